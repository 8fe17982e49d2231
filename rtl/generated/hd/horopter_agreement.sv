// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 25 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 3083 bits, pipeline 8769 bits, memories 156687 bits.
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
  output logic verdict_out_of_step_o,
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
  logic not_2266;
  assign not_2266 = ~cfg_prove_i;
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_2488;
  assign sum_2488 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3554;
  assign difference_3554 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3770;
  assign not_3770 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3827;
  assign difference_3827 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_4042;
  assign less_4042 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_4043;
  assign sum_4043 = {1'b0, cfg_height_i[10:7]} + 5'h1f;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:36
  logic [3:0] select_493;
  assign select_493 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_493 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_493_s1_q;
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
      select_493_s1_q <= select_493;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:36
  logic [6:0] select_496;
  assign select_496 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:51
  logic equal_528;
  assign equal_528 = select_493_s1_q == 4'hf;
  // hls/stages/agreement.hpp:271
  logic [6:0] select_2107;
  assign select_2107 = sample_pair_whole_s1_q ? (select_496 + {6'h0, equal_528}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2107;
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
  logic [3:0] select_493_s2_q;
  logic [6:0] select_496_s2_q;
  logic equal_528_s2_q;
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
      select_493_s2_q <= select_493_s1_q;
      select_496_s2_q <= select_496;
      equal_528_s2_q <= equal_528;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:110
  logic equal_494;
  assign equal_494 = select_493_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:116
  logic [8:0] select_499;
  assign select_499 = ({select_496_s2_q, select_493_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:117
  logic [8:0] select_500;
  assign select_500 = equal_494 ? select_499 : averager_place_q;
  // hls/stages/census.hpp:42
  logic [3:0] select_511;
  assign select_511 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:271
  logic [3:0] select_2105;
  assign select_2105 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_511 + 4'h1) : select_511) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2105;
      averager_place_q <= sample_pair_whole_s2_q ? select_500 : averager_place_q;
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
  logic [3:0] select_493_s3_q;
  logic equal_494_s3_q;
  logic [6:0] select_496_s3_q;
  logic [8:0] select_500_s3_q;
  logic equal_502_s3_q;
  logic [3:0] select_511_s3_q;
  logic equal_528_s3_q;
  logic equal_529_s3_q;
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
      select_493_s3_q <= select_493_s2_q;
      equal_494_s3_q <= equal_494;
      select_496_s3_q <= select_496_s2_q;
      select_500_s3_q <= select_500;
      equal_502_s3_q <= select_493_s2_q[1:0] == 2'h3;
      select_511_s3_q <= select_511;
      equal_528_s3_q <= equal_528_s2_q;
      equal_529_s3_q <= select_511 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:42
  logic or_501;
  assign or_501 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:412
  logic and_506;
  assign and_506 = (or_501 & equal_502_s3_q) & (~(select_500_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:271
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_496_s3_q : 7'h0;
  // hls/stages/census.hpp:127
  logic and_530;
  assign and_530 = equal_529_s3_q & and_506;
  // hls/stages/agreement.hpp:271
  logic and_532;
  assign and_532 = sample_pair_whole_s3_q & (equal_528_s3_q & and_530);
  // hls/stages/census.hpp:42
  logic [6:0] select_551;
  assign select_551 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:271
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_551 : 7'h0;
  // hls/stages/census.hpp:58
  logic [6:0] select_2109;
  assign select_2109 = sample_last_s3_q ? (select_551 + {6'h0, equal_529_s3_q}) : select_551;
  // hls/stages/agreement.hpp:271
  logic select_2114;
  assign select_2114 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_501 & (~raster_final_row_q)) : or_501) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [10:0] select_2116;
  assign select_2116 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:271
  logic select_2120;
  assign select_2120 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:457
  logic equal_2394;
  assign equal_2394 = {last[7], column} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2109 : raster_at_row_q;
      raster_at_live_q <= select_2114;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2116 : raster_rows_left_q;
      raster_final_row_q <= select_2120;
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
  logic [3:0] select_493_s4_q;
  logic equal_494_s4_q;
  logic [6:0] select_496_s4_q;
  logic [8:0] select_500_s4_q;
  logic and_506_s4_q;
  logic [3:0] select_511_s4_q;
  logic [6:0] column_s4_q;
  logic and_530_s4_q;
  logic and_532_s4_q;
  logic [3:0] select_551_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1659_s4_q;
  logic equal_2394_s4_q;
  logic and_2395_s4_q;
  logic [7:0] sum_2484_s4_q;
  logic [2:0] or_2930_s4_q;
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
      select_493_s4_q <= select_493_s3_q;
      equal_494_s4_q <= equal_494_s3_q;
      select_496_s4_q <= select_496_s3_q;
      select_500_s4_q <= select_500_s3_q;
      and_506_s4_q <= and_506;
      select_511_s4_q <= select_511_s3_q;
      column_s4_q <= column;
      and_530_s4_q <= and_530;
      and_532_s4_q <= and_532;
      select_551_s4_q <= select_551[3:0];
      row_s4_q <= row;
      equal_1659_s4_q <= {or_501, select_511_s3_q} == 5'h18;
      equal_2394_s4_q <= equal_2394;
      and_2395_s4_q <= and_532 & equal_2394;
      sum_2484_s4_q <= {1'b0, row} + 8'h1;
      or_2930_s4_q <= select_496_s3_q[2:0] | select_551[6:4];
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
  // hls/stages/agreement.hpp:195
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:621
  logic equal_608;
  assign equal_608 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:612
  logic equal_611;
  assign equal_611 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:613
  logic equal_613;
  assign equal_613 = run_phase_q == 3'h2;
  // hls/stages/patches.hpp:122
  logic and_1653;
  assign and_1653 = (select_493_s4_q == 4'h0) & (select_496_s4_q == 7'h0);
  // hls/stages/agreement.hpp:521
  logic select_2398;
  assign select_2398 = (and_2395_s4_q | (~ends_cell_q)) ? and_2395_s4_q : ends_q;
  // hls/stages/agreement.hpp:527
  logic [2:0] now;
  assign now = select_2398 ? (and_2395_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:532
  logic [5:0] select_2402;
  assign select_2402 = select_2398 ? (and_2395_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2405;
  assign select_2405 = select_2398 ? (following_last_shift_q & (~and_2395_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:533
  logic [7:0] select_2407;
  assign select_2407 = select_2398 ? (and_2395_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:605
  logic and_2408;
  assign and_2408 = run_last_shift_q & equal_611;
  // hls/stages/agreement.hpp:614
  logic select_2410;
  assign select_2410 = equal_611 ? (~run_last_shift_q) : equal_613;
  // hls/stages/agreement.hpp:618
  logic equal_2411;
  assign equal_2411 = run_phase_q == 3'h1;
  logic not_2414;
  assign not_2414 = ~select_2410;
  // hls/stages/agreement.hpp:621
  logic equal_2416;
  assign equal_2416 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:605
  logic and_2417;
  assign and_2417 = final_row_q & so;
  // hls/stages/agreement.hpp:618
  logic [1:0] select_2418;
  assign select_2418 = equal_2416 ? 2'h1 : {2{and_2417}};
  logic [2:0] select_2420;
  assign select_2420 = (and_2408 | (select_2410 | equal_2411)) ? (equal_2411 ? 3'h2 : {not_2414, {2{select_2410}}}) : (equal_608 ? 3'h6 : {select_2418[0], select_2418});
  // hls/stages/agreement.hpp:605
  logic and_2423;
  assign and_2423 = select_2410 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:628
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2426;
  assign select_2426 = (plan_shift_q[5] & select_2410) ? value : 7'h0;
  logic [1:0] or_2427;
  assign or_2427 = {2{so}} | select_2426[5:4];
  // hls/stages/agreement.hpp:631
  logic [7:0] or_2431;
  assign or_2431 = (select_2410 ? plan_columns_q : 8'h0) | ((equal_2411 | equal_2416) ? whole_q : 8'h0);
  logic [1:0] or_2432;
  assign or_2432 = {2{and_2408}} | or_2431[4:3];
  // hls/stages/agreement.hpp:632
  logic [7:0] or_2434;
  assign or_2434 = {or_2431[7:5], or_2432, or_2431[2:0]} | (equal_608 ? drawn_q : 8'h0);
  logic [4:0] or_2435;
  assign or_2435 = {5{so}} | {or_2434[6], or_2434[3:0]};
  // hls/stages/agreement.hpp:638
  logic not_2439;
  assign not_2439 = ~run_shift_q[5];
  logic [7:0] select_2442;
  assign select_2442 = equal_611 ? ({{7{not_2439}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:521
  logic [6:0] select_2446;
  assign select_2446 = and_2395_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:524
  logic [7:0] select_2448;
  assign select_2448 = select_2398 ? {select_2446[6], select_2446} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2451;
  assign select_2451 = select_2398 ? (and_2395_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:458
  logic [6:0] select_2458;
  assign select_2458 = equal_2394_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:518
  logic [7:0] select_2462;
  assign select_2462 = and_532_s4_q ? (equal_2394_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2465;
  assign select_2465 = and_532_s4_q ? (equal_2394_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:529
  logic select_2479;
  assign select_2479 = (ends_cell_q | select_2398) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_611 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:524
  logic and_2483;
  assign and_2483 = (~select_2398) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:474
  logic equal_2485;
  assign equal_2485 = {sum_2484_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2484_s4_q[6:0]};
  // hls/stages/agreement.hpp:518
  logic select_2487;
  assign select_2487 = and_532_s4_q ? (equal_2394_s4_q ? equal_2485 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2867;
  assign select_2867 = and_1653 ? (sample_pair_first_s4_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/patches.hpp:370
  logic [8:0] sum_2931;
  assign sum_2931 = {1'b0, select_496_s4_q[3], or_2930_s4_q, select_551_s4_q} + 9'h1;

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
      run_shift_q <= select_2402;
      run_last_shift_q <= select_2405;
      run_span_q <= select_2407;
      following_phase_q <= select_2420;
      following_shift_q <= select_2410 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2423;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2426[6], or_2427, select_2426[3:0]};
      following_columns_q <= {or_2434[7], or_2435[4], or_2434[5:4], or_2435[3:0]};
      plan_shift_q <= equal_611 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2442;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2448;
      columns_left_q <= select_2451;
      last_q <= and_532_s4_q ? (equal_2394_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_532_s4_q ? select_2458 : least_q;
      whole_q <= select_2462;
      drawn_q <= select_2465;
      slot_q <= select_2398 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2479;
      ends_q <= and_2483;
      final_row_q <= select_2487;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= sample_pair_whole_s4_q ? select_2867 : patches_phase_q;
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
  logic [3:0] select_493_s5_q;
  logic equal_494_s5_q;
  logic [6:0] select_496_s5_q;
  logic [8:0] select_500_s5_q;
  logic and_506_s5_q;
  logic equal_512_s5_q;
  logic [6:0] column_s5_q;
  logic and_530_s5_q;
  logic and_532_s5_q;
  logic [6:0] row_s5_q;
  logic so_s5_q;
  logic equal_608_s5_q;
  logic equal_611_s5_q;
  logic equal_613_s5_q;
  logic [7:0] sum_614_s5_q;
  logic equal_671_s5_q;
  logic [7:0] sum_715_s5_q;
  logic and_1653_s5_q;
  logic equal_1659_s5_q;
  logic equal_2394_s5_q;
  logic and_2395_s5_q;
  logic select_2398_s5_q;
  logic [3:0] phase_s5_q;
  logic not_2933_s5_q;
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
      select_493_s5_q <= select_493_s4_q;
      equal_494_s5_q <= equal_494_s4_q;
      select_496_s5_q <= select_496_s4_q;
      select_500_s5_q <= select_500_s4_q;
      and_506_s5_q <= and_506_s4_q;
      equal_512_s5_q <= select_511_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_530_s5_q <= and_530_s4_q;
      and_532_s5_q <= and_532_s4_q;
      row_s5_q <= row_s4_q;
      so_s5_q <= so;
      equal_608_s5_q <= equal_608;
      equal_611_s5_q <= equal_611;
      equal_613_s5_q <= equal_613;
      sum_614_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      equal_671_s5_q <= run_phase_q == 3'h7;
      sum_715_s5_q <= {1'b0, last_q} + 8'h3;
      and_1653_s5_q <= and_1653;
      equal_1659_s5_q <= equal_1659_s4_q;
      equal_2394_s5_q <= equal_2394_s4_q;
      and_2395_s5_q <= and_2395_s4_q;
      select_2398_s5_q <= select_2398;
      phase_s5_q <= phase;
      not_2933_s5_q <= ~({sum_2931, select_511_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:592
  logic [7:0] select_615;
  assign select_615 = run_shift_s5_q[5] ? x_s5_q : sum_614_s5_q;
  logic less_616;
  assign less_616 = {1'b0, last_s5_q} < select_615;
  // hls/stages/agreement.hpp:223
  logic not_617;
  assign not_617 = ~less_616;
  // hls/stages/agreement.hpp:797
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:526
  logic [6:0] select_2467;
  assign select_2467 = select_2398_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2467;
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
  logic [3:0] select_493_s6_q;
  logic equal_494_s6_q;
  logic [6:0] select_496_s6_q;
  logic [8:0] select_500_s6_q;
  logic and_506_s6_q;
  logic equal_512_s6_q;
  logic [6:0] column_s6_q;
  logic and_530_s6_q;
  logic and_532_s6_q;
  logic [6:0] row_s6_q;
  logic so_s6_q;
  logic equal_608_s6_q;
  logic equal_611_s6_q;
  logic [6:0] sum_614_s6_q;
  logic less_616_s6_q;
  logic not_617_s6_q;
  logic and_618_s6_q;
  logic equal_671_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_719_s6_q;
  logic equal_1534_s6_q;
  logic and_1653_s6_q;
  logic equal_1659_s6_q;
  logic equal_2394_s6_q;
  logic and_2395_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2887_s6_q;
  logic [3:0] select_2890_s6_q;
  logic not_2933_s6_q;
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
      select_493_s6_q <= select_493_s5_q;
      equal_494_s6_q <= equal_494_s5_q;
      select_496_s6_q <= select_496_s5_q;
      select_500_s6_q <= select_500_s5_q;
      and_506_s6_q <= and_506_s5_q;
      equal_512_s6_q <= equal_512_s5_q;
      column_s6_q <= column_s5_q;
      and_530_s6_q <= and_530_s5_q;
      and_532_s6_q <= and_532_s5_q;
      row_s6_q <= row_s5_q;
      so_s6_q <= so_s5_q;
      equal_608_s6_q <= equal_608_s5_q;
      equal_611_s6_q <= equal_611_s5_q;
      sum_614_s6_q <= sum_614_s5_q[6:0];
      less_616_s6_q <= less_616;
      not_617_s6_q <= not_617;
      and_618_s6_q <= equal_613_s5_q & not_617;
      equal_671_s6_q <= equal_671_s5_q;
      x_s6_2_q <= x[6:0];
      and_719_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_715_s5_q < select_615)));
      equal_1534_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      and_1653_s6_q <= and_1653_s5_q;
      equal_1659_s6_q <= equal_1659_s5_q;
      equal_2394_s6_q <= equal_2394_s5_q;
      and_2395_s6_q <= and_2395_s5_q;
      phase_s6_q <= phase_s5_q;
      equal_2887_s6_q <= row_s5_q == 7'h3;
      select_2890_s6_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_2933_s6_q <= not_2933_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:592
  logic or_609;
  assign or_609 = so_s6_q | equal_608_s6_q;
  // hls/stages/agreement.hpp:719
  logic not_610;
  assign not_610 = ~or_609;
  // hls/stages/agreement.hpp:148
  logic select_695;
  assign select_695 = equal_611_s6_q ? not_617_s6_q : and_618_s6_q;
  logic and_720;
  assign and_720 = equal_611_s6_q & and_719_s6_q;
  logic select_721;
  assign select_721 = or_609 ? not_617_s6_q : and_720;
  // hls/stages/agreement.hpp:820
  logic [6:0] right;
  assign right = sum_614_s6_q + 7'h7d;
  // hls/stages/agreement.hpp:518
  logic and_2757;
  assign and_2757 = and_532_s6_q & (equal_2394_s6_q & (row_s6_q[6:2] == 5'h0));
  // hls/stages/patches.hpp:87
  logic [3:0] select_2891;
  assign select_2891 = equal_2887_s6_q ? select_2890_s6_q : patches_choosing_rows_to_next_q;
  logic equal_2892;
  assign equal_2892 = select_2891 == 4'h0;
  // hls/stages/agreement.hpp:458
  logic [3:0] select_2895;
  assign select_2895 = equal_2394_s6_q ? (equal_2892 ? 4'h2 : (select_2891 + 4'hf)) : patches_choosing_rows_to_next_q;

  // Memory left, 120 x 85, DISTANCE 24, hls/stages/agreement.hpp:1364; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [84:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 85'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_609 ? not_617_s6_q : select_695);
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 97, DISTANCE 24, hls/stages/agreement.hpp:1365; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [96:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 97'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_611_s6_q ? sum_614_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_610 & select_695);
  logic [96:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1366; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [61:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 62'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_609 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_721;
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s6_en) begin
      patches_choosing_rows_to_next_q <= and_532_s6_q ? select_2895 : patches_choosing_rows_to_next_q;
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
  logic [3:0] select_493_s7_q;
  logic equal_494_s7_q;
  logic [6:0] select_496_s7_q;
  logic [8:0] select_500_s7_q;
  logic and_506_s7_q;
  logic equal_512_s7_q;
  logic [6:0] column_s7_q;
  logic and_530_s7_q;
  logic and_532_s7_q;
  logic [6:0] row_s7_q;
  logic so_s7_q;
  logic equal_608_s7_q;
  logic or_609_s7_q;
  logic equal_611_s7_q;
  logic less_616_s7_q;
  logic not_617_s7_q;
  logic and_620_s7_q;
  logic equal_671_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_721_s7_q;
  logic and_1526_s7_q;
  logic [6:0] right_s7_q;
  logic equal_1534_s7_q;
  logic and_1653_s7_q;
  logic equal_1659_s7_q;
  logic equal_2394_s7_q;
  logic and_2758_s7_q;
  logic and_2760_s7_q;
  logic and_2767_s7_q;
  logic [3:0] phase_s7_q;
  logic equal_2887_s7_q;
  logic equal_2892_s7_q;
  logic not_2933_s7_q;
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
      select_493_s7_q <= select_493_s6_q;
      equal_494_s7_q <= equal_494_s6_q;
      select_496_s7_q <= select_496_s6_q;
      select_500_s7_q <= select_500_s6_q;
      and_506_s7_q <= and_506_s6_q;
      equal_512_s7_q <= equal_512_s6_q;
      column_s7_q <= column_s6_q;
      and_530_s7_q <= and_530_s6_q;
      and_532_s7_q <= and_532_s6_q;
      row_s7_q <= row_s6_q;
      so_s7_q <= so_s6_q;
      equal_608_s7_q <= equal_608_s6_q;
      or_609_s7_q <= or_609;
      equal_611_s7_q <= equal_611_s6_q;
      less_616_s7_q <= less_616_s6_q;
      not_617_s7_q <= not_617_s6_q;
      and_620_s7_q <= not_610 & ((~equal_611_s6_q) & and_618_s6_q);
      equal_671_s7_q <= equal_671_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_721_s7_q <= select_721;
      and_1526_s7_q <= not_610 & and_720;
      right_s7_q <= right;
      equal_1534_s7_q <= equal_1534_s6_q;
      and_1653_s7_q <= and_1653_s6_q;
      equal_1659_s7_q <= equal_1659_s6_q;
      equal_2394_s7_q <= equal_2394_s6_q;
      and_2758_s7_q <= and_2395_s6_q & and_2757;
      and_2760_s7_q <= and_2395_s6_q & (~and_2757);
      and_2767_s7_q <= ends_cell_s6_q & so_s6_q;
      phase_s7_q <= phase_s6_q;
      equal_2887_s7_q <= equal_2887_s6_q;
      equal_2892_s7_q <= equal_2892;
      not_2933_s7_q <= not_2933_s6_q;
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
  // hls/stages/census.hpp:32
  logic not_1657;
  assign not_1657 = ~sample_pair_first_s7_q;
  // hls/stages/patches.hpp:311
  logic equal_1661;
  assign equal_1661 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1731;
  assign select_1731 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1956;
  assign sum_1956 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2761;
  assign select_2761 = and_2760_s7_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2763;
  assign select_2763 = and_2758_s7_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2761[15]}}, select_2761});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2764;
  assign select_2764 = and_2760_s7_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2764[15]}}, select_2764};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2766;
  assign select_2766 = and_2758_s7_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2767_s7_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:372
  logic and_2869;
  assign and_2869 = not_1657 & equal_1659_s7_q;
  logic [8:0] select_2870;
  assign select_2870 = and_2869 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s7_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2871;
  assign select_2871 = and_2869 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2872;
  assign select_2872 = sample_pair_first_s7_q ? select_2870 : select_2871;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2873;
  assign select_2873 = and_1653_s7_q ? select_2872[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:271
  logic [3:0] select_2874;
  assign select_2874 = sample_pair_whole_s7_q ? select_2873 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2876;
  assign select_2876 = sample_pair_whole_s7_q ? (and_1653_s7_q ? select_2872[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2879;
  assign select_2879 = sample_pair_whole_s7_q ? (equal_1661 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2881;
  assign select_2881 = sample_pair_whole_s7_q ? (patches_band_rows_number_q + {4'h0, equal_1661}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2882;
  assign equal_2882 = phase_s7_q == 4'h0;
  // hls/stages/patches.hpp:331
  logic not_2883;
  assign not_2883 = ~equal_2882;
  // hls/stages/agreement.hpp:271
  logic [3:0] select_2885;
  assign select_2885 = sample_pair_whole_s7_q ? (phase_s7_q + {{2{not_2883}}, 1'b1, not_2883}) : patches_first_band_rows_to_next_q;
  logic select_2886;
  assign select_2886 = sample_pair_whole_s7_q ? equal_2882 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2897;
  assign select_2897 = equal_2887_s7_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:458
  logic [4:0] select_2899;
  assign select_2899 = equal_2394_s7_q ? (select_2897 + {4'h0, equal_2892_s7_q}) : patches_choosing_number_q;
  logic select_2903;
  assign select_2903 = equal_2394_s7_q ? ((7'h2 < row_s7_q) & equal_2892_s7_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:518
  logic [4:0] select_2906;
  assign select_2906 = and_532_s7_q ? (equal_2394_s7_q ? select_2897 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:204
  logic [8:0] select_3817;
  assign select_3817 = so_s7_q ? (and_2767_s7_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3819;
  assign sum_3819 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3820;
  assign select_3820 = sum_1956[5] ? {1'b1, sum_1956[4:0], region_across_rest_q[2:0]} : sum_3819;
  // hls/stages/agreement.hpp:458
  logic [8:0] select_3822;
  assign select_3822 = equal_2394_s7_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3825;
  assign select_3825 = equal_2394_s7_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1363; read in stage 7, written in stage 22: 7 < 22 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 33'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_620_s7_q;
  logic [32:0] fresh_rdata_q;
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
      registration_slope_row_q <= select_2763;
      registration_slope_change_q <= select_2766;
      registration_slope_q <= so_s7_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2874;
      patches_band_rows_number_q <= select_2876;
      patches_next_band_rows_to_next_q <= select_2879;
      patches_next_band_number_q <= select_2881;
      patches_first_band_rows_to_next_q <= select_2885;
      patches_first_band_number_q <= select_2886;
      patches_choosing_number_q <= and_532_s7_q ? select_2899 : patches_choosing_number_q;
      patches_chooses_q <= and_532_s7_q ? select_2903 : patches_chooses_q;
      patches_choosing_band_q <= select_2906;
      region_across_rest_q <= select_3817;
      region_across_back_q <= so_s7_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3820;
      columns_begin_rest_q <= and_532_s7_q ? select_3822 : columns_begin_rest_q;
      columns_begin_back_q <= and_532_s7_q ? select_3825 : columns_begin_back_q;
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
  logic [3:0] select_493_s8_q;
  logic equal_494_s8_q;
  logic [6:0] select_496_s8_q;
  logic [8:0] select_500_s8_q;
  logic and_506_s8_q;
  logic equal_512_s8_q;
  logic [6:0] column_s8_q;
  logic and_530_s8_q;
  logic and_532_s8_q;
  logic [6:0] row_s8_q;
  logic so_s8_q;
  logic equal_608_s8_q;
  logic or_609_s8_q;
  logic equal_611_s8_q;
  logic less_616_s8_q;
  logic not_617_s8_q;
  logic and_620_s8_q;
  logic equal_671_s8_q;
  logic [84:0] left_rdata_s8_q;
  logic [96:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_721_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic and_1526_s8_q;
  logic [6:0] right_s8_q;
  logic equal_1534_s8_q;
  logic and_1653_s8_q;
  logic not_1657_s8_q;
  logic or_1663_s8_q;
  logic [16:0] select_1731_s8_q;
  logic sum_1956_s8_q;
  logic equal_2394_s8_q;
  logic not_2933_s8_q;
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
      select_493_s8_q <= select_493_s7_q;
      equal_494_s8_q <= equal_494_s7_q;
      select_496_s8_q <= select_496_s7_q;
      select_500_s8_q <= select_500_s7_q;
      and_506_s8_q <= and_506_s7_q;
      equal_512_s8_q <= equal_512_s7_q;
      column_s8_q <= column_s7_q;
      and_530_s8_q <= and_530_s7_q;
      and_532_s8_q <= and_532_s7_q;
      row_s8_q <= row_s7_q;
      so_s8_q <= so_s7_q;
      equal_608_s8_q <= equal_608_s7_q;
      or_609_s8_q <= or_609_s7_q;
      equal_611_s8_q <= equal_611_s7_q;
      less_616_s8_q <= less_616_s7_q;
      not_617_s8_q <= not_617_s7_q;
      and_620_s8_q <= and_620_s7_q;
      equal_671_s8_q <= equal_671_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_721_s8_q <= select_721_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      and_1526_s8_q <= and_1526_s7_q;
      right_s8_q <= right_s7_q;
      equal_1534_s8_q <= equal_1534_s7_q;
      and_1653_s8_q <= and_1653_s7_q;
      not_1657_s8_q <= not_1657;
      or_1663_s8_q <= (~equal_1659_s7_q) | (~equal_1661);
      select_1731_s8_q <= select_1731;
      sum_1956_s8_q <= sum_1956[5];
      equal_2394_s8_q <= equal_2394_s7_q;
      not_2933_s8_q <= not_2933_s7_q;
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
  // hls/stages/agreement.hpp:666
  logic not_699;
  assign not_699 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:219
  logic and_727;
  assign and_727 = left_rdata_s8_q[48] & not_617_s8_q;
  logic and_728;
  assign and_728 = right_codes_rdata_s8_q[42] & not_617_s8_q;
  logic [11:0] select_729;
  assign select_729 = less_616_s8_q ? 12'h0 : right_codes_rdata_s8_q[41:30];
  logic [11:0] select_730;
  assign select_730 = less_616_s8_q ? 12'h0 : left_rdata_s8_q[47:36];
  // hls/stages/agreement.hpp:683
  logic [11:0] select_734;
  assign select_734 = and_727 ? (and_728 ? (~(select_729 ^ select_730)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:219
  logic and_750;
  assign and_750 = left_rdata_s8_q[66] & not_617_s8_q;
  logic and_751;
  assign and_751 = right_codes_rdata_s8_q[57] & not_617_s8_q;
  logic [11:0] select_752;
  assign select_752 = less_616_s8_q ? 12'h0 : right_codes_rdata_s8_q[56:45];
  logic [11:0] select_753;
  assign select_753 = less_616_s8_q ? 12'h0 : left_rdata_s8_q[65:54];
  // hls/stages/agreement.hpp:683
  logic [11:0] select_757;
  assign select_757 = and_750 ? (and_751 ? (~(select_752 ^ select_753)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:219
  logic and_767;
  assign and_767 = left_rdata_s8_q[84] & not_617_s8_q;
  logic and_768;
  assign and_768 = right_codes_rdata_s8_q[70] & not_617_s8_q;
  logic [11:0] select_769;
  assign select_769 = less_616_s8_q ? 12'h0 : right_codes_rdata_s8_q[69:58];
  logic [11:0] select_770;
  assign select_770 = less_616_s8_q ? 12'h0 : left_rdata_s8_q[83:72];
  // hls/stages/agreement.hpp:683
  logic [11:0] select_774;
  assign select_774 = and_767 ? (and_768 ? (~(select_769 ^ select_770)) : 12'h0) : 12'h0;
  logic [11:0] select_982;
  assign select_982 = (slot_s8_q[0] ? and_768 : and_751) ? (~(select_730 ^ (slot_s8_q[0] ? select_769 : select_752))) : 12'h0;
  // hls/stages/agreement.hpp:219
  logic and_999;
  assign and_999 = right_codes_rdata_s8_q[83] & not_617_s8_q;
  logic [11:0] select_1001;
  assign select_1001 = less_616_s8_q ? 12'h0 : right_codes_rdata_s8_q[82:71];
  // hls/stages/agreement.hpp:683
  logic [11:0] select_1005;
  assign select_1005 = (slot_s8_q[0] ? and_999 : and_768) ? (~(select_753 ^ (slot_s8_q[0] ? select_1001 : select_769))) : 12'h0;
  // hls/stages/agreement.hpp:733
  logic select_1017;
  assign select_1017 = slot_s8_q[0] ? (right_codes_rdata_s8_q[96] & not_617_s8_q) : and_999;
  logic [11:0] select_1019;
  assign select_1019 = slot_s8_q[0] ? (less_616_s8_q ? 12'h0 : right_codes_rdata_s8_q[95:84]) : select_1001;
  // hls/stages/agreement.hpp:219
  logic and_1228;
  assign and_1228 = right_codes_rdata_s8_q[27] & not_617_s8_q;
  // hls/stages/agreement.hpp:733
  logic select_1229;
  assign select_1229 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_617_s8_q) : and_1228;
  // hls/stages/agreement.hpp:219
  logic [11:0] select_1231;
  assign select_1231 = less_616_s8_q ? 12'h0 : right_codes_rdata_s8_q[26:15];
  // hls/stages/agreement.hpp:733
  logic [11:0] select_1232;
  assign select_1232 = slot_s8_q[0] ? (less_616_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1231;
  // hls/stages/agreement.hpp:683
  logic [11:0] select_1256;
  assign select_1256 = (slot_s8_q[0] ? and_1228 : and_728) ? (~(select_753 ^ (slot_s8_q[0] ? select_1231 : select_729))) : 12'h0;
  logic [11:0] select_1271;
  assign select_1271 = (slot_s8_q[0] ? and_728 : and_751) ? (~(select_770 ^ (slot_s8_q[0] ? select_729 : select_752))) : 12'h0;
  // hls/stages/agreement.hpp:965
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:972
  logic and_1560;
  assign and_1560 = (or_609_s8_q & (left_rdata_s8_q[67] & not_617_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/patches.hpp:391
  logic not_1654;
  assign not_1654 = ~patches_begins_q;
  // hls/stages/patches.hpp:361
  logic and_1658;
  assign and_1658 = patches_capturing_q & not_1657_s8_q;
  // hls/stages/patches.hpp:125
  logic and_1666;
  assign and_1666 = (not_1654 & (patches_work_q == 3'h0)) & (~(and_1658 | or_1663_s8_q));
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s8_q[6:1]} < x_s8_q;
  // hls/stages/agreement.hpp:148
  logic [5:0] b;
  assign b = or_609_s8_q ? (less_616_s8_q ? 6'h0 : best_left_rdata_s8_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1733;
  assign select_1733 = ($signed(10'h0) < $signed(select_1731_s8_q[16:7])) ? 14'h7f : select_1731_s8_q[13:0];
  // hls/stages/patches.hpp:529
  logic equal_1763;
  assign equal_1763 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:500
  logic equal_1765;
  assign equal_1765 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:494
  logic equal_1767;
  assign equal_1767 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1768;
  assign equal_1768 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_1769;
  assign or_1769 = equal_1767 | equal_1768;
  // hls/stages/patches.hpp:455
  logic not_1770;
  assign not_1770 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_1792;
  assign select_1792 = and_1666 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1793;
  assign select_1793 = and_1653_s8_q ? select_1792 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1795;
  assign and_1795 = and_1658 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1799;
  assign select_1799 = and_1653_s8_q ? (and_1666 | (and_1658 & (~and_1795))) : patches_capturing_q;
  // hls/stages/patches.hpp:167
  logic not_1824;
  assign not_1824 = ~equal_1768;
  // hls/stages/agreement.hpp:271
  logic [3:0] select_1838;
  assign select_1838 = and_1653_s8_q ? {select_1792[4], select_1792[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:541
  logic less_1924;
  assign less_1924 = patches_step_q[4:0] < 5'h11;
  logic equal_1925;
  assign equal_1925 = patches_step_q[6:5] == 2'h0;
  logic not_1926;
  assign not_1926 = ~equal_1925;
  logic equal_1927;
  assign equal_1927 = patches_step_q[6:5] == 2'h3;
  logic not_1928;
  assign not_1928 = ~equal_1927;
  // hls/stages/patches.hpp:555
  logic select_1931;
  assign select_1931 = equal_1927 ? (less_1924 & (less_1924 & not_1928)) : less_1924;
  // hls/stages/agreement.hpp:458
  logic select_2491;
  assign select_2491 = equal_2394_s8_q ? (~({row_s8_q, 1'b0} < {sum_2488, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:148
  logic and_2626;
  assign and_2626 = not_617_s8_q & (or_609_s8_q & (left_rdata_s8_q[71] & not_617_s8_q));
  logic and_2630;
  assign and_2630 = not_617_s8_q & (or_609_s8_q & (left_rdata_s8_q[70] & not_617_s8_q));
  logic [7:0] select_2657;
  assign select_2657 = or_609_s8_q ? (less_616_s8_q ? 8'h0 : best_left_rdata_s8_q[32:25]) : 8'h0;
  logic [7:0] select_2659;
  assign select_2659 = or_609_s8_q ? (less_616_s8_q ? 8'h0 : best_left_rdata_s8_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:91
  logic parity_2910;
  assign parity_2910 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:458
  logic [15:0] select_2911;
  assign select_2911 = equal_2394_s8_q ? {patches_chance_q[14:0], parity_2910} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s8_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:392
  logic or_2974;
  assign or_2974 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_2980;
  assign and_2980 = equal_1763 & not_1770;
  // hls/stages/patches.hpp:398
  logic and_2981;
  assign and_2981 = not_1824 & and_2980;
  logic [1:0] select_2983;
  assign select_2983 = equal_1765 ? 2'h0 : (equal_1767 ? 2'h3 : {equal_1768, and_2981});
  // hls/stages/patches.hpp:279
  logic equal_2985;
  assign equal_2985 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_2986;
  assign not_2986 = ~equal_2985;
  // hls/stages/patches.hpp:279
  logic equal_2987;
  assign equal_2987 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_2988;
  assign not_2988 = ~equal_2987;
  // hls/stages/patches.hpp:283
  logic not_2990;
  assign not_2990 = ~(patches_following_q == 3'h2);
  logic and_2993;
  assign and_2993 = (~(patches_following_q == 3'h1)) & not_2990;
  // hls/stages/patches.hpp:396
  logic [1:0] select_2994;
  assign select_2994 = equal_2987 ? 2'h2 : {and_2993, not_2990};
  logic [3:0] select_2995;
  assign select_2995 = equal_2985 ? 4'h2 : {select_2994, {2{not_2988}}};
  // hls/stages/patches.hpp:404
  logic not_2998;
  assign not_2998 = ~or_2974;
  // hls/stages/patches.hpp:393
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:405
  logic [11:0] select_3003;
  assign select_3003 = or_2974 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

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
      row_q <= and_532_s8_q ? (equal_2394_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_532_s8_q ? select_2491 : lower_half_q;
      patches_chance_q <= and_532_s8_q ? select_2911 : patches_chance_q;
      patches_capturing_q <= sample_pair_whole_s8_q ? select_1799 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s8_q ? select_1793 : patches_row_q;
      patches_work_q <= or_2974 ? following : patches_work_q;
      patches_second_q <= not_1654 & (patches_second_q | (patches_ends_q & equal_1763));
      patches_following_q <= equal_1763 ? {2'h0, and_2980} : {equal_1765, select_2983};
      patches_following_beats_q <= {select_2995, not_2986};
      patches_begins_q <= sample_pair_whole_s8_q & (and_1653_s8_q & and_1795);
      patches_ends_q <= not_2998 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3003;
      patches_step_q <= or_2974 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic [3:0] select_493_s9_q;
  logic equal_494_s9_q;
  logic [6:0] select_496_s9_q;
  logic [8:0] select_500_s9_q;
  logic and_506_s9_q;
  logic equal_512_s9_q;
  logic [6:0] column_s9_q;
  logic and_530_s9_q;
  logic and_532_s9_q;
  logic equal_554_s9_q;
  logic equal_563_s9_q;
  logic so_s9_q;
  logic equal_608_s9_q;
  logic or_609_s9_q;
  logic equal_611_s9_q;
  logic less_616_s9_q;
  logic not_617_s9_q;
  logic and_620_s9_q;
  logic [32:0] fresh_rdata_s9_q;
  logic equal_671_s9_q;
  logic [62:0] left_rdata_s9_q;
  logic and_700_s9_q;
  logic and_701_s9_q;
  logic and_702_s9_q;
  logic and_703_s9_q;
  logic [77:0] right_codes_rdata_s9_q;
  logic and_707_s9_q;
  logic and_708_s9_q;
  logic and_709_s9_q;
  logic and_710_s9_q;
  logic and_711_s9_q;
  logic and_712_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_721_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic and_727_s9_q;
  logic [11:0] select_734_s9_q;
  logic and_750_s9_q;
  logic [11:0] select_757_s9_q;
  logic and_767_s9_q;
  logic [11:0] select_774_s9_q;
  logic [11:0] select_982_s9_q;
  logic [11:0] select_1005_s9_q;
  logic [11:0] select_1022_s9_q;
  logic [11:0] select_1235_s9_q;
  logic [11:0] select_1256_s9_q;
  logic [11:0] select_1271_s9_q;
  logic and_1526_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic equal_1534_s9_q;
  logic and_1561_s9_q;
  logic and_1653_s9_q;
  logic and_1666_s9_q;
  logic right_3_s9_q;
  logic less_1680_s9_q;
  logic [5:0] b_s9_q;
  logic [13:0] select_1733_s9_q;
  logic equal_1763_s9_q;
  logic equal_1765_s9_q;
  logic equal_1767_s9_q;
  logic equal_1768_s9_q;
  logic or_1769_s9_q;
  logic and_1772_s9_q;
  logic [4:0] select_1793_s9_q;
  logic select_1799_s9_q;
  logic and_1805_s9_q;
  logic and_1825_s9_q;
  logic [3:0] select_1838_s9_q;
  logic less_1924_s9_q;
  logic equal_1925_s9_q;
  logic not_1926_s9_q;
  logic equal_1927_s9_q;
  logic not_1928_s9_q;
  logic select_1931_s9_q;
  logic and_1932_s9_q;
  logic sum_1956_s9_q;
  logic and_1977_s9_q;
  logic and_2094_s9_q;
  logic equal_2394_s9_q;
  logic and_2520_s9_q;
  logic and_2627_s9_q;
  logic and_2631_s9_q;
  logic [7:0] select_2657_s9_q;
  logic [7:0] select_2659_s9_q;
  logic [5:0] further_s9_q;
  logic not_2933_s9_q;
  logic or_2974_s9_q;
  logic not_2998_s9_q;
  logic and_3470_s9_q;
  logic equal_3477_s9_q;
  logic less_3805_s9_q;
  logic equal_4023_s9_q;
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
      select_493_s9_q <= select_493_s8_q;
      equal_494_s9_q <= equal_494_s8_q;
      select_496_s9_q <= select_496_s8_q;
      select_500_s9_q <= select_500_s8_q;
      and_506_s9_q <= and_506_s8_q;
      equal_512_s9_q <= equal_512_s8_q;
      column_s9_q <= column_s8_q;
      and_530_s9_q <= and_530_s8_q;
      and_532_s9_q <= and_532_s8_q;
      equal_554_s9_q <= (column_s8_q | row_s8_q) == 7'h0;
      equal_563_s9_q <= row_s8_q == 7'h0;
      so_s9_q <= so_s8_q;
      equal_608_s9_q <= equal_608_s8_q;
      or_609_s9_q <= or_609_s8_q;
      equal_611_s9_q <= equal_611_s8_q;
      less_616_s9_q <= less_616_s8_q;
      not_617_s9_q <= not_617_s8_q;
      and_620_s9_q <= and_620_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_671_s9_q <= equal_671_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[65:49], left_rdata_s8_q[47:31], left_rdata_s8_q[29:13], left_rdata_s8_q[11:0]};
      and_700_s9_q <= left_rdata_s8_q[12] & not_699;
      and_701_s9_q <= left_rdata_s8_q[30] & not_699;
      and_702_s9_q <= left_rdata_s8_q[48] & not_699;
      and_703_s9_q <= left_rdata_s8_q[66] & not_699;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[82:71], right_codes_rdata_s8_q[69:58], right_codes_rdata_s8_q[56:43], right_codes_rdata_s8_q[41:28], right_codes_rdata_s8_q[26:13], right_codes_rdata_s8_q[11:0]};
      and_707_s9_q <= right_codes_rdata_s8_q[12] & not_699;
      and_708_s9_q <= right_codes_rdata_s8_q[27] & not_699;
      and_709_s9_q <= right_codes_rdata_s8_q[42] & not_699;
      and_710_s9_q <= right_codes_rdata_s8_q[57] & not_699;
      and_711_s9_q <= right_codes_rdata_s8_q[70] & not_699;
      and_712_s9_q <= right_codes_rdata_s8_q[83] & not_699;
      x_s9_2_q <= x_s8_2_q;
      select_721_s9_q <= select_721_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      and_727_s9_q <= and_727;
      select_734_s9_q <= select_734;
      and_750_s9_q <= and_750;
      select_757_s9_q <= select_757;
      and_767_s9_q <= and_767;
      select_774_s9_q <= select_774;
      select_982_s9_q <= select_982;
      select_1005_s9_q <= select_1005;
      select_1022_s9_q <= select_1017 ? (~(select_770 ^ select_1019)) : 12'h0;
      select_1235_s9_q <= select_1229 ? (~(select_730 ^ select_1232)) : 12'h0;
      select_1256_s9_q <= select_1256;
      select_1271_s9_q <= select_1271;
      and_1526_s9_q <= and_1526_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      equal_1534_s9_q <= equal_1534_s8_q;
      and_1561_s9_q <= (or_609_s8_q & (left_rdata_s8_q[68] & not_617_s8_q)) & and_1560;
      and_1653_s9_q <= and_1653_s8_q;
      and_1666_s9_q <= and_1666;
      right_3_s9_q <= right_3;
      less_1680_s9_q <= 6'h4 < row_q[6:1];
      b_s9_q <= b;
      select_1733_s9_q <= select_1733;
      equal_1763_s9_q <= equal_1763;
      equal_1765_s9_q <= equal_1765;
      equal_1767_s9_q <= equal_1767;
      equal_1768_s9_q <= equal_1768;
      or_1769_s9_q <= or_1769;
      and_1772_s9_q <= or_1769 & (equal_1768 & not_1770);
      select_1793_s9_q <= select_1793;
      select_1799_s9_q <= select_1799;
      and_1805_s9_q <= or_1769 & (patches_second_q & equal_1768);
      and_1825_s9_q <= not_1824 & or_1769;
      select_1838_s9_q <= select_1838;
      less_1924_s9_q <= less_1924;
      equal_1925_s9_q <= equal_1925;
      not_1926_s9_q <= not_1926;
      equal_1927_s9_q <= equal_1927;
      not_1928_s9_q <= not_1928;
      select_1931_s9_q <= select_1931;
      and_1932_s9_q <= not_1926 & select_1931;
      sum_1956_s9_q <= sum_1956_s8_q;
      and_1977_s9_q <= or_609_s8_q & (left_rdata_s8_q[69] & not_617_s8_q);
      and_2094_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2394_s9_q <= equal_2394_s8_q;
      and_2520_s9_q <= not_617_s8_q & and_1560;
      and_2627_s9_q <= or_609_s8_q & and_2626;
      and_2631_s9_q <= or_609_s8_q & and_2630;
      select_2657_s9_q <= select_2657;
      select_2659_s9_q <= select_2659;
      further_s9_q <= further;
      not_2933_s9_q <= not_2933_s8_q;
      or_2974_s9_q <= or_2974;
      not_2998_s9_q <= not_2998;
      and_3470_s9_q <= less_1924 & (patches_step_q[6:5] == 2'h1);
      equal_3477_s9_q <= patches_step_q[6:5] == 2'h2;
      less_3805_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_4023_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/count_bits.hpp:24
  logic parity_740;
  assign parity_740 = ^select_734_s9_q[5:3];
  logic parity_743;
  assign parity_743 = ^select_734_s9_q[8:6];
  logic parity_746;
  assign parity_746 = ^select_734_s9_q[11:3];
  logic parity_760;
  assign parity_760 = ^select_757_s9_q[8:6];
  logic parity_763;
  assign parity_763 = ^select_757_s9_q[11:9];
  logic parity_780;
  assign parity_780 = ^select_774_s9_q[2:0];
  logic parity_783;
  assign parity_783 = ^select_774_s9_q[5:3];
  logic parity_786;
  assign parity_786 = ^select_774_s9_q[8:0];
  logic parity_792;
  assign parity_792 = ^select_774_s9_q[11:9];
  logic parity_795;
  assign parity_795 = ^select_757_s9_q[2:0];
  logic parity_798;
  assign parity_798 = ^{select_774_s9_q[11:9], select_757_s9_q[5:0]};
  logic parity_801;
  assign parity_801 = ^{select_774_s9_q, select_757_s9_q, select_734_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_806;
  assign or_806 = (select_734_s9_q[1:0] == 2'h3) | (select_734_s9_q[2] & (select_734_s9_q[0] | select_734_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_810;
  assign or_810 = (select_757_s9_q[7:6] == 2'h3) | (select_757_s9_q[8] & (select_757_s9_q[6] | select_757_s9_q[7]));
  logic or_814;
  assign or_814 = (select_757_s9_q[10:9] == 2'h3) | (select_757_s9_q[11] & (select_757_s9_q[9] | select_757_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_822;
  assign or_822 = (select_774_s9_q[7:6] == 2'h3) | (select_774_s9_q[8] & (~(select_774_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_826;
  assign or_826 = (select_774_s9_q[1:0] == 2'h3) | (select_774_s9_q[2] & (select_774_s9_q[0] | select_774_s9_q[1]));
  logic or_830;
  assign or_830 = (select_774_s9_q[4:3] == 2'h3) | (select_774_s9_q[5] & (select_774_s9_q[3] | select_774_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_833;
  assign parity_833 = ^{or_830, or_826, or_822};
  // hls/stages/count_bits.hpp:23
  logic or_837;
  assign or_837 = (select_757_s9_q[4:3] == 2'h3) | (select_757_s9_q[5] & (select_757_s9_q[3] | select_757_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_841;
  assign or_841 = (select_774_s9_q[10:9] == 2'h3) | (select_774_s9_q[11] & (select_774_s9_q[9] | select_774_s9_q[10]));
  logic or_845;
  assign or_845 = (select_757_s9_q[1:0] == 2'h3) | (select_757_s9_q[2] & (select_757_s9_q[0] | select_757_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_848;
  assign parity_848 = ^{or_845, or_841, or_837};
  logic parity_851;
  assign parity_851 = ^{or_845, or_841, or_837, or_830, or_826, or_822, or_814, or_810, or_806};
  // hls/stages/count_bits.hpp:25
  logic or_856;
  assign or_856 = (parity_740 & parity_743) | ((^select_734_s9_q[11:9]) & (parity_740 | parity_743));
  logic and_859;
  assign and_859 = (^{select_757_s9_q[11:6], select_734_s9_q[2:0]}) & (parity_786 | parity_798);
  // hls/stages/count_bits.hpp:23
  logic or_867;
  assign or_867 = (select_734_s9_q[10:9] == 2'h3) | (select_734_s9_q[11] & (select_734_s9_q[9] | select_734_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_871;
  assign or_871 = (select_734_s9_q[4:3] == 2'h3) | (select_734_s9_q[5] & (select_734_s9_q[3] | select_734_s9_q[4]));
  logic or_875;
  assign or_875 = (select_734_s9_q[7:6] == 2'h3) | (select_734_s9_q[8] & (select_734_s9_q[6] | select_734_s9_q[7]));
  logic or_882;
  assign or_882 = (parity_760 & parity_763) | ((^select_734_s9_q[2:0]) & (parity_760 | parity_763));
  logic or_886;
  assign or_886 = (parity_780 & parity_783) | ((^select_774_s9_q[8:6]) & (parity_780 | parity_783));
  logic or_890;
  assign or_890 = (parity_792 & parity_795) | ((^select_757_s9_q[5:3]) & (parity_792 | parity_795));
  // hls/stages/agreement.hpp:683
  logic [11:0] select_983;
  assign select_983 = and_727_s9_q ? select_982_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_989;
  assign parity_989 = ^select_983[5:3];
  logic parity_992;
  assign parity_992 = ^select_983[8:6];
  logic parity_995;
  assign parity_995 = ^select_983[11:3];
  // hls/stages/agreement.hpp:683
  logic [11:0] select_1006;
  assign select_1006 = and_750_s9_q ? select_1005_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1009;
  assign parity_1009 = ^select_1006[8:6];
  logic parity_1012;
  assign parity_1012 = ^select_1006[11:9];
  // hls/stages/agreement.hpp:683
  logic [11:0] select_1023;
  assign select_1023 = and_767_s9_q ? select_1022_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1029;
  assign parity_1029 = ^select_1023[2:0];
  logic parity_1032;
  assign parity_1032 = ^select_1023[5:3];
  logic parity_1035;
  assign parity_1035 = ^select_1023[8:0];
  logic parity_1041;
  assign parity_1041 = ^select_1023[11:9];
  logic parity_1044;
  assign parity_1044 = ^select_1006[2:0];
  logic parity_1047;
  assign parity_1047 = ^{select_1023[11:9], select_1006[5:0]};
  logic parity_1050;
  assign parity_1050 = ^{select_1023, select_1006, select_983[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1055;
  assign or_1055 = (select_983[1:0] == 2'h3) | (select_983[2] & (select_983[0] | select_983[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1059;
  assign or_1059 = (select_1006[7:6] == 2'h3) | (select_1006[8] & (select_1006[6] | select_1006[7]));
  logic or_1063;
  assign or_1063 = (select_1006[10:9] == 2'h3) | (select_1006[11] & (select_1006[9] | select_1006[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1071;
  assign or_1071 = (select_1023[7:6] == 2'h3) | (select_1023[8] & (~(select_1023[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1075;
  assign or_1075 = (select_1023[1:0] == 2'h3) | (select_1023[2] & (select_1023[0] | select_1023[1]));
  logic or_1079;
  assign or_1079 = (select_1023[4:3] == 2'h3) | (select_1023[5] & (select_1023[3] | select_1023[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1082;
  assign parity_1082 = ^{or_1079, or_1075, or_1071};
  // hls/stages/count_bits.hpp:23
  logic or_1086;
  assign or_1086 = (select_1006[4:3] == 2'h3) | (select_1006[5] & (select_1006[3] | select_1006[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1090;
  assign or_1090 = (select_1023[10:9] == 2'h3) | (select_1023[11] & (select_1023[9] | select_1023[10]));
  logic or_1094;
  assign or_1094 = (select_1006[1:0] == 2'h3) | (select_1006[2] & (select_1006[0] | select_1006[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1097;
  assign parity_1097 = ^{or_1094, or_1090, or_1086};
  logic parity_1100;
  assign parity_1100 = ^{or_1094, or_1090, or_1086, or_1079, or_1075, or_1071, or_1063, or_1059, or_1055};
  // hls/stages/count_bits.hpp:25
  logic or_1105;
  assign or_1105 = (parity_989 & parity_992) | ((^select_983[11:9]) & (parity_989 | parity_992));
  logic and_1108;
  assign and_1108 = (^{select_1006[11:6], select_983[2:0]}) & (parity_1035 | parity_1047);
  // hls/stages/count_bits.hpp:23
  logic or_1116;
  assign or_1116 = (select_983[10:9] == 2'h3) | (select_983[11] & (select_983[9] | select_983[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1120;
  assign or_1120 = (select_983[4:3] == 2'h3) | (select_983[5] & (select_983[3] | select_983[4]));
  logic or_1124;
  assign or_1124 = (select_983[7:6] == 2'h3) | (select_983[8] & (select_983[6] | select_983[7]));
  logic or_1131;
  assign or_1131 = (parity_1009 & parity_1012) | ((^select_983[2:0]) & (parity_1009 | parity_1012));
  logic or_1135;
  assign or_1135 = (parity_1029 & parity_1032) | ((^select_1023[8:6]) & (parity_1029 | parity_1032));
  logic or_1139;
  assign or_1139 = (parity_1041 & parity_1044) | ((^select_1006[5:3]) & (parity_1041 | parity_1044));
  // hls/stages/agreement.hpp:683
  logic [11:0] select_1236;
  assign select_1236 = and_727_s9_q ? select_1235_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1242;
  assign parity_1242 = ^select_1236[5:3];
  logic parity_1245;
  assign parity_1245 = ^select_1236[8:6];
  logic parity_1248;
  assign parity_1248 = ^select_1236[11:3];
  // hls/stages/agreement.hpp:683
  logic [11:0] select_1257;
  assign select_1257 = and_750_s9_q ? select_1256_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1260;
  assign parity_1260 = ^select_1257[8:6];
  logic parity_1263;
  assign parity_1263 = ^select_1257[11:9];
  // hls/stages/agreement.hpp:683
  logic [11:0] select_1272;
  assign select_1272 = and_767_s9_q ? select_1271_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1278;
  assign parity_1278 = ^select_1272[2:0];
  logic parity_1281;
  assign parity_1281 = ^select_1272[5:3];
  logic parity_1284;
  assign parity_1284 = ^select_1272[8:0];
  logic parity_1290;
  assign parity_1290 = ^select_1272[11:9];
  logic parity_1293;
  assign parity_1293 = ^select_1257[2:0];
  logic parity_1296;
  assign parity_1296 = ^{select_1272[11:9], select_1257[5:0]};
  logic parity_1299;
  assign parity_1299 = ^{select_1272, select_1257, select_1236[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1304;
  assign or_1304 = (select_1236[1:0] == 2'h3) | (select_1236[2] & (select_1236[0] | select_1236[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1308;
  assign or_1308 = (select_1257[7:6] == 2'h3) | (select_1257[8] & (select_1257[6] | select_1257[7]));
  logic or_1312;
  assign or_1312 = (select_1257[10:9] == 2'h3) | (select_1257[11] & (select_1257[9] | select_1257[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1320;
  assign or_1320 = (select_1272[7:6] == 2'h3) | (select_1272[8] & (~(select_1272[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1324;
  assign or_1324 = (select_1272[1:0] == 2'h3) | (select_1272[2] & (select_1272[0] | select_1272[1]));
  logic or_1328;
  assign or_1328 = (select_1272[4:3] == 2'h3) | (select_1272[5] & (select_1272[3] | select_1272[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1331;
  assign parity_1331 = ^{or_1328, or_1324, or_1320};
  // hls/stages/count_bits.hpp:23
  logic or_1335;
  assign or_1335 = (select_1257[4:3] == 2'h3) | (select_1257[5] & (select_1257[3] | select_1257[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1339;
  assign or_1339 = (select_1272[10:9] == 2'h3) | (select_1272[11] & (select_1272[9] | select_1272[10]));
  logic or_1343;
  assign or_1343 = (select_1257[1:0] == 2'h3) | (select_1257[2] & (select_1257[0] | select_1257[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1346;
  assign parity_1346 = ^{or_1343, or_1339, or_1335};
  logic parity_1349;
  assign parity_1349 = ^{or_1343, or_1339, or_1335, or_1328, or_1324, or_1320, or_1312, or_1308, or_1304};
  // hls/stages/count_bits.hpp:25
  logic or_1354;
  assign or_1354 = (parity_1242 & parity_1245) | ((^select_1236[11:9]) & (parity_1242 | parity_1245));
  logic and_1357;
  assign and_1357 = (^{select_1257[11:6], select_1236[2:0]}) & (parity_1284 | parity_1296);
  // hls/stages/count_bits.hpp:23
  logic or_1365;
  assign or_1365 = (select_1236[10:9] == 2'h3) | (select_1236[11] & (select_1236[9] | select_1236[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1369;
  assign or_1369 = (select_1236[4:3] == 2'h3) | (select_1236[5] & (select_1236[3] | select_1236[4]));
  logic or_1373;
  assign or_1373 = (select_1236[7:6] == 2'h3) | (select_1236[8] & (select_1236[6] | select_1236[7]));
  logic or_1380;
  assign or_1380 = (parity_1260 & parity_1263) | ((^select_1236[2:0]) & (parity_1260 | parity_1263));
  logic or_1384;
  assign or_1384 = (parity_1278 & parity_1281) | ((^select_1272[8:6]) & (parity_1278 | parity_1281));
  logic or_1388;
  assign or_1388 = (parity_1290 & parity_1293) | ((^select_1257[5:3]) & (parity_1290 | parity_1293));
  // hls/stages/agreement.hpp:966
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:242
  logic or_1574;
  assign or_1574 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));
  // hls/stages/agreement.hpp:1002
  logic [5:0] sum_1625;
  assign sum_1625 = {1'b0, last_s9_q[6:2]} + 6'h1;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1710;
  assign sum_1710 = {2'h0, x_s9_q} + {{4{b_s9_q[5]}}, b_s9_q};
  // hls/stages/registration.hpp:213
  logic [9:0] select_1734;
  assign select_1734 = b_s9_q[4] ? select_1733_s9_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1739;
  assign sum_1739 = (b_s9_q[0] ? select_1733_s9_q[13:1] : 13'h0) + (b_s9_q[1] ? select_1733_s9_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1740;
  assign select_1740 = b_s9_q[2] ? select_1733_s9_q[11:0] : 12'h0;
  // hls/stages/patches.hpp:507
  logic not_1764;
  assign not_1764 = ~equal_1763_s9_q;
  // hls/stages/patches.hpp:453
  logic not_1766;
  assign not_1766 = ~equal_1765_s9_q;
  logic and_1848;
  assign and_1848 = not_1764 & (or_1769_s9_q & not_1766);
  // hls/stages/patches.hpp:184
  logic and_1934;
  assign and_1934 = equal_1763_s9_q & (less_1924_s9_q ? and_1932_s9_q : select_1931_s9_q);
  // hls/stages/agreement.hpp:148
  logic [7:0] select_2655;
  assign select_2655 = or_609_s9_q ? (less_616_s9_q ? 8'h0 : best_left_rdata_s9_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2657_s9_q} - {1'b0, select_2659_s9_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2916;
  assign select_2916 = right_3_s9_q ? last_s9_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s9_q} + {1'b0, select_2916};
  // hls/stages/patches.hpp:126
  logic select_2935;
  assign select_2935 = and_1653_s9_q ? (and_1666_s9_q ? not_2933_s9_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:187
  logic [4:0] select_3005;
  assign select_3005 = or_2974_s9_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:555
  logic select_3473;
  assign select_3473 = equal_1927_s9_q ? (less_1924_s9_q ? (not_1928_s9_q & and_3470_s9_q) : and_3470_s9_q) : and_3470_s9_q;

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
  assign patches_right_0_re = s9_en & (not_1764 & (not_1766 & and_1772_s9_q));
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
  assign patches_right_1_re = s9_en & (not_1764 & (not_1766 & and_1805_s9_q));
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
  assign patches_columns_above_re = s9_en & and_1848;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:806; read in stage 9, written in stage 24: 9 < 24 < 9 + DISTANCE.
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
  assign patches_rows_re = s9_en & and_1934;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_620_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_703_s9_q, left_rdata_s9_q[62:46], and_702_s9_q, left_rdata_s9_q[45:29], and_701_s9_q, left_rdata_s9_q[28:12], and_700_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[30:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_620_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_712_s9_q, right_codes_rdata_s9_q[77:66], and_711_s9_q, right_codes_rdata_s9_q[65:54], and_710_s9_q, right_codes_rdata_s9_q[53:42], and_709_s9_q, right_codes_rdata_s9_q[39:26], and_708_s9_q, right_codes_rdata_s9_q[25:12], and_707_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[32:31], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
      patches_lower_q <= sample_pair_whole_s9_q ? select_2935 : patches_lower_q;
      patches_code_row_q <= select_3005;
      patches_column_q <= or_2974_s9_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2998_s9_q & (patches_column_q == 5'h1e);
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
  logic [3:0] select_493_s10_q;
  logic equal_494_s10_q;
  logic [6:0] select_496_s10_q;
  logic [8:0] select_500_s10_q;
  logic and_506_s10_q;
  logic equal_512_s10_q;
  logic [6:0] column_s10_q;
  logic and_530_s10_q;
  logic and_532_s10_q;
  logic equal_554_s10_q;
  logic equal_563_s10_q;
  logic so_s10_q;
  logic equal_608_s10_q;
  logic or_609_s10_q;
  logic equal_611_s10_q;
  logic less_616_s10_q;
  logic not_617_s10_q;
  logic and_620_s10_q;
  logic equal_671_s10_q;
  logic [1:0] right_codes_rdata_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_721_s10_q;
  logic [61:0] best_left_rdata_s10_q;
  logic xor_802_s10_q;
  logic parity_851_s10_q;
  logic and_852_s10_q;
  logic or_856_s10_q;
  logic or_860_s10_q;
  logic or_867_s10_q;
  logic or_871_s10_q;
  logic or_875_s10_q;
  logic or_882_s10_q;
  logic or_886_s10_q;
  logic or_890_s10_q;
  logic and_899_s10_q;
  logic and_901_s10_q;
  logic or_913_s10_q;
  logic or_917_s10_q;
  logic or_921_s10_q;
  logic xor_1051_s10_q;
  logic parity_1066_s10_q;
  logic parity_1100_s10_q;
  logic and_1101_s10_q;
  logic or_1105_s10_q;
  logic or_1109_s10_q;
  logic or_1116_s10_q;
  logic or_1120_s10_q;
  logic or_1124_s10_q;
  logic or_1131_s10_q;
  logic or_1135_s10_q;
  logic or_1139_s10_q;
  logic and_1148_s10_q;
  logic or_1149_s10_q;
  logic or_1162_s10_q;
  logic or_1166_s10_q;
  logic or_1170_s10_q;
  logic xor_1300_s10_q;
  logic parity_1315_s10_q;
  logic parity_1349_s10_q;
  logic and_1350_s10_q;
  logic or_1354_s10_q;
  logic or_1358_s10_q;
  logic or_1365_s10_q;
  logic or_1369_s10_q;
  logic or_1373_s10_q;
  logic or_1380_s10_q;
  logic or_1384_s10_q;
  logic or_1388_s10_q;
  logic and_1397_s10_q;
  logic or_1398_s10_q;
  logic or_1411_s10_q;
  logic or_1415_s10_q;
  logic or_1419_s10_q;
  logic and_1526_s10_q;
  logic [6:0] select_1530_s10_q;
  logic [6:0] right_s10_q;
  logic equal_1534_s10_q;
  logic and_1561_s10_q;
  logic or_1574_s10_q;
  logic less_1626_s10_q;
  logic and_1653_s10_q;
  logic and_1666_s10_q;
  logic right_3_s10_q;
  logic less_1680_s10_q;
  logic [5:0] b_s10_q;
  logic less_1701_s10_q;
  logic not_1706_s10_q;
  logic less_1711_s10_q;
  logic less_1712_s10_q;
  logic select_1734_s10_q;
  logic [8:0] difference_1736_s10_q;
  logic [11:0] sum_1739_s10_q;
  logic select_1740_s10_q;
  logic [10:0] sum_1742_s10_q;
  logic equal_1756_s10_q;
  logic equal_1763_s10_q;
  logic not_1764_s10_q;
  logic equal_1765_s10_q;
  logic not_1766_s10_q;
  logic equal_1767_s10_q;
  logic equal_1768_s10_q;
  logic or_1769_s10_q;
  logic [4:0] select_1793_s10_q;
  logic select_1799_s10_q;
  logic and_1827_s10_q;
  logic [3:0] select_1838_s10_q;
  logic and_1848_s10_q;
  logic less_1924_s10_q;
  logic equal_1925_s10_q;
  logic not_1926_s10_q;
  logic equal_1927_s10_q;
  logic not_1928_s10_q;
  logic sum_1956_s10_q;
  logic and_1977_s10_q;
  logic and_2097_s10_q;
  logic equal_2394_s10_q;
  logic and_2521_s10_q;
  logic equal_2606_s10_q;
  logic and_2627_s10_q;
  logic and_2631_s10_q;
  logic [7:0] select_2655_s10_q;
  logic rise_2_s10_q;
  logic [7:0] select_2661_s10_q;
  logic [7:0] xor_2666_s10_q;
  logic less_2692_s10_q;
  logic not_2919_s10_q;
  logic or_2974_s10_q;
  logic not_2998_s10_q;
  logic select_3475_s10_q;
  logic equal_3477_s10_q;
  logic less_3805_s10_q;
  logic equal_4023_s10_q;
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
      select_493_s10_q <= select_493_s9_q;
      equal_494_s10_q <= equal_494_s9_q;
      select_496_s10_q <= select_496_s9_q;
      select_500_s10_q <= select_500_s9_q;
      and_506_s10_q <= and_506_s9_q;
      equal_512_s10_q <= equal_512_s9_q;
      column_s10_q <= column_s9_q;
      and_530_s10_q <= and_530_s9_q;
      and_532_s10_q <= and_532_s9_q;
      equal_554_s10_q <= equal_554_s9_q;
      equal_563_s10_q <= equal_563_s9_q;
      so_s10_q <= so_s9_q;
      equal_608_s10_q <= equal_608_s9_q;
      or_609_s10_q <= or_609_s9_q;
      equal_611_s10_q <= equal_611_s9_q;
      less_616_s10_q <= less_616_s9_q;
      not_617_s10_q <= not_617_s9_q;
      and_620_s10_q <= and_620_s9_q;
      equal_671_s10_q <= equal_671_s9_q;
      right_codes_rdata_s10_q <= right_codes_rdata_s9_q[41:40];
      x_s10_2_q <= x_s9_2_q;
      select_721_s10_q <= select_721_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      xor_802_s10_q <= parity_746 ^ parity_801;
      parity_851_s10_q <= parity_851;
      and_852_s10_q <= parity_746 & parity_801;
      or_856_s10_q <= or_856;
      or_860_s10_q <= (parity_786 & parity_798) | and_859;
      or_867_s10_q <= or_867;
      or_871_s10_q <= or_871;
      or_875_s10_q <= or_875;
      or_882_s10_q <= or_882;
      or_886_s10_q <= or_886;
      or_890_s10_q <= or_890;
      and_899_s10_q <= parity_833 & parity_848;
      and_901_s10_q <= (^{or_814, or_810, or_806}) & (parity_833 | parity_848);
      or_913_s10_q <= (or_810 & or_814) | (or_806 & (or_810 | or_814));
      or_917_s10_q <= (or_826 & or_830) | (or_822 & (or_826 | or_830));
      or_921_s10_q <= (or_841 & or_845) | (or_837 & (or_841 | or_845));
      xor_1051_s10_q <= parity_995 ^ parity_1050;
      parity_1066_s10_q <= ^{or_1063, or_1059, or_1055};
      parity_1100_s10_q <= parity_1100;
      and_1101_s10_q <= parity_995 & parity_1050;
      or_1105_s10_q <= or_1105;
      or_1109_s10_q <= (parity_1035 & parity_1047) | and_1108;
      or_1116_s10_q <= or_1116;
      or_1120_s10_q <= or_1120;
      or_1124_s10_q <= or_1124;
      or_1131_s10_q <= or_1131;
      or_1135_s10_q <= or_1135;
      or_1139_s10_q <= or_1139;
      and_1148_s10_q <= parity_1082 & parity_1097;
      or_1149_s10_q <= parity_1082 | parity_1097;
      or_1162_s10_q <= (or_1059 & or_1063) | (or_1055 & (or_1059 | or_1063));
      or_1166_s10_q <= (or_1075 & or_1079) | (or_1071 & (or_1075 | or_1079));
      or_1170_s10_q <= (or_1090 & or_1094) | (or_1086 & (or_1090 | or_1094));
      xor_1300_s10_q <= parity_1248 ^ parity_1299;
      parity_1315_s10_q <= ^{or_1312, or_1308, or_1304};
      parity_1349_s10_q <= parity_1349;
      and_1350_s10_q <= parity_1248 & parity_1299;
      or_1354_s10_q <= or_1354;
      or_1358_s10_q <= (parity_1284 & parity_1296) | and_1357;
      or_1365_s10_q <= or_1365;
      or_1369_s10_q <= or_1369;
      or_1373_s10_q <= or_1373;
      or_1380_s10_q <= or_1380;
      or_1384_s10_q <= or_1384;
      or_1388_s10_q <= or_1388;
      and_1397_s10_q <= parity_1331 & parity_1346;
      or_1398_s10_q <= parity_1331 | parity_1346;
      or_1411_s10_q <= (or_1308 & or_1312) | (or_1304 & (or_1308 | or_1312));
      or_1415_s10_q <= (or_1324 & or_1328) | (or_1320 & (or_1324 | or_1328));
      or_1419_s10_q <= (or_1339 & or_1343) | (or_1335 & (or_1339 | or_1343));
      and_1526_s10_q <= and_1526_s9_q;
      select_1530_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      equal_1534_s10_q <= equal_1534_s9_q;
      and_1561_s10_q <= and_1561_s9_q;
      or_1574_s10_q <= or_1574;
      less_1626_s10_q <= {1'b0, sum_1625, last_s9_q[1]} < x_s9_q;
      and_1653_s10_q <= and_1653_s9_q;
      and_1666_s10_q <= and_1666_s9_q;
      right_3_s10_q <= right_3_s9_q;
      less_1680_s10_q <= less_1680_s9_q;
      b_s10_q <= b_s9_q;
      less_1701_s10_q <= {3'h0, last_s9_q[6:1]} < ({1'b0, x_s9_q} + 9'h1);
      not_1706_s10_q <= ~(x_s9_q < {1'b0, last_s9_q});
      less_1711_s10_q <= $signed(10'h0) < $signed(sum_1710);
      less_1712_s10_q <= $signed(sum_1710) < $signed({3'h0, last_s9_q});
      select_1734_s10_q <= select_1734[0];
      difference_1736_s10_q <= select_1734[9:1] - (b_s9_q[5] ? select_1733_s9_q[8:0] : 9'h0);
      sum_1739_s10_q <= sum_1739[12:1];
      select_1740_s10_q <= select_1740[0];
      sum_1742_s10_q <= select_1740[11:1] + (b_s9_q[3] ? select_1733_s9_q[10:0] : 11'h0);
      equal_1756_s10_q <= x_s9_q == {1'b0, last_s9_q};
      equal_1763_s10_q <= equal_1763_s9_q;
      not_1764_s10_q <= not_1764;
      equal_1765_s10_q <= equal_1765_s9_q;
      not_1766_s10_q <= not_1766;
      equal_1767_s10_q <= equal_1767_s9_q;
      equal_1768_s10_q <= equal_1768_s9_q;
      or_1769_s10_q <= or_1769_s9_q;
      select_1793_s10_q <= select_1793_s9_q;
      select_1799_s10_q <= select_1799_s9_q;
      and_1827_s10_q <= not_1764 & (not_1766 & and_1825_s9_q);
      select_1838_s10_q <= select_1838_s9_q;
      and_1848_s10_q <= and_1848;
      less_1924_s10_q <= less_1924_s9_q;
      equal_1925_s10_q <= equal_1925_s9_q;
      not_1926_s10_q <= not_1926_s9_q;
      equal_1927_s10_q <= equal_1927_s9_q;
      not_1928_s10_q <= not_1928_s9_q;
      sum_1956_s10_q <= sum_1956_s9_q;
      and_1977_s10_q <= and_1977_s9_q;
      and_2097_s10_q <= and_2094_s9_q & (~({sum_1625, last_s9_q[1:0]} < x_s9_q));
      equal_2394_s10_q <= equal_2394_s9_q;
      and_2521_s10_q <= or_609_s9_q & and_2520_s9_q;
      equal_2606_s10_q <= shift_s9_q == 6'h0;
      and_2627_s10_q <= and_2627_s9_q;
      and_2631_s10_q <= and_2631_s9_q;
      select_2655_s10_q <= select_2655;
      rise_2_s10_q <= rise_2[8];
      select_2661_s10_q <= rise_2[8] ? select_2657_s9_q : select_2659_s9_q;
      xor_2666_s10_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2692_s10_q <= select_2657_s9_q < select_2659_s9_q;
      not_2919_s10_q <= ~(x_s9_q < {1'b0, from});
      or_2974_s10_q <= or_2974_s9_q;
      not_2998_s10_q <= not_2998_s9_q;
      select_3475_s10_q <= less_1924_s9_q ? (not_1926_s9_q & select_3473) : select_3473;
      equal_3477_s10_q <= equal_3477_s9_q;
      less_3805_s10_q <= less_3805_s9_q;
      equal_4023_s10_q <= equal_4023_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/count_bits.hpp:24
  logic parity_878;
  assign parity_878 = ^{or_875_s10_q, or_871_s10_q, or_867_s10_q};
  logic parity_893;
  assign parity_893 = ^{or_890_s10_q, or_886_s10_q, or_882_s10_q};
  logic parity_896;
  assign parity_896 = ^{or_890_s10_q, or_886_s10_q, or_882_s10_q, or_875_s10_q, or_871_s10_q, or_867_s10_q, or_860_s10_q, or_856_s10_q, and_852_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_898;
  assign and_898 = parity_851_s10_q & parity_896;
  logic or_902;
  assign or_902 = and_899_s10_q | and_901_s10_q;
  logic and_905;
  assign and_905 = (^{or_860_s10_q, or_856_s10_q, and_852_s10_q}) & (parity_878 | parity_893);
  logic or_906;
  assign or_906 = (parity_878 & parity_893) | and_905;
  // hls/stages/count_bits.hpp:24
  logic parity_924;
  assign parity_924 = ^{or_921_s10_q, or_917_s10_q, or_913_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_928;
  assign or_928 = (or_856_s10_q & or_860_s10_q) | (and_852_s10_q & (or_856_s10_q | or_860_s10_q));
  logic or_932;
  assign or_932 = (or_871_s10_q & or_875_s10_q) | (or_867_s10_q & (or_871_s10_q | or_875_s10_q));
  logic or_936;
  assign or_936 = (or_886_s10_q & or_890_s10_q) | (or_882_s10_q & (or_886_s10_q | or_890_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_939;
  assign parity_939 = ^{or_936, or_932, or_928};
  logic parity_942;
  assign parity_942 = ^{or_936, or_932, or_928, or_921_s10_q, or_917_s10_q, or_913_s10_q, or_906, or_902, and_898};
  // hls/stages/count_bits.hpp:25
  logic or_954;
  assign or_954 = (or_917_s10_q & or_921_s10_q) | (or_913_s10_q & (or_917_s10_q | or_921_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1127;
  assign parity_1127 = ^{or_1124_s10_q, or_1120_s10_q, or_1116_s10_q};
  logic parity_1142;
  assign parity_1142 = ^{or_1139_s10_q, or_1135_s10_q, or_1131_s10_q};
  logic parity_1145;
  assign parity_1145 = ^{or_1139_s10_q, or_1135_s10_q, or_1131_s10_q, or_1124_s10_q, or_1120_s10_q, or_1116_s10_q, or_1109_s10_q, or_1105_s10_q, and_1101_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1147;
  assign and_1147 = parity_1100_s10_q & parity_1145;
  logic or_1151;
  assign or_1151 = and_1148_s10_q | (parity_1066_s10_q & or_1149_s10_q);
  logic and_1154;
  assign and_1154 = (^{or_1109_s10_q, or_1105_s10_q, and_1101_s10_q}) & (parity_1127 | parity_1142);
  logic or_1155;
  assign or_1155 = (parity_1127 & parity_1142) | and_1154;
  // hls/stages/count_bits.hpp:24
  logic parity_1173;
  assign parity_1173 = ^{or_1170_s10_q, or_1166_s10_q, or_1162_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1177;
  assign or_1177 = (or_1105_s10_q & or_1109_s10_q) | (and_1101_s10_q & (or_1105_s10_q | or_1109_s10_q));
  logic or_1181;
  assign or_1181 = (or_1120_s10_q & or_1124_s10_q) | (or_1116_s10_q & (or_1120_s10_q | or_1124_s10_q));
  logic or_1185;
  assign or_1185 = (or_1135_s10_q & or_1139_s10_q) | (or_1131_s10_q & (or_1135_s10_q | or_1139_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1188;
  assign parity_1188 = ^{or_1185, or_1181, or_1177};
  logic parity_1191;
  assign parity_1191 = ^{or_1185, or_1181, or_1177, or_1170_s10_q, or_1166_s10_q, or_1162_s10_q, or_1155, or_1151, and_1147};
  // hls/stages/count_bits.hpp:25
  logic or_1203;
  assign or_1203 = (or_1166_s10_q & or_1170_s10_q) | (or_1162_s10_q & (or_1166_s10_q | or_1170_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1376;
  assign parity_1376 = ^{or_1373_s10_q, or_1369_s10_q, or_1365_s10_q};
  logic parity_1391;
  assign parity_1391 = ^{or_1388_s10_q, or_1384_s10_q, or_1380_s10_q};
  logic parity_1394;
  assign parity_1394 = ^{or_1388_s10_q, or_1384_s10_q, or_1380_s10_q, or_1373_s10_q, or_1369_s10_q, or_1365_s10_q, or_1358_s10_q, or_1354_s10_q, and_1350_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1396;
  assign and_1396 = parity_1349_s10_q & parity_1394;
  logic or_1400;
  assign or_1400 = and_1397_s10_q | (parity_1315_s10_q & or_1398_s10_q);
  logic and_1403;
  assign and_1403 = (^{or_1358_s10_q, or_1354_s10_q, and_1350_s10_q}) & (parity_1376 | parity_1391);
  logic or_1404;
  assign or_1404 = (parity_1376 & parity_1391) | and_1403;
  // hls/stages/count_bits.hpp:24
  logic parity_1422;
  assign parity_1422 = ^{or_1419_s10_q, or_1415_s10_q, or_1411_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1426;
  assign or_1426 = (or_1354_s10_q & or_1358_s10_q) | (and_1350_s10_q & (or_1354_s10_q | or_1358_s10_q));
  logic or_1430;
  assign or_1430 = (or_1369_s10_q & or_1373_s10_q) | (or_1365_s10_q & (or_1369_s10_q | or_1373_s10_q));
  logic or_1434;
  assign or_1434 = (or_1384_s10_q & or_1388_s10_q) | (or_1380_s10_q & (or_1384_s10_q | or_1388_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1437;
  assign parity_1437 = ^{or_1434, or_1430, or_1426};
  logic parity_1440;
  assign parity_1440 = ^{or_1434, or_1430, or_1426, or_1419_s10_q, or_1415_s10_q, or_1411_s10_q, or_1404, or_1400, and_1396};
  // hls/stages/count_bits.hpp:25
  logic or_1452;
  assign or_1452 = (or_1415_s10_q & or_1419_s10_q) | (or_1411_s10_q & (or_1415_s10_q | or_1419_s10_q));
  // hls/stages/agreement.hpp:223
  logic inside_v;
  assign inside_v = or_609_s10_q & not_617_s10_q;
  // hls/stages/agreement.hpp:257
  logic right_2;
  assign right_2 = inside_v & less_1626_s10_q;
  // hls/stages/patches.hpp:104
  logic and_1703;
  assign and_1703 = less_1701_s10_q & (~right_3_s10_q);
  // hls/stages/patches.hpp:106
  logic equal_1704;
  assign equal_1704 = x_s10_q == 8'h0;
  // hls/stages/agreement.hpp:1011
  logic and_1714;
  assign and_1714 = (~(and_1703 | (equal_1704 | not_1706_s10_q))) & (less_1711_s10_q & less_1712_s10_q);
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1743;
  assign sum_1743 = sum_1739_s10_q + {sum_1742_s10_q, select_1740_s10_q};
  logic [9:0] sum_1744;
  assign sum_1744 = {difference_1736_s10_q, select_1734_s10_q} + sum_1743[11:2];
  // hls/stages/agreement.hpp:787
  logic and_1760;
  assign and_1760 = so_s10_q & (ends_cell_s10_q & (inside_v & (and_1703 | equal_1756_s10_q)));
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2655_s10_q} - {1'b0, select_2661_s10_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s10_q} + {1'b0, xor_2666_s10_q};

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1367; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_609_s10_q ? select_1530_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_721_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory right_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1369; read in stage 10, written in stage 11: 10 < 11 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] right_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_1530_s10_q;
  logic right_turns_re;
  assign right_turns_re = s10_en & inside_v;
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_turns_re) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
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
  assign patches_left_re = s10_en & and_1827_s10_q;
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s10_en) begin
      patches_read_searches_q <= equal_1763_s10_q ? select_3475_s10_q : patches_read_searches_q;
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
  logic [3:0] select_493_s11_q;
  logic equal_494_s11_q;
  logic [6:0] select_496_s11_q;
  logic [8:0] select_500_s11_q;
  logic and_506_s11_q;
  logic equal_512_s11_q;
  logic [6:0] column_s11_q;
  logic and_530_s11_q;
  logic and_532_s11_q;
  logic equal_554_s11_q;
  logic equal_563_s11_q;
  logic so_s11_q;
  logic equal_608_s11_q;
  logic or_609_s11_q;
  logic equal_611_s11_q;
  logic less_616_s11_q;
  logic not_617_s11_q;
  logic and_620_s11_q;
  logic equal_671_s11_q;
  logic [1:0] right_codes_rdata_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic xor_802_s11_q;
  logic xor_897_s11_q;
  logic parity_942_s11_q;
  logic and_943_s11_q;
  logic and_945_s11_q;
  logic and_947_s11_q;
  logic and_949_s11_q;
  logic or_954_s11_q;
  logic or_958_s11_q;
  logic xor_1051_s11_q;
  logic xor_1146_s11_q;
  logic parity_1191_s11_q;
  logic and_1192_s11_q;
  logic and_1194_s11_q;
  logic and_1196_s11_q;
  logic and_1198_s11_q;
  logic or_1203_s11_q;
  logic or_1207_s11_q;
  logic xor_1300_s11_q;
  logic xor_1395_s11_q;
  logic parity_1440_s11_q;
  logic and_1441_s11_q;
  logic and_1443_s11_q;
  logic and_1445_s11_q;
  logic and_1447_s11_q;
  logic or_1452_s11_q;
  logic or_1456_s11_q;
  logic and_1526_s11_q;
  logic [6:0] select_1530_s11_q;
  logic [6:0] right_s11_q;
  logic equal_1534_s11_q;
  logic inside_v_s11_q;
  logic and_1561_s11_q;
  logic or_1574_s11_q;
  logic right_2_s11_q;
  logic and_1653_s11_q;
  logic and_1666_s11_q;
  logic and_1678_s11_q;
  logic less_1680_s11_q;
  logic [5:0] b_s11_q;
  logic equal_1704_s11_q;
  logic and_1714_s11_q;
  logic [7:0] sum_1744_s11_q;
  logic equal_1756_s11_q;
  logic and_1760_s11_q;
  logic equal_1763_s11_q;
  logic not_1764_s11_q;
  logic equal_1765_s11_q;
  logic not_1766_s11_q;
  logic equal_1767_s11_q;
  logic equal_1768_s11_q;
  logic or_1769_s11_q;
  logic [7:0] patches_right_0_rdata_s11_q;
  logic [4:0] select_1793_s11_q;
  logic select_1799_s11_q;
  logic [7:0] patches_right_1_rdata_s11_q;
  logic [3:0] select_1838_s11_q;
  logic and_1848_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic less_1924_s11_q;
  logic equal_1925_s11_q;
  logic not_1926_s11_q;
  logic equal_1927_s11_q;
  logic not_1928_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_1956_s11_q;
  logic and_1977_s11_q;
  logic and_2099_s11_q;
  logic equal_2394_s11_q;
  logic and_2521_s11_q;
  logic equal_2606_s11_q;
  logic and_2627_s11_q;
  logic and_2631_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] size_3_s11_q;
  logic less_2692_s11_q;
  logic and_2922_s11_q;
  logic or_2974_s11_q;
  logic not_2998_s11_q;
  logic equal_3477_s11_q;
  logic less_3805_s11_q;
  logic equal_4023_s11_q;
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
      select_493_s11_q <= select_493_s10_q;
      equal_494_s11_q <= equal_494_s10_q;
      select_496_s11_q <= select_496_s10_q;
      select_500_s11_q <= select_500_s10_q;
      and_506_s11_q <= and_506_s10_q;
      equal_512_s11_q <= equal_512_s10_q;
      column_s11_q <= column_s10_q;
      and_530_s11_q <= and_530_s10_q;
      and_532_s11_q <= and_532_s10_q;
      equal_554_s11_q <= equal_554_s10_q;
      equal_563_s11_q <= equal_563_s10_q;
      so_s11_q <= so_s10_q;
      equal_608_s11_q <= equal_608_s10_q;
      or_609_s11_q <= or_609_s10_q;
      equal_611_s11_q <= equal_611_s10_q;
      less_616_s11_q <= less_616_s10_q;
      not_617_s11_q <= not_617_s10_q;
      and_620_s11_q <= and_620_s10_q;
      equal_671_s11_q <= equal_671_s10_q;
      right_codes_rdata_s11_q <= right_codes_rdata_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      xor_802_s11_q <= xor_802_s10_q;
      xor_897_s11_q <= parity_851_s10_q ^ parity_896;
      parity_942_s11_q <= parity_942;
      and_943_s11_q <= parity_924 & parity_939;
      and_945_s11_q <= (^{or_906, or_902, and_898}) & (parity_924 | parity_939);
      and_947_s11_q <= or_902 & or_906;
      and_949_s11_q <= and_898 & (or_902 | or_906);
      or_954_s11_q <= or_954;
      or_958_s11_q <= (or_932 & or_936) | (or_928 & (or_932 | or_936));
      xor_1051_s11_q <= xor_1051_s10_q;
      xor_1146_s11_q <= parity_1100_s10_q ^ parity_1145;
      parity_1191_s11_q <= parity_1191;
      and_1192_s11_q <= parity_1173 & parity_1188;
      and_1194_s11_q <= (^{or_1155, or_1151, and_1147}) & (parity_1173 | parity_1188);
      and_1196_s11_q <= or_1151 & or_1155;
      and_1198_s11_q <= and_1147 & (or_1151 | or_1155);
      or_1203_s11_q <= or_1203;
      or_1207_s11_q <= (or_1181 & or_1185) | (or_1177 & (or_1181 | or_1185));
      xor_1300_s11_q <= xor_1300_s10_q;
      xor_1395_s11_q <= parity_1349_s10_q ^ parity_1394;
      parity_1440_s11_q <= parity_1440;
      and_1441_s11_q <= parity_1422 & parity_1437;
      and_1443_s11_q <= (^{or_1404, or_1400, and_1396}) & (parity_1422 | parity_1437);
      and_1445_s11_q <= or_1400 & or_1404;
      and_1447_s11_q <= and_1396 & (or_1400 | or_1404);
      or_1452_s11_q <= or_1452;
      or_1456_s11_q <= (or_1430 & or_1434) | (or_1426 & (or_1430 | or_1434));
      and_1526_s11_q <= and_1526_s10_q;
      select_1530_s11_q <= select_1530_s10_q;
      right_s11_q <= right_s10_q;
      equal_1534_s11_q <= equal_1534_s10_q;
      inside_v_s11_q <= inside_v;
      and_1561_s11_q <= and_1561_s10_q;
      or_1574_s11_q <= or_1574_s10_q;
      right_2_s11_q <= right_2;
      and_1653_s11_q <= and_1653_s10_q;
      and_1666_s11_q <= and_1666_s10_q;
      and_1678_s11_q <= so_s10_q & (ends_cell_s10_q & (inside_v & right_3_s10_q));
      less_1680_s11_q <= less_1680_s10_q;
      b_s11_q <= b_s10_q;
      equal_1704_s11_q <= equal_1704;
      and_1714_s11_q <= and_1714;
      sum_1744_s11_q <= sum_1744[9:2];
      equal_1756_s11_q <= equal_1756_s10_q;
      and_1760_s11_q <= and_1760;
      equal_1763_s11_q <= equal_1763_s10_q;
      not_1764_s11_q <= not_1764_s10_q;
      equal_1765_s11_q <= equal_1765_s10_q;
      not_1766_s11_q <= not_1766_s10_q;
      equal_1767_s11_q <= equal_1767_s10_q;
      equal_1768_s11_q <= equal_1768_s10_q;
      or_1769_s11_q <= or_1769_s10_q;
      patches_right_0_rdata_s11_q <= patches_right_0_rdata_q;
      select_1793_s11_q <= select_1793_s10_q;
      select_1799_s11_q <= select_1799_s10_q;
      patches_right_1_rdata_s11_q <= patches_right_1_rdata_q;
      select_1838_s11_q <= select_1838_s10_q;
      and_1848_s11_q <= and_1848_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_q;
      less_1924_s11_q <= less_1924_s10_q;
      equal_1925_s11_q <= equal_1925_s10_q;
      not_1926_s11_q <= not_1926_s10_q;
      equal_1927_s11_q <= equal_1927_s10_q;
      not_1928_s11_q <= not_1928_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_1956_s11_q <= sum_1956_s10_q;
      and_1977_s11_q <= and_1977_s10_q;
      and_2099_s11_q <= so_s10_q & (ends_cell_s10_q & and_2097_s10_q);
      equal_2394_s11_q <= equal_2394_s10_q;
      and_2521_s11_q <= and_2521_s10_q;
      equal_2606_s11_q <= equal_2606_s10_q;
      and_2627_s11_q <= and_2627_s10_q;
      and_2631_s11_q <= and_2631_s10_q;
      wide_s11_q <= wide;
      size_3_s11_q <= size_3;
      less_2692_s11_q <= less_2692_s10_q;
      and_2922_s11_q <= so_s10_q & (ends_cell_s10_q & (inside_v & not_2919_s10_q));
      or_2974_s11_q <= or_2974_s10_q;
      not_2998_s11_q <= not_2998_s10_q;
      equal_3477_s11_q <= equal_3477_s10_q;
      less_3805_s11_q <= less_3805_s10_q;
      equal_4023_s11_q <= equal_4023_s10_q;
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
  logic or_946;
  assign or_946 = and_943_s11_q | and_945_s11_q;
  logic or_950;
  assign or_950 = and_947_s11_q | and_949_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_963;
  assign parity_963 = ^{or_958_s11_q, or_954_s11_q, or_950, or_946};
  // hls/stages/count_bits.hpp:25
  logic or_967;
  assign or_967 = (or_954_s11_q & or_958_s11_q) | (or_950 & (or_954_s11_q | or_958_s11_q));
  logic and_968;
  assign and_968 = or_946 & (^{or_958_s11_q, or_954_s11_q, or_950});
  // hls/stages/count_bits.hpp:24
  logic xor_969;
  assign xor_969 = or_967 ^ and_968;
  // hls/stages/count_bits.hpp:27
  logic and_970;
  assign and_970 = or_967 & and_968;
  // hls/stages/agreement.hpp:148
  logic [5:0] select_971;
  assign select_971 = equal_611_s11_q ? {and_970, xor_969, parity_963, parity_942_s11_q, xor_897_s11_q, xor_802_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_609_s11_q ? 6'h0 : select_971;
  // hls/stages/count_bits.hpp:25
  logic or_1195;
  assign or_1195 = and_1192_s11_q | and_1194_s11_q;
  logic or_1199;
  assign or_1199 = and_1196_s11_q | and_1198_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1212;
  assign parity_1212 = ^{or_1207_s11_q, or_1203_s11_q, or_1199, or_1195};
  // hls/stages/count_bits.hpp:25
  logic or_1216;
  assign or_1216 = (or_1203_s11_q & or_1207_s11_q) | (or_1199 & (or_1203_s11_q | or_1207_s11_q));
  logic and_1217;
  assign and_1217 = or_1195 & (^{or_1207_s11_q, or_1203_s11_q, or_1199});
  // hls/stages/count_bits.hpp:24
  logic xor_1218;
  assign xor_1218 = or_1216 ^ and_1217;
  // hls/stages/count_bits.hpp:27
  logic and_1219;
  assign and_1219 = or_1216 & and_1217;
  // hls/stages/agreement.hpp:148
  logic [5:0] select_1220;
  assign select_1220 = equal_611_s11_q ? {and_1219, xor_1218, parity_1212, parity_1191_s11_q, xor_1146_s11_q, xor_1051_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_609_s11_q ? 6'h0 : select_1220;
  // hls/stages/count_bits.hpp:25
  logic or_1444;
  assign or_1444 = and_1441_s11_q | and_1443_s11_q;
  logic or_1448;
  assign or_1448 = and_1445_s11_q | and_1447_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1461;
  assign parity_1461 = ^{or_1456_s11_q, or_1452_s11_q, or_1448, or_1444};
  // hls/stages/count_bits.hpp:25
  logic or_1465;
  assign or_1465 = (or_1452_s11_q & or_1456_s11_q) | (or_1448 & (or_1452_s11_q | or_1456_s11_q));
  logic and_1466;
  assign and_1466 = or_1444 & (^{or_1456_s11_q, or_1452_s11_q, or_1448});
  // hls/stages/count_bits.hpp:24
  logic xor_1467;
  assign xor_1467 = or_1465 ^ and_1466;
  // hls/stages/count_bits.hpp:27
  logic and_1468;
  assign and_1468 = or_1465 & and_1466;
  // hls/stages/agreement.hpp:148
  logic [5:0] select_1469;
  assign select_1469 = equal_611_s11_q ? {and_1468, xor_1467, parity_1461, parity_1440_s11_q, xor_1395_s11_q, xor_1300_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_609_s11_q ? 6'h0 : select_1469;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1505;
  assign sum_1505 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1508;
  assign sum_1508 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:148
  logic [6:0] select_1551;
  assign select_1551 = or_609_s11_q ? (less_616_s11_q ? 7'h0 : select_1530_s11_q) : 7'h0;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1745;
  assign sum_1745 = {registration_slope_s11_q[11], registration_slope_s11_q} + {{5{sum_1744_s11_q[7]}}, sum_1744_s11_q};
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1768_s11_q ? (patches_second_s11_q ? 8'h0 : patches_right_0_rdata_s11_q) : 8'h0;
  // hls/stages/patches.hpp:462
  logic [8:0] sum_1886;
  assign sum_1886 = {1'b0, patches_columns_above_rdata_s11_q[23:16]} + {3'h0, patches_columns_above_rdata_s11_q[31:26]};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2669;
  assign select_2669 = ({wide_s11_q, 1'b0} < size_3_s11_q) ? {wide_s11_q, 1'b0} : size_3_s11_q;
  logic [8:0] taken;
  assign taken = ~select_2669;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3440;
  assign select_3440 = less_1924_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3442;
  assign select_3442 = less_1924_s11_q ? (equal_1927_s11_q ? 10'h0 : select_3440) : 10'h0;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3447;
  assign select_3447 = less_1924_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3450;
  assign select_3450 = equal_1927_s11_q ? (less_1924_s11_q ? (equal_1927_s11_q ? 5'h0 : select_3447) : 5'h0) : select_3447;

  // Memory right_turns, write
  logic [6:0] right_turns_waddr;
  assign right_turns_waddr = x_s11_q[6:0];
  logic right_turns_we;
  assign right_turns_we = s11_en & and_620_s11_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= right_codes_rdata_s11_q;
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_turns_we) begin
      if (right_turns_re && right_turns_raddr == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_waddr >= 7'd120) $error("right_turns: write outside, address %0d", right_turns_waddr);
    end
    if (rst_ni && right_turns_re && right_turns_raddr >= 7'd120) $error("right_turns: read outside, address %0d", right_turns_raddr);
  end
`endif

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
  logic [3:0] select_493_s12_q;
  logic equal_494_s12_q;
  logic [6:0] select_496_s12_q;
  logic [8:0] select_500_s12_q;
  logic and_506_s12_q;
  logic equal_512_s12_q;
  logic [6:0] column_s12_q;
  logic and_530_s12_q;
  logic and_532_s12_q;
  logic equal_554_s12_q;
  logic equal_563_s12_q;
  logic so_s12_q;
  logic equal_608_s12_q;
  logic or_609_s12_q;
  logic less_616_s12_q;
  logic not_617_s12_q;
  logic equal_671_s12_q;
  logic [1:0] right_codes_rdata_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1222_s12_q;
  logic [5:0] select_1471_s12_q;
  logic [6:0] sum_1506_s12_q;
  logic [6:0] sum_1509_s12_q;
  logic and_1526_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic equal_1534_s12_q;
  logic inside_v_s12_q;
  logic [6:0] select_1552_s12_q;
  logic and_1561_s12_q;
  logic or_1574_s12_q;
  logic [1:0] right_turns_rdata_s12_q;
  logic right_2_s12_q;
  logic and_1653_s12_q;
  logic and_1666_s12_q;
  logic and_1678_s12_q;
  logic less_1680_s12_q;
  logic [5:0] b_s12_q;
  logic equal_1704_s12_q;
  logic and_1714_s12_q;
  logic [7:0] sum_1745_s12_q;
  logic less_1746_s12_q;
  logic less_1747_s12_q;
  logic equal_1756_s12_q;
  logic and_1760_s12_q;
  logic equal_1763_s12_q;
  logic not_1764_s12_q;
  logic equal_1765_s12_q;
  logic not_1766_s12_q;
  logic equal_1767_s12_q;
  logic equal_1768_s12_q;
  logic or_1769_s12_q;
  logic [4:0] select_1793_s12_q;
  logic select_1799_s12_q;
  logic [7:0] patches_left_rdata_s12_q;
  logic [3:0] select_1838_s12_q;
  logic and_1848_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] select_1852_s12_q;
  logic [8:0] sum_1886_s12_q;
  logic less_1924_s12_q;
  logic equal_1925_s12_q;
  logic not_1926_s12_q;
  logic equal_1927_s12_q;
  logic not_1928_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1956_s12_q;
  logic and_1977_s12_q;
  logic and_2099_s12_q;
  logic equal_2394_s12_q;
  logic and_2521_s12_q;
  logic equal_2606_s12_q;
  logic and_2627_s12_q;
  logic and_2631_s12_q;
  logic and_2633_s12_q;
  logic less_2653_s12_q;
  logic [7:0] wide_s12_q;
  logic [8:0] taken_s12_q;
  logic [7:0] not_2671_s12_q;
  logic less_2692_s12_q;
  logic and_2922_s12_q;
  logic or_2974_s12_q;
  logic not_2998_s12_q;
  logic [9:0] select_3443_s12_q;
  logic [4:0] select_3450_s12_q;
  logic equal_3477_s12_q;
  logic less_3805_s12_q;
  logic equal_4023_s12_q;
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
      select_493_s12_q <= select_493_s11_q;
      equal_494_s12_q <= equal_494_s11_q;
      select_496_s12_q <= select_496_s11_q;
      select_500_s12_q <= select_500_s11_q;
      and_506_s12_q <= and_506_s11_q;
      equal_512_s12_q <= equal_512_s11_q;
      column_s12_q <= column_s11_q;
      and_530_s12_q <= and_530_s11_q;
      and_532_s12_q <= and_532_s11_q;
      equal_554_s12_q <= equal_554_s11_q;
      equal_563_s12_q <= equal_563_s11_q;
      so_s12_q <= so_s11_q;
      equal_608_s12_q <= equal_608_s11_q;
      or_609_s12_q <= or_609_s11_q;
      less_616_s12_q <= less_616_s11_q;
      not_617_s12_q <= not_617_s11_q;
      equal_671_s12_q <= equal_671_s11_q;
      right_codes_rdata_s12_q <= right_codes_rdata_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      column_2_s12_q <= column_2;
      select_1222_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1471_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1506_s12_q <= {1'b0, before_v_2} + sum_1505;
      sum_1509_s12_q <= {1'b0, before_v_3} + sum_1508;
      and_1526_s12_q <= and_1526_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      equal_1534_s12_q <= equal_1534_s11_q;
      inside_v_s12_q <= inside_v_s11_q;
      select_1552_s12_q <= so_s11_q ? x_s11_q[6:0] : select_1551;
      and_1561_s12_q <= and_1561_s11_q;
      or_1574_s12_q <= or_1574_s11_q;
      right_turns_rdata_s12_q <= right_turns_rdata_q;
      right_2_s12_q <= right_2_s11_q;
      and_1653_s12_q <= and_1653_s11_q;
      and_1666_s12_q <= and_1666_s11_q;
      and_1678_s12_q <= and_1678_s11_q;
      less_1680_s12_q <= less_1680_s11_q;
      b_s12_q <= b_s11_q;
      equal_1704_s12_q <= equal_1704_s11_q;
      and_1714_s12_q <= and_1714_s11_q;
      sum_1745_s12_q <= sum_1745[7:0];
      less_1746_s12_q <= $signed(6'h0) < $signed(sum_1745[12:7]);
      less_1747_s12_q <= $signed(sum_1745[12:7]) < $signed(6'h3f);
      equal_1756_s12_q <= equal_1756_s11_q;
      and_1760_s12_q <= and_1760_s11_q;
      equal_1763_s12_q <= equal_1763_s11_q;
      not_1764_s12_q <= not_1764_s11_q;
      equal_1765_s12_q <= equal_1765_s11_q;
      not_1766_s12_q <= not_1766_s11_q;
      equal_1767_s12_q <= equal_1767_s11_q;
      equal_1768_s12_q <= equal_1768_s11_q;
      or_1769_s12_q <= or_1769_s11_q;
      select_1793_s12_q <= select_1793_s11_q;
      select_1799_s12_q <= select_1799_s11_q;
      patches_left_rdata_s12_q <= patches_left_rdata_q;
      select_1838_s12_q <= select_1838_s11_q;
      and_1848_s12_q <= and_1848_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      select_1852_s12_q <= patches_second_s11_q ? patches_right_1_rdata_s11_q : pixel;
      sum_1886_s12_q <= sum_1886;
      less_1924_s12_q <= less_1924_s11_q;
      equal_1925_s12_q <= equal_1925_s11_q;
      not_1926_s12_q <= not_1926_s11_q;
      equal_1927_s12_q <= equal_1927_s11_q;
      not_1928_s12_q <= not_1928_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_1956_s12_q <= sum_1956_s11_q;
      and_1977_s12_q <= and_1977_s11_q;
      and_2099_s12_q <= and_2099_s11_q;
      equal_2394_s12_q <= equal_2394_s11_q;
      and_2521_s12_q <= and_2521_s11_q;
      equal_2606_s12_q <= equal_2606_s11_q;
      and_2627_s12_q <= and_2627_s11_q;
      and_2631_s12_q <= and_2631_s11_q;
      and_2633_s12_q <= and_620_s11_q & (x_s11_q[6:0] == select_1530_s11_q);
      less_2653_s12_q <= slot_s11_q < 3'h3;
      wide_s12_q <= wide_s11_q;
      taken_s12_q <= taken;
      not_2671_s12_q <= ~wide_s11_q;
      less_2692_s12_q <= less_2692_s11_q;
      and_2922_s12_q <= and_2922_s11_q;
      or_2974_s12_q <= or_2974_s11_q;
      not_2998_s12_q <= not_2998_s11_q;
      select_3443_s12_q <= equal_1927_s11_q ? select_3442 : select_3440;
      select_3450_s12_q <= select_3450;
      equal_3477_s12_q <= equal_3477_s11_q;
      less_3805_s12_q <= less_3805_s11_q;
      equal_4023_s12_q <= equal_4023_s11_q;
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
  // hls/stages/census.hpp:120
  logic and_507;
  assign and_507 = sample_pair_whole_s12_q & and_506_s12_q;
  // hls/stages/agreement.hpp:806
  logic or_724;
  assign or_724 = shift_first_s12_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:777
  logic [5:0] select_973;
  assign select_973 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:778
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [6:0] sum_1501;
  assign sum_1501 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1511;
  assign select_1511 = (sum_1506_s12_q < sum_1509_s12_q) ? sum_1509_s12_q : sum_1506_s12_q;
  // hls/stages/agreement.hpp:1002
  logic not_1544;
  assign not_1544 = ~equal_671_s12_q;
  // hls/stages/agreement.hpp:787
  logic and_1546;
  assign and_1546 = ends_cell_s12_q & inside_v_s12_q;
  logic and_1548;
  assign and_1548 = not_1544 & (so_s12_q & and_1546);
  // hls/stages/agreement.hpp:976
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/registration.hpp:83
  logic equal_1681;
  assign equal_1681 = slot_s12_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1684;
  assign select_1684 = b_s12_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1685;
  assign select_1685 = b_s12_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1686;
  assign sum_1686 = {{2{select_1684[6]}}, select_1684} + {select_1685[7], select_1685};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1687;
  assign select_1687 = b_s12_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1688;
  assign select_1688 = b_s12_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1689;
  assign sum_1689 = {{2{select_1687[7]}}, select_1687[7:1]} + {select_1688[7], select_1688};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1691;
  assign select_1691 = b_s12_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1692;
  assign select_1692 = b_s12_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1693;
  assign difference_1693 = {{2{select_1691[7]}}, select_1691[7:1]} - {select_1692[7], select_1692};
  // hls/stages/agreement.hpp:787
  logic [5:0] select_1728;
  assign select_1728 = so_s12_q ? (ends_cell_s12_q ? (inside_v_s12_q ? b_s12_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1749;
  assign select_1749 = less_1746_s12_q ? 8'h7f : (less_1747_s12_q ? 8'h80 : sum_1745_s12_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1681 ? registration_slope_here_q : select_1749;
  // hls/stages/agreement.hpp:787
  logic [7:0] select_1753;
  assign select_1753 = so_s12_q ? (ends_cell_s12_q ? (inside_v_s12_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1761;
  assign and_1761 = not_1544 & and_1760_s12_q;
  // hls/stages/patches.hpp:172
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1768_s12_q ? select_1852_s12_q : patches_left_rdata_s12_q;
  // hls/stages/patches.hpp:462
  logic [9:0] sum_1887;
  assign sum_1887 = {2'h0, patches_columns_above_rdata_s12_q[15:8]} + {1'b0, sum_1886_s12_q};
  // hls/stages/agreement.hpp:234
  logic [5:0] select_2494;
  assign select_2494 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2495;
  assign select_2495 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2496;
  assign select_2496 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2497;
  assign select_2497 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2498;
  assign select_2498 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2499;
  assign select_2499 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:983
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s12_q[61:54]} - {1'b0, best_left_rdata_s12_q[53:46]};
  // hls/stages/agreement.hpp:970
  logic [1:0] select_2634;
  assign select_2634 = and_2633_s12_q ? right_codes_rdata_s12_q : right_turns_rdata_s12_q;
  // hls/stages/agreement.hpp:148
  logic [1:0] select_2636;
  assign select_2636 = or_609_s12_q ? (less_616_s12_q ? 2'h0 : select_2634) : 2'h0;
  // hls/stages/registration.hpp:37
  logic not_2664;
  assign not_2664 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2653_s12_q ? {1'b0, wide_s12_q, 1'b0} : {registration_displacement_over_q[8:0], not_2664};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2672;
  assign select_2672 = registration_displacement_over_q[9] ? wide_s12_q : not_2671_s12_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2653_s12_q ? {taken_s12_q, 1'b1} : {not_2664, select_2672, not_2664};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2674;
  assign sum_2674 = {left, 1'b1} + {taken_2, less_2653_s12_q};
  // hls/stages/agreement.hpp:252
  logic [4:0] select_2676;
  assign select_2676 = so_s12_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:787
  logic [7:0] select_2678;
  assign select_2678 = equal_671_s12_q ? registration_slope_here_q : (so_s12_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:148
  logic [2:0] select_2687;
  assign select_2687 = or_609_s12_q ? (less_616_s12_q ? 3'h0 : best_left_rdata_s12_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3445;
  assign select_3445 = less_1924_s12_q ? (equal_1925_s12_q ? 10'h0 : select_3443_s12_q) : select_3443_s12_q;
  logic [4:0] select_3452;
  assign select_3452 = less_1924_s12_q ? (equal_1925_s12_q ? 5'h0 : select_3450_s12_q) : select_3450_s12_q;
  // hls/stages/patches.hpp:551
  logic and_3462;
  assign and_3462 = less_1924_s12_q & (patches_step_s12_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3465;
  assign select_3465 = equal_1927_s12_q ? (less_1924_s12_q ? (not_1928_s12_q & and_3462) : and_3462) : and_3462;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:227; read in stage 12, written in stage 15: 12 < 15 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_500_s12_q;
  logic averager_memory_re;
  assign averager_memory_re = s12_en & and_507;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1396; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s12_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s12_en & and_1548;
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
      registration_displacement_over_q <= so_s12_q ? sum_2674[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2676;
      registration_slope_here_q <= select_2678;
      patches_read_row_differing_q <= equal_1763_s12_q ? select_3445 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1763_s12_q ? select_3452 : patches_read_row_column_q;
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
      middle_sum_columns_values_1_q <= select_2494;
      middle_sum_columns_values_2_q <= select_2495;
      middle_sum_columns_values_3_q <= select_2496;
      middle_sum_columns_values_4_q <= select_2497;
      middle_sum_columns_values_5_q <= select_2498;
      middle_sum_columns_values_6_q <= select_2499;
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
  logic [3:0] select_493_s13_q;
  logic equal_494_s13_q;
  logic [6:0] select_496_s13_q;
  logic [8:0] select_500_s13_q;
  logic and_506_s13_q;
  logic and_507_s13_q;
  logic equal_512_s13_q;
  logic [6:0] column_s13_q;
  logic and_530_s13_q;
  logic and_532_s13_q;
  logic equal_554_s13_q;
  logic equal_563_s13_q;
  logic so_s13_q;
  logic equal_608_s13_q;
  logic or_609_s13_q;
  logic not_617_s13_q;
  logic equal_671_s13_q;
  logic [6:0] x_s13_2_q;
  logic [61:0] best_left_rdata_s13_q;
  logic select_726_s13_q;
  logic [6:0] difference_974_s13_q;
  logic [6:0] difference_1223_s13_q;
  logic equal_1224_s13_q;
  logic [6:0] difference_1472_s13_q;
  logic [6:0] sum_1502_s13_q;
  logic [6:0] select_1511_s13_q;
  logic and_1526_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1535_s13_q;
  logic not_1544_s13_q;
  logic inside_v_s13_q;
  logic and_1546_s13_q;
  logic and_1548_s13_q;
  logic [6:0] select_1552_s13_q;
  logic and_1561_s13_q;
  logic less_1562_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1574_s13_q;
  logic right_2_s13_q;
  logic and_1653_s13_q;
  logic and_1666_s13_q;
  logic and_1679_s13_q;
  logic less_1680_s13_q;
  logic equal_1681_s13_q;
  logic [7:0] sum_1686_s13_q;
  logic select_1687_s13_q;
  logic [8:0] sum_1689_s13_q;
  logic select_1691_s13_q;
  logic [8:0] difference_1693_s13_q;
  logic equal_1704_s13_q;
  logic and_1714_s13_q;
  logic [5:0] select_1729_s13_q;
  logic [7:0] select_1754_s13_q;
  logic equal_1756_s13_q;
  logic and_1761_s13_q;
  logic and_1762_s13_q;
  logic equal_1763_s13_q;
  logic not_1764_s13_q;
  logic equal_1765_s13_q;
  logic not_1766_s13_q;
  logic equal_1767_s13_q;
  logic equal_1768_s13_q;
  logic or_1769_s13_q;
  logic [4:0] select_1793_s13_q;
  logic select_1799_s13_q;
  logic [3:0] select_1838_s13_q;
  logic and_1848_s13_q;
  logic [31:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [9:0] sum_1887_s13_q;
  logic less_1924_s13_q;
  logic equal_1925_s13_q;
  logic not_1926_s13_q;
  logic equal_1927_s13_q;
  logic not_1928_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1956_s13_q;
  logic and_1977_s13_q;
  logic and_2100_s13_q;
  logic equal_2394_s13_q;
  logic and_2521_s13_q;
  logic equal_2606_s13_q;
  logic rise_s13_q;
  logic [7:0] xor_2611_s13_q;
  logic and_2627_s13_q;
  logic select_2636_s13_q;
  logic and_2637_s13_q;
  logic select_2687_s13_q;
  logic or_2690_s13_q;
  logic [1:0] sum_2691_s13_q;
  logic less_2692_s13_q;
  logic and_2923_s13_q;
  logic or_2974_s13_q;
  logic not_2998_s13_q;
  logic select_3465_s13_q;
  logic equal_3477_s13_q;
  logic less_3805_s13_q;
  logic equal_4023_s13_q;
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
      select_493_s13_q <= select_493_s12_q;
      equal_494_s13_q <= equal_494_s12_q;
      select_496_s13_q <= select_496_s12_q;
      select_500_s13_q <= select_500_s12_q;
      and_506_s13_q <= and_506_s12_q;
      and_507_s13_q <= and_507;
      equal_512_s13_q <= equal_512_s12_q;
      column_s13_q <= column_s12_q;
      and_530_s13_q <= and_530_s12_q;
      and_532_s13_q <= and_532_s12_q;
      equal_554_s13_q <= equal_554_s12_q;
      equal_563_s13_q <= equal_563_s12_q;
      so_s13_q <= so_s12_q;
      equal_608_s13_q <= equal_608_s12_q;
      or_609_s13_q <= or_609_s12_q;
      not_617_s13_q <= not_617_s12_q;
      equal_671_s13_q <= equal_671_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_726_s13_q <= or_724 ? shift_first_s12_q : (~age_s12_q[1]);
      difference_974_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_973};
      difference_1223_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1222_s12_q};
      equal_1224_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1472_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1471_s12_q};
      sum_1502_s13_q <= {1'b0, before_v} + sum_1501;
      select_1511_s13_q <= select_1511;
      and_1526_s13_q <= and_1526_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1535_s13_q <= or_724 ? shift_first_s12_q : equal_1534_s12_q;
      not_1544_s13_q <= not_1544;
      inside_v_s13_q <= inside_v_s12_q;
      and_1546_s13_q <= and_1546;
      and_1548_s13_q <= and_1548;
      select_1552_s13_q <= select_1552_s12_q;
      and_1561_s13_q <= and_1561_s12_q;
      less_1562_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1574_s13_q <= or_1574_s12_q;
      right_2_s13_q <= right_2_s12_q;
      and_1653_s13_q <= and_1653_s12_q;
      and_1666_s13_q <= and_1666_s12_q;
      and_1679_s13_q <= not_1544 & and_1678_s12_q;
      less_1680_s13_q <= less_1680_s12_q;
      equal_1681_s13_q <= equal_1681;
      sum_1686_s13_q <= sum_1686[8:1];
      select_1687_s13_q <= select_1687[0];
      sum_1689_s13_q <= sum_1689;
      select_1691_s13_q <= select_1691[0];
      difference_1693_s13_q <= difference_1693;
      equal_1704_s13_q <= equal_1704_s12_q;
      and_1714_s13_q <= and_1714_s12_q;
      select_1729_s13_q <= equal_671_s12_q ? 6'h0 : select_1728;
      select_1754_s13_q <= equal_671_s12_q ? 8'h0 : select_1753;
      equal_1756_s13_q <= equal_1756_s12_q;
      and_1761_s13_q <= and_1761;
      and_1762_s13_q <= patches_chooses_s12_q & and_1761;
      equal_1763_s13_q <= equal_1763_s12_q;
      not_1764_s13_q <= not_1764_s12_q;
      equal_1765_s13_q <= equal_1765_s12_q;
      not_1766_s13_q <= not_1766_s12_q;
      equal_1767_s13_q <= equal_1767_s12_q;
      equal_1768_s13_q <= equal_1768_s12_q;
      or_1769_s13_q <= or_1769_s12_q;
      select_1793_s13_q <= select_1793_s12_q;
      select_1799_s13_q <= select_1799_s12_q;
      select_1838_s13_q <= select_1838_s12_q;
      and_1848_s13_q <= and_1848_s12_q;
      patches_columns_above_rdata_s13_q <= patches_columns_above_rdata_s12_q;
      pixel_2_s13_q <= pixel_2;
      sum_1887_s13_q <= sum_1887;
      less_1924_s13_q <= less_1924_s12_q;
      equal_1925_s13_q <= equal_1925_s12_q;
      not_1926_s13_q <= not_1926_s12_q;
      equal_1927_s13_q <= equal_1927_s12_q;
      not_1928_s13_q <= not_1928_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1956_s13_q <= sum_1956_s12_q;
      and_1977_s13_q <= and_1977_s12_q;
      and_2100_s13_q <= not_1544 & and_2099_s12_q;
      equal_2394_s13_q <= equal_2394_s12_q;
      and_2521_s13_q <= and_2521_s12_q;
      equal_2606_s13_q <= equal_2606_s12_q;
      rise_s13_q <= rise[8];
      xor_2611_s13_q <= rise[7:0] ^ {8{rise[8]}};
      and_2627_s13_q <= and_2627_s12_q;
      select_2636_s13_q <= select_2636[1];
      and_2637_s13_q <= and_2631_s12_q & select_2636[0];
      select_2687_s13_q <= select_2687[0];
      or_2690_s13_q <= (select_2687 == 3'h0) | (select_2687 == 3'h4);
      sum_2691_s13_q <= select_2687[2:1] + 2'h3;
      less_2692_s13_q <= less_2692_s12_q;
      and_2923_s13_q <= not_1544 & and_2922_s12_q;
      or_2974_s13_q <= or_2974_s12_q;
      not_2998_s13_q <= not_2998_s12_q;
      select_3465_s13_q <= select_3465;
      equal_3477_s13_q <= equal_3477_s12_q;
      less_3805_s13_q <= less_3805_s12_q;
      equal_4023_s13_q <= equal_4023_s12_q;
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
  // hls/stages/census.hpp:113
  logic [13:0] select_510;
  assign select_510 = equal_494_s13_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_516;
  assign sum_516 = {6'h0, sample_pair_pixel_1_q} + (equal_494_s13_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:777
  logic [7:0] sum_976;
  assign sum_976 = {difference_974_s13_q[6], difference_974_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1226;
  assign sum_1226 = {difference_1223_s13_q[6], difference_1223_s13_q} + (equal_1224_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1474;
  assign sum_1474 = {difference_1472_s13_q[6], difference_1472_s13_q} + (equal_1224_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:754
  logic [6:0] select_1503;
  assign select_1503 = slot_s13_q[0] ? chosen_near_q : sum_1502_s13_q;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_1513;
  assign select_1513 = (select_1503 < select_1511_s13_q) ? select_1511_s13_q : select_1503;
  // hls/stages/agreement.hpp:975
  logic select_1564;
  assign select_1564 = slot_s13_q[2] ? less_1562_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:989
  logic [8:0] difference_1567;
  assign difference_1567 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1690;
  assign sum_1690 = {{3{sum_1686_s13_q[7]}}, sum_1686_s13_q} + {sum_1689_s13_q[8], sum_1689_s13_q, select_1687_s13_q};
  logic [9:0] sum_1694;
  assign sum_1694 = {difference_1693_s13_q, select_1691_s13_q} + {sum_1690[10], sum_1690[10:2]};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_1876;
  assign sum_1876 = {1'b0, patches_columns_above_rdata_s13_q[7:0]} + {2'h0, pixel_2_s13_q[7:1]};
  logic [8:0] sum_1877;
  assign sum_1877 = {1'b0, patches_columns_above_rdata_s13_q[23:16]} + {2'h0, patches_columns_above_rdata_s13_q[31:25]};
  // hls/stages/patches.hpp:462
  logic [10:0] sum_1888;
  assign sum_1888 = {3'h0, patches_columns_above_rdata_s13_q[15:8]} + {sum_1887_s13_q, patches_columns_above_rdata_s13_q[25]};
  // hls/stages/agreement.hpp:234
  logic [6:0] select_2506;
  assign select_2506 = slot_s13_q[0] ? 7'h0 : sum_1502_s13_q;
  // hls/stages/agreement.hpp:750
  logic [6:0] select_2508;
  assign select_2508 = (select_2506 < select_1511_s13_q) ? select_1511_s13_q : select_2506;
  // hls/stages/agreement.hpp:984
  logic [7:0] lower;
  assign lower = rise_s13_q ? best_left_rdata_s13_q[61:54] : best_left_rdata_s13_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2693;
  assign difference_2693 = {sum_2691_s13_q, select_2687_s13_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2694;
  assign select_2694 = less_2692_s13_q ? difference_2693 : {sum_2691_s13_q, select_2687_s13_q, registration_displacement_fraction_q};
  logic [7:0] select_2695;
  assign select_2695 = or_2690_s13_q ? {sum_2691_s13_q, select_2687_s13_q, 5'h0} : select_2694;
  // hls/stages/patches.hpp:187
  logic select_3013;
  assign select_3013 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:175
  logic and_3074;
  assign and_3074 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_3079;
  assign select_3079 = or_2974_s13_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_3081;
  assign select_3081 = and_3074 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:551
  logic [4:0] select_3454;
  assign select_3454 = less_1924_s13_q ? patches_step_s13_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3457;
  assign select_3457 = equal_1927_s13_q ? (less_1924_s13_q ? (equal_1927_s13_q ? 5'h0 : select_3454) : 5'h0) : select_3454;
  logic [4:0] select_3459;
  assign select_3459 = less_1924_s13_q ? (equal_1925_s13_q ? 5'h0 : select_3457) : select_3457;
  logic select_3467;
  assign select_3467 = less_1924_s13_q ? (not_1926_s13_q & select_3465_s13_q) : select_3465_s13_q;
  // hls/stages/patches.hpp:178
  logic or_3479;
  assign or_3479 = patches_read_first_q | (patches_read_row_differing_s13_q < patches_peak_best_differing_q);
  logic and_3480;
  assign and_3480 = patches_read_searches_s13_q & or_3479;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3512;
  assign select_3512 = and_3480 ? {patches_read_row_column_s13_q, patches_read_row_differing_s13_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3513;
  assign select_3513 = equal_1763_s13_q ? select_3512[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3514;
  assign select_3514 = equal_1763_s13_q ? select_3512[14:10] : patches_peak_best_column_q;

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1368; read in stage 13, written in stage 16: 13 < 16 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s13_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s13_en & and_1548_s13_q;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s13_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s13_en & and_1848_s13_q;
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
      chosen_near_q <= select_2508;
      patches_along_ends_q <= not_2998_s13_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2998_s13_q & select_3013;
      patches_down_by_q <= or_2974_s13_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3074});
      patches_along_q <= select_3079;
      patches_match_row_q <= or_2974_s13_q ? 4'h0 : select_3081;
      patches_summed_last_q <= not_1764_s13_q & (equal_1765_s13_q & and_3074);
      patches_read_first_q <= equal_1763_s13_q ? select_3467 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3513;
      patches_peak_best_column_q <= select_3514;
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
      averager_running_0_q <= sample_pair_whole_s13_q ? select_510 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s13_q ? sum_516 : averager_running_1_q;
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_976;
      sums_0_sum_sums_values_0_q <= sum_1226;
      sums_0_sum_sums_values_1_q <= equal_1224_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1474;
      sums_1_sum_sums_values_1_q <= equal_1224_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [3:0] select_493_s14_q;
  logic equal_494_s14_q;
  logic [6:0] select_496_s14_q;
  logic [8:0] select_500_s14_q;
  logic and_506_s14_q;
  logic and_507_s14_q;
  logic [29:0] averager_memory_rdata_s14_q;
  logic [13:0] select_510_s14_q;
  logic equal_512_s14_q;
  logic [13:0] sum_516_s14_q;
  logic [6:0] column_s14_q;
  logic and_530_s14_q;
  logic and_532_s14_q;
  logic equal_554_s14_q;
  logic equal_563_s14_q;
  logic so_s14_q;
  logic equal_608_s14_q;
  logic or_609_s14_q;
  logic not_617_s14_q;
  logic equal_671_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_726_s14_q;
  logic [7:0] sum_976_s14_q;
  logic less_1475_s14_q;
  logic [6:0] select_1513_s14_q;
  logic [7:0] select_1521_s14_q;
  logic [7:0] select_1524_s14_q;
  logic and_1526_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1535_s14_q;
  logic not_1544_s14_q;
  logic inside_v_s14_q;
  logic and_1546_s14_q;
  logic and_1548_s14_q;
  logic [6:0] select_1552_s14_q;
  logic and_1561_s14_q;
  logic select_1564_s14_q;
  logic [9:0] sum_1568_s14_q;
  logic or_1574_s14_q;
  logic right_2_s14_q;
  logic and_1653_s14_q;
  logic and_1666_s14_q;
  logic and_1679_s14_q;
  logic less_1680_s14_q;
  logic equal_1681_s14_q;
  logic sum_1690_s14_q;
  logic [9:0] sum_1694_s14_q;
  logic equal_1704_s14_q;
  logic and_1714_s14_q;
  logic [5:0] select_1729_s14_q;
  logic [7:0] select_1754_s14_q;
  logic equal_1756_s14_q;
  logic and_1761_s14_q;
  logic and_1762_s14_q;
  logic equal_1763_s14_q;
  logic not_1764_s14_q;
  logic equal_1765_s14_q;
  logic not_1766_s14_q;
  logic equal_1767_s14_q;
  logic equal_1768_s14_q;
  logic or_1769_s14_q;
  logic [4:0] select_1793_s14_q;
  logic select_1799_s14_q;
  logic [3:0] select_1838_s14_q;
  logic [8:0] patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic [4:0] sum_1862_s14_q;
  logic [8:0] sum_1876_s14_q;
  logic [8:0] sum_1877_s14_q;
  logic [10:0] sum_1888_s14_q;
  logic less_1924_s14_q;
  logic equal_1925_s14_q;
  logic not_1926_s14_q;
  logic equal_1927_s14_q;
  logic not_1928_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic sum_1956_s14_q;
  logic and_1977_s14_q;
  logic [17:0] seen_columns_rdata_s14_q;
  logic and_2100_s14_q;
  logic equal_2394_s14_q;
  logic and_2521_s14_q;
  logic equal_2606_s14_q;
  logic [7:0] lower_s14_q;
  logic [7:0] sum_2612_s14_q;
  logic and_2627_s14_q;
  logic select_2636_s14_q;
  logic and_2637_s14_q;
  logic [7:0] select_2695_s14_q;
  logic and_2923_s14_q;
  logic [4:0] select_3459_s14_q;
  logic equal_3477_s14_q;
  logic and_3480_s14_q;
  logic [14:0] select_3512_s14_q;
  logic less_3805_s14_q;
  logic equal_4023_s14_q;
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
      select_493_s14_q <= select_493_s13_q;
      equal_494_s14_q <= equal_494_s13_q;
      select_496_s14_q <= select_496_s13_q;
      select_500_s14_q <= select_500_s13_q;
      and_506_s14_q <= and_506_s13_q;
      and_507_s14_q <= and_507_s13_q;
      averager_memory_rdata_s14_q <= averager_memory_rdata_q;
      select_510_s14_q <= select_510;
      equal_512_s14_q <= equal_512_s13_q;
      sum_516_s14_q <= sum_516;
      column_s14_q <= column_s13_q;
      and_530_s14_q <= and_530_s13_q;
      and_532_s14_q <= and_532_s13_q;
      equal_554_s14_q <= equal_554_s13_q;
      equal_563_s14_q <= equal_563_s13_q;
      so_s14_q <= so_s13_q;
      equal_608_s14_q <= equal_608_s13_q;
      or_609_s14_q <= or_609_s13_q;
      not_617_s14_q <= not_617_s13_q;
      equal_671_s14_q <= equal_671_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[45:0];
      select_726_s14_q <= select_726_s13_q;
      sum_976_s14_q <= sum_976;
      less_1475_s14_q <= sum_1226 < sum_1474;
      select_1513_s14_q <= select_1513;
      select_1521_s14_q <= select_726_s13_q ? 8'h0 : best_left_rdata_s13_q[53:46];
      select_1524_s14_q <= select_726_s13_q ? 8'h0 : best_left_rdata_s13_q[61:54];
      and_1526_s14_q <= and_1526_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1535_s14_q <= select_1535_s13_q;
      not_1544_s14_q <= not_1544_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      and_1546_s14_q <= and_1546_s13_q;
      and_1548_s14_q <= and_1548_s13_q;
      select_1552_s14_q <= select_1552_s13_q;
      and_1561_s14_q <= and_1561_s13_q;
      select_1564_s14_q <= select_1564;
      sum_1568_s14_q <= {difference_1567[8], difference_1567} + 10'h1;
      or_1574_s14_q <= or_1574_s13_q;
      right_2_s14_q <= right_2_s13_q;
      and_1653_s14_q <= and_1653_s13_q;
      and_1666_s14_q <= and_1666_s13_q;
      and_1679_s14_q <= and_1679_s13_q;
      less_1680_s14_q <= less_1680_s13_q;
      equal_1681_s14_q <= equal_1681_s13_q;
      sum_1690_s14_q <= sum_1690[1];
      sum_1694_s14_q <= sum_1694;
      equal_1704_s14_q <= equal_1704_s13_q;
      and_1714_s14_q <= and_1714_s13_q;
      select_1729_s14_q <= select_1729_s13_q;
      select_1754_s14_q <= select_1754_s13_q;
      equal_1756_s14_q <= equal_1756_s13_q;
      and_1761_s14_q <= and_1761_s13_q;
      and_1762_s14_q <= and_1762_s13_q;
      equal_1763_s14_q <= equal_1763_s13_q;
      not_1764_s14_q <= not_1764_s13_q;
      equal_1765_s14_q <= equal_1765_s13_q;
      not_1766_s14_q <= not_1766_s13_q;
      equal_1767_s14_q <= equal_1767_s13_q;
      equal_1768_s14_q <= equal_1768_s13_q;
      or_1769_s14_q <= or_1769_s13_q;
      select_1793_s14_q <= select_1793_s13_q;
      select_1799_s14_q <= select_1799_s13_q;
      select_1838_s14_q <= select_1838_s13_q;
      patches_columns_above_rdata_s14_q <= {patches_columns_above_rdata_s13_q[24], patches_columns_above_rdata_s13_q[7:0]};
      pixel_2_s14_q <= pixel_2_s13_q;
      sum_1862_s14_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1876_s14_q <= sum_1876;
      sum_1877_s14_q <= sum_1877;
      sum_1888_s14_q <= sum_1888;
      less_1924_s14_q <= less_1924_s13_q;
      equal_1925_s14_q <= equal_1925_s13_q;
      not_1926_s14_q <= not_1926_s13_q;
      equal_1927_s14_q <= equal_1927_s13_q;
      not_1928_s14_q <= not_1928_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      sum_1956_s14_q <= sum_1956_s13_q;
      and_1977_s14_q <= and_1977_s13_q;
      seen_columns_rdata_s14_q <= seen_columns_rdata_q;
      and_2100_s14_q <= and_2100_s13_q;
      equal_2394_s14_q <= equal_2394_s13_q;
      and_2521_s14_q <= and_2521_s13_q;
      equal_2606_s14_q <= equal_2606_s13_q;
      lower_s14_q <= lower;
      sum_2612_s14_q <= {7'h0, rise_s13_q} + xor_2611_s13_q;
      and_2627_s14_q <= and_2627_s13_q;
      select_2636_s14_q <= select_2636_s13_q;
      and_2637_s14_q <= and_2637_s13_q;
      select_2695_s14_q <= select_2695;
      and_2923_s14_q <= and_2923_s13_q;
      select_3459_s14_q <= select_3459;
      equal_3477_s14_q <= equal_3477_s13_q;
      and_3480_s14_q <= and_3480;
      select_3512_s14_q <= select_3512;
      less_3805_s14_q <= less_3805_s13_q;
      equal_4023_s14_q <= equal_4023_s13_q;
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
  // hls/stages/census.hpp:122
  logic [13:0] sum_514;
  assign sum_514 = select_510_s14_q + (equal_512_s14_q ? 14'h0 : averager_memory_rdata_s14_q[13:0]);
  logic [13:0] sum_518;
  assign sum_518 = sum_516_s14_q + (equal_512_s14_q ? 14'h0 : averager_memory_rdata_s14_q[27:14]);
  // hls/stages/agreement.hpp:412
  logic whole;
  assign whole = equal_494_s14_q ? sample_present_s14_q : (sample_present_s14_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_494_s14_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:124
  logic and_526;
  assign and_526 = all_of_skin & (averager_memory_rdata_s14_q[29] | equal_512_s14_q);
  // hls/stages/agreement.hpp:754
  logic [7:0] select_977;
  assign select_977 = slot_s14_q[0] ? chosen_score_q : sum_976_s14_q;
  // hls/stages/agreement.hpp:750
  logic [7:0] select_1476;
  assign select_1476 = less_1475_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1477;
  assign less_1477 = select_977 < select_1476;
  // hls/stages/agreement.hpp:800
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1477 ? select_1476 : select_977) : 8'h0;
  // hls/stages/agreement.hpp:719
  logic not_1483;
  assign not_1483 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:751
  logic [1:0] select_1484;
  assign select_1484 = less_1475_s14_q ? {slot_s14_q[0], not_1483} : 2'h0;
  logic [2:0] select_1486;
  assign select_1486 = less_1477 ? {select_1484, not_1483} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:801
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1513_s14_q : 7'h0;
  // hls/stages/agreement.hpp:812
  logic less_1515;
  assign less_1515 = best_left_rdata_s14_q[39:33] < of_near;
  // hls/stages/agreement.hpp:242
  logic and_1570;
  assign and_1570 = (and_1561_s14_q & select_1564_s14_q) & ({{22{sum_1568_s14_q[9]}}, sum_1568_s14_q} < 32'h3);
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s14_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:210
  logic equal_1599;
  assign equal_1599 = x_s14_q[5:0] == 6'h3c;
  logic equal_1601;
  assign equal_1601 = x_s14_q[5:0] == 6'h3b;
  logic equal_1603;
  assign equal_1603 = x_s14_q[5:0] == 6'h36;
  logic equal_1605;
  assign equal_1605 = x_s14_q[5:0] == 6'h35;
  logic equal_1607;
  assign equal_1607 = x_s14_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1170
  logic and_1611;
  assign and_1611 = (~equal_1601) & ((~equal_1603) & ((~equal_1605) & (~equal_1607)));
  // hls/stages/patches.hpp:372
  logic [1:0] select_1667;
  assign select_1667 = and_1666_s14_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1668;
  assign select_1668 = and_1666_s14_q ? patches_band_rows_number_s14_q : patches_band_q;
  // hls/stages/agreement.hpp:271
  logic [5:0] select_1669;
  assign select_1669 = and_1653_s14_q ? {select_1668, select_1667[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1670;
  assign select_1670 = and_1653_s14_q ? select_1667 : patches_fetch_q;
  logic equal_1671;
  assign equal_1671 = select_1670 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1681_s14_q ? {sum_1694_s14_q, sum_1690_s14_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1776;
  assign select_1776 = and_1653_s14_q ? select_1668 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_1777;
  assign equal_1777 = {patches_choosing_band_s14_q, and_1679_s14_q} == {select_1776, select_1670[1]};
  // hls/stages/patches.hpp:495
  logic less_1854;
  assign less_1854 = 5'he < patches_along_s14_q;
  // hls/stages/patches.hpp:496
  logic or_1855;
  assign or_1855 = equal_1767_s14_q | less_1854;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_s14_q == 5'h0;
  logic select_1860;
  assign select_1860 = equal_1767_s14_q ? patches_column_s14_q[0] : (or_1855 ? (patches_along_s14_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:497
  logic [4:0] select_1863;
  assign select_1863 = patches_match_row_ends_s14_q ? patches_down_by_s14_q : sum_1862_s14_q;
  // hls/stages/patches.hpp:500
  logic [4:0] select_1866;
  assign select_1866 = equal_1767_s14_q ? 5'h0 : (or_1855 ? (select_1863 + 5'h1) : sum_1862_s14_q);
  // hls/stages/patches.hpp:476
  logic equal_1869;
  assign equal_1869 = patches_column_s14_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s14_q == 5'h11;
  logic equal_1871;
  assign equal_1871 = patches_column_s14_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_1873;
  assign and_1873 = of_row & (~equal_1871);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1869 ? 2'h3 : {equal_1871, and_1873};
  // hls/stages/patches.hpp:464
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1876_s14_q, pixel_2_s14_q[0]} - {1'b0, sum_1877_s14_q, patches_columns_above_rdata_s14_q[8]};
  // hls/stages/patches.hpp:462
  logic [9:0] sum_1889;
  assign sum_1889 = {2'h0, patches_columns_above_rdata_s14_q[7:0]} + sum_1888_s14_q[10:1];
  // hls/stages/patches.hpp:477
  logic or_1899;
  assign or_1899 = (((patches_column_s14_q == 5'ha) | of_row) | equal_1871) | equal_1869;
  // hls/stages/patches.hpp:472
  logic and_1904;
  assign and_1904 = (~(patches_code_row_s14_q[4:2] == 3'h0)) & (~(patches_column_s14_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:172
  logic and_1918;
  assign and_1918 = (~(equal_1768_s14_q | (~and_1904))) & (~patches_column_s14_q[4]);
  // hls/stages/agreement.hpp:204
  logic [7:0] select_1943;
  assign select_1943 = so_s14_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1043
  logic or_1946;
  assign or_1946 = select_1943[7] | (~({select_1943[5], select_1943[3], select_1943[1]} == 3'h0));
  // hls/stages/agreement.hpp:1051
  logic or_1958;
  assign or_1958 = (~sum_1956_s14_q) | equal_1756_s14_q;
  // hls/stages/agreement.hpp:257
  logic textured;
  assign textured = inside_v_s14_q & (or_609_s14_q & (not_617_s14_q & and_1561_s14_q));
  // hls/stages/agreement.hpp:1023
  logic [7:0] select_2041;
  assign select_2041 = inside_v_s14_q ? (sum_1956_s14_q ? select_1943 : {select_1943[6:0], 1'b0}) : select_1943;
  // hls/stages/agreement.hpp:1043
  logic or_2044;
  assign or_2044 = select_2041[7] | (~({select_2041[5], select_2041[3], select_2041[1]} == 3'h0));
  // hls/stages/agreement.hpp:271
  logic select_2153;
  assign select_2153 = sample_pair_whole_s14_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:234
  logic [7:0] select_2503;
  assign select_2503 = slot_s14_q[0] ? 8'h0 : sum_976_s14_q;
  // hls/stages/agreement.hpp:750
  logic less_2504;
  assign less_2504 = select_2503 < select_1476;
  // hls/stages/agreement.hpp:787
  logic less_2510;
  assign less_2510 = $signed(run_shift_s14_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2512;
  assign less_2512 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s14_q);
  // hls/stages/agreement.hpp:985
  logic [7:0] difference_2610;
  assign difference_2610 = best_left_rdata_s14_q[16:9] - lower_s14_q;
  // hls/stages/agreement.hpp:787
  logic [10:0] select_2680;
  assign select_2680 = equal_671_s14_q ? registration_expected_q : (so_s14_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2695_s14_q[7]}}, select_2695_s14_q} - {sum_1694_s14_q[9], sum_1694_s14_q, sum_1690_s14_q};
  // hls/stages/patches.hpp:353
  logic not_2939;
  assign not_2939 = ~select_1670[1];
  // hls/stages/agreement.hpp:271
  logic [1:0] select_2941;
  assign select_2941 = sample_pair_whole_s14_q ? (equal_1671 ? select_1670 : {not_2939, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:184
  logic [4:0] select_3436;
  assign select_3436 = equal_1765_s14_q ? patches_down_by_s14_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3481;
  assign select_3481 = and_3480_s14_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s14_q} - {1'b0, select_3481};
  // hls/stages/division.hpp:34
  logic [7:0] sum_3806;
  assign sum_3806 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:787
  logic [7:0] select_3815;
  assign select_3815 = equal_671_s14_q ? select_1943 : (so_s14_q ? (ends_cell_s14_q ? select_2041 : select_1943) : 8'h1);
  // hls/stages/agreement.hpp:458
  logic [8:0] select_3829;
  assign select_3829 = equal_563_s14_q ? {difference_3827[7], difference_3827} : (less_3805_s14_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:518
  logic [8:0] select_3831;
  assign select_3831 = and_532_s14_q ? (equal_2394_s14_q ? select_3829 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:458
  logic [7:0] select_3833;
  assign select_3833 = equal_563_s14_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:518
  logic [7:0] select_3835;
  assign select_3835 = and_532_s14_q ? (equal_2394_s14_q ? select_3833 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3837;
  assign select_3837 = sum_3806[7] ? {1'b1, sum_3806[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:344; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s14_q;
  logic census_memory_re;
  assign census_memory_re = s14_en & and_532_s14_q;
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
      averager_running_of_skin_q <= select_2153;
      chosen_score_q <= less_2504 ? select_1476 : select_2503;
      chosen_place_q <= less_2504 ? {select_1484, not_1483} : 3'h2;
      before_0_q <= select_2503;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2510) & (~less_2512);
      registration_expected_q <= select_2680;
      patches_band_q <= sample_pair_whole_s14_q ? select_1776 : patches_band_q;
      patches_fetch_q <= select_2941;
      patches_summed_down_by_q <= equal_1763_s14_q ? patches_summed_down_by_q : select_3436;
      patches_read_at_q <= equal_1763_s14_q ? select_3459_s14_q : patches_read_at_q;
      patches_peak_row_q <= equal_1763_s14_q ? select_3481 : patches_peak_row_q;
      region_columns_q <= select_3815;
      region_down_rest_q <= select_3831;
      region_down_back_q <= select_3835;
      region_down_next_q <= select_3837;
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
  logic [3:0] select_493_s15_q;
  logic [6:0] select_496_s15_q;
  logic [8:0] select_500_s15_q;
  logic and_506_s15_q;
  logic and_507_s15_q;
  logic [13:0] sum_514_s15_q;
  logic [13:0] sum_518_s15_q;
  logic and_522_s15_q;
  logic and_526_s15_q;
  logic [6:0] column_s15_q;
  logic and_530_s15_q;
  logic and_532_s15_q;
  logic equal_535_s15_q;
  logic equal_554_s15_q;
  logic equal_563_s15_q;
  logic so_s15_q;
  logic equal_608_s15_q;
  logic or_609_s15_q;
  logic not_617_s15_q;
  logic equal_671_s15_q;
  logic [6:0] x_s15_2_q;
  logic [32:0] best_left_rdata_s15_q;
  logic select_726_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1486_s15_q;
  logic [6:0] of_near_s15_q;
  logic [6:0] select_1516_s15_q;
  logic [5:0] select_1518_s15_q;
  logic [7:0] select_1521_s15_q;
  logic [7:0] select_1524_s15_q;
  logic and_1526_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1535_s15_q;
  logic or_1541_s15_q;
  logic not_1544_s15_q;
  logic inside_v_s15_q;
  logic and_1546_s15_q;
  logic and_1548_s15_q;
  logic [1:0] shown_right_rdata_s15_q;
  logic [6:0] select_1552_s15_q;
  logic and_1570_s15_q;
  logic and_1575_s15_q;
  logic equal_1585_s15_q;
  logic all_s15_q;
  logic equal_1599_s15_q;
  logic equal_1601_s15_q;
  logic equal_1603_s15_q;
  logic equal_1605_s15_q;
  logic equal_1607_s15_q;
  logic and_1612_s15_q;
  logic right_2_s15_q;
  logic and_1653_s15_q;
  logic [5:0] select_1669_s15_q;
  logic select_1670_s15_q;
  logic equal_1671_s15_q;
  logic and_1679_s15_q;
  logic less_1680_s15_q;
  logic equal_1681_s15_q;
  logic expected_s15_q;
  logic [10:0] sum_1696_s15_q;
  logic equal_1704_s15_q;
  logic and_1714_s15_q;
  logic [5:0] select_1729_s15_q;
  logic [7:0] select_1754_s15_q;
  logic and_1761_s15_q;
  logic and_1762_s15_q;
  logic equal_1763_s15_q;
  logic not_1764_s15_q;
  logic equal_1765_s15_q;
  logic not_1766_s15_q;
  logic equal_1768_s15_q;
  logic or_1769_s15_q;
  logic and_1778_s15_q;
  logic [4:0] select_1793_s15_q;
  logic select_1799_s15_q;
  logic [3:0] select_1838_s15_q;
  logic patches_columns_above_rdata_s15_q;
  logic [7:0] pixel_2_s15_q;
  logic less_1854_s15_q;
  logic new_row_s15_q;
  logic select_1860_s15_q;
  logic not_1861_s15_q;
  logic [4:0] select_1866_s15_q;
  logic or_1867_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [10:0] down_2_s15_q;
  logic sum_1888_s15_q;
  logic [9:0] sum_1889_s15_q;
  logic and_1907_s15_q;
  logic and_1918_s15_q;
  logic and_1921_s15_q;
  logic less_1924_s15_q;
  logic equal_1925_s15_q;
  logic not_1926_s15_q;
  logic equal_1927_s15_q;
  logic not_1928_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic or_1946_s15_q;
  logic or_1949_s15_q;
  logic or_1952_s15_q;
  logic and_1961_s15_q;
  logic textured_s15_q;
  logic and_1977_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic and_2027_s15_q;
  logic and_2029_s15_q;
  logic or_2044_s15_q;
  logic or_2047_s15_q;
  logic or_2050_s15_q;
  logic and_2061_s15_q;
  logic and_2077_s15_q;
  logic and_2100_s15_q;
  logic equal_2394_s15_q;
  logic and_2521_s15_q;
  logic and_2545_s15_q;
  logic equal_2606_s15_q;
  logic [5:0] difference_2610_s15_q;
  logic [7:0] sum_2612_s15_q;
  logic and_2627_s15_q;
  logic select_2636_s15_q;
  logic and_2637_s15_q;
  logic [11:0] select_2698_s15_q;
  logic and_2923_s15_q;
  logic less_3050_s15_q;
  logic equal_3477_s15_q;
  logic [4:0] select_3481_s15_q;
  logic [5:0] away_s15_q;
  logic equal_3483_s15_q;
  logic equal_3492_s15_q;
  logic [14:0] select_3512_s15_q;
  logic less_3805_s15_q;
  logic sum_3806_s15_q;
  logic select_3848_s15_q;
  logic equal_3859_s15_q;
  logic equal_3897_s15_q;
  logic and_4013_s15_q;
  logic equal_4023_s15_q;
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
      select_493_s15_q <= select_493_s14_q;
      select_496_s15_q <= select_496_s14_q;
      select_500_s15_q <= select_500_s14_q;
      and_506_s15_q <= and_506_s14_q;
      and_507_s15_q <= and_507_s14_q;
      sum_514_s15_q <= sum_514;
      sum_518_s15_q <= sum_518;
      and_522_s15_q <= whole & (averager_memory_rdata_s14_q[28] | equal_512_s14_q);
      and_526_s15_q <= and_526;
      column_s15_q <= column_s14_q;
      and_530_s15_q <= and_530_s14_q;
      and_532_s15_q <= and_532_s14_q;
      equal_535_s15_q <= select_493_s14_q == 4'h3;
      equal_554_s15_q <= equal_554_s14_q;
      equal_563_s15_q <= equal_563_s14_q;
      so_s15_q <= so_s14_q;
      equal_608_s15_q <= equal_608_s14_q;
      or_609_s15_q <= or_609_s14_q;
      not_617_s15_q <= not_617_s14_q;
      equal_671_s15_q <= equal_671_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q[32:0];
      select_726_s15_q <= select_726_s14_q;
      of_best_s15_q <= of_best;
      select_1486_s15_q <= select_1486;
      of_near_s15_q <= of_near;
      select_1516_s15_q <= less_1515 ? of_near : best_left_rdata_s14_q[39:33];
      select_1518_s15_q <= less_1515 ? run_shift_s14_q : best_left_rdata_s14_q[45:40];
      select_1521_s15_q <= select_1521_s14_q;
      select_1524_s15_q <= select_1524_s14_q;
      and_1526_s15_q <= and_1526_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1535_s15_q <= select_1535_s14_q;
      or_1541_s15_q <= select_1535_s14_q | (best_right_rdata_s14_q[21:15] < of_near);
      not_1544_s15_q <= not_1544_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      and_1546_s15_q <= and_1546_s14_q;
      and_1548_s15_q <= and_1548_s14_q;
      shown_right_rdata_s15_q <= shown_right_rdata_q;
      select_1552_s15_q <= select_1552_s14_q;
      and_1570_s15_q <= and_1570;
      and_1575_s15_q <= and_1570 & or_1574_s14_q;
      equal_1585_s15_q <= x_s14_q[6:4] == 3'h7;
      all_s15_q <= all;
      equal_1599_s15_q <= equal_1599;
      equal_1601_s15_q <= equal_1601;
      equal_1603_s15_q <= equal_1603;
      equal_1605_s15_q <= equal_1605;
      equal_1607_s15_q <= equal_1607;
      and_1612_s15_q <= (~equal_1599) & and_1611;
      right_2_s15_q <= right_2_s14_q;
      and_1653_s15_q <= and_1653_s14_q;
      select_1669_s15_q <= select_1669;
      select_1670_s15_q <= select_1670[1];
      equal_1671_s15_q <= equal_1671;
      and_1679_s15_q <= and_1679_s14_q;
      less_1680_s15_q <= less_1680_s14_q;
      equal_1681_s15_q <= equal_1681_s14_q;
      expected_s15_q <= expected[0];
      sum_1696_s15_q <= {expected[10], expected[10:1]} + 11'h5;
      equal_1704_s15_q <= equal_1704_s14_q;
      and_1714_s15_q <= and_1714_s14_q;
      select_1729_s15_q <= select_1729_s14_q;
      select_1754_s15_q <= select_1754_s14_q;
      and_1761_s15_q <= and_1761_s14_q;
      and_1762_s15_q <= and_1762_s14_q;
      equal_1763_s15_q <= equal_1763_s14_q;
      not_1764_s15_q <= not_1764_s14_q;
      equal_1765_s15_q <= equal_1765_s14_q;
      not_1766_s15_q <= not_1766_s14_q;
      equal_1768_s15_q <= equal_1768_s14_q;
      or_1769_s15_q <= or_1769_s14_q;
      and_1778_s15_q <= and_1762_s14_q & equal_1777;
      select_1793_s15_q <= select_1793_s14_q;
      select_1799_s15_q <= select_1799_s14_q;
      select_1838_s15_q <= select_1838_s14_q;
      patches_columns_above_rdata_s15_q <= patches_columns_above_rdata_s14_q[8];
      pixel_2_s15_q <= pixel_2_s14_q;
      less_1854_s15_q <= less_1854;
      new_row_s15_q <= new_row;
      select_1860_s15_q <= select_1860;
      not_1861_s15_q <= ~or_1855;
      select_1866_s15_q <= select_1866;
      or_1867_s15_q <= equal_1767_s14_q | equal_1765_s14_q;
      of_row_2_s15_q <= of_row_2;
      down_2_s15_q <= down_2;
      sum_1888_s15_q <= sum_1888_s14_q[0];
      sum_1889_s15_q <= sum_1889;
      and_1907_s15_q <= or_1769_s14_q & (or_1899 & (equal_1768_s14_q & and_1904));
      and_1918_s15_q <= and_1918;
      and_1921_s15_q <= or_1769_s14_q & (and_1918 & (patches_column_s14_q == 5'hf));
      less_1924_s15_q <= less_1924_s14_q;
      equal_1925_s15_q <= equal_1925_s14_q;
      not_1926_s15_q <= not_1926_s14_q;
      equal_1927_s15_q <= equal_1927_s14_q;
      not_1928_s15_q <= not_1928_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      or_1946_s15_q <= or_1946;
      or_1949_s15_q <= select_1943[7] | (~({select_1943[6], select_1943[3:2]} == 3'h0));
      or_1952_s15_q <= select_1943[7] | (~(select_1943[6:4] == 3'h0));
      and_1961_s15_q <= so_s14_q & (ends_cell_s14_q & (inside_v_s14_q & or_1958));
      textured_s15_q <= textured;
      and_1977_s15_q <= and_1977_s14_q;
      seen_columns_rdata_s15_q <= {seen_columns_rdata_s14_q[13:7], seen_columns_rdata_s14_q[5:0]};
      and_2027_s15_q <= seen_columns_rdata_s14_q[14] & inside_v_s14_q;
      and_2029_s15_q <= seen_columns_rdata_s14_q[5] & inside_v_s14_q;
      or_2044_s15_q <= or_2044;
      or_2047_s15_q <= select_2041[7] | (~({select_2041[6], select_2041[3:2]} == 3'h0));
      or_2050_s15_q <= select_2041[7] | (~(select_2041[6:4] == 3'h0));
      and_2061_s15_q <= seen_columns_rdata_s14_q[16] & inside_v_s14_q;
      and_2077_s15_q <= seen_columns_rdata_s14_q[17] & inside_v_s14_q;
      and_2100_s15_q <= and_2100_s14_q;
      equal_2394_s15_q <= equal_2394_s14_q;
      and_2521_s15_q <= and_2521_s14_q;
      and_2545_s15_q <= seen_columns_rdata_s14_q[15] & inside_v_s14_q;
      equal_2606_s15_q <= equal_2606_s14_q;
      difference_2610_s15_q <= difference_2610[7:2];
      sum_2612_s15_q <= sum_2612_s14_q;
      and_2627_s15_q <= and_2627_s14_q;
      select_2636_s15_q <= select_2636_s14_q;
      and_2637_s15_q <= and_2637_s14_q;
      select_2698_s15_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_2923_s15_q <= and_2923_s14_q;
      less_3050_s15_q <= 4'he < patches_column_s14_q[4:1];
      equal_3477_s15_q <= equal_3477_s14_q;
      select_3481_s15_q <= select_3481;
      away_s15_q <= away;
      equal_3483_s15_q <= away == 6'h3f;
      equal_3492_s15_q <= away == 6'h1;
      select_3512_s15_q <= select_3512_s14_q;
      less_3805_s15_q <= less_3805_s14_q;
      sum_3806_s15_q <= sum_3806[7];
      select_3848_s15_q <= sum_1956_s14_q ? (equal_1756_s14_q & or_1958) : or_1958;
      equal_3859_s15_q <= x_s14_q[6:3] == 4'h7;
      equal_3897_s15_q <= x_s14_q[6:3] == 4'h6;
      and_4013_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      equal_4023_s15_q <= equal_4023_s14_q;
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
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_506_s15_q ? sum_514_s15_q[13:5] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_535_s15_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_506_s15_q ? sum_518_s15_q[13:5] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_535_s15_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:207
  logic and_543;
  assign and_543 = and_506_s15_q & and_522_s15_q;
  // hls/stages/census.hpp:127
  logic select_545;
  assign select_545 = equal_535_s15_q ? and_543 : (averager_mask_q & and_543);
  // hls/stages/agreement.hpp:271
  logic whole_2;
  assign whole_2 = sample_pair_whole_s15_q & select_545;
  // hls/stages/census.hpp:207
  logic and_547;
  assign and_547 = and_506_s15_q & and_526_s15_q;
  // hls/stages/census.hpp:127
  logic select_549;
  assign select_549 = equal_535_s15_q ? and_547 : (averager_of_skin_q & and_547);
  // hls/stages/agreement.hpp:809
  logic equal_1489;
  assign equal_1489 = select_1486_s15_q == 3'h1;
  logic or_1492;
  assign or_1492 = equal_1489 | (~(select_1486_s15_q == 3'h2));
  logic [7:0] select_1494;
  assign select_1494 = or_1492 ? before_0_s15_q : before_1_s15_q;
  logic [7:0] select_1495;
  assign select_1495 = equal_1489 ? (or_1492 ? before_1_q : {7'h0, shift_not_right_s15_q}) : select_1494;
  // hls/stages/agreement.hpp:810
  logic [7:0] select_1498;
  assign select_1498 = equal_1489 ? select_1494 : (or_1492 ? before_2_q : before_2_s15_q);
  // hls/stages/agreement.hpp:823
  logic or_1537;
  assign or_1537 = select_1535_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:148
  logic and_1577;
  assign and_1577 = or_609_s15_q & (not_617_s15_q & and_1575_s15_q);
  logic and_1580;
  assign and_1580 = or_609_s15_q & (not_617_s15_q & and_1570_s15_q);
  // hls/stages/agreement.hpp:787
  logic and_1583;
  assign and_1583 = not_1544_s15_q & (so_s15_q ? and_1546_s15_q : (equal_608_s15_q & and_1580));
  // hls/stages/agreement.hpp:1170
  logic [1:0] quarter;
  assign quarter = x_s15_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1122
  logic [1:0] select_1588;
  assign select_1588 = x_s15_q[4] ? {x_s15_q[3], x_s15_q[0]} : {x_s15_q[0], x_s15_q[3]};
  // hls/stages/agreement.hpp:1135
  logic [3:0] select_1590;
  assign select_1590 = equal_1585_s15_q ? {2'h0, quarter} : (all_s15_q ? {1'b0, x_s15_q[2:0]} : {x_s15_q[2:1], select_1588});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1591;
  assign sum_1591 = slot_s15_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:787
  logic [3:0] select_1592;
  assign select_1592 = equal_671_s15_q ? select_1590 : {sum_1591, lower_half_s15_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1593;
  assign equal_1593 = x_s15_q[5:0] == 6'h3f;
  logic equal_1595;
  assign equal_1595 = x_s15_q[5:0] == 6'h3e;
  logic equal_1597;
  assign equal_1597 = x_s15_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1170
  logic and_1615;
  assign and_1615 = (~equal_1593) & ((~equal_1595) & ((~equal_1597) & and_1612_s15_q));
  // hls/stages/agreement.hpp:1122
  logic less_1616;
  assign less_1616 = x_s15_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s15_q ? {1'b0, x_s15_q[2]} : x_s15_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1620;
  assign or_1620 = (kind == 2'h3) | (x_s15_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s15_q ? (right_2_s15_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1631;
  assign sum_1631 = {2'h0, slot_s15_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1637;
  assign not_1637 = ~lower_half_s15_q;
  logic [3:0] select_1638;
  assign select_1638 = registration_of_right_q ? {lower_half_s15_q, 1'b0, not_1637, 1'b0} : {1'b0, lower_half_s15_q, 1'b0, not_1637};
  // hls/stages/patches.hpp:98
  logic less_1697;
  assign less_1697 = {{4{sum_1696_s15_q[10]}}, sum_1696_s15_q, expected_s15_q} < 16'h15;
  // hls/stages/patches.hpp:466
  logic [11:0] sum_1879;
  assign sum_1879 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1880;
  assign sum_1880 = {{4{down_2_s15_q[10]}}, down_2_s15_q[10:2]} + {sum_1879[11], sum_1879};
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_1889_s15_q, sum_1888_s15_q, patches_columns_above_rdata_s15_q} + {4'h0, pixel_2_s15_q};
  // hls/stages/agreement.hpp:787
  logic [5:0] select_1953;
  assign select_1953 = equal_671_s15_q ? x_s15_q[5:0] : {region_row_q, or_1952_s15_q, or_1949_s15_q, or_1946_s15_q};
  // hls/stages/agreement.hpp:1121
  logic not_1954;
  assign not_1954 = ~equal_1585_s15_q;
  // hls/stages/agreement.hpp:257
  logic explained;
  assign explained = inside_v_s15_q & and_1580;
  // hls/stages/agreement.hpp:148
  logic and_1979;
  assign and_1979 = or_609_s15_q & (not_617_s15_q & and_1977_s15_q);
  // hls/stages/agreement.hpp:1007
  logic select_1989;
  assign select_1989 = slot_s15_q[2] ? shown_shown_q : and_1580;
  // hls/stages/agreement.hpp:257
  logic shown;
  assign shown = inside_v_s15_q & (shown_right_rdata_s15_q[0] | select_1989);
  // hls/stages/agreement.hpp:1007
  logic select_1992;
  assign select_1992 = slot_s15_q[2] ? shown_nearer_q : and_1577;
  // hls/stages/agreement.hpp:257
  logic near;
  assign near = inside_v_s15_q & (select_1989 ? select_1992 : shown_right_rdata_s15_q[1]);
  // hls/stages/agreement.hpp:271
  logic [10:0] select_2132;
  assign select_2132 = sample_pair_whole_s15_q ? (and_530_s15_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2134;
  assign select_2134 = sample_pair_whole_s15_q ? (and_530_s15_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2155;
  assign select_2155 = sample_pair_whole_s15_q ? (and_530_s15_q ? select_545 : averager_mask_q) : averager_mask_q;
  logic select_2157;
  assign select_2157 = sample_pair_whole_s15_q ? (and_530_s15_q ? select_549 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:787
  logic and_2525;
  assign and_2525 = not_1544_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_2521_s15_q)));
  // hls/stages/agreement.hpp:1098
  logic not_2544;
  assign not_2544 = ~(x_s15_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1023
  logic and_2547;
  assign and_2547 = seen_columns_rdata_s15_q[6] & inside_v_s15_q;
  logic and_2548;
  assign and_2548 = seen_columns_rdata_s15_q[2] & inside_v_s15_q;
  // hls/stages/agreement.hpp:787
  logic and_2586;
  assign and_2586 = so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & (and_2521_s15_q & and_1979)));
  // hls/stages/agreement.hpp:1103
  logic and_2591;
  assign and_2591 = not_2544 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:148
  logic and_2615;
  assign and_2615 = ((and_1977_s15_q & and_1570_s15_q) & equal_2606_s15_q) & (~({2'h0, difference_2610_s15_q} < sum_2612_s15_q));
  // hls/stages/agreement.hpp:1020
  logic and_2638;
  assign and_2638 = and_1580 & and_2637_s15_q;
  // hls/stages/agreement.hpp:787
  logic and_2642;
  assign and_2642 = so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & (and_2627_s15_q & and_2638)));
  logic and_2648;
  assign and_2648 = ends_cell_s15_q & (inside_v_s15_q & (select_2636_s15_q & and_2638));
  // hls/stages/registration.hpp:108
  logic equal_2681;
  assign equal_2681 = slot_s15_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2698_s15_q[11:7])) ? 12'h7f : select_2698_s15_q;
  // hls/stages/agreement.hpp:787
  logic select_2742;
  assign select_2742 = so_s15_q ? (equal_2681 ? right_2_s15_q : registration_of_right_q) : registration_of_right_q;
  logic select_2745;
  assign select_2745 = so_s15_q ? (equal_1681_s15_q ? inside_v_s15_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1122
  logic [1:0] quarter_2;
  assign quarter_2 = all_s15_q ? x_s15_q[1:0] : select_1588;
  // hls/stages/patches.hpp:184
  logic [10:0] select_3028;
  assign select_3028 = equal_1765_s15_q ? patches_down_values_0_q : (or_1769_s15_q ? down_2_s15_q : patches_down_values_0_q);
  logic [10:0] select_3030;
  assign select_3030 = or_1769_s15_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3032;
  assign select_3032 = equal_1763_s15_q ? patches_down_values_1_q : (equal_1765_s15_q ? patches_down_values_1_q : select_3030);
  // hls/stages/patches.hpp:551
  logic and_3485;
  assign and_3485 = less_1924_s15_q & (equal_3477_s15_q & equal_3483_s15_q);
  // hls/stages/patches.hpp:555
  logic select_3488;
  assign select_3488 = equal_1927_s15_q ? (less_1924_s15_q ? (not_1928_s15_q & and_3485) : and_3485) : and_3485;
  // hls/stages/patches.hpp:551
  logic and_3494;
  assign and_3494 = less_1924_s15_q & (equal_3477_s15_q & equal_3492_s15_q);
  // hls/stages/patches.hpp:555
  logic select_3497;
  assign select_3497 = equal_1927_s15_q ? (less_1924_s15_q ? (not_1928_s15_q & and_3494) : and_3494) : and_3494;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3501;
  assign sum_3501 = {away_s15_q[5], away_s15_q} + 7'h7d;
  // hls/stages/agreement.hpp:787
  logic select_3802;
  assign select_3802 = equal_671_s15_q ? shown_shown_q : (so_s15_q ? select_1989 : shown_shown_q);
  logic select_3804;
  assign select_3804 = equal_671_s15_q ? shown_nearer_q : (so_s15_q ? select_1992 : shown_nearer_q);
  // hls/stages/agreement.hpp:458
  logic [2:0] select_3808;
  assign select_3808 = less_3805_s15_q ? (sum_3806_s15_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3810;
  assign select_3810 = equal_2394_s15_q ? (equal_563_s15_q ? 3'h0 : select_3808) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3806_s15_q;
  // hls/stages/agreement.hpp:458
  logic select_3841;
  assign select_3841 = equal_2394_s15_q ? (equal_563_s15_q | (less_3805_s15_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1209
  logic equal_3878;
  assign equal_3878 = x_s15_q[6:3] == 4'ha;
  logic equal_3882;
  assign equal_3882 = x_s15_q[6:3] == 4'h9;
  logic equal_3883;
  assign equal_3883 = x_s15_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1118
  logic [7:0] select_3899;
  assign select_3899 = equal_3859_s15_q ? cfg_unproven_limit_i : (equal_3897_s15_q ? cfg_explained_limit_i : cfg_regions_limit_i);
  logic [7:0] select_3901;
  assign select_3901 = equal_3882 ? cfg_hidden_limit_i : (equal_3883 ? cfg_unproven_skin_limit_i : select_3899);
  // hls/stages/agreement.hpp:787
  logic select_4011;
  assign select_4011 = so_s15_q ? (ends_cell_s15_q ? and_2029_s15_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4015;
  assign select_4015 = so_s15_q ? (ends_cell_s15_q ? and_4013_s15_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4017;
  assign select_4017 = ends_cell_s15_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4019;
  assign select_4019 = equal_671_s15_q ? centres_values_1_textured_q : (so_s15_q ? select_4017 : centres_values_1_textured_q);
  logic select_4020;
  assign select_4020 = ends_cell_s15_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4022;
  assign select_4022 = equal_671_s15_q ? centres_values_1_of_skin_q : (so_s15_q ? select_4020 : centres_values_1_of_skin_q);

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:762; read in stage 15, written in stage 17: 15 < 17 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1669_s15_q;
  logic patches_choices_re;
  assign patches_choices_re = s15_en & (sample_pair_whole_s15_q & (~equal_1671_s15_q));
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
  assign patches_right_codes_raddr = {select_1866_s15_q, not_1861_s15_q, select_1860_s15_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s15_en & or_1867_s15_q;
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
  assign patches_left_codes_re = s15_en & (not_1764_s15_q & (new_row_s15_q & equal_1765_s15_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1389; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1953;
  logic regions_re;
  assign regions_re = s15_en & (equal_671_s15_q ? (x_s15_q[6] & not_1954) : and_1961_s15_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_500_s15_q;
  logic averager_memory_we;
  assign averager_memory_we = s15_en & and_507_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_526_s15_q, and_522_s15_q, sum_518_s15_q, sum_514_s15_q};
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
      averager_mask_q <= select_2155;
      averager_of_skin_q <= select_2157;
      registration_of_right_q <= equal_671_s15_q ? registration_of_right_q : select_2742;
      registration_was_inside_q <= equal_671_s15_q ? registration_was_inside_q : select_2745;
      patches_down_values_0_q <= equal_1763_s15_q ? patches_down_values_0_q : select_3028;
      patches_down_values_1_q <= select_3032;
      shown_shown_q <= select_3802;
      shown_nearer_q <= select_3804;
      region_row_q <= and_532_s15_q ? select_3810 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_532_s15_q ? select_3841 : region_fresh_q;
      centres_values_0_textured_q <= equal_671_s15_q ? centres_values_0_textured_q : select_4011;
      centres_values_0_of_skin_q <= equal_671_s15_q ? centres_values_0_of_skin_q : select_4015;
      centres_values_1_textured_q <= select_4019;
      centres_values_1_of_skin_q <= select_4022;
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
      averager_total_0_q <= select_2132;
      averager_total_1_q <= select_2134;
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
  logic [3:0] select_493_s16_q;
  logic [6:0] select_496_s16_q;
  logic [6:0] column_s16_q;
  logic and_530_s16_q;
  logic and_532_s16_q;
  logic [77:0] census_memory_rdata_s16_q;
  logic [8:0] grey_s16_q;
  logic equal_535_s16_q;
  logic [8:0] select_538_s16_q;
  logic [8:0] grey_2_s16_q;
  logic [8:0] select_542_s16_q;
  logic whole_2_s16_q;
  logic and_550_s16_q;
  logic equal_554_s16_q;
  logic equal_563_s16_q;
  logic so_s16_q;
  logic equal_671_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1481_s16_q;
  logic [2:0] select_1486_s16_q;
  logic [7:0] select_1495_s16_q;
  logic [7:0] select_1498_s16_q;
  logic [6:0] select_1517_s16_q;
  logic [5:0] select_1519_s16_q;
  logic [7:0] select_1522_s16_q;
  logic [7:0] select_1525_s16_q;
  logic and_1526_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1537_s16_q;
  logic [6:0] select_1542_s16_q;
  logic [6:0] select_1543_s16_q;
  logic not_1544_s16_q;
  logic inside_v_s16_q;
  logic and_1548_s16_q;
  logic [6:0] select_1552_s16_q;
  logic and_1577_s16_q;
  logic and_1583_s16_q;
  logic equal_1585_s16_q;
  logic [1:0] quarter_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1591_s16_q;
  logic [3:0] select_1592_s16_q;
  logic equal_1593_s16_q;
  logic equal_1595_s16_q;
  logic equal_1597_s16_q;
  logic equal_1599_s16_q;
  logic equal_1601_s16_q;
  logic equal_1603_s16_q;
  logic equal_1605_s16_q;
  logic equal_1607_s16_q;
  logic less_1616_s16_q;
  logic or_1620_s16_q;
  logic select_1623_s16_q;
  logic and_1633_s16_q;
  logic [3:0] select_1638_s16_q;
  logic and_1653_s16_q;
  logic select_1670_s16_q;
  logic equal_1671_s16_q;
  logic and_1679_s16_q;
  logic equal_1681_s16_q;
  logic equal_1704_s16_q;
  logic and_1715_s16_q;
  logic [5:0] select_1729_s16_q;
  logic [7:0] select_1754_s16_q;
  logic and_1761_s16_q;
  logic and_1762_s16_q;
  logic equal_1763_s16_q;
  logic equal_1765_s16_q;
  logic equal_1768_s16_q;
  logic or_1769_s16_q;
  logic and_1778_s16_q;
  logic [4:0] select_1793_s16_q;
  logic select_1799_s16_q;
  logic [3:0] select_1838_s16_q;
  logic less_1854_s16_q;
  logic new_row_s16_q;
  logic or_1867_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic [1:0] down_2_s16_q;
  logic [12:0] sum_1880_s16_q;
  logic [11:0] smooth_s16_q;
  logic and_1909_s16_q;
  logic and_1918_s16_q;
  logic and_1923_s16_q;
  logic less_1924_s16_q;
  logic equal_1925_s16_q;
  logic not_1926_s16_q;
  logic equal_1927_s16_q;
  logic [9:0] patches_rows_rdata_s16_q;
  logic or_1946_s16_q;
  logic or_1949_s16_q;
  logic or_1952_s16_q;
  logic not_1954_s16_q;
  logic textured_s16_q;
  logic explained_s16_q;
  logic and_1979_s16_q;
  logic and_1986_s16_q;
  logic [12:0] seen_columns_rdata_s16_q;
  logic shown_s16_q;
  logic near_s16_q;
  logic and_2027_s16_q;
  logic and_2029_s16_q;
  logic or_2044_s16_q;
  logic or_2047_s16_q;
  logic or_2050_s16_q;
  logic and_2061_s16_q;
  logic and_2063_s16_q;
  logic and_2064_s16_q;
  logic and_2077_s16_q;
  logic and_2079_s16_q;
  logic and_2080_s16_q;
  logic and_2100_s16_q;
  logic equal_2394_s16_q;
  logic and_2525_s16_q;
  logic not_2544_s16_q;
  logic and_2545_s16_q;
  logic and_2546_s16_q;
  logic [1:0] sum_2550_s16_q;
  logic and_2587_s16_q;
  logic and_2594_s16_q;
  logic and_2618_s16_q;
  logic and_2642_s16_q;
  logic and_2649_s16_q;
  logic and_2684_s16_q;
  logic and_2685_s16_q;
  logic [11:0] residual_s16_q;
  logic equal_2747_s16_q;
  logic [3:0] not_2748_s16_q;
  logic [1:0] quarter_2_s16_q;
  logic and_2923_s16_q;
  logic less_3050_s16_q;
  logic equal_3393_s16_q;
  logic [4:0] select_3481_s16_q;
  logic select_3488_s16_q;
  logic select_3497_s16_q;
  logic and_3503_s16_q;
  logic [14:0] select_3512_s16_q;
  logic select_3848_s16_q;
  logic equal_3859_s16_q;
  logic equal_3878_s16_q;
  logic equal_3881_s16_q;
  logic equal_3882_s16_q;
  logic equal_3883_s16_q;
  logic [7:0] select_3902_s16_q;
  logic equal_4023_s16_q;
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
      select_493_s16_q <= select_493_s15_q;
      select_496_s16_q <= select_496_s15_q;
      column_s16_q <= column_s15_q;
      and_530_s16_q <= and_530_s15_q;
      and_532_s16_q <= and_532_s15_q;
      census_memory_rdata_s16_q <= census_memory_rdata_q;
      grey_s16_q <= grey;
      equal_535_s16_q <= equal_535_s15_q;
      select_538_s16_q <= sample_pair_whole_s15_q ? total[10:2] : 9'h0;
      grey_2_s16_q <= grey_2;
      select_542_s16_q <= sample_pair_whole_s15_q ? total_2[10:2] : 9'h0;
      whole_2_s16_q <= whole_2;
      and_550_s16_q <= sample_pair_whole_s15_q & select_549;
      equal_554_s16_q <= equal_554_s15_q;
      equal_563_s16_q <= equal_563_s15_q;
      so_s16_q <= so_s15_q;
      equal_671_s16_q <= equal_671_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      of_best_s16_q <= of_best_s15_q;
      or_1481_s16_q <= select_726_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1486_s16_q <= select_1486_s15_q;
      select_1495_s16_q <= select_1495;
      select_1498_s16_q <= select_1498;
      select_1517_s16_q <= select_726_s15_q ? of_near_s15_q : select_1516_s15_q;
      select_1519_s16_q <= select_726_s15_q ? run_shift_s15_q : select_1518_s15_q;
      select_1522_s16_q <= (run_shift_s15_q == 6'h3f) ? of_best_s15_q : select_1521_s15_q;
      select_1525_s16_q <= (run_shift_s15_q == 6'h1) ? of_best_s15_q : select_1524_s15_q;
      and_1526_s16_q <= and_1526_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1537_s16_q <= or_1537;
      select_1542_s16_q <= or_1541_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1543_s16_q <= or_1541_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      not_1544_s16_q <= not_1544_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      and_1548_s16_q <= and_1548_s15_q;
      select_1552_s16_q <= select_1552_s15_q;
      and_1577_s16_q <= and_1577;
      and_1583_s16_q <= and_1583;
      equal_1585_s16_q <= equal_1585_s15_q;
      quarter_s16_q <= quarter;
      all_s16_q <= all_s15_q;
      sum_1591_s16_q <= sum_1591;
      select_1592_s16_q <= select_1592;
      equal_1593_s16_q <= equal_1593;
      equal_1595_s16_q <= equal_1595;
      equal_1597_s16_q <= equal_1597;
      equal_1599_s16_q <= equal_1599_s15_q;
      equal_1601_s16_q <= equal_1601_s15_q;
      equal_1603_s16_q <= equal_1603_s15_q;
      equal_1605_s16_q <= equal_1605_s15_q;
      equal_1607_s16_q <= equal_1607_s15_q;
      less_1616_s16_q <= less_1616;
      or_1620_s16_q <= or_1620;
      select_1623_s16_q <= equal_1585_s15_q ? and_1615 : (less_1616 & (~or_1620));
      and_1633_s16_q <= half_ends & ({{3{sum_1631[4]}}, sum_1631} < 8'h3);
      select_1638_s16_q <= select_1638;
      and_1653_s16_q <= and_1653_s15_q;
      select_1670_s16_q <= select_1670_s15_q;
      equal_1671_s16_q <= equal_1671_s15_q;
      and_1679_s16_q <= and_1679_s15_q;
      equal_1681_s16_q <= equal_1681_s15_q;
      equal_1704_s16_q <= equal_1704_s15_q;
      and_1715_s16_q <= (less_1680_s15_q & (and_1580 & less_1697)) & and_1714_s15_q;
      select_1729_s16_q <= select_1729_s15_q;
      select_1754_s16_q <= select_1754_s15_q;
      and_1761_s16_q <= and_1761_s15_q;
      and_1762_s16_q <= and_1762_s15_q;
      equal_1763_s16_q <= equal_1763_s15_q;
      equal_1765_s16_q <= equal_1765_s15_q;
      equal_1768_s16_q <= equal_1768_s15_q;
      or_1769_s16_q <= or_1769_s15_q;
      and_1778_s16_q <= and_1778_s15_q;
      select_1793_s16_q <= select_1793_s15_q;
      select_1799_s16_q <= select_1799_s15_q;
      select_1838_s16_q <= select_1838_s15_q;
      less_1854_s16_q <= less_1854_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1867_s16_q <= or_1867_s15_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[1:0];
      sum_1880_s16_q <= sum_1880;
      smooth_s16_q <= smooth;
      and_1909_s16_q <= not_1764_s15_q & (not_1766_s15_q & and_1907_s15_q);
      and_1918_s16_q <= and_1918_s15_q;
      and_1923_s16_q <= not_1764_s15_q & (not_1766_s15_q & and_1921_s15_q);
      less_1924_s16_q <= less_1924_s15_q;
      equal_1925_s16_q <= equal_1925_s15_q;
      not_1926_s16_q <= not_1926_s15_q;
      equal_1927_s16_q <= equal_1927_s15_q;
      patches_rows_rdata_s16_q <= patches_rows_rdata_s15_q;
      or_1946_s16_q <= or_1946_s15_q;
      or_1949_s16_q <= or_1949_s15_q;
      or_1952_s16_q <= or_1952_s15_q;
      not_1954_s16_q <= not_1954;
      textured_s16_q <= textured_s15_q;
      explained_s16_q <= explained;
      and_1979_s16_q <= and_1979;
      and_1986_s16_q <= not_1544_s15_q & and_1961_s15_q;
      seen_columns_rdata_s16_q <= seen_columns_rdata_s15_q;
      shown_s16_q <= shown;
      near_s16_q <= near;
      and_2027_s16_q <= and_2027_s15_q;
      and_2029_s16_q <= and_2029_s15_q;
      or_2044_s16_q <= or_2044_s15_q;
      or_2047_s16_q <= or_2047_s15_q;
      or_2050_s16_q <= or_2050_s15_q;
      and_2061_s16_q <= and_2061_s15_q;
      and_2063_s16_q <= seen_columns_rdata_s15_q[7] & inside_v_s15_q;
      and_2064_s16_q <= seen_columns_rdata_s15_q[3] & inside_v_s15_q;
      and_2077_s16_q <= and_2077_s15_q;
      and_2079_s16_q <= seen_columns_rdata_s15_q[8] & inside_v_s15_q;
      and_2080_s16_q <= seen_columns_rdata_s15_q[4] & inside_v_s15_q;
      and_2100_s16_q <= and_2100_s15_q;
      equal_2394_s16_q <= equal_2394_s15_q;
      and_2525_s16_q <= and_2525;
      not_2544_s16_q <= not_2544;
      and_2545_s16_q <= and_2545_s15_q;
      and_2546_s16_q <= seen_columns_rdata_s15_q[10] & inside_v_s15_q;
      sum_2550_s16_q <= {1'b0, and_2547} + ({1'b0, explained} + {1'b0, and_2548});
      and_2587_s16_q <= not_1544_s15_q & and_2586;
      and_2594_s16_q <= not_1544_s15_q & (so_s15_q & (ends_cell_s15_q & and_2591));
      and_2618_s16_q <= inside_v_s15_q & (or_609_s15_q & (not_617_s15_q & and_2615));
      and_2642_s16_q <= and_2642;
      and_2649_s16_q <= so_s15_q & and_2648;
      and_2684_s16_q <= not_1544_s15_q & (so_s15_q & (half_ends & equal_2681));
      and_2685_s16_q <= and_1580 & less_1680_s15_q;
      residual_s16_q <= residual;
      equal_2747_s16_q <= sum_1591 == 2'h2;
      not_2748_s16_q <= ~select_1638;
      quarter_2_s16_q <= quarter_2;
      and_2923_s16_q <= and_2923_s15_q;
      less_3050_s16_q <= less_3050_s15_q;
      equal_3393_s16_q <= patches_match_row_s15_q == 4'h0;
      select_3481_s16_q <= select_3481_s15_q;
      select_3488_s16_q <= select_3488;
      select_3497_s16_q <= select_3497;
      and_3503_s16_q <= equal_3477_s15_q & ({sum_3501[6], sum_3501} < 8'hfb);
      select_3512_s16_q <= select_3512_s15_q;
      select_3848_s16_q <= select_3848_s15_q;
      equal_3859_s16_q <= equal_3859_s15_q;
      equal_3878_s16_q <= equal_3878;
      equal_3881_s16_q <= x_s15_q[6:3] == 4'hb;
      equal_3882_s16_q <= equal_3882;
      equal_3883_s16_q <= equal_3883;
      select_3902_s16_q <= equal_3878 ? cfg_regions_limit_i : select_3901;
      equal_4023_s16_q <= equal_4023_s15_q;
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
  logic census_columns_values_0_cell_3_mask_q;
  logic [8:0] census_columns_values_0_cell_4_left_q;
  logic census_columns_values_0_cell_4_mask_q;
  logic [8:0] census_columns_values_1_cell_0_left_q;
  logic [8:0] census_columns_values_1_cell_0_right_q;
  logic [8:0] census_columns_values_1_cell_1_left_q;
  logic [8:0] census_columns_values_1_cell_1_right_q;
  logic [8:0] census_columns_values_1_cell_2_left_q;
  logic [8:0] census_columns_values_1_cell_2_right_q;
  logic census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] census_columns_values_1_cell_3_left_q;
  logic [8:0] census_columns_values_1_cell_4_left_q;
  logic [8:0] census_columns_values_2_cell_0_left_q;
  logic [8:0] census_columns_values_2_cell_0_right_q;
  logic [8:0] census_columns_values_2_cell_1_left_q;
  logic [8:0] census_columns_values_2_cell_1_right_q;
  logic [8:0] census_columns_values_2_cell_2_left_q;
  logic [8:0] census_columns_values_2_cell_3_left_q;
  logic [8:0] census_columns_values_2_cell_4_left_q;
  logic [8:0] census_columns_values_3_cell_1_left_q;
  logic [8:0] census_columns_values_3_cell_1_right_q;
  logic [8:0] census_columns_values_3_cell_3_left_q;
  logic [3:0] census_filled_q;
  logic [13:0] moments_place_q;
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
  // hls/stages/moments.hpp:45
  logic [13:0] sum_555;
  assign sum_555 = moments_place_q + 14'h1;
  logic [13:0] select_557;
  assign select_557 = equal_554_s16_q ? 14'h0 : sum_555;
  // hls/stages/agreement.hpp:450
  logic equal_562;
  assign equal_562 = column_s16_q == 7'h0;
  logic [3:0] select_564;
  assign select_564 = equal_563_s16_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:451
  logic [4:0] select_565;
  assign select_565 = equal_562 ? {select_564, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:281
  logic [3:0] select_566;
  assign select_566 = equal_562 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:310
  logic [9:0] difference_568;
  assign difference_568 = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:291
  logic and_577;
  assign and_577 = census_memory_rdata_s16_q[38] & (census_memory_rdata_s16_q[18] & whole_2_s16_q);
  logic and_579;
  assign and_579 = census_memory_rdata_s16_q[77] & (census_memory_rdata_s16_q[58] & and_577);
  // hls/stages/census.hpp:299
  logic less_622;
  assign less_622 = census_memory_rdata_s16_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_623;
  assign less_623 = census_memory_rdata_s16_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_624;
  assign less_624 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_625;
  assign less_625 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_626;
  assign less_626 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_627;
  assign less_627 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_628;
  assign less_628 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_629;
  assign less_629 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_630;
  assign less_630 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_631;
  assign less_631 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_632;
  assign less_632 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_633;
  assign less_633 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:300
  logic less_634;
  assign less_634 = census_memory_rdata_s16_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_636;
  assign less_636 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_639;
  assign less_639 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_641;
  assign less_641 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_644;
  assign less_644 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:275
  logic [9:0] difference_647;
  assign difference_647 = {1'b0, select_538_s16_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_650;
  assign difference_650 = {1'b0, census_memory_rdata_s16_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_654;
  assign difference_654 = {1'b0, census_memory_rdata_s16_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_658;
  assign difference_658 = {1'b0, census_memory_rdata_s16_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_662;
  assign difference_662 = {1'b0, census_memory_rdata_s16_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/agreement.hpp:200
  logic not_1553;
  assign not_1553 = ~so_s16_q;
  // hls/stages/agreement.hpp:787
  logic and_1578;
  assign and_1578 = not_1553 & and_1577_s16_q;
  logic and_1634;
  assign and_1634 = so_s16_q & and_1633_s16_q;
  logic and_1719;
  assign and_1719 = not_1544_s16_q & (so_s16_q & (ends_cell_s16_q & (inside_v_s16_q & and_1715_s16_q)));
  logic [7:0] select_1724;
  assign select_1724 = so_s16_q ? (ends_cell_s16_q ? (inside_v_s16_q ? x_s16_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:466
  logic [13:0] sum_1881;
  assign sum_1881 = {{3{patches_down_values_1_s16_q[10]}}, patches_down_values_1_s16_q} + {sum_1880_s16_q, down_2_s16_q[1]};
  logic [12:0] sum_1882;
  assign sum_1882 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1881[13:1];
  // hls/stages/patches.hpp:465
  logic [12:0] sum_1891;
  assign sum_1891 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s16_q[11:1]};
  logic [12:0] sum_1892;
  assign sum_1892 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1893;
  assign difference_1893 = {1'b0, sum_1891, smooth_s16_q[0]} - {1'b0, sum_1892, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:257
  logic and_1988;
  assign and_1988 = inside_v_s16_q & and_1979_s16_q;
  // hls/stages/agreement.hpp:1023
  logic and_2030;
  assign and_2030 = seen_columns_rdata_s16_q[0] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1080
  logic [1:0] sum_2032;
  assign sum_2032 = {1'b0, and_2029_s16_q} + ({1'b0, textured_s16_q} + {1'b0, and_2030});
  // hls/stages/agreement.hpp:1023
  logic and_2062;
  assign and_2062 = seen_columns_rdata_s16_q[11] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1082
  logic [1:0] sum_2066;
  assign sum_2066 = {1'b0, and_2063_s16_q} + ({1'b0, shown_s16_q} + {1'b0, and_2064_s16_q});
  // hls/stages/agreement.hpp:1023
  logic and_2078;
  assign and_2078 = seen_columns_rdata_s16_q[12] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1083
  logic [1:0] sum_2082;
  assign sum_2082 = {1'b0, and_2079_s16_q} + ({1'b0, near_s16_q} + {1'b0, and_2080_s16_q});
  // hls/stages/agreement.hpp:271
  logic [8:0] select_2124;
  assign select_2124 = sample_pair_whole_s16_q ? (and_530_s16_q ? grey_s16_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2126;
  assign select_2126 = sample_pair_whole_s16_q ? (and_530_s16_q ? grey_2_s16_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2128;
  assign select_2128 = sample_pair_whole_s16_q ? (and_530_s16_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2130;
  assign select_2130 = sample_pair_whole_s16_q ? (and_530_s16_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2135;
  assign sum_2135 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s16_q};
  logic [9:0] sum_2143;
  assign sum_2143 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s16_q};
  // hls/stages/agreement.hpp:518
  logic [8:0] select_2158;
  assign select_2158 = and_532_s16_q ? select_538_s16_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2159;
  assign select_2159 = and_532_s16_q ? select_542_s16_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2161;
  assign select_2161 = and_532_s16_q ? census_memory_rdata_s16_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2162;
  assign select_2162 = and_532_s16_q ? census_memory_rdata_s16_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2163;
  assign select_2163 = and_532_s16_q ? census_memory_rdata_s16_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2164;
  assign select_2164 = and_532_s16_q ? census_memory_rdata_s16_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2165;
  assign select_2165 = and_532_s16_q ? census_memory_rdata_s16_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2166;
  assign select_2166 = and_532_s16_q ? census_memory_rdata_s16_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2167;
  assign select_2167 = and_532_s16_q ? census_memory_rdata_s16_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2168;
  assign select_2168 = and_532_s16_q ? census_memory_rdata_s16_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic select_2170;
  assign select_2170 = and_532_s16_q ? census_memory_rdata_s16_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2171;
  assign select_2171 = and_532_s16_q ? census_memory_rdata_s16_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic select_2173;
  assign select_2173 = and_532_s16_q ? census_memory_rdata_s16_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2174;
  assign select_2174 = and_532_s16_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2175;
  assign select_2175 = and_532_s16_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2177;
  assign select_2177 = and_532_s16_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2178;
  assign select_2178 = and_532_s16_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2180;
  assign select_2180 = and_532_s16_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2181;
  assign select_2181 = and_532_s16_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2183;
  assign select_2183 = and_532_s16_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2184;
  assign select_2184 = and_532_s16_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2187;
  assign select_2187 = and_532_s16_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2190;
  assign select_2190 = and_532_s16_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2191;
  assign select_2191 = and_532_s16_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2193;
  assign select_2193 = and_532_s16_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2194;
  assign select_2194 = and_532_s16_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2196;
  assign select_2196 = and_532_s16_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2199;
  assign select_2199 = and_532_s16_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_532_s16_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2206;
  assign select_2206 = and_532_s16_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2207;
  assign select_2207 = and_532_s16_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2210;
  assign select_2210 = and_532_s16_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  // hls/stages/census.hpp:277
  logic [9:0] difference_2215;
  assign difference_2215 = {1'b0, select_542_s16_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2218;
  assign difference_2218 = {1'b0, census_memory_rdata_s16_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2222;
  assign difference_2222 = {1'b0, census_memory_rdata_s16_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  // hls/stages/census.hpp:364
  logic [9:0] difference_2291;
  assign difference_2291 = {1'b0, select_538_s16_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2303;
  assign difference_2303 = {1'b0, select_542_s16_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:518
  logic and_2519;
  assign and_2519 = and_532_s16_q & (equal_563_s16_q & equal_2394_s16_q);
  // hls/stages/agreement.hpp:787
  logic and_2530;
  assign and_2530 = not_1544_s16_q & (so_s16_q & (ends_cell_s16_q & textured_s16_q));
  // hls/stages/agreement.hpp:1081
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2545_s16_q} + ({2'h0, and_2546_s16_q} + {1'b0, sum_2550_s16_q});
  // hls/stages/agreement.hpp:925
  logic [13:0] select_2589;
  assign select_2589 = and_2519 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2587_s16_q});
  logic [13:0] select_2596;
  assign select_2596 = and_2519 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2594_s16_q});
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2719;
  assign difference_2719 = 13'h0 - {residual_s16_q[11], residual_s16_q};
  logic less_2734;
  assign less_2734 = $signed(difference_2719) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2750;
  assign select_2750 = equal_2747_s16_q ? (registration_fresh_q & not_2748_s16_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:787
  logic [3:0] select_2752;
  assign select_2752 = so_s16_q ? (and_1633_s16_q ? select_2750 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2754;
  assign select_2754 = and_2519 ? 4'hf : (equal_671_s16_q ? registration_fresh_q : select_2752);
  // hls/stages/registration.hpp:258
  logic not_2775;
  assign not_2775 = ~quarter_2_s16_q[1];
  logic [3:0] select_2776;
  assign select_2776 = quarter_2_s16_q[0] ? {quarter_2_s16_q[1], 1'b0, not_2775, 1'b0} : {1'b0, quarter_2_s16_q[1], 1'b0, not_2775};
  // hls/stages/patches.hpp:184
  logic [11:0] select_3016;
  assign select_3016 = equal_1765_s16_q ? patches_smooth_values_0_q : (or_1769_s16_q ? smooth_s16_q : patches_smooth_values_0_q);
  logic [11:0] select_3018;
  assign select_3018 = or_1769_s16_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3020;
  assign select_3020 = equal_1763_s16_q ? patches_smooth_values_1_q : (equal_1765_s16_q ? patches_smooth_values_1_q : select_3018);
  logic [11:0] select_3021;
  assign select_3021 = or_1769_s16_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3023;
  assign select_3023 = equal_1763_s16_q ? patches_smooth_values_2_q : (equal_1765_s16_q ? patches_smooth_values_2_q : select_3021);
  logic [11:0] select_3024;
  assign select_3024 = or_1769_s16_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3026;
  assign select_3026 = equal_1763_s16_q ? patches_smooth_values_3_q : (equal_1765_s16_q ? patches_smooth_values_3_q : select_3024);
  logic [10:0] select_3033;
  assign select_3033 = or_1769_s16_q ? patches_down_values_1_s16_q : patches_down_values_2_q;
  logic [10:0] select_3035;
  assign select_3035 = equal_1763_s16_q ? patches_down_values_2_q : (equal_1765_s16_q ? patches_down_values_2_q : select_3033);
  logic [10:0] select_3036;
  assign select_3036 = or_1769_s16_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3038;
  assign select_3038 = equal_1763_s16_q ? patches_down_values_3_q : (equal_1765_s16_q ? patches_down_values_3_q : select_3036);
  // hls/stages/patches.hpp:555
  logic select_3490;
  assign select_3490 = less_1924_s16_q ? (not_1926_s16_q & select_3488_s16_q) : select_3488_s16_q;
  logic select_3499;
  assign select_3499 = less_1924_s16_q ? (not_1926_s16_q & select_3497_s16_q) : select_3497_s16_q;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3505;
  assign select_3505 = less_1924_s16_q ? (and_3503_s16_q ? patches_rows_rdata_s16_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3516;
  assign select_3516 = patches_read_above_q ? patches_read_row_differing_s16_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3518;
  assign select_3518 = patches_read_below_q ? patches_read_row_differing_s16_q : patches_peak_below_q;
  // hls/stages/patches.hpp:574
  logic less_3555;
  assign less_3555 = select_3516 < select_3518;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_3555 ? select_3518 : select_3516;
  logic [9:0] low;
  assign low = (select_3518 < select_3516) ? select_3518 : select_3516;
  // hls/stages/agreement.hpp:1215
  logic equal_3633;
  assign equal_3633 = x_s16_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:204
  logic or_3846;
  assign or_3846 = segment_starts_q | not_1553;
  // hls/stages/agreement.hpp:787
  logic select_3850;
  assign select_3850 = ends_cell_s16_q ? (inside_v_s16_q ? select_3848_s16_q : or_3846) : or_3846;
  // hls/stages/agreement.hpp:1209
  logic equal_3880;
  assign equal_3880 = x_s16_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1118
  logic [7:0] select_3903;
  assign select_3903 = equal_3881_s16_q ? {cfg_on_skin_limit_i, 3'h0} : select_3902_s16_q;
  logic [7:0] limit;
  assign limit = equal_3880 ? cfg_regions_limit_i : select_3903;
  // hls/stages/agreement.hpp:1223
  logic not_3905;
  assign not_3905 = ~x_s16_q[2];
  logic [3:0] select_3906;
  assign select_3906 = x_s16_q[1] ? {x_s16_q[2], 1'b0, not_3905, 1'b0} : {1'b0, x_s16_q[2], 1'b0, not_3905};
  logic [7:0] select_3907;
  assign select_3907 = x_s16_q[0] ? {select_3906[3], 1'b0, select_3906[2], 1'b0, select_3906[1], 1'b0, select_3906[0], 1'b0} : {1'b0, select_3906[3], 1'b0, select_3906[2], 1'b0, select_3906[1], 1'b0, select_3906[0]};
  // hls/stages/agreement.hpp:1118
  logic [13:0] select_3911;
  assign select_3911 = equal_3882_s16_q ? counts_skin_supervised_q : (equal_3883_s16_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3913;
  assign select_3913 = equal_3881_s16_q ? counts_skin_textured_q : (equal_3878_s16_q ? counts_textured_q : select_3911);
  logic [13:0] of;
  assign of = equal_3880 ? counts_textured_q : select_3913;
  // hls/stages/registration.hpp:258
  logic not_4116;
  assign not_4116 = ~quarter_s16_q[1];
  logic [3:0] select_4117;
  assign select_4117 = quarter_s16_q[0] ? {quarter_s16_q[1], 1'b0, not_4116, 1'b0} : {1'b0, quarter_s16_q[1], 1'b0, not_4116};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 16, written in stage 20: 16 < 20 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1592_s16_q;
  logic registration_sums_re;
  assign registration_sums_re = s16_en & (equal_671_s16_q ? (x_s16_q[6] & select_1623_s16_q) : and_1634);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s16_q;
  logic census_memory_we;
  assign census_memory_we = s16_en & and_532_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s16_q[58:40], census_memory_rdata_s16_q[38:0], and_550_s16_q, whole_2_s16_q, select_542_s16_q, select_538_s16_q};
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
  assign shown_right_waddr = select_1552_s16_q;
  logic shown_right_we;
  assign shown_right_we = s16_en & and_1583_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1578, not_1553};
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
  assign seen_columns_we = s16_en & and_1548_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s16_q, near_s16_q, shown_s16_q, explained_s16_q, and_1988, textured_s16_q};
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
      moments_place_q <= 14'h0;
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
      census_filled_q <= and_532_s16_q ? {select_566[2:0], 1'b1} : census_filled_q;
      moments_place_q <= and_532_s16_q ? select_557 : moments_place_q;
      rows_passed_above_q <= and_532_s16_q ? select_565 : rows_passed_above_q;
      counts_textured_q <= and_2519 ? 14'h0 : (counts_textured_q + {13'h0, and_2530});
      counts_skin_supervised_q <= select_2589;
      counts_skin_textured_q <= select_2596;
      registration_fresh_q <= select_2754;
      patches_smooth_values_0_q <= equal_1763_s16_q ? patches_smooth_values_0_q : select_3016;
      patches_smooth_values_1_q <= select_3020;
      patches_smooth_values_2_q <= select_3023;
      patches_smooth_values_3_q <= select_3026;
      patches_down_values_2_q <= select_3035;
      patches_down_values_3_q <= select_3038;
      patches_read_above_q <= equal_1763_s16_q ? select_3490 : patches_read_above_q;
      patches_read_below_q <= equal_1763_s16_q ? select_3499 : patches_read_below_q;
      patches_peak_above_q <= equal_1763_s16_q ? select_3516 : patches_peak_above_q;
      patches_peak_below_q <= equal_1763_s16_q ? select_3518 : patches_peak_below_q;
      segment_starts_q <= equal_671_s16_q ? or_3846 : (so_s16_q ? select_3850 : or_3846);
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
    census_columns_values_0_cell_3_mask_q = 1'b0;
    census_columns_values_0_cell_4_left_q = 9'h0;
    census_columns_values_0_cell_4_mask_q = 1'b0;
    census_columns_values_1_cell_0_left_q = 9'h0;
    census_columns_values_1_cell_0_right_q = 9'h0;
    census_columns_values_1_cell_1_left_q = 9'h0;
    census_columns_values_1_cell_1_right_q = 9'h0;
    census_columns_values_1_cell_2_left_q = 9'h0;
    census_columns_values_1_cell_2_right_q = 9'h0;
    census_columns_values_1_cell_2_of_skin_q = 1'b0;
    census_columns_values_1_cell_3_left_q = 9'h0;
    census_columns_values_1_cell_4_left_q = 9'h0;
    census_columns_values_2_cell_0_left_q = 9'h0;
    census_columns_values_2_cell_0_right_q = 9'h0;
    census_columns_values_2_cell_1_left_q = 9'h0;
    census_columns_values_2_cell_1_right_q = 9'h0;
    census_columns_values_2_cell_2_left_q = 9'h0;
    census_columns_values_2_cell_3_left_q = 9'h0;
    census_columns_values_2_cell_4_left_q = 9'h0;
    census_columns_values_3_cell_1_left_q = 9'h0;
    census_columns_values_3_cell_1_right_q = 9'h0;
    census_columns_values_3_cell_3_left_q = 9'h0;
    sharpness_last_mean_0_q = 9'h0;
    sharpness_last_mean_1_q = 9'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s16_en) begin
      averager_quarter_1_0_q <= select_2124;
      averager_quarter_1_1_q <= select_2126;
      averager_quarter_2_0_q <= select_2128;
      averager_quarter_2_1_q <= select_2130;
      census_columns_values_0_cell_0_left_q <= select_2158;
      census_columns_values_0_cell_0_right_q <= select_2159;
      census_columns_values_0_cell_1_left_q <= select_2161;
      census_columns_values_0_cell_1_right_q <= select_2162;
      census_columns_values_0_cell_1_mask_q <= select_2163;
      census_columns_values_0_cell_2_left_q <= select_2164;
      census_columns_values_0_cell_2_right_q <= select_2165;
      census_columns_values_0_cell_2_mask_q <= select_2166;
      census_columns_values_0_cell_2_of_skin_q <= select_2167;
      census_columns_values_0_cell_3_left_q <= select_2168;
      census_columns_values_0_cell_3_mask_q <= select_2170;
      census_columns_values_0_cell_4_left_q <= select_2171;
      census_columns_values_0_cell_4_mask_q <= select_2173;
      census_columns_values_1_cell_0_left_q <= select_2174;
      census_columns_values_1_cell_0_right_q <= select_2175;
      census_columns_values_1_cell_1_left_q <= select_2177;
      census_columns_values_1_cell_1_right_q <= select_2178;
      census_columns_values_1_cell_2_left_q <= select_2180;
      census_columns_values_1_cell_2_right_q <= select_2181;
      census_columns_values_1_cell_2_of_skin_q <= select_2183;
      census_columns_values_1_cell_3_left_q <= select_2184;
      census_columns_values_1_cell_4_left_q <= select_2187;
      census_columns_values_2_cell_0_left_q <= select_2190;
      census_columns_values_2_cell_0_right_q <= select_2191;
      census_columns_values_2_cell_1_left_q <= select_2193;
      census_columns_values_2_cell_1_right_q <= select_2194;
      census_columns_values_2_cell_2_left_q <= select_2196;
      census_columns_values_2_cell_3_left_q <= select_2199;
      census_columns_values_2_cell_4_left_q <= select_2202;
      census_columns_values_3_cell_1_left_q <= select_2206;
      census_columns_values_3_cell_1_right_q <= select_2207;
      census_columns_values_3_cell_3_left_q <= select_2210;
      sharpness_last_mean_0_q <= and_532_s16_q ? select_538_s16_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_532_s16_q ? select_542_s16_q : sharpness_last_mean_1_q;
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
  logic [8:0] census_columns_values_0_cell_2_right_s17_q;
  logic census_columns_values_0_cell_2_mask_s17_q;
  logic census_columns_values_0_cell_3_mask_s17_q;
  logic census_columns_values_0_cell_4_mask_s17_q;
  logic [8:0] census_columns_values_1_cell_2_right_s17_q;
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
  logic [3:0] select_493_s17_q;
  logic [6:0] select_496_s17_q;
  logic [6:0] column_s17_q;
  logic and_530_s17_q;
  logic and_532_s17_q;
  logic [17:0] census_memory_rdata_s17_q;
  logic equal_535_s17_q;
  logic whole_2_s17_q;
  logic equal_554_s17_q;
  logic [12:0] select_556_s17_q;
  logic [10:0] select_557_s17_q;
  logic and_567_s17_q;
  logic [9:0] select_569_s17_q;
  logic and_579_s17_q;
  logic so_s17_q;
  logic less_622_s17_q;
  logic less_623_s17_q;
  logic less_624_s17_q;
  logic less_625_s17_q;
  logic less_626_s17_q;
  logic less_627_s17_q;
  logic less_628_s17_q;
  logic less_629_s17_q;
  logic less_630_s17_q;
  logic less_631_s17_q;
  logic less_632_s17_q;
  logic less_633_s17_q;
  logic less_634_s17_q;
  logic less_636_s17_q;
  logic less_639_s17_q;
  logic less_641_s17_q;
  logic less_644_s17_q;
  logic difference_647_s17_q;
  logic [8:0] xor_648_s17_q;
  logic difference_650_s17_q;
  logic [8:0] xor_651_s17_q;
  logic difference_654_s17_q;
  logic [8:0] xor_655_s17_q;
  logic difference_658_s17_q;
  logic [8:0] xor_659_s17_q;
  logic difference_662_s17_q;
  logic [8:0] xor_663_s17_q;
  logic equal_671_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1482_s17_q;
  logic [2:0] select_1487_s17_q;
  logic [7:0] select_1488_s17_q;
  logic [7:0] select_1496_s17_q;
  logic [7:0] select_1499_s17_q;
  logic [6:0] select_1517_s17_q;
  logic [5:0] select_1519_s17_q;
  logic [7:0] select_1522_s17_q;
  logic [7:0] select_1525_s17_q;
  logic and_1526_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1538_s17_q;
  logic [6:0] select_1539_s17_q;
  logic [6:0] select_1542_s17_q;
  logic [6:0] select_1543_s17_q;
  logic not_1544_s17_q;
  logic equal_1585_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1591_s17_q;
  logic equal_1593_s17_q;
  logic equal_1595_s17_q;
  logic equal_1597_s17_q;
  logic equal_1599_s17_q;
  logic equal_1601_s17_q;
  logic equal_1603_s17_q;
  logic equal_1605_s17_q;
  logic equal_1607_s17_q;
  logic less_1616_s17_q;
  logic or_1620_s17_q;
  logic equal_1640_s17_q;
  logic and_1650_s17_q;
  logic and_1653_s17_q;
  logic select_1670_s17_q;
  logic equal_1671_s17_q;
  logic [22:0] patches_choices_rdata_s17_q;
  logic and_1679_s17_q;
  logic equal_1681_s17_q;
  logic equal_1704_s17_q;
  logic and_1719_s17_q;
  logic [7:0] select_1725_s17_q;
  logic [5:0] select_1729_s17_q;
  logic [7:0] select_1754_s17_q;
  logic and_1761_s17_q;
  logic and_1762_s17_q;
  logic equal_1763_s17_q;
  logic equal_1765_s17_q;
  logic equal_1768_s17_q;
  logic or_1769_s17_q;
  logic and_1778_s17_q;
  logic [4:0] select_1793_s17_q;
  logic select_1799_s17_q;
  logic [3:0] select_1838_s17_q;
  logic less_1854_s17_q;
  logic new_row_s17_q;
  logic or_1867_s17_q;
  logic [27:0] patches_right_codes_rdata_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic down_2_s17_q;
  logic sum_1881_s17_q;
  logic [12:0] sum_1882_s17_q;
  logic [14:0] difference_1893_s17_q;
  logic and_1909_s17_q;
  logic [47:0] patches_left_codes_rdata_s17_q;
  logic and_1918_s17_q;
  logic and_1923_s17_q;
  logic less_1924_s17_q;
  logic equal_1925_s17_q;
  logic not_1926_s17_q;
  logic equal_1927_s17_q;
  logic or_1946_s17_q;
  logic or_1949_s17_q;
  logic or_1952_s17_q;
  logic not_1954_s17_q;
  logic [29:0] regions_rdata_s17_q;
  logic textured_s17_q;
  logic explained_s17_q;
  logic and_1981_s17_q;
  logic and_1986_s17_q;
  logic and_2027_s17_q;
  logic and_2028_s17_q;
  logic [1:0] sum_2032_s17_q;
  logic or_2044_s17_q;
  logic or_2047_s17_q;
  logic or_2050_s17_q;
  logic and_2061_s17_q;
  logic [2:0] sum_2067_s17_q;
  logic and_2077_s17_q;
  logic [2:0] sum_2083_s17_q;
  logic and_2100_s17_q;
  logic sum_2135_s17_q;
  logic [9:0] difference_2136_s17_q;
  logic sum_2143_s17_q;
  logic [9:0] difference_2144_s17_q;
  logic difference_2215_s17_q;
  logic [8:0] xor_2216_s17_q;
  logic difference_2218_s17_q;
  logic [8:0] xor_2219_s17_q;
  logic difference_2222_s17_q;
  logic [8:0] xor_2223_s17_q;
  logic difference_2291_s17_q;
  logic [8:0] xor_2292_s17_q;
  logic difference_2303_s17_q;
  logic [8:0] xor_2304_s17_q;
  logic equal_2394_s17_q;
  logic and_2519_s17_q;
  logic and_2525_s17_q;
  logic and_2530_s17_q;
  logic not_2544_s17_q;
  logic [2:0] explained_2_s17_q;
  logic and_2621_s17_q;
  logic and_2643_s17_q;
  logic and_2650_s17_q;
  logic and_2684_s17_q;
  logic and_2685_s17_q;
  logic [7:0] residual_s17_q;
  logic less_2720_s17_q;
  logic less_2734_s17_q;
  logic equal_2778_s17_q;
  logic and_2923_s17_q;
  logic less_3050_s17_q;
  logic equal_3393_s17_q;
  logic [4:0] select_3481_s17_q;
  logic [9:0] select_3505_s17_q;
  logic [14:0] select_3512_s17_q;
  logic less_3555_s17_q;
  logic [9:0] high_s17_q;
  logic [9:0] low_s17_q;
  logic equal_3633_s17_q;
  logic and_3860_s17_q;
  logic equal_3878_s17_q;
  logic equal_3880_s17_q;
  logic equal_3881_s17_q;
  logic equal_3882_s17_q;
  logic equal_3883_s17_q;
  logic equal_3909_s17_q;
  logic [13:0] of_s17_q;
  logic equal_4023_s17_q;
  logic equal_4119_s17_q;
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
      census_columns_values_0_cell_2_right_s17_q <= census_columns_values_0_cell_2_right_q;
      census_columns_values_0_cell_2_mask_s17_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s17_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s17_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_right_s17_q <= census_columns_values_1_cell_2_right_q;
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
      select_493_s17_q <= select_493_s16_q;
      select_496_s17_q <= select_496_s16_q;
      column_s17_q <= column_s16_q;
      and_530_s17_q <= and_530_s16_q;
      and_532_s17_q <= and_532_s16_q;
      census_memory_rdata_s17_q <= {census_memory_rdata_s16_q[76:68], census_memory_rdata_s16_q[57:49]};
      equal_535_s17_q <= equal_535_s16_q;
      whole_2_s17_q <= whole_2_s16_q;
      equal_554_s17_q <= equal_554_s16_q;
      select_556_s17_q <= equal_554_s16_q ? 13'h0 : sum_555[12:0];
      select_557_s17_q <= select_557[13:3];
      and_567_s17_q <= select_565[4] & select_566[3];
      select_569_s17_q <= census_columns_values_0_cell_2_mask_q ? difference_568 : 10'h0;
      and_579_s17_q <= and_579;
      so_s17_q <= so_s16_q;
      less_622_s17_q <= less_622;
      less_623_s17_q <= less_623;
      less_624_s17_q <= less_624;
      less_625_s17_q <= less_625;
      less_626_s17_q <= less_626;
      less_627_s17_q <= less_627;
      less_628_s17_q <= less_628;
      less_629_s17_q <= less_629;
      less_630_s17_q <= less_630;
      less_631_s17_q <= less_631;
      less_632_s17_q <= less_632;
      less_633_s17_q <= less_633;
      less_634_s17_q <= less_634;
      less_636_s17_q <= less_636;
      less_639_s17_q <= less_639;
      less_641_s17_q <= less_641;
      less_644_s17_q <= less_644;
      difference_647_s17_q <= difference_647[9];
      xor_648_s17_q <= difference_647[8:0] ^ {9{difference_647[9]}};
      difference_650_s17_q <= difference_650[9];
      xor_651_s17_q <= difference_650[8:0] ^ {9{difference_650[9]}};
      difference_654_s17_q <= difference_654[9];
      xor_655_s17_q <= difference_654[8:0] ^ {9{difference_654[9]}};
      difference_658_s17_q <= difference_658[9];
      xor_659_s17_q <= difference_658[8:0] ^ {9{difference_658[9]}};
      difference_662_s17_q <= difference_662[9];
      xor_663_s17_q <= difference_662[8:0] ^ {9{difference_662[9]}};
      equal_671_s17_q <= equal_671_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1482_s17_q <= or_1481_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1487_s17_q <= or_1481_s16_q ? select_1486_s16_q : best_left_rdata_s16_q[8:6];
      select_1488_s17_q <= or_1481_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1496_s17_q <= or_1481_s16_q ? select_1495_s16_q : best_left_rdata_s16_q[24:17];
      select_1499_s17_q <= or_1481_s16_q ? select_1498_s16_q : best_left_rdata_s16_q[32:25];
      select_1517_s17_q <= select_1517_s16_q;
      select_1519_s17_q <= select_1519_s16_q;
      select_1522_s17_q <= select_1522_s16_q;
      select_1525_s17_q <= select_1525_s16_q;
      and_1526_s17_q <= and_1526_s16_q;
      right_s17_q <= right_s16_q;
      select_1538_s17_q <= or_1537_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1539_s17_q <= or_1537_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1542_s17_q <= select_1542_s16_q;
      select_1543_s17_q <= select_1543_s16_q;
      not_1544_s17_q <= not_1544_s16_q;
      equal_1585_s17_q <= equal_1585_s16_q;
      all_s17_q <= all_s16_q;
      sum_1591_s17_q <= sum_1591_s16_q;
      equal_1593_s17_q <= equal_1593_s16_q;
      equal_1595_s17_q <= equal_1595_s16_q;
      equal_1597_s17_q <= equal_1597_s16_q;
      equal_1599_s17_q <= equal_1599_s16_q;
      equal_1601_s17_q <= equal_1601_s16_q;
      equal_1603_s17_q <= equal_1603_s16_q;
      equal_1605_s17_q <= equal_1605_s16_q;
      equal_1607_s17_q <= equal_1607_s16_q;
      less_1616_s17_q <= less_1616_s16_q;
      or_1620_s17_q <= or_1620_s16_q;
      equal_1640_s17_q <= (registration_fresh_q & select_1638_s16_q) == 4'h0;
      and_1650_s17_q <= not_1544_s16_q & and_1634;
      and_1653_s17_q <= and_1653_s16_q;
      select_1670_s17_q <= select_1670_s16_q;
      equal_1671_s17_q <= equal_1671_s16_q;
      patches_choices_rdata_s17_q <= patches_choices_rdata_q;
      and_1679_s17_q <= and_1679_s16_q;
      equal_1681_s17_q <= equal_1681_s16_q;
      equal_1704_s17_q <= equal_1704_s16_q;
      and_1719_s17_q <= and_1719;
      select_1725_s17_q <= equal_671_s16_q ? 8'h0 : select_1724;
      select_1729_s17_q <= select_1729_s16_q;
      select_1754_s17_q <= select_1754_s16_q;
      and_1761_s17_q <= and_1761_s16_q;
      and_1762_s17_q <= and_1762_s16_q;
      equal_1763_s17_q <= equal_1763_s16_q;
      equal_1765_s17_q <= equal_1765_s16_q;
      equal_1768_s17_q <= equal_1768_s16_q;
      or_1769_s17_q <= or_1769_s16_q;
      and_1778_s17_q <= and_1778_s16_q;
      select_1793_s17_q <= select_1793_s16_q;
      select_1799_s17_q <= select_1799_s16_q;
      select_1838_s17_q <= select_1838_s16_q;
      less_1854_s17_q <= less_1854_s16_q;
      new_row_s17_q <= new_row_s16_q;
      or_1867_s17_q <= or_1867_s16_q;
      patches_right_codes_rdata_s17_q <= patches_right_codes_rdata_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      down_2_s17_q <= down_2_s16_q[0];
      sum_1881_s17_q <= sum_1881[0];
      sum_1882_s17_q <= sum_1882;
      difference_1893_s17_q <= difference_1893;
      and_1909_s17_q <= and_1909_s16_q;
      patches_left_codes_rdata_s17_q <= patches_left_codes_rdata_q;
      and_1918_s17_q <= and_1918_s16_q;
      and_1923_s17_q <= and_1923_s16_q;
      less_1924_s17_q <= less_1924_s16_q;
      equal_1925_s17_q <= equal_1925_s16_q;
      not_1926_s17_q <= not_1926_s16_q;
      equal_1927_s17_q <= equal_1927_s16_q;
      or_1946_s17_q <= or_1946_s16_q;
      or_1949_s17_q <= or_1949_s16_q;
      or_1952_s17_q <= or_1952_s16_q;
      not_1954_s17_q <= not_1954_s16_q;
      regions_rdata_s17_q <= regions_rdata_q;
      textured_s17_q <= textured_s16_q;
      explained_s17_q <= explained_s16_q;
      and_1981_s17_q <= inside_v_s16_q & (and_1979_s16_q & and_1577_s16_q);
      and_1986_s17_q <= and_1986_s16_q;
      and_2027_s17_q <= and_2027_s16_q;
      and_2028_s17_q <= seen_columns_rdata_s16_q[9] & inside_v_s16_q;
      sum_2032_s17_q <= sum_2032;
      or_2044_s17_q <= or_2044_s16_q;
      or_2047_s17_q <= or_2047_s16_q;
      or_2050_s17_q <= or_2050_s16_q;
      and_2061_s17_q <= and_2061_s16_q;
      sum_2067_s17_q <= {2'h0, and_2062} + {1'b0, sum_2066};
      and_2077_s17_q <= and_2077_s16_q;
      sum_2083_s17_q <= {2'h0, and_2078} + {1'b0, sum_2082};
      and_2100_s17_q <= and_2100_s16_q;
      sum_2135_s17_q <= sum_2135[0];
      difference_2136_s17_q <= {1'b0, sum_2135[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2143_s17_q <= sum_2143[0];
      difference_2144_s17_q <= {1'b0, sum_2143[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2215_s17_q <= difference_2215[9];
      xor_2216_s17_q <= difference_2215[8:0] ^ {9{difference_2215[9]}};
      difference_2218_s17_q <= difference_2218[9];
      xor_2219_s17_q <= difference_2218[8:0] ^ {9{difference_2218[9]}};
      difference_2222_s17_q <= difference_2222[9];
      xor_2223_s17_q <= difference_2222[8:0] ^ {9{difference_2222[9]}};
      difference_2291_s17_q <= difference_2291[9];
      xor_2292_s17_q <= difference_2291[8:0] ^ {9{difference_2291[9]}};
      difference_2303_s17_q <= difference_2303[9];
      xor_2304_s17_q <= difference_2303[8:0] ^ {9{difference_2303[9]}};
      equal_2394_s17_q <= equal_2394_s16_q;
      and_2519_s17_q <= and_2519;
      and_2525_s17_q <= and_2525_s16_q;
      and_2530_s17_q <= and_2530;
      not_2544_s17_q <= not_2544_s16_q;
      explained_2_s17_q <= explained_2;
      and_2621_s17_q <= not_1544_s16_q & (so_s16_q & (ends_cell_s16_q & and_2618_s16_q));
      and_2643_s17_q <= not_1544_s16_q & and_2642_s16_q;
      and_2650_s17_q <= not_1544_s16_q & and_2649_s16_q;
      and_2684_s17_q <= and_2684_s16_q;
      and_2685_s17_q <= and_2685_s16_q;
      residual_s17_q <= residual_s16_q[7:0];
      less_2720_s17_q <= $signed(difference_2719) < $signed({7'h0, cfg_moved_limit_i});
      less_2734_s17_q <= less_2734;
      equal_2778_s17_q <= (registration_fresh_q & select_2776) == 4'h0;
      and_2923_s17_q <= and_2923_s16_q;
      less_3050_s17_q <= less_3050_s16_q;
      equal_3393_s17_q <= equal_3393_s16_q;
      select_3481_s17_q <= select_3481_s16_q;
      select_3505_s17_q <= select_3505;
      select_3512_s17_q <= select_3512_s16_q;
      less_3555_s17_q <= less_3555;
      high_s17_q <= high;
      low_s17_q <= low;
      equal_3633_s17_q <= equal_3633;
      and_3860_s17_q <= equal_3859_s16_q & equal_3633;
      equal_3878_s17_q <= equal_3878_s16_q;
      equal_3880_s17_q <= equal_3880;
      equal_3881_s17_q <= equal_3881_s16_q;
      equal_3882_s17_q <= equal_3882_s16_q;
      equal_3883_s17_q <= equal_3883_s16_q;
      equal_3909_s17_q <= (limit & select_3907) == 8'h0;
      of_s17_q <= of;
      equal_4023_s17_q <= equal_4023_s16_q;
      equal_4119_s17_q <= (registration_fresh_q & select_4117) == 4'h0;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic [8:0] census_columns_values_0_cell_3_right_q;
  logic [8:0] census_columns_values_0_cell_4_right_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic [8:0] census_columns_values_1_cell_3_right_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic [8:0] census_columns_values_1_cell_4_right_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [8:0] census_columns_values_2_cell_2_right_q;
  logic [8:0] census_columns_values_2_cell_3_right_q;
  logic [8:0] census_columns_values_2_cell_4_right_q;
  logic [8:0] census_columns_values_3_cell_3_right_q;
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
  // hls/stages/census.hpp:311
  logic [9:0] select_571;
  assign select_571 = and_567_s17_q ? (census_columns_values_1_cell_2_mask_q ? select_569_s17_q : 10'h0) : 10'h0;
  // hls/stages/moments.hpp:53
  logic less_572;
  assign less_572 = $signed(6'h0) < $signed(select_571[9:4]);
  // hls/stages/agreement.hpp:451
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_579_s17_q;
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
  // hls/stages/census.hpp:312
  logic [9:0] difference_601;
  assign difference_601 = {1'b0, census_columns_values_0_cell_2_right_s17_q} - {1'b0, census_columns_values_1_cell_2_right_s17_q};
  // hls/stages/census.hpp:300
  logic less_635;
  assign less_635 = census_memory_rdata_s17_q[8:0] < census_columns_values_1_cell_2_right_s17_q;
  logic less_637;
  assign less_637 = census_columns_values_0_cell_2_right_s17_q < census_columns_values_1_cell_2_right_s17_q;
  logic less_638;
  assign less_638 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_s17_q;
  logic less_640;
  assign less_640 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_s17_q;
  logic less_642;
  assign less_642 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_s17_q;
  logic less_643;
  assign less_643 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_s17_q;
  logic less_645;
  assign less_645 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_s17_q;
  // hls/stages/census.hpp:275
  logic [9:0] sum_649;
  assign sum_649 = {9'h0, difference_647_s17_q} + {1'b0, xor_648_s17_q};
  logic [9:0] sum_652;
  assign sum_652 = {9'h0, difference_650_s17_q} + {1'b0, xor_651_s17_q};
  // hls/stages/patches.hpp:156
  logic and_1721;
  assign and_1721 = and_1719_s17_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:342
  logic [22:0] select_1755;
  assign select_1755 = and_1721 ? {select_1754_s17_q, select_1729_s17_q, select_1725_s17_q, and_1719_s17_q} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:466
  logic [14:0] sum_1883;
  assign sum_1883 = {{4{patches_down_values_3_s17_q[10]}}, patches_down_values_3_s17_q} + {sum_1882_s17_q, sum_1881_s17_q, down_2_s17_q};
  // hls/stages/agreement.hpp:899
  logic [6:0] select_1967;
  assign select_1967 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:900
  logic [6:0] sum_1968;
  assign sum_1968 = {6'h0, textured_s17_q} + select_1967;
  // hls/stages/agreement.hpp:1054
  logic [9:0] sum_1970;
  assign sum_1970 = {3'h0, sum_1968} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[9:0]);
  // hls/stages/agreement.hpp:899
  logic [6:0] select_1972;
  assign select_1972 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:900
  logic [6:0] sum_1973;
  assign sum_1973 = {6'h0, explained_s17_q} + select_1972;
  // hls/stages/agreement.hpp:1055
  logic [9:0] sum_1975;
  assign sum_1975 = {3'h0, sum_1973} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[19:10]);
  // hls/stages/agreement.hpp:899
  logic [6:0] select_1982;
  assign select_1982 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_1983;
  assign sum_1983 = {6'h0, and_1981_s17_q} + select_1982;
  // hls/stages/agreement.hpp:1056
  logic [9:0] sum_1985;
  assign sum_1985 = {3'h0, sum_1983} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[29:20]);
  // hls/stages/agreement.hpp:1267
  logic or_1995;
  assign or_1995 = marks_first_s17_q | line_ended_q;
  // hls/stages/agreement.hpp:1269
  logic [12:0] select_1997;
  assign select_1997 = marks_first_s17_q ? 13'h1 : (or_1995 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1268
  logic [8:0] select_1999;
  assign select_1999 = or_1995 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1276
  logic select_2001;
  assign select_2001 = cfg_compete_i ? (or_1995 & select_1997[12]) : (select_1999[8] & select_1997[9]);
  // hls/stages/agreement.hpp:1080
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2027_s17_q} + ({2'h0, and_2028_s17_q} + {1'b0, sum_2032_s17_q});
  // hls/stages/agreement.hpp:1082
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2061_s17_q} + sum_2067_s17_q;
  // hls/stages/agreement.hpp:1089
  logic [2:0] select_2069;
  assign select_2069 = age_s17_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1083
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2077_s17_q} + sum_2083_s17_q;
  // hls/stages/agreement.hpp:1090
  logic [2:0] select_2085;
  assign select_2085 = age_s17_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:210
  logic [9:0] xor_2137;
  assign xor_2137 = {difference_2136_s17_q[8:0], sum_2135_s17_q} ^ {10{difference_2136_s17_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2136_s17_q[9]} + {1'b0, xor_2137};
  logic [9:0] xor_2145;
  assign xor_2145 = {difference_2144_s17_q[8:0], sum_2143_s17_q} ^ {10{difference_2144_s17_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2144_s17_q[9]} + {1'b0, xor_2145};
  // hls/stages/agreement.hpp:518
  logic select_2160;
  assign select_2160 = and_532_s17_q ? whole_2_s17_q : census_columns_values_0_cell_0_mask_q;
  logic [8:0] select_2169;
  assign select_2169 = and_532_s17_q ? census_memory_rdata_s17_q[8:0] : census_columns_values_0_cell_3_right_q;
  logic [8:0] select_2172;
  assign select_2172 = and_532_s17_q ? census_memory_rdata_s17_q[17:9] : census_columns_values_0_cell_4_right_q;
  logic select_2176;
  assign select_2176 = and_532_s17_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2179;
  assign select_2179 = and_532_s17_q ? census_columns_values_0_cell_1_mask_s17_q : census_columns_values_1_cell_1_mask_q;
  logic select_2182;
  assign select_2182 = and_532_s17_q ? census_columns_values_0_cell_2_mask_s17_q : census_columns_values_1_cell_2_mask_q;
  logic [8:0] select_2185;
  assign select_2185 = and_532_s17_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2186;
  assign select_2186 = and_532_s17_q ? census_columns_values_0_cell_3_mask_s17_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2188;
  assign select_2188 = and_532_s17_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2189;
  assign select_2189 = and_532_s17_q ? census_columns_values_0_cell_4_mask_s17_q : census_columns_values_1_cell_4_mask_q;
  logic select_2192;
  assign select_2192 = and_532_s17_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2195;
  assign select_2195 = and_532_s17_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2197;
  assign select_2197 = and_532_s17_q ? census_columns_values_1_cell_2_right_s17_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2200;
  assign select_2200 = and_532_s17_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2203;
  assign select_2203 = and_532_s17_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2211;
  assign select_2211 = and_532_s17_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:277
  logic [9:0] sum_2217;
  assign sum_2217 = {9'h0, difference_2215_s17_q} + {1'b0, xor_2216_s17_q};
  logic [9:0] sum_2220;
  assign sum_2220 = {9'h0, difference_2218_s17_q} + {1'b0, xor_2219_s17_q};
  logic [9:0] difference_2226;
  assign difference_2226 = {1'b0, census_memory_rdata_s17_q[8:0]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2230;
  assign difference_2230 = {1'b0, census_memory_rdata_s17_q[17:9]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:364
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2291_s17_q} + xor_2292_s17_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2303_s17_q} + xor_2304_s17_q;
  // hls/stages/agreement.hpp:787
  logic and_2535;
  assign and_2535 = not_1544_s17_q & (so_s17_q & (ends_cell_s17_q & explained_s17_q));
  // hls/stages/agreement.hpp:925
  logic [13:0] select_2537;
  assign select_2537 = and_2519_s17_q ? 14'h0 : (counts_explained_q + {13'h0, and_2535});
  // hls/stages/agreement.hpp:787
  logic and_2540;
  assign and_2540 = not_1544_s17_q & (so_s17_q & (ends_cell_s17_q & and_1981_s17_q));
  // hls/stages/agreement.hpp:1088
  logic [2:0] select_2553;
  assign select_2553 = age_s17_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1125
  logic less_2569;
  assign less_2569 = region_row_s17_q < x_s17_q[5:3];
  // hls/stages/patches.hpp:344
  logic not_2913;
  assign not_2913 = ~and_1761_s17_q;
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_1867_s17_q ? patches_right_codes_rdata_s17_q : 28'h0;
  // hls/stages/patches.hpp:517
  logic [47:0] select_3083;
  assign select_3083 = new_row_s17_q ? patches_left_codes_rdata_s17_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3085;
  assign select_3085 = equal_1763_s17_q ? patches_left_row_q : (equal_1765_s17_q ? select_3083 : patches_left_row_q);
  logic [4:0] select_3430;
  assign select_3430 = equal_1765_s17_q ? patches_along_s17_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3507;
  assign select_3507 = less_1924_s17_q ? (equal_1927_s17_q ? 10'h3ff : select_3505_s17_q) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3508;
  assign select_3508 = equal_1927_s17_q ? select_3507 : select_3505_s17_q;
  logic [9:0] select_3510;
  assign select_3510 = less_1924_s17_q ? (equal_1925_s17_q ? 10'h3ff : select_3508) : select_3508;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high_s17_q - low_s17_q;
  logic [9:0] fall_2;
  assign fall_2 = high_s17_q - select_3512_s17_q[9:0];
  // hls/stages/agreement.hpp:1223
  logic [13:0] select_3896;
  assign select_3896 = equal_3633_s17_q ? 14'h0 : product_q;
  logic [13:0] select_3915;
  assign select_3915 = equal_3909_s17_q ? 14'h0 : of_s17_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3896} + {1'b0, select_3915};
  // hls/stages/agreement.hpp:787
  logic [2:0] select_3956;
  assign select_3956 = ends_cell_s17_q ? explained_2_s17_q : box_explained_columns_values_0_q;
  logic [2:0] select_3958;
  assign select_3958 = equal_671_s17_q ? box_explained_columns_values_0_q : (so_s17_q ? select_3956 : box_explained_columns_values_0_q);
  logic [2:0] select_3959;
  assign select_3959 = ends_cell_s17_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3961;
  assign select_3961 = equal_671_s17_q ? box_explained_columns_values_1_q : (so_s17_q ? select_3959 : box_explained_columns_values_1_q);
  logic [2:0] select_3962;
  assign select_3962 = ends_cell_s17_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3964;
  assign select_3964 = equal_671_s17_q ? box_explained_columns_values_2_q : (so_s17_q ? select_3962 : box_explained_columns_values_2_q);
  logic [2:0] select_3965;
  assign select_3965 = ends_cell_s17_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3967;
  assign select_3967 = equal_671_s17_q ? box_explained_columns_values_3_q : (so_s17_q ? select_3965 : box_explained_columns_values_3_q);
  logic [2:0] select_3968;
  assign select_3968 = ends_cell_s17_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3970;
  assign select_3970 = equal_671_s17_q ? box_explained_columns_values_4_q : (so_s17_q ? select_3968 : box_explained_columns_values_4_q);
  logic [2:0] select_3975;
  assign select_3975 = so_s17_q ? (ends_cell_s17_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3977;
  assign select_3977 = ends_cell_s17_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3979;
  assign select_3979 = equal_671_s17_q ? box_shown_columns_values_1_q : (so_s17_q ? select_3977 : box_shown_columns_values_1_q);
  logic [2:0] select_3980;
  assign select_3980 = ends_cell_s17_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3982;
  assign select_3982 = equal_671_s17_q ? box_shown_columns_values_2_q : (so_s17_q ? select_3980 : box_shown_columns_values_2_q);
  logic [2:0] select_3983;
  assign select_3983 = ends_cell_s17_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3985;
  assign select_3985 = equal_671_s17_q ? box_shown_columns_values_3_q : (so_s17_q ? select_3983 : box_shown_columns_values_3_q);
  logic [2:0] select_3986;
  assign select_3986 = ends_cell_s17_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3988;
  assign select_3988 = equal_671_s17_q ? box_shown_columns_values_4_q : (so_s17_q ? select_3986 : box_shown_columns_values_4_q);
  logic [2:0] select_3993;
  assign select_3993 = so_s17_q ? (ends_cell_s17_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3995;
  assign select_3995 = ends_cell_s17_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3997;
  assign select_3997 = equal_671_s17_q ? box_nearer_columns_values_1_q : (so_s17_q ? select_3995 : box_nearer_columns_values_1_q);
  logic [2:0] select_3998;
  assign select_3998 = ends_cell_s17_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4000;
  assign select_4000 = equal_671_s17_q ? box_nearer_columns_values_2_q : (so_s17_q ? select_3998 : box_nearer_columns_values_2_q);
  logic [2:0] select_4001;
  assign select_4001 = ends_cell_s17_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4003;
  assign select_4003 = equal_671_s17_q ? box_nearer_columns_values_3_q : (so_s17_q ? select_4001 : box_nearer_columns_values_3_q);
  logic [2:0] select_4004;
  assign select_4004 = ends_cell_s17_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4006;
  assign select_4006 = equal_671_s17_q ? box_nearer_columns_values_4_q : (so_s17_q ? select_4004 : box_nearer_columns_values_4_q);

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1526_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1525_s17_q, select_1522_s17_q, select_1519_s17_q, select_1517_s17_q, select_1499_s17_q, select_1496_s17_q, select_1488_s17_q, select_1487_s17_q, select_1482_s17_q};
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
  assign best_right_we = s17_en & and_1526_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1543_s17_q, select_1542_s17_q, select_1539_s17_q, select_1538_s17_q};
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
  assign patches_choices_waddr = {patches_choosing_band_s17_q, and_1679_s17_q};
  logic patches_choices_we;
  assign patches_choices_we = s17_en & and_1762_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= select_1755;
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
      counts_explained_q <= select_2537;
      patches_fixed_q <= not_2913 & (patches_fixed_q | (and_2923_s17_q & and_1721));
      patches_choice_valid_q <= and_1761_s17_q ? (select_1755[0] & not_2913) : select_1755[0];
      patches_choice_column_q <= select_1755[8:1];
      patches_choice_shift_q <= select_1755[14:9];
      patches_choice_slope_q <= select_1755[22:15];
      patches_left_row_q <= select_3085;
      patches_summed_row_column_q <= equal_1763_s17_q ? patches_summed_row_column_q : select_3430;
      patches_read_far_q <= equal_1763_s17_q ? select_3510 : patches_read_far_q;
      segment_textured_q <= select_1967 + {6'h0, and_2530_s17_q};
      segment_explained_q <= select_1972 + {6'h0, and_2535};
      segment_nearer_q <= select_1982 + {6'h0, and_2540};
      segment_started_q <= ~segment_starts_q;
      product_q <= equal_671_s17_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_1997;
      columns_passed_q <= {select_1999[7:0], or_1995};
      line_ended_q <= marks_last_s17_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_columns_values_0_cell_0_mask_q = 1'b0;
    census_columns_values_0_cell_3_right_q = 9'h0;
    census_columns_values_0_cell_4_right_q = 9'h0;
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_1_cell_3_right_q = 9'h0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_4_right_q = 9'h0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
    census_columns_values_2_cell_2_right_q = 9'h0;
    census_columns_values_2_cell_3_right_q = 9'h0;
    census_columns_values_2_cell_4_right_q = 9'h0;
    census_columns_values_3_cell_3_right_q = 9'h0;
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
      census_columns_values_0_cell_0_mask_q <= select_2160;
      census_columns_values_0_cell_3_right_q <= select_2169;
      census_columns_values_0_cell_4_right_q <= select_2172;
      census_columns_values_1_cell_0_mask_q <= select_2176;
      census_columns_values_1_cell_1_mask_q <= select_2179;
      census_columns_values_1_cell_2_mask_q <= select_2182;
      census_columns_values_1_cell_3_right_q <= select_2185;
      census_columns_values_1_cell_3_mask_q <= select_2186;
      census_columns_values_1_cell_4_right_q <= select_2188;
      census_columns_values_1_cell_4_mask_q <= select_2189;
      census_columns_values_2_cell_0_mask_q <= select_2192;
      census_columns_values_2_cell_1_mask_q <= select_2195;
      census_columns_values_2_cell_2_right_q <= select_2197;
      census_columns_values_2_cell_3_right_q <= select_2200;
      census_columns_values_2_cell_4_right_q <= select_2203;
      census_columns_values_3_cell_3_right_q <= select_2211;
      box_explained_columns_values_0_q <= select_3958;
      box_explained_columns_values_1_q <= select_3961;
      box_explained_columns_values_2_q <= select_3964;
      box_explained_columns_values_3_q <= select_3967;
      box_explained_columns_values_4_q <= select_3970;
      box_shown_columns_values_0_q <= equal_671_s17_q ? box_shown_columns_values_0_q : select_3975;
      box_shown_columns_values_1_q <= select_3979;
      box_shown_columns_values_2_q <= select_3982;
      box_shown_columns_values_3_q <= select_3985;
      box_shown_columns_values_4_q <= select_3988;
      box_nearer_columns_values_0_q <= equal_671_s17_q ? box_nearer_columns_values_0_q : select_3993;
      box_nearer_columns_values_1_q <= select_3997;
      box_nearer_columns_values_2_q <= select_4000;
      box_nearer_columns_values_3_q <= select_4003;
      box_nearer_columns_values_4_q <= select_4006;
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
  logic [3:0] select_493_s18_q;
  logic [6:0] select_496_s18_q;
  logic [6:0] column_s18_q;
  logic and_530_s18_q;
  logic and_532_s18_q;
  logic equal_535_s18_q;
  logic whole_2_s18_q;
  logic equal_554_s18_q;
  logic [12:0] select_556_s18_q;
  logic less_558_s18_q;
  logic and_567_s18_q;
  logic less_572_s18_q;
  logic and_575_s18_q;
  logic whole_9_s18_q;
  logic [9:0] difference_601_s18_q;
  logic so_s18_q;
  logic less_622_s18_q;
  logic less_623_s18_q;
  logic less_624_s18_q;
  logic less_625_s18_q;
  logic less_626_s18_q;
  logic less_627_s18_q;
  logic less_628_s18_q;
  logic less_629_s18_q;
  logic less_630_s18_q;
  logic less_631_s18_q;
  logic less_632_s18_q;
  logic less_633_s18_q;
  logic less_634_s18_q;
  logic less_635_s18_q;
  logic less_636_s18_q;
  logic less_637_s18_q;
  logic less_638_s18_q;
  logic less_639_s18_q;
  logic less_640_s18_q;
  logic less_641_s18_q;
  logic less_642_s18_q;
  logic less_643_s18_q;
  logic less_644_s18_q;
  logic less_645_s18_q;
  logic [10:0] sum_653_s18_q;
  logic [9:0] sum_656_s18_q;
  logic [9:0] sum_660_s18_q;
  logic [9:0] sum_664_s18_q;
  logic equal_671_s18_q;
  logic less_681_s18_q;
  logic not_682_s18_q;
  logic not_1544_s18_q;
  logic equal_1585_s18_q;
  logic all_s18_q;
  logic [1:0] sum_1591_s18_q;
  logic equal_1593_s18_q;
  logic equal_1595_s18_q;
  logic equal_1597_s18_q;
  logic equal_1599_s18_q;
  logic equal_1601_s18_q;
  logic equal_1603_s18_q;
  logic equal_1605_s18_q;
  logic equal_1607_s18_q;
  logic less_1616_s18_q;
  logic or_1620_s18_q;
  logic [31:0] registration_sums_rdata_s18_q;
  logic equal_1640_s18_q;
  logic and_1650_s18_q;
  logic and_1653_s18_q;
  logic select_1670_s18_q;
  logic equal_1671_s18_q;
  logic equal_1681_s18_q;
  logic equal_1704_s18_q;
  logic equal_1763_s18_q;
  logic equal_1765_s18_q;
  logic equal_1768_s18_q;
  logic or_1769_s18_q;
  logic [22:0] select_1779_s18_q;
  logic [4:0] select_1793_s18_q;
  logic select_1799_s18_q;
  logic [3:0] select_1838_s18_q;
  logic less_1854_s18_q;
  logic new_row_s18_q;
  logic [1:0] of_row_2_s18_q;
  logic less_1884_s18_q;
  logic less_1885_s18_q;
  logic less_1894_s18_q;
  logic less_1895_s18_q;
  logic and_1909_s18_q;
  logic and_1918_s18_q;
  logic and_1923_s18_q;
  logic less_1924_s18_q;
  logic equal_1925_s18_q;
  logic not_1926_s18_q;
  logic equal_1927_s18_q;
  logic or_1946_s18_q;
  logic or_1949_s18_q;
  logic or_1952_s18_q;
  logic not_1954_s18_q;
  logic [9:0] sum_1970_s18_q;
  logic [9:0] sum_1975_s18_q;
  logic [9:0] sum_1985_s18_q;
  logic and_1986_s18_q;
  logic select_2001_s18_q;
  logic [2:0] textured_2_s18_q;
  logic or_2044_s18_q;
  logic or_2047_s18_q;
  logic or_2050_s18_q;
  logic [3:0] difference_2070_s18_q;
  logic [3:0] difference_2086_s18_q;
  logic and_2100_s18_q;
  logic [10:0] size_s18_q;
  logic [10:0] size_2_s18_q;
  logic [10:0] sum_2221_s18_q;
  logic [9:0] sum_2224_s18_q;
  logic difference_2226_s18_q;
  logic [8:0] xor_2227_s18_q;
  logic difference_2230_s18_q;
  logic [8:0] xor_2231_s18_q;
  logic [8:0] contrast_s18_q;
  logic [8:0] contrast_2_s18_q;
  logic equal_2394_s18_q;
  logic and_2519_s18_q;
  logic and_2525_s18_q;
  logic and_2540_s18_q;
  logic not_2544_s18_q;
  logic [3:0] difference_2554_s18_q;
  logic [9:0] select_2570_s18_q;
  logic [9:0] select_2573_s18_q;
  logic and_2621_s18_q;
  logic and_2643_s18_q;
  logic and_2650_s18_q;
  logic and_2684_s18_q;
  logic and_2685_s18_q;
  logic [7:0] residual_s18_q;
  logic and_2721_s18_q;
  logic and_2735_s18_q;
  logic equal_2778_s18_q;
  logic [27:0] word_s18_q;
  logic equal_3044_s18_q;
  logic less_3050_s18_q;
  logic [47:0] select_3083_s18_q;
  logic equal_3393_s18_q;
  logic [4:0] select_3481_s18_q;
  logic [14:0] select_3512_s18_q;
  logic less_3555_s18_q;
  logic [9:0] eight_s18_q;
  logic [9:0] fall_2_s18_q;
  logic equal_3633_s18_q;
  logic and_3860_s18_q;
  logic less_3861_s18_q;
  logic equal_3862_s18_q;
  logic equal_3878_s18_q;
  logic equal_3880_s18_q;
  logic equal_3881_s18_q;
  logic equal_3882_s18_q;
  logic equal_3883_s18_q;
  logic sum_4_s18_q;
  logic equal_4023_s18_q;
  logic equal_4119_s18_q;
  logic [9:0] select_4129_s18_q;
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
      select_493_s18_q <= select_493_s17_q;
      select_496_s18_q <= select_496_s17_q;
      column_s18_q <= column_s17_q;
      and_530_s18_q <= and_530_s17_q;
      and_532_s18_q <= and_532_s17_q;
      equal_535_s18_q <= equal_535_s17_q;
      whole_2_s18_q <= whole_2_s17_q;
      equal_554_s18_q <= equal_554_s17_q;
      select_556_s18_q <= select_556_s17_q;
      less_558_s18_q <= 11'h3ec < select_557_s17_q;
      and_567_s18_q <= and_567_s17_q;
      less_572_s18_q <= less_572;
      and_575_s18_q <= ($signed(select_571) < $signed(10'h3f1)) & (~less_572);
      whole_9_s18_q <= whole_9;
      difference_601_s18_q <= difference_601;
      so_s18_q <= so_s17_q;
      less_622_s18_q <= less_622_s17_q;
      less_623_s18_q <= less_623_s17_q;
      less_624_s18_q <= less_624_s17_q;
      less_625_s18_q <= less_625_s17_q;
      less_626_s18_q <= less_626_s17_q;
      less_627_s18_q <= less_627_s17_q;
      less_628_s18_q <= less_628_s17_q;
      less_629_s18_q <= less_629_s17_q;
      less_630_s18_q <= less_630_s17_q;
      less_631_s18_q <= less_631_s17_q;
      less_632_s18_q <= less_632_s17_q;
      less_633_s18_q <= less_633_s17_q;
      less_634_s18_q <= less_634_s17_q;
      less_635_s18_q <= less_635;
      less_636_s18_q <= less_636_s17_q;
      less_637_s18_q <= less_637;
      less_638_s18_q <= less_638;
      less_639_s18_q <= less_639_s17_q;
      less_640_s18_q <= less_640;
      less_641_s18_q <= less_641_s17_q;
      less_642_s18_q <= less_642;
      less_643_s18_q <= less_643;
      less_644_s18_q <= less_644_s17_q;
      less_645_s18_q <= less_645;
      sum_653_s18_q <= {1'b0, sum_649} + {1'b0, sum_652};
      sum_656_s18_q <= {9'h0, difference_654_s17_q} + {1'b0, xor_655_s17_q};
      sum_660_s18_q <= {9'h0, difference_658_s17_q} + {1'b0, xor_659_s17_q};
      sum_664_s18_q <= {9'h0, difference_662_s17_q} + {1'b0, xor_663_s17_q};
      equal_671_s18_q <= equal_671_s17_q;
      less_681_s18_q <= $signed(select_571) < $signed(10'h1);
      not_682_s18_q <= ~select_571[9];
      not_1544_s18_q <= not_1544_s17_q;
      equal_1585_s18_q <= equal_1585_s17_q;
      all_s18_q <= all_s17_q;
      sum_1591_s18_q <= sum_1591_s17_q;
      equal_1593_s18_q <= equal_1593_s17_q;
      equal_1595_s18_q <= equal_1595_s17_q;
      equal_1597_s18_q <= equal_1597_s17_q;
      equal_1599_s18_q <= equal_1599_s17_q;
      equal_1601_s18_q <= equal_1601_s17_q;
      equal_1603_s18_q <= equal_1603_s17_q;
      equal_1605_s18_q <= equal_1605_s17_q;
      equal_1607_s18_q <= equal_1607_s17_q;
      less_1616_s18_q <= less_1616_s17_q;
      or_1620_s18_q <= or_1620_s17_q;
      registration_sums_rdata_s18_q <= registration_sums_rdata_q;
      equal_1640_s18_q <= equal_1640_s17_q;
      and_1650_s18_q <= and_1650_s17_q;
      and_1653_s18_q <= and_1653_s17_q;
      select_1670_s18_q <= select_1670_s17_q;
      equal_1671_s18_q <= equal_1671_s17_q;
      equal_1681_s18_q <= equal_1681_s17_q;
      equal_1704_s18_q <= equal_1704_s17_q;
      equal_1763_s18_q <= equal_1763_s17_q;
      equal_1765_s18_q <= equal_1765_s17_q;
      equal_1768_s18_q <= equal_1768_s17_q;
      or_1769_s18_q <= or_1769_s17_q;
      select_1779_s18_q <= and_1778_s17_q ? select_1755 : patches_choices_rdata_s17_q;
      select_1793_s18_q <= select_1793_s17_q;
      select_1799_s18_q <= select_1799_s17_q;
      select_1838_s18_q <= select_1838_s17_q;
      less_1854_s18_q <= less_1854_s17_q;
      new_row_s18_q <= new_row_s17_q;
      of_row_2_s18_q <= of_row_2_s17_q;
      less_1884_s18_q <= $signed(15'h100) < $signed(sum_1883);
      less_1885_s18_q <= $signed(sum_1883[14:8]) < $signed(7'h7f);
      less_1894_s18_q <= $signed(15'h100) < $signed(difference_1893_s17_q);
      less_1895_s18_q <= $signed(difference_1893_s17_q[14:8]) < $signed(7'h7f);
      and_1909_s18_q <= and_1909_s17_q;
      and_1918_s18_q <= and_1918_s17_q;
      and_1923_s18_q <= and_1923_s17_q;
      less_1924_s18_q <= less_1924_s17_q;
      equal_1925_s18_q <= equal_1925_s17_q;
      not_1926_s18_q <= not_1926_s17_q;
      equal_1927_s18_q <= equal_1927_s17_q;
      or_1946_s18_q <= or_1946_s17_q;
      or_1949_s18_q <= or_1949_s17_q;
      or_1952_s18_q <= or_1952_s17_q;
      not_1954_s18_q <= not_1954_s17_q;
      sum_1970_s18_q <= sum_1970;
      sum_1975_s18_q <= sum_1975;
      sum_1985_s18_q <= sum_1985;
      and_1986_s18_q <= and_1986_s17_q;
      select_2001_s18_q <= select_2001;
      textured_2_s18_q <= textured_2;
      or_2044_s18_q <= or_2044_s17_q;
      or_2047_s18_q <= or_2047_s17_q;
      or_2050_s18_q <= or_2050_s17_q;
      difference_2070_s18_q <= {1'b0, shown_2} - {1'b0, select_2069};
      difference_2086_s18_q <= {1'b0, near_2} - {1'b0, select_2085};
      and_2100_s18_q <= and_2100_s17_q;
      size_s18_q <= size;
      size_2_s18_q <= size_2;
      sum_2221_s18_q <= {1'b0, sum_2217} + {1'b0, sum_2220};
      sum_2224_s18_q <= {9'h0, difference_2222_s17_q} + {1'b0, xor_2223_s17_q};
      difference_2226_s18_q <= difference_2226[9];
      xor_2227_s18_q <= difference_2226[8:0] ^ {9{difference_2226[9]}};
      difference_2230_s18_q <= difference_2230[9];
      xor_2231_s18_q <= difference_2230[8:0] ^ {9{difference_2230[9]}};
      contrast_s18_q <= contrast;
      contrast_2_s18_q <= contrast_2;
      equal_2394_s18_q <= equal_2394_s17_q;
      and_2519_s18_q <= and_2519_s17_q;
      and_2525_s18_q <= and_2525_s17_q;
      and_2540_s18_q <= and_2540;
      not_2544_s18_q <= not_2544_s17_q;
      difference_2554_s18_q <= {1'b0, explained_2_s17_q} - {1'b0, select_2553};
      select_2570_s18_q <= less_2569 ? 10'h0 : regions_rdata_s17_q[9:0];
      select_2573_s18_q <= less_2569 ? 10'h0 : regions_rdata_s17_q[19:10];
      and_2621_s18_q <= and_2621_s17_q;
      and_2643_s18_q <= and_2643_s17_q;
      and_2650_s18_q <= and_2650_s17_q;
      and_2684_s18_q <= and_2684_s17_q;
      and_2685_s18_q <= and_2685_s17_q;
      residual_s18_q <= residual_s17_q;
      and_2721_s18_q <= and_2685_s17_q & less_2720_s17_q;
      and_2735_s18_q <= and_2685_s17_q & less_2734_s17_q;
      equal_2778_s18_q <= equal_2778_s17_q;
      word_s18_q <= word;
      equal_3044_s18_q <= patches_along_s17_q == 5'h7;
      less_3050_s18_q <= less_3050_s17_q;
      select_3083_s18_q <= select_3083;
      equal_3393_s18_q <= equal_3393_s17_q;
      select_3481_s18_q <= select_3481_s17_q;
      select_3512_s18_q <= select_3512_s17_q;
      less_3555_s18_q <= less_3555_s17_q;
      eight_s18_q <= eight;
      fall_2_s18_q <= fall_2;
      equal_3633_s18_q <= equal_3633_s17_q;
      and_3860_s18_q <= and_3860_s17_q;
      less_3861_s18_q <= counts_explained_q < product_q;
      equal_3862_s18_q <= counts_explained_q == product_q;
      equal_3878_s18_q <= equal_3878_s17_q;
      equal_3880_s18_q <= equal_3880_s17_q;
      equal_3881_s18_q <= equal_3881_s17_q;
      equal_3882_s18_q <= equal_3882_s17_q;
      equal_3883_s18_q <= equal_3883_s17_q;
      sum_4_s18_q <= sum_4[0];
      equal_4023_s18_q <= equal_4023_s17_q;
      equal_4119_s18_q <= equal_4119_s17_q;
      select_4129_s18_q <= less_2569 ? 10'h0 : regions_rdata_s17_q[29:20];
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
  // hls/stages/moments.hpp:79
  logic not_559;
  assign not_559 = ~less_558_s18_q;
  logic and_560;
  assign and_560 = and_532_s18_q & not_559;
  // hls/stages/agreement.hpp:451
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
  // hls/stages/census.hpp:275
  logic [10:0] sum_657;
  assign sum_657 = sum_653_s18_q + {1'b0, sum_656_s18_q};
  // hls/stages/registration.hpp:265
  logic equal_1642;
  assign equal_1642 = sum_1591_s18_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1591_s18_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1648;
  assign select_1648 = equal_1642 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1649;
  assign sum_1649 = (equal_1640_s18_q ? registration_sums_rdata_s18_q[31:20] : 12'h0) + {{5{select_1648[6]}}, select_1648};
  // hls/stages/patches.hpp:353
  logic [21:0] select_1782;
  assign select_1782 = select_1670_s18_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1779_s18_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1783;
  assign select_1783 = equal_1671_s18_q ? patches_place_0_column_q : select_1782[7:0];
  logic [5:0] select_1784;
  assign select_1784 = equal_1671_s18_q ? patches_place_0_shift_q : select_1782[13:8];
  // hls/stages/patches.hpp:353
  logic [21:0] select_1811;
  assign select_1811 = select_1670_s18_q ? select_1779_s18_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1812;
  assign select_1812 = equal_1671_s18_q ? patches_place_1_column_q : select_1811[7:0];
  logic [5:0] select_1813;
  assign select_1813 = equal_1671_s18_q ? patches_place_1_shift_q : select_1811[13:8];
  // hls/stages/patches.hpp:132
  logic equal_1829;
  assign equal_1829 = {select_1783[7], select_496_s18_q, select_493_s18_q} == {1'b0, select_1783[6:0], 4'h0};
  logic equal_1833;
  assign equal_1833 = {select_1812[7], select_496_s18_q, select_493_s18_q} == {1'b0, select_1812[6:0], 4'h0};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_1875;
  assign sum_1875 = patches_code_row_s18_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_1913;
  assign sum_1913 = patches_code_row_s18_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:430
  logic next_row;
  assign next_row = select_2001_s18_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1283
  logic [6:0] select_2004;
  assign select_2004 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1293
  logic equal_2007;
  assign equal_2007 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1266
  logic not_2014;
  assign not_2014 = ~marks_first_s18_q;
  // hls/stages/agreement.hpp:1087
  logic [2:0] select_2035;
  assign select_2035 = age_s18_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1094
  logic not_2051;
  assign not_2051 = ~region_row_s18_q[2];
  logic [2:0] select_2052;
  assign select_2052 = region_row_s18_q[1] ? {1'b0, not_2051, 1'b0} : {region_row_s18_q[2], 1'b0, not_2051};
  logic [5:0] select_2053;
  assign select_2053 = region_row_s18_q[0] ? {select_2052[2], 1'b0, select_2052[1], 1'b0, select_2052[0], 1'b0} : {1'b0, select_2052[2], 1'b0, select_2052[1], 1'b0, select_2052[0]};
  logic [11:0] select_2054;
  assign select_2054 = or_2050_s18_q ? {select_2053[5], 1'b0, select_2053[4], 1'b0, select_2053[3], 1'b0, select_2053[2], 1'b0, select_2053[1], 1'b0, select_2053[0], 1'b0} : {1'b0, select_2053[5], 1'b0, select_2053[4], 1'b0, select_2053[3], 1'b0, select_2053[2], 1'b0, select_2053[1], 1'b0, select_2053[0]};
  logic [23:0] select_2055;
  assign select_2055 = or_2047_s18_q ? {select_2054[11], 1'b0, select_2054[10], 1'b0, select_2054[9], 1'b0, select_2054[8], 1'b0, select_2054[7], 1'b0, select_2054[6], 1'b0, select_2054[5], 1'b0, select_2054[4], 1'b0, select_2054[3], 1'b0, select_2054[2], 1'b0, select_2054[1], 1'b0, select_2054[0], 1'b0} : {1'b0, select_2054[11], 1'b0, select_2054[10], 1'b0, select_2054[9], 1'b0, select_2054[8], 1'b0, select_2054[7], 1'b0, select_2054[6], 1'b0, select_2054[5], 1'b0, select_2054[4], 1'b0, select_2054[3], 1'b0, select_2054[2], 1'b0, select_2054[1], 1'b0, select_2054[0]};
  // hls/stages/agreement.hpp:1089
  logic [4:0] around;
  assign around = {difference_2070_s18_q[3], difference_2070_s18_q} + (equal_1704_s18_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1090
  logic [4:0] n;
  assign n = {difference_2086_s18_q[3], difference_2086_s18_q} + (equal_1704_s18_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size_s18_q} + (equal_535_s18_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:271
  logic [13:0] select_2142;
  assign select_2142 = sample_pair_whole_s18_q ? (and_530_s18_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s18_q} + (equal_535_s18_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:271
  logic [13:0] select_2150;
  assign select_2150 = sample_pair_whole_s18_q ? (and_530_s18_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:518
  logic select_2198;
  assign select_2198 = and_532_s18_q ? census_columns_values_1_cell_2_mask_s18_q : census_columns_values_2_cell_2_mask_q;
  logic select_2201;
  assign select_2201 = and_532_s18_q ? census_columns_values_1_cell_3_mask_s18_q : census_columns_values_2_cell_3_mask_q;
  logic select_2204;
  assign select_2204 = and_532_s18_q ? census_columns_values_1_cell_4_mask_s18_q : census_columns_values_2_cell_4_mask_q;
  logic select_2205;
  assign select_2205 = and_532_s18_q ? census_columns_values_2_cell_0_mask_s18_q : census_columns_values_3_cell_0_mask_q;
  logic select_2208;
  assign select_2208 = and_532_s18_q ? census_columns_values_2_cell_1_mask_s18_q : census_columns_values_3_cell_1_mask_q;
  logic select_2209;
  assign select_2209 = and_532_s18_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2212;
  assign select_2212 = and_532_s18_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:277
  logic [10:0] sum_2225;
  assign sum_2225 = sum_2221_s18_q + {1'b0, sum_2224_s18_q};
  logic [9:0] sum_2228;
  assign sum_2228 = {9'h0, difference_2226_s18_q} + {1'b0, xor_2227_s18_q};
  // hls/stages/agreement.hpp:518
  logic select_2287;
  assign select_2287 = and_532_s18_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:366
  logic and_2290;
  assign and_2290 = whole_2_s18_q & (~(column_s18_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:455
  logic and_2296;
  assign and_2296 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s18_q[8:2]));
  logic and_2297;
  assign and_2297 = and_2290 & and_2296;
  logic and_2308;
  assign and_2308 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s18_q[8:2]));
  logic and_2309;
  assign and_2309 = and_2290 & and_2308;
  // hls/stages/census.hpp:420
  logic not_2326;
  assign not_2326 = ~x_s18_q[1];
  logic [2:0] select_2327;
  assign select_2327 = x_s18_q[0] ? {1'b0, not_2326, 1'b0} : {x_s18_q[1], 1'b0, not_2326};
  logic [5:0] select_2328;
  assign select_2328 = slot_s18_q[2] ? {select_2327[2], 1'b0, select_2327[1], 1'b0, select_2327[0], 1'b0} : {1'b0, select_2327[2], 1'b0, select_2327[1], 1'b0, select_2327[0]};
  logic [11:0] select_2329;
  assign select_2329 = slot_s18_q[1] ? {select_2328[5], 1'b0, select_2328[4], 1'b0, select_2328[3], 1'b0, select_2328[2], 1'b0, select_2328[1], 1'b0, select_2328[0], 1'b0} : {1'b0, select_2328[5], 1'b0, select_2328[4], 1'b0, select_2328[3], 1'b0, select_2328[2], 1'b0, select_2328[1], 1'b0, select_2328[0]};
  // hls/stages/agreement.hpp:925
  logic [13:0] select_2527;
  assign select_2527 = and_2519_s18_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2525_s18_q});
  logic [13:0] select_2542;
  assign select_2542 = and_2519_s18_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2540_s18_q});
  // hls/stages/agreement.hpp:1088
  logic [4:0] e;
  assign e = {difference_2554_s18_q[3], difference_2554_s18_q} + (equal_1704_s18_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/registration.hpp:107
  logic [7:0] select_2702;
  assign select_2702 = equal_1681_s18_q ? (and_2685_s18_q ? residual_s18_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:787
  logic and_2709;
  assign and_2709 = not_1544_s18_q & (so_s18_q & (and_2685_s18_q & equal_1681_s18_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2711;
  assign select_2711 = and_2684_s18_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2709});
  // hls/stages/registration.hpp:107
  logic and_2713;
  assign and_2713 = and_2685_s18_q & ($signed(residual_s18_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:787
  logic [1:0] select_2715;
  assign select_2715 = so_s18_q ? (equal_1681_s18_q ? {and_2713, and_2685_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2723;
  assign select_2723 = so_s18_q ? (equal_1681_s18_q ? {and_2721_s18_q, and_2685_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2724;
  assign select_2724 = equal_671_s18_q ? 2'h0 : select_2723;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2725;
  assign sum_2725 = registration_half_votes_up_q + {{5{select_2724[1]}}, select_2724};
  // hls/stages/registration.hpp:205
  logic less_2727;
  assign less_2727 = $signed(residual_s18_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2728;
  assign and_2728 = and_2685_s18_q & less_2727;
  // hls/stages/agreement.hpp:787
  logic [1:0] select_2730;
  assign select_2730 = so_s18_q ? (equal_1681_s18_q ? {and_2728, and_2685_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2737;
  assign select_2737 = so_s18_q ? (equal_1681_s18_q ? {and_2735_s18_q, and_2685_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2738;
  assign select_2738 = equal_671_s18_q ? 2'h0 : select_2737;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2739;
  assign sum_2739 = registration_half_half_votes_up_q + {{5{select_2738[1]}}, select_2738};
  // hls/stages/agreement.hpp:1123
  logic [11:0] select_2780;
  assign select_2780 = or_1620_s18_q ? 12'h0 : (equal_2778_s18_q ? registration_sums_rdata_s18_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1135
  logic [11:0] select_2782;
  assign select_2782 = equal_1585_s18_q ? 12'h0 : (less_1616_s18_q ? select_2780 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2785;
  assign and_2785 = x_s18_q[1] & all_s18_q;
  // hls/stages/agreement.hpp:1135
  logic and_2788;
  assign and_2788 = not_1954_s18_q & (less_1616_s18_q & ({and_2785, x_s18_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1123
  logic [11:0] select_2795;
  assign select_2795 = or_1620_s18_q ? 12'h0 : (equal_2778_s18_q ? registration_sums_rdata_s18_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1135
  logic [11:0] select_2797;
  assign select_2797 = equal_1585_s18_q ? 12'h0 : (less_1616_s18_q ? select_2795 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2803;
  assign not_2803 = ~all_s18_q;
  // hls/stages/agreement.hpp:1135
  logic and_2806;
  assign and_2806 = not_1954_s18_q & (less_1616_s18_q & (x_s18_q[2:0] == {all_s18_q, not_2803, 1'b0}));
  // hls/stages/agreement.hpp:787
  logic and_2812;
  assign and_2812 = equal_671_s18_q & (x_s18_q[6] & (not_1954_s18_q & (less_1616_s18_q & all_s18_q)));
  // hls/stages/registration.hpp:157
  logic equal_2839;
  assign equal_2839 = x_s18_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1135
  logic and_2842;
  assign and_2842 = not_1954_s18_q & (less_1616_s18_q & (x_s18_q[5] ? x_s18_q[3] : equal_2839));
  logic and_2851;
  assign and_2851 = not_1954_s18_q & (less_1616_s18_q & ((~x_s18_q[5]) & (x_s18_q[3] & equal_2839)));
  // hls/stages/agreement.hpp:271
  logic [7:0] select_2946;
  assign select_2946 = sample_pair_whole_s18_q ? (equal_1671_s18_q ? patches_place_0_slope_q : select_1782[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_2951;
  assign select_2951 = sample_pair_whole_s18_q ? (equal_1671_s18_q ? patches_place_1_slope_q : select_1811[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s18_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3040;
  assign select_3040 = or_1769_s18_q ? {less_1895_s18_q, less_1894_s18_q, less_1885_s18_q, less_1884_s18_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3042;
  assign select_3042 = equal_1763_s18_q ? patches_codes_at_q : (equal_1765_s18_q ? other[55:4] : select_3040);
  // hls/stages/patches.hpp:516
  logic [27:0] select_3045;
  assign select_3045 = equal_3044_s18_q ? word_s18_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3047;
  assign select_3047 = equal_1765_s18_q ? (new_row_s18_q ? word_s18_q : select_3045) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_3049;
  assign select_3049 = less_1854_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_3051;
  assign select_3051 = less_3050_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3053;
  assign select_3053 = or_1769_s18_q ? (equal_1768_s18_q ? patches_next_codes_q : select_3051) : patches_next_codes_q;
  logic [55:0] select_3055;
  assign select_3055 = equal_1763_s18_q ? patches_next_codes_q : (equal_1765_s18_q ? select_3049 : select_3053);
  // hls/stages/count_bits.hpp:24
  logic parity_3060;
  assign parity_3060 = ^{less_1895_s18_q, less_1894_s18_q, less_1885_s18_q, less_1884_s18_q};
  // hls/stages/count_bits.hpp:25
  logic or_3064;
  assign or_3064 = ({less_1885_s18_q, less_1884_s18_q} == 2'h3) | (less_1894_s18_q & (less_1885_s18_q | less_1884_s18_q));
  logic and_3065;
  assign and_3065 = less_1895_s18_q & (^{less_1894_s18_q, less_1885_s18_q, less_1884_s18_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3066;
  assign xor_3066 = or_3064 ^ and_3065;
  // hls/stages/count_bits.hpp:27
  logic and_3067;
  assign and_3067 = or_3064 & and_3065;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3069;
  assign select_3069 = or_1769_s18_q ? (and_1918_s18_q ? {and_3067, xor_3066, parity_3060} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3083_s18_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3089;
  assign xor_3089 = bits[17] ^ (^{select_3083_s18_q[16:15], other[16:15]});
  logic xor_3092;
  assign xor_3092 = bits[11] ^ (^{select_3083_s18_q[10:9], other[10:9]});
  logic xor_3095;
  assign xor_3095 = bits[14] ^ (^{select_3083_s18_q[13:12], other[13:12]});
  logic xor_3098;
  assign xor_3098 = xor_3089 ^ (^{select_3083_s18_q[14:9], other[14:9]});
  logic xor_3101;
  assign xor_3101 = bits[47] ^ (^{select_3083_s18_q[46:45], other[46:45]});
  logic xor_3104;
  assign xor_3104 = bits[8] ^ (^{select_3083_s18_q[7:6], other[7:6]});
  logic xor_3107;
  assign xor_3107 = bits[2] ^ (^{select_3083_s18_q[1:0], other[1:0]});
  logic xor_3110;
  assign xor_3110 = bits[5] ^ (^{select_3083_s18_q[4:3], other[4:3]});
  logic xor_3113;
  assign xor_3113 = xor_3104 ^ (^{select_3083_s18_q[5:0], other[5:0]});
  logic parity_3115;
  assign parity_3115 = ^{select_3083_s18_q[47:45], select_3083_s18_q[8:0], other[47:45], other[8:0]};
  logic xor_3119;
  assign xor_3119 = bits[44] ^ (^{select_3083_s18_q[43:42], other[43:42]});
  logic xor_3122;
  assign xor_3122 = bits[38] ^ (^{select_3083_s18_q[37:36], other[37:36]});
  logic xor_3125;
  assign xor_3125 = bits[41] ^ (^{select_3083_s18_q[40:39], other[40:39]});
  logic xor_3131;
  assign xor_3131 = bits[26] ^ (^{select_3083_s18_q[25:24], other[25:24]});
  logic xor_3134;
  assign xor_3134 = bits[20] ^ (^{select_3083_s18_q[19:18], other[19:18]});
  logic xor_3137;
  assign xor_3137 = bits[23] ^ (^{select_3083_s18_q[22:21], other[22:21]});
  logic xor_3143;
  assign xor_3143 = bits[35] ^ (^{select_3083_s18_q[34:33], other[34:33]});
  logic xor_3146;
  assign xor_3146 = bits[29] ^ (^{select_3083_s18_q[28:27], other[28:27]});
  logic xor_3149;
  assign xor_3149 = bits[32] ^ (^{select_3083_s18_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:184
  logic select_3433;
  assign select_3433 = equal_1763_s18_q ? patches_summed_first_q : (equal_1765_s18_q ? new_row_s18_q : patches_summed_first_q);
  // hls/stages/patches.hpp:538
  logic [9:0] select_3521;
  assign select_3521 = (patches_read_far_s18_q < patches_peak_far_q) ? patches_read_far_s18_q : patches_peak_far_q;
  logic [9:0] select_3522;
  assign select_3522 = patches_read_first_s18_q ? patches_read_far_s18_q : select_3521;
  // hls/stages/patches.hpp:578
  logic [10:0] sum_3564;
  assign sum_3564 = {1'b0, fall_2_s18_q} + {2'h0, fall_2_s18_q[9:1]};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3568;
  assign sum_3568 = {1'b0, fall_2_s18_q} + {3'h0, fall_2_s18_q[9:2]};
  logic less_3572;
  assign less_3572 = {eight_s18_q, 3'h0} < ({fall_2_s18_q, 3'h0} - {3'h0, fall_2_s18_q});
  // hls/stages/patches.hpp:592
  logic [7:0] select_3578;
  assign select_3578 = patches_second_s18_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [3:0] sum_3579;
  assign sum_3579 = {2'h0, select_3512_s18_q[14:13]} + 4'hf;
  logic [5:0] select_3580;
  assign select_3580 = patches_second_s18_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3581;
  assign sum_3581 = {select_3580[5], select_3580} + {{4{sum_3579[3]}}, sum_3579[3:1]};
  // hls/stages/agreement.hpp:1180
  logic or_3857;
  assign or_3857 = ({counts_textured_s18_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s18_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1218
  logic too_little;
  assign too_little = less_3861_s18_q | (product_rest_q & equal_3862_s18_q);
  // hls/stages/agreement.hpp:1219
  logic select_3865;
  assign select_3865 = and_3860_s18_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1128
  logic [10:0] sum_3868;
  assign sum_3868 = {1'b0, select_2573_s18_q} + {2'h0, select_2573_s18_q[9:1]};
  // hls/stages/agreement.hpp:787
  logic select_3920;
  assign select_3920 = equal_671_s18_q ? (equal_3633_s18_q ? sum_4_s18_q : (product_rest_q | sum_4_s18_q)) : product_rest_q;
  logic [2:0] select_3938;
  assign select_3938 = ends_cell_s18_q ? textured_2_s18_q : box_textured_columns_values_0_q;
  logic [2:0] select_3940;
  assign select_3940 = equal_671_s18_q ? box_textured_columns_values_0_q : (so_s18_q ? select_3938 : box_textured_columns_values_0_q);
  logic [2:0] select_3941;
  assign select_3941 = ends_cell_s18_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3943;
  assign select_3943 = equal_671_s18_q ? box_textured_columns_values_1_q : (so_s18_q ? select_3941 : box_textured_columns_values_1_q);
  logic [2:0] select_3944;
  assign select_3944 = ends_cell_s18_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3946;
  assign select_3946 = equal_671_s18_q ? box_textured_columns_values_2_q : (so_s18_q ? select_3944 : box_textured_columns_values_2_q);
  logic [2:0] select_3947;
  assign select_3947 = ends_cell_s18_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3949;
  assign select_3949 = equal_671_s18_q ? box_textured_columns_values_3_q : (so_s18_q ? select_3947 : box_textured_columns_values_3_q);
  logic [2:0] select_3950;
  assign select_3950 = ends_cell_s18_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3952;
  assign select_3952 = equal_671_s18_q ? box_textured_columns_values_4_q : (so_s18_q ? select_3950 : box_textured_columns_values_4_q);
  logic [4:0] select_3972;
  assign select_3972 = so_s18_q ? (ends_cell_s18_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3973;
  assign select_3973 = equal_671_s18_q ? box_explained_sum_sums_values_0_q : select_3972;
  logic [4:0] select_3990;
  assign select_3990 = so_s18_q ? (ends_cell_s18_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4008;
  assign select_4008 = so_s18_q ? (ends_cell_s18_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1292
  logic [3:0] select_4040;
  assign select_4040 = select_2001_s18_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:430
  logic [7:0] select_4046;
  assign select_4046 = marks_first_s18_q ? (less_4042 ? {sum_4043, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1133
  logic [31:0] select_4121;
  assign select_4121 = equal_1607_s18_q ? {2'h0, counts_explained_s18_q, 2'h0, counts_textured_s18_q} : (equal_4119_s18_q ? registration_sums_rdata_s18_q : 32'h0);
  logic [31:0] select_4122;
  assign select_4122 = equal_1605_s18_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4121;

  // Memory moments_memory, 8040 x 4, DISTANCE 16, hls/stages/moments.hpp:84; read in stage 18, written in stage 21: 18 < 21 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:8039];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8040; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_556_s18_q;
  logic moments_memory_re;
  assign moments_memory_re = s18_en & and_560;
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (moments_memory_re) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1875, patches_code_row_s18_q[1:0], of_row_2_s18_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s18_en & and_1909_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1895_s18_q, less_1894_s18_q, less_1885_s18_q, less_1884_s18_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1913, patches_code_row_s18_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s18_en & and_1923_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1895_s18_q, less_1894_s18_q, less_1885_s18_q, less_1884_s18_q, patches_codes_at_q[51:8]};
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
  assign regions_waddr = {region_row_s18_q, or_1952_s18_q, or_1949_s18_q, or_1946_s18_q};
  logic regions_we;
  assign regions_we = s18_en & and_1986_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1985_s18_q, sum_1975_s18_q, sum_1970_s18_q};
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
      sharpness_before_last_mask_q <= select_2287;
      counts_supervised_q <= select_2527;
      counts_nearer_q <= select_2542;
      registration_half_measured_q <= select_2711;
      registration_half_votes_up_q <= and_2684_s18_q ? 7'h0 : sum_2725;
      registration_half_half_votes_up_q <= and_2684_s18_q ? 7'h0 : sum_2739;
      patches_place_0_column_q <= sample_pair_whole_s18_q ? select_1783 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s18_q ? select_1784 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2946;
      patches_place_1_column_q <= sample_pair_whole_s18_q ? select_1812 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s18_q ? select_1813 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2951;
      patches_codes_at_q <= select_3042;
      patches_codes_further_q <= equal_1763_s18_q ? patches_codes_further_q : select_3047;
      patches_next_codes_q <= select_3055;
      patches_summed_first_q <= select_3433;
      patches_peak_far_q <= equal_1763_s18_q ? select_3522 : patches_peak_far_q;
      product_rest_q <= select_3920;
      disagree_q <= equal_671_s18_q ? select_3865 : disagree_q;
      began_q <= not_2014 & (began_q | select_2001_s18_q);
      seen_x_q <= select_2001_s18_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s18_q ? 4'h0 : select_4040;
      seen_column_q <= select_2001_s18_q ? 8'h0 : (seen_column_q + {7'h0, equal_2007});
      seen_rows_left_q <= select_4046;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s18_q ? 13'h0 : (seen_base_q + {6'h0, select_2004});
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
      averager_detail_0_q <= select_2142;
      averager_detail_1_q <= select_2150;
      census_columns_values_2_cell_2_mask_q <= select_2198;
      census_columns_values_2_cell_3_mask_q <= select_2201;
      census_columns_values_2_cell_4_mask_q <= select_2204;
      census_columns_values_3_cell_0_mask_q <= select_2205;
      census_columns_values_3_cell_1_mask_q <= select_2208;
      census_columns_values_3_cell_2_mask_q <= select_2209;
      census_columns_values_3_cell_3_mask_q <= select_2212;
      sharpness_last_mask_q <= and_532_s18_q ? whole_2_s18_q : sharpness_last_mask_q;
      box_textured_columns_values_0_q <= select_3940;
      box_textured_columns_values_1_q <= select_3943;
      box_textured_columns_values_2_q <= select_3946;
      box_textured_columns_values_3_q <= select_3949;
      box_textured_columns_values_4_q <= select_3952;
      box_explained_sum_sums_values_0_q <= select_3973;
      box_shown_sum_sums_values_0_q <= equal_671_s18_q ? box_shown_sum_sums_values_0_q : select_3990;
      box_nearer_sum_sums_values_0_q <= equal_671_s18_q ? box_nearer_sum_sums_values_0_q : select_4008;
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
  logic [3:0] select_493_s19_q;
  logic [6:0] select_496_s19_q;
  logic [6:0] column_s19_q;
  logic and_532_s19_q;
  logic equal_554_s19_q;
  logic [12:0] select_556_s19_q;
  logic less_558_s19_q;
  logic not_559_s19_q;
  logic and_560_s19_q;
  logic and_567_s19_q;
  logic less_572_s19_q;
  logic and_575_s19_q;
  logic whole_16_s19_q;
  logic [9:0] difference_601_s19_q;
  logic so_s19_q;
  logic less_622_s19_q;
  logic less_623_s19_q;
  logic less_624_s19_q;
  logic less_625_s19_q;
  logic less_626_s19_q;
  logic less_627_s19_q;
  logic less_628_s19_q;
  logic less_629_s19_q;
  logic less_630_s19_q;
  logic less_631_s19_q;
  logic less_632_s19_q;
  logic less_633_s19_q;
  logic less_634_s19_q;
  logic less_635_s19_q;
  logic less_636_s19_q;
  logic less_637_s19_q;
  logic less_638_s19_q;
  logic less_639_s19_q;
  logic less_640_s19_q;
  logic less_641_s19_q;
  logic less_642_s19_q;
  logic less_643_s19_q;
  logic less_644_s19_q;
  logic less_645_s19_q;
  logic and_646_s19_q;
  logic [11:0] sum_661_s19_q;
  logic [9:0] sum_664_s19_q;
  logic equal_671_s19_q;
  logic less_681_s19_q;
  logic not_682_s19_q;
  logic not_1544_s19_q;
  logic equal_1585_s19_q;
  logic [1:0] sum_1591_s19_q;
  logic equal_1593_s19_q;
  logic equal_1595_s19_q;
  logic equal_1597_s19_q;
  logic equal_1599_s19_q;
  logic equal_1601_s19_q;
  logic equal_1603_s19_q;
  logic less_1616_s19_q;
  logic [19:0] select_1641_s19_q;
  logic equal_1642_s19_q;
  logic [11:0] sum_1649_s19_q;
  logic and_1650_s19_q;
  logic and_1653_s19_q;
  logic select_1670_s19_q;
  logic equal_1671_s19_q;
  logic equal_1704_s19_q;
  logic equal_1763_s19_q;
  logic equal_1765_s19_q;
  logic equal_1768_s19_q;
  logic select_1779_s19_q;
  logic [7:0] sum_1785_s19_q;
  logic [4:0] select_1793_s19_q;
  logic select_1799_s19_q;
  logic [7:0] sum_1814_s19_q;
  logic equal_1829_s19_q;
  logic equal_1833_s19_q;
  logic [3:0] select_1838_s19_q;
  logic less_1924_s19_q;
  logic equal_1925_s19_q;
  logic not_1926_s19_q;
  logic equal_1927_s19_q;
  logic not_1954_s19_q;
  logic not_2014_s19_q;
  logic [7:0] sum_2024_s19_q;
  logic [3:0] difference_2036_s19_q;
  logic or_2044_s19_q;
  logic [23:0] select_2055_s19_q;
  logic [4:0] around_s19_q;
  logic less_2089_s19_q;
  logic and_2100_s19_q;
  logic [11:0] sum_2229_s19_q;
  logic [9:0] sum_2232_s19_q;
  logic [27:0] select_2284_s19_q;
  logic and_2297_s19_q;
  logic and_2309_s19_q;
  logic [8:0] select_2316_s19_q;
  logic [8:0] select_2320_s19_q;
  logic equal_2323_s19_q;
  logic less_2324_s19_q;
  logic [11:0] select_2329_s19_q;
  logic equal_2367_s19_q;
  logic equal_2394_s19_q;
  logic and_2519_s19_q;
  logic not_2544_s19_q;
  logic [4:0] e_s19_q;
  logic [9:0] select_2570_s19_q;
  logic [9:0] select_2573_s19_q;
  logic and_2621_s19_q;
  logic and_2643_s19_q;
  logic and_2650_s19_q;
  logic and_2684_s19_q;
  logic [7:0] select_2704_s19_q;
  logic [1:0] select_2716_s19_q;
  logic [1:0] select_2731_s19_q;
  logic [11:0] select_2782_s19_q;
  logic and_2790_s19_q;
  logic [11:0] select_2797_s19_q;
  logic and_2808_s19_q;
  logic and_2812_s19_q;
  logic and_2844_s19_q;
  logic and_2852_s19_q;
  logic [8:0] other_s19_q;
  logic [2:0] select_3070_s19_q;
  logic [8:0] select_3083_s19_q;
  logic xor_3098_s19_q;
  logic xor_3116_s19_q;
  logic xor_3128_s19_q;
  logic xor_3140_s19_q;
  logic xor_3152_s19_q;
  logic or_3161_s19_q;
  logic or_3165_s19_q;
  logic or_3169_s19_q;
  logic or_3176_s19_q;
  logic or_3180_s19_q;
  logic or_3184_s19_q;
  logic or_3191_s19_q;
  logic or_3195_s19_q;
  logic or_3199_s19_q;
  logic or_3209_s19_q;
  logic or_3213_s19_q;
  logic or_3217_s19_q;
  logic or_3225_s19_q;
  logic or_3229_s19_q;
  logic or_3233_s19_q;
  logic or_3240_s19_q;
  logic or_3244_s19_q;
  logic or_3248_s19_q;
  logic or_3258_s19_q;
  logic or_3262_s19_q;
  logic or_3266_s19_q;
  logic and_3271_s19_q;
  logic or_3272_s19_q;
  logic equal_3393_s19_q;
  logic [4:0] select_3481_s19_q;
  logic [12:0] select_3512_s19_q;
  logic [9:0] select_3522_s19_q;
  logic less_3555_s19_q;
  logic not_3563_s19_q;
  logic not_3566_s19_q;
  logic not_3570_s19_q;
  logic not_3573_s19_q;
  logic [7:0] select_3578_s19_q;
  logic sum_3579_s19_q;
  logic [6:0] sum_3581_s19_q;
  logic equal_3633_s19_q;
  logic equal_3854_s19_q;
  logic or_3857_s19_q;
  logic select_3865_s19_q;
  logic not_3870_s19_q;
  logic equal_3878_s19_q;
  logic equal_3880_s19_q;
  logic equal_3881_s19_q;
  logic equal_3882_s19_q;
  logic equal_3883_s19_q;
  logic equal_4023_s19_q;
  logic [31:0] select_4122_s19_q;
  logic [9:0] select_4129_s19_q;
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
      select_493_s19_q <= select_493_s18_q;
      select_496_s19_q <= select_496_s18_q;
      column_s19_q <= column_s18_q;
      and_532_s19_q <= and_532_s18_q;
      equal_554_s19_q <= equal_554_s18_q;
      select_556_s19_q <= select_556_s18_q;
      less_558_s19_q <= less_558_s18_q;
      not_559_s19_q <= not_559;
      and_560_s19_q <= and_560;
      and_567_s19_q <= and_567_s18_q;
      less_572_s19_q <= less_572_s18_q;
      and_575_s19_q <= and_575_s18_q;
      whole_16_s19_q <= whole_16;
      difference_601_s19_q <= difference_601_s18_q;
      so_s19_q <= so_s18_q;
      less_622_s19_q <= less_622_s18_q;
      less_623_s19_q <= less_623_s18_q;
      less_624_s19_q <= less_624_s18_q;
      less_625_s19_q <= less_625_s18_q;
      less_626_s19_q <= less_626_s18_q;
      less_627_s19_q <= less_627_s18_q;
      less_628_s19_q <= less_628_s18_q;
      less_629_s19_q <= less_629_s18_q;
      less_630_s19_q <= less_630_s18_q;
      less_631_s19_q <= less_631_s18_q;
      less_632_s19_q <= less_632_s18_q;
      less_633_s19_q <= less_633_s18_q;
      less_634_s19_q <= less_634_s18_q;
      less_635_s19_q <= less_635_s18_q;
      less_636_s19_q <= less_636_s18_q;
      less_637_s19_q <= less_637_s18_q;
      less_638_s19_q <= less_638_s18_q;
      less_639_s19_q <= less_639_s18_q;
      less_640_s19_q <= less_640_s18_q;
      less_641_s19_q <= less_641_s18_q;
      less_642_s19_q <= less_642_s18_q;
      less_643_s19_q <= less_643_s18_q;
      less_644_s19_q <= less_644_s18_q;
      less_645_s19_q <= less_645_s18_q;
      and_646_s19_q <= census_columns_values_1_cell_2_mask_s18_q & and_567_s18_q;
      sum_661_s19_q <= {1'b0, sum_657} + {2'h0, sum_660_s18_q};
      sum_664_s19_q <= sum_664_s18_q;
      equal_671_s19_q <= equal_671_s18_q;
      less_681_s19_q <= less_681_s18_q;
      not_682_s19_q <= not_682_s18_q;
      not_1544_s19_q <= not_1544_s18_q;
      equal_1585_s19_q <= equal_1585_s18_q;
      sum_1591_s19_q <= sum_1591_s18_q;
      equal_1593_s19_q <= equal_1593_s18_q;
      equal_1595_s19_q <= equal_1595_s18_q;
      equal_1597_s19_q <= equal_1597_s18_q;
      equal_1599_s19_q <= equal_1599_s18_q;
      equal_1601_s19_q <= equal_1601_s18_q;
      equal_1603_s19_q <= equal_1603_s18_q;
      less_1616_s19_q <= less_1616_s18_q;
      select_1641_s19_q <= equal_1640_s18_q ? registration_sums_rdata_s18_q[19:0] : 20'h0;
      equal_1642_s19_q <= equal_1642;
      sum_1649_s19_q <= sum_1649;
      and_1650_s19_q <= and_1650_s18_q;
      and_1653_s19_q <= and_1653_s18_q;
      select_1670_s19_q <= select_1670_s18_q;
      equal_1671_s19_q <= equal_1671_s18_q;
      equal_1704_s19_q <= equal_1704_s18_q;
      equal_1763_s19_q <= equal_1763_s18_q;
      equal_1765_s19_q <= equal_1765_s18_q;
      equal_1768_s19_q <= equal_1768_s18_q;
      select_1779_s19_q <= select_1779_s18_q[0];
      sum_1785_s19_q <= select_1783 + {{2{select_1784[5]}}, select_1784};
      select_1793_s19_q <= select_1793_s18_q;
      select_1799_s19_q <= select_1799_s18_q;
      sum_1814_s19_q <= select_1812 + {{2{select_1813[5]}}, select_1813};
      equal_1829_s19_q <= equal_1829;
      equal_1833_s19_q <= equal_1833;
      select_1838_s19_q <= select_1838_s18_q;
      less_1924_s19_q <= less_1924_s18_q;
      equal_1925_s19_q <= equal_1925_s18_q;
      not_1926_s19_q <= not_1926_s18_q;
      equal_1927_s19_q <= equal_1927_s18_q;
      not_1954_s19_q <= not_1954_s18_q;
      not_2014_s19_q <= not_2014;
      sum_2024_s19_q <= {2'h0, x_s18_q[7:2]} + 8'hff;
      difference_2036_s19_q <= {1'b0, textured_2_s18_q} - {1'b0, select_2035};
      or_2044_s19_q <= or_2044_s18_q;
      select_2055_s19_q <= select_2055;
      around_s19_q <= around;
      less_2089_s19_q <= {1'b0, around[4:1]} < n;
      and_2100_s19_q <= and_2100_s18_q;
      sum_2229_s19_q <= {1'b0, sum_2225} + {2'h0, sum_2228};
      sum_2232_s19_q <= {9'h0, difference_2230_s18_q} + {1'b0, xor_2231_s18_q};
      select_2284_s19_q <= sample_pair_whole_s18_q ? {detail_2, detail} : 28'h0;
      and_2297_s19_q <= and_2297;
      and_2309_s19_q <= and_2309;
      select_2316_s19_q <= and_2297 ? contrast_s18_q : 9'h0;
      select_2320_s19_q <= and_2309 ? contrast_2_s18_q : 9'h0;
      equal_2323_s19_q <= x_s18_q[7:3] == 5'h0;
      less_2324_s19_q <= 7'h2 < {x_s18_q[4:0], slot_s18_q[2:1]};
      select_2329_s19_q <= select_2329;
      equal_2367_s19_q <= {x_s18_q[4:0], slot_s18_q} == 8'h0;
      equal_2394_s19_q <= equal_2394_s18_q;
      and_2519_s19_q <= and_2519_s18_q;
      not_2544_s19_q <= not_2544_s18_q;
      e_s19_q <= e;
      select_2570_s19_q <= select_2570_s18_q;
      select_2573_s19_q <= select_2573_s18_q;
      and_2621_s19_q <= and_2621_s18_q;
      and_2643_s19_q <= and_2643_s18_q;
      and_2650_s19_q <= and_2650_s18_q;
      and_2684_s19_q <= and_2684_s18_q;
      select_2704_s19_q <= equal_671_s18_q ? 8'h0 : (so_s18_q ? select_2702 : 8'h0);
      select_2716_s19_q <= equal_671_s18_q ? 2'h0 : select_2715;
      select_2731_s19_q <= equal_671_s18_q ? 2'h0 : select_2730;
      select_2782_s19_q <= select_2782;
      and_2790_s19_q <= equal_671_s18_q & (x_s18_q[6] & and_2788);
      select_2797_s19_q <= select_2797;
      and_2808_s19_q <= equal_671_s18_q & (x_s18_q[6] & and_2806);
      and_2812_s19_q <= and_2812;
      and_2844_s19_q <= equal_671_s18_q & (x_s18_q[6] & and_2842);
      and_2852_s19_q <= x_s18_q[6] & and_2851;
      other_s19_q <= other[44:36];
      select_3070_s19_q <= equal_1765_s18_q ? 3'h0 : select_3069;
      select_3083_s19_q <= select_3083_s18_q[44:36];
      xor_3098_s19_q <= xor_3098;
      xor_3116_s19_q <= xor_3098 ^ parity_3115;
      xor_3128_s19_q <= xor_3119 ^ (^{select_3083_s18_q[41:36], other[41:36]});
      xor_3140_s19_q <= xor_3131 ^ (^{select_3083_s18_q[23:18], other[23:18]});
      xor_3152_s19_q <= xor_3143 ^ (^{select_3083_s18_q[32:27], other[32:27]});
      or_3161_s19_q <= (xor_3092 & xor_3095) | (xor_3089 & (xor_3092 | xor_3095));
      or_3165_s19_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3169_s19_q <= (xor_3107 & xor_3110) | (xor_3104 & (xor_3107 | xor_3110));
      or_3176_s19_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3180_s19_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3184_s19_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3191_s19_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3195_s19_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3199_s19_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3209_s19_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3213_s19_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3217_s19_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3225_s19_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3229_s19_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3233_s19_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3240_s19_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3244_s19_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3248_s19_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3258_s19_q <= (xor_3122 & xor_3125) | (xor_3119 & (xor_3122 | xor_3125));
      or_3262_s19_q <= (xor_3134 & xor_3137) | (xor_3131 & (xor_3134 | xor_3137));
      or_3266_s19_q <= (xor_3146 & xor_3149) | (xor_3143 & (xor_3146 | xor_3149));
      and_3271_s19_q <= xor_3101 & xor_3113;
      or_3272_s19_q <= xor_3101 | xor_3113;
      equal_3393_s19_q <= equal_3393_s18_q;
      select_3481_s19_q <= select_3481_s18_q;
      select_3512_s19_q <= select_3512_s18_q[12:0];
      select_3522_s19_q <= select_3522;
      less_3555_s19_q <= less_3555_s18_q;
      not_3563_s19_q <= ~({eight_s18_q, 3'h0} < {3'h0, fall_2_s18_q});
      not_3566_s19_q <= ~({eight_s18_q, 3'h0} < {1'b0, sum_3564, fall_2_s18_q[0]});
      not_3570_s19_q <= ~({eight_s18_q, 3'h0} < {sum_3568, fall_2_s18_q[1:0]});
      not_3573_s19_q <= ~less_3572;
      select_3578_s19_q <= select_3578;
      sum_3579_s19_q <= sum_3579[0];
      sum_3581_s19_q <= sum_3581;
      equal_3633_s19_q <= equal_3633_s18_q;
      equal_3854_s19_q <= select_2570_s18_q[9:3] == 7'h0;
      or_3857_s19_q <= or_3857;
      select_3865_s19_q <= select_3865;
      not_3870_s19_q <= ~({sum_3868, select_2573_s18_q[0]} < {2'h0, select_2570_s18_q});
      equal_3878_s19_q <= equal_3878_s18_q;
      equal_3880_s19_q <= equal_3880_s18_q;
      equal_3881_s19_q <= equal_3881_s18_q;
      equal_3882_s19_q <= equal_3882_s18_q;
      equal_3883_s19_q <= equal_3883_s18_q;
      equal_4023_s19_q <= equal_4023_s18_q;
      select_4122_s19_q <= select_4122;
      select_4129_s19_q <= select_4129_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_3_cell_4_mask_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic moments_whole_frames_q;
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
  // hls/stages/agreement.hpp:451
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
  // hls/stages/census.hpp:275
  logic [11:0] texture;
  assign texture = sum_661_s19_q + {2'h0, sum_664_s19_q};
  // hls/stages/agreement.hpp:1140
  logic equal_672;
  assign equal_672 = x_s19_q == 7'h7f;
  logic equal_673;
  assign equal_673 = x_s19_q == 7'h70;
  // hls/stages/agreement.hpp:787
  logic select_675;
  assign select_675 = equal_672 ? moments_whole_frames_q : (moments_whole_frames_q | equal_673);
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1591_s19_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1644;
  assign select_1644 = equal_1642_s19_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1781;
  assign select_1781 = equal_1671_s19_q ? patches_place_0_valid_q : (select_1670_s19_q ? patches_place_0_valid_q : select_1779_s19_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1786;
  assign sum_1786 = sum_1785_s19_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1787;
  assign equal_1787 = {sum_1786[7], select_496_s19_q, select_493_s19_q} == {1'b0, sum_1786[6:0], 4'h8};
  // hls/stages/patches.hpp:127
  logic select_1810;
  assign select_1810 = equal_1671_s19_q ? patches_place_1_valid_q : (select_1670_s19_q ? select_1779_s19_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1815;
  assign sum_1815 = sum_1814_s19_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1816;
  assign equal_1816 = {sum_1815[7], select_496_s19_q, select_493_s19_q} == {1'b0, sum_1815[6:0], 4'h8};
  // hls/stages/agreement.hpp:1300
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1267
  logic select_2012;
  assign select_2012 = marks_first_s19_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1253
  logic [10:0] sum_2013;
  assign sum_2013 = {1'b0, {5{select_2012}}, 1'b0, {2{select_2012}}, 1'b0, select_2012} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1104
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2024_s19_q[7]}}, sum_2024_s19_q, x_s19_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1253
  logic [10:0] sum_2026;
  assign sum_2026 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1087
  logic [4:0] t;
  assign t = {difference_2036_s19_q[3], difference_2036_s19_q} + (equal_1704_s19_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1094
  logic [47:0] select_2056;
  assign select_2056 = or_2044_s19_q ? {select_2055_s19_q[23], 1'b0, select_2055_s19_q[22], 1'b0, select_2055_s19_q[21], 1'b0, select_2055_s19_q[20], 1'b0, select_2055_s19_q[19], 1'b0, select_2055_s19_q[18], 1'b0, select_2055_s19_q[17], 1'b0, select_2055_s19_q[16], 1'b0, select_2055_s19_q[15], 1'b0, select_2055_s19_q[14], 1'b0, select_2055_s19_q[13], 1'b0, select_2055_s19_q[12], 1'b0, select_2055_s19_q[11], 1'b0, select_2055_s19_q[10], 1'b0, select_2055_s19_q[9], 1'b0, select_2055_s19_q[8], 1'b0, select_2055_s19_q[7], 1'b0, select_2055_s19_q[6], 1'b0, select_2055_s19_q[5], 1'b0, select_2055_s19_q[4], 1'b0, select_2055_s19_q[3], 1'b0, select_2055_s19_q[2], 1'b0, select_2055_s19_q[1], 1'b0, select_2055_s19_q[0], 1'b0} : {1'b0, select_2055_s19_q[23], 1'b0, select_2055_s19_q[22], 1'b0, select_2055_s19_q[21], 1'b0, select_2055_s19_q[20], 1'b0, select_2055_s19_q[19], 1'b0, select_2055_s19_q[18], 1'b0, select_2055_s19_q[17], 1'b0, select_2055_s19_q[16], 1'b0, select_2055_s19_q[15], 1'b0, select_2055_s19_q[14], 1'b0, select_2055_s19_q[13], 1'b0, select_2055_s19_q[12], 1'b0, select_2055_s19_q[11], 1'b0, select_2055_s19_q[10], 1'b0, select_2055_s19_q[9], 1'b0, select_2055_s19_q[8], 1'b0, select_2055_s19_q[7], 1'b0, select_2055_s19_q[6], 1'b0, select_2055_s19_q[5], 1'b0, select_2055_s19_q[4], 1'b0, select_2055_s19_q[3], 1'b0, select_2055_s19_q[2], 1'b0, select_2055_s19_q[1], 1'b0, select_2055_s19_q[0]};
  // hls/stages/agreement.hpp:1096
  logic [5:0] sum_2073;
  assign sum_2073 = {1'b0, around_s19_q} + {2'h0, around_s19_q[4:1]};
  // hls/stages/agreement.hpp:518
  logic select_2213;
  assign select_2213 = and_532_s19_q ? census_columns_values_2_cell_4_mask_s19_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:277
  logic [11:0] sum_2233;
  assign sum_2233 = sum_2229_s19_q + {2'h0, sum_2232_s19_q};
  // hls/stages/agreement.hpp:518
  logic [11:0] select_2235;
  assign select_2235 = and_532_s19_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2236;
  assign select_2236 = and_532_s19_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2285;
  assign select_2285 = and_532_s19_q ? select_2284_s19_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2286;
  assign select_2286 = and_532_s19_q ? select_2284_s19_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:365
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2284_s19_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2284_s19_q[27:14]};
  // hls/stages/census.hpp:368
  logic [23:0] sum_2317;
  assign sum_2317 = (equal_554_s19_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2316_s19_q};
  logic [23:0] sum_2321;
  assign sum_2321 = (equal_554_s19_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2320_s19_q};
  // hls/stages/census.hpp:420
  logic less_2325;
  assign less_2325 = x_s19_q[4:0] < 5'h3;
  logic [23:0] select_2330;
  assign select_2330 = slot_s19_q ? {select_2329_s19_q[11], 1'b0, select_2329_s19_q[10], 1'b0, select_2329_s19_q[9], 1'b0, select_2329_s19_q[8], 1'b0, select_2329_s19_q[7], 1'b0, select_2329_s19_q[6], 1'b0, select_2329_s19_q[5], 1'b0, select_2329_s19_q[4], 1'b0, select_2329_s19_q[3], 1'b0, select_2329_s19_q[2], 1'b0, select_2329_s19_q[1], 1'b0, select_2329_s19_q[0], 1'b0} : {1'b0, select_2329_s19_q[11], 1'b0, select_2329_s19_q[10], 1'b0, select_2329_s19_q[9], 1'b0, select_2329_s19_q[8], 1'b0, select_2329_s19_q[7], 1'b0, select_2329_s19_q[6], 1'b0, select_2329_s19_q[5], 1'b0, select_2329_s19_q[4], 1'b0, select_2329_s19_q[3], 1'b0, select_2329_s19_q[2], 1'b0, select_2329_s19_q[1], 1'b0, select_2329_s19_q[0]};
  // hls/stages/census.hpp:383
  logic and_2334;
  assign and_2334 = less_2325 & (~((sharpness_sums_contrast_1_q & select_2330) == 24'h0));
  logic and_2344;
  assign and_2344 = less_2325 & (~((sharpness_sums_contrast_0_q & select_2330) == 24'h0));
  // hls/stages/agreement.hpp:1095
  logic [5:0] sum_2557;
  assign sum_2557 = {1'b0, e_s19_q} + {2'h0, e_s19_q[4:1]};
  // hls/stages/agreement.hpp:1126
  logic [10:0] sum_2574;
  assign sum_2574 = {1'b0, select_2573_s19_q} + {3'h0, select_2573_s19_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2705;
  assign sum_2705 = registration_half_across_q + {{6{select_2704_s19_q[7]}}, select_2704_s19_q};
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2717;
  assign sum_2717 = registration_half_votes_down_q + {{5{select_2716_s19_q[1]}}, select_2716_s19_q};
  logic [6:0] sum_2732;
  assign sum_2732 = registration_half_half_votes_down_q + {{5{select_2731_s19_q[1]}}, select_2731_s19_q};
  // hls/stages/agreement.hpp:787
  logic and_2773;
  assign and_2773 = equal_671_s19_q & (x_s19_q[6] & (not_1954_s19_q & less_1616_s19_q));
  logic [11:0] select_2784;
  assign select_2784 = equal_671_s19_q ? (x_s19_q[6] ? select_2782_s19_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2792;
  assign sum_2792 = {{2{select_2784[11]}}, select_2784} + (and_2790_s19_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:787
  logic [11:0] select_2799;
  assign select_2799 = equal_671_s19_q ? (x_s19_q[6] ? select_2797_s19_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2801;
  assign sum_2801 = {{2{select_2799[11]}}, select_2799} + (and_2790_s19_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2813;
  assign not_2813 = ~and_2812_s19_q;
  logic less_2814;
  assign less_2814 = $signed({9'h1, {2{not_2813}}, and_2812_s19_q}) < $signed(registration_up_q[13:2]);
  logic select_2815;
  assign select_2815 = and_2808_s19_q ? less_2814 : registration_enough_q;
  // hls/stages/agreement.hpp:1135
  logic and_2819;
  assign and_2819 = x_s19_q[6] & (not_1954_s19_q & (less_1616_s19_q & (x_s19_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:787
  logic and_2820;
  assign and_2820 = equal_671_s19_q & and_2819;
  // hls/stages/registration.hpp:242
  logic less_2821;
  assign less_2821 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2823;
  assign less_2823 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2825;
  assign equal_2825 = x_s19_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:787
  logic and_2829;
  assign and_2829 = equal_671_s19_q & (x_s19_q[6] & (not_1954_s19_q & (less_1616_s19_q & equal_2825)));
  // hls/stages/agreement.hpp:1135
  logic and_2836;
  assign and_2836 = x_s19_q[6] & (not_1954_s19_q & (less_1616_s19_q & (x_s19_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2854;
  assign and_2854 = registration_votes_up_q & registration_other_down_q;
  logic select_2856;
  assign select_2856 = registration_votes_down_q ? (registration_other_up_q | and_2854) : and_2854;
  // hls/stages/registration.hpp:138
  logic and_2858;
  assign and_2858 = (equal_671_s19_q & and_2852_s19_q) & (registration_other_enough_q & select_2856);
  logic and_2860;
  assign and_2860 = registration_enough_q & ((and_2844_s19_q & (less_2823 | less_2821)) | and_2858);
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3073;
  assign sum_3073 = {7'h0, patches_set_q} + (equal_1768_s19_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3153;
  assign xor_3153 = xor_3140_s19_q ^ xor_3152_s19_q;
  // hls/stages/count_bits.hpp:25
  logic or_3278;
  assign or_3278 = (xor_3140_s19_q & xor_3152_s19_q) | (xor_3128_s19_q & (xor_3140_s19_q | xor_3152_s19_q));
  // hls/stages/patches.hpp:578
  logic [1:0] sum_3567;
  assign sum_3567 = {1'b0, not_3563_s19_q} + {1'b0, not_3566_s19_q};
  // hls/stages/patches.hpp:579
  logic [1:0] sum_3574;
  assign sum_3574 = {1'b0, not_3570_s19_q} + {1'b0, not_3573_s19_q};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3567} + {1'b0, sum_3574};
  // hls/stages/patches.hpp:592
  logic [18:0] product_3582;
  assign product_3582 = $signed({{11{select_3578_s19_q[7]}}, select_3578_s19_q}) * $signed({{8{sum_3581_s19_q[6]}}, sum_3581_s19_q, sum_3579_s19_q, select_3512_s19_q[12:10]});
  // hls/stages/patches.hpp:600
  logic [11:0] sum_3759;
  assign sum_3759 = {sum_3581_s19_q[6], sum_3581_s19_q, sum_3579_s19_q, select_3512_s19_q[12:10]} + 12'h1;
  // hls/stages/agreement.hpp:1128
  logic select_3871;
  assign select_3871 = equal_3854_s19_q ? ((~or_3857_s19_q) & (~select_3865_s19_q)) : not_3870_s19_q;
  // hls/stages/agreement.hpp:1135
  logic [47:0] select_3873;
  assign select_3873 = x_s19_q[6] ? (equal_1585_s19_q ? good_q : {select_3871, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:787
  logic [4:0] select_3954;
  assign select_3954 = so_s19_q ? (ends_cell_s19_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:458
  logic [12:0] select_4026;
  assign select_4026 = equal_2394_s19_q ? (equal_4023_s19_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:518
  logic [6:0] select_4029;
  assign select_4029 = and_532_s19_q ? (equal_2394_s19_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_whole_frames_q <= 1'b0;
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
      moments_whole_frames_q <= equal_671_s19_q ? select_675 : moments_whole_frames_q;
      sharpness_sums_contrast_0_q <= and_532_s19_q ? sum_2317 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_532_s19_q ? sum_2321 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2684_s19_q ? 14'h0 : sum_2705;
      registration_half_votes_down_q <= and_2684_s19_q ? 7'h0 : sum_2717;
      registration_half_half_votes_down_q <= and_2684_s19_q ? 7'h0 : sum_2732;
      registration_down_q <= and_2773 ? sum_2792 : registration_down_q;
      registration_up_q <= and_2773 ? sum_2801 : registration_up_q;
      registration_enough_q <= select_2815;
      registration_votes_down_q <= and_2820 ? less_2821 : registration_votes_down_q;
      registration_votes_up_q <= and_2820 ? less_2823 : registration_votes_up_q;
      registration_other_enough_q <= and_2829 ? select_2815 : registration_other_enough_q;
      registration_other_down_q <= and_2829 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2829 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s19_q ? select_1781 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s19_q ? select_1810 : patches_place_1_valid_q;
      patches_set_q <= equal_1763_s19_q ? 3'h0 : select_3070_s19_q;
      patches_size_q <= sum_3073;
      good_q <= equal_671_s19_q ? select_3873 : good_q;
      map_row_q <= and_532_s19_q ? select_4026 : map_row_q;
      map_width_q <= select_4029;
      write_half_q <= marks_first_s19_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2012;
      done_q <= not_2014_s19_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s19_q;
      said_q <= equal_671_s19_q & equal_672;
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
      census_columns_values_3_cell_4_mask_q <= select_2213;
      census_changes_values_0_left_q <= and_532_s19_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_532_s19_q ? sum_2233 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2235;
      census_changes_values_1_right_q <= select_2236;
      sharpness_last_detail_0_q <= select_2285;
      sharpness_last_detail_1_q <= select_2286;
      box_textured_sum_sums_values_0_q <= equal_671_s19_q ? box_textured_sum_sums_values_0_q : select_3954;
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
  logic and_532_s20_q;
  logic equal_554_s20_q;
  logic [12:0] select_556_s20_q;
  logic less_558_s20_q;
  logic not_559_s20_q;
  logic and_560_s20_q;
  logic [3:0] moments_memory_rdata_s20_q;
  logic and_567_s20_q;
  logic less_572_s20_q;
  logic and_575_s20_q;
  logic and_600_s20_q;
  logic [9:0] difference_601_s20_q;
  logic less_622_s20_q;
  logic less_623_s20_q;
  logic less_624_s20_q;
  logic less_625_s20_q;
  logic less_626_s20_q;
  logic less_627_s20_q;
  logic less_628_s20_q;
  logic less_629_s20_q;
  logic less_630_s20_q;
  logic less_631_s20_q;
  logic less_632_s20_q;
  logic less_633_s20_q;
  logic less_634_s20_q;
  logic less_635_s20_q;
  logic less_636_s20_q;
  logic less_637_s20_q;
  logic less_638_s20_q;
  logic less_639_s20_q;
  logic less_640_s20_q;
  logic less_641_s20_q;
  logic less_642_s20_q;
  logic less_643_s20_q;
  logic less_644_s20_q;
  logic less_645_s20_q;
  logic and_646_s20_q;
  logic [12:0] sum_666_s20_q;
  logic equal_671_s20_q;
  logic equal_672_s20_q;
  logic equal_673_s20_q;
  logic less_681_s20_q;
  logic not_682_s20_q;
  logic not_1544_s20_q;
  logic equal_1585_s20_q;
  logic [1:0] sum_1591_s20_q;
  logic equal_1593_s20_q;
  logic equal_1595_s20_q;
  logic equal_1597_s20_q;
  logic equal_1599_s20_q;
  logic equal_1601_s20_q;
  logic equal_1603_s20_q;
  logic [19:0] sum_1645_s20_q;
  logic [11:0] sum_1649_s20_q;
  logic and_1650_s20_q;
  logic and_1653_s20_q;
  logic select_1670_s20_q;
  logic equal_1671_s20_q;
  logic equal_1763_s20_q;
  logic equal_1765_s20_q;
  logic select_1779_s20_q;
  logic select_1781_s20_q;
  logic equal_1787_s20_q;
  logic [4:0] select_1793_s20_q;
  logic select_1799_s20_q;
  logic select_1810_s20_q;
  logic equal_1816_s20_q;
  logic or_1831_s20_q;
  logic or_1835_s20_q;
  logic [3:0] select_1838_s20_q;
  logic less_1924_s20_q;
  logic equal_1925_s20_q;
  logic not_1926_s20_q;
  logic equal_1927_s20_q;
  logic not_1954_s20_q;
  logic [2:0] index_s20_q;
  logic [10:0] sum_2013_s20_q;
  logic and_2020_s20_q;
  logic less_2021_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_2026_s20_q;
  logic equal_2039_s20_q;
  logic not_2059_s20_q;
  logic not_2075_s20_q;
  logic less_2089_s20_q;
  logic and_2100_s20_q;
  logic [12:0] sum_2239_s20_q;
  logic [12:0] select_2299_s20_q;
  logic [12:0] select_2311_s20_q;
  logic equal_2323_s20_q;
  logic less_2324_s20_q;
  logic and_2334_s20_q;
  logic and_2344_s20_q;
  logic equal_2367_s20_q;
  logic and_2519_s20_q;
  logic not_2544_s20_q;
  logic not_2559_s20_q;
  logic [9:0] select_2570_s20_q;
  logic [9:0] select_2573_s20_q;
  logic less_2575_s20_q;
  logic and_2621_s20_q;
  logic and_2643_s20_q;
  logic and_2650_s20_q;
  logic equal_2825_s20_q;
  logic not_2838_s20_q;
  logic and_2860_s20_q;
  logic parity_3157_s20_q;
  logic or_3161_s20_q;
  logic or_3165_s20_q;
  logic or_3169_s20_q;
  logic or_3176_s20_q;
  logic or_3180_s20_q;
  logic or_3184_s20_q;
  logic or_3191_s20_q;
  logic or_3195_s20_q;
  logic or_3199_s20_q;
  logic or_3209_s20_q;
  logic or_3213_s20_q;
  logic or_3217_s20_q;
  logic or_3225_s20_q;
  logic or_3229_s20_q;
  logic or_3233_s20_q;
  logic or_3240_s20_q;
  logic or_3244_s20_q;
  logic or_3248_s20_q;
  logic or_3258_s20_q;
  logic or_3262_s20_q;
  logic or_3266_s20_q;
  logic and_3270_s20_q;
  logic or_3274_s20_q;
  logic or_3278_s20_q;
  logic equal_3393_s20_q;
  logic [4:0] select_3481_s20_q;
  logic [9:0] select_3512_s20_q;
  logic [9:0] select_3522_s20_q;
  logic less_3555_s20_q;
  logic [2:0] fraction_s20_q;
  logic [13:0] product_3582_s20_q;
  logic equal_3633_s20_q;
  logic less_3760_s20_q;
  logic or_3857_s20_q;
  logic select_3865_s20_q;
  logic equal_3878_s20_q;
  logic equal_3880_s20_q;
  logic equal_3881_s20_q;
  logic equal_3882_s20_q;
  logic equal_3883_s20_q;
  logic [31:0] select_4122_s20_q;
  logic [9:0] select_4129_s20_q;
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
      and_532_s20_q <= and_532_s19_q;
      equal_554_s20_q <= equal_554_s19_q;
      select_556_s20_q <= select_556_s19_q;
      less_558_s20_q <= less_558_s19_q;
      not_559_s20_q <= not_559_s19_q;
      and_560_s20_q <= and_560_s19_q;
      moments_memory_rdata_s20_q <= moments_memory_rdata_q;
      and_567_s20_q <= and_567_s19_q;
      less_572_s20_q <= less_572_s19_q;
      and_575_s20_q <= and_575_s19_q;
      and_600_s20_q <= whole_22 & and_567_s19_q;
      difference_601_s20_q <= difference_601_s19_q;
      less_622_s20_q <= less_622_s19_q;
      less_623_s20_q <= less_623_s19_q;
      less_624_s20_q <= less_624_s19_q;
      less_625_s20_q <= less_625_s19_q;
      less_626_s20_q <= less_626_s19_q;
      less_627_s20_q <= less_627_s19_q;
      less_628_s20_q <= less_628_s19_q;
      less_629_s20_q <= less_629_s19_q;
      less_630_s20_q <= less_630_s19_q;
      less_631_s20_q <= less_631_s19_q;
      less_632_s20_q <= less_632_s19_q;
      less_633_s20_q <= less_633_s19_q;
      less_634_s20_q <= less_634_s19_q;
      less_635_s20_q <= less_635_s19_q;
      less_636_s20_q <= less_636_s19_q;
      less_637_s20_q <= less_637_s19_q;
      less_638_s20_q <= less_638_s19_q;
      less_639_s20_q <= less_639_s19_q;
      less_640_s20_q <= less_640_s19_q;
      less_641_s20_q <= less_641_s19_q;
      less_642_s20_q <= less_642_s19_q;
      less_643_s20_q <= less_643_s19_q;
      less_644_s20_q <= less_644_s19_q;
      less_645_s20_q <= less_645_s19_q;
      and_646_s20_q <= and_646_s19_q;
      sum_666_s20_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_671_s20_q <= equal_671_s19_q;
      equal_672_s20_q <= equal_672;
      equal_673_s20_q <= equal_673;
      less_681_s20_q <= less_681_s19_q;
      not_682_s20_q <= not_682_s19_q;
      not_1544_s20_q <= not_1544_s19_q;
      equal_1585_s20_q <= equal_1585_s19_q;
      sum_1591_s20_q <= sum_1591_s19_q;
      equal_1593_s20_q <= equal_1593_s19_q;
      equal_1595_s20_q <= equal_1595_s19_q;
      equal_1597_s20_q <= equal_1597_s19_q;
      equal_1599_s20_q <= equal_1599_s19_q;
      equal_1601_s20_q <= equal_1601_s19_q;
      equal_1603_s20_q <= equal_1603_s19_q;
      sum_1645_s20_q <= select_1641_s19_q + {{6{select_1644[13]}}, select_1644};
      sum_1649_s20_q <= sum_1649_s19_q;
      and_1650_s20_q <= and_1650_s19_q;
      and_1653_s20_q <= and_1653_s19_q;
      select_1670_s20_q <= select_1670_s19_q;
      equal_1671_s20_q <= equal_1671_s19_q;
      equal_1763_s20_q <= equal_1763_s19_q;
      equal_1765_s20_q <= equal_1765_s19_q;
      select_1779_s20_q <= select_1779_s19_q;
      select_1781_s20_q <= select_1781;
      equal_1787_s20_q <= equal_1787;
      select_1793_s20_q <= select_1793_s19_q;
      select_1799_s20_q <= select_1799_s19_q;
      select_1810_s20_q <= select_1810;
      equal_1816_s20_q <= equal_1816;
      or_1831_s20_q <= and_1653_s19_q | (select_1781 & equal_1829_s19_q);
      or_1835_s20_q <= and_1653_s19_q | (select_1810 & equal_1833_s19_q);
      select_1838_s20_q <= select_1838_s19_q;
      less_1924_s20_q <= less_1924_s19_q;
      equal_1925_s20_q <= equal_1925_s19_q;
      not_1926_s20_q <= not_1926_s19_q;
      equal_1927_s20_q <= equal_1927_s19_q;
      not_1954_s20_q <= not_1954_s19_q;
      index_s20_q <= index[2:0];
      sum_2013_s20_q <= sum_2013;
      and_2020_s20_q <= began_q & (seen_x_q == 4'h0);
      less_2021_s20_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s20_q <= index_2[2:0];
      sum_2026_s20_q <= sum_2026;
      equal_2039_s20_q <= t[4:1] == 4'h0;
      not_2059_s20_q <= ~((good_q & select_2056) == 48'h0);
      not_2075_s20_q <= ~({sum_2073, around_s19_q[0]} < {2'h0, t});
      less_2089_s20_q <= less_2089_s19_q;
      and_2100_s20_q <= and_2100_s19_q;
      sum_2239_s20_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2233};
      select_2299_s20_q <= and_2297_s19_q ? detail_3[14:2] : 13'h0;
      select_2311_s20_q <= and_2309_s19_q ? detail_4[14:2] : 13'h0;
      equal_2323_s20_q <= equal_2323_s19_q;
      less_2324_s20_q <= less_2324_s19_q;
      and_2334_s20_q <= and_2334;
      and_2344_s20_q <= and_2344;
      equal_2367_s20_q <= equal_2367_s19_q;
      and_2519_s20_q <= and_2519_s19_q;
      not_2544_s20_q <= not_2544_s19_q;
      not_2559_s20_q <= ~({sum_2557, e_s19_q[0]} < {2'h0, t});
      select_2570_s20_q <= select_2570_s19_q;
      select_2573_s20_q <= select_2573_s19_q;
      less_2575_s20_q <= {sum_2574, select_2573_s19_q[1:0]} < {3'h0, select_2570_s19_q};
      and_2621_s20_q <= and_2621_s19_q;
      and_2643_s20_q <= and_2643_s19_q;
      and_2650_s20_q <= and_2650_s19_q;
      equal_2825_s20_q <= equal_2825;
      not_2838_s20_q <= ~(equal_671_s19_q & and_2836);
      and_2860_s20_q <= and_2860;
      parity_3157_s20_q <= ^{xor_3153, xor_3116_s19_q, select_3083_s19_q, other_s19_q};
      or_3161_s20_q <= or_3161_s19_q;
      or_3165_s20_q <= or_3165_s19_q;
      or_3169_s20_q <= or_3169_s19_q;
      or_3176_s20_q <= or_3176_s19_q;
      or_3180_s20_q <= or_3180_s19_q;
      or_3184_s20_q <= or_3184_s19_q;
      or_3191_s20_q <= or_3191_s19_q;
      or_3195_s20_q <= or_3195_s19_q;
      or_3199_s20_q <= or_3199_s19_q;
      or_3209_s20_q <= or_3209_s19_q;
      or_3213_s20_q <= or_3213_s19_q;
      or_3217_s20_q <= or_3217_s19_q;
      or_3225_s20_q <= or_3225_s19_q;
      or_3229_s20_q <= or_3229_s19_q;
      or_3233_s20_q <= or_3233_s19_q;
      or_3240_s20_q <= or_3240_s19_q;
      or_3244_s20_q <= or_3244_s19_q;
      or_3248_s20_q <= or_3248_s19_q;
      or_3258_s20_q <= or_3258_s19_q;
      or_3262_s20_q <= or_3262_s19_q;
      or_3266_s20_q <= or_3266_s19_q;
      and_3270_s20_q <= xor_3116_s19_q & (^{xor_3153, select_3083_s19_q, other_s19_q});
      or_3274_s20_q <= and_3271_s19_q | (xor_3098_s19_q & or_3272_s19_q);
      or_3278_s20_q <= or_3278;
      equal_3393_s20_q <= equal_3393_s19_q;
      select_3481_s20_q <= select_3481_s19_q;
      select_3512_s20_q <= select_3512_s19_q[9:0];
      select_3522_s20_q <= select_3522_s19_q;
      less_3555_s20_q <= less_3555_s19_q;
      fraction_s20_q <= fraction;
      product_3582_s20_q <= product_3582[18:5];
      equal_3633_s20_q <= equal_3633_s19_q;
      less_3760_s20_q <= {{4{sum_3759[11]}}, sum_3759} < 16'h3;
      or_3857_s20_q <= or_3857_s19_q;
      select_3865_s20_q <= select_3865_s19_q;
      equal_3878_s20_q <= equal_3878_s19_q;
      equal_3880_s20_q <= equal_3880_s19_q;
      equal_3881_s20_q <= equal_3881_s19_q;
      equal_3882_s20_q <= equal_3882_s19_q;
      equal_3883_s20_q <= equal_3883_s19_q;
      select_4122_s20_q <= select_4122_s19_q;
      select_4129_s20_q <= select_4129_s19_q;
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
  // hls/stages/agreement.hpp:451
  logic [9:0] select_602;
  assign select_602 = and_600_s20_q ? difference_601_s20_q : 10'h0;
  // hls/stages/moments.hpp:53
  logic less_603;
  assign less_603 = $signed(6'h0) < $signed(select_602[9:4]);
  // hls/stages/census.hpp:286
  logic [13:0] sum_667;
  assign sum_667 = {2'h0, census_changes_values_1_left_s20_q} + {1'b0, sum_666_s20_q};
  logic [13:0] sum_668;
  assign sum_668 = {2'h0, census_changes_values_2_left_q} + sum_667;
  // hls/stages/moments.hpp:54
  logic and_679;
  assign and_679 = moments_whole_frames_q & (~(moments_memory_rdata_s20_q[1:0] == 2'h0));
  // hls/stages/agreement.hpp:452
  logic and_684;
  assign and_684 = and_679 & (moments_memory_rdata_s20_q[0] ? less_681_s20_q : not_682_s20_q);
  // hls/stages/moments.hpp:54
  logic and_688;
  assign and_688 = moments_whole_frames_q & (~(moments_memory_rdata_s20_q[3:2] == 2'h0));
  // hls/stages/moments.hpp:55
  logic select_692;
  assign select_692 = moments_memory_rdata_s20_q[2] ? ($signed(select_602) < $signed(10'h1)) : (~select_602[9]);
  // hls/stages/patches.hpp:134
  logic [4:0] select_1832;
  assign select_1832 = or_1831_s20_q ? {and_1653_s20_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1836;
  assign select_1836 = or_1835_s20_q ? {and_1653_s20_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1832[4] ? select_1836[3:0] : select_1832[3:0];
  logic and_1841;
  assign and_1841 = select_1799_s20_q & (select_1793_s20_q[3] ^ select_1793_s20_q[4]);
  logic and_1846;
  assign and_1846 = sample_pair_whole_s20_q & (and_1841 & ((~select_1832[4]) | (~select_1836[4])));
  // hls/stages/agreement.hpp:1023
  logic and_2060;
  assign and_2060 = good_known_q & not_2059_s20_q;
  // hls/stages/agreement.hpp:1096
  logic is_seen;
  assign is_seen = equal_2039_s20_q ? and_2060 : not_2075_s20_q;
  // hls/stages/agreement.hpp:518
  logic [11:0] select_2237;
  assign select_2237 = and_532_s20_q ? census_changes_values_1_left_s20_q : census_changes_values_2_left_q;
  logic [11:0] select_2238;
  assign select_2238 = and_532_s20_q ? census_changes_values_1_right_s20_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:287
  logic [13:0] sum_2240;
  assign sum_2240 = {2'h0, census_changes_values_1_right_s20_q} + {1'b0, sum_2239_s20_q};
  logic [13:0] sum_2241;
  assign sum_2241 = {2'h0, census_changes_values_2_right_q} + sum_2240;
  // hls/stages/census.hpp:368
  logic [23:0] select_2301;
  assign select_2301 = equal_554_s20_q ? {11'h0, select_2299_s20_q} : (sharpness_sums_detail_0_q + {11'h0, select_2299_s20_q});
  logic [23:0] select_2313;
  assign select_2313 = equal_554_s20_q ? {11'h0, select_2311_s20_q} : (sharpness_sums_detail_1_q + {11'h0, select_2311_s20_q});
  // hls/stages/census.hpp:388
  logic [17:0] select_2336;
  assign select_2336 = (less_2324_s20_q & and_2334_s20_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2346;
  assign select_2346 = (less_2324_s20_q & and_2344_s20_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:214
  logic [1:0] select_2355;
  assign select_2355 = equal_2323_s20_q ? {sharpness_comparing_contrast_0_q[0], and_2344_s20_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2357;
  assign select_2357 = equal_2323_s20_q ? {sharpness_comparing_contrast_1_q[0], and_2334_s20_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:397
  logic xor_2380;
  assign xor_2380 = sharpness_comparing_contrast_0_q[1] ^ and_2334_s20_q;
  logic select_2383;
  assign select_2383 = (equal_2367_s20_q | xor_2380) ? (and_2334_s20_q & xor_2380) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:214
  logic select_2384;
  assign select_2384 = equal_2323_s20_q ? select_2383 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:397
  logic xor_2386;
  assign xor_2386 = sharpness_comparing_contrast_1_q[1] ^ and_2344_s20_q;
  logic select_2389;
  assign select_2389 = (equal_2367_s20_q | xor_2386) ? (and_2344_s20_q & xor_2386) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:214
  logic select_2390;
  assign select_2390 = equal_2323_s20_q ? select_2389 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1099
  logic not_2561;
  assign not_2561 = ~(equal_2039_s20_q ? and_2060 : not_2559_s20_q);
  // hls/stages/agreement.hpp:787
  logic and_2564;
  assign and_2564 = ends_cell_s20_q & (not_2544_s20_q & (centres_values_1_textured_s20_q & not_2561));
  // hls/stages/agreement.hpp:1131
  logic [9:0] select_2577;
  assign select_2577 = ((~(select_2570_s20_q[9:4] == 6'h0)) & less_2575_s20_q) ? select_2570_s20_q : 10'h0;
  // hls/stages/agreement.hpp:787
  logic [9:0] select_2580;
  assign select_2580 = equal_671_s20_q ? (x_s20_q[6] ? (equal_1585_s20_q ? 10'h0 : select_2577) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1103
  logic and_2598;
  assign and_2598 = centres_values_1_textured_s20_q & (centres_values_1_of_skin_s20_q & not_2561);
  // hls/stages/agreement.hpp:271
  logic [4:0] select_2970;
  assign select_2970 = sample_pair_whole_s20_q ? (select_1832[4] ? {1'b1, select_1832[3:0]} : (select_1832 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2973;
  assign select_2973 = sample_pair_whole_s20_q ? (select_1836[4] ? {1'b1, select_1836[3:0]} : (select_1836 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3187;
  assign parity_3187 = ^{or_3184_s20_q, or_3180_s20_q, or_3176_s20_q};
  logic parity_3202;
  assign parity_3202 = ^{or_3199_s20_q, or_3195_s20_q, or_3191_s20_q};
  logic parity_3205;
  assign parity_3205 = ^{or_3199_s20_q, or_3195_s20_q, or_3191_s20_q, or_3184_s20_q, or_3180_s20_q, or_3176_s20_q, or_3169_s20_q, or_3165_s20_q, or_3161_s20_q};
  logic parity_3236;
  assign parity_3236 = ^{or_3233_s20_q, or_3229_s20_q, or_3225_s20_q};
  logic parity_3251;
  assign parity_3251 = ^{or_3248_s20_q, or_3244_s20_q, or_3240_s20_q};
  logic parity_3254;
  assign parity_3254 = ^{or_3248_s20_q, or_3244_s20_q, or_3240_s20_q, or_3233_s20_q, or_3229_s20_q, or_3225_s20_q, or_3217_s20_q, or_3213_s20_q, or_3209_s20_q};
  logic parity_3269;
  assign parity_3269 = ^{or_3266_s20_q, or_3262_s20_q, or_3258_s20_q};
  logic parity_3281;
  assign parity_3281 = ^{or_3278_s20_q, or_3274_s20_q, and_3270_s20_q};
  logic parity_3284;
  assign parity_3284 = ^{or_3278_s20_q, or_3274_s20_q, and_3270_s20_q, or_3266_s20_q, or_3262_s20_q, or_3258_s20_q, or_3248_s20_q, or_3244_s20_q, or_3240_s20_q, or_3233_s20_q, or_3229_s20_q, or_3225_s20_q, or_3217_s20_q, or_3213_s20_q, or_3209_s20_q};
  logic parity_3286;
  assign parity_3286 = ^{or_3278_s20_q, or_3274_s20_q, and_3270_s20_q, or_3266_s20_q, or_3262_s20_q, or_3258_s20_q, or_3248_s20_q, or_3244_s20_q, or_3240_s20_q, or_3233_s20_q, or_3229_s20_q, or_3225_s20_q, or_3217_s20_q, or_3213_s20_q, or_3209_s20_q, or_3199_s20_q, or_3195_s20_q, or_3191_s20_q, or_3184_s20_q, or_3180_s20_q, or_3176_s20_q, or_3169_s20_q, or_3165_s20_q, or_3161_s20_q};
  // hls/stages/count_bits.hpp:25
  logic and_3287;
  assign and_3287 = parity_3205 & parity_3284;
  logic and_3290;
  assign and_3290 = (^{or_3169_s20_q, or_3165_s20_q, or_3161_s20_q}) & (parity_3187 | parity_3202);
  logic or_3291;
  assign or_3291 = (parity_3187 & parity_3202) | and_3290;
  logic or_3295;
  assign or_3295 = (parity_3269 & parity_3281) | (parity_3254 & (parity_3269 | parity_3281));
  logic and_3301;
  assign and_3301 = (^{or_3217_s20_q, or_3213_s20_q, or_3209_s20_q}) & (parity_3236 | parity_3251);
  logic or_3302;
  assign or_3302 = (parity_3236 & parity_3251) | and_3301;
  logic or_3306;
  assign or_3306 = (or_3262_s20_q & or_3266_s20_q) | (or_3258_s20_q & (or_3262_s20_q | or_3266_s20_q));
  logic or_3310;
  assign or_3310 = (or_3274_s20_q & or_3278_s20_q) | (and_3270_s20_q & (or_3274_s20_q | or_3278_s20_q));
  // hls/stages/count_bits.hpp:23
  logic or_3317;
  assign or_3317 = (or_3213_s20_q & or_3217_s20_q) | (or_3209_s20_q & (or_3213_s20_q | or_3217_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3321;
  assign or_3321 = (or_3229_s20_q & or_3233_s20_q) | (or_3225_s20_q & (or_3229_s20_q | or_3233_s20_q));
  logic or_3325;
  assign or_3325 = (or_3244_s20_q & or_3248_s20_q) | (or_3240_s20_q & (or_3244_s20_q | or_3248_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3328;
  assign parity_3328 = ^{or_3325, or_3321, or_3317};
  // hls/stages/count_bits.hpp:23
  logic or_3332;
  assign or_3332 = (or_3165_s20_q & or_3169_s20_q) | (or_3161_s20_q & (or_3165_s20_q | or_3169_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3336;
  assign or_3336 = (or_3180_s20_q & or_3184_s20_q) | (or_3176_s20_q & (or_3180_s20_q | or_3184_s20_q));
  logic or_3340;
  assign or_3340 = (or_3195_s20_q & or_3199_s20_q) | (or_3191_s20_q & (or_3195_s20_q | or_3199_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3343;
  assign parity_3343 = ^{or_3340, or_3336, or_3332};
  logic parity_3346;
  assign parity_3346 = ^{or_3340, or_3336, or_3332, or_3325, or_3321, or_3317, or_3310, or_3306, or_3302};
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3525;
  assign difference_3525 = select_3522_s20_q - select_3512_s20_q;
  // hls/stages/patches.hpp:594
  logic or_3532;
  assign or_3532 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3512_s20_q);
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3556;
  assign sum_3556 = select_3481_s20_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [7:0] difference_3576;
  assign difference_3576 = {sum_3556, select_3481_s20_q[2:0], 3'h0} - {5'h0, fraction_s20_q};
  logic [7:0] select_3577;
  assign select_3577 = less_3555_s20_q ? difference_3576 : {sum_3556, select_3481_s20_q[2:0], fraction_s20_q};
  // hls/stages/agreement.hpp:787
  logic select_3877;
  assign select_3877 = equal_671_s20_q ? ((x_s20_q[6] & good_known_q) | equal_672_s20_q) : good_known_q;
  // hls/stages/agreement.hpp:1300
  logic and_4052;
  assign and_4052 = and_2100_s20_q & ({sum_2026_s20_q, index_2_s20_q} == {sum_2013_s20_q, index_s20_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1400; read in stage 20, written in stage 21: 20 < 21 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2013_s20_q, index_s20_q};
  logic map_re;
  assign map_re = s20_en & (and_2020_s20_q & less_2021_s20_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1591_s20_q, lower_half_s20_q, registration_of_right_s20_q};
  logic registration_sums_we;
  assign registration_sums_we = s20_en & and_1650_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1649_s20_q, sum_1645_s20_q};
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
      sharpness_sums_detail_0_q <= and_532_s20_q ? select_2301 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_532_s20_q ? select_2313 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2355 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2357 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_2384 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_2390 : sharpness_comparing_less_contrast_1_q;
      registration_moved_q <= not_2838_s20_q & (registration_moved_q | and_2860_s20_q);
      patches_left_next_0_q <= select_2970;
      patches_left_next_1_q <= select_2973;
      good_known_q <= select_3877;
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
      census_changes_values_2_left_q <= select_2237;
      census_changes_values_2_right_q <= select_2238;
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
  logic and_532_s21_q;
  logic equal_554_s21_q;
  logic [12:0] select_556_s21_q;
  logic less_558_s21_q;
  logic not_559_s21_q;
  logic and_560_s21_q;
  logic and_567_s21_q;
  logic less_572_s21_q;
  logic and_575_s21_q;
  logic and_600_s21_q;
  logic less_603_s21_q;
  logic and_606_s21_q;
  logic so_s21_q;
  logic less_622_s21_q;
  logic less_623_s21_q;
  logic less_624_s21_q;
  logic less_625_s21_q;
  logic less_626_s21_q;
  logic less_627_s21_q;
  logic less_628_s21_q;
  logic less_629_s21_q;
  logic less_630_s21_q;
  logic less_631_s21_q;
  logic less_632_s21_q;
  logic less_633_s21_q;
  logic less_634_s21_q;
  logic less_635_s21_q;
  logic less_636_s21_q;
  logic less_637_s21_q;
  logic less_638_s21_q;
  logic less_639_s21_q;
  logic less_640_s21_q;
  logic less_641_s21_q;
  logic less_642_s21_q;
  logic less_643_s21_q;
  logic less_644_s21_q;
  logic less_645_s21_q;
  logic and_646_s21_q;
  logic [8:0] sum_668_s21_q;
  logic equal_671_s21_q;
  logic equal_672_s21_q;
  logic equal_673_s21_q;
  logic and_680_s21_q;
  logic and_684_s21_q;
  logic and_689_s21_q;
  logic and_693_s21_q;
  logic not_1544_s21_q;
  logic equal_1585_s21_q;
  logic equal_1593_s21_q;
  logic equal_1595_s21_q;
  logic equal_1597_s21_q;
  logic equal_1599_s21_q;
  logic equal_1601_s21_q;
  logic equal_1603_s21_q;
  logic and_1653_s21_q;
  logic select_1670_s21_q;
  logic equal_1671_s21_q;
  logic equal_1763_s21_q;
  logic equal_1765_s21_q;
  logic select_1779_s21_q;
  logic or_1789_s21_q;
  logic [4:0] select_1793_s21_q;
  logic select_1799_s21_q;
  logic or_1818_s21_q;
  logic [3:0] column_5_s21_q;
  logic [3:0] select_1838_s21_q;
  logic select_1839_s21_q;
  logic and_1846_s21_q;
  logic less_1924_s21_q;
  logic equal_1925_s21_q;
  logic not_1926_s21_q;
  logic equal_1927_s21_q;
  logic not_1954_s21_q;
  logic and_2020_s21_q;
  logic less_2021_s21_q;
  logic [2:0] index_2_s21_q;
  logic [10:0] sum_2026_s21_q;
  logic is_seen_s21_q;
  logic and_2090_s21_q;
  logic and_2100_s21_q;
  logic [8:0] sum_2241_s21_q;
  logic equal_2323_s21_q;
  logic less_2324_s21_q;
  logic [17:0] select_2336_s21_q;
  logic [17:0] select_2346_s21_q;
  logic equal_2367_s21_q;
  logic and_2519_s21_q;
  logic and_2566_s21_q;
  logic [9:0] select_2570_s21_q;
  logic [9:0] select_2573_s21_q;
  logic [9:0] select_2580_s21_q;
  logic and_2601_s21_q;
  logic and_2621_s21_q;
  logic and_2643_s21_q;
  logic and_2650_s21_q;
  logic equal_2825_s21_q;
  logic parity_3157_s21_q;
  logic parity_3286_s21_q;
  logic and_3287_s21_q;
  logic or_3291_s21_q;
  logic or_3295_s21_q;
  logic or_3302_s21_q;
  logic or_3306_s21_q;
  logic or_3310_s21_q;
  logic or_3317_s21_q;
  logic or_3321_s21_q;
  logic or_3325_s21_q;
  logic or_3332_s21_q;
  logic or_3336_s21_q;
  logic or_3340_s21_q;
  logic parity_3346_s21_q;
  logic or_3356_s21_q;
  logic or_3360_s21_q;
  logic and_3367_s21_q;
  logic and_3369_s21_q;
  logic and_3371_s21_q;
  logic equal_3393_s21_q;
  logic equal_3524_s21_q;
  logic less_3526_s21_q;
  logic less_3527_s21_q;
  logic or_3532_s21_q;
  logic [7:0] select_3577_s21_q;
  logic [13:0] product_3582_s21_q;
  logic equal_3633_s21_q;
  logic less_3760_s21_q;
  logic or_3857_s21_q;
  logic select_3865_s21_q;
  logic equal_3878_s21_q;
  logic equal_3880_s21_q;
  logic equal_3881_s21_q;
  logic equal_3882_s21_q;
  logic equal_3883_s21_q;
  logic and_4037_s21_q;
  logic and_4052_s21_q;
  logic [31:0] select_4122_s21_q;
  logic [9:0] select_4129_s21_q;
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
      and_532_s21_q <= and_532_s20_q;
      equal_554_s21_q <= equal_554_s20_q;
      select_556_s21_q <= select_556_s20_q;
      less_558_s21_q <= less_558_s20_q;
      not_559_s21_q <= not_559_s20_q;
      and_560_s21_q <= and_560_s20_q;
      and_567_s21_q <= and_567_s20_q;
      less_572_s21_q <= less_572_s20_q;
      and_575_s21_q <= and_575_s20_q;
      and_600_s21_q <= and_600_s20_q;
      less_603_s21_q <= less_603;
      and_606_s21_q <= ($signed(select_602) < $signed(10'h3f1)) & (~less_603);
      so_s21_q <= drew_q;
      less_622_s21_q <= less_622_s20_q;
      less_623_s21_q <= less_623_s20_q;
      less_624_s21_q <= less_624_s20_q;
      less_625_s21_q <= less_625_s20_q;
      less_626_s21_q <= less_626_s20_q;
      less_627_s21_q <= less_627_s20_q;
      less_628_s21_q <= less_628_s20_q;
      less_629_s21_q <= less_629_s20_q;
      less_630_s21_q <= less_630_s20_q;
      less_631_s21_q <= less_631_s20_q;
      less_632_s21_q <= less_632_s20_q;
      less_633_s21_q <= less_633_s20_q;
      less_634_s21_q <= less_634_s20_q;
      less_635_s21_q <= less_635_s20_q;
      less_636_s21_q <= less_636_s20_q;
      less_637_s21_q <= less_637_s20_q;
      less_638_s21_q <= less_638_s20_q;
      less_639_s21_q <= less_639_s20_q;
      less_640_s21_q <= less_640_s20_q;
      less_641_s21_q <= less_641_s20_q;
      less_642_s21_q <= less_642_s20_q;
      less_643_s21_q <= less_643_s20_q;
      less_644_s21_q <= less_644_s20_q;
      less_645_s21_q <= less_645_s20_q;
      and_646_s21_q <= and_646_s20_q;
      sum_668_s21_q <= sum_668[13:5];
      equal_671_s21_q <= equal_671_s20_q;
      equal_672_s21_q <= equal_672_s20_q;
      equal_673_s21_q <= equal_673_s20_q;
      and_680_s21_q <= not_559_s20_q & and_679;
      and_684_s21_q <= and_684;
      and_689_s21_q <= not_559_s20_q & and_688;
      and_693_s21_q <= and_688 & select_692;
      not_1544_s21_q <= not_1544_s20_q;
      equal_1585_s21_q <= equal_1585_s20_q;
      equal_1593_s21_q <= equal_1593_s20_q;
      equal_1595_s21_q <= equal_1595_s20_q;
      equal_1597_s21_q <= equal_1597_s20_q;
      equal_1599_s21_q <= equal_1599_s20_q;
      equal_1601_s21_q <= equal_1601_s20_q;
      equal_1603_s21_q <= equal_1603_s20_q;
      and_1653_s21_q <= and_1653_s20_q;
      select_1670_s21_q <= select_1670_s20_q;
      equal_1671_s21_q <= equal_1671_s20_q;
      equal_1763_s21_q <= equal_1763_s20_q;
      equal_1765_s21_q <= equal_1765_s20_q;
      select_1779_s21_q <= select_1779_s20_q;
      or_1789_s21_q <= and_1653_s20_q | (select_1781_s20_q & equal_1787_s20_q);
      select_1793_s21_q <= select_1793_s20_q;
      select_1799_s21_q <= select_1799_s20_q;
      or_1818_s21_q <= and_1653_s20_q | (select_1810_s20_q & equal_1816_s20_q);
      column_5_s21_q <= column_5;
      select_1838_s21_q <= select_1838_s20_q;
      select_1839_s21_q <= or_1831_s20_q ? and_1653_s20_q : patches_left_next_0_q[4];
      and_1846_s21_q <= and_1846;
      less_1924_s21_q <= less_1924_s20_q;
      equal_1925_s21_q <= equal_1925_s20_q;
      not_1926_s21_q <= not_1926_s20_q;
      equal_1927_s21_q <= equal_1927_s20_q;
      not_1954_s21_q <= not_1954_s20_q;
      and_2020_s21_q <= and_2020_s20_q;
      less_2021_s21_q <= less_2021_s20_q;
      index_2_s21_q <= index_2_s20_q;
      sum_2026_s21_q <= sum_2026_s20_q;
      is_seen_s21_q <= is_seen;
      and_2090_s21_q <= is_seen & less_2089_s20_q;
      and_2100_s21_q <= and_2100_s20_q;
      sum_2241_s21_q <= sum_2241[13:5];
      equal_2323_s21_q <= equal_2323_s20_q;
      less_2324_s21_q <= less_2324_s20_q;
      select_2336_s21_q <= select_2336;
      select_2346_s21_q <= select_2346;
      equal_2367_s21_q <= equal_2367_s20_q;
      and_2519_s21_q <= and_2519_s20_q;
      and_2566_s21_q <= not_1544_s20_q & (drew_q & and_2564);
      select_2570_s21_q <= select_2570_s20_q;
      select_2573_s21_q <= select_2573_s20_q;
      select_2580_s21_q <= select_2580;
      and_2601_s21_q <= drew_q & (ends_cell_s20_q & (not_2544_s20_q & and_2598));
      and_2621_s21_q <= and_2621_s20_q;
      and_2643_s21_q <= and_2643_s20_q;
      and_2650_s21_q <= and_2650_s20_q;
      equal_2825_s21_q <= equal_2825_s20_q;
      parity_3157_s21_q <= parity_3157_s20_q;
      parity_3286_s21_q <= parity_3286;
      and_3287_s21_q <= and_3287;
      or_3291_s21_q <= or_3291;
      or_3295_s21_q <= or_3295;
      or_3302_s21_q <= or_3302;
      or_3306_s21_q <= or_3306;
      or_3310_s21_q <= or_3310;
      or_3317_s21_q <= or_3317;
      or_3321_s21_q <= or_3321;
      or_3325_s21_q <= or_3325;
      or_3332_s21_q <= or_3332;
      or_3336_s21_q <= or_3336;
      or_3340_s21_q <= or_3340;
      parity_3346_s21_q <= parity_3346;
      or_3356_s21_q <= (or_3321 & or_3325) | (or_3317 & (or_3321 | or_3325));
      or_3360_s21_q <= (or_3336 & or_3340) | (or_3332 & (or_3336 | or_3340));
      and_3367_s21_q <= and_3287 & (or_3291 | or_3295);
      and_3369_s21_q <= parity_3328 & parity_3343;
      and_3371_s21_q <= (^{or_3310, or_3306, or_3302}) & (parity_3328 | parity_3343);
      equal_3393_s21_q <= equal_3393_s20_q;
      equal_3524_s21_q <= select_3481_s20_q[3:0] == 4'h0;
      less_3526_s21_q <= {difference_3525, 3'h0} < {3'h0, patches_size_q};
      less_3527_s21_q <= select_3522_s20_q < select_3512_s20_q;
      or_3532_s21_q <= or_3532;
      select_3577_s21_q <= select_3577;
      product_3582_s21_q <= product_3582_s20_q;
      equal_3633_s21_q <= equal_3633_s20_q;
      less_3760_s21_q <= less_3760_s20_q;
      or_3857_s21_q <= or_3857_s20_q;
      select_3865_s21_q <= select_3865_s20_q;
      equal_3878_s21_q <= equal_3878_s20_q;
      equal_3880_s21_q <= equal_3880_s20_q;
      equal_3881_s21_q <= equal_3881_s20_q;
      equal_3882_s21_q <= equal_3882_s20_q;
      equal_3883_s21_q <= equal_3883_s20_q;
      and_4037_s21_q <= said_q;
      and_4052_s21_q <= and_4052;
      select_4122_s21_q <= select_4122_s20_q;
      select_4129_s21_q <= select_4129_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [13:0] moments_turned_0_q;
  logic [13:0] moments_turned_1_q;
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
  logic [5:0] select_1800;
  assign select_1800 = or_1789_s21_q ? {and_1653_s21_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1802;
  assign and_1802 = select_1799_s21_q & (~select_1800[5]);
  // hls/stages/patches.hpp:133
  logic [5:0] select_1820;
  assign select_1820 = or_1818_s21_q ? {and_1653_s21_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1822;
  assign and_1822 = select_1799_s21_q & (~select_1820[5]);
  // hls/stages/moments.hpp:48
  logic [13:0] select_2250;
  assign select_2250 = equal_554_s21_q ? 14'h0 : moments_turned_0_q;
  // hls/stages/agreement.hpp:452
  logic [13:0] select_2252;
  assign select_2252 = less_558_s21_q ? select_2250 : (select_2250 + {13'h0, and_684_s21_q});
  // hls/stages/moments.hpp:48
  logic [13:0] select_2254;
  assign select_2254 = equal_554_s21_q ? 14'h0 : moments_turned_1_q;
  // hls/stages/agreement.hpp:452
  logic [13:0] select_2256;
  assign select_2256 = less_558_s21_q ? select_2254 : (select_2254 + {13'h0, and_693_s21_q});
  // hls/stages/moments.hpp:71
  logic [13:0] select_2259;
  assign select_2259 = (moments_turned_1_q < moments_turned_0_q) ? moments_turned_0_q : moments_turned_1_q;
  // hls/stages/census.hpp:388
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2336_s21_q};
  // hls/stages/agreement.hpp:214
  logic [17:0] select_2339;
  assign select_2339 = equal_2323_s21_q ? (less_2324_s21_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:388
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2346_s21_q};
  // hls/stages/agreement.hpp:214
  logic [17:0] select_2349;
  assign select_2349 = equal_2323_s21_q ? (less_2324_s21_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:925
  logic [13:0] select_2568;
  assign select_2568 = and_2519_s21_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2566_s21_q});
  logic [13:0] select_2582;
  assign select_2582 = and_2519_s21_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2580_s21_q});
  // hls/stages/agreement.hpp:787
  logic and_2602;
  assign and_2602 = not_1544_s21_q & and_2601_s21_q;
  // hls/stages/agreement.hpp:925
  logic [13:0] select_2604;
  assign select_2604 = and_2519_s21_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2602});
  logic [13:0] select_2623;
  assign select_2623 = and_2519_s21_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2621_s21_q});
  // hls/stages/patches.hpp:127
  logic select_2953;
  assign select_2953 = equal_1671_s21_q ? patches_valid_0_q : (select_1670_s21_q ? patches_valid_0_q : select_1779_s21_q);
  // hls/stages/agreement.hpp:271
  logic select_2956;
  assign select_2956 = sample_pair_whole_s21_q ? (and_1802 ? (sample_present_s21_q & select_2953) : select_2953) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_2958;
  assign select_2958 = equal_1671_s21_q ? patches_valid_1_q : (select_1670_s21_q ? select_1779_s21_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:271
  logic select_2961;
  assign select_2961 = sample_pair_whole_s21_q ? (and_1822 ? (sample_present_s21_q & select_2958) : select_2958) : patches_valid_1_q;
  logic [5:0] select_2964;
  assign select_2964 = sample_pair_whole_s21_q ? (select_1800[5] ? {1'b1, select_1800[4:0]} : (select_1800 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2967;
  assign select_2967 = sample_pair_whole_s21_q ? (select_1820[5] ? {1'b1, select_1820[4:0]} : (select_1820 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3348;
  assign parity_3348 = ^{or_3340_s21_q, or_3336_s21_q, or_3332_s21_q, or_3325_s21_q, or_3321_s21_q, or_3317_s21_q, or_3310_s21_q, or_3306_s21_q, or_3302_s21_q, or_3295_s21_q, or_3291_s21_q, and_3287_s21_q};
  // hls/stages/count_bits.hpp:25
  logic or_3352;
  assign or_3352 = (or_3306_s21_q & or_3310_s21_q) | (or_3302_s21_q & (or_3306_s21_q | or_3310_s21_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3363;
  assign parity_3363 = ^{or_3360_s21_q, or_3356_s21_q, or_3352};
  // hls/stages/count_bits.hpp:25
  logic and_3364;
  assign and_3364 = (^{or_3295_s21_q, or_3291_s21_q, and_3287_s21_q}) & parity_3346_s21_q;
  logic or_3368;
  assign or_3368 = (or_3291_s21_q & or_3295_s21_q) | and_3367_s21_q;
  logic or_3372;
  assign or_3372 = and_3369_s21_q | and_3371_s21_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3375;
  assign parity_3375 = ^{or_3372, or_3368, and_3364};
  // hls/stages/count_bits.hpp:25
  logic and_3377;
  assign and_3377 = parity_3363 & parity_3375;
  logic or_3381;
  assign or_3381 = (or_3356_s21_q & or_3360_s21_q) | (or_3352 & (or_3356_s21_q | or_3360_s21_q));
  logic or_3385;
  assign or_3385 = (or_3368 & or_3372) | (and_3364 & (or_3368 | or_3372));
  // hls/stages/patches.hpp:594
  logic or_3533;
  assign or_3533 = (~(patches_second_s21_q ? patches_valid_1_q : patches_valid_0_q)) | or_3532_s21_q;
  logic or_3536;
  assign or_3536 = equal_3524_s21_q | (less_3526_s21_q | (less_3527_s21_q | or_3533));
  // hls/stages/patches.hpp:593
  logic [14:0] difference_3583;
  assign difference_3583 = {{7{select_3577_s21_q[7]}}, select_3577_s21_q} - {product_3582_s21_q[13], product_3582_s21_q};
  // hls/stages/patches.hpp:599
  logic less_3584;
  assign less_3584 = $signed({{8{difference_3554[6]}}, difference_3554}) < $signed(difference_3583);
  // hls/stages/agreement.hpp:1118
  logic [13:0] select_3885;
  assign select_3885 = equal_3882_s21_q ? counts_skin_unproven_q : (equal_3883_s21_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3887;
  assign select_3887 = equal_3881_s21_q ? counts_regions_bad_q : (equal_3878_s21_q ? counts_nearer_s21_q : select_3885);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3880_s21_q ? counts_on_skin_q : select_3887;
  // hls/stages/agreement.hpp:1133
  logic [31:0] select_4123;
  assign select_4123 = equal_1603_s21_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4122_s21_q;
  logic [31:0] select_4124;
  assign select_4124 = equal_1601_s21_q ? {8'h0, sharpness_sums_detail_0_s21_q} : select_4123;
  logic [31:0] select_4125;
  assign select_4125 = equal_1599_s21_q ? {8'h0, sharpness_sums_detail_1_s21_q} : select_4124;
  logic [31:0] select_4126;
  assign select_4126 = equal_1597_s21_q ? {8'h0, sharpness_sums_contrast_0_s21_q} : select_4125;
  logic [31:0] select_4127;
  assign select_4127 = equal_1595_s21_q ? {8'h0, sharpness_sums_contrast_1_s21_q} : select_4126;

  // Memory moments_memory, write
  logic [12:0] moments_memory_waddr;
  assign moments_memory_waddr = select_556_s21_q;
  logic moments_memory_we;
  assign moments_memory_we = s21_en & and_560_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_606_s21_q, less_603_s21_q, and_575_s21_q, less_572_s21_q};
  end
`ifndef SYNTHESIS
  logic [12:0] moments_memory_raddr_s19_sim;
  logic moments_memory_re_s19_sim;
  logic [12:0] moments_memory_raddr_s20_sim;
  logic moments_memory_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_memory_re_s19_sim <= 1'b0;
      moments_memory_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      moments_memory_re_s19_sim <= moments_memory_re;
      moments_memory_raddr_s19_sim <= moments_memory_raddr;
      moments_memory_re_s20_sim <= moments_memory_re_s19_sim;
      moments_memory_raddr_s20_sim <= moments_memory_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && moments_memory_we) begin
      if (moments_memory_re && moments_memory_raddr == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_re_s19_sim && moments_memory_raddr_s19_sim == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_re_s20_sim && moments_memory_raddr_s20_sim == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_waddr >= 13'd8040) $error("moments_memory: write outside, address %0d", moments_memory_waddr);
    end
    if (rst_ni && moments_memory_re && moments_memory_raddr >= 13'd8040) $error("moments_memory: read outside, address %0d", moments_memory_raddr);
  end
`endif

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1839_s21_q, select_1838_s21_q, column_5_s21_q};
  logic patches_left_we;
  assign patches_left_we = s21_en & and_1846_s21_q;
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
  assign map_waddr = {sum_2026_s21_q, index_2_s21_q};
  logic map_we;
  assign map_we = s21_en & and_2100_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2090_s21_q, is_seen_s21_q};
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
      moments_turned_0_q <= 14'h0;
      moments_turned_1_q <= 14'h0;
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
      moments_turned_0_q <= and_532_s21_q ? select_2252 : moments_turned_0_q;
      moments_turned_1_q <= and_532_s21_q ? select_2256 : moments_turned_1_q;
      sharpness_comparing_rest_0_q <= so_s21_q ? select_2339 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s21_q ? select_2349 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2568;
      counts_regions_bad_q <= select_2582;
      counts_skin_unproven_q <= select_2604;
      counts_on_skin_q <= select_2623;
      patches_valid_0_q <= select_2956;
      patches_valid_1_q <= select_2961;
      patches_right_next_0_q <= select_2964;
      patches_right_next_1_q <= select_2967;
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
  logic and_532_s22_q;
  logic equal_554_s22_q;
  logic and_567_s22_q;
  logic and_600_s22_q;
  logic so_s22_q;
  logic less_622_s22_q;
  logic less_623_s22_q;
  logic less_624_s22_q;
  logic less_625_s22_q;
  logic less_626_s22_q;
  logic less_627_s22_q;
  logic less_628_s22_q;
  logic less_629_s22_q;
  logic less_630_s22_q;
  logic less_631_s22_q;
  logic less_632_s22_q;
  logic less_633_s22_q;
  logic less_634_s22_q;
  logic less_635_s22_q;
  logic less_636_s22_q;
  logic less_637_s22_q;
  logic less_638_s22_q;
  logic less_639_s22_q;
  logic less_640_s22_q;
  logic less_641_s22_q;
  logic less_642_s22_q;
  logic less_643_s22_q;
  logic less_644_s22_q;
  logic less_645_s22_q;
  logic and_646_s22_q;
  logic less_669_s22_q;
  logic equal_671_s22_q;
  logic equal_672_s22_q;
  logic equal_673_s22_q;
  logic and_680_s22_q;
  logic and_685_s22_q;
  logic and_689_s22_q;
  logic and_694_s22_q;
  logic equal_1585_s22_q;
  logic equal_1593_s22_q;
  logic equal_1763_s22_q;
  logic equal_1765_s22_q;
  logic [4:0] select_1790_s22_q;
  logic [4:0] select_1793_s22_q;
  logic and_1803_s22_q;
  logic [4:0] select_1819_s22_q;
  logic and_1823_s22_q;
  logic less_1924_s22_q;
  logic equal_1925_s22_q;
  logic not_1926_s22_q;
  logic equal_1927_s22_q;
  logic not_1954_s22_q;
  logic and_2020_s22_q;
  logic less_2021_s22_q;
  logic [1:0] map_rdata_s22_q;
  logic is_seen_s22_q;
  logic and_2090_s22_q;
  logic and_2243_s22_q;
  logic [13:0] select_2259_s22_q;
  logic equal_2323_s22_q;
  logic sum_s22_q;
  logic sum_2_s22_q;
  logic equal_2367_s22_q;
  logic select_2385_s22_q;
  logic select_2391_s22_q;
  logic and_2519_s22_q;
  logic [9:0] select_2570_s22_q;
  logic [9:0] select_2573_s22_q;
  logic and_2643_s22_q;
  logic and_2650_s22_q;
  logic equal_2825_s22_q;
  logic parity_3157_s22_q;
  logic parity_3286_s22_q;
  logic parity_3348_s22_q;
  logic xor_3376_s22_q;
  logic parity_3388_s22_q;
  logic and_3389_s22_q;
  logic and_3391_s22_q;
  logic equal_3393_s22_q;
  logic or_3536_s22_q;
  logic [5:0] difference_3583_s22_q;
  logic not_3585_s22_q;
  logic not_3595_s22_q;
  logic equal_3633_s22_q;
  logic less_3707_s22_q;
  logic less_3708_s22_q;
  logic less_3760_s22_q;
  logic or_3857_s22_q;
  logic select_3865_s22_q;
  logic and_3879_s22_q;
  logic [13:0] before_v_4_s22_q;
  logic not_3924_s22_q;
  logic or_3928_s22_q;
  logic and_3933_s22_q;
  logic less_3934_s22_q;
  logic and_4037_s22_q;
  logic and_4052_s22_q;
  logic not_4066_s22_q;
  logic [31:0] select_4127_s22_q;
  logic [9:0] select_4129_s22_q;
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
      and_532_s22_q <= and_532_s21_q;
      equal_554_s22_q <= equal_554_s21_q;
      and_567_s22_q <= and_567_s21_q;
      and_600_s22_q <= and_600_s21_q;
      so_s22_q <= so_s21_q;
      less_622_s22_q <= less_622_s21_q;
      less_623_s22_q <= less_623_s21_q;
      less_624_s22_q <= less_624_s21_q;
      less_625_s22_q <= less_625_s21_q;
      less_626_s22_q <= less_626_s21_q;
      less_627_s22_q <= less_627_s21_q;
      less_628_s22_q <= less_628_s21_q;
      less_629_s22_q <= less_629_s21_q;
      less_630_s22_q <= less_630_s21_q;
      less_631_s22_q <= less_631_s21_q;
      less_632_s22_q <= less_632_s21_q;
      less_633_s22_q <= less_633_s21_q;
      less_634_s22_q <= less_634_s21_q;
      less_635_s22_q <= less_635_s21_q;
      less_636_s22_q <= less_636_s21_q;
      less_637_s22_q <= less_637_s21_q;
      less_638_s22_q <= less_638_s21_q;
      less_639_s22_q <= less_639_s21_q;
      less_640_s22_q <= less_640_s21_q;
      less_641_s22_q <= less_641_s21_q;
      less_642_s22_q <= less_642_s21_q;
      less_643_s22_q <= less_643_s21_q;
      less_644_s22_q <= less_644_s21_q;
      less_645_s22_q <= less_645_s21_q;
      and_646_s22_q <= and_646_s21_q;
      less_669_s22_q <= 9'h4 < sum_668_s21_q;
      equal_671_s22_q <= equal_671_s21_q;
      equal_672_s22_q <= equal_672_s21_q;
      equal_673_s22_q <= equal_673_s21_q;
      and_680_s22_q <= and_680_s21_q;
      and_685_s22_q <= not_559_s21_q & and_684_s21_q;
      and_689_s22_q <= and_689_s21_q;
      and_694_s22_q <= not_559_s21_q & and_693_s21_q;
      equal_1585_s22_q <= equal_1585_s21_q;
      equal_1593_s22_q <= equal_1593_s21_q;
      equal_1763_s22_q <= equal_1763_s21_q;
      equal_1765_s22_q <= equal_1765_s21_q;
      select_1790_s22_q <= or_1789_s21_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1793_s22_q <= select_1793_s21_q;
      and_1803_s22_q <= sample_pair_whole_s21_q & and_1802;
      select_1819_s22_q <= or_1818_s21_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1823_s22_q <= sample_pair_whole_s21_q & and_1822;
      less_1924_s22_q <= less_1924_s21_q;
      equal_1925_s22_q <= equal_1925_s21_q;
      not_1926_s22_q <= not_1926_s21_q;
      equal_1927_s22_q <= equal_1927_s21_q;
      not_1954_s22_q <= not_1954_s21_q;
      and_2020_s22_q <= and_2020_s21_q;
      less_2021_s22_q <= less_2021_s21_q;
      map_rdata_s22_q <= map_rdata_q;
      is_seen_s22_q <= is_seen_s21_q;
      and_2090_s22_q <= and_2090_s21_q;
      and_2243_s22_q <= and_600_s21_q & (9'h4 < sum_2241_s21_q);
      select_2259_s22_q <= select_2259;
      equal_2323_s22_q <= equal_2323_s21_q;
      sum_s22_q <= sum[0];
      sum_2_s22_q <= sum_2[0];
      equal_2367_s22_q <= equal_2367_s21_q;
      select_2385_s22_q <= sharpness_comparing_less_contrast_0_q;
      select_2391_s22_q <= sharpness_comparing_less_contrast_1_q;
      and_2519_s22_q <= and_2519_s21_q;
      select_2570_s22_q <= select_2570_s21_q;
      select_2573_s22_q <= select_2573_s21_q;
      and_2643_s22_q <= and_2643_s21_q;
      and_2650_s22_q <= and_2650_s21_q;
      equal_2825_s22_q <= equal_2825_s21_q;
      parity_3157_s22_q <= parity_3157_s21_q;
      parity_3286_s22_q <= parity_3286_s21_q;
      parity_3348_s22_q <= parity_3348;
      xor_3376_s22_q <= parity_3363 ^ parity_3375;
      parity_3388_s22_q <= ^{or_3385, or_3381, and_3377};
      and_3389_s22_q <= or_3381 & or_3385;
      and_3391_s22_q <= and_3377 & (or_3381 | or_3385);
      equal_3393_s22_q <= equal_3393_s21_q;
      or_3536_s22_q <= or_3536;
      difference_3583_s22_q <= difference_3583[5:0];
      not_3585_s22_q <= ~less_3584;
      not_3595_s22_q <= ~($signed(difference_3583) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3633_s22_q <= equal_3633_s21_q;
      less_3707_s22_q <= $signed(15'h10) < $signed(difference_3583);
      less_3708_s22_q <= $signed(difference_3583[14:4]) < $signed(11'h7ff);
      less_3760_s22_q <= less_3760_s21_q;
      or_3857_s22_q <= or_3857_s21_q;
      select_3865_s22_q <= select_3865_s21_q;
      and_3879_s22_q <= equal_3878_s21_q & equal_3633_s21_q;
      before_v_4_s22_q <= before_v_4;
      not_3924_s22_q <= ~(equal_3883_s21_q & equal_3633_s21_q);
      or_3928_s22_q <= (equal_3883_s21_q | equal_3882_s21_q) | (x_s21_q[6:3] == 4'hf);
      and_3933_s22_q <= equal_3880_s21_q & equal_3633_s21_q;
      less_3934_s22_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4037_s22_q <= and_4037_s21_q;
      and_4052_s22_q <= and_4052_s21_q;
      not_4066_s22_q <= ~proven_q;
      select_4127_s22_q <= select_4127;
      select_4129_s22_q <= select_4129_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
  logic [19:0] census_left_misses_q;
  logic [13:0] moments_before_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
  logic [13:0] counts_turned_left_q;
  logic [13:0] counts_turned_right_q;
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
  logic patches_frame_ended_q;
  logic hides_q;
  // hls/stages/census.hpp:308
  logic and_670;
  assign and_670 = and_567_s22_q & less_669_s22_q;
  // hls/stages/census.hpp:315
  logic and_2244;
  assign and_2244 = and_600_s22_q & less_669_s22_q;
  // hls/stages/census.hpp:316
  logic [19:0] sum_2245;
  assign sum_2245 = census_left_misses_q + {{17{and_2244}}, and_2243_s22_q, 1'b0, and_2243_s22_q};
  // hls/stages/agreement.hpp:518
  logic [19:0] select_2247;
  assign select_2247 = and_532_s22_q ? (equal_554_s22_q ? 20'h0 : sum_2245) : census_left_misses_q;
  // hls/stages/agreement.hpp:787
  logic [13:0] select_2261;
  assign select_2261 = equal_672_s22_q ? moments_before_q : (equal_673_s22_q ? select_2259_s22_q : moments_before_q);
  // hls/stages/moments.hpp:69
  logic less_2264;
  assign less_2264 = {3'h0, counts_turned_right_q[13:2]} < ({1'b0, counts_turned_left_q} + 15'h3);
  // hls/stages/moments.hpp:82
  logic less_2268;
  assign less_2268 = {3'h0, counts_turned_left_q[13:2]} < ({1'b0, counts_turned_right_q} + 15'h3);
  logic [14:0] sum_2272;
  assign sum_2272 = {1'b0, moments_before_q} + 15'h3;
  // hls/stages/agreement.hpp:214
  logic [2:0] select_2351;
  assign select_2351 = equal_2323_s22_q ? {sharpness_comparing_product_0_q[1:0], sum_s22_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2353;
  assign select_2353 = equal_2323_s22_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s22_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:394
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s22_q});
  // hls/stages/agreement.hpp:214
  logic select_2362;
  assign select_2362 = so_s22_q ? (equal_2323_s22_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:394
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s22_q});
  // hls/stages/agreement.hpp:214
  logic select_2365;
  assign select_2365 = equal_2323_s22_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:396
  logic xor_2368;
  assign xor_2368 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2374;
  assign xor_2374 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/agreement.hpp:925
  logic [13:0] select_2645;
  assign select_2645 = and_2519_s22_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2643_s22_q});
  logic [13:0] select_2652;
  assign select_2652 = and_2519_s22_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2650_s22_q});
  // hls/stages/count_bits.hpp:27
  logic or_3392;
  assign or_3392 = and_3389_s22_q | and_3391_s22_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3392, parity_3388_s22_q, xor_3376_s22_q, parity_3348_s22_q, parity_3286_s22_q, parity_3157_s22_q} + (equal_3393_s22_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3397;
  assign select_3397 = equal_1763_s22_q ? patches_sums_values_0_q : (equal_1765_s22_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3398;
  assign select_3398 = equal_1765_s22_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3400;
  assign select_3400 = equal_1765_s22_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3402;
  assign select_3402 = equal_1765_s22_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3404;
  assign select_3404 = equal_1765_s22_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3406;
  assign select_3406 = equal_1765_s22_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3408;
  assign select_3408 = equal_1765_s22_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3410;
  assign select_3410 = equal_1765_s22_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3412;
  assign select_3412 = equal_1765_s22_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3414;
  assign select_3414 = equal_1765_s22_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3416;
  assign select_3416 = equal_1765_s22_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3418;
  assign select_3418 = equal_1765_s22_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3420;
  assign select_3420 = equal_1765_s22_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3422;
  assign select_3422 = equal_1765_s22_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3424;
  assign select_3424 = equal_1765_s22_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3426;
  assign select_3426 = equal_1765_s22_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3428;
  assign select_3428 = equal_1765_s22_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:574
  logic not_3537;
  assign not_3537 = ~or_3536_s22_q;
  // hls/stages/patches.hpp:555
  logic and_3538;
  assign and_3538 = equal_1927_s22_q & not_3537;
  // hls/stages/patches.hpp:184
  logic and_3541;
  assign and_3541 = equal_1763_s22_q & (less_1924_s22_q ? (not_1926_s22_q & and_3538) : and_3538);
  // hls/stages/patches.hpp:555
  logic and_3544;
  assign and_3544 = equal_1927_s22_q & (patches_second_s22_q & not_3537);
  // hls/stages/patches.hpp:184
  logic and_3547;
  assign and_3547 = equal_1763_s22_q & (less_1924_s22_q ? (not_1926_s22_q & and_3544) : and_3544);
  // hls/stages/patches.hpp:555
  logic and_3587;
  assign and_3587 = equal_1927_s22_q & (not_3537 & not_3585_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3590;
  assign and_3590 = equal_1763_s22_q & (less_1924_s22_q ? (not_1926_s22_q & and_3587) : and_3587);
  // hls/stages/patches.hpp:555
  logic and_3597;
  assign and_3597 = equal_1927_s22_q & (not_3537 & not_3595_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3600;
  assign and_3600 = equal_1763_s22_q & (less_1924_s22_q ? (not_1926_s22_q & and_3597) : and_3597);
  // hls/stages/agreement.hpp:1123
  logic less_3634;
  assign less_3634 = x_s22_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:787
  logic and_3638;
  assign and_3638 = equal_671_s22_q & (x_s22_q[6] & (not_1954_s22_q & (equal_3633_s22_q & less_3634)));
  // hls/stages/agreement.hpp:1135
  logic and_3643;
  assign and_3643 = x_s22_q[6] & (not_1954_s22_q & (less_3634 & (x_s22_q[2:0] == 3'h1)));
  logic and_3650;
  assign and_3650 = x_s22_q[6] & (not_1954_s22_q & (less_3634 & (x_s22_q[2:0] == 3'h2)));
  logic and_3657;
  assign and_3657 = x_s22_q[6] & (not_1954_s22_q & (less_3634 & (x_s22_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:199
  logic select_3664;
  assign select_3664 = (x_s22_q[5:3] == 3'h2) ? x_s22_q[1] : (x_s22_q[0] & (x_s22_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3691;
  assign sum_3691 = {2'h0, x_s22_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:601
  logic [5:0] select_3710;
  assign select_3710 = less_3707_s22_q ? 6'h10 : (less_3708_s22_q ? 6'h30 : difference_3583_s22_q);
  // hls/stages/patches.hpp:555
  logic [5:0] select_3712;
  assign select_3712 = equal_1927_s22_q ? (or_3536_s22_q ? 6'h0 : select_3710) : 6'h0;
  logic [5:0] select_3714;
  assign select_3714 = less_1924_s22_q ? (equal_1925_s22_q ? 6'h0 : select_3712) : select_3712;
  // hls/stages/agreement.hpp:787
  logic and_3721;
  assign and_3721 = equal_671_s22_q & (x_s22_q[6] & (not_1954_s22_q & (equal_2825_s22_q & less_3634)));
  // hls/stages/agreement.hpp:1135
  logic and_3725;
  assign and_3725 = x_s22_q[6] & (not_1954_s22_q & (less_3634 & (x_s22_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:555
  logic and_3762;
  assign and_3762 = equal_1927_s22_q & (not_3537 & less_3760_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3765;
  assign and_3765 = equal_1763_s22_q & (less_1924_s22_q ? (not_1926_s22_q & and_3762) : and_3762);
  // hls/stages/agreement.hpp:1214
  logic [14:0] over;
  assign over = {1'b0, product_s22_q} - {1'b0, before_v_4_s22_q};
  // hls/stages/agreement.hpp:1222
  logic select_3890;
  assign select_3890 = and_3879_s22_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1300
  logic [1:0] select_4053;
  assign select_4053 = and_4052_s22_q ? {and_2090_s22_q, is_seen_s22_q} : map_rdata_s22_q;
  // hls/stages/agreement.hpp:1301
  logic and_4054;
  assign and_4054 = proven_q & less_4042;
  // hls/stages/agreement.hpp:1142
  logic or_4085;
  assign or_4085 = select_2385_s22_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:787
  logic and_4113;
  assign and_4113 = equal_671_s22_q & (x_s22_q[6] & (not_1954_s22_q | (4'hc < x_s22_q[5:2])));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s22_q;
  logic fresh_we;
  assign fresh_we = s22_en & and_532_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {and_694_s22_q, and_689_s22_q, and_685_s22_q, and_680_s22_q, census_columns_values_1_cell_2_of_skin_s22_q, and_670, and_646_s22_q, and_600_s22_q, and_567_s22_q, less_645_s22_q, less_644_s22_q, less_643_s22_q, less_642_s22_q, less_641_s22_q, less_640_s22_q, less_639_s22_q, less_638_s22_q, less_637_s22_q, less_636_s22_q, less_635_s22_q, less_634_s22_q, less_633_s22_q, less_632_s22_q, less_631_s22_q, less_630_s22_q, less_629_s22_q, less_628_s22_q, less_627_s22_q, less_626_s22_q, less_625_s22_q, less_624_s22_q, less_623_s22_q, less_622_s22_q};
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
  assign patches_right_0_waddr = {select_1793_s22_q, select_1790_s22_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s22_en & and_1803_s22_q;
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
  assign patches_right_1_waddr = {select_1793_s22_q, select_1819_s22_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s22_en & and_1823_s22_q;
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
      moments_before_q <= 14'h0;
      sharpness_comparing_product_0_q <= 3'h0;
      sharpness_comparing_product_1_q <= 3'h0;
      sharpness_comparing_carry_0_q <= 1'b0;
      sharpness_comparing_carry_1_q <= 1'b0;
      counts_turned_left_q <= 14'h0;
      counts_turned_right_q <= 14'h0;
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
      patches_frame_ended_q <= 1'b0;
      hides_q <= 1'b0;
    end else if (s22_en) begin
      census_left_misses_q <= select_2247;
      moments_before_q <= equal_671_s22_q ? select_2261 : moments_before_q;
      sharpness_comparing_product_0_q <= so_s22_q ? select_2351 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s22_q ? select_2353 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2362;
      sharpness_comparing_carry_1_q <= so_s22_q ? select_2365 : sharpness_comparing_carry_1_q;
      counts_turned_left_q <= select_2645;
      counts_turned_right_q <= select_2652;
      patches_sums_values_0_q <= select_3397;
      patches_sums_values_1_q <= equal_1763_s22_q ? patches_sums_values_1_q : select_3398;
      patches_sums_values_2_q <= equal_1763_s22_q ? patches_sums_values_2_q : select_3400;
      patches_sums_values_3_q <= equal_1763_s22_q ? patches_sums_values_3_q : select_3402;
      patches_sums_values_4_q <= equal_1763_s22_q ? patches_sums_values_4_q : select_3404;
      patches_sums_values_5_q <= equal_1763_s22_q ? patches_sums_values_5_q : select_3406;
      patches_sums_values_6_q <= equal_1763_s22_q ? patches_sums_values_6_q : select_3408;
      patches_sums_values_7_q <= equal_1763_s22_q ? patches_sums_values_7_q : select_3410;
      patches_sums_values_8_q <= equal_1763_s22_q ? patches_sums_values_8_q : select_3412;
      patches_sums_values_9_q <= equal_1763_s22_q ? patches_sums_values_9_q : select_3414;
      patches_sums_values_10_q <= equal_1763_s22_q ? patches_sums_values_10_q : select_3416;
      patches_sums_values_11_q <= equal_1763_s22_q ? patches_sums_values_11_q : select_3418;
      patches_sums_values_12_q <= equal_1763_s22_q ? patches_sums_values_12_q : select_3420;
      patches_sums_values_13_q <= equal_1763_s22_q ? patches_sums_values_13_q : select_3422;
      patches_sums_values_14_q <= equal_1763_s22_q ? patches_sums_values_14_q : select_3424;
      patches_sums_values_15_q <= equal_1763_s22_q ? patches_sums_values_15_q : select_3426;
      patches_sums_values_16_q <= equal_1763_s22_q ? patches_sums_values_16_q : select_3428;
      patches_frame_ended_q <= equal_671_s22_q & (equal_673_s22_q & (~equal_672_s22_q));
      hides_q <= equal_671_s22_q ? select_3890 : hides_q;
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
  logic [9:0] patches_sums_values_0_s23_q;
  logic [4:0] patches_summed_row_column_s23_q;
  logic patches_summed_first_s23_q;
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic patches_frame_ended_s23_q;
  logic so_s23_q;
  logic equal_671_s23_q;
  logic equal_672_s23_q;
  logic equal_673_s23_q;
  logic equal_1585_s23_q;
  logic equal_1593_s23_q;
  logic and_2020_s23_q;
  logic less_2021_s23_q;
  logic not_2265_s23_q;
  logic not_2269_s23_q;
  logic less_2273_s23_q;
  logic less_2274_s23_q;
  logic equal_2323_s23_q;
  logic or_2369_s23_q;
  logic and_2370_s23_q;
  logic or_2375_s23_q;
  logic and_2376_s23_q;
  logic select_2391_s23_q;
  logic [9:0] select_2570_s23_q;
  logic [9:0] select_2573_s23_q;
  logic and_3541_s23_q;
  logic and_3547_s23_q;
  logic and_3590_s23_q;
  logic and_3600_s23_q;
  logic and_3638_s23_q;
  logic and_3644_s23_q;
  logic and_3651_s23_q;
  logic and_3658_s23_q;
  logic and_3667_s23_q;
  logic and_3694_s23_q;
  logic [5:0] select_3715_s23_q;
  logic and_3721_s23_q;
  logic and_3726_s23_q;
  logic and_3766_s23_q;
  logic or_3857_s23_q;
  logic select_3865_s23_q;
  logic select_3890_s23_q;
  logic and_3922_s23_q;
  logic not_3924_s23_q;
  logic or_3928_s23_q;
  logic and_3933_s23_q;
  logic and_3935_s23_q;
  logic and_4037_s23_q;
  logic and_4055_s23_q;
  logic and_4058_s23_q;
  logic not_4066_s23_q;
  logic or_4085_s23_q;
  logic and_4113_s23_q;
  logic [5:0] select_4115_s23_q;
  logic [31:0] select_4127_s23_q;
  logic [9:0] select_4129_s23_q;
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
      patches_sums_values_0_s23_q <= patches_sums_values_0_q;
      patches_summed_row_column_s23_q <= patches_summed_row_column_s22_q;
      patches_summed_first_s23_q <= patches_summed_first_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_s22_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_s22_q;
      patches_frame_ended_s23_q <= patches_frame_ended_q;
      so_s23_q <= so_s22_q;
      equal_671_s23_q <= equal_671_s22_q;
      equal_672_s23_q <= equal_672_s22_q;
      equal_673_s23_q <= equal_673_s22_q;
      equal_1585_s23_q <= equal_1585_s22_q;
      equal_1593_s23_q <= equal_1593_s22_q;
      and_2020_s23_q <= and_2020_s22_q;
      less_2021_s23_q <= less_2021_s22_q;
      not_2265_s23_q <= ~less_2264;
      not_2269_s23_q <= ~less_2268;
      less_2273_s23_q <= {3'h0, counts_turned_left_q[13:2]} < sum_2272;
      less_2274_s23_q <= {3'h0, counts_turned_right_q[13:2]} < sum_2272;
      equal_2323_s23_q <= equal_2323_s22_q;
      or_2369_s23_q <= equal_2367_s22_q | xor_2368;
      and_2370_s23_q <= five_times[0] & xor_2368;
      or_2375_s23_q <= equal_2367_s22_q | xor_2374;
      and_2376_s23_q <= five_times_2[0] & xor_2374;
      select_2391_s23_q <= select_2391_s22_q;
      select_2570_s23_q <= select_2570_s22_q;
      select_2573_s23_q <= select_2573_s22_q;
      and_3541_s23_q <= and_3541;
      and_3547_s23_q <= and_3547;
      and_3590_s23_q <= and_3590;
      and_3600_s23_q <= and_3600;
      and_3638_s23_q <= and_3638;
      and_3644_s23_q <= equal_671_s22_q & and_3643;
      and_3651_s23_q <= equal_671_s22_q & and_3650;
      and_3658_s23_q <= equal_671_s22_q & and_3657;
      and_3667_s23_q <= x_s22_q[6] & (not_1954_s22_q & (less_3634 & select_3664));
      and_3694_s23_q <= not_1954_s22_q & (less_3634 & (sum_3691[4:2] == 3'h0));
      select_3715_s23_q <= equal_1763_s22_q ? select_3714 : 6'h0;
      and_3721_s23_q <= and_3721;
      and_3726_s23_q <= equal_671_s22_q & and_3725;
      and_3766_s23_q <= and_3541 & and_3765;
      or_3857_s23_q <= or_3857_s22_q;
      select_3865_s23_q <= select_3865_s22_q;
      select_3890_s23_q <= select_3890;
      and_3922_s23_q <= over[14] & equal_3633_s22_q;
      not_3924_s23_q <= not_3924_s22_q;
      or_3928_s23_q <= or_3928_s22_q;
      and_3933_s23_q <= and_3933_s22_q;
      and_3935_s23_q <= over[14] & less_3934_s22_q;
      and_4037_s23_q <= and_4037_s22_q;
      and_4055_s23_q <= select_4053[0] & and_4054;
      and_4058_s23_q <= select_4053[1] & and_4054;
      not_4066_s23_q <= not_4066_s22_q;
      or_4085_s23_q <= or_4085;
      and_4113_s23_q <= and_4113;
      select_4115_s23_q <= equal_671_s22_q ? (x_s22_q[6] ? x_s22_q[5:0] : 6'h0) : 6'h0;
      select_4127_s23_q <= select_4127_s22_q;
      select_4129_s23_q <= select_4129_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
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
  // hls/stages/patches.hpp:184
  logic less_1936;
  assign less_1936 = patches_sums_values_0_s23_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1937;
  assign not_1937 = ~less_1936;
  logic [1:0] select_1938;
  assign select_1938 = patches_summed_first_s23_q ? 2'h2 : {less_1936, not_1937};
  logic [12:0] select_1940;
  assign select_1940 = select_1938[0] ? {4'h0, patches_summed_first_s23_q, 3'h0, patches_summed_row_column_s23_q} : {patches_summed_row_column_s23_q, patches_sums_values_0_s23_q[7:0]};
  logic [14:0] select_1941;
  assign select_1941 = select_1938[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1942;
  assign select_1942 = (select_1938 == 2'h2) ? {select_1940[12:8], patches_sums_values_0_s23_q[9:8], select_1940[7:0]} : select_1941;
  // hls/stages/census.hpp:396
  logic select_2371;
  assign select_2371 = or_2369_s23_q ? and_2370_s23_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:214
  logic select_2372;
  assign select_2372 = equal_2323_s23_q ? select_2371 : sharpness_comparing_less_detail_0_q;
  logic select_2373;
  assign select_2373 = so_s23_q ? select_2372 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:396
  logic select_2377;
  assign select_2377 = or_2375_s23_q ? and_2376_s23_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:214
  logic select_2378;
  assign select_2378 = equal_2323_s23_q ? select_2377 : sharpness_comparing_less_detail_1_q;
  logic select_2379;
  assign select_2379 = so_s23_q ? select_2378 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:652
  logic not_3542;
  assign not_3542 = ~patches_lower_s23_q;
  logic not_3548;
  assign not_3548 = ~and_3547_s23_q;
  // hls/stages/patches.hpp:188
  logic and_3550;
  assign and_3550 = and_3541_s23_q & (not_3542 & not_3548);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3552;
  assign sum_3552 = {7'h0, and_3550} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:655
  logic and_3591;
  assign and_3591 = and_3590_s23_q & and_3550;
  logic [7:0] sum_3592;
  assign sum_3592 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3591};
  // hls/stages/patches.hpp:656
  logic and_3601;
  assign and_3601 = and_3600_s23_q & and_3550;
  logic [7:0] sum_3602;
  assign sum_3602 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3601};
  // hls/stages/patches.hpp:188
  logic and_3604;
  assign and_3604 = and_3541_s23_q & (and_3547_s23_q & not_3542);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3606;
  assign sum_3606 = {7'h0, and_3604} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_3608;
  assign and_3608 = and_3590_s23_q & and_3604;
  logic [7:0] sum_3609;
  assign sum_3609 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3608};
  // hls/stages/patches.hpp:656
  logic and_3611;
  assign and_3611 = and_3600_s23_q & and_3604;
  logic [7:0] sum_3612;
  assign sum_3612 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3611};
  // hls/stages/patches.hpp:188
  logic and_3614;
  assign and_3614 = and_3541_s23_q & (patches_lower_s23_q & not_3548);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3616;
  assign sum_3616 = {7'h0, and_3614} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_3618;
  assign and_3618 = and_3590_s23_q & and_3614;
  logic [7:0] sum_3619;
  assign sum_3619 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3618};
  // hls/stages/patches.hpp:656
  logic and_3621;
  assign and_3621 = and_3600_s23_q & and_3614;
  logic [7:0] sum_3622;
  assign sum_3622 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3621};
  // hls/stages/patches.hpp:188
  logic and_3624;
  assign and_3624 = and_3541_s23_q & (patches_lower_s23_q & and_3547_s23_q);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3626;
  assign sum_3626 = {7'h0, and_3624} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_3628;
  assign and_3628 = and_3590_s23_q & and_3624;
  logic [7:0] sum_3629;
  assign sum_3629 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3628};
  // hls/stages/patches.hpp:656
  logic and_3631;
  assign and_3631 = and_3600_s23_q & and_3624;
  logic [7:0] sum_3632;
  assign sum_3632 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3631};
  // hls/stages/patches.hpp:618
  logic [7:0] or_3646;
  assign or_3646 = (and_3638_s23_q ? patches_quarters_0_places_q : 8'h0) | (and_3644_s23_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3660;
  assign or_3660 = (or_3646 | (and_3651_s23_q ? patches_quarters_2_places_q : 8'h0)) | (and_3658_s23_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:787
  logic and_3668;
  assign and_3668 = equal_671_s23_q & and_3667_s23_q;
  // hls/stages/patches.hpp:619
  logic [7:0] select_3670;
  assign select_3670 = and_3638_s23_q ? (and_3668 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3672;
  assign select_3672 = and_3644_s23_q ? (and_3668 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3675;
  assign select_3675 = and_3651_s23_q ? (and_3668 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3678;
  assign select_3678 = and_3658_s23_q ? (and_3668 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3681;
  assign select_3681 = and_3638_s23_q ? (and_3668 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3683;
  assign select_3683 = and_3644_s23_q ? (and_3668 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3686;
  assign select_3686 = and_3651_s23_q ? (and_3668 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3689;
  assign select_3689 = and_3658_s23_q ? (and_3668 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:787
  logic and_3696;
  assign and_3696 = equal_671_s23_q & (x_s23_q & and_3694_s23_q);
  // hls/stages/patches.hpp:613
  logic [7:0] sum_3698;
  assign sum_3698 = patches_word_places_q + (and_3644_s23_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:615
  logic [7:0] select_3702;
  assign select_3702 = and_3696 ? (patches_word_up_q + (and_3644_s23_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3704;
  assign sum_3704 = patches_word_down_q + (and_3644_s23_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:658
  logic [5:0] select_3716;
  assign select_3716 = and_3541_s23_q ? select_3715_s23_q : 6'h0;
  logic [11:0] sum_3717;
  assign sum_3717 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3716[5]}}, select_3716};
  // hls/stages/patches.hpp:642
  logic [7:0] select_3728;
  assign select_3728 = and_3721_s23_q ? (and_3726_s23_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:644
  logic or_3732;
  assign or_3732 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:645
  logic or_3735;
  assign or_3735 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic [8:0] sum_3736;
  assign sum_3736 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:641
  logic select_3738;
  assign select_3738 = and_3721_s23_q ? (and_3726_s23_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3743;
  assign and_3743 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_3744;
  assign select_3744 = and_3721_s23_q ? {and_3743, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3746;
  assign select_3746 = and_3721_s23_q ? (and_3726_s23_q ? {and_3743, patches_found_q[2:1]} : select_3744) : patches_found_q;
  // hls/stages/patches.hpp:640
  logic or_3749;
  assign or_3749 = patches_partly_q | (patches_doubted_q & (~and_3726_s23_q));
  // hls/stages/patches.hpp:641
  logic select_3751;
  assign select_3751 = and_3726_s23_q ? or_3749 : (and_3721_s23_q ? or_3749 : patches_doubted_q);
  // hls/stages/patches.hpp:639
  logic select_3753;
  assign select_3753 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_3757;
  assign select_3757 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3767;
  assign sum_3767 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3766_s23_q};
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_3790;
  assign select_3790 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_3796;
  assign and_3796 = patches_frame_ended_s23_q & (~patches_age_q[9]);
  logic [9:0] sum_3797;
  assign sum_3797 = patches_age_q + {9'h0, and_3796};
  logic [9:0] select_3800;
  assign select_3800 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3797)) : sum_3797;
  // hls/stages/agreement.hpp:1140
  logic not_3891;
  assign not_3891 = ~hidden_for_q[7];
  logic [7:0] select_3893;
  assign select_3893 = select_3890_s23_q ? (hidden_for_q + {7'h0, not_3891}) : 8'h0;
  // hls/stages/agreement.hpp:787
  logic [7:0] select_3895;
  assign select_3895 = equal_671_s23_q ? (equal_672_s23_q ? select_3893 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1220
  logic and_3925;
  assign and_3925 = too_much_q & not_3924_s23_q;
  // hls/stages/agreement.hpp:1221
  logic select_3930;
  assign select_3930 = and_3922_s23_q ? (and_3925 | or_3928_s23_q) : and_3925;
  // hls/stages/agreement.hpp:1223
  logic select_3936;
  assign select_3936 = and_3933_s23_q ? and_3935_s23_q : overlooks_q;
  // hls/stages/agreement.hpp:432
  logic select_4057;
  assign select_4057 = and_2020_s23_q ? (less_2021_s23_q ? and_4055_s23_q : seen_q) : seen_q;
  logic select_4060;
  assign select_4060 = and_2020_s23_q ? (less_2021_s23_q ? and_4058_s23_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1231
  logic or_4067;
  assign or_4067 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4066_s23_q;
  // hls/stages/agreement.hpp:787
  logic and_4073;
  assign and_4073 = equal_671_s23_q & (equal_672_s23_q & (cfg_prove_i & or_3857_s23_q));
  // hls/stages/agreement.hpp:1233
  logic not_4075;
  assign not_4075 = ~(or_3857_s23_q | not_2266);
  // hls/stages/agreement.hpp:787
  logic and_4079;
  assign and_4079 = equal_671_s23_q & (equal_672_s23_q & (not_4075 & (select_3865_s23_q | select_3930)));
  logic and_4082;
  assign and_4082 = equal_672_s23_q & (cfg_prove_i & (registration_moved_s23_q | patches_moved_q));
  // hls/stages/agreement.hpp:1133
  logic [31:0] select_4128;
  assign select_4128 = equal_1593_s23_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4127_s23_q;
  // hls/stages/agreement.hpp:1135
  logic [31:0] select_4130;
  assign select_4130 = equal_1585_s23_q ? select_4128 : {2'h0, select_4129_s23_q, select_2573_s23_q, select_2570_s23_q};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
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
      sharpness_comparing_less_detail_0_q <= select_2373;
      sharpness_comparing_less_detail_1_q <= select_2379;
      patches_best_differing_q <= select_1942[9:0];
      patches_best_column_q <= select_1942[14:10];
      patches_quarters_0_places_q <= sum_3552;
      patches_quarters_0_up_q <= sum_3592;
      patches_quarters_0_down_q <= sum_3602;
      patches_quarters_1_places_q <= sum_3606;
      patches_quarters_1_up_q <= sum_3609;
      patches_quarters_1_down_q <= sum_3612;
      patches_quarters_2_places_q <= sum_3616;
      patches_quarters_2_up_q <= sum_3619;
      patches_quarters_2_down_q <= sum_3622;
      patches_quarters_3_places_q <= sum_3626;
      patches_quarters_3_up_q <= sum_3629;
      patches_quarters_3_down_q <= sum_3632;
      patches_word_places_q <= or_3660;
      patches_word_up_q <= ((select_3670 | select_3672) | select_3675) | select_3678;
      patches_word_down_q <= ((select_3681 | select_3683) | select_3686) | select_3689;
      patches_sum_places_q <= and_3696 ? sum_3698 : patches_sum_places_q;
      patches_sum_up_q <= select_3702;
      patches_sum_down_q <= and_3696 ? sum_3704 : patches_sum_down_q;
      patches_across_q <= sum_3717;
      patches_places_q <= select_3728;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3732;
      patches_partly_q <= or_3735;
      patches_clear_limit_q <= sum_3736[8:2];
      patches_complete_q <= select_3738;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3746;
      patches_doubted_q <= and_3721_s23_q ? select_3751 : patches_doubted_q;
      patches_doubted_before_q <= select_3753;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3757;
      patches_on_skin_q <= sum_3767;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3790;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3800;
      hidden_for_q <= select_3895;
      too_much_q <= equal_671_s23_q ? select_3930 : too_much_q;
      overlooks_q <= equal_671_s23_q ? select_3936 : overlooks_q;
      seen_q <= select_4057;
      nearer_q <= select_4060;
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
  logic patches_round_ends_s24_q;
  logic [7:0] patches_on_skin_s24_q;
  logic equal_671_s24_q;
  logic equal_672_s24_q;
  logic equal_673_s24_q;
  logic or_2271_s24_q;
  logic or_2275_s24_q;
  logic and_4037_s24_q;
  logic and_4070_s24_q;
  logic and_4073_s24_q;
  logic and_4079_s24_q;
  logic and_4083_s24_q;
  logic and_4088_s24_q;
  logic and_4092_s24_q;
  logic not_4097_s24_q;
  logic or_4103_s24_q;
  logic and_4113_s24_q;
  logic [5:0] select_4115_s24_q;
  logic [31:0] select_4132_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      patches_summed_last_s24_q <= patches_summed_last_s23_q;
      patches_summed_down_by_s24_q <= patches_summed_down_by_s23_q;
      patches_round_ends_s24_q <= patches_round_ends_q;
      patches_on_skin_s24_q <= patches_on_skin_q;
      equal_671_s24_q <= equal_671_s23_q;
      equal_672_s24_q <= equal_672_s23_q;
      equal_673_s24_q <= equal_673_s23_q;
      or_2271_s24_q <= not_2265_s23_q | (not_2266 | not_2269_s23_q);
      or_2275_s24_q <= less_2273_s23_q | less_2274_s23_q;
      and_4037_s24_q <= and_4037_s23_q;
      and_4070_s24_q <= equal_671_s23_q & (equal_672_s23_q & (cfg_prove_i & or_4067));
      and_4073_s24_q <= and_4073;
      and_4079_s24_q <= and_4079;
      and_4083_s24_q <= equal_671_s23_q & and_4082;
      and_4088_s24_q <= equal_672_s23_q & (not_4075 & (select_2373 | or_4085_s23_q));
      and_4092_s24_q <= equal_672_s23_q & (not_4075 & (select_2379 | select_2391_s23_q));
      not_4097_s24_q <= ~(select_3893 < cfg_hidden_frames_i);
      or_4103_s24_q <= not_2266 | (select_3936 & not_3770);
      and_4113_s24_q <= and_4113_s23_q;
      select_4115_s24_q <= select_4115_s23_q;
      select_4132_s24_q <= equal_671_s23_q ? (x_s23_q ? select_4130 : 32'h0) : 32'h0;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic moments_out_of_step_q;
  logic [7:0] patches_on_skin_most_q;
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/agreement.hpp:1137
  logic select_2277;
  assign select_2277 = or_2271_s24_q ? cfg_prove_i : (moments_out_of_step_q & or_2275_s24_q);
  // hls/stages/agreement.hpp:787
  logic select_2279;
  assign select_2279 = equal_672_s24_q ? moments_out_of_step_q : (equal_673_s24_q ? select_2277 : moments_out_of_step_q);
  // hls/stages/patches.hpp:649
  logic [12:0] product_3768;
  assign product_3768 = {8'h0, cfg_on_skin_limit_i} * {5'h0, patches_places_q};
  // hls/stages/patches.hpp:188
  logic and_3774;
  assign and_3774 = (~(patches_on_skin_s24_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_s24_q);
  logic select_3779;
  assign select_3779 = patches_round_ends_s24_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_3783;
  assign or_3783 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s24_q));
  // hls/stages/agreement.hpp:1142
  logic and_4099;
  assign and_4099 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4097_s24_q);
  // hls/stages/agreement.hpp:787
  logic and_4105;
  assign and_4105 = equal_672_s24_q & (or_4103_s24_q ? cfg_prove_i : patches_overlooked_q);
  logic and_4109;
  assign and_4109 = equal_671_s24_q & (equal_672_s24_q & (cfg_prove_i & moments_out_of_step_q));

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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_out_of_step_q <= 1'b0;
      patches_on_skin_most_q <= 8'h0;
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s24_en) begin
      moments_out_of_step_q <= equal_671_s24_q ? select_2279 : moments_out_of_step_q;
      patches_on_skin_most_q <= product_3768[12:5];
      patches_large_q <= not_3770 & and_3774;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3779;
      patches_spoiled_q <= or_3783;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic and_4037_s25_q;
  logic or_4061_s25_q;
  logic and_4062_s25_q;
  logic and_4070_s25_q;
  logic and_4073_s25_q;
  logic and_4079_s25_q;
  logic and_4083_s25_q;
  logic and_4089_s25_q;
  logic and_4093_s25_q;
  logic and_4101_s25_q;
  logic and_4106_s25_q;
  logic and_4109_s25_q;
  logic and_4113_s25_q;
  logic [5:0] select_4115_s25_q;
  logic [31:0] select_4132_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      and_4037_s25_q <= and_4037_s24_q;
      or_4061_s25_q <= not_2266 | seen_q;
      and_4062_s25_q <= cfg_prove_i & nearer_q;
      and_4070_s25_q <= and_4070_s24_q;
      and_4073_s25_q <= and_4073_s24_q;
      and_4079_s25_q <= and_4079_s24_q;
      and_4083_s25_q <= and_4083_s24_q;
      and_4089_s25_q <= equal_671_s24_q & and_4088_s24_q;
      and_4093_s25_q <= equal_671_s24_q & and_4092_s24_q;
      and_4101_s25_q <= equal_671_s24_q & (equal_672_s24_q & and_4099);
      and_4106_s25_q <= equal_671_s24_q & and_4105;
      and_4109_s25_q <= and_4109;
      and_4113_s25_q <= and_4113_s24_q;
      select_4115_s25_q <= select_4115_s24_q;
      select_4132_s25_q <= select_4132_s24_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s25_q;
  assign pixel_1_o = pixel_1_s25_q;
  assign saturated_o = saturated_s25_q;
  assign mask_o = mask_s25_q;
  assign marks_first_o = marks_first_s25_q;
  assign marks_last_o = marks_last_s25_q;
  assign marks_seen_o = or_4061_s25_q;
  assign marks_nearer_o = and_4062_s25_q;
  assign verdict_valid_o = and_4037_s25_q;
  assign verdict_unproven_yet_o = and_4070_s25_q;
  assign verdict_untextured_o = and_4073_s25_q;
  assign verdict_disagree_o = and_4079_s25_q;
  assign verdict_moved_o = and_4083_s25_q;
  assign verdict_unsharp_left_o = and_4089_s25_q;
  assign verdict_unsharp_right_o = and_4093_s25_q;
  assign verdict_hidden_o = and_4101_s25_q;
  assign verdict_overlooked_o = and_4106_s25_q;
  assign verdict_out_of_step_o = and_4109_s25_q;
  assign frame_valid_o = and_4113_s25_q;
  assign frame_index_o = select_4115_s25_q;
  assign frame_word_o = select_4132_s25_q;
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
  assign unused_bits = ^{over[13:0], product_3768[4:0], sum_3736[1:0], sum_3691[1:0], product_3582[4:0], sum_2674[0], difference_2610[1:0], detail_4[1:0], detail_3[1:0], sum_2241[4:0], sum_1744[1:0], sum_1743[1:0], sum_1739[0], sum_1690[0], sum_1686[0], sum_668[4:0], cfg_width_i[3:0]};

endmodule
