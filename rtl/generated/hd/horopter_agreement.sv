// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 25 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2997 bits, pipeline 8484 bits, memories 122127 bits.
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
  input  logic [4:0] cfg_on_skin_limit_i,
  input  logic [7:0] cfg_on_skin_cells_i,
  input  logic cfg_alarm_before_i,
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
  output logic verdict_overlooked_o,
  output logic frame_valid_o,
  output logic [5:0] frame_index_o,
  output logic [31:0] frame_word_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en;
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

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_2402;
  assign sum_2402 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3439;
  assign difference_3439 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3657;
  assign not_3657 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3714;
  assign difference_3714 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_3929;
  assign less_3929 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_3930;
  assign sum_3930 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_3948;
  assign not_3948 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_485;
  assign select_485 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_485 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_485_s1_q;
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
      select_485_s1_q <= select_485;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:35
  logic [6:0] select_488;
  assign select_488 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:50
  logic equal_520;
  assign equal_520 = select_485_s1_q == 4'hf;
  // hls/stages/agreement.hpp:270
  logic [6:0] select_2051;
  assign select_2051 = sample_pair_whole_s1_q ? (select_488 + {6'h0, equal_520}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2051;
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
  logic [3:0] select_485_s2_q;
  logic [6:0] select_488_s2_q;
  logic equal_520_s2_q;
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
      select_485_s2_q <= select_485_s1_q;
      select_488_s2_q <= select_488;
      equal_520_s2_q <= equal_520;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:109
  logic equal_486;
  assign equal_486 = select_485_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:115
  logic [8:0] select_491;
  assign select_491 = ({select_488_s2_q, select_485_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_492;
  assign select_492 = equal_486 ? select_491 : averager_place_q;
  // hls/stages/census.hpp:41
  logic [3:0] select_503;
  assign select_503 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_2049;
  assign select_2049 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_503 + 4'h1) : select_503) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2049;
      averager_place_q <= sample_pair_whole_s2_q ? select_492 : averager_place_q;
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
  logic [3:0] select_485_s3_q;
  logic equal_486_s3_q;
  logic [6:0] select_488_s3_q;
  logic [8:0] select_492_s3_q;
  logic equal_494_s3_q;
  logic [3:0] select_503_s3_q;
  logic equal_520_s3_q;
  logic equal_521_s3_q;
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
      select_485_s3_q <= select_485_s2_q;
      equal_486_s3_q <= equal_486;
      select_488_s3_q <= select_488_s2_q;
      select_492_s3_q <= select_492;
      equal_494_s3_q <= select_485_s2_q[1:0] == 2'h3;
      select_503_s3_q <= select_503;
      equal_520_s3_q <= equal_520_s2_q;
      equal_521_s3_q <= select_503 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:41
  logic or_493;
  assign or_493 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:411
  logic and_498;
  assign and_498 = (or_493 & equal_494_s3_q) & (~(select_492_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:270
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_488_s3_q : 7'h0;
  // hls/stages/census.hpp:126
  logic and_522;
  assign and_522 = equal_521_s3_q & and_498;
  // hls/stages/agreement.hpp:270
  logic and_524;
  assign and_524 = sample_pair_whole_s3_q & (equal_520_s3_q & and_522);
  // hls/stages/census.hpp:41
  logic [6:0] select_583;
  assign select_583 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:270
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_583 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_2053;
  assign select_2053 = sample_last_s3_q ? (select_583 + {6'h0, equal_521_s3_q}) : select_583;
  // hls/stages/agreement.hpp:270
  logic select_2058;
  assign select_2058 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_493 & (~raster_final_row_q)) : or_493) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_2060;
  assign select_2060 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:270
  logic select_2064;
  assign select_2064 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:453
  logic equal_2308;
  assign equal_2308 = {last[7], column} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2053 : raster_at_row_q;
      raster_at_live_q <= select_2058;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2060 : raster_rows_left_q;
      raster_final_row_q <= select_2064;
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
  logic [3:0] select_485_s4_q;
  logic equal_486_s4_q;
  logic [6:0] select_488_s4_q;
  logic [8:0] select_492_s4_q;
  logic and_498_s4_q;
  logic [3:0] select_503_s4_q;
  logic [6:0] column_s4_q;
  logic and_522_s4_q;
  logic and_524_s4_q;
  logic [3:0] select_583_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1604_s4_q;
  logic equal_2308_s4_q;
  logic and_2309_s4_q;
  logic [7:0] sum_2398_s4_q;
  logic [2:0] or_2815_s4_q;
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
      select_485_s4_q <= select_485_s3_q;
      equal_486_s4_q <= equal_486_s3_q;
      select_488_s4_q <= select_488_s3_q;
      select_492_s4_q <= select_492_s3_q;
      and_498_s4_q <= and_498;
      select_503_s4_q <= select_503_s3_q;
      column_s4_q <= column;
      and_522_s4_q <= and_522;
      and_524_s4_q <= and_524;
      select_583_s4_q <= select_583[3:0];
      row_s4_q <= row;
      equal_1604_s4_q <= {or_493, select_503_s3_q} == 5'h18;
      equal_2308_s4_q <= equal_2308;
      and_2309_s4_q <= and_524 & equal_2308;
      sum_2398_s4_q <= {1'b0, row} + 8'h1;
      or_2815_s4_q <= select_488_s3_q[2:0] | select_583[6:4];
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
  logic shift_first_q;
  logic [3:0] patches_phase_q;
  // hls/stages/agreement.hpp:194
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:617
  logic equal_544;
  assign equal_544 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:608
  logic equal_547;
  assign equal_547 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:609
  logic equal_549;
  assign equal_549 = run_phase_q == 3'h2;
  // hls/stages/patches.hpp:122
  logic and_1598;
  assign and_1598 = (select_485_s4_q == 4'h0) & (select_488_s4_q == 7'h0);
  // hls/stages/agreement.hpp:517
  logic select_2312;
  assign select_2312 = (and_2309_s4_q | (~ends_cell_q)) ? and_2309_s4_q : ends_q;
  // hls/stages/agreement.hpp:523
  logic [2:0] now;
  assign now = select_2312 ? (and_2309_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:528
  logic [5:0] select_2316;
  assign select_2316 = select_2312 ? (and_2309_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2319;
  assign select_2319 = select_2312 ? (following_last_shift_q & (~and_2309_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:529
  logic [7:0] select_2321;
  assign select_2321 = select_2312 ? (and_2309_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:601
  logic and_2322;
  assign and_2322 = run_last_shift_q & equal_547;
  // hls/stages/agreement.hpp:610
  logic select_2324;
  assign select_2324 = equal_547 ? (~run_last_shift_q) : equal_549;
  // hls/stages/agreement.hpp:614
  logic equal_2325;
  assign equal_2325 = run_phase_q == 3'h1;
  logic not_2328;
  assign not_2328 = ~select_2324;
  // hls/stages/agreement.hpp:617
  logic equal_2330;
  assign equal_2330 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:601
  logic and_2331;
  assign and_2331 = final_row_q & so;
  // hls/stages/agreement.hpp:614
  logic [1:0] select_2332;
  assign select_2332 = equal_2330 ? 2'h1 : {2{and_2331}};
  logic [2:0] select_2334;
  assign select_2334 = (and_2322 | (select_2324 | equal_2325)) ? (equal_2325 ? 3'h2 : {not_2328, {2{select_2324}}}) : (equal_544 ? 3'h6 : {select_2332[0], select_2332});
  // hls/stages/agreement.hpp:601
  logic and_2337;
  assign and_2337 = select_2324 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:624
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2340;
  assign select_2340 = (plan_shift_q[5] & select_2324) ? value : 7'h0;
  logic [1:0] or_2341;
  assign or_2341 = {2{so}} | select_2340[5:4];
  // hls/stages/agreement.hpp:627
  logic [7:0] or_2345;
  assign or_2345 = (select_2324 ? plan_columns_q : 8'h0) | ((equal_2325 | equal_2330) ? whole_q : 8'h0);
  logic [1:0] or_2346;
  assign or_2346 = {2{and_2322}} | or_2345[4:3];
  // hls/stages/agreement.hpp:628
  logic [7:0] or_2348;
  assign or_2348 = {or_2345[7:5], or_2346, or_2345[2:0]} | (equal_544 ? drawn_q : 8'h0);
  logic [4:0] or_2349;
  assign or_2349 = {5{so}} | {or_2348[6], or_2348[3:0]};
  // hls/stages/agreement.hpp:634
  logic not_2353;
  assign not_2353 = ~run_shift_q[5];
  logic [7:0] select_2356;
  assign select_2356 = equal_547 ? ({{7{not_2353}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:517
  logic [6:0] select_2360;
  assign select_2360 = and_2309_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2362;
  assign select_2362 = select_2312 ? {select_2360[6], select_2360} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2365;
  assign select_2365 = select_2312 ? (and_2309_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:454
  logic [6:0] select_2372;
  assign select_2372 = equal_2308_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:514
  logic [7:0] select_2376;
  assign select_2376 = and_524_s4_q ? (equal_2308_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2379;
  assign select_2379 = and_524_s4_q ? (equal_2308_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:525
  logic select_2393;
  assign select_2393 = (ends_cell_q | select_2312) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_547 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:520
  logic and_2397;
  assign and_2397 = (~select_2312) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:470
  logic equal_2399;
  assign equal_2399 = {sum_2398_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2398_s4_q[6:0]};
  // hls/stages/agreement.hpp:514
  logic select_2401;
  assign select_2401 = and_524_s4_q ? (equal_2308_s4_q ? equal_2399 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2752;
  assign select_2752 = and_1598 ? (sample_pair_first_s4_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/patches.hpp:370
  logic [8:0] sum_2816;
  assign sum_2816 = {1'b0, select_488_s4_q[3], or_2815_s4_q, select_583_s4_q} + 9'h1;

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
      shift_first_q <= 1'b0;
      patches_phase_q <= 4'h0;
    end else if (s4_en) begin
      run_phase_q <= now;
      run_shift_q <= select_2316;
      run_last_shift_q <= select_2319;
      run_span_q <= select_2321;
      following_phase_q <= select_2334;
      following_shift_q <= select_2324 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2337;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2340[6], or_2341, select_2340[3:0]};
      following_columns_q <= {or_2348[7], or_2349[4], or_2348[5:4], or_2349[3:0]};
      plan_shift_q <= equal_547 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2356;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2362;
      columns_left_q <= select_2365;
      last_q <= and_524_s4_q ? (equal_2308_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_524_s4_q ? select_2372 : least_q;
      whole_q <= select_2376;
      drawn_q <= select_2379;
      slot_q <= select_2312 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2393;
      ends_q <= and_2397;
      final_row_q <= select_2401;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= sample_pair_whole_s4_q ? select_2752 : patches_phase_q;
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
  logic shift_first_s5_q;
  logic [3:0] select_485_s5_q;
  logic equal_486_s5_q;
  logic [6:0] select_488_s5_q;
  logic [8:0] select_492_s5_q;
  logic and_498_s5_q;
  logic equal_504_s5_q;
  logic [6:0] column_s5_q;
  logic and_522_s5_q;
  logic and_524_s5_q;
  logic so_s5_q;
  logic equal_544_s5_q;
  logic equal_547_s5_q;
  logic equal_549_s5_q;
  logic [7:0] sum_550_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_660_s5_q;
  logic equal_1489_s5_q;
  logic and_1598_s5_q;
  logic equal_1604_s5_q;
  logic equal_2308_s5_q;
  logic and_2309_s5_q;
  logic select_2312_s5_q;
  logic [3:0] phase_s5_q;
  logic not_2818_s5_q;
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
      shift_first_s5_q <= shift_first_q;
      select_485_s5_q <= select_485_s4_q;
      equal_486_s5_q <= equal_486_s4_q;
      select_488_s5_q <= select_488_s4_q;
      select_492_s5_q <= select_492_s4_q;
      and_498_s5_q <= and_498_s4_q;
      equal_504_s5_q <= select_503_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_522_s5_q <= and_522_s4_q;
      and_524_s5_q <= and_524_s4_q;
      so_s5_q <= so;
      equal_544_s5_q <= equal_544;
      equal_547_s5_q <= equal_547;
      equal_549_s5_q <= equal_549;
      sum_550_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_660_s5_q <= {1'b0, last_q} + 8'h3;
      equal_1489_s5_q <= run_phase_q == 3'h7;
      and_1598_s5_q <= and_1598;
      equal_1604_s5_q <= equal_1604_s4_q;
      equal_2308_s5_q <= equal_2308_s4_q;
      and_2309_s5_q <= and_2309_s4_q;
      select_2312_s5_q <= select_2312;
      phase_s5_q <= phase;
      not_2818_s5_q <= ~({sum_2816, select_503_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:588
  logic [7:0] select_551;
  assign select_551 = run_shift_s5_q[5] ? x_s5_q : sum_550_s5_q;
  logic less_552;
  assign less_552 = {1'b0, last_s5_q} < select_551;
  // hls/stages/agreement.hpp:222
  logic not_553;
  assign not_553 = ~less_552;
  // hls/stages/agreement.hpp:790
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:522
  logic [6:0] select_2381;
  assign select_2381 = select_2312_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2381;
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
  logic shift_first_s6_q;
  logic [3:0] select_485_s6_q;
  logic equal_486_s6_q;
  logic [6:0] select_488_s6_q;
  logic [8:0] select_492_s6_q;
  logic and_498_s6_q;
  logic equal_504_s6_q;
  logic [6:0] column_s6_q;
  logic and_522_s6_q;
  logic and_524_s6_q;
  logic so_s6_q;
  logic equal_544_s6_q;
  logic equal_547_s6_q;
  logic [6:0] sum_550_s6_q;
  logic less_552_s6_q;
  logic not_553_s6_q;
  logic and_554_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_664_s6_q;
  logic equal_1479_s6_q;
  logic equal_1489_s6_q;
  logic and_1598_s6_q;
  logic equal_1604_s6_q;
  logic equal_2308_s6_q;
  logic and_2309_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2772_s6_q;
  logic [3:0] select_2775_s6_q;
  logic not_2818_s6_q;
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
      shift_first_s6_q <= shift_first_s5_q;
      select_485_s6_q <= select_485_s5_q;
      equal_486_s6_q <= equal_486_s5_q;
      select_488_s6_q <= select_488_s5_q;
      select_492_s6_q <= select_492_s5_q;
      and_498_s6_q <= and_498_s5_q;
      equal_504_s6_q <= equal_504_s5_q;
      column_s6_q <= column_s5_q;
      and_522_s6_q <= and_522_s5_q;
      and_524_s6_q <= and_524_s5_q;
      so_s6_q <= so_s5_q;
      equal_544_s6_q <= equal_544_s5_q;
      equal_547_s6_q <= equal_547_s5_q;
      sum_550_s6_q <= sum_550_s5_q[6:0];
      less_552_s6_q <= less_552;
      not_553_s6_q <= not_553;
      and_554_s6_q <= equal_549_s5_q & not_553;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_664_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_660_s5_q < select_551)));
      equal_1479_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1489_s6_q <= equal_1489_s5_q;
      and_1598_s6_q <= and_1598_s5_q;
      equal_1604_s6_q <= equal_1604_s5_q;
      equal_2308_s6_q <= equal_2308_s5_q;
      and_2309_s6_q <= and_2309_s5_q;
      phase_s6_q <= phase_s5_q;
      equal_2772_s6_q <= row_s5_q == 7'h3;
      select_2775_s6_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_2818_s6_q <= not_2818_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:588
  logic or_545;
  assign or_545 = so_s6_q | equal_544_s6_q;
  // hls/stages/agreement.hpp:712
  logic not_546;
  assign not_546 = ~or_545;
  // hls/stages/agreement.hpp:147
  logic select_640;
  assign select_640 = equal_547_s6_q ? not_553_s6_q : and_554_s6_q;
  logic and_665;
  assign and_665 = equal_547_s6_q & and_664_s6_q;
  logic select_666;
  assign select_666 = or_545 ? not_553_s6_q : and_665;
  // hls/stages/agreement.hpp:813
  logic [6:0] right;
  assign right = sum_550_s6_q + 7'h7d;
  // hls/stages/agreement.hpp:514
  logic and_2642;
  assign and_2642 = and_524_s6_q & (equal_2308_s6_q & (row_s6_q[6:2] == 5'h0));
  // hls/stages/patches.hpp:87
  logic [3:0] select_2776;
  assign select_2776 = equal_2772_s6_q ? select_2775_s6_q : patches_choosing_rows_to_next_q;
  logic equal_2777;
  assign equal_2777 = select_2776 == 4'h0;
  // hls/stages/agreement.hpp:454
  logic [3:0] select_2780;
  assign select_2780 = equal_2308_s6_q ? (equal_2777 ? 4'h2 : (select_2776 + 4'hf)) : patches_choosing_rows_to_next_q;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1340; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_545 ? not_553_s6_q : select_640);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1341; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_547_s6_q ? sum_550_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_546 & select_640);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1342; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [61:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 62'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_545 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_666;
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s6_en) begin
      patches_choosing_rows_to_next_q <= and_524_s6_q ? select_2780 : patches_choosing_rows_to_next_q;
    end
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
  logic shift_first_s7_q;
  logic [3:0] patches_choosing_rows_to_next_s7_q;
  logic [3:0] select_485_s7_q;
  logic equal_486_s7_q;
  logic [6:0] select_488_s7_q;
  logic [8:0] select_492_s7_q;
  logic and_498_s7_q;
  logic equal_504_s7_q;
  logic [6:0] column_s7_q;
  logic and_522_s7_q;
  logic and_524_s7_q;
  logic so_s7_q;
  logic equal_544_s7_q;
  logic or_545_s7_q;
  logic equal_547_s7_q;
  logic less_552_s7_q;
  logic not_553_s7_q;
  logic and_556_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_666_s7_q;
  logic and_1471_s7_q;
  logic [6:0] right_s7_q;
  logic equal_1479_s7_q;
  logic equal_1489_s7_q;
  logic and_1598_s7_q;
  logic equal_1604_s7_q;
  logic equal_2308_s7_q;
  logic and_2643_s7_q;
  logic and_2645_s7_q;
  logic and_2652_s7_q;
  logic [3:0] phase_s7_q;
  logic equal_2772_s7_q;
  logic equal_2777_s7_q;
  logic not_2818_s7_q;
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
      shift_first_s7_q <= shift_first_s6_q;
      patches_choosing_rows_to_next_s7_q <= patches_choosing_rows_to_next_q;
      select_485_s7_q <= select_485_s6_q;
      equal_486_s7_q <= equal_486_s6_q;
      select_488_s7_q <= select_488_s6_q;
      select_492_s7_q <= select_492_s6_q;
      and_498_s7_q <= and_498_s6_q;
      equal_504_s7_q <= equal_504_s6_q;
      column_s7_q <= column_s6_q;
      and_522_s7_q <= and_522_s6_q;
      and_524_s7_q <= and_524_s6_q;
      so_s7_q <= so_s6_q;
      equal_544_s7_q <= equal_544_s6_q;
      or_545_s7_q <= or_545;
      equal_547_s7_q <= equal_547_s6_q;
      less_552_s7_q <= less_552_s6_q;
      not_553_s7_q <= not_553_s6_q;
      and_556_s7_q <= not_546 & ((~equal_547_s6_q) & and_554_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_666_s7_q <= select_666;
      and_1471_s7_q <= not_546 & and_665;
      right_s7_q <= right;
      equal_1479_s7_q <= equal_1479_s6_q;
      equal_1489_s7_q <= equal_1489_s6_q;
      and_1598_s7_q <= and_1598_s6_q;
      equal_1604_s7_q <= equal_1604_s6_q;
      equal_2308_s7_q <= equal_2308_s6_q;
      and_2643_s7_q <= and_2309_s6_q & and_2642;
      and_2645_s7_q <= and_2309_s6_q & (~and_2642);
      and_2652_s7_q <= ends_cell_s6_q & so_s6_q;
      phase_s7_q <= phase_s6_q;
      equal_2772_s7_q <= equal_2772_s6_q;
      equal_2777_s7_q <= equal_2777;
      not_2818_s7_q <= not_2818_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
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
  logic patches_chooses_q;
  logic [4:0] patches_choosing_band_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/census.hpp:31
  logic not_1602;
  assign not_1602 = ~sample_pair_first_s7_q;
  // hls/stages/patches.hpp:311
  logic equal_1606;
  assign equal_1606 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1676;
  assign select_1676 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1900;
  assign sum_1900 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2646;
  assign select_2646 = and_2645_s7_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2648;
  assign select_2648 = and_2643_s7_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2646[15]}}, select_2646});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2649;
  assign select_2649 = and_2645_s7_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2649[15]}}, select_2649};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2651;
  assign select_2651 = and_2643_s7_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2652_s7_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:372
  logic and_2754;
  assign and_2754 = not_1602 & equal_1604_s7_q;
  logic [8:0] select_2755;
  assign select_2755 = and_2754 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s7_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2756;
  assign select_2756 = and_2754 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2757;
  assign select_2757 = sample_pair_first_s7_q ? select_2755 : select_2756;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2758;
  assign select_2758 = and_1598_s7_q ? select_2757[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_2759;
  assign select_2759 = sample_pair_whole_s7_q ? select_2758 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2761;
  assign select_2761 = sample_pair_whole_s7_q ? (and_1598_s7_q ? select_2757[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2764;
  assign select_2764 = sample_pair_whole_s7_q ? (equal_1606 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2766;
  assign select_2766 = sample_pair_whole_s7_q ? (patches_band_rows_number_q + {4'h0, equal_1606}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2767;
  assign equal_2767 = phase_s7_q == 4'h0;
  // hls/stages/patches.hpp:331
  logic not_2768;
  assign not_2768 = ~equal_2767;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_2770;
  assign select_2770 = sample_pair_whole_s7_q ? (phase_s7_q + {{2{not_2768}}, 1'b1, not_2768}) : patches_first_band_rows_to_next_q;
  logic select_2771;
  assign select_2771 = sample_pair_whole_s7_q ? equal_2767 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2782;
  assign select_2782 = equal_2772_s7_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:454
  logic [4:0] select_2784;
  assign select_2784 = equal_2308_s7_q ? (select_2782 + {4'h0, equal_2777_s7_q}) : patches_choosing_number_q;
  logic select_2788;
  assign select_2788 = equal_2308_s7_q ? ((7'h2 < row_s7_q) & equal_2777_s7_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:514
  logic [4:0] select_2791;
  assign select_2791 = and_524_s7_q ? (equal_2308_s7_q ? select_2782 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:203
  logic [8:0] select_3704;
  assign select_3704 = so_s7_q ? (and_2652_s7_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3706;
  assign sum_3706 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3707;
  assign select_3707 = sum_1900[5] ? {1'b1, sum_1900[4:0], region_across_rest_q[2:0]} : sum_3706;
  // hls/stages/agreement.hpp:454
  logic [8:0] select_3709;
  assign select_3709 = equal_2308_s7_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3712;
  assign select_3712 = equal_2308_s7_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1339; read in stage 7, written in stage 22: 7 < 22 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_556_s7_q;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      patches_chooses_q <= 1'b0;
      patches_choosing_band_q <= 5'h0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s7_en) begin
      registration_slope_row_q <= select_2648;
      registration_slope_change_q <= select_2651;
      registration_slope_q <= so_s7_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2759;
      patches_band_rows_number_q <= select_2761;
      patches_next_band_rows_to_next_q <= select_2764;
      patches_next_band_number_q <= select_2766;
      patches_first_band_rows_to_next_q <= select_2770;
      patches_first_band_number_q <= select_2771;
      patches_choosing_number_q <= and_524_s7_q ? select_2784 : patches_choosing_number_q;
      patches_chooses_q <= and_524_s7_q ? select_2788 : patches_chooses_q;
      patches_choosing_band_q <= select_2791;
      region_across_rest_q <= select_3704;
      region_across_back_q <= so_s7_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3707;
      columns_begin_rest_q <= and_524_s7_q ? select_3709 : columns_begin_rest_q;
      columns_begin_back_q <= and_524_s7_q ? select_3712 : columns_begin_back_q;
    end
  end

  logic [7:0] pixel_0_s8_q;
  logic [7:0] pixel_1_s8_q;
  logic saturated_s8_q;
  logic mask_s8_q;
  logic marks_first_s8_q;
  logic marks_last_s8_q;
  logic sample_pair_whole_s8_q;
  logic sample_present_s8_q;
  logic [5:0] run_shift_s8_q;
  logic [7:0] x_s8_q;
  logic [6:0] last_s8_q;
  logic [3:0] age_s8_q;
  logic [2:0] slot_s8_q;
  logic ends_cell_s8_q;
  logic shift_first_s8_q;
  logic [11:0] registration_slope_s8_q;
  logic [4:0] patches_band_rows_number_s8_q;
  logic patches_chooses_s8_q;
  logic [4:0] patches_choosing_band_s8_q;
  logic [3:0] select_485_s8_q;
  logic equal_486_s8_q;
  logic [6:0] select_488_s8_q;
  logic [8:0] select_492_s8_q;
  logic and_498_s8_q;
  logic equal_504_s8_q;
  logic [6:0] column_s8_q;
  logic and_522_s8_q;
  logic and_524_s8_q;
  logic so_s8_q;
  logic equal_544_s8_q;
  logic or_545_s8_q;
  logic equal_547_s8_q;
  logic less_552_s8_q;
  logic not_553_s8_q;
  logic and_556_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_666_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic and_1471_s8_q;
  logic [6:0] right_s8_q;
  logic equal_1479_s8_q;
  logic equal_1489_s8_q;
  logic and_1598_s8_q;
  logic not_1602_s8_q;
  logic or_1608_s8_q;
  logic [16:0] select_1676_s8_q;
  logic sum_1900_s8_q;
  logic equal_2308_s8_q;
  logic not_2818_s8_q;
  always_ff @(posedge clk_i) begin
    if (s7_en) begin
      pixel_0_s8_q <= pixel_0_s7_q;
      pixel_1_s8_q <= pixel_1_s7_q;
      saturated_s8_q <= saturated_s7_q;
      mask_s8_q <= mask_s7_q;
      marks_first_s8_q <= marks_first_s7_q;
      marks_last_s8_q <= marks_last_s7_q;
      sample_pair_whole_s8_q <= sample_pair_whole_s7_q;
      sample_present_s8_q <= sample_present_s7_q;
      run_shift_s8_q <= run_shift_s7_q;
      x_s8_q <= x_s7_q;
      last_s8_q <= last_s7_q;
      age_s8_q <= age_s7_q;
      slot_s8_q <= slot_s7_q;
      ends_cell_s8_q <= ends_cell_s7_q;
      shift_first_s8_q <= shift_first_s7_q;
      registration_slope_s8_q <= registration_slope_q[27:16];
      patches_band_rows_number_s8_q <= patches_band_rows_number_q;
      patches_chooses_s8_q <= patches_chooses_q;
      patches_choosing_band_s8_q <= patches_choosing_band_q;
      select_485_s8_q <= select_485_s7_q;
      equal_486_s8_q <= equal_486_s7_q;
      select_488_s8_q <= select_488_s7_q;
      select_492_s8_q <= select_492_s7_q;
      and_498_s8_q <= and_498_s7_q;
      equal_504_s8_q <= equal_504_s7_q;
      column_s8_q <= column_s7_q;
      and_522_s8_q <= and_522_s7_q;
      and_524_s8_q <= and_524_s7_q;
      so_s8_q <= so_s7_q;
      equal_544_s8_q <= equal_544_s7_q;
      or_545_s8_q <= or_545_s7_q;
      equal_547_s8_q <= equal_547_s7_q;
      less_552_s8_q <= less_552_s7_q;
      not_553_s8_q <= not_553_s7_q;
      and_556_s8_q <= and_556_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_666_s8_q <= select_666_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      and_1471_s8_q <= and_1471_s7_q;
      right_s8_q <= right_s7_q;
      equal_1479_s8_q <= equal_1479_s7_q;
      equal_1489_s8_q <= equal_1489_s7_q;
      and_1598_s8_q <= and_1598_s7_q;
      not_1602_s8_q <= not_1602;
      or_1608_s8_q <= (~equal_1604_s7_q) | (~equal_1606);
      select_1676_s8_q <= select_1676;
      sum_1900_s8_q <= sum_1900[5];
      equal_2308_s8_q <= equal_2308_s7_q;
      not_2818_s8_q <= not_2818_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  logic [15:0] patches_chance_q;
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
  // hls/stages/agreement.hpp:660
  logic not_644;
  assign not_644 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:218
  logic and_672;
  assign and_672 = left_rdata_s8_q[44] & not_553_s8_q;
  logic and_673;
  assign and_673 = right_codes_rdata_s8_q[38] & not_553_s8_q;
  logic [11:0] select_674;
  assign select_674 = less_552_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_675;
  assign select_675 = less_552_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_679;
  assign select_679 = and_672 ? (and_673 ? (~(select_674 ^ select_675)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:218
  logic and_695;
  assign and_695 = left_rdata_s8_q[60] & not_553_s8_q;
  logic and_696;
  assign and_696 = right_codes_rdata_s8_q[51] & not_553_s8_q;
  logic [11:0] select_697;
  assign select_697 = less_552_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_698;
  assign select_698 = less_552_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_702;
  assign select_702 = and_695 ? (and_696 ? (~(select_697 ^ select_698)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:218
  logic and_712;
  assign and_712 = left_rdata_s8_q[76] & not_553_s8_q;
  logic and_713;
  assign and_713 = right_codes_rdata_s8_q[64] & not_553_s8_q;
  logic [11:0] select_714;
  assign select_714 = less_552_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_715;
  assign select_715 = less_552_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_719;
  assign select_719 = and_712 ? (and_713 ? (~(select_714 ^ select_715)) : 12'h0) : 12'h0;
  logic [11:0] select_927;
  assign select_927 = (slot_s8_q[0] ? and_713 : and_696) ? (~(select_675 ^ (slot_s8_q[0] ? select_714 : select_697))) : 12'h0;
  // hls/stages/agreement.hpp:218
  logic and_944;
  assign and_944 = right_codes_rdata_s8_q[77] & not_553_s8_q;
  logic [11:0] select_946;
  assign select_946 = less_552_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_950;
  assign select_950 = (slot_s8_q[0] ? and_944 : and_713) ? (~(select_698 ^ (slot_s8_q[0] ? select_946 : select_714))) : 12'h0;
  // hls/stages/agreement.hpp:726
  logic select_962;
  assign select_962 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_553_s8_q) : and_944;
  logic [11:0] select_964;
  assign select_964 = slot_s8_q[0] ? (less_552_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_946;
  // hls/stages/agreement.hpp:218
  logic and_1173;
  assign and_1173 = right_codes_rdata_s8_q[25] & not_553_s8_q;
  // hls/stages/agreement.hpp:726
  logic select_1174;
  assign select_1174 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_553_s8_q) : and_1173;
  // hls/stages/agreement.hpp:218
  logic [11:0] select_1176;
  assign select_1176 = less_552_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:726
  logic [11:0] select_1177;
  assign select_1177 = slot_s8_q[0] ? (less_552_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1176;
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1201;
  assign select_1201 = (slot_s8_q[0] ? and_1173 : and_673) ? (~(select_698 ^ (slot_s8_q[0] ? select_1176 : select_674))) : 12'h0;
  logic [11:0] select_1216;
  assign select_1216 = (slot_s8_q[0] ? and_673 : and_696) ? (~(select_715 ^ (slot_s8_q[0] ? select_674 : select_697))) : 12'h0;
  // hls/stages/agreement.hpp:953
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:958
  logic and_1506;
  assign and_1506 = (or_545_s8_q & (left_rdata_s8_q[61] & not_553_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/patches.hpp:391
  logic not_1599;
  assign not_1599 = ~patches_begins_q;
  // hls/stages/patches.hpp:361
  logic and_1603;
  assign and_1603 = patches_capturing_q & not_1602_s8_q;
  // hls/stages/patches.hpp:125
  logic and_1611;
  assign and_1611 = (not_1599 & (patches_work_q == 3'h0)) & (~(and_1603 | or_1608_s8_q));
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s8_q[6:1]} < x_s8_q;
  // hls/stages/agreement.hpp:147
  logic [5:0] b;
  assign b = or_545_s8_q ? (less_552_s8_q ? 6'h0 : best_left_rdata_s8_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1678;
  assign select_1678 = ($signed(10'h0) < $signed(select_1676_s8_q[16:7])) ? 14'h7f : select_1676_s8_q[13:0];
  // hls/stages/patches.hpp:529
  logic equal_1708;
  assign equal_1708 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:500
  logic equal_1710;
  assign equal_1710 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:494
  logic equal_1712;
  assign equal_1712 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1713;
  assign equal_1713 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_1714;
  assign or_1714 = equal_1712 | equal_1713;
  // hls/stages/patches.hpp:455
  logic not_1715;
  assign not_1715 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_1737;
  assign select_1737 = and_1611 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1738;
  assign select_1738 = and_1598_s8_q ? select_1737 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1740;
  assign and_1740 = and_1603 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1744;
  assign select_1744 = and_1598_s8_q ? (and_1611 | (and_1603 & (~and_1740))) : patches_capturing_q;
  // hls/stages/patches.hpp:167
  logic not_1769;
  assign not_1769 = ~equal_1713;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_1783;
  assign select_1783 = and_1598_s8_q ? {select_1737[4], select_1737[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:541
  logic less_1869;
  assign less_1869 = patches_step_q[4:0] < 5'h11;
  logic equal_1870;
  assign equal_1870 = patches_step_q[6:5] == 2'h0;
  logic not_1871;
  assign not_1871 = ~equal_1870;
  logic equal_1872;
  assign equal_1872 = patches_step_q[6:5] == 2'h3;
  logic not_1873;
  assign not_1873 = ~equal_1872;
  // hls/stages/patches.hpp:555
  logic select_1876;
  assign select_1876 = equal_1872 ? (less_1869 & (less_1869 & not_1873)) : less_1869;
  // hls/stages/agreement.hpp:454
  logic select_2405;
  assign select_2405 = equal_2308_s8_q ? (~({row_s8_q, 1'b0} < {sum_2402, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:147
  logic [7:0] select_2542;
  assign select_2542 = or_545_s8_q ? (less_552_s8_q ? 8'h0 : best_left_rdata_s8_q[32:25]) : 8'h0;
  logic [7:0] select_2544;
  assign select_2544 = or_545_s8_q ? (less_552_s8_q ? 8'h0 : best_left_rdata_s8_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:91
  logic parity_2795;
  assign parity_2795 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:454
  logic [15:0] select_2796;
  assign select_2796 = equal_2308_s8_q ? {patches_chance_q[14:0], parity_2795} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s8_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:392
  logic or_2859;
  assign or_2859 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_2865;
  assign and_2865 = equal_1708 & not_1715;
  // hls/stages/patches.hpp:398
  logic and_2866;
  assign and_2866 = not_1769 & and_2865;
  logic [1:0] select_2868;
  assign select_2868 = equal_1710 ? 2'h0 : (equal_1712 ? 2'h3 : {equal_1713, and_2866});
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
      patches_chance_q <= 16'h1;
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
    end else if (s8_en) begin
      row_q <= and_524_s8_q ? (equal_2308_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_524_s8_q ? select_2405 : lower_half_q;
      patches_chance_q <= and_524_s8_q ? select_2796 : patches_chance_q;
      patches_capturing_q <= sample_pair_whole_s8_q ? select_1744 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s8_q ? select_1738 : patches_row_q;
      patches_work_q <= or_2859 ? following : patches_work_q;
      patches_second_q <= not_1599 & (patches_second_q | (patches_ends_q & equal_1708));
      patches_following_q <= equal_1708 ? {2'h0, and_2865} : {equal_1710, select_2868};
      patches_following_beats_q <= {select_2880, not_2871};
      patches_begins_q <= sample_pair_whole_s8_q & (and_1598_s8_q & and_1740);
      patches_ends_q <= not_2883 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2888;
      patches_step_q <= or_2859 ? 7'h0 : (patches_step_q + 7'h1);
    end
  end

  logic [7:0] pixel_0_s9_q;
  logic [7:0] pixel_1_s9_q;
  logic saturated_s9_q;
  logic mask_s9_q;
  logic marks_first_s9_q;
  logic marks_last_s9_q;
  logic sample_pair_whole_s9_q;
  logic sample_present_s9_q;
  logic [5:0] run_shift_s9_q;
  logic [7:0] x_s9_q;
  logic [6:0] last_s9_q;
  logic [3:0] age_s9_q;
  logic [2:0] slot_s9_q;
  logic ends_cell_s9_q;
  logic lower_half_s9_q;
  logic shift_first_s9_q;
  logic [11:0] registration_slope_s9_q;
  logic [4:0] patches_band_rows_number_s9_q;
  logic patches_chooses_s9_q;
  logic [4:0] patches_choosing_band_s9_q;
  logic patches_second_s9_q;
  logic [4:0] patches_step_s9_q;
  logic [3:0] select_485_s9_q;
  logic equal_486_s9_q;
  logic [6:0] select_488_s9_q;
  logic [8:0] select_492_s9_q;
  logic and_498_s9_q;
  logic equal_504_s9_q;
  logic [6:0] column_s9_q;
  logic and_522_s9_q;
  logic and_524_s9_q;
  logic so_s9_q;
  logic equal_544_s9_q;
  logic or_545_s9_q;
  logic equal_547_s9_q;
  logic less_552_s9_q;
  logic not_553_s9_q;
  logic and_556_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic equal_585_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_645_s9_q;
  logic and_646_s9_q;
  logic and_647_s9_q;
  logic and_648_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_652_s9_q;
  logic and_653_s9_q;
  logic and_654_s9_q;
  logic and_655_s9_q;
  logic and_656_s9_q;
  logic and_657_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_666_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic and_672_s9_q;
  logic [11:0] select_679_s9_q;
  logic and_695_s9_q;
  logic [11:0] select_702_s9_q;
  logic and_712_s9_q;
  logic [11:0] select_719_s9_q;
  logic [11:0] select_927_s9_q;
  logic [11:0] select_950_s9_q;
  logic [11:0] select_967_s9_q;
  logic [11:0] select_1180_s9_q;
  logic [11:0] select_1201_s9_q;
  logic [11:0] select_1216_s9_q;
  logic and_1471_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic equal_1479_s9_q;
  logic equal_1489_s9_q;
  logic and_1507_s9_q;
  logic and_1598_s9_q;
  logic and_1611_s9_q;
  logic right_3_s9_q;
  logic less_1625_s9_q;
  logic [5:0] b_s9_q;
  logic [13:0] select_1678_s9_q;
  logic equal_1708_s9_q;
  logic equal_1710_s9_q;
  logic equal_1712_s9_q;
  logic equal_1713_s9_q;
  logic or_1714_s9_q;
  logic and_1717_s9_q;
  logic [4:0] select_1738_s9_q;
  logic select_1744_s9_q;
  logic and_1750_s9_q;
  logic and_1770_s9_q;
  logic [3:0] select_1783_s9_q;
  logic less_1869_s9_q;
  logic equal_1870_s9_q;
  logic not_1871_s9_q;
  logic equal_1872_s9_q;
  logic not_1873_s9_q;
  logic select_1876_s9_q;
  logic and_1877_s9_q;
  logic sum_1900_s9_q;
  logic and_1921_s9_q;
  logic and_2038_s9_q;
  logic equal_2184_s9_q;
  logic equal_2308_s9_q;
  logic and_2434_s9_q;
  logic [7:0] select_2542_s9_q;
  logic [7:0] select_2544_s9_q;
  logic [5:0] further_s9_q;
  logic not_2818_s9_q;
  logic or_2859_s9_q;
  logic not_2883_s9_q;
  logic and_3355_s9_q;
  logic equal_3362_s9_q;
  logic less_3692_s9_q;
  logic equal_3910_s9_q;
  always_ff @(posedge clk_i) begin
    if (s8_en) begin
      pixel_0_s9_q <= pixel_0_s8_q;
      pixel_1_s9_q <= pixel_1_s8_q;
      saturated_s9_q <= saturated_s8_q;
      mask_s9_q <= mask_s8_q;
      marks_first_s9_q <= marks_first_s8_q;
      marks_last_s9_q <= marks_last_s8_q;
      sample_pair_whole_s9_q <= sample_pair_whole_s8_q;
      sample_present_s9_q <= sample_present_s8_q;
      run_shift_s9_q <= run_shift_s8_q;
      x_s9_q <= x_s8_q;
      last_s9_q <= last_s8_q;
      age_s9_q <= age_s8_q;
      slot_s9_q <= slot_s8_q;
      ends_cell_s9_q <= ends_cell_s8_q;
      lower_half_s9_q <= lower_half_q;
      shift_first_s9_q <= shift_first_s8_q;
      registration_slope_s9_q <= registration_slope_s8_q;
      patches_band_rows_number_s9_q <= patches_band_rows_number_s8_q;
      patches_chooses_s9_q <= patches_chooses_s8_q;
      patches_choosing_band_s9_q <= patches_choosing_band_s8_q;
      patches_second_s9_q <= patches_second_q;
      patches_step_s9_q <= patches_step_q[4:0];
      select_485_s9_q <= select_485_s8_q;
      equal_486_s9_q <= equal_486_s8_q;
      select_488_s9_q <= select_488_s8_q;
      select_492_s9_q <= select_492_s8_q;
      and_498_s9_q <= and_498_s8_q;
      equal_504_s9_q <= equal_504_s8_q;
      column_s9_q <= column_s8_q;
      and_522_s9_q <= and_522_s8_q;
      and_524_s9_q <= and_524_s8_q;
      so_s9_q <= so_s8_q;
      equal_544_s9_q <= equal_544_s8_q;
      or_545_s9_q <= or_545_s8_q;
      equal_547_s9_q <= equal_547_s8_q;
      less_552_s9_q <= less_552_s8_q;
      not_553_s9_q <= not_553_s8_q;
      and_556_s9_q <= and_556_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_585_s9_q <= row_s8_q == 7'h0;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_645_s9_q <= left_rdata_s8_q[12] & not_644;
      and_646_s9_q <= left_rdata_s8_q[28] & not_644;
      and_647_s9_q <= left_rdata_s8_q[44] & not_644;
      and_648_s9_q <= left_rdata_s8_q[60] & not_644;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_652_s9_q <= right_codes_rdata_s8_q[12] & not_644;
      and_653_s9_q <= right_codes_rdata_s8_q[25] & not_644;
      and_654_s9_q <= right_codes_rdata_s8_q[38] & not_644;
      and_655_s9_q <= right_codes_rdata_s8_q[51] & not_644;
      and_656_s9_q <= right_codes_rdata_s8_q[64] & not_644;
      and_657_s9_q <= right_codes_rdata_s8_q[77] & not_644;
      x_s9_2_q <= x_s8_2_q;
      select_666_s9_q <= select_666_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      and_672_s9_q <= and_672;
      select_679_s9_q <= select_679;
      and_695_s9_q <= and_695;
      select_702_s9_q <= select_702;
      and_712_s9_q <= and_712;
      select_719_s9_q <= select_719;
      select_927_s9_q <= select_927;
      select_950_s9_q <= select_950;
      select_967_s9_q <= select_962 ? (~(select_715 ^ select_964)) : 12'h0;
      select_1180_s9_q <= select_1174 ? (~(select_675 ^ select_1177)) : 12'h0;
      select_1201_s9_q <= select_1201;
      select_1216_s9_q <= select_1216;
      and_1471_s9_q <= and_1471_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      equal_1479_s9_q <= equal_1479_s8_q;
      equal_1489_s9_q <= equal_1489_s8_q;
      and_1507_s9_q <= (or_545_s8_q & (left_rdata_s8_q[62] & not_553_s8_q)) & and_1506;
      and_1598_s9_q <= and_1598_s8_q;
      and_1611_s9_q <= and_1611;
      right_3_s9_q <= right_3;
      less_1625_s9_q <= 6'h4 < row_q[6:1];
      b_s9_q <= b;
      select_1678_s9_q <= select_1678;
      equal_1708_s9_q <= equal_1708;
      equal_1710_s9_q <= equal_1710;
      equal_1712_s9_q <= equal_1712;
      equal_1713_s9_q <= equal_1713;
      or_1714_s9_q <= or_1714;
      and_1717_s9_q <= or_1714 & (equal_1713 & not_1715);
      select_1738_s9_q <= select_1738;
      select_1744_s9_q <= select_1744;
      and_1750_s9_q <= or_1714 & (patches_second_q & equal_1713);
      and_1770_s9_q <= not_1769 & or_1714;
      select_1783_s9_q <= select_1783;
      less_1869_s9_q <= less_1869;
      equal_1870_s9_q <= equal_1870;
      not_1871_s9_q <= not_1871;
      equal_1872_s9_q <= equal_1872;
      not_1873_s9_q <= not_1873;
      select_1876_s9_q <= select_1876;
      and_1877_s9_q <= not_1871 & select_1876;
      sum_1900_s9_q <= sum_1900_s8_q;
      and_1921_s9_q <= or_545_s8_q & (left_rdata_s8_q[63] & not_553_s8_q);
      and_2038_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2184_s9_q <= (column_s8_q | row_s8_q) == 7'h0;
      equal_2308_s9_q <= equal_2308_s8_q;
      and_2434_s9_q <= not_553_s8_q & and_1506;
      select_2542_s9_q <= select_2542;
      select_2544_s9_q <= select_2544;
      further_s9_q <= further;
      not_2818_s9_q <= not_2818_s8_q;
      or_2859_s9_q <= or_2859;
      not_2883_s9_q <= not_2883;
      and_3355_s9_q <= less_1869 & (patches_step_q[6:5] == 2'h1);
      equal_3362_s9_q <= patches_step_q[6:5] == 2'h2;
      less_3692_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_3910_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/count_bits.hpp:24
  logic parity_685;
  assign parity_685 = ^select_679_s9_q[5:3];
  logic parity_688;
  assign parity_688 = ^select_679_s9_q[8:6];
  logic parity_691;
  assign parity_691 = ^select_679_s9_q[11:3];
  logic parity_705;
  assign parity_705 = ^select_702_s9_q[8:6];
  logic parity_708;
  assign parity_708 = ^select_702_s9_q[11:9];
  logic parity_725;
  assign parity_725 = ^select_719_s9_q[2:0];
  logic parity_728;
  assign parity_728 = ^select_719_s9_q[5:3];
  logic parity_731;
  assign parity_731 = ^select_719_s9_q[8:0];
  logic parity_737;
  assign parity_737 = ^select_719_s9_q[11:9];
  logic parity_740;
  assign parity_740 = ^select_702_s9_q[2:0];
  logic parity_743;
  assign parity_743 = ^{select_719_s9_q[11:9], select_702_s9_q[5:0]};
  logic parity_746;
  assign parity_746 = ^{select_719_s9_q, select_702_s9_q, select_679_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_751;
  assign or_751 = (select_679_s9_q[1:0] == 2'h3) | (select_679_s9_q[2] & (select_679_s9_q[0] | select_679_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_755;
  assign or_755 = (select_702_s9_q[7:6] == 2'h3) | (select_702_s9_q[8] & (select_702_s9_q[6] | select_702_s9_q[7]));
  logic or_759;
  assign or_759 = (select_702_s9_q[10:9] == 2'h3) | (select_702_s9_q[11] & (select_702_s9_q[9] | select_702_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_767;
  assign or_767 = (select_719_s9_q[7:6] == 2'h3) | (select_719_s9_q[8] & (~(select_719_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_771;
  assign or_771 = (select_719_s9_q[1:0] == 2'h3) | (select_719_s9_q[2] & (select_719_s9_q[0] | select_719_s9_q[1]));
  logic or_775;
  assign or_775 = (select_719_s9_q[4:3] == 2'h3) | (select_719_s9_q[5] & (select_719_s9_q[3] | select_719_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_778;
  assign parity_778 = ^{or_775, or_771, or_767};
  // hls/stages/count_bits.hpp:23
  logic or_782;
  assign or_782 = (select_702_s9_q[4:3] == 2'h3) | (select_702_s9_q[5] & (select_702_s9_q[3] | select_702_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_786;
  assign or_786 = (select_719_s9_q[10:9] == 2'h3) | (select_719_s9_q[11] & (select_719_s9_q[9] | select_719_s9_q[10]));
  logic or_790;
  assign or_790 = (select_702_s9_q[1:0] == 2'h3) | (select_702_s9_q[2] & (select_702_s9_q[0] | select_702_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_793;
  assign parity_793 = ^{or_790, or_786, or_782};
  logic parity_796;
  assign parity_796 = ^{or_790, or_786, or_782, or_775, or_771, or_767, or_759, or_755, or_751};
  // hls/stages/count_bits.hpp:25
  logic or_801;
  assign or_801 = (parity_685 & parity_688) | ((^select_679_s9_q[11:9]) & (parity_685 | parity_688));
  logic and_804;
  assign and_804 = (^{select_702_s9_q[11:6], select_679_s9_q[2:0]}) & (parity_731 | parity_743);
  // hls/stages/count_bits.hpp:23
  logic or_812;
  assign or_812 = (select_679_s9_q[10:9] == 2'h3) | (select_679_s9_q[11] & (select_679_s9_q[9] | select_679_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_816;
  assign or_816 = (select_679_s9_q[4:3] == 2'h3) | (select_679_s9_q[5] & (select_679_s9_q[3] | select_679_s9_q[4]));
  logic or_820;
  assign or_820 = (select_679_s9_q[7:6] == 2'h3) | (select_679_s9_q[8] & (select_679_s9_q[6] | select_679_s9_q[7]));
  logic or_827;
  assign or_827 = (parity_705 & parity_708) | ((^select_679_s9_q[2:0]) & (parity_705 | parity_708));
  logic or_831;
  assign or_831 = (parity_725 & parity_728) | ((^select_719_s9_q[8:6]) & (parity_725 | parity_728));
  logic or_835;
  assign or_835 = (parity_737 & parity_740) | ((^select_702_s9_q[5:3]) & (parity_737 | parity_740));
  // hls/stages/agreement.hpp:676
  logic [11:0] select_928;
  assign select_928 = and_672_s9_q ? select_927_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_934;
  assign parity_934 = ^select_928[5:3];
  logic parity_937;
  assign parity_937 = ^select_928[8:6];
  logic parity_940;
  assign parity_940 = ^select_928[11:3];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_951;
  assign select_951 = and_695_s9_q ? select_950_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_954;
  assign parity_954 = ^select_951[8:6];
  logic parity_957;
  assign parity_957 = ^select_951[11:9];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_968;
  assign select_968 = and_712_s9_q ? select_967_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_974;
  assign parity_974 = ^select_968[2:0];
  logic parity_977;
  assign parity_977 = ^select_968[5:3];
  logic parity_980;
  assign parity_980 = ^select_968[8:0];
  logic parity_986;
  assign parity_986 = ^select_968[11:9];
  logic parity_989;
  assign parity_989 = ^select_951[2:0];
  logic parity_992;
  assign parity_992 = ^{select_968[11:9], select_951[5:0]};
  logic parity_995;
  assign parity_995 = ^{select_968, select_951, select_928[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1000;
  assign or_1000 = (select_928[1:0] == 2'h3) | (select_928[2] & (select_928[0] | select_928[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1004;
  assign or_1004 = (select_951[7:6] == 2'h3) | (select_951[8] & (select_951[6] | select_951[7]));
  logic or_1008;
  assign or_1008 = (select_951[10:9] == 2'h3) | (select_951[11] & (select_951[9] | select_951[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1016;
  assign or_1016 = (select_968[7:6] == 2'h3) | (select_968[8] & (~(select_968[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1020;
  assign or_1020 = (select_968[1:0] == 2'h3) | (select_968[2] & (select_968[0] | select_968[1]));
  logic or_1024;
  assign or_1024 = (select_968[4:3] == 2'h3) | (select_968[5] & (select_968[3] | select_968[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1027;
  assign parity_1027 = ^{or_1024, or_1020, or_1016};
  // hls/stages/count_bits.hpp:23
  logic or_1031;
  assign or_1031 = (select_951[4:3] == 2'h3) | (select_951[5] & (select_951[3] | select_951[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1035;
  assign or_1035 = (select_968[10:9] == 2'h3) | (select_968[11] & (select_968[9] | select_968[10]));
  logic or_1039;
  assign or_1039 = (select_951[1:0] == 2'h3) | (select_951[2] & (select_951[0] | select_951[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1042;
  assign parity_1042 = ^{or_1039, or_1035, or_1031};
  logic parity_1045;
  assign parity_1045 = ^{or_1039, or_1035, or_1031, or_1024, or_1020, or_1016, or_1008, or_1004, or_1000};
  // hls/stages/count_bits.hpp:25
  logic or_1050;
  assign or_1050 = (parity_934 & parity_937) | ((^select_928[11:9]) & (parity_934 | parity_937));
  logic and_1053;
  assign and_1053 = (^{select_951[11:6], select_928[2:0]}) & (parity_980 | parity_992);
  // hls/stages/count_bits.hpp:23
  logic or_1061;
  assign or_1061 = (select_928[10:9] == 2'h3) | (select_928[11] & (select_928[9] | select_928[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1065;
  assign or_1065 = (select_928[4:3] == 2'h3) | (select_928[5] & (select_928[3] | select_928[4]));
  logic or_1069;
  assign or_1069 = (select_928[7:6] == 2'h3) | (select_928[8] & (select_928[6] | select_928[7]));
  logic or_1076;
  assign or_1076 = (parity_954 & parity_957) | ((^select_928[2:0]) & (parity_954 | parity_957));
  logic or_1080;
  assign or_1080 = (parity_974 & parity_977) | ((^select_968[8:6]) & (parity_974 | parity_977));
  logic or_1084;
  assign or_1084 = (parity_986 & parity_989) | ((^select_951[5:3]) & (parity_986 | parity_989));
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1181;
  assign select_1181 = and_672_s9_q ? select_1180_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1187;
  assign parity_1187 = ^select_1181[5:3];
  logic parity_1190;
  assign parity_1190 = ^select_1181[8:6];
  logic parity_1193;
  assign parity_1193 = ^select_1181[11:3];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1202;
  assign select_1202 = and_695_s9_q ? select_1201_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1205;
  assign parity_1205 = ^select_1202[8:6];
  logic parity_1208;
  assign parity_1208 = ^select_1202[11:9];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1217;
  assign select_1217 = and_712_s9_q ? select_1216_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1223;
  assign parity_1223 = ^select_1217[2:0];
  logic parity_1226;
  assign parity_1226 = ^select_1217[5:3];
  logic parity_1229;
  assign parity_1229 = ^select_1217[8:0];
  logic parity_1235;
  assign parity_1235 = ^select_1217[11:9];
  logic parity_1238;
  assign parity_1238 = ^select_1202[2:0];
  logic parity_1241;
  assign parity_1241 = ^{select_1217[11:9], select_1202[5:0]};
  logic parity_1244;
  assign parity_1244 = ^{select_1217, select_1202, select_1181[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1249;
  assign or_1249 = (select_1181[1:0] == 2'h3) | (select_1181[2] & (select_1181[0] | select_1181[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1253;
  assign or_1253 = (select_1202[7:6] == 2'h3) | (select_1202[8] & (select_1202[6] | select_1202[7]));
  logic or_1257;
  assign or_1257 = (select_1202[10:9] == 2'h3) | (select_1202[11] & (select_1202[9] | select_1202[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1265;
  assign or_1265 = (select_1217[7:6] == 2'h3) | (select_1217[8] & (~(select_1217[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1269;
  assign or_1269 = (select_1217[1:0] == 2'h3) | (select_1217[2] & (select_1217[0] | select_1217[1]));
  logic or_1273;
  assign or_1273 = (select_1217[4:3] == 2'h3) | (select_1217[5] & (select_1217[3] | select_1217[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1276;
  assign parity_1276 = ^{or_1273, or_1269, or_1265};
  // hls/stages/count_bits.hpp:23
  logic or_1280;
  assign or_1280 = (select_1202[4:3] == 2'h3) | (select_1202[5] & (select_1202[3] | select_1202[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1284;
  assign or_1284 = (select_1217[10:9] == 2'h3) | (select_1217[11] & (select_1217[9] | select_1217[10]));
  logic or_1288;
  assign or_1288 = (select_1202[1:0] == 2'h3) | (select_1202[2] & (select_1202[0] | select_1202[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1291;
  assign parity_1291 = ^{or_1288, or_1284, or_1280};
  logic parity_1294;
  assign parity_1294 = ^{or_1288, or_1284, or_1280, or_1273, or_1269, or_1265, or_1257, or_1253, or_1249};
  // hls/stages/count_bits.hpp:25
  logic or_1299;
  assign or_1299 = (parity_1187 & parity_1190) | ((^select_1181[11:9]) & (parity_1187 | parity_1190));
  logic and_1302;
  assign and_1302 = (^{select_1202[11:6], select_1181[2:0]}) & (parity_1229 | parity_1241);
  // hls/stages/count_bits.hpp:23
  logic or_1310;
  assign or_1310 = (select_1181[10:9] == 2'h3) | (select_1181[11] & (select_1181[9] | select_1181[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1314;
  assign or_1314 = (select_1181[4:3] == 2'h3) | (select_1181[5] & (select_1181[3] | select_1181[4]));
  logic or_1318;
  assign or_1318 = (select_1181[7:6] == 2'h3) | (select_1181[8] & (select_1181[6] | select_1181[7]));
  logic or_1325;
  assign or_1325 = (parity_1205 & parity_1208) | ((^select_1181[2:0]) & (parity_1205 | parity_1208));
  logic or_1329;
  assign or_1329 = (parity_1223 & parity_1226) | ((^select_1217[8:6]) & (parity_1223 | parity_1226));
  logic or_1333;
  assign or_1333 = (parity_1235 & parity_1238) | ((^select_1202[5:3]) & (parity_1235 | parity_1238));
  // hls/stages/agreement.hpp:954
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:241
  logic or_1520;
  assign or_1520 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));
  // hls/stages/agreement.hpp:988
  logic [5:0] sum_1570;
  assign sum_1570 = {1'b0, last_s9_q[6:2]} + 6'h1;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1655;
  assign sum_1655 = {2'h0, x_s9_q} + {{4{b_s9_q[5]}}, b_s9_q};
  // hls/stages/registration.hpp:213
  logic [9:0] select_1679;
  assign select_1679 = b_s9_q[4] ? select_1678_s9_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1684;
  assign sum_1684 = (b_s9_q[0] ? select_1678_s9_q[13:1] : 13'h0) + (b_s9_q[1] ? select_1678_s9_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1685;
  assign select_1685 = b_s9_q[2] ? select_1678_s9_q[11:0] : 12'h0;
  // hls/stages/patches.hpp:507
  logic not_1709;
  assign not_1709 = ~equal_1708_s9_q;
  // hls/stages/patches.hpp:453
  logic not_1711;
  assign not_1711 = ~equal_1710_s9_q;
  logic and_1793;
  assign and_1793 = not_1709 & (or_1714_s9_q & not_1711);
  // hls/stages/patches.hpp:184
  logic and_1879;
  assign and_1879 = equal_1708_s9_q & (less_1869_s9_q ? and_1877_s9_q : select_1876_s9_q);
  // hls/stages/agreement.hpp:147
  logic [7:0] select_2540;
  assign select_2540 = or_545_s9_q ? (less_552_s9_q ? 8'h0 : best_left_rdata_s9_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2542_s9_q} - {1'b0, select_2544_s9_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2801;
  assign select_2801 = right_3_s9_q ? last_s9_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s9_q} + {1'b0, select_2801};
  // hls/stages/patches.hpp:126
  logic select_2820;
  assign select_2820 = and_1598_s9_q ? (and_1611_s9_q ? not_2818_s9_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:187
  logic [4:0] select_2890;
  assign select_2890 = or_2859_s9_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:555
  logic select_3358;
  assign select_3358 = equal_1872_s9_q ? (less_1869_s9_q ? (not_1873_s9_q & and_3355_s9_q) : and_3355_s9_q) : and_3355_s9_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:774; read in stage 9, written in stage 22: 9 < 22 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s9_en & (not_1709 & (not_1711 & and_1717_s9_q));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:774; read in stage 9, written in stage 22: 9 < 22 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s9_en & (not_1709 & (not_1711 & and_1750_s9_q));
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:786; read in stage 9, written in stage 13: 9 < 13 < 9 + DISTANCE.
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
  assign patches_columns_above_re = s9_en & and_1793;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:806; read in stage 9, written in stage 23: 9 < 23 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_s9_q;
  logic patches_rows_re;
  assign patches_rows_re = s9_en & and_1879;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_556_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_648_s9_q, left_rdata_s9_q[56:42], and_647_s9_q, left_rdata_s9_q[41:27], and_646_s9_q, left_rdata_s9_q[26:12], and_645_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_556_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_657_s9_q, right_codes_rdata_s9_q[71:60], and_656_s9_q, right_codes_rdata_s9_q[59:48], and_655_s9_q, right_codes_rdata_s9_q[47:36], and_654_s9_q, right_codes_rdata_s9_q[35:24], and_653_s9_q, right_codes_rdata_s9_q[23:12], and_652_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_lower_q <= 1'b0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
    end else if (s9_en) begin
      patches_lower_q <= sample_pair_whole_s9_q ? select_2820 : patches_lower_q;
      patches_code_row_q <= select_2890;
      patches_column_q <= or_2859_s9_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2883_s9_q & (patches_column_q == 5'h1e);
    end
  end

  logic [7:0] pixel_0_s10_q;
  logic [7:0] pixel_1_s10_q;
  logic saturated_s10_q;
  logic mask_s10_q;
  logic marks_first_s10_q;
  logic marks_last_s10_q;
  logic sample_pair_whole_s10_q;
  logic sample_present_s10_q;
  logic [5:0] run_shift_s10_q;
  logic [7:0] x_s10_q;
  logic [3:0] age_s10_q;
  logic [2:0] slot_s10_q;
  logic ends_cell_s10_q;
  logic lower_half_s10_q;
  logic shift_first_s10_q;
  logic [11:0] registration_slope_s10_q;
  logic [4:0] patches_band_rows_number_s10_q;
  logic patches_chooses_s10_q;
  logic [4:0] patches_choosing_band_s10_q;
  logic patches_lower_s10_q;
  logic patches_second_s10_q;
  logic [4:0] patches_code_row_s10_q;
  logic [4:0] patches_column_s10_q;
  logic [4:0] patches_step_s10_q;
  logic [3:0] select_485_s10_q;
  logic equal_486_s10_q;
  logic [6:0] select_488_s10_q;
  logic [8:0] select_492_s10_q;
  logic and_498_s10_q;
  logic equal_504_s10_q;
  logic [6:0] column_s10_q;
  logic and_522_s10_q;
  logic and_524_s10_q;
  logic so_s10_q;
  logic equal_544_s10_q;
  logic or_545_s10_q;
  logic equal_547_s10_q;
  logic less_552_s10_q;
  logic not_553_s10_q;
  logic equal_585_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_666_s10_q;
  logic [61:0] best_left_rdata_s10_q;
  logic xor_747_s10_q;
  logic parity_796_s10_q;
  logic and_797_s10_q;
  logic or_801_s10_q;
  logic or_805_s10_q;
  logic or_812_s10_q;
  logic or_816_s10_q;
  logic or_820_s10_q;
  logic or_827_s10_q;
  logic or_831_s10_q;
  logic or_835_s10_q;
  logic and_844_s10_q;
  logic and_846_s10_q;
  logic or_858_s10_q;
  logic or_862_s10_q;
  logic or_866_s10_q;
  logic xor_996_s10_q;
  logic parity_1011_s10_q;
  logic parity_1045_s10_q;
  logic and_1046_s10_q;
  logic or_1050_s10_q;
  logic or_1054_s10_q;
  logic or_1061_s10_q;
  logic or_1065_s10_q;
  logic or_1069_s10_q;
  logic or_1076_s10_q;
  logic or_1080_s10_q;
  logic or_1084_s10_q;
  logic and_1093_s10_q;
  logic or_1094_s10_q;
  logic or_1107_s10_q;
  logic or_1111_s10_q;
  logic or_1115_s10_q;
  logic xor_1245_s10_q;
  logic parity_1260_s10_q;
  logic parity_1294_s10_q;
  logic and_1295_s10_q;
  logic or_1299_s10_q;
  logic or_1303_s10_q;
  logic or_1310_s10_q;
  logic or_1314_s10_q;
  logic or_1318_s10_q;
  logic or_1325_s10_q;
  logic or_1329_s10_q;
  logic or_1333_s10_q;
  logic and_1342_s10_q;
  logic or_1343_s10_q;
  logic or_1356_s10_q;
  logic or_1360_s10_q;
  logic or_1364_s10_q;
  logic and_1471_s10_q;
  logic [6:0] select_1475_s10_q;
  logic [6:0] right_s10_q;
  logic equal_1479_s10_q;
  logic equal_1489_s10_q;
  logic and_1507_s10_q;
  logic or_1520_s10_q;
  logic less_1571_s10_q;
  logic and_1598_s10_q;
  logic and_1611_s10_q;
  logic right_3_s10_q;
  logic less_1625_s10_q;
  logic [5:0] b_s10_q;
  logic less_1646_s10_q;
  logic not_1651_s10_q;
  logic less_1656_s10_q;
  logic less_1657_s10_q;
  logic select_1679_s10_q;
  logic [8:0] difference_1681_s10_q;
  logic [11:0] sum_1684_s10_q;
  logic select_1685_s10_q;
  logic [10:0] sum_1687_s10_q;
  logic equal_1701_s10_q;
  logic equal_1708_s10_q;
  logic not_1709_s10_q;
  logic equal_1710_s10_q;
  logic not_1711_s10_q;
  logic equal_1712_s10_q;
  logic equal_1713_s10_q;
  logic or_1714_s10_q;
  logic [4:0] select_1738_s10_q;
  logic select_1744_s10_q;
  logic and_1772_s10_q;
  logic [3:0] select_1783_s10_q;
  logic and_1793_s10_q;
  logic less_1869_s10_q;
  logic equal_1870_s10_q;
  logic not_1871_s10_q;
  logic equal_1872_s10_q;
  logic not_1873_s10_q;
  logic sum_1900_s10_q;
  logic and_1921_s10_q;
  logic and_2041_s10_q;
  logic equal_2184_s10_q;
  logic equal_2308_s10_q;
  logic and_2435_s10_q;
  logic equal_2520_s10_q;
  logic [7:0] select_2540_s10_q;
  logic rise_2_s10_q;
  logic [7:0] select_2546_s10_q;
  logic [7:0] xor_2551_s10_q;
  logic less_2577_s10_q;
  logic not_2804_s10_q;
  logic or_2859_s10_q;
  logic not_2883_s10_q;
  logic select_3360_s10_q;
  logic equal_3362_s10_q;
  logic less_3692_s10_q;
  logic equal_3910_s10_q;
  always_ff @(posedge clk_i) begin
    if (s9_en) begin
      pixel_0_s10_q <= pixel_0_s9_q;
      pixel_1_s10_q <= pixel_1_s9_q;
      saturated_s10_q <= saturated_s9_q;
      mask_s10_q <= mask_s9_q;
      marks_first_s10_q <= marks_first_s9_q;
      marks_last_s10_q <= marks_last_s9_q;
      sample_pair_whole_s10_q <= sample_pair_whole_s9_q;
      sample_present_s10_q <= sample_present_s9_q;
      run_shift_s10_q <= run_shift_s9_q;
      x_s10_q <= x_s9_q;
      age_s10_q <= age_s9_q;
      slot_s10_q <= slot_s9_q;
      ends_cell_s10_q <= ends_cell_s9_q;
      lower_half_s10_q <= lower_half_s9_q;
      shift_first_s10_q <= shift_first_s9_q;
      registration_slope_s10_q <= registration_slope_s9_q;
      patches_band_rows_number_s10_q <= patches_band_rows_number_s9_q;
      patches_chooses_s10_q <= patches_chooses_s9_q;
      patches_choosing_band_s10_q <= patches_choosing_band_s9_q;
      patches_lower_s10_q <= patches_lower_q;
      patches_second_s10_q <= patches_second_s9_q;
      patches_code_row_s10_q <= patches_code_row_q;
      patches_column_s10_q <= patches_column_q;
      patches_step_s10_q <= patches_step_s9_q;
      select_485_s10_q <= select_485_s9_q;
      equal_486_s10_q <= equal_486_s9_q;
      select_488_s10_q <= select_488_s9_q;
      select_492_s10_q <= select_492_s9_q;
      and_498_s10_q <= and_498_s9_q;
      equal_504_s10_q <= equal_504_s9_q;
      column_s10_q <= column_s9_q;
      and_522_s10_q <= and_522_s9_q;
      and_524_s10_q <= and_524_s9_q;
      so_s10_q <= so_s9_q;
      equal_544_s10_q <= equal_544_s9_q;
      or_545_s10_q <= or_545_s9_q;
      equal_547_s10_q <= equal_547_s9_q;
      less_552_s10_q <= less_552_s9_q;
      not_553_s10_q <= not_553_s9_q;
      equal_585_s10_q <= equal_585_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_666_s10_q <= select_666_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      xor_747_s10_q <= parity_691 ^ parity_746;
      parity_796_s10_q <= parity_796;
      and_797_s10_q <= parity_691 & parity_746;
      or_801_s10_q <= or_801;
      or_805_s10_q <= (parity_731 & parity_743) | and_804;
      or_812_s10_q <= or_812;
      or_816_s10_q <= or_816;
      or_820_s10_q <= or_820;
      or_827_s10_q <= or_827;
      or_831_s10_q <= or_831;
      or_835_s10_q <= or_835;
      and_844_s10_q <= parity_778 & parity_793;
      and_846_s10_q <= (^{or_759, or_755, or_751}) & (parity_778 | parity_793);
      or_858_s10_q <= (or_755 & or_759) | (or_751 & (or_755 | or_759));
      or_862_s10_q <= (or_771 & or_775) | (or_767 & (or_771 | or_775));
      or_866_s10_q <= (or_786 & or_790) | (or_782 & (or_786 | or_790));
      xor_996_s10_q <= parity_940 ^ parity_995;
      parity_1011_s10_q <= ^{or_1008, or_1004, or_1000};
      parity_1045_s10_q <= parity_1045;
      and_1046_s10_q <= parity_940 & parity_995;
      or_1050_s10_q <= or_1050;
      or_1054_s10_q <= (parity_980 & parity_992) | and_1053;
      or_1061_s10_q <= or_1061;
      or_1065_s10_q <= or_1065;
      or_1069_s10_q <= or_1069;
      or_1076_s10_q <= or_1076;
      or_1080_s10_q <= or_1080;
      or_1084_s10_q <= or_1084;
      and_1093_s10_q <= parity_1027 & parity_1042;
      or_1094_s10_q <= parity_1027 | parity_1042;
      or_1107_s10_q <= (or_1004 & or_1008) | (or_1000 & (or_1004 | or_1008));
      or_1111_s10_q <= (or_1020 & or_1024) | (or_1016 & (or_1020 | or_1024));
      or_1115_s10_q <= (or_1035 & or_1039) | (or_1031 & (or_1035 | or_1039));
      xor_1245_s10_q <= parity_1193 ^ parity_1244;
      parity_1260_s10_q <= ^{or_1257, or_1253, or_1249};
      parity_1294_s10_q <= parity_1294;
      and_1295_s10_q <= parity_1193 & parity_1244;
      or_1299_s10_q <= or_1299;
      or_1303_s10_q <= (parity_1229 & parity_1241) | and_1302;
      or_1310_s10_q <= or_1310;
      or_1314_s10_q <= or_1314;
      or_1318_s10_q <= or_1318;
      or_1325_s10_q <= or_1325;
      or_1329_s10_q <= or_1329;
      or_1333_s10_q <= or_1333;
      and_1342_s10_q <= parity_1276 & parity_1291;
      or_1343_s10_q <= parity_1276 | parity_1291;
      or_1356_s10_q <= (or_1253 & or_1257) | (or_1249 & (or_1253 | or_1257));
      or_1360_s10_q <= (or_1269 & or_1273) | (or_1265 & (or_1269 | or_1273));
      or_1364_s10_q <= (or_1284 & or_1288) | (or_1280 & (or_1284 | or_1288));
      and_1471_s10_q <= and_1471_s9_q;
      select_1475_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      equal_1479_s10_q <= equal_1479_s9_q;
      equal_1489_s10_q <= equal_1489_s9_q;
      and_1507_s10_q <= and_1507_s9_q;
      or_1520_s10_q <= or_1520;
      less_1571_s10_q <= {1'b0, sum_1570, last_s9_q[1]} < x_s9_q;
      and_1598_s10_q <= and_1598_s9_q;
      and_1611_s10_q <= and_1611_s9_q;
      right_3_s10_q <= right_3_s9_q;
      less_1625_s10_q <= less_1625_s9_q;
      b_s10_q <= b_s9_q;
      less_1646_s10_q <= {3'h0, last_s9_q[6:1]} < ({1'b0, x_s9_q} + 9'h1);
      not_1651_s10_q <= ~(x_s9_q < {1'b0, last_s9_q});
      less_1656_s10_q <= $signed(10'h0) < $signed(sum_1655);
      less_1657_s10_q <= $signed(sum_1655) < $signed({3'h0, last_s9_q});
      select_1679_s10_q <= select_1679[0];
      difference_1681_s10_q <= select_1679[9:1] - (b_s9_q[5] ? select_1678_s9_q[8:0] : 9'h0);
      sum_1684_s10_q <= sum_1684[12:1];
      select_1685_s10_q <= select_1685[0];
      sum_1687_s10_q <= select_1685[11:1] + (b_s9_q[3] ? select_1678_s9_q[10:0] : 11'h0);
      equal_1701_s10_q <= x_s9_q == {1'b0, last_s9_q};
      equal_1708_s10_q <= equal_1708_s9_q;
      not_1709_s10_q <= not_1709;
      equal_1710_s10_q <= equal_1710_s9_q;
      not_1711_s10_q <= not_1711;
      equal_1712_s10_q <= equal_1712_s9_q;
      equal_1713_s10_q <= equal_1713_s9_q;
      or_1714_s10_q <= or_1714_s9_q;
      select_1738_s10_q <= select_1738_s9_q;
      select_1744_s10_q <= select_1744_s9_q;
      and_1772_s10_q <= not_1709 & (not_1711 & and_1770_s9_q);
      select_1783_s10_q <= select_1783_s9_q;
      and_1793_s10_q <= and_1793;
      less_1869_s10_q <= less_1869_s9_q;
      equal_1870_s10_q <= equal_1870_s9_q;
      not_1871_s10_q <= not_1871_s9_q;
      equal_1872_s10_q <= equal_1872_s9_q;
      not_1873_s10_q <= not_1873_s9_q;
      sum_1900_s10_q <= sum_1900_s9_q;
      and_1921_s10_q <= and_1921_s9_q;
      and_2041_s10_q <= and_2038_s9_q & (~({sum_1570, last_s9_q[1:0]} < x_s9_q));
      equal_2184_s10_q <= equal_2184_s9_q;
      equal_2308_s10_q <= equal_2308_s9_q;
      and_2435_s10_q <= or_545_s9_q & and_2434_s9_q;
      equal_2520_s10_q <= shift_s9_q == 6'h0;
      select_2540_s10_q <= select_2540;
      rise_2_s10_q <= rise_2[8];
      select_2546_s10_q <= rise_2[8] ? select_2542_s9_q : select_2544_s9_q;
      xor_2551_s10_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2577_s10_q <= select_2542_s9_q < select_2544_s9_q;
      not_2804_s10_q <= ~(x_s9_q < {1'b0, from});
      or_2859_s10_q <= or_2859_s9_q;
      not_2883_s10_q <= not_2883_s9_q;
      select_3360_s10_q <= less_1869_s9_q ? (not_1871_s9_q & select_3358) : select_3358;
      equal_3362_s10_q <= equal_3362_s9_q;
      less_3692_s10_q <= less_3692_s9_q;
      equal_3910_s10_q <= equal_3910_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/count_bits.hpp:24
  logic parity_823;
  assign parity_823 = ^{or_820_s10_q, or_816_s10_q, or_812_s10_q};
  logic parity_838;
  assign parity_838 = ^{or_835_s10_q, or_831_s10_q, or_827_s10_q};
  logic parity_841;
  assign parity_841 = ^{or_835_s10_q, or_831_s10_q, or_827_s10_q, or_820_s10_q, or_816_s10_q, or_812_s10_q, or_805_s10_q, or_801_s10_q, and_797_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_843;
  assign and_843 = parity_796_s10_q & parity_841;
  logic or_847;
  assign or_847 = and_844_s10_q | and_846_s10_q;
  logic and_850;
  assign and_850 = (^{or_805_s10_q, or_801_s10_q, and_797_s10_q}) & (parity_823 | parity_838);
  logic or_851;
  assign or_851 = (parity_823 & parity_838) | and_850;
  // hls/stages/count_bits.hpp:24
  logic parity_869;
  assign parity_869 = ^{or_866_s10_q, or_862_s10_q, or_858_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_873;
  assign or_873 = (or_801_s10_q & or_805_s10_q) | (and_797_s10_q & (or_801_s10_q | or_805_s10_q));
  logic or_877;
  assign or_877 = (or_816_s10_q & or_820_s10_q) | (or_812_s10_q & (or_816_s10_q | or_820_s10_q));
  logic or_881;
  assign or_881 = (or_831_s10_q & or_835_s10_q) | (or_827_s10_q & (or_831_s10_q | or_835_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_884;
  assign parity_884 = ^{or_881, or_877, or_873};
  logic parity_887;
  assign parity_887 = ^{or_881, or_877, or_873, or_866_s10_q, or_862_s10_q, or_858_s10_q, or_851, or_847, and_843};
  // hls/stages/count_bits.hpp:25
  logic or_899;
  assign or_899 = (or_862_s10_q & or_866_s10_q) | (or_858_s10_q & (or_862_s10_q | or_866_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1072;
  assign parity_1072 = ^{or_1069_s10_q, or_1065_s10_q, or_1061_s10_q};
  logic parity_1087;
  assign parity_1087 = ^{or_1084_s10_q, or_1080_s10_q, or_1076_s10_q};
  logic parity_1090;
  assign parity_1090 = ^{or_1084_s10_q, or_1080_s10_q, or_1076_s10_q, or_1069_s10_q, or_1065_s10_q, or_1061_s10_q, or_1054_s10_q, or_1050_s10_q, and_1046_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1092;
  assign and_1092 = parity_1045_s10_q & parity_1090;
  logic or_1096;
  assign or_1096 = and_1093_s10_q | (parity_1011_s10_q & or_1094_s10_q);
  logic and_1099;
  assign and_1099 = (^{or_1054_s10_q, or_1050_s10_q, and_1046_s10_q}) & (parity_1072 | parity_1087);
  logic or_1100;
  assign or_1100 = (parity_1072 & parity_1087) | and_1099;
  // hls/stages/count_bits.hpp:24
  logic parity_1118;
  assign parity_1118 = ^{or_1115_s10_q, or_1111_s10_q, or_1107_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1122;
  assign or_1122 = (or_1050_s10_q & or_1054_s10_q) | (and_1046_s10_q & (or_1050_s10_q | or_1054_s10_q));
  logic or_1126;
  assign or_1126 = (or_1065_s10_q & or_1069_s10_q) | (or_1061_s10_q & (or_1065_s10_q | or_1069_s10_q));
  logic or_1130;
  assign or_1130 = (or_1080_s10_q & or_1084_s10_q) | (or_1076_s10_q & (or_1080_s10_q | or_1084_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1133;
  assign parity_1133 = ^{or_1130, or_1126, or_1122};
  logic parity_1136;
  assign parity_1136 = ^{or_1130, or_1126, or_1122, or_1115_s10_q, or_1111_s10_q, or_1107_s10_q, or_1100, or_1096, and_1092};
  // hls/stages/count_bits.hpp:25
  logic or_1148;
  assign or_1148 = (or_1111_s10_q & or_1115_s10_q) | (or_1107_s10_q & (or_1111_s10_q | or_1115_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1321;
  assign parity_1321 = ^{or_1318_s10_q, or_1314_s10_q, or_1310_s10_q};
  logic parity_1336;
  assign parity_1336 = ^{or_1333_s10_q, or_1329_s10_q, or_1325_s10_q};
  logic parity_1339;
  assign parity_1339 = ^{or_1333_s10_q, or_1329_s10_q, or_1325_s10_q, or_1318_s10_q, or_1314_s10_q, or_1310_s10_q, or_1303_s10_q, or_1299_s10_q, and_1295_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1341;
  assign and_1341 = parity_1294_s10_q & parity_1339;
  logic or_1345;
  assign or_1345 = and_1342_s10_q | (parity_1260_s10_q & or_1343_s10_q);
  logic and_1348;
  assign and_1348 = (^{or_1303_s10_q, or_1299_s10_q, and_1295_s10_q}) & (parity_1321 | parity_1336);
  logic or_1349;
  assign or_1349 = (parity_1321 & parity_1336) | and_1348;
  // hls/stages/count_bits.hpp:24
  logic parity_1367;
  assign parity_1367 = ^{or_1364_s10_q, or_1360_s10_q, or_1356_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1371;
  assign or_1371 = (or_1299_s10_q & or_1303_s10_q) | (and_1295_s10_q & (or_1299_s10_q | or_1303_s10_q));
  logic or_1375;
  assign or_1375 = (or_1314_s10_q & or_1318_s10_q) | (or_1310_s10_q & (or_1314_s10_q | or_1318_s10_q));
  logic or_1379;
  assign or_1379 = (or_1329_s10_q & or_1333_s10_q) | (or_1325_s10_q & (or_1329_s10_q | or_1333_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1382;
  assign parity_1382 = ^{or_1379, or_1375, or_1371};
  logic parity_1385;
  assign parity_1385 = ^{or_1379, or_1375, or_1371, or_1364_s10_q, or_1360_s10_q, or_1356_s10_q, or_1349, or_1345, and_1341};
  // hls/stages/count_bits.hpp:25
  logic or_1397;
  assign or_1397 = (or_1360_s10_q & or_1364_s10_q) | (or_1356_s10_q & (or_1360_s10_q | or_1364_s10_q));
  // hls/stages/agreement.hpp:147
  logic [6:0] select_1497;
  assign select_1497 = or_545_s10_q ? (less_552_s10_q ? 7'h0 : select_1475_s10_q) : 7'h0;
  // hls/stages/patches.hpp:104
  logic and_1648;
  assign and_1648 = less_1646_s10_q & (~right_3_s10_q);
  // hls/stages/patches.hpp:106
  logic equal_1649;
  assign equal_1649 = x_s10_q == 8'h0;
  // hls/stages/agreement.hpp:997
  logic and_1659;
  assign and_1659 = (~(and_1648 | (equal_1649 | not_1651_s10_q))) & (less_1656_s10_q & less_1657_s10_q);
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1688;
  assign sum_1688 = sum_1684_s10_q + {sum_1687_s10_q, select_1685_s10_q};
  logic [9:0] sum_1689;
  assign sum_1689 = {difference_1681_s10_q, select_1679_s10_q} + sum_1688[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2540_s10_q} - {1'b0, select_2546_s10_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s10_q} + {1'b0, xor_2551_s10_q};

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1343; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_545_s10_q ? select_1475_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_666_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:775; read in stage 10, written in stage 21: 10 < 21 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s10_q, patches_code_row_s10_q[3:0], patches_column_s10_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s10_en & and_1772_s10_q;
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s10_en) begin
      patches_read_searches_q <= equal_1708_s10_q ? select_3360_s10_q : patches_read_searches_q;
    end
  end

  logic [7:0] pixel_0_s11_q;
  logic [7:0] pixel_1_s11_q;
  logic saturated_s11_q;
  logic mask_s11_q;
  logic marks_first_s11_q;
  logic marks_last_s11_q;
  logic sample_pair_whole_s11_q;
  logic sample_present_s11_q;
  logic [5:0] run_shift_s11_q;
  logic [7:0] x_s11_q;
  logic [3:0] age_s11_q;
  logic [2:0] slot_s11_q;
  logic ends_cell_s11_q;
  logic lower_half_s11_q;
  logic shift_first_s11_q;
  logic [11:0] registration_slope_s11_q;
  logic [4:0] patches_band_rows_number_s11_q;
  logic patches_chooses_s11_q;
  logic [4:0] patches_choosing_band_s11_q;
  logic patches_lower_s11_q;
  logic patches_second_s11_q;
  logic [4:0] patches_code_row_s11_q;
  logic [4:0] patches_column_s11_q;
  logic [4:0] patches_step_s11_q;
  logic patches_read_searches_s11_q;
  logic [3:0] select_485_s11_q;
  logic equal_486_s11_q;
  logic [6:0] select_488_s11_q;
  logic [8:0] select_492_s11_q;
  logic and_498_s11_q;
  logic equal_504_s11_q;
  logic [6:0] column_s11_q;
  logic and_522_s11_q;
  logic and_524_s11_q;
  logic so_s11_q;
  logic equal_544_s11_q;
  logic or_545_s11_q;
  logic equal_547_s11_q;
  logic less_552_s11_q;
  logic not_553_s11_q;
  logic equal_585_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic xor_747_s11_q;
  logic xor_842_s11_q;
  logic parity_887_s11_q;
  logic and_888_s11_q;
  logic and_890_s11_q;
  logic and_892_s11_q;
  logic and_894_s11_q;
  logic or_899_s11_q;
  logic or_903_s11_q;
  logic xor_996_s11_q;
  logic xor_1091_s11_q;
  logic parity_1136_s11_q;
  logic and_1137_s11_q;
  logic and_1139_s11_q;
  logic and_1141_s11_q;
  logic and_1143_s11_q;
  logic or_1148_s11_q;
  logic or_1152_s11_q;
  logic xor_1245_s11_q;
  logic xor_1340_s11_q;
  logic parity_1385_s11_q;
  logic and_1386_s11_q;
  logic and_1388_s11_q;
  logic and_1390_s11_q;
  logic and_1392_s11_q;
  logic or_1397_s11_q;
  logic or_1401_s11_q;
  logic and_1471_s11_q;
  logic [6:0] right_s11_q;
  logic equal_1479_s11_q;
  logic equal_1489_s11_q;
  logic [6:0] select_1498_s11_q;
  logic and_1507_s11_q;
  logic or_1520_s11_q;
  logic less_1571_s11_q;
  logic and_1598_s11_q;
  logic and_1611_s11_q;
  logic right_3_s11_q;
  logic less_1625_s11_q;
  logic [5:0] b_s11_q;
  logic equal_1649_s11_q;
  logic and_1659_s11_q;
  logic [7:0] sum_1689_s11_q;
  logic equal_1701_s11_q;
  logic or_1702_s11_q;
  logic equal_1708_s11_q;
  logic not_1709_s11_q;
  logic equal_1710_s11_q;
  logic not_1711_s11_q;
  logic equal_1712_s11_q;
  logic equal_1713_s11_q;
  logic or_1714_s11_q;
  logic [7:0] patches_right_0_rdata_s11_q;
  logic [4:0] select_1738_s11_q;
  logic select_1744_s11_q;
  logic [7:0] patches_right_1_rdata_s11_q;
  logic [3:0] select_1783_s11_q;
  logic and_1793_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic less_1869_s11_q;
  logic equal_1870_s11_q;
  logic not_1871_s11_q;
  logic equal_1872_s11_q;
  logic not_1873_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_1900_s11_q;
  logic and_1921_s11_q;
  logic and_2043_s11_q;
  logic equal_2184_s11_q;
  logic equal_2308_s11_q;
  logic and_2435_s11_q;
  logic equal_2520_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] size_3_s11_q;
  logic less_2577_s11_q;
  logic not_2804_s11_q;
  logic or_2859_s11_q;
  logic not_2883_s11_q;
  logic equal_3362_s11_q;
  logic less_3692_s11_q;
  logic equal_3910_s11_q;
  always_ff @(posedge clk_i) begin
    if (s10_en) begin
      pixel_0_s11_q <= pixel_0_s10_q;
      pixel_1_s11_q <= pixel_1_s10_q;
      saturated_s11_q <= saturated_s10_q;
      mask_s11_q <= mask_s10_q;
      marks_first_s11_q <= marks_first_s10_q;
      marks_last_s11_q <= marks_last_s10_q;
      sample_pair_whole_s11_q <= sample_pair_whole_s10_q;
      sample_present_s11_q <= sample_present_s10_q;
      run_shift_s11_q <= run_shift_s10_q;
      x_s11_q <= x_s10_q;
      age_s11_q <= age_s10_q;
      slot_s11_q <= slot_s10_q;
      ends_cell_s11_q <= ends_cell_s10_q;
      lower_half_s11_q <= lower_half_s10_q;
      shift_first_s11_q <= shift_first_s10_q;
      registration_slope_s11_q <= registration_slope_s10_q;
      patches_band_rows_number_s11_q <= patches_band_rows_number_s10_q;
      patches_chooses_s11_q <= patches_chooses_s10_q;
      patches_choosing_band_s11_q <= patches_choosing_band_s10_q;
      patches_lower_s11_q <= patches_lower_s10_q;
      patches_second_s11_q <= patches_second_s10_q;
      patches_code_row_s11_q <= patches_code_row_s10_q;
      patches_column_s11_q <= patches_column_s10_q;
      patches_step_s11_q <= patches_step_s10_q;
      patches_read_searches_s11_q <= patches_read_searches_q;
      select_485_s11_q <= select_485_s10_q;
      equal_486_s11_q <= equal_486_s10_q;
      select_488_s11_q <= select_488_s10_q;
      select_492_s11_q <= select_492_s10_q;
      and_498_s11_q <= and_498_s10_q;
      equal_504_s11_q <= equal_504_s10_q;
      column_s11_q <= column_s10_q;
      and_522_s11_q <= and_522_s10_q;
      and_524_s11_q <= and_524_s10_q;
      so_s11_q <= so_s10_q;
      equal_544_s11_q <= equal_544_s10_q;
      or_545_s11_q <= or_545_s10_q;
      equal_547_s11_q <= equal_547_s10_q;
      less_552_s11_q <= less_552_s10_q;
      not_553_s11_q <= not_553_s10_q;
      equal_585_s11_q <= equal_585_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      xor_747_s11_q <= xor_747_s10_q;
      xor_842_s11_q <= parity_796_s10_q ^ parity_841;
      parity_887_s11_q <= parity_887;
      and_888_s11_q <= parity_869 & parity_884;
      and_890_s11_q <= (^{or_851, or_847, and_843}) & (parity_869 | parity_884);
      and_892_s11_q <= or_847 & or_851;
      and_894_s11_q <= and_843 & (or_847 | or_851);
      or_899_s11_q <= or_899;
      or_903_s11_q <= (or_877 & or_881) | (or_873 & (or_877 | or_881));
      xor_996_s11_q <= xor_996_s10_q;
      xor_1091_s11_q <= parity_1045_s10_q ^ parity_1090;
      parity_1136_s11_q <= parity_1136;
      and_1137_s11_q <= parity_1118 & parity_1133;
      and_1139_s11_q <= (^{or_1100, or_1096, and_1092}) & (parity_1118 | parity_1133);
      and_1141_s11_q <= or_1096 & or_1100;
      and_1143_s11_q <= and_1092 & (or_1096 | or_1100);
      or_1148_s11_q <= or_1148;
      or_1152_s11_q <= (or_1126 & or_1130) | (or_1122 & (or_1126 | or_1130));
      xor_1245_s11_q <= xor_1245_s10_q;
      xor_1340_s11_q <= parity_1294_s10_q ^ parity_1339;
      parity_1385_s11_q <= parity_1385;
      and_1386_s11_q <= parity_1367 & parity_1382;
      and_1388_s11_q <= (^{or_1349, or_1345, and_1341}) & (parity_1367 | parity_1382);
      and_1390_s11_q <= or_1345 & or_1349;
      and_1392_s11_q <= and_1341 & (or_1345 | or_1349);
      or_1397_s11_q <= or_1397;
      or_1401_s11_q <= (or_1375 & or_1379) | (or_1371 & (or_1375 | or_1379));
      and_1471_s11_q <= and_1471_s10_q;
      right_s11_q <= right_s10_q;
      equal_1479_s11_q <= equal_1479_s10_q;
      equal_1489_s11_q <= equal_1489_s10_q;
      select_1498_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1497;
      and_1507_s11_q <= and_1507_s10_q;
      or_1520_s11_q <= or_1520_s10_q;
      less_1571_s11_q <= less_1571_s10_q;
      and_1598_s11_q <= and_1598_s10_q;
      and_1611_s11_q <= and_1611_s10_q;
      right_3_s11_q <= right_3_s10_q;
      less_1625_s11_q <= less_1625_s10_q;
      b_s11_q <= b_s10_q;
      equal_1649_s11_q <= equal_1649;
      and_1659_s11_q <= and_1659;
      sum_1689_s11_q <= sum_1689[9:2];
      equal_1701_s11_q <= equal_1701_s10_q;
      or_1702_s11_q <= and_1648 | equal_1701_s10_q;
      equal_1708_s11_q <= equal_1708_s10_q;
      not_1709_s11_q <= not_1709_s10_q;
      equal_1710_s11_q <= equal_1710_s10_q;
      not_1711_s11_q <= not_1711_s10_q;
      equal_1712_s11_q <= equal_1712_s10_q;
      equal_1713_s11_q <= equal_1713_s10_q;
      or_1714_s11_q <= or_1714_s10_q;
      patches_right_0_rdata_s11_q <= patches_right_0_rdata_q;
      select_1738_s11_q <= select_1738_s10_q;
      select_1744_s11_q <= select_1744_s10_q;
      patches_right_1_rdata_s11_q <= patches_right_1_rdata_q;
      select_1783_s11_q <= select_1783_s10_q;
      and_1793_s11_q <= and_1793_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_q;
      less_1869_s11_q <= less_1869_s10_q;
      equal_1870_s11_q <= equal_1870_s10_q;
      not_1871_s11_q <= not_1871_s10_q;
      equal_1872_s11_q <= equal_1872_s10_q;
      not_1873_s11_q <= not_1873_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_1900_s11_q <= sum_1900_s10_q;
      and_1921_s11_q <= and_1921_s10_q;
      and_2043_s11_q <= so_s10_q & (ends_cell_s10_q & and_2041_s10_q);
      equal_2184_s11_q <= equal_2184_s10_q;
      equal_2308_s11_q <= equal_2308_s10_q;
      and_2435_s11_q <= and_2435_s10_q;
      equal_2520_s11_q <= equal_2520_s10_q;
      wide_s11_q <= wide;
      size_3_s11_q <= size_3;
      less_2577_s11_q <= less_2577_s10_q;
      not_2804_s11_q <= not_2804_s10_q;
      or_2859_s11_q <= or_2859_s10_q;
      not_2883_s11_q <= not_2883_s10_q;
      equal_3362_s11_q <= equal_3362_s10_q;
      less_3692_s11_q <= less_3692_s10_q;
      equal_3910_s11_q <= equal_3910_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
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
  logic or_891;
  assign or_891 = and_888_s11_q | and_890_s11_q;
  logic or_895;
  assign or_895 = and_892_s11_q | and_894_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_908;
  assign parity_908 = ^{or_903_s11_q, or_899_s11_q, or_895, or_891};
  // hls/stages/count_bits.hpp:25
  logic or_912;
  assign or_912 = (or_899_s11_q & or_903_s11_q) | (or_895 & (or_899_s11_q | or_903_s11_q));
  logic and_913;
  assign and_913 = or_891 & (^{or_903_s11_q, or_899_s11_q, or_895});
  // hls/stages/count_bits.hpp:24
  logic xor_914;
  assign xor_914 = or_912 ^ and_913;
  // hls/stages/count_bits.hpp:27
  logic and_915;
  assign and_915 = or_912 & and_913;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_916;
  assign select_916 = equal_547_s11_q ? {and_915, xor_914, parity_908, parity_887_s11_q, xor_842_s11_q, xor_747_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_545_s11_q ? 6'h0 : select_916;
  // hls/stages/count_bits.hpp:25
  logic or_1140;
  assign or_1140 = and_1137_s11_q | and_1139_s11_q;
  logic or_1144;
  assign or_1144 = and_1141_s11_q | and_1143_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1157;
  assign parity_1157 = ^{or_1152_s11_q, or_1148_s11_q, or_1144, or_1140};
  // hls/stages/count_bits.hpp:25
  logic or_1161;
  assign or_1161 = (or_1148_s11_q & or_1152_s11_q) | (or_1144 & (or_1148_s11_q | or_1152_s11_q));
  logic and_1162;
  assign and_1162 = or_1140 & (^{or_1152_s11_q, or_1148_s11_q, or_1144});
  // hls/stages/count_bits.hpp:24
  logic xor_1163;
  assign xor_1163 = or_1161 ^ and_1162;
  // hls/stages/count_bits.hpp:27
  logic and_1164;
  assign and_1164 = or_1161 & and_1162;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_1165;
  assign select_1165 = equal_547_s11_q ? {and_1164, xor_1163, parity_1157, parity_1136_s11_q, xor_1091_s11_q, xor_996_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_545_s11_q ? 6'h0 : select_1165;
  // hls/stages/count_bits.hpp:25
  logic or_1389;
  assign or_1389 = and_1386_s11_q | and_1388_s11_q;
  logic or_1393;
  assign or_1393 = and_1390_s11_q | and_1392_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1406;
  assign parity_1406 = ^{or_1401_s11_q, or_1397_s11_q, or_1393, or_1389};
  // hls/stages/count_bits.hpp:25
  logic or_1410;
  assign or_1410 = (or_1397_s11_q & or_1401_s11_q) | (or_1393 & (or_1397_s11_q | or_1401_s11_q));
  logic and_1411;
  assign and_1411 = or_1389 & (^{or_1401_s11_q, or_1397_s11_q, or_1393});
  // hls/stages/count_bits.hpp:24
  logic xor_1412;
  assign xor_1412 = or_1410 ^ and_1411;
  // hls/stages/count_bits.hpp:27
  logic and_1413;
  assign and_1413 = or_1410 & and_1411;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_1414;
  assign select_1414 = equal_547_s11_q ? {and_1413, xor_1412, parity_1406, parity_1385_s11_q, xor_1340_s11_q, xor_1245_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_545_s11_q ? 6'h0 : select_1414;
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1450;
  assign sum_1450 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1453;
  assign sum_1453 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:222
  logic inside_v;
  assign inside_v = or_545_s11_q & not_553_s11_q;
  // hls/stages/agreement.hpp:256
  logic right_2;
  assign right_2 = inside_v & less_1571_s11_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1690;
  assign sum_1690 = {registration_slope_s11_q[11], registration_slope_s11_q} + {{5{sum_1689_s11_q[7]}}, sum_1689_s11_q};
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1713_s11_q ? (patches_second_s11_q ? 8'h0 : patches_right_0_rdata_s11_q) : 8'h0;
  // hls/stages/patches.hpp:462
  logic [8:0] sum_1831;
  assign sum_1831 = {1'b0, patches_columns_above_rdata_s11_q[23:16]} + {3'h0, patches_columns_above_rdata_s11_q[31:26]};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2554;
  assign select_2554 = ({wide_s11_q, 1'b0} < size_3_s11_q) ? {wide_s11_q, 1'b0} : size_3_s11_q;
  logic [8:0] taken;
  assign taken = ~select_2554;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3325;
  assign select_3325 = less_1869_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3327;
  assign select_3327 = less_1869_s11_q ? (equal_1872_s11_q ? 10'h0 : select_3325) : 10'h0;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3332;
  assign select_3332 = less_1869_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3335;
  assign select_3335 = equal_1872_s11_q ? (less_1869_s11_q ? (equal_1872_s11_q ? 5'h0 : select_3332) : 5'h0) : select_3332;

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
  logic sample_pair_whole_s12_q;
  logic sample_present_s12_q;
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [3:0] age_s12_q;
  logic [2:0] slot_s12_q;
  logic ends_cell_s12_q;
  logic lower_half_s12_q;
  logic shift_first_s12_q;
  logic [4:0] patches_band_rows_number_s12_q;
  logic patches_chooses_s12_q;
  logic [4:0] patches_choosing_band_s12_q;
  logic patches_lower_s12_q;
  logic patches_second_s12_q;
  logic [4:0] patches_code_row_s12_q;
  logic [4:0] patches_column_s12_q;
  logic [4:0] patches_step_s12_q;
  logic patches_read_searches_s12_q;
  logic [3:0] select_485_s12_q;
  logic equal_486_s12_q;
  logic [6:0] select_488_s12_q;
  logic [8:0] select_492_s12_q;
  logic and_498_s12_q;
  logic equal_504_s12_q;
  logic [6:0] column_s12_q;
  logic and_522_s12_q;
  logic and_524_s12_q;
  logic so_s12_q;
  logic equal_544_s12_q;
  logic or_545_s12_q;
  logic less_552_s12_q;
  logic not_553_s12_q;
  logic equal_585_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1167_s12_q;
  logic [5:0] select_1416_s12_q;
  logic [6:0] sum_1451_s12_q;
  logic [6:0] sum_1454_s12_q;
  logic and_1471_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic equal_1479_s12_q;
  logic equal_1489_s12_q;
  logic inside_v_s12_q;
  logic [6:0] select_1498_s12_q;
  logic and_1507_s12_q;
  logic or_1520_s12_q;
  logic right_2_s12_q;
  logic and_1598_s12_q;
  logic and_1611_s12_q;
  logic and_1623_s12_q;
  logic less_1625_s12_q;
  logic [5:0] b_s12_q;
  logic equal_1649_s12_q;
  logic and_1659_s12_q;
  logic [7:0] sum_1690_s12_q;
  logic less_1691_s12_q;
  logic less_1692_s12_q;
  logic equal_1701_s12_q;
  logic and_1705_s12_q;
  logic equal_1708_s12_q;
  logic not_1709_s12_q;
  logic equal_1710_s12_q;
  logic not_1711_s12_q;
  logic equal_1712_s12_q;
  logic equal_1713_s12_q;
  logic or_1714_s12_q;
  logic [4:0] select_1738_s12_q;
  logic select_1744_s12_q;
  logic [7:0] patches_left_rdata_s12_q;
  logic [3:0] select_1783_s12_q;
  logic and_1793_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] select_1797_s12_q;
  logic [8:0] sum_1831_s12_q;
  logic less_1869_s12_q;
  logic equal_1870_s12_q;
  logic not_1871_s12_q;
  logic equal_1872_s12_q;
  logic not_1873_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1900_s12_q;
  logic and_1921_s12_q;
  logic and_2043_s12_q;
  logic equal_2184_s12_q;
  logic equal_2308_s12_q;
  logic and_2435_s12_q;
  logic equal_2520_s12_q;
  logic less_2538_s12_q;
  logic [7:0] wide_s12_q;
  logic [8:0] taken_s12_q;
  logic [7:0] not_2556_s12_q;
  logic less_2577_s12_q;
  logic and_2807_s12_q;
  logic or_2859_s12_q;
  logic not_2883_s12_q;
  logic [9:0] select_3328_s12_q;
  logic [4:0] select_3335_s12_q;
  logic equal_3362_s12_q;
  logic less_3692_s12_q;
  logic equal_3910_s12_q;
  always_ff @(posedge clk_i) begin
    if (s11_en) begin
      pixel_0_s12_q <= pixel_0_s11_q;
      pixel_1_s12_q <= pixel_1_s11_q;
      saturated_s12_q <= saturated_s11_q;
      mask_s12_q <= mask_s11_q;
      marks_first_s12_q <= marks_first_s11_q;
      marks_last_s12_q <= marks_last_s11_q;
      sample_pair_whole_s12_q <= sample_pair_whole_s11_q;
      sample_present_s12_q <= sample_present_s11_q;
      run_shift_s12_q <= run_shift_s11_q;
      x_s12_q <= x_s11_q;
      age_s12_q <= age_s11_q;
      slot_s12_q <= slot_s11_q;
      ends_cell_s12_q <= ends_cell_s11_q;
      lower_half_s12_q <= lower_half_s11_q;
      shift_first_s12_q <= shift_first_s11_q;
      patches_band_rows_number_s12_q <= patches_band_rows_number_s11_q;
      patches_chooses_s12_q <= patches_chooses_s11_q;
      patches_choosing_band_s12_q <= patches_choosing_band_s11_q;
      patches_lower_s12_q <= patches_lower_s11_q;
      patches_second_s12_q <= patches_second_s11_q;
      patches_code_row_s12_q <= patches_code_row_s11_q;
      patches_column_s12_q <= patches_column_s11_q;
      patches_step_s12_q <= patches_step_s11_q;
      patches_read_searches_s12_q <= patches_read_searches_s11_q;
      select_485_s12_q <= select_485_s11_q;
      equal_486_s12_q <= equal_486_s11_q;
      select_488_s12_q <= select_488_s11_q;
      select_492_s12_q <= select_492_s11_q;
      and_498_s12_q <= and_498_s11_q;
      equal_504_s12_q <= equal_504_s11_q;
      column_s12_q <= column_s11_q;
      and_522_s12_q <= and_522_s11_q;
      and_524_s12_q <= and_524_s11_q;
      so_s12_q <= so_s11_q;
      equal_544_s12_q <= equal_544_s11_q;
      or_545_s12_q <= or_545_s11_q;
      less_552_s12_q <= less_552_s11_q;
      not_553_s12_q <= not_553_s11_q;
      equal_585_s12_q <= equal_585_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      column_2_s12_q <= column_2;
      select_1167_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1416_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1451_s12_q <= {1'b0, before_v_2} + sum_1450;
      sum_1454_s12_q <= {1'b0, before_v_3} + sum_1453;
      and_1471_s12_q <= and_1471_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      equal_1479_s12_q <= equal_1479_s11_q;
      equal_1489_s12_q <= equal_1489_s11_q;
      inside_v_s12_q <= inside_v;
      select_1498_s12_q <= select_1498_s11_q;
      and_1507_s12_q <= and_1507_s11_q;
      or_1520_s12_q <= or_1520_s11_q;
      right_2_s12_q <= right_2;
      and_1598_s12_q <= and_1598_s11_q;
      and_1611_s12_q <= and_1611_s11_q;
      and_1623_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & right_3_s11_q));
      less_1625_s12_q <= less_1625_s11_q;
      b_s12_q <= b_s11_q;
      equal_1649_s12_q <= equal_1649_s11_q;
      and_1659_s12_q <= and_1659_s11_q;
      sum_1690_s12_q <= sum_1690[7:0];
      less_1691_s12_q <= $signed(6'h0) < $signed(sum_1690[12:7]);
      less_1692_s12_q <= $signed(sum_1690[12:7]) < $signed(6'h3f);
      equal_1701_s12_q <= equal_1701_s11_q;
      and_1705_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & or_1702_s11_q));
      equal_1708_s12_q <= equal_1708_s11_q;
      not_1709_s12_q <= not_1709_s11_q;
      equal_1710_s12_q <= equal_1710_s11_q;
      not_1711_s12_q <= not_1711_s11_q;
      equal_1712_s12_q <= equal_1712_s11_q;
      equal_1713_s12_q <= equal_1713_s11_q;
      or_1714_s12_q <= or_1714_s11_q;
      select_1738_s12_q <= select_1738_s11_q;
      select_1744_s12_q <= select_1744_s11_q;
      patches_left_rdata_s12_q <= patches_left_rdata_q;
      select_1783_s12_q <= select_1783_s11_q;
      and_1793_s12_q <= and_1793_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      select_1797_s12_q <= patches_second_s11_q ? patches_right_1_rdata_s11_q : pixel;
      sum_1831_s12_q <= sum_1831;
      less_1869_s12_q <= less_1869_s11_q;
      equal_1870_s12_q <= equal_1870_s11_q;
      not_1871_s12_q <= not_1871_s11_q;
      equal_1872_s12_q <= equal_1872_s11_q;
      not_1873_s12_q <= not_1873_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_1900_s12_q <= sum_1900_s11_q;
      and_1921_s12_q <= and_1921_s11_q;
      and_2043_s12_q <= and_2043_s11_q;
      equal_2184_s12_q <= equal_2184_s11_q;
      equal_2308_s12_q <= equal_2308_s11_q;
      and_2435_s12_q <= and_2435_s11_q;
      equal_2520_s12_q <= equal_2520_s11_q;
      less_2538_s12_q <= slot_s11_q < 3'h3;
      wide_s12_q <= wide_s11_q;
      taken_s12_q <= taken;
      not_2556_s12_q <= ~wide_s11_q;
      less_2577_s12_q <= less_2577_s11_q;
      and_2807_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & not_2804_s11_q));
      or_2859_s12_q <= or_2859_s11_q;
      not_2883_s12_q <= not_2883_s11_q;
      select_3328_s12_q <= equal_1872_s11_q ? select_3327 : select_3325;
      select_3335_s12_q <= select_3335;
      equal_3362_s12_q <= equal_3362_s11_q;
      less_3692_s12_q <= less_3692_s11_q;
      equal_3910_s12_q <= equal_3910_s11_q;
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
  logic shift_not_right_q;
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [7:0] registration_slope_here_q;
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
  // hls/stages/census.hpp:119
  logic and_499;
  assign and_499 = sample_pair_whole_s12_q & and_498_s12_q;
  // hls/stages/agreement.hpp:799
  logic or_669;
  assign or_669 = shift_first_s12_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:770
  logic [5:0] select_918;
  assign select_918 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1446;
  assign sum_1446 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:743
  logic [6:0] select_1456;
  assign select_1456 = (sum_1451_s12_q < sum_1454_s12_q) ? sum_1454_s12_q : sum_1451_s12_q;
  // hls/stages/agreement.hpp:988
  logic not_1490;
  assign not_1490 = ~equal_1489_s12_q;
  // hls/stages/agreement.hpp:780
  logic and_1492;
  assign and_1492 = ends_cell_s12_q & inside_v_s12_q;
  logic and_1494;
  assign and_1494 = not_1490 & (so_s12_q & and_1492);
  // hls/stages/agreement.hpp:962
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/registration.hpp:83
  logic equal_1626;
  assign equal_1626 = slot_s12_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1629;
  assign select_1629 = b_s12_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1630;
  assign select_1630 = b_s12_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1631;
  assign sum_1631 = {{2{select_1629[6]}}, select_1629} + {select_1630[7], select_1630};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1632;
  assign select_1632 = b_s12_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1633;
  assign select_1633 = b_s12_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1634;
  assign sum_1634 = {{2{select_1632[7]}}, select_1632[7:1]} + {select_1633[7], select_1633};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1636;
  assign select_1636 = b_s12_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1637;
  assign select_1637 = b_s12_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1638;
  assign difference_1638 = {{2{select_1636[7]}}, select_1636[7:1]} - {select_1637[7], select_1637};
  // hls/stages/agreement.hpp:780
  logic [5:0] select_1673;
  assign select_1673 = so_s12_q ? (ends_cell_s12_q ? (inside_v_s12_q ? b_s12_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1694;
  assign select_1694 = less_1691_s12_q ? 8'h7f : (less_1692_s12_q ? 8'h80 : sum_1690_s12_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1626 ? registration_slope_here_q : select_1694;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_1698;
  assign select_1698 = so_s12_q ? (ends_cell_s12_q ? (inside_v_s12_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1706;
  assign and_1706 = not_1490 & and_1705_s12_q;
  // hls/stages/patches.hpp:172
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1713_s12_q ? select_1797_s12_q : patches_left_rdata_s12_q;
  // hls/stages/patches.hpp:462
  logic [9:0] sum_1832;
  assign sum_1832 = {2'h0, patches_columns_above_rdata_s12_q[15:8]} + {1'b0, sum_1831_s12_q};
  // hls/stages/agreement.hpp:233
  logic [5:0] select_2408;
  assign select_2408 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2409;
  assign select_2409 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2410;
  assign select_2410 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2411;
  assign select_2411 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2412;
  assign select_2412 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2413;
  assign select_2413 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:969
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s12_q[61:54]} - {1'b0, best_left_rdata_s12_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2549;
  assign not_2549 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2538_s12_q ? {1'b0, wide_s12_q, 1'b0} : {registration_displacement_over_q[8:0], not_2549};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2557;
  assign select_2557 = registration_displacement_over_q[9] ? wide_s12_q : not_2556_s12_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2538_s12_q ? {taken_s12_q, 1'b1} : {not_2549, select_2557, not_2549};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2559;
  assign sum_2559 = {left, 1'b1} + {taken_2, less_2538_s12_q};
  // hls/stages/agreement.hpp:251
  logic [4:0] select_2561;
  assign select_2561 = so_s12_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_2563;
  assign select_2563 = equal_1489_s12_q ? registration_slope_here_q : (so_s12_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:147
  logic [2:0] select_2572;
  assign select_2572 = or_545_s12_q ? (less_552_s12_q ? 3'h0 : best_left_rdata_s12_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3330;
  assign select_3330 = less_1869_s12_q ? (equal_1870_s12_q ? 10'h0 : select_3328_s12_q) : select_3328_s12_q;
  logic [4:0] select_3337;
  assign select_3337 = less_1869_s12_q ? (equal_1870_s12_q ? 5'h0 : select_3335_s12_q) : select_3335_s12_q;
  // hls/stages/patches.hpp:551
  logic and_3347;
  assign and_3347 = less_1869_s12_q & (patches_step_s12_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3350;
  assign select_3350 = equal_1872_s12_q ? (less_1869_s12_q ? (not_1873_s12_q & and_3347) : and_3347) : and_3347;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 12, written in stage 15: 12 < 15 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_492_s12_q;
  logic averager_memory_re;
  assign averager_memory_re = s12_en & and_499;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1371; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s12_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s12_en & and_1494;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      shift_not_right_q <= 1'b0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
    end else if (s12_en) begin
      shift_not_right_q <= $signed(run_shift_s12_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s12_q ? sum_2559[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2561;
      registration_slope_here_q <= select_2563;
      patches_read_row_differing_q <= equal_1708_s12_q ? select_3330 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1708_s12_q ? select_3337 : patches_read_row_column_q;
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
      middle_sum_columns_values_1_q <= select_2408;
      middle_sum_columns_values_2_q <= select_2409;
      middle_sum_columns_values_3_q <= select_2410;
      middle_sum_columns_values_4_q <= select_2411;
      middle_sum_columns_values_5_q <= select_2412;
      middle_sum_columns_values_6_q <= select_2413;
    end
  end

  logic [7:0] pixel_0_s13_q;
  logic [7:0] pixel_1_s13_q;
  logic saturated_s13_q;
  logic mask_s13_q;
  logic marks_first_s13_q;
  logic marks_last_s13_q;
  logic sample_pair_whole_s13_q;
  logic sample_present_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic [1:0] age_s13_q;
  logic [2:0] slot_s13_q;
  logic ends_cell_s13_q;
  logic lower_half_s13_q;
  logic shift_not_right_s13_q;
  logic [4:0] patches_band_rows_number_s13_q;
  logic [4:0] patches_choosing_band_s13_q;
  logic patches_lower_s13_q;
  logic patches_second_s13_q;
  logic [4:0] patches_code_row_s13_q;
  logic [4:0] patches_column_s13_q;
  logic [4:0] patches_step_s13_q;
  logic [9:0] patches_read_row_differing_s13_q;
  logic [4:0] patches_read_row_column_s13_q;
  logic patches_read_searches_s13_q;
  logic [3:0] select_485_s13_q;
  logic equal_486_s13_q;
  logic [6:0] select_488_s13_q;
  logic [8:0] select_492_s13_q;
  logic and_498_s13_q;
  logic and_499_s13_q;
  logic equal_504_s13_q;
  logic [6:0] column_s13_q;
  logic and_522_s13_q;
  logic and_524_s13_q;
  logic so_s13_q;
  logic equal_544_s13_q;
  logic or_545_s13_q;
  logic not_553_s13_q;
  logic equal_585_s13_q;
  logic [6:0] x_s13_2_q;
  logic [61:0] best_left_rdata_s13_q;
  logic select_671_s13_q;
  logic [6:0] difference_919_s13_q;
  logic [6:0] difference_1168_s13_q;
  logic equal_1169_s13_q;
  logic [6:0] difference_1417_s13_q;
  logic [6:0] sum_1447_s13_q;
  logic [6:0] select_1456_s13_q;
  logic and_1471_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1480_s13_q;
  logic equal_1489_s13_q;
  logic not_1490_s13_q;
  logic inside_v_s13_q;
  logic and_1492_s13_q;
  logic and_1494_s13_q;
  logic [6:0] select_1498_s13_q;
  logic and_1507_s13_q;
  logic less_1508_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1520_s13_q;
  logic right_2_s13_q;
  logic and_1598_s13_q;
  logic and_1611_s13_q;
  logic and_1624_s13_q;
  logic less_1625_s13_q;
  logic equal_1626_s13_q;
  logic [7:0] sum_1631_s13_q;
  logic select_1632_s13_q;
  logic [8:0] sum_1634_s13_q;
  logic select_1636_s13_q;
  logic [8:0] difference_1638_s13_q;
  logic equal_1649_s13_q;
  logic and_1659_s13_q;
  logic [5:0] select_1674_s13_q;
  logic [7:0] select_1699_s13_q;
  logic equal_1701_s13_q;
  logic and_1706_s13_q;
  logic and_1707_s13_q;
  logic equal_1708_s13_q;
  logic not_1709_s13_q;
  logic equal_1710_s13_q;
  logic not_1711_s13_q;
  logic equal_1712_s13_q;
  logic equal_1713_s13_q;
  logic or_1714_s13_q;
  logic [4:0] select_1738_s13_q;
  logic select_1744_s13_q;
  logic [3:0] select_1783_s13_q;
  logic and_1793_s13_q;
  logic [31:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [9:0] sum_1832_s13_q;
  logic less_1869_s13_q;
  logic equal_1870_s13_q;
  logic not_1871_s13_q;
  logic equal_1872_s13_q;
  logic not_1873_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1900_s13_q;
  logic and_1921_s13_q;
  logic and_2044_s13_q;
  logic equal_2184_s13_q;
  logic equal_2308_s13_q;
  logic and_2435_s13_q;
  logic equal_2520_s13_q;
  logic rise_s13_q;
  logic [7:0] xor_2525_s13_q;
  logic select_2572_s13_q;
  logic or_2575_s13_q;
  logic [1:0] sum_2576_s13_q;
  logic less_2577_s13_q;
  logic and_2808_s13_q;
  logic or_2859_s13_q;
  logic not_2883_s13_q;
  logic select_3350_s13_q;
  logic equal_3362_s13_q;
  logic less_3692_s13_q;
  logic equal_3910_s13_q;
  always_ff @(posedge clk_i) begin
    if (s12_en) begin
      pixel_0_s13_q <= pixel_0_s12_q;
      pixel_1_s13_q <= pixel_1_s12_q;
      saturated_s13_q <= saturated_s12_q;
      mask_s13_q <= mask_s12_q;
      marks_first_s13_q <= marks_first_s12_q;
      marks_last_s13_q <= marks_last_s12_q;
      sample_pair_whole_s13_q <= sample_pair_whole_s12_q;
      sample_present_s13_q <= sample_present_s12_q;
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      age_s13_q <= {age_s12_q[2], age_s12_q[0]};
      slot_s13_q <= slot_s12_q;
      ends_cell_s13_q <= ends_cell_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      shift_not_right_s13_q <= shift_not_right_q;
      patches_band_rows_number_s13_q <= patches_band_rows_number_s12_q;
      patches_choosing_band_s13_q <= patches_choosing_band_s12_q;
      patches_lower_s13_q <= patches_lower_s12_q;
      patches_second_s13_q <= patches_second_s12_q;
      patches_code_row_s13_q <= patches_code_row_s12_q;
      patches_column_s13_q <= patches_column_s12_q;
      patches_step_s13_q <= patches_step_s12_q;
      patches_read_row_differing_s13_q <= patches_read_row_differing_q;
      patches_read_row_column_s13_q <= patches_read_row_column_q;
      patches_read_searches_s13_q <= patches_read_searches_s12_q;
      select_485_s13_q <= select_485_s12_q;
      equal_486_s13_q <= equal_486_s12_q;
      select_488_s13_q <= select_488_s12_q;
      select_492_s13_q <= select_492_s12_q;
      and_498_s13_q <= and_498_s12_q;
      and_499_s13_q <= and_499;
      equal_504_s13_q <= equal_504_s12_q;
      column_s13_q <= column_s12_q;
      and_522_s13_q <= and_522_s12_q;
      and_524_s13_q <= and_524_s12_q;
      so_s13_q <= so_s12_q;
      equal_544_s13_q <= equal_544_s12_q;
      or_545_s13_q <= or_545_s12_q;
      not_553_s13_q <= not_553_s12_q;
      equal_585_s13_q <= equal_585_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_671_s13_q <= or_669 ? shift_first_s12_q : (~age_s12_q[1]);
      difference_919_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_918};
      difference_1168_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1167_s12_q};
      equal_1169_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1417_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1416_s12_q};
      sum_1447_s13_q <= {1'b0, before_v} + sum_1446;
      select_1456_s13_q <= select_1456;
      and_1471_s13_q <= and_1471_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1480_s13_q <= or_669 ? shift_first_s12_q : equal_1479_s12_q;
      equal_1489_s13_q <= equal_1489_s12_q;
      not_1490_s13_q <= not_1490;
      inside_v_s13_q <= inside_v_s12_q;
      and_1492_s13_q <= and_1492;
      and_1494_s13_q <= and_1494;
      select_1498_s13_q <= select_1498_s12_q;
      and_1507_s13_q <= and_1507_s12_q;
      less_1508_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1520_s13_q <= or_1520_s12_q;
      right_2_s13_q <= right_2_s12_q;
      and_1598_s13_q <= and_1598_s12_q;
      and_1611_s13_q <= and_1611_s12_q;
      and_1624_s13_q <= not_1490 & and_1623_s12_q;
      less_1625_s13_q <= less_1625_s12_q;
      equal_1626_s13_q <= equal_1626;
      sum_1631_s13_q <= sum_1631[8:1];
      select_1632_s13_q <= select_1632[0];
      sum_1634_s13_q <= sum_1634;
      select_1636_s13_q <= select_1636[0];
      difference_1638_s13_q <= difference_1638;
      equal_1649_s13_q <= equal_1649_s12_q;
      and_1659_s13_q <= and_1659_s12_q;
      select_1674_s13_q <= equal_1489_s12_q ? 6'h0 : select_1673;
      select_1699_s13_q <= equal_1489_s12_q ? 8'h0 : select_1698;
      equal_1701_s13_q <= equal_1701_s12_q;
      and_1706_s13_q <= and_1706;
      and_1707_s13_q <= patches_chooses_s12_q & and_1706;
      equal_1708_s13_q <= equal_1708_s12_q;
      not_1709_s13_q <= not_1709_s12_q;
      equal_1710_s13_q <= equal_1710_s12_q;
      not_1711_s13_q <= not_1711_s12_q;
      equal_1712_s13_q <= equal_1712_s12_q;
      equal_1713_s13_q <= equal_1713_s12_q;
      or_1714_s13_q <= or_1714_s12_q;
      select_1738_s13_q <= select_1738_s12_q;
      select_1744_s13_q <= select_1744_s12_q;
      select_1783_s13_q <= select_1783_s12_q;
      and_1793_s13_q <= and_1793_s12_q;
      patches_columns_above_rdata_s13_q <= patches_columns_above_rdata_s12_q;
      pixel_2_s13_q <= pixel_2;
      sum_1832_s13_q <= sum_1832;
      less_1869_s13_q <= less_1869_s12_q;
      equal_1870_s13_q <= equal_1870_s12_q;
      not_1871_s13_q <= not_1871_s12_q;
      equal_1872_s13_q <= equal_1872_s12_q;
      not_1873_s13_q <= not_1873_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1900_s13_q <= sum_1900_s12_q;
      and_1921_s13_q <= and_1921_s12_q;
      and_2044_s13_q <= not_1490 & and_2043_s12_q;
      equal_2184_s13_q <= equal_2184_s12_q;
      equal_2308_s13_q <= equal_2308_s12_q;
      and_2435_s13_q <= and_2435_s12_q;
      equal_2520_s13_q <= equal_2520_s12_q;
      rise_s13_q <= rise[8];
      xor_2525_s13_q <= rise[7:0] ^ {8{rise[8]}};
      select_2572_s13_q <= select_2572[0];
      or_2575_s13_q <= (select_2572 == 3'h0) | (select_2572 == 3'h4);
      sum_2576_s13_q <= select_2572[2:1] + 2'h3;
      less_2577_s13_q <= less_2577_s12_q;
      and_2808_s13_q <= not_1490 & and_2807_s12_q;
      or_2859_s13_q <= or_2859_s12_q;
      not_2883_s13_q <= not_2883_s12_q;
      select_3350_s13_q <= select_3350;
      equal_3362_s13_q <= equal_3362_s12_q;
      less_3692_s13_q <= less_3692_s12_q;
      equal_3910_s13_q <= equal_3910_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [6:0] chosen_near_q;
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic patches_read_first_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  // hls/stages/census.hpp:112
  logic [13:0] select_502;
  assign select_502 = equal_486_s13_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_508;
  assign sum_508 = {6'h0, sample_pair_pixel_1_q} + (equal_486_s13_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:770
  logic [7:0] sum_921;
  assign sum_921 = {difference_919_s13_q[6], difference_919_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1171;
  assign sum_1171 = {difference_1168_s13_q[6], difference_1168_s13_q} + (equal_1169_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1419;
  assign sum_1419 = {difference_1417_s13_q[6], difference_1417_s13_q} + (equal_1169_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:747
  logic [6:0] select_1448;
  assign select_1448 = slot_s13_q[0] ? chosen_near_q : sum_1447_s13_q;
  // hls/stages/agreement.hpp:743
  logic [6:0] select_1458;
  assign select_1458 = (select_1448 < select_1456_s13_q) ? select_1456_s13_q : select_1448;
  // hls/stages/agreement.hpp:961
  logic select_1510;
  assign select_1510 = slot_s13_q[2] ? less_1508_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:975
  logic [8:0] difference_1513;
  assign difference_1513 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1635;
  assign sum_1635 = {{3{sum_1631_s13_q[7]}}, sum_1631_s13_q} + {sum_1634_s13_q[8], sum_1634_s13_q, select_1632_s13_q};
  logic [9:0] sum_1639;
  assign sum_1639 = {difference_1638_s13_q, select_1636_s13_q} + {sum_1635[10], sum_1635[10:2]};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_1821;
  assign sum_1821 = {1'b0, patches_columns_above_rdata_s13_q[7:0]} + {2'h0, pixel_2_s13_q[7:1]};
  logic [8:0] sum_1822;
  assign sum_1822 = {1'b0, patches_columns_above_rdata_s13_q[23:16]} + {2'h0, patches_columns_above_rdata_s13_q[31:25]};
  // hls/stages/patches.hpp:462
  logic [10:0] sum_1833;
  assign sum_1833 = {3'h0, patches_columns_above_rdata_s13_q[15:8]} + {sum_1832_s13_q, patches_columns_above_rdata_s13_q[25]};
  // hls/stages/agreement.hpp:233
  logic [6:0] select_2420;
  assign select_2420 = slot_s13_q[0] ? 7'h0 : sum_1447_s13_q;
  // hls/stages/agreement.hpp:743
  logic [6:0] select_2422;
  assign select_2422 = (select_2420 < select_1456_s13_q) ? select_1456_s13_q : select_2420;
  // hls/stages/agreement.hpp:970
  logic [7:0] lower;
  assign lower = rise_s13_q ? best_left_rdata_s13_q[61:54] : best_left_rdata_s13_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2578;
  assign difference_2578 = {sum_2576_s13_q, select_2572_s13_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2579;
  assign select_2579 = less_2577_s13_q ? difference_2578 : {sum_2576_s13_q, select_2572_s13_q, registration_displacement_fraction_q};
  logic [7:0] select_2580;
  assign select_2580 = or_2575_s13_q ? {sum_2576_s13_q, select_2572_s13_q, 5'h0} : select_2579;
  // hls/stages/patches.hpp:187
  logic select_2898;
  assign select_2898 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:175
  logic and_2959;
  assign and_2959 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_2964;
  assign select_2964 = or_2859_s13_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_2966;
  assign select_2966 = and_2959 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:551
  logic [4:0] select_3339;
  assign select_3339 = less_1869_s13_q ? patches_step_s13_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3342;
  assign select_3342 = equal_1872_s13_q ? (less_1869_s13_q ? (equal_1872_s13_q ? 5'h0 : select_3339) : 5'h0) : select_3339;
  logic [4:0] select_3344;
  assign select_3344 = less_1869_s13_q ? (equal_1870_s13_q ? 5'h0 : select_3342) : select_3342;
  logic select_3352;
  assign select_3352 = less_1869_s13_q ? (not_1871_s13_q & select_3350_s13_q) : select_3350_s13_q;
  // hls/stages/patches.hpp:178
  logic or_3364;
  assign or_3364 = patches_read_first_q | (patches_read_row_differing_s13_q < patches_peak_best_differing_q);
  logic and_3365;
  assign and_3365 = patches_read_searches_s13_q & or_3364;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3397;
  assign select_3397 = and_3365 ? {patches_read_row_column_s13_q, patches_read_row_differing_s13_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3398;
  assign select_3398 = equal_1708_s13_q ? select_3397[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3399;
  assign select_3399 = equal_1708_s13_q ? select_3397[14:10] : patches_peak_best_column_q;

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1344; read in stage 13, written in stage 16: 13 < 16 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s13_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s13_en & and_1494_s13_q;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s13_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s13_en & and_1793_s13_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_s13_q[23:0], pixel_2_s13_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_columns_above_raddr_s10_sim;
  logic patches_columns_above_re_s10_sim;
  logic [4:0] patches_columns_above_raddr_s11_sim;
  logic patches_columns_above_re_s11_sim;
  logic [4:0] patches_columns_above_raddr_s12_sim;
  logic patches_columns_above_re_s12_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_columns_above_re_s10_sim <= 1'b0;
      patches_columns_above_re_s11_sim <= 1'b0;
      patches_columns_above_re_s12_sim <= 1'b0;
    end else if (en_i) begin
      patches_columns_above_re_s10_sim <= patches_columns_above_re;
      patches_columns_above_raddr_s10_sim <= patches_columns_above_raddr;
      patches_columns_above_re_s11_sim <= patches_columns_above_re_s10_sim;
      patches_columns_above_raddr_s11_sim <= patches_columns_above_raddr_s10_sim;
      patches_columns_above_re_s12_sim <= patches_columns_above_re_s11_sim;
      patches_columns_above_raddr_s12_sim <= patches_columns_above_raddr_s11_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s10_sim && patches_columns_above_raddr_s10_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s11_sim && patches_columns_above_raddr_s11_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s12_sim && patches_columns_above_raddr_s12_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      chosen_near_q <= 7'h0;
      patches_along_ends_q <= 1'b0;
      patches_match_row_ends_q <= 1'b0;
      patches_down_by_q <= 5'h0;
      patches_along_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_last_q <= 1'b0;
      patches_read_first_q <= 1'b0;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
    end else if (s13_en) begin
      sample_pair_pixel_0_q <= pixel_0_s13_q;
      sample_pair_pixel_1_q <= pixel_1_s13_q;
      chosen_near_q <= select_2422;
      patches_along_ends_q <= not_2883_s13_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2883_s13_q & select_2898;
      patches_down_by_q <= or_2859_s13_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2959});
      patches_along_q <= select_2964;
      patches_match_row_q <= or_2859_s13_q ? 4'h0 : select_2966;
      patches_summed_last_q <= not_1709_s13_q & (equal_1710_s13_q & and_2959);
      patches_read_first_q <= equal_1708_s13_q ? select_3352 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3398;
      patches_peak_best_column_q <= select_3399;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_running_0_q = 14'h0;
    averager_running_1_q = 14'h0;
    middle_sum_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_1_q = 8'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_1_sum_sums_values_1_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s13_en) begin
      averager_running_0_q <= sample_pair_whole_s13_q ? select_502 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s13_q ? sum_508 : averager_running_1_q;
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_921;
      sums_0_sum_sums_values_0_q <= sum_1171;
      sums_0_sum_sums_values_1_q <= equal_1169_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1419;
      sums_1_sum_sums_values_1_q <= equal_1169_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic saturated_s14_q;
  logic mask_s14_q;
  logic marks_first_s14_q;
  logic marks_last_s14_q;
  logic [7:0] sample_pair_pixel_0_s14_q;
  logic [7:0] sample_pair_pixel_1_s14_q;
  logic sample_pair_whole_s14_q;
  logic sample_present_s14_q;
  logic [5:0] run_shift_s14_q;
  logic [7:0] x_s14_q;
  logic age_s14_q;
  logic [2:0] slot_s14_q;
  logic ends_cell_s14_q;
  logic lower_half_s14_q;
  logic shift_not_right_s14_q;
  logic [4:0] patches_band_rows_number_s14_q;
  logic [4:0] patches_choosing_band_s14_q;
  logic patches_lower_s14_q;
  logic patches_second_s14_q;
  logic [4:0] patches_code_row_s14_q;
  logic [4:0] patches_column_s14_q;
  logic patches_match_row_ends_s14_q;
  logic [4:0] patches_down_by_s14_q;
  logic [4:0] patches_along_s14_q;
  logic [3:0] patches_match_row_s14_q;
  logic patches_summed_last_s14_q;
  logic [4:0] patches_step_s14_q;
  logic [9:0] patches_read_row_differing_s14_q;
  logic patches_read_first_s14_q;
  logic [3:0] select_485_s14_q;
  logic equal_486_s14_q;
  logic [6:0] select_488_s14_q;
  logic [8:0] select_492_s14_q;
  logic and_498_s14_q;
  logic and_499_s14_q;
  logic [29:0] averager_memory_rdata_s14_q;
  logic [13:0] select_502_s14_q;
  logic equal_504_s14_q;
  logic [13:0] sum_508_s14_q;
  logic [6:0] column_s14_q;
  logic and_522_s14_q;
  logic and_524_s14_q;
  logic so_s14_q;
  logic equal_544_s14_q;
  logic or_545_s14_q;
  logic not_553_s14_q;
  logic equal_585_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_671_s14_q;
  logic [7:0] sum_921_s14_q;
  logic less_1420_s14_q;
  logic [6:0] select_1458_s14_q;
  logic [7:0] select_1466_s14_q;
  logic [7:0] select_1469_s14_q;
  logic and_1471_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1480_s14_q;
  logic equal_1489_s14_q;
  logic not_1490_s14_q;
  logic inside_v_s14_q;
  logic and_1492_s14_q;
  logic and_1494_s14_q;
  logic [6:0] select_1498_s14_q;
  logic and_1507_s14_q;
  logic select_1510_s14_q;
  logic [9:0] sum_1514_s14_q;
  logic or_1520_s14_q;
  logic right_2_s14_q;
  logic and_1598_s14_q;
  logic and_1611_s14_q;
  logic and_1624_s14_q;
  logic less_1625_s14_q;
  logic equal_1626_s14_q;
  logic sum_1635_s14_q;
  logic [9:0] sum_1639_s14_q;
  logic equal_1649_s14_q;
  logic and_1659_s14_q;
  logic [5:0] select_1674_s14_q;
  logic [7:0] select_1699_s14_q;
  logic equal_1701_s14_q;
  logic and_1706_s14_q;
  logic and_1707_s14_q;
  logic equal_1708_s14_q;
  logic not_1709_s14_q;
  logic equal_1710_s14_q;
  logic not_1711_s14_q;
  logic equal_1712_s14_q;
  logic equal_1713_s14_q;
  logic or_1714_s14_q;
  logic [4:0] select_1738_s14_q;
  logic select_1744_s14_q;
  logic [3:0] select_1783_s14_q;
  logic [8:0] patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic [4:0] sum_1807_s14_q;
  logic [8:0] sum_1821_s14_q;
  logic [8:0] sum_1822_s14_q;
  logic [10:0] sum_1833_s14_q;
  logic less_1869_s14_q;
  logic equal_1870_s14_q;
  logic not_1871_s14_q;
  logic equal_1872_s14_q;
  logic not_1873_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic sum_1900_s14_q;
  logic and_1921_s14_q;
  logic [17:0] seen_columns_rdata_s14_q;
  logic and_2044_s14_q;
  logic equal_2184_s14_q;
  logic equal_2308_s14_q;
  logic and_2435_s14_q;
  logic equal_2520_s14_q;
  logic [7:0] lower_s14_q;
  logic [7:0] sum_2526_s14_q;
  logic [7:0] select_2580_s14_q;
  logic and_2808_s14_q;
  logic [4:0] select_3344_s14_q;
  logic equal_3362_s14_q;
  logic and_3365_s14_q;
  logic [14:0] select_3397_s14_q;
  logic less_3692_s14_q;
  logic equal_3910_s14_q;
  always_ff @(posedge clk_i) begin
    if (s13_en) begin
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_pixel_0_s14_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s14_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s14_q <= sample_pair_whole_s13_q;
      sample_present_s14_q <= sample_present_s13_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      age_s14_q <= age_s13_q[1];
      slot_s14_q <= slot_s13_q;
      ends_cell_s14_q <= ends_cell_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      shift_not_right_s14_q <= shift_not_right_s13_q;
      patches_band_rows_number_s14_q <= patches_band_rows_number_s13_q;
      patches_choosing_band_s14_q <= patches_choosing_band_s13_q;
      patches_lower_s14_q <= patches_lower_s13_q;
      patches_second_s14_q <= patches_second_s13_q;
      patches_code_row_s14_q <= patches_code_row_s13_q;
      patches_column_s14_q <= patches_column_s13_q;
      patches_match_row_ends_s14_q <= patches_match_row_ends_q;
      patches_down_by_s14_q <= patches_down_by_q;
      patches_along_s14_q <= patches_along_q;
      patches_match_row_s14_q <= patches_match_row_q;
      patches_summed_last_s14_q <= patches_summed_last_q;
      patches_step_s14_q <= patches_step_s13_q;
      patches_read_row_differing_s14_q <= patches_read_row_differing_s13_q;
      patches_read_first_s14_q <= patches_read_first_q;
      select_485_s14_q <= select_485_s13_q;
      equal_486_s14_q <= equal_486_s13_q;
      select_488_s14_q <= select_488_s13_q;
      select_492_s14_q <= select_492_s13_q;
      and_498_s14_q <= and_498_s13_q;
      and_499_s14_q <= and_499_s13_q;
      averager_memory_rdata_s14_q <= averager_memory_rdata_q;
      select_502_s14_q <= select_502;
      equal_504_s14_q <= equal_504_s13_q;
      sum_508_s14_q <= sum_508;
      column_s14_q <= column_s13_q;
      and_522_s14_q <= and_522_s13_q;
      and_524_s14_q <= and_524_s13_q;
      so_s14_q <= so_s13_q;
      equal_544_s14_q <= equal_544_s13_q;
      or_545_s14_q <= or_545_s13_q;
      not_553_s14_q <= not_553_s13_q;
      equal_585_s14_q <= equal_585_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[45:0];
      select_671_s14_q <= select_671_s13_q;
      sum_921_s14_q <= sum_921;
      less_1420_s14_q <= sum_1171 < sum_1419;
      select_1458_s14_q <= select_1458;
      select_1466_s14_q <= select_671_s13_q ? 8'h0 : best_left_rdata_s13_q[53:46];
      select_1469_s14_q <= select_671_s13_q ? 8'h0 : best_left_rdata_s13_q[61:54];
      and_1471_s14_q <= and_1471_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1480_s14_q <= select_1480_s13_q;
      equal_1489_s14_q <= equal_1489_s13_q;
      not_1490_s14_q <= not_1490_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      and_1492_s14_q <= and_1492_s13_q;
      and_1494_s14_q <= and_1494_s13_q;
      select_1498_s14_q <= select_1498_s13_q;
      and_1507_s14_q <= and_1507_s13_q;
      select_1510_s14_q <= select_1510;
      sum_1514_s14_q <= {difference_1513[8], difference_1513} + 10'h1;
      or_1520_s14_q <= or_1520_s13_q;
      right_2_s14_q <= right_2_s13_q;
      and_1598_s14_q <= and_1598_s13_q;
      and_1611_s14_q <= and_1611_s13_q;
      and_1624_s14_q <= and_1624_s13_q;
      less_1625_s14_q <= less_1625_s13_q;
      equal_1626_s14_q <= equal_1626_s13_q;
      sum_1635_s14_q <= sum_1635[1];
      sum_1639_s14_q <= sum_1639;
      equal_1649_s14_q <= equal_1649_s13_q;
      and_1659_s14_q <= and_1659_s13_q;
      select_1674_s14_q <= select_1674_s13_q;
      select_1699_s14_q <= select_1699_s13_q;
      equal_1701_s14_q <= equal_1701_s13_q;
      and_1706_s14_q <= and_1706_s13_q;
      and_1707_s14_q <= and_1707_s13_q;
      equal_1708_s14_q <= equal_1708_s13_q;
      not_1709_s14_q <= not_1709_s13_q;
      equal_1710_s14_q <= equal_1710_s13_q;
      not_1711_s14_q <= not_1711_s13_q;
      equal_1712_s14_q <= equal_1712_s13_q;
      equal_1713_s14_q <= equal_1713_s13_q;
      or_1714_s14_q <= or_1714_s13_q;
      select_1738_s14_q <= select_1738_s13_q;
      select_1744_s14_q <= select_1744_s13_q;
      select_1783_s14_q <= select_1783_s13_q;
      patches_columns_above_rdata_s14_q <= {patches_columns_above_rdata_s13_q[24], patches_columns_above_rdata_s13_q[7:0]};
      pixel_2_s14_q <= pixel_2_s13_q;
      sum_1807_s14_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1821_s14_q <= sum_1821;
      sum_1822_s14_q <= sum_1822;
      sum_1833_s14_q <= sum_1833;
      less_1869_s14_q <= less_1869_s13_q;
      equal_1870_s14_q <= equal_1870_s13_q;
      not_1871_s14_q <= not_1871_s13_q;
      equal_1872_s14_q <= equal_1872_s13_q;
      not_1873_s14_q <= not_1873_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      sum_1900_s14_q <= sum_1900_s13_q;
      and_1921_s14_q <= and_1921_s13_q;
      seen_columns_rdata_s14_q <= seen_columns_rdata_q;
      and_2044_s14_q <= and_2044_s13_q;
      equal_2184_s14_q <= equal_2184_s13_q;
      equal_2308_s14_q <= equal_2308_s13_q;
      and_2435_s14_q <= and_2435_s13_q;
      equal_2520_s14_q <= equal_2520_s13_q;
      lower_s14_q <= lower;
      sum_2526_s14_q <= {7'h0, rise_s13_q} + xor_2525_s13_q;
      select_2580_s14_q <= select_2580;
      and_2808_s14_q <= and_2808_s13_q;
      select_3344_s14_q <= select_3344;
      equal_3362_s14_q <= equal_3362_s13_q;
      and_3365_s14_q <= and_3365;
      select_3397_s14_q <= select_3397;
      less_3692_s14_q <= less_3692_s13_q;
      equal_3910_s14_q <= equal_3910_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic sample_of_skin_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic [7:0] chosen_score_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  logic shift_allowed_q;
  logic [10:0] registration_expected_q;
  logic [4:0] patches_band_q;
  logic [1:0] patches_fetch_q;
  logic [4:0] patches_summed_down_by_q;
  logic [4:0] patches_read_at_q;
  logic [4:0] patches_peak_row_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  // hls/stages/census.hpp:121
  logic [13:0] sum_506;
  assign sum_506 = select_502_s14_q + (equal_504_s14_q ? 14'h0 : averager_memory_rdata_s14_q[13:0]);
  logic [13:0] sum_510;
  assign sum_510 = sum_508_s14_q + (equal_504_s14_q ? 14'h0 : averager_memory_rdata_s14_q[27:14]);
  // hls/stages/agreement.hpp:411
  logic whole;
  assign whole = equal_486_s14_q ? sample_present_s14_q : (sample_present_s14_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_486_s14_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:123
  logic and_518;
  assign and_518 = all_of_skin & (averager_memory_rdata_s14_q[29] | equal_504_s14_q);
  // hls/stages/agreement.hpp:747
  logic [7:0] select_922;
  assign select_922 = slot_s14_q[0] ? chosen_score_q : sum_921_s14_q;
  // hls/stages/agreement.hpp:743
  logic [7:0] select_1421;
  assign select_1421 = less_1420_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1422;
  assign less_1422 = select_922 < select_1421;
  // hls/stages/agreement.hpp:793
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1422 ? select_1421 : select_922) : 8'h0;
  // hls/stages/agreement.hpp:712
  logic not_1428;
  assign not_1428 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:744
  logic [1:0] select_1429;
  assign select_1429 = less_1420_s14_q ? {slot_s14_q[0], not_1428} : 2'h0;
  logic [2:0] select_1431;
  assign select_1431 = less_1422 ? {select_1429, not_1428} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:794
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1458_s14_q : 7'h0;
  // hls/stages/agreement.hpp:805
  logic less_1460;
  assign less_1460 = best_left_rdata_s14_q[39:33] < of_near;
  // hls/stages/agreement.hpp:241
  logic and_1516;
  assign and_1516 = (and_1507_s14_q & select_1510_s14_q) & ({{22{sum_1514_s14_q[9]}}, sum_1514_s14_q} < 32'h3);
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s14_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:210
  logic equal_1544;
  assign equal_1544 = x_s14_q[5:0] == 6'h3c;
  logic equal_1546;
  assign equal_1546 = x_s14_q[5:0] == 6'h3b;
  logic equal_1548;
  assign equal_1548 = x_s14_q[5:0] == 6'h36;
  logic equal_1550;
  assign equal_1550 = x_s14_q[5:0] == 6'h35;
  logic equal_1552;
  assign equal_1552 = x_s14_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1150
  logic and_1556;
  assign and_1556 = (~equal_1546) & ((~equal_1548) & ((~equal_1550) & (~equal_1552)));
  // hls/stages/patches.hpp:372
  logic [1:0] select_1612;
  assign select_1612 = and_1611_s14_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1613;
  assign select_1613 = and_1611_s14_q ? patches_band_rows_number_s14_q : patches_band_q;
  // hls/stages/agreement.hpp:270
  logic [5:0] select_1614;
  assign select_1614 = and_1598_s14_q ? {select_1613, select_1612[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1615;
  assign select_1615 = and_1598_s14_q ? select_1612 : patches_fetch_q;
  logic equal_1616;
  assign equal_1616 = select_1615 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1626_s14_q ? {sum_1639_s14_q, sum_1635_s14_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1721;
  assign select_1721 = and_1598_s14_q ? select_1613 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_1722;
  assign equal_1722 = {patches_choosing_band_s14_q, and_1624_s14_q} == {select_1721, select_1615[1]};
  // hls/stages/patches.hpp:495
  logic less_1799;
  assign less_1799 = 5'he < patches_along_s14_q;
  // hls/stages/patches.hpp:496
  logic or_1800;
  assign or_1800 = equal_1712_s14_q | less_1799;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_s14_q == 5'h0;
  logic select_1805;
  assign select_1805 = equal_1712_s14_q ? patches_column_s14_q[0] : (or_1800 ? (patches_along_s14_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:497
  logic [4:0] select_1808;
  assign select_1808 = patches_match_row_ends_s14_q ? patches_down_by_s14_q : sum_1807_s14_q;
  // hls/stages/patches.hpp:500
  logic [4:0] select_1811;
  assign select_1811 = equal_1712_s14_q ? 5'h0 : (or_1800 ? (select_1808 + 5'h1) : sum_1807_s14_q);
  // hls/stages/patches.hpp:476
  logic equal_1814;
  assign equal_1814 = patches_column_s14_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s14_q == 5'h11;
  logic equal_1816;
  assign equal_1816 = patches_column_s14_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_1818;
  assign and_1818 = of_row & (~equal_1816);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1814 ? 2'h3 : {equal_1816, and_1818};
  // hls/stages/patches.hpp:464
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1821_s14_q, pixel_2_s14_q[0]} - {1'b0, sum_1822_s14_q, patches_columns_above_rdata_s14_q[8]};
  // hls/stages/patches.hpp:462
  logic [9:0] sum_1834;
  assign sum_1834 = {2'h0, patches_columns_above_rdata_s14_q[7:0]} + sum_1833_s14_q[10:1];
  // hls/stages/patches.hpp:477
  logic or_1844;
  assign or_1844 = (((patches_column_s14_q == 5'ha) | of_row) | equal_1816) | equal_1814;
  // hls/stages/patches.hpp:472
  logic and_1849;
  assign and_1849 = (~(patches_code_row_s14_q[4:2] == 3'h0)) & (~(patches_column_s14_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:172
  logic and_1863;
  assign and_1863 = (~(equal_1713_s14_q | (~and_1849))) & (~patches_column_s14_q[4]);
  // hls/stages/agreement.hpp:203
  logic [7:0] select_1887;
  assign select_1887 = so_s14_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1026
  logic or_1890;
  assign or_1890 = select_1887[7] | (~({select_1887[5], select_1887[3], select_1887[1]} == 3'h0));
  // hls/stages/agreement.hpp:1034
  logic or_1902;
  assign or_1902 = (~sum_1900_s14_q) | equal_1701_s14_q;
  // hls/stages/agreement.hpp:256
  logic textured;
  assign textured = inside_v_s14_q & (or_545_s14_q & (not_553_s14_q & and_1507_s14_q));
  // hls/stages/agreement.hpp:1009
  logic [7:0] select_1985;
  assign select_1985 = inside_v_s14_q ? (sum_1900_s14_q ? select_1887 : {select_1887[6:0], 1'b0}) : select_1887;
  // hls/stages/agreement.hpp:1026
  logic or_1988;
  assign or_1988 = select_1985[7] | (~({select_1985[5], select_1985[3], select_1985[1]} == 3'h0));
  // hls/stages/agreement.hpp:270
  logic select_2097;
  assign select_2097 = sample_pair_whole_s14_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:233
  logic [7:0] select_2417;
  assign select_2417 = slot_s14_q[0] ? 8'h0 : sum_921_s14_q;
  // hls/stages/agreement.hpp:743
  logic less_2418;
  assign less_2418 = select_2417 < select_1421;
  // hls/stages/agreement.hpp:780
  logic less_2424;
  assign less_2424 = $signed(run_shift_s14_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2426;
  assign less_2426 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s14_q);
  // hls/stages/agreement.hpp:971
  logic [7:0] difference_2524;
  assign difference_2524 = best_left_rdata_s14_q[16:9] - lower_s14_q;
  // hls/stages/agreement.hpp:780
  logic [10:0] select_2565;
  assign select_2565 = equal_1489_s14_q ? registration_expected_q : (so_s14_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2580_s14_q[7]}}, select_2580_s14_q} - {sum_1639_s14_q[9], sum_1639_s14_q, sum_1635_s14_q};
  // hls/stages/patches.hpp:353
  logic not_2824;
  assign not_2824 = ~select_1615[1];
  // hls/stages/agreement.hpp:270
  logic [1:0] select_2826;
  assign select_2826 = sample_pair_whole_s14_q ? (equal_1616 ? select_1615 : {not_2824, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:184
  logic [4:0] select_3321;
  assign select_3321 = equal_1710_s14_q ? patches_down_by_s14_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3366;
  assign select_3366 = and_3365_s14_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s14_q} - {1'b0, select_3366};
  // hls/stages/division.hpp:34
  logic [7:0] sum_3693;
  assign sum_3693 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_3702;
  assign select_3702 = equal_1489_s14_q ? select_1887 : (so_s14_q ? (ends_cell_s14_q ? select_1985 : select_1887) : 8'h1);
  // hls/stages/agreement.hpp:454
  logic [8:0] select_3716;
  assign select_3716 = equal_585_s14_q ? {difference_3714[7], difference_3714} : (less_3692_s14_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:514
  logic [8:0] select_3718;
  assign select_3718 = and_524_s14_q ? (equal_2308_s14_q ? select_3716 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:454
  logic [7:0] select_3720;
  assign select_3720 = equal_585_s14_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:514
  logic [7:0] select_3722;
  assign select_3722 = and_524_s14_q ? (equal_2308_s14_q ? select_3720 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3724;
  assign select_3724 = sum_3693[7] ? {1'b1, sum_3693[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s14_q;
  logic census_memory_re;
  assign census_memory_re = s14_en & and_524_s14_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_of_skin_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      chosen_score_q <= 8'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      shift_allowed_q <= 1'b0;
      registration_expected_q <= 11'h0;
      patches_band_q <= 5'h0;
      patches_fetch_q <= 2'h0;
      patches_summed_down_by_q <= 5'h0;
      patches_read_at_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
    end else if (s14_en) begin
      sample_of_skin_q <= mask_s14_q;
      averager_running_mask_q <= sample_pair_whole_s14_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2097;
      chosen_score_q <= less_2418 ? select_1421 : select_2417;
      chosen_place_q <= less_2418 ? {select_1429, not_1428} : 3'h2;
      before_0_q <= select_2417;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2424) & (~less_2426);
      registration_expected_q <= select_2565;
      patches_band_q <= sample_pair_whole_s14_q ? select_1721 : patches_band_q;
      patches_fetch_q <= select_2826;
      patches_summed_down_by_q <= equal_1708_s14_q ? patches_summed_down_by_q : select_3321;
      patches_read_at_q <= equal_1708_s14_q ? select_3344_s14_q : patches_read_at_q;
      patches_peak_row_q <= equal_1708_s14_q ? select_3366 : patches_peak_row_q;
      region_columns_q <= select_3702;
      region_down_rest_q <= select_3718;
      region_down_back_q <= select_3722;
      region_down_next_q <= select_3724;
    end
  end

  logic [7:0] pixel_0_s15_q;
  logic [7:0] pixel_1_s15_q;
  logic saturated_s15_q;
  logic marks_first_s15_q;
  logic marks_last_s15_q;
  logic [7:0] sample_pair_pixel_0_s15_q;
  logic [7:0] sample_pair_pixel_1_s15_q;
  logic sample_pair_whole_s15_q;
  logic sample_present_s15_q;
  logic [5:0] run_shift_s15_q;
  logic [7:0] x_s15_q;
  logic age_s15_q;
  logic [2:0] slot_s15_q;
  logic ends_cell_s15_q;
  logic lower_half_s15_q;
  logic [7:0] before_0_s15_q;
  logic [7:0] before_1_s15_q;
  logic [7:0] before_2_s15_q;
  logic shift_not_right_s15_q;
  logic [4:0] patches_choosing_band_s15_q;
  logic patches_lower_s15_q;
  logic patches_second_s15_q;
  logic [4:0] patches_code_row_s15_q;
  logic [4:0] patches_along_s15_q;
  logic [3:0] patches_match_row_s15_q;
  logic patches_summed_last_s15_q;
  logic [4:0] patches_summed_down_by_s15_q;
  logic [9:0] patches_read_row_differing_s15_q;
  logic patches_read_first_s15_q;
  logic [3:0] select_485_s15_q;
  logic [6:0] select_488_s15_q;
  logic [8:0] select_492_s15_q;
  logic and_498_s15_q;
  logic and_499_s15_q;
  logic [13:0] sum_506_s15_q;
  logic [13:0] sum_510_s15_q;
  logic and_514_s15_q;
  logic and_518_s15_q;
  logic [6:0] column_s15_q;
  logic and_522_s15_q;
  logic and_524_s15_q;
  logic equal_527_s15_q;
  logic so_s15_q;
  logic equal_544_s15_q;
  logic or_545_s15_q;
  logic not_553_s15_q;
  logic equal_585_s15_q;
  logic [6:0] x_s15_2_q;
  logic [32:0] best_left_rdata_s15_q;
  logic select_671_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1431_s15_q;
  logic [6:0] of_near_s15_q;
  logic [6:0] select_1461_s15_q;
  logic [5:0] select_1463_s15_q;
  logic [7:0] select_1466_s15_q;
  logic [7:0] select_1469_s15_q;
  logic and_1471_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1480_s15_q;
  logic or_1486_s15_q;
  logic equal_1489_s15_q;
  logic not_1490_s15_q;
  logic inside_v_s15_q;
  logic and_1492_s15_q;
  logic and_1494_s15_q;
  logic [1:0] shown_right_rdata_s15_q;
  logic [6:0] select_1498_s15_q;
  logic and_1516_s15_q;
  logic and_1521_s15_q;
  logic equal_1530_s15_q;
  logic all_s15_q;
  logic equal_1544_s15_q;
  logic equal_1546_s15_q;
  logic equal_1548_s15_q;
  logic equal_1550_s15_q;
  logic equal_1552_s15_q;
  logic and_1557_s15_q;
  logic right_2_s15_q;
  logic and_1598_s15_q;
  logic [5:0] select_1614_s15_q;
  logic select_1615_s15_q;
  logic equal_1616_s15_q;
  logic and_1624_s15_q;
  logic less_1625_s15_q;
  logic equal_1626_s15_q;
  logic expected_s15_q;
  logic [10:0] sum_1641_s15_q;
  logic equal_1649_s15_q;
  logic and_1659_s15_q;
  logic [5:0] select_1674_s15_q;
  logic [7:0] select_1699_s15_q;
  logic and_1706_s15_q;
  logic and_1707_s15_q;
  logic equal_1708_s15_q;
  logic not_1709_s15_q;
  logic equal_1710_s15_q;
  logic not_1711_s15_q;
  logic equal_1713_s15_q;
  logic or_1714_s15_q;
  logic and_1723_s15_q;
  logic [4:0] select_1738_s15_q;
  logic select_1744_s15_q;
  logic [3:0] select_1783_s15_q;
  logic patches_columns_above_rdata_s15_q;
  logic [7:0] pixel_2_s15_q;
  logic less_1799_s15_q;
  logic new_row_s15_q;
  logic select_1805_s15_q;
  logic not_1806_s15_q;
  logic [4:0] select_1811_s15_q;
  logic or_1812_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [10:0] down_2_s15_q;
  logic sum_1833_s15_q;
  logic [9:0] sum_1834_s15_q;
  logic and_1852_s15_q;
  logic and_1863_s15_q;
  logic and_1866_s15_q;
  logic less_1869_s15_q;
  logic equal_1870_s15_q;
  logic not_1871_s15_q;
  logic equal_1872_s15_q;
  logic not_1873_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic or_1890_s15_q;
  logic or_1893_s15_q;
  logic or_1896_s15_q;
  logic and_1905_s15_q;
  logic textured_s15_q;
  logic and_1921_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic and_1971_s15_q;
  logic and_1973_s15_q;
  logic or_1988_s15_q;
  logic or_1991_s15_q;
  logic or_1994_s15_q;
  logic and_2005_s15_q;
  logic and_2021_s15_q;
  logic and_2044_s15_q;
  logic equal_2184_s15_q;
  logic equal_2308_s15_q;
  logic and_2435_s15_q;
  logic and_2459_s15_q;
  logic equal_2520_s15_q;
  logic [5:0] difference_2524_s15_q;
  logic [7:0] sum_2526_s15_q;
  logic [11:0] select_2583_s15_q;
  logic and_2808_s15_q;
  logic less_2935_s15_q;
  logic equal_3362_s15_q;
  logic [4:0] select_3366_s15_q;
  logic [5:0] away_s15_q;
  logic equal_3368_s15_q;
  logic equal_3377_s15_q;
  logic [14:0] select_3397_s15_q;
  logic less_3692_s15_q;
  logic sum_3693_s15_q;
  logic select_3735_s15_q;
  logic equal_3746_s15_q;
  logic equal_3784_s15_q;
  logic and_3900_s15_q;
  logic equal_3910_s15_q;
  always_ff @(posedge clk_i) begin
    if (s14_en) begin
      pixel_0_s15_q <= sample_pair_pixel_0_q;
      pixel_1_s15_q <= sample_pair_pixel_1_q;
      saturated_s15_q <= saturated_s14_q;
      marks_first_s15_q <= marks_first_s14_q;
      marks_last_s15_q <= marks_last_s14_q;
      sample_pair_pixel_0_s15_q <= sample_pair_pixel_0_s14_q;
      sample_pair_pixel_1_s15_q <= sample_pair_pixel_1_s14_q;
      sample_pair_whole_s15_q <= sample_pair_whole_s14_q;
      sample_present_s15_q <= sample_present_s14_q;
      run_shift_s15_q <= run_shift_s14_q;
      x_s15_q <= x_s14_q;
      age_s15_q <= age_s14_q;
      slot_s15_q <= slot_s14_q;
      ends_cell_s15_q <= ends_cell_s14_q;
      lower_half_s15_q <= lower_half_s14_q;
      before_0_s15_q <= before_0_q;
      before_1_s15_q <= before_1_q;
      before_2_s15_q <= before_2_q;
      shift_not_right_s15_q <= shift_not_right_s14_q;
      patches_choosing_band_s15_q <= patches_choosing_band_s14_q;
      patches_lower_s15_q <= patches_lower_s14_q;
      patches_second_s15_q <= patches_second_s14_q;
      patches_code_row_s15_q <= patches_code_row_s14_q;
      patches_along_s15_q <= patches_along_s14_q;
      patches_match_row_s15_q <= patches_match_row_s14_q;
      patches_summed_last_s15_q <= patches_summed_last_s14_q;
      patches_summed_down_by_s15_q <= patches_summed_down_by_q;
      patches_read_row_differing_s15_q <= patches_read_row_differing_s14_q;
      patches_read_first_s15_q <= patches_read_first_s14_q;
      select_485_s15_q <= select_485_s14_q;
      select_488_s15_q <= select_488_s14_q;
      select_492_s15_q <= select_492_s14_q;
      and_498_s15_q <= and_498_s14_q;
      and_499_s15_q <= and_499_s14_q;
      sum_506_s15_q <= sum_506;
      sum_510_s15_q <= sum_510;
      and_514_s15_q <= whole & (averager_memory_rdata_s14_q[28] | equal_504_s14_q);
      and_518_s15_q <= and_518;
      column_s15_q <= column_s14_q;
      and_522_s15_q <= and_522_s14_q;
      and_524_s15_q <= and_524_s14_q;
      equal_527_s15_q <= select_485_s14_q == 4'h3;
      so_s15_q <= so_s14_q;
      equal_544_s15_q <= equal_544_s14_q;
      or_545_s15_q <= or_545_s14_q;
      not_553_s15_q <= not_553_s14_q;
      equal_585_s15_q <= equal_585_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q[32:0];
      select_671_s15_q <= select_671_s14_q;
      of_best_s15_q <= of_best;
      select_1431_s15_q <= select_1431;
      of_near_s15_q <= of_near;
      select_1461_s15_q <= less_1460 ? of_near : best_left_rdata_s14_q[39:33];
      select_1463_s15_q <= less_1460 ? run_shift_s14_q : best_left_rdata_s14_q[45:40];
      select_1466_s15_q <= select_1466_s14_q;
      select_1469_s15_q <= select_1469_s14_q;
      and_1471_s15_q <= and_1471_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1480_s15_q <= select_1480_s14_q;
      or_1486_s15_q <= select_1480_s14_q | (best_right_rdata_s14_q[21:15] < of_near);
      equal_1489_s15_q <= equal_1489_s14_q;
      not_1490_s15_q <= not_1490_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      and_1492_s15_q <= and_1492_s14_q;
      and_1494_s15_q <= and_1494_s14_q;
      shown_right_rdata_s15_q <= shown_right_rdata_q;
      select_1498_s15_q <= select_1498_s14_q;
      and_1516_s15_q <= and_1516;
      and_1521_s15_q <= and_1516 & or_1520_s14_q;
      equal_1530_s15_q <= x_s14_q[6:4] == 3'h7;
      all_s15_q <= all;
      equal_1544_s15_q <= equal_1544;
      equal_1546_s15_q <= equal_1546;
      equal_1548_s15_q <= equal_1548;
      equal_1550_s15_q <= equal_1550;
      equal_1552_s15_q <= equal_1552;
      and_1557_s15_q <= (~equal_1544) & and_1556;
      right_2_s15_q <= right_2_s14_q;
      and_1598_s15_q <= and_1598_s14_q;
      select_1614_s15_q <= select_1614;
      select_1615_s15_q <= select_1615[1];
      equal_1616_s15_q <= equal_1616;
      and_1624_s15_q <= and_1624_s14_q;
      less_1625_s15_q <= less_1625_s14_q;
      equal_1626_s15_q <= equal_1626_s14_q;
      expected_s15_q <= expected[0];
      sum_1641_s15_q <= {expected[10], expected[10:1]} + 11'h5;
      equal_1649_s15_q <= equal_1649_s14_q;
      and_1659_s15_q <= and_1659_s14_q;
      select_1674_s15_q <= select_1674_s14_q;
      select_1699_s15_q <= select_1699_s14_q;
      and_1706_s15_q <= and_1706_s14_q;
      and_1707_s15_q <= and_1707_s14_q;
      equal_1708_s15_q <= equal_1708_s14_q;
      not_1709_s15_q <= not_1709_s14_q;
      equal_1710_s15_q <= equal_1710_s14_q;
      not_1711_s15_q <= not_1711_s14_q;
      equal_1713_s15_q <= equal_1713_s14_q;
      or_1714_s15_q <= or_1714_s14_q;
      and_1723_s15_q <= and_1707_s14_q & equal_1722;
      select_1738_s15_q <= select_1738_s14_q;
      select_1744_s15_q <= select_1744_s14_q;
      select_1783_s15_q <= select_1783_s14_q;
      patches_columns_above_rdata_s15_q <= patches_columns_above_rdata_s14_q[8];
      pixel_2_s15_q <= pixel_2_s14_q;
      less_1799_s15_q <= less_1799;
      new_row_s15_q <= new_row;
      select_1805_s15_q <= select_1805;
      not_1806_s15_q <= ~or_1800;
      select_1811_s15_q <= select_1811;
      or_1812_s15_q <= equal_1712_s14_q | equal_1710_s14_q;
      of_row_2_s15_q <= of_row_2;
      down_2_s15_q <= down_2;
      sum_1833_s15_q <= sum_1833_s14_q[0];
      sum_1834_s15_q <= sum_1834;
      and_1852_s15_q <= or_1714_s14_q & (or_1844 & (equal_1713_s14_q & and_1849));
      and_1863_s15_q <= and_1863;
      and_1866_s15_q <= or_1714_s14_q & (and_1863 & (patches_column_s14_q == 5'hf));
      less_1869_s15_q <= less_1869_s14_q;
      equal_1870_s15_q <= equal_1870_s14_q;
      not_1871_s15_q <= not_1871_s14_q;
      equal_1872_s15_q <= equal_1872_s14_q;
      not_1873_s15_q <= not_1873_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      or_1890_s15_q <= or_1890;
      or_1893_s15_q <= select_1887[7] | (~({select_1887[6], select_1887[3:2]} == 3'h0));
      or_1896_s15_q <= select_1887[7] | (~(select_1887[6:4] == 3'h0));
      and_1905_s15_q <= so_s14_q & (ends_cell_s14_q & (inside_v_s14_q & or_1902));
      textured_s15_q <= textured;
      and_1921_s15_q <= and_1921_s14_q;
      seen_columns_rdata_s15_q <= {seen_columns_rdata_s14_q[13:7], seen_columns_rdata_s14_q[5:0]};
      and_1971_s15_q <= seen_columns_rdata_s14_q[14] & inside_v_s14_q;
      and_1973_s15_q <= seen_columns_rdata_s14_q[5] & inside_v_s14_q;
      or_1988_s15_q <= or_1988;
      or_1991_s15_q <= select_1985[7] | (~({select_1985[6], select_1985[3:2]} == 3'h0));
      or_1994_s15_q <= select_1985[7] | (~(select_1985[6:4] == 3'h0));
      and_2005_s15_q <= seen_columns_rdata_s14_q[16] & inside_v_s14_q;
      and_2021_s15_q <= seen_columns_rdata_s14_q[17] & inside_v_s14_q;
      and_2044_s15_q <= and_2044_s14_q;
      equal_2184_s15_q <= equal_2184_s14_q;
      equal_2308_s15_q <= equal_2308_s14_q;
      and_2435_s15_q <= and_2435_s14_q;
      and_2459_s15_q <= seen_columns_rdata_s14_q[15] & inside_v_s14_q;
      equal_2520_s15_q <= equal_2520_s14_q;
      difference_2524_s15_q <= difference_2524[7:2];
      sum_2526_s15_q <= sum_2526_s14_q;
      select_2583_s15_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_2808_s15_q <= and_2808_s14_q;
      less_2935_s15_q <= 4'he < patches_column_s14_q[4:1];
      equal_3362_s15_q <= equal_3362_s14_q;
      select_3366_s15_q <= select_3366;
      away_s15_q <= away;
      equal_3368_s15_q <= away == 6'h3f;
      equal_3377_s15_q <= away == 6'h1;
      select_3397_s15_q <= select_3397_s14_q;
      less_3692_s15_q <= less_3692_s14_q;
      sum_3693_s15_q <= sum_3693[7];
      select_3735_s15_q <= sum_1900_s14_q ? (equal_1701_s14_q & or_1902) : or_1902;
      equal_3746_s15_q <= x_s14_q[6:3] == 4'h7;
      equal_3784_s15_q <= x_s14_q[6:3] == 4'h6;
      and_3900_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      equal_3910_s15_q <= equal_3910_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic region_fresh_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_498_s15_q ? sum_506_s15_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_527_s15_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_498_s15_q ? sum_510_s15_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_527_s15_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_535;
  assign and_535 = and_498_s15_q & and_514_s15_q;
  // hls/stages/census.hpp:126
  logic select_537;
  assign select_537 = equal_527_s15_q ? and_535 : (averager_mask_q & and_535);
  // hls/stages/agreement.hpp:270
  logic whole_2;
  assign whole_2 = sample_pair_whole_s15_q & select_537;
  // hls/stages/census.hpp:206
  logic and_539;
  assign and_539 = and_498_s15_q & and_518_s15_q;
  // hls/stages/census.hpp:126
  logic select_541;
  assign select_541 = equal_527_s15_q ? and_539 : (averager_of_skin_q & and_539);
  // hls/stages/agreement.hpp:802
  logic equal_1434;
  assign equal_1434 = select_1431_s15_q == 3'h1;
  logic or_1437;
  assign or_1437 = equal_1434 | (~(select_1431_s15_q == 3'h2));
  logic [7:0] select_1439;
  assign select_1439 = or_1437 ? before_0_s15_q : before_1_s15_q;
  logic [7:0] select_1440;
  assign select_1440 = equal_1434 ? (or_1437 ? before_1_q : {7'h0, shift_not_right_s15_q}) : select_1439;
  // hls/stages/agreement.hpp:803
  logic [7:0] select_1443;
  assign select_1443 = equal_1434 ? select_1439 : (or_1437 ? before_2_q : before_2_s15_q);
  // hls/stages/agreement.hpp:816
  logic or_1482;
  assign or_1482 = select_1480_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:147
  logic and_1523;
  assign and_1523 = or_545_s15_q & (not_553_s15_q & and_1521_s15_q);
  logic and_1526;
  assign and_1526 = or_545_s15_q & (not_553_s15_q & and_1516_s15_q);
  // hls/stages/agreement.hpp:780
  logic and_1529;
  assign and_1529 = not_1490_s15_q & (so_s15_q ? and_1492_s15_q : (equal_544_s15_q & and_1526));
  // hls/stages/agreement.hpp:1150
  logic [1:0] quarter;
  assign quarter = x_s15_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1105
  logic [1:0] select_1533;
  assign select_1533 = x_s15_q[4] ? {x_s15_q[3], x_s15_q[0]} : {x_s15_q[0], x_s15_q[3]};
  // hls/stages/agreement.hpp:1118
  logic [3:0] select_1535;
  assign select_1535 = equal_1530_s15_q ? {2'h0, quarter} : (all_s15_q ? {1'b0, x_s15_q[2:0]} : {x_s15_q[2:1], select_1533});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1536;
  assign sum_1536 = slot_s15_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:780
  logic [3:0] select_1537;
  assign select_1537 = equal_1489_s15_q ? select_1535 : {sum_1536, lower_half_s15_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1538;
  assign equal_1538 = x_s15_q[5:0] == 6'h3f;
  logic equal_1540;
  assign equal_1540 = x_s15_q[5:0] == 6'h3e;
  logic equal_1542;
  assign equal_1542 = x_s15_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1150
  logic and_1560;
  assign and_1560 = (~equal_1538) & ((~equal_1540) & ((~equal_1542) & and_1557_s15_q));
  // hls/stages/agreement.hpp:1105
  logic less_1561;
  assign less_1561 = x_s15_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s15_q ? {1'b0, x_s15_q[2]} : x_s15_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1565;
  assign or_1565 = (kind == 2'h3) | (x_s15_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s15_q ? (right_2_s15_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1576;
  assign sum_1576 = {2'h0, slot_s15_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1582;
  assign not_1582 = ~lower_half_s15_q;
  logic [3:0] select_1583;
  assign select_1583 = registration_of_right_q ? {lower_half_s15_q, 1'b0, not_1582, 1'b0} : {1'b0, lower_half_s15_q, 1'b0, not_1582};
  // hls/stages/patches.hpp:98
  logic less_1642;
  assign less_1642 = {{4{sum_1641_s15_q[10]}}, sum_1641_s15_q, expected_s15_q} < 16'h15;
  // hls/stages/patches.hpp:466
  logic [11:0] sum_1824;
  assign sum_1824 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1825;
  assign sum_1825 = {{4{down_2_s15_q[10]}}, down_2_s15_q[10:2]} + {sum_1824[11], sum_1824};
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_1834_s15_q, sum_1833_s15_q, patches_columns_above_rdata_s15_q} + {4'h0, pixel_2_s15_q};
  // hls/stages/agreement.hpp:780
  logic [5:0] select_1897;
  assign select_1897 = equal_1489_s15_q ? x_s15_q[5:0] : {region_row_q, or_1896_s15_q, or_1893_s15_q, or_1890_s15_q};
  // hls/stages/agreement.hpp:1104
  logic not_1898;
  assign not_1898 = ~equal_1530_s15_q;
  // hls/stages/agreement.hpp:256
  logic explained;
  assign explained = inside_v_s15_q & and_1526;
  // hls/stages/agreement.hpp:147
  logic and_1923;
  assign and_1923 = or_545_s15_q & (not_553_s15_q & and_1921_s15_q);
  // hls/stages/agreement.hpp:993
  logic select_1933;
  assign select_1933 = slot_s15_q[2] ? shown_shown_q : and_1526;
  // hls/stages/agreement.hpp:256
  logic shown;
  assign shown = inside_v_s15_q & (shown_right_rdata_s15_q[0] | select_1933);
  // hls/stages/agreement.hpp:993
  logic select_1936;
  assign select_1936 = slot_s15_q[2] ? shown_nearer_q : and_1523;
  // hls/stages/agreement.hpp:256
  logic near;
  assign near = inside_v_s15_q & (select_1933 ? select_1936 : shown_right_rdata_s15_q[1]);
  // hls/stages/agreement.hpp:270
  logic [10:0] select_2076;
  assign select_2076 = sample_pair_whole_s15_q ? (and_522_s15_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2078;
  assign select_2078 = sample_pair_whole_s15_q ? (and_522_s15_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2099;
  assign select_2099 = sample_pair_whole_s15_q ? (and_522_s15_q ? select_537 : averager_mask_q) : averager_mask_q;
  logic select_2101;
  assign select_2101 = sample_pair_whole_s15_q ? (and_522_s15_q ? select_541 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:780
  logic and_2439;
  assign and_2439 = not_1490_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_2435_s15_q)));
  // hls/stages/agreement.hpp:1081
  logic not_2458;
  assign not_2458 = ~(x_s15_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1009
  logic and_2461;
  assign and_2461 = seen_columns_rdata_s15_q[6] & inside_v_s15_q;
  logic and_2462;
  assign and_2462 = seen_columns_rdata_s15_q[2] & inside_v_s15_q;
  // hls/stages/agreement.hpp:780
  logic and_2500;
  assign and_2500 = so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & (and_2435_s15_q & and_1923)));
  // hls/stages/agreement.hpp:1086
  logic and_2505;
  assign and_2505 = not_2458 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:147
  logic and_2529;
  assign and_2529 = ((and_1921_s15_q & and_1516_s15_q) & equal_2520_s15_q) & (~({2'h0, difference_2524_s15_q} < sum_2526_s15_q));
  // hls/stages/registration.hpp:108
  logic equal_2566;
  assign equal_2566 = slot_s15_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2583_s15_q[11:7])) ? 12'h7f : select_2583_s15_q;
  // hls/stages/agreement.hpp:780
  logic select_2627;
  assign select_2627 = so_s15_q ? (equal_2566 ? right_2_s15_q : registration_of_right_q) : registration_of_right_q;
  logic select_2630;
  assign select_2630 = so_s15_q ? (equal_1626_s15_q ? inside_v_s15_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1105
  logic [1:0] quarter_2;
  assign quarter_2 = all_s15_q ? x_s15_q[1:0] : select_1533;
  // hls/stages/patches.hpp:184
  logic [10:0] select_2913;
  assign select_2913 = equal_1710_s15_q ? patches_down_values_0_q : (or_1714_s15_q ? down_2_s15_q : patches_down_values_0_q);
  logic [10:0] select_2915;
  assign select_2915 = or_1714_s15_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_2917;
  assign select_2917 = equal_1708_s15_q ? patches_down_values_1_q : (equal_1710_s15_q ? patches_down_values_1_q : select_2915);
  // hls/stages/patches.hpp:551
  logic and_3370;
  assign and_3370 = less_1869_s15_q & (equal_3362_s15_q & equal_3368_s15_q);
  // hls/stages/patches.hpp:555
  logic select_3373;
  assign select_3373 = equal_1872_s15_q ? (less_1869_s15_q ? (not_1873_s15_q & and_3370) : and_3370) : and_3370;
  // hls/stages/patches.hpp:551
  logic and_3379;
  assign and_3379 = less_1869_s15_q & (equal_3362_s15_q & equal_3377_s15_q);
  // hls/stages/patches.hpp:555
  logic select_3382;
  assign select_3382 = equal_1872_s15_q ? (less_1869_s15_q ? (not_1873_s15_q & and_3379) : and_3379) : and_3379;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3386;
  assign sum_3386 = {away_s15_q[5], away_s15_q} + 7'h7d;
  // hls/stages/agreement.hpp:780
  logic select_3689;
  assign select_3689 = equal_1489_s15_q ? shown_shown_q : (so_s15_q ? select_1933 : shown_shown_q);
  logic select_3691;
  assign select_3691 = equal_1489_s15_q ? shown_nearer_q : (so_s15_q ? select_1936 : shown_nearer_q);
  // hls/stages/agreement.hpp:454
  logic [2:0] select_3695;
  assign select_3695 = less_3692_s15_q ? (sum_3693_s15_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3697;
  assign select_3697 = equal_2308_s15_q ? (equal_585_s15_q ? 3'h0 : select_3695) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3693_s15_q;
  // hls/stages/agreement.hpp:454
  logic select_3728;
  assign select_3728 = equal_2308_s15_q ? (equal_585_s15_q | (less_3692_s15_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1189
  logic equal_3765;
  assign equal_3765 = x_s15_q[6:3] == 4'ha;
  logic equal_3769;
  assign equal_3769 = x_s15_q[6:3] == 4'h9;
  logic equal_3770;
  assign equal_3770 = x_s15_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1101
  logic [7:0] select_3786;
  assign select_3786 = equal_3746_s15_q ? cfg_unproven_limit_i : (equal_3784_s15_q ? cfg_explained_limit_i : cfg_regions_limit_i);
  logic [7:0] select_3788;
  assign select_3788 = equal_3769 ? cfg_hidden_limit_i : (equal_3770 ? cfg_unproven_skin_limit_i : select_3786);
  // hls/stages/agreement.hpp:780
  logic select_3898;
  assign select_3898 = so_s15_q ? (ends_cell_s15_q ? and_1973_s15_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3902;
  assign select_3902 = so_s15_q ? (ends_cell_s15_q ? and_3900_s15_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_3904;
  assign select_3904 = ends_cell_s15_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3906;
  assign select_3906 = equal_1489_s15_q ? centres_values_1_textured_q : (so_s15_q ? select_3904 : centres_values_1_textured_q);
  logic select_3907;
  assign select_3907 = ends_cell_s15_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3909;
  assign select_3909 = equal_1489_s15_q ? centres_values_1_of_skin_q : (so_s15_q ? select_3907 : centres_values_1_of_skin_q);

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:762; read in stage 15, written in stage 17: 15 < 17 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1614_s15_q;
  logic patches_choices_re;
  assign patches_choices_re = s15_en & (sample_pair_whole_s15_q & (~equal_1616_s15_q));
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:791; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1811_s15_q, not_1806_s15_q, select_1805_s15_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s15_en & or_1812_s15_q;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:792; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_s15_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s15_en & (not_1709_s15_q & (new_row_s15_q & equal_1710_s15_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1364; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
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
  assign regions_re = s15_en & (equal_1489_s15_q ? (x_s15_q[6] & not_1898) : and_1905_s15_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_492_s15_q;
  logic averager_memory_we;
  assign averager_memory_we = s15_en & and_499_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_518_s15_q, and_514_s15_q, sum_510_s15_q, sum_506_s15_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s13_sim;
  logic averager_memory_re_s13_sim;
  logic [8:0] averager_memory_raddr_s14_sim;
  logic averager_memory_re_s14_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s13_sim <= 1'b0;
      averager_memory_re_s14_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s13_sim <= averager_memory_re;
      averager_memory_raddr_s13_sim <= averager_memory_raddr;
      averager_memory_re_s14_sim <= averager_memory_re_s13_sim;
      averager_memory_raddr_s14_sim <= averager_memory_raddr_s13_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s13_sim && averager_memory_raddr_s13_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s14_sim && averager_memory_raddr_s14_sim == averager_memory_waddr) begin
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
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s15_en) begin
      averager_mask_q <= select_2099;
      averager_of_skin_q <= select_2101;
      registration_of_right_q <= equal_1489_s15_q ? registration_of_right_q : select_2627;
      registration_was_inside_q <= equal_1489_s15_q ? registration_was_inside_q : select_2630;
      patches_down_values_0_q <= equal_1708_s15_q ? patches_down_values_0_q : select_2913;
      patches_down_values_1_q <= select_2917;
      shown_shown_q <= select_3689;
      shown_nearer_q <= select_3691;
      region_row_q <= and_524_s15_q ? select_3697 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_524_s15_q ? select_3728 : region_fresh_q;
      centres_values_0_textured_q <= equal_1489_s15_q ? centres_values_0_textured_q : select_3898;
      centres_values_0_of_skin_q <= equal_1489_s15_q ? centres_values_0_of_skin_q : select_3902;
      centres_values_1_textured_q <= select_3906;
      centres_values_1_of_skin_q <= select_3909;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s15_en) begin
      averager_total_0_q <= select_2076;
      averager_total_1_q <= select_2078;
    end
  end

  logic [7:0] pixel_0_s16_q;
  logic [7:0] pixel_1_s16_q;
  logic saturated_s16_q;
  logic mask_s16_q;
  logic marks_first_s16_q;
  logic marks_last_s16_q;
  logic [7:0] sample_pair_pixel_0_s16_q;
  logic [7:0] sample_pair_pixel_1_s16_q;
  logic sample_pair_whole_s16_q;
  logic sample_present_s16_q;
  logic [5:0] run_shift_s16_q;
  logic [7:0] x_s16_q;
  logic age_s16_q;
  logic [2:0] slot_s16_q;
  logic ends_cell_s16_q;
  logic lower_half_s16_q;
  logic registration_of_right_s16_q;
  logic [4:0] patches_choosing_band_s16_q;
  logic patches_lower_s16_q;
  logic patches_second_s16_q;
  logic [4:0] patches_code_row_s16_q;
  logic [10:0] patches_down_values_1_s16_q;
  logic [4:0] patches_along_s16_q;
  logic patches_summed_last_s16_q;
  logic [4:0] patches_summed_down_by_s16_q;
  logic [9:0] patches_read_row_differing_s16_q;
  logic patches_read_first_s16_q;
  logic [2:0] region_row_s16_q;
  logic region_fresh_s16_q;
  logic centres_values_1_textured_s16_q;
  logic centres_values_1_of_skin_s16_q;
  logic [3:0] select_485_s16_q;
  logic [6:0] select_488_s16_q;
  logic [6:0] column_s16_q;
  logic and_522_s16_q;
  logic and_524_s16_q;
  logic [77:0] census_memory_rdata_s16_q;
  logic [8:0] grey_s16_q;
  logic equal_527_s16_q;
  logic [8:0] select_530_s16_q;
  logic [8:0] grey_2_s16_q;
  logic [8:0] select_534_s16_q;
  logic whole_2_s16_q;
  logic and_542_s16_q;
  logic so_s16_q;
  logic equal_585_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1426_s16_q;
  logic [2:0] select_1431_s16_q;
  logic [7:0] select_1440_s16_q;
  logic [7:0] select_1443_s16_q;
  logic [6:0] select_1462_s16_q;
  logic [5:0] select_1464_s16_q;
  logic [7:0] select_1467_s16_q;
  logic [7:0] select_1470_s16_q;
  logic and_1471_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1482_s16_q;
  logic [6:0] select_1487_s16_q;
  logic [6:0] select_1488_s16_q;
  logic equal_1489_s16_q;
  logic not_1490_s16_q;
  logic inside_v_s16_q;
  logic and_1494_s16_q;
  logic [6:0] select_1498_s16_q;
  logic and_1523_s16_q;
  logic and_1529_s16_q;
  logic equal_1530_s16_q;
  logic [1:0] quarter_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1536_s16_q;
  logic [3:0] select_1537_s16_q;
  logic equal_1538_s16_q;
  logic equal_1540_s16_q;
  logic equal_1542_s16_q;
  logic equal_1544_s16_q;
  logic equal_1546_s16_q;
  logic equal_1548_s16_q;
  logic equal_1550_s16_q;
  logic equal_1552_s16_q;
  logic less_1561_s16_q;
  logic or_1565_s16_q;
  logic select_1568_s16_q;
  logic and_1578_s16_q;
  logic [3:0] select_1583_s16_q;
  logic and_1598_s16_q;
  logic select_1615_s16_q;
  logic equal_1616_s16_q;
  logic and_1624_s16_q;
  logic equal_1626_s16_q;
  logic equal_1649_s16_q;
  logic and_1660_s16_q;
  logic [5:0] select_1674_s16_q;
  logic [7:0] select_1699_s16_q;
  logic and_1706_s16_q;
  logic and_1707_s16_q;
  logic equal_1708_s16_q;
  logic equal_1710_s16_q;
  logic equal_1713_s16_q;
  logic or_1714_s16_q;
  logic and_1723_s16_q;
  logic [4:0] select_1738_s16_q;
  logic select_1744_s16_q;
  logic [3:0] select_1783_s16_q;
  logic less_1799_s16_q;
  logic new_row_s16_q;
  logic or_1812_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic [1:0] down_2_s16_q;
  logic [12:0] sum_1825_s16_q;
  logic [11:0] smooth_s16_q;
  logic and_1854_s16_q;
  logic and_1863_s16_q;
  logic and_1868_s16_q;
  logic less_1869_s16_q;
  logic equal_1870_s16_q;
  logic not_1871_s16_q;
  logic equal_1872_s16_q;
  logic [9:0] patches_rows_rdata_s16_q;
  logic or_1890_s16_q;
  logic or_1893_s16_q;
  logic or_1896_s16_q;
  logic not_1898_s16_q;
  logic textured_s16_q;
  logic explained_s16_q;
  logic and_1923_s16_q;
  logic and_1930_s16_q;
  logic [12:0] seen_columns_rdata_s16_q;
  logic shown_s16_q;
  logic near_s16_q;
  logic and_1971_s16_q;
  logic and_1973_s16_q;
  logic or_1988_s16_q;
  logic or_1991_s16_q;
  logic or_1994_s16_q;
  logic and_2005_s16_q;
  logic and_2007_s16_q;
  logic and_2008_s16_q;
  logic and_2021_s16_q;
  logic and_2023_s16_q;
  logic and_2024_s16_q;
  logic and_2044_s16_q;
  logic equal_2184_s16_q;
  logic equal_2308_s16_q;
  logic and_2439_s16_q;
  logic not_2458_s16_q;
  logic and_2459_s16_q;
  logic and_2460_s16_q;
  logic [1:0] sum_2464_s16_q;
  logic and_2501_s16_q;
  logic and_2508_s16_q;
  logic and_2532_s16_q;
  logic and_2569_s16_q;
  logic and_2570_s16_q;
  logic [11:0] residual_s16_q;
  logic equal_2632_s16_q;
  logic [3:0] not_2633_s16_q;
  logic [1:0] quarter_2_s16_q;
  logic and_2808_s16_q;
  logic less_2935_s16_q;
  logic equal_3278_s16_q;
  logic [4:0] select_3366_s16_q;
  logic select_3373_s16_q;
  logic select_3382_s16_q;
  logic and_3388_s16_q;
  logic [14:0] select_3397_s16_q;
  logic select_3735_s16_q;
  logic equal_3746_s16_q;
  logic equal_3765_s16_q;
  logic equal_3768_s16_q;
  logic equal_3769_s16_q;
  logic equal_3770_s16_q;
  logic [7:0] select_3789_s16_q;
  logic equal_3910_s16_q;
  always_ff @(posedge clk_i) begin
    if (s15_en) begin
      pixel_0_s16_q <= pixel_0_s15_q;
      pixel_1_s16_q <= pixel_1_s15_q;
      saturated_s16_q <= saturated_s15_q;
      mask_s16_q <= sample_of_skin_q;
      marks_first_s16_q <= marks_first_s15_q;
      marks_last_s16_q <= marks_last_s15_q;
      sample_pair_pixel_0_s16_q <= sample_pair_pixel_0_s15_q;
      sample_pair_pixel_1_s16_q <= sample_pair_pixel_1_s15_q;
      sample_pair_whole_s16_q <= sample_pair_whole_s15_q;
      sample_present_s16_q <= sample_present_s15_q;
      run_shift_s16_q <= run_shift_s15_q;
      x_s16_q <= x_s15_q;
      age_s16_q <= age_s15_q;
      slot_s16_q <= slot_s15_q;
      ends_cell_s16_q <= ends_cell_s15_q;
      lower_half_s16_q <= lower_half_s15_q;
      registration_of_right_s16_q <= registration_of_right_q;
      patches_choosing_band_s16_q <= patches_choosing_band_s15_q;
      patches_lower_s16_q <= patches_lower_s15_q;
      patches_second_s16_q <= patches_second_s15_q;
      patches_code_row_s16_q <= patches_code_row_s15_q;
      patches_down_values_1_s16_q <= patches_down_values_1_q;
      patches_along_s16_q <= patches_along_s15_q;
      patches_summed_last_s16_q <= patches_summed_last_s15_q;
      patches_summed_down_by_s16_q <= patches_summed_down_by_s15_q;
      patches_read_row_differing_s16_q <= patches_read_row_differing_s15_q;
      patches_read_first_s16_q <= patches_read_first_s15_q;
      region_row_s16_q <= region_row_q;
      region_fresh_s16_q <= region_fresh_q;
      centres_values_1_textured_s16_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s16_q <= centres_values_1_of_skin_q;
      select_485_s16_q <= select_485_s15_q;
      select_488_s16_q <= select_488_s15_q;
      column_s16_q <= column_s15_q;
      and_522_s16_q <= and_522_s15_q;
      and_524_s16_q <= and_524_s15_q;
      census_memory_rdata_s16_q <= census_memory_rdata_q;
      grey_s16_q <= grey;
      equal_527_s16_q <= equal_527_s15_q;
      select_530_s16_q <= sample_pair_whole_s15_q ? total[10:2] : 9'h0;
      grey_2_s16_q <= grey_2;
      select_534_s16_q <= sample_pair_whole_s15_q ? total_2[10:2] : 9'h0;
      whole_2_s16_q <= whole_2;
      and_542_s16_q <= sample_pair_whole_s15_q & select_541;
      so_s16_q <= so_s15_q;
      equal_585_s16_q <= equal_585_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      of_best_s16_q <= of_best_s15_q;
      or_1426_s16_q <= select_671_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1431_s16_q <= select_1431_s15_q;
      select_1440_s16_q <= select_1440;
      select_1443_s16_q <= select_1443;
      select_1462_s16_q <= select_671_s15_q ? of_near_s15_q : select_1461_s15_q;
      select_1464_s16_q <= select_671_s15_q ? run_shift_s15_q : select_1463_s15_q;
      select_1467_s16_q <= (run_shift_s15_q == 6'h3f) ? of_best_s15_q : select_1466_s15_q;
      select_1470_s16_q <= (run_shift_s15_q == 6'h1) ? of_best_s15_q : select_1469_s15_q;
      and_1471_s16_q <= and_1471_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1482_s16_q <= or_1482;
      select_1487_s16_q <= or_1486_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1488_s16_q <= or_1486_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1489_s16_q <= equal_1489_s15_q;
      not_1490_s16_q <= not_1490_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      and_1494_s16_q <= and_1494_s15_q;
      select_1498_s16_q <= select_1498_s15_q;
      and_1523_s16_q <= and_1523;
      and_1529_s16_q <= and_1529;
      equal_1530_s16_q <= equal_1530_s15_q;
      quarter_s16_q <= quarter;
      all_s16_q <= all_s15_q;
      sum_1536_s16_q <= sum_1536;
      select_1537_s16_q <= select_1537;
      equal_1538_s16_q <= equal_1538;
      equal_1540_s16_q <= equal_1540;
      equal_1542_s16_q <= equal_1542;
      equal_1544_s16_q <= equal_1544_s15_q;
      equal_1546_s16_q <= equal_1546_s15_q;
      equal_1548_s16_q <= equal_1548_s15_q;
      equal_1550_s16_q <= equal_1550_s15_q;
      equal_1552_s16_q <= equal_1552_s15_q;
      less_1561_s16_q <= less_1561;
      or_1565_s16_q <= or_1565;
      select_1568_s16_q <= equal_1530_s15_q ? and_1560 : (less_1561 & (~or_1565));
      and_1578_s16_q <= half_ends & ({{3{sum_1576[4]}}, sum_1576} < 8'h3);
      select_1583_s16_q <= select_1583;
      and_1598_s16_q <= and_1598_s15_q;
      select_1615_s16_q <= select_1615_s15_q;
      equal_1616_s16_q <= equal_1616_s15_q;
      and_1624_s16_q <= and_1624_s15_q;
      equal_1626_s16_q <= equal_1626_s15_q;
      equal_1649_s16_q <= equal_1649_s15_q;
      and_1660_s16_q <= (less_1625_s15_q & (and_1526 & less_1642)) & and_1659_s15_q;
      select_1674_s16_q <= select_1674_s15_q;
      select_1699_s16_q <= select_1699_s15_q;
      and_1706_s16_q <= and_1706_s15_q;
      and_1707_s16_q <= and_1707_s15_q;
      equal_1708_s16_q <= equal_1708_s15_q;
      equal_1710_s16_q <= equal_1710_s15_q;
      equal_1713_s16_q <= equal_1713_s15_q;
      or_1714_s16_q <= or_1714_s15_q;
      and_1723_s16_q <= and_1723_s15_q;
      select_1738_s16_q <= select_1738_s15_q;
      select_1744_s16_q <= select_1744_s15_q;
      select_1783_s16_q <= select_1783_s15_q;
      less_1799_s16_q <= less_1799_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1812_s16_q <= or_1812_s15_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[1:0];
      sum_1825_s16_q <= sum_1825;
      smooth_s16_q <= smooth;
      and_1854_s16_q <= not_1709_s15_q & (not_1711_s15_q & and_1852_s15_q);
      and_1863_s16_q <= and_1863_s15_q;
      and_1868_s16_q <= not_1709_s15_q & (not_1711_s15_q & and_1866_s15_q);
      less_1869_s16_q <= less_1869_s15_q;
      equal_1870_s16_q <= equal_1870_s15_q;
      not_1871_s16_q <= not_1871_s15_q;
      equal_1872_s16_q <= equal_1872_s15_q;
      patches_rows_rdata_s16_q <= patches_rows_rdata_s15_q;
      or_1890_s16_q <= or_1890_s15_q;
      or_1893_s16_q <= or_1893_s15_q;
      or_1896_s16_q <= or_1896_s15_q;
      not_1898_s16_q <= not_1898;
      textured_s16_q <= textured_s15_q;
      explained_s16_q <= explained;
      and_1923_s16_q <= and_1923;
      and_1930_s16_q <= not_1490_s15_q & and_1905_s15_q;
      seen_columns_rdata_s16_q <= seen_columns_rdata_s15_q;
      shown_s16_q <= shown;
      near_s16_q <= near;
      and_1971_s16_q <= and_1971_s15_q;
      and_1973_s16_q <= and_1973_s15_q;
      or_1988_s16_q <= or_1988_s15_q;
      or_1991_s16_q <= or_1991_s15_q;
      or_1994_s16_q <= or_1994_s15_q;
      and_2005_s16_q <= and_2005_s15_q;
      and_2007_s16_q <= seen_columns_rdata_s15_q[7] & inside_v_s15_q;
      and_2008_s16_q <= seen_columns_rdata_s15_q[3] & inside_v_s15_q;
      and_2021_s16_q <= and_2021_s15_q;
      and_2023_s16_q <= seen_columns_rdata_s15_q[8] & inside_v_s15_q;
      and_2024_s16_q <= seen_columns_rdata_s15_q[4] & inside_v_s15_q;
      and_2044_s16_q <= and_2044_s15_q;
      equal_2184_s16_q <= equal_2184_s15_q;
      equal_2308_s16_q <= equal_2308_s15_q;
      and_2439_s16_q <= and_2439;
      not_2458_s16_q <= not_2458;
      and_2459_s16_q <= and_2459_s15_q;
      and_2460_s16_q <= seen_columns_rdata_s15_q[10] & inside_v_s15_q;
      sum_2464_s16_q <= {1'b0, and_2461} + ({1'b0, explained} + {1'b0, and_2462});
      and_2501_s16_q <= not_1490_s15_q & and_2500;
      and_2508_s16_q <= not_1490_s15_q & (so_s15_q & (ends_cell_s15_q & and_2505));
      and_2532_s16_q <= inside_v_s15_q & (or_545_s15_q & (not_553_s15_q & and_2529));
      and_2569_s16_q <= not_1490_s15_q & (so_s15_q & (half_ends & equal_2566));
      and_2570_s16_q <= and_1526 & less_1625_s15_q;
      residual_s16_q <= residual;
      equal_2632_s16_q <= sum_1536 == 2'h2;
      not_2633_s16_q <= ~select_1583;
      quarter_2_s16_q <= quarter_2;
      and_2808_s16_q <= and_2808_s15_q;
      less_2935_s16_q <= less_2935_s15_q;
      equal_3278_s16_q <= patches_match_row_s15_q == 4'h0;
      select_3366_s16_q <= select_3366_s15_q;
      select_3373_s16_q <= select_3373;
      select_3382_s16_q <= select_3382;
      and_3388_s16_q <= equal_3362_s15_q & ({sum_3386[6], sum_3386} < 8'hfb);
      select_3397_s16_q <= select_3397_s15_q;
      select_3735_s16_q <= select_3735_s15_q;
      equal_3746_s16_q <= equal_3746_s15_q;
      equal_3765_s16_q <= equal_3765;
      equal_3768_s16_q <= x_s15_q[6:3] == 4'hb;
      equal_3769_s16_q <= equal_3769;
      equal_3770_s16_q <= equal_3770;
      select_3789_s16_q <= equal_3765 ? cfg_regions_limit_i : select_3788;
      equal_3910_s16_q <= equal_3910_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
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
  logic [3:0] census_filled_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic [3:0] registration_fresh_q;
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
  logic segment_starts_q;
  // hls/stages/census.hpp:294
  logic less_558;
  assign less_558 = census_memory_rdata_s16_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_559;
  assign less_559 = census_memory_rdata_s16_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_560;
  assign less_560 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_561;
  assign less_561 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_562;
  assign less_562 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_563;
  assign less_563 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_564;
  assign less_564 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_565;
  assign less_565 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_566;
  assign less_566 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_567;
  assign less_567 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_568;
  assign less_568 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_569;
  assign less_569 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_570;
  assign less_570 = census_memory_rdata_s16_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_571;
  assign less_571 = census_memory_rdata_s16_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_572;
  assign less_572 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_573;
  assign less_573 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_574;
  assign less_574 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_575;
  assign less_575 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_576;
  assign less_576 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_577;
  assign less_577 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_578;
  assign less_578 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_579;
  assign less_579 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_580;
  assign less_580 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_581;
  assign less_581 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:449
  logic equal_582;
  assign equal_582 = column_s16_q == 7'h0;
  logic [3:0] select_586;
  assign select_586 = equal_585_s16_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:450
  logic [4:0] select_587;
  assign select_587 = equal_582 ? {select_586, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_588;
  assign select_588 = equal_582 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:286
  logic and_591;
  assign and_591 = census_memory_rdata_s16_q[38] & (census_memory_rdata_s16_q[18] & whole_2_s16_q);
  logic and_593;
  assign and_593 = census_memory_rdata_s16_q[77] & (census_memory_rdata_s16_q[58] & and_591);
  // hls/stages/census.hpp:270
  logic [9:0] difference_616;
  assign difference_616 = {1'b0, select_530_s16_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_619;
  assign difference_619 = {1'b0, census_memory_rdata_s16_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_623;
  assign difference_623 = {1'b0, census_memory_rdata_s16_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_627;
  assign difference_627 = {1'b0, census_memory_rdata_s16_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_631;
  assign difference_631 = {1'b0, census_memory_rdata_s16_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/agreement.hpp:199
  logic not_1499;
  assign not_1499 = ~so_s16_q;
  // hls/stages/agreement.hpp:780
  logic and_1524;
  assign and_1524 = not_1499 & and_1523_s16_q;
  logic and_1579;
  assign and_1579 = so_s16_q & and_1578_s16_q;
  logic and_1664;
  assign and_1664 = not_1490_s16_q & (so_s16_q & (ends_cell_s16_q & (inside_v_s16_q & and_1660_s16_q)));
  logic [7:0] select_1669;
  assign select_1669 = so_s16_q ? (ends_cell_s16_q ? (inside_v_s16_q ? x_s16_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:466
  logic [13:0] sum_1826;
  assign sum_1826 = {{3{patches_down_values_1_s16_q[10]}}, patches_down_values_1_s16_q} + {sum_1825_s16_q, down_2_s16_q[1]};
  logic [12:0] sum_1827;
  assign sum_1827 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1826[13:1];
  // hls/stages/patches.hpp:465
  logic [12:0] sum_1836;
  assign sum_1836 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s16_q[11:1]};
  logic [12:0] sum_1837;
  assign sum_1837 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1838;
  assign difference_1838 = {1'b0, sum_1836, smooth_s16_q[0]} - {1'b0, sum_1837, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:256
  logic and_1932;
  assign and_1932 = inside_v_s16_q & and_1923_s16_q;
  // hls/stages/agreement.hpp:1009
  logic and_1974;
  assign and_1974 = seen_columns_rdata_s16_q[0] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1063
  logic [1:0] sum_1976;
  assign sum_1976 = {1'b0, and_1973_s16_q} + ({1'b0, textured_s16_q} + {1'b0, and_1974});
  // hls/stages/agreement.hpp:1009
  logic and_2006;
  assign and_2006 = seen_columns_rdata_s16_q[11] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1065
  logic [1:0] sum_2010;
  assign sum_2010 = {1'b0, and_2007_s16_q} + ({1'b0, shown_s16_q} + {1'b0, and_2008_s16_q});
  // hls/stages/agreement.hpp:1009
  logic and_2022;
  assign and_2022 = seen_columns_rdata_s16_q[12] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1066
  logic [1:0] sum_2026;
  assign sum_2026 = {1'b0, and_2023_s16_q} + ({1'b0, near_s16_q} + {1'b0, and_2024_s16_q});
  // hls/stages/agreement.hpp:270
  logic [8:0] select_2068;
  assign select_2068 = sample_pair_whole_s16_q ? (and_522_s16_q ? grey_s16_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2070;
  assign select_2070 = sample_pair_whole_s16_q ? (and_522_s16_q ? grey_2_s16_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2072;
  assign select_2072 = sample_pair_whole_s16_q ? (and_522_s16_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2074;
  assign select_2074 = sample_pair_whole_s16_q ? (and_522_s16_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2079;
  assign sum_2079 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s16_q};
  logic [9:0] sum_2087;
  assign sum_2087 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s16_q};
  // hls/stages/agreement.hpp:514
  logic [8:0] select_2102;
  assign select_2102 = and_524_s16_q ? select_530_s16_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2103;
  assign select_2103 = and_524_s16_q ? select_534_s16_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2105;
  assign select_2105 = and_524_s16_q ? census_memory_rdata_s16_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2106;
  assign select_2106 = and_524_s16_q ? census_memory_rdata_s16_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2107;
  assign select_2107 = and_524_s16_q ? census_memory_rdata_s16_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2108;
  assign select_2108 = and_524_s16_q ? census_memory_rdata_s16_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2109;
  assign select_2109 = and_524_s16_q ? census_memory_rdata_s16_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2110;
  assign select_2110 = and_524_s16_q ? census_memory_rdata_s16_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2111;
  assign select_2111 = and_524_s16_q ? census_memory_rdata_s16_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2112;
  assign select_2112 = and_524_s16_q ? census_memory_rdata_s16_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2113;
  assign select_2113 = and_524_s16_q ? census_memory_rdata_s16_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2114;
  assign select_2114 = and_524_s16_q ? census_memory_rdata_s16_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2115;
  assign select_2115 = and_524_s16_q ? census_memory_rdata_s16_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2116;
  assign select_2116 = and_524_s16_q ? census_memory_rdata_s16_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2117;
  assign select_2117 = and_524_s16_q ? census_memory_rdata_s16_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2118;
  assign select_2118 = and_524_s16_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2119;
  assign select_2119 = and_524_s16_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2121;
  assign select_2121 = and_524_s16_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2122;
  assign select_2122 = and_524_s16_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2124;
  assign select_2124 = and_524_s16_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2125;
  assign select_2125 = and_524_s16_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2127;
  assign select_2127 = and_524_s16_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2128;
  assign select_2128 = and_524_s16_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2129;
  assign select_2129 = and_524_s16_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2131;
  assign select_2131 = and_524_s16_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2132;
  assign select_2132 = and_524_s16_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2134;
  assign select_2134 = and_524_s16_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2135;
  assign select_2135 = and_524_s16_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2137;
  assign select_2137 = and_524_s16_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2138;
  assign select_2138 = and_524_s16_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2140;
  assign select_2140 = and_524_s16_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2141;
  assign select_2141 = and_524_s16_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2143;
  assign select_2143 = and_524_s16_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2144;
  assign select_2144 = and_524_s16_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2146;
  assign select_2146 = and_524_s16_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2147;
  assign select_2147 = and_524_s16_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2150;
  assign select_2150 = and_524_s16_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2151;
  assign select_2151 = and_524_s16_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2154;
  assign select_2154 = and_524_s16_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2155;
  assign select_2155 = and_524_s16_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2159;
  assign difference_2159 = {1'b0, select_534_s16_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2162;
  assign difference_2162 = {1'b0, census_memory_rdata_s16_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2166;
  assign difference_2166 = {1'b0, census_memory_rdata_s16_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2170;
  assign difference_2170 = {1'b0, census_memory_rdata_s16_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2174;
  assign difference_2174 = {1'b0, census_memory_rdata_s16_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2205;
  assign difference_2205 = {1'b0, select_530_s16_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2217;
  assign difference_2217 = {1'b0, select_534_s16_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:514
  logic and_2433;
  assign and_2433 = and_524_s16_q & (equal_585_s16_q & equal_2308_s16_q);
  // hls/stages/agreement.hpp:780
  logic and_2444;
  assign and_2444 = not_1490_s16_q & (so_s16_q & (ends_cell_s16_q & textured_s16_q));
  // hls/stages/agreement.hpp:1064
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2459_s16_q} + ({2'h0, and_2460_s16_q} + {1'b0, sum_2464_s16_q});
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2503;
  assign select_2503 = and_2433 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2501_s16_q});
  logic [13:0] select_2510;
  assign select_2510 = and_2433 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2508_s16_q});
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2604;
  assign difference_2604 = 13'h0 - {residual_s16_q[11], residual_s16_q};
  logic less_2619;
  assign less_2619 = $signed(difference_2604) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2635;
  assign select_2635 = equal_2632_s16_q ? (registration_fresh_q & not_2633_s16_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:780
  logic [3:0] select_2637;
  assign select_2637 = so_s16_q ? (and_1578_s16_q ? select_2635 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2639;
  assign select_2639 = and_2433 ? 4'hf : (equal_1489_s16_q ? registration_fresh_q : select_2637);
  // hls/stages/registration.hpp:258
  logic not_2660;
  assign not_2660 = ~quarter_2_s16_q[1];
  logic [3:0] select_2661;
  assign select_2661 = quarter_2_s16_q[0] ? {quarter_2_s16_q[1], 1'b0, not_2660, 1'b0} : {1'b0, quarter_2_s16_q[1], 1'b0, not_2660};
  // hls/stages/patches.hpp:184
  logic [11:0] select_2901;
  assign select_2901 = equal_1710_s16_q ? patches_smooth_values_0_q : (or_1714_s16_q ? smooth_s16_q : patches_smooth_values_0_q);
  logic [11:0] select_2903;
  assign select_2903 = or_1714_s16_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2905;
  assign select_2905 = equal_1708_s16_q ? patches_smooth_values_1_q : (equal_1710_s16_q ? patches_smooth_values_1_q : select_2903);
  logic [11:0] select_2906;
  assign select_2906 = or_1714_s16_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2908;
  assign select_2908 = equal_1708_s16_q ? patches_smooth_values_2_q : (equal_1710_s16_q ? patches_smooth_values_2_q : select_2906);
  logic [11:0] select_2909;
  assign select_2909 = or_1714_s16_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2911;
  assign select_2911 = equal_1708_s16_q ? patches_smooth_values_3_q : (equal_1710_s16_q ? patches_smooth_values_3_q : select_2909);
  logic [10:0] select_2918;
  assign select_2918 = or_1714_s16_q ? patches_down_values_1_s16_q : patches_down_values_2_q;
  logic [10:0] select_2920;
  assign select_2920 = equal_1708_s16_q ? patches_down_values_2_q : (equal_1710_s16_q ? patches_down_values_2_q : select_2918);
  logic [10:0] select_2921;
  assign select_2921 = or_1714_s16_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_2923;
  assign select_2923 = equal_1708_s16_q ? patches_down_values_3_q : (equal_1710_s16_q ? patches_down_values_3_q : select_2921);
  // hls/stages/patches.hpp:555
  logic select_3375;
  assign select_3375 = less_1869_s16_q ? (not_1871_s16_q & select_3373_s16_q) : select_3373_s16_q;
  logic select_3384;
  assign select_3384 = less_1869_s16_q ? (not_1871_s16_q & select_3382_s16_q) : select_3382_s16_q;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3390;
  assign select_3390 = less_1869_s16_q ? (and_3388_s16_q ? patches_rows_rdata_s16_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3401;
  assign select_3401 = patches_read_above_q ? patches_read_row_differing_s16_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3403;
  assign select_3403 = patches_read_below_q ? patches_read_row_differing_s16_q : patches_peak_below_q;
  // hls/stages/patches.hpp:574
  logic less_3440;
  assign less_3440 = select_3401 < select_3403;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_3440 ? select_3403 : select_3401;
  logic [9:0] low;
  assign low = (select_3403 < select_3401) ? select_3403 : select_3401;
  // hls/stages/agreement.hpp:1195
  logic equal_3518;
  assign equal_3518 = x_s16_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:203
  logic or_3733;
  assign or_3733 = segment_starts_q | not_1499;
  // hls/stages/agreement.hpp:780
  logic select_3737;
  assign select_3737 = ends_cell_s16_q ? (inside_v_s16_q ? select_3735_s16_q : or_3733) : or_3733;
  // hls/stages/agreement.hpp:1189
  logic equal_3767;
  assign equal_3767 = x_s16_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1101
  logic [7:0] select_3790;
  assign select_3790 = equal_3768_s16_q ? {cfg_on_skin_limit_i, 3'h0} : select_3789_s16_q;
  logic [7:0] limit;
  assign limit = equal_3767 ? cfg_regions_limit_i : select_3790;
  // hls/stages/agreement.hpp:1203
  logic not_3792;
  assign not_3792 = ~x_s16_q[2];
  logic [3:0] select_3793;
  assign select_3793 = x_s16_q[1] ? {x_s16_q[2], 1'b0, not_3792, 1'b0} : {1'b0, x_s16_q[2], 1'b0, not_3792};
  logic [7:0] select_3794;
  assign select_3794 = x_s16_q[0] ? {select_3793[3], 1'b0, select_3793[2], 1'b0, select_3793[1], 1'b0, select_3793[0], 1'b0} : {1'b0, select_3793[3], 1'b0, select_3793[2], 1'b0, select_3793[1], 1'b0, select_3793[0]};
  // hls/stages/agreement.hpp:1101
  logic [13:0] select_3798;
  assign select_3798 = equal_3769_s16_q ? counts_skin_supervised_q : (equal_3770_s16_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3800;
  assign select_3800 = equal_3768_s16_q ? counts_skin_textured_q : (equal_3765_s16_q ? counts_textured_q : select_3798);
  logic [13:0] of;
  assign of = equal_3767 ? counts_textured_q : select_3800;
  // hls/stages/registration.hpp:258
  logic not_4001;
  assign not_4001 = ~quarter_s16_q[1];
  logic [3:0] select_4002;
  assign select_4002 = quarter_s16_q[0] ? {quarter_s16_q[1], 1'b0, not_4001, 1'b0} : {1'b0, quarter_s16_q[1], 1'b0, not_4001};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 16, written in stage 20: 16 < 20 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1537_s16_q;
  logic registration_sums_re;
  assign registration_sums_re = s16_en & (equal_1489_s16_q ? (x_s16_q[6] & select_1568_s16_q) : and_1579);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s16_q;
  logic census_memory_we;
  assign census_memory_we = s16_en & and_524_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s16_q[58:40], census_memory_rdata_s16_q[38:0], and_542_s16_q, whole_2_s16_q, select_534_s16_q, select_530_s16_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s15_sim;
  logic census_memory_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s15_sim <= census_memory_re;
      census_memory_raddr_s15_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s15_sim && census_memory_raddr_s15_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1498_s16_q;
  logic shown_right_we;
  assign shown_right_we = s16_en & and_1529_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1524, not_1499};
  end
`ifndef SYNTHESIS
  logic [6:0] shown_right_raddr_s14_sim;
  logic shown_right_re_s14_sim;
  logic [6:0] shown_right_raddr_s15_sim;
  logic shown_right_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      shown_right_re_s14_sim <= 1'b0;
      shown_right_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      shown_right_re_s14_sim <= shown_right_re;
      shown_right_raddr_s14_sim <= shown_right_raddr;
      shown_right_re_s15_sim <= shown_right_re_s14_sim;
      shown_right_raddr_s15_sim <= shown_right_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_re_s14_sim && shown_right_raddr_s14_sim == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_re_s15_sim && shown_right_raddr_s15_sim == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 7'd120) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 7'd120) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s16_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s16_en & and_1494_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s16_q, near_s16_q, shown_s16_q, explained_s16_q, and_1932, textured_s16_q};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s13_sim;
  logic seen_columns_re_s13_sim;
  logic [6:0] seen_columns_raddr_s14_sim;
  logic seen_columns_re_s14_sim;
  logic [6:0] seen_columns_raddr_s15_sim;
  logic seen_columns_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s13_sim <= 1'b0;
      seen_columns_re_s14_sim <= 1'b0;
      seen_columns_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s13_sim <= seen_columns_re;
      seen_columns_raddr_s13_sim <= seen_columns_raddr;
      seen_columns_re_s14_sim <= seen_columns_re_s13_sim;
      seen_columns_raddr_s14_sim <= seen_columns_raddr_s13_sim;
      seen_columns_re_s15_sim <= seen_columns_re_s14_sim;
      seen_columns_raddr_s15_sim <= seen_columns_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s13_sim && seen_columns_raddr_s13_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s14_sim && seen_columns_raddr_s14_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s15_sim && seen_columns_raddr_s15_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 7'd120) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 7'd120) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      counts_textured_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
      registration_fresh_q <= 4'hf;
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
      segment_starts_q <= 1'b1;
    end else if (s16_en) begin
      census_filled_q <= and_524_s16_q ? {select_588[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_524_s16_q ? select_587 : rows_passed_above_q;
      counts_textured_q <= and_2433 ? 14'h0 : (counts_textured_q + {13'h0, and_2444});
      counts_skin_supervised_q <= select_2503;
      counts_skin_textured_q <= select_2510;
      registration_fresh_q <= select_2639;
      patches_smooth_values_0_q <= equal_1708_s16_q ? patches_smooth_values_0_q : select_2901;
      patches_smooth_values_1_q <= select_2905;
      patches_smooth_values_2_q <= select_2908;
      patches_smooth_values_3_q <= select_2911;
      patches_down_values_2_q <= select_2920;
      patches_down_values_3_q <= select_2923;
      patches_read_above_q <= equal_1708_s16_q ? select_3375 : patches_read_above_q;
      patches_read_below_q <= equal_1708_s16_q ? select_3384 : patches_read_below_q;
      patches_peak_above_q <= equal_1708_s16_q ? select_3401 : patches_peak_above_q;
      patches_peak_below_q <= equal_1708_s16_q ? select_3403 : patches_peak_below_q;
      segment_starts_q <= equal_1489_s16_q ? or_3733 : (so_s16_q ? select_3737 : or_3733);
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s16_en) begin
      averager_quarter_1_0_q <= select_2068;
      averager_quarter_1_1_q <= select_2070;
      averager_quarter_2_0_q <= select_2072;
      averager_quarter_2_1_q <= select_2074;
      census_columns_values_0_cell_0_left_q <= select_2102;
      census_columns_values_0_cell_0_right_q <= select_2103;
      census_columns_values_0_cell_1_left_q <= select_2105;
      census_columns_values_0_cell_1_right_q <= select_2106;
      census_columns_values_0_cell_1_mask_q <= select_2107;
      census_columns_values_0_cell_2_left_q <= select_2108;
      census_columns_values_0_cell_2_right_q <= select_2109;
      census_columns_values_0_cell_2_mask_q <= select_2110;
      census_columns_values_0_cell_2_of_skin_q <= select_2111;
      census_columns_values_0_cell_3_left_q <= select_2112;
      census_columns_values_0_cell_3_right_q <= select_2113;
      census_columns_values_0_cell_3_mask_q <= select_2114;
      census_columns_values_0_cell_4_left_q <= select_2115;
      census_columns_values_0_cell_4_right_q <= select_2116;
      census_columns_values_0_cell_4_mask_q <= select_2117;
      census_columns_values_1_cell_0_left_q <= select_2118;
      census_columns_values_1_cell_0_right_q <= select_2119;
      census_columns_values_1_cell_1_left_q <= select_2121;
      census_columns_values_1_cell_1_right_q <= select_2122;
      census_columns_values_1_cell_2_left_q <= select_2124;
      census_columns_values_1_cell_2_right_q <= select_2125;
      census_columns_values_1_cell_2_of_skin_q <= select_2127;
      census_columns_values_1_cell_3_left_q <= select_2128;
      census_columns_values_1_cell_3_right_q <= select_2129;
      census_columns_values_1_cell_4_left_q <= select_2131;
      census_columns_values_1_cell_4_right_q <= select_2132;
      census_columns_values_2_cell_0_left_q <= select_2134;
      census_columns_values_2_cell_0_right_q <= select_2135;
      census_columns_values_2_cell_1_left_q <= select_2137;
      census_columns_values_2_cell_1_right_q <= select_2138;
      census_columns_values_2_cell_2_left_q <= select_2140;
      census_columns_values_2_cell_2_right_q <= select_2141;
      census_columns_values_2_cell_3_left_q <= select_2143;
      census_columns_values_2_cell_3_right_q <= select_2144;
      census_columns_values_2_cell_4_left_q <= select_2146;
      census_columns_values_2_cell_4_right_q <= select_2147;
      census_columns_values_3_cell_1_left_q <= select_2150;
      census_columns_values_3_cell_1_right_q <= select_2151;
      census_columns_values_3_cell_3_left_q <= select_2154;
      census_columns_values_3_cell_3_right_q <= select_2155;
      sharpness_last_mean_0_q <= and_524_s16_q ? select_530_s16_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_524_s16_q ? select_534_s16_q : sharpness_last_mean_1_q;
    end
  end

  logic [7:0] pixel_0_s17_q;
  logic [7:0] pixel_1_s17_q;
  logic saturated_s17_q;
  logic mask_s17_q;
  logic marks_first_s17_q;
  logic marks_last_s17_q;
  logic [7:0] sample_pair_pixel_0_s17_q;
  logic [7:0] sample_pair_pixel_1_s17_q;
  logic sample_pair_whole_s17_q;
  logic sample_present_s17_q;
  logic census_columns_values_0_cell_1_mask_s17_q;
  logic census_columns_values_0_cell_2_mask_s17_q;
  logic census_columns_values_0_cell_3_mask_s17_q;
  logic census_columns_values_0_cell_4_mask_s17_q;
  logic census_columns_values_1_cell_2_of_skin_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic [2:0] slot_s17_q;
  logic ends_cell_s17_q;
  logic lower_half_s17_q;
  logic [13:0] counts_textured_s17_q;
  logic registration_of_right_s17_q;
  logic [4:0] patches_choosing_band_s17_q;
  logic patches_lower_s17_q;
  logic patches_second_s17_q;
  logic [4:0] patches_code_row_s17_q;
  logic [10:0] patches_down_values_3_s17_q;
  logic [4:0] patches_along_s17_q;
  logic patches_summed_last_s17_q;
  logic [4:0] patches_summed_down_by_s17_q;
  logic patches_read_first_s17_q;
  logic [2:0] region_row_s17_q;
  logic region_fresh_s17_q;
  logic centres_values_1_textured_s17_q;
  logic centres_values_1_of_skin_s17_q;
  logic [3:0] select_485_s17_q;
  logic [6:0] select_488_s17_q;
  logic [6:0] column_s17_q;
  logic and_522_s17_q;
  logic and_524_s17_q;
  logic equal_527_s17_q;
  logic whole_2_s17_q;
  logic so_s17_q;
  logic less_558_s17_q;
  logic less_559_s17_q;
  logic less_560_s17_q;
  logic less_561_s17_q;
  logic less_562_s17_q;
  logic less_563_s17_q;
  logic less_564_s17_q;
  logic less_565_s17_q;
  logic less_566_s17_q;
  logic less_567_s17_q;
  logic less_568_s17_q;
  logic less_569_s17_q;
  logic less_570_s17_q;
  logic less_571_s17_q;
  logic less_572_s17_q;
  logic less_573_s17_q;
  logic less_574_s17_q;
  logic less_575_s17_q;
  logic less_576_s17_q;
  logic less_577_s17_q;
  logic less_578_s17_q;
  logic less_579_s17_q;
  logic less_580_s17_q;
  logic less_581_s17_q;
  logic and_589_s17_q;
  logic and_593_s17_q;
  logic difference_616_s17_q;
  logic [8:0] xor_617_s17_q;
  logic difference_619_s17_q;
  logic [8:0] xor_620_s17_q;
  logic difference_623_s17_q;
  logic [8:0] xor_624_s17_q;
  logic difference_627_s17_q;
  logic [8:0] xor_628_s17_q;
  logic difference_631_s17_q;
  logic [8:0] xor_632_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1427_s17_q;
  logic [2:0] select_1432_s17_q;
  logic [7:0] select_1433_s17_q;
  logic [7:0] select_1441_s17_q;
  logic [7:0] select_1444_s17_q;
  logic [6:0] select_1462_s17_q;
  logic [5:0] select_1464_s17_q;
  logic [7:0] select_1467_s17_q;
  logic [7:0] select_1470_s17_q;
  logic and_1471_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1483_s17_q;
  logic [6:0] select_1484_s17_q;
  logic [6:0] select_1487_s17_q;
  logic [6:0] select_1488_s17_q;
  logic equal_1489_s17_q;
  logic not_1490_s17_q;
  logic equal_1530_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1536_s17_q;
  logic equal_1538_s17_q;
  logic equal_1540_s17_q;
  logic equal_1542_s17_q;
  logic equal_1544_s17_q;
  logic equal_1546_s17_q;
  logic equal_1548_s17_q;
  logic equal_1550_s17_q;
  logic equal_1552_s17_q;
  logic less_1561_s17_q;
  logic or_1565_s17_q;
  logic equal_1585_s17_q;
  logic and_1595_s17_q;
  logic and_1598_s17_q;
  logic select_1615_s17_q;
  logic equal_1616_s17_q;
  logic [22:0] patches_choices_rdata_s17_q;
  logic and_1624_s17_q;
  logic equal_1626_s17_q;
  logic equal_1649_s17_q;
  logic and_1664_s17_q;
  logic [7:0] select_1670_s17_q;
  logic [5:0] select_1674_s17_q;
  logic [7:0] select_1699_s17_q;
  logic and_1706_s17_q;
  logic and_1707_s17_q;
  logic equal_1708_s17_q;
  logic equal_1710_s17_q;
  logic equal_1713_s17_q;
  logic or_1714_s17_q;
  logic and_1723_s17_q;
  logic [4:0] select_1738_s17_q;
  logic select_1744_s17_q;
  logic [3:0] select_1783_s17_q;
  logic less_1799_s17_q;
  logic new_row_s17_q;
  logic or_1812_s17_q;
  logic [27:0] patches_right_codes_rdata_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic down_2_s17_q;
  logic sum_1826_s17_q;
  logic [12:0] sum_1827_s17_q;
  logic [14:0] difference_1838_s17_q;
  logic and_1854_s17_q;
  logic [47:0] patches_left_codes_rdata_s17_q;
  logic and_1863_s17_q;
  logic and_1868_s17_q;
  logic less_1869_s17_q;
  logic equal_1870_s17_q;
  logic not_1871_s17_q;
  logic equal_1872_s17_q;
  logic or_1890_s17_q;
  logic or_1893_s17_q;
  logic or_1896_s17_q;
  logic not_1898_s17_q;
  logic [29:0] regions_rdata_s17_q;
  logic textured_s17_q;
  logic explained_s17_q;
  logic and_1925_s17_q;
  logic and_1930_s17_q;
  logic and_1971_s17_q;
  logic and_1972_s17_q;
  logic [1:0] sum_1976_s17_q;
  logic or_1988_s17_q;
  logic or_1991_s17_q;
  logic or_1994_s17_q;
  logic and_2005_s17_q;
  logic [2:0] sum_2011_s17_q;
  logic and_2021_s17_q;
  logic [2:0] sum_2027_s17_q;
  logic and_2044_s17_q;
  logic sum_2079_s17_q;
  logic [9:0] difference_2080_s17_q;
  logic sum_2087_s17_q;
  logic [9:0] difference_2088_s17_q;
  logic difference_2159_s17_q;
  logic [8:0] xor_2160_s17_q;
  logic difference_2162_s17_q;
  logic [8:0] xor_2163_s17_q;
  logic difference_2166_s17_q;
  logic [8:0] xor_2167_s17_q;
  logic difference_2170_s17_q;
  logic [8:0] xor_2171_s17_q;
  logic difference_2174_s17_q;
  logic [8:0] xor_2175_s17_q;
  logic equal_2184_s17_q;
  logic difference_2205_s17_q;
  logic [8:0] xor_2206_s17_q;
  logic difference_2217_s17_q;
  logic [8:0] xor_2218_s17_q;
  logic equal_2308_s17_q;
  logic and_2433_s17_q;
  logic and_2439_s17_q;
  logic and_2444_s17_q;
  logic not_2458_s17_q;
  logic [2:0] explained_2_s17_q;
  logic and_2535_s17_q;
  logic and_2569_s17_q;
  logic and_2570_s17_q;
  logic [7:0] residual_s17_q;
  logic less_2605_s17_q;
  logic less_2619_s17_q;
  logic equal_2663_s17_q;
  logic and_2808_s17_q;
  logic less_2935_s17_q;
  logic equal_3278_s17_q;
  logic [4:0] select_3366_s17_q;
  logic [9:0] select_3390_s17_q;
  logic [14:0] select_3397_s17_q;
  logic less_3440_s17_q;
  logic [9:0] high_s17_q;
  logic [9:0] low_s17_q;
  logic equal_3518_s17_q;
  logic and_3747_s17_q;
  logic equal_3765_s17_q;
  logic equal_3767_s17_q;
  logic equal_3768_s17_q;
  logic equal_3769_s17_q;
  logic equal_3770_s17_q;
  logic equal_3796_s17_q;
  logic [13:0] of_s17_q;
  logic equal_3910_s17_q;
  logic equal_4004_s17_q;
  always_ff @(posedge clk_i) begin
    if (s16_en) begin
      pixel_0_s17_q <= pixel_0_s16_q;
      pixel_1_s17_q <= pixel_1_s16_q;
      saturated_s17_q <= saturated_s16_q;
      mask_s17_q <= mask_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      sample_pair_pixel_0_s17_q <= sample_pair_pixel_0_s16_q;
      sample_pair_pixel_1_s17_q <= sample_pair_pixel_1_s16_q;
      sample_pair_whole_s17_q <= sample_pair_whole_s16_q;
      sample_present_s17_q <= sample_present_s16_q;
      census_columns_values_0_cell_1_mask_s17_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s17_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s17_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s17_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s17_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      slot_s17_q <= slot_s16_q;
      ends_cell_s17_q <= ends_cell_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      counts_textured_s17_q <= counts_textured_q;
      registration_of_right_s17_q <= registration_of_right_s16_q;
      patches_choosing_band_s17_q <= patches_choosing_band_s16_q;
      patches_lower_s17_q <= patches_lower_s16_q;
      patches_second_s17_q <= patches_second_s16_q;
      patches_code_row_s17_q <= patches_code_row_s16_q;
      patches_down_values_3_s17_q <= patches_down_values_3_q;
      patches_along_s17_q <= patches_along_s16_q;
      patches_summed_last_s17_q <= patches_summed_last_s16_q;
      patches_summed_down_by_s17_q <= patches_summed_down_by_s16_q;
      patches_read_first_s17_q <= patches_read_first_s16_q;
      region_row_s17_q <= region_row_s16_q;
      region_fresh_s17_q <= region_fresh_s16_q;
      centres_values_1_textured_s17_q <= centres_values_1_textured_s16_q;
      centres_values_1_of_skin_s17_q <= centres_values_1_of_skin_s16_q;
      select_485_s17_q <= select_485_s16_q;
      select_488_s17_q <= select_488_s16_q;
      column_s17_q <= column_s16_q;
      and_522_s17_q <= and_522_s16_q;
      and_524_s17_q <= and_524_s16_q;
      equal_527_s17_q <= equal_527_s16_q;
      whole_2_s17_q <= whole_2_s16_q;
      so_s17_q <= so_s16_q;
      less_558_s17_q <= less_558;
      less_559_s17_q <= less_559;
      less_560_s17_q <= less_560;
      less_561_s17_q <= less_561;
      less_562_s17_q <= less_562;
      less_563_s17_q <= less_563;
      less_564_s17_q <= less_564;
      less_565_s17_q <= less_565;
      less_566_s17_q <= less_566;
      less_567_s17_q <= less_567;
      less_568_s17_q <= less_568;
      less_569_s17_q <= less_569;
      less_570_s17_q <= less_570;
      less_571_s17_q <= less_571;
      less_572_s17_q <= less_572;
      less_573_s17_q <= less_573;
      less_574_s17_q <= less_574;
      less_575_s17_q <= less_575;
      less_576_s17_q <= less_576;
      less_577_s17_q <= less_577;
      less_578_s17_q <= less_578;
      less_579_s17_q <= less_579;
      less_580_s17_q <= less_580;
      less_581_s17_q <= less_581;
      and_589_s17_q <= select_587[4] & select_588[3];
      and_593_s17_q <= and_593;
      difference_616_s17_q <= difference_616[9];
      xor_617_s17_q <= difference_616[8:0] ^ {9{difference_616[9]}};
      difference_619_s17_q <= difference_619[9];
      xor_620_s17_q <= difference_619[8:0] ^ {9{difference_619[9]}};
      difference_623_s17_q <= difference_623[9];
      xor_624_s17_q <= difference_623[8:0] ^ {9{difference_623[9]}};
      difference_627_s17_q <= difference_627[9];
      xor_628_s17_q <= difference_627[8:0] ^ {9{difference_627[9]}};
      difference_631_s17_q <= difference_631[9];
      xor_632_s17_q <= difference_631[8:0] ^ {9{difference_631[9]}};
      x_s17_2_q <= x_s16_2_q;
      select_1427_s17_q <= or_1426_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1432_s17_q <= or_1426_s16_q ? select_1431_s16_q : best_left_rdata_s16_q[8:6];
      select_1433_s17_q <= or_1426_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1441_s17_q <= or_1426_s16_q ? select_1440_s16_q : best_left_rdata_s16_q[24:17];
      select_1444_s17_q <= or_1426_s16_q ? select_1443_s16_q : best_left_rdata_s16_q[32:25];
      select_1462_s17_q <= select_1462_s16_q;
      select_1464_s17_q <= select_1464_s16_q;
      select_1467_s17_q <= select_1467_s16_q;
      select_1470_s17_q <= select_1470_s16_q;
      and_1471_s17_q <= and_1471_s16_q;
      right_s17_q <= right_s16_q;
      select_1483_s17_q <= or_1482_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1484_s17_q <= or_1482_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1487_s17_q <= select_1487_s16_q;
      select_1488_s17_q <= select_1488_s16_q;
      equal_1489_s17_q <= equal_1489_s16_q;
      not_1490_s17_q <= not_1490_s16_q;
      equal_1530_s17_q <= equal_1530_s16_q;
      all_s17_q <= all_s16_q;
      sum_1536_s17_q <= sum_1536_s16_q;
      equal_1538_s17_q <= equal_1538_s16_q;
      equal_1540_s17_q <= equal_1540_s16_q;
      equal_1542_s17_q <= equal_1542_s16_q;
      equal_1544_s17_q <= equal_1544_s16_q;
      equal_1546_s17_q <= equal_1546_s16_q;
      equal_1548_s17_q <= equal_1548_s16_q;
      equal_1550_s17_q <= equal_1550_s16_q;
      equal_1552_s17_q <= equal_1552_s16_q;
      less_1561_s17_q <= less_1561_s16_q;
      or_1565_s17_q <= or_1565_s16_q;
      equal_1585_s17_q <= (registration_fresh_q & select_1583_s16_q) == 4'h0;
      and_1595_s17_q <= not_1490_s16_q & and_1579;
      and_1598_s17_q <= and_1598_s16_q;
      select_1615_s17_q <= select_1615_s16_q;
      equal_1616_s17_q <= equal_1616_s16_q;
      patches_choices_rdata_s17_q <= patches_choices_rdata_q;
      and_1624_s17_q <= and_1624_s16_q;
      equal_1626_s17_q <= equal_1626_s16_q;
      equal_1649_s17_q <= equal_1649_s16_q;
      and_1664_s17_q <= and_1664;
      select_1670_s17_q <= equal_1489_s16_q ? 8'h0 : select_1669;
      select_1674_s17_q <= select_1674_s16_q;
      select_1699_s17_q <= select_1699_s16_q;
      and_1706_s17_q <= and_1706_s16_q;
      and_1707_s17_q <= and_1707_s16_q;
      equal_1708_s17_q <= equal_1708_s16_q;
      equal_1710_s17_q <= equal_1710_s16_q;
      equal_1713_s17_q <= equal_1713_s16_q;
      or_1714_s17_q <= or_1714_s16_q;
      and_1723_s17_q <= and_1723_s16_q;
      select_1738_s17_q <= select_1738_s16_q;
      select_1744_s17_q <= select_1744_s16_q;
      select_1783_s17_q <= select_1783_s16_q;
      less_1799_s17_q <= less_1799_s16_q;
      new_row_s17_q <= new_row_s16_q;
      or_1812_s17_q <= or_1812_s16_q;
      patches_right_codes_rdata_s17_q <= patches_right_codes_rdata_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      down_2_s17_q <= down_2_s16_q[0];
      sum_1826_s17_q <= sum_1826[0];
      sum_1827_s17_q <= sum_1827;
      difference_1838_s17_q <= difference_1838;
      and_1854_s17_q <= and_1854_s16_q;
      patches_left_codes_rdata_s17_q <= patches_left_codes_rdata_q;
      and_1863_s17_q <= and_1863_s16_q;
      and_1868_s17_q <= and_1868_s16_q;
      less_1869_s17_q <= less_1869_s16_q;
      equal_1870_s17_q <= equal_1870_s16_q;
      not_1871_s17_q <= not_1871_s16_q;
      equal_1872_s17_q <= equal_1872_s16_q;
      or_1890_s17_q <= or_1890_s16_q;
      or_1893_s17_q <= or_1893_s16_q;
      or_1896_s17_q <= or_1896_s16_q;
      not_1898_s17_q <= not_1898_s16_q;
      regions_rdata_s17_q <= regions_rdata_q;
      textured_s17_q <= textured_s16_q;
      explained_s17_q <= explained_s16_q;
      and_1925_s17_q <= inside_v_s16_q & (and_1923_s16_q & and_1523_s16_q);
      and_1930_s17_q <= and_1930_s16_q;
      and_1971_s17_q <= and_1971_s16_q;
      and_1972_s17_q <= seen_columns_rdata_s16_q[9] & inside_v_s16_q;
      sum_1976_s17_q <= sum_1976;
      or_1988_s17_q <= or_1988_s16_q;
      or_1991_s17_q <= or_1991_s16_q;
      or_1994_s17_q <= or_1994_s16_q;
      and_2005_s17_q <= and_2005_s16_q;
      sum_2011_s17_q <= {2'h0, and_2006} + {1'b0, sum_2010};
      and_2021_s17_q <= and_2021_s16_q;
      sum_2027_s17_q <= {2'h0, and_2022} + {1'b0, sum_2026};
      and_2044_s17_q <= and_2044_s16_q;
      sum_2079_s17_q <= sum_2079[0];
      difference_2080_s17_q <= {1'b0, sum_2079[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2087_s17_q <= sum_2087[0];
      difference_2088_s17_q <= {1'b0, sum_2087[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2159_s17_q <= difference_2159[9];
      xor_2160_s17_q <= difference_2159[8:0] ^ {9{difference_2159[9]}};
      difference_2162_s17_q <= difference_2162[9];
      xor_2163_s17_q <= difference_2162[8:0] ^ {9{difference_2162[9]}};
      difference_2166_s17_q <= difference_2166[9];
      xor_2167_s17_q <= difference_2166[8:0] ^ {9{difference_2166[9]}};
      difference_2170_s17_q <= difference_2170[9];
      xor_2171_s17_q <= difference_2170[8:0] ^ {9{difference_2170[9]}};
      difference_2174_s17_q <= difference_2174[9];
      xor_2175_s17_q <= difference_2174[8:0] ^ {9{difference_2174[9]}};
      equal_2184_s17_q <= equal_2184_s16_q;
      difference_2205_s17_q <= difference_2205[9];
      xor_2206_s17_q <= difference_2205[8:0] ^ {9{difference_2205[9]}};
      difference_2217_s17_q <= difference_2217[9];
      xor_2218_s17_q <= difference_2217[8:0] ^ {9{difference_2217[9]}};
      equal_2308_s17_q <= equal_2308_s16_q;
      and_2433_s17_q <= and_2433;
      and_2439_s17_q <= and_2439_s16_q;
      and_2444_s17_q <= and_2444;
      not_2458_s17_q <= not_2458_s16_q;
      explained_2_s17_q <= explained_2;
      and_2535_s17_q <= not_1490_s16_q & (so_s16_q & (ends_cell_s16_q & and_2532_s16_q));
      and_2569_s17_q <= and_2569_s16_q;
      and_2570_s17_q <= and_2570_s16_q;
      residual_s17_q <= residual_s16_q[7:0];
      less_2605_s17_q <= $signed(difference_2604) < $signed({7'h0, cfg_moved_limit_i});
      less_2619_s17_q <= less_2619;
      equal_2663_s17_q <= (registration_fresh_q & select_2661) == 4'h0;
      and_2808_s17_q <= and_2808_s16_q;
      less_2935_s17_q <= less_2935_s16_q;
      equal_3278_s17_q <= equal_3278_s16_q;
      select_3366_s17_q <= select_3366_s16_q;
      select_3390_s17_q <= select_3390;
      select_3397_s17_q <= select_3397_s16_q;
      less_3440_s17_q <= less_3440;
      high_s17_q <= high;
      low_s17_q <= low;
      equal_3518_s17_q <= equal_3518;
      and_3747_s17_q <= equal_3746_s16_q & equal_3518;
      equal_3765_s17_q <= equal_3765_s16_q;
      equal_3767_s17_q <= equal_3767;
      equal_3768_s17_q <= equal_3768_s16_q;
      equal_3769_s17_q <= equal_3769_s16_q;
      equal_3770_s17_q <= equal_3770_s16_q;
      equal_3796_s17_q <= (limit & select_3794) == 8'h0;
      of_s17_q <= of;
      equal_3910_s17_q <= equal_3910_s16_q;
      equal_4004_s17_q <= (registration_fresh_q & select_4002) == 4'h0;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [13:0] counts_explained_q;
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [7:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
  logic [9:0] patches_read_far_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic segment_started_q;
  logic [13:0] product_q;
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
  logic [12:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/agreement.hpp:450
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_593_s17_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s17_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s17_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s17_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s17_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:270
  logic [9:0] sum_618;
  assign sum_618 = {9'h0, difference_616_s17_q} + {1'b0, xor_617_s17_q};
  logic [9:0] sum_621;
  assign sum_621 = {9'h0, difference_619_s17_q} + {1'b0, xor_620_s17_q};
  // hls/stages/patches.hpp:156
  logic and_1666;
  assign and_1666 = and_1664_s17_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:342
  logic [22:0] select_1700;
  assign select_1700 = and_1666 ? {select_1699_s17_q, select_1674_s17_q, select_1670_s17_q, and_1664_s17_q} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:466
  logic [14:0] sum_1828;
  assign sum_1828 = {{4{patches_down_values_3_s17_q[10]}}, patches_down_values_3_s17_q} + {sum_1827_s17_q, sum_1826_s17_q, down_2_s17_q};
  // hls/stages/agreement.hpp:890
  logic [6:0] select_1911;
  assign select_1911 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:891
  logic [6:0] sum_1912;
  assign sum_1912 = {6'h0, textured_s17_q} + select_1911;
  // hls/stages/agreement.hpp:1037
  logic [9:0] sum_1914;
  assign sum_1914 = {3'h0, sum_1912} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[9:0]);
  // hls/stages/agreement.hpp:890
  logic [6:0] select_1916;
  assign select_1916 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:891
  logic [6:0] sum_1917;
  assign sum_1917 = {6'h0, explained_s17_q} + select_1916;
  // hls/stages/agreement.hpp:1038
  logic [9:0] sum_1919;
  assign sum_1919 = {3'h0, sum_1917} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[19:10]);
  // hls/stages/agreement.hpp:890
  logic [6:0] select_1926;
  assign select_1926 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:892
  logic [6:0] sum_1927;
  assign sum_1927 = {6'h0, and_1925_s17_q} + select_1926;
  // hls/stages/agreement.hpp:1039
  logic [9:0] sum_1929;
  assign sum_1929 = {3'h0, sum_1927} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[29:20]);
  // hls/stages/agreement.hpp:1246
  logic or_1939;
  assign or_1939 = marks_first_s17_q | line_ended_q;
  // hls/stages/agreement.hpp:1248
  logic [12:0] select_1941;
  assign select_1941 = marks_first_s17_q ? 13'h1 : (or_1939 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1247
  logic [8:0] select_1943;
  assign select_1943 = or_1939 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1255
  logic select_1945;
  assign select_1945 = cfg_compete_i ? (or_1939 & select_1941[12]) : (select_1943[8] & select_1941[9]);
  // hls/stages/agreement.hpp:1063
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1971_s17_q} + ({2'h0, and_1972_s17_q} + {1'b0, sum_1976_s17_q});
  // hls/stages/agreement.hpp:1065
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2005_s17_q} + sum_2011_s17_q;
  // hls/stages/agreement.hpp:1072
  logic [2:0] select_2013;
  assign select_2013 = age_s17_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1066
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2021_s17_q} + sum_2027_s17_q;
  // hls/stages/agreement.hpp:1073
  logic [2:0] select_2029;
  assign select_2029 = age_s17_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:209
  logic [9:0] xor_2081;
  assign xor_2081 = {difference_2080_s17_q[8:0], sum_2079_s17_q} ^ {10{difference_2080_s17_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2080_s17_q[9]} + {1'b0, xor_2081};
  logic [9:0] xor_2089;
  assign xor_2089 = {difference_2088_s17_q[8:0], sum_2087_s17_q} ^ {10{difference_2088_s17_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2088_s17_q[9]} + {1'b0, xor_2089};
  // hls/stages/agreement.hpp:514
  logic select_2104;
  assign select_2104 = and_524_s17_q ? whole_2_s17_q : census_columns_values_0_cell_0_mask_q;
  logic select_2120;
  assign select_2120 = and_524_s17_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2123;
  assign select_2123 = and_524_s17_q ? census_columns_values_0_cell_1_mask_s17_q : census_columns_values_1_cell_1_mask_q;
  logic select_2126;
  assign select_2126 = and_524_s17_q ? census_columns_values_0_cell_2_mask_s17_q : census_columns_values_1_cell_2_mask_q;
  logic select_2130;
  assign select_2130 = and_524_s17_q ? census_columns_values_0_cell_3_mask_s17_q : census_columns_values_1_cell_3_mask_q;
  logic select_2133;
  assign select_2133 = and_524_s17_q ? census_columns_values_0_cell_4_mask_s17_q : census_columns_values_1_cell_4_mask_q;
  logic select_2136;
  assign select_2136 = and_524_s17_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2139;
  assign select_2139 = and_524_s17_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_2161;
  assign sum_2161 = {9'h0, difference_2159_s17_q} + {1'b0, xor_2160_s17_q};
  logic [9:0] sum_2164;
  assign sum_2164 = {9'h0, difference_2162_s17_q} + {1'b0, xor_2163_s17_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2205_s17_q} + xor_2206_s17_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2217_s17_q} + xor_2218_s17_q;
  // hls/stages/agreement.hpp:780
  logic and_2449;
  assign and_2449 = not_1490_s17_q & (so_s17_q & (ends_cell_s17_q & explained_s17_q));
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2451;
  assign select_2451 = and_2433_s17_q ? 14'h0 : (counts_explained_q + {13'h0, and_2449});
  // hls/stages/agreement.hpp:780
  logic and_2454;
  assign and_2454 = not_1490_s17_q & (so_s17_q & (ends_cell_s17_q & and_1925_s17_q));
  // hls/stages/agreement.hpp:1071
  logic [2:0] select_2467;
  assign select_2467 = age_s17_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1108
  logic less_2483;
  assign less_2483 = region_row_s17_q < x_s17_q[5:3];
  // hls/stages/patches.hpp:344
  logic not_2798;
  assign not_2798 = ~and_1706_s17_q;
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_1812_s17_q ? patches_right_codes_rdata_s17_q : 28'h0;
  // hls/stages/patches.hpp:517
  logic [47:0] select_2968;
  assign select_2968 = new_row_s17_q ? patches_left_codes_rdata_s17_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_2970;
  assign select_2970 = equal_1708_s17_q ? patches_left_row_q : (equal_1710_s17_q ? select_2968 : patches_left_row_q);
  logic [4:0] select_3315;
  assign select_3315 = equal_1710_s17_q ? patches_along_s17_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3392;
  assign select_3392 = less_1869_s17_q ? (equal_1872_s17_q ? 10'h3ff : select_3390_s17_q) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3393;
  assign select_3393 = equal_1872_s17_q ? select_3392 : select_3390_s17_q;
  logic [9:0] select_3395;
  assign select_3395 = less_1869_s17_q ? (equal_1870_s17_q ? 10'h3ff : select_3393) : select_3393;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high_s17_q - low_s17_q;
  logic [9:0] fall_2;
  assign fall_2 = high_s17_q - select_3397_s17_q[9:0];
  // hls/stages/agreement.hpp:1203
  logic [13:0] select_3783;
  assign select_3783 = equal_3518_s17_q ? 14'h0 : product_q;
  logic [13:0] select_3802;
  assign select_3802 = equal_3796_s17_q ? 14'h0 : of_s17_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3783} + {1'b0, select_3802};
  // hls/stages/agreement.hpp:780
  logic [2:0] select_3843;
  assign select_3843 = ends_cell_s17_q ? explained_2_s17_q : box_explained_columns_values_0_q;
  logic [2:0] select_3845;
  assign select_3845 = equal_1489_s17_q ? box_explained_columns_values_0_q : (so_s17_q ? select_3843 : box_explained_columns_values_0_q);
  logic [2:0] select_3846;
  assign select_3846 = ends_cell_s17_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3848;
  assign select_3848 = equal_1489_s17_q ? box_explained_columns_values_1_q : (so_s17_q ? select_3846 : box_explained_columns_values_1_q);
  logic [2:0] select_3849;
  assign select_3849 = ends_cell_s17_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3851;
  assign select_3851 = equal_1489_s17_q ? box_explained_columns_values_2_q : (so_s17_q ? select_3849 : box_explained_columns_values_2_q);
  logic [2:0] select_3852;
  assign select_3852 = ends_cell_s17_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3854;
  assign select_3854 = equal_1489_s17_q ? box_explained_columns_values_3_q : (so_s17_q ? select_3852 : box_explained_columns_values_3_q);
  logic [2:0] select_3855;
  assign select_3855 = ends_cell_s17_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3857;
  assign select_3857 = equal_1489_s17_q ? box_explained_columns_values_4_q : (so_s17_q ? select_3855 : box_explained_columns_values_4_q);
  logic [2:0] select_3862;
  assign select_3862 = so_s17_q ? (ends_cell_s17_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3864;
  assign select_3864 = ends_cell_s17_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3866;
  assign select_3866 = equal_1489_s17_q ? box_shown_columns_values_1_q : (so_s17_q ? select_3864 : box_shown_columns_values_1_q);
  logic [2:0] select_3867;
  assign select_3867 = ends_cell_s17_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3869;
  assign select_3869 = equal_1489_s17_q ? box_shown_columns_values_2_q : (so_s17_q ? select_3867 : box_shown_columns_values_2_q);
  logic [2:0] select_3870;
  assign select_3870 = ends_cell_s17_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3872;
  assign select_3872 = equal_1489_s17_q ? box_shown_columns_values_3_q : (so_s17_q ? select_3870 : box_shown_columns_values_3_q);
  logic [2:0] select_3873;
  assign select_3873 = ends_cell_s17_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3875;
  assign select_3875 = equal_1489_s17_q ? box_shown_columns_values_4_q : (so_s17_q ? select_3873 : box_shown_columns_values_4_q);
  logic [2:0] select_3880;
  assign select_3880 = so_s17_q ? (ends_cell_s17_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3882;
  assign select_3882 = ends_cell_s17_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3884;
  assign select_3884 = equal_1489_s17_q ? box_nearer_columns_values_1_q : (so_s17_q ? select_3882 : box_nearer_columns_values_1_q);
  logic [2:0] select_3885;
  assign select_3885 = ends_cell_s17_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3887;
  assign select_3887 = equal_1489_s17_q ? box_nearer_columns_values_2_q : (so_s17_q ? select_3885 : box_nearer_columns_values_2_q);
  logic [2:0] select_3888;
  assign select_3888 = ends_cell_s17_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3890;
  assign select_3890 = equal_1489_s17_q ? box_nearer_columns_values_3_q : (so_s17_q ? select_3888 : box_nearer_columns_values_3_q);
  logic [2:0] select_3891;
  assign select_3891 = ends_cell_s17_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3893;
  assign select_3893 = equal_1489_s17_q ? box_nearer_columns_values_4_q : (so_s17_q ? select_3891 : box_nearer_columns_values_4_q);

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1471_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1470_s17_q, select_1467_s17_q, select_1464_s17_q, select_1462_s17_q, select_1444_s17_q, select_1441_s17_q, select_1433_s17_q, select_1432_s17_q, select_1427_s17_q};
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
  assign best_right_we = s17_en & and_1471_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1488_s17_q, select_1487_s17_q, select_1484_s17_q, select_1483_s17_q};
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

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s17_q, and_1624_s17_q};
  logic patches_choices_we;
  assign patches_choices_we = s17_en & and_1707_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= select_1700;
  end
`ifndef SYNTHESIS
  logic [5:0] patches_choices_raddr_s16_sim;
  logic patches_choices_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choices_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      patches_choices_re_s16_sim <= patches_choices_re;
      patches_choices_raddr_s16_sim <= patches_choices_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_choices_we) begin
      if (patches_choices_re && patches_choices_raddr == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
      if (patches_choices_re_s16_sim && patches_choices_raddr_s16_sim == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_explained_q <= 14'h0;
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
      patches_read_far_q <= 10'h3ff;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      segment_started_q <= 1'b0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s17_en) begin
      counts_explained_q <= select_2451;
      patches_fixed_q <= not_2798 & (patches_fixed_q | (and_2808_s17_q & and_1666));
      patches_choice_valid_q <= and_1706_s17_q ? (select_1700[0] & not_2798) : select_1700[0];
      patches_choice_column_q <= select_1700[8:1];
      patches_choice_shift_q <= select_1700[14:9];
      patches_choice_slope_q <= select_1700[22:15];
      patches_left_row_q <= select_2970;
      patches_summed_row_column_q <= equal_1708_s17_q ? patches_summed_row_column_q : select_3315;
      patches_read_far_q <= equal_1708_s17_q ? select_3395 : patches_read_far_q;
      segment_textured_q <= select_1911 + {6'h0, and_2444_s17_q};
      segment_explained_q <= select_1916 + {6'h0, and_2449};
      segment_nearer_q <= select_1926 + {6'h0, and_2454};
      segment_started_q <= ~segment_starts_q;
      product_q <= equal_1489_s17_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_1941;
      columns_passed_q <= {select_1943[7:0], or_1939};
      line_ended_q <= marks_last_s17_q;
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
    if (s17_en) begin
      census_columns_values_0_cell_0_mask_q <= select_2104;
      census_columns_values_1_cell_0_mask_q <= select_2120;
      census_columns_values_1_cell_1_mask_q <= select_2123;
      census_columns_values_1_cell_2_mask_q <= select_2126;
      census_columns_values_1_cell_3_mask_q <= select_2130;
      census_columns_values_1_cell_4_mask_q <= select_2133;
      census_columns_values_2_cell_0_mask_q <= select_2136;
      census_columns_values_2_cell_1_mask_q <= select_2139;
      box_explained_columns_values_0_q <= select_3845;
      box_explained_columns_values_1_q <= select_3848;
      box_explained_columns_values_2_q <= select_3851;
      box_explained_columns_values_3_q <= select_3854;
      box_explained_columns_values_4_q <= select_3857;
      box_shown_columns_values_0_q <= equal_1489_s17_q ? box_shown_columns_values_0_q : select_3862;
      box_shown_columns_values_1_q <= select_3866;
      box_shown_columns_values_2_q <= select_3869;
      box_shown_columns_values_3_q <= select_3872;
      box_shown_columns_values_4_q <= select_3875;
      box_nearer_columns_values_0_q <= equal_1489_s17_q ? box_nearer_columns_values_0_q : select_3880;
      box_nearer_columns_values_1_q <= select_3884;
      box_nearer_columns_values_2_q <= select_3887;
      box_nearer_columns_values_3_q <= select_3890;
      box_nearer_columns_values_4_q <= select_3893;
    end
  end

  logic [7:0] pixel_0_s18_q;
  logic [7:0] pixel_1_s18_q;
  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic [7:0] sample_pair_pixel_0_s18_q;
  logic [7:0] sample_pair_pixel_1_s18_q;
  logic sample_pair_whole_s18_q;
  logic sample_present_s18_q;
  logic census_columns_values_1_cell_2_mask_s18_q;
  logic census_columns_values_1_cell_2_of_skin_s18_q;
  logic census_columns_values_1_cell_3_mask_s18_q;
  logic census_columns_values_1_cell_4_mask_s18_q;
  logic census_columns_values_2_cell_0_mask_s18_q;
  logic census_columns_values_2_cell_1_mask_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic [2:0] slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic [13:0] counts_textured_s18_q;
  logic [13:0] counts_explained_s18_q;
  logic registration_of_right_s18_q;
  logic patches_lower_s18_q;
  logic patches_second_s18_q;
  logic [4:0] patches_code_row_s18_q;
  logic [4:0] patches_summed_row_column_s18_q;
  logic patches_summed_last_s18_q;
  logic [4:0] patches_summed_down_by_s18_q;
  logic patches_read_first_s18_q;
  logic [9:0] patches_read_far_s18_q;
  logic [2:0] region_row_s18_q;
  logic [13:0] product_s18_q;
  logic centres_values_1_textured_s18_q;
  logic centres_values_1_of_skin_s18_q;
  logic [3:0] select_485_s18_q;
  logic [6:0] select_488_s18_q;
  logic [6:0] column_s18_q;
  logic and_522_s18_q;
  logic and_524_s18_q;
  logic equal_527_s18_q;
  logic whole_2_s18_q;
  logic so_s18_q;
  logic less_558_s18_q;
  logic less_559_s18_q;
  logic less_560_s18_q;
  logic less_561_s18_q;
  logic less_562_s18_q;
  logic less_563_s18_q;
  logic less_564_s18_q;
  logic less_565_s18_q;
  logic less_566_s18_q;
  logic less_567_s18_q;
  logic less_568_s18_q;
  logic less_569_s18_q;
  logic less_570_s18_q;
  logic less_571_s18_q;
  logic less_572_s18_q;
  logic less_573_s18_q;
  logic less_574_s18_q;
  logic less_575_s18_q;
  logic less_576_s18_q;
  logic less_577_s18_q;
  logic less_578_s18_q;
  logic less_579_s18_q;
  logic less_580_s18_q;
  logic less_581_s18_q;
  logic and_589_s18_q;
  logic whole_9_s18_q;
  logic [10:0] sum_622_s18_q;
  logic [9:0] sum_625_s18_q;
  logic [9:0] sum_629_s18_q;
  logic [9:0] sum_633_s18_q;
  logic equal_1489_s18_q;
  logic not_1490_s18_q;
  logic equal_1530_s18_q;
  logic all_s18_q;
  logic [1:0] sum_1536_s18_q;
  logic equal_1538_s18_q;
  logic equal_1540_s18_q;
  logic equal_1542_s18_q;
  logic equal_1544_s18_q;
  logic equal_1546_s18_q;
  logic equal_1548_s18_q;
  logic equal_1550_s18_q;
  logic equal_1552_s18_q;
  logic less_1561_s18_q;
  logic or_1565_s18_q;
  logic [31:0] registration_sums_rdata_s18_q;
  logic equal_1585_s18_q;
  logic and_1595_s18_q;
  logic and_1598_s18_q;
  logic select_1615_s18_q;
  logic equal_1616_s18_q;
  logic equal_1626_s18_q;
  logic equal_1649_s18_q;
  logic equal_1708_s18_q;
  logic equal_1710_s18_q;
  logic equal_1713_s18_q;
  logic or_1714_s18_q;
  logic [22:0] select_1724_s18_q;
  logic [4:0] select_1738_s18_q;
  logic select_1744_s18_q;
  logic [3:0] select_1783_s18_q;
  logic less_1799_s18_q;
  logic new_row_s18_q;
  logic [1:0] of_row_2_s18_q;
  logic less_1829_s18_q;
  logic less_1830_s18_q;
  logic less_1839_s18_q;
  logic less_1840_s18_q;
  logic and_1854_s18_q;
  logic and_1863_s18_q;
  logic and_1868_s18_q;
  logic less_1869_s18_q;
  logic equal_1870_s18_q;
  logic not_1871_s18_q;
  logic equal_1872_s18_q;
  logic or_1890_s18_q;
  logic or_1893_s18_q;
  logic or_1896_s18_q;
  logic not_1898_s18_q;
  logic [9:0] sum_1914_s18_q;
  logic [9:0] sum_1919_s18_q;
  logic [9:0] sum_1929_s18_q;
  logic and_1930_s18_q;
  logic select_1945_s18_q;
  logic [2:0] textured_2_s18_q;
  logic or_1988_s18_q;
  logic or_1991_s18_q;
  logic or_1994_s18_q;
  logic [3:0] difference_2014_s18_q;
  logic [3:0] difference_2030_s18_q;
  logic and_2044_s18_q;
  logic [10:0] size_s18_q;
  logic [10:0] size_2_s18_q;
  logic [10:0] sum_2165_s18_q;
  logic [9:0] sum_2168_s18_q;
  logic [9:0] sum_2172_s18_q;
  logic [9:0] sum_2176_s18_q;
  logic equal_2184_s18_q;
  logic [8:0] contrast_s18_q;
  logic [8:0] contrast_2_s18_q;
  logic equal_2308_s18_q;
  logic and_2433_s18_q;
  logic and_2439_s18_q;
  logic and_2454_s18_q;
  logic not_2458_s18_q;
  logic [3:0] difference_2468_s18_q;
  logic [9:0] select_2484_s18_q;
  logic [9:0] select_2487_s18_q;
  logic and_2535_s18_q;
  logic and_2569_s18_q;
  logic and_2570_s18_q;
  logic [7:0] residual_s18_q;
  logic and_2606_s18_q;
  logic and_2620_s18_q;
  logic equal_2663_s18_q;
  logic [27:0] word_s18_q;
  logic equal_2929_s18_q;
  logic less_2935_s18_q;
  logic [47:0] select_2968_s18_q;
  logic equal_3278_s18_q;
  logic [4:0] select_3366_s18_q;
  logic [14:0] select_3397_s18_q;
  logic less_3440_s18_q;
  logic [9:0] eight_s18_q;
  logic [9:0] fall_2_s18_q;
  logic equal_3518_s18_q;
  logic and_3747_s18_q;
  logic less_3748_s18_q;
  logic equal_3749_s18_q;
  logic equal_3765_s18_q;
  logic equal_3767_s18_q;
  logic equal_3768_s18_q;
  logic equal_3769_s18_q;
  logic equal_3770_s18_q;
  logic sum_4_s18_q;
  logic equal_3910_s18_q;
  logic equal_4004_s18_q;
  logic [9:0] select_4014_s18_q;
  always_ff @(posedge clk_i) begin
    if (s17_en) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      sample_pair_pixel_0_s18_q <= sample_pair_pixel_0_s17_q;
      sample_pair_pixel_1_s18_q <= sample_pair_pixel_1_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      sample_present_s18_q <= sample_present_s17_q;
      census_columns_values_1_cell_2_mask_s18_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s18_q <= census_columns_values_1_cell_2_of_skin_s17_q;
      census_columns_values_1_cell_3_mask_s18_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s18_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s18_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s18_q <= census_columns_values_2_cell_1_mask_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      slot_s18_q <= slot_s17_q;
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      counts_textured_s18_q <= counts_textured_s17_q;
      counts_explained_s18_q <= counts_explained_q;
      registration_of_right_s18_q <= registration_of_right_s17_q;
      patches_lower_s18_q <= patches_lower_s17_q;
      patches_second_s18_q <= patches_second_s17_q;
      patches_code_row_s18_q <= patches_code_row_s17_q;
      patches_summed_row_column_s18_q <= patches_summed_row_column_q;
      patches_summed_last_s18_q <= patches_summed_last_s17_q;
      patches_summed_down_by_s18_q <= patches_summed_down_by_s17_q;
      patches_read_first_s18_q <= patches_read_first_s17_q;
      patches_read_far_s18_q <= patches_read_far_q;
      region_row_s18_q <= region_row_s17_q;
      product_s18_q <= product_q;
      centres_values_1_textured_s18_q <= centres_values_1_textured_s17_q;
      centres_values_1_of_skin_s18_q <= centres_values_1_of_skin_s17_q;
      select_485_s18_q <= select_485_s17_q;
      select_488_s18_q <= select_488_s17_q;
      column_s18_q <= column_s17_q;
      and_522_s18_q <= and_522_s17_q;
      and_524_s18_q <= and_524_s17_q;
      equal_527_s18_q <= equal_527_s17_q;
      whole_2_s18_q <= whole_2_s17_q;
      so_s18_q <= so_s17_q;
      less_558_s18_q <= less_558_s17_q;
      less_559_s18_q <= less_559_s17_q;
      less_560_s18_q <= less_560_s17_q;
      less_561_s18_q <= less_561_s17_q;
      less_562_s18_q <= less_562_s17_q;
      less_563_s18_q <= less_563_s17_q;
      less_564_s18_q <= less_564_s17_q;
      less_565_s18_q <= less_565_s17_q;
      less_566_s18_q <= less_566_s17_q;
      less_567_s18_q <= less_567_s17_q;
      less_568_s18_q <= less_568_s17_q;
      less_569_s18_q <= less_569_s17_q;
      less_570_s18_q <= less_570_s17_q;
      less_571_s18_q <= less_571_s17_q;
      less_572_s18_q <= less_572_s17_q;
      less_573_s18_q <= less_573_s17_q;
      less_574_s18_q <= less_574_s17_q;
      less_575_s18_q <= less_575_s17_q;
      less_576_s18_q <= less_576_s17_q;
      less_577_s18_q <= less_577_s17_q;
      less_578_s18_q <= less_578_s17_q;
      less_579_s18_q <= less_579_s17_q;
      less_580_s18_q <= less_580_s17_q;
      less_581_s18_q <= less_581_s17_q;
      and_589_s18_q <= and_589_s17_q;
      whole_9_s18_q <= whole_9;
      sum_622_s18_q <= {1'b0, sum_618} + {1'b0, sum_621};
      sum_625_s18_q <= {9'h0, difference_623_s17_q} + {1'b0, xor_624_s17_q};
      sum_629_s18_q <= {9'h0, difference_627_s17_q} + {1'b0, xor_628_s17_q};
      sum_633_s18_q <= {9'h0, difference_631_s17_q} + {1'b0, xor_632_s17_q};
      equal_1489_s18_q <= equal_1489_s17_q;
      not_1490_s18_q <= not_1490_s17_q;
      equal_1530_s18_q <= equal_1530_s17_q;
      all_s18_q <= all_s17_q;
      sum_1536_s18_q <= sum_1536_s17_q;
      equal_1538_s18_q <= equal_1538_s17_q;
      equal_1540_s18_q <= equal_1540_s17_q;
      equal_1542_s18_q <= equal_1542_s17_q;
      equal_1544_s18_q <= equal_1544_s17_q;
      equal_1546_s18_q <= equal_1546_s17_q;
      equal_1548_s18_q <= equal_1548_s17_q;
      equal_1550_s18_q <= equal_1550_s17_q;
      equal_1552_s18_q <= equal_1552_s17_q;
      less_1561_s18_q <= less_1561_s17_q;
      or_1565_s18_q <= or_1565_s17_q;
      registration_sums_rdata_s18_q <= registration_sums_rdata_q;
      equal_1585_s18_q <= equal_1585_s17_q;
      and_1595_s18_q <= and_1595_s17_q;
      and_1598_s18_q <= and_1598_s17_q;
      select_1615_s18_q <= select_1615_s17_q;
      equal_1616_s18_q <= equal_1616_s17_q;
      equal_1626_s18_q <= equal_1626_s17_q;
      equal_1649_s18_q <= equal_1649_s17_q;
      equal_1708_s18_q <= equal_1708_s17_q;
      equal_1710_s18_q <= equal_1710_s17_q;
      equal_1713_s18_q <= equal_1713_s17_q;
      or_1714_s18_q <= or_1714_s17_q;
      select_1724_s18_q <= and_1723_s17_q ? select_1700 : patches_choices_rdata_s17_q;
      select_1738_s18_q <= select_1738_s17_q;
      select_1744_s18_q <= select_1744_s17_q;
      select_1783_s18_q <= select_1783_s17_q;
      less_1799_s18_q <= less_1799_s17_q;
      new_row_s18_q <= new_row_s17_q;
      of_row_2_s18_q <= of_row_2_s17_q;
      less_1829_s18_q <= $signed(15'h100) < $signed(sum_1828);
      less_1830_s18_q <= $signed(sum_1828[14:8]) < $signed(7'h7f);
      less_1839_s18_q <= $signed(15'h100) < $signed(difference_1838_s17_q);
      less_1840_s18_q <= $signed(difference_1838_s17_q[14:8]) < $signed(7'h7f);
      and_1854_s18_q <= and_1854_s17_q;
      and_1863_s18_q <= and_1863_s17_q;
      and_1868_s18_q <= and_1868_s17_q;
      less_1869_s18_q <= less_1869_s17_q;
      equal_1870_s18_q <= equal_1870_s17_q;
      not_1871_s18_q <= not_1871_s17_q;
      equal_1872_s18_q <= equal_1872_s17_q;
      or_1890_s18_q <= or_1890_s17_q;
      or_1893_s18_q <= or_1893_s17_q;
      or_1896_s18_q <= or_1896_s17_q;
      not_1898_s18_q <= not_1898_s17_q;
      sum_1914_s18_q <= sum_1914;
      sum_1919_s18_q <= sum_1919;
      sum_1929_s18_q <= sum_1929;
      and_1930_s18_q <= and_1930_s17_q;
      select_1945_s18_q <= select_1945;
      textured_2_s18_q <= textured_2;
      or_1988_s18_q <= or_1988_s17_q;
      or_1991_s18_q <= or_1991_s17_q;
      or_1994_s18_q <= or_1994_s17_q;
      difference_2014_s18_q <= {1'b0, shown_2} - {1'b0, select_2013};
      difference_2030_s18_q <= {1'b0, near_2} - {1'b0, select_2029};
      and_2044_s18_q <= and_2044_s17_q;
      size_s18_q <= size;
      size_2_s18_q <= size_2;
      sum_2165_s18_q <= {1'b0, sum_2161} + {1'b0, sum_2164};
      sum_2168_s18_q <= {9'h0, difference_2166_s17_q} + {1'b0, xor_2167_s17_q};
      sum_2172_s18_q <= {9'h0, difference_2170_s17_q} + {1'b0, xor_2171_s17_q};
      sum_2176_s18_q <= {9'h0, difference_2174_s17_q} + {1'b0, xor_2175_s17_q};
      equal_2184_s18_q <= equal_2184_s17_q;
      contrast_s18_q <= contrast;
      contrast_2_s18_q <= contrast_2;
      equal_2308_s18_q <= equal_2308_s17_q;
      and_2433_s18_q <= and_2433_s17_q;
      and_2439_s18_q <= and_2439_s17_q;
      and_2454_s18_q <= and_2454;
      not_2458_s18_q <= not_2458_s17_q;
      difference_2468_s18_q <= {1'b0, explained_2_s17_q} - {1'b0, select_2467};
      select_2484_s18_q <= less_2483 ? 10'h0 : regions_rdata_s17_q[9:0];
      select_2487_s18_q <= less_2483 ? 10'h0 : regions_rdata_s17_q[19:10];
      and_2535_s18_q <= and_2535_s17_q;
      and_2569_s18_q <= and_2569_s17_q;
      and_2570_s18_q <= and_2570_s17_q;
      residual_s18_q <= residual_s17_q;
      and_2606_s18_q <= and_2570_s17_q & less_2605_s17_q;
      and_2620_s18_q <= and_2570_s17_q & less_2619_s17_q;
      equal_2663_s18_q <= equal_2663_s17_q;
      word_s18_q <= word;
      equal_2929_s18_q <= patches_along_s17_q == 5'h7;
      less_2935_s18_q <= less_2935_s17_q;
      select_2968_s18_q <= select_2968;
      equal_3278_s18_q <= equal_3278_s17_q;
      select_3366_s18_q <= select_3366_s17_q;
      select_3397_s18_q <= select_3397_s17_q;
      less_3440_s18_q <= less_3440_s17_q;
      eight_s18_q <= eight;
      fall_2_s18_q <= fall_2;
      equal_3518_s18_q <= equal_3518_s17_q;
      and_3747_s18_q <= and_3747_s17_q;
      less_3748_s18_q <= counts_explained_q < product_q;
      equal_3749_s18_q <= counts_explained_q == product_q;
      equal_3765_s18_q <= equal_3765_s17_q;
      equal_3767_s18_q <= equal_3767_s17_q;
      equal_3768_s18_q <= equal_3768_s17_q;
      equal_3769_s18_q <= equal_3769_s17_q;
      equal_3770_s18_q <= equal_3770_s17_q;
      sum_4_s18_q <= sum_4[0];
      equal_3910_s18_q <= equal_3910_s17_q;
      equal_4004_s18_q <= equal_4004_s17_q;
      select_4014_s18_q <= less_2483 ? 10'h0 : regions_rdata_s17_q[29:20];
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
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
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_nearer_q;
  logic [5:0] registration_half_measured_q;
  logic [6:0] registration_half_votes_up_q;
  logic [6:0] registration_half_half_votes_up_q;
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
  logic product_rest_q;
  logic disagree_q;
  logic [2:0] box_textured_columns_values_0_q;
  logic [2:0] box_textured_columns_values_1_q;
  logic [2:0] box_textured_columns_values_2_q;
  logic [2:0] box_textured_columns_values_3_q;
  logic [2:0] box_textured_columns_values_4_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic began_q;
  logic [3:0] seen_x_q;
  logic [3:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/agreement.hpp:450
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s18_q & whole_9_s18_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s18_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s18_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s18_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s18_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:270
  logic [10:0] sum_626;
  assign sum_626 = sum_622_s18_q + {1'b0, sum_625_s18_q};
  // hls/stages/registration.hpp:265
  logic equal_1587;
  assign equal_1587 = sum_1536_s18_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1536_s18_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1593;
  assign select_1593 = equal_1587 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1594;
  assign sum_1594 = (equal_1585_s18_q ? registration_sums_rdata_s18_q[31:20] : 12'h0) + {{5{select_1593[6]}}, select_1593};
  // hls/stages/patches.hpp:353
  logic [21:0] select_1727;
  assign select_1727 = select_1615_s18_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1724_s18_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1728;
  assign select_1728 = equal_1616_s18_q ? patches_place_0_column_q : select_1727[7:0];
  logic [5:0] select_1729;
  assign select_1729 = equal_1616_s18_q ? patches_place_0_shift_q : select_1727[13:8];
  // hls/stages/patches.hpp:353
  logic [21:0] select_1756;
  assign select_1756 = select_1615_s18_q ? select_1724_s18_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1757;
  assign select_1757 = equal_1616_s18_q ? patches_place_1_column_q : select_1756[7:0];
  logic [5:0] select_1758;
  assign select_1758 = equal_1616_s18_q ? patches_place_1_shift_q : select_1756[13:8];
  // hls/stages/patches.hpp:132
  logic equal_1774;
  assign equal_1774 = {select_1728[7], select_488_s18_q, select_485_s18_q} == {1'b0, select_1728[6:0], 4'h0};
  logic equal_1778;
  assign equal_1778 = {select_1757[7], select_488_s18_q, select_485_s18_q} == {1'b0, select_1757[6:0], 4'h0};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_1820;
  assign sum_1820 = patches_code_row_s18_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_1858;
  assign sum_1858 = patches_code_row_s18_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:429
  logic next_row;
  assign next_row = select_1945_s18_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1262
  logic [6:0] select_1948;
  assign select_1948 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1272
  logic equal_1951;
  assign equal_1951 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1245
  logic not_1958;
  assign not_1958 = ~marks_first_s18_q;
  // hls/stages/agreement.hpp:1070
  logic [2:0] select_1979;
  assign select_1979 = age_s18_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1077
  logic not_1995;
  assign not_1995 = ~region_row_s18_q[2];
  logic [2:0] select_1996;
  assign select_1996 = region_row_s18_q[1] ? {1'b0, not_1995, 1'b0} : {region_row_s18_q[2], 1'b0, not_1995};
  logic [5:0] select_1997;
  assign select_1997 = region_row_s18_q[0] ? {select_1996[2], 1'b0, select_1996[1], 1'b0, select_1996[0], 1'b0} : {1'b0, select_1996[2], 1'b0, select_1996[1], 1'b0, select_1996[0]};
  logic [11:0] select_1998;
  assign select_1998 = or_1994_s18_q ? {select_1997[5], 1'b0, select_1997[4], 1'b0, select_1997[3], 1'b0, select_1997[2], 1'b0, select_1997[1], 1'b0, select_1997[0], 1'b0} : {1'b0, select_1997[5], 1'b0, select_1997[4], 1'b0, select_1997[3], 1'b0, select_1997[2], 1'b0, select_1997[1], 1'b0, select_1997[0]};
  logic [23:0] select_1999;
  assign select_1999 = or_1991_s18_q ? {select_1998[11], 1'b0, select_1998[10], 1'b0, select_1998[9], 1'b0, select_1998[8], 1'b0, select_1998[7], 1'b0, select_1998[6], 1'b0, select_1998[5], 1'b0, select_1998[4], 1'b0, select_1998[3], 1'b0, select_1998[2], 1'b0, select_1998[1], 1'b0, select_1998[0], 1'b0} : {1'b0, select_1998[11], 1'b0, select_1998[10], 1'b0, select_1998[9], 1'b0, select_1998[8], 1'b0, select_1998[7], 1'b0, select_1998[6], 1'b0, select_1998[5], 1'b0, select_1998[4], 1'b0, select_1998[3], 1'b0, select_1998[2], 1'b0, select_1998[1], 1'b0, select_1998[0]};
  // hls/stages/agreement.hpp:1072
  logic [4:0] around;
  assign around = {difference_2014_s18_q[3], difference_2014_s18_q} + (equal_1649_s18_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1073
  logic [4:0] n;
  assign n = {difference_2030_s18_q[3], difference_2030_s18_q} + (equal_1649_s18_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s18_q} + (equal_527_s18_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:270
  logic [13:0] select_2086;
  assign select_2086 = sample_pair_whole_s18_q ? (and_522_s18_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s18_q} + (equal_527_s18_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:270
  logic [13:0] select_2094;
  assign select_2094 = sample_pair_whole_s18_q ? (and_522_s18_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:514
  logic select_2142;
  assign select_2142 = and_524_s18_q ? census_columns_values_1_cell_2_mask_s18_q : census_columns_values_2_cell_2_mask_q;
  logic select_2145;
  assign select_2145 = and_524_s18_q ? census_columns_values_1_cell_3_mask_s18_q : census_columns_values_2_cell_3_mask_q;
  logic select_2148;
  assign select_2148 = and_524_s18_q ? census_columns_values_1_cell_4_mask_s18_q : census_columns_values_2_cell_4_mask_q;
  logic select_2149;
  assign select_2149 = and_524_s18_q ? census_columns_values_2_cell_0_mask_s18_q : census_columns_values_3_cell_0_mask_q;
  logic select_2152;
  assign select_2152 = and_524_s18_q ? census_columns_values_2_cell_1_mask_s18_q : census_columns_values_3_cell_1_mask_q;
  logic select_2153;
  assign select_2153 = and_524_s18_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2156;
  assign select_2156 = and_524_s18_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_2169;
  assign sum_2169 = sum_2165_s18_q + {1'b0, sum_2168_s18_q};
  // hls/stages/agreement.hpp:514
  logic select_2201;
  assign select_2201 = and_524_s18_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2204;
  assign and_2204 = whole_2_s18_q & (~(column_s18_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:451
  logic and_2210;
  assign and_2210 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s18_q[8:2]));
  logic and_2211;
  assign and_2211 = and_2204 & and_2210;
  logic and_2222;
  assign and_2222 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s18_q[8:2]));
  logic and_2223;
  assign and_2223 = and_2204 & and_2222;
  // hls/stages/census.hpp:409
  logic not_2240;
  assign not_2240 = ~x_s18_q[1];
  logic [2:0] select_2241;
  assign select_2241 = x_s18_q[0] ? {1'b0, not_2240, 1'b0} : {x_s18_q[1], 1'b0, not_2240};
  logic [5:0] select_2242;
  assign select_2242 = slot_s18_q[2] ? {select_2241[2], 1'b0, select_2241[1], 1'b0, select_2241[0], 1'b0} : {1'b0, select_2241[2], 1'b0, select_2241[1], 1'b0, select_2241[0]};
  logic [11:0] select_2243;
  assign select_2243 = slot_s18_q[1] ? {select_2242[5], 1'b0, select_2242[4], 1'b0, select_2242[3], 1'b0, select_2242[2], 1'b0, select_2242[1], 1'b0, select_2242[0], 1'b0} : {1'b0, select_2242[5], 1'b0, select_2242[4], 1'b0, select_2242[3], 1'b0, select_2242[2], 1'b0, select_2242[1], 1'b0, select_2242[0]};
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2441;
  assign select_2441 = and_2433_s18_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2439_s18_q});
  logic [13:0] select_2456;
  assign select_2456 = and_2433_s18_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2454_s18_q});
  // hls/stages/agreement.hpp:1071
  logic [4:0] e;
  assign e = {difference_2468_s18_q[3], difference_2468_s18_q} + (equal_1649_s18_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/registration.hpp:107
  logic [7:0] select_2587;
  assign select_2587 = equal_1626_s18_q ? (and_2570_s18_q ? residual_s18_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:780
  logic and_2594;
  assign and_2594 = not_1490_s18_q & (so_s18_q & (and_2570_s18_q & equal_1626_s18_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2596;
  assign select_2596 = and_2569_s18_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2594});
  // hls/stages/registration.hpp:107
  logic and_2598;
  assign and_2598 = and_2570_s18_q & ($signed(residual_s18_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:780
  logic [1:0] select_2600;
  assign select_2600 = so_s18_q ? (equal_1626_s18_q ? {and_2598, and_2570_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2608;
  assign select_2608 = so_s18_q ? (equal_1626_s18_q ? {and_2606_s18_q, and_2570_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2609;
  assign select_2609 = equal_1489_s18_q ? 2'h0 : select_2608;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2610;
  assign sum_2610 = registration_half_votes_up_q + {{5{select_2609[1]}}, select_2609};
  // hls/stages/registration.hpp:205
  logic less_2612;
  assign less_2612 = $signed(residual_s18_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2613;
  assign and_2613 = and_2570_s18_q & less_2612;
  // hls/stages/agreement.hpp:780
  logic [1:0] select_2615;
  assign select_2615 = so_s18_q ? (equal_1626_s18_q ? {and_2613, and_2570_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2622;
  assign select_2622 = so_s18_q ? (equal_1626_s18_q ? {and_2620_s18_q, and_2570_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2623;
  assign select_2623 = equal_1489_s18_q ? 2'h0 : select_2622;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2624;
  assign sum_2624 = registration_half_half_votes_up_q + {{5{select_2623[1]}}, select_2623};
  // hls/stages/agreement.hpp:1106
  logic [11:0] select_2665;
  assign select_2665 = or_1565_s18_q ? 12'h0 : (equal_2663_s18_q ? registration_sums_rdata_s18_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1118
  logic [11:0] select_2667;
  assign select_2667 = equal_1530_s18_q ? 12'h0 : (less_1561_s18_q ? select_2665 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2670;
  assign and_2670 = x_s18_q[1] & all_s18_q;
  // hls/stages/agreement.hpp:1118
  logic and_2673;
  assign and_2673 = not_1898_s18_q & (less_1561_s18_q & ({and_2670, x_s18_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1106
  logic [11:0] select_2680;
  assign select_2680 = or_1565_s18_q ? 12'h0 : (equal_2663_s18_q ? registration_sums_rdata_s18_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1118
  logic [11:0] select_2682;
  assign select_2682 = equal_1530_s18_q ? 12'h0 : (less_1561_s18_q ? select_2680 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2688;
  assign not_2688 = ~all_s18_q;
  // hls/stages/agreement.hpp:1118
  logic and_2691;
  assign and_2691 = not_1898_s18_q & (less_1561_s18_q & (x_s18_q[2:0] == {all_s18_q, not_2688, 1'b0}));
  // hls/stages/agreement.hpp:780
  logic and_2697;
  assign and_2697 = equal_1489_s18_q & (x_s18_q[6] & (not_1898_s18_q & (less_1561_s18_q & all_s18_q)));
  // hls/stages/registration.hpp:157
  logic equal_2724;
  assign equal_2724 = x_s18_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1118
  logic and_2727;
  assign and_2727 = not_1898_s18_q & (less_1561_s18_q & (x_s18_q[5] ? x_s18_q[3] : equal_2724));
  logic and_2736;
  assign and_2736 = not_1898_s18_q & (less_1561_s18_q & ((~x_s18_q[5]) & (x_s18_q[3] & equal_2724)));
  // hls/stages/agreement.hpp:270
  logic [7:0] select_2831;
  assign select_2831 = sample_pair_whole_s18_q ? (equal_1616_s18_q ? patches_place_0_slope_q : select_1727[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_2836;
  assign select_2836 = sample_pair_whole_s18_q ? (equal_1616_s18_q ? patches_place_1_slope_q : select_1756[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s18_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_2925;
  assign select_2925 = or_1714_s18_q ? {less_1840_s18_q, less_1839_s18_q, less_1830_s18_q, less_1829_s18_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2927;
  assign select_2927 = equal_1708_s18_q ? patches_codes_at_q : (equal_1710_s18_q ? other[55:4] : select_2925);
  // hls/stages/patches.hpp:516
  logic [27:0] select_2930;
  assign select_2930 = equal_2929_s18_q ? word_s18_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_2932;
  assign select_2932 = equal_1710_s18_q ? (new_row_s18_q ? word_s18_q : select_2930) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_2934;
  assign select_2934 = less_1799_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_2936;
  assign select_2936 = less_2935_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_2938;
  assign select_2938 = or_1714_s18_q ? (equal_1713_s18_q ? patches_next_codes_q : select_2936) : patches_next_codes_q;
  logic [55:0] select_2940;
  assign select_2940 = equal_1708_s18_q ? patches_next_codes_q : (equal_1710_s18_q ? select_2934 : select_2938);
  // hls/stages/count_bits.hpp:24
  logic parity_2945;
  assign parity_2945 = ^{less_1840_s18_q, less_1839_s18_q, less_1830_s18_q, less_1829_s18_q};
  // hls/stages/count_bits.hpp:25
  logic or_2949;
  assign or_2949 = ({less_1830_s18_q, less_1829_s18_q} == 2'h3) | (less_1839_s18_q & (less_1830_s18_q | less_1829_s18_q));
  logic and_2950;
  assign and_2950 = less_1840_s18_q & (^{less_1839_s18_q, less_1830_s18_q, less_1829_s18_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2951;
  assign xor_2951 = or_2949 ^ and_2950;
  // hls/stages/count_bits.hpp:27
  logic and_2952;
  assign and_2952 = or_2949 & and_2950;
  // hls/stages/patches.hpp:184
  logic [2:0] select_2954;
  assign select_2954 = or_1714_s18_q ? (and_1863_s18_q ? {and_2952, xor_2951, parity_2945} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2968_s18_q;
  // hls/stages/count_bits.hpp:24
  logic xor_2974;
  assign xor_2974 = bits[17] ^ (^{select_2968_s18_q[16:15], other[16:15]});
  logic xor_2977;
  assign xor_2977 = bits[11] ^ (^{select_2968_s18_q[10:9], other[10:9]});
  logic xor_2980;
  assign xor_2980 = bits[14] ^ (^{select_2968_s18_q[13:12], other[13:12]});
  logic xor_2983;
  assign xor_2983 = xor_2974 ^ (^{select_2968_s18_q[14:9], other[14:9]});
  logic xor_2986;
  assign xor_2986 = bits[47] ^ (^{select_2968_s18_q[46:45], other[46:45]});
  logic xor_2989;
  assign xor_2989 = bits[8] ^ (^{select_2968_s18_q[7:6], other[7:6]});
  logic xor_2992;
  assign xor_2992 = bits[2] ^ (^{select_2968_s18_q[1:0], other[1:0]});
  logic xor_2995;
  assign xor_2995 = bits[5] ^ (^{select_2968_s18_q[4:3], other[4:3]});
  logic xor_2998;
  assign xor_2998 = xor_2989 ^ (^{select_2968_s18_q[5:0], other[5:0]});
  logic parity_3000;
  assign parity_3000 = ^{select_2968_s18_q[47:45], select_2968_s18_q[8:0], other[47:45], other[8:0]};
  logic xor_3004;
  assign xor_3004 = bits[44] ^ (^{select_2968_s18_q[43:42], other[43:42]});
  logic xor_3007;
  assign xor_3007 = bits[38] ^ (^{select_2968_s18_q[37:36], other[37:36]});
  logic xor_3010;
  assign xor_3010 = bits[41] ^ (^{select_2968_s18_q[40:39], other[40:39]});
  logic xor_3016;
  assign xor_3016 = bits[26] ^ (^{select_2968_s18_q[25:24], other[25:24]});
  logic xor_3019;
  assign xor_3019 = bits[20] ^ (^{select_2968_s18_q[19:18], other[19:18]});
  logic xor_3022;
  assign xor_3022 = bits[23] ^ (^{select_2968_s18_q[22:21], other[22:21]});
  logic xor_3028;
  assign xor_3028 = bits[35] ^ (^{select_2968_s18_q[34:33], other[34:33]});
  logic xor_3031;
  assign xor_3031 = bits[29] ^ (^{select_2968_s18_q[28:27], other[28:27]});
  logic xor_3034;
  assign xor_3034 = bits[32] ^ (^{select_2968_s18_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:184
  logic select_3318;
  assign select_3318 = equal_1708_s18_q ? patches_summed_first_q : (equal_1710_s18_q ? new_row_s18_q : patches_summed_first_q);
  // hls/stages/patches.hpp:538
  logic [9:0] select_3406;
  assign select_3406 = (patches_read_far_s18_q < patches_peak_far_q) ? patches_read_far_s18_q : patches_peak_far_q;
  logic [9:0] select_3407;
  assign select_3407 = patches_read_first_s18_q ? patches_read_far_s18_q : select_3406;
  // hls/stages/patches.hpp:578
  logic [10:0] sum_3449;
  assign sum_3449 = {1'b0, fall_2_s18_q} + {2'h0, fall_2_s18_q[9:1]};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3453;
  assign sum_3453 = {1'b0, fall_2_s18_q} + {3'h0, fall_2_s18_q[9:2]};
  logic less_3457;
  assign less_3457 = {eight_s18_q, 3'h0} < ({fall_2_s18_q, 3'h0} - {3'h0, fall_2_s18_q});
  // hls/stages/patches.hpp:592
  logic [7:0] select_3463;
  assign select_3463 = patches_second_s18_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [3:0] sum_3464;
  assign sum_3464 = {2'h0, select_3397_s18_q[14:13]} + 4'hf;
  logic [5:0] select_3465;
  assign select_3465 = patches_second_s18_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3466;
  assign sum_3466 = {select_3465[5], select_3465} + {{4{sum_3464[3]}}, sum_3464[3:1]};
  // hls/stages/agreement.hpp:1160
  logic or_3744;
  assign or_3744 = ({counts_textured_s18_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s18_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1198
  logic too_little;
  assign too_little = less_3748_s18_q | (product_rest_q & equal_3749_s18_q);
  // hls/stages/agreement.hpp:1199
  logic select_3752;
  assign select_3752 = and_3747_s18_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1111
  logic [10:0] sum_3755;
  assign sum_3755 = {1'b0, select_2487_s18_q} + {2'h0, select_2487_s18_q[9:1]};
  // hls/stages/agreement.hpp:780
  logic select_3807;
  assign select_3807 = equal_1489_s18_q ? (equal_3518_s18_q ? sum_4_s18_q : (product_rest_q | sum_4_s18_q)) : product_rest_q;
  logic [2:0] select_3825;
  assign select_3825 = ends_cell_s18_q ? textured_2_s18_q : box_textured_columns_values_0_q;
  logic [2:0] select_3827;
  assign select_3827 = equal_1489_s18_q ? box_textured_columns_values_0_q : (so_s18_q ? select_3825 : box_textured_columns_values_0_q);
  logic [2:0] select_3828;
  assign select_3828 = ends_cell_s18_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3830;
  assign select_3830 = equal_1489_s18_q ? box_textured_columns_values_1_q : (so_s18_q ? select_3828 : box_textured_columns_values_1_q);
  logic [2:0] select_3831;
  assign select_3831 = ends_cell_s18_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3833;
  assign select_3833 = equal_1489_s18_q ? box_textured_columns_values_2_q : (so_s18_q ? select_3831 : box_textured_columns_values_2_q);
  logic [2:0] select_3834;
  assign select_3834 = ends_cell_s18_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3836;
  assign select_3836 = equal_1489_s18_q ? box_textured_columns_values_3_q : (so_s18_q ? select_3834 : box_textured_columns_values_3_q);
  logic [2:0] select_3837;
  assign select_3837 = ends_cell_s18_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3839;
  assign select_3839 = equal_1489_s18_q ? box_textured_columns_values_4_q : (so_s18_q ? select_3837 : box_textured_columns_values_4_q);
  logic [4:0] select_3859;
  assign select_3859 = so_s18_q ? (ends_cell_s18_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3860;
  assign select_3860 = equal_1489_s18_q ? box_explained_sum_sums_values_0_q : select_3859;
  logic [4:0] select_3877;
  assign select_3877 = so_s18_q ? (ends_cell_s18_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_3895;
  assign select_3895 = so_s18_q ? (ends_cell_s18_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1271
  logic [3:0] select_3927;
  assign select_3927 = select_1945_s18_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:429
  logic [7:0] select_3933;
  assign select_3933 = marks_first_s18_q ? (less_3929 ? {sum_3930, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1116
  logic [31:0] select_4006;
  assign select_4006 = equal_1552_s18_q ? {2'h0, counts_explained_s18_q, 2'h0, counts_textured_s18_q} : (equal_4004_s18_q ? registration_sums_rdata_s18_q : 32'h0);
  logic [31:0] select_4007;
  assign select_4007 = equal_1550_s18_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4006;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1820, patches_code_row_s18_q[1:0], of_row_2_s18_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s18_en & and_1854_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1840_s18_q, less_1839_s18_q, less_1830_s18_q, less_1829_s18_q, patches_codes_at_q[51:28]};
  end
`ifndef SYNTHESIS
  logic [6:0] patches_right_codes_raddr_s16_sim;
  logic patches_right_codes_re_s16_sim;
  logic [6:0] patches_right_codes_raddr_s17_sim;
  logic patches_right_codes_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_codes_re_s16_sim <= 1'b0;
      patches_right_codes_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_codes_re_s16_sim <= patches_right_codes_re;
      patches_right_codes_raddr_s16_sim <= patches_right_codes_raddr;
      patches_right_codes_re_s17_sim <= patches_right_codes_re_s16_sim;
      patches_right_codes_raddr_s17_sim <= patches_right_codes_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s16_sim && patches_right_codes_raddr_s16_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s17_sim && patches_right_codes_raddr_s17_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 7'd112) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 7'd112) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1858, patches_code_row_s18_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s18_en & and_1868_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1840_s18_q, less_1839_s18_q, less_1830_s18_q, less_1829_s18_q, patches_codes_at_q[51:8]};
  end
`ifndef SYNTHESIS
  logic [3:0] patches_left_codes_raddr_s16_sim;
  logic patches_left_codes_re_s16_sim;
  logic [3:0] patches_left_codes_raddr_s17_sim;
  logic patches_left_codes_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_codes_re_s16_sim <= 1'b0;
      patches_left_codes_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_codes_re_s16_sim <= patches_left_codes_re;
      patches_left_codes_raddr_s16_sim <= patches_left_codes_raddr;
      patches_left_codes_re_s17_sim <= patches_left_codes_re_s16_sim;
      patches_left_codes_raddr_s17_sim <= patches_left_codes_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s16_sim && patches_left_codes_raddr_s16_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s17_sim && patches_left_codes_raddr_s17_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s18_q, or_1896_s18_q, or_1893_s18_q, or_1890_s18_q};
  logic regions_we;
  assign regions_we = s18_en & and_1930_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1929_s18_q, sum_1919_s18_q, sum_1914_s18_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s16_sim;
  logic regions_re_s16_sim;
  logic [5:0] regions_raddr_s17_sim;
  logic regions_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s16_sim <= 1'b0;
      regions_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s16_sim <= regions_re;
      regions_raddr_s16_sim <= regions_raddr;
      regions_re_s17_sim <= regions_re_s16_sim;
      regions_raddr_s17_sim <= regions_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s16_sim && regions_raddr_s16_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s17_sim && regions_raddr_s17_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_before_last_mask_q <= 1'b0;
      counts_supervised_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      registration_half_measured_q <= 6'h0;
      registration_half_votes_up_q <= 7'h0;
      registration_half_half_votes_up_q <= 7'h0;
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
    end else if (s18_en) begin
      sharpness_before_last_mask_q <= select_2201;
      counts_supervised_q <= select_2441;
      counts_nearer_q <= select_2456;
      registration_half_measured_q <= select_2596;
      registration_half_votes_up_q <= and_2569_s18_q ? 7'h0 : sum_2610;
      registration_half_half_votes_up_q <= and_2569_s18_q ? 7'h0 : sum_2624;
      patches_place_0_column_q <= sample_pair_whole_s18_q ? select_1728 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s18_q ? select_1729 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2831;
      patches_place_1_column_q <= sample_pair_whole_s18_q ? select_1757 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s18_q ? select_1758 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2836;
      patches_codes_at_q <= select_2927;
      patches_codes_further_q <= equal_1708_s18_q ? patches_codes_further_q : select_2932;
      patches_next_codes_q <= select_2940;
      patches_summed_first_q <= select_3318;
      patches_peak_far_q <= equal_1708_s18_q ? select_3407 : patches_peak_far_q;
      product_rest_q <= select_3807;
      disagree_q <= equal_1489_s18_q ? select_3752 : disagree_q;
      began_q <= not_1958 & (began_q | select_1945_s18_q);
      seen_x_q <= select_1945_s18_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s18_q ? 4'h0 : select_3927;
      seen_column_q <= select_1945_s18_q ? 8'h0 : (seen_column_q + {7'h0, equal_1951});
      seen_rows_left_q <= select_3933;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s18_q ? 13'h0 : (seen_base_q + {6'h0, select_1948});
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
    if (s18_en) begin
      averager_detail_0_q <= select_2086;
      averager_detail_1_q <= select_2094;
      census_columns_values_2_cell_2_mask_q <= select_2142;
      census_columns_values_2_cell_3_mask_q <= select_2145;
      census_columns_values_2_cell_4_mask_q <= select_2148;
      census_columns_values_3_cell_0_mask_q <= select_2149;
      census_columns_values_3_cell_1_mask_q <= select_2152;
      census_columns_values_3_cell_2_mask_q <= select_2153;
      census_columns_values_3_cell_3_mask_q <= select_2156;
      sharpness_last_mask_q <= and_524_s18_q ? whole_2_s18_q : sharpness_last_mask_q;
      box_textured_columns_values_0_q <= select_3827;
      box_textured_columns_values_1_q <= select_3830;
      box_textured_columns_values_2_q <= select_3833;
      box_textured_columns_values_3_q <= select_3836;
      box_textured_columns_values_4_q <= select_3839;
      box_explained_sum_sums_values_0_q <= select_3860;
      box_shown_sum_sums_values_0_q <= equal_1489_s18_q ? box_shown_sum_sums_values_0_q : select_3877;
      box_nearer_sum_sums_values_0_q <= equal_1489_s18_q ? box_nearer_sum_sums_values_0_q : select_3895;
    end
  end

  logic [7:0] pixel_0_s19_q;
  logic [7:0] pixel_1_s19_q;
  logic saturated_s19_q;
  logic mask_s19_q;
  logic marks_first_s19_q;
  logic marks_last_s19_q;
  logic [7:0] sample_pair_pixel_0_s19_q;
  logic [7:0] sample_pair_pixel_1_s19_q;
  logic sample_pair_whole_s19_q;
  logic sample_present_s19_q;
  logic census_columns_values_1_cell_2_of_skin_s19_q;
  logic census_columns_values_2_cell_4_mask_s19_q;
  logic census_columns_values_3_cell_0_mask_s19_q;
  logic census_columns_values_3_cell_1_mask_s19_q;
  logic census_columns_values_3_cell_2_mask_s19_q;
  logic census_columns_values_3_cell_3_mask_s19_q;
  logic [6:0] x_s19_q;
  logic slot_s19_q;
  logic ends_cell_s19_q;
  logic lower_half_s19_q;
  logic [13:0] counts_nearer_s19_q;
  logic registration_of_right_s19_q;
  logic patches_lower_s19_q;
  logic patches_second_s19_q;
  logic [4:0] patches_summed_row_column_s19_q;
  logic patches_summed_first_s19_q;
  logic patches_summed_last_s19_q;
  logic [4:0] patches_summed_down_by_s19_q;
  logic [13:0] product_s19_q;
  logic centres_values_1_textured_s19_q;
  logic centres_values_1_of_skin_s19_q;
  logic [3:0] select_485_s19_q;
  logic [6:0] select_488_s19_q;
  logic [6:0] column_s19_q;
  logic and_524_s19_q;
  logic so_s19_q;
  logic less_558_s19_q;
  logic less_559_s19_q;
  logic less_560_s19_q;
  logic less_561_s19_q;
  logic less_562_s19_q;
  logic less_563_s19_q;
  logic less_564_s19_q;
  logic less_565_s19_q;
  logic less_566_s19_q;
  logic less_567_s19_q;
  logic less_568_s19_q;
  logic less_569_s19_q;
  logic less_570_s19_q;
  logic less_571_s19_q;
  logic less_572_s19_q;
  logic less_573_s19_q;
  logic less_574_s19_q;
  logic less_575_s19_q;
  logic less_576_s19_q;
  logic less_577_s19_q;
  logic less_578_s19_q;
  logic less_579_s19_q;
  logic less_580_s19_q;
  logic less_581_s19_q;
  logic and_589_s19_q;
  logic whole_16_s19_q;
  logic and_615_s19_q;
  logic [11:0] sum_630_s19_q;
  logic [9:0] sum_633_s19_q;
  logic equal_1489_s19_q;
  logic not_1490_s19_q;
  logic equal_1530_s19_q;
  logic [1:0] sum_1536_s19_q;
  logic equal_1538_s19_q;
  logic equal_1540_s19_q;
  logic equal_1542_s19_q;
  logic equal_1544_s19_q;
  logic equal_1546_s19_q;
  logic equal_1548_s19_q;
  logic less_1561_s19_q;
  logic [19:0] select_1586_s19_q;
  logic equal_1587_s19_q;
  logic [11:0] sum_1594_s19_q;
  logic and_1595_s19_q;
  logic and_1598_s19_q;
  logic select_1615_s19_q;
  logic equal_1616_s19_q;
  logic equal_1649_s19_q;
  logic equal_1708_s19_q;
  logic equal_1710_s19_q;
  logic equal_1713_s19_q;
  logic select_1724_s19_q;
  logic [7:0] sum_1730_s19_q;
  logic [4:0] select_1738_s19_q;
  logic select_1744_s19_q;
  logic [7:0] sum_1759_s19_q;
  logic equal_1774_s19_q;
  logic equal_1778_s19_q;
  logic [3:0] select_1783_s19_q;
  logic less_1869_s19_q;
  logic equal_1870_s19_q;
  logic not_1871_s19_q;
  logic equal_1872_s19_q;
  logic not_1898_s19_q;
  logic not_1958_s19_q;
  logic [7:0] sum_1968_s19_q;
  logic [3:0] difference_1980_s19_q;
  logic or_1988_s19_q;
  logic [23:0] select_1999_s19_q;
  logic [4:0] around_s19_q;
  logic less_2033_s19_q;
  logic and_2044_s19_q;
  logic [11:0] sum_2173_s19_q;
  logic [9:0] sum_2176_s19_q;
  logic equal_2184_s19_q;
  logic [27:0] select_2198_s19_q;
  logic and_2211_s19_q;
  logic and_2223_s19_q;
  logic [8:0] select_2230_s19_q;
  logic [8:0] select_2234_s19_q;
  logic equal_2237_s19_q;
  logic less_2238_s19_q;
  logic [11:0] select_2243_s19_q;
  logic equal_2281_s19_q;
  logic equal_2308_s19_q;
  logic and_2433_s19_q;
  logic not_2458_s19_q;
  logic [4:0] e_s19_q;
  logic [9:0] select_2484_s19_q;
  logic [9:0] select_2487_s19_q;
  logic and_2535_s19_q;
  logic and_2569_s19_q;
  logic [7:0] select_2589_s19_q;
  logic [1:0] select_2601_s19_q;
  logic [1:0] select_2616_s19_q;
  logic [11:0] select_2667_s19_q;
  logic and_2675_s19_q;
  logic [11:0] select_2682_s19_q;
  logic and_2693_s19_q;
  logic and_2697_s19_q;
  logic and_2729_s19_q;
  logic and_2737_s19_q;
  logic [8:0] other_s19_q;
  logic [2:0] select_2955_s19_q;
  logic [8:0] select_2968_s19_q;
  logic xor_2983_s19_q;
  logic xor_3001_s19_q;
  logic xor_3013_s19_q;
  logic xor_3025_s19_q;
  logic xor_3037_s19_q;
  logic or_3046_s19_q;
  logic or_3050_s19_q;
  logic or_3054_s19_q;
  logic or_3061_s19_q;
  logic or_3065_s19_q;
  logic or_3069_s19_q;
  logic or_3076_s19_q;
  logic or_3080_s19_q;
  logic or_3084_s19_q;
  logic or_3094_s19_q;
  logic or_3098_s19_q;
  logic or_3102_s19_q;
  logic or_3110_s19_q;
  logic or_3114_s19_q;
  logic or_3118_s19_q;
  logic or_3125_s19_q;
  logic or_3129_s19_q;
  logic or_3133_s19_q;
  logic or_3143_s19_q;
  logic or_3147_s19_q;
  logic or_3151_s19_q;
  logic and_3156_s19_q;
  logic or_3157_s19_q;
  logic equal_3278_s19_q;
  logic [4:0] select_3366_s19_q;
  logic [12:0] select_3397_s19_q;
  logic [9:0] select_3407_s19_q;
  logic less_3440_s19_q;
  logic not_3448_s19_q;
  logic not_3451_s19_q;
  logic not_3455_s19_q;
  logic not_3458_s19_q;
  logic [7:0] select_3463_s19_q;
  logic sum_3464_s19_q;
  logic [6:0] sum_3466_s19_q;
  logic equal_3518_s19_q;
  logic equal_3741_s19_q;
  logic or_3744_s19_q;
  logic select_3752_s19_q;
  logic not_3757_s19_q;
  logic equal_3765_s19_q;
  logic equal_3767_s19_q;
  logic equal_3768_s19_q;
  logic equal_3769_s19_q;
  logic equal_3770_s19_q;
  logic equal_3910_s19_q;
  logic [31:0] select_4007_s19_q;
  logic [9:0] select_4014_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      pixel_0_s19_q <= pixel_0_s18_q;
      pixel_1_s19_q <= pixel_1_s18_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= line_ended_q;
      sample_pair_pixel_0_s19_q <= sample_pair_pixel_0_s18_q;
      sample_pair_pixel_1_s19_q <= sample_pair_pixel_1_s18_q;
      sample_pair_whole_s19_q <= sample_pair_whole_s18_q;
      sample_present_s19_q <= sample_present_s18_q;
      census_columns_values_1_cell_2_of_skin_s19_q <= census_columns_values_1_cell_2_of_skin_s18_q;
      census_columns_values_2_cell_4_mask_s19_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s19_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s19_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s19_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s19_q <= census_columns_values_3_cell_3_mask_q;
      x_s19_q <= x_s18_q[6:0];
      slot_s19_q <= slot_s18_q[0];
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      counts_nearer_s19_q <= counts_nearer_q;
      registration_of_right_s19_q <= registration_of_right_s18_q;
      patches_lower_s19_q <= patches_lower_s18_q;
      patches_second_s19_q <= patches_second_s18_q;
      patches_summed_row_column_s19_q <= patches_summed_row_column_s18_q;
      patches_summed_first_s19_q <= patches_summed_first_q;
      patches_summed_last_s19_q <= patches_summed_last_s18_q;
      patches_summed_down_by_s19_q <= patches_summed_down_by_s18_q;
      product_s19_q <= product_s18_q;
      centres_values_1_textured_s19_q <= centres_values_1_textured_s18_q;
      centres_values_1_of_skin_s19_q <= centres_values_1_of_skin_s18_q;
      select_485_s19_q <= select_485_s18_q;
      select_488_s19_q <= select_488_s18_q;
      column_s19_q <= column_s18_q;
      and_524_s19_q <= and_524_s18_q;
      so_s19_q <= so_s18_q;
      less_558_s19_q <= less_558_s18_q;
      less_559_s19_q <= less_559_s18_q;
      less_560_s19_q <= less_560_s18_q;
      less_561_s19_q <= less_561_s18_q;
      less_562_s19_q <= less_562_s18_q;
      less_563_s19_q <= less_563_s18_q;
      less_564_s19_q <= less_564_s18_q;
      less_565_s19_q <= less_565_s18_q;
      less_566_s19_q <= less_566_s18_q;
      less_567_s19_q <= less_567_s18_q;
      less_568_s19_q <= less_568_s18_q;
      less_569_s19_q <= less_569_s18_q;
      less_570_s19_q <= less_570_s18_q;
      less_571_s19_q <= less_571_s18_q;
      less_572_s19_q <= less_572_s18_q;
      less_573_s19_q <= less_573_s18_q;
      less_574_s19_q <= less_574_s18_q;
      less_575_s19_q <= less_575_s18_q;
      less_576_s19_q <= less_576_s18_q;
      less_577_s19_q <= less_577_s18_q;
      less_578_s19_q <= less_578_s18_q;
      less_579_s19_q <= less_579_s18_q;
      less_580_s19_q <= less_580_s18_q;
      less_581_s19_q <= less_581_s18_q;
      and_589_s19_q <= and_589_s18_q;
      whole_16_s19_q <= whole_16;
      and_615_s19_q <= census_columns_values_1_cell_2_mask_s18_q & and_589_s18_q;
      sum_630_s19_q <= {1'b0, sum_626} + {2'h0, sum_629_s18_q};
      sum_633_s19_q <= sum_633_s18_q;
      equal_1489_s19_q <= equal_1489_s18_q;
      not_1490_s19_q <= not_1490_s18_q;
      equal_1530_s19_q <= equal_1530_s18_q;
      sum_1536_s19_q <= sum_1536_s18_q;
      equal_1538_s19_q <= equal_1538_s18_q;
      equal_1540_s19_q <= equal_1540_s18_q;
      equal_1542_s19_q <= equal_1542_s18_q;
      equal_1544_s19_q <= equal_1544_s18_q;
      equal_1546_s19_q <= equal_1546_s18_q;
      equal_1548_s19_q <= equal_1548_s18_q;
      less_1561_s19_q <= less_1561_s18_q;
      select_1586_s19_q <= equal_1585_s18_q ? registration_sums_rdata_s18_q[19:0] : 20'h0;
      equal_1587_s19_q <= equal_1587;
      sum_1594_s19_q <= sum_1594;
      and_1595_s19_q <= and_1595_s18_q;
      and_1598_s19_q <= and_1598_s18_q;
      select_1615_s19_q <= select_1615_s18_q;
      equal_1616_s19_q <= equal_1616_s18_q;
      equal_1649_s19_q <= equal_1649_s18_q;
      equal_1708_s19_q <= equal_1708_s18_q;
      equal_1710_s19_q <= equal_1710_s18_q;
      equal_1713_s19_q <= equal_1713_s18_q;
      select_1724_s19_q <= select_1724_s18_q[0];
      sum_1730_s19_q <= select_1728 + {{2{select_1729[5]}}, select_1729};
      select_1738_s19_q <= select_1738_s18_q;
      select_1744_s19_q <= select_1744_s18_q;
      sum_1759_s19_q <= select_1757 + {{2{select_1758[5]}}, select_1758};
      equal_1774_s19_q <= equal_1774;
      equal_1778_s19_q <= equal_1778;
      select_1783_s19_q <= select_1783_s18_q;
      less_1869_s19_q <= less_1869_s18_q;
      equal_1870_s19_q <= equal_1870_s18_q;
      not_1871_s19_q <= not_1871_s18_q;
      equal_1872_s19_q <= equal_1872_s18_q;
      not_1898_s19_q <= not_1898_s18_q;
      not_1958_s19_q <= not_1958;
      sum_1968_s19_q <= {2'h0, x_s18_q[7:2]} + 8'hff;
      difference_1980_s19_q <= {1'b0, textured_2_s18_q} - {1'b0, select_1979};
      or_1988_s19_q <= or_1988_s18_q;
      select_1999_s19_q <= select_1999;
      around_s19_q <= around;
      less_2033_s19_q <= {1'b0, around[4:1]} < n;
      and_2044_s19_q <= and_2044_s18_q;
      sum_2173_s19_q <= {1'b0, sum_2169} + {2'h0, sum_2172_s18_q};
      sum_2176_s19_q <= sum_2176_s18_q;
      equal_2184_s19_q <= equal_2184_s18_q;
      select_2198_s19_q <= sample_pair_whole_s18_q ? {detail_2, detail} : 28'h0;
      and_2211_s19_q <= and_2211;
      and_2223_s19_q <= and_2223;
      select_2230_s19_q <= and_2211 ? contrast_s18_q : 9'h0;
      select_2234_s19_q <= and_2223 ? contrast_2_s18_q : 9'h0;
      equal_2237_s19_q <= x_s18_q[7:3] == 5'h0;
      less_2238_s19_q <= 7'h2 < {x_s18_q[4:0], slot_s18_q[2:1]};
      select_2243_s19_q <= select_2243;
      equal_2281_s19_q <= {x_s18_q[4:0], slot_s18_q} == 8'h0;
      equal_2308_s19_q <= equal_2308_s18_q;
      and_2433_s19_q <= and_2433_s18_q;
      not_2458_s19_q <= not_2458_s18_q;
      e_s19_q <= e;
      select_2484_s19_q <= select_2484_s18_q;
      select_2487_s19_q <= select_2487_s18_q;
      and_2535_s19_q <= and_2535_s18_q;
      and_2569_s19_q <= and_2569_s18_q;
      select_2589_s19_q <= equal_1489_s18_q ? 8'h0 : (so_s18_q ? select_2587 : 8'h0);
      select_2601_s19_q <= equal_1489_s18_q ? 2'h0 : select_2600;
      select_2616_s19_q <= equal_1489_s18_q ? 2'h0 : select_2615;
      select_2667_s19_q <= select_2667;
      and_2675_s19_q <= equal_1489_s18_q & (x_s18_q[6] & and_2673);
      select_2682_s19_q <= select_2682;
      and_2693_s19_q <= equal_1489_s18_q & (x_s18_q[6] & and_2691);
      and_2697_s19_q <= and_2697;
      and_2729_s19_q <= equal_1489_s18_q & (x_s18_q[6] & and_2727);
      and_2737_s19_q <= x_s18_q[6] & and_2736;
      other_s19_q <= other[44:36];
      select_2955_s19_q <= equal_1710_s18_q ? 3'h0 : select_2954;
      select_2968_s19_q <= select_2968_s18_q[44:36];
      xor_2983_s19_q <= xor_2983;
      xor_3001_s19_q <= xor_2983 ^ parity_3000;
      xor_3013_s19_q <= xor_3004 ^ (^{select_2968_s18_q[41:36], other[41:36]});
      xor_3025_s19_q <= xor_3016 ^ (^{select_2968_s18_q[23:18], other[23:18]});
      xor_3037_s19_q <= xor_3028 ^ (^{select_2968_s18_q[32:27], other[32:27]});
      or_3046_s19_q <= (xor_2977 & xor_2980) | (xor_2974 & (xor_2977 | xor_2980));
      or_3050_s19_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3054_s19_q <= (xor_2992 & xor_2995) | (xor_2989 & (xor_2992 | xor_2995));
      or_3061_s19_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3065_s19_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3069_s19_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3076_s19_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3080_s19_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3084_s19_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3094_s19_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3098_s19_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3102_s19_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3110_s19_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3114_s19_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3118_s19_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3125_s19_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3129_s19_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3133_s19_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3143_s19_q <= (xor_3007 & xor_3010) | (xor_3004 & (xor_3007 | xor_3010));
      or_3147_s19_q <= (xor_3019 & xor_3022) | (xor_3016 & (xor_3019 | xor_3022));
      or_3151_s19_q <= (xor_3031 & xor_3034) | (xor_3028 & (xor_3031 | xor_3034));
      and_3156_s19_q <= xor_2986 & xor_2998;
      or_3157_s19_q <= xor_2986 | xor_2998;
      equal_3278_s19_q <= equal_3278_s18_q;
      select_3366_s19_q <= select_3366_s18_q;
      select_3397_s19_q <= select_3397_s18_q[12:0];
      select_3407_s19_q <= select_3407;
      less_3440_s19_q <= less_3440_s18_q;
      not_3448_s19_q <= ~({eight_s18_q, 3'h0} < {3'h0, fall_2_s18_q});
      not_3451_s19_q <= ~({eight_s18_q, 3'h0} < {1'b0, sum_3449, fall_2_s18_q[0]});
      not_3455_s19_q <= ~({eight_s18_q, 3'h0} < {sum_3453, fall_2_s18_q[1:0]});
      not_3458_s19_q <= ~less_3457;
      select_3463_s19_q <= select_3463;
      sum_3464_s19_q <= sum_3464[0];
      sum_3466_s19_q <= sum_3466;
      equal_3518_s19_q <= equal_3518_s18_q;
      equal_3741_s19_q <= select_2484_s18_q[9:3] == 7'h0;
      or_3744_s19_q <= or_3744;
      select_3752_s19_q <= select_3752;
      not_3757_s19_q <= ~({sum_3755, select_2487_s18_q[0]} < {2'h0, select_2484_s18_q});
      equal_3765_s19_q <= equal_3765_s18_q;
      equal_3767_s19_q <= equal_3767_s18_q;
      equal_3768_s19_q <= equal_3768_s18_q;
      equal_3769_s19_q <= equal_3769_s18_q;
      equal_3770_s19_q <= equal_3770_s18_q;
      equal_3910_s19_q <= equal_3910_s18_q;
      select_4007_s19_q <= select_4007;
      select_4014_s19_q <= select_4014_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
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
  logic [6:0] registration_half_votes_down_q;
  logic [6:0] registration_half_half_votes_down_q;
  logic [13:0] registration_down_q;
  logic [13:0] registration_up_q;
  logic registration_enough_q;
  logic registration_votes_down_q;
  logic registration_votes_up_q;
  logic registration_other_enough_q;
  logic registration_other_down_q;
  logic registration_other_up_q;
  logic patches_place_0_valid_q;
  logic patches_place_1_valid_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic [47:0] good_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:450
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s19_q & whole_16_s19_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s19_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s19_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s19_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s19_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:270
  logic [11:0] texture;
  assign texture = sum_630_s19_q + {2'h0, sum_633_s19_q};
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1536_s19_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1589;
  assign select_1589 = equal_1587_s19_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1726;
  assign select_1726 = equal_1616_s19_q ? patches_place_0_valid_q : (select_1615_s19_q ? patches_place_0_valid_q : select_1724_s19_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1731;
  assign sum_1731 = sum_1730_s19_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1732;
  assign equal_1732 = {sum_1731[7], select_488_s19_q, select_485_s19_q} == {1'b0, sum_1731[6:0], 4'h8};
  // hls/stages/patches.hpp:127
  logic select_1755;
  assign select_1755 = equal_1616_s19_q ? patches_place_1_valid_q : (select_1615_s19_q ? select_1724_s19_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1760;
  assign sum_1760 = sum_1759_s19_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1761;
  assign equal_1761 = {sum_1760[7], select_488_s19_q, select_485_s19_q} == {1'b0, sum_1760[6:0], 4'h8};
  // hls/stages/agreement.hpp:1279
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1246
  logic select_1956;
  assign select_1956 = marks_first_s19_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1232
  logic [10:0] sum_1957;
  assign sum_1957 = {1'b0, {5{select_1956}}, 1'b0, {2{select_1956}}, 1'b0, select_1956} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1087
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1968_s19_q[7]}}, sum_1968_s19_q, x_s19_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1232
  logic [10:0] sum_1970;
  assign sum_1970 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1070
  logic [4:0] t;
  assign t = {difference_1980_s19_q[3], difference_1980_s19_q} + (equal_1649_s19_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1077
  logic [47:0] select_2000;
  assign select_2000 = or_1988_s19_q ? {select_1999_s19_q[23], 1'b0, select_1999_s19_q[22], 1'b0, select_1999_s19_q[21], 1'b0, select_1999_s19_q[20], 1'b0, select_1999_s19_q[19], 1'b0, select_1999_s19_q[18], 1'b0, select_1999_s19_q[17], 1'b0, select_1999_s19_q[16], 1'b0, select_1999_s19_q[15], 1'b0, select_1999_s19_q[14], 1'b0, select_1999_s19_q[13], 1'b0, select_1999_s19_q[12], 1'b0, select_1999_s19_q[11], 1'b0, select_1999_s19_q[10], 1'b0, select_1999_s19_q[9], 1'b0, select_1999_s19_q[8], 1'b0, select_1999_s19_q[7], 1'b0, select_1999_s19_q[6], 1'b0, select_1999_s19_q[5], 1'b0, select_1999_s19_q[4], 1'b0, select_1999_s19_q[3], 1'b0, select_1999_s19_q[2], 1'b0, select_1999_s19_q[1], 1'b0, select_1999_s19_q[0], 1'b0} : {1'b0, select_1999_s19_q[23], 1'b0, select_1999_s19_q[22], 1'b0, select_1999_s19_q[21], 1'b0, select_1999_s19_q[20], 1'b0, select_1999_s19_q[19], 1'b0, select_1999_s19_q[18], 1'b0, select_1999_s19_q[17], 1'b0, select_1999_s19_q[16], 1'b0, select_1999_s19_q[15], 1'b0, select_1999_s19_q[14], 1'b0, select_1999_s19_q[13], 1'b0, select_1999_s19_q[12], 1'b0, select_1999_s19_q[11], 1'b0, select_1999_s19_q[10], 1'b0, select_1999_s19_q[9], 1'b0, select_1999_s19_q[8], 1'b0, select_1999_s19_q[7], 1'b0, select_1999_s19_q[6], 1'b0, select_1999_s19_q[5], 1'b0, select_1999_s19_q[4], 1'b0, select_1999_s19_q[3], 1'b0, select_1999_s19_q[2], 1'b0, select_1999_s19_q[1], 1'b0, select_1999_s19_q[0]};
  // hls/stages/agreement.hpp:1079
  logic [5:0] sum_2017;
  assign sum_2017 = {1'b0, around_s19_q} + {2'h0, around_s19_q[4:1]};
  // hls/stages/agreement.hpp:514
  logic select_2157;
  assign select_2157 = and_524_s19_q ? census_columns_values_2_cell_4_mask_s19_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2177;
  assign sum_2177 = sum_2173_s19_q + {2'h0, sum_2176_s19_q};
  // hls/stages/agreement.hpp:514
  logic [11:0] select_2179;
  assign select_2179 = and_524_s19_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2180;
  assign select_2180 = and_524_s19_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2199;
  assign select_2199 = and_524_s19_q ? select_2198_s19_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2200;
  assign select_2200 = and_524_s19_q ? select_2198_s19_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2198_s19_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2198_s19_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_2231;
  assign sum_2231 = (equal_2184_s19_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2230_s19_q};
  logic [23:0] sum_2235;
  assign sum_2235 = (equal_2184_s19_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2234_s19_q};
  // hls/stages/census.hpp:409
  logic less_2239;
  assign less_2239 = x_s19_q[4:0] < 5'h3;
  logic [23:0] select_2244;
  assign select_2244 = slot_s19_q ? {select_2243_s19_q[11], 1'b0, select_2243_s19_q[10], 1'b0, select_2243_s19_q[9], 1'b0, select_2243_s19_q[8], 1'b0, select_2243_s19_q[7], 1'b0, select_2243_s19_q[6], 1'b0, select_2243_s19_q[5], 1'b0, select_2243_s19_q[4], 1'b0, select_2243_s19_q[3], 1'b0, select_2243_s19_q[2], 1'b0, select_2243_s19_q[1], 1'b0, select_2243_s19_q[0], 1'b0} : {1'b0, select_2243_s19_q[11], 1'b0, select_2243_s19_q[10], 1'b0, select_2243_s19_q[9], 1'b0, select_2243_s19_q[8], 1'b0, select_2243_s19_q[7], 1'b0, select_2243_s19_q[6], 1'b0, select_2243_s19_q[5], 1'b0, select_2243_s19_q[4], 1'b0, select_2243_s19_q[3], 1'b0, select_2243_s19_q[2], 1'b0, select_2243_s19_q[1], 1'b0, select_2243_s19_q[0]};
  // hls/stages/census.hpp:372
  logic and_2248;
  assign and_2248 = less_2239 & (~((sharpness_sums_contrast_1_q & select_2244) == 24'h0));
  logic and_2258;
  assign and_2258 = less_2239 & (~((sharpness_sums_contrast_0_q & select_2244) == 24'h0));
  // hls/stages/agreement.hpp:1078
  logic [5:0] sum_2471;
  assign sum_2471 = {1'b0, e_s19_q} + {2'h0, e_s19_q[4:1]};
  // hls/stages/agreement.hpp:1109
  logic [10:0] sum_2488;
  assign sum_2488 = {1'b0, select_2487_s19_q} + {3'h0, select_2487_s19_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2590;
  assign sum_2590 = registration_half_across_q + {{6{select_2589_s19_q[7]}}, select_2589_s19_q};
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2602;
  assign sum_2602 = registration_half_votes_down_q + {{5{select_2601_s19_q[1]}}, select_2601_s19_q};
  logic [6:0] sum_2617;
  assign sum_2617 = registration_half_half_votes_down_q + {{5{select_2616_s19_q[1]}}, select_2616_s19_q};
  // hls/stages/agreement.hpp:780
  logic and_2658;
  assign and_2658 = equal_1489_s19_q & (x_s19_q[6] & (not_1898_s19_q & less_1561_s19_q));
  logic [11:0] select_2669;
  assign select_2669 = equal_1489_s19_q ? (x_s19_q[6] ? select_2667_s19_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2677;
  assign sum_2677 = {{2{select_2669[11]}}, select_2669} + (and_2675_s19_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:780
  logic [11:0] select_2684;
  assign select_2684 = equal_1489_s19_q ? (x_s19_q[6] ? select_2682_s19_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2686;
  assign sum_2686 = {{2{select_2684[11]}}, select_2684} + (and_2675_s19_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2698;
  assign not_2698 = ~and_2697_s19_q;
  logic less_2699;
  assign less_2699 = $signed({9'h1, {2{not_2698}}, and_2697_s19_q}) < $signed(registration_up_q[13:2]);
  logic select_2700;
  assign select_2700 = and_2693_s19_q ? less_2699 : registration_enough_q;
  // hls/stages/agreement.hpp:1118
  logic and_2704;
  assign and_2704 = x_s19_q[6] & (not_1898_s19_q & (less_1561_s19_q & (x_s19_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:780
  logic and_2705;
  assign and_2705 = equal_1489_s19_q & and_2704;
  // hls/stages/registration.hpp:242
  logic less_2706;
  assign less_2706 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2708;
  assign less_2708 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2710;
  assign equal_2710 = x_s19_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:780
  logic and_2714;
  assign and_2714 = equal_1489_s19_q & (x_s19_q[6] & (not_1898_s19_q & (less_1561_s19_q & equal_2710)));
  // hls/stages/agreement.hpp:1118
  logic and_2721;
  assign and_2721 = x_s19_q[6] & (not_1898_s19_q & (less_1561_s19_q & (x_s19_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2739;
  assign and_2739 = registration_votes_up_q & registration_other_down_q;
  logic select_2741;
  assign select_2741 = registration_votes_down_q ? (registration_other_up_q | and_2739) : and_2739;
  // hls/stages/registration.hpp:138
  logic and_2743;
  assign and_2743 = (equal_1489_s19_q & and_2737_s19_q) & (registration_other_enough_q & select_2741);
  logic and_2745;
  assign and_2745 = registration_enough_q & ((and_2729_s19_q & (less_2708 | less_2706)) | and_2743);
  // hls/stages/patches.hpp:167
  logic [9:0] sum_2958;
  assign sum_2958 = {7'h0, patches_set_q} + (equal_1713_s19_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3038;
  assign xor_3038 = xor_3025_s19_q ^ xor_3037_s19_q;
  // hls/stages/count_bits.hpp:25
  logic or_3163;
  assign or_3163 = (xor_3025_s19_q & xor_3037_s19_q) | (xor_3013_s19_q & (xor_3025_s19_q | xor_3037_s19_q));
  // hls/stages/patches.hpp:578
  logic [1:0] sum_3452;
  assign sum_3452 = {1'b0, not_3448_s19_q} + {1'b0, not_3451_s19_q};
  // hls/stages/patches.hpp:579
  logic [1:0] sum_3459;
  assign sum_3459 = {1'b0, not_3455_s19_q} + {1'b0, not_3458_s19_q};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3452} + {1'b0, sum_3459};
  // hls/stages/patches.hpp:592
  logic [18:0] product_3467;
  assign product_3467 = $signed({{11{select_3463_s19_q[7]}}, select_3463_s19_q}) * $signed({{8{sum_3466_s19_q[6]}}, sum_3466_s19_q, sum_3464_s19_q, select_3397_s19_q[12:10]});
  // hls/stages/agreement.hpp:1120
  logic equal_3625;
  assign equal_3625 = x_s19_q == 7'h7f;
  // hls/stages/patches.hpp:600
  logic [11:0] sum_3646;
  assign sum_3646 = {sum_3466_s19_q[6], sum_3466_s19_q, sum_3464_s19_q, select_3397_s19_q[12:10]} + 12'h1;
  // hls/stages/agreement.hpp:1111
  logic select_3758;
  assign select_3758 = equal_3741_s19_q ? ((~or_3744_s19_q) & (~select_3752_s19_q)) : not_3757_s19_q;
  // hls/stages/agreement.hpp:1118
  logic [47:0] select_3760;
  assign select_3760 = x_s19_q[6] ? (equal_1530_s19_q ? good_q : {select_3758, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:780
  logic [4:0] select_3841;
  assign select_3841 = so_s19_q ? (ends_cell_s19_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_3842;
  assign select_3842 = equal_1489_s19_q ? box_textured_sum_sums_values_0_q : select_3841;
  // hls/stages/agreement.hpp:454
  logic [12:0] select_3913;
  assign select_3913 = equal_2308_s19_q ? (equal_3910_s19_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:514
  logic [6:0] select_3916;
  assign select_3916 = and_524_s19_q ? (equal_2308_s19_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      registration_half_across_q <= 14'h0;
      registration_half_votes_down_q <= 7'h0;
      registration_half_half_votes_down_q <= 7'h0;
      registration_down_q <= 14'h0;
      registration_up_q <= 14'h0;
      registration_enough_q <= 1'b0;
      registration_votes_down_q <= 1'b0;
      registration_votes_up_q <= 1'b0;
      registration_other_enough_q <= 1'b0;
      registration_other_down_q <= 1'b0;
      registration_other_up_q <= 1'b0;
      patches_place_0_valid_q <= 1'b0;
      patches_place_1_valid_q <= 1'b0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s19_en) begin
      sharpness_sums_contrast_0_q <= and_524_s19_q ? sum_2231 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_524_s19_q ? sum_2235 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2569_s19_q ? 14'h0 : sum_2590;
      registration_half_votes_down_q <= and_2569_s19_q ? 7'h0 : sum_2602;
      registration_half_half_votes_down_q <= and_2569_s19_q ? 7'h0 : sum_2617;
      registration_down_q <= and_2658 ? sum_2677 : registration_down_q;
      registration_up_q <= and_2658 ? sum_2686 : registration_up_q;
      registration_enough_q <= select_2700;
      registration_votes_down_q <= and_2705 ? less_2706 : registration_votes_down_q;
      registration_votes_up_q <= and_2705 ? less_2708 : registration_votes_up_q;
      registration_other_enough_q <= and_2714 ? select_2700 : registration_other_enough_q;
      registration_other_down_q <= and_2714 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2714 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s19_q ? select_1726 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s19_q ? select_1755 : patches_place_1_valid_q;
      patches_set_q <= equal_1708_s19_q ? 3'h0 : select_2955_s19_q;
      patches_size_q <= sum_2958;
      good_q <= equal_1489_s19_q ? select_3760 : good_q;
      map_row_q <= and_524_s19_q ? select_3913 : map_row_q;
      map_width_q <= select_3916;
      write_half_q <= marks_first_s19_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1956;
      done_q <= not_1958_s19_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s19_q;
      said_q <= equal_1489_s19_q & equal_3625;
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
    box_textured_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s19_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2157;
      census_changes_values_0_left_q <= and_524_s19_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_524_s19_q ? sum_2177 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2179;
      census_changes_values_1_right_q <= select_2180;
      sharpness_last_detail_0_q <= select_2199;
      sharpness_last_detail_1_q <= select_2200;
      box_textured_sum_sums_values_0_q <= select_3842;
    end
  end

  logic [7:0] pixel_0_s20_q;
  logic [7:0] pixel_1_s20_q;
  logic saturated_s20_q;
  logic mask_s20_q;
  logic marks_first_s20_q;
  logic marks_last_s20_q;
  logic [7:0] sample_pair_pixel_0_s20_q;
  logic [7:0] sample_pair_pixel_1_s20_q;
  logic sample_pair_whole_s20_q;
  logic sample_present_s20_q;
  logic census_columns_values_1_cell_2_of_skin_s20_q;
  logic [11:0] census_changes_values_1_left_s20_q;
  logic [11:0] census_changes_values_1_right_s20_q;
  logic [23:0] sharpness_sums_contrast_0_s20_q;
  logic [23:0] sharpness_sums_contrast_1_s20_q;
  logic [6:0] x_s20_q;
  logic ends_cell_s20_q;
  logic lower_half_s20_q;
  logic [13:0] counts_nearer_s20_q;
  logic registration_of_right_s20_q;
  logic patches_lower_s20_q;
  logic patches_second_s20_q;
  logic [4:0] patches_summed_row_column_s20_q;
  logic patches_summed_first_s20_q;
  logic patches_summed_last_s20_q;
  logic [4:0] patches_summed_down_by_s20_q;
  logic [13:0] product_s20_q;
  logic centres_values_1_textured_s20_q;
  logic centres_values_1_of_skin_s20_q;
  logic done_s20_q;
  logic [6:0] column_s20_q;
  logic and_524_s20_q;
  logic less_558_s20_q;
  logic less_559_s20_q;
  logic less_560_s20_q;
  logic less_561_s20_q;
  logic less_562_s20_q;
  logic less_563_s20_q;
  logic less_564_s20_q;
  logic less_565_s20_q;
  logic less_566_s20_q;
  logic less_567_s20_q;
  logic less_568_s20_q;
  logic less_569_s20_q;
  logic less_570_s20_q;
  logic less_571_s20_q;
  logic less_572_s20_q;
  logic less_573_s20_q;
  logic less_574_s20_q;
  logic less_575_s20_q;
  logic less_576_s20_q;
  logic less_577_s20_q;
  logic less_578_s20_q;
  logic less_579_s20_q;
  logic less_580_s20_q;
  logic less_581_s20_q;
  logic and_589_s20_q;
  logic and_614_s20_q;
  logic and_615_s20_q;
  logic [12:0] sum_635_s20_q;
  logic equal_1489_s20_q;
  logic not_1490_s20_q;
  logic equal_1530_s20_q;
  logic [1:0] sum_1536_s20_q;
  logic equal_1538_s20_q;
  logic equal_1540_s20_q;
  logic equal_1542_s20_q;
  logic equal_1544_s20_q;
  logic equal_1546_s20_q;
  logic equal_1548_s20_q;
  logic [19:0] sum_1590_s20_q;
  logic [11:0] sum_1594_s20_q;
  logic and_1595_s20_q;
  logic and_1598_s20_q;
  logic select_1615_s20_q;
  logic equal_1616_s20_q;
  logic equal_1708_s20_q;
  logic equal_1710_s20_q;
  logic select_1724_s20_q;
  logic select_1726_s20_q;
  logic equal_1732_s20_q;
  logic [4:0] select_1738_s20_q;
  logic select_1744_s20_q;
  logic select_1755_s20_q;
  logic equal_1761_s20_q;
  logic or_1776_s20_q;
  logic or_1780_s20_q;
  logic [3:0] select_1783_s20_q;
  logic less_1869_s20_q;
  logic equal_1870_s20_q;
  logic not_1871_s20_q;
  logic equal_1872_s20_q;
  logic not_1898_s20_q;
  logic [2:0] index_s20_q;
  logic [10:0] sum_1957_s20_q;
  logic and_1964_s20_q;
  logic less_1965_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_1970_s20_q;
  logic equal_1983_s20_q;
  logic not_2003_s20_q;
  logic not_2019_s20_q;
  logic less_2033_s20_q;
  logic and_2044_s20_q;
  logic equal_2184_s20_q;
  logic [12:0] sum_2185_s20_q;
  logic [12:0] select_2213_s20_q;
  logic [12:0] select_2225_s20_q;
  logic equal_2237_s20_q;
  logic less_2238_s20_q;
  logic and_2248_s20_q;
  logic and_2258_s20_q;
  logic equal_2281_s20_q;
  logic and_2433_s20_q;
  logic not_2458_s20_q;
  logic not_2473_s20_q;
  logic [9:0] select_2484_s20_q;
  logic [9:0] select_2487_s20_q;
  logic less_2489_s20_q;
  logic and_2535_s20_q;
  logic equal_2710_s20_q;
  logic not_2723_s20_q;
  logic and_2745_s20_q;
  logic parity_3042_s20_q;
  logic or_3046_s20_q;
  logic or_3050_s20_q;
  logic or_3054_s20_q;
  logic or_3061_s20_q;
  logic or_3065_s20_q;
  logic or_3069_s20_q;
  logic or_3076_s20_q;
  logic or_3080_s20_q;
  logic or_3084_s20_q;
  logic or_3094_s20_q;
  logic or_3098_s20_q;
  logic or_3102_s20_q;
  logic or_3110_s20_q;
  logic or_3114_s20_q;
  logic or_3118_s20_q;
  logic or_3125_s20_q;
  logic or_3129_s20_q;
  logic or_3133_s20_q;
  logic or_3143_s20_q;
  logic or_3147_s20_q;
  logic or_3151_s20_q;
  logic and_3155_s20_q;
  logic or_3159_s20_q;
  logic or_3163_s20_q;
  logic equal_3278_s20_q;
  logic [4:0] select_3366_s20_q;
  logic [9:0] select_3397_s20_q;
  logic [9:0] select_3407_s20_q;
  logic less_3440_s20_q;
  logic [2:0] fraction_s20_q;
  logic [13:0] product_3467_s20_q;
  logic equal_3518_s20_q;
  logic equal_3625_s20_q;
  logic less_3647_s20_q;
  logic or_3744_s20_q;
  logic select_3752_s20_q;
  logic equal_3765_s20_q;
  logic equal_3767_s20_q;
  logic equal_3768_s20_q;
  logic equal_3769_s20_q;
  logic equal_3770_s20_q;
  logic [31:0] select_4007_s20_q;
  logic [9:0] select_4014_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      pixel_0_s20_q <= pixel_0_s19_q;
      pixel_1_s20_q <= pixel_1_s19_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= mask_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      sample_pair_pixel_0_s20_q <= sample_pair_pixel_0_s19_q;
      sample_pair_pixel_1_s20_q <= sample_pair_pixel_1_s19_q;
      sample_pair_whole_s20_q <= sample_pair_whole_s19_q;
      sample_present_s20_q <= sample_present_s19_q;
      census_columns_values_1_cell_2_of_skin_s20_q <= census_columns_values_1_cell_2_of_skin_s19_q;
      census_changes_values_1_left_s20_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s20_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s20_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s20_q <= sharpness_sums_contrast_1_q;
      x_s20_q <= x_s19_q;
      ends_cell_s20_q <= ends_cell_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      counts_nearer_s20_q <= counts_nearer_s19_q;
      registration_of_right_s20_q <= registration_of_right_s19_q;
      patches_lower_s20_q <= patches_lower_s19_q;
      patches_second_s20_q <= patches_second_s19_q;
      patches_summed_row_column_s20_q <= patches_summed_row_column_s19_q;
      patches_summed_first_s20_q <= patches_summed_first_s19_q;
      patches_summed_last_s20_q <= patches_summed_last_s19_q;
      patches_summed_down_by_s20_q <= patches_summed_down_by_s19_q;
      product_s20_q <= product_s19_q;
      centres_values_1_textured_s20_q <= centres_values_1_textured_s19_q;
      centres_values_1_of_skin_s20_q <= centres_values_1_of_skin_s19_q;
      done_s20_q <= done_q;
      column_s20_q <= column_s19_q;
      and_524_s20_q <= and_524_s19_q;
      less_558_s20_q <= less_558_s19_q;
      less_559_s20_q <= less_559_s19_q;
      less_560_s20_q <= less_560_s19_q;
      less_561_s20_q <= less_561_s19_q;
      less_562_s20_q <= less_562_s19_q;
      less_563_s20_q <= less_563_s19_q;
      less_564_s20_q <= less_564_s19_q;
      less_565_s20_q <= less_565_s19_q;
      less_566_s20_q <= less_566_s19_q;
      less_567_s20_q <= less_567_s19_q;
      less_568_s20_q <= less_568_s19_q;
      less_569_s20_q <= less_569_s19_q;
      less_570_s20_q <= less_570_s19_q;
      less_571_s20_q <= less_571_s19_q;
      less_572_s20_q <= less_572_s19_q;
      less_573_s20_q <= less_573_s19_q;
      less_574_s20_q <= less_574_s19_q;
      less_575_s20_q <= less_575_s19_q;
      less_576_s20_q <= less_576_s19_q;
      less_577_s20_q <= less_577_s19_q;
      less_578_s20_q <= less_578_s19_q;
      less_579_s20_q <= less_579_s19_q;
      less_580_s20_q <= less_580_s19_q;
      less_581_s20_q <= less_581_s19_q;
      and_589_s20_q <= and_589_s19_q;
      and_614_s20_q <= whole_22 & and_589_s19_q;
      and_615_s20_q <= and_615_s19_q;
      sum_635_s20_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1489_s20_q <= equal_1489_s19_q;
      not_1490_s20_q <= not_1490_s19_q;
      equal_1530_s20_q <= equal_1530_s19_q;
      sum_1536_s20_q <= sum_1536_s19_q;
      equal_1538_s20_q <= equal_1538_s19_q;
      equal_1540_s20_q <= equal_1540_s19_q;
      equal_1542_s20_q <= equal_1542_s19_q;
      equal_1544_s20_q <= equal_1544_s19_q;
      equal_1546_s20_q <= equal_1546_s19_q;
      equal_1548_s20_q <= equal_1548_s19_q;
      sum_1590_s20_q <= select_1586_s19_q + {{6{select_1589[13]}}, select_1589};
      sum_1594_s20_q <= sum_1594_s19_q;
      and_1595_s20_q <= and_1595_s19_q;
      and_1598_s20_q <= and_1598_s19_q;
      select_1615_s20_q <= select_1615_s19_q;
      equal_1616_s20_q <= equal_1616_s19_q;
      equal_1708_s20_q <= equal_1708_s19_q;
      equal_1710_s20_q <= equal_1710_s19_q;
      select_1724_s20_q <= select_1724_s19_q;
      select_1726_s20_q <= select_1726;
      equal_1732_s20_q <= equal_1732;
      select_1738_s20_q <= select_1738_s19_q;
      select_1744_s20_q <= select_1744_s19_q;
      select_1755_s20_q <= select_1755;
      equal_1761_s20_q <= equal_1761;
      or_1776_s20_q <= and_1598_s19_q | (select_1726 & equal_1774_s19_q);
      or_1780_s20_q <= and_1598_s19_q | (select_1755 & equal_1778_s19_q);
      select_1783_s20_q <= select_1783_s19_q;
      less_1869_s20_q <= less_1869_s19_q;
      equal_1870_s20_q <= equal_1870_s19_q;
      not_1871_s20_q <= not_1871_s19_q;
      equal_1872_s20_q <= equal_1872_s19_q;
      not_1898_s20_q <= not_1898_s19_q;
      index_s20_q <= index[2:0];
      sum_1957_s20_q <= sum_1957;
      and_1964_s20_q <= began_q & (seen_x_q == 4'h0);
      less_1965_s20_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s20_q <= index_2[2:0];
      sum_1970_s20_q <= sum_1970;
      equal_1983_s20_q <= t[4:1] == 4'h0;
      not_2003_s20_q <= ~((good_q & select_2000) == 48'h0);
      not_2019_s20_q <= ~({sum_2017, around_s19_q[0]} < {2'h0, t});
      less_2033_s20_q <= less_2033_s19_q;
      and_2044_s20_q <= and_2044_s19_q;
      equal_2184_s20_q <= equal_2184_s19_q;
      sum_2185_s20_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2177};
      select_2213_s20_q <= and_2211_s19_q ? detail_3[14:2] : 13'h0;
      select_2225_s20_q <= and_2223_s19_q ? detail_4[14:2] : 13'h0;
      equal_2237_s20_q <= equal_2237_s19_q;
      less_2238_s20_q <= less_2238_s19_q;
      and_2248_s20_q <= and_2248;
      and_2258_s20_q <= and_2258;
      equal_2281_s20_q <= equal_2281_s19_q;
      and_2433_s20_q <= and_2433_s19_q;
      not_2458_s20_q <= not_2458_s19_q;
      not_2473_s20_q <= ~({sum_2471, e_s19_q[0]} < {2'h0, t});
      select_2484_s20_q <= select_2484_s19_q;
      select_2487_s20_q <= select_2487_s19_q;
      less_2489_s20_q <= {sum_2488, select_2487_s19_q[1:0]} < {3'h0, select_2484_s19_q};
      and_2535_s20_q <= and_2535_s19_q;
      equal_2710_s20_q <= equal_2710;
      not_2723_s20_q <= ~(equal_1489_s19_q & and_2721);
      and_2745_s20_q <= and_2745;
      parity_3042_s20_q <= ^{xor_3038, xor_3001_s19_q, select_2968_s19_q, other_s19_q};
      or_3046_s20_q <= or_3046_s19_q;
      or_3050_s20_q <= or_3050_s19_q;
      or_3054_s20_q <= or_3054_s19_q;
      or_3061_s20_q <= or_3061_s19_q;
      or_3065_s20_q <= or_3065_s19_q;
      or_3069_s20_q <= or_3069_s19_q;
      or_3076_s20_q <= or_3076_s19_q;
      or_3080_s20_q <= or_3080_s19_q;
      or_3084_s20_q <= or_3084_s19_q;
      or_3094_s20_q <= or_3094_s19_q;
      or_3098_s20_q <= or_3098_s19_q;
      or_3102_s20_q <= or_3102_s19_q;
      or_3110_s20_q <= or_3110_s19_q;
      or_3114_s20_q <= or_3114_s19_q;
      or_3118_s20_q <= or_3118_s19_q;
      or_3125_s20_q <= or_3125_s19_q;
      or_3129_s20_q <= or_3129_s19_q;
      or_3133_s20_q <= or_3133_s19_q;
      or_3143_s20_q <= or_3143_s19_q;
      or_3147_s20_q <= or_3147_s19_q;
      or_3151_s20_q <= or_3151_s19_q;
      and_3155_s20_q <= xor_3001_s19_q & (^{xor_3038, select_2968_s19_q, other_s19_q});
      or_3159_s20_q <= and_3156_s19_q | (xor_2983_s19_q & or_3157_s19_q);
      or_3163_s20_q <= or_3163;
      equal_3278_s20_q <= equal_3278_s19_q;
      select_3366_s20_q <= select_3366_s19_q;
      select_3397_s20_q <= select_3397_s19_q[9:0];
      select_3407_s20_q <= select_3407_s19_q;
      less_3440_s20_q <= less_3440_s19_q;
      fraction_s20_q <= fraction;
      product_3467_s20_q <= product_3467[18:5];
      equal_3518_s20_q <= equal_3518_s19_q;
      equal_3625_s20_q <= equal_3625;
      less_3647_s20_q <= {{4{sum_3646[11]}}, sum_3646} < 16'h3;
      or_3744_s20_q <= or_3744_s19_q;
      select_3752_s20_q <= select_3752_s19_q;
      equal_3765_s20_q <= equal_3765_s19_q;
      equal_3767_s20_q <= equal_3767_s19_q;
      equal_3768_s20_q <= equal_3768_s19_q;
      equal_3769_s20_q <= equal_3769_s19_q;
      equal_3770_s20_q <= equal_3770_s19_q;
      select_4007_s20_q <= select_4007_s19_q;
      select_4014_s20_q <= select_4014_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
  logic registration_moved_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic good_known_q;
  // hls/stages/census.hpp:281
  logic [13:0] sum_636;
  assign sum_636 = {2'h0, census_changes_values_1_left_s20_q} + {1'b0, sum_635_s20_q};
  logic [13:0] sum_637;
  assign sum_637 = {2'h0, census_changes_values_2_left_q} + sum_636;
  // hls/stages/patches.hpp:134
  logic [4:0] select_1777;
  assign select_1777 = or_1776_s20_q ? {and_1598_s20_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1781;
  assign select_1781 = or_1780_s20_q ? {and_1598_s20_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1777[4] ? select_1781[3:0] : select_1777[3:0];
  logic and_1786;
  assign and_1786 = select_1744_s20_q & (select_1738_s20_q[3] ^ select_1738_s20_q[4]);
  logic and_1791;
  assign and_1791 = sample_pair_whole_s20_q & (and_1786 & ((~select_1777[4]) | (~select_1781[4])));
  // hls/stages/agreement.hpp:1009
  logic and_2004;
  assign and_2004 = good_known_q & not_2003_s20_q;
  // hls/stages/agreement.hpp:1079
  logic is_seen;
  assign is_seen = equal_1983_s20_q ? and_2004 : not_2019_s20_q;
  // hls/stages/agreement.hpp:514
  logic [11:0] select_2181;
  assign select_2181 = and_524_s20_q ? census_changes_values_1_left_s20_q : census_changes_values_2_left_q;
  logic [11:0] select_2182;
  assign select_2182 = and_524_s20_q ? census_changes_values_1_right_s20_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_2186;
  assign sum_2186 = {2'h0, census_changes_values_1_right_s20_q} + {1'b0, sum_2185_s20_q};
  logic [13:0] sum_2187;
  assign sum_2187 = {2'h0, census_changes_values_2_right_q} + sum_2186;
  // hls/stages/census.hpp:357
  logic [23:0] select_2215;
  assign select_2215 = equal_2184_s20_q ? {11'h0, select_2213_s20_q} : (sharpness_sums_detail_0_q + {11'h0, select_2213_s20_q});
  logic [23:0] select_2227;
  assign select_2227 = equal_2184_s20_q ? {11'h0, select_2225_s20_q} : (sharpness_sums_detail_1_q + {11'h0, select_2225_s20_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_2250;
  assign select_2250 = (less_2238_s20_q & and_2248_s20_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2260;
  assign select_2260 = (less_2238_s20_q & and_2258_s20_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:213
  logic [1:0] select_2269;
  assign select_2269 = equal_2237_s20_q ? {sharpness_comparing_contrast_0_q[0], and_2258_s20_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2271;
  assign select_2271 = equal_2237_s20_q ? {sharpness_comparing_contrast_1_q[0], and_2248_s20_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_2294;
  assign xor_2294 = sharpness_comparing_contrast_0_q[1] ^ and_2248_s20_q;
  logic select_2297;
  assign select_2297 = (equal_2281_s20_q | xor_2294) ? (and_2248_s20_q & xor_2294) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:213
  logic select_2298;
  assign select_2298 = equal_2237_s20_q ? select_2297 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2300;
  assign xor_2300 = sharpness_comparing_contrast_1_q[1] ^ and_2258_s20_q;
  logic select_2303;
  assign select_2303 = (equal_2281_s20_q | xor_2300) ? (and_2258_s20_q & xor_2300) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:213
  logic select_2304;
  assign select_2304 = equal_2237_s20_q ? select_2303 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1082
  logic not_2475;
  assign not_2475 = ~(equal_1983_s20_q ? and_2004 : not_2473_s20_q);
  // hls/stages/agreement.hpp:780
  logic and_2478;
  assign and_2478 = ends_cell_s20_q & (not_2458_s20_q & (centres_values_1_textured_s20_q & not_2475));
  // hls/stages/agreement.hpp:1114
  logic [9:0] select_2491;
  assign select_2491 = ((~(select_2484_s20_q[9:4] == 6'h0)) & less_2489_s20_q) ? select_2484_s20_q : 10'h0;
  // hls/stages/agreement.hpp:780
  logic [9:0] select_2494;
  assign select_2494 = equal_1489_s20_q ? (x_s20_q[6] ? (equal_1530_s20_q ? 10'h0 : select_2491) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1086
  logic and_2512;
  assign and_2512 = centres_values_1_textured_s20_q & (centres_values_1_of_skin_s20_q & not_2475);
  // hls/stages/agreement.hpp:270
  logic [4:0] select_2855;
  assign select_2855 = sample_pair_whole_s20_q ? (select_1777[4] ? {1'b1, select_1777[3:0]} : (select_1777 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2858;
  assign select_2858 = sample_pair_whole_s20_q ? (select_1781[4] ? {1'b1, select_1781[3:0]} : (select_1781 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3072;
  assign parity_3072 = ^{or_3069_s20_q, or_3065_s20_q, or_3061_s20_q};
  logic parity_3087;
  assign parity_3087 = ^{or_3084_s20_q, or_3080_s20_q, or_3076_s20_q};
  logic parity_3090;
  assign parity_3090 = ^{or_3084_s20_q, or_3080_s20_q, or_3076_s20_q, or_3069_s20_q, or_3065_s20_q, or_3061_s20_q, or_3054_s20_q, or_3050_s20_q, or_3046_s20_q};
  logic parity_3121;
  assign parity_3121 = ^{or_3118_s20_q, or_3114_s20_q, or_3110_s20_q};
  logic parity_3136;
  assign parity_3136 = ^{or_3133_s20_q, or_3129_s20_q, or_3125_s20_q};
  logic parity_3139;
  assign parity_3139 = ^{or_3133_s20_q, or_3129_s20_q, or_3125_s20_q, or_3118_s20_q, or_3114_s20_q, or_3110_s20_q, or_3102_s20_q, or_3098_s20_q, or_3094_s20_q};
  logic parity_3154;
  assign parity_3154 = ^{or_3151_s20_q, or_3147_s20_q, or_3143_s20_q};
  logic parity_3166;
  assign parity_3166 = ^{or_3163_s20_q, or_3159_s20_q, and_3155_s20_q};
  logic parity_3169;
  assign parity_3169 = ^{or_3163_s20_q, or_3159_s20_q, and_3155_s20_q, or_3151_s20_q, or_3147_s20_q, or_3143_s20_q, or_3133_s20_q, or_3129_s20_q, or_3125_s20_q, or_3118_s20_q, or_3114_s20_q, or_3110_s20_q, or_3102_s20_q, or_3098_s20_q, or_3094_s20_q};
  logic parity_3171;
  assign parity_3171 = ^{or_3163_s20_q, or_3159_s20_q, and_3155_s20_q, or_3151_s20_q, or_3147_s20_q, or_3143_s20_q, or_3133_s20_q, or_3129_s20_q, or_3125_s20_q, or_3118_s20_q, or_3114_s20_q, or_3110_s20_q, or_3102_s20_q, or_3098_s20_q, or_3094_s20_q, or_3084_s20_q, or_3080_s20_q, or_3076_s20_q, or_3069_s20_q, or_3065_s20_q, or_3061_s20_q, or_3054_s20_q, or_3050_s20_q, or_3046_s20_q};
  // hls/stages/count_bits.hpp:25
  logic and_3172;
  assign and_3172 = parity_3090 & parity_3169;
  logic and_3175;
  assign and_3175 = (^{or_3054_s20_q, or_3050_s20_q, or_3046_s20_q}) & (parity_3072 | parity_3087);
  logic or_3176;
  assign or_3176 = (parity_3072 & parity_3087) | and_3175;
  logic or_3180;
  assign or_3180 = (parity_3154 & parity_3166) | (parity_3139 & (parity_3154 | parity_3166));
  logic and_3186;
  assign and_3186 = (^{or_3102_s20_q, or_3098_s20_q, or_3094_s20_q}) & (parity_3121 | parity_3136);
  logic or_3187;
  assign or_3187 = (parity_3121 & parity_3136) | and_3186;
  logic or_3191;
  assign or_3191 = (or_3147_s20_q & or_3151_s20_q) | (or_3143_s20_q & (or_3147_s20_q | or_3151_s20_q));
  logic or_3195;
  assign or_3195 = (or_3159_s20_q & or_3163_s20_q) | (and_3155_s20_q & (or_3159_s20_q | or_3163_s20_q));
  // hls/stages/count_bits.hpp:23
  logic or_3202;
  assign or_3202 = (or_3098_s20_q & or_3102_s20_q) | (or_3094_s20_q & (or_3098_s20_q | or_3102_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3206;
  assign or_3206 = (or_3114_s20_q & or_3118_s20_q) | (or_3110_s20_q & (or_3114_s20_q | or_3118_s20_q));
  logic or_3210;
  assign or_3210 = (or_3129_s20_q & or_3133_s20_q) | (or_3125_s20_q & (or_3129_s20_q | or_3133_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3213;
  assign parity_3213 = ^{or_3210, or_3206, or_3202};
  // hls/stages/count_bits.hpp:23
  logic or_3217;
  assign or_3217 = (or_3050_s20_q & or_3054_s20_q) | (or_3046_s20_q & (or_3050_s20_q | or_3054_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3221;
  assign or_3221 = (or_3065_s20_q & or_3069_s20_q) | (or_3061_s20_q & (or_3065_s20_q | or_3069_s20_q));
  logic or_3225;
  assign or_3225 = (or_3080_s20_q & or_3084_s20_q) | (or_3076_s20_q & (or_3080_s20_q | or_3084_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3228;
  assign parity_3228 = ^{or_3225, or_3221, or_3217};
  logic parity_3231;
  assign parity_3231 = ^{or_3225, or_3221, or_3217, or_3210, or_3206, or_3202, or_3195, or_3191, or_3187};
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3410;
  assign difference_3410 = select_3407_s20_q - select_3397_s20_q;
  // hls/stages/patches.hpp:594
  logic or_3417;
  assign or_3417 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3397_s20_q);
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3441;
  assign sum_3441 = select_3366_s20_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [7:0] difference_3461;
  assign difference_3461 = {sum_3441, select_3366_s20_q[2:0], 3'h0} - {5'h0, fraction_s20_q};
  logic [7:0] select_3462;
  assign select_3462 = less_3440_s20_q ? difference_3461 : {sum_3441, select_3366_s20_q[2:0], fraction_s20_q};
  // hls/stages/agreement.hpp:780
  logic select_3764;
  assign select_3764 = equal_1489_s20_q ? ((x_s20_q[6] & good_known_q) | equal_3625_s20_q) : good_known_q;
  // hls/stages/agreement.hpp:1279
  logic and_3939;
  assign and_3939 = and_2044_s20_q & ({sum_1970_s20_q, index_2_s20_q} == {sum_1957_s20_q, index_s20_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1375; read in stage 20, written in stage 21: 20 < 21 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1957_s20_q, index_s20_q};
  logic map_re;
  assign map_re = s20_en & (and_1964_s20_q & less_1965_s20_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1536_s20_q, lower_half_s20_q, registration_of_right_s20_q};
  logic registration_sums_we;
  assign registration_sums_we = s20_en & and_1595_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1594_s20_q, sum_1590_s20_q};
  end
`ifndef SYNTHESIS
  logic [3:0] registration_sums_raddr_s17_sim;
  logic registration_sums_re_s17_sim;
  logic [3:0] registration_sums_raddr_s18_sim;
  logic registration_sums_re_s18_sim;
  logic [3:0] registration_sums_raddr_s19_sim;
  logic registration_sums_re_s19_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_sums_re_s17_sim <= 1'b0;
      registration_sums_re_s18_sim <= 1'b0;
      registration_sums_re_s19_sim <= 1'b0;
    end else if (en_i) begin
      registration_sums_re_s17_sim <= registration_sums_re;
      registration_sums_raddr_s17_sim <= registration_sums_raddr;
      registration_sums_re_s18_sim <= registration_sums_re_s17_sim;
      registration_sums_raddr_s18_sim <= registration_sums_raddr_s17_sim;
      registration_sums_re_s19_sim <= registration_sums_re_s18_sim;
      registration_sums_raddr_s19_sim <= registration_sums_raddr_s18_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s17_sim && registration_sums_raddr_s17_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s18_sim && registration_sums_raddr_s18_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s19_sim && registration_sums_raddr_s19_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_waddr >= 4'd12) $error("registration_sums: write outside, address %0d", registration_sums_waddr);
    end
    if (rst_ni && registration_sums_re && registration_sums_raddr >= 4'd12) $error("registration_sums: read outside, address %0d", registration_sums_raddr);
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
      registration_moved_q <= 1'b0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      good_known_q <= 1'b0;
    end else if (s20_en) begin
      sharpness_sums_detail_0_q <= and_524_s20_q ? select_2215 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_524_s20_q ? select_2227 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2269 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2271 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_2298 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_2304 : sharpness_comparing_less_contrast_1_q;
      registration_moved_q <= not_2723_s20_q & (registration_moved_q | and_2745_s20_q);
      patches_left_next_0_q <= select_2855;
      patches_left_next_1_q <= select_2858;
      good_known_q <= select_3764;
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
    if (s20_en) begin
      census_changes_values_2_left_q <= select_2181;
      census_changes_values_2_right_q <= select_2182;
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
  logic census_columns_values_1_cell_2_of_skin_s21_q;
  logic [23:0] sharpness_sums_detail_0_s21_q;
  logic [23:0] sharpness_sums_detail_1_s21_q;
  logic [23:0] sharpness_sums_contrast_0_s21_q;
  logic [23:0] sharpness_sums_contrast_1_s21_q;
  logic [6:0] x_s21_q;
  logic [13:0] counts_nearer_s21_q;
  logic registration_moved_s21_q;
  logic patches_lower_s21_q;
  logic patches_second_s21_q;
  logic [4:0] patches_summed_row_column_s21_q;
  logic patches_summed_first_s21_q;
  logic patches_summed_last_s21_q;
  logic [4:0] patches_summed_down_by_s21_q;
  logic [13:0] product_s21_q;
  logic done_s21_q;
  logic [6:0] column_s21_q;
  logic and_524_s21_q;
  logic so_s21_q;
  logic less_558_s21_q;
  logic less_559_s21_q;
  logic less_560_s21_q;
  logic less_561_s21_q;
  logic less_562_s21_q;
  logic less_563_s21_q;
  logic less_564_s21_q;
  logic less_565_s21_q;
  logic less_566_s21_q;
  logic less_567_s21_q;
  logic less_568_s21_q;
  logic less_569_s21_q;
  logic less_570_s21_q;
  logic less_571_s21_q;
  logic less_572_s21_q;
  logic less_573_s21_q;
  logic less_574_s21_q;
  logic less_575_s21_q;
  logic less_576_s21_q;
  logic less_577_s21_q;
  logic less_578_s21_q;
  logic less_579_s21_q;
  logic less_580_s21_q;
  logic less_581_s21_q;
  logic and_589_s21_q;
  logic and_614_s21_q;
  logic and_615_s21_q;
  logic [8:0] sum_637_s21_q;
  logic equal_1489_s21_q;
  logic not_1490_s21_q;
  logic equal_1530_s21_q;
  logic equal_1538_s21_q;
  logic equal_1540_s21_q;
  logic equal_1542_s21_q;
  logic equal_1544_s21_q;
  logic equal_1546_s21_q;
  logic equal_1548_s21_q;
  logic and_1598_s21_q;
  logic select_1615_s21_q;
  logic equal_1616_s21_q;
  logic equal_1708_s21_q;
  logic equal_1710_s21_q;
  logic select_1724_s21_q;
  logic or_1734_s21_q;
  logic [4:0] select_1738_s21_q;
  logic select_1744_s21_q;
  logic or_1763_s21_q;
  logic [3:0] column_5_s21_q;
  logic [3:0] select_1783_s21_q;
  logic select_1784_s21_q;
  logic and_1791_s21_q;
  logic less_1869_s21_q;
  logic equal_1870_s21_q;
  logic not_1871_s21_q;
  logic equal_1872_s21_q;
  logic not_1898_s21_q;
  logic and_1964_s21_q;
  logic less_1965_s21_q;
  logic [2:0] index_2_s21_q;
  logic [10:0] sum_1970_s21_q;
  logic is_seen_s21_q;
  logic and_2034_s21_q;
  logic and_2044_s21_q;
  logic equal_2184_s21_q;
  logic [8:0] sum_2187_s21_q;
  logic equal_2237_s21_q;
  logic less_2238_s21_q;
  logic [17:0] select_2250_s21_q;
  logic [17:0] select_2260_s21_q;
  logic equal_2281_s21_q;
  logic and_2433_s21_q;
  logic and_2480_s21_q;
  logic [9:0] select_2484_s21_q;
  logic [9:0] select_2487_s21_q;
  logic [9:0] select_2494_s21_q;
  logic and_2515_s21_q;
  logic and_2535_s21_q;
  logic equal_2710_s21_q;
  logic parity_3042_s21_q;
  logic parity_3171_s21_q;
  logic and_3172_s21_q;
  logic or_3176_s21_q;
  logic or_3180_s21_q;
  logic or_3187_s21_q;
  logic or_3191_s21_q;
  logic or_3195_s21_q;
  logic or_3202_s21_q;
  logic or_3206_s21_q;
  logic or_3210_s21_q;
  logic or_3217_s21_q;
  logic or_3221_s21_q;
  logic or_3225_s21_q;
  logic parity_3231_s21_q;
  logic or_3241_s21_q;
  logic or_3245_s21_q;
  logic and_3252_s21_q;
  logic and_3254_s21_q;
  logic and_3256_s21_q;
  logic equal_3278_s21_q;
  logic equal_3409_s21_q;
  logic less_3411_s21_q;
  logic less_3412_s21_q;
  logic or_3417_s21_q;
  logic [7:0] select_3462_s21_q;
  logic [13:0] product_3467_s21_q;
  logic equal_3518_s21_q;
  logic equal_3625_s21_q;
  logic less_3647_s21_q;
  logic or_3744_s21_q;
  logic select_3752_s21_q;
  logic equal_3765_s21_q;
  logic equal_3767_s21_q;
  logic equal_3768_s21_q;
  logic equal_3769_s21_q;
  logic equal_3770_s21_q;
  logic and_3924_s21_q;
  logic and_3939_s21_q;
  logic [31:0] select_4007_s21_q;
  logic [9:0] select_4014_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= mask_s20_q;
      marks_first_s21_q <= marks_first_s20_q;
      marks_last_s21_q <= marks_last_s20_q;
      sample_pair_pixel_0_s21_q <= sample_pair_pixel_0_s20_q;
      sample_pair_pixel_1_s21_q <= sample_pair_pixel_1_s20_q;
      sample_pair_whole_s21_q <= sample_pair_whole_s20_q;
      sample_present_s21_q <= sample_present_s20_q;
      census_columns_values_1_cell_2_of_skin_s21_q <= census_columns_values_1_cell_2_of_skin_s20_q;
      sharpness_sums_detail_0_s21_q <= sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_s21_q <= sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_s21_q <= sharpness_sums_contrast_0_s20_q;
      sharpness_sums_contrast_1_s21_q <= sharpness_sums_contrast_1_s20_q;
      x_s21_q <= x_s20_q;
      counts_nearer_s21_q <= counts_nearer_s20_q;
      registration_moved_s21_q <= registration_moved_q;
      patches_lower_s21_q <= patches_lower_s20_q;
      patches_second_s21_q <= patches_second_s20_q;
      patches_summed_row_column_s21_q <= patches_summed_row_column_s20_q;
      patches_summed_first_s21_q <= patches_summed_first_s20_q;
      patches_summed_last_s21_q <= patches_summed_last_s20_q;
      patches_summed_down_by_s21_q <= patches_summed_down_by_s20_q;
      product_s21_q <= product_s20_q;
      done_s21_q <= done_s20_q;
      column_s21_q <= column_s20_q;
      and_524_s21_q <= and_524_s20_q;
      so_s21_q <= drew_q;
      less_558_s21_q <= less_558_s20_q;
      less_559_s21_q <= less_559_s20_q;
      less_560_s21_q <= less_560_s20_q;
      less_561_s21_q <= less_561_s20_q;
      less_562_s21_q <= less_562_s20_q;
      less_563_s21_q <= less_563_s20_q;
      less_564_s21_q <= less_564_s20_q;
      less_565_s21_q <= less_565_s20_q;
      less_566_s21_q <= less_566_s20_q;
      less_567_s21_q <= less_567_s20_q;
      less_568_s21_q <= less_568_s20_q;
      less_569_s21_q <= less_569_s20_q;
      less_570_s21_q <= less_570_s20_q;
      less_571_s21_q <= less_571_s20_q;
      less_572_s21_q <= less_572_s20_q;
      less_573_s21_q <= less_573_s20_q;
      less_574_s21_q <= less_574_s20_q;
      less_575_s21_q <= less_575_s20_q;
      less_576_s21_q <= less_576_s20_q;
      less_577_s21_q <= less_577_s20_q;
      less_578_s21_q <= less_578_s20_q;
      less_579_s21_q <= less_579_s20_q;
      less_580_s21_q <= less_580_s20_q;
      less_581_s21_q <= less_581_s20_q;
      and_589_s21_q <= and_589_s20_q;
      and_614_s21_q <= and_614_s20_q;
      and_615_s21_q <= and_615_s20_q;
      sum_637_s21_q <= sum_637[13:5];
      equal_1489_s21_q <= equal_1489_s20_q;
      not_1490_s21_q <= not_1490_s20_q;
      equal_1530_s21_q <= equal_1530_s20_q;
      equal_1538_s21_q <= equal_1538_s20_q;
      equal_1540_s21_q <= equal_1540_s20_q;
      equal_1542_s21_q <= equal_1542_s20_q;
      equal_1544_s21_q <= equal_1544_s20_q;
      equal_1546_s21_q <= equal_1546_s20_q;
      equal_1548_s21_q <= equal_1548_s20_q;
      and_1598_s21_q <= and_1598_s20_q;
      select_1615_s21_q <= select_1615_s20_q;
      equal_1616_s21_q <= equal_1616_s20_q;
      equal_1708_s21_q <= equal_1708_s20_q;
      equal_1710_s21_q <= equal_1710_s20_q;
      select_1724_s21_q <= select_1724_s20_q;
      or_1734_s21_q <= and_1598_s20_q | (select_1726_s20_q & equal_1732_s20_q);
      select_1738_s21_q <= select_1738_s20_q;
      select_1744_s21_q <= select_1744_s20_q;
      or_1763_s21_q <= and_1598_s20_q | (select_1755_s20_q & equal_1761_s20_q);
      column_5_s21_q <= column_5;
      select_1783_s21_q <= select_1783_s20_q;
      select_1784_s21_q <= or_1776_s20_q ? and_1598_s20_q : patches_left_next_0_q[4];
      and_1791_s21_q <= and_1791;
      less_1869_s21_q <= less_1869_s20_q;
      equal_1870_s21_q <= equal_1870_s20_q;
      not_1871_s21_q <= not_1871_s20_q;
      equal_1872_s21_q <= equal_1872_s20_q;
      not_1898_s21_q <= not_1898_s20_q;
      and_1964_s21_q <= and_1964_s20_q;
      less_1965_s21_q <= less_1965_s20_q;
      index_2_s21_q <= index_2_s20_q;
      sum_1970_s21_q <= sum_1970_s20_q;
      is_seen_s21_q <= is_seen;
      and_2034_s21_q <= is_seen & less_2033_s20_q;
      and_2044_s21_q <= and_2044_s20_q;
      equal_2184_s21_q <= equal_2184_s20_q;
      sum_2187_s21_q <= sum_2187[13:5];
      equal_2237_s21_q <= equal_2237_s20_q;
      less_2238_s21_q <= less_2238_s20_q;
      select_2250_s21_q <= select_2250;
      select_2260_s21_q <= select_2260;
      equal_2281_s21_q <= equal_2281_s20_q;
      and_2433_s21_q <= and_2433_s20_q;
      and_2480_s21_q <= not_1490_s20_q & (drew_q & and_2478);
      select_2484_s21_q <= select_2484_s20_q;
      select_2487_s21_q <= select_2487_s20_q;
      select_2494_s21_q <= select_2494;
      and_2515_s21_q <= drew_q & (ends_cell_s20_q & (not_2458_s20_q & and_2512));
      and_2535_s21_q <= and_2535_s20_q;
      equal_2710_s21_q <= equal_2710_s20_q;
      parity_3042_s21_q <= parity_3042_s20_q;
      parity_3171_s21_q <= parity_3171;
      and_3172_s21_q <= and_3172;
      or_3176_s21_q <= or_3176;
      or_3180_s21_q <= or_3180;
      or_3187_s21_q <= or_3187;
      or_3191_s21_q <= or_3191;
      or_3195_s21_q <= or_3195;
      or_3202_s21_q <= or_3202;
      or_3206_s21_q <= or_3206;
      or_3210_s21_q <= or_3210;
      or_3217_s21_q <= or_3217;
      or_3221_s21_q <= or_3221;
      or_3225_s21_q <= or_3225;
      parity_3231_s21_q <= parity_3231;
      or_3241_s21_q <= (or_3206 & or_3210) | (or_3202 & (or_3206 | or_3210));
      or_3245_s21_q <= (or_3221 & or_3225) | (or_3217 & (or_3221 | or_3225));
      and_3252_s21_q <= and_3172 & (or_3176 | or_3180);
      and_3254_s21_q <= parity_3213 & parity_3228;
      and_3256_s21_q <= (^{or_3195, or_3191, or_3187}) & (parity_3213 | parity_3228);
      equal_3278_s21_q <= equal_3278_s20_q;
      equal_3409_s21_q <= select_3366_s20_q[3:0] == 4'h0;
      less_3411_s21_q <= {difference_3410, 3'h0} < {3'h0, patches_size_q};
      less_3412_s21_q <= select_3407_s20_q < select_3397_s20_q;
      or_3417_s21_q <= or_3417;
      select_3462_s21_q <= select_3462;
      product_3467_s21_q <= product_3467_s20_q;
      equal_3518_s21_q <= equal_3518_s20_q;
      equal_3625_s21_q <= equal_3625_s20_q;
      less_3647_s21_q <= less_3647_s20_q;
      or_3744_s21_q <= or_3744_s20_q;
      select_3752_s21_q <= select_3752_s20_q;
      equal_3765_s21_q <= equal_3765_s20_q;
      equal_3767_s21_q <= equal_3767_s20_q;
      equal_3768_s21_q <= equal_3768_s20_q;
      equal_3769_s21_q <= equal_3769_s20_q;
      equal_3770_s21_q <= equal_3770_s20_q;
      and_3924_s21_q <= said_q;
      and_3939_s21_q <= and_3939;
      select_4007_s21_q <= select_4007_s20_q;
      select_4014_s21_q <= select_4014_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_unproven_q;
  logic [13:0] counts_on_skin_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic proven_q;
  // hls/stages/patches.hpp:133
  logic [5:0] select_1745;
  assign select_1745 = or_1734_s21_q ? {and_1598_s21_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1747;
  assign and_1747 = select_1744_s21_q & (~select_1745[5]);
  // hls/stages/patches.hpp:133
  logic [5:0] select_1765;
  assign select_1765 = or_1763_s21_q ? {and_1598_s21_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1767;
  assign and_1767 = select_1744_s21_q & (~select_1765[5]);
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2250_s21_q};
  // hls/stages/agreement.hpp:213
  logic [17:0] select_2253;
  assign select_2253 = equal_2237_s21_q ? (less_2238_s21_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2260_s21_q};
  // hls/stages/agreement.hpp:213
  logic [17:0] select_2263;
  assign select_2263 = equal_2237_s21_q ? (less_2238_s21_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2482;
  assign select_2482 = and_2433_s21_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2480_s21_q});
  logic [13:0] select_2496;
  assign select_2496 = and_2433_s21_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2494_s21_q});
  // hls/stages/agreement.hpp:780
  logic and_2516;
  assign and_2516 = not_1490_s21_q & and_2515_s21_q;
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2518;
  assign select_2518 = and_2433_s21_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2516});
  logic [13:0] select_2537;
  assign select_2537 = and_2433_s21_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2535_s21_q});
  // hls/stages/patches.hpp:127
  logic select_2838;
  assign select_2838 = equal_1616_s21_q ? patches_valid_0_q : (select_1615_s21_q ? patches_valid_0_q : select_1724_s21_q);
  // hls/stages/agreement.hpp:270
  logic select_2841;
  assign select_2841 = sample_pair_whole_s21_q ? (and_1747 ? (sample_present_s21_q & select_2838) : select_2838) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_2843;
  assign select_2843 = equal_1616_s21_q ? patches_valid_1_q : (select_1615_s21_q ? select_1724_s21_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:270
  logic select_2846;
  assign select_2846 = sample_pair_whole_s21_q ? (and_1767 ? (sample_present_s21_q & select_2843) : select_2843) : patches_valid_1_q;
  logic [5:0] select_2849;
  assign select_2849 = sample_pair_whole_s21_q ? (select_1745[5] ? {1'b1, select_1745[4:0]} : (select_1745 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2852;
  assign select_2852 = sample_pair_whole_s21_q ? (select_1765[5] ? {1'b1, select_1765[4:0]} : (select_1765 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3233;
  assign parity_3233 = ^{or_3225_s21_q, or_3221_s21_q, or_3217_s21_q, or_3210_s21_q, or_3206_s21_q, or_3202_s21_q, or_3195_s21_q, or_3191_s21_q, or_3187_s21_q, or_3180_s21_q, or_3176_s21_q, and_3172_s21_q};
  // hls/stages/count_bits.hpp:25
  logic or_3237;
  assign or_3237 = (or_3191_s21_q & or_3195_s21_q) | (or_3187_s21_q & (or_3191_s21_q | or_3195_s21_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3248;
  assign parity_3248 = ^{or_3245_s21_q, or_3241_s21_q, or_3237};
  // hls/stages/count_bits.hpp:25
  logic and_3249;
  assign and_3249 = (^{or_3180_s21_q, or_3176_s21_q, and_3172_s21_q}) & parity_3231_s21_q;
  logic or_3253;
  assign or_3253 = (or_3176_s21_q & or_3180_s21_q) | and_3252_s21_q;
  logic or_3257;
  assign or_3257 = and_3254_s21_q | and_3256_s21_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3260;
  assign parity_3260 = ^{or_3257, or_3253, and_3249};
  // hls/stages/count_bits.hpp:25
  logic and_3262;
  assign and_3262 = parity_3248 & parity_3260;
  logic or_3266;
  assign or_3266 = (or_3241_s21_q & or_3245_s21_q) | (or_3237 & (or_3241_s21_q | or_3245_s21_q));
  logic or_3270;
  assign or_3270 = (or_3253 & or_3257) | (and_3249 & (or_3253 | or_3257));
  // hls/stages/patches.hpp:594
  logic or_3418;
  assign or_3418 = (~(patches_second_s21_q ? patches_valid_1_q : patches_valid_0_q)) | or_3417_s21_q;
  logic or_3421;
  assign or_3421 = equal_3409_s21_q | (less_3411_s21_q | (less_3412_s21_q | or_3418));
  // hls/stages/patches.hpp:593
  logic [14:0] difference_3468;
  assign difference_3468 = {{7{select_3462_s21_q[7]}}, select_3462_s21_q} - {product_3467_s21_q[13], product_3467_s21_q};
  // hls/stages/patches.hpp:599
  logic less_3469;
  assign less_3469 = $signed({{8{difference_3439[6]}}, difference_3439}) < $signed(difference_3468);
  // hls/stages/agreement.hpp:1101
  logic [13:0] select_3772;
  assign select_3772 = equal_3769_s21_q ? counts_skin_unproven_q : (equal_3770_s21_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3774;
  assign select_3774 = equal_3768_s21_q ? counts_regions_bad_q : (equal_3765_s21_q ? counts_nearer_s21_q : select_3772);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3767_s21_q ? counts_on_skin_q : select_3774;
  // hls/stages/agreement.hpp:1116
  logic [31:0] select_4008;
  assign select_4008 = equal_1548_s21_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4007_s21_q;
  logic [31:0] select_4009;
  assign select_4009 = equal_1546_s21_q ? {8'h0, sharpness_sums_detail_0_s21_q} : select_4008;
  logic [31:0] select_4010;
  assign select_4010 = equal_1544_s21_q ? {8'h0, sharpness_sums_detail_1_s21_q} : select_4009;
  logic [31:0] select_4011;
  assign select_4011 = equal_1542_s21_q ? {8'h0, sharpness_sums_contrast_0_s21_q} : select_4010;
  logic [31:0] select_4012;
  assign select_4012 = equal_1540_s21_q ? {8'h0, sharpness_sums_contrast_1_s21_q} : select_4011;

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1784_s21_q, select_1783_s21_q, column_5_s21_q};
  logic patches_left_we;
  assign patches_left_we = s21_en & and_1791_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s21_q;
  end
`ifndef SYNTHESIS
  logic [8:0] patches_left_raddr_s11_sim;
  logic patches_left_re_s11_sim;
  logic [8:0] patches_left_raddr_s12_sim;
  logic patches_left_re_s12_sim;
  logic [8:0] patches_left_raddr_s13_sim;
  logic patches_left_re_s13_sim;
  logic [8:0] patches_left_raddr_s14_sim;
  logic patches_left_re_s14_sim;
  logic [8:0] patches_left_raddr_s15_sim;
  logic patches_left_re_s15_sim;
  logic [8:0] patches_left_raddr_s16_sim;
  logic patches_left_re_s16_sim;
  logic [8:0] patches_left_raddr_s17_sim;
  logic patches_left_re_s17_sim;
  logic [8:0] patches_left_raddr_s18_sim;
  logic patches_left_re_s18_sim;
  logic [8:0] patches_left_raddr_s19_sim;
  logic patches_left_re_s19_sim;
  logic [8:0] patches_left_raddr_s20_sim;
  logic patches_left_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_re_s11_sim <= 1'b0;
      patches_left_re_s12_sim <= 1'b0;
      patches_left_re_s13_sim <= 1'b0;
      patches_left_re_s14_sim <= 1'b0;
      patches_left_re_s15_sim <= 1'b0;
      patches_left_re_s16_sim <= 1'b0;
      patches_left_re_s17_sim <= 1'b0;
      patches_left_re_s18_sim <= 1'b0;
      patches_left_re_s19_sim <= 1'b0;
      patches_left_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_re_s11_sim <= patches_left_re;
      patches_left_raddr_s11_sim <= patches_left_raddr;
      patches_left_re_s12_sim <= patches_left_re_s11_sim;
      patches_left_raddr_s12_sim <= patches_left_raddr_s11_sim;
      patches_left_re_s13_sim <= patches_left_re_s12_sim;
      patches_left_raddr_s13_sim <= patches_left_raddr_s12_sim;
      patches_left_re_s14_sim <= patches_left_re_s13_sim;
      patches_left_raddr_s14_sim <= patches_left_raddr_s13_sim;
      patches_left_re_s15_sim <= patches_left_re_s14_sim;
      patches_left_raddr_s15_sim <= patches_left_raddr_s14_sim;
      patches_left_re_s16_sim <= patches_left_re_s15_sim;
      patches_left_raddr_s16_sim <= patches_left_raddr_s15_sim;
      patches_left_re_s17_sim <= patches_left_re_s16_sim;
      patches_left_raddr_s17_sim <= patches_left_raddr_s16_sim;
      patches_left_re_s18_sim <= patches_left_re_s17_sim;
      patches_left_raddr_s18_sim <= patches_left_raddr_s17_sim;
      patches_left_re_s19_sim <= patches_left_re_s18_sim;
      patches_left_raddr_s19_sim <= patches_left_raddr_s18_sim;
      patches_left_re_s20_sim <= patches_left_re_s19_sim;
      patches_left_raddr_s20_sim <= patches_left_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_we) begin
      if (patches_left_re && patches_left_raddr == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s11_sim && patches_left_raddr_s11_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s12_sim && patches_left_raddr_s12_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s13_sim && patches_left_raddr_s13_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s14_sim && patches_left_raddr_s14_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s15_sim && patches_left_raddr_s15_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s16_sim && patches_left_raddr_s16_sim == patches_left_waddr) begin
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
    end
  end
`endif

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1970_s21_q, index_2_s21_q};
  logic map_we;
  assign map_we = s21_en & and_2044_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2034_s21_q, is_seen_s21_q};
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
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_unproven_q <= 14'h0;
      counts_on_skin_q <= 14'h0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      proven_q <= 1'b0;
    end else if (s21_en) begin
      sharpness_comparing_rest_0_q <= so_s21_q ? select_2253 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s21_q ? select_2263 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2482;
      counts_regions_bad_q <= select_2496;
      counts_skin_unproven_q <= select_2518;
      counts_on_skin_q <= select_2537;
      patches_valid_0_q <= select_2841;
      patches_valid_1_q <= select_2846;
      patches_right_next_0_q <= select_2849;
      patches_right_next_1_q <= select_2852;
      proven_q <= marks_first_s21_q ? done_s21_q : proven_q;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic [7:0] sample_pair_pixel_1_s22_q;
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic [6:0] x_s22_q;
  logic registration_moved_s22_q;
  logic patches_lower_s22_q;
  logic patches_second_s22_q;
  logic [4:0] patches_summed_row_column_s22_q;
  logic patches_summed_first_s22_q;
  logic patches_summed_last_s22_q;
  logic [4:0] patches_summed_down_by_s22_q;
  logic [13:0] product_s22_q;
  logic [6:0] column_s22_q;
  logic and_524_s22_q;
  logic so_s22_q;
  logic less_558_s22_q;
  logic less_559_s22_q;
  logic less_560_s22_q;
  logic less_561_s22_q;
  logic less_562_s22_q;
  logic less_563_s22_q;
  logic less_564_s22_q;
  logic less_565_s22_q;
  logic less_566_s22_q;
  logic less_567_s22_q;
  logic less_568_s22_q;
  logic less_569_s22_q;
  logic less_570_s22_q;
  logic less_571_s22_q;
  logic less_572_s22_q;
  logic less_573_s22_q;
  logic less_574_s22_q;
  logic less_575_s22_q;
  logic less_576_s22_q;
  logic less_577_s22_q;
  logic less_578_s22_q;
  logic less_579_s22_q;
  logic less_580_s22_q;
  logic less_581_s22_q;
  logic and_589_s22_q;
  logic and_614_s22_q;
  logic and_615_s22_q;
  logic less_638_s22_q;
  logic equal_1489_s22_q;
  logic equal_1530_s22_q;
  logic equal_1538_s22_q;
  logic equal_1708_s22_q;
  logic equal_1710_s22_q;
  logic [4:0] select_1735_s22_q;
  logic [4:0] select_1738_s22_q;
  logic and_1748_s22_q;
  logic [4:0] select_1764_s22_q;
  logic and_1768_s22_q;
  logic less_1869_s22_q;
  logic equal_1870_s22_q;
  logic not_1871_s22_q;
  logic equal_1872_s22_q;
  logic not_1898_s22_q;
  logic and_1964_s22_q;
  logic less_1965_s22_q;
  logic [1:0] map_rdata_s22_q;
  logic is_seen_s22_q;
  logic and_2034_s22_q;
  logic equal_2184_s22_q;
  logic and_2189_s22_q;
  logic equal_2237_s22_q;
  logic sum_s22_q;
  logic sum_2_s22_q;
  logic equal_2281_s22_q;
  logic select_2299_s22_q;
  logic select_2305_s22_q;
  logic [9:0] select_2484_s22_q;
  logic [9:0] select_2487_s22_q;
  logic equal_2710_s22_q;
  logic parity_3042_s22_q;
  logic parity_3171_s22_q;
  logic parity_3233_s22_q;
  logic xor_3261_s22_q;
  logic parity_3273_s22_q;
  logic and_3274_s22_q;
  logic and_3276_s22_q;
  logic equal_3278_s22_q;
  logic or_3421_s22_q;
  logic [5:0] difference_3468_s22_q;
  logic not_3470_s22_q;
  logic not_3480_s22_q;
  logic equal_3518_s22_q;
  logic less_3592_s22_q;
  logic less_3593_s22_q;
  logic equal_3625_s22_q;
  logic less_3647_s22_q;
  logic or_3744_s22_q;
  logic select_3752_s22_q;
  logic and_3766_s22_q;
  logic [13:0] before_v_4_s22_q;
  logic not_3811_s22_q;
  logic or_3815_s22_q;
  logic and_3820_s22_q;
  logic less_3821_s22_q;
  logic and_3924_s22_q;
  logic and_3939_s22_q;
  logic not_3954_s22_q;
  logic [31:0] select_4012_s22_q;
  logic [9:0] select_4014_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      sample_pair_pixel_1_s22_q <= sample_pair_pixel_1_s21_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_s21_q;
      x_s22_q <= x_s21_q;
      registration_moved_s22_q <= registration_moved_s21_q;
      patches_lower_s22_q <= patches_lower_s21_q;
      patches_second_s22_q <= patches_second_s21_q;
      patches_summed_row_column_s22_q <= patches_summed_row_column_s21_q;
      patches_summed_first_s22_q <= patches_summed_first_s21_q;
      patches_summed_last_s22_q <= patches_summed_last_s21_q;
      patches_summed_down_by_s22_q <= patches_summed_down_by_s21_q;
      product_s22_q <= product_s21_q;
      column_s22_q <= column_s21_q;
      and_524_s22_q <= and_524_s21_q;
      so_s22_q <= so_s21_q;
      less_558_s22_q <= less_558_s21_q;
      less_559_s22_q <= less_559_s21_q;
      less_560_s22_q <= less_560_s21_q;
      less_561_s22_q <= less_561_s21_q;
      less_562_s22_q <= less_562_s21_q;
      less_563_s22_q <= less_563_s21_q;
      less_564_s22_q <= less_564_s21_q;
      less_565_s22_q <= less_565_s21_q;
      less_566_s22_q <= less_566_s21_q;
      less_567_s22_q <= less_567_s21_q;
      less_568_s22_q <= less_568_s21_q;
      less_569_s22_q <= less_569_s21_q;
      less_570_s22_q <= less_570_s21_q;
      less_571_s22_q <= less_571_s21_q;
      less_572_s22_q <= less_572_s21_q;
      less_573_s22_q <= less_573_s21_q;
      less_574_s22_q <= less_574_s21_q;
      less_575_s22_q <= less_575_s21_q;
      less_576_s22_q <= less_576_s21_q;
      less_577_s22_q <= less_577_s21_q;
      less_578_s22_q <= less_578_s21_q;
      less_579_s22_q <= less_579_s21_q;
      less_580_s22_q <= less_580_s21_q;
      less_581_s22_q <= less_581_s21_q;
      and_589_s22_q <= and_589_s21_q;
      and_614_s22_q <= and_614_s21_q;
      and_615_s22_q <= and_615_s21_q;
      less_638_s22_q <= 9'h4 < sum_637_s21_q;
      equal_1489_s22_q <= equal_1489_s21_q;
      equal_1530_s22_q <= equal_1530_s21_q;
      equal_1538_s22_q <= equal_1538_s21_q;
      equal_1708_s22_q <= equal_1708_s21_q;
      equal_1710_s22_q <= equal_1710_s21_q;
      select_1735_s22_q <= or_1734_s21_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1738_s22_q <= select_1738_s21_q;
      and_1748_s22_q <= sample_pair_whole_s21_q & and_1747;
      select_1764_s22_q <= or_1763_s21_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1768_s22_q <= sample_pair_whole_s21_q & and_1767;
      less_1869_s22_q <= less_1869_s21_q;
      equal_1870_s22_q <= equal_1870_s21_q;
      not_1871_s22_q <= not_1871_s21_q;
      equal_1872_s22_q <= equal_1872_s21_q;
      not_1898_s22_q <= not_1898_s21_q;
      and_1964_s22_q <= and_1964_s21_q;
      less_1965_s22_q <= less_1965_s21_q;
      map_rdata_s22_q <= map_rdata_q;
      is_seen_s22_q <= is_seen_s21_q;
      and_2034_s22_q <= and_2034_s21_q;
      equal_2184_s22_q <= equal_2184_s21_q;
      and_2189_s22_q <= and_614_s21_q & (9'h4 < sum_2187_s21_q);
      equal_2237_s22_q <= equal_2237_s21_q;
      sum_s22_q <= sum[0];
      sum_2_s22_q <= sum_2[0];
      equal_2281_s22_q <= equal_2281_s21_q;
      select_2299_s22_q <= sharpness_comparing_less_contrast_0_q;
      select_2305_s22_q <= sharpness_comparing_less_contrast_1_q;
      select_2484_s22_q <= select_2484_s21_q;
      select_2487_s22_q <= select_2487_s21_q;
      equal_2710_s22_q <= equal_2710_s21_q;
      parity_3042_s22_q <= parity_3042_s21_q;
      parity_3171_s22_q <= parity_3171_s21_q;
      parity_3233_s22_q <= parity_3233;
      xor_3261_s22_q <= parity_3248 ^ parity_3260;
      parity_3273_s22_q <= ^{or_3270, or_3266, and_3262};
      and_3274_s22_q <= or_3266 & or_3270;
      and_3276_s22_q <= and_3262 & (or_3266 | or_3270);
      equal_3278_s22_q <= equal_3278_s21_q;
      or_3421_s22_q <= or_3421;
      difference_3468_s22_q <= difference_3468[5:0];
      not_3470_s22_q <= ~less_3469;
      not_3480_s22_q <= ~($signed(difference_3468) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3518_s22_q <= equal_3518_s21_q;
      less_3592_s22_q <= $signed(15'h10) < $signed(difference_3468);
      less_3593_s22_q <= $signed(difference_3468[14:4]) < $signed(11'h7ff);
      equal_3625_s22_q <= equal_3625_s21_q;
      less_3647_s22_q <= less_3647_s21_q;
      or_3744_s22_q <= or_3744_s21_q;
      select_3752_s22_q <= select_3752_s21_q;
      and_3766_s22_q <= equal_3765_s21_q & equal_3518_s21_q;
      before_v_4_s22_q <= before_v_4;
      not_3811_s22_q <= ~(equal_3770_s21_q & equal_3518_s21_q);
      or_3815_s22_q <= (equal_3770_s21_q | equal_3769_s21_q) | (x_s21_q[6:3] == 4'hf);
      and_3820_s22_q <= equal_3767_s21_q & equal_3518_s21_q;
      less_3821_s22_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_3924_s22_q <= and_3924_s21_q;
      and_3939_s22_q <= and_3939_s21_q;
      not_3954_s22_q <= ~proven_q;
      select_4012_s22_q <= select_4012;
      select_4014_s22_q <= select_4014_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [19:0] census_left_misses_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
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
  logic patches_frame_ended_q;
  logic hides_q;
  // hls/stages/census.hpp:303
  logic and_639;
  assign and_639 = and_589_s22_q & less_638_s22_q;
  // hls/stages/patches.hpp:184
  logic less_1881;
  assign less_1881 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1882;
  assign not_1882 = ~less_1881;
  logic [1:0] select_1883;
  assign select_1883 = patches_summed_first_s22_q ? 2'h2 : {less_1881, not_1882};
  logic [12:0] select_1884;
  assign select_1884 = select_1883[0] ? {4'h0, patches_summed_first_s22_q, 3'h0, patches_summed_row_column_s22_q} : {patches_summed_row_column_s22_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1885;
  assign select_1885 = select_1883[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1886;
  assign select_1886 = select_1883[1] ? {select_1884[12:8], patches_sums_values_0_q[9:8], select_1884[7:0]} : select_1885;
  // hls/stages/census.hpp:306
  logic and_2190;
  assign and_2190 = and_614_s22_q & less_638_s22_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2191;
  assign sum_2191 = census_left_misses_q + {{17{and_2190}}, and_2189_s22_q, 1'b0, and_2189_s22_q};
  // hls/stages/agreement.hpp:514
  logic [19:0] select_2193;
  assign select_2193 = and_524_s22_q ? (equal_2184_s22_q ? 20'h0 : sum_2191) : census_left_misses_q;
  // hls/stages/agreement.hpp:213
  logic [2:0] select_2265;
  assign select_2265 = equal_2237_s22_q ? {sharpness_comparing_product_0_q[1:0], sum_s22_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2267;
  assign select_2267 = equal_2237_s22_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s22_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s22_q});
  // hls/stages/agreement.hpp:213
  logic select_2276;
  assign select_2276 = so_s22_q ? (equal_2237_s22_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s22_q});
  // hls/stages/agreement.hpp:213
  logic select_2279;
  assign select_2279 = equal_2237_s22_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_2282;
  assign xor_2282 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2288;
  assign xor_2288 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/count_bits.hpp:27
  logic or_3277;
  assign or_3277 = and_3274_s22_q | and_3276_s22_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3277, parity_3273_s22_q, xor_3261_s22_q, parity_3233_s22_q, parity_3171_s22_q, parity_3042_s22_q} + (equal_3278_s22_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3282;
  assign select_3282 = equal_1708_s22_q ? patches_sums_values_0_q : (equal_1710_s22_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3283;
  assign select_3283 = equal_1710_s22_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3285;
  assign select_3285 = equal_1710_s22_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3287;
  assign select_3287 = equal_1710_s22_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3289;
  assign select_3289 = equal_1710_s22_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3291;
  assign select_3291 = equal_1710_s22_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3293;
  assign select_3293 = equal_1710_s22_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3295;
  assign select_3295 = equal_1710_s22_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3297;
  assign select_3297 = equal_1710_s22_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3299;
  assign select_3299 = equal_1710_s22_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3301;
  assign select_3301 = equal_1710_s22_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3303;
  assign select_3303 = equal_1710_s22_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3305;
  assign select_3305 = equal_1710_s22_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3307;
  assign select_3307 = equal_1710_s22_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3309;
  assign select_3309 = equal_1710_s22_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3311;
  assign select_3311 = equal_1710_s22_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3313;
  assign select_3313 = equal_1710_s22_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:574
  logic not_3422;
  assign not_3422 = ~or_3421_s22_q;
  // hls/stages/patches.hpp:555
  logic and_3423;
  assign and_3423 = equal_1872_s22_q & not_3422;
  // hls/stages/patches.hpp:184
  logic and_3426;
  assign and_3426 = equal_1708_s22_q & (less_1869_s22_q ? (not_1871_s22_q & and_3423) : and_3423);
  // hls/stages/patches.hpp:555
  logic and_3429;
  assign and_3429 = equal_1872_s22_q & (patches_second_s22_q & not_3422);
  // hls/stages/patches.hpp:184
  logic and_3432;
  assign and_3432 = equal_1708_s22_q & (less_1869_s22_q ? (not_1871_s22_q & and_3429) : and_3429);
  // hls/stages/patches.hpp:555
  logic and_3472;
  assign and_3472 = equal_1872_s22_q & (not_3422 & not_3470_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3475;
  assign and_3475 = equal_1708_s22_q & (less_1869_s22_q ? (not_1871_s22_q & and_3472) : and_3472);
  // hls/stages/patches.hpp:555
  logic and_3482;
  assign and_3482 = equal_1872_s22_q & (not_3422 & not_3480_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3485;
  assign and_3485 = equal_1708_s22_q & (less_1869_s22_q ? (not_1871_s22_q & and_3482) : and_3482);
  // hls/stages/agreement.hpp:1106
  logic less_3519;
  assign less_3519 = x_s22_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:780
  logic and_3523;
  assign and_3523 = equal_1489_s22_q & (x_s22_q[6] & (not_1898_s22_q & (equal_3518_s22_q & less_3519)));
  // hls/stages/agreement.hpp:1118
  logic and_3528;
  assign and_3528 = x_s22_q[6] & (not_1898_s22_q & (less_3519 & (x_s22_q[2:0] == 3'h1)));
  logic and_3535;
  assign and_3535 = x_s22_q[6] & (not_1898_s22_q & (less_3519 & (x_s22_q[2:0] == 3'h2)));
  logic and_3542;
  assign and_3542 = x_s22_q[6] & (not_1898_s22_q & (less_3519 & (x_s22_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:199
  logic select_3549;
  assign select_3549 = (x_s22_q[5:3] == 3'h2) ? x_s22_q[1] : (x_s22_q[0] & (x_s22_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3576;
  assign sum_3576 = {2'h0, x_s22_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:601
  logic [5:0] select_3595;
  assign select_3595 = less_3592_s22_q ? 6'h10 : (less_3593_s22_q ? 6'h30 : difference_3468_s22_q);
  // hls/stages/patches.hpp:555
  logic [5:0] select_3597;
  assign select_3597 = equal_1872_s22_q ? (or_3421_s22_q ? 6'h0 : select_3595) : 6'h0;
  logic [5:0] select_3599;
  assign select_3599 = less_1869_s22_q ? (equal_1870_s22_q ? 6'h0 : select_3597) : select_3597;
  // hls/stages/agreement.hpp:780
  logic and_3606;
  assign and_3606 = equal_1489_s22_q & (x_s22_q[6] & (not_1898_s22_q & (equal_2710_s22_q & less_3519)));
  // hls/stages/agreement.hpp:1118
  logic and_3610;
  assign and_3610 = x_s22_q[6] & (not_1898_s22_q & (less_3519 & (x_s22_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:555
  logic and_3649;
  assign and_3649 = equal_1872_s22_q & (not_3422 & less_3647_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3652;
  assign and_3652 = equal_1708_s22_q & (less_1869_s22_q ? (not_1871_s22_q & and_3649) : and_3649);
  // hls/stages/agreement.hpp:1194
  logic [14:0] over;
  assign over = {1'b0, product_s22_q} - {1'b0, before_v_4_s22_q};
  // hls/stages/agreement.hpp:1202
  logic select_3777;
  assign select_3777 = and_3766_s22_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1279
  logic [1:0] select_3940;
  assign select_3940 = and_3939_s22_q ? {and_2034_s22_q, is_seen_s22_q} : map_rdata_s22_q;
  // hls/stages/agreement.hpp:1280
  logic and_3941;
  assign and_3941 = proven_q & less_3929;
  // hls/stages/agreement.hpp:1122
  logic or_3973;
  assign or_3973 = select_2299_s22_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:780
  logic and_3998;
  assign and_3998 = equal_1489_s22_q & (x_s22_q[6] & (not_1898_s22_q | (4'hc < x_s22_q[5:2])));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s22_q;
  logic fresh_we;
  assign fresh_we = s22_en & and_524_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s22_q, and_639, and_615_s22_q, and_614_s22_q, and_589_s22_q, less_581_s22_q, less_580_s22_q, less_579_s22_q, less_578_s22_q, less_577_s22_q, less_576_s22_q, less_575_s22_q, less_574_s22_q, less_573_s22_q, less_572_s22_q, less_571_s22_q, less_570_s22_q, less_569_s22_q, less_568_s22_q, less_567_s22_q, less_566_s22_q, less_565_s22_q, less_564_s22_q, less_563_s22_q, less_562_s22_q, less_561_s22_q, less_560_s22_q, less_559_s22_q, less_558_s22_q};
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
      if (fresh_waddr >= 7'd120) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd120) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1738_s22_q, select_1735_s22_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s22_en & and_1748_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s22_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_0_raddr_s10_sim;
  logic patches_right_0_re_s10_sim;
  logic [9:0] patches_right_0_raddr_s11_sim;
  logic patches_right_0_re_s11_sim;
  logic [9:0] patches_right_0_raddr_s12_sim;
  logic patches_right_0_re_s12_sim;
  logic [9:0] patches_right_0_raddr_s13_sim;
  logic patches_right_0_re_s13_sim;
  logic [9:0] patches_right_0_raddr_s14_sim;
  logic patches_right_0_re_s14_sim;
  logic [9:0] patches_right_0_raddr_s15_sim;
  logic patches_right_0_re_s15_sim;
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_0_re_s10_sim <= 1'b0;
      patches_right_0_re_s11_sim <= 1'b0;
      patches_right_0_re_s12_sim <= 1'b0;
      patches_right_0_re_s13_sim <= 1'b0;
      patches_right_0_re_s14_sim <= 1'b0;
      patches_right_0_re_s15_sim <= 1'b0;
      patches_right_0_re_s16_sim <= 1'b0;
      patches_right_0_re_s17_sim <= 1'b0;
      patches_right_0_re_s18_sim <= 1'b0;
      patches_right_0_re_s19_sim <= 1'b0;
      patches_right_0_re_s20_sim <= 1'b0;
      patches_right_0_re_s21_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_0_re_s10_sim <= patches_right_0_re;
      patches_right_0_raddr_s10_sim <= patches_right_0_raddr;
      patches_right_0_re_s11_sim <= patches_right_0_re_s10_sim;
      patches_right_0_raddr_s11_sim <= patches_right_0_raddr_s10_sim;
      patches_right_0_re_s12_sim <= patches_right_0_re_s11_sim;
      patches_right_0_raddr_s12_sim <= patches_right_0_raddr_s11_sim;
      patches_right_0_re_s13_sim <= patches_right_0_re_s12_sim;
      patches_right_0_raddr_s13_sim <= patches_right_0_raddr_s12_sim;
      patches_right_0_re_s14_sim <= patches_right_0_re_s13_sim;
      patches_right_0_raddr_s14_sim <= patches_right_0_raddr_s13_sim;
      patches_right_0_re_s15_sim <= patches_right_0_re_s14_sim;
      patches_right_0_raddr_s15_sim <= patches_right_0_raddr_s14_sim;
      patches_right_0_re_s16_sim <= patches_right_0_re_s15_sim;
      patches_right_0_raddr_s16_sim <= patches_right_0_raddr_s15_sim;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_0_we) begin
      if (patches_right_0_re && patches_right_0_raddr == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s10_sim && patches_right_0_raddr_s10_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s11_sim && patches_right_0_raddr_s11_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s12_sim && patches_right_0_raddr_s12_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s13_sim && patches_right_0_raddr_s13_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s14_sim && patches_right_0_raddr_s14_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s15_sim && patches_right_0_raddr_s15_sim == patches_right_0_waddr) begin
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
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_1738_s22_q, select_1764_s22_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s22_en & and_1768_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s22_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_1_raddr_s10_sim;
  logic patches_right_1_re_s10_sim;
  logic [9:0] patches_right_1_raddr_s11_sim;
  logic patches_right_1_re_s11_sim;
  logic [9:0] patches_right_1_raddr_s12_sim;
  logic patches_right_1_re_s12_sim;
  logic [9:0] patches_right_1_raddr_s13_sim;
  logic patches_right_1_re_s13_sim;
  logic [9:0] patches_right_1_raddr_s14_sim;
  logic patches_right_1_re_s14_sim;
  logic [9:0] patches_right_1_raddr_s15_sim;
  logic patches_right_1_re_s15_sim;
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_1_re_s10_sim <= 1'b0;
      patches_right_1_re_s11_sim <= 1'b0;
      patches_right_1_re_s12_sim <= 1'b0;
      patches_right_1_re_s13_sim <= 1'b0;
      patches_right_1_re_s14_sim <= 1'b0;
      patches_right_1_re_s15_sim <= 1'b0;
      patches_right_1_re_s16_sim <= 1'b0;
      patches_right_1_re_s17_sim <= 1'b0;
      patches_right_1_re_s18_sim <= 1'b0;
      patches_right_1_re_s19_sim <= 1'b0;
      patches_right_1_re_s20_sim <= 1'b0;
      patches_right_1_re_s21_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_1_re_s10_sim <= patches_right_1_re;
      patches_right_1_raddr_s10_sim <= patches_right_1_raddr;
      patches_right_1_re_s11_sim <= patches_right_1_re_s10_sim;
      patches_right_1_raddr_s11_sim <= patches_right_1_raddr_s10_sim;
      patches_right_1_re_s12_sim <= patches_right_1_re_s11_sim;
      patches_right_1_raddr_s12_sim <= patches_right_1_raddr_s11_sim;
      patches_right_1_re_s13_sim <= patches_right_1_re_s12_sim;
      patches_right_1_raddr_s13_sim <= patches_right_1_raddr_s12_sim;
      patches_right_1_re_s14_sim <= patches_right_1_re_s13_sim;
      patches_right_1_raddr_s14_sim <= patches_right_1_raddr_s13_sim;
      patches_right_1_re_s15_sim <= patches_right_1_re_s14_sim;
      patches_right_1_raddr_s15_sim <= patches_right_1_raddr_s14_sim;
      patches_right_1_re_s16_sim <= patches_right_1_re_s15_sim;
      patches_right_1_raddr_s16_sim <= patches_right_1_raddr_s15_sim;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_1_we) begin
      if (patches_right_1_re && patches_right_1_raddr == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s10_sim && patches_right_1_raddr_s10_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s11_sim && patches_right_1_raddr_s11_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s12_sim && patches_right_1_raddr_s12_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s13_sim && patches_right_1_raddr_s13_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s14_sim && patches_right_1_raddr_s14_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s15_sim && patches_right_1_raddr_s15_sim == patches_right_1_waddr) begin
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
      patches_frame_ended_q <= 1'b0;
      hides_q <= 1'b0;
    end else if (s22_en) begin
      census_left_misses_q <= select_2193;
      sharpness_comparing_product_0_q <= so_s22_q ? select_2265 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s22_q ? select_2267 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2276;
      sharpness_comparing_carry_1_q <= so_s22_q ? select_2279 : sharpness_comparing_carry_1_q;
      patches_sums_values_0_q <= select_3282;
      patches_sums_values_1_q <= equal_1708_s22_q ? patches_sums_values_1_q : select_3283;
      patches_sums_values_2_q <= equal_1708_s22_q ? patches_sums_values_2_q : select_3285;
      patches_sums_values_3_q <= equal_1708_s22_q ? patches_sums_values_3_q : select_3287;
      patches_sums_values_4_q <= equal_1708_s22_q ? patches_sums_values_4_q : select_3289;
      patches_sums_values_5_q <= equal_1708_s22_q ? patches_sums_values_5_q : select_3291;
      patches_sums_values_6_q <= equal_1708_s22_q ? patches_sums_values_6_q : select_3293;
      patches_sums_values_7_q <= equal_1708_s22_q ? patches_sums_values_7_q : select_3295;
      patches_sums_values_8_q <= equal_1708_s22_q ? patches_sums_values_8_q : select_3297;
      patches_sums_values_9_q <= equal_1708_s22_q ? patches_sums_values_9_q : select_3299;
      patches_sums_values_10_q <= equal_1708_s22_q ? patches_sums_values_10_q : select_3301;
      patches_sums_values_11_q <= equal_1708_s22_q ? patches_sums_values_11_q : select_3303;
      patches_sums_values_12_q <= equal_1708_s22_q ? patches_sums_values_12_q : select_3305;
      patches_sums_values_13_q <= equal_1708_s22_q ? patches_sums_values_13_q : select_3307;
      patches_sums_values_14_q <= equal_1708_s22_q ? patches_sums_values_14_q : select_3309;
      patches_sums_values_15_q <= equal_1708_s22_q ? patches_sums_values_15_q : select_3311;
      patches_sums_values_16_q <= equal_1708_s22_q ? patches_sums_values_16_q : select_3313;
      patches_best_differing_q <= select_1886[9:0];
      patches_best_column_q <= select_1886[14:10];
      patches_frame_ended_q <= equal_1489_s22_q & ((x_s22_q == 7'h70) & (~equal_3625_s22_q));
      hides_q <= equal_1489_s22_q ? select_3777 : hides_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s22_en) begin
      left_pixel_q <= left_pixel_q;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic x_s23_q;
  logic registration_moved_s23_q;
  logic patches_lower_s23_q;
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic patches_frame_ended_s23_q;
  logic so_s23_q;
  logic equal_1489_s23_q;
  logic equal_1530_s23_q;
  logic equal_1538_s23_q;
  logic and_1964_s23_q;
  logic less_1965_s23_q;
  logic equal_2237_s23_q;
  logic or_2283_s23_q;
  logic and_2284_s23_q;
  logic or_2289_s23_q;
  logic and_2290_s23_q;
  logic select_2305_s23_q;
  logic [9:0] select_2484_s23_q;
  logic [9:0] select_2487_s23_q;
  logic and_3426_s23_q;
  logic and_3432_s23_q;
  logic and_3475_s23_q;
  logic and_3485_s23_q;
  logic and_3523_s23_q;
  logic and_3529_s23_q;
  logic and_3536_s23_q;
  logic and_3543_s23_q;
  logic and_3552_s23_q;
  logic and_3579_s23_q;
  logic [5:0] select_3600_s23_q;
  logic and_3606_s23_q;
  logic and_3611_s23_q;
  logic equal_3625_s23_q;
  logic and_3653_s23_q;
  logic or_3744_s23_q;
  logic select_3752_s23_q;
  logic select_3777_s23_q;
  logic and_3809_s23_q;
  logic not_3811_s23_q;
  logic or_3815_s23_q;
  logic and_3820_s23_q;
  logic and_3822_s23_q;
  logic and_3924_s23_q;
  logic and_3942_s23_q;
  logic and_3945_s23_q;
  logic not_3954_s23_q;
  logic or_3973_s23_q;
  logic and_3998_s23_q;
  logic [5:0] select_4000_s23_q;
  logic [31:0] select_4012_s23_q;
  logic [9:0] select_4014_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      x_s23_q <= x_s22_q[6];
      registration_moved_s23_q <= registration_moved_s22_q;
      patches_lower_s23_q <= patches_lower_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_s22_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_s22_q;
      patches_frame_ended_s23_q <= patches_frame_ended_q;
      so_s23_q <= so_s22_q;
      equal_1489_s23_q <= equal_1489_s22_q;
      equal_1530_s23_q <= equal_1530_s22_q;
      equal_1538_s23_q <= equal_1538_s22_q;
      and_1964_s23_q <= and_1964_s22_q;
      less_1965_s23_q <= less_1965_s22_q;
      equal_2237_s23_q <= equal_2237_s22_q;
      or_2283_s23_q <= equal_2281_s22_q | xor_2282;
      and_2284_s23_q <= five_times[0] & xor_2282;
      or_2289_s23_q <= equal_2281_s22_q | xor_2288;
      and_2290_s23_q <= five_times_2[0] & xor_2288;
      select_2305_s23_q <= select_2305_s22_q;
      select_2484_s23_q <= select_2484_s22_q;
      select_2487_s23_q <= select_2487_s22_q;
      and_3426_s23_q <= and_3426;
      and_3432_s23_q <= and_3432;
      and_3475_s23_q <= and_3475;
      and_3485_s23_q <= and_3485;
      and_3523_s23_q <= and_3523;
      and_3529_s23_q <= equal_1489_s22_q & and_3528;
      and_3536_s23_q <= equal_1489_s22_q & and_3535;
      and_3543_s23_q <= equal_1489_s22_q & and_3542;
      and_3552_s23_q <= x_s22_q[6] & (not_1898_s22_q & (less_3519 & select_3549));
      and_3579_s23_q <= not_1898_s22_q & (less_3519 & (sum_3576[4:2] == 3'h0));
      select_3600_s23_q <= equal_1708_s22_q ? select_3599 : 6'h0;
      and_3606_s23_q <= and_3606;
      and_3611_s23_q <= equal_1489_s22_q & and_3610;
      equal_3625_s23_q <= equal_3625_s22_q;
      and_3653_s23_q <= and_3426 & and_3652;
      or_3744_s23_q <= or_3744_s22_q;
      select_3752_s23_q <= select_3752_s22_q;
      select_3777_s23_q <= select_3777;
      and_3809_s23_q <= over[14] & equal_3518_s22_q;
      not_3811_s23_q <= not_3811_s22_q;
      or_3815_s23_q <= or_3815_s22_q;
      and_3820_s23_q <= and_3820_s22_q;
      and_3822_s23_q <= over[14] & less_3821_s22_q;
      and_3924_s23_q <= and_3924_s22_q;
      and_3942_s23_q <= select_3940[0] & and_3941;
      and_3945_s23_q <= select_3940[1] & and_3941;
      not_3954_s23_q <= not_3954_s22_q;
      or_3973_s23_q <= or_3973;
      and_3998_s23_q <= and_3998;
      select_4000_s23_q <= equal_1489_s22_q ? (x_s22_q[6] ? x_s22_q[5:0] : 6'h0) : 6'h0;
      select_4012_s23_q <= select_4012_s22_q;
      select_4014_s23_q <= select_4014_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
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
  logic patches_suspected_q;
  logic patches_moved_q;
  logic patches_twice_q;
  logic patches_clear_q;
  logic [9:0] patches_age_q;
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic overlooks_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:385
  logic select_2285;
  assign select_2285 = or_2283_s23_q ? and_2284_s23_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:213
  logic select_2286;
  assign select_2286 = equal_2237_s23_q ? select_2285 : sharpness_comparing_less_detail_0_q;
  logic select_2287;
  assign select_2287 = so_s23_q ? select_2286 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_2291;
  assign select_2291 = or_2289_s23_q ? and_2290_s23_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:213
  logic select_2292;
  assign select_2292 = equal_2237_s23_q ? select_2291 : sharpness_comparing_less_detail_1_q;
  logic select_2293;
  assign select_2293 = so_s23_q ? select_2292 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:652
  logic not_3427;
  assign not_3427 = ~patches_lower_s23_q;
  logic not_3433;
  assign not_3433 = ~and_3432_s23_q;
  // hls/stages/patches.hpp:188
  logic and_3435;
  assign and_3435 = and_3426_s23_q & (not_3427 & not_3433);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3437;
  assign sum_3437 = {7'h0, and_3435} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:655
  logic and_3476;
  assign and_3476 = and_3475_s23_q & and_3435;
  logic [7:0] sum_3477;
  assign sum_3477 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3476};
  // hls/stages/patches.hpp:656
  logic and_3486;
  assign and_3486 = and_3485_s23_q & and_3435;
  logic [7:0] sum_3487;
  assign sum_3487 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3486};
  // hls/stages/patches.hpp:188
  logic and_3489;
  assign and_3489 = and_3426_s23_q & (and_3432_s23_q & not_3427);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3491;
  assign sum_3491 = {7'h0, and_3489} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_3493;
  assign and_3493 = and_3475_s23_q & and_3489;
  logic [7:0] sum_3494;
  assign sum_3494 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3493};
  // hls/stages/patches.hpp:656
  logic and_3496;
  assign and_3496 = and_3485_s23_q & and_3489;
  logic [7:0] sum_3497;
  assign sum_3497 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3496};
  // hls/stages/patches.hpp:188
  logic and_3499;
  assign and_3499 = and_3426_s23_q & (patches_lower_s23_q & not_3433);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3501;
  assign sum_3501 = {7'h0, and_3499} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_3503;
  assign and_3503 = and_3475_s23_q & and_3499;
  logic [7:0] sum_3504;
  assign sum_3504 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3503};
  // hls/stages/patches.hpp:656
  logic and_3506;
  assign and_3506 = and_3485_s23_q & and_3499;
  logic [7:0] sum_3507;
  assign sum_3507 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3506};
  // hls/stages/patches.hpp:188
  logic and_3509;
  assign and_3509 = and_3426_s23_q & (patches_lower_s23_q & and_3432_s23_q);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3511;
  assign sum_3511 = {7'h0, and_3509} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_3513;
  assign and_3513 = and_3475_s23_q & and_3509;
  logic [7:0] sum_3514;
  assign sum_3514 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3513};
  // hls/stages/patches.hpp:656
  logic and_3516;
  assign and_3516 = and_3485_s23_q & and_3509;
  logic [7:0] sum_3517;
  assign sum_3517 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3516};
  // hls/stages/patches.hpp:618
  logic [7:0] or_3531;
  assign or_3531 = (and_3523_s23_q ? patches_quarters_0_places_q : 8'h0) | (and_3529_s23_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3545;
  assign or_3545 = (or_3531 | (and_3536_s23_q ? patches_quarters_2_places_q : 8'h0)) | (and_3543_s23_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:780
  logic and_3553;
  assign and_3553 = equal_1489_s23_q & and_3552_s23_q;
  // hls/stages/patches.hpp:619
  logic [7:0] select_3555;
  assign select_3555 = and_3523_s23_q ? (and_3553 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3557;
  assign select_3557 = and_3529_s23_q ? (and_3553 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3560;
  assign select_3560 = and_3536_s23_q ? (and_3553 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3563;
  assign select_3563 = and_3543_s23_q ? (and_3553 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3566;
  assign select_3566 = and_3523_s23_q ? (and_3553 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3568;
  assign select_3568 = and_3529_s23_q ? (and_3553 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3571;
  assign select_3571 = and_3536_s23_q ? (and_3553 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3574;
  assign select_3574 = and_3543_s23_q ? (and_3553 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:780
  logic and_3581;
  assign and_3581 = equal_1489_s23_q & (x_s23_q & and_3579_s23_q);
  // hls/stages/patches.hpp:613
  logic [7:0] sum_3583;
  assign sum_3583 = patches_word_places_q + (and_3529_s23_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:615
  logic [7:0] select_3587;
  assign select_3587 = and_3581 ? (patches_word_up_q + (and_3529_s23_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3589;
  assign sum_3589 = patches_word_down_q + (and_3529_s23_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:658
  logic [5:0] select_3601;
  assign select_3601 = and_3426_s23_q ? select_3600_s23_q : 6'h0;
  logic [11:0] sum_3602;
  assign sum_3602 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3601[5]}}, select_3601};
  // hls/stages/patches.hpp:642
  logic [7:0] select_3613;
  assign select_3613 = and_3606_s23_q ? (and_3611_s23_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
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
  assign select_3623 = and_3606_s23_q ? (and_3611_s23_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3630;
  assign and_3630 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_3631;
  assign select_3631 = and_3606_s23_q ? {and_3630, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3633;
  assign select_3633 = and_3606_s23_q ? (and_3611_s23_q ? {and_3630, patches_found_q[2:1]} : select_3631) : patches_found_q;
  // hls/stages/patches.hpp:640
  logic or_3636;
  assign or_3636 = patches_partly_q | (patches_doubted_q & (~and_3611_s23_q));
  // hls/stages/patches.hpp:641
  logic select_3638;
  assign select_3638 = and_3611_s23_q ? or_3636 : (and_3606_s23_q ? or_3636 : patches_doubted_q);
  // hls/stages/patches.hpp:639
  logic select_3640;
  assign select_3640 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_3644;
  assign select_3644 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3654;
  assign sum_3654 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3653_s23_q};
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_3677;
  assign select_3677 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_3683;
  assign and_3683 = patches_frame_ended_s23_q & (~patches_age_q[9]);
  logic [9:0] sum_3684;
  assign sum_3684 = patches_age_q + {9'h0, and_3683};
  logic [9:0] select_3687;
  assign select_3687 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3684)) : sum_3684;
  // hls/stages/agreement.hpp:1120
  logic not_3778;
  assign not_3778 = ~hidden_for_q[7];
  logic [7:0] select_3780;
  assign select_3780 = select_3777_s23_q ? (hidden_for_q + {7'h0, not_3778}) : 8'h0;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_3782;
  assign select_3782 = equal_1489_s23_q ? (equal_3625_s23_q ? select_3780 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1200
  logic and_3812;
  assign and_3812 = too_much_q & not_3811_s23_q;
  // hls/stages/agreement.hpp:1201
  logic select_3817;
  assign select_3817 = and_3809_s23_q ? (and_3812 | or_3815_s23_q) : and_3812;
  // hls/stages/agreement.hpp:1203
  logic select_3823;
  assign select_3823 = and_3820_s23_q ? and_3822_s23_q : overlooks_q;
  // hls/stages/agreement.hpp:431
  logic select_3944;
  assign select_3944 = and_1964_s23_q ? (less_1965_s23_q ? and_3942_s23_q : seen_q) : seen_q;
  logic select_3947;
  assign select_3947 = and_1964_s23_q ? (less_1965_s23_q ? and_3945_s23_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1211
  logic or_3955;
  assign or_3955 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_3954_s23_q;
  // hls/stages/agreement.hpp:780
  logic and_3961;
  assign and_3961 = equal_1489_s23_q & (equal_3625_s23_q & (cfg_prove_i & or_3744_s23_q));
  // hls/stages/agreement.hpp:1213
  logic not_3963;
  assign not_3963 = ~(or_3744_s23_q | not_3948);
  // hls/stages/agreement.hpp:780
  logic and_3966;
  assign and_3966 = equal_3625_s23_q & (not_3963 & (select_3752_s23_q | select_3817));
  logic and_3970;
  assign and_3970 = equal_3625_s23_q & (cfg_prove_i & (registration_moved_s23_q | patches_moved_q));
  logic and_3980;
  assign and_3980 = equal_3625_s23_q & (not_3963 & (select_2293 | select_2305_s23_q));
  // hls/stages/agreement.hpp:1116
  logic [31:0] select_4013;
  assign select_4013 = equal_1538_s23_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4012_s23_q;
  // hls/stages/agreement.hpp:1118
  logic [31:0] select_4015;
  assign select_4015 = equal_1530_s23_q ? select_4013 : {2'h0, select_4014_s23_q, select_2487_s23_q, select_2484_s23_q};

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s23_q;
  logic patches_rows_we;
  assign patches_rows_we = s23_en & patches_summed_last_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= {patches_best_column_q, patches_best_differing_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_rows_raddr_s10_sim;
  logic patches_rows_re_s10_sim;
  logic [4:0] patches_rows_raddr_s11_sim;
  logic patches_rows_re_s11_sim;
  logic [4:0] patches_rows_raddr_s12_sim;
  logic patches_rows_re_s12_sim;
  logic [4:0] patches_rows_raddr_s13_sim;
  logic patches_rows_re_s13_sim;
  logic [4:0] patches_rows_raddr_s14_sim;
  logic patches_rows_re_s14_sim;
  logic [4:0] patches_rows_raddr_s15_sim;
  logic patches_rows_re_s15_sim;
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_rows_re_s10_sim <= 1'b0;
      patches_rows_re_s11_sim <= 1'b0;
      patches_rows_re_s12_sim <= 1'b0;
      patches_rows_re_s13_sim <= 1'b0;
      patches_rows_re_s14_sim <= 1'b0;
      patches_rows_re_s15_sim <= 1'b0;
      patches_rows_re_s16_sim <= 1'b0;
      patches_rows_re_s17_sim <= 1'b0;
      patches_rows_re_s18_sim <= 1'b0;
      patches_rows_re_s19_sim <= 1'b0;
      patches_rows_re_s20_sim <= 1'b0;
      patches_rows_re_s21_sim <= 1'b0;
      patches_rows_re_s22_sim <= 1'b0;
    end else if (en_i) begin
      patches_rows_re_s10_sim <= patches_rows_re;
      patches_rows_raddr_s10_sim <= patches_rows_raddr;
      patches_rows_re_s11_sim <= patches_rows_re_s10_sim;
      patches_rows_raddr_s11_sim <= patches_rows_raddr_s10_sim;
      patches_rows_re_s12_sim <= patches_rows_re_s11_sim;
      patches_rows_raddr_s12_sim <= patches_rows_raddr_s11_sim;
      patches_rows_re_s13_sim <= patches_rows_re_s12_sim;
      patches_rows_raddr_s13_sim <= patches_rows_raddr_s12_sim;
      patches_rows_re_s14_sim <= patches_rows_re_s13_sim;
      patches_rows_raddr_s14_sim <= patches_rows_raddr_s13_sim;
      patches_rows_re_s15_sim <= patches_rows_re_s14_sim;
      patches_rows_raddr_s15_sim <= patches_rows_raddr_s14_sim;
      patches_rows_re_s16_sim <= patches_rows_re_s15_sim;
      patches_rows_raddr_s16_sim <= patches_rows_raddr_s15_sim;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s10_sim && patches_rows_raddr_s10_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s11_sim && patches_rows_raddr_s11_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s12_sim && patches_rows_raddr_s12_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s13_sim && patches_rows_raddr_s13_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s14_sim && patches_rows_raddr_s14_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s15_sim && patches_rows_raddr_s15_sim == patches_rows_waddr) begin
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
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
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
      patches_suspected_q <= 1'b0;
      patches_moved_q <= 1'b0;
      patches_twice_q <= 1'b0;
      patches_clear_q <= 1'b0;
      patches_age_q <= 10'h200;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s23_en) begin
      sharpness_comparing_less_detail_0_q <= select_2287;
      sharpness_comparing_less_detail_1_q <= select_2293;
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
      patches_sum_places_q <= and_3581 ? sum_3583 : patches_sum_places_q;
      patches_sum_up_q <= select_3587;
      patches_sum_down_q <= and_3581 ? sum_3589 : patches_sum_down_q;
      patches_across_q <= sum_3602;
      patches_places_q <= select_3613;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3617;
      patches_partly_q <= or_3620;
      patches_clear_limit_q <= sum_3621[8:2];
      patches_complete_q <= select_3623;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3633;
      patches_doubted_q <= and_3606_s23_q ? select_3638 : patches_doubted_q;
      patches_doubted_before_q <= select_3640;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3644;
      patches_on_skin_q <= sum_3654;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3677;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3687;
      hidden_for_q <= select_3782;
      too_much_q <= equal_1489_s23_q ? select_3817 : too_much_q;
      overlooks_q <= equal_1489_s23_q ? select_3823 : overlooks_q;
      seen_q <= select_3944;
      nearer_q <= select_3947;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic patches_round_ends_s24_q;
  logic [7:0] patches_on_skin_s24_q;
  logic equal_1489_s24_q;
  logic equal_3625_s24_q;
  logic and_3924_s24_q;
  logic and_3958_s24_q;
  logic and_3961_s24_q;
  logic and_3967_s24_q;
  logic and_3971_s24_q;
  logic and_3976_s24_q;
  logic and_3980_s24_q;
  logic not_3985_s24_q;
  logic or_3991_s24_q;
  logic and_3998_s24_q;
  logic [5:0] select_4000_s24_q;
  logic [31:0] select_4017_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      patches_round_ends_s24_q <= patches_round_ends_q;
      patches_on_skin_s24_q <= patches_on_skin_q;
      equal_1489_s24_q <= equal_1489_s23_q;
      equal_3625_s24_q <= equal_3625_s23_q;
      and_3924_s24_q <= and_3924_s23_q;
      and_3958_s24_q <= equal_1489_s23_q & (equal_3625_s23_q & (cfg_prove_i & or_3955));
      and_3961_s24_q <= and_3961;
      and_3967_s24_q <= equal_1489_s23_q & and_3966;
      and_3971_s24_q <= equal_1489_s23_q & and_3970;
      and_3976_s24_q <= equal_3625_s23_q & (not_3963 & (select_2287 | or_3973_s23_q));
      and_3980_s24_q <= and_3980;
      not_3985_s24_q <= ~(select_3780 < cfg_hidden_frames_i);
      or_3991_s24_q <= not_3948 | (select_3823 & not_3657);
      and_3998_s24_q <= and_3998_s23_q;
      select_4000_s24_q <= select_4000_s23_q;
      select_4017_s24_q <= equal_1489_s23_q ? (x_s23_q ? select_4015 : 32'h0) : 32'h0;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic [7:0] patches_on_skin_most_q;
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:649
  logic [12:0] product_3655;
  assign product_3655 = {8'h0, cfg_on_skin_limit_i} * {5'h0, patches_places_q};
  // hls/stages/patches.hpp:188
  logic and_3661;
  assign and_3661 = (~(patches_on_skin_s24_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_s24_q);
  logic select_3666;
  assign select_3666 = patches_round_ends_s24_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_3670;
  assign or_3670 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s24_q));
  // hls/stages/agreement.hpp:1122
  logic and_3987;
  assign and_3987 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_3985_s24_q);
  // hls/stages/agreement.hpp:780
  logic and_3993;
  assign and_3993 = equal_3625_s24_q & (or_3991_s24_q ? cfg_prove_i : patches_overlooked_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_on_skin_most_q <= 8'h0;
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s24_en) begin
      patches_on_skin_most_q <= product_3655[12:5];
      patches_large_q <= not_3657 & and_3661;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3666;
      patches_spoiled_q <= or_3670;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic and_3924_s25_q;
  logic or_3949_s25_q;
  logic and_3950_s25_q;
  logic and_3958_s25_q;
  logic and_3961_s25_q;
  logic and_3967_s25_q;
  logic and_3971_s25_q;
  logic and_3977_s25_q;
  logic and_3981_s25_q;
  logic and_3989_s25_q;
  logic and_3994_s25_q;
  logic and_3998_s25_q;
  logic [5:0] select_4000_s25_q;
  logic [31:0] select_4017_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      and_3924_s25_q <= and_3924_s24_q;
      or_3949_s25_q <= not_3948 | seen_q;
      and_3950_s25_q <= cfg_prove_i & nearer_q;
      and_3958_s25_q <= and_3958_s24_q;
      and_3961_s25_q <= and_3961_s24_q;
      and_3967_s25_q <= and_3967_s24_q;
      and_3971_s25_q <= and_3971_s24_q;
      and_3977_s25_q <= equal_1489_s24_q & and_3976_s24_q;
      and_3981_s25_q <= equal_1489_s24_q & and_3980_s24_q;
      and_3989_s25_q <= equal_1489_s24_q & (equal_3625_s24_q & and_3987);
      and_3994_s25_q <= equal_1489_s24_q & and_3993;
      and_3998_s25_q <= and_3998_s24_q;
      select_4000_s25_q <= select_4000_s24_q;
      select_4017_s25_q <= select_4017_s24_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s25_q;
  assign pixel_1_o = pixel_1_s25_q;
  assign saturated_o = saturated_s25_q;
  assign mask_o = mask_s25_q;
  assign marks_first_o = marks_first_s25_q;
  assign marks_last_o = marks_last_s25_q;
  assign marks_seen_o = or_3949_s25_q;
  assign marks_nearer_o = and_3950_s25_q;
  assign verdict_valid_o = and_3924_s25_q;
  assign verdict_unproven_yet_o = and_3958_s25_q;
  assign verdict_untextured_o = and_3961_s25_q;
  assign verdict_disagree_o = and_3967_s25_q;
  assign verdict_moved_o = and_3971_s25_q;
  assign verdict_unsharp_left_o = and_3977_s25_q;
  assign verdict_unsharp_right_o = and_3981_s25_q;
  assign verdict_hidden_o = and_3989_s25_q;
  assign verdict_overlooked_o = and_3994_s25_q;
  assign frame_valid_o = and_3998_s25_q;
  assign frame_index_o = select_4000_s25_q;
  assign frame_word_o = select_4017_s25_q;
  assign valid_o = valid_s25_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], product_3655[4:0], sum_3621[1:0], sum_3576[1:0], product_3467[4:0], sum_2559[0], difference_2524[1:0], detail_4[1:0], detail_3[1:0], sum_2187[4:0], sum_1689[1:0], sum_1688[1:0], sum_1684[0], sum_1635[0], sum_1631[0], sum_637[4:0], cfg_width_i[3:0]};

endmodule
