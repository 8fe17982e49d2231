// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 30 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2930 bits, pipeline 8742 bits, memories 120207 bits.
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
  input  logic [10:0] cfg_width_i,
  input  logic [10:0] cfg_height_i,
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
  input  logic signed [15:0] cfg_epipolar_slope_i,
  input  logic signed [15:0] cfg_epipolar_column_i,
  input  logic signed [15:0] cfg_epipolar_row_i,
  input  logic signed [15:0] cfg_epipolar_both_i,
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q, valid_s28_q, valid_s29_q, valid_s30_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en, s27_en, s28_en, s29_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;
  assign s5_en = en_i & valid_s5_q;
  assign s6_en = en_i & valid_s6_q;
  assign s7_en = en_i & valid_s7_q;
  assign s8_en = en_i & valid_s8_q;
  assign s9_en = en_i & valid_s9_q;
  assign s10_en = en_i & valid_s10_q;
  assign s11_en = en_i & valid_s11_q;
  assign s12_en = en_i & valid_s12_q;
  assign s13_en = en_i & valid_s13_q;
  assign s14_en = en_i & valid_s14_q;
  assign s15_en = en_i & valid_s15_q;
  assign s16_en = en_i & valid_s16_q;
  assign s17_en = en_i & valid_s17_q;
  assign s18_en = en_i & valid_s18_q;
  assign s19_en = en_i & valid_s19_q;
  assign s20_en = en_i & valid_s20_q;
  assign s21_en = en_i & valid_s21_q;
  assign s22_en = en_i & valid_s22_q;
  assign s23_en = en_i & valid_s23_q;
  assign s24_en = en_i & valid_s24_q;
  assign s25_en = en_i & valid_s25_q;
  assign s26_en = en_i & valid_s26_q;
  assign s27_en = en_i & valid_s27_q;
  assign s28_en = en_i & valid_s28_q;
  assign s29_en = en_i & valid_s29_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_2381;
  assign sum_2381 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3386;
  assign difference_3386 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [7:0] difference_3614;
  assign difference_3614 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_3816;
  assign less_3816 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_3817;
  assign sum_3817 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_3835;
  assign not_3835 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_464;
  assign select_464 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 4'h0;
      raster_row_ended_q <= 1'b1;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_464 + 4'h1) : raster_at_x_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic sample_pair_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_last_s1_q;
  logic sample_present_s1_q;
  logic raster_row_ended_s1_q;
  logic [3:0] select_464_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      sample_pair_first_s1_q <= sample_pair_first_q;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_last_s1_q <= sample_last_q;
      sample_present_s1_q <= sample_present_q;
      raster_row_ended_s1_q <= raster_row_ended_q;
      select_464_s1_q <= select_464;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:35
  logic [6:0] select_467;
  assign select_467 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:50
  logic equal_499;
  assign equal_499 = select_464_s1_q == 4'hf;
  // hls/stages/agreement.hpp:263
  logic [6:0] select_2030;
  assign select_2030 = sample_pair_whole_s1_q ? (select_467 + {6'h0, equal_499}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2030;
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
  logic sample_last_s2_q;
  logic sample_present_s2_q;
  logic [3:0] select_464_s2_q;
  logic [6:0] select_467_s2_q;
  logic equal_499_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_first_s2_q <= sample_pair_first_s1_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_last_s2_q <= sample_last_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      select_464_s2_q <= select_464_s1_q;
      select_467_s2_q <= select_467;
      equal_499_s2_q <= equal_499;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:109
  logic equal_465;
  assign equal_465 = select_464_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:115
  logic [8:0] select_470;
  assign select_470 = ({select_467_s2_q, select_464_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_471;
  assign select_471 = equal_465 ? select_470 : averager_place_q;
  // hls/stages/census.hpp:41
  logic [3:0] select_482;
  assign select_482 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2028;
  assign select_2028 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_482 + 4'h1) : select_482) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2028;
      averager_place_q <= sample_pair_whole_s2_q ? select_471 : averager_place_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_last_s3_q;
  logic sample_present_s3_q;
  logic [3:0] select_464_s3_q;
  logic equal_465_s3_q;
  logic [6:0] select_467_s3_q;
  logic [8:0] select_471_s3_q;
  logic equal_473_s3_q;
  logic [3:0] select_482_s3_q;
  logic equal_499_s3_q;
  logic equal_500_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_first_s3_q <= sample_pair_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_last_s3_q <= sample_last_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      select_464_s3_q <= select_464_s2_q;
      equal_465_s3_q <= equal_465;
      select_467_s3_q <= select_467_s2_q;
      select_471_s3_q <= select_471;
      equal_473_s3_q <= select_464_s2_q[1:0] == 2'h3;
      select_482_s3_q <= select_482;
      equal_499_s3_q <= equal_499_s2_q;
      equal_500_s3_q <= select_482 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:41
  logic or_472;
  assign or_472 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_477;
  assign and_477 = (or_472 & equal_473_s3_q) & (~(select_471_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_467_s3_q : 7'h0;
  // hls/stages/census.hpp:126
  logic and_501;
  assign and_501 = equal_500_s3_q & and_477;
  // hls/stages/agreement.hpp:263
  logic and_503;
  assign and_503 = sample_pair_whole_s3_q & (equal_499_s3_q & and_501);
  // hls/stages/census.hpp:41
  logic [6:0] select_562;
  assign select_562 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_562 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_2032;
  assign select_2032 = sample_last_s3_q ? (select_562 + {6'h0, equal_500_s3_q}) : select_562;
  // hls/stages/agreement.hpp:263
  logic select_2037;
  assign select_2037 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_472 & (~raster_final_row_q)) : or_472) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_2039;
  assign select_2039 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:263
  logic select_2043;
  assign select_2043 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2287;
  assign equal_2287 = {last[7], column} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2032 : raster_at_row_q;
      raster_at_live_q <= select_2037;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2039 : raster_rows_left_q;
      raster_final_row_q <= select_2043;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic sample_pair_first_s4_q;
  logic sample_pair_whole_s4_q;
  logic sample_present_s4_q;
  logic [3:0] select_464_s4_q;
  logic equal_465_s4_q;
  logic [6:0] select_467_s4_q;
  logic [8:0] select_471_s4_q;
  logic and_477_s4_q;
  logic [3:0] select_482_s4_q;
  logic [6:0] column_s4_q;
  logic and_501_s4_q;
  logic and_503_s4_q;
  logic [3:0] select_562_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1591_s4_q;
  logic equal_2287_s4_q;
  logic and_2288_s4_q;
  logic [7:0] sum_2377_s4_q;
  logic [2:0] or_2762_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sample_pair_first_s4_q <= sample_pair_first_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      sample_present_s4_q <= sample_present_s3_q;
      select_464_s4_q <= select_464_s3_q;
      equal_465_s4_q <= equal_465_s3_q;
      select_467_s4_q <= select_467_s3_q;
      select_471_s4_q <= select_471_s3_q;
      and_477_s4_q <= and_477;
      select_482_s4_q <= select_482_s3_q;
      column_s4_q <= column;
      and_501_s4_q <= and_501;
      and_503_s4_q <= and_503;
      select_562_s4_q <= select_562[3:0];
      row_s4_q <= row;
      equal_1591_s4_q <= {or_472, select_482_s3_q} == 5'h18;
      equal_2287_s4_q <= equal_2287;
      and_2288_s4_q <= and_503 & equal_2287;
      sum_2377_s4_q <= {1'b0, row} + 8'h1;
      or_2762_s4_q <= select_467_s3_q[2:0] | select_562[6:4];
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
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
  logic [2:0] slot_q;
  logic ends_cell_q;
  logic ends_q;
  logic final_row_q;
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_523;
  assign equal_523 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:601
  logic equal_526;
  assign equal_526 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_528;
  assign equal_528 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:510
  logic select_2291;
  assign select_2291 = (and_2288_s4_q | (~ends_cell_q)) ? and_2288_s4_q : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2291 ? (and_2288_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2295;
  assign select_2295 = select_2291 ? (and_2288_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2298;
  assign select_2298 = select_2291 ? (following_last_shift_q & (~and_2288_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:522
  logic [7:0] select_2300;
  assign select_2300 = select_2291 ? (and_2288_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:594
  logic and_2301;
  assign and_2301 = run_last_shift_q & equal_526;
  // hls/stages/agreement.hpp:603
  logic select_2303;
  assign select_2303 = equal_526 ? (~run_last_shift_q) : equal_528;
  // hls/stages/agreement.hpp:607
  logic equal_2304;
  assign equal_2304 = run_phase_q == 3'h1;
  logic not_2307;
  assign not_2307 = ~select_2303;
  // hls/stages/agreement.hpp:610
  logic equal_2309;
  assign equal_2309 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2310;
  assign and_2310 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2311;
  assign select_2311 = equal_2309 ? 2'h1 : {2{and_2310}};
  logic [2:0] select_2313;
  assign select_2313 = (and_2301 | (select_2303 | equal_2304)) ? (equal_2304 ? 3'h2 : {not_2307, {2{select_2303}}}) : (equal_523 ? 3'h6 : {select_2311[0], select_2311});
  // hls/stages/agreement.hpp:594
  logic and_2316;
  assign and_2316 = select_2303 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2319;
  assign select_2319 = (plan_shift_q[5] & select_2303) ? value : 7'h0;
  logic [1:0] or_2320;
  assign or_2320 = {2{so}} | select_2319[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_2324;
  assign or_2324 = (select_2303 ? plan_columns_q : 8'h0) | ((equal_2304 | equal_2309) ? whole_q : 8'h0);
  logic [1:0] or_2325;
  assign or_2325 = {2{and_2301}} | or_2324[4:3];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2327;
  assign or_2327 = {or_2324[7:5], or_2325, or_2324[2:0]} | (equal_523 ? drawn_q : 8'h0);
  logic [4:0] or_2328;
  assign or_2328 = {5{so}} | {or_2327[6], or_2327[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2332;
  assign not_2332 = ~run_shift_q[5];
  logic [7:0] select_2335;
  assign select_2335 = equal_526 ? ({{7{not_2332}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2339;
  assign select_2339 = and_2288_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2341;
  assign select_2341 = select_2291 ? {select_2339[6], select_2339} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2344;
  assign select_2344 = select_2291 ? (and_2288_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:447
  logic [6:0] select_2351;
  assign select_2351 = equal_2287_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_2355;
  assign select_2355 = and_503_s4_q ? (equal_2287_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2358;
  assign select_2358 = and_503_s4_q ? (equal_2287_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2372;
  assign select_2372 = (ends_cell_q | select_2291) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_526 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2376;
  assign and_2376 = (~select_2291) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic equal_2378;
  assign equal_2378 = {sum_2377_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2377_s4_q[6:0]};
  // hls/stages/agreement.hpp:507
  logic select_2380;
  assign select_2380 = and_503_s4_q ? (equal_2287_s4_q ? equal_2378 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:352
  logic [8:0] sum_2763;
  assign sum_2763 = {1'b0, select_467_s4_q[3], or_2762_s4_q, select_562_s4_q} + 9'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      slot_q <= 3'h0;
      ends_cell_q <= 1'b1;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
    end else if (s4_en) begin
      run_phase_q <= now;
      run_shift_q <= select_2295;
      run_last_shift_q <= select_2298;
      run_span_q <= select_2300;
      following_phase_q <= select_2313;
      following_shift_q <= select_2303 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2316;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2319[6], or_2320, select_2319[3:0]};
      following_columns_q <= {or_2327[7], or_2328[4], or_2327[5:4], or_2328[3:0]};
      plan_shift_q <= equal_526 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2335;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2341;
      columns_left_q <= select_2344;
      last_q <= and_503_s4_q ? (equal_2287_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_503_s4_q ? select_2351 : least_q;
      whole_q <= select_2355;
      drawn_q <= select_2358;
      slot_q <= select_2291 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2372;
      ends_q <= and_2376;
      final_row_q <= select_2380;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic sample_pair_first_s5_q;
  logic sample_pair_whole_s5_q;
  logic sample_present_s5_q;
  logic [5:0] run_shift_s5_q;
  logic [7:0] x_s5_q;
  logic [6:0] last_s5_q;
  logic [2:0] slot_s5_q;
  logic ends_cell_s5_q;
  logic [3:0] select_464_s5_q;
  logic equal_465_s5_q;
  logic [6:0] select_467_s5_q;
  logic [8:0] select_471_s5_q;
  logic and_477_s5_q;
  logic equal_483_s5_q;
  logic [6:0] column_s5_q;
  logic and_501_s5_q;
  logic and_503_s5_q;
  logic so_s5_q;
  logic equal_523_s5_q;
  logic equal_526_s5_q;
  logic equal_528_s5_q;
  logic [7:0] sum_529_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_639_s5_q;
  logic equal_648_s5_q;
  logic equal_1472_s5_q;
  logic equal_1591_s5_q;
  logic equal_2287_s5_q;
  logic and_2288_s5_q;
  logic select_2291_s5_q;
  logic not_2765_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      sample_pair_first_s5_q <= sample_pair_first_s4_q;
      sample_pair_whole_s5_q <= sample_pair_whole_s4_q;
      sample_present_s5_q <= sample_present_s4_q;
      run_shift_s5_q <= run_shift_q;
      x_s5_q <= x_q;
      last_s5_q <= last_q;
      slot_s5_q <= slot_q;
      ends_cell_s5_q <= ends_cell_q;
      select_464_s5_q <= select_464_s4_q;
      equal_465_s5_q <= equal_465_s4_q;
      select_467_s5_q <= select_467_s4_q;
      select_471_s5_q <= select_471_s4_q;
      and_477_s5_q <= and_477_s4_q;
      equal_483_s5_q <= select_482_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_501_s5_q <= and_501_s4_q;
      and_503_s5_q <= and_503_s4_q;
      so_s5_q <= so;
      equal_523_s5_q <= equal_523;
      equal_526_s5_q <= equal_526;
      equal_528_s5_q <= equal_528;
      sum_529_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_639_s5_q <= {1'b0, last_q} + 8'h3;
      equal_648_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_1472_s5_q <= run_phase_q == 3'h7;
      equal_1591_s5_q <= equal_1591_s4_q;
      equal_2287_s5_q <= equal_2287_s4_q;
      and_2288_s5_q <= and_2288_s4_q;
      select_2291_s5_q <= select_2291;
      not_2765_s5_q <= ~({sum_2763, select_482_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_530;
  assign select_530 = run_shift_s5_q[5] ? x_s5_q : sum_529_s5_q;
  logic less_531;
  assign less_531 = {1'b0, last_s5_q} < select_530;
  // hls/stages/agreement.hpp:216
  logic not_532;
  assign not_532 = ~less_531;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:515
  logic [6:0] select_2360;
  assign select_2360 = select_2291_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2360;
    end
  end

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic sample_pair_first_s6_q;
  logic sample_pair_whole_s6_q;
  logic sample_present_s6_q;
  logic [5:0] run_shift_s6_q;
  logic [7:0] x_s6_q;
  logic [6:0] last_s6_q;
  logic [3:0] age_s6_q;
  logic [2:0] slot_s6_q;
  logic ends_cell_s6_q;
  logic [3:0] select_464_s6_q;
  logic equal_465_s6_q;
  logic [6:0] select_467_s6_q;
  logic [8:0] select_471_s6_q;
  logic and_477_s6_q;
  logic equal_483_s6_q;
  logic [6:0] column_s6_q;
  logic and_501_s6_q;
  logic and_503_s6_q;
  logic so_s6_q;
  logic equal_523_s6_q;
  logic equal_526_s6_q;
  logic [6:0] sum_529_s6_q;
  logic less_531_s6_q;
  logic not_532_s6_q;
  logic and_533_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_643_s6_q;
  logic equal_648_s6_q;
  logic equal_1462_s6_q;
  logic equal_1472_s6_q;
  logic equal_1591_s6_q;
  logic equal_2287_s6_q;
  logic and_2288_s6_q;
  logic not_2765_s6_q;
  always_ff @(posedge clk_i) begin
    if (s5_en) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      pixel_1_s6_q <= pixel_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      sample_pair_first_s6_q <= sample_pair_first_s5_q;
      sample_pair_whole_s6_q <= sample_pair_whole_s5_q;
      sample_present_s6_q <= sample_present_s5_q;
      run_shift_s6_q <= run_shift_s5_q;
      x_s6_q <= x_s5_q;
      last_s6_q <= last_s5_q;
      age_s6_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s6_q <= slot_s5_q;
      ends_cell_s6_q <= ends_cell_s5_q;
      select_464_s6_q <= select_464_s5_q;
      equal_465_s6_q <= equal_465_s5_q;
      select_467_s6_q <= select_467_s5_q;
      select_471_s6_q <= select_471_s5_q;
      and_477_s6_q <= and_477_s5_q;
      equal_483_s6_q <= equal_483_s5_q;
      column_s6_q <= column_s5_q;
      and_501_s6_q <= and_501_s5_q;
      and_503_s6_q <= and_503_s5_q;
      so_s6_q <= so_s5_q;
      equal_523_s6_q <= equal_523_s5_q;
      equal_526_s6_q <= equal_526_s5_q;
      sum_529_s6_q <= sum_529_s5_q[6:0];
      less_531_s6_q <= less_531;
      not_532_s6_q <= not_532;
      and_533_s6_q <= equal_528_s5_q & not_532;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_643_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_639_s5_q < select_530)));
      equal_648_s6_q <= equal_648_s5_q;
      equal_1462_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1472_s6_q <= equal_1472_s5_q;
      equal_1591_s6_q <= equal_1591_s5_q;
      equal_2287_s6_q <= equal_2287_s5_q;
      and_2288_s6_q <= and_2288_s5_q;
      not_2765_s6_q <= not_2765_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:581
  logic or_524;
  assign or_524 = so_s6_q | equal_523_s6_q;
  // hls/stages/agreement.hpp:704
  logic not_525;
  assign not_525 = ~or_524;
  // hls/stages/agreement.hpp:141
  logic select_619;
  assign select_619 = equal_526_s6_q ? not_532_s6_q : and_533_s6_q;
  logic and_644;
  assign and_644 = equal_526_s6_q & and_643_s6_q;
  logic select_645;
  assign select_645 = or_524 ? not_532_s6_q : and_644;
  // hls/stages/agreement.hpp:782
  logic or_650;
  assign or_650 = equal_648_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_529_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1295; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_524 ? not_532_s6_q : select_619);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1296; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_526_s6_q ? sum_529_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_525 & select_619);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1297; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 46'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_524 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_645;
  logic [45:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  logic [7:0] pixel_0_s7_q;
  logic [7:0] pixel_1_s7_q;
  logic saturated_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
  logic sample_pair_first_s7_q;
  logic sample_pair_whole_s7_q;
  logic sample_present_s7_q;
  logic [5:0] run_shift_s7_q;
  logic [7:0] x_s7_q;
  logic [6:0] last_s7_q;
  logic [3:0] age_s7_q;
  logic [2:0] slot_s7_q;
  logic ends_cell_s7_q;
  logic [3:0] select_464_s7_q;
  logic equal_465_s7_q;
  logic [6:0] select_467_s7_q;
  logic [8:0] select_471_s7_q;
  logic and_477_s7_q;
  logic equal_483_s7_q;
  logic [6:0] column_s7_q;
  logic and_501_s7_q;
  logic and_503_s7_q;
  logic so_s7_q;
  logic equal_523_s7_q;
  logic or_524_s7_q;
  logic equal_526_s7_q;
  logic less_531_s7_q;
  logic not_532_s7_q;
  logic and_535_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_645_s7_q;
  logic select_652_s7_q;
  logic and_1454_s7_q;
  logic [6:0] right_s7_q;
  logic select_1463_s7_q;
  logic equal_1472_s7_q;
  logic equal_1591_s7_q;
  logic equal_2287_s7_q;
  logic and_2288_s7_q;
  logic not_2765_s7_q;
  always_ff @(posedge clk_i) begin
    if (s6_en) begin
      pixel_0_s7_q <= pixel_0_s6_q;
      pixel_1_s7_q <= pixel_1_s6_q;
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
      sample_pair_first_s7_q <= sample_pair_first_s6_q;
      sample_pair_whole_s7_q <= sample_pair_whole_s6_q;
      sample_present_s7_q <= sample_present_s6_q;
      run_shift_s7_q <= run_shift_s6_q;
      x_s7_q <= x_s6_q;
      last_s7_q <= last_s6_q;
      age_s7_q <= age_s6_q;
      slot_s7_q <= slot_s6_q;
      ends_cell_s7_q <= ends_cell_s6_q;
      select_464_s7_q <= select_464_s6_q;
      equal_465_s7_q <= equal_465_s6_q;
      select_467_s7_q <= select_467_s6_q;
      select_471_s7_q <= select_471_s6_q;
      and_477_s7_q <= and_477_s6_q;
      equal_483_s7_q <= equal_483_s6_q;
      column_s7_q <= column_s6_q;
      and_501_s7_q <= and_501_s6_q;
      and_503_s7_q <= and_503_s6_q;
      so_s7_q <= so_s6_q;
      equal_523_s7_q <= equal_523_s6_q;
      or_524_s7_q <= or_524;
      equal_526_s7_q <= equal_526_s6_q;
      less_531_s7_q <= less_531_s6_q;
      not_532_s7_q <= not_532_s6_q;
      and_535_s7_q <= not_525 & ((~equal_526_s6_q) & and_533_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_645_s7_q <= select_645;
      select_652_s7_q <= or_650 ? equal_648_s6_q : (~age_s6_q[1]);
      and_1454_s7_q <= not_525 & and_644;
      right_s7_q <= right;
      select_1463_s7_q <= or_650 ? equal_648_s6_q : equal_1462_s6_q;
      equal_1472_s7_q <= equal_1472_s6_q;
      equal_1591_s7_q <= equal_1591_s6_q;
      equal_2287_s7_q <= equal_2287_s6_q;
      and_2288_s7_q <= and_2288_s6_q;
      not_2765_s7_q <= not_2765_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1294; read in stage 7, written in stage 27: 7 < 27 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_535_s7_q;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  logic [7:0] pixel_0_s8_q;
  logic [7:0] pixel_1_s8_q;
  logic saturated_s8_q;
  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic sample_pair_first_s8_q;
  logic sample_pair_whole_s8_q;
  logic sample_present_s8_q;
  logic [5:0] run_shift_s8_q;
  logic [7:0] x_s8_q;
  logic [6:0] last_s8_q;
  logic [3:0] age_s8_q;
  logic [2:0] slot_s8_q;
  logic ends_cell_s8_q;
  logic [3:0] select_464_s8_q;
  logic equal_465_s8_q;
  logic [6:0] select_467_s8_q;
  logic [8:0] select_471_s8_q;
  logic and_477_s8_q;
  logic equal_483_s8_q;
  logic [6:0] column_s8_q;
  logic and_501_s8_q;
  logic and_503_s8_q;
  logic so_s8_q;
  logic equal_523_s8_q;
  logic or_524_s8_q;
  logic equal_526_s8_q;
  logic less_531_s8_q;
  logic not_532_s8_q;
  logic and_535_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_645_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic select_652_s8_q;
  logic and_1454_s8_q;
  logic [6:0] right_s8_q;
  logic select_1463_s8_q;
  logic equal_1472_s8_q;
  logic equal_1591_s8_q;
  logic equal_2287_s8_q;
  logic and_2288_s8_q;
  logic not_2765_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      pixel_0_s8_q <= pixel_0_s7_q;
      pixel_1_s8_q <= pixel_1_s7_q;
      saturated_s8_q <= saturated_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      sample_pair_first_s8_q <= sample_pair_first_s7_q;
      sample_pair_whole_s8_q <= sample_pair_whole_s7_q;
      sample_present_s8_q <= sample_present_s7_q;
      run_shift_s8_q <= run_shift_s7_q;
      x_s8_q <= x_s7_q;
      last_s8_q <= last_s7_q;
      age_s8_q <= age_s7_q;
      slot_s8_q <= slot_s7_q;
      ends_cell_s8_q <= ends_cell_s7_q;
      select_464_s8_q <= select_464_s7_q;
      equal_465_s8_q <= equal_465_s7_q;
      select_467_s8_q <= select_467_s7_q;
      select_471_s8_q <= select_471_s7_q;
      and_477_s8_q <= and_477_s7_q;
      equal_483_s8_q <= equal_483_s7_q;
      column_s8_q <= column_s7_q;
      and_501_s8_q <= and_501_s7_q;
      and_503_s8_q <= and_503_s7_q;
      so_s8_q <= so_s7_q;
      equal_523_s8_q <= equal_523_s7_q;
      or_524_s8_q <= or_524_s7_q;
      equal_526_s8_q <= equal_526_s7_q;
      less_531_s8_q <= less_531_s7_q;
      not_532_s8_q <= not_532_s7_q;
      and_535_s8_q <= and_535_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_645_s8_q <= select_645_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      select_652_s8_q <= select_652_s7_q;
      and_1454_s8_q <= and_1454_s7_q;
      right_s8_q <= right_s7_q;
      select_1463_s8_q <= select_1463_s7_q;
      equal_1472_s8_q <= equal_1472_s7_q;
      equal_1591_s8_q <= equal_1591_s7_q;
      equal_2287_s8_q <= equal_2287_s7_q;
      and_2288_s8_q <= and_2288_s7_q;
      not_2765_s8_q <= not_2765_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  // hls/stages/agreement.hpp:653
  logic not_623;
  assign not_623 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:212
  logic and_658;
  assign and_658 = left_rdata_s8_q[44] & not_532_s8_q;
  logic and_659;
  assign and_659 = right_codes_rdata_s8_q[38] & not_532_s8_q;
  logic [11:0] select_660;
  assign select_660 = less_531_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_661;
  assign select_661 = less_531_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_665;
  assign select_665 = and_658 ? (and_659 ? (~(select_660 ^ select_661)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_681;
  assign and_681 = left_rdata_s8_q[60] & not_532_s8_q;
  logic and_682;
  assign and_682 = right_codes_rdata_s8_q[51] & not_532_s8_q;
  logic [11:0] select_683;
  assign select_683 = less_531_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_684;
  assign select_684 = less_531_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_688;
  assign select_688 = and_681 ? (and_682 ? (~(select_683 ^ select_684)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_698;
  assign and_698 = left_rdata_s8_q[76] & not_532_s8_q;
  logic and_699;
  assign and_699 = right_codes_rdata_s8_q[64] & not_532_s8_q;
  logic [11:0] select_700;
  assign select_700 = less_531_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_701;
  assign select_701 = less_531_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_705;
  assign select_705 = and_698 ? (and_699 ? (~(select_700 ^ select_701)) : 12'h0) : 12'h0;
  logic [11:0] select_913;
  assign select_913 = (slot_s8_q[0] ? and_699 : and_682) ? (~(select_661 ^ (slot_s8_q[0] ? select_700 : select_683))) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_930;
  assign and_930 = right_codes_rdata_s8_q[77] & not_532_s8_q;
  logic [11:0] select_932;
  assign select_932 = less_531_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_936;
  assign select_936 = (slot_s8_q[0] ? and_930 : and_699) ? (~(select_684 ^ (slot_s8_q[0] ? select_932 : select_700))) : 12'h0;
  // hls/stages/agreement.hpp:718
  logic select_948;
  assign select_948 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_532_s8_q) : and_930;
  logic [11:0] select_950;
  assign select_950 = slot_s8_q[0] ? (less_531_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_932;
  // hls/stages/agreement.hpp:212
  logic and_1159;
  assign and_1159 = right_codes_rdata_s8_q[25] & not_532_s8_q;
  // hls/stages/agreement.hpp:718
  logic select_1160;
  assign select_1160 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_532_s8_q) : and_1159;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1162;
  assign select_1162 = less_531_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1163;
  assign select_1163 = slot_s8_q[0] ? (less_531_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1162;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1187;
  assign select_1187 = (slot_s8_q[0] ? and_1159 : and_659) ? (~(select_684 ^ (slot_s8_q[0] ? select_1162 : select_660))) : 12'h0;
  logic [11:0] select_1202;
  assign select_1202 = (slot_s8_q[0] ? and_659 : and_682) ? (~(select_701 ^ (slot_s8_q[0] ? select_660 : select_683))) : 12'h0;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:932
  logic and_1478;
  assign and_1478 = (or_524_s8_q & (left_rdata_s8_q[61] & not_532_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:235
  logic and_1486;
  assign and_1486 = not_532_s8_q & (or_524_s8_q & (left_rdata_s8_q[63] & not_532_s8_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
    end else if (s8_en) begin
      row_q <= and_503_s8_q ? (equal_2287_s8_q ? row_s8_q : row_q) : row_q;
    end
  end

  logic [7:0] pixel_0_s9_q;
  logic [7:0] pixel_1_s9_q;
  logic saturated_s9_q;
  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic sample_pair_first_s9_q;
  logic sample_pair_whole_s9_q;
  logic sample_present_s9_q;
  logic [5:0] run_shift_s9_q;
  logic [7:0] x_s9_q;
  logic [6:0] last_s9_q;
  logic [3:0] age_s9_q;
  logic [2:0] slot_s9_q;
  logic ends_cell_s9_q;
  logic [3:0] select_464_s9_q;
  logic equal_465_s9_q;
  logic [6:0] select_467_s9_q;
  logic [8:0] select_471_s9_q;
  logic and_477_s9_q;
  logic equal_483_s9_q;
  logic [6:0] column_s9_q;
  logic and_501_s9_q;
  logic and_503_s9_q;
  logic so_s9_q;
  logic equal_523_s9_q;
  logic or_524_s9_q;
  logic equal_526_s9_q;
  logic less_531_s9_q;
  logic not_532_s9_q;
  logic and_535_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic [6:0] row_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_624_s9_q;
  logic and_625_s9_q;
  logic and_626_s9_q;
  logic and_627_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_631_s9_q;
  logic and_632_s9_q;
  logic and_633_s9_q;
  logic and_634_s9_q;
  logic and_635_s9_q;
  logic and_636_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_645_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic select_652_s9_q;
  logic and_658_s9_q;
  logic [11:0] select_665_s9_q;
  logic and_681_s9_q;
  logic [11:0] select_688_s9_q;
  logic and_698_s9_q;
  logic [11:0] select_705_s9_q;
  logic [11:0] select_913_s9_q;
  logic [11:0] select_936_s9_q;
  logic [11:0] select_953_s9_q;
  logic [11:0] select_1166_s9_q;
  logic [11:0] select_1187_s9_q;
  logic [11:0] select_1202_s9_q;
  logic and_1454_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic select_1463_s9_q;
  logic equal_1472_s9_q;
  logic and_1479_s9_q;
  logic and_1482_s9_q;
  logic and_1486_s9_q;
  logic equal_1591_s9_q;
  logic less_1612_s9_q;
  logic and_2017_s9_q;
  logic equal_2287_s9_q;
  logic and_2288_s9_q;
  logic not_2765_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      pixel_0_s9_q <= pixel_0_s8_q;
      pixel_1_s9_q <= pixel_1_s8_q;
      saturated_s9_q <= saturated_s8_q;
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      sample_pair_first_s9_q <= sample_pair_first_s8_q;
      sample_pair_whole_s9_q <= sample_pair_whole_s8_q;
      sample_present_s9_q <= sample_present_s8_q;
      run_shift_s9_q <= run_shift_s8_q;
      x_s9_q <= x_s8_q;
      last_s9_q <= last_s8_q;
      age_s9_q <= age_s8_q;
      slot_s9_q <= slot_s8_q;
      ends_cell_s9_q <= ends_cell_s8_q;
      select_464_s9_q <= select_464_s8_q;
      equal_465_s9_q <= equal_465_s8_q;
      select_467_s9_q <= select_467_s8_q;
      select_471_s9_q <= select_471_s8_q;
      and_477_s9_q <= and_477_s8_q;
      equal_483_s9_q <= equal_483_s8_q;
      column_s9_q <= column_s8_q;
      and_501_s9_q <= and_501_s8_q;
      and_503_s9_q <= and_503_s8_q;
      so_s9_q <= so_s8_q;
      equal_523_s9_q <= equal_523_s8_q;
      or_524_s9_q <= or_524_s8_q;
      equal_526_s9_q <= equal_526_s8_q;
      less_531_s9_q <= less_531_s8_q;
      not_532_s9_q <= not_532_s8_q;
      and_535_s9_q <= and_535_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      row_s9_q <= row_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_624_s9_q <= left_rdata_s8_q[12] & not_623;
      and_625_s9_q <= left_rdata_s8_q[28] & not_623;
      and_626_s9_q <= left_rdata_s8_q[44] & not_623;
      and_627_s9_q <= left_rdata_s8_q[60] & not_623;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_631_s9_q <= right_codes_rdata_s8_q[12] & not_623;
      and_632_s9_q <= right_codes_rdata_s8_q[25] & not_623;
      and_633_s9_q <= right_codes_rdata_s8_q[38] & not_623;
      and_634_s9_q <= right_codes_rdata_s8_q[51] & not_623;
      and_635_s9_q <= right_codes_rdata_s8_q[64] & not_623;
      and_636_s9_q <= right_codes_rdata_s8_q[77] & not_623;
      x_s9_2_q <= x_s8_2_q;
      select_645_s9_q <= select_645_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_652_s9_q <= select_652_s8_q;
      and_658_s9_q <= and_658;
      select_665_s9_q <= select_665;
      and_681_s9_q <= and_681;
      select_688_s9_q <= select_688;
      and_698_s9_q <= and_698;
      select_705_s9_q <= select_705;
      select_913_s9_q <= select_913;
      select_936_s9_q <= select_936;
      select_953_s9_q <= select_948 ? (~(select_701 ^ select_950)) : 12'h0;
      select_1166_s9_q <= select_1160 ? (~(select_661 ^ select_1163)) : 12'h0;
      select_1187_s9_q <= select_1187;
      select_1202_s9_q <= select_1202;
      and_1454_s9_q <= and_1454_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      select_1463_s9_q <= select_1463_s8_q;
      equal_1472_s9_q <= equal_1472_s8_q;
      and_1479_s9_q <= not_532_s8_q & and_1478;
      and_1482_s9_q <= (or_524_s8_q & (left_rdata_s8_q[62] & not_532_s8_q)) & and_1478;
      and_1486_s9_q <= and_1486;
      equal_1591_s9_q <= equal_1591_s8_q;
      less_1612_s9_q <= 6'h4 < row_q[6:1];
      and_2017_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2287_s9_q <= equal_2287_s8_q;
      and_2288_s9_q <= and_2288_s8_q;
      not_2765_s9_q <= not_2765_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/count_bits.hpp:24
  logic parity_671;
  assign parity_671 = ^select_665_s9_q[5:3];
  logic parity_674;
  assign parity_674 = ^select_665_s9_q[8:6];
  logic parity_677;
  assign parity_677 = ^select_665_s9_q[11:3];
  logic parity_691;
  assign parity_691 = ^select_688_s9_q[8:6];
  logic parity_694;
  assign parity_694 = ^select_688_s9_q[11:9];
  logic parity_711;
  assign parity_711 = ^select_705_s9_q[2:0];
  logic parity_714;
  assign parity_714 = ^select_705_s9_q[5:3];
  logic parity_717;
  assign parity_717 = ^select_705_s9_q[8:0];
  logic parity_723;
  assign parity_723 = ^select_705_s9_q[11:9];
  logic parity_726;
  assign parity_726 = ^select_688_s9_q[2:0];
  logic parity_729;
  assign parity_729 = ^{select_705_s9_q[11:9], select_688_s9_q[5:0]};
  logic parity_732;
  assign parity_732 = ^{select_705_s9_q, select_688_s9_q, select_665_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_737;
  assign or_737 = (select_665_s9_q[1:0] == 2'h3) | (select_665_s9_q[2] & (select_665_s9_q[0] | select_665_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_741;
  assign or_741 = (select_688_s9_q[7:6] == 2'h3) | (select_688_s9_q[8] & (select_688_s9_q[6] | select_688_s9_q[7]));
  logic or_745;
  assign or_745 = (select_688_s9_q[10:9] == 2'h3) | (select_688_s9_q[11] & (select_688_s9_q[9] | select_688_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_753;
  assign or_753 = (select_705_s9_q[7:6] == 2'h3) | (select_705_s9_q[8] & (~(select_705_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_757;
  assign or_757 = (select_705_s9_q[1:0] == 2'h3) | (select_705_s9_q[2] & (select_705_s9_q[0] | select_705_s9_q[1]));
  logic or_761;
  assign or_761 = (select_705_s9_q[4:3] == 2'h3) | (select_705_s9_q[5] & (select_705_s9_q[3] | select_705_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_764;
  assign parity_764 = ^{or_761, or_757, or_753};
  // hls/stages/count_bits.hpp:23
  logic or_768;
  assign or_768 = (select_688_s9_q[4:3] == 2'h3) | (select_688_s9_q[5] & (select_688_s9_q[3] | select_688_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_772;
  assign or_772 = (select_705_s9_q[10:9] == 2'h3) | (select_705_s9_q[11] & (select_705_s9_q[9] | select_705_s9_q[10]));
  logic or_776;
  assign or_776 = (select_688_s9_q[1:0] == 2'h3) | (select_688_s9_q[2] & (select_688_s9_q[0] | select_688_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_779;
  assign parity_779 = ^{or_776, or_772, or_768};
  logic parity_782;
  assign parity_782 = ^{or_776, or_772, or_768, or_761, or_757, or_753, or_745, or_741, or_737};
  // hls/stages/count_bits.hpp:25
  logic or_787;
  assign or_787 = (parity_671 & parity_674) | ((^select_665_s9_q[11:9]) & (parity_671 | parity_674));
  logic and_790;
  assign and_790 = (^{select_688_s9_q[11:6], select_665_s9_q[2:0]}) & (parity_717 | parity_729);
  // hls/stages/count_bits.hpp:23
  logic or_798;
  assign or_798 = (select_665_s9_q[10:9] == 2'h3) | (select_665_s9_q[11] & (select_665_s9_q[9] | select_665_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_802;
  assign or_802 = (select_665_s9_q[4:3] == 2'h3) | (select_665_s9_q[5] & (select_665_s9_q[3] | select_665_s9_q[4]));
  logic or_806;
  assign or_806 = (select_665_s9_q[7:6] == 2'h3) | (select_665_s9_q[8] & (select_665_s9_q[6] | select_665_s9_q[7]));
  logic or_813;
  assign or_813 = (parity_691 & parity_694) | ((^select_665_s9_q[2:0]) & (parity_691 | parity_694));
  logic or_817;
  assign or_817 = (parity_711 & parity_714) | ((^select_705_s9_q[8:6]) & (parity_711 | parity_714));
  logic or_821;
  assign or_821 = (parity_723 & parity_726) | ((^select_688_s9_q[5:3]) & (parity_723 | parity_726));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_914;
  assign select_914 = and_658_s9_q ? select_913_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_920;
  assign parity_920 = ^select_914[5:3];
  logic parity_923;
  assign parity_923 = ^select_914[8:6];
  logic parity_926;
  assign parity_926 = ^select_914[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_937;
  assign select_937 = and_681_s9_q ? select_936_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_940;
  assign parity_940 = ^select_937[8:6];
  logic parity_943;
  assign parity_943 = ^select_937[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_954;
  assign select_954 = and_698_s9_q ? select_953_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_960;
  assign parity_960 = ^select_954[2:0];
  logic parity_963;
  assign parity_963 = ^select_954[5:3];
  logic parity_966;
  assign parity_966 = ^select_954[8:0];
  logic parity_972;
  assign parity_972 = ^select_954[11:9];
  logic parity_975;
  assign parity_975 = ^select_937[2:0];
  logic parity_978;
  assign parity_978 = ^{select_954[11:9], select_937[5:0]};
  logic parity_981;
  assign parity_981 = ^{select_954, select_937, select_914[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_986;
  assign or_986 = (select_914[1:0] == 2'h3) | (select_914[2] & (select_914[0] | select_914[1]));
  // hls/stages/count_bits.hpp:25
  logic or_990;
  assign or_990 = (select_937[7:6] == 2'h3) | (select_937[8] & (select_937[6] | select_937[7]));
  logic or_994;
  assign or_994 = (select_937[10:9] == 2'h3) | (select_937[11] & (select_937[9] | select_937[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1002;
  assign or_1002 = (select_954[7:6] == 2'h3) | (select_954[8] & (~(select_954[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1006;
  assign or_1006 = (select_954[1:0] == 2'h3) | (select_954[2] & (select_954[0] | select_954[1]));
  logic or_1010;
  assign or_1010 = (select_954[4:3] == 2'h3) | (select_954[5] & (select_954[3] | select_954[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1013;
  assign parity_1013 = ^{or_1010, or_1006, or_1002};
  // hls/stages/count_bits.hpp:23
  logic or_1017;
  assign or_1017 = (select_937[4:3] == 2'h3) | (select_937[5] & (select_937[3] | select_937[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1021;
  assign or_1021 = (select_954[10:9] == 2'h3) | (select_954[11] & (select_954[9] | select_954[10]));
  logic or_1025;
  assign or_1025 = (select_937[1:0] == 2'h3) | (select_937[2] & (select_937[0] | select_937[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1028;
  assign parity_1028 = ^{or_1025, or_1021, or_1017};
  logic parity_1031;
  assign parity_1031 = ^{or_1025, or_1021, or_1017, or_1010, or_1006, or_1002, or_994, or_990, or_986};
  // hls/stages/count_bits.hpp:25
  logic or_1036;
  assign or_1036 = (parity_920 & parity_923) | ((^select_914[11:9]) & (parity_920 | parity_923));
  logic and_1039;
  assign and_1039 = (^{select_937[11:6], select_914[2:0]}) & (parity_966 | parity_978);
  // hls/stages/count_bits.hpp:23
  logic or_1047;
  assign or_1047 = (select_914[10:9] == 2'h3) | (select_914[11] & (select_914[9] | select_914[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1051;
  assign or_1051 = (select_914[4:3] == 2'h3) | (select_914[5] & (select_914[3] | select_914[4]));
  logic or_1055;
  assign or_1055 = (select_914[7:6] == 2'h3) | (select_914[8] & (select_914[6] | select_914[7]));
  logic or_1062;
  assign or_1062 = (parity_940 & parity_943) | ((^select_914[2:0]) & (parity_940 | parity_943));
  logic or_1066;
  assign or_1066 = (parity_960 & parity_963) | ((^select_954[8:6]) & (parity_960 | parity_963));
  logic or_1070;
  assign or_1070 = (parity_972 & parity_975) | ((^select_937[5:3]) & (parity_972 | parity_975));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1167;
  assign select_1167 = and_658_s9_q ? select_1166_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1173;
  assign parity_1173 = ^select_1167[5:3];
  logic parity_1176;
  assign parity_1176 = ^select_1167[8:6];
  logic parity_1179;
  assign parity_1179 = ^select_1167[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1188;
  assign select_1188 = and_681_s9_q ? select_1187_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1191;
  assign parity_1191 = ^select_1188[8:6];
  logic parity_1194;
  assign parity_1194 = ^select_1188[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1203;
  assign select_1203 = and_698_s9_q ? select_1202_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1209;
  assign parity_1209 = ^select_1203[2:0];
  logic parity_1212;
  assign parity_1212 = ^select_1203[5:3];
  logic parity_1215;
  assign parity_1215 = ^select_1203[8:0];
  logic parity_1221;
  assign parity_1221 = ^select_1203[11:9];
  logic parity_1224;
  assign parity_1224 = ^select_1188[2:0];
  logic parity_1227;
  assign parity_1227 = ^{select_1203[11:9], select_1188[5:0]};
  logic parity_1230;
  assign parity_1230 = ^{select_1203, select_1188, select_1167[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1235;
  assign or_1235 = (select_1167[1:0] == 2'h3) | (select_1167[2] & (select_1167[0] | select_1167[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1239;
  assign or_1239 = (select_1188[7:6] == 2'h3) | (select_1188[8] & (select_1188[6] | select_1188[7]));
  logic or_1243;
  assign or_1243 = (select_1188[10:9] == 2'h3) | (select_1188[11] & (select_1188[9] | select_1188[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1251;
  assign or_1251 = (select_1203[7:6] == 2'h3) | (select_1203[8] & (~(select_1203[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1255;
  assign or_1255 = (select_1203[1:0] == 2'h3) | (select_1203[2] & (select_1203[0] | select_1203[1]));
  logic or_1259;
  assign or_1259 = (select_1203[4:3] == 2'h3) | (select_1203[5] & (select_1203[3] | select_1203[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1262;
  assign parity_1262 = ^{or_1259, or_1255, or_1251};
  // hls/stages/count_bits.hpp:23
  logic or_1266;
  assign or_1266 = (select_1188[4:3] == 2'h3) | (select_1188[5] & (select_1188[3] | select_1188[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1270;
  assign or_1270 = (select_1203[10:9] == 2'h3) | (select_1203[11] & (select_1203[9] | select_1203[10]));
  logic or_1274;
  assign or_1274 = (select_1188[1:0] == 2'h3) | (select_1188[2] & (select_1188[0] | select_1188[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1277;
  assign parity_1277 = ^{or_1274, or_1270, or_1266};
  logic parity_1280;
  assign parity_1280 = ^{or_1274, or_1270, or_1266, or_1259, or_1255, or_1251, or_1243, or_1239, or_1235};
  // hls/stages/count_bits.hpp:25
  logic or_1285;
  assign or_1285 = (parity_1173 & parity_1176) | ((^select_1167[11:9]) & (parity_1173 | parity_1176));
  logic and_1288;
  assign and_1288 = (^{select_1188[11:6], select_1167[2:0]}) & (parity_1215 | parity_1227);
  // hls/stages/count_bits.hpp:23
  logic or_1296;
  assign or_1296 = (select_1167[10:9] == 2'h3) | (select_1167[11] & (select_1167[9] | select_1167[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1300;
  assign or_1300 = (select_1167[4:3] == 2'h3) | (select_1167[5] & (select_1167[3] | select_1167[4]));
  logic or_1304;
  assign or_1304 = (select_1167[7:6] == 2'h3) | (select_1167[8] & (select_1167[6] | select_1167[7]));
  logic or_1311;
  assign or_1311 = (parity_1191 & parity_1194) | ((^select_1167[2:0]) & (parity_1191 | parity_1194));
  logic or_1315;
  assign or_1315 = (parity_1209 & parity_1212) | ((^select_1203[8:6]) & (parity_1209 | parity_1212));
  logic or_1319;
  assign or_1319 = (parity_1221 & parity_1224) | ((^select_1188[5:3]) & (parity_1221 | parity_1224));
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:235
  logic or_1500;
  assign or_1500 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_535_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_627_s9_q, left_rdata_s9_q[56:42], and_626_s9_q, left_rdata_s9_q[41:27], and_625_s9_q, left_rdata_s9_q[26:12], and_624_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
  end
`ifndef SYNTHESIS
  logic [6:0] left_raddr_s7_sim;
  logic left_re_s7_sim;
  logic [6:0] left_raddr_s8_sim;
  logic left_re_s8_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_re_s7_sim <= 1'b0;
      left_re_s8_sim <= 1'b0;
    end else if (en_i) begin
      left_re_s7_sim <= left_re;
      left_raddr_s7_sim <= left_raddr;
      left_re_s8_sim <= left_re_s7_sim;
      left_raddr_s8_sim <= left_raddr_s7_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s7_sim && left_raddr_s7_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s8_sim && left_raddr_s8_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd120) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd120) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s9_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s9_en & and_535_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_636_s9_q, right_codes_rdata_s9_q[71:60], and_635_s9_q, right_codes_rdata_s9_q[59:48], and_634_s9_q, right_codes_rdata_s9_q[47:36], and_633_s9_q, right_codes_rdata_s9_q[35:24], and_632_s9_q, right_codes_rdata_s9_q[23:12], and_631_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
  end
`ifndef SYNTHESIS
  logic [6:0] right_codes_raddr_s7_sim;
  logic right_codes_re_s7_sim;
  logic [6:0] right_codes_raddr_s8_sim;
  logic right_codes_re_s8_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_codes_re_s7_sim <= 1'b0;
      right_codes_re_s8_sim <= 1'b0;
    end else if (en_i) begin
      right_codes_re_s7_sim <= right_codes_re;
      right_codes_raddr_s7_sim <= right_codes_raddr;
      right_codes_re_s8_sim <= right_codes_re_s7_sim;
      right_codes_raddr_s8_sim <= right_codes_raddr_s7_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s7_sim && right_codes_raddr_s7_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s8_sim && right_codes_raddr_s8_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 7'd120) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 7'd120) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  logic [7:0] pixel_0_s10_q;
  logic [7:0] pixel_1_s10_q;
  logic saturated_s10_q;
  logic mask_s10_q;
  logic marks_first_s10_q;
  logic marks_last_s10_q;
  logic sample_pair_first_s10_q;
  logic sample_pair_whole_s10_q;
  logic sample_present_s10_q;
  logic [5:0] run_shift_s10_q;
  logic [7:0] x_s10_q;
  logic [6:0] last_s10_q;
  logic [3:0] age_s10_q;
  logic [2:0] slot_s10_q;
  logic ends_cell_s10_q;
  logic [3:0] select_464_s10_q;
  logic equal_465_s10_q;
  logic [6:0] select_467_s10_q;
  logic [8:0] select_471_s10_q;
  logic and_477_s10_q;
  logic equal_483_s10_q;
  logic [6:0] column_s10_q;
  logic and_501_s10_q;
  logic and_503_s10_q;
  logic so_s10_q;
  logic equal_523_s10_q;
  logic or_524_s10_q;
  logic equal_526_s10_q;
  logic less_531_s10_q;
  logic not_532_s10_q;
  logic [6:0] row_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_645_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic select_652_s10_q;
  logic xor_733_s10_q;
  logic parity_782_s10_q;
  logic and_783_s10_q;
  logic or_787_s10_q;
  logic or_791_s10_q;
  logic or_798_s10_q;
  logic or_802_s10_q;
  logic or_806_s10_q;
  logic or_813_s10_q;
  logic or_817_s10_q;
  logic or_821_s10_q;
  logic and_830_s10_q;
  logic and_832_s10_q;
  logic or_844_s10_q;
  logic or_848_s10_q;
  logic or_852_s10_q;
  logic xor_982_s10_q;
  logic parity_997_s10_q;
  logic parity_1031_s10_q;
  logic and_1032_s10_q;
  logic or_1036_s10_q;
  logic or_1040_s10_q;
  logic or_1047_s10_q;
  logic or_1051_s10_q;
  logic or_1055_s10_q;
  logic or_1062_s10_q;
  logic or_1066_s10_q;
  logic or_1070_s10_q;
  logic and_1079_s10_q;
  logic or_1080_s10_q;
  logic or_1093_s10_q;
  logic or_1097_s10_q;
  logic or_1101_s10_q;
  logic xor_1231_s10_q;
  logic parity_1246_s10_q;
  logic parity_1280_s10_q;
  logic and_1281_s10_q;
  logic or_1285_s10_q;
  logic or_1289_s10_q;
  logic or_1296_s10_q;
  logic or_1300_s10_q;
  logic or_1304_s10_q;
  logic or_1311_s10_q;
  logic or_1315_s10_q;
  logic or_1319_s10_q;
  logic and_1328_s10_q;
  logic or_1329_s10_q;
  logic or_1342_s10_q;
  logic or_1346_s10_q;
  logic or_1350_s10_q;
  logic and_1454_s10_q;
  logic [6:0] select_1458_s10_q;
  logic [6:0] right_s10_q;
  logic select_1463_s10_q;
  logic equal_1472_s10_q;
  logic and_1479_s10_q;
  logic and_1482_s10_q;
  logic and_1486_s10_q;
  logic or_1500_s10_q;
  logic equal_1591_s10_q;
  logic less_1612_s10_q;
  logic and_2017_s10_q;
  logic equal_2287_s10_q;
  logic and_2288_s10_q;
  logic not_2765_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      pixel_0_s10_q <= pixel_0_s9_q;
      pixel_1_s10_q <= pixel_1_s9_q;
      saturated_s10_q <= saturated_s9_q;
      mask_s10_q <= mask_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      sample_pair_first_s10_q <= sample_pair_first_s9_q;
      sample_pair_whole_s10_q <= sample_pair_whole_s9_q;
      sample_present_s10_q <= sample_present_s9_q;
      run_shift_s10_q <= run_shift_s9_q;
      x_s10_q <= x_s9_q;
      last_s10_q <= last_s9_q;
      age_s10_q <= age_s9_q;
      slot_s10_q <= slot_s9_q;
      ends_cell_s10_q <= ends_cell_s9_q;
      select_464_s10_q <= select_464_s9_q;
      equal_465_s10_q <= equal_465_s9_q;
      select_467_s10_q <= select_467_s9_q;
      select_471_s10_q <= select_471_s9_q;
      and_477_s10_q <= and_477_s9_q;
      equal_483_s10_q <= equal_483_s9_q;
      column_s10_q <= column_s9_q;
      and_501_s10_q <= and_501_s9_q;
      and_503_s10_q <= and_503_s9_q;
      so_s10_q <= so_s9_q;
      equal_523_s10_q <= equal_523_s9_q;
      or_524_s10_q <= or_524_s9_q;
      equal_526_s10_q <= equal_526_s9_q;
      less_531_s10_q <= less_531_s9_q;
      not_532_s10_q <= not_532_s9_q;
      row_s10_q <= row_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_645_s10_q <= select_645_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_652_s10_q <= select_652_s9_q;
      xor_733_s10_q <= parity_677 ^ parity_732;
      parity_782_s10_q <= parity_782;
      and_783_s10_q <= parity_677 & parity_732;
      or_787_s10_q <= or_787;
      or_791_s10_q <= (parity_717 & parity_729) | and_790;
      or_798_s10_q <= or_798;
      or_802_s10_q <= or_802;
      or_806_s10_q <= or_806;
      or_813_s10_q <= or_813;
      or_817_s10_q <= or_817;
      or_821_s10_q <= or_821;
      and_830_s10_q <= parity_764 & parity_779;
      and_832_s10_q <= (^{or_745, or_741, or_737}) & (parity_764 | parity_779);
      or_844_s10_q <= (or_741 & or_745) | (or_737 & (or_741 | or_745));
      or_848_s10_q <= (or_757 & or_761) | (or_753 & (or_757 | or_761));
      or_852_s10_q <= (or_772 & or_776) | (or_768 & (or_772 | or_776));
      xor_982_s10_q <= parity_926 ^ parity_981;
      parity_997_s10_q <= ^{or_994, or_990, or_986};
      parity_1031_s10_q <= parity_1031;
      and_1032_s10_q <= parity_926 & parity_981;
      or_1036_s10_q <= or_1036;
      or_1040_s10_q <= (parity_966 & parity_978) | and_1039;
      or_1047_s10_q <= or_1047;
      or_1051_s10_q <= or_1051;
      or_1055_s10_q <= or_1055;
      or_1062_s10_q <= or_1062;
      or_1066_s10_q <= or_1066;
      or_1070_s10_q <= or_1070;
      and_1079_s10_q <= parity_1013 & parity_1028;
      or_1080_s10_q <= parity_1013 | parity_1028;
      or_1093_s10_q <= (or_990 & or_994) | (or_986 & (or_990 | or_994));
      or_1097_s10_q <= (or_1006 & or_1010) | (or_1002 & (or_1006 | or_1010));
      or_1101_s10_q <= (or_1021 & or_1025) | (or_1017 & (or_1021 | or_1025));
      xor_1231_s10_q <= parity_1179 ^ parity_1230;
      parity_1246_s10_q <= ^{or_1243, or_1239, or_1235};
      parity_1280_s10_q <= parity_1280;
      and_1281_s10_q <= parity_1179 & parity_1230;
      or_1285_s10_q <= or_1285;
      or_1289_s10_q <= (parity_1215 & parity_1227) | and_1288;
      or_1296_s10_q <= or_1296;
      or_1300_s10_q <= or_1300;
      or_1304_s10_q <= or_1304;
      or_1311_s10_q <= or_1311;
      or_1315_s10_q <= or_1315;
      or_1319_s10_q <= or_1319;
      and_1328_s10_q <= parity_1262 & parity_1277;
      or_1329_s10_q <= parity_1262 | parity_1277;
      or_1342_s10_q <= (or_1239 & or_1243) | (or_1235 & (or_1239 | or_1243));
      or_1346_s10_q <= (or_1255 & or_1259) | (or_1251 & (or_1255 | or_1259));
      or_1350_s10_q <= (or_1270 & or_1274) | (or_1266 & (or_1270 | or_1274));
      and_1454_s10_q <= and_1454_s9_q;
      select_1458_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      select_1463_s10_q <= select_1463_s9_q;
      equal_1472_s10_q <= equal_1472_s9_q;
      and_1479_s10_q <= and_1479_s9_q;
      and_1482_s10_q <= and_1482_s9_q;
      and_1486_s10_q <= and_1486_s9_q;
      or_1500_s10_q <= or_1500;
      equal_1591_s10_q <= equal_1591_s9_q;
      less_1612_s10_q <= less_1612_s9_q;
      and_2017_s10_q <= and_2017_s9_q;
      equal_2287_s10_q <= equal_2287_s9_q;
      and_2288_s10_q <= and_2288_s9_q;
      not_2765_s10_q <= not_2765_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_phase_q;
  // hls/stages/count_bits.hpp:24
  logic parity_809;
  assign parity_809 = ^{or_806_s10_q, or_802_s10_q, or_798_s10_q};
  logic parity_824;
  assign parity_824 = ^{or_821_s10_q, or_817_s10_q, or_813_s10_q};
  logic parity_827;
  assign parity_827 = ^{or_821_s10_q, or_817_s10_q, or_813_s10_q, or_806_s10_q, or_802_s10_q, or_798_s10_q, or_791_s10_q, or_787_s10_q, and_783_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_829;
  assign and_829 = parity_782_s10_q & parity_827;
  logic or_833;
  assign or_833 = and_830_s10_q | and_832_s10_q;
  logic and_836;
  assign and_836 = (^{or_791_s10_q, or_787_s10_q, and_783_s10_q}) & (parity_809 | parity_824);
  logic or_837;
  assign or_837 = (parity_809 & parity_824) | and_836;
  // hls/stages/count_bits.hpp:24
  logic parity_855;
  assign parity_855 = ^{or_852_s10_q, or_848_s10_q, or_844_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_859;
  assign or_859 = (or_787_s10_q & or_791_s10_q) | (and_783_s10_q & (or_787_s10_q | or_791_s10_q));
  logic or_863;
  assign or_863 = (or_802_s10_q & or_806_s10_q) | (or_798_s10_q & (or_802_s10_q | or_806_s10_q));
  logic or_867;
  assign or_867 = (or_817_s10_q & or_821_s10_q) | (or_813_s10_q & (or_817_s10_q | or_821_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_870;
  assign parity_870 = ^{or_867, or_863, or_859};
  logic parity_873;
  assign parity_873 = ^{or_867, or_863, or_859, or_852_s10_q, or_848_s10_q, or_844_s10_q, or_837, or_833, and_829};
  // hls/stages/count_bits.hpp:25
  logic or_885;
  assign or_885 = (or_848_s10_q & or_852_s10_q) | (or_844_s10_q & (or_848_s10_q | or_852_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1058;
  assign parity_1058 = ^{or_1055_s10_q, or_1051_s10_q, or_1047_s10_q};
  logic parity_1073;
  assign parity_1073 = ^{or_1070_s10_q, or_1066_s10_q, or_1062_s10_q};
  logic parity_1076;
  assign parity_1076 = ^{or_1070_s10_q, or_1066_s10_q, or_1062_s10_q, or_1055_s10_q, or_1051_s10_q, or_1047_s10_q, or_1040_s10_q, or_1036_s10_q, and_1032_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1078;
  assign and_1078 = parity_1031_s10_q & parity_1076;
  logic or_1082;
  assign or_1082 = and_1079_s10_q | (parity_997_s10_q & or_1080_s10_q);
  logic and_1085;
  assign and_1085 = (^{or_1040_s10_q, or_1036_s10_q, and_1032_s10_q}) & (parity_1058 | parity_1073);
  logic or_1086;
  assign or_1086 = (parity_1058 & parity_1073) | and_1085;
  // hls/stages/count_bits.hpp:24
  logic parity_1104;
  assign parity_1104 = ^{or_1101_s10_q, or_1097_s10_q, or_1093_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1108;
  assign or_1108 = (or_1036_s10_q & or_1040_s10_q) | (and_1032_s10_q & (or_1036_s10_q | or_1040_s10_q));
  logic or_1112;
  assign or_1112 = (or_1051_s10_q & or_1055_s10_q) | (or_1047_s10_q & (or_1051_s10_q | or_1055_s10_q));
  logic or_1116;
  assign or_1116 = (or_1066_s10_q & or_1070_s10_q) | (or_1062_s10_q & (or_1066_s10_q | or_1070_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1119;
  assign parity_1119 = ^{or_1116, or_1112, or_1108};
  logic parity_1122;
  assign parity_1122 = ^{or_1116, or_1112, or_1108, or_1101_s10_q, or_1097_s10_q, or_1093_s10_q, or_1086, or_1082, and_1078};
  // hls/stages/count_bits.hpp:25
  logic or_1134;
  assign or_1134 = (or_1097_s10_q & or_1101_s10_q) | (or_1093_s10_q & (or_1097_s10_q | or_1101_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1307;
  assign parity_1307 = ^{or_1304_s10_q, or_1300_s10_q, or_1296_s10_q};
  logic parity_1322;
  assign parity_1322 = ^{or_1319_s10_q, or_1315_s10_q, or_1311_s10_q};
  logic parity_1325;
  assign parity_1325 = ^{or_1319_s10_q, or_1315_s10_q, or_1311_s10_q, or_1304_s10_q, or_1300_s10_q, or_1296_s10_q, or_1289_s10_q, or_1285_s10_q, and_1281_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1327;
  assign and_1327 = parity_1280_s10_q & parity_1325;
  logic or_1331;
  assign or_1331 = and_1328_s10_q | (parity_1246_s10_q & or_1329_s10_q);
  logic and_1334;
  assign and_1334 = (^{or_1289_s10_q, or_1285_s10_q, and_1281_s10_q}) & (parity_1307 | parity_1322);
  logic or_1335;
  assign or_1335 = (parity_1307 & parity_1322) | and_1334;
  // hls/stages/count_bits.hpp:24
  logic parity_1353;
  assign parity_1353 = ^{or_1350_s10_q, or_1346_s10_q, or_1342_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1357;
  assign or_1357 = (or_1285_s10_q & or_1289_s10_q) | (and_1281_s10_q & (or_1285_s10_q | or_1289_s10_q));
  logic or_1361;
  assign or_1361 = (or_1300_s10_q & or_1304_s10_q) | (or_1296_s10_q & (or_1300_s10_q | or_1304_s10_q));
  logic or_1365;
  assign or_1365 = (or_1315_s10_q & or_1319_s10_q) | (or_1311_s10_q & (or_1315_s10_q | or_1319_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1368;
  assign parity_1368 = ^{or_1365, or_1361, or_1357};
  logic parity_1371;
  assign parity_1371 = ^{or_1365, or_1361, or_1357, or_1350_s10_q, or_1346_s10_q, or_1342_s10_q, or_1335, or_1331, and_1327};
  // hls/stages/count_bits.hpp:25
  logic or_1383;
  assign or_1383 = (or_1346_s10_q & or_1350_s10_q) | (or_1342_s10_q & (or_1346_s10_q | or_1350_s10_q));
  // hls/stages/agreement.hpp:141
  logic [6:0] select_1510;
  assign select_1510 = or_524_s10_q ? (less_531_s10_q ? 7'h0 : select_1458_s10_q) : 7'h0;
  // hls/stages/patches.hpp:105
  logic and_1585;
  assign and_1585 = (select_464_s10_q == 4'h0) & (select_467_s10_q == 7'h0);
  // hls/stages/patches.hpp:299
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:109
  logic [3:0] select_2699;
  assign select_2699 = and_1585 ? (sample_pair_first_s10_q ? phase : patches_phase_q) : patches_phase_q;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1298; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_524_s10_q ? select_1458_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_645_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_phase_q <= 4'h0;
    end else if (s10_en) begin
      patches_phase_q <= sample_pair_whole_s10_q ? select_2699 : patches_phase_q;
    end
  end

  logic [7:0] pixel_0_s11_q;
  logic [7:0] pixel_1_s11_q;
  logic saturated_s11_q;
  logic mask_s11_q;
  logic marks_first_s11_q;
  logic marks_last_s11_q;
  logic sample_pair_first_s11_q;
  logic sample_pair_whole_s11_q;
  logic sample_present_s11_q;
  logic [5:0] run_shift_s11_q;
  logic [7:0] x_s11_q;
  logic [6:0] last_s11_q;
  logic [3:0] age_s11_q;
  logic [2:0] slot_s11_q;
  logic ends_cell_s11_q;
  logic [3:0] select_464_s11_q;
  logic equal_465_s11_q;
  logic [6:0] select_467_s11_q;
  logic [8:0] select_471_s11_q;
  logic and_477_s11_q;
  logic equal_483_s11_q;
  logic [6:0] column_s11_q;
  logic and_501_s11_q;
  logic and_503_s11_q;
  logic so_s11_q;
  logic equal_523_s11_q;
  logic or_524_s11_q;
  logic equal_526_s11_q;
  logic less_531_s11_q;
  logic not_532_s11_q;
  logic [6:0] row_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic select_652_s11_q;
  logic xor_733_s11_q;
  logic xor_828_s11_q;
  logic parity_873_s11_q;
  logic and_874_s11_q;
  logic and_876_s11_q;
  logic and_878_s11_q;
  logic and_880_s11_q;
  logic or_885_s11_q;
  logic or_889_s11_q;
  logic xor_982_s11_q;
  logic xor_1077_s11_q;
  logic parity_1122_s11_q;
  logic and_1123_s11_q;
  logic and_1125_s11_q;
  logic and_1127_s11_q;
  logic and_1129_s11_q;
  logic or_1134_s11_q;
  logic or_1138_s11_q;
  logic xor_1231_s11_q;
  logic xor_1326_s11_q;
  logic parity_1371_s11_q;
  logic and_1372_s11_q;
  logic and_1374_s11_q;
  logic and_1376_s11_q;
  logic and_1378_s11_q;
  logic or_1383_s11_q;
  logic or_1387_s11_q;
  logic and_1454_s11_q;
  logic [6:0] right_s11_q;
  logic select_1463_s11_q;
  logic equal_1472_s11_q;
  logic and_1479_s11_q;
  logic and_1482_s11_q;
  logic and_1486_s11_q;
  logic or_1500_s11_q;
  logic [6:0] select_1511_s11_q;
  logic and_1585_s11_q;
  logic equal_1591_s11_q;
  logic less_1612_s11_q;
  logic and_2017_s11_q;
  logic equal_2287_s11_q;
  logic and_2288_s11_q;
  logic [3:0] phase_s11_q;
  logic not_2765_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      pixel_0_s11_q <= pixel_0_s10_q;
      pixel_1_s11_q <= pixel_1_s10_q;
      saturated_s11_q <= saturated_s10_q;
      mask_s11_q <= mask_s10_q;
      marks_first_s11_q <= marks_first_s10_q;
      marks_last_s11_q <= marks_last_s10_q;
      sample_pair_first_s11_q <= sample_pair_first_s10_q;
      sample_pair_whole_s11_q <= sample_pair_whole_s10_q;
      sample_present_s11_q <= sample_present_s10_q;
      run_shift_s11_q <= run_shift_s10_q;
      x_s11_q <= x_s10_q;
      last_s11_q <= last_s10_q;
      age_s11_q <= age_s10_q;
      slot_s11_q <= slot_s10_q;
      ends_cell_s11_q <= ends_cell_s10_q;
      select_464_s11_q <= select_464_s10_q;
      equal_465_s11_q <= equal_465_s10_q;
      select_467_s11_q <= select_467_s10_q;
      select_471_s11_q <= select_471_s10_q;
      and_477_s11_q <= and_477_s10_q;
      equal_483_s11_q <= equal_483_s10_q;
      column_s11_q <= column_s10_q;
      and_501_s11_q <= and_501_s10_q;
      and_503_s11_q <= and_503_s10_q;
      so_s11_q <= so_s10_q;
      equal_523_s11_q <= equal_523_s10_q;
      or_524_s11_q <= or_524_s10_q;
      equal_526_s11_q <= equal_526_s10_q;
      less_531_s11_q <= less_531_s10_q;
      not_532_s11_q <= not_532_s10_q;
      row_s11_q <= row_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_652_s11_q <= select_652_s10_q;
      xor_733_s11_q <= xor_733_s10_q;
      xor_828_s11_q <= parity_782_s10_q ^ parity_827;
      parity_873_s11_q <= parity_873;
      and_874_s11_q <= parity_855 & parity_870;
      and_876_s11_q <= (^{or_837, or_833, and_829}) & (parity_855 | parity_870);
      and_878_s11_q <= or_833 & or_837;
      and_880_s11_q <= and_829 & (or_833 | or_837);
      or_885_s11_q <= or_885;
      or_889_s11_q <= (or_863 & or_867) | (or_859 & (or_863 | or_867));
      xor_982_s11_q <= xor_982_s10_q;
      xor_1077_s11_q <= parity_1031_s10_q ^ parity_1076;
      parity_1122_s11_q <= parity_1122;
      and_1123_s11_q <= parity_1104 & parity_1119;
      and_1125_s11_q <= (^{or_1086, or_1082, and_1078}) & (parity_1104 | parity_1119);
      and_1127_s11_q <= or_1082 & or_1086;
      and_1129_s11_q <= and_1078 & (or_1082 | or_1086);
      or_1134_s11_q <= or_1134;
      or_1138_s11_q <= (or_1112 & or_1116) | (or_1108 & (or_1112 | or_1116));
      xor_1231_s11_q <= xor_1231_s10_q;
      xor_1326_s11_q <= parity_1280_s10_q ^ parity_1325;
      parity_1371_s11_q <= parity_1371;
      and_1372_s11_q <= parity_1353 & parity_1368;
      and_1374_s11_q <= (^{or_1335, or_1331, and_1327}) & (parity_1353 | parity_1368);
      and_1376_s11_q <= or_1331 & or_1335;
      and_1378_s11_q <= and_1327 & (or_1331 | or_1335);
      or_1383_s11_q <= or_1383;
      or_1387_s11_q <= (or_1361 & or_1365) | (or_1357 & (or_1361 | or_1365));
      and_1454_s11_q <= and_1454_s10_q;
      right_s11_q <= right_s10_q;
      select_1463_s11_q <= select_1463_s10_q;
      equal_1472_s11_q <= equal_1472_s10_q;
      and_1479_s11_q <= and_1479_s10_q;
      and_1482_s11_q <= and_1482_s10_q;
      and_1486_s11_q <= and_1486_s10_q;
      or_1500_s11_q <= or_1500_s10_q;
      select_1511_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1510;
      and_1585_s11_q <= and_1585;
      equal_1591_s11_q <= equal_1591_s10_q;
      less_1612_s11_q <= less_1612_s10_q;
      and_2017_s11_q <= and_2017_s10_q;
      equal_2287_s11_q <= equal_2287_s10_q;
      and_2288_s11_q <= and_2288_s10_q;
      phase_s11_q <= phase;
      not_2765_s11_q <= not_2765_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/count_bits.hpp:25
  logic or_877;
  assign or_877 = and_874_s11_q | and_876_s11_q;
  logic or_881;
  assign or_881 = and_878_s11_q | and_880_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_894;
  assign parity_894 = ^{or_889_s11_q, or_885_s11_q, or_881, or_877};
  // hls/stages/count_bits.hpp:25
  logic or_898;
  assign or_898 = (or_885_s11_q & or_889_s11_q) | (or_881 & (or_885_s11_q | or_889_s11_q));
  logic and_899;
  assign and_899 = or_877 & (^{or_889_s11_q, or_885_s11_q, or_881});
  // hls/stages/count_bits.hpp:24
  logic xor_900;
  assign xor_900 = or_898 ^ and_899;
  // hls/stages/count_bits.hpp:27
  logic and_901;
  assign and_901 = or_898 & and_899;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_902;
  assign select_902 = equal_526_s11_q ? {and_901, xor_900, parity_894, parity_873_s11_q, xor_828_s11_q, xor_733_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_524_s11_q ? 6'h0 : select_902;
  // hls/stages/count_bits.hpp:25
  logic or_1126;
  assign or_1126 = and_1123_s11_q | and_1125_s11_q;
  logic or_1130;
  assign or_1130 = and_1127_s11_q | and_1129_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1143;
  assign parity_1143 = ^{or_1138_s11_q, or_1134_s11_q, or_1130, or_1126};
  // hls/stages/count_bits.hpp:25
  logic or_1147;
  assign or_1147 = (or_1134_s11_q & or_1138_s11_q) | (or_1130 & (or_1134_s11_q | or_1138_s11_q));
  logic and_1148;
  assign and_1148 = or_1126 & (^{or_1138_s11_q, or_1134_s11_q, or_1130});
  // hls/stages/count_bits.hpp:24
  logic xor_1149;
  assign xor_1149 = or_1147 ^ and_1148;
  // hls/stages/count_bits.hpp:27
  logic and_1150;
  assign and_1150 = or_1147 & and_1148;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1151;
  assign select_1151 = equal_526_s11_q ? {and_1150, xor_1149, parity_1143, parity_1122_s11_q, xor_1077_s11_q, xor_982_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_524_s11_q ? 6'h0 : select_1151;
  // hls/stages/count_bits.hpp:25
  logic or_1375;
  assign or_1375 = and_1372_s11_q | and_1374_s11_q;
  logic or_1379;
  assign or_1379 = and_1376_s11_q | and_1378_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1392;
  assign parity_1392 = ^{or_1387_s11_q, or_1383_s11_q, or_1379, or_1375};
  // hls/stages/count_bits.hpp:25
  logic or_1396;
  assign or_1396 = (or_1383_s11_q & or_1387_s11_q) | (or_1379 & (or_1383_s11_q | or_1387_s11_q));
  logic and_1397;
  assign and_1397 = or_1375 & (^{or_1387_s11_q, or_1383_s11_q, or_1379});
  // hls/stages/count_bits.hpp:24
  logic xor_1398;
  assign xor_1398 = or_1396 ^ and_1397;
  // hls/stages/count_bits.hpp:27
  logic and_1399;
  assign and_1399 = or_1396 & and_1397;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1400;
  assign select_1400 = equal_526_s11_q ? {and_1399, xor_1398, parity_1392, parity_1371_s11_q, xor_1326_s11_q, xor_1231_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_524_s11_q ? 6'h0 : select_1400;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1440;
  assign sum_1440 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1443;
  assign sum_1443 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:447
  logic select_2384;
  assign select_2384 = equal_2287_s11_q ? (~({row_s11_q, 1'b0} < {sum_2381, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2589;
  assign and_2589 = and_503_s11_q & (equal_2287_s11_q & (row_s11_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      lower_half_q <= 1'b0;
    end else if (s11_en) begin
      lower_half_q <= and_503_s11_q ? select_2384 : lower_half_q;
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
    if (s11_en) begin
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

  logic [7:0] pixel_0_s12_q;
  logic [7:0] pixel_1_s12_q;
  logic saturated_s12_q;
  logic mask_s12_q;
  logic marks_first_s12_q;
  logic marks_last_s12_q;
  logic sample_pair_first_s12_q;
  logic sample_pair_whole_s12_q;
  logic sample_present_s12_q;
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [6:0] last_s12_q;
  logic [3:0] age_s12_q;
  logic [2:0] slot_s12_q;
  logic ends_cell_s12_q;
  logic lower_half_s12_q;
  logic [3:0] select_464_s12_q;
  logic equal_465_s12_q;
  logic [6:0] select_467_s12_q;
  logic [8:0] select_471_s12_q;
  logic and_477_s12_q;
  logic equal_483_s12_q;
  logic [6:0] column_s12_q;
  logic and_501_s12_q;
  logic and_503_s12_q;
  logic so_s12_q;
  logic equal_523_s12_q;
  logic or_524_s12_q;
  logic less_531_s12_q;
  logic not_532_s12_q;
  logic equal_564_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic select_652_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1153_s12_q;
  logic [5:0] select_1402_s12_q;
  logic [6:0] sum_1441_s12_q;
  logic [6:0] sum_1444_s12_q;
  logic and_1454_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic select_1463_s12_q;
  logic equal_1472_s12_q;
  logic and_1479_s12_q;
  logic and_1482_s12_q;
  logic and_1486_s12_q;
  logic or_1500_s12_q;
  logic [6:0] select_1511_s12_q;
  logic and_1585_s12_q;
  logic equal_1591_s12_q;
  logic less_1612_s12_q;
  logic and_2017_s12_q;
  logic equal_2163_s12_q;
  logic equal_2287_s12_q;
  logic and_2590_s12_q;
  logic and_2592_s12_q;
  logic [3:0] phase_s12_q;
  logic equal_2719_s12_q;
  logic [3:0] select_2722_s12_q;
  logic less_2733_s12_q;
  logic not_2765_s12_q;
  logic less_3592_s12_q;
  logic equal_3797_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      pixel_0_s12_q <= pixel_0_s11_q;
      pixel_1_s12_q <= pixel_1_s11_q;
      saturated_s12_q <= saturated_s11_q;
      mask_s12_q <= mask_s11_q;
      marks_first_s12_q <= marks_first_s11_q;
      marks_last_s12_q <= marks_last_s11_q;
      sample_pair_first_s12_q <= sample_pair_first_s11_q;
      sample_pair_whole_s12_q <= sample_pair_whole_s11_q;
      sample_present_s12_q <= sample_present_s11_q;
      run_shift_s12_q <= run_shift_s11_q;
      x_s12_q <= x_s11_q;
      last_s12_q <= last_s11_q;
      age_s12_q <= age_s11_q;
      slot_s12_q <= slot_s11_q;
      ends_cell_s12_q <= ends_cell_s11_q;
      lower_half_s12_q <= lower_half_q;
      select_464_s12_q <= select_464_s11_q;
      equal_465_s12_q <= equal_465_s11_q;
      select_467_s12_q <= select_467_s11_q;
      select_471_s12_q <= select_471_s11_q;
      and_477_s12_q <= and_477_s11_q;
      equal_483_s12_q <= equal_483_s11_q;
      column_s12_q <= column_s11_q;
      and_501_s12_q <= and_501_s11_q;
      and_503_s12_q <= and_503_s11_q;
      so_s12_q <= so_s11_q;
      equal_523_s12_q <= equal_523_s11_q;
      or_524_s12_q <= or_524_s11_q;
      less_531_s12_q <= less_531_s11_q;
      not_532_s12_q <= not_532_s11_q;
      equal_564_s12_q <= row_s11_q == 7'h0;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_652_s12_q <= select_652_s11_q;
      column_2_s12_q <= column_2;
      select_1153_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1402_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1441_s12_q <= {1'b0, before_v_2} + sum_1440;
      sum_1444_s12_q <= {1'b0, before_v_3} + sum_1443;
      and_1454_s12_q <= and_1454_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      select_1463_s12_q <= select_1463_s11_q;
      equal_1472_s12_q <= equal_1472_s11_q;
      and_1479_s12_q <= and_1479_s11_q;
      and_1482_s12_q <= and_1482_s11_q;
      and_1486_s12_q <= and_1486_s11_q;
      or_1500_s12_q <= or_1500_s11_q;
      select_1511_s12_q <= select_1511_s11_q;
      and_1585_s12_q <= and_1585_s11_q;
      equal_1591_s12_q <= equal_1591_s11_q;
      less_1612_s12_q <= less_1612_s11_q;
      and_2017_s12_q <= and_2017_s11_q;
      equal_2163_s12_q <= (column_s11_q | row_s11_q) == 7'h0;
      equal_2287_s12_q <= equal_2287_s11_q;
      and_2590_s12_q <= and_2288_s11_q & and_2589;
      and_2592_s12_q <= and_2288_s11_q & (~and_2589);
      phase_s12_q <= phase_s11_q;
      equal_2719_s12_q <= row_s11_q == 7'h3;
      select_2722_s12_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      less_2733_s12_q <= 7'h2 < row_s11_q;
      not_2765_s12_q <= not_2765_s11_q;
      less_3592_s12_q <= 6'h2 < row_s11_q[6:1];
      equal_3797_s12_q <= row_s11_q[6:3] == 4'h0;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  logic [5:0] middle_sum_columns_values_0_q;
  logic [5:0] middle_sum_columns_values_1_q;
  logic [5:0] middle_sum_columns_values_2_q;
  logic [5:0] middle_sum_columns_values_3_q;
  logic [5:0] middle_sum_columns_values_4_q;
  logic [5:0] middle_sum_columns_values_5_q;
  logic [5:0] middle_sum_columns_values_6_q;
  logic [3:0] patches_choosing_rows_to_next_q;
  logic patches_chooses_q;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_904;
  assign select_904 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1436;
  assign sum_1436 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1446;
  assign select_1446 = (sum_1441_s12_q < sum_1444_s12_q) ? sum_1444_s12_q : sum_1441_s12_q;
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2387;
  assign select_2387 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2388;
  assign select_2388 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2389;
  assign select_2389 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2390;
  assign select_2390 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2391;
  assign select_2391 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2392;
  assign select_2392 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/patches.hpp:70
  logic [3:0] select_2723;
  assign select_2723 = equal_2719_s12_q ? select_2722_s12_q : patches_choosing_rows_to_next_q;
  logic equal_2724;
  assign equal_2724 = select_2723 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2727;
  assign select_2727 = equal_2287_s12_q ? (equal_2724 ? 4'h2 : (select_2723 + 4'hf)) : patches_choosing_rows_to_next_q;
  logic select_2735;
  assign select_2735 = equal_2287_s12_q ? (less_2733_s12_q & equal_2724) : patches_chooses_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_chooses_q <= 1'b0;
    end else if (s12_en) begin
      patches_choosing_rows_to_next_q <= and_503_s12_q ? select_2727 : patches_choosing_rows_to_next_q;
      patches_chooses_q <= and_503_s12_q ? select_2735 : patches_chooses_q;
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s12_en) begin
      middle_sum_columns_values_0_q <= slot_s12_q[0] ? middle_sum_columns_values_0_q : column_2_s12_q;
      middle_sum_columns_values_1_q <= select_2387;
      middle_sum_columns_values_2_q <= select_2388;
      middle_sum_columns_values_3_q <= select_2389;
      middle_sum_columns_values_4_q <= select_2390;
      middle_sum_columns_values_5_q <= select_2391;
      middle_sum_columns_values_6_q <= select_2392;
    end
  end

  logic [7:0] pixel_0_s13_q;
  logic [7:0] pixel_1_s13_q;
  logic saturated_s13_q;
  logic mask_s13_q;
  logic marks_first_s13_q;
  logic marks_last_s13_q;
  logic sample_pair_first_s13_q;
  logic sample_pair_whole_s13_q;
  logic sample_present_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic [6:0] last_s13_q;
  logic [1:0] age_s13_q;
  logic [2:0] slot_s13_q;
  logic ends_cell_s13_q;
  logic lower_half_s13_q;
  logic [3:0] patches_choosing_rows_to_next_s13_q;
  logic patches_chooses_s13_q;
  logic [3:0] select_464_s13_q;
  logic equal_465_s13_q;
  logic [6:0] select_467_s13_q;
  logic [8:0] select_471_s13_q;
  logic and_477_s13_q;
  logic equal_483_s13_q;
  logic [6:0] column_s13_q;
  logic and_501_s13_q;
  logic and_503_s13_q;
  logic so_s13_q;
  logic equal_523_s13_q;
  logic or_524_s13_q;
  logic less_531_s13_q;
  logic not_532_s13_q;
  logic equal_564_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_652_s13_q;
  logic [6:0] difference_905_s13_q;
  logic [6:0] difference_1154_s13_q;
  logic equal_1155_s13_q;
  logic [6:0] difference_1403_s13_q;
  logic [6:0] sum_1437_s13_q;
  logic [6:0] select_1446_s13_q;
  logic and_1454_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1463_s13_q;
  logic equal_1472_s13_q;
  logic and_1479_s13_q;
  logic and_1482_s13_q;
  logic and_1486_s13_q;
  logic less_1487_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1500_s13_q;
  logic [6:0] select_1511_s13_q;
  logic and_1585_s13_q;
  logic equal_1591_s13_q;
  logic less_1612_s13_q;
  logic and_2017_s13_q;
  logic equal_2163_s13_q;
  logic equal_2287_s13_q;
  logic and_2590_s13_q;
  logic and_2592_s13_q;
  logic and_2599_s13_q;
  logic [3:0] phase_s13_q;
  logic equal_2719_s13_q;
  logic equal_2724_s13_q;
  logic not_2765_s13_q;
  logic less_3592_s13_q;
  logic equal_3797_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
      pixel_0_s13_q <= pixel_0_s12_q;
      pixel_1_s13_q <= pixel_1_s12_q;
      saturated_s13_q <= saturated_s12_q;
      mask_s13_q <= mask_s12_q;
      marks_first_s13_q <= marks_first_s12_q;
      marks_last_s13_q <= marks_last_s12_q;
      sample_pair_first_s13_q <= sample_pair_first_s12_q;
      sample_pair_whole_s13_q <= sample_pair_whole_s12_q;
      sample_present_s13_q <= sample_present_s12_q;
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      last_s13_q <= last_s12_q;
      age_s13_q <= {age_s12_q[2], age_s12_q[0]};
      slot_s13_q <= slot_s12_q;
      ends_cell_s13_q <= ends_cell_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      patches_choosing_rows_to_next_s13_q <= patches_choosing_rows_to_next_q;
      patches_chooses_s13_q <= patches_chooses_q;
      select_464_s13_q <= select_464_s12_q;
      equal_465_s13_q <= equal_465_s12_q;
      select_467_s13_q <= select_467_s12_q;
      select_471_s13_q <= select_471_s12_q;
      and_477_s13_q <= and_477_s12_q;
      equal_483_s13_q <= equal_483_s12_q;
      column_s13_q <= column_s12_q;
      and_501_s13_q <= and_501_s12_q;
      and_503_s13_q <= and_503_s12_q;
      so_s13_q <= so_s12_q;
      equal_523_s13_q <= equal_523_s12_q;
      or_524_s13_q <= or_524_s12_q;
      less_531_s13_q <= less_531_s12_q;
      not_532_s13_q <= not_532_s12_q;
      equal_564_s13_q <= equal_564_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_652_s13_q <= select_652_s12_q;
      difference_905_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_904};
      difference_1154_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1153_s12_q};
      equal_1155_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1403_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1402_s12_q};
      sum_1437_s13_q <= {1'b0, before_v} + sum_1436;
      select_1446_s13_q <= select_1446;
      and_1454_s13_q <= and_1454_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1463_s13_q <= select_1463_s12_q;
      equal_1472_s13_q <= equal_1472_s12_q;
      and_1479_s13_q <= and_1479_s12_q;
      and_1482_s13_q <= and_1482_s12_q;
      and_1486_s13_q <= and_1486_s12_q;
      less_1487_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1500_s13_q <= or_1500_s12_q;
      select_1511_s13_q <= select_1511_s12_q;
      and_1585_s13_q <= and_1585_s12_q;
      equal_1591_s13_q <= equal_1591_s12_q;
      less_1612_s13_q <= less_1612_s12_q;
      and_2017_s13_q <= and_2017_s12_q;
      equal_2163_s13_q <= equal_2163_s12_q;
      equal_2287_s13_q <= equal_2287_s12_q;
      and_2590_s13_q <= and_2590_s12_q;
      and_2592_s13_q <= and_2592_s12_q;
      and_2599_s13_q <= ends_cell_s12_q & so_s12_q;
      phase_s13_q <= phase_s12_q;
      equal_2719_s13_q <= equal_2719_s12_q;
      equal_2724_s13_q <= equal_2724;
      not_2765_s13_q <= not_2765_s12_q;
      less_3592_s13_q <= less_3592_s12_q;
      equal_3797_s13_q <= equal_3797_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [6:0] chosen_near_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [3:0] patches_band_rows_rows_to_next_q;
  logic [4:0] patches_band_rows_number_q;
  logic [3:0] patches_next_band_rows_to_next_q;
  logic [4:0] patches_next_band_number_q;
  logic [3:0] patches_first_band_rows_to_next_q;
  logic patches_first_band_number_q;
  logic [4:0] patches_choosing_number_q;
  logic [4:0] patches_choosing_band_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/agreement.hpp:772
  logic less_653;
  assign less_653 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_655;
  assign less_655 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:231
  logic and_657;
  assign and_657 = (~less_653) & (~less_655);
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_907;
  assign sum_907 = {difference_905_s13_q[6], difference_905_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1157;
  assign sum_1157 = {difference_1154_s13_q[6], difference_1154_s13_q} + (equal_1155_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1405;
  assign sum_1405 = {difference_1403_s13_q[6], difference_1403_s13_q} + (equal_1155_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1438;
  assign select_1438 = slot_s13_q[0] ? chosen_near_q : sum_1437_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1448;
  assign select_1448 = (select_1438 < select_1446_s13_q) ? select_1446_s13_q : select_1438;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_657 ? select_1448 : 7'h0;
  // hls/stages/agreement.hpp:935
  logic select_1489;
  assign select_1489 = slot_s13_q[2] ? less_1487_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1492;
  assign difference_1492 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/census.hpp:31
  logic not_1589;
  assign not_1589 = ~sample_pair_first_s13_q;
  // hls/stages/patches.hpp:293
  logic equal_1593;
  assign equal_1593 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1661;
  assign select_1661 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1885;
  assign sum_1885 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2398;
  assign select_2398 = slot_s13_q[0] ? 7'h0 : sum_1437_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_2400;
  assign select_2400 = (select_2398 < select_1446_s13_q) ? select_1446_s13_q : select_2398;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2593;
  assign select_2593 = and_2592_s13_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2595;
  assign select_2595 = and_2590_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2593[15]}}, select_2593});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2596;
  assign select_2596 = and_2592_s13_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2596[15]}}, select_2596};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2598;
  assign select_2598 = and_2590_s13_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2599_s13_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:354
  logic and_2701;
  assign and_2701 = not_1589 & equal_1591_s13_q;
  logic [8:0] select_2702;
  assign select_2702 = and_2701 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s13_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2703;
  assign select_2703 = and_2701 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2704;
  assign select_2704 = sample_pair_first_s13_q ? select_2702 : select_2703;
  // hls/stages/patches.hpp:109
  logic [3:0] select_2705;
  assign select_2705 = and_1585_s13_q ? select_2704[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2706;
  assign select_2706 = sample_pair_whole_s13_q ? select_2705 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2708;
  assign select_2708 = sample_pair_whole_s13_q ? (and_1585_s13_q ? select_2704[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2711;
  assign select_2711 = sample_pair_whole_s13_q ? (equal_1593 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2713;
  assign select_2713 = sample_pair_whole_s13_q ? (patches_band_rows_number_q + {4'h0, equal_1593}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:312
  logic equal_2714;
  assign equal_2714 = phase_s13_q == 4'h0;
  // hls/stages/patches.hpp:313
  logic not_2715;
  assign not_2715 = ~equal_2714;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2717;
  assign select_2717 = sample_pair_whole_s13_q ? (phase_s13_q + {{2{not_2715}}, 1'b1, not_2715}) : patches_first_band_rows_to_next_q;
  logic select_2718;
  assign select_2718 = sample_pair_whole_s13_q ? equal_2714 : patches_first_band_number_q;
  // hls/stages/patches.hpp:70
  logic [4:0] select_2729;
  assign select_2729 = equal_2719_s13_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2731;
  assign select_2731 = equal_2287_s13_q ? (select_2729 + {4'h0, equal_2724_s13_q}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2738;
  assign select_2738 = and_503_s13_q ? (equal_2287_s13_q ? select_2729 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3604;
  assign select_3604 = so_s13_q ? (and_2599_s13_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3606;
  assign sum_3606 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3607;
  assign select_3607 = sum_1885[5] ? {1'b1, sum_1885[4:0], region_across_rest_q[2:0]} : sum_3606;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3609;
  assign select_3609 = equal_2287_s13_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3612;
  assign select_3612 = equal_2287_s13_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_near_q <= 7'h0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      patches_band_rows_rows_to_next_q <= 4'h0;
      patches_band_rows_number_q <= 5'h0;
      patches_next_band_rows_to_next_q <= 4'h0;
      patches_next_band_number_q <= 5'h0;
      patches_first_band_rows_to_next_q <= 4'h0;
      patches_first_band_number_q <= 1'b0;
      patches_choosing_number_q <= 5'h0;
      patches_choosing_band_q <= 5'h0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s13_en) begin
      chosen_near_q <= select_2400;
      registration_slope_row_q <= select_2595;
      registration_slope_change_q <= select_2598;
      registration_slope_q <= so_s13_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2706;
      patches_band_rows_number_q <= select_2708;
      patches_next_band_rows_to_next_q <= select_2711;
      patches_next_band_number_q <= select_2713;
      patches_first_band_rows_to_next_q <= select_2717;
      patches_first_band_number_q <= select_2718;
      patches_choosing_number_q <= and_503_s13_q ? select_2731 : patches_choosing_number_q;
      patches_choosing_band_q <= select_2738;
      region_across_rest_q <= select_3604;
      region_across_back_q <= so_s13_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3607;
      columns_begin_rest_q <= and_503_s13_q ? select_3609 : columns_begin_rest_q;
      columns_begin_back_q <= and_503_s13_q ? select_3612 : columns_begin_back_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    middle_sum_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_1_q = 8'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_1_sum_sums_values_1_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s13_en) begin
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_907;
      sums_0_sum_sums_values_0_q <= sum_1157;
      sums_0_sum_sums_values_1_q <= equal_1155_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1405;
      sums_1_sum_sums_values_1_q <= equal_1155_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic [7:0] pixel_0_s14_q;
  logic [7:0] pixel_1_s14_q;
  logic saturated_s14_q;
  logic mask_s14_q;
  logic marks_first_s14_q;
  logic marks_last_s14_q;
  logic sample_pair_whole_s14_q;
  logic sample_present_s14_q;
  logic [5:0] run_shift_s14_q;
  logic [7:0] x_s14_q;
  logic [6:0] last_s14_q;
  logic age_s14_q;
  logic [2:0] slot_s14_q;
  logic ends_cell_s14_q;
  logic lower_half_s14_q;
  logic [11:0] registration_slope_s14_q;
  logic [4:0] patches_band_rows_number_s14_q;
  logic patches_chooses_s14_q;
  logic [4:0] patches_choosing_band_s14_q;
  logic [3:0] select_464_s14_q;
  logic equal_465_s14_q;
  logic [6:0] select_467_s14_q;
  logic [8:0] select_471_s14_q;
  logic and_477_s14_q;
  logic equal_483_s14_q;
  logic [6:0] column_s14_q;
  logic and_501_s14_q;
  logic and_503_s14_q;
  logic so_s14_q;
  logic equal_523_s14_q;
  logic or_524_s14_q;
  logic less_531_s14_q;
  logic not_532_s14_q;
  logic equal_564_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_652_s14_q;
  logic and_657_s14_q;
  logic [7:0] sum_907_s14_q;
  logic less_1406_s14_q;
  logic [6:0] of_near_s14_q;
  logic and_1454_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1463_s14_q;
  logic equal_1472_s14_q;
  logic and_1479_s14_q;
  logic and_1482_s14_q;
  logic and_1486_s14_q;
  logic select_1489_s14_q;
  logic [9:0] sum_1493_s14_q;
  logic or_1500_s14_q;
  logic [6:0] select_1511_s14_q;
  logic and_1585_s14_q;
  logic not_1589_s14_q;
  logic or_1595_s14_q;
  logic less_1612_s14_q;
  logic [16:0] select_1661_s14_q;
  logic sum_1885_s14_q;
  logic and_2017_s14_q;
  logic equal_2163_s14_q;
  logic equal_2287_s14_q;
  logic not_2765_s14_q;
  logic less_3592_s14_q;
  logic equal_3797_s14_q;
  always_ff @(posedge clk_i) begin
    if (s13_en) begin
      pixel_0_s14_q <= pixel_0_s13_q;
      pixel_1_s14_q <= pixel_1_s13_q;
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_whole_s14_q <= sample_pair_whole_s13_q;
      sample_present_s14_q <= sample_present_s13_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      last_s14_q <= last_s13_q;
      age_s14_q <= age_s13_q[1];
      slot_s14_q <= slot_s13_q;
      ends_cell_s14_q <= ends_cell_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      registration_slope_s14_q <= registration_slope_q[27:16];
      patches_band_rows_number_s14_q <= patches_band_rows_number_q;
      patches_chooses_s14_q <= patches_chooses_s13_q;
      patches_choosing_band_s14_q <= patches_choosing_band_q;
      select_464_s14_q <= select_464_s13_q;
      equal_465_s14_q <= equal_465_s13_q;
      select_467_s14_q <= select_467_s13_q;
      select_471_s14_q <= select_471_s13_q;
      and_477_s14_q <= and_477_s13_q;
      equal_483_s14_q <= equal_483_s13_q;
      column_s14_q <= column_s13_q;
      and_501_s14_q <= and_501_s13_q;
      and_503_s14_q <= and_503_s13_q;
      so_s14_q <= so_s13_q;
      equal_523_s14_q <= equal_523_s13_q;
      or_524_s14_q <= or_524_s13_q;
      less_531_s14_q <= less_531_s13_q;
      not_532_s14_q <= not_532_s13_q;
      equal_564_s14_q <= equal_564_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_652_s14_q <= select_652_s13_q;
      and_657_s14_q <= and_657;
      sum_907_s14_q <= sum_907;
      less_1406_s14_q <= sum_1157 < sum_1405;
      of_near_s14_q <= of_near;
      and_1454_s14_q <= and_1454_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1463_s14_q <= select_1463_s13_q;
      equal_1472_s14_q <= equal_1472_s13_q;
      and_1479_s14_q <= and_1479_s13_q;
      and_1482_s14_q <= and_1482_s13_q;
      and_1486_s14_q <= and_1486_s13_q;
      select_1489_s14_q <= select_1489;
      sum_1493_s14_q <= {difference_1492[8], difference_1492} + 10'h1;
      or_1500_s14_q <= or_1500_s13_q;
      select_1511_s14_q <= select_1511_s13_q;
      and_1585_s14_q <= and_1585_s13_q;
      not_1589_s14_q <= not_1589;
      or_1595_s14_q <= (~equal_1591_s13_q) | (~equal_1593);
      less_1612_s14_q <= less_1612_s13_q;
      select_1661_s14_q <= select_1661;
      sum_1885_s14_q <= sum_1885[5];
      and_2017_s14_q <= and_2017_s13_q;
      equal_2163_s14_q <= equal_2163_s13_q;
      equal_2287_s14_q <= equal_2287_s13_q;
      not_2765_s14_q <= not_2765_s13_q;
      less_3592_s14_q <= less_3592_s13_q;
      equal_3797_s14_q <= equal_3797_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [7:0] chosen_score_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  logic patches_capturing_q;
  logic [4:0] patches_row_q;
  logic [2:0] patches_work_q;
  logic patches_second_q;
  logic [2:0] patches_following_q;
  logic [4:0] patches_following_beats_q;
  logic patches_begins_q;
  logic patches_ends_q;
  logic [11:0] patches_remaining_q;
  logic [6:0] patches_step_q;
  // hls/stages/agreement.hpp:739
  logic [7:0] select_908;
  assign select_908 = slot_s14_q[0] ? chosen_score_q : sum_907_s14_q;
  // hls/stages/agreement.hpp:735
  logic [7:0] select_1407;
  assign select_1407 = less_1406_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1408;
  assign less_1408 = select_908 < select_1407;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_657_s14_q ? (less_1408 ? select_1407 : select_908) : 8'h0;
  // hls/stages/agreement.hpp:704
  logic not_1414;
  assign not_1414 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1415;
  assign select_1415 = less_1406_s14_q ? {slot_s14_q[0], not_1414} : 2'h0;
  logic [2:0] select_1417;
  assign select_1417 = less_1408 ? {select_1415, not_1414} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1426;
  assign select_1426 = slot_s14_q[0] ? 8'h0 : sum_907_s14_q;
  // hls/stages/agreement.hpp:788
  logic or_1451;
  assign or_1451 = select_652_s14_q | (best_left_rdata_s14_q[39:33] < of_near_s14_q);
  // hls/stages/agreement.hpp:801
  logic or_1469;
  assign or_1469 = select_1463_s14_q | (best_right_rdata_s14_q[21:15] < of_near_s14_q);
  // hls/stages/agreement.hpp:235
  logic and_1495;
  assign and_1495 = (and_1482_s14_q & select_1489_s14_q) & ({{22{sum_1493_s14_q[9]}}, sum_1493_s14_q} < 32'h3);
  // hls/stages/patches.hpp:373
  logic not_1586;
  assign not_1586 = ~patches_begins_q;
  // hls/stages/patches.hpp:343
  logic and_1590;
  assign and_1590 = patches_capturing_q & not_1589_s14_q;
  // hls/stages/patches.hpp:108
  logic and_1598;
  assign and_1598 = (not_1586 & (patches_work_q == 3'h0)) & (~(and_1590 | or_1595_s14_q));
  // hls/stages/registration.hpp:218
  logic [13:0] select_1663;
  assign select_1663 = ($signed(10'h0) < $signed(select_1661_s14_q[16:7])) ? 14'h7f : select_1661_s14_q[13:0];
  // hls/stages/patches.hpp:511
  logic equal_1693;
  assign equal_1693 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:482
  logic equal_1695;
  assign equal_1695 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:476
  logic equal_1697;
  assign equal_1697 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:150
  logic equal_1698;
  assign equal_1698 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:511
  logic or_1699;
  assign or_1699 = equal_1697 | equal_1698;
  // hls/stages/patches.hpp:437
  logic not_1700;
  assign not_1700 = ~patches_second_q;
  // hls/stages/patches.hpp:354
  logic [4:0] select_1722;
  assign select_1722 = and_1598 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:109
  logic [4:0] select_1723;
  assign select_1723 = and_1585_s14_q ? select_1722 : patches_row_q;
  // hls/stages/patches.hpp:108
  logic and_1725;
  assign and_1725 = and_1590 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:109
  logic select_1729;
  assign select_1729 = and_1585_s14_q ? (and_1598 | (and_1590 & (~and_1725))) : patches_capturing_q;
  // hls/stages/patches.hpp:150
  logic not_1754;
  assign not_1754 = ~equal_1698;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1768;
  assign select_1768 = and_1585_s14_q ? {select_1722[4], select_1722[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:523
  logic less_1854;
  assign less_1854 = patches_step_q[4:0] < 5'h11;
  logic equal_1855;
  assign equal_1855 = patches_step_q[6:5] == 2'h0;
  logic not_1856;
  assign not_1856 = ~equal_1855;
  logic equal_1857;
  assign equal_1857 = patches_step_q[6:5] == 2'h3;
  logic not_1858;
  assign not_1858 = ~equal_1857;
  // hls/stages/patches.hpp:537
  logic select_1861;
  assign select_1861 = equal_1857 ? (less_1854 & (less_1854 & not_1858)) : less_1854;
  // hls/stages/agreement.hpp:735
  logic less_2396;
  assign less_2396 = select_1426 < select_1407;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2491;
  assign select_2491 = or_524_s14_q ? (less_531_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2493;
  assign select_2493 = or_524_s14_q ? (less_531_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:374
  logic or_2806;
  assign or_2806 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:376
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:170
  logic and_2812;
  assign and_2812 = equal_1693 & not_1700;
  // hls/stages/patches.hpp:380
  logic and_2813;
  assign and_2813 = not_1754 & and_2812;
  logic [1:0] select_2815;
  assign select_2815 = equal_1695 ? 2'h0 : (equal_1697 ? 2'h3 : {equal_1698, and_2813});
  // hls/stages/patches.hpp:261
  logic equal_2817;
  assign equal_2817 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:259
  logic not_2818;
  assign not_2818 = ~equal_2817;
  // hls/stages/patches.hpp:261
  logic equal_2819;
  assign equal_2819 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:257
  logic not_2820;
  assign not_2820 = ~equal_2819;
  // hls/stages/patches.hpp:265
  logic not_2822;
  assign not_2822 = ~(patches_following_q == 3'h2);
  logic and_2825;
  assign and_2825 = (~(patches_following_q == 3'h1)) & not_2822;
  // hls/stages/patches.hpp:378
  logic [1:0] select_2826;
  assign select_2826 = equal_2819 ? 2'h2 : {and_2825, not_2822};
  logic [3:0] select_2827;
  assign select_2827 = equal_2817 ? 4'h2 : {select_2826, {2{not_2820}}};
  // hls/stages/patches.hpp:386
  logic not_2830;
  assign not_2830 = ~or_2806;
  // hls/stages/patches.hpp:375
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:387
  logic [11:0] select_2835;
  assign select_2835 = or_2806 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_score_q <= 8'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      patches_capturing_q <= 1'b0;
      patches_row_q <= 5'h0;
      patches_work_q <= 3'h0;
      patches_second_q <= 1'b0;
      patches_following_q <= 3'h0;
      patches_following_beats_q <= 5'h0;
      patches_begins_q <= 1'b0;
      patches_ends_q <= 1'b0;
      patches_remaining_q <= 12'h0;
      patches_step_q <= 7'h0;
    end else if (s14_en) begin
      chosen_score_q <= less_2396 ? select_1407 : select_1426;
      chosen_place_q <= less_2396 ? {select_1415, not_1414} : 3'h2;
      before_0_q <= select_1426;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      patches_capturing_q <= sample_pair_whole_s14_q ? select_1729 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s14_q ? select_1723 : patches_row_q;
      patches_work_q <= or_2806 ? following : patches_work_q;
      patches_second_q <= not_1586 & (patches_second_q | (patches_ends_q & equal_1693));
      patches_following_q <= equal_1693 ? {2'h0, and_2812} : {equal_1695, select_2815};
      patches_following_beats_q <= {select_2827, not_2818};
      patches_begins_q <= sample_pair_whole_s14_q & (and_1585_s14_q & and_1725);
      patches_ends_q <= not_2830 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2835;
      patches_step_q <= or_2806 ? 7'h0 : (patches_step_q + 7'h1);
    end
  end

  logic [7:0] pixel_0_s15_q;
  logic [7:0] pixel_1_s15_q;
  logic saturated_s15_q;
  logic mask_s15_q;
  logic marks_first_s15_q;
  logic marks_last_s15_q;
  logic sample_pair_whole_s15_q;
  logic sample_present_s15_q;
  logic [5:0] run_shift_s15_q;
  logic [7:0] x_s15_q;
  logic [6:0] last_s15_q;
  logic age_s15_q;
  logic [2:0] slot_s15_q;
  logic ends_cell_s15_q;
  logic lower_half_s15_q;
  logic [7:0] before_0_s15_q;
  logic [7:0] before_1_s15_q;
  logic [7:0] before_2_s15_q;
  logic [11:0] registration_slope_s15_q;
  logic [4:0] patches_band_rows_number_s15_q;
  logic patches_chooses_s15_q;
  logic [4:0] patches_choosing_band_s15_q;
  logic patches_second_s15_q;
  logic [4:0] patches_step_s15_q;
  logic [3:0] select_464_s15_q;
  logic equal_465_s15_q;
  logic [6:0] select_467_s15_q;
  logic [8:0] select_471_s15_q;
  logic and_477_s15_q;
  logic equal_483_s15_q;
  logic [6:0] column_s15_q;
  logic and_501_s15_q;
  logic and_503_s15_q;
  logic so_s15_q;
  logic equal_523_s15_q;
  logic or_524_s15_q;
  logic less_531_s15_q;
  logic not_532_s15_q;
  logic equal_564_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_652_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1417_s15_q;
  logic [6:0] of_near_s15_q;
  logic or_1451_s15_q;
  logic and_1454_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1463_s15_q;
  logic or_1469_s15_q;
  logic equal_1472_s15_q;
  logic and_1479_s15_q;
  logic and_1483_s15_q;
  logic and_1486_s15_q;
  logic and_1496_s15_q;
  logic and_1501_s15_q;
  logic [8:0] select_1503_s15_q;
  logic [6:0] select_1511_s15_q;
  logic and_1585_s15_q;
  logic and_1598_s15_q;
  logic less_1612_s15_q;
  logic [13:0] select_1663_s15_q;
  logic equal_1693_s15_q;
  logic equal_1695_s15_q;
  logic equal_1697_s15_q;
  logic equal_1698_s15_q;
  logic or_1699_s15_q;
  logic and_1702_s15_q;
  logic [4:0] select_1723_s15_q;
  logic select_1729_s15_q;
  logic and_1735_s15_q;
  logic and_1755_s15_q;
  logic [3:0] select_1768_s15_q;
  logic less_1854_s15_q;
  logic equal_1855_s15_q;
  logic not_1856_s15_q;
  logic equal_1857_s15_q;
  logic not_1858_s15_q;
  logic select_1861_s15_q;
  logic and_1862_s15_q;
  logic sum_1885_s15_q;
  logic and_2017_s15_q;
  logic equal_2163_s15_q;
  logic equal_2287_s15_q;
  logic [7:0] select_2491_s15_q;
  logic [7:0] select_2493_s15_q;
  logic not_2765_s15_q;
  logic or_2806_s15_q;
  logic not_2830_s15_q;
  logic and_3302_s15_q;
  logic equal_3309_s15_q;
  logic less_3592_s15_q;
  logic equal_3797_s15_q;
  always_ff @(posedge clk_i) begin
    if (s14_en) begin
      pixel_0_s15_q <= pixel_0_s14_q;
      pixel_1_s15_q <= pixel_1_s14_q;
      saturated_s15_q <= saturated_s14_q;
      mask_s15_q <= mask_s14_q;
      marks_first_s15_q <= marks_first_s14_q;
      marks_last_s15_q <= marks_last_s14_q;
      sample_pair_whole_s15_q <= sample_pair_whole_s14_q;
      sample_present_s15_q <= sample_present_s14_q;
      run_shift_s15_q <= run_shift_s14_q;
      x_s15_q <= x_s14_q;
      last_s15_q <= last_s14_q;
      age_s15_q <= age_s14_q;
      slot_s15_q <= slot_s14_q;
      ends_cell_s15_q <= ends_cell_s14_q;
      lower_half_s15_q <= lower_half_s14_q;
      before_0_s15_q <= before_0_q;
      before_1_s15_q <= before_1_q;
      before_2_s15_q <= before_2_q;
      registration_slope_s15_q <= registration_slope_s14_q;
      patches_band_rows_number_s15_q <= patches_band_rows_number_s14_q;
      patches_chooses_s15_q <= patches_chooses_s14_q;
      patches_choosing_band_s15_q <= patches_choosing_band_s14_q;
      patches_second_s15_q <= patches_second_q;
      patches_step_s15_q <= patches_step_q[4:0];
      select_464_s15_q <= select_464_s14_q;
      equal_465_s15_q <= equal_465_s14_q;
      select_467_s15_q <= select_467_s14_q;
      select_471_s15_q <= select_471_s14_q;
      and_477_s15_q <= and_477_s14_q;
      equal_483_s15_q <= equal_483_s14_q;
      column_s15_q <= column_s14_q;
      and_501_s15_q <= and_501_s14_q;
      and_503_s15_q <= and_503_s14_q;
      so_s15_q <= so_s14_q;
      equal_523_s15_q <= equal_523_s14_q;
      or_524_s15_q <= or_524_s14_q;
      less_531_s15_q <= less_531_s14_q;
      not_532_s15_q <= not_532_s14_q;
      equal_564_s15_q <= equal_564_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_652_s15_q <= select_652_s14_q;
      of_best_s15_q <= of_best;
      select_1417_s15_q <= select_1417;
      of_near_s15_q <= of_near_s14_q;
      or_1451_s15_q <= or_1451;
      and_1454_s15_q <= and_1454_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1463_s15_q <= select_1463_s14_q;
      or_1469_s15_q <= or_1469;
      equal_1472_s15_q <= equal_1472_s14_q;
      and_1479_s15_q <= and_1479_s14_q;
      and_1483_s15_q <= not_532_s14_q & and_1482_s14_q;
      and_1486_s15_q <= and_1486_s14_q;
      and_1496_s15_q <= not_532_s14_q & and_1495;
      and_1501_s15_q <= and_1495 & or_1500_s14_q;
      select_1503_s15_q <= less_531_s14_q ? 9'h0 : best_left_rdata_s14_q[8:0];
      select_1511_s15_q <= select_1511_s14_q;
      and_1585_s15_q <= and_1585_s14_q;
      and_1598_s15_q <= and_1598;
      less_1612_s15_q <= less_1612_s14_q;
      select_1663_s15_q <= select_1663;
      equal_1693_s15_q <= equal_1693;
      equal_1695_s15_q <= equal_1695;
      equal_1697_s15_q <= equal_1697;
      equal_1698_s15_q <= equal_1698;
      or_1699_s15_q <= or_1699;
      and_1702_s15_q <= or_1699 & (equal_1698 & not_1700);
      select_1723_s15_q <= select_1723;
      select_1729_s15_q <= select_1729;
      and_1735_s15_q <= or_1699 & (patches_second_q & equal_1698);
      and_1755_s15_q <= not_1754 & or_1699;
      select_1768_s15_q <= select_1768;
      less_1854_s15_q <= less_1854;
      equal_1855_s15_q <= equal_1855;
      not_1856_s15_q <= not_1856;
      equal_1857_s15_q <= equal_1857;
      not_1858_s15_q <= not_1858;
      select_1861_s15_q <= select_1861;
      and_1862_s15_q <= not_1856 & select_1861;
      sum_1885_s15_q <= sum_1885_s14_q;
      and_2017_s15_q <= and_2017_s14_q;
      equal_2163_s15_q <= equal_2163_s14_q;
      equal_2287_s15_q <= equal_2287_s14_q;
      select_2491_s15_q <= select_2491;
      select_2493_s15_q <= select_2493;
      not_2765_s15_q <= not_2765_s14_q;
      or_2806_s15_q <= or_2806;
      not_2830_s15_q <= not_2830;
      and_3302_s15_q <= less_1854 & (patches_step_q[6:5] == 2'h1);
      equal_3309_s15_q <= patches_step_q[6:5] == 2'h2;
      less_3592_s15_q <= less_3592_s14_q;
      equal_3797_s15_q <= equal_3797_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [15:0] patches_chance_q;
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:785
  logic equal_1420;
  assign equal_1420 = select_1417_s15_q == 3'h1;
  logic equal_1421;
  assign equal_1421 = select_1417_s15_q == 3'h2;
  logic not_1422;
  assign not_1422 = ~equal_1421;
  logic [2:0] select_1423;
  assign select_1423 = equal_1420 ? 3'h2 : {not_1422, {2{equal_1421}}};
  logic [7:0] select_1428;
  assign select_1428 = select_1423[1] ? (select_1423[0] ? before_1_s15_q : before_1_q) : (select_1423[0] ? before_1_q : before_0_q);
  logic [7:0] select_1429;
  assign select_1429 = select_1423[2] ? (select_1423[0] ? before_2_s15_q : before_0_s15_q) : select_1428;
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1431;
  assign select_1431 = equal_1420 ? 2'h0 : {not_1422, equal_1421};
  logic [7:0] select_1433;
  assign select_1433 = select_1431[1] ? before_2_q : (select_1431[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:797
  logic or_1465;
  assign or_1465 = select_1463_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:235
  logic and_1502;
  assign and_1502 = not_532_s15_q & and_1501_s15_q;
  // hls/stages/agreement.hpp:141
  logic [14:0] shift_2;
  assign shift_2 = or_524_s15_q ? {select_1503_s15_q, and_1502, and_1496_s15_q, and_1486_s15_q, and_1483_s15_q, and_1479_s15_q, not_532_s15_q} : 15'h0;
  // hls/stages/patches.hpp:86
  logic right_3;
  assign right_3 = {2'h0, last_s15_q[6:1]} < x_s15_q;
  // hls/stages/registration.hpp:213
  logic [9:0] select_1664;
  assign select_1664 = shift_2[10] ? select_1663_s15_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1669;
  assign sum_1669 = (shift_2[6] ? select_1663_s15_q[13:1] : 13'h0) + (shift_2[7] ? select_1663_s15_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1670;
  assign select_1670 = shift_2[8] ? select_1663_s15_q[11:0] : 12'h0;
  logic [10:0] sum_1672;
  assign sum_1672 = select_1670[11:1] + (shift_2[9] ? select_1663_s15_q[10:0] : 11'h0);
  // hls/stages/patches.hpp:489
  logic not_1694;
  assign not_1694 = ~equal_1693_s15_q;
  // hls/stages/patches.hpp:435
  logic not_1696;
  assign not_1696 = ~equal_1695_s15_q;
  logic and_1778;
  assign and_1778 = not_1694 & (or_1699_s15_q & not_1696);
  // hls/stages/patches.hpp:167
  logic and_1864;
  assign and_1864 = equal_1693_s15_q & (less_1854_s15_q ? and_1862_s15_q : select_1861_s15_q);
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2489;
  assign select_2489 = or_524_s15_q ? (less_531_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2491_s15_q} - {1'b0, select_2493_s15_q};
  // hls/stages/patches.hpp:74
  logic parity_2742;
  assign parity_2742 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2743;
  assign select_2743 = equal_2287_s15_q ? {patches_chance_q[14:0], parity_2742} : patches_chance_q;
  // hls/stages/patches.hpp:91
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:92
  logic [5:0] further;
  assign further = last_s15_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:109
  logic select_2767;
  assign select_2767 = and_1585_s15_q ? (and_1598_s15_q ? not_2765_s15_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:170
  logic [4:0] select_2837;
  assign select_2837 = or_2806_s15_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:534
  logic select_3304;
  assign select_3304 = less_1854_s15_q ? (not_1858_s15_q & and_3302_s15_q) : and_3302_s15_q;
  // hls/stages/patches.hpp:537
  logic select_3305;
  assign select_3305 = equal_1857_s15_q ? select_3304 : and_3302_s15_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:740; read in stage 15, written in stage 28: 15 < 28 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s15_en & (not_1694 & (not_1696 & and_1702_s15_q));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:740; read in stage 15, written in stage 28: 15 < 28 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s15_en & (not_1694 & (not_1696 & and_1735_s15_q));
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:752; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
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
  assign patches_columns_above_re = s15_en & and_1778;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:772; read in stage 15, written in stage 29: 15 < 29 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_s15_q;
  logic patches_rows_re;
  assign patches_rows_re = s15_en & and_1864;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_chance_q <= 16'h1;
      patches_lower_q <= 1'b0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
    end else if (s15_en) begin
      patches_chance_q <= and_503_s15_q ? select_2743 : patches_chance_q;
      patches_lower_q <= sample_pair_whole_s15_q ? select_2767 : patches_lower_q;
      patches_code_row_q <= select_2837;
      patches_column_q <= or_2806_s15_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2830_s15_q & (patches_column_q == 5'h1e);
    end
  end

  logic [7:0] pixel_0_s16_q;
  logic [7:0] pixel_1_s16_q;
  logic saturated_s16_q;
  logic mask_s16_q;
  logic marks_first_s16_q;
  logic marks_last_s16_q;
  logic sample_pair_whole_s16_q;
  logic sample_present_s16_q;
  logic [5:0] run_shift_s16_q;
  logic [7:0] x_s16_q;
  logic [6:0] last_s16_q;
  logic age_s16_q;
  logic [2:0] slot_s16_q;
  logic ends_cell_s16_q;
  logic lower_half_s16_q;
  logic [11:0] registration_slope_s16_q;
  logic [4:0] patches_band_rows_number_s16_q;
  logic patches_chooses_s16_q;
  logic [4:0] patches_choosing_band_s16_q;
  logic patches_lower_s16_q;
  logic patches_second_s16_q;
  logic [4:0] patches_code_row_s16_q;
  logic [4:0] patches_column_s16_q;
  logic [4:0] patches_step_s16_q;
  logic [3:0] select_464_s16_q;
  logic equal_465_s16_q;
  logic [6:0] select_467_s16_q;
  logic [8:0] select_471_s16_q;
  logic and_477_s16_q;
  logic equal_483_s16_q;
  logic [6:0] column_s16_q;
  logic and_501_s16_q;
  logic and_503_s16_q;
  logic so_s16_q;
  logic equal_564_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1412_s16_q;
  logic [2:0] select_1417_s16_q;
  logic [7:0] select_1429_s16_q;
  logic [7:0] select_1433_s16_q;
  logic [6:0] select_1452_s16_q;
  logic [5:0] select_1453_s16_q;
  logic and_1454_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1465_s16_q;
  logic [6:0] select_1470_s16_q;
  logic [6:0] select_1471_s16_q;
  logic equal_1472_s16_q;
  logic [13:0] shift_2_s16_q;
  logic [6:0] select_1511_s16_q;
  logic and_1514_s16_q;
  logic and_1585_s16_q;
  logic and_1598_s16_q;
  logic right_3_s16_q;
  logic less_1612_s16_q;
  logic select_1664_s16_q;
  logic [8:0] difference_1666_s16_q;
  logic [11:0] sum_1669_s16_q;
  logic select_1670_s16_q;
  logic [10:0] sum_1672_s16_q;
  logic equal_1693_s16_q;
  logic not_1694_s16_q;
  logic equal_1695_s16_q;
  logic not_1696_s16_q;
  logic equal_1697_s16_q;
  logic equal_1698_s16_q;
  logic or_1699_s16_q;
  logic [4:0] select_1723_s16_q;
  logic select_1729_s16_q;
  logic and_1757_s16_q;
  logic [3:0] select_1768_s16_q;
  logic and_1778_s16_q;
  logic less_1854_s16_q;
  logic equal_1855_s16_q;
  logic not_1856_s16_q;
  logic equal_1857_s16_q;
  logic not_1858_s16_q;
  logic sum_1885_s16_q;
  logic textured_s16_q;
  logic and_2017_s16_q;
  logic equal_2163_s16_q;
  logic equal_2287_s16_q;
  logic [7:0] select_2489_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2495_s16_q;
  logic [7:0] xor_2500_s16_q;
  logic less_2524_s16_q;
  logic [5:0] further_s16_q;
  logic or_2806_s16_q;
  logic not_2830_s16_q;
  logic select_3307_s16_q;
  logic equal_3309_s16_q;
  logic less_3592_s16_q;
  logic equal_3797_s16_q;
  always_ff @(posedge clk_i) begin
    if (s15_en) begin
      pixel_0_s16_q <= pixel_0_s15_q;
      pixel_1_s16_q <= pixel_1_s15_q;
      saturated_s16_q <= saturated_s15_q;
      mask_s16_q <= mask_s15_q;
      marks_first_s16_q <= marks_first_s15_q;
      marks_last_s16_q <= marks_last_s15_q;
      sample_pair_whole_s16_q <= sample_pair_whole_s15_q;
      sample_present_s16_q <= sample_present_s15_q;
      run_shift_s16_q <= run_shift_s15_q;
      x_s16_q <= x_s15_q;
      last_s16_q <= last_s15_q;
      age_s16_q <= age_s15_q;
      slot_s16_q <= slot_s15_q;
      ends_cell_s16_q <= ends_cell_s15_q;
      lower_half_s16_q <= lower_half_s15_q;
      registration_slope_s16_q <= registration_slope_s15_q;
      patches_band_rows_number_s16_q <= patches_band_rows_number_s15_q;
      patches_chooses_s16_q <= patches_chooses_s15_q;
      patches_choosing_band_s16_q <= patches_choosing_band_s15_q;
      patches_lower_s16_q <= patches_lower_q;
      patches_second_s16_q <= patches_second_s15_q;
      patches_code_row_s16_q <= patches_code_row_q;
      patches_column_s16_q <= patches_column_q;
      patches_step_s16_q <= patches_step_s15_q;
      select_464_s16_q <= select_464_s15_q;
      equal_465_s16_q <= equal_465_s15_q;
      select_467_s16_q <= select_467_s15_q;
      select_471_s16_q <= select_471_s15_q;
      and_477_s16_q <= and_477_s15_q;
      equal_483_s16_q <= equal_483_s15_q;
      column_s16_q <= column_s15_q;
      and_501_s16_q <= and_501_s15_q;
      and_503_s16_q <= and_503_s15_q;
      so_s16_q <= so_s15_q;
      equal_564_s16_q <= equal_564_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1412_s16_q <= select_652_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1417_s16_q <= select_1417_s15_q;
      select_1429_s16_q <= select_1429;
      select_1433_s16_q <= select_1433;
      select_1452_s16_q <= or_1451_s15_q ? of_near_s15_q : best_left_rdata_s15_q[39:33];
      select_1453_s16_q <= or_1451_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      and_1454_s16_q <= and_1454_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1465_s16_q <= or_1465;
      select_1470_s16_q <= or_1469_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1471_s16_q <= or_1469_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1472_s16_q <= equal_1472_s15_q;
      shift_2_s16_q <= {shift_2[14:3], shift_2[1:0]};
      select_1511_s16_q <= select_1511_s15_q;
      and_1514_s16_q <= equal_523_s15_q & shift_2[4];
      and_1585_s16_q <= and_1585_s15_q;
      and_1598_s16_q <= and_1598_s15_q;
      right_3_s16_q <= right_3;
      less_1612_s16_q <= less_1612_s15_q;
      select_1664_s16_q <= select_1664[0];
      difference_1666_s16_q <= select_1664[9:1] - (shift_2[11] ? select_1663_s15_q[8:0] : 9'h0);
      sum_1669_s16_q <= sum_1669[12:1];
      select_1670_s16_q <= select_1670[0];
      sum_1672_s16_q <= sum_1672;
      equal_1693_s16_q <= equal_1693_s15_q;
      not_1694_s16_q <= not_1694;
      equal_1695_s16_q <= equal_1695_s15_q;
      not_1696_s16_q <= not_1696;
      equal_1697_s16_q <= equal_1697_s15_q;
      equal_1698_s16_q <= equal_1698_s15_q;
      or_1699_s16_q <= or_1699_s15_q;
      select_1723_s16_q <= select_1723_s15_q;
      select_1729_s16_q <= select_1729_s15_q;
      and_1757_s16_q <= not_1694 & (not_1696 & and_1755_s15_q);
      select_1768_s16_q <= select_1768_s15_q;
      and_1778_s16_q <= and_1778;
      less_1854_s16_q <= less_1854_s15_q;
      equal_1855_s16_q <= equal_1855_s15_q;
      not_1856_s16_q <= not_1856_s15_q;
      equal_1857_s16_q <= equal_1857_s15_q;
      not_1858_s16_q <= not_1858_s15_q;
      sum_1885_s16_q <= sum_1885_s15_q;
      textured_s16_q <= textured;
      and_2017_s16_q <= and_2017_s15_q;
      equal_2163_s16_q <= equal_2163_s15_q;
      equal_2287_s16_q <= equal_2287_s15_q;
      select_2489_s16_q <= select_2489;
      rise_s16_q <= rise[8];
      select_2495_s16_q <= rise[8] ? select_2491_s15_q : select_2493_s15_q;
      xor_2500_s16_q <= rise[7:0] ^ {8{rise[8]}};
      less_2524_s16_q <= select_2491_s15_q < select_2493_s15_q;
      further_s16_q <= further;
      or_2806_s16_q <= or_2806_s15_q;
      not_2830_s16_q <= not_2830_s15_q;
      select_3307_s16_q <= less_1854_s15_q ? (not_1856_s15_q & select_3305) : select_3305;
      equal_3309_s16_q <= equal_3309_s15_q;
      less_3592_s16_q <= less_3592_s15_q;
      equal_3797_s16_q <= equal_3797_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/agreement.hpp:955
  logic not_1473;
  assign not_1473 = ~equal_1472_s16_q;
  // hls/stages/patches.hpp:321
  logic and_1505;
  assign and_1505 = ends_cell_s16_q & shift_2_s16_q[0];
  logic and_1507;
  assign and_1507 = not_1473 & (so_s16_q & and_1505);
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_1557;
  assign sum_1557 = {1'b0, last_s16_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s16_q[0] & ({1'b0, sum_1557, last_s16_q[1]} < x_s16_q);
  // hls/stages/patches.hpp:85
  logic [9:0] sum_1640;
  assign sum_1640 = {2'h0, x_s16_q} + {{4{shift_2_s16_q[10]}}, shift_2_s16_q[10:5]};
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1673;
  assign sum_1673 = sum_1669_s16_q + {sum_1672_s16_q, select_1670_s16_q};
  logic [9:0] sum_1674;
  assign sum_1674 = {difference_1666_s16_q, select_1664_s16_q} + sum_1673[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2496;
  assign difference_2496 = {1'b0, select_2489_s16_q} - {1'b0, select_2495_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2496[8] ? 8'h0 : difference_2496[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2500_s16_q};
  // hls/stages/patches.hpp:93
  logic [5:0] select_2748;
  assign select_2748 = right_3_s16_q ? last_s16_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s16_q} + {1'b0, select_2748};

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1299; read in stage 16, written in stage 17: 16 < 17 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s16_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s16_en & and_1507;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:741; read in stage 16, written in stage 27: 16 < 27 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s16_q, patches_code_row_s16_q[3:0], patches_column_s16_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s16_en & and_1757_s16_q;
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1326; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s16_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s16_en & and_1507;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s16_en) begin
      patches_read_searches_q <= equal_1693_s16_q ? select_3307_s16_q : patches_read_searches_q;
    end
  end

  logic [7:0] pixel_0_s17_q;
  logic [7:0] pixel_1_s17_q;
  logic saturated_s17_q;
  logic mask_s17_q;
  logic marks_first_s17_q;
  logic marks_last_s17_q;
  logic sample_pair_whole_s17_q;
  logic sample_present_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic [2:0] slot_s17_q;
  logic ends_cell_s17_q;
  logic lower_half_s17_q;
  logic [11:0] registration_slope_s17_q;
  logic [4:0] patches_band_rows_number_s17_q;
  logic patches_chooses_s17_q;
  logic [4:0] patches_choosing_band_s17_q;
  logic patches_lower_s17_q;
  logic patches_second_s17_q;
  logic [4:0] patches_code_row_s17_q;
  logic [4:0] patches_column_s17_q;
  logic [4:0] patches_step_s17_q;
  logic patches_read_searches_s17_q;
  logic [3:0] select_464_s17_q;
  logic equal_465_s17_q;
  logic [6:0] select_467_s17_q;
  logic [8:0] select_471_s17_q;
  logic and_477_s17_q;
  logic equal_483_s17_q;
  logic [6:0] column_s17_q;
  logic and_501_s17_q;
  logic and_503_s17_q;
  logic so_s17_q;
  logic equal_564_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1413_s17_q;
  logic [2:0] select_1418_s17_q;
  logic [7:0] select_1419_s17_q;
  logic [7:0] select_1430_s17_q;
  logic [7:0] select_1434_s17_q;
  logic [6:0] select_1452_s17_q;
  logic [5:0] select_1453_s17_q;
  logic and_1454_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1466_s17_q;
  logic [6:0] select_1467_s17_q;
  logic [6:0] select_1470_s17_q;
  logic [6:0] select_1471_s17_q;
  logic equal_1472_s17_q;
  logic not_1473_s17_q;
  logic [13:0] shift_2_s17_q;
  logic and_1507_s17_q;
  logic [6:0] select_1511_s17_q;
  logic and_1516_s17_q;
  logic right_2_s17_q;
  logic and_1585_s17_q;
  logic and_1598_s17_q;
  logic right_3_s17_q;
  logic less_1612_s17_q;
  logic less_1631_s17_q;
  logic not_1636_s17_q;
  logic less_1641_s17_q;
  logic less_1642_s17_q;
  logic [7:0] sum_1674_s17_q;
  logic equal_1686_s17_q;
  logic equal_1693_s17_q;
  logic not_1694_s17_q;
  logic equal_1695_s17_q;
  logic not_1696_s17_q;
  logic equal_1697_s17_q;
  logic equal_1698_s17_q;
  logic or_1699_s17_q;
  logic [7:0] patches_right_0_rdata_s17_q;
  logic [4:0] select_1723_s17_q;
  logic select_1729_s17_q;
  logic [7:0] patches_right_1_rdata_s17_q;
  logic [3:0] select_1768_s17_q;
  logic and_1778_s17_q;
  logic [31:0] patches_columns_above_rdata_s17_q;
  logic less_1854_s17_q;
  logic equal_1855_s17_q;
  logic not_1856_s17_q;
  logic equal_1857_s17_q;
  logic not_1858_s17_q;
  logic [14:0] patches_rows_rdata_s17_q;
  logic sum_1885_s17_q;
  logic textured_s17_q;
  logic and_2020_s17_q;
  logic equal_2163_s17_q;
  logic equal_2287_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] size_3_s17_q;
  logic less_2524_s17_q;
  logic not_2751_s17_q;
  logic or_2806_s17_q;
  logic not_2830_s17_q;
  logic equal_3309_s17_q;
  logic less_3592_s17_q;
  logic equal_3797_s17_q;
  always_ff @(posedge clk_i) begin
    if (s16_en) begin
      pixel_0_s17_q <= pixel_0_s16_q;
      pixel_1_s17_q <= pixel_1_s16_q;
      saturated_s17_q <= saturated_s16_q;
      mask_s17_q <= mask_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      sample_pair_whole_s17_q <= sample_pair_whole_s16_q;
      sample_present_s17_q <= sample_present_s16_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      slot_s17_q <= slot_s16_q;
      ends_cell_s17_q <= ends_cell_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      registration_slope_s17_q <= registration_slope_s16_q;
      patches_band_rows_number_s17_q <= patches_band_rows_number_s16_q;
      patches_chooses_s17_q <= patches_chooses_s16_q;
      patches_choosing_band_s17_q <= patches_choosing_band_s16_q;
      patches_lower_s17_q <= patches_lower_s16_q;
      patches_second_s17_q <= patches_second_s16_q;
      patches_code_row_s17_q <= patches_code_row_s16_q;
      patches_column_s17_q <= patches_column_s16_q;
      patches_step_s17_q <= patches_step_s16_q;
      patches_read_searches_s17_q <= patches_read_searches_q;
      select_464_s17_q <= select_464_s16_q;
      equal_465_s17_q <= equal_465_s16_q;
      select_467_s17_q <= select_467_s16_q;
      select_471_s17_q <= select_471_s16_q;
      and_477_s17_q <= and_477_s16_q;
      equal_483_s17_q <= equal_483_s16_q;
      column_s17_q <= column_s16_q;
      and_501_s17_q <= and_501_s16_q;
      and_503_s17_q <= and_503_s16_q;
      so_s17_q <= so_s16_q;
      equal_564_s17_q <= equal_564_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1413_s17_q <= or_1412_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1418_s17_q <= or_1412_s16_q ? select_1417_s16_q : best_left_rdata_s16_q[8:6];
      select_1419_s17_q <= or_1412_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1430_s17_q <= or_1412_s16_q ? select_1429_s16_q : best_left_rdata_s16_q[24:17];
      select_1434_s17_q <= or_1412_s16_q ? select_1433_s16_q : best_left_rdata_s16_q[32:25];
      select_1452_s17_q <= select_1452_s16_q;
      select_1453_s17_q <= select_1453_s16_q;
      and_1454_s17_q <= and_1454_s16_q;
      right_s17_q <= right_s16_q;
      select_1466_s17_q <= or_1465_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1467_s17_q <= or_1465_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1470_s17_q <= select_1470_s16_q;
      select_1471_s17_q <= select_1471_s16_q;
      equal_1472_s17_q <= equal_1472_s16_q;
      not_1473_s17_q <= not_1473;
      shift_2_s17_q <= shift_2_s16_q;
      and_1507_s17_q <= and_1507;
      select_1511_s17_q <= select_1511_s16_q;
      and_1516_s17_q <= not_1473 & (so_s16_q ? and_1505 : and_1514_s16_q);
      right_2_s17_q <= right_2;
      and_1585_s17_q <= and_1585_s16_q;
      and_1598_s17_q <= and_1598_s16_q;
      right_3_s17_q <= right_3_s16_q;
      less_1612_s17_q <= less_1612_s16_q;
      less_1631_s17_q <= {3'h0, last_s16_q[6:1]} < ({1'b0, x_s16_q} + 9'h1);
      not_1636_s17_q <= ~(x_s16_q < {1'b0, last_s16_q});
      less_1641_s17_q <= $signed(10'h0) < $signed(sum_1640);
      less_1642_s17_q <= $signed(sum_1640) < $signed({3'h0, last_s16_q});
      sum_1674_s17_q <= sum_1674[9:2];
      equal_1686_s17_q <= x_s16_q == {1'b0, last_s16_q};
      equal_1693_s17_q <= equal_1693_s16_q;
      not_1694_s17_q <= not_1694_s16_q;
      equal_1695_s17_q <= equal_1695_s16_q;
      not_1696_s17_q <= not_1696_s16_q;
      equal_1697_s17_q <= equal_1697_s16_q;
      equal_1698_s17_q <= equal_1698_s16_q;
      or_1699_s17_q <= or_1699_s16_q;
      patches_right_0_rdata_s17_q <= patches_right_0_rdata_q;
      select_1723_s17_q <= select_1723_s16_q;
      select_1729_s17_q <= select_1729_s16_q;
      patches_right_1_rdata_s17_q <= patches_right_1_rdata_q;
      select_1768_s17_q <= select_1768_s16_q;
      and_1778_s17_q <= and_1778_s16_q;
      patches_columns_above_rdata_s17_q <= patches_columns_above_rdata_q;
      less_1854_s17_q <= less_1854_s16_q;
      equal_1855_s17_q <= equal_1855_s16_q;
      not_1856_s17_q <= not_1856_s16_q;
      equal_1857_s17_q <= equal_1857_s16_q;
      not_1858_s17_q <= not_1858_s16_q;
      patches_rows_rdata_s17_q <= patches_rows_rdata_q;
      sum_1885_s17_q <= sum_1885_s16_q;
      textured_s17_q <= textured_s16_q;
      and_2020_s17_q <= and_2017_s16_q & (~({sum_1557, last_s16_q[1:0]} < x_s16_q));
      equal_2163_s17_q <= equal_2163_s16_q;
      equal_2287_s17_q <= equal_2287_s16_q;
      wide_s17_q <= wide;
      size_3_s17_q <= size_3;
      less_2524_s17_q <= less_2524_s16_q;
      not_2751_s17_q <= ~(x_s16_q < {1'b0, from});
      or_2806_s17_q <= or_2806_s16_q;
      not_2830_s17_q <= not_2830_s16_q;
      equal_3309_s17_q <= equal_3309_s16_q;
      less_3592_s17_q <= less_3592_s16_q;
      equal_3797_s17_q <= equal_3797_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:119
  logic and_478;
  assign and_478 = sample_pair_whole_s17_q & and_477_s17_q;
  // hls/stages/agreement.hpp:193
  logic not_1512;
  assign not_1512 = ~so_s17_q;
  // hls/stages/patches.hpp:321
  logic and_1513;
  assign and_1513 = not_1512 & shift_2_s17_q[4];
  logic and_1610;
  assign and_1610 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & right_3_s17_q));
  // hls/stages/patches.hpp:87
  logic and_1633;
  assign and_1633 = less_1631_s17_q & (~right_3_s17_q);
  // hls/stages/patches.hpp:89
  logic equal_1634;
  assign equal_1634 = x_s17_q == 8'h0;
  // hls/stages/agreement.hpp:964
  logic and_1644;
  assign and_1644 = (~(and_1633 | (equal_1634 | not_1636_s17_q))) & (less_1641_s17_q & less_1642_s17_q);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1675;
  assign sum_1675 = {registration_slope_s17_q[11], registration_slope_s17_q} + {{5{sum_1674_s17_q[7]}}, sum_1674_s17_q};
  // hls/stages/patches.hpp:321
  logic and_1689;
  assign and_1689 = ends_cell_s17_q & (shift_2_s17_q[0] & (and_1633 | equal_1686_s17_q));
  logic and_1691;
  assign and_1691 = not_1473_s17_q & (so_s17_q & and_1689);
  // hls/stages/patches.hpp:155
  logic [7:0] pixel;
  assign pixel = equal_1698_s17_q ? (patches_second_s17_q ? 8'h0 : patches_right_0_rdata_s17_q) : 8'h0;
  // hls/stages/patches.hpp:444
  logic [8:0] sum_1816;
  assign sum_1816 = {1'b0, patches_columns_above_rdata_s17_q[23:16]} + {3'h0, patches_columns_above_rdata_s17_q[31:26]};
  // hls/stages/agreement.hpp:1000
  logic or_1887;
  assign or_1887 = (~sum_1885_s17_q) | equal_1686_s17_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2503;
  assign select_2503 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2503;
  // hls/stages/patches.hpp:321
  logic and_2754;
  assign and_2754 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & not_2751_s17_q));
  // hls/stages/patches.hpp:533
  logic [9:0] select_3272;
  assign select_3272 = less_1854_s17_q ? patches_rows_rdata_s17_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:534
  logic [9:0] select_3274;
  assign select_3274 = less_1854_s17_q ? (equal_1857_s17_q ? 10'h0 : select_3272) : 10'h0;
  // hls/stages/patches.hpp:533
  logic [4:0] select_3279;
  assign select_3279 = less_1854_s17_q ? patches_rows_rdata_s17_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:537
  logic [4:0] select_3282;
  assign select_3282 = equal_1857_s17_q ? (less_1854_s17_q ? (equal_1857_s17_q ? 5'h0 : select_3279) : 5'h0) : select_3279;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 17, written in stage 20: 17 < 20 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_471_s17_q;
  logic averager_memory_re;
  assign averager_memory_re = s17_en & and_478;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1454_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1453_s17_q, select_1452_s17_q, select_1434_s17_q, select_1430_s17_q, select_1419_s17_q, select_1418_s17_q, select_1413_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s7_sim;
  logic best_left_re_s7_sim;
  logic [6:0] best_left_raddr_s8_sim;
  logic best_left_re_s8_sim;
  logic [6:0] best_left_raddr_s9_sim;
  logic best_left_re_s9_sim;
  logic [6:0] best_left_raddr_s10_sim;
  logic best_left_re_s10_sim;
  logic [6:0] best_left_raddr_s11_sim;
  logic best_left_re_s11_sim;
  logic [6:0] best_left_raddr_s12_sim;
  logic best_left_re_s12_sim;
  logic [6:0] best_left_raddr_s13_sim;
  logic best_left_re_s13_sim;
  logic [6:0] best_left_raddr_s14_sim;
  logic best_left_re_s14_sim;
  logic [6:0] best_left_raddr_s15_sim;
  logic best_left_re_s15_sim;
  logic [6:0] best_left_raddr_s16_sim;
  logic best_left_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s7_sim <= 1'b0;
      best_left_re_s8_sim <= 1'b0;
      best_left_re_s9_sim <= 1'b0;
      best_left_re_s10_sim <= 1'b0;
      best_left_re_s11_sim <= 1'b0;
      best_left_re_s12_sim <= 1'b0;
      best_left_re_s13_sim <= 1'b0;
      best_left_re_s14_sim <= 1'b0;
      best_left_re_s15_sim <= 1'b0;
      best_left_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s7_sim <= best_left_re;
      best_left_raddr_s7_sim <= best_left_raddr;
      best_left_re_s8_sim <= best_left_re_s7_sim;
      best_left_raddr_s8_sim <= best_left_raddr_s7_sim;
      best_left_re_s9_sim <= best_left_re_s8_sim;
      best_left_raddr_s9_sim <= best_left_raddr_s8_sim;
      best_left_re_s10_sim <= best_left_re_s9_sim;
      best_left_raddr_s10_sim <= best_left_raddr_s9_sim;
      best_left_re_s11_sim <= best_left_re_s10_sim;
      best_left_raddr_s11_sim <= best_left_raddr_s10_sim;
      best_left_re_s12_sim <= best_left_re_s11_sim;
      best_left_raddr_s12_sim <= best_left_raddr_s11_sim;
      best_left_re_s13_sim <= best_left_re_s12_sim;
      best_left_raddr_s13_sim <= best_left_raddr_s12_sim;
      best_left_re_s14_sim <= best_left_re_s13_sim;
      best_left_raddr_s14_sim <= best_left_raddr_s13_sim;
      best_left_re_s15_sim <= best_left_re_s14_sim;
      best_left_raddr_s15_sim <= best_left_raddr_s14_sim;
      best_left_re_s16_sim <= best_left_re_s15_sim;
      best_left_raddr_s16_sim <= best_left_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s7_sim && best_left_raddr_s7_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s8_sim && best_left_raddr_s8_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s9_sim && best_left_raddr_s9_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s10_sim && best_left_raddr_s10_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s11_sim && best_left_raddr_s11_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s12_sim && best_left_raddr_s12_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s13_sim && best_left_raddr_s13_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s14_sim && best_left_raddr_s14_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s15_sim && best_left_raddr_s15_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s16_sim && best_left_raddr_s16_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_waddr >= 7'd120) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd120) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = right_s17_q;
  logic best_right_we;
  assign best_right_we = s17_en & and_1454_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1471_s17_q, select_1470_s17_q, select_1467_s17_q, select_1466_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_right_raddr_s11_sim;
  logic best_right_re_s11_sim;
  logic [6:0] best_right_raddr_s12_sim;
  logic best_right_re_s12_sim;
  logic [6:0] best_right_raddr_s13_sim;
  logic best_right_re_s13_sim;
  logic [6:0] best_right_raddr_s14_sim;
  logic best_right_re_s14_sim;
  logic [6:0] best_right_raddr_s15_sim;
  logic best_right_re_s15_sim;
  logic [6:0] best_right_raddr_s16_sim;
  logic best_right_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s11_sim <= 1'b0;
      best_right_re_s12_sim <= 1'b0;
      best_right_re_s13_sim <= 1'b0;
      best_right_re_s14_sim <= 1'b0;
      best_right_re_s15_sim <= 1'b0;
      best_right_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s11_sim <= best_right_re;
      best_right_raddr_s11_sim <= best_right_raddr;
      best_right_re_s12_sim <= best_right_re_s11_sim;
      best_right_raddr_s12_sim <= best_right_raddr_s11_sim;
      best_right_re_s13_sim <= best_right_re_s12_sim;
      best_right_raddr_s13_sim <= best_right_raddr_s12_sim;
      best_right_re_s14_sim <= best_right_re_s13_sim;
      best_right_raddr_s14_sim <= best_right_raddr_s13_sim;
      best_right_re_s15_sim <= best_right_re_s14_sim;
      best_right_raddr_s15_sim <= best_right_raddr_s14_sim;
      best_right_re_s16_sim <= best_right_re_s15_sim;
      best_right_raddr_s16_sim <= best_right_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s11_sim && best_right_raddr_s11_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s12_sim && best_right_raddr_s12_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s13_sim && best_right_raddr_s13_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s14_sim && best_right_raddr_s14_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s15_sim && best_right_raddr_s15_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s16_sim && best_right_raddr_s16_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 7'd120) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd120) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1511_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1516_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1513, not_1512};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 7'd120) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 7'd120) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  logic [7:0] pixel_0_s18_q;
  logic [7:0] pixel_1_s18_q;
  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic sample_pair_whole_s18_q;
  logic sample_present_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic [2:0] slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic [4:0] patches_band_rows_number_s18_q;
  logic [4:0] patches_choosing_band_s18_q;
  logic patches_lower_s18_q;
  logic patches_second_s18_q;
  logic [4:0] patches_code_row_s18_q;
  logic [4:0] patches_column_s18_q;
  logic [4:0] patches_step_s18_q;
  logic patches_read_searches_s18_q;
  logic [3:0] select_464_s18_q;
  logic equal_465_s18_q;
  logic [6:0] select_467_s18_q;
  logic [8:0] select_471_s18_q;
  logic and_477_s18_q;
  logic and_478_s18_q;
  logic equal_483_s18_q;
  logic [6:0] column_s18_q;
  logic and_501_s18_q;
  logic and_503_s18_q;
  logic so_s18_q;
  logic equal_564_s18_q;
  logic equal_1472_s18_q;
  logic not_1473_s18_q;
  logic [13:0] shift_2_s18_q;
  logic and_1507_s18_q;
  logic [1:0] shown_right_rdata_s18_q;
  logic not_1512_s18_q;
  logic right_2_s18_q;
  logic and_1585_s18_q;
  logic and_1598_s18_q;
  logic and_1611_s18_q;
  logic less_1612_s18_q;
  logic equal_1634_s18_q;
  logic and_1644_s18_q;
  logic [7:0] sum_1675_s18_q;
  logic less_1676_s18_q;
  logic less_1677_s18_q;
  logic and_1691_s18_q;
  logic and_1692_s18_q;
  logic equal_1693_s18_q;
  logic not_1694_s18_q;
  logic equal_1695_s18_q;
  logic not_1696_s18_q;
  logic equal_1697_s18_q;
  logic equal_1698_s18_q;
  logic or_1699_s18_q;
  logic [4:0] select_1723_s18_q;
  logic select_1729_s18_q;
  logic [7:0] patches_left_rdata_s18_q;
  logic [3:0] select_1768_s18_q;
  logic and_1778_s18_q;
  logic [31:0] patches_columns_above_rdata_s18_q;
  logic [7:0] select_1782_s18_q;
  logic [8:0] sum_1816_s18_q;
  logic less_1854_s18_q;
  logic equal_1855_s18_q;
  logic not_1856_s18_q;
  logic equal_1857_s18_q;
  logic not_1858_s18_q;
  logic [9:0] patches_rows_rdata_s18_q;
  logic sum_1885_s18_q;
  logic and_1890_s18_q;
  logic textured_s18_q;
  logic [17:0] seen_columns_rdata_s18_q;
  logic and_2023_s18_q;
  logic equal_2163_s18_q;
  logic equal_2287_s18_q;
  logic less_2487_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2505_s18_q;
  logic less_2524_s18_q;
  logic and_2755_s18_q;
  logic or_2806_s18_q;
  logic not_2830_s18_q;
  logic [9:0] select_3275_s18_q;
  logic [4:0] select_3282_s18_q;
  logic equal_3309_s18_q;
  logic less_3592_s18_q;
  logic select_3635_s18_q;
  logic equal_3797_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      sample_present_s18_q <= sample_present_s17_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      slot_s18_q <= slot_s17_q;
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      patches_band_rows_number_s18_q <= patches_band_rows_number_s17_q;
      patches_choosing_band_s18_q <= patches_choosing_band_s17_q;
      patches_lower_s18_q <= patches_lower_s17_q;
      patches_second_s18_q <= patches_second_s17_q;
      patches_code_row_s18_q <= patches_code_row_s17_q;
      patches_column_s18_q <= patches_column_s17_q;
      patches_step_s18_q <= patches_step_s17_q;
      patches_read_searches_s18_q <= patches_read_searches_s17_q;
      select_464_s18_q <= select_464_s17_q;
      equal_465_s18_q <= equal_465_s17_q;
      select_467_s18_q <= select_467_s17_q;
      select_471_s18_q <= select_471_s17_q;
      and_477_s18_q <= and_477_s17_q;
      and_478_s18_q <= and_478;
      equal_483_s18_q <= equal_483_s17_q;
      column_s18_q <= column_s17_q;
      and_501_s18_q <= and_501_s17_q;
      and_503_s18_q <= and_503_s17_q;
      so_s18_q <= so_s17_q;
      equal_564_s18_q <= equal_564_s17_q;
      equal_1472_s18_q <= equal_1472_s17_q;
      not_1473_s18_q <= not_1473_s17_q;
      shift_2_s18_q <= shift_2_s17_q;
      and_1507_s18_q <= and_1507_s17_q;
      shown_right_rdata_s18_q <= shown_right_rdata_q;
      not_1512_s18_q <= not_1512;
      right_2_s18_q <= right_2_s17_q;
      and_1585_s18_q <= and_1585_s17_q;
      and_1598_s18_q <= and_1598_s17_q;
      and_1611_s18_q <= not_1473_s17_q & and_1610;
      less_1612_s18_q <= less_1612_s17_q;
      equal_1634_s18_q <= equal_1634;
      and_1644_s18_q <= and_1644;
      sum_1675_s18_q <= sum_1675[7:0];
      less_1676_s18_q <= $signed(6'h0) < $signed(sum_1675[12:7]);
      less_1677_s18_q <= $signed(sum_1675[12:7]) < $signed(6'h3f);
      and_1691_s18_q <= and_1691;
      and_1692_s18_q <= patches_chooses_s17_q & and_1691;
      equal_1693_s18_q <= equal_1693_s17_q;
      not_1694_s18_q <= not_1694_s17_q;
      equal_1695_s18_q <= equal_1695_s17_q;
      not_1696_s18_q <= not_1696_s17_q;
      equal_1697_s18_q <= equal_1697_s17_q;
      equal_1698_s18_q <= equal_1698_s17_q;
      or_1699_s18_q <= or_1699_s17_q;
      select_1723_s18_q <= select_1723_s17_q;
      select_1729_s18_q <= select_1729_s17_q;
      patches_left_rdata_s18_q <= patches_left_rdata_q;
      select_1768_s18_q <= select_1768_s17_q;
      and_1778_s18_q <= and_1778_s17_q;
      patches_columns_above_rdata_s18_q <= patches_columns_above_rdata_s17_q;
      select_1782_s18_q <= patches_second_s17_q ? patches_right_1_rdata_s17_q : pixel;
      sum_1816_s18_q <= sum_1816;
      less_1854_s18_q <= less_1854_s17_q;
      equal_1855_s18_q <= equal_1855_s17_q;
      not_1856_s18_q <= not_1856_s17_q;
      equal_1857_s18_q <= equal_1857_s17_q;
      not_1858_s18_q <= not_1858_s17_q;
      patches_rows_rdata_s18_q <= patches_rows_rdata_s17_q[9:0];
      sum_1885_s18_q <= sum_1885_s17_q;
      and_1890_s18_q <= so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & or_1887));
      textured_s18_q <= textured_s17_q;
      seen_columns_rdata_s18_q <= seen_columns_rdata_q;
      and_2023_s18_q <= not_1473_s17_q & (so_s17_q & (ends_cell_s17_q & and_2020_s17_q));
      equal_2163_s18_q <= equal_2163_s17_q;
      equal_2287_s18_q <= equal_2287_s17_q;
      less_2487_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2505_s18_q <= ~wide_s17_q;
      less_2524_s18_q <= less_2524_s17_q;
      and_2755_s18_q <= not_1473_s17_q & and_2754;
      or_2806_s18_q <= or_2806_s17_q;
      not_2830_s18_q <= not_2830_s17_q;
      select_3275_s18_q <= equal_1857_s17_q ? select_3274 : select_3272;
      select_3282_s18_q <= select_3282;
      equal_3309_s18_q <= equal_3309_s17_q;
      less_3592_s18_q <= less_3592_s17_q;
      select_3635_s18_q <= sum_1885_s17_q ? (equal_1686_s17_q & or_1887) : or_1887;
      equal_3797_s18_q <= equal_3797_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [7:0] registration_slope_here_q;
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic segment_starts_q;
  // hls/stages/census.hpp:112
  logic [13:0] select_481;
  assign select_481 = equal_465_s18_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_487;
  assign sum_487 = {6'h0, sample_pair_pixel_1_q} + (equal_465_s18_q ? 14'h0 : averager_running_1_q);
  // hls/stages/registration.hpp:83
  logic equal_1613;
  assign equal_1613 = slot_s18_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1614;
  assign select_1614 = shift_2_s18_q[5] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1615;
  assign select_1615 = shift_2_s18_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1616;
  assign sum_1616 = {{2{select_1614[6]}}, select_1614} + {select_1615[7], select_1615};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1617;
  assign select_1617 = shift_2_s18_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1618;
  assign select_1618 = shift_2_s18_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1619;
  assign sum_1619 = {{2{select_1617[7]}}, select_1617[7:1]} + {select_1618[7], select_1618};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1621;
  assign select_1621 = shift_2_s18_q[9] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1622;
  assign select_1622 = shift_2_s18_q[10] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1623;
  assign difference_1623 = {{2{select_1621[7]}}, select_1621[7:1]} - {select_1622[7], select_1622};
  // hls/stages/patches.hpp:321
  logic [5:0] select_1657;
  assign select_1657 = ends_cell_s18_q ? (shift_2_s18_q[0] ? shift_2_s18_q[10:5] : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1679;
  assign select_1679 = less_1676_s18_q ? 8'h7f : (less_1677_s18_q ? 8'h80 : sum_1675_s18_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1613 ? registration_slope_here_q : select_1679;
  // hls/stages/patches.hpp:321
  logic [7:0] select_1683;
  assign select_1683 = so_s18_q ? (ends_cell_s18_q ? (shift_2_s18_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:155
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1698_s18_q ? select_1782_s18_q : patches_left_rdata_s18_q;
  // hls/stages/patches.hpp:444
  logic [9:0] sum_1817;
  assign sum_1817 = {2'h0, patches_columns_above_rdata_s18_q[15:8]} + {1'b0, sum_1816_s18_q};
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1872;
  assign select_1872 = so_s18_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_1875;
  assign or_1875 = select_1872[7] | (~({select_1872[5], select_1872[3], select_1872[1]} == 3'h0));
  // hls/stages/agreement.hpp:250
  logic and_1904;
  assign and_1904 = shift_2_s18_q[0] & ({shift_2_s18_q[4], shift_2_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:960
  logic select_1912;
  assign select_1912 = slot_s18_q[2] ? shown_shown_q : shift_2_s18_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1912);
  // hls/stages/agreement.hpp:960
  logic select_1915;
  assign select_1915 = slot_s18_q[2] ? shown_nearer_q : shift_2_s18_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s18_q[0] & (select_1912 ? select_1915 : shown_right_rdata_s18_q[1]);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_1964;
  assign select_1964 = shift_2_s18_q[0] ? (sum_1885_s18_q ? select_1872 : {select_1872[6:0], 1'b0}) : select_1872;
  // hls/stages/agreement.hpp:992
  logic or_1967;
  assign or_1967 = select_1964[7] | (~({select_1964[5], select_1964[3], select_1964[1]} == 3'h0));
  // hls/stages/registration.hpp:37
  logic not_2498;
  assign not_2498 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2487_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2498};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2506;
  assign select_2506 = registration_displacement_over_q[9] ? wide_s18_q : not_2505_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2487_s18_q ? {taken_s18_q, 1'b1} : {not_2498, select_2506, not_2498};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2508;
  assign sum_2508 = {left, 1'b1} + {taken_2, less_2487_s18_q};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2510;
  assign select_2510 = so_s18_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/patches.hpp:321
  logic [7:0] select_2512;
  assign select_2512 = equal_1472_s18_q ? registration_slope_here_q : (so_s18_q ? slope : registration_slope_here_q);
  // hls/stages/patches.hpp:537
  logic [9:0] select_3277;
  assign select_3277 = less_1854_s18_q ? (equal_1855_s18_q ? 10'h0 : select_3275_s18_q) : select_3275_s18_q;
  logic [4:0] select_3284;
  assign select_3284 = less_1854_s18_q ? (equal_1855_s18_q ? 5'h0 : select_3282_s18_q) : select_3282_s18_q;
  // hls/stages/patches.hpp:533
  logic and_3294;
  assign and_3294 = less_1854_s18_q & (patches_step_s18_q == 5'h0);
  // hls/stages/patches.hpp:537
  logic select_3297;
  assign select_3297 = equal_1857_s18_q ? (less_1854_s18_q ? (not_1858_s18_q & and_3294) : and_3294) : and_3294;
  // hls/stages/patches.hpp:321
  logic select_3589;
  assign select_3589 = equal_1472_s18_q ? shown_shown_q : (so_s18_q ? select_1912 : shown_shown_q);
  logic select_3591;
  assign select_3591 = equal_1472_s18_q ? shown_nearer_q : (so_s18_q ? select_1915 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3593;
  assign sum_3593 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/patches.hpp:321
  logic [7:0] select_3602;
  assign select_3602 = equal_1472_s18_q ? select_1872 : (so_s18_q ? (ends_cell_s18_q ? select_1964 : select_1872) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3616;
  assign select_3616 = equal_564_s18_q ? {difference_3614[7], difference_3614} : (less_3592_s18_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3618;
  assign select_3618 = and_503_s18_q ? (equal_2287_s18_q ? select_3616 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3620;
  assign select_3620 = equal_564_s18_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_3622;
  assign select_3622 = and_503_s18_q ? (equal_2287_s18_q ? select_3620 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3624;
  assign select_3624 = sum_3593[7] ? {1'b1, sum_3593[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});
  // hls/stages/agreement.hpp:197
  logic or_3633;
  assign or_3633 = segment_starts_q | not_1512_s18_q;
  // hls/stages/patches.hpp:321
  logic select_3637;
  assign select_3637 = ends_cell_s18_q ? (shift_2_s18_q[0] ? select_3635_s18_q : or_3633) : or_3633;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
      segment_starts_q <= 1'b1;
    end else if (s18_en) begin
      sample_pair_pixel_0_q <= pixel_0_s18_q;
      sample_pair_pixel_1_q <= pixel_1_s18_q;
      registration_displacement_over_q <= so_s18_q ? sum_2508[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2510;
      registration_slope_here_q <= select_2512;
      patches_read_row_differing_q <= equal_1693_s18_q ? select_3277 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1693_s18_q ? select_3284 : patches_read_row_column_q;
      shown_shown_q <= select_3589;
      shown_nearer_q <= select_3591;
      region_columns_q <= select_3602;
      region_down_rest_q <= select_3618;
      region_down_back_q <= select_3622;
      region_down_next_q <= select_3624;
      segment_starts_q <= equal_1472_s18_q ? or_3633 : (so_s18_q ? select_3637 : or_3633);
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_running_0_q = 14'h0;
    averager_running_1_q = 14'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s18_en) begin
      averager_running_0_q <= sample_pair_whole_s18_q ? select_481 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s18_q ? sum_487 : averager_running_1_q;
    end
  end

  logic saturated_s19_q;
  logic mask_s19_q;
  logic marks_first_s19_q;
  logic marks_last_s19_q;
  logic [7:0] sample_pair_pixel_0_s19_q;
  logic [7:0] sample_pair_pixel_1_s19_q;
  logic sample_pair_whole_s19_q;
  logic sample_present_s19_q;
  logic [7:0] x_s19_q;
  logic age_s19_q;
  logic [2:0] slot_s19_q;
  logic ends_cell_s19_q;
  logic lower_half_s19_q;
  logic [4:0] patches_band_rows_number_s19_q;
  logic [4:0] patches_choosing_band_s19_q;
  logic patches_lower_s19_q;
  logic patches_second_s19_q;
  logic [4:0] patches_code_row_s19_q;
  logic [4:0] patches_column_s19_q;
  logic [4:0] patches_step_s19_q;
  logic [9:0] patches_read_row_differing_s19_q;
  logic [4:0] patches_read_row_column_s19_q;
  logic patches_read_searches_s19_q;
  logic [3:0] select_464_s19_q;
  logic equal_465_s19_q;
  logic [6:0] select_467_s19_q;
  logic [8:0] select_471_s19_q;
  logic and_477_s19_q;
  logic and_478_s19_q;
  logic [29:0] averager_memory_rdata_s19_q;
  logic [13:0] select_481_s19_q;
  logic equal_483_s19_q;
  logic [13:0] sum_487_s19_q;
  logic [6:0] column_s19_q;
  logic and_501_s19_q;
  logic and_503_s19_q;
  logic so_s19_q;
  logic equal_564_s19_q;
  logic equal_1472_s19_q;
  logic not_1473_s19_q;
  logic [4:0] shift_2_s19_q;
  logic and_1507_s19_q;
  logic equal_1517_s19_q;
  logic right_2_s19_q;
  logic and_1585_s19_q;
  logic and_1598_s19_q;
  logic and_1611_s19_q;
  logic less_1612_s19_q;
  logic equal_1613_s19_q;
  logic [7:0] sum_1616_s19_q;
  logic select_1617_s19_q;
  logic [8:0] sum_1619_s19_q;
  logic select_1621_s19_q;
  logic [8:0] difference_1623_s19_q;
  logic equal_1634_s19_q;
  logic and_1644_s19_q;
  logic [5:0] select_1659_s19_q;
  logic [7:0] select_1684_s19_q;
  logic and_1691_s19_q;
  logic and_1692_s19_q;
  logic equal_1693_s19_q;
  logic not_1694_s19_q;
  logic equal_1695_s19_q;
  logic not_1696_s19_q;
  logic equal_1697_s19_q;
  logic equal_1698_s19_q;
  logic or_1699_s19_q;
  logic [4:0] select_1723_s19_q;
  logic select_1729_s19_q;
  logic [3:0] select_1768_s19_q;
  logic and_1778_s19_q;
  logic [31:0] patches_columns_above_rdata_s19_q;
  logic [7:0] pixel_2_s19_q;
  logic [9:0] sum_1817_s19_q;
  logic less_1854_s19_q;
  logic equal_1855_s19_q;
  logic not_1856_s19_q;
  logic equal_1857_s19_q;
  logic not_1858_s19_q;
  logic [9:0] patches_rows_rdata_s19_q;
  logic or_1875_s19_q;
  logic or_1878_s19_q;
  logic or_1881_s19_q;
  logic and_1890_s19_q;
  logic textured_s19_q;
  logic and_1904_s19_q;
  logic [12:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_1950_s19_q;
  logic and_1952_s19_q;
  logic or_1967_s19_q;
  logic or_1970_s19_q;
  logic or_1973_s19_q;
  logic and_1984_s19_q;
  logic and_1986_s19_q;
  logic and_1987_s19_q;
  logic and_2000_s19_q;
  logic and_2002_s19_q;
  logic and_2003_s19_q;
  logic and_2023_s19_q;
  logic equal_2163_s19_q;
  logic equal_2287_s19_q;
  logic and_2427_s19_q;
  logic and_2429_s19_q;
  logic and_2430_s19_q;
  logic or_2522_s19_q;
  logic [1:0] sum_2523_s19_q;
  logic less_2524_s19_q;
  logic and_2755_s19_q;
  logic or_2806_s19_q;
  logic not_2830_s19_q;
  logic select_3297_s19_q;
  logic equal_3309_s19_q;
  logic less_3592_s19_q;
  logic sum_3593_s19_q;
  logic and_3787_s19_q;
  logic equal_3797_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
      sample_pair_pixel_0_s19_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s19_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s19_q <= sample_pair_whole_s18_q;
      sample_present_s19_q <= sample_present_s18_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      slot_s19_q <= slot_s18_q;
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      patches_band_rows_number_s19_q <= patches_band_rows_number_s18_q;
      patches_choosing_band_s19_q <= patches_choosing_band_s18_q;
      patches_lower_s19_q <= patches_lower_s18_q;
      patches_second_s19_q <= patches_second_s18_q;
      patches_code_row_s19_q <= patches_code_row_s18_q;
      patches_column_s19_q <= patches_column_s18_q;
      patches_step_s19_q <= patches_step_s18_q;
      patches_read_row_differing_s19_q <= patches_read_row_differing_q;
      patches_read_row_column_s19_q <= patches_read_row_column_q;
      patches_read_searches_s19_q <= patches_read_searches_s18_q;
      select_464_s19_q <= select_464_s18_q;
      equal_465_s19_q <= equal_465_s18_q;
      select_467_s19_q <= select_467_s18_q;
      select_471_s19_q <= select_471_s18_q;
      and_477_s19_q <= and_477_s18_q;
      and_478_s19_q <= and_478_s18_q;
      averager_memory_rdata_s19_q <= averager_memory_rdata_q;
      select_481_s19_q <= select_481;
      equal_483_s19_q <= equal_483_s18_q;
      sum_487_s19_q <= sum_487;
      column_s19_q <= column_s18_q;
      and_501_s19_q <= and_501_s18_q;
      and_503_s19_q <= and_503_s18_q;
      so_s19_q <= so_s18_q;
      equal_564_s19_q <= equal_564_s18_q;
      equal_1472_s19_q <= equal_1472_s18_q;
      not_1473_s19_q <= not_1473_s18_q;
      shift_2_s19_q <= {shift_2_s18_q[11], shift_2_s18_q[3:0]};
      and_1507_s19_q <= and_1507_s18_q;
      equal_1517_s19_q <= x_s18_q[6:4] == 3'h7;
      right_2_s19_q <= right_2_s18_q;
      and_1585_s19_q <= and_1585_s18_q;
      and_1598_s19_q <= and_1598_s18_q;
      and_1611_s19_q <= and_1611_s18_q;
      less_1612_s19_q <= less_1612_s18_q;
      equal_1613_s19_q <= equal_1613;
      sum_1616_s19_q <= sum_1616[8:1];
      select_1617_s19_q <= select_1617[0];
      sum_1619_s19_q <= sum_1619;
      select_1621_s19_q <= select_1621[0];
      difference_1623_s19_q <= difference_1623;
      equal_1634_s19_q <= equal_1634_s18_q;
      and_1644_s19_q <= and_1644_s18_q;
      select_1659_s19_q <= equal_1472_s18_q ? 6'h0 : (so_s18_q ? select_1657 : 6'h0);
      select_1684_s19_q <= equal_1472_s18_q ? 8'h0 : select_1683;
      and_1691_s19_q <= and_1691_s18_q;
      and_1692_s19_q <= and_1692_s18_q;
      equal_1693_s19_q <= equal_1693_s18_q;
      not_1694_s19_q <= not_1694_s18_q;
      equal_1695_s19_q <= equal_1695_s18_q;
      not_1696_s19_q <= not_1696_s18_q;
      equal_1697_s19_q <= equal_1697_s18_q;
      equal_1698_s19_q <= equal_1698_s18_q;
      or_1699_s19_q <= or_1699_s18_q;
      select_1723_s19_q <= select_1723_s18_q;
      select_1729_s19_q <= select_1729_s18_q;
      select_1768_s19_q <= select_1768_s18_q;
      and_1778_s19_q <= and_1778_s18_q;
      patches_columns_above_rdata_s19_q <= patches_columns_above_rdata_s18_q;
      pixel_2_s19_q <= pixel_2;
      sum_1817_s19_q <= sum_1817;
      less_1854_s19_q <= less_1854_s18_q;
      equal_1855_s19_q <= equal_1855_s18_q;
      not_1856_s19_q <= not_1856_s18_q;
      equal_1857_s19_q <= equal_1857_s18_q;
      not_1858_s19_q <= not_1858_s18_q;
      patches_rows_rdata_s19_q <= patches_rows_rdata_s18_q;
      or_1875_s19_q <= or_1875;
      or_1878_s19_q <= select_1872[7] | (~({select_1872[6], select_1872[3:2]} == 3'h0));
      or_1881_s19_q <= select_1872[7] | (~(select_1872[6:4] == 3'h0));
      and_1890_s19_q <= and_1890_s18_q;
      textured_s19_q <= textured_s18_q;
      and_1904_s19_q <= and_1904;
      seen_columns_rdata_s19_q <= {seen_columns_rdata_s18_q[13:7], seen_columns_rdata_s18_q[5:0]};
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_1950_s19_q <= seen_columns_rdata_s18_q[14] & shift_2_s18_q[0];
      and_1952_s19_q <= seen_columns_rdata_s18_q[5] & shift_2_s18_q[0];
      or_1967_s19_q <= or_1967;
      or_1970_s19_q <= select_1964[7] | (~({select_1964[6], select_1964[3:2]} == 3'h0));
      or_1973_s19_q <= select_1964[7] | (~(select_1964[6:4] == 3'h0));
      and_1984_s19_q <= seen_columns_rdata_s18_q[16] & shift_2_s18_q[0];
      and_1986_s19_q <= seen_columns_rdata_s18_q[8] & shift_2_s18_q[0];
      and_1987_s19_q <= seen_columns_rdata_s18_q[3] & shift_2_s18_q[0];
      and_2000_s19_q <= seen_columns_rdata_s18_q[17] & shift_2_s18_q[0];
      and_2002_s19_q <= seen_columns_rdata_s18_q[9] & shift_2_s18_q[0];
      and_2003_s19_q <= seen_columns_rdata_s18_q[4] & shift_2_s18_q[0];
      and_2023_s19_q <= and_2023_s18_q;
      equal_2163_s19_q <= equal_2163_s18_q;
      equal_2287_s19_q <= equal_2287_s18_q;
      and_2427_s19_q <= seen_columns_rdata_s18_q[15] & shift_2_s18_q[0];
      and_2429_s19_q <= seen_columns_rdata_s18_q[7] & shift_2_s18_q[0];
      and_2430_s19_q <= seen_columns_rdata_s18_q[2] & shift_2_s18_q[0];
      or_2522_s19_q <= (shift_2_s18_q[13:11] == 3'h0) | (shift_2_s18_q[13:11] == 3'h4);
      sum_2523_s19_q <= shift_2_s18_q[13:12] + 2'h3;
      less_2524_s19_q <= less_2524_s18_q;
      and_2755_s19_q <= and_2755_s18_q;
      or_2806_s19_q <= or_2806_s18_q;
      not_2830_s19_q <= not_2830_s18_q;
      select_3297_s19_q <= select_3297;
      equal_3309_s19_q <= equal_3309_s18_q;
      less_3592_s19_q <= less_3592_s18_q;
      sum_3593_s19_q <= sum_3593[7];
      and_3787_s19_q <= seen_columns_rdata_s18_q[6] & shift_2_s18_q[0];
      equal_3797_s19_q <= equal_3797_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic sample_of_skin_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic patches_read_first_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic region_fresh_q;
  logic segment_started_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/census.hpp:121
  logic [13:0] sum_485;
  assign sum_485 = select_481_s19_q + (equal_483_s19_q ? 14'h0 : averager_memory_rdata_s19_q[13:0]);
  logic [13:0] sum_489;
  assign sum_489 = sum_487_s19_q + (equal_483_s19_q ? 14'h0 : averager_memory_rdata_s19_q[27:14]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = equal_465_s19_q ? sample_present_s19_q : (sample_present_s19_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_465_s19_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:123
  logic and_497;
  assign and_497 = all_of_skin & (averager_memory_rdata_s19_q[29] | equal_483_s19_q);
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s19_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:192
  logic equal_1531;
  assign equal_1531 = x_s19_q[5:0] == 6'h3c;
  logic equal_1533;
  assign equal_1533 = x_s19_q[5:0] == 6'h3b;
  logic equal_1535;
  assign equal_1535 = x_s19_q[5:0] == 6'h36;
  logic equal_1537;
  assign equal_1537 = x_s19_q[5:0] == 6'h35;
  logic equal_1539;
  assign equal_1539 = x_s19_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1116
  logic and_1543;
  assign and_1543 = (~equal_1533) & ((~equal_1535) & ((~equal_1537) & (~equal_1539)));
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1620;
  assign sum_1620 = {{3{sum_1616_s19_q[7]}}, sum_1616_s19_q} + {sum_1619_s19_q[8], sum_1619_s19_q, select_1617_s19_q};
  logic [9:0] sum_1624;
  assign sum_1624 = {difference_1623_s19_q, select_1621_s19_q} + {sum_1620[10], sum_1620[10:2]};
  // hls/stages/patches.hpp:446
  logic [8:0] sum_1806;
  assign sum_1806 = {1'b0, patches_columns_above_rdata_s19_q[7:0]} + {2'h0, pixel_2_s19_q[7:1]};
  logic [8:0] sum_1807;
  assign sum_1807 = {1'b0, patches_columns_above_rdata_s19_q[23:16]} + {2'h0, patches_columns_above_rdata_s19_q[31:25]};
  // hls/stages/patches.hpp:444
  logic [10:0] sum_1818;
  assign sum_1818 = {3'h0, patches_columns_above_rdata_s19_q[15:8]} + {sum_1817_s19_q, patches_columns_above_rdata_s19_q[25]};
  // hls/stages/patches.hpp:321
  logic [5:0] select_1882;
  assign select_1882 = equal_1472_s19_q ? x_s19_q[5:0] : {region_row_q, or_1881_s19_q, or_1878_s19_q, or_1875_s19_q};
  // hls/stages/agreement.hpp:1070
  logic not_1883;
  assign not_1883 = ~equal_1517_s19_q;
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s19_q[0] & shift_2_s19_q[3];
  logic and_1911;
  assign and_1911 = shift_2_s19_q[0] & shift_2_s19_q[2];
  // hls/stages/agreement.hpp:976
  logic and_1953;
  assign and_1953 = seen_columns_rdata_s19_q[0] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_1955;
  assign sum_1955 = {1'b0, and_1952_s19_q} + ({1'b0, textured_s19_q} + {1'b0, and_1953});
  // hls/stages/agreement.hpp:976
  logic and_1985;
  assign and_1985 = seen_columns_rdata_s19_q[11] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1989;
  assign sum_1989 = {1'b0, and_1986_s19_q} + ({1'b0, shown_s19_q} + {1'b0, and_1987_s19_q});
  // hls/stages/agreement.hpp:976
  logic and_2001;
  assign and_2001 = seen_columns_rdata_s19_q[12] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_2005;
  assign sum_2005 = {1'b0, and_2002_s19_q} + ({1'b0, near_s19_q} + {1'b0, and_2003_s19_q});
  // hls/stages/agreement.hpp:263
  logic select_2076;
  assign select_2076 = sample_pair_whole_s19_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/patches.hpp:321
  logic and_2406;
  assign and_2406 = so_s19_q & (ends_cell_s19_q & (shift_2_s19_q[0] & shift_2_s19_q[1]));
  // hls/stages/agreement.hpp:1047
  logic not_2426;
  assign not_2426 = ~(x_s19_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:976
  logic and_2428;
  assign and_2428 = seen_columns_rdata_s19_q[10] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2432;
  assign sum_2432 = {1'b0, and_2429_s19_q} + ({1'b0, explained} + {1'b0, and_2430_s19_q});
  // hls/stages/patches.hpp:321
  logic and_2467;
  assign and_2467 = ends_cell_s19_q & (shift_2_s19_q[0] & (shift_2_s19_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:1052
  logic and_2473;
  assign and_2473 = not_2426 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2525;
  assign difference_2525 = {sum_2523_s19_q, shift_2_s19_q[4], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2526;
  assign select_2526 = less_2524_s19_q ? difference_2525 : {sum_2523_s19_q, shift_2_s19_q[4], registration_displacement_fraction_q};
  logic [7:0] select_2527;
  assign select_2527 = or_2522_s19_q ? {sum_2523_s19_q, shift_2_s19_q[4], 5'h0} : select_2526;
  // hls/stages/patches.hpp:170
  logic select_2845;
  assign select_2845 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:158
  logic and_2906;
  assign and_2906 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:394
  logic [4:0] select_2911;
  assign select_2911 = or_2806_s19_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:396
  logic [3:0] select_2913;
  assign select_2913 = and_2906 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:533
  logic [4:0] select_3286;
  assign select_3286 = less_1854_s19_q ? patches_step_s19_q : 5'h0;
  // hls/stages/patches.hpp:537
  logic [4:0] select_3289;
  assign select_3289 = equal_1857_s19_q ? (less_1854_s19_q ? (equal_1857_s19_q ? 5'h0 : select_3286) : 5'h0) : select_3286;
  logic [4:0] select_3291;
  assign select_3291 = less_1854_s19_q ? (equal_1855_s19_q ? 5'h0 : select_3289) : select_3289;
  logic select_3299;
  assign select_3299 = less_1854_s19_q ? (not_1856_s19_q & select_3297_s19_q) : select_3297_s19_q;
  // hls/stages/patches.hpp:161
  logic or_3311;
  assign or_3311 = patches_read_first_q | (patches_read_row_differing_s19_q < patches_peak_best_differing_q);
  logic and_3312;
  assign and_3312 = patches_read_searches_s19_q & or_3311;
  // hls/stages/patches.hpp:516
  logic [14:0] select_3344;
  assign select_3344 = and_3312 ? {patches_read_row_column_s19_q, patches_read_row_differing_s19_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:167
  logic [9:0] select_3345;
  assign select_3345 = equal_1693_s19_q ? select_3344[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3346;
  assign select_3346 = equal_1693_s19_q ? select_3344[14:10] : patches_peak_best_column_q;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3595;
  assign select_3595 = less_3592_s19_q ? (sum_3593_s19_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3597;
  assign select_3597 = equal_2287_s19_q ? (equal_564_s19_q ? 3'h0 : select_3595) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3593_s19_q;
  // hls/stages/agreement.hpp:447
  logic select_3628;
  assign select_3628 = equal_2287_s19_q ? (equal_564_s19_q | (less_3592_s19_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1148
  logic equal_3646;
  assign equal_3646 = x_s19_q[6:3] == 4'h7;
  logic equal_3668;
  assign equal_3668 = x_s19_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_3681;
  assign select_3681 = (x_s19_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3683;
  assign select_3683 = equal_3668 ? cfg_unproven_skin_limit_i : (equal_3646 ? cfg_unproven_limit_i : select_3681);
  // hls/stages/patches.hpp:321
  logic select_3785;
  assign select_3785 = so_s19_q ? (ends_cell_s19_q ? and_1952_s19_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3789;
  assign select_3789 = so_s19_q ? (ends_cell_s19_q ? and_3787_s19_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_3791;
  assign select_3791 = ends_cell_s19_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3793;
  assign select_3793 = equal_1472_s19_q ? centres_values_1_textured_q : (so_s19_q ? select_3791 : centres_values_1_textured_q);
  logic select_3794;
  assign select_3794 = ends_cell_s19_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3796;
  assign select_3796 = equal_1472_s19_q ? centres_values_1_of_skin_q : (so_s19_q ? select_3794 : centres_values_1_of_skin_q);

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 19, written in stage 21: 19 < 21 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s19_q;
  logic census_memory_re;
  assign census_memory_re = s19_en & and_503_s19_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1319; read in stage 19, written in stage 22: 19 < 22 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1882;
  logic regions_re;
  assign regions_re = s19_en & (equal_1472_s19_q ? (x_s19_q[6] & not_1883) : and_1890_s19_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s19_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s19_en & and_1778_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_s19_q[23:0], pixel_2_s19_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_columns_above_raddr_s16_sim;
  logic patches_columns_above_re_s16_sim;
  logic [4:0] patches_columns_above_raddr_s17_sim;
  logic patches_columns_above_re_s17_sim;
  logic [4:0] patches_columns_above_raddr_s18_sim;
  logic patches_columns_above_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_columns_above_re_s16_sim <= 1'b0;
      patches_columns_above_re_s17_sim <= 1'b0;
      patches_columns_above_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      patches_columns_above_re_s16_sim <= patches_columns_above_re;
      patches_columns_above_raddr_s16_sim <= patches_columns_above_raddr;
      patches_columns_above_re_s17_sim <= patches_columns_above_re_s16_sim;
      patches_columns_above_raddr_s17_sim <= patches_columns_above_raddr_s16_sim;
      patches_columns_above_re_s18_sim <= patches_columns_above_re_s17_sim;
      patches_columns_above_raddr_s18_sim <= patches_columns_above_raddr_s17_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s16_sim && patches_columns_above_raddr_s16_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s17_sim && patches_columns_above_raddr_s17_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s18_sim && patches_columns_above_raddr_s18_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
    end
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s19_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s19_en & and_1507_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q, near_s19_q, shown_s19_q, explained, and_1911, textured_s19_q};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s17_sim;
  logic seen_columns_re_s17_sim;
  logic [6:0] seen_columns_raddr_s18_sim;
  logic seen_columns_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s17_sim <= 1'b0;
      seen_columns_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s17_sim <= seen_columns_re;
      seen_columns_raddr_s17_sim <= seen_columns_raddr;
      seen_columns_re_s18_sim <= seen_columns_re_s17_sim;
      seen_columns_raddr_s18_sim <= seen_columns_raddr_s17_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s17_sim && seen_columns_raddr_s17_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s18_sim && seen_columns_raddr_s18_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 7'd120) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 7'd120) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_of_skin_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      patches_along_ends_q <= 1'b0;
      patches_match_row_ends_q <= 1'b0;
      patches_down_by_q <= 5'h0;
      patches_along_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_last_q <= 1'b0;
      patches_read_first_q <= 1'b0;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      segment_started_q <= 1'b0;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s19_en) begin
      sample_of_skin_q <= mask_s19_q;
      averager_running_mask_q <= sample_pair_whole_s19_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2076;
      patches_along_ends_q <= not_2830_s19_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2830_s19_q & select_2845;
      patches_down_by_q <= or_2806_s19_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2906});
      patches_along_q <= select_2911;
      patches_match_row_q <= or_2806_s19_q ? 4'h0 : select_2913;
      patches_summed_last_q <= not_1694_s19_q & (equal_1695_s19_q & and_2906);
      patches_read_first_q <= equal_1693_s19_q ? select_3299 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3345;
      patches_peak_best_column_q <= select_3346;
      region_row_q <= and_503_s19_q ? select_3597 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_503_s19_q ? select_3628 : region_fresh_q;
      segment_started_q <= ~segment_starts_q;
      centres_values_0_textured_q <= equal_1472_s19_q ? centres_values_0_textured_q : select_3785;
      centres_values_0_of_skin_q <= equal_1472_s19_q ? centres_values_0_of_skin_q : select_3789;
      centres_values_1_textured_q <= select_3793;
      centres_values_1_of_skin_q <= select_3796;
    end
  end

  logic [7:0] pixel_0_s20_q;
  logic [7:0] pixel_1_s20_q;
  logic saturated_s20_q;
  logic marks_first_s20_q;
  logic marks_last_s20_q;
  logic [7:0] sample_pair_pixel_0_s20_q;
  logic [7:0] sample_pair_pixel_1_s20_q;
  logic sample_pair_whole_s20_q;
  logic sample_present_s20_q;
  logic [7:0] x_s20_q;
  logic age_s20_q;
  logic [2:0] slot_s20_q;
  logic ends_cell_s20_q;
  logic lower_half_s20_q;
  logic [4:0] patches_band_rows_number_s20_q;
  logic [4:0] patches_choosing_band_s20_q;
  logic patches_lower_s20_q;
  logic patches_second_s20_q;
  logic [4:0] patches_code_row_s20_q;
  logic [4:0] patches_column_s20_q;
  logic patches_match_row_ends_s20_q;
  logic [4:0] patches_down_by_s20_q;
  logic [4:0] patches_along_s20_q;
  logic [3:0] patches_match_row_s20_q;
  logic patches_summed_last_s20_q;
  logic [4:0] patches_step_s20_q;
  logic [9:0] patches_read_row_differing_s20_q;
  logic patches_read_first_s20_q;
  logic [2:0] region_row_s20_q;
  logic region_fresh_s20_q;
  logic segment_started_s20_q;
  logic centres_values_1_textured_s20_q;
  logic centres_values_1_of_skin_s20_q;
  logic [3:0] select_464_s20_q;
  logic [6:0] select_467_s20_q;
  logic [8:0] select_471_s20_q;
  logic and_477_s20_q;
  logic and_478_s20_q;
  logic [13:0] sum_485_s20_q;
  logic [13:0] sum_489_s20_q;
  logic and_493_s20_q;
  logic and_497_s20_q;
  logic [6:0] column_s20_q;
  logic and_501_s20_q;
  logic and_503_s20_q;
  logic equal_506_s20_q;
  logic so_s20_q;
  logic equal_564_s20_q;
  logic equal_1472_s20_q;
  logic not_1473_s20_q;
  logic [1:0] shift_2_s20_q;
  logic equal_1517_s20_q;
  logic all_s20_q;
  logic equal_1531_s20_q;
  logic equal_1533_s20_q;
  logic equal_1535_s20_q;
  logic equal_1537_s20_q;
  logic equal_1539_s20_q;
  logic and_1544_s20_q;
  logic right_2_s20_q;
  logic and_1585_s20_q;
  logic and_1598_s20_q;
  logic and_1611_s20_q;
  logic less_1612_s20_q;
  logic equal_1613_s20_q;
  logic sum_1620_s20_q;
  logic [9:0] sum_1624_s20_q;
  logic equal_1634_s20_q;
  logic and_1644_s20_q;
  logic [5:0] select_1659_s20_q;
  logic [7:0] select_1684_s20_q;
  logic and_1691_s20_q;
  logic and_1692_s20_q;
  logic equal_1693_s20_q;
  logic not_1694_s20_q;
  logic equal_1695_s20_q;
  logic not_1696_s20_q;
  logic equal_1697_s20_q;
  logic equal_1698_s20_q;
  logic or_1699_s20_q;
  logic [4:0] select_1723_s20_q;
  logic select_1729_s20_q;
  logic [3:0] select_1768_s20_q;
  logic [8:0] patches_columns_above_rdata_s20_q;
  logic [7:0] pixel_2_s20_q;
  logic [4:0] sum_1792_s20_q;
  logic [8:0] sum_1806_s20_q;
  logic [8:0] sum_1807_s20_q;
  logic [10:0] sum_1818_s20_q;
  logic less_1854_s20_q;
  logic equal_1855_s20_q;
  logic not_1856_s20_q;
  logic equal_1857_s20_q;
  logic not_1858_s20_q;
  logic [9:0] patches_rows_rdata_s20_q;
  logic or_1875_s20_q;
  logic or_1878_s20_q;
  logic or_1881_s20_q;
  logic not_1883_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1904_s20_q;
  logic and_1909_s20_q;
  logic and_1950_s20_q;
  logic and_1951_s20_q;
  logic [1:0] sum_1955_s20_q;
  logic or_1967_s20_q;
  logic or_1970_s20_q;
  logic or_1973_s20_q;
  logic and_1984_s20_q;
  logic [2:0] sum_1990_s20_q;
  logic and_2000_s20_q;
  logic [2:0] sum_2006_s20_q;
  logic and_2023_s20_q;
  logic equal_2163_s20_q;
  logic equal_2287_s20_q;
  logic and_2407_s20_q;
  logic not_2426_s20_q;
  logic and_2427_s20_q;
  logic [2:0] sum_2433_s20_q;
  logic and_2469_s20_q;
  logic and_2476_s20_q;
  logic [7:0] select_2527_s20_q;
  logic and_2755_s20_q;
  logic [4:0] select_3291_s20_q;
  logic equal_3309_s20_q;
  logic and_3312_s20_q;
  logic [14:0] select_3344_s20_q;
  logic equal_3646_s20_q;
  logic equal_3667_s20_q;
  logic equal_3668_s20_q;
  logic [7:0] select_3683_s20_q;
  logic equal_3797_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      pixel_0_s20_q <= sample_pair_pixel_0_q;
      pixel_1_s20_q <= sample_pair_pixel_1_q;
      saturated_s20_q <= saturated_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      sample_pair_pixel_0_s20_q <= sample_pair_pixel_0_s19_q;
      sample_pair_pixel_1_s20_q <= sample_pair_pixel_1_s19_q;
      sample_pair_whole_s20_q <= sample_pair_whole_s19_q;
      sample_present_s20_q <= sample_present_s19_q;
      x_s20_q <= x_s19_q;
      age_s20_q <= age_s19_q;
      slot_s20_q <= slot_s19_q;
      ends_cell_s20_q <= ends_cell_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      patches_band_rows_number_s20_q <= patches_band_rows_number_s19_q;
      patches_choosing_band_s20_q <= patches_choosing_band_s19_q;
      patches_lower_s20_q <= patches_lower_s19_q;
      patches_second_s20_q <= patches_second_s19_q;
      patches_code_row_s20_q <= patches_code_row_s19_q;
      patches_column_s20_q <= patches_column_s19_q;
      patches_match_row_ends_s20_q <= patches_match_row_ends_q;
      patches_down_by_s20_q <= patches_down_by_q;
      patches_along_s20_q <= patches_along_q;
      patches_match_row_s20_q <= patches_match_row_q;
      patches_summed_last_s20_q <= patches_summed_last_q;
      patches_step_s20_q <= patches_step_s19_q;
      patches_read_row_differing_s20_q <= patches_read_row_differing_s19_q;
      patches_read_first_s20_q <= patches_read_first_q;
      region_row_s20_q <= region_row_q;
      region_fresh_s20_q <= region_fresh_q;
      segment_started_s20_q <= segment_started_q;
      centres_values_1_textured_s20_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s20_q <= centres_values_1_of_skin_q;
      select_464_s20_q <= select_464_s19_q;
      select_467_s20_q <= select_467_s19_q;
      select_471_s20_q <= select_471_s19_q;
      and_477_s20_q <= and_477_s19_q;
      and_478_s20_q <= and_478_s19_q;
      sum_485_s20_q <= sum_485;
      sum_489_s20_q <= sum_489;
      and_493_s20_q <= whole & (averager_memory_rdata_s19_q[28] | equal_483_s19_q);
      and_497_s20_q <= and_497;
      column_s20_q <= column_s19_q;
      and_501_s20_q <= and_501_s19_q;
      and_503_s20_q <= and_503_s19_q;
      equal_506_s20_q <= select_464_s19_q == 4'h3;
      so_s20_q <= so_s19_q;
      equal_564_s20_q <= equal_564_s19_q;
      equal_1472_s20_q <= equal_1472_s19_q;
      not_1473_s20_q <= not_1473_s19_q;
      shift_2_s20_q <= {shift_2_s19_q[3], shift_2_s19_q[0]};
      equal_1517_s20_q <= equal_1517_s19_q;
      all_s20_q <= all;
      equal_1531_s20_q <= equal_1531;
      equal_1533_s20_q <= equal_1533;
      equal_1535_s20_q <= equal_1535;
      equal_1537_s20_q <= equal_1537;
      equal_1539_s20_q <= equal_1539;
      and_1544_s20_q <= (~equal_1531) & and_1543;
      right_2_s20_q <= right_2_s19_q;
      and_1585_s20_q <= and_1585_s19_q;
      and_1598_s20_q <= and_1598_s19_q;
      and_1611_s20_q <= and_1611_s19_q;
      less_1612_s20_q <= less_1612_s19_q;
      equal_1613_s20_q <= equal_1613_s19_q;
      sum_1620_s20_q <= sum_1620[1];
      sum_1624_s20_q <= sum_1624;
      equal_1634_s20_q <= equal_1634_s19_q;
      and_1644_s20_q <= and_1644_s19_q;
      select_1659_s20_q <= select_1659_s19_q;
      select_1684_s20_q <= select_1684_s19_q;
      and_1691_s20_q <= and_1691_s19_q;
      and_1692_s20_q <= and_1692_s19_q;
      equal_1693_s20_q <= equal_1693_s19_q;
      not_1694_s20_q <= not_1694_s19_q;
      equal_1695_s20_q <= equal_1695_s19_q;
      not_1696_s20_q <= not_1696_s19_q;
      equal_1697_s20_q <= equal_1697_s19_q;
      equal_1698_s20_q <= equal_1698_s19_q;
      or_1699_s20_q <= or_1699_s19_q;
      select_1723_s20_q <= select_1723_s19_q;
      select_1729_s20_q <= select_1729_s19_q;
      select_1768_s20_q <= select_1768_s19_q;
      patches_columns_above_rdata_s20_q <= {patches_columns_above_rdata_s19_q[24], patches_columns_above_rdata_s19_q[7:0]};
      pixel_2_s20_q <= pixel_2_s19_q;
      sum_1792_s20_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1806_s20_q <= sum_1806;
      sum_1807_s20_q <= sum_1807;
      sum_1818_s20_q <= sum_1818;
      less_1854_s20_q <= less_1854_s19_q;
      equal_1855_s20_q <= equal_1855_s19_q;
      not_1856_s20_q <= not_1856_s19_q;
      equal_1857_s20_q <= equal_1857_s19_q;
      not_1858_s20_q <= not_1858_s19_q;
      patches_rows_rdata_s20_q <= patches_rows_rdata_s19_q;
      or_1875_s20_q <= or_1875_s19_q;
      or_1878_s20_q <= or_1878_s19_q;
      or_1881_s20_q <= or_1881_s19_q;
      not_1883_s20_q <= not_1883;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained;
      and_1904_s20_q <= and_1904_s19_q;
      and_1909_s20_q <= not_1473_s19_q & and_1890_s19_q;
      and_1950_s20_q <= and_1950_s19_q;
      and_1951_s20_q <= seen_columns_rdata_s19_q[9] & shift_2_s19_q[0];
      sum_1955_s20_q <= sum_1955;
      or_1967_s20_q <= or_1967_s19_q;
      or_1970_s20_q <= or_1970_s19_q;
      or_1973_s20_q <= or_1973_s19_q;
      and_1984_s20_q <= and_1984_s19_q;
      sum_1990_s20_q <= {2'h0, and_1985} + {1'b0, sum_1989};
      and_2000_s20_q <= and_2000_s19_q;
      sum_2006_s20_q <= {2'h0, and_2001} + {1'b0, sum_2005};
      and_2023_s20_q <= and_2023_s19_q;
      equal_2163_s20_q <= equal_2163_s19_q;
      equal_2287_s20_q <= equal_2287_s19_q;
      and_2407_s20_q <= not_1473_s19_q & and_2406;
      not_2426_s20_q <= not_2426;
      and_2427_s20_q <= and_2427_s19_q;
      sum_2433_s20_q <= {2'h0, and_2428} + {1'b0, sum_2432};
      and_2469_s20_q <= not_1473_s19_q & (so_s19_q & and_2467);
      and_2476_s20_q <= not_1473_s19_q & (so_s19_q & (ends_cell_s19_q & and_2473));
      select_2527_s20_q <= select_2527;
      and_2755_s20_q <= and_2755_s19_q;
      select_3291_s20_q <= select_3291;
      equal_3309_s20_q <= equal_3309_s19_q;
      and_3312_s20_q <= and_3312;
      select_3344_s20_q <= select_3344;
      equal_3646_s20_q <= equal_3646;
      equal_3667_s20_q <= x_s19_q[6:3] == 4'h9;
      equal_3668_s20_q <= equal_3668;
      select_3683_s20_q <= select_3683;
      equal_3797_s20_q <= equal_3797_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [3:0] census_filled_q;
  logic [4:0] rows_passed_above_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic [10:0] registration_expected_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [4:0] patches_band_q;
  logic [1:0] patches_fetch_q;
  logic [4:0] patches_summed_down_by_q;
  logic [4:0] patches_read_at_q;
  logic [4:0] patches_peak_row_q;
  logic [2:0] box_explained_columns_values_0_q;
  logic [2:0] box_explained_columns_values_1_q;
  logic [2:0] box_explained_columns_values_2_q;
  logic [2:0] box_explained_columns_values_3_q;
  logic [2:0] box_explained_columns_values_4_q;
  logic [2:0] box_shown_columns_values_0_q;
  logic [2:0] box_shown_columns_values_1_q;
  logic [2:0] box_shown_columns_values_2_q;
  logic [2:0] box_shown_columns_values_3_q;
  logic [2:0] box_shown_columns_values_4_q;
  logic [2:0] box_nearer_columns_values_0_q;
  logic [2:0] box_nearer_columns_values_1_q;
  logic [2:0] box_nearer_columns_values_2_q;
  logic [2:0] box_nearer_columns_values_3_q;
  logic [2:0] box_nearer_columns_values_4_q;
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_477_s20_q ? sum_485_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_506_s20_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_477_s20_q ? sum_489_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_506_s20_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_514;
  assign and_514 = and_477_s20_q & and_493_s20_q;
  // hls/stages/census.hpp:126
  logic select_516;
  assign select_516 = equal_506_s20_q ? and_514 : (averager_mask_q & and_514);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s20_q & select_516;
  // hls/stages/census.hpp:206
  logic and_518;
  assign and_518 = and_477_s20_q & and_497_s20_q;
  // hls/stages/census.hpp:126
  logic select_520;
  assign select_520 = equal_506_s20_q ? and_518 : (averager_of_skin_q & and_518);
  // hls/stages/agreement.hpp:442
  logic equal_561;
  assign equal_561 = column_s20_q == 7'h0;
  logic [3:0] select_565;
  assign select_565 = equal_564_s20_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_566;
  assign select_566 = equal_561 ? {select_565, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_567;
  assign select_567 = equal_561 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s20_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1520;
  assign select_1520 = x_s20_q[4] ? {x_s20_q[3], x_s20_q[0]} : {x_s20_q[0], x_s20_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1522;
  assign select_1522 = equal_1517_s20_q ? {2'h0, quarter} : (all_s20_q ? {1'b0, x_s20_q[2:0]} : {x_s20_q[2:1], select_1520});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1523;
  assign sum_1523 = slot_s20_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:321
  logic [3:0] select_1524;
  assign select_1524 = equal_1472_s20_q ? select_1522 : {sum_1523, lower_half_s20_q, registration_of_right_q};
  // hls/stages/patches.hpp:192
  logic equal_1525;
  assign equal_1525 = x_s20_q[5:0] == 6'h3f;
  logic equal_1527;
  assign equal_1527 = x_s20_q[5:0] == 6'h3e;
  logic equal_1529;
  assign equal_1529 = x_s20_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1116
  logic and_1547;
  assign and_1547 = (~equal_1525) & ((~equal_1527) & ((~equal_1529) & and_1544_s20_q));
  // hls/stages/agreement.hpp:1071
  logic less_1548;
  assign less_1548 = x_s20_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s20_q ? {1'b0, x_s20_q[2]} : x_s20_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1552;
  assign or_1552 = (kind == 2'h3) | (x_s20_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s20_q[0] ? (right_2_s20_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1563;
  assign sum_1563 = {2'h0, slot_s20_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1569;
  assign not_1569 = ~lower_half_s20_q;
  logic [3:0] select_1570;
  assign select_1570 = registration_of_right_q ? {lower_half_s20_q, 1'b0, not_1569, 1'b0} : {1'b0, lower_half_s20_q, 1'b0, not_1569};
  // hls/stages/patches.hpp:354
  logic [1:0] select_1599;
  assign select_1599 = and_1598_s20_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1600;
  assign select_1600 = and_1598_s20_q ? patches_band_rows_number_s20_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1601;
  assign select_1601 = and_1585_s20_q ? {select_1600, select_1599[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:109
  logic [1:0] select_1602;
  assign select_1602 = and_1585_s20_q ? select_1599 : patches_fetch_q;
  logic equal_1603;
  assign equal_1603 = select_1602 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1613_s20_q ? {sum_1624_s20_q, sum_1620_s20_q} : registration_expected_q;
  // hls/stages/patches.hpp:109
  logic [4:0] select_1706;
  assign select_1706 = and_1585_s20_q ? select_1600 : patches_band_q;
  // hls/stages/patches.hpp:334
  logic equal_1707;
  assign equal_1707 = {patches_choosing_band_s20_q, and_1611_s20_q} == {select_1706, select_1602[1]};
  // hls/stages/patches.hpp:477
  logic less_1784;
  assign less_1784 = 5'he < patches_along_s20_q;
  // hls/stages/patches.hpp:478
  logic or_1785;
  assign or_1785 = equal_1697_s20_q | less_1784;
  // hls/stages/patches.hpp:481
  logic new_row;
  assign new_row = patches_along_s20_q == 5'h0;
  logic select_1790;
  assign select_1790 = equal_1697_s20_q ? patches_column_s20_q[0] : (or_1785 ? (patches_along_s20_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:479
  logic [4:0] select_1793;
  assign select_1793 = patches_match_row_ends_s20_q ? patches_down_by_s20_q : sum_1792_s20_q;
  // hls/stages/patches.hpp:482
  logic [4:0] select_1796;
  assign select_1796 = equal_1697_s20_q ? 5'h0 : (or_1785 ? (select_1793 + 5'h1) : sum_1792_s20_q);
  // hls/stages/patches.hpp:458
  logic equal_1799;
  assign equal_1799 = patches_column_s20_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s20_q == 5'h11;
  logic equal_1801;
  assign equal_1801 = patches_column_s20_q == 5'h18;
  // hls/stages/patches.hpp:460
  logic and_1803;
  assign and_1803 = of_row & (~equal_1801);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1799 ? 2'h3 : {equal_1801, and_1803};
  // hls/stages/patches.hpp:446
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1806_s20_q, pixel_2_s20_q[0]} - {1'b0, sum_1807_s20_q, patches_columns_above_rdata_s20_q[8]};
  // hls/stages/patches.hpp:444
  logic [9:0] sum_1819;
  assign sum_1819 = {2'h0, patches_columns_above_rdata_s20_q[7:0]} + sum_1818_s20_q[10:1];
  // hls/stages/patches.hpp:459
  logic or_1829;
  assign or_1829 = (((patches_column_s20_q == 5'ha) | of_row) | equal_1801) | equal_1799;
  // hls/stages/patches.hpp:454
  logic and_1834;
  assign and_1834 = (~(patches_code_row_s20_q[4:2] == 3'h0)) & (~(patches_column_s20_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:155
  logic and_1848;
  assign and_1848 = (~(equal_1698_s20_q | (~and_1834))) & (~patches_column_s20_q[4]);
  // hls/stages/agreement.hpp:1029
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1950_s20_q} + ({2'h0, and_1951_s20_q} + {1'b0, sum_1955_s20_q});
  // hls/stages/agreement.hpp:1031
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1984_s20_q} + sum_1990_s20_q;
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1992;
  assign select_1992 = age_s20_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1032
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2000_s20_q} + sum_2006_s20_q;
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_2008;
  assign select_2008 = age_s20_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2055;
  assign select_2055 = sample_pair_whole_s20_q ? (and_501_s20_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2057;
  assign select_2057 = sample_pair_whole_s20_q ? (and_501_s20_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2078;
  assign select_2078 = sample_pair_whole_s20_q ? (and_501_s20_q ? select_516 : averager_mask_q) : averager_mask_q;
  logic select_2080;
  assign select_2080 = sample_pair_whole_s20_q ? (and_501_s20_q ? select_520 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic and_2403;
  assign and_2403 = and_503_s20_q & (equal_564_s20_q & equal_2287_s20_q);
  // hls/stages/patches.hpp:321
  logic and_2412;
  assign and_2412 = not_1473_s20_q & (so_s20_q & (ends_cell_s20_q & textured_s20_q));
  // hls/stages/agreement.hpp:1030
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2427_s20_q} + sum_2433_s20_q;
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2435;
  assign select_2435 = age_s20_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2471;
  assign select_2471 = and_2403 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2469_s20_q});
  logic [13:0] select_2478;
  assign select_2478 = and_2403 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2476_s20_q});
  // hls/stages/patches.hpp:321
  logic [10:0] select_2514;
  assign select_2514 = equal_1472_s20_q ? registration_expected_q : (so_s20_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2515;
  assign equal_2515 = slot_s20_q == 3'h4;
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2527_s20_q[7]}}, select_2527_s20_q} - {sum_1624_s20_q[9], sum_1624_s20_q, sum_1620_s20_q};
  // hls/stages/patches.hpp:321
  logic select_2574;
  assign select_2574 = so_s20_q ? (equal_2515 ? right_2_s20_q : registration_of_right_q) : registration_of_right_q;
  logic select_2577;
  assign select_2577 = so_s20_q ? (equal_1613_s20_q ? shift_2_s20_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all_s20_q ? x_s20_q[1:0] : select_1520;
  // hls/stages/patches.hpp:335
  logic not_2771;
  assign not_2771 = ~select_1602[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2773;
  assign select_2773 = sample_pair_whole_s20_q ? (equal_1603 ? select_1602 : {not_2771, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:167
  logic [4:0] select_3268;
  assign select_3268 = equal_1695_s20_q ? patches_down_by_s20_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:517
  logic [4:0] select_3313;
  assign select_3313 = and_3312_s20_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:524
  logic [5:0] away;
  assign away = {1'b0, patches_step_s20_q} - {1'b0, select_3313};
  // hls/stages/agreement.hpp:1154
  logic equal_3465;
  assign equal_3465 = x_s20_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1148
  logic equal_3665;
  assign equal_3665 = x_s20_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1067
  logic [7:0] limit;
  assign limit = equal_3665 ? cfg_regions_limit_i : (equal_3667_s20_q ? cfg_hidden_limit_i : select_3683_s20_q);
  // hls/stages/agreement.hpp:1161
  logic not_3686;
  assign not_3686 = ~x_s20_q[2];
  logic [3:0] select_3687;
  assign select_3687 = x_s20_q[1] ? {x_s20_q[2], 1'b0, not_3686, 1'b0} : {1'b0, x_s20_q[2], 1'b0, not_3686};
  logic [7:0] select_3688;
  assign select_3688 = x_s20_q[0] ? {select_3687[3], 1'b0, select_3687[2], 1'b0, select_3687[1], 1'b0, select_3687[0], 1'b0} : {1'b0, select_3687[3], 1'b0, select_3687[2], 1'b0, select_3687[1], 1'b0, select_3687[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3692;
  assign select_3692 = equal_3667_s20_q ? counts_skin_supervised_q : (equal_3668_s20_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3665 ? counts_textured_q : select_3692;
  // hls/stages/patches.hpp:321
  logic [2:0] select_3731;
  assign select_3731 = so_s20_q ? (ends_cell_s20_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3732;
  assign select_3732 = equal_1472_s20_q ? box_explained_columns_values_0_q : select_3731;
  logic [2:0] select_3733;
  assign select_3733 = ends_cell_s20_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3735;
  assign select_3735 = equal_1472_s20_q ? box_explained_columns_values_1_q : (so_s20_q ? select_3733 : box_explained_columns_values_1_q);
  logic [2:0] select_3736;
  assign select_3736 = ends_cell_s20_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3738;
  assign select_3738 = equal_1472_s20_q ? box_explained_columns_values_2_q : (so_s20_q ? select_3736 : box_explained_columns_values_2_q);
  logic [2:0] select_3739;
  assign select_3739 = ends_cell_s20_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3741;
  assign select_3741 = equal_1472_s20_q ? box_explained_columns_values_3_q : (so_s20_q ? select_3739 : box_explained_columns_values_3_q);
  logic [2:0] select_3742;
  assign select_3742 = ends_cell_s20_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3744;
  assign select_3744 = equal_1472_s20_q ? box_explained_columns_values_4_q : (so_s20_q ? select_3742 : box_explained_columns_values_4_q);
  logic [2:0] select_3749;
  assign select_3749 = so_s20_q ? (ends_cell_s20_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3751;
  assign select_3751 = ends_cell_s20_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3753;
  assign select_3753 = equal_1472_s20_q ? box_shown_columns_values_1_q : (so_s20_q ? select_3751 : box_shown_columns_values_1_q);
  logic [2:0] select_3754;
  assign select_3754 = ends_cell_s20_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3756;
  assign select_3756 = equal_1472_s20_q ? box_shown_columns_values_2_q : (so_s20_q ? select_3754 : box_shown_columns_values_2_q);
  logic [2:0] select_3757;
  assign select_3757 = ends_cell_s20_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3759;
  assign select_3759 = equal_1472_s20_q ? box_shown_columns_values_3_q : (so_s20_q ? select_3757 : box_shown_columns_values_3_q);
  logic [2:0] select_3760;
  assign select_3760 = ends_cell_s20_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3762;
  assign select_3762 = equal_1472_s20_q ? box_shown_columns_values_4_q : (so_s20_q ? select_3760 : box_shown_columns_values_4_q);
  logic [2:0] select_3767;
  assign select_3767 = so_s20_q ? (ends_cell_s20_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3769;
  assign select_3769 = ends_cell_s20_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3771;
  assign select_3771 = equal_1472_s20_q ? box_nearer_columns_values_1_q : (so_s20_q ? select_3769 : box_nearer_columns_values_1_q);
  logic [2:0] select_3772;
  assign select_3772 = ends_cell_s20_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3774;
  assign select_3774 = equal_1472_s20_q ? box_nearer_columns_values_2_q : (so_s20_q ? select_3772 : box_nearer_columns_values_2_q);
  logic [2:0] select_3775;
  assign select_3775 = ends_cell_s20_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3777;
  assign select_3777 = equal_1472_s20_q ? box_nearer_columns_values_3_q : (so_s20_q ? select_3775 : box_nearer_columns_values_3_q);
  logic [2:0] select_3778;
  assign select_3778 = ends_cell_s20_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3780;
  assign select_3780 = equal_1472_s20_q ? box_nearer_columns_values_4_q : (so_s20_q ? select_3778 : box_nearer_columns_values_4_q);

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_471_s20_q;
  logic averager_memory_we;
  assign averager_memory_we = s20_en & and_478_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_497_s20_q, and_493_s20_q, sum_489_s20_q, sum_485_s20_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s18_sim;
  logic averager_memory_re_s18_sim;
  logic [8:0] averager_memory_raddr_s19_sim;
  logic averager_memory_re_s19_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s18_sim <= 1'b0;
      averager_memory_re_s19_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s18_sim <= averager_memory_re;
      averager_memory_raddr_s18_sim <= averager_memory_raddr;
      averager_memory_re_s19_sim <= averager_memory_re_s18_sim;
      averager_memory_raddr_s19_sim <= averager_memory_raddr_s18_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s18_sim && averager_memory_raddr_s18_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s19_sim && averager_memory_raddr_s19_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_textured_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
      registration_expected_q <= 11'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      patches_band_q <= 5'h0;
      patches_fetch_q <= 2'h0;
      patches_summed_down_by_q <= 5'h0;
      patches_read_at_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
    end else if (s20_en) begin
      averager_mask_q <= select_2078;
      averager_of_skin_q <= select_2080;
      census_filled_q <= and_503_s20_q ? {select_567[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_503_s20_q ? select_566 : rows_passed_above_q;
      counts_textured_q <= and_2403 ? 14'h0 : (counts_textured_q + {13'h0, and_2412});
      counts_skin_supervised_q <= select_2471;
      counts_skin_textured_q <= select_2478;
      registration_expected_q <= select_2514;
      registration_of_right_q <= equal_1472_s20_q ? registration_of_right_q : select_2574;
      registration_was_inside_q <= equal_1472_s20_q ? registration_was_inside_q : select_2577;
      patches_band_q <= sample_pair_whole_s20_q ? select_1706 : patches_band_q;
      patches_fetch_q <= select_2773;
      patches_summed_down_by_q <= equal_1693_s20_q ? patches_summed_down_by_q : select_3268;
      patches_read_at_q <= equal_1693_s20_q ? select_3291_s20_q : patches_read_at_q;
      patches_peak_row_q <= equal_1693_s20_q ? select_3313 : patches_peak_row_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
    box_explained_columns_values_0_q = 3'h0;
    box_explained_columns_values_1_q = 3'h0;
    box_explained_columns_values_2_q = 3'h0;
    box_explained_columns_values_3_q = 3'h0;
    box_explained_columns_values_4_q = 3'h0;
    box_shown_columns_values_0_q = 3'h0;
    box_shown_columns_values_1_q = 3'h0;
    box_shown_columns_values_2_q = 3'h0;
    box_shown_columns_values_3_q = 3'h0;
    box_shown_columns_values_4_q = 3'h0;
    box_nearer_columns_values_0_q = 3'h0;
    box_nearer_columns_values_1_q = 3'h0;
    box_nearer_columns_values_2_q = 3'h0;
    box_nearer_columns_values_3_q = 3'h0;
    box_nearer_columns_values_4_q = 3'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s20_en) begin
      averager_total_0_q <= select_2055;
      averager_total_1_q <= select_2057;
      box_explained_columns_values_0_q <= select_3732;
      box_explained_columns_values_1_q <= select_3735;
      box_explained_columns_values_2_q <= select_3738;
      box_explained_columns_values_3_q <= select_3741;
      box_explained_columns_values_4_q <= select_3744;
      box_shown_columns_values_0_q <= equal_1472_s20_q ? box_shown_columns_values_0_q : select_3749;
      box_shown_columns_values_1_q <= select_3753;
      box_shown_columns_values_2_q <= select_3756;
      box_shown_columns_values_3_q <= select_3759;
      box_shown_columns_values_4_q <= select_3762;
      box_nearer_columns_values_0_q <= equal_1472_s20_q ? box_nearer_columns_values_0_q : select_3767;
      box_nearer_columns_values_1_q <= select_3771;
      box_nearer_columns_values_2_q <= select_3774;
      box_nearer_columns_values_3_q <= select_3777;
      box_nearer_columns_values_4_q <= select_3780;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
  logic mask_s21_q;
  logic marks_first_s21_q;
  logic marks_last_s21_q;
  logic [7:0] sample_pair_pixel_0_s21_q;
  logic [7:0] sample_pair_pixel_1_s21_q;
  logic sample_pair_whole_s21_q;
  logic sample_present_s21_q;
  logic [7:0] x_s21_q;
  logic age_s21_q;
  logic [2:0] slot_s21_q;
  logic ends_cell_s21_q;
  logic lower_half_s21_q;
  logic [13:0] counts_textured_s21_q;
  logic registration_of_right_s21_q;
  logic [4:0] patches_choosing_band_s21_q;
  logic patches_lower_s21_q;
  logic patches_second_s21_q;
  logic [4:0] patches_code_row_s21_q;
  logic [4:0] patches_along_s21_q;
  logic [3:0] patches_match_row_s21_q;
  logic patches_summed_last_s21_q;
  logic [4:0] patches_summed_down_by_s21_q;
  logic [9:0] patches_read_row_differing_s21_q;
  logic patches_read_first_s21_q;
  logic [2:0] region_row_s21_q;
  logic region_fresh_s21_q;
  logic segment_started_s21_q;
  logic centres_values_1_textured_s21_q;
  logic centres_values_1_of_skin_s21_q;
  logic [3:0] select_464_s21_q;
  logic [6:0] select_467_s21_q;
  logic [6:0] column_s21_q;
  logic and_501_s21_q;
  logic and_503_s21_q;
  logic [77:0] census_memory_rdata_s21_q;
  logic [8:0] grey_s21_q;
  logic equal_506_s21_q;
  logic [8:0] select_509_s21_q;
  logic [8:0] grey_2_s21_q;
  logic [8:0] select_513_s21_q;
  logic whole_2_s21_q;
  logic and_521_s21_q;
  logic so_s21_q;
  logic and_568_s21_q;
  logic equal_1472_s21_q;
  logic not_1473_s21_q;
  logic [1:0] shift_2_s21_q;
  logic equal_1517_s21_q;
  logic [1:0] quarter_s21_q;
  logic all_s21_q;
  logic [1:0] sum_1523_s21_q;
  logic [3:0] select_1524_s21_q;
  logic equal_1525_s21_q;
  logic equal_1527_s21_q;
  logic equal_1529_s21_q;
  logic equal_1531_s21_q;
  logic equal_1533_s21_q;
  logic equal_1535_s21_q;
  logic equal_1537_s21_q;
  logic equal_1539_s21_q;
  logic less_1548_s21_q;
  logic or_1552_s21_q;
  logic select_1555_s21_q;
  logic and_1565_s21_q;
  logic [3:0] select_1570_s21_q;
  logic and_1585_s21_q;
  logic [5:0] select_1601_s21_q;
  logic select_1602_s21_q;
  logic equal_1603_s21_q;
  logic and_1611_s21_q;
  logic less_1612_s21_q;
  logic equal_1613_s21_q;
  logic expected_s21_q;
  logic [10:0] sum_1626_s21_q;
  logic equal_1634_s21_q;
  logic and_1644_s21_q;
  logic [5:0] select_1659_s21_q;
  logic [7:0] select_1684_s21_q;
  logic and_1691_s21_q;
  logic and_1692_s21_q;
  logic equal_1693_s21_q;
  logic not_1694_s21_q;
  logic equal_1695_s21_q;
  logic not_1696_s21_q;
  logic equal_1698_s21_q;
  logic or_1699_s21_q;
  logic and_1708_s21_q;
  logic [4:0] select_1723_s21_q;
  logic select_1729_s21_q;
  logic [3:0] select_1768_s21_q;
  logic patches_columns_above_rdata_s21_q;
  logic [7:0] pixel_2_s21_q;
  logic less_1784_s21_q;
  logic new_row_s21_q;
  logic select_1790_s21_q;
  logic not_1791_s21_q;
  logic [4:0] select_1796_s21_q;
  logic or_1797_s21_q;
  logic [1:0] of_row_2_s21_q;
  logic [10:0] down_2_s21_q;
  logic sum_1818_s21_q;
  logic [9:0] sum_1819_s21_q;
  logic and_1837_s21_q;
  logic and_1848_s21_q;
  logic and_1851_s21_q;
  logic less_1854_s21_q;
  logic equal_1855_s21_q;
  logic not_1856_s21_q;
  logic equal_1857_s21_q;
  logic not_1858_s21_q;
  logic [9:0] patches_rows_rdata_s21_q;
  logic or_1875_s21_q;
  logic or_1878_s21_q;
  logic or_1881_s21_q;
  logic not_1883_s21_q;
  logic [29:0] regions_rdata_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1904_s21_q;
  logic and_1909_s21_q;
  logic [2:0] textured_2_s21_q;
  logic or_1967_s21_q;
  logic or_1970_s21_q;
  logic or_1973_s21_q;
  logic [3:0] difference_1993_s21_q;
  logic [3:0] difference_2009_s21_q;
  logic and_2023_s21_q;
  logic equal_2163_s21_q;
  logic equal_2287_s21_q;
  logic and_2403_s21_q;
  logic and_2407_s21_q;
  logic and_2412_s21_q;
  logic not_2426_s21_q;
  logic [3:0] difference_2436_s21_q;
  logic and_2518_s21_q;
  logic [11:0] select_2530_s21_q;
  logic equal_2579_s21_q;
  logic [3:0] not_2580_s21_q;
  logic [1:0] quarter_2_s21_q;
  logic and_2755_s21_q;
  logic less_2882_s21_q;
  logic equal_3309_s21_q;
  logic [4:0] select_3313_s21_q;
  logic [5:0] away_s21_q;
  logic equal_3315_s21_q;
  logic equal_3324_s21_q;
  logic [14:0] select_3344_s21_q;
  logic equal_3465_s21_q;
  logic and_3647_s21_q;
  logic equal_3665_s21_q;
  logic equal_3667_s21_q;
  logic equal_3668_s21_q;
  logic equal_3690_s21_q;
  logic [13:0] of_s21_q;
  logic equal_3797_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= sample_of_skin_q;
      marks_first_s21_q <= marks_first_s20_q;
      marks_last_s21_q <= marks_last_s20_q;
      sample_pair_pixel_0_s21_q <= sample_pair_pixel_0_s20_q;
      sample_pair_pixel_1_s21_q <= sample_pair_pixel_1_s20_q;
      sample_pair_whole_s21_q <= sample_pair_whole_s20_q;
      sample_present_s21_q <= sample_present_s20_q;
      x_s21_q <= x_s20_q;
      age_s21_q <= age_s20_q;
      slot_s21_q <= slot_s20_q;
      ends_cell_s21_q <= ends_cell_s20_q;
      lower_half_s21_q <= lower_half_s20_q;
      counts_textured_s21_q <= counts_textured_q;
      registration_of_right_s21_q <= registration_of_right_q;
      patches_choosing_band_s21_q <= patches_choosing_band_s20_q;
      patches_lower_s21_q <= patches_lower_s20_q;
      patches_second_s21_q <= patches_second_s20_q;
      patches_code_row_s21_q <= patches_code_row_s20_q;
      patches_along_s21_q <= patches_along_s20_q;
      patches_match_row_s21_q <= patches_match_row_s20_q;
      patches_summed_last_s21_q <= patches_summed_last_s20_q;
      patches_summed_down_by_s21_q <= patches_summed_down_by_q;
      patches_read_row_differing_s21_q <= patches_read_row_differing_s20_q;
      patches_read_first_s21_q <= patches_read_first_s20_q;
      region_row_s21_q <= region_row_s20_q;
      region_fresh_s21_q <= region_fresh_s20_q;
      segment_started_s21_q <= segment_started_s20_q;
      centres_values_1_textured_s21_q <= centres_values_1_textured_s20_q;
      centres_values_1_of_skin_s21_q <= centres_values_1_of_skin_s20_q;
      select_464_s21_q <= select_464_s20_q;
      select_467_s21_q <= select_467_s20_q;
      column_s21_q <= column_s20_q;
      and_501_s21_q <= and_501_s20_q;
      and_503_s21_q <= and_503_s20_q;
      census_memory_rdata_s21_q <= census_memory_rdata_q;
      grey_s21_q <= grey;
      equal_506_s21_q <= equal_506_s20_q;
      select_509_s21_q <= sample_pair_whole_s20_q ? total[10:2] : 9'h0;
      grey_2_s21_q <= grey_2;
      select_513_s21_q <= sample_pair_whole_s20_q ? total_2[10:2] : 9'h0;
      whole_2_s21_q <= whole_2;
      and_521_s21_q <= sample_pair_whole_s20_q & select_520;
      so_s21_q <= so_s20_q;
      and_568_s21_q <= select_566[4] & select_567[3];
      equal_1472_s21_q <= equal_1472_s20_q;
      not_1473_s21_q <= not_1473_s20_q;
      shift_2_s21_q <= shift_2_s20_q;
      equal_1517_s21_q <= equal_1517_s20_q;
      quarter_s21_q <= quarter;
      all_s21_q <= all_s20_q;
      sum_1523_s21_q <= sum_1523;
      select_1524_s21_q <= select_1524;
      equal_1525_s21_q <= equal_1525;
      equal_1527_s21_q <= equal_1527;
      equal_1529_s21_q <= equal_1529;
      equal_1531_s21_q <= equal_1531_s20_q;
      equal_1533_s21_q <= equal_1533_s20_q;
      equal_1535_s21_q <= equal_1535_s20_q;
      equal_1537_s21_q <= equal_1537_s20_q;
      equal_1539_s21_q <= equal_1539_s20_q;
      less_1548_s21_q <= less_1548;
      or_1552_s21_q <= or_1552;
      select_1555_s21_q <= equal_1517_s20_q ? and_1547 : (less_1548 & (~or_1552));
      and_1565_s21_q <= half_ends & ({{3{sum_1563[4]}}, sum_1563} < 8'h3);
      select_1570_s21_q <= select_1570;
      and_1585_s21_q <= and_1585_s20_q;
      select_1601_s21_q <= select_1601;
      select_1602_s21_q <= select_1602[1];
      equal_1603_s21_q <= equal_1603;
      and_1611_s21_q <= and_1611_s20_q;
      less_1612_s21_q <= less_1612_s20_q;
      equal_1613_s21_q <= equal_1613_s20_q;
      expected_s21_q <= expected[0];
      sum_1626_s21_q <= {expected[10], expected[10:1]} + 11'h5;
      equal_1634_s21_q <= equal_1634_s20_q;
      and_1644_s21_q <= and_1644_s20_q;
      select_1659_s21_q <= select_1659_s20_q;
      select_1684_s21_q <= select_1684_s20_q;
      and_1691_s21_q <= and_1691_s20_q;
      and_1692_s21_q <= and_1692_s20_q;
      equal_1693_s21_q <= equal_1693_s20_q;
      not_1694_s21_q <= not_1694_s20_q;
      equal_1695_s21_q <= equal_1695_s20_q;
      not_1696_s21_q <= not_1696_s20_q;
      equal_1698_s21_q <= equal_1698_s20_q;
      or_1699_s21_q <= or_1699_s20_q;
      and_1708_s21_q <= and_1692_s20_q & equal_1707;
      select_1723_s21_q <= select_1723_s20_q;
      select_1729_s21_q <= select_1729_s20_q;
      select_1768_s21_q <= select_1768_s20_q;
      patches_columns_above_rdata_s21_q <= patches_columns_above_rdata_s20_q[8];
      pixel_2_s21_q <= pixel_2_s20_q;
      less_1784_s21_q <= less_1784;
      new_row_s21_q <= new_row;
      select_1790_s21_q <= select_1790;
      not_1791_s21_q <= ~or_1785;
      select_1796_s21_q <= select_1796;
      or_1797_s21_q <= equal_1697_s20_q | equal_1695_s20_q;
      of_row_2_s21_q <= of_row_2;
      down_2_s21_q <= down_2;
      sum_1818_s21_q <= sum_1818_s20_q[0];
      sum_1819_s21_q <= sum_1819;
      and_1837_s21_q <= or_1699_s20_q & (or_1829 & (equal_1698_s20_q & and_1834));
      and_1848_s21_q <= and_1848;
      and_1851_s21_q <= or_1699_s20_q & (and_1848 & (patches_column_s20_q == 5'hf));
      less_1854_s21_q <= less_1854_s20_q;
      equal_1855_s21_q <= equal_1855_s20_q;
      not_1856_s21_q <= not_1856_s20_q;
      equal_1857_s21_q <= equal_1857_s20_q;
      not_1858_s21_q <= not_1858_s20_q;
      patches_rows_rdata_s21_q <= patches_rows_rdata_s20_q;
      or_1875_s21_q <= or_1875_s20_q;
      or_1878_s21_q <= or_1878_s20_q;
      or_1881_s21_q <= or_1881_s20_q;
      not_1883_s21_q <= not_1883_s20_q;
      regions_rdata_s21_q <= regions_rdata_q;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1904_s21_q <= and_1904_s20_q;
      and_1909_s21_q <= and_1909_s20_q;
      textured_2_s21_q <= textured_2;
      or_1967_s21_q <= or_1967_s20_q;
      or_1970_s21_q <= or_1970_s20_q;
      or_1973_s21_q <= or_1973_s20_q;
      difference_1993_s21_q <= {1'b0, shown_2} - {1'b0, select_1992};
      difference_2009_s21_q <= {1'b0, near_2} - {1'b0, select_2008};
      and_2023_s21_q <= and_2023_s20_q;
      equal_2163_s21_q <= equal_2163_s20_q;
      equal_2287_s21_q <= equal_2287_s20_q;
      and_2403_s21_q <= and_2403;
      and_2407_s21_q <= and_2407_s20_q;
      and_2412_s21_q <= and_2412;
      not_2426_s21_q <= not_2426_s20_q;
      difference_2436_s21_q <= {1'b0, explained_2} - {1'b0, select_2435};
      and_2518_s21_q <= not_1473_s20_q & (so_s20_q & (half_ends & equal_2515));
      select_2530_s21_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2579_s21_q <= sum_1523 == 2'h2;
      not_2580_s21_q <= ~select_1570;
      quarter_2_s21_q <= quarter_2;
      and_2755_s21_q <= and_2755_s20_q;
      less_2882_s21_q <= 4'he < patches_column_s20_q[4:1];
      equal_3309_s21_q <= equal_3309_s20_q;
      select_3313_s21_q <= select_3313;
      away_s21_q <= away;
      equal_3315_s21_q <= away == 6'h3f;
      equal_3324_s21_q <= away == 6'h1;
      select_3344_s21_q <= select_3344_s20_q;
      equal_3465_s21_q <= equal_3465;
      and_3647_s21_q <= equal_3646_s20_q & equal_3465;
      equal_3665_s21_q <= equal_3665;
      equal_3667_s21_q <= equal_3667_s20_q;
      equal_3668_s21_q <= equal_3668_s20_q;
      equal_3690_s21_q <= (limit & select_3688) == 8'h0;
      of_s21_q <= of;
      equal_3797_s21_q <= equal_3797_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_quarter_1_0_q;
  logic [8:0] averager_quarter_1_1_q;
  logic [8:0] averager_quarter_2_0_q;
  logic [8:0] averager_quarter_2_1_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
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
  logic [8:0] census_columns_values_1_cell_1_left_q;
  logic [8:0] census_columns_values_1_cell_1_right_q;
  logic [8:0] census_columns_values_1_cell_2_left_q;
  logic [8:0] census_columns_values_1_cell_2_right_q;
  logic census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] census_columns_values_1_cell_3_left_q;
  logic [8:0] census_columns_values_1_cell_3_right_q;
  logic [8:0] census_columns_values_1_cell_4_left_q;
  logic [8:0] census_columns_values_1_cell_4_right_q;
  logic [8:0] census_columns_values_2_cell_0_left_q;
  logic [8:0] census_columns_values_2_cell_0_right_q;
  logic [8:0] census_columns_values_2_cell_1_left_q;
  logic [8:0] census_columns_values_2_cell_1_right_q;
  logic [8:0] census_columns_values_2_cell_2_left_q;
  logic [8:0] census_columns_values_2_cell_2_right_q;
  logic [8:0] census_columns_values_2_cell_3_left_q;
  logic [8:0] census_columns_values_2_cell_3_right_q;
  logic [8:0] census_columns_values_2_cell_4_left_q;
  logic [8:0] census_columns_values_2_cell_4_right_q;
  logic [8:0] census_columns_values_3_cell_1_left_q;
  logic [8:0] census_columns_values_3_cell_1_right_q;
  logic [8:0] census_columns_values_3_cell_3_left_q;
  logic [8:0] census_columns_values_3_cell_3_right_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [13:0] counts_explained_q;
  logic [3:0] registration_fresh_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic [13:0] product_q;
  logic [2:0] box_textured_columns_values_0_q;
  logic [2:0] box_textured_columns_values_1_q;
  logic [2:0] box_textured_columns_values_2_q;
  logic [2:0] box_textured_columns_values_3_q;
  logic [2:0] box_textured_columns_values_4_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic [12:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/census.hpp:294
  logic less_537;
  assign less_537 = census_memory_rdata_s21_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_538;
  assign less_538 = census_memory_rdata_s21_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_540;
  assign less_540 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_541;
  assign less_541 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_542;
  assign less_542 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_543;
  assign less_543 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_544;
  assign less_544 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_545;
  assign less_545 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_546;
  assign less_546 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_547;
  assign less_547 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_548;
  assign less_548 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_549;
  assign less_549 = census_memory_rdata_s21_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_550;
  assign less_550 = census_memory_rdata_s21_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_552;
  assign less_552 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_553;
  assign less_553 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_554;
  assign less_554 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_555;
  assign less_555 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_556;
  assign less_556 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_557;
  assign less_557 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_558;
  assign less_558 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_559;
  assign less_559 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_560;
  assign less_560 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:286
  logic and_570;
  assign and_570 = census_memory_rdata_s21_q[38] & (census_memory_rdata_s21_q[18] & whole_2_s21_q);
  logic and_572;
  assign and_572 = census_memory_rdata_s21_q[77] & (census_memory_rdata_s21_q[58] & and_570);
  // hls/stages/census.hpp:270
  logic [9:0] difference_595;
  assign difference_595 = {1'b0, select_509_s21_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_598;
  assign difference_598 = {1'b0, census_memory_rdata_s21_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_602;
  assign difference_602 = {1'b0, census_memory_rdata_s21_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_606;
  assign difference_606 = {1'b0, census_memory_rdata_s21_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_610;
  assign difference_610 = {1'b0, census_memory_rdata_s21_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/patches.hpp:321
  logic and_1566;
  assign and_1566 = so_s21_q & and_1565_s21_q;
  // hls/stages/patches.hpp:81
  logic less_1627;
  assign less_1627 = {{4{sum_1626_s21_q[10]}}, sum_1626_s21_q, expected_s21_q} < 16'h15;
  // hls/stages/patches.hpp:94
  logic and_1645;
  assign and_1645 = (less_1612_s21_q & (shift_2_s21_q[1] & less_1627)) & and_1644_s21_q;
  // hls/stages/patches.hpp:448
  logic [11:0] sum_1809;
  assign sum_1809 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1810;
  assign sum_1810 = {{4{down_2_s21_q[10]}}, down_2_s21_q[10:2]} + {sum_1809[11], sum_1809};
  // hls/stages/patches.hpp:445
  logic [11:0] smooth;
  assign smooth = {sum_1819_s21_q, sum_1818_s21_q, patches_columns_above_rdata_s21_q} + {4'h0, pixel_2_s21_q};
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1894;
  assign select_1894 = segment_started_s21_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1895;
  assign sum_1895 = {6'h0, textured_s21_q} + select_1894;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1897;
  assign sum_1897 = {3'h0, sum_1895} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1899;
  assign select_1899 = segment_started_s21_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1900;
  assign sum_1900 = {6'h0, explained_s21_q} + select_1899;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1902;
  assign sum_1902 = {3'h0, sum_1900} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1905;
  assign select_1905 = segment_started_s21_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_1906;
  assign sum_1906 = {6'h0, and_1904_s21_q} + select_1905;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_1908;
  assign sum_1908 = {3'h0, sum_1906} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[29:20]);
  // hls/stages/agreement.hpp:1202
  logic or_1918;
  assign or_1918 = marks_first_s21_q | line_ended_q;
  // hls/stages/agreement.hpp:1204
  logic [12:0] select_1920;
  assign select_1920 = marks_first_s21_q ? 13'h1 : (or_1918 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1203
  logic [8:0] select_1922;
  assign select_1922 = or_1918 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1211
  logic select_1924;
  assign select_1924 = cfg_compete_i ? (or_1918 & select_1920[12]) : (select_1922[8] & select_1920[9]);
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_1958;
  assign select_1958 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1038
  logic [4:0] around;
  assign around = {difference_1993_s21_q[3], difference_1993_s21_q} + (equal_1634_s21_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1039
  logic [4:0] n;
  assign n = {difference_2009_s21_q[3], difference_2009_s21_q} + (equal_1634_s21_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2047;
  assign select_2047 = sample_pair_whole_s21_q ? (and_501_s21_q ? grey_s21_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2049;
  assign select_2049 = sample_pair_whole_s21_q ? (and_501_s21_q ? grey_2_s21_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2051;
  assign select_2051 = sample_pair_whole_s21_q ? (and_501_s21_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2053;
  assign select_2053 = sample_pair_whole_s21_q ? (and_501_s21_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2058;
  assign sum_2058 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s21_q};
  logic [9:0] sum_2066;
  assign sum_2066 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s21_q};
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2081;
  assign select_2081 = and_503_s21_q ? select_509_s21_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2082;
  assign select_2082 = and_503_s21_q ? select_513_s21_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2084;
  assign select_2084 = and_503_s21_q ? census_memory_rdata_s21_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2085;
  assign select_2085 = and_503_s21_q ? census_memory_rdata_s21_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2086;
  assign select_2086 = and_503_s21_q ? census_memory_rdata_s21_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2087;
  assign select_2087 = and_503_s21_q ? census_memory_rdata_s21_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2088;
  assign select_2088 = and_503_s21_q ? census_memory_rdata_s21_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2089;
  assign select_2089 = and_503_s21_q ? census_memory_rdata_s21_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2090;
  assign select_2090 = and_503_s21_q ? census_memory_rdata_s21_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2091;
  assign select_2091 = and_503_s21_q ? census_memory_rdata_s21_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2092;
  assign select_2092 = and_503_s21_q ? census_memory_rdata_s21_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2093;
  assign select_2093 = and_503_s21_q ? census_memory_rdata_s21_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2094;
  assign select_2094 = and_503_s21_q ? census_memory_rdata_s21_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2095;
  assign select_2095 = and_503_s21_q ? census_memory_rdata_s21_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2096;
  assign select_2096 = and_503_s21_q ? census_memory_rdata_s21_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2097;
  assign select_2097 = and_503_s21_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2098;
  assign select_2098 = and_503_s21_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2100;
  assign select_2100 = and_503_s21_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2101;
  assign select_2101 = and_503_s21_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2103;
  assign select_2103 = and_503_s21_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2104;
  assign select_2104 = and_503_s21_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2106;
  assign select_2106 = and_503_s21_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2107;
  assign select_2107 = and_503_s21_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2108;
  assign select_2108 = and_503_s21_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2110;
  assign select_2110 = and_503_s21_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2111;
  assign select_2111 = and_503_s21_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2113;
  assign select_2113 = and_503_s21_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2114;
  assign select_2114 = and_503_s21_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2116;
  assign select_2116 = and_503_s21_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2117;
  assign select_2117 = and_503_s21_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2119;
  assign select_2119 = and_503_s21_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2120;
  assign select_2120 = and_503_s21_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2122;
  assign select_2122 = and_503_s21_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2123;
  assign select_2123 = and_503_s21_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2125;
  assign select_2125 = and_503_s21_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2126;
  assign select_2126 = and_503_s21_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2129;
  assign select_2129 = and_503_s21_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2130;
  assign select_2130 = and_503_s21_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2133;
  assign select_2133 = and_503_s21_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2134;
  assign select_2134 = and_503_s21_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2138;
  assign difference_2138 = {1'b0, select_513_s21_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2141;
  assign difference_2141 = {1'b0, census_memory_rdata_s21_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2145;
  assign difference_2145 = {1'b0, census_memory_rdata_s21_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2149;
  assign difference_2149 = {1'b0, census_memory_rdata_s21_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2153;
  assign difference_2153 = {1'b0, census_memory_rdata_s21_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2184;
  assign difference_2184 = {1'b0, select_509_s21_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2196;
  assign difference_2196 = {1'b0, select_513_s21_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/patches.hpp:321
  logic and_2417;
  assign and_2417 = not_1473_s21_q & (so_s21_q & (ends_cell_s21_q & explained_s21_q));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2419;
  assign select_2419 = and_2403_s21_q ? 14'h0 : (counts_explained_q + {13'h0, and_2417});
  // hls/stages/patches.hpp:321
  logic and_2422;
  assign and_2422 = not_1473_s21_q & (so_s21_q & (ends_cell_s21_q & and_1904_s21_q));
  // hls/stages/agreement.hpp:1037
  logic [4:0] e;
  assign e = {difference_2436_s21_q[3], difference_2436_s21_q} + (equal_1634_s21_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1074
  logic less_2451;
  assign less_2451 = region_row_s21_q < x_s21_q[5:3];
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2530_s21_q[11:7])) ? 12'h7f : select_2530_s21_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2582;
  assign select_2582 = equal_2579_s21_q ? (registration_fresh_q & not_2580_s21_q) : registration_fresh_q;
  // hls/stages/patches.hpp:321
  logic [3:0] select_2584;
  assign select_2584 = so_s21_q ? (and_1565_s21_q ? select_2582 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2586;
  assign select_2586 = and_2403_s21_q ? 4'hf : (equal_1472_s21_q ? registration_fresh_q : select_2584);
  // hls/stages/registration.hpp:258
  logic not_2607;
  assign not_2607 = ~quarter_2_s21_q[1];
  logic [3:0] select_2608;
  assign select_2608 = quarter_2_s21_q[0] ? {quarter_2_s21_q[1], 1'b0, not_2607, 1'b0} : {1'b0, quarter_2_s21_q[1], 1'b0, not_2607};
  // hls/stages/patches.hpp:167
  logic [10:0] select_2860;
  assign select_2860 = equal_1695_s21_q ? patches_down_values_0_q : (or_1699_s21_q ? down_2_s21_q : patches_down_values_0_q);
  logic [10:0] select_2862;
  assign select_2862 = or_1699_s21_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_2864;
  assign select_2864 = equal_1693_s21_q ? patches_down_values_1_q : (equal_1695_s21_q ? patches_down_values_1_q : select_2862);
  // hls/stages/patches.hpp:533
  logic and_3317;
  assign and_3317 = less_1854_s21_q & (equal_3309_s21_q & equal_3315_s21_q);
  // hls/stages/patches.hpp:537
  logic select_3320;
  assign select_3320 = equal_1857_s21_q ? (less_1854_s21_q ? (not_1858_s21_q & and_3317) : and_3317) : and_3317;
  // hls/stages/patches.hpp:533
  logic and_3326;
  assign and_3326 = less_1854_s21_q & (equal_3309_s21_q & equal_3324_s21_q);
  // hls/stages/patches.hpp:537
  logic select_3329;
  assign select_3329 = equal_1857_s21_q ? (less_1854_s21_q ? (not_1858_s21_q & and_3326) : and_3326) : and_3326;
  // hls/stages/patches.hpp:530
  logic [6:0] sum_3333;
  assign sum_3333 = {away_s21_q[5], away_s21_q} + 7'h7d;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3679;
  assign select_3679 = equal_3465_s21_q ? 14'h0 : product_q;
  logic [13:0] select_3694;
  assign select_3694 = equal_3690_s21_q ? 14'h0 : of_s21_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3679} + {1'b0, select_3694};
  // hls/stages/patches.hpp:321
  logic [2:0] select_3712;
  assign select_3712 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_3714;
  assign select_3714 = equal_1472_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_3712 : box_textured_columns_values_0_q);
  logic [2:0] select_3715;
  assign select_3715 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3717;
  assign select_3717 = equal_1472_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_3715 : box_textured_columns_values_1_q);
  logic [2:0] select_3718;
  assign select_3718 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3720;
  assign select_3720 = equal_1472_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_3718 : box_textured_columns_values_2_q);
  logic [2:0] select_3721;
  assign select_3721 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3723;
  assign select_3723 = equal_1472_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_3721 : box_textured_columns_values_3_q);
  logic [2:0] select_3724;
  assign select_3724 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3726;
  assign select_3726 = equal_1472_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_3724 : box_textured_columns_values_4_q);
  logic [4:0] select_3746;
  assign select_3746 = so_s21_q ? (ends_cell_s21_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3747;
  assign select_3747 = equal_1472_s21_q ? box_explained_sum_sums_values_0_q : select_3746;
  logic [4:0] select_3764;
  assign select_3764 = so_s21_q ? (ends_cell_s21_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_3782;
  assign select_3782 = so_s21_q ? (ends_cell_s21_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/registration.hpp:258
  logic not_3884;
  assign not_3884 = ~quarter_s21_q[1];
  logic [3:0] select_3885;
  assign select_3885 = quarter_s21_q[0] ? {quarter_s21_q[1], 1'b0, not_3884, 1'b0} : {1'b0, quarter_s21_q[1], 1'b0, not_3884};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 21, written in stage 25: 21 < 25 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1524_s21_q;
  logic registration_sums_re;
  assign registration_sums_re = s21_en & (equal_1472_s21_q ? (x_s21_q[6] & select_1555_s21_q) : and_1566);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:728; read in stage 21, written in stage 23: 21 < 23 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1601_s21_q;
  logic patches_choices_re;
  assign patches_choices_re = s21_en & (sample_pair_whole_s21_q & (~equal_1603_s21_q));
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:757; read in stage 21, written in stage 24: 21 < 24 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1796_s21_q, not_1791_s21_q, select_1790_s21_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s21_en & or_1797_s21_q;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:758; read in stage 21, written in stage 24: 21 < 24 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_s21_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s21_en & (not_1694_s21_q & (new_row_s21_q & equal_1695_s21_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s21_q;
  logic census_memory_we;
  assign census_memory_we = s21_en & and_503_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s21_q[58:40], census_memory_rdata_s21_q[38:0], and_521_s21_q, whole_2_s21_q, select_513_s21_q, select_509_s21_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s20_sim;
  logic census_memory_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s20_sim <= census_memory_re;
      census_memory_raddr_s20_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s20_sim && census_memory_raddr_s20_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_explained_q <= 14'h0;
      registration_fresh_q <= 4'hf;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s21_en) begin
      counts_explained_q <= select_2419;
      registration_fresh_q <= select_2586;
      patches_down_values_0_q <= equal_1693_s21_q ? patches_down_values_0_q : select_2860;
      patches_down_values_1_q <= select_2864;
      segment_textured_q <= select_1894 + {6'h0, and_2412_s21_q};
      segment_explained_q <= select_1899 + {6'h0, and_2417};
      segment_nearer_q <= select_1905 + {6'h0, and_2422};
      product_q <= equal_1472_s21_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_1920;
      columns_passed_q <= {select_1922[7:0], or_1918};
      line_ended_q <= marks_last_s21_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_quarter_1_0_q = 9'h0;
    averager_quarter_1_1_q = 9'h0;
    averager_quarter_2_0_q = 9'h0;
    averager_quarter_2_1_q = 9'h0;
    census_columns_values_0_cell_0_left_q = 9'h0;
    census_columns_values_0_cell_0_right_q = 9'h0;
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
    census_columns_values_1_cell_1_left_q = 9'h0;
    census_columns_values_1_cell_1_right_q = 9'h0;
    census_columns_values_1_cell_2_left_q = 9'h0;
    census_columns_values_1_cell_2_right_q = 9'h0;
    census_columns_values_1_cell_2_of_skin_q = 1'b0;
    census_columns_values_1_cell_3_left_q = 9'h0;
    census_columns_values_1_cell_3_right_q = 9'h0;
    census_columns_values_1_cell_4_left_q = 9'h0;
    census_columns_values_1_cell_4_right_q = 9'h0;
    census_columns_values_2_cell_0_left_q = 9'h0;
    census_columns_values_2_cell_0_right_q = 9'h0;
    census_columns_values_2_cell_1_left_q = 9'h0;
    census_columns_values_2_cell_1_right_q = 9'h0;
    census_columns_values_2_cell_2_left_q = 9'h0;
    census_columns_values_2_cell_2_right_q = 9'h0;
    census_columns_values_2_cell_3_left_q = 9'h0;
    census_columns_values_2_cell_3_right_q = 9'h0;
    census_columns_values_2_cell_4_left_q = 9'h0;
    census_columns_values_2_cell_4_right_q = 9'h0;
    census_columns_values_3_cell_1_left_q = 9'h0;
    census_columns_values_3_cell_1_right_q = 9'h0;
    census_columns_values_3_cell_3_left_q = 9'h0;
    census_columns_values_3_cell_3_right_q = 9'h0;
    sharpness_last_mean_0_q = 9'h0;
    sharpness_last_mean_1_q = 9'h0;
    box_textured_columns_values_0_q = 3'h0;
    box_textured_columns_values_1_q = 3'h0;
    box_textured_columns_values_2_q = 3'h0;
    box_textured_columns_values_3_q = 3'h0;
    box_textured_columns_values_4_q = 3'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s21_en) begin
      averager_quarter_1_0_q <= select_2047;
      averager_quarter_1_1_q <= select_2049;
      averager_quarter_2_0_q <= select_2051;
      averager_quarter_2_1_q <= select_2053;
      census_columns_values_0_cell_0_left_q <= select_2081;
      census_columns_values_0_cell_0_right_q <= select_2082;
      census_columns_values_0_cell_1_left_q <= select_2084;
      census_columns_values_0_cell_1_right_q <= select_2085;
      census_columns_values_0_cell_1_mask_q <= select_2086;
      census_columns_values_0_cell_2_left_q <= select_2087;
      census_columns_values_0_cell_2_right_q <= select_2088;
      census_columns_values_0_cell_2_mask_q <= select_2089;
      census_columns_values_0_cell_2_of_skin_q <= select_2090;
      census_columns_values_0_cell_3_left_q <= select_2091;
      census_columns_values_0_cell_3_right_q <= select_2092;
      census_columns_values_0_cell_3_mask_q <= select_2093;
      census_columns_values_0_cell_4_left_q <= select_2094;
      census_columns_values_0_cell_4_right_q <= select_2095;
      census_columns_values_0_cell_4_mask_q <= select_2096;
      census_columns_values_1_cell_0_left_q <= select_2097;
      census_columns_values_1_cell_0_right_q <= select_2098;
      census_columns_values_1_cell_1_left_q <= select_2100;
      census_columns_values_1_cell_1_right_q <= select_2101;
      census_columns_values_1_cell_2_left_q <= select_2103;
      census_columns_values_1_cell_2_right_q <= select_2104;
      census_columns_values_1_cell_2_of_skin_q <= select_2106;
      census_columns_values_1_cell_3_left_q <= select_2107;
      census_columns_values_1_cell_3_right_q <= select_2108;
      census_columns_values_1_cell_4_left_q <= select_2110;
      census_columns_values_1_cell_4_right_q <= select_2111;
      census_columns_values_2_cell_0_left_q <= select_2113;
      census_columns_values_2_cell_0_right_q <= select_2114;
      census_columns_values_2_cell_1_left_q <= select_2116;
      census_columns_values_2_cell_1_right_q <= select_2117;
      census_columns_values_2_cell_2_left_q <= select_2119;
      census_columns_values_2_cell_2_right_q <= select_2120;
      census_columns_values_2_cell_3_left_q <= select_2122;
      census_columns_values_2_cell_3_right_q <= select_2123;
      census_columns_values_2_cell_4_left_q <= select_2125;
      census_columns_values_2_cell_4_right_q <= select_2126;
      census_columns_values_3_cell_1_left_q <= select_2129;
      census_columns_values_3_cell_1_right_q <= select_2130;
      census_columns_values_3_cell_3_left_q <= select_2133;
      census_columns_values_3_cell_3_right_q <= select_2134;
      sharpness_last_mean_0_q <= and_503_s21_q ? select_509_s21_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_503_s21_q ? select_513_s21_q : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= select_3714;
      box_textured_columns_values_1_q <= select_3717;
      box_textured_columns_values_2_q <= select_3720;
      box_textured_columns_values_3_q <= select_3723;
      box_textured_columns_values_4_q <= select_3726;
      box_explained_sum_sums_values_0_q <= select_3747;
      box_shown_sum_sums_values_0_q <= equal_1472_s21_q ? box_shown_sum_sums_values_0_q : select_3764;
      box_nearer_sum_sums_values_0_q <= equal_1472_s21_q ? box_nearer_sum_sums_values_0_q : select_3782;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic [7:0] sample_pair_pixel_0_s22_q;
  logic [7:0] sample_pair_pixel_1_s22_q;
  logic sample_pair_whole_s22_q;
  logic sample_present_s22_q;
  logic census_columns_values_0_cell_1_mask_s22_q;
  logic census_columns_values_0_cell_2_mask_s22_q;
  logic census_columns_values_0_cell_3_mask_s22_q;
  logic census_columns_values_0_cell_4_mask_s22_q;
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic [7:0] x_s22_q;
  logic [2:0] slot_s22_q;
  logic ends_cell_s22_q;
  logic lower_half_s22_q;
  logic [13:0] counts_textured_s22_q;
  logic [13:0] counts_explained_s22_q;
  logic registration_of_right_s22_q;
  logic [4:0] patches_choosing_band_s22_q;
  logic patches_lower_s22_q;
  logic patches_second_s22_q;
  logic [4:0] patches_code_row_s22_q;
  logic [10:0] patches_down_values_1_s22_q;
  logic [4:0] patches_along_s22_q;
  logic patches_summed_last_s22_q;
  logic [4:0] patches_summed_down_by_s22_q;
  logic [9:0] patches_read_row_differing_s22_q;
  logic patches_read_first_s22_q;
  logic [2:0] region_row_s22_q;
  logic [13:0] product_s22_q;
  logic centres_values_1_textured_s22_q;
  logic centres_values_1_of_skin_s22_q;
  logic [3:0] select_464_s22_q;
  logic [6:0] select_467_s22_q;
  logic [6:0] column_s22_q;
  logic and_501_s22_q;
  logic and_503_s22_q;
  logic equal_506_s22_q;
  logic whole_2_s22_q;
  logic so_s22_q;
  logic less_537_s22_q;
  logic less_538_s22_q;
  logic less_539_s22_q;
  logic less_540_s22_q;
  logic less_541_s22_q;
  logic less_542_s22_q;
  logic less_543_s22_q;
  logic less_544_s22_q;
  logic less_545_s22_q;
  logic less_546_s22_q;
  logic less_547_s22_q;
  logic less_548_s22_q;
  logic less_549_s22_q;
  logic less_550_s22_q;
  logic less_551_s22_q;
  logic less_552_s22_q;
  logic less_553_s22_q;
  logic less_554_s22_q;
  logic less_555_s22_q;
  logic less_556_s22_q;
  logic less_557_s22_q;
  logic less_558_s22_q;
  logic less_559_s22_q;
  logic less_560_s22_q;
  logic and_568_s22_q;
  logic and_572_s22_q;
  logic difference_595_s22_q;
  logic [8:0] xor_596_s22_q;
  logic difference_598_s22_q;
  logic [8:0] xor_599_s22_q;
  logic difference_602_s22_q;
  logic [8:0] xor_603_s22_q;
  logic difference_606_s22_q;
  logic [8:0] xor_607_s22_q;
  logic difference_610_s22_q;
  logic [8:0] xor_611_s22_q;
  logic equal_1472_s22_q;
  logic not_1473_s22_q;
  logic shift_2_s22_q;
  logic equal_1517_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1523_s22_q;
  logic equal_1525_s22_q;
  logic equal_1527_s22_q;
  logic equal_1529_s22_q;
  logic equal_1531_s22_q;
  logic equal_1533_s22_q;
  logic equal_1535_s22_q;
  logic equal_1537_s22_q;
  logic equal_1539_s22_q;
  logic less_1548_s22_q;
  logic or_1552_s22_q;
  logic equal_1572_s22_q;
  logic and_1582_s22_q;
  logic and_1585_s22_q;
  logic select_1602_s22_q;
  logic equal_1603_s22_q;
  logic and_1611_s22_q;
  logic equal_1613_s22_q;
  logic equal_1634_s22_q;
  logic and_1645_s22_q;
  logic [5:0] select_1659_s22_q;
  logic [7:0] select_1684_s22_q;
  logic and_1691_s22_q;
  logic and_1692_s22_q;
  logic equal_1693_s22_q;
  logic equal_1695_s22_q;
  logic equal_1698_s22_q;
  logic or_1699_s22_q;
  logic and_1708_s22_q;
  logic [4:0] select_1723_s22_q;
  logic select_1729_s22_q;
  logic [3:0] select_1768_s22_q;
  logic less_1784_s22_q;
  logic new_row_s22_q;
  logic or_1797_s22_q;
  logic [1:0] of_row_2_s22_q;
  logic [1:0] down_2_s22_q;
  logic [12:0] sum_1810_s22_q;
  logic [11:0] smooth_s22_q;
  logic and_1839_s22_q;
  logic and_1848_s22_q;
  logic and_1853_s22_q;
  logic less_1854_s22_q;
  logic equal_1855_s22_q;
  logic not_1856_s22_q;
  logic equal_1857_s22_q;
  logic [9:0] patches_rows_rdata_s22_q;
  logic or_1875_s22_q;
  logic or_1878_s22_q;
  logic or_1881_s22_q;
  logic not_1883_s22_q;
  logic [9:0] sum_1897_s22_q;
  logic [9:0] sum_1902_s22_q;
  logic [9:0] sum_1908_s22_q;
  logic and_1909_s22_q;
  logic select_1924_s22_q;
  logic [3:0] difference_1959_s22_q;
  logic or_1967_s22_q;
  logic or_1970_s22_q;
  logic or_1973_s22_q;
  logic [4:0] around_s22_q;
  logic less_2012_s22_q;
  logic and_2023_s22_q;
  logic sum_2058_s22_q;
  logic [9:0] difference_2059_s22_q;
  logic sum_2066_s22_q;
  logic [9:0] difference_2067_s22_q;
  logic difference_2138_s22_q;
  logic [8:0] xor_2139_s22_q;
  logic difference_2141_s22_q;
  logic [8:0] xor_2142_s22_q;
  logic difference_2145_s22_q;
  logic [8:0] xor_2146_s22_q;
  logic difference_2149_s22_q;
  logic [8:0] xor_2150_s22_q;
  logic difference_2153_s22_q;
  logic [8:0] xor_2154_s22_q;
  logic equal_2163_s22_q;
  logic difference_2184_s22_q;
  logic [8:0] xor_2185_s22_q;
  logic difference_2196_s22_q;
  logic [8:0] xor_2197_s22_q;
  logic equal_2287_s22_q;
  logic and_2403_s22_q;
  logic and_2407_s22_q;
  logic and_2422_s22_q;
  logic not_2426_s22_q;
  logic [4:0] e_s22_q;
  logic [9:0] select_2452_s22_q;
  logic [9:0] select_2455_s22_q;
  logic and_2518_s22_q;
  logic and_2519_s22_q;
  logic [11:0] residual_s22_q;
  logic equal_2610_s22_q;
  logic and_2755_s22_q;
  logic less_2882_s22_q;
  logic equal_3225_s22_q;
  logic [4:0] select_3313_s22_q;
  logic select_3320_s22_q;
  logic select_3329_s22_q;
  logic and_3335_s22_q;
  logic [14:0] select_3344_s22_q;
  logic equal_3465_s22_q;
  logic and_3647_s22_q;
  logic less_3648_s22_q;
  logic equal_3649_s22_q;
  logic equal_3665_s22_q;
  logic equal_3667_s22_q;
  logic equal_3668_s22_q;
  logic sum_4_s22_q;
  logic equal_3797_s22_q;
  logic equal_3887_s22_q;
  logic [9:0] select_3897_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      sample_pair_pixel_0_s22_q <= sample_pair_pixel_0_s21_q;
      sample_pair_pixel_1_s22_q <= sample_pair_pixel_1_s21_q;
      sample_pair_whole_s22_q <= sample_pair_whole_s21_q;
      sample_present_s22_q <= sample_present_s21_q;
      census_columns_values_0_cell_1_mask_s22_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s22_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s22_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s22_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s22_q <= x_s21_q;
      slot_s22_q <= slot_s21_q;
      ends_cell_s22_q <= ends_cell_s21_q;
      lower_half_s22_q <= lower_half_s21_q;
      counts_textured_s22_q <= counts_textured_s21_q;
      counts_explained_s22_q <= counts_explained_q;
      registration_of_right_s22_q <= registration_of_right_s21_q;
      patches_choosing_band_s22_q <= patches_choosing_band_s21_q;
      patches_lower_s22_q <= patches_lower_s21_q;
      patches_second_s22_q <= patches_second_s21_q;
      patches_code_row_s22_q <= patches_code_row_s21_q;
      patches_down_values_1_s22_q <= patches_down_values_1_q;
      patches_along_s22_q <= patches_along_s21_q;
      patches_summed_last_s22_q <= patches_summed_last_s21_q;
      patches_summed_down_by_s22_q <= patches_summed_down_by_s21_q;
      patches_read_row_differing_s22_q <= patches_read_row_differing_s21_q;
      patches_read_first_s22_q <= patches_read_first_s21_q;
      region_row_s22_q <= region_row_s21_q;
      product_s22_q <= product_q;
      centres_values_1_textured_s22_q <= centres_values_1_textured_s21_q;
      centres_values_1_of_skin_s22_q <= centres_values_1_of_skin_s21_q;
      select_464_s22_q <= select_464_s21_q;
      select_467_s22_q <= select_467_s21_q;
      column_s22_q <= column_s21_q;
      and_501_s22_q <= and_501_s21_q;
      and_503_s22_q <= and_503_s21_q;
      equal_506_s22_q <= equal_506_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      so_s22_q <= so_s21_q;
      less_537_s22_q <= less_537;
      less_538_s22_q <= less_538;
      less_539_s22_q <= less_539;
      less_540_s22_q <= less_540;
      less_541_s22_q <= less_541;
      less_542_s22_q <= less_542;
      less_543_s22_q <= less_543;
      less_544_s22_q <= less_544;
      less_545_s22_q <= less_545;
      less_546_s22_q <= less_546;
      less_547_s22_q <= less_547;
      less_548_s22_q <= less_548;
      less_549_s22_q <= less_549;
      less_550_s22_q <= less_550;
      less_551_s22_q <= less_551;
      less_552_s22_q <= less_552;
      less_553_s22_q <= less_553;
      less_554_s22_q <= less_554;
      less_555_s22_q <= less_555;
      less_556_s22_q <= less_556;
      less_557_s22_q <= less_557;
      less_558_s22_q <= less_558;
      less_559_s22_q <= less_559;
      less_560_s22_q <= less_560;
      and_568_s22_q <= and_568_s21_q;
      and_572_s22_q <= and_572;
      difference_595_s22_q <= difference_595[9];
      xor_596_s22_q <= difference_595[8:0] ^ {9{difference_595[9]}};
      difference_598_s22_q <= difference_598[9];
      xor_599_s22_q <= difference_598[8:0] ^ {9{difference_598[9]}};
      difference_602_s22_q <= difference_602[9];
      xor_603_s22_q <= difference_602[8:0] ^ {9{difference_602[9]}};
      difference_606_s22_q <= difference_606[9];
      xor_607_s22_q <= difference_606[8:0] ^ {9{difference_606[9]}};
      difference_610_s22_q <= difference_610[9];
      xor_611_s22_q <= difference_610[8:0] ^ {9{difference_610[9]}};
      equal_1472_s22_q <= equal_1472_s21_q;
      not_1473_s22_q <= not_1473_s21_q;
      shift_2_s22_q <= shift_2_s21_q[0];
      equal_1517_s22_q <= equal_1517_s21_q;
      all_s22_q <= all_s21_q;
      sum_1523_s22_q <= sum_1523_s21_q;
      equal_1525_s22_q <= equal_1525_s21_q;
      equal_1527_s22_q <= equal_1527_s21_q;
      equal_1529_s22_q <= equal_1529_s21_q;
      equal_1531_s22_q <= equal_1531_s21_q;
      equal_1533_s22_q <= equal_1533_s21_q;
      equal_1535_s22_q <= equal_1535_s21_q;
      equal_1537_s22_q <= equal_1537_s21_q;
      equal_1539_s22_q <= equal_1539_s21_q;
      less_1548_s22_q <= less_1548_s21_q;
      or_1552_s22_q <= or_1552_s21_q;
      equal_1572_s22_q <= (registration_fresh_q & select_1570_s21_q) == 4'h0;
      and_1582_s22_q <= not_1473_s21_q & and_1566;
      and_1585_s22_q <= and_1585_s21_q;
      select_1602_s22_q <= select_1602_s21_q;
      equal_1603_s22_q <= equal_1603_s21_q;
      and_1611_s22_q <= and_1611_s21_q;
      equal_1613_s22_q <= equal_1613_s21_q;
      equal_1634_s22_q <= equal_1634_s21_q;
      and_1645_s22_q <= and_1645;
      select_1659_s22_q <= select_1659_s21_q;
      select_1684_s22_q <= select_1684_s21_q;
      and_1691_s22_q <= and_1691_s21_q;
      and_1692_s22_q <= and_1692_s21_q;
      equal_1693_s22_q <= equal_1693_s21_q;
      equal_1695_s22_q <= equal_1695_s21_q;
      equal_1698_s22_q <= equal_1698_s21_q;
      or_1699_s22_q <= or_1699_s21_q;
      and_1708_s22_q <= and_1708_s21_q;
      select_1723_s22_q <= select_1723_s21_q;
      select_1729_s22_q <= select_1729_s21_q;
      select_1768_s22_q <= select_1768_s21_q;
      less_1784_s22_q <= less_1784_s21_q;
      new_row_s22_q <= new_row_s21_q;
      or_1797_s22_q <= or_1797_s21_q;
      of_row_2_s22_q <= of_row_2_s21_q;
      down_2_s22_q <= down_2_s21_q[1:0];
      sum_1810_s22_q <= sum_1810;
      smooth_s22_q <= smooth;
      and_1839_s22_q <= not_1694_s21_q & (not_1696_s21_q & and_1837_s21_q);
      and_1848_s22_q <= and_1848_s21_q;
      and_1853_s22_q <= not_1694_s21_q & (not_1696_s21_q & and_1851_s21_q);
      less_1854_s22_q <= less_1854_s21_q;
      equal_1855_s22_q <= equal_1855_s21_q;
      not_1856_s22_q <= not_1856_s21_q;
      equal_1857_s22_q <= equal_1857_s21_q;
      patches_rows_rdata_s22_q <= patches_rows_rdata_s21_q;
      or_1875_s22_q <= or_1875_s21_q;
      or_1878_s22_q <= or_1878_s21_q;
      or_1881_s22_q <= or_1881_s21_q;
      not_1883_s22_q <= not_1883_s21_q;
      sum_1897_s22_q <= sum_1897;
      sum_1902_s22_q <= sum_1902;
      sum_1908_s22_q <= sum_1908;
      and_1909_s22_q <= and_1909_s21_q;
      select_1924_s22_q <= select_1924;
      difference_1959_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1958};
      or_1967_s22_q <= or_1967_s21_q;
      or_1970_s22_q <= or_1970_s21_q;
      or_1973_s22_q <= or_1973_s21_q;
      around_s22_q <= around;
      less_2012_s22_q <= {1'b0, around[4:1]} < n;
      and_2023_s22_q <= and_2023_s21_q;
      sum_2058_s22_q <= sum_2058[0];
      difference_2059_s22_q <= {1'b0, sum_2058[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2066_s22_q <= sum_2066[0];
      difference_2067_s22_q <= {1'b0, sum_2066[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2138_s22_q <= difference_2138[9];
      xor_2139_s22_q <= difference_2138[8:0] ^ {9{difference_2138[9]}};
      difference_2141_s22_q <= difference_2141[9];
      xor_2142_s22_q <= difference_2141[8:0] ^ {9{difference_2141[9]}};
      difference_2145_s22_q <= difference_2145[9];
      xor_2146_s22_q <= difference_2145[8:0] ^ {9{difference_2145[9]}};
      difference_2149_s22_q <= difference_2149[9];
      xor_2150_s22_q <= difference_2149[8:0] ^ {9{difference_2149[9]}};
      difference_2153_s22_q <= difference_2153[9];
      xor_2154_s22_q <= difference_2153[8:0] ^ {9{difference_2153[9]}};
      equal_2163_s22_q <= equal_2163_s21_q;
      difference_2184_s22_q <= difference_2184[9];
      xor_2185_s22_q <= difference_2184[8:0] ^ {9{difference_2184[9]}};
      difference_2196_s22_q <= difference_2196[9];
      xor_2197_s22_q <= difference_2196[8:0] ^ {9{difference_2196[9]}};
      equal_2287_s22_q <= equal_2287_s21_q;
      and_2403_s22_q <= and_2403_s21_q;
      and_2407_s22_q <= and_2407_s21_q;
      and_2422_s22_q <= and_2422;
      not_2426_s22_q <= not_2426_s21_q;
      e_s22_q <= e;
      select_2452_s22_q <= less_2451 ? 10'h0 : regions_rdata_s21_q[9:0];
      select_2455_s22_q <= less_2451 ? 10'h0 : regions_rdata_s21_q[19:10];
      and_2518_s22_q <= and_2518_s21_q;
      and_2519_s22_q <= shift_2_s21_q[1] & less_1612_s21_q;
      residual_s22_q <= residual;
      equal_2610_s22_q <= (registration_fresh_q & select_2608) == 4'h0;
      and_2755_s22_q <= and_2755_s21_q;
      less_2882_s22_q <= less_2882_s21_q;
      equal_3225_s22_q <= patches_match_row_s21_q == 4'h0;
      select_3313_s22_q <= select_3313_s21_q;
      select_3320_s22_q <= select_3320;
      select_3329_s22_q <= select_3329;
      and_3335_s22_q <= equal_3309_s21_q & ({sum_3333[6], sum_3333} < 8'hfb);
      select_3344_s22_q <= select_3344_s21_q;
      equal_3465_s22_q <= equal_3465_s21_q;
      and_3647_s22_q <= and_3647_s21_q;
      less_3648_s22_q <= counts_explained_q < product_q;
      equal_3649_s22_q <= counts_explained_q == product_q;
      equal_3665_s22_q <= equal_3665_s21_q;
      equal_3667_s22_q <= equal_3667_s21_q;
      equal_3668_s22_q <= equal_3668_s21_q;
      sum_4_s22_q <= sum_4[0];
      equal_3797_s22_q <= equal_3797_s21_q;
      equal_3887_s22_q <= (registration_fresh_q & select_3885) == 4'h0;
      select_3897_s22_q <= less_2451 ? 10'h0 : regions_rdata_s21_q[29:20];
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [13:0] counts_supervised_q;
  logic [11:0] patches_smooth_values_0_q;
  logic [11:0] patches_smooth_values_1_q;
  logic [11:0] patches_smooth_values_2_q;
  logic [11:0] patches_smooth_values_3_q;
  logic [10:0] patches_down_values_2_q;
  logic [10:0] patches_down_values_3_q;
  logic patches_read_above_q;
  logic patches_read_below_q;
  logic [9:0] patches_peak_above_q;
  logic [9:0] patches_peak_below_q;
  logic product_rest_q;
  logic disagree_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic began_q;
  logic [3:0] seen_x_q;
  logic [3:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_572_s22_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s22_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s22_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s22_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s22_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:270
  logic [9:0] sum_597;
  assign sum_597 = {9'h0, difference_595_s22_q} + {1'b0, xor_596_s22_q};
  logic [9:0] sum_600;
  assign sum_600 = {9'h0, difference_598_s22_q} + {1'b0, xor_599_s22_q};
  // hls/stages/patches.hpp:321
  logic and_1649;
  assign and_1649 = not_1473_s22_q & (so_s22_q & (ends_cell_s22_q & (shift_2_s22_q & and_1645_s22_q)));
  logic [7:0] select_1654;
  assign select_1654 = so_s22_q ? (ends_cell_s22_q ? (shift_2_s22_q ? x_s22_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:448
  logic [13:0] sum_1811;
  assign sum_1811 = {{3{patches_down_values_1_s22_q[10]}}, patches_down_values_1_s22_q} + {sum_1810_s22_q, down_2_s22_q[1]};
  logic [12:0] sum_1812;
  assign sum_1812 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1811[13:1];
  // hls/stages/patches.hpp:447
  logic [12:0] sum_1821;
  assign sum_1821 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s22_q[11:1]};
  logic [12:0] sum_1822;
  assign sum_1822 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1823;
  assign difference_1823 = {1'b0, sum_1821, smooth_s22_q[0]} - {1'b0, sum_1822, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_1924_s22_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1218
  logic [6:0] select_1927;
  assign select_1927 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1228
  logic equal_1930;
  assign equal_1930 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1201
  logic not_1937;
  assign not_1937 = ~marks_first_s22_q;
  // hls/stages/agreement.hpp:1036
  logic [4:0] t;
  assign t = {difference_1959_s22_q[3], difference_1959_s22_q} + (equal_1634_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1043
  logic not_1974;
  assign not_1974 = ~region_row_s22_q[2];
  logic [2:0] select_1975;
  assign select_1975 = region_row_s22_q[1] ? {1'b0, not_1974, 1'b0} : {region_row_s22_q[2], 1'b0, not_1974};
  logic [5:0] select_1976;
  assign select_1976 = region_row_s22_q[0] ? {select_1975[2], 1'b0, select_1975[1], 1'b0, select_1975[0], 1'b0} : {1'b0, select_1975[2], 1'b0, select_1975[1], 1'b0, select_1975[0]};
  logic [11:0] select_1977;
  assign select_1977 = or_1973_s22_q ? {select_1976[5], 1'b0, select_1976[4], 1'b0, select_1976[3], 1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0], 1'b0} : {1'b0, select_1976[5], 1'b0, select_1976[4], 1'b0, select_1976[3], 1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0]};
  logic [23:0] select_1978;
  assign select_1978 = or_1970_s22_q ? {select_1977[11], 1'b0, select_1977[10], 1'b0, select_1977[9], 1'b0, select_1977[8], 1'b0, select_1977[7], 1'b0, select_1977[6], 1'b0, select_1977[5], 1'b0, select_1977[4], 1'b0, select_1977[3], 1'b0, select_1977[2], 1'b0, select_1977[1], 1'b0, select_1977[0], 1'b0} : {1'b0, select_1977[11], 1'b0, select_1977[10], 1'b0, select_1977[9], 1'b0, select_1977[8], 1'b0, select_1977[7], 1'b0, select_1977[6], 1'b0, select_1977[5], 1'b0, select_1977[4], 1'b0, select_1977[3], 1'b0, select_1977[2], 1'b0, select_1977[1], 1'b0, select_1977[0]};
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_1996;
  assign sum_1996 = {1'b0, around_s22_q} + {2'h0, around_s22_q[4:1]};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2060;
  assign xor_2060 = {difference_2059_s22_q[8:0], sum_2058_s22_q} ^ {10{difference_2059_s22_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2059_s22_q[9]} + {1'b0, xor_2060};
  logic [9:0] xor_2068;
  assign xor_2068 = {difference_2067_s22_q[8:0], sum_2066_s22_q} ^ {10{difference_2067_s22_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2067_s22_q[9]} + {1'b0, xor_2068};
  // hls/stages/agreement.hpp:507
  logic select_2083;
  assign select_2083 = and_503_s22_q ? whole_2_s22_q : census_columns_values_0_cell_0_mask_q;
  logic select_2099;
  assign select_2099 = and_503_s22_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2102;
  assign select_2102 = and_503_s22_q ? census_columns_values_0_cell_1_mask_s22_q : census_columns_values_1_cell_1_mask_q;
  logic select_2105;
  assign select_2105 = and_503_s22_q ? census_columns_values_0_cell_2_mask_s22_q : census_columns_values_1_cell_2_mask_q;
  logic select_2109;
  assign select_2109 = and_503_s22_q ? census_columns_values_0_cell_3_mask_s22_q : census_columns_values_1_cell_3_mask_q;
  logic select_2112;
  assign select_2112 = and_503_s22_q ? census_columns_values_0_cell_4_mask_s22_q : census_columns_values_1_cell_4_mask_q;
  logic select_2115;
  assign select_2115 = and_503_s22_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2118;
  assign select_2118 = and_503_s22_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_2140;
  assign sum_2140 = {9'h0, difference_2138_s22_q} + {1'b0, xor_2139_s22_q};
  logic [9:0] sum_2143;
  assign sum_2143 = {9'h0, difference_2141_s22_q} + {1'b0, xor_2142_s22_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2184_s22_q} + xor_2185_s22_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2196_s22_q} + xor_2197_s22_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2409;
  assign select_2409 = and_2403_s22_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2407_s22_q});
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2439;
  assign sum_2439 = {1'b0, e_s22_q} + {2'h0, e_s22_q[4:1]};
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2551;
  assign difference_2551 = 13'h0 - {residual_s22_q[11], residual_s22_q};
  logic less_2566;
  assign less_2566 = $signed(difference_2551) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:167
  logic [11:0] select_2848;
  assign select_2848 = equal_1695_s22_q ? patches_smooth_values_0_q : (or_1699_s22_q ? smooth_s22_q : patches_smooth_values_0_q);
  logic [11:0] select_2850;
  assign select_2850 = or_1699_s22_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2852;
  assign select_2852 = equal_1693_s22_q ? patches_smooth_values_1_q : (equal_1695_s22_q ? patches_smooth_values_1_q : select_2850);
  logic [11:0] select_2853;
  assign select_2853 = or_1699_s22_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2855;
  assign select_2855 = equal_1693_s22_q ? patches_smooth_values_2_q : (equal_1695_s22_q ? patches_smooth_values_2_q : select_2853);
  logic [11:0] select_2856;
  assign select_2856 = or_1699_s22_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2858;
  assign select_2858 = equal_1693_s22_q ? patches_smooth_values_3_q : (equal_1695_s22_q ? patches_smooth_values_3_q : select_2856);
  logic [10:0] select_2865;
  assign select_2865 = or_1699_s22_q ? patches_down_values_1_s22_q : patches_down_values_2_q;
  logic [10:0] select_2867;
  assign select_2867 = equal_1693_s22_q ? patches_down_values_2_q : (equal_1695_s22_q ? patches_down_values_2_q : select_2865);
  logic [10:0] select_2868;
  assign select_2868 = or_1699_s22_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_2870;
  assign select_2870 = equal_1693_s22_q ? patches_down_values_3_q : (equal_1695_s22_q ? patches_down_values_3_q : select_2868);
  // hls/stages/patches.hpp:537
  logic select_3322;
  assign select_3322 = less_1854_s22_q ? (not_1856_s22_q & select_3320_s22_q) : select_3320_s22_q;
  logic select_3331;
  assign select_3331 = less_1854_s22_q ? (not_1856_s22_q & select_3329_s22_q) : select_3329_s22_q;
  // hls/stages/patches.hpp:533
  logic [9:0] select_3337;
  assign select_3337 = less_1854_s22_q ? (and_3335_s22_q ? patches_rows_rdata_s22_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:518
  logic [9:0] select_3348;
  assign select_3348 = patches_read_above_q ? patches_read_row_differing_s22_q : patches_peak_above_q;
  // hls/stages/patches.hpp:519
  logic [9:0] select_3350;
  assign select_3350 = patches_read_below_q ? patches_read_row_differing_s22_q : patches_peak_below_q;
  // hls/stages/patches.hpp:556
  logic less_3387;
  assign less_3387 = select_3348 < select_3350;
  // hls/stages/patches.hpp:557
  logic [9:0] high;
  assign high = less_3387 ? select_3350 : select_3348;
  logic [9:0] low;
  assign low = (select_3350 < select_3348) ? select_3350 : select_3348;
  // hls/stages/agreement.hpp:1126
  logic or_3644;
  assign or_3644 = ({counts_textured_s22_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s22_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = less_3648_s22_q | (product_rest_q & equal_3649_s22_q);
  // hls/stages/agreement.hpp:1158
  logic select_3652;
  assign select_3652 = and_3647_s22_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_3655;
  assign sum_3655 = {1'b0, select_2455_s22_q} + {2'h0, select_2455_s22_q[9:1]};
  // hls/stages/patches.hpp:321
  logic select_3699;
  assign select_3699 = equal_1472_s22_q ? (equal_3465_s22_q ? sum_4_s22_q : (product_rest_q | sum_4_s22_q)) : product_rest_q;
  logic [4:0] select_3728;
  assign select_3728 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_3729;
  assign select_3729 = equal_1472_s22_q ? box_textured_sum_sums_values_0_q : select_3728;
  // hls/stages/agreement.hpp:1227
  logic [3:0] select_3814;
  assign select_3814 = select_1924_s22_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3820;
  assign select_3820 = marks_first_s22_q ? (less_3816 ? {sum_3817, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s22_q, or_1881_s22_q, or_1878_s22_q, or_1875_s22_q};
  logic regions_we;
  assign regions_we = s22_en & and_1909_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1908_s22_q, sum_1902_s22_q, sum_1897_s22_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s20_sim;
  logic regions_re_s20_sim;
  logic [5:0] regions_raddr_s21_sim;
  logic regions_re_s21_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s20_sim <= 1'b0;
      regions_re_s21_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s20_sim <= regions_re;
      regions_raddr_s20_sim <= regions_raddr;
      regions_re_s21_sim <= regions_re_s20_sim;
      regions_raddr_s21_sim <= regions_raddr_s20_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s20_sim && regions_raddr_s20_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s21_sim && regions_raddr_s21_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_supervised_q <= 14'h0;
      patches_smooth_values_0_q <= 12'h0;
      patches_smooth_values_1_q <= 12'h0;
      patches_smooth_values_2_q <= 12'h0;
      patches_smooth_values_3_q <= 12'h0;
      patches_down_values_2_q <= 11'h0;
      patches_down_values_3_q <= 11'h0;
      patches_read_above_q <= 1'b0;
      patches_read_below_q <= 1'b0;
      patches_peak_above_q <= 10'h0;
      patches_peak_below_q <= 10'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      began_q <= 1'b0;
      seen_x_q <= 4'h0;
      seen_y_q <= 4'h0;
      seen_column_q <= 8'h0;
      seen_rows_left_q <= 8'h0;
      at_cell_end_q <= 1'b0;
      was_next_row_q <= 1'b0;
      seen_base_q <= 13'h0;
    end else if (s22_en) begin
      counts_supervised_q <= select_2409;
      patches_smooth_values_0_q <= equal_1693_s22_q ? patches_smooth_values_0_q : select_2848;
      patches_smooth_values_1_q <= select_2852;
      patches_smooth_values_2_q <= select_2855;
      patches_smooth_values_3_q <= select_2858;
      patches_down_values_2_q <= select_2867;
      patches_down_values_3_q <= select_2870;
      patches_read_above_q <= equal_1693_s22_q ? select_3322 : patches_read_above_q;
      patches_read_below_q <= equal_1693_s22_q ? select_3331 : patches_read_below_q;
      patches_peak_above_q <= equal_1693_s22_q ? select_3348 : patches_peak_above_q;
      patches_peak_below_q <= equal_1693_s22_q ? select_3350 : patches_peak_below_q;
      product_rest_q <= select_3699;
      disagree_q <= equal_1472_s22_q ? select_3652 : disagree_q;
      began_q <= not_1937 & (began_q | select_1924_s22_q);
      seen_x_q <= select_1924_s22_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s22_q ? 4'h0 : select_3814;
      seen_column_q <= select_1924_s22_q ? 8'h0 : (seen_column_q + {7'h0, equal_1930});
      seen_rows_left_q <= select_3820;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s22_q ? 13'h0 : (seen_base_q + {6'h0, select_1927});
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_columns_values_0_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
    box_textured_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s22_en) begin
      census_columns_values_0_cell_0_mask_q <= select_2083;
      census_columns_values_1_cell_0_mask_q <= select_2099;
      census_columns_values_1_cell_1_mask_q <= select_2102;
      census_columns_values_1_cell_2_mask_q <= select_2105;
      census_columns_values_1_cell_3_mask_q <= select_2109;
      census_columns_values_1_cell_4_mask_q <= select_2112;
      census_columns_values_2_cell_0_mask_q <= select_2115;
      census_columns_values_2_cell_1_mask_q <= select_2118;
      box_textured_sum_sums_values_0_q <= select_3729;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic [7:0] sample_pair_pixel_0_s23_q;
  logic [7:0] sample_pair_pixel_1_s23_q;
  logic sample_pair_whole_s23_q;
  logic sample_present_s23_q;
  logic census_columns_values_1_cell_2_mask_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic census_columns_values_1_cell_3_mask_s23_q;
  logic census_columns_values_1_cell_4_mask_s23_q;
  logic census_columns_values_2_cell_0_mask_s23_q;
  logic census_columns_values_2_cell_1_mask_s23_q;
  logic [6:0] x_s23_q;
  logic [2:0] slot_s23_q;
  logic ends_cell_s23_q;
  logic lower_half_s23_q;
  logic [13:0] counts_supervised_s23_q;
  logic [13:0] counts_textured_s23_q;
  logic [13:0] counts_explained_s23_q;
  logic registration_of_right_s23_q;
  logic [4:0] patches_choosing_band_s23_q;
  logic patches_lower_s23_q;
  logic patches_second_s23_q;
  logic [4:0] patches_code_row_s23_q;
  logic [10:0] patches_down_values_3_s23_q;
  logic [4:0] patches_along_s23_q;
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic patches_read_first_s23_q;
  logic [13:0] product_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic [3:0] select_464_s23_q;
  logic [6:0] select_467_s23_q;
  logic [6:0] column_s23_q;
  logic and_501_s23_q;
  logic and_503_s23_q;
  logic equal_506_s23_q;
  logic whole_2_s23_q;
  logic so_s23_q;
  logic less_537_s23_q;
  logic less_538_s23_q;
  logic less_539_s23_q;
  logic less_540_s23_q;
  logic less_541_s23_q;
  logic less_542_s23_q;
  logic less_543_s23_q;
  logic less_544_s23_q;
  logic less_545_s23_q;
  logic less_546_s23_q;
  logic less_547_s23_q;
  logic less_548_s23_q;
  logic less_549_s23_q;
  logic less_550_s23_q;
  logic less_551_s23_q;
  logic less_552_s23_q;
  logic less_553_s23_q;
  logic less_554_s23_q;
  logic less_555_s23_q;
  logic less_556_s23_q;
  logic less_557_s23_q;
  logic less_558_s23_q;
  logic less_559_s23_q;
  logic less_560_s23_q;
  logic and_568_s23_q;
  logic whole_9_s23_q;
  logic [10:0] sum_601_s23_q;
  logic [9:0] sum_604_s23_q;
  logic [9:0] sum_608_s23_q;
  logic [9:0] sum_612_s23_q;
  logic equal_1472_s23_q;
  logic not_1473_s23_q;
  logic equal_1517_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1523_s23_q;
  logic equal_1525_s23_q;
  logic equal_1527_s23_q;
  logic equal_1529_s23_q;
  logic equal_1531_s23_q;
  logic equal_1533_s23_q;
  logic equal_1535_s23_q;
  logic equal_1537_s23_q;
  logic equal_1539_s23_q;
  logic less_1548_s23_q;
  logic or_1552_s23_q;
  logic [31:0] registration_sums_rdata_s23_q;
  logic equal_1572_s23_q;
  logic and_1582_s23_q;
  logic and_1585_s23_q;
  logic select_1602_s23_q;
  logic equal_1603_s23_q;
  logic [22:0] patches_choices_rdata_s23_q;
  logic and_1611_s23_q;
  logic equal_1613_s23_q;
  logic and_1649_s23_q;
  logic [7:0] select_1655_s23_q;
  logic [5:0] select_1659_s23_q;
  logic [7:0] select_1684_s23_q;
  logic and_1691_s23_q;
  logic and_1692_s23_q;
  logic equal_1693_s23_q;
  logic equal_1695_s23_q;
  logic equal_1698_s23_q;
  logic or_1699_s23_q;
  logic and_1708_s23_q;
  logic [4:0] select_1723_s23_q;
  logic select_1729_s23_q;
  logic [3:0] select_1768_s23_q;
  logic less_1784_s23_q;
  logic new_row_s23_q;
  logic or_1797_s23_q;
  logic [27:0] patches_right_codes_rdata_s23_q;
  logic [1:0] of_row_2_s23_q;
  logic down_2_s23_q;
  logic sum_1811_s23_q;
  logic [12:0] sum_1812_s23_q;
  logic [14:0] difference_1823_s23_q;
  logic and_1839_s23_q;
  logic [47:0] patches_left_codes_rdata_s23_q;
  logic and_1848_s23_q;
  logic and_1853_s23_q;
  logic less_1854_s23_q;
  logic equal_1855_s23_q;
  logic not_1856_s23_q;
  logic equal_1857_s23_q;
  logic not_1883_s23_q;
  logic not_1937_s23_q;
  logic [7:0] sum_1947_s23_q;
  logic equal_1962_s23_q;
  logic or_1967_s23_q;
  logic [23:0] select_1978_s23_q;
  logic not_1998_s23_q;
  logic less_2012_s23_q;
  logic and_2023_s23_q;
  logic [10:0] size_s23_q;
  logic [10:0] size_2_s23_q;
  logic [10:0] sum_2144_s23_q;
  logic [9:0] sum_2147_s23_q;
  logic [9:0] sum_2151_s23_q;
  logic [9:0] sum_2155_s23_q;
  logic equal_2163_s23_q;
  logic [8:0] contrast_s23_q;
  logic [8:0] contrast_2_s23_q;
  logic equal_2216_s23_q;
  logic equal_2287_s23_q;
  logic and_2403_s23_q;
  logic and_2422_s23_q;
  logic not_2426_s23_q;
  logic not_2441_s23_q;
  logic [9:0] select_2452_s23_q;
  logic [9:0] select_2455_s23_q;
  logic and_2518_s23_q;
  logic and_2519_s23_q;
  logic [7:0] residual_s23_q;
  logic less_2552_s23_q;
  logic less_2566_s23_q;
  logic equal_2610_s23_q;
  logic and_2755_s23_q;
  logic less_2882_s23_q;
  logic equal_3225_s23_q;
  logic [4:0] select_3313_s23_q;
  logic [9:0] select_3337_s23_q;
  logic [14:0] select_3344_s23_q;
  logic less_3387_s23_q;
  logic [9:0] high_s23_q;
  logic [9:0] low_s23_q;
  logic equal_3465_s23_q;
  logic equal_3641_s23_q;
  logic or_3644_s23_q;
  logic select_3652_s23_q;
  logic not_3657_s23_q;
  logic equal_3665_s23_q;
  logic equal_3667_s23_q;
  logic equal_3668_s23_q;
  logic equal_3797_s23_q;
  logic equal_3887_s23_q;
  logic [9:0] select_3897_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= line_ended_q;
      sample_pair_pixel_0_s23_q <= sample_pair_pixel_0_s22_q;
      sample_pair_pixel_1_s23_q <= sample_pair_pixel_1_s22_q;
      sample_pair_whole_s23_q <= sample_pair_whole_s22_q;
      sample_present_s23_q <= sample_present_s22_q;
      census_columns_values_1_cell_2_mask_s23_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_s22_q;
      census_columns_values_1_cell_3_mask_s23_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s23_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s23_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s23_q <= census_columns_values_2_cell_1_mask_q;
      x_s23_q <= x_s22_q[6:0];
      slot_s23_q <= slot_s22_q;
      ends_cell_s23_q <= ends_cell_s22_q;
      lower_half_s23_q <= lower_half_s22_q;
      counts_supervised_s23_q <= counts_supervised_q;
      counts_textured_s23_q <= counts_textured_s22_q;
      counts_explained_s23_q <= counts_explained_s22_q;
      registration_of_right_s23_q <= registration_of_right_s22_q;
      patches_choosing_band_s23_q <= patches_choosing_band_s22_q;
      patches_lower_s23_q <= patches_lower_s22_q;
      patches_second_s23_q <= patches_second_s22_q;
      patches_code_row_s23_q <= patches_code_row_s22_q;
      patches_down_values_3_s23_q <= patches_down_values_3_q;
      patches_along_s23_q <= patches_along_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_s22_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_s22_q;
      patches_read_first_s23_q <= patches_read_first_s22_q;
      product_s23_q <= product_s22_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_s22_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_s22_q;
      select_464_s23_q <= select_464_s22_q;
      select_467_s23_q <= select_467_s22_q;
      column_s23_q <= column_s22_q;
      and_501_s23_q <= and_501_s22_q;
      and_503_s23_q <= and_503_s22_q;
      equal_506_s23_q <= equal_506_s22_q;
      whole_2_s23_q <= whole_2_s22_q;
      so_s23_q <= so_s22_q;
      less_537_s23_q <= less_537_s22_q;
      less_538_s23_q <= less_538_s22_q;
      less_539_s23_q <= less_539_s22_q;
      less_540_s23_q <= less_540_s22_q;
      less_541_s23_q <= less_541_s22_q;
      less_542_s23_q <= less_542_s22_q;
      less_543_s23_q <= less_543_s22_q;
      less_544_s23_q <= less_544_s22_q;
      less_545_s23_q <= less_545_s22_q;
      less_546_s23_q <= less_546_s22_q;
      less_547_s23_q <= less_547_s22_q;
      less_548_s23_q <= less_548_s22_q;
      less_549_s23_q <= less_549_s22_q;
      less_550_s23_q <= less_550_s22_q;
      less_551_s23_q <= less_551_s22_q;
      less_552_s23_q <= less_552_s22_q;
      less_553_s23_q <= less_553_s22_q;
      less_554_s23_q <= less_554_s22_q;
      less_555_s23_q <= less_555_s22_q;
      less_556_s23_q <= less_556_s22_q;
      less_557_s23_q <= less_557_s22_q;
      less_558_s23_q <= less_558_s22_q;
      less_559_s23_q <= less_559_s22_q;
      less_560_s23_q <= less_560_s22_q;
      and_568_s23_q <= and_568_s22_q;
      whole_9_s23_q <= whole_9;
      sum_601_s23_q <= {1'b0, sum_597} + {1'b0, sum_600};
      sum_604_s23_q <= {9'h0, difference_602_s22_q} + {1'b0, xor_603_s22_q};
      sum_608_s23_q <= {9'h0, difference_606_s22_q} + {1'b0, xor_607_s22_q};
      sum_612_s23_q <= {9'h0, difference_610_s22_q} + {1'b0, xor_611_s22_q};
      equal_1472_s23_q <= equal_1472_s22_q;
      not_1473_s23_q <= not_1473_s22_q;
      equal_1517_s23_q <= equal_1517_s22_q;
      all_s23_q <= all_s22_q;
      sum_1523_s23_q <= sum_1523_s22_q;
      equal_1525_s23_q <= equal_1525_s22_q;
      equal_1527_s23_q <= equal_1527_s22_q;
      equal_1529_s23_q <= equal_1529_s22_q;
      equal_1531_s23_q <= equal_1531_s22_q;
      equal_1533_s23_q <= equal_1533_s22_q;
      equal_1535_s23_q <= equal_1535_s22_q;
      equal_1537_s23_q <= equal_1537_s22_q;
      equal_1539_s23_q <= equal_1539_s22_q;
      less_1548_s23_q <= less_1548_s22_q;
      or_1552_s23_q <= or_1552_s22_q;
      registration_sums_rdata_s23_q <= registration_sums_rdata_q;
      equal_1572_s23_q <= equal_1572_s22_q;
      and_1582_s23_q <= and_1582_s22_q;
      and_1585_s23_q <= and_1585_s22_q;
      select_1602_s23_q <= select_1602_s22_q;
      equal_1603_s23_q <= equal_1603_s22_q;
      patches_choices_rdata_s23_q <= patches_choices_rdata_q;
      and_1611_s23_q <= and_1611_s22_q;
      equal_1613_s23_q <= equal_1613_s22_q;
      and_1649_s23_q <= and_1649;
      select_1655_s23_q <= equal_1472_s22_q ? 8'h0 : select_1654;
      select_1659_s23_q <= select_1659_s22_q;
      select_1684_s23_q <= select_1684_s22_q;
      and_1691_s23_q <= and_1691_s22_q;
      and_1692_s23_q <= and_1692_s22_q;
      equal_1693_s23_q <= equal_1693_s22_q;
      equal_1695_s23_q <= equal_1695_s22_q;
      equal_1698_s23_q <= equal_1698_s22_q;
      or_1699_s23_q <= or_1699_s22_q;
      and_1708_s23_q <= and_1708_s22_q;
      select_1723_s23_q <= select_1723_s22_q;
      select_1729_s23_q <= select_1729_s22_q;
      select_1768_s23_q <= select_1768_s22_q;
      less_1784_s23_q <= less_1784_s22_q;
      new_row_s23_q <= new_row_s22_q;
      or_1797_s23_q <= or_1797_s22_q;
      patches_right_codes_rdata_s23_q <= patches_right_codes_rdata_q;
      of_row_2_s23_q <= of_row_2_s22_q;
      down_2_s23_q <= down_2_s22_q[0];
      sum_1811_s23_q <= sum_1811[0];
      sum_1812_s23_q <= sum_1812;
      difference_1823_s23_q <= difference_1823;
      and_1839_s23_q <= and_1839_s22_q;
      patches_left_codes_rdata_s23_q <= patches_left_codes_rdata_q;
      and_1848_s23_q <= and_1848_s22_q;
      and_1853_s23_q <= and_1853_s22_q;
      less_1854_s23_q <= less_1854_s22_q;
      equal_1855_s23_q <= equal_1855_s22_q;
      not_1856_s23_q <= not_1856_s22_q;
      equal_1857_s23_q <= equal_1857_s22_q;
      not_1883_s23_q <= not_1883_s22_q;
      not_1937_s23_q <= not_1937;
      sum_1947_s23_q <= {2'h0, x_s22_q[7:2]} + 8'hff;
      equal_1962_s23_q <= t[4:1] == 4'h0;
      or_1967_s23_q <= or_1967_s22_q;
      select_1978_s23_q <= select_1978;
      not_1998_s23_q <= ~({sum_1996, around_s22_q[0]} < {2'h0, t});
      less_2012_s23_q <= less_2012_s22_q;
      and_2023_s23_q <= and_2023_s22_q;
      size_s23_q <= size;
      size_2_s23_q <= size_2;
      sum_2144_s23_q <= {1'b0, sum_2140} + {1'b0, sum_2143};
      sum_2147_s23_q <= {9'h0, difference_2145_s22_q} + {1'b0, xor_2146_s22_q};
      sum_2151_s23_q <= {9'h0, difference_2149_s22_q} + {1'b0, xor_2150_s22_q};
      sum_2155_s23_q <= {9'h0, difference_2153_s22_q} + {1'b0, xor_2154_s22_q};
      equal_2163_s23_q <= equal_2163_s22_q;
      contrast_s23_q <= contrast;
      contrast_2_s23_q <= contrast_2;
      equal_2216_s23_q <= x_s22_q[7:3] == 5'h0;
      equal_2287_s23_q <= equal_2287_s22_q;
      and_2403_s23_q <= and_2403_s22_q;
      and_2422_s23_q <= and_2422_s22_q;
      not_2426_s23_q <= not_2426_s22_q;
      not_2441_s23_q <= ~({sum_2439, e_s22_q[0]} < {2'h0, t});
      select_2452_s23_q <= select_2452_s22_q;
      select_2455_s23_q <= select_2455_s22_q;
      and_2518_s23_q <= and_2518_s22_q;
      and_2519_s23_q <= and_2519_s22_q;
      residual_s23_q <= residual_s22_q[7:0];
      less_2552_s23_q <= $signed(difference_2551) < $signed({7'h0, cfg_moved_limit_i});
      less_2566_s23_q <= less_2566;
      equal_2610_s23_q <= equal_2610_s22_q;
      and_2755_s23_q <= and_2755_s22_q;
      less_2882_s23_q <= less_2882_s22_q;
      equal_3225_s23_q <= equal_3225_s22_q;
      select_3313_s23_q <= select_3313_s22_q;
      select_3337_s23_q <= select_3337;
      select_3344_s23_q <= select_3344_s22_q;
      less_3387_s23_q <= less_3387;
      high_s23_q <= high;
      low_s23_q <= low;
      equal_3465_s23_q <= equal_3465_s22_q;
      equal_3641_s23_q <= select_2452_s22_q[9:3] == 7'h0;
      or_3644_s23_q <= or_3644;
      select_3652_s23_q <= select_3652;
      not_3657_s23_q <= ~({sum_3655, select_2455_s22_q[0]} < {2'h0, select_2452_s22_q});
      equal_3665_s23_q <= equal_3665_s22_q;
      equal_3667_s23_q <= equal_3667_s22_q;
      equal_3668_s23_q <= equal_3668_s22_q;
      equal_3797_s23_q <= equal_3797_s22_q;
      equal_3887_s23_q <= equal_3887_s22_q;
      select_3897_s23_q <= select_3897_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic sharpness_last_mask_q;
  logic sharpness_before_last_mask_q;
  logic [13:0] counts_nearer_q;
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [7:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
  logic [9:0] patches_read_far_q;
  logic [47:0] good_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:443
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s23_q & whole_9_s23_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s23_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s23_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s23_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s23_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:270
  logic [10:0] sum_605;
  assign sum_605 = sum_601_s23_q + {1'b0, sum_604_s23_q};
  // hls/stages/patches.hpp:139
  logic and_1651;
  assign and_1651 = and_1649_s23_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:324
  logic [22:0] select_1685;
  assign select_1685 = and_1651 ? {select_1684_s23_q, select_1659_s23_q, select_1655_s23_q, and_1649_s23_q} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:448
  logic [14:0] sum_1813;
  assign sum_1813 = {{4{patches_down_values_3_s23_q[10]}}, patches_down_values_3_s23_q} + {sum_1812_s23_q, sum_1811_s23_q, down_2_s23_q};
  // hls/stages/agreement.hpp:1235
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1202
  logic select_1935;
  assign select_1935 = marks_first_s23_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1188
  logic [10:0] sum_1936;
  assign sum_1936 = {1'b0, {5{select_1935}}, 1'b0, {2{select_1935}}, 1'b0, select_1935} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1053
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1947_s23_q[7]}}, sum_1947_s23_q, x_s23_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1188
  logic [10:0] sum_1949;
  assign sum_1949 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1043
  logic [47:0] select_1979;
  assign select_1979 = or_1967_s23_q ? {select_1978_s23_q[23], 1'b0, select_1978_s23_q[22], 1'b0, select_1978_s23_q[21], 1'b0, select_1978_s23_q[20], 1'b0, select_1978_s23_q[19], 1'b0, select_1978_s23_q[18], 1'b0, select_1978_s23_q[17], 1'b0, select_1978_s23_q[16], 1'b0, select_1978_s23_q[15], 1'b0, select_1978_s23_q[14], 1'b0, select_1978_s23_q[13], 1'b0, select_1978_s23_q[12], 1'b0, select_1978_s23_q[11], 1'b0, select_1978_s23_q[10], 1'b0, select_1978_s23_q[9], 1'b0, select_1978_s23_q[8], 1'b0, select_1978_s23_q[7], 1'b0, select_1978_s23_q[6], 1'b0, select_1978_s23_q[5], 1'b0, select_1978_s23_q[4], 1'b0, select_1978_s23_q[3], 1'b0, select_1978_s23_q[2], 1'b0, select_1978_s23_q[1], 1'b0, select_1978_s23_q[0], 1'b0} : {1'b0, select_1978_s23_q[23], 1'b0, select_1978_s23_q[22], 1'b0, select_1978_s23_q[21], 1'b0, select_1978_s23_q[20], 1'b0, select_1978_s23_q[19], 1'b0, select_1978_s23_q[18], 1'b0, select_1978_s23_q[17], 1'b0, select_1978_s23_q[16], 1'b0, select_1978_s23_q[15], 1'b0, select_1978_s23_q[14], 1'b0, select_1978_s23_q[13], 1'b0, select_1978_s23_q[12], 1'b0, select_1978_s23_q[11], 1'b0, select_1978_s23_q[10], 1'b0, select_1978_s23_q[9], 1'b0, select_1978_s23_q[8], 1'b0, select_1978_s23_q[7], 1'b0, select_1978_s23_q[6], 1'b0, select_1978_s23_q[5], 1'b0, select_1978_s23_q[4], 1'b0, select_1978_s23_q[3], 1'b0, select_1978_s23_q[2], 1'b0, select_1978_s23_q[1], 1'b0, select_1978_s23_q[0]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s23_q} + (equal_506_s23_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2065;
  assign select_2065 = sample_pair_whole_s23_q ? (and_501_s23_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s23_q} + (equal_506_s23_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2073;
  assign select_2073 = sample_pair_whole_s23_q ? (and_501_s23_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:507
  logic select_2121;
  assign select_2121 = and_503_s23_q ? census_columns_values_1_cell_2_mask_s23_q : census_columns_values_2_cell_2_mask_q;
  logic select_2124;
  assign select_2124 = and_503_s23_q ? census_columns_values_1_cell_3_mask_s23_q : census_columns_values_2_cell_3_mask_q;
  logic select_2127;
  assign select_2127 = and_503_s23_q ? census_columns_values_1_cell_4_mask_s23_q : census_columns_values_2_cell_4_mask_q;
  logic select_2128;
  assign select_2128 = and_503_s23_q ? census_columns_values_2_cell_0_mask_s23_q : census_columns_values_3_cell_0_mask_q;
  logic select_2131;
  assign select_2131 = and_503_s23_q ? census_columns_values_2_cell_1_mask_s23_q : census_columns_values_3_cell_1_mask_q;
  logic select_2132;
  assign select_2132 = and_503_s23_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2135;
  assign select_2135 = and_503_s23_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_2148;
  assign sum_2148 = sum_2144_s23_q + {1'b0, sum_2147_s23_q};
  // hls/stages/agreement.hpp:507
  logic select_2180;
  assign select_2180 = and_503_s23_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2183;
  assign and_2183 = whole_2_s23_q & (~(column_s23_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
  logic and_2189;
  assign and_2189 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s23_q[8:2]));
  logic and_2190;
  assign and_2190 = and_2183 & and_2189;
  logic and_2201;
  assign and_2201 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s23_q[8:2]));
  logic and_2202;
  assign and_2202 = and_2183 & and_2201;
  // hls/stages/census.hpp:409
  logic not_2219;
  assign not_2219 = ~x_s23_q[1];
  logic [2:0] select_2220;
  assign select_2220 = x_s23_q[0] ? {1'b0, not_2219, 1'b0} : {x_s23_q[1], 1'b0, not_2219};
  logic [5:0] select_2221;
  assign select_2221 = slot_s23_q[2] ? {select_2220[2], 1'b0, select_2220[1], 1'b0, select_2220[0], 1'b0} : {1'b0, select_2220[2], 1'b0, select_2220[1], 1'b0, select_2220[0]};
  logic [11:0] select_2222;
  assign select_2222 = slot_s23_q[1] ? {select_2221[5], 1'b0, select_2221[4], 1'b0, select_2221[3], 1'b0, select_2221[2], 1'b0, select_2221[1], 1'b0, select_2221[0], 1'b0} : {1'b0, select_2221[5], 1'b0, select_2221[4], 1'b0, select_2221[3], 1'b0, select_2221[2], 1'b0, select_2221[1], 1'b0, select_2221[0]};
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2424;
  assign select_2424 = and_2403_s23_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2422_s23_q});
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2456;
  assign sum_2456 = {1'b0, select_2455_s23_q} + {3'h0, select_2455_s23_q[9:2]};
  // hls/stages/registration.hpp:107
  logic [7:0] select_2534;
  assign select_2534 = equal_1613_s23_q ? (and_2519_s23_q ? residual_s23_q : 8'h0) : 8'h0;
  logic and_2545;
  assign and_2545 = and_2519_s23_q & ($signed(residual_s23_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2559;
  assign less_2559 = $signed(residual_s23_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2612;
  assign select_2612 = or_1552_s23_q ? 12'h0 : (equal_2610_s23_q ? registration_sums_rdata_s23_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2614;
  assign select_2614 = equal_1517_s23_q ? 12'h0 : (less_1548_s23_q ? select_2612 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2617;
  assign and_2617 = x_s23_q[1] & all_s23_q;
  // hls/stages/agreement.hpp:1084
  logic and_2620;
  assign and_2620 = not_1883_s23_q & (less_1548_s23_q & ({and_2617, x_s23_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2627;
  assign select_2627 = or_1552_s23_q ? 12'h0 : (equal_2610_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2629;
  assign select_2629 = equal_1517_s23_q ? 12'h0 : (less_1548_s23_q ? select_2627 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2635;
  assign not_2635 = ~all_s23_q;
  // hls/stages/agreement.hpp:1084
  logic and_2638;
  assign and_2638 = not_1883_s23_q & (less_1548_s23_q & (x_s23_q[2:0] == {all_s23_q, not_2635, 1'b0}));
  // hls/stages/patches.hpp:321
  logic and_2644;
  assign and_2644 = equal_1472_s23_q & (x_s23_q[6] & (not_1883_s23_q & (less_1548_s23_q & all_s23_q)));
  // hls/stages/registration.hpp:157
  logic equal_2671;
  assign equal_2671 = x_s23_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_2674;
  assign and_2674 = not_1883_s23_q & (less_1548_s23_q & (x_s23_q[5] ? x_s23_q[3] : equal_2671));
  logic and_2683;
  assign and_2683 = not_1883_s23_q & (less_1548_s23_q & ((~x_s23_q[5]) & (x_s23_q[3] & equal_2671)));
  // hls/stages/patches.hpp:326
  logic not_2745;
  assign not_2745 = ~and_1691_s23_q;
  // hls/stages/patches.hpp:482
  logic [27:0] word;
  assign word = or_1797_s23_q ? patches_right_codes_rdata_s23_q : 28'h0;
  // hls/stages/patches.hpp:499
  logic [47:0] select_2915;
  assign select_2915 = new_row_s23_q ? patches_left_codes_rdata_s23_q : patches_left_row_q;
  // hls/stages/patches.hpp:167
  logic [47:0] select_2917;
  assign select_2917 = equal_1693_s23_q ? patches_left_row_q : (equal_1695_s23_q ? select_2915 : patches_left_row_q);
  logic [4:0] select_3262;
  assign select_3262 = equal_1695_s23_q ? patches_along_s23_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:534
  logic [9:0] select_3339;
  assign select_3339 = less_1854_s23_q ? (equal_1857_s23_q ? 10'h3ff : select_3337_s23_q) : 10'h3ff;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3340;
  assign select_3340 = equal_1857_s23_q ? select_3339 : select_3337_s23_q;
  logic [9:0] select_3342;
  assign select_3342 = less_1854_s23_q ? (equal_1855_s23_q ? 10'h3ff : select_3340) : select_3340;
  // hls/stages/patches.hpp:558
  logic [9:0] eight;
  assign eight = high_s23_q - low_s23_q;
  logic [9:0] fall;
  assign fall = high_s23_q - select_3344_s23_q[9:0];
  // hls/stages/agreement.hpp:1086
  logic equal_3568;
  assign equal_3568 = x_s23_q == 7'h7f;
  // hls/stages/agreement.hpp:1077
  logic select_3658;
  assign select_3658 = equal_3641_s23_q ? ((~or_3644_s23_q) & (~select_3652_s23_q)) : not_3657_s23_q;
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_3660;
  assign select_3660 = x_s23_q[6] ? (equal_1517_s23_q ? good_q : {select_3658, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:447
  logic [12:0] select_3800;
  assign select_3800 = equal_2287_s23_q ? (equal_3797_s23_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3803;
  assign select_3803 = and_503_s23_q ? (equal_2287_s23_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3889;
  assign select_3889 = equal_1539_s23_q ? {2'h0, counts_explained_s23_q, 2'h0, counts_textured_s23_q} : (equal_3887_s23_q ? registration_sums_rdata_s23_q : 32'h0);
  logic [31:0] select_3890;
  assign select_3890 = equal_1537_s23_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s23_q} : select_3889;

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s23_q, and_1611_s23_q};
  logic patches_choices_we;
  assign patches_choices_we = s23_en & and_1692_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= select_1685;
  end
`ifndef SYNTHESIS
  logic [5:0] patches_choices_raddr_s22_sim;
  logic patches_choices_re_s22_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choices_re_s22_sim <= 1'b0;
    end else if (en_i) begin
      patches_choices_re_s22_sim <= patches_choices_re;
      patches_choices_raddr_s22_sim <= patches_choices_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_choices_we) begin
      if (patches_choices_re && patches_choices_raddr == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
      if (patches_choices_re_s22_sim && patches_choices_raddr_s22_sim == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_before_last_mask_q <= 1'b0;
      counts_nearer_q <= 14'h0;
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
      patches_read_far_q <= 10'h3ff;
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s23_en) begin
      sharpness_before_last_mask_q <= select_2180;
      counts_nearer_q <= select_2424;
      patches_fixed_q <= not_2745 & (patches_fixed_q | (and_2755_s23_q & and_1651));
      patches_choice_valid_q <= and_1691_s23_q ? (select_1685[0] & not_2745) : select_1685[0];
      patches_choice_column_q <= select_1685[8:1];
      patches_choice_shift_q <= select_1685[14:9];
      patches_choice_slope_q <= select_1685[22:15];
      patches_left_row_q <= select_2917;
      patches_summed_row_column_q <= equal_1693_s23_q ? patches_summed_row_column_q : select_3262;
      patches_read_far_q <= equal_1693_s23_q ? select_3342 : patches_read_far_q;
      good_q <= equal_1472_s23_q ? select_3660 : good_q;
      map_row_q <= and_503_s23_q ? select_3800 : map_row_q;
      map_width_q <= select_3803;
      write_half_q <= marks_first_s23_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1935;
      done_q <= not_1937_s23_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s23_q;
      said_q <= equal_1472_s23_q & equal_3568;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_detail_0_q = 14'h0;
    averager_detail_1_q = 14'h0;
    census_columns_values_2_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_3_mask_q = 1'b0;
    census_columns_values_2_cell_4_mask_q = 1'b0;
    census_columns_values_3_cell_0_mask_q = 1'b0;
    census_columns_values_3_cell_1_mask_q = 1'b0;
    census_columns_values_3_cell_2_mask_q = 1'b0;
    census_columns_values_3_cell_3_mask_q = 1'b0;
    sharpness_last_mask_q = 1'b0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s23_en) begin
      averager_detail_0_q <= select_2065;
      averager_detail_1_q <= select_2073;
      census_columns_values_2_cell_2_mask_q <= select_2121;
      census_columns_values_2_cell_3_mask_q <= select_2124;
      census_columns_values_2_cell_4_mask_q <= select_2127;
      census_columns_values_3_cell_0_mask_q <= select_2128;
      census_columns_values_3_cell_1_mask_q <= select_2131;
      census_columns_values_3_cell_2_mask_q <= select_2132;
      census_columns_values_3_cell_3_mask_q <= select_2135;
      sharpness_last_mask_q <= and_503_s23_q ? whole_2_s23_q : sharpness_last_mask_q;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic [7:0] sample_pair_pixel_0_s24_q;
  logic [7:0] sample_pair_pixel_1_s24_q;
  logic sample_pair_whole_s24_q;
  logic sample_present_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic census_columns_values_2_cell_4_mask_s24_q;
  logic census_columns_values_3_cell_0_mask_s24_q;
  logic census_columns_values_3_cell_1_mask_s24_q;
  logic census_columns_values_3_cell_2_mask_s24_q;
  logic census_columns_values_3_cell_3_mask_s24_q;
  logic [6:0] x_s24_q;
  logic slot_s24_q;
  logic ends_cell_s24_q;
  logic lower_half_s24_q;
  logic [13:0] counts_nearer_s24_q;
  logic registration_of_right_s24_q;
  logic patches_lower_s24_q;
  logic patches_second_s24_q;
  logic [4:0] patches_code_row_s24_q;
  logic [4:0] patches_summed_row_column_s24_q;
  logic patches_summed_last_s24_q;
  logic [4:0] patches_summed_down_by_s24_q;
  logic patches_read_first_s24_q;
  logic [9:0] patches_read_far_s24_q;
  logic [13:0] product_s24_q;
  logic centres_values_1_textured_s24_q;
  logic centres_values_1_of_skin_s24_q;
  logic done_s24_q;
  logic [3:0] select_464_s24_q;
  logic [6:0] select_467_s24_q;
  logic [6:0] column_s24_q;
  logic and_503_s24_q;
  logic less_537_s24_q;
  logic less_538_s24_q;
  logic less_539_s24_q;
  logic less_540_s24_q;
  logic less_541_s24_q;
  logic less_542_s24_q;
  logic less_543_s24_q;
  logic less_544_s24_q;
  logic less_545_s24_q;
  logic less_546_s24_q;
  logic less_547_s24_q;
  logic less_548_s24_q;
  logic less_549_s24_q;
  logic less_550_s24_q;
  logic less_551_s24_q;
  logic less_552_s24_q;
  logic less_553_s24_q;
  logic less_554_s24_q;
  logic less_555_s24_q;
  logic less_556_s24_q;
  logic less_557_s24_q;
  logic less_558_s24_q;
  logic less_559_s24_q;
  logic less_560_s24_q;
  logic and_568_s24_q;
  logic whole_16_s24_q;
  logic and_594_s24_q;
  logic [11:0] sum_609_s24_q;
  logic [9:0] sum_612_s24_q;
  logic equal_1472_s24_q;
  logic not_1473_s24_q;
  logic equal_1517_s24_q;
  logic [1:0] sum_1523_s24_q;
  logic equal_1525_s24_q;
  logic equal_1527_s24_q;
  logic equal_1529_s24_q;
  logic equal_1531_s24_q;
  logic equal_1533_s24_q;
  logic equal_1535_s24_q;
  logic less_1548_s24_q;
  logic [19:0] select_1573_s24_q;
  logic [11:0] select_1578_s24_q;
  logic and_1582_s24_q;
  logic and_1585_s24_q;
  logic select_1602_s24_q;
  logic equal_1603_s24_q;
  logic equal_1613_s24_q;
  logic equal_1693_s24_q;
  logic equal_1695_s24_q;
  logic equal_1698_s24_q;
  logic or_1699_s24_q;
  logic [22:0] select_1709_s24_q;
  logic [4:0] select_1723_s24_q;
  logic select_1729_s24_q;
  logic [3:0] select_1768_s24_q;
  logic less_1784_s24_q;
  logic new_row_s24_q;
  logic [1:0] of_row_2_s24_q;
  logic less_1814_s24_q;
  logic less_1815_s24_q;
  logic less_1824_s24_q;
  logic less_1825_s24_q;
  logic and_1839_s24_q;
  logic and_1848_s24_q;
  logic and_1853_s24_q;
  logic less_1854_s24_q;
  logic equal_1855_s24_q;
  logic not_1856_s24_q;
  logic equal_1857_s24_q;
  logic not_1883_s24_q;
  logic [2:0] index_s24_q;
  logic [10:0] sum_1936_s24_q;
  logic and_1943_s24_q;
  logic less_1944_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1949_s24_q;
  logic equal_1962_s24_q;
  logic not_1982_s24_q;
  logic not_1998_s24_q;
  logic less_2012_s24_q;
  logic and_2023_s24_q;
  logic [11:0] sum_2152_s24_q;
  logic [9:0] sum_2155_s24_q;
  logic equal_2163_s24_q;
  logic [27:0] select_2177_s24_q;
  logic and_2190_s24_q;
  logic and_2202_s24_q;
  logic [8:0] select_2209_s24_q;
  logic [8:0] select_2213_s24_q;
  logic equal_2216_s24_q;
  logic less_2217_s24_q;
  logic [11:0] select_2222_s24_q;
  logic equal_2260_s24_q;
  logic and_2403_s24_q;
  logic not_2426_s24_q;
  logic not_2441_s24_q;
  logic [9:0] select_2452_s24_q;
  logic [9:0] select_2455_s24_q;
  logic less_2457_s24_q;
  logic and_2518_s24_q;
  logic and_2519_s24_q;
  logic [7:0] select_2536_s24_q;
  logic and_2545_s24_q;
  logic and_2553_s24_q;
  logic and_2560_s24_q;
  logic and_2567_s24_q;
  logic [11:0] select_2614_s24_q;
  logic and_2622_s24_q;
  logic [11:0] select_2629_s24_q;
  logic and_2640_s24_q;
  logic and_2644_s24_q;
  logic equal_2671_s24_q;
  logic and_2676_s24_q;
  logic and_2684_s24_q;
  logic [27:0] word_s24_q;
  logic equal_2876_s24_q;
  logic less_2882_s24_q;
  logic [47:0] select_2915_s24_q;
  logic equal_3225_s24_q;
  logic [4:0] select_3313_s24_q;
  logic [14:0] select_3344_s24_q;
  logic less_3387_s24_q;
  logic [9:0] eight_s24_q;
  logic [9:0] fall_s24_q;
  logic equal_3465_s24_q;
  logic equal_3568_s24_q;
  logic or_3644_s24_q;
  logic select_3652_s24_q;
  logic equal_3665_s24_q;
  logic equal_3667_s24_q;
  logic equal_3668_s24_q;
  logic [31:0] select_3890_s24_q;
  logic [9:0] select_3897_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      sample_pair_pixel_0_s24_q <= sample_pair_pixel_0_s23_q;
      sample_pair_pixel_1_s24_q <= sample_pair_pixel_1_s23_q;
      sample_pair_whole_s24_q <= sample_pair_whole_s23_q;
      sample_present_s24_q <= sample_present_s23_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      census_columns_values_2_cell_4_mask_s24_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s24_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s24_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s24_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s24_q <= census_columns_values_3_cell_3_mask_q;
      x_s24_q <= x_s23_q;
      slot_s24_q <= slot_s23_q[0];
      ends_cell_s24_q <= ends_cell_s23_q;
      lower_half_s24_q <= lower_half_s23_q;
      counts_nearer_s24_q <= counts_nearer_q;
      registration_of_right_s24_q <= registration_of_right_s23_q;
      patches_lower_s24_q <= patches_lower_s23_q;
      patches_second_s24_q <= patches_second_s23_q;
      patches_code_row_s24_q <= patches_code_row_s23_q;
      patches_summed_row_column_s24_q <= patches_summed_row_column_q;
      patches_summed_last_s24_q <= patches_summed_last_s23_q;
      patches_summed_down_by_s24_q <= patches_summed_down_by_s23_q;
      patches_read_first_s24_q <= patches_read_first_s23_q;
      patches_read_far_s24_q <= patches_read_far_q;
      product_s24_q <= product_s23_q;
      centres_values_1_textured_s24_q <= centres_values_1_textured_s23_q;
      centres_values_1_of_skin_s24_q <= centres_values_1_of_skin_s23_q;
      done_s24_q <= done_q;
      select_464_s24_q <= select_464_s23_q;
      select_467_s24_q <= select_467_s23_q;
      column_s24_q <= column_s23_q;
      and_503_s24_q <= and_503_s23_q;
      less_537_s24_q <= less_537_s23_q;
      less_538_s24_q <= less_538_s23_q;
      less_539_s24_q <= less_539_s23_q;
      less_540_s24_q <= less_540_s23_q;
      less_541_s24_q <= less_541_s23_q;
      less_542_s24_q <= less_542_s23_q;
      less_543_s24_q <= less_543_s23_q;
      less_544_s24_q <= less_544_s23_q;
      less_545_s24_q <= less_545_s23_q;
      less_546_s24_q <= less_546_s23_q;
      less_547_s24_q <= less_547_s23_q;
      less_548_s24_q <= less_548_s23_q;
      less_549_s24_q <= less_549_s23_q;
      less_550_s24_q <= less_550_s23_q;
      less_551_s24_q <= less_551_s23_q;
      less_552_s24_q <= less_552_s23_q;
      less_553_s24_q <= less_553_s23_q;
      less_554_s24_q <= less_554_s23_q;
      less_555_s24_q <= less_555_s23_q;
      less_556_s24_q <= less_556_s23_q;
      less_557_s24_q <= less_557_s23_q;
      less_558_s24_q <= less_558_s23_q;
      less_559_s24_q <= less_559_s23_q;
      less_560_s24_q <= less_560_s23_q;
      and_568_s24_q <= and_568_s23_q;
      whole_16_s24_q <= whole_16;
      and_594_s24_q <= census_columns_values_1_cell_2_mask_s23_q & and_568_s23_q;
      sum_609_s24_q <= {1'b0, sum_605} + {2'h0, sum_608_s23_q};
      sum_612_s24_q <= sum_612_s23_q;
      equal_1472_s24_q <= equal_1472_s23_q;
      not_1473_s24_q <= not_1473_s23_q;
      equal_1517_s24_q <= equal_1517_s23_q;
      sum_1523_s24_q <= sum_1523_s23_q;
      equal_1525_s24_q <= equal_1525_s23_q;
      equal_1527_s24_q <= equal_1527_s23_q;
      equal_1529_s24_q <= equal_1529_s23_q;
      equal_1531_s24_q <= equal_1531_s23_q;
      equal_1533_s24_q <= equal_1533_s23_q;
      equal_1535_s24_q <= equal_1535_s23_q;
      less_1548_s24_q <= less_1548_s23_q;
      select_1573_s24_q <= equal_1572_s23_q ? registration_sums_rdata_s23_q[19:0] : 20'h0;
      select_1578_s24_q <= equal_1572_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0;
      and_1582_s24_q <= and_1582_s23_q;
      and_1585_s24_q <= and_1585_s23_q;
      select_1602_s24_q <= select_1602_s23_q;
      equal_1603_s24_q <= equal_1603_s23_q;
      equal_1613_s24_q <= equal_1613_s23_q;
      equal_1693_s24_q <= equal_1693_s23_q;
      equal_1695_s24_q <= equal_1695_s23_q;
      equal_1698_s24_q <= equal_1698_s23_q;
      or_1699_s24_q <= or_1699_s23_q;
      select_1709_s24_q <= and_1708_s23_q ? select_1685 : patches_choices_rdata_s23_q;
      select_1723_s24_q <= select_1723_s23_q;
      select_1729_s24_q <= select_1729_s23_q;
      select_1768_s24_q <= select_1768_s23_q;
      less_1784_s24_q <= less_1784_s23_q;
      new_row_s24_q <= new_row_s23_q;
      of_row_2_s24_q <= of_row_2_s23_q;
      less_1814_s24_q <= $signed(15'h100) < $signed(sum_1813);
      less_1815_s24_q <= $signed(sum_1813[14:8]) < $signed(7'h7f);
      less_1824_s24_q <= $signed(15'h100) < $signed(difference_1823_s23_q);
      less_1825_s24_q <= $signed(difference_1823_s23_q[14:8]) < $signed(7'h7f);
      and_1839_s24_q <= and_1839_s23_q;
      and_1848_s24_q <= and_1848_s23_q;
      and_1853_s24_q <= and_1853_s23_q;
      less_1854_s24_q <= less_1854_s23_q;
      equal_1855_s24_q <= equal_1855_s23_q;
      not_1856_s24_q <= not_1856_s23_q;
      equal_1857_s24_q <= equal_1857_s23_q;
      not_1883_s24_q <= not_1883_s23_q;
      index_s24_q <= index[2:0];
      sum_1936_s24_q <= sum_1936;
      and_1943_s24_q <= began_q & (seen_x_q == 4'h0);
      less_1944_s24_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s24_q <= index_2[2:0];
      sum_1949_s24_q <= sum_1949;
      equal_1962_s24_q <= equal_1962_s23_q;
      not_1982_s24_q <= ~((good_q & select_1979) == 48'h0);
      not_1998_s24_q <= not_1998_s23_q;
      less_2012_s24_q <= less_2012_s23_q;
      and_2023_s24_q <= and_2023_s23_q;
      sum_2152_s24_q <= {1'b0, sum_2148} + {2'h0, sum_2151_s23_q};
      sum_2155_s24_q <= sum_2155_s23_q;
      equal_2163_s24_q <= equal_2163_s23_q;
      select_2177_s24_q <= sample_pair_whole_s23_q ? {detail_2, detail} : 28'h0;
      and_2190_s24_q <= and_2190;
      and_2202_s24_q <= and_2202;
      select_2209_s24_q <= and_2190 ? contrast_s23_q : 9'h0;
      select_2213_s24_q <= and_2202 ? contrast_2_s23_q : 9'h0;
      equal_2216_s24_q <= equal_2216_s23_q;
      less_2217_s24_q <= 7'h2 < {x_s23_q[4:0], slot_s23_q[2:1]};
      select_2222_s24_q <= select_2222;
      equal_2260_s24_q <= {x_s23_q[4:0], slot_s23_q} == 8'h0;
      and_2403_s24_q <= and_2403_s23_q;
      not_2426_s24_q <= not_2426_s23_q;
      not_2441_s24_q <= not_2441_s23_q;
      select_2452_s24_q <= select_2452_s23_q;
      select_2455_s24_q <= select_2455_s23_q;
      less_2457_s24_q <= {sum_2456, select_2455_s23_q[1:0]} < {3'h0, select_2452_s23_q};
      and_2518_s24_q <= and_2518_s23_q;
      and_2519_s24_q <= and_2519_s23_q;
      select_2536_s24_q <= equal_1472_s23_q ? 8'h0 : (so_s23_q ? select_2534 : 8'h0);
      and_2545_s24_q <= and_2545;
      and_2553_s24_q <= and_2519_s23_q & less_2552_s23_q;
      and_2560_s24_q <= and_2519_s23_q & less_2559;
      and_2567_s24_q <= and_2519_s23_q & less_2566_s23_q;
      select_2614_s24_q <= select_2614;
      and_2622_s24_q <= equal_1472_s23_q & (x_s23_q[6] & and_2620);
      select_2629_s24_q <= select_2629;
      and_2640_s24_q <= equal_1472_s23_q & (x_s23_q[6] & and_2638);
      and_2644_s24_q <= and_2644;
      equal_2671_s24_q <= equal_2671;
      and_2676_s24_q <= equal_1472_s23_q & (x_s23_q[6] & and_2674);
      and_2684_s24_q <= x_s23_q[6] & and_2683;
      word_s24_q <= word;
      equal_2876_s24_q <= patches_along_s23_q == 5'h7;
      less_2882_s24_q <= less_2882_s23_q;
      select_2915_s24_q <= select_2915;
      equal_3225_s24_q <= equal_3225_s23_q;
      select_3313_s24_q <= select_3313_s23_q;
      select_3344_s24_q <= select_3344_s23_q;
      less_3387_s24_q <= less_3387_s23_q;
      eight_s24_q <= eight;
      fall_s24_q <= fall;
      equal_3465_s24_q <= equal_3465_s23_q;
      equal_3568_s24_q <= equal_3568;
      or_3644_s24_q <= or_3644_s23_q;
      select_3652_s24_q <= select_3652_s23_q;
      equal_3665_s24_q <= equal_3665_s23_q;
      equal_3667_s24_q <= equal_3667_s23_q;
      equal_3668_s24_q <= equal_3668_s23_q;
      select_3890_s24_q <= select_3890;
      select_3897_s24_q <= select_3897_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_3_cell_4_mask_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
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
  logic [7:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic [7:0] patches_place_1_column_q;
  logic [5:0] patches_place_1_shift_q;
  logic [7:0] patches_place_1_slope_q;
  logic [51:0] patches_codes_at_q;
  logic [27:0] patches_codes_further_q;
  logic [55:0] patches_next_codes_q;
  logic patches_summed_first_q;
  logic [9:0] patches_peak_far_q;
  logic good_known_q;
  // hls/stages/agreement.hpp:443
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s24_q & whole_16_s24_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s24_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s24_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s24_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s24_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:270
  logic [11:0] texture;
  assign texture = sum_609_s24_q + {2'h0, sum_612_s24_q};
  // hls/stages/registration.hpp:265
  logic equal_1574;
  assign equal_1574 = sum_1523_s24_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1523_s24_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1576;
  assign select_1576 = equal_1574 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1523_s24_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1580;
  assign select_1580 = equal_1574 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/patches.hpp:335
  logic [21:0] select_1712;
  assign select_1712 = select_1602_s24_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1709_s24_q[22:1];
  // hls/stages/patches.hpp:110
  logic [7:0] select_1713;
  assign select_1713 = equal_1603_s24_q ? patches_place_0_column_q : select_1712[7:0];
  logic [5:0] select_1714;
  assign select_1714 = equal_1603_s24_q ? patches_place_0_shift_q : select_1712[13:8];
  // hls/stages/patches.hpp:335
  logic [21:0] select_1741;
  assign select_1741 = select_1602_s24_q ? select_1709_s24_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:110
  logic [7:0] select_1742;
  assign select_1742 = equal_1603_s24_q ? patches_place_1_column_q : select_1741[7:0];
  logic [5:0] select_1743;
  assign select_1743 = equal_1603_s24_q ? patches_place_1_shift_q : select_1741[13:8];
  // hls/stages/patches.hpp:115
  logic equal_1759;
  assign equal_1759 = {select_1713[7], select_467_s24_q, select_464_s24_q} == {1'b0, select_1713[6:0], 4'h0};
  logic equal_1763;
  assign equal_1763 = {select_1742[7], select_467_s24_q, select_464_s24_q} == {1'b0, select_1742[6:0], 4'h0};
  // hls/stages/patches.hpp:463
  logic [2:0] sum_1805;
  assign sum_1805 = patches_code_row_s24_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:467
  logic [1:0] sum_1843;
  assign sum_1843 = patches_code_row_s24_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:976
  logic and_1983;
  assign and_1983 = good_known_q & not_1982_s24_q;
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_1962_s24_q ? and_1983 : not_1998_s24_q;
  // hls/stages/agreement.hpp:507
  logic select_2136;
  assign select_2136 = and_503_s24_q ? census_columns_values_2_cell_4_mask_s24_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2156;
  assign sum_2156 = sum_2152_s24_q + {2'h0, sum_2155_s24_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2158;
  assign select_2158 = and_503_s24_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2159;
  assign select_2159 = and_503_s24_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2178;
  assign select_2178 = and_503_s24_q ? select_2177_s24_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2179;
  assign select_2179 = and_503_s24_q ? select_2177_s24_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2177_s24_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2177_s24_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_2210;
  assign sum_2210 = (equal_2163_s24_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2209_s24_q};
  logic [23:0] sum_2214;
  assign sum_2214 = (equal_2163_s24_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2213_s24_q};
  // hls/stages/census.hpp:409
  logic less_2218;
  assign less_2218 = x_s24_q[4:0] < 5'h3;
  logic [23:0] select_2223;
  assign select_2223 = slot_s24_q ? {select_2222_s24_q[11], 1'b0, select_2222_s24_q[10], 1'b0, select_2222_s24_q[9], 1'b0, select_2222_s24_q[8], 1'b0, select_2222_s24_q[7], 1'b0, select_2222_s24_q[6], 1'b0, select_2222_s24_q[5], 1'b0, select_2222_s24_q[4], 1'b0, select_2222_s24_q[3], 1'b0, select_2222_s24_q[2], 1'b0, select_2222_s24_q[1], 1'b0, select_2222_s24_q[0], 1'b0} : {1'b0, select_2222_s24_q[11], 1'b0, select_2222_s24_q[10], 1'b0, select_2222_s24_q[9], 1'b0, select_2222_s24_q[8], 1'b0, select_2222_s24_q[7], 1'b0, select_2222_s24_q[6], 1'b0, select_2222_s24_q[5], 1'b0, select_2222_s24_q[4], 1'b0, select_2222_s24_q[3], 1'b0, select_2222_s24_q[2], 1'b0, select_2222_s24_q[1], 1'b0, select_2222_s24_q[0]};
  // hls/stages/census.hpp:372
  logic and_2227;
  assign and_2227 = less_2218 & (~((sharpness_sums_contrast_1_q & select_2223) == 24'h0));
  logic and_2237;
  assign and_2237 = less_2218 & (~((sharpness_sums_contrast_0_q & select_2223) == 24'h0));
  // hls/stages/agreement.hpp:1048
  logic not_2443;
  assign not_2443 = ~(equal_1962_s24_q ? and_1983 : not_2441_s24_q);
  // hls/stages/patches.hpp:321
  logic and_2446;
  assign and_2446 = ends_cell_s24_q & (not_2426_s24_q & (centres_values_1_textured_s24_q & not_2443));
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_2459;
  assign select_2459 = ((~(select_2452_s24_q[9:4] == 6'h0)) & less_2457_s24_q) ? select_2452_s24_q : 10'h0;
  // hls/stages/patches.hpp:321
  logic [9:0] select_2462;
  assign select_2462 = equal_1472_s24_q ? (x_s24_q[6] ? (equal_1517_s24_q ? 10'h0 : select_2459) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1052
  logic and_2480;
  assign and_2480 = centres_values_1_textured_s24_q & (centres_values_1_of_skin_s24_q & not_2443);
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2537;
  assign sum_2537 = registration_half_across_q + {{6{select_2536_s24_q[7]}}, select_2536_s24_q};
  // hls/stages/patches.hpp:321
  logic and_2541;
  assign and_2541 = not_1473_s24_q & (drew_q & (and_2519_s24_q & equal_1613_s24_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2543;
  assign select_2543 = and_2518_s24_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2541});
  // hls/stages/patches.hpp:321
  logic [1:0] select_2547;
  assign select_2547 = drew_q ? (equal_1613_s24_q ? {and_2545_s24_q, and_2519_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2548;
  assign select_2548 = equal_1472_s24_q ? 2'h0 : select_2547;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2549;
  assign sum_2549 = registration_half_votes_down_q + {{5{select_2548[1]}}, select_2548};
  // hls/stages/patches.hpp:321
  logic [1:0] select_2555;
  assign select_2555 = drew_q ? (equal_1613_s24_q ? {and_2553_s24_q, and_2519_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2556;
  assign select_2556 = equal_1472_s24_q ? 2'h0 : select_2555;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2557;
  assign sum_2557 = registration_half_votes_up_q + {{5{select_2556[1]}}, select_2556};
  // hls/stages/patches.hpp:321
  logic [1:0] select_2562;
  assign select_2562 = drew_q ? (equal_1613_s24_q ? {and_2560_s24_q, and_2519_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2563;
  assign select_2563 = equal_1472_s24_q ? 2'h0 : select_2562;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2564;
  assign sum_2564 = registration_half_half_votes_down_q + {{5{select_2563[1]}}, select_2563};
  // hls/stages/patches.hpp:321
  logic [1:0] select_2569;
  assign select_2569 = drew_q ? (equal_1613_s24_q ? {and_2567_s24_q, and_2519_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2570;
  assign select_2570 = equal_1472_s24_q ? 2'h0 : select_2569;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2571;
  assign sum_2571 = registration_half_half_votes_up_q + {{5{select_2570[1]}}, select_2570};
  // hls/stages/patches.hpp:321
  logic and_2605;
  assign and_2605 = equal_1472_s24_q & (x_s24_q[6] & (not_1883_s24_q & less_1548_s24_q));
  logic [11:0] select_2616;
  assign select_2616 = equal_1472_s24_q ? (x_s24_q[6] ? select_2614_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2624;
  assign sum_2624 = {{2{select_2616[11]}}, select_2616} + (and_2622_s24_q ? 14'h0 : registration_down_q);
  // hls/stages/patches.hpp:321
  logic [11:0] select_2631;
  assign select_2631 = equal_1472_s24_q ? (x_s24_q[6] ? select_2629_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2633;
  assign sum_2633 = {{2{select_2631[11]}}, select_2631} + (and_2622_s24_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2645;
  assign not_2645 = ~and_2644_s24_q;
  logic less_2646;
  assign less_2646 = $signed({9'h1, {2{not_2645}}, and_2644_s24_q}) < $signed(registration_up_q[13:2]);
  logic select_2647;
  assign select_2647 = and_2640_s24_q ? less_2646 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_2651;
  assign and_2651 = x_s24_q[6] & (not_1883_s24_q & (less_1548_s24_q & (x_s24_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:321
  logic and_2652;
  assign and_2652 = equal_1472_s24_q & and_2651;
  // hls/stages/registration.hpp:242
  logic less_2653;
  assign less_2653 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2655;
  assign less_2655 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1084
  logic and_2660;
  assign and_2660 = x_s24_q[6] & (not_1883_s24_q & (less_1548_s24_q & (x_s24_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:321
  logic and_2661;
  assign and_2661 = equal_1472_s24_q & and_2660;
  // hls/stages/agreement.hpp:1084
  logic and_2668;
  assign and_2668 = x_s24_q[6] & (not_1883_s24_q & (less_1548_s24_q & (x_s24_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2686;
  assign and_2686 = registration_votes_up_q & registration_other_down_q;
  logic select_2688;
  assign select_2688 = registration_votes_down_q ? (registration_other_up_q | and_2686) : and_2686;
  // hls/stages/registration.hpp:138
  logic and_2690;
  assign and_2690 = (equal_1472_s24_q & and_2684_s24_q) & (registration_other_enough_q & select_2688);
  logic and_2692;
  assign and_2692 = registration_enough_q & ((and_2676_s24_q & (less_2655 | less_2653)) | and_2690);
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2778;
  assign select_2778 = sample_pair_whole_s24_q ? (equal_1603_s24_q ? patches_place_0_slope_q : select_1712[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_2783;
  assign select_2783 = sample_pair_whole_s24_q ? (equal_1603_s24_q ? patches_place_1_slope_q : select_1741[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:499
  logic [55:0] other;
  assign other = new_row_s24_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:167
  logic [51:0] select_2872;
  assign select_2872 = or_1699_s24_q ? {less_1825_s24_q, less_1824_s24_q, less_1815_s24_q, less_1814_s24_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2874;
  assign select_2874 = equal_1693_s24_q ? patches_codes_at_q : (equal_1695_s24_q ? other[55:4] : select_2872);
  // hls/stages/patches.hpp:498
  logic [27:0] select_2877;
  assign select_2877 = equal_2876_s24_q ? word_s24_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:167
  logic [27:0] select_2879;
  assign select_2879 = equal_1695_s24_q ? (new_row_s24_q ? word_s24_q : select_2877) : patches_codes_further_q;
  // hls/stages/patches.hpp:500
  logic [55:0] select_2881;
  assign select_2881 = less_1784_s24_q ? {word_s24_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:470
  logic [55:0] select_2883;
  assign select_2883 = less_2882_s24_q ? {word_s24_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:167
  logic [55:0] select_2885;
  assign select_2885 = or_1699_s24_q ? (equal_1698_s24_q ? patches_next_codes_q : select_2883) : patches_next_codes_q;
  logic [55:0] select_2887;
  assign select_2887 = equal_1693_s24_q ? patches_next_codes_q : (equal_1695_s24_q ? select_2881 : select_2885);
  // hls/stages/count_bits.hpp:24
  logic parity_2892;
  assign parity_2892 = ^{less_1825_s24_q, less_1824_s24_q, less_1815_s24_q, less_1814_s24_q};
  // hls/stages/count_bits.hpp:25
  logic or_2896;
  assign or_2896 = ({less_1815_s24_q, less_1814_s24_q} == 2'h3) | (less_1824_s24_q & (less_1815_s24_q | less_1814_s24_q));
  logic and_2897;
  assign and_2897 = less_1825_s24_q & (^{less_1824_s24_q, less_1815_s24_q, less_1814_s24_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2898;
  assign xor_2898 = or_2896 ^ and_2897;
  // hls/stages/count_bits.hpp:27
  logic and_2899;
  assign and_2899 = or_2896 & and_2897;
  // hls/stages/patches.hpp:167
  logic [2:0] select_2901;
  assign select_2901 = or_1699_s24_q ? (and_1848_s24_q ? {and_2899, xor_2898, parity_2892} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:501
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2915_s24_q;
  // hls/stages/count_bits.hpp:24
  logic xor_2921;
  assign xor_2921 = bits[17] ^ (^{select_2915_s24_q[16:15], other[16:15]});
  logic xor_2924;
  assign xor_2924 = bits[11] ^ (^{select_2915_s24_q[10:9], other[10:9]});
  logic xor_2927;
  assign xor_2927 = bits[14] ^ (^{select_2915_s24_q[13:12], other[13:12]});
  logic xor_2930;
  assign xor_2930 = xor_2921 ^ (^{select_2915_s24_q[14:9], other[14:9]});
  logic xor_2933;
  assign xor_2933 = bits[47] ^ (^{select_2915_s24_q[46:45], other[46:45]});
  logic xor_2936;
  assign xor_2936 = bits[8] ^ (^{select_2915_s24_q[7:6], other[7:6]});
  logic xor_2939;
  assign xor_2939 = bits[2] ^ (^{select_2915_s24_q[1:0], other[1:0]});
  logic xor_2942;
  assign xor_2942 = bits[5] ^ (^{select_2915_s24_q[4:3], other[4:3]});
  logic xor_2945;
  assign xor_2945 = xor_2936 ^ (^{select_2915_s24_q[5:0], other[5:0]});
  logic parity_2947;
  assign parity_2947 = ^{select_2915_s24_q[47:45], select_2915_s24_q[8:0], other[47:45], other[8:0]};
  logic xor_2951;
  assign xor_2951 = bits[44] ^ (^{select_2915_s24_q[43:42], other[43:42]});
  logic xor_2954;
  assign xor_2954 = bits[38] ^ (^{select_2915_s24_q[37:36], other[37:36]});
  logic xor_2957;
  assign xor_2957 = bits[41] ^ (^{select_2915_s24_q[40:39], other[40:39]});
  logic xor_2963;
  assign xor_2963 = bits[26] ^ (^{select_2915_s24_q[25:24], other[25:24]});
  logic xor_2966;
  assign xor_2966 = bits[20] ^ (^{select_2915_s24_q[19:18], other[19:18]});
  logic xor_2969;
  assign xor_2969 = bits[23] ^ (^{select_2915_s24_q[22:21], other[22:21]});
  logic xor_2975;
  assign xor_2975 = bits[35] ^ (^{select_2915_s24_q[34:33], other[34:33]});
  logic xor_2978;
  assign xor_2978 = bits[29] ^ (^{select_2915_s24_q[28:27], other[28:27]});
  logic xor_2981;
  assign xor_2981 = bits[32] ^ (^{select_2915_s24_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:167
  logic select_3265;
  assign select_3265 = equal_1693_s24_q ? patches_summed_first_q : (equal_1695_s24_q ? new_row_s24_q : patches_summed_first_q);
  // hls/stages/patches.hpp:520
  logic [9:0] select_3353;
  assign select_3353 = (patches_read_far_s24_q < patches_peak_far_q) ? patches_read_far_s24_q : patches_peak_far_q;
  logic [9:0] select_3354;
  assign select_3354 = patches_read_first_s24_q ? patches_read_far_s24_q : select_3353;
  // hls/stages/patches.hpp:560
  logic [10:0] sum_3396;
  assign sum_3396 = {1'b0, fall_s24_q} + {2'h0, fall_s24_q[9:1]};
  // hls/stages/patches.hpp:561
  logic [10:0] sum_3400;
  assign sum_3400 = {1'b0, fall_s24_q} + {3'h0, fall_s24_q[9:2]};
  logic not_3405;
  assign not_3405 = ~({eight_s24_q, 3'h0} < ({fall_s24_q, 3'h0} - {3'h0, fall_s24_q}));
  // hls/stages/patches.hpp:574
  logic [7:0] select_3410;
  assign select_3410 = patches_second_s24_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:573
  logic [3:0] sum_3411;
  assign sum_3411 = {2'h0, select_3344_s24_q[14:13]} + 4'hf;
  logic [5:0] select_3412;
  assign select_3412 = patches_second_s24_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3413;
  assign sum_3413 = {select_3412[5], select_3412} + {{4{sum_3411[3]}}, sum_3411[3:1]};
  // hls/stages/patches.hpp:321
  logic select_3664;
  assign select_3664 = equal_1472_s24_q ? ((x_s24_q[6] & good_known_q) | equal_3568_s24_q) : good_known_q;
  // hls/stages/agreement.hpp:1235
  logic and_3826;
  assign and_3826 = and_2023_s24_q & ({sum_1949_s24_q, index_2_s24_q} == {sum_1936_s24_q, index_s24_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1330; read in stage 24, written in stage 25: 24 < 25 < 24 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1936_s24_q, index_s24_q};
  logic map_re;
  assign map_re = s24_en & (and_1943_s24_q & less_1944_s24_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1805, patches_code_row_s24_q[1:0], of_row_2_s24_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s24_en & and_1839_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1825_s24_q, less_1824_s24_q, less_1815_s24_q, less_1814_s24_q, patches_codes_at_q[51:28]};
  end
`ifndef SYNTHESIS
  logic [6:0] patches_right_codes_raddr_s22_sim;
  logic patches_right_codes_re_s22_sim;
  logic [6:0] patches_right_codes_raddr_s23_sim;
  logic patches_right_codes_re_s23_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_codes_re_s22_sim <= 1'b0;
      patches_right_codes_re_s23_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_codes_re_s22_sim <= patches_right_codes_re;
      patches_right_codes_raddr_s22_sim <= patches_right_codes_raddr;
      patches_right_codes_re_s23_sim <= patches_right_codes_re_s22_sim;
      patches_right_codes_raddr_s23_sim <= patches_right_codes_raddr_s22_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s22_sim && patches_right_codes_raddr_s22_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s23_sim && patches_right_codes_raddr_s23_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 7'd112) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 7'd112) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1843, patches_code_row_s24_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s24_en & and_1853_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1825_s24_q, less_1824_s24_q, less_1815_s24_q, less_1814_s24_q, patches_codes_at_q[51:8]};
  end
`ifndef SYNTHESIS
  logic [3:0] patches_left_codes_raddr_s22_sim;
  logic patches_left_codes_re_s22_sim;
  logic [3:0] patches_left_codes_raddr_s23_sim;
  logic patches_left_codes_re_s23_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_codes_re_s22_sim <= 1'b0;
      patches_left_codes_re_s23_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_codes_re_s22_sim <= patches_left_codes_re;
      patches_left_codes_raddr_s22_sim <= patches_left_codes_raddr;
      patches_left_codes_re_s23_sim <= patches_left_codes_re_s22_sim;
      patches_left_codes_raddr_s23_sim <= patches_left_codes_raddr_s22_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s22_sim && patches_left_codes_raddr_s22_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s23_sim && patches_left_codes_raddr_s23_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
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
      patches_place_0_column_q <= 8'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_column_q <= 8'h0;
      patches_place_1_shift_q <= 6'h0;
      patches_place_1_slope_q <= 8'h0;
      patches_codes_at_q <= 52'h0;
      patches_codes_further_q <= 28'h0;
      patches_next_codes_q <= 56'h0;
      patches_summed_first_q <= 1'b0;
      patches_peak_far_q <= 10'h0;
      good_known_q <= 1'b0;
    end else if (s24_en) begin
      sharpness_sums_contrast_0_q <= and_503_s24_q ? sum_2210 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_503_s24_q ? sum_2214 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2518_s24_q ? 14'h0 : sum_2537;
      registration_half_measured_q <= select_2543;
      registration_half_votes_down_q <= and_2518_s24_q ? 7'h0 : sum_2549;
      registration_half_votes_up_q <= and_2518_s24_q ? 7'h0 : sum_2557;
      registration_half_half_votes_down_q <= and_2518_s24_q ? 7'h0 : sum_2564;
      registration_half_half_votes_up_q <= and_2518_s24_q ? 7'h0 : sum_2571;
      registration_down_q <= and_2605 ? sum_2624 : registration_down_q;
      registration_up_q <= and_2605 ? sum_2633 : registration_up_q;
      registration_enough_q <= select_2647;
      registration_votes_down_q <= and_2652 ? less_2653 : registration_votes_down_q;
      registration_votes_up_q <= and_2652 ? less_2655 : registration_votes_up_q;
      registration_other_enough_q <= and_2661 ? select_2647 : registration_other_enough_q;
      registration_other_down_q <= and_2661 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2661 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_column_q <= sample_pair_whole_s24_q ? select_1713 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s24_q ? select_1714 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2778;
      patches_place_1_column_q <= sample_pair_whole_s24_q ? select_1742 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s24_q ? select_1743 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2783;
      patches_codes_at_q <= select_2874;
      patches_codes_further_q <= equal_1693_s24_q ? patches_codes_further_q : select_2879;
      patches_next_codes_q <= select_2887;
      patches_summed_first_q <= select_3265;
      patches_peak_far_q <= equal_1693_s24_q ? select_3354 : patches_peak_far_q;
      good_known_q <= select_3664;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_columns_values_3_cell_4_mask_q = 1'b0;
    census_changes_values_0_left_q = 12'h0;
    census_changes_values_0_right_q = 12'h0;
    census_changes_values_1_left_q = 12'h0;
    census_changes_values_1_right_q = 12'h0;
    sharpness_last_detail_0_q = 14'h0;
    sharpness_last_detail_1_q = 14'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s24_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2136;
      census_changes_values_0_left_q <= and_503_s24_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_503_s24_q ? sum_2156 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2158;
      census_changes_values_1_right_q <= select_2159;
      sharpness_last_detail_0_q <= select_2178;
      sharpness_last_detail_1_q <= select_2179;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic [7:0] sample_pair_pixel_0_s25_q;
  logic [7:0] sample_pair_pixel_1_s25_q;
  logic sample_pair_whole_s25_q;
  logic sample_present_s25_q;
  logic census_columns_values_1_cell_2_of_skin_s25_q;
  logic [11:0] census_changes_values_1_left_s25_q;
  logic [11:0] census_changes_values_1_right_s25_q;
  logic [23:0] sharpness_sums_contrast_0_s25_q;
  logic [23:0] sharpness_sums_contrast_1_s25_q;
  logic [6:0] x_s25_q;
  logic lower_half_s25_q;
  logic [13:0] counts_nearer_s25_q;
  logic registration_of_right_s25_q;
  logic patches_lower_s25_q;
  logic patches_second_s25_q;
  logic [4:0] patches_summed_row_column_s25_q;
  logic patches_summed_first_s25_q;
  logic patches_summed_last_s25_q;
  logic [4:0] patches_summed_down_by_s25_q;
  logic [13:0] product_s25_q;
  logic done_s25_q;
  logic [3:0] select_464_s25_q;
  logic [6:0] select_467_s25_q;
  logic [6:0] column_s25_q;
  logic and_503_s25_q;
  logic so_s25_q;
  logic less_537_s25_q;
  logic less_538_s25_q;
  logic less_539_s25_q;
  logic less_540_s25_q;
  logic less_541_s25_q;
  logic less_542_s25_q;
  logic less_543_s25_q;
  logic less_544_s25_q;
  logic less_545_s25_q;
  logic less_546_s25_q;
  logic less_547_s25_q;
  logic less_548_s25_q;
  logic less_549_s25_q;
  logic less_550_s25_q;
  logic less_551_s25_q;
  logic less_552_s25_q;
  logic less_553_s25_q;
  logic less_554_s25_q;
  logic less_555_s25_q;
  logic less_556_s25_q;
  logic less_557_s25_q;
  logic less_558_s25_q;
  logic less_559_s25_q;
  logic less_560_s25_q;
  logic and_568_s25_q;
  logic and_593_s25_q;
  logic and_594_s25_q;
  logic [12:0] sum_614_s25_q;
  logic equal_1472_s25_q;
  logic not_1473_s25_q;
  logic equal_1517_s25_q;
  logic [1:0] sum_1523_s25_q;
  logic equal_1525_s25_q;
  logic equal_1527_s25_q;
  logic equal_1529_s25_q;
  logic equal_1531_s25_q;
  logic equal_1533_s25_q;
  logic equal_1535_s25_q;
  logic [19:0] sum_1577_s25_q;
  logic [11:0] sum_1581_s25_q;
  logic and_1582_s25_q;
  logic and_1585_s25_q;
  logic select_1602_s25_q;
  logic equal_1603_s25_q;
  logic equal_1693_s25_q;
  logic equal_1695_s25_q;
  logic equal_1698_s25_q;
  logic select_1709_s25_q;
  logic [7:0] sum_1715_s25_q;
  logic [4:0] select_1723_s25_q;
  logic select_1729_s25_q;
  logic [7:0] sum_1744_s25_q;
  logic equal_1759_s25_q;
  logic equal_1763_s25_q;
  logic [3:0] select_1768_s25_q;
  logic less_1854_s25_q;
  logic equal_1855_s25_q;
  logic not_1856_s25_q;
  logic equal_1857_s25_q;
  logic not_1883_s25_q;
  logic and_1943_s25_q;
  logic less_1944_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1949_s25_q;
  logic is_seen_s25_q;
  logic and_2013_s25_q;
  logic and_2023_s25_q;
  logic equal_2163_s25_q;
  logic [12:0] sum_2164_s25_q;
  logic [12:0] select_2192_s25_q;
  logic [12:0] select_2204_s25_q;
  logic equal_2216_s25_q;
  logic less_2217_s25_q;
  logic and_2227_s25_q;
  logic and_2237_s25_q;
  logic equal_2260_s25_q;
  logic and_2403_s25_q;
  logic and_2448_s25_q;
  logic [9:0] select_2452_s25_q;
  logic [9:0] select_2455_s25_q;
  logic [9:0] select_2462_s25_q;
  logic and_2483_s25_q;
  logic not_2670_s25_q;
  logic equal_2671_s25_q;
  logic and_2692_s25_q;
  logic [8:0] other_s25_q;
  logic [2:0] select_2902_s25_q;
  logic [8:0] select_2915_s25_q;
  logic xor_2930_s25_q;
  logic xor_2948_s25_q;
  logic xor_2960_s25_q;
  logic xor_2972_s25_q;
  logic xor_2984_s25_q;
  logic or_2993_s25_q;
  logic or_2997_s25_q;
  logic or_3001_s25_q;
  logic or_3008_s25_q;
  logic or_3012_s25_q;
  logic or_3016_s25_q;
  logic or_3023_s25_q;
  logic or_3027_s25_q;
  logic or_3031_s25_q;
  logic or_3041_s25_q;
  logic or_3045_s25_q;
  logic or_3049_s25_q;
  logic or_3057_s25_q;
  logic or_3061_s25_q;
  logic or_3065_s25_q;
  logic or_3072_s25_q;
  logic or_3076_s25_q;
  logic or_3080_s25_q;
  logic or_3090_s25_q;
  logic or_3094_s25_q;
  logic or_3098_s25_q;
  logic and_3103_s25_q;
  logic or_3104_s25_q;
  logic equal_3225_s25_q;
  logic [4:0] select_3313_s25_q;
  logic [12:0] select_3344_s25_q;
  logic [9:0] select_3354_s25_q;
  logic less_3387_s25_q;
  logic not_3395_s25_q;
  logic not_3398_s25_q;
  logic not_3402_s25_q;
  logic not_3405_s25_q;
  logic [7:0] select_3410_s25_q;
  logic sum_3411_s25_q;
  logic [6:0] sum_3413_s25_q;
  logic equal_3465_s25_q;
  logic equal_3568_s25_q;
  logic or_3644_s25_q;
  logic select_3652_s25_q;
  logic equal_3665_s25_q;
  logic equal_3667_s25_q;
  logic equal_3668_s25_q;
  logic and_3811_s25_q;
  logic and_3826_s25_q;
  logic [31:0] select_3890_s25_q;
  logic [9:0] select_3897_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      sample_pair_pixel_0_s25_q <= sample_pair_pixel_0_s24_q;
      sample_pair_pixel_1_s25_q <= sample_pair_pixel_1_s24_q;
      sample_pair_whole_s25_q <= sample_pair_whole_s24_q;
      sample_present_s25_q <= sample_present_s24_q;
      census_columns_values_1_cell_2_of_skin_s25_q <= census_columns_values_1_cell_2_of_skin_s24_q;
      census_changes_values_1_left_s25_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s25_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s25_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s25_q <= sharpness_sums_contrast_1_q;
      x_s25_q <= x_s24_q;
      lower_half_s25_q <= lower_half_s24_q;
      counts_nearer_s25_q <= counts_nearer_s24_q;
      registration_of_right_s25_q <= registration_of_right_s24_q;
      patches_lower_s25_q <= patches_lower_s24_q;
      patches_second_s25_q <= patches_second_s24_q;
      patches_summed_row_column_s25_q <= patches_summed_row_column_s24_q;
      patches_summed_first_s25_q <= patches_summed_first_q;
      patches_summed_last_s25_q <= patches_summed_last_s24_q;
      patches_summed_down_by_s25_q <= patches_summed_down_by_s24_q;
      product_s25_q <= product_s24_q;
      done_s25_q <= done_s24_q;
      select_464_s25_q <= select_464_s24_q;
      select_467_s25_q <= select_467_s24_q;
      column_s25_q <= column_s24_q;
      and_503_s25_q <= and_503_s24_q;
      so_s25_q <= drew_q;
      less_537_s25_q <= less_537_s24_q;
      less_538_s25_q <= less_538_s24_q;
      less_539_s25_q <= less_539_s24_q;
      less_540_s25_q <= less_540_s24_q;
      less_541_s25_q <= less_541_s24_q;
      less_542_s25_q <= less_542_s24_q;
      less_543_s25_q <= less_543_s24_q;
      less_544_s25_q <= less_544_s24_q;
      less_545_s25_q <= less_545_s24_q;
      less_546_s25_q <= less_546_s24_q;
      less_547_s25_q <= less_547_s24_q;
      less_548_s25_q <= less_548_s24_q;
      less_549_s25_q <= less_549_s24_q;
      less_550_s25_q <= less_550_s24_q;
      less_551_s25_q <= less_551_s24_q;
      less_552_s25_q <= less_552_s24_q;
      less_553_s25_q <= less_553_s24_q;
      less_554_s25_q <= less_554_s24_q;
      less_555_s25_q <= less_555_s24_q;
      less_556_s25_q <= less_556_s24_q;
      less_557_s25_q <= less_557_s24_q;
      less_558_s25_q <= less_558_s24_q;
      less_559_s25_q <= less_559_s24_q;
      less_560_s25_q <= less_560_s24_q;
      and_568_s25_q <= and_568_s24_q;
      and_593_s25_q <= whole_22 & and_568_s24_q;
      and_594_s25_q <= and_594_s24_q;
      sum_614_s25_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1472_s25_q <= equal_1472_s24_q;
      not_1473_s25_q <= not_1473_s24_q;
      equal_1517_s25_q <= equal_1517_s24_q;
      sum_1523_s25_q <= sum_1523_s24_q;
      equal_1525_s25_q <= equal_1525_s24_q;
      equal_1527_s25_q <= equal_1527_s24_q;
      equal_1529_s25_q <= equal_1529_s24_q;
      equal_1531_s25_q <= equal_1531_s24_q;
      equal_1533_s25_q <= equal_1533_s24_q;
      equal_1535_s25_q <= equal_1535_s24_q;
      sum_1577_s25_q <= select_1573_s24_q + {{6{select_1576[13]}}, select_1576};
      sum_1581_s25_q <= select_1578_s24_q + {{5{select_1580[6]}}, select_1580};
      and_1582_s25_q <= and_1582_s24_q;
      and_1585_s25_q <= and_1585_s24_q;
      select_1602_s25_q <= select_1602_s24_q;
      equal_1603_s25_q <= equal_1603_s24_q;
      equal_1693_s25_q <= equal_1693_s24_q;
      equal_1695_s25_q <= equal_1695_s24_q;
      equal_1698_s25_q <= equal_1698_s24_q;
      select_1709_s25_q <= select_1709_s24_q[0];
      sum_1715_s25_q <= select_1713 + {{2{select_1714[5]}}, select_1714};
      select_1723_s25_q <= select_1723_s24_q;
      select_1729_s25_q <= select_1729_s24_q;
      sum_1744_s25_q <= select_1742 + {{2{select_1743[5]}}, select_1743};
      equal_1759_s25_q <= equal_1759;
      equal_1763_s25_q <= equal_1763;
      select_1768_s25_q <= select_1768_s24_q;
      less_1854_s25_q <= less_1854_s24_q;
      equal_1855_s25_q <= equal_1855_s24_q;
      not_1856_s25_q <= not_1856_s24_q;
      equal_1857_s25_q <= equal_1857_s24_q;
      not_1883_s25_q <= not_1883_s24_q;
      and_1943_s25_q <= and_1943_s24_q;
      less_1944_s25_q <= less_1944_s24_q;
      index_2_s25_q <= index_2_s24_q;
      sum_1949_s25_q <= sum_1949_s24_q;
      is_seen_s25_q <= is_seen;
      and_2013_s25_q <= is_seen & less_2012_s24_q;
      and_2023_s25_q <= and_2023_s24_q;
      equal_2163_s25_q <= equal_2163_s24_q;
      sum_2164_s25_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2156};
      select_2192_s25_q <= and_2190_s24_q ? detail_3[14:2] : 13'h0;
      select_2204_s25_q <= and_2202_s24_q ? detail_4[14:2] : 13'h0;
      equal_2216_s25_q <= equal_2216_s24_q;
      less_2217_s25_q <= less_2217_s24_q;
      and_2227_s25_q <= and_2227;
      and_2237_s25_q <= and_2237;
      equal_2260_s25_q <= equal_2260_s24_q;
      and_2403_s25_q <= and_2403_s24_q;
      and_2448_s25_q <= not_1473_s24_q & (drew_q & and_2446);
      select_2452_s25_q <= select_2452_s24_q;
      select_2455_s25_q <= select_2455_s24_q;
      select_2462_s25_q <= select_2462;
      and_2483_s25_q <= drew_q & (ends_cell_s24_q & (not_2426_s24_q & and_2480));
      not_2670_s25_q <= ~(equal_1472_s24_q & and_2668);
      equal_2671_s25_q <= equal_2671_s24_q;
      and_2692_s25_q <= and_2692;
      other_s25_q <= other[44:36];
      select_2902_s25_q <= equal_1695_s24_q ? 3'h0 : select_2901;
      select_2915_s25_q <= select_2915_s24_q[44:36];
      xor_2930_s25_q <= xor_2930;
      xor_2948_s25_q <= xor_2930 ^ parity_2947;
      xor_2960_s25_q <= xor_2951 ^ (^{select_2915_s24_q[41:36], other[41:36]});
      xor_2972_s25_q <= xor_2963 ^ (^{select_2915_s24_q[23:18], other[23:18]});
      xor_2984_s25_q <= xor_2975 ^ (^{select_2915_s24_q[32:27], other[32:27]});
      or_2993_s25_q <= (xor_2924 & xor_2927) | (xor_2921 & (xor_2924 | xor_2927));
      or_2997_s25_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3001_s25_q <= (xor_2939 & xor_2942) | (xor_2936 & (xor_2939 | xor_2942));
      or_3008_s25_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3012_s25_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3016_s25_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3023_s25_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3027_s25_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3031_s25_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3041_s25_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3045_s25_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3049_s25_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3057_s25_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3061_s25_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3065_s25_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3072_s25_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3076_s25_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3080_s25_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3090_s25_q <= (xor_2954 & xor_2957) | (xor_2951 & (xor_2954 | xor_2957));
      or_3094_s25_q <= (xor_2966 & xor_2969) | (xor_2963 & (xor_2966 | xor_2969));
      or_3098_s25_q <= (xor_2978 & xor_2981) | (xor_2975 & (xor_2978 | xor_2981));
      and_3103_s25_q <= xor_2933 & xor_2945;
      or_3104_s25_q <= xor_2933 | xor_2945;
      equal_3225_s25_q <= equal_3225_s24_q;
      select_3313_s25_q <= select_3313_s24_q;
      select_3344_s25_q <= select_3344_s24_q[12:0];
      select_3354_s25_q <= select_3354;
      less_3387_s25_q <= less_3387_s24_q;
      not_3395_s25_q <= ~({eight_s24_q, 3'h0} < {3'h0, fall_s24_q});
      not_3398_s25_q <= ~({eight_s24_q, 3'h0} < {1'b0, sum_3396, fall_s24_q[0]});
      not_3402_s25_q <= ~({eight_s24_q, 3'h0} < {sum_3400, fall_s24_q[1:0]});
      not_3405_s25_q <= not_3405;
      select_3410_s25_q <= select_3410;
      sum_3411_s25_q <= sum_3411[0];
      sum_3413_s25_q <= sum_3413;
      equal_3465_s25_q <= equal_3465_s24_q;
      equal_3568_s25_q <= equal_3568_s24_q;
      or_3644_s25_q <= or_3644_s24_q;
      select_3652_s25_q <= select_3652_s24_q;
      equal_3665_s25_q <= equal_3665_s24_q;
      equal_3667_s25_q <= equal_3667_s24_q;
      equal_3668_s25_q <= equal_3668_s24_q;
      and_3811_s25_q <= said_q;
      and_3826_s25_q <= and_3826;
      select_3890_s25_q <= select_3890_s24_q;
      select_3897_s25_q <= select_3897_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_unproven_q;
  logic registration_moved_q;
  logic patches_place_0_valid_q;
  logic patches_place_1_valid_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic proven_q;
  // hls/stages/census.hpp:281
  logic [13:0] sum_615;
  assign sum_615 = {2'h0, census_changes_values_1_left_s25_q} + {1'b0, sum_614_s25_q};
  logic [13:0] sum_616;
  assign sum_616 = {2'h0, census_changes_values_2_left_q} + sum_615;
  // hls/stages/patches.hpp:110
  logic select_1711;
  assign select_1711 = equal_1603_s25_q ? patches_place_0_valid_q : (select_1602_s25_q ? patches_place_0_valid_q : select_1709_s25_q);
  // hls/stages/patches.hpp:306
  logic [7:0] sum_1716;
  assign sum_1716 = sum_1715_s25_q + 8'hff;
  // hls/stages/patches.hpp:114
  logic equal_1717;
  assign equal_1717 = {sum_1716[7], select_467_s25_q, select_464_s25_q} == {1'b0, sum_1716[6:0], 4'h8};
  // hls/stages/patches.hpp:110
  logic select_1740;
  assign select_1740 = equal_1603_s25_q ? patches_place_1_valid_q : (select_1602_s25_q ? select_1709_s25_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:306
  logic [7:0] sum_1745;
  assign sum_1745 = sum_1744_s25_q + 8'hff;
  // hls/stages/patches.hpp:114
  logic equal_1746;
  assign equal_1746 = {sum_1745[7], select_467_s25_q, select_464_s25_q} == {1'b0, sum_1745[6:0], 4'h8};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2160;
  assign select_2160 = and_503_s25_q ? census_changes_values_1_left_s25_q : census_changes_values_2_left_q;
  logic [11:0] select_2161;
  assign select_2161 = and_503_s25_q ? census_changes_values_1_right_s25_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_2165;
  assign sum_2165 = {2'h0, census_changes_values_1_right_s25_q} + {1'b0, sum_2164_s25_q};
  logic [13:0] sum_2166;
  assign sum_2166 = {2'h0, census_changes_values_2_right_q} + sum_2165;
  // hls/stages/census.hpp:357
  logic [23:0] select_2194;
  assign select_2194 = equal_2163_s25_q ? {11'h0, select_2192_s25_q} : (sharpness_sums_detail_0_q + {11'h0, select_2192_s25_q});
  logic [23:0] select_2206;
  assign select_2206 = equal_2163_s25_q ? {11'h0, select_2204_s25_q} : (sharpness_sums_detail_1_q + {11'h0, select_2204_s25_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_2229;
  assign select_2229 = (less_2217_s25_q & and_2227_s25_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2239;
  assign select_2239 = (less_2217_s25_q & and_2237_s25_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:207
  logic [1:0] select_2248;
  assign select_2248 = equal_2216_s25_q ? {sharpness_comparing_contrast_0_q[0], and_2237_s25_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2250;
  assign select_2250 = equal_2216_s25_q ? {sharpness_comparing_contrast_1_q[0], and_2227_s25_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_2273;
  assign xor_2273 = sharpness_comparing_contrast_0_q[1] ^ and_2227_s25_q;
  logic select_2276;
  assign select_2276 = (equal_2260_s25_q | xor_2273) ? (and_2227_s25_q & xor_2273) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2277;
  assign select_2277 = equal_2216_s25_q ? select_2276 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2279;
  assign xor_2279 = sharpness_comparing_contrast_1_q[1] ^ and_2237_s25_q;
  logic select_2282;
  assign select_2282 = (equal_2260_s25_q | xor_2279) ? (and_2237_s25_q & xor_2279) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2283;
  assign select_2283 = equal_2216_s25_q ? select_2282 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2450;
  assign select_2450 = and_2403_s25_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2448_s25_q});
  logic [13:0] select_2464;
  assign select_2464 = and_2403_s25_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2462_s25_q});
  // hls/stages/patches.hpp:321
  logic and_2484;
  assign and_2484 = not_1473_s25_q & and_2483_s25_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2486;
  assign select_2486 = and_2403_s25_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2484});
  // hls/stages/patches.hpp:150
  logic [9:0] sum_2905;
  assign sum_2905 = {7'h0, patches_set_q} + (equal_1698_s25_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_2985;
  assign xor_2985 = xor_2972_s25_q ^ xor_2984_s25_q;
  // hls/stages/count_bits.hpp:25
  logic or_3110;
  assign or_3110 = (xor_2972_s25_q & xor_2984_s25_q) | (xor_2960_s25_q & (xor_2972_s25_q | xor_2984_s25_q));
  // hls/stages/patches.hpp:560
  logic [1:0] sum_3399;
  assign sum_3399 = {1'b0, not_3395_s25_q} + {1'b0, not_3398_s25_q};
  // hls/stages/patches.hpp:561
  logic [1:0] sum_3406;
  assign sum_3406 = {1'b0, not_3402_s25_q} + {1'b0, not_3405_s25_q};
  // hls/stages/patches.hpp:560
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3399} + {1'b0, sum_3406};
  // hls/stages/patches.hpp:574
  logic [18:0] product_3414;
  assign product_3414 = $signed({{11{select_3410_s25_q[7]}}, select_3410_s25_q}) * $signed({{8{sum_3413_s25_q[6]}}, sum_3413_s25_q, sum_3411_s25_q, select_3344_s25_q[12:10]});
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3670;
  assign select_3670 = equal_3667_s25_q ? counts_skin_unproven_q : (equal_3668_s25_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3665_s25_q ? counts_nearer_s25_q : select_3670;
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3891;
  assign select_3891 = equal_1535_s25_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3890_s25_q;
  logic [31:0] select_3892;
  assign select_3892 = equal_1533_s25_q ? {8'h0, sharpness_sums_detail_0_q} : select_3891;
  logic [31:0] select_3893;
  assign select_3893 = equal_1531_s25_q ? {8'h0, sharpness_sums_detail_1_q} : select_3892;
  logic [31:0] select_3894;
  assign select_3894 = equal_1529_s25_q ? {8'h0, sharpness_sums_contrast_0_s25_q} : select_3893;
  logic [31:0] select_3895;
  assign select_3895 = equal_1527_s25_q ? {8'h0, sharpness_sums_contrast_1_s25_q} : select_3894;

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1523_s25_q, lower_half_s25_q, registration_of_right_s25_q};
  logic registration_sums_we;
  assign registration_sums_we = s25_en & and_1582_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1581_s25_q, sum_1577_s25_q};
  end
`ifndef SYNTHESIS
  logic [3:0] registration_sums_raddr_s22_sim;
  logic registration_sums_re_s22_sim;
  logic [3:0] registration_sums_raddr_s23_sim;
  logic registration_sums_re_s23_sim;
  logic [3:0] registration_sums_raddr_s24_sim;
  logic registration_sums_re_s24_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_sums_re_s22_sim <= 1'b0;
      registration_sums_re_s23_sim <= 1'b0;
      registration_sums_re_s24_sim <= 1'b0;
    end else if (en_i) begin
      registration_sums_re_s22_sim <= registration_sums_re;
      registration_sums_raddr_s22_sim <= registration_sums_raddr;
      registration_sums_re_s23_sim <= registration_sums_re_s22_sim;
      registration_sums_raddr_s23_sim <= registration_sums_raddr_s22_sim;
      registration_sums_re_s24_sim <= registration_sums_re_s23_sim;
      registration_sums_raddr_s24_sim <= registration_sums_raddr_s23_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s22_sim && registration_sums_raddr_s22_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s23_sim && registration_sums_raddr_s23_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s24_sim && registration_sums_raddr_s24_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_waddr >= 4'd12) $error("registration_sums: write outside, address %0d", registration_sums_waddr);
    end
    if (rst_ni && registration_sums_re && registration_sums_raddr >= 4'd12) $error("registration_sums: read outside, address %0d", registration_sums_raddr);
  end
`endif

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1949_s25_q, index_2_s25_q};
  logic map_we;
  assign map_we = s25_en & and_2023_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2013_s25_q, is_seen_s25_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && map_we) begin
      if (map_re && map_raddr == map_waddr) begin
        $error("map: address %0d is read less than DISTANCE steps after its write", map_waddr);
      end
      if (map_waddr >= 14'd16080) $error("map: write outside, address %0d", map_waddr);
    end
    if (rst_ni && map_re && map_raddr >= 14'd16080) $error("map: read outside, address %0d", map_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_comparing_contrast_0_q <= 2'h0;
      sharpness_comparing_contrast_1_q <= 2'h0;
      sharpness_comparing_less_contrast_0_q <= 1'b0;
      sharpness_comparing_less_contrast_1_q <= 1'b0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_unproven_q <= 14'h0;
      registration_moved_q <= 1'b0;
      patches_place_0_valid_q <= 1'b0;
      patches_place_1_valid_q <= 1'b0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      proven_q <= 1'b0;
    end else if (s25_en) begin
      sharpness_sums_detail_0_q <= and_503_s25_q ? select_2194 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_503_s25_q ? select_2206 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s25_q ? select_2248 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s25_q ? select_2250 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s25_q ? select_2277 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s25_q ? select_2283 : sharpness_comparing_less_contrast_1_q;
      counts_unproven_q <= select_2450;
      counts_regions_bad_q <= select_2464;
      counts_skin_unproven_q <= select_2486;
      registration_moved_q <= not_2670_s25_q & (registration_moved_q | and_2692_s25_q);
      patches_place_0_valid_q <= sample_pair_whole_s25_q ? select_1711 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s25_q ? select_1740 : patches_place_1_valid_q;
      patches_set_q <= equal_1693_s25_q ? 3'h0 : select_2902_s25_q;
      patches_size_q <= sum_2905;
      proven_q <= marks_first_s25_q ? done_s25_q : proven_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_changes_values_2_left_q = 12'h0;
    census_changes_values_2_right_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s25_en) begin
      census_changes_values_2_left_q <= select_2160;
      census_changes_values_2_right_q <= select_2161;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic [7:0] sample_pair_pixel_0_s26_q;
  logic [7:0] sample_pair_pixel_1_s26_q;
  logic sample_pair_whole_s26_q;
  logic sample_present_s26_q;
  logic census_columns_values_1_cell_2_of_skin_s26_q;
  logic [6:0] x_s26_q;
  logic registration_moved_s26_q;
  logic patches_lower_s26_q;
  logic patches_second_s26_q;
  logic [4:0] patches_summed_row_column_s26_q;
  logic patches_summed_first_s26_q;
  logic patches_summed_last_s26_q;
  logic [4:0] patches_summed_down_by_s26_q;
  logic [13:0] product_s26_q;
  logic [6:0] column_s26_q;
  logic and_503_s26_q;
  logic so_s26_q;
  logic less_537_s26_q;
  logic less_538_s26_q;
  logic less_539_s26_q;
  logic less_540_s26_q;
  logic less_541_s26_q;
  logic less_542_s26_q;
  logic less_543_s26_q;
  logic less_544_s26_q;
  logic less_545_s26_q;
  logic less_546_s26_q;
  logic less_547_s26_q;
  logic less_548_s26_q;
  logic less_549_s26_q;
  logic less_550_s26_q;
  logic less_551_s26_q;
  logic less_552_s26_q;
  logic less_553_s26_q;
  logic less_554_s26_q;
  logic less_555_s26_q;
  logic less_556_s26_q;
  logic less_557_s26_q;
  logic less_558_s26_q;
  logic less_559_s26_q;
  logic less_560_s26_q;
  logic and_568_s26_q;
  logic and_593_s26_q;
  logic and_594_s26_q;
  logic [8:0] sum_616_s26_q;
  logic equal_1472_s26_q;
  logic equal_1517_s26_q;
  logic equal_1525_s26_q;
  logic and_1585_s26_q;
  logic select_1602_s26_q;
  logic equal_1603_s26_q;
  logic equal_1693_s26_q;
  logic equal_1695_s26_q;
  logic select_1709_s26_q;
  logic select_1711_s26_q;
  logic equal_1717_s26_q;
  logic [4:0] select_1723_s26_q;
  logic select_1729_s26_q;
  logic select_1740_s26_q;
  logic equal_1746_s26_q;
  logic or_1761_s26_q;
  logic or_1765_s26_q;
  logic [3:0] select_1768_s26_q;
  logic less_1854_s26_q;
  logic equal_1855_s26_q;
  logic not_1856_s26_q;
  logic equal_1857_s26_q;
  logic not_1883_s26_q;
  logic and_1943_s26_q;
  logic less_1944_s26_q;
  logic [1:0] map_rdata_s26_q;
  logic is_seen_s26_q;
  logic and_2013_s26_q;
  logic equal_2163_s26_q;
  logic [8:0] sum_2166_s26_q;
  logic equal_2216_s26_q;
  logic less_2217_s26_q;
  logic [17:0] select_2229_s26_q;
  logic [17:0] select_2239_s26_q;
  logic equal_2260_s26_q;
  logic [9:0] select_2452_s26_q;
  logic [9:0] select_2455_s26_q;
  logic equal_2671_s26_q;
  logic parity_2989_s26_q;
  logic or_2993_s26_q;
  logic or_2997_s26_q;
  logic or_3001_s26_q;
  logic or_3008_s26_q;
  logic or_3012_s26_q;
  logic or_3016_s26_q;
  logic or_3023_s26_q;
  logic or_3027_s26_q;
  logic or_3031_s26_q;
  logic or_3041_s26_q;
  logic or_3045_s26_q;
  logic or_3049_s26_q;
  logic or_3057_s26_q;
  logic or_3061_s26_q;
  logic or_3065_s26_q;
  logic or_3072_s26_q;
  logic or_3076_s26_q;
  logic or_3080_s26_q;
  logic or_3090_s26_q;
  logic or_3094_s26_q;
  logic or_3098_s26_q;
  logic and_3102_s26_q;
  logic or_3106_s26_q;
  logic or_3110_s26_q;
  logic equal_3225_s26_q;
  logic [4:0] select_3313_s26_q;
  logic [9:0] select_3344_s26_q;
  logic [9:0] select_3354_s26_q;
  logic less_3387_s26_q;
  logic [2:0] fraction_s26_q;
  logic [13:0] product_3414_s26_q;
  logic equal_3465_s26_q;
  logic equal_3568_s26_q;
  logic or_3644_s26_q;
  logic select_3652_s26_q;
  logic and_3666_s26_q;
  logic [13:0] before_v_4_s26_q;
  logic not_3703_s26_q;
  logic or_3707_s26_q;
  logic and_3811_s26_q;
  logic and_3826_s26_q;
  logic not_3842_s26_q;
  logic [31:0] select_3895_s26_q;
  logic [9:0] select_3897_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      sample_pair_pixel_0_s26_q <= sample_pair_pixel_0_s25_q;
      sample_pair_pixel_1_s26_q <= sample_pair_pixel_1_s25_q;
      sample_pair_whole_s26_q <= sample_pair_whole_s25_q;
      sample_present_s26_q <= sample_present_s25_q;
      census_columns_values_1_cell_2_of_skin_s26_q <= census_columns_values_1_cell_2_of_skin_s25_q;
      x_s26_q <= x_s25_q;
      registration_moved_s26_q <= registration_moved_q;
      patches_lower_s26_q <= patches_lower_s25_q;
      patches_second_s26_q <= patches_second_s25_q;
      patches_summed_row_column_s26_q <= patches_summed_row_column_s25_q;
      patches_summed_first_s26_q <= patches_summed_first_s25_q;
      patches_summed_last_s26_q <= patches_summed_last_s25_q;
      patches_summed_down_by_s26_q <= patches_summed_down_by_s25_q;
      product_s26_q <= product_s25_q;
      column_s26_q <= column_s25_q;
      and_503_s26_q <= and_503_s25_q;
      so_s26_q <= so_s25_q;
      less_537_s26_q <= less_537_s25_q;
      less_538_s26_q <= less_538_s25_q;
      less_539_s26_q <= less_539_s25_q;
      less_540_s26_q <= less_540_s25_q;
      less_541_s26_q <= less_541_s25_q;
      less_542_s26_q <= less_542_s25_q;
      less_543_s26_q <= less_543_s25_q;
      less_544_s26_q <= less_544_s25_q;
      less_545_s26_q <= less_545_s25_q;
      less_546_s26_q <= less_546_s25_q;
      less_547_s26_q <= less_547_s25_q;
      less_548_s26_q <= less_548_s25_q;
      less_549_s26_q <= less_549_s25_q;
      less_550_s26_q <= less_550_s25_q;
      less_551_s26_q <= less_551_s25_q;
      less_552_s26_q <= less_552_s25_q;
      less_553_s26_q <= less_553_s25_q;
      less_554_s26_q <= less_554_s25_q;
      less_555_s26_q <= less_555_s25_q;
      less_556_s26_q <= less_556_s25_q;
      less_557_s26_q <= less_557_s25_q;
      less_558_s26_q <= less_558_s25_q;
      less_559_s26_q <= less_559_s25_q;
      less_560_s26_q <= less_560_s25_q;
      and_568_s26_q <= and_568_s25_q;
      and_593_s26_q <= and_593_s25_q;
      and_594_s26_q <= and_594_s25_q;
      sum_616_s26_q <= sum_616[13:5];
      equal_1472_s26_q <= equal_1472_s25_q;
      equal_1517_s26_q <= equal_1517_s25_q;
      equal_1525_s26_q <= equal_1525_s25_q;
      and_1585_s26_q <= and_1585_s25_q;
      select_1602_s26_q <= select_1602_s25_q;
      equal_1603_s26_q <= equal_1603_s25_q;
      equal_1693_s26_q <= equal_1693_s25_q;
      equal_1695_s26_q <= equal_1695_s25_q;
      select_1709_s26_q <= select_1709_s25_q;
      select_1711_s26_q <= select_1711;
      equal_1717_s26_q <= equal_1717;
      select_1723_s26_q <= select_1723_s25_q;
      select_1729_s26_q <= select_1729_s25_q;
      select_1740_s26_q <= select_1740;
      equal_1746_s26_q <= equal_1746;
      or_1761_s26_q <= and_1585_s25_q | (select_1711 & equal_1759_s25_q);
      or_1765_s26_q <= and_1585_s25_q | (select_1740 & equal_1763_s25_q);
      select_1768_s26_q <= select_1768_s25_q;
      less_1854_s26_q <= less_1854_s25_q;
      equal_1855_s26_q <= equal_1855_s25_q;
      not_1856_s26_q <= not_1856_s25_q;
      equal_1857_s26_q <= equal_1857_s25_q;
      not_1883_s26_q <= not_1883_s25_q;
      and_1943_s26_q <= and_1943_s25_q;
      less_1944_s26_q <= less_1944_s25_q;
      map_rdata_s26_q <= map_rdata_q;
      is_seen_s26_q <= is_seen_s25_q;
      and_2013_s26_q <= and_2013_s25_q;
      equal_2163_s26_q <= equal_2163_s25_q;
      sum_2166_s26_q <= sum_2166[13:5];
      equal_2216_s26_q <= equal_2216_s25_q;
      less_2217_s26_q <= less_2217_s25_q;
      select_2229_s26_q <= select_2229;
      select_2239_s26_q <= select_2239;
      equal_2260_s26_q <= equal_2260_s25_q;
      select_2452_s26_q <= select_2452_s25_q;
      select_2455_s26_q <= select_2455_s25_q;
      equal_2671_s26_q <= equal_2671_s25_q;
      parity_2989_s26_q <= ^{xor_2985, xor_2948_s25_q, select_2915_s25_q, other_s25_q};
      or_2993_s26_q <= or_2993_s25_q;
      or_2997_s26_q <= or_2997_s25_q;
      or_3001_s26_q <= or_3001_s25_q;
      or_3008_s26_q <= or_3008_s25_q;
      or_3012_s26_q <= or_3012_s25_q;
      or_3016_s26_q <= or_3016_s25_q;
      or_3023_s26_q <= or_3023_s25_q;
      or_3027_s26_q <= or_3027_s25_q;
      or_3031_s26_q <= or_3031_s25_q;
      or_3041_s26_q <= or_3041_s25_q;
      or_3045_s26_q <= or_3045_s25_q;
      or_3049_s26_q <= or_3049_s25_q;
      or_3057_s26_q <= or_3057_s25_q;
      or_3061_s26_q <= or_3061_s25_q;
      or_3065_s26_q <= or_3065_s25_q;
      or_3072_s26_q <= or_3072_s25_q;
      or_3076_s26_q <= or_3076_s25_q;
      or_3080_s26_q <= or_3080_s25_q;
      or_3090_s26_q <= or_3090_s25_q;
      or_3094_s26_q <= or_3094_s25_q;
      or_3098_s26_q <= or_3098_s25_q;
      and_3102_s26_q <= xor_2948_s25_q & (^{xor_2985, select_2915_s25_q, other_s25_q});
      or_3106_s26_q <= and_3103_s25_q | (xor_2930_s25_q & or_3104_s25_q);
      or_3110_s26_q <= or_3110;
      equal_3225_s26_q <= equal_3225_s25_q;
      select_3313_s26_q <= select_3313_s25_q;
      select_3344_s26_q <= select_3344_s25_q[9:0];
      select_3354_s26_q <= select_3354_s25_q;
      less_3387_s26_q <= less_3387_s25_q;
      fraction_s26_q <= fraction;
      product_3414_s26_q <= product_3414[18:5];
      equal_3465_s26_q <= equal_3465_s25_q;
      equal_3568_s26_q <= equal_3568_s25_q;
      or_3644_s26_q <= or_3644_s25_q;
      select_3652_s26_q <= select_3652_s25_q;
      and_3666_s26_q <= equal_3665_s25_q & equal_3465_s25_q;
      before_v_4_s26_q <= before_v_4;
      not_3703_s26_q <= ~(equal_3668_s25_q & equal_3465_s25_q);
      or_3707_s26_q <= (equal_3668_s25_q | equal_3667_s25_q) | (x_s25_q[6:3] == 4'hf);
      and_3811_s26_q <= and_3811_s25_q;
      and_3826_s26_q <= and_3826_s25_q;
      not_3842_s26_q <= ~proven_q;
      select_3895_s26_q <= select_3895;
      select_3897_s26_q <= select_3897_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic hides_q;
  // hls/stages/patches.hpp:117
  logic [4:0] select_1762;
  assign select_1762 = or_1761_s26_q ? {and_1585_s26_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1766;
  assign select_1766 = or_1765_s26_q ? {and_1585_s26_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:125
  logic [3:0] column_5;
  assign column_5 = select_1762[4] ? select_1766[3:0] : select_1762[3:0];
  logic and_1771;
  assign and_1771 = select_1729_s26_q & (select_1723_s26_q[3] ^ select_1723_s26_q[4]);
  logic and_1776;
  assign and_1776 = sample_pair_whole_s26_q & (and_1771 & ((~select_1762[4]) | (~select_1766[4])));
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2229_s26_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2232;
  assign select_2232 = equal_2216_s26_q ? (less_2217_s26_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2239_s26_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2242;
  assign select_2242 = equal_2216_s26_q ? (less_2217_s26_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2802;
  assign select_2802 = sample_pair_whole_s26_q ? (select_1762[4] ? {1'b1, select_1762[3:0]} : (select_1762 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2805;
  assign select_2805 = sample_pair_whole_s26_q ? (select_1766[4] ? {1'b1, select_1766[3:0]} : (select_1766 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3019;
  assign parity_3019 = ^{or_3016_s26_q, or_3012_s26_q, or_3008_s26_q};
  logic parity_3034;
  assign parity_3034 = ^{or_3031_s26_q, or_3027_s26_q, or_3023_s26_q};
  logic parity_3037;
  assign parity_3037 = ^{or_3031_s26_q, or_3027_s26_q, or_3023_s26_q, or_3016_s26_q, or_3012_s26_q, or_3008_s26_q, or_3001_s26_q, or_2997_s26_q, or_2993_s26_q};
  logic parity_3068;
  assign parity_3068 = ^{or_3065_s26_q, or_3061_s26_q, or_3057_s26_q};
  logic parity_3083;
  assign parity_3083 = ^{or_3080_s26_q, or_3076_s26_q, or_3072_s26_q};
  logic parity_3086;
  assign parity_3086 = ^{or_3080_s26_q, or_3076_s26_q, or_3072_s26_q, or_3065_s26_q, or_3061_s26_q, or_3057_s26_q, or_3049_s26_q, or_3045_s26_q, or_3041_s26_q};
  logic parity_3101;
  assign parity_3101 = ^{or_3098_s26_q, or_3094_s26_q, or_3090_s26_q};
  logic parity_3113;
  assign parity_3113 = ^{or_3110_s26_q, or_3106_s26_q, and_3102_s26_q};
  logic parity_3116;
  assign parity_3116 = ^{or_3110_s26_q, or_3106_s26_q, and_3102_s26_q, or_3098_s26_q, or_3094_s26_q, or_3090_s26_q, or_3080_s26_q, or_3076_s26_q, or_3072_s26_q, or_3065_s26_q, or_3061_s26_q, or_3057_s26_q, or_3049_s26_q, or_3045_s26_q, or_3041_s26_q};
  logic parity_3118;
  assign parity_3118 = ^{or_3110_s26_q, or_3106_s26_q, and_3102_s26_q, or_3098_s26_q, or_3094_s26_q, or_3090_s26_q, or_3080_s26_q, or_3076_s26_q, or_3072_s26_q, or_3065_s26_q, or_3061_s26_q, or_3057_s26_q, or_3049_s26_q, or_3045_s26_q, or_3041_s26_q, or_3031_s26_q, or_3027_s26_q, or_3023_s26_q, or_3016_s26_q, or_3012_s26_q, or_3008_s26_q, or_3001_s26_q, or_2997_s26_q, or_2993_s26_q};
  // hls/stages/count_bits.hpp:25
  logic and_3119;
  assign and_3119 = parity_3037 & parity_3116;
  logic and_3122;
  assign and_3122 = (^{or_3001_s26_q, or_2997_s26_q, or_2993_s26_q}) & (parity_3019 | parity_3034);
  logic or_3123;
  assign or_3123 = (parity_3019 & parity_3034) | and_3122;
  logic or_3127;
  assign or_3127 = (parity_3101 & parity_3113) | (parity_3086 & (parity_3101 | parity_3113));
  logic and_3133;
  assign and_3133 = (^{or_3049_s26_q, or_3045_s26_q, or_3041_s26_q}) & (parity_3068 | parity_3083);
  logic or_3134;
  assign or_3134 = (parity_3068 & parity_3083) | and_3133;
  logic or_3138;
  assign or_3138 = (or_3094_s26_q & or_3098_s26_q) | (or_3090_s26_q & (or_3094_s26_q | or_3098_s26_q));
  logic or_3142;
  assign or_3142 = (or_3106_s26_q & or_3110_s26_q) | (and_3102_s26_q & (or_3106_s26_q | or_3110_s26_q));
  // hls/stages/count_bits.hpp:23
  logic or_3149;
  assign or_3149 = (or_3045_s26_q & or_3049_s26_q) | (or_3041_s26_q & (or_3045_s26_q | or_3049_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3153;
  assign or_3153 = (or_3061_s26_q & or_3065_s26_q) | (or_3057_s26_q & (or_3061_s26_q | or_3065_s26_q));
  logic or_3157;
  assign or_3157 = (or_3076_s26_q & or_3080_s26_q) | (or_3072_s26_q & (or_3076_s26_q | or_3080_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3160;
  assign parity_3160 = ^{or_3157, or_3153, or_3149};
  // hls/stages/count_bits.hpp:23
  logic or_3164;
  assign or_3164 = (or_2997_s26_q & or_3001_s26_q) | (or_2993_s26_q & (or_2997_s26_q | or_3001_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3168;
  assign or_3168 = (or_3012_s26_q & or_3016_s26_q) | (or_3008_s26_q & (or_3012_s26_q | or_3016_s26_q));
  logic or_3172;
  assign or_3172 = (or_3027_s26_q & or_3031_s26_q) | (or_3023_s26_q & (or_3027_s26_q | or_3031_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3175;
  assign parity_3175 = ^{or_3172, or_3168, or_3164};
  logic parity_3178;
  assign parity_3178 = ^{or_3172, or_3168, or_3164, or_3157, or_3153, or_3149, or_3142, or_3138, or_3134};
  // hls/stages/patches.hpp:571
  logic [9:0] difference_3357;
  assign difference_3357 = select_3354_s26_q - select_3344_s26_q;
  // hls/stages/patches.hpp:576
  logic or_3364;
  assign or_3364 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3344_s26_q);
  // hls/stages/patches.hpp:562
  logic [1:0] sum_3388;
  assign sum_3388 = select_3313_s26_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:563
  logic [7:0] difference_3408;
  assign difference_3408 = {sum_3388, select_3313_s26_q[2:0], 3'h0} - {5'h0, fraction_s26_q};
  logic [7:0] select_3409;
  assign select_3409 = less_3387_s26_q ? difference_3408 : {sum_3388, select_3313_s26_q[2:0], fraction_s26_q};
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_s26_q} - {1'b0, before_v_4_s26_q};
  // hls/stages/agreement.hpp:1161
  logic select_3673;
  assign select_3673 = and_3666_s26_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1235
  logic [1:0] select_3827;
  assign select_3827 = and_3826_s26_q ? {and_2013_s26_q, is_seen_s26_q} : map_rdata_s26_q;
  // hls/stages/agreement.hpp:1236
  logic and_3828;
  assign and_3828 = proven_q & less_3816;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      hides_q <= 1'b0;
    end else if (s26_en) begin
      sharpness_comparing_rest_0_q <= so_s26_q ? select_2232 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s26_q ? select_2242 : sharpness_comparing_rest_1_q;
      patches_left_next_0_q <= select_2802;
      patches_left_next_1_q <= select_2805;
      hides_q <= equal_1472_s26_q ? select_3673 : hides_q;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic [7:0] sample_pair_pixel_0_s27_q;
  logic [7:0] sample_pair_pixel_1_s27_q;
  logic sample_pair_whole_s27_q;
  logic sample_present_s27_q;
  logic census_columns_values_1_cell_2_of_skin_s27_q;
  logic [6:0] x_s27_q;
  logic registration_moved_s27_q;
  logic patches_lower_s27_q;
  logic patches_second_s27_q;
  logic [4:0] patches_summed_row_column_s27_q;
  logic patches_summed_first_s27_q;
  logic patches_summed_last_s27_q;
  logic [4:0] patches_summed_down_by_s27_q;
  logic [6:0] column_s27_q;
  logic and_503_s27_q;
  logic so_s27_q;
  logic less_537_s27_q;
  logic less_538_s27_q;
  logic less_539_s27_q;
  logic less_540_s27_q;
  logic less_541_s27_q;
  logic less_542_s27_q;
  logic less_543_s27_q;
  logic less_544_s27_q;
  logic less_545_s27_q;
  logic less_546_s27_q;
  logic less_547_s27_q;
  logic less_548_s27_q;
  logic less_549_s27_q;
  logic less_550_s27_q;
  logic less_551_s27_q;
  logic less_552_s27_q;
  logic less_553_s27_q;
  logic less_554_s27_q;
  logic less_555_s27_q;
  logic less_556_s27_q;
  logic less_557_s27_q;
  logic less_558_s27_q;
  logic less_559_s27_q;
  logic less_560_s27_q;
  logic and_568_s27_q;
  logic and_593_s27_q;
  logic and_594_s27_q;
  logic less_617_s27_q;
  logic equal_1472_s27_q;
  logic equal_1517_s27_q;
  logic equal_1525_s27_q;
  logic and_1585_s27_q;
  logic select_1602_s27_q;
  logic equal_1603_s27_q;
  logic equal_1693_s27_q;
  logic equal_1695_s27_q;
  logic select_1709_s27_q;
  logic or_1719_s27_q;
  logic [4:0] select_1723_s27_q;
  logic select_1729_s27_q;
  logic or_1748_s27_q;
  logic [3:0] column_5_s27_q;
  logic [3:0] select_1768_s27_q;
  logic select_1769_s27_q;
  logic and_1776_s27_q;
  logic less_1854_s27_q;
  logic equal_1855_s27_q;
  logic not_1856_s27_q;
  logic equal_1857_s27_q;
  logic not_1883_s27_q;
  logic and_1943_s27_q;
  logic less_1944_s27_q;
  logic equal_2163_s27_q;
  logic and_2168_s27_q;
  logic equal_2216_s27_q;
  logic sum_s27_q;
  logic sum_2_s27_q;
  logic equal_2260_s27_q;
  logic select_2278_s27_q;
  logic select_2284_s27_q;
  logic [9:0] select_2452_s27_q;
  logic [9:0] select_2455_s27_q;
  logic equal_2671_s27_q;
  logic parity_2989_s27_q;
  logic parity_3118_s27_q;
  logic and_3119_s27_q;
  logic or_3123_s27_q;
  logic or_3127_s27_q;
  logic or_3134_s27_q;
  logic or_3138_s27_q;
  logic or_3142_s27_q;
  logic or_3149_s27_q;
  logic or_3153_s27_q;
  logic or_3157_s27_q;
  logic or_3164_s27_q;
  logic or_3168_s27_q;
  logic or_3172_s27_q;
  logic parity_3178_s27_q;
  logic or_3188_s27_q;
  logic or_3192_s27_q;
  logic and_3199_s27_q;
  logic and_3201_s27_q;
  logic and_3203_s27_q;
  logic equal_3225_s27_q;
  logic equal_3356_s27_q;
  logic less_3358_s27_q;
  logic less_3359_s27_q;
  logic or_3364_s27_q;
  logic [7:0] select_3409_s27_q;
  logic [13:0] product_3414_s27_q;
  logic equal_3465_s27_q;
  logic equal_3568_s27_q;
  logic or_3644_s27_q;
  logic select_3652_s27_q;
  logic select_3673_s27_q;
  logic and_3701_s27_q;
  logic not_3703_s27_q;
  logic or_3707_s27_q;
  logic and_3811_s27_q;
  logic and_3829_s27_q;
  logic and_3832_s27_q;
  logic not_3842_s27_q;
  logic [31:0] select_3895_s27_q;
  logic [9:0] select_3897_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      sample_pair_pixel_0_s27_q <= sample_pair_pixel_0_s26_q;
      sample_pair_pixel_1_s27_q <= sample_pair_pixel_1_s26_q;
      sample_pair_whole_s27_q <= sample_pair_whole_s26_q;
      sample_present_s27_q <= sample_present_s26_q;
      census_columns_values_1_cell_2_of_skin_s27_q <= census_columns_values_1_cell_2_of_skin_s26_q;
      x_s27_q <= x_s26_q;
      registration_moved_s27_q <= registration_moved_s26_q;
      patches_lower_s27_q <= patches_lower_s26_q;
      patches_second_s27_q <= patches_second_s26_q;
      patches_summed_row_column_s27_q <= patches_summed_row_column_s26_q;
      patches_summed_first_s27_q <= patches_summed_first_s26_q;
      patches_summed_last_s27_q <= patches_summed_last_s26_q;
      patches_summed_down_by_s27_q <= patches_summed_down_by_s26_q;
      column_s27_q <= column_s26_q;
      and_503_s27_q <= and_503_s26_q;
      so_s27_q <= so_s26_q;
      less_537_s27_q <= less_537_s26_q;
      less_538_s27_q <= less_538_s26_q;
      less_539_s27_q <= less_539_s26_q;
      less_540_s27_q <= less_540_s26_q;
      less_541_s27_q <= less_541_s26_q;
      less_542_s27_q <= less_542_s26_q;
      less_543_s27_q <= less_543_s26_q;
      less_544_s27_q <= less_544_s26_q;
      less_545_s27_q <= less_545_s26_q;
      less_546_s27_q <= less_546_s26_q;
      less_547_s27_q <= less_547_s26_q;
      less_548_s27_q <= less_548_s26_q;
      less_549_s27_q <= less_549_s26_q;
      less_550_s27_q <= less_550_s26_q;
      less_551_s27_q <= less_551_s26_q;
      less_552_s27_q <= less_552_s26_q;
      less_553_s27_q <= less_553_s26_q;
      less_554_s27_q <= less_554_s26_q;
      less_555_s27_q <= less_555_s26_q;
      less_556_s27_q <= less_556_s26_q;
      less_557_s27_q <= less_557_s26_q;
      less_558_s27_q <= less_558_s26_q;
      less_559_s27_q <= less_559_s26_q;
      less_560_s27_q <= less_560_s26_q;
      and_568_s27_q <= and_568_s26_q;
      and_593_s27_q <= and_593_s26_q;
      and_594_s27_q <= and_594_s26_q;
      less_617_s27_q <= 9'h4 < sum_616_s26_q;
      equal_1472_s27_q <= equal_1472_s26_q;
      equal_1517_s27_q <= equal_1517_s26_q;
      equal_1525_s27_q <= equal_1525_s26_q;
      and_1585_s27_q <= and_1585_s26_q;
      select_1602_s27_q <= select_1602_s26_q;
      equal_1603_s27_q <= equal_1603_s26_q;
      equal_1693_s27_q <= equal_1693_s26_q;
      equal_1695_s27_q <= equal_1695_s26_q;
      select_1709_s27_q <= select_1709_s26_q;
      or_1719_s27_q <= and_1585_s26_q | (select_1711_s26_q & equal_1717_s26_q);
      select_1723_s27_q <= select_1723_s26_q;
      select_1729_s27_q <= select_1729_s26_q;
      or_1748_s27_q <= and_1585_s26_q | (select_1740_s26_q & equal_1746_s26_q);
      column_5_s27_q <= column_5;
      select_1768_s27_q <= select_1768_s26_q;
      select_1769_s27_q <= or_1761_s26_q ? and_1585_s26_q : patches_left_next_0_q[4];
      and_1776_s27_q <= and_1776;
      less_1854_s27_q <= less_1854_s26_q;
      equal_1855_s27_q <= equal_1855_s26_q;
      not_1856_s27_q <= not_1856_s26_q;
      equal_1857_s27_q <= equal_1857_s26_q;
      not_1883_s27_q <= not_1883_s26_q;
      and_1943_s27_q <= and_1943_s26_q;
      less_1944_s27_q <= less_1944_s26_q;
      equal_2163_s27_q <= equal_2163_s26_q;
      and_2168_s27_q <= and_593_s26_q & (9'h4 < sum_2166_s26_q);
      equal_2216_s27_q <= equal_2216_s26_q;
      sum_s27_q <= sum[0];
      sum_2_s27_q <= sum_2[0];
      equal_2260_s27_q <= equal_2260_s26_q;
      select_2278_s27_q <= sharpness_comparing_less_contrast_0_q;
      select_2284_s27_q <= sharpness_comparing_less_contrast_1_q;
      select_2452_s27_q <= select_2452_s26_q;
      select_2455_s27_q <= select_2455_s26_q;
      equal_2671_s27_q <= equal_2671_s26_q;
      parity_2989_s27_q <= parity_2989_s26_q;
      parity_3118_s27_q <= parity_3118;
      and_3119_s27_q <= and_3119;
      or_3123_s27_q <= or_3123;
      or_3127_s27_q <= or_3127;
      or_3134_s27_q <= or_3134;
      or_3138_s27_q <= or_3138;
      or_3142_s27_q <= or_3142;
      or_3149_s27_q <= or_3149;
      or_3153_s27_q <= or_3153;
      or_3157_s27_q <= or_3157;
      or_3164_s27_q <= or_3164;
      or_3168_s27_q <= or_3168;
      or_3172_s27_q <= or_3172;
      parity_3178_s27_q <= parity_3178;
      or_3188_s27_q <= (or_3153 & or_3157) | (or_3149 & (or_3153 | or_3157));
      or_3192_s27_q <= (or_3168 & or_3172) | (or_3164 & (or_3168 | or_3172));
      and_3199_s27_q <= and_3119 & (or_3123 | or_3127);
      and_3201_s27_q <= parity_3160 & parity_3175;
      and_3203_s27_q <= (^{or_3142, or_3138, or_3134}) & (parity_3160 | parity_3175);
      equal_3225_s27_q <= equal_3225_s26_q;
      equal_3356_s27_q <= select_3313_s26_q[3:0] == 4'h0;
      less_3358_s27_q <= {difference_3357, 3'h0} < {3'h0, patches_size_q};
      less_3359_s27_q <= select_3354_s26_q < select_3344_s26_q;
      or_3364_s27_q <= or_3364;
      select_3409_s27_q <= select_3409;
      product_3414_s27_q <= product_3414_s26_q;
      equal_3465_s27_q <= equal_3465_s26_q;
      equal_3568_s27_q <= equal_3568_s26_q;
      or_3644_s27_q <= or_3644_s26_q;
      select_3652_s27_q <= select_3652_s26_q;
      select_3673_s27_q <= select_3673;
      and_3701_s27_q <= over[14] & equal_3465_s26_q;
      not_3703_s27_q <= not_3703_s26_q;
      or_3707_s27_q <= or_3707_s26_q;
      and_3811_s27_q <= and_3811_s26_q;
      and_3829_s27_q <= select_3827[0] & and_3828;
      and_3832_s27_q <= select_3827[1] & and_3828;
      not_3842_s27_q <= not_3842_s26_q;
      select_3895_s27_q <= select_3895_s26_q;
      select_3897_s27_q <= select_3897_s26_q;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:303
  logic and_618;
  assign and_618 = and_568_s27_q & less_617_s27_q;
  // hls/stages/patches.hpp:116
  logic [5:0] select_1730;
  assign select_1730 = or_1719_s27_q ? {and_1585_s27_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:120
  logic and_1732;
  assign and_1732 = select_1729_s27_q & (~select_1730[5]);
  // hls/stages/patches.hpp:116
  logic [5:0] select_1750;
  assign select_1750 = or_1748_s27_q ? {and_1585_s27_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:120
  logic and_1752;
  assign and_1752 = select_1729_s27_q & (~select_1750[5]);
  // hls/stages/census.hpp:306
  logic and_2169;
  assign and_2169 = and_593_s27_q & less_617_s27_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2170;
  assign sum_2170 = census_left_misses_q + {{17{and_2169}}, and_2168_s27_q, 1'b0, and_2168_s27_q};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2172;
  assign select_2172 = and_503_s27_q ? (equal_2163_s27_q ? 20'h0 : sum_2170) : census_left_misses_q;
  // hls/stages/agreement.hpp:207
  logic [2:0] select_2244;
  assign select_2244 = equal_2216_s27_q ? {sharpness_comparing_product_0_q[1:0], sum_s27_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2246;
  assign select_2246 = equal_2216_s27_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s27_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s27_q});
  // hls/stages/agreement.hpp:207
  logic select_2255;
  assign select_2255 = so_s27_q ? (equal_2216_s27_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s27_q});
  // hls/stages/agreement.hpp:207
  logic select_2258;
  assign select_2258 = equal_2216_s27_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_2261;
  assign xor_2261 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2267;
  assign xor_2267 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:110
  logic select_2785;
  assign select_2785 = equal_1603_s27_q ? patches_valid_0_q : (select_1602_s27_q ? patches_valid_0_q : select_1709_s27_q);
  // hls/stages/agreement.hpp:263
  logic select_2788;
  assign select_2788 = sample_pair_whole_s27_q ? (and_1732 ? (sample_present_s27_q & select_2785) : select_2785) : patches_valid_0_q;
  // hls/stages/patches.hpp:110
  logic select_2790;
  assign select_2790 = equal_1603_s27_q ? patches_valid_1_q : (select_1602_s27_q ? select_1709_s27_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2793;
  assign select_2793 = sample_pair_whole_s27_q ? (and_1752 ? (sample_present_s27_q & select_2790) : select_2790) : patches_valid_1_q;
  logic [5:0] select_2796;
  assign select_2796 = sample_pair_whole_s27_q ? (select_1730[5] ? {1'b1, select_1730[4:0]} : (select_1730 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2799;
  assign select_2799 = sample_pair_whole_s27_q ? (select_1750[5] ? {1'b1, select_1750[4:0]} : (select_1750 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3180;
  assign parity_3180 = ^{or_3172_s27_q, or_3168_s27_q, or_3164_s27_q, or_3157_s27_q, or_3153_s27_q, or_3149_s27_q, or_3142_s27_q, or_3138_s27_q, or_3134_s27_q, or_3127_s27_q, or_3123_s27_q, and_3119_s27_q};
  // hls/stages/count_bits.hpp:25
  logic or_3184;
  assign or_3184 = (or_3138_s27_q & or_3142_s27_q) | (or_3134_s27_q & (or_3138_s27_q | or_3142_s27_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3195;
  assign parity_3195 = ^{or_3192_s27_q, or_3188_s27_q, or_3184};
  // hls/stages/count_bits.hpp:25
  logic and_3196;
  assign and_3196 = (^{or_3127_s27_q, or_3123_s27_q, and_3119_s27_q}) & parity_3178_s27_q;
  logic or_3200;
  assign or_3200 = (or_3123_s27_q & or_3127_s27_q) | and_3199_s27_q;
  logic or_3204;
  assign or_3204 = and_3201_s27_q | and_3203_s27_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3207;
  assign parity_3207 = ^{or_3204, or_3200, and_3196};
  // hls/stages/count_bits.hpp:25
  logic and_3209;
  assign and_3209 = parity_3195 & parity_3207;
  logic or_3213;
  assign or_3213 = (or_3188_s27_q & or_3192_s27_q) | (or_3184 & (or_3188_s27_q | or_3192_s27_q));
  logic or_3217;
  assign or_3217 = (or_3200 & or_3204) | (and_3196 & (or_3200 | or_3204));
  // hls/stages/patches.hpp:576
  logic or_3365;
  assign or_3365 = (~(patches_second_s27_q ? patches_valid_1_q : patches_valid_0_q)) | or_3364_s27_q;
  logic or_3368;
  assign or_3368 = equal_3356_s27_q | (less_3358_s27_q | (less_3359_s27_q | or_3365));
  // hls/stages/patches.hpp:575
  logic [14:0] difference_3415;
  assign difference_3415 = {{7{select_3409_s27_q[7]}}, select_3409_s27_q} - {product_3414_s27_q[13], product_3414_s27_q};
  // hls/stages/patches.hpp:581
  logic less_3416;
  assign less_3416 = $signed({{8{difference_3386[6]}}, difference_3386}) < $signed(difference_3415);
  // hls/stages/agreement.hpp:1086
  logic not_3674;
  assign not_3674 = ~hidden_for_q[7];
  logic [7:0] select_3676;
  assign select_3676 = select_3673_s27_q ? (hidden_for_q + {7'h0, not_3674}) : 8'h0;
  // hls/stages/patches.hpp:321
  logic [7:0] select_3678;
  assign select_3678 = equal_1472_s27_q ? (equal_3568_s27_q ? select_3676 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1159
  logic and_3704;
  assign and_3704 = too_much_q & not_3703_s27_q;
  // hls/stages/agreement.hpp:1160
  logic select_3709;
  assign select_3709 = and_3701_s27_q ? (and_3704 | or_3707_s27_q) : and_3704;
  // hls/stages/agreement.hpp:424
  logic select_3831;
  assign select_3831 = and_1943_s27_q ? (less_1944_s27_q ? and_3829_s27_q : seen_q) : seen_q;
  logic select_3834;
  assign select_3834 = and_1943_s27_q ? (less_1944_s27_q ? and_3832_s27_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1088
  logic or_3861;
  assign or_3861 = select_2278_s27_q | ($signed(20'h0) < $signed(census_left_misses_q));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s27_q;
  logic fresh_we;
  assign fresh_we = s27_en & and_503_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s27_q, and_618, and_594_s27_q, and_593_s27_q, and_568_s27_q, less_560_s27_q, less_559_s27_q, less_558_s27_q, less_557_s27_q, less_556_s27_q, less_555_s27_q, less_554_s27_q, less_553_s27_q, less_552_s27_q, less_551_s27_q, less_550_s27_q, less_549_s27_q, less_548_s27_q, less_547_s27_q, less_546_s27_q, less_545_s27_q, less_544_s27_q, less_543_s27_q, less_542_s27_q, less_541_s27_q, less_540_s27_q, less_539_s27_q, less_538_s27_q, less_537_s27_q};
  end
`ifndef SYNTHESIS
  logic [6:0] fresh_raddr_s8_sim;
  logic fresh_re_s8_sim;
  logic [6:0] fresh_raddr_s9_sim;
  logic fresh_re_s9_sim;
  logic [6:0] fresh_raddr_s10_sim;
  logic fresh_re_s10_sim;
  logic [6:0] fresh_raddr_s11_sim;
  logic fresh_re_s11_sim;
  logic [6:0] fresh_raddr_s12_sim;
  logic fresh_re_s12_sim;
  logic [6:0] fresh_raddr_s13_sim;
  logic fresh_re_s13_sim;
  logic [6:0] fresh_raddr_s14_sim;
  logic fresh_re_s14_sim;
  logic [6:0] fresh_raddr_s15_sim;
  logic fresh_re_s15_sim;
  logic [6:0] fresh_raddr_s16_sim;
  logic fresh_re_s16_sim;
  logic [6:0] fresh_raddr_s17_sim;
  logic fresh_re_s17_sim;
  logic [6:0] fresh_raddr_s18_sim;
  logic fresh_re_s18_sim;
  logic [6:0] fresh_raddr_s19_sim;
  logic fresh_re_s19_sim;
  logic [6:0] fresh_raddr_s20_sim;
  logic fresh_re_s20_sim;
  logic [6:0] fresh_raddr_s21_sim;
  logic fresh_re_s21_sim;
  logic [6:0] fresh_raddr_s22_sim;
  logic fresh_re_s22_sim;
  logic [6:0] fresh_raddr_s23_sim;
  logic fresh_re_s23_sim;
  logic [6:0] fresh_raddr_s24_sim;
  logic fresh_re_s24_sim;
  logic [6:0] fresh_raddr_s25_sim;
  logic fresh_re_s25_sim;
  logic [6:0] fresh_raddr_s26_sim;
  logic fresh_re_s26_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s8_sim <= 1'b0;
      fresh_re_s9_sim <= 1'b0;
      fresh_re_s10_sim <= 1'b0;
      fresh_re_s11_sim <= 1'b0;
      fresh_re_s12_sim <= 1'b0;
      fresh_re_s13_sim <= 1'b0;
      fresh_re_s14_sim <= 1'b0;
      fresh_re_s15_sim <= 1'b0;
      fresh_re_s16_sim <= 1'b0;
      fresh_re_s17_sim <= 1'b0;
      fresh_re_s18_sim <= 1'b0;
      fresh_re_s19_sim <= 1'b0;
      fresh_re_s20_sim <= 1'b0;
      fresh_re_s21_sim <= 1'b0;
      fresh_re_s22_sim <= 1'b0;
      fresh_re_s23_sim <= 1'b0;
      fresh_re_s24_sim <= 1'b0;
      fresh_re_s25_sim <= 1'b0;
      fresh_re_s26_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s8_sim <= fresh_re;
      fresh_raddr_s8_sim <= fresh_raddr;
      fresh_re_s9_sim <= fresh_re_s8_sim;
      fresh_raddr_s9_sim <= fresh_raddr_s8_sim;
      fresh_re_s10_sim <= fresh_re_s9_sim;
      fresh_raddr_s10_sim <= fresh_raddr_s9_sim;
      fresh_re_s11_sim <= fresh_re_s10_sim;
      fresh_raddr_s11_sim <= fresh_raddr_s10_sim;
      fresh_re_s12_sim <= fresh_re_s11_sim;
      fresh_raddr_s12_sim <= fresh_raddr_s11_sim;
      fresh_re_s13_sim <= fresh_re_s12_sim;
      fresh_raddr_s13_sim <= fresh_raddr_s12_sim;
      fresh_re_s14_sim <= fresh_re_s13_sim;
      fresh_raddr_s14_sim <= fresh_raddr_s13_sim;
      fresh_re_s15_sim <= fresh_re_s14_sim;
      fresh_raddr_s15_sim <= fresh_raddr_s14_sim;
      fresh_re_s16_sim <= fresh_re_s15_sim;
      fresh_raddr_s16_sim <= fresh_raddr_s15_sim;
      fresh_re_s17_sim <= fresh_re_s16_sim;
      fresh_raddr_s17_sim <= fresh_raddr_s16_sim;
      fresh_re_s18_sim <= fresh_re_s17_sim;
      fresh_raddr_s18_sim <= fresh_raddr_s17_sim;
      fresh_re_s19_sim <= fresh_re_s18_sim;
      fresh_raddr_s19_sim <= fresh_raddr_s18_sim;
      fresh_re_s20_sim <= fresh_re_s19_sim;
      fresh_raddr_s20_sim <= fresh_raddr_s19_sim;
      fresh_re_s21_sim <= fresh_re_s20_sim;
      fresh_raddr_s21_sim <= fresh_raddr_s20_sim;
      fresh_re_s22_sim <= fresh_re_s21_sim;
      fresh_raddr_s22_sim <= fresh_raddr_s21_sim;
      fresh_re_s23_sim <= fresh_re_s22_sim;
      fresh_raddr_s23_sim <= fresh_raddr_s22_sim;
      fresh_re_s24_sim <= fresh_re_s23_sim;
      fresh_raddr_s24_sim <= fresh_raddr_s23_sim;
      fresh_re_s25_sim <= fresh_re_s24_sim;
      fresh_raddr_s25_sim <= fresh_raddr_s24_sim;
      fresh_re_s26_sim <= fresh_re_s25_sim;
      fresh_raddr_s26_sim <= fresh_raddr_s25_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s8_sim && fresh_raddr_s8_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s9_sim && fresh_raddr_s9_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s10_sim && fresh_raddr_s10_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s11_sim && fresh_raddr_s11_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s12_sim && fresh_raddr_s12_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s13_sim && fresh_raddr_s13_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s14_sim && fresh_raddr_s14_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s15_sim && fresh_raddr_s15_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s16_sim && fresh_raddr_s16_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s17_sim && fresh_raddr_s17_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s18_sim && fresh_raddr_s18_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s19_sim && fresh_raddr_s19_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s20_sim && fresh_raddr_s20_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s21_sim && fresh_raddr_s21_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s22_sim && fresh_raddr_s22_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s23_sim && fresh_raddr_s23_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s24_sim && fresh_raddr_s24_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s25_sim && fresh_raddr_s25_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_re_s26_sim && fresh_raddr_s26_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_waddr >= 7'd120) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd120) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1769_s27_q, select_1768_s27_q, column_5_s27_q};
  logic patches_left_we;
  assign patches_left_we = s27_en & and_1776_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s27_q;
  end
`ifndef SYNTHESIS
  logic [8:0] patches_left_raddr_s17_sim;
  logic patches_left_re_s17_sim;
  logic [8:0] patches_left_raddr_s18_sim;
  logic patches_left_re_s18_sim;
  logic [8:0] patches_left_raddr_s19_sim;
  logic patches_left_re_s19_sim;
  logic [8:0] patches_left_raddr_s20_sim;
  logic patches_left_re_s20_sim;
  logic [8:0] patches_left_raddr_s21_sim;
  logic patches_left_re_s21_sim;
  logic [8:0] patches_left_raddr_s22_sim;
  logic patches_left_re_s22_sim;
  logic [8:0] patches_left_raddr_s23_sim;
  logic patches_left_re_s23_sim;
  logic [8:0] patches_left_raddr_s24_sim;
  logic patches_left_re_s24_sim;
  logic [8:0] patches_left_raddr_s25_sim;
  logic patches_left_re_s25_sim;
  logic [8:0] patches_left_raddr_s26_sim;
  logic patches_left_re_s26_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_re_s17_sim <= 1'b0;
      patches_left_re_s18_sim <= 1'b0;
      patches_left_re_s19_sim <= 1'b0;
      patches_left_re_s20_sim <= 1'b0;
      patches_left_re_s21_sim <= 1'b0;
      patches_left_re_s22_sim <= 1'b0;
      patches_left_re_s23_sim <= 1'b0;
      patches_left_re_s24_sim <= 1'b0;
      patches_left_re_s25_sim <= 1'b0;
      patches_left_re_s26_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_re_s17_sim <= patches_left_re;
      patches_left_raddr_s17_sim <= patches_left_raddr;
      patches_left_re_s18_sim <= patches_left_re_s17_sim;
      patches_left_raddr_s18_sim <= patches_left_raddr_s17_sim;
      patches_left_re_s19_sim <= patches_left_re_s18_sim;
      patches_left_raddr_s19_sim <= patches_left_raddr_s18_sim;
      patches_left_re_s20_sim <= patches_left_re_s19_sim;
      patches_left_raddr_s20_sim <= patches_left_raddr_s19_sim;
      patches_left_re_s21_sim <= patches_left_re_s20_sim;
      patches_left_raddr_s21_sim <= patches_left_raddr_s20_sim;
      patches_left_re_s22_sim <= patches_left_re_s21_sim;
      patches_left_raddr_s22_sim <= patches_left_raddr_s21_sim;
      patches_left_re_s23_sim <= patches_left_re_s22_sim;
      patches_left_raddr_s23_sim <= patches_left_raddr_s22_sim;
      patches_left_re_s24_sim <= patches_left_re_s23_sim;
      patches_left_raddr_s24_sim <= patches_left_raddr_s23_sim;
      patches_left_re_s25_sim <= patches_left_re_s24_sim;
      patches_left_raddr_s25_sim <= patches_left_raddr_s24_sim;
      patches_left_re_s26_sim <= patches_left_re_s25_sim;
      patches_left_raddr_s26_sim <= patches_left_raddr_s25_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_we) begin
      if (patches_left_re && patches_left_raddr == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s17_sim && patches_left_raddr_s17_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s18_sim && patches_left_raddr_s18_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s19_sim && patches_left_raddr_s19_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s20_sim && patches_left_raddr_s20_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s21_sim && patches_left_raddr_s21_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s22_sim && patches_left_raddr_s22_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s23_sim && patches_left_raddr_s23_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s24_sim && patches_left_raddr_s24_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s25_sim && patches_left_raddr_s25_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s26_sim && patches_left_raddr_s26_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_left_misses_q <= 20'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s27_en) begin
      census_left_misses_q <= select_2172;
      sharpness_comparing_product_0_q <= so_s27_q ? select_2244 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s27_q ? select_2246 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2255;
      sharpness_comparing_carry_1_q <= so_s27_q ? select_2258 : sharpness_comparing_carry_1_q;
      patches_valid_0_q <= select_2788;
      patches_valid_1_q <= select_2793;
      patches_right_next_0_q <= select_2796;
      patches_right_next_1_q <= select_2799;
      hidden_for_q <= select_3678;
      too_much_q <= equal_1472_s27_q ? select_3709 : too_much_q;
      seen_q <= select_3831;
      nearer_q <= select_3834;
    end
  end

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic [7:0] sample_pair_pixel_1_s28_q;
  logic [6:0] x_s28_q;
  logic registration_moved_s28_q;
  logic patches_lower_s28_q;
  logic patches_second_s28_q;
  logic [4:0] patches_summed_row_column_s28_q;
  logic patches_summed_first_s28_q;
  logic patches_summed_last_s28_q;
  logic [4:0] patches_summed_down_by_s28_q;
  logic so_s28_q;
  logic equal_1472_s28_q;
  logic equal_1517_s28_q;
  logic equal_1525_s28_q;
  logic equal_1693_s28_q;
  logic equal_1695_s28_q;
  logic [4:0] select_1720_s28_q;
  logic [4:0] select_1723_s28_q;
  logic and_1733_s28_q;
  logic [4:0] select_1749_s28_q;
  logic and_1753_s28_q;
  logic less_1854_s28_q;
  logic equal_1855_s28_q;
  logic not_1856_s28_q;
  logic equal_1857_s28_q;
  logic not_1883_s28_q;
  logic equal_2216_s28_q;
  logic or_2262_s28_q;
  logic and_2263_s28_q;
  logic or_2268_s28_q;
  logic and_2269_s28_q;
  logic select_2284_s28_q;
  logic [9:0] select_2452_s28_q;
  logic [9:0] select_2455_s28_q;
  logic equal_2671_s28_q;
  logic parity_2989_s28_q;
  logic parity_3118_s28_q;
  logic parity_3180_s28_q;
  logic xor_3208_s28_q;
  logic parity_3220_s28_q;
  logic and_3221_s28_q;
  logic and_3223_s28_q;
  logic equal_3225_s28_q;
  logic or_3368_s28_q;
  logic [5:0] difference_3415_s28_q;
  logic not_3417_s28_q;
  logic not_3427_s28_q;
  logic equal_3465_s28_q;
  logic less_3539_s28_q;
  logic less_3540_s28_q;
  logic equal_3568_s28_q;
  logic or_3644_s28_q;
  logic and_3811_s28_q;
  logic not_3842_s28_q;
  logic or_3852_s28_q;
  logic or_3861_s28_q;
  logic not_3873_s28_q;
  logic [31:0] select_3895_s28_q;
  logic [9:0] select_3897_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      sample_pair_pixel_1_s28_q <= sample_pair_pixel_1_s27_q;
      x_s28_q <= x_s27_q;
      registration_moved_s28_q <= registration_moved_s27_q;
      patches_lower_s28_q <= patches_lower_s27_q;
      patches_second_s28_q <= patches_second_s27_q;
      patches_summed_row_column_s28_q <= patches_summed_row_column_s27_q;
      patches_summed_first_s28_q <= patches_summed_first_s27_q;
      patches_summed_last_s28_q <= patches_summed_last_s27_q;
      patches_summed_down_by_s28_q <= patches_summed_down_by_s27_q;
      so_s28_q <= so_s27_q;
      equal_1472_s28_q <= equal_1472_s27_q;
      equal_1517_s28_q <= equal_1517_s27_q;
      equal_1525_s28_q <= equal_1525_s27_q;
      equal_1693_s28_q <= equal_1693_s27_q;
      equal_1695_s28_q <= equal_1695_s27_q;
      select_1720_s28_q <= or_1719_s27_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1723_s28_q <= select_1723_s27_q;
      and_1733_s28_q <= sample_pair_whole_s27_q & and_1732;
      select_1749_s28_q <= or_1748_s27_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1753_s28_q <= sample_pair_whole_s27_q & and_1752;
      less_1854_s28_q <= less_1854_s27_q;
      equal_1855_s28_q <= equal_1855_s27_q;
      not_1856_s28_q <= not_1856_s27_q;
      equal_1857_s28_q <= equal_1857_s27_q;
      not_1883_s28_q <= not_1883_s27_q;
      equal_2216_s28_q <= equal_2216_s27_q;
      or_2262_s28_q <= equal_2260_s27_q | xor_2261;
      and_2263_s28_q <= five_times[0] & xor_2261;
      or_2268_s28_q <= equal_2260_s27_q | xor_2267;
      and_2269_s28_q <= five_times_2[0] & xor_2267;
      select_2284_s28_q <= select_2284_s27_q;
      select_2452_s28_q <= select_2452_s27_q;
      select_2455_s28_q <= select_2455_s27_q;
      equal_2671_s28_q <= equal_2671_s27_q;
      parity_2989_s28_q <= parity_2989_s27_q;
      parity_3118_s28_q <= parity_3118_s27_q;
      parity_3180_s28_q <= parity_3180;
      xor_3208_s28_q <= parity_3195 ^ parity_3207;
      parity_3220_s28_q <= ^{or_3217, or_3213, and_3209};
      and_3221_s28_q <= or_3213 & or_3217;
      and_3223_s28_q <= and_3209 & (or_3213 | or_3217);
      equal_3225_s28_q <= equal_3225_s27_q;
      or_3368_s28_q <= or_3368;
      difference_3415_s28_q <= difference_3415[5:0];
      not_3417_s28_q <= ~less_3416;
      not_3427_s28_q <= ~($signed(difference_3415) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3465_s28_q <= equal_3465_s27_q;
      less_3539_s28_q <= $signed(15'h10) < $signed(difference_3415);
      less_3540_s28_q <= $signed(difference_3415[14:4]) < $signed(11'h7ff);
      equal_3568_s28_q <= equal_3568_s27_q;
      or_3644_s28_q <= or_3644_s27_q;
      and_3811_s28_q <= and_3811_s27_q;
      not_3842_s28_q <= not_3842_s27_q;
      or_3852_s28_q <= select_3652_s27_q | select_3709;
      or_3861_s28_q <= or_3861;
      not_3873_s28_q <= ~(select_3676 < cfg_hidden_frames_i);
      select_3895_s28_q <= select_3895_s27_q;
      select_3897_s28_q <= select_3897_s27_q;
    end
  end

  // Stage 28 ----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
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
  // hls/stages/patches.hpp:167
  logic less_1866;
  assign less_1866 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:168
  logic not_1867;
  assign not_1867 = ~less_1866;
  logic [1:0] select_1868;
  assign select_1868 = patches_summed_first_s28_q ? 2'h2 : {less_1866, not_1867};
  logic [12:0] select_1869;
  assign select_1869 = select_1868[0] ? {4'h0, patches_summed_first_s28_q, 3'h0, patches_summed_row_column_s28_q} : {patches_summed_row_column_s28_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1870;
  assign select_1870 = select_1868[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1871;
  assign select_1871 = select_1868[1] ? {select_1869[12:8], patches_sums_values_0_q[9:8], select_1869[7:0]} : select_1870;
  // hls/stages/census.hpp:385
  logic select_2264;
  assign select_2264 = or_2262_s28_q ? and_2263_s28_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2265;
  assign select_2265 = equal_2216_s28_q ? select_2264 : sharpness_comparing_less_detail_0_q;
  logic select_2266;
  assign select_2266 = so_s28_q ? select_2265 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_2270;
  assign select_2270 = or_2268_s28_q ? and_2269_s28_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2271;
  assign select_2271 = equal_2216_s28_q ? select_2270 : sharpness_comparing_less_detail_1_q;
  logic select_2272;
  assign select_2272 = so_s28_q ? select_2271 : sharpness_comparing_less_detail_1_q;
  // hls/stages/count_bits.hpp:27
  logic or_3224;
  assign or_3224 = and_3221_s28_q | and_3223_s28_q;
  // hls/stages/patches.hpp:502
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3224, parity_3220_s28_q, xor_3208_s28_q, parity_3180_s28_q, parity_3118_s28_q, parity_2989_s28_q} + (equal_3225_s28_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:167
  logic [9:0] select_3229;
  assign select_3229 = equal_1693_s28_q ? patches_sums_values_0_q : (equal_1695_s28_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3230;
  assign select_3230 = equal_1695_s28_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3232;
  assign select_3232 = equal_1695_s28_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3234;
  assign select_3234 = equal_1695_s28_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3236;
  assign select_3236 = equal_1695_s28_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3238;
  assign select_3238 = equal_1695_s28_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3240;
  assign select_3240 = equal_1695_s28_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3242;
  assign select_3242 = equal_1695_s28_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3244;
  assign select_3244 = equal_1695_s28_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3246;
  assign select_3246 = equal_1695_s28_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3248;
  assign select_3248 = equal_1695_s28_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3250;
  assign select_3250 = equal_1695_s28_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3252;
  assign select_3252 = equal_1695_s28_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3254;
  assign select_3254 = equal_1695_s28_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3256;
  assign select_3256 = equal_1695_s28_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3258;
  assign select_3258 = equal_1695_s28_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3260;
  assign select_3260 = equal_1695_s28_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:556
  logic not_3369;
  assign not_3369 = ~or_3368_s28_q;
  // hls/stages/patches.hpp:537
  logic and_3370;
  assign and_3370 = equal_1857_s28_q & not_3369;
  // hls/stages/patches.hpp:167
  logic and_3373;
  assign and_3373 = equal_1693_s28_q & (less_1854_s28_q ? (not_1856_s28_q & and_3370) : and_3370);
  // hls/stages/patches.hpp:537
  logic and_3376;
  assign and_3376 = equal_1857_s28_q & (patches_second_s28_q & not_3369);
  // hls/stages/patches.hpp:167
  logic and_3379;
  assign and_3379 = equal_1693_s28_q & (less_1854_s28_q ? (not_1856_s28_q & and_3376) : and_3376);
  // hls/stages/patches.hpp:537
  logic and_3419;
  assign and_3419 = equal_1857_s28_q & (not_3369 & not_3417_s28_q);
  // hls/stages/patches.hpp:167
  logic and_3422;
  assign and_3422 = equal_1693_s28_q & (less_1854_s28_q ? (not_1856_s28_q & and_3419) : and_3419);
  // hls/stages/patches.hpp:537
  logic and_3429;
  assign and_3429 = equal_1857_s28_q & (not_3369 & not_3427_s28_q);
  // hls/stages/patches.hpp:167
  logic and_3432;
  assign and_3432 = equal_1693_s28_q & (less_1854_s28_q ? (not_1856_s28_q & and_3429) : and_3429);
  // hls/stages/agreement.hpp:1072
  logic less_3466;
  assign less_3466 = x_s28_q[5:3] < 3'h3;
  // hls/stages/patches.hpp:321
  logic and_3470;
  assign and_3470 = equal_1472_s28_q & (x_s28_q[6] & (not_1883_s28_q & (equal_3465_s28_q & less_3466)));
  // hls/stages/agreement.hpp:1084
  logic and_3475;
  assign and_3475 = x_s28_q[6] & (not_1883_s28_q & (less_3466 & (x_s28_q[2:0] == 3'h1)));
  logic and_3482;
  assign and_3482 = x_s28_q[6] & (not_1883_s28_q & (less_3466 & (x_s28_q[2:0] == 3'h2)));
  logic and_3489;
  assign and_3489 = x_s28_q[6] & (not_1883_s28_q & (less_3466 & (x_s28_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:182
  logic select_3496;
  assign select_3496 = (x_s28_q[5:3] == 3'h2) ? x_s28_q[1] : (x_s28_q[0] & (x_s28_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:185
  logic [4:0] sum_3523;
  assign sum_3523 = {2'h0, x_s28_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3542;
  assign select_3542 = less_3539_s28_q ? 6'h10 : (less_3540_s28_q ? 6'h30 : difference_3415_s28_q);
  // hls/stages/patches.hpp:537
  logic [5:0] select_3544;
  assign select_3544 = equal_1857_s28_q ? (or_3368_s28_q ? 6'h0 : select_3542) : 6'h0;
  logic [5:0] select_3546;
  assign select_3546 = less_1854_s28_q ? (equal_1855_s28_q ? 6'h0 : select_3544) : select_3544;
  // hls/stages/patches.hpp:321
  logic and_3553;
  assign and_3553 = equal_1472_s28_q & (x_s28_q[6] & (not_1883_s28_q & (equal_2671_s28_q & less_3466)));
  // hls/stages/agreement.hpp:1084
  logic and_3557;
  assign and_3557 = x_s28_q[6] & (not_1883_s28_q & (less_3466 & (x_s28_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:321
  logic and_3849;
  assign and_3849 = equal_1472_s28_q & (equal_3568_s28_q & (cfg_prove_i & or_3644_s28_q));
  // hls/stages/agreement.hpp:1171
  logic not_3851;
  assign not_3851 = ~(or_3644_s28_q | not_3835);
  // hls/stages/patches.hpp:321
  logic and_3855;
  assign and_3855 = equal_1472_s28_q & (equal_3568_s28_q & (not_3851 & or_3852_s28_q));
  logic and_3868;
  assign and_3868 = equal_3568_s28_q & (not_3851 & (select_2272 | select_2284_s28_q));
  // hls/stages/agreement.hpp:1088
  logic and_3875;
  assign and_3875 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_3873_s28_q);
  // hls/stages/patches.hpp:321
  logic and_3881;
  assign and_3881 = equal_1472_s28_q & (x_s28_q[6] & (not_1883_s28_q | (4'hc < x_s28_q[5:2])));

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1723_s28_q, select_1720_s28_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s28_en & and_1733_s28_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s28_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_0_raddr_s16_sim;
  logic patches_right_0_re_s16_sim;
  logic [9:0] patches_right_0_raddr_s17_sim;
  logic patches_right_0_re_s17_sim;
  logic [9:0] patches_right_0_raddr_s18_sim;
  logic patches_right_0_re_s18_sim;
  logic [9:0] patches_right_0_raddr_s19_sim;
  logic patches_right_0_re_s19_sim;
  logic [9:0] patches_right_0_raddr_s20_sim;
  logic patches_right_0_re_s20_sim;
  logic [9:0] patches_right_0_raddr_s21_sim;
  logic patches_right_0_re_s21_sim;
  logic [9:0] patches_right_0_raddr_s22_sim;
  logic patches_right_0_re_s22_sim;
  logic [9:0] patches_right_0_raddr_s23_sim;
  logic patches_right_0_re_s23_sim;
  logic [9:0] patches_right_0_raddr_s24_sim;
  logic patches_right_0_re_s24_sim;
  logic [9:0] patches_right_0_raddr_s25_sim;
  logic patches_right_0_re_s25_sim;
  logic [9:0] patches_right_0_raddr_s26_sim;
  logic patches_right_0_re_s26_sim;
  logic [9:0] patches_right_0_raddr_s27_sim;
  logic patches_right_0_re_s27_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_0_re_s16_sim <= 1'b0;
      patches_right_0_re_s17_sim <= 1'b0;
      patches_right_0_re_s18_sim <= 1'b0;
      patches_right_0_re_s19_sim <= 1'b0;
      patches_right_0_re_s20_sim <= 1'b0;
      patches_right_0_re_s21_sim <= 1'b0;
      patches_right_0_re_s22_sim <= 1'b0;
      patches_right_0_re_s23_sim <= 1'b0;
      patches_right_0_re_s24_sim <= 1'b0;
      patches_right_0_re_s25_sim <= 1'b0;
      patches_right_0_re_s26_sim <= 1'b0;
      patches_right_0_re_s27_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_0_re_s16_sim <= patches_right_0_re;
      patches_right_0_raddr_s16_sim <= patches_right_0_raddr;
      patches_right_0_re_s17_sim <= patches_right_0_re_s16_sim;
      patches_right_0_raddr_s17_sim <= patches_right_0_raddr_s16_sim;
      patches_right_0_re_s18_sim <= patches_right_0_re_s17_sim;
      patches_right_0_raddr_s18_sim <= patches_right_0_raddr_s17_sim;
      patches_right_0_re_s19_sim <= patches_right_0_re_s18_sim;
      patches_right_0_raddr_s19_sim <= patches_right_0_raddr_s18_sim;
      patches_right_0_re_s20_sim <= patches_right_0_re_s19_sim;
      patches_right_0_raddr_s20_sim <= patches_right_0_raddr_s19_sim;
      patches_right_0_re_s21_sim <= patches_right_0_re_s20_sim;
      patches_right_0_raddr_s21_sim <= patches_right_0_raddr_s20_sim;
      patches_right_0_re_s22_sim <= patches_right_0_re_s21_sim;
      patches_right_0_raddr_s22_sim <= patches_right_0_raddr_s21_sim;
      patches_right_0_re_s23_sim <= patches_right_0_re_s22_sim;
      patches_right_0_raddr_s23_sim <= patches_right_0_raddr_s22_sim;
      patches_right_0_re_s24_sim <= patches_right_0_re_s23_sim;
      patches_right_0_raddr_s24_sim <= patches_right_0_raddr_s23_sim;
      patches_right_0_re_s25_sim <= patches_right_0_re_s24_sim;
      patches_right_0_raddr_s25_sim <= patches_right_0_raddr_s24_sim;
      patches_right_0_re_s26_sim <= patches_right_0_re_s25_sim;
      patches_right_0_raddr_s26_sim <= patches_right_0_raddr_s25_sim;
      patches_right_0_re_s27_sim <= patches_right_0_re_s26_sim;
      patches_right_0_raddr_s27_sim <= patches_right_0_raddr_s26_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_0_we) begin
      if (patches_right_0_re && patches_right_0_raddr == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s16_sim && patches_right_0_raddr_s16_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s17_sim && patches_right_0_raddr_s17_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s18_sim && patches_right_0_raddr_s18_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s19_sim && patches_right_0_raddr_s19_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s20_sim && patches_right_0_raddr_s20_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s21_sim && patches_right_0_raddr_s21_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s22_sim && patches_right_0_raddr_s22_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s23_sim && patches_right_0_raddr_s23_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s24_sim && patches_right_0_raddr_s24_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s25_sim && patches_right_0_raddr_s25_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s26_sim && patches_right_0_raddr_s26_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s27_sim && patches_right_0_raddr_s27_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_1723_s28_q, select_1749_s28_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s28_en & and_1753_s28_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s28_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_1_raddr_s16_sim;
  logic patches_right_1_re_s16_sim;
  logic [9:0] patches_right_1_raddr_s17_sim;
  logic patches_right_1_re_s17_sim;
  logic [9:0] patches_right_1_raddr_s18_sim;
  logic patches_right_1_re_s18_sim;
  logic [9:0] patches_right_1_raddr_s19_sim;
  logic patches_right_1_re_s19_sim;
  logic [9:0] patches_right_1_raddr_s20_sim;
  logic patches_right_1_re_s20_sim;
  logic [9:0] patches_right_1_raddr_s21_sim;
  logic patches_right_1_re_s21_sim;
  logic [9:0] patches_right_1_raddr_s22_sim;
  logic patches_right_1_re_s22_sim;
  logic [9:0] patches_right_1_raddr_s23_sim;
  logic patches_right_1_re_s23_sim;
  logic [9:0] patches_right_1_raddr_s24_sim;
  logic patches_right_1_re_s24_sim;
  logic [9:0] patches_right_1_raddr_s25_sim;
  logic patches_right_1_re_s25_sim;
  logic [9:0] patches_right_1_raddr_s26_sim;
  logic patches_right_1_re_s26_sim;
  logic [9:0] patches_right_1_raddr_s27_sim;
  logic patches_right_1_re_s27_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_1_re_s16_sim <= 1'b0;
      patches_right_1_re_s17_sim <= 1'b0;
      patches_right_1_re_s18_sim <= 1'b0;
      patches_right_1_re_s19_sim <= 1'b0;
      patches_right_1_re_s20_sim <= 1'b0;
      patches_right_1_re_s21_sim <= 1'b0;
      patches_right_1_re_s22_sim <= 1'b0;
      patches_right_1_re_s23_sim <= 1'b0;
      patches_right_1_re_s24_sim <= 1'b0;
      patches_right_1_re_s25_sim <= 1'b0;
      patches_right_1_re_s26_sim <= 1'b0;
      patches_right_1_re_s27_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_1_re_s16_sim <= patches_right_1_re;
      patches_right_1_raddr_s16_sim <= patches_right_1_raddr;
      patches_right_1_re_s17_sim <= patches_right_1_re_s16_sim;
      patches_right_1_raddr_s17_sim <= patches_right_1_raddr_s16_sim;
      patches_right_1_re_s18_sim <= patches_right_1_re_s17_sim;
      patches_right_1_raddr_s18_sim <= patches_right_1_raddr_s17_sim;
      patches_right_1_re_s19_sim <= patches_right_1_re_s18_sim;
      patches_right_1_raddr_s19_sim <= patches_right_1_raddr_s18_sim;
      patches_right_1_re_s20_sim <= patches_right_1_re_s19_sim;
      patches_right_1_raddr_s20_sim <= patches_right_1_raddr_s19_sim;
      patches_right_1_re_s21_sim <= patches_right_1_re_s20_sim;
      patches_right_1_raddr_s21_sim <= patches_right_1_raddr_s20_sim;
      patches_right_1_re_s22_sim <= patches_right_1_re_s21_sim;
      patches_right_1_raddr_s22_sim <= patches_right_1_raddr_s21_sim;
      patches_right_1_re_s23_sim <= patches_right_1_re_s22_sim;
      patches_right_1_raddr_s23_sim <= patches_right_1_raddr_s22_sim;
      patches_right_1_re_s24_sim <= patches_right_1_re_s23_sim;
      patches_right_1_raddr_s24_sim <= patches_right_1_raddr_s23_sim;
      patches_right_1_re_s25_sim <= patches_right_1_re_s24_sim;
      patches_right_1_raddr_s25_sim <= patches_right_1_raddr_s24_sim;
      patches_right_1_re_s26_sim <= patches_right_1_re_s25_sim;
      patches_right_1_raddr_s26_sim <= patches_right_1_raddr_s25_sim;
      patches_right_1_re_s27_sim <= patches_right_1_re_s26_sim;
      patches_right_1_raddr_s27_sim <= patches_right_1_raddr_s26_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_1_we) begin
      if (patches_right_1_re && patches_right_1_raddr == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s16_sim && patches_right_1_raddr_s16_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s17_sim && patches_right_1_raddr_s17_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s18_sim && patches_right_1_raddr_s18_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s19_sim && patches_right_1_raddr_s19_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s20_sim && patches_right_1_raddr_s20_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s21_sim && patches_right_1_raddr_s21_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s22_sim && patches_right_1_raddr_s22_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s23_sim && patches_right_1_raddr_s23_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s24_sim && patches_right_1_raddr_s24_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s25_sim && patches_right_1_raddr_s25_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s26_sim && patches_right_1_raddr_s26_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s27_sim && patches_right_1_raddr_s27_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
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
    end else if (s28_en) begin
      sharpness_comparing_less_detail_0_q <= select_2266;
      sharpness_comparing_less_detail_1_q <= select_2272;
      patches_sums_values_0_q <= select_3229;
      patches_sums_values_1_q <= equal_1693_s28_q ? patches_sums_values_1_q : select_3230;
      patches_sums_values_2_q <= equal_1693_s28_q ? patches_sums_values_2_q : select_3232;
      patches_sums_values_3_q <= equal_1693_s28_q ? patches_sums_values_3_q : select_3234;
      patches_sums_values_4_q <= equal_1693_s28_q ? patches_sums_values_4_q : select_3236;
      patches_sums_values_5_q <= equal_1693_s28_q ? patches_sums_values_5_q : select_3238;
      patches_sums_values_6_q <= equal_1693_s28_q ? patches_sums_values_6_q : select_3240;
      patches_sums_values_7_q <= equal_1693_s28_q ? patches_sums_values_7_q : select_3242;
      patches_sums_values_8_q <= equal_1693_s28_q ? patches_sums_values_8_q : select_3244;
      patches_sums_values_9_q <= equal_1693_s28_q ? patches_sums_values_9_q : select_3246;
      patches_sums_values_10_q <= equal_1693_s28_q ? patches_sums_values_10_q : select_3248;
      patches_sums_values_11_q <= equal_1693_s28_q ? patches_sums_values_11_q : select_3250;
      patches_sums_values_12_q <= equal_1693_s28_q ? patches_sums_values_12_q : select_3252;
      patches_sums_values_13_q <= equal_1693_s28_q ? patches_sums_values_13_q : select_3254;
      patches_sums_values_14_q <= equal_1693_s28_q ? patches_sums_values_14_q : select_3256;
      patches_sums_values_15_q <= equal_1693_s28_q ? patches_sums_values_15_q : select_3258;
      patches_sums_values_16_q <= equal_1693_s28_q ? patches_sums_values_16_q : select_3260;
      patches_best_differing_q <= select_1871[9:0];
      patches_best_column_q <= select_1871[14:10];
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s28_en) begin
      left_pixel_q <= left_pixel_q;
    end
  end

  logic [7:0] pixel_0_s29_q;
  logic [7:0] pixel_1_s29_q;
  logic saturated_s29_q;
  logic mask_s29_q;
  logic marks_first_s29_q;
  logic marks_last_s29_q;
  logic [6:0] x_s29_q;
  logic registration_moved_s29_q;
  logic patches_lower_s29_q;
  logic patches_summed_last_s29_q;
  logic [4:0] patches_summed_down_by_s29_q;
  logic equal_1472_s29_q;
  logic equal_1517_s29_q;
  logic equal_1525_s29_q;
  logic [9:0] select_2452_s29_q;
  logic [9:0] select_2455_s29_q;
  logic and_3373_s29_q;
  logic and_3379_s29_q;
  logic and_3422_s29_q;
  logic and_3432_s29_q;
  logic and_3470_s29_q;
  logic and_3476_s29_q;
  logic and_3483_s29_q;
  logic and_3490_s29_q;
  logic and_3499_s29_q;
  logic and_3526_s29_q;
  logic [5:0] select_3547_s29_q;
  logic and_3553_s29_q;
  logic and_3558_s29_q;
  logic equal_3568_s29_q;
  logic and_3811_s29_q;
  logic or_3836_s29_q;
  logic and_3837_s29_q;
  logic not_3842_s29_q;
  logic and_3849_s29_q;
  logic and_3855_s29_q;
  logic and_3864_s29_q;
  logic and_3868_s29_q;
  logic and_3877_s29_q;
  logic and_3881_s29_q;
  logic [31:0] select_3895_s29_q;
  logic [9:0] select_3897_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      x_s29_q <= x_s28_q;
      registration_moved_s29_q <= registration_moved_s28_q;
      patches_lower_s29_q <= patches_lower_s28_q;
      patches_summed_last_s29_q <= patches_summed_last_s28_q;
      patches_summed_down_by_s29_q <= patches_summed_down_by_s28_q;
      equal_1472_s29_q <= equal_1472_s28_q;
      equal_1517_s29_q <= equal_1517_s28_q;
      equal_1525_s29_q <= equal_1525_s28_q;
      select_2452_s29_q <= select_2452_s28_q;
      select_2455_s29_q <= select_2455_s28_q;
      and_3373_s29_q <= and_3373;
      and_3379_s29_q <= and_3379;
      and_3422_s29_q <= and_3422;
      and_3432_s29_q <= and_3432;
      and_3470_s29_q <= and_3470;
      and_3476_s29_q <= equal_1472_s28_q & and_3475;
      and_3483_s29_q <= equal_1472_s28_q & and_3482;
      and_3490_s29_q <= equal_1472_s28_q & and_3489;
      and_3499_s29_q <= x_s28_q[6] & (not_1883_s28_q & (less_3466 & select_3496));
      and_3526_s29_q <= not_1883_s28_q & (less_3466 & (sum_3523[4:2] == 3'h0));
      select_3547_s29_q <= equal_1693_s28_q ? select_3546 : 6'h0;
      and_3553_s29_q <= and_3553;
      and_3558_s29_q <= equal_1472_s28_q & and_3557;
      equal_3568_s29_q <= equal_3568_s28_q;
      and_3811_s29_q <= and_3811_s28_q;
      or_3836_s29_q <= not_3835 | seen_q;
      and_3837_s29_q <= cfg_prove_i & nearer_q;
      not_3842_s29_q <= not_3842_s28_q;
      and_3849_s29_q <= and_3849;
      and_3855_s29_q <= and_3855;
      and_3864_s29_q <= equal_3568_s28_q & (not_3851 & (select_2266 | or_3861_s28_q));
      and_3868_s29_q <= and_3868;
      and_3877_s29_q <= equal_1472_s28_q & (equal_3568_s28_q & and_3875);
      and_3881_s29_q <= and_3881;
      select_3895_s29_q <= select_3895_s28_q;
      select_3897_s29_q <= select_3897_s28_q;
    end
  end

  // Stage 29 ----------------------------------------------------------------------------------------------------------
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
  logic patches_complete_q;
  logic patches_round_ends_q;
  logic [2:0] patches_found_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [2:0] patches_round_moved_q;
  logic patches_suspected_q;
  logic patches_moved_q;
  logic patches_settled_q;
  // hls/stages/patches.hpp:619
  logic not_3374;
  assign not_3374 = ~patches_lower_s29_q;
  logic not_3380;
  assign not_3380 = ~and_3379_s29_q;
  // hls/stages/patches.hpp:171
  logic and_3382;
  assign and_3382 = and_3373_s29_q & (not_3374 & not_3380);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3384;
  assign sum_3384 = {7'h0, and_3382} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:622
  logic and_3423;
  assign and_3423 = and_3422_s29_q & and_3382;
  logic [7:0] sum_3424;
  assign sum_3424 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3423};
  // hls/stages/patches.hpp:623
  logic and_3433;
  assign and_3433 = and_3432_s29_q & and_3382;
  logic [7:0] sum_3434;
  assign sum_3434 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3433};
  // hls/stages/patches.hpp:171
  logic and_3436;
  assign and_3436 = and_3373_s29_q & (and_3379_s29_q & not_3374);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3438;
  assign sum_3438 = {7'h0, and_3436} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:622
  logic and_3440;
  assign and_3440 = and_3422_s29_q & and_3436;
  logic [7:0] sum_3441;
  assign sum_3441 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3440};
  // hls/stages/patches.hpp:623
  logic and_3443;
  assign and_3443 = and_3432_s29_q & and_3436;
  logic [7:0] sum_3444;
  assign sum_3444 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3443};
  // hls/stages/patches.hpp:171
  logic and_3446;
  assign and_3446 = and_3373_s29_q & (patches_lower_s29_q & not_3380);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3448;
  assign sum_3448 = {7'h0, and_3446} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:622
  logic and_3450;
  assign and_3450 = and_3422_s29_q & and_3446;
  logic [7:0] sum_3451;
  assign sum_3451 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3450};
  // hls/stages/patches.hpp:623
  logic and_3453;
  assign and_3453 = and_3432_s29_q & and_3446;
  logic [7:0] sum_3454;
  assign sum_3454 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3453};
  // hls/stages/patches.hpp:171
  logic and_3456;
  assign and_3456 = and_3373_s29_q & (patches_lower_s29_q & and_3379_s29_q);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3458;
  assign sum_3458 = {7'h0, and_3456} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:622
  logic and_3460;
  assign and_3460 = and_3422_s29_q & and_3456;
  logic [7:0] sum_3461;
  assign sum_3461 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3460};
  // hls/stages/patches.hpp:623
  logic and_3463;
  assign and_3463 = and_3432_s29_q & and_3456;
  logic [7:0] sum_3464;
  assign sum_3464 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3463};
  // hls/stages/patches.hpp:598
  logic [7:0] or_3478;
  assign or_3478 = (and_3470_s29_q ? patches_quarters_0_places_q : 8'h0) | (and_3476_s29_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3492;
  assign or_3492 = (or_3478 | (and_3483_s29_q ? patches_quarters_2_places_q : 8'h0)) | (and_3490_s29_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:321
  logic and_3500;
  assign and_3500 = equal_1472_s29_q & and_3499_s29_q;
  // hls/stages/patches.hpp:599
  logic [7:0] select_3502;
  assign select_3502 = and_3470_s29_q ? (and_3500 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3504;
  assign select_3504 = and_3476_s29_q ? (and_3500 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3507;
  assign select_3507 = and_3483_s29_q ? (and_3500 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3510;
  assign select_3510 = and_3490_s29_q ? (and_3500 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:600
  logic [7:0] select_3513;
  assign select_3513 = and_3470_s29_q ? (and_3500 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3515;
  assign select_3515 = and_3476_s29_q ? (and_3500 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3518;
  assign select_3518 = and_3483_s29_q ? (and_3500 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3521;
  assign select_3521 = and_3490_s29_q ? (and_3500 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:321
  logic and_3528;
  assign and_3528 = equal_1472_s29_q & (x_s29_q[6] & and_3526_s29_q);
  // hls/stages/patches.hpp:593
  logic [7:0] sum_3530;
  assign sum_3530 = patches_word_places_q + (and_3476_s29_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:595
  logic [7:0] select_3534;
  assign select_3534 = and_3528 ? (patches_word_up_q + (and_3476_s29_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3536;
  assign sum_3536 = patches_word_down_q + (and_3476_s29_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:625
  logic [5:0] select_3548;
  assign select_3548 = and_3373_s29_q ? select_3547_s29_q : 6'h0;
  logic [11:0] sum_3549;
  assign sum_3549 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3548[5]}}, select_3548};
  // hls/stages/patches.hpp:614
  logic [7:0] select_3560;
  assign select_3560 = and_3553_s29_q ? (and_3558_s29_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:616
  logic or_3564;
  assign or_3564 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:613
  logic select_3566;
  assign select_3566 = and_3553_s29_q ? (and_3558_s29_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:171
  logic and_3572;
  assign and_3572 = patches_complete_q & (equal_1472_s29_q & ((x_s29_q == 7'h70) & (~equal_3568_s29_q)));
  logic and_3573;
  assign and_3573 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:613
  logic [2:0] select_3574;
  assign select_3574 = and_3553_s29_q ? {and_3573, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3576;
  assign select_3576 = and_3553_s29_q ? (and_3558_s29_q ? {and_3573, patches_found_q[2:1]} : select_3574) : patches_found_q;
  // hls/stages/patches.hpp:607
  logic equal_3580;
  assign equal_3580 = patches_found_q == 3'h0;
  logic now_2;
  assign now_2 = ~equal_3580;
  // hls/stages/patches.hpp:612
  logic select_3584;
  assign select_3584 = patches_round_ends_q ? (patches_suspected_q & now_2) : patches_moved_q;
  logic select_3587;
  assign select_3587 = patches_round_ends_q ? (patches_suspected_q | (patches_settled_q | equal_3580)) : patches_settled_q;
  // hls/stages/agreement.hpp:1169
  logic or_3843;
  assign or_3843 = ((~(cfg_patch_limit_i == 6'h3f)) & (~patches_settled_q)) | not_3842_s29_q;
  // hls/stages/patches.hpp:321
  logic and_3858;
  assign and_3858 = equal_3568_s29_q & (cfg_prove_i & (registration_moved_s29_q | patches_moved_q));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3896;
  assign select_3896 = equal_1525_s29_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3895_s29_q;
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_3898;
  assign select_3898 = equal_1517_s29_q ? select_3896 : {2'h0, select_3897_s29_q, select_2455_s29_q, select_2452_s29_q};

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s29_q;
  logic patches_rows_we;
  assign patches_rows_we = s29_en & patches_summed_last_s29_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= {patches_best_column_q, patches_best_differing_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_rows_raddr_s16_sim;
  logic patches_rows_re_s16_sim;
  logic [4:0] patches_rows_raddr_s17_sim;
  logic patches_rows_re_s17_sim;
  logic [4:0] patches_rows_raddr_s18_sim;
  logic patches_rows_re_s18_sim;
  logic [4:0] patches_rows_raddr_s19_sim;
  logic patches_rows_re_s19_sim;
  logic [4:0] patches_rows_raddr_s20_sim;
  logic patches_rows_re_s20_sim;
  logic [4:0] patches_rows_raddr_s21_sim;
  logic patches_rows_re_s21_sim;
  logic [4:0] patches_rows_raddr_s22_sim;
  logic patches_rows_re_s22_sim;
  logic [4:0] patches_rows_raddr_s23_sim;
  logic patches_rows_re_s23_sim;
  logic [4:0] patches_rows_raddr_s24_sim;
  logic patches_rows_re_s24_sim;
  logic [4:0] patches_rows_raddr_s25_sim;
  logic patches_rows_re_s25_sim;
  logic [4:0] patches_rows_raddr_s26_sim;
  logic patches_rows_re_s26_sim;
  logic [4:0] patches_rows_raddr_s27_sim;
  logic patches_rows_re_s27_sim;
  logic [4:0] patches_rows_raddr_s28_sim;
  logic patches_rows_re_s28_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_rows_re_s16_sim <= 1'b0;
      patches_rows_re_s17_sim <= 1'b0;
      patches_rows_re_s18_sim <= 1'b0;
      patches_rows_re_s19_sim <= 1'b0;
      patches_rows_re_s20_sim <= 1'b0;
      patches_rows_re_s21_sim <= 1'b0;
      patches_rows_re_s22_sim <= 1'b0;
      patches_rows_re_s23_sim <= 1'b0;
      patches_rows_re_s24_sim <= 1'b0;
      patches_rows_re_s25_sim <= 1'b0;
      patches_rows_re_s26_sim <= 1'b0;
      patches_rows_re_s27_sim <= 1'b0;
      patches_rows_re_s28_sim <= 1'b0;
    end else if (en_i) begin
      patches_rows_re_s16_sim <= patches_rows_re;
      patches_rows_raddr_s16_sim <= patches_rows_raddr;
      patches_rows_re_s17_sim <= patches_rows_re_s16_sim;
      patches_rows_raddr_s17_sim <= patches_rows_raddr_s16_sim;
      patches_rows_re_s18_sim <= patches_rows_re_s17_sim;
      patches_rows_raddr_s18_sim <= patches_rows_raddr_s17_sim;
      patches_rows_re_s19_sim <= patches_rows_re_s18_sim;
      patches_rows_raddr_s19_sim <= patches_rows_raddr_s18_sim;
      patches_rows_re_s20_sim <= patches_rows_re_s19_sim;
      patches_rows_raddr_s20_sim <= patches_rows_raddr_s19_sim;
      patches_rows_re_s21_sim <= patches_rows_re_s20_sim;
      patches_rows_raddr_s21_sim <= patches_rows_raddr_s20_sim;
      patches_rows_re_s22_sim <= patches_rows_re_s21_sim;
      patches_rows_raddr_s22_sim <= patches_rows_raddr_s21_sim;
      patches_rows_re_s23_sim <= patches_rows_re_s22_sim;
      patches_rows_raddr_s23_sim <= patches_rows_raddr_s22_sim;
      patches_rows_re_s24_sim <= patches_rows_re_s23_sim;
      patches_rows_raddr_s24_sim <= patches_rows_raddr_s23_sim;
      patches_rows_re_s25_sim <= patches_rows_re_s24_sim;
      patches_rows_raddr_s25_sim <= patches_rows_raddr_s24_sim;
      patches_rows_re_s26_sim <= patches_rows_re_s25_sim;
      patches_rows_raddr_s26_sim <= patches_rows_raddr_s25_sim;
      patches_rows_re_s27_sim <= patches_rows_re_s26_sim;
      patches_rows_raddr_s27_sim <= patches_rows_raddr_s26_sim;
      patches_rows_re_s28_sim <= patches_rows_re_s27_sim;
      patches_rows_raddr_s28_sim <= patches_rows_raddr_s27_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s16_sim && patches_rows_raddr_s16_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s17_sim && patches_rows_raddr_s17_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s18_sim && patches_rows_raddr_s18_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s19_sim && patches_rows_raddr_s19_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s20_sim && patches_rows_raddr_s20_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s21_sim && patches_rows_raddr_s21_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s22_sim && patches_rows_raddr_s22_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s23_sim && patches_rows_raddr_s23_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s24_sim && patches_rows_raddr_s24_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s25_sim && patches_rows_raddr_s25_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s26_sim && patches_rows_raddr_s26_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s27_sim && patches_rows_raddr_s27_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s28_sim && patches_rows_raddr_s28_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      patches_complete_q <= 1'b0;
      patches_round_ends_q <= 1'b0;
      patches_found_q <= 3'h0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 3'h0;
      patches_suspected_q <= 1'b0;
      patches_moved_q <= 1'b0;
      patches_settled_q <= 1'b0;
    end else if (s29_en) begin
      patches_quarters_0_places_q <= sum_3384;
      patches_quarters_0_up_q <= sum_3424;
      patches_quarters_0_down_q <= sum_3434;
      patches_quarters_1_places_q <= sum_3438;
      patches_quarters_1_up_q <= sum_3441;
      patches_quarters_1_down_q <= sum_3444;
      patches_quarters_2_places_q <= sum_3448;
      patches_quarters_2_up_q <= sum_3451;
      patches_quarters_2_down_q <= sum_3454;
      patches_quarters_3_places_q <= sum_3458;
      patches_quarters_3_up_q <= sum_3461;
      patches_quarters_3_down_q <= sum_3464;
      patches_word_places_q <= or_3492;
      patches_word_up_q <= ((select_3502 | select_3504) | select_3507) | select_3510;
      patches_word_down_q <= ((select_3513 | select_3515) | select_3518) | select_3521;
      patches_sum_places_q <= and_3528 ? sum_3530 : patches_sum_places_q;
      patches_sum_up_q <= select_3534;
      patches_sum_down_q <= and_3528 ? sum_3536 : patches_sum_down_q;
      patches_across_q <= sum_3549;
      patches_places_q <= select_3560;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3564;
      patches_complete_q <= select_3566;
      patches_round_ends_q <= and_3572;
      patches_found_q <= select_3576;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? now_2 : patches_suspected_q;
      patches_moved_q <= select_3584;
      patches_settled_q <= select_3587;
    end
  end

  logic [7:0] pixel_0_s30_q;
  logic [7:0] pixel_1_s30_q;
  logic saturated_s30_q;
  logic mask_s30_q;
  logic marks_first_s30_q;
  logic marks_last_s30_q;
  logic and_3811_s30_q;
  logic or_3836_s30_q;
  logic and_3837_s30_q;
  logic and_3846_s30_q;
  logic and_3849_s30_q;
  logic and_3855_s30_q;
  logic and_3859_s30_q;
  logic and_3865_s30_q;
  logic and_3869_s30_q;
  logic and_3877_s30_q;
  logic and_3881_s30_q;
  logic [5:0] select_3883_s30_q;
  logic [31:0] select_3900_s30_q;
  always_ff @(posedge clk_i) begin
    if (s29_en) begin
      pixel_0_s30_q <= pixel_0_s29_q;
      pixel_1_s30_q <= pixel_1_s29_q;
      saturated_s30_q <= saturated_s29_q;
      mask_s30_q <= mask_s29_q;
      marks_first_s30_q <= marks_first_s29_q;
      marks_last_s30_q <= marks_last_s29_q;
      and_3811_s30_q <= and_3811_s29_q;
      or_3836_s30_q <= or_3836_s29_q;
      and_3837_s30_q <= and_3837_s29_q;
      and_3846_s30_q <= equal_1472_s29_q & (equal_3568_s29_q & (cfg_prove_i & or_3843));
      and_3849_s30_q <= and_3849_s29_q;
      and_3855_s30_q <= and_3855_s29_q;
      and_3859_s30_q <= equal_1472_s29_q & and_3858;
      and_3865_s30_q <= equal_1472_s29_q & and_3864_s29_q;
      and_3869_s30_q <= equal_1472_s29_q & and_3868_s29_q;
      and_3877_s30_q <= and_3877_s29_q;
      and_3881_s30_q <= and_3881_s29_q;
      select_3883_s30_q <= equal_1472_s29_q ? (x_s29_q[6] ? x_s29_q[5:0] : 6'h0) : 6'h0;
      select_3900_s30_q <= equal_1472_s29_q ? (x_s29_q[6] ? select_3898 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s30_q;
  assign pixel_1_o = pixel_1_s30_q;
  assign saturated_o = saturated_s30_q;
  assign mask_o = mask_s30_q;
  assign marks_first_o = marks_first_s30_q;
  assign marks_last_o = marks_last_s30_q;
  assign marks_seen_o = or_3836_s30_q;
  assign marks_nearer_o = and_3837_s30_q;
  assign verdict_valid_o = and_3811_s30_q;
  assign verdict_unproven_yet_o = and_3846_s30_q;
  assign verdict_untextured_o = and_3849_s30_q;
  assign verdict_disagree_o = and_3855_s30_q;
  assign verdict_moved_o = and_3859_s30_q;
  assign verdict_unsharp_left_o = and_3865_s30_q;
  assign verdict_unsharp_right_o = and_3869_s30_q;
  assign verdict_hidden_o = and_3877_s30_q;
  assign frame_valid_o = and_3881_s30_q;
  assign frame_index_o = select_3883_s30_q;
  assign frame_word_o = select_3900_s30_q;
  assign valid_o = valid_s30_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
      valid_s6_q <= 1'b0;
      valid_s7_q <= 1'b0;
      valid_s8_q <= 1'b0;
      valid_s9_q <= 1'b0;
      valid_s10_q <= 1'b0;
      valid_s11_q <= 1'b0;
      valid_s12_q <= 1'b0;
      valid_s13_q <= 1'b0;
      valid_s14_q <= 1'b0;
      valid_s15_q <= 1'b0;
      valid_s16_q <= 1'b0;
      valid_s17_q <= 1'b0;
      valid_s18_q <= 1'b0;
      valid_s19_q <= 1'b0;
      valid_s20_q <= 1'b0;
      valid_s21_q <= 1'b0;
      valid_s22_q <= 1'b0;
      valid_s23_q <= 1'b0;
      valid_s24_q <= 1'b0;
      valid_s25_q <= 1'b0;
      valid_s26_q <= 1'b0;
      valid_s27_q <= 1'b0;
      valid_s28_q <= 1'b0;
      valid_s29_q <= 1'b0;
      valid_s30_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
      valid_s6_q <= valid_s5_q;
      valid_s7_q <= valid_s6_q;
      valid_s8_q <= valid_s7_q;
      valid_s9_q <= valid_s8_q;
      valid_s10_q <= valid_s9_q;
      valid_s11_q <= valid_s10_q;
      valid_s12_q <= valid_s11_q;
      valid_s13_q <= valid_s12_q;
      valid_s14_q <= valid_s13_q;
      valid_s15_q <= valid_s14_q;
      valid_s16_q <= valid_s15_q;
      valid_s17_q <= valid_s16_q;
      valid_s18_q <= valid_s17_q;
      valid_s19_q <= valid_s18_q;
      valid_s20_q <= valid_s19_q;
      valid_s21_q <= valid_s20_q;
      valid_s22_q <= valid_s21_q;
      valid_s23_q <= valid_s22_q;
      valid_s24_q <= valid_s23_q;
      valid_s25_q <= valid_s24_q;
      valid_s26_q <= valid_s25_q;
      valid_s27_q <= valid_s26_q;
      valid_s28_q <= valid_s27_q;
      valid_s29_q <= valid_s28_q;
      valid_s30_q <= valid_s29_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], sum_3523[1:0], product_3414[4:0], sum_2508[0], detail_4[1:0], detail_3[1:0], sum_2166[4:0], sum_1674[1:0], sum_1673[1:0], sum_1669[0], sum_1620[0], sum_1616[0], sum_616[4:0], cfg_width_i[3:0]};

endmodule
