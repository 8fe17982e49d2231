// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 30 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2904 bits, pipeline 8748 bits, memories 120207 bits.
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
  logic [6:0] sum_2357;
  assign sum_2357 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3354;
  assign difference_3354 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [7:0] difference_3574;
  assign difference_3574 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_3776;
  assign less_3776 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_3777;
  assign sum_3777 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_3795;
  assign not_3795 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_461;
  assign select_461 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_461 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_461_s1_q;
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
      select_461_s1_q <= select_461;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:35
  logic [6:0] select_464;
  assign select_464 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:50
  logic equal_496;
  assign equal_496 = select_461_s1_q == 4'hf;
  // hls/stages/agreement.hpp:263
  logic [6:0] select_2006;
  assign select_2006 = sample_pair_whole_s1_q ? (select_464 + {6'h0, equal_496}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2006;
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
  logic [3:0] select_461_s2_q;
  logic [6:0] select_464_s2_q;
  logic equal_496_s2_q;
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
      select_461_s2_q <= select_461_s1_q;
      select_464_s2_q <= select_464;
      equal_496_s2_q <= equal_496;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:109
  logic equal_462;
  assign equal_462 = select_461_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:115
  logic [8:0] select_467;
  assign select_467 = ({select_464_s2_q, select_461_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_468;
  assign select_468 = equal_462 ? select_467 : averager_place_q;
  // hls/stages/census.hpp:41
  logic [3:0] select_479;
  assign select_479 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2004;
  assign select_2004 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_479 + 4'h1) : select_479) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2004;
      averager_place_q <= sample_pair_whole_s2_q ? select_468 : averager_place_q;
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
  logic [3:0] select_461_s3_q;
  logic equal_462_s3_q;
  logic [6:0] select_464_s3_q;
  logic [8:0] select_468_s3_q;
  logic equal_470_s3_q;
  logic [3:0] select_479_s3_q;
  logic equal_496_s3_q;
  logic equal_497_s3_q;
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
      select_461_s3_q <= select_461_s2_q;
      equal_462_s3_q <= equal_462;
      select_464_s3_q <= select_464_s2_q;
      select_468_s3_q <= select_468;
      equal_470_s3_q <= select_461_s2_q[1:0] == 2'h3;
      select_479_s3_q <= select_479;
      equal_496_s3_q <= equal_496_s2_q;
      equal_497_s3_q <= select_479 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:41
  logic or_469;
  assign or_469 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_474;
  assign and_474 = (or_469 & equal_470_s3_q) & (~(select_468_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_464_s3_q : 7'h0;
  // hls/stages/census.hpp:126
  logic and_498;
  assign and_498 = equal_497_s3_q & and_474;
  // hls/stages/agreement.hpp:263
  logic and_500;
  assign and_500 = sample_pair_whole_s3_q & (equal_496_s3_q & and_498);
  // hls/stages/census.hpp:41
  logic [6:0] select_559;
  assign select_559 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_559 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_2008;
  assign select_2008 = sample_last_s3_q ? (select_559 + {6'h0, equal_497_s3_q}) : select_559;
  // hls/stages/agreement.hpp:263
  logic select_2013;
  assign select_2013 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_469 & (~raster_final_row_q)) : or_469) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_2015;
  assign select_2015 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:263
  logic select_2019;
  assign select_2019 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2263;
  assign equal_2263 = {last[7], column} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2008 : raster_at_row_q;
      raster_at_live_q <= select_2013;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2015 : raster_rows_left_q;
      raster_final_row_q <= select_2019;
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
  logic [3:0] select_461_s4_q;
  logic equal_462_s4_q;
  logic [6:0] select_464_s4_q;
  logic [8:0] select_468_s4_q;
  logic and_474_s4_q;
  logic [3:0] select_479_s4_q;
  logic [6:0] column_s4_q;
  logic and_498_s4_q;
  logic and_500_s4_q;
  logic [3:0] select_559_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1588_s4_q;
  logic equal_2263_s4_q;
  logic and_2264_s4_q;
  logic [7:0] sum_2353_s4_q;
  logic [2:0] or_2738_s4_q;
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
      select_461_s4_q <= select_461_s3_q;
      equal_462_s4_q <= equal_462_s3_q;
      select_464_s4_q <= select_464_s3_q;
      select_468_s4_q <= select_468_s3_q;
      and_474_s4_q <= and_474;
      select_479_s4_q <= select_479_s3_q;
      column_s4_q <= column;
      and_498_s4_q <= and_498;
      and_500_s4_q <= and_500;
      select_559_s4_q <= select_559[3:0];
      row_s4_q <= row;
      equal_1588_s4_q <= {or_469, select_479_s3_q} == 5'h18;
      equal_2263_s4_q <= equal_2263;
      and_2264_s4_q <= and_500 & equal_2263;
      sum_2353_s4_q <= {1'b0, row} + 8'h1;
      or_2738_s4_q <= select_464_s3_q[2:0] | select_559[6:4];
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
  logic equal_520;
  assign equal_520 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:601
  logic equal_523;
  assign equal_523 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_525;
  assign equal_525 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:510
  logic select_2267;
  assign select_2267 = (and_2264_s4_q | (~ends_cell_q)) ? and_2264_s4_q : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2267 ? (and_2264_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2271;
  assign select_2271 = select_2267 ? (and_2264_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2274;
  assign select_2274 = select_2267 ? (following_last_shift_q & (~and_2264_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:522
  logic [7:0] select_2276;
  assign select_2276 = select_2267 ? (and_2264_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:594
  logic and_2277;
  assign and_2277 = run_last_shift_q & equal_523;
  // hls/stages/agreement.hpp:603
  logic select_2279;
  assign select_2279 = equal_523 ? (~run_last_shift_q) : equal_525;
  // hls/stages/agreement.hpp:607
  logic equal_2280;
  assign equal_2280 = run_phase_q == 3'h1;
  logic not_2283;
  assign not_2283 = ~select_2279;
  // hls/stages/agreement.hpp:610
  logic equal_2285;
  assign equal_2285 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2286;
  assign and_2286 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2287;
  assign select_2287 = equal_2285 ? 2'h1 : {2{and_2286}};
  logic [2:0] select_2289;
  assign select_2289 = (and_2277 | (select_2279 | equal_2280)) ? (equal_2280 ? 3'h2 : {not_2283, {2{select_2279}}}) : (equal_520 ? 3'h6 : {select_2287[0], select_2287});
  // hls/stages/agreement.hpp:594
  logic and_2292;
  assign and_2292 = select_2279 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2295;
  assign select_2295 = (plan_shift_q[5] & select_2279) ? value : 7'h0;
  logic [1:0] or_2296;
  assign or_2296 = {2{so}} | select_2295[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_2300;
  assign or_2300 = (select_2279 ? plan_columns_q : 8'h0) | ((equal_2280 | equal_2285) ? whole_q : 8'h0);
  logic [1:0] or_2301;
  assign or_2301 = {2{and_2277}} | or_2300[4:3];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2303;
  assign or_2303 = {or_2300[7:5], or_2301, or_2300[2:0]} | (equal_520 ? drawn_q : 8'h0);
  logic [4:0] or_2304;
  assign or_2304 = {5{so}} | {or_2303[6], or_2303[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2308;
  assign not_2308 = ~run_shift_q[5];
  logic [7:0] select_2311;
  assign select_2311 = equal_523 ? ({{7{not_2308}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2315;
  assign select_2315 = and_2264_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2317;
  assign select_2317 = select_2267 ? {select_2315[6], select_2315} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2320;
  assign select_2320 = select_2267 ? (and_2264_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:447
  logic [6:0] select_2327;
  assign select_2327 = equal_2263_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_2331;
  assign select_2331 = and_500_s4_q ? (equal_2263_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2334;
  assign select_2334 = and_500_s4_q ? (equal_2263_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2348;
  assign select_2348 = (ends_cell_q | select_2267) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_523 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2352;
  assign and_2352 = (~select_2267) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic equal_2354;
  assign equal_2354 = {sum_2353_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2353_s4_q[6:0]};
  // hls/stages/agreement.hpp:507
  logic select_2356;
  assign select_2356 = and_500_s4_q ? (equal_2263_s4_q ? equal_2354 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:345
  logic [8:0] sum_2739;
  assign sum_2739 = {1'b0, select_464_s4_q[3], or_2738_s4_q, select_559_s4_q} + 9'h1;

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
      run_shift_q <= select_2271;
      run_last_shift_q <= select_2274;
      run_span_q <= select_2276;
      following_phase_q <= select_2289;
      following_shift_q <= select_2279 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2292;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2295[6], or_2296, select_2295[3:0]};
      following_columns_q <= {or_2303[7], or_2304[4], or_2303[5:4], or_2304[3:0]};
      plan_shift_q <= equal_523 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2311;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2317;
      columns_left_q <= select_2320;
      last_q <= and_500_s4_q ? (equal_2263_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_500_s4_q ? select_2327 : least_q;
      whole_q <= select_2331;
      drawn_q <= select_2334;
      slot_q <= select_2267 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2348;
      ends_q <= and_2352;
      final_row_q <= select_2356;
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
  logic [3:0] select_461_s5_q;
  logic equal_462_s5_q;
  logic [6:0] select_464_s5_q;
  logic [8:0] select_468_s5_q;
  logic and_474_s5_q;
  logic equal_480_s5_q;
  logic [6:0] column_s5_q;
  logic and_498_s5_q;
  logic and_500_s5_q;
  logic so_s5_q;
  logic equal_520_s5_q;
  logic equal_523_s5_q;
  logic equal_525_s5_q;
  logic [7:0] sum_526_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_636_s5_q;
  logic equal_645_s5_q;
  logic equal_1469_s5_q;
  logic equal_1588_s5_q;
  logic equal_2263_s5_q;
  logic and_2264_s5_q;
  logic select_2267_s5_q;
  logic not_2741_s5_q;
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
      select_461_s5_q <= select_461_s4_q;
      equal_462_s5_q <= equal_462_s4_q;
      select_464_s5_q <= select_464_s4_q;
      select_468_s5_q <= select_468_s4_q;
      and_474_s5_q <= and_474_s4_q;
      equal_480_s5_q <= select_479_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_498_s5_q <= and_498_s4_q;
      and_500_s5_q <= and_500_s4_q;
      so_s5_q <= so;
      equal_520_s5_q <= equal_520;
      equal_523_s5_q <= equal_523;
      equal_525_s5_q <= equal_525;
      sum_526_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_636_s5_q <= {1'b0, last_q} + 8'h3;
      equal_645_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_1469_s5_q <= run_phase_q == 3'h7;
      equal_1588_s5_q <= equal_1588_s4_q;
      equal_2263_s5_q <= equal_2263_s4_q;
      and_2264_s5_q <= and_2264_s4_q;
      select_2267_s5_q <= select_2267;
      not_2741_s5_q <= ~({sum_2739, select_479_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_527;
  assign select_527 = run_shift_s5_q[5] ? x_s5_q : sum_526_s5_q;
  logic less_528;
  assign less_528 = {1'b0, last_s5_q} < select_527;
  // hls/stages/agreement.hpp:216
  logic not_529;
  assign not_529 = ~less_528;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:515
  logic [6:0] select_2336;
  assign select_2336 = select_2267_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2336;
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
  logic [3:0] select_461_s6_q;
  logic equal_462_s6_q;
  logic [6:0] select_464_s6_q;
  logic [8:0] select_468_s6_q;
  logic and_474_s6_q;
  logic equal_480_s6_q;
  logic [6:0] column_s6_q;
  logic and_498_s6_q;
  logic and_500_s6_q;
  logic so_s6_q;
  logic equal_520_s6_q;
  logic equal_523_s6_q;
  logic [6:0] sum_526_s6_q;
  logic less_528_s6_q;
  logic not_529_s6_q;
  logic and_530_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_640_s6_q;
  logic equal_645_s6_q;
  logic equal_1459_s6_q;
  logic equal_1469_s6_q;
  logic equal_1588_s6_q;
  logic equal_2263_s6_q;
  logic and_2264_s6_q;
  logic not_2741_s6_q;
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
      select_461_s6_q <= select_461_s5_q;
      equal_462_s6_q <= equal_462_s5_q;
      select_464_s6_q <= select_464_s5_q;
      select_468_s6_q <= select_468_s5_q;
      and_474_s6_q <= and_474_s5_q;
      equal_480_s6_q <= equal_480_s5_q;
      column_s6_q <= column_s5_q;
      and_498_s6_q <= and_498_s5_q;
      and_500_s6_q <= and_500_s5_q;
      so_s6_q <= so_s5_q;
      equal_520_s6_q <= equal_520_s5_q;
      equal_523_s6_q <= equal_523_s5_q;
      sum_526_s6_q <= sum_526_s5_q[6:0];
      less_528_s6_q <= less_528;
      not_529_s6_q <= not_529;
      and_530_s6_q <= equal_525_s5_q & not_529;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_640_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_636_s5_q < select_527)));
      equal_645_s6_q <= equal_645_s5_q;
      equal_1459_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1469_s6_q <= equal_1469_s5_q;
      equal_1588_s6_q <= equal_1588_s5_q;
      equal_2263_s6_q <= equal_2263_s5_q;
      and_2264_s6_q <= and_2264_s5_q;
      not_2741_s6_q <= not_2741_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:581
  logic or_521;
  assign or_521 = so_s6_q | equal_520_s6_q;
  // hls/stages/agreement.hpp:704
  logic not_522;
  assign not_522 = ~or_521;
  // hls/stages/agreement.hpp:141
  logic select_616;
  assign select_616 = equal_523_s6_q ? not_529_s6_q : and_530_s6_q;
  logic and_641;
  assign and_641 = equal_523_s6_q & and_640_s6_q;
  logic select_642;
  assign select_642 = or_521 ? not_529_s6_q : and_641;
  // hls/stages/agreement.hpp:782
  logic or_647;
  assign or_647 = equal_645_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_526_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1294; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_521 ? not_529_s6_q : select_616);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1295; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_523_s6_q ? sum_526_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_522 & select_616);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1296; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 46'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_521 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_642;
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
  logic [3:0] select_461_s7_q;
  logic equal_462_s7_q;
  logic [6:0] select_464_s7_q;
  logic [8:0] select_468_s7_q;
  logic and_474_s7_q;
  logic equal_480_s7_q;
  logic [6:0] column_s7_q;
  logic and_498_s7_q;
  logic and_500_s7_q;
  logic so_s7_q;
  logic equal_520_s7_q;
  logic or_521_s7_q;
  logic equal_523_s7_q;
  logic less_528_s7_q;
  logic not_529_s7_q;
  logic and_532_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_642_s7_q;
  logic select_649_s7_q;
  logic and_1451_s7_q;
  logic [6:0] right_s7_q;
  logic select_1460_s7_q;
  logic equal_1469_s7_q;
  logic equal_1588_s7_q;
  logic equal_2263_s7_q;
  logic and_2264_s7_q;
  logic not_2741_s7_q;
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
      select_461_s7_q <= select_461_s6_q;
      equal_462_s7_q <= equal_462_s6_q;
      select_464_s7_q <= select_464_s6_q;
      select_468_s7_q <= select_468_s6_q;
      and_474_s7_q <= and_474_s6_q;
      equal_480_s7_q <= equal_480_s6_q;
      column_s7_q <= column_s6_q;
      and_498_s7_q <= and_498_s6_q;
      and_500_s7_q <= and_500_s6_q;
      so_s7_q <= so_s6_q;
      equal_520_s7_q <= equal_520_s6_q;
      or_521_s7_q <= or_521;
      equal_523_s7_q <= equal_523_s6_q;
      less_528_s7_q <= less_528_s6_q;
      not_529_s7_q <= not_529_s6_q;
      and_532_s7_q <= not_522 & ((~equal_523_s6_q) & and_530_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_642_s7_q <= select_642;
      select_649_s7_q <= or_647 ? equal_645_s6_q : (~age_s6_q[1]);
      and_1451_s7_q <= not_522 & and_641;
      right_s7_q <= right;
      select_1460_s7_q <= or_647 ? equal_645_s6_q : equal_1459_s6_q;
      equal_1469_s7_q <= equal_1469_s6_q;
      equal_1588_s7_q <= equal_1588_s6_q;
      equal_2263_s7_q <= equal_2263_s6_q;
      and_2264_s7_q <= and_2264_s6_q;
      not_2741_s7_q <= not_2741_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1293; read in stage 7, written in stage 27: 7 < 27 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_532_s7_q;
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
  logic [3:0] select_461_s8_q;
  logic equal_462_s8_q;
  logic [6:0] select_464_s8_q;
  logic [8:0] select_468_s8_q;
  logic and_474_s8_q;
  logic equal_480_s8_q;
  logic [6:0] column_s8_q;
  logic and_498_s8_q;
  logic and_500_s8_q;
  logic so_s8_q;
  logic equal_520_s8_q;
  logic or_521_s8_q;
  logic equal_523_s8_q;
  logic less_528_s8_q;
  logic not_529_s8_q;
  logic and_532_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_642_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic select_649_s8_q;
  logic and_1451_s8_q;
  logic [6:0] right_s8_q;
  logic select_1460_s8_q;
  logic equal_1469_s8_q;
  logic equal_1588_s8_q;
  logic equal_2263_s8_q;
  logic and_2264_s8_q;
  logic not_2741_s8_q;
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
      select_461_s8_q <= select_461_s7_q;
      equal_462_s8_q <= equal_462_s7_q;
      select_464_s8_q <= select_464_s7_q;
      select_468_s8_q <= select_468_s7_q;
      and_474_s8_q <= and_474_s7_q;
      equal_480_s8_q <= equal_480_s7_q;
      column_s8_q <= column_s7_q;
      and_498_s8_q <= and_498_s7_q;
      and_500_s8_q <= and_500_s7_q;
      so_s8_q <= so_s7_q;
      equal_520_s8_q <= equal_520_s7_q;
      or_521_s8_q <= or_521_s7_q;
      equal_523_s8_q <= equal_523_s7_q;
      less_528_s8_q <= less_528_s7_q;
      not_529_s8_q <= not_529_s7_q;
      and_532_s8_q <= and_532_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_642_s8_q <= select_642_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      select_649_s8_q <= select_649_s7_q;
      and_1451_s8_q <= and_1451_s7_q;
      right_s8_q <= right_s7_q;
      select_1460_s8_q <= select_1460_s7_q;
      equal_1469_s8_q <= equal_1469_s7_q;
      equal_1588_s8_q <= equal_1588_s7_q;
      equal_2263_s8_q <= equal_2263_s7_q;
      and_2264_s8_q <= and_2264_s7_q;
      not_2741_s8_q <= not_2741_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  // hls/stages/agreement.hpp:653
  logic not_620;
  assign not_620 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:212
  logic and_655;
  assign and_655 = left_rdata_s8_q[44] & not_529_s8_q;
  logic and_656;
  assign and_656 = right_codes_rdata_s8_q[38] & not_529_s8_q;
  logic [11:0] select_657;
  assign select_657 = less_528_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_658;
  assign select_658 = less_528_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_662;
  assign select_662 = and_655 ? (and_656 ? (~(select_657 ^ select_658)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_678;
  assign and_678 = left_rdata_s8_q[60] & not_529_s8_q;
  logic and_679;
  assign and_679 = right_codes_rdata_s8_q[51] & not_529_s8_q;
  logic [11:0] select_680;
  assign select_680 = less_528_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_681;
  assign select_681 = less_528_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_685;
  assign select_685 = and_678 ? (and_679 ? (~(select_680 ^ select_681)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_695;
  assign and_695 = left_rdata_s8_q[76] & not_529_s8_q;
  logic and_696;
  assign and_696 = right_codes_rdata_s8_q[64] & not_529_s8_q;
  logic [11:0] select_697;
  assign select_697 = less_528_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_698;
  assign select_698 = less_528_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_702;
  assign select_702 = and_695 ? (and_696 ? (~(select_697 ^ select_698)) : 12'h0) : 12'h0;
  logic [11:0] select_910;
  assign select_910 = (slot_s8_q[0] ? and_696 : and_679) ? (~(select_658 ^ (slot_s8_q[0] ? select_697 : select_680))) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_927;
  assign and_927 = right_codes_rdata_s8_q[77] & not_529_s8_q;
  logic [11:0] select_929;
  assign select_929 = less_528_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_933;
  assign select_933 = (slot_s8_q[0] ? and_927 : and_696) ? (~(select_681 ^ (slot_s8_q[0] ? select_929 : select_697))) : 12'h0;
  // hls/stages/agreement.hpp:718
  logic select_945;
  assign select_945 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_529_s8_q) : and_927;
  logic [11:0] select_947;
  assign select_947 = slot_s8_q[0] ? (less_528_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_929;
  // hls/stages/agreement.hpp:212
  logic and_1156;
  assign and_1156 = right_codes_rdata_s8_q[25] & not_529_s8_q;
  // hls/stages/agreement.hpp:718
  logic select_1157;
  assign select_1157 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_529_s8_q) : and_1156;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1159;
  assign select_1159 = less_528_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1160;
  assign select_1160 = slot_s8_q[0] ? (less_528_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1159;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1184;
  assign select_1184 = (slot_s8_q[0] ? and_1156 : and_656) ? (~(select_681 ^ (slot_s8_q[0] ? select_1159 : select_657))) : 12'h0;
  logic [11:0] select_1199;
  assign select_1199 = (slot_s8_q[0] ? and_656 : and_679) ? (~(select_698 ^ (slot_s8_q[0] ? select_657 : select_680))) : 12'h0;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:932
  logic and_1475;
  assign and_1475 = (or_521_s8_q & (left_rdata_s8_q[61] & not_529_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:235
  logic and_1483;
  assign and_1483 = not_529_s8_q & (or_521_s8_q & (left_rdata_s8_q[63] & not_529_s8_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
    end else if (s8_en) begin
      row_q <= and_500_s8_q ? (equal_2263_s8_q ? row_s8_q : row_q) : row_q;
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
  logic [3:0] select_461_s9_q;
  logic equal_462_s9_q;
  logic [6:0] select_464_s9_q;
  logic [8:0] select_468_s9_q;
  logic and_474_s9_q;
  logic equal_480_s9_q;
  logic [6:0] column_s9_q;
  logic and_498_s9_q;
  logic and_500_s9_q;
  logic so_s9_q;
  logic equal_520_s9_q;
  logic or_521_s9_q;
  logic equal_523_s9_q;
  logic less_528_s9_q;
  logic not_529_s9_q;
  logic and_532_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic [6:0] row_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_621_s9_q;
  logic and_622_s9_q;
  logic and_623_s9_q;
  logic and_624_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_628_s9_q;
  logic and_629_s9_q;
  logic and_630_s9_q;
  logic and_631_s9_q;
  logic and_632_s9_q;
  logic and_633_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_642_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic select_649_s9_q;
  logic and_655_s9_q;
  logic [11:0] select_662_s9_q;
  logic and_678_s9_q;
  logic [11:0] select_685_s9_q;
  logic and_695_s9_q;
  logic [11:0] select_702_s9_q;
  logic [11:0] select_910_s9_q;
  logic [11:0] select_933_s9_q;
  logic [11:0] select_950_s9_q;
  logic [11:0] select_1163_s9_q;
  logic [11:0] select_1184_s9_q;
  logic [11:0] select_1199_s9_q;
  logic and_1451_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic select_1460_s9_q;
  logic equal_1469_s9_q;
  logic and_1476_s9_q;
  logic and_1479_s9_q;
  logic and_1483_s9_q;
  logic equal_1588_s9_q;
  logic less_1609_s9_q;
  logic and_1993_s9_q;
  logic equal_2263_s9_q;
  logic and_2264_s9_q;
  logic not_2741_s9_q;
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
      select_461_s9_q <= select_461_s8_q;
      equal_462_s9_q <= equal_462_s8_q;
      select_464_s9_q <= select_464_s8_q;
      select_468_s9_q <= select_468_s8_q;
      and_474_s9_q <= and_474_s8_q;
      equal_480_s9_q <= equal_480_s8_q;
      column_s9_q <= column_s8_q;
      and_498_s9_q <= and_498_s8_q;
      and_500_s9_q <= and_500_s8_q;
      so_s9_q <= so_s8_q;
      equal_520_s9_q <= equal_520_s8_q;
      or_521_s9_q <= or_521_s8_q;
      equal_523_s9_q <= equal_523_s8_q;
      less_528_s9_q <= less_528_s8_q;
      not_529_s9_q <= not_529_s8_q;
      and_532_s9_q <= and_532_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      row_s9_q <= row_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_621_s9_q <= left_rdata_s8_q[12] & not_620;
      and_622_s9_q <= left_rdata_s8_q[28] & not_620;
      and_623_s9_q <= left_rdata_s8_q[44] & not_620;
      and_624_s9_q <= left_rdata_s8_q[60] & not_620;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_628_s9_q <= right_codes_rdata_s8_q[12] & not_620;
      and_629_s9_q <= right_codes_rdata_s8_q[25] & not_620;
      and_630_s9_q <= right_codes_rdata_s8_q[38] & not_620;
      and_631_s9_q <= right_codes_rdata_s8_q[51] & not_620;
      and_632_s9_q <= right_codes_rdata_s8_q[64] & not_620;
      and_633_s9_q <= right_codes_rdata_s8_q[77] & not_620;
      x_s9_2_q <= x_s8_2_q;
      select_642_s9_q <= select_642_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_649_s9_q <= select_649_s8_q;
      and_655_s9_q <= and_655;
      select_662_s9_q <= select_662;
      and_678_s9_q <= and_678;
      select_685_s9_q <= select_685;
      and_695_s9_q <= and_695;
      select_702_s9_q <= select_702;
      select_910_s9_q <= select_910;
      select_933_s9_q <= select_933;
      select_950_s9_q <= select_945 ? (~(select_698 ^ select_947)) : 12'h0;
      select_1163_s9_q <= select_1157 ? (~(select_658 ^ select_1160)) : 12'h0;
      select_1184_s9_q <= select_1184;
      select_1199_s9_q <= select_1199;
      and_1451_s9_q <= and_1451_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      select_1460_s9_q <= select_1460_s8_q;
      equal_1469_s9_q <= equal_1469_s8_q;
      and_1476_s9_q <= not_529_s8_q & and_1475;
      and_1479_s9_q <= (or_521_s8_q & (left_rdata_s8_q[62] & not_529_s8_q)) & and_1475;
      and_1483_s9_q <= and_1483;
      equal_1588_s9_q <= equal_1588_s8_q;
      less_1609_s9_q <= 6'h4 < row_q[6:1];
      and_1993_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2263_s9_q <= equal_2263_s8_q;
      and_2264_s9_q <= and_2264_s8_q;
      not_2741_s9_q <= not_2741_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/count_bits.hpp:24
  logic parity_668;
  assign parity_668 = ^select_662_s9_q[5:3];
  logic parity_671;
  assign parity_671 = ^select_662_s9_q[8:6];
  logic parity_674;
  assign parity_674 = ^select_662_s9_q[11:3];
  logic parity_688;
  assign parity_688 = ^select_685_s9_q[8:6];
  logic parity_691;
  assign parity_691 = ^select_685_s9_q[11:9];
  logic parity_708;
  assign parity_708 = ^select_702_s9_q[2:0];
  logic parity_711;
  assign parity_711 = ^select_702_s9_q[5:3];
  logic parity_714;
  assign parity_714 = ^select_702_s9_q[8:0];
  logic parity_720;
  assign parity_720 = ^select_702_s9_q[11:9];
  logic parity_723;
  assign parity_723 = ^select_685_s9_q[2:0];
  logic parity_726;
  assign parity_726 = ^{select_702_s9_q[11:9], select_685_s9_q[5:0]};
  logic parity_729;
  assign parity_729 = ^{select_702_s9_q, select_685_s9_q, select_662_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_734;
  assign or_734 = (select_662_s9_q[1:0] == 2'h3) | (select_662_s9_q[2] & (select_662_s9_q[0] | select_662_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_738;
  assign or_738 = (select_685_s9_q[7:6] == 2'h3) | (select_685_s9_q[8] & (select_685_s9_q[6] | select_685_s9_q[7]));
  logic or_742;
  assign or_742 = (select_685_s9_q[10:9] == 2'h3) | (select_685_s9_q[11] & (select_685_s9_q[9] | select_685_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_750;
  assign or_750 = (select_702_s9_q[7:6] == 2'h3) | (select_702_s9_q[8] & (~(select_702_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_754;
  assign or_754 = (select_702_s9_q[1:0] == 2'h3) | (select_702_s9_q[2] & (select_702_s9_q[0] | select_702_s9_q[1]));
  logic or_758;
  assign or_758 = (select_702_s9_q[4:3] == 2'h3) | (select_702_s9_q[5] & (select_702_s9_q[3] | select_702_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_761;
  assign parity_761 = ^{or_758, or_754, or_750};
  // hls/stages/count_bits.hpp:23
  logic or_765;
  assign or_765 = (select_685_s9_q[4:3] == 2'h3) | (select_685_s9_q[5] & (select_685_s9_q[3] | select_685_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_769;
  assign or_769 = (select_702_s9_q[10:9] == 2'h3) | (select_702_s9_q[11] & (select_702_s9_q[9] | select_702_s9_q[10]));
  logic or_773;
  assign or_773 = (select_685_s9_q[1:0] == 2'h3) | (select_685_s9_q[2] & (select_685_s9_q[0] | select_685_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_776;
  assign parity_776 = ^{or_773, or_769, or_765};
  logic parity_779;
  assign parity_779 = ^{or_773, or_769, or_765, or_758, or_754, or_750, or_742, or_738, or_734};
  // hls/stages/count_bits.hpp:25
  logic or_784;
  assign or_784 = (parity_668 & parity_671) | ((^select_662_s9_q[11:9]) & (parity_668 | parity_671));
  logic and_787;
  assign and_787 = (^{select_685_s9_q[11:6], select_662_s9_q[2:0]}) & (parity_714 | parity_726);
  // hls/stages/count_bits.hpp:23
  logic or_795;
  assign or_795 = (select_662_s9_q[10:9] == 2'h3) | (select_662_s9_q[11] & (select_662_s9_q[9] | select_662_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_799;
  assign or_799 = (select_662_s9_q[4:3] == 2'h3) | (select_662_s9_q[5] & (select_662_s9_q[3] | select_662_s9_q[4]));
  logic or_803;
  assign or_803 = (select_662_s9_q[7:6] == 2'h3) | (select_662_s9_q[8] & (select_662_s9_q[6] | select_662_s9_q[7]));
  logic or_810;
  assign or_810 = (parity_688 & parity_691) | ((^select_662_s9_q[2:0]) & (parity_688 | parity_691));
  logic or_814;
  assign or_814 = (parity_708 & parity_711) | ((^select_702_s9_q[8:6]) & (parity_708 | parity_711));
  logic or_818;
  assign or_818 = (parity_720 & parity_723) | ((^select_685_s9_q[5:3]) & (parity_720 | parity_723));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_911;
  assign select_911 = and_655_s9_q ? select_910_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_917;
  assign parity_917 = ^select_911[5:3];
  logic parity_920;
  assign parity_920 = ^select_911[8:6];
  logic parity_923;
  assign parity_923 = ^select_911[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_934;
  assign select_934 = and_678_s9_q ? select_933_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_937;
  assign parity_937 = ^select_934[8:6];
  logic parity_940;
  assign parity_940 = ^select_934[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_951;
  assign select_951 = and_695_s9_q ? select_950_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_957;
  assign parity_957 = ^select_951[2:0];
  logic parity_960;
  assign parity_960 = ^select_951[5:3];
  logic parity_963;
  assign parity_963 = ^select_951[8:0];
  logic parity_969;
  assign parity_969 = ^select_951[11:9];
  logic parity_972;
  assign parity_972 = ^select_934[2:0];
  logic parity_975;
  assign parity_975 = ^{select_951[11:9], select_934[5:0]};
  logic parity_978;
  assign parity_978 = ^{select_951, select_934, select_911[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_983;
  assign or_983 = (select_911[1:0] == 2'h3) | (select_911[2] & (select_911[0] | select_911[1]));
  // hls/stages/count_bits.hpp:25
  logic or_987;
  assign or_987 = (select_934[7:6] == 2'h3) | (select_934[8] & (select_934[6] | select_934[7]));
  logic or_991;
  assign or_991 = (select_934[10:9] == 2'h3) | (select_934[11] & (select_934[9] | select_934[10]));
  // hls/stages/count_bits.hpp:23
  logic or_999;
  assign or_999 = (select_951[7:6] == 2'h3) | (select_951[8] & (~(select_951[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1003;
  assign or_1003 = (select_951[1:0] == 2'h3) | (select_951[2] & (select_951[0] | select_951[1]));
  logic or_1007;
  assign or_1007 = (select_951[4:3] == 2'h3) | (select_951[5] & (select_951[3] | select_951[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1010;
  assign parity_1010 = ^{or_1007, or_1003, or_999};
  // hls/stages/count_bits.hpp:23
  logic or_1014;
  assign or_1014 = (select_934[4:3] == 2'h3) | (select_934[5] & (select_934[3] | select_934[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1018;
  assign or_1018 = (select_951[10:9] == 2'h3) | (select_951[11] & (select_951[9] | select_951[10]));
  logic or_1022;
  assign or_1022 = (select_934[1:0] == 2'h3) | (select_934[2] & (select_934[0] | select_934[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1025;
  assign parity_1025 = ^{or_1022, or_1018, or_1014};
  logic parity_1028;
  assign parity_1028 = ^{or_1022, or_1018, or_1014, or_1007, or_1003, or_999, or_991, or_987, or_983};
  // hls/stages/count_bits.hpp:25
  logic or_1033;
  assign or_1033 = (parity_917 & parity_920) | ((^select_911[11:9]) & (parity_917 | parity_920));
  logic and_1036;
  assign and_1036 = (^{select_934[11:6], select_911[2:0]}) & (parity_963 | parity_975);
  // hls/stages/count_bits.hpp:23
  logic or_1044;
  assign or_1044 = (select_911[10:9] == 2'h3) | (select_911[11] & (select_911[9] | select_911[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1048;
  assign or_1048 = (select_911[4:3] == 2'h3) | (select_911[5] & (select_911[3] | select_911[4]));
  logic or_1052;
  assign or_1052 = (select_911[7:6] == 2'h3) | (select_911[8] & (select_911[6] | select_911[7]));
  logic or_1059;
  assign or_1059 = (parity_937 & parity_940) | ((^select_911[2:0]) & (parity_937 | parity_940));
  logic or_1063;
  assign or_1063 = (parity_957 & parity_960) | ((^select_951[8:6]) & (parity_957 | parity_960));
  logic or_1067;
  assign or_1067 = (parity_969 & parity_972) | ((^select_934[5:3]) & (parity_969 | parity_972));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1164;
  assign select_1164 = and_655_s9_q ? select_1163_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1170;
  assign parity_1170 = ^select_1164[5:3];
  logic parity_1173;
  assign parity_1173 = ^select_1164[8:6];
  logic parity_1176;
  assign parity_1176 = ^select_1164[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1185;
  assign select_1185 = and_678_s9_q ? select_1184_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1188;
  assign parity_1188 = ^select_1185[8:6];
  logic parity_1191;
  assign parity_1191 = ^select_1185[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1200;
  assign select_1200 = and_695_s9_q ? select_1199_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1206;
  assign parity_1206 = ^select_1200[2:0];
  logic parity_1209;
  assign parity_1209 = ^select_1200[5:3];
  logic parity_1212;
  assign parity_1212 = ^select_1200[8:0];
  logic parity_1218;
  assign parity_1218 = ^select_1200[11:9];
  logic parity_1221;
  assign parity_1221 = ^select_1185[2:0];
  logic parity_1224;
  assign parity_1224 = ^{select_1200[11:9], select_1185[5:0]};
  logic parity_1227;
  assign parity_1227 = ^{select_1200, select_1185, select_1164[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1232;
  assign or_1232 = (select_1164[1:0] == 2'h3) | (select_1164[2] & (select_1164[0] | select_1164[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1236;
  assign or_1236 = (select_1185[7:6] == 2'h3) | (select_1185[8] & (select_1185[6] | select_1185[7]));
  logic or_1240;
  assign or_1240 = (select_1185[10:9] == 2'h3) | (select_1185[11] & (select_1185[9] | select_1185[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1248;
  assign or_1248 = (select_1200[7:6] == 2'h3) | (select_1200[8] & (~(select_1200[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1252;
  assign or_1252 = (select_1200[1:0] == 2'h3) | (select_1200[2] & (select_1200[0] | select_1200[1]));
  logic or_1256;
  assign or_1256 = (select_1200[4:3] == 2'h3) | (select_1200[5] & (select_1200[3] | select_1200[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1259;
  assign parity_1259 = ^{or_1256, or_1252, or_1248};
  // hls/stages/count_bits.hpp:23
  logic or_1263;
  assign or_1263 = (select_1185[4:3] == 2'h3) | (select_1185[5] & (select_1185[3] | select_1185[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1267;
  assign or_1267 = (select_1200[10:9] == 2'h3) | (select_1200[11] & (select_1200[9] | select_1200[10]));
  logic or_1271;
  assign or_1271 = (select_1185[1:0] == 2'h3) | (select_1185[2] & (select_1185[0] | select_1185[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1274;
  assign parity_1274 = ^{or_1271, or_1267, or_1263};
  logic parity_1277;
  assign parity_1277 = ^{or_1271, or_1267, or_1263, or_1256, or_1252, or_1248, or_1240, or_1236, or_1232};
  // hls/stages/count_bits.hpp:25
  logic or_1282;
  assign or_1282 = (parity_1170 & parity_1173) | ((^select_1164[11:9]) & (parity_1170 | parity_1173));
  logic and_1285;
  assign and_1285 = (^{select_1185[11:6], select_1164[2:0]}) & (parity_1212 | parity_1224);
  // hls/stages/count_bits.hpp:23
  logic or_1293;
  assign or_1293 = (select_1164[10:9] == 2'h3) | (select_1164[11] & (select_1164[9] | select_1164[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1297;
  assign or_1297 = (select_1164[4:3] == 2'h3) | (select_1164[5] & (select_1164[3] | select_1164[4]));
  logic or_1301;
  assign or_1301 = (select_1164[7:6] == 2'h3) | (select_1164[8] & (select_1164[6] | select_1164[7]));
  logic or_1308;
  assign or_1308 = (parity_1188 & parity_1191) | ((^select_1164[2:0]) & (parity_1188 | parity_1191));
  logic or_1312;
  assign or_1312 = (parity_1206 & parity_1209) | ((^select_1200[8:6]) & (parity_1206 | parity_1209));
  logic or_1316;
  assign or_1316 = (parity_1218 & parity_1221) | ((^select_1185[5:3]) & (parity_1218 | parity_1221));
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:235
  logic or_1497;
  assign or_1497 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_532_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_624_s9_q, left_rdata_s9_q[56:42], and_623_s9_q, left_rdata_s9_q[41:27], and_622_s9_q, left_rdata_s9_q[26:12], and_621_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_532_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_633_s9_q, right_codes_rdata_s9_q[71:60], and_632_s9_q, right_codes_rdata_s9_q[59:48], and_631_s9_q, right_codes_rdata_s9_q[47:36], and_630_s9_q, right_codes_rdata_s9_q[35:24], and_629_s9_q, right_codes_rdata_s9_q[23:12], and_628_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
  logic [3:0] select_461_s10_q;
  logic equal_462_s10_q;
  logic [6:0] select_464_s10_q;
  logic [8:0] select_468_s10_q;
  logic and_474_s10_q;
  logic equal_480_s10_q;
  logic [6:0] column_s10_q;
  logic and_498_s10_q;
  logic and_500_s10_q;
  logic so_s10_q;
  logic equal_520_s10_q;
  logic or_521_s10_q;
  logic equal_523_s10_q;
  logic less_528_s10_q;
  logic not_529_s10_q;
  logic [6:0] row_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_642_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic select_649_s10_q;
  logic xor_730_s10_q;
  logic parity_779_s10_q;
  logic and_780_s10_q;
  logic or_784_s10_q;
  logic or_788_s10_q;
  logic or_795_s10_q;
  logic or_799_s10_q;
  logic or_803_s10_q;
  logic or_810_s10_q;
  logic or_814_s10_q;
  logic or_818_s10_q;
  logic and_827_s10_q;
  logic and_829_s10_q;
  logic or_841_s10_q;
  logic or_845_s10_q;
  logic or_849_s10_q;
  logic xor_979_s10_q;
  logic parity_994_s10_q;
  logic parity_1028_s10_q;
  logic and_1029_s10_q;
  logic or_1033_s10_q;
  logic or_1037_s10_q;
  logic or_1044_s10_q;
  logic or_1048_s10_q;
  logic or_1052_s10_q;
  logic or_1059_s10_q;
  logic or_1063_s10_q;
  logic or_1067_s10_q;
  logic and_1076_s10_q;
  logic or_1077_s10_q;
  logic or_1090_s10_q;
  logic or_1094_s10_q;
  logic or_1098_s10_q;
  logic xor_1228_s10_q;
  logic parity_1243_s10_q;
  logic parity_1277_s10_q;
  logic and_1278_s10_q;
  logic or_1282_s10_q;
  logic or_1286_s10_q;
  logic or_1293_s10_q;
  logic or_1297_s10_q;
  logic or_1301_s10_q;
  logic or_1308_s10_q;
  logic or_1312_s10_q;
  logic or_1316_s10_q;
  logic and_1325_s10_q;
  logic or_1326_s10_q;
  logic or_1339_s10_q;
  logic or_1343_s10_q;
  logic or_1347_s10_q;
  logic and_1451_s10_q;
  logic [6:0] select_1455_s10_q;
  logic [6:0] right_s10_q;
  logic select_1460_s10_q;
  logic equal_1469_s10_q;
  logic and_1476_s10_q;
  logic and_1479_s10_q;
  logic and_1483_s10_q;
  logic or_1497_s10_q;
  logic equal_1588_s10_q;
  logic less_1609_s10_q;
  logic and_1993_s10_q;
  logic equal_2263_s10_q;
  logic and_2264_s10_q;
  logic not_2741_s10_q;
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
      select_461_s10_q <= select_461_s9_q;
      equal_462_s10_q <= equal_462_s9_q;
      select_464_s10_q <= select_464_s9_q;
      select_468_s10_q <= select_468_s9_q;
      and_474_s10_q <= and_474_s9_q;
      equal_480_s10_q <= equal_480_s9_q;
      column_s10_q <= column_s9_q;
      and_498_s10_q <= and_498_s9_q;
      and_500_s10_q <= and_500_s9_q;
      so_s10_q <= so_s9_q;
      equal_520_s10_q <= equal_520_s9_q;
      or_521_s10_q <= or_521_s9_q;
      equal_523_s10_q <= equal_523_s9_q;
      less_528_s10_q <= less_528_s9_q;
      not_529_s10_q <= not_529_s9_q;
      row_s10_q <= row_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_642_s10_q <= select_642_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_649_s10_q <= select_649_s9_q;
      xor_730_s10_q <= parity_674 ^ parity_729;
      parity_779_s10_q <= parity_779;
      and_780_s10_q <= parity_674 & parity_729;
      or_784_s10_q <= or_784;
      or_788_s10_q <= (parity_714 & parity_726) | and_787;
      or_795_s10_q <= or_795;
      or_799_s10_q <= or_799;
      or_803_s10_q <= or_803;
      or_810_s10_q <= or_810;
      or_814_s10_q <= or_814;
      or_818_s10_q <= or_818;
      and_827_s10_q <= parity_761 & parity_776;
      and_829_s10_q <= (^{or_742, or_738, or_734}) & (parity_761 | parity_776);
      or_841_s10_q <= (or_738 & or_742) | (or_734 & (or_738 | or_742));
      or_845_s10_q <= (or_754 & or_758) | (or_750 & (or_754 | or_758));
      or_849_s10_q <= (or_769 & or_773) | (or_765 & (or_769 | or_773));
      xor_979_s10_q <= parity_923 ^ parity_978;
      parity_994_s10_q <= ^{or_991, or_987, or_983};
      parity_1028_s10_q <= parity_1028;
      and_1029_s10_q <= parity_923 & parity_978;
      or_1033_s10_q <= or_1033;
      or_1037_s10_q <= (parity_963 & parity_975) | and_1036;
      or_1044_s10_q <= or_1044;
      or_1048_s10_q <= or_1048;
      or_1052_s10_q <= or_1052;
      or_1059_s10_q <= or_1059;
      or_1063_s10_q <= or_1063;
      or_1067_s10_q <= or_1067;
      and_1076_s10_q <= parity_1010 & parity_1025;
      or_1077_s10_q <= parity_1010 | parity_1025;
      or_1090_s10_q <= (or_987 & or_991) | (or_983 & (or_987 | or_991));
      or_1094_s10_q <= (or_1003 & or_1007) | (or_999 & (or_1003 | or_1007));
      or_1098_s10_q <= (or_1018 & or_1022) | (or_1014 & (or_1018 | or_1022));
      xor_1228_s10_q <= parity_1176 ^ parity_1227;
      parity_1243_s10_q <= ^{or_1240, or_1236, or_1232};
      parity_1277_s10_q <= parity_1277;
      and_1278_s10_q <= parity_1176 & parity_1227;
      or_1282_s10_q <= or_1282;
      or_1286_s10_q <= (parity_1212 & parity_1224) | and_1285;
      or_1293_s10_q <= or_1293;
      or_1297_s10_q <= or_1297;
      or_1301_s10_q <= or_1301;
      or_1308_s10_q <= or_1308;
      or_1312_s10_q <= or_1312;
      or_1316_s10_q <= or_1316;
      and_1325_s10_q <= parity_1259 & parity_1274;
      or_1326_s10_q <= parity_1259 | parity_1274;
      or_1339_s10_q <= (or_1236 & or_1240) | (or_1232 & (or_1236 | or_1240));
      or_1343_s10_q <= (or_1252 & or_1256) | (or_1248 & (or_1252 | or_1256));
      or_1347_s10_q <= (or_1267 & or_1271) | (or_1263 & (or_1267 | or_1271));
      and_1451_s10_q <= and_1451_s9_q;
      select_1455_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      select_1460_s10_q <= select_1460_s9_q;
      equal_1469_s10_q <= equal_1469_s9_q;
      and_1476_s10_q <= and_1476_s9_q;
      and_1479_s10_q <= and_1479_s9_q;
      and_1483_s10_q <= and_1483_s9_q;
      or_1497_s10_q <= or_1497;
      equal_1588_s10_q <= equal_1588_s9_q;
      less_1609_s10_q <= less_1609_s9_q;
      and_1993_s10_q <= and_1993_s9_q;
      equal_2263_s10_q <= equal_2263_s9_q;
      and_2264_s10_q <= and_2264_s9_q;
      not_2741_s10_q <= not_2741_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_phase_q;
  // hls/stages/count_bits.hpp:24
  logic parity_806;
  assign parity_806 = ^{or_803_s10_q, or_799_s10_q, or_795_s10_q};
  logic parity_821;
  assign parity_821 = ^{or_818_s10_q, or_814_s10_q, or_810_s10_q};
  logic parity_824;
  assign parity_824 = ^{or_818_s10_q, or_814_s10_q, or_810_s10_q, or_803_s10_q, or_799_s10_q, or_795_s10_q, or_788_s10_q, or_784_s10_q, and_780_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_826;
  assign and_826 = parity_779_s10_q & parity_824;
  logic or_830;
  assign or_830 = and_827_s10_q | and_829_s10_q;
  logic and_833;
  assign and_833 = (^{or_788_s10_q, or_784_s10_q, and_780_s10_q}) & (parity_806 | parity_821);
  logic or_834;
  assign or_834 = (parity_806 & parity_821) | and_833;
  // hls/stages/count_bits.hpp:24
  logic parity_852;
  assign parity_852 = ^{or_849_s10_q, or_845_s10_q, or_841_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_856;
  assign or_856 = (or_784_s10_q & or_788_s10_q) | (and_780_s10_q & (or_784_s10_q | or_788_s10_q));
  logic or_860;
  assign or_860 = (or_799_s10_q & or_803_s10_q) | (or_795_s10_q & (or_799_s10_q | or_803_s10_q));
  logic or_864;
  assign or_864 = (or_814_s10_q & or_818_s10_q) | (or_810_s10_q & (or_814_s10_q | or_818_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_867;
  assign parity_867 = ^{or_864, or_860, or_856};
  logic parity_870;
  assign parity_870 = ^{or_864, or_860, or_856, or_849_s10_q, or_845_s10_q, or_841_s10_q, or_834, or_830, and_826};
  // hls/stages/count_bits.hpp:25
  logic or_882;
  assign or_882 = (or_845_s10_q & or_849_s10_q) | (or_841_s10_q & (or_845_s10_q | or_849_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1055;
  assign parity_1055 = ^{or_1052_s10_q, or_1048_s10_q, or_1044_s10_q};
  logic parity_1070;
  assign parity_1070 = ^{or_1067_s10_q, or_1063_s10_q, or_1059_s10_q};
  logic parity_1073;
  assign parity_1073 = ^{or_1067_s10_q, or_1063_s10_q, or_1059_s10_q, or_1052_s10_q, or_1048_s10_q, or_1044_s10_q, or_1037_s10_q, or_1033_s10_q, and_1029_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1075;
  assign and_1075 = parity_1028_s10_q & parity_1073;
  logic or_1079;
  assign or_1079 = and_1076_s10_q | (parity_994_s10_q & or_1077_s10_q);
  logic and_1082;
  assign and_1082 = (^{or_1037_s10_q, or_1033_s10_q, and_1029_s10_q}) & (parity_1055 | parity_1070);
  logic or_1083;
  assign or_1083 = (parity_1055 & parity_1070) | and_1082;
  // hls/stages/count_bits.hpp:24
  logic parity_1101;
  assign parity_1101 = ^{or_1098_s10_q, or_1094_s10_q, or_1090_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1105;
  assign or_1105 = (or_1033_s10_q & or_1037_s10_q) | (and_1029_s10_q & (or_1033_s10_q | or_1037_s10_q));
  logic or_1109;
  assign or_1109 = (or_1048_s10_q & or_1052_s10_q) | (or_1044_s10_q & (or_1048_s10_q | or_1052_s10_q));
  logic or_1113;
  assign or_1113 = (or_1063_s10_q & or_1067_s10_q) | (or_1059_s10_q & (or_1063_s10_q | or_1067_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1116;
  assign parity_1116 = ^{or_1113, or_1109, or_1105};
  logic parity_1119;
  assign parity_1119 = ^{or_1113, or_1109, or_1105, or_1098_s10_q, or_1094_s10_q, or_1090_s10_q, or_1083, or_1079, and_1075};
  // hls/stages/count_bits.hpp:25
  logic or_1131;
  assign or_1131 = (or_1094_s10_q & or_1098_s10_q) | (or_1090_s10_q & (or_1094_s10_q | or_1098_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1304;
  assign parity_1304 = ^{or_1301_s10_q, or_1297_s10_q, or_1293_s10_q};
  logic parity_1319;
  assign parity_1319 = ^{or_1316_s10_q, or_1312_s10_q, or_1308_s10_q};
  logic parity_1322;
  assign parity_1322 = ^{or_1316_s10_q, or_1312_s10_q, or_1308_s10_q, or_1301_s10_q, or_1297_s10_q, or_1293_s10_q, or_1286_s10_q, or_1282_s10_q, and_1278_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1324;
  assign and_1324 = parity_1277_s10_q & parity_1322;
  logic or_1328;
  assign or_1328 = and_1325_s10_q | (parity_1243_s10_q & or_1326_s10_q);
  logic and_1331;
  assign and_1331 = (^{or_1286_s10_q, or_1282_s10_q, and_1278_s10_q}) & (parity_1304 | parity_1319);
  logic or_1332;
  assign or_1332 = (parity_1304 & parity_1319) | and_1331;
  // hls/stages/count_bits.hpp:24
  logic parity_1350;
  assign parity_1350 = ^{or_1347_s10_q, or_1343_s10_q, or_1339_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1354;
  assign or_1354 = (or_1282_s10_q & or_1286_s10_q) | (and_1278_s10_q & (or_1282_s10_q | or_1286_s10_q));
  logic or_1358;
  assign or_1358 = (or_1297_s10_q & or_1301_s10_q) | (or_1293_s10_q & (or_1297_s10_q | or_1301_s10_q));
  logic or_1362;
  assign or_1362 = (or_1312_s10_q & or_1316_s10_q) | (or_1308_s10_q & (or_1312_s10_q | or_1316_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1365;
  assign parity_1365 = ^{or_1362, or_1358, or_1354};
  logic parity_1368;
  assign parity_1368 = ^{or_1362, or_1358, or_1354, or_1347_s10_q, or_1343_s10_q, or_1339_s10_q, or_1332, or_1328, and_1324};
  // hls/stages/count_bits.hpp:25
  logic or_1380;
  assign or_1380 = (or_1343_s10_q & or_1347_s10_q) | (or_1339_s10_q & (or_1343_s10_q | or_1347_s10_q));
  // hls/stages/agreement.hpp:141
  logic [6:0] select_1507;
  assign select_1507 = or_521_s10_q ? (less_528_s10_q ? 7'h0 : select_1455_s10_q) : 7'h0;
  // hls/stages/patches.hpp:99
  logic and_1582;
  assign and_1582 = (select_461_s10_q == 4'h0) & (select_464_s10_q == 7'h0);
  // hls/stages/patches.hpp:292
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:103
  logic [3:0] select_2675;
  assign select_2675 = and_1582 ? (sample_pair_first_s10_q ? phase : patches_phase_q) : patches_phase_q;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1297; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_521_s10_q ? select_1455_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_642_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_phase_q <= 4'h0;
    end else if (s10_en) begin
      patches_phase_q <= sample_pair_whole_s10_q ? select_2675 : patches_phase_q;
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
  logic [3:0] select_461_s11_q;
  logic equal_462_s11_q;
  logic [6:0] select_464_s11_q;
  logic [8:0] select_468_s11_q;
  logic and_474_s11_q;
  logic equal_480_s11_q;
  logic [6:0] column_s11_q;
  logic and_498_s11_q;
  logic and_500_s11_q;
  logic so_s11_q;
  logic equal_520_s11_q;
  logic or_521_s11_q;
  logic equal_523_s11_q;
  logic less_528_s11_q;
  logic not_529_s11_q;
  logic [6:0] row_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic select_649_s11_q;
  logic xor_730_s11_q;
  logic xor_825_s11_q;
  logic parity_870_s11_q;
  logic and_871_s11_q;
  logic and_873_s11_q;
  logic and_875_s11_q;
  logic and_877_s11_q;
  logic or_882_s11_q;
  logic or_886_s11_q;
  logic xor_979_s11_q;
  logic xor_1074_s11_q;
  logic parity_1119_s11_q;
  logic and_1120_s11_q;
  logic and_1122_s11_q;
  logic and_1124_s11_q;
  logic and_1126_s11_q;
  logic or_1131_s11_q;
  logic or_1135_s11_q;
  logic xor_1228_s11_q;
  logic xor_1323_s11_q;
  logic parity_1368_s11_q;
  logic and_1369_s11_q;
  logic and_1371_s11_q;
  logic and_1373_s11_q;
  logic and_1375_s11_q;
  logic or_1380_s11_q;
  logic or_1384_s11_q;
  logic and_1451_s11_q;
  logic [6:0] right_s11_q;
  logic select_1460_s11_q;
  logic equal_1469_s11_q;
  logic and_1476_s11_q;
  logic and_1479_s11_q;
  logic and_1483_s11_q;
  logic or_1497_s11_q;
  logic [6:0] select_1508_s11_q;
  logic and_1582_s11_q;
  logic equal_1588_s11_q;
  logic less_1609_s11_q;
  logic and_1993_s11_q;
  logic equal_2263_s11_q;
  logic and_2264_s11_q;
  logic [3:0] phase_s11_q;
  logic not_2741_s11_q;
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
      select_461_s11_q <= select_461_s10_q;
      equal_462_s11_q <= equal_462_s10_q;
      select_464_s11_q <= select_464_s10_q;
      select_468_s11_q <= select_468_s10_q;
      and_474_s11_q <= and_474_s10_q;
      equal_480_s11_q <= equal_480_s10_q;
      column_s11_q <= column_s10_q;
      and_498_s11_q <= and_498_s10_q;
      and_500_s11_q <= and_500_s10_q;
      so_s11_q <= so_s10_q;
      equal_520_s11_q <= equal_520_s10_q;
      or_521_s11_q <= or_521_s10_q;
      equal_523_s11_q <= equal_523_s10_q;
      less_528_s11_q <= less_528_s10_q;
      not_529_s11_q <= not_529_s10_q;
      row_s11_q <= row_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_649_s11_q <= select_649_s10_q;
      xor_730_s11_q <= xor_730_s10_q;
      xor_825_s11_q <= parity_779_s10_q ^ parity_824;
      parity_870_s11_q <= parity_870;
      and_871_s11_q <= parity_852 & parity_867;
      and_873_s11_q <= (^{or_834, or_830, and_826}) & (parity_852 | parity_867);
      and_875_s11_q <= or_830 & or_834;
      and_877_s11_q <= and_826 & (or_830 | or_834);
      or_882_s11_q <= or_882;
      or_886_s11_q <= (or_860 & or_864) | (or_856 & (or_860 | or_864));
      xor_979_s11_q <= xor_979_s10_q;
      xor_1074_s11_q <= parity_1028_s10_q ^ parity_1073;
      parity_1119_s11_q <= parity_1119;
      and_1120_s11_q <= parity_1101 & parity_1116;
      and_1122_s11_q <= (^{or_1083, or_1079, and_1075}) & (parity_1101 | parity_1116);
      and_1124_s11_q <= or_1079 & or_1083;
      and_1126_s11_q <= and_1075 & (or_1079 | or_1083);
      or_1131_s11_q <= or_1131;
      or_1135_s11_q <= (or_1109 & or_1113) | (or_1105 & (or_1109 | or_1113));
      xor_1228_s11_q <= xor_1228_s10_q;
      xor_1323_s11_q <= parity_1277_s10_q ^ parity_1322;
      parity_1368_s11_q <= parity_1368;
      and_1369_s11_q <= parity_1350 & parity_1365;
      and_1371_s11_q <= (^{or_1332, or_1328, and_1324}) & (parity_1350 | parity_1365);
      and_1373_s11_q <= or_1328 & or_1332;
      and_1375_s11_q <= and_1324 & (or_1328 | or_1332);
      or_1380_s11_q <= or_1380;
      or_1384_s11_q <= (or_1358 & or_1362) | (or_1354 & (or_1358 | or_1362));
      and_1451_s11_q <= and_1451_s10_q;
      right_s11_q <= right_s10_q;
      select_1460_s11_q <= select_1460_s10_q;
      equal_1469_s11_q <= equal_1469_s10_q;
      and_1476_s11_q <= and_1476_s10_q;
      and_1479_s11_q <= and_1479_s10_q;
      and_1483_s11_q <= and_1483_s10_q;
      or_1497_s11_q <= or_1497_s10_q;
      select_1508_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1507;
      and_1582_s11_q <= and_1582;
      equal_1588_s11_q <= equal_1588_s10_q;
      less_1609_s11_q <= less_1609_s10_q;
      and_1993_s11_q <= and_1993_s10_q;
      equal_2263_s11_q <= equal_2263_s10_q;
      and_2264_s11_q <= and_2264_s10_q;
      phase_s11_q <= phase;
      not_2741_s11_q <= not_2741_s10_q;
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
  logic or_874;
  assign or_874 = and_871_s11_q | and_873_s11_q;
  logic or_878;
  assign or_878 = and_875_s11_q | and_877_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_891;
  assign parity_891 = ^{or_886_s11_q, or_882_s11_q, or_878, or_874};
  // hls/stages/count_bits.hpp:25
  logic or_895;
  assign or_895 = (or_882_s11_q & or_886_s11_q) | (or_878 & (or_882_s11_q | or_886_s11_q));
  logic and_896;
  assign and_896 = or_874 & (^{or_886_s11_q, or_882_s11_q, or_878});
  // hls/stages/count_bits.hpp:24
  logic xor_897;
  assign xor_897 = or_895 ^ and_896;
  // hls/stages/count_bits.hpp:27
  logic and_898;
  assign and_898 = or_895 & and_896;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_899;
  assign select_899 = equal_523_s11_q ? {and_898, xor_897, parity_891, parity_870_s11_q, xor_825_s11_q, xor_730_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_521_s11_q ? 6'h0 : select_899;
  // hls/stages/count_bits.hpp:25
  logic or_1123;
  assign or_1123 = and_1120_s11_q | and_1122_s11_q;
  logic or_1127;
  assign or_1127 = and_1124_s11_q | and_1126_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1140;
  assign parity_1140 = ^{or_1135_s11_q, or_1131_s11_q, or_1127, or_1123};
  // hls/stages/count_bits.hpp:25
  logic or_1144;
  assign or_1144 = (or_1131_s11_q & or_1135_s11_q) | (or_1127 & (or_1131_s11_q | or_1135_s11_q));
  logic and_1145;
  assign and_1145 = or_1123 & (^{or_1135_s11_q, or_1131_s11_q, or_1127});
  // hls/stages/count_bits.hpp:24
  logic xor_1146;
  assign xor_1146 = or_1144 ^ and_1145;
  // hls/stages/count_bits.hpp:27
  logic and_1147;
  assign and_1147 = or_1144 & and_1145;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1148;
  assign select_1148 = equal_523_s11_q ? {and_1147, xor_1146, parity_1140, parity_1119_s11_q, xor_1074_s11_q, xor_979_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_521_s11_q ? 6'h0 : select_1148;
  // hls/stages/count_bits.hpp:25
  logic or_1372;
  assign or_1372 = and_1369_s11_q | and_1371_s11_q;
  logic or_1376;
  assign or_1376 = and_1373_s11_q | and_1375_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1389;
  assign parity_1389 = ^{or_1384_s11_q, or_1380_s11_q, or_1376, or_1372};
  // hls/stages/count_bits.hpp:25
  logic or_1393;
  assign or_1393 = (or_1380_s11_q & or_1384_s11_q) | (or_1376 & (or_1380_s11_q | or_1384_s11_q));
  logic and_1394;
  assign and_1394 = or_1372 & (^{or_1384_s11_q, or_1380_s11_q, or_1376});
  // hls/stages/count_bits.hpp:24
  logic xor_1395;
  assign xor_1395 = or_1393 ^ and_1394;
  // hls/stages/count_bits.hpp:27
  logic and_1396;
  assign and_1396 = or_1393 & and_1394;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1397;
  assign select_1397 = equal_523_s11_q ? {and_1396, xor_1395, parity_1389, parity_1368_s11_q, xor_1323_s11_q, xor_1228_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_521_s11_q ? 6'h0 : select_1397;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1437;
  assign sum_1437 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1440;
  assign sum_1440 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:447
  logic select_2360;
  assign select_2360 = equal_2263_s11_q ? (~({row_s11_q, 1'b0} < {sum_2357, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2565;
  assign and_2565 = and_500_s11_q & (equal_2263_s11_q & (row_s11_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      lower_half_q <= 1'b0;
    end else if (s11_en) begin
      lower_half_q <= and_500_s11_q ? select_2360 : lower_half_q;
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
  logic [3:0] select_461_s12_q;
  logic equal_462_s12_q;
  logic [6:0] select_464_s12_q;
  logic [8:0] select_468_s12_q;
  logic and_474_s12_q;
  logic equal_480_s12_q;
  logic [6:0] column_s12_q;
  logic and_498_s12_q;
  logic and_500_s12_q;
  logic so_s12_q;
  logic equal_520_s12_q;
  logic or_521_s12_q;
  logic less_528_s12_q;
  logic not_529_s12_q;
  logic equal_561_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic select_649_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1150_s12_q;
  logic [5:0] select_1399_s12_q;
  logic [6:0] sum_1438_s12_q;
  logic [6:0] sum_1441_s12_q;
  logic and_1451_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic select_1460_s12_q;
  logic equal_1469_s12_q;
  logic and_1476_s12_q;
  logic and_1479_s12_q;
  logic and_1483_s12_q;
  logic or_1497_s12_q;
  logic [6:0] select_1508_s12_q;
  logic and_1582_s12_q;
  logic equal_1588_s12_q;
  logic less_1609_s12_q;
  logic and_1993_s12_q;
  logic equal_2139_s12_q;
  logic equal_2263_s12_q;
  logic and_2566_s12_q;
  logic and_2568_s12_q;
  logic [3:0] phase_s12_q;
  logic equal_2695_s12_q;
  logic [3:0] select_2698_s12_q;
  logic less_2709_s12_q;
  logic not_2741_s12_q;
  logic less_3552_s12_q;
  logic equal_3757_s12_q;
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
      select_461_s12_q <= select_461_s11_q;
      equal_462_s12_q <= equal_462_s11_q;
      select_464_s12_q <= select_464_s11_q;
      select_468_s12_q <= select_468_s11_q;
      and_474_s12_q <= and_474_s11_q;
      equal_480_s12_q <= equal_480_s11_q;
      column_s12_q <= column_s11_q;
      and_498_s12_q <= and_498_s11_q;
      and_500_s12_q <= and_500_s11_q;
      so_s12_q <= so_s11_q;
      equal_520_s12_q <= equal_520_s11_q;
      or_521_s12_q <= or_521_s11_q;
      less_528_s12_q <= less_528_s11_q;
      not_529_s12_q <= not_529_s11_q;
      equal_561_s12_q <= row_s11_q == 7'h0;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_649_s12_q <= select_649_s11_q;
      column_2_s12_q <= column_2;
      select_1150_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1399_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1438_s12_q <= {1'b0, before_v_2} + sum_1437;
      sum_1441_s12_q <= {1'b0, before_v_3} + sum_1440;
      and_1451_s12_q <= and_1451_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      select_1460_s12_q <= select_1460_s11_q;
      equal_1469_s12_q <= equal_1469_s11_q;
      and_1476_s12_q <= and_1476_s11_q;
      and_1479_s12_q <= and_1479_s11_q;
      and_1483_s12_q <= and_1483_s11_q;
      or_1497_s12_q <= or_1497_s11_q;
      select_1508_s12_q <= select_1508_s11_q;
      and_1582_s12_q <= and_1582_s11_q;
      equal_1588_s12_q <= equal_1588_s11_q;
      less_1609_s12_q <= less_1609_s11_q;
      and_1993_s12_q <= and_1993_s11_q;
      equal_2139_s12_q <= (column_s11_q | row_s11_q) == 7'h0;
      equal_2263_s12_q <= equal_2263_s11_q;
      and_2566_s12_q <= and_2264_s11_q & and_2565;
      and_2568_s12_q <= and_2264_s11_q & (~and_2565);
      phase_s12_q <= phase_s11_q;
      equal_2695_s12_q <= row_s11_q == 7'h3;
      select_2698_s12_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      less_2709_s12_q <= 7'h2 < row_s11_q;
      not_2741_s12_q <= not_2741_s11_q;
      less_3552_s12_q <= 6'h2 < row_s11_q[6:1];
      equal_3757_s12_q <= row_s11_q[6:3] == 4'h0;
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
  logic [5:0] select_901;
  assign select_901 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1433;
  assign sum_1433 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1443;
  assign select_1443 = (sum_1438_s12_q < sum_1441_s12_q) ? sum_1441_s12_q : sum_1438_s12_q;
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2363;
  assign select_2363 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2364;
  assign select_2364 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2365;
  assign select_2365 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2366;
  assign select_2366 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2367;
  assign select_2367 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2368;
  assign select_2368 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/patches.hpp:64
  logic [3:0] select_2699;
  assign select_2699 = equal_2695_s12_q ? select_2698_s12_q : patches_choosing_rows_to_next_q;
  logic equal_2700;
  assign equal_2700 = select_2699 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2703;
  assign select_2703 = equal_2263_s12_q ? (equal_2700 ? 4'h2 : (select_2699 + 4'hf)) : patches_choosing_rows_to_next_q;
  logic select_2711;
  assign select_2711 = equal_2263_s12_q ? (less_2709_s12_q & equal_2700) : patches_chooses_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_chooses_q <= 1'b0;
    end else if (s12_en) begin
      patches_choosing_rows_to_next_q <= and_500_s12_q ? select_2703 : patches_choosing_rows_to_next_q;
      patches_chooses_q <= and_500_s12_q ? select_2711 : patches_chooses_q;
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
      middle_sum_columns_values_1_q <= select_2363;
      middle_sum_columns_values_2_q <= select_2364;
      middle_sum_columns_values_3_q <= select_2365;
      middle_sum_columns_values_4_q <= select_2366;
      middle_sum_columns_values_5_q <= select_2367;
      middle_sum_columns_values_6_q <= select_2368;
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
  logic [3:0] select_461_s13_q;
  logic equal_462_s13_q;
  logic [6:0] select_464_s13_q;
  logic [8:0] select_468_s13_q;
  logic and_474_s13_q;
  logic equal_480_s13_q;
  logic [6:0] column_s13_q;
  logic and_498_s13_q;
  logic and_500_s13_q;
  logic so_s13_q;
  logic equal_520_s13_q;
  logic or_521_s13_q;
  logic less_528_s13_q;
  logic not_529_s13_q;
  logic equal_561_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_649_s13_q;
  logic [6:0] difference_902_s13_q;
  logic [6:0] difference_1151_s13_q;
  logic equal_1152_s13_q;
  logic [6:0] difference_1400_s13_q;
  logic [6:0] sum_1434_s13_q;
  logic [6:0] select_1443_s13_q;
  logic and_1451_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1460_s13_q;
  logic equal_1469_s13_q;
  logic and_1476_s13_q;
  logic and_1479_s13_q;
  logic and_1483_s13_q;
  logic less_1484_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1497_s13_q;
  logic [6:0] select_1508_s13_q;
  logic and_1582_s13_q;
  logic equal_1588_s13_q;
  logic less_1609_s13_q;
  logic and_1993_s13_q;
  logic equal_2139_s13_q;
  logic equal_2263_s13_q;
  logic and_2566_s13_q;
  logic and_2568_s13_q;
  logic and_2575_s13_q;
  logic [3:0] phase_s13_q;
  logic equal_2695_s13_q;
  logic equal_2700_s13_q;
  logic not_2741_s13_q;
  logic less_3552_s13_q;
  logic equal_3757_s13_q;
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
      select_461_s13_q <= select_461_s12_q;
      equal_462_s13_q <= equal_462_s12_q;
      select_464_s13_q <= select_464_s12_q;
      select_468_s13_q <= select_468_s12_q;
      and_474_s13_q <= and_474_s12_q;
      equal_480_s13_q <= equal_480_s12_q;
      column_s13_q <= column_s12_q;
      and_498_s13_q <= and_498_s12_q;
      and_500_s13_q <= and_500_s12_q;
      so_s13_q <= so_s12_q;
      equal_520_s13_q <= equal_520_s12_q;
      or_521_s13_q <= or_521_s12_q;
      less_528_s13_q <= less_528_s12_q;
      not_529_s13_q <= not_529_s12_q;
      equal_561_s13_q <= equal_561_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_649_s13_q <= select_649_s12_q;
      difference_902_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_901};
      difference_1151_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1150_s12_q};
      equal_1152_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1400_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1399_s12_q};
      sum_1434_s13_q <= {1'b0, before_v} + sum_1433;
      select_1443_s13_q <= select_1443;
      and_1451_s13_q <= and_1451_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1460_s13_q <= select_1460_s12_q;
      equal_1469_s13_q <= equal_1469_s12_q;
      and_1476_s13_q <= and_1476_s12_q;
      and_1479_s13_q <= and_1479_s12_q;
      and_1483_s13_q <= and_1483_s12_q;
      less_1484_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1497_s13_q <= or_1497_s12_q;
      select_1508_s13_q <= select_1508_s12_q;
      and_1582_s13_q <= and_1582_s12_q;
      equal_1588_s13_q <= equal_1588_s12_q;
      less_1609_s13_q <= less_1609_s12_q;
      and_1993_s13_q <= and_1993_s12_q;
      equal_2139_s13_q <= equal_2139_s12_q;
      equal_2263_s13_q <= equal_2263_s12_q;
      and_2566_s13_q <= and_2566_s12_q;
      and_2568_s13_q <= and_2568_s12_q;
      and_2575_s13_q <= ends_cell_s12_q & so_s12_q;
      phase_s13_q <= phase_s12_q;
      equal_2695_s13_q <= equal_2695_s12_q;
      equal_2700_s13_q <= equal_2700;
      not_2741_s13_q <= not_2741_s12_q;
      less_3552_s13_q <= less_3552_s12_q;
      equal_3757_s13_q <= equal_3757_s12_q;
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
  logic less_650;
  assign less_650 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_652;
  assign less_652 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:231
  logic and_654;
  assign and_654 = (~less_650) & (~less_652);
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_904;
  assign sum_904 = {difference_902_s13_q[6], difference_902_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1154;
  assign sum_1154 = {difference_1151_s13_q[6], difference_1151_s13_q} + (equal_1152_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1402;
  assign sum_1402 = {difference_1400_s13_q[6], difference_1400_s13_q} + (equal_1152_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1435;
  assign select_1435 = slot_s13_q[0] ? chosen_near_q : sum_1434_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1445;
  assign select_1445 = (select_1435 < select_1443_s13_q) ? select_1443_s13_q : select_1435;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_654 ? select_1445 : 7'h0;
  // hls/stages/agreement.hpp:935
  logic select_1486;
  assign select_1486 = slot_s13_q[2] ? less_1484_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1489;
  assign difference_1489 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/census.hpp:31
  logic not_1586;
  assign not_1586 = ~sample_pair_first_s13_q;
  // hls/stages/patches.hpp:286
  logic equal_1590;
  assign equal_1590 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1658;
  assign select_1658 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1861;
  assign sum_1861 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2374;
  assign select_2374 = slot_s13_q[0] ? 7'h0 : sum_1434_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_2376;
  assign select_2376 = (select_2374 < select_1443_s13_q) ? select_1443_s13_q : select_2374;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2569;
  assign select_2569 = and_2568_s13_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2571;
  assign select_2571 = and_2566_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2569[15]}}, select_2569});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2572;
  assign select_2572 = and_2568_s13_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2572[15]}}, select_2572};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2574;
  assign select_2574 = and_2566_s13_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2575_s13_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:347
  logic and_2677;
  assign and_2677 = not_1586 & equal_1588_s13_q;
  logic [8:0] select_2678;
  assign select_2678 = and_2677 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s13_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2679;
  assign select_2679 = and_2677 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2680;
  assign select_2680 = sample_pair_first_s13_q ? select_2678 : select_2679;
  // hls/stages/patches.hpp:103
  logic [3:0] select_2681;
  assign select_2681 = and_1582_s13_q ? select_2680[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2682;
  assign select_2682 = sample_pair_whole_s13_q ? select_2681 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2684;
  assign select_2684 = sample_pair_whole_s13_q ? (and_1582_s13_q ? select_2680[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2687;
  assign select_2687 = sample_pair_whole_s13_q ? (equal_1590 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2689;
  assign select_2689 = sample_pair_whole_s13_q ? (patches_band_rows_number_q + {4'h0, equal_1590}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:305
  logic equal_2690;
  assign equal_2690 = phase_s13_q == 4'h0;
  // hls/stages/patches.hpp:306
  logic not_2691;
  assign not_2691 = ~equal_2690;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2693;
  assign select_2693 = sample_pair_whole_s13_q ? (phase_s13_q + {{2{not_2691}}, 1'b1, not_2691}) : patches_first_band_rows_to_next_q;
  logic select_2694;
  assign select_2694 = sample_pair_whole_s13_q ? equal_2690 : patches_first_band_number_q;
  // hls/stages/patches.hpp:64
  logic [4:0] select_2705;
  assign select_2705 = equal_2695_s13_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2707;
  assign select_2707 = equal_2263_s13_q ? (select_2705 + {4'h0, equal_2700_s13_q}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2714;
  assign select_2714 = and_500_s13_q ? (equal_2263_s13_q ? select_2705 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3564;
  assign select_3564 = so_s13_q ? (and_2575_s13_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3566;
  assign sum_3566 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3567;
  assign select_3567 = sum_1861[5] ? {1'b1, sum_1861[4:0], region_across_rest_q[2:0]} : sum_3566;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3569;
  assign select_3569 = equal_2263_s13_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3572;
  assign select_3572 = equal_2263_s13_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

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
      chosen_near_q <= select_2376;
      registration_slope_row_q <= select_2571;
      registration_slope_change_q <= select_2574;
      registration_slope_q <= so_s13_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2682;
      patches_band_rows_number_q <= select_2684;
      patches_next_band_rows_to_next_q <= select_2687;
      patches_next_band_number_q <= select_2689;
      patches_first_band_rows_to_next_q <= select_2693;
      patches_first_band_number_q <= select_2694;
      patches_choosing_number_q <= and_500_s13_q ? select_2707 : patches_choosing_number_q;
      patches_choosing_band_q <= select_2714;
      region_across_rest_q <= select_3564;
      region_across_back_q <= so_s13_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3567;
      columns_begin_rest_q <= and_500_s13_q ? select_3569 : columns_begin_rest_q;
      columns_begin_back_q <= and_500_s13_q ? select_3572 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_904;
      sums_0_sum_sums_values_0_q <= sum_1154;
      sums_0_sum_sums_values_1_q <= equal_1152_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1402;
      sums_1_sum_sums_values_1_q <= equal_1152_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [3:0] select_461_s14_q;
  logic equal_462_s14_q;
  logic [6:0] select_464_s14_q;
  logic [8:0] select_468_s14_q;
  logic and_474_s14_q;
  logic equal_480_s14_q;
  logic [6:0] column_s14_q;
  logic and_498_s14_q;
  logic and_500_s14_q;
  logic so_s14_q;
  logic equal_520_s14_q;
  logic or_521_s14_q;
  logic less_528_s14_q;
  logic not_529_s14_q;
  logic equal_561_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_649_s14_q;
  logic and_654_s14_q;
  logic [7:0] sum_904_s14_q;
  logic less_1403_s14_q;
  logic [6:0] of_near_s14_q;
  logic and_1451_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1460_s14_q;
  logic equal_1469_s14_q;
  logic and_1476_s14_q;
  logic and_1479_s14_q;
  logic and_1483_s14_q;
  logic select_1486_s14_q;
  logic [9:0] sum_1490_s14_q;
  logic or_1497_s14_q;
  logic [6:0] select_1508_s14_q;
  logic and_1582_s14_q;
  logic not_1586_s14_q;
  logic or_1592_s14_q;
  logic less_1609_s14_q;
  logic [16:0] select_1658_s14_q;
  logic sum_1861_s14_q;
  logic and_1993_s14_q;
  logic equal_2139_s14_q;
  logic equal_2263_s14_q;
  logic not_2741_s14_q;
  logic less_3552_s14_q;
  logic equal_3757_s14_q;
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
      select_461_s14_q <= select_461_s13_q;
      equal_462_s14_q <= equal_462_s13_q;
      select_464_s14_q <= select_464_s13_q;
      select_468_s14_q <= select_468_s13_q;
      and_474_s14_q <= and_474_s13_q;
      equal_480_s14_q <= equal_480_s13_q;
      column_s14_q <= column_s13_q;
      and_498_s14_q <= and_498_s13_q;
      and_500_s14_q <= and_500_s13_q;
      so_s14_q <= so_s13_q;
      equal_520_s14_q <= equal_520_s13_q;
      or_521_s14_q <= or_521_s13_q;
      less_528_s14_q <= less_528_s13_q;
      not_529_s14_q <= not_529_s13_q;
      equal_561_s14_q <= equal_561_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_649_s14_q <= select_649_s13_q;
      and_654_s14_q <= and_654;
      sum_904_s14_q <= sum_904;
      less_1403_s14_q <= sum_1154 < sum_1402;
      of_near_s14_q <= of_near;
      and_1451_s14_q <= and_1451_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1460_s14_q <= select_1460_s13_q;
      equal_1469_s14_q <= equal_1469_s13_q;
      and_1476_s14_q <= and_1476_s13_q;
      and_1479_s14_q <= and_1479_s13_q;
      and_1483_s14_q <= and_1483_s13_q;
      select_1486_s14_q <= select_1486;
      sum_1490_s14_q <= {difference_1489[8], difference_1489} + 10'h1;
      or_1497_s14_q <= or_1497_s13_q;
      select_1508_s14_q <= select_1508_s13_q;
      and_1582_s14_q <= and_1582_s13_q;
      not_1586_s14_q <= not_1586;
      or_1592_s14_q <= (~equal_1588_s13_q) | (~equal_1590);
      less_1609_s14_q <= less_1609_s13_q;
      select_1658_s14_q <= select_1658;
      sum_1861_s14_q <= sum_1861[5];
      and_1993_s14_q <= and_1993_s13_q;
      equal_2139_s14_q <= equal_2139_s13_q;
      equal_2263_s14_q <= equal_2263_s13_q;
      not_2741_s14_q <= not_2741_s13_q;
      less_3552_s14_q <= less_3552_s13_q;
      equal_3757_s14_q <= equal_3757_s13_q;
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
  logic [7:0] select_905;
  assign select_905 = slot_s14_q[0] ? chosen_score_q : sum_904_s14_q;
  // hls/stages/agreement.hpp:735
  logic [7:0] select_1404;
  assign select_1404 = less_1403_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1405;
  assign less_1405 = select_905 < select_1404;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_654_s14_q ? (less_1405 ? select_1404 : select_905) : 8'h0;
  // hls/stages/agreement.hpp:704
  logic not_1411;
  assign not_1411 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1412;
  assign select_1412 = less_1403_s14_q ? {slot_s14_q[0], not_1411} : 2'h0;
  logic [2:0] select_1414;
  assign select_1414 = less_1405 ? {select_1412, not_1411} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1423;
  assign select_1423 = slot_s14_q[0] ? 8'h0 : sum_904_s14_q;
  // hls/stages/agreement.hpp:788
  logic or_1448;
  assign or_1448 = select_649_s14_q | (best_left_rdata_s14_q[39:33] < of_near_s14_q);
  // hls/stages/agreement.hpp:801
  logic or_1466;
  assign or_1466 = select_1460_s14_q | (best_right_rdata_s14_q[21:15] < of_near_s14_q);
  // hls/stages/agreement.hpp:235
  logic and_1492;
  assign and_1492 = (and_1479_s14_q & select_1486_s14_q) & ({{22{sum_1490_s14_q[9]}}, sum_1490_s14_q} < 32'h3);
  // hls/stages/patches.hpp:366
  logic not_1583;
  assign not_1583 = ~patches_begins_q;
  // hls/stages/patches.hpp:336
  logic and_1587;
  assign and_1587 = patches_capturing_q & not_1586_s14_q;
  // hls/stages/patches.hpp:102
  logic and_1595;
  assign and_1595 = (not_1583 & (patches_work_q == 3'h0)) & (~(and_1587 | or_1592_s14_q));
  // hls/stages/registration.hpp:218
  logic [13:0] select_1660;
  assign select_1660 = ($signed(10'h0) < $signed(select_1658_s14_q[16:7])) ? 14'h7f : select_1658_s14_q[13:0];
  // hls/stages/patches.hpp:474
  logic equal_1690;
  assign equal_1690 = patches_work_q == 3'h4;
  logic equal_1692;
  assign equal_1692 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:143
  logic equal_1694;
  assign equal_1694 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:474
  logic equal_1695;
  assign equal_1695 = patches_work_q == 3'h2;
  logic or_1696;
  assign or_1696 = equal_1694 | equal_1695;
  // hls/stages/patches.hpp:423
  logic not_1697;
  assign not_1697 = ~patches_second_q;
  // hls/stages/patches.hpp:347
  logic [4:0] select_1719;
  assign select_1719 = and_1595 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:103
  logic [4:0] select_1720;
  assign select_1720 = and_1582_s14_q ? select_1719 : patches_row_q;
  // hls/stages/patches.hpp:102
  logic and_1722;
  assign and_1722 = and_1587 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:103
  logic select_1726;
  assign select_1726 = and_1582_s14_q ? (and_1595 | (and_1587 & (~and_1722))) : patches_capturing_q;
  // hls/stages/patches.hpp:143
  logic not_1751;
  assign not_1751 = ~equal_1694;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1765;
  assign select_1765 = and_1582_s14_q ? {select_1719[4], select_1719[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:486
  logic less_1830;
  assign less_1830 = patches_step_q[4:0] < 5'h11;
  logic equal_1831;
  assign equal_1831 = patches_step_q[6:5] == 2'h0;
  logic not_1832;
  assign not_1832 = ~equal_1831;
  logic equal_1833;
  assign equal_1833 = patches_step_q[6:5] == 2'h3;
  logic not_1834;
  assign not_1834 = ~equal_1833;
  // hls/stages/patches.hpp:500
  logic select_1837;
  assign select_1837 = equal_1833 ? (less_1830 & (less_1830 & not_1834)) : less_1830;
  // hls/stages/agreement.hpp:735
  logic less_2372;
  assign less_2372 = select_1423 < select_1404;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2467;
  assign select_2467 = or_521_s14_q ? (less_528_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2469;
  assign select_2469 = or_521_s14_q ? (less_528_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:367
  logic or_2782;
  assign or_2782 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:369
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:163
  logic and_2788;
  assign and_2788 = equal_1690 & not_1697;
  // hls/stages/patches.hpp:373
  logic and_2789;
  assign and_2789 = not_1751 & and_2788;
  logic [1:0] select_2791;
  assign select_2791 = equal_1692 ? 2'h0 : (equal_1695 ? 2'h3 : {equal_1694, and_2789});
  // hls/stages/patches.hpp:253
  logic equal_2793;
  assign equal_2793 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:251
  logic not_2794;
  assign not_2794 = ~equal_2793;
  // hls/stages/patches.hpp:253
  logic equal_2795;
  assign equal_2795 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:249
  logic not_2796;
  assign not_2796 = ~equal_2795;
  // hls/stages/patches.hpp:257
  logic not_2798;
  assign not_2798 = ~(patches_following_q == 3'h2);
  logic and_2801;
  assign and_2801 = (~(patches_following_q == 3'h1)) & not_2798;
  // hls/stages/patches.hpp:371
  logic [1:0] select_2802;
  assign select_2802 = equal_2795 ? 2'h2 : {and_2801, not_2798};
  logic [3:0] select_2803;
  assign select_2803 = equal_2793 ? 4'h2 : {select_2802, {2{not_2796}}};
  // hls/stages/patches.hpp:379
  logic not_2806;
  assign not_2806 = ~or_2782;
  // hls/stages/patches.hpp:368
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:380
  logic [11:0] select_2811;
  assign select_2811 = or_2782 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

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
      chosen_score_q <= less_2372 ? select_1404 : select_1423;
      chosen_place_q <= less_2372 ? {select_1412, not_1411} : 3'h2;
      before_0_q <= select_1423;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      patches_capturing_q <= sample_pair_whole_s14_q ? select_1726 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s14_q ? select_1720 : patches_row_q;
      patches_work_q <= or_2782 ? following : patches_work_q;
      patches_second_q <= not_1583 & (patches_second_q | (patches_ends_q & equal_1690));
      patches_following_q <= equal_1690 ? {2'h0, and_2788} : {equal_1692, select_2791};
      patches_following_beats_q <= {select_2803, not_2794};
      patches_begins_q <= sample_pair_whole_s14_q & (and_1582_s14_q & and_1722);
      patches_ends_q <= not_2806 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2811;
      patches_step_q <= or_2782 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic [3:0] select_461_s15_q;
  logic equal_462_s15_q;
  logic [6:0] select_464_s15_q;
  logic [8:0] select_468_s15_q;
  logic and_474_s15_q;
  logic equal_480_s15_q;
  logic [6:0] column_s15_q;
  logic and_498_s15_q;
  logic and_500_s15_q;
  logic so_s15_q;
  logic equal_520_s15_q;
  logic or_521_s15_q;
  logic less_528_s15_q;
  logic not_529_s15_q;
  logic equal_561_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_649_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1414_s15_q;
  logic [6:0] of_near_s15_q;
  logic or_1448_s15_q;
  logic and_1451_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1460_s15_q;
  logic or_1466_s15_q;
  logic equal_1469_s15_q;
  logic and_1476_s15_q;
  logic and_1480_s15_q;
  logic and_1483_s15_q;
  logic and_1493_s15_q;
  logic and_1498_s15_q;
  logic [8:0] select_1500_s15_q;
  logic [6:0] select_1508_s15_q;
  logic and_1582_s15_q;
  logic and_1595_s15_q;
  logic less_1609_s15_q;
  logic [13:0] select_1660_s15_q;
  logic equal_1690_s15_q;
  logic equal_1692_s15_q;
  logic equal_1694_s15_q;
  logic or_1696_s15_q;
  logic and_1699_s15_q;
  logic [4:0] select_1720_s15_q;
  logic select_1726_s15_q;
  logic and_1732_s15_q;
  logic and_1752_s15_q;
  logic [3:0] select_1765_s15_q;
  logic less_1830_s15_q;
  logic equal_1831_s15_q;
  logic not_1832_s15_q;
  logic equal_1833_s15_q;
  logic not_1834_s15_q;
  logic select_1837_s15_q;
  logic and_1838_s15_q;
  logic sum_1861_s15_q;
  logic and_1993_s15_q;
  logic equal_2139_s15_q;
  logic equal_2263_s15_q;
  logic [7:0] select_2467_s15_q;
  logic [7:0] select_2469_s15_q;
  logic not_2741_s15_q;
  logic or_2782_s15_q;
  logic not_2806_s15_q;
  logic and_3270_s15_q;
  logic equal_3277_s15_q;
  logic less_3552_s15_q;
  logic equal_3757_s15_q;
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
      select_461_s15_q <= select_461_s14_q;
      equal_462_s15_q <= equal_462_s14_q;
      select_464_s15_q <= select_464_s14_q;
      select_468_s15_q <= select_468_s14_q;
      and_474_s15_q <= and_474_s14_q;
      equal_480_s15_q <= equal_480_s14_q;
      column_s15_q <= column_s14_q;
      and_498_s15_q <= and_498_s14_q;
      and_500_s15_q <= and_500_s14_q;
      so_s15_q <= so_s14_q;
      equal_520_s15_q <= equal_520_s14_q;
      or_521_s15_q <= or_521_s14_q;
      less_528_s15_q <= less_528_s14_q;
      not_529_s15_q <= not_529_s14_q;
      equal_561_s15_q <= equal_561_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_649_s15_q <= select_649_s14_q;
      of_best_s15_q <= of_best;
      select_1414_s15_q <= select_1414;
      of_near_s15_q <= of_near_s14_q;
      or_1448_s15_q <= or_1448;
      and_1451_s15_q <= and_1451_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1460_s15_q <= select_1460_s14_q;
      or_1466_s15_q <= or_1466;
      equal_1469_s15_q <= equal_1469_s14_q;
      and_1476_s15_q <= and_1476_s14_q;
      and_1480_s15_q <= not_529_s14_q & and_1479_s14_q;
      and_1483_s15_q <= and_1483_s14_q;
      and_1493_s15_q <= not_529_s14_q & and_1492;
      and_1498_s15_q <= and_1492 & or_1497_s14_q;
      select_1500_s15_q <= less_528_s14_q ? 9'h0 : best_left_rdata_s14_q[8:0];
      select_1508_s15_q <= select_1508_s14_q;
      and_1582_s15_q <= and_1582_s14_q;
      and_1595_s15_q <= and_1595;
      less_1609_s15_q <= less_1609_s14_q;
      select_1660_s15_q <= select_1660;
      equal_1690_s15_q <= equal_1690;
      equal_1692_s15_q <= equal_1692;
      equal_1694_s15_q <= equal_1694;
      or_1696_s15_q <= or_1696;
      and_1699_s15_q <= or_1696 & (equal_1694 & not_1697);
      select_1720_s15_q <= select_1720;
      select_1726_s15_q <= select_1726;
      and_1732_s15_q <= or_1696 & (patches_second_q & equal_1694);
      and_1752_s15_q <= not_1751 & or_1696;
      select_1765_s15_q <= select_1765;
      less_1830_s15_q <= less_1830;
      equal_1831_s15_q <= equal_1831;
      not_1832_s15_q <= not_1832;
      equal_1833_s15_q <= equal_1833;
      not_1834_s15_q <= not_1834;
      select_1837_s15_q <= select_1837;
      and_1838_s15_q <= not_1832 & select_1837;
      sum_1861_s15_q <= sum_1861_s14_q;
      and_1993_s15_q <= and_1993_s14_q;
      equal_2139_s15_q <= equal_2139_s14_q;
      equal_2263_s15_q <= equal_2263_s14_q;
      select_2467_s15_q <= select_2467;
      select_2469_s15_q <= select_2469;
      not_2741_s15_q <= not_2741_s14_q;
      or_2782_s15_q <= or_2782;
      not_2806_s15_q <= not_2806;
      and_3270_s15_q <= less_1830 & (patches_step_q[6:5] == 2'h1);
      equal_3277_s15_q <= patches_step_q[6:5] == 2'h2;
      less_3552_s15_q <= less_3552_s14_q;
      equal_3757_s15_q <= equal_3757_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [15:0] patches_chance_q;
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:785
  logic equal_1417;
  assign equal_1417 = select_1414_s15_q == 3'h1;
  logic equal_1418;
  assign equal_1418 = select_1414_s15_q == 3'h2;
  logic not_1419;
  assign not_1419 = ~equal_1418;
  logic [2:0] select_1420;
  assign select_1420 = equal_1417 ? 3'h2 : {not_1419, {2{equal_1418}}};
  logic [7:0] select_1425;
  assign select_1425 = select_1420[1] ? (select_1420[0] ? before_1_s15_q : before_1_q) : (select_1420[0] ? before_1_q : before_0_q);
  logic [7:0] select_1426;
  assign select_1426 = select_1420[2] ? (select_1420[0] ? before_2_s15_q : before_0_s15_q) : select_1425;
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1428;
  assign select_1428 = equal_1417 ? 2'h0 : {not_1419, equal_1418};
  logic [7:0] select_1430;
  assign select_1430 = select_1428[1] ? before_2_q : (select_1428[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:797
  logic or_1462;
  assign or_1462 = select_1460_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:235
  logic and_1499;
  assign and_1499 = not_529_s15_q & and_1498_s15_q;
  // hls/stages/agreement.hpp:141
  logic [14:0] shift_2;
  assign shift_2 = or_521_s15_q ? {select_1500_s15_q, and_1499, and_1493_s15_q, and_1483_s15_q, and_1480_s15_q, and_1476_s15_q, not_529_s15_q} : 15'h0;
  // hls/stages/patches.hpp:80
  logic right_3;
  assign right_3 = {2'h0, last_s15_q[6:1]} < x_s15_q;
  // hls/stages/registration.hpp:213
  logic [9:0] select_1661;
  assign select_1661 = shift_2[10] ? select_1660_s15_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1666;
  assign sum_1666 = (shift_2[6] ? select_1660_s15_q[13:1] : 13'h0) + (shift_2[7] ? select_1660_s15_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1667;
  assign select_1667 = shift_2[8] ? select_1660_s15_q[11:0] : 12'h0;
  logic [10:0] sum_1669;
  assign sum_1669 = select_1667[11:1] + (shift_2[9] ? select_1660_s15_q[10:0] : 11'h0);
  // hls/stages/patches.hpp:455
  logic not_1691;
  assign not_1691 = ~equal_1690_s15_q;
  // hls/stages/patches.hpp:421
  logic not_1693;
  assign not_1693 = ~equal_1692_s15_q;
  logic and_1775;
  assign and_1775 = not_1691 & (or_1696_s15_q & not_1693);
  // hls/stages/patches.hpp:160
  logic and_1840;
  assign and_1840 = equal_1690_s15_q & (less_1830_s15_q ? and_1838_s15_q : select_1837_s15_q);
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2465;
  assign select_2465 = or_521_s15_q ? (less_528_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2467_s15_q} - {1'b0, select_2469_s15_q};
  // hls/stages/patches.hpp:68
  logic parity_2718;
  assign parity_2718 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2719;
  assign select_2719 = equal_2263_s15_q ? {patches_chance_q[14:0], parity_2718} : patches_chance_q;
  // hls/stages/patches.hpp:85
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:86
  logic [5:0] further;
  assign further = last_s15_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:103
  logic select_2743;
  assign select_2743 = and_1582_s15_q ? (and_1595_s15_q ? not_2741_s15_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:163
  logic [4:0] select_2813;
  assign select_2813 = or_2782_s15_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:497
  logic select_3272;
  assign select_3272 = less_1830_s15_q ? (not_1834_s15_q & and_3270_s15_q) : and_3270_s15_q;
  // hls/stages/patches.hpp:500
  logic select_3273;
  assign select_3273 = equal_1833_s15_q ? select_3272 : and_3270_s15_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:698; read in stage 15, written in stage 28: 15 < 28 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s15_en & (not_1691 & (not_1693 & and_1699_s15_q));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:698; read in stage 15, written in stage 28: 15 < 28 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s15_en & (not_1691 & (not_1693 & and_1732_s15_q));
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:710; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
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
  assign patches_columns_above_re = s15_en & and_1775;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:729; read in stage 15, written in stage 29: 15 < 29 < 15 + DISTANCE.
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
  assign patches_rows_re = s15_en & and_1840;
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
      patches_chance_q <= and_500_s15_q ? select_2719 : patches_chance_q;
      patches_lower_q <= sample_pair_whole_s15_q ? select_2743 : patches_lower_q;
      patches_code_row_q <= select_2813;
      patches_column_q <= or_2782_s15_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2806_s15_q & (patches_column_q == 5'h1e);
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
  logic [3:0] select_461_s16_q;
  logic equal_462_s16_q;
  logic [6:0] select_464_s16_q;
  logic [8:0] select_468_s16_q;
  logic and_474_s16_q;
  logic equal_480_s16_q;
  logic [6:0] column_s16_q;
  logic and_498_s16_q;
  logic and_500_s16_q;
  logic so_s16_q;
  logic equal_561_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1409_s16_q;
  logic [2:0] select_1414_s16_q;
  logic [7:0] select_1426_s16_q;
  logic [7:0] select_1430_s16_q;
  logic [6:0] select_1449_s16_q;
  logic [5:0] select_1450_s16_q;
  logic and_1451_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1462_s16_q;
  logic [6:0] select_1467_s16_q;
  logic [6:0] select_1468_s16_q;
  logic equal_1469_s16_q;
  logic [13:0] shift_2_s16_q;
  logic [6:0] select_1508_s16_q;
  logic and_1511_s16_q;
  logic and_1582_s16_q;
  logic and_1595_s16_q;
  logic right_3_s16_q;
  logic less_1609_s16_q;
  logic select_1661_s16_q;
  logic [8:0] difference_1663_s16_q;
  logic [11:0] sum_1666_s16_q;
  logic select_1667_s16_q;
  logic [10:0] sum_1669_s16_q;
  logic equal_1690_s16_q;
  logic not_1691_s16_q;
  logic equal_1692_s16_q;
  logic not_1693_s16_q;
  logic equal_1694_s16_q;
  logic or_1696_s16_q;
  logic [4:0] select_1720_s16_q;
  logic select_1726_s16_q;
  logic and_1754_s16_q;
  logic [3:0] select_1765_s16_q;
  logic and_1775_s16_q;
  logic less_1830_s16_q;
  logic equal_1831_s16_q;
  logic not_1832_s16_q;
  logic equal_1833_s16_q;
  logic not_1834_s16_q;
  logic sum_1861_s16_q;
  logic textured_s16_q;
  logic and_1993_s16_q;
  logic equal_2139_s16_q;
  logic equal_2263_s16_q;
  logic [7:0] select_2465_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2471_s16_q;
  logic [7:0] xor_2476_s16_q;
  logic less_2500_s16_q;
  logic [5:0] further_s16_q;
  logic or_2782_s16_q;
  logic not_2806_s16_q;
  logic select_3275_s16_q;
  logic equal_3277_s16_q;
  logic less_3552_s16_q;
  logic equal_3757_s16_q;
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
      select_461_s16_q <= select_461_s15_q;
      equal_462_s16_q <= equal_462_s15_q;
      select_464_s16_q <= select_464_s15_q;
      select_468_s16_q <= select_468_s15_q;
      and_474_s16_q <= and_474_s15_q;
      equal_480_s16_q <= equal_480_s15_q;
      column_s16_q <= column_s15_q;
      and_498_s16_q <= and_498_s15_q;
      and_500_s16_q <= and_500_s15_q;
      so_s16_q <= so_s15_q;
      equal_561_s16_q <= equal_561_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1409_s16_q <= select_649_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1414_s16_q <= select_1414_s15_q;
      select_1426_s16_q <= select_1426;
      select_1430_s16_q <= select_1430;
      select_1449_s16_q <= or_1448_s15_q ? of_near_s15_q : best_left_rdata_s15_q[39:33];
      select_1450_s16_q <= or_1448_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      and_1451_s16_q <= and_1451_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1462_s16_q <= or_1462;
      select_1467_s16_q <= or_1466_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1468_s16_q <= or_1466_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1469_s16_q <= equal_1469_s15_q;
      shift_2_s16_q <= {shift_2[14:3], shift_2[1:0]};
      select_1508_s16_q <= select_1508_s15_q;
      and_1511_s16_q <= equal_520_s15_q & shift_2[4];
      and_1582_s16_q <= and_1582_s15_q;
      and_1595_s16_q <= and_1595_s15_q;
      right_3_s16_q <= right_3;
      less_1609_s16_q <= less_1609_s15_q;
      select_1661_s16_q <= select_1661[0];
      difference_1663_s16_q <= select_1661[9:1] - (shift_2[11] ? select_1660_s15_q[8:0] : 9'h0);
      sum_1666_s16_q <= sum_1666[12:1];
      select_1667_s16_q <= select_1667[0];
      sum_1669_s16_q <= sum_1669;
      equal_1690_s16_q <= equal_1690_s15_q;
      not_1691_s16_q <= not_1691;
      equal_1692_s16_q <= equal_1692_s15_q;
      not_1693_s16_q <= not_1693;
      equal_1694_s16_q <= equal_1694_s15_q;
      or_1696_s16_q <= or_1696_s15_q;
      select_1720_s16_q <= select_1720_s15_q;
      select_1726_s16_q <= select_1726_s15_q;
      and_1754_s16_q <= not_1691 & (not_1693 & and_1752_s15_q);
      select_1765_s16_q <= select_1765_s15_q;
      and_1775_s16_q <= and_1775;
      less_1830_s16_q <= less_1830_s15_q;
      equal_1831_s16_q <= equal_1831_s15_q;
      not_1832_s16_q <= not_1832_s15_q;
      equal_1833_s16_q <= equal_1833_s15_q;
      not_1834_s16_q <= not_1834_s15_q;
      sum_1861_s16_q <= sum_1861_s15_q;
      textured_s16_q <= textured;
      and_1993_s16_q <= and_1993_s15_q;
      equal_2139_s16_q <= equal_2139_s15_q;
      equal_2263_s16_q <= equal_2263_s15_q;
      select_2465_s16_q <= select_2465;
      rise_s16_q <= rise[8];
      select_2471_s16_q <= rise[8] ? select_2467_s15_q : select_2469_s15_q;
      xor_2476_s16_q <= rise[7:0] ^ {8{rise[8]}};
      less_2500_s16_q <= select_2467_s15_q < select_2469_s15_q;
      further_s16_q <= further;
      or_2782_s16_q <= or_2782_s15_q;
      not_2806_s16_q <= not_2806_s15_q;
      select_3275_s16_q <= less_1830_s15_q ? (not_1832_s15_q & select_3273) : select_3273;
      equal_3277_s16_q <= equal_3277_s15_q;
      less_3552_s16_q <= less_3552_s15_q;
      equal_3757_s16_q <= equal_3757_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/agreement.hpp:955
  logic not_1470;
  assign not_1470 = ~equal_1469_s16_q;
  // hls/stages/patches.hpp:314
  logic and_1502;
  assign and_1502 = ends_cell_s16_q & shift_2_s16_q[0];
  logic and_1504;
  assign and_1504 = not_1470 & (so_s16_q & and_1502);
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_1554;
  assign sum_1554 = {1'b0, last_s16_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s16_q[0] & ({1'b0, sum_1554, last_s16_q[1]} < x_s16_q);
  // hls/stages/patches.hpp:79
  logic [9:0] sum_1637;
  assign sum_1637 = {2'h0, x_s16_q} + {{4{shift_2_s16_q[10]}}, shift_2_s16_q[10:5]};
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1670;
  assign sum_1670 = sum_1666_s16_q + {sum_1669_s16_q, select_1667_s16_q};
  logic [9:0] sum_1671;
  assign sum_1671 = {difference_1663_s16_q, select_1661_s16_q} + sum_1670[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2472;
  assign difference_2472 = {1'b0, select_2465_s16_q} - {1'b0, select_2471_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2472[8] ? 8'h0 : difference_2472[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2476_s16_q};
  // hls/stages/patches.hpp:87
  logic [5:0] select_2724;
  assign select_2724 = right_3_s16_q ? last_s16_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s16_q} + {1'b0, select_2724};

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1298; read in stage 16, written in stage 17: 16 < 17 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s16_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s16_en & and_1504;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:699; read in stage 16, written in stage 27: 16 < 27 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s16_q, patches_code_row_s16_q[3:0], patches_column_s16_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s16_en & and_1754_s16_q;
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1325; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s16_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s16_en & and_1504;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s16_en) begin
      patches_read_searches_q <= equal_1690_s16_q ? select_3275_s16_q : patches_read_searches_q;
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
  logic [3:0] select_461_s17_q;
  logic equal_462_s17_q;
  logic [6:0] select_464_s17_q;
  logic [8:0] select_468_s17_q;
  logic and_474_s17_q;
  logic equal_480_s17_q;
  logic [6:0] column_s17_q;
  logic and_498_s17_q;
  logic and_500_s17_q;
  logic so_s17_q;
  logic equal_561_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1410_s17_q;
  logic [2:0] select_1415_s17_q;
  logic [7:0] select_1416_s17_q;
  logic [7:0] select_1427_s17_q;
  logic [7:0] select_1431_s17_q;
  logic [6:0] select_1449_s17_q;
  logic [5:0] select_1450_s17_q;
  logic and_1451_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1463_s17_q;
  logic [6:0] select_1464_s17_q;
  logic [6:0] select_1467_s17_q;
  logic [6:0] select_1468_s17_q;
  logic equal_1469_s17_q;
  logic not_1470_s17_q;
  logic [13:0] shift_2_s17_q;
  logic and_1504_s17_q;
  logic [6:0] select_1508_s17_q;
  logic and_1513_s17_q;
  logic right_2_s17_q;
  logic and_1582_s17_q;
  logic and_1595_s17_q;
  logic right_3_s17_q;
  logic less_1609_s17_q;
  logic less_1628_s17_q;
  logic not_1633_s17_q;
  logic less_1638_s17_q;
  logic less_1639_s17_q;
  logic [7:0] sum_1671_s17_q;
  logic equal_1683_s17_q;
  logic equal_1690_s17_q;
  logic not_1691_s17_q;
  logic equal_1692_s17_q;
  logic not_1693_s17_q;
  logic equal_1694_s17_q;
  logic or_1696_s17_q;
  logic [7:0] patches_right_0_rdata_s17_q;
  logic [4:0] select_1720_s17_q;
  logic select_1726_s17_q;
  logic [7:0] patches_right_1_rdata_s17_q;
  logic [3:0] select_1765_s17_q;
  logic and_1775_s17_q;
  logic [31:0] patches_columns_above_rdata_s17_q;
  logic less_1830_s17_q;
  logic equal_1831_s17_q;
  logic not_1832_s17_q;
  logic equal_1833_s17_q;
  logic not_1834_s17_q;
  logic [14:0] patches_rows_rdata_s17_q;
  logic sum_1861_s17_q;
  logic textured_s17_q;
  logic and_1996_s17_q;
  logic equal_2139_s17_q;
  logic equal_2263_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] size_3_s17_q;
  logic less_2500_s17_q;
  logic not_2727_s17_q;
  logic or_2782_s17_q;
  logic not_2806_s17_q;
  logic equal_3277_s17_q;
  logic less_3552_s17_q;
  logic equal_3757_s17_q;
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
      select_461_s17_q <= select_461_s16_q;
      equal_462_s17_q <= equal_462_s16_q;
      select_464_s17_q <= select_464_s16_q;
      select_468_s17_q <= select_468_s16_q;
      and_474_s17_q <= and_474_s16_q;
      equal_480_s17_q <= equal_480_s16_q;
      column_s17_q <= column_s16_q;
      and_498_s17_q <= and_498_s16_q;
      and_500_s17_q <= and_500_s16_q;
      so_s17_q <= so_s16_q;
      equal_561_s17_q <= equal_561_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1410_s17_q <= or_1409_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1415_s17_q <= or_1409_s16_q ? select_1414_s16_q : best_left_rdata_s16_q[8:6];
      select_1416_s17_q <= or_1409_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1427_s17_q <= or_1409_s16_q ? select_1426_s16_q : best_left_rdata_s16_q[24:17];
      select_1431_s17_q <= or_1409_s16_q ? select_1430_s16_q : best_left_rdata_s16_q[32:25];
      select_1449_s17_q <= select_1449_s16_q;
      select_1450_s17_q <= select_1450_s16_q;
      and_1451_s17_q <= and_1451_s16_q;
      right_s17_q <= right_s16_q;
      select_1463_s17_q <= or_1462_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1464_s17_q <= or_1462_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1467_s17_q <= select_1467_s16_q;
      select_1468_s17_q <= select_1468_s16_q;
      equal_1469_s17_q <= equal_1469_s16_q;
      not_1470_s17_q <= not_1470;
      shift_2_s17_q <= shift_2_s16_q;
      and_1504_s17_q <= and_1504;
      select_1508_s17_q <= select_1508_s16_q;
      and_1513_s17_q <= not_1470 & (so_s16_q ? and_1502 : and_1511_s16_q);
      right_2_s17_q <= right_2;
      and_1582_s17_q <= and_1582_s16_q;
      and_1595_s17_q <= and_1595_s16_q;
      right_3_s17_q <= right_3_s16_q;
      less_1609_s17_q <= less_1609_s16_q;
      less_1628_s17_q <= {3'h0, last_s16_q[6:1]} < ({1'b0, x_s16_q} + 9'h1);
      not_1633_s17_q <= ~(x_s16_q < {1'b0, last_s16_q});
      less_1638_s17_q <= $signed(10'h0) < $signed(sum_1637);
      less_1639_s17_q <= $signed(sum_1637) < $signed({3'h0, last_s16_q});
      sum_1671_s17_q <= sum_1671[9:2];
      equal_1683_s17_q <= x_s16_q == {1'b0, last_s16_q};
      equal_1690_s17_q <= equal_1690_s16_q;
      not_1691_s17_q <= not_1691_s16_q;
      equal_1692_s17_q <= equal_1692_s16_q;
      not_1693_s17_q <= not_1693_s16_q;
      equal_1694_s17_q <= equal_1694_s16_q;
      or_1696_s17_q <= or_1696_s16_q;
      patches_right_0_rdata_s17_q <= patches_right_0_rdata_q;
      select_1720_s17_q <= select_1720_s16_q;
      select_1726_s17_q <= select_1726_s16_q;
      patches_right_1_rdata_s17_q <= patches_right_1_rdata_q;
      select_1765_s17_q <= select_1765_s16_q;
      and_1775_s17_q <= and_1775_s16_q;
      patches_columns_above_rdata_s17_q <= patches_columns_above_rdata_q;
      less_1830_s17_q <= less_1830_s16_q;
      equal_1831_s17_q <= equal_1831_s16_q;
      not_1832_s17_q <= not_1832_s16_q;
      equal_1833_s17_q <= equal_1833_s16_q;
      not_1834_s17_q <= not_1834_s16_q;
      patches_rows_rdata_s17_q <= patches_rows_rdata_q;
      sum_1861_s17_q <= sum_1861_s16_q;
      textured_s17_q <= textured_s16_q;
      and_1996_s17_q <= and_1993_s16_q & (~({sum_1554, last_s16_q[1:0]} < x_s16_q));
      equal_2139_s17_q <= equal_2139_s16_q;
      equal_2263_s17_q <= equal_2263_s16_q;
      wide_s17_q <= wide;
      size_3_s17_q <= size_3;
      less_2500_s17_q <= less_2500_s16_q;
      not_2727_s17_q <= ~(x_s16_q < {1'b0, from});
      or_2782_s17_q <= or_2782_s16_q;
      not_2806_s17_q <= not_2806_s16_q;
      equal_3277_s17_q <= equal_3277_s16_q;
      less_3552_s17_q <= less_3552_s16_q;
      equal_3757_s17_q <= equal_3757_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:119
  logic and_475;
  assign and_475 = sample_pair_whole_s17_q & and_474_s17_q;
  // hls/stages/agreement.hpp:193
  logic not_1509;
  assign not_1509 = ~so_s17_q;
  // hls/stages/patches.hpp:314
  logic and_1510;
  assign and_1510 = not_1509 & shift_2_s17_q[4];
  logic and_1607;
  assign and_1607 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & right_3_s17_q));
  // hls/stages/patches.hpp:81
  logic and_1630;
  assign and_1630 = less_1628_s17_q & (~right_3_s17_q);
  // hls/stages/patches.hpp:83
  logic equal_1631;
  assign equal_1631 = x_s17_q == 8'h0;
  // hls/stages/agreement.hpp:964
  logic and_1641;
  assign and_1641 = (~(and_1630 | (equal_1631 | not_1633_s17_q))) & (less_1638_s17_q & less_1639_s17_q);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1672;
  assign sum_1672 = {registration_slope_s17_q[11], registration_slope_s17_q} + {{5{sum_1671_s17_q[7]}}, sum_1671_s17_q};
  // hls/stages/patches.hpp:314
  logic and_1686;
  assign and_1686 = ends_cell_s17_q & (shift_2_s17_q[0] & (and_1630 | equal_1683_s17_q));
  logic and_1688;
  assign and_1688 = not_1470_s17_q & (so_s17_q & and_1686);
  // hls/stages/patches.hpp:148
  logic [7:0] pixel;
  assign pixel = equal_1694_s17_q ? (patches_second_s17_q ? 8'h0 : patches_right_0_rdata_s17_q) : 8'h0;
  // hls/stages/patches.hpp:430
  logic [8:0] sum_1797;
  assign sum_1797 = {1'b0, patches_columns_above_rdata_s17_q[23:16]} + {3'h0, patches_columns_above_rdata_s17_q[31:26]};
  // hls/stages/agreement.hpp:1000
  logic or_1863;
  assign or_1863 = (~sum_1861_s17_q) | equal_1683_s17_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2479;
  assign select_2479 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2479;
  // hls/stages/patches.hpp:314
  logic and_2730;
  assign and_2730 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & not_2727_s17_q));
  // hls/stages/patches.hpp:496
  logic [9:0] select_3240;
  assign select_3240 = less_1830_s17_q ? patches_rows_rdata_s17_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:497
  logic [9:0] select_3242;
  assign select_3242 = less_1830_s17_q ? (equal_1833_s17_q ? 10'h0 : select_3240) : 10'h0;
  // hls/stages/patches.hpp:496
  logic [4:0] select_3247;
  assign select_3247 = less_1830_s17_q ? patches_rows_rdata_s17_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:500
  logic [4:0] select_3250;
  assign select_3250 = equal_1833_s17_q ? (less_1830_s17_q ? (equal_1833_s17_q ? 5'h0 : select_3247) : 5'h0) : select_3247;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 17, written in stage 20: 17 < 20 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_468_s17_q;
  logic averager_memory_re;
  assign averager_memory_re = s17_en & and_475;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1451_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1450_s17_q, select_1449_s17_q, select_1431_s17_q, select_1427_s17_q, select_1416_s17_q, select_1415_s17_q, select_1410_s17_q};
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
  assign best_right_we = s17_en & and_1451_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1468_s17_q, select_1467_s17_q, select_1464_s17_q, select_1463_s17_q};
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
  assign shown_right_waddr = select_1508_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1513_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1510, not_1509};
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
  logic [3:0] select_461_s18_q;
  logic equal_462_s18_q;
  logic [6:0] select_464_s18_q;
  logic [8:0] select_468_s18_q;
  logic and_474_s18_q;
  logic and_475_s18_q;
  logic equal_480_s18_q;
  logic [6:0] column_s18_q;
  logic and_498_s18_q;
  logic and_500_s18_q;
  logic so_s18_q;
  logic equal_561_s18_q;
  logic equal_1469_s18_q;
  logic not_1470_s18_q;
  logic [13:0] shift_2_s18_q;
  logic and_1504_s18_q;
  logic [1:0] shown_right_rdata_s18_q;
  logic not_1509_s18_q;
  logic right_2_s18_q;
  logic and_1582_s18_q;
  logic and_1595_s18_q;
  logic and_1608_s18_q;
  logic less_1609_s18_q;
  logic equal_1631_s18_q;
  logic and_1641_s18_q;
  logic [7:0] sum_1672_s18_q;
  logic less_1673_s18_q;
  logic less_1674_s18_q;
  logic and_1688_s18_q;
  logic and_1689_s18_q;
  logic equal_1690_s18_q;
  logic not_1691_s18_q;
  logic equal_1692_s18_q;
  logic not_1693_s18_q;
  logic equal_1694_s18_q;
  logic or_1696_s18_q;
  logic [4:0] select_1720_s18_q;
  logic select_1726_s18_q;
  logic [7:0] patches_left_rdata_s18_q;
  logic [3:0] select_1765_s18_q;
  logic and_1775_s18_q;
  logic [31:0] patches_columns_above_rdata_s18_q;
  logic [7:0] select_1779_s18_q;
  logic [8:0] sum_1797_s18_q;
  logic less_1830_s18_q;
  logic equal_1831_s18_q;
  logic not_1832_s18_q;
  logic equal_1833_s18_q;
  logic not_1834_s18_q;
  logic [9:0] patches_rows_rdata_s18_q;
  logic sum_1861_s18_q;
  logic and_1866_s18_q;
  logic textured_s18_q;
  logic [17:0] seen_columns_rdata_s18_q;
  logic and_1999_s18_q;
  logic equal_2139_s18_q;
  logic equal_2263_s18_q;
  logic less_2463_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2481_s18_q;
  logic less_2500_s18_q;
  logic and_2731_s18_q;
  logic or_2782_s18_q;
  logic not_2806_s18_q;
  logic [9:0] select_3243_s18_q;
  logic [4:0] select_3250_s18_q;
  logic equal_3277_s18_q;
  logic less_3552_s18_q;
  logic select_3595_s18_q;
  logic equal_3757_s18_q;
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
      select_461_s18_q <= select_461_s17_q;
      equal_462_s18_q <= equal_462_s17_q;
      select_464_s18_q <= select_464_s17_q;
      select_468_s18_q <= select_468_s17_q;
      and_474_s18_q <= and_474_s17_q;
      and_475_s18_q <= and_475;
      equal_480_s18_q <= equal_480_s17_q;
      column_s18_q <= column_s17_q;
      and_498_s18_q <= and_498_s17_q;
      and_500_s18_q <= and_500_s17_q;
      so_s18_q <= so_s17_q;
      equal_561_s18_q <= equal_561_s17_q;
      equal_1469_s18_q <= equal_1469_s17_q;
      not_1470_s18_q <= not_1470_s17_q;
      shift_2_s18_q <= shift_2_s17_q;
      and_1504_s18_q <= and_1504_s17_q;
      shown_right_rdata_s18_q <= shown_right_rdata_q;
      not_1509_s18_q <= not_1509;
      right_2_s18_q <= right_2_s17_q;
      and_1582_s18_q <= and_1582_s17_q;
      and_1595_s18_q <= and_1595_s17_q;
      and_1608_s18_q <= not_1470_s17_q & and_1607;
      less_1609_s18_q <= less_1609_s17_q;
      equal_1631_s18_q <= equal_1631;
      and_1641_s18_q <= and_1641;
      sum_1672_s18_q <= sum_1672[7:0];
      less_1673_s18_q <= $signed(6'h0) < $signed(sum_1672[12:7]);
      less_1674_s18_q <= $signed(sum_1672[12:7]) < $signed(6'h3f);
      and_1688_s18_q <= and_1688;
      and_1689_s18_q <= patches_chooses_s17_q & and_1688;
      equal_1690_s18_q <= equal_1690_s17_q;
      not_1691_s18_q <= not_1691_s17_q;
      equal_1692_s18_q <= equal_1692_s17_q;
      not_1693_s18_q <= not_1693_s17_q;
      equal_1694_s18_q <= equal_1694_s17_q;
      or_1696_s18_q <= or_1696_s17_q;
      select_1720_s18_q <= select_1720_s17_q;
      select_1726_s18_q <= select_1726_s17_q;
      patches_left_rdata_s18_q <= patches_left_rdata_q;
      select_1765_s18_q <= select_1765_s17_q;
      and_1775_s18_q <= and_1775_s17_q;
      patches_columns_above_rdata_s18_q <= patches_columns_above_rdata_s17_q;
      select_1779_s18_q <= patches_second_s17_q ? patches_right_1_rdata_s17_q : pixel;
      sum_1797_s18_q <= sum_1797;
      less_1830_s18_q <= less_1830_s17_q;
      equal_1831_s18_q <= equal_1831_s17_q;
      not_1832_s18_q <= not_1832_s17_q;
      equal_1833_s18_q <= equal_1833_s17_q;
      not_1834_s18_q <= not_1834_s17_q;
      patches_rows_rdata_s18_q <= patches_rows_rdata_s17_q[9:0];
      sum_1861_s18_q <= sum_1861_s17_q;
      and_1866_s18_q <= so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & or_1863));
      textured_s18_q <= textured_s17_q;
      seen_columns_rdata_s18_q <= seen_columns_rdata_q;
      and_1999_s18_q <= not_1470_s17_q & (so_s17_q & (ends_cell_s17_q & and_1996_s17_q));
      equal_2139_s18_q <= equal_2139_s17_q;
      equal_2263_s18_q <= equal_2263_s17_q;
      less_2463_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2481_s18_q <= ~wide_s17_q;
      less_2500_s18_q <= less_2500_s17_q;
      and_2731_s18_q <= not_1470_s17_q & and_2730;
      or_2782_s18_q <= or_2782_s17_q;
      not_2806_s18_q <= not_2806_s17_q;
      select_3243_s18_q <= equal_1833_s17_q ? select_3242 : select_3240;
      select_3250_s18_q <= select_3250;
      equal_3277_s18_q <= equal_3277_s17_q;
      less_3552_s18_q <= less_3552_s17_q;
      select_3595_s18_q <= sum_1861_s17_q ? (equal_1683_s17_q & or_1863) : or_1863;
      equal_3757_s18_q <= equal_3757_s17_q;
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
  logic [13:0] select_478;
  assign select_478 = equal_462_s18_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_484;
  assign sum_484 = {6'h0, sample_pair_pixel_1_q} + (equal_462_s18_q ? 14'h0 : averager_running_1_q);
  // hls/stages/registration.hpp:83
  logic equal_1610;
  assign equal_1610 = slot_s18_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1611;
  assign select_1611 = shift_2_s18_q[5] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1612;
  assign select_1612 = shift_2_s18_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1613;
  assign sum_1613 = {{2{select_1611[6]}}, select_1611} + {select_1612[7], select_1612};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1614;
  assign select_1614 = shift_2_s18_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1615;
  assign select_1615 = shift_2_s18_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1616;
  assign sum_1616 = {{2{select_1614[7]}}, select_1614[7:1]} + {select_1615[7], select_1615};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1618;
  assign select_1618 = shift_2_s18_q[9] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1619;
  assign select_1619 = shift_2_s18_q[10] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1620;
  assign difference_1620 = {{2{select_1618[7]}}, select_1618[7:1]} - {select_1619[7], select_1619};
  // hls/stages/patches.hpp:314
  logic [5:0] select_1654;
  assign select_1654 = ends_cell_s18_q ? (shift_2_s18_q[0] ? shift_2_s18_q[10:5] : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1676;
  assign select_1676 = less_1673_s18_q ? 8'h7f : (less_1674_s18_q ? 8'h80 : sum_1672_s18_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1610 ? registration_slope_here_q : select_1676;
  // hls/stages/patches.hpp:314
  logic [7:0] select_1680;
  assign select_1680 = so_s18_q ? (ends_cell_s18_q ? (shift_2_s18_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:148
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1694_s18_q ? select_1779_s18_q : patches_left_rdata_s18_q;
  // hls/stages/patches.hpp:430
  logic [9:0] sum_1798;
  assign sum_1798 = {2'h0, patches_columns_above_rdata_s18_q[15:8]} + {1'b0, sum_1797_s18_q};
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1848;
  assign select_1848 = so_s18_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_1851;
  assign or_1851 = select_1848[7] | (~({select_1848[5], select_1848[3], select_1848[1]} == 3'h0));
  // hls/stages/agreement.hpp:250
  logic and_1880;
  assign and_1880 = shift_2_s18_q[0] & ({shift_2_s18_q[4], shift_2_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:960
  logic select_1888;
  assign select_1888 = slot_s18_q[2] ? shown_shown_q : shift_2_s18_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1888);
  // hls/stages/agreement.hpp:960
  logic select_1891;
  assign select_1891 = slot_s18_q[2] ? shown_nearer_q : shift_2_s18_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s18_q[0] & (select_1888 ? select_1891 : shown_right_rdata_s18_q[1]);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_1940;
  assign select_1940 = shift_2_s18_q[0] ? (sum_1861_s18_q ? select_1848 : {select_1848[6:0], 1'b0}) : select_1848;
  // hls/stages/agreement.hpp:992
  logic or_1943;
  assign or_1943 = select_1940[7] | (~({select_1940[5], select_1940[3], select_1940[1]} == 3'h0));
  // hls/stages/registration.hpp:37
  logic not_2474;
  assign not_2474 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2463_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2474};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2482;
  assign select_2482 = registration_displacement_over_q[9] ? wide_s18_q : not_2481_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2463_s18_q ? {taken_s18_q, 1'b1} : {not_2474, select_2482, not_2474};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2484;
  assign sum_2484 = {left, 1'b1} + {taken_2, less_2463_s18_q};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2486;
  assign select_2486 = so_s18_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/patches.hpp:314
  logic [7:0] select_2488;
  assign select_2488 = equal_1469_s18_q ? registration_slope_here_q : (so_s18_q ? slope : registration_slope_here_q);
  // hls/stages/patches.hpp:500
  logic [9:0] select_3245;
  assign select_3245 = less_1830_s18_q ? (equal_1831_s18_q ? 10'h0 : select_3243_s18_q) : select_3243_s18_q;
  logic [4:0] select_3252;
  assign select_3252 = less_1830_s18_q ? (equal_1831_s18_q ? 5'h0 : select_3250_s18_q) : select_3250_s18_q;
  // hls/stages/patches.hpp:496
  logic and_3262;
  assign and_3262 = less_1830_s18_q & (patches_step_s18_q == 5'h0);
  // hls/stages/patches.hpp:500
  logic select_3265;
  assign select_3265 = equal_1833_s18_q ? (less_1830_s18_q ? (not_1834_s18_q & and_3262) : and_3262) : and_3262;
  // hls/stages/patches.hpp:314
  logic select_3549;
  assign select_3549 = equal_1469_s18_q ? shown_shown_q : (so_s18_q ? select_1888 : shown_shown_q);
  logic select_3551;
  assign select_3551 = equal_1469_s18_q ? shown_nearer_q : (so_s18_q ? select_1891 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3553;
  assign sum_3553 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/patches.hpp:314
  logic [7:0] select_3562;
  assign select_3562 = equal_1469_s18_q ? select_1848 : (so_s18_q ? (ends_cell_s18_q ? select_1940 : select_1848) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3576;
  assign select_3576 = equal_561_s18_q ? {difference_3574[7], difference_3574} : (less_3552_s18_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3578;
  assign select_3578 = and_500_s18_q ? (equal_2263_s18_q ? select_3576 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3580;
  assign select_3580 = equal_561_s18_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_3582;
  assign select_3582 = and_500_s18_q ? (equal_2263_s18_q ? select_3580 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3584;
  assign select_3584 = sum_3553[7] ? {1'b1, sum_3553[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});
  // hls/stages/agreement.hpp:197
  logic or_3593;
  assign or_3593 = segment_starts_q | not_1509_s18_q;
  // hls/stages/patches.hpp:314
  logic select_3597;
  assign select_3597 = ends_cell_s18_q ? (shift_2_s18_q[0] ? select_3595_s18_q : or_3593) : or_3593;

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
      registration_displacement_over_q <= so_s18_q ? sum_2484[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2486;
      registration_slope_here_q <= select_2488;
      patches_read_row_differing_q <= equal_1690_s18_q ? select_3245 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1690_s18_q ? select_3252 : patches_read_row_column_q;
      shown_shown_q <= select_3549;
      shown_nearer_q <= select_3551;
      region_columns_q <= select_3562;
      region_down_rest_q <= select_3578;
      region_down_back_q <= select_3582;
      region_down_next_q <= select_3584;
      segment_starts_q <= equal_1469_s18_q ? or_3593 : (so_s18_q ? select_3597 : or_3593);
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
      averager_running_0_q <= sample_pair_whole_s18_q ? select_478 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s18_q ? sum_484 : averager_running_1_q;
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
  logic [3:0] select_461_s19_q;
  logic equal_462_s19_q;
  logic [6:0] select_464_s19_q;
  logic [8:0] select_468_s19_q;
  logic and_474_s19_q;
  logic and_475_s19_q;
  logic [29:0] averager_memory_rdata_s19_q;
  logic [13:0] select_478_s19_q;
  logic equal_480_s19_q;
  logic [13:0] sum_484_s19_q;
  logic [6:0] column_s19_q;
  logic and_498_s19_q;
  logic and_500_s19_q;
  logic so_s19_q;
  logic equal_561_s19_q;
  logic equal_1469_s19_q;
  logic not_1470_s19_q;
  logic [4:0] shift_2_s19_q;
  logic and_1504_s19_q;
  logic equal_1514_s19_q;
  logic right_2_s19_q;
  logic and_1582_s19_q;
  logic and_1595_s19_q;
  logic and_1608_s19_q;
  logic less_1609_s19_q;
  logic equal_1610_s19_q;
  logic [7:0] sum_1613_s19_q;
  logic select_1614_s19_q;
  logic [8:0] sum_1616_s19_q;
  logic select_1618_s19_q;
  logic [8:0] difference_1620_s19_q;
  logic equal_1631_s19_q;
  logic and_1641_s19_q;
  logic [5:0] select_1656_s19_q;
  logic [7:0] select_1681_s19_q;
  logic and_1688_s19_q;
  logic and_1689_s19_q;
  logic equal_1690_s19_q;
  logic not_1691_s19_q;
  logic equal_1692_s19_q;
  logic not_1693_s19_q;
  logic equal_1694_s19_q;
  logic or_1696_s19_q;
  logic [4:0] select_1720_s19_q;
  logic select_1726_s19_q;
  logic [3:0] select_1765_s19_q;
  logic and_1775_s19_q;
  logic [31:0] patches_columns_above_rdata_s19_q;
  logic [7:0] pixel_2_s19_q;
  logic [9:0] sum_1798_s19_q;
  logic less_1830_s19_q;
  logic equal_1831_s19_q;
  logic not_1832_s19_q;
  logic equal_1833_s19_q;
  logic not_1834_s19_q;
  logic [9:0] patches_rows_rdata_s19_q;
  logic or_1851_s19_q;
  logic or_1854_s19_q;
  logic or_1857_s19_q;
  logic and_1866_s19_q;
  logic textured_s19_q;
  logic and_1880_s19_q;
  logic [12:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_1926_s19_q;
  logic and_1928_s19_q;
  logic or_1943_s19_q;
  logic or_1946_s19_q;
  logic or_1949_s19_q;
  logic and_1960_s19_q;
  logic and_1962_s19_q;
  logic and_1963_s19_q;
  logic and_1976_s19_q;
  logic and_1978_s19_q;
  logic and_1979_s19_q;
  logic and_1999_s19_q;
  logic equal_2139_s19_q;
  logic equal_2263_s19_q;
  logic and_2403_s19_q;
  logic and_2405_s19_q;
  logic and_2406_s19_q;
  logic or_2498_s19_q;
  logic [1:0] sum_2499_s19_q;
  logic less_2500_s19_q;
  logic and_2731_s19_q;
  logic or_2782_s19_q;
  logic not_2806_s19_q;
  logic select_3265_s19_q;
  logic equal_3277_s19_q;
  logic less_3552_s19_q;
  logic sum_3553_s19_q;
  logic and_3747_s19_q;
  logic equal_3757_s19_q;
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
      select_461_s19_q <= select_461_s18_q;
      equal_462_s19_q <= equal_462_s18_q;
      select_464_s19_q <= select_464_s18_q;
      select_468_s19_q <= select_468_s18_q;
      and_474_s19_q <= and_474_s18_q;
      and_475_s19_q <= and_475_s18_q;
      averager_memory_rdata_s19_q <= averager_memory_rdata_q;
      select_478_s19_q <= select_478;
      equal_480_s19_q <= equal_480_s18_q;
      sum_484_s19_q <= sum_484;
      column_s19_q <= column_s18_q;
      and_498_s19_q <= and_498_s18_q;
      and_500_s19_q <= and_500_s18_q;
      so_s19_q <= so_s18_q;
      equal_561_s19_q <= equal_561_s18_q;
      equal_1469_s19_q <= equal_1469_s18_q;
      not_1470_s19_q <= not_1470_s18_q;
      shift_2_s19_q <= {shift_2_s18_q[11], shift_2_s18_q[3:0]};
      and_1504_s19_q <= and_1504_s18_q;
      equal_1514_s19_q <= x_s18_q[6:4] == 3'h7;
      right_2_s19_q <= right_2_s18_q;
      and_1582_s19_q <= and_1582_s18_q;
      and_1595_s19_q <= and_1595_s18_q;
      and_1608_s19_q <= and_1608_s18_q;
      less_1609_s19_q <= less_1609_s18_q;
      equal_1610_s19_q <= equal_1610;
      sum_1613_s19_q <= sum_1613[8:1];
      select_1614_s19_q <= select_1614[0];
      sum_1616_s19_q <= sum_1616;
      select_1618_s19_q <= select_1618[0];
      difference_1620_s19_q <= difference_1620;
      equal_1631_s19_q <= equal_1631_s18_q;
      and_1641_s19_q <= and_1641_s18_q;
      select_1656_s19_q <= equal_1469_s18_q ? 6'h0 : (so_s18_q ? select_1654 : 6'h0);
      select_1681_s19_q <= equal_1469_s18_q ? 8'h0 : select_1680;
      and_1688_s19_q <= and_1688_s18_q;
      and_1689_s19_q <= and_1689_s18_q;
      equal_1690_s19_q <= equal_1690_s18_q;
      not_1691_s19_q <= not_1691_s18_q;
      equal_1692_s19_q <= equal_1692_s18_q;
      not_1693_s19_q <= not_1693_s18_q;
      equal_1694_s19_q <= equal_1694_s18_q;
      or_1696_s19_q <= or_1696_s18_q;
      select_1720_s19_q <= select_1720_s18_q;
      select_1726_s19_q <= select_1726_s18_q;
      select_1765_s19_q <= select_1765_s18_q;
      and_1775_s19_q <= and_1775_s18_q;
      patches_columns_above_rdata_s19_q <= patches_columns_above_rdata_s18_q;
      pixel_2_s19_q <= pixel_2;
      sum_1798_s19_q <= sum_1798;
      less_1830_s19_q <= less_1830_s18_q;
      equal_1831_s19_q <= equal_1831_s18_q;
      not_1832_s19_q <= not_1832_s18_q;
      equal_1833_s19_q <= equal_1833_s18_q;
      not_1834_s19_q <= not_1834_s18_q;
      patches_rows_rdata_s19_q <= patches_rows_rdata_s18_q;
      or_1851_s19_q <= or_1851;
      or_1854_s19_q <= select_1848[7] | (~({select_1848[6], select_1848[3:2]} == 3'h0));
      or_1857_s19_q <= select_1848[7] | (~(select_1848[6:4] == 3'h0));
      and_1866_s19_q <= and_1866_s18_q;
      textured_s19_q <= textured_s18_q;
      and_1880_s19_q <= and_1880;
      seen_columns_rdata_s19_q <= {seen_columns_rdata_s18_q[13:7], seen_columns_rdata_s18_q[5:0]};
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_1926_s19_q <= seen_columns_rdata_s18_q[14] & shift_2_s18_q[0];
      and_1928_s19_q <= seen_columns_rdata_s18_q[5] & shift_2_s18_q[0];
      or_1943_s19_q <= or_1943;
      or_1946_s19_q <= select_1940[7] | (~({select_1940[6], select_1940[3:2]} == 3'h0));
      or_1949_s19_q <= select_1940[7] | (~(select_1940[6:4] == 3'h0));
      and_1960_s19_q <= seen_columns_rdata_s18_q[16] & shift_2_s18_q[0];
      and_1962_s19_q <= seen_columns_rdata_s18_q[8] & shift_2_s18_q[0];
      and_1963_s19_q <= seen_columns_rdata_s18_q[3] & shift_2_s18_q[0];
      and_1976_s19_q <= seen_columns_rdata_s18_q[17] & shift_2_s18_q[0];
      and_1978_s19_q <= seen_columns_rdata_s18_q[9] & shift_2_s18_q[0];
      and_1979_s19_q <= seen_columns_rdata_s18_q[4] & shift_2_s18_q[0];
      and_1999_s19_q <= and_1999_s18_q;
      equal_2139_s19_q <= equal_2139_s18_q;
      equal_2263_s19_q <= equal_2263_s18_q;
      and_2403_s19_q <= seen_columns_rdata_s18_q[15] & shift_2_s18_q[0];
      and_2405_s19_q <= seen_columns_rdata_s18_q[7] & shift_2_s18_q[0];
      and_2406_s19_q <= seen_columns_rdata_s18_q[2] & shift_2_s18_q[0];
      or_2498_s19_q <= (shift_2_s18_q[13:11] == 3'h0) | (shift_2_s18_q[13:11] == 3'h4);
      sum_2499_s19_q <= shift_2_s18_q[13:12] + 2'h3;
      less_2500_s19_q <= less_2500_s18_q;
      and_2731_s19_q <= and_2731_s18_q;
      or_2782_s19_q <= or_2782_s18_q;
      not_2806_s19_q <= not_2806_s18_q;
      select_3265_s19_q <= select_3265;
      equal_3277_s19_q <= equal_3277_s18_q;
      less_3552_s19_q <= less_3552_s18_q;
      sum_3553_s19_q <= sum_3553[7];
      and_3747_s19_q <= seen_columns_rdata_s18_q[6] & shift_2_s18_q[0];
      equal_3757_s19_q <= equal_3757_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic sample_of_skin_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
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
  logic [13:0] sum_482;
  assign sum_482 = select_478_s19_q + (equal_480_s19_q ? 14'h0 : averager_memory_rdata_s19_q[13:0]);
  logic [13:0] sum_486;
  assign sum_486 = sum_484_s19_q + (equal_480_s19_q ? 14'h0 : averager_memory_rdata_s19_q[27:14]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = equal_462_s19_q ? sample_present_s19_q : (sample_present_s19_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_462_s19_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:123
  logic and_494;
  assign and_494 = all_of_skin & (averager_memory_rdata_s19_q[29] | equal_480_s19_q);
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s19_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:185
  logic equal_1528;
  assign equal_1528 = x_s19_q[5:0] == 6'h3c;
  logic equal_1530;
  assign equal_1530 = x_s19_q[5:0] == 6'h3b;
  logic equal_1532;
  assign equal_1532 = x_s19_q[5:0] == 6'h36;
  logic equal_1534;
  assign equal_1534 = x_s19_q[5:0] == 6'h35;
  logic equal_1536;
  assign equal_1536 = x_s19_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1116
  logic and_1540;
  assign and_1540 = (~equal_1530) & ((~equal_1532) & ((~equal_1534) & (~equal_1536)));
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1617;
  assign sum_1617 = {{3{sum_1613_s19_q[7]}}, sum_1613_s19_q} + {sum_1616_s19_q[8], sum_1616_s19_q, select_1614_s19_q};
  logic [9:0] sum_1621;
  assign sum_1621 = {difference_1620_s19_q, select_1618_s19_q} + {sum_1617[10], sum_1617[10:2]};
  // hls/stages/patches.hpp:432
  logic [8:0] sum_1787;
  assign sum_1787 = {1'b0, patches_columns_above_rdata_s19_q[7:0]} + {2'h0, pixel_2_s19_q[7:1]};
  logic [8:0] sum_1788;
  assign sum_1788 = {1'b0, patches_columns_above_rdata_s19_q[23:16]} + {2'h0, patches_columns_above_rdata_s19_q[31:25]};
  // hls/stages/patches.hpp:430
  logic [10:0] sum_1799;
  assign sum_1799 = {3'h0, patches_columns_above_rdata_s19_q[15:8]} + {sum_1798_s19_q, patches_columns_above_rdata_s19_q[25]};
  // hls/stages/patches.hpp:148
  logic and_1811;
  assign and_1811 = (~(patches_code_row_s19_q[4:2] == 3'h0)) & (~(patches_column_s19_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:160
  logic and_1815;
  assign and_1815 = or_1696_s19_q & ((equal_1694_s19_q & and_1811) & (patches_column_s19_q == 5'h1f));
  // hls/stages/patches.hpp:445
  logic or_1821;
  assign or_1821 = equal_1694_s19_q | (~and_1811);
  // hls/stages/patches.hpp:449
  logic and_1826;
  assign and_1826 = (~or_1821) & ((~patches_column_s19_q[4]) & (patches_column_s19_q == 5'hf));
  // hls/stages/patches.hpp:314
  logic [5:0] select_1858;
  assign select_1858 = equal_1469_s19_q ? x_s19_q[5:0] : {region_row_q, or_1857_s19_q, or_1854_s19_q, or_1851_s19_q};
  // hls/stages/agreement.hpp:1070
  logic not_1859;
  assign not_1859 = ~equal_1514_s19_q;
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s19_q[0] & shift_2_s19_q[3];
  logic and_1887;
  assign and_1887 = shift_2_s19_q[0] & shift_2_s19_q[2];
  // hls/stages/agreement.hpp:976
  logic and_1929;
  assign and_1929 = seen_columns_rdata_s19_q[0] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_1931;
  assign sum_1931 = {1'b0, and_1928_s19_q} + ({1'b0, textured_s19_q} + {1'b0, and_1929});
  // hls/stages/agreement.hpp:976
  logic and_1961;
  assign and_1961 = seen_columns_rdata_s19_q[11] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1965;
  assign sum_1965 = {1'b0, and_1962_s19_q} + ({1'b0, shown_s19_q} + {1'b0, and_1963_s19_q});
  // hls/stages/agreement.hpp:976
  logic and_1977;
  assign and_1977 = seen_columns_rdata_s19_q[12] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_1981;
  assign sum_1981 = {1'b0, and_1978_s19_q} + ({1'b0, near_s19_q} + {1'b0, and_1979_s19_q});
  // hls/stages/agreement.hpp:263
  logic select_2052;
  assign select_2052 = sample_pair_whole_s19_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/patches.hpp:314
  logic and_2382;
  assign and_2382 = so_s19_q & (ends_cell_s19_q & (shift_2_s19_q[0] & shift_2_s19_q[1]));
  // hls/stages/agreement.hpp:1047
  logic not_2402;
  assign not_2402 = ~(x_s19_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:976
  logic and_2404;
  assign and_2404 = seen_columns_rdata_s19_q[10] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2408;
  assign sum_2408 = {1'b0, and_2405_s19_q} + ({1'b0, explained} + {1'b0, and_2406_s19_q});
  // hls/stages/patches.hpp:314
  logic and_2443;
  assign and_2443 = ends_cell_s19_q & (shift_2_s19_q[0] & (shift_2_s19_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:1052
  logic and_2449;
  assign and_2449 = not_2402 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2501;
  assign difference_2501 = {sum_2499_s19_q, shift_2_s19_q[4], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2502;
  assign select_2502 = less_2500_s19_q ? difference_2501 : {sum_2499_s19_q, shift_2_s19_q[4], registration_displacement_fraction_q};
  logic [7:0] select_2503;
  assign select_2503 = or_2498_s19_q ? {sum_2499_s19_q, shift_2_s19_q[4], 5'h0} : select_2502;
  // hls/stages/patches.hpp:496
  logic [4:0] select_3254;
  assign select_3254 = less_1830_s19_q ? patches_step_s19_q : 5'h0;
  // hls/stages/patches.hpp:500
  logic [4:0] select_3257;
  assign select_3257 = equal_1833_s19_q ? (less_1830_s19_q ? (equal_1833_s19_q ? 5'h0 : select_3254) : 5'h0) : select_3254;
  logic [4:0] select_3259;
  assign select_3259 = less_1830_s19_q ? (equal_1831_s19_q ? 5'h0 : select_3257) : select_3257;
  logic select_3267;
  assign select_3267 = less_1830_s19_q ? (not_1832_s19_q & select_3265_s19_q) : select_3265_s19_q;
  // hls/stages/patches.hpp:154
  logic or_3279;
  assign or_3279 = patches_read_first_q | (patches_read_row_differing_s19_q < patches_peak_best_differing_q);
  logic and_3280;
  assign and_3280 = patches_read_searches_s19_q & or_3279;
  // hls/stages/patches.hpp:479
  logic [14:0] select_3312;
  assign select_3312 = and_3280 ? {patches_read_row_column_s19_q, patches_read_row_differing_s19_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:160
  logic [9:0] select_3313;
  assign select_3313 = equal_1690_s19_q ? select_3312[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3314;
  assign select_3314 = equal_1690_s19_q ? select_3312[14:10] : patches_peak_best_column_q;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3555;
  assign select_3555 = less_3552_s19_q ? (sum_3553_s19_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3557;
  assign select_3557 = equal_2263_s19_q ? (equal_561_s19_q ? 3'h0 : select_3555) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3553_s19_q;
  // hls/stages/agreement.hpp:447
  logic select_3588;
  assign select_3588 = equal_2263_s19_q ? (equal_561_s19_q | (less_3552_s19_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1148
  logic equal_3606;
  assign equal_3606 = x_s19_q[6:3] == 4'h7;
  logic equal_3628;
  assign equal_3628 = x_s19_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_3641;
  assign select_3641 = (x_s19_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3643;
  assign select_3643 = equal_3628 ? cfg_unproven_skin_limit_i : (equal_3606 ? cfg_unproven_limit_i : select_3641);
  // hls/stages/patches.hpp:314
  logic select_3745;
  assign select_3745 = so_s19_q ? (ends_cell_s19_q ? and_1928_s19_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3749;
  assign select_3749 = so_s19_q ? (ends_cell_s19_q ? and_3747_s19_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_3751;
  assign select_3751 = ends_cell_s19_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3753;
  assign select_3753 = equal_1469_s19_q ? centres_values_1_textured_q : (so_s19_q ? select_3751 : centres_values_1_textured_q);
  logic select_3754;
  assign select_3754 = ends_cell_s19_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3756;
  assign select_3756 = equal_1469_s19_q ? centres_values_1_of_skin_q : (so_s19_q ? select_3754 : centres_values_1_of_skin_q);

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
  assign census_memory_re = s19_en & and_500_s19_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1318; read in stage 19, written in stage 22: 19 < 22 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1858;
  logic regions_re;
  assign regions_re = s19_en & (equal_1469_s19_q ? (x_s19_q[6] & not_1859) : and_1866_s19_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s19_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s19_en & and_1775_s19_q;
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
  assign seen_columns_we = s19_en & and_1504_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q, near_s19_q, shown_s19_q, explained, and_1887, textured_s19_q};
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
      averager_running_of_skin_q <= select_2052;
      patches_read_first_q <= equal_1690_s19_q ? select_3267 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3313;
      patches_peak_best_column_q <= select_3314;
      region_row_q <= and_500_s19_q ? select_3557 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_500_s19_q ? select_3588 : region_fresh_q;
      segment_started_q <= ~segment_starts_q;
      centres_values_0_textured_q <= equal_1469_s19_q ? centres_values_0_textured_q : select_3745;
      centres_values_0_of_skin_q <= equal_1469_s19_q ? centres_values_0_of_skin_q : select_3749;
      centres_values_1_textured_q <= select_3753;
      centres_values_1_of_skin_q <= select_3756;
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
  logic patches_column_s20_q;
  logic [4:0] patches_step_s20_q;
  logic [9:0] patches_read_row_differing_s20_q;
  logic patches_read_first_s20_q;
  logic [2:0] region_row_s20_q;
  logic region_fresh_s20_q;
  logic segment_started_s20_q;
  logic centres_values_1_textured_s20_q;
  logic centres_values_1_of_skin_s20_q;
  logic [3:0] select_461_s20_q;
  logic [6:0] select_464_s20_q;
  logic [8:0] select_468_s20_q;
  logic and_474_s20_q;
  logic and_475_s20_q;
  logic [13:0] sum_482_s20_q;
  logic [13:0] sum_486_s20_q;
  logic and_490_s20_q;
  logic and_494_s20_q;
  logic [6:0] column_s20_q;
  logic and_498_s20_q;
  logic and_500_s20_q;
  logic equal_503_s20_q;
  logic so_s20_q;
  logic equal_561_s20_q;
  logic equal_1469_s20_q;
  logic not_1470_s20_q;
  logic [1:0] shift_2_s20_q;
  logic equal_1514_s20_q;
  logic all_s20_q;
  logic equal_1528_s20_q;
  logic equal_1530_s20_q;
  logic equal_1532_s20_q;
  logic equal_1534_s20_q;
  logic equal_1536_s20_q;
  logic and_1541_s20_q;
  logic right_2_s20_q;
  logic and_1582_s20_q;
  logic and_1595_s20_q;
  logic and_1608_s20_q;
  logic less_1609_s20_q;
  logic equal_1610_s20_q;
  logic sum_1617_s20_q;
  logic [9:0] sum_1621_s20_q;
  logic equal_1631_s20_q;
  logic and_1641_s20_q;
  logic [5:0] select_1656_s20_q;
  logic [7:0] select_1681_s20_q;
  logic and_1688_s20_q;
  logic and_1689_s20_q;
  logic equal_1690_s20_q;
  logic not_1691_s20_q;
  logic equal_1692_s20_q;
  logic equal_1694_s20_q;
  logic or_1696_s20_q;
  logic [4:0] select_1720_s20_q;
  logic select_1726_s20_q;
  logic [3:0] select_1765_s20_q;
  logic [8:0] patches_columns_above_rdata_s20_q;
  logic [7:0] pixel_2_s20_q;
  logic [8:0] sum_1787_s20_q;
  logic [8:0] sum_1788_s20_q;
  logic [10:0] sum_1799_s20_q;
  logic and_1816_s20_q;
  logic or_1821_s20_q;
  logic and_1828_s20_q;
  logic less_1830_s20_q;
  logic equal_1831_s20_q;
  logic not_1832_s20_q;
  logic equal_1833_s20_q;
  logic not_1834_s20_q;
  logic [9:0] patches_rows_rdata_s20_q;
  logic or_1851_s20_q;
  logic or_1854_s20_q;
  logic or_1857_s20_q;
  logic not_1859_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1880_s20_q;
  logic and_1885_s20_q;
  logic and_1926_s20_q;
  logic and_1927_s20_q;
  logic [1:0] sum_1931_s20_q;
  logic or_1943_s20_q;
  logic or_1946_s20_q;
  logic or_1949_s20_q;
  logic and_1960_s20_q;
  logic [2:0] sum_1966_s20_q;
  logic and_1976_s20_q;
  logic [2:0] sum_1982_s20_q;
  logic and_1999_s20_q;
  logic equal_2139_s20_q;
  logic equal_2263_s20_q;
  logic and_2383_s20_q;
  logic not_2402_s20_q;
  logic and_2403_s20_q;
  logic [2:0] sum_2409_s20_q;
  logic and_2445_s20_q;
  logic and_2452_s20_q;
  logic [7:0] select_2503_s20_q;
  logic and_2731_s20_q;
  logic or_2782_s20_q;
  logic not_2806_s20_q;
  logic [4:0] select_3259_s20_q;
  logic equal_3277_s20_q;
  logic and_3280_s20_q;
  logic [14:0] select_3312_s20_q;
  logic equal_3606_s20_q;
  logic equal_3627_s20_q;
  logic equal_3628_s20_q;
  logic [7:0] select_3643_s20_q;
  logic equal_3757_s20_q;
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
      patches_column_s20_q <= patches_column_s19_q[4];
      patches_step_s20_q <= patches_step_s19_q;
      patches_read_row_differing_s20_q <= patches_read_row_differing_s19_q;
      patches_read_first_s20_q <= patches_read_first_q;
      region_row_s20_q <= region_row_q;
      region_fresh_s20_q <= region_fresh_q;
      segment_started_s20_q <= segment_started_q;
      centres_values_1_textured_s20_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s20_q <= centres_values_1_of_skin_q;
      select_461_s20_q <= select_461_s19_q;
      select_464_s20_q <= select_464_s19_q;
      select_468_s20_q <= select_468_s19_q;
      and_474_s20_q <= and_474_s19_q;
      and_475_s20_q <= and_475_s19_q;
      sum_482_s20_q <= sum_482;
      sum_486_s20_q <= sum_486;
      and_490_s20_q <= whole & (averager_memory_rdata_s19_q[28] | equal_480_s19_q);
      and_494_s20_q <= and_494;
      column_s20_q <= column_s19_q;
      and_498_s20_q <= and_498_s19_q;
      and_500_s20_q <= and_500_s19_q;
      equal_503_s20_q <= select_461_s19_q == 4'h3;
      so_s20_q <= so_s19_q;
      equal_561_s20_q <= equal_561_s19_q;
      equal_1469_s20_q <= equal_1469_s19_q;
      not_1470_s20_q <= not_1470_s19_q;
      shift_2_s20_q <= {shift_2_s19_q[3], shift_2_s19_q[0]};
      equal_1514_s20_q <= equal_1514_s19_q;
      all_s20_q <= all;
      equal_1528_s20_q <= equal_1528;
      equal_1530_s20_q <= equal_1530;
      equal_1532_s20_q <= equal_1532;
      equal_1534_s20_q <= equal_1534;
      equal_1536_s20_q <= equal_1536;
      and_1541_s20_q <= (~equal_1528) & and_1540;
      right_2_s20_q <= right_2_s19_q;
      and_1582_s20_q <= and_1582_s19_q;
      and_1595_s20_q <= and_1595_s19_q;
      and_1608_s20_q <= and_1608_s19_q;
      less_1609_s20_q <= less_1609_s19_q;
      equal_1610_s20_q <= equal_1610_s19_q;
      sum_1617_s20_q <= sum_1617[1];
      sum_1621_s20_q <= sum_1621;
      equal_1631_s20_q <= equal_1631_s19_q;
      and_1641_s20_q <= and_1641_s19_q;
      select_1656_s20_q <= select_1656_s19_q;
      select_1681_s20_q <= select_1681_s19_q;
      and_1688_s20_q <= and_1688_s19_q;
      and_1689_s20_q <= and_1689_s19_q;
      equal_1690_s20_q <= equal_1690_s19_q;
      not_1691_s20_q <= not_1691_s19_q;
      equal_1692_s20_q <= equal_1692_s19_q;
      equal_1694_s20_q <= equal_1694_s19_q;
      or_1696_s20_q <= or_1696_s19_q;
      select_1720_s20_q <= select_1720_s19_q;
      select_1726_s20_q <= select_1726_s19_q;
      select_1765_s20_q <= select_1765_s19_q;
      patches_columns_above_rdata_s20_q <= {patches_columns_above_rdata_s19_q[24], patches_columns_above_rdata_s19_q[7:0]};
      pixel_2_s20_q <= pixel_2_s19_q;
      sum_1787_s20_q <= sum_1787;
      sum_1788_s20_q <= sum_1788;
      sum_1799_s20_q <= sum_1799;
      and_1816_s20_q <= not_1693_s19_q & and_1815;
      or_1821_s20_q <= or_1821;
      and_1828_s20_q <= not_1693_s19_q & (or_1696_s19_q & and_1826);
      less_1830_s20_q <= less_1830_s19_q;
      equal_1831_s20_q <= equal_1831_s19_q;
      not_1832_s20_q <= not_1832_s19_q;
      equal_1833_s20_q <= equal_1833_s19_q;
      not_1834_s20_q <= not_1834_s19_q;
      patches_rows_rdata_s20_q <= patches_rows_rdata_s19_q;
      or_1851_s20_q <= or_1851_s19_q;
      or_1854_s20_q <= or_1854_s19_q;
      or_1857_s20_q <= or_1857_s19_q;
      not_1859_s20_q <= not_1859;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained;
      and_1880_s20_q <= and_1880_s19_q;
      and_1885_s20_q <= not_1470_s19_q & and_1866_s19_q;
      and_1926_s20_q <= and_1926_s19_q;
      and_1927_s20_q <= seen_columns_rdata_s19_q[9] & shift_2_s19_q[0];
      sum_1931_s20_q <= sum_1931;
      or_1943_s20_q <= or_1943_s19_q;
      or_1946_s20_q <= or_1946_s19_q;
      or_1949_s20_q <= or_1949_s19_q;
      and_1960_s20_q <= and_1960_s19_q;
      sum_1966_s20_q <= {2'h0, and_1961} + {1'b0, sum_1965};
      and_1976_s20_q <= and_1976_s19_q;
      sum_1982_s20_q <= {2'h0, and_1977} + {1'b0, sum_1981};
      and_1999_s20_q <= and_1999_s19_q;
      equal_2139_s20_q <= equal_2139_s19_q;
      equal_2263_s20_q <= equal_2263_s19_q;
      and_2383_s20_q <= not_1470_s19_q & and_2382;
      not_2402_s20_q <= not_2402;
      and_2403_s20_q <= and_2403_s19_q;
      sum_2409_s20_q <= {2'h0, and_2404} + {1'b0, sum_2408};
      and_2445_s20_q <= not_1470_s19_q & (so_s19_q & and_2443);
      and_2452_s20_q <= not_1470_s19_q & (so_s19_q & (ends_cell_s19_q & and_2449));
      select_2503_s20_q <= select_2503;
      and_2731_s20_q <= and_2731_s19_q;
      or_2782_s20_q <= or_2782_s19_q;
      not_2806_s20_q <= not_2806_s19_q;
      select_3259_s20_q <= select_3259;
      equal_3277_s20_q <= equal_3277_s19_q;
      and_3280_s20_q <= and_3280;
      select_3312_s20_q <= select_3312;
      equal_3606_s20_q <= equal_3606;
      equal_3627_s20_q <= x_s19_q[6:3] == 4'h9;
      equal_3628_s20_q <= equal_3628;
      select_3643_s20_q <= select_3643;
      equal_3757_s20_q <= equal_3757_s19_q;
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
  assign grey = and_474_s20_q ? sum_482_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_503_s20_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_474_s20_q ? sum_486_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_503_s20_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_511;
  assign and_511 = and_474_s20_q & and_490_s20_q;
  // hls/stages/census.hpp:126
  logic select_513;
  assign select_513 = equal_503_s20_q ? and_511 : (averager_mask_q & and_511);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s20_q & select_513;
  // hls/stages/census.hpp:206
  logic and_515;
  assign and_515 = and_474_s20_q & and_494_s20_q;
  // hls/stages/census.hpp:126
  logic select_517;
  assign select_517 = equal_503_s20_q ? and_515 : (averager_of_skin_q & and_515);
  // hls/stages/agreement.hpp:442
  logic equal_558;
  assign equal_558 = column_s20_q == 7'h0;
  logic [3:0] select_562;
  assign select_562 = equal_561_s20_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_563;
  assign select_563 = equal_558 ? {select_562, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_564;
  assign select_564 = equal_558 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s20_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1517;
  assign select_1517 = x_s20_q[4] ? {x_s20_q[3], x_s20_q[0]} : {x_s20_q[0], x_s20_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1519;
  assign select_1519 = equal_1514_s20_q ? {2'h0, quarter} : (all_s20_q ? {1'b0, x_s20_q[2:0]} : {x_s20_q[2:1], select_1517});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1520;
  assign sum_1520 = slot_s20_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:314
  logic [3:0] select_1521;
  assign select_1521 = equal_1469_s20_q ? select_1519 : {sum_1520, lower_half_s20_q, registration_of_right_q};
  // hls/stages/patches.hpp:185
  logic equal_1522;
  assign equal_1522 = x_s20_q[5:0] == 6'h3f;
  logic equal_1524;
  assign equal_1524 = x_s20_q[5:0] == 6'h3e;
  logic equal_1526;
  assign equal_1526 = x_s20_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1116
  logic and_1544;
  assign and_1544 = (~equal_1522) & ((~equal_1524) & ((~equal_1526) & and_1541_s20_q));
  // hls/stages/agreement.hpp:1071
  logic less_1545;
  assign less_1545 = x_s20_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s20_q ? {1'b0, x_s20_q[2]} : x_s20_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1549;
  assign or_1549 = (kind == 2'h3) | (x_s20_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s20_q[0] ? (right_2_s20_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1560;
  assign sum_1560 = {2'h0, slot_s20_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1566;
  assign not_1566 = ~lower_half_s20_q;
  logic [3:0] select_1567;
  assign select_1567 = registration_of_right_q ? {lower_half_s20_q, 1'b0, not_1566, 1'b0} : {1'b0, lower_half_s20_q, 1'b0, not_1566};
  // hls/stages/patches.hpp:347
  logic [1:0] select_1596;
  assign select_1596 = and_1595_s20_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1597;
  assign select_1597 = and_1595_s20_q ? patches_band_rows_number_s20_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1598;
  assign select_1598 = and_1582_s20_q ? {select_1597, select_1596[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:103
  logic [1:0] select_1599;
  assign select_1599 = and_1582_s20_q ? select_1596 : patches_fetch_q;
  logic equal_1600;
  assign equal_1600 = select_1599 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1610_s20_q ? {sum_1621_s20_q, sum_1617_s20_q} : registration_expected_q;
  // hls/stages/patches.hpp:103
  logic [4:0] select_1703;
  assign select_1703 = and_1582_s20_q ? select_1597 : patches_band_q;
  // hls/stages/patches.hpp:327
  logic equal_1704;
  assign equal_1704 = {patches_choosing_band_s20_q, and_1608_s20_q} == {select_1703, select_1599[1]};
  // hls/stages/patches.hpp:432
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1787_s20_q, pixel_2_s20_q[0]} - {1'b0, sum_1788_s20_q, patches_columns_above_rdata_s20_q[8]};
  // hls/stages/patches.hpp:430
  logic [9:0] sum_1800;
  assign sum_1800 = {2'h0, patches_columns_above_rdata_s20_q[7:0]} + sum_1799_s20_q[10:1];
  // hls/stages/agreement.hpp:1029
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1926_s20_q} + ({2'h0, and_1927_s20_q} + {1'b0, sum_1931_s20_q});
  // hls/stages/agreement.hpp:1031
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1960_s20_q} + sum_1966_s20_q;
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1968;
  assign select_1968 = age_s20_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1032
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1976_s20_q} + sum_1982_s20_q;
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_1984;
  assign select_1984 = age_s20_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2031;
  assign select_2031 = sample_pair_whole_s20_q ? (and_498_s20_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2033;
  assign select_2033 = sample_pair_whole_s20_q ? (and_498_s20_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2054;
  assign select_2054 = sample_pair_whole_s20_q ? (and_498_s20_q ? select_513 : averager_mask_q) : averager_mask_q;
  logic select_2056;
  assign select_2056 = sample_pair_whole_s20_q ? (and_498_s20_q ? select_517 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic and_2379;
  assign and_2379 = and_500_s20_q & (equal_561_s20_q & equal_2263_s20_q);
  // hls/stages/patches.hpp:314
  logic and_2388;
  assign and_2388 = not_1470_s20_q & (so_s20_q & (ends_cell_s20_q & textured_s20_q));
  // hls/stages/agreement.hpp:1030
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2403_s20_q} + sum_2409_s20_q;
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2411;
  assign select_2411 = age_s20_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2447;
  assign select_2447 = and_2379 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2445_s20_q});
  logic [13:0] select_2454;
  assign select_2454 = and_2379 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2452_s20_q});
  // hls/stages/patches.hpp:314
  logic [10:0] select_2490;
  assign select_2490 = equal_1469_s20_q ? registration_expected_q : (so_s20_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2491;
  assign equal_2491 = slot_s20_q == 3'h4;
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2503_s20_q[7]}}, select_2503_s20_q} - {sum_1621_s20_q[9], sum_1621_s20_q, sum_1617_s20_q};
  // hls/stages/patches.hpp:314
  logic select_2550;
  assign select_2550 = so_s20_q ? (equal_2491 ? right_2_s20_q : registration_of_right_q) : registration_of_right_q;
  logic select_2553;
  assign select_2553 = so_s20_q ? (equal_1610_s20_q ? shift_2_s20_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all_s20_q ? x_s20_q[1:0] : select_1517;
  // hls/stages/patches.hpp:328
  logic not_2747;
  assign not_2747 = ~select_1599[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2749;
  assign select_2749 = sample_pair_whole_s20_q ? (equal_1600 ? select_1599 : {not_2747, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:480
  logic [4:0] select_3281;
  assign select_3281 = and_3280_s20_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:487
  logic [5:0] away;
  assign away = {1'b0, patches_step_s20_q} - {1'b0, select_3281};
  // hls/stages/agreement.hpp:1154
  logic equal_3434;
  assign equal_3434 = x_s20_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1148
  logic equal_3625;
  assign equal_3625 = x_s20_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1067
  logic [7:0] limit;
  assign limit = equal_3625 ? cfg_regions_limit_i : (equal_3627_s20_q ? cfg_hidden_limit_i : select_3643_s20_q);
  // hls/stages/agreement.hpp:1161
  logic not_3646;
  assign not_3646 = ~x_s20_q[2];
  logic [3:0] select_3647;
  assign select_3647 = x_s20_q[1] ? {x_s20_q[2], 1'b0, not_3646, 1'b0} : {1'b0, x_s20_q[2], 1'b0, not_3646};
  logic [7:0] select_3648;
  assign select_3648 = x_s20_q[0] ? {select_3647[3], 1'b0, select_3647[2], 1'b0, select_3647[1], 1'b0, select_3647[0], 1'b0} : {1'b0, select_3647[3], 1'b0, select_3647[2], 1'b0, select_3647[1], 1'b0, select_3647[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3652;
  assign select_3652 = equal_3627_s20_q ? counts_skin_supervised_q : (equal_3628_s20_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3625 ? counts_textured_q : select_3652;
  // hls/stages/patches.hpp:314
  logic [2:0] select_3691;
  assign select_3691 = so_s20_q ? (ends_cell_s20_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3692;
  assign select_3692 = equal_1469_s20_q ? box_explained_columns_values_0_q : select_3691;
  logic [2:0] select_3693;
  assign select_3693 = ends_cell_s20_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3695;
  assign select_3695 = equal_1469_s20_q ? box_explained_columns_values_1_q : (so_s20_q ? select_3693 : box_explained_columns_values_1_q);
  logic [2:0] select_3696;
  assign select_3696 = ends_cell_s20_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3698;
  assign select_3698 = equal_1469_s20_q ? box_explained_columns_values_2_q : (so_s20_q ? select_3696 : box_explained_columns_values_2_q);
  logic [2:0] select_3699;
  assign select_3699 = ends_cell_s20_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3701;
  assign select_3701 = equal_1469_s20_q ? box_explained_columns_values_3_q : (so_s20_q ? select_3699 : box_explained_columns_values_3_q);
  logic [2:0] select_3702;
  assign select_3702 = ends_cell_s20_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3704;
  assign select_3704 = equal_1469_s20_q ? box_explained_columns_values_4_q : (so_s20_q ? select_3702 : box_explained_columns_values_4_q);
  logic [2:0] select_3709;
  assign select_3709 = so_s20_q ? (ends_cell_s20_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3711;
  assign select_3711 = ends_cell_s20_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3713;
  assign select_3713 = equal_1469_s20_q ? box_shown_columns_values_1_q : (so_s20_q ? select_3711 : box_shown_columns_values_1_q);
  logic [2:0] select_3714;
  assign select_3714 = ends_cell_s20_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3716;
  assign select_3716 = equal_1469_s20_q ? box_shown_columns_values_2_q : (so_s20_q ? select_3714 : box_shown_columns_values_2_q);
  logic [2:0] select_3717;
  assign select_3717 = ends_cell_s20_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3719;
  assign select_3719 = equal_1469_s20_q ? box_shown_columns_values_3_q : (so_s20_q ? select_3717 : box_shown_columns_values_3_q);
  logic [2:0] select_3720;
  assign select_3720 = ends_cell_s20_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3722;
  assign select_3722 = equal_1469_s20_q ? box_shown_columns_values_4_q : (so_s20_q ? select_3720 : box_shown_columns_values_4_q);
  logic [2:0] select_3727;
  assign select_3727 = so_s20_q ? (ends_cell_s20_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3729;
  assign select_3729 = ends_cell_s20_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3731;
  assign select_3731 = equal_1469_s20_q ? box_nearer_columns_values_1_q : (so_s20_q ? select_3729 : box_nearer_columns_values_1_q);
  logic [2:0] select_3732;
  assign select_3732 = ends_cell_s20_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3734;
  assign select_3734 = equal_1469_s20_q ? box_nearer_columns_values_2_q : (so_s20_q ? select_3732 : box_nearer_columns_values_2_q);
  logic [2:0] select_3735;
  assign select_3735 = ends_cell_s20_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3737;
  assign select_3737 = equal_1469_s20_q ? box_nearer_columns_values_3_q : (so_s20_q ? select_3735 : box_nearer_columns_values_3_q);
  logic [2:0] select_3738;
  assign select_3738 = ends_cell_s20_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3740;
  assign select_3740 = equal_1469_s20_q ? box_nearer_columns_values_4_q : (so_s20_q ? select_3738 : box_nearer_columns_values_4_q);

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_468_s20_q;
  logic averager_memory_we;
  assign averager_memory_we = s20_en & and_475_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_494_s20_q, and_490_s20_q, sum_486_s20_q, sum_482_s20_q};
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
      patches_read_at_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
    end else if (s20_en) begin
      averager_mask_q <= select_2054;
      averager_of_skin_q <= select_2056;
      census_filled_q <= and_500_s20_q ? {select_564[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_500_s20_q ? select_563 : rows_passed_above_q;
      counts_textured_q <= and_2379 ? 14'h0 : (counts_textured_q + {13'h0, and_2388});
      counts_skin_supervised_q <= select_2447;
      counts_skin_textured_q <= select_2454;
      registration_expected_q <= select_2490;
      registration_of_right_q <= equal_1469_s20_q ? registration_of_right_q : select_2550;
      registration_was_inside_q <= equal_1469_s20_q ? registration_was_inside_q : select_2553;
      patches_band_q <= sample_pair_whole_s20_q ? select_1703 : patches_band_q;
      patches_fetch_q <= select_2749;
      patches_read_at_q <= equal_1690_s20_q ? select_3259_s20_q : patches_read_at_q;
      patches_peak_row_q <= equal_1690_s20_q ? select_3281 : patches_peak_row_q;
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
      averager_total_0_q <= select_2031;
      averager_total_1_q <= select_2033;
      box_explained_columns_values_0_q <= select_3692;
      box_explained_columns_values_1_q <= select_3695;
      box_explained_columns_values_2_q <= select_3698;
      box_explained_columns_values_3_q <= select_3701;
      box_explained_columns_values_4_q <= select_3704;
      box_shown_columns_values_0_q <= equal_1469_s20_q ? box_shown_columns_values_0_q : select_3709;
      box_shown_columns_values_1_q <= select_3713;
      box_shown_columns_values_2_q <= select_3716;
      box_shown_columns_values_3_q <= select_3719;
      box_shown_columns_values_4_q <= select_3722;
      box_nearer_columns_values_0_q <= equal_1469_s20_q ? box_nearer_columns_values_0_q : select_3727;
      box_nearer_columns_values_1_q <= select_3731;
      box_nearer_columns_values_2_q <= select_3734;
      box_nearer_columns_values_3_q <= select_3737;
      box_nearer_columns_values_4_q <= select_3740;
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
  logic patches_column_s21_q;
  logic [9:0] patches_read_row_differing_s21_q;
  logic patches_read_first_s21_q;
  logic [2:0] region_row_s21_q;
  logic region_fresh_s21_q;
  logic segment_started_s21_q;
  logic centres_values_1_textured_s21_q;
  logic centres_values_1_of_skin_s21_q;
  logic [3:0] select_461_s21_q;
  logic [6:0] select_464_s21_q;
  logic [6:0] column_s21_q;
  logic and_498_s21_q;
  logic and_500_s21_q;
  logic [77:0] census_memory_rdata_s21_q;
  logic [8:0] grey_s21_q;
  logic equal_503_s21_q;
  logic [8:0] select_506_s21_q;
  logic [8:0] grey_2_s21_q;
  logic [8:0] select_510_s21_q;
  logic whole_2_s21_q;
  logic and_518_s21_q;
  logic so_s21_q;
  logic and_565_s21_q;
  logic equal_1469_s21_q;
  logic not_1470_s21_q;
  logic [1:0] shift_2_s21_q;
  logic equal_1514_s21_q;
  logic [1:0] quarter_s21_q;
  logic all_s21_q;
  logic [1:0] sum_1520_s21_q;
  logic [3:0] select_1521_s21_q;
  logic equal_1522_s21_q;
  logic equal_1524_s21_q;
  logic equal_1526_s21_q;
  logic equal_1528_s21_q;
  logic equal_1530_s21_q;
  logic equal_1532_s21_q;
  logic equal_1534_s21_q;
  logic equal_1536_s21_q;
  logic less_1545_s21_q;
  logic or_1549_s21_q;
  logic select_1552_s21_q;
  logic and_1562_s21_q;
  logic [3:0] select_1567_s21_q;
  logic and_1582_s21_q;
  logic [5:0] select_1598_s21_q;
  logic select_1599_s21_q;
  logic equal_1600_s21_q;
  logic and_1608_s21_q;
  logic less_1609_s21_q;
  logic equal_1610_s21_q;
  logic expected_s21_q;
  logic [10:0] sum_1623_s21_q;
  logic equal_1631_s21_q;
  logic and_1641_s21_q;
  logic [5:0] select_1656_s21_q;
  logic [7:0] select_1681_s21_q;
  logic and_1688_s21_q;
  logic and_1689_s21_q;
  logic equal_1690_s21_q;
  logic not_1691_s21_q;
  logic equal_1692_s21_q;
  logic equal_1694_s21_q;
  logic or_1696_s21_q;
  logic and_1705_s21_q;
  logic [4:0] select_1720_s21_q;
  logic select_1726_s21_q;
  logic [3:0] select_1765_s21_q;
  logic patches_columns_above_rdata_s21_q;
  logic [7:0] pixel_2_s21_q;
  logic [10:0] down_2_s21_q;
  logic sum_1799_s21_q;
  logic [9:0] sum_1800_s21_q;
  logic and_1817_s21_q;
  logic or_1821_s21_q;
  logic and_1829_s21_q;
  logic less_1830_s21_q;
  logic equal_1831_s21_q;
  logic not_1832_s21_q;
  logic equal_1833_s21_q;
  logic not_1834_s21_q;
  logic [9:0] patches_rows_rdata_s21_q;
  logic or_1851_s21_q;
  logic or_1854_s21_q;
  logic or_1857_s21_q;
  logic not_1859_s21_q;
  logic [29:0] regions_rdata_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1880_s21_q;
  logic and_1885_s21_q;
  logic [2:0] textured_2_s21_q;
  logic or_1943_s21_q;
  logic or_1946_s21_q;
  logic or_1949_s21_q;
  logic [3:0] difference_1969_s21_q;
  logic [3:0] difference_1985_s21_q;
  logic and_1999_s21_q;
  logic equal_2139_s21_q;
  logic equal_2263_s21_q;
  logic and_2379_s21_q;
  logic and_2383_s21_q;
  logic and_2388_s21_q;
  logic not_2402_s21_q;
  logic [3:0] difference_2412_s21_q;
  logic and_2494_s21_q;
  logic [11:0] select_2506_s21_q;
  logic equal_2555_s21_q;
  logic [3:0] not_2556_s21_q;
  logic [1:0] quarter_2_s21_q;
  logic and_2731_s21_q;
  logic or_2782_s21_q;
  logic not_2806_s21_q;
  logic equal_3277_s21_q;
  logic [4:0] select_3281_s21_q;
  logic [5:0] away_s21_q;
  logic equal_3283_s21_q;
  logic equal_3292_s21_q;
  logic [14:0] select_3312_s21_q;
  logic equal_3434_s21_q;
  logic and_3607_s21_q;
  logic equal_3625_s21_q;
  logic equal_3627_s21_q;
  logic equal_3628_s21_q;
  logic equal_3650_s21_q;
  logic [13:0] of_s21_q;
  logic equal_3757_s21_q;
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
      patches_column_s21_q <= patches_column_s20_q;
      patches_read_row_differing_s21_q <= patches_read_row_differing_s20_q;
      patches_read_first_s21_q <= patches_read_first_s20_q;
      region_row_s21_q <= region_row_s20_q;
      region_fresh_s21_q <= region_fresh_s20_q;
      segment_started_s21_q <= segment_started_s20_q;
      centres_values_1_textured_s21_q <= centres_values_1_textured_s20_q;
      centres_values_1_of_skin_s21_q <= centres_values_1_of_skin_s20_q;
      select_461_s21_q <= select_461_s20_q;
      select_464_s21_q <= select_464_s20_q;
      column_s21_q <= column_s20_q;
      and_498_s21_q <= and_498_s20_q;
      and_500_s21_q <= and_500_s20_q;
      census_memory_rdata_s21_q <= census_memory_rdata_q;
      grey_s21_q <= grey;
      equal_503_s21_q <= equal_503_s20_q;
      select_506_s21_q <= sample_pair_whole_s20_q ? total[10:2] : 9'h0;
      grey_2_s21_q <= grey_2;
      select_510_s21_q <= sample_pair_whole_s20_q ? total_2[10:2] : 9'h0;
      whole_2_s21_q <= whole_2;
      and_518_s21_q <= sample_pair_whole_s20_q & select_517;
      so_s21_q <= so_s20_q;
      and_565_s21_q <= select_563[4] & select_564[3];
      equal_1469_s21_q <= equal_1469_s20_q;
      not_1470_s21_q <= not_1470_s20_q;
      shift_2_s21_q <= shift_2_s20_q;
      equal_1514_s21_q <= equal_1514_s20_q;
      quarter_s21_q <= quarter;
      all_s21_q <= all_s20_q;
      sum_1520_s21_q <= sum_1520;
      select_1521_s21_q <= select_1521;
      equal_1522_s21_q <= equal_1522;
      equal_1524_s21_q <= equal_1524;
      equal_1526_s21_q <= equal_1526;
      equal_1528_s21_q <= equal_1528_s20_q;
      equal_1530_s21_q <= equal_1530_s20_q;
      equal_1532_s21_q <= equal_1532_s20_q;
      equal_1534_s21_q <= equal_1534_s20_q;
      equal_1536_s21_q <= equal_1536_s20_q;
      less_1545_s21_q <= less_1545;
      or_1549_s21_q <= or_1549;
      select_1552_s21_q <= equal_1514_s20_q ? and_1544 : (less_1545 & (~or_1549));
      and_1562_s21_q <= half_ends & ({{3{sum_1560[4]}}, sum_1560} < 8'h3);
      select_1567_s21_q <= select_1567;
      and_1582_s21_q <= and_1582_s20_q;
      select_1598_s21_q <= select_1598;
      select_1599_s21_q <= select_1599[1];
      equal_1600_s21_q <= equal_1600;
      and_1608_s21_q <= and_1608_s20_q;
      less_1609_s21_q <= less_1609_s20_q;
      equal_1610_s21_q <= equal_1610_s20_q;
      expected_s21_q <= expected[0];
      sum_1623_s21_q <= {expected[10], expected[10:1]} + 11'h5;
      equal_1631_s21_q <= equal_1631_s20_q;
      and_1641_s21_q <= and_1641_s20_q;
      select_1656_s21_q <= select_1656_s20_q;
      select_1681_s21_q <= select_1681_s20_q;
      and_1688_s21_q <= and_1688_s20_q;
      and_1689_s21_q <= and_1689_s20_q;
      equal_1690_s21_q <= equal_1690_s20_q;
      not_1691_s21_q <= not_1691_s20_q;
      equal_1692_s21_q <= equal_1692_s20_q;
      equal_1694_s21_q <= equal_1694_s20_q;
      or_1696_s21_q <= or_1696_s20_q;
      and_1705_s21_q <= and_1689_s20_q & equal_1704;
      select_1720_s21_q <= select_1720_s20_q;
      select_1726_s21_q <= select_1726_s20_q;
      select_1765_s21_q <= select_1765_s20_q;
      patches_columns_above_rdata_s21_q <= patches_columns_above_rdata_s20_q[8];
      pixel_2_s21_q <= pixel_2_s20_q;
      down_2_s21_q <= down_2;
      sum_1799_s21_q <= sum_1799_s20_q[0];
      sum_1800_s21_q <= sum_1800;
      and_1817_s21_q <= not_1691_s20_q & and_1816_s20_q;
      or_1821_s21_q <= or_1821_s20_q;
      and_1829_s21_q <= not_1691_s20_q & and_1828_s20_q;
      less_1830_s21_q <= less_1830_s20_q;
      equal_1831_s21_q <= equal_1831_s20_q;
      not_1832_s21_q <= not_1832_s20_q;
      equal_1833_s21_q <= equal_1833_s20_q;
      not_1834_s21_q <= not_1834_s20_q;
      patches_rows_rdata_s21_q <= patches_rows_rdata_s20_q;
      or_1851_s21_q <= or_1851_s20_q;
      or_1854_s21_q <= or_1854_s20_q;
      or_1857_s21_q <= or_1857_s20_q;
      not_1859_s21_q <= not_1859_s20_q;
      regions_rdata_s21_q <= regions_rdata_q;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1880_s21_q <= and_1880_s20_q;
      and_1885_s21_q <= and_1885_s20_q;
      textured_2_s21_q <= textured_2;
      or_1943_s21_q <= or_1943_s20_q;
      or_1946_s21_q <= or_1946_s20_q;
      or_1949_s21_q <= or_1949_s20_q;
      difference_1969_s21_q <= {1'b0, shown_2} - {1'b0, select_1968};
      difference_1985_s21_q <= {1'b0, near_2} - {1'b0, select_1984};
      and_1999_s21_q <= and_1999_s20_q;
      equal_2139_s21_q <= equal_2139_s20_q;
      equal_2263_s21_q <= equal_2263_s20_q;
      and_2379_s21_q <= and_2379;
      and_2383_s21_q <= and_2383_s20_q;
      and_2388_s21_q <= and_2388;
      not_2402_s21_q <= not_2402_s20_q;
      difference_2412_s21_q <= {1'b0, explained_2} - {1'b0, select_2411};
      and_2494_s21_q <= not_1470_s20_q & (so_s20_q & (half_ends & equal_2491));
      select_2506_s21_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2555_s21_q <= sum_1520 == 2'h2;
      not_2556_s21_q <= ~select_1567;
      quarter_2_s21_q <= quarter_2;
      and_2731_s21_q <= and_2731_s20_q;
      or_2782_s21_q <= or_2782_s20_q;
      not_2806_s21_q <= not_2806_s20_q;
      equal_3277_s21_q <= equal_3277_s20_q;
      select_3281_s21_q <= select_3281;
      away_s21_q <= away;
      equal_3283_s21_q <= away == 6'h3f;
      equal_3292_s21_q <= away == 6'h1;
      select_3312_s21_q <= select_3312_s20_q;
      equal_3434_s21_q <= equal_3434;
      and_3607_s21_q <= equal_3606_s20_q & equal_3434;
      equal_3625_s21_q <= equal_3625;
      equal_3627_s21_q <= equal_3627_s20_q;
      equal_3628_s21_q <= equal_3628_s20_q;
      equal_3650_s21_q <= (limit & select_3648) == 8'h0;
      of_s21_q <= of;
      equal_3757_s21_q <= equal_3757_s20_q;
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
  logic patches_along_ends_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [4:0] patches_along_q;
  logic [4:0] patches_summed_row_column_q;
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
  logic less_534;
  assign less_534 = census_memory_rdata_s21_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_535;
  assign less_535 = census_memory_rdata_s21_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_536;
  assign less_536 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_537;
  assign less_537 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_538;
  assign less_538 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_540;
  assign less_540 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_541;
  assign less_541 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_542;
  assign less_542 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_543;
  assign less_543 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_544;
  assign less_544 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_545;
  assign less_545 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_546;
  assign less_546 = census_memory_rdata_s21_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_547;
  assign less_547 = census_memory_rdata_s21_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_548;
  assign less_548 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_549;
  assign less_549 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_550;
  assign less_550 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_552;
  assign less_552 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_553;
  assign less_553 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_554;
  assign less_554 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_555;
  assign less_555 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_556;
  assign less_556 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_557;
  assign less_557 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:286
  logic and_567;
  assign and_567 = census_memory_rdata_s21_q[38] & (census_memory_rdata_s21_q[18] & whole_2_s21_q);
  logic and_569;
  assign and_569 = census_memory_rdata_s21_q[77] & (census_memory_rdata_s21_q[58] & and_567);
  // hls/stages/census.hpp:270
  logic [9:0] difference_592;
  assign difference_592 = {1'b0, select_506_s21_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_595;
  assign difference_595 = {1'b0, census_memory_rdata_s21_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_599;
  assign difference_599 = {1'b0, census_memory_rdata_s21_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_603;
  assign difference_603 = {1'b0, census_memory_rdata_s21_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_607;
  assign difference_607 = {1'b0, census_memory_rdata_s21_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/patches.hpp:314
  logic and_1563;
  assign and_1563 = so_s21_q & and_1562_s21_q;
  // hls/stages/patches.hpp:75
  logic less_1624;
  assign less_1624 = {{4{sum_1623_s21_q[10]}}, sum_1623_s21_q, expected_s21_q} < 16'h15;
  // hls/stages/patches.hpp:88
  logic and_1642;
  assign and_1642 = (less_1609_s21_q & (shift_2_s21_q[1] & less_1624)) & and_1641_s21_q;
  // hls/stages/patches.hpp:455
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  // hls/stages/patches.hpp:434
  logic [11:0] sum_1790;
  assign sum_1790 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1791;
  assign sum_1791 = {{4{down_2_s21_q[10]}}, down_2_s21_q[10:2]} + {sum_1790[11], sum_1790};
  // hls/stages/patches.hpp:431
  logic [11:0] smooth;
  assign smooth = {sum_1800_s21_q, sum_1799_s21_q, patches_columns_above_rdata_s21_q} + {4'h0, pixel_2_s21_q};
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1870;
  assign select_1870 = segment_started_s21_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1871;
  assign sum_1871 = {6'h0, textured_s21_q} + select_1870;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1873;
  assign sum_1873 = {3'h0, sum_1871} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1875;
  assign select_1875 = segment_started_s21_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1876;
  assign sum_1876 = {6'h0, explained_s21_q} + select_1875;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1878;
  assign sum_1878 = {3'h0, sum_1876} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1881;
  assign select_1881 = segment_started_s21_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_1882;
  assign sum_1882 = {6'h0, and_1880_s21_q} + select_1881;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_1884;
  assign sum_1884 = {3'h0, sum_1882} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[29:20]);
  // hls/stages/agreement.hpp:1201
  logic or_1894;
  assign or_1894 = marks_first_s21_q | line_ended_q;
  // hls/stages/agreement.hpp:1203
  logic [12:0] select_1896;
  assign select_1896 = marks_first_s21_q ? 13'h1 : (or_1894 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1202
  logic [8:0] select_1898;
  assign select_1898 = or_1894 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1210
  logic select_1900;
  assign select_1900 = cfg_compete_i ? (or_1894 & select_1896[12]) : (select_1898[8] & select_1896[9]);
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_1934;
  assign select_1934 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1038
  logic [4:0] around;
  assign around = {difference_1969_s21_q[3], difference_1969_s21_q} + (equal_1631_s21_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1039
  logic [4:0] n;
  assign n = {difference_1985_s21_q[3], difference_1985_s21_q} + (equal_1631_s21_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2023;
  assign select_2023 = sample_pair_whole_s21_q ? (and_498_s21_q ? grey_s21_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2025;
  assign select_2025 = sample_pair_whole_s21_q ? (and_498_s21_q ? grey_2_s21_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2027;
  assign select_2027 = sample_pair_whole_s21_q ? (and_498_s21_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2029;
  assign select_2029 = sample_pair_whole_s21_q ? (and_498_s21_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2034;
  assign sum_2034 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s21_q};
  logic [9:0] sum_2042;
  assign sum_2042 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s21_q};
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2057;
  assign select_2057 = and_500_s21_q ? select_506_s21_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2058;
  assign select_2058 = and_500_s21_q ? select_510_s21_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2060;
  assign select_2060 = and_500_s21_q ? census_memory_rdata_s21_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2061;
  assign select_2061 = and_500_s21_q ? census_memory_rdata_s21_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2062;
  assign select_2062 = and_500_s21_q ? census_memory_rdata_s21_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2063;
  assign select_2063 = and_500_s21_q ? census_memory_rdata_s21_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2064;
  assign select_2064 = and_500_s21_q ? census_memory_rdata_s21_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2065;
  assign select_2065 = and_500_s21_q ? census_memory_rdata_s21_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2066;
  assign select_2066 = and_500_s21_q ? census_memory_rdata_s21_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2067;
  assign select_2067 = and_500_s21_q ? census_memory_rdata_s21_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2068;
  assign select_2068 = and_500_s21_q ? census_memory_rdata_s21_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2069;
  assign select_2069 = and_500_s21_q ? census_memory_rdata_s21_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2070;
  assign select_2070 = and_500_s21_q ? census_memory_rdata_s21_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2071;
  assign select_2071 = and_500_s21_q ? census_memory_rdata_s21_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2072;
  assign select_2072 = and_500_s21_q ? census_memory_rdata_s21_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2073;
  assign select_2073 = and_500_s21_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2074;
  assign select_2074 = and_500_s21_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2076;
  assign select_2076 = and_500_s21_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2077;
  assign select_2077 = and_500_s21_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2079;
  assign select_2079 = and_500_s21_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2080;
  assign select_2080 = and_500_s21_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2082;
  assign select_2082 = and_500_s21_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2083;
  assign select_2083 = and_500_s21_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2084;
  assign select_2084 = and_500_s21_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2086;
  assign select_2086 = and_500_s21_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2087;
  assign select_2087 = and_500_s21_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2089;
  assign select_2089 = and_500_s21_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2090;
  assign select_2090 = and_500_s21_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2092;
  assign select_2092 = and_500_s21_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2093;
  assign select_2093 = and_500_s21_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2095;
  assign select_2095 = and_500_s21_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2096;
  assign select_2096 = and_500_s21_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2098;
  assign select_2098 = and_500_s21_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2099;
  assign select_2099 = and_500_s21_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2101;
  assign select_2101 = and_500_s21_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2102;
  assign select_2102 = and_500_s21_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2105;
  assign select_2105 = and_500_s21_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2106;
  assign select_2106 = and_500_s21_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2109;
  assign select_2109 = and_500_s21_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2110;
  assign select_2110 = and_500_s21_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2114;
  assign difference_2114 = {1'b0, select_510_s21_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2117;
  assign difference_2117 = {1'b0, census_memory_rdata_s21_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2121;
  assign difference_2121 = {1'b0, census_memory_rdata_s21_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2125;
  assign difference_2125 = {1'b0, census_memory_rdata_s21_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2129;
  assign difference_2129 = {1'b0, census_memory_rdata_s21_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2160;
  assign difference_2160 = {1'b0, select_506_s21_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2172;
  assign difference_2172 = {1'b0, select_510_s21_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/patches.hpp:314
  logic and_2393;
  assign and_2393 = not_1470_s21_q & (so_s21_q & (ends_cell_s21_q & explained_s21_q));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2395;
  assign select_2395 = and_2379_s21_q ? 14'h0 : (counts_explained_q + {13'h0, and_2393});
  // hls/stages/patches.hpp:314
  logic and_2398;
  assign and_2398 = not_1470_s21_q & (so_s21_q & (ends_cell_s21_q & and_1880_s21_q));
  // hls/stages/agreement.hpp:1037
  logic [4:0] e;
  assign e = {difference_2412_s21_q[3], difference_2412_s21_q} + (equal_1631_s21_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1074
  logic less_2427;
  assign less_2427 = region_row_s21_q < x_s21_q[5:3];
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2506_s21_q[11:7])) ? 12'h7f : select_2506_s21_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2558;
  assign select_2558 = equal_2555_s21_q ? (registration_fresh_q & not_2556_s21_q) : registration_fresh_q;
  // hls/stages/patches.hpp:314
  logic [3:0] select_2560;
  assign select_2560 = so_s21_q ? (and_1562_s21_q ? select_2558 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2562;
  assign select_2562 = and_2379_s21_q ? 4'hf : (equal_1469_s21_q ? registration_fresh_q : select_2560);
  // hls/stages/registration.hpp:258
  logic not_2583;
  assign not_2583 = ~quarter_2_s21_q[1];
  logic [3:0] select_2584;
  assign select_2584 = quarter_2_s21_q[0] ? {quarter_2_s21_q[1], 1'b0, not_2583, 1'b0} : {1'b0, quarter_2_s21_q[1], 1'b0, not_2583};
  // hls/stages/patches.hpp:160
  logic [10:0] select_2836;
  assign select_2836 = equal_1692_s21_q ? patches_down_values_0_q : (or_1696_s21_q ? down_2_s21_q : patches_down_values_0_q);
  logic [10:0] select_2838;
  assign select_2838 = or_1696_s21_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_2840;
  assign select_2840 = equal_1690_s21_q ? patches_down_values_1_q : (equal_1692_s21_q ? patches_down_values_1_q : select_2838);
  // hls/stages/patches.hpp:387
  logic [4:0] select_2879;
  assign select_2879 = or_2782_s21_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:160
  logic [4:0] select_3231;
  assign select_3231 = equal_1690_s21_q ? patches_summed_row_column_q : (equal_1692_s21_q ? patches_along_q : patches_summed_row_column_q);
  // hls/stages/patches.hpp:496
  logic and_3285;
  assign and_3285 = less_1830_s21_q & (equal_3277_s21_q & equal_3283_s21_q);
  // hls/stages/patches.hpp:500
  logic select_3288;
  assign select_3288 = equal_1833_s21_q ? (less_1830_s21_q ? (not_1834_s21_q & and_3285) : and_3285) : and_3285;
  // hls/stages/patches.hpp:496
  logic and_3294;
  assign and_3294 = less_1830_s21_q & (equal_3277_s21_q & equal_3292_s21_q);
  // hls/stages/patches.hpp:500
  logic select_3297;
  assign select_3297 = equal_1833_s21_q ? (less_1830_s21_q ? (not_1834_s21_q & and_3294) : and_3294) : and_3294;
  // hls/stages/patches.hpp:493
  logic [6:0] sum_3301;
  assign sum_3301 = {away_s21_q[5], away_s21_q} + 7'h7d;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3639;
  assign select_3639 = equal_3434_s21_q ? 14'h0 : product_q;
  logic [13:0] select_3654;
  assign select_3654 = equal_3650_s21_q ? 14'h0 : of_s21_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3639} + {1'b0, select_3654};
  // hls/stages/patches.hpp:314
  logic [2:0] select_3672;
  assign select_3672 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_3674;
  assign select_3674 = equal_1469_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_3672 : box_textured_columns_values_0_q);
  logic [2:0] select_3675;
  assign select_3675 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3677;
  assign select_3677 = equal_1469_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_3675 : box_textured_columns_values_1_q);
  logic [2:0] select_3678;
  assign select_3678 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3680;
  assign select_3680 = equal_1469_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_3678 : box_textured_columns_values_2_q);
  logic [2:0] select_3681;
  assign select_3681 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3683;
  assign select_3683 = equal_1469_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_3681 : box_textured_columns_values_3_q);
  logic [2:0] select_3684;
  assign select_3684 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3686;
  assign select_3686 = equal_1469_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_3684 : box_textured_columns_values_4_q);
  logic [4:0] select_3706;
  assign select_3706 = so_s21_q ? (ends_cell_s21_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3707;
  assign select_3707 = equal_1469_s21_q ? box_explained_sum_sums_values_0_q : select_3706;
  logic [4:0] select_3724;
  assign select_3724 = so_s21_q ? (ends_cell_s21_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_3742;
  assign select_3742 = so_s21_q ? (ends_cell_s21_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/registration.hpp:258
  logic not_3839;
  assign not_3839 = ~quarter_s21_q[1];
  logic [3:0] select_3840;
  assign select_3840 = quarter_s21_q[0] ? {quarter_s21_q[1], 1'b0, not_3839, 1'b0} : {1'b0, quarter_s21_q[1], 1'b0, not_3839};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 21, written in stage 25: 21 < 25 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1521_s21_q;
  logic registration_sums_re;
  assign registration_sums_re = s21_en & (equal_1469_s21_q ? (x_s21_q[6] & select_1552_s21_q) : and_1563);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:686; read in stage 21, written in stage 23: 21 < 23 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1598_s21_q;
  logic patches_choices_re;
  assign patches_choices_re = s21_en & (sample_pair_whole_s21_q & (~equal_1600_s21_q));
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s21_q;
  logic census_memory_we;
  assign census_memory_we = s21_en & and_500_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s21_q[58:40], census_memory_rdata_s21_q[38:0], and_518_s21_q, whole_2_s21_q, select_510_s21_q, select_506_s21_q};
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
      patches_along_ends_q <= 1'b0;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      patches_along_q <= 5'h0;
      patches_summed_row_column_q <= 5'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s21_en) begin
      counts_explained_q <= select_2395;
      registration_fresh_q <= select_2562;
      patches_along_ends_q <= not_2806_s21_q & (patches_along_q == 5'hf);
      patches_down_values_0_q <= equal_1690_s21_q ? patches_down_values_0_q : select_2836;
      patches_down_values_1_q <= select_2840;
      patches_along_q <= select_2879;
      patches_summed_row_column_q <= select_3231;
      segment_textured_q <= select_1870 + {6'h0, and_2388_s21_q};
      segment_explained_q <= select_1875 + {6'h0, and_2393};
      segment_nearer_q <= select_1881 + {6'h0, and_2398};
      product_q <= equal_1469_s21_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_1896;
      columns_passed_q <= {select_1898[7:0], or_1894};
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
      averager_quarter_1_0_q <= select_2023;
      averager_quarter_1_1_q <= select_2025;
      averager_quarter_2_0_q <= select_2027;
      averager_quarter_2_1_q <= select_2029;
      census_columns_values_0_cell_0_left_q <= select_2057;
      census_columns_values_0_cell_0_right_q <= select_2058;
      census_columns_values_0_cell_1_left_q <= select_2060;
      census_columns_values_0_cell_1_right_q <= select_2061;
      census_columns_values_0_cell_1_mask_q <= select_2062;
      census_columns_values_0_cell_2_left_q <= select_2063;
      census_columns_values_0_cell_2_right_q <= select_2064;
      census_columns_values_0_cell_2_mask_q <= select_2065;
      census_columns_values_0_cell_2_of_skin_q <= select_2066;
      census_columns_values_0_cell_3_left_q <= select_2067;
      census_columns_values_0_cell_3_right_q <= select_2068;
      census_columns_values_0_cell_3_mask_q <= select_2069;
      census_columns_values_0_cell_4_left_q <= select_2070;
      census_columns_values_0_cell_4_right_q <= select_2071;
      census_columns_values_0_cell_4_mask_q <= select_2072;
      census_columns_values_1_cell_0_left_q <= select_2073;
      census_columns_values_1_cell_0_right_q <= select_2074;
      census_columns_values_1_cell_1_left_q <= select_2076;
      census_columns_values_1_cell_1_right_q <= select_2077;
      census_columns_values_1_cell_2_left_q <= select_2079;
      census_columns_values_1_cell_2_right_q <= select_2080;
      census_columns_values_1_cell_2_of_skin_q <= select_2082;
      census_columns_values_1_cell_3_left_q <= select_2083;
      census_columns_values_1_cell_3_right_q <= select_2084;
      census_columns_values_1_cell_4_left_q <= select_2086;
      census_columns_values_1_cell_4_right_q <= select_2087;
      census_columns_values_2_cell_0_left_q <= select_2089;
      census_columns_values_2_cell_0_right_q <= select_2090;
      census_columns_values_2_cell_1_left_q <= select_2092;
      census_columns_values_2_cell_1_right_q <= select_2093;
      census_columns_values_2_cell_2_left_q <= select_2095;
      census_columns_values_2_cell_2_right_q <= select_2096;
      census_columns_values_2_cell_3_left_q <= select_2098;
      census_columns_values_2_cell_3_right_q <= select_2099;
      census_columns_values_2_cell_4_left_q <= select_2101;
      census_columns_values_2_cell_4_right_q <= select_2102;
      census_columns_values_3_cell_1_left_q <= select_2105;
      census_columns_values_3_cell_1_right_q <= select_2106;
      census_columns_values_3_cell_3_left_q <= select_2109;
      census_columns_values_3_cell_3_right_q <= select_2110;
      sharpness_last_mean_0_q <= and_500_s21_q ? select_506_s21_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_500_s21_q ? select_510_s21_q : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= select_3674;
      box_textured_columns_values_1_q <= select_3677;
      box_textured_columns_values_2_q <= select_3680;
      box_textured_columns_values_3_q <= select_3683;
      box_textured_columns_values_4_q <= select_3686;
      box_explained_sum_sums_values_0_q <= select_3707;
      box_shown_sum_sums_values_0_q <= equal_1469_s21_q ? box_shown_sum_sums_values_0_q : select_3724;
      box_nearer_sum_sums_values_0_q <= equal_1469_s21_q ? box_nearer_sum_sums_values_0_q : select_3742;
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
  logic patches_column_s22_q;
  logic patches_along_ends_s22_q;
  logic [10:0] patches_down_values_1_s22_q;
  logic [4:0] patches_summed_row_column_s22_q;
  logic [9:0] patches_read_row_differing_s22_q;
  logic patches_read_first_s22_q;
  logic [2:0] region_row_s22_q;
  logic [13:0] product_s22_q;
  logic centres_values_1_textured_s22_q;
  logic centres_values_1_of_skin_s22_q;
  logic [3:0] select_461_s22_q;
  logic [6:0] select_464_s22_q;
  logic [6:0] column_s22_q;
  logic and_498_s22_q;
  logic and_500_s22_q;
  logic equal_503_s22_q;
  logic whole_2_s22_q;
  logic so_s22_q;
  logic less_534_s22_q;
  logic less_535_s22_q;
  logic less_536_s22_q;
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
  logic and_565_s22_q;
  logic and_569_s22_q;
  logic difference_592_s22_q;
  logic [8:0] xor_593_s22_q;
  logic difference_595_s22_q;
  logic [8:0] xor_596_s22_q;
  logic difference_599_s22_q;
  logic [8:0] xor_600_s22_q;
  logic difference_603_s22_q;
  logic [8:0] xor_604_s22_q;
  logic difference_607_s22_q;
  logic [8:0] xor_608_s22_q;
  logic equal_1469_s22_q;
  logic not_1470_s22_q;
  logic shift_2_s22_q;
  logic equal_1514_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1520_s22_q;
  logic equal_1522_s22_q;
  logic equal_1524_s22_q;
  logic equal_1526_s22_q;
  logic equal_1528_s22_q;
  logic equal_1530_s22_q;
  logic equal_1532_s22_q;
  logic equal_1534_s22_q;
  logic equal_1536_s22_q;
  logic less_1545_s22_q;
  logic or_1549_s22_q;
  logic equal_1569_s22_q;
  logic and_1579_s22_q;
  logic and_1582_s22_q;
  logic select_1599_s22_q;
  logic equal_1600_s22_q;
  logic and_1608_s22_q;
  logic equal_1610_s22_q;
  logic equal_1631_s22_q;
  logic and_1642_s22_q;
  logic [5:0] select_1656_s22_q;
  logic [7:0] select_1681_s22_q;
  logic and_1688_s22_q;
  logic and_1689_s22_q;
  logic equal_1690_s22_q;
  logic not_1691_s22_q;
  logic equal_1692_s22_q;
  logic equal_1694_s22_q;
  logic or_1696_s22_q;
  logic and_1705_s22_q;
  logic [4:0] select_1720_s22_q;
  logic select_1726_s22_q;
  logic [3:0] select_1765_s22_q;
  logic new_row_s22_q;
  logic [1:0] down_2_s22_q;
  logic [12:0] sum_1791_s22_q;
  logic [11:0] smooth_s22_q;
  logic and_1817_s22_q;
  logic or_1821_s22_q;
  logic and_1829_s22_q;
  logic less_1830_s22_q;
  logic equal_1831_s22_q;
  logic not_1832_s22_q;
  logic equal_1833_s22_q;
  logic [9:0] patches_rows_rdata_s22_q;
  logic or_1851_s22_q;
  logic or_1854_s22_q;
  logic or_1857_s22_q;
  logic not_1859_s22_q;
  logic [9:0] sum_1873_s22_q;
  logic [9:0] sum_1878_s22_q;
  logic [9:0] sum_1884_s22_q;
  logic and_1885_s22_q;
  logic select_1900_s22_q;
  logic [3:0] difference_1935_s22_q;
  logic or_1943_s22_q;
  logic or_1946_s22_q;
  logic or_1949_s22_q;
  logic [4:0] around_s22_q;
  logic less_1988_s22_q;
  logic and_1999_s22_q;
  logic sum_2034_s22_q;
  logic [9:0] difference_2035_s22_q;
  logic sum_2042_s22_q;
  logic [9:0] difference_2043_s22_q;
  logic difference_2114_s22_q;
  logic [8:0] xor_2115_s22_q;
  logic difference_2117_s22_q;
  logic [8:0] xor_2118_s22_q;
  logic difference_2121_s22_q;
  logic [8:0] xor_2122_s22_q;
  logic difference_2125_s22_q;
  logic [8:0] xor_2126_s22_q;
  logic difference_2129_s22_q;
  logic [8:0] xor_2130_s22_q;
  logic equal_2139_s22_q;
  logic difference_2160_s22_q;
  logic [8:0] xor_2161_s22_q;
  logic difference_2172_s22_q;
  logic [8:0] xor_2173_s22_q;
  logic equal_2263_s22_q;
  logic and_2379_s22_q;
  logic and_2383_s22_q;
  logic and_2398_s22_q;
  logic not_2402_s22_q;
  logic [4:0] e_s22_q;
  logic [9:0] select_2428_s22_q;
  logic [9:0] select_2431_s22_q;
  logic and_2494_s22_q;
  logic and_2495_s22_q;
  logic [11:0] residual_s22_q;
  logic equal_2586_s22_q;
  logic and_2731_s22_q;
  logic or_2782_s22_q;
  logic not_2806_s22_q;
  logic [4:0] select_3281_s22_q;
  logic select_3288_s22_q;
  logic select_3297_s22_q;
  logic and_3303_s22_q;
  logic [14:0] select_3312_s22_q;
  logic equal_3434_s22_q;
  logic and_3607_s22_q;
  logic less_3608_s22_q;
  logic equal_3609_s22_q;
  logic equal_3625_s22_q;
  logic equal_3627_s22_q;
  logic equal_3628_s22_q;
  logic sum_4_s22_q;
  logic equal_3757_s22_q;
  logic equal_3842_s22_q;
  logic [9:0] select_3852_s22_q;
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
      patches_column_s22_q <= patches_column_s21_q;
      patches_along_ends_s22_q <= patches_along_ends_q;
      patches_down_values_1_s22_q <= patches_down_values_1_q;
      patches_summed_row_column_s22_q <= patches_summed_row_column_q;
      patches_read_row_differing_s22_q <= patches_read_row_differing_s21_q;
      patches_read_first_s22_q <= patches_read_first_s21_q;
      region_row_s22_q <= region_row_s21_q;
      product_s22_q <= product_q;
      centres_values_1_textured_s22_q <= centres_values_1_textured_s21_q;
      centres_values_1_of_skin_s22_q <= centres_values_1_of_skin_s21_q;
      select_461_s22_q <= select_461_s21_q;
      select_464_s22_q <= select_464_s21_q;
      column_s22_q <= column_s21_q;
      and_498_s22_q <= and_498_s21_q;
      and_500_s22_q <= and_500_s21_q;
      equal_503_s22_q <= equal_503_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      so_s22_q <= so_s21_q;
      less_534_s22_q <= less_534;
      less_535_s22_q <= less_535;
      less_536_s22_q <= less_536;
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
      and_565_s22_q <= and_565_s21_q;
      and_569_s22_q <= and_569;
      difference_592_s22_q <= difference_592[9];
      xor_593_s22_q <= difference_592[8:0] ^ {9{difference_592[9]}};
      difference_595_s22_q <= difference_595[9];
      xor_596_s22_q <= difference_595[8:0] ^ {9{difference_595[9]}};
      difference_599_s22_q <= difference_599[9];
      xor_600_s22_q <= difference_599[8:0] ^ {9{difference_599[9]}};
      difference_603_s22_q <= difference_603[9];
      xor_604_s22_q <= difference_603[8:0] ^ {9{difference_603[9]}};
      difference_607_s22_q <= difference_607[9];
      xor_608_s22_q <= difference_607[8:0] ^ {9{difference_607[9]}};
      equal_1469_s22_q <= equal_1469_s21_q;
      not_1470_s22_q <= not_1470_s21_q;
      shift_2_s22_q <= shift_2_s21_q[0];
      equal_1514_s22_q <= equal_1514_s21_q;
      all_s22_q <= all_s21_q;
      sum_1520_s22_q <= sum_1520_s21_q;
      equal_1522_s22_q <= equal_1522_s21_q;
      equal_1524_s22_q <= equal_1524_s21_q;
      equal_1526_s22_q <= equal_1526_s21_q;
      equal_1528_s22_q <= equal_1528_s21_q;
      equal_1530_s22_q <= equal_1530_s21_q;
      equal_1532_s22_q <= equal_1532_s21_q;
      equal_1534_s22_q <= equal_1534_s21_q;
      equal_1536_s22_q <= equal_1536_s21_q;
      less_1545_s22_q <= less_1545_s21_q;
      or_1549_s22_q <= or_1549_s21_q;
      equal_1569_s22_q <= (registration_fresh_q & select_1567_s21_q) == 4'h0;
      and_1579_s22_q <= not_1470_s21_q & and_1563;
      and_1582_s22_q <= and_1582_s21_q;
      select_1599_s22_q <= select_1599_s21_q;
      equal_1600_s22_q <= equal_1600_s21_q;
      and_1608_s22_q <= and_1608_s21_q;
      equal_1610_s22_q <= equal_1610_s21_q;
      equal_1631_s22_q <= equal_1631_s21_q;
      and_1642_s22_q <= and_1642;
      select_1656_s22_q <= select_1656_s21_q;
      select_1681_s22_q <= select_1681_s21_q;
      and_1688_s22_q <= and_1688_s21_q;
      and_1689_s22_q <= and_1689_s21_q;
      equal_1690_s22_q <= equal_1690_s21_q;
      not_1691_s22_q <= not_1691_s21_q;
      equal_1692_s22_q <= equal_1692_s21_q;
      equal_1694_s22_q <= equal_1694_s21_q;
      or_1696_s22_q <= or_1696_s21_q;
      and_1705_s22_q <= and_1705_s21_q;
      select_1720_s22_q <= select_1720_s21_q;
      select_1726_s22_q <= select_1726_s21_q;
      select_1765_s22_q <= select_1765_s21_q;
      new_row_s22_q <= new_row;
      down_2_s22_q <= down_2_s21_q[1:0];
      sum_1791_s22_q <= sum_1791;
      smooth_s22_q <= smooth;
      and_1817_s22_q <= and_1817_s21_q;
      or_1821_s22_q <= or_1821_s21_q;
      and_1829_s22_q <= and_1829_s21_q;
      less_1830_s22_q <= less_1830_s21_q;
      equal_1831_s22_q <= equal_1831_s21_q;
      not_1832_s22_q <= not_1832_s21_q;
      equal_1833_s22_q <= equal_1833_s21_q;
      patches_rows_rdata_s22_q <= patches_rows_rdata_s21_q;
      or_1851_s22_q <= or_1851_s21_q;
      or_1854_s22_q <= or_1854_s21_q;
      or_1857_s22_q <= or_1857_s21_q;
      not_1859_s22_q <= not_1859_s21_q;
      sum_1873_s22_q <= sum_1873;
      sum_1878_s22_q <= sum_1878;
      sum_1884_s22_q <= sum_1884;
      and_1885_s22_q <= and_1885_s21_q;
      select_1900_s22_q <= select_1900;
      difference_1935_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1934};
      or_1943_s22_q <= or_1943_s21_q;
      or_1946_s22_q <= or_1946_s21_q;
      or_1949_s22_q <= or_1949_s21_q;
      around_s22_q <= around;
      less_1988_s22_q <= {1'b0, around[4:1]} < n;
      and_1999_s22_q <= and_1999_s21_q;
      sum_2034_s22_q <= sum_2034[0];
      difference_2035_s22_q <= {1'b0, sum_2034[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2042_s22_q <= sum_2042[0];
      difference_2043_s22_q <= {1'b0, sum_2042[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2114_s22_q <= difference_2114[9];
      xor_2115_s22_q <= difference_2114[8:0] ^ {9{difference_2114[9]}};
      difference_2117_s22_q <= difference_2117[9];
      xor_2118_s22_q <= difference_2117[8:0] ^ {9{difference_2117[9]}};
      difference_2121_s22_q <= difference_2121[9];
      xor_2122_s22_q <= difference_2121[8:0] ^ {9{difference_2121[9]}};
      difference_2125_s22_q <= difference_2125[9];
      xor_2126_s22_q <= difference_2125[8:0] ^ {9{difference_2125[9]}};
      difference_2129_s22_q <= difference_2129[9];
      xor_2130_s22_q <= difference_2129[8:0] ^ {9{difference_2129[9]}};
      equal_2139_s22_q <= equal_2139_s21_q;
      difference_2160_s22_q <= difference_2160[9];
      xor_2161_s22_q <= difference_2160[8:0] ^ {9{difference_2160[9]}};
      difference_2172_s22_q <= difference_2172[9];
      xor_2173_s22_q <= difference_2172[8:0] ^ {9{difference_2172[9]}};
      equal_2263_s22_q <= equal_2263_s21_q;
      and_2379_s22_q <= and_2379_s21_q;
      and_2383_s22_q <= and_2383_s21_q;
      and_2398_s22_q <= and_2398;
      not_2402_s22_q <= not_2402_s21_q;
      e_s22_q <= e;
      select_2428_s22_q <= less_2427 ? 10'h0 : regions_rdata_s21_q[9:0];
      select_2431_s22_q <= less_2427 ? 10'h0 : regions_rdata_s21_q[19:10];
      and_2494_s22_q <= and_2494_s21_q;
      and_2495_s22_q <= shift_2_s21_q[1] & less_1609_s21_q;
      residual_s22_q <= residual;
      equal_2586_s22_q <= (registration_fresh_q & select_2584) == 4'h0;
      and_2731_s22_q <= and_2731_s21_q;
      or_2782_s22_q <= or_2782_s21_q;
      not_2806_s22_q <= not_2806_s21_q;
      select_3281_s22_q <= select_3281_s21_q;
      select_3288_s22_q <= select_3288;
      select_3297_s22_q <= select_3297;
      and_3303_s22_q <= equal_3277_s21_q & ({sum_3301[6], sum_3301} < 8'hfb);
      select_3312_s22_q <= select_3312_s21_q;
      equal_3434_s22_q <= equal_3434_s21_q;
      and_3607_s22_q <= and_3607_s21_q;
      less_3608_s22_q <= counts_explained_q < product_q;
      equal_3609_s22_q <= counts_explained_q == product_q;
      equal_3625_s22_q <= equal_3625_s21_q;
      equal_3627_s22_q <= equal_3627_s21_q;
      equal_3628_s22_q <= equal_3628_s21_q;
      sum_4_s22_q <= sum_4[0];
      equal_3757_s22_q <= equal_3757_s21_q;
      equal_3842_s22_q <= (registration_fresh_q & select_3840) == 4'h0;
      select_3852_s22_q <= less_2427 ? 10'h0 : regions_rdata_s21_q[29:20];
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
  logic patches_match_row_ends_q;
  logic [11:0] patches_smooth_values_0_q;
  logic [11:0] patches_smooth_values_1_q;
  logic [11:0] patches_smooth_values_2_q;
  logic [11:0] patches_smooth_values_3_q;
  logic [10:0] patches_down_values_2_q;
  logic [10:0] patches_down_values_3_q;
  logic [4:0] patches_down_by_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic [4:0] patches_summed_down_by_q;
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
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_569_s22_q;
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
  logic [9:0] sum_594;
  assign sum_594 = {9'h0, difference_592_s22_q} + {1'b0, xor_593_s22_q};
  logic [9:0] sum_597;
  assign sum_597 = {9'h0, difference_595_s22_q} + {1'b0, xor_596_s22_q};
  // hls/stages/patches.hpp:314
  logic and_1646;
  assign and_1646 = not_1470_s22_q & (so_s22_q & (ends_cell_s22_q & (shift_2_s22_q & and_1642_s22_q)));
  logic [7:0] select_1651;
  assign select_1651 = so_s22_q ? (ends_cell_s22_q ? (shift_2_s22_q ? x_s22_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:160
  logic and_1784;
  assign and_1784 = not_1691_s22_q & (equal_1692_s22_q & new_row_s22_q);
  // hls/stages/patches.hpp:434
  logic [13:0] sum_1792;
  assign sum_1792 = {{3{patches_down_values_1_s22_q[10]}}, patches_down_values_1_s22_q} + {sum_1791_s22_q, down_2_s22_q[1]};
  logic [12:0] sum_1793;
  assign sum_1793 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1792[13:1];
  // hls/stages/patches.hpp:433
  logic [12:0] sum_1802;
  assign sum_1802 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s22_q[11:1]};
  logic [12:0] sum_1803;
  assign sum_1803 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1804;
  assign difference_1804 = {1'b0, sum_1802, smooth_s22_q[0]} - {1'b0, sum_1803, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_1900_s22_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1217
  logic [6:0] select_1903;
  assign select_1903 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1227
  logic equal_1906;
  assign equal_1906 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1200
  logic not_1913;
  assign not_1913 = ~marks_first_s22_q;
  // hls/stages/agreement.hpp:1036
  logic [4:0] t;
  assign t = {difference_1935_s22_q[3], difference_1935_s22_q} + (equal_1631_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1043
  logic not_1950;
  assign not_1950 = ~region_row_s22_q[2];
  logic [2:0] select_1951;
  assign select_1951 = region_row_s22_q[1] ? {1'b0, not_1950, 1'b0} : {region_row_s22_q[2], 1'b0, not_1950};
  logic [5:0] select_1952;
  assign select_1952 = region_row_s22_q[0] ? {select_1951[2], 1'b0, select_1951[1], 1'b0, select_1951[0], 1'b0} : {1'b0, select_1951[2], 1'b0, select_1951[1], 1'b0, select_1951[0]};
  logic [11:0] select_1953;
  assign select_1953 = or_1949_s22_q ? {select_1952[5], 1'b0, select_1952[4], 1'b0, select_1952[3], 1'b0, select_1952[2], 1'b0, select_1952[1], 1'b0, select_1952[0], 1'b0} : {1'b0, select_1952[5], 1'b0, select_1952[4], 1'b0, select_1952[3], 1'b0, select_1952[2], 1'b0, select_1952[1], 1'b0, select_1952[0]};
  logic [23:0] select_1954;
  assign select_1954 = or_1946_s22_q ? {select_1953[11], 1'b0, select_1953[10], 1'b0, select_1953[9], 1'b0, select_1953[8], 1'b0, select_1953[7], 1'b0, select_1953[6], 1'b0, select_1953[5], 1'b0, select_1953[4], 1'b0, select_1953[3], 1'b0, select_1953[2], 1'b0, select_1953[1], 1'b0, select_1953[0], 1'b0} : {1'b0, select_1953[11], 1'b0, select_1953[10], 1'b0, select_1953[9], 1'b0, select_1953[8], 1'b0, select_1953[7], 1'b0, select_1953[6], 1'b0, select_1953[5], 1'b0, select_1953[4], 1'b0, select_1953[3], 1'b0, select_1953[2], 1'b0, select_1953[1], 1'b0, select_1953[0]};
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_1972;
  assign sum_1972 = {1'b0, around_s22_q} + {2'h0, around_s22_q[4:1]};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2036;
  assign xor_2036 = {difference_2035_s22_q[8:0], sum_2034_s22_q} ^ {10{difference_2035_s22_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2035_s22_q[9]} + {1'b0, xor_2036};
  logic [9:0] xor_2044;
  assign xor_2044 = {difference_2043_s22_q[8:0], sum_2042_s22_q} ^ {10{difference_2043_s22_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2043_s22_q[9]} + {1'b0, xor_2044};
  // hls/stages/agreement.hpp:507
  logic select_2059;
  assign select_2059 = and_500_s22_q ? whole_2_s22_q : census_columns_values_0_cell_0_mask_q;
  logic select_2075;
  assign select_2075 = and_500_s22_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2078;
  assign select_2078 = and_500_s22_q ? census_columns_values_0_cell_1_mask_s22_q : census_columns_values_1_cell_1_mask_q;
  logic select_2081;
  assign select_2081 = and_500_s22_q ? census_columns_values_0_cell_2_mask_s22_q : census_columns_values_1_cell_2_mask_q;
  logic select_2085;
  assign select_2085 = and_500_s22_q ? census_columns_values_0_cell_3_mask_s22_q : census_columns_values_1_cell_3_mask_q;
  logic select_2088;
  assign select_2088 = and_500_s22_q ? census_columns_values_0_cell_4_mask_s22_q : census_columns_values_1_cell_4_mask_q;
  logic select_2091;
  assign select_2091 = and_500_s22_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2094;
  assign select_2094 = and_500_s22_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_2116;
  assign sum_2116 = {9'h0, difference_2114_s22_q} + {1'b0, xor_2115_s22_q};
  logic [9:0] sum_2119;
  assign sum_2119 = {9'h0, difference_2117_s22_q} + {1'b0, xor_2118_s22_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2160_s22_q} + xor_2161_s22_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2172_s22_q} + xor_2173_s22_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2385;
  assign select_2385 = and_2379_s22_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2383_s22_q});
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2415;
  assign sum_2415 = {1'b0, e_s22_q} + {2'h0, e_s22_q[4:1]};
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2527;
  assign difference_2527 = 13'h0 - {residual_s22_q[11], residual_s22_q};
  logic less_2542;
  assign less_2542 = $signed(difference_2527) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:163
  logic select_2821;
  assign select_2821 = patches_along_ends_s22_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:160
  logic [11:0] select_2824;
  assign select_2824 = equal_1692_s22_q ? patches_smooth_values_0_q : (or_1696_s22_q ? smooth_s22_q : patches_smooth_values_0_q);
  logic [11:0] select_2826;
  assign select_2826 = or_1696_s22_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2828;
  assign select_2828 = equal_1690_s22_q ? patches_smooth_values_1_q : (equal_1692_s22_q ? patches_smooth_values_1_q : select_2826);
  logic [11:0] select_2829;
  assign select_2829 = or_1696_s22_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2831;
  assign select_2831 = equal_1690_s22_q ? patches_smooth_values_2_q : (equal_1692_s22_q ? patches_smooth_values_2_q : select_2829);
  logic [11:0] select_2832;
  assign select_2832 = or_1696_s22_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2834;
  assign select_2834 = equal_1690_s22_q ? patches_smooth_values_3_q : (equal_1692_s22_q ? patches_smooth_values_3_q : select_2832);
  logic [10:0] select_2841;
  assign select_2841 = or_1696_s22_q ? patches_down_values_1_s22_q : patches_down_values_2_q;
  logic [10:0] select_2843;
  assign select_2843 = equal_1690_s22_q ? patches_down_values_2_q : (equal_1692_s22_q ? patches_down_values_2_q : select_2841);
  logic [10:0] select_2844;
  assign select_2844 = or_1696_s22_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_2846;
  assign select_2846 = equal_1690_s22_q ? patches_down_values_3_q : (equal_1692_s22_q ? patches_down_values_3_q : select_2844);
  // hls/stages/patches.hpp:151
  logic and_2874;
  assign and_2874 = patches_along_ends_s22_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:389
  logic [3:0] select_2881;
  assign select_2881 = and_2874 ? 4'h0 : ({3'h0, patches_along_ends_s22_q} + patches_match_row_q);
  // hls/stages/patches.hpp:160
  logic [4:0] select_3237;
  assign select_3237 = equal_1690_s22_q ? patches_summed_down_by_q : (equal_1692_s22_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:500
  logic select_3290;
  assign select_3290 = less_1830_s22_q ? (not_1832_s22_q & select_3288_s22_q) : select_3288_s22_q;
  logic select_3299;
  assign select_3299 = less_1830_s22_q ? (not_1832_s22_q & select_3297_s22_q) : select_3297_s22_q;
  // hls/stages/patches.hpp:496
  logic [9:0] select_3305;
  assign select_3305 = less_1830_s22_q ? (and_3303_s22_q ? patches_rows_rdata_s22_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:481
  logic [9:0] select_3316;
  assign select_3316 = patches_read_above_q ? patches_read_row_differing_s22_q : patches_peak_above_q;
  // hls/stages/patches.hpp:482
  logic [9:0] select_3318;
  assign select_3318 = patches_read_below_q ? patches_read_row_differing_s22_q : patches_peak_below_q;
  // hls/stages/patches.hpp:519
  logic less_3355;
  assign less_3355 = select_3316 < select_3318;
  // hls/stages/patches.hpp:520
  logic [9:0] high;
  assign high = less_3355 ? select_3318 : select_3316;
  logic [9:0] low;
  assign low = (select_3318 < select_3316) ? select_3318 : select_3316;
  // hls/stages/agreement.hpp:1126
  logic or_3604;
  assign or_3604 = ({counts_textured_s22_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s22_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = less_3608_s22_q | (product_rest_q & equal_3609_s22_q);
  // hls/stages/agreement.hpp:1158
  logic select_3612;
  assign select_3612 = and_3607_s22_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_3615;
  assign sum_3615 = {1'b0, select_2431_s22_q} + {2'h0, select_2431_s22_q[9:1]};
  // hls/stages/patches.hpp:314
  logic select_3659;
  assign select_3659 = equal_1469_s22_q ? (equal_3434_s22_q ? sum_4_s22_q : (product_rest_q | sum_4_s22_q)) : product_rest_q;
  logic [4:0] select_3688;
  assign select_3688 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_3689;
  assign select_3689 = equal_1469_s22_q ? box_textured_sum_sums_values_0_q : select_3688;
  // hls/stages/agreement.hpp:1226
  logic [3:0] select_3774;
  assign select_3774 = select_1900_s22_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3780;
  assign select_3780 = marks_first_s22_q ? (less_3776 ? {sum_3777, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory patches_right_codes, 28 x 112, DISTANCE 24, hls/stages/patches.hpp:714; read in stage 22, written in stage 24: 22 < 24 < 22 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [111:0] patches_right_codes_mem [0:27];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 28; i++) patches_right_codes_mem[i] = 112'h0;
`endif
  logic [4:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = patches_down_by_q + {1'b0, patches_match_row_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s22_en & and_1784;
  logic [111:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:715; read in stage 22, written in stage 24: 22 < 24 < 22 + DISTANCE.
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
  assign patches_left_codes_re = s22_en & and_1784;
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s22_q, or_1857_s22_q, or_1854_s22_q, or_1851_s22_q};
  logic regions_we;
  assign regions_we = s22_en & and_1885_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1884_s22_q, sum_1878_s22_q, sum_1873_s22_q};
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
      patches_match_row_ends_q <= 1'b0;
      patches_smooth_values_0_q <= 12'h0;
      patches_smooth_values_1_q <= 12'h0;
      patches_smooth_values_2_q <= 12'h0;
      patches_smooth_values_3_q <= 12'h0;
      patches_down_values_2_q <= 11'h0;
      patches_down_values_3_q <= 11'h0;
      patches_down_by_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_last_q <= 1'b0;
      patches_summed_down_by_q <= 5'h0;
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
      counts_supervised_q <= select_2385;
      patches_match_row_ends_q <= not_2806_s22_q & select_2821;
      patches_smooth_values_0_q <= equal_1690_s22_q ? patches_smooth_values_0_q : select_2824;
      patches_smooth_values_1_q <= select_2828;
      patches_smooth_values_2_q <= select_2831;
      patches_smooth_values_3_q <= select_2834;
      patches_down_values_2_q <= select_2843;
      patches_down_values_3_q <= select_2846;
      patches_down_by_q <= or_2782_s22_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2874});
      patches_match_row_q <= or_2782_s22_q ? 4'h0 : select_2881;
      patches_summed_last_q <= not_1691_s22_q & (equal_1692_s22_q & and_2874);
      patches_summed_down_by_q <= select_3237;
      patches_read_above_q <= equal_1690_s22_q ? select_3290 : patches_read_above_q;
      patches_read_below_q <= equal_1690_s22_q ? select_3299 : patches_read_below_q;
      patches_peak_above_q <= equal_1690_s22_q ? select_3316 : patches_peak_above_q;
      patches_peak_below_q <= equal_1690_s22_q ? select_3318 : patches_peak_below_q;
      product_rest_q <= select_3659;
      disagree_q <= equal_1469_s22_q ? select_3612 : disagree_q;
      began_q <= not_1913 & (began_q | select_1900_s22_q);
      seen_x_q <= select_1900_s22_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s22_q ? 4'h0 : select_3774;
      seen_column_q <= select_1900_s22_q ? 8'h0 : (seen_column_q + {7'h0, equal_1906});
      seen_rows_left_q <= select_3780;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s22_q ? 13'h0 : (seen_base_q + {6'h0, select_1903});
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
      census_columns_values_0_cell_0_mask_q <= select_2059;
      census_columns_values_1_cell_0_mask_q <= select_2075;
      census_columns_values_1_cell_1_mask_q <= select_2078;
      census_columns_values_1_cell_2_mask_q <= select_2081;
      census_columns_values_1_cell_3_mask_q <= select_2085;
      census_columns_values_1_cell_4_mask_q <= select_2088;
      census_columns_values_2_cell_0_mask_q <= select_2091;
      census_columns_values_2_cell_1_mask_q <= select_2094;
      box_textured_sum_sums_values_0_q <= select_3689;
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
  logic patches_column_s23_q;
  logic [10:0] patches_down_values_3_s23_q;
  logic [4:0] patches_summed_row_column_s23_q;
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic patches_read_first_s23_q;
  logic [13:0] product_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic [3:0] select_461_s23_q;
  logic [6:0] select_464_s23_q;
  logic [6:0] column_s23_q;
  logic and_498_s23_q;
  logic and_500_s23_q;
  logic equal_503_s23_q;
  logic whole_2_s23_q;
  logic so_s23_q;
  logic less_534_s23_q;
  logic less_535_s23_q;
  logic less_536_s23_q;
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
  logic and_565_s23_q;
  logic whole_9_s23_q;
  logic [10:0] sum_598_s23_q;
  logic [9:0] sum_601_s23_q;
  logic [9:0] sum_605_s23_q;
  logic [9:0] sum_609_s23_q;
  logic equal_1469_s23_q;
  logic not_1470_s23_q;
  logic equal_1514_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1520_s23_q;
  logic equal_1522_s23_q;
  logic equal_1524_s23_q;
  logic equal_1526_s23_q;
  logic equal_1528_s23_q;
  logic equal_1530_s23_q;
  logic equal_1532_s23_q;
  logic equal_1534_s23_q;
  logic equal_1536_s23_q;
  logic less_1545_s23_q;
  logic or_1549_s23_q;
  logic [31:0] registration_sums_rdata_s23_q;
  logic equal_1569_s23_q;
  logic and_1579_s23_q;
  logic and_1582_s23_q;
  logic select_1599_s23_q;
  logic equal_1600_s23_q;
  logic [22:0] patches_choices_rdata_s23_q;
  logic and_1608_s23_q;
  logic equal_1610_s23_q;
  logic and_1646_s23_q;
  logic [7:0] select_1652_s23_q;
  logic [5:0] select_1656_s23_q;
  logic [7:0] select_1681_s23_q;
  logic and_1688_s23_q;
  logic and_1689_s23_q;
  logic equal_1690_s23_q;
  logic equal_1692_s23_q;
  logic equal_1694_s23_q;
  logic or_1696_s23_q;
  logic and_1705_s23_q;
  logic [4:0] select_1720_s23_q;
  logic select_1726_s23_q;
  logic [3:0] select_1765_s23_q;
  logic new_row_s23_q;
  logic down_2_s23_q;
  logic sum_1792_s23_q;
  logic [12:0] sum_1793_s23_q;
  logic [14:0] difference_1804_s23_q;
  logic and_1817_s23_q;
  logic or_1821_s23_q;
  logic and_1829_s23_q;
  logic less_1830_s23_q;
  logic equal_1831_s23_q;
  logic not_1832_s23_q;
  logic equal_1833_s23_q;
  logic not_1859_s23_q;
  logic not_1913_s23_q;
  logic [7:0] sum_1923_s23_q;
  logic equal_1938_s23_q;
  logic or_1943_s23_q;
  logic [23:0] select_1954_s23_q;
  logic not_1974_s23_q;
  logic less_1988_s23_q;
  logic and_1999_s23_q;
  logic [10:0] size_s23_q;
  logic [10:0] size_2_s23_q;
  logic [10:0] sum_2120_s23_q;
  logic [9:0] sum_2123_s23_q;
  logic [9:0] sum_2127_s23_q;
  logic [9:0] sum_2131_s23_q;
  logic equal_2139_s23_q;
  logic [8:0] contrast_s23_q;
  logic [8:0] contrast_2_s23_q;
  logic equal_2192_s23_q;
  logic equal_2263_s23_q;
  logic and_2379_s23_q;
  logic and_2398_s23_q;
  logic not_2402_s23_q;
  logic not_2417_s23_q;
  logic [9:0] select_2428_s23_q;
  logic [9:0] select_2431_s23_q;
  logic and_2494_s23_q;
  logic and_2495_s23_q;
  logic [7:0] residual_s23_q;
  logic less_2528_s23_q;
  logic less_2542_s23_q;
  logic equal_2586_s23_q;
  logic and_2731_s23_q;
  logic equal_3193_s23_q;
  logic [4:0] select_3281_s23_q;
  logic [9:0] select_3305_s23_q;
  logic [14:0] select_3312_s23_q;
  logic less_3355_s23_q;
  logic [9:0] high_s23_q;
  logic [9:0] low_s23_q;
  logic equal_3434_s23_q;
  logic equal_3601_s23_q;
  logic or_3604_s23_q;
  logic select_3612_s23_q;
  logic not_3617_s23_q;
  logic equal_3625_s23_q;
  logic equal_3627_s23_q;
  logic equal_3628_s23_q;
  logic equal_3757_s23_q;
  logic equal_3842_s23_q;
  logic [9:0] select_3852_s23_q;
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
      patches_column_s23_q <= patches_column_s22_q;
      patches_down_values_3_s23_q <= patches_down_values_3_q;
      patches_summed_row_column_s23_q <= patches_summed_row_column_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_q;
      patches_read_first_s23_q <= patches_read_first_s22_q;
      product_s23_q <= product_s22_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_s22_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_s22_q;
      select_461_s23_q <= select_461_s22_q;
      select_464_s23_q <= select_464_s22_q;
      column_s23_q <= column_s22_q;
      and_498_s23_q <= and_498_s22_q;
      and_500_s23_q <= and_500_s22_q;
      equal_503_s23_q <= equal_503_s22_q;
      whole_2_s23_q <= whole_2_s22_q;
      so_s23_q <= so_s22_q;
      less_534_s23_q <= less_534_s22_q;
      less_535_s23_q <= less_535_s22_q;
      less_536_s23_q <= less_536_s22_q;
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
      and_565_s23_q <= and_565_s22_q;
      whole_9_s23_q <= whole_9;
      sum_598_s23_q <= {1'b0, sum_594} + {1'b0, sum_597};
      sum_601_s23_q <= {9'h0, difference_599_s22_q} + {1'b0, xor_600_s22_q};
      sum_605_s23_q <= {9'h0, difference_603_s22_q} + {1'b0, xor_604_s22_q};
      sum_609_s23_q <= {9'h0, difference_607_s22_q} + {1'b0, xor_608_s22_q};
      equal_1469_s23_q <= equal_1469_s22_q;
      not_1470_s23_q <= not_1470_s22_q;
      equal_1514_s23_q <= equal_1514_s22_q;
      all_s23_q <= all_s22_q;
      sum_1520_s23_q <= sum_1520_s22_q;
      equal_1522_s23_q <= equal_1522_s22_q;
      equal_1524_s23_q <= equal_1524_s22_q;
      equal_1526_s23_q <= equal_1526_s22_q;
      equal_1528_s23_q <= equal_1528_s22_q;
      equal_1530_s23_q <= equal_1530_s22_q;
      equal_1532_s23_q <= equal_1532_s22_q;
      equal_1534_s23_q <= equal_1534_s22_q;
      equal_1536_s23_q <= equal_1536_s22_q;
      less_1545_s23_q <= less_1545_s22_q;
      or_1549_s23_q <= or_1549_s22_q;
      registration_sums_rdata_s23_q <= registration_sums_rdata_q;
      equal_1569_s23_q <= equal_1569_s22_q;
      and_1579_s23_q <= and_1579_s22_q;
      and_1582_s23_q <= and_1582_s22_q;
      select_1599_s23_q <= select_1599_s22_q;
      equal_1600_s23_q <= equal_1600_s22_q;
      patches_choices_rdata_s23_q <= patches_choices_rdata_q;
      and_1608_s23_q <= and_1608_s22_q;
      equal_1610_s23_q <= equal_1610_s22_q;
      and_1646_s23_q <= and_1646;
      select_1652_s23_q <= equal_1469_s22_q ? 8'h0 : select_1651;
      select_1656_s23_q <= select_1656_s22_q;
      select_1681_s23_q <= select_1681_s22_q;
      and_1688_s23_q <= and_1688_s22_q;
      and_1689_s23_q <= and_1689_s22_q;
      equal_1690_s23_q <= equal_1690_s22_q;
      equal_1692_s23_q <= equal_1692_s22_q;
      equal_1694_s23_q <= equal_1694_s22_q;
      or_1696_s23_q <= or_1696_s22_q;
      and_1705_s23_q <= and_1705_s22_q;
      select_1720_s23_q <= select_1720_s22_q;
      select_1726_s23_q <= select_1726_s22_q;
      select_1765_s23_q <= select_1765_s22_q;
      new_row_s23_q <= new_row_s22_q;
      down_2_s23_q <= down_2_s22_q[0];
      sum_1792_s23_q <= sum_1792[0];
      sum_1793_s23_q <= sum_1793;
      difference_1804_s23_q <= difference_1804;
      and_1817_s23_q <= and_1817_s22_q;
      or_1821_s23_q <= or_1821_s22_q;
      and_1829_s23_q <= and_1829_s22_q;
      less_1830_s23_q <= less_1830_s22_q;
      equal_1831_s23_q <= equal_1831_s22_q;
      not_1832_s23_q <= not_1832_s22_q;
      equal_1833_s23_q <= equal_1833_s22_q;
      not_1859_s23_q <= not_1859_s22_q;
      not_1913_s23_q <= not_1913;
      sum_1923_s23_q <= {2'h0, x_s22_q[7:2]} + 8'hff;
      equal_1938_s23_q <= t[4:1] == 4'h0;
      or_1943_s23_q <= or_1943_s22_q;
      select_1954_s23_q <= select_1954;
      not_1974_s23_q <= ~({sum_1972, around_s22_q[0]} < {2'h0, t});
      less_1988_s23_q <= less_1988_s22_q;
      and_1999_s23_q <= and_1999_s22_q;
      size_s23_q <= size;
      size_2_s23_q <= size_2;
      sum_2120_s23_q <= {1'b0, sum_2116} + {1'b0, sum_2119};
      sum_2123_s23_q <= {9'h0, difference_2121_s22_q} + {1'b0, xor_2122_s22_q};
      sum_2127_s23_q <= {9'h0, difference_2125_s22_q} + {1'b0, xor_2126_s22_q};
      sum_2131_s23_q <= {9'h0, difference_2129_s22_q} + {1'b0, xor_2130_s22_q};
      equal_2139_s23_q <= equal_2139_s22_q;
      contrast_s23_q <= contrast;
      contrast_2_s23_q <= contrast_2;
      equal_2192_s23_q <= x_s22_q[7:3] == 5'h0;
      equal_2263_s23_q <= equal_2263_s22_q;
      and_2379_s23_q <= and_2379_s22_q;
      and_2398_s23_q <= and_2398_s22_q;
      not_2402_s23_q <= not_2402_s22_q;
      not_2417_s23_q <= ~({sum_2415, e_s22_q[0]} < {2'h0, t});
      select_2428_s23_q <= select_2428_s22_q;
      select_2431_s23_q <= select_2431_s22_q;
      and_2494_s23_q <= and_2494_s22_q;
      and_2495_s23_q <= and_2495_s22_q;
      residual_s23_q <= residual_s22_q[7:0];
      less_2528_s23_q <= $signed(difference_2527) < $signed({7'h0, cfg_moved_limit_i});
      less_2542_s23_q <= less_2542;
      equal_2586_s23_q <= equal_2586_s22_q;
      and_2731_s23_q <= and_2731_s22_q;
      equal_3193_s23_q <= patches_match_row_q == 4'h0;
      select_3281_s23_q <= select_3281_s22_q;
      select_3305_s23_q <= select_3305;
      select_3312_s23_q <= select_3312_s22_q;
      less_3355_s23_q <= less_3355;
      high_s23_q <= high;
      low_s23_q <= low;
      equal_3434_s23_q <= equal_3434_s22_q;
      equal_3601_s23_q <= select_2428_s22_q[9:3] == 7'h0;
      or_3604_s23_q <= or_3604;
      select_3612_s23_q <= select_3612;
      not_3617_s23_q <= ~({sum_3615, select_2431_s22_q[0]} < {2'h0, select_2428_s22_q});
      equal_3625_s23_q <= equal_3625_s22_q;
      equal_3627_s23_q <= equal_3627_s22_q;
      equal_3628_s23_q <= equal_3628_s22_q;
      equal_3757_s23_q <= equal_3757_s22_q;
      equal_3842_s23_q <= equal_3842_s22_q;
      select_3852_s23_q <= select_3852_s22_q;
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
  logic [10:0] sum_602;
  assign sum_602 = sum_598_s23_q + {1'b0, sum_601_s23_q};
  // hls/stages/patches.hpp:133
  logic and_1648;
  assign and_1648 = and_1646_s23_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:317
  logic [22:0] select_1682;
  assign select_1682 = and_1648 ? {select_1681_s23_q, select_1656_s23_q, select_1652_s23_q, and_1646_s23_q} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:434
  logic [14:0] sum_1794;
  assign sum_1794 = {{4{patches_down_values_3_s23_q[10]}}, patches_down_values_3_s23_q} + {sum_1793_s23_q, sum_1792_s23_q, down_2_s23_q};
  // hls/stages/agreement.hpp:1234
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1201
  logic select_1911;
  assign select_1911 = marks_first_s23_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1187
  logic [10:0] sum_1912;
  assign sum_1912 = {1'b0, {5{select_1911}}, 1'b0, {2{select_1911}}, 1'b0, select_1911} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1053
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1923_s23_q[7]}}, sum_1923_s23_q, x_s23_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1187
  logic [10:0] sum_1925;
  assign sum_1925 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1043
  logic [47:0] select_1955;
  assign select_1955 = or_1943_s23_q ? {select_1954_s23_q[23], 1'b0, select_1954_s23_q[22], 1'b0, select_1954_s23_q[21], 1'b0, select_1954_s23_q[20], 1'b0, select_1954_s23_q[19], 1'b0, select_1954_s23_q[18], 1'b0, select_1954_s23_q[17], 1'b0, select_1954_s23_q[16], 1'b0, select_1954_s23_q[15], 1'b0, select_1954_s23_q[14], 1'b0, select_1954_s23_q[13], 1'b0, select_1954_s23_q[12], 1'b0, select_1954_s23_q[11], 1'b0, select_1954_s23_q[10], 1'b0, select_1954_s23_q[9], 1'b0, select_1954_s23_q[8], 1'b0, select_1954_s23_q[7], 1'b0, select_1954_s23_q[6], 1'b0, select_1954_s23_q[5], 1'b0, select_1954_s23_q[4], 1'b0, select_1954_s23_q[3], 1'b0, select_1954_s23_q[2], 1'b0, select_1954_s23_q[1], 1'b0, select_1954_s23_q[0], 1'b0} : {1'b0, select_1954_s23_q[23], 1'b0, select_1954_s23_q[22], 1'b0, select_1954_s23_q[21], 1'b0, select_1954_s23_q[20], 1'b0, select_1954_s23_q[19], 1'b0, select_1954_s23_q[18], 1'b0, select_1954_s23_q[17], 1'b0, select_1954_s23_q[16], 1'b0, select_1954_s23_q[15], 1'b0, select_1954_s23_q[14], 1'b0, select_1954_s23_q[13], 1'b0, select_1954_s23_q[12], 1'b0, select_1954_s23_q[11], 1'b0, select_1954_s23_q[10], 1'b0, select_1954_s23_q[9], 1'b0, select_1954_s23_q[8], 1'b0, select_1954_s23_q[7], 1'b0, select_1954_s23_q[6], 1'b0, select_1954_s23_q[5], 1'b0, select_1954_s23_q[4], 1'b0, select_1954_s23_q[3], 1'b0, select_1954_s23_q[2], 1'b0, select_1954_s23_q[1], 1'b0, select_1954_s23_q[0]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s23_q} + (equal_503_s23_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2041;
  assign select_2041 = sample_pair_whole_s23_q ? (and_498_s23_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s23_q} + (equal_503_s23_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2049;
  assign select_2049 = sample_pair_whole_s23_q ? (and_498_s23_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:507
  logic select_2097;
  assign select_2097 = and_500_s23_q ? census_columns_values_1_cell_2_mask_s23_q : census_columns_values_2_cell_2_mask_q;
  logic select_2100;
  assign select_2100 = and_500_s23_q ? census_columns_values_1_cell_3_mask_s23_q : census_columns_values_2_cell_3_mask_q;
  logic select_2103;
  assign select_2103 = and_500_s23_q ? census_columns_values_1_cell_4_mask_s23_q : census_columns_values_2_cell_4_mask_q;
  logic select_2104;
  assign select_2104 = and_500_s23_q ? census_columns_values_2_cell_0_mask_s23_q : census_columns_values_3_cell_0_mask_q;
  logic select_2107;
  assign select_2107 = and_500_s23_q ? census_columns_values_2_cell_1_mask_s23_q : census_columns_values_3_cell_1_mask_q;
  logic select_2108;
  assign select_2108 = and_500_s23_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2111;
  assign select_2111 = and_500_s23_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_2124;
  assign sum_2124 = sum_2120_s23_q + {1'b0, sum_2123_s23_q};
  // hls/stages/agreement.hpp:507
  logic select_2156;
  assign select_2156 = and_500_s23_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2159;
  assign and_2159 = whole_2_s23_q & (~(column_s23_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
  logic and_2165;
  assign and_2165 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s23_q[8:2]));
  logic and_2166;
  assign and_2166 = and_2159 & and_2165;
  logic and_2177;
  assign and_2177 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s23_q[8:2]));
  logic and_2178;
  assign and_2178 = and_2159 & and_2177;
  // hls/stages/census.hpp:409
  logic not_2195;
  assign not_2195 = ~x_s23_q[1];
  logic [2:0] select_2196;
  assign select_2196 = x_s23_q[0] ? {1'b0, not_2195, 1'b0} : {x_s23_q[1], 1'b0, not_2195};
  logic [5:0] select_2197;
  assign select_2197 = slot_s23_q[2] ? {select_2196[2], 1'b0, select_2196[1], 1'b0, select_2196[0], 1'b0} : {1'b0, select_2196[2], 1'b0, select_2196[1], 1'b0, select_2196[0]};
  logic [11:0] select_2198;
  assign select_2198 = slot_s23_q[1] ? {select_2197[5], 1'b0, select_2197[4], 1'b0, select_2197[3], 1'b0, select_2197[2], 1'b0, select_2197[1], 1'b0, select_2197[0], 1'b0} : {1'b0, select_2197[5], 1'b0, select_2197[4], 1'b0, select_2197[3], 1'b0, select_2197[2], 1'b0, select_2197[1], 1'b0, select_2197[0]};
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2400;
  assign select_2400 = and_2379_s23_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2398_s23_q});
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2432;
  assign sum_2432 = {1'b0, select_2431_s23_q} + {3'h0, select_2431_s23_q[9:2]};
  // hls/stages/registration.hpp:107
  logic [7:0] select_2510;
  assign select_2510 = equal_1610_s23_q ? (and_2495_s23_q ? residual_s23_q : 8'h0) : 8'h0;
  logic and_2521;
  assign and_2521 = and_2495_s23_q & ($signed(residual_s23_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2535;
  assign less_2535 = $signed(residual_s23_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2588;
  assign select_2588 = or_1549_s23_q ? 12'h0 : (equal_2586_s23_q ? registration_sums_rdata_s23_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2590;
  assign select_2590 = equal_1514_s23_q ? 12'h0 : (less_1545_s23_q ? select_2588 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2593;
  assign and_2593 = x_s23_q[1] & all_s23_q;
  // hls/stages/agreement.hpp:1084
  logic and_2596;
  assign and_2596 = not_1859_s23_q & (less_1545_s23_q & ({and_2593, x_s23_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2603;
  assign select_2603 = or_1549_s23_q ? 12'h0 : (equal_2586_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2605;
  assign select_2605 = equal_1514_s23_q ? 12'h0 : (less_1545_s23_q ? select_2603 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2611;
  assign not_2611 = ~all_s23_q;
  // hls/stages/agreement.hpp:1084
  logic and_2614;
  assign and_2614 = not_1859_s23_q & (less_1545_s23_q & (x_s23_q[2:0] == {all_s23_q, not_2611, 1'b0}));
  // hls/stages/patches.hpp:314
  logic and_2620;
  assign and_2620 = equal_1469_s23_q & (x_s23_q[6] & (not_1859_s23_q & (less_1545_s23_q & all_s23_q)));
  // hls/stages/registration.hpp:157
  logic equal_2647;
  assign equal_2647 = x_s23_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_2650;
  assign and_2650 = not_1859_s23_q & (less_1545_s23_q & (x_s23_q[5] ? x_s23_q[3] : equal_2647));
  logic and_2659;
  assign and_2659 = not_1859_s23_q & (less_1545_s23_q & ((~x_s23_q[5]) & (x_s23_q[3] & equal_2647)));
  // hls/stages/patches.hpp:319
  logic not_2721;
  assign not_2721 = ~and_1688_s23_q;
  // hls/stages/patches.hpp:497
  logic [9:0] select_3307;
  assign select_3307 = less_1830_s23_q ? (equal_1833_s23_q ? 10'h3ff : select_3305_s23_q) : 10'h3ff;
  // hls/stages/patches.hpp:500
  logic [9:0] select_3308;
  assign select_3308 = equal_1833_s23_q ? select_3307 : select_3305_s23_q;
  logic [9:0] select_3310;
  assign select_3310 = less_1830_s23_q ? (equal_1831_s23_q ? 10'h3ff : select_3308) : select_3308;
  // hls/stages/patches.hpp:521
  logic [9:0] eight;
  assign eight = high_s23_q - low_s23_q;
  logic [9:0] fall;
  assign fall = high_s23_q - select_3312_s23_q[9:0];
  // hls/stages/agreement.hpp:1086
  logic equal_3533;
  assign equal_3533 = x_s23_q == 7'h7f;
  // hls/stages/agreement.hpp:1077
  logic select_3618;
  assign select_3618 = equal_3601_s23_q ? ((~or_3604_s23_q) & (~select_3612_s23_q)) : not_3617_s23_q;
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_3620;
  assign select_3620 = x_s23_q[6] ? (equal_1514_s23_q ? good_q : {select_3618, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:447
  logic [12:0] select_3760;
  assign select_3760 = equal_2263_s23_q ? (equal_3757_s23_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3763;
  assign select_3763 = and_500_s23_q ? (equal_2263_s23_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3844;
  assign select_3844 = equal_1536_s23_q ? {2'h0, counts_explained_s23_q, 2'h0, counts_textured_s23_q} : (equal_3842_s23_q ? registration_sums_rdata_s23_q : 32'h0);
  logic [31:0] select_3845;
  assign select_3845 = equal_1534_s23_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s23_q} : select_3844;

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s23_q, and_1608_s23_q};
  logic patches_choices_we;
  assign patches_choices_we = s23_en & and_1689_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= select_1682;
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
      sharpness_before_last_mask_q <= select_2156;
      counts_nearer_q <= select_2400;
      patches_fixed_q <= not_2721 & (patches_fixed_q | (and_2731_s23_q & and_1648));
      patches_choice_valid_q <= and_1688_s23_q ? (select_1682[0] & not_2721) : select_1682[0];
      patches_choice_column_q <= select_1682[8:1];
      patches_choice_shift_q <= select_1682[14:9];
      patches_choice_slope_q <= select_1682[22:15];
      patches_read_far_q <= equal_1690_s23_q ? select_3310 : patches_read_far_q;
      good_q <= equal_1469_s23_q ? select_3620 : good_q;
      map_row_q <= and_500_s23_q ? select_3760 : map_row_q;
      map_width_q <= select_3763;
      write_half_q <= marks_first_s23_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1911;
      done_q <= not_1913_s23_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s23_q;
      said_q <= equal_1469_s23_q & equal_3533;
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
      averager_detail_0_q <= select_2041;
      averager_detail_1_q <= select_2049;
      census_columns_values_2_cell_2_mask_q <= select_2097;
      census_columns_values_2_cell_3_mask_q <= select_2100;
      census_columns_values_2_cell_4_mask_q <= select_2103;
      census_columns_values_3_cell_0_mask_q <= select_2104;
      census_columns_values_3_cell_1_mask_q <= select_2107;
      census_columns_values_3_cell_2_mask_q <= select_2108;
      census_columns_values_3_cell_3_mask_q <= select_2111;
      sharpness_last_mask_q <= and_500_s23_q ? whole_2_s23_q : sharpness_last_mask_q;
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
  logic patches_column_s24_q;
  logic [4:0] patches_summed_row_column_s24_q;
  logic patches_summed_last_s24_q;
  logic [4:0] patches_summed_down_by_s24_q;
  logic patches_read_first_s24_q;
  logic [9:0] patches_read_far_s24_q;
  logic [13:0] product_s24_q;
  logic centres_values_1_textured_s24_q;
  logic centres_values_1_of_skin_s24_q;
  logic done_s24_q;
  logic [3:0] select_461_s24_q;
  logic [6:0] select_464_s24_q;
  logic [6:0] column_s24_q;
  logic and_500_s24_q;
  logic less_534_s24_q;
  logic less_535_s24_q;
  logic less_536_s24_q;
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
  logic and_565_s24_q;
  logic whole_16_s24_q;
  logic and_591_s24_q;
  logic [11:0] sum_606_s24_q;
  logic [9:0] sum_609_s24_q;
  logic equal_1469_s24_q;
  logic not_1470_s24_q;
  logic equal_1514_s24_q;
  logic [1:0] sum_1520_s24_q;
  logic equal_1522_s24_q;
  logic equal_1524_s24_q;
  logic equal_1526_s24_q;
  logic equal_1528_s24_q;
  logic equal_1530_s24_q;
  logic equal_1532_s24_q;
  logic less_1545_s24_q;
  logic [19:0] select_1570_s24_q;
  logic [11:0] select_1575_s24_q;
  logic and_1579_s24_q;
  logic and_1582_s24_q;
  logic select_1599_s24_q;
  logic equal_1600_s24_q;
  logic equal_1610_s24_q;
  logic equal_1690_s24_q;
  logic equal_1692_s24_q;
  logic equal_1694_s24_q;
  logic or_1696_s24_q;
  logic [22:0] select_1706_s24_q;
  logic [4:0] select_1720_s24_q;
  logic select_1726_s24_q;
  logic [3:0] select_1765_s24_q;
  logic new_row_s24_q;
  logic [111:0] patches_right_codes_rdata_s24_q;
  logic less_1795_s24_q;
  logic less_1796_s24_q;
  logic less_1805_s24_q;
  logic less_1806_s24_q;
  logic and_1817_s24_q;
  logic [47:0] patches_left_codes_rdata_s24_q;
  logic or_1821_s24_q;
  logic and_1829_s24_q;
  logic less_1830_s24_q;
  logic equal_1831_s24_q;
  logic not_1832_s24_q;
  logic equal_1833_s24_q;
  logic not_1859_s24_q;
  logic [2:0] index_s24_q;
  logic [10:0] sum_1912_s24_q;
  logic and_1919_s24_q;
  logic less_1920_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1925_s24_q;
  logic equal_1938_s24_q;
  logic not_1958_s24_q;
  logic not_1974_s24_q;
  logic less_1988_s24_q;
  logic and_1999_s24_q;
  logic [11:0] sum_2128_s24_q;
  logic [9:0] sum_2131_s24_q;
  logic equal_2139_s24_q;
  logic [27:0] select_2153_s24_q;
  logic and_2166_s24_q;
  logic and_2178_s24_q;
  logic [8:0] select_2185_s24_q;
  logic [8:0] select_2189_s24_q;
  logic equal_2192_s24_q;
  logic less_2193_s24_q;
  logic [11:0] select_2198_s24_q;
  logic equal_2236_s24_q;
  logic and_2379_s24_q;
  logic not_2402_s24_q;
  logic not_2417_s24_q;
  logic [9:0] select_2428_s24_q;
  logic [9:0] select_2431_s24_q;
  logic less_2433_s24_q;
  logic and_2494_s24_q;
  logic and_2495_s24_q;
  logic [7:0] select_2512_s24_q;
  logic and_2521_s24_q;
  logic and_2529_s24_q;
  logic and_2536_s24_q;
  logic and_2543_s24_q;
  logic [11:0] select_2590_s24_q;
  logic and_2598_s24_q;
  logic [11:0] select_2605_s24_q;
  logic and_2616_s24_q;
  logic and_2620_s24_q;
  logic equal_2647_s24_q;
  logic and_2652_s24_q;
  logic and_2660_s24_q;
  logic equal_3193_s24_q;
  logic [4:0] select_3281_s24_q;
  logic [14:0] select_3312_s24_q;
  logic less_3355_s24_q;
  logic [9:0] eight_s24_q;
  logic [9:0] fall_s24_q;
  logic equal_3434_s24_q;
  logic equal_3533_s24_q;
  logic or_3604_s24_q;
  logic select_3612_s24_q;
  logic equal_3625_s24_q;
  logic equal_3627_s24_q;
  logic equal_3628_s24_q;
  logic [31:0] select_3845_s24_q;
  logic [9:0] select_3852_s24_q;
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
      patches_column_s24_q <= patches_column_s23_q;
      patches_summed_row_column_s24_q <= patches_summed_row_column_s23_q;
      patches_summed_last_s24_q <= patches_summed_last_s23_q;
      patches_summed_down_by_s24_q <= patches_summed_down_by_s23_q;
      patches_read_first_s24_q <= patches_read_first_s23_q;
      patches_read_far_s24_q <= patches_read_far_q;
      product_s24_q <= product_s23_q;
      centres_values_1_textured_s24_q <= centres_values_1_textured_s23_q;
      centres_values_1_of_skin_s24_q <= centres_values_1_of_skin_s23_q;
      done_s24_q <= done_q;
      select_461_s24_q <= select_461_s23_q;
      select_464_s24_q <= select_464_s23_q;
      column_s24_q <= column_s23_q;
      and_500_s24_q <= and_500_s23_q;
      less_534_s24_q <= less_534_s23_q;
      less_535_s24_q <= less_535_s23_q;
      less_536_s24_q <= less_536_s23_q;
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
      and_565_s24_q <= and_565_s23_q;
      whole_16_s24_q <= whole_16;
      and_591_s24_q <= census_columns_values_1_cell_2_mask_s23_q & and_565_s23_q;
      sum_606_s24_q <= {1'b0, sum_602} + {2'h0, sum_605_s23_q};
      sum_609_s24_q <= sum_609_s23_q;
      equal_1469_s24_q <= equal_1469_s23_q;
      not_1470_s24_q <= not_1470_s23_q;
      equal_1514_s24_q <= equal_1514_s23_q;
      sum_1520_s24_q <= sum_1520_s23_q;
      equal_1522_s24_q <= equal_1522_s23_q;
      equal_1524_s24_q <= equal_1524_s23_q;
      equal_1526_s24_q <= equal_1526_s23_q;
      equal_1528_s24_q <= equal_1528_s23_q;
      equal_1530_s24_q <= equal_1530_s23_q;
      equal_1532_s24_q <= equal_1532_s23_q;
      less_1545_s24_q <= less_1545_s23_q;
      select_1570_s24_q <= equal_1569_s23_q ? registration_sums_rdata_s23_q[19:0] : 20'h0;
      select_1575_s24_q <= equal_1569_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0;
      and_1579_s24_q <= and_1579_s23_q;
      and_1582_s24_q <= and_1582_s23_q;
      select_1599_s24_q <= select_1599_s23_q;
      equal_1600_s24_q <= equal_1600_s23_q;
      equal_1610_s24_q <= equal_1610_s23_q;
      equal_1690_s24_q <= equal_1690_s23_q;
      equal_1692_s24_q <= equal_1692_s23_q;
      equal_1694_s24_q <= equal_1694_s23_q;
      or_1696_s24_q <= or_1696_s23_q;
      select_1706_s24_q <= and_1705_s23_q ? select_1682 : patches_choices_rdata_s23_q;
      select_1720_s24_q <= select_1720_s23_q;
      select_1726_s24_q <= select_1726_s23_q;
      select_1765_s24_q <= select_1765_s23_q;
      new_row_s24_q <= new_row_s23_q;
      patches_right_codes_rdata_s24_q <= patches_right_codes_rdata_q;
      less_1795_s24_q <= $signed(15'h100) < $signed(sum_1794);
      less_1796_s24_q <= $signed(sum_1794[14:8]) < $signed(7'h7f);
      less_1805_s24_q <= $signed(15'h100) < $signed(difference_1804_s23_q);
      less_1806_s24_q <= $signed(difference_1804_s23_q[14:8]) < $signed(7'h7f);
      and_1817_s24_q <= and_1817_s23_q;
      patches_left_codes_rdata_s24_q <= patches_left_codes_rdata_q;
      or_1821_s24_q <= or_1821_s23_q;
      and_1829_s24_q <= and_1829_s23_q;
      less_1830_s24_q <= less_1830_s23_q;
      equal_1831_s24_q <= equal_1831_s23_q;
      not_1832_s24_q <= not_1832_s23_q;
      equal_1833_s24_q <= equal_1833_s23_q;
      not_1859_s24_q <= not_1859_s23_q;
      index_s24_q <= index[2:0];
      sum_1912_s24_q <= sum_1912;
      and_1919_s24_q <= began_q & (seen_x_q == 4'h0);
      less_1920_s24_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s24_q <= index_2[2:0];
      sum_1925_s24_q <= sum_1925;
      equal_1938_s24_q <= equal_1938_s23_q;
      not_1958_s24_q <= ~((good_q & select_1955) == 48'h0);
      not_1974_s24_q <= not_1974_s23_q;
      less_1988_s24_q <= less_1988_s23_q;
      and_1999_s24_q <= and_1999_s23_q;
      sum_2128_s24_q <= {1'b0, sum_2124} + {2'h0, sum_2127_s23_q};
      sum_2131_s24_q <= sum_2131_s23_q;
      equal_2139_s24_q <= equal_2139_s23_q;
      select_2153_s24_q <= sample_pair_whole_s23_q ? {detail_2, detail} : 28'h0;
      and_2166_s24_q <= and_2166;
      and_2178_s24_q <= and_2178;
      select_2185_s24_q <= and_2166 ? contrast_s23_q : 9'h0;
      select_2189_s24_q <= and_2178 ? contrast_2_s23_q : 9'h0;
      equal_2192_s24_q <= equal_2192_s23_q;
      less_2193_s24_q <= 7'h2 < {x_s23_q[4:0], slot_s23_q[2:1]};
      select_2198_s24_q <= select_2198;
      equal_2236_s24_q <= {x_s23_q[4:0], slot_s23_q} == 8'h0;
      and_2379_s24_q <= and_2379_s23_q;
      not_2402_s24_q <= not_2402_s23_q;
      not_2417_s24_q <= not_2417_s23_q;
      select_2428_s24_q <= select_2428_s23_q;
      select_2431_s24_q <= select_2431_s23_q;
      less_2433_s24_q <= {sum_2432, select_2431_s23_q[1:0]} < {3'h0, select_2428_s23_q};
      and_2494_s24_q <= and_2494_s23_q;
      and_2495_s24_q <= and_2495_s23_q;
      select_2512_s24_q <= equal_1469_s23_q ? 8'h0 : (so_s23_q ? select_2510 : 8'h0);
      and_2521_s24_q <= and_2521;
      and_2529_s24_q <= and_2495_s23_q & less_2528_s23_q;
      and_2536_s24_q <= and_2495_s23_q & less_2535;
      and_2543_s24_q <= and_2495_s23_q & less_2542_s23_q;
      select_2590_s24_q <= select_2590;
      and_2598_s24_q <= equal_1469_s23_q & (x_s23_q[6] & and_2596);
      select_2605_s24_q <= select_2605;
      and_2616_s24_q <= equal_1469_s23_q & (x_s23_q[6] & and_2614);
      and_2620_s24_q <= and_2620;
      equal_2647_s24_q <= equal_2647;
      and_2652_s24_q <= equal_1469_s23_q & (x_s23_q[6] & and_2650);
      and_2660_s24_q <= x_s23_q[6] & and_2659;
      equal_3193_s24_q <= equal_3193_s23_q;
      select_3281_s24_q <= select_3281_s23_q;
      select_3312_s24_q <= select_3312_s23_q;
      less_3355_s24_q <= less_3355_s23_q;
      eight_s24_q <= eight;
      fall_s24_q <= fall;
      equal_3434_s24_q <= equal_3434_s23_q;
      equal_3533_s24_q <= equal_3533;
      or_3604_s24_q <= or_3604_s23_q;
      select_3612_s24_q <= select_3612_s23_q;
      equal_3625_s24_q <= equal_3625_s23_q;
      equal_3627_s24_q <= equal_3627_s23_q;
      equal_3628_s24_q <= equal_3628_s23_q;
      select_3845_s24_q <= select_3845;
      select_3852_s24_q <= select_3852_s23_q;
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
  logic [51:0] patches_codes_low_q;
  logic [55:0] patches_codes_high_q;
  logic [47:0] patches_left_row_q;
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
  assign texture = sum_606_s24_q + {2'h0, sum_609_s24_q};
  // hls/stages/registration.hpp:265
  logic equal_1571;
  assign equal_1571 = sum_1520_s24_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1520_s24_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1573;
  assign select_1573 = equal_1571 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1520_s24_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1577;
  assign select_1577 = equal_1571 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/patches.hpp:328
  logic [21:0] select_1709;
  assign select_1709 = select_1599_s24_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1706_s24_q[22:1];
  // hls/stages/patches.hpp:104
  logic [7:0] select_1710;
  assign select_1710 = equal_1600_s24_q ? patches_place_0_column_q : select_1709[7:0];
  logic [5:0] select_1711;
  assign select_1711 = equal_1600_s24_q ? patches_place_0_shift_q : select_1709[13:8];
  // hls/stages/patches.hpp:328
  logic [21:0] select_1738;
  assign select_1738 = select_1599_s24_q ? select_1706_s24_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:104
  logic [7:0] select_1739;
  assign select_1739 = equal_1600_s24_q ? patches_place_1_column_q : select_1738[7:0];
  logic [5:0] select_1740;
  assign select_1740 = equal_1600_s24_q ? patches_place_1_shift_q : select_1738[13:8];
  // hls/stages/patches.hpp:109
  logic equal_1756;
  assign equal_1756 = {select_1710[7], select_464_s24_q, select_461_s24_q} == {1'b0, select_1710[6:0], 4'h0};
  logic equal_1760;
  assign equal_1760 = {select_1739[7], select_464_s24_q, select_461_s24_q} == {1'b0, select_1739[6:0], 4'h0};
  // hls/stages/patches.hpp:443
  logic [2:0] sum_1786;
  assign sum_1786 = patches_code_row_s24_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:447
  logic [1:0] sum_1819;
  assign sum_1819 = patches_code_row_s24_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:976
  logic and_1959;
  assign and_1959 = good_known_q & not_1958_s24_q;
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_1938_s24_q ? and_1959 : not_1974_s24_q;
  // hls/stages/agreement.hpp:507
  logic select_2112;
  assign select_2112 = and_500_s24_q ? census_columns_values_2_cell_4_mask_s24_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2132;
  assign sum_2132 = sum_2128_s24_q + {2'h0, sum_2131_s24_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2134;
  assign select_2134 = and_500_s24_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2135;
  assign select_2135 = and_500_s24_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2154;
  assign select_2154 = and_500_s24_q ? select_2153_s24_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2155;
  assign select_2155 = and_500_s24_q ? select_2153_s24_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2153_s24_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2153_s24_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_2186;
  assign sum_2186 = (equal_2139_s24_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2185_s24_q};
  logic [23:0] sum_2190;
  assign sum_2190 = (equal_2139_s24_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2189_s24_q};
  // hls/stages/census.hpp:409
  logic less_2194;
  assign less_2194 = x_s24_q[4:0] < 5'h3;
  logic [23:0] select_2199;
  assign select_2199 = slot_s24_q ? {select_2198_s24_q[11], 1'b0, select_2198_s24_q[10], 1'b0, select_2198_s24_q[9], 1'b0, select_2198_s24_q[8], 1'b0, select_2198_s24_q[7], 1'b0, select_2198_s24_q[6], 1'b0, select_2198_s24_q[5], 1'b0, select_2198_s24_q[4], 1'b0, select_2198_s24_q[3], 1'b0, select_2198_s24_q[2], 1'b0, select_2198_s24_q[1], 1'b0, select_2198_s24_q[0], 1'b0} : {1'b0, select_2198_s24_q[11], 1'b0, select_2198_s24_q[10], 1'b0, select_2198_s24_q[9], 1'b0, select_2198_s24_q[8], 1'b0, select_2198_s24_q[7], 1'b0, select_2198_s24_q[6], 1'b0, select_2198_s24_q[5], 1'b0, select_2198_s24_q[4], 1'b0, select_2198_s24_q[3], 1'b0, select_2198_s24_q[2], 1'b0, select_2198_s24_q[1], 1'b0, select_2198_s24_q[0]};
  // hls/stages/census.hpp:372
  logic and_2203;
  assign and_2203 = less_2194 & (~((sharpness_sums_contrast_1_q & select_2199) == 24'h0));
  logic and_2213;
  assign and_2213 = less_2194 & (~((sharpness_sums_contrast_0_q & select_2199) == 24'h0));
  // hls/stages/agreement.hpp:1048
  logic not_2419;
  assign not_2419 = ~(equal_1938_s24_q ? and_1959 : not_2417_s24_q);
  // hls/stages/patches.hpp:314
  logic and_2422;
  assign and_2422 = ends_cell_s24_q & (not_2402_s24_q & (centres_values_1_textured_s24_q & not_2419));
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_2435;
  assign select_2435 = ((~(select_2428_s24_q[9:4] == 6'h0)) & less_2433_s24_q) ? select_2428_s24_q : 10'h0;
  // hls/stages/patches.hpp:314
  logic [9:0] select_2438;
  assign select_2438 = equal_1469_s24_q ? (x_s24_q[6] ? (equal_1514_s24_q ? 10'h0 : select_2435) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1052
  logic and_2456;
  assign and_2456 = centres_values_1_textured_s24_q & (centres_values_1_of_skin_s24_q & not_2419);
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2513;
  assign sum_2513 = registration_half_across_q + {{6{select_2512_s24_q[7]}}, select_2512_s24_q};
  // hls/stages/patches.hpp:314
  logic and_2517;
  assign and_2517 = not_1470_s24_q & (drew_q & (and_2495_s24_q & equal_1610_s24_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2519;
  assign select_2519 = and_2494_s24_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2517});
  // hls/stages/patches.hpp:314
  logic [1:0] select_2523;
  assign select_2523 = drew_q ? (equal_1610_s24_q ? {and_2521_s24_q, and_2495_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2524;
  assign select_2524 = equal_1469_s24_q ? 2'h0 : select_2523;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2525;
  assign sum_2525 = registration_half_votes_down_q + {{5{select_2524[1]}}, select_2524};
  // hls/stages/patches.hpp:314
  logic [1:0] select_2531;
  assign select_2531 = drew_q ? (equal_1610_s24_q ? {and_2529_s24_q, and_2495_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2532;
  assign select_2532 = equal_1469_s24_q ? 2'h0 : select_2531;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2533;
  assign sum_2533 = registration_half_votes_up_q + {{5{select_2532[1]}}, select_2532};
  // hls/stages/patches.hpp:314
  logic [1:0] select_2538;
  assign select_2538 = drew_q ? (equal_1610_s24_q ? {and_2536_s24_q, and_2495_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2539;
  assign select_2539 = equal_1469_s24_q ? 2'h0 : select_2538;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2540;
  assign sum_2540 = registration_half_half_votes_down_q + {{5{select_2539[1]}}, select_2539};
  // hls/stages/patches.hpp:314
  logic [1:0] select_2545;
  assign select_2545 = drew_q ? (equal_1610_s24_q ? {and_2543_s24_q, and_2495_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2546;
  assign select_2546 = equal_1469_s24_q ? 2'h0 : select_2545;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2547;
  assign sum_2547 = registration_half_half_votes_up_q + {{5{select_2546[1]}}, select_2546};
  // hls/stages/patches.hpp:314
  logic and_2581;
  assign and_2581 = equal_1469_s24_q & (x_s24_q[6] & (not_1859_s24_q & less_1545_s24_q));
  logic [11:0] select_2592;
  assign select_2592 = equal_1469_s24_q ? (x_s24_q[6] ? select_2590_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2600;
  assign sum_2600 = {{2{select_2592[11]}}, select_2592} + (and_2598_s24_q ? 14'h0 : registration_down_q);
  // hls/stages/patches.hpp:314
  logic [11:0] select_2607;
  assign select_2607 = equal_1469_s24_q ? (x_s24_q[6] ? select_2605_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2609;
  assign sum_2609 = {{2{select_2607[11]}}, select_2607} + (and_2598_s24_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2621;
  assign not_2621 = ~and_2620_s24_q;
  logic less_2622;
  assign less_2622 = $signed({9'h1, {2{not_2621}}, and_2620_s24_q}) < $signed(registration_up_q[13:2]);
  logic select_2623;
  assign select_2623 = and_2616_s24_q ? less_2622 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_2627;
  assign and_2627 = x_s24_q[6] & (not_1859_s24_q & (less_1545_s24_q & (x_s24_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:314
  logic and_2628;
  assign and_2628 = equal_1469_s24_q & and_2627;
  // hls/stages/registration.hpp:242
  logic less_2629;
  assign less_2629 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2631;
  assign less_2631 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1084
  logic and_2636;
  assign and_2636 = x_s24_q[6] & (not_1859_s24_q & (less_1545_s24_q & (x_s24_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:314
  logic and_2637;
  assign and_2637 = equal_1469_s24_q & and_2636;
  // hls/stages/agreement.hpp:1084
  logic and_2644;
  assign and_2644 = x_s24_q[6] & (not_1859_s24_q & (less_1545_s24_q & (x_s24_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2662;
  assign and_2662 = registration_votes_up_q & registration_other_down_q;
  logic select_2664;
  assign select_2664 = registration_votes_down_q ? (registration_other_up_q | and_2662) : and_2662;
  // hls/stages/registration.hpp:138
  logic and_2666;
  assign and_2666 = (equal_1469_s24_q & and_2660_s24_q) & (registration_other_enough_q & select_2664);
  logic and_2668;
  assign and_2668 = registration_enough_q & ((and_2652_s24_q & (less_2631 | less_2629)) | and_2666);
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2754;
  assign select_2754 = sample_pair_whole_s24_q ? (equal_1600_s24_q ? patches_place_0_slope_q : select_1709[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_2759;
  assign select_2759 = sample_pair_whole_s24_q ? (equal_1600_s24_q ? patches_place_1_slope_q : select_1738[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:463
  logic [55:0] other;
  assign other = new_row_s24_q ? patches_right_codes_rdata_s24_q[55:0] : {patches_codes_high_q[3:0], patches_codes_low_q};
  // hls/stages/patches.hpp:160
  logic [51:0] select_2848;
  assign select_2848 = or_1696_s24_q ? {patches_codes_high_q[3:0], patches_codes_low_q[51:4]} : patches_codes_low_q;
  logic [51:0] select_2850;
  assign select_2850 = equal_1690_s24_q ? patches_codes_low_q : (equal_1692_s24_q ? other[55:4] : select_2848);
  // hls/stages/patches.hpp:463
  logic [55:0] select_2851;
  assign select_2851 = new_row_s24_q ? patches_right_codes_rdata_s24_q[111:56] : {4'h0, patches_codes_high_q[55:4]};
  // hls/stages/patches.hpp:160
  logic [55:0] select_2852;
  assign select_2852 = or_1696_s24_q ? {less_1806_s24_q, less_1805_s24_q, less_1796_s24_q, less_1795_s24_q, patches_codes_high_q[55:4]} : patches_codes_high_q;
  logic [55:0] select_2854;
  assign select_2854 = equal_1690_s24_q ? patches_codes_high_q : (equal_1692_s24_q ? select_2851 : select_2852);
  // hls/stages/count_bits.hpp:24
  logic parity_2859;
  assign parity_2859 = ^{less_1806_s24_q, less_1805_s24_q, less_1796_s24_q, less_1795_s24_q};
  // hls/stages/count_bits.hpp:25
  logic or_2863;
  assign or_2863 = ({less_1796_s24_q, less_1795_s24_q} == 2'h3) | (less_1805_s24_q & (less_1796_s24_q | less_1795_s24_q));
  logic and_2864;
  assign and_2864 = less_1806_s24_q & (^{less_1805_s24_q, less_1796_s24_q, less_1795_s24_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2865;
  assign xor_2865 = or_2863 ^ and_2864;
  // hls/stages/count_bits.hpp:27
  logic and_2866;
  assign and_2866 = or_2863 & and_2864;
  // hls/stages/patches.hpp:449
  logic [2:0] select_2868;
  assign select_2868 = or_1821_s24_q ? 3'h0 : (patches_column_s24_q ? 3'h0 : {and_2866, xor_2865, parity_2859});
  // hls/stages/patches.hpp:464
  logic [47:0] select_2883;
  assign select_2883 = new_row_s24_q ? patches_left_codes_rdata_s24_q : patches_left_row_q;
  // hls/stages/patches.hpp:160
  logic [47:0] select_2885;
  assign select_2885 = equal_1690_s24_q ? patches_left_row_q : (equal_1692_s24_q ? select_2883 : patches_left_row_q);
  // hls/stages/patches.hpp:464
  logic [47:0] bits;
  assign bits = select_2883 ^ other[47:0];
  // hls/stages/patches.hpp:160
  logic select_3233;
  assign select_3233 = equal_1690_s24_q ? patches_summed_first_q : (equal_1692_s24_q ? new_row_s24_q : patches_summed_first_q);
  // hls/stages/patches.hpp:483
  logic [9:0] select_3321;
  assign select_3321 = (patches_read_far_s24_q < patches_peak_far_q) ? patches_read_far_s24_q : patches_peak_far_q;
  logic [9:0] select_3322;
  assign select_3322 = patches_read_first_s24_q ? patches_read_far_s24_q : select_3321;
  // hls/stages/patches.hpp:523
  logic [10:0] sum_3364;
  assign sum_3364 = {1'b0, fall_s24_q} + {2'h0, fall_s24_q[9:1]};
  // hls/stages/patches.hpp:524
  logic [10:0] sum_3368;
  assign sum_3368 = {1'b0, fall_s24_q} + {3'h0, fall_s24_q[9:2]};
  logic not_3373;
  assign not_3373 = ~({eight_s24_q, 3'h0} < ({fall_s24_q, 3'h0} - {3'h0, fall_s24_q}));
  // hls/stages/patches.hpp:537
  logic [7:0] select_3378;
  assign select_3378 = patches_second_s24_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:536
  logic [3:0] sum_3379;
  assign sum_3379 = {2'h0, select_3312_s24_q[14:13]} + 4'hf;
  logic [5:0] select_3380;
  assign select_3380 = patches_second_s24_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3381;
  assign sum_3381 = {select_3380[5], select_3380} + {{4{sum_3379[3]}}, sum_3379[3:1]};
  // hls/stages/patches.hpp:314
  logic select_3624;
  assign select_3624 = equal_1469_s24_q ? ((x_s24_q[6] & good_known_q) | equal_3533_s24_q) : good_known_q;
  // hls/stages/agreement.hpp:1234
  logic and_3786;
  assign and_3786 = and_1999_s24_q & ({sum_1925_s24_q, index_2_s24_q} == {sum_1912_s24_q, index_s24_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1329; read in stage 24, written in stage 25: 24 < 25 < 24 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1912_s24_q, index_s24_q};
  logic map_re;
  assign map_re = s24_en & (and_1919_s24_q & less_1920_s24_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory patches_right_codes, write
  logic [4:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1786, patches_code_row_s24_q[1:0]};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s24_en & and_1817_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1806_s24_q, less_1805_s24_q, less_1796_s24_q, less_1795_s24_q, patches_codes_high_q, patches_codes_low_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_right_codes_raddr_s23_sim;
  logic patches_right_codes_re_s23_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_codes_re_s23_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_codes_re_s23_sim <= patches_right_codes_re;
      patches_right_codes_raddr_s23_sim <= patches_right_codes_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s23_sim && patches_right_codes_raddr_s23_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 5'd28) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 5'd28) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1819, patches_code_row_s24_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s24_en & and_1829_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1806_s24_q, less_1805_s24_q, less_1796_s24_q, less_1795_s24_q, patches_codes_high_q[55:12]};
  end
`ifndef SYNTHESIS
  logic [3:0] patches_left_codes_raddr_s23_sim;
  logic patches_left_codes_re_s23_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_codes_re_s23_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_codes_re_s23_sim <= patches_left_codes_re;
      patches_left_codes_raddr_s23_sim <= patches_left_codes_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
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
      patches_codes_low_q <= 52'h0;
      patches_codes_high_q <= 56'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_first_q <= 1'b0;
      patches_peak_far_q <= 10'h0;
      good_known_q <= 1'b0;
    end else if (s24_en) begin
      sharpness_sums_contrast_0_q <= and_500_s24_q ? sum_2186 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_500_s24_q ? sum_2190 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2494_s24_q ? 14'h0 : sum_2513;
      registration_half_measured_q <= select_2519;
      registration_half_votes_down_q <= and_2494_s24_q ? 7'h0 : sum_2525;
      registration_half_votes_up_q <= and_2494_s24_q ? 7'h0 : sum_2533;
      registration_half_half_votes_down_q <= and_2494_s24_q ? 7'h0 : sum_2540;
      registration_half_half_votes_up_q <= and_2494_s24_q ? 7'h0 : sum_2547;
      registration_down_q <= and_2581 ? sum_2600 : registration_down_q;
      registration_up_q <= and_2581 ? sum_2609 : registration_up_q;
      registration_enough_q <= select_2623;
      registration_votes_down_q <= and_2628 ? less_2629 : registration_votes_down_q;
      registration_votes_up_q <= and_2628 ? less_2631 : registration_votes_up_q;
      registration_other_enough_q <= and_2637 ? select_2623 : registration_other_enough_q;
      registration_other_down_q <= and_2637 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2637 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_column_q <= sample_pair_whole_s24_q ? select_1710 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s24_q ? select_1711 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2754;
      patches_place_1_column_q <= sample_pair_whole_s24_q ? select_1739 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s24_q ? select_1740 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2759;
      patches_codes_low_q <= select_2850;
      patches_codes_high_q <= select_2854;
      patches_left_row_q <= select_2885;
      patches_summed_first_q <= select_3233;
      patches_peak_far_q <= equal_1690_s24_q ? select_3322 : patches_peak_far_q;
      good_known_q <= select_3624;
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
      census_columns_values_3_cell_4_mask_q <= select_2112;
      census_changes_values_0_left_q <= and_500_s24_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_500_s24_q ? sum_2132 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2134;
      census_changes_values_1_right_q <= select_2135;
      sharpness_last_detail_0_q <= select_2154;
      sharpness_last_detail_1_q <= select_2155;
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
  logic [3:0] select_461_s25_q;
  logic [6:0] select_464_s25_q;
  logic [6:0] column_s25_q;
  logic and_500_s25_q;
  logic so_s25_q;
  logic less_534_s25_q;
  logic less_535_s25_q;
  logic less_536_s25_q;
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
  logic and_565_s25_q;
  logic and_590_s25_q;
  logic and_591_s25_q;
  logic [12:0] sum_611_s25_q;
  logic equal_1469_s25_q;
  logic not_1470_s25_q;
  logic equal_1514_s25_q;
  logic [1:0] sum_1520_s25_q;
  logic equal_1522_s25_q;
  logic equal_1524_s25_q;
  logic equal_1526_s25_q;
  logic equal_1528_s25_q;
  logic equal_1530_s25_q;
  logic equal_1532_s25_q;
  logic [19:0] sum_1574_s25_q;
  logic [11:0] sum_1578_s25_q;
  logic and_1579_s25_q;
  logic and_1582_s25_q;
  logic select_1599_s25_q;
  logic equal_1600_s25_q;
  logic equal_1690_s25_q;
  logic equal_1692_s25_q;
  logic equal_1694_s25_q;
  logic select_1706_s25_q;
  logic [7:0] sum_1712_s25_q;
  logic [4:0] select_1720_s25_q;
  logic select_1726_s25_q;
  logic [7:0] sum_1741_s25_q;
  logic equal_1756_s25_q;
  logic equal_1760_s25_q;
  logic [3:0] select_1765_s25_q;
  logic less_1830_s25_q;
  logic equal_1831_s25_q;
  logic not_1832_s25_q;
  logic equal_1833_s25_q;
  logic not_1859_s25_q;
  logic and_1919_s25_q;
  logic less_1920_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1925_s25_q;
  logic is_seen_s25_q;
  logic and_1989_s25_q;
  logic and_1999_s25_q;
  logic equal_2139_s25_q;
  logic [12:0] sum_2140_s25_q;
  logic [12:0] select_2168_s25_q;
  logic [12:0] select_2180_s25_q;
  logic equal_2192_s25_q;
  logic less_2193_s25_q;
  logic and_2203_s25_q;
  logic and_2213_s25_q;
  logic equal_2236_s25_q;
  logic and_2379_s25_q;
  logic and_2424_s25_q;
  logic [9:0] select_2428_s25_q;
  logic [9:0] select_2431_s25_q;
  logic [9:0] select_2438_s25_q;
  logic and_2459_s25_q;
  logic not_2646_s25_q;
  logic equal_2647_s25_q;
  logic and_2668_s25_q;
  logic [20:0] other_s25_q;
  logic [2:0] select_2869_s25_q;
  logic [20:0] select_2883_s25_q;
  logic bits_s25_q;
  logic xor_2889_s25_q;
  logic xor_2892_s25_q;
  logic xor_2895_s25_q;
  logic parity_2897_s25_q;
  logic xor_2901_s25_q;
  logic xor_2907_s25_q;
  logic xor_2910_s25_q;
  logic xor_2919_s25_q;
  logic xor_2922_s25_q;
  logic xor_2925_s25_q;
  logic xor_2931_s25_q;
  logic xor_2934_s25_q;
  logic xor_2937_s25_q;
  logic parity_2939_s25_q;
  logic xor_2943_s25_q;
  logic xor_2946_s25_q;
  logic xor_2949_s25_q;
  logic parity_2951_s25_q;
  logic equal_2962_s25_q;
  logic and_2964_s25_q;
  logic equal_2973_s25_q;
  logic and_2975_s25_q;
  logic equal_2977_s25_q;
  logic and_2979_s25_q;
  logic equal_2981_s25_q;
  logic and_2983_s25_q;
  logic equal_2988_s25_q;
  logic and_2990_s25_q;
  logic equal_2992_s25_q;
  logic and_2994_s25_q;
  logic equal_2996_s25_q;
  logic and_2998_s25_q;
  logic equal_3006_s25_q;
  logic and_3008_s25_q;
  logic equal_3010_s25_q;
  logic and_3012_s25_q;
  logic equal_3014_s25_q;
  logic and_3016_s25_q;
  logic equal_3021_s25_q;
  logic not_3023_s25_q;
  logic equal_3026_s25_q;
  logic and_3028_s25_q;
  logic equal_3030_s25_q;
  logic and_3032_s25_q;
  logic equal_3037_s25_q;
  logic and_3039_s25_q;
  logic equal_3041_s25_q;
  logic and_3043_s25_q;
  logic equal_3045_s25_q;
  logic and_3047_s25_q;
  logic equal_3193_s25_q;
  logic [4:0] select_3281_s25_q;
  logic [12:0] select_3312_s25_q;
  logic [9:0] select_3322_s25_q;
  logic less_3355_s25_q;
  logic not_3363_s25_q;
  logic not_3366_s25_q;
  logic not_3370_s25_q;
  logic not_3373_s25_q;
  logic [7:0] select_3378_s25_q;
  logic sum_3379_s25_q;
  logic [6:0] sum_3381_s25_q;
  logic equal_3434_s25_q;
  logic equal_3533_s25_q;
  logic or_3604_s25_q;
  logic select_3612_s25_q;
  logic equal_3625_s25_q;
  logic equal_3627_s25_q;
  logic equal_3628_s25_q;
  logic and_3771_s25_q;
  logic and_3786_s25_q;
  logic [31:0] select_3845_s25_q;
  logic [9:0] select_3852_s25_q;
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
      select_461_s25_q <= select_461_s24_q;
      select_464_s25_q <= select_464_s24_q;
      column_s25_q <= column_s24_q;
      and_500_s25_q <= and_500_s24_q;
      so_s25_q <= drew_q;
      less_534_s25_q <= less_534_s24_q;
      less_535_s25_q <= less_535_s24_q;
      less_536_s25_q <= less_536_s24_q;
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
      and_565_s25_q <= and_565_s24_q;
      and_590_s25_q <= whole_22 & and_565_s24_q;
      and_591_s25_q <= and_591_s24_q;
      sum_611_s25_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1469_s25_q <= equal_1469_s24_q;
      not_1470_s25_q <= not_1470_s24_q;
      equal_1514_s25_q <= equal_1514_s24_q;
      sum_1520_s25_q <= sum_1520_s24_q;
      equal_1522_s25_q <= equal_1522_s24_q;
      equal_1524_s25_q <= equal_1524_s24_q;
      equal_1526_s25_q <= equal_1526_s24_q;
      equal_1528_s25_q <= equal_1528_s24_q;
      equal_1530_s25_q <= equal_1530_s24_q;
      equal_1532_s25_q <= equal_1532_s24_q;
      sum_1574_s25_q <= select_1570_s24_q + {{6{select_1573[13]}}, select_1573};
      sum_1578_s25_q <= select_1575_s24_q + {{5{select_1577[6]}}, select_1577};
      and_1579_s25_q <= and_1579_s24_q;
      and_1582_s25_q <= and_1582_s24_q;
      select_1599_s25_q <= select_1599_s24_q;
      equal_1600_s25_q <= equal_1600_s24_q;
      equal_1690_s25_q <= equal_1690_s24_q;
      equal_1692_s25_q <= equal_1692_s24_q;
      equal_1694_s25_q <= equal_1694_s24_q;
      select_1706_s25_q <= select_1706_s24_q[0];
      sum_1712_s25_q <= select_1710 + {{2{select_1711[5]}}, select_1711};
      select_1720_s25_q <= select_1720_s24_q;
      select_1726_s25_q <= select_1726_s24_q;
      sum_1741_s25_q <= select_1739 + {{2{select_1740[5]}}, select_1740};
      equal_1756_s25_q <= equal_1756;
      equal_1760_s25_q <= equal_1760;
      select_1765_s25_q <= select_1765_s24_q;
      less_1830_s25_q <= less_1830_s24_q;
      equal_1831_s25_q <= equal_1831_s24_q;
      not_1832_s25_q <= not_1832_s24_q;
      equal_1833_s25_q <= equal_1833_s24_q;
      not_1859_s25_q <= not_1859_s24_q;
      and_1919_s25_q <= and_1919_s24_q;
      less_1920_s25_q <= less_1920_s24_q;
      index_2_s25_q <= index_2_s24_q;
      sum_1925_s25_q <= sum_1925_s24_q;
      is_seen_s25_q <= is_seen;
      and_1989_s25_q <= is_seen & less_1988_s24_q;
      and_1999_s25_q <= and_1999_s24_q;
      equal_2139_s25_q <= equal_2139_s24_q;
      sum_2140_s25_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2132};
      select_2168_s25_q <= and_2166_s24_q ? detail_3[14:2] : 13'h0;
      select_2180_s25_q <= and_2178_s24_q ? detail_4[14:2] : 13'h0;
      equal_2192_s25_q <= equal_2192_s24_q;
      less_2193_s25_q <= less_2193_s24_q;
      and_2203_s25_q <= and_2203;
      and_2213_s25_q <= and_2213;
      equal_2236_s25_q <= equal_2236_s24_q;
      and_2379_s25_q <= and_2379_s24_q;
      and_2424_s25_q <= not_1470_s24_q & (drew_q & and_2422);
      select_2428_s25_q <= select_2428_s24_q;
      select_2431_s25_q <= select_2431_s24_q;
      select_2438_s25_q <= select_2438;
      and_2459_s25_q <= drew_q & (ends_cell_s24_q & (not_2402_s24_q & and_2456));
      not_2646_s25_q <= ~(equal_1469_s24_q & and_2644);
      equal_2647_s25_q <= equal_2647_s24_q;
      and_2668_s25_q <= and_2668;
      other_s25_q <= {other[47:36], other[8:0]};
      select_2869_s25_q <= or_1696_s24_q ? select_2868 : 3'h0;
      select_2883_s25_q <= {select_2883[47:36], select_2883[8:0]};
      bits_s25_q <= bits[8];
      xor_2889_s25_q <= bits[17] ^ (^{select_2883[16:15], other[16:15]});
      xor_2892_s25_q <= bits[11] ^ (^{select_2883[10:9], other[10:9]});
      xor_2895_s25_q <= bits[14] ^ (^{select_2883[13:12], other[13:12]});
      parity_2897_s25_q <= ^{select_2883[14:9], other[14:9]};
      xor_2901_s25_q <= bits[47] ^ (^{select_2883[46:45], other[46:45]});
      xor_2907_s25_q <= bits[2] ^ (^{select_2883[1:0], other[1:0]});
      xor_2910_s25_q <= bits[5] ^ (^{select_2883[4:3], other[4:3]});
      xor_2919_s25_q <= bits[44] ^ (^{select_2883[43:42], other[43:42]});
      xor_2922_s25_q <= bits[38] ^ (^{select_2883[37:36], other[37:36]});
      xor_2925_s25_q <= bits[41] ^ (^{select_2883[40:39], other[40:39]});
      xor_2931_s25_q <= bits[26] ^ (^{select_2883[25:24], other[25:24]});
      xor_2934_s25_q <= bits[20] ^ (^{select_2883[19:18], other[19:18]});
      xor_2937_s25_q <= bits[23] ^ (^{select_2883[22:21], other[22:21]});
      parity_2939_s25_q <= ^{select_2883[23:18], other[23:18]};
      xor_2943_s25_q <= bits[35] ^ (^{select_2883[34:33], other[34:33]});
      xor_2946_s25_q <= bits[29] ^ (^{select_2883[28:27], other[28:27]});
      xor_2949_s25_q <= bits[32] ^ (^{select_2883[31:30], other[31:30]});
      parity_2951_s25_q <= ^{select_2883[32:27], other[32:27]};
      equal_2962_s25_q <= bits[46:45] == 2'h3;
      and_2964_s25_q <= bits[47] & (bits[45] | bits[46]);
      equal_2973_s25_q <= bits[34:33] == 2'h3;
      and_2975_s25_q <= bits[35] & (bits[33] | bits[34]);
      equal_2977_s25_q <= bits[28:27] == 2'h3;
      and_2979_s25_q <= bits[29] & (bits[27] | bits[28]);
      equal_2981_s25_q <= bits[31:30] == 2'h3;
      and_2983_s25_q <= bits[32] & (bits[30] | bits[31]);
      equal_2988_s25_q <= bits[43:42] == 2'h3;
      and_2990_s25_q <= bits[44] & (bits[42] | bits[43]);
      equal_2992_s25_q <= bits[37:36] == 2'h3;
      and_2994_s25_q <= bits[38] & (bits[36] | bits[37]);
      equal_2996_s25_q <= bits[40:39] == 2'h3;
      and_2998_s25_q <= bits[41] & (bits[39] | bits[40]);
      equal_3006_s25_q <= bits[25:24] == 2'h3;
      and_3008_s25_q <= bits[26] & (bits[24] | bits[25]);
      equal_3010_s25_q <= bits[19:18] == 2'h3;
      and_3012_s25_q <= bits[20] & (bits[18] | bits[19]);
      equal_3014_s25_q <= bits[22:21] == 2'h3;
      and_3016_s25_q <= bits[23] & (bits[21] | bits[22]);
      equal_3021_s25_q <= bits[7:6] == 2'h3;
      not_3023_s25_q <= ~(bits[7:6] == 2'h0);
      equal_3026_s25_q <= bits[1:0] == 2'h3;
      and_3028_s25_q <= bits[2] & (bits[0] | bits[1]);
      equal_3030_s25_q <= bits[4:3] == 2'h3;
      and_3032_s25_q <= bits[5] & (bits[3] | bits[4]);
      equal_3037_s25_q <= bits[16:15] == 2'h3;
      and_3039_s25_q <= bits[17] & (bits[15] | bits[16]);
      equal_3041_s25_q <= bits[10:9] == 2'h3;
      and_3043_s25_q <= bits[11] & (bits[9] | bits[10]);
      equal_3045_s25_q <= bits[13:12] == 2'h3;
      and_3047_s25_q <= bits[14] & (bits[12] | bits[13]);
      equal_3193_s25_q <= equal_3193_s24_q;
      select_3281_s25_q <= select_3281_s24_q;
      select_3312_s25_q <= select_3312_s24_q[12:0];
      select_3322_s25_q <= select_3322;
      less_3355_s25_q <= less_3355_s24_q;
      not_3363_s25_q <= ~({eight_s24_q, 3'h0} < {3'h0, fall_s24_q});
      not_3366_s25_q <= ~({eight_s24_q, 3'h0} < {1'b0, sum_3364, fall_s24_q[0]});
      not_3370_s25_q <= ~({eight_s24_q, 3'h0} < {sum_3368, fall_s24_q[1:0]});
      not_3373_s25_q <= not_3373;
      select_3378_s25_q <= select_3378;
      sum_3379_s25_q <= sum_3379[0];
      sum_3381_s25_q <= sum_3381;
      equal_3434_s25_q <= equal_3434_s24_q;
      equal_3533_s25_q <= equal_3533_s24_q;
      or_3604_s25_q <= or_3604_s24_q;
      select_3612_s25_q <= select_3612_s24_q;
      equal_3625_s25_q <= equal_3625_s24_q;
      equal_3627_s25_q <= equal_3627_s24_q;
      equal_3628_s25_q <= equal_3628_s24_q;
      and_3771_s25_q <= said_q;
      and_3786_s25_q <= and_3786;
      select_3845_s25_q <= select_3845_s24_q;
      select_3852_s25_q <= select_3852_s24_q;
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
  logic [13:0] sum_612;
  assign sum_612 = {2'h0, census_changes_values_1_left_s25_q} + {1'b0, sum_611_s25_q};
  logic [13:0] sum_613;
  assign sum_613 = {2'h0, census_changes_values_2_left_q} + sum_612;
  // hls/stages/patches.hpp:104
  logic select_1708;
  assign select_1708 = equal_1600_s25_q ? patches_place_0_valid_q : (select_1599_s25_q ? patches_place_0_valid_q : select_1706_s25_q);
  // hls/stages/patches.hpp:299
  logic [7:0] sum_1713;
  assign sum_1713 = sum_1712_s25_q + 8'hff;
  // hls/stages/patches.hpp:108
  logic equal_1714;
  assign equal_1714 = {sum_1713[7], select_464_s25_q, select_461_s25_q} == {1'b0, sum_1713[6:0], 4'h8};
  // hls/stages/patches.hpp:104
  logic select_1737;
  assign select_1737 = equal_1600_s25_q ? patches_place_1_valid_q : (select_1599_s25_q ? select_1706_s25_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:299
  logic [7:0] sum_1742;
  assign sum_1742 = sum_1741_s25_q + 8'hff;
  // hls/stages/patches.hpp:108
  logic equal_1743;
  assign equal_1743 = {sum_1742[7], select_464_s25_q, select_461_s25_q} == {1'b0, sum_1742[6:0], 4'h8};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2136;
  assign select_2136 = and_500_s25_q ? census_changes_values_1_left_s25_q : census_changes_values_2_left_q;
  logic [11:0] select_2137;
  assign select_2137 = and_500_s25_q ? census_changes_values_1_right_s25_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_2141;
  assign sum_2141 = {2'h0, census_changes_values_1_right_s25_q} + {1'b0, sum_2140_s25_q};
  logic [13:0] sum_2142;
  assign sum_2142 = {2'h0, census_changes_values_2_right_q} + sum_2141;
  // hls/stages/census.hpp:357
  logic [23:0] select_2170;
  assign select_2170 = equal_2139_s25_q ? {11'h0, select_2168_s25_q} : (sharpness_sums_detail_0_q + {11'h0, select_2168_s25_q});
  logic [23:0] select_2182;
  assign select_2182 = equal_2139_s25_q ? {11'h0, select_2180_s25_q} : (sharpness_sums_detail_1_q + {11'h0, select_2180_s25_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_2205;
  assign select_2205 = (less_2193_s25_q & and_2203_s25_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2215;
  assign select_2215 = (less_2193_s25_q & and_2213_s25_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:207
  logic [1:0] select_2224;
  assign select_2224 = equal_2192_s25_q ? {sharpness_comparing_contrast_0_q[0], and_2213_s25_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2226;
  assign select_2226 = equal_2192_s25_q ? {sharpness_comparing_contrast_1_q[0], and_2203_s25_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_2249;
  assign xor_2249 = sharpness_comparing_contrast_0_q[1] ^ and_2203_s25_q;
  logic select_2252;
  assign select_2252 = (equal_2236_s25_q | xor_2249) ? (and_2203_s25_q & xor_2249) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2253;
  assign select_2253 = equal_2192_s25_q ? select_2252 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2255;
  assign xor_2255 = sharpness_comparing_contrast_1_q[1] ^ and_2213_s25_q;
  logic select_2258;
  assign select_2258 = (equal_2236_s25_q | xor_2255) ? (and_2213_s25_q & xor_2255) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2259;
  assign select_2259 = equal_2192_s25_q ? select_2258 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2426;
  assign select_2426 = and_2379_s25_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2424_s25_q});
  logic [13:0] select_2440;
  assign select_2440 = and_2379_s25_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2438_s25_q});
  // hls/stages/patches.hpp:314
  logic and_2460;
  assign and_2460 = not_1470_s25_q & and_2459_s25_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2462;
  assign select_2462 = and_2379_s25_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2460});
  // hls/stages/patches.hpp:160
  logic [2:0] select_2871;
  assign select_2871 = equal_1690_s25_q ? 3'h0 : (equal_1692_s25_q ? 3'h0 : select_2869_s25_q);
  // hls/stages/patches.hpp:143
  logic [9:0] sum_2873;
  assign sum_2873 = {7'h0, patches_set_q} + (equal_1694_s25_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_2898;
  assign xor_2898 = xor_2889_s25_q ^ parity_2897_s25_q;
  logic xor_2904;
  assign xor_2904 = bits_s25_q ^ (^{select_2883_s25_q[7:6], other_s25_q[7:6]});
  logic xor_2913;
  assign xor_2913 = xor_2904 ^ (^{select_2883_s25_q[5:0], other_s25_q[5:0]});
  logic parity_2915;
  assign parity_2915 = ^{select_2883_s25_q[20:18], select_2883_s25_q[8:0], other_s25_q[20:18], other_s25_q[8:0]};
  logic xor_2916;
  assign xor_2916 = xor_2898 ^ parity_2915;
  logic xor_2940;
  assign xor_2940 = xor_2931_s25_q ^ parity_2939_s25_q;
  logic xor_2952;
  assign xor_2952 = xor_2943_s25_q ^ parity_2951_s25_q;
  logic xor_2953;
  assign xor_2953 = xor_2940 ^ xor_2952;
  // hls/stages/count_bits.hpp:25
  logic or_2961;
  assign or_2961 = (xor_2892_s25_q & xor_2895_s25_q) | (xor_2889_s25_q & (xor_2892_s25_q | xor_2895_s25_q));
  logic or_2969;
  assign or_2969 = (xor_2907_s25_q & xor_2910_s25_q) | (xor_2904 & (xor_2907_s25_q | xor_2910_s25_q));
  logic or_3058;
  assign or_3058 = (xor_2922_s25_q & xor_2925_s25_q) | (xor_2919_s25_q & (xor_2922_s25_q | xor_2925_s25_q));
  logic or_3062;
  assign or_3062 = (xor_2934_s25_q & xor_2937_s25_q) | (xor_2931_s25_q & (xor_2934_s25_q | xor_2937_s25_q));
  logic or_3066;
  assign or_3066 = (xor_2946_s25_q & xor_2949_s25_q) | (xor_2943_s25_q & (xor_2946_s25_q | xor_2949_s25_q));
  logic and_3070;
  assign and_3070 = xor_2916 & (^{xor_2953, select_2883_s25_q[17:9], other_s25_q[17:9]});
  logic or_3074;
  assign or_3074 = (xor_2901_s25_q & xor_2913) | (xor_2898 & (xor_2901_s25_q | xor_2913));
  logic and_3077;
  assign and_3077 = (xor_2919_s25_q ^ (^{select_2883_s25_q[14:9], other_s25_q[14:9]})) & (xor_2940 | xor_2952);
  // hls/stages/patches.hpp:523
  logic [1:0] sum_3367;
  assign sum_3367 = {1'b0, not_3363_s25_q} + {1'b0, not_3366_s25_q};
  // hls/stages/patches.hpp:524
  logic [1:0] sum_3374;
  assign sum_3374 = {1'b0, not_3370_s25_q} + {1'b0, not_3373_s25_q};
  // hls/stages/patches.hpp:523
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3367} + {1'b0, sum_3374};
  // hls/stages/patches.hpp:537
  logic [18:0] product_3382;
  assign product_3382 = $signed({{11{select_3378_s25_q[7]}}, select_3378_s25_q}) * $signed({{8{sum_3381_s25_q[6]}}, sum_3381_s25_q, sum_3379_s25_q, select_3312_s25_q[12:10]});
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3630;
  assign select_3630 = equal_3627_s25_q ? counts_skin_unproven_q : (equal_3628_s25_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3625_s25_q ? counts_nearer_s25_q : select_3630;
  // hls/stages/patches.hpp:314
  logic and_3801;
  assign and_3801 = equal_1469_s25_q & (equal_3533_s25_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3846;
  assign select_3846 = equal_1532_s25_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3845_s25_q;
  logic [31:0] select_3847;
  assign select_3847 = equal_1530_s25_q ? {8'h0, sharpness_sums_detail_0_q} : select_3846;
  logic [31:0] select_3848;
  assign select_3848 = equal_1528_s25_q ? {8'h0, sharpness_sums_detail_1_q} : select_3847;
  logic [31:0] select_3849;
  assign select_3849 = equal_1526_s25_q ? {8'h0, sharpness_sums_contrast_0_s25_q} : select_3848;
  logic [31:0] select_3850;
  assign select_3850 = equal_1524_s25_q ? {8'h0, sharpness_sums_contrast_1_s25_q} : select_3849;

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1520_s25_q, lower_half_s25_q, registration_of_right_s25_q};
  logic registration_sums_we;
  assign registration_sums_we = s25_en & and_1579_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1578_s25_q, sum_1574_s25_q};
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
  assign map_waddr = {sum_1925_s25_q, index_2_s25_q};
  logic map_we;
  assign map_we = s25_en & and_1999_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1989_s25_q, is_seen_s25_q};
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
      sharpness_sums_detail_0_q <= and_500_s25_q ? select_2170 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_500_s25_q ? select_2182 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s25_q ? select_2224 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s25_q ? select_2226 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s25_q ? select_2253 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s25_q ? select_2259 : sharpness_comparing_less_contrast_1_q;
      counts_unproven_q <= select_2426;
      counts_regions_bad_q <= select_2440;
      counts_skin_unproven_q <= select_2462;
      registration_moved_q <= not_2646_s25_q & (registration_moved_q | and_2668_s25_q);
      patches_place_0_valid_q <= sample_pair_whole_s25_q ? select_1708 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s25_q ? select_1737 : patches_place_1_valid_q;
      patches_set_q <= select_2871;
      patches_size_q <= sum_2873;
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
      census_changes_values_2_left_q <= select_2136;
      census_changes_values_2_right_q <= select_2137;
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
  logic and_500_s26_q;
  logic so_s26_q;
  logic less_534_s26_q;
  logic less_535_s26_q;
  logic less_536_s26_q;
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
  logic and_565_s26_q;
  logic and_590_s26_q;
  logic and_591_s26_q;
  logic [8:0] sum_613_s26_q;
  logic equal_1469_s26_q;
  logic equal_1514_s26_q;
  logic equal_1522_s26_q;
  logic and_1582_s26_q;
  logic select_1599_s26_q;
  logic equal_1600_s26_q;
  logic equal_1690_s26_q;
  logic equal_1692_s26_q;
  logic select_1706_s26_q;
  logic select_1708_s26_q;
  logic equal_1714_s26_q;
  logic [4:0] select_1720_s26_q;
  logic select_1726_s26_q;
  logic select_1737_s26_q;
  logic equal_1743_s26_q;
  logic or_1758_s26_q;
  logic or_1762_s26_q;
  logic [3:0] select_1765_s26_q;
  logic less_1830_s26_q;
  logic equal_1831_s26_q;
  logic not_1832_s26_q;
  logic equal_1833_s26_q;
  logic not_1859_s26_q;
  logic and_1919_s26_q;
  logic less_1920_s26_q;
  logic [1:0] map_rdata_s26_q;
  logic is_seen_s26_q;
  logic and_1989_s26_q;
  logic equal_2139_s26_q;
  logic [8:0] sum_2142_s26_q;
  logic equal_2192_s26_q;
  logic less_2193_s26_q;
  logic [17:0] select_2205_s26_q;
  logic [17:0] select_2215_s26_q;
  logic equal_2236_s26_q;
  logic [9:0] select_2428_s26_q;
  logic [9:0] select_2431_s26_q;
  logic equal_2647_s26_q;
  logic [8:0] other_s26_q;
  logic [8:0] select_2883_s26_q;
  logic xor_2916_s26_q;
  logic xor_2953_s26_q;
  logic or_2961_s26_q;
  logic or_2965_s26_q;
  logic or_2969_s26_q;
  logic or_2976_s26_q;
  logic or_2980_s26_q;
  logic or_2984_s26_q;
  logic or_2991_s26_q;
  logic or_2995_s26_q;
  logic or_2999_s26_q;
  logic or_3009_s26_q;
  logic or_3013_s26_q;
  logic or_3017_s26_q;
  logic or_3025_s26_q;
  logic or_3029_s26_q;
  logic or_3033_s26_q;
  logic or_3040_s26_q;
  logic or_3044_s26_q;
  logic or_3048_s26_q;
  logic or_3058_s26_q;
  logic or_3062_s26_q;
  logic or_3066_s26_q;
  logic and_3070_s26_q;
  logic or_3074_s26_q;
  logic or_3078_s26_q;
  logic equal_3193_s26_q;
  logic [4:0] select_3281_s26_q;
  logic [9:0] select_3312_s26_q;
  logic [9:0] select_3322_s26_q;
  logic less_3355_s26_q;
  logic [2:0] fraction_s26_q;
  logic [13:0] product_3382_s26_q;
  logic equal_3434_s26_q;
  logic equal_3533_s26_q;
  logic or_3604_s26_q;
  logic select_3612_s26_q;
  logic and_3626_s26_q;
  logic [13:0] before_v_4_s26_q;
  logic not_3663_s26_q;
  logic or_3667_s26_q;
  logic and_3771_s26_q;
  logic and_3786_s26_q;
  logic and_3801_s26_q;
  logic [31:0] select_3850_s26_q;
  logic [9:0] select_3852_s26_q;
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
      and_500_s26_q <= and_500_s25_q;
      so_s26_q <= so_s25_q;
      less_534_s26_q <= less_534_s25_q;
      less_535_s26_q <= less_535_s25_q;
      less_536_s26_q <= less_536_s25_q;
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
      and_565_s26_q <= and_565_s25_q;
      and_590_s26_q <= and_590_s25_q;
      and_591_s26_q <= and_591_s25_q;
      sum_613_s26_q <= sum_613[13:5];
      equal_1469_s26_q <= equal_1469_s25_q;
      equal_1514_s26_q <= equal_1514_s25_q;
      equal_1522_s26_q <= equal_1522_s25_q;
      and_1582_s26_q <= and_1582_s25_q;
      select_1599_s26_q <= select_1599_s25_q;
      equal_1600_s26_q <= equal_1600_s25_q;
      equal_1690_s26_q <= equal_1690_s25_q;
      equal_1692_s26_q <= equal_1692_s25_q;
      select_1706_s26_q <= select_1706_s25_q;
      select_1708_s26_q <= select_1708;
      equal_1714_s26_q <= equal_1714;
      select_1720_s26_q <= select_1720_s25_q;
      select_1726_s26_q <= select_1726_s25_q;
      select_1737_s26_q <= select_1737;
      equal_1743_s26_q <= equal_1743;
      or_1758_s26_q <= and_1582_s25_q | (select_1708 & equal_1756_s25_q);
      or_1762_s26_q <= and_1582_s25_q | (select_1737 & equal_1760_s25_q);
      select_1765_s26_q <= select_1765_s25_q;
      less_1830_s26_q <= less_1830_s25_q;
      equal_1831_s26_q <= equal_1831_s25_q;
      not_1832_s26_q <= not_1832_s25_q;
      equal_1833_s26_q <= equal_1833_s25_q;
      not_1859_s26_q <= not_1859_s25_q;
      and_1919_s26_q <= and_1919_s25_q;
      less_1920_s26_q <= less_1920_s25_q;
      map_rdata_s26_q <= map_rdata_q;
      is_seen_s26_q <= is_seen_s25_q;
      and_1989_s26_q <= and_1989_s25_q;
      equal_2139_s26_q <= equal_2139_s25_q;
      sum_2142_s26_q <= sum_2142[13:5];
      equal_2192_s26_q <= equal_2192_s25_q;
      less_2193_s26_q <= less_2193_s25_q;
      select_2205_s26_q <= select_2205;
      select_2215_s26_q <= select_2215;
      equal_2236_s26_q <= equal_2236_s25_q;
      select_2428_s26_q <= select_2428_s25_q;
      select_2431_s26_q <= select_2431_s25_q;
      equal_2647_s26_q <= equal_2647_s25_q;
      other_s26_q <= other_s25_q[17:9];
      select_2883_s26_q <= select_2883_s25_q[17:9];
      xor_2916_s26_q <= xor_2916;
      xor_2953_s26_q <= xor_2953;
      or_2961_s26_q <= or_2961;
      or_2965_s26_q <= equal_2962_s25_q | and_2964_s25_q;
      or_2969_s26_q <= or_2969;
      or_2976_s26_q <= equal_2973_s25_q | and_2975_s25_q;
      or_2980_s26_q <= equal_2977_s25_q | and_2979_s25_q;
      or_2984_s26_q <= equal_2981_s25_q | and_2983_s25_q;
      or_2991_s26_q <= equal_2988_s25_q | and_2990_s25_q;
      or_2995_s26_q <= equal_2992_s25_q | and_2994_s25_q;
      or_2999_s26_q <= equal_2996_s25_q | and_2998_s25_q;
      or_3009_s26_q <= equal_3006_s25_q | and_3008_s25_q;
      or_3013_s26_q <= equal_3010_s25_q | and_3012_s25_q;
      or_3017_s26_q <= equal_3014_s25_q | and_3016_s25_q;
      or_3025_s26_q <= equal_3021_s25_q | (bits_s25_q & not_3023_s25_q);
      or_3029_s26_q <= equal_3026_s25_q | and_3028_s25_q;
      or_3033_s26_q <= equal_3030_s25_q | and_3032_s25_q;
      or_3040_s26_q <= equal_3037_s25_q | and_3039_s25_q;
      or_3044_s26_q <= equal_3041_s25_q | and_3043_s25_q;
      or_3048_s26_q <= equal_3045_s25_q | and_3047_s25_q;
      or_3058_s26_q <= or_3058;
      or_3062_s26_q <= or_3062;
      or_3066_s26_q <= or_3066;
      and_3070_s26_q <= and_3070;
      or_3074_s26_q <= or_3074;
      or_3078_s26_q <= (xor_2940 & xor_2952) | and_3077;
      equal_3193_s26_q <= equal_3193_s25_q;
      select_3281_s26_q <= select_3281_s25_q;
      select_3312_s26_q <= select_3312_s25_q[9:0];
      select_3322_s26_q <= select_3322_s25_q;
      less_3355_s26_q <= less_3355_s25_q;
      fraction_s26_q <= fraction;
      product_3382_s26_q <= product_3382[18:5];
      equal_3434_s26_q <= equal_3434_s25_q;
      equal_3533_s26_q <= equal_3533_s25_q;
      or_3604_s26_q <= or_3604_s25_q;
      select_3612_s26_q <= select_3612_s25_q;
      and_3626_s26_q <= equal_3625_s25_q & equal_3434_s25_q;
      before_v_4_s26_q <= before_v_4;
      not_3663_s26_q <= ~(equal_3628_s25_q & equal_3434_s25_q);
      or_3667_s26_q <= (equal_3628_s25_q | equal_3627_s25_q) | (x_s25_q[6:3] == 4'hf);
      and_3771_s26_q <= and_3771_s25_q;
      and_3786_s26_q <= and_3786_s25_q;
      and_3801_s26_q <= and_3801;
      select_3850_s26_q <= select_3850;
      select_3852_s26_q <= select_3852_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic hides_q;
  // hls/stages/patches.hpp:111
  logic [4:0] select_1759;
  assign select_1759 = or_1758_s26_q ? {and_1582_s26_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1763;
  assign select_1763 = or_1762_s26_q ? {and_1582_s26_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:119
  logic [3:0] column_5;
  assign column_5 = select_1759[4] ? select_1763[3:0] : select_1759[3:0];
  logic and_1768;
  assign and_1768 = select_1726_s26_q & (select_1720_s26_q[3] ^ select_1720_s26_q[4]);
  logic and_1773;
  assign and_1773 = sample_pair_whole_s26_q & (and_1768 & ((~select_1759[4]) | (~select_1763[4])));
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2205_s26_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2208;
  assign select_2208 = equal_2192_s26_q ? (less_2193_s26_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2215_s26_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2218;
  assign select_2218 = equal_2192_s26_q ? (less_2193_s26_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2778;
  assign select_2778 = sample_pair_whole_s26_q ? (select_1759[4] ? {1'b1, select_1759[3:0]} : (select_1759 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2781;
  assign select_2781 = sample_pair_whole_s26_q ? (select_1763[4] ? {1'b1, select_1763[3:0]} : (select_1763 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_2957;
  assign parity_2957 = ^{xor_2953_s26_q, xor_2916_s26_q, select_2883_s26_q, other_s26_q};
  logic parity_2987;
  assign parity_2987 = ^{or_2984_s26_q, or_2980_s26_q, or_2976_s26_q};
  logic parity_3002;
  assign parity_3002 = ^{or_2999_s26_q, or_2995_s26_q, or_2991_s26_q};
  logic parity_3005;
  assign parity_3005 = ^{or_2999_s26_q, or_2995_s26_q, or_2991_s26_q, or_2984_s26_q, or_2980_s26_q, or_2976_s26_q, or_2969_s26_q, or_2965_s26_q, or_2961_s26_q};
  logic parity_3036;
  assign parity_3036 = ^{or_3033_s26_q, or_3029_s26_q, or_3025_s26_q};
  logic parity_3051;
  assign parity_3051 = ^{or_3048_s26_q, or_3044_s26_q, or_3040_s26_q};
  logic parity_3054;
  assign parity_3054 = ^{or_3048_s26_q, or_3044_s26_q, or_3040_s26_q, or_3033_s26_q, or_3029_s26_q, or_3025_s26_q, or_3017_s26_q, or_3013_s26_q, or_3009_s26_q};
  logic parity_3069;
  assign parity_3069 = ^{or_3066_s26_q, or_3062_s26_q, or_3058_s26_q};
  logic parity_3081;
  assign parity_3081 = ^{or_3078_s26_q, or_3074_s26_q, and_3070_s26_q};
  logic parity_3084;
  assign parity_3084 = ^{or_3078_s26_q, or_3074_s26_q, and_3070_s26_q, or_3066_s26_q, or_3062_s26_q, or_3058_s26_q, or_3048_s26_q, or_3044_s26_q, or_3040_s26_q, or_3033_s26_q, or_3029_s26_q, or_3025_s26_q, or_3017_s26_q, or_3013_s26_q, or_3009_s26_q};
  logic parity_3086;
  assign parity_3086 = ^{or_3078_s26_q, or_3074_s26_q, and_3070_s26_q, or_3066_s26_q, or_3062_s26_q, or_3058_s26_q, or_3048_s26_q, or_3044_s26_q, or_3040_s26_q, or_3033_s26_q, or_3029_s26_q, or_3025_s26_q, or_3017_s26_q, or_3013_s26_q, or_3009_s26_q, or_2999_s26_q, or_2995_s26_q, or_2991_s26_q, or_2984_s26_q, or_2980_s26_q, or_2976_s26_q, or_2969_s26_q, or_2965_s26_q, or_2961_s26_q};
  // hls/stages/count_bits.hpp:25
  logic and_3087;
  assign and_3087 = parity_3005 & parity_3084;
  logic and_3090;
  assign and_3090 = (^{or_2969_s26_q, or_2965_s26_q, or_2961_s26_q}) & (parity_2987 | parity_3002);
  logic or_3091;
  assign or_3091 = (parity_2987 & parity_3002) | and_3090;
  logic or_3095;
  assign or_3095 = (parity_3069 & parity_3081) | (parity_3054 & (parity_3069 | parity_3081));
  logic and_3101;
  assign and_3101 = (^{or_3017_s26_q, or_3013_s26_q, or_3009_s26_q}) & (parity_3036 | parity_3051);
  logic or_3102;
  assign or_3102 = (parity_3036 & parity_3051) | and_3101;
  logic or_3106;
  assign or_3106 = (or_3062_s26_q & or_3066_s26_q) | (or_3058_s26_q & (or_3062_s26_q | or_3066_s26_q));
  logic or_3110;
  assign or_3110 = (or_3074_s26_q & or_3078_s26_q) | (and_3070_s26_q & (or_3074_s26_q | or_3078_s26_q));
  // hls/stages/count_bits.hpp:23
  logic or_3117;
  assign or_3117 = (or_3013_s26_q & or_3017_s26_q) | (or_3009_s26_q & (or_3013_s26_q | or_3017_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3121;
  assign or_3121 = (or_3029_s26_q & or_3033_s26_q) | (or_3025_s26_q & (or_3029_s26_q | or_3033_s26_q));
  logic or_3125;
  assign or_3125 = (or_3044_s26_q & or_3048_s26_q) | (or_3040_s26_q & (or_3044_s26_q | or_3048_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3128;
  assign parity_3128 = ^{or_3125, or_3121, or_3117};
  // hls/stages/count_bits.hpp:23
  logic or_3132;
  assign or_3132 = (or_2965_s26_q & or_2969_s26_q) | (or_2961_s26_q & (or_2965_s26_q | or_2969_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3136;
  assign or_3136 = (or_2980_s26_q & or_2984_s26_q) | (or_2976_s26_q & (or_2980_s26_q | or_2984_s26_q));
  logic or_3140;
  assign or_3140 = (or_2995_s26_q & or_2999_s26_q) | (or_2991_s26_q & (or_2995_s26_q | or_2999_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3143;
  assign parity_3143 = ^{or_3140, or_3136, or_3132};
  logic parity_3146;
  assign parity_3146 = ^{or_3140, or_3136, or_3132, or_3125, or_3121, or_3117, or_3110, or_3106, or_3102};
  // hls/stages/patches.hpp:534
  logic [9:0] difference_3325;
  assign difference_3325 = select_3322_s26_q - select_3312_s26_q;
  // hls/stages/patches.hpp:539
  logic or_3332;
  assign or_3332 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3312_s26_q);
  // hls/stages/patches.hpp:525
  logic [1:0] sum_3356;
  assign sum_3356 = select_3281_s26_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:526
  logic [7:0] difference_3376;
  assign difference_3376 = {sum_3356, select_3281_s26_q[2:0], 3'h0} - {5'h0, fraction_s26_q};
  logic [7:0] select_3377;
  assign select_3377 = less_3355_s26_q ? difference_3376 : {sum_3356, select_3281_s26_q[2:0], fraction_s26_q};
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_s26_q} - {1'b0, before_v_4_s26_q};
  // hls/stages/agreement.hpp:1161
  logic select_3633;
  assign select_3633 = and_3626_s26_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1234
  logic [1:0] select_3787;
  assign select_3787 = and_3786_s26_q ? {and_1989_s26_q, is_seen_s26_q} : map_rdata_s26_q;
  // hls/stages/agreement.hpp:1235
  logic and_3788;
  assign and_3788 = proven_q & less_3776;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      hides_q <= 1'b0;
    end else if (s26_en) begin
      sharpness_comparing_rest_0_q <= so_s26_q ? select_2208 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s26_q ? select_2218 : sharpness_comparing_rest_1_q;
      patches_left_next_0_q <= select_2778;
      patches_left_next_1_q <= select_2781;
      hides_q <= equal_1469_s26_q ? select_3633 : hides_q;
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
  logic and_500_s27_q;
  logic so_s27_q;
  logic less_534_s27_q;
  logic less_535_s27_q;
  logic less_536_s27_q;
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
  logic and_565_s27_q;
  logic and_590_s27_q;
  logic and_591_s27_q;
  logic less_614_s27_q;
  logic equal_1469_s27_q;
  logic equal_1514_s27_q;
  logic equal_1522_s27_q;
  logic and_1582_s27_q;
  logic select_1599_s27_q;
  logic equal_1600_s27_q;
  logic equal_1690_s27_q;
  logic equal_1692_s27_q;
  logic select_1706_s27_q;
  logic or_1716_s27_q;
  logic [4:0] select_1720_s27_q;
  logic select_1726_s27_q;
  logic or_1745_s27_q;
  logic [3:0] column_5_s27_q;
  logic [3:0] select_1765_s27_q;
  logic select_1766_s27_q;
  logic and_1773_s27_q;
  logic less_1830_s27_q;
  logic equal_1831_s27_q;
  logic not_1832_s27_q;
  logic equal_1833_s27_q;
  logic not_1859_s27_q;
  logic and_1919_s27_q;
  logic less_1920_s27_q;
  logic equal_2139_s27_q;
  logic and_2144_s27_q;
  logic equal_2192_s27_q;
  logic sum_s27_q;
  logic sum_2_s27_q;
  logic equal_2236_s27_q;
  logic select_2254_s27_q;
  logic select_2260_s27_q;
  logic [9:0] select_2428_s27_q;
  logic [9:0] select_2431_s27_q;
  logic equal_2647_s27_q;
  logic parity_2957_s27_q;
  logic parity_3086_s27_q;
  logic and_3087_s27_q;
  logic or_3091_s27_q;
  logic or_3095_s27_q;
  logic or_3102_s27_q;
  logic or_3106_s27_q;
  logic or_3110_s27_q;
  logic or_3117_s27_q;
  logic or_3121_s27_q;
  logic or_3125_s27_q;
  logic or_3132_s27_q;
  logic or_3136_s27_q;
  logic or_3140_s27_q;
  logic parity_3146_s27_q;
  logic or_3156_s27_q;
  logic or_3160_s27_q;
  logic and_3167_s27_q;
  logic and_3169_s27_q;
  logic and_3171_s27_q;
  logic equal_3193_s27_q;
  logic equal_3324_s27_q;
  logic less_3326_s27_q;
  logic less_3327_s27_q;
  logic or_3332_s27_q;
  logic [7:0] select_3377_s27_q;
  logic [13:0] product_3382_s27_q;
  logic equal_3434_s27_q;
  logic equal_3533_s27_q;
  logic or_3604_s27_q;
  logic select_3612_s27_q;
  logic select_3633_s27_q;
  logic and_3661_s27_q;
  logic not_3663_s27_q;
  logic or_3667_s27_q;
  logic and_3771_s27_q;
  logic and_3789_s27_q;
  logic and_3792_s27_q;
  logic and_3801_s27_q;
  logic [31:0] select_3850_s27_q;
  logic [9:0] select_3852_s27_q;
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
      and_500_s27_q <= and_500_s26_q;
      so_s27_q <= so_s26_q;
      less_534_s27_q <= less_534_s26_q;
      less_535_s27_q <= less_535_s26_q;
      less_536_s27_q <= less_536_s26_q;
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
      and_565_s27_q <= and_565_s26_q;
      and_590_s27_q <= and_590_s26_q;
      and_591_s27_q <= and_591_s26_q;
      less_614_s27_q <= 9'h4 < sum_613_s26_q;
      equal_1469_s27_q <= equal_1469_s26_q;
      equal_1514_s27_q <= equal_1514_s26_q;
      equal_1522_s27_q <= equal_1522_s26_q;
      and_1582_s27_q <= and_1582_s26_q;
      select_1599_s27_q <= select_1599_s26_q;
      equal_1600_s27_q <= equal_1600_s26_q;
      equal_1690_s27_q <= equal_1690_s26_q;
      equal_1692_s27_q <= equal_1692_s26_q;
      select_1706_s27_q <= select_1706_s26_q;
      or_1716_s27_q <= and_1582_s26_q | (select_1708_s26_q & equal_1714_s26_q);
      select_1720_s27_q <= select_1720_s26_q;
      select_1726_s27_q <= select_1726_s26_q;
      or_1745_s27_q <= and_1582_s26_q | (select_1737_s26_q & equal_1743_s26_q);
      column_5_s27_q <= column_5;
      select_1765_s27_q <= select_1765_s26_q;
      select_1766_s27_q <= or_1758_s26_q ? and_1582_s26_q : patches_left_next_0_q[4];
      and_1773_s27_q <= and_1773;
      less_1830_s27_q <= less_1830_s26_q;
      equal_1831_s27_q <= equal_1831_s26_q;
      not_1832_s27_q <= not_1832_s26_q;
      equal_1833_s27_q <= equal_1833_s26_q;
      not_1859_s27_q <= not_1859_s26_q;
      and_1919_s27_q <= and_1919_s26_q;
      less_1920_s27_q <= less_1920_s26_q;
      equal_2139_s27_q <= equal_2139_s26_q;
      and_2144_s27_q <= and_590_s26_q & (9'h4 < sum_2142_s26_q);
      equal_2192_s27_q <= equal_2192_s26_q;
      sum_s27_q <= sum[0];
      sum_2_s27_q <= sum_2[0];
      equal_2236_s27_q <= equal_2236_s26_q;
      select_2254_s27_q <= sharpness_comparing_less_contrast_0_q;
      select_2260_s27_q <= sharpness_comparing_less_contrast_1_q;
      select_2428_s27_q <= select_2428_s26_q;
      select_2431_s27_q <= select_2431_s26_q;
      equal_2647_s27_q <= equal_2647_s26_q;
      parity_2957_s27_q <= parity_2957;
      parity_3086_s27_q <= parity_3086;
      and_3087_s27_q <= and_3087;
      or_3091_s27_q <= or_3091;
      or_3095_s27_q <= or_3095;
      or_3102_s27_q <= or_3102;
      or_3106_s27_q <= or_3106;
      or_3110_s27_q <= or_3110;
      or_3117_s27_q <= or_3117;
      or_3121_s27_q <= or_3121;
      or_3125_s27_q <= or_3125;
      or_3132_s27_q <= or_3132;
      or_3136_s27_q <= or_3136;
      or_3140_s27_q <= or_3140;
      parity_3146_s27_q <= parity_3146;
      or_3156_s27_q <= (or_3121 & or_3125) | (or_3117 & (or_3121 | or_3125));
      or_3160_s27_q <= (or_3136 & or_3140) | (or_3132 & (or_3136 | or_3140));
      and_3167_s27_q <= and_3087 & (or_3091 | or_3095);
      and_3169_s27_q <= parity_3128 & parity_3143;
      and_3171_s27_q <= (^{or_3110, or_3106, or_3102}) & (parity_3128 | parity_3143);
      equal_3193_s27_q <= equal_3193_s26_q;
      equal_3324_s27_q <= select_3281_s26_q[3:0] == 4'h0;
      less_3326_s27_q <= {difference_3325, 2'h0} < {2'h0, patches_size_q};
      less_3327_s27_q <= select_3322_s26_q < select_3312_s26_q;
      or_3332_s27_q <= or_3332;
      select_3377_s27_q <= select_3377;
      product_3382_s27_q <= product_3382_s26_q;
      equal_3434_s27_q <= equal_3434_s26_q;
      equal_3533_s27_q <= equal_3533_s26_q;
      or_3604_s27_q <= or_3604_s26_q;
      select_3612_s27_q <= select_3612_s26_q;
      select_3633_s27_q <= select_3633;
      and_3661_s27_q <= over[14] & equal_3434_s26_q;
      not_3663_s27_q <= not_3663_s26_q;
      or_3667_s27_q <= or_3667_s26_q;
      and_3771_s27_q <= and_3771_s26_q;
      and_3789_s27_q <= select_3787[0] & and_3788;
      and_3792_s27_q <= select_3787[1] & and_3788;
      and_3801_s27_q <= and_3801_s26_q;
      select_3850_s27_q <= select_3850_s26_q;
      select_3852_s27_q <= select_3852_s26_q;
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
  logic and_615;
  assign and_615 = and_565_s27_q & less_614_s27_q;
  // hls/stages/patches.hpp:110
  logic [5:0] select_1727;
  assign select_1727 = or_1716_s27_q ? {and_1582_s27_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:114
  logic and_1729;
  assign and_1729 = select_1726_s27_q & (~select_1727[5]);
  // hls/stages/patches.hpp:110
  logic [5:0] select_1747;
  assign select_1747 = or_1745_s27_q ? {and_1582_s27_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:114
  logic and_1749;
  assign and_1749 = select_1726_s27_q & (~select_1747[5]);
  // hls/stages/census.hpp:306
  logic and_2145;
  assign and_2145 = and_590_s27_q & less_614_s27_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2146;
  assign sum_2146 = census_left_misses_q + {{17{and_2145}}, and_2144_s27_q, 1'b0, and_2144_s27_q};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2148;
  assign select_2148 = and_500_s27_q ? (equal_2139_s27_q ? 20'h0 : sum_2146) : census_left_misses_q;
  // hls/stages/agreement.hpp:207
  logic [2:0] select_2220;
  assign select_2220 = equal_2192_s27_q ? {sharpness_comparing_product_0_q[1:0], sum_s27_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2222;
  assign select_2222 = equal_2192_s27_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s27_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s27_q});
  // hls/stages/agreement.hpp:207
  logic select_2231;
  assign select_2231 = so_s27_q ? (equal_2192_s27_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s27_q});
  // hls/stages/agreement.hpp:207
  logic select_2234;
  assign select_2234 = equal_2192_s27_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_2237;
  assign xor_2237 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2243;
  assign xor_2243 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:104
  logic select_2761;
  assign select_2761 = equal_1600_s27_q ? patches_valid_0_q : (select_1599_s27_q ? patches_valid_0_q : select_1706_s27_q);
  // hls/stages/agreement.hpp:263
  logic select_2764;
  assign select_2764 = sample_pair_whole_s27_q ? (and_1729 ? (sample_present_s27_q & select_2761) : select_2761) : patches_valid_0_q;
  // hls/stages/patches.hpp:104
  logic select_2766;
  assign select_2766 = equal_1600_s27_q ? patches_valid_1_q : (select_1599_s27_q ? select_1706_s27_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2769;
  assign select_2769 = sample_pair_whole_s27_q ? (and_1749 ? (sample_present_s27_q & select_2766) : select_2766) : patches_valid_1_q;
  logic [5:0] select_2772;
  assign select_2772 = sample_pair_whole_s27_q ? (select_1727[5] ? {1'b1, select_1727[4:0]} : (select_1727 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2775;
  assign select_2775 = sample_pair_whole_s27_q ? (select_1747[5] ? {1'b1, select_1747[4:0]} : (select_1747 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3148;
  assign parity_3148 = ^{or_3140_s27_q, or_3136_s27_q, or_3132_s27_q, or_3125_s27_q, or_3121_s27_q, or_3117_s27_q, or_3110_s27_q, or_3106_s27_q, or_3102_s27_q, or_3095_s27_q, or_3091_s27_q, and_3087_s27_q};
  // hls/stages/count_bits.hpp:25
  logic or_3152;
  assign or_3152 = (or_3106_s27_q & or_3110_s27_q) | (or_3102_s27_q & (or_3106_s27_q | or_3110_s27_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3163;
  assign parity_3163 = ^{or_3160_s27_q, or_3156_s27_q, or_3152};
  // hls/stages/count_bits.hpp:25
  logic and_3164;
  assign and_3164 = (^{or_3095_s27_q, or_3091_s27_q, and_3087_s27_q}) & parity_3146_s27_q;
  logic or_3168;
  assign or_3168 = (or_3091_s27_q & or_3095_s27_q) | and_3167_s27_q;
  logic or_3172;
  assign or_3172 = and_3169_s27_q | and_3171_s27_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3175;
  assign parity_3175 = ^{or_3172, or_3168, and_3164};
  // hls/stages/count_bits.hpp:25
  logic and_3177;
  assign and_3177 = parity_3163 & parity_3175;
  logic or_3181;
  assign or_3181 = (or_3156_s27_q & or_3160_s27_q) | (or_3152 & (or_3156_s27_q | or_3160_s27_q));
  logic or_3185;
  assign or_3185 = (or_3168 & or_3172) | (and_3164 & (or_3168 | or_3172));
  // hls/stages/patches.hpp:539
  logic or_3333;
  assign or_3333 = (~(patches_second_s27_q ? patches_valid_1_q : patches_valid_0_q)) | or_3332_s27_q;
  logic or_3336;
  assign or_3336 = equal_3324_s27_q | (less_3326_s27_q | (less_3327_s27_q | or_3333));
  // hls/stages/patches.hpp:538
  logic [14:0] difference_3383;
  assign difference_3383 = {{7{select_3377_s27_q[7]}}, select_3377_s27_q} - {product_3382_s27_q[13], product_3382_s27_q};
  // hls/stages/patches.hpp:544
  logic less_3384;
  assign less_3384 = $signed({{8{difference_3354[6]}}, difference_3354}) < $signed(difference_3383);
  // hls/stages/agreement.hpp:1086
  logic not_3634;
  assign not_3634 = ~hidden_for_q[7];
  logic [7:0] select_3636;
  assign select_3636 = select_3633_s27_q ? (hidden_for_q + {7'h0, not_3634}) : 8'h0;
  // hls/stages/patches.hpp:314
  logic [7:0] select_3638;
  assign select_3638 = equal_1469_s27_q ? (equal_3533_s27_q ? select_3636 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1159
  logic and_3664;
  assign and_3664 = too_much_q & not_3663_s27_q;
  // hls/stages/agreement.hpp:1160
  logic select_3669;
  assign select_3669 = and_3661_s27_q ? (and_3664 | or_3667_s27_q) : and_3664;
  // hls/stages/agreement.hpp:424
  logic select_3791;
  assign select_3791 = and_1919_s27_q ? (less_1920_s27_q ? and_3789_s27_q : seen_q) : seen_q;
  logic select_3794;
  assign select_3794 = and_1919_s27_q ? (less_1920_s27_q ? and_3792_s27_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1088
  logic or_3816;
  assign or_3816 = select_2254_s27_q | ($signed(20'h0) < $signed(census_left_misses_q));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s27_q;
  logic fresh_we;
  assign fresh_we = s27_en & and_500_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s27_q, and_615, and_591_s27_q, and_590_s27_q, and_565_s27_q, less_557_s27_q, less_556_s27_q, less_555_s27_q, less_554_s27_q, less_553_s27_q, less_552_s27_q, less_551_s27_q, less_550_s27_q, less_549_s27_q, less_548_s27_q, less_547_s27_q, less_546_s27_q, less_545_s27_q, less_544_s27_q, less_543_s27_q, less_542_s27_q, less_541_s27_q, less_540_s27_q, less_539_s27_q, less_538_s27_q, less_537_s27_q, less_536_s27_q, less_535_s27_q, less_534_s27_q};
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
  assign patches_left_waddr = {select_1766_s27_q, select_1765_s27_q, column_5_s27_q};
  logic patches_left_we;
  assign patches_left_we = s27_en & and_1773_s27_q;
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
      census_left_misses_q <= select_2148;
      sharpness_comparing_product_0_q <= so_s27_q ? select_2220 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s27_q ? select_2222 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2231;
      sharpness_comparing_carry_1_q <= so_s27_q ? select_2234 : sharpness_comparing_carry_1_q;
      patches_valid_0_q <= select_2764;
      patches_valid_1_q <= select_2769;
      patches_right_next_0_q <= select_2772;
      patches_right_next_1_q <= select_2775;
      hidden_for_q <= select_3638;
      too_much_q <= equal_1469_s27_q ? select_3669 : too_much_q;
      seen_q <= select_3791;
      nearer_q <= select_3794;
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
  logic equal_1469_s28_q;
  logic equal_1514_s28_q;
  logic equal_1522_s28_q;
  logic equal_1690_s28_q;
  logic equal_1692_s28_q;
  logic [4:0] select_1717_s28_q;
  logic [4:0] select_1720_s28_q;
  logic and_1730_s28_q;
  logic [4:0] select_1746_s28_q;
  logic and_1750_s28_q;
  logic less_1830_s28_q;
  logic equal_1831_s28_q;
  logic not_1832_s28_q;
  logic equal_1833_s28_q;
  logic not_1859_s28_q;
  logic equal_2192_s28_q;
  logic or_2238_s28_q;
  logic and_2239_s28_q;
  logic or_2244_s28_q;
  logic and_2245_s28_q;
  logic select_2260_s28_q;
  logic [9:0] select_2428_s28_q;
  logic [9:0] select_2431_s28_q;
  logic equal_2647_s28_q;
  logic parity_2957_s28_q;
  logic parity_3086_s28_q;
  logic parity_3148_s28_q;
  logic xor_3176_s28_q;
  logic parity_3188_s28_q;
  logic and_3189_s28_q;
  logic and_3191_s28_q;
  logic equal_3193_s28_q;
  logic or_3336_s28_q;
  logic [5:0] difference_3383_s28_q;
  logic not_3385_s28_q;
  logic not_3395_s28_q;
  logic equal_3434_s28_q;
  logic less_3504_s28_q;
  logic less_3505_s28_q;
  logic equal_3533_s28_q;
  logic or_3604_s28_q;
  logic and_3771_s28_q;
  logic and_3801_s28_q;
  logic or_3807_s28_q;
  logic or_3816_s28_q;
  logic not_3828_s28_q;
  logic [31:0] select_3850_s28_q;
  logic [9:0] select_3852_s28_q;
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
      equal_1469_s28_q <= equal_1469_s27_q;
      equal_1514_s28_q <= equal_1514_s27_q;
      equal_1522_s28_q <= equal_1522_s27_q;
      equal_1690_s28_q <= equal_1690_s27_q;
      equal_1692_s28_q <= equal_1692_s27_q;
      select_1717_s28_q <= or_1716_s27_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1720_s28_q <= select_1720_s27_q;
      and_1730_s28_q <= sample_pair_whole_s27_q & and_1729;
      select_1746_s28_q <= or_1745_s27_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1750_s28_q <= sample_pair_whole_s27_q & and_1749;
      less_1830_s28_q <= less_1830_s27_q;
      equal_1831_s28_q <= equal_1831_s27_q;
      not_1832_s28_q <= not_1832_s27_q;
      equal_1833_s28_q <= equal_1833_s27_q;
      not_1859_s28_q <= not_1859_s27_q;
      equal_2192_s28_q <= equal_2192_s27_q;
      or_2238_s28_q <= equal_2236_s27_q | xor_2237;
      and_2239_s28_q <= five_times[0] & xor_2237;
      or_2244_s28_q <= equal_2236_s27_q | xor_2243;
      and_2245_s28_q <= five_times_2[0] & xor_2243;
      select_2260_s28_q <= select_2260_s27_q;
      select_2428_s28_q <= select_2428_s27_q;
      select_2431_s28_q <= select_2431_s27_q;
      equal_2647_s28_q <= equal_2647_s27_q;
      parity_2957_s28_q <= parity_2957_s27_q;
      parity_3086_s28_q <= parity_3086_s27_q;
      parity_3148_s28_q <= parity_3148;
      xor_3176_s28_q <= parity_3163 ^ parity_3175;
      parity_3188_s28_q <= ^{or_3185, or_3181, and_3177};
      and_3189_s28_q <= or_3181 & or_3185;
      and_3191_s28_q <= and_3177 & (or_3181 | or_3185);
      equal_3193_s28_q <= equal_3193_s27_q;
      or_3336_s28_q <= or_3336;
      difference_3383_s28_q <= difference_3383[5:0];
      not_3385_s28_q <= ~less_3384;
      not_3395_s28_q <= ~($signed(difference_3383) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3434_s28_q <= equal_3434_s27_q;
      less_3504_s28_q <= $signed(15'h10) < $signed(difference_3383);
      less_3505_s28_q <= $signed(difference_3383[14:4]) < $signed(11'h7ff);
      equal_3533_s28_q <= equal_3533_s27_q;
      or_3604_s28_q <= or_3604_s27_q;
      and_3771_s28_q <= and_3771_s27_q;
      and_3801_s28_q <= and_3801_s27_q;
      or_3807_s28_q <= select_3612_s27_q | select_3669;
      or_3816_s28_q <= or_3816;
      not_3828_s28_q <= ~(select_3636 < cfg_hidden_frames_i);
      select_3850_s28_q <= select_3850_s27_q;
      select_3852_s28_q <= select_3852_s27_q;
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
  // hls/stages/patches.hpp:160
  logic less_1842;
  assign less_1842 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:161
  logic not_1843;
  assign not_1843 = ~less_1842;
  logic [1:0] select_1844;
  assign select_1844 = patches_summed_first_s28_q ? 2'h2 : {less_1842, not_1843};
  logic [12:0] select_1845;
  assign select_1845 = select_1844[0] ? {4'h0, patches_summed_first_s28_q, 3'h0, patches_summed_row_column_s28_q} : {patches_summed_row_column_s28_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1846;
  assign select_1846 = select_1844[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1847;
  assign select_1847 = select_1844[1] ? {select_1845[12:8], patches_sums_values_0_q[9:8], select_1845[7:0]} : select_1846;
  // hls/stages/census.hpp:385
  logic select_2240;
  assign select_2240 = or_2238_s28_q ? and_2239_s28_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2241;
  assign select_2241 = equal_2192_s28_q ? select_2240 : sharpness_comparing_less_detail_0_q;
  logic select_2242;
  assign select_2242 = so_s28_q ? select_2241 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_2246;
  assign select_2246 = or_2244_s28_q ? and_2245_s28_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2247;
  assign select_2247 = equal_2192_s28_q ? select_2246 : sharpness_comparing_less_detail_1_q;
  logic select_2248;
  assign select_2248 = so_s28_q ? select_2247 : sharpness_comparing_less_detail_1_q;
  // hls/stages/count_bits.hpp:27
  logic or_3192;
  assign or_3192 = and_3189_s28_q | and_3191_s28_q;
  // hls/stages/patches.hpp:465
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3192, parity_3188_s28_q, xor_3176_s28_q, parity_3148_s28_q, parity_3086_s28_q, parity_2957_s28_q} + (equal_3193_s28_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:160
  logic [9:0] select_3197;
  assign select_3197 = equal_1690_s28_q ? patches_sums_values_0_q : (equal_1692_s28_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3198;
  assign select_3198 = equal_1692_s28_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3200;
  assign select_3200 = equal_1692_s28_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3202;
  assign select_3202 = equal_1692_s28_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3204;
  assign select_3204 = equal_1692_s28_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3206;
  assign select_3206 = equal_1692_s28_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3208;
  assign select_3208 = equal_1692_s28_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3210;
  assign select_3210 = equal_1692_s28_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3212;
  assign select_3212 = equal_1692_s28_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3214;
  assign select_3214 = equal_1692_s28_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3216;
  assign select_3216 = equal_1692_s28_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3218;
  assign select_3218 = equal_1692_s28_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3220;
  assign select_3220 = equal_1692_s28_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3222;
  assign select_3222 = equal_1692_s28_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3224;
  assign select_3224 = equal_1692_s28_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3226;
  assign select_3226 = equal_1692_s28_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3228;
  assign select_3228 = equal_1692_s28_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:519
  logic not_3337;
  assign not_3337 = ~or_3336_s28_q;
  // hls/stages/patches.hpp:500
  logic and_3338;
  assign and_3338 = equal_1833_s28_q & not_3337;
  // hls/stages/patches.hpp:160
  logic and_3341;
  assign and_3341 = equal_1690_s28_q & (less_1830_s28_q ? (not_1832_s28_q & and_3338) : and_3338);
  // hls/stages/patches.hpp:500
  logic and_3344;
  assign and_3344 = equal_1833_s28_q & (patches_second_s28_q & not_3337);
  // hls/stages/patches.hpp:160
  logic and_3347;
  assign and_3347 = equal_1690_s28_q & (less_1830_s28_q ? (not_1832_s28_q & and_3344) : and_3344);
  // hls/stages/patches.hpp:500
  logic and_3387;
  assign and_3387 = equal_1833_s28_q & (not_3337 & not_3385_s28_q);
  // hls/stages/patches.hpp:160
  logic and_3390;
  assign and_3390 = equal_1690_s28_q & (less_1830_s28_q ? (not_1832_s28_q & and_3387) : and_3387);
  // hls/stages/patches.hpp:500
  logic and_3397;
  assign and_3397 = equal_1833_s28_q & (not_3337 & not_3395_s28_q);
  // hls/stages/patches.hpp:160
  logic and_3400;
  assign and_3400 = equal_1690_s28_q & (less_1830_s28_q ? (not_1832_s28_q & and_3397) : and_3397);
  // hls/stages/agreement.hpp:1072
  logic less_3433;
  assign less_3433 = x_s28_q[5:3] < 3'h5;
  // hls/stages/registration.hpp:150
  logic not_3435;
  assign not_3435 = ~x_s28_q[4];
  // hls/stages/registration.hpp:157
  logic not_3436;
  assign not_3436 = ~x_s28_q[3];
  // hls/stages/patches.hpp:176
  logic and_3437;
  assign and_3437 = not_3435 & not_3436;
  logic [1:0] select_3438;
  assign select_3438 = x_s28_q[4] ? {1'b1, x_s28_q[3]} : {not_3436, 1'b1};
  logic [3:0] select_3439;
  assign select_3439 = x_s28_q[5] ? {{2{and_3437}}, 2'h0} : {not_3436, not_3435, select_3438};
  // hls/stages/agreement.hpp:1084
  logic and_3442;
  assign and_3442 = not_1859_s28_q & (less_3433 & (equal_3434_s28_q & select_3439[0]));
  // hls/stages/patches.hpp:176
  logic equal_3446;
  assign equal_3446 = x_s28_q[2:0] == 3'h1;
  // hls/stages/agreement.hpp:1084
  logic and_3450;
  assign and_3450 = x_s28_q[6] & (not_1859_s28_q & (less_3433 & (select_3439[1] & equal_3446)));
  logic and_3457;
  assign and_3457 = not_1859_s28_q & (less_3433 & (select_3439[2] & (x_s28_q[2:0] == 3'h2)));
  logic and_3465;
  assign and_3465 = not_1859_s28_q & (less_3433 & (select_3439[3] & (x_s28_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:180
  logic [4:0] sum_3484;
  assign sum_3484 = {2'h0, x_s28_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:314
  logic and_3493;
  assign and_3493 = equal_1469_s28_q & (x_s28_q[6] & (not_1859_s28_q & (less_3433 & equal_3446)));
  // hls/stages/patches.hpp:545
  logic [5:0] select_3507;
  assign select_3507 = less_3504_s28_q ? 6'h10 : (less_3505_s28_q ? 6'h30 : difference_3383_s28_q);
  // hls/stages/patches.hpp:500
  logic [5:0] select_3509;
  assign select_3509 = equal_1833_s28_q ? (or_3336_s28_q ? 6'h0 : select_3507) : 6'h0;
  logic [5:0] select_3511;
  assign select_3511 = less_1830_s28_q ? (equal_1831_s28_q ? 6'h0 : select_3509) : select_3509;
  // hls/stages/patches.hpp:314
  logic and_3518;
  assign and_3518 = equal_1469_s28_q & (x_s28_q[6] & (not_1859_s28_q & (equal_2647_s28_q & less_3433)));
  // hls/stages/agreement.hpp:1084
  logic and_3522;
  assign and_3522 = x_s28_q[6] & (not_1859_s28_q & (less_3433 & (x_s28_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:314
  logic and_3804;
  assign and_3804 = equal_1469_s28_q & (equal_3533_s28_q & (cfg_prove_i & or_3604_s28_q));
  // hls/stages/agreement.hpp:1170
  logic not_3806;
  assign not_3806 = ~(or_3604_s28_q | not_3795);
  // hls/stages/patches.hpp:314
  logic and_3810;
  assign and_3810 = equal_1469_s28_q & (equal_3533_s28_q & (not_3806 & or_3807_s28_q));
  logic and_3823;
  assign and_3823 = equal_3533_s28_q & (not_3806 & (select_2248 | select_2260_s28_q));
  // hls/stages/agreement.hpp:1088
  logic and_3830;
  assign and_3830 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_3828_s28_q);
  // hls/stages/patches.hpp:314
  logic and_3836;
  assign and_3836 = equal_1469_s28_q & (x_s28_q[6] & (not_1859_s28_q | (4'hc < x_s28_q[5:2])));

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1720_s28_q, select_1717_s28_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s28_en & and_1730_s28_q;
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
  assign patches_right_1_waddr = {select_1720_s28_q, select_1746_s28_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s28_en & and_1750_s28_q;
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
      sharpness_comparing_less_detail_0_q <= select_2242;
      sharpness_comparing_less_detail_1_q <= select_2248;
      patches_sums_values_0_q <= select_3197;
      patches_sums_values_1_q <= equal_1690_s28_q ? patches_sums_values_1_q : select_3198;
      patches_sums_values_2_q <= equal_1690_s28_q ? patches_sums_values_2_q : select_3200;
      patches_sums_values_3_q <= equal_1690_s28_q ? patches_sums_values_3_q : select_3202;
      patches_sums_values_4_q <= equal_1690_s28_q ? patches_sums_values_4_q : select_3204;
      patches_sums_values_5_q <= equal_1690_s28_q ? patches_sums_values_5_q : select_3206;
      patches_sums_values_6_q <= equal_1690_s28_q ? patches_sums_values_6_q : select_3208;
      patches_sums_values_7_q <= equal_1690_s28_q ? patches_sums_values_7_q : select_3210;
      patches_sums_values_8_q <= equal_1690_s28_q ? patches_sums_values_8_q : select_3212;
      patches_sums_values_9_q <= equal_1690_s28_q ? patches_sums_values_9_q : select_3214;
      patches_sums_values_10_q <= equal_1690_s28_q ? patches_sums_values_10_q : select_3216;
      patches_sums_values_11_q <= equal_1690_s28_q ? patches_sums_values_11_q : select_3218;
      patches_sums_values_12_q <= equal_1690_s28_q ? patches_sums_values_12_q : select_3220;
      patches_sums_values_13_q <= equal_1690_s28_q ? patches_sums_values_13_q : select_3222;
      patches_sums_values_14_q <= equal_1690_s28_q ? patches_sums_values_14_q : select_3224;
      patches_sums_values_15_q <= equal_1690_s28_q ? patches_sums_values_15_q : select_3226;
      patches_sums_values_16_q <= equal_1690_s28_q ? patches_sums_values_16_q : select_3228;
      patches_best_differing_q <= select_1847[9:0];
      patches_best_column_q <= select_1847[14:10];
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
  logic equal_1469_s29_q;
  logic equal_1514_s29_q;
  logic equal_1522_s29_q;
  logic [9:0] select_2428_s29_q;
  logic [9:0] select_2431_s29_q;
  logic and_3341_s29_q;
  logic and_3347_s29_q;
  logic and_3390_s29_q;
  logic and_3400_s29_q;
  logic and_3443_s29_q;
  logic and_3450_s29_q;
  logic and_3458_s29_q;
  logic and_3466_s29_q;
  logic and_3487_s29_q;
  logic and_3493_s29_q;
  logic [5:0] select_3512_s29_q;
  logic and_3518_s29_q;
  logic and_3523_s29_q;
  logic equal_3533_s29_q;
  logic and_3771_s29_q;
  logic or_3796_s29_q;
  logic and_3797_s29_q;
  logic and_3801_s29_q;
  logic and_3804_s29_q;
  logic and_3810_s29_q;
  logic and_3819_s29_q;
  logic and_3823_s29_q;
  logic and_3832_s29_q;
  logic and_3836_s29_q;
  logic [31:0] select_3850_s29_q;
  logic [9:0] select_3852_s29_q;
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
      equal_1469_s29_q <= equal_1469_s28_q;
      equal_1514_s29_q <= equal_1514_s28_q;
      equal_1522_s29_q <= equal_1522_s28_q;
      select_2428_s29_q <= select_2428_s28_q;
      select_2431_s29_q <= select_2431_s28_q;
      and_3341_s29_q <= and_3341;
      and_3347_s29_q <= and_3347;
      and_3390_s29_q <= and_3390;
      and_3400_s29_q <= and_3400;
      and_3443_s29_q <= x_s28_q[6] & and_3442;
      and_3450_s29_q <= and_3450;
      and_3458_s29_q <= x_s28_q[6] & and_3457;
      and_3466_s29_q <= x_s28_q[6] & and_3465;
      and_3487_s29_q <= not_1859_s28_q & (less_3433 & (sum_3484[4:2] == 3'h0));
      and_3493_s29_q <= and_3493;
      select_3512_s29_q <= equal_1690_s28_q ? select_3511 : 6'h0;
      and_3518_s29_q <= and_3518;
      and_3523_s29_q <= equal_1469_s28_q & and_3522;
      equal_3533_s29_q <= equal_3533_s28_q;
      and_3771_s29_q <= and_3771_s28_q;
      or_3796_s29_q <= not_3795 | seen_q;
      and_3797_s29_q <= cfg_prove_i & nearer_q;
      and_3801_s29_q <= and_3801_s28_q;
      and_3804_s29_q <= and_3804;
      and_3810_s29_q <= and_3810;
      and_3819_s29_q <= equal_3533_s28_q & (not_3806 & (select_2242 | or_3816_s28_q));
      and_3823_s29_q <= and_3823;
      and_3832_s29_q <= equal_1469_s28_q & (equal_3533_s28_q & and_3830);
      and_3836_s29_q <= and_3836;
      select_3850_s29_q <= select_3850_s28_q;
      select_3852_s29_q <= select_3852_s28_q;
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
  logic [4:0] patches_found_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [4:0] patches_round_moved_q;
  logic patches_moved_q;
  // hls/stages/patches.hpp:577
  logic not_3342;
  assign not_3342 = ~patches_lower_s29_q;
  logic not_3348;
  assign not_3348 = ~and_3347_s29_q;
  // hls/stages/patches.hpp:164
  logic and_3350;
  assign and_3350 = and_3341_s29_q & (not_3342 & not_3348);
  // hls/stages/patches.hpp:579
  logic [7:0] sum_3352;
  assign sum_3352 = {7'h0, and_3350} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:580
  logic and_3391;
  assign and_3391 = and_3390_s29_q & and_3350;
  logic [7:0] sum_3392;
  assign sum_3392 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3391};
  // hls/stages/patches.hpp:581
  logic and_3401;
  assign and_3401 = and_3400_s29_q & and_3350;
  logic [7:0] sum_3402;
  assign sum_3402 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3401};
  // hls/stages/patches.hpp:164
  logic and_3404;
  assign and_3404 = and_3341_s29_q & (and_3347_s29_q & not_3342);
  // hls/stages/patches.hpp:579
  logic [7:0] sum_3406;
  assign sum_3406 = {7'h0, and_3404} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:580
  logic and_3408;
  assign and_3408 = and_3390_s29_q & and_3404;
  logic [7:0] sum_3409;
  assign sum_3409 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3408};
  // hls/stages/patches.hpp:581
  logic and_3411;
  assign and_3411 = and_3400_s29_q & and_3404;
  logic [7:0] sum_3412;
  assign sum_3412 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3411};
  // hls/stages/patches.hpp:164
  logic and_3414;
  assign and_3414 = and_3341_s29_q & (patches_lower_s29_q & not_3348);
  // hls/stages/patches.hpp:579
  logic [7:0] sum_3416;
  assign sum_3416 = {7'h0, and_3414} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:580
  logic and_3418;
  assign and_3418 = and_3390_s29_q & and_3414;
  logic [7:0] sum_3419;
  assign sum_3419 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3418};
  // hls/stages/patches.hpp:581
  logic and_3421;
  assign and_3421 = and_3400_s29_q & and_3414;
  logic [7:0] sum_3422;
  assign sum_3422 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3421};
  // hls/stages/patches.hpp:164
  logic and_3424;
  assign and_3424 = and_3341_s29_q & (patches_lower_s29_q & and_3347_s29_q);
  // hls/stages/patches.hpp:579
  logic [7:0] sum_3426;
  assign sum_3426 = {7'h0, and_3424} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:580
  logic and_3428;
  assign and_3428 = and_3390_s29_q & and_3424;
  logic [7:0] sum_3429;
  assign sum_3429 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3428};
  // hls/stages/patches.hpp:581
  logic and_3431;
  assign and_3431 = and_3400_s29_q & and_3424;
  logic [7:0] sum_3432;
  assign sum_3432 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3431};
  // hls/stages/patches.hpp:314
  logic and_3444;
  assign and_3444 = equal_1469_s29_q & and_3443_s29_q;
  logic and_3451;
  assign and_3451 = equal_1469_s29_q & and_3450_s29_q;
  // hls/stages/patches.hpp:561
  logic [7:0] or_3453;
  assign or_3453 = (and_3444 ? patches_quarters_0_places_q : 8'h0) | (and_3451 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/patches.hpp:314
  logic and_3459;
  assign and_3459 = equal_1469_s29_q & and_3458_s29_q;
  logic and_3467;
  assign and_3467 = equal_1469_s29_q & and_3466_s29_q;
  // hls/stages/patches.hpp:561
  logic [7:0] or_3469;
  assign or_3469 = (or_3453 | (and_3459 ? patches_quarters_2_places_q : 8'h0)) | (and_3467 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:562
  logic [7:0] or_3472;
  assign or_3472 = (and_3444 ? patches_quarters_0_up_q : 8'h0) | (and_3451 ? patches_quarters_1_up_q : 8'h0);
  logic [7:0] or_3476;
  assign or_3476 = (or_3472 | (and_3459 ? patches_quarters_2_up_q : 8'h0)) | (and_3467 ? patches_quarters_3_up_q : 8'h0);
  // hls/stages/patches.hpp:563
  logic [7:0] or_3479;
  assign or_3479 = (and_3444 ? patches_quarters_0_down_q : 8'h0) | (and_3451 ? patches_quarters_1_down_q : 8'h0);
  logic [7:0] or_3483;
  assign or_3483 = (or_3479 | (and_3459 ? patches_quarters_2_down_q : 8'h0)) | (and_3467 ? patches_quarters_3_down_q : 8'h0);
  // hls/stages/patches.hpp:314
  logic and_3489;
  assign and_3489 = equal_1469_s29_q & (x_s29_q[6] & and_3487_s29_q);
  // hls/stages/patches.hpp:556
  logic [7:0] sum_3495;
  assign sum_3495 = patches_word_places_q + (and_3493_s29_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:558
  logic [7:0] select_3499;
  assign select_3499 = and_3489 ? (patches_word_up_q + (and_3493_s29_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3501;
  assign sum_3501 = patches_word_down_q + (and_3493_s29_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:583
  logic [5:0] select_3513;
  assign select_3513 = and_3341_s29_q ? select_3512_s29_q : 6'h0;
  logic [11:0] sum_3514;
  assign sum_3514 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3513[5]}}, select_3513};
  // hls/stages/patches.hpp:572
  logic [7:0] select_3525;
  assign select_3525 = and_3518_s29_q ? (and_3523_s29_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:574
  logic or_3529;
  assign or_3529 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:571
  logic select_3531;
  assign select_3531 = and_3518_s29_q ? (and_3523_s29_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:164
  logic and_3537;
  assign and_3537 = patches_complete_q & (equal_1469_s29_q & ((x_s29_q == 7'h70) & (~equal_3533_s29_q)));
  logic and_3538;
  assign and_3538 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:571
  logic [4:0] select_3539;
  assign select_3539 = and_3518_s29_q ? {and_3538, patches_found_q[4:1]} : patches_found_q;
  logic [4:0] select_3541;
  assign select_3541 = and_3518_s29_q ? (and_3523_s29_q ? {and_3538, patches_found_q[4:1]} : select_3539) : patches_found_q;
  // hls/stages/patches.hpp:570
  logic select_3547;
  assign select_3547 = patches_round_ends_q ? (~(patches_found_q == 5'h0)) : patches_moved_q;
  // hls/stages/patches.hpp:314
  logic and_3813;
  assign and_3813 = equal_3533_s29_q & (cfg_prove_i & (registration_moved_s29_q | patches_moved_q));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3851;
  assign select_3851 = equal_1522_s29_q ? {7'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3850_s29_q;
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_3853;
  assign select_3853 = equal_1514_s29_q ? select_3851 : {2'h0, select_3852_s29_q, select_2431_s29_q, select_2428_s29_q};

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
      patches_found_q <= 5'h0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 5'h0;
      patches_moved_q <= 1'b0;
    end else if (s29_en) begin
      patches_quarters_0_places_q <= sum_3352;
      patches_quarters_0_up_q <= sum_3392;
      patches_quarters_0_down_q <= sum_3402;
      patches_quarters_1_places_q <= sum_3406;
      patches_quarters_1_up_q <= sum_3409;
      patches_quarters_1_down_q <= sum_3412;
      patches_quarters_2_places_q <= sum_3416;
      patches_quarters_2_up_q <= sum_3419;
      patches_quarters_2_down_q <= sum_3422;
      patches_quarters_3_places_q <= sum_3426;
      patches_quarters_3_up_q <= sum_3429;
      patches_quarters_3_down_q <= sum_3432;
      patches_word_places_q <= or_3469;
      patches_word_up_q <= or_3476;
      patches_word_down_q <= or_3483;
      patches_sum_places_q <= and_3489 ? sum_3495 : patches_sum_places_q;
      patches_sum_up_q <= select_3499;
      patches_sum_down_q <= and_3489 ? sum_3501 : patches_sum_down_q;
      patches_across_q <= sum_3514;
      patches_places_q <= select_3525;
      patches_enough_q <= {3'h0, and_3523_s29_q, 1'b0} < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3529;
      patches_complete_q <= select_3531;
      patches_round_ends_q <= and_3537;
      patches_found_q <= select_3541;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_moved_q <= select_3547;
    end
  end

  logic [7:0] pixel_0_s30_q;
  logic [7:0] pixel_1_s30_q;
  logic saturated_s30_q;
  logic mask_s30_q;
  logic marks_first_s30_q;
  logic marks_last_s30_q;
  logic and_3771_s30_q;
  logic or_3796_s30_q;
  logic and_3797_s30_q;
  logic and_3801_s30_q;
  logic and_3804_s30_q;
  logic and_3810_s30_q;
  logic and_3814_s30_q;
  logic and_3820_s30_q;
  logic and_3824_s30_q;
  logic and_3832_s30_q;
  logic and_3836_s30_q;
  logic [5:0] select_3838_s30_q;
  logic [31:0] select_3855_s30_q;
  always_ff @(posedge clk_i) begin
    if (s29_en) begin
      pixel_0_s30_q <= pixel_0_s29_q;
      pixel_1_s30_q <= pixel_1_s29_q;
      saturated_s30_q <= saturated_s29_q;
      mask_s30_q <= mask_s29_q;
      marks_first_s30_q <= marks_first_s29_q;
      marks_last_s30_q <= marks_last_s29_q;
      and_3771_s30_q <= and_3771_s29_q;
      or_3796_s30_q <= or_3796_s29_q;
      and_3797_s30_q <= and_3797_s29_q;
      and_3801_s30_q <= and_3801_s29_q;
      and_3804_s30_q <= and_3804_s29_q;
      and_3810_s30_q <= and_3810_s29_q;
      and_3814_s30_q <= equal_1469_s29_q & and_3813;
      and_3820_s30_q <= equal_1469_s29_q & and_3819_s29_q;
      and_3824_s30_q <= equal_1469_s29_q & and_3823_s29_q;
      and_3832_s30_q <= and_3832_s29_q;
      and_3836_s30_q <= and_3836_s29_q;
      select_3838_s30_q <= equal_1469_s29_q ? (x_s29_q[6] ? x_s29_q[5:0] : 6'h0) : 6'h0;
      select_3855_s30_q <= equal_1469_s29_q ? (x_s29_q[6] ? select_3853 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s30_q;
  assign pixel_1_o = pixel_1_s30_q;
  assign saturated_o = saturated_s30_q;
  assign mask_o = mask_s30_q;
  assign marks_first_o = marks_first_s30_q;
  assign marks_last_o = marks_last_s30_q;
  assign marks_seen_o = or_3796_s30_q;
  assign marks_nearer_o = and_3797_s30_q;
  assign verdict_valid_o = and_3771_s30_q;
  assign verdict_unproven_yet_o = and_3801_s30_q;
  assign verdict_untextured_o = and_3804_s30_q;
  assign verdict_disagree_o = and_3810_s30_q;
  assign verdict_moved_o = and_3814_s30_q;
  assign verdict_unsharp_left_o = and_3820_s30_q;
  assign verdict_unsharp_right_o = and_3824_s30_q;
  assign verdict_hidden_o = and_3832_s30_q;
  assign frame_valid_o = and_3836_s30_q;
  assign frame_index_o = select_3838_s30_q;
  assign frame_word_o = select_3855_s30_q;
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
  assign unused_bits = ^{over[13:0], sum_3484[1:0], product_3382[4:0], sum_2484[0], detail_4[1:0], detail_3[1:0], sum_2142[4:0], sum_1671[1:0], sum_1670[1:0], sum_1666[0], sum_1617[0], sum_1613[0], sum_613[4:0], cfg_width_i[3:0]};

endmodule
