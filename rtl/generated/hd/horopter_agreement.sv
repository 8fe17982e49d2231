// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 25 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3142 bits, pipeline 8762 bits, memories 157167 bits.
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
  input  logic cfg_same_table_i,
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
  output logic verdict_out_of_step_o,
  output logic frame_valid_o,
  output logic [5:0] frame_index_o,
  output logic [31:0] frame_word_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q;
  logic s0_en, s1_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
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
  logic not_2367;
  assign not_2367 = ~cfg_prove_i;
  logic [6:0] sum_2580;
  assign sum_2580 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic less_2585;
  assign less_2585 = 7'h8 < cfg_height_i[10:4];
  logic [6:0] difference_3618;
  assign difference_3618 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3811;
  assign not_3811 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3869;
  assign difference_3869 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic [5:0] sum_4097;
  assign sum_4097 = {1'b0, cfg_height_i[10:6]} + 6'h3f;
  logic [7:0] select_4098;
  assign select_4098 = (7'h4 < cfg_height_i[10:4]) ? {sum_4097, cfg_height_i[5:4]} : 8'h0;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic [3:0] raster_at_y_q;
  logic raster_row_ended_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:42
  logic [3:0] select_514;
  assign select_514 = sample_pair_first_q ? 4'h0 : raster_at_x_q;
  // hls/stages/census.hpp:114
  logic equal_515;
  assign equal_515 = select_514[1:0] == 2'h0;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [8:0] select_519;
  assign select_519 = equal_515 ? (row_starts ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/census.hpp:42
  logic [3:0] select_533;
  assign select_533 = sample_pair_first_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2158;
  assign select_2158 = sample_pair_whole_q ? (sample_last_q ? 4'h0 : (select_514 + 4'h1)) : raster_at_x_q;
  logic [3:0] select_2161;
  assign select_2161 = sample_pair_whole_q ? (sample_last_q ? (select_533 + 4'h1) : select_533) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 4'h0;
      raster_at_y_q <= 4'h0;
      raster_row_ended_q <= 1'b1;
      averager_place_q <= 9'h0;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= select_2158;
      raster_at_y_q <= select_2161;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      averager_place_q <= sample_pair_whole_q ? select_519 : averager_place_q;
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
  logic [3:0] select_514_s1_q;
  logic equal_515_s1_q;
  logic row_starts_s1_q;
  logic [8:0] select_519_s1_q;
  logic not_521_s1_q;
  logic [3:0] select_533_s1_q;
  logic equal_552_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      sample_pair_first_s1_q <= sample_pair_first_q;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_last_s1_q <= sample_last_q;
      sample_present_s1_q <= sample_present_q;
      select_514_s1_q <= select_514;
      equal_515_s1_q <= equal_515;
      row_starts_s1_q <= row_starts;
      select_519_s1_q <= select_519;
      not_521_s1_q <= ~(averager_place_q == 9'h1df);
      select_533_s1_q <= select_533;
      equal_552_s1_q <= select_533 == 4'hf;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  logic averager_inside_q;
  // hls/stages/census.hpp:124
  logic select_524;
  assign select_524 = equal_515_s1_q ? (row_starts_s1_q | (averager_inside_q & not_521_s1_q)) : averager_inside_q;
  // hls/stages/census.hpp:42
  logic or_525;
  assign or_525 = sample_pair_first_s1_q | raster_at_live_q;
  // hls/stages/agreement.hpp:423
  logic and_528;
  assign and_528 = select_524 & (or_525 & (select_514_s1_q[1:0] == 2'h3));
  // hls/stages/census.hpp:42
  logic [6:0] select_549;
  assign select_549 = sample_pair_first_s1_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:277
  logic [6:0] last;
  assign last = sample_pair_whole_s1_q ? select_549 : 7'h0;
  // hls/stages/census.hpp:53
  logic equal_551;
  assign equal_551 = select_514_s1_q == 4'hf;
  // hls/stages/census.hpp:134
  logic and_553;
  assign and_553 = equal_552_s1_q & and_528;
  // hls/stages/census.hpp:42
  logic [6:0] select_687;
  assign select_687 = sample_pair_first_s1_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
  logic [6:0] row;
  assign row = sample_pair_whole_s1_q ? select_687 : 7'h0;
  logic [6:0] select_2164;
  assign select_2164 = sample_pair_whole_s1_q ? (sample_last_s1_q ? 7'h0 : (select_549 + {6'h0, equal_551})) : raster_at_column_q;
  // hls/stages/census.hpp:62
  logic [6:0] select_2166;
  assign select_2166 = sample_last_s1_q ? (select_687 + {6'h0, equal_552_s1_q}) : select_687;
  // hls/stages/agreement.hpp:277
  logic select_2171;
  assign select_2171 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_525 & (~raster_final_row_q)) : or_525) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [10:0] select_2173;
  assign select_2173 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:277
  logic select_2177;
  assign select_2177 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_inside_q <= 1'b1;
    end else if (s1_en) begin
      raster_at_column_q <= select_2164;
      raster_at_row_q <= sample_pair_whole_s1_q ? select_2166 : raster_at_row_q;
      raster_at_live_q <= select_2171;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_2173 : raster_rows_left_q;
      raster_final_row_q <= select_2177;
      averager_inside_q <= sample_pair_whole_s1_q ? select_524 : averager_inside_q;
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
  logic [3:0] select_514_s2_q;
  logic equal_515_s2_q;
  logic row_starts_s2_q;
  logic [8:0] select_519_s2_q;
  logic and_528_s2_q;
  logic [3:0] select_533_s2_q;
  logic [6:0] select_549_s2_q;
  logic [6:0] last_s2_q;
  logic and_553_s2_q;
  logic and_555_s2_q;
  logic [6:0] select_687_s2_q;
  logic [6:0] row_s2_q;
  logic equal_1689_s2_q;
  logic [7:0] sum_2485_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_first_s2_q <= sample_pair_first_s1_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      select_514_s2_q <= select_514_s1_q;
      equal_515_s2_q <= equal_515_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_519_s2_q <= select_519_s1_q;
      and_528_s2_q <= and_528;
      select_533_s2_q <= select_533_s1_q;
      select_549_s2_q <= select_549;
      last_s2_q <= last;
      and_553_s2_q <= and_553;
      and_555_s2_q <= sample_pair_whole_s1_q & (equal_551 & and_553);
      select_687_s2_q <= select_687;
      row_s2_q <= row;
      equal_1689_s2_q <= {or_525, select_533_s1_q} == 5'h18;
      sum_2485_s2_q <= {1'b0, last} + 8'h1;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:464
  logic equal_2486;
  assign equal_2486 = {sum_2485_s2_q[7], cfg_width_i[10:4]} == {1'b0, sum_2485_s2_q[6:0]};
  // hls/stages/agreement.hpp:484
  logic [7:0] sum_2576;
  assign sum_2576 = {1'b0, row_s2_q} + 8'h1;
  // hls/stages/patches.hpp:380
  logic [7:0] sum_3032;
  assign sum_3032 = {1'b0, select_687_s2_q} + 8'h1;

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic [3:0] select_514_s3_q;
  logic equal_515_s3_q;
  logic row_starts_s3_q;
  logic [8:0] select_519_s3_q;
  logic and_528_s3_q;
  logic equal_534_s3_q;
  logic [6:0] select_549_s3_q;
  logic [6:0] last_s3_q;
  logic and_553_s3_q;
  logic and_555_s3_q;
  logic [6:0] row_s3_q;
  logic equal_1689_s3_q;
  logic equal_2486_s3_q;
  logic and_2487_s3_q;
  logic equal_2577_s3_q;
  logic not_3034_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_first_s3_q <= sample_pair_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      select_514_s3_q <= select_514_s2_q;
      equal_515_s3_q <= equal_515_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_519_s3_q <= select_519_s2_q;
      and_528_s3_q <= and_528_s2_q;
      equal_534_s3_q <= select_533_s2_q == 4'h0;
      select_549_s3_q <= select_549_s2_q;
      last_s3_q <= last_s2_q;
      and_553_s3_q <= and_553_s2_q;
      and_555_s3_q <= and_555_s2_q;
      row_s3_q <= row_s2_q;
      equal_1689_s3_q <= equal_1689_s2_q;
      equal_2486_s3_q <= equal_2486;
      and_2487_s3_q <= and_555_s2_q & equal_2486;
      equal_2577_s3_q <= {sum_2576[7], cfg_height_i[10:4]} == {1'b0, sum_2576[6:0]};
      not_3034_s3_q <= ~({sum_3032, select_533_s2_q, 1'b0} < {2'h0, cfg_height_i});
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:197
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:634
  logic equal_584;
  assign equal_584 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:625
  logic equal_599;
  assign equal_599 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:626
  logic equal_600;
  assign equal_600 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:534
  logic select_2490;
  assign select_2490 = (and_2487_s3_q | (~ends_cell_q)) ? and_2487_s3_q : ends_q;
  // hls/stages/agreement.hpp:540
  logic [2:0] now;
  assign now = select_2490 ? (and_2487_s3_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:545
  logic [5:0] select_2494;
  assign select_2494 = select_2490 ? (and_2487_s3_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2497;
  assign select_2497 = select_2490 ? (following_last_shift_q & (~and_2487_s3_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:546
  logic [7:0] select_2499;
  assign select_2499 = select_2490 ? (and_2487_s3_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:618
  logic and_2500;
  assign and_2500 = run_last_shift_q & equal_599;
  // hls/stages/agreement.hpp:627
  logic select_2502;
  assign select_2502 = equal_599 ? (~run_last_shift_q) : equal_600;
  // hls/stages/agreement.hpp:631
  logic equal_2503;
  assign equal_2503 = run_phase_q == 3'h1;
  logic not_2506;
  assign not_2506 = ~select_2502;
  // hls/stages/agreement.hpp:634
  logic equal_2508;
  assign equal_2508 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:618
  logic and_2509;
  assign and_2509 = final_row_q & so;
  // hls/stages/agreement.hpp:631
  logic [1:0] select_2510;
  assign select_2510 = equal_2508 ? 2'h1 : {2{and_2509}};
  logic [2:0] select_2512;
  assign select_2512 = (and_2500 | (select_2502 | equal_2503)) ? (equal_2503 ? 3'h2 : {not_2506, {2{select_2502}}}) : (equal_584 ? 3'h6 : {select_2510[0], select_2510});
  // hls/stages/agreement.hpp:618
  logic and_2515;
  assign and_2515 = select_2502 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:641
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2518;
  assign select_2518 = (plan_shift_q[5] & select_2502) ? value : 7'h0;
  logic [1:0] or_2519;
  assign or_2519 = {2{so}} | select_2518[5:4];
  // hls/stages/agreement.hpp:644
  logic [7:0] or_2523;
  assign or_2523 = (select_2502 ? plan_columns_q : 8'h0) | ((equal_2503 | equal_2508) ? whole_q : 8'h0);
  logic [1:0] or_2524;
  assign or_2524 = {2{and_2500}} | or_2523[4:3];
  // hls/stages/agreement.hpp:645
  logic [7:0] or_2526;
  assign or_2526 = {or_2523[7:5], or_2524, or_2523[2:0]} | (equal_584 ? drawn_q : 8'h0);
  logic [4:0] or_2527;
  assign or_2527 = {5{so}} | {or_2526[6], or_2526[3:0]};
  // hls/stages/agreement.hpp:651
  logic not_2531;
  assign not_2531 = ~run_shift_q[5];
  logic [7:0] select_2534;
  assign select_2534 = equal_599 ? ({{7{not_2531}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:534
  logic [6:0] select_2538;
  assign select_2538 = and_2487_s3_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:537
  logic [7:0] select_2540;
  assign select_2540 = select_2490 ? {select_2538[6], select_2538} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2543;
  assign select_2543 = select_2490 ? (and_2487_s3_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:465
  logic [6:0] select_2550;
  assign select_2550 = equal_2486_s3_q ? ((6'he < last_s3_q[6:1]) ? 7'h1d : last_s3_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [4:0] sum_2552;
  assign sum_2552 = {1'b0, last_s3_q[6:3]} + 5'h3;
  // hls/stages/agreement.hpp:531
  logic [7:0] select_2554;
  assign select_2554 = and_555_s3_q ? (equal_2486_s3_q ? {sum_2552, last_s3_q[2:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [5:0] sum_2555;
  assign sum_2555 = {1'b0, last_s3_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:531
  logic [7:0] select_2557;
  assign select_2557 = and_555_s3_q ? (equal_2486_s3_q ? {sum_2555, last_s3_q[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:542
  logic select_2571;
  assign select_2571 = (ends_cell_q | select_2490) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_599 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:537
  logic and_2575;
  assign and_2575 = (~select_2490) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:531
  logic select_2579;
  assign select_2579 = and_555_s3_q ? (equal_2486_s3_q ? equal_2577_s3_q : final_row_q) : final_row_q;

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
    end else if (s3_en) begin
      run_phase_q <= now;
      run_shift_q <= select_2494;
      run_last_shift_q <= select_2497;
      run_span_q <= select_2499;
      following_phase_q <= select_2512;
      following_shift_q <= select_2502 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2515;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2518[6], or_2519, select_2518[3:0]};
      following_columns_q <= {or_2526[7], or_2527[4], or_2526[5:4], or_2527[3:0]};
      plan_shift_q <= equal_599 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2534;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2540;
      columns_left_q <= select_2543;
      last_q <= and_555_s3_q ? (equal_2486_s3_q ? last_s3_q : last_q) : last_q;
      least_q <= and_555_s3_q ? select_2550 : least_q;
      whole_q <= select_2554;
      drawn_q <= select_2557;
      slot_q <= select_2490 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2571;
      ends_q <= and_2575;
      final_row_q <= select_2579;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
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
  logic [5:0] run_shift_s4_q;
  logic [7:0] x_s4_q;
  logic [6:0] last_s4_q;
  logic [2:0] slot_s4_q;
  logic ends_cell_s4_q;
  logic shift_first_s4_q;
  logic [3:0] select_514_s4_q;
  logic equal_515_s4_q;
  logic row_starts_s4_q;
  logic [8:0] select_519_s4_q;
  logic and_528_s4_q;
  logic equal_534_s4_q;
  logic [6:0] select_549_s4_q;
  logic [6:0] last_s4_2_q;
  logic and_553_s4_q;
  logic and_555_s4_q;
  logic equal_580_s4_q;
  logic so_s4_q;
  logic equal_584_s4_q;
  logic [7:0] sum_586_s4_q;
  logic equal_599_s4_q;
  logic equal_600_s4_q;
  logic [7:0] sum_616_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1689_s4_q;
  logic equal_2486_s4_q;
  logic and_2487_s4_q;
  logic select_2490_s4_q;
  logic not_3034_s4_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s4_q <= pixel_0_s3_q;
      pixel_1_s4_q <= pixel_1_s3_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      sample_pair_first_s4_q <= sample_pair_first_s3_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      sample_present_s4_q <= sample_present_s3_q;
      run_shift_s4_q <= run_shift_q;
      x_s4_q <= x_q;
      last_s4_q <= last_q;
      slot_s4_q <= slot_q;
      ends_cell_s4_q <= ends_cell_q;
      shift_first_s4_q <= shift_first_q;
      select_514_s4_q <= select_514_s3_q;
      equal_515_s4_q <= equal_515_s3_q;
      row_starts_s4_q <= row_starts_s3_q;
      select_519_s4_q <= select_519_s3_q;
      and_528_s4_q <= and_528_s3_q;
      equal_534_s4_q <= equal_534_s3_q;
      select_549_s4_q <= select_549_s3_q;
      last_s4_2_q <= last_s3_q;
      and_553_s4_q <= and_553_s3_q;
      and_555_s4_q <= and_555_s3_q;
      equal_580_s4_q <= run_phase_q == 3'h7;
      so_s4_q <= so;
      equal_584_s4_q <= equal_584;
      sum_586_s4_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      equal_599_s4_q <= equal_599;
      equal_600_s4_q <= equal_600;
      sum_616_s4_q <= {1'b0, last_q} + 8'h3;
      row_s4_q <= row_s3_q;
      equal_1689_s4_q <= equal_1689_s3_q;
      equal_2486_s4_q <= equal_2486_s3_q;
      and_2487_s4_q <= and_2487_s3_q;
      select_2490_s4_q <= select_2490;
      not_3034_s4_q <= not_3034_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  logic [3:0] patches_phase_q;
  // hls/stages/agreement.hpp:605
  logic [7:0] select_587;
  assign select_587 = run_shift_s4_q[5] ? x_s4_q : sum_586_s4_q;
  logic less_588;
  assign less_588 = {1'b0, last_s4_q} < select_587;
  // hls/stages/agreement.hpp:227
  logic not_589;
  assign not_589 = ~less_588;
  // hls/stages/agreement.hpp:809
  logic [7:0] x;
  assign x = x_s4_q + 8'hfd;
  // hls/stages/agreement.hpp:539
  logic [6:0] select_2559;
  assign select_2559 = select_2490_s4_q ? 7'h0 : (ends_cell_s4_q ? {age_q[5:0], 1'b1} : age_q);
  // hls/stages/patches.hpp:324
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2970;
  assign select_2970 = row_starts_s4_q ? (sample_pair_first_s4_q ? phase : patches_phase_q) : patches_phase_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
      patches_phase_q <= 4'h0;
    end else if (s4_en) begin
      age_q <= select_2559;
      patches_phase_q <= sample_pair_whole_s4_q ? select_2970 : patches_phase_q;
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
  logic [3:0] age_s5_q;
  logic [2:0] slot_s5_q;
  logic ends_cell_s5_q;
  logic shift_first_s5_q;
  logic [3:0] select_514_s5_q;
  logic equal_515_s5_q;
  logic row_starts_s5_q;
  logic [8:0] select_519_s5_q;
  logic and_528_s5_q;
  logic equal_534_s5_q;
  logic [6:0] select_549_s5_q;
  logic [6:0] last_s5_2_q;
  logic and_553_s5_q;
  logic and_555_s5_q;
  logic equal_580_s5_q;
  logic so_s5_q;
  logic equal_584_s5_q;
  logic [6:0] sum_586_s5_q;
  logic less_588_s5_q;
  logic not_589_s5_q;
  logic equal_599_s5_q;
  logic and_601_s5_q;
  logic [6:0] x_s5_2_q;
  logic and_620_s5_q;
  logic [6:0] row_s5_q;
  logic equal_1573_s5_q;
  logic equal_1689_s5_q;
  logic equal_2486_s5_q;
  logic and_2487_s5_q;
  logic [3:0] phase_s5_q;
  logic not_3034_s5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      sample_pair_first_s5_q <= sample_pair_first_s4_q;
      sample_pair_whole_s5_q <= sample_pair_whole_s4_q;
      sample_present_s5_q <= sample_present_s4_q;
      run_shift_s5_q <= run_shift_s4_q;
      x_s5_q <= x_s4_q;
      last_s5_q <= last_s4_q;
      age_s5_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s5_q <= slot_s4_q;
      ends_cell_s5_q <= ends_cell_s4_q;
      shift_first_s5_q <= shift_first_s4_q;
      select_514_s5_q <= select_514_s4_q;
      equal_515_s5_q <= equal_515_s4_q;
      row_starts_s5_q <= row_starts_s4_q;
      select_519_s5_q <= select_519_s4_q;
      and_528_s5_q <= and_528_s4_q;
      equal_534_s5_q <= equal_534_s4_q;
      select_549_s5_q <= select_549_s4_q;
      last_s5_2_q <= last_s4_2_q;
      and_553_s5_q <= and_553_s4_q;
      and_555_s5_q <= and_555_s4_q;
      equal_580_s5_q <= equal_580_s4_q;
      so_s5_q <= so_s4_q;
      equal_584_s5_q <= equal_584_s4_q;
      sum_586_s5_q <= sum_586_s4_q[6:0];
      less_588_s5_q <= less_588;
      not_589_s5_q <= not_589;
      equal_599_s5_q <= equal_599_s4_q;
      and_601_s5_q <= equal_600_s4_q & not_589;
      x_s5_2_q <= x[6:0];
      and_620_s5_q <= age_q[2] & (ends_cell_s4_q & (~(sum_616_s4_q < select_587)));
      row_s5_q <= row_s4_q;
      equal_1573_s5_q <= {x[7], last_s4_q} == {1'b0, x[6:0]};
      equal_1689_s5_q <= equal_1689_s4_q;
      equal_2486_s5_q <= equal_2486_s4_q;
      and_2487_s5_q <= and_2487_s4_q;
      phase_s5_q <= phase;
      not_3034_s5_q <= not_3034_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:605
  logic or_585;
  assign or_585 = so_s5_q | equal_584_s5_q;
  // hls/stages/agreement.hpp:150
  logic select_603;
  assign select_603 = or_585 ? not_589_s5_q : (equal_599_s5_q ? not_589_s5_q : and_601_s5_q);
  logic and_621;
  assign and_621 = equal_599_s5_q & and_620_s5_q;
  logic select_622;
  assign select_622 = or_585 ? not_589_s5_q : and_621;
  // hls/stages/agreement.hpp:832
  logic [6:0] right;
  assign right = sum_586_s5_q + 7'h7d;
  // hls/stages/agreement.hpp:150
  logic [6:0] select_650;
  assign select_650 = or_585 ? x_s5_q[6:0] : (equal_599_s5_q ? sum_586_s5_q : x_s5_q[6:0]);
  // hls/stages/agreement.hpp:731
  logic not_657;
  assign not_657 = ~or_585;
  // hls/stages/agreement.hpp:473
  logic equal_2591;
  assign equal_2591 = row_s5_q[6:2] == 5'h0;
  // hls/stages/agreement.hpp:531
  logic and_2860;
  assign and_2860 = and_555_s5_q & (equal_2486_s5_q & equal_2591);
  // hls/stages/registration.hpp:127
  logic and_2863;
  assign and_2863 = and_2487_s5_q & (~and_2860);

  // Memory left, 120 x 85, DISTANCE 24, hls/stages/agreement.hpp:1406; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [84:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 85'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s5_q[6:0];
`ifndef SYNTHESIS
  logic left_re;
  assign left_re = s5_en & select_603;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 99, DISTANCE 24, hls/stages/agreement.hpp:1407; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [98:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_650;
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s5_en & select_603;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1408; read in stage 5, written in stage 16: 5 < 16 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [61:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 62'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_585 ? x_s5_q[6:0] : x_s5_2_q;
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s5_en & select_622;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
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
  logic [3:0] select_514_s6_q;
  logic equal_515_s6_q;
  logic row_starts_s6_q;
  logic [8:0] select_519_s6_q;
  logic and_528_s6_q;
  logic equal_534_s6_q;
  logic [6:0] select_549_s6_q;
  logic [6:0] last_s6_2_q;
  logic and_553_s6_q;
  logic and_555_s6_q;
  logic equal_580_s6_q;
  logic so_s6_q;
  logic equal_584_s6_q;
  logic or_585_s6_q;
  logic less_588_s6_q;
  logic not_589_s6_q;
  logic equal_599_s6_q;
  logic [6:0] x_s6_2_q;
  logic select_622_s6_q;
  logic [6:0] right_s6_q;
  logic and_660_s6_q;
  logic [6:0] row_s6_q;
  logic and_1572_s6_q;
  logic equal_1573_s6_q;
  logic equal_1689_s6_q;
  logic equal_2486_s6_q;
  logic equal_2591_s6_q;
  logic and_2861_s6_q;
  logic [15:0] select_2864_s6_q;
  logic [15:0] select_2867_s6_q;
  logic and_2870_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2990_s6_q;
  logic [3:0] select_2993_s6_q;
  logic not_3034_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      age_s6_q <= age_s5_q;
      slot_s6_q <= slot_s5_q;
      ends_cell_s6_q <= ends_cell_s5_q;
      shift_first_s6_q <= shift_first_s5_q;
      select_514_s6_q <= select_514_s5_q;
      equal_515_s6_q <= equal_515_s5_q;
      row_starts_s6_q <= row_starts_s5_q;
      select_519_s6_q <= select_519_s5_q;
      and_528_s6_q <= and_528_s5_q;
      equal_534_s6_q <= equal_534_s5_q;
      select_549_s6_q <= select_549_s5_q;
      last_s6_2_q <= last_s5_2_q;
      and_553_s6_q <= and_553_s5_q;
      and_555_s6_q <= and_555_s5_q;
      equal_580_s6_q <= equal_580_s5_q;
      so_s6_q <= so_s5_q;
      equal_584_s6_q <= equal_584_s5_q;
      or_585_s6_q <= or_585;
      less_588_s6_q <= less_588_s5_q;
      not_589_s6_q <= not_589_s5_q;
      equal_599_s6_q <= equal_599_s5_q;
      x_s6_2_q <= x_s5_2_q;
      select_622_s6_q <= select_622;
      right_s6_q <= right;
      and_660_s6_q <= not_657 & ((~equal_599_s5_q) & and_601_s5_q);
      row_s6_q <= row_s5_q;
      and_1572_s6_q <= not_657 & and_621;
      equal_1573_s6_q <= equal_1573_s5_q;
      equal_1689_s6_q <= equal_1689_s5_q;
      equal_2486_s6_q <= equal_2486_s5_q;
      equal_2591_s6_q <= equal_2591;
      and_2861_s6_q <= and_2487_s5_q & and_2860;
      select_2864_s6_q <= and_2863 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
      select_2867_s6_q <= and_2863 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
      and_2870_s6_q <= ends_cell_s5_q & so_s5_q;
      phase_s6_q <= phase_s5_q;
      equal_2990_s6_q <= row_s5_q == 7'h5;
      select_2993_s6_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_3034_s6_q <= not_3034_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [3:0] patches_choosing_rows_to_next_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1761;
  assign select_1761 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_2001;
  assign sum_2001 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [23:0] sum_2865;
  assign sum_2865 = registration_slope_row_q + {{8{select_2864_s6_q[15]}}, select_2864_s6_q};
  // hls/stages/registration.hpp:132
  logic [23:0] select_2866;
  assign select_2866 = and_2861_s6_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : sum_2865;
  // hls/stages/registration.hpp:130
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2867_s6_q[15]}}, select_2867_s6_q};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2869;
  assign select_2869 = and_2861_s6_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2870_s6_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:87
  logic [3:0] select_2994;
  assign select_2994 = equal_2990_s6_q ? select_2993_s6_q : patches_choosing_rows_to_next_q;
  logic equal_2995;
  assign equal_2995 = select_2994 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_2998;
  assign select_2998 = equal_2486_s6_q ? (equal_2995 ? 4'h2 : (select_2994 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_3859;
  assign select_3859 = so_s6_q ? (and_2870_s6_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3861;
  assign sum_3861 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3862;
  assign select_3862 = sum_2001[5] ? {1'b1, sum_2001[4:0], region_across_rest_q[2:0]} : sum_3861;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3864;
  assign select_3864 = equal_2486_s6_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3867;
  assign select_3867 = equal_2486_s6_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1405; read in stage 6, written in stage 22: 6 < 22 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 33'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s6_q[6:0];
`ifndef SYNTHESIS
  logic fresh_re;
  assign fresh_re = s6_en & and_660_s6_q;
`endif
  logic [32:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      patches_choosing_rows_to_next_q <= 4'h0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s6_en) begin
      registration_slope_row_q <= select_2866;
      registration_slope_change_q <= select_2869;
      registration_slope_q <= so_s6_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_choosing_rows_to_next_q <= and_555_s6_q ? select_2998 : patches_choosing_rows_to_next_q;
      region_across_rest_q <= select_3859;
      region_across_back_q <= so_s6_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3862;
      columns_begin_rest_q <= and_555_s6_q ? select_3864 : columns_begin_rest_q;
      columns_begin_back_q <= and_555_s6_q ? select_3867 : columns_begin_back_q;
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
  logic [11:0] registration_slope_s7_q;
  logic [3:0] patches_choosing_rows_to_next_s7_q;
  logic [3:0] select_514_s7_q;
  logic equal_515_s7_q;
  logic row_starts_s7_q;
  logic [8:0] select_519_s7_q;
  logic and_528_s7_q;
  logic equal_534_s7_q;
  logic [6:0] select_549_s7_q;
  logic [6:0] last_s7_2_q;
  logic and_553_s7_q;
  logic and_555_s7_q;
  logic equal_580_s7_q;
  logic so_s7_q;
  logic equal_584_s7_q;
  logic or_585_s7_q;
  logic less_588_s7_q;
  logic not_589_s7_q;
  logic equal_599_s7_q;
  logic [84:0] left_rdata_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_622_s7_q;
  logic [61:0] best_left_rdata_s7_q;
  logic [6:0] right_s7_q;
  logic [98:0] right_codes_rdata_s7_q;
  logic and_660_s7_q;
  logic [6:0] row_s7_q;
  logic and_1572_s7_q;
  logic equal_1573_s7_q;
  logic equal_1689_s7_q;
  logic [16:0] select_1761_s7_q;
  logic sum_2001_s7_q;
  logic equal_2486_s7_q;
  logic equal_2591_s7_q;
  logic [3:0] phase_s7_q;
  logic equal_2990_s7_q;
  logic equal_2995_s7_q;
  logic not_3034_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      registration_slope_s7_q <= registration_slope_q[27:16];
      patches_choosing_rows_to_next_s7_q <= patches_choosing_rows_to_next_q;
      select_514_s7_q <= select_514_s6_q;
      equal_515_s7_q <= equal_515_s6_q;
      row_starts_s7_q <= row_starts_s6_q;
      select_519_s7_q <= select_519_s6_q;
      and_528_s7_q <= and_528_s6_q;
      equal_534_s7_q <= equal_534_s6_q;
      select_549_s7_q <= select_549_s6_q;
      last_s7_2_q <= last_s6_2_q;
      and_553_s7_q <= and_553_s6_q;
      and_555_s7_q <= and_555_s6_q;
      equal_580_s7_q <= equal_580_s6_q;
      so_s7_q <= so_s6_q;
      equal_584_s7_q <= equal_584_s6_q;
      or_585_s7_q <= or_585_s6_q;
      less_588_s7_q <= less_588_s6_q;
      not_589_s7_q <= not_589_s6_q;
      equal_599_s7_q <= equal_599_s6_q;
      left_rdata_s7_q <= left_rdata_q;
      x_s7_2_q <= x_s6_2_q;
      select_622_s7_q <= select_622_s6_q;
      best_left_rdata_s7_q <= best_left_rdata_q;
      right_s7_q <= right_s6_q;
      right_codes_rdata_s7_q <= right_codes_rdata_q;
      and_660_s7_q <= and_660_s6_q;
      row_s7_q <= row_s6_q;
      and_1572_s7_q <= and_1572_s6_q;
      equal_1573_s7_q <= equal_1573_s6_q;
      equal_1689_s7_q <= equal_1689_s6_q;
      select_1761_s7_q <= select_1761;
      sum_2001_s7_q <= sum_2001[5];
      equal_2486_s7_q <= equal_2486_s6_q;
      equal_2591_s7_q <= equal_2591_s6_q;
      phase_s7_q <= phase_s6_q;
      equal_2990_s7_q <= equal_2990_s6_q;
      equal_2995_s7_q <= equal_2995;
      not_3034_s7_q <= not_3034_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic late_q;
  logic [3:0] patches_band_rows_rows_to_next_q;
  logic [4:0] patches_band_rows_number_q;
  logic [3:0] patches_next_band_rows_to_next_q;
  logic [4:0] patches_next_band_number_q;
  logic [3:0] patches_first_band_rows_to_next_q;
  logic patches_first_band_number_q;
  logic [4:0] patches_choosing_number_q;
  logic patches_chooses_q;
  logic [4:0] patches_choosing_band_q;
  logic done_q;
  logic proven_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:679
  logic equal_574;
  assign equal_574 = row_q == 7'h0;
  // hls/stages/agreement.hpp:986
  logic and_612;
  assign and_612 = (or_585_s7_q & (left_rdata_s7_q[67] & not_589_s7_q)) & (late_q | (~(row_q[6:3] == 4'h0)));
  // hls/stages/agreement.hpp:977
  logic [5:0] shift;
  assign shift = slot_s7_q[2] ? best_left_rdata_s7_q[5:0] : best_left_rdata_s7_q[45:40];
  // hls/stages/agreement.hpp:1015
  logic less_644;
  assign less_644 = 7'h2 < row_q;
  // hls/stages/agreement.hpp:1017
  logic and_654;
  assign and_654 = (or_585_s7_q & (right_codes_rdata_s7_q[58] & not_589_s7_q)) & less_644;
  // hls/stages/agreement.hpp:680
  logic or_758;
  assign or_758 = late_q | (~equal_574);
  // hls/stages/agreement.hpp:222
  logic and_773;
  assign and_773 = left_rdata_s7_q[48] & not_589_s7_q;
  logic and_774;
  assign and_774 = right_codes_rdata_s7_q[42] & not_589_s7_q;
  logic [11:0] select_775;
  assign select_775 = less_588_s7_q ? 12'h0 : left_rdata_s7_q[47:36];
  logic [11:0] select_776;
  assign select_776 = less_588_s7_q ? 12'h0 : right_codes_rdata_s7_q[41:30];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_780;
  assign select_780 = and_773 ? (and_774 ? (~(select_775 ^ select_776)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_796;
  assign and_796 = left_rdata_s7_q[66] & not_589_s7_q;
  logic and_797;
  assign and_797 = right_codes_rdata_s7_q[57] & not_589_s7_q;
  logic [11:0] select_798;
  assign select_798 = less_588_s7_q ? 12'h0 : left_rdata_s7_q[65:54];
  logic [11:0] select_799;
  assign select_799 = less_588_s7_q ? 12'h0 : right_codes_rdata_s7_q[56:45];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_803;
  assign select_803 = and_796 ? (and_797 ? (~(select_798 ^ select_799)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_813;
  assign and_813 = left_rdata_s7_q[84] & not_589_s7_q;
  logic and_814;
  assign and_814 = right_codes_rdata_s7_q[72] & not_589_s7_q;
  logic [11:0] select_815;
  assign select_815 = less_588_s7_q ? 12'h0 : left_rdata_s7_q[83:72];
  logic [11:0] select_816;
  assign select_816 = less_588_s7_q ? 12'h0 : right_codes_rdata_s7_q[71:60];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_820;
  assign select_820 = and_813 ? (and_814 ? (~(select_815 ^ select_816)) : 12'h0) : 12'h0;
  logic [11:0] select_1028;
  assign select_1028 = (slot_s7_q[0] ? and_814 : and_797) ? (~(select_775 ^ (slot_s7_q[0] ? select_816 : select_799))) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_1045;
  assign and_1045 = right_codes_rdata_s7_q[85] & not_589_s7_q;
  logic [11:0] select_1047;
  assign select_1047 = less_588_s7_q ? 12'h0 : right_codes_rdata_s7_q[84:73];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1051;
  assign select_1051 = (slot_s7_q[0] ? and_1045 : and_814) ? (~(select_798 ^ (slot_s7_q[0] ? select_1047 : select_816))) : 12'h0;
  // hls/stages/agreement.hpp:745
  logic select_1063;
  assign select_1063 = slot_s7_q[0] ? (right_codes_rdata_s7_q[98] & not_589_s7_q) : and_1045;
  logic [11:0] select_1065;
  assign select_1065 = slot_s7_q[0] ? (less_588_s7_q ? 12'h0 : right_codes_rdata_s7_q[97:86]) : select_1047;
  // hls/stages/agreement.hpp:222
  logic and_1274;
  assign and_1274 = right_codes_rdata_s7_q[27] & not_589_s7_q;
  // hls/stages/agreement.hpp:745
  logic select_1275;
  assign select_1275 = slot_s7_q[0] ? (right_codes_rdata_s7_q[12] & not_589_s7_q) : and_1274;
  // hls/stages/agreement.hpp:222
  logic [11:0] select_1277;
  assign select_1277 = less_588_s7_q ? 12'h0 : right_codes_rdata_s7_q[26:15];
  // hls/stages/agreement.hpp:745
  logic [11:0] select_1278;
  assign select_1278 = slot_s7_q[0] ? (less_588_s7_q ? 12'h0 : right_codes_rdata_s7_q[11:0]) : select_1277;
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1302;
  assign select_1302 = (slot_s7_q[0] ? and_1274 : and_774) ? (~(select_798 ^ (slot_s7_q[0] ? select_1277 : select_776))) : 12'h0;
  logic [11:0] select_1317;
  assign select_1317 = (slot_s7_q[0] ? and_774 : and_797) ? (~(select_815 ^ (slot_s7_q[0] ? select_776 : select_799))) : 12'h0;
  // hls/stages/census.hpp:33
  logic not_1687;
  assign not_1687 = ~sample_pair_first_s7_q;
  // hls/stages/patches.hpp:318
  logic equal_1691;
  assign equal_1691 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/agreement.hpp:150
  logic [5:0] b;
  assign b = or_585_s7_q ? (less_588_s7_q ? 6'h0 : best_left_rdata_s7_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1763;
  assign select_1763 = ($signed(10'h0) < $signed(select_1761_s7_q[16:7])) ? 14'h7f : select_1761_s7_q[13:0];
  // hls/stages/agreement.hpp:1305
  logic not_2066;
  assign not_2066 = ~marks_first_s7_q;
  // hls/stages/agreement.hpp:472
  logic and_2586;
  assign and_2586 = proven_q & less_2585;
  // hls/stages/agreement.hpp:531
  logic select_2590;
  assign select_2590 = and_555_s7_q ? (equal_2486_s7_q ? (and_2586 & (row_s7_q[6:1] == 6'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:474
  logic and_2592;
  assign and_2592 = and_2586 & equal_2591_s7_q;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2761;
  assign select_2761 = or_585_s7_q ? (less_588_s7_q ? 8'h0 : best_left_rdata_s7_q[32:25]) : 8'h0;
  logic [7:0] select_2763;
  assign select_2763 = or_585_s7_q ? (less_588_s7_q ? 8'h0 : best_left_rdata_s7_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:382
  logic and_2972;
  assign and_2972 = not_1687 & equal_1689_s7_q;
  logic [8:0] select_2973;
  assign select_2973 = and_2972 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s7_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2974;
  assign select_2974 = and_2972 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2975;
  assign select_2975 = sample_pair_first_s7_q ? select_2973 : select_2974;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2976;
  assign select_2976 = row_starts_s7_q ? select_2975[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2977;
  assign select_2977 = sample_pair_whole_s7_q ? select_2976 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2979;
  assign select_2979 = sample_pair_whole_s7_q ? (row_starts_s7_q ? select_2975[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2982;
  assign select_2982 = sample_pair_whole_s7_q ? (equal_1691 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2984;
  assign select_2984 = sample_pair_whole_s7_q ? (patches_band_rows_number_q + {4'h0, equal_1691}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:337
  logic equal_2985;
  assign equal_2985 = phase_s7_q == 4'h0;
  // hls/stages/patches.hpp:338
  logic not_2986;
  assign not_2986 = ~equal_2985;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2988;
  assign select_2988 = sample_pair_whole_s7_q ? (phase_s7_q + {{2{not_2986}}, 1'b1, not_2986}) : patches_first_band_rows_to_next_q;
  logic select_2989;
  assign select_2989 = sample_pair_whole_s7_q ? equal_2985 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3000;
  assign select_3000 = equal_2990_s7_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_3002;
  assign select_3002 = equal_2486_s7_q ? (select_3000 + {4'h0, equal_2995_s7_q}) : patches_choosing_number_q;
  logic select_3006;
  assign select_3006 = equal_2486_s7_q ? ((7'h4 < row_s7_q) & equal_2995_s7_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:531
  logic [4:0] select_3009;
  assign select_3009 = and_555_s7_q ? (equal_2486_s7_q ? select_3000 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:1165
  logic equal_3919;
  assign equal_3919 = x_s7_q[6:0] == 7'h7f;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      late_q <= 1'b0;
      patches_band_rows_rows_to_next_q <= 4'h0;
      patches_band_rows_number_q <= 5'h0;
      patches_next_band_rows_to_next_q <= 4'h0;
      patches_next_band_number_q <= 5'h0;
      patches_first_band_rows_to_next_q <= 4'h0;
      patches_first_band_number_q <= 1'b0;
      patches_choosing_number_q <= 5'h0;
      patches_chooses_q <= 1'b0;
      patches_choosing_band_q <= 5'h0;
      done_q <= 1'b0;
      proven_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s7_en) begin
      row_q <= and_555_s7_q ? (equal_2486_s7_q ? row_s7_q : row_q) : row_q;
      late_q <= select_2590;
      patches_band_rows_rows_to_next_q <= select_2977;
      patches_band_rows_number_q <= select_2979;
      patches_next_band_rows_to_next_q <= select_2982;
      patches_next_band_number_q <= select_2984;
      patches_first_band_rows_to_next_q <= select_2988;
      patches_first_band_number_q <= select_2989;
      patches_choosing_number_q <= and_555_s7_q ? select_3002 : patches_choosing_number_q;
      patches_chooses_q <= and_555_s7_q ? select_3006 : patches_chooses_q;
      patches_choosing_band_q <= select_3009;
      done_q <= not_2066 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s7_q ? done_q : proven_q;
      drew_q <= so_s7_q;
      said_q <= equal_580_s7_q & equal_3919;
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
  logic [4:0] patches_choosing_number_s8_q;
  logic patches_chooses_s8_q;
  logic [4:0] patches_choosing_band_s8_q;
  logic done_s8_q;
  logic proven_s8_q;
  logic [3:0] select_514_s8_q;
  logic equal_515_s8_q;
  logic row_starts_s8_q;
  logic [8:0] select_519_s8_q;
  logic and_528_s8_q;
  logic equal_534_s8_q;
  logic [6:0] select_549_s8_q;
  logic [6:0] last_s8_2_q;
  logic and_553_s8_q;
  logic and_555_s8_q;
  logic equal_574_s8_q;
  logic equal_580_s8_q;
  logic equal_584_s8_q;
  logic or_585_s8_q;
  logic less_588_s8_q;
  logic not_589_s8_q;
  logic equal_599_s8_q;
  logic [62:0] left_rdata_s8_q;
  logic and_613_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_622_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic [5:0] shift_s8_q;
  logic [6:0] right_s8_q;
  logic and_645_s8_q;
  logic and_648_s8_q;
  logic [77:0] right_codes_rdata_s8_q;
  logic and_654_s8_q;
  logic and_656_s8_q;
  logic and_660_s8_q;
  logic [32:0] fresh_rdata_s8_q;
  logic equal_689_s8_q;
  logic and_759_s8_q;
  logic and_760_s8_q;
  logic and_761_s8_q;
  logic and_762_s8_q;
  logic and_763_s8_q;
  logic and_764_s8_q;
  logic and_765_s8_q;
  logic and_766_s8_q;
  logic and_767_s8_q;
  logic and_768_s8_q;
  logic and_773_s8_q;
  logic [11:0] select_780_s8_q;
  logic and_796_s8_q;
  logic [11:0] select_803_s8_q;
  logic and_813_s8_q;
  logic [11:0] select_820_s8_q;
  logic [11:0] select_1028_s8_q;
  logic [11:0] select_1051_s8_q;
  logic [11:0] select_1068_s8_q;
  logic [11:0] select_1281_s8_q;
  logic [11:0] select_1302_s8_q;
  logic [11:0] select_1317_s8_q;
  logic and_1572_s8_q;
  logic equal_1573_s8_q;
  logic not_1687_s8_q;
  logic or_1693_s8_q;
  logic less_1710_s8_q;
  logic [5:0] b_s8_q;
  logic [13:0] select_1763_s8_q;
  logic sum_2001_s8_q;
  logic not_2012_s8_q;
  logic and_2026_s8_q;
  logic not_2066_s8_q;
  logic less_2144_s8_q;
  logic equal_2298_s8_q;
  logic equal_2486_s8_q;
  logic not_2582_s8_q;
  logic and_2592_s8_q;
  logic and_2622_s8_q;
  logic [7:0] select_2761_s8_q;
  logic [7:0] select_2763_s8_q;
  logic not_3034_s8_q;
  logic less_3847_s8_q;
  logic equal_3919_s8_q;
  logic or_4077_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      registration_slope_s8_q <= registration_slope_s7_q;
      patches_band_rows_number_s8_q <= patches_band_rows_number_q;
      patches_choosing_number_s8_q <= patches_choosing_number_q;
      patches_chooses_s8_q <= patches_chooses_q;
      patches_choosing_band_s8_q <= patches_choosing_band_q;
      done_s8_q <= done_q;
      proven_s8_q <= proven_q;
      select_514_s8_q <= select_514_s7_q;
      equal_515_s8_q <= equal_515_s7_q;
      row_starts_s8_q <= row_starts_s7_q;
      select_519_s8_q <= select_519_s7_q;
      and_528_s8_q <= and_528_s7_q;
      equal_534_s8_q <= equal_534_s7_q;
      select_549_s8_q <= select_549_s7_q;
      last_s8_2_q <= last_s7_2_q;
      and_553_s8_q <= and_553_s7_q;
      and_555_s8_q <= and_555_s7_q;
      equal_574_s8_q <= equal_574;
      equal_580_s8_q <= equal_580_s7_q;
      equal_584_s8_q <= equal_584_s7_q;
      or_585_s8_q <= or_585_s7_q;
      less_588_s8_q <= less_588_s7_q;
      not_589_s8_q <= not_589_s7_q;
      equal_599_s8_q <= equal_599_s7_q;
      left_rdata_s8_q <= {left_rdata_s7_q[65:49], left_rdata_s7_q[47:31], left_rdata_s7_q[29:13], left_rdata_s7_q[11:0]};
      and_613_s8_q <= (or_585_s7_q & (left_rdata_s7_q[68] & not_589_s7_q)) & and_612;
      x_s8_2_q <= x_s7_2_q;
      select_622_s8_q <= select_622_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_s7_q;
      shift_s8_q <= shift;
      right_s8_q <= right_s7_q;
      and_645_s8_q <= (or_585_s7_q & (left_rdata_s7_q[70] & not_589_s7_q)) & less_644;
      and_648_s8_q <= or_585_s7_q & (left_rdata_s7_q[71] & not_589_s7_q);
      right_codes_rdata_s8_q <= {right_codes_rdata_s7_q[84:73], right_codes_rdata_s7_q[71:60], right_codes_rdata_s7_q[56:43], right_codes_rdata_s7_q[41:28], right_codes_rdata_s7_q[26:13], right_codes_rdata_s7_q[11:0]};
      and_654_s8_q <= and_654;
      and_656_s8_q <= or_585_s7_q & (right_codes_rdata_s7_q[59] & not_589_s7_q);
      and_660_s8_q <= and_660_s7_q;
      fresh_rdata_s8_q <= fresh_rdata_q;
      equal_689_s8_q <= row_s7_q == 7'h0;
      and_759_s8_q <= left_rdata_s7_q[12] & or_758;
      and_760_s8_q <= left_rdata_s7_q[30] & or_758;
      and_761_s8_q <= left_rdata_s7_q[48] & or_758;
      and_762_s8_q <= left_rdata_s7_q[66] & or_758;
      and_763_s8_q <= right_codes_rdata_s7_q[12] & or_758;
      and_764_s8_q <= right_codes_rdata_s7_q[27] & or_758;
      and_765_s8_q <= right_codes_rdata_s7_q[42] & or_758;
      and_766_s8_q <= right_codes_rdata_s7_q[57] & or_758;
      and_767_s8_q <= right_codes_rdata_s7_q[72] & or_758;
      and_768_s8_q <= right_codes_rdata_s7_q[85] & or_758;
      and_773_s8_q <= and_773;
      select_780_s8_q <= select_780;
      and_796_s8_q <= and_796;
      select_803_s8_q <= select_803;
      and_813_s8_q <= and_813;
      select_820_s8_q <= select_820;
      select_1028_s8_q <= select_1028;
      select_1051_s8_q <= select_1051;
      select_1068_s8_q <= select_1063 ? (~(select_815 ^ select_1065)) : 12'h0;
      select_1281_s8_q <= select_1275 ? (~(select_775 ^ select_1278)) : 12'h0;
      select_1302_s8_q <= select_1302;
      select_1317_s8_q <= select_1317;
      and_1572_s8_q <= and_1572_s7_q;
      equal_1573_s8_q <= equal_1573_s7_q;
      not_1687_s8_q <= not_1687;
      or_1693_s8_q <= (~equal_1689_s7_q) | (~equal_1691);
      less_1710_s8_q <= 6'h4 < row_q[6:1];
      b_s8_q <= b;
      select_1763_s8_q <= select_1763;
      sum_2001_s8_q <= sum_2001_s7_q;
      not_2012_s8_q <= ~late_q;
      and_2026_s8_q <= or_585_s7_q & (left_rdata_s7_q[69] & not_589_s7_q);
      not_2066_s8_q <= not_2066;
      less_2144_s8_q <= 7'h6 < row_q;
      equal_2298_s8_q <= (last_s7_2_q | row_s7_q) == 7'h0;
      equal_2486_s8_q <= equal_2486_s7_q;
      not_2582_s8_q <= ~({row_s7_q, 1'b0} < {sum_2580, cfg_height_i[4]});
      and_2592_s8_q <= and_2592;
      and_2622_s8_q <= not_589_s7_q & and_612;
      select_2761_s8_q <= select_2761;
      select_2763_s8_q <= select_2763;
      not_3034_s8_q <= not_3034_s7_q;
      less_3847_s8_q <= 6'h2 < row_s7_q[6:1];
      equal_3919_s8_q <= equal_3919;
      or_4077_s8_q <= and_2592 | (~(row_s7_q[6:3] == 4'h0));
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic lower_half_q;
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
  logic patches_read_searches_q;
  // hls/stages/agreement.hpp:978
  logic [7:0] found;
  assign found = x_s8_q + {{2{shift_s8_q[5]}}, shift_s8_q};
  // hls/stages/count_bits.hpp:24
  logic parity_786;
  assign parity_786 = ^select_780_s8_q[5:3];
  logic parity_789;
  assign parity_789 = ^select_780_s8_q[8:6];
  logic parity_792;
  assign parity_792 = ^select_780_s8_q[11:3];
  logic parity_806;
  assign parity_806 = ^select_803_s8_q[8:6];
  logic parity_809;
  assign parity_809 = ^select_803_s8_q[11:9];
  logic parity_826;
  assign parity_826 = ^select_820_s8_q[2:0];
  logic parity_829;
  assign parity_829 = ^select_820_s8_q[5:3];
  logic parity_832;
  assign parity_832 = ^select_820_s8_q[8:0];
  logic parity_838;
  assign parity_838 = ^select_820_s8_q[11:9];
  logic parity_841;
  assign parity_841 = ^select_803_s8_q[2:0];
  logic parity_844;
  assign parity_844 = ^{select_820_s8_q[11:9], select_803_s8_q[5:0]};
  logic parity_847;
  assign parity_847 = ^{select_820_s8_q, select_803_s8_q, select_780_s8_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_852;
  assign or_852 = (select_780_s8_q[1:0] == 2'h3) | (select_780_s8_q[2] & (select_780_s8_q[0] | select_780_s8_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_856;
  assign or_856 = (select_803_s8_q[7:6] == 2'h3) | (select_803_s8_q[8] & (select_803_s8_q[6] | select_803_s8_q[7]));
  logic or_860;
  assign or_860 = (select_803_s8_q[10:9] == 2'h3) | (select_803_s8_q[11] & (select_803_s8_q[9] | select_803_s8_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_868;
  assign or_868 = (select_820_s8_q[7:6] == 2'h3) | (select_820_s8_q[8] & (~(select_820_s8_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_872;
  assign or_872 = (select_820_s8_q[1:0] == 2'h3) | (select_820_s8_q[2] & (select_820_s8_q[0] | select_820_s8_q[1]));
  logic or_876;
  assign or_876 = (select_820_s8_q[4:3] == 2'h3) | (select_820_s8_q[5] & (select_820_s8_q[3] | select_820_s8_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_879;
  assign parity_879 = ^{or_876, or_872, or_868};
  // hls/stages/count_bits.hpp:23
  logic or_883;
  assign or_883 = (select_803_s8_q[4:3] == 2'h3) | (select_803_s8_q[5] & (select_803_s8_q[3] | select_803_s8_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_887;
  assign or_887 = (select_820_s8_q[10:9] == 2'h3) | (select_820_s8_q[11] & (select_820_s8_q[9] | select_820_s8_q[10]));
  logic or_891;
  assign or_891 = (select_803_s8_q[1:0] == 2'h3) | (select_803_s8_q[2] & (select_803_s8_q[0] | select_803_s8_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_894;
  assign parity_894 = ^{or_891, or_887, or_883};
  logic parity_897;
  assign parity_897 = ^{or_891, or_887, or_883, or_876, or_872, or_868, or_860, or_856, or_852};
  // hls/stages/count_bits.hpp:25
  logic or_902;
  assign or_902 = (parity_786 & parity_789) | ((^select_780_s8_q[11:9]) & (parity_786 | parity_789));
  logic and_905;
  assign and_905 = (^{select_803_s8_q[11:6], select_780_s8_q[2:0]}) & (parity_832 | parity_844);
  // hls/stages/count_bits.hpp:23
  logic or_913;
  assign or_913 = (select_780_s8_q[10:9] == 2'h3) | (select_780_s8_q[11] & (select_780_s8_q[9] | select_780_s8_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_917;
  assign or_917 = (select_780_s8_q[4:3] == 2'h3) | (select_780_s8_q[5] & (select_780_s8_q[3] | select_780_s8_q[4]));
  logic or_921;
  assign or_921 = (select_780_s8_q[7:6] == 2'h3) | (select_780_s8_q[8] & (select_780_s8_q[6] | select_780_s8_q[7]));
  logic or_928;
  assign or_928 = (parity_806 & parity_809) | ((^select_780_s8_q[2:0]) & (parity_806 | parity_809));
  logic or_932;
  assign or_932 = (parity_826 & parity_829) | ((^select_820_s8_q[8:6]) & (parity_826 | parity_829));
  logic or_936;
  assign or_936 = (parity_838 & parity_841) | ((^select_803_s8_q[5:3]) & (parity_838 | parity_841));
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1029;
  assign select_1029 = and_773_s8_q ? select_1028_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1035;
  assign parity_1035 = ^select_1029[5:3];
  logic parity_1038;
  assign parity_1038 = ^select_1029[8:6];
  logic parity_1041;
  assign parity_1041 = ^select_1029[11:3];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1052;
  assign select_1052 = and_796_s8_q ? select_1051_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1055;
  assign parity_1055 = ^select_1052[8:6];
  logic parity_1058;
  assign parity_1058 = ^select_1052[11:9];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1069;
  assign select_1069 = and_813_s8_q ? select_1068_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1075;
  assign parity_1075 = ^select_1069[2:0];
  logic parity_1078;
  assign parity_1078 = ^select_1069[5:3];
  logic parity_1081;
  assign parity_1081 = ^select_1069[8:0];
  logic parity_1087;
  assign parity_1087 = ^select_1069[11:9];
  logic parity_1090;
  assign parity_1090 = ^select_1052[2:0];
  logic parity_1093;
  assign parity_1093 = ^{select_1069[11:9], select_1052[5:0]};
  logic parity_1096;
  assign parity_1096 = ^{select_1069, select_1052, select_1029[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1101;
  assign or_1101 = (select_1029[1:0] == 2'h3) | (select_1029[2] & (select_1029[0] | select_1029[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1105;
  assign or_1105 = (select_1052[7:6] == 2'h3) | (select_1052[8] & (select_1052[6] | select_1052[7]));
  logic or_1109;
  assign or_1109 = (select_1052[10:9] == 2'h3) | (select_1052[11] & (select_1052[9] | select_1052[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1117;
  assign or_1117 = (select_1069[7:6] == 2'h3) | (select_1069[8] & (~(select_1069[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1121;
  assign or_1121 = (select_1069[1:0] == 2'h3) | (select_1069[2] & (select_1069[0] | select_1069[1]));
  logic or_1125;
  assign or_1125 = (select_1069[4:3] == 2'h3) | (select_1069[5] & (select_1069[3] | select_1069[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1128;
  assign parity_1128 = ^{or_1125, or_1121, or_1117};
  // hls/stages/count_bits.hpp:23
  logic or_1132;
  assign or_1132 = (select_1052[4:3] == 2'h3) | (select_1052[5] & (select_1052[3] | select_1052[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1136;
  assign or_1136 = (select_1069[10:9] == 2'h3) | (select_1069[11] & (select_1069[9] | select_1069[10]));
  logic or_1140;
  assign or_1140 = (select_1052[1:0] == 2'h3) | (select_1052[2] & (select_1052[0] | select_1052[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1143;
  assign parity_1143 = ^{or_1140, or_1136, or_1132};
  logic parity_1146;
  assign parity_1146 = ^{or_1140, or_1136, or_1132, or_1125, or_1121, or_1117, or_1109, or_1105, or_1101};
  // hls/stages/count_bits.hpp:25
  logic or_1151;
  assign or_1151 = (parity_1035 & parity_1038) | ((^select_1029[11:9]) & (parity_1035 | parity_1038));
  logic and_1154;
  assign and_1154 = (^{select_1052[11:6], select_1029[2:0]}) & (parity_1081 | parity_1093);
  // hls/stages/count_bits.hpp:23
  logic or_1162;
  assign or_1162 = (select_1029[10:9] == 2'h3) | (select_1029[11] & (select_1029[9] | select_1029[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1166;
  assign or_1166 = (select_1029[4:3] == 2'h3) | (select_1029[5] & (select_1029[3] | select_1029[4]));
  logic or_1170;
  assign or_1170 = (select_1029[7:6] == 2'h3) | (select_1029[8] & (select_1029[6] | select_1029[7]));
  logic or_1177;
  assign or_1177 = (parity_1055 & parity_1058) | ((^select_1029[2:0]) & (parity_1055 | parity_1058));
  logic or_1181;
  assign or_1181 = (parity_1075 & parity_1078) | ((^select_1069[8:6]) & (parity_1075 | parity_1078));
  logic or_1185;
  assign or_1185 = (parity_1087 & parity_1090) | ((^select_1052[5:3]) & (parity_1087 | parity_1090));
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1282;
  assign select_1282 = and_773_s8_q ? select_1281_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1288;
  assign parity_1288 = ^select_1282[5:3];
  logic parity_1291;
  assign parity_1291 = ^select_1282[8:6];
  logic parity_1294;
  assign parity_1294 = ^select_1282[11:3];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1303;
  assign select_1303 = and_796_s8_q ? select_1302_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1306;
  assign parity_1306 = ^select_1303[8:6];
  logic parity_1309;
  assign parity_1309 = ^select_1303[11:9];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1318;
  assign select_1318 = and_813_s8_q ? select_1317_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1324;
  assign parity_1324 = ^select_1318[2:0];
  logic parity_1327;
  assign parity_1327 = ^select_1318[5:3];
  logic parity_1330;
  assign parity_1330 = ^select_1318[8:0];
  logic parity_1336;
  assign parity_1336 = ^select_1318[11:9];
  logic parity_1339;
  assign parity_1339 = ^select_1303[2:0];
  logic parity_1342;
  assign parity_1342 = ^{select_1318[11:9], select_1303[5:0]};
  logic parity_1345;
  assign parity_1345 = ^{select_1318, select_1303, select_1282[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1350;
  assign or_1350 = (select_1282[1:0] == 2'h3) | (select_1282[2] & (select_1282[0] | select_1282[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1354;
  assign or_1354 = (select_1303[7:6] == 2'h3) | (select_1303[8] & (select_1303[6] | select_1303[7]));
  logic or_1358;
  assign or_1358 = (select_1303[10:9] == 2'h3) | (select_1303[11] & (select_1303[9] | select_1303[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1366;
  assign or_1366 = (select_1318[7:6] == 2'h3) | (select_1318[8] & (~(select_1318[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1370;
  assign or_1370 = (select_1318[1:0] == 2'h3) | (select_1318[2] & (select_1318[0] | select_1318[1]));
  logic or_1374;
  assign or_1374 = (select_1318[4:3] == 2'h3) | (select_1318[5] & (select_1318[3] | select_1318[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1377;
  assign parity_1377 = ^{or_1374, or_1370, or_1366};
  // hls/stages/count_bits.hpp:23
  logic or_1381;
  assign or_1381 = (select_1303[4:3] == 2'h3) | (select_1303[5] & (select_1303[3] | select_1303[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1385;
  assign or_1385 = (select_1318[10:9] == 2'h3) | (select_1318[11] & (select_1318[9] | select_1318[10]));
  logic or_1389;
  assign or_1389 = (select_1303[1:0] == 2'h3) | (select_1303[2] & (select_1303[0] | select_1303[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1392;
  assign parity_1392 = ^{or_1389, or_1385, or_1381};
  logic parity_1395;
  assign parity_1395 = ^{or_1389, or_1385, or_1381, or_1374, or_1370, or_1366, or_1358, or_1354, or_1350};
  // hls/stages/count_bits.hpp:25
  logic or_1400;
  assign or_1400 = (parity_1288 & parity_1291) | ((^select_1282[11:9]) & (parity_1288 | parity_1291));
  logic and_1403;
  assign and_1403 = (^{select_1303[11:6], select_1282[2:0]}) & (parity_1330 | parity_1342);
  // hls/stages/count_bits.hpp:23
  logic or_1411;
  assign or_1411 = (select_1282[10:9] == 2'h3) | (select_1282[11] & (select_1282[9] | select_1282[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1415;
  assign or_1415 = (select_1282[4:3] == 2'h3) | (select_1282[5] & (select_1282[3] | select_1282[4]));
  logic or_1419;
  assign or_1419 = (select_1282[7:6] == 2'h3) | (select_1282[8] & (select_1282[6] | select_1282[7]));
  logic or_1426;
  assign or_1426 = (parity_1306 & parity_1309) | ((^select_1282[2:0]) & (parity_1306 | parity_1309));
  logic or_1430;
  assign or_1430 = (parity_1324 & parity_1327) | ((^select_1318[8:6]) & (parity_1324 | parity_1327));
  logic or_1434;
  assign or_1434 = (parity_1336 & parity_1339) | ((^select_1303[5:3]) & (parity_1336 | parity_1339));
  // hls/stages/agreement.hpp:248
  logic or_1593;
  assign or_1593 = (cfg_nearer_below_i & shift_s8_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s8_q)));
  // hls/stages/patches.hpp:401
  logic not_1684;
  assign not_1684 = ~patches_begins_q;
  // hls/stages/patches.hpp:371
  logic and_1688;
  assign and_1688 = patches_capturing_q & not_1687_s8_q;
  // hls/stages/patches.hpp:125
  logic and_1696;
  assign and_1696 = (not_1684 & (patches_work_q == 3'h0)) & (~(and_1688 | or_1693_s8_q));
  // hls/stages/registration.hpp:213
  logic [9:0] select_1764;
  assign select_1764 = b_s8_q[4] ? select_1763_s8_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1769;
  assign sum_1769 = (b_s8_q[0] ? select_1763_s8_q[13:1] : 13'h0) + (b_s8_q[1] ? select_1763_s8_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1770;
  assign select_1770 = b_s8_q[2] ? select_1763_s8_q[11:0] : 12'h0;
  // hls/stages/patches.hpp:542
  logic equal_1791;
  assign equal_1791 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:514
  logic equal_1793;
  assign equal_1793 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:508
  logic equal_1795;
  assign equal_1795 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1796;
  assign equal_1796 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:542
  logic or_1797;
  assign or_1797 = equal_1795 | equal_1796;
  // hls/stages/patches.hpp:469
  logic not_1798;
  assign not_1798 = ~patches_second_q;
  // hls/stages/patches.hpp:382
  logic [4:0] select_1825;
  assign select_1825 = and_1696 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1826;
  assign select_1826 = row_starts_s8_q ? select_1825 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1828;
  assign and_1828 = and_1688 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1832;
  assign select_1832 = row_starts_s8_q ? (and_1696 | (and_1688 & (~and_1828))) : patches_capturing_q;
  // hls/stages/patches.hpp:168
  logic not_1856;
  assign not_1856 = ~equal_1796;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_1870;
  assign select_1870 = row_starts_s8_q ? {select_1825[4], select_1825[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:554
  logic less_1974;
  assign less_1974 = patches_step_q[4:0] < 5'h11;
  logic equal_1975;
  assign equal_1975 = patches_step_q[6:5] == 2'h2;
  logic equal_1976;
  assign equal_1976 = patches_step_q[6:5] == 2'h1;
  logic or_1977;
  assign or_1977 = equal_1975 | equal_1976;
  // hls/stages/agreement.hpp:531
  logic select_2584;
  assign select_2584 = and_555_s8_q ? (equal_2486_s8_q ? not_2582_s8_q : lower_half_q) : lower_half_q;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2759;
  assign select_2759 = or_585_s8_q ? (less_588_s8_q ? 8'h0 : best_left_rdata_s8_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2761_s8_q} - {1'b0, select_2763_s8_q};
  // hls/stages/patches.hpp:402
  logic or_3075;
  assign or_3075 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:404
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3080;
  assign select_3080 = (patches_second_q | patches_begins_q) ? not_1684 : (patches_ends_q & equal_1791);
  logic and_3081;
  assign and_3081 = equal_1791 & not_1798;
  // hls/stages/patches.hpp:408
  logic and_3082;
  assign and_3082 = not_1856 & and_3081;
  logic [1:0] select_3084;
  assign select_3084 = equal_1793 ? 2'h0 : (equal_1795 ? 2'h3 : {equal_1796, and_3082});
  // hls/stages/patches.hpp:286
  logic equal_3086;
  assign equal_3086 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:284
  logic not_3087;
  assign not_3087 = ~equal_3086;
  // hls/stages/patches.hpp:286
  logic equal_3088;
  assign equal_3088 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:282
  logic not_3089;
  assign not_3089 = ~equal_3088;
  // hls/stages/patches.hpp:290
  logic not_3091;
  assign not_3091 = ~(patches_following_q == 3'h2);
  logic and_3094;
  assign and_3094 = (~(patches_following_q == 3'h1)) & not_3091;
  // hls/stages/patches.hpp:406
  logic [1:0] select_3095;
  assign select_3095 = equal_3088 ? 2'h2 : {and_3094, not_3091};
  logic [3:0] select_3096;
  assign select_3096 = equal_3086 ? 4'h2 : {select_3095, {2{not_3089}}};
  // hls/stages/patches.hpp:414
  logic not_3099;
  assign not_3099 = ~or_3075;
  // hls/stages/patches.hpp:403
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:415
  logic [11:0] select_3104;
  assign select_3104 = or_3075 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/agreement.hpp:276
  logic select_3556;
  assign select_3556 = equal_1791 ? (less_1974 & (equal_1976 & or_1977)) : patches_read_searches_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s8_q[6:0];
  logic left_we;
  assign left_we = s8_en & and_660_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_762_s8_q, left_rdata_s8_q[62:46], and_761_s8_q, left_rdata_s8_q[45:29], and_760_s8_q, left_rdata_s8_q[28:12], and_759_s8_q, left_rdata_s8_q[11:0], fresh_rdata_s8_q[30:26], fresh_rdata_s8_q[24], fresh_rdata_s8_q[11:0]};
  end
`ifndef SYNTHESIS
  logic [6:0] left_raddr_s6_sim;
  logic left_re_s6_sim;
  logic [6:0] left_raddr_s7_sim;
  logic left_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_re_s6_sim <= 1'b0;
      left_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      left_re_s6_sim <= left_re;
      left_raddr_s6_sim <= left_raddr;
      left_re_s7_sim <= left_re_s6_sim;
      left_raddr_s7_sim <= left_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s6_sim && left_raddr_s6_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s7_sim && left_raddr_s7_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd120) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd120) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s8_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s8_en & and_660_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_768_s8_q, right_codes_rdata_s8_q[77:66], and_767_s8_q, right_codes_rdata_s8_q[65:54], and_766_s8_q, right_codes_rdata_s8_q[53:40], and_765_s8_q, right_codes_rdata_s8_q[39:26], and_764_s8_q, right_codes_rdata_s8_q[25:12], and_763_s8_q, right_codes_rdata_s8_q[11:0], fresh_rdata_s8_q[32:31], fresh_rdata_s8_q[25], fresh_rdata_s8_q[23:12]};
  end
`ifndef SYNTHESIS
  logic [6:0] right_codes_raddr_s6_sim;
  logic right_codes_re_s6_sim;
  logic [6:0] right_codes_raddr_s7_sim;
  logic right_codes_re_s7_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_codes_re_s6_sim <= 1'b0;
      right_codes_re_s7_sim <= 1'b0;
    end else if (en_i) begin
      right_codes_re_s6_sim <= right_codes_re;
      right_codes_raddr_s6_sim <= right_codes_raddr;
      right_codes_re_s7_sim <= right_codes_re_s6_sim;
      right_codes_raddr_s7_sim <= right_codes_raddr_s6_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s6_sim && right_codes_raddr_s6_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s7_sim && right_codes_raddr_s7_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_waddr >= 7'd120) $error("right_codes: write outside, address %0d", right_codes_waddr);
    end
    if (rst_ni && right_codes_re && right_codes_raddr >= 7'd120) $error("right_codes: read outside, address %0d", right_codes_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      lower_half_q <= 1'b0;
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
      patches_read_searches_q <= 1'b0;
    end else if (s8_en) begin
      lower_half_q <= select_2584;
      patches_capturing_q <= sample_pair_whole_s8_q ? select_1832 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s8_q ? select_1826 : patches_row_q;
      patches_work_q <= or_3075 ? following : patches_work_q;
      patches_second_q <= select_3080;
      patches_following_q <= equal_1791 ? {2'h0, and_3081} : {equal_1793, select_3084};
      patches_following_beats_q <= {select_3096, not_3087};
      patches_begins_q <= sample_pair_whole_s8_q & (row_starts_s8_q & and_1828);
      patches_ends_q <= not_3099 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3104;
      patches_step_q <= or_3075 ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3556;
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
  logic [4:0] patches_choosing_number_s9_q;
  logic patches_chooses_s9_q;
  logic [4:0] patches_choosing_band_s9_q;
  logic patches_second_s9_q;
  logic [4:0] patches_step_s9_q;
  logic patches_read_searches_s9_q;
  logic done_s9_q;
  logic proven_s9_q;
  logic [3:0] select_514_s9_q;
  logic equal_515_s9_q;
  logic row_starts_s9_q;
  logic [8:0] select_519_s9_q;
  logic and_528_s9_q;
  logic equal_534_s9_q;
  logic [6:0] select_549_s9_q;
  logic [6:0] last_s9_2_q;
  logic and_553_s9_q;
  logic and_555_s9_q;
  logic equal_574_s9_q;
  logic equal_580_s9_q;
  logic so_s9_q;
  logic equal_584_s9_q;
  logic or_585_s9_q;
  logic less_588_s9_q;
  logic not_589_s9_q;
  logic equal_599_s9_q;
  logic and_613_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_622_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic [6:0] select_631_s9_q;
  logic [6:0] right_s9_q;
  logic and_645_s9_q;
  logic and_648_s9_q;
  logic and_654_s9_q;
  logic and_656_s9_q;
  logic equal_689_s9_q;
  logic xor_848_s9_q;
  logic parity_897_s9_q;
  logic and_898_s9_q;
  logic or_902_s9_q;
  logic or_906_s9_q;
  logic or_913_s9_q;
  logic or_917_s9_q;
  logic or_921_s9_q;
  logic or_928_s9_q;
  logic or_932_s9_q;
  logic or_936_s9_q;
  logic and_945_s9_q;
  logic and_947_s9_q;
  logic or_959_s9_q;
  logic or_963_s9_q;
  logic or_967_s9_q;
  logic xor_1097_s9_q;
  logic parity_1112_s9_q;
  logic parity_1146_s9_q;
  logic and_1147_s9_q;
  logic or_1151_s9_q;
  logic or_1155_s9_q;
  logic or_1162_s9_q;
  logic or_1166_s9_q;
  logic or_1170_s9_q;
  logic or_1177_s9_q;
  logic or_1181_s9_q;
  logic or_1185_s9_q;
  logic and_1194_s9_q;
  logic or_1195_s9_q;
  logic or_1208_s9_q;
  logic or_1212_s9_q;
  logic or_1216_s9_q;
  logic xor_1346_s9_q;
  logic parity_1361_s9_q;
  logic parity_1395_s9_q;
  logic and_1396_s9_q;
  logic or_1400_s9_q;
  logic or_1404_s9_q;
  logic or_1411_s9_q;
  logic or_1415_s9_q;
  logic or_1419_s9_q;
  logic or_1426_s9_q;
  logic or_1430_s9_q;
  logic or_1434_s9_q;
  logic and_1443_s9_q;
  logic or_1444_s9_q;
  logic or_1457_s9_q;
  logic or_1461_s9_q;
  logic or_1465_s9_q;
  logic and_1572_s9_q;
  logic equal_1573_s9_q;
  logic or_1593_s9_q;
  logic and_1696_s9_q;
  logic less_1710_s9_q;
  logic [5:0] b_s9_q;
  logic select_1764_s9_q;
  logic [8:0] difference_1766_s9_q;
  logic [11:0] sum_1769_s9_q;
  logic select_1770_s9_q;
  logic [10:0] sum_1772_s9_q;
  logic equal_1791_s9_q;
  logic equal_1793_s9_q;
  logic equal_1795_s9_q;
  logic equal_1796_s9_q;
  logic or_1797_s9_q;
  logic not_1798_s9_q;
  logic and_1800_s9_q;
  logic [4:0] select_1826_s9_q;
  logic select_1832_s9_q;
  logic and_1838_s9_q;
  logic and_1857_s9_q;
  logic [3:0] select_1870_s9_q;
  logic less_1974_s9_q;
  logic equal_1975_s9_q;
  logic or_1977_s9_q;
  logic sum_2001_s9_q;
  logic not_2012_s9_q;
  logic and_2026_s9_q;
  logic not_2066_s9_q;
  logic less_2144_s9_q;
  logic equal_2298_s9_q;
  logic equal_2486_s9_q;
  logic and_2592_s9_q;
  logic and_2623_s9_q;
  logic equal_2712_s9_q;
  logic [7:0] select_2759_s9_q;
  logic rise_2_s9_q;
  logic [7:0] select_2765_s9_q;
  logic [7:0] xor_2770_s9_q;
  logic less_2796_s9_q;
  logic not_3034_s9_q;
  logic or_3075_s9_q;
  logic not_3099_s9_q;
  logic equal_3591_s9_q;
  logic less_3847_s9_q;
  logic equal_3919_s9_q;
  logic or_4077_s9_q;
  logic and_4091_s9_q;
  logic and_4108_s9_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      patches_choosing_number_s9_q <= patches_choosing_number_s8_q;
      patches_chooses_s9_q <= patches_chooses_s8_q;
      patches_choosing_band_s9_q <= patches_choosing_band_s8_q;
      patches_second_s9_q <= patches_second_q;
      patches_step_s9_q <= patches_step_q[4:0];
      patches_read_searches_s9_q <= patches_read_searches_q;
      done_s9_q <= done_s8_q;
      proven_s9_q <= proven_s8_q;
      select_514_s9_q <= select_514_s8_q;
      equal_515_s9_q <= equal_515_s8_q;
      row_starts_s9_q <= row_starts_s8_q;
      select_519_s9_q <= select_519_s8_q;
      and_528_s9_q <= and_528_s8_q;
      equal_534_s9_q <= equal_534_s8_q;
      select_549_s9_q <= select_549_s8_q;
      last_s9_2_q <= last_s8_2_q;
      and_553_s9_q <= and_553_s8_q;
      and_555_s9_q <= and_555_s8_q;
      equal_574_s9_q <= equal_574_s8_q;
      equal_580_s9_q <= equal_580_s8_q;
      so_s9_q <= drew_q;
      equal_584_s9_q <= equal_584_s8_q;
      or_585_s9_q <= or_585_s8_q;
      less_588_s9_q <= less_588_s8_q;
      not_589_s9_q <= not_589_s8_q;
      equal_599_s9_q <= equal_599_s8_q;
      and_613_s9_q <= and_613_s8_q;
      x_s9_2_q <= x_s8_2_q;
      select_622_s9_q <= select_622_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_631_s9_q <= ({1'b0, last_s8_q} < found) ? 7'h0 : found[6:0];
      right_s9_q <= right_s8_q;
      and_645_s9_q <= and_645_s8_q;
      and_648_s9_q <= and_648_s8_q;
      and_654_s9_q <= and_654_s8_q;
      and_656_s9_q <= and_656_s8_q;
      equal_689_s9_q <= equal_689_s8_q;
      xor_848_s9_q <= parity_792 ^ parity_847;
      parity_897_s9_q <= parity_897;
      and_898_s9_q <= parity_792 & parity_847;
      or_902_s9_q <= or_902;
      or_906_s9_q <= (parity_832 & parity_844) | and_905;
      or_913_s9_q <= or_913;
      or_917_s9_q <= or_917;
      or_921_s9_q <= or_921;
      or_928_s9_q <= or_928;
      or_932_s9_q <= or_932;
      or_936_s9_q <= or_936;
      and_945_s9_q <= parity_879 & parity_894;
      and_947_s9_q <= (^{or_860, or_856, or_852}) & (parity_879 | parity_894);
      or_959_s9_q <= (or_856 & or_860) | (or_852 & (or_856 | or_860));
      or_963_s9_q <= (or_872 & or_876) | (or_868 & (or_872 | or_876));
      or_967_s9_q <= (or_887 & or_891) | (or_883 & (or_887 | or_891));
      xor_1097_s9_q <= parity_1041 ^ parity_1096;
      parity_1112_s9_q <= ^{or_1109, or_1105, or_1101};
      parity_1146_s9_q <= parity_1146;
      and_1147_s9_q <= parity_1041 & parity_1096;
      or_1151_s9_q <= or_1151;
      or_1155_s9_q <= (parity_1081 & parity_1093) | and_1154;
      or_1162_s9_q <= or_1162;
      or_1166_s9_q <= or_1166;
      or_1170_s9_q <= or_1170;
      or_1177_s9_q <= or_1177;
      or_1181_s9_q <= or_1181;
      or_1185_s9_q <= or_1185;
      and_1194_s9_q <= parity_1128 & parity_1143;
      or_1195_s9_q <= parity_1128 | parity_1143;
      or_1208_s9_q <= (or_1105 & or_1109) | (or_1101 & (or_1105 | or_1109));
      or_1212_s9_q <= (or_1121 & or_1125) | (or_1117 & (or_1121 | or_1125));
      or_1216_s9_q <= (or_1136 & or_1140) | (or_1132 & (or_1136 | or_1140));
      xor_1346_s9_q <= parity_1294 ^ parity_1345;
      parity_1361_s9_q <= ^{or_1358, or_1354, or_1350};
      parity_1395_s9_q <= parity_1395;
      and_1396_s9_q <= parity_1294 & parity_1345;
      or_1400_s9_q <= or_1400;
      or_1404_s9_q <= (parity_1330 & parity_1342) | and_1403;
      or_1411_s9_q <= or_1411;
      or_1415_s9_q <= or_1415;
      or_1419_s9_q <= or_1419;
      or_1426_s9_q <= or_1426;
      or_1430_s9_q <= or_1430;
      or_1434_s9_q <= or_1434;
      and_1443_s9_q <= parity_1377 & parity_1392;
      or_1444_s9_q <= parity_1377 | parity_1392;
      or_1457_s9_q <= (or_1354 & or_1358) | (or_1350 & (or_1354 | or_1358));
      or_1461_s9_q <= (or_1370 & or_1374) | (or_1366 & (or_1370 | or_1374));
      or_1465_s9_q <= (or_1385 & or_1389) | (or_1381 & (or_1385 | or_1389));
      and_1572_s9_q <= and_1572_s8_q;
      equal_1573_s9_q <= equal_1573_s8_q;
      or_1593_s9_q <= or_1593;
      and_1696_s9_q <= and_1696;
      less_1710_s9_q <= less_1710_s8_q;
      b_s9_q <= b_s8_q;
      select_1764_s9_q <= select_1764[0];
      difference_1766_s9_q <= select_1764[9:1] - (b_s8_q[5] ? select_1763_s8_q[8:0] : 9'h0);
      sum_1769_s9_q <= sum_1769[12:1];
      select_1770_s9_q <= select_1770[0];
      sum_1772_s9_q <= select_1770[11:1] + (b_s8_q[3] ? select_1763_s8_q[10:0] : 11'h0);
      equal_1791_s9_q <= equal_1791;
      equal_1793_s9_q <= equal_1793;
      equal_1795_s9_q <= equal_1795;
      equal_1796_s9_q <= equal_1796;
      or_1797_s9_q <= or_1797;
      not_1798_s9_q <= not_1798;
      and_1800_s9_q <= or_1797 & (equal_1796 & not_1798);
      select_1826_s9_q <= select_1826;
      select_1832_s9_q <= select_1832;
      and_1838_s9_q <= or_1797 & (patches_second_q & equal_1796);
      and_1857_s9_q <= not_1856 & or_1797;
      select_1870_s9_q <= select_1870;
      less_1974_s9_q <= less_1974;
      equal_1975_s9_q <= equal_1975;
      or_1977_s9_q <= or_1977;
      sum_2001_s9_q <= sum_2001_s8_q;
      not_2012_s9_q <= not_2012_s8_q;
      and_2026_s9_q <= and_2026_s8_q;
      not_2066_s9_q <= not_2066_s8_q;
      less_2144_s9_q <= less_2144_s8_q;
      equal_2298_s9_q <= equal_2298_s8_q;
      equal_2486_s9_q <= equal_2486_s8_q;
      and_2592_s9_q <= and_2592_s8_q;
      and_2623_s9_q <= or_585_s8_q & and_2622_s8_q;
      equal_2712_s9_q <= shift_s8_q == 6'h0;
      select_2759_s9_q <= select_2759;
      rise_2_s9_q <= rise_2[8];
      select_2765_s9_q <= rise_2[8] ? select_2761_s8_q : select_2763_s8_q;
      xor_2770_s9_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2796_s9_q <= select_2761_s8_q < select_2763_s8_q;
      not_3034_s9_q <= not_3034_s8_q;
      or_3075_s9_q <= or_3075;
      not_3099_s9_q <= not_3099;
      equal_3591_s9_q <= patches_step_q[6:5] == 2'h3;
      less_3847_s9_q <= less_3847_s8_q;
      equal_3919_s9_q <= equal_3919_s8_q;
      or_4077_s9_q <= or_4077_s8_q;
      and_4091_s9_q <= said_q;
      and_4108_s9_q <= less_2585 & proven_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/count_bits.hpp:24
  logic parity_924;
  assign parity_924 = ^{or_921_s9_q, or_917_s9_q, or_913_s9_q};
  logic parity_939;
  assign parity_939 = ^{or_936_s9_q, or_932_s9_q, or_928_s9_q};
  logic parity_942;
  assign parity_942 = ^{or_936_s9_q, or_932_s9_q, or_928_s9_q, or_921_s9_q, or_917_s9_q, or_913_s9_q, or_906_s9_q, or_902_s9_q, and_898_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_944;
  assign and_944 = parity_897_s9_q & parity_942;
  logic or_948;
  assign or_948 = and_945_s9_q | and_947_s9_q;
  logic and_951;
  assign and_951 = (^{or_906_s9_q, or_902_s9_q, and_898_s9_q}) & (parity_924 | parity_939);
  logic or_952;
  assign or_952 = (parity_924 & parity_939) | and_951;
  // hls/stages/count_bits.hpp:24
  logic parity_970;
  assign parity_970 = ^{or_967_s9_q, or_963_s9_q, or_959_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_974;
  assign or_974 = (or_902_s9_q & or_906_s9_q) | (and_898_s9_q & (or_902_s9_q | or_906_s9_q));
  logic or_978;
  assign or_978 = (or_917_s9_q & or_921_s9_q) | (or_913_s9_q & (or_917_s9_q | or_921_s9_q));
  logic or_982;
  assign or_982 = (or_932_s9_q & or_936_s9_q) | (or_928_s9_q & (or_932_s9_q | or_936_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_985;
  assign parity_985 = ^{or_982, or_978, or_974};
  logic parity_988;
  assign parity_988 = ^{or_982, or_978, or_974, or_967_s9_q, or_963_s9_q, or_959_s9_q, or_952, or_948, and_944};
  // hls/stages/count_bits.hpp:25
  logic or_1000;
  assign or_1000 = (or_963_s9_q & or_967_s9_q) | (or_959_s9_q & (or_963_s9_q | or_967_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1173;
  assign parity_1173 = ^{or_1170_s9_q, or_1166_s9_q, or_1162_s9_q};
  logic parity_1188;
  assign parity_1188 = ^{or_1185_s9_q, or_1181_s9_q, or_1177_s9_q};
  logic parity_1191;
  assign parity_1191 = ^{or_1185_s9_q, or_1181_s9_q, or_1177_s9_q, or_1170_s9_q, or_1166_s9_q, or_1162_s9_q, or_1155_s9_q, or_1151_s9_q, and_1147_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1193;
  assign and_1193 = parity_1146_s9_q & parity_1191;
  logic or_1197;
  assign or_1197 = and_1194_s9_q | (parity_1112_s9_q & or_1195_s9_q);
  logic and_1200;
  assign and_1200 = (^{or_1155_s9_q, or_1151_s9_q, and_1147_s9_q}) & (parity_1173 | parity_1188);
  logic or_1201;
  assign or_1201 = (parity_1173 & parity_1188) | and_1200;
  // hls/stages/count_bits.hpp:24
  logic parity_1219;
  assign parity_1219 = ^{or_1216_s9_q, or_1212_s9_q, or_1208_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1223;
  assign or_1223 = (or_1151_s9_q & or_1155_s9_q) | (and_1147_s9_q & (or_1151_s9_q | or_1155_s9_q));
  logic or_1227;
  assign or_1227 = (or_1166_s9_q & or_1170_s9_q) | (or_1162_s9_q & (or_1166_s9_q | or_1170_s9_q));
  logic or_1231;
  assign or_1231 = (or_1181_s9_q & or_1185_s9_q) | (or_1177_s9_q & (or_1181_s9_q | or_1185_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1234;
  assign parity_1234 = ^{or_1231, or_1227, or_1223};
  logic parity_1237;
  assign parity_1237 = ^{or_1231, or_1227, or_1223, or_1216_s9_q, or_1212_s9_q, or_1208_s9_q, or_1201, or_1197, and_1193};
  // hls/stages/count_bits.hpp:25
  logic or_1249;
  assign or_1249 = (or_1212_s9_q & or_1216_s9_q) | (or_1208_s9_q & (or_1212_s9_q | or_1216_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1422;
  assign parity_1422 = ^{or_1419_s9_q, or_1415_s9_q, or_1411_s9_q};
  logic parity_1437;
  assign parity_1437 = ^{or_1434_s9_q, or_1430_s9_q, or_1426_s9_q};
  logic parity_1440;
  assign parity_1440 = ^{or_1434_s9_q, or_1430_s9_q, or_1426_s9_q, or_1419_s9_q, or_1415_s9_q, or_1411_s9_q, or_1404_s9_q, or_1400_s9_q, and_1396_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1442;
  assign and_1442 = parity_1395_s9_q & parity_1440;
  logic or_1446;
  assign or_1446 = and_1443_s9_q | (parity_1361_s9_q & or_1444_s9_q);
  logic and_1449;
  assign and_1449 = (^{or_1404_s9_q, or_1400_s9_q, and_1396_s9_q}) & (parity_1422 | parity_1437);
  logic or_1450;
  assign or_1450 = (parity_1422 & parity_1437) | and_1449;
  // hls/stages/count_bits.hpp:24
  logic parity_1468;
  assign parity_1468 = ^{or_1465_s9_q, or_1461_s9_q, or_1457_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1472;
  assign or_1472 = (or_1400_s9_q & or_1404_s9_q) | (and_1396_s9_q & (or_1400_s9_q | or_1404_s9_q));
  logic or_1476;
  assign or_1476 = (or_1415_s9_q & or_1419_s9_q) | (or_1411_s9_q & (or_1415_s9_q | or_1419_s9_q));
  logic or_1480;
  assign or_1480 = (or_1430_s9_q & or_1434_s9_q) | (or_1426_s9_q & (or_1430_s9_q | or_1434_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1483;
  assign parity_1483 = ^{or_1480, or_1476, or_1472};
  logic parity_1486;
  assign parity_1486 = ^{or_1480, or_1476, or_1472, or_1465_s9_q, or_1461_s9_q, or_1457_s9_q, or_1450, or_1446, and_1442};
  // hls/stages/count_bits.hpp:25
  logic or_1498;
  assign or_1498 = (or_1461_s9_q & or_1465_s9_q) | (or_1457_s9_q & (or_1461_s9_q | or_1465_s9_q));
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1773;
  assign sum_1773 = sum_1769_s9_q + {sum_1772_s9_q, select_1770_s9_q};
  logic [9:0] sum_1774;
  assign sum_1774 = {difference_1766_s9_q, select_1764_s9_q} + sum_1773[11:2];
  // hls/stages/patches.hpp:521
  logic not_1792;
  assign not_1792 = ~equal_1791_s9_q;
  // hls/stages/patches.hpp:467
  logic not_1794;
  assign not_1794 = ~equal_1793_s9_q;
  logic and_1880;
  assign and_1880 = not_1792 & (or_1797_s9_q & not_1794);
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2759_s9_q} - {1'b0, select_2765_s9_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s9_q} + {1'b0, xor_2770_s9_q};
  // hls/stages/patches.hpp:126
  logic select_3036;
  assign select_3036 = row_starts_s9_q ? (and_1696_s9_q ? not_3034_s9_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:191
  logic [4:0] select_3106;
  assign select_3106 = or_3075_s9_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1409; read in stage 9, written in stage 16: 9 < 16 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_585_s9_q ? select_631_s9_q : right_s9_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s9_en & select_622_s9_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:794; read in stage 9, written in stage 20: 9 < 20 < 9 + DISTANCE.
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
  assign patches_right_0_re = s9_en & (not_1792 & (not_1794 & and_1800_s9_q));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:794; read in stage 9, written in stage 20: 9 < 20 < 9 + DISTANCE.
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
  assign patches_right_1_re = s9_en & (not_1792 & (not_1794 & and_1838_s9_q));
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:806; read in stage 9, written in stage 13: 9 < 13 < 9 + DISTANCE.
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
  assign patches_columns_above_re = s9_en & and_1880;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:826; read in stage 9, written in stage 24: 9 < 24 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_s9_q;
`ifndef SYNTHESIS
  logic patches_rows_re;
  assign patches_rows_re = s9_en & (equal_1791_s9_q & (less_1974_s9_q & or_1977_s9_q));
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_lower_q <= 1'b0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
    end else if (s9_en) begin
      patches_lower_q <= sample_pair_whole_s9_q ? select_3036 : patches_lower_q;
      patches_code_row_q <= select_3106;
      patches_column_q <= or_3075_s9_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3099_s9_q & (patches_column_q == 5'h1e);
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
  logic [6:0] last_s10_q;
  logic [3:0] age_s10_q;
  logic [2:0] slot_s10_q;
  logic ends_cell_s10_q;
  logic lower_half_s10_q;
  logic shift_first_s10_q;
  logic [11:0] registration_slope_s10_q;
  logic [4:0] patches_band_rows_number_s10_q;
  logic [4:0] patches_choosing_number_s10_q;
  logic patches_chooses_s10_q;
  logic [4:0] patches_choosing_band_s10_q;
  logic patches_lower_s10_q;
  logic patches_second_s10_q;
  logic [4:0] patches_code_row_s10_q;
  logic [4:0] patches_column_s10_q;
  logic [4:0] patches_step_s10_q;
  logic patches_read_searches_s10_q;
  logic done_s10_q;
  logic proven_s10_q;
  logic [3:0] select_514_s10_q;
  logic equal_515_s10_q;
  logic row_starts_s10_q;
  logic [8:0] select_519_s10_q;
  logic and_528_s10_q;
  logic equal_534_s10_q;
  logic [6:0] select_549_s10_q;
  logic [6:0] last_s10_2_q;
  logic and_553_s10_q;
  logic and_555_s10_q;
  logic equal_574_s10_q;
  logic equal_580_s10_q;
  logic so_s10_q;
  logic equal_584_s10_q;
  logic or_585_s10_q;
  logic less_588_s10_q;
  logic not_589_s10_q;
  logic equal_599_s10_q;
  logic and_613_s10_q;
  logic [6:0] x_s10_2_q;
  logic [61:0] best_left_rdata_s10_q;
  logic [6:0] select_631_s10_q;
  logic [6:0] right_s10_q;
  logic and_645_s10_q;
  logic and_648_s10_q;
  logic and_654_s10_q;
  logic and_656_s10_q;
  logic equal_689_s10_q;
  logic xor_848_s10_q;
  logic xor_943_s10_q;
  logic parity_988_s10_q;
  logic and_989_s10_q;
  logic and_991_s10_q;
  logic and_993_s10_q;
  logic and_995_s10_q;
  logic or_1000_s10_q;
  logic or_1004_s10_q;
  logic xor_1097_s10_q;
  logic xor_1192_s10_q;
  logic parity_1237_s10_q;
  logic and_1238_s10_q;
  logic and_1240_s10_q;
  logic and_1242_s10_q;
  logic and_1244_s10_q;
  logic or_1249_s10_q;
  logic or_1253_s10_q;
  logic xor_1346_s10_q;
  logic xor_1441_s10_q;
  logic parity_1486_s10_q;
  logic and_1487_s10_q;
  logic and_1489_s10_q;
  logic and_1491_s10_q;
  logic and_1493_s10_q;
  logic or_1498_s10_q;
  logic or_1502_s10_q;
  logic and_1572_s10_q;
  logic equal_1573_s10_q;
  logic or_1593_s10_q;
  logic and_1696_s10_q;
  logic less_1710_s10_q;
  logic [5:0] b_s10_q;
  logic [7:0] sum_1774_s10_q;
  logic equal_1791_s10_q;
  logic not_1792_s10_q;
  logic equal_1793_s10_q;
  logic not_1794_s10_q;
  logic equal_1795_s10_q;
  logic equal_1796_s10_q;
  logic or_1797_s10_q;
  logic not_1798_s10_q;
  logic [4:0] select_1826_s10_q;
  logic select_1832_s10_q;
  logic and_1859_s10_q;
  logic [3:0] select_1870_s10_q;
  logic and_1880_s10_q;
  logic less_1974_s10_q;
  logic equal_1975_s10_q;
  logic or_1977_s10_q;
  logic sum_2001_s10_q;
  logic not_2012_s10_q;
  logic and_2026_s10_q;
  logic not_2066_s10_q;
  logic less_2144_s10_q;
  logic equal_2298_s10_q;
  logic equal_2486_s10_q;
  logic and_2592_s10_q;
  logic and_2623_s10_q;
  logic equal_2712_s10_q;
  logic [7:0] wide_s10_q;
  logic [8:0] size_3_s10_q;
  logic less_2796_s10_q;
  logic or_3075_s10_q;
  logic not_3099_s10_q;
  logic equal_3591_s10_q;
  logic less_3847_s10_q;
  logic equal_3919_s10_q;
  logic or_4077_s10_q;
  logic and_4091_s10_q;
  logic and_4108_s10_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      last_s10_q <= last_s9_q;
      age_s10_q <= age_s9_q;
      slot_s10_q <= slot_s9_q;
      ends_cell_s10_q <= ends_cell_s9_q;
      lower_half_s10_q <= lower_half_s9_q;
      shift_first_s10_q <= shift_first_s9_q;
      registration_slope_s10_q <= registration_slope_s9_q;
      patches_band_rows_number_s10_q <= patches_band_rows_number_s9_q;
      patches_choosing_number_s10_q <= patches_choosing_number_s9_q;
      patches_chooses_s10_q <= patches_chooses_s9_q;
      patches_choosing_band_s10_q <= patches_choosing_band_s9_q;
      patches_lower_s10_q <= patches_lower_q;
      patches_second_s10_q <= patches_second_s9_q;
      patches_code_row_s10_q <= patches_code_row_q;
      patches_column_s10_q <= patches_column_q;
      patches_step_s10_q <= patches_step_s9_q;
      patches_read_searches_s10_q <= patches_read_searches_s9_q;
      done_s10_q <= done_s9_q;
      proven_s10_q <= proven_s9_q;
      select_514_s10_q <= select_514_s9_q;
      equal_515_s10_q <= equal_515_s9_q;
      row_starts_s10_q <= row_starts_s9_q;
      select_519_s10_q <= select_519_s9_q;
      and_528_s10_q <= and_528_s9_q;
      equal_534_s10_q <= equal_534_s9_q;
      select_549_s10_q <= select_549_s9_q;
      last_s10_2_q <= last_s9_2_q;
      and_553_s10_q <= and_553_s9_q;
      and_555_s10_q <= and_555_s9_q;
      equal_574_s10_q <= equal_574_s9_q;
      equal_580_s10_q <= equal_580_s9_q;
      so_s10_q <= so_s9_q;
      equal_584_s10_q <= equal_584_s9_q;
      or_585_s10_q <= or_585_s9_q;
      less_588_s10_q <= less_588_s9_q;
      not_589_s10_q <= not_589_s9_q;
      equal_599_s10_q <= equal_599_s9_q;
      and_613_s10_q <= and_613_s9_q;
      x_s10_2_q <= x_s9_2_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_631_s10_q <= select_631_s9_q;
      right_s10_q <= right_s9_q;
      and_645_s10_q <= and_645_s9_q;
      and_648_s10_q <= and_648_s9_q;
      and_654_s10_q <= and_654_s9_q;
      and_656_s10_q <= and_656_s9_q;
      equal_689_s10_q <= equal_689_s9_q;
      xor_848_s10_q <= xor_848_s9_q;
      xor_943_s10_q <= parity_897_s9_q ^ parity_942;
      parity_988_s10_q <= parity_988;
      and_989_s10_q <= parity_970 & parity_985;
      and_991_s10_q <= (^{or_952, or_948, and_944}) & (parity_970 | parity_985);
      and_993_s10_q <= or_948 & or_952;
      and_995_s10_q <= and_944 & (or_948 | or_952);
      or_1000_s10_q <= or_1000;
      or_1004_s10_q <= (or_978 & or_982) | (or_974 & (or_978 | or_982));
      xor_1097_s10_q <= xor_1097_s9_q;
      xor_1192_s10_q <= parity_1146_s9_q ^ parity_1191;
      parity_1237_s10_q <= parity_1237;
      and_1238_s10_q <= parity_1219 & parity_1234;
      and_1240_s10_q <= (^{or_1201, or_1197, and_1193}) & (parity_1219 | parity_1234);
      and_1242_s10_q <= or_1197 & or_1201;
      and_1244_s10_q <= and_1193 & (or_1197 | or_1201);
      or_1249_s10_q <= or_1249;
      or_1253_s10_q <= (or_1227 & or_1231) | (or_1223 & (or_1227 | or_1231));
      xor_1346_s10_q <= xor_1346_s9_q;
      xor_1441_s10_q <= parity_1395_s9_q ^ parity_1440;
      parity_1486_s10_q <= parity_1486;
      and_1487_s10_q <= parity_1468 & parity_1483;
      and_1489_s10_q <= (^{or_1450, or_1446, and_1442}) & (parity_1468 | parity_1483);
      and_1491_s10_q <= or_1446 & or_1450;
      and_1493_s10_q <= and_1442 & (or_1446 | or_1450);
      or_1498_s10_q <= or_1498;
      or_1502_s10_q <= (or_1476 & or_1480) | (or_1472 & (or_1476 | or_1480));
      and_1572_s10_q <= and_1572_s9_q;
      equal_1573_s10_q <= equal_1573_s9_q;
      or_1593_s10_q <= or_1593_s9_q;
      and_1696_s10_q <= and_1696_s9_q;
      less_1710_s10_q <= less_1710_s9_q;
      b_s10_q <= b_s9_q;
      sum_1774_s10_q <= sum_1774[9:2];
      equal_1791_s10_q <= equal_1791_s9_q;
      not_1792_s10_q <= not_1792;
      equal_1793_s10_q <= equal_1793_s9_q;
      not_1794_s10_q <= not_1794;
      equal_1795_s10_q <= equal_1795_s9_q;
      equal_1796_s10_q <= equal_1796_s9_q;
      or_1797_s10_q <= or_1797_s9_q;
      not_1798_s10_q <= not_1798_s9_q;
      select_1826_s10_q <= select_1826_s9_q;
      select_1832_s10_q <= select_1832_s9_q;
      and_1859_s10_q <= not_1792 & (not_1794 & and_1857_s9_q);
      select_1870_s10_q <= select_1870_s9_q;
      and_1880_s10_q <= and_1880;
      less_1974_s10_q <= less_1974_s9_q;
      equal_1975_s10_q <= equal_1975_s9_q;
      or_1977_s10_q <= or_1977_s9_q;
      sum_2001_s10_q <= sum_2001_s9_q;
      not_2012_s10_q <= not_2012_s9_q;
      and_2026_s10_q <= and_2026_s9_q;
      not_2066_s10_q <= not_2066_s9_q;
      less_2144_s10_q <= less_2144_s9_q;
      equal_2298_s10_q <= equal_2298_s9_q;
      equal_2486_s10_q <= equal_2486_s9_q;
      and_2592_s10_q <= and_2592_s9_q;
      and_2623_s10_q <= and_2623_s9_q;
      equal_2712_s10_q <= equal_2712_s9_q;
      wide_s10_q <= wide;
      size_3_s10_q <= size_3;
      less_2796_s10_q <= less_2796_s9_q;
      or_3075_s10_q <= or_3075_s9_q;
      not_3099_s10_q <= not_3099_s9_q;
      equal_3591_s10_q <= equal_3591_s9_q;
      less_3847_s10_q <= less_3847_s9_q;
      equal_3919_s10_q <= equal_3919_s9_q;
      or_4077_s10_q <= or_4077_s9_q;
      and_4091_s10_q <= and_4091_s9_q;
      and_4108_s10_q <= and_4108_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:227
  logic inside_v;
  assign inside_v = or_585_s10_q & not_589_s10_q;
  // hls/stages/count_bits.hpp:25
  logic or_992;
  assign or_992 = and_989_s10_q | and_991_s10_q;
  logic or_996;
  assign or_996 = and_993_s10_q | and_995_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1009;
  assign parity_1009 = ^{or_1004_s10_q, or_1000_s10_q, or_996, or_992};
  // hls/stages/count_bits.hpp:25
  logic or_1013;
  assign or_1013 = (or_1000_s10_q & or_1004_s10_q) | (or_996 & (or_1000_s10_q | or_1004_s10_q));
  logic and_1014;
  assign and_1014 = or_992 & (^{or_1004_s10_q, or_1000_s10_q, or_996});
  // hls/stages/count_bits.hpp:24
  logic xor_1015;
  assign xor_1015 = or_1013 ^ and_1014;
  // hls/stages/count_bits.hpp:27
  logic and_1016;
  assign and_1016 = or_1013 & and_1014;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1017;
  assign select_1017 = equal_599_s10_q ? {and_1016, xor_1015, parity_1009, parity_988_s10_q, xor_943_s10_q, xor_848_s10_q} : 6'h0;
  logic [5:0] column;
  assign column = or_585_s10_q ? 6'h0 : select_1017;
  // hls/stages/count_bits.hpp:25
  logic or_1241;
  assign or_1241 = and_1238_s10_q | and_1240_s10_q;
  logic or_1245;
  assign or_1245 = and_1242_s10_q | and_1244_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1258;
  assign parity_1258 = ^{or_1253_s10_q, or_1249_s10_q, or_1245, or_1241};
  // hls/stages/count_bits.hpp:25
  logic or_1262;
  assign or_1262 = (or_1249_s10_q & or_1253_s10_q) | (or_1245 & (or_1249_s10_q | or_1253_s10_q));
  logic and_1263;
  assign and_1263 = or_1241 & (^{or_1253_s10_q, or_1249_s10_q, or_1245});
  // hls/stages/count_bits.hpp:24
  logic xor_1264;
  assign xor_1264 = or_1262 ^ and_1263;
  // hls/stages/count_bits.hpp:27
  logic and_1265;
  assign and_1265 = or_1262 & and_1263;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1266;
  assign select_1266 = equal_599_s10_q ? {and_1265, xor_1264, parity_1258, parity_1237_s10_q, xor_1192_s10_q, xor_1097_s10_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_585_s10_q ? 6'h0 : select_1266;
  // hls/stages/count_bits.hpp:25
  logic or_1490;
  assign or_1490 = and_1487_s10_q | and_1489_s10_q;
  logic or_1494;
  assign or_1494 = and_1491_s10_q | and_1493_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1507;
  assign parity_1507 = ^{or_1502_s10_q, or_1498_s10_q, or_1494, or_1490};
  // hls/stages/count_bits.hpp:25
  logic or_1511;
  assign or_1511 = (or_1498_s10_q & or_1502_s10_q) | (or_1494 & (or_1498_s10_q | or_1502_s10_q));
  logic and_1512;
  assign and_1512 = or_1490 & (^{or_1502_s10_q, or_1498_s10_q, or_1494});
  // hls/stages/count_bits.hpp:24
  logic xor_1513;
  assign xor_1513 = or_1511 ^ and_1512;
  // hls/stages/count_bits.hpp:27
  logic and_1514;
  assign and_1514 = or_1511 & and_1512;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1515;
  assign select_1515 = equal_599_s10_q ? {and_1514, xor_1513, parity_1507, parity_1486_s10_q, xor_1441_s10_q, xor_1346_s10_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_585_s10_q ? 6'h0 : select_1515;
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v_2;
  assign before_v_2 = age_s10_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_1551;
  assign sum_1551 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v_3;
  assign before_v_3 = age_s10_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_1554;
  assign sum_1554 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1775;
  assign sum_1775 = {registration_slope_s10_q[11], registration_slope_s10_q} + {{5{sum_1774_s10_q[7]}}, sum_1774_s10_q};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2773;
  assign select_2773 = ({wide_s10_q, 1'b0} < size_3_s10_q) ? {wide_s10_q, 1'b0} : size_3_s10_q;
  logic [8:0] taken;
  assign taken = ~select_2773;

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:795; read in stage 10, written in stage 20: 10 < 20 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s10_q, patches_code_row_s10_q[3:0], patches_column_s10_q[3:0]};
`ifndef SYNTHESIS
  logic patches_left_re;
  assign patches_left_re = s10_en & and_1859_s10_q;
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
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
    if (s10_en) begin
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
  logic [6:0] last_s11_q;
  logic [3:0] age_s11_q;
  logic [2:0] slot_s11_q;
  logic ends_cell_s11_q;
  logic lower_half_s11_q;
  logic shift_first_s11_q;
  logic [4:0] patches_band_rows_number_s11_q;
  logic [4:0] patches_choosing_number_s11_q;
  logic patches_chooses_s11_q;
  logic [4:0] patches_choosing_band_s11_q;
  logic patches_lower_s11_q;
  logic patches_second_s11_q;
  logic [4:0] patches_code_row_s11_q;
  logic [4:0] patches_column_s11_q;
  logic [4:0] patches_step_s11_q;
  logic patches_read_searches_s11_q;
  logic done_s11_q;
  logic proven_s11_q;
  logic [3:0] select_514_s11_q;
  logic equal_515_s11_q;
  logic row_starts_s11_q;
  logic [8:0] select_519_s11_q;
  logic and_528_s11_q;
  logic equal_534_s11_q;
  logic [6:0] select_549_s11_q;
  logic [6:0] last_s11_2_q;
  logic and_553_s11_q;
  logic and_555_s11_q;
  logic equal_574_s11_q;
  logic equal_580_s11_q;
  logic so_s11_q;
  logic equal_584_s11_q;
  logic or_585_s11_q;
  logic less_588_s11_q;
  logic not_589_s11_q;
  logic inside_v_s11_q;
  logic and_613_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic [6:0] select_631_s11_q;
  logic [6:0] right_s11_q;
  logic [28:0] best_right_rdata_s11_q;
  logic and_645_s11_q;
  logic and_648_s11_q;
  logic and_654_s11_q;
  logic and_656_s11_q;
  logic equal_689_s11_q;
  logic [5:0] column_s11_q;
  logic [5:0] select_1268_s11_q;
  logic [5:0] select_1517_s11_q;
  logic [6:0] sum_1552_s11_q;
  logic [6:0] sum_1555_s11_q;
  logic and_1572_s11_q;
  logic equal_1573_s11_q;
  logic or_1593_s11_q;
  logic and_1696_s11_q;
  logic less_1710_s11_q;
  logic [5:0] b_s11_q;
  logic [7:0] sum_1775_s11_q;
  logic less_1776_s11_q;
  logic less_1777_s11_q;
  logic equal_1791_s11_q;
  logic not_1792_s11_q;
  logic equal_1793_s11_q;
  logic not_1794_s11_q;
  logic equal_1795_s11_q;
  logic equal_1796_s11_q;
  logic or_1797_s11_q;
  logic not_1798_s11_q;
  logic [7:0] patches_right_0_rdata_s11_q;
  logic [4:0] select_1826_s11_q;
  logic select_1832_s11_q;
  logic [7:0] patches_right_1_rdata_s11_q;
  logic [3:0] select_1870_s11_q;
  logic and_1880_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic less_1974_s11_q;
  logic equal_1975_s11_q;
  logic or_1977_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_2001_s11_q;
  logic not_2012_s11_q;
  logic and_2026_s11_q;
  logic not_2066_s11_q;
  logic less_2144_s11_q;
  logic equal_2298_s11_q;
  logic equal_2486_s11_q;
  logic and_2592_s11_q;
  logic and_2623_s11_q;
  logic equal_2712_s11_q;
  logic less_2757_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] taken_s11_q;
  logic [7:0] not_2775_s11_q;
  logic less_2796_s11_q;
  logic or_3075_s11_q;
  logic not_3099_s11_q;
  logic equal_3591_s11_q;
  logic less_3847_s11_q;
  logic equal_3919_s11_q;
  logic or_4077_s11_q;
  logic and_4091_s11_q;
  logic and_4108_s11_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      last_s11_q <= last_s10_q;
      age_s11_q <= age_s10_q;
      slot_s11_q <= slot_s10_q;
      ends_cell_s11_q <= ends_cell_s10_q;
      lower_half_s11_q <= lower_half_s10_q;
      shift_first_s11_q <= shift_first_s10_q;
      patches_band_rows_number_s11_q <= patches_band_rows_number_s10_q;
      patches_choosing_number_s11_q <= patches_choosing_number_s10_q;
      patches_chooses_s11_q <= patches_chooses_s10_q;
      patches_choosing_band_s11_q <= patches_choosing_band_s10_q;
      patches_lower_s11_q <= patches_lower_s10_q;
      patches_second_s11_q <= patches_second_s10_q;
      patches_code_row_s11_q <= patches_code_row_s10_q;
      patches_column_s11_q <= patches_column_s10_q;
      patches_step_s11_q <= patches_step_s10_q;
      patches_read_searches_s11_q <= patches_read_searches_s10_q;
      done_s11_q <= done_s10_q;
      proven_s11_q <= proven_s10_q;
      select_514_s11_q <= select_514_s10_q;
      equal_515_s11_q <= equal_515_s10_q;
      row_starts_s11_q <= row_starts_s10_q;
      select_519_s11_q <= select_519_s10_q;
      and_528_s11_q <= and_528_s10_q;
      equal_534_s11_q <= equal_534_s10_q;
      select_549_s11_q <= select_549_s10_q;
      last_s11_2_q <= last_s10_2_q;
      and_553_s11_q <= and_553_s10_q;
      and_555_s11_q <= and_555_s10_q;
      equal_574_s11_q <= equal_574_s10_q;
      equal_580_s11_q <= equal_580_s10_q;
      so_s11_q <= so_s10_q;
      equal_584_s11_q <= equal_584_s10_q;
      or_585_s11_q <= or_585_s10_q;
      less_588_s11_q <= less_588_s10_q;
      not_589_s11_q <= not_589_s10_q;
      inside_v_s11_q <= inside_v;
      and_613_s11_q <= and_613_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_631_s11_q <= select_631_s10_q;
      right_s11_q <= right_s10_q;
      best_right_rdata_s11_q <= best_right_rdata_q;
      and_645_s11_q <= and_645_s10_q;
      and_648_s11_q <= and_648_s10_q;
      and_654_s11_q <= and_654_s10_q;
      and_656_s11_q <= and_656_s10_q;
      equal_689_s11_q <= equal_689_s10_q;
      column_s11_q <= column;
      select_1268_s11_q <= age_s10_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1517_s11_q <= age_s10_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1552_s11_q <= {1'b0, before_v_2} + sum_1551;
      sum_1555_s11_q <= {1'b0, before_v_3} + sum_1554;
      and_1572_s11_q <= and_1572_s10_q;
      equal_1573_s11_q <= equal_1573_s10_q;
      or_1593_s11_q <= or_1593_s10_q;
      and_1696_s11_q <= and_1696_s10_q;
      less_1710_s11_q <= less_1710_s10_q;
      b_s11_q <= b_s10_q;
      sum_1775_s11_q <= sum_1775[7:0];
      less_1776_s11_q <= $signed(6'h0) < $signed(sum_1775[12:7]);
      less_1777_s11_q <= $signed(sum_1775[12:7]) < $signed(6'h3f);
      equal_1791_s11_q <= equal_1791_s10_q;
      not_1792_s11_q <= not_1792_s10_q;
      equal_1793_s11_q <= equal_1793_s10_q;
      not_1794_s11_q <= not_1794_s10_q;
      equal_1795_s11_q <= equal_1795_s10_q;
      equal_1796_s11_q <= equal_1796_s10_q;
      or_1797_s11_q <= or_1797_s10_q;
      not_1798_s11_q <= not_1798_s10_q;
      patches_right_0_rdata_s11_q <= patches_right_0_rdata_q;
      select_1826_s11_q <= select_1826_s10_q;
      select_1832_s11_q <= select_1832_s10_q;
      patches_right_1_rdata_s11_q <= patches_right_1_rdata_q;
      select_1870_s11_q <= select_1870_s10_q;
      and_1880_s11_q <= and_1880_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_q;
      less_1974_s11_q <= less_1974_s10_q;
      equal_1975_s11_q <= equal_1975_s10_q;
      or_1977_s11_q <= or_1977_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_2001_s11_q <= sum_2001_s10_q;
      not_2012_s11_q <= not_2012_s10_q;
      and_2026_s11_q <= and_2026_s10_q;
      not_2066_s11_q <= not_2066_s10_q;
      less_2144_s11_q <= less_2144_s10_q;
      equal_2298_s11_q <= equal_2298_s10_q;
      equal_2486_s11_q <= equal_2486_s10_q;
      and_2592_s11_q <= and_2592_s10_q;
      and_2623_s11_q <= and_2623_s10_q;
      equal_2712_s11_q <= equal_2712_s10_q;
      less_2757_s11_q <= slot_s10_q < 3'h3;
      wide_s11_q <= wide_s10_q;
      taken_s11_q <= taken;
      not_2775_s11_q <= ~wide_s10_q;
      less_2796_s11_q <= less_2796_s10_q;
      or_3075_s11_q <= or_3075_s10_q;
      not_3099_s11_q <= not_3099_s10_q;
      equal_3591_s11_q <= equal_3591_s10_q;
      less_3847_s11_q <= less_3847_s10_q;
      equal_3919_s11_q <= equal_3919_s10_q;
      or_4077_s11_q <= or_4077_s10_q;
      and_4091_s11_q <= and_4091_s10_q;
      and_4108_s11_q <= and_4108_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  logic [13:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
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
  // hls/stages/agreement.hpp:1108
  logic equal_575;
  assign equal_575 = x_s11_q == 8'h0;
  // hls/stages/agreement.hpp:260
  logic first;
  assign first = equal_574_s11_q & equal_575;
  // hls/stages/moments.hpp:68
  logic [13:0] select_578;
  assign select_578 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:1023
  logic not_581;
  assign not_581 = ~equal_580_s11_q;
  // hls/stages/agreement.hpp:202
  logic not_583;
  assign not_583 = ~so_s11_q;
  // hls/stages/agreement.hpp:990
  logic [6:0] chosen;
  assign chosen = slot_s11_q[2] ? best_right_rdata_s11_q[14:8] : best_right_rdata_s11_q[28:22];
  // hls/stages/agreement.hpp:818
  logic or_770;
  assign or_770 = shift_first_s11_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1019;
  assign select_1019 = age_s11_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v;
  assign before_v = age_s11_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_1547;
  assign sum_1547 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:762
  logic [6:0] select_1557;
  assign select_1557 = (sum_1552_s11_q < sum_1555_s11_q) ? sum_1555_s11_q : sum_1552_s11_q;
  // hls/stages/agreement.hpp:799
  logic and_1583;
  assign and_1583 = ends_cell_s11_q & inside_v_s11_q;
  logic and_1585;
  assign and_1585 = not_581 & (so_s11_q & and_1583);
  // hls/stages/registration.hpp:83
  logic equal_1711;
  assign equal_1711 = slot_s11_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1714;
  assign select_1714 = b_s11_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1715;
  assign select_1715 = b_s11_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1716;
  assign sum_1716 = {{2{select_1714[6]}}, select_1714} + {select_1715[7], select_1715};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1717;
  assign select_1717 = b_s11_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1718;
  assign select_1718 = b_s11_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1719;
  assign sum_1719 = {{2{select_1717[7]}}, select_1717[7:1]} + {select_1718[7], select_1718};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1721;
  assign select_1721 = b_s11_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1722;
  assign select_1722 = b_s11_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1723;
  assign difference_1723 = {{2{select_1721[7]}}, select_1721[7:1]} - {select_1722[7], select_1722};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1779;
  assign select_1779 = less_1776_s11_q ? 8'h7f : (less_1777_s11_q ? 8'h80 : sum_1775_s11_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1711 ? registration_slope_here_q : select_1779;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_1783;
  assign select_1783 = equal_580_s11_q ? 8'h0 : (so_s11_q ? (ends_cell_s11_q ? slope : 8'h0) : 8'h0);
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_1796_s11_q ? (patches_second_s11_q ? 8'h0 : patches_right_0_rdata_s11_q) : 8'h0;
  // hls/stages/patches.hpp:476
  logic [8:0] sum_1927;
  assign sum_1927 = {1'b0, patches_columns_above_rdata_s11_q[23:16]} + {3'h0, patches_columns_above_rdata_s11_q[31:26]};
  // hls/stages/agreement.hpp:799
  logic and_2349;
  assign and_2349 = not_581 & (not_583 & (equal_584_s11_q & (inside_v_s11_q & first)));
  // hls/stages/agreement.hpp:240
  logic [5:0] select_2596;
  assign select_2596 = slot_s11_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2597;
  assign select_2597 = slot_s11_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2598;
  assign select_2598 = slot_s11_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2599;
  assign select_2599 = slot_s11_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2600;
  assign select_2600 = slot_s11_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2601;
  assign select_2601 = slot_s11_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:997
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s11_q[61:54]} - {1'b0, best_left_rdata_s11_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2768;
  assign not_2768 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2757_s11_q ? {1'b0, wide_s11_q, 1'b0} : {registration_displacement_over_q[8:0], not_2768};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2776;
  assign select_2776 = registration_displacement_over_q[9] ? wide_s11_q : not_2775_s11_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2757_s11_q ? {taken_s11_q, 1'b1} : {not_2768, select_2776, not_2768};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2778;
  assign sum_2778 = {left, 1'b1} + {taken_2, less_2757_s11_q};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_2780;
  assign select_2780 = so_s11_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_2782;
  assign select_2782 = equal_580_s11_q ? registration_slope_here_q : (so_s11_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:150
  logic [2:0] select_2791;
  assign select_2791 = or_585_s11_q ? (less_588_s11_q ? 3'h0 : best_left_rdata_s11_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:564
  logic [9:0] select_3542;
  assign select_3542 = less_1974_s11_q ? (or_1977_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3545;
  assign select_3545 = less_1974_s11_q ? (or_1977_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0) : 5'h0;

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1440; read in stage 11, written in stage 15: 11 < 15 < 11 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s11_q[6:0];
`ifndef SYNTHESIS
  logic seen_columns_re;
  assign seen_columns_re = s11_en & and_1585;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_place_q <= 14'h0;
      moments_taken_q <= 1'b0;
      moments_starts_q <= 1'b0;
      shift_not_right_q <= 1'b0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
    end else if (s11_en) begin
      moments_place_q <= select_578;
      moments_taken_q <= not_581 & (not_583 & (equal_584_s11_q & inside_v_s11_q));
      moments_starts_q <= and_2349;
      shift_not_right_q <= $signed(run_shift_s11_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s11_q ? sum_2778[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2780;
      registration_slope_here_q <= select_2782;
      patches_read_row_differing_q <= equal_1791_s11_q ? select_3542 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1791_s11_q ? select_3545 : patches_read_row_column_q;
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
    if (s11_en) begin
      middle_sum_columns_values_0_q <= slot_s11_q[0] ? middle_sum_columns_values_0_q : column_s11_q;
      middle_sum_columns_values_1_q <= select_2596;
      middle_sum_columns_values_2_q <= select_2597;
      middle_sum_columns_values_3_q <= select_2598;
      middle_sum_columns_values_4_q <= select_2599;
      middle_sum_columns_values_5_q <= select_2600;
      middle_sum_columns_values_6_q <= select_2601;
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
  logic moments_starts_s12_q;
  logic [5:0] run_shift_s12_q;
  logic [7:0] x_s12_q;
  logic [6:0] last_s12_q;
  logic [1:0] age_s12_q;
  logic [2:0] slot_s12_q;
  logic ends_cell_s12_q;
  logic lower_half_s12_q;
  logic shift_not_right_s12_q;
  logic [4:0] patches_band_rows_number_s12_q;
  logic [4:0] patches_choosing_number_s12_q;
  logic patches_chooses_s12_q;
  logic [4:0] patches_choosing_band_s12_q;
  logic patches_lower_s12_q;
  logic patches_second_s12_q;
  logic [4:0] patches_code_row_s12_q;
  logic [4:0] patches_column_s12_q;
  logic [4:0] patches_step_s12_q;
  logic [9:0] patches_read_row_differing_s12_q;
  logic [4:0] patches_read_row_column_s12_q;
  logic patches_read_searches_s12_q;
  logic done_s12_q;
  logic proven_s12_q;
  logic [3:0] select_514_s12_q;
  logic equal_515_s12_q;
  logic row_starts_s12_q;
  logic [8:0] select_519_s12_q;
  logic and_528_s12_q;
  logic equal_534_s12_q;
  logic [6:0] select_549_s12_q;
  logic [6:0] last_s12_2_q;
  logic and_553_s12_q;
  logic and_555_s12_q;
  logic equal_575_s12_q;
  logic first_s12_q;
  logic equal_580_s12_q;
  logic not_581_s12_q;
  logic so_s12_q;
  logic not_583_s12_q;
  logic equal_584_s12_q;
  logic or_585_s12_q;
  logic less_588_s12_q;
  logic not_589_s12_q;
  logic inside_v_s12_q;
  logic and_613_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic less_624_s12_q;
  logic [6:0] select_631_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic [6:0] chosen_s12_q;
  logic and_645_s12_q;
  logic and_648_s12_q;
  logic and_654_s12_q;
  logic and_656_s12_q;
  logic equal_689_s12_q;
  logic select_772_s12_q;
  logic [6:0] difference_1020_s12_q;
  logic [6:0] difference_1269_s12_q;
  logic equal_1270_s12_q;
  logic [6:0] difference_1518_s12_q;
  logic [6:0] sum_1548_s12_q;
  logic [6:0] select_1557_s12_q;
  logic and_1572_s12_q;
  logic select_1574_s12_q;
  logic and_1583_s12_q;
  logic and_1585_s12_q;
  logic or_1593_s12_q;
  logic and_1602_s12_q;
  logic and_1696_s12_q;
  logic less_1710_s12_q;
  logic equal_1711_s12_q;
  logic [5:0] b_s12_q;
  logic [7:0] sum_1716_s12_q;
  logic select_1717_s12_q;
  logic [8:0] sum_1719_s12_q;
  logic select_1721_s12_q;
  logic [8:0] difference_1723_s12_q;
  logic [7:0] select_1783_s12_q;
  logic equal_1791_s12_q;
  logic not_1792_s12_q;
  logic equal_1793_s12_q;
  logic not_1794_s12_q;
  logic equal_1795_s12_q;
  logic equal_1796_s12_q;
  logic or_1797_s12_q;
  logic not_1798_s12_q;
  logic [4:0] select_1826_s12_q;
  logic select_1832_s12_q;
  logic [7:0] patches_left_rdata_s12_q;
  logic [3:0] select_1870_s12_q;
  logic and_1880_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] select_1884_s12_q;
  logic [8:0] sum_1927_s12_q;
  logic less_1974_s12_q;
  logic equal_1975_s12_q;
  logic or_1977_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_2001_s12_q;
  logic not_2012_s12_q;
  logic and_2026_s12_q;
  logic not_2066_s12_q;
  logic less_2144_s12_q;
  logic equal_2298_s12_q;
  logic equal_2486_s12_q;
  logic and_2592_s12_q;
  logic and_2623_s12_q;
  logic equal_2712_s12_q;
  logic rise_s12_q;
  logic [7:0] xor_2717_s12_q;
  logic select_2791_s12_q;
  logic or_2794_s12_q;
  logic [1:0] sum_2795_s12_q;
  logic less_2796_s12_q;
  logic or_3075_s12_q;
  logic not_3099_s12_q;
  logic equal_3591_s12_q;
  logic less_3847_s12_q;
  logic equal_3919_s12_q;
  logic or_4077_s12_q;
  logic and_4091_s12_q;
  logic and_4108_s12_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s12_q <= pixel_0_s11_q;
      pixel_1_s12_q <= pixel_1_s11_q;
      saturated_s12_q <= saturated_s11_q;
      mask_s12_q <= mask_s11_q;
      marks_first_s12_q <= marks_first_s11_q;
      marks_last_s12_q <= marks_last_s11_q;
      sample_pair_whole_s12_q <= sample_pair_whole_s11_q;
      sample_present_s12_q <= sample_present_s11_q;
      moments_starts_s12_q <= moments_starts_q;
      run_shift_s12_q <= run_shift_s11_q;
      x_s12_q <= x_s11_q;
      last_s12_q <= last_s11_q;
      age_s12_q <= {age_s11_q[2], age_s11_q[0]};
      slot_s12_q <= slot_s11_q;
      ends_cell_s12_q <= ends_cell_s11_q;
      lower_half_s12_q <= lower_half_s11_q;
      shift_not_right_s12_q <= shift_not_right_q;
      patches_band_rows_number_s12_q <= patches_band_rows_number_s11_q;
      patches_choosing_number_s12_q <= patches_choosing_number_s11_q;
      patches_chooses_s12_q <= patches_chooses_s11_q;
      patches_choosing_band_s12_q <= patches_choosing_band_s11_q;
      patches_lower_s12_q <= patches_lower_s11_q;
      patches_second_s12_q <= patches_second_s11_q;
      patches_code_row_s12_q <= patches_code_row_s11_q;
      patches_column_s12_q <= patches_column_s11_q;
      patches_step_s12_q <= patches_step_s11_q;
      patches_read_row_differing_s12_q <= patches_read_row_differing_q;
      patches_read_row_column_s12_q <= patches_read_row_column_q;
      patches_read_searches_s12_q <= patches_read_searches_s11_q;
      done_s12_q <= done_s11_q;
      proven_s12_q <= proven_s11_q;
      select_514_s12_q <= select_514_s11_q;
      equal_515_s12_q <= equal_515_s11_q;
      row_starts_s12_q <= row_starts_s11_q;
      select_519_s12_q <= select_519_s11_q;
      and_528_s12_q <= and_528_s11_q;
      equal_534_s12_q <= equal_534_s11_q;
      select_549_s12_q <= select_549_s11_q;
      last_s12_2_q <= last_s11_2_q;
      and_553_s12_q <= and_553_s11_q;
      and_555_s12_q <= and_555_s11_q;
      equal_575_s12_q <= equal_575;
      first_s12_q <= first;
      equal_580_s12_q <= equal_580_s11_q;
      not_581_s12_q <= not_581;
      so_s12_q <= so_s11_q;
      not_583_s12_q <= not_583;
      equal_584_s12_q <= equal_584_s11_q;
      or_585_s12_q <= or_585_s11_q;
      less_588_s12_q <= less_588_s11_q;
      not_589_s12_q <= not_589_s11_q;
      inside_v_s12_q <= inside_v_s11_q;
      and_613_s12_q <= and_613_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      less_624_s12_q <= 8'hb6 < best_left_rdata_s11_q[16:9];
      select_631_s12_q <= select_631_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_s11_q;
      chosen_s12_q <= chosen;
      and_645_s12_q <= and_645_s11_q;
      and_648_s12_q <= and_648_s11_q;
      and_654_s12_q <= and_654_s11_q;
      and_656_s12_q <= and_656_s11_q;
      equal_689_s12_q <= equal_689_s11_q;
      select_772_s12_q <= or_770 ? shift_first_s11_q : (~age_s11_q[1]);
      difference_1020_s12_q <= {1'b0, column_s11_q} - {1'b0, select_1019};
      difference_1269_s12_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1268_s11_q};
      equal_1270_s12_q <= {age_s11_q[0], slot_s11_q[0]} == 2'h0;
      difference_1518_s12_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1517_s11_q};
      sum_1548_s12_q <= {1'b0, before_v} + sum_1547;
      select_1557_s12_q <= select_1557;
      and_1572_s12_q <= and_1572_s11_q;
      select_1574_s12_q <= or_770 ? shift_first_s11_q : equal_1573_s11_q;
      and_1583_s12_q <= and_1583;
      and_1585_s12_q <= and_1585;
      or_1593_s12_q <= or_1593_s11_q;
      and_1602_s12_q <= or_585_s11_q & (slot_s11_q[2] & not_589_s11_q);
      and_1696_s12_q <= and_1696_s11_q;
      less_1710_s12_q <= less_1710_s11_q;
      equal_1711_s12_q <= equal_1711;
      b_s12_q <= b_s11_q;
      sum_1716_s12_q <= sum_1716[8:1];
      select_1717_s12_q <= select_1717[0];
      sum_1719_s12_q <= sum_1719;
      select_1721_s12_q <= select_1721[0];
      difference_1723_s12_q <= difference_1723;
      select_1783_s12_q <= select_1783;
      equal_1791_s12_q <= equal_1791_s11_q;
      not_1792_s12_q <= not_1792_s11_q;
      equal_1793_s12_q <= equal_1793_s11_q;
      not_1794_s12_q <= not_1794_s11_q;
      equal_1795_s12_q <= equal_1795_s11_q;
      equal_1796_s12_q <= equal_1796_s11_q;
      or_1797_s12_q <= or_1797_s11_q;
      not_1798_s12_q <= not_1798_s11_q;
      select_1826_s12_q <= select_1826_s11_q;
      select_1832_s12_q <= select_1832_s11_q;
      patches_left_rdata_s12_q <= patches_left_rdata_q;
      select_1870_s12_q <= select_1870_s11_q;
      and_1880_s12_q <= and_1880_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      select_1884_s12_q <= patches_second_s11_q ? patches_right_1_rdata_s11_q : pixel;
      sum_1927_s12_q <= sum_1927;
      less_1974_s12_q <= less_1974_s11_q;
      equal_1975_s12_q <= equal_1975_s11_q;
      or_1977_s12_q <= or_1977_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_2001_s12_q <= sum_2001_s11_q;
      not_2012_s12_q <= not_2012_s11_q;
      and_2026_s12_q <= and_2026_s11_q;
      not_2066_s12_q <= not_2066_s11_q;
      less_2144_s12_q <= less_2144_s11_q;
      equal_2298_s12_q <= equal_2298_s11_q;
      equal_2486_s12_q <= equal_2486_s11_q;
      and_2592_s12_q <= and_2592_s11_q;
      and_2623_s12_q <= and_2623_s11_q;
      equal_2712_s12_q <= equal_2712_s11_q;
      rise_s12_q <= rise[8];
      xor_2717_s12_q <= rise[7:0] ^ {8{rise[8]}};
      select_2791_s12_q <= select_2791[0];
      or_2794_s12_q <= (select_2791 == 3'h0) | (select_2791 == 3'h4);
      sum_2795_s12_q <= select_2791[2:1] + 2'h3;
      less_2796_s12_q <= less_2796_s11_q;
      or_3075_s12_q <= or_3075_s11_q;
      not_3099_s12_q <= not_3099_s11_q;
      equal_3591_s12_q <= equal_3591_s11_q;
      less_3847_s12_q <= less_3847_s11_q;
      equal_3919_s12_q <= equal_3919_s11_q;
      or_4077_s12_q <= or_4077_s11_q;
      and_4091_s12_q <= and_4091_s11_q;
      and_4108_s12_q <= and_4108_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [6:0] chosen_near_q;
  logic patches_read_first_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  logic [4:0] patches_bands_chosen_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  // hls/stages/census.hpp:127
  logic and_529;
  assign and_529 = sample_pair_whole_s12_q & and_528_s12_q;
  // hls/stages/moments.hpp:74
  logic [10:0] place;
  assign place = first_s12_q ? 11'h0 : moments_place_q[13:3];
  // hls/stages/moments.hpp:131
  logic not_593;
  assign not_593 = ~(11'h3ec < place);
  // hls/stages/agreement.hpp:989
  logic select_626;
  assign select_626 = slot_s12_q[2] ? less_624_s12_q : (6'h2a < best_left_rdata_s12_q[39:34]);
  // hls/stages/agreement.hpp:1003
  logic [8:0] difference_636;
  assign difference_636 = {2'h0, chosen_s12_q} - {1'b0, x_s12_q};
  // hls/stages/agreement.hpp:789
  logic [7:0] sum_1022;
  assign sum_1022 = {difference_1020_s12_q[6], difference_1020_s12_q} + (age_s12_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1272;
  assign sum_1272 = {difference_1269_s12_q[6], difference_1269_s12_q} + (equal_1270_s12_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1520;
  assign sum_1520 = {difference_1518_s12_q[6], difference_1518_s12_q} + (equal_1270_s12_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:766
  logic [6:0] select_1549;
  assign select_1549 = slot_s12_q[0] ? chosen_near_q : sum_1548_s12_q;
  // hls/stages/agreement.hpp:762
  logic [6:0] select_1559;
  assign select_1559 = (select_1549 < select_1557_s12_q) ? select_1557_s12_q : select_1549;
  // hls/stages/agreement.hpp:799
  logic [6:0] select_1589;
  assign select_1589 = so_s12_q ? x_s12_q[6:0] : (or_585_s12_q ? (less_588_s12_q ? 7'h0 : select_631_s12_q) : 7'h0);
  // hls/stages/agreement.hpp:1032
  logic [6:0] sum_1705;
  assign sum_1705 = x_s12_q[7:1] + 7'h7f;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s12_q[6:1]} < {sum_1705, x_s12_q[0]};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1720;
  assign sum_1720 = {{3{sum_1716_s12_q[7]}}, sum_1716_s12_q} + {sum_1719_s12_q[8], sum_1719_s12_q, select_1717_s12_q};
  logic [9:0] sum_1724;
  assign sum_1724 = {difference_1723_s12_q, select_1721_s12_q} + {sum_1720[10], sum_1720[10:2]};
  // hls/stages/agreement.hpp:1159
  logic equal_1808;
  assign equal_1808 = x_s12_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:153
  logic [4:0] select_1809;
  assign select_1809 = equal_1808 ? patches_choosing_number_s12_q : patches_bands_chosen_q;
  // hls/stages/patches.hpp:174
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1796_s12_q ? select_1884_s12_q : patches_left_rdata_s12_q;
  // hls/stages/patches.hpp:476
  logic [9:0] sum_1928;
  assign sum_1928 = {2'h0, patches_columns_above_rdata_s12_q[15:8]} + {1'b0, sum_1927_s12_q};
  // hls/stages/agreement.hpp:240
  logic [6:0] select_2608;
  assign select_2608 = slot_s12_q[0] ? 7'h0 : sum_1548_s12_q;
  // hls/stages/agreement.hpp:762
  logic [6:0] select_2610;
  assign select_2610 = (select_2608 < select_1557_s12_q) ? select_1557_s12_q : select_2608;
  // hls/stages/agreement.hpp:998
  logic [7:0] lower;
  assign lower = rise_s12_q ? best_left_rdata_s12_q[61:54] : best_left_rdata_s12_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2797;
  assign difference_2797 = {sum_2795_s12_q, select_2791_s12_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2798;
  assign select_2798 = less_2796_s12_q ? difference_2797 : {sum_2795_s12_q, select_2791_s12_q, registration_displacement_fraction_q};
  logic [7:0] select_2799;
  assign select_2799 = or_2794_s12_q ? {sum_2795_s12_q, select_2791_s12_q, 5'h0} : select_2798;
  // hls/stages/agreement.hpp:276
  logic select_3553;
  assign select_3553 = equal_1791_s12_q ? (less_1974_s12_q & (or_1977_s12_q & (patches_step_s12_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3558;
  assign or_3558 = patches_read_first_q | (patches_read_row_differing_s12_q < patches_peak_best_differing_q);
  logic and_3559;
  assign and_3559 = patches_read_searches_s12_q & or_3558;
  // hls/stages/patches.hpp:547
  logic [14:0] select_3579;
  assign select_3579 = and_3559 ? {patches_read_row_column_s12_q, patches_read_row_differing_s12_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3580;
  assign select_3580 = equal_1791_s12_q ? select_3579[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3581;
  assign select_3581 = equal_1791_s12_q ? select_3579[14:10] : patches_peak_best_column_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3848;
  assign sum_3848 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3870;
  assign select_3870 = equal_689_s12_q ? {difference_3869[7], difference_3869} : region_down_rest_q;
  logic [8:0] select_3872;
  assign select_3872 = equal_2486_s12_q ? (less_3847_s12_q ? region_down_next_q : select_3870) : region_down_rest_q;
  logic [7:0] select_3875;
  assign select_3875 = equal_689_s12_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  logic [7:0] select_3877;
  assign select_3877 = equal_2486_s12_q ? (less_3847_s12_q ? region_down_back_q : select_3875) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3880;
  assign select_3880 = sum_3848[7] ? {1'b1, sum_3848[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:238; read in stage 12, written in stage 15: 12 < 15 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_519_s12_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s12_en & and_529;
`endif
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1410; read in stage 12, written in stage 15: 12 < 15 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s12_q[6:0];
`ifndef SYNTHESIS
  logic shown_right_re;
  assign shown_right_re = s12_en & and_1585_s12_q;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1411; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] left_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_turns_mem[i] = 2'h0;
`endif
  logic [6:0] left_turns_raddr;
  assign left_turns_raddr = x_s12_q[6:0];
`ifndef SYNTHESIS
  logic left_turns_re;
  assign left_turns_re = s12_en & and_1602_s12_q;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1411; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_631_s12_q;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s12_en & and_1602_s12_q;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_near_q <= 7'h0;
      patches_read_first_q <= 1'b0;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
      patches_bands_chosen_q <= 5'h0;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
    end else if (s12_en) begin
      chosen_near_q <= select_2610;
      patches_read_first_q <= select_3553;
      patches_peak_best_differing_q <= select_3580;
      patches_peak_best_column_q <= select_3581;
      patches_bands_chosen_q <= equal_580_s12_q ? select_1809 : patches_bands_chosen_q;
      region_down_rest_q <= and_555_s12_q ? select_3872 : region_down_rest_q;
      region_down_back_q <= and_555_s12_q ? select_3877 : region_down_back_q;
      region_down_next_q <= select_3880;
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
    if (s12_en) begin
      middle_sum_sum_sums_values_0_q <= slot_s12_q[0] ? middle_sum_sum_sums_values_0_q : sum_1022;
      sums_0_sum_sums_values_0_q <= sum_1272;
      sums_0_sum_sums_values_1_q <= equal_1270_s12_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1520;
      sums_1_sum_sums_values_1_q <= equal_1270_s12_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic moments_starts_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic [6:0] last_s13_q;
  logic age_s13_q;
  logic [2:0] slot_s13_q;
  logic ends_cell_s13_q;
  logic lower_half_s13_q;
  logic shift_not_right_s13_q;
  logic [4:0] patches_band_rows_number_s13_q;
  logic patches_chooses_s13_q;
  logic [4:0] patches_choosing_band_s13_q;
  logic patches_lower_s13_q;
  logic patches_second_s13_q;
  logic [4:0] patches_code_row_s13_q;
  logic [4:0] patches_column_s13_q;
  logic [4:0] patches_step_s13_q;
  logic [9:0] patches_read_row_differing_s13_q;
  logic patches_read_first_s13_q;
  logic done_s13_q;
  logic proven_s13_q;
  logic [3:0] select_514_s13_q;
  logic equal_515_s13_q;
  logic row_starts_s13_q;
  logic [8:0] select_519_s13_q;
  logic and_528_s13_q;
  logic and_529_s13_q;
  logic equal_534_s13_q;
  logic [6:0] select_549_s13_q;
  logic [6:0] last_s13_2_q;
  logic and_553_s13_q;
  logic and_555_s13_q;
  logic equal_575_s13_q;
  logic [12:0] select_579_s13_q;
  logic equal_580_s13_q;
  logic not_581_s13_q;
  logic so_s13_q;
  logic not_583_s13_q;
  logic equal_584_s13_q;
  logic or_585_s13_q;
  logic less_588_s13_q;
  logic not_589_s13_q;
  logic inside_v_s13_q;
  logic not_593_s13_q;
  logic and_596_s13_q;
  logic and_613_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_626_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic [9:0] sum_637_s13_q;
  logic and_645_s13_q;
  logic and_648_s13_q;
  logic and_654_s13_q;
  logic and_656_s13_q;
  logic equal_689_s13_q;
  logic select_772_s13_q;
  logic [7:0] sum_1022_s13_q;
  logic less_1521_s13_q;
  logic [6:0] select_1559_s13_q;
  logic [7:0] select_1567_s13_q;
  logic [7:0] select_1570_s13_q;
  logic and_1572_s13_q;
  logic select_1574_s13_q;
  logic and_1583_s13_q;
  logic and_1585_s13_q;
  logic [6:0] select_1589_s13_q;
  logic or_1593_s13_q;
  logic and_1611_s13_q;
  logic and_1696_s13_q;
  logic [6:0] sum_1705_s13_q;
  logic right_3_s13_q;
  logic less_1710_s13_q;
  logic equal_1711_s13_q;
  logic [5:0] b_s13_q;
  logic sum_1720_s13_q;
  logic [9:0] sum_1724_s13_q;
  logic [7:0] select_1783_s13_q;
  logic equal_1791_s13_q;
  logic not_1792_s13_q;
  logic equal_1793_s13_q;
  logic not_1794_s13_q;
  logic equal_1795_s13_q;
  logic equal_1796_s13_q;
  logic or_1797_s13_q;
  logic not_1798_s13_q;
  logic equal_1808_s13_q;
  logic [4:0] select_1826_s13_q;
  logic select_1832_s13_q;
  logic [3:0] select_1870_s13_q;
  logic and_1880_s13_q;
  logic [31:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [9:0] sum_1928_s13_q;
  logic less_1974_s13_q;
  logic equal_1975_s13_q;
  logic or_1977_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_2001_s13_q;
  logic equal_2003_s13_q;
  logic not_2012_s13_q;
  logic and_2026_s13_q;
  logic [17:0] seen_columns_rdata_s13_q;
  logic not_2066_s13_q;
  logic less_2144_s13_q;
  logic equal_2298_s13_q;
  logic equal_2486_s13_q;
  logic and_2592_s13_q;
  logic and_2623_s13_q;
  logic equal_2712_s13_q;
  logic [7:0] lower_s13_q;
  logic [7:0] sum_2718_s13_q;
  logic [7:0] select_2799_s13_q;
  logic or_3075_s13_q;
  logic not_3099_s13_q;
  logic and_3559_s13_q;
  logic equal_3591_s13_q;
  logic less_3847_s13_q;
  logic sum_3848_s13_q;
  logic equal_3919_s13_q;
  logic or_4077_s13_q;
  logic and_4091_s13_q;
  logic and_4108_s13_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s13_q <= pixel_0_s12_q;
      pixel_1_s13_q <= pixel_1_s12_q;
      saturated_s13_q <= saturated_s12_q;
      mask_s13_q <= mask_s12_q;
      marks_first_s13_q <= marks_first_s12_q;
      marks_last_s13_q <= marks_last_s12_q;
      sample_pair_whole_s13_q <= sample_pair_whole_s12_q;
      sample_present_s13_q <= sample_present_s12_q;
      moments_starts_s13_q <= moments_starts_s12_q;
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      last_s13_q <= last_s12_q;
      age_s13_q <= age_s12_q[1];
      slot_s13_q <= slot_s12_q;
      ends_cell_s13_q <= ends_cell_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      shift_not_right_s13_q <= shift_not_right_s12_q;
      patches_band_rows_number_s13_q <= patches_band_rows_number_s12_q;
      patches_chooses_s13_q <= patches_chooses_s12_q;
      patches_choosing_band_s13_q <= patches_choosing_band_s12_q;
      patches_lower_s13_q <= patches_lower_s12_q;
      patches_second_s13_q <= patches_second_s12_q;
      patches_code_row_s13_q <= patches_code_row_s12_q;
      patches_column_s13_q <= patches_column_s12_q;
      patches_step_s13_q <= patches_step_s12_q;
      patches_read_row_differing_s13_q <= patches_read_row_differing_s12_q;
      patches_read_first_s13_q <= patches_read_first_q;
      done_s13_q <= done_s12_q;
      proven_s13_q <= proven_s12_q;
      select_514_s13_q <= select_514_s12_q;
      equal_515_s13_q <= equal_515_s12_q;
      row_starts_s13_q <= row_starts_s12_q;
      select_519_s13_q <= select_519_s12_q;
      and_528_s13_q <= and_528_s12_q;
      and_529_s13_q <= and_529;
      equal_534_s13_q <= equal_534_s12_q;
      select_549_s13_q <= select_549_s12_q;
      last_s13_2_q <= last_s12_2_q;
      and_553_s13_q <= and_553_s12_q;
      and_555_s13_q <= and_555_s12_q;
      equal_575_s13_q <= equal_575_s12_q;
      select_579_s13_q <= first_s12_q ? 13'h0 : moments_place_q[12:0];
      equal_580_s13_q <= equal_580_s12_q;
      not_581_s13_q <= not_581_s12_q;
      so_s13_q <= so_s12_q;
      not_583_s13_q <= not_583_s12_q;
      equal_584_s13_q <= equal_584_s12_q;
      or_585_s13_q <= or_585_s12_q;
      less_588_s13_q <= less_588_s12_q;
      not_589_s13_q <= not_589_s12_q;
      inside_v_s13_q <= inside_v_s12_q;
      not_593_s13_q <= not_593;
      and_596_s13_q <= not_583_s12_q & (equal_584_s12_q & (inside_v_s12_q & not_593));
      and_613_s13_q <= and_613_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q[45:0];
      select_626_s13_q <= select_626;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      sum_637_s13_q <= {difference_636[8], difference_636} + 10'h1;
      and_645_s13_q <= and_645_s12_q;
      and_648_s13_q <= and_648_s12_q;
      and_654_s13_q <= and_654_s12_q;
      and_656_s13_q <= and_656_s12_q;
      equal_689_s13_q <= equal_689_s12_q;
      select_772_s13_q <= select_772_s12_q;
      sum_1022_s13_q <= sum_1022;
      less_1521_s13_q <= sum_1272 < sum_1520;
      select_1559_s13_q <= select_1559;
      select_1567_s13_q <= select_772_s12_q ? 8'h0 : best_left_rdata_s12_q[53:46];
      select_1570_s13_q <= select_772_s12_q ? 8'h0 : best_left_rdata_s12_q[61:54];
      and_1572_s13_q <= and_1572_s12_q;
      select_1574_s13_q <= select_1574_s12_q;
      and_1583_s13_q <= and_1583_s12_q;
      and_1585_s13_q <= and_1585_s12_q;
      select_1589_s13_q <= select_1589;
      or_1593_s13_q <= or_1593_s12_q;
      and_1611_s13_q <= moments_taken_q;
      and_1696_s13_q <= and_1696_s12_q;
      sum_1705_s13_q <= sum_1705;
      right_3_s13_q <= right_3;
      less_1710_s13_q <= less_1710_s12_q;
      equal_1711_s13_q <= equal_1711_s12_q;
      b_s13_q <= b_s12_q;
      sum_1720_s13_q <= sum_1720[1];
      sum_1724_s13_q <= sum_1724;
      select_1783_s13_q <= select_1783_s12_q;
      equal_1791_s13_q <= equal_1791_s12_q;
      not_1792_s13_q <= not_1792_s12_q;
      equal_1793_s13_q <= equal_1793_s12_q;
      not_1794_s13_q <= not_1794_s12_q;
      equal_1795_s13_q <= equal_1795_s12_q;
      equal_1796_s13_q <= equal_1796_s12_q;
      or_1797_s13_q <= or_1797_s12_q;
      not_1798_s13_q <= not_1798_s12_q;
      equal_1808_s13_q <= equal_1808;
      select_1826_s13_q <= select_1826_s12_q;
      select_1832_s13_q <= select_1832_s12_q;
      select_1870_s13_q <= select_1870_s12_q;
      and_1880_s13_q <= and_1880_s12_q;
      patches_columns_above_rdata_s13_q <= patches_columns_above_rdata_s12_q;
      pixel_2_s13_q <= pixel_2;
      sum_1928_s13_q <= sum_1928;
      less_1974_s13_q <= less_1974_s12_q;
      equal_1975_s13_q <= equal_1975_s12_q;
      or_1977_s13_q <= or_1977_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_2001_s13_q <= sum_2001_s12_q;
      equal_2003_s13_q <= x_s12_q == {1'b0, last_s12_q};
      not_2012_s13_q <= not_2012_s12_q;
      and_2026_s13_q <= and_2026_s12_q;
      seen_columns_rdata_s13_q <= seen_columns_rdata_q;
      not_2066_s13_q <= not_2066_s12_q;
      less_2144_s13_q <= less_2144_s12_q;
      equal_2298_s13_q <= equal_2298_s12_q;
      equal_2486_s13_q <= equal_2486_s12_q;
      and_2592_s13_q <= and_2592_s12_q;
      and_2623_s13_q <= and_2623_s12_q;
      equal_2712_s13_q <= equal_2712_s12_q;
      lower_s13_q <= lower;
      sum_2718_s13_q <= {7'h0, rise_s12_q} + xor_2717_s12_q;
      select_2799_s13_q <= select_2799;
      or_3075_s13_q <= or_3075_s12_q;
      not_3099_s13_q <= not_3099_s12_q;
      and_3559_s13_q <= and_3559;
      equal_3591_s13_q <= equal_3591_s12_q;
      less_3847_s13_q <= less_3847_s12_q;
      sum_3848_s13_q <= sum_3848[7];
      equal_3919_s13_q <= equal_3919_s12_q;
      or_4077_s13_q <= or_4077_s12_q;
      and_4091_s13_q <= and_4091_s12_q;
      and_4108_s13_q <= and_4108_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic draws_late_q;
  logic [7:0] chosen_score_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  logic shift_allowed_q;
  logic [10:0] registration_expected_q;
  logic [15:0] patches_chance_q;
  logic [4:0] patches_band_q;
  logic [1:0] patches_fetch_q;
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic [4:0] patches_read_at_q;
  logic [4:0] patches_peak_row_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
  logic region_fresh_q;
  // hls/stages/census.hpp:117
  logic [13:0] select_532;
  assign select_532 = equal_515_s13_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_538;
  assign sum_538 = {6'h0, sample_pair_pixel_1_q} + (equal_515_s13_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:799
  logic and_597;
  assign and_597 = not_581_s13_q & and_596_s13_q;
  // hls/stages/agreement.hpp:248
  logic and_639;
  assign and_639 = (and_613_s13_q & select_626_s13_q) & ({{22{sum_637_s13_q[9]}}, sum_637_s13_q} < 32'h3);
  // hls/stages/agreement.hpp:766
  logic [7:0] select_1023;
  assign select_1023 = slot_s13_q[0] ? chosen_score_q : sum_1022_s13_q;
  // hls/stages/agreement.hpp:762
  logic [7:0] select_1522;
  assign select_1522 = less_1521_s13_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1523;
  assign less_1523 = select_1023 < select_1522;
  // hls/stages/agreement.hpp:812
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1523 ? select_1522 : select_1023) : 8'h0;
  // hls/stages/agreement.hpp:731
  logic not_1529;
  assign not_1529 = ~slot_s13_q[0];
  // hls/stages/agreement.hpp:763
  logic [1:0] select_1530;
  assign select_1530 = less_1521_s13_q ? {slot_s13_q[0], not_1529} : 2'h0;
  logic [2:0] select_1532;
  assign select_1532 = less_1523 ? {select_1530, not_1529} : (slot_s13_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:813
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1559_s13_q : 7'h0;
  // hls/stages/agreement.hpp:824
  logic less_1561;
  assign less_1561 = best_left_rdata_s13_q[39:33] < of_near;
  // hls/stages/agreement.hpp:1145
  logic equal_1618;
  assign equal_1618 = x_s13_q[6:4] == 3'h7;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s13_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:217
  logic equal_1632;
  assign equal_1632 = x_s13_q[5:0] == 6'h3c;
  logic equal_1634;
  assign equal_1634 = x_s13_q[5:0] == 6'h3b;
  logic equal_1636;
  assign equal_1636 = x_s13_q[5:0] == 6'h36;
  logic equal_1638;
  assign equal_1638 = x_s13_q[5:0] == 6'h35;
  logic equal_1640;
  assign equal_1640 = x_s13_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1208
  logic and_1644;
  assign and_1644 = (~equal_1634) & ((~equal_1636) & ((~equal_1638) & (~equal_1640)));
  // hls/stages/agreement.hpp:1023
  logic [5:0] sum_1658;
  assign sum_1658 = {1'b0, last_s13_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:263
  logic right_2;
  assign right_2 = inside_v_s13_q & ({1'b0, sum_1658, last_s13_q[1]} < x_s13_q);
  // hls/stages/patches.hpp:382
  logic [1:0] select_1697;
  assign select_1697 = and_1696_s13_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1698;
  assign select_1698 = and_1696_s13_q ? patches_band_rows_number_s13_q : patches_band_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] select_1699;
  assign select_1699 = row_starts_s13_q ? {select_1698, select_1697[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1700;
  assign select_1700 = row_starts_s13_q ? select_1697 : patches_fetch_q;
  logic equal_1701;
  assign equal_1701 = select_1700 == 2'h0;
  // hls/stages/agreement.hpp:799
  logic and_1709;
  assign and_1709 = not_581_s13_q & (so_s13_q & (ends_cell_s13_q & right_3_s13_q));
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1711_s13_q ? {sum_1724_s13_q, sum_1720_s13_q} : registration_expected_q;
  // hls/stages/patches.hpp:104
  logic less_1731;
  assign less_1731 = {3'h0, last_s13_q[6:1]} < ({1'b0, sum_1705_s13_q, x_s13_q[0]} + 9'h1);
  // hls/stages/patches.hpp:106
  logic or_1737;
  assign or_1737 = ({sum_1705_s13_q, x_s13_q[0]} == 8'h0) | (~({sum_1705_s13_q, x_s13_q[0]} < {1'b0, last_s13_q}));
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1740;
  assign sum_1740 = {2'h0, sum_1705_s13_q, x_s13_q[0]} + {{4{b_s13_q[5]}}, b_s13_q};
  // hls/stages/agreement.hpp:799
  logic [5:0] select_1758;
  assign select_1758 = equal_580_s13_q ? 6'h0 : (so_s13_q ? (ends_cell_s13_q ? b_s13_q : 6'h0) : 6'h0);
  // hls/stages/patches.hpp:113
  logic equal_1785;
  assign equal_1785 = {sum_1705_s13_q[6], last_s13_q[6:1], x_s13_q[0]} == {1'b0, sum_1705_s13_q[5:0], last_s13_q[0]};
  // hls/stages/patches.hpp:126
  logic [4:0] select_1804;
  assign select_1804 = row_starts_s13_q ? select_1698 : patches_band_q;
  // hls/stages/patches.hpp:360
  logic equal_1805;
  assign equal_1805 = {patches_choosing_band_s13_q, and_1709} == {select_1804, select_1700[1]};
  // hls/stages/patches.hpp:478
  logic [8:0] sum_1908;
  assign sum_1908 = {1'b0, patches_columns_above_rdata_s13_q[7:0]} + {2'h0, pixel_2_s13_q[7:1]};
  logic [8:0] sum_1909;
  assign sum_1909 = {1'b0, patches_columns_above_rdata_s13_q[23:16]} + {2'h0, patches_columns_above_rdata_s13_q[31:25]};
  // hls/stages/patches.hpp:476
  logic [10:0] sum_1929;
  assign sum_1929 = {3'h0, patches_columns_above_rdata_s13_q[15:8]} + {sum_1928_s13_q, patches_columns_above_rdata_s13_q[25]};
  // hls/stages/agreement.hpp:206
  logic [7:0] select_1988;
  assign select_1988 = so_s13_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1066
  logic or_1991;
  assign or_1991 = select_1988[7] | (~({select_1988[5], select_1988[3], select_1988[1]} == 3'h0));
  // hls/stages/agreement.hpp:1065
  logic or_1994;
  assign or_1994 = select_1988[7] | (~({select_1988[6], select_1988[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1064
  logic or_1997;
  assign or_1997 = select_1988[7] | (~(select_1988[6:4] == 3'h0));
  // hls/stages/agreement.hpp:799
  logic [5:0] select_1998;
  assign select_1998 = equal_580_s13_q ? x_s13_q[5:0] : {region_row_q, or_1997, or_1994, or_1991};
  // hls/stages/agreement.hpp:1145
  logic not_1999;
  assign not_1999 = ~equal_1618;
  // hls/stages/agreement.hpp:1074
  logic or_2004;
  assign or_2004 = (~sum_2001_s13_q) | equal_2003_s13_q;
  // hls/stages/agreement.hpp:799
  logic and_2007;
  assign and_2007 = so_s13_q & (ends_cell_s13_q & (inside_v_s13_q & or_2004));
  // hls/stages/agreement.hpp:1045
  logic [7:0] select_2094;
  assign select_2094 = inside_v_s13_q ? (sum_2001_s13_q ? select_1988 : {select_1988[6:0], 1'b0}) : select_1988;
  // hls/stages/agreement.hpp:1066
  logic or_2097;
  assign or_2097 = select_2094[7] | (~({select_2094[5], select_2094[3], select_2094[1]} == 3'h0));
  // hls/stages/agreement.hpp:531
  logic select_2594;
  assign select_2594 = and_555_s13_q ? (equal_2486_s13_q ? and_2592_s13_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:240
  logic [7:0] select_2605;
  assign select_2605 = slot_s13_q[0] ? 8'h0 : sum_1022_s13_q;
  // hls/stages/agreement.hpp:762
  logic less_2606;
  assign less_2606 = select_2605 < select_1522;
  // hls/stages/agreement.hpp:799
  logic less_2612;
  assign less_2612 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2614;
  assign less_2614 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:999
  logic [7:0] difference_2716;
  assign difference_2716 = best_left_rdata_s13_q[16:9] - lower_s13_q;
  // hls/stages/agreement.hpp:799
  logic [10:0] select_2784;
  assign select_2784 = equal_580_s13_q ? registration_expected_q : (so_s13_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2799_s13_q[7]}}, select_2799_s13_q} - {sum_1724_s13_q[9], sum_1724_s13_q, sum_1720_s13_q};
  // hls/stages/patches.hpp:91
  logic parity_3013;
  assign parity_3013 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3014;
  assign select_3014 = equal_2486_s13_q ? {patches_chance_q[14:0], parity_3013} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3_s13_q ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s13_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3019;
  assign select_3019 = right_3_s13_q ? last_s13_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3019};
  // hls/stages/patches.hpp:362
  logic not_3040;
  assign not_3040 = ~select_1700[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3042;
  assign select_3042 = sample_pair_whole_s13_q ? (equal_1701 ? select_1700 : {not_3040, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:191
  logic select_3114;
  assign select_3114 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:177
  logic and_3175;
  assign and_3175 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:422
  logic [4:0] select_3180;
  assign select_3180 = or_3075_s13_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:424
  logic [3:0] select_3182;
  assign select_3182 = and_3175 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:564
  logic [4:0] select_3548;
  assign select_3548 = less_1974_s13_q ? (or_1977_s13_q ? patches_step_s13_q : 5'h0) : 5'h0;
  // hls/stages/patches.hpp:548
  logic [4:0] select_3560;
  assign select_3560 = and_3559_s13_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:555
  logic [5:0] away;
  assign away = {1'b0, patches_step_s13_q} - {1'b0, select_3560};
  // hls/stages/agreement.hpp:465
  logic [2:0] select_3851;
  assign select_3851 = less_3847_s13_q ? (sum_3848_s13_q ? region_row_q : next_region_row_q) : (and_2592_s13_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:531
  logic [2:0] select_3853;
  assign select_3853 = and_555_s13_q ? (equal_2486_s13_q ? select_3851 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_3857;
  assign select_3857 = equal_580_s13_q ? select_1988 : (so_s13_q ? (ends_cell_s13_q ? select_2094 : select_1988) : 8'h1);
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3848_s13_q;
  // hls/stages/agreement.hpp:465
  logic select_3884;
  assign select_3884 = equal_2486_s13_q ? (less_3847_s13_q ? next : (region_fresh_q | equal_689_s13_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1247
  logic equal_3902;
  assign equal_3902 = x_s13_q[6:3] == 4'h7;
  logic equal_3931;
  assign equal_3931 = x_s13_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1142
  logic [7:0] select_3950;
  assign select_3950 = (x_s13_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3952;
  assign select_3952 = equal_3931 ? cfg_unproven_skin_limit_i : (equal_3902 ? cfg_unproven_limit_i : select_3950);

  // Memory moments_memory, 8040 x 4, DISTANCE 16, hls/stages/moments.hpp:155; read in stage 13, written in stage 14: 13 < 14 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:8039];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8040; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_579_s13_q;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s13_en & and_597;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s13_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s13_en & and_1880_s13_q;
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
      draws_late_q <= 1'b0;
      chosen_score_q <= 8'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      shift_allowed_q <= 1'b0;
      registration_expected_q <= 11'h0;
      patches_chance_q <= 16'h1;
      patches_band_q <= 5'h0;
      patches_fetch_q <= 2'h0;
      patches_along_ends_q <= 1'b0;
      patches_match_row_ends_q <= 1'b0;
      patches_down_by_q <= 5'h0;
      patches_along_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_last_q <= 1'b0;
      patches_read_at_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_fresh_q <= 1'b1;
    end else if (s13_en) begin
      sample_pair_pixel_0_q <= pixel_0_s13_q;
      sample_pair_pixel_1_q <= pixel_1_s13_q;
      draws_late_q <= select_2594;
      chosen_score_q <= less_2606 ? select_1522 : select_2605;
      chosen_place_q <= less_2606 ? {select_1530, not_1529} : 3'h2;
      before_0_q <= select_2605;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2612) & (~less_2614);
      registration_expected_q <= select_2784;
      patches_chance_q <= and_555_s13_q ? select_3014 : patches_chance_q;
      patches_band_q <= sample_pair_whole_s13_q ? select_1804 : patches_band_q;
      patches_fetch_q <= select_3042;
      patches_along_ends_q <= not_3099_s13_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3099_s13_q & select_3114;
      patches_down_by_q <= or_3075_s13_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3175});
      patches_along_q <= select_3180;
      patches_match_row_q <= or_3075_s13_q ? 4'h0 : select_3182;
      patches_summed_last_q <= not_1792_s13_q & (equal_1793_s13_q & and_3175);
      patches_read_at_q <= equal_1791_s13_q ? select_3548 : patches_read_at_q;
      patches_peak_row_q <= equal_1791_s13_q ? select_3560 : patches_peak_row_q;
      region_row_q <= select_3853;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3857;
      region_fresh_q <= and_555_s13_q ? select_3884 : region_fresh_q;
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
    if (s13_en) begin
      averager_running_0_q <= sample_pair_whole_s13_q ? select_532 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s13_q ? sum_538 : averager_running_1_q;
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
  logic moments_starts_s14_q;
  logic [5:0] run_shift_s14_q;
  logic [7:0] x_s14_q;
  logic age_s14_q;
  logic [2:0] slot_s14_q;
  logic ends_cell_s14_q;
  logic lower_half_s14_q;
  logic draws_late_s14_q;
  logic [7:0] before_0_s14_q;
  logic [7:0] before_1_s14_q;
  logic [7:0] before_2_s14_q;
  logic shift_not_right_s14_q;
  logic patches_chooses_s14_q;
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
  logic [9:0] patches_read_row_differing_s14_q;
  logic patches_read_first_s14_q;
  logic [2:0] region_row_s14_q;
  logic region_fresh_s14_q;
  logic done_s14_q;
  logic proven_s14_q;
  logic [3:0] select_514_s14_q;
  logic equal_515_s14_q;
  logic row_starts_s14_q;
  logic [8:0] select_519_s14_q;
  logic and_528_s14_q;
  logic and_529_s14_q;
  logic [29:0] averager_memory_rdata_s14_q;
  logic [13:0] select_532_s14_q;
  logic equal_534_s14_q;
  logic [13:0] sum_538_s14_q;
  logic [6:0] select_549_s14_q;
  logic [6:0] last_s14_q;
  logic and_553_s14_q;
  logic and_555_s14_q;
  logic equal_575_s14_q;
  logic [12:0] select_579_s14_q;
  logic equal_580_s14_q;
  logic not_581_s14_q;
  logic so_s14_q;
  logic not_583_s14_q;
  logic equal_584_s14_q;
  logic or_585_s14_q;
  logic less_588_s14_q;
  logic not_589_s14_q;
  logic inside_v_s14_q;
  logic not_593_s14_q;
  logic and_597_s14_q;
  logic [6:0] x_s14_2_q;
  logic [32:0] best_left_rdata_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic and_639_s14_q;
  logic and_645_s14_q;
  logic and_648_s14_q;
  logic and_654_s14_q;
  logic and_656_s14_q;
  logic equal_689_s14_q;
  logic select_772_s14_q;
  logic [7:0] of_best_s14_q;
  logic [2:0] select_1532_s14_q;
  logic [6:0] of_near_s14_q;
  logic [6:0] select_1562_s14_q;
  logic [5:0] select_1564_s14_q;
  logic [7:0] select_1567_s14_q;
  logic [7:0] select_1570_s14_q;
  logic and_1572_s14_q;
  logic select_1574_s14_q;
  logic or_1580_s14_q;
  logic and_1583_s14_q;
  logic and_1585_s14_q;
  logic [1:0] shown_right_rdata_s14_q;
  logic [6:0] select_1589_s14_q;
  logic and_1594_s14_q;
  logic [1:0] left_turns_rdata_s14_q;
  logic and_1611_s14_q;
  logic [1:0] right_turns_rdata_s14_q;
  logic equal_1618_s14_q;
  logic all_s14_q;
  logic equal_1632_s14_q;
  logic equal_1634_s14_q;
  logic equal_1636_s14_q;
  logic equal_1638_s14_q;
  logic equal_1640_s14_q;
  logic and_1645_s14_q;
  logic right_2_s14_q;
  logic [5:0] select_1699_s14_q;
  logic select_1700_s14_q;
  logic equal_1701_s14_q;
  logic [6:0] sum_1705_s14_q;
  logic and_1709_s14_q;
  logic less_1710_s14_q;
  logic equal_1711_s14_q;
  logic expected_s14_q;
  logic [10:0] sum_1726_s14_q;
  logic less_1731_s14_q;
  logic not_1732_s14_q;
  logic or_1737_s14_q;
  logic less_1741_s14_q;
  logic less_1742_s14_q;
  logic [5:0] select_1758_s14_q;
  logic [7:0] select_1783_s14_q;
  logic equal_1785_s14_q;
  logic equal_1791_s14_q;
  logic not_1792_s14_q;
  logic equal_1793_s14_q;
  logic not_1794_s14_q;
  logic equal_1795_s14_q;
  logic equal_1796_s14_q;
  logic or_1797_s14_q;
  logic not_1798_s14_q;
  logic equal_1805_s14_q;
  logic equal_1808_s14_q;
  logic less_1811_s14_q;
  logic [4:0] select_1826_s14_q;
  logic select_1832_s14_q;
  logic [3:0] select_1870_s14_q;
  logic [8:0] patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic [4:0] sum_1894_s14_q;
  logic [8:0] sum_1908_s14_q;
  logic [8:0] sum_1909_s14_q;
  logic [10:0] sum_1929_s14_q;
  logic less_1974_s14_q;
  logic equal_1975_s14_q;
  logic or_1977_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic or_1991_s14_q;
  logic or_1994_s14_q;
  logic or_1997_s14_q;
  logic [5:0] select_1998_s14_q;
  logic not_1999_s14_q;
  logic select_2008_s14_q;
  logic and_2011_s14_q;
  logic not_2012_s14_q;
  logic and_2026_s14_q;
  logic and_2036_s14_q;
  logic [12:0] seen_columns_rdata_s14_q;
  logic not_2066_s14_q;
  logic and_2080_s14_q;
  logic and_2082_s14_q;
  logic or_2097_s14_q;
  logic or_2100_s14_q;
  logic or_2103_s14_q;
  logic and_2114_s14_q;
  logic and_2130_s14_q;
  logic less_2144_s14_q;
  logic not_2148_s14_q;
  logic equal_2298_s14_q;
  logic equal_2486_s14_q;
  logic and_2623_s14_q;
  logic and_2650_s14_q;
  logic equal_2712_s14_q;
  logic [5:0] difference_2716_s14_q;
  logic [7:0] sum_2718_s14_q;
  logic [11:0] select_2802_s14_q;
  logic [6:0] from_s14_q;
  logic [5:0] away_s14_q;
  logic [9:0] select_3580_s14_q;
  logic [4:0] select_3581_s14_q;
  logic equal_3591_s14_q;
  logic select_3891_s14_q;
  logic equal_3902_s14_q;
  logic equal_3919_s14_q;
  logic equal_3931_s14_q;
  logic [7:0] select_3952_s14_q;
  logic and_4065_s14_q;
  logic or_4077_s14_q;
  logic and_4091_s14_q;
  logic and_4108_s14_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_pixel_0_s14_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s14_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s14_q <= sample_pair_whole_s13_q;
      sample_present_s14_q <= sample_present_s13_q;
      moments_starts_s14_q <= moments_starts_s13_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      age_s14_q <= age_s13_q;
      slot_s14_q <= slot_s13_q;
      ends_cell_s14_q <= ends_cell_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      draws_late_s14_q <= draws_late_q;
      before_0_s14_q <= before_0_q;
      before_1_s14_q <= before_1_q;
      before_2_s14_q <= before_2_q;
      shift_not_right_s14_q <= shift_not_right_s13_q;
      patches_chooses_s14_q <= patches_chooses_s13_q;
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
      patches_read_row_differing_s14_q <= patches_read_row_differing_s13_q;
      patches_read_first_s14_q <= patches_read_first_s13_q;
      region_row_s14_q <= region_row_q;
      region_fresh_s14_q <= region_fresh_q;
      done_s14_q <= done_s13_q;
      proven_s14_q <= proven_s13_q;
      select_514_s14_q <= select_514_s13_q;
      equal_515_s14_q <= equal_515_s13_q;
      row_starts_s14_q <= row_starts_s13_q;
      select_519_s14_q <= select_519_s13_q;
      and_528_s14_q <= and_528_s13_q;
      and_529_s14_q <= and_529_s13_q;
      averager_memory_rdata_s14_q <= averager_memory_rdata_q;
      select_532_s14_q <= select_532;
      equal_534_s14_q <= equal_534_s13_q;
      sum_538_s14_q <= sum_538;
      select_549_s14_q <= select_549_s13_q;
      last_s14_q <= last_s13_2_q;
      and_553_s14_q <= and_553_s13_q;
      and_555_s14_q <= and_555_s13_q;
      equal_575_s14_q <= equal_575_s13_q;
      select_579_s14_q <= select_579_s13_q;
      equal_580_s14_q <= equal_580_s13_q;
      not_581_s14_q <= not_581_s13_q;
      so_s14_q <= so_s13_q;
      not_583_s14_q <= not_583_s13_q;
      equal_584_s14_q <= equal_584_s13_q;
      or_585_s14_q <= or_585_s13_q;
      less_588_s14_q <= less_588_s13_q;
      not_589_s14_q <= not_589_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      not_593_s14_q <= not_593_s13_q;
      and_597_s14_q <= and_597;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[32:0];
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      and_639_s14_q <= and_639;
      and_645_s14_q <= and_645_s13_q;
      and_648_s14_q <= and_648_s13_q;
      and_654_s14_q <= and_654_s13_q;
      and_656_s14_q <= and_656_s13_q;
      equal_689_s14_q <= equal_689_s13_q;
      select_772_s14_q <= select_772_s13_q;
      of_best_s14_q <= of_best;
      select_1532_s14_q <= select_1532;
      of_near_s14_q <= of_near;
      select_1562_s14_q <= less_1561 ? of_near : best_left_rdata_s13_q[39:33];
      select_1564_s14_q <= less_1561 ? run_shift_s13_q : best_left_rdata_s13_q[45:40];
      select_1567_s14_q <= select_1567_s13_q;
      select_1570_s14_q <= select_1570_s13_q;
      and_1572_s14_q <= and_1572_s13_q;
      select_1574_s14_q <= select_1574_s13_q;
      or_1580_s14_q <= select_1574_s13_q | (best_right_rdata_s13_q[21:15] < of_near);
      and_1583_s14_q <= and_1583_s13_q;
      and_1585_s14_q <= and_1585_s13_q;
      shown_right_rdata_s14_q <= shown_right_rdata_q;
      select_1589_s14_q <= select_1589_s13_q;
      and_1594_s14_q <= and_639 & or_1593_s13_q;
      left_turns_rdata_s14_q <= left_turns_rdata_q;
      and_1611_s14_q <= and_1611_s13_q;
      right_turns_rdata_s14_q <= right_turns_rdata_q;
      equal_1618_s14_q <= equal_1618;
      all_s14_q <= all;
      equal_1632_s14_q <= equal_1632;
      equal_1634_s14_q <= equal_1634;
      equal_1636_s14_q <= equal_1636;
      equal_1638_s14_q <= equal_1638;
      equal_1640_s14_q <= equal_1640;
      and_1645_s14_q <= (~equal_1632) & and_1644;
      right_2_s14_q <= right_2;
      select_1699_s14_q <= select_1699;
      select_1700_s14_q <= select_1700[1];
      equal_1701_s14_q <= equal_1701;
      sum_1705_s14_q <= sum_1705_s13_q;
      and_1709_s14_q <= and_1709;
      less_1710_s14_q <= less_1710_s13_q;
      equal_1711_s14_q <= equal_1711_s13_q;
      expected_s14_q <= expected[0];
      sum_1726_s14_q <= {expected[10], expected[10:1]} + 11'h5;
      less_1731_s14_q <= less_1731;
      not_1732_s14_q <= ~right_3_s13_q;
      or_1737_s14_q <= or_1737;
      less_1741_s14_q <= $signed(10'h0) < $signed(sum_1740);
      less_1742_s14_q <= $signed(sum_1740) < $signed({3'h0, last_s13_q});
      select_1758_s14_q <= select_1758;
      select_1783_s14_q <= select_1783_s13_q;
      equal_1785_s14_q <= equal_1785;
      equal_1791_s14_q <= equal_1791_s13_q;
      not_1792_s14_q <= not_1792_s13_q;
      equal_1793_s14_q <= equal_1793_s13_q;
      not_1794_s14_q <= not_1794_s13_q;
      equal_1795_s14_q <= equal_1795_s13_q;
      equal_1796_s14_q <= equal_1796_s13_q;
      or_1797_s14_q <= or_1797_s13_q;
      not_1798_s14_q <= not_1798_s13_q;
      equal_1805_s14_q <= equal_1805;
      equal_1808_s14_q <= equal_1808_s13_q;
      less_1811_s14_q <= select_1804 < patches_bands_chosen_q;
      select_1826_s14_q <= select_1826_s13_q;
      select_1832_s14_q <= select_1832_s13_q;
      select_1870_s14_q <= select_1870_s13_q;
      patches_columns_above_rdata_s14_q <= {patches_columns_above_rdata_s13_q[24], patches_columns_above_rdata_s13_q[7:0]};
      pixel_2_s14_q <= pixel_2_s13_q;
      sum_1894_s14_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1908_s14_q <= sum_1908;
      sum_1909_s14_q <= sum_1909;
      sum_1929_s14_q <= sum_1929;
      less_1974_s14_q <= less_1974_s13_q;
      equal_1975_s14_q <= equal_1975_s13_q;
      or_1977_s14_q <= or_1977_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      or_1991_s14_q <= or_1991;
      or_1994_s14_q <= or_1994;
      or_1997_s14_q <= or_1997;
      select_1998_s14_q <= select_1998;
      not_1999_s14_q <= not_1999;
      select_2008_s14_q <= equal_580_s13_q ? (x_s13_q[6] & not_1999) : and_2007;
      and_2011_s14_q <= or_585_s13_q & (not_589_s13_q & and_613_s13_q);
      not_2012_s14_q <= not_2012_s13_q;
      and_2026_s14_q <= and_2026_s13_q;
      and_2036_s14_q <= not_581_s13_q & and_2007;
      seen_columns_rdata_s14_q <= {seen_columns_rdata_s13_q[13:7], seen_columns_rdata_s13_q[5:0]};
      not_2066_s14_q <= not_2066_s13_q;
      and_2080_s14_q <= seen_columns_rdata_s13_q[14] & inside_v_s13_q;
      and_2082_s14_q <= seen_columns_rdata_s13_q[5] & inside_v_s13_q;
      or_2097_s14_q <= or_2097;
      or_2100_s14_q <= select_2094[7] | (~({select_2094[6], select_2094[3:2]} == 3'h0));
      or_2103_s14_q <= select_2094[7] | (~(select_2094[6:4] == 3'h0));
      and_2114_s14_q <= seen_columns_rdata_s13_q[16] & inside_v_s13_q;
      and_2130_s14_q <= seen_columns_rdata_s13_q[17] & inside_v_s13_q;
      less_2144_s14_q <= less_2144_s13_q;
      not_2148_s14_q <= ~({sum_1658, last_s13_q[1:0]} < x_s13_q);
      equal_2298_s14_q <= equal_2298_s13_q;
      equal_2486_s14_q <= equal_2486_s13_q;
      and_2623_s14_q <= and_2623_s13_q;
      and_2650_s14_q <= seen_columns_rdata_s13_q[15] & inside_v_s13_q;
      equal_2712_s14_q <= equal_2712_s13_q;
      difference_2716_s14_q <= difference_2716[7:2];
      sum_2718_s14_q <= sum_2718_s13_q;
      select_2802_s14_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      from_s14_q <= from;
      away_s14_q <= away;
      select_3580_s14_q <= patches_peak_best_differing_q;
      select_3581_s14_q <= patches_peak_best_column_q;
      equal_3591_s14_q <= equal_3591_s13_q;
      select_3891_s14_q <= sum_2001_s13_q ? (equal_2003_s13_q & or_2004) : or_2004;
      equal_3902_s14_q <= equal_3902;
      equal_3919_s14_q <= equal_3919_s13_q;
      equal_3931_s14_q <= equal_3931;
      select_3952_s14_q <= select_3952;
      and_4065_s14_q <= seen_columns_rdata_s13_q[6] & inside_v_s13_q;
      or_4077_s14_q <= or_4077_s13_q;
      and_4091_s14_q <= and_4091_s13_q;
      and_4108_s14_q <= and_4108_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic sample_of_skin_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [4:0] patches_summed_down_by_q;
  logic patches_read_above_q;
  logic patches_read_below_q;
  logic [9:0] patches_peak_above_q;
  logic [9:0] patches_peak_below_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic segment_starts_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  logic write_half_q;
  logic read_half_q;
  // hls/stages/census.hpp:129
  logic [13:0] sum_536;
  assign sum_536 = select_532_s14_q + (equal_534_s14_q ? 14'h0 : averager_memory_rdata_s14_q[13:0]);
  logic [13:0] sum_540;
  assign sum_540 = sum_538_s14_q + (equal_534_s14_q ? 14'h0 : averager_memory_rdata_s14_q[27:14]);
  // hls/stages/agreement.hpp:423
  logic whole;
  assign whole = equal_515_s14_q ? sample_present_s14_q : (sample_present_s14_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_515_s14_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:131
  logic and_548;
  assign and_548 = all_of_skin & (averager_memory_rdata_s14_q[29] | equal_534_s14_q);
  // hls/stages/agreement.hpp:150
  logic and_641;
  assign and_641 = or_585_s14_q & (not_589_s14_q & and_639_s14_q);
  // hls/stages/moments.hpp:89
  logic and_646;
  assign and_646 = and_641 & and_645_s14_q;
  // hls/stages/agreement.hpp:821
  logic equal_1535;
  assign equal_1535 = select_1532_s14_q == 3'h1;
  logic or_1538;
  assign or_1538 = equal_1535 | (~(select_1532_s14_q == 3'h2));
  logic [7:0] select_1540;
  assign select_1540 = or_1538 ? before_0_s14_q : before_1_s14_q;
  logic [7:0] select_1541;
  assign select_1541 = equal_1535 ? (or_1538 ? before_1_q : {7'h0, shift_not_right_s14_q}) : select_1540;
  // hls/stages/agreement.hpp:822
  logic [7:0] select_1544;
  assign select_1544 = equal_1535 ? select_1540 : (or_1538 ? before_2_q : before_2_s14_q);
  // hls/stages/agreement.hpp:835
  logic or_1576;
  assign or_1576 = select_1574_s14_q | (best_right_rdata_s14_q[7:0] < of_best_s14_q);
  // hls/stages/agreement.hpp:150
  logic and_1596;
  assign and_1596 = or_585_s14_q & (not_589_s14_q & and_1594_s14_q);
  // hls/stages/agreement.hpp:799
  logic and_1600;
  assign and_1600 = not_581_s14_q & (so_s14_q ? and_1583_s14_q : (equal_584_s14_q & and_641));
  // hls/stages/agreement.hpp:1208
  logic [1:0] quarter;
  assign quarter = x_s14_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1146
  logic [1:0] select_1621;
  assign select_1621 = x_s14_q[4] ? {x_s14_q[3], x_s14_q[0]} : {x_s14_q[0], x_s14_q[3]};
  // hls/stages/agreement.hpp:1159
  logic [3:0] select_1623;
  assign select_1623 = equal_1618_s14_q ? {2'h0, quarter} : (all_s14_q ? {1'b0, x_s14_q[2:0]} : {x_s14_q[2:1], select_1621});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1624;
  assign sum_1624 = slot_s14_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:799
  logic [3:0] select_1625;
  assign select_1625 = equal_580_s14_q ? select_1623 : {sum_1624, lower_half_s14_q, registration_of_right_q};
  // hls/stages/patches.hpp:217
  logic equal_1626;
  assign equal_1626 = x_s14_q[5:0] == 6'h3f;
  logic equal_1628;
  assign equal_1628 = x_s14_q[5:0] == 6'h3e;
  logic equal_1630;
  assign equal_1630 = x_s14_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1208
  logic and_1648;
  assign and_1648 = (~equal_1626) & ((~equal_1628) & ((~equal_1630) & and_1645_s14_q));
  // hls/stages/agreement.hpp:1146
  logic less_1649;
  assign less_1649 = x_s14_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s14_q ? {1'b0, x_s14_q[2]} : x_s14_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1653;
  assign or_1653 = (kind == 2'h3) | (x_s14_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s14_q ? (right_2_s14_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1664;
  assign sum_1664 = {2'h0, slot_s14_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1670;
  assign not_1670 = ~lower_half_s14_q;
  logic [3:0] select_1671;
  assign select_1671 = registration_of_right_q ? {lower_half_s14_q, 1'b0, not_1670, 1'b0} : {1'b0, lower_half_s14_q, 1'b0, not_1670};
  // hls/stages/patches.hpp:98
  logic less_1727;
  assign less_1727 = {{4{sum_1726_s14_q[10]}}, sum_1726_s14_q, expected_s14_q} < 16'h15;
  // hls/stages/patches.hpp:104
  logic and_1733;
  assign and_1733 = less_1731_s14_q & not_1732_s14_q;
  // hls/stages/agreement.hpp:1032
  logic and_1744;
  assign and_1744 = (~(and_1733 | or_1737_s14_q)) & (less_1741_s14_q & less_1742_s14_q);
  // hls/stages/agreement.hpp:799
  logic and_1789;
  assign and_1789 = not_581_s14_q & (so_s14_q & (ends_cell_s14_q & (and_1733 | equal_1785_s14_q)));
  // hls/stages/patches.hpp:351
  logic and_1790;
  assign and_1790 = patches_chooses_s14_q & and_1789;
  // hls/stages/patches.hpp:509
  logic less_1886;
  assign less_1886 = 5'he < patches_along_s14_q;
  // hls/stages/patches.hpp:510
  logic or_1887;
  assign or_1887 = equal_1795_s14_q | less_1886;
  // hls/stages/patches.hpp:513
  logic new_row;
  assign new_row = patches_along_s14_q == 5'h0;
  logic select_1892;
  assign select_1892 = equal_1795_s14_q ? patches_column_s14_q[0] : (or_1887 ? (patches_along_s14_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:511
  logic [4:0] select_1895;
  assign select_1895 = patches_match_row_ends_s14_q ? patches_down_by_s14_q : sum_1894_s14_q;
  // hls/stages/patches.hpp:514
  logic [4:0] select_1898;
  assign select_1898 = equal_1795_s14_q ? 5'h0 : (or_1887 ? (select_1895 + 5'h1) : sum_1894_s14_q);
  // hls/stages/patches.hpp:490
  logic equal_1901;
  assign equal_1901 = patches_column_s14_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s14_q == 5'h11;
  logic equal_1903;
  assign equal_1903 = patches_column_s14_q == 5'h18;
  // hls/stages/patches.hpp:492
  logic and_1905;
  assign and_1905 = of_row & (~equal_1903);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1901 ? 2'h3 : {equal_1903, and_1905};
  // hls/stages/patches.hpp:478
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1908_s14_q, pixel_2_s14_q[0]} - {1'b0, sum_1909_s14_q, patches_columns_above_rdata_s14_q[8]};
  // hls/stages/patches.hpp:476
  logic [9:0] sum_1930;
  assign sum_1930 = {2'h0, patches_columns_above_rdata_s14_q[7:0]} + sum_1929_s14_q[10:1];
  // hls/stages/patches.hpp:491
  logic or_1949;
  assign or_1949 = (((patches_column_s14_q == 5'ha) | of_row) | equal_1903) | equal_1901;
  // hls/stages/patches.hpp:486
  logic and_1954;
  assign and_1954 = (~(patches_code_row_s14_q[4:2] == 3'h0)) & (~(patches_column_s14_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:174
  logic and_1968;
  assign and_1968 = (~(equal_1796_s14_q | (~and_1954))) & (~patches_column_s14_q[4]);
  // hls/stages/agreement.hpp:150
  logic and_2028;
  assign and_2028 = or_585_s14_q & (not_589_s14_q & and_2026_s14_q);
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s14_q & and_2011_s14_q;
  // hls/stages/agreement.hpp:1028
  logic select_2041;
  assign select_2041 = slot_s14_q[2] ? shown_shown_q : and_641;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s14_q & (shown_right_rdata_s14_q[0] | select_2041);
  // hls/stages/agreement.hpp:1028
  logic select_2044;
  assign select_2044 = slot_s14_q[2] ? shown_nearer_q : and_1596;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s14_q & (select_2041 ? select_2044 : shown_right_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:1306
  logic select_2064;
  assign select_2064 = marks_first_s14_q ? (done_s14_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1127
  logic not_2146;
  assign not_2146 = ~(x_s14_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:799
  logic select_2152;
  assign select_2152 = less_2144_s14_q ? (not_2146 & not_2148_s14_q) : ((draws_late_s14_q & not_2146) & not_2148_s14_q);
  // hls/stages/agreement.hpp:277
  logic select_2211;
  assign select_2211 = sample_pair_whole_s14_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:799
  logic and_2626;
  assign and_2626 = ends_cell_s14_q & (inside_v_s14_q & (and_2623_s14_q & not_2012_s14_q));
  // hls/stages/agreement.hpp:1122
  logic not_2649;
  assign not_2649 = ~((draws_late_s14_q & not_2012_s14_q) | (x_s14_q[7:1] == 7'h0));
  // hls/stages/agreement.hpp:799
  logic and_2691;
  assign and_2691 = ends_cell_s14_q & (inside_v_s14_q & (not_2012_s14_q & (and_2623_s14_q & and_2028)));
  // hls/stages/agreement.hpp:1127
  logic and_2697;
  assign and_2697 = not_2649 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:248
  logic and_2721;
  assign and_2721 = ((and_2026_s14_q & and_639_s14_q) & equal_2712_s14_q) & (~({2'h0, difference_2716_s14_q} < sum_2718_s14_q));
  // hls/stages/agreement.hpp:150
  logic and_2732;
  assign and_2732 = not_589_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_2734;
  assign and_2734 = not_589_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2735;
  assign select_2735 = or_585_s14_q ? {and_2734, and_2732} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_2737;
  assign select_2737 = less_588_s14_q ? 2'h0 : (slot_s14_q[2] ? right_turns_rdata_s14_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2738;
  assign select_2738 = or_585_s14_q ? select_2737 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2785;
  assign equal_2785 = slot_s14_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2802_s14_q[11:7])) ? 12'h7f : select_2802_s14_q;
  // hls/stages/agreement.hpp:799
  logic select_2846;
  assign select_2846 = so_s14_q ? (equal_2785 ? right_2_s14_q : registration_of_right_q) : registration_of_right_q;
  logic select_2849;
  assign select_2849 = so_s14_q ? (equal_1711_s14_q ? inside_v_s14_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1146
  logic [1:0] quarter_2;
  assign quarter_2 = all_s14_q ? x_s14_q[1:0] : select_1621;
  // hls/stages/agreement.hpp:799
  logic and_3023;
  assign and_3023 = ends_cell_s14_q & (~({sum_1705_s14_q, x_s14_q[0]} < {1'b0, from_s14_q}));
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3537;
  assign select_3537 = equal_1793_s14_q ? patches_down_by_s14_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:564
  logic and_3565;
  assign and_3565 = less_1974_s14_q & (or_1977_s14_q & (equal_1975_s14_q & (away_s14_q == 6'h3f)));
  logic and_3570;
  assign and_3570 = less_1974_s14_q & (or_1977_s14_q & (equal_1975_s14_q & (away_s14_q == 6'h1)));
  // hls/stages/patches.hpp:561
  logic [6:0] sum_3572;
  assign sum_3572 = {away_s14_q[5], away_s14_q} + 7'h7d;
  // hls/stages/patches.hpp:549
  logic [9:0] select_3583;
  assign select_3583 = patches_read_above_q ? patches_read_row_differing_s14_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3584;
  assign select_3584 = equal_1791_s14_q ? select_3583 : patches_peak_above_q;
  // hls/stages/patches.hpp:550
  logic [9:0] select_3585;
  assign select_3585 = patches_read_below_q ? patches_read_row_differing_s14_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3586;
  assign select_3586 = equal_1791_s14_q ? select_3585 : patches_peak_below_q;
  // hls/stages/agreement.hpp:799
  logic select_3844;
  assign select_3844 = equal_580_s14_q ? shown_shown_q : (so_s14_q ? select_2041 : shown_shown_q);
  logic select_3846;
  assign select_3846 = equal_580_s14_q ? shown_nearer_q : (so_s14_q ? select_2044 : shown_nearer_q);
  // hls/stages/agreement.hpp:206
  logic or_3889;
  assign or_3889 = segment_starts_q | not_583_s14_q;
  // hls/stages/agreement.hpp:799
  logic select_3893;
  assign select_3893 = ends_cell_s14_q ? (inside_v_s14_q ? select_3891_s14_q : or_3889) : or_3889;
  // hls/stages/agreement.hpp:1247
  logic equal_3926;
  assign equal_3926 = x_s14_q[6:3] == 4'ha;
  logic equal_3929;
  assign equal_3929 = x_s14_q[6:3] == 4'hb;
  logic equal_3930;
  assign equal_3930 = x_s14_q[6:3] == 4'h9;
  // hls/stages/agreement.hpp:1142
  logic [7:0] select_3954;
  assign select_3954 = equal_3926 ? cfg_regions_limit_i : (equal_3930 ? cfg_hidden_limit_i : select_3952_s14_q);
  // hls/stages/agreement.hpp:799
  logic select_4063;
  assign select_4063 = so_s14_q ? (ends_cell_s14_q ? and_2082_s14_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4067;
  assign select_4067 = so_s14_q ? (ends_cell_s14_q ? and_4065_s14_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4069;
  assign select_4069 = ends_cell_s14_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4071;
  assign select_4071 = equal_580_s14_q ? centres_values_1_textured_q : (so_s14_q ? select_4069 : centres_values_1_textured_q);
  logic select_4072;
  assign select_4072 = ends_cell_s14_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4074;
  assign select_4074 = equal_580_s14_q ? centres_values_1_of_skin_q : (so_s14_q ? select_4072 : centres_values_1_of_skin_q);

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:352; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = last_s14_q;
`ifndef SYNTHESIS
  logic census_memory_re;
  assign census_memory_re = s14_en & and_555_s14_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:782; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1699_s14_q;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s14_en & (sample_pair_whole_s14_q & (~equal_1701_s14_q));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1431; read in stage 14, written in stage 17: 14 < 17 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1998_s14_q;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s14_en & select_2008_s14_q;
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory moments_memory, write
  logic [12:0] moments_memory_waddr;
  assign moments_memory_waddr = select_579_s14_q;
  logic moments_memory_we;
  assign moments_memory_we = s14_en & and_597_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_656_s14_q, and_654_s14_q, and_648_s14_q, and_646};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && moments_memory_we) begin
      if (moments_memory_re && moments_memory_raddr == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_waddr >= 13'd8040) $error("moments_memory: write outside, address %0d", moments_memory_waddr);
    end
    if (rst_ni && moments_memory_re && moments_memory_raddr >= 13'd8040) $error("moments_memory: read outside, address %0d", moments_memory_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_of_skin_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      patches_summed_down_by_q <= 5'h0;
      patches_read_above_q <= 1'b0;
      patches_read_below_q <= 1'b0;
      patches_peak_above_q <= 10'h0;
      patches_peak_below_q <= 10'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      segment_starts_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
    end else if (s14_en) begin
      sample_of_skin_q <= mask_s14_q;
      averager_running_mask_q <= sample_pair_whole_s14_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2211;
      registration_of_right_q <= equal_580_s14_q ? registration_of_right_q : select_2846;
      registration_was_inside_q <= equal_580_s14_q ? registration_was_inside_q : select_2849;
      patches_summed_down_by_q <= equal_1791_s14_q ? patches_summed_down_by_q : select_3537;
      patches_read_above_q <= equal_1791_s14_q ? and_3565 : patches_read_above_q;
      patches_read_below_q <= equal_1791_s14_q ? and_3570 : patches_read_below_q;
      patches_peak_above_q <= select_3584;
      patches_peak_below_q <= select_3586;
      shown_shown_q <= select_3844;
      shown_nearer_q <= select_3846;
      segment_starts_q <= equal_580_s14_q ? or_3889 : (so_s14_q ? select_3893 : or_3889);
      centres_values_0_textured_q <= equal_580_s14_q ? centres_values_0_textured_q : select_4063;
      centres_values_0_of_skin_q <= equal_580_s14_q ? centres_values_0_of_skin_q : select_4067;
      centres_values_1_textured_q <= select_4071;
      centres_values_1_of_skin_q <= select_4074;
      write_half_q <= marks_first_s14_q ? (write_half_q ^ done_s14_q) : write_half_q;
      read_half_q <= select_2064;
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
  logic moments_starts_s15_q;
  logic [5:0] run_shift_s15_q;
  logic [7:0] x_s15_q;
  logic age_s15_q;
  logic [2:0] slot_s15_q;
  logic ends_cell_s15_q;
  logic lower_half_s15_q;
  logic registration_of_right_s15_q;
  logic [4:0] patches_choosing_band_s15_q;
  logic patches_lower_s15_q;
  logic patches_second_s15_q;
  logic [4:0] patches_code_row_s15_q;
  logic [4:0] patches_along_s15_q;
  logic [3:0] patches_match_row_s15_q;
  logic patches_summed_last_s15_q;
  logic [4:0] patches_summed_down_by_s15_q;
  logic patches_read_first_s15_q;
  logic [2:0] region_row_s15_q;
  logic region_fresh_s15_q;
  logic centres_values_1_textured_s15_q;
  logic centres_values_1_of_skin_s15_q;
  logic proven_s15_q;
  logic [3:0] select_514_s15_q;
  logic row_starts_s15_q;
  logic [8:0] select_519_s15_q;
  logic and_528_s15_q;
  logic and_529_s15_q;
  logic [13:0] sum_536_s15_q;
  logic [13:0] sum_540_s15_q;
  logic and_544_s15_q;
  logic and_548_s15_q;
  logic [6:0] select_549_s15_q;
  logic [6:0] last_s15_q;
  logic and_553_s15_q;
  logic and_555_s15_q;
  logic equal_558_s15_q;
  logic equal_575_s15_q;
  logic equal_580_s15_q;
  logic not_581_s15_q;
  logic so_s15_q;
  logic not_583_s15_q;
  logic equal_584_s15_q;
  logic inside_v_s15_q;
  logic not_593_s15_q;
  logic [3:0] moments_memory_rdata_s15_q;
  logic [6:0] x_s15_2_q;
  logic [32:0] best_left_rdata_s15_q;
  logic [6:0] right_s15_q;
  logic [14:0] best_right_rdata_s15_q;
  logic and_641_s15_q;
  logic and_648_s15_q;
  logic and_656_s15_q;
  logic equal_689_s15_q;
  logic [7:0] of_best_s15_q;
  logic or_1527_s15_q;
  logic [2:0] select_1532_s15_q;
  logic [7:0] select_1541_s15_q;
  logic [7:0] select_1544_s15_q;
  logic [6:0] select_1563_s15_q;
  logic [5:0] select_1565_s15_q;
  logic [7:0] select_1568_s15_q;
  logic [7:0] select_1571_s15_q;
  logic and_1572_s15_q;
  logic or_1576_s15_q;
  logic [6:0] select_1581_s15_q;
  logic [6:0] select_1582_s15_q;
  logic and_1585_s15_q;
  logic [6:0] select_1589_s15_q;
  logic and_1596_s15_q;
  logic and_1600_s15_q;
  logic and_1611_s15_q;
  logic equal_1618_s15_q;
  logic [1:0] quarter_s15_q;
  logic all_s15_q;
  logic [1:0] sum_1624_s15_q;
  logic [3:0] select_1625_s15_q;
  logic equal_1626_s15_q;
  logic equal_1628_s15_q;
  logic equal_1630_s15_q;
  logic equal_1632_s15_q;
  logic equal_1634_s15_q;
  logic equal_1636_s15_q;
  logic equal_1638_s15_q;
  logic equal_1640_s15_q;
  logic less_1649_s15_q;
  logic or_1653_s15_q;
  logic select_1656_s15_q;
  logic and_1666_s15_q;
  logic [3:0] select_1671_s15_q;
  logic select_1700_s15_q;
  logic equal_1701_s15_q;
  logic [6:0] sum_1705_s15_q;
  logic and_1709_s15_q;
  logic equal_1711_s15_q;
  logic and_1745_s15_q;
  logic [5:0] select_1758_s15_q;
  logic [7:0] select_1783_s15_q;
  logic and_1789_s15_q;
  logic and_1790_s15_q;
  logic equal_1791_s15_q;
  logic not_1792_s15_q;
  logic equal_1793_s15_q;
  logic not_1794_s15_q;
  logic equal_1796_s15_q;
  logic or_1797_s15_q;
  logic not_1798_s15_q;
  logic and_1806_s15_q;
  logic equal_1808_s15_q;
  logic less_1811_s15_q;
  logic [4:0] select_1826_s15_q;
  logic select_1832_s15_q;
  logic [3:0] select_1870_s15_q;
  logic patches_columns_above_rdata_s15_q;
  logic [7:0] pixel_2_s15_q;
  logic less_1886_s15_q;
  logic new_row_s15_q;
  logic select_1892_s15_q;
  logic not_1893_s15_q;
  logic [4:0] select_1898_s15_q;
  logic or_1899_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [10:0] down_2_s15_q;
  logic sum_1929_s15_q;
  logic [9:0] sum_1930_s15_q;
  logic and_1957_s15_q;
  logic and_1968_s15_q;
  logic and_1971_s15_q;
  logic less_1974_s15_q;
  logic or_1977_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic or_1991_s15_q;
  logic or_1994_s15_q;
  logic or_1997_s15_q;
  logic not_1999_s15_q;
  logic not_2012_s15_q;
  logic and_2014_s15_q;
  logic and_2028_s15_q;
  logic and_2036_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic textured_s15_q;
  logic shown_s15_q;
  logic near_s15_q;
  logic not_2066_s15_q;
  logic select_2078_s15_q;
  logic and_2080_s15_q;
  logic and_2082_s15_q;
  logic or_2097_s15_q;
  logic or_2100_s15_q;
  logic or_2103_s15_q;
  logic and_2114_s15_q;
  logic and_2116_s15_q;
  logic and_2117_s15_q;
  logic and_2130_s15_q;
  logic and_2132_s15_q;
  logic and_2133_s15_q;
  logic and_2153_s15_q;
  logic equal_2298_s15_q;
  logic equal_2486_s15_q;
  logic and_2628_s15_q;
  logic not_2649_s15_q;
  logic and_2650_s15_q;
  logic and_2652_s15_q;
  logic and_2653_s15_q;
  logic and_2692_s15_q;
  logic and_2700_s15_q;
  logic and_2724_s15_q;
  logic select_2735_s15_q;
  logic select_2738_s15_q;
  logic and_2739_s15_q;
  logic and_2788_s15_q;
  logic and_2789_s15_q;
  logic [11:0] residual_s15_q;
  logic equal_2851_s15_q;
  logic [3:0] not_2852_s15_q;
  logic [1:0] quarter_2_s15_q;
  logic and_3025_s15_q;
  logic less_3151_s15_q;
  logic and_3574_s15_q;
  logic [9:0] select_3580_s15_q;
  logic [4:0] select_3581_s15_q;
  logic [4:0] select_3582_s15_q;
  logic equal_3591_s15_q;
  logic less_3619_s15_q;
  logic less_3622_s15_q;
  logic equal_3902_s15_q;
  logic equal_3919_s15_q;
  logic equal_3926_s15_q;
  logic equal_3929_s15_q;
  logic equal_3930_s15_q;
  logic equal_3931_s15_q;
  logic [7:0] select_3955_s15_q;
  logic or_4077_s15_q;
  logic and_4091_s15_q;
  logic and_4108_s15_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s15_q <= sample_pair_pixel_0_q;
      pixel_1_s15_q <= sample_pair_pixel_1_q;
      saturated_s15_q <= saturated_s14_q;
      marks_first_s15_q <= marks_first_s14_q;
      marks_last_s15_q <= marks_last_s14_q;
      sample_pair_pixel_0_s15_q <= sample_pair_pixel_0_s14_q;
      sample_pair_pixel_1_s15_q <= sample_pair_pixel_1_s14_q;
      sample_pair_whole_s15_q <= sample_pair_whole_s14_q;
      sample_present_s15_q <= sample_present_s14_q;
      moments_starts_s15_q <= moments_starts_s14_q;
      run_shift_s15_q <= run_shift_s14_q;
      x_s15_q <= x_s14_q;
      age_s15_q <= age_s14_q;
      slot_s15_q <= slot_s14_q;
      ends_cell_s15_q <= ends_cell_s14_q;
      lower_half_s15_q <= lower_half_s14_q;
      registration_of_right_s15_q <= registration_of_right_q;
      patches_choosing_band_s15_q <= patches_choosing_band_s14_q;
      patches_lower_s15_q <= patches_lower_s14_q;
      patches_second_s15_q <= patches_second_s14_q;
      patches_code_row_s15_q <= patches_code_row_s14_q;
      patches_along_s15_q <= patches_along_s14_q;
      patches_match_row_s15_q <= patches_match_row_s14_q;
      patches_summed_last_s15_q <= patches_summed_last_s14_q;
      patches_summed_down_by_s15_q <= patches_summed_down_by_q;
      patches_read_first_s15_q <= patches_read_first_s14_q;
      region_row_s15_q <= region_row_s14_q;
      region_fresh_s15_q <= region_fresh_s14_q;
      centres_values_1_textured_s15_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s15_q <= centres_values_1_of_skin_q;
      proven_s15_q <= proven_s14_q;
      select_514_s15_q <= select_514_s14_q;
      row_starts_s15_q <= row_starts_s14_q;
      select_519_s15_q <= select_519_s14_q;
      and_528_s15_q <= and_528_s14_q;
      and_529_s15_q <= and_529_s14_q;
      sum_536_s15_q <= sum_536;
      sum_540_s15_q <= sum_540;
      and_544_s15_q <= whole & (averager_memory_rdata_s14_q[28] | equal_534_s14_q);
      and_548_s15_q <= and_548;
      select_549_s15_q <= select_549_s14_q;
      last_s15_q <= last_s14_q;
      and_553_s15_q <= and_553_s14_q;
      and_555_s15_q <= and_555_s14_q;
      equal_558_s15_q <= select_514_s14_q == 4'h3;
      equal_575_s15_q <= equal_575_s14_q;
      equal_580_s15_q <= equal_580_s14_q;
      not_581_s15_q <= not_581_s14_q;
      so_s15_q <= so_s14_q;
      not_583_s15_q <= not_583_s14_q;
      equal_584_s15_q <= equal_584_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      not_593_s15_q <= not_593_s14_q;
      moments_memory_rdata_s15_q <= moments_memory_rdata_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q[14:0];
      and_641_s15_q <= and_641;
      and_648_s15_q <= and_648_s14_q;
      and_656_s15_q <= and_656_s14_q;
      equal_689_s15_q <= equal_689_s14_q;
      of_best_s15_q <= of_best_s14_q;
      or_1527_s15_q <= select_772_s14_q | (best_left_rdata_s14_q[16:9] < of_best_s14_q);
      select_1532_s15_q <= select_1532_s14_q;
      select_1541_s15_q <= select_1541;
      select_1544_s15_q <= select_1544;
      select_1563_s15_q <= select_772_s14_q ? of_near_s14_q : select_1562_s14_q;
      select_1565_s15_q <= select_772_s14_q ? run_shift_s14_q : select_1564_s14_q;
      select_1568_s15_q <= (run_shift_s14_q == 6'h3f) ? of_best_s14_q : select_1567_s14_q;
      select_1571_s15_q <= (run_shift_s14_q == 6'h1) ? of_best_s14_q : select_1570_s14_q;
      and_1572_s15_q <= and_1572_s14_q;
      or_1576_s15_q <= or_1576;
      select_1581_s15_q <= or_1580_s14_q ? of_near_s14_q : best_right_rdata_s14_q[21:15];
      select_1582_s15_q <= or_1580_s14_q ? x_s14_2_q : best_right_rdata_s14_q[28:22];
      and_1585_s15_q <= and_1585_s14_q;
      select_1589_s15_q <= select_1589_s14_q;
      and_1596_s15_q <= and_1596;
      and_1600_s15_q <= and_1600;
      and_1611_s15_q <= and_1611_s14_q;
      equal_1618_s15_q <= equal_1618_s14_q;
      quarter_s15_q <= quarter;
      all_s15_q <= all_s14_q;
      sum_1624_s15_q <= sum_1624;
      select_1625_s15_q <= select_1625;
      equal_1626_s15_q <= equal_1626;
      equal_1628_s15_q <= equal_1628;
      equal_1630_s15_q <= equal_1630;
      equal_1632_s15_q <= equal_1632_s14_q;
      equal_1634_s15_q <= equal_1634_s14_q;
      equal_1636_s15_q <= equal_1636_s14_q;
      equal_1638_s15_q <= equal_1638_s14_q;
      equal_1640_s15_q <= equal_1640_s14_q;
      less_1649_s15_q <= less_1649;
      or_1653_s15_q <= or_1653;
      select_1656_s15_q <= equal_1618_s14_q ? and_1648 : (less_1649 & (~or_1653));
      and_1666_s15_q <= half_ends & ({{3{sum_1664[4]}}, sum_1664} < 8'h3);
      select_1671_s15_q <= select_1671;
      select_1700_s15_q <= select_1700_s14_q;
      equal_1701_s15_q <= equal_1701_s14_q;
      sum_1705_s15_q <= sum_1705_s14_q;
      and_1709_s15_q <= and_1709_s14_q;
      equal_1711_s15_q <= equal_1711_s14_q;
      and_1745_s15_q <= (less_1710_s14_q & (and_641 & less_1727)) & and_1744;
      select_1758_s15_q <= select_1758_s14_q;
      select_1783_s15_q <= select_1783_s14_q;
      and_1789_s15_q <= and_1789;
      and_1790_s15_q <= and_1790;
      equal_1791_s15_q <= equal_1791_s14_q;
      not_1792_s15_q <= not_1792_s14_q;
      equal_1793_s15_q <= equal_1793_s14_q;
      not_1794_s15_q <= not_1794_s14_q;
      equal_1796_s15_q <= equal_1796_s14_q;
      or_1797_s15_q <= or_1797_s14_q;
      not_1798_s15_q <= not_1798_s14_q;
      and_1806_s15_q <= and_1790 & equal_1805_s14_q;
      equal_1808_s15_q <= equal_1808_s14_q;
      less_1811_s15_q <= less_1811_s14_q;
      select_1826_s15_q <= select_1826_s14_q;
      select_1832_s15_q <= select_1832_s14_q;
      select_1870_s15_q <= select_1870_s14_q;
      patches_columns_above_rdata_s15_q <= patches_columns_above_rdata_s14_q[8];
      pixel_2_s15_q <= pixel_2_s14_q;
      less_1886_s15_q <= less_1886;
      new_row_s15_q <= new_row;
      select_1892_s15_q <= select_1892;
      not_1893_s15_q <= ~or_1887;
      select_1898_s15_q <= select_1898;
      or_1899_s15_q <= equal_1795_s14_q | equal_1793_s14_q;
      of_row_2_s15_q <= of_row_2;
      down_2_s15_q <= down_2;
      sum_1929_s15_q <= sum_1929_s14_q[0];
      sum_1930_s15_q <= sum_1930;
      and_1957_s15_q <= or_1797_s14_q & (or_1949 & (equal_1796_s14_q & and_1954));
      and_1968_s15_q <= and_1968;
      and_1971_s15_q <= or_1797_s14_q & (and_1968 & (patches_column_s14_q == 5'hf));
      less_1974_s15_q <= less_1974_s14_q;
      or_1977_s15_q <= or_1977_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      or_1991_s15_q <= or_1991_s14_q;
      or_1994_s15_q <= or_1994_s14_q;
      or_1997_s15_q <= or_1997_s14_q;
      not_1999_s15_q <= not_1999_s14_q;
      not_2012_s15_q <= not_2012_s14_q;
      and_2014_s15_q <= inside_v_s14_q & (and_2011_s14_q & not_2012_s14_q);
      and_2028_s15_q <= and_2028;
      and_2036_s15_q <= and_2036_s14_q;
      seen_columns_rdata_s15_q <= seen_columns_rdata_s14_q;
      textured_s15_q <= textured;
      shown_s15_q <= shown;
      near_s15_q <= near;
      not_2066_s15_q <= not_2066_s14_q;
      select_2078_s15_q <= draws_late_s14_q ? read_half_q : write_half_q;
      and_2080_s15_q <= and_2080_s14_q;
      and_2082_s15_q <= and_2082_s14_q;
      or_2097_s15_q <= or_2097_s14_q;
      or_2100_s15_q <= or_2100_s14_q;
      or_2103_s15_q <= or_2103_s14_q;
      and_2114_s15_q <= and_2114_s14_q;
      and_2116_s15_q <= seen_columns_rdata_s14_q[7] & inside_v_s14_q;
      and_2117_s15_q <= seen_columns_rdata_s14_q[3] & inside_v_s14_q;
      and_2130_s15_q <= and_2130_s14_q;
      and_2132_s15_q <= seen_columns_rdata_s14_q[8] & inside_v_s14_q;
      and_2133_s15_q <= seen_columns_rdata_s14_q[4] & inside_v_s14_q;
      and_2153_s15_q <= ends_cell_s14_q & select_2152;
      equal_2298_s15_q <= equal_2298_s14_q;
      equal_2486_s15_q <= equal_2486_s14_q;
      and_2628_s15_q <= not_581_s14_q & (so_s14_q & and_2626);
      not_2649_s15_q <= not_2649;
      and_2650_s15_q <= and_2650_s14_q;
      and_2652_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      and_2653_s15_q <= seen_columns_rdata_s14_q[2] & inside_v_s14_q;
      and_2692_s15_q <= so_s14_q & and_2691;
      and_2700_s15_q <= not_581_s14_q & (so_s14_q & (ends_cell_s14_q & and_2697));
      and_2724_s15_q <= (or_585_s14_q & (not_589_s14_q & and_2721)) & not_2012_s14_q;
      select_2735_s15_q <= select_2735[1];
      select_2738_s15_q <= select_2738[1];
      and_2739_s15_q <= select_2735[0] & select_2738[0];
      and_2788_s15_q <= not_581_s14_q & (so_s14_q & (half_ends & equal_2785));
      and_2789_s15_q <= and_641 & less_1710_s14_q;
      residual_s15_q <= residual;
      equal_2851_s15_q <= sum_1624 == 2'h2;
      not_2852_s15_q <= ~select_1671;
      quarter_2_s15_q <= quarter_2;
      and_3025_s15_q <= not_581_s14_q & (so_s14_q & and_3023);
      less_3151_s15_q <= 4'he < patches_column_s14_q[4:1];
      and_3574_s15_q <= equal_1975_s14_q & ({sum_3572[6], sum_3572} < 8'hfb);
      select_3580_s15_q <= select_3580_s14_q;
      select_3581_s15_q <= select_3581_s14_q;
      select_3582_s15_q <= patches_peak_row_q;
      equal_3591_s15_q <= equal_3591_s14_q;
      less_3619_s15_q <= select_3584 < select_3586;
      less_3622_s15_q <= select_3586 < select_3584;
      equal_3902_s15_q <= equal_3902_s14_q;
      equal_3919_s15_q <= equal_3919_s14_q;
      equal_3926_s15_q <= equal_3926;
      equal_3929_s15_q <= equal_3929;
      equal_3930_s15_q <= equal_3930;
      equal_3931_s15_q <= equal_3931_s14_q;
      select_3955_s15_q <= equal_3929 ? {cfg_on_skin_limit_i, 3'h0} : select_3954;
      or_4077_s15_q <= or_4077_s14_q;
      and_4091_s15_q <= and_4091_s14_q;
      and_4108_s15_q <= and_4108_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [3:0] census_filled_q;
  logic moments_has_before_q;
  logic [4:0] rows_passed_above_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic [3:0] registration_fresh_q;
  logic patches_fixed_q;
  logic [7:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [9:0] patches_read_far_q;
  logic segment_started_q;
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_528_s15_q ? sum_536_s15_q[13:5] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_558_s15_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_528_s15_q ? sum_540_s15_q[13:5] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_558_s15_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:218
  logic and_566;
  assign and_566 = and_528_s15_q & and_544_s15_q;
  // hls/stages/census.hpp:134
  logic select_568;
  assign select_568 = equal_558_s15_q ? and_566 : (averager_mask_q & and_566);
  // hls/stages/agreement.hpp:277
  logic whole_2;
  assign whole_2 = sample_pair_whole_s15_q & select_568;
  // hls/stages/census.hpp:218
  logic and_570;
  assign and_570 = and_528_s15_q & and_548_s15_q;
  // hls/stages/census.hpp:134
  logic select_572;
  assign select_572 = equal_558_s15_q ? and_570 : (averager_of_skin_q & and_570);
  // hls/stages/agreement.hpp:460
  logic equal_686;
  assign equal_686 = last_s15_q == 7'h0;
  logic [3:0] select_690;
  assign select_690 = equal_689_s15_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
  logic [4:0] select_691;
  assign select_691 = equal_686 ? {select_690, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_692;
  assign select_692 = equal_686 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:799
  logic and_1597;
  assign and_1597 = not_583_s15_q & and_1596_s15_q;
  // hls/stages/moments.hpp:85
  logic and_1604;
  assign and_1604 = moments_has_before_q & moments_memory_rdata_s15_q[0];
  // hls/stages/agreement.hpp:1016
  logic and_1608;
  assign and_1608 = not_593_s15_q & (and_1604 & (moments_memory_rdata_s15_q[1] ^ and_648_s15_q));
  // hls/stages/moments.hpp:85
  logic and_1613;
  assign and_1613 = moments_has_before_q & moments_memory_rdata_s15_q[2];
  // hls/stages/agreement.hpp:1016
  logic and_1617;
  assign and_1617 = not_593_s15_q & (and_1613 & (moments_memory_rdata_s15_q[3] ^ and_656_s15_q));
  // hls/stages/agreement.hpp:799
  logic and_1667;
  assign and_1667 = so_s15_q & and_1666_s15_q;
  logic and_1748;
  assign and_1748 = not_581_s15_q & (so_s15_q & (ends_cell_s15_q & and_1745_s15_q));
  // hls/stages/patches.hpp:157
  logic and_1750;
  assign and_1750 = and_1748 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:799
  logic [7:0] select_1753;
  assign select_1753 = so_s15_q ? (ends_cell_s15_q ? {sum_1705_s15_q, x_s15_q[0]} : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:351
  logic [7:0] select_1755;
  assign select_1755 = and_1750 ? (equal_580_s15_q ? 8'h0 : select_1753) : patches_choice_column_q;
  // hls/stages/patches.hpp:480
  logic [11:0] sum_1911;
  assign sum_1911 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1912;
  assign sum_1912 = {{4{down_2_s15_q[10]}}, down_2_s15_q[10:2]} + {sum_1911[11], sum_1911};
  // hls/stages/patches.hpp:477
  logic [11:0] smooth;
  assign smooth = {sum_1930_s15_q, sum_1929_s15_q, patches_columns_above_rdata_s15_q} + {4'h0, pixel_2_s15_q};
  // hls/stages/agreement.hpp:263
  logic and_2031;
  assign and_2031 = inside_v_s15_q & (not_2012_s15_q & (and_2028_s15_q & and_1596_s15_q));
  logic and_2039;
  assign and_2039 = inside_v_s15_q & and_2028_s15_q;
  logic explained;
  assign explained = inside_v_s15_q & and_641_s15_q;
  // hls/stages/agreement.hpp:1045
  logic and_2083;
  assign and_2083 = seen_columns_rdata_s15_q[0] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1103
  logic [1:0] sum_2085;
  assign sum_2085 = {1'b0, and_2082_s15_q} + ({1'b0, textured_s15_q} + {1'b0, and_2083});
  // hls/stages/agreement.hpp:1045
  logic and_2115;
  assign and_2115 = seen_columns_rdata_s15_q[11] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1105
  logic [1:0] sum_2119;
  assign sum_2119 = {1'b0, and_2116_s15_q} + ({1'b0, shown_s15_q} + {1'b0, and_2117_s15_q});
  // hls/stages/agreement.hpp:1045
  logic and_2131;
  assign and_2131 = seen_columns_rdata_s15_q[12] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1106
  logic [1:0] sum_2135;
  assign sum_2135 = {1'b0, and_2132_s15_q} + ({1'b0, near_s15_q} + {1'b0, and_2133_s15_q});
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2189;
  assign select_2189 = sample_pair_whole_s15_q ? (and_553_s15_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2191;
  assign select_2191 = sample_pair_whole_s15_q ? (and_553_s15_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2213;
  assign select_2213 = sample_pair_whole_s15_q ? (and_553_s15_q ? select_568 : averager_mask_q) : averager_mask_q;
  logic select_2215;
  assign select_2215 = sample_pair_whole_s15_q ? (and_553_s15_q ? select_572 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:799
  logic select_2318;
  assign select_2318 = equal_580_s15_q ? (moments_has_before_q | equal_1808_s15_q) : moments_has_before_q;
  // hls/stages/agreement.hpp:531
  logic and_2621;
  assign and_2621 = and_555_s15_q & (equal_689_s15_q & equal_2486_s15_q);
  // hls/stages/agreement.hpp:799
  logic and_2633;
  assign and_2633 = not_581_s15_q & (so_s15_q & (ends_cell_s15_q & and_2014_s15_q));
  // hls/stages/agreement.hpp:1045
  logic and_2651;
  assign and_2651 = seen_columns_rdata_s15_q[10] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1104
  logic [1:0] sum_2655;
  assign sum_2655 = {1'b0, and_2652_s15_q} + ({1'b0, explained} + {1'b0, and_2653_s15_q});
  // hls/stages/agreement.hpp:799
  logic and_2693;
  assign and_2693 = not_581_s15_q & and_2692_s15_q;
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2695;
  assign select_2695 = and_2621 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2693});
  logic [13:0] select_2702;
  assign select_2702 = and_2621 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2700_s15_q});
  // hls/stages/agreement.hpp:799
  logic and_2728;
  assign and_2728 = not_581_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_2724_s15_q)));
  // hls/stages/agreement.hpp:1042
  logic and_2740;
  assign and_2740 = and_641_s15_q & and_2739_s15_q;
  // hls/stages/agreement.hpp:263
  logic and_2743;
  assign and_2743 = inside_v_s15_q & (not_2012_s15_q & (select_2735_s15_q & and_2740));
  logic and_2751;
  assign and_2751 = inside_v_s15_q & (not_2012_s15_q & (select_2738_s15_q & and_2740));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2823;
  assign difference_2823 = 13'h0 - {residual_s15_q[11], residual_s15_q};
  logic less_2838;
  assign less_2838 = $signed(difference_2823) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2854;
  assign select_2854 = equal_2851_s15_q ? (registration_fresh_q & not_2852_s15_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:799
  logic [3:0] select_2856;
  assign select_2856 = so_s15_q ? (and_1666_s15_q ? select_2854 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2858;
  assign select_2858 = and_2621 ? 4'hf : (equal_580_s15_q ? registration_fresh_q : select_2856);
  // hls/stages/registration.hpp:258
  logic not_2878;
  assign not_2878 = ~quarter_2_s15_q[1];
  logic [3:0] select_2879;
  assign select_2879 = quarter_2_s15_q[0] ? {quarter_2_s15_q[1], 1'b0, not_2878, 1'b0} : {1'b0, quarter_2_s15_q[1], 1'b0, not_2878};
  // hls/stages/patches.hpp:352
  logic not_3016;
  assign not_3016 = ~and_1789_s15_q;
  // hls/stages/agreement.hpp:276
  logic [10:0] select_3129;
  assign select_3129 = equal_1793_s15_q ? patches_down_values_0_q : (or_1797_s15_q ? down_2_s15_q : patches_down_values_0_q);
  logic [10:0] select_3131;
  assign select_3131 = or_1797_s15_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3133;
  assign select_3133 = equal_1791_s15_q ? patches_down_values_1_q : (equal_1793_s15_q ? patches_down_values_1_q : select_3131);
  // hls/stages/patches.hpp:564
  logic [9:0] select_3576;
  assign select_3576 = or_1977_s15_q ? (and_3574_s15_q ? patches_rows_rdata_s15_q : 10'h3ff) : 10'h3ff;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3578;
  assign select_3578 = equal_1791_s15_q ? (less_1974_s15_q ? select_3576 : 10'h3ff) : patches_read_far_q;
  // hls/stages/patches.hpp:586
  logic [9:0] high;
  assign high = less_3619_s15_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = less_3622_s15_q ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:587
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3580_s15_q;
  // hls/stages/agreement.hpp:1253
  logic equal_3687;
  assign equal_3687 = x_s15_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1247
  logic equal_3928;
  assign equal_3928 = x_s15_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1142
  logic [7:0] limit;
  assign limit = equal_3928 ? cfg_regions_limit_i : select_3955_s15_q;
  // hls/stages/agreement.hpp:1261
  logic not_3957;
  assign not_3957 = ~x_s15_q[2];
  logic [3:0] select_3958;
  assign select_3958 = x_s15_q[1] ? {x_s15_q[2], 1'b0, not_3957, 1'b0} : {1'b0, x_s15_q[2], 1'b0, not_3957};
  logic [7:0] select_3959;
  assign select_3959 = x_s15_q[0] ? {select_3958[3], 1'b0, select_3958[2], 1'b0, select_3958[1], 1'b0, select_3958[0], 1'b0} : {1'b0, select_3958[3], 1'b0, select_3958[2], 1'b0, select_3958[1], 1'b0, select_3958[0]};
  // hls/stages/agreement.hpp:1142
  logic [13:0] select_3963;
  assign select_3963 = equal_3930_s15_q ? counts_skin_supervised_q : (equal_3931_s15_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3965;
  assign select_3965 = equal_3929_s15_q ? counts_skin_textured_q : (equal_3926_s15_q ? counts_textured_q : select_3963);
  logic [13:0] of;
  assign of = equal_3928 ? counts_textured_q : select_3965;
  // hls/stages/agreement.hpp:1181
  logic [14:0] sum_4156;
  assign sum_4156 = {1'b0, counts_skin_textured_q} + {2'h0, counts_skin_textured_q[13:1]};
  // hls/stages/registration.hpp:258
  logic not_4176;
  assign not_4176 = ~quarter_s15_q[1];
  logic [3:0] select_4177;
  assign select_4177 = quarter_s15_q[0] ? {quarter_s15_q[1], 1'b0, not_4176, 1'b0} : {1'b0, quarter_s15_q[1], 1'b0, not_4176};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1625_s15_q;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s15_en & (equal_580_s15_q ? (x_s15_q[6] & select_1656_s15_q) : and_1667);
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:811; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1898_s15_q, not_1893_s15_q, select_1892_s15_q};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s15_en & or_1899_s15_q;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:812; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_s15_q;
`ifndef SYNTHESIS
  logic patches_left_codes_re;
  assign patches_left_codes_re = s15_en & (not_1792_s15_q & (new_row_s15_q & equal_1793_s15_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_519_s15_q;
  logic averager_memory_we;
  assign averager_memory_we = s15_en & and_529_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_548_s15_q, and_544_s15_q, sum_540_s15_q, sum_536_s15_q};
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

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1589_s15_q;
  logic shown_right_we;
  assign shown_right_we = s15_en & and_1600_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1597, not_583_s15_q};
  end
`ifndef SYNTHESIS
  logic [6:0] shown_right_raddr_s13_sim;
  logic shown_right_re_s13_sim;
  logic [6:0] shown_right_raddr_s14_sim;
  logic shown_right_re_s14_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      shown_right_re_s13_sim <= 1'b0;
      shown_right_re_s14_sim <= 1'b0;
    end else if (en_i) begin
      shown_right_re_s13_sim <= shown_right_re;
      shown_right_raddr_s13_sim <= shown_right_raddr;
      shown_right_re_s14_sim <= shown_right_re_s13_sim;
      shown_right_raddr_s14_sim <= shown_right_raddr_s13_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_re_s13_sim && shown_right_raddr_s13_sim == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_re_s14_sim && shown_right_raddr_s14_sim == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 7'd120) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 7'd120) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s15_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s15_en & and_1585_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s15_q, near_s15_q, shown_s15_q, explained, and_2039, textured_s15_q};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s12_sim;
  logic seen_columns_re_s12_sim;
  logic [6:0] seen_columns_raddr_s13_sim;
  logic seen_columns_re_s13_sim;
  logic [6:0] seen_columns_raddr_s14_sim;
  logic seen_columns_re_s14_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s12_sim <= 1'b0;
      seen_columns_re_s13_sim <= 1'b0;
      seen_columns_re_s14_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s12_sim <= seen_columns_re;
      seen_columns_raddr_s12_sim <= seen_columns_raddr;
      seen_columns_re_s13_sim <= seen_columns_re_s12_sim;
      seen_columns_raddr_s13_sim <= seen_columns_raddr_s12_sim;
      seen_columns_re_s14_sim <= seen_columns_re_s13_sim;
      seen_columns_raddr_s14_sim <= seen_columns_raddr_s13_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s12_sim && seen_columns_raddr_s12_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s13_sim && seen_columns_raddr_s13_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s14_sim && seen_columns_raddr_s14_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_waddr >= 7'd120) $error("seen_columns: write outside, address %0d", seen_columns_waddr);
    end
    if (rst_ni && seen_columns_re && seen_columns_raddr >= 7'd120) $error("seen_columns: read outside, address %0d", seen_columns_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      census_filled_q <= 4'h0;
      moments_has_before_q <= 1'b0;
      rows_passed_above_q <= 5'h0;
      counts_textured_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
      registration_fresh_q <= 4'hf;
      patches_fixed_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      patches_read_far_q <= 10'h3ff;
      segment_started_q <= 1'b0;
    end else if (s15_en) begin
      averager_mask_q <= select_2213;
      averager_of_skin_q <= select_2215;
      census_filled_q <= and_555_s15_q ? {select_692[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2318;
      rows_passed_above_q <= and_555_s15_q ? select_691 : rows_passed_above_q;
      counts_textured_q <= and_2621 ? 14'h0 : (counts_textured_q + {13'h0, and_2633});
      counts_skin_supervised_q <= select_2695;
      counts_skin_textured_q <= select_2702;
      registration_fresh_q <= select_2858;
      patches_fixed_q <= not_3016 & (patches_fixed_q | (and_3025_s15_q & and_1750));
      patches_choice_column_q <= select_1755;
      patches_choice_shift_q <= and_1750 ? select_1758_s15_q : patches_choice_shift_q;
      patches_choice_slope_q <= and_1750 ? select_1783_s15_q : patches_choice_slope_q;
      patches_down_values_0_q <= equal_1791_s15_q ? patches_down_values_0_q : select_3129;
      patches_down_values_1_q <= select_3133;
      patches_read_far_q <= select_3578;
      segment_started_q <= ~segment_starts_q;
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
      averager_total_0_q <= select_2189;
      averager_total_1_q <= select_2191;
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
  logic moments_starts_s16_q;
  logic [7:0] x_s16_q;
  logic age_s16_q;
  logic [2:0] slot_s16_q;
  logic ends_cell_s16_q;
  logic lower_half_s16_q;
  logic [13:0] counts_textured_s16_q;
  logic registration_of_right_s16_q;
  logic [4:0] patches_choosing_band_s16_q;
  logic patches_lower_s16_q;
  logic patches_second_s16_q;
  logic [4:0] patches_code_row_s16_q;
  logic [10:0] patches_down_values_1_s16_q;
  logic [4:0] patches_along_s16_q;
  logic patches_summed_last_s16_q;
  logic [4:0] patches_summed_down_by_s16_q;
  logic patches_read_first_s16_q;
  logic [9:0] patches_read_far_s16_q;
  logic [2:0] region_row_s16_q;
  logic region_fresh_s16_q;
  logic segment_started_s16_q;
  logic centres_values_1_textured_s16_q;
  logic centres_values_1_of_skin_s16_q;
  logic proven_s16_q;
  logic [3:0] select_514_s16_q;
  logic row_starts_s16_q;
  logic [6:0] select_549_s16_q;
  logic [6:0] last_s16_q;
  logic and_553_s16_q;
  logic and_555_s16_q;
  logic [77:0] census_memory_rdata_s16_q;
  logic [8:0] grey_s16_q;
  logic equal_558_s16_q;
  logic [8:0] select_561_s16_q;
  logic [8:0] grey_2_s16_q;
  logic [8:0] select_565_s16_q;
  logic whole_2_s16_q;
  logic and_573_s16_q;
  logic equal_575_s16_q;
  logic equal_580_s16_q;
  logic not_581_s16_q;
  logic so_s16_q;
  logic not_583_s16_q;
  logic equal_584_s16_q;
  logic inside_v_s16_q;
  logic [6:0] x_s16_2_q;
  logic [6:0] right_s16_q;
  logic and_693_s16_q;
  logic [5:0] select_1528_s16_q;
  logic [2:0] select_1533_s16_q;
  logic [7:0] select_1534_s16_q;
  logic [7:0] select_1542_s16_q;
  logic [7:0] select_1545_s16_q;
  logic [6:0] select_1563_s16_q;
  logic [5:0] select_1565_s16_q;
  logic [7:0] select_1568_s16_q;
  logic [7:0] select_1571_s16_q;
  logic and_1572_s16_q;
  logic [7:0] select_1577_s16_q;
  logic [6:0] select_1578_s16_q;
  logic [6:0] select_1581_s16_q;
  logic [6:0] select_1582_s16_q;
  logic and_1605_s16_q;
  logic and_1608_s16_q;
  logic and_1611_s16_q;
  logic and_1614_s16_q;
  logic and_1617_s16_q;
  logic equal_1618_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1624_s16_q;
  logic equal_1626_s16_q;
  logic equal_1628_s16_q;
  logic equal_1630_s16_q;
  logic equal_1632_s16_q;
  logic equal_1634_s16_q;
  logic equal_1636_s16_q;
  logic equal_1638_s16_q;
  logic equal_1640_s16_q;
  logic less_1649_s16_q;
  logic or_1653_s16_q;
  logic equal_1673_s16_q;
  logic and_1683_s16_q;
  logic select_1700_s16_q;
  logic equal_1701_s16_q;
  logic [22:0] patches_choices_rdata_s16_q;
  logic and_1709_s16_q;
  logic equal_1711_s16_q;
  logic and_1748_s16_q;
  logic and_1750_s16_q;
  logic and_1789_s16_q;
  logic and_1790_s16_q;
  logic equal_1791_s16_q;
  logic equal_1793_s16_q;
  logic equal_1796_s16_q;
  logic or_1797_s16_q;
  logic not_1798_s16_q;
  logic and_1806_s16_q;
  logic equal_1808_s16_q;
  logic less_1811_s16_q;
  logic [4:0] select_1826_s16_q;
  logic select_1832_s16_q;
  logic [3:0] select_1870_s16_q;
  logic less_1886_s16_q;
  logic new_row_s16_q;
  logic or_1899_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic [1:0] down_2_s16_q;
  logic [12:0] sum_1912_s16_q;
  logic [11:0] smooth_s16_q;
  logic and_1959_s16_q;
  logic and_1968_s16_q;
  logic and_1973_s16_q;
  logic or_1991_s16_q;
  logic or_1994_s16_q;
  logic or_1997_s16_q;
  logic not_1999_s16_q;
  logic [29:0] regions_rdata_s16_q;
  logic and_2014_s16_q;
  logic and_2020_s16_q;
  logic and_2031_s16_q;
  logic and_2036_s16_q;
  logic select_2064_s16_q;
  logic not_2066_s16_q;
  logic select_2078_s16_q;
  logic and_2080_s16_q;
  logic and_2081_s16_q;
  logic [1:0] sum_2085_s16_q;
  logic or_2097_s16_q;
  logic or_2100_s16_q;
  logic or_2103_s16_q;
  logic and_2114_s16_q;
  logic [2:0] sum_2120_s16_q;
  logic and_2130_s16_q;
  logic [2:0] sum_2136_s16_q;
  logic and_2155_s16_q;
  logic equal_2298_s16_q;
  logic equal_2486_s16_q;
  logic and_2621_s16_q;
  logic and_2628_s16_q;
  logic and_2633_s16_q;
  logic not_2649_s16_q;
  logic and_2650_s16_q;
  logic [2:0] sum_2656_s16_q;
  logic and_2728_s16_q;
  logic and_2746_s16_q;
  logic and_2754_s16_q;
  logic and_2788_s16_q;
  logic and_2789_s16_q;
  logic [7:0] residual_s16_q;
  logic less_2824_s16_q;
  logic less_2838_s16_q;
  logic equal_2881_s16_q;
  logic not_3016_s16_q;
  logic less_3151_s16_q;
  logic equal_3494_s16_q;
  logic [9:0] select_3580_s16_q;
  logic [4:0] select_3581_s16_q;
  logic [4:0] select_3582_s16_q;
  logic equal_3591_s16_q;
  logic less_3619_s16_q;
  logic [9:0] eight_s16_q;
  logic [9:0] fall_2_s16_q;
  logic equal_3687_s16_q;
  logic and_3903_s16_q;
  logic equal_3919_s16_q;
  logic equal_3926_s16_q;
  logic equal_3928_s16_q;
  logic equal_3929_s16_q;
  logic equal_3930_s16_q;
  logic equal_3931_s16_q;
  logic equal_3961_s16_q;
  logic [13:0] of_s16_q;
  logic or_4077_s16_q;
  logic and_4091_s16_q;
  logic and_4108_s16_q;
  logic [13:0] sum_4156_s16_q;
  logic equal_4179_s16_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      moments_starts_s16_q <= moments_starts_s15_q;
      x_s16_q <= x_s15_q;
      age_s16_q <= age_s15_q;
      slot_s16_q <= slot_s15_q;
      ends_cell_s16_q <= ends_cell_s15_q;
      lower_half_s16_q <= lower_half_s15_q;
      counts_textured_s16_q <= counts_textured_q;
      registration_of_right_s16_q <= registration_of_right_s15_q;
      patches_choosing_band_s16_q <= patches_choosing_band_s15_q;
      patches_lower_s16_q <= patches_lower_s15_q;
      patches_second_s16_q <= patches_second_s15_q;
      patches_code_row_s16_q <= patches_code_row_s15_q;
      patches_down_values_1_s16_q <= patches_down_values_1_q;
      patches_along_s16_q <= patches_along_s15_q;
      patches_summed_last_s16_q <= patches_summed_last_s15_q;
      patches_summed_down_by_s16_q <= patches_summed_down_by_s15_q;
      patches_read_first_s16_q <= patches_read_first_s15_q;
      patches_read_far_s16_q <= patches_read_far_q;
      region_row_s16_q <= region_row_s15_q;
      region_fresh_s16_q <= region_fresh_s15_q;
      segment_started_s16_q <= segment_started_q;
      centres_values_1_textured_s16_q <= centres_values_1_textured_s15_q;
      centres_values_1_of_skin_s16_q <= centres_values_1_of_skin_s15_q;
      proven_s16_q <= proven_s15_q;
      select_514_s16_q <= select_514_s15_q;
      row_starts_s16_q <= row_starts_s15_q;
      select_549_s16_q <= select_549_s15_q;
      last_s16_q <= last_s15_q;
      and_553_s16_q <= and_553_s15_q;
      and_555_s16_q <= and_555_s15_q;
      census_memory_rdata_s16_q <= census_memory_rdata_q;
      grey_s16_q <= grey;
      equal_558_s16_q <= equal_558_s15_q;
      select_561_s16_q <= sample_pair_whole_s15_q ? total[10:2] : 9'h0;
      grey_2_s16_q <= grey_2;
      select_565_s16_q <= sample_pair_whole_s15_q ? total_2[10:2] : 9'h0;
      whole_2_s16_q <= whole_2;
      and_573_s16_q <= sample_pair_whole_s15_q & select_572;
      equal_575_s16_q <= equal_575_s15_q;
      equal_580_s16_q <= equal_580_s15_q;
      not_581_s16_q <= not_581_s15_q;
      so_s16_q <= so_s15_q;
      not_583_s16_q <= not_583_s15_q;
      equal_584_s16_q <= equal_584_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      x_s16_2_q <= x_s15_2_q;
      right_s16_q <= right_s15_q;
      and_693_s16_q <= select_691[4] & select_692[3];
      select_1528_s16_q <= or_1527_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[5:0];
      select_1533_s16_q <= or_1527_s15_q ? select_1532_s15_q : best_left_rdata_s15_q[8:6];
      select_1534_s16_q <= or_1527_s15_q ? of_best_s15_q : best_left_rdata_s15_q[16:9];
      select_1542_s16_q <= or_1527_s15_q ? select_1541_s15_q : best_left_rdata_s15_q[24:17];
      select_1545_s16_q <= or_1527_s15_q ? select_1544_s15_q : best_left_rdata_s15_q[32:25];
      select_1563_s16_q <= select_1563_s15_q;
      select_1565_s16_q <= select_1565_s15_q;
      select_1568_s16_q <= select_1568_s15_q;
      select_1571_s16_q <= select_1571_s15_q;
      and_1572_s16_q <= and_1572_s15_q;
      select_1577_s16_q <= or_1576_s15_q ? of_best_s15_q : best_right_rdata_s15_q[7:0];
      select_1578_s16_q <= or_1576_s15_q ? x_s15_2_q : best_right_rdata_s15_q[14:8];
      select_1581_s16_q <= select_1581_s15_q;
      select_1582_s16_q <= select_1582_s15_q;
      and_1605_s16_q <= not_593_s15_q & and_1604;
      and_1608_s16_q <= and_1608;
      and_1611_s16_q <= and_1611_s15_q;
      and_1614_s16_q <= not_593_s15_q & and_1613;
      and_1617_s16_q <= and_1617;
      equal_1618_s16_q <= equal_1618_s15_q;
      all_s16_q <= all_s15_q;
      sum_1624_s16_q <= sum_1624_s15_q;
      equal_1626_s16_q <= equal_1626_s15_q;
      equal_1628_s16_q <= equal_1628_s15_q;
      equal_1630_s16_q <= equal_1630_s15_q;
      equal_1632_s16_q <= equal_1632_s15_q;
      equal_1634_s16_q <= equal_1634_s15_q;
      equal_1636_s16_q <= equal_1636_s15_q;
      equal_1638_s16_q <= equal_1638_s15_q;
      equal_1640_s16_q <= equal_1640_s15_q;
      less_1649_s16_q <= less_1649_s15_q;
      or_1653_s16_q <= or_1653_s15_q;
      equal_1673_s16_q <= (registration_fresh_q & select_1671_s15_q) == 4'h0;
      and_1683_s16_q <= not_581_s15_q & and_1667;
      select_1700_s16_q <= select_1700_s15_q;
      equal_1701_s16_q <= equal_1701_s15_q;
      patches_choices_rdata_s16_q <= patches_choices_rdata_q;
      and_1709_s16_q <= and_1709_s15_q;
      equal_1711_s16_q <= equal_1711_s15_q;
      and_1748_s16_q <= and_1748;
      and_1750_s16_q <= and_1750;
      and_1789_s16_q <= and_1789_s15_q;
      and_1790_s16_q <= and_1790_s15_q;
      equal_1791_s16_q <= equal_1791_s15_q;
      equal_1793_s16_q <= equal_1793_s15_q;
      equal_1796_s16_q <= equal_1796_s15_q;
      or_1797_s16_q <= or_1797_s15_q;
      not_1798_s16_q <= not_1798_s15_q;
      and_1806_s16_q <= and_1806_s15_q;
      equal_1808_s16_q <= equal_1808_s15_q;
      less_1811_s16_q <= less_1811_s15_q;
      select_1826_s16_q <= select_1826_s15_q;
      select_1832_s16_q <= select_1832_s15_q;
      select_1870_s16_q <= select_1870_s15_q;
      less_1886_s16_q <= less_1886_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1899_s16_q <= or_1899_s15_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[1:0];
      sum_1912_s16_q <= sum_1912;
      smooth_s16_q <= smooth;
      and_1959_s16_q <= not_1792_s15_q & (not_1794_s15_q & and_1957_s15_q);
      and_1968_s16_q <= and_1968_s15_q;
      and_1973_s16_q <= not_1792_s15_q & (not_1794_s15_q & and_1971_s15_q);
      or_1991_s16_q <= or_1991_s15_q;
      or_1994_s16_q <= or_1994_s15_q;
      or_1997_s16_q <= or_1997_s15_q;
      not_1999_s16_q <= not_1999_s15_q;
      regions_rdata_s16_q <= regions_rdata_q;
      and_2014_s16_q <= and_2014_s15_q;
      and_2020_s16_q <= inside_v_s15_q & (and_641_s15_q & not_2012_s15_q);
      and_2031_s16_q <= and_2031;
      and_2036_s16_q <= and_2036_s15_q;
      select_2064_s16_q <= read_half_q;
      not_2066_s16_q <= not_2066_s15_q;
      select_2078_s16_q <= select_2078_s15_q;
      and_2080_s16_q <= and_2080_s15_q;
      and_2081_s16_q <= seen_columns_rdata_s15_q[9] & inside_v_s15_q;
      sum_2085_s16_q <= sum_2085;
      or_2097_s16_q <= or_2097_s15_q;
      or_2100_s16_q <= or_2100_s15_q;
      or_2103_s16_q <= or_2103_s15_q;
      and_2114_s16_q <= and_2114_s15_q;
      sum_2120_s16_q <= {2'h0, and_2115} + {1'b0, sum_2119};
      and_2130_s16_q <= and_2130_s15_q;
      sum_2136_s16_q <= {2'h0, and_2131} + {1'b0, sum_2135};
      and_2155_s16_q <= not_581_s15_q & (so_s15_q & and_2153_s15_q);
      equal_2298_s16_q <= equal_2298_s15_q;
      equal_2486_s16_q <= equal_2486_s15_q;
      and_2621_s16_q <= and_2621;
      and_2628_s16_q <= and_2628_s15_q;
      and_2633_s16_q <= and_2633;
      not_2649_s16_q <= not_2649_s15_q;
      and_2650_s16_q <= and_2650_s15_q;
      sum_2656_s16_q <= {2'h0, and_2651} + {1'b0, sum_2655};
      and_2728_s16_q <= and_2728;
      and_2746_s16_q <= not_581_s15_q & (so_s15_q & (ends_cell_s15_q & and_2743));
      and_2754_s16_q <= not_581_s15_q & (so_s15_q & (ends_cell_s15_q & and_2751));
      and_2788_s16_q <= and_2788_s15_q;
      and_2789_s16_q <= and_2789_s15_q;
      residual_s16_q <= residual_s15_q[7:0];
      less_2824_s16_q <= $signed(difference_2823) < $signed({7'h0, cfg_moved_limit_i});
      less_2838_s16_q <= less_2838;
      equal_2881_s16_q <= (registration_fresh_q & select_2879) == 4'h0;
      not_3016_s16_q <= not_3016;
      less_3151_s16_q <= less_3151_s15_q;
      equal_3494_s16_q <= patches_match_row_s15_q == 4'h0;
      select_3580_s16_q <= select_3580_s15_q;
      select_3581_s16_q <= select_3581_s15_q;
      select_3582_s16_q <= select_3582_s15_q;
      equal_3591_s16_q <= equal_3591_s15_q;
      less_3619_s16_q <= less_3619_s15_q;
      eight_s16_q <= eight;
      fall_2_s16_q <= fall_2;
      equal_3687_s16_q <= equal_3687;
      and_3903_s16_q <= equal_3902_s15_q & equal_3687;
      equal_3919_s16_q <= equal_3919_s15_q;
      equal_3926_s16_q <= equal_3926_s15_q;
      equal_3928_s16_q <= equal_3928;
      equal_3929_s16_q <= equal_3929_s15_q;
      equal_3930_s16_q <= equal_3930_s15_q;
      equal_3931_s16_q <= equal_3931_s15_q;
      equal_3961_s16_q <= (limit & select_3959) == 8'h0;
      of_s16_q <= of;
      or_4077_s16_q <= or_4077_s15_q;
      and_4091_s16_q <= and_4091_s15_q;
      and_4108_s16_q <= and_4108_s15_q;
      sum_4156_s16_q <= sum_4156[14:1];
      equal_4179_s16_q <= (registration_fresh_q & select_4177) == 4'h0;
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
  logic [13:0] moments_turned_0_q;
  logic [13:0] moments_turned_1_q;
  logic moments_turns_0_q;
  logic moments_turns_1_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [13:0] counts_explained_q;
  logic [13:0] counts_nearer_q;
  logic patches_choice_valid_q;
  logic [11:0] patches_smooth_values_0_q;
  logic [11:0] patches_smooth_values_1_q;
  logic [11:0] patches_smooth_values_2_q;
  logic [11:0] patches_smooth_values_3_q;
  logic [10:0] patches_down_values_2_q;
  logic [10:0] patches_down_values_3_q;
  logic [9:0] patches_peak_far_q;
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
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
  // hls/stages/census.hpp:308
  logic less_662;
  assign less_662 = census_memory_rdata_s16_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_663;
  assign less_663 = census_memory_rdata_s16_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_664;
  assign less_664 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_665;
  assign less_665 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_667;
  assign less_667 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_668;
  assign less_668 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_669;
  assign less_669 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_670;
  assign less_670 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_672;
  assign less_672 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_673;
  assign less_673 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_674;
  assign less_674 = census_memory_rdata_s16_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_675;
  assign less_675 = census_memory_rdata_s16_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_676;
  assign less_676 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_677;
  assign less_677 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_678;
  assign less_678 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_679;
  assign less_679 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_680;
  assign less_680 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_681;
  assign less_681 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_682;
  assign less_682 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_683;
  assign less_683 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_684;
  assign less_684 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_685;
  assign less_685 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:300
  logic and_695;
  assign and_695 = census_memory_rdata_s16_q[38] & (census_memory_rdata_s16_q[18] & whole_2_s16_q);
  logic and_697;
  assign and_697 = census_memory_rdata_s16_q[77] & (census_memory_rdata_s16_q[58] & and_695);
  // hls/stages/census.hpp:284
  logic [9:0] difference_720;
  assign difference_720 = {1'b0, select_561_s16_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_723;
  assign difference_723 = {1'b0, census_memory_rdata_s16_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_727;
  assign difference_727 = {1'b0, census_memory_rdata_s16_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_731;
  assign difference_731 = {1'b0, census_memory_rdata_s16_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_735;
  assign difference_735 = {1'b0, census_memory_rdata_s16_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/patches.hpp:351
  logic select_1751;
  assign select_1751 = and_1750_s16_q ? and_1748_s16_q : patches_choice_valid_q;
  // hls/stages/patches.hpp:360
  logic [22:0] select_1807;
  assign select_1807 = and_1806_s16_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1751} : patches_choices_rdata_s16_q;
  // hls/stages/patches.hpp:126
  logic is_chosen;
  assign is_chosen = select_1807[0] & less_1811_s16_q;
  // hls/stages/patches.hpp:480
  logic [13:0] sum_1913;
  assign sum_1913 = {{3{patches_down_values_1_s16_q[10]}}, patches_down_values_1_s16_q} + {sum_1912_s16_q, down_2_s16_q[1]};
  logic [12:0] sum_1914;
  assign sum_1914 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1913[13:1];
  // hls/stages/patches.hpp:479
  logic [12:0] sum_1932;
  assign sum_1932 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s16_q[11:1]};
  logic [12:0] sum_1933;
  assign sum_1933 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1934;
  assign difference_1934 = {1'b0, sum_1932, smooth_s16_q[0]} - {1'b0, sum_1933, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:911
  logic [6:0] select_2015;
  assign select_2015 = segment_started_s16_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:912
  logic [6:0] sum_2016;
  assign sum_2016 = {6'h0, and_2014_s16_q} + select_2015;
  // hls/stages/agreement.hpp:1077
  logic [9:0] sum_2018;
  assign sum_2018 = {3'h0, sum_2016} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[9:0]);
  // hls/stages/agreement.hpp:911
  logic [6:0] select_2021;
  assign select_2021 = segment_started_s16_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:912
  logic [6:0] sum_2022;
  assign sum_2022 = {6'h0, and_2020_s16_q} + select_2021;
  // hls/stages/agreement.hpp:1078
  logic [9:0] sum_2024;
  assign sum_2024 = {3'h0, sum_2022} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[19:10]);
  // hls/stages/agreement.hpp:911
  logic [6:0] select_2032;
  assign select_2032 = segment_started_s16_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:913
  logic [6:0] sum_2033;
  assign sum_2033 = {6'h0, and_2031_s16_q} + select_2032;
  // hls/stages/agreement.hpp:1079
  logic [9:0] sum_2035;
  assign sum_2035 = {3'h0, sum_2033} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[29:20]);
  // hls/stages/agreement.hpp:1306
  logic or_2047;
  assign or_2047 = marks_first_s16_q | line_ended_q;
  // hls/stages/agreement.hpp:1308
  logic [12:0] select_2049;
  assign select_2049 = marks_first_s16_q ? 13'h1 : (or_2047 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1307
  logic [8:0] select_2051;
  assign select_2051 = or_2047 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1315
  logic select_2053;
  assign select_2053 = cfg_compete_i ? (or_2047 & select_2049[12]) : (select_2051[8] & select_2049[9]);
  // hls/stages/agreement.hpp:1103
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2080_s16_q} + ({2'h0, and_2081_s16_q} + {1'b0, sum_2085_s16_q});
  // hls/stages/agreement.hpp:1105
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2114_s16_q} + sum_2120_s16_q;
  // hls/stages/agreement.hpp:1112
  logic [2:0] select_2122;
  assign select_2122 = age_s16_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1106
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2130_s16_q} + sum_2136_s16_q;
  // hls/stages/agreement.hpp:1113
  logic [2:0] select_2138;
  assign select_2138 = age_s16_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2181;
  assign select_2181 = sample_pair_whole_s16_q ? (and_553_s16_q ? grey_s16_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2183;
  assign select_2183 = sample_pair_whole_s16_q ? (and_553_s16_q ? grey_2_s16_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2185;
  assign select_2185 = sample_pair_whole_s16_q ? (and_553_s16_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2187;
  assign select_2187 = sample_pair_whole_s16_q ? (and_553_s16_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2192;
  assign sum_2192 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s16_q};
  logic [9:0] sum_2200;
  assign sum_2200 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s16_q};
  // hls/stages/agreement.hpp:531
  logic [8:0] select_2216;
  assign select_2216 = and_555_s16_q ? select_561_s16_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2217;
  assign select_2217 = and_555_s16_q ? select_565_s16_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2219;
  assign select_2219 = and_555_s16_q ? census_memory_rdata_s16_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2220;
  assign select_2220 = and_555_s16_q ? census_memory_rdata_s16_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2221;
  assign select_2221 = and_555_s16_q ? census_memory_rdata_s16_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2222;
  assign select_2222 = and_555_s16_q ? census_memory_rdata_s16_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2223;
  assign select_2223 = and_555_s16_q ? census_memory_rdata_s16_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2224;
  assign select_2224 = and_555_s16_q ? census_memory_rdata_s16_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2225;
  assign select_2225 = and_555_s16_q ? census_memory_rdata_s16_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2226;
  assign select_2226 = and_555_s16_q ? census_memory_rdata_s16_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2227;
  assign select_2227 = and_555_s16_q ? census_memory_rdata_s16_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2228;
  assign select_2228 = and_555_s16_q ? census_memory_rdata_s16_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2229;
  assign select_2229 = and_555_s16_q ? census_memory_rdata_s16_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2230;
  assign select_2230 = and_555_s16_q ? census_memory_rdata_s16_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2231;
  assign select_2231 = and_555_s16_q ? census_memory_rdata_s16_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2232;
  assign select_2232 = and_555_s16_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2233;
  assign select_2233 = and_555_s16_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2235;
  assign select_2235 = and_555_s16_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2236;
  assign select_2236 = and_555_s16_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2238;
  assign select_2238 = and_555_s16_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2239;
  assign select_2239 = and_555_s16_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2241;
  assign select_2241 = and_555_s16_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2242;
  assign select_2242 = and_555_s16_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2243;
  assign select_2243 = and_555_s16_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2245;
  assign select_2245 = and_555_s16_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2246;
  assign select_2246 = and_555_s16_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2248;
  assign select_2248 = and_555_s16_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2249;
  assign select_2249 = and_555_s16_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2251;
  assign select_2251 = and_555_s16_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2252;
  assign select_2252 = and_555_s16_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2254;
  assign select_2254 = and_555_s16_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2255;
  assign select_2255 = and_555_s16_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2257;
  assign select_2257 = and_555_s16_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2258;
  assign select_2258 = and_555_s16_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2260;
  assign select_2260 = and_555_s16_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2261;
  assign select_2261 = and_555_s16_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2264;
  assign select_2264 = and_555_s16_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2265;
  assign select_2265 = and_555_s16_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2268;
  assign select_2268 = and_555_s16_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2269;
  assign select_2269 = and_555_s16_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2273;
  assign difference_2273 = {1'b0, select_565_s16_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2276;
  assign difference_2276 = {1'b0, census_memory_rdata_s16_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2280;
  assign difference_2280 = {1'b0, census_memory_rdata_s16_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2284;
  assign difference_2284 = {1'b0, census_memory_rdata_s16_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2288;
  assign difference_2288 = {1'b0, census_memory_rdata_s16_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/moments.hpp:65
  logic [13:0] sum_2310;
  assign sum_2310 = {13'h0, moments_turns_0_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2312;
  assign sum_2312 = {13'h0, moments_turns_1_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:799
  logic and_2352;
  assign and_2352 = not_583_s16_q & (equal_584_s16_q & (inside_v_s16_q & and_1608_s16_q));
  logic and_2356;
  assign and_2356 = not_583_s16_q & (equal_584_s16_q & (inside_v_s16_q & and_1617_s16_q));
  // hls/stages/census.hpp:371
  logic [9:0] difference_2383;
  assign difference_2383 = {1'b0, select_561_s16_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2395;
  assign difference_2395 = {1'b0, select_565_s16_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:799
  logic and_2638;
  assign and_2638 = not_581_s16_q & (so_s16_q & (ends_cell_s16_q & and_2020_s16_q));
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2640;
  assign select_2640 = and_2621_s16_q ? 14'h0 : (counts_explained_q + {13'h0, and_2638});
  // hls/stages/agreement.hpp:799
  logic and_2643;
  assign and_2643 = not_581_s16_q & (so_s16_q & (ends_cell_s16_q & and_2031_s16_q));
  // hls/stages/agreement.hpp:1104
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2650_s16_q} + sum_2656_s16_q;
  // hls/stages/agreement.hpp:1111
  logic [2:0] select_2658;
  assign select_2658 = age_s16_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1149
  logic less_2674;
  assign less_2674 = region_row_s16_q < x_s16_q[5:3];
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3117;
  assign select_3117 = equal_1793_s16_q ? patches_smooth_values_0_q : (or_1797_s16_q ? smooth_s16_q : patches_smooth_values_0_q);
  logic [11:0] select_3119;
  assign select_3119 = or_1797_s16_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3121;
  assign select_3121 = equal_1791_s16_q ? patches_smooth_values_1_q : (equal_1793_s16_q ? patches_smooth_values_1_q : select_3119);
  logic [11:0] select_3122;
  assign select_3122 = or_1797_s16_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3124;
  assign select_3124 = equal_1791_s16_q ? patches_smooth_values_2_q : (equal_1793_s16_q ? patches_smooth_values_2_q : select_3122);
  logic [11:0] select_3125;
  assign select_3125 = or_1797_s16_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3127;
  assign select_3127 = equal_1791_s16_q ? patches_smooth_values_3_q : (equal_1793_s16_q ? patches_smooth_values_3_q : select_3125);
  logic [10:0] select_3134;
  assign select_3134 = or_1797_s16_q ? patches_down_values_1_s16_q : patches_down_values_2_q;
  logic [10:0] select_3136;
  assign select_3136 = equal_1791_s16_q ? patches_down_values_2_q : (equal_1793_s16_q ? patches_down_values_2_q : select_3134);
  logic [10:0] select_3137;
  assign select_3137 = or_1797_s16_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3139;
  assign select_3139 = equal_1791_s16_q ? patches_down_values_3_q : (equal_1793_s16_q ? patches_down_values_3_q : select_3137);
  // hls/stages/patches.hpp:551
  logic [9:0] select_3588;
  assign select_3588 = (patches_read_far_s16_q < patches_peak_far_q) ? patches_read_far_s16_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3590;
  assign select_3590 = equal_1791_s16_q ? (patches_read_first_s16_q ? patches_read_far_s16_q : select_3588) : patches_peak_far_q;
  // hls/stages/patches.hpp:589
  logic [10:0] sum_3628;
  assign sum_3628 = {1'b0, fall_2_s16_q} + {2'h0, fall_2_s16_q[9:1]};
  // hls/stages/patches.hpp:590
  logic [10:0] sum_3632;
  assign sum_3632 = {1'b0, fall_2_s16_q} + {3'h0, fall_2_s16_q[9:2]};
  logic less_3636;
  assign less_3636 = {eight_s16_q, 3'h0} < ({fall_2_s16_q, 3'h0} - {3'h0, fall_2_s16_q});
  // hls/stages/agreement.hpp:1261
  logic [13:0] select_3948;
  assign select_3948 = equal_3687_s16_q ? 14'h0 : product_q;
  logic [13:0] select_3967;
  assign select_3967 = equal_3961_s16_q ? 14'h0 : of_s16_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3948} + {1'b0, select_3967};
  // hls/stages/agreement.hpp:799
  logic [2:0] select_4009;
  assign select_4009 = so_s16_q ? (ends_cell_s16_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4011;
  assign select_4011 = ends_cell_s16_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4013;
  assign select_4013 = equal_580_s16_q ? box_explained_columns_values_1_q : (so_s16_q ? select_4011 : box_explained_columns_values_1_q);
  logic [2:0] select_4014;
  assign select_4014 = ends_cell_s16_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4016;
  assign select_4016 = equal_580_s16_q ? box_explained_columns_values_2_q : (so_s16_q ? select_4014 : box_explained_columns_values_2_q);
  logic [2:0] select_4017;
  assign select_4017 = ends_cell_s16_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4019;
  assign select_4019 = equal_580_s16_q ? box_explained_columns_values_3_q : (so_s16_q ? select_4017 : box_explained_columns_values_3_q);
  logic [2:0] select_4020;
  assign select_4020 = ends_cell_s16_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4022;
  assign select_4022 = equal_580_s16_q ? box_explained_columns_values_4_q : (so_s16_q ? select_4020 : box_explained_columns_values_4_q);
  logic [2:0] select_4027;
  assign select_4027 = so_s16_q ? (ends_cell_s16_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4029;
  assign select_4029 = ends_cell_s16_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4031;
  assign select_4031 = equal_580_s16_q ? box_shown_columns_values_1_q : (so_s16_q ? select_4029 : box_shown_columns_values_1_q);
  logic [2:0] select_4032;
  assign select_4032 = ends_cell_s16_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4034;
  assign select_4034 = equal_580_s16_q ? box_shown_columns_values_2_q : (so_s16_q ? select_4032 : box_shown_columns_values_2_q);
  logic [2:0] select_4035;
  assign select_4035 = ends_cell_s16_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4037;
  assign select_4037 = equal_580_s16_q ? box_shown_columns_values_3_q : (so_s16_q ? select_4035 : box_shown_columns_values_3_q);
  logic [2:0] select_4038;
  assign select_4038 = ends_cell_s16_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4040;
  assign select_4040 = equal_580_s16_q ? box_shown_columns_values_4_q : (so_s16_q ? select_4038 : box_shown_columns_values_4_q);
  logic [2:0] select_4045;
  assign select_4045 = so_s16_q ? (ends_cell_s16_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4047;
  assign select_4047 = ends_cell_s16_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4049;
  assign select_4049 = equal_580_s16_q ? box_nearer_columns_values_1_q : (so_s16_q ? select_4047 : box_nearer_columns_values_1_q);
  logic [2:0] select_4050;
  assign select_4050 = ends_cell_s16_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4052;
  assign select_4052 = equal_580_s16_q ? box_nearer_columns_values_2_q : (so_s16_q ? select_4050 : box_nearer_columns_values_2_q);
  logic [2:0] select_4053;
  assign select_4053 = ends_cell_s16_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4055;
  assign select_4055 = equal_580_s16_q ? box_nearer_columns_values_3_q : (so_s16_q ? select_4053 : box_nearer_columns_values_3_q);
  logic [2:0] select_4056;
  assign select_4056 = ends_cell_s16_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4058;
  assign select_4058 = equal_580_s16_q ? box_nearer_columns_values_4_q : (so_s16_q ? select_4056 : box_nearer_columns_values_4_q);
  // hls/stages/agreement.hpp:1166
  logic and_4158;
  assign and_4158 = (proven_s16_q & (~cfg_same_table_i)) & (sum_4156_s16_q < counts_nearer_q);

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = last_s16_q;
  logic census_memory_we;
  assign census_memory_we = s16_en & and_555_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s16_q[58:40], census_memory_rdata_s16_q[38:0], and_573_s16_q, whole_2_s16_q, select_565_s16_q, select_561_s16_q};
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

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s16_2_q;
  logic best_left_we;
  assign best_left_we = s16_en & and_1572_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1571_s16_q, select_1568_s16_q, select_1565_s16_q, select_1563_s16_q, select_1545_s16_q, select_1542_s16_q, select_1534_s16_q, select_1533_s16_q, select_1528_s16_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_left_raddr_s6_sim;
  logic best_left_re_s6_sim;
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s6_sim <= 1'b0;
      best_left_re_s7_sim <= 1'b0;
      best_left_re_s8_sim <= 1'b0;
      best_left_re_s9_sim <= 1'b0;
      best_left_re_s10_sim <= 1'b0;
      best_left_re_s11_sim <= 1'b0;
      best_left_re_s12_sim <= 1'b0;
      best_left_re_s13_sim <= 1'b0;
      best_left_re_s14_sim <= 1'b0;
      best_left_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s6_sim <= best_left_re;
      best_left_raddr_s6_sim <= best_left_raddr;
      best_left_re_s7_sim <= best_left_re_s6_sim;
      best_left_raddr_s7_sim <= best_left_raddr_s6_sim;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_re_s6_sim && best_left_raddr_s6_sim == best_left_waddr) begin
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
      if (best_left_waddr >= 7'd120) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd120) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = right_s16_q;
  logic best_right_we;
  assign best_right_we = s16_en & and_1572_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1582_s16_q, select_1581_s16_q, select_1578_s16_q, select_1577_s16_q};
  end
`ifndef SYNTHESIS
  logic [6:0] best_right_raddr_s10_sim;
  logic best_right_re_s10_sim;
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s10_sim <= 1'b0;
      best_right_re_s11_sim <= 1'b0;
      best_right_re_s12_sim <= 1'b0;
      best_right_re_s13_sim <= 1'b0;
      best_right_re_s14_sim <= 1'b0;
      best_right_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s10_sim <= best_right_re;
      best_right_raddr_s10_sim <= best_right_raddr;
      best_right_re_s11_sim <= best_right_re_s10_sim;
      best_right_raddr_s11_sim <= best_right_raddr_s10_sim;
      best_right_re_s12_sim <= best_right_re_s11_sim;
      best_right_raddr_s12_sim <= best_right_raddr_s11_sim;
      best_right_re_s13_sim <= best_right_re_s12_sim;
      best_right_raddr_s13_sim <= best_right_raddr_s12_sim;
      best_right_re_s14_sim <= best_right_re_s13_sim;
      best_right_raddr_s14_sim <= best_right_raddr_s13_sim;
      best_right_re_s15_sim <= best_right_re_s14_sim;
      best_right_raddr_s15_sim <= best_right_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_re_s10_sim && best_right_raddr_s10_sim == best_right_waddr) begin
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
      if (best_right_waddr >= 7'd120) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd120) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory left_turns, write
  logic [6:0] left_turns_waddr;
  assign left_turns_waddr = x_s16_q[6:0];
  logic left_turns_we;
  assign left_turns_we = s16_en & and_1611_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1608_s16_q, and_1605_s16_q};
  end
`ifndef SYNTHESIS
  logic [6:0] left_turns_raddr_s13_sim;
  logic left_turns_re_s13_sim;
  logic [6:0] left_turns_raddr_s14_sim;
  logic left_turns_re_s14_sim;
  logic [6:0] left_turns_raddr_s15_sim;
  logic left_turns_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_turns_re_s13_sim <= 1'b0;
      left_turns_re_s14_sim <= 1'b0;
      left_turns_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      left_turns_re_s13_sim <= left_turns_re;
      left_turns_raddr_s13_sim <= left_turns_raddr;
      left_turns_re_s14_sim <= left_turns_re_s13_sim;
      left_turns_raddr_s14_sim <= left_turns_raddr_s13_sim;
      left_turns_re_s15_sim <= left_turns_re_s14_sim;
      left_turns_raddr_s15_sim <= left_turns_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_turns_we) begin
      if (left_turns_re && left_turns_raddr == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s13_sim && left_turns_raddr_s13_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s14_sim && left_turns_raddr_s14_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s15_sim && left_turns_raddr_s15_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_waddr >= 7'd120) $error("left_turns: write outside, address %0d", left_turns_waddr);
    end
    if (rst_ni && left_turns_re && left_turns_raddr >= 7'd120) $error("left_turns: read outside, address %0d", left_turns_raddr);
  end
`endif

  // Memory right_turns, write
  logic [6:0] right_turns_waddr;
  assign right_turns_waddr = x_s16_q[6:0];
  logic right_turns_we;
  assign right_turns_we = s16_en & and_1611_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1617_s16_q, and_1614_s16_q};
  end
`ifndef SYNTHESIS
  logic [6:0] right_turns_raddr_s13_sim;
  logic right_turns_re_s13_sim;
  logic [6:0] right_turns_raddr_s14_sim;
  logic right_turns_re_s14_sim;
  logic [6:0] right_turns_raddr_s15_sim;
  logic right_turns_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_turns_re_s13_sim <= 1'b0;
      right_turns_re_s14_sim <= 1'b0;
      right_turns_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      right_turns_re_s13_sim <= right_turns_re;
      right_turns_raddr_s13_sim <= right_turns_raddr;
      right_turns_re_s14_sim <= right_turns_re_s13_sim;
      right_turns_raddr_s14_sim <= right_turns_raddr_s13_sim;
      right_turns_re_s15_sim <= right_turns_re_s14_sim;
      right_turns_raddr_s15_sim <= right_turns_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_turns_we) begin
      if (right_turns_re && right_turns_raddr == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s13_sim && right_turns_raddr_s13_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s14_sim && right_turns_raddr_s14_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s15_sim && right_turns_raddr_s15_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_waddr >= 7'd120) $error("right_turns: write outside, address %0d", right_turns_waddr);
    end
    if (rst_ni && right_turns_re && right_turns_raddr >= 7'd120) $error("right_turns: read outside, address %0d", right_turns_raddr);
  end
`endif

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s16_q, and_1709_s16_q};
  logic patches_choices_we;
  assign patches_choices_we = s16_en & and_1790_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1751};
  end
`ifndef SYNTHESIS
  logic [5:0] patches_choices_raddr_s15_sim;
  logic patches_choices_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choices_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      patches_choices_re_s15_sim <= patches_choices_re;
      patches_choices_raddr_s15_sim <= patches_choices_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_choices_we) begin
      if (patches_choices_re && patches_choices_raddr == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
      if (patches_choices_re_s15_sim && patches_choices_raddr_s15_sim == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_turned_0_q <= 14'h0;
      moments_turned_1_q <= 14'h0;
      moments_turns_0_q <= 1'b0;
      moments_turns_1_q <= 1'b0;
      counts_explained_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      patches_choice_valid_q <= 1'b0;
      patches_smooth_values_0_q <= 12'h0;
      patches_smooth_values_1_q <= 12'h0;
      patches_smooth_values_2_q <= 12'h0;
      patches_smooth_values_3_q <= 12'h0;
      patches_down_values_2_q <= 11'h0;
      patches_down_values_3_q <= 11'h0;
      patches_peak_far_q <= 10'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s16_en) begin
      moments_turned_0_q <= sum_2310;
      moments_turned_1_q <= sum_2312;
      moments_turns_0_q <= not_581_s16_q & and_2352;
      moments_turns_1_q <= not_581_s16_q & and_2356;
      counts_explained_q <= select_2640;
      counts_nearer_q <= and_2621_s16_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2643});
      patches_choice_valid_q <= and_1789_s16_q ? (select_1751 & not_3016_s16_q) : select_1751;
      patches_smooth_values_0_q <= equal_1791_s16_q ? patches_smooth_values_0_q : select_3117;
      patches_smooth_values_1_q <= select_3121;
      patches_smooth_values_2_q <= select_3124;
      patches_smooth_values_3_q <= select_3127;
      patches_down_values_2_q <= select_3136;
      patches_down_values_3_q <= select_3139;
      patches_peak_far_q <= select_3590;
      segment_textured_q <= select_2015 + {6'h0, and_2633_s16_q};
      segment_explained_q <= select_2021 + {6'h0, and_2638};
      segment_nearer_q <= select_2032 + {6'h0, and_2643};
      product_q <= equal_580_s16_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2049;
      columns_passed_q <= {select_2051[7:0], or_2047};
      line_ended_q <= marks_last_s16_q;
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
    if (s16_en) begin
      averager_quarter_1_0_q <= select_2181;
      averager_quarter_1_1_q <= select_2183;
      averager_quarter_2_0_q <= select_2185;
      averager_quarter_2_1_q <= select_2187;
      census_columns_values_0_cell_0_left_q <= select_2216;
      census_columns_values_0_cell_0_right_q <= select_2217;
      census_columns_values_0_cell_1_left_q <= select_2219;
      census_columns_values_0_cell_1_right_q <= select_2220;
      census_columns_values_0_cell_1_mask_q <= select_2221;
      census_columns_values_0_cell_2_left_q <= select_2222;
      census_columns_values_0_cell_2_right_q <= select_2223;
      census_columns_values_0_cell_2_mask_q <= select_2224;
      census_columns_values_0_cell_2_of_skin_q <= select_2225;
      census_columns_values_0_cell_3_left_q <= select_2226;
      census_columns_values_0_cell_3_right_q <= select_2227;
      census_columns_values_0_cell_3_mask_q <= select_2228;
      census_columns_values_0_cell_4_left_q <= select_2229;
      census_columns_values_0_cell_4_right_q <= select_2230;
      census_columns_values_0_cell_4_mask_q <= select_2231;
      census_columns_values_1_cell_0_left_q <= select_2232;
      census_columns_values_1_cell_0_right_q <= select_2233;
      census_columns_values_1_cell_1_left_q <= select_2235;
      census_columns_values_1_cell_1_right_q <= select_2236;
      census_columns_values_1_cell_2_left_q <= select_2238;
      census_columns_values_1_cell_2_right_q <= select_2239;
      census_columns_values_1_cell_2_of_skin_q <= select_2241;
      census_columns_values_1_cell_3_left_q <= select_2242;
      census_columns_values_1_cell_3_right_q <= select_2243;
      census_columns_values_1_cell_4_left_q <= select_2245;
      census_columns_values_1_cell_4_right_q <= select_2246;
      census_columns_values_2_cell_0_left_q <= select_2248;
      census_columns_values_2_cell_0_right_q <= select_2249;
      census_columns_values_2_cell_1_left_q <= select_2251;
      census_columns_values_2_cell_1_right_q <= select_2252;
      census_columns_values_2_cell_2_left_q <= select_2254;
      census_columns_values_2_cell_2_right_q <= select_2255;
      census_columns_values_2_cell_3_left_q <= select_2257;
      census_columns_values_2_cell_3_right_q <= select_2258;
      census_columns_values_2_cell_4_left_q <= select_2260;
      census_columns_values_2_cell_4_right_q <= select_2261;
      census_columns_values_3_cell_1_left_q <= select_2264;
      census_columns_values_3_cell_1_right_q <= select_2265;
      census_columns_values_3_cell_3_left_q <= select_2268;
      census_columns_values_3_cell_3_right_q <= select_2269;
      sharpness_last_mean_0_q <= and_555_s16_q ? select_561_s16_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_555_s16_q ? select_565_s16_q : sharpness_last_mean_1_q;
      box_explained_columns_values_0_q <= equal_580_s16_q ? box_explained_columns_values_0_q : select_4009;
      box_explained_columns_values_1_q <= select_4013;
      box_explained_columns_values_2_q <= select_4016;
      box_explained_columns_values_3_q <= select_4019;
      box_explained_columns_values_4_q <= select_4022;
      box_shown_columns_values_0_q <= equal_580_s16_q ? box_shown_columns_values_0_q : select_4027;
      box_shown_columns_values_1_q <= select_4031;
      box_shown_columns_values_2_q <= select_4034;
      box_shown_columns_values_3_q <= select_4037;
      box_shown_columns_values_4_q <= select_4040;
      box_nearer_columns_values_0_q <= equal_580_s16_q ? box_nearer_columns_values_0_q : select_4045;
      box_nearer_columns_values_1_q <= select_4049;
      box_nearer_columns_values_2_q <= select_4052;
      box_nearer_columns_values_3_q <= select_4055;
      box_nearer_columns_values_4_q <= select_4058;
    end
  end

  logic [7:0] pixel_0_s17_q;
  logic [7:0] pixel_1_s17_q;
  logic saturated_s17_q;
  logic mask_s17_q;
  logic marks_first_s17_q;
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
  logic [13:0] counts_explained_s17_q;
  logic [13:0] counts_nearer_s17_q;
  logic registration_of_right_s17_q;
  logic patches_lower_s17_q;
  logic patches_second_s17_q;
  logic [4:0] patches_code_row_s17_q;
  logic [10:0] patches_down_values_3_s17_q;
  logic [4:0] patches_along_s17_q;
  logic patches_summed_last_s17_q;
  logic [4:0] patches_summed_down_by_s17_q;
  logic [2:0] region_row_s17_q;
  logic [13:0] product_s17_q;
  logic centres_values_1_textured_s17_q;
  logic centres_values_1_of_skin_s17_q;
  logic [3:0] select_514_s17_q;
  logic row_starts_s17_q;
  logic [6:0] select_549_s17_q;
  logic [6:0] last_s17_q;
  logic and_553_s17_q;
  logic and_555_s17_q;
  logic equal_558_s17_q;
  logic whole_2_s17_q;
  logic equal_575_s17_q;
  logic equal_580_s17_q;
  logic not_581_s17_q;
  logic so_s17_q;
  logic less_662_s17_q;
  logic less_663_s17_q;
  logic less_664_s17_q;
  logic less_665_s17_q;
  logic less_666_s17_q;
  logic less_667_s17_q;
  logic less_668_s17_q;
  logic less_669_s17_q;
  logic less_670_s17_q;
  logic less_671_s17_q;
  logic less_672_s17_q;
  logic less_673_s17_q;
  logic less_674_s17_q;
  logic less_675_s17_q;
  logic less_676_s17_q;
  logic less_677_s17_q;
  logic less_678_s17_q;
  logic less_679_s17_q;
  logic less_680_s17_q;
  logic less_681_s17_q;
  logic less_682_s17_q;
  logic less_683_s17_q;
  logic less_684_s17_q;
  logic less_685_s17_q;
  logic and_693_s17_q;
  logic and_697_s17_q;
  logic difference_720_s17_q;
  logic [8:0] xor_721_s17_q;
  logic difference_723_s17_q;
  logic [8:0] xor_724_s17_q;
  logic difference_727_s17_q;
  logic [8:0] xor_728_s17_q;
  logic difference_731_s17_q;
  logic [8:0] xor_732_s17_q;
  logic difference_735_s17_q;
  logic [8:0] xor_736_s17_q;
  logic [9:0] half_grey_levels_s17_q;
  logic [9:0] half_grey_levels_2_s17_q;
  logic equal_1618_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1624_s17_q;
  logic equal_1626_s17_q;
  logic equal_1628_s17_q;
  logic equal_1630_s17_q;
  logic equal_1632_s17_q;
  logic equal_1634_s17_q;
  logic equal_1636_s17_q;
  logic equal_1638_s17_q;
  logic equal_1640_s17_q;
  logic less_1649_s17_q;
  logic or_1653_s17_q;
  logic [31:0] registration_sums_rdata_s17_q;
  logic equal_1673_s17_q;
  logic and_1683_s17_q;
  logic select_1700_s17_q;
  logic equal_1701_s17_q;
  logic equal_1711_s17_q;
  logic equal_1791_s17_q;
  logic equal_1793_s17_q;
  logic equal_1796_s17_q;
  logic or_1797_s17_q;
  logic not_1798_s17_q;
  logic [21:0] select_1807_s17_q;
  logic equal_1808_s17_q;
  logic is_chosen_s17_q;
  logic [4:0] select_1826_s17_q;
  logic select_1832_s17_q;
  logic [3:0] select_1870_s17_q;
  logic less_1886_s17_q;
  logic new_row_s17_q;
  logic or_1899_s17_q;
  logic [27:0] patches_right_codes_rdata_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic down_2_s17_q;
  logic sum_1913_s17_q;
  logic [12:0] sum_1914_s17_q;
  logic [14:0] difference_1934_s17_q;
  logic and_1959_s17_q;
  logic [47:0] patches_left_codes_rdata_s17_q;
  logic and_1968_s17_q;
  logic and_1973_s17_q;
  logic or_1991_s17_q;
  logic or_1994_s17_q;
  logic or_1997_s17_q;
  logic not_1999_s17_q;
  logic [9:0] sum_2018_s17_q;
  logic [9:0] sum_2024_s17_q;
  logic [9:0] sum_2035_s17_q;
  logic and_2036_s17_q;
  logic select_2053_s17_q;
  logic select_2064_s17_q;
  logic not_2066_s17_q;
  logic select_2078_s17_q;
  logic [2:0] textured_2_s17_q;
  logic or_2097_s17_q;
  logic or_2100_s17_q;
  logic or_2103_s17_q;
  logic [3:0] difference_2123_s17_q;
  logic [3:0] difference_2139_s17_q;
  logic and_2155_s17_q;
  logic sum_2192_s17_q;
  logic [9:0] difference_2193_s17_q;
  logic sum_2200_s17_q;
  logic [9:0] difference_2201_s17_q;
  logic difference_2273_s17_q;
  logic [8:0] xor_2274_s17_q;
  logic difference_2276_s17_q;
  logic [8:0] xor_2277_s17_q;
  logic difference_2280_s17_q;
  logic [8:0] xor_2281_s17_q;
  logic difference_2284_s17_q;
  logic [8:0] xor_2285_s17_q;
  logic difference_2288_s17_q;
  logic [8:0] xor_2289_s17_q;
  logic equal_2298_s17_q;
  logic difference_2383_s17_q;
  logic [8:0] xor_2384_s17_q;
  logic difference_2395_s17_q;
  logic [8:0] xor_2396_s17_q;
  logic equal_2486_s17_q;
  logic and_2621_s17_q;
  logic and_2628_s17_q;
  logic not_2649_s17_q;
  logic [3:0] difference_2659_s17_q;
  logic [9:0] select_2675_s17_q;
  logic [9:0] select_2678_s17_q;
  logic and_2728_s17_q;
  logic and_2746_s17_q;
  logic and_2754_s17_q;
  logic and_2788_s17_q;
  logic and_2789_s17_q;
  logic [7:0] residual_s17_q;
  logic and_2825_s17_q;
  logic and_2839_s17_q;
  logic equal_2881_s17_q;
  logic less_3151_s17_q;
  logic equal_3494_s17_q;
  logic [9:0] select_3580_s17_q;
  logic [4:0] select_3581_s17_q;
  logic [4:0] select_3582_s17_q;
  logic equal_3591_s17_q;
  logic less_3619_s17_q;
  logic not_3627_s17_q;
  logic not_3630_s17_q;
  logic not_3634_s17_q;
  logic not_3637_s17_q;
  logic equal_3687_s17_q;
  logic and_3903_s17_q;
  logic less_3904_s17_q;
  logic equal_3905_s17_q;
  logic equal_3919_s17_q;
  logic equal_3926_s17_q;
  logic equal_3928_s17_q;
  logic equal_3929_s17_q;
  logic equal_3930_s17_q;
  logic equal_3931_s17_q;
  logic sum_4_s17_q;
  logic or_4077_s17_q;
  logic and_4091_s17_q;
  logic and_4108_s17_q;
  logic not_4120_s17_q;
  logic and_4158_s17_q;
  logic equal_4179_s17_q;
  logic [9:0] select_4189_s17_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s17_q <= pixel_0_s16_q;
      pixel_1_s17_q <= pixel_1_s16_q;
      saturated_s17_q <= saturated_s16_q;
      mask_s17_q <= mask_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
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
      counts_textured_s17_q <= counts_textured_s16_q;
      counts_explained_s17_q <= counts_explained_q;
      counts_nearer_s17_q <= counts_nearer_q;
      registration_of_right_s17_q <= registration_of_right_s16_q;
      patches_lower_s17_q <= patches_lower_s16_q;
      patches_second_s17_q <= patches_second_s16_q;
      patches_code_row_s17_q <= patches_code_row_s16_q;
      patches_down_values_3_s17_q <= patches_down_values_3_q;
      patches_along_s17_q <= patches_along_s16_q;
      patches_summed_last_s17_q <= patches_summed_last_s16_q;
      patches_summed_down_by_s17_q <= patches_summed_down_by_s16_q;
      region_row_s17_q <= region_row_s16_q;
      product_s17_q <= product_q;
      centres_values_1_textured_s17_q <= centres_values_1_textured_s16_q;
      centres_values_1_of_skin_s17_q <= centres_values_1_of_skin_s16_q;
      select_514_s17_q <= select_514_s16_q;
      row_starts_s17_q <= row_starts_s16_q;
      select_549_s17_q <= select_549_s16_q;
      last_s17_q <= last_s16_q;
      and_553_s17_q <= and_553_s16_q;
      and_555_s17_q <= and_555_s16_q;
      equal_558_s17_q <= equal_558_s16_q;
      whole_2_s17_q <= whole_2_s16_q;
      equal_575_s17_q <= equal_575_s16_q;
      equal_580_s17_q <= equal_580_s16_q;
      not_581_s17_q <= not_581_s16_q;
      so_s17_q <= so_s16_q;
      less_662_s17_q <= less_662;
      less_663_s17_q <= less_663;
      less_664_s17_q <= less_664;
      less_665_s17_q <= less_665;
      less_666_s17_q <= less_666;
      less_667_s17_q <= less_667;
      less_668_s17_q <= less_668;
      less_669_s17_q <= less_669;
      less_670_s17_q <= less_670;
      less_671_s17_q <= less_671;
      less_672_s17_q <= less_672;
      less_673_s17_q <= less_673;
      less_674_s17_q <= less_674;
      less_675_s17_q <= less_675;
      less_676_s17_q <= less_676;
      less_677_s17_q <= less_677;
      less_678_s17_q <= less_678;
      less_679_s17_q <= less_679;
      less_680_s17_q <= less_680;
      less_681_s17_q <= less_681;
      less_682_s17_q <= less_682;
      less_683_s17_q <= less_683;
      less_684_s17_q <= less_684;
      less_685_s17_q <= less_685;
      and_693_s17_q <= and_693_s16_q;
      and_697_s17_q <= and_697;
      difference_720_s17_q <= difference_720[9];
      xor_721_s17_q <= difference_720[8:0] ^ {9{difference_720[9]}};
      difference_723_s17_q <= difference_723[9];
      xor_724_s17_q <= difference_723[8:0] ^ {9{difference_723[9]}};
      difference_727_s17_q <= difference_727[9];
      xor_728_s17_q <= difference_727[8:0] ^ {9{difference_727[9]}};
      difference_731_s17_q <= difference_731[9];
      xor_732_s17_q <= difference_731[8:0] ^ {9{difference_731[9]}};
      difference_735_s17_q <= difference_735[9];
      xor_736_s17_q <= difference_735[8:0] ^ {9{difference_735[9]}};
      half_grey_levels_s17_q <= half_grey_levels;
      half_grey_levels_2_s17_q <= half_grey_levels_2;
      equal_1618_s17_q <= equal_1618_s16_q;
      all_s17_q <= all_s16_q;
      sum_1624_s17_q <= sum_1624_s16_q;
      equal_1626_s17_q <= equal_1626_s16_q;
      equal_1628_s17_q <= equal_1628_s16_q;
      equal_1630_s17_q <= equal_1630_s16_q;
      equal_1632_s17_q <= equal_1632_s16_q;
      equal_1634_s17_q <= equal_1634_s16_q;
      equal_1636_s17_q <= equal_1636_s16_q;
      equal_1638_s17_q <= equal_1638_s16_q;
      equal_1640_s17_q <= equal_1640_s16_q;
      less_1649_s17_q <= less_1649_s16_q;
      or_1653_s17_q <= or_1653_s16_q;
      registration_sums_rdata_s17_q <= registration_sums_rdata_q;
      equal_1673_s17_q <= equal_1673_s16_q;
      and_1683_s17_q <= and_1683_s16_q;
      select_1700_s17_q <= select_1700_s16_q;
      equal_1701_s17_q <= equal_1701_s16_q;
      equal_1711_s17_q <= equal_1711_s16_q;
      equal_1791_s17_q <= equal_1791_s16_q;
      equal_1793_s17_q <= equal_1793_s16_q;
      equal_1796_s17_q <= equal_1796_s16_q;
      or_1797_s17_q <= or_1797_s16_q;
      not_1798_s17_q <= not_1798_s16_q;
      select_1807_s17_q <= select_1807[22:1];
      equal_1808_s17_q <= equal_1808_s16_q;
      is_chosen_s17_q <= is_chosen;
      select_1826_s17_q <= select_1826_s16_q;
      select_1832_s17_q <= select_1832_s16_q;
      select_1870_s17_q <= select_1870_s16_q;
      less_1886_s17_q <= less_1886_s16_q;
      new_row_s17_q <= new_row_s16_q;
      or_1899_s17_q <= or_1899_s16_q;
      patches_right_codes_rdata_s17_q <= patches_right_codes_rdata_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      down_2_s17_q <= down_2_s16_q[0];
      sum_1913_s17_q <= sum_1913[0];
      sum_1914_s17_q <= sum_1914;
      difference_1934_s17_q <= difference_1934;
      and_1959_s17_q <= and_1959_s16_q;
      patches_left_codes_rdata_s17_q <= patches_left_codes_rdata_q;
      and_1968_s17_q <= and_1968_s16_q;
      and_1973_s17_q <= and_1973_s16_q;
      or_1991_s17_q <= or_1991_s16_q;
      or_1994_s17_q <= or_1994_s16_q;
      or_1997_s17_q <= or_1997_s16_q;
      not_1999_s17_q <= not_1999_s16_q;
      sum_2018_s17_q <= sum_2018;
      sum_2024_s17_q <= sum_2024;
      sum_2035_s17_q <= sum_2035;
      and_2036_s17_q <= and_2036_s16_q;
      select_2053_s17_q <= select_2053;
      select_2064_s17_q <= select_2064_s16_q;
      not_2066_s17_q <= not_2066_s16_q;
      select_2078_s17_q <= select_2078_s16_q;
      textured_2_s17_q <= textured_2;
      or_2097_s17_q <= or_2097_s16_q;
      or_2100_s17_q <= or_2100_s16_q;
      or_2103_s17_q <= or_2103_s16_q;
      difference_2123_s17_q <= {1'b0, shown_2} - {1'b0, select_2122};
      difference_2139_s17_q <= {1'b0, near_2} - {1'b0, select_2138};
      and_2155_s17_q <= and_2155_s16_q;
      sum_2192_s17_q <= sum_2192[0];
      difference_2193_s17_q <= {1'b0, sum_2192[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2200_s17_q <= sum_2200[0];
      difference_2201_s17_q <= {1'b0, sum_2200[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2273_s17_q <= difference_2273[9];
      xor_2274_s17_q <= difference_2273[8:0] ^ {9{difference_2273[9]}};
      difference_2276_s17_q <= difference_2276[9];
      xor_2277_s17_q <= difference_2276[8:0] ^ {9{difference_2276[9]}};
      difference_2280_s17_q <= difference_2280[9];
      xor_2281_s17_q <= difference_2280[8:0] ^ {9{difference_2280[9]}};
      difference_2284_s17_q <= difference_2284[9];
      xor_2285_s17_q <= difference_2284[8:0] ^ {9{difference_2284[9]}};
      difference_2288_s17_q <= difference_2288[9];
      xor_2289_s17_q <= difference_2288[8:0] ^ {9{difference_2288[9]}};
      equal_2298_s17_q <= equal_2298_s16_q;
      difference_2383_s17_q <= difference_2383[9];
      xor_2384_s17_q <= difference_2383[8:0] ^ {9{difference_2383[9]}};
      difference_2395_s17_q <= difference_2395[9];
      xor_2396_s17_q <= difference_2395[8:0] ^ {9{difference_2395[9]}};
      equal_2486_s17_q <= equal_2486_s16_q;
      and_2621_s17_q <= and_2621_s16_q;
      and_2628_s17_q <= and_2628_s16_q;
      not_2649_s17_q <= not_2649_s16_q;
      difference_2659_s17_q <= {1'b0, explained_2} - {1'b0, select_2658};
      select_2675_s17_q <= less_2674 ? 10'h0 : regions_rdata_s16_q[9:0];
      select_2678_s17_q <= less_2674 ? 10'h0 : regions_rdata_s16_q[19:10];
      and_2728_s17_q <= and_2728_s16_q;
      and_2746_s17_q <= and_2746_s16_q;
      and_2754_s17_q <= and_2754_s16_q;
      and_2788_s17_q <= and_2788_s16_q;
      and_2789_s17_q <= and_2789_s16_q;
      residual_s17_q <= residual_s16_q;
      and_2825_s17_q <= and_2789_s16_q & less_2824_s16_q;
      and_2839_s17_q <= and_2789_s16_q & less_2838_s16_q;
      equal_2881_s17_q <= equal_2881_s16_q;
      less_3151_s17_q <= less_3151_s16_q;
      equal_3494_s17_q <= equal_3494_s16_q;
      select_3580_s17_q <= select_3580_s16_q;
      select_3581_s17_q <= select_3581_s16_q;
      select_3582_s17_q <= select_3582_s16_q;
      equal_3591_s17_q <= equal_3591_s16_q;
      less_3619_s17_q <= less_3619_s16_q;
      not_3627_s17_q <= ~({eight_s16_q, 3'h0} < {3'h0, fall_2_s16_q});
      not_3630_s17_q <= ~({eight_s16_q, 3'h0} < {1'b0, sum_3628, fall_2_s16_q[0]});
      not_3634_s17_q <= ~({eight_s16_q, 3'h0} < {sum_3632, fall_2_s16_q[1:0]});
      not_3637_s17_q <= ~less_3636;
      equal_3687_s17_q <= equal_3687_s16_q;
      and_3903_s17_q <= and_3903_s16_q;
      less_3904_s17_q <= counts_explained_q < product_q;
      equal_3905_s17_q <= counts_explained_q == product_q;
      equal_3919_s17_q <= equal_3919_s16_q;
      equal_3926_s17_q <= equal_3926_s16_q;
      equal_3928_s17_q <= equal_3928_s16_q;
      equal_3929_s17_q <= equal_3929_s16_q;
      equal_3930_s17_q <= equal_3930_s16_q;
      equal_3931_s17_q <= equal_3931_s16_q;
      sum_4_s17_q <= sum_4[0];
      or_4077_s17_q <= or_4077_s16_q;
      and_4091_s17_q <= and_4091_s16_q;
      and_4108_s17_q <= and_4108_s16_q;
      not_4120_s17_q <= ~proven_s16_q;
      and_4158_s17_q <= and_4158;
      equal_4179_s17_q <= equal_4179_s16_q;
      select_4189_s17_q <= less_2674 ? 10'h0 : regions_rdata_s16_q[29:20];
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [13:0] moments_before_0_q;
  logic [13:0] moments_before_1_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_turned_left_q;
  logic [13:0] counts_turned_right_q;
  logic [5:0] registration_half_measured_q;
  logic [6:0] registration_half_votes_up_q;
  logic [6:0] registration_half_half_votes_up_q;
  logic [7:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic [7:0] patches_place_1_column_q;
  logic [5:0] patches_place_1_shift_q;
  logic [7:0] patches_place_1_slope_q;
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
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
  // hls/stages/agreement.hpp:461
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_697_s17_q;
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
  // hls/stages/census.hpp:284
  logic [9:0] sum_722;
  assign sum_722 = {9'h0, difference_720_s17_q} + {1'b0, xor_721_s17_q};
  logic [9:0] sum_725;
  assign sum_725 = {9'h0, difference_723_s17_q} + {1'b0, xor_724_s17_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_747;
  assign sum_747 = {half_grey_levels_s17_q[9], half_grey_levels_s17_q[9:4]} + 7'h7f;
  logic less_748;
  assign less_748 = {{5{sum_747[6]}}, sum_747, half_grey_levels_s17_q[3:0]} < 16'hffe1;
  logic [6:0] sum_753;
  assign sum_753 = {half_grey_levels_2_s17_q[9], half_grey_levels_2_s17_q[9:4]} + 7'h7f;
  logic less_754;
  assign less_754 = {{5{sum_753[6]}}, sum_753, half_grey_levels_2_s17_q[3:0]} < 16'hffe1;
  // hls/stages/registration.hpp:265
  logic equal_1675;
  assign equal_1675 = sum_1624_s17_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1624_s17_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1681;
  assign select_1681 = equal_1675 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1682;
  assign sum_1682 = (equal_1673_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0) + {{5{select_1681[6]}}, select_1681};
  // hls/stages/patches.hpp:362
  logic [21:0] select_1816;
  assign select_1816 = select_1700_s17_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1807_s17_q;
  // hls/stages/patches.hpp:127
  logic [7:0] select_1817;
  assign select_1817 = equal_1701_s17_q ? patches_place_0_column_q : select_1816[7:0];
  logic [5:0] select_1818;
  assign select_1818 = equal_1701_s17_q ? patches_place_0_shift_q : select_1816[13:8];
  // hls/stages/patches.hpp:362
  logic [21:0] select_1844;
  assign select_1844 = select_1700_s17_q ? select_1807_s17_q : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1845;
  assign select_1845 = equal_1701_s17_q ? patches_place_1_column_q : select_1844[7:0];
  logic [5:0] select_1846;
  assign select_1846 = equal_1701_s17_q ? patches_place_1_shift_q : select_1844[13:8];
  // hls/stages/patches.hpp:133
  logic equal_1861;
  assign equal_1861 = {select_1817[7], select_549_s17_q, select_514_s17_q} == {1'b0, select_1817[6:0], 4'h0};
  logic equal_1865;
  assign equal_1865 = {select_1845[7], select_549_s17_q, select_514_s17_q} == {1'b0, select_1845[6:0], 4'h0};
  // hls/stages/patches.hpp:480
  logic [14:0] sum_1915;
  assign sum_1915 = {{4{patches_down_values_3_s17_q[10]}}, patches_down_values_3_s17_q} + {sum_1914_s17_q, sum_1913_s17_q, down_2_s17_q};
  // hls/stages/patches.hpp:459
  logic and_1938;
  assign and_1938 = difference_1934_s17_q[8] & (~(difference_1934_s17_q[7:0] == 8'h0));
  // hls/stages/patches.hpp:462
  logic and_1942;
  assign and_1942 = (~difference_1934_s17_q[14]) & (and_1938 | (~(difference_1934_s17_q[13:9] == 5'h0)));
  // hls/stages/patches.hpp:458
  logic and_1945;
  assign and_1945 = difference_1934_s17_q[14] & (~(difference_1934_s17_q[13:8] == 6'h3f));
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = select_2053_s17_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1322
  logic [6:0] select_2056;
  assign select_2056 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1333
  logic equal_2059;
  assign equal_2059 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1110
  logic [2:0] select_2088;
  assign select_2088 = age_s17_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1117
  logic not_2104;
  assign not_2104 = ~region_row_s17_q[2];
  logic [2:0] select_2105;
  assign select_2105 = region_row_s17_q[1] ? {1'b0, not_2104, 1'b0} : {region_row_s17_q[2], 1'b0, not_2104};
  logic [5:0] select_2106;
  assign select_2106 = region_row_s17_q[0] ? {select_2105[2], 1'b0, select_2105[1], 1'b0, select_2105[0], 1'b0} : {1'b0, select_2105[2], 1'b0, select_2105[1], 1'b0, select_2105[0]};
  logic [11:0] select_2107;
  assign select_2107 = or_2103_s17_q ? {select_2106[5], 1'b0, select_2106[4], 1'b0, select_2106[3], 1'b0, select_2106[2], 1'b0, select_2106[1], 1'b0, select_2106[0], 1'b0} : {1'b0, select_2106[5], 1'b0, select_2106[4], 1'b0, select_2106[3], 1'b0, select_2106[2], 1'b0, select_2106[1], 1'b0, select_2106[0]};
  logic [23:0] select_2108;
  assign select_2108 = or_2100_s17_q ? {select_2107[11], 1'b0, select_2107[10], 1'b0, select_2107[9], 1'b0, select_2107[8], 1'b0, select_2107[7], 1'b0, select_2107[6], 1'b0, select_2107[5], 1'b0, select_2107[4], 1'b0, select_2107[3], 1'b0, select_2107[2], 1'b0, select_2107[1], 1'b0, select_2107[0], 1'b0} : {1'b0, select_2107[11], 1'b0, select_2107[10], 1'b0, select_2107[9], 1'b0, select_2107[8], 1'b0, select_2107[7], 1'b0, select_2107[6], 1'b0, select_2107[5], 1'b0, select_2107[4], 1'b0, select_2107[3], 1'b0, select_2107[2], 1'b0, select_2107[1], 1'b0, select_2107[0]};
  // hls/stages/agreement.hpp:1112
  logic [4:0] around;
  assign around = {difference_2123_s17_q[3], difference_2123_s17_q} + (equal_575_s17_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1113
  logic [4:0] n;
  assign n = {difference_2139_s17_q[3], difference_2139_s17_q} + (equal_575_s17_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:221
  logic [9:0] xor_2194;
  assign xor_2194 = {difference_2193_s17_q[8:0], sum_2192_s17_q} ^ {10{difference_2193_s17_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2193_s17_q[9]} + {1'b0, xor_2194};
  logic [9:0] xor_2202;
  assign xor_2202 = {difference_2201_s17_q[8:0], sum_2200_s17_q} ^ {10{difference_2201_s17_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2201_s17_q[9]} + {1'b0, xor_2202};
  // hls/stages/agreement.hpp:531
  logic select_2218;
  assign select_2218 = and_555_s17_q ? whole_2_s17_q : census_columns_values_0_cell_0_mask_q;
  logic select_2234;
  assign select_2234 = and_555_s17_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2237;
  assign select_2237 = and_555_s17_q ? census_columns_values_0_cell_1_mask_s17_q : census_columns_values_1_cell_1_mask_q;
  logic select_2244;
  assign select_2244 = and_555_s17_q ? census_columns_values_0_cell_3_mask_s17_q : census_columns_values_1_cell_3_mask_q;
  logic select_2247;
  assign select_2247 = and_555_s17_q ? census_columns_values_0_cell_4_mask_s17_q : census_columns_values_1_cell_4_mask_q;
  logic select_2250;
  assign select_2250 = and_555_s17_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2253;
  assign select_2253 = and_555_s17_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] sum_2275;
  assign sum_2275 = {9'h0, difference_2273_s17_q} + {1'b0, xor_2274_s17_q};
  logic [9:0] sum_2278;
  assign sum_2278 = {9'h0, difference_2276_s17_q} + {1'b0, xor_2277_s17_q};
  // hls/stages/moments.hpp:153
  logic [13:0] select_2313;
  assign select_2313 = equal_1808_s17_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2315;
  assign select_2315 = equal_1808_s17_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2326;
  assign sum_2326 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2336;
  assign sum_2336 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/census.hpp:371
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2383_s17_q} + xor_2384_s17_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2395_s17_q} + xor_2396_s17_q;
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2630;
  assign select_2630 = and_2621_s17_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2628_s17_q});
  // hls/stages/agreement.hpp:1111
  logic [4:0] e;
  assign e = {difference_2659_s17_q[3], difference_2659_s17_q} + (equal_575_s17_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2748;
  assign select_2748 = and_2621_s17_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2746_s17_q});
  logic [13:0] select_2756;
  assign select_2756 = and_2621_s17_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2754_s17_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2806;
  assign select_2806 = equal_1711_s17_q ? (and_2789_s17_q ? residual_s17_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:799
  logic and_2813;
  assign and_2813 = not_581_s17_q & (so_s17_q & (and_2789_s17_q & equal_1711_s17_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2815;
  assign select_2815 = and_2788_s17_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2813});
  // hls/stages/registration.hpp:107
  logic and_2817;
  assign and_2817 = and_2789_s17_q & ($signed(residual_s17_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:799
  logic [1:0] select_2827;
  assign select_2827 = so_s17_q ? (equal_1711_s17_q ? {and_2825_s17_q, and_2789_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2828;
  assign select_2828 = equal_580_s17_q ? 2'h0 : select_2827;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2829;
  assign sum_2829 = registration_half_votes_up_q + {{5{select_2828[1]}}, select_2828};
  // hls/stages/registration.hpp:205
  logic less_2831;
  assign less_2831 = $signed(residual_s17_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2832;
  assign and_2832 = and_2789_s17_q & less_2831;
  // hls/stages/agreement.hpp:799
  logic [1:0] select_2841;
  assign select_2841 = so_s17_q ? (equal_1711_s17_q ? {and_2839_s17_q, and_2789_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2842;
  assign select_2842 = equal_580_s17_q ? 2'h0 : select_2841;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2843;
  assign sum_2843 = registration_half_half_votes_up_q + {{5{select_2842[1]}}, select_2842};
  // hls/stages/agreement.hpp:1147
  logic [11:0] select_2883;
  assign select_2883 = or_1653_s17_q ? 12'h0 : (equal_2881_s17_q ? registration_sums_rdata_s17_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1159
  logic [11:0] select_2885;
  assign select_2885 = equal_1618_s17_q ? 12'h0 : (less_1649_s17_q ? select_2883 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2888;
  assign and_2888 = x_s17_q[1] & all_s17_q;
  // hls/stages/agreement.hpp:1159
  logic and_2891;
  assign and_2891 = not_1999_s17_q & (less_1649_s17_q & ({and_2888, x_s17_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1147
  logic [11:0] select_2898;
  assign select_2898 = or_1653_s17_q ? 12'h0 : (equal_2881_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1159
  logic [11:0] select_2900;
  assign select_2900 = equal_1618_s17_q ? 12'h0 : (less_1649_s17_q ? select_2898 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2906;
  assign not_2906 = ~all_s17_q;
  // hls/stages/agreement.hpp:1159
  logic and_2909;
  assign and_2909 = not_1999_s17_q & (less_1649_s17_q & (x_s17_q[2:0] == {all_s17_q, not_2906, 1'b0}));
  // hls/stages/agreement.hpp:799
  logic and_2915;
  assign and_2915 = equal_580_s17_q & (x_s17_q[6] & (not_1999_s17_q & (less_1649_s17_q & all_s17_q)));
  // hls/stages/registration.hpp:157
  logic equal_2942;
  assign equal_2942 = x_s17_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1159
  logic and_2945;
  assign and_2945 = not_1999_s17_q & (less_1649_s17_q & (x_s17_q[5] ? x_s17_q[3] : equal_2942));
  logic and_2954;
  assign and_2954 = not_1999_s17_q & (less_1649_s17_q & ((~x_s17_q[5]) & (x_s17_q[3] & equal_2942)));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3047;
  assign select_3047 = sample_pair_whole_s17_q ? (equal_1701_s17_q ? patches_place_0_slope_q : select_1816[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3052;
  assign select_3052 = sample_pair_whole_s17_q ? (equal_1701_s17_q ? patches_place_1_slope_q : select_1844[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:514
  logic [27:0] word;
  assign word = or_1899_s17_q ? patches_right_codes_rdata_s17_q : 28'h0;
  // hls/stages/patches.hpp:531
  logic [47:0] select_3184;
  assign select_3184 = new_row_s17_q ? patches_left_codes_rdata_s17_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3186;
  assign select_3186 = equal_1791_s17_q ? patches_left_row_q : (equal_1793_s17_q ? select_3184 : patches_left_row_q);
  logic [4:0] select_3531;
  assign select_3531 = equal_1793_s17_q ? patches_along_s17_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:589
  logic [1:0] sum_3631;
  assign sum_3631 = {1'b0, not_3627_s17_q} + {1'b0, not_3630_s17_q};
  // hls/stages/patches.hpp:590
  logic [1:0] sum_3638;
  assign sum_3638 = {1'b0, not_3634_s17_q} + {1'b0, not_3637_s17_q};
  // hls/stages/patches.hpp:589
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3631} + {1'b0, sum_3638};
  // hls/stages/patches.hpp:609
  logic [7:0] select_3642;
  assign select_3642 = patches_second_s17_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:608
  logic [3:0] sum_3643;
  assign sum_3643 = {2'h0, select_3581_s17_q[4:3]} + 4'hf;
  logic [5:0] select_3644;
  assign select_3644 = patches_second_s17_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3645;
  assign sum_3645 = {select_3644[5], select_3644} + {{4{sum_3643[3]}}, sum_3643[3:1]};
  // hls/stages/agreement.hpp:1218
  logic or_3900;
  assign or_3900 = ({counts_textured_s17_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s17_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1256
  logic too_little;
  assign too_little = less_3904_s17_q | (product_rest_q & equal_3905_s17_q);
  // hls/stages/agreement.hpp:1257
  logic select_3908;
  assign select_3908 = and_3903_s17_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1152
  logic [10:0] sum_3911;
  assign sum_3911 = {1'b0, select_2678_s17_q} + {2'h0, select_2678_s17_q[9:1]};
  // hls/stages/agreement.hpp:799
  logic select_3972;
  assign select_3972 = equal_580_s17_q ? (equal_3687_s17_q ? sum_4_s17_q : (product_rest_q | sum_4_s17_q)) : product_rest_q;
  logic [2:0] select_3990;
  assign select_3990 = ends_cell_s17_q ? textured_2_s17_q : box_textured_columns_values_0_q;
  logic [2:0] select_3992;
  assign select_3992 = equal_580_s17_q ? box_textured_columns_values_0_q : (so_s17_q ? select_3990 : box_textured_columns_values_0_q);
  logic [2:0] select_3993;
  assign select_3993 = ends_cell_s17_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3995;
  assign select_3995 = equal_580_s17_q ? box_textured_columns_values_1_q : (so_s17_q ? select_3993 : box_textured_columns_values_1_q);
  logic [2:0] select_3996;
  assign select_3996 = ends_cell_s17_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3998;
  assign select_3998 = equal_580_s17_q ? box_textured_columns_values_2_q : (so_s17_q ? select_3996 : box_textured_columns_values_2_q);
  logic [2:0] select_3999;
  assign select_3999 = ends_cell_s17_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4001;
  assign select_4001 = equal_580_s17_q ? box_textured_columns_values_3_q : (so_s17_q ? select_3999 : box_textured_columns_values_3_q);
  logic [2:0] select_4002;
  assign select_4002 = ends_cell_s17_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4004;
  assign select_4004 = equal_580_s17_q ? box_textured_columns_values_4_q : (so_s17_q ? select_4002 : box_textured_columns_values_4_q);
  logic [4:0] select_4024;
  assign select_4024 = so_s17_q ? (ends_cell_s17_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4025;
  assign select_4025 = equal_580_s17_q ? box_explained_sum_sums_values_0_q : select_4024;
  logic [4:0] select_4042;
  assign select_4042 = so_s17_q ? (ends_cell_s17_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4060;
  assign select_4060 = so_s17_q ? (ends_cell_s17_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1332
  logic [3:0] select_4094;
  assign select_4094 = select_2053_s17_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4100;
  assign select_4100 = marks_first_s17_q ? select_4098 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1157
  logic [31:0] select_4181;
  assign select_4181 = equal_1640_s17_q ? {2'h0, counts_explained_s17_q, 2'h0, counts_textured_s17_q} : (equal_4179_s17_q ? registration_sums_rdata_s17_q : 32'h0);
  logic [31:0] select_4182;
  assign select_4182 = equal_1638_s17_q ? {2'h0, counts_nearer_s17_q, 2'h0, counts_supervised_q} : select_4181;

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s17_q, or_1997_s17_q, or_1994_s17_q, or_1991_s17_q};
  logic regions_we;
  assign regions_we = s17_en & and_2036_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2035_s17_q, sum_2024_s17_q, sum_2018_s17_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s15_sim;
  logic regions_re_s15_sim;
  logic [5:0] regions_raddr_s16_sim;
  logic regions_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s15_sim <= 1'b0;
      regions_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s15_sim <= regions_re;
      regions_raddr_s15_sim <= regions_raddr;
      regions_re_s16_sim <= regions_re_s15_sim;
      regions_raddr_s16_sim <= regions_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s15_sim && regions_raddr_s15_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s16_sim && regions_raddr_s16_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_before_0_q <= 14'h0;
      moments_before_1_q <= 14'h0;
      counts_supervised_q <= 14'h0;
      counts_turned_left_q <= 14'h0;
      counts_turned_right_q <= 14'h0;
      registration_half_measured_q <= 6'h0;
      registration_half_votes_up_q <= 7'h0;
      registration_half_half_votes_up_q <= 7'h0;
      patches_place_0_column_q <= 8'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_column_q <= 8'h0;
      patches_place_1_shift_q <= 6'h0;
      patches_place_1_slope_q <= 8'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
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
    end else if (s17_en) begin
      moments_before_0_q <= equal_580_s17_q ? select_2313 : moments_before_0_q;
      moments_before_1_q <= equal_580_s17_q ? select_2315 : moments_before_1_q;
      counts_supervised_q <= select_2630;
      counts_turned_left_q <= select_2748;
      counts_turned_right_q <= select_2756;
      registration_half_measured_q <= select_2815;
      registration_half_votes_up_q <= and_2788_s17_q ? 7'h0 : sum_2829;
      registration_half_half_votes_up_q <= and_2788_s17_q ? 7'h0 : sum_2843;
      patches_place_0_column_q <= sample_pair_whole_s17_q ? select_1817 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s17_q ? select_1818 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3047;
      patches_place_1_column_q <= sample_pair_whole_s17_q ? select_1845 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s17_q ? select_1846 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3052;
      patches_left_row_q <= select_3186;
      patches_summed_row_column_q <= equal_1791_s17_q ? patches_summed_row_column_q : select_3531;
      product_rest_q <= select_3972;
      disagree_q <= equal_580_s17_q ? select_3908 : disagree_q;
      began_q <= not_2066_s17_q & (began_q | select_2053_s17_q);
      seen_x_q <= select_2053_s17_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s17_q ? 4'h0 : select_4094;
      seen_column_q <= select_2053_s17_q ? 8'h0 : (seen_column_q + {7'h0, equal_2059});
      seen_rows_left_q <= select_4100;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s17_q ? 13'h0 : (seen_base_q + {6'h0, select_2056});
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_columns_values_0_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
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
    if (s17_en) begin
      census_columns_values_0_cell_0_mask_q <= select_2218;
      census_columns_values_1_cell_0_mask_q <= select_2234;
      census_columns_values_1_cell_1_mask_q <= select_2237;
      census_columns_values_1_cell_3_mask_q <= select_2244;
      census_columns_values_1_cell_4_mask_q <= select_2247;
      census_columns_values_2_cell_0_mask_q <= select_2250;
      census_columns_values_2_cell_1_mask_q <= select_2253;
      box_textured_columns_values_0_q <= select_3992;
      box_textured_columns_values_1_q <= select_3995;
      box_textured_columns_values_2_q <= select_3998;
      box_textured_columns_values_3_q <= select_4001;
      box_textured_columns_values_4_q <= select_4004;
      box_explained_sum_sums_values_0_q <= select_4025;
      box_shown_sum_sums_values_0_q <= equal_580_s17_q ? box_shown_sum_sums_values_0_q : select_4042;
      box_nearer_sum_sums_values_0_q <= equal_580_s17_q ? box_nearer_sum_sums_values_0_q : select_4060;
    end
  end

  logic [7:0] pixel_0_s18_q;
  logic [7:0] pixel_1_s18_q;
  logic saturated_s18_q;
  logic mask_s18_q;
  logic marks_first_s18_q;
  logic marks_last_s18_q;
  logic [7:0] sample_pair_pixel_0_s18_q;
  logic [7:0] sample_pair_pixel_1_s18_q;
  logic sample_pair_whole_s18_q;
  logic sample_present_s18_q;
  logic census_columns_values_0_cell_2_mask_s18_q;
  logic census_columns_values_1_cell_2_of_skin_s18_q;
  logic census_columns_values_1_cell_3_mask_s18_q;
  logic census_columns_values_1_cell_4_mask_s18_q;
  logic census_columns_values_2_cell_0_mask_s18_q;
  logic census_columns_values_2_cell_1_mask_s18_q;
  logic [6:0] x_s18_q;
  logic [2:0] slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic [13:0] counts_nearer_s18_q;
  logic [11:0] counts_turned_left_s18_q;
  logic [11:0] counts_turned_right_s18_q;
  logic registration_of_right_s18_q;
  logic patches_lower_s18_q;
  logic patches_second_s18_q;
  logic [4:0] patches_code_row_s18_q;
  logic [4:0] patches_summed_row_column_s18_q;
  logic patches_summed_last_s18_q;
  logic [4:0] patches_summed_down_by_s18_q;
  logic [13:0] product_s18_q;
  logic centres_values_1_textured_s18_q;
  logic centres_values_1_of_skin_s18_q;
  logic [2:0] select_514_s18_q;
  logic row_starts_s18_q;
  logic [6:0] last_s18_q;
  logic and_553_s18_q;
  logic and_555_s18_q;
  logic equal_558_s18_q;
  logic whole_2_s18_q;
  logic equal_575_s18_q;
  logic equal_580_s18_q;
  logic not_581_s18_q;
  logic so_s18_q;
  logic less_662_s18_q;
  logic less_663_s18_q;
  logic less_664_s18_q;
  logic less_665_s18_q;
  logic less_666_s18_q;
  logic less_667_s18_q;
  logic less_668_s18_q;
  logic less_669_s18_q;
  logic less_670_s18_q;
  logic less_671_s18_q;
  logic less_672_s18_q;
  logic less_673_s18_q;
  logic less_674_s18_q;
  logic less_675_s18_q;
  logic less_676_s18_q;
  logic less_677_s18_q;
  logic less_678_s18_q;
  logic less_679_s18_q;
  logic less_680_s18_q;
  logic less_681_s18_q;
  logic less_682_s18_q;
  logic less_683_s18_q;
  logic less_684_s18_q;
  logic less_685_s18_q;
  logic and_693_s18_q;
  logic whole_9_s18_q;
  logic [10:0] sum_726_s18_q;
  logic [9:0] sum_729_s18_q;
  logic [9:0] sum_733_s18_q;
  logic [9:0] sum_737_s18_q;
  logic less_748_s18_q;
  logic less_750_s18_q;
  logic less_754_s18_q;
  logic less_756_s18_q;
  logic equal_1618_s18_q;
  logic [1:0] sum_1624_s18_q;
  logic equal_1626_s18_q;
  logic equal_1628_s18_q;
  logic equal_1630_s18_q;
  logic equal_1632_s18_q;
  logic equal_1634_s18_q;
  logic equal_1636_s18_q;
  logic less_1649_s18_q;
  logic [19:0] select_1674_s18_q;
  logic equal_1675_s18_q;
  logic [11:0] sum_1682_s18_q;
  logic and_1683_s18_q;
  logic select_1700_s18_q;
  logic equal_1701_s18_q;
  logic equal_1791_s18_q;
  logic equal_1793_s18_q;
  logic equal_1796_s18_q;
  logic or_1797_s18_q;
  logic not_1798_s18_q;
  logic equal_1808_s18_q;
  logic is_chosen_s18_q;
  logic [8:0] sum_1815_s18_q;
  logic [8:0] sum_1819_s18_q;
  logic [4:0] select_1826_s18_q;
  logic select_1832_s18_q;
  logic [8:0] sum_1847_s18_q;
  logic equal_1861_s18_q;
  logic equal_1865_s18_q;
  logic [3:0] select_1870_s18_q;
  logic less_1886_s18_q;
  logic new_row_s18_q;
  logic [1:0] of_row_2_s18_q;
  logic not_1916_s18_q;
  logic and_1919_s18_q;
  logic not_1921_s18_q;
  logic and_1926_s18_q;
  logic and_1942_s18_q;
  logic and_1945_s18_q;
  logic and_1959_s18_q;
  logic and_1968_s18_q;
  logic and_1973_s18_q;
  logic not_1999_s18_q;
  logic select_2064_s18_q;
  logic [7:0] sum_2076_s18_q;
  logic select_2078_s18_q;
  logic [3:0] difference_2089_s18_q;
  logic or_2097_s18_q;
  logic [23:0] select_2108_s18_q;
  logic [4:0] around_s18_q;
  logic less_2142_s18_q;
  logic and_2155_s18_q;
  logic [10:0] size_s18_q;
  logic [10:0] size_2_s18_q;
  logic [10:0] sum_2279_s18_q;
  logic [9:0] sum_2282_s18_q;
  logic [9:0] sum_2286_s18_q;
  logic [9:0] sum_2290_s18_q;
  logic equal_2298_s18_q;
  logic [13:0] select_2320_s18_q;
  logic not_2328_s18_q;
  logic not_2331_s18_q;
  logic not_2338_s18_q;
  logic not_2341_s18_q;
  logic [8:0] contrast_s18_q;
  logic [8:0] contrast_2_s18_q;
  logic equal_2415_s18_q;
  logic equal_2486_s18_q;
  logic and_2621_s18_q;
  logic not_2649_s18_q;
  logic [4:0] e_s18_q;
  logic [9:0] select_2675_s18_q;
  logic [9:0] select_2678_s18_q;
  logic and_2728_s18_q;
  logic and_2788_s18_q;
  logic [7:0] select_2808_s18_q;
  logic [1:0] select_2818_s18_q;
  logic [1:0] select_2833_s18_q;
  logic [11:0] select_2885_s18_q;
  logic and_2893_s18_q;
  logic [11:0] select_2900_s18_q;
  logic and_2911_s18_q;
  logic and_2915_s18_q;
  logic and_2947_s18_q;
  logic and_2955_s18_q;
  logic [27:0] word_s18_q;
  logic equal_3145_s18_q;
  logic less_3151_s18_q;
  logic [47:0] select_3184_s18_q;
  logic equal_3494_s18_q;
  logic [9:0] select_3580_s18_q;
  logic [2:0] select_3581_s18_q;
  logic [4:0] select_3582_s18_q;
  logic [9:0] select_3590_s18_q;
  logic equal_3591_s18_q;
  logic less_3619_s18_q;
  logic [2:0] fraction_s18_q;
  logic [7:0] select_3642_s18_q;
  logic sum_3643_s18_q;
  logic [6:0] sum_3645_s18_q;
  logic equal_3687_s18_q;
  logic equal_3897_s18_q;
  logic or_3900_s18_q;
  logic select_3908_s18_q;
  logic not_3913_s18_q;
  logic equal_3919_s18_q;
  logic equal_3926_s18_q;
  logic equal_3928_s18_q;
  logic equal_3929_s18_q;
  logic equal_3930_s18_q;
  logic equal_3931_s18_q;
  logic or_4077_s18_q;
  logic and_4091_s18_q;
  logic and_4108_s18_q;
  logic not_4120_s18_q;
  logic and_4158_s18_q;
  logic [31:0] select_4182_s18_q;
  logic [9:0] select_4189_s18_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= line_ended_q;
      sample_pair_pixel_0_s18_q <= sample_pair_pixel_0_s17_q;
      sample_pair_pixel_1_s18_q <= sample_pair_pixel_1_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      sample_present_s18_q <= sample_present_s17_q;
      census_columns_values_0_cell_2_mask_s18_q <= census_columns_values_0_cell_2_mask_s17_q;
      census_columns_values_1_cell_2_of_skin_s18_q <= census_columns_values_1_cell_2_of_skin_s17_q;
      census_columns_values_1_cell_3_mask_s18_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s18_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s18_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s18_q <= census_columns_values_2_cell_1_mask_q;
      x_s18_q <= x_s17_q[6:0];
      slot_s18_q <= slot_s17_q;
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      counts_nearer_s18_q <= counts_nearer_s17_q;
      counts_turned_left_s18_q <= counts_turned_left_q[13:2];
      counts_turned_right_s18_q <= counts_turned_right_q[13:2];
      registration_of_right_s18_q <= registration_of_right_s17_q;
      patches_lower_s18_q <= patches_lower_s17_q;
      patches_second_s18_q <= patches_second_s17_q;
      patches_code_row_s18_q <= patches_code_row_s17_q;
      patches_summed_row_column_s18_q <= patches_summed_row_column_q;
      patches_summed_last_s18_q <= patches_summed_last_s17_q;
      patches_summed_down_by_s18_q <= patches_summed_down_by_s17_q;
      product_s18_q <= product_s17_q;
      centres_values_1_textured_s18_q <= centres_values_1_textured_s17_q;
      centres_values_1_of_skin_s18_q <= centres_values_1_of_skin_s17_q;
      select_514_s18_q <= select_514_s17_q[2:0];
      row_starts_s18_q <= row_starts_s17_q;
      last_s18_q <= last_s17_q;
      and_553_s18_q <= and_553_s17_q;
      and_555_s18_q <= and_555_s17_q;
      equal_558_s18_q <= equal_558_s17_q;
      whole_2_s18_q <= whole_2_s17_q;
      equal_575_s18_q <= equal_575_s17_q;
      equal_580_s18_q <= equal_580_s17_q;
      not_581_s18_q <= not_581_s17_q;
      so_s18_q <= so_s17_q;
      less_662_s18_q <= less_662_s17_q;
      less_663_s18_q <= less_663_s17_q;
      less_664_s18_q <= less_664_s17_q;
      less_665_s18_q <= less_665_s17_q;
      less_666_s18_q <= less_666_s17_q;
      less_667_s18_q <= less_667_s17_q;
      less_668_s18_q <= less_668_s17_q;
      less_669_s18_q <= less_669_s17_q;
      less_670_s18_q <= less_670_s17_q;
      less_671_s18_q <= less_671_s17_q;
      less_672_s18_q <= less_672_s17_q;
      less_673_s18_q <= less_673_s17_q;
      less_674_s18_q <= less_674_s17_q;
      less_675_s18_q <= less_675_s17_q;
      less_676_s18_q <= less_676_s17_q;
      less_677_s18_q <= less_677_s17_q;
      less_678_s18_q <= less_678_s17_q;
      less_679_s18_q <= less_679_s17_q;
      less_680_s18_q <= less_680_s17_q;
      less_681_s18_q <= less_681_s17_q;
      less_682_s18_q <= less_682_s17_q;
      less_683_s18_q <= less_683_s17_q;
      less_684_s18_q <= less_684_s17_q;
      less_685_s18_q <= less_685_s17_q;
      and_693_s18_q <= and_693_s17_q;
      whole_9_s18_q <= whole_9;
      sum_726_s18_q <= {1'b0, sum_722} + {1'b0, sum_725};
      sum_729_s18_q <= {9'h0, difference_727_s17_q} + {1'b0, xor_728_s17_q};
      sum_733_s18_q <= {9'h0, difference_731_s17_q} + {1'b0, xor_732_s17_q};
      sum_737_s18_q <= {9'h0, difference_735_s17_q} + {1'b0, xor_736_s17_q};
      less_748_s18_q <= less_748;
      less_750_s18_q <= $signed(10'h0) < $signed(half_grey_levels_s17_q);
      less_754_s18_q <= less_754;
      less_756_s18_q <= $signed(10'h0) < $signed(half_grey_levels_2_s17_q);
      equal_1618_s18_q <= equal_1618_s17_q;
      sum_1624_s18_q <= sum_1624_s17_q;
      equal_1626_s18_q <= equal_1626_s17_q;
      equal_1628_s18_q <= equal_1628_s17_q;
      equal_1630_s18_q <= equal_1630_s17_q;
      equal_1632_s18_q <= equal_1632_s17_q;
      equal_1634_s18_q <= equal_1634_s17_q;
      equal_1636_s18_q <= equal_1636_s17_q;
      less_1649_s18_q <= less_1649_s17_q;
      select_1674_s18_q <= equal_1673_s17_q ? registration_sums_rdata_s17_q[19:0] : 20'h0;
      equal_1675_s18_q <= equal_1675;
      sum_1682_s18_q <= sum_1682;
      and_1683_s18_q <= and_1683_s17_q;
      select_1700_s18_q <= select_1700_s17_q;
      equal_1701_s18_q <= equal_1701_s17_q;
      equal_1791_s18_q <= equal_1791_s17_q;
      equal_1793_s18_q <= equal_1793_s17_q;
      equal_1796_s18_q <= equal_1796_s17_q;
      or_1797_s18_q <= or_1797_s17_q;
      not_1798_s18_q <= not_1798_s17_q;
      equal_1808_s18_q <= equal_1808_s17_q;
      is_chosen_s18_q <= is_chosen_s17_q;
      sum_1815_s18_q <= {1'b0, select_549_s17_q, select_514_s17_q[3]} + 9'h1;
      sum_1819_s18_q <= {1'b0, select_1817} + {{3{select_1818[5]}}, select_1818};
      select_1826_s18_q <= select_1826_s17_q;
      select_1832_s18_q <= select_1832_s17_q;
      sum_1847_s18_q <= {1'b0, select_1845} + {{3{select_1846[5]}}, select_1846};
      equal_1861_s18_q <= equal_1861;
      equal_1865_s18_q <= equal_1865;
      select_1870_s18_q <= select_1870_s17_q;
      less_1886_s18_q <= less_1886_s17_q;
      new_row_s18_q <= new_row_s17_q;
      of_row_2_s18_q <= of_row_2_s17_q;
      not_1916_s18_q <= ~sum_1915[14];
      and_1919_s18_q <= sum_1915[8] & (~(sum_1915[7:0] == 8'h0));
      not_1921_s18_q <= ~(sum_1915[13:9] == 5'h0);
      and_1926_s18_q <= sum_1915[14] & (~(sum_1915[13:8] == 6'h3f));
      and_1942_s18_q <= and_1942;
      and_1945_s18_q <= and_1945;
      and_1959_s18_q <= and_1959_s17_q;
      and_1968_s18_q <= and_1968_s17_q;
      and_1973_s18_q <= and_1973_s17_q;
      not_1999_s18_q <= not_1999_s17_q;
      select_2064_s18_q <= select_2064_s17_q;
      sum_2076_s18_q <= {2'h0, x_s17_q[7:2]} + 8'hff;
      select_2078_s18_q <= select_2078_s17_q;
      difference_2089_s18_q <= {1'b0, textured_2_s17_q} - {1'b0, select_2088};
      or_2097_s18_q <= or_2097_s17_q;
      select_2108_s18_q <= select_2108;
      around_s18_q <= around;
      less_2142_s18_q <= {1'b0, around[4:1]} < n;
      and_2155_s18_q <= and_2155_s17_q;
      size_s18_q <= size;
      size_2_s18_q <= size_2;
      sum_2279_s18_q <= {1'b0, sum_2275} + {1'b0, sum_2278};
      sum_2282_s18_q <= {9'h0, difference_2280_s17_q} + {1'b0, xor_2281_s17_q};
      sum_2286_s18_q <= {9'h0, difference_2284_s17_q} + {1'b0, xor_2285_s17_q};
      sum_2290_s18_q <= {9'h0, difference_2288_s17_q} + {1'b0, xor_2289_s17_q};
      equal_2298_s18_q <= equal_2298_s17_q;
      select_2320_s18_q <= (select_2315 < select_2313) ? select_2313 : select_2315;
      not_2328_s18_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2326);
      not_2331_s18_q <= ~({3'h0, select_2315[13:2]} < sum_2326);
      not_2338_s18_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2336);
      not_2341_s18_q <= ~({3'h0, select_2313[13:2]} < sum_2336);
      contrast_s18_q <= contrast;
      contrast_2_s18_q <= contrast_2;
      equal_2415_s18_q <= x_s17_q[7:3] == 5'h0;
      equal_2486_s18_q <= equal_2486_s17_q;
      and_2621_s18_q <= and_2621_s17_q;
      not_2649_s18_q <= not_2649_s17_q;
      e_s18_q <= e;
      select_2675_s18_q <= select_2675_s17_q;
      select_2678_s18_q <= select_2678_s17_q;
      and_2728_s18_q <= and_2728_s17_q;
      and_2788_s18_q <= and_2788_s17_q;
      select_2808_s18_q <= equal_580_s17_q ? 8'h0 : (so_s17_q ? select_2806 : 8'h0);
      select_2818_s18_q <= equal_1711_s17_q ? {and_2817, and_2789_s17_q} : 2'h0;
      select_2833_s18_q <= equal_1711_s17_q ? {and_2832, and_2789_s17_q} : 2'h0;
      select_2885_s18_q <= select_2885;
      and_2893_s18_q <= equal_580_s17_q & (x_s17_q[6] & and_2891);
      select_2900_s18_q <= select_2900;
      and_2911_s18_q <= equal_580_s17_q & (x_s17_q[6] & and_2909);
      and_2915_s18_q <= and_2915;
      and_2947_s18_q <= equal_580_s17_q & (x_s17_q[6] & and_2945);
      and_2955_s18_q <= x_s17_q[6] & and_2954;
      word_s18_q <= word;
      equal_3145_s18_q <= patches_along_s17_q == 5'h7;
      less_3151_s18_q <= less_3151_s17_q;
      select_3184_s18_q <= select_3184;
      equal_3494_s18_q <= equal_3494_s17_q;
      select_3580_s18_q <= select_3580_s17_q;
      select_3581_s18_q <= select_3581_s17_q[2:0];
      select_3582_s18_q <= select_3582_s17_q;
      select_3590_s18_q <= patches_peak_far_q;
      equal_3591_s18_q <= equal_3591_s17_q;
      less_3619_s18_q <= less_3619_s17_q;
      fraction_s18_q <= fraction;
      select_3642_s18_q <= select_3642;
      sum_3643_s18_q <= sum_3643[0];
      sum_3645_s18_q <= sum_3645;
      equal_3687_s18_q <= equal_3687_s17_q;
      equal_3897_s18_q <= select_2675_s17_q[9:3] == 7'h0;
      or_3900_s18_q <= or_3900;
      select_3908_s18_q <= select_3908;
      not_3913_s18_q <= ~({sum_3911, select_2678_s17_q[0]} < {2'h0, select_2675_s17_q});
      equal_3919_s18_q <= equal_3919_s17_q;
      equal_3926_s18_q <= equal_3926_s17_q;
      equal_3928_s18_q <= equal_3928_s17_q;
      equal_3929_s18_q <= equal_3929_s17_q;
      equal_3930_s18_q <= equal_3930_s17_q;
      equal_3931_s18_q <= equal_3931_s17_q;
      or_4077_s18_q <= or_4077_s17_q;
      and_4091_s18_q <= and_4091_s17_q;
      and_4108_s18_q <= and_4108_s17_q;
      not_4120_s18_q <= not_4120_s17_q;
      and_4158_s18_q <= and_4158_s17_q;
      select_4182_s18_q <= select_4182;
      select_4189_s18_q <= select_4189_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic [13:0] moments_most_before_q;
  logic moments_left_alone_q;
  logic moments_left_other_stops_q;
  logic moments_right_alone_q;
  logic moments_right_other_stops_q;
  logic sharpness_last_mask_q;
  logic sharpness_before_last_mask_q;
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
  logic [51:0] patches_codes_at_q;
  logic [27:0] patches_codes_further_q;
  logic [55:0] patches_next_codes_q;
  logic patches_summed_first_q;
  logic [47:0] good_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  // hls/stages/agreement.hpp:461
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_q & whole_9_s18_q;
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
  // hls/stages/census.hpp:284
  logic [10:0] sum_730;
  assign sum_730 = sum_726_s18_q + {1'b0, sum_729_s18_q};
  // hls/stages/agreement.hpp:461
  logic and_744;
  assign and_744 = census_columns_values_0_cell_2_mask_s18_q & census_columns_values_1_cell_2_mask_q;
  logic and_745;
  assign and_745 = and_693_s18_q & and_744;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1624_s18_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1677;
  assign select_1677 = equal_1675_s18_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1814;
  assign select_1814 = equal_1701_s18_q ? patches_place_0_valid_q : (select_1700_s18_q ? patches_place_0_valid_q : is_chosen_s18_q);
  // hls/stages/patches.hpp:132
  logic equal_1820;
  assign equal_1820 = {sum_1819_s18_q, sum_1815_s18_q[0], select_514_s18_q} == {1'b0, sum_1815_s18_q[8:1], 4'h0};
  // hls/stages/patches.hpp:127
  logic select_1843;
  assign select_1843 = equal_1701_s18_q ? patches_place_1_valid_q : (select_1700_s18_q ? is_chosen_s18_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:132
  logic equal_1848;
  assign equal_1848 = {sum_1847_s18_q[8], sum_1815_s18_q, select_514_s18_q} == {1'b0, sum_1847_s18_q[7:0], 4'h0};
  // hls/stages/patches.hpp:495
  logic [2:0] sum_1907;
  assign sum_1907 = patches_code_row_s18_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:462
  logic and_1923;
  assign and_1923 = not_1916_s18_q & (and_1919_s18_q | not_1921_s18_q);
  // hls/stages/patches.hpp:499
  logic [1:0] sum_1963;
  assign sum_1963 = patches_code_row_s18_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:1340
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1292
  logic [10:0] sum_2065;
  assign sum_2065 = {1'b0, {5{select_2064_s18_q}}, 1'b0, {2{select_2064_s18_q}}, 1'b0, select_2064_s18_q} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1128
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2076_s18_q[7]}}, sum_2076_s18_q, x_s18_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1292
  logic [10:0] sum_2079;
  assign sum_2079 = {1'b0, {5{select_2078_s18_q}}, 1'b0, {2{select_2078_s18_q}}, 1'b0, select_2078_s18_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1110
  logic [4:0] t;
  assign t = {difference_2089_s18_q[3], difference_2089_s18_q} + (equal_575_s18_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1117
  logic [47:0] select_2109;
  assign select_2109 = or_2097_s18_q ? {select_2108_s18_q[23], 1'b0, select_2108_s18_q[22], 1'b0, select_2108_s18_q[21], 1'b0, select_2108_s18_q[20], 1'b0, select_2108_s18_q[19], 1'b0, select_2108_s18_q[18], 1'b0, select_2108_s18_q[17], 1'b0, select_2108_s18_q[16], 1'b0, select_2108_s18_q[15], 1'b0, select_2108_s18_q[14], 1'b0, select_2108_s18_q[13], 1'b0, select_2108_s18_q[12], 1'b0, select_2108_s18_q[11], 1'b0, select_2108_s18_q[10], 1'b0, select_2108_s18_q[9], 1'b0, select_2108_s18_q[8], 1'b0, select_2108_s18_q[7], 1'b0, select_2108_s18_q[6], 1'b0, select_2108_s18_q[5], 1'b0, select_2108_s18_q[4], 1'b0, select_2108_s18_q[3], 1'b0, select_2108_s18_q[2], 1'b0, select_2108_s18_q[1], 1'b0, select_2108_s18_q[0], 1'b0} : {1'b0, select_2108_s18_q[23], 1'b0, select_2108_s18_q[22], 1'b0, select_2108_s18_q[21], 1'b0, select_2108_s18_q[20], 1'b0, select_2108_s18_q[19], 1'b0, select_2108_s18_q[18], 1'b0, select_2108_s18_q[17], 1'b0, select_2108_s18_q[16], 1'b0, select_2108_s18_q[15], 1'b0, select_2108_s18_q[14], 1'b0, select_2108_s18_q[13], 1'b0, select_2108_s18_q[12], 1'b0, select_2108_s18_q[11], 1'b0, select_2108_s18_q[10], 1'b0, select_2108_s18_q[9], 1'b0, select_2108_s18_q[8], 1'b0, select_2108_s18_q[7], 1'b0, select_2108_s18_q[6], 1'b0, select_2108_s18_q[5], 1'b0, select_2108_s18_q[4], 1'b0, select_2108_s18_q[3], 1'b0, select_2108_s18_q[2], 1'b0, select_2108_s18_q[1], 1'b0, select_2108_s18_q[0]};
  // hls/stages/agreement.hpp:1119
  logic [5:0] sum_2126;
  assign sum_2126 = {1'b0, around_s18_q} + {2'h0, around_s18_q[4:1]};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size_s18_q} + (equal_558_s18_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2199;
  assign select_2199 = sample_pair_whole_s18_q ? (and_553_s18_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s18_q} + (equal_558_s18_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2207;
  assign select_2207 = sample_pair_whole_s18_q ? (and_553_s18_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:531
  logic select_2240;
  assign select_2240 = and_555_s18_q ? census_columns_values_0_cell_2_mask_s18_q : census_columns_values_1_cell_2_mask_q;
  logic select_2256;
  assign select_2256 = and_555_s18_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2259;
  assign select_2259 = and_555_s18_q ? census_columns_values_1_cell_3_mask_s18_q : census_columns_values_2_cell_3_mask_q;
  logic select_2262;
  assign select_2262 = and_555_s18_q ? census_columns_values_1_cell_4_mask_s18_q : census_columns_values_2_cell_4_mask_q;
  logic select_2263;
  assign select_2263 = and_555_s18_q ? census_columns_values_2_cell_0_mask_s18_q : census_columns_values_3_cell_0_mask_q;
  logic select_2266;
  assign select_2266 = and_555_s18_q ? census_columns_values_2_cell_1_mask_s18_q : census_columns_values_3_cell_1_mask_q;
  logic select_2267;
  assign select_2267 = and_555_s18_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2270;
  assign select_2270 = and_555_s18_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:286
  logic [10:0] sum_2283;
  assign sum_2283 = sum_2279_s18_q + {1'b0, sum_2282_s18_q};
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2322;
  assign sum_2322 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:531
  logic select_2379;
  assign select_2379 = and_555_s18_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2382;
  assign and_2382 = whole_2_s18_q & (~(last_s18_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:462
  logic and_2388;
  assign and_2388 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s18_q[8:2]));
  logic and_2389;
  assign and_2389 = and_2382 & and_2388;
  logic and_2400;
  assign and_2400 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s18_q[8:2]));
  logic and_2401;
  assign and_2401 = and_2382 & and_2400;
  // hls/stages/census.hpp:427
  logic not_2418;
  assign not_2418 = ~x_s18_q[1];
  logic [2:0] select_2419;
  assign select_2419 = x_s18_q[0] ? {1'b0, not_2418, 1'b0} : {x_s18_q[1], 1'b0, not_2418};
  logic [5:0] select_2420;
  assign select_2420 = slot_s18_q[2] ? {select_2419[2], 1'b0, select_2419[1], 1'b0, select_2419[0], 1'b0} : {1'b0, select_2419[2], 1'b0, select_2419[1], 1'b0, select_2419[0]};
  logic [11:0] select_2421;
  assign select_2421 = slot_s18_q[1] ? {select_2420[5], 1'b0, select_2420[4], 1'b0, select_2420[3], 1'b0, select_2420[2], 1'b0, select_2420[1], 1'b0, select_2420[0], 1'b0} : {1'b0, select_2420[5], 1'b0, select_2420[4], 1'b0, select_2420[3], 1'b0, select_2420[2], 1'b0, select_2420[1], 1'b0, select_2420[0]};
  // hls/stages/agreement.hpp:1118
  logic [5:0] sum_2662;
  assign sum_2662 = {1'b0, e_s18_q} + {2'h0, e_s18_q[4:1]};
  // hls/stages/agreement.hpp:1150
  logic [10:0] sum_2679;
  assign sum_2679 = {1'b0, select_2678_s18_q} + {3'h0, select_2678_s18_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2809;
  assign sum_2809 = registration_half_across_q + {{6{select_2808_s18_q[7]}}, select_2808_s18_q};
  // hls/stages/agreement.hpp:799
  logic [1:0] select_2820;
  assign select_2820 = equal_580_s18_q ? 2'h0 : (so_s18_q ? select_2818_s18_q : 2'h0);
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2821;
  assign sum_2821 = registration_half_votes_down_q + {{5{select_2820[1]}}, select_2820};
  // hls/stages/agreement.hpp:799
  logic [1:0] select_2835;
  assign select_2835 = equal_580_s18_q ? 2'h0 : (so_s18_q ? select_2833_s18_q : 2'h0);
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2836;
  assign sum_2836 = registration_half_half_votes_down_q + {{5{select_2835[1]}}, select_2835};
  // hls/stages/agreement.hpp:799
  logic and_2876;
  assign and_2876 = equal_580_s18_q & (x_s18_q[6] & (not_1999_s18_q & less_1649_s18_q));
  logic [11:0] select_2887;
  assign select_2887 = equal_580_s18_q ? (x_s18_q[6] ? select_2885_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2895;
  assign sum_2895 = {{2{select_2887[11]}}, select_2887} + (and_2893_s18_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:799
  logic [11:0] select_2902;
  assign select_2902 = equal_580_s18_q ? (x_s18_q[6] ? select_2900_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2904;
  assign sum_2904 = {{2{select_2902[11]}}, select_2902} + (and_2893_s18_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2916;
  assign not_2916 = ~and_2915_s18_q;
  logic less_2917;
  assign less_2917 = $signed({9'h1, {2{not_2916}}, and_2915_s18_q}) < $signed(registration_up_q[13:2]);
  logic select_2918;
  assign select_2918 = and_2911_s18_q ? less_2917 : registration_enough_q;
  // hls/stages/agreement.hpp:1159
  logic and_2922;
  assign and_2922 = x_s18_q[6] & (not_1999_s18_q & (less_1649_s18_q & (x_s18_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:799
  logic and_2923;
  assign and_2923 = equal_580_s18_q & and_2922;
  // hls/stages/registration.hpp:242
  logic less_2924;
  assign less_2924 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2926;
  assign less_2926 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2928;
  assign equal_2928 = x_s18_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:799
  logic and_2932;
  assign and_2932 = equal_580_s18_q & (x_s18_q[6] & (not_1999_s18_q & (less_1649_s18_q & equal_2928)));
  // hls/stages/agreement.hpp:1159
  logic and_2939;
  assign and_2939 = x_s18_q[6] & (not_1999_s18_q & (less_1649_s18_q & (x_s18_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2957;
  assign and_2957 = registration_votes_up_q & registration_other_down_q;
  logic select_2959;
  assign select_2959 = registration_votes_down_q ? (registration_other_up_q | and_2957) : and_2957;
  // hls/stages/registration.hpp:138
  logic and_2961;
  assign and_2961 = (equal_580_s18_q & and_2955_s18_q) & (registration_other_enough_q & select_2959);
  logic and_2963;
  assign and_2963 = registration_enough_q & ((and_2947_s18_q & (less_2926 | less_2924)) | and_2961);
  // hls/stages/patches.hpp:531
  logic [55:0] other;
  assign other = new_row_s18_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3141;
  assign select_3141 = or_1797_s18_q ? {and_1945_s18_q, and_1942_s18_q, and_1926_s18_q, and_1923, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3143;
  assign select_3143 = equal_1791_s18_q ? patches_codes_at_q : (equal_1793_s18_q ? other[55:4] : select_3141);
  // hls/stages/patches.hpp:530
  logic [27:0] select_3146;
  assign select_3146 = equal_3145_s18_q ? word_s18_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3148;
  assign select_3148 = equal_1793_s18_q ? (new_row_s18_q ? word_s18_q : select_3146) : patches_codes_further_q;
  // hls/stages/patches.hpp:532
  logic [55:0] select_3150;
  assign select_3150 = less_1886_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:502
  logic [55:0] select_3152;
  assign select_3152 = less_3151_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3154;
  assign select_3154 = or_1797_s18_q ? (equal_1796_s18_q ? patches_next_codes_q : select_3152) : patches_next_codes_q;
  logic [55:0] select_3156;
  assign select_3156 = equal_1791_s18_q ? patches_next_codes_q : (equal_1793_s18_q ? select_3150 : select_3154);
  // hls/stages/count_bits.hpp:24
  logic parity_3161;
  assign parity_3161 = ^{and_1945_s18_q, and_1942_s18_q, and_1926_s18_q, and_1923};
  // hls/stages/count_bits.hpp:25
  logic or_3165;
  assign or_3165 = ({and_1926_s18_q, and_1923} == 2'h3) | (and_1942_s18_q & (and_1926_s18_q | and_1923));
  logic and_3166;
  assign and_3166 = and_1945_s18_q & (^{and_1942_s18_q, and_1926_s18_q, and_1923});
  // hls/stages/count_bits.hpp:24
  logic xor_3167;
  assign xor_3167 = or_3165 ^ and_3166;
  // hls/stages/count_bits.hpp:27
  logic and_3168;
  assign and_3168 = or_3165 & and_3166;
  // hls/stages/patches.hpp:533
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3184_s18_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3190;
  assign xor_3190 = bits[17] ^ (^{select_3184_s18_q[16:15], other[16:15]});
  logic xor_3193;
  assign xor_3193 = bits[11] ^ (^{select_3184_s18_q[10:9], other[10:9]});
  logic xor_3196;
  assign xor_3196 = bits[14] ^ (^{select_3184_s18_q[13:12], other[13:12]});
  logic xor_3199;
  assign xor_3199 = xor_3190 ^ (^{select_3184_s18_q[14:9], other[14:9]});
  logic xor_3202;
  assign xor_3202 = bits[47] ^ (^{select_3184_s18_q[46:45], other[46:45]});
  logic xor_3205;
  assign xor_3205 = bits[8] ^ (^{select_3184_s18_q[7:6], other[7:6]});
  logic xor_3208;
  assign xor_3208 = bits[2] ^ (^{select_3184_s18_q[1:0], other[1:0]});
  logic xor_3211;
  assign xor_3211 = bits[5] ^ (^{select_3184_s18_q[4:3], other[4:3]});
  logic xor_3214;
  assign xor_3214 = xor_3205 ^ (^{select_3184_s18_q[5:0], other[5:0]});
  logic parity_3216;
  assign parity_3216 = ^{select_3184_s18_q[47:45], select_3184_s18_q[8:0], other[47:45], other[8:0]};
  logic xor_3220;
  assign xor_3220 = bits[44] ^ (^{select_3184_s18_q[43:42], other[43:42]});
  logic xor_3223;
  assign xor_3223 = bits[38] ^ (^{select_3184_s18_q[37:36], other[37:36]});
  logic xor_3226;
  assign xor_3226 = bits[41] ^ (^{select_3184_s18_q[40:39], other[40:39]});
  logic xor_3232;
  assign xor_3232 = bits[26] ^ (^{select_3184_s18_q[25:24], other[25:24]});
  logic xor_3235;
  assign xor_3235 = bits[20] ^ (^{select_3184_s18_q[19:18], other[19:18]});
  logic xor_3238;
  assign xor_3238 = bits[23] ^ (^{select_3184_s18_q[22:21], other[22:21]});
  logic xor_3244;
  assign xor_3244 = bits[35] ^ (^{select_3184_s18_q[34:33], other[34:33]});
  logic xor_3247;
  assign xor_3247 = bits[29] ^ (^{select_3184_s18_q[28:27], other[28:27]});
  logic xor_3250;
  assign xor_3250 = bits[32] ^ (^{select_3184_s18_q[31:30], other[31:30]});
  // hls/stages/agreement.hpp:276
  logic select_3534;
  assign select_3534 = equal_1791_s18_q ? patches_summed_first_q : (equal_1793_s18_q ? new_row_s18_q : patches_summed_first_q);
  // hls/stages/patches.hpp:591
  logic [1:0] sum_3620;
  assign sum_3620 = select_3582_s18_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:592
  logic [7:0] difference_3640;
  assign difference_3640 = {sum_3620, select_3582_s18_q[2:0], 3'h0} - {5'h0, fraction_s18_q};
  logic [7:0] select_3641;
  assign select_3641 = less_3619_s18_q ? difference_3640 : {sum_3620, select_3582_s18_q[2:0], fraction_s18_q};
  // hls/stages/patches.hpp:609
  logic [18:0] product_3646;
  assign product_3646 = $signed({{11{select_3642_s18_q[7]}}, select_3642_s18_q}) * $signed({{8{sum_3645_s18_q[6]}}, sum_3645_s18_q, sum_3643_s18_q, select_3581_s18_q});
  // hls/stages/patches.hpp:617
  logic [11:0] sum_3806;
  assign sum_3806 = {sum_3645_s18_q[6], sum_3645_s18_q, sum_3643_s18_q, select_3581_s18_q} + 12'h1;
  // hls/stages/agreement.hpp:1152
  logic select_3914;
  assign select_3914 = equal_3897_s18_q ? ((~or_3900_s18_q) & (~select_3908_s18_q)) : not_3913_s18_q;
  // hls/stages/agreement.hpp:1159
  logic [47:0] select_3916;
  assign select_3916 = x_s18_q[6] ? (equal_1618_s18_q ? good_q : {select_3914, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:799
  logic [4:0] select_4006;
  assign select_4006 = so_s18_q ? (ends_cell_s18_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:465
  logic [12:0] select_4080;
  assign select_4080 = equal_2486_s18_q ? (or_4077_s18_q ? (map_row_q + {6'h0, map_width_q}) : 13'h0) : map_row_q;
  // hls/stages/agreement.hpp:531
  logic [6:0] select_4083;
  assign select_4083 = and_555_s18_q ? (equal_2486_s18_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1907, patches_code_row_s18_q[1:0], of_row_2_s18_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s18_en & and_1959_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1945_s18_q, and_1942_s18_q, and_1926_s18_q, and_1923, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1963, patches_code_row_s18_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s18_en & and_1973_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1945_s18_q, and_1942_s18_q, and_1926_s18_q, and_1923, patches_codes_at_q[51:8]};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_most_before_q <= 14'h0;
      moments_left_alone_q <= 1'b0;
      moments_left_other_stops_q <= 1'b0;
      moments_right_alone_q <= 1'b0;
      moments_right_other_stops_q <= 1'b0;
      sharpness_before_last_mask_q <= 1'b0;
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
      patches_codes_at_q <= 52'h0;
      patches_codes_further_q <= 28'h0;
      patches_next_codes_q <= 56'h0;
      patches_summed_first_q <= 1'b0;
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
    end else if (s18_en) begin
      moments_most_before_q <= equal_580_s18_q ? select_2320_s18_q : moments_most_before_q;
      moments_left_alone_q <= equal_580_s18_q ? not_2328_s18_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_580_s18_q ? not_2331_s18_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_580_s18_q ? not_2338_s18_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_580_s18_q ? not_2341_s18_q : moments_right_other_stops_q;
      sharpness_before_last_mask_q <= select_2379;
      registration_half_across_q <= and_2788_s18_q ? 14'h0 : sum_2809;
      registration_half_votes_down_q <= and_2788_s18_q ? 7'h0 : sum_2821;
      registration_half_half_votes_down_q <= and_2788_s18_q ? 7'h0 : sum_2836;
      registration_down_q <= and_2876 ? sum_2895 : registration_down_q;
      registration_up_q <= and_2876 ? sum_2904 : registration_up_q;
      registration_enough_q <= select_2918;
      registration_votes_down_q <= and_2923 ? less_2924 : registration_votes_down_q;
      registration_votes_up_q <= and_2923 ? less_2926 : registration_votes_up_q;
      registration_other_enough_q <= and_2932 ? select_2918 : registration_other_enough_q;
      registration_other_down_q <= and_2932 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2932 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s18_q ? select_1814 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s18_q ? select_1843 : patches_place_1_valid_q;
      patches_codes_at_q <= select_3143;
      patches_codes_further_q <= equal_1791_s18_q ? patches_codes_further_q : select_3148;
      patches_next_codes_q <= select_3156;
      patches_summed_first_q <= select_3534;
      good_q <= equal_580_s18_q ? select_3916 : good_q;
      map_row_q <= and_555_s18_q ? select_4080 : map_row_q;
      map_width_q <= select_4083;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_detail_0_q = 14'h0;
    averager_detail_1_q = 14'h0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_3_mask_q = 1'b0;
    census_columns_values_2_cell_4_mask_q = 1'b0;
    census_columns_values_3_cell_0_mask_q = 1'b0;
    census_columns_values_3_cell_1_mask_q = 1'b0;
    census_columns_values_3_cell_2_mask_q = 1'b0;
    census_columns_values_3_cell_3_mask_q = 1'b0;
    sharpness_last_mask_q = 1'b0;
    box_textured_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s18_en) begin
      averager_detail_0_q <= select_2199;
      averager_detail_1_q <= select_2207;
      census_columns_values_1_cell_2_mask_q <= select_2240;
      census_columns_values_2_cell_2_mask_q <= select_2256;
      census_columns_values_2_cell_3_mask_q <= select_2259;
      census_columns_values_2_cell_4_mask_q <= select_2262;
      census_columns_values_3_cell_0_mask_q <= select_2263;
      census_columns_values_3_cell_1_mask_q <= select_2266;
      census_columns_values_3_cell_2_mask_q <= select_2267;
      census_columns_values_3_cell_3_mask_q <= select_2270;
      sharpness_last_mask_q <= and_555_s18_q ? whole_2_s18_q : sharpness_last_mask_q;
      box_textured_sum_sums_values_0_q <= equal_580_s18_q ? box_textured_sum_sums_values_0_q : select_4006;
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
  logic moments_left_alone_s19_q;
  logic moments_left_other_stops_s19_q;
  logic moments_right_alone_s19_q;
  logic moments_right_other_stops_s19_q;
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
  logic row_starts_s19_q;
  logic [6:0] last_s19_q;
  logic and_555_s19_q;
  logic equal_580_s19_q;
  logic not_581_s19_q;
  logic so_s19_q;
  logic less_662_s19_q;
  logic less_663_s19_q;
  logic less_664_s19_q;
  logic less_665_s19_q;
  logic less_666_s19_q;
  logic less_667_s19_q;
  logic less_668_s19_q;
  logic less_669_s19_q;
  logic less_670_s19_q;
  logic less_671_s19_q;
  logic less_672_s19_q;
  logic less_673_s19_q;
  logic less_674_s19_q;
  logic less_675_s19_q;
  logic less_676_s19_q;
  logic less_677_s19_q;
  logic less_678_s19_q;
  logic less_679_s19_q;
  logic less_680_s19_q;
  logic less_681_s19_q;
  logic less_682_s19_q;
  logic less_683_s19_q;
  logic less_684_s19_q;
  logic less_685_s19_q;
  logic and_693_s19_q;
  logic whole_16_s19_q;
  logic and_719_s19_q;
  logic [11:0] sum_734_s19_q;
  logic [9:0] sum_737_s19_q;
  logic and_745_s19_q;
  logic and_749_s19_q;
  logic less_750_s19_q;
  logic less_754_s19_q;
  logic less_756_s19_q;
  logic equal_1618_s19_q;
  logic [1:0] sum_1624_s19_q;
  logic equal_1626_s19_q;
  logic equal_1628_s19_q;
  logic equal_1630_s19_q;
  logic equal_1632_s19_q;
  logic equal_1634_s19_q;
  logic equal_1636_s19_q;
  logic [19:0] sum_1678_s19_q;
  logic [11:0] sum_1682_s19_q;
  logic and_1683_s19_q;
  logic select_1700_s19_q;
  logic equal_1701_s19_q;
  logic equal_1791_s19_q;
  logic equal_1793_s19_q;
  logic equal_1796_s19_q;
  logic or_1797_s19_q;
  logic not_1798_s19_q;
  logic equal_1808_s19_q;
  logic is_chosen_s19_q;
  logic or_1822_s19_q;
  logic [4:0] select_1826_s19_q;
  logic select_1832_s19_q;
  logic or_1850_s19_q;
  logic or_1863_s19_q;
  logic or_1867_s19_q;
  logic [3:0] select_1870_s19_q;
  logic not_1999_s19_q;
  logic [2:0] index_s19_q;
  logic [10:0] sum_2065_s19_q;
  logic and_2072_s19_q;
  logic less_2073_s19_q;
  logic [2:0] index_2_s19_q;
  logic [10:0] sum_2079_s19_q;
  logic equal_2092_s19_q;
  logic not_2112_s19_q;
  logic not_2128_s19_q;
  logic less_2142_s19_q;
  logic and_2155_s19_q;
  logic [11:0] sum_2287_s19_q;
  logic [9:0] sum_2290_s19_q;
  logic equal_2298_s19_q;
  logic not_2324_s19_q;
  logic not_2334_s19_q;
  logic [27:0] select_2376_s19_q;
  logic and_2389_s19_q;
  logic and_2401_s19_q;
  logic [8:0] select_2408_s19_q;
  logic [8:0] select_2412_s19_q;
  logic equal_2415_s19_q;
  logic less_2416_s19_q;
  logic [11:0] select_2421_s19_q;
  logic equal_2459_s19_q;
  logic and_2621_s19_q;
  logic not_2649_s19_q;
  logic not_2664_s19_q;
  logic [9:0] select_2675_s19_q;
  logic [9:0] select_2678_s19_q;
  logic less_2680_s19_q;
  logic and_2728_s19_q;
  logic equal_2928_s19_q;
  logic not_2941_s19_q;
  logic and_2963_s19_q;
  logic [8:0] other_s19_q;
  logic [2:0] select_3169_s19_q;
  logic [8:0] select_3184_s19_q;
  logic xor_3199_s19_q;
  logic xor_3217_s19_q;
  logic xor_3229_s19_q;
  logic xor_3241_s19_q;
  logic xor_3253_s19_q;
  logic or_3262_s19_q;
  logic or_3266_s19_q;
  logic or_3270_s19_q;
  logic or_3277_s19_q;
  logic or_3281_s19_q;
  logic or_3285_s19_q;
  logic or_3292_s19_q;
  logic or_3296_s19_q;
  logic or_3300_s19_q;
  logic or_3310_s19_q;
  logic or_3314_s19_q;
  logic or_3318_s19_q;
  logic or_3326_s19_q;
  logic or_3330_s19_q;
  logic or_3334_s19_q;
  logic or_3341_s19_q;
  logic or_3345_s19_q;
  logic or_3349_s19_q;
  logic or_3359_s19_q;
  logic or_3363_s19_q;
  logic or_3367_s19_q;
  logic and_3372_s19_q;
  logic or_3373_s19_q;
  logic equal_3494_s19_q;
  logic [9:0] select_3580_s19_q;
  logic [9:0] select_3590_s19_q;
  logic equal_3591_s19_q;
  logic not_3596_s19_q;
  logic [7:0] select_3641_s19_q;
  logic [13:0] product_3646_s19_q;
  logic equal_3687_s19_q;
  logic less_3807_s19_q;
  logic or_3900_s19_q;
  logic select_3908_s19_q;
  logic equal_3919_s19_q;
  logic equal_3926_s19_q;
  logic equal_3928_s19_q;
  logic equal_3929_s19_q;
  logic equal_3930_s19_q;
  logic equal_3931_s19_q;
  logic and_4091_s19_q;
  logic and_4108_s19_q;
  logic not_4120_s19_q;
  logic and_4158_s19_q;
  logic [31:0] select_4182_s19_q;
  logic [9:0] select_4189_s19_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s19_q <= pixel_0_s18_q;
      pixel_1_s19_q <= pixel_1_s18_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
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
      moments_left_alone_s19_q <= moments_left_alone_q;
      moments_left_other_stops_s19_q <= moments_left_other_stops_q;
      moments_right_alone_s19_q <= moments_right_alone_q;
      moments_right_other_stops_s19_q <= moments_right_other_stops_q;
      x_s19_q <= x_s18_q;
      slot_s19_q <= slot_s18_q[0];
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      counts_nearer_s19_q <= counts_nearer_s18_q;
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
      row_starts_s19_q <= row_starts_s18_q;
      last_s19_q <= last_s18_q;
      and_555_s19_q <= and_555_s18_q;
      equal_580_s19_q <= equal_580_s18_q;
      not_581_s19_q <= not_581_s18_q;
      so_s19_q <= so_s18_q;
      less_662_s19_q <= less_662_s18_q;
      less_663_s19_q <= less_663_s18_q;
      less_664_s19_q <= less_664_s18_q;
      less_665_s19_q <= less_665_s18_q;
      less_666_s19_q <= less_666_s18_q;
      less_667_s19_q <= less_667_s18_q;
      less_668_s19_q <= less_668_s18_q;
      less_669_s19_q <= less_669_s18_q;
      less_670_s19_q <= less_670_s18_q;
      less_671_s19_q <= less_671_s18_q;
      less_672_s19_q <= less_672_s18_q;
      less_673_s19_q <= less_673_s18_q;
      less_674_s19_q <= less_674_s18_q;
      less_675_s19_q <= less_675_s18_q;
      less_676_s19_q <= less_676_s18_q;
      less_677_s19_q <= less_677_s18_q;
      less_678_s19_q <= less_678_s18_q;
      less_679_s19_q <= less_679_s18_q;
      less_680_s19_q <= less_680_s18_q;
      less_681_s19_q <= less_681_s18_q;
      less_682_s19_q <= less_682_s18_q;
      less_683_s19_q <= less_683_s18_q;
      less_684_s19_q <= less_684_s18_q;
      less_685_s19_q <= less_685_s18_q;
      and_693_s19_q <= and_693_s18_q;
      whole_16_s19_q <= whole_16;
      and_719_s19_q <= census_columns_values_1_cell_2_mask_q & and_693_s18_q;
      sum_734_s19_q <= {1'b0, sum_730} + {2'h0, sum_733_s18_q};
      sum_737_s19_q <= sum_737_s18_q;
      and_745_s19_q <= and_745;
      and_749_s19_q <= and_745 & less_748_s18_q;
      less_750_s19_q <= less_750_s18_q;
      less_754_s19_q <= less_754_s18_q;
      less_756_s19_q <= less_756_s18_q;
      equal_1618_s19_q <= equal_1618_s18_q;
      sum_1624_s19_q <= sum_1624_s18_q;
      equal_1626_s19_q <= equal_1626_s18_q;
      equal_1628_s19_q <= equal_1628_s18_q;
      equal_1630_s19_q <= equal_1630_s18_q;
      equal_1632_s19_q <= equal_1632_s18_q;
      equal_1634_s19_q <= equal_1634_s18_q;
      equal_1636_s19_q <= equal_1636_s18_q;
      sum_1678_s19_q <= select_1674_s18_q + {{6{select_1677[13]}}, select_1677};
      sum_1682_s19_q <= sum_1682_s18_q;
      and_1683_s19_q <= and_1683_s18_q;
      select_1700_s19_q <= select_1700_s18_q;
      equal_1701_s19_q <= equal_1701_s18_q;
      equal_1791_s19_q <= equal_1791_s18_q;
      equal_1793_s19_q <= equal_1793_s18_q;
      equal_1796_s19_q <= equal_1796_s18_q;
      or_1797_s19_q <= or_1797_s18_q;
      not_1798_s19_q <= not_1798_s18_q;
      equal_1808_s19_q <= equal_1808_s18_q;
      is_chosen_s19_q <= is_chosen_s18_q;
      or_1822_s19_q <= row_starts_s18_q | (select_1814 & equal_1820);
      select_1826_s19_q <= select_1826_s18_q;
      select_1832_s19_q <= select_1832_s18_q;
      or_1850_s19_q <= row_starts_s18_q | (select_1843 & equal_1848);
      or_1863_s19_q <= row_starts_s18_q | (select_1814 & equal_1861_s18_q);
      or_1867_s19_q <= row_starts_s18_q | (select_1843 & equal_1865_s18_q);
      select_1870_s19_q <= select_1870_s18_q;
      not_1999_s19_q <= not_1999_s18_q;
      index_s19_q <= index[2:0];
      sum_2065_s19_q <= sum_2065;
      and_2072_s19_q <= began_q & (seen_x_q == 4'h0);
      less_2073_s19_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s19_q <= index_2[2:0];
      sum_2079_s19_q <= sum_2079;
      equal_2092_s19_q <= t[4:1] == 4'h0;
      not_2112_s19_q <= ~((good_q & select_2109) == 48'h0);
      not_2128_s19_q <= ~({sum_2126, around_s18_q[0]} < {2'h0, t});
      less_2142_s19_q <= less_2142_s18_q;
      and_2155_s19_q <= and_2155_s18_q;
      sum_2287_s19_q <= {1'b0, sum_2283} + {2'h0, sum_2286_s18_q};
      sum_2290_s19_q <= sum_2290_s18_q;
      equal_2298_s19_q <= equal_2298_s18_q;
      not_2324_s19_q <= ~({3'h0, counts_turned_left_s18_q} < sum_2322);
      not_2334_s19_q <= ~({3'h0, counts_turned_right_s18_q} < sum_2322);
      select_2376_s19_q <= sample_pair_whole_s18_q ? {detail_2, detail} : 28'h0;
      and_2389_s19_q <= and_2389;
      and_2401_s19_q <= and_2401;
      select_2408_s19_q <= and_2389 ? contrast_s18_q : 9'h0;
      select_2412_s19_q <= and_2401 ? contrast_2_s18_q : 9'h0;
      equal_2415_s19_q <= equal_2415_s18_q;
      less_2416_s19_q <= 7'h2 < {x_s18_q[4:0], slot_s18_q[2:1]};
      select_2421_s19_q <= select_2421;
      equal_2459_s19_q <= {x_s18_q[4:0], slot_s18_q} == 8'h0;
      and_2621_s19_q <= and_2621_s18_q;
      not_2649_s19_q <= not_2649_s18_q;
      not_2664_s19_q <= ~({sum_2662, e_s18_q[0]} < {2'h0, t});
      select_2675_s19_q <= select_2675_s18_q;
      select_2678_s19_q <= select_2678_s18_q;
      less_2680_s19_q <= {sum_2679, select_2678_s18_q[1:0]} < {3'h0, select_2675_s18_q};
      and_2728_s19_q <= and_2728_s18_q;
      equal_2928_s19_q <= equal_2928;
      not_2941_s19_q <= ~(equal_580_s18_q & and_2939);
      and_2963_s19_q <= and_2963;
      other_s19_q <= other[44:36];
      select_3169_s19_q <= and_1968_s18_q ? {and_3168, xor_3167, parity_3161} : 3'h0;
      select_3184_s19_q <= select_3184_s18_q[44:36];
      xor_3199_s19_q <= xor_3199;
      xor_3217_s19_q <= xor_3199 ^ parity_3216;
      xor_3229_s19_q <= xor_3220 ^ (^{select_3184_s18_q[41:36], other[41:36]});
      xor_3241_s19_q <= xor_3232 ^ (^{select_3184_s18_q[23:18], other[23:18]});
      xor_3253_s19_q <= xor_3244 ^ (^{select_3184_s18_q[32:27], other[32:27]});
      or_3262_s19_q <= (xor_3193 & xor_3196) | (xor_3190 & (xor_3193 | xor_3196));
      or_3266_s19_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3270_s19_q <= (xor_3208 & xor_3211) | (xor_3205 & (xor_3208 | xor_3211));
      or_3277_s19_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3281_s19_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3285_s19_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3292_s19_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3296_s19_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3300_s19_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3310_s19_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3314_s19_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3318_s19_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3326_s19_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3330_s19_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3334_s19_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3341_s19_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3345_s19_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3349_s19_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3359_s19_q <= (xor_3223 & xor_3226) | (xor_3220 & (xor_3223 | xor_3226));
      or_3363_s19_q <= (xor_3235 & xor_3238) | (xor_3232 & (xor_3235 | xor_3238));
      or_3367_s19_q <= (xor_3247 & xor_3250) | (xor_3244 & (xor_3247 | xor_3250));
      and_3372_s19_q <= xor_3202 & xor_3214;
      or_3373_s19_q <= xor_3202 | xor_3214;
      equal_3494_s19_q <= equal_3494_s18_q;
      select_3580_s19_q <= select_3580_s18_q;
      select_3590_s19_q <= select_3590_s18_q;
      equal_3591_s19_q <= equal_3591_s18_q;
      not_3596_s19_q <= ~(select_3582_s18_q[3:0] == 4'h0);
      select_3641_s19_q <= select_3641;
      product_3646_s19_q <= product_3646[18:5];
      equal_3687_s19_q <= equal_3687_s18_q;
      less_3807_s19_q <= {{4{sum_3806[11]}}, sum_3806} < 16'h3;
      or_3900_s19_q <= or_3900_s18_q;
      select_3908_s19_q <= select_3908_s18_q;
      equal_3919_s19_q <= equal_3919_s18_q;
      equal_3926_s19_q <= equal_3926_s18_q;
      equal_3928_s19_q <= equal_3928_s18_q;
      equal_3929_s19_q <= equal_3929_s18_q;
      equal_3930_s19_q <= equal_3930_s18_q;
      equal_3931_s19_q <= equal_3931_s18_q;
      and_4091_s19_q <= and_4091_s18_q;
      and_4108_s19_q <= and_4108_s18_q;
      not_4120_s19_q <= not_4120_s18_q;
      and_4158_s19_q <= and_4158_s18_q;
      select_4182_s19_q <= select_4182_s18_q;
      select_4189_s19_q <= select_4189_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_3_cell_4_mask_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic moments_left_begins_q;
  logic moments_right_begins_q;
  logic moments_ends_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic registration_moved_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic [9:0] patches_peak_size_q;
  logic good_known_q;
  // hls/stages/agreement.hpp:461
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
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_734_s19_q + {2'h0, sum_737_s19_q};
  // hls/stages/patches.hpp:134
  logic [5:0] select_1833;
  assign select_1833 = or_1822_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1835;
  assign and_1835 = select_1832_s19_q & (~select_1833[5]);
  // hls/stages/patches.hpp:134
  logic [5:0] select_1852;
  assign select_1852 = or_1850_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1854;
  assign and_1854 = select_1832_s19_q & (~select_1852[5]);
  // hls/stages/patches.hpp:135
  logic [4:0] select_1864;
  assign select_1864 = or_1863_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1868;
  assign select_1868 = or_1867_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1864[4] ? select_1868[3:0] : select_1864[3:0];
  logic and_1873;
  assign and_1873 = select_1832_s19_q & (select_1826_s19_q[3] ^ select_1826_s19_q[4]);
  logic and_1878;
  assign and_1878 = sample_pair_whole_s19_q & (and_1873 & ((~select_1864[4]) | (~select_1868[4])));
  // hls/stages/agreement.hpp:1045
  logic and_2113;
  assign and_2113 = good_known_q & not_2112_s19_q;
  // hls/stages/agreement.hpp:1119
  logic is_seen;
  assign is_seen = equal_2092_s19_q ? and_2113 : not_2128_s19_q;
  // hls/stages/agreement.hpp:531
  logic select_2271;
  assign select_2271 = and_555_s19_q ? census_columns_values_2_cell_4_mask_s19_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2291;
  assign sum_2291 = sum_2287_s19_q + {2'h0, sum_2290_s19_q};
  // hls/stages/agreement.hpp:531
  logic [11:0] select_2293;
  assign select_2293 = and_555_s19_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2294;
  assign select_2294 = and_555_s19_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:106
  logic and_2359;
  assign and_2359 = moments_right_alone_s19_q & (moments_right_begins_q | moments_right_other_stops_s19_q);
  logic or_2361;
  assign or_2361 = moments_left_begins_q | (moments_left_other_stops_s19_q | and_2359);
  logic and_2363;
  assign and_2363 = cfg_same_table_i & (moments_left_alone_s19_q ? or_2361 : and_2359);
  // hls/stages/moments.hpp:107
  logic and_2369;
  assign and_2369 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/agreement.hpp:531
  logic [13:0] select_2377;
  assign select_2377 = and_555_s19_q ? select_2376_s19_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2378;
  assign select_2378 = and_555_s19_q ? select_2376_s19_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2376_s19_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2376_s19_q[27:14]};
  // hls/stages/census.hpp:375
  logic [23:0] sum_2409;
  assign sum_2409 = (equal_2298_s19_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2408_s19_q};
  logic [23:0] sum_2413;
  assign sum_2413 = (equal_2298_s19_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2412_s19_q};
  // hls/stages/census.hpp:427
  logic less_2417;
  assign less_2417 = x_s19_q[4:0] < 5'h3;
  logic [23:0] select_2422;
  assign select_2422 = slot_s19_q ? {select_2421_s19_q[11], 1'b0, select_2421_s19_q[10], 1'b0, select_2421_s19_q[9], 1'b0, select_2421_s19_q[8], 1'b0, select_2421_s19_q[7], 1'b0, select_2421_s19_q[6], 1'b0, select_2421_s19_q[5], 1'b0, select_2421_s19_q[4], 1'b0, select_2421_s19_q[3], 1'b0, select_2421_s19_q[2], 1'b0, select_2421_s19_q[1], 1'b0, select_2421_s19_q[0], 1'b0} : {1'b0, select_2421_s19_q[11], 1'b0, select_2421_s19_q[10], 1'b0, select_2421_s19_q[9], 1'b0, select_2421_s19_q[8], 1'b0, select_2421_s19_q[7], 1'b0, select_2421_s19_q[6], 1'b0, select_2421_s19_q[5], 1'b0, select_2421_s19_q[4], 1'b0, select_2421_s19_q[3], 1'b0, select_2421_s19_q[2], 1'b0, select_2421_s19_q[1], 1'b0, select_2421_s19_q[0]};
  // hls/stages/census.hpp:390
  logic and_2426;
  assign and_2426 = less_2417 & (~((sharpness_sums_contrast_1_q & select_2422) == 24'h0));
  logic and_2436;
  assign and_2436 = less_2417 & (~((sharpness_sums_contrast_0_q & select_2422) == 24'h0));
  // hls/stages/agreement.hpp:1123
  logic not_2666;
  assign not_2666 = ~(equal_2092_s19_q ? and_2113 : not_2664_s19_q);
  // hls/stages/agreement.hpp:799
  logic and_2669;
  assign and_2669 = ends_cell_s19_q & (not_2649_s19_q & (centres_values_1_textured_s19_q & not_2666));
  // hls/stages/agreement.hpp:1155
  logic [9:0] select_2682;
  assign select_2682 = ((~(select_2675_s19_q[9:4] == 6'h0)) & less_2680_s19_q) ? select_2675_s19_q : 10'h0;
  // hls/stages/agreement.hpp:799
  logic [9:0] select_2685;
  assign select_2685 = equal_580_s19_q ? (x_s19_q[6] ? (equal_1618_s19_q ? 10'h0 : select_2682) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1127
  logic and_2704;
  assign and_2704 = centres_values_1_textured_s19_q & (centres_values_1_of_skin_s19_q & not_2666);
  // hls/stages/patches.hpp:127
  logic select_3054;
  assign select_3054 = equal_1701_s19_q ? patches_valid_0_q : (select_1700_s19_q ? patches_valid_0_q : is_chosen_s19_q);
  // hls/stages/agreement.hpp:277
  logic select_3057;
  assign select_3057 = sample_pair_whole_s19_q ? (and_1835 ? (sample_present_s19_q & select_3054) : select_3054) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3059;
  assign select_3059 = equal_1701_s19_q ? patches_valid_1_q : (select_1700_s19_q ? is_chosen_s19_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3062;
  assign select_3062 = sample_pair_whole_s19_q ? (and_1854 ? (sample_present_s19_q & select_3059) : select_3059) : patches_valid_1_q;
  logic [5:0] select_3065;
  assign select_3065 = sample_pair_whole_s19_q ? (select_1833[5] ? {1'b1, select_1833[4:0]} : (select_1833 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3068;
  assign select_3068 = sample_pair_whole_s19_q ? (select_1852[5] ? {1'b1, select_1852[4:0]} : (select_1852 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3071;
  assign select_3071 = sample_pair_whole_s19_q ? (select_1864[4] ? {1'b1, select_1864[3:0]} : (select_1864 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3074;
  assign select_3074 = sample_pair_whole_s19_q ? (select_1868[4] ? {1'b1, select_1868[3:0]} : (select_1868 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3171;
  assign select_3171 = equal_1793_s19_q ? 3'h0 : (or_1797_s19_q ? select_3169_s19_q : 3'h0);
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3174;
  assign sum_3174 = {7'h0, patches_set_q} + (equal_1796_s19_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3254;
  assign xor_3254 = xor_3241_s19_q ^ xor_3253_s19_q;
  // hls/stages/count_bits.hpp:25
  logic or_3379;
  assign or_3379 = (xor_3241_s19_q & xor_3253_s19_q) | (xor_3229_s19_q & (xor_3241_s19_q | xor_3253_s19_q));
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3593;
  assign select_3593 = equal_1791_s19_q ? (equal_3591_s19_q ? sum_3174 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/patches.hpp:610
  logic [14:0] difference_3647;
  assign difference_3647 = {{7{select_3641_s19_q[7]}}, select_3641_s19_q} - {product_3646_s19_q[13], product_3646_s19_q};
  // hls/stages/agreement.hpp:799
  logic select_3921;
  assign select_3921 = equal_580_s19_q ? ((x_s19_q[6] & good_known_q) | equal_3919_s19_q) : good_known_q;
  // hls/stages/agreement.hpp:1340
  logic and_4106;
  assign and_4106 = and_2155_s19_q & ({sum_2079_s19_q, index_2_s19_q} == {sum_2065_s19_q, index_s19_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1444; read in stage 19, written in stage 20: 19 < 20 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2065_s19_q, index_s19_q};
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s19_en & (and_2072_s19_q & less_2073_s19_q);
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1624_s19_q, lower_half_s19_q, registration_of_right_s19_q};
  logic registration_sums_we;
  assign registration_sums_we = s19_en & and_1683_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1682_s19_q, sum_1678_s19_q};
  end
`ifndef SYNTHESIS
  logic [3:0] registration_sums_raddr_s16_sim;
  logic registration_sums_re_s16_sim;
  logic [3:0] registration_sums_raddr_s17_sim;
  logic registration_sums_re_s17_sim;
  logic [3:0] registration_sums_raddr_s18_sim;
  logic registration_sums_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_sums_re_s16_sim <= 1'b0;
      registration_sums_re_s17_sim <= 1'b0;
      registration_sums_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      registration_sums_re_s16_sim <= registration_sums_re;
      registration_sums_raddr_s16_sim <= registration_sums_raddr;
      registration_sums_re_s17_sim <= registration_sums_re_s16_sim;
      registration_sums_raddr_s17_sim <= registration_sums_raddr_s16_sim;
      registration_sums_re_s18_sim <= registration_sums_re_s17_sim;
      registration_sums_raddr_s18_sim <= registration_sums_raddr_s17_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s16_sim && registration_sums_raddr_s16_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s17_sim && registration_sums_raddr_s17_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s18_sim && registration_sums_raddr_s18_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_waddr >= 4'd12) $error("registration_sums: write outside, address %0d", registration_sums_waddr);
    end
    if (rst_ni && registration_sums_re && registration_sums_raddr >= 4'd12) $error("registration_sums: read outside, address %0d", registration_sums_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_left_begins_q <= 1'b0;
      moments_right_begins_q <= 1'b0;
      moments_ends_q <= 1'b0;
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      registration_moved_q <= 1'b0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      patches_peak_size_q <= 10'h0;
      good_known_q <= 1'b0;
    end else if (s19_en) begin
      moments_left_begins_q <= equal_580_s19_q ? not_2324_s19_q : moments_left_begins_q;
      moments_right_begins_q <= equal_580_s19_q ? not_2334_s19_q : moments_right_begins_q;
      moments_ends_q <= equal_580_s19_q & (equal_1808_s19_q & (not_2367 | and_2369));
      sharpness_sums_contrast_0_q <= and_555_s19_q ? sum_2409 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_555_s19_q ? sum_2413 : sharpness_sums_contrast_1_q;
      registration_moved_q <= not_2941_s19_q & (registration_moved_q | and_2963_s19_q);
      patches_valid_0_q <= select_3057;
      patches_valid_1_q <= select_3062;
      patches_right_next_0_q <= select_3065;
      patches_right_next_1_q <= select_3068;
      patches_left_next_0_q <= select_3071;
      patches_left_next_1_q <= select_3074;
      patches_set_q <= equal_1791_s19_q ? 3'h0 : select_3171;
      patches_size_q <= sum_3174;
      patches_peak_size_q <= select_3593;
      good_known_q <= select_3921;
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
    if (s19_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2271;
      census_changes_values_0_left_q <= and_555_s19_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_555_s19_q ? sum_2291 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2293;
      census_changes_values_1_right_q <= select_2294;
      sharpness_last_detail_0_q <= select_2377;
      sharpness_last_detail_1_q <= select_2378;
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
  logic census_columns_values_1_cell_2_of_skin_s20_q;
  logic [11:0] census_changes_values_1_left_s20_q;
  logic [11:0] census_changes_values_1_right_s20_q;
  logic [23:0] sharpness_sums_contrast_0_s20_q;
  logic [23:0] sharpness_sums_contrast_1_s20_q;
  logic [6:0] x_s20_q;
  logic [13:0] counts_nearer_s20_q;
  logic registration_moved_s20_q;
  logic patches_lower_s20_q;
  logic patches_second_s20_q;
  logic [4:0] patches_summed_row_column_s20_q;
  logic patches_summed_first_s20_q;
  logic patches_summed_last_s20_q;
  logic [4:0] patches_summed_down_by_s20_q;
  logic [13:0] product_s20_q;
  logic [6:0] last_s20_q;
  logic and_555_s20_q;
  logic equal_580_s20_q;
  logic not_581_s20_q;
  logic so_s20_q;
  logic less_662_s20_q;
  logic less_663_s20_q;
  logic less_664_s20_q;
  logic less_665_s20_q;
  logic less_666_s20_q;
  logic less_667_s20_q;
  logic less_668_s20_q;
  logic less_669_s20_q;
  logic less_670_s20_q;
  logic less_671_s20_q;
  logic less_672_s20_q;
  logic less_673_s20_q;
  logic less_674_s20_q;
  logic less_675_s20_q;
  logic less_676_s20_q;
  logic less_677_s20_q;
  logic less_678_s20_q;
  logic less_679_s20_q;
  logic less_680_s20_q;
  logic less_681_s20_q;
  logic less_682_s20_q;
  logic less_683_s20_q;
  logic less_684_s20_q;
  logic less_685_s20_q;
  logic and_693_s20_q;
  logic and_718_s20_q;
  logic and_719_s20_q;
  logic [12:0] sum_739_s20_q;
  logic and_745_s20_q;
  logic and_749_s20_q;
  logic less_750_s20_q;
  logic less_754_s20_q;
  logic less_756_s20_q;
  logic equal_1618_s20_q;
  logic equal_1626_s20_q;
  logic equal_1628_s20_q;
  logic equal_1630_s20_q;
  logic equal_1632_s20_q;
  logic equal_1634_s20_q;
  logic equal_1636_s20_q;
  logic equal_1791_s20_q;
  logic equal_1793_s20_q;
  logic not_1798_s20_q;
  logic equal_1808_s20_q;
  logic [4:0] select_1823_s20_q;
  logic [4:0] select_1826_s20_q;
  logic and_1836_s20_q;
  logic [4:0] select_1851_s20_q;
  logic and_1855_s20_q;
  logic [3:0] column_4_s20_q;
  logic [3:0] select_1870_s20_q;
  logic select_1871_s20_q;
  logic and_1878_s20_q;
  logic not_1999_s20_q;
  logic and_2072_s20_q;
  logic less_2073_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_2079_s20_q;
  logic is_seen_s20_q;
  logic and_2143_s20_q;
  logic and_2155_s20_q;
  logic equal_2298_s20_q;
  logic [12:0] sum_2299_s20_q;
  logic not_2343_s20_q;
  logic and_2364_s20_q;
  logic [12:0] select_2391_s20_q;
  logic [12:0] select_2403_s20_q;
  logic equal_2415_s20_q;
  logic less_2416_s20_q;
  logic and_2426_s20_q;
  logic and_2436_s20_q;
  logic equal_2459_s20_q;
  logic and_2621_s20_q;
  logic and_2671_s20_q;
  logic [9:0] select_2675_s20_q;
  logic [9:0] select_2678_s20_q;
  logic [9:0] select_2685_s20_q;
  logic and_2707_s20_q;
  logic and_2728_s20_q;
  logic equal_2928_s20_q;
  logic parity_3258_s20_q;
  logic or_3262_s20_q;
  logic or_3266_s20_q;
  logic or_3270_s20_q;
  logic or_3277_s20_q;
  logic or_3281_s20_q;
  logic or_3285_s20_q;
  logic or_3292_s20_q;
  logic or_3296_s20_q;
  logic or_3300_s20_q;
  logic or_3310_s20_q;
  logic or_3314_s20_q;
  logic or_3318_s20_q;
  logic or_3326_s20_q;
  logic or_3330_s20_q;
  logic or_3334_s20_q;
  logic or_3341_s20_q;
  logic or_3345_s20_q;
  logic or_3349_s20_q;
  logic or_3359_s20_q;
  logic or_3363_s20_q;
  logic or_3367_s20_q;
  logic and_3371_s20_q;
  logic or_3375_s20_q;
  logic or_3379_s20_q;
  logic equal_3494_s20_q;
  logic [9:0] select_3580_s20_q;
  logic and_3594_s20_q;
  logic not_3596_s20_q;
  logic select_3597_s20_q;
  logic not_3599_s20_q;
  logic [9:0] difference_3600_s20_q;
  logic [14:0] difference_3647_s20_q;
  logic equal_3687_s20_q;
  logic less_3807_s20_q;
  logic or_3900_s20_q;
  logic select_3908_s20_q;
  logic equal_3919_s20_q;
  logic equal_3926_s20_q;
  logic equal_3928_s20_q;
  logic equal_3929_s20_q;
  logic equal_3930_s20_q;
  logic equal_3931_s20_q;
  logic and_4091_s20_q;
  logic and_4106_s20_q;
  logic and_4108_s20_q;
  logic not_4120_s20_q;
  logic and_4158_s20_q;
  logic [31:0] select_4182_s20_q;
  logic [9:0] select_4189_s20_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s20_q <= pixel_0_s19_q;
      pixel_1_s20_q <= pixel_1_s19_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= mask_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      sample_pair_pixel_0_s20_q <= sample_pair_pixel_0_s19_q;
      sample_pair_pixel_1_s20_q <= sample_pair_pixel_1_s19_q;
      census_columns_values_1_cell_2_of_skin_s20_q <= census_columns_values_1_cell_2_of_skin_s19_q;
      census_changes_values_1_left_s20_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s20_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s20_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s20_q <= sharpness_sums_contrast_1_q;
      x_s20_q <= x_s19_q;
      counts_nearer_s20_q <= counts_nearer_s19_q;
      registration_moved_s20_q <= registration_moved_q;
      patches_lower_s20_q <= patches_lower_s19_q;
      patches_second_s20_q <= patches_second_s19_q;
      patches_summed_row_column_s20_q <= patches_summed_row_column_s19_q;
      patches_summed_first_s20_q <= patches_summed_first_s19_q;
      patches_summed_last_s20_q <= patches_summed_last_s19_q;
      patches_summed_down_by_s20_q <= patches_summed_down_by_s19_q;
      product_s20_q <= product_s19_q;
      last_s20_q <= last_s19_q;
      and_555_s20_q <= and_555_s19_q;
      equal_580_s20_q <= equal_580_s19_q;
      not_581_s20_q <= not_581_s19_q;
      so_s20_q <= so_s19_q;
      less_662_s20_q <= less_662_s19_q;
      less_663_s20_q <= less_663_s19_q;
      less_664_s20_q <= less_664_s19_q;
      less_665_s20_q <= less_665_s19_q;
      less_666_s20_q <= less_666_s19_q;
      less_667_s20_q <= less_667_s19_q;
      less_668_s20_q <= less_668_s19_q;
      less_669_s20_q <= less_669_s19_q;
      less_670_s20_q <= less_670_s19_q;
      less_671_s20_q <= less_671_s19_q;
      less_672_s20_q <= less_672_s19_q;
      less_673_s20_q <= less_673_s19_q;
      less_674_s20_q <= less_674_s19_q;
      less_675_s20_q <= less_675_s19_q;
      less_676_s20_q <= less_676_s19_q;
      less_677_s20_q <= less_677_s19_q;
      less_678_s20_q <= less_678_s19_q;
      less_679_s20_q <= less_679_s19_q;
      less_680_s20_q <= less_680_s19_q;
      less_681_s20_q <= less_681_s19_q;
      less_682_s20_q <= less_682_s19_q;
      less_683_s20_q <= less_683_s19_q;
      less_684_s20_q <= less_684_s19_q;
      less_685_s20_q <= less_685_s19_q;
      and_693_s20_q <= and_693_s19_q;
      and_718_s20_q <= whole_22 & and_693_s19_q;
      and_719_s20_q <= and_719_s19_q;
      sum_739_s20_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_745_s20_q <= and_745_s19_q;
      and_749_s20_q <= and_749_s19_q;
      less_750_s20_q <= less_750_s19_q;
      less_754_s20_q <= less_754_s19_q;
      less_756_s20_q <= less_756_s19_q;
      equal_1618_s20_q <= equal_1618_s19_q;
      equal_1626_s20_q <= equal_1626_s19_q;
      equal_1628_s20_q <= equal_1628_s19_q;
      equal_1630_s20_q <= equal_1630_s19_q;
      equal_1632_s20_q <= equal_1632_s19_q;
      equal_1634_s20_q <= equal_1634_s19_q;
      equal_1636_s20_q <= equal_1636_s19_q;
      equal_1791_s20_q <= equal_1791_s19_q;
      equal_1793_s20_q <= equal_1793_s19_q;
      not_1798_s20_q <= not_1798_s19_q;
      equal_1808_s20_q <= equal_1808_s19_q;
      select_1823_s20_q <= or_1822_s19_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1826_s20_q <= select_1826_s19_q;
      and_1836_s20_q <= sample_pair_whole_s19_q & and_1835;
      select_1851_s20_q <= or_1850_s19_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1855_s20_q <= sample_pair_whole_s19_q & and_1854;
      column_4_s20_q <= column_4;
      select_1870_s20_q <= select_1870_s19_q;
      select_1871_s20_q <= or_1863_s19_q ? row_starts_s19_q : patches_left_next_0_q[4];
      and_1878_s20_q <= and_1878;
      not_1999_s20_q <= not_1999_s19_q;
      and_2072_s20_q <= and_2072_s19_q;
      less_2073_s20_q <= less_2073_s19_q;
      index_2_s20_q <= index_2_s19_q;
      sum_2079_s20_q <= sum_2079_s19_q;
      is_seen_s20_q <= is_seen;
      and_2143_s20_q <= is_seen & less_2142_s19_q;
      and_2155_s20_q <= and_2155_s19_q;
      equal_2298_s20_q <= equal_2298_s19_q;
      sum_2299_s20_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2291};
      not_2343_s20_q <= ~moments_ends_q;
      and_2364_s20_q <= cfg_prove_i & and_2363;
      select_2391_s20_q <= and_2389_s19_q ? detail_3[14:2] : 13'h0;
      select_2403_s20_q <= and_2401_s19_q ? detail_4[14:2] : 13'h0;
      equal_2415_s20_q <= equal_2415_s19_q;
      less_2416_s20_q <= less_2416_s19_q;
      and_2426_s20_q <= and_2426;
      and_2436_s20_q <= and_2436;
      equal_2459_s20_q <= equal_2459_s19_q;
      and_2621_s20_q <= and_2621_s19_q;
      and_2671_s20_q <= not_581_s19_q & (so_s19_q & and_2669);
      select_2675_s20_q <= select_2675_s19_q;
      select_2678_s20_q <= select_2678_s19_q;
      select_2685_s20_q <= select_2685;
      and_2707_s20_q <= so_s19_q & (ends_cell_s19_q & (not_2649_s19_q & and_2704));
      and_2728_s20_q <= and_2728_s19_q;
      equal_2928_s20_q <= equal_2928_s19_q;
      parity_3258_s20_q <= ^{xor_3254, xor_3217_s19_q, select_3184_s19_q, other_s19_q};
      or_3262_s20_q <= or_3262_s19_q;
      or_3266_s20_q <= or_3266_s19_q;
      or_3270_s20_q <= or_3270_s19_q;
      or_3277_s20_q <= or_3277_s19_q;
      or_3281_s20_q <= or_3281_s19_q;
      or_3285_s20_q <= or_3285_s19_q;
      or_3292_s20_q <= or_3292_s19_q;
      or_3296_s20_q <= or_3296_s19_q;
      or_3300_s20_q <= or_3300_s19_q;
      or_3310_s20_q <= or_3310_s19_q;
      or_3314_s20_q <= or_3314_s19_q;
      or_3318_s20_q <= or_3318_s19_q;
      or_3326_s20_q <= or_3326_s19_q;
      or_3330_s20_q <= or_3330_s19_q;
      or_3334_s20_q <= or_3334_s19_q;
      or_3341_s20_q <= or_3341_s19_q;
      or_3345_s20_q <= or_3345_s19_q;
      or_3349_s20_q <= or_3349_s19_q;
      or_3359_s20_q <= or_3359_s19_q;
      or_3363_s20_q <= or_3363_s19_q;
      or_3367_s20_q <= or_3367_s19_q;
      and_3371_s20_q <= xor_3217_s19_q & (^{xor_3254, select_3184_s19_q, other_s19_q});
      or_3375_s20_q <= and_3372_s19_q | (xor_3199_s19_q & or_3373_s19_q);
      or_3379_s20_q <= or_3379;
      equal_3494_s20_q <= equal_3494_s19_q;
      select_3580_s20_q <= select_3580_s19_q;
      and_3594_s20_q <= equal_1791_s19_q & equal_3591_s19_q;
      not_3596_s20_q <= not_3596_s19_q;
      select_3597_s20_q <= patches_second_s19_q ? patches_valid_1_q : patches_valid_0_q;
      not_3599_s20_q <= ~(select_3590_s19_q < select_3580_s19_q);
      difference_3600_s20_q <= select_3590_s19_q - select_3580_s19_q;
      difference_3647_s20_q <= difference_3647;
      equal_3687_s20_q <= equal_3687_s19_q;
      less_3807_s20_q <= less_3807_s19_q;
      or_3900_s20_q <= or_3900_s19_q;
      select_3908_s20_q <= select_3908_s19_q;
      equal_3919_s20_q <= equal_3919_s19_q;
      equal_3926_s20_q <= equal_3926_s19_q;
      equal_3928_s20_q <= equal_3928_s19_q;
      equal_3929_s20_q <= equal_3929_s19_q;
      equal_3930_s20_q <= equal_3930_s19_q;
      equal_3931_s20_q <= equal_3931_s19_q;
      and_4091_s20_q <= and_4091_s19_q;
      and_4106_s20_q <= and_4106;
      and_4108_s20_q <= and_4108_s19_q;
      not_4120_s20_q <= not_4120_s19_q;
      and_4158_s20_q <= and_4158_s19_q;
      select_4182_s20_q <= select_4182_s19_q;
      select_4189_s20_q <= select_4189_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic moments_out_of_step_q;
  logic moments_begins_alone_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_unproven_q;
  logic [13:0] counts_on_skin_q;
  logic patches_frame_ended_q;
  // hls/stages/census.hpp:295
  logic [13:0] sum_740;
  assign sum_740 = {2'h0, census_changes_values_1_left_s20_q} + {1'b0, sum_739_s20_q};
  logic [13:0] sum_741;
  assign sum_741 = {2'h0, census_changes_values_2_left_q} + sum_740;
  // hls/stages/agreement.hpp:531
  logic [11:0] select_2295;
  assign select_2295 = and_555_s20_q ? census_changes_values_1_left_s20_q : census_changes_values_2_left_q;
  logic [11:0] select_2296;
  assign select_2296 = and_555_s20_q ? census_changes_values_1_right_s20_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [13:0] sum_2300;
  assign sum_2300 = {2'h0, census_changes_values_1_right_s20_q} + {1'b0, sum_2299_s20_q};
  logic [13:0] sum_2301;
  assign sum_2301 = {2'h0, census_changes_values_2_right_q} + sum_2300;
  // hls/stages/moments.hpp:55
  logic out_of_step;
  assign out_of_step = moments_begins_alone_q | (moments_out_of_step_q & not_2343_s20_q);
  // hls/stages/census.hpp:375
  logic [23:0] select_2393;
  assign select_2393 = equal_2298_s20_q ? {11'h0, select_2391_s20_q} : (sharpness_sums_detail_0_q + {11'h0, select_2391_s20_q});
  logic [23:0] select_2405;
  assign select_2405 = equal_2298_s20_q ? {11'h0, select_2403_s20_q} : (sharpness_sums_detail_1_q + {11'h0, select_2403_s20_q});
  // hls/stages/census.hpp:395
  logic [17:0] select_2428;
  assign select_2428 = (less_2416_s20_q & and_2426_s20_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2438;
  assign select_2438 = (less_2416_s20_q & and_2436_s20_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:217
  logic [1:0] select_2447;
  assign select_2447 = equal_2415_s20_q ? {sharpness_comparing_contrast_0_q[0], and_2436_s20_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2449;
  assign select_2449 = equal_2415_s20_q ? {sharpness_comparing_contrast_1_q[0], and_2426_s20_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:404
  logic xor_2472;
  assign xor_2472 = sharpness_comparing_contrast_0_q[1] ^ and_2426_s20_q;
  logic select_2475;
  assign select_2475 = (equal_2459_s20_q | xor_2472) ? (and_2426_s20_q & xor_2472) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2476;
  assign select_2476 = equal_2415_s20_q ? select_2475 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2478;
  assign xor_2478 = sharpness_comparing_contrast_1_q[1] ^ and_2436_s20_q;
  logic select_2481;
  assign select_2481 = (equal_2459_s20_q | xor_2478) ? (and_2436_s20_q & xor_2478) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2482;
  assign select_2482 = equal_2415_s20_q ? select_2481 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2673;
  assign select_2673 = and_2621_s20_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2671_s20_q});
  logic [13:0] select_2687;
  assign select_2687 = and_2621_s20_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2685_s20_q});
  // hls/stages/agreement.hpp:799
  logic and_2708;
  assign and_2708 = not_581_s20_q & and_2707_s20_q;
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2710;
  assign select_2710 = and_2621_s20_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2708});
  logic [13:0] select_2730;
  assign select_2730 = and_2621_s20_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2728_s20_q});
  // hls/stages/count_bits.hpp:24
  logic parity_3288;
  assign parity_3288 = ^{or_3285_s20_q, or_3281_s20_q, or_3277_s20_q};
  logic parity_3303;
  assign parity_3303 = ^{or_3300_s20_q, or_3296_s20_q, or_3292_s20_q};
  logic parity_3306;
  assign parity_3306 = ^{or_3300_s20_q, or_3296_s20_q, or_3292_s20_q, or_3285_s20_q, or_3281_s20_q, or_3277_s20_q, or_3270_s20_q, or_3266_s20_q, or_3262_s20_q};
  logic parity_3337;
  assign parity_3337 = ^{or_3334_s20_q, or_3330_s20_q, or_3326_s20_q};
  logic parity_3352;
  assign parity_3352 = ^{or_3349_s20_q, or_3345_s20_q, or_3341_s20_q};
  logic parity_3355;
  assign parity_3355 = ^{or_3349_s20_q, or_3345_s20_q, or_3341_s20_q, or_3334_s20_q, or_3330_s20_q, or_3326_s20_q, or_3318_s20_q, or_3314_s20_q, or_3310_s20_q};
  logic parity_3370;
  assign parity_3370 = ^{or_3367_s20_q, or_3363_s20_q, or_3359_s20_q};
  logic parity_3382;
  assign parity_3382 = ^{or_3379_s20_q, or_3375_s20_q, and_3371_s20_q};
  logic parity_3385;
  assign parity_3385 = ^{or_3379_s20_q, or_3375_s20_q, and_3371_s20_q, or_3367_s20_q, or_3363_s20_q, or_3359_s20_q, or_3349_s20_q, or_3345_s20_q, or_3341_s20_q, or_3334_s20_q, or_3330_s20_q, or_3326_s20_q, or_3318_s20_q, or_3314_s20_q, or_3310_s20_q};
  logic parity_3387;
  assign parity_3387 = ^{or_3379_s20_q, or_3375_s20_q, and_3371_s20_q, or_3367_s20_q, or_3363_s20_q, or_3359_s20_q, or_3349_s20_q, or_3345_s20_q, or_3341_s20_q, or_3334_s20_q, or_3330_s20_q, or_3326_s20_q, or_3318_s20_q, or_3314_s20_q, or_3310_s20_q, or_3300_s20_q, or_3296_s20_q, or_3292_s20_q, or_3285_s20_q, or_3281_s20_q, or_3277_s20_q, or_3270_s20_q, or_3266_s20_q, or_3262_s20_q};
  // hls/stages/count_bits.hpp:25
  logic and_3388;
  assign and_3388 = parity_3306 & parity_3385;
  logic and_3391;
  assign and_3391 = (^{or_3270_s20_q, or_3266_s20_q, or_3262_s20_q}) & (parity_3288 | parity_3303);
  logic or_3392;
  assign or_3392 = (parity_3288 & parity_3303) | and_3391;
  logic or_3396;
  assign or_3396 = (parity_3370 & parity_3382) | (parity_3355 & (parity_3370 | parity_3382));
  logic and_3402;
  assign and_3402 = (^{or_3318_s20_q, or_3314_s20_q, or_3310_s20_q}) & (parity_3337 | parity_3352);
  logic or_3403;
  assign or_3403 = (parity_3337 & parity_3352) | and_3402;
  logic or_3407;
  assign or_3407 = (or_3363_s20_q & or_3367_s20_q) | (or_3359_s20_q & (or_3363_s20_q | or_3367_s20_q));
  logic or_3411;
  assign or_3411 = (or_3375_s20_q & or_3379_s20_q) | (and_3371_s20_q & (or_3375_s20_q | or_3379_s20_q));
  // hls/stages/count_bits.hpp:23
  logic or_3418;
  assign or_3418 = (or_3314_s20_q & or_3318_s20_q) | (or_3310_s20_q & (or_3314_s20_q | or_3318_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3422;
  assign or_3422 = (or_3330_s20_q & or_3334_s20_q) | (or_3326_s20_q & (or_3330_s20_q | or_3334_s20_q));
  logic or_3426;
  assign or_3426 = (or_3345_s20_q & or_3349_s20_q) | (or_3341_s20_q & (or_3345_s20_q | or_3349_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3429;
  assign parity_3429 = ^{or_3426, or_3422, or_3418};
  // hls/stages/count_bits.hpp:23
  logic or_3433;
  assign or_3433 = (or_3266_s20_q & or_3270_s20_q) | (or_3262_s20_q & (or_3266_s20_q | or_3270_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3437;
  assign or_3437 = (or_3281_s20_q & or_3285_s20_q) | (or_3277_s20_q & (or_3281_s20_q | or_3285_s20_q));
  logic or_3441;
  assign or_3441 = (or_3296_s20_q & or_3300_s20_q) | (or_3292_s20_q & (or_3296_s20_q | or_3300_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3444;
  assign parity_3444 = ^{or_3441, or_3437, or_3433};
  logic parity_3447;
  assign parity_3447 = ^{or_3441, or_3437, or_3433, or_3426, or_3422, or_3418, or_3411, or_3407, or_3403};
  // hls/stages/patches.hpp:606
  logic and_3603;
  assign and_3603 = not_3599_s20_q & (~({difference_3600_s20_q, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:613
  logic and_3607;
  assign and_3607 = (10'h38 < patches_peak_size_q) & (~({1'b0, patches_peak_size_q[9:1]} < select_3580_s20_q));
  // hls/stages/patches.hpp:616
  logic less_3648;
  assign less_3648 = $signed({{8{difference_3618[6]}}, difference_3618}) < $signed(difference_3647_s20_q);
  // hls/stages/patches.hpp:615
  logic less_3653;
  assign less_3653 = $signed(difference_3647_s20_q) < $signed({9'h0, cfg_patch_limit_i});
  // hls/stages/agreement.hpp:1147
  logic less_3688;
  assign less_3688 = x_s20_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:799
  logic and_3692;
  assign and_3692 = equal_580_s20_q & (x_s20_q[6] & (not_1999_s20_q & (equal_3687_s20_q & less_3688)));
  // hls/stages/agreement.hpp:1159
  logic and_3697;
  assign and_3697 = x_s20_q[6] & (not_1999_s20_q & (less_3688 & (x_s20_q[2:0] == 3'h1)));
  logic and_3704;
  assign and_3704 = x_s20_q[6] & (not_1999_s20_q & (less_3688 & (x_s20_q[2:0] == 3'h2)));
  logic and_3711;
  assign and_3711 = x_s20_q[6] & (not_1999_s20_q & (less_3688 & (x_s20_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:203
  logic select_3718;
  assign select_3718 = (x_s20_q[5:3] == 3'h2) ? x_s20_q[1] : (x_s20_q[0] & (x_s20_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3745;
  assign sum_3745 = {2'h0, x_s20_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3762;
  assign select_3762 = ($signed(difference_3647_s20_q[14:4]) < $signed(11'h7ff)) ? 6'h30 : difference_3647_s20_q[5:0];
  logic [5:0] select_3763;
  assign select_3763 = ($signed(15'h10) < $signed(difference_3647_s20_q)) ? 6'h10 : select_3762;
  // hls/stages/agreement.hpp:799
  logic and_3770;
  assign and_3770 = equal_580_s20_q & (x_s20_q[6] & (not_1999_s20_q & (equal_2928_s20_q & less_3688)));
  // hls/stages/agreement.hpp:1159
  logic and_3774;
  assign and_3774 = x_s20_q[6] & (not_1999_s20_q & (less_3688 & (x_s20_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:1142
  logic [13:0] select_3933;
  assign select_3933 = equal_3930_s20_q ? counts_skin_unproven_q : (equal_3931_s20_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3935;
  assign select_3935 = equal_3929_s20_q ? counts_regions_bad_q : (equal_3926_s20_q ? counts_nearer_s20_q : select_3933);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3928_s20_q ? counts_on_skin_q : select_3935;
  // hls/stages/agreement.hpp:799
  logic and_4173;
  assign and_4173 = equal_580_s20_q & (x_s20_q[6] & (not_1999_s20_q | (4'hc < x_s20_q[5:2])));
  // hls/stages/agreement.hpp:1157
  logic [31:0] select_4183;
  assign select_4183 = equal_1636_s20_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4182_s20_q;
  logic [31:0] select_4184;
  assign select_4184 = equal_1634_s20_q ? {8'h0, sharpness_sums_detail_0_q} : select_4183;
  logic [31:0] select_4185;
  assign select_4185 = equal_1632_s20_q ? {8'h0, sharpness_sums_detail_1_q} : select_4184;
  logic [31:0] select_4186;
  assign select_4186 = equal_1630_s20_q ? {8'h0, sharpness_sums_contrast_0_s20_q} : select_4185;
  logic [31:0] select_4187;
  assign select_4187 = equal_1628_s20_q ? {8'h0, sharpness_sums_contrast_1_s20_q} : select_4186;

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1826_s20_q, select_1823_s20_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s20_en & and_1836_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s20_q;
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
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_1826_s20_q, select_1851_s20_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s20_en & and_1855_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s20_q;
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
    end
  end
`endif

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1871_s20_q, select_1870_s20_q, column_4_s20_q};
  logic patches_left_we;
  assign patches_left_we = s20_en & and_1878_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s20_q;
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
    end
  end
`endif

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_2079_s20_q, index_2_s20_q};
  logic map_we;
  assign map_we = s20_en & and_2155_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2143_s20_q, is_seen_s20_q};
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
      moments_out_of_step_q <= 1'b0;
      moments_begins_alone_q <= 1'b0;
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_comparing_contrast_0_q <= 2'h0;
      sharpness_comparing_contrast_1_q <= 2'h0;
      sharpness_comparing_less_contrast_0_q <= 1'b0;
      sharpness_comparing_less_contrast_1_q <= 1'b0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_unproven_q <= 14'h0;
      counts_on_skin_q <= 14'h0;
      patches_frame_ended_q <= 1'b0;
    end else if (s20_en) begin
      moments_out_of_step_q <= out_of_step;
      moments_begins_alone_q <= equal_580_s20_q & (equal_1808_s20_q & and_2364_s20_q);
      sharpness_sums_detail_0_q <= and_555_s20_q ? select_2393 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_555_s20_q ? select_2405 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s20_q ? select_2447 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s20_q ? select_2449 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s20_q ? select_2476 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s20_q ? select_2482 : sharpness_comparing_less_contrast_1_q;
      counts_unproven_q <= select_2673;
      counts_regions_bad_q <= select_2687;
      counts_skin_unproven_q <= select_2710;
      counts_on_skin_q <= select_2730;
      patches_frame_ended_q <= equal_580_s20_q & equal_1808_s20_q;
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
      census_changes_values_2_left_q <= select_2295;
      census_changes_values_2_right_q <= select_2296;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
  logic mask_s21_q;
  logic marks_first_s21_q;
  logic marks_last_s21_q;
  logic census_columns_values_1_cell_2_of_skin_s21_q;
  logic x_s21_q;
  logic registration_moved_s21_q;
  logic patches_lower_s21_q;
  logic patches_second_s21_q;
  logic [4:0] patches_summed_row_column_s21_q;
  logic patches_summed_first_s21_q;
  logic patches_summed_last_s21_q;
  logic [4:0] patches_summed_down_by_s21_q;
  logic patches_frame_ended_s21_q;
  logic [13:0] product_s21_q;
  logic [6:0] last_s21_q;
  logic and_555_s21_q;
  logic equal_580_s21_q;
  logic so_s21_q;
  logic less_662_s21_q;
  logic less_663_s21_q;
  logic less_664_s21_q;
  logic less_665_s21_q;
  logic less_666_s21_q;
  logic less_667_s21_q;
  logic less_668_s21_q;
  logic less_669_s21_q;
  logic less_670_s21_q;
  logic less_671_s21_q;
  logic less_672_s21_q;
  logic less_673_s21_q;
  logic less_674_s21_q;
  logic less_675_s21_q;
  logic less_676_s21_q;
  logic less_677_s21_q;
  logic less_678_s21_q;
  logic less_679_s21_q;
  logic less_680_s21_q;
  logic less_681_s21_q;
  logic less_682_s21_q;
  logic less_683_s21_q;
  logic less_684_s21_q;
  logic less_685_s21_q;
  logic and_693_s21_q;
  logic and_718_s21_q;
  logic and_719_s21_q;
  logic [8:0] sum_741_s21_q;
  logic and_749_s21_q;
  logic less_750_s21_q;
  logic and_755_s21_q;
  logic less_756_s21_q;
  logic equal_1618_s21_q;
  logic equal_1626_s21_q;
  logic equal_1791_s21_q;
  logic equal_1793_s21_q;
  logic not_1798_s21_q;
  logic and_2072_s21_q;
  logic less_2073_s21_q;
  logic [1:0] map_rdata_s21_q;
  logic is_seen_s21_q;
  logic and_2143_s21_q;
  logic equal_2298_s21_q;
  logic [8:0] sum_2301_s21_q;
  logic equal_2415_s21_q;
  logic less_2416_s21_q;
  logic [17:0] select_2428_s21_q;
  logic [17:0] select_2438_s21_q;
  logic equal_2459_s21_q;
  logic [9:0] select_2675_s21_q;
  logic [9:0] select_2678_s21_q;
  logic parity_3258_s21_q;
  logic parity_3387_s21_q;
  logic and_3388_s21_q;
  logic or_3392_s21_q;
  logic or_3396_s21_q;
  logic or_3403_s21_q;
  logic or_3407_s21_q;
  logic or_3411_s21_q;
  logic or_3418_s21_q;
  logic or_3422_s21_q;
  logic or_3426_s21_q;
  logic or_3433_s21_q;
  logic or_3437_s21_q;
  logic or_3441_s21_q;
  logic parity_3447_s21_q;
  logic or_3457_s21_q;
  logic or_3461_s21_q;
  logic and_3468_s21_q;
  logic and_3470_s21_q;
  logic and_3472_s21_q;
  logic equal_3494_s21_q;
  logic and_3594_s21_q;
  logic and_3610_s21_q;
  logic not_3649_s21_q;
  logic not_3654_s21_q;
  logic equal_3687_s21_q;
  logic and_3692_s21_q;
  logic and_3698_s21_q;
  logic and_3705_s21_q;
  logic and_3712_s21_q;
  logic and_3721_s21_q;
  logic and_3748_s21_q;
  logic [5:0] select_3763_s21_q;
  logic and_3770_s21_q;
  logic and_3775_s21_q;
  logic less_3807_s21_q;
  logic or_3900_s21_q;
  logic select_3908_s21_q;
  logic equal_3919_s21_q;
  logic and_3927_s21_q;
  logic [13:0] before_v_4_s21_q;
  logic not_3976_s21_q;
  logic or_3980_s21_q;
  logic and_3985_s21_q;
  logic less_3986_s21_q;
  logic and_4091_s21_q;
  logic and_4106_s21_q;
  logic and_4108_s21_q;
  logic not_4120_s21_q;
  logic and_4158_s21_q;
  logic and_4173_s21_q;
  logic [5:0] select_4175_s21_q;
  logic [31:0] select_4187_s21_q;
  logic [9:0] select_4189_s21_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s21_q <= pixel_0_s20_q;
      pixel_1_s21_q <= pixel_1_s20_q;
      saturated_s21_q <= saturated_s20_q;
      mask_s21_q <= mask_s20_q;
      marks_first_s21_q <= marks_first_s20_q;
      marks_last_s21_q <= marks_last_s20_q;
      census_columns_values_1_cell_2_of_skin_s21_q <= census_columns_values_1_cell_2_of_skin_s20_q;
      x_s21_q <= x_s20_q[6];
      registration_moved_s21_q <= registration_moved_s20_q;
      patches_lower_s21_q <= patches_lower_s20_q;
      patches_second_s21_q <= patches_second_s20_q;
      patches_summed_row_column_s21_q <= patches_summed_row_column_s20_q;
      patches_summed_first_s21_q <= patches_summed_first_s20_q;
      patches_summed_last_s21_q <= patches_summed_last_s20_q;
      patches_summed_down_by_s21_q <= patches_summed_down_by_s20_q;
      patches_frame_ended_s21_q <= patches_frame_ended_q;
      product_s21_q <= product_s20_q;
      last_s21_q <= last_s20_q;
      and_555_s21_q <= and_555_s20_q;
      equal_580_s21_q <= equal_580_s20_q;
      so_s21_q <= so_s20_q;
      less_662_s21_q <= less_662_s20_q;
      less_663_s21_q <= less_663_s20_q;
      less_664_s21_q <= less_664_s20_q;
      less_665_s21_q <= less_665_s20_q;
      less_666_s21_q <= less_666_s20_q;
      less_667_s21_q <= less_667_s20_q;
      less_668_s21_q <= less_668_s20_q;
      less_669_s21_q <= less_669_s20_q;
      less_670_s21_q <= less_670_s20_q;
      less_671_s21_q <= less_671_s20_q;
      less_672_s21_q <= less_672_s20_q;
      less_673_s21_q <= less_673_s20_q;
      less_674_s21_q <= less_674_s20_q;
      less_675_s21_q <= less_675_s20_q;
      less_676_s21_q <= less_676_s20_q;
      less_677_s21_q <= less_677_s20_q;
      less_678_s21_q <= less_678_s20_q;
      less_679_s21_q <= less_679_s20_q;
      less_680_s21_q <= less_680_s20_q;
      less_681_s21_q <= less_681_s20_q;
      less_682_s21_q <= less_682_s20_q;
      less_683_s21_q <= less_683_s20_q;
      less_684_s21_q <= less_684_s20_q;
      less_685_s21_q <= less_685_s20_q;
      and_693_s21_q <= and_693_s20_q;
      and_718_s21_q <= and_718_s20_q;
      and_719_s21_q <= and_719_s20_q;
      sum_741_s21_q <= sum_741[13:5];
      and_749_s21_q <= and_749_s20_q;
      less_750_s21_q <= less_750_s20_q;
      and_755_s21_q <= (and_718_s20_q & and_745_s20_q) & less_754_s20_q;
      less_756_s21_q <= less_756_s20_q;
      equal_1618_s21_q <= equal_1618_s20_q;
      equal_1626_s21_q <= equal_1626_s20_q;
      equal_1791_s21_q <= equal_1791_s20_q;
      equal_1793_s21_q <= equal_1793_s20_q;
      not_1798_s21_q <= not_1798_s20_q;
      and_2072_s21_q <= and_2072_s20_q;
      less_2073_s21_q <= less_2073_s20_q;
      map_rdata_s21_q <= map_rdata_q;
      is_seen_s21_q <= is_seen_s20_q;
      and_2143_s21_q <= and_2143_s20_q;
      equal_2298_s21_q <= equal_2298_s20_q;
      sum_2301_s21_q <= sum_2301[13:5];
      equal_2415_s21_q <= equal_2415_s20_q;
      less_2416_s21_q <= less_2416_s20_q;
      select_2428_s21_q <= select_2428;
      select_2438_s21_q <= select_2438;
      equal_2459_s21_q <= equal_2459_s20_q;
      select_2675_s21_q <= select_2675_s20_q;
      select_2678_s21_q <= select_2678_s20_q;
      parity_3258_s21_q <= parity_3258_s20_q;
      parity_3387_s21_q <= parity_3387;
      and_3388_s21_q <= and_3388;
      or_3392_s21_q <= or_3392;
      or_3396_s21_q <= or_3396;
      or_3403_s21_q <= or_3403;
      or_3407_s21_q <= or_3407;
      or_3411_s21_q <= or_3411;
      or_3418_s21_q <= or_3418;
      or_3422_s21_q <= or_3422;
      or_3426_s21_q <= or_3426;
      or_3433_s21_q <= or_3433;
      or_3437_s21_q <= or_3437;
      or_3441_s21_q <= or_3441;
      parity_3447_s21_q <= parity_3447;
      or_3457_s21_q <= (or_3422 & or_3426) | (or_3418 & (or_3422 | or_3426));
      or_3461_s21_q <= (or_3437 & or_3441) | (or_3433 & (or_3437 | or_3441));
      and_3468_s21_q <= and_3388 & (or_3392 | or_3396);
      and_3470_s21_q <= parity_3429 & parity_3444;
      and_3472_s21_q <= (^{or_3411, or_3407, or_3403}) & (parity_3429 | parity_3444);
      equal_3494_s21_q <= equal_3494_s20_q;
      and_3594_s21_q <= and_3594_s20_q;
      and_3610_s21_q <= not_3596_s20_q & (select_3597_s20_q & (and_3603 & and_3607));
      not_3649_s21_q <= ~less_3648;
      not_3654_s21_q <= ~less_3653;
      equal_3687_s21_q <= equal_3687_s20_q;
      and_3692_s21_q <= and_3692;
      and_3698_s21_q <= equal_580_s20_q & and_3697;
      and_3705_s21_q <= equal_580_s20_q & and_3704;
      and_3712_s21_q <= equal_580_s20_q & and_3711;
      and_3721_s21_q <= x_s20_q[6] & (not_1999_s20_q & (less_3688 & select_3718));
      and_3748_s21_q <= not_1999_s20_q & (less_3688 & (sum_3745[4:2] == 3'h0));
      select_3763_s21_q <= select_3763;
      and_3770_s21_q <= and_3770;
      and_3775_s21_q <= equal_580_s20_q & and_3774;
      less_3807_s21_q <= less_3807_s20_q;
      or_3900_s21_q <= or_3900_s20_q;
      select_3908_s21_q <= select_3908_s20_q;
      equal_3919_s21_q <= equal_3919_s20_q;
      and_3927_s21_q <= equal_3926_s20_q & equal_3687_s20_q;
      before_v_4_s21_q <= before_v_4;
      not_3976_s21_q <= ~(equal_3931_s20_q & equal_3687_s20_q);
      or_3980_s21_q <= (equal_3931_s20_q | equal_3930_s20_q) | (x_s20_q[6:3] == 4'hf);
      and_3985_s21_q <= equal_3928_s20_q & equal_3687_s20_q;
      less_3986_s21_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4091_s21_q <= and_4091_s20_q;
      and_4106_s21_q <= and_4106_s20_q;
      and_4108_s21_q <= and_4108_s20_q;
      not_4120_s21_q <= not_4120_s20_q;
      and_4158_s21_q <= and_4158_s20_q;
      and_4173_s21_q <= and_4173;
      select_4175_s21_q <= equal_580_s20_q ? (x_s20_q[6] ? x_s20_q[5:0] : 6'h0) : 6'h0;
      select_4187_s21_q <= select_4187;
      select_4189_s21_q <= select_4189_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
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
  logic hides_q;
  // hls/stages/census.hpp:395
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2428_s21_q};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2431;
  assign select_2431 = equal_2415_s21_q ? (less_2416_s21_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:395
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2438_s21_q};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2441;
  assign select_2441 = equal_2415_s21_q ? (less_2416_s21_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3449;
  assign parity_3449 = ^{or_3441_s21_q, or_3437_s21_q, or_3433_s21_q, or_3426_s21_q, or_3422_s21_q, or_3418_s21_q, or_3411_s21_q, or_3407_s21_q, or_3403_s21_q, or_3396_s21_q, or_3392_s21_q, and_3388_s21_q};
  // hls/stages/count_bits.hpp:25
  logic or_3453;
  assign or_3453 = (or_3407_s21_q & or_3411_s21_q) | (or_3403_s21_q & (or_3407_s21_q | or_3411_s21_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3464;
  assign parity_3464 = ^{or_3461_s21_q, or_3457_s21_q, or_3453};
  // hls/stages/count_bits.hpp:25
  logic and_3465;
  assign and_3465 = (^{or_3396_s21_q, or_3392_s21_q, and_3388_s21_q}) & parity_3447_s21_q;
  logic or_3469;
  assign or_3469 = (or_3392_s21_q & or_3396_s21_q) | and_3468_s21_q;
  logic or_3473;
  assign or_3473 = and_3470_s21_q | and_3472_s21_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3476;
  assign parity_3476 = ^{or_3473, or_3469, and_3465};
  // hls/stages/count_bits.hpp:25
  logic and_3478;
  assign and_3478 = parity_3464 & parity_3476;
  logic or_3482;
  assign or_3482 = (or_3457_s21_q & or_3461_s21_q) | (or_3453 & (or_3457_s21_q | or_3461_s21_q));
  logic or_3486;
  assign or_3486 = (or_3469 & or_3473) | (and_3465 & (or_3469 | or_3473));
  // hls/stages/patches.hpp:190
  logic and_3611;
  assign and_3611 = and_3594_s21_q & and_3610_s21_q;
  // hls/stages/patches.hpp:672
  logic not_3612;
  assign not_3612 = ~patches_lower_s21_q;
  // hls/stages/patches.hpp:192
  logic and_3614;
  assign and_3614 = and_3611 & (not_1798_s21_q & not_3612);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3616;
  assign sum_3616 = {7'h0, and_3614} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:675
  logic and_3650;
  assign and_3650 = not_3649_s21_q & and_3614;
  logic [7:0] sum_3651;
  assign sum_3651 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3650};
  // hls/stages/patches.hpp:676
  logic and_3655;
  assign and_3655 = not_3654_s21_q & and_3614;
  logic [7:0] sum_3656;
  assign sum_3656 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3655};
  // hls/stages/patches.hpp:192
  logic and_3658;
  assign and_3658 = and_3611 & (patches_second_s21_q & not_3612);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3660;
  assign sum_3660 = {7'h0, and_3658} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:675
  logic and_3662;
  assign and_3662 = not_3649_s21_q & and_3658;
  logic [7:0] sum_3663;
  assign sum_3663 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3662};
  // hls/stages/patches.hpp:676
  logic and_3665;
  assign and_3665 = not_3654_s21_q & and_3658;
  logic [7:0] sum_3666;
  assign sum_3666 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3665};
  // hls/stages/patches.hpp:192
  logic and_3668;
  assign and_3668 = and_3611 & (patches_lower_s21_q & not_1798_s21_q);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3670;
  assign sum_3670 = {7'h0, and_3668} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:675
  logic and_3672;
  assign and_3672 = not_3649_s21_q & and_3668;
  logic [7:0] sum_3673;
  assign sum_3673 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3672};
  // hls/stages/patches.hpp:676
  logic and_3675;
  assign and_3675 = not_3654_s21_q & and_3668;
  logic [7:0] sum_3676;
  assign sum_3676 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3675};
  // hls/stages/patches.hpp:192
  logic and_3678;
  assign and_3678 = and_3611 & (patches_lower_s21_q & patches_second_s21_q);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3680;
  assign sum_3680 = {7'h0, and_3678} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:675
  logic and_3682;
  assign and_3682 = not_3649_s21_q & and_3678;
  logic [7:0] sum_3683;
  assign sum_3683 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3682};
  // hls/stages/patches.hpp:676
  logic and_3685;
  assign and_3685 = not_3654_s21_q & and_3678;
  logic [7:0] sum_3686;
  assign sum_3686 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3685};
  // hls/stages/patches.hpp:638
  logic [7:0] or_3700;
  assign or_3700 = (and_3692_s21_q ? patches_quarters_0_places_q : 8'h0) | (and_3698_s21_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3714;
  assign or_3714 = (or_3700 | (and_3705_s21_q ? patches_quarters_2_places_q : 8'h0)) | (and_3712_s21_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:799
  logic and_3722;
  assign and_3722 = equal_580_s21_q & and_3721_s21_q;
  // hls/stages/patches.hpp:639
  logic [7:0] select_3724;
  assign select_3724 = and_3692_s21_q ? (and_3722 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3726;
  assign select_3726 = and_3698_s21_q ? (and_3722 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3729;
  assign select_3729 = and_3705_s21_q ? (and_3722 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3732;
  assign select_3732 = and_3712_s21_q ? (and_3722 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:640
  logic [7:0] select_3735;
  assign select_3735 = and_3692_s21_q ? (and_3722 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3737;
  assign select_3737 = and_3698_s21_q ? (and_3722 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3740;
  assign select_3740 = and_3705_s21_q ? (and_3722 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3743;
  assign select_3743 = and_3712_s21_q ? (and_3722 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:799
  logic and_3750;
  assign and_3750 = equal_580_s21_q & (x_s21_q & and_3748_s21_q);
  // hls/stages/patches.hpp:633
  logic [7:0] sum_3752;
  assign sum_3752 = patches_word_places_q + (and_3698_s21_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:635
  logic [7:0] select_3756;
  assign select_3756 = and_3750 ? (patches_word_up_q + (and_3698_s21_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3758;
  assign sum_3758 = patches_word_down_q + (and_3698_s21_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:678
  logic [5:0] select_3764;
  assign select_3764 = and_3611 ? select_3763_s21_q : 6'h0;
  // hls/stages/patches.hpp:679
  logic [11:0] select_3766;
  assign select_3766 = patches_round_ends_q ? {{6{select_3764[5]}}, select_3764} : (patches_across_q + {{6{select_3764[5]}}, select_3764});
  // hls/stages/patches.hpp:662
  logic [7:0] select_3777;
  assign select_3777 = and_3770_s21_q ? (and_3775_s21_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:664
  logic or_3781;
  assign or_3781 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:665
  logic or_3784;
  assign or_3784 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:666
  logic [8:0] sum_3785;
  assign sum_3785 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:661
  logic select_3787;
  assign select_3787 = and_3770_s21_q ? (and_3775_s21_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3790;
  assign and_3790 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:661
  logic [2:0] select_3791;
  assign select_3791 = and_3770_s21_q ? {and_3790, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3793;
  assign select_3793 = and_3770_s21_q ? (and_3775_s21_q ? {and_3790, patches_found_q[2:1]} : select_3791) : patches_found_q;
  // hls/stages/patches.hpp:660
  logic or_3796;
  assign or_3796 = patches_partly_q | (patches_doubted_q & (~and_3775_s21_q));
  // hls/stages/patches.hpp:661
  logic select_3798;
  assign select_3798 = and_3775_s21_q ? or_3796 : (and_3770_s21_q ? or_3796 : patches_doubted_q);
  // hls/stages/patches.hpp:659
  logic select_3800;
  assign select_3800 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:648
  logic [7:0] select_3804;
  assign select_3804 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:679
  logic and_3808;
  assign and_3808 = less_3807_s21_q & and_3611;
  logic [7:0] sum_3809;
  assign sum_3809 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3808};
  // hls/stages/patches.hpp:650
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:651
  logic select_3832;
  assign select_3832 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:652
  logic and_3838;
  assign and_3838 = patches_frame_ended_s21_q & (~patches_age_q[9]);
  logic [9:0] sum_3839;
  assign sum_3839 = patches_age_q + {9'h0, and_3838};
  logic [9:0] select_3842;
  assign select_3842 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3839)) : sum_3839;
  // hls/stages/agreement.hpp:1252
  logic [14:0] over;
  assign over = {1'b0, product_s21_q} - {1'b0, before_v_4_s21_q};
  // hls/stages/agreement.hpp:1260
  logic select_3938;
  assign select_3938 = and_3927_s21_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1340
  logic [1:0] select_4107;
  assign select_4107 = and_4106_s21_q ? {and_2143_s21_q, is_seen_s21_q} : map_rdata_s21_q;
  // hls/stages/agreement.hpp:1269
  logic or_4121;
  assign or_4121 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4120_s21_q;
  // hls/stages/agreement.hpp:799
  logic and_4136;
  assign and_4136 = equal_3919_s21_q & (cfg_prove_i & (registration_moved_s21_q | patches_moved_q));
  logic and_4169;
  assign and_4169 = equal_580_s21_q & (equal_3919_s21_q & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/agreement.hpp:1157
  logic [31:0] select_4188;
  assign select_4188 = equal_1626_s21_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4187_s21_q;
  // hls/stages/agreement.hpp:1159
  logic [31:0] select_4190;
  assign select_4190 = equal_1618_s21_q ? select_4188 : {2'h0, select_4189_s21_q, select_2678_s21_q, select_2675_s21_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
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
      hides_q <= 1'b0;
    end else if (s21_en) begin
      sharpness_comparing_rest_0_q <= so_s21_q ? select_2431 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s21_q ? select_2441 : sharpness_comparing_rest_1_q;
      patches_quarters_0_places_q <= sum_3616;
      patches_quarters_0_up_q <= sum_3651;
      patches_quarters_0_down_q <= sum_3656;
      patches_quarters_1_places_q <= sum_3660;
      patches_quarters_1_up_q <= sum_3663;
      patches_quarters_1_down_q <= sum_3666;
      patches_quarters_2_places_q <= sum_3670;
      patches_quarters_2_up_q <= sum_3673;
      patches_quarters_2_down_q <= sum_3676;
      patches_quarters_3_places_q <= sum_3680;
      patches_quarters_3_up_q <= sum_3683;
      patches_quarters_3_down_q <= sum_3686;
      patches_word_places_q <= or_3714;
      patches_word_up_q <= ((select_3724 | select_3726) | select_3729) | select_3732;
      patches_word_down_q <= ((select_3735 | select_3737) | select_3740) | select_3743;
      patches_sum_places_q <= and_3750 ? sum_3752 : patches_sum_places_q;
      patches_sum_up_q <= select_3756;
      patches_sum_down_q <= and_3750 ? sum_3758 : patches_sum_down_q;
      patches_across_q <= select_3766;
      patches_places_q <= select_3777;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3781;
      patches_partly_q <= or_3784;
      patches_clear_limit_q <= sum_3785[8:2];
      patches_complete_q <= select_3787;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3793;
      patches_doubted_q <= and_3770_s21_q ? select_3798 : patches_doubted_q;
      patches_doubted_before_q <= select_3800;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3804;
      patches_on_skin_q <= sum_3809;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3832;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3842;
      hides_q <= equal_580_s21_q ? select_3938 : hides_q;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic [4:0] patches_summed_row_column_s22_q;
  logic patches_summed_first_s22_q;
  logic patches_summed_last_s22_q;
  logic [4:0] patches_summed_down_by_s22_q;
  logic patches_round_ends_s22_q;
  logic [7:0] patches_on_skin_s22_q;
  logic [6:0] last_s22_q;
  logic and_555_s22_q;
  logic equal_580_s22_q;
  logic so_s22_q;
  logic less_662_s22_q;
  logic less_663_s22_q;
  logic less_664_s22_q;
  logic less_665_s22_q;
  logic less_666_s22_q;
  logic less_667_s22_q;
  logic less_668_s22_q;
  logic less_669_s22_q;
  logic less_670_s22_q;
  logic less_671_s22_q;
  logic less_672_s22_q;
  logic less_673_s22_q;
  logic less_674_s22_q;
  logic less_675_s22_q;
  logic less_676_s22_q;
  logic less_677_s22_q;
  logic less_678_s22_q;
  logic less_679_s22_q;
  logic less_680_s22_q;
  logic less_681_s22_q;
  logic less_682_s22_q;
  logic less_683_s22_q;
  logic less_684_s22_q;
  logic less_685_s22_q;
  logic and_693_s22_q;
  logic and_718_s22_q;
  logic and_719_s22_q;
  logic less_742_s22_q;
  logic and_749_s22_q;
  logic less_750_s22_q;
  logic and_755_s22_q;
  logic less_756_s22_q;
  logic equal_1791_s22_q;
  logic equal_1793_s22_q;
  logic and_2072_s22_q;
  logic less_2073_s22_q;
  logic equal_2298_s22_q;
  logic and_2303_s22_q;
  logic equal_2415_s22_q;
  logic sum_s22_q;
  logic sum_2_s22_q;
  logic equal_2459_s22_q;
  logic select_2477_s22_q;
  logic select_2483_s22_q;
  logic parity_3258_s22_q;
  logic parity_3387_s22_q;
  logic parity_3449_s22_q;
  logic xor_3477_s22_q;
  logic parity_3489_s22_q;
  logic and_3490_s22_q;
  logic and_3492_s22_q;
  logic equal_3494_s22_q;
  logic or_3900_s22_q;
  logic select_3908_s22_q;
  logic equal_3919_s22_q;
  logic not_3939_s22_q;
  logic and_3974_s22_q;
  logic not_3976_s22_q;
  logic or_3980_s22_q;
  logic and_3985_s22_q;
  logic and_3987_s22_q;
  logic and_4091_s22_q;
  logic and_4109_s22_q;
  logic and_4112_s22_q;
  logic and_4124_s22_q;
  logic and_4137_s22_q;
  logic and_4158_s22_q;
  logic and_4169_s22_q;
  logic and_4173_s22_q;
  logic [5:0] select_4175_s22_q;
  logic [31:0] select_4192_s22_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_s21_q;
      patches_summed_row_column_s22_q <= patches_summed_row_column_s21_q;
      patches_summed_first_s22_q <= patches_summed_first_s21_q;
      patches_summed_last_s22_q <= patches_summed_last_s21_q;
      patches_summed_down_by_s22_q <= patches_summed_down_by_s21_q;
      patches_round_ends_s22_q <= patches_round_ends_q;
      patches_on_skin_s22_q <= patches_on_skin_q;
      last_s22_q <= last_s21_q;
      and_555_s22_q <= and_555_s21_q;
      equal_580_s22_q <= equal_580_s21_q;
      so_s22_q <= so_s21_q;
      less_662_s22_q <= less_662_s21_q;
      less_663_s22_q <= less_663_s21_q;
      less_664_s22_q <= less_664_s21_q;
      less_665_s22_q <= less_665_s21_q;
      less_666_s22_q <= less_666_s21_q;
      less_667_s22_q <= less_667_s21_q;
      less_668_s22_q <= less_668_s21_q;
      less_669_s22_q <= less_669_s21_q;
      less_670_s22_q <= less_670_s21_q;
      less_671_s22_q <= less_671_s21_q;
      less_672_s22_q <= less_672_s21_q;
      less_673_s22_q <= less_673_s21_q;
      less_674_s22_q <= less_674_s21_q;
      less_675_s22_q <= less_675_s21_q;
      less_676_s22_q <= less_676_s21_q;
      less_677_s22_q <= less_677_s21_q;
      less_678_s22_q <= less_678_s21_q;
      less_679_s22_q <= less_679_s21_q;
      less_680_s22_q <= less_680_s21_q;
      less_681_s22_q <= less_681_s21_q;
      less_682_s22_q <= less_682_s21_q;
      less_683_s22_q <= less_683_s21_q;
      less_684_s22_q <= less_684_s21_q;
      less_685_s22_q <= less_685_s21_q;
      and_693_s22_q <= and_693_s21_q;
      and_718_s22_q <= and_718_s21_q;
      and_719_s22_q <= and_719_s21_q;
      less_742_s22_q <= 9'h4 < sum_741_s21_q;
      and_749_s22_q <= and_749_s21_q;
      less_750_s22_q <= less_750_s21_q;
      and_755_s22_q <= and_755_s21_q;
      less_756_s22_q <= less_756_s21_q;
      equal_1791_s22_q <= equal_1791_s21_q;
      equal_1793_s22_q <= equal_1793_s21_q;
      and_2072_s22_q <= and_2072_s21_q;
      less_2073_s22_q <= less_2073_s21_q;
      equal_2298_s22_q <= equal_2298_s21_q;
      and_2303_s22_q <= and_718_s21_q & (9'h4 < sum_2301_s21_q);
      equal_2415_s22_q <= equal_2415_s21_q;
      sum_s22_q <= sum[0];
      sum_2_s22_q <= sum_2[0];
      equal_2459_s22_q <= equal_2459_s21_q;
      select_2477_s22_q <= sharpness_comparing_less_contrast_0_q;
      select_2483_s22_q <= sharpness_comparing_less_contrast_1_q;
      parity_3258_s22_q <= parity_3258_s21_q;
      parity_3387_s22_q <= parity_3387_s21_q;
      parity_3449_s22_q <= parity_3449;
      xor_3477_s22_q <= parity_3464 ^ parity_3476;
      parity_3489_s22_q <= ^{or_3486, or_3482, and_3478};
      and_3490_s22_q <= or_3482 & or_3486;
      and_3492_s22_q <= and_3478 & (or_3482 | or_3486);
      equal_3494_s22_q <= equal_3494_s21_q;
      or_3900_s22_q <= or_3900_s21_q;
      select_3908_s22_q <= select_3908_s21_q;
      equal_3919_s22_q <= equal_3919_s21_q;
      not_3939_s22_q <= ~select_3938;
      and_3974_s22_q <= over[14] & equal_3687_s21_q;
      not_3976_s22_q <= not_3976_s21_q;
      or_3980_s22_q <= or_3980_s21_q;
      and_3985_s22_q <= and_3985_s21_q;
      and_3987_s22_q <= over[14] & less_3986_s21_q;
      and_4091_s22_q <= and_4091_s21_q;
      and_4109_s22_q <= select_4107[0] & and_4108_s21_q;
      and_4112_s22_q <= select_4107[1] & and_4108_s21_q;
      and_4124_s22_q <= equal_580_s21_q & (equal_3919_s21_q & (cfg_prove_i & or_4121));
      and_4137_s22_q <= equal_580_s21_q & and_4136;
      and_4158_s22_q <= and_4158_s21_q;
      and_4169_s22_q <= and_4169;
      and_4173_s22_q <= and_4173_s21_q;
      select_4175_s22_q <= select_4175_s21_q;
      select_4192_s22_q <= equal_580_s21_q ? (x_s21_q ? select_4190 : 32'h0) : 32'h0;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  logic [4:0] patches_on_skin_limit_q;
  logic [8:0] hidden_for_q;
  logic [1:0] hidden_more_q;
  logic hidden_ends_q;
  logic too_much_q;
  logic overlooks_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:317
  logic and_743;
  assign and_743 = and_693_s22_q & less_742_s22_q;
  // hls/stages/census.hpp:324
  logic and_2304;
  assign and_2304 = and_718_s22_q & less_742_s22_q;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2305;
  assign sum_2305 = census_left_misses_q + {{17{and_2304}}, and_2303_s22_q, 1'b0, and_2303_s22_q};
  // hls/stages/agreement.hpp:531
  logic [19:0] select_2307;
  assign select_2307 = and_555_s22_q ? (equal_2298_s22_q ? 20'h0 : sum_2305) : census_left_misses_q;
  // hls/stages/agreement.hpp:217
  logic [2:0] select_2443;
  assign select_2443 = equal_2415_s22_q ? {sharpness_comparing_product_0_q[1:0], sum_s22_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2445;
  assign select_2445 = equal_2415_s22_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s22_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s22_q});
  // hls/stages/agreement.hpp:217
  logic select_2454;
  assign select_2454 = so_s22_q ? (equal_2415_s22_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s22_q});
  // hls/stages/agreement.hpp:217
  logic select_2457;
  assign select_2457 = equal_2415_s22_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:403
  logic xor_2460;
  assign xor_2460 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2466;
  assign xor_2466 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/count_bits.hpp:27
  logic or_3493;
  assign or_3493 = and_3490_s22_q | and_3492_s22_q;
  // hls/stages/patches.hpp:534
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3493, parity_3489_s22_q, xor_3477_s22_q, parity_3449_s22_q, parity_3387_s22_q, parity_3258_s22_q} + (equal_3494_s22_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3498;
  assign select_3498 = equal_1791_s22_q ? patches_sums_values_0_q : (equal_1793_s22_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3499;
  assign select_3499 = equal_1793_s22_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3501;
  assign select_3501 = equal_1793_s22_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3503;
  assign select_3503 = equal_1793_s22_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3505;
  assign select_3505 = equal_1793_s22_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3507;
  assign select_3507 = equal_1793_s22_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3509;
  assign select_3509 = equal_1793_s22_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3511;
  assign select_3511 = equal_1793_s22_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3513;
  assign select_3513 = equal_1793_s22_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3515;
  assign select_3515 = equal_1793_s22_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3517;
  assign select_3517 = equal_1793_s22_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3519;
  assign select_3519 = equal_1793_s22_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3521;
  assign select_3521 = equal_1793_s22_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3523;
  assign select_3523 = equal_1793_s22_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3525;
  assign select_3525 = equal_1793_s22_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3527;
  assign select_3527 = equal_1793_s22_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3529;
  assign select_3529 = equal_1793_s22_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:668
  logic [12:0] product_3814;
  assign product_3814 = {8'h0, patches_on_skin_limit_q} * {5'h0, patches_places_q};
  // hls/stages/agreement.hpp:1165
  logic [8:0] select_3923;
  assign select_3923 = hidden_ends_q ? 9'h0 : (hidden_for_q + {{7{hidden_more_q[0]}}, hidden_more_q});
  // hls/stages/agreement.hpp:1177
  logic [8:0] select_3924;
  assign select_3924 = equal_3919_s22_q ? select_3923 : hidden_for_q;
  // hls/stages/agreement.hpp:1180
  logic or_3942;
  assign or_3942 = not_3939_s22_q | (~(hidden_for_q[8:1] == 8'hff));
  // hls/stages/agreement.hpp:799
  logic select_3947;
  assign select_3947 = equal_580_s22_q ? (not_3939_s22_q & (cfg_same_table_i | (hidden_for_q == 9'h0))) : hidden_ends_q;
  // hls/stages/agreement.hpp:1258
  logic and_3977;
  assign and_3977 = too_much_q & not_3976_s22_q;
  // hls/stages/agreement.hpp:1259
  logic select_3982;
  assign select_3982 = and_3974_s22_q ? (and_3977 | or_3980_s22_q) : and_3977;
  // hls/stages/agreement.hpp:1261
  logic select_3988;
  assign select_3988 = and_3985_s22_q ? and_3987_s22_q : overlooks_q;
  // hls/stages/agreement.hpp:443
  logic select_4111;
  assign select_4111 = and_2072_s22_q ? (less_2073_s22_q ? and_4109_s22_q : seen_q) : seen_q;
  logic select_4114;
  assign select_4114 = and_2072_s22_q ? (less_2073_s22_q ? and_4112_s22_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1169
  logic or_4139;
  assign or_4139 = select_2477_s22_q | ($signed(20'h0) < $signed(census_left_misses_q));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s22_q;
  logic fresh_we;
  assign fresh_we = s22_en & and_555_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_756_s22_q, and_755_s22_q, less_750_s22_q, and_749_s22_q, census_columns_values_1_cell_2_of_skin_s22_q, and_743, and_719_s22_q, and_718_s22_q, and_693_s22_q, less_685_s22_q, less_684_s22_q, less_683_s22_q, less_682_s22_q, less_681_s22_q, less_680_s22_q, less_679_s22_q, less_678_s22_q, less_677_s22_q, less_676_s22_q, less_675_s22_q, less_674_s22_q, less_673_s22_q, less_672_s22_q, less_671_s22_q, less_670_s22_q, less_669_s22_q, less_668_s22_q, less_667_s22_q, less_666_s22_q, less_665_s22_q, less_664_s22_q, less_663_s22_q, less_662_s22_q};
  end
`ifndef SYNTHESIS
  logic [6:0] fresh_raddr_s7_sim;
  logic fresh_re_s7_sim;
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
      fresh_re_s7_sim <= 1'b0;
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
      fresh_re_s7_sim <= fresh_re;
      fresh_raddr_s7_sim <= fresh_raddr;
      fresh_re_s8_sim <= fresh_re_s7_sim;
      fresh_raddr_s8_sim <= fresh_raddr_s7_sim;
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
      if (fresh_re_s7_sim && fresh_raddr_s7_sim == fresh_waddr) begin
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
      patches_on_skin_limit_q <= 5'h0;
      hidden_for_q <= 9'h0;
      hidden_more_q <= 2'h0;
      hidden_ends_q <= 1'b0;
      too_much_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s22_en) begin
      census_left_misses_q <= select_2307;
      sharpness_comparing_product_0_q <= so_s22_q ? select_2443 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s22_q ? select_2445 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2454;
      sharpness_comparing_carry_1_q <= so_s22_q ? select_2457 : sharpness_comparing_carry_1_q;
      patches_sums_values_0_q <= select_3498;
      patches_sums_values_1_q <= equal_1791_s22_q ? patches_sums_values_1_q : select_3499;
      patches_sums_values_2_q <= equal_1791_s22_q ? patches_sums_values_2_q : select_3501;
      patches_sums_values_3_q <= equal_1791_s22_q ? patches_sums_values_3_q : select_3503;
      patches_sums_values_4_q <= equal_1791_s22_q ? patches_sums_values_4_q : select_3505;
      patches_sums_values_5_q <= equal_1791_s22_q ? patches_sums_values_5_q : select_3507;
      patches_sums_values_6_q <= equal_1791_s22_q ? patches_sums_values_6_q : select_3509;
      patches_sums_values_7_q <= equal_1791_s22_q ? patches_sums_values_7_q : select_3511;
      patches_sums_values_8_q <= equal_1791_s22_q ? patches_sums_values_8_q : select_3513;
      patches_sums_values_9_q <= equal_1791_s22_q ? patches_sums_values_9_q : select_3515;
      patches_sums_values_10_q <= equal_1791_s22_q ? patches_sums_values_10_q : select_3517;
      patches_sums_values_11_q <= equal_1791_s22_q ? patches_sums_values_11_q : select_3519;
      patches_sums_values_12_q <= equal_1791_s22_q ? patches_sums_values_12_q : select_3521;
      patches_sums_values_13_q <= equal_1791_s22_q ? patches_sums_values_13_q : select_3523;
      patches_sums_values_14_q <= equal_1791_s22_q ? patches_sums_values_14_q : select_3525;
      patches_sums_values_15_q <= equal_1791_s22_q ? patches_sums_values_15_q : select_3527;
      patches_sums_values_16_q <= equal_1791_s22_q ? patches_sums_values_16_q : select_3529;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      hidden_for_q <= equal_580_s22_q ? select_3924 : hidden_for_q;
      hidden_more_q <= equal_580_s22_q ? {or_3942, not_3939_s22_q} : hidden_more_q;
      hidden_ends_q <= select_3947;
      too_much_q <= equal_580_s22_q ? select_3982 : too_much_q;
      overlooks_q <= equal_580_s22_q ? select_3988 : overlooks_q;
      seen_q <= select_4111;
      nearer_q <= select_4114;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic [9:0] patches_sums_values_0_s23_q;
  logic [4:0] patches_summed_row_column_s23_q;
  logic patches_summed_first_s23_q;
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic patches_round_ends_s23_q;
  logic [7:0] patches_on_skin_s23_q;
  logic equal_580_s23_q;
  logic so_s23_q;
  logic equal_2415_s23_q;
  logic or_2461_s23_q;
  logic and_2462_s23_q;
  logic or_2467_s23_q;
  logic and_2468_s23_q;
  logic select_2483_s23_q;
  logic [7:0] product_3814_s23_q;
  logic or_3900_s23_q;
  logic equal_3919_s23_q;
  logic [7:0] select_3924_s23_q;
  logic and_4091_s23_q;
  logic and_4124_s23_q;
  logic or_4130_s23_q;
  logic and_4137_s23_q;
  logic or_4139_s23_q;
  logic and_4158_s23_q;
  logic or_4163_s23_q;
  logic and_4169_s23_q;
  logic and_4173_s23_q;
  logic [5:0] select_4175_s23_q;
  logic [31:0] select_4192_s23_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      patches_sums_values_0_s23_q <= patches_sums_values_0_q;
      patches_summed_row_column_s23_q <= patches_summed_row_column_s22_q;
      patches_summed_first_s23_q <= patches_summed_first_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_s22_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_s22_q;
      patches_round_ends_s23_q <= patches_round_ends_s22_q;
      patches_on_skin_s23_q <= patches_on_skin_s22_q;
      equal_580_s23_q <= equal_580_s22_q;
      so_s23_q <= so_s22_q;
      equal_2415_s23_q <= equal_2415_s22_q;
      or_2461_s23_q <= equal_2459_s22_q | xor_2460;
      and_2462_s23_q <= five_times[0] & xor_2460;
      or_2467_s23_q <= equal_2459_s22_q | xor_2466;
      and_2468_s23_q <= five_times_2[0] & xor_2466;
      select_2483_s23_q <= select_2483_s22_q;
      product_3814_s23_q <= product_3814[12:5];
      or_3900_s23_q <= or_3900_s22_q;
      equal_3919_s23_q <= equal_3919_s22_q;
      select_3924_s23_q <= select_3924[8:1];
      and_4091_s23_q <= and_4091_s22_q;
      and_4124_s23_q <= and_4124_s22_q;
      or_4130_s23_q <= select_3908_s22_q | select_3982;
      and_4137_s23_q <= and_4137_s22_q;
      or_4139_s23_q <= or_4139;
      and_4158_s23_q <= and_4158_s22_q;
      or_4163_s23_q <= not_2367 | (select_3988 & not_3811);
      and_4169_s23_q <= and_4169_s22_q;
      and_4173_s23_q <= and_4173_s22_q;
      select_4175_s23_q <= select_4175_s22_q;
      select_4192_s23_q <= select_4192_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic [9:0] patches_best_differing_q;
  logic [4:0] patches_best_column_q;
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:186
  logic less_1981;
  assign less_1981 = patches_sums_values_0_s23_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_1982;
  assign not_1982 = ~less_1981;
  logic [1:0] select_1983;
  assign select_1983 = patches_summed_first_s23_q ? 2'h2 : {less_1981, not_1982};
  logic [12:0] select_1985;
  assign select_1985 = select_1983[0] ? {4'h0, patches_summed_first_s23_q, 3'h0, patches_summed_row_column_s23_q} : {patches_summed_row_column_s23_q, patches_sums_values_0_s23_q[7:0]};
  logic [14:0] select_1986;
  assign select_1986 = select_1983[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1987;
  assign select_1987 = (select_1983 == 2'h2) ? {select_1985[12:8], patches_sums_values_0_s23_q[9:8], select_1985[7:0]} : select_1986;
  // hls/stages/census.hpp:403
  logic select_2463;
  assign select_2463 = or_2461_s23_q ? and_2462_s23_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2464;
  assign select_2464 = equal_2415_s23_q ? select_2463 : sharpness_comparing_less_detail_0_q;
  logic select_2465;
  assign select_2465 = so_s23_q ? select_2464 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic select_2469;
  assign select_2469 = or_2467_s23_q ? and_2468_s23_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2470;
  assign select_2470 = equal_2415_s23_q ? select_2469 : sharpness_comparing_less_detail_1_q;
  logic select_2471;
  assign select_2471 = so_s23_q ? select_2470 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:192
  logic and_3816;
  assign and_3816 = (~(patches_on_skin_s23_q[7:2] == 6'h0)) & (product_3814_s23_q < patches_on_skin_s23_q);
  logic select_3821;
  assign select_3821 = patches_round_ends_s23_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:649
  logic or_3825;
  assign or_3825 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s23_q));
  // hls/stages/agreement.hpp:799
  logic and_4127;
  assign and_4127 = equal_580_s23_q & (equal_3919_s23_q & (cfg_prove_i & or_3900_s23_q));
  // hls/stages/agreement.hpp:1271
  logic not_4129;
  assign not_4129 = ~(or_3900_s23_q | not_2367);
  // hls/stages/agreement.hpp:799
  logic and_4133;
  assign and_4133 = equal_580_s23_q & (equal_3919_s23_q & (not_4129 & or_4130_s23_q));
  logic and_4146;
  assign and_4146 = equal_3919_s23_q & (not_4129 & (select_2471 | select_2483_s23_q));
  // hls/stages/agreement.hpp:1169
  logic and_4152;
  assign and_4152 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3924_s23_q < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:799
  logic and_4165;
  assign and_4165 = equal_3919_s23_q & (or_4163_s23_q ? cfg_prove_i : patches_overlooked_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      patches_best_differing_q <= 10'h0;
      patches_best_column_q <= 5'h0;
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s23_en) begin
      sharpness_comparing_less_detail_0_q <= select_2465;
      sharpness_comparing_less_detail_1_q <= select_2471;
      patches_best_differing_q <= select_1987[9:0];
      patches_best_column_q <= select_1987[14:10];
      patches_large_q <= not_3811 & and_3816;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3821;
      patches_spoiled_q <= or_3825;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s23_en) begin
      left_pixel_q <= left_pixel_q;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic patches_summed_last_s24_q;
  logic [4:0] patches_summed_down_by_s24_q;
  logic equal_580_s24_q;
  logic equal_3919_s24_q;
  logic and_4091_s24_q;
  logic or_4115_s24_q;
  logic and_4116_s24_q;
  logic and_4124_s24_q;
  logic and_4127_s24_q;
  logic and_4133_s24_q;
  logic and_4137_s24_q;
  logic and_4142_s24_q;
  logic and_4146_s24_q;
  logic or_4153_s24_q;
  logic and_4158_s24_q;
  logic and_4166_s24_q;
  logic and_4169_s24_q;
  logic and_4173_s24_q;
  logic [5:0] select_4175_s24_q;
  logic [31:0] select_4192_s24_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      patches_summed_last_s24_q <= patches_summed_last_s23_q;
      patches_summed_down_by_s24_q <= patches_summed_down_by_s23_q;
      equal_580_s24_q <= equal_580_s23_q;
      equal_3919_s24_q <= equal_3919_s23_q;
      and_4091_s24_q <= and_4091_s23_q;
      or_4115_s24_q <= not_2367 | seen_q;
      and_4116_s24_q <= cfg_prove_i & nearer_q;
      and_4124_s24_q <= and_4124_s23_q;
      and_4127_s24_q <= and_4127;
      and_4133_s24_q <= and_4133;
      and_4137_s24_q <= and_4137_s23_q;
      and_4142_s24_q <= equal_3919_s23_q & (not_4129 & (select_2465 | or_4139_s23_q));
      and_4146_s24_q <= and_4146;
      or_4153_s24_q <= not_2367 | and_4152;
      and_4158_s24_q <= and_4158_s23_q;
      and_4166_s24_q <= equal_580_s23_q & and_4165;
      and_4169_s24_q <= and_4169_s23_q;
      and_4173_s24_q <= and_4173_s23_q;
      select_4175_s24_q <= select_4175_s23_q;
      select_4192_s24_q <= select_4192_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:799
  logic and_4160;
  assign and_4160 = equal_3919_s24_q & (or_4153_s24_q ? cfg_prove_i : and_4158_s24_q);

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s24_q;
  logic patches_rows_we;
  assign patches_rows_we = s24_en & patches_summed_last_s24_q;
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
  logic [4:0] patches_rows_raddr_s23_sim;
  logic patches_rows_re_s23_sim;
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
      patches_rows_re_s23_sim <= 1'b0;
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
      patches_rows_re_s23_sim <= patches_rows_re_s22_sim;
      patches_rows_raddr_s23_sim <= patches_rows_raddr_s22_sim;
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
      if (patches_rows_re_s23_sim && patches_rows_raddr_s23_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic and_4091_s25_q;
  logic or_4115_s25_q;
  logic and_4116_s25_q;
  logic and_4124_s25_q;
  logic and_4127_s25_q;
  logic and_4133_s25_q;
  logic and_4137_s25_q;
  logic and_4143_s25_q;
  logic and_4147_s25_q;
  logic and_4161_s25_q;
  logic and_4166_s25_q;
  logic and_4169_s25_q;
  logic and_4173_s25_q;
  logic [5:0] select_4175_s25_q;
  logic [31:0] select_4192_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      and_4091_s25_q <= and_4091_s24_q;
      or_4115_s25_q <= or_4115_s24_q;
      and_4116_s25_q <= and_4116_s24_q;
      and_4124_s25_q <= and_4124_s24_q;
      and_4127_s25_q <= and_4127_s24_q;
      and_4133_s25_q <= and_4133_s24_q;
      and_4137_s25_q <= and_4137_s24_q;
      and_4143_s25_q <= equal_580_s24_q & and_4142_s24_q;
      and_4147_s25_q <= equal_580_s24_q & and_4146_s24_q;
      and_4161_s25_q <= equal_580_s24_q & and_4160;
      and_4166_s25_q <= and_4166_s24_q;
      and_4169_s25_q <= and_4169_s24_q;
      and_4173_s25_q <= and_4173_s24_q;
      select_4175_s25_q <= select_4175_s24_q;
      select_4192_s25_q <= select_4192_s24_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s25_q;
  assign pixel_1_o = pixel_1_s25_q;
  assign saturated_o = saturated_s25_q;
  assign mask_o = mask_s25_q;
  assign marks_first_o = marks_first_s25_q;
  assign marks_last_o = marks_last_s25_q;
  assign marks_seen_o = or_4115_s25_q;
  assign marks_nearer_o = and_4116_s25_q;
  assign verdict_valid_o = and_4091_s25_q;
  assign verdict_unproven_yet_o = and_4124_s25_q;
  assign verdict_untextured_o = and_4127_s25_q;
  assign verdict_disagree_o = and_4133_s25_q;
  assign verdict_moved_o = and_4137_s25_q;
  assign verdict_unsharp_left_o = and_4143_s25_q;
  assign verdict_unsharp_right_o = and_4147_s25_q;
  assign verdict_hidden_o = and_4161_s25_q;
  assign verdict_overlooked_o = and_4166_s25_q;
  assign verdict_out_of_step_o = and_4169_s25_q;
  assign frame_valid_o = and_4173_s25_q;
  assign frame_index_o = select_4175_s25_q;
  assign frame_word_o = select_4192_s25_q;
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
  assign unused_bits = ^{sum_4156[0], over[13:0], product_3814[4:0], sum_3785[1:0], sum_3745[1:0], product_3646[4:0], sum_2778[0], difference_2716[1:0], detail_4[1:0], detail_3[1:0], sum_2301[4:0], sum_1774[1:0], sum_1773[1:0], sum_1769[0], sum_1720[0], sum_1716[0], sum_741[4:0], cfg_width_i[3:0]};

endmodule
