// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 24 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3116 bits, pipeline 8712 bits, memories 157167 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en;
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

  // Of the configuration alone: not pipelined.
  logic not_2350;
  assign not_2350 = ~cfg_prove_i;
  logic [6:0] sum_2563;
  assign sum_2563 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3623;
  assign difference_3623 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3836;
  assign not_3836 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3894;
  assign difference_3894 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_4110;
  assign less_4110 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_4111;
  assign sum_4111 = {1'b0, cfg_height_i[10:7]} + 5'h1f;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:42
  logic [3:0] select_507;
  assign select_507 = sample_pair_first_q ? 4'h0 : raster_at_x_q;
  // hls/stages/census.hpp:114
  logic equal_508;
  assign equal_508 = select_507[1:0] == 2'h0;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [8:0] select_512;
  assign select_512 = equal_508 ? (row_starts ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2140;
  assign select_2140 = sample_pair_whole_q ? (sample_last_q ? 4'h0 : (select_507 + 4'h1)) : raster_at_x_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      raster_at_x_q <= 4'h0;
      raster_row_ended_q <= 1'b1;
      averager_place_q <= 9'h0;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= select_2140;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      averager_place_q <= sample_pair_whole_q ? select_512 : averager_place_q;
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
  logic [3:0] select_507_s1_q;
  logic equal_508_s1_q;
  logic row_starts_s1_q;
  logic [8:0] select_512_s1_q;
  logic not_514_s1_q;
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
      select_507_s1_q <= select_507;
      equal_508_s1_q <= equal_508;
      row_starts_s1_q <= row_starts;
      select_512_s1_q <= select_512;
      not_514_s1_q <= ~(averager_place_q == 9'h1df);
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [6:0] raster_at_column_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  logic averager_inside_q;
  // hls/stages/census.hpp:124
  logic select_517;
  assign select_517 = equal_508_s1_q ? (row_starts_s1_q | (averager_inside_q & not_514_s1_q)) : averager_inside_q;
  // hls/stages/census.hpp:42
  logic or_518;
  assign or_518 = sample_pair_first_s1_q | raster_at_live_q;
  logic [3:0] select_526;
  assign select_526 = sample_pair_first_s1_q ? 4'h0 : raster_at_y_q;
  logic [6:0] select_542;
  assign select_542 = sample_pair_first_s1_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_s1_q ? select_542 : 7'h0;
  // hls/stages/census.hpp:53
  logic equal_544;
  assign equal_544 = select_507_s1_q == 4'hf;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2143;
  assign select_2143 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (select_526 + 4'h1) : select_526) : raster_at_y_q;
  logic [6:0] select_2146;
  assign select_2146 = sample_pair_whole_s1_q ? (sample_last_s1_q ? 7'h0 : (select_542 + {6'h0, equal_544})) : raster_at_column_q;
  logic select_2153;
  assign select_2153 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_518 & (~raster_final_row_q)) : or_518) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [10:0] select_2155;
  assign select_2155 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:276
  logic select_2159;
  assign select_2159 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      raster_at_column_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_inside_q <= 1'b1;
    end else if (s1_en) begin
      raster_at_y_q <= select_2143;
      raster_at_column_q <= select_2146;
      raster_at_live_q <= select_2153;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_2155 : raster_rows_left_q;
      raster_final_row_q <= select_2159;
      averager_inside_q <= sample_pair_whole_s1_q ? select_517 : averager_inside_q;
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
  logic [3:0] select_507_s2_q;
  logic equal_508_s2_q;
  logic row_starts_s2_q;
  logic [8:0] select_512_s2_q;
  logic and_521_s2_q;
  logic [3:0] select_526_s2_q;
  logic [6:0] select_542_s2_q;
  logic [6:0] last_s2_q;
  logic equal_544_s2_q;
  logic equal_545_s2_q;
  logic equal_1677_s2_q;
  logic [7:0] sum_2468_s2_q;
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
      sample_last_s2_q <= sample_last_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      select_507_s2_q <= select_507_s1_q;
      equal_508_s2_q <= equal_508_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_512_s2_q <= select_512_s1_q;
      and_521_s2_q <= select_517 & (or_518 & (select_507_s1_q[1:0] == 2'h3));
      select_526_s2_q <= select_526;
      select_542_s2_q <= select_542;
      last_s2_q <= last;
      equal_544_s2_q <= equal_544;
      equal_545_s2_q <= select_526 == 4'hf;
      equal_1677_s2_q <= {or_518, select_526} == 5'h18;
      sum_2468_s2_q <= {1'b0, last} + 8'h1;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic [3:0] patches_phase_q;
  // hls/stages/census.hpp:134
  logic and_546;
  assign and_546 = equal_545_s2_q & and_521_s2_q;
  // hls/stages/agreement.hpp:276
  logic and_548;
  assign and_548 = sample_pair_whole_s2_q & (equal_544_s2_q & and_546);
  // hls/stages/census.hpp:42
  logic [6:0] select_676;
  assign select_676 = sample_pair_first_s2_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] row;
  assign row = sample_pair_whole_s2_q ? select_676 : 7'h0;
  // hls/stages/census.hpp:62
  logic [6:0] select_2148;
  assign select_2148 = sample_last_s2_q ? (select_676 + {6'h0, equal_545_s2_q}) : select_676;
  // hls/stages/agreement.hpp:459
  logic equal_2469;
  assign equal_2469 = {sum_2468_s2_q[7], cfg_width_i[10:4]} == {1'b0, sum_2468_s2_q[6:0]};
  // hls/stages/patches.hpp:318
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2937;
  assign select_2937 = row_starts_s2_q ? (sample_pair_first_s2_q ? phase : patches_phase_q) : patches_phase_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      patches_phase_q <= 4'h0;
    end else if (s2_en) begin
      raster_at_row_q <= sample_pair_whole_s2_q ? select_2148 : raster_at_row_q;
      patches_phase_q <= sample_pair_whole_s2_q ? select_2937 : patches_phase_q;
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
  logic sample_present_s3_q;
  logic [3:0] select_507_s3_q;
  logic equal_508_s3_q;
  logic row_starts_s3_q;
  logic [8:0] select_512_s3_q;
  logic and_521_s3_q;
  logic [3:0] select_526_s3_q;
  logic [6:0] select_542_s3_q;
  logic [6:0] last_s3_q;
  logic and_546_s3_q;
  logic and_548_s3_q;
  logic [6:0] select_676_s3_q;
  logic [6:0] row_s3_q;
  logic equal_1677_s3_q;
  logic equal_2469_s3_q;
  logic and_2470_s3_q;
  logic [7:0] sum_2559_s3_q;
  logic [3:0] phase_s3_q;
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
      select_507_s3_q <= select_507_s2_q;
      equal_508_s3_q <= equal_508_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_512_s3_q <= select_512_s2_q;
      and_521_s3_q <= and_521_s2_q;
      select_526_s3_q <= select_526_s2_q;
      select_542_s3_q <= select_542_s2_q;
      last_s3_q <= last_s2_q;
      and_546_s3_q <= and_546;
      and_548_s3_q <= and_548;
      select_676_s3_q <= select_676;
      row_s3_q <= row;
      equal_1677_s3_q <= equal_1677_s2_q;
      equal_2469_s3_q <= equal_2469;
      and_2470_s3_q <= and_548 & equal_2469;
      sum_2559_s3_q <= {1'b0, row} + 8'h1;
      phase_s3_q <= phase;
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
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_577;
  assign equal_577 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:614
  logic equal_592;
  assign equal_592 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_593;
  assign equal_593 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:523
  logic select_2473;
  assign select_2473 = (and_2470_s3_q | (~ends_cell_q)) ? and_2470_s3_q : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2473 ? (and_2470_s3_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2477;
  assign select_2477 = select_2473 ? (and_2470_s3_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2480;
  assign select_2480 = select_2473 ? (following_last_shift_q & (~and_2470_s3_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:535
  logic [7:0] select_2482;
  assign select_2482 = select_2473 ? (and_2470_s3_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:607
  logic and_2483;
  assign and_2483 = run_last_shift_q & equal_592;
  // hls/stages/agreement.hpp:616
  logic select_2485;
  assign select_2485 = equal_592 ? (~run_last_shift_q) : equal_593;
  // hls/stages/agreement.hpp:620
  logic equal_2486;
  assign equal_2486 = run_phase_q == 3'h1;
  logic not_2489;
  assign not_2489 = ~select_2485;
  // hls/stages/agreement.hpp:623
  logic equal_2491;
  assign equal_2491 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2492;
  assign and_2492 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2493;
  assign select_2493 = equal_2491 ? 2'h1 : {2{and_2492}};
  logic [2:0] select_2495;
  assign select_2495 = (and_2483 | (select_2485 | equal_2486)) ? (equal_2486 ? 3'h2 : {not_2489, {2{select_2485}}}) : (equal_577 ? 3'h6 : {select_2493[0], select_2493});
  // hls/stages/agreement.hpp:607
  logic and_2498;
  assign and_2498 = select_2485 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2501;
  assign select_2501 = (plan_shift_q[5] & select_2485) ? value : 7'h0;
  logic [1:0] or_2502;
  assign or_2502 = {2{so}} | select_2501[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2506;
  assign or_2506 = (select_2485 ? plan_columns_q : 8'h0) | ((equal_2486 | equal_2491) ? whole_q : 8'h0);
  logic [1:0] or_2507;
  assign or_2507 = {2{and_2483}} | or_2506[4:3];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2509;
  assign or_2509 = {or_2506[7:5], or_2507, or_2506[2:0]} | (equal_577 ? drawn_q : 8'h0);
  logic [4:0] or_2510;
  assign or_2510 = {5{so}} | {or_2509[6], or_2509[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2514;
  assign not_2514 = ~run_shift_q[5];
  logic [7:0] select_2517;
  assign select_2517 = equal_592 ? ({{7{not_2514}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2521;
  assign select_2521 = and_2470_s3_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2523;
  assign select_2523 = select_2473 ? {select_2521[6], select_2521} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2526;
  assign select_2526 = select_2473 ? (and_2470_s3_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:460
  logic [6:0] select_2533;
  assign select_2533 = equal_2469_s3_q ? ((6'he < last_s3_q[6:1]) ? 7'h1d : last_s3_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2535;
  assign sum_2535 = {1'b0, last_s3_q[6:3]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2537;
  assign select_2537 = and_548_s3_q ? (equal_2469_s3_q ? {sum_2535, last_s3_q[2:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_2538;
  assign sum_2538 = {1'b0, last_s3_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2540;
  assign select_2540 = and_548_s3_q ? (equal_2469_s3_q ? {sum_2538, last_s3_q[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2554;
  assign select_2554 = (ends_cell_q | select_2473) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_592 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2558;
  assign and_2558 = (~select_2473) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic equal_2560;
  assign equal_2560 = {sum_2559_s3_q[7], cfg_height_i[10:4]} == {1'b0, sum_2559_s3_q[6:0]};
  // hls/stages/agreement.hpp:520
  logic select_2562;
  assign select_2562 = and_548_s3_q ? (equal_2469_s3_q ? equal_2560 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:372
  logic [7:0] sum_3000;
  assign sum_3000 = {1'b0, select_676_s3_q} + 8'h1;

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
      run_shift_q <= select_2477;
      run_last_shift_q <= select_2480;
      run_span_q <= select_2482;
      following_phase_q <= select_2495;
      following_shift_q <= select_2485 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2498;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2501[6], or_2502, select_2501[3:0]};
      following_columns_q <= {or_2509[7], or_2510[4], or_2509[5:4], or_2510[3:0]};
      plan_shift_q <= equal_592 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2517;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2523;
      columns_left_q <= select_2526;
      last_q <= and_548_s3_q ? (equal_2469_s3_q ? last_s3_q : last_q) : last_q;
      least_q <= and_548_s3_q ? select_2533 : least_q;
      whole_q <= select_2537;
      drawn_q <= select_2540;
      slot_q <= select_2473 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2554;
      ends_q <= and_2558;
      final_row_q <= select_2562;
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
  logic [3:0] select_507_s4_q;
  logic equal_508_s4_q;
  logic row_starts_s4_q;
  logic [8:0] select_512_s4_q;
  logic and_521_s4_q;
  logic equal_527_s4_q;
  logic [6:0] select_542_s4_q;
  logic [6:0] last_s4_2_q;
  logic and_546_s4_q;
  logic and_548_s4_q;
  logic equal_573_s4_q;
  logic so_s4_q;
  logic equal_577_s4_q;
  logic [7:0] sum_579_s4_q;
  logic equal_592_s4_q;
  logic equal_593_s4_q;
  logic [7:0] sum_610_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1677_s4_q;
  logic equal_2469_s4_q;
  logic and_2470_s4_q;
  logic select_2473_s4_q;
  logic [3:0] phase_s4_q;
  logic equal_2957_s4_q;
  logic [3:0] select_2960_s4_q;
  logic not_3002_s4_q;
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
      select_507_s4_q <= select_507_s3_q;
      equal_508_s4_q <= equal_508_s3_q;
      row_starts_s4_q <= row_starts_s3_q;
      select_512_s4_q <= select_512_s3_q;
      and_521_s4_q <= and_521_s3_q;
      equal_527_s4_q <= select_526_s3_q == 4'h0;
      select_542_s4_q <= select_542_s3_q;
      last_s4_2_q <= last_s3_q;
      and_546_s4_q <= and_546_s3_q;
      and_548_s4_q <= and_548_s3_q;
      equal_573_s4_q <= run_phase_q == 3'h7;
      so_s4_q <= so;
      equal_577_s4_q <= equal_577;
      sum_579_s4_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      equal_592_s4_q <= equal_592;
      equal_593_s4_q <= equal_593;
      sum_610_s4_q <= {1'b0, last_q} + 8'h3;
      row_s4_q <= row_s3_q;
      equal_1677_s4_q <= equal_1677_s3_q;
      equal_2469_s4_q <= equal_2469_s3_q;
      and_2470_s4_q <= and_2470_s3_q;
      select_2473_s4_q <= select_2473;
      phase_s4_q <= phase_s3_q;
      equal_2957_s4_q <= row_s3_q == 7'h3;
      select_2960_s4_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_3002_s4_q <= ~({sum_3000, select_526_s3_q, 1'b0} < {2'h0, cfg_height_i});
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  logic [3:0] patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_580;
  assign select_580 = run_shift_s4_q[5] ? x_s4_q : sum_579_s4_q;
  logic less_581;
  assign less_581 = {1'b0, last_s4_q} < select_580;
  // hls/stages/agreement.hpp:226
  logic not_582;
  assign not_582 = ~less_581;
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_s4_q + 8'hfd;
  // hls/stages/agreement.hpp:528
  logic [6:0] select_2542;
  assign select_2542 = select_2473_s4_q ? 7'h0 : (ends_cell_s4_q ? {age_q[5:0], 1'b1} : age_q);
  // hls/stages/patches.hpp:87
  logic [3:0] select_2961;
  assign select_2961 = equal_2957_s4_q ? select_2960_s4_q : patches_choosing_rows_to_next_q;
  logic equal_2962;
  assign equal_2962 = select_2961 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2965;
  assign select_2965 = equal_2469_s4_q ? (equal_2962 ? 4'h2 : (select_2961 + 4'hf)) : patches_choosing_rows_to_next_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s4_en) begin
      age_q <= select_2542;
      patches_choosing_rows_to_next_q <= and_548_s4_q ? select_2965 : patches_choosing_rows_to_next_q;
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
  logic [3:0] patches_choosing_rows_to_next_s5_q;
  logic [3:0] select_507_s5_q;
  logic equal_508_s5_q;
  logic row_starts_s5_q;
  logic [8:0] select_512_s5_q;
  logic and_521_s5_q;
  logic equal_527_s5_q;
  logic [6:0] select_542_s5_q;
  logic [6:0] last_s5_2_q;
  logic and_546_s5_q;
  logic and_548_s5_q;
  logic equal_573_s5_q;
  logic so_s5_q;
  logic equal_577_s5_q;
  logic [6:0] sum_579_s5_q;
  logic less_581_s5_q;
  logic not_582_s5_q;
  logic equal_592_s5_q;
  logic and_594_s5_q;
  logic [6:0] x_s5_2_q;
  logic and_614_s5_q;
  logic [6:0] row_s5_q;
  logic equal_1561_s5_q;
  logic equal_1677_s5_q;
  logic equal_2469_s5_q;
  logic and_2470_s5_q;
  logic [3:0] phase_s5_q;
  logic equal_2957_s5_q;
  logic equal_2962_s5_q;
  logic not_3002_s5_q;
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
      patches_choosing_rows_to_next_s5_q <= patches_choosing_rows_to_next_q;
      select_507_s5_q <= select_507_s4_q;
      equal_508_s5_q <= equal_508_s4_q;
      row_starts_s5_q <= row_starts_s4_q;
      select_512_s5_q <= select_512_s4_q;
      and_521_s5_q <= and_521_s4_q;
      equal_527_s5_q <= equal_527_s4_q;
      select_542_s5_q <= select_542_s4_q;
      last_s5_2_q <= last_s4_2_q;
      and_546_s5_q <= and_546_s4_q;
      and_548_s5_q <= and_548_s4_q;
      equal_573_s5_q <= equal_573_s4_q;
      so_s5_q <= so_s4_q;
      equal_577_s5_q <= equal_577_s4_q;
      sum_579_s5_q <= sum_579_s4_q[6:0];
      less_581_s5_q <= less_581;
      not_582_s5_q <= not_582;
      equal_592_s5_q <= equal_592_s4_q;
      and_594_s5_q <= equal_593_s4_q & not_582;
      x_s5_2_q <= x[6:0];
      and_614_s5_q <= age_q[2] & (ends_cell_s4_q & (~(sum_610_s4_q < select_580)));
      row_s5_q <= row_s4_q;
      equal_1561_s5_q <= {x[7], last_s4_q} == {1'b0, x[6:0]};
      equal_1677_s5_q <= equal_1677_s4_q;
      equal_2469_s5_q <= equal_2469_s4_q;
      and_2470_s5_q <= and_2470_s4_q;
      phase_s5_q <= phase_s4_q;
      equal_2957_s5_q <= equal_2957_s4_q;
      equal_2962_s5_q <= equal_2962;
      not_3002_s5_q <= not_3002_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_band_rows_rows_to_next_q;
  logic [4:0] patches_band_rows_number_q;
  logic [3:0] patches_next_band_rows_to_next_q;
  logic [4:0] patches_next_band_number_q;
  logic [3:0] patches_first_band_rows_to_next_q;
  logic patches_first_band_number_q;
  logic [4:0] patches_choosing_number_q;
  logic patches_chooses_q;
  logic [4:0] patches_choosing_band_q;
  // hls/stages/agreement.hpp:594
  logic or_578;
  assign or_578 = so_s5_q | equal_577_s5_q;
  // hls/stages/agreement.hpp:149
  logic select_596;
  assign select_596 = or_578 ? not_582_s5_q : (equal_592_s5_q ? not_582_s5_q : and_594_s5_q);
  logic and_615;
  assign and_615 = equal_592_s5_q & and_614_s5_q;
  logic select_616;
  assign select_616 = or_578 ? not_582_s5_q : and_615;
  // hls/stages/agreement.hpp:821
  logic [6:0] right;
  assign right = sum_579_s5_q + 7'h7d;
  // hls/stages/agreement.hpp:149
  logic [6:0] select_640;
  assign select_640 = or_578 ? x_s5_q[6:0] : (equal_592_s5_q ? sum_579_s5_q : x_s5_q[6:0]);
  // hls/stages/agreement.hpp:720
  logic not_646;
  assign not_646 = ~or_578;
  // hls/stages/census.hpp:33
  logic not_1675;
  assign not_1675 = ~sample_pair_first_s5_q;
  // hls/stages/patches.hpp:312
  logic equal_1679;
  assign equal_1679 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/agreement.hpp:520
  logic and_2827;
  assign and_2827 = and_548_s5_q & (equal_2469_s5_q & (row_s5_q[6:2] == 5'h0));
  // hls/stages/patches.hpp:374
  logic and_2939;
  assign and_2939 = not_1675 & equal_1677_s5_q;
  logic [8:0] select_2940;
  assign select_2940 = and_2939 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s5_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2941;
  assign select_2941 = and_2939 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2942;
  assign select_2942 = sample_pair_first_s5_q ? select_2940 : select_2941;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2943;
  assign select_2943 = row_starts_s5_q ? select_2942[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2944;
  assign select_2944 = sample_pair_whole_s5_q ? select_2943 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2946;
  assign select_2946 = sample_pair_whole_s5_q ? (row_starts_s5_q ? select_2942[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2949;
  assign select_2949 = sample_pair_whole_s5_q ? (equal_1679 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2951;
  assign select_2951 = sample_pair_whole_s5_q ? (patches_band_rows_number_q + {4'h0, equal_1679}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:331
  logic equal_2952;
  assign equal_2952 = phase_s5_q == 4'h0;
  // hls/stages/patches.hpp:332
  logic not_2953;
  assign not_2953 = ~equal_2952;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2955;
  assign select_2955 = sample_pair_whole_s5_q ? (phase_s5_q + {{2{not_2953}}, 1'b1, not_2953}) : patches_first_band_rows_to_next_q;
  logic select_2956;
  assign select_2956 = sample_pair_whole_s5_q ? equal_2952 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2967;
  assign select_2967 = equal_2957_s5_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2969;
  assign select_2969 = equal_2469_s5_q ? (select_2967 + {4'h0, equal_2962_s5_q}) : patches_choosing_number_q;
  logic select_2973;
  assign select_2973 = equal_2469_s5_q ? ((7'h2 < row_s5_q) & equal_2962_s5_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:520
  logic [4:0] select_2976;
  assign select_2976 = and_548_s5_q ? (equal_2469_s5_q ? select_2967 : patches_choosing_band_q) : patches_choosing_band_q;

  // Memory left, 120 x 85, DISTANCE 24, hls/stages/agreement.hpp:1373; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
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
  assign left_re = s5_en & select_596;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 99, DISTANCE 24, hls/stages/agreement.hpp:1374; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [98:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_640;
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s5_en & select_596;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1375; read in stage 5, written in stage 16: 5 < 16 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [61:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 62'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_578 ? x_s5_q[6:0] : x_s5_2_q;
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s5_en & select_616;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_band_rows_rows_to_next_q <= 4'h0;
      patches_band_rows_number_q <= 5'h0;
      patches_next_band_rows_to_next_q <= 4'h0;
      patches_next_band_number_q <= 5'h0;
      patches_first_band_rows_to_next_q <= 4'h0;
      patches_first_band_number_q <= 1'b0;
      patches_choosing_number_q <= 5'h0;
      patches_chooses_q <= 1'b0;
      patches_choosing_band_q <= 5'h0;
    end else if (s5_en) begin
      patches_band_rows_rows_to_next_q <= select_2944;
      patches_band_rows_number_q <= select_2946;
      patches_next_band_rows_to_next_q <= select_2949;
      patches_next_band_number_q <= select_2951;
      patches_first_band_rows_to_next_q <= select_2955;
      patches_first_band_number_q <= select_2956;
      patches_choosing_number_q <= and_548_s5_q ? select_2969 : patches_choosing_number_q;
      patches_chooses_q <= and_548_s5_q ? select_2973 : patches_chooses_q;
      patches_choosing_band_q <= select_2976;
    end
  end

  logic [7:0] pixel_0_s6_q;
  logic [7:0] pixel_1_s6_q;
  logic saturated_s6_q;
  logic mask_s6_q;
  logic marks_first_s6_q;
  logic marks_last_s6_q;
  logic sample_pair_whole_s6_q;
  logic sample_present_s6_q;
  logic [5:0] run_shift_s6_q;
  logic [7:0] x_s6_q;
  logic [6:0] last_s6_q;
  logic [3:0] age_s6_q;
  logic [2:0] slot_s6_q;
  logic ends_cell_s6_q;
  logic shift_first_s6_q;
  logic [4:0] patches_band_rows_number_s6_q;
  logic patches_chooses_s6_q;
  logic [4:0] patches_choosing_band_s6_q;
  logic [3:0] select_507_s6_q;
  logic equal_508_s6_q;
  logic row_starts_s6_q;
  logic [8:0] select_512_s6_q;
  logic and_521_s6_q;
  logic equal_527_s6_q;
  logic [6:0] select_542_s6_q;
  logic [6:0] last_s6_2_q;
  logic and_546_s6_q;
  logic and_548_s6_q;
  logic equal_573_s6_q;
  logic so_s6_q;
  logic equal_577_s6_q;
  logic or_578_s6_q;
  logic less_581_s6_q;
  logic not_582_s6_q;
  logic equal_592_s6_q;
  logic [6:0] x_s6_2_q;
  logic select_616_s6_q;
  logic [6:0] right_s6_q;
  logic and_649_s6_q;
  logic [6:0] row_s6_q;
  logic and_1560_s6_q;
  logic equal_1561_s6_q;
  logic not_1675_s6_q;
  logic or_1681_s6_q;
  logic equal_2469_s6_q;
  logic and_2828_s6_q;
  logic and_2830_s6_q;
  logic and_2837_s6_q;
  logic not_3002_s6_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s6_q <= pixel_0_s5_q;
      pixel_1_s6_q <= pixel_1_s5_q;
      saturated_s6_q <= saturated_s5_q;
      mask_s6_q <= mask_s5_q;
      marks_first_s6_q <= marks_first_s5_q;
      marks_last_s6_q <= marks_last_s5_q;
      sample_pair_whole_s6_q <= sample_pair_whole_s5_q;
      sample_present_s6_q <= sample_present_s5_q;
      run_shift_s6_q <= run_shift_s5_q;
      x_s6_q <= x_s5_q;
      last_s6_q <= last_s5_q;
      age_s6_q <= age_s5_q;
      slot_s6_q <= slot_s5_q;
      ends_cell_s6_q <= ends_cell_s5_q;
      shift_first_s6_q <= shift_first_s5_q;
      patches_band_rows_number_s6_q <= patches_band_rows_number_q;
      patches_chooses_s6_q <= patches_chooses_q;
      patches_choosing_band_s6_q <= patches_choosing_band_q;
      select_507_s6_q <= select_507_s5_q;
      equal_508_s6_q <= equal_508_s5_q;
      row_starts_s6_q <= row_starts_s5_q;
      select_512_s6_q <= select_512_s5_q;
      and_521_s6_q <= and_521_s5_q;
      equal_527_s6_q <= equal_527_s5_q;
      select_542_s6_q <= select_542_s5_q;
      last_s6_2_q <= last_s5_2_q;
      and_546_s6_q <= and_546_s5_q;
      and_548_s6_q <= and_548_s5_q;
      equal_573_s6_q <= equal_573_s5_q;
      so_s6_q <= so_s5_q;
      equal_577_s6_q <= equal_577_s5_q;
      or_578_s6_q <= or_578;
      less_581_s6_q <= less_581_s5_q;
      not_582_s6_q <= not_582_s5_q;
      equal_592_s6_q <= equal_592_s5_q;
      x_s6_2_q <= x_s5_2_q;
      select_616_s6_q <= select_616;
      right_s6_q <= right;
      and_649_s6_q <= not_646 & ((~equal_592_s5_q) & and_594_s5_q);
      row_s6_q <= row_s5_q;
      and_1560_s6_q <= not_646 & and_615;
      equal_1561_s6_q <= equal_1561_s5_q;
      not_1675_s6_q <= not_1675;
      or_1681_s6_q <= (~equal_1677_s5_q) | (~equal_1679);
      equal_2469_s6_q <= equal_2469_s5_q;
      and_2828_s6_q <= and_2470_s5_q & and_2827;
      and_2830_s6_q <= and_2470_s5_q & (~and_2827);
      and_2837_s6_q <= ends_cell_s5_q & so_s5_q;
      not_3002_s6_q <= not_3002_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
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
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/patches.hpp:393
  logic not_1672;
  assign not_1672 = ~patches_begins_q;
  // hls/stages/patches.hpp:363
  logic and_1676;
  assign and_1676 = patches_capturing_q & not_1675_s6_q;
  // hls/stages/patches.hpp:125
  logic and_1684;
  assign and_1684 = (not_1672 & (patches_work_q == 3'h0)) & (~(and_1676 | or_1681_s6_q));
  // hls/stages/registration.hpp:218
  logic [16:0] select_1751;
  assign select_1751 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/patches.hpp:535
  logic equal_1783;
  assign equal_1783 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:506
  logic equal_1785;
  assign equal_1785 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:500
  logic equal_1787;
  assign equal_1787 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1788;
  assign equal_1788 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:535
  logic or_1789;
  assign or_1789 = equal_1787 | equal_1788;
  // hls/stages/patches.hpp:461
  logic not_1790;
  assign not_1790 = ~patches_second_q;
  // hls/stages/patches.hpp:374
  logic [4:0] select_1812;
  assign select_1812 = and_1684 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1813;
  assign select_1813 = row_starts_s6_q ? select_1812 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1815;
  assign and_1815 = and_1676 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1819;
  assign select_1819 = row_starts_s6_q ? (and_1684 | (and_1676 & (~and_1815))) : patches_capturing_q;
  // hls/stages/patches.hpp:168
  logic not_1843;
  assign not_1843 = ~equal_1788;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1857;
  assign select_1857 = row_starts_s6_q ? {select_1812[4], select_1812[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:547
  logic less_1961;
  assign less_1961 = patches_step_q[4:0] < 5'h11;
  logic equal_1962;
  assign equal_1962 = patches_step_q[6:5] == 2'h0;
  logic not_1963;
  assign not_1963 = ~equal_1962;
  logic equal_1964;
  assign equal_1964 = patches_step_q[6:5] == 2'h3;
  logic not_1965;
  assign not_1965 = ~equal_1964;
  // hls/stages/patches.hpp:561
  logic select_1968;
  assign select_1968 = equal_1964 ? (less_1961 & (less_1961 & not_1965)) : less_1961;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1993;
  assign sum_1993 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2831;
  assign select_2831 = and_2830_s6_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2833;
  assign select_2833 = and_2828_s6_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2831[15]}}, select_2831});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2834;
  assign select_2834 = and_2830_s6_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2834[15]}}, select_2834};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2836;
  assign select_2836 = and_2828_s6_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2837_s6_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:394
  logic or_3043;
  assign or_3043 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:396
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:188
  logic and_3049;
  assign and_3049 = equal_1783 & not_1790;
  // hls/stages/patches.hpp:400
  logic and_3050;
  assign and_3050 = not_1843 & and_3049;
  logic [1:0] select_3052;
  assign select_3052 = equal_1785 ? 2'h0 : (equal_1787 ? 2'h3 : {equal_1788, and_3050});
  // hls/stages/patches.hpp:280
  logic equal_3054;
  assign equal_3054 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:278
  logic not_3055;
  assign not_3055 = ~equal_3054;
  // hls/stages/patches.hpp:280
  logic equal_3056;
  assign equal_3056 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:276
  logic not_3057;
  assign not_3057 = ~equal_3056;
  // hls/stages/patches.hpp:284
  logic not_3059;
  assign not_3059 = ~(patches_following_q == 3'h2);
  logic and_3062;
  assign and_3062 = (~(patches_following_q == 3'h1)) & not_3059;
  // hls/stages/patches.hpp:398
  logic [1:0] select_3063;
  assign select_3063 = equal_3056 ? 2'h2 : {and_3062, not_3059};
  logic [3:0] select_3064;
  assign select_3064 = equal_3054 ? 4'h2 : {select_3063, {2{not_3057}}};
  // hls/stages/patches.hpp:406
  logic not_3067;
  assign not_3067 = ~or_3043;
  // hls/stages/patches.hpp:395
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:407
  logic [11:0] select_3072;
  assign select_3072 = or_3043 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3884;
  assign select_3884 = so_s6_q ? (and_2837_s6_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3886;
  assign sum_3886 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3887;
  assign select_3887 = sum_1993[5] ? {1'b1, sum_1993[4:0], region_across_rest_q[2:0]} : sum_3886;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3889;
  assign select_3889 = equal_2469_s6_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3892;
  assign select_3892 = equal_2469_s6_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1372; read in stage 6, written in stage 21: 6 < 21 < 6 + DISTANCE.
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
  assign fresh_re = s6_en & and_649_s6_q;
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
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s6_en) begin
      registration_slope_row_q <= select_2833;
      registration_slope_change_q <= select_2836;
      registration_slope_q <= so_s6_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_capturing_q <= sample_pair_whole_s6_q ? select_1819 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s6_q ? select_1813 : patches_row_q;
      patches_work_q <= or_3043 ? following : patches_work_q;
      patches_second_q <= not_1672 & (patches_second_q | (patches_ends_q & equal_1783));
      patches_following_q <= equal_1783 ? {2'h0, and_3049} : {equal_1785, select_3052};
      patches_following_beats_q <= {select_3064, not_3055};
      patches_begins_q <= sample_pair_whole_s6_q & (row_starts_s6_q & and_1815);
      patches_ends_q <= not_3067 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3072;
      patches_step_q <= or_3043 ? 7'h0 : (patches_step_q + 7'h1);
      region_across_rest_q <= select_3884;
      region_across_back_q <= so_s6_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3887;
      columns_begin_rest_q <= and_548_s6_q ? select_3889 : columns_begin_rest_q;
      columns_begin_back_q <= and_548_s6_q ? select_3892 : columns_begin_back_q;
    end
  end

  logic [7:0] pixel_0_s7_q;
  logic [7:0] pixel_1_s7_q;
  logic saturated_s7_q;
  logic mask_s7_q;
  logic marks_first_s7_q;
  logic marks_last_s7_q;
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
  logic [4:0] patches_band_rows_number_s7_q;
  logic patches_chooses_s7_q;
  logic [4:0] patches_choosing_band_s7_q;
  logic patches_second_s7_q;
  logic [4:0] patches_step_s7_q;
  logic [3:0] select_507_s7_q;
  logic equal_508_s7_q;
  logic row_starts_s7_q;
  logic [8:0] select_512_s7_q;
  logic and_521_s7_q;
  logic equal_527_s7_q;
  logic [6:0] select_542_s7_q;
  logic [6:0] last_s7_2_q;
  logic and_546_s7_q;
  logic and_548_s7_q;
  logic equal_573_s7_q;
  logic so_s7_q;
  logic equal_577_s7_q;
  logic or_578_s7_q;
  logic less_581_s7_q;
  logic not_582_s7_q;
  logic equal_592_s7_q;
  logic [84:0] left_rdata_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_616_s7_q;
  logic [61:0] best_left_rdata_s7_q;
  logic [6:0] right_s7_q;
  logic [98:0] right_codes_rdata_s7_q;
  logic and_649_s7_q;
  logic [6:0] row_s7_q;
  logic and_1560_s7_q;
  logic equal_1561_s7_q;
  logic and_1684_s7_q;
  logic [16:0] select_1751_s7_q;
  logic equal_1783_s7_q;
  logic equal_1785_s7_q;
  logic equal_1787_s7_q;
  logic equal_1788_s7_q;
  logic or_1789_s7_q;
  logic and_1792_s7_q;
  logic [4:0] select_1813_s7_q;
  logic select_1819_s7_q;
  logic and_1825_s7_q;
  logic and_1844_s7_q;
  logic [3:0] select_1857_s7_q;
  logic less_1961_s7_q;
  logic equal_1962_s7_q;
  logic not_1963_s7_q;
  logic equal_1964_s7_q;
  logic not_1965_s7_q;
  logic select_1968_s7_q;
  logic and_1969_s7_q;
  logic sum_1993_s7_q;
  logic equal_2469_s7_q;
  logic not_3002_s7_q;
  logic or_3043_s7_q;
  logic not_3067_s7_q;
  logic and_3539_s7_q;
  logic equal_3546_s7_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s7_q <= pixel_0_s6_q;
      pixel_1_s7_q <= pixel_1_s6_q;
      saturated_s7_q <= saturated_s6_q;
      mask_s7_q <= mask_s6_q;
      marks_first_s7_q <= marks_first_s6_q;
      marks_last_s7_q <= marks_last_s6_q;
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
      patches_band_rows_number_s7_q <= patches_band_rows_number_s6_q;
      patches_chooses_s7_q <= patches_chooses_s6_q;
      patches_choosing_band_s7_q <= patches_choosing_band_s6_q;
      patches_second_s7_q <= patches_second_q;
      patches_step_s7_q <= patches_step_q[4:0];
      select_507_s7_q <= select_507_s6_q;
      equal_508_s7_q <= equal_508_s6_q;
      row_starts_s7_q <= row_starts_s6_q;
      select_512_s7_q <= select_512_s6_q;
      and_521_s7_q <= and_521_s6_q;
      equal_527_s7_q <= equal_527_s6_q;
      select_542_s7_q <= select_542_s6_q;
      last_s7_2_q <= last_s6_2_q;
      and_546_s7_q <= and_546_s6_q;
      and_548_s7_q <= and_548_s6_q;
      equal_573_s7_q <= equal_573_s6_q;
      so_s7_q <= so_s6_q;
      equal_577_s7_q <= equal_577_s6_q;
      or_578_s7_q <= or_578_s6_q;
      less_581_s7_q <= less_581_s6_q;
      not_582_s7_q <= not_582_s6_q;
      equal_592_s7_q <= equal_592_s6_q;
      left_rdata_s7_q <= left_rdata_q;
      x_s7_2_q <= x_s6_2_q;
      select_616_s7_q <= select_616_s6_q;
      best_left_rdata_s7_q <= best_left_rdata_q;
      right_s7_q <= right_s6_q;
      right_codes_rdata_s7_q <= right_codes_rdata_q;
      and_649_s7_q <= and_649_s6_q;
      row_s7_q <= row_s6_q;
      and_1560_s7_q <= and_1560_s6_q;
      equal_1561_s7_q <= equal_1561_s6_q;
      and_1684_s7_q <= and_1684;
      select_1751_s7_q <= select_1751;
      equal_1783_s7_q <= equal_1783;
      equal_1785_s7_q <= equal_1785;
      equal_1787_s7_q <= equal_1787;
      equal_1788_s7_q <= equal_1788;
      or_1789_s7_q <= or_1789;
      and_1792_s7_q <= or_1789 & (equal_1788 & not_1790);
      select_1813_s7_q <= select_1813;
      select_1819_s7_q <= select_1819;
      and_1825_s7_q <= or_1789 & (patches_second_q & equal_1788);
      and_1844_s7_q <= not_1843 & or_1789;
      select_1857_s7_q <= select_1857;
      less_1961_s7_q <= less_1961;
      equal_1962_s7_q <= equal_1962;
      not_1963_s7_q <= not_1963;
      equal_1964_s7_q <= equal_1964;
      not_1965_s7_q <= not_1965;
      select_1968_s7_q <= select_1968;
      and_1969_s7_q <= not_1963 & select_1968;
      sum_1993_s7_q <= sum_1993[5];
      equal_2469_s7_q <= equal_2469_s6_q;
      not_3002_s7_q <= not_3002_s6_q;
      or_3043_s7_q <= or_3043;
      not_3067_s7_q <= not_3067;
      and_3539_s7_q <= less_1961 & (patches_step_q[6:5] == 2'h1);
      equal_3546_s7_q <= patches_step_q[6:5] == 2'h2;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  logic [15:0] patches_chance_q;
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:668
  logic equal_567;
  assign equal_567 = row_q == 7'h0;
  // hls/stages/agreement.hpp:975
  logic and_606;
  assign and_606 = (or_578_s7_q & (left_rdata_s7_q[67] & not_582_s7_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s7_q[2] ? best_left_rdata_s7_q[5:0] : best_left_rdata_s7_q[45:40];
  // hls/stages/agreement.hpp:668
  logic not_746;
  assign not_746 = ~equal_567;
  // hls/stages/agreement.hpp:221
  logic and_761;
  assign and_761 = left_rdata_s7_q[48] & not_582_s7_q;
  logic and_762;
  assign and_762 = right_codes_rdata_s7_q[42] & not_582_s7_q;
  logic [11:0] select_763;
  assign select_763 = less_581_s7_q ? 12'h0 : left_rdata_s7_q[47:36];
  logic [11:0] select_764;
  assign select_764 = less_581_s7_q ? 12'h0 : right_codes_rdata_s7_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_768;
  assign select_768 = and_761 ? (and_762 ? (~(select_763 ^ select_764)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_784;
  assign and_784 = left_rdata_s7_q[66] & not_582_s7_q;
  logic and_785;
  assign and_785 = right_codes_rdata_s7_q[57] & not_582_s7_q;
  logic [11:0] select_786;
  assign select_786 = less_581_s7_q ? 12'h0 : left_rdata_s7_q[65:54];
  logic [11:0] select_787;
  assign select_787 = less_581_s7_q ? 12'h0 : right_codes_rdata_s7_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_791;
  assign select_791 = and_784 ? (and_785 ? (~(select_786 ^ select_787)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_801;
  assign and_801 = left_rdata_s7_q[84] & not_582_s7_q;
  logic and_802;
  assign and_802 = right_codes_rdata_s7_q[72] & not_582_s7_q;
  logic [11:0] select_803;
  assign select_803 = less_581_s7_q ? 12'h0 : left_rdata_s7_q[83:72];
  logic [11:0] select_804;
  assign select_804 = less_581_s7_q ? 12'h0 : right_codes_rdata_s7_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_808;
  assign select_808 = and_801 ? (and_802 ? (~(select_803 ^ select_804)) : 12'h0) : 12'h0;
  logic [11:0] select_1016;
  assign select_1016 = (slot_s7_q[0] ? and_802 : and_785) ? (~(select_763 ^ (slot_s7_q[0] ? select_804 : select_787))) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_1033;
  assign and_1033 = right_codes_rdata_s7_q[85] & not_582_s7_q;
  logic [11:0] select_1035;
  assign select_1035 = less_581_s7_q ? 12'h0 : right_codes_rdata_s7_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1039;
  assign select_1039 = (slot_s7_q[0] ? and_1033 : and_802) ? (~(select_786 ^ (slot_s7_q[0] ? select_1035 : select_804))) : 12'h0;
  // hls/stages/agreement.hpp:734
  logic select_1051;
  assign select_1051 = slot_s7_q[0] ? (right_codes_rdata_s7_q[98] & not_582_s7_q) : and_1033;
  logic [11:0] select_1053;
  assign select_1053 = slot_s7_q[0] ? (less_581_s7_q ? 12'h0 : right_codes_rdata_s7_q[97:86]) : select_1035;
  // hls/stages/agreement.hpp:221
  logic and_1262;
  assign and_1262 = right_codes_rdata_s7_q[27] & not_582_s7_q;
  // hls/stages/agreement.hpp:734
  logic select_1263;
  assign select_1263 = slot_s7_q[0] ? (right_codes_rdata_s7_q[12] & not_582_s7_q) : and_1262;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1265;
  assign select_1265 = less_581_s7_q ? 12'h0 : right_codes_rdata_s7_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1266;
  assign select_1266 = slot_s7_q[0] ? (less_581_s7_q ? 12'h0 : right_codes_rdata_s7_q[11:0]) : select_1265;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1290;
  assign select_1290 = (slot_s7_q[0] ? and_1262 : and_762) ? (~(select_786 ^ (slot_s7_q[0] ? select_1265 : select_764))) : 12'h0;
  logic [11:0] select_1305;
  assign select_1305 = (slot_s7_q[0] ? and_762 : and_785) ? (~(select_803 ^ (slot_s7_q[0] ? select_764 : select_787))) : 12'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s7_q[6:1]} < x_s7_q;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_578_s7_q ? (less_581_s7_q ? 6'h0 : best_left_rdata_s7_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1753;
  assign select_1753 = ($signed(10'h0) < $signed(select_1751_s7_q[16:7])) ? 14'h7f : select_1751_s7_q[13:0];
  // hls/stages/patches.hpp:513
  logic not_1784;
  assign not_1784 = ~equal_1783_s7_q;
  // hls/stages/patches.hpp:459
  logic not_1786;
  assign not_1786 = ~equal_1785_s7_q;
  logic and_1867;
  assign and_1867 = not_1784 & (or_1789_s7_q & not_1786);
  // hls/stages/patches.hpp:185
  logic and_1971;
  assign and_1971 = equal_1783_s7_q & (less_1961_s7_q ? and_1969_s7_q : select_1968_s7_q);
  // hls/stages/agreement.hpp:460
  logic select_2566;
  assign select_2566 = equal_2469_s7_q ? (~({row_s7_q, 1'b0} < {sum_2563, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2727;
  assign select_2727 = or_578_s7_q ? (less_581_s7_q ? 8'h0 : best_left_rdata_s7_q[32:25]) : 8'h0;
  logic [7:0] select_2729;
  assign select_2729 = or_578_s7_q ? (less_581_s7_q ? 8'h0 : best_left_rdata_s7_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:91
  logic parity_2980;
  assign parity_2980 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2981;
  assign select_2981 = equal_2469_s7_q ? {patches_chance_q[14:0], parity_2980} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s7_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:126
  logic select_3004;
  assign select_3004 = row_starts_s7_q ? (and_1684_s7_q ? not_3002_s7_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:188
  logic [4:0] select_3074;
  assign select_3074 = or_3043_s7_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:561
  logic select_3542;
  assign select_3542 = equal_1964_s7_q ? (less_1961_s7_q ? (not_1965_s7_q & and_3539_s7_q) : and_3539_s7_q) : and_3539_s7_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:780; read in stage 7, written in stage 20: 7 < 20 < 7 + DISTANCE.
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
  assign patches_right_0_re = s7_en & (not_1784 & (not_1786 & and_1792_s7_q));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:780; read in stage 7, written in stage 20: 7 < 20 < 7 + DISTANCE.
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
  assign patches_right_1_re = s7_en & (not_1784 & (not_1786 & and_1825_s7_q));
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:792; read in stage 7, written in stage 11: 7 < 11 < 7 + DISTANCE.
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
  assign patches_columns_above_re = s7_en & and_1867;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:812; read in stage 7, written in stage 22: 7 < 22 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_s7_q;
`ifndef SYNTHESIS
  logic patches_rows_re;
  assign patches_rows_re = s7_en & and_1971;
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      lower_half_q <= 1'b0;
      patches_chance_q <= 16'h1;
      patches_lower_q <= 1'b0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
    end else if (s7_en) begin
      row_q <= and_548_s7_q ? (equal_2469_s7_q ? row_s7_q : row_q) : row_q;
      lower_half_q <= and_548_s7_q ? select_2566 : lower_half_q;
      patches_chance_q <= and_548_s7_q ? select_2981 : patches_chance_q;
      patches_lower_q <= sample_pair_whole_s7_q ? select_3004 : patches_lower_q;
      patches_code_row_q <= select_3074;
      patches_column_q <= or_3043_s7_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3067_s7_q & (patches_column_q == 5'h1e);
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
  logic lower_half_s8_q;
  logic shift_first_s8_q;
  logic [11:0] registration_slope_s8_q;
  logic [4:0] patches_band_rows_number_s8_q;
  logic patches_chooses_s8_q;
  logic [4:0] patches_choosing_band_s8_q;
  logic patches_lower_s8_q;
  logic patches_second_s8_q;
  logic [4:0] patches_code_row_s8_q;
  logic [4:0] patches_column_s8_q;
  logic [4:0] patches_step_s8_q;
  logic [3:0] select_507_s8_q;
  logic equal_508_s8_q;
  logic row_starts_s8_q;
  logic [8:0] select_512_s8_q;
  logic and_521_s8_q;
  logic equal_527_s8_q;
  logic [6:0] select_542_s8_q;
  logic [6:0] last_s8_2_q;
  logic and_546_s8_q;
  logic and_548_s8_q;
  logic equal_567_s8_q;
  logic equal_573_s8_q;
  logic so_s8_q;
  logic equal_577_s8_q;
  logic or_578_s8_q;
  logic less_581_s8_q;
  logic not_582_s8_q;
  logic equal_592_s8_q;
  logic [62:0] left_rdata_s8_q;
  logic and_599_s8_q;
  logic and_607_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_616_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic [5:0] shift_s8_q;
  logic [6:0] right_s8_q;
  logic and_638_s8_q;
  logic [77:0] right_codes_rdata_s8_q;
  logic and_643_s8_q;
  logic and_645_s8_q;
  logic and_649_s8_q;
  logic [32:0] fresh_rdata_s8_q;
  logic equal_678_s8_q;
  logic and_747_s8_q;
  logic and_748_s8_q;
  logic and_749_s8_q;
  logic and_750_s8_q;
  logic and_751_s8_q;
  logic and_752_s8_q;
  logic and_753_s8_q;
  logic and_754_s8_q;
  logic and_755_s8_q;
  logic and_756_s8_q;
  logic and_761_s8_q;
  logic [11:0] select_768_s8_q;
  logic and_784_s8_q;
  logic [11:0] select_791_s8_q;
  logic and_801_s8_q;
  logic [11:0] select_808_s8_q;
  logic [11:0] select_1016_s8_q;
  logic [11:0] select_1039_s8_q;
  logic [11:0] select_1056_s8_q;
  logic [11:0] select_1269_s8_q;
  logic [11:0] select_1290_s8_q;
  logic [11:0] select_1305_s8_q;
  logic and_1560_s8_q;
  logic equal_1561_s8_q;
  logic and_1684_s8_q;
  logic right_3_s8_q;
  logic less_1698_s8_q;
  logic [5:0] b_s8_q;
  logic [13:0] select_1753_s8_q;
  logic equal_1783_s8_q;
  logic not_1784_s8_q;
  logic equal_1785_s8_q;
  logic not_1786_s8_q;
  logic equal_1787_s8_q;
  logic equal_1788_s8_q;
  logic or_1789_s8_q;
  logic [4:0] select_1813_s8_q;
  logic select_1819_s8_q;
  logic and_1846_s8_q;
  logic [3:0] select_1857_s8_q;
  logic and_1867_s8_q;
  logic less_1961_s8_q;
  logic equal_1962_s8_q;
  logic not_1963_s8_q;
  logic equal_1964_s8_q;
  logic not_1965_s8_q;
  logic sum_1993_s8_q;
  logic and_2014_s8_q;
  logic and_2131_s8_q;
  logic equal_2280_s8_q;
  logic equal_2469_s8_q;
  logic and_2595_s8_q;
  logic [7:0] select_2727_s8_q;
  logic [7:0] select_2729_s8_q;
  logic [5:0] further_s8_q;
  logic or_3043_s8_q;
  logic not_3067_s8_q;
  logic select_3544_s8_q;
  logic equal_3546_s8_q;
  logic less_3872_s8_q;
  logic equal_4091_s8_q;
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
      lower_half_s8_q <= lower_half_q;
      shift_first_s8_q <= shift_first_s7_q;
      registration_slope_s8_q <= registration_slope_s7_q;
      patches_band_rows_number_s8_q <= patches_band_rows_number_s7_q;
      patches_chooses_s8_q <= patches_chooses_s7_q;
      patches_choosing_band_s8_q <= patches_choosing_band_s7_q;
      patches_lower_s8_q <= patches_lower_q;
      patches_second_s8_q <= patches_second_s7_q;
      patches_code_row_s8_q <= patches_code_row_q;
      patches_column_s8_q <= patches_column_q;
      patches_step_s8_q <= patches_step_s7_q;
      select_507_s8_q <= select_507_s7_q;
      equal_508_s8_q <= equal_508_s7_q;
      row_starts_s8_q <= row_starts_s7_q;
      select_512_s8_q <= select_512_s7_q;
      and_521_s8_q <= and_521_s7_q;
      equal_527_s8_q <= equal_527_s7_q;
      select_542_s8_q <= select_542_s7_q;
      last_s8_2_q <= last_s7_2_q;
      and_546_s8_q <= and_546_s7_q;
      and_548_s8_q <= and_548_s7_q;
      equal_567_s8_q <= equal_567;
      equal_573_s8_q <= equal_573_s7_q;
      so_s8_q <= so_s7_q;
      equal_577_s8_q <= equal_577_s7_q;
      or_578_s8_q <= or_578_s7_q;
      less_581_s8_q <= less_581_s7_q;
      not_582_s8_q <= not_582_s7_q;
      equal_592_s8_q <= equal_592_s7_q;
      left_rdata_s8_q <= {left_rdata_s7_q[65:49], left_rdata_s7_q[47:31], left_rdata_s7_q[29:13], left_rdata_s7_q[11:0]};
      and_599_s8_q <= or_578_s7_q & (left_rdata_s7_q[70] & not_582_s7_q);
      and_607_s8_q <= (or_578_s7_q & (left_rdata_s7_q[68] & not_582_s7_q)) & and_606;
      x_s8_2_q <= x_s7_2_q;
      select_616_s8_q <= select_616_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_s7_q;
      shift_s8_q <= shift;
      right_s8_q <= right_s7_q;
      and_638_s8_q <= or_578_s7_q & (left_rdata_s7_q[71] & not_582_s7_q);
      right_codes_rdata_s8_q <= {right_codes_rdata_s7_q[84:73], right_codes_rdata_s7_q[71:60], right_codes_rdata_s7_q[56:43], right_codes_rdata_s7_q[41:28], right_codes_rdata_s7_q[26:13], right_codes_rdata_s7_q[11:0]};
      and_643_s8_q <= or_578_s7_q & (right_codes_rdata_s7_q[58] & not_582_s7_q);
      and_645_s8_q <= or_578_s7_q & (right_codes_rdata_s7_q[59] & not_582_s7_q);
      and_649_s8_q <= and_649_s7_q;
      fresh_rdata_s8_q <= fresh_rdata_q;
      equal_678_s8_q <= row_s7_q == 7'h0;
      and_747_s8_q <= left_rdata_s7_q[12] & not_746;
      and_748_s8_q <= left_rdata_s7_q[30] & not_746;
      and_749_s8_q <= left_rdata_s7_q[48] & not_746;
      and_750_s8_q <= left_rdata_s7_q[66] & not_746;
      and_751_s8_q <= right_codes_rdata_s7_q[12] & not_746;
      and_752_s8_q <= right_codes_rdata_s7_q[27] & not_746;
      and_753_s8_q <= right_codes_rdata_s7_q[42] & not_746;
      and_754_s8_q <= right_codes_rdata_s7_q[57] & not_746;
      and_755_s8_q <= right_codes_rdata_s7_q[72] & not_746;
      and_756_s8_q <= right_codes_rdata_s7_q[85] & not_746;
      and_761_s8_q <= and_761;
      select_768_s8_q <= select_768;
      and_784_s8_q <= and_784;
      select_791_s8_q <= select_791;
      and_801_s8_q <= and_801;
      select_808_s8_q <= select_808;
      select_1016_s8_q <= select_1016;
      select_1039_s8_q <= select_1039;
      select_1056_s8_q <= select_1051 ? (~(select_803 ^ select_1053)) : 12'h0;
      select_1269_s8_q <= select_1263 ? (~(select_763 ^ select_1266)) : 12'h0;
      select_1290_s8_q <= select_1290;
      select_1305_s8_q <= select_1305;
      and_1560_s8_q <= and_1560_s7_q;
      equal_1561_s8_q <= equal_1561_s7_q;
      and_1684_s8_q <= and_1684_s7_q;
      right_3_s8_q <= right_3;
      less_1698_s8_q <= 6'h4 < row_q[6:1];
      b_s8_q <= b;
      select_1753_s8_q <= select_1753;
      equal_1783_s8_q <= equal_1783_s7_q;
      not_1784_s8_q <= not_1784;
      equal_1785_s8_q <= equal_1785_s7_q;
      not_1786_s8_q <= not_1786;
      equal_1787_s8_q <= equal_1787_s7_q;
      equal_1788_s8_q <= equal_1788_s7_q;
      or_1789_s8_q <= or_1789_s7_q;
      select_1813_s8_q <= select_1813_s7_q;
      select_1819_s8_q <= select_1819_s7_q;
      and_1846_s8_q <= not_1784 & (not_1786 & and_1844_s7_q);
      select_1857_s8_q <= select_1857_s7_q;
      and_1867_s8_q <= and_1867;
      less_1961_s8_q <= less_1961_s7_q;
      equal_1962_s8_q <= equal_1962_s7_q;
      not_1963_s8_q <= not_1963_s7_q;
      equal_1964_s8_q <= equal_1964_s7_q;
      not_1965_s8_q <= not_1965_s7_q;
      sum_1993_s8_q <= sum_1993_s7_q;
      and_2014_s8_q <= or_578_s7_q & (left_rdata_s7_q[69] & not_582_s7_q);
      and_2131_s8_q <= (7'h6 < row_q) & (~(x_s7_q[7:2] == 6'h0));
      equal_2280_s8_q <= (last_s7_2_q | row_s7_q) == 7'h0;
      equal_2469_s8_q <= equal_2469_s7_q;
      and_2595_s8_q <= not_582_s7_q & and_606;
      select_2727_s8_q <= select_2727;
      select_2729_s8_q <= select_2729;
      further_s8_q <= further;
      or_3043_s8_q <= or_3043_s7_q;
      not_3067_s8_q <= not_3067_s7_q;
      select_3544_s8_q <= less_1961_s7_q ? (not_1963_s7_q & select_3542) : select_3542;
      equal_3546_s8_q <= equal_3546_s7_q;
      less_3872_s8_q <= 6'h2 < row_s7_q[6:1];
      equal_4091_s8_q <= row_s7_q[6:3] == 4'h0;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s8_q + {{2{shift_s8_q[5]}}, shift_s8_q};
  // hls/stages/count_bits.hpp:24
  logic parity_774;
  assign parity_774 = ^select_768_s8_q[5:3];
  logic parity_777;
  assign parity_777 = ^select_768_s8_q[8:6];
  logic parity_780;
  assign parity_780 = ^select_768_s8_q[11:3];
  logic parity_794;
  assign parity_794 = ^select_791_s8_q[8:6];
  logic parity_797;
  assign parity_797 = ^select_791_s8_q[11:9];
  logic parity_814;
  assign parity_814 = ^select_808_s8_q[2:0];
  logic parity_817;
  assign parity_817 = ^select_808_s8_q[5:3];
  logic parity_820;
  assign parity_820 = ^select_808_s8_q[8:0];
  logic parity_826;
  assign parity_826 = ^select_808_s8_q[11:9];
  logic parity_829;
  assign parity_829 = ^select_791_s8_q[2:0];
  logic parity_832;
  assign parity_832 = ^{select_808_s8_q[11:9], select_791_s8_q[5:0]};
  logic parity_835;
  assign parity_835 = ^{select_808_s8_q, select_791_s8_q, select_768_s8_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_840;
  assign or_840 = (select_768_s8_q[1:0] == 2'h3) | (select_768_s8_q[2] & (select_768_s8_q[0] | select_768_s8_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_844;
  assign or_844 = (select_791_s8_q[7:6] == 2'h3) | (select_791_s8_q[8] & (select_791_s8_q[6] | select_791_s8_q[7]));
  logic or_848;
  assign or_848 = (select_791_s8_q[10:9] == 2'h3) | (select_791_s8_q[11] & (select_791_s8_q[9] | select_791_s8_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_856;
  assign or_856 = (select_808_s8_q[7:6] == 2'h3) | (select_808_s8_q[8] & (~(select_808_s8_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_860;
  assign or_860 = (select_808_s8_q[1:0] == 2'h3) | (select_808_s8_q[2] & (select_808_s8_q[0] | select_808_s8_q[1]));
  logic or_864;
  assign or_864 = (select_808_s8_q[4:3] == 2'h3) | (select_808_s8_q[5] & (select_808_s8_q[3] | select_808_s8_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_867;
  assign parity_867 = ^{or_864, or_860, or_856};
  // hls/stages/count_bits.hpp:23
  logic or_871;
  assign or_871 = (select_791_s8_q[4:3] == 2'h3) | (select_791_s8_q[5] & (select_791_s8_q[3] | select_791_s8_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_875;
  assign or_875 = (select_808_s8_q[10:9] == 2'h3) | (select_808_s8_q[11] & (select_808_s8_q[9] | select_808_s8_q[10]));
  logic or_879;
  assign or_879 = (select_791_s8_q[1:0] == 2'h3) | (select_791_s8_q[2] & (select_791_s8_q[0] | select_791_s8_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_882;
  assign parity_882 = ^{or_879, or_875, or_871};
  logic parity_885;
  assign parity_885 = ^{or_879, or_875, or_871, or_864, or_860, or_856, or_848, or_844, or_840};
  // hls/stages/count_bits.hpp:25
  logic or_890;
  assign or_890 = (parity_774 & parity_777) | ((^select_768_s8_q[11:9]) & (parity_774 | parity_777));
  logic and_893;
  assign and_893 = (^{select_791_s8_q[11:6], select_768_s8_q[2:0]}) & (parity_820 | parity_832);
  // hls/stages/count_bits.hpp:23
  logic or_901;
  assign or_901 = (select_768_s8_q[10:9] == 2'h3) | (select_768_s8_q[11] & (select_768_s8_q[9] | select_768_s8_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_905;
  assign or_905 = (select_768_s8_q[4:3] == 2'h3) | (select_768_s8_q[5] & (select_768_s8_q[3] | select_768_s8_q[4]));
  logic or_909;
  assign or_909 = (select_768_s8_q[7:6] == 2'h3) | (select_768_s8_q[8] & (select_768_s8_q[6] | select_768_s8_q[7]));
  logic or_916;
  assign or_916 = (parity_794 & parity_797) | ((^select_768_s8_q[2:0]) & (parity_794 | parity_797));
  logic or_920;
  assign or_920 = (parity_814 & parity_817) | ((^select_808_s8_q[8:6]) & (parity_814 | parity_817));
  logic or_924;
  assign or_924 = (parity_826 & parity_829) | ((^select_791_s8_q[5:3]) & (parity_826 | parity_829));
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1017;
  assign select_1017 = and_761_s8_q ? select_1016_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1023;
  assign parity_1023 = ^select_1017[5:3];
  logic parity_1026;
  assign parity_1026 = ^select_1017[8:6];
  logic parity_1029;
  assign parity_1029 = ^select_1017[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1040;
  assign select_1040 = and_784_s8_q ? select_1039_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1043;
  assign parity_1043 = ^select_1040[8:6];
  logic parity_1046;
  assign parity_1046 = ^select_1040[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1057;
  assign select_1057 = and_801_s8_q ? select_1056_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1063;
  assign parity_1063 = ^select_1057[2:0];
  logic parity_1066;
  assign parity_1066 = ^select_1057[5:3];
  logic parity_1069;
  assign parity_1069 = ^select_1057[8:0];
  logic parity_1075;
  assign parity_1075 = ^select_1057[11:9];
  logic parity_1078;
  assign parity_1078 = ^select_1040[2:0];
  logic parity_1081;
  assign parity_1081 = ^{select_1057[11:9], select_1040[5:0]};
  logic parity_1084;
  assign parity_1084 = ^{select_1057, select_1040, select_1017[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1089;
  assign or_1089 = (select_1017[1:0] == 2'h3) | (select_1017[2] & (select_1017[0] | select_1017[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1093;
  assign or_1093 = (select_1040[7:6] == 2'h3) | (select_1040[8] & (select_1040[6] | select_1040[7]));
  logic or_1097;
  assign or_1097 = (select_1040[10:9] == 2'h3) | (select_1040[11] & (select_1040[9] | select_1040[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1105;
  assign or_1105 = (select_1057[7:6] == 2'h3) | (select_1057[8] & (~(select_1057[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1109;
  assign or_1109 = (select_1057[1:0] == 2'h3) | (select_1057[2] & (select_1057[0] | select_1057[1]));
  logic or_1113;
  assign or_1113 = (select_1057[4:3] == 2'h3) | (select_1057[5] & (select_1057[3] | select_1057[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1116;
  assign parity_1116 = ^{or_1113, or_1109, or_1105};
  // hls/stages/count_bits.hpp:23
  logic or_1120;
  assign or_1120 = (select_1040[4:3] == 2'h3) | (select_1040[5] & (select_1040[3] | select_1040[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1124;
  assign or_1124 = (select_1057[10:9] == 2'h3) | (select_1057[11] & (select_1057[9] | select_1057[10]));
  logic or_1128;
  assign or_1128 = (select_1040[1:0] == 2'h3) | (select_1040[2] & (select_1040[0] | select_1040[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1131;
  assign parity_1131 = ^{or_1128, or_1124, or_1120};
  logic parity_1134;
  assign parity_1134 = ^{or_1128, or_1124, or_1120, or_1113, or_1109, or_1105, or_1097, or_1093, or_1089};
  // hls/stages/count_bits.hpp:25
  logic or_1139;
  assign or_1139 = (parity_1023 & parity_1026) | ((^select_1017[11:9]) & (parity_1023 | parity_1026));
  logic and_1142;
  assign and_1142 = (^{select_1040[11:6], select_1017[2:0]}) & (parity_1069 | parity_1081);
  // hls/stages/count_bits.hpp:23
  logic or_1150;
  assign or_1150 = (select_1017[10:9] == 2'h3) | (select_1017[11] & (select_1017[9] | select_1017[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1154;
  assign or_1154 = (select_1017[4:3] == 2'h3) | (select_1017[5] & (select_1017[3] | select_1017[4]));
  logic or_1158;
  assign or_1158 = (select_1017[7:6] == 2'h3) | (select_1017[8] & (select_1017[6] | select_1017[7]));
  logic or_1165;
  assign or_1165 = (parity_1043 & parity_1046) | ((^select_1017[2:0]) & (parity_1043 | parity_1046));
  logic or_1169;
  assign or_1169 = (parity_1063 & parity_1066) | ((^select_1057[8:6]) & (parity_1063 | parity_1066));
  logic or_1173;
  assign or_1173 = (parity_1075 & parity_1078) | ((^select_1040[5:3]) & (parity_1075 | parity_1078));
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1270;
  assign select_1270 = and_761_s8_q ? select_1269_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1276;
  assign parity_1276 = ^select_1270[5:3];
  logic parity_1279;
  assign parity_1279 = ^select_1270[8:6];
  logic parity_1282;
  assign parity_1282 = ^select_1270[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1291;
  assign select_1291 = and_784_s8_q ? select_1290_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1294;
  assign parity_1294 = ^select_1291[8:6];
  logic parity_1297;
  assign parity_1297 = ^select_1291[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1306;
  assign select_1306 = and_801_s8_q ? select_1305_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1312;
  assign parity_1312 = ^select_1306[2:0];
  logic parity_1315;
  assign parity_1315 = ^select_1306[5:3];
  logic parity_1318;
  assign parity_1318 = ^select_1306[8:0];
  logic parity_1324;
  assign parity_1324 = ^select_1306[11:9];
  logic parity_1327;
  assign parity_1327 = ^select_1291[2:0];
  logic parity_1330;
  assign parity_1330 = ^{select_1306[11:9], select_1291[5:0]};
  logic parity_1333;
  assign parity_1333 = ^{select_1306, select_1291, select_1270[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1338;
  assign or_1338 = (select_1270[1:0] == 2'h3) | (select_1270[2] & (select_1270[0] | select_1270[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1342;
  assign or_1342 = (select_1291[7:6] == 2'h3) | (select_1291[8] & (select_1291[6] | select_1291[7]));
  logic or_1346;
  assign or_1346 = (select_1291[10:9] == 2'h3) | (select_1291[11] & (select_1291[9] | select_1291[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1354;
  assign or_1354 = (select_1306[7:6] == 2'h3) | (select_1306[8] & (~(select_1306[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1358;
  assign or_1358 = (select_1306[1:0] == 2'h3) | (select_1306[2] & (select_1306[0] | select_1306[1]));
  logic or_1362;
  assign or_1362 = (select_1306[4:3] == 2'h3) | (select_1306[5] & (select_1306[3] | select_1306[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1365;
  assign parity_1365 = ^{or_1362, or_1358, or_1354};
  // hls/stages/count_bits.hpp:23
  logic or_1369;
  assign or_1369 = (select_1291[4:3] == 2'h3) | (select_1291[5] & (select_1291[3] | select_1291[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1373;
  assign or_1373 = (select_1306[10:9] == 2'h3) | (select_1306[11] & (select_1306[9] | select_1306[10]));
  logic or_1377;
  assign or_1377 = (select_1291[1:0] == 2'h3) | (select_1291[2] & (select_1291[0] | select_1291[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1380;
  assign parity_1380 = ^{or_1377, or_1373, or_1369};
  logic parity_1383;
  assign parity_1383 = ^{or_1377, or_1373, or_1369, or_1362, or_1358, or_1354, or_1346, or_1342, or_1338};
  // hls/stages/count_bits.hpp:25
  logic or_1388;
  assign or_1388 = (parity_1276 & parity_1279) | ((^select_1270[11:9]) & (parity_1276 | parity_1279));
  logic and_1391;
  assign and_1391 = (^{select_1291[11:6], select_1270[2:0]}) & (parity_1318 | parity_1330);
  // hls/stages/count_bits.hpp:23
  logic or_1399;
  assign or_1399 = (select_1270[10:9] == 2'h3) | (select_1270[11] & (select_1270[9] | select_1270[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1403;
  assign or_1403 = (select_1270[4:3] == 2'h3) | (select_1270[5] & (select_1270[3] | select_1270[4]));
  logic or_1407;
  assign or_1407 = (select_1270[7:6] == 2'h3) | (select_1270[8] & (select_1270[6] | select_1270[7]));
  logic or_1414;
  assign or_1414 = (parity_1294 & parity_1297) | ((^select_1270[2:0]) & (parity_1294 | parity_1297));
  logic or_1418;
  assign or_1418 = (parity_1312 & parity_1315) | ((^select_1306[8:6]) & (parity_1312 | parity_1315));
  logic or_1422;
  assign or_1422 = (parity_1324 & parity_1327) | ((^select_1291[5:3]) & (parity_1324 | parity_1327));
  // hls/stages/agreement.hpp:247
  logic or_1581;
  assign or_1581 = (cfg_nearer_below_i & shift_s8_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s8_q)));
  // hls/stages/agreement.hpp:1009
  logic [5:0] sum_1646;
  assign sum_1646 = {1'b0, last_s8_q[6:2]} + 6'h1;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1727;
  assign sum_1727 = {2'h0, x_s8_q} + {{4{b_s8_q[5]}}, b_s8_q};
  // hls/stages/registration.hpp:213
  logic [9:0] select_1754;
  assign select_1754 = b_s8_q[4] ? select_1753_s8_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1759;
  assign sum_1759 = (b_s8_q[0] ? select_1753_s8_q[13:1] : 13'h0) + (b_s8_q[1] ? select_1753_s8_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1760;
  assign select_1760 = b_s8_q[2] ? select_1753_s8_q[11:0] : 12'h0;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2725;
  assign select_2725 = or_578_s8_q ? (less_581_s8_q ? 8'h0 : best_left_rdata_s8_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2727_s8_q} - {1'b0, select_2729_s8_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2986;
  assign select_2986 = right_3_s8_q ? last_s8_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s8_q} + {1'b0, select_2986};

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:781; read in stage 8, written in stage 20: 8 < 20 < 8 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s8_q, patches_code_row_s8_q[3:0], patches_column_s8_q[3:0]};
`ifndef SYNTHESIS
  logic patches_left_re;
  assign patches_left_re = s8_en & and_1846_s8_q;
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s8_q[6:0];
  logic left_we;
  assign left_we = s8_en & and_649_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_750_s8_q, left_rdata_s8_q[62:46], and_749_s8_q, left_rdata_s8_q[45:29], and_748_s8_q, left_rdata_s8_q[28:12], and_747_s8_q, left_rdata_s8_q[11:0], fresh_rdata_s8_q[30:26], fresh_rdata_s8_q[24], fresh_rdata_s8_q[11:0]};
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
  assign right_codes_we = s8_en & and_649_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_756_s8_q, right_codes_rdata_s8_q[77:66], and_755_s8_q, right_codes_rdata_s8_q[65:54], and_754_s8_q, right_codes_rdata_s8_q[53:40], and_753_s8_q, right_codes_rdata_s8_q[39:26], and_752_s8_q, right_codes_rdata_s8_q[25:12], and_751_s8_q, right_codes_rdata_s8_q[11:0], fresh_rdata_s8_q[32:31], fresh_rdata_s8_q[25], fresh_rdata_s8_q[23:12]};
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
      patches_read_searches_q <= 1'b0;
    end else if (s8_en) begin
      patches_read_searches_q <= equal_1783_s8_q ? select_3544_s8_q : patches_read_searches_q;
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
  logic [3:0] age_s9_q;
  logic [2:0] slot_s9_q;
  logic ends_cell_s9_q;
  logic lower_half_s9_q;
  logic shift_first_s9_q;
  logic [11:0] registration_slope_s9_q;
  logic [4:0] patches_band_rows_number_s9_q;
  logic patches_chooses_s9_q;
  logic [4:0] patches_choosing_band_s9_q;
  logic patches_lower_s9_q;
  logic patches_second_s9_q;
  logic [4:0] patches_code_row_s9_q;
  logic [4:0] patches_column_s9_q;
  logic [4:0] patches_step_s9_q;
  logic patches_read_searches_s9_q;
  logic [3:0] select_507_s9_q;
  logic equal_508_s9_q;
  logic row_starts_s9_q;
  logic [8:0] select_512_s9_q;
  logic and_521_s9_q;
  logic equal_527_s9_q;
  logic [6:0] select_542_s9_q;
  logic [6:0] last_s9_q;
  logic and_546_s9_q;
  logic and_548_s9_q;
  logic equal_567_s9_q;
  logic equal_573_s9_q;
  logic so_s9_q;
  logic equal_577_s9_q;
  logic or_578_s9_q;
  logic less_581_s9_q;
  logic not_582_s9_q;
  logic equal_592_s9_q;
  logic and_599_s9_q;
  logic and_607_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_616_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic [6:0] select_625_s9_q;
  logic [6:0] right_s9_q;
  logic and_638_s9_q;
  logic and_643_s9_q;
  logic and_645_s9_q;
  logic equal_678_s9_q;
  logic xor_836_s9_q;
  logic parity_885_s9_q;
  logic and_886_s9_q;
  logic or_890_s9_q;
  logic or_894_s9_q;
  logic or_901_s9_q;
  logic or_905_s9_q;
  logic or_909_s9_q;
  logic or_916_s9_q;
  logic or_920_s9_q;
  logic or_924_s9_q;
  logic and_933_s9_q;
  logic and_935_s9_q;
  logic or_947_s9_q;
  logic or_951_s9_q;
  logic or_955_s9_q;
  logic xor_1085_s9_q;
  logic parity_1100_s9_q;
  logic parity_1134_s9_q;
  logic and_1135_s9_q;
  logic or_1139_s9_q;
  logic or_1143_s9_q;
  logic or_1150_s9_q;
  logic or_1154_s9_q;
  logic or_1158_s9_q;
  logic or_1165_s9_q;
  logic or_1169_s9_q;
  logic or_1173_s9_q;
  logic and_1182_s9_q;
  logic or_1183_s9_q;
  logic or_1196_s9_q;
  logic or_1200_s9_q;
  logic or_1204_s9_q;
  logic xor_1334_s9_q;
  logic parity_1349_s9_q;
  logic parity_1383_s9_q;
  logic and_1384_s9_q;
  logic or_1388_s9_q;
  logic or_1392_s9_q;
  logic or_1399_s9_q;
  logic or_1403_s9_q;
  logic or_1407_s9_q;
  logic or_1414_s9_q;
  logic or_1418_s9_q;
  logic or_1422_s9_q;
  logic and_1431_s9_q;
  logic or_1432_s9_q;
  logic or_1445_s9_q;
  logic or_1449_s9_q;
  logic or_1453_s9_q;
  logic and_1560_s9_q;
  logic equal_1561_s9_q;
  logic or_1581_s9_q;
  logic less_1647_s9_q;
  logic and_1684_s9_q;
  logic right_3_s9_q;
  logic less_1698_s9_q;
  logic [5:0] b_s9_q;
  logic less_1719_s9_q;
  logic not_1723_s9_q;
  logic less_1728_s9_q;
  logic less_1729_s9_q;
  logic select_1754_s9_q;
  logic [8:0] difference_1756_s9_q;
  logic [11:0] sum_1759_s9_q;
  logic select_1760_s9_q;
  logic [10:0] sum_1762_s9_q;
  logic equal_1776_s9_q;
  logic equal_1783_s9_q;
  logic not_1784_s9_q;
  logic equal_1785_s9_q;
  logic not_1786_s9_q;
  logic equal_1787_s9_q;
  logic equal_1788_s9_q;
  logic or_1789_s9_q;
  logic [7:0] patches_right_0_rdata_s9_q;
  logic [4:0] select_1813_s9_q;
  logic select_1819_s9_q;
  logic [7:0] patches_right_1_rdata_s9_q;
  logic [3:0] select_1857_s9_q;
  logic and_1867_s9_q;
  logic [31:0] patches_columns_above_rdata_s9_q;
  logic less_1961_s9_q;
  logic equal_1962_s9_q;
  logic not_1963_s9_q;
  logic equal_1964_s9_q;
  logic not_1965_s9_q;
  logic [14:0] patches_rows_rdata_s9_q;
  logic sum_1993_s9_q;
  logic and_2014_s9_q;
  logic and_2134_s9_q;
  logic equal_2280_s9_q;
  logic equal_2469_s9_q;
  logic and_2596_s9_q;
  logic equal_2681_s9_q;
  logic [7:0] select_2725_s9_q;
  logic rise_2_s9_q;
  logic [7:0] select_2731_s9_q;
  logic [7:0] xor_2736_s9_q;
  logic less_2762_s9_q;
  logic not_2989_s9_q;
  logic or_3043_s9_q;
  logic not_3067_s9_q;
  logic equal_3546_s9_q;
  logic less_3872_s9_q;
  logic equal_4091_s9_q;
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
      age_s9_q <= age_s8_q;
      slot_s9_q <= slot_s8_q;
      ends_cell_s9_q <= ends_cell_s8_q;
      lower_half_s9_q <= lower_half_s8_q;
      shift_first_s9_q <= shift_first_s8_q;
      registration_slope_s9_q <= registration_slope_s8_q;
      patches_band_rows_number_s9_q <= patches_band_rows_number_s8_q;
      patches_chooses_s9_q <= patches_chooses_s8_q;
      patches_choosing_band_s9_q <= patches_choosing_band_s8_q;
      patches_lower_s9_q <= patches_lower_s8_q;
      patches_second_s9_q <= patches_second_s8_q;
      patches_code_row_s9_q <= patches_code_row_s8_q;
      patches_column_s9_q <= patches_column_s8_q;
      patches_step_s9_q <= patches_step_s8_q;
      patches_read_searches_s9_q <= patches_read_searches_q;
      select_507_s9_q <= select_507_s8_q;
      equal_508_s9_q <= equal_508_s8_q;
      row_starts_s9_q <= row_starts_s8_q;
      select_512_s9_q <= select_512_s8_q;
      and_521_s9_q <= and_521_s8_q;
      equal_527_s9_q <= equal_527_s8_q;
      select_542_s9_q <= select_542_s8_q;
      last_s9_q <= last_s8_2_q;
      and_546_s9_q <= and_546_s8_q;
      and_548_s9_q <= and_548_s8_q;
      equal_567_s9_q <= equal_567_s8_q;
      equal_573_s9_q <= equal_573_s8_q;
      so_s9_q <= so_s8_q;
      equal_577_s9_q <= equal_577_s8_q;
      or_578_s9_q <= or_578_s8_q;
      less_581_s9_q <= less_581_s8_q;
      not_582_s9_q <= not_582_s8_q;
      equal_592_s9_q <= equal_592_s8_q;
      and_599_s9_q <= and_599_s8_q;
      and_607_s9_q <= and_607_s8_q;
      x_s9_2_q <= x_s8_2_q;
      select_616_s9_q <= select_616_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_625_s9_q <= ({1'b0, last_s8_q} < found) ? 7'h0 : found[6:0];
      right_s9_q <= right_s8_q;
      and_638_s9_q <= and_638_s8_q;
      and_643_s9_q <= and_643_s8_q;
      and_645_s9_q <= and_645_s8_q;
      equal_678_s9_q <= equal_678_s8_q;
      xor_836_s9_q <= parity_780 ^ parity_835;
      parity_885_s9_q <= parity_885;
      and_886_s9_q <= parity_780 & parity_835;
      or_890_s9_q <= or_890;
      or_894_s9_q <= (parity_820 & parity_832) | and_893;
      or_901_s9_q <= or_901;
      or_905_s9_q <= or_905;
      or_909_s9_q <= or_909;
      or_916_s9_q <= or_916;
      or_920_s9_q <= or_920;
      or_924_s9_q <= or_924;
      and_933_s9_q <= parity_867 & parity_882;
      and_935_s9_q <= (^{or_848, or_844, or_840}) & (parity_867 | parity_882);
      or_947_s9_q <= (or_844 & or_848) | (or_840 & (or_844 | or_848));
      or_951_s9_q <= (or_860 & or_864) | (or_856 & (or_860 | or_864));
      or_955_s9_q <= (or_875 & or_879) | (or_871 & (or_875 | or_879));
      xor_1085_s9_q <= parity_1029 ^ parity_1084;
      parity_1100_s9_q <= ^{or_1097, or_1093, or_1089};
      parity_1134_s9_q <= parity_1134;
      and_1135_s9_q <= parity_1029 & parity_1084;
      or_1139_s9_q <= or_1139;
      or_1143_s9_q <= (parity_1069 & parity_1081) | and_1142;
      or_1150_s9_q <= or_1150;
      or_1154_s9_q <= or_1154;
      or_1158_s9_q <= or_1158;
      or_1165_s9_q <= or_1165;
      or_1169_s9_q <= or_1169;
      or_1173_s9_q <= or_1173;
      and_1182_s9_q <= parity_1116 & parity_1131;
      or_1183_s9_q <= parity_1116 | parity_1131;
      or_1196_s9_q <= (or_1093 & or_1097) | (or_1089 & (or_1093 | or_1097));
      or_1200_s9_q <= (or_1109 & or_1113) | (or_1105 & (or_1109 | or_1113));
      or_1204_s9_q <= (or_1124 & or_1128) | (or_1120 & (or_1124 | or_1128));
      xor_1334_s9_q <= parity_1282 ^ parity_1333;
      parity_1349_s9_q <= ^{or_1346, or_1342, or_1338};
      parity_1383_s9_q <= parity_1383;
      and_1384_s9_q <= parity_1282 & parity_1333;
      or_1388_s9_q <= or_1388;
      or_1392_s9_q <= (parity_1318 & parity_1330) | and_1391;
      or_1399_s9_q <= or_1399;
      or_1403_s9_q <= or_1403;
      or_1407_s9_q <= or_1407;
      or_1414_s9_q <= or_1414;
      or_1418_s9_q <= or_1418;
      or_1422_s9_q <= or_1422;
      and_1431_s9_q <= parity_1365 & parity_1380;
      or_1432_s9_q <= parity_1365 | parity_1380;
      or_1445_s9_q <= (or_1342 & or_1346) | (or_1338 & (or_1342 | or_1346));
      or_1449_s9_q <= (or_1358 & or_1362) | (or_1354 & (or_1358 | or_1362));
      or_1453_s9_q <= (or_1373 & or_1377) | (or_1369 & (or_1373 | or_1377));
      and_1560_s9_q <= and_1560_s8_q;
      equal_1561_s9_q <= equal_1561_s8_q;
      or_1581_s9_q <= or_1581;
      less_1647_s9_q <= {1'b0, sum_1646, last_s8_q[1]} < x_s8_q;
      and_1684_s9_q <= and_1684_s8_q;
      right_3_s9_q <= right_3_s8_q;
      less_1698_s9_q <= less_1698_s8_q;
      b_s9_q <= b_s8_q;
      less_1719_s9_q <= {3'h0, last_s8_q[6:1]} < ({1'b0, x_s8_q} + 9'h1);
      not_1723_s9_q <= ~(x_s8_q < {1'b0, last_s8_q});
      less_1728_s9_q <= $signed(10'h0) < $signed(sum_1727);
      less_1729_s9_q <= $signed(sum_1727) < $signed({3'h0, last_s8_q});
      select_1754_s9_q <= select_1754[0];
      difference_1756_s9_q <= select_1754[9:1] - (b_s8_q[5] ? select_1753_s8_q[8:0] : 9'h0);
      sum_1759_s9_q <= sum_1759[12:1];
      select_1760_s9_q <= select_1760[0];
      sum_1762_s9_q <= select_1760[11:1] + (b_s8_q[3] ? select_1753_s8_q[10:0] : 11'h0);
      equal_1776_s9_q <= x_s8_q == {1'b0, last_s8_q};
      equal_1783_s9_q <= equal_1783_s8_q;
      not_1784_s9_q <= not_1784_s8_q;
      equal_1785_s9_q <= equal_1785_s8_q;
      not_1786_s9_q <= not_1786_s8_q;
      equal_1787_s9_q <= equal_1787_s8_q;
      equal_1788_s9_q <= equal_1788_s8_q;
      or_1789_s9_q <= or_1789_s8_q;
      patches_right_0_rdata_s9_q <= patches_right_0_rdata_q;
      select_1813_s9_q <= select_1813_s8_q;
      select_1819_s9_q <= select_1819_s8_q;
      patches_right_1_rdata_s9_q <= patches_right_1_rdata_q;
      select_1857_s9_q <= select_1857_s8_q;
      and_1867_s9_q <= and_1867_s8_q;
      patches_columns_above_rdata_s9_q <= patches_columns_above_rdata_q;
      less_1961_s9_q <= less_1961_s8_q;
      equal_1962_s9_q <= equal_1962_s8_q;
      not_1963_s9_q <= not_1963_s8_q;
      equal_1964_s9_q <= equal_1964_s8_q;
      not_1965_s9_q <= not_1965_s8_q;
      patches_rows_rdata_s9_q <= patches_rows_rdata_q;
      sum_1993_s9_q <= sum_1993_s8_q;
      and_2014_s9_q <= and_2014_s8_q;
      and_2134_s9_q <= and_2131_s8_q & (~({sum_1646, last_s8_q[1:0]} < x_s8_q));
      equal_2280_s9_q <= equal_2280_s8_q;
      equal_2469_s9_q <= equal_2469_s8_q;
      and_2596_s9_q <= or_578_s8_q & and_2595_s8_q;
      equal_2681_s9_q <= shift_s8_q == 6'h0;
      select_2725_s9_q <= select_2725;
      rise_2_s9_q <= rise_2[8];
      select_2731_s9_q <= rise_2[8] ? select_2727_s8_q : select_2729_s8_q;
      xor_2736_s9_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2762_s9_q <= select_2727_s8_q < select_2729_s8_q;
      not_2989_s9_q <= ~(x_s8_q < {1'b0, from});
      or_3043_s9_q <= or_3043_s8_q;
      not_3067_s9_q <= not_3067_s8_q;
      equal_3546_s9_q <= equal_3546_s8_q;
      less_3872_s9_q <= less_3872_s8_q;
      equal_4091_s9_q <= equal_4091_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/patches.hpp:106
  logic equal_568;
  assign equal_568 = x_s9_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_567_s9_q & equal_568;
  // hls/stages/count_bits.hpp:24
  logic parity_912;
  assign parity_912 = ^{or_909_s9_q, or_905_s9_q, or_901_s9_q};
  logic parity_927;
  assign parity_927 = ^{or_924_s9_q, or_920_s9_q, or_916_s9_q};
  logic parity_930;
  assign parity_930 = ^{or_924_s9_q, or_920_s9_q, or_916_s9_q, or_909_s9_q, or_905_s9_q, or_901_s9_q, or_894_s9_q, or_890_s9_q, and_886_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_932;
  assign and_932 = parity_885_s9_q & parity_930;
  logic or_936;
  assign or_936 = and_933_s9_q | and_935_s9_q;
  logic and_939;
  assign and_939 = (^{or_894_s9_q, or_890_s9_q, and_886_s9_q}) & (parity_912 | parity_927);
  logic or_940;
  assign or_940 = (parity_912 & parity_927) | and_939;
  // hls/stages/count_bits.hpp:24
  logic parity_958;
  assign parity_958 = ^{or_955_s9_q, or_951_s9_q, or_947_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_962;
  assign or_962 = (or_890_s9_q & or_894_s9_q) | (and_886_s9_q & (or_890_s9_q | or_894_s9_q));
  logic or_966;
  assign or_966 = (or_905_s9_q & or_909_s9_q) | (or_901_s9_q & (or_905_s9_q | or_909_s9_q));
  logic or_970;
  assign or_970 = (or_920_s9_q & or_924_s9_q) | (or_916_s9_q & (or_920_s9_q | or_924_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_973;
  assign parity_973 = ^{or_970, or_966, or_962};
  logic parity_976;
  assign parity_976 = ^{or_970, or_966, or_962, or_955_s9_q, or_951_s9_q, or_947_s9_q, or_940, or_936, and_932};
  // hls/stages/count_bits.hpp:25
  logic or_988;
  assign or_988 = (or_951_s9_q & or_955_s9_q) | (or_947_s9_q & (or_951_s9_q | or_955_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1161;
  assign parity_1161 = ^{or_1158_s9_q, or_1154_s9_q, or_1150_s9_q};
  logic parity_1176;
  assign parity_1176 = ^{or_1173_s9_q, or_1169_s9_q, or_1165_s9_q};
  logic parity_1179;
  assign parity_1179 = ^{or_1173_s9_q, or_1169_s9_q, or_1165_s9_q, or_1158_s9_q, or_1154_s9_q, or_1150_s9_q, or_1143_s9_q, or_1139_s9_q, and_1135_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1181;
  assign and_1181 = parity_1134_s9_q & parity_1179;
  logic or_1185;
  assign or_1185 = and_1182_s9_q | (parity_1100_s9_q & or_1183_s9_q);
  logic and_1188;
  assign and_1188 = (^{or_1143_s9_q, or_1139_s9_q, and_1135_s9_q}) & (parity_1161 | parity_1176);
  logic or_1189;
  assign or_1189 = (parity_1161 & parity_1176) | and_1188;
  // hls/stages/count_bits.hpp:24
  logic parity_1207;
  assign parity_1207 = ^{or_1204_s9_q, or_1200_s9_q, or_1196_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1211;
  assign or_1211 = (or_1139_s9_q & or_1143_s9_q) | (and_1135_s9_q & (or_1139_s9_q | or_1143_s9_q));
  logic or_1215;
  assign or_1215 = (or_1154_s9_q & or_1158_s9_q) | (or_1150_s9_q & (or_1154_s9_q | or_1158_s9_q));
  logic or_1219;
  assign or_1219 = (or_1169_s9_q & or_1173_s9_q) | (or_1165_s9_q & (or_1169_s9_q | or_1173_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1222;
  assign parity_1222 = ^{or_1219, or_1215, or_1211};
  logic parity_1225;
  assign parity_1225 = ^{or_1219, or_1215, or_1211, or_1204_s9_q, or_1200_s9_q, or_1196_s9_q, or_1189, or_1185, and_1181};
  // hls/stages/count_bits.hpp:25
  logic or_1237;
  assign or_1237 = (or_1200_s9_q & or_1204_s9_q) | (or_1196_s9_q & (or_1200_s9_q | or_1204_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1410;
  assign parity_1410 = ^{or_1407_s9_q, or_1403_s9_q, or_1399_s9_q};
  logic parity_1425;
  assign parity_1425 = ^{or_1422_s9_q, or_1418_s9_q, or_1414_s9_q};
  logic parity_1428;
  assign parity_1428 = ^{or_1422_s9_q, or_1418_s9_q, or_1414_s9_q, or_1407_s9_q, or_1403_s9_q, or_1399_s9_q, or_1392_s9_q, or_1388_s9_q, and_1384_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1430;
  assign and_1430 = parity_1383_s9_q & parity_1428;
  logic or_1434;
  assign or_1434 = and_1431_s9_q | (parity_1349_s9_q & or_1432_s9_q);
  logic and_1437;
  assign and_1437 = (^{or_1392_s9_q, or_1388_s9_q, and_1384_s9_q}) & (parity_1410 | parity_1425);
  logic or_1438;
  assign or_1438 = (parity_1410 & parity_1425) | and_1437;
  // hls/stages/count_bits.hpp:24
  logic parity_1456;
  assign parity_1456 = ^{or_1453_s9_q, or_1449_s9_q, or_1445_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1460;
  assign or_1460 = (or_1388_s9_q & or_1392_s9_q) | (and_1384_s9_q & (or_1388_s9_q | or_1392_s9_q));
  logic or_1464;
  assign or_1464 = (or_1403_s9_q & or_1407_s9_q) | (or_1399_s9_q & (or_1403_s9_q | or_1407_s9_q));
  logic or_1468;
  assign or_1468 = (or_1418_s9_q & or_1422_s9_q) | (or_1414_s9_q & (or_1418_s9_q | or_1422_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1471;
  assign parity_1471 = ^{or_1468, or_1464, or_1460};
  logic parity_1474;
  assign parity_1474 = ^{or_1468, or_1464, or_1460, or_1453_s9_q, or_1449_s9_q, or_1445_s9_q, or_1438, or_1434, and_1430};
  // hls/stages/count_bits.hpp:25
  logic or_1486;
  assign or_1486 = (or_1449_s9_q & or_1453_s9_q) | (or_1445_s9_q & (or_1449_s9_q | or_1453_s9_q));
  // hls/stages/patches.hpp:104
  logic and_1721;
  assign and_1721 = less_1719_s9_q & (~right_3_s9_q);
  // hls/stages/agreement.hpp:1018
  logic and_1731;
  assign and_1731 = (~(and_1721 | (equal_568 | not_1723_s9_q))) & (less_1728_s9_q & less_1729_s9_q);
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1763;
  assign sum_1763 = sum_1759_s9_q + {sum_1762_s9_q, select_1760_s9_q};
  logic [9:0] sum_1764;
  assign sum_1764 = {difference_1756_s9_q, select_1754_s9_q} + sum_1763[11:2];
  // hls/stages/patches.hpp:173
  logic [7:0] pixel;
  assign pixel = equal_1788_s9_q ? (patches_second_s9_q ? 8'h0 : patches_right_0_rdata_s9_q) : 8'h0;
  // hls/stages/patches.hpp:468
  logic [8:0] sum_1914;
  assign sum_1914 = {1'b0, patches_columns_above_rdata_s9_q[23:16]} + {3'h0, patches_columns_above_rdata_s9_q[31:26]};
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2725_s9_q} - {1'b0, select_2731_s9_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s9_q} + {1'b0, xor_2736_s9_q};
  // hls/stages/patches.hpp:557
  logic [9:0] select_3509;
  assign select_3509 = less_1961_s9_q ? patches_rows_rdata_s9_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3512;
  assign select_3512 = equal_1964_s9_q ? (less_1961_s9_q ? (equal_1964_s9_q ? 10'h0 : select_3509) : 10'h0) : select_3509;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3516;
  assign select_3516 = less_1961_s9_q ? patches_rows_rdata_s9_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3519;
  assign select_3519 = equal_1964_s9_q ? (less_1961_s9_q ? (equal_1964_s9_q ? 5'h0 : select_3516) : 5'h0) : select_3516;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1376; read in stage 9, written in stage 16: 9 < 16 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_578_s9_q ? select_625_s9_q : right_s9_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s9_en & select_616_s9_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
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
  logic patches_read_searches_s10_q;
  logic [3:0] select_507_s10_q;
  logic equal_508_s10_q;
  logic row_starts_s10_q;
  logic [8:0] select_512_s10_q;
  logic and_521_s10_q;
  logic equal_527_s10_q;
  logic [6:0] select_542_s10_q;
  logic [6:0] last_s10_q;
  logic and_546_s10_q;
  logic and_548_s10_q;
  logic equal_568_s10_q;
  logic first_s10_q;
  logic equal_573_s10_q;
  logic so_s10_q;
  logic equal_577_s10_q;
  logic or_578_s10_q;
  logic less_581_s10_q;
  logic not_582_s10_q;
  logic equal_592_s10_q;
  logic and_599_s10_q;
  logic and_607_s10_q;
  logic [6:0] x_s10_2_q;
  logic [61:0] best_left_rdata_s10_q;
  logic [6:0] select_625_s10_q;
  logic [6:0] right_s10_q;
  logic and_638_s10_q;
  logic and_643_s10_q;
  logic and_645_s10_q;
  logic equal_678_s10_q;
  logic xor_836_s10_q;
  logic xor_931_s10_q;
  logic parity_976_s10_q;
  logic and_977_s10_q;
  logic and_979_s10_q;
  logic and_981_s10_q;
  logic and_983_s10_q;
  logic or_988_s10_q;
  logic or_992_s10_q;
  logic xor_1085_s10_q;
  logic xor_1180_s10_q;
  logic parity_1225_s10_q;
  logic and_1226_s10_q;
  logic and_1228_s10_q;
  logic and_1230_s10_q;
  logic and_1232_s10_q;
  logic or_1237_s10_q;
  logic or_1241_s10_q;
  logic xor_1334_s10_q;
  logic xor_1429_s10_q;
  logic parity_1474_s10_q;
  logic and_1475_s10_q;
  logic and_1477_s10_q;
  logic and_1479_s10_q;
  logic and_1481_s10_q;
  logic or_1486_s10_q;
  logic or_1490_s10_q;
  logic and_1560_s10_q;
  logic equal_1561_s10_q;
  logic or_1581_s10_q;
  logic less_1647_s10_q;
  logic and_1684_s10_q;
  logic right_3_s10_q;
  logic less_1698_s10_q;
  logic [5:0] b_s10_q;
  logic and_1731_s10_q;
  logic [7:0] sum_1764_s10_q;
  logic equal_1776_s10_q;
  logic or_1777_s10_q;
  logic equal_1783_s10_q;
  logic not_1784_s10_q;
  logic equal_1785_s10_q;
  logic not_1786_s10_q;
  logic equal_1787_s10_q;
  logic equal_1788_s10_q;
  logic or_1789_s10_q;
  logic [4:0] select_1813_s10_q;
  logic select_1819_s10_q;
  logic [7:0] patches_left_rdata_s10_q;
  logic [3:0] select_1857_s10_q;
  logic and_1867_s10_q;
  logic [31:0] patches_columns_above_rdata_s10_q;
  logic [7:0] select_1871_s10_q;
  logic [8:0] sum_1914_s10_q;
  logic less_1961_s10_q;
  logic equal_1962_s10_q;
  logic not_1963_s10_q;
  logic equal_1964_s10_q;
  logic not_1965_s10_q;
  logic [9:0] patches_rows_rdata_s10_q;
  logic sum_1993_s10_q;
  logic and_2014_s10_q;
  logic and_2136_s10_q;
  logic equal_2280_s10_q;
  logic equal_2469_s10_q;
  logic and_2596_s10_q;
  logic equal_2681_s10_q;
  logic [7:0] wide_s10_q;
  logic [8:0] size_3_s10_q;
  logic less_2762_s10_q;
  logic not_2989_s10_q;
  logic or_3043_s10_q;
  logic not_3067_s10_q;
  logic [9:0] select_3512_s10_q;
  logic [4:0] select_3519_s10_q;
  logic equal_3546_s10_q;
  logic less_3872_s10_q;
  logic equal_4091_s10_q;
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
      age_s10_q <= age_s9_q;
      slot_s10_q <= slot_s9_q;
      ends_cell_s10_q <= ends_cell_s9_q;
      lower_half_s10_q <= lower_half_s9_q;
      shift_first_s10_q <= shift_first_s9_q;
      registration_slope_s10_q <= registration_slope_s9_q;
      patches_band_rows_number_s10_q <= patches_band_rows_number_s9_q;
      patches_chooses_s10_q <= patches_chooses_s9_q;
      patches_choosing_band_s10_q <= patches_choosing_band_s9_q;
      patches_lower_s10_q <= patches_lower_s9_q;
      patches_second_s10_q <= patches_second_s9_q;
      patches_code_row_s10_q <= patches_code_row_s9_q;
      patches_column_s10_q <= patches_column_s9_q;
      patches_step_s10_q <= patches_step_s9_q;
      patches_read_searches_s10_q <= patches_read_searches_s9_q;
      select_507_s10_q <= select_507_s9_q;
      equal_508_s10_q <= equal_508_s9_q;
      row_starts_s10_q <= row_starts_s9_q;
      select_512_s10_q <= select_512_s9_q;
      and_521_s10_q <= and_521_s9_q;
      equal_527_s10_q <= equal_527_s9_q;
      select_542_s10_q <= select_542_s9_q;
      last_s10_q <= last_s9_q;
      and_546_s10_q <= and_546_s9_q;
      and_548_s10_q <= and_548_s9_q;
      equal_568_s10_q <= equal_568;
      first_s10_q <= first;
      equal_573_s10_q <= equal_573_s9_q;
      so_s10_q <= so_s9_q;
      equal_577_s10_q <= equal_577_s9_q;
      or_578_s10_q <= or_578_s9_q;
      less_581_s10_q <= less_581_s9_q;
      not_582_s10_q <= not_582_s9_q;
      equal_592_s10_q <= equal_592_s9_q;
      and_599_s10_q <= and_599_s9_q;
      and_607_s10_q <= and_607_s9_q;
      x_s10_2_q <= x_s9_2_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_625_s10_q <= select_625_s9_q;
      right_s10_q <= right_s9_q;
      and_638_s10_q <= and_638_s9_q;
      and_643_s10_q <= and_643_s9_q;
      and_645_s10_q <= and_645_s9_q;
      equal_678_s10_q <= equal_678_s9_q;
      xor_836_s10_q <= xor_836_s9_q;
      xor_931_s10_q <= parity_885_s9_q ^ parity_930;
      parity_976_s10_q <= parity_976;
      and_977_s10_q <= parity_958 & parity_973;
      and_979_s10_q <= (^{or_940, or_936, and_932}) & (parity_958 | parity_973);
      and_981_s10_q <= or_936 & or_940;
      and_983_s10_q <= and_932 & (or_936 | or_940);
      or_988_s10_q <= or_988;
      or_992_s10_q <= (or_966 & or_970) | (or_962 & (or_966 | or_970));
      xor_1085_s10_q <= xor_1085_s9_q;
      xor_1180_s10_q <= parity_1134_s9_q ^ parity_1179;
      parity_1225_s10_q <= parity_1225;
      and_1226_s10_q <= parity_1207 & parity_1222;
      and_1228_s10_q <= (^{or_1189, or_1185, and_1181}) & (parity_1207 | parity_1222);
      and_1230_s10_q <= or_1185 & or_1189;
      and_1232_s10_q <= and_1181 & (or_1185 | or_1189);
      or_1237_s10_q <= or_1237;
      or_1241_s10_q <= (or_1215 & or_1219) | (or_1211 & (or_1215 | or_1219));
      xor_1334_s10_q <= xor_1334_s9_q;
      xor_1429_s10_q <= parity_1383_s9_q ^ parity_1428;
      parity_1474_s10_q <= parity_1474;
      and_1475_s10_q <= parity_1456 & parity_1471;
      and_1477_s10_q <= (^{or_1438, or_1434, and_1430}) & (parity_1456 | parity_1471);
      and_1479_s10_q <= or_1434 & or_1438;
      and_1481_s10_q <= and_1430 & (or_1434 | or_1438);
      or_1486_s10_q <= or_1486;
      or_1490_s10_q <= (or_1464 & or_1468) | (or_1460 & (or_1464 | or_1468));
      and_1560_s10_q <= and_1560_s9_q;
      equal_1561_s10_q <= equal_1561_s9_q;
      or_1581_s10_q <= or_1581_s9_q;
      less_1647_s10_q <= less_1647_s9_q;
      and_1684_s10_q <= and_1684_s9_q;
      right_3_s10_q <= right_3_s9_q;
      less_1698_s10_q <= less_1698_s9_q;
      b_s10_q <= b_s9_q;
      and_1731_s10_q <= and_1731;
      sum_1764_s10_q <= sum_1764[9:2];
      equal_1776_s10_q <= equal_1776_s9_q;
      or_1777_s10_q <= and_1721 | equal_1776_s9_q;
      equal_1783_s10_q <= equal_1783_s9_q;
      not_1784_s10_q <= not_1784_s9_q;
      equal_1785_s10_q <= equal_1785_s9_q;
      not_1786_s10_q <= not_1786_s9_q;
      equal_1787_s10_q <= equal_1787_s9_q;
      equal_1788_s10_q <= equal_1788_s9_q;
      or_1789_s10_q <= or_1789_s9_q;
      select_1813_s10_q <= select_1813_s9_q;
      select_1819_s10_q <= select_1819_s9_q;
      patches_left_rdata_s10_q <= patches_left_rdata_q;
      select_1857_s10_q <= select_1857_s9_q;
      and_1867_s10_q <= and_1867_s9_q;
      patches_columns_above_rdata_s10_q <= patches_columns_above_rdata_s9_q;
      select_1871_s10_q <= patches_second_s9_q ? patches_right_1_rdata_s9_q : pixel;
      sum_1914_s10_q <= sum_1914;
      less_1961_s10_q <= less_1961_s9_q;
      equal_1962_s10_q <= equal_1962_s9_q;
      not_1963_s10_q <= not_1963_s9_q;
      equal_1964_s10_q <= equal_1964_s9_q;
      not_1965_s10_q <= not_1965_s9_q;
      patches_rows_rdata_s10_q <= patches_rows_rdata_s9_q[9:0];
      sum_1993_s10_q <= sum_1993_s9_q;
      and_2014_s10_q <= and_2014_s9_q;
      and_2136_s10_q <= so_s9_q & (ends_cell_s9_q & and_2134_s9_q);
      equal_2280_s10_q <= equal_2280_s9_q;
      equal_2469_s10_q <= equal_2469_s9_q;
      and_2596_s10_q <= and_2596_s9_q;
      equal_2681_s10_q <= equal_2681_s9_q;
      wide_s10_q <= wide;
      size_3_s10_q <= size_3;
      less_2762_s10_q <= less_2762_s9_q;
      not_2989_s10_q <= not_2989_s9_q;
      or_3043_s10_q <= or_3043_s9_q;
      not_3067_s10_q <= not_3067_s9_q;
      select_3512_s10_q <= select_3512;
      select_3519_s10_q <= select_3519;
      equal_3546_s10_q <= equal_3546_s9_q;
      less_3872_s10_q <= less_3872_s9_q;
      equal_4091_s10_q <= equal_4091_s9_q;
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
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_578_s10_q & not_582_s10_q;
  // hls/stages/count_bits.hpp:25
  logic or_980;
  assign or_980 = and_977_s10_q | and_979_s10_q;
  logic or_984;
  assign or_984 = and_981_s10_q | and_983_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_997;
  assign parity_997 = ^{or_992_s10_q, or_988_s10_q, or_984, or_980};
  // hls/stages/count_bits.hpp:25
  logic or_1001;
  assign or_1001 = (or_988_s10_q & or_992_s10_q) | (or_984 & (or_988_s10_q | or_992_s10_q));
  logic and_1002;
  assign and_1002 = or_980 & (^{or_992_s10_q, or_988_s10_q, or_984});
  // hls/stages/count_bits.hpp:24
  logic xor_1003;
  assign xor_1003 = or_1001 ^ and_1002;
  // hls/stages/count_bits.hpp:27
  logic and_1004;
  assign and_1004 = or_1001 & and_1002;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1005;
  assign select_1005 = equal_592_s10_q ? {and_1004, xor_1003, parity_997, parity_976_s10_q, xor_931_s10_q, xor_836_s10_q} : 6'h0;
  logic [5:0] column;
  assign column = or_578_s10_q ? 6'h0 : select_1005;
  // hls/stages/count_bits.hpp:25
  logic or_1229;
  assign or_1229 = and_1226_s10_q | and_1228_s10_q;
  logic or_1233;
  assign or_1233 = and_1230_s10_q | and_1232_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1246;
  assign parity_1246 = ^{or_1241_s10_q, or_1237_s10_q, or_1233, or_1229};
  // hls/stages/count_bits.hpp:25
  logic or_1250;
  assign or_1250 = (or_1237_s10_q & or_1241_s10_q) | (or_1233 & (or_1237_s10_q | or_1241_s10_q));
  logic and_1251;
  assign and_1251 = or_1229 & (^{or_1241_s10_q, or_1237_s10_q, or_1233});
  // hls/stages/count_bits.hpp:24
  logic xor_1252;
  assign xor_1252 = or_1250 ^ and_1251;
  // hls/stages/count_bits.hpp:27
  logic and_1253;
  assign and_1253 = or_1250 & and_1251;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1254;
  assign select_1254 = equal_592_s10_q ? {and_1253, xor_1252, parity_1246, parity_1225_s10_q, xor_1180_s10_q, xor_1085_s10_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_578_s10_q ? 6'h0 : select_1254;
  // hls/stages/count_bits.hpp:25
  logic or_1478;
  assign or_1478 = and_1475_s10_q | and_1477_s10_q;
  logic or_1482;
  assign or_1482 = and_1479_s10_q | and_1481_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1495;
  assign parity_1495 = ^{or_1490_s10_q, or_1486_s10_q, or_1482, or_1478};
  // hls/stages/count_bits.hpp:25
  logic or_1499;
  assign or_1499 = (or_1486_s10_q & or_1490_s10_q) | (or_1482 & (or_1486_s10_q | or_1490_s10_q));
  logic and_1500;
  assign and_1500 = or_1478 & (^{or_1490_s10_q, or_1486_s10_q, or_1482});
  // hls/stages/count_bits.hpp:24
  logic xor_1501;
  assign xor_1501 = or_1499 ^ and_1500;
  // hls/stages/count_bits.hpp:27
  logic and_1502;
  assign and_1502 = or_1499 & and_1500;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1503;
  assign select_1503 = equal_592_s10_q ? {and_1502, xor_1501, parity_1495, parity_1474_s10_q, xor_1429_s10_q, xor_1334_s10_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_578_s10_q ? 6'h0 : select_1503;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s10_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1539;
  assign sum_1539 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s10_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1542;
  assign sum_1542 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v & less_1647_s10_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1765;
  assign sum_1765 = {registration_slope_s10_q[11], registration_slope_s10_q} + {{5{sum_1764_s10_q[7]}}, sum_1764_s10_q};
  // hls/stages/patches.hpp:173
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1788_s10_q ? select_1871_s10_q : patches_left_rdata_s10_q;
  // hls/stages/patches.hpp:468
  logic [9:0] sum_1915;
  assign sum_1915 = {2'h0, patches_columns_above_rdata_s10_q[15:8]} + {1'b0, sum_1914_s10_q};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2739;
  assign select_2739 = ({wide_s10_q, 1'b0} < size_3_s10_q) ? {wide_s10_q, 1'b0} : size_3_s10_q;
  logic [8:0] taken;
  assign taken = ~select_2739;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3514;
  assign select_3514 = less_1961_s10_q ? (equal_1962_s10_q ? 10'h0 : select_3512_s10_q) : select_3512_s10_q;
  logic [4:0] select_3521;
  assign select_3521 = less_1961_s10_q ? (equal_1962_s10_q ? 5'h0 : select_3519_s10_q) : select_3519_s10_q;
  // hls/stages/patches.hpp:557
  logic and_3531;
  assign and_3531 = less_1961_s10_q & (patches_step_s10_q == 5'h0);
  // hls/stages/patches.hpp:561
  logic select_3534;
  assign select_3534 = equal_1964_s10_q ? (less_1961_s10_q ? (not_1965_s10_q & and_3531) : and_3531) : and_3531;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
    end else if (s10_en) begin
      patches_read_row_differing_q <= equal_1783_s10_q ? select_3514 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1783_s10_q ? select_3521 : patches_read_row_column_q;
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
  logic [3:0] age_s11_q;
  logic [2:0] slot_s11_q;
  logic ends_cell_s11_q;
  logic lower_half_s11_q;
  logic shift_first_s11_q;
  logic [4:0] patches_band_rows_number_s11_q;
  logic patches_chooses_s11_q;
  logic [4:0] patches_choosing_band_s11_q;
  logic patches_lower_s11_q;
  logic patches_second_s11_q;
  logic [4:0] patches_code_row_s11_q;
  logic [4:0] patches_column_s11_q;
  logic [4:0] patches_step_s11_q;
  logic [9:0] patches_read_row_differing_s11_q;
  logic [4:0] patches_read_row_column_s11_q;
  logic patches_read_searches_s11_q;
  logic [3:0] select_507_s11_q;
  logic equal_508_s11_q;
  logic row_starts_s11_q;
  logic [8:0] select_512_s11_q;
  logic and_521_s11_q;
  logic equal_527_s11_q;
  logic [6:0] select_542_s11_q;
  logic [6:0] last_s11_q;
  logic and_546_s11_q;
  logic and_548_s11_q;
  logic equal_568_s11_q;
  logic first_s11_q;
  logic equal_573_s11_q;
  logic so_s11_q;
  logic equal_577_s11_q;
  logic or_578_s11_q;
  logic less_581_s11_q;
  logic not_582_s11_q;
  logic inside_v_s11_q;
  logic and_599_s11_q;
  logic and_607_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic [6:0] select_625_s11_q;
  logic [6:0] right_s11_q;
  logic [28:0] best_right_rdata_s11_q;
  logic and_638_s11_q;
  logic and_643_s11_q;
  logic and_645_s11_q;
  logic equal_678_s11_q;
  logic [5:0] column_s11_q;
  logic [5:0] select_1256_s11_q;
  logic [5:0] select_1505_s11_q;
  logic [6:0] sum_1540_s11_q;
  logic [6:0] sum_1543_s11_q;
  logic and_1560_s11_q;
  logic equal_1561_s11_q;
  logic or_1581_s11_q;
  logic right_2_s11_q;
  logic and_1684_s11_q;
  logic and_1696_s11_q;
  logic less_1698_s11_q;
  logic [5:0] b_s11_q;
  logic and_1731_s11_q;
  logic [7:0] sum_1765_s11_q;
  logic less_1766_s11_q;
  logic less_1767_s11_q;
  logic equal_1776_s11_q;
  logic and_1780_s11_q;
  logic equal_1783_s11_q;
  logic not_1784_s11_q;
  logic equal_1785_s11_q;
  logic not_1786_s11_q;
  logic equal_1787_s11_q;
  logic equal_1788_s11_q;
  logic or_1789_s11_q;
  logic [4:0] select_1813_s11_q;
  logic select_1819_s11_q;
  logic [3:0] select_1857_s11_q;
  logic and_1867_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic [7:0] pixel_2_s11_q;
  logic [9:0] sum_1915_s11_q;
  logic less_1961_s11_q;
  logic equal_1962_s11_q;
  logic not_1963_s11_q;
  logic equal_1964_s11_q;
  logic not_1965_s11_q;
  logic [9:0] patches_rows_rdata_s11_q;
  logic sum_1993_s11_q;
  logic and_2014_s11_q;
  logic and_2136_s11_q;
  logic equal_2280_s11_q;
  logic equal_2469_s11_q;
  logic and_2596_s11_q;
  logic equal_2681_s11_q;
  logic less_2723_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] taken_s11_q;
  logic [7:0] not_2741_s11_q;
  logic less_2762_s11_q;
  logic and_2992_s11_q;
  logic or_3043_s11_q;
  logic not_3067_s11_q;
  logic select_3534_s11_q;
  logic equal_3546_s11_q;
  logic less_3872_s11_q;
  logic equal_4091_s11_q;
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
      age_s11_q <= age_s10_q;
      slot_s11_q <= slot_s10_q;
      ends_cell_s11_q <= ends_cell_s10_q;
      lower_half_s11_q <= lower_half_s10_q;
      shift_first_s11_q <= shift_first_s10_q;
      patches_band_rows_number_s11_q <= patches_band_rows_number_s10_q;
      patches_chooses_s11_q <= patches_chooses_s10_q;
      patches_choosing_band_s11_q <= patches_choosing_band_s10_q;
      patches_lower_s11_q <= patches_lower_s10_q;
      patches_second_s11_q <= patches_second_s10_q;
      patches_code_row_s11_q <= patches_code_row_s10_q;
      patches_column_s11_q <= patches_column_s10_q;
      patches_step_s11_q <= patches_step_s10_q;
      patches_read_row_differing_s11_q <= patches_read_row_differing_q;
      patches_read_row_column_s11_q <= patches_read_row_column_q;
      patches_read_searches_s11_q <= patches_read_searches_s10_q;
      select_507_s11_q <= select_507_s10_q;
      equal_508_s11_q <= equal_508_s10_q;
      row_starts_s11_q <= row_starts_s10_q;
      select_512_s11_q <= select_512_s10_q;
      and_521_s11_q <= and_521_s10_q;
      equal_527_s11_q <= equal_527_s10_q;
      select_542_s11_q <= select_542_s10_q;
      last_s11_q <= last_s10_q;
      and_546_s11_q <= and_546_s10_q;
      and_548_s11_q <= and_548_s10_q;
      equal_568_s11_q <= equal_568_s10_q;
      first_s11_q <= first_s10_q;
      equal_573_s11_q <= equal_573_s10_q;
      so_s11_q <= so_s10_q;
      equal_577_s11_q <= equal_577_s10_q;
      or_578_s11_q <= or_578_s10_q;
      less_581_s11_q <= less_581_s10_q;
      not_582_s11_q <= not_582_s10_q;
      inside_v_s11_q <= inside_v;
      and_599_s11_q <= and_599_s10_q;
      and_607_s11_q <= and_607_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_625_s11_q <= select_625_s10_q;
      right_s11_q <= right_s10_q;
      best_right_rdata_s11_q <= best_right_rdata_q;
      and_638_s11_q <= and_638_s10_q;
      and_643_s11_q <= and_643_s10_q;
      and_645_s11_q <= and_645_s10_q;
      equal_678_s11_q <= equal_678_s10_q;
      column_s11_q <= column;
      select_1256_s11_q <= age_s10_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1505_s11_q <= age_s10_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1540_s11_q <= {1'b0, before_v_2} + sum_1539;
      sum_1543_s11_q <= {1'b0, before_v_3} + sum_1542;
      and_1560_s11_q <= and_1560_s10_q;
      equal_1561_s11_q <= equal_1561_s10_q;
      or_1581_s11_q <= or_1581_s10_q;
      right_2_s11_q <= right_2;
      and_1684_s11_q <= and_1684_s10_q;
      and_1696_s11_q <= so_s10_q & (ends_cell_s10_q & (inside_v & right_3_s10_q));
      less_1698_s11_q <= less_1698_s10_q;
      b_s11_q <= b_s10_q;
      and_1731_s11_q <= and_1731_s10_q;
      sum_1765_s11_q <= sum_1765[7:0];
      less_1766_s11_q <= $signed(6'h0) < $signed(sum_1765[12:7]);
      less_1767_s11_q <= $signed(sum_1765[12:7]) < $signed(6'h3f);
      equal_1776_s11_q <= equal_1776_s10_q;
      and_1780_s11_q <= so_s10_q & (ends_cell_s10_q & (inside_v & or_1777_s10_q));
      equal_1783_s11_q <= equal_1783_s10_q;
      not_1784_s11_q <= not_1784_s10_q;
      equal_1785_s11_q <= equal_1785_s10_q;
      not_1786_s11_q <= not_1786_s10_q;
      equal_1787_s11_q <= equal_1787_s10_q;
      equal_1788_s11_q <= equal_1788_s10_q;
      or_1789_s11_q <= or_1789_s10_q;
      select_1813_s11_q <= select_1813_s10_q;
      select_1819_s11_q <= select_1819_s10_q;
      select_1857_s11_q <= select_1857_s10_q;
      and_1867_s11_q <= and_1867_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_s10_q;
      pixel_2_s11_q <= pixel_2;
      sum_1915_s11_q <= sum_1915;
      less_1961_s11_q <= less_1961_s10_q;
      equal_1962_s11_q <= equal_1962_s10_q;
      not_1963_s11_q <= not_1963_s10_q;
      equal_1964_s11_q <= equal_1964_s10_q;
      not_1965_s11_q <= not_1965_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_s10_q;
      sum_1993_s11_q <= sum_1993_s10_q;
      and_2014_s11_q <= and_2014_s10_q;
      and_2136_s11_q <= and_2136_s10_q;
      equal_2280_s11_q <= equal_2280_s10_q;
      equal_2469_s11_q <= equal_2469_s10_q;
      and_2596_s11_q <= and_2596_s10_q;
      equal_2681_s11_q <= equal_2681_s10_q;
      less_2723_s11_q <= slot_s10_q < 3'h3;
      wide_s11_q <= wide_s10_q;
      taken_s11_q <= taken;
      not_2741_s11_q <= ~wide_s10_q;
      less_2762_s11_q <= less_2762_s10_q;
      and_2992_s11_q <= so_s10_q & (ends_cell_s10_q & (inside_v & not_2989_s10_q));
      or_3043_s11_q <= or_3043_s10_q;
      not_3067_s11_q <= not_3067_s10_q;
      select_3534_s11_q <= select_3534;
      equal_3546_s11_q <= equal_3546_s10_q;
      less_3872_s11_q <= less_3872_s10_q;
      equal_4091_s11_q <= equal_4091_s10_q;
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
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic patches_read_first_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  // hls/stages/census.hpp:127
  logic and_522;
  assign and_522 = sample_pair_whole_s11_q & and_521_s11_q;
  // hls/stages/moments.hpp:57
  logic [13:0] select_571;
  assign select_571 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:1009
  logic not_574;
  assign not_574 = ~equal_573_s11_q;
  // hls/stages/agreement.hpp:201
  logic not_576;
  assign not_576 = ~so_s11_q;
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s11_q[2] ? best_right_rdata_s11_q[14:8] : best_right_rdata_s11_q[28:22];
  // hls/stages/agreement.hpp:807
  logic or_758;
  assign or_758 = shift_first_s11_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1007;
  assign select_1007 = age_s11_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s11_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1535;
  assign sum_1535 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1545;
  assign select_1545 = (sum_1540_s11_q < sum_1543_s11_q) ? sum_1543_s11_q : sum_1540_s11_q;
  // hls/stages/agreement.hpp:788
  logic and_1571;
  assign and_1571 = ends_cell_s11_q & inside_v_s11_q;
  logic and_1573;
  assign and_1573 = not_574 & (so_s11_q & and_1571);
  // hls/stages/registration.hpp:83
  logic equal_1699;
  assign equal_1699 = slot_s11_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1702;
  assign select_1702 = b_s11_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1703;
  assign select_1703 = b_s11_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1704;
  assign sum_1704 = {{2{select_1702[6]}}, select_1702} + {select_1703[7], select_1703};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1705;
  assign select_1705 = b_s11_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1706;
  assign select_1706 = b_s11_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1707;
  assign sum_1707 = {{2{select_1705[7]}}, select_1705[7:1]} + {select_1706[7], select_1706};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1709;
  assign select_1709 = b_s11_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1710;
  assign select_1710 = b_s11_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1711;
  assign difference_1711 = {{2{select_1709[7]}}, select_1709[7:1]} - {select_1710[7], select_1710};
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1747;
  assign select_1747 = so_s11_q ? (ends_cell_s11_q ? (inside_v_s11_q ? b_s11_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1769;
  assign select_1769 = less_1766_s11_q ? 8'h7f : (less_1767_s11_q ? 8'h80 : sum_1765_s11_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1699 ? registration_slope_here_q : select_1769;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1773;
  assign select_1773 = so_s11_q ? (ends_cell_s11_q ? (inside_v_s11_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1781;
  assign and_1781 = not_574 & and_1780_s11_q;
  // hls/stages/patches.hpp:470
  logic [8:0] sum_1895;
  assign sum_1895 = {1'b0, patches_columns_above_rdata_s11_q[7:0]} + {2'h0, pixel_2_s11_q[7:1]};
  logic [8:0] sum_1896;
  assign sum_1896 = {1'b0, patches_columns_above_rdata_s11_q[23:16]} + {2'h0, patches_columns_above_rdata_s11_q[31:25]};
  // hls/stages/patches.hpp:468
  logic [10:0] sum_1916;
  assign sum_1916 = {3'h0, patches_columns_above_rdata_s11_q[15:8]} + {sum_1915_s11_q, patches_columns_above_rdata_s11_q[25]};
  // hls/stages/agreement.hpp:788
  logic and_2332;
  assign and_2332 = not_574 & (not_576 & (equal_577_s11_q & (inside_v_s11_q & first_s11_q)));
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2569;
  assign select_2569 = slot_s11_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2570;
  assign select_2570 = slot_s11_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2571;
  assign select_2571 = slot_s11_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2572;
  assign select_2572 = slot_s11_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2573;
  assign select_2573 = slot_s11_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2574;
  assign select_2574 = slot_s11_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s11_q[61:54]} - {1'b0, best_left_rdata_s11_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2734;
  assign not_2734 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2723_s11_q ? {1'b0, wide_s11_q, 1'b0} : {registration_displacement_over_q[8:0], not_2734};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2742;
  assign select_2742 = registration_displacement_over_q[9] ? wide_s11_q : not_2741_s11_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2723_s11_q ? {taken_s11_q, 1'b1} : {not_2734, select_2742, not_2734};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2744;
  assign sum_2744 = {left, 1'b1} + {taken_2, less_2723_s11_q};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2746;
  assign select_2746 = so_s11_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2748;
  assign select_2748 = equal_573_s11_q ? registration_slope_here_q : (so_s11_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2757;
  assign select_2757 = or_578_s11_q ? (less_581_s11_q ? 3'h0 : best_left_rdata_s11_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:188
  logic select_3082;
  assign select_3082 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:176
  logic and_3143;
  assign and_3143 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:414
  logic [4:0] select_3148;
  assign select_3148 = or_3043_s11_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:416
  logic [3:0] select_3150;
  assign select_3150 = and_3143 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:557
  logic [4:0] select_3523;
  assign select_3523 = less_1961_s11_q ? patches_step_s11_q : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3526;
  assign select_3526 = equal_1964_s11_q ? (less_1961_s11_q ? (equal_1964_s11_q ? 5'h0 : select_3523) : 5'h0) : select_3523;
  logic [4:0] select_3528;
  assign select_3528 = less_1961_s11_q ? (equal_1962_s11_q ? 5'h0 : select_3526) : select_3526;
  logic select_3536;
  assign select_3536 = less_1961_s11_q ? (not_1963_s11_q & select_3534_s11_q) : select_3534_s11_q;
  // hls/stages/patches.hpp:179
  logic or_3548;
  assign or_3548 = patches_read_first_q | (patches_read_row_differing_s11_q < patches_peak_best_differing_q);
  logic and_3549;
  assign and_3549 = patches_read_searches_s11_q & or_3548;
  // hls/stages/patches.hpp:540
  logic [14:0] select_3581;
  assign select_3581 = and_3549 ? {patches_read_row_column_s11_q, patches_read_row_differing_s11_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:185
  logic [9:0] select_3582;
  assign select_3582 = equal_1783_s11_q ? select_3581[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3583;
  assign select_3583 = equal_1783_s11_q ? select_3581[14:10] : patches_peak_best_column_q;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:238; read in stage 11, written in stage 14: 11 < 14 < 11 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_512_s11_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s11_en & and_522;
`endif
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1405; read in stage 11, written in stage 15: 11 < 15 < 11 + DISTANCE.
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
  assign seen_columns_re = s11_en & and_1573;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s11_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s11_en & and_1867_s11_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_s11_q[23:0], pixel_2_s11_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_columns_above_raddr_s8_sim;
  logic patches_columns_above_re_s8_sim;
  logic [4:0] patches_columns_above_raddr_s9_sim;
  logic patches_columns_above_re_s9_sim;
  logic [4:0] patches_columns_above_raddr_s10_sim;
  logic patches_columns_above_re_s10_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_columns_above_re_s8_sim <= 1'b0;
      patches_columns_above_re_s9_sim <= 1'b0;
      patches_columns_above_re_s10_sim <= 1'b0;
    end else if (en_i) begin
      patches_columns_above_re_s8_sim <= patches_columns_above_re;
      patches_columns_above_raddr_s8_sim <= patches_columns_above_raddr;
      patches_columns_above_re_s9_sim <= patches_columns_above_re_s8_sim;
      patches_columns_above_raddr_s9_sim <= patches_columns_above_raddr_s8_sim;
      patches_columns_above_re_s10_sim <= patches_columns_above_re_s9_sim;
      patches_columns_above_raddr_s10_sim <= patches_columns_above_raddr_s9_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s8_sim && patches_columns_above_raddr_s8_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s9_sim && patches_columns_above_raddr_s9_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s10_sim && patches_columns_above_raddr_s10_sim == patches_columns_above_waddr) begin
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
      shift_not_right_q <= 1'b0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      patches_along_ends_q <= 1'b0;
      patches_match_row_ends_q <= 1'b0;
      patches_down_by_q <= 5'h0;
      patches_along_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_last_q <= 1'b0;
      patches_read_first_q <= 1'b0;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
    end else if (s11_en) begin
      moments_place_q <= select_571;
      moments_taken_q <= not_574 & (not_576 & (equal_577_s11_q & inside_v_s11_q));
      moments_starts_q <= and_2332;
      shift_not_right_q <= $signed(run_shift_s11_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s11_q ? sum_2744[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2746;
      registration_slope_here_q <= select_2748;
      patches_along_ends_q <= not_3067_s11_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3067_s11_q & select_3082;
      patches_down_by_q <= or_3043_s11_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3143});
      patches_along_q <= select_3148;
      patches_match_row_q <= or_3043_s11_q ? 4'h0 : select_3150;
      patches_summed_last_q <= not_1784_s11_q & (equal_1785_s11_q & and_3143);
      patches_read_first_q <= equal_1783_s11_q ? select_3536 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3582;
      patches_peak_best_column_q <= select_3583;
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
      middle_sum_columns_values_1_q <= select_2569;
      middle_sum_columns_values_2_q <= select_2570;
      middle_sum_columns_values_3_q <= select_2571;
      middle_sum_columns_values_4_q <= select_2572;
      middle_sum_columns_values_5_q <= select_2573;
      middle_sum_columns_values_6_q <= select_2574;
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
  logic [1:0] age_s12_q;
  logic [2:0] slot_s12_q;
  logic ends_cell_s12_q;
  logic lower_half_s12_q;
  logic shift_not_right_s12_q;
  logic [4:0] patches_band_rows_number_s12_q;
  logic [4:0] patches_choosing_band_s12_q;
  logic patches_lower_s12_q;
  logic patches_second_s12_q;
  logic [4:0] patches_code_row_s12_q;
  logic [4:0] patches_column_s12_q;
  logic patches_match_row_ends_s12_q;
  logic [4:0] patches_down_by_s12_q;
  logic [4:0] patches_along_s12_q;
  logic [3:0] patches_match_row_s12_q;
  logic patches_summed_last_s12_q;
  logic [4:0] patches_step_s12_q;
  logic [9:0] patches_read_row_differing_s12_q;
  logic patches_read_first_s12_q;
  logic [3:0] select_507_s12_q;
  logic equal_508_s12_q;
  logic row_starts_s12_q;
  logic [8:0] select_512_s12_q;
  logic and_521_s12_q;
  logic and_522_s12_q;
  logic equal_527_s12_q;
  logic [6:0] select_542_s12_q;
  logic [6:0] last_s12_q;
  logic and_546_s12_q;
  logic and_548_s12_q;
  logic equal_568_s12_q;
  logic first_s12_q;
  logic equal_573_s12_q;
  logic not_574_s12_q;
  logic so_s12_q;
  logic not_576_s12_q;
  logic equal_577_s12_q;
  logic or_578_s12_q;
  logic less_581_s12_q;
  logic not_582_s12_q;
  logic inside_v_s12_q;
  logic and_599_s12_q;
  logic and_607_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic less_618_s12_q;
  logic [6:0] select_625_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic [6:0] chosen_s12_q;
  logic and_638_s12_q;
  logic and_643_s12_q;
  logic and_645_s12_q;
  logic equal_678_s12_q;
  logic select_760_s12_q;
  logic [6:0] difference_1008_s12_q;
  logic [6:0] difference_1257_s12_q;
  logic equal_1258_s12_q;
  logic [6:0] difference_1506_s12_q;
  logic [6:0] sum_1536_s12_q;
  logic [6:0] select_1545_s12_q;
  logic and_1560_s12_q;
  logic select_1562_s12_q;
  logic and_1571_s12_q;
  logic and_1573_s12_q;
  logic or_1581_s12_q;
  logic and_1590_s12_q;
  logic right_2_s12_q;
  logic and_1684_s12_q;
  logic and_1697_s12_q;
  logic less_1698_s12_q;
  logic equal_1699_s12_q;
  logic [7:0] sum_1704_s12_q;
  logic select_1705_s12_q;
  logic [8:0] sum_1707_s12_q;
  logic select_1709_s12_q;
  logic [8:0] difference_1711_s12_q;
  logic and_1731_s12_q;
  logic [5:0] select_1748_s12_q;
  logic [7:0] select_1774_s12_q;
  logic equal_1776_s12_q;
  logic and_1781_s12_q;
  logic and_1782_s12_q;
  logic equal_1783_s12_q;
  logic not_1784_s12_q;
  logic equal_1785_s12_q;
  logic not_1786_s12_q;
  logic equal_1787_s12_q;
  logic equal_1788_s12_q;
  logic or_1789_s12_q;
  logic [4:0] select_1813_s12_q;
  logic select_1819_s12_q;
  logic [3:0] select_1857_s12_q;
  logic [8:0] patches_columns_above_rdata_s12_q;
  logic [7:0] pixel_2_s12_q;
  logic [4:0] sum_1881_s12_q;
  logic [8:0] sum_1895_s12_q;
  logic [8:0] sum_1896_s12_q;
  logic [10:0] sum_1916_s12_q;
  logic less_1961_s12_q;
  logic equal_1962_s12_q;
  logic not_1963_s12_q;
  logic equal_1964_s12_q;
  logic not_1965_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1993_s12_q;
  logic and_2014_s12_q;
  logic and_2137_s12_q;
  logic equal_2280_s12_q;
  logic equal_2469_s12_q;
  logic and_2596_s12_q;
  logic equal_2681_s12_q;
  logic rise_s12_q;
  logic [7:0] xor_2686_s12_q;
  logic select_2757_s12_q;
  logic or_2760_s12_q;
  logic [1:0] sum_2761_s12_q;
  logic less_2762_s12_q;
  logic and_2993_s12_q;
  logic [4:0] select_3528_s12_q;
  logic equal_3546_s12_q;
  logic and_3549_s12_q;
  logic [14:0] select_3581_s12_q;
  logic less_3872_s12_q;
  logic equal_4091_s12_q;
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
      age_s12_q <= {age_s11_q[2], age_s11_q[0]};
      slot_s12_q <= slot_s11_q;
      ends_cell_s12_q <= ends_cell_s11_q;
      lower_half_s12_q <= lower_half_s11_q;
      shift_not_right_s12_q <= shift_not_right_q;
      patches_band_rows_number_s12_q <= patches_band_rows_number_s11_q;
      patches_choosing_band_s12_q <= patches_choosing_band_s11_q;
      patches_lower_s12_q <= patches_lower_s11_q;
      patches_second_s12_q <= patches_second_s11_q;
      patches_code_row_s12_q <= patches_code_row_s11_q;
      patches_column_s12_q <= patches_column_s11_q;
      patches_match_row_ends_s12_q <= patches_match_row_ends_q;
      patches_down_by_s12_q <= patches_down_by_q;
      patches_along_s12_q <= patches_along_q;
      patches_match_row_s12_q <= patches_match_row_q;
      patches_summed_last_s12_q <= patches_summed_last_q;
      patches_step_s12_q <= patches_step_s11_q;
      patches_read_row_differing_s12_q <= patches_read_row_differing_s11_q;
      patches_read_first_s12_q <= patches_read_first_q;
      select_507_s12_q <= select_507_s11_q;
      equal_508_s12_q <= equal_508_s11_q;
      row_starts_s12_q <= row_starts_s11_q;
      select_512_s12_q <= select_512_s11_q;
      and_521_s12_q <= and_521_s11_q;
      and_522_s12_q <= and_522;
      equal_527_s12_q <= equal_527_s11_q;
      select_542_s12_q <= select_542_s11_q;
      last_s12_q <= last_s11_q;
      and_546_s12_q <= and_546_s11_q;
      and_548_s12_q <= and_548_s11_q;
      equal_568_s12_q <= equal_568_s11_q;
      first_s12_q <= first_s11_q;
      equal_573_s12_q <= equal_573_s11_q;
      not_574_s12_q <= not_574;
      so_s12_q <= so_s11_q;
      not_576_s12_q <= not_576;
      equal_577_s12_q <= equal_577_s11_q;
      or_578_s12_q <= or_578_s11_q;
      less_581_s12_q <= less_581_s11_q;
      not_582_s12_q <= not_582_s11_q;
      inside_v_s12_q <= inside_v_s11_q;
      and_599_s12_q <= and_599_s11_q;
      and_607_s12_q <= and_607_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      less_618_s12_q <= 8'hb6 < best_left_rdata_s11_q[16:9];
      select_625_s12_q <= select_625_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_s11_q;
      chosen_s12_q <= chosen;
      and_638_s12_q <= and_638_s11_q;
      and_643_s12_q <= and_643_s11_q;
      and_645_s12_q <= and_645_s11_q;
      equal_678_s12_q <= equal_678_s11_q;
      select_760_s12_q <= or_758 ? shift_first_s11_q : (~age_s11_q[1]);
      difference_1008_s12_q <= {1'b0, column_s11_q} - {1'b0, select_1007};
      difference_1257_s12_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1256_s11_q};
      equal_1258_s12_q <= {age_s11_q[0], slot_s11_q[0]} == 2'h0;
      difference_1506_s12_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1505_s11_q};
      sum_1536_s12_q <= {1'b0, before_v} + sum_1535;
      select_1545_s12_q <= select_1545;
      and_1560_s12_q <= and_1560_s11_q;
      select_1562_s12_q <= or_758 ? shift_first_s11_q : equal_1561_s11_q;
      and_1571_s12_q <= and_1571;
      and_1573_s12_q <= and_1573;
      or_1581_s12_q <= or_1581_s11_q;
      and_1590_s12_q <= or_578_s11_q & (slot_s11_q[2] & not_582_s11_q);
      right_2_s12_q <= right_2_s11_q;
      and_1684_s12_q <= and_1684_s11_q;
      and_1697_s12_q <= not_574 & and_1696_s11_q;
      less_1698_s12_q <= less_1698_s11_q;
      equal_1699_s12_q <= equal_1699;
      sum_1704_s12_q <= sum_1704[8:1];
      select_1705_s12_q <= select_1705[0];
      sum_1707_s12_q <= sum_1707;
      select_1709_s12_q <= select_1709[0];
      difference_1711_s12_q <= difference_1711;
      and_1731_s12_q <= and_1731_s11_q;
      select_1748_s12_q <= equal_573_s11_q ? 6'h0 : select_1747;
      select_1774_s12_q <= equal_573_s11_q ? 8'h0 : select_1773;
      equal_1776_s12_q <= equal_1776_s11_q;
      and_1781_s12_q <= and_1781;
      and_1782_s12_q <= patches_chooses_s11_q & and_1781;
      equal_1783_s12_q <= equal_1783_s11_q;
      not_1784_s12_q <= not_1784_s11_q;
      equal_1785_s12_q <= equal_1785_s11_q;
      not_1786_s12_q <= not_1786_s11_q;
      equal_1787_s12_q <= equal_1787_s11_q;
      equal_1788_s12_q <= equal_1788_s11_q;
      or_1789_s12_q <= or_1789_s11_q;
      select_1813_s12_q <= select_1813_s11_q;
      select_1819_s12_q <= select_1819_s11_q;
      select_1857_s12_q <= select_1857_s11_q;
      patches_columns_above_rdata_s12_q <= {patches_columns_above_rdata_s11_q[24], patches_columns_above_rdata_s11_q[7:0]};
      pixel_2_s12_q <= pixel_2_s11_q;
      sum_1881_s12_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1895_s12_q <= sum_1895;
      sum_1896_s12_q <= sum_1896;
      sum_1916_s12_q <= sum_1916;
      less_1961_s12_q <= less_1961_s11_q;
      equal_1962_s12_q <= equal_1962_s11_q;
      not_1963_s12_q <= not_1963_s11_q;
      equal_1964_s12_q <= equal_1964_s11_q;
      not_1965_s12_q <= not_1965_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q;
      sum_1993_s12_q <= sum_1993_s11_q;
      and_2014_s12_q <= and_2014_s11_q;
      and_2137_s12_q <= not_574 & and_2136_s11_q;
      equal_2280_s12_q <= equal_2280_s11_q;
      equal_2469_s12_q <= equal_2469_s11_q;
      and_2596_s12_q <= and_2596_s11_q;
      equal_2681_s12_q <= equal_2681_s11_q;
      rise_s12_q <= rise[8];
      xor_2686_s12_q <= rise[7:0] ^ {8{rise[8]}};
      select_2757_s12_q <= select_2757[0];
      or_2760_s12_q <= (select_2757 == 3'h0) | (select_2757 == 3'h4);
      sum_2761_s12_q <= select_2757[2:1] + 2'h3;
      less_2762_s12_q <= less_2762_s11_q;
      and_2993_s12_q <= not_574 & and_2992_s11_q;
      select_3528_s12_q <= select_3528;
      equal_3546_s12_q <= equal_3546_s11_q;
      and_3549_s12_q <= and_3549;
      select_3581_s12_q <= select_3581;
      less_3872_s12_q <= less_3872_s11_q;
      equal_4091_s12_q <= equal_4091_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
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
  logic [4:0] patches_summed_down_by_q;
  logic [4:0] patches_read_at_q;
  logic [4:0] patches_peak_row_q;
  // hls/stages/census.hpp:117
  logic [13:0] select_525;
  assign select_525 = equal_508_s12_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_531;
  assign sum_531 = {6'h0, sample_pair_pixel_1_q} + (equal_508_s12_q ? 14'h0 : averager_running_1_q);
  // hls/stages/moments.hpp:63
  logic [10:0] place;
  assign place = first_s12_q ? 11'h0 : moments_place_q[13:3];
  // hls/stages/moments.hpp:104
  logic not_586;
  assign not_586 = ~(11'h3ec < place);
  // hls/stages/agreement.hpp:978
  logic select_620;
  assign select_620 = slot_s12_q[2] ? less_618_s12_q : (6'h2a < best_left_rdata_s12_q[39:34]);
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_630;
  assign difference_630 = {2'h0, chosen_s12_q} - {1'b0, x_s12_q};
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1010;
  assign sum_1010 = {difference_1008_s12_q[6], difference_1008_s12_q} + (age_s12_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1260;
  assign sum_1260 = {difference_1257_s12_q[6], difference_1257_s12_q} + (equal_1258_s12_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1508;
  assign sum_1508 = {difference_1506_s12_q[6], difference_1506_s12_q} + (equal_1258_s12_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1537;
  assign select_1537 = slot_s12_q[0] ? chosen_near_q : sum_1536_s12_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1547;
  assign select_1547 = (select_1537 < select_1545_s12_q) ? select_1545_s12_q : select_1537;
  // hls/stages/agreement.hpp:788
  logic [6:0] select_1577;
  assign select_1577 = so_s12_q ? x_s12_q[6:0] : (or_578_s12_q ? (less_581_s12_q ? 7'h0 : select_625_s12_q) : 7'h0);
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1708;
  assign sum_1708 = {{3{sum_1704_s12_q[7]}}, sum_1704_s12_q} + {sum_1707_s12_q[8], sum_1707_s12_q, select_1705_s12_q};
  logic [9:0] sum_1712;
  assign sum_1712 = {difference_1711_s12_q, select_1709_s12_q} + {sum_1708[10], sum_1708[10:2]};
  // hls/stages/patches.hpp:501
  logic less_1873;
  assign less_1873 = 5'he < patches_along_s12_q;
  // hls/stages/patches.hpp:502
  logic or_1874;
  assign or_1874 = equal_1787_s12_q | less_1873;
  // hls/stages/patches.hpp:505
  logic new_row;
  assign new_row = patches_along_s12_q == 5'h0;
  logic select_1879;
  assign select_1879 = equal_1787_s12_q ? patches_column_s12_q[0] : (or_1874 ? (patches_along_s12_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:503
  logic [4:0] select_1882;
  assign select_1882 = patches_match_row_ends_s12_q ? patches_down_by_s12_q : sum_1881_s12_q;
  // hls/stages/patches.hpp:506
  logic [4:0] select_1885;
  assign select_1885 = equal_1787_s12_q ? 5'h0 : (or_1874 ? (select_1882 + 5'h1) : sum_1881_s12_q);
  // hls/stages/patches.hpp:482
  logic equal_1888;
  assign equal_1888 = patches_column_s12_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s12_q == 5'h11;
  logic equal_1890;
  assign equal_1890 = patches_column_s12_q == 5'h18;
  // hls/stages/patches.hpp:484
  logic and_1892;
  assign and_1892 = of_row & (~equal_1890);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1888 ? 2'h3 : {equal_1890, and_1892};
  // hls/stages/patches.hpp:470
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1895_s12_q, pixel_2_s12_q[0]} - {1'b0, sum_1896_s12_q, patches_columns_above_rdata_s12_q[8]};
  // hls/stages/patches.hpp:468
  logic [9:0] sum_1917;
  assign sum_1917 = {2'h0, patches_columns_above_rdata_s12_q[7:0]} + sum_1916_s12_q[10:1];
  // hls/stages/patches.hpp:483
  logic or_1936;
  assign or_1936 = (((patches_column_s12_q == 5'ha) | of_row) | equal_1890) | equal_1888;
  // hls/stages/patches.hpp:478
  logic and_1941;
  assign and_1941 = (~(patches_code_row_s12_q[4:2] == 3'h0)) & (~(patches_column_s12_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:173
  logic and_1955;
  assign and_1955 = (~(equal_1788_s12_q | (~and_1941))) & (~patches_column_s12_q[4]);
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2581;
  assign select_2581 = slot_s12_q[0] ? 7'h0 : sum_1536_s12_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2583;
  assign select_2583 = (select_2581 < select_1545_s12_q) ? select_1545_s12_q : select_2581;
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise_s12_q ? best_left_rdata_s12_q[61:54] : best_left_rdata_s12_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2763;
  assign difference_2763 = {sum_2761_s12_q, select_2757_s12_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2764;
  assign select_2764 = less_2762_s12_q ? difference_2763 : {sum_2761_s12_q, select_2757_s12_q, registration_displacement_fraction_q};
  logic [7:0] select_2765;
  assign select_2765 = or_2760_s12_q ? {sum_2761_s12_q, select_2757_s12_q, 5'h0} : select_2764;
  // hls/stages/patches.hpp:185
  logic [4:0] select_3505;
  assign select_3505 = equal_1785_s12_q ? patches_down_by_s12_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:541
  logic [4:0] select_3550;
  assign select_3550 = and_3549_s12_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:548
  logic [5:0] away;
  assign away = {1'b0, patches_step_s12_q} - {1'b0, select_3550};

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1377; read in stage 12, written in stage 15: 12 < 15 < 12 + DISTANCE.
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
  assign shown_right_re = s12_en & and_1573_s12_q;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1378; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
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
  assign left_turns_re = s12_en & and_1590_s12_q;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1378; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_625_s12_q;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s12_en & and_1590_s12_q;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      chosen_near_q <= 7'h0;
      patches_summed_down_by_q <= 5'h0;
      patches_read_at_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
    end else if (s12_en) begin
      sample_pair_pixel_0_q <= pixel_0_s12_q;
      sample_pair_pixel_1_q <= pixel_1_s12_q;
      chosen_near_q <= select_2583;
      patches_summed_down_by_q <= equal_1783_s12_q ? patches_summed_down_by_q : select_3505;
      patches_read_at_q <= equal_1783_s12_q ? select_3528_s12_q : patches_read_at_q;
      patches_peak_row_q <= equal_1783_s12_q ? select_3550 : patches_peak_row_q;
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
    if (s12_en) begin
      averager_running_0_q <= sample_pair_whole_s12_q ? select_525 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s12_q ? sum_531 : averager_running_1_q;
      middle_sum_sum_sums_values_0_q <= slot_s12_q[0] ? middle_sum_sum_sums_values_0_q : sum_1010;
      sums_0_sum_sums_values_0_q <= sum_1260;
      sums_0_sum_sums_values_1_q <= equal_1258_s12_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1508;
      sums_1_sum_sums_values_1_q <= equal_1258_s12_q ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic saturated_s13_q;
  logic mask_s13_q;
  logic marks_first_s13_q;
  logic marks_last_s13_q;
  logic [7:0] sample_pair_pixel_0_s13_q;
  logic [7:0] sample_pair_pixel_1_s13_q;
  logic sample_pair_whole_s13_q;
  logic sample_present_s13_q;
  logic moments_starts_s13_q;
  logic [5:0] run_shift_s13_q;
  logic [7:0] x_s13_q;
  logic age_s13_q;
  logic [2:0] slot_s13_q;
  logic ends_cell_s13_q;
  logic lower_half_s13_q;
  logic shift_not_right_s13_q;
  logic [4:0] patches_band_rows_number_s13_q;
  logic [4:0] patches_choosing_band_s13_q;
  logic patches_lower_s13_q;
  logic patches_second_s13_q;
  logic [4:0] patches_code_row_s13_q;
  logic [4:0] patches_along_s13_q;
  logic [3:0] patches_match_row_s13_q;
  logic patches_summed_last_s13_q;
  logic [4:0] patches_summed_down_by_s13_q;
  logic [9:0] patches_read_row_differing_s13_q;
  logic patches_read_first_s13_q;
  logic [3:0] select_507_s13_q;
  logic equal_508_s13_q;
  logic row_starts_s13_q;
  logic [8:0] select_512_s13_q;
  logic and_521_s13_q;
  logic and_522_s13_q;
  logic [29:0] averager_memory_rdata_s13_q;
  logic [13:0] select_525_s13_q;
  logic equal_527_s13_q;
  logic [13:0] sum_531_s13_q;
  logic [6:0] select_542_s13_q;
  logic [6:0] last_s13_q;
  logic and_546_s13_q;
  logic and_548_s13_q;
  logic equal_568_s13_q;
  logic [12:0] select_572_s13_q;
  logic equal_573_s13_q;
  logic not_574_s13_q;
  logic so_s13_q;
  logic not_576_s13_q;
  logic equal_577_s13_q;
  logic or_578_s13_q;
  logic less_581_s13_q;
  logic not_582_s13_q;
  logic inside_v_s13_q;
  logic not_586_s13_q;
  logic and_589_s13_q;
  logic and_599_s13_q;
  logic and_607_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_620_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic [9:0] sum_631_s13_q;
  logic and_638_s13_q;
  logic and_643_s13_q;
  logic and_645_s13_q;
  logic equal_678_s13_q;
  logic select_760_s13_q;
  logic [7:0] sum_1010_s13_q;
  logic less_1509_s13_q;
  logic [6:0] select_1547_s13_q;
  logic [7:0] select_1555_s13_q;
  logic [7:0] select_1558_s13_q;
  logic and_1560_s13_q;
  logic select_1562_s13_q;
  logic and_1571_s13_q;
  logic and_1573_s13_q;
  logic [6:0] select_1577_s13_q;
  logic or_1581_s13_q;
  logic and_1599_s13_q;
  logic right_2_s13_q;
  logic and_1684_s13_q;
  logic and_1697_s13_q;
  logic less_1698_s13_q;
  logic equal_1699_s13_q;
  logic sum_1708_s13_q;
  logic [9:0] sum_1712_s13_q;
  logic and_1731_s13_q;
  logic [5:0] select_1748_s13_q;
  logic [7:0] select_1774_s13_q;
  logic equal_1776_s13_q;
  logic and_1781_s13_q;
  logic and_1782_s13_q;
  logic equal_1783_s13_q;
  logic not_1784_s13_q;
  logic equal_1785_s13_q;
  logic not_1786_s13_q;
  logic equal_1788_s13_q;
  logic or_1789_s13_q;
  logic [4:0] select_1813_s13_q;
  logic select_1819_s13_q;
  logic [3:0] select_1857_s13_q;
  logic patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic less_1873_s13_q;
  logic new_row_s13_q;
  logic select_1879_s13_q;
  logic not_1880_s13_q;
  logic [4:0] select_1885_s13_q;
  logic or_1886_s13_q;
  logic [1:0] of_row_2_s13_q;
  logic [10:0] down_2_s13_q;
  logic sum_1916_s13_q;
  logic [9:0] sum_1917_s13_q;
  logic and_1944_s13_q;
  logic and_1955_s13_q;
  logic and_1958_s13_q;
  logic less_1961_s13_q;
  logic equal_1962_s13_q;
  logic not_1963_s13_q;
  logic equal_1964_s13_q;
  logic not_1965_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1993_s13_q;
  logic and_2014_s13_q;
  logic [17:0] seen_columns_rdata_s13_q;
  logic and_2137_s13_q;
  logic equal_2280_s13_q;
  logic equal_2469_s13_q;
  logic and_2596_s13_q;
  logic equal_2681_s13_q;
  logic [7:0] lower_s13_q;
  logic [7:0] sum_2687_s13_q;
  logic [7:0] select_2765_s13_q;
  logic and_2993_s13_q;
  logic less_3119_s13_q;
  logic equal_3546_s13_q;
  logic [4:0] select_3550_s13_q;
  logic [5:0] away_s13_q;
  logic equal_3552_s13_q;
  logic equal_3561_s13_q;
  logic [14:0] select_3581_s13_q;
  logic less_3872_s13_q;
  logic equal_4091_s13_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s13_q <= saturated_s12_q;
      mask_s13_q <= mask_s12_q;
      marks_first_s13_q <= marks_first_s12_q;
      marks_last_s13_q <= marks_last_s12_q;
      sample_pair_pixel_0_s13_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s13_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s13_q <= sample_pair_whole_s12_q;
      sample_present_s13_q <= sample_present_s12_q;
      moments_starts_s13_q <= moments_starts_s12_q;
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      age_s13_q <= age_s12_q[1];
      slot_s13_q <= slot_s12_q;
      ends_cell_s13_q <= ends_cell_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      shift_not_right_s13_q <= shift_not_right_s12_q;
      patches_band_rows_number_s13_q <= patches_band_rows_number_s12_q;
      patches_choosing_band_s13_q <= patches_choosing_band_s12_q;
      patches_lower_s13_q <= patches_lower_s12_q;
      patches_second_s13_q <= patches_second_s12_q;
      patches_code_row_s13_q <= patches_code_row_s12_q;
      patches_along_s13_q <= patches_along_s12_q;
      patches_match_row_s13_q <= patches_match_row_s12_q;
      patches_summed_last_s13_q <= patches_summed_last_s12_q;
      patches_summed_down_by_s13_q <= patches_summed_down_by_q;
      patches_read_row_differing_s13_q <= patches_read_row_differing_s12_q;
      patches_read_first_s13_q <= patches_read_first_s12_q;
      select_507_s13_q <= select_507_s12_q;
      equal_508_s13_q <= equal_508_s12_q;
      row_starts_s13_q <= row_starts_s12_q;
      select_512_s13_q <= select_512_s12_q;
      and_521_s13_q <= and_521_s12_q;
      and_522_s13_q <= and_522_s12_q;
      averager_memory_rdata_s13_q <= averager_memory_rdata_q;
      select_525_s13_q <= select_525;
      equal_527_s13_q <= equal_527_s12_q;
      sum_531_s13_q <= sum_531;
      select_542_s13_q <= select_542_s12_q;
      last_s13_q <= last_s12_q;
      and_546_s13_q <= and_546_s12_q;
      and_548_s13_q <= and_548_s12_q;
      equal_568_s13_q <= equal_568_s12_q;
      select_572_s13_q <= first_s12_q ? 13'h0 : moments_place_q[12:0];
      equal_573_s13_q <= equal_573_s12_q;
      not_574_s13_q <= not_574_s12_q;
      so_s13_q <= so_s12_q;
      not_576_s13_q <= not_576_s12_q;
      equal_577_s13_q <= equal_577_s12_q;
      or_578_s13_q <= or_578_s12_q;
      less_581_s13_q <= less_581_s12_q;
      not_582_s13_q <= not_582_s12_q;
      inside_v_s13_q <= inside_v_s12_q;
      not_586_s13_q <= not_586;
      and_589_s13_q <= not_576_s12_q & (equal_577_s12_q & (inside_v_s12_q & not_586));
      and_599_s13_q <= and_599_s12_q;
      and_607_s13_q <= and_607_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q[45:0];
      select_620_s13_q <= select_620;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      sum_631_s13_q <= {difference_630[8], difference_630} + 10'h1;
      and_638_s13_q <= and_638_s12_q;
      and_643_s13_q <= and_643_s12_q;
      and_645_s13_q <= and_645_s12_q;
      equal_678_s13_q <= equal_678_s12_q;
      select_760_s13_q <= select_760_s12_q;
      sum_1010_s13_q <= sum_1010;
      less_1509_s13_q <= sum_1260 < sum_1508;
      select_1547_s13_q <= select_1547;
      select_1555_s13_q <= select_760_s12_q ? 8'h0 : best_left_rdata_s12_q[53:46];
      select_1558_s13_q <= select_760_s12_q ? 8'h0 : best_left_rdata_s12_q[61:54];
      and_1560_s13_q <= and_1560_s12_q;
      select_1562_s13_q <= select_1562_s12_q;
      and_1571_s13_q <= and_1571_s12_q;
      and_1573_s13_q <= and_1573_s12_q;
      select_1577_s13_q <= select_1577;
      or_1581_s13_q <= or_1581_s12_q;
      and_1599_s13_q <= moments_taken_q;
      right_2_s13_q <= right_2_s12_q;
      and_1684_s13_q <= and_1684_s12_q;
      and_1697_s13_q <= and_1697_s12_q;
      less_1698_s13_q <= less_1698_s12_q;
      equal_1699_s13_q <= equal_1699_s12_q;
      sum_1708_s13_q <= sum_1708[1];
      sum_1712_s13_q <= sum_1712;
      and_1731_s13_q <= and_1731_s12_q;
      select_1748_s13_q <= select_1748_s12_q;
      select_1774_s13_q <= select_1774_s12_q;
      equal_1776_s13_q <= equal_1776_s12_q;
      and_1781_s13_q <= and_1781_s12_q;
      and_1782_s13_q <= and_1782_s12_q;
      equal_1783_s13_q <= equal_1783_s12_q;
      not_1784_s13_q <= not_1784_s12_q;
      equal_1785_s13_q <= equal_1785_s12_q;
      not_1786_s13_q <= not_1786_s12_q;
      equal_1788_s13_q <= equal_1788_s12_q;
      or_1789_s13_q <= or_1789_s12_q;
      select_1813_s13_q <= select_1813_s12_q;
      select_1819_s13_q <= select_1819_s12_q;
      select_1857_s13_q <= select_1857_s12_q;
      patches_columns_above_rdata_s13_q <= patches_columns_above_rdata_s12_q[8];
      pixel_2_s13_q <= pixel_2_s12_q;
      less_1873_s13_q <= less_1873;
      new_row_s13_q <= new_row;
      select_1879_s13_q <= select_1879;
      not_1880_s13_q <= ~or_1874;
      select_1885_s13_q <= select_1885;
      or_1886_s13_q <= equal_1787_s12_q | equal_1785_s12_q;
      of_row_2_s13_q <= of_row_2;
      down_2_s13_q <= down_2;
      sum_1916_s13_q <= sum_1916_s12_q[0];
      sum_1917_s13_q <= sum_1917;
      and_1944_s13_q <= or_1789_s12_q & (or_1936 & (equal_1788_s12_q & and_1941));
      and_1955_s13_q <= and_1955;
      and_1958_s13_q <= or_1789_s12_q & (and_1955 & (patches_column_s12_q == 5'hf));
      less_1961_s13_q <= less_1961_s12_q;
      equal_1962_s13_q <= equal_1962_s12_q;
      not_1963_s13_q <= not_1963_s12_q;
      equal_1964_s13_q <= equal_1964_s12_q;
      not_1965_s13_q <= not_1965_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1993_s13_q <= sum_1993_s12_q;
      and_2014_s13_q <= and_2014_s12_q;
      seen_columns_rdata_s13_q <= seen_columns_rdata_q;
      and_2137_s13_q <= and_2137_s12_q;
      equal_2280_s13_q <= equal_2280_s12_q;
      equal_2469_s13_q <= equal_2469_s12_q;
      and_2596_s13_q <= and_2596_s12_q;
      equal_2681_s13_q <= equal_2681_s12_q;
      lower_s13_q <= lower;
      sum_2687_s13_q <= {7'h0, rise_s12_q} + xor_2686_s12_q;
      select_2765_s13_q <= select_2765;
      and_2993_s13_q <= and_2993_s12_q;
      less_3119_s13_q <= 4'he < patches_column_s12_q[4:1];
      equal_3546_s13_q <= equal_3546_s12_q;
      select_3550_s13_q <= select_3550;
      away_s13_q <= away;
      equal_3552_s13_q <= away == 6'h3f;
      equal_3561_s13_q <= away == 6'h1;
      select_3581_s13_q <= select_3581_s12_q;
      less_3872_s13_q <= less_3872_s12_q;
      equal_4091_s13_q <= equal_4091_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
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
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  // hls/stages/census.hpp:129
  logic [13:0] sum_529;
  assign sum_529 = select_525_s13_q + (equal_527_s13_q ? 14'h0 : averager_memory_rdata_s13_q[13:0]);
  logic [13:0] sum_533;
  assign sum_533 = sum_531_s13_q + (equal_527_s13_q ? 14'h0 : averager_memory_rdata_s13_q[27:14]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = equal_508_s13_q ? sample_present_s13_q : (sample_present_s13_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_508_s13_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:131
  logic and_541;
  assign and_541 = all_of_skin & (averager_memory_rdata_s13_q[29] | equal_527_s13_q);
  // hls/stages/agreement.hpp:788
  logic and_590;
  assign and_590 = not_574_s13_q & and_589_s13_q;
  // hls/stages/agreement.hpp:247
  logic and_633;
  assign and_633 = (and_607_s13_q & select_620_s13_q) & ({{22{sum_631_s13_q[9]}}, sum_631_s13_q} < 32'h3);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_1011;
  assign select_1011 = slot_s13_q[0] ? chosen_score_q : sum_1010_s13_q;
  // hls/stages/agreement.hpp:751
  logic [7:0] select_1510;
  assign select_1510 = less_1509_s13_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1511;
  assign less_1511 = select_1011 < select_1510;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1511 ? select_1510 : select_1011) : 8'h0;
  // hls/stages/agreement.hpp:720
  logic not_1517;
  assign not_1517 = ~slot_s13_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1518;
  assign select_1518 = less_1509_s13_q ? {slot_s13_q[0], not_1517} : 2'h0;
  logic [2:0] select_1520;
  assign select_1520 = less_1511 ? {select_1518, not_1517} : (slot_s13_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1547_s13_q : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1549;
  assign less_1549 = best_left_rdata_s13_q[39:33] < of_near;
  // hls/stages/agreement.hpp:1128
  logic equal_1606;
  assign equal_1606 = x_s13_q[6:4] == 3'h7;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s13_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:211
  logic equal_1620;
  assign equal_1620 = x_s13_q[5:0] == 6'h3c;
  logic equal_1622;
  assign equal_1622 = x_s13_q[5:0] == 6'h3b;
  logic equal_1624;
  assign equal_1624 = x_s13_q[5:0] == 6'h36;
  logic equal_1626;
  assign equal_1626 = x_s13_q[5:0] == 6'h35;
  logic equal_1628;
  assign equal_1628 = x_s13_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_1632;
  assign and_1632 = (~equal_1622) & ((~equal_1624) & ((~equal_1626) & (~equal_1628)));
  // hls/stages/patches.hpp:374
  logic [1:0] select_1685;
  assign select_1685 = and_1684_s13_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1686;
  assign select_1686 = and_1684_s13_q ? patches_band_rows_number_s13_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1687;
  assign select_1687 = row_starts_s13_q ? {select_1686, select_1685[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1688;
  assign select_1688 = row_starts_s13_q ? select_1685 : patches_fetch_q;
  logic equal_1689;
  assign equal_1689 = select_1688 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1699_s13_q ? {sum_1712_s13_q, sum_1708_s13_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1796;
  assign select_1796 = row_starts_s13_q ? select_1686 : patches_band_q;
  // hls/stages/patches.hpp:354
  logic equal_1797;
  assign equal_1797 = {patches_choosing_band_s13_q, and_1697_s13_q} == {select_1796, select_1688[1]};
  // hls/stages/patches.hpp:472
  logic [11:0] sum_1898;
  assign sum_1898 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1899;
  assign sum_1899 = {{4{down_2_s13_q[10]}}, down_2_s13_q[10:2]} + {sum_1898[11], sum_1898};
  // hls/stages/patches.hpp:469
  logic [11:0] smooth;
  assign smooth = {sum_1917_s13_q, sum_1916_s13_q, patches_columns_above_rdata_s13_q} + {4'h0, pixel_2_s13_q};
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1980;
  assign select_1980 = so_s13_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1983;
  assign or_1983 = select_1980[7] | (~({select_1980[5], select_1980[3], select_1980[1]} == 3'h0));
  // hls/stages/agreement.hpp:1128
  logic not_1991;
  assign not_1991 = ~equal_1606;
  // hls/stages/agreement.hpp:1058
  logic or_1995;
  assign or_1995 = (~sum_1993_s13_q) | equal_1776_s13_q;
  // hls/stages/agreement.hpp:788
  logic and_1998;
  assign and_1998 = so_s13_q & (ends_cell_s13_q & (inside_v_s13_q & or_1995));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s13_q & (or_578_s13_q & (not_582_s13_q & and_607_s13_q));
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2078;
  assign select_2078 = inside_v_s13_q ? (sum_1993_s13_q ? select_1980 : {select_1980[6:0], 1'b0}) : select_1980;
  // hls/stages/agreement.hpp:1050
  logic or_2081;
  assign or_2081 = select_2078[7] | (~({select_2078[5], select_2078[3], select_2078[1]} == 3'h0));
  // hls/stages/agreement.hpp:276
  logic select_2193;
  assign select_2193 = sample_pair_whole_s13_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:239
  logic [7:0] select_2578;
  assign select_2578 = slot_s13_q[0] ? 8'h0 : sum_1010_s13_q;
  // hls/stages/agreement.hpp:751
  logic less_2579;
  assign less_2579 = select_2578 < select_1510;
  // hls/stages/agreement.hpp:788
  logic less_2585;
  assign less_2585 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2587;
  assign less_2587 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2685;
  assign difference_2685 = best_left_rdata_s13_q[16:9] - lower_s13_q;
  // hls/stages/agreement.hpp:788
  logic [10:0] select_2750;
  assign select_2750 = equal_573_s13_q ? registration_expected_q : (so_s13_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2765_s13_q[7]}}, select_2765_s13_q} - {sum_1712_s13_q[9], sum_1712_s13_q, sum_1708_s13_q};
  // hls/stages/patches.hpp:355
  logic not_3008;
  assign not_3008 = ~select_1688[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3010;
  assign select_3010 = sample_pair_whole_s13_q ? (equal_1689 ? select_1688 : {not_3008, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:185
  logic [10:0] select_3097;
  assign select_3097 = equal_1785_s13_q ? patches_down_values_0_q : (or_1789_s13_q ? down_2_s13_q : patches_down_values_0_q);
  logic [10:0] select_3099;
  assign select_3099 = or_1789_s13_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3101;
  assign select_3101 = equal_1783_s13_q ? patches_down_values_1_q : (equal_1785_s13_q ? patches_down_values_1_q : select_3099);
  // hls/stages/patches.hpp:557
  logic and_3554;
  assign and_3554 = less_1961_s13_q & (equal_3546_s13_q & equal_3552_s13_q);
  // hls/stages/patches.hpp:561
  logic select_3557;
  assign select_3557 = equal_1964_s13_q ? (less_1961_s13_q ? (not_1965_s13_q & and_3554) : and_3554) : and_3554;
  // hls/stages/patches.hpp:557
  logic and_3563;
  assign and_3563 = less_1961_s13_q & (equal_3546_s13_q & equal_3561_s13_q);
  // hls/stages/patches.hpp:561
  logic select_3566;
  assign select_3566 = equal_1964_s13_q ? (less_1961_s13_q ? (not_1965_s13_q & and_3563) : and_3563) : and_3563;
  // hls/stages/patches.hpp:554
  logic [6:0] sum_3570;
  assign sum_3570 = {away_s13_q[5], away_s13_q} + 7'h7d;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3873;
  assign sum_3873 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3882;
  assign select_3882 = equal_573_s13_q ? select_1980 : (so_s13_q ? (ends_cell_s13_q ? select_2078 : select_1980) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3896;
  assign select_3896 = equal_678_s13_q ? {difference_3894[7], difference_3894} : (less_3872_s13_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3898;
  assign select_3898 = and_548_s13_q ? (equal_2469_s13_q ? select_3896 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3900;
  assign select_3900 = equal_678_s13_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3902;
  assign select_3902 = and_548_s13_q ? (equal_2469_s13_q ? select_3900 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3904;
  assign select_3904 = sum_3873[7] ? {1'b1, sum_3873[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:352; read in stage 13, written in stage 15: 13 < 15 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = last_s13_q;
`ifndef SYNTHESIS
  logic census_memory_re;
  assign census_memory_re = s13_en & and_548_s13_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 8040 x 4, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 13, written in stage 14: 13 < 14 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:8039];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8040; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_572_s13_q;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s13_en & and_590;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:797; read in stage 13, written in stage 16: 13 < 16 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1885_s13_q, not_1880_s13_q, select_1879_s13_q};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s13_en & or_1886_s13_q;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:798; read in stage 13, written in stage 16: 13 < 16 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_s13_q;
`ifndef SYNTHESIS
  logic patches_left_codes_re;
  assign patches_left_codes_re = s13_en & (not_1784_s13_q & (new_row_s13_q & equal_1785_s13_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
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
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
    end else if (s13_en) begin
      sample_of_skin_q <= mask_s13_q;
      averager_running_mask_q <= sample_pair_whole_s13_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2193;
      chosen_score_q <= less_2579 ? select_1510 : select_2578;
      chosen_place_q <= less_2579 ? {select_1518, not_1517} : 3'h2;
      before_0_q <= select_2578;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2585) & (~less_2587);
      registration_expected_q <= select_2750;
      patches_band_q <= sample_pair_whole_s13_q ? select_1796 : patches_band_q;
      patches_fetch_q <= select_3010;
      patches_down_values_0_q <= equal_1783_s13_q ? patches_down_values_0_q : select_3097;
      patches_down_values_1_q <= select_3101;
      region_columns_q <= select_3882;
      region_down_rest_q <= select_3898;
      region_down_back_q <= select_3902;
      region_down_next_q <= select_3904;
    end
  end

  logic [7:0] pixel_0_s14_q;
  logic [7:0] pixel_1_s14_q;
  logic saturated_s14_q;
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
  logic [7:0] before_0_s14_q;
  logic [7:0] before_1_s14_q;
  logic [7:0] before_2_s14_q;
  logic shift_not_right_s14_q;
  logic [4:0] patches_choosing_band_s14_q;
  logic patches_lower_s14_q;
  logic patches_second_s14_q;
  logic [4:0] patches_code_row_s14_q;
  logic [10:0] patches_down_values_1_s14_q;
  logic [4:0] patches_along_s14_q;
  logic patches_summed_last_s14_q;
  logic [4:0] patches_summed_down_by_s14_q;
  logic [9:0] patches_read_row_differing_s14_q;
  logic patches_read_first_s14_q;
  logic [3:0] select_507_s14_q;
  logic row_starts_s14_q;
  logic [8:0] select_512_s14_q;
  logic and_521_s14_q;
  logic and_522_s14_q;
  logic [13:0] sum_529_s14_q;
  logic [13:0] sum_533_s14_q;
  logic and_537_s14_q;
  logic and_541_s14_q;
  logic [6:0] select_542_s14_q;
  logic [6:0] last_s14_q;
  logic and_546_s14_q;
  logic and_548_s14_q;
  logic equal_551_s14_q;
  logic equal_568_s14_q;
  logic [12:0] select_572_s14_q;
  logic equal_573_s14_q;
  logic not_574_s14_q;
  logic so_s14_q;
  logic not_576_s14_q;
  logic equal_577_s14_q;
  logic or_578_s14_q;
  logic less_581_s14_q;
  logic not_582_s14_q;
  logic inside_v_s14_q;
  logic not_586_s14_q;
  logic and_590_s14_q;
  logic and_599_s14_q;
  logic [6:0] x_s14_2_q;
  logic [32:0] best_left_rdata_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic and_633_s14_q;
  logic and_638_s14_q;
  logic and_643_s14_q;
  logic and_645_s14_q;
  logic equal_678_s14_q;
  logic select_760_s14_q;
  logic [7:0] of_best_s14_q;
  logic [2:0] select_1520_s14_q;
  logic [6:0] of_near_s14_q;
  logic [6:0] select_1550_s14_q;
  logic [5:0] select_1552_s14_q;
  logic [7:0] select_1555_s14_q;
  logic [7:0] select_1558_s14_q;
  logic and_1560_s14_q;
  logic select_1562_s14_q;
  logic or_1568_s14_q;
  logic and_1571_s14_q;
  logic and_1573_s14_q;
  logic [1:0] shown_right_rdata_s14_q;
  logic [6:0] select_1577_s14_q;
  logic and_1582_s14_q;
  logic [1:0] left_turns_rdata_s14_q;
  logic and_1599_s14_q;
  logic [1:0] right_turns_rdata_s14_q;
  logic equal_1606_s14_q;
  logic all_s14_q;
  logic equal_1620_s14_q;
  logic equal_1622_s14_q;
  logic equal_1624_s14_q;
  logic equal_1626_s14_q;
  logic equal_1628_s14_q;
  logic and_1633_s14_q;
  logic right_2_s14_q;
  logic [5:0] select_1687_s14_q;
  logic select_1688_s14_q;
  logic equal_1689_s14_q;
  logic and_1697_s14_q;
  logic less_1698_s14_q;
  logic equal_1699_s14_q;
  logic expected_s14_q;
  logic [10:0] sum_1714_s14_q;
  logic and_1731_s14_q;
  logic [5:0] select_1748_s14_q;
  logic [7:0] select_1774_s14_q;
  logic and_1781_s14_q;
  logic and_1782_s14_q;
  logic equal_1783_s14_q;
  logic equal_1785_s14_q;
  logic equal_1788_s14_q;
  logic or_1789_s14_q;
  logic and_1798_s14_q;
  logic [4:0] select_1813_s14_q;
  logic select_1819_s14_q;
  logic [3:0] select_1857_s14_q;
  logic less_1873_s14_q;
  logic new_row_s14_q;
  logic or_1886_s14_q;
  logic [1:0] of_row_2_s14_q;
  logic [1:0] down_2_s14_q;
  logic [12:0] sum_1899_s14_q;
  logic [11:0] smooth_s14_q;
  logic and_1946_s14_q;
  logic and_1955_s14_q;
  logic and_1960_s14_q;
  logic less_1961_s14_q;
  logic equal_1962_s14_q;
  logic not_1963_s14_q;
  logic equal_1964_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic or_1983_s14_q;
  logic or_1986_s14_q;
  logic or_1989_s14_q;
  logic not_1991_s14_q;
  logic select_1999_s14_q;
  logic textured_s14_q;
  logic and_2014_s14_q;
  logic and_2023_s14_q;
  logic [12:0] seen_columns_rdata_s14_q;
  logic and_2064_s14_q;
  logic and_2066_s14_q;
  logic or_2081_s14_q;
  logic or_2084_s14_q;
  logic or_2087_s14_q;
  logic and_2098_s14_q;
  logic and_2114_s14_q;
  logic and_2137_s14_q;
  logic equal_2280_s14_q;
  logic equal_2469_s14_q;
  logic and_2596_s14_q;
  logic and_2620_s14_q;
  logic equal_2681_s14_q;
  logic [5:0] difference_2685_s14_q;
  logic [7:0] sum_2687_s14_q;
  logic [11:0] select_2768_s14_q;
  logic and_2993_s14_q;
  logic less_3119_s14_q;
  logic equal_3462_s14_q;
  logic [4:0] select_3550_s14_q;
  logic select_3557_s14_q;
  logic select_3566_s14_q;
  logic and_3572_s14_q;
  logic [14:0] select_3581_s14_q;
  logic less_3872_s14_q;
  logic sum_3873_s14_q;
  logic select_3915_s14_q;
  logic equal_3926_s14_q;
  logic equal_3965_s14_q;
  logic and_4081_s14_q;
  logic equal_4091_s14_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s14_q <= sample_pair_pixel_0_q;
      pixel_1_s14_q <= sample_pair_pixel_1_q;
      saturated_s14_q <= saturated_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_pixel_0_s14_q <= sample_pair_pixel_0_s13_q;
      sample_pair_pixel_1_s14_q <= sample_pair_pixel_1_s13_q;
      sample_pair_whole_s14_q <= sample_pair_whole_s13_q;
      sample_present_s14_q <= sample_present_s13_q;
      moments_starts_s14_q <= moments_starts_s13_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      age_s14_q <= age_s13_q;
      slot_s14_q <= slot_s13_q;
      ends_cell_s14_q <= ends_cell_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      before_0_s14_q <= before_0_q;
      before_1_s14_q <= before_1_q;
      before_2_s14_q <= before_2_q;
      shift_not_right_s14_q <= shift_not_right_s13_q;
      patches_choosing_band_s14_q <= patches_choosing_band_s13_q;
      patches_lower_s14_q <= patches_lower_s13_q;
      patches_second_s14_q <= patches_second_s13_q;
      patches_code_row_s14_q <= patches_code_row_s13_q;
      patches_down_values_1_s14_q <= patches_down_values_1_q;
      patches_along_s14_q <= patches_along_s13_q;
      patches_summed_last_s14_q <= patches_summed_last_s13_q;
      patches_summed_down_by_s14_q <= patches_summed_down_by_s13_q;
      patches_read_row_differing_s14_q <= patches_read_row_differing_s13_q;
      patches_read_first_s14_q <= patches_read_first_s13_q;
      select_507_s14_q <= select_507_s13_q;
      row_starts_s14_q <= row_starts_s13_q;
      select_512_s14_q <= select_512_s13_q;
      and_521_s14_q <= and_521_s13_q;
      and_522_s14_q <= and_522_s13_q;
      sum_529_s14_q <= sum_529;
      sum_533_s14_q <= sum_533;
      and_537_s14_q <= whole & (averager_memory_rdata_s13_q[28] | equal_527_s13_q);
      and_541_s14_q <= and_541;
      select_542_s14_q <= select_542_s13_q;
      last_s14_q <= last_s13_q;
      and_546_s14_q <= and_546_s13_q;
      and_548_s14_q <= and_548_s13_q;
      equal_551_s14_q <= select_507_s13_q == 4'h3;
      equal_568_s14_q <= equal_568_s13_q;
      select_572_s14_q <= select_572_s13_q;
      equal_573_s14_q <= equal_573_s13_q;
      not_574_s14_q <= not_574_s13_q;
      so_s14_q <= so_s13_q;
      not_576_s14_q <= not_576_s13_q;
      equal_577_s14_q <= equal_577_s13_q;
      or_578_s14_q <= or_578_s13_q;
      less_581_s14_q <= less_581_s13_q;
      not_582_s14_q <= not_582_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      not_586_s14_q <= not_586_s13_q;
      and_590_s14_q <= and_590;
      and_599_s14_q <= and_599_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[32:0];
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      and_633_s14_q <= and_633;
      and_638_s14_q <= and_638_s13_q;
      and_643_s14_q <= and_643_s13_q;
      and_645_s14_q <= and_645_s13_q;
      equal_678_s14_q <= equal_678_s13_q;
      select_760_s14_q <= select_760_s13_q;
      of_best_s14_q <= of_best;
      select_1520_s14_q <= select_1520;
      of_near_s14_q <= of_near;
      select_1550_s14_q <= less_1549 ? of_near : best_left_rdata_s13_q[39:33];
      select_1552_s14_q <= less_1549 ? run_shift_s13_q : best_left_rdata_s13_q[45:40];
      select_1555_s14_q <= select_1555_s13_q;
      select_1558_s14_q <= select_1558_s13_q;
      and_1560_s14_q <= and_1560_s13_q;
      select_1562_s14_q <= select_1562_s13_q;
      or_1568_s14_q <= select_1562_s13_q | (best_right_rdata_s13_q[21:15] < of_near);
      and_1571_s14_q <= and_1571_s13_q;
      and_1573_s14_q <= and_1573_s13_q;
      shown_right_rdata_s14_q <= shown_right_rdata_q;
      select_1577_s14_q <= select_1577_s13_q;
      and_1582_s14_q <= and_633 & or_1581_s13_q;
      left_turns_rdata_s14_q <= left_turns_rdata_q;
      and_1599_s14_q <= and_1599_s13_q;
      right_turns_rdata_s14_q <= right_turns_rdata_q;
      equal_1606_s14_q <= equal_1606;
      all_s14_q <= all;
      equal_1620_s14_q <= equal_1620;
      equal_1622_s14_q <= equal_1622;
      equal_1624_s14_q <= equal_1624;
      equal_1626_s14_q <= equal_1626;
      equal_1628_s14_q <= equal_1628;
      and_1633_s14_q <= (~equal_1620) & and_1632;
      right_2_s14_q <= right_2_s13_q;
      select_1687_s14_q <= select_1687;
      select_1688_s14_q <= select_1688[1];
      equal_1689_s14_q <= equal_1689;
      and_1697_s14_q <= and_1697_s13_q;
      less_1698_s14_q <= less_1698_s13_q;
      equal_1699_s14_q <= equal_1699_s13_q;
      expected_s14_q <= expected[0];
      sum_1714_s14_q <= {expected[10], expected[10:1]} + 11'h5;
      and_1731_s14_q <= and_1731_s13_q;
      select_1748_s14_q <= select_1748_s13_q;
      select_1774_s14_q <= select_1774_s13_q;
      and_1781_s14_q <= and_1781_s13_q;
      and_1782_s14_q <= and_1782_s13_q;
      equal_1783_s14_q <= equal_1783_s13_q;
      equal_1785_s14_q <= equal_1785_s13_q;
      equal_1788_s14_q <= equal_1788_s13_q;
      or_1789_s14_q <= or_1789_s13_q;
      and_1798_s14_q <= and_1782_s13_q & equal_1797;
      select_1813_s14_q <= select_1813_s13_q;
      select_1819_s14_q <= select_1819_s13_q;
      select_1857_s14_q <= select_1857_s13_q;
      less_1873_s14_q <= less_1873_s13_q;
      new_row_s14_q <= new_row_s13_q;
      or_1886_s14_q <= or_1886_s13_q;
      of_row_2_s14_q <= of_row_2_s13_q;
      down_2_s14_q <= down_2_s13_q[1:0];
      sum_1899_s14_q <= sum_1899;
      smooth_s14_q <= smooth;
      and_1946_s14_q <= not_1784_s13_q & (not_1786_s13_q & and_1944_s13_q);
      and_1955_s14_q <= and_1955_s13_q;
      and_1960_s14_q <= not_1784_s13_q & (not_1786_s13_q & and_1958_s13_q);
      less_1961_s14_q <= less_1961_s13_q;
      equal_1962_s14_q <= equal_1962_s13_q;
      not_1963_s14_q <= not_1963_s13_q;
      equal_1964_s14_q <= equal_1964_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      or_1983_s14_q <= or_1983;
      or_1986_s14_q <= select_1980[7] | (~({select_1980[6], select_1980[3:2]} == 3'h0));
      or_1989_s14_q <= select_1980[7] | (~(select_1980[6:4] == 3'h0));
      not_1991_s14_q <= not_1991;
      select_1999_s14_q <= equal_573_s13_q ? (x_s13_q[6] & not_1991) : and_1998;
      textured_s14_q <= textured;
      and_2014_s14_q <= and_2014_s13_q;
      and_2023_s14_q <= not_574_s13_q & and_1998;
      seen_columns_rdata_s14_q <= {seen_columns_rdata_s13_q[13:7], seen_columns_rdata_s13_q[5:0]};
      and_2064_s14_q <= seen_columns_rdata_s13_q[14] & inside_v_s13_q;
      and_2066_s14_q <= seen_columns_rdata_s13_q[5] & inside_v_s13_q;
      or_2081_s14_q <= or_2081;
      or_2084_s14_q <= select_2078[7] | (~({select_2078[6], select_2078[3:2]} == 3'h0));
      or_2087_s14_q <= select_2078[7] | (~(select_2078[6:4] == 3'h0));
      and_2098_s14_q <= seen_columns_rdata_s13_q[16] & inside_v_s13_q;
      and_2114_s14_q <= seen_columns_rdata_s13_q[17] & inside_v_s13_q;
      and_2137_s14_q <= and_2137_s13_q;
      equal_2280_s14_q <= equal_2280_s13_q;
      equal_2469_s14_q <= equal_2469_s13_q;
      and_2596_s14_q <= and_2596_s13_q;
      and_2620_s14_q <= seen_columns_rdata_s13_q[15] & inside_v_s13_q;
      equal_2681_s14_q <= equal_2681_s13_q;
      difference_2685_s14_q <= difference_2685[7:2];
      sum_2687_s14_q <= sum_2687_s13_q;
      select_2768_s14_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_2993_s14_q <= and_2993_s13_q;
      less_3119_s14_q <= less_3119_s13_q;
      equal_3462_s14_q <= patches_match_row_s13_q == 4'h0;
      select_3550_s14_q <= select_3550_s13_q;
      select_3557_s14_q <= select_3557;
      select_3566_s14_q <= select_3566;
      and_3572_s14_q <= equal_3546_s13_q & ({sum_3570[6], sum_3570} < 8'hfb);
      select_3581_s14_q <= select_3581_s13_q;
      less_3872_s14_q <= less_3872_s13_q;
      sum_3873_s14_q <= sum_3873[7];
      select_3915_s14_q <= sum_1993_s13_q ? (equal_1776_s13_q & or_1995) : or_1995;
      equal_3926_s14_q <= x_s13_q[6:3] == 4'h7;
      equal_3965_s14_q <= x_s13_q[6:3] == 4'h6;
      and_4081_s14_q <= seen_columns_rdata_s13_q[6] & inside_v_s13_q;
      equal_4091_s14_q <= equal_4091_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
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
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic region_fresh_q;
  logic segment_starts_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_521_s14_q ? sum_529_s14_q[13:5] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_551_s14_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_521_s14_q ? sum_533_s14_q[13:5] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_551_s14_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:218
  logic and_559;
  assign and_559 = and_521_s14_q & and_537_s14_q;
  // hls/stages/census.hpp:134
  logic select_561;
  assign select_561 = equal_551_s14_q ? and_559 : (averager_mask_q & and_559);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s14_q & select_561;
  // hls/stages/census.hpp:218
  logic and_563;
  assign and_563 = and_521_s14_q & and_541_s14_q;
  // hls/stages/census.hpp:134
  logic select_565;
  assign select_565 = equal_551_s14_q ? and_563 : (averager_of_skin_q & and_563);
  // hls/stages/agreement.hpp:149
  logic and_635;
  assign and_635 = or_578_s14_q & (not_582_s14_q & and_633_s14_q);
  // hls/stages/moments.hpp:77
  logic and_636;
  assign and_636 = and_599_s14_q & and_635;
  // hls/stages/agreement.hpp:810
  logic equal_1523;
  assign equal_1523 = select_1520_s14_q == 3'h1;
  logic or_1526;
  assign or_1526 = equal_1523 | (~(select_1520_s14_q == 3'h2));
  logic [7:0] select_1528;
  assign select_1528 = or_1526 ? before_0_s14_q : before_1_s14_q;
  logic [7:0] select_1529;
  assign select_1529 = equal_1523 ? (or_1526 ? before_1_q : {7'h0, shift_not_right_s14_q}) : select_1528;
  // hls/stages/agreement.hpp:811
  logic [7:0] select_1532;
  assign select_1532 = equal_1523 ? select_1528 : (or_1526 ? before_2_q : before_2_s14_q);
  // hls/stages/agreement.hpp:824
  logic or_1564;
  assign or_1564 = select_1562_s14_q | (best_right_rdata_s14_q[7:0] < of_best_s14_q);
  // hls/stages/agreement.hpp:149
  logic and_1584;
  assign and_1584 = or_578_s14_q & (not_582_s14_q & and_1582_s14_q);
  // hls/stages/agreement.hpp:788
  logic and_1588;
  assign and_1588 = not_574_s14_q & (so_s14_q ? and_1571_s14_q : (equal_577_s14_q & and_635));
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s14_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1609;
  assign select_1609 = x_s14_q[4] ? {x_s14_q[3], x_s14_q[0]} : {x_s14_q[0], x_s14_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1611;
  assign select_1611 = equal_1606_s14_q ? {2'h0, quarter} : (all_s14_q ? {1'b0, x_s14_q[2:0]} : {x_s14_q[2:1], select_1609});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1612;
  assign sum_1612 = slot_s14_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1613;
  assign select_1613 = equal_573_s14_q ? select_1611 : {sum_1612, lower_half_s14_q, registration_of_right_q};
  // hls/stages/patches.hpp:211
  logic equal_1614;
  assign equal_1614 = x_s14_q[5:0] == 6'h3f;
  logic equal_1616;
  assign equal_1616 = x_s14_q[5:0] == 6'h3e;
  logic equal_1618;
  assign equal_1618 = x_s14_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1178
  logic and_1636;
  assign and_1636 = (~equal_1614) & ((~equal_1616) & ((~equal_1618) & and_1633_s14_q));
  // hls/stages/agreement.hpp:1129
  logic less_1637;
  assign less_1637 = x_s14_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s14_q ? {1'b0, x_s14_q[2]} : x_s14_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1641;
  assign or_1641 = (kind == 2'h3) | (x_s14_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s14_q ? (right_2_s14_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1652;
  assign sum_1652 = {2'h0, slot_s14_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1658;
  assign not_1658 = ~lower_half_s14_q;
  logic [3:0] select_1659;
  assign select_1659 = registration_of_right_q ? {lower_half_s14_q, 1'b0, not_1658, 1'b0} : {1'b0, lower_half_s14_q, 1'b0, not_1658};
  // hls/stages/patches.hpp:98
  logic less_1715;
  assign less_1715 = {{4{sum_1714_s14_q[10]}}, sum_1714_s14_q, expected_s14_q} < 16'h15;
  // hls/stages/patches.hpp:472
  logic [13:0] sum_1900;
  assign sum_1900 = {{3{patches_down_values_1_s14_q[10]}}, patches_down_values_1_s14_q} + {sum_1899_s14_q, down_2_s14_q[1]};
  logic [12:0] sum_1901;
  assign sum_1901 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1900[13:1];
  // hls/stages/patches.hpp:471
  logic [12:0] sum_1919;
  assign sum_1919 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s14_q[11:1]};
  logic [12:0] sum_1920;
  assign sum_1920 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1921;
  assign difference_1921 = {1'b0, sum_1919, smooth_s14_q[0]} - {1'b0, sum_1920, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1990;
  assign select_1990 = equal_573_s14_q ? x_s14_q[5:0] : {region_row_q, or_1989_s14_q, or_1986_s14_q, or_1983_s14_q};
  // hls/stages/agreement.hpp:149
  logic and_2016;
  assign and_2016 = or_578_s14_q & (not_582_s14_q & and_2014_s14_q);
  // hls/stages/agreement.hpp:1014
  logic select_2026;
  assign select_2026 = slot_s14_q[2] ? shown_shown_q : and_635;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s14_q & (shown_right_rdata_s14_q[0] | select_2026);
  // hls/stages/agreement.hpp:1014
  logic select_2029;
  assign select_2029 = slot_s14_q[2] ? shown_nearer_q : and_1584;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s14_q & (select_2026 ? select_2029 : shown_right_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2171;
  assign select_2171 = sample_pair_whole_s14_q ? (and_546_s14_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2173;
  assign select_2173 = sample_pair_whole_s14_q ? (and_546_s14_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2195;
  assign select_2195 = sample_pair_whole_s14_q ? (and_546_s14_q ? select_561 : averager_mask_q) : averager_mask_q;
  logic select_2197;
  assign select_2197 = sample_pair_whole_s14_q ? (and_546_s14_q ? select_565 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:788
  logic and_2600;
  assign and_2600 = not_574_s14_q & (so_s14_q & (ends_cell_s14_q & (inside_v_s14_q & and_2596_s14_q)));
  // hls/stages/agreement.hpp:1105
  logic not_2619;
  assign not_2619 = ~(x_s14_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:788
  logic and_2661;
  assign and_2661 = so_s14_q & (ends_cell_s14_q & (inside_v_s14_q & (and_2596_s14_q & and_2016)));
  // hls/stages/agreement.hpp:1110
  logic and_2666;
  assign and_2666 = not_2619 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:247
  logic and_2690;
  assign and_2690 = ((and_2014_s14_q & and_633_s14_q) & equal_2681_s14_q) & (~({2'h0, difference_2685_s14_q} < sum_2687_s14_q));
  // hls/stages/agreement.hpp:149
  logic and_2700;
  assign and_2700 = not_582_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2702;
  assign and_2702 = not_582_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2703;
  assign select_2703 = or_578_s14_q ? {and_2702, and_2700} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2705;
  assign select_2705 = less_581_s14_q ? 2'h0 : (slot_s14_q[2] ? right_turns_rdata_s14_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2706;
  assign select_2706 = or_578_s14_q ? select_2705 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2751;
  assign equal_2751 = slot_s14_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2768_s14_q[11:7])) ? 12'h7f : select_2768_s14_q;
  // hls/stages/agreement.hpp:788
  logic select_2812;
  assign select_2812 = so_s14_q ? (equal_2751 ? right_2_s14_q : registration_of_right_q) : registration_of_right_q;
  logic select_2815;
  assign select_2815 = so_s14_q ? (equal_1699_s14_q ? inside_v_s14_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all_s14_q ? x_s14_q[1:0] : select_1609;
  // hls/stages/patches.hpp:185
  logic [11:0] select_3085;
  assign select_3085 = equal_1785_s14_q ? patches_smooth_values_0_q : (or_1789_s14_q ? smooth_s14_q : patches_smooth_values_0_q);
  logic [11:0] select_3087;
  assign select_3087 = or_1789_s14_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3089;
  assign select_3089 = equal_1783_s14_q ? patches_smooth_values_1_q : (equal_1785_s14_q ? patches_smooth_values_1_q : select_3087);
  logic [11:0] select_3090;
  assign select_3090 = or_1789_s14_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3092;
  assign select_3092 = equal_1783_s14_q ? patches_smooth_values_2_q : (equal_1785_s14_q ? patches_smooth_values_2_q : select_3090);
  logic [11:0] select_3093;
  assign select_3093 = or_1789_s14_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3095;
  assign select_3095 = equal_1783_s14_q ? patches_smooth_values_3_q : (equal_1785_s14_q ? patches_smooth_values_3_q : select_3093);
  logic [10:0] select_3102;
  assign select_3102 = or_1789_s14_q ? patches_down_values_1_s14_q : patches_down_values_2_q;
  logic [10:0] select_3104;
  assign select_3104 = equal_1783_s14_q ? patches_down_values_2_q : (equal_1785_s14_q ? patches_down_values_2_q : select_3102);
  logic [10:0] select_3105;
  assign select_3105 = or_1789_s14_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3107;
  assign select_3107 = equal_1783_s14_q ? patches_down_values_3_q : (equal_1785_s14_q ? patches_down_values_3_q : select_3105);
  // hls/stages/patches.hpp:561
  logic select_3559;
  assign select_3559 = less_1961_s14_q ? (not_1963_s14_q & select_3557_s14_q) : select_3557_s14_q;
  logic select_3568;
  assign select_3568 = less_1961_s14_q ? (not_1963_s14_q & select_3566_s14_q) : select_3566_s14_q;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3574;
  assign select_3574 = less_1961_s14_q ? (and_3572_s14_q ? patches_rows_rdata_s14_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3585;
  assign select_3585 = patches_read_above_q ? patches_read_row_differing_s14_q : patches_peak_above_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3587;
  assign select_3587 = patches_read_below_q ? patches_read_row_differing_s14_q : patches_peak_below_q;
  // hls/stages/patches.hpp:580
  logic less_3624;
  assign less_3624 = select_3585 < select_3587;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3624 ? select_3587 : select_3585;
  logic [9:0] low;
  assign low = (select_3587 < select_3585) ? select_3587 : select_3585;
  // hls/stages/agreement.hpp:788
  logic select_3869;
  assign select_3869 = equal_573_s14_q ? shown_shown_q : (so_s14_q ? select_2026 : shown_shown_q);
  logic select_3871;
  assign select_3871 = equal_573_s14_q ? shown_nearer_q : (so_s14_q ? select_2029 : shown_nearer_q);
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3875;
  assign select_3875 = less_3872_s14_q ? (sum_3873_s14_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3877;
  assign select_3877 = equal_2469_s14_q ? (equal_678_s14_q ? 3'h0 : select_3875) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3873_s14_q;
  // hls/stages/agreement.hpp:460
  logic select_3908;
  assign select_3908 = equal_2469_s14_q ? (equal_678_s14_q | (less_3872_s14_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3913;
  assign or_3913 = segment_starts_q | not_576_s14_q;
  // hls/stages/agreement.hpp:788
  logic select_3917;
  assign select_3917 = ends_cell_s14_q ? (inside_v_s14_q ? select_3915_s14_q : or_3913) : or_3913;
  // hls/stages/agreement.hpp:1217
  logic equal_3946;
  assign equal_3946 = x_s14_q[6:3] == 4'ha;
  logic equal_3950;
  assign equal_3950 = x_s14_q[6:3] == 4'h9;
  logic equal_3951;
  assign equal_3951 = x_s14_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3967;
  assign select_3967 = equal_3926_s14_q ? cfg_unproven_limit_i : (equal_3965_s14_q ? cfg_explained_limit_i : cfg_regions_limit_i);
  logic [7:0] select_3969;
  assign select_3969 = equal_3950 ? cfg_hidden_limit_i : (equal_3951 ? cfg_unproven_skin_limit_i : select_3967);
  // hls/stages/agreement.hpp:788
  logic select_4079;
  assign select_4079 = so_s14_q ? (ends_cell_s14_q ? and_2066_s14_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4083;
  assign select_4083 = so_s14_q ? (ends_cell_s14_q ? and_4081_s14_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4085;
  assign select_4085 = ends_cell_s14_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4087;
  assign select_4087 = equal_573_s14_q ? centres_values_1_textured_q : (so_s14_q ? select_4085 : centres_values_1_textured_q);
  logic select_4088;
  assign select_4088 = ends_cell_s14_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4090;
  assign select_4090 = equal_573_s14_q ? centres_values_1_of_skin_q : (so_s14_q ? select_4088 : centres_values_1_of_skin_q);

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:768; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1687_s14_q;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s14_en & (sample_pair_whole_s14_q & (~equal_1689_s14_q));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1398; read in stage 14, written in stage 17: 14 < 17 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1990;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s14_en & select_1999_s14_q;
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_512_s14_q;
  logic averager_memory_we;
  assign averager_memory_we = s14_en & and_522_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_541_s14_q, and_537_s14_q, sum_533_s14_q, sum_529_s14_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s12_sim;
  logic averager_memory_re_s12_sim;
  logic [8:0] averager_memory_raddr_s13_sim;
  logic averager_memory_re_s13_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s12_sim <= 1'b0;
      averager_memory_re_s13_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s12_sim <= averager_memory_re;
      averager_memory_raddr_s12_sim <= averager_memory_raddr;
      averager_memory_re_s13_sim <= averager_memory_re_s12_sim;
      averager_memory_raddr_s13_sim <= averager_memory_raddr_s12_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s12_sim && averager_memory_raddr_s12_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s13_sim && averager_memory_raddr_s13_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory moments_memory, write
  logic [12:0] moments_memory_waddr;
  assign moments_memory_waddr = select_572_s14_q;
  logic moments_memory_we;
  assign moments_memory_we = s14_en & and_590_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_645_s14_q, and_643_s14_q, and_638_s14_q, and_636};
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
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
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
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s14_en) begin
      averager_mask_q <= select_2195;
      averager_of_skin_q <= select_2197;
      registration_of_right_q <= equal_573_s14_q ? registration_of_right_q : select_2812;
      registration_was_inside_q <= equal_573_s14_q ? registration_was_inside_q : select_2815;
      patches_smooth_values_0_q <= equal_1783_s14_q ? patches_smooth_values_0_q : select_3085;
      patches_smooth_values_1_q <= select_3089;
      patches_smooth_values_2_q <= select_3092;
      patches_smooth_values_3_q <= select_3095;
      patches_down_values_2_q <= select_3104;
      patches_down_values_3_q <= select_3107;
      patches_read_above_q <= equal_1783_s14_q ? select_3559 : patches_read_above_q;
      patches_read_below_q <= equal_1783_s14_q ? select_3568 : patches_read_below_q;
      patches_peak_above_q <= equal_1783_s14_q ? select_3585 : patches_peak_above_q;
      patches_peak_below_q <= equal_1783_s14_q ? select_3587 : patches_peak_below_q;
      shown_shown_q <= select_3869;
      shown_nearer_q <= select_3871;
      region_row_q <= and_548_s14_q ? select_3877 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_548_s14_q ? select_3908 : region_fresh_q;
      segment_starts_q <= equal_573_s14_q ? or_3913 : (so_s14_q ? select_3917 : or_3913);
      centres_values_0_textured_q <= equal_573_s14_q ? centres_values_0_textured_q : select_4079;
      centres_values_0_of_skin_q <= equal_573_s14_q ? centres_values_0_of_skin_q : select_4083;
      centres_values_1_textured_q <= select_4087;
      centres_values_1_of_skin_q <= select_4090;
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
    if (s14_en) begin
      averager_total_0_q <= select_2171;
      averager_total_1_q <= select_2173;
    end
  end

  logic [7:0] pixel_0_s15_q;
  logic [7:0] pixel_1_s15_q;
  logic saturated_s15_q;
  logic mask_s15_q;
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
  logic [10:0] patches_down_values_3_s15_q;
  logic [4:0] patches_along_s15_q;
  logic patches_summed_last_s15_q;
  logic [4:0] patches_summed_down_by_s15_q;
  logic patches_read_first_s15_q;
  logic [2:0] region_row_s15_q;
  logic region_fresh_s15_q;
  logic centres_values_1_textured_s15_q;
  logic centres_values_1_of_skin_s15_q;
  logic [3:0] select_507_s15_q;
  logic row_starts_s15_q;
  logic [6:0] select_542_s15_q;
  logic [6:0] last_s15_q;
  logic and_546_s15_q;
  logic and_548_s15_q;
  logic [77:0] census_memory_rdata_s15_q;
  logic [8:0] grey_s15_q;
  logic equal_551_s15_q;
  logic [8:0] select_554_s15_q;
  logic [8:0] grey_2_s15_q;
  logic [8:0] select_558_s15_q;
  logic whole_2_s15_q;
  logic and_566_s15_q;
  logic equal_568_s15_q;
  logic equal_573_s15_q;
  logic not_574_s15_q;
  logic so_s15_q;
  logic not_576_s15_q;
  logic equal_577_s15_q;
  logic inside_v_s15_q;
  logic not_586_s15_q;
  logic [3:0] moments_memory_rdata_s15_q;
  logic [6:0] x_s15_2_q;
  logic [32:0] best_left_rdata_s15_q;
  logic [6:0] right_s15_q;
  logic [14:0] best_right_rdata_s15_q;
  logic and_635_s15_q;
  logic and_638_s15_q;
  logic and_645_s15_q;
  logic equal_678_s15_q;
  logic [7:0] of_best_s15_q;
  logic or_1515_s15_q;
  logic [2:0] select_1520_s15_q;
  logic [7:0] select_1529_s15_q;
  logic [7:0] select_1532_s15_q;
  logic [6:0] select_1551_s15_q;
  logic [5:0] select_1553_s15_q;
  logic [7:0] select_1556_s15_q;
  logic [7:0] select_1559_s15_q;
  logic and_1560_s15_q;
  logic or_1564_s15_q;
  logic [6:0] select_1569_s15_q;
  logic [6:0] select_1570_s15_q;
  logic and_1573_s15_q;
  logic [6:0] select_1577_s15_q;
  logic and_1584_s15_q;
  logic and_1588_s15_q;
  logic and_1599_s15_q;
  logic equal_1606_s15_q;
  logic [1:0] quarter_s15_q;
  logic all_s15_q;
  logic [1:0] sum_1612_s15_q;
  logic [3:0] select_1613_s15_q;
  logic equal_1614_s15_q;
  logic equal_1616_s15_q;
  logic equal_1618_s15_q;
  logic equal_1620_s15_q;
  logic equal_1622_s15_q;
  logic equal_1624_s15_q;
  logic equal_1626_s15_q;
  logic equal_1628_s15_q;
  logic less_1637_s15_q;
  logic or_1641_s15_q;
  logic select_1644_s15_q;
  logic and_1654_s15_q;
  logic [3:0] select_1659_s15_q;
  logic select_1688_s15_q;
  logic equal_1689_s15_q;
  logic and_1697_s15_q;
  logic equal_1699_s15_q;
  logic and_1732_s15_q;
  logic [5:0] select_1748_s15_q;
  logic [7:0] select_1774_s15_q;
  logic and_1781_s15_q;
  logic and_1782_s15_q;
  logic equal_1783_s15_q;
  logic equal_1785_s15_q;
  logic equal_1788_s15_q;
  logic or_1789_s15_q;
  logic and_1798_s15_q;
  logic [4:0] select_1813_s15_q;
  logic select_1819_s15_q;
  logic [3:0] select_1857_s15_q;
  logic less_1873_s15_q;
  logic new_row_s15_q;
  logic or_1886_s15_q;
  logic [27:0] patches_right_codes_rdata_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic down_2_s15_q;
  logic sum_1900_s15_q;
  logic [12:0] sum_1901_s15_q;
  logic [14:0] difference_1921_s15_q;
  logic and_1946_s15_q;
  logic [47:0] patches_left_codes_rdata_s15_q;
  logic and_1955_s15_q;
  logic and_1960_s15_q;
  logic less_1961_s15_q;
  logic equal_1962_s15_q;
  logic not_1963_s15_q;
  logic equal_1964_s15_q;
  logic or_1983_s15_q;
  logic or_1986_s15_q;
  logic or_1989_s15_q;
  logic not_1991_s15_q;
  logic textured_s15_q;
  logic and_2016_s15_q;
  logic and_2023_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic shown_s15_q;
  logic near_s15_q;
  logic and_2064_s15_q;
  logic and_2066_s15_q;
  logic or_2081_s15_q;
  logic or_2084_s15_q;
  logic or_2087_s15_q;
  logic and_2098_s15_q;
  logic and_2100_s15_q;
  logic and_2101_s15_q;
  logic and_2114_s15_q;
  logic and_2116_s15_q;
  logic and_2117_s15_q;
  logic and_2137_s15_q;
  logic equal_2280_s15_q;
  logic equal_2469_s15_q;
  logic and_2600_s15_q;
  logic not_2619_s15_q;
  logic and_2620_s15_q;
  logic and_2622_s15_q;
  logic and_2623_s15_q;
  logic and_2662_s15_q;
  logic and_2669_s15_q;
  logic and_2693_s15_q;
  logic select_2703_s15_q;
  logic select_2706_s15_q;
  logic and_2707_s15_q;
  logic and_2754_s15_q;
  logic and_2755_s15_q;
  logic [11:0] residual_s15_q;
  logic equal_2817_s15_q;
  logic [3:0] not_2818_s15_q;
  logic [1:0] quarter_2_s15_q;
  logic and_2993_s15_q;
  logic less_3119_s15_q;
  logic equal_3462_s15_q;
  logic [4:0] select_3550_s15_q;
  logic [9:0] select_3574_s15_q;
  logic [14:0] select_3581_s15_q;
  logic less_3624_s15_q;
  logic [9:0] high_s15_q;
  logic [9:0] low_s15_q;
  logic equal_3926_s15_q;
  logic equal_3946_s15_q;
  logic equal_3949_s15_q;
  logic equal_3950_s15_q;
  logic equal_3951_s15_q;
  logic [7:0] select_3970_s15_q;
  logic equal_4091_s15_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s15_q <= pixel_0_s14_q;
      pixel_1_s15_q <= pixel_1_s14_q;
      saturated_s15_q <= saturated_s14_q;
      mask_s15_q <= sample_of_skin_q;
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
      patches_down_values_3_s15_q <= patches_down_values_3_q;
      patches_along_s15_q <= patches_along_s14_q;
      patches_summed_last_s15_q <= patches_summed_last_s14_q;
      patches_summed_down_by_s15_q <= patches_summed_down_by_s14_q;
      patches_read_first_s15_q <= patches_read_first_s14_q;
      region_row_s15_q <= region_row_q;
      region_fresh_s15_q <= region_fresh_q;
      centres_values_1_textured_s15_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s15_q <= centres_values_1_of_skin_q;
      select_507_s15_q <= select_507_s14_q;
      row_starts_s15_q <= row_starts_s14_q;
      select_542_s15_q <= select_542_s14_q;
      last_s15_q <= last_s14_q;
      and_546_s15_q <= and_546_s14_q;
      and_548_s15_q <= and_548_s14_q;
      census_memory_rdata_s15_q <= census_memory_rdata_q;
      grey_s15_q <= grey;
      equal_551_s15_q <= equal_551_s14_q;
      select_554_s15_q <= sample_pair_whole_s14_q ? total[10:2] : 9'h0;
      grey_2_s15_q <= grey_2;
      select_558_s15_q <= sample_pair_whole_s14_q ? total_2[10:2] : 9'h0;
      whole_2_s15_q <= whole_2;
      and_566_s15_q <= sample_pair_whole_s14_q & select_565;
      equal_568_s15_q <= equal_568_s14_q;
      equal_573_s15_q <= equal_573_s14_q;
      not_574_s15_q <= not_574_s14_q;
      so_s15_q <= so_s14_q;
      not_576_s15_q <= not_576_s14_q;
      equal_577_s15_q <= equal_577_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      not_586_s15_q <= not_586_s14_q;
      moments_memory_rdata_s15_q <= moments_memory_rdata_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q[14:0];
      and_635_s15_q <= and_635;
      and_638_s15_q <= and_638_s14_q;
      and_645_s15_q <= and_645_s14_q;
      equal_678_s15_q <= equal_678_s14_q;
      of_best_s15_q <= of_best_s14_q;
      or_1515_s15_q <= select_760_s14_q | (best_left_rdata_s14_q[16:9] < of_best_s14_q);
      select_1520_s15_q <= select_1520_s14_q;
      select_1529_s15_q <= select_1529;
      select_1532_s15_q <= select_1532;
      select_1551_s15_q <= select_760_s14_q ? of_near_s14_q : select_1550_s14_q;
      select_1553_s15_q <= select_760_s14_q ? run_shift_s14_q : select_1552_s14_q;
      select_1556_s15_q <= (run_shift_s14_q == 6'h3f) ? of_best_s14_q : select_1555_s14_q;
      select_1559_s15_q <= (run_shift_s14_q == 6'h1) ? of_best_s14_q : select_1558_s14_q;
      and_1560_s15_q <= and_1560_s14_q;
      or_1564_s15_q <= or_1564;
      select_1569_s15_q <= or_1568_s14_q ? of_near_s14_q : best_right_rdata_s14_q[21:15];
      select_1570_s15_q <= or_1568_s14_q ? x_s14_2_q : best_right_rdata_s14_q[28:22];
      and_1573_s15_q <= and_1573_s14_q;
      select_1577_s15_q <= select_1577_s14_q;
      and_1584_s15_q <= and_1584;
      and_1588_s15_q <= and_1588;
      and_1599_s15_q <= and_1599_s14_q;
      equal_1606_s15_q <= equal_1606_s14_q;
      quarter_s15_q <= quarter;
      all_s15_q <= all_s14_q;
      sum_1612_s15_q <= sum_1612;
      select_1613_s15_q <= select_1613;
      equal_1614_s15_q <= equal_1614;
      equal_1616_s15_q <= equal_1616;
      equal_1618_s15_q <= equal_1618;
      equal_1620_s15_q <= equal_1620_s14_q;
      equal_1622_s15_q <= equal_1622_s14_q;
      equal_1624_s15_q <= equal_1624_s14_q;
      equal_1626_s15_q <= equal_1626_s14_q;
      equal_1628_s15_q <= equal_1628_s14_q;
      less_1637_s15_q <= less_1637;
      or_1641_s15_q <= or_1641;
      select_1644_s15_q <= equal_1606_s14_q ? and_1636 : (less_1637 & (~or_1641));
      and_1654_s15_q <= half_ends & ({{3{sum_1652[4]}}, sum_1652} < 8'h3);
      select_1659_s15_q <= select_1659;
      select_1688_s15_q <= select_1688_s14_q;
      equal_1689_s15_q <= equal_1689_s14_q;
      and_1697_s15_q <= and_1697_s14_q;
      equal_1699_s15_q <= equal_1699_s14_q;
      and_1732_s15_q <= (less_1698_s14_q & (and_635 & less_1715)) & and_1731_s14_q;
      select_1748_s15_q <= select_1748_s14_q;
      select_1774_s15_q <= select_1774_s14_q;
      and_1781_s15_q <= and_1781_s14_q;
      and_1782_s15_q <= and_1782_s14_q;
      equal_1783_s15_q <= equal_1783_s14_q;
      equal_1785_s15_q <= equal_1785_s14_q;
      equal_1788_s15_q <= equal_1788_s14_q;
      or_1789_s15_q <= or_1789_s14_q;
      and_1798_s15_q <= and_1798_s14_q;
      select_1813_s15_q <= select_1813_s14_q;
      select_1819_s15_q <= select_1819_s14_q;
      select_1857_s15_q <= select_1857_s14_q;
      less_1873_s15_q <= less_1873_s14_q;
      new_row_s15_q <= new_row_s14_q;
      or_1886_s15_q <= or_1886_s14_q;
      patches_right_codes_rdata_s15_q <= patches_right_codes_rdata_q;
      of_row_2_s15_q <= of_row_2_s14_q;
      down_2_s15_q <= down_2_s14_q[0];
      sum_1900_s15_q <= sum_1900[0];
      sum_1901_s15_q <= sum_1901;
      difference_1921_s15_q <= difference_1921;
      and_1946_s15_q <= and_1946_s14_q;
      patches_left_codes_rdata_s15_q <= patches_left_codes_rdata_q;
      and_1955_s15_q <= and_1955_s14_q;
      and_1960_s15_q <= and_1960_s14_q;
      less_1961_s15_q <= less_1961_s14_q;
      equal_1962_s15_q <= equal_1962_s14_q;
      not_1963_s15_q <= not_1963_s14_q;
      equal_1964_s15_q <= equal_1964_s14_q;
      or_1983_s15_q <= or_1983_s14_q;
      or_1986_s15_q <= or_1986_s14_q;
      or_1989_s15_q <= or_1989_s14_q;
      not_1991_s15_q <= not_1991_s14_q;
      textured_s15_q <= textured_s14_q;
      and_2016_s15_q <= and_2016;
      and_2023_s15_q <= and_2023_s14_q;
      seen_columns_rdata_s15_q <= seen_columns_rdata_s14_q;
      shown_s15_q <= shown;
      near_s15_q <= near;
      and_2064_s15_q <= and_2064_s14_q;
      and_2066_s15_q <= and_2066_s14_q;
      or_2081_s15_q <= or_2081_s14_q;
      or_2084_s15_q <= or_2084_s14_q;
      or_2087_s15_q <= or_2087_s14_q;
      and_2098_s15_q <= and_2098_s14_q;
      and_2100_s15_q <= seen_columns_rdata_s14_q[7] & inside_v_s14_q;
      and_2101_s15_q <= seen_columns_rdata_s14_q[3] & inside_v_s14_q;
      and_2114_s15_q <= and_2114_s14_q;
      and_2116_s15_q <= seen_columns_rdata_s14_q[8] & inside_v_s14_q;
      and_2117_s15_q <= seen_columns_rdata_s14_q[4] & inside_v_s14_q;
      and_2137_s15_q <= and_2137_s14_q;
      equal_2280_s15_q <= equal_2280_s14_q;
      equal_2469_s15_q <= equal_2469_s14_q;
      and_2600_s15_q <= and_2600;
      not_2619_s15_q <= not_2619;
      and_2620_s15_q <= and_2620_s14_q;
      and_2622_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      and_2623_s15_q <= seen_columns_rdata_s14_q[2] & inside_v_s14_q;
      and_2662_s15_q <= not_574_s14_q & and_2661;
      and_2669_s15_q <= not_574_s14_q & (so_s14_q & (ends_cell_s14_q & and_2666));
      and_2693_s15_q <= inside_v_s14_q & (or_578_s14_q & (not_582_s14_q & and_2690));
      select_2703_s15_q <= select_2703[1];
      select_2706_s15_q <= select_2706[1];
      and_2707_s15_q <= select_2703[0] & select_2706[0];
      and_2754_s15_q <= not_574_s14_q & (so_s14_q & (half_ends & equal_2751));
      and_2755_s15_q <= and_635 & less_1698_s14_q;
      residual_s15_q <= residual;
      equal_2817_s15_q <= sum_1612 == 2'h2;
      not_2818_s15_q <= ~select_1659;
      quarter_2_s15_q <= quarter_2;
      and_2993_s15_q <= and_2993_s14_q;
      less_3119_s15_q <= less_3119_s14_q;
      equal_3462_s15_q <= equal_3462_s14_q;
      select_3550_s15_q <= select_3550_s14_q;
      select_3574_s15_q <= select_3574;
      select_3581_s15_q <= select_3581_s14_q;
      less_3624_s15_q <= less_3624;
      high_s15_q <= high;
      low_s15_q <= low;
      equal_3926_s15_q <= equal_3926_s14_q;
      equal_3946_s15_q <= equal_3946;
      equal_3949_s15_q <= x_s14_q[6:3] == 4'hb;
      equal_3950_s15_q <= equal_3950;
      equal_3951_s15_q <= equal_3951;
      select_3970_s15_q <= equal_3946 ? cfg_regions_limit_i : select_3969;
      equal_4091_s15_q <= equal_4091_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
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
  logic moments_has_before_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic [3:0] registration_fresh_q;
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
  logic [9:0] patches_read_far_q;
  logic segment_started_q;
  // hls/stages/census.hpp:308
  logic less_651;
  assign less_651 = census_memory_rdata_s15_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_memory_rdata_s15_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_663;
  assign less_663 = census_memory_rdata_s15_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_memory_rdata_s15_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_675;
  assign equal_675 = last_s15_q == 7'h0;
  logic [3:0] select_679;
  assign select_679 = equal_678_s15_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_680;
  assign select_680 = equal_675 ? {select_679, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_681;
  assign select_681 = equal_675 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:300
  logic and_684;
  assign and_684 = census_memory_rdata_s15_q[38] & (census_memory_rdata_s15_q[18] & whole_2_s15_q);
  logic and_686;
  assign and_686 = census_memory_rdata_s15_q[77] & (census_memory_rdata_s15_q[58] & and_684);
  // hls/stages/census.hpp:284
  logic [9:0] difference_709;
  assign difference_709 = {1'b0, select_554_s15_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_712;
  assign difference_712 = {1'b0, census_memory_rdata_s15_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_716;
  assign difference_716 = {1'b0, census_memory_rdata_s15_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_720;
  assign difference_720 = {1'b0, census_memory_rdata_s15_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_724;
  assign difference_724 = {1'b0, census_memory_rdata_s15_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/agreement.hpp:788
  logic and_1585;
  assign and_1585 = not_576_s15_q & and_1584_s15_q;
  // hls/stages/moments.hpp:73
  logic and_1592;
  assign and_1592 = moments_has_before_q & moments_memory_rdata_s15_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1596;
  assign and_1596 = not_586_s15_q & (and_1592 & (moments_memory_rdata_s15_q[1] ^ and_638_s15_q));
  // hls/stages/moments.hpp:73
  logic and_1601;
  assign and_1601 = moments_has_before_q & moments_memory_rdata_s15_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1605;
  assign and_1605 = not_586_s15_q & (and_1601 & (moments_memory_rdata_s15_q[3] ^ and_645_s15_q));
  // hls/stages/agreement.hpp:788
  logic and_1655;
  assign and_1655 = so_s15_q & and_1654_s15_q;
  logic and_1736;
  assign and_1736 = not_574_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_1732_s15_q)));
  logic [7:0] select_1742;
  assign select_1742 = so_s15_q ? (ends_cell_s15_q ? (inside_v_s15_q ? x_s15_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:472
  logic [14:0] sum_1902;
  assign sum_1902 = {{4{patches_down_values_3_s15_q[10]}}, patches_down_values_3_s15_q} + {sum_1901_s15_q, sum_1900_s15_q, down_2_s15_q};
  // hls/stages/patches.hpp:451
  logic and_1925;
  assign and_1925 = difference_1921_s15_q[8] & (~(difference_1921_s15_q[7:0] == 8'h0));
  // hls/stages/patches.hpp:454
  logic and_1929;
  assign and_1929 = (~difference_1921_s15_q[14]) & (and_1925 | (~(difference_1921_s15_q[13:9] == 5'h0)));
  // hls/stages/patches.hpp:450
  logic and_1932;
  assign and_1932 = difference_1921_s15_q[14] & (~(difference_1921_s15_q[13:8] == 6'h3f));
  // hls/stages/agreement.hpp:262
  logic explained;
  assign explained = inside_v_s15_q & and_635_s15_q;
  logic and_2025;
  assign and_2025 = inside_v_s15_q & and_2016_s15_q;
  // hls/stages/agreement.hpp:1030
  logic and_2067;
  assign and_2067 = seen_columns_rdata_s15_q[0] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2069;
  assign sum_2069 = {1'b0, and_2066_s15_q} + ({1'b0, textured_s15_q} + {1'b0, and_2067});
  // hls/stages/agreement.hpp:1030
  logic and_2099;
  assign and_2099 = seen_columns_rdata_s15_q[11] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2103;
  assign sum_2103 = {1'b0, and_2100_s15_q} + ({1'b0, shown_s15_q} + {1'b0, and_2101_s15_q});
  // hls/stages/agreement.hpp:1030
  logic and_2115;
  assign and_2115 = seen_columns_rdata_s15_q[12] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2119;
  assign sum_2119 = {1'b0, and_2116_s15_q} + ({1'b0, near_s15_q} + {1'b0, and_2117_s15_q});
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2163;
  assign select_2163 = sample_pair_whole_s15_q ? (and_546_s15_q ? grey_s15_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2165;
  assign select_2165 = sample_pair_whole_s15_q ? (and_546_s15_q ? grey_2_s15_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2167;
  assign select_2167 = sample_pair_whole_s15_q ? (and_546_s15_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2169;
  assign select_2169 = sample_pair_whole_s15_q ? (and_546_s15_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2174;
  assign sum_2174 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s15_q};
  logic [9:0] sum_2182;
  assign sum_2182 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s15_q};
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2198;
  assign select_2198 = and_548_s15_q ? select_554_s15_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2199;
  assign select_2199 = and_548_s15_q ? select_558_s15_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2201;
  assign select_2201 = and_548_s15_q ? census_memory_rdata_s15_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_548_s15_q ? census_memory_rdata_s15_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2203;
  assign select_2203 = and_548_s15_q ? census_memory_rdata_s15_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2204;
  assign select_2204 = and_548_s15_q ? census_memory_rdata_s15_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2205;
  assign select_2205 = and_548_s15_q ? census_memory_rdata_s15_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2206;
  assign select_2206 = and_548_s15_q ? census_memory_rdata_s15_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2207;
  assign select_2207 = and_548_s15_q ? census_memory_rdata_s15_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2208;
  assign select_2208 = and_548_s15_q ? census_memory_rdata_s15_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_548_s15_q ? census_memory_rdata_s15_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2210;
  assign select_2210 = and_548_s15_q ? census_memory_rdata_s15_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2211;
  assign select_2211 = and_548_s15_q ? census_memory_rdata_s15_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_548_s15_q ? census_memory_rdata_s15_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2213;
  assign select_2213 = and_548_s15_q ? census_memory_rdata_s15_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_548_s15_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_548_s15_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2217;
  assign select_2217 = and_548_s15_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_548_s15_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2220;
  assign select_2220 = and_548_s15_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2221;
  assign select_2221 = and_548_s15_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2223;
  assign select_2223 = and_548_s15_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2224;
  assign select_2224 = and_548_s15_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_548_s15_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2227;
  assign select_2227 = and_548_s15_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_548_s15_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2230;
  assign select_2230 = and_548_s15_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_548_s15_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2233;
  assign select_2233 = and_548_s15_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_548_s15_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2236;
  assign select_2236 = and_548_s15_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2237;
  assign select_2237 = and_548_s15_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2239;
  assign select_2239 = and_548_s15_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2240;
  assign select_2240 = and_548_s15_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2242;
  assign select_2242 = and_548_s15_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2243;
  assign select_2243 = and_548_s15_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2246;
  assign select_2246 = and_548_s15_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2247;
  assign select_2247 = and_548_s15_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2250;
  assign select_2250 = and_548_s15_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2251;
  assign select_2251 = and_548_s15_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2255;
  assign difference_2255 = {1'b0, select_558_s15_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2258;
  assign difference_2258 = {1'b0, census_memory_rdata_s15_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2262;
  assign difference_2262 = {1'b0, census_memory_rdata_s15_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2266;
  assign difference_2266 = {1'b0, census_memory_rdata_s15_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2270;
  assign difference_2270 = {1'b0, census_memory_rdata_s15_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/agreement.hpp:1142
  logic equal_2295;
  assign equal_2295 = x_s15_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:788
  logic select_2301;
  assign select_2301 = equal_573_s15_q ? (moments_has_before_q | equal_2295) : moments_has_before_q;
  // hls/stages/census.hpp:371
  logic [9:0] difference_2366;
  assign difference_2366 = {1'b0, select_554_s15_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2378;
  assign difference_2378 = {1'b0, select_558_s15_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:520
  logic and_2594;
  assign and_2594 = and_548_s15_q & (equal_678_s15_q & equal_2469_s15_q);
  // hls/stages/agreement.hpp:788
  logic and_2605;
  assign and_2605 = not_574_s15_q & (so_s15_q & (ends_cell_s15_q & textured_s15_q));
  // hls/stages/agreement.hpp:1030
  logic and_2621;
  assign and_2621 = seen_columns_rdata_s15_q[10] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2625;
  assign sum_2625 = {1'b0, and_2622_s15_q} + ({1'b0, explained} + {1'b0, and_2623_s15_q});
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2664;
  assign select_2664 = and_2594 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2662_s15_q});
  logic [13:0] select_2671;
  assign select_2671 = and_2594 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2669_s15_q});
  // hls/stages/agreement.hpp:1027
  logic and_2708;
  assign and_2708 = and_635_s15_q & and_2707_s15_q;
  // hls/stages/agreement.hpp:788
  logic and_2711;
  assign and_2711 = ends_cell_s15_q & (inside_v_s15_q & (select_2703_s15_q & and_2708));
  logic and_2718;
  assign and_2718 = ends_cell_s15_q & (inside_v_s15_q & (select_2706_s15_q & and_2708));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2789;
  assign difference_2789 = 13'h0 - {residual_s15_q[11], residual_s15_q};
  logic less_2804;
  assign less_2804 = $signed(difference_2789) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2820;
  assign select_2820 = equal_2817_s15_q ? (registration_fresh_q & not_2818_s15_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2822;
  assign select_2822 = so_s15_q ? (and_1654_s15_q ? select_2820 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2824;
  assign select_2824 = and_2594 ? 4'hf : (equal_573_s15_q ? registration_fresh_q : select_2822);
  // hls/stages/registration.hpp:258
  logic not_2845;
  assign not_2845 = ~quarter_2_s15_q[1];
  logic [3:0] select_2846;
  assign select_2846 = quarter_2_s15_q[0] ? {quarter_2_s15_q[1], 1'b0, not_2845, 1'b0} : {1'b0, quarter_2_s15_q[1], 1'b0, not_2845};
  // hls/stages/patches.hpp:506
  logic [27:0] word;
  assign word = or_1886_s15_q ? patches_right_codes_rdata_s15_q : 28'h0;
  // hls/stages/patches.hpp:523
  logic [47:0] select_3152;
  assign select_3152 = new_row_s15_q ? patches_left_codes_rdata_s15_q : patches_left_row_q;
  // hls/stages/patches.hpp:185
  logic [47:0] select_3154;
  assign select_3154 = equal_1783_s15_q ? patches_left_row_q : (equal_1785_s15_q ? select_3152 : patches_left_row_q);
  logic [4:0] select_3499;
  assign select_3499 = equal_1785_s15_q ? patches_along_s15_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:558
  logic [9:0] select_3576;
  assign select_3576 = less_1961_s15_q ? (equal_1964_s15_q ? 10'h3ff : select_3574_s15_q) : 10'h3ff;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3577;
  assign select_3577 = equal_1964_s15_q ? select_3576 : select_3574_s15_q;
  logic [9:0] select_3579;
  assign select_3579 = less_1961_s15_q ? (equal_1962_s15_q ? 10'h3ff : select_3577) : select_3577;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high_s15_q - low_s15_q;
  logic [9:0] fall_2;
  assign fall_2 = high_s15_q - select_3581_s15_q[9:0];
  // hls/stages/agreement.hpp:1223
  logic equal_3702;
  assign equal_3702 = x_s15_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1217
  logic equal_3948;
  assign equal_3948 = x_s15_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3971;
  assign select_3971 = equal_3949_s15_q ? {cfg_on_skin_limit_i, 3'h0} : select_3970_s15_q;
  logic [7:0] limit;
  assign limit = equal_3948 ? cfg_regions_limit_i : select_3971;
  // hls/stages/agreement.hpp:1231
  logic not_3973;
  assign not_3973 = ~x_s15_q[2];
  logic [3:0] select_3974;
  assign select_3974 = x_s15_q[1] ? {x_s15_q[2], 1'b0, not_3973, 1'b0} : {1'b0, x_s15_q[2], 1'b0, not_3973};
  logic [7:0] select_3975;
  assign select_3975 = x_s15_q[0] ? {select_3974[3], 1'b0, select_3974[2], 1'b0, select_3974[1], 1'b0, select_3974[0], 1'b0} : {1'b0, select_3974[3], 1'b0, select_3974[2], 1'b0, select_3974[1], 1'b0, select_3974[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3979;
  assign select_3979 = equal_3950_s15_q ? counts_skin_supervised_q : (equal_3951_s15_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3981;
  assign select_3981 = equal_3949_s15_q ? counts_skin_textured_q : (equal_3946_s15_q ? counts_textured_q : select_3979);
  logic [13:0] of;
  assign of = equal_3948 ? counts_textured_q : select_3981;
  // hls/stages/registration.hpp:258
  logic not_4184;
  assign not_4184 = ~quarter_s15_q[1];
  logic [3:0] select_4185;
  assign select_4185 = quarter_s15_q[0] ? {quarter_s15_q[1], 1'b0, not_4184, 1'b0} : {1'b0, quarter_s15_q[1], 1'b0, not_4184};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1613_s15_q;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s15_en & (equal_573_s15_q ? (x_s15_q[6] & select_1644_s15_q) : and_1655);
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = last_s15_q;
  logic census_memory_we;
  assign census_memory_we = s15_en & and_548_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s15_q[58:40], census_memory_rdata_s15_q[38:0], and_566_s15_q, whole_2_s15_q, select_558_s15_q, select_554_s15_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s14_sim;
  logic census_memory_re_s14_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s14_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s14_sim <= census_memory_re;
      census_memory_raddr_s14_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s14_sim && census_memory_raddr_s14_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1577_s15_q;
  logic shown_right_we;
  assign shown_right_we = s15_en & and_1588_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1585, not_576_s15_q};
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
  assign seen_columns_we = s15_en & and_1573_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s15_q, near_s15_q, shown_s15_q, explained, and_2025, textured_s15_q};
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
      census_filled_q <= 4'h0;
      moments_has_before_q <= 1'b0;
      rows_passed_above_q <= 5'h0;
      counts_textured_q <= 14'h0;
      counts_skin_supervised_q <= 14'h0;
      counts_skin_textured_q <= 14'h0;
      registration_fresh_q <= 4'hf;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
      patches_read_far_q <= 10'h3ff;
      segment_started_q <= 1'b0;
    end else if (s15_en) begin
      census_filled_q <= and_548_s15_q ? {select_681[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2301;
      rows_passed_above_q <= and_548_s15_q ? select_680 : rows_passed_above_q;
      counts_textured_q <= and_2594 ? 14'h0 : (counts_textured_q + {13'h0, and_2605});
      counts_skin_supervised_q <= select_2664;
      counts_skin_textured_q <= select_2671;
      registration_fresh_q <= select_2824;
      patches_left_row_q <= select_3154;
      patches_summed_row_column_q <= equal_1783_s15_q ? patches_summed_row_column_q : select_3499;
      patches_read_far_q <= equal_1783_s15_q ? select_3579 : patches_read_far_q;
      segment_started_q <= ~segment_starts_q;
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
    if (s15_en) begin
      averager_quarter_1_0_q <= select_2163;
      averager_quarter_1_1_q <= select_2165;
      averager_quarter_2_0_q <= select_2167;
      averager_quarter_2_1_q <= select_2169;
      census_columns_values_0_cell_0_left_q <= select_2198;
      census_columns_values_0_cell_0_right_q <= select_2199;
      census_columns_values_0_cell_1_left_q <= select_2201;
      census_columns_values_0_cell_1_right_q <= select_2202;
      census_columns_values_0_cell_1_mask_q <= select_2203;
      census_columns_values_0_cell_2_left_q <= select_2204;
      census_columns_values_0_cell_2_right_q <= select_2205;
      census_columns_values_0_cell_2_mask_q <= select_2206;
      census_columns_values_0_cell_2_of_skin_q <= select_2207;
      census_columns_values_0_cell_3_left_q <= select_2208;
      census_columns_values_0_cell_3_right_q <= select_2209;
      census_columns_values_0_cell_3_mask_q <= select_2210;
      census_columns_values_0_cell_4_left_q <= select_2211;
      census_columns_values_0_cell_4_right_q <= select_2212;
      census_columns_values_0_cell_4_mask_q <= select_2213;
      census_columns_values_1_cell_0_left_q <= select_2214;
      census_columns_values_1_cell_0_right_q <= select_2215;
      census_columns_values_1_cell_1_left_q <= select_2217;
      census_columns_values_1_cell_1_right_q <= select_2218;
      census_columns_values_1_cell_2_left_q <= select_2220;
      census_columns_values_1_cell_2_right_q <= select_2221;
      census_columns_values_1_cell_2_of_skin_q <= select_2223;
      census_columns_values_1_cell_3_left_q <= select_2224;
      census_columns_values_1_cell_3_right_q <= select_2225;
      census_columns_values_1_cell_4_left_q <= select_2227;
      census_columns_values_1_cell_4_right_q <= select_2228;
      census_columns_values_2_cell_0_left_q <= select_2230;
      census_columns_values_2_cell_0_right_q <= select_2231;
      census_columns_values_2_cell_1_left_q <= select_2233;
      census_columns_values_2_cell_1_right_q <= select_2234;
      census_columns_values_2_cell_2_left_q <= select_2236;
      census_columns_values_2_cell_2_right_q <= select_2237;
      census_columns_values_2_cell_3_left_q <= select_2239;
      census_columns_values_2_cell_3_right_q <= select_2240;
      census_columns_values_2_cell_4_left_q <= select_2242;
      census_columns_values_2_cell_4_right_q <= select_2243;
      census_columns_values_3_cell_1_left_q <= select_2246;
      census_columns_values_3_cell_1_right_q <= select_2247;
      census_columns_values_3_cell_3_left_q <= select_2250;
      census_columns_values_3_cell_3_right_q <= select_2251;
      sharpness_last_mean_0_q <= and_548_s15_q ? select_554_s15_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_548_s15_q ? select_558_s15_q : sharpness_last_mean_1_q;
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
  logic census_columns_values_0_cell_1_mask_s16_q;
  logic census_columns_values_0_cell_2_mask_s16_q;
  logic census_columns_values_0_cell_3_mask_s16_q;
  logic census_columns_values_0_cell_4_mask_s16_q;
  logic census_columns_values_1_cell_2_of_skin_s16_q;
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
  logic [4:0] patches_summed_row_column_s16_q;
  logic patches_summed_last_s16_q;
  logic [4:0] patches_summed_down_by_s16_q;
  logic patches_read_first_s16_q;
  logic [9:0] patches_read_far_s16_q;
  logic [2:0] region_row_s16_q;
  logic region_fresh_s16_q;
  logic segment_started_s16_q;
  logic centres_values_1_textured_s16_q;
  logic centres_values_1_of_skin_s16_q;
  logic [3:0] select_507_s16_q;
  logic row_starts_s16_q;
  logic [6:0] select_542_s16_q;
  logic [6:0] last_s16_q;
  logic and_546_s16_q;
  logic and_548_s16_q;
  logic equal_551_s16_q;
  logic whole_2_s16_q;
  logic equal_568_s16_q;
  logic equal_573_s16_q;
  logic not_574_s16_q;
  logic so_s16_q;
  logic not_576_s16_q;
  logic equal_577_s16_q;
  logic inside_v_s16_q;
  logic [6:0] x_s16_2_q;
  logic [6:0] right_s16_q;
  logic less_651_s16_q;
  logic less_652_s16_q;
  logic less_653_s16_q;
  logic less_654_s16_q;
  logic less_655_s16_q;
  logic less_656_s16_q;
  logic less_657_s16_q;
  logic less_658_s16_q;
  logic less_659_s16_q;
  logic less_660_s16_q;
  logic less_661_s16_q;
  logic less_662_s16_q;
  logic less_663_s16_q;
  logic less_664_s16_q;
  logic less_665_s16_q;
  logic less_666_s16_q;
  logic less_667_s16_q;
  logic less_668_s16_q;
  logic less_669_s16_q;
  logic less_670_s16_q;
  logic less_671_s16_q;
  logic less_672_s16_q;
  logic less_673_s16_q;
  logic less_674_s16_q;
  logic and_682_s16_q;
  logic and_686_s16_q;
  logic difference_709_s16_q;
  logic [8:0] xor_710_s16_q;
  logic difference_712_s16_q;
  logic [8:0] xor_713_s16_q;
  logic difference_716_s16_q;
  logic [8:0] xor_717_s16_q;
  logic difference_720_s16_q;
  logic [8:0] xor_721_s16_q;
  logic difference_724_s16_q;
  logic [8:0] xor_725_s16_q;
  logic [9:0] half_grey_levels_s16_q;
  logic [9:0] half_grey_levels_2_s16_q;
  logic [5:0] select_1516_s16_q;
  logic [2:0] select_1521_s16_q;
  logic [7:0] select_1522_s16_q;
  logic [7:0] select_1530_s16_q;
  logic [7:0] select_1533_s16_q;
  logic [6:0] select_1551_s16_q;
  logic [5:0] select_1553_s16_q;
  logic [7:0] select_1556_s16_q;
  logic [7:0] select_1559_s16_q;
  logic and_1560_s16_q;
  logic [7:0] select_1565_s16_q;
  logic [6:0] select_1566_s16_q;
  logic [6:0] select_1569_s16_q;
  logic [6:0] select_1570_s16_q;
  logic and_1593_s16_q;
  logic and_1596_s16_q;
  logic and_1599_s16_q;
  logic and_1602_s16_q;
  logic and_1605_s16_q;
  logic equal_1606_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1612_s16_q;
  logic equal_1614_s16_q;
  logic equal_1616_s16_q;
  logic equal_1618_s16_q;
  logic equal_1620_s16_q;
  logic equal_1622_s16_q;
  logic equal_1624_s16_q;
  logic equal_1626_s16_q;
  logic equal_1628_s16_q;
  logic less_1637_s16_q;
  logic or_1641_s16_q;
  logic equal_1661_s16_q;
  logic and_1671_s16_q;
  logic select_1688_s16_q;
  logic equal_1689_s16_q;
  logic [22:0] patches_choices_rdata_s16_q;
  logic and_1697_s16_q;
  logic equal_1699_s16_q;
  logic and_1736_s16_q;
  logic [7:0] select_1743_s16_q;
  logic [5:0] select_1748_s16_q;
  logic [7:0] select_1774_s16_q;
  logic and_1781_s16_q;
  logic and_1782_s16_q;
  logic equal_1783_s16_q;
  logic equal_1785_s16_q;
  logic equal_1788_s16_q;
  logic or_1789_s16_q;
  logic and_1798_s16_q;
  logic [4:0] select_1813_s16_q;
  logic select_1819_s16_q;
  logic [3:0] select_1857_s16_q;
  logic less_1873_s16_q;
  logic new_row_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic not_1903_s16_q;
  logic and_1906_s16_q;
  logic not_1908_s16_q;
  logic and_1913_s16_q;
  logic and_1929_s16_q;
  logic and_1932_s16_q;
  logic and_1946_s16_q;
  logic and_1955_s16_q;
  logic and_1960_s16_q;
  logic less_1961_s16_q;
  logic equal_1962_s16_q;
  logic not_1963_s16_q;
  logic equal_1964_s16_q;
  logic or_1983_s16_q;
  logic or_1986_s16_q;
  logic or_1989_s16_q;
  logic not_1991_s16_q;
  logic [29:0] regions_rdata_s16_q;
  logic textured_s16_q;
  logic explained_s16_q;
  logic and_2018_s16_q;
  logic and_2023_s16_q;
  logic and_2064_s16_q;
  logic and_2065_s16_q;
  logic [1:0] sum_2069_s16_q;
  logic or_2081_s16_q;
  logic or_2084_s16_q;
  logic or_2087_s16_q;
  logic and_2098_s16_q;
  logic [2:0] sum_2104_s16_q;
  logic and_2114_s16_q;
  logic [2:0] sum_2120_s16_q;
  logic and_2137_s16_q;
  logic sum_2174_s16_q;
  logic [9:0] difference_2175_s16_q;
  logic sum_2182_s16_q;
  logic [9:0] difference_2183_s16_q;
  logic difference_2255_s16_q;
  logic [8:0] xor_2256_s16_q;
  logic difference_2258_s16_q;
  logic [8:0] xor_2259_s16_q;
  logic difference_2262_s16_q;
  logic [8:0] xor_2263_s16_q;
  logic difference_2266_s16_q;
  logic [8:0] xor_2267_s16_q;
  logic difference_2270_s16_q;
  logic [8:0] xor_2271_s16_q;
  logic equal_2280_s16_q;
  logic equal_2295_s16_q;
  logic difference_2366_s16_q;
  logic [8:0] xor_2367_s16_q;
  logic difference_2378_s16_q;
  logic [8:0] xor_2379_s16_q;
  logic equal_2469_s16_q;
  logic and_2594_s16_q;
  logic and_2600_s16_q;
  logic and_2605_s16_q;
  logic not_2619_s16_q;
  logic and_2620_s16_q;
  logic [2:0] sum_2626_s16_q;
  logic and_2696_s16_q;
  logic and_2713_s16_q;
  logic and_2720_s16_q;
  logic and_2754_s16_q;
  logic and_2755_s16_q;
  logic [7:0] residual_s16_q;
  logic less_2790_s16_q;
  logic less_2804_s16_q;
  logic equal_2848_s16_q;
  logic and_2993_s16_q;
  logic [27:0] word_s16_q;
  logic equal_3113_s16_q;
  logic less_3119_s16_q;
  logic [47:0] select_3152_s16_q;
  logic equal_3462_s16_q;
  logic [4:0] select_3550_s16_q;
  logic [14:0] select_3581_s16_q;
  logic less_3624_s16_q;
  logic [9:0] eight_s16_q;
  logic [9:0] fall_2_s16_q;
  logic equal_3702_s16_q;
  logic and_3927_s16_q;
  logic equal_3946_s16_q;
  logic equal_3948_s16_q;
  logic equal_3949_s16_q;
  logic equal_3950_s16_q;
  logic equal_3951_s16_q;
  logic equal_3977_s16_q;
  logic [13:0] of_s16_q;
  logic equal_4091_s16_q;
  logic equal_4187_s16_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s16_q <= pixel_0_s15_q;
      pixel_1_s16_q <= pixel_1_s15_q;
      saturated_s16_q <= saturated_s15_q;
      mask_s16_q <= mask_s15_q;
      marks_first_s16_q <= marks_first_s15_q;
      marks_last_s16_q <= marks_last_s15_q;
      sample_pair_pixel_0_s16_q <= sample_pair_pixel_0_s15_q;
      sample_pair_pixel_1_s16_q <= sample_pair_pixel_1_s15_q;
      sample_pair_whole_s16_q <= sample_pair_whole_s15_q;
      sample_present_s16_q <= sample_present_s15_q;
      census_columns_values_0_cell_1_mask_s16_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s16_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s16_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s16_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s16_q <= census_columns_values_1_cell_2_of_skin_q;
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
      patches_summed_row_column_s16_q <= patches_summed_row_column_q;
      patches_summed_last_s16_q <= patches_summed_last_s15_q;
      patches_summed_down_by_s16_q <= patches_summed_down_by_s15_q;
      patches_read_first_s16_q <= patches_read_first_s15_q;
      patches_read_far_s16_q <= patches_read_far_q;
      region_row_s16_q <= region_row_s15_q;
      region_fresh_s16_q <= region_fresh_s15_q;
      segment_started_s16_q <= segment_started_q;
      centres_values_1_textured_s16_q <= centres_values_1_textured_s15_q;
      centres_values_1_of_skin_s16_q <= centres_values_1_of_skin_s15_q;
      select_507_s16_q <= select_507_s15_q;
      row_starts_s16_q <= row_starts_s15_q;
      select_542_s16_q <= select_542_s15_q;
      last_s16_q <= last_s15_q;
      and_546_s16_q <= and_546_s15_q;
      and_548_s16_q <= and_548_s15_q;
      equal_551_s16_q <= equal_551_s15_q;
      whole_2_s16_q <= whole_2_s15_q;
      equal_568_s16_q <= equal_568_s15_q;
      equal_573_s16_q <= equal_573_s15_q;
      not_574_s16_q <= not_574_s15_q;
      so_s16_q <= so_s15_q;
      not_576_s16_q <= not_576_s15_q;
      equal_577_s16_q <= equal_577_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      x_s16_2_q <= x_s15_2_q;
      right_s16_q <= right_s15_q;
      less_651_s16_q <= less_651;
      less_652_s16_q <= less_652;
      less_653_s16_q <= less_653;
      less_654_s16_q <= less_654;
      less_655_s16_q <= less_655;
      less_656_s16_q <= less_656;
      less_657_s16_q <= less_657;
      less_658_s16_q <= less_658;
      less_659_s16_q <= less_659;
      less_660_s16_q <= less_660;
      less_661_s16_q <= less_661;
      less_662_s16_q <= less_662;
      less_663_s16_q <= less_663;
      less_664_s16_q <= less_664;
      less_665_s16_q <= less_665;
      less_666_s16_q <= less_666;
      less_667_s16_q <= less_667;
      less_668_s16_q <= less_668;
      less_669_s16_q <= less_669;
      less_670_s16_q <= less_670;
      less_671_s16_q <= less_671;
      less_672_s16_q <= less_672;
      less_673_s16_q <= less_673;
      less_674_s16_q <= less_674;
      and_682_s16_q <= select_680[4] & select_681[3];
      and_686_s16_q <= and_686;
      difference_709_s16_q <= difference_709[9];
      xor_710_s16_q <= difference_709[8:0] ^ {9{difference_709[9]}};
      difference_712_s16_q <= difference_712[9];
      xor_713_s16_q <= difference_712[8:0] ^ {9{difference_712[9]}};
      difference_716_s16_q <= difference_716[9];
      xor_717_s16_q <= difference_716[8:0] ^ {9{difference_716[9]}};
      difference_720_s16_q <= difference_720[9];
      xor_721_s16_q <= difference_720[8:0] ^ {9{difference_720[9]}};
      difference_724_s16_q <= difference_724[9];
      xor_725_s16_q <= difference_724[8:0] ^ {9{difference_724[9]}};
      half_grey_levels_s16_q <= half_grey_levels;
      half_grey_levels_2_s16_q <= half_grey_levels_2;
      select_1516_s16_q <= or_1515_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[5:0];
      select_1521_s16_q <= or_1515_s15_q ? select_1520_s15_q : best_left_rdata_s15_q[8:6];
      select_1522_s16_q <= or_1515_s15_q ? of_best_s15_q : best_left_rdata_s15_q[16:9];
      select_1530_s16_q <= or_1515_s15_q ? select_1529_s15_q : best_left_rdata_s15_q[24:17];
      select_1533_s16_q <= or_1515_s15_q ? select_1532_s15_q : best_left_rdata_s15_q[32:25];
      select_1551_s16_q <= select_1551_s15_q;
      select_1553_s16_q <= select_1553_s15_q;
      select_1556_s16_q <= select_1556_s15_q;
      select_1559_s16_q <= select_1559_s15_q;
      and_1560_s16_q <= and_1560_s15_q;
      select_1565_s16_q <= or_1564_s15_q ? of_best_s15_q : best_right_rdata_s15_q[7:0];
      select_1566_s16_q <= or_1564_s15_q ? x_s15_2_q : best_right_rdata_s15_q[14:8];
      select_1569_s16_q <= select_1569_s15_q;
      select_1570_s16_q <= select_1570_s15_q;
      and_1593_s16_q <= not_586_s15_q & and_1592;
      and_1596_s16_q <= and_1596;
      and_1599_s16_q <= and_1599_s15_q;
      and_1602_s16_q <= not_586_s15_q & and_1601;
      and_1605_s16_q <= and_1605;
      equal_1606_s16_q <= equal_1606_s15_q;
      all_s16_q <= all_s15_q;
      sum_1612_s16_q <= sum_1612_s15_q;
      equal_1614_s16_q <= equal_1614_s15_q;
      equal_1616_s16_q <= equal_1616_s15_q;
      equal_1618_s16_q <= equal_1618_s15_q;
      equal_1620_s16_q <= equal_1620_s15_q;
      equal_1622_s16_q <= equal_1622_s15_q;
      equal_1624_s16_q <= equal_1624_s15_q;
      equal_1626_s16_q <= equal_1626_s15_q;
      equal_1628_s16_q <= equal_1628_s15_q;
      less_1637_s16_q <= less_1637_s15_q;
      or_1641_s16_q <= or_1641_s15_q;
      equal_1661_s16_q <= (registration_fresh_q & select_1659_s15_q) == 4'h0;
      and_1671_s16_q <= not_574_s15_q & and_1655;
      select_1688_s16_q <= select_1688_s15_q;
      equal_1689_s16_q <= equal_1689_s15_q;
      patches_choices_rdata_s16_q <= patches_choices_rdata_q;
      and_1697_s16_q <= and_1697_s15_q;
      equal_1699_s16_q <= equal_1699_s15_q;
      and_1736_s16_q <= and_1736;
      select_1743_s16_q <= equal_573_s15_q ? 8'h0 : select_1742;
      select_1748_s16_q <= select_1748_s15_q;
      select_1774_s16_q <= select_1774_s15_q;
      and_1781_s16_q <= and_1781_s15_q;
      and_1782_s16_q <= and_1782_s15_q;
      equal_1783_s16_q <= equal_1783_s15_q;
      equal_1785_s16_q <= equal_1785_s15_q;
      equal_1788_s16_q <= equal_1788_s15_q;
      or_1789_s16_q <= or_1789_s15_q;
      and_1798_s16_q <= and_1798_s15_q;
      select_1813_s16_q <= select_1813_s15_q;
      select_1819_s16_q <= select_1819_s15_q;
      select_1857_s16_q <= select_1857_s15_q;
      less_1873_s16_q <= less_1873_s15_q;
      new_row_s16_q <= new_row_s15_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      not_1903_s16_q <= ~sum_1902[14];
      and_1906_s16_q <= sum_1902[8] & (~(sum_1902[7:0] == 8'h0));
      not_1908_s16_q <= ~(sum_1902[13:9] == 5'h0);
      and_1913_s16_q <= sum_1902[14] & (~(sum_1902[13:8] == 6'h3f));
      and_1929_s16_q <= and_1929;
      and_1932_s16_q <= and_1932;
      and_1946_s16_q <= and_1946_s15_q;
      and_1955_s16_q <= and_1955_s15_q;
      and_1960_s16_q <= and_1960_s15_q;
      less_1961_s16_q <= less_1961_s15_q;
      equal_1962_s16_q <= equal_1962_s15_q;
      not_1963_s16_q <= not_1963_s15_q;
      equal_1964_s16_q <= equal_1964_s15_q;
      or_1983_s16_q <= or_1983_s15_q;
      or_1986_s16_q <= or_1986_s15_q;
      or_1989_s16_q <= or_1989_s15_q;
      not_1991_s16_q <= not_1991_s15_q;
      regions_rdata_s16_q <= regions_rdata_q;
      textured_s16_q <= textured_s15_q;
      explained_s16_q <= explained;
      and_2018_s16_q <= inside_v_s15_q & (and_2016_s15_q & and_1584_s15_q);
      and_2023_s16_q <= and_2023_s15_q;
      and_2064_s16_q <= and_2064_s15_q;
      and_2065_s16_q <= seen_columns_rdata_s15_q[9] & inside_v_s15_q;
      sum_2069_s16_q <= sum_2069;
      or_2081_s16_q <= or_2081_s15_q;
      or_2084_s16_q <= or_2084_s15_q;
      or_2087_s16_q <= or_2087_s15_q;
      and_2098_s16_q <= and_2098_s15_q;
      sum_2104_s16_q <= {2'h0, and_2099} + {1'b0, sum_2103};
      and_2114_s16_q <= and_2114_s15_q;
      sum_2120_s16_q <= {2'h0, and_2115} + {1'b0, sum_2119};
      and_2137_s16_q <= and_2137_s15_q;
      sum_2174_s16_q <= sum_2174[0];
      difference_2175_s16_q <= {1'b0, sum_2174[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2182_s16_q <= sum_2182[0];
      difference_2183_s16_q <= {1'b0, sum_2182[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2255_s16_q <= difference_2255[9];
      xor_2256_s16_q <= difference_2255[8:0] ^ {9{difference_2255[9]}};
      difference_2258_s16_q <= difference_2258[9];
      xor_2259_s16_q <= difference_2258[8:0] ^ {9{difference_2258[9]}};
      difference_2262_s16_q <= difference_2262[9];
      xor_2263_s16_q <= difference_2262[8:0] ^ {9{difference_2262[9]}};
      difference_2266_s16_q <= difference_2266[9];
      xor_2267_s16_q <= difference_2266[8:0] ^ {9{difference_2266[9]}};
      difference_2270_s16_q <= difference_2270[9];
      xor_2271_s16_q <= difference_2270[8:0] ^ {9{difference_2270[9]}};
      equal_2280_s16_q <= equal_2280_s15_q;
      equal_2295_s16_q <= equal_2295;
      difference_2366_s16_q <= difference_2366[9];
      xor_2367_s16_q <= difference_2366[8:0] ^ {9{difference_2366[9]}};
      difference_2378_s16_q <= difference_2378[9];
      xor_2379_s16_q <= difference_2378[8:0] ^ {9{difference_2378[9]}};
      equal_2469_s16_q <= equal_2469_s15_q;
      and_2594_s16_q <= and_2594;
      and_2600_s16_q <= and_2600_s15_q;
      and_2605_s16_q <= and_2605;
      not_2619_s16_q <= not_2619_s15_q;
      and_2620_s16_q <= and_2620_s15_q;
      sum_2626_s16_q <= {2'h0, and_2621} + {1'b0, sum_2625};
      and_2696_s16_q <= not_574_s15_q & (so_s15_q & (ends_cell_s15_q & and_2693_s15_q));
      and_2713_s16_q <= not_574_s15_q & (so_s15_q & and_2711);
      and_2720_s16_q <= not_574_s15_q & (so_s15_q & and_2718);
      and_2754_s16_q <= and_2754_s15_q;
      and_2755_s16_q <= and_2755_s15_q;
      residual_s16_q <= residual_s15_q[7:0];
      less_2790_s16_q <= $signed(difference_2789) < $signed({7'h0, cfg_moved_limit_i});
      less_2804_s16_q <= less_2804;
      equal_2848_s16_q <= (registration_fresh_q & select_2846) == 4'h0;
      and_2993_s16_q <= and_2993_s15_q;
      word_s16_q <= word;
      equal_3113_s16_q <= patches_along_s15_q == 5'h7;
      less_3119_s16_q <= less_3119_s15_q;
      select_3152_s16_q <= select_3152;
      equal_3462_s16_q <= equal_3462_s15_q;
      select_3550_s16_q <= select_3550_s15_q;
      select_3581_s16_q <= select_3581_s15_q;
      less_3624_s16_q <= less_3624_s15_q;
      eight_s16_q <= eight;
      fall_2_s16_q <= fall_2;
      equal_3702_s16_q <= equal_3702;
      and_3927_s16_q <= equal_3926_s15_q & equal_3702;
      equal_3946_s16_q <= equal_3946_s15_q;
      equal_3948_s16_q <= equal_3948;
      equal_3949_s16_q <= equal_3949_s15_q;
      equal_3950_s16_q <= equal_3950_s15_q;
      equal_3951_s16_q <= equal_3951_s15_q;
      equal_3977_s16_q <= (limit & select_3975) == 8'h0;
      of_s16_q <= of;
      equal_4091_s16_q <= equal_4091_s15_q;
      equal_4187_s16_q <= (registration_fresh_q & select_4185) == 4'h0;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [13:0] moments_turned_0_q;
  logic [13:0] moments_turned_1_q;
  logic moments_turns_0_q;
  logic moments_turns_1_q;
  logic [13:0] counts_explained_q;
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [7:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic [51:0] patches_codes_at_q;
  logic [27:0] patches_codes_further_q;
  logic [55:0] patches_next_codes_q;
  logic patches_summed_first_q;
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
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_686_s16_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s16_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s16_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s16_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s16_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:284
  logic [9:0] sum_711;
  assign sum_711 = {9'h0, difference_709_s16_q} + {1'b0, xor_710_s16_q};
  logic [9:0] sum_714;
  assign sum_714 = {9'h0, difference_712_s16_q} + {1'b0, xor_713_s16_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_736;
  assign sum_736 = {half_grey_levels_s16_q[9], half_grey_levels_s16_q[9:4]} + 7'h7f;
  logic less_737;
  assign less_737 = {{5{sum_736[6]}}, sum_736, half_grey_levels_s16_q[3:0]} < 16'hffe1;
  logic [6:0] sum_742;
  assign sum_742 = {half_grey_levels_2_s16_q[9], half_grey_levels_2_s16_q[9:4]} + 7'h7f;
  logic less_743;
  assign less_743 = {{5{sum_742[6]}}, sum_742, half_grey_levels_2_s16_q[3:0]} < 16'hffe1;
  // hls/stages/patches.hpp:157
  logic and_1738;
  assign and_1738 = and_1736_s16_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:345
  logic select_1739;
  assign select_1739 = and_1738 ? and_1736_s16_q : patches_choice_valid_q;
  logic [7:0] select_1744;
  assign select_1744 = and_1738 ? select_1743_s16_q : patches_choice_column_q;
  logic [5:0] select_1749;
  assign select_1749 = and_1738 ? select_1748_s16_q : patches_choice_shift_q;
  logic [7:0] select_1775;
  assign select_1775 = and_1738 ? select_1774_s16_q : patches_choice_slope_q;
  // hls/stages/patches.hpp:354
  logic [22:0] select_1799;
  assign select_1799 = and_1798_s16_q ? {select_1775, select_1749, select_1744, select_1739} : patches_choices_rdata_s16_q;
  // hls/stages/patches.hpp:487
  logic [2:0] sum_1894;
  assign sum_1894 = patches_code_row_s16_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:454
  logic and_1910;
  assign and_1910 = not_1903_s16_q & (and_1906_s16_q | not_1908_s16_q);
  // hls/stages/patches.hpp:491
  logic [1:0] sum_1950;
  assign sum_1950 = patches_code_row_s16_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2004;
  assign select_2004 = segment_started_s16_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2005;
  assign sum_2005 = {6'h0, textured_s16_q} + select_2004;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2007;
  assign sum_2007 = {3'h0, sum_2005} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2009;
  assign select_2009 = segment_started_s16_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2010;
  assign sum_2010 = {6'h0, explained_s16_q} + select_2009;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2012;
  assign sum_2012 = {3'h0, sum_2010} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2019;
  assign select_2019 = segment_started_s16_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2020;
  assign sum_2020 = {6'h0, and_2018_s16_q} + select_2019;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2022;
  assign sum_2022 = {3'h0, sum_2020} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[29:20]);
  // hls/stages/agreement.hpp:1275
  logic or_2032;
  assign or_2032 = marks_first_s16_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [12:0] select_2034;
  assign select_2034 = marks_first_s16_q ? 13'h1 : (or_2032 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2036;
  assign select_2036 = or_2032 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2038;
  assign select_2038 = cfg_compete_i ? (or_2032 & select_2034[12]) : (select_2036[8] & select_2034[9]);
  // hls/stages/agreement.hpp:1087
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2064_s16_q} + ({2'h0, and_2065_s16_q} + {1'b0, sum_2069_s16_q});
  // hls/stages/agreement.hpp:1089
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2098_s16_q} + sum_2104_s16_q;
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2106;
  assign select_2106 = age_s16_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1090
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2114_s16_q} + sum_2120_s16_q;
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2122;
  assign select_2122 = age_s16_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:221
  logic [9:0] xor_2176;
  assign xor_2176 = {difference_2175_s16_q[8:0], sum_2174_s16_q} ^ {10{difference_2175_s16_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2175_s16_q[9]} + {1'b0, xor_2176};
  logic [9:0] xor_2184;
  assign xor_2184 = {difference_2183_s16_q[8:0], sum_2182_s16_q} ^ {10{difference_2183_s16_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2183_s16_q[9]} + {1'b0, xor_2184};
  // hls/stages/agreement.hpp:520
  logic select_2200;
  assign select_2200 = and_548_s16_q ? whole_2_s16_q : census_columns_values_0_cell_0_mask_q;
  logic select_2216;
  assign select_2216 = and_548_s16_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2219;
  assign select_2219 = and_548_s16_q ? census_columns_values_0_cell_1_mask_s16_q : census_columns_values_1_cell_1_mask_q;
  logic select_2226;
  assign select_2226 = and_548_s16_q ? census_columns_values_0_cell_3_mask_s16_q : census_columns_values_1_cell_3_mask_q;
  logic select_2229;
  assign select_2229 = and_548_s16_q ? census_columns_values_0_cell_4_mask_s16_q : census_columns_values_1_cell_4_mask_q;
  logic select_2232;
  assign select_2232 = and_548_s16_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2235;
  assign select_2235 = and_548_s16_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] sum_2257;
  assign sum_2257 = {9'h0, difference_2255_s16_q} + {1'b0, xor_2256_s16_q};
  logic [9:0] sum_2260;
  assign sum_2260 = {9'h0, difference_2258_s16_q} + {1'b0, xor_2259_s16_q};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2292;
  assign sum_2292 = {13'h0, moments_turns_0_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2294;
  assign sum_2294 = {13'h0, moments_turns_1_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:788
  logic and_2335;
  assign and_2335 = not_576_s16_q & (equal_577_s16_q & (inside_v_s16_q & and_1596_s16_q));
  logic and_2339;
  assign and_2339 = not_576_s16_q & (equal_577_s16_q & (inside_v_s16_q & and_1605_s16_q));
  // hls/stages/census.hpp:371
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2366_s16_q} + xor_2367_s16_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2378_s16_q} + xor_2379_s16_q;
  // hls/stages/agreement.hpp:788
  logic and_2610;
  assign and_2610 = not_574_s16_q & (so_s16_q & (ends_cell_s16_q & explained_s16_q));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2612;
  assign select_2612 = and_2594_s16_q ? 14'h0 : (counts_explained_q + {13'h0, and_2610});
  // hls/stages/agreement.hpp:788
  logic and_2615;
  assign and_2615 = not_574_s16_q & (so_s16_q & (ends_cell_s16_q & and_2018_s16_q));
  // hls/stages/agreement.hpp:1088
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2620_s16_q} + sum_2626_s16_q;
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2628;
  assign select_2628 = age_s16_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1132
  logic less_2644;
  assign less_2644 = region_row_s16_q < x_s16_q[5:3];
  // hls/stages/patches.hpp:346
  logic not_2983;
  assign not_2983 = ~and_1781_s16_q;
  // hls/stages/patches.hpp:523
  logic [55:0] other;
  assign other = new_row_s16_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:185
  logic [51:0] select_3109;
  assign select_3109 = or_1789_s16_q ? {and_1932_s16_q, and_1929_s16_q, and_1913_s16_q, and_1910, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3111;
  assign select_3111 = equal_1783_s16_q ? patches_codes_at_q : (equal_1785_s16_q ? other[55:4] : select_3109);
  // hls/stages/patches.hpp:522
  logic [27:0] select_3114;
  assign select_3114 = equal_3113_s16_q ? word_s16_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:185
  logic [27:0] select_3116;
  assign select_3116 = equal_1785_s16_q ? (new_row_s16_q ? word_s16_q : select_3114) : patches_codes_further_q;
  // hls/stages/patches.hpp:524
  logic [55:0] select_3118;
  assign select_3118 = less_1873_s16_q ? {word_s16_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:494
  logic [55:0] select_3120;
  assign select_3120 = less_3119_s16_q ? {word_s16_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:185
  logic [55:0] select_3122;
  assign select_3122 = or_1789_s16_q ? (equal_1788_s16_q ? patches_next_codes_q : select_3120) : patches_next_codes_q;
  logic [55:0] select_3124;
  assign select_3124 = equal_1783_s16_q ? patches_next_codes_q : (equal_1785_s16_q ? select_3118 : select_3122);
  // hls/stages/count_bits.hpp:24
  logic parity_3129;
  assign parity_3129 = ^{and_1932_s16_q, and_1929_s16_q, and_1913_s16_q, and_1910};
  // hls/stages/count_bits.hpp:25
  logic or_3133;
  assign or_3133 = ({and_1913_s16_q, and_1910} == 2'h3) | (and_1929_s16_q & (and_1913_s16_q | and_1910));
  logic and_3134;
  assign and_3134 = and_1932_s16_q & (^{and_1929_s16_q, and_1913_s16_q, and_1910});
  // hls/stages/count_bits.hpp:24
  logic xor_3135;
  assign xor_3135 = or_3133 ^ and_3134;
  // hls/stages/count_bits.hpp:27
  logic and_3136;
  assign and_3136 = or_3133 & and_3134;
  // hls/stages/patches.hpp:525
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3152_s16_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3158;
  assign xor_3158 = bits[17] ^ (^{select_3152_s16_q[16:15], other[16:15]});
  logic xor_3161;
  assign xor_3161 = bits[11] ^ (^{select_3152_s16_q[10:9], other[10:9]});
  logic xor_3164;
  assign xor_3164 = bits[14] ^ (^{select_3152_s16_q[13:12], other[13:12]});
  logic xor_3167;
  assign xor_3167 = xor_3158 ^ (^{select_3152_s16_q[14:9], other[14:9]});
  logic xor_3170;
  assign xor_3170 = bits[47] ^ (^{select_3152_s16_q[46:45], other[46:45]});
  logic xor_3173;
  assign xor_3173 = bits[8] ^ (^{select_3152_s16_q[7:6], other[7:6]});
  logic xor_3176;
  assign xor_3176 = bits[2] ^ (^{select_3152_s16_q[1:0], other[1:0]});
  logic xor_3179;
  assign xor_3179 = bits[5] ^ (^{select_3152_s16_q[4:3], other[4:3]});
  logic xor_3182;
  assign xor_3182 = xor_3173 ^ (^{select_3152_s16_q[5:0], other[5:0]});
  logic parity_3184;
  assign parity_3184 = ^{select_3152_s16_q[47:45], select_3152_s16_q[8:0], other[47:45], other[8:0]};
  logic xor_3188;
  assign xor_3188 = bits[44] ^ (^{select_3152_s16_q[43:42], other[43:42]});
  logic xor_3191;
  assign xor_3191 = bits[38] ^ (^{select_3152_s16_q[37:36], other[37:36]});
  logic xor_3194;
  assign xor_3194 = bits[41] ^ (^{select_3152_s16_q[40:39], other[40:39]});
  logic xor_3200;
  assign xor_3200 = bits[26] ^ (^{select_3152_s16_q[25:24], other[25:24]});
  logic xor_3203;
  assign xor_3203 = bits[20] ^ (^{select_3152_s16_q[19:18], other[19:18]});
  logic xor_3206;
  assign xor_3206 = bits[23] ^ (^{select_3152_s16_q[22:21], other[22:21]});
  logic xor_3212;
  assign xor_3212 = bits[35] ^ (^{select_3152_s16_q[34:33], other[34:33]});
  logic xor_3215;
  assign xor_3215 = bits[29] ^ (^{select_3152_s16_q[28:27], other[28:27]});
  logic xor_3218;
  assign xor_3218 = bits[32] ^ (^{select_3152_s16_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:185
  logic select_3502;
  assign select_3502 = equal_1783_s16_q ? patches_summed_first_q : (equal_1785_s16_q ? new_row_s16_q : patches_summed_first_q);
  // hls/stages/patches.hpp:544
  logic [9:0] select_3590;
  assign select_3590 = (patches_read_far_s16_q < patches_peak_far_q) ? patches_read_far_s16_q : patches_peak_far_q;
  logic [9:0] select_3591;
  assign select_3591 = patches_read_first_s16_q ? patches_read_far_s16_q : select_3590;
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3633;
  assign sum_3633 = {1'b0, fall_2_s16_q} + {2'h0, fall_2_s16_q[9:1]};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3637;
  assign sum_3637 = {1'b0, fall_2_s16_q} + {3'h0, fall_2_s16_q[9:2]};
  logic less_3641;
  assign less_3641 = {eight_s16_q, 3'h0} < ({fall_2_s16_q, 3'h0} - {3'h0, fall_2_s16_q});
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3964;
  assign select_3964 = equal_3702_s16_q ? 14'h0 : product_q;
  logic [13:0] select_3983;
  assign select_3983 = equal_3977_s16_q ? 14'h0 : of_s16_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3964} + {1'b0, select_3983};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4025;
  assign select_4025 = so_s16_q ? (ends_cell_s16_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4027;
  assign select_4027 = ends_cell_s16_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4029;
  assign select_4029 = equal_573_s16_q ? box_explained_columns_values_1_q : (so_s16_q ? select_4027 : box_explained_columns_values_1_q);
  logic [2:0] select_4030;
  assign select_4030 = ends_cell_s16_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4032;
  assign select_4032 = equal_573_s16_q ? box_explained_columns_values_2_q : (so_s16_q ? select_4030 : box_explained_columns_values_2_q);
  logic [2:0] select_4033;
  assign select_4033 = ends_cell_s16_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4035;
  assign select_4035 = equal_573_s16_q ? box_explained_columns_values_3_q : (so_s16_q ? select_4033 : box_explained_columns_values_3_q);
  logic [2:0] select_4036;
  assign select_4036 = ends_cell_s16_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4038;
  assign select_4038 = equal_573_s16_q ? box_explained_columns_values_4_q : (so_s16_q ? select_4036 : box_explained_columns_values_4_q);
  logic [2:0] select_4043;
  assign select_4043 = so_s16_q ? (ends_cell_s16_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4045;
  assign select_4045 = ends_cell_s16_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4047;
  assign select_4047 = equal_573_s16_q ? box_shown_columns_values_1_q : (so_s16_q ? select_4045 : box_shown_columns_values_1_q);
  logic [2:0] select_4048;
  assign select_4048 = ends_cell_s16_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4050;
  assign select_4050 = equal_573_s16_q ? box_shown_columns_values_2_q : (so_s16_q ? select_4048 : box_shown_columns_values_2_q);
  logic [2:0] select_4051;
  assign select_4051 = ends_cell_s16_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4053;
  assign select_4053 = equal_573_s16_q ? box_shown_columns_values_3_q : (so_s16_q ? select_4051 : box_shown_columns_values_3_q);
  logic [2:0] select_4054;
  assign select_4054 = ends_cell_s16_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4056;
  assign select_4056 = equal_573_s16_q ? box_shown_columns_values_4_q : (so_s16_q ? select_4054 : box_shown_columns_values_4_q);
  logic [2:0] select_4061;
  assign select_4061 = so_s16_q ? (ends_cell_s16_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4063;
  assign select_4063 = ends_cell_s16_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4065;
  assign select_4065 = equal_573_s16_q ? box_nearer_columns_values_1_q : (so_s16_q ? select_4063 : box_nearer_columns_values_1_q);
  logic [2:0] select_4066;
  assign select_4066 = ends_cell_s16_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4068;
  assign select_4068 = equal_573_s16_q ? box_nearer_columns_values_2_q : (so_s16_q ? select_4066 : box_nearer_columns_values_2_q);
  logic [2:0] select_4069;
  assign select_4069 = ends_cell_s16_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4071;
  assign select_4071 = equal_573_s16_q ? box_nearer_columns_values_3_q : (so_s16_q ? select_4069 : box_nearer_columns_values_3_q);
  logic [2:0] select_4072;
  assign select_4072 = ends_cell_s16_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4074;
  assign select_4074 = equal_573_s16_q ? box_nearer_columns_values_4_q : (so_s16_q ? select_4072 : box_nearer_columns_values_4_q);

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s16_2_q;
  logic best_left_we;
  assign best_left_we = s16_en & and_1560_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1559_s16_q, select_1556_s16_q, select_1553_s16_q, select_1551_s16_q, select_1533_s16_q, select_1530_s16_q, select_1522_s16_q, select_1521_s16_q, select_1516_s16_q};
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
  assign best_right_we = s16_en & and_1560_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1570_s16_q, select_1569_s16_q, select_1566_s16_q, select_1565_s16_q};
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
  assign left_turns_we = s16_en & and_1599_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1596_s16_q, and_1593_s16_q};
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
  assign right_turns_we = s16_en & and_1599_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1605_s16_q, and_1602_s16_q};
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
  assign patches_choices_waddr = {patches_choosing_band_s16_q, and_1697_s16_q};
  logic patches_choices_we;
  assign patches_choices_we = s16_en & and_1782_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {select_1775, select_1749, select_1744, select_1739};
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

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1894, patches_code_row_s16_q[1:0], of_row_2_s16_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s16_en & and_1946_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1932_s16_q, and_1929_s16_q, and_1913_s16_q, and_1910, patches_codes_at_q[51:28]};
  end
`ifndef SYNTHESIS
  logic [6:0] patches_right_codes_raddr_s14_sim;
  logic patches_right_codes_re_s14_sim;
  logic [6:0] patches_right_codes_raddr_s15_sim;
  logic patches_right_codes_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_codes_re_s14_sim <= 1'b0;
      patches_right_codes_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_codes_re_s14_sim <= patches_right_codes_re;
      patches_right_codes_raddr_s14_sim <= patches_right_codes_raddr;
      patches_right_codes_re_s15_sim <= patches_right_codes_re_s14_sim;
      patches_right_codes_raddr_s15_sim <= patches_right_codes_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s14_sim && patches_right_codes_raddr_s14_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s15_sim && patches_right_codes_raddr_s15_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 7'd112) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 7'd112) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1950, patches_code_row_s16_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s16_en & and_1960_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1932_s16_q, and_1929_s16_q, and_1913_s16_q, and_1910, patches_codes_at_q[51:8]};
  end
`ifndef SYNTHESIS
  logic [3:0] patches_left_codes_raddr_s14_sim;
  logic patches_left_codes_re_s14_sim;
  logic [3:0] patches_left_codes_raddr_s15_sim;
  logic patches_left_codes_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_codes_re_s14_sim <= 1'b0;
      patches_left_codes_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_codes_re_s14_sim <= patches_left_codes_re;
      patches_left_codes_raddr_s14_sim <= patches_left_codes_raddr;
      patches_left_codes_re_s15_sim <= patches_left_codes_re_s14_sim;
      patches_left_codes_raddr_s15_sim <= patches_left_codes_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s14_sim && patches_left_codes_raddr_s14_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s15_sim && patches_left_codes_raddr_s15_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_turned_0_q <= 14'h0;
      moments_turned_1_q <= 14'h0;
      moments_turns_0_q <= 1'b0;
      moments_turns_1_q <= 1'b0;
      counts_explained_q <= 14'h0;
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_codes_at_q <= 52'h0;
      patches_codes_further_q <= 28'h0;
      patches_next_codes_q <= 56'h0;
      patches_summed_first_q <= 1'b0;
      patches_peak_far_q <= 10'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s16_en) begin
      moments_turned_0_q <= sum_2292;
      moments_turned_1_q <= sum_2294;
      moments_turns_0_q <= not_574_s16_q & and_2335;
      moments_turns_1_q <= not_574_s16_q & and_2339;
      counts_explained_q <= select_2612;
      patches_fixed_q <= not_2983 & (patches_fixed_q | (and_2993_s16_q & and_1738));
      patches_choice_valid_q <= and_1781_s16_q ? (select_1739 & not_2983) : select_1739;
      patches_choice_column_q <= select_1744;
      patches_choice_shift_q <= select_1749;
      patches_choice_slope_q <= select_1775;
      patches_codes_at_q <= select_3111;
      patches_codes_further_q <= equal_1783_s16_q ? patches_codes_further_q : select_3116;
      patches_next_codes_q <= select_3124;
      patches_summed_first_q <= select_3502;
      patches_peak_far_q <= equal_1783_s16_q ? select_3591 : patches_peak_far_q;
      segment_textured_q <= select_2004 + {6'h0, and_2605_s16_q};
      segment_explained_q <= select_2009 + {6'h0, and_2610};
      segment_nearer_q <= select_2019 + {6'h0, and_2615};
      product_q <= equal_573_s16_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2034;
      columns_passed_q <= {select_2036[7:0], or_2032};
      line_ended_q <= marks_last_s16_q;
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
      census_columns_values_0_cell_0_mask_q <= select_2200;
      census_columns_values_1_cell_0_mask_q <= select_2216;
      census_columns_values_1_cell_1_mask_q <= select_2219;
      census_columns_values_1_cell_3_mask_q <= select_2226;
      census_columns_values_1_cell_4_mask_q <= select_2229;
      census_columns_values_2_cell_0_mask_q <= select_2232;
      census_columns_values_2_cell_1_mask_q <= select_2235;
      box_explained_columns_values_0_q <= equal_573_s16_q ? box_explained_columns_values_0_q : select_4025;
      box_explained_columns_values_1_q <= select_4029;
      box_explained_columns_values_2_q <= select_4032;
      box_explained_columns_values_3_q <= select_4035;
      box_explained_columns_values_4_q <= select_4038;
      box_shown_columns_values_0_q <= equal_573_s16_q ? box_shown_columns_values_0_q : select_4043;
      box_shown_columns_values_1_q <= select_4047;
      box_shown_columns_values_2_q <= select_4050;
      box_shown_columns_values_3_q <= select_4053;
      box_shown_columns_values_4_q <= select_4056;
      box_nearer_columns_values_0_q <= equal_573_s16_q ? box_nearer_columns_values_0_q : select_4061;
      box_nearer_columns_values_1_q <= select_4065;
      box_nearer_columns_values_2_q <= select_4068;
      box_nearer_columns_values_3_q <= select_4071;
      box_nearer_columns_values_4_q <= select_4074;
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
  logic census_columns_values_0_cell_2_mask_s17_q;
  logic census_columns_values_1_cell_2_of_skin_s17_q;
  logic census_columns_values_1_cell_3_mask_s17_q;
  logic census_columns_values_1_cell_4_mask_s17_q;
  logic census_columns_values_2_cell_0_mask_s17_q;
  logic census_columns_values_2_cell_1_mask_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic [2:0] slot_s17_q;
  logic ends_cell_s17_q;
  logic lower_half_s17_q;
  logic [13:0] counts_textured_s17_q;
  logic [13:0] counts_explained_s17_q;
  logic registration_of_right_s17_q;
  logic patches_lower_s17_q;
  logic patches_second_s17_q;
  logic [4:0] patches_summed_row_column_s17_q;
  logic patches_summed_first_s17_q;
  logic patches_summed_last_s17_q;
  logic [4:0] patches_summed_down_by_s17_q;
  logic [2:0] region_row_s17_q;
  logic [13:0] product_s17_q;
  logic centres_values_1_textured_s17_q;
  logic centres_values_1_of_skin_s17_q;
  logic [3:0] select_507_s17_q;
  logic row_starts_s17_q;
  logic [6:0] select_542_s17_q;
  logic [6:0] last_s17_q;
  logic and_546_s17_q;
  logic and_548_s17_q;
  logic equal_551_s17_q;
  logic whole_2_s17_q;
  logic equal_568_s17_q;
  logic equal_573_s17_q;
  logic not_574_s17_q;
  logic so_s17_q;
  logic less_651_s17_q;
  logic less_652_s17_q;
  logic less_653_s17_q;
  logic less_654_s17_q;
  logic less_655_s17_q;
  logic less_656_s17_q;
  logic less_657_s17_q;
  logic less_658_s17_q;
  logic less_659_s17_q;
  logic less_660_s17_q;
  logic less_661_s17_q;
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
  logic and_682_s17_q;
  logic whole_9_s17_q;
  logic [10:0] sum_715_s17_q;
  logic [9:0] sum_718_s17_q;
  logic [9:0] sum_722_s17_q;
  logic [9:0] sum_726_s17_q;
  logic less_737_s17_q;
  logic less_739_s17_q;
  logic less_743_s17_q;
  logic less_745_s17_q;
  logic equal_1606_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1612_s17_q;
  logic equal_1614_s17_q;
  logic equal_1616_s17_q;
  logic equal_1618_s17_q;
  logic equal_1620_s17_q;
  logic equal_1622_s17_q;
  logic equal_1624_s17_q;
  logic equal_1626_s17_q;
  logic equal_1628_s17_q;
  logic less_1637_s17_q;
  logic or_1641_s17_q;
  logic [31:0] registration_sums_rdata_s17_q;
  logic equal_1661_s17_q;
  logic and_1671_s17_q;
  logic select_1688_s17_q;
  logic equal_1689_s17_q;
  logic equal_1699_s17_q;
  logic equal_1783_s17_q;
  logic equal_1785_s17_q;
  logic equal_1788_s17_q;
  logic or_1789_s17_q;
  logic [22:0] select_1799_s17_q;
  logic [4:0] select_1813_s17_q;
  logic select_1819_s17_q;
  logic [3:0] select_1857_s17_q;
  logic less_1961_s17_q;
  logic equal_1962_s17_q;
  logic not_1963_s17_q;
  logic equal_1964_s17_q;
  logic or_1983_s17_q;
  logic or_1986_s17_q;
  logic or_1989_s17_q;
  logic not_1991_s17_q;
  logic [9:0] sum_2007_s17_q;
  logic [9:0] sum_2012_s17_q;
  logic [9:0] sum_2022_s17_q;
  logic and_2023_s17_q;
  logic select_2038_s17_q;
  logic [2:0] textured_2_s17_q;
  logic or_2081_s17_q;
  logic or_2084_s17_q;
  logic or_2087_s17_q;
  logic [3:0] difference_2107_s17_q;
  logic [3:0] difference_2123_s17_q;
  logic and_2137_s17_q;
  logic [10:0] size_s17_q;
  logic [10:0] size_2_s17_q;
  logic [10:0] sum_2261_s17_q;
  logic [9:0] sum_2264_s17_q;
  logic [9:0] sum_2268_s17_q;
  logic [9:0] sum_2272_s17_q;
  logic equal_2280_s17_q;
  logic equal_2295_s17_q;
  logic [8:0] contrast_s17_q;
  logic [8:0] contrast_2_s17_q;
  logic equal_2469_s17_q;
  logic and_2594_s17_q;
  logic and_2600_s17_q;
  logic and_2615_s17_q;
  logic not_2619_s17_q;
  logic [3:0] difference_2629_s17_q;
  logic [9:0] select_2645_s17_q;
  logic [9:0] select_2648_s17_q;
  logic and_2696_s17_q;
  logic and_2713_s17_q;
  logic and_2720_s17_q;
  logic and_2754_s17_q;
  logic and_2755_s17_q;
  logic [7:0] residual_s17_q;
  logic and_2791_s17_q;
  logic and_2805_s17_q;
  logic equal_2848_s17_q;
  logic [8:0] other_s17_q;
  logic [2:0] select_3137_s17_q;
  logic [8:0] select_3152_s17_q;
  logic xor_3167_s17_q;
  logic xor_3185_s17_q;
  logic xor_3197_s17_q;
  logic xor_3209_s17_q;
  logic xor_3221_s17_q;
  logic or_3230_s17_q;
  logic or_3234_s17_q;
  logic or_3238_s17_q;
  logic or_3245_s17_q;
  logic or_3249_s17_q;
  logic or_3253_s17_q;
  logic or_3260_s17_q;
  logic or_3264_s17_q;
  logic or_3268_s17_q;
  logic or_3278_s17_q;
  logic or_3282_s17_q;
  logic or_3286_s17_q;
  logic or_3294_s17_q;
  logic or_3298_s17_q;
  logic or_3302_s17_q;
  logic or_3309_s17_q;
  logic or_3313_s17_q;
  logic or_3317_s17_q;
  logic or_3327_s17_q;
  logic or_3331_s17_q;
  logic or_3335_s17_q;
  logic and_3340_s17_q;
  logic or_3341_s17_q;
  logic equal_3462_s17_q;
  logic [4:0] select_3550_s17_q;
  logic [14:0] select_3581_s17_q;
  logic [9:0] select_3591_s17_q;
  logic less_3624_s17_q;
  logic not_3632_s17_q;
  logic not_3635_s17_q;
  logic not_3639_s17_q;
  logic not_3642_s17_q;
  logic equal_3702_s17_q;
  logic and_3927_s17_q;
  logic less_3928_s17_q;
  logic equal_3929_s17_q;
  logic equal_3946_s17_q;
  logic equal_3948_s17_q;
  logic equal_3949_s17_q;
  logic equal_3950_s17_q;
  logic equal_3951_s17_q;
  logic sum_4_s17_q;
  logic equal_4091_s17_q;
  logic equal_4187_s17_q;
  logic [9:0] select_4197_s17_q;
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
      census_columns_values_0_cell_2_mask_s17_q <= census_columns_values_0_cell_2_mask_s16_q;
      census_columns_values_1_cell_2_of_skin_s17_q <= census_columns_values_1_cell_2_of_skin_s16_q;
      census_columns_values_1_cell_3_mask_s17_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s17_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s17_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s17_q <= census_columns_values_2_cell_1_mask_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      slot_s17_q <= slot_s16_q;
      ends_cell_s17_q <= ends_cell_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      counts_textured_s17_q <= counts_textured_s16_q;
      counts_explained_s17_q <= counts_explained_q;
      registration_of_right_s17_q <= registration_of_right_s16_q;
      patches_lower_s17_q <= patches_lower_s16_q;
      patches_second_s17_q <= patches_second_s16_q;
      patches_summed_row_column_s17_q <= patches_summed_row_column_s16_q;
      patches_summed_first_s17_q <= patches_summed_first_q;
      patches_summed_last_s17_q <= patches_summed_last_s16_q;
      patches_summed_down_by_s17_q <= patches_summed_down_by_s16_q;
      region_row_s17_q <= region_row_s16_q;
      product_s17_q <= product_q;
      centres_values_1_textured_s17_q <= centres_values_1_textured_s16_q;
      centres_values_1_of_skin_s17_q <= centres_values_1_of_skin_s16_q;
      select_507_s17_q <= select_507_s16_q;
      row_starts_s17_q <= row_starts_s16_q;
      select_542_s17_q <= select_542_s16_q;
      last_s17_q <= last_s16_q;
      and_546_s17_q <= and_546_s16_q;
      and_548_s17_q <= and_548_s16_q;
      equal_551_s17_q <= equal_551_s16_q;
      whole_2_s17_q <= whole_2_s16_q;
      equal_568_s17_q <= equal_568_s16_q;
      equal_573_s17_q <= equal_573_s16_q;
      not_574_s17_q <= not_574_s16_q;
      so_s17_q <= so_s16_q;
      less_651_s17_q <= less_651_s16_q;
      less_652_s17_q <= less_652_s16_q;
      less_653_s17_q <= less_653_s16_q;
      less_654_s17_q <= less_654_s16_q;
      less_655_s17_q <= less_655_s16_q;
      less_656_s17_q <= less_656_s16_q;
      less_657_s17_q <= less_657_s16_q;
      less_658_s17_q <= less_658_s16_q;
      less_659_s17_q <= less_659_s16_q;
      less_660_s17_q <= less_660_s16_q;
      less_661_s17_q <= less_661_s16_q;
      less_662_s17_q <= less_662_s16_q;
      less_663_s17_q <= less_663_s16_q;
      less_664_s17_q <= less_664_s16_q;
      less_665_s17_q <= less_665_s16_q;
      less_666_s17_q <= less_666_s16_q;
      less_667_s17_q <= less_667_s16_q;
      less_668_s17_q <= less_668_s16_q;
      less_669_s17_q <= less_669_s16_q;
      less_670_s17_q <= less_670_s16_q;
      less_671_s17_q <= less_671_s16_q;
      less_672_s17_q <= less_672_s16_q;
      less_673_s17_q <= less_673_s16_q;
      less_674_s17_q <= less_674_s16_q;
      and_682_s17_q <= and_682_s16_q;
      whole_9_s17_q <= whole_9;
      sum_715_s17_q <= {1'b0, sum_711} + {1'b0, sum_714};
      sum_718_s17_q <= {9'h0, difference_716_s16_q} + {1'b0, xor_717_s16_q};
      sum_722_s17_q <= {9'h0, difference_720_s16_q} + {1'b0, xor_721_s16_q};
      sum_726_s17_q <= {9'h0, difference_724_s16_q} + {1'b0, xor_725_s16_q};
      less_737_s17_q <= less_737;
      less_739_s17_q <= $signed(10'h0) < $signed(half_grey_levels_s16_q);
      less_743_s17_q <= less_743;
      less_745_s17_q <= $signed(10'h0) < $signed(half_grey_levels_2_s16_q);
      equal_1606_s17_q <= equal_1606_s16_q;
      all_s17_q <= all_s16_q;
      sum_1612_s17_q <= sum_1612_s16_q;
      equal_1614_s17_q <= equal_1614_s16_q;
      equal_1616_s17_q <= equal_1616_s16_q;
      equal_1618_s17_q <= equal_1618_s16_q;
      equal_1620_s17_q <= equal_1620_s16_q;
      equal_1622_s17_q <= equal_1622_s16_q;
      equal_1624_s17_q <= equal_1624_s16_q;
      equal_1626_s17_q <= equal_1626_s16_q;
      equal_1628_s17_q <= equal_1628_s16_q;
      less_1637_s17_q <= less_1637_s16_q;
      or_1641_s17_q <= or_1641_s16_q;
      registration_sums_rdata_s17_q <= registration_sums_rdata_q;
      equal_1661_s17_q <= equal_1661_s16_q;
      and_1671_s17_q <= and_1671_s16_q;
      select_1688_s17_q <= select_1688_s16_q;
      equal_1689_s17_q <= equal_1689_s16_q;
      equal_1699_s17_q <= equal_1699_s16_q;
      equal_1783_s17_q <= equal_1783_s16_q;
      equal_1785_s17_q <= equal_1785_s16_q;
      equal_1788_s17_q <= equal_1788_s16_q;
      or_1789_s17_q <= or_1789_s16_q;
      select_1799_s17_q <= select_1799;
      select_1813_s17_q <= select_1813_s16_q;
      select_1819_s17_q <= select_1819_s16_q;
      select_1857_s17_q <= select_1857_s16_q;
      less_1961_s17_q <= less_1961_s16_q;
      equal_1962_s17_q <= equal_1962_s16_q;
      not_1963_s17_q <= not_1963_s16_q;
      equal_1964_s17_q <= equal_1964_s16_q;
      or_1983_s17_q <= or_1983_s16_q;
      or_1986_s17_q <= or_1986_s16_q;
      or_1989_s17_q <= or_1989_s16_q;
      not_1991_s17_q <= not_1991_s16_q;
      sum_2007_s17_q <= sum_2007;
      sum_2012_s17_q <= sum_2012;
      sum_2022_s17_q <= sum_2022;
      and_2023_s17_q <= and_2023_s16_q;
      select_2038_s17_q <= select_2038;
      textured_2_s17_q <= textured_2;
      or_2081_s17_q <= or_2081_s16_q;
      or_2084_s17_q <= or_2084_s16_q;
      or_2087_s17_q <= or_2087_s16_q;
      difference_2107_s17_q <= {1'b0, shown_2} - {1'b0, select_2106};
      difference_2123_s17_q <= {1'b0, near_2} - {1'b0, select_2122};
      and_2137_s17_q <= and_2137_s16_q;
      size_s17_q <= size;
      size_2_s17_q <= size_2;
      sum_2261_s17_q <= {1'b0, sum_2257} + {1'b0, sum_2260};
      sum_2264_s17_q <= {9'h0, difference_2262_s16_q} + {1'b0, xor_2263_s16_q};
      sum_2268_s17_q <= {9'h0, difference_2266_s16_q} + {1'b0, xor_2267_s16_q};
      sum_2272_s17_q <= {9'h0, difference_2270_s16_q} + {1'b0, xor_2271_s16_q};
      equal_2280_s17_q <= equal_2280_s16_q;
      equal_2295_s17_q <= equal_2295_s16_q;
      contrast_s17_q <= contrast;
      contrast_2_s17_q <= contrast_2;
      equal_2469_s17_q <= equal_2469_s16_q;
      and_2594_s17_q <= and_2594_s16_q;
      and_2600_s17_q <= and_2600_s16_q;
      and_2615_s17_q <= and_2615;
      not_2619_s17_q <= not_2619_s16_q;
      difference_2629_s17_q <= {1'b0, explained_2} - {1'b0, select_2628};
      select_2645_s17_q <= less_2644 ? 10'h0 : regions_rdata_s16_q[9:0];
      select_2648_s17_q <= less_2644 ? 10'h0 : regions_rdata_s16_q[19:10];
      and_2696_s17_q <= and_2696_s16_q;
      and_2713_s17_q <= and_2713_s16_q;
      and_2720_s17_q <= and_2720_s16_q;
      and_2754_s17_q <= and_2754_s16_q;
      and_2755_s17_q <= and_2755_s16_q;
      residual_s17_q <= residual_s16_q;
      and_2791_s17_q <= and_2755_s16_q & less_2790_s16_q;
      and_2805_s17_q <= and_2755_s16_q & less_2804_s16_q;
      equal_2848_s17_q <= equal_2848_s16_q;
      other_s17_q <= other[44:36];
      select_3137_s17_q <= and_1955_s16_q ? {and_3136, xor_3135, parity_3129} : 3'h0;
      select_3152_s17_q <= select_3152_s16_q[44:36];
      xor_3167_s17_q <= xor_3167;
      xor_3185_s17_q <= xor_3167 ^ parity_3184;
      xor_3197_s17_q <= xor_3188 ^ (^{select_3152_s16_q[41:36], other[41:36]});
      xor_3209_s17_q <= xor_3200 ^ (^{select_3152_s16_q[23:18], other[23:18]});
      xor_3221_s17_q <= xor_3212 ^ (^{select_3152_s16_q[32:27], other[32:27]});
      or_3230_s17_q <= (xor_3161 & xor_3164) | (xor_3158 & (xor_3161 | xor_3164));
      or_3234_s17_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3238_s17_q <= (xor_3176 & xor_3179) | (xor_3173 & (xor_3176 | xor_3179));
      or_3245_s17_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3249_s17_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3253_s17_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3260_s17_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3264_s17_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3268_s17_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3278_s17_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3282_s17_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3286_s17_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3294_s17_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3298_s17_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3302_s17_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3309_s17_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3313_s17_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3317_s17_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3327_s17_q <= (xor_3191 & xor_3194) | (xor_3188 & (xor_3191 | xor_3194));
      or_3331_s17_q <= (xor_3203 & xor_3206) | (xor_3200 & (xor_3203 | xor_3206));
      or_3335_s17_q <= (xor_3215 & xor_3218) | (xor_3212 & (xor_3215 | xor_3218));
      and_3340_s17_q <= xor_3170 & xor_3182;
      or_3341_s17_q <= xor_3170 | xor_3182;
      equal_3462_s17_q <= equal_3462_s16_q;
      select_3550_s17_q <= select_3550_s16_q;
      select_3581_s17_q <= select_3581_s16_q;
      select_3591_s17_q <= select_3591;
      less_3624_s17_q <= less_3624_s16_q;
      not_3632_s17_q <= ~({eight_s16_q, 3'h0} < {3'h0, fall_2_s16_q});
      not_3635_s17_q <= ~({eight_s16_q, 3'h0} < {1'b0, sum_3633, fall_2_s16_q[0]});
      not_3639_s17_q <= ~({eight_s16_q, 3'h0} < {sum_3637, fall_2_s16_q[1:0]});
      not_3642_s17_q <= ~less_3641;
      equal_3702_s17_q <= equal_3702_s16_q;
      and_3927_s17_q <= and_3927_s16_q;
      less_3928_s17_q <= counts_explained_q < product_q;
      equal_3929_s17_q <= counts_explained_q == product_q;
      equal_3946_s17_q <= equal_3946_s16_q;
      equal_3948_s17_q <= equal_3948_s16_q;
      equal_3949_s17_q <= equal_3949_s16_q;
      equal_3950_s17_q <= equal_3950_s16_q;
      equal_3951_s17_q <= equal_3951_s16_q;
      sum_4_s17_q <= sum_4[0];
      equal_4091_s17_q <= equal_4091_s16_q;
      equal_4187_s17_q <= equal_4187_s16_q;
      select_4197_s17_q <= less_2644 ? 10'h0 : regions_rdata_s16_q[29:20];
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
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
  logic [13:0] moments_before_0_q;
  logic [13:0] moments_before_1_q;
  logic sharpness_last_mask_q;
  logic sharpness_before_last_mask_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_nearer_q;
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
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
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
  // hls/stages/agreement.hpp:456
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_q & whole_9_s17_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s17_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s17_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s17_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s17_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:284
  logic [10:0] sum_719;
  assign sum_719 = sum_715_s17_q + {1'b0, sum_718_s17_q};
  // hls/stages/agreement.hpp:456
  logic and_733;
  assign and_733 = census_columns_values_0_cell_2_mask_s17_q & census_columns_values_1_cell_2_mask_q;
  logic and_734;
  assign and_734 = and_682_s17_q & and_733;
  // hls/stages/registration.hpp:265
  logic equal_1663;
  assign equal_1663 = sum_1612_s17_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1612_s17_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1669;
  assign select_1669 = equal_1663 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1670;
  assign sum_1670 = (equal_1661_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0) + {{5{select_1669[6]}}, select_1669};
  // hls/stages/patches.hpp:355
  logic [21:0] select_1803;
  assign select_1803 = select_1688_s17_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1799_s17_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1804;
  assign select_1804 = equal_1689_s17_q ? patches_place_0_column_q : select_1803[7:0];
  logic [5:0] select_1805;
  assign select_1805 = equal_1689_s17_q ? patches_place_0_shift_q : select_1803[13:8];
  // hls/stages/patches.hpp:355
  logic [21:0] select_1831;
  assign select_1831 = select_1688_s17_q ? select_1799_s17_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1832;
  assign select_1832 = equal_1689_s17_q ? patches_place_1_column_q : select_1831[7:0];
  logic [5:0] select_1833;
  assign select_1833 = equal_1689_s17_q ? patches_place_1_shift_q : select_1831[13:8];
  // hls/stages/patches.hpp:133
  logic equal_1848;
  assign equal_1848 = {select_1804[7], select_542_s17_q, select_507_s17_q} == {1'b0, select_1804[6:0], 4'h0};
  logic equal_1852;
  assign equal_1852 = {select_1832[7], select_542_s17_q, select_507_s17_q} == {1'b0, select_1832[6:0], 4'h0};
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2038_s17_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2041;
  assign select_2041 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1301
  logic equal_2044;
  assign equal_2044 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1274
  logic not_2051;
  assign not_2051 = ~marks_first_s17_q;
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2072;
  assign select_2072 = age_s17_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2088;
  assign not_2088 = ~region_row_s17_q[2];
  logic [2:0] select_2089;
  assign select_2089 = region_row_s17_q[1] ? {1'b0, not_2088, 1'b0} : {region_row_s17_q[2], 1'b0, not_2088};
  logic [5:0] select_2090;
  assign select_2090 = region_row_s17_q[0] ? {select_2089[2], 1'b0, select_2089[1], 1'b0, select_2089[0], 1'b0} : {1'b0, select_2089[2], 1'b0, select_2089[1], 1'b0, select_2089[0]};
  logic [11:0] select_2091;
  assign select_2091 = or_2087_s17_q ? {select_2090[5], 1'b0, select_2090[4], 1'b0, select_2090[3], 1'b0, select_2090[2], 1'b0, select_2090[1], 1'b0, select_2090[0], 1'b0} : {1'b0, select_2090[5], 1'b0, select_2090[4], 1'b0, select_2090[3], 1'b0, select_2090[2], 1'b0, select_2090[1], 1'b0, select_2090[0]};
  logic [23:0] select_2092;
  assign select_2092 = or_2084_s17_q ? {select_2091[11], 1'b0, select_2091[10], 1'b0, select_2091[9], 1'b0, select_2091[8], 1'b0, select_2091[7], 1'b0, select_2091[6], 1'b0, select_2091[5], 1'b0, select_2091[4], 1'b0, select_2091[3], 1'b0, select_2091[2], 1'b0, select_2091[1], 1'b0, select_2091[0], 1'b0} : {1'b0, select_2091[11], 1'b0, select_2091[10], 1'b0, select_2091[9], 1'b0, select_2091[8], 1'b0, select_2091[7], 1'b0, select_2091[6], 1'b0, select_2091[5], 1'b0, select_2091[4], 1'b0, select_2091[3], 1'b0, select_2091[2], 1'b0, select_2091[1], 1'b0, select_2091[0]};
  // hls/stages/agreement.hpp:1096
  logic [4:0] around;
  assign around = {difference_2107_s17_q[3], difference_2107_s17_q} + (equal_568_s17_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1097
  logic [4:0] n;
  assign n = {difference_2123_s17_q[3], difference_2123_s17_q} + (equal_568_s17_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size_s17_q} + (equal_551_s17_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2181;
  assign select_2181 = sample_pair_whole_s17_q ? (and_546_s17_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s17_q} + (equal_551_s17_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2189;
  assign select_2189 = sample_pair_whole_s17_q ? (and_546_s17_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:520
  logic select_2222;
  assign select_2222 = and_548_s17_q ? census_columns_values_0_cell_2_mask_s17_q : census_columns_values_1_cell_2_mask_q;
  logic select_2238;
  assign select_2238 = and_548_s17_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2241;
  assign select_2241 = and_548_s17_q ? census_columns_values_1_cell_3_mask_s17_q : census_columns_values_2_cell_3_mask_q;
  logic select_2244;
  assign select_2244 = and_548_s17_q ? census_columns_values_1_cell_4_mask_s17_q : census_columns_values_2_cell_4_mask_q;
  logic select_2245;
  assign select_2245 = and_548_s17_q ? census_columns_values_2_cell_0_mask_s17_q : census_columns_values_3_cell_0_mask_q;
  logic select_2248;
  assign select_2248 = and_548_s17_q ? census_columns_values_2_cell_1_mask_s17_q : census_columns_values_3_cell_1_mask_q;
  logic select_2249;
  assign select_2249 = and_548_s17_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2252;
  assign select_2252 = and_548_s17_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:286
  logic [10:0] sum_2265;
  assign sum_2265 = sum_2261_s17_q + {1'b0, sum_2264_s17_q};
  // hls/stages/moments.hpp:117
  logic [13:0] select_2296;
  assign select_2296 = equal_2295_s17_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2298;
  assign select_2298 = equal_2295_s17_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2309;
  assign sum_2309 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2319;
  assign sum_2319 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/agreement.hpp:520
  logic select_2362;
  assign select_2362 = and_548_s17_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2365;
  assign and_2365 = whole_2_s17_q & (~(last_s17_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2371;
  assign and_2371 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s17_q[8:2]));
  logic and_2372;
  assign and_2372 = and_2365 & and_2371;
  logic and_2383;
  assign and_2383 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s17_q[8:2]));
  logic and_2384;
  assign and_2384 = and_2365 & and_2383;
  // hls/stages/census.hpp:427
  logic not_2401;
  assign not_2401 = ~x_s17_q[1];
  logic [2:0] select_2402;
  assign select_2402 = x_s17_q[0] ? {1'b0, not_2401, 1'b0} : {x_s17_q[1], 1'b0, not_2401};
  logic [5:0] select_2403;
  assign select_2403 = slot_s17_q[2] ? {select_2402[2], 1'b0, select_2402[1], 1'b0, select_2402[0], 1'b0} : {1'b0, select_2402[2], 1'b0, select_2402[1], 1'b0, select_2402[0]};
  logic [11:0] select_2404;
  assign select_2404 = slot_s17_q[1] ? {select_2403[5], 1'b0, select_2403[4], 1'b0, select_2403[3], 1'b0, select_2403[2], 1'b0, select_2403[1], 1'b0, select_2403[0], 1'b0} : {1'b0, select_2403[5], 1'b0, select_2403[4], 1'b0, select_2403[3], 1'b0, select_2403[2], 1'b0, select_2403[1], 1'b0, select_2403[0]};
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2602;
  assign select_2602 = and_2594_s17_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2600_s17_q});
  logic [13:0] select_2617;
  assign select_2617 = and_2594_s17_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2615_s17_q});
  // hls/stages/agreement.hpp:1095
  logic [4:0] e;
  assign e = {difference_2629_s17_q[3], difference_2629_s17_q} + (equal_568_s17_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2715;
  assign select_2715 = and_2594_s17_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2713_s17_q});
  logic [13:0] select_2722;
  assign select_2722 = and_2594_s17_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2720_s17_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2772;
  assign select_2772 = equal_1699_s17_q ? (and_2755_s17_q ? residual_s17_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_2779;
  assign and_2779 = not_574_s17_q & (so_s17_q & (and_2755_s17_q & equal_1699_s17_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2781;
  assign select_2781 = and_2754_s17_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2779});
  // hls/stages/registration.hpp:107
  logic and_2783;
  assign and_2783 = and_2755_s17_q & ($signed(residual_s17_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2785;
  assign select_2785 = so_s17_q ? (equal_1699_s17_q ? {and_2783, and_2755_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2793;
  assign select_2793 = so_s17_q ? (equal_1699_s17_q ? {and_2791_s17_q, and_2755_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2794;
  assign select_2794 = equal_573_s17_q ? 2'h0 : select_2793;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2795;
  assign sum_2795 = registration_half_votes_up_q + {{5{select_2794[1]}}, select_2794};
  // hls/stages/registration.hpp:205
  logic less_2797;
  assign less_2797 = $signed(residual_s17_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2798;
  assign and_2798 = and_2755_s17_q & less_2797;
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2800;
  assign select_2800 = so_s17_q ? (equal_1699_s17_q ? {and_2798, and_2755_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2807;
  assign select_2807 = so_s17_q ? (equal_1699_s17_q ? {and_2805_s17_q, and_2755_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2808;
  assign select_2808 = equal_573_s17_q ? 2'h0 : select_2807;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2809;
  assign sum_2809 = registration_half_half_votes_up_q + {{5{select_2808[1]}}, select_2808};
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2850;
  assign select_2850 = or_1641_s17_q ? 12'h0 : (equal_2848_s17_q ? registration_sums_rdata_s17_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2852;
  assign select_2852 = equal_1606_s17_q ? 12'h0 : (less_1637_s17_q ? select_2850 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2855;
  assign and_2855 = x_s17_q[1] & all_s17_q;
  // hls/stages/agreement.hpp:1142
  logic and_2858;
  assign and_2858 = not_1991_s17_q & (less_1637_s17_q & ({and_2855, x_s17_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2865;
  assign select_2865 = or_1641_s17_q ? 12'h0 : (equal_2848_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2867;
  assign select_2867 = equal_1606_s17_q ? 12'h0 : (less_1637_s17_q ? select_2865 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2873;
  assign not_2873 = ~all_s17_q;
  // hls/stages/agreement.hpp:1142
  logic and_2876;
  assign and_2876 = not_1991_s17_q & (less_1637_s17_q & (x_s17_q[2:0] == {all_s17_q, not_2873, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2882;
  assign and_2882 = equal_573_s17_q & (x_s17_q[6] & (not_1991_s17_q & (less_1637_s17_q & all_s17_q)));
  // hls/stages/registration.hpp:157
  logic equal_2909;
  assign equal_2909 = x_s17_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2912;
  assign and_2912 = not_1991_s17_q & (less_1637_s17_q & (x_s17_q[5] ? x_s17_q[3] : equal_2909));
  logic and_2921;
  assign and_2921 = not_1991_s17_q & (less_1637_s17_q & ((~x_s17_q[5]) & (x_s17_q[3] & equal_2909)));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3015;
  assign select_3015 = sample_pair_whole_s17_q ? (equal_1689_s17_q ? patches_place_0_slope_q : select_1803[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3020;
  assign select_3020 = sample_pair_whole_s17_q ? (equal_1689_s17_q ? patches_place_1_slope_q : select_1831[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:185
  logic [2:0] select_3139;
  assign select_3139 = equal_1785_s17_q ? 3'h0 : (or_1789_s17_q ? select_3137_s17_q : 3'h0);
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3142;
  assign sum_3142 = {7'h0, patches_set_q} + (equal_1788_s17_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3222;
  assign xor_3222 = xor_3209_s17_q ^ xor_3221_s17_q;
  // hls/stages/count_bits.hpp:25
  logic or_3347;
  assign or_3347 = (xor_3209_s17_q & xor_3221_s17_q) | (xor_3197_s17_q & (xor_3209_s17_q | xor_3221_s17_q));
  // hls/stages/patches.hpp:584
  logic [1:0] sum_3636;
  assign sum_3636 = {1'b0, not_3632_s17_q} + {1'b0, not_3635_s17_q};
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3643;
  assign sum_3643 = {1'b0, not_3639_s17_q} + {1'b0, not_3642_s17_q};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3636} + {1'b0, sum_3643};
  // hls/stages/patches.hpp:598
  logic [7:0] select_3647;
  assign select_3647 = patches_second_s17_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:597
  logic [3:0] sum_3648;
  assign sum_3648 = {2'h0, select_3581_s17_q[14:13]} + 4'hf;
  logic [5:0] select_3649;
  assign select_3649 = patches_second_s17_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3650;
  assign sum_3650 = {select_3649[5], select_3649} + {{4{sum_3648[3]}}, sum_3648[3:1]};
  // hls/stages/agreement.hpp:1188
  logic or_3924;
  assign or_3924 = ({counts_textured_s17_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s17_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = less_3928_s17_q | (product_rest_q & equal_3929_s17_q);
  // hls/stages/agreement.hpp:1227
  logic select_3932;
  assign select_3932 = and_3927_s17_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3935;
  assign sum_3935 = {1'b0, select_2648_s17_q} + {2'h0, select_2648_s17_q[9:1]};
  // hls/stages/agreement.hpp:788
  logic select_3988;
  assign select_3988 = equal_573_s17_q ? (equal_3702_s17_q ? sum_4_s17_q : (product_rest_q | sum_4_s17_q)) : product_rest_q;
  logic [2:0] select_4006;
  assign select_4006 = ends_cell_s17_q ? textured_2_s17_q : box_textured_columns_values_0_q;
  logic [2:0] select_4008;
  assign select_4008 = equal_573_s17_q ? box_textured_columns_values_0_q : (so_s17_q ? select_4006 : box_textured_columns_values_0_q);
  logic [2:0] select_4009;
  assign select_4009 = ends_cell_s17_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4011;
  assign select_4011 = equal_573_s17_q ? box_textured_columns_values_1_q : (so_s17_q ? select_4009 : box_textured_columns_values_1_q);
  logic [2:0] select_4012;
  assign select_4012 = ends_cell_s17_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4014;
  assign select_4014 = equal_573_s17_q ? box_textured_columns_values_2_q : (so_s17_q ? select_4012 : box_textured_columns_values_2_q);
  logic [2:0] select_4015;
  assign select_4015 = ends_cell_s17_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4017;
  assign select_4017 = equal_573_s17_q ? box_textured_columns_values_3_q : (so_s17_q ? select_4015 : box_textured_columns_values_3_q);
  logic [2:0] select_4018;
  assign select_4018 = ends_cell_s17_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4020;
  assign select_4020 = equal_573_s17_q ? box_textured_columns_values_4_q : (so_s17_q ? select_4018 : box_textured_columns_values_4_q);
  logic [4:0] select_4040;
  assign select_4040 = so_s17_q ? (ends_cell_s17_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4041;
  assign select_4041 = equal_573_s17_q ? box_explained_sum_sums_values_0_q : select_4040;
  logic [4:0] select_4058;
  assign select_4058 = so_s17_q ? (ends_cell_s17_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4076;
  assign select_4076 = so_s17_q ? (ends_cell_s17_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1300
  logic [3:0] select_4108;
  assign select_4108 = select_2038_s17_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4114;
  assign select_4114 = marks_first_s17_q ? (less_4110 ? {sum_4111, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4189;
  assign select_4189 = equal_1628_s17_q ? {2'h0, counts_explained_s17_q, 2'h0, counts_textured_s17_q} : (equal_4187_s17_q ? registration_sums_rdata_s17_q : 32'h0);
  logic [31:0] select_4190;
  assign select_4190 = equal_1626_s17_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4189;

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s17_q, or_1989_s17_q, or_1986_s17_q, or_1983_s17_q};
  logic regions_we;
  assign regions_we = s17_en & and_2023_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2022_s17_q, sum_2012_s17_q, sum_2007_s17_q};
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
      sharpness_before_last_mask_q <= 1'b0;
      counts_supervised_q <= 14'h0;
      counts_nearer_q <= 14'h0;
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
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
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
      moments_before_0_q <= equal_573_s17_q ? select_2296 : moments_before_0_q;
      moments_before_1_q <= equal_573_s17_q ? select_2298 : moments_before_1_q;
      sharpness_before_last_mask_q <= select_2362;
      counts_supervised_q <= select_2602;
      counts_nearer_q <= select_2617;
      counts_turned_left_q <= select_2715;
      counts_turned_right_q <= select_2722;
      registration_half_measured_q <= select_2781;
      registration_half_votes_up_q <= and_2754_s17_q ? 7'h0 : sum_2795;
      registration_half_half_votes_up_q <= and_2754_s17_q ? 7'h0 : sum_2809;
      patches_place_0_column_q <= sample_pair_whole_s17_q ? select_1804 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s17_q ? select_1805 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3015;
      patches_place_1_column_q <= sample_pair_whole_s17_q ? select_1832 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s17_q ? select_1833 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3020;
      patches_set_q <= equal_1783_s17_q ? 3'h0 : select_3139;
      patches_size_q <= sum_3142;
      product_rest_q <= select_3988;
      disagree_q <= equal_573_s17_q ? select_3932 : disagree_q;
      began_q <= not_2051 & (began_q | select_2038_s17_q);
      seen_x_q <= select_2038_s17_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s17_q ? 4'h0 : select_4108;
      seen_column_q <= select_2038_s17_q ? 8'h0 : (seen_column_q + {7'h0, equal_2044});
      seen_rows_left_q <= select_4114;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s17_q ? 13'h0 : (seen_base_q + {6'h0, select_2041});
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
      averager_detail_0_q <= select_2181;
      averager_detail_1_q <= select_2189;
      census_columns_values_1_cell_2_mask_q <= select_2222;
      census_columns_values_2_cell_2_mask_q <= select_2238;
      census_columns_values_2_cell_3_mask_q <= select_2241;
      census_columns_values_2_cell_4_mask_q <= select_2244;
      census_columns_values_3_cell_0_mask_q <= select_2245;
      census_columns_values_3_cell_1_mask_q <= select_2248;
      census_columns_values_3_cell_2_mask_q <= select_2249;
      census_columns_values_3_cell_3_mask_q <= select_2252;
      sharpness_last_mask_q <= and_548_s17_q ? whole_2_s17_q : sharpness_last_mask_q;
      box_textured_columns_values_0_q <= select_4008;
      box_textured_columns_values_1_q <= select_4011;
      box_textured_columns_values_2_q <= select_4014;
      box_textured_columns_values_3_q <= select_4017;
      box_textured_columns_values_4_q <= select_4020;
      box_explained_sum_sums_values_0_q <= select_4041;
      box_shown_sum_sums_values_0_q <= equal_573_s17_q ? box_shown_sum_sums_values_0_q : select_4058;
      box_nearer_sum_sums_values_0_q <= equal_573_s17_q ? box_nearer_sum_sums_values_0_q : select_4076;
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
  logic census_columns_values_1_cell_2_of_skin_s18_q;
  logic census_columns_values_2_cell_4_mask_s18_q;
  logic census_columns_values_3_cell_0_mask_s18_q;
  logic census_columns_values_3_cell_1_mask_s18_q;
  logic census_columns_values_3_cell_2_mask_s18_q;
  logic census_columns_values_3_cell_3_mask_s18_q;
  logic [6:0] x_s18_q;
  logic slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic [13:0] counts_nearer_s18_q;
  logic [11:0] counts_turned_left_s18_q;
  logic [11:0] counts_turned_right_s18_q;
  logic registration_of_right_s18_q;
  logic patches_lower_s18_q;
  logic patches_second_s18_q;
  logic [4:0] patches_summed_row_column_s18_q;
  logic patches_summed_first_s18_q;
  logic patches_summed_last_s18_q;
  logic [4:0] patches_summed_down_by_s18_q;
  logic [13:0] product_s18_q;
  logic centres_values_1_textured_s18_q;
  logic centres_values_1_of_skin_s18_q;
  logic [2:0] select_507_s18_q;
  logic row_starts_s18_q;
  logic [6:0] last_s18_q;
  logic and_548_s18_q;
  logic equal_568_s18_q;
  logic equal_573_s18_q;
  logic not_574_s18_q;
  logic so_s18_q;
  logic less_651_s18_q;
  logic less_652_s18_q;
  logic less_653_s18_q;
  logic less_654_s18_q;
  logic less_655_s18_q;
  logic less_656_s18_q;
  logic less_657_s18_q;
  logic less_658_s18_q;
  logic less_659_s18_q;
  logic less_660_s18_q;
  logic less_661_s18_q;
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
  logic and_682_s18_q;
  logic whole_16_s18_q;
  logic and_708_s18_q;
  logic [11:0] sum_723_s18_q;
  logic [9:0] sum_726_s18_q;
  logic and_734_s18_q;
  logic and_738_s18_q;
  logic less_739_s18_q;
  logic less_743_s18_q;
  logic less_745_s18_q;
  logic equal_1606_s18_q;
  logic [1:0] sum_1612_s18_q;
  logic equal_1614_s18_q;
  logic equal_1616_s18_q;
  logic equal_1618_s18_q;
  logic equal_1620_s18_q;
  logic equal_1622_s18_q;
  logic equal_1624_s18_q;
  logic less_1637_s18_q;
  logic [19:0] select_1662_s18_q;
  logic equal_1663_s18_q;
  logic [11:0] sum_1670_s18_q;
  logic and_1671_s18_q;
  logic select_1688_s18_q;
  logic equal_1689_s18_q;
  logic equal_1783_s18_q;
  logic equal_1785_s18_q;
  logic select_1799_s18_q;
  logic [8:0] sum_1802_s18_q;
  logic [8:0] sum_1806_s18_q;
  logic [4:0] select_1813_s18_q;
  logic select_1819_s18_q;
  logic [8:0] sum_1834_s18_q;
  logic equal_1848_s18_q;
  logic equal_1852_s18_q;
  logic [3:0] select_1857_s18_q;
  logic less_1961_s18_q;
  logic equal_1962_s18_q;
  logic not_1963_s18_q;
  logic equal_1964_s18_q;
  logic not_1991_s18_q;
  logic not_2051_s18_q;
  logic [7:0] sum_2061_s18_q;
  logic [3:0] difference_2073_s18_q;
  logic or_2081_s18_q;
  logic [23:0] select_2092_s18_q;
  logic [4:0] around_s18_q;
  logic less_2126_s18_q;
  logic and_2137_s18_q;
  logic [11:0] sum_2269_s18_q;
  logic [9:0] sum_2272_s18_q;
  logic equal_2280_s18_q;
  logic equal_2295_s18_q;
  logic [13:0] select_2303_s18_q;
  logic not_2311_s18_q;
  logic not_2314_s18_q;
  logic not_2321_s18_q;
  logic not_2324_s18_q;
  logic [27:0] select_2359_s18_q;
  logic and_2372_s18_q;
  logic and_2384_s18_q;
  logic [8:0] select_2391_s18_q;
  logic [8:0] select_2395_s18_q;
  logic equal_2398_s18_q;
  logic less_2399_s18_q;
  logic [11:0] select_2404_s18_q;
  logic equal_2442_s18_q;
  logic equal_2469_s18_q;
  logic and_2594_s18_q;
  logic not_2619_s18_q;
  logic [4:0] e_s18_q;
  logic [9:0] select_2645_s18_q;
  logic [9:0] select_2648_s18_q;
  logic and_2696_s18_q;
  logic and_2754_s18_q;
  logic [7:0] select_2774_s18_q;
  logic [1:0] select_2786_s18_q;
  logic [1:0] select_2801_s18_q;
  logic [11:0] select_2852_s18_q;
  logic and_2860_s18_q;
  logic [11:0] select_2867_s18_q;
  logic and_2878_s18_q;
  logic and_2882_s18_q;
  logic and_2914_s18_q;
  logic and_2922_s18_q;
  logic parity_3226_s18_q;
  logic or_3230_s18_q;
  logic or_3234_s18_q;
  logic or_3238_s18_q;
  logic or_3245_s18_q;
  logic or_3249_s18_q;
  logic or_3253_s18_q;
  logic or_3260_s18_q;
  logic or_3264_s18_q;
  logic or_3268_s18_q;
  logic or_3278_s18_q;
  logic or_3282_s18_q;
  logic or_3286_s18_q;
  logic or_3294_s18_q;
  logic or_3298_s18_q;
  logic or_3302_s18_q;
  logic or_3309_s18_q;
  logic or_3313_s18_q;
  logic or_3317_s18_q;
  logic or_3327_s18_q;
  logic or_3331_s18_q;
  logic or_3335_s18_q;
  logic and_3339_s18_q;
  logic or_3343_s18_q;
  logic or_3347_s18_q;
  logic equal_3462_s18_q;
  logic [4:0] select_3550_s18_q;
  logic [12:0] select_3581_s18_q;
  logic [9:0] select_3591_s18_q;
  logic less_3624_s18_q;
  logic [2:0] fraction_s18_q;
  logic [7:0] select_3647_s18_q;
  logic sum_3648_s18_q;
  logic [6:0] sum_3650_s18_q;
  logic equal_3702_s18_q;
  logic equal_3921_s18_q;
  logic or_3924_s18_q;
  logic select_3932_s18_q;
  logic not_3937_s18_q;
  logic equal_3946_s18_q;
  logic equal_3948_s18_q;
  logic equal_3949_s18_q;
  logic equal_3950_s18_q;
  logic equal_3951_s18_q;
  logic equal_4091_s18_q;
  logic [31:0] select_4190_s18_q;
  logic [9:0] select_4197_s18_q;
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
      census_columns_values_1_cell_2_of_skin_s18_q <= census_columns_values_1_cell_2_of_skin_s17_q;
      census_columns_values_2_cell_4_mask_s18_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s18_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s18_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s18_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s18_q <= census_columns_values_3_cell_3_mask_q;
      x_s18_q <= x_s17_q[6:0];
      slot_s18_q <= slot_s17_q[0];
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      counts_nearer_s18_q <= counts_nearer_q;
      counts_turned_left_s18_q <= counts_turned_left_q[13:2];
      counts_turned_right_s18_q <= counts_turned_right_q[13:2];
      registration_of_right_s18_q <= registration_of_right_s17_q;
      patches_lower_s18_q <= patches_lower_s17_q;
      patches_second_s18_q <= patches_second_s17_q;
      patches_summed_row_column_s18_q <= patches_summed_row_column_s17_q;
      patches_summed_first_s18_q <= patches_summed_first_s17_q;
      patches_summed_last_s18_q <= patches_summed_last_s17_q;
      patches_summed_down_by_s18_q <= patches_summed_down_by_s17_q;
      product_s18_q <= product_s17_q;
      centres_values_1_textured_s18_q <= centres_values_1_textured_s17_q;
      centres_values_1_of_skin_s18_q <= centres_values_1_of_skin_s17_q;
      select_507_s18_q <= select_507_s17_q[2:0];
      row_starts_s18_q <= row_starts_s17_q;
      last_s18_q <= last_s17_q;
      and_548_s18_q <= and_548_s17_q;
      equal_568_s18_q <= equal_568_s17_q;
      equal_573_s18_q <= equal_573_s17_q;
      not_574_s18_q <= not_574_s17_q;
      so_s18_q <= so_s17_q;
      less_651_s18_q <= less_651_s17_q;
      less_652_s18_q <= less_652_s17_q;
      less_653_s18_q <= less_653_s17_q;
      less_654_s18_q <= less_654_s17_q;
      less_655_s18_q <= less_655_s17_q;
      less_656_s18_q <= less_656_s17_q;
      less_657_s18_q <= less_657_s17_q;
      less_658_s18_q <= less_658_s17_q;
      less_659_s18_q <= less_659_s17_q;
      less_660_s18_q <= less_660_s17_q;
      less_661_s18_q <= less_661_s17_q;
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
      and_682_s18_q <= and_682_s17_q;
      whole_16_s18_q <= whole_16;
      and_708_s18_q <= census_columns_values_1_cell_2_mask_q & and_682_s17_q;
      sum_723_s18_q <= {1'b0, sum_719} + {2'h0, sum_722_s17_q};
      sum_726_s18_q <= sum_726_s17_q;
      and_734_s18_q <= and_734;
      and_738_s18_q <= and_734 & less_737_s17_q;
      less_739_s18_q <= less_739_s17_q;
      less_743_s18_q <= less_743_s17_q;
      less_745_s18_q <= less_745_s17_q;
      equal_1606_s18_q <= equal_1606_s17_q;
      sum_1612_s18_q <= sum_1612_s17_q;
      equal_1614_s18_q <= equal_1614_s17_q;
      equal_1616_s18_q <= equal_1616_s17_q;
      equal_1618_s18_q <= equal_1618_s17_q;
      equal_1620_s18_q <= equal_1620_s17_q;
      equal_1622_s18_q <= equal_1622_s17_q;
      equal_1624_s18_q <= equal_1624_s17_q;
      less_1637_s18_q <= less_1637_s17_q;
      select_1662_s18_q <= equal_1661_s17_q ? registration_sums_rdata_s17_q[19:0] : 20'h0;
      equal_1663_s18_q <= equal_1663;
      sum_1670_s18_q <= sum_1670;
      and_1671_s18_q <= and_1671_s17_q;
      select_1688_s18_q <= select_1688_s17_q;
      equal_1689_s18_q <= equal_1689_s17_q;
      equal_1783_s18_q <= equal_1783_s17_q;
      equal_1785_s18_q <= equal_1785_s17_q;
      select_1799_s18_q <= select_1799_s17_q[0];
      sum_1802_s18_q <= {1'b0, select_542_s17_q, select_507_s17_q[3]} + 9'h1;
      sum_1806_s18_q <= {1'b0, select_1804} + {{3{select_1805[5]}}, select_1805};
      select_1813_s18_q <= select_1813_s17_q;
      select_1819_s18_q <= select_1819_s17_q;
      sum_1834_s18_q <= {1'b0, select_1832} + {{3{select_1833[5]}}, select_1833};
      equal_1848_s18_q <= equal_1848;
      equal_1852_s18_q <= equal_1852;
      select_1857_s18_q <= select_1857_s17_q;
      less_1961_s18_q <= less_1961_s17_q;
      equal_1962_s18_q <= equal_1962_s17_q;
      not_1963_s18_q <= not_1963_s17_q;
      equal_1964_s18_q <= equal_1964_s17_q;
      not_1991_s18_q <= not_1991_s17_q;
      not_2051_s18_q <= not_2051;
      sum_2061_s18_q <= {2'h0, x_s17_q[7:2]} + 8'hff;
      difference_2073_s18_q <= {1'b0, textured_2_s17_q} - {1'b0, select_2072};
      or_2081_s18_q <= or_2081_s17_q;
      select_2092_s18_q <= select_2092;
      around_s18_q <= around;
      less_2126_s18_q <= {1'b0, around[4:1]} < n;
      and_2137_s18_q <= and_2137_s17_q;
      sum_2269_s18_q <= {1'b0, sum_2265} + {2'h0, sum_2268_s17_q};
      sum_2272_s18_q <= sum_2272_s17_q;
      equal_2280_s18_q <= equal_2280_s17_q;
      equal_2295_s18_q <= equal_2295_s17_q;
      select_2303_s18_q <= (select_2298 < select_2296) ? select_2296 : select_2298;
      not_2311_s18_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2309);
      not_2314_s18_q <= ~({3'h0, select_2298[13:2]} < sum_2309);
      not_2321_s18_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2319);
      not_2324_s18_q <= ~({3'h0, select_2296[13:2]} < sum_2319);
      select_2359_s18_q <= sample_pair_whole_s17_q ? {detail_2, detail} : 28'h0;
      and_2372_s18_q <= and_2372;
      and_2384_s18_q <= and_2384;
      select_2391_s18_q <= and_2372 ? contrast_s17_q : 9'h0;
      select_2395_s18_q <= and_2384 ? contrast_2_s17_q : 9'h0;
      equal_2398_s18_q <= x_s17_q[7:3] == 5'h0;
      less_2399_s18_q <= 7'h2 < {x_s17_q[4:0], slot_s17_q[2:1]};
      select_2404_s18_q <= select_2404;
      equal_2442_s18_q <= {x_s17_q[4:0], slot_s17_q} == 8'h0;
      equal_2469_s18_q <= equal_2469_s17_q;
      and_2594_s18_q <= and_2594_s17_q;
      not_2619_s18_q <= not_2619_s17_q;
      e_s18_q <= e;
      select_2645_s18_q <= select_2645_s17_q;
      select_2648_s18_q <= select_2648_s17_q;
      and_2696_s18_q <= and_2696_s17_q;
      and_2754_s18_q <= and_2754_s17_q;
      select_2774_s18_q <= equal_573_s17_q ? 8'h0 : (so_s17_q ? select_2772 : 8'h0);
      select_2786_s18_q <= equal_573_s17_q ? 2'h0 : select_2785;
      select_2801_s18_q <= equal_573_s17_q ? 2'h0 : select_2800;
      select_2852_s18_q <= select_2852;
      and_2860_s18_q <= equal_573_s17_q & (x_s17_q[6] & and_2858);
      select_2867_s18_q <= select_2867;
      and_2878_s18_q <= equal_573_s17_q & (x_s17_q[6] & and_2876);
      and_2882_s18_q <= and_2882;
      and_2914_s18_q <= equal_573_s17_q & (x_s17_q[6] & and_2912);
      and_2922_s18_q <= x_s17_q[6] & and_2921;
      parity_3226_s18_q <= ^{xor_3222, xor_3185_s17_q, select_3152_s17_q, other_s17_q};
      or_3230_s18_q <= or_3230_s17_q;
      or_3234_s18_q <= or_3234_s17_q;
      or_3238_s18_q <= or_3238_s17_q;
      or_3245_s18_q <= or_3245_s17_q;
      or_3249_s18_q <= or_3249_s17_q;
      or_3253_s18_q <= or_3253_s17_q;
      or_3260_s18_q <= or_3260_s17_q;
      or_3264_s18_q <= or_3264_s17_q;
      or_3268_s18_q <= or_3268_s17_q;
      or_3278_s18_q <= or_3278_s17_q;
      or_3282_s18_q <= or_3282_s17_q;
      or_3286_s18_q <= or_3286_s17_q;
      or_3294_s18_q <= or_3294_s17_q;
      or_3298_s18_q <= or_3298_s17_q;
      or_3302_s18_q <= or_3302_s17_q;
      or_3309_s18_q <= or_3309_s17_q;
      or_3313_s18_q <= or_3313_s17_q;
      or_3317_s18_q <= or_3317_s17_q;
      or_3327_s18_q <= or_3327_s17_q;
      or_3331_s18_q <= or_3331_s17_q;
      or_3335_s18_q <= or_3335_s17_q;
      and_3339_s18_q <= xor_3185_s17_q & (^{xor_3222, select_3152_s17_q, other_s17_q});
      or_3343_s18_q <= and_3340_s17_q | (xor_3167_s17_q & or_3341_s17_q);
      or_3347_s18_q <= or_3347;
      equal_3462_s18_q <= equal_3462_s17_q;
      select_3550_s18_q <= select_3550_s17_q;
      select_3581_s18_q <= select_3581_s17_q[12:0];
      select_3591_s18_q <= select_3591_s17_q;
      less_3624_s18_q <= less_3624_s17_q;
      fraction_s18_q <= fraction;
      select_3647_s18_q <= select_3647;
      sum_3648_s18_q <= sum_3648[0];
      sum_3650_s18_q <= sum_3650;
      equal_3702_s18_q <= equal_3702_s17_q;
      equal_3921_s18_q <= select_2645_s17_q[9:3] == 7'h0;
      or_3924_s18_q <= or_3924;
      select_3932_s18_q <= select_3932;
      not_3937_s18_q <= ~({sum_3935, select_2648_s17_q[0]} < {2'h0, select_2645_s17_q});
      equal_3946_s18_q <= equal_3946_s17_q;
      equal_3948_s18_q <= equal_3948_s17_q;
      equal_3949_s18_q <= equal_3949_s17_q;
      equal_3950_s18_q <= equal_3950_s17_q;
      equal_3951_s18_q <= equal_3951_s17_q;
      equal_4091_s18_q <= equal_4091_s17_q;
      select_4190_s18_q <= select_4190;
      select_4197_s18_q <= select_4197_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_3_cell_4_mask_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [13:0] moments_most_before_q;
  logic moments_left_alone_q;
  logic moments_left_other_stops_q;
  logic moments_right_alone_q;
  logic moments_right_other_stops_q;
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
  logic [47:0] good_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:456
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s18_q & whole_16_s18_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s18_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s18_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s18_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s18_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_723_s18_q + {2'h0, sum_726_s18_q};
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1612_s18_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1665;
  assign select_1665 = equal_1663_s18_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1801;
  assign select_1801 = equal_1689_s18_q ? patches_place_0_valid_q : (select_1688_s18_q ? patches_place_0_valid_q : select_1799_s18_q);
  // hls/stages/patches.hpp:132
  logic equal_1807;
  assign equal_1807 = {sum_1806_s18_q, sum_1802_s18_q[0], select_507_s18_q} == {1'b0, sum_1802_s18_q[8:1], 4'h0};
  // hls/stages/patches.hpp:127
  logic select_1830;
  assign select_1830 = equal_1689_s18_q ? patches_place_1_valid_q : (select_1688_s18_q ? select_1799_s18_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:132
  logic equal_1835;
  assign equal_1835 = {sum_1834_s18_q[8], sum_1802_s18_q, select_507_s18_q} == {1'b0, sum_1834_s18_q[7:0], 4'h0};
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1275
  logic select_2049;
  assign select_2049 = marks_first_s18_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2050;
  assign sum_2050 = {1'b0, {5{select_2049}}, 1'b0, {2{select_2049}}, 1'b0, select_2049} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1111
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2061_s18_q[7]}}, sum_2061_s18_q, x_s18_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2063;
  assign sum_2063 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1094
  logic [4:0] t;
  assign t = {difference_2073_s18_q[3], difference_2073_s18_q} + (equal_568_s18_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic [47:0] select_2093;
  assign select_2093 = or_2081_s18_q ? {select_2092_s18_q[23], 1'b0, select_2092_s18_q[22], 1'b0, select_2092_s18_q[21], 1'b0, select_2092_s18_q[20], 1'b0, select_2092_s18_q[19], 1'b0, select_2092_s18_q[18], 1'b0, select_2092_s18_q[17], 1'b0, select_2092_s18_q[16], 1'b0, select_2092_s18_q[15], 1'b0, select_2092_s18_q[14], 1'b0, select_2092_s18_q[13], 1'b0, select_2092_s18_q[12], 1'b0, select_2092_s18_q[11], 1'b0, select_2092_s18_q[10], 1'b0, select_2092_s18_q[9], 1'b0, select_2092_s18_q[8], 1'b0, select_2092_s18_q[7], 1'b0, select_2092_s18_q[6], 1'b0, select_2092_s18_q[5], 1'b0, select_2092_s18_q[4], 1'b0, select_2092_s18_q[3], 1'b0, select_2092_s18_q[2], 1'b0, select_2092_s18_q[1], 1'b0, select_2092_s18_q[0], 1'b0} : {1'b0, select_2092_s18_q[23], 1'b0, select_2092_s18_q[22], 1'b0, select_2092_s18_q[21], 1'b0, select_2092_s18_q[20], 1'b0, select_2092_s18_q[19], 1'b0, select_2092_s18_q[18], 1'b0, select_2092_s18_q[17], 1'b0, select_2092_s18_q[16], 1'b0, select_2092_s18_q[15], 1'b0, select_2092_s18_q[14], 1'b0, select_2092_s18_q[13], 1'b0, select_2092_s18_q[12], 1'b0, select_2092_s18_q[11], 1'b0, select_2092_s18_q[10], 1'b0, select_2092_s18_q[9], 1'b0, select_2092_s18_q[8], 1'b0, select_2092_s18_q[7], 1'b0, select_2092_s18_q[6], 1'b0, select_2092_s18_q[5], 1'b0, select_2092_s18_q[4], 1'b0, select_2092_s18_q[3], 1'b0, select_2092_s18_q[2], 1'b0, select_2092_s18_q[1], 1'b0, select_2092_s18_q[0]};
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2110;
  assign sum_2110 = {1'b0, around_s18_q} + {2'h0, around_s18_q[4:1]};
  // hls/stages/agreement.hpp:520
  logic select_2253;
  assign select_2253 = and_548_s18_q ? census_columns_values_2_cell_4_mask_s18_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2273;
  assign sum_2273 = sum_2269_s18_q + {2'h0, sum_2272_s18_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2275;
  assign select_2275 = and_548_s18_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2276;
  assign select_2276 = and_548_s18_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2305;
  assign sum_2305 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:520
  logic [13:0] select_2360;
  assign select_2360 = and_548_s18_q ? select_2359_s18_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2361;
  assign select_2361 = and_548_s18_q ? select_2359_s18_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2359_s18_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2359_s18_q[27:14]};
  // hls/stages/census.hpp:375
  logic [23:0] sum_2392;
  assign sum_2392 = (equal_2280_s18_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2391_s18_q};
  logic [23:0] sum_2396;
  assign sum_2396 = (equal_2280_s18_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2395_s18_q};
  // hls/stages/census.hpp:427
  logic less_2400;
  assign less_2400 = x_s18_q[4:0] < 5'h3;
  logic [23:0] select_2405;
  assign select_2405 = slot_s18_q ? {select_2404_s18_q[11], 1'b0, select_2404_s18_q[10], 1'b0, select_2404_s18_q[9], 1'b0, select_2404_s18_q[8], 1'b0, select_2404_s18_q[7], 1'b0, select_2404_s18_q[6], 1'b0, select_2404_s18_q[5], 1'b0, select_2404_s18_q[4], 1'b0, select_2404_s18_q[3], 1'b0, select_2404_s18_q[2], 1'b0, select_2404_s18_q[1], 1'b0, select_2404_s18_q[0], 1'b0} : {1'b0, select_2404_s18_q[11], 1'b0, select_2404_s18_q[10], 1'b0, select_2404_s18_q[9], 1'b0, select_2404_s18_q[8], 1'b0, select_2404_s18_q[7], 1'b0, select_2404_s18_q[6], 1'b0, select_2404_s18_q[5], 1'b0, select_2404_s18_q[4], 1'b0, select_2404_s18_q[3], 1'b0, select_2404_s18_q[2], 1'b0, select_2404_s18_q[1], 1'b0, select_2404_s18_q[0]};
  // hls/stages/census.hpp:390
  logic and_2409;
  assign and_2409 = less_2400 & (~((sharpness_sums_contrast_1_q & select_2405) == 24'h0));
  logic and_2419;
  assign and_2419 = less_2400 & (~((sharpness_sums_contrast_0_q & select_2405) == 24'h0));
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2632;
  assign sum_2632 = {1'b0, e_s18_q} + {2'h0, e_s18_q[4:1]};
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2649;
  assign sum_2649 = {1'b0, select_2648_s18_q} + {3'h0, select_2648_s18_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2775;
  assign sum_2775 = registration_half_across_q + {{6{select_2774_s18_q[7]}}, select_2774_s18_q};
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2787;
  assign sum_2787 = registration_half_votes_down_q + {{5{select_2786_s18_q[1]}}, select_2786_s18_q};
  logic [6:0] sum_2802;
  assign sum_2802 = registration_half_half_votes_down_q + {{5{select_2801_s18_q[1]}}, select_2801_s18_q};
  // hls/stages/agreement.hpp:788
  logic and_2843;
  assign and_2843 = equal_573_s18_q & (x_s18_q[6] & (not_1991_s18_q & less_1637_s18_q));
  logic [11:0] select_2854;
  assign select_2854 = equal_573_s18_q ? (x_s18_q[6] ? select_2852_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2862;
  assign sum_2862 = {{2{select_2854[11]}}, select_2854} + (and_2860_s18_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2869;
  assign select_2869 = equal_573_s18_q ? (x_s18_q[6] ? select_2867_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2871;
  assign sum_2871 = {{2{select_2869[11]}}, select_2869} + (and_2860_s18_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2883;
  assign not_2883 = ~and_2882_s18_q;
  logic less_2884;
  assign less_2884 = $signed({9'h1, {2{not_2883}}, and_2882_s18_q}) < $signed(registration_up_q[13:2]);
  logic select_2885;
  assign select_2885 = and_2878_s18_q ? less_2884 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2889;
  assign and_2889 = x_s18_q[6] & (not_1991_s18_q & (less_1637_s18_q & (x_s18_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2890;
  assign and_2890 = equal_573_s18_q & and_2889;
  // hls/stages/registration.hpp:242
  logic less_2891;
  assign less_2891 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2893;
  assign less_2893 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2895;
  assign equal_2895 = x_s18_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2899;
  assign and_2899 = equal_573_s18_q & (x_s18_q[6] & (not_1991_s18_q & (less_1637_s18_q & equal_2895)));
  // hls/stages/agreement.hpp:1142
  logic and_2906;
  assign and_2906 = x_s18_q[6] & (not_1991_s18_q & (less_1637_s18_q & (x_s18_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2924;
  assign and_2924 = registration_votes_up_q & registration_other_down_q;
  logic select_2926;
  assign select_2926 = registration_votes_down_q ? (registration_other_up_q | and_2924) : and_2924;
  // hls/stages/registration.hpp:138
  logic and_2928;
  assign and_2928 = (equal_573_s18_q & and_2922_s18_q) & (registration_other_enough_q & select_2926);
  logic and_2930;
  assign and_2930 = registration_enough_q & ((and_2914_s18_q & (less_2893 | less_2891)) | and_2928);
  // hls/stages/count_bits.hpp:24
  logic parity_3256;
  assign parity_3256 = ^{or_3253_s18_q, or_3249_s18_q, or_3245_s18_q};
  logic parity_3271;
  assign parity_3271 = ^{or_3268_s18_q, or_3264_s18_q, or_3260_s18_q};
  logic parity_3274;
  assign parity_3274 = ^{or_3268_s18_q, or_3264_s18_q, or_3260_s18_q, or_3253_s18_q, or_3249_s18_q, or_3245_s18_q, or_3238_s18_q, or_3234_s18_q, or_3230_s18_q};
  logic parity_3305;
  assign parity_3305 = ^{or_3302_s18_q, or_3298_s18_q, or_3294_s18_q};
  logic parity_3320;
  assign parity_3320 = ^{or_3317_s18_q, or_3313_s18_q, or_3309_s18_q};
  logic parity_3323;
  assign parity_3323 = ^{or_3317_s18_q, or_3313_s18_q, or_3309_s18_q, or_3302_s18_q, or_3298_s18_q, or_3294_s18_q, or_3286_s18_q, or_3282_s18_q, or_3278_s18_q};
  logic parity_3338;
  assign parity_3338 = ^{or_3335_s18_q, or_3331_s18_q, or_3327_s18_q};
  logic parity_3350;
  assign parity_3350 = ^{or_3347_s18_q, or_3343_s18_q, and_3339_s18_q};
  logic parity_3353;
  assign parity_3353 = ^{or_3347_s18_q, or_3343_s18_q, and_3339_s18_q, or_3335_s18_q, or_3331_s18_q, or_3327_s18_q, or_3317_s18_q, or_3313_s18_q, or_3309_s18_q, or_3302_s18_q, or_3298_s18_q, or_3294_s18_q, or_3286_s18_q, or_3282_s18_q, or_3278_s18_q};
  logic parity_3355;
  assign parity_3355 = ^{or_3347_s18_q, or_3343_s18_q, and_3339_s18_q, or_3335_s18_q, or_3331_s18_q, or_3327_s18_q, or_3317_s18_q, or_3313_s18_q, or_3309_s18_q, or_3302_s18_q, or_3298_s18_q, or_3294_s18_q, or_3286_s18_q, or_3282_s18_q, or_3278_s18_q, or_3268_s18_q, or_3264_s18_q, or_3260_s18_q, or_3253_s18_q, or_3249_s18_q, or_3245_s18_q, or_3238_s18_q, or_3234_s18_q, or_3230_s18_q};
  // hls/stages/count_bits.hpp:25
  logic and_3356;
  assign and_3356 = parity_3274 & parity_3353;
  logic and_3359;
  assign and_3359 = (^{or_3238_s18_q, or_3234_s18_q, or_3230_s18_q}) & (parity_3256 | parity_3271);
  logic or_3360;
  assign or_3360 = (parity_3256 & parity_3271) | and_3359;
  logic or_3364;
  assign or_3364 = (parity_3338 & parity_3350) | (parity_3323 & (parity_3338 | parity_3350));
  logic and_3370;
  assign and_3370 = (^{or_3286_s18_q, or_3282_s18_q, or_3278_s18_q}) & (parity_3305 | parity_3320);
  logic or_3371;
  assign or_3371 = (parity_3305 & parity_3320) | and_3370;
  logic or_3375;
  assign or_3375 = (or_3331_s18_q & or_3335_s18_q) | (or_3327_s18_q & (or_3331_s18_q | or_3335_s18_q));
  logic or_3379;
  assign or_3379 = (or_3343_s18_q & or_3347_s18_q) | (and_3339_s18_q & (or_3343_s18_q | or_3347_s18_q));
  // hls/stages/count_bits.hpp:23
  logic or_3386;
  assign or_3386 = (or_3282_s18_q & or_3286_s18_q) | (or_3278_s18_q & (or_3282_s18_q | or_3286_s18_q));
  // hls/stages/count_bits.hpp:25
  logic or_3390;
  assign or_3390 = (or_3298_s18_q & or_3302_s18_q) | (or_3294_s18_q & (or_3298_s18_q | or_3302_s18_q));
  logic or_3394;
  assign or_3394 = (or_3313_s18_q & or_3317_s18_q) | (or_3309_s18_q & (or_3313_s18_q | or_3317_s18_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3397;
  assign parity_3397 = ^{or_3394, or_3390, or_3386};
  // hls/stages/count_bits.hpp:23
  logic or_3401;
  assign or_3401 = (or_3234_s18_q & or_3238_s18_q) | (or_3230_s18_q & (or_3234_s18_q | or_3238_s18_q));
  // hls/stages/count_bits.hpp:25
  logic or_3405;
  assign or_3405 = (or_3249_s18_q & or_3253_s18_q) | (or_3245_s18_q & (or_3249_s18_q | or_3253_s18_q));
  logic or_3409;
  assign or_3409 = (or_3264_s18_q & or_3268_s18_q) | (or_3260_s18_q & (or_3264_s18_q | or_3268_s18_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3412;
  assign parity_3412 = ^{or_3409, or_3405, or_3401};
  logic parity_3415;
  assign parity_3415 = ^{or_3409, or_3405, or_3401, or_3394, or_3390, or_3386, or_3379, or_3375, or_3371};
  // hls/stages/patches.hpp:595
  logic [9:0] difference_3594;
  assign difference_3594 = select_3591_s18_q - select_3581_s18_q[9:0];
  // hls/stages/patches.hpp:600
  logic or_3601;
  assign or_3601 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3581_s18_q[9:0]);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3625;
  assign sum_3625 = select_3550_s18_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:587
  logic [7:0] difference_3645;
  assign difference_3645 = {sum_3625, select_3550_s18_q[2:0], 3'h0} - {5'h0, fraction_s18_q};
  logic [7:0] select_3646;
  assign select_3646 = less_3624_s18_q ? difference_3645 : {sum_3625, select_3550_s18_q[2:0], fraction_s18_q};
  // hls/stages/patches.hpp:598
  logic [18:0] product_3651;
  assign product_3651 = $signed({{11{select_3647_s18_q[7]}}, select_3647_s18_q}) * $signed({{8{sum_3650_s18_q[6]}}, sum_3650_s18_q, sum_3648_s18_q, select_3581_s18_q[12:10]});
  // hls/stages/patches.hpp:606
  logic [11:0] sum_3826;
  assign sum_3826 = {sum_3650_s18_q[6], sum_3650_s18_q, sum_3648_s18_q, select_3581_s18_q[12:10]} + 12'h1;
  // hls/stages/agreement.hpp:1135
  logic select_3938;
  assign select_3938 = equal_3921_s18_q ? ((~or_3924_s18_q) & (~select_3932_s18_q)) : not_3937_s18_q;
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3940;
  assign select_3940 = x_s18_q[6] ? (equal_1606_s18_q ? good_q : {select_3938, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:1147
  logic equal_3943;
  assign equal_3943 = x_s18_q == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic [4:0] select_4022;
  assign select_4022 = so_s18_q ? (ends_cell_s18_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4094;
  assign select_4094 = equal_2469_s18_q ? (equal_4091_s18_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4097;
  assign select_4097 = and_548_s18_q ? (equal_2469_s18_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      moments_most_before_q <= 14'h0;
      moments_left_alone_q <= 1'b0;
      moments_left_other_stops_q <= 1'b0;
      moments_right_alone_q <= 1'b0;
      moments_right_other_stops_q <= 1'b0;
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
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s18_en) begin
      moments_most_before_q <= equal_573_s18_q ? select_2303_s18_q : moments_most_before_q;
      moments_left_alone_q <= equal_573_s18_q ? not_2311_s18_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_573_s18_q ? not_2314_s18_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_573_s18_q ? not_2321_s18_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_573_s18_q ? not_2324_s18_q : moments_right_other_stops_q;
      sharpness_sums_contrast_0_q <= and_548_s18_q ? sum_2392 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_548_s18_q ? sum_2396 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2754_s18_q ? 14'h0 : sum_2775;
      registration_half_votes_down_q <= and_2754_s18_q ? 7'h0 : sum_2787;
      registration_half_half_votes_down_q <= and_2754_s18_q ? 7'h0 : sum_2802;
      registration_down_q <= and_2843 ? sum_2862 : registration_down_q;
      registration_up_q <= and_2843 ? sum_2871 : registration_up_q;
      registration_enough_q <= select_2885;
      registration_votes_down_q <= and_2890 ? less_2891 : registration_votes_down_q;
      registration_votes_up_q <= and_2890 ? less_2893 : registration_votes_up_q;
      registration_other_enough_q <= and_2899 ? select_2885 : registration_other_enough_q;
      registration_other_down_q <= and_2899 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2899 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s18_q ? select_1801 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s18_q ? select_1830 : patches_place_1_valid_q;
      good_q <= equal_573_s18_q ? select_3940 : good_q;
      map_row_q <= and_548_s18_q ? select_4094 : map_row_q;
      map_width_q <= select_4097;
      write_half_q <= marks_first_s18_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2049;
      done_q <= not_2051_s18_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s18_q;
      said_q <= equal_573_s18_q & equal_3943;
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
    if (s18_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2253;
      census_changes_values_0_left_q <= and_548_s18_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_548_s18_q ? sum_2273 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2275;
      census_changes_values_1_right_q <= select_2276;
      sharpness_last_detail_0_q <= select_2360;
      sharpness_last_detail_1_q <= select_2361;
      box_textured_sum_sums_values_0_q <= equal_573_s18_q ? box_textured_sum_sums_values_0_q : select_4022;
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
  logic [11:0] census_changes_values_1_left_s19_q;
  logic [11:0] census_changes_values_1_right_s19_q;
  logic moments_left_alone_s19_q;
  logic moments_left_other_stops_s19_q;
  logic moments_right_alone_s19_q;
  logic moments_right_other_stops_s19_q;
  logic [23:0] sharpness_sums_contrast_0_s19_q;
  logic [23:0] sharpness_sums_contrast_1_s19_q;
  logic [6:0] x_s19_q;
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
  logic done_s19_q;
  logic row_starts_s19_q;
  logic [6:0] last_s19_q;
  logic and_548_s19_q;
  logic equal_573_s19_q;
  logic not_574_s19_q;
  logic less_651_s19_q;
  logic less_652_s19_q;
  logic less_653_s19_q;
  logic less_654_s19_q;
  logic less_655_s19_q;
  logic less_656_s19_q;
  logic less_657_s19_q;
  logic less_658_s19_q;
  logic less_659_s19_q;
  logic less_660_s19_q;
  logic less_661_s19_q;
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
  logic and_682_s19_q;
  logic and_707_s19_q;
  logic and_708_s19_q;
  logic [12:0] sum_728_s19_q;
  logic and_734_s19_q;
  logic and_738_s19_q;
  logic less_739_s19_q;
  logic less_743_s19_q;
  logic less_745_s19_q;
  logic equal_1606_s19_q;
  logic [1:0] sum_1612_s19_q;
  logic equal_1614_s19_q;
  logic equal_1616_s19_q;
  logic equal_1618_s19_q;
  logic equal_1620_s19_q;
  logic equal_1622_s19_q;
  logic equal_1624_s19_q;
  logic [19:0] sum_1666_s19_q;
  logic [11:0] sum_1670_s19_q;
  logic and_1671_s19_q;
  logic select_1688_s19_q;
  logic equal_1689_s19_q;
  logic equal_1783_s19_q;
  logic equal_1785_s19_q;
  logic select_1799_s19_q;
  logic or_1809_s19_q;
  logic [4:0] select_1813_s19_q;
  logic select_1819_s19_q;
  logic or_1837_s19_q;
  logic or_1850_s19_q;
  logic or_1854_s19_q;
  logic [3:0] select_1857_s19_q;
  logic less_1961_s19_q;
  logic equal_1962_s19_q;
  logic not_1963_s19_q;
  logic equal_1964_s19_q;
  logic not_1991_s19_q;
  logic [2:0] index_s19_q;
  logic [10:0] sum_2050_s19_q;
  logic and_2057_s19_q;
  logic less_2058_s19_q;
  logic [2:0] index_2_s19_q;
  logic [10:0] sum_2063_s19_q;
  logic equal_2076_s19_q;
  logic not_2096_s19_q;
  logic not_2112_s19_q;
  logic less_2126_s19_q;
  logic and_2137_s19_q;
  logic equal_2280_s19_q;
  logic [12:0] sum_2281_s19_q;
  logic equal_2295_s19_q;
  logic not_2307_s19_q;
  logic not_2317_s19_q;
  logic [12:0] select_2374_s19_q;
  logic [12:0] select_2386_s19_q;
  logic equal_2398_s19_q;
  logic less_2399_s19_q;
  logic and_2409_s19_q;
  logic and_2419_s19_q;
  logic equal_2442_s19_q;
  logic and_2594_s19_q;
  logic not_2619_s19_q;
  logic not_2634_s19_q;
  logic [9:0] select_2645_s19_q;
  logic [9:0] select_2648_s19_q;
  logic less_2650_s19_q;
  logic and_2696_s19_q;
  logic equal_2895_s19_q;
  logic not_2908_s19_q;
  logic and_2930_s19_q;
  logic parity_3226_s19_q;
  logic parity_3355_s19_q;
  logic and_3356_s19_q;
  logic or_3360_s19_q;
  logic or_3364_s19_q;
  logic or_3371_s19_q;
  logic or_3375_s19_q;
  logic or_3379_s19_q;
  logic or_3386_s19_q;
  logic or_3390_s19_q;
  logic or_3394_s19_q;
  logic or_3401_s19_q;
  logic or_3405_s19_q;
  logic or_3409_s19_q;
  logic parity_3415_s19_q;
  logic or_3425_s19_q;
  logic or_3429_s19_q;
  logic and_3436_s19_q;
  logic and_3438_s19_q;
  logic and_3440_s19_q;
  logic equal_3462_s19_q;
  logic equal_3593_s19_q;
  logic less_3595_s19_q;
  logic less_3596_s19_q;
  logic or_3601_s19_q;
  logic [7:0] select_3646_s19_q;
  logic [13:0] product_3651_s19_q;
  logic equal_3702_s19_q;
  logic less_3827_s19_q;
  logic or_3924_s19_q;
  logic select_3932_s19_q;
  logic equal_3943_s19_q;
  logic equal_3946_s19_q;
  logic equal_3948_s19_q;
  logic equal_3949_s19_q;
  logic equal_3950_s19_q;
  logic equal_3951_s19_q;
  logic [31:0] select_4190_s19_q;
  logic [9:0] select_4197_s19_q;
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
      census_changes_values_1_left_s19_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s19_q <= census_changes_values_1_right_q;
      moments_left_alone_s19_q <= moments_left_alone_q;
      moments_left_other_stops_s19_q <= moments_left_other_stops_q;
      moments_right_alone_s19_q <= moments_right_alone_q;
      moments_right_other_stops_s19_q <= moments_right_other_stops_q;
      sharpness_sums_contrast_0_s19_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s19_q <= sharpness_sums_contrast_1_q;
      x_s19_q <= x_s18_q;
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      counts_nearer_s19_q <= counts_nearer_s18_q;
      registration_of_right_s19_q <= registration_of_right_s18_q;
      patches_lower_s19_q <= patches_lower_s18_q;
      patches_second_s19_q <= patches_second_s18_q;
      patches_summed_row_column_s19_q <= patches_summed_row_column_s18_q;
      patches_summed_first_s19_q <= patches_summed_first_s18_q;
      patches_summed_last_s19_q <= patches_summed_last_s18_q;
      patches_summed_down_by_s19_q <= patches_summed_down_by_s18_q;
      product_s19_q <= product_s18_q;
      centres_values_1_textured_s19_q <= centres_values_1_textured_s18_q;
      centres_values_1_of_skin_s19_q <= centres_values_1_of_skin_s18_q;
      done_s19_q <= done_q;
      row_starts_s19_q <= row_starts_s18_q;
      last_s19_q <= last_s18_q;
      and_548_s19_q <= and_548_s18_q;
      equal_573_s19_q <= equal_573_s18_q;
      not_574_s19_q <= not_574_s18_q;
      less_651_s19_q <= less_651_s18_q;
      less_652_s19_q <= less_652_s18_q;
      less_653_s19_q <= less_653_s18_q;
      less_654_s19_q <= less_654_s18_q;
      less_655_s19_q <= less_655_s18_q;
      less_656_s19_q <= less_656_s18_q;
      less_657_s19_q <= less_657_s18_q;
      less_658_s19_q <= less_658_s18_q;
      less_659_s19_q <= less_659_s18_q;
      less_660_s19_q <= less_660_s18_q;
      less_661_s19_q <= less_661_s18_q;
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
      and_682_s19_q <= and_682_s18_q;
      and_707_s19_q <= whole_22 & and_682_s18_q;
      and_708_s19_q <= and_708_s18_q;
      sum_728_s19_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_734_s19_q <= and_734_s18_q;
      and_738_s19_q <= and_738_s18_q;
      less_739_s19_q <= less_739_s18_q;
      less_743_s19_q <= less_743_s18_q;
      less_745_s19_q <= less_745_s18_q;
      equal_1606_s19_q <= equal_1606_s18_q;
      sum_1612_s19_q <= sum_1612_s18_q;
      equal_1614_s19_q <= equal_1614_s18_q;
      equal_1616_s19_q <= equal_1616_s18_q;
      equal_1618_s19_q <= equal_1618_s18_q;
      equal_1620_s19_q <= equal_1620_s18_q;
      equal_1622_s19_q <= equal_1622_s18_q;
      equal_1624_s19_q <= equal_1624_s18_q;
      sum_1666_s19_q <= select_1662_s18_q + {{6{select_1665[13]}}, select_1665};
      sum_1670_s19_q <= sum_1670_s18_q;
      and_1671_s19_q <= and_1671_s18_q;
      select_1688_s19_q <= select_1688_s18_q;
      equal_1689_s19_q <= equal_1689_s18_q;
      equal_1783_s19_q <= equal_1783_s18_q;
      equal_1785_s19_q <= equal_1785_s18_q;
      select_1799_s19_q <= select_1799_s18_q;
      or_1809_s19_q <= row_starts_s18_q | (select_1801 & equal_1807);
      select_1813_s19_q <= select_1813_s18_q;
      select_1819_s19_q <= select_1819_s18_q;
      or_1837_s19_q <= row_starts_s18_q | (select_1830 & equal_1835);
      or_1850_s19_q <= row_starts_s18_q | (select_1801 & equal_1848_s18_q);
      or_1854_s19_q <= row_starts_s18_q | (select_1830 & equal_1852_s18_q);
      select_1857_s19_q <= select_1857_s18_q;
      less_1961_s19_q <= less_1961_s18_q;
      equal_1962_s19_q <= equal_1962_s18_q;
      not_1963_s19_q <= not_1963_s18_q;
      equal_1964_s19_q <= equal_1964_s18_q;
      not_1991_s19_q <= not_1991_s18_q;
      index_s19_q <= index[2:0];
      sum_2050_s19_q <= sum_2050;
      and_2057_s19_q <= began_q & (seen_x_q == 4'h0);
      less_2058_s19_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s19_q <= index_2[2:0];
      sum_2063_s19_q <= sum_2063;
      equal_2076_s19_q <= t[4:1] == 4'h0;
      not_2096_s19_q <= ~((good_q & select_2093) == 48'h0);
      not_2112_s19_q <= ~({sum_2110, around_s18_q[0]} < {2'h0, t});
      less_2126_s19_q <= less_2126_s18_q;
      and_2137_s19_q <= and_2137_s18_q;
      equal_2280_s19_q <= equal_2280_s18_q;
      sum_2281_s19_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2273};
      equal_2295_s19_q <= equal_2295_s18_q;
      not_2307_s19_q <= ~({3'h0, counts_turned_left_s18_q} < sum_2305);
      not_2317_s19_q <= ~({3'h0, counts_turned_right_s18_q} < sum_2305);
      select_2374_s19_q <= and_2372_s18_q ? detail_3[14:2] : 13'h0;
      select_2386_s19_q <= and_2384_s18_q ? detail_4[14:2] : 13'h0;
      equal_2398_s19_q <= equal_2398_s18_q;
      less_2399_s19_q <= less_2399_s18_q;
      and_2409_s19_q <= and_2409;
      and_2419_s19_q <= and_2419;
      equal_2442_s19_q <= equal_2442_s18_q;
      and_2594_s19_q <= and_2594_s18_q;
      not_2619_s19_q <= not_2619_s18_q;
      not_2634_s19_q <= ~({sum_2632, e_s18_q[0]} < {2'h0, t});
      select_2645_s19_q <= select_2645_s18_q;
      select_2648_s19_q <= select_2648_s18_q;
      less_2650_s19_q <= {sum_2649, select_2648_s18_q[1:0]} < {3'h0, select_2645_s18_q};
      and_2696_s19_q <= and_2696_s18_q;
      equal_2895_s19_q <= equal_2895;
      not_2908_s19_q <= ~(equal_573_s18_q & and_2906);
      and_2930_s19_q <= and_2930;
      parity_3226_s19_q <= parity_3226_s18_q;
      parity_3355_s19_q <= parity_3355;
      and_3356_s19_q <= and_3356;
      or_3360_s19_q <= or_3360;
      or_3364_s19_q <= or_3364;
      or_3371_s19_q <= or_3371;
      or_3375_s19_q <= or_3375;
      or_3379_s19_q <= or_3379;
      or_3386_s19_q <= or_3386;
      or_3390_s19_q <= or_3390;
      or_3394_s19_q <= or_3394;
      or_3401_s19_q <= or_3401;
      or_3405_s19_q <= or_3405;
      or_3409_s19_q <= or_3409;
      parity_3415_s19_q <= parity_3415;
      or_3425_s19_q <= (or_3390 & or_3394) | (or_3386 & (or_3390 | or_3394));
      or_3429_s19_q <= (or_3405 & or_3409) | (or_3401 & (or_3405 | or_3409));
      and_3436_s19_q <= and_3356 & (or_3360 | or_3364);
      and_3438_s19_q <= parity_3397 & parity_3412;
      and_3440_s19_q <= (^{or_3379, or_3375, or_3371}) & (parity_3397 | parity_3412);
      equal_3462_s19_q <= equal_3462_s18_q;
      equal_3593_s19_q <= select_3550_s18_q[3:0] == 4'h0;
      less_3595_s19_q <= {difference_3594, 3'h0} < {3'h0, patches_size_q};
      less_3596_s19_q <= select_3591_s18_q < select_3581_s18_q[9:0];
      or_3601_s19_q <= or_3601;
      select_3646_s19_q <= select_3646;
      product_3651_s19_q <= product_3651[18:5];
      equal_3702_s19_q <= equal_3702_s18_q;
      less_3827_s19_q <= {{4{sum_3826[11]}}, sum_3826} < 16'h3;
      or_3924_s19_q <= or_3924_s18_q;
      select_3932_s19_q <= select_3932_s18_q;
      equal_3943_s19_q <= equal_3943;
      equal_3946_s19_q <= equal_3946_s18_q;
      equal_3948_s19_q <= equal_3948_s18_q;
      equal_3949_s19_q <= equal_3949_s18_q;
      equal_3950_s19_q <= equal_3950_s18_q;
      equal_3951_s19_q <= equal_3951_s18_q;
      select_4190_s19_q <= select_4190_s18_q;
      select_4197_s19_q <= select_4197_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic moments_left_begins_q;
  logic moments_right_begins_q;
  logic moments_ends_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
  logic [1:0] sharpness_comparing_contrast_0_q;
  logic [1:0] sharpness_comparing_contrast_1_q;
  logic sharpness_comparing_less_contrast_0_q;
  logic sharpness_comparing_less_contrast_1_q;
  logic registration_moved_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic good_known_q;
  // hls/stages/census.hpp:295
  logic [13:0] sum_729;
  assign sum_729 = {2'h0, census_changes_values_1_left_s19_q} + {1'b0, sum_728_s19_q};
  logic [13:0] sum_730;
  assign sum_730 = {2'h0, census_changes_values_2_left_q} + sum_729;
  // hls/stages/patches.hpp:134
  logic [5:0] select_1820;
  assign select_1820 = or_1809_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1822;
  assign and_1822 = select_1819_s19_q & (~select_1820[5]);
  // hls/stages/patches.hpp:134
  logic [5:0] select_1839;
  assign select_1839 = or_1837_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1841;
  assign and_1841 = select_1819_s19_q & (~select_1839[5]);
  // hls/stages/patches.hpp:135
  logic [4:0] select_1851;
  assign select_1851 = or_1850_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1855;
  assign select_1855 = or_1854_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1851[4] ? select_1855[3:0] : select_1851[3:0];
  logic and_1860;
  assign and_1860 = select_1819_s19_q & (select_1813_s19_q[3] ^ select_1813_s19_q[4]);
  logic and_1865;
  assign and_1865 = sample_pair_whole_s19_q & (and_1860 & ((~select_1851[4]) | (~select_1855[4])));
  // hls/stages/agreement.hpp:1030
  logic and_2097;
  assign and_2097 = good_known_q & not_2096_s19_q;
  // hls/stages/agreement.hpp:1103
  logic is_seen;
  assign is_seen = equal_2076_s19_q ? and_2097 : not_2112_s19_q;
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2277;
  assign select_2277 = and_548_s19_q ? census_changes_values_1_left_s19_q : census_changes_values_2_left_q;
  logic [11:0] select_2278;
  assign select_2278 = and_548_s19_q ? census_changes_values_1_right_s19_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [13:0] sum_2282;
  assign sum_2282 = {2'h0, census_changes_values_1_right_s19_q} + {1'b0, sum_2281_s19_q};
  logic [13:0] sum_2283;
  assign sum_2283 = {2'h0, census_changes_values_2_right_q} + sum_2282;
  // hls/stages/moments.hpp:94
  logic and_2342;
  assign and_2342 = moments_right_alone_s19_q & (moments_right_begins_q | moments_right_other_stops_s19_q);
  logic or_2344;
  assign or_2344 = moments_left_begins_q | (moments_left_other_stops_s19_q | and_2342);
  logic and_2346;
  assign and_2346 = cfg_same_table_i & (moments_left_alone_s19_q ? or_2344 : and_2342);
  // hls/stages/moments.hpp:95
  logic and_2352;
  assign and_2352 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:375
  logic [23:0] select_2376;
  assign select_2376 = equal_2280_s19_q ? {11'h0, select_2374_s19_q} : (sharpness_sums_detail_0_q + {11'h0, select_2374_s19_q});
  logic [23:0] select_2388;
  assign select_2388 = equal_2280_s19_q ? {11'h0, select_2386_s19_q} : (sharpness_sums_detail_1_q + {11'h0, select_2386_s19_q});
  // hls/stages/census.hpp:395
  logic [17:0] select_2411;
  assign select_2411 = (less_2399_s19_q & and_2409_s19_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2421;
  assign select_2421 = (less_2399_s19_q & and_2419_s19_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:216
  logic [1:0] select_2430;
  assign select_2430 = equal_2398_s19_q ? {sharpness_comparing_contrast_0_q[0], and_2419_s19_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2432;
  assign select_2432 = equal_2398_s19_q ? {sharpness_comparing_contrast_1_q[0], and_2409_s19_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:404
  logic xor_2455;
  assign xor_2455 = sharpness_comparing_contrast_0_q[1] ^ and_2409_s19_q;
  logic select_2458;
  assign select_2458 = (equal_2442_s19_q | xor_2455) ? (and_2409_s19_q & xor_2455) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2459;
  assign select_2459 = equal_2398_s19_q ? select_2458 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2461;
  assign xor_2461 = sharpness_comparing_contrast_1_q[1] ^ and_2419_s19_q;
  logic select_2464;
  assign select_2464 = (equal_2442_s19_q | xor_2461) ? (and_2419_s19_q & xor_2461) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2465;
  assign select_2465 = equal_2398_s19_q ? select_2464 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1106
  logic not_2636;
  assign not_2636 = ~(equal_2076_s19_q ? and_2097 : not_2634_s19_q);
  // hls/stages/agreement.hpp:788
  logic and_2639;
  assign and_2639 = ends_cell_s19_q & (not_2619_s19_q & (centres_values_1_textured_s19_q & not_2636));
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_2652;
  assign select_2652 = ((~(select_2645_s19_q[9:4] == 6'h0)) & less_2650_s19_q) ? select_2645_s19_q : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2655;
  assign select_2655 = equal_573_s19_q ? (x_s19_q[6] ? (equal_1606_s19_q ? 10'h0 : select_2652) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1110
  logic and_2673;
  assign and_2673 = centres_values_1_textured_s19_q & (centres_values_1_of_skin_s19_q & not_2636);
  // hls/stages/patches.hpp:127
  logic select_3022;
  assign select_3022 = equal_1689_s19_q ? patches_valid_0_q : (select_1688_s19_q ? patches_valid_0_q : select_1799_s19_q);
  // hls/stages/agreement.hpp:276
  logic select_3025;
  assign select_3025 = sample_pair_whole_s19_q ? (and_1822 ? (sample_present_s19_q & select_3022) : select_3022) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3027;
  assign select_3027 = equal_1689_s19_q ? patches_valid_1_q : (select_1688_s19_q ? select_1799_s19_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3030;
  assign select_3030 = sample_pair_whole_s19_q ? (and_1841 ? (sample_present_s19_q & select_3027) : select_3027) : patches_valid_1_q;
  logic [5:0] select_3033;
  assign select_3033 = sample_pair_whole_s19_q ? (select_1820[5] ? {1'b1, select_1820[4:0]} : (select_1820 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3036;
  assign select_3036 = sample_pair_whole_s19_q ? (select_1839[5] ? {1'b1, select_1839[4:0]} : (select_1839 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3039;
  assign select_3039 = sample_pair_whole_s19_q ? (select_1851[4] ? {1'b1, select_1851[3:0]} : (select_1851 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3042;
  assign select_3042 = sample_pair_whole_s19_q ? (select_1855[4] ? {1'b1, select_1855[3:0]} : (select_1855 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3417;
  assign parity_3417 = ^{or_3409_s19_q, or_3405_s19_q, or_3401_s19_q, or_3394_s19_q, or_3390_s19_q, or_3386_s19_q, or_3379_s19_q, or_3375_s19_q, or_3371_s19_q, or_3364_s19_q, or_3360_s19_q, and_3356_s19_q};
  // hls/stages/count_bits.hpp:25
  logic or_3421;
  assign or_3421 = (or_3375_s19_q & or_3379_s19_q) | (or_3371_s19_q & (or_3375_s19_q | or_3379_s19_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3432;
  assign parity_3432 = ^{or_3429_s19_q, or_3425_s19_q, or_3421};
  // hls/stages/count_bits.hpp:25
  logic and_3433;
  assign and_3433 = (^{or_3364_s19_q, or_3360_s19_q, and_3356_s19_q}) & parity_3415_s19_q;
  logic or_3437;
  assign or_3437 = (or_3360_s19_q & or_3364_s19_q) | and_3436_s19_q;
  logic or_3441;
  assign or_3441 = and_3438_s19_q | and_3440_s19_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3444;
  assign parity_3444 = ^{or_3441, or_3437, and_3433};
  // hls/stages/count_bits.hpp:25
  logic and_3446;
  assign and_3446 = parity_3432 & parity_3444;
  logic or_3450;
  assign or_3450 = (or_3425_s19_q & or_3429_s19_q) | (or_3421 & (or_3425_s19_q | or_3429_s19_q));
  logic or_3454;
  assign or_3454 = (or_3437 & or_3441) | (and_3433 & (or_3437 | or_3441));
  // hls/stages/patches.hpp:600
  logic or_3602;
  assign or_3602 = (~(patches_second_s19_q ? patches_valid_1_q : patches_valid_0_q)) | or_3601_s19_q;
  logic or_3605;
  assign or_3605 = equal_3593_s19_q | (less_3595_s19_q | (less_3596_s19_q | or_3602));
  // hls/stages/patches.hpp:599
  logic [14:0] difference_3652;
  assign difference_3652 = {{7{select_3646_s19_q[7]}}, select_3646_s19_q} - {product_3651_s19_q[13], product_3651_s19_q};
  // hls/stages/patches.hpp:605
  logic less_3653;
  assign less_3653 = $signed({{8{difference_3623[6]}}, difference_3623}) < $signed(difference_3652);
  // hls/stages/agreement.hpp:788
  logic select_3945;
  assign select_3945 = equal_573_s19_q ? ((x_s19_q[6] & good_known_q) | equal_3943_s19_q) : good_known_q;
  // hls/stages/agreement.hpp:1308
  logic and_4120;
  assign and_4120 = and_2137_s19_q & ({sum_2063_s19_q, index_2_s19_q} == {sum_2050_s19_q, index_s19_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1409; read in stage 19, written in stage 20: 19 < 20 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2050_s19_q, index_s19_q};
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s19_en & (and_2057_s19_q & less_2058_s19_q);
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1612_s19_q, lower_half_s19_q, registration_of_right_s19_q};
  logic registration_sums_we;
  assign registration_sums_we = s19_en & and_1671_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1670_s19_q, sum_1666_s19_q};
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
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
      sharpness_comparing_contrast_0_q <= 2'h0;
      sharpness_comparing_contrast_1_q <= 2'h0;
      sharpness_comparing_less_contrast_0_q <= 1'b0;
      sharpness_comparing_less_contrast_1_q <= 1'b0;
      registration_moved_q <= 1'b0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      good_known_q <= 1'b0;
    end else if (s19_en) begin
      moments_left_begins_q <= equal_573_s19_q ? not_2307_s19_q : moments_left_begins_q;
      moments_right_begins_q <= equal_573_s19_q ? not_2317_s19_q : moments_right_begins_q;
      moments_ends_q <= equal_573_s19_q & (equal_2295_s19_q & (not_2350 | and_2352));
      sharpness_sums_detail_0_q <= and_548_s19_q ? select_2376 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_548_s19_q ? select_2388 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2430 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2432 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_2459 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_2465 : sharpness_comparing_less_contrast_1_q;
      registration_moved_q <= not_2908_s19_q & (registration_moved_q | and_2930_s19_q);
      patches_valid_0_q <= select_3025;
      patches_valid_1_q <= select_3030;
      patches_right_next_0_q <= select_3033;
      patches_right_next_1_q <= select_3036;
      patches_left_next_0_q <= select_3039;
      patches_left_next_1_q <= select_3042;
      good_known_q <= select_3945;
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
    if (s19_en) begin
      census_changes_values_2_left_q <= select_2277;
      census_changes_values_2_right_q <= select_2278;
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
  logic [23:0] sharpness_sums_detail_0_s20_q;
  logic [23:0] sharpness_sums_detail_1_s20_q;
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
  logic done_s20_q;
  logic [6:0] last_s20_q;
  logic and_548_s20_q;
  logic equal_573_s20_q;
  logic not_574_s20_q;
  logic so_s20_q;
  logic less_651_s20_q;
  logic less_652_s20_q;
  logic less_653_s20_q;
  logic less_654_s20_q;
  logic less_655_s20_q;
  logic less_656_s20_q;
  logic less_657_s20_q;
  logic less_658_s20_q;
  logic less_659_s20_q;
  logic less_660_s20_q;
  logic less_661_s20_q;
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
  logic and_682_s20_q;
  logic and_707_s20_q;
  logic and_708_s20_q;
  logic [8:0] sum_730_s20_q;
  logic and_738_s20_q;
  logic less_739_s20_q;
  logic and_744_s20_q;
  logic less_745_s20_q;
  logic equal_1606_s20_q;
  logic equal_1614_s20_q;
  logic equal_1616_s20_q;
  logic equal_1618_s20_q;
  logic equal_1620_s20_q;
  logic equal_1622_s20_q;
  logic equal_1624_s20_q;
  logic equal_1783_s20_q;
  logic equal_1785_s20_q;
  logic [4:0] select_1810_s20_q;
  logic [4:0] select_1813_s20_q;
  logic and_1823_s20_q;
  logic [4:0] select_1838_s20_q;
  logic and_1842_s20_q;
  logic [3:0] column_4_s20_q;
  logic [3:0] select_1857_s20_q;
  logic select_1858_s20_q;
  logic and_1865_s20_q;
  logic less_1961_s20_q;
  logic equal_1962_s20_q;
  logic not_1963_s20_q;
  logic equal_1964_s20_q;
  logic not_1991_s20_q;
  logic and_2057_s20_q;
  logic less_2058_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_2063_s20_q;
  logic is_seen_s20_q;
  logic and_2127_s20_q;
  logic and_2137_s20_q;
  logic equal_2280_s20_q;
  logic [8:0] sum_2283_s20_q;
  logic equal_2295_s20_q;
  logic not_2326_s20_q;
  logic and_2347_s20_q;
  logic equal_2398_s20_q;
  logic less_2399_s20_q;
  logic [17:0] select_2411_s20_q;
  logic [17:0] select_2421_s20_q;
  logic equal_2442_s20_q;
  logic and_2594_s20_q;
  logic and_2641_s20_q;
  logic [9:0] select_2645_s20_q;
  logic [9:0] select_2648_s20_q;
  logic [9:0] select_2655_s20_q;
  logic and_2676_s20_q;
  logic and_2696_s20_q;
  logic equal_2895_s20_q;
  logic parity_3226_s20_q;
  logic parity_3355_s20_q;
  logic parity_3417_s20_q;
  logic xor_3445_s20_q;
  logic parity_3457_s20_q;
  logic and_3458_s20_q;
  logic and_3460_s20_q;
  logic equal_3462_s20_q;
  logic or_3605_s20_q;
  logic [5:0] difference_3652_s20_q;
  logic not_3654_s20_q;
  logic not_3664_s20_q;
  logic equal_3702_s20_q;
  logic less_3776_s20_q;
  logic less_3777_s20_q;
  logic less_3827_s20_q;
  logic or_3924_s20_q;
  logic select_3932_s20_q;
  logic equal_3943_s20_q;
  logic equal_3946_s20_q;
  logic equal_3948_s20_q;
  logic equal_3949_s20_q;
  logic equal_3950_s20_q;
  logic equal_3951_s20_q;
  logic and_4105_s20_q;
  logic and_4120_s20_q;
  logic [31:0] select_4190_s20_q;
  logic [9:0] select_4197_s20_q;
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
      sharpness_sums_detail_0_s20_q <= sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_s20_q <= sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_s20_q <= sharpness_sums_contrast_0_s19_q;
      sharpness_sums_contrast_1_s20_q <= sharpness_sums_contrast_1_s19_q;
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
      done_s20_q <= done_s19_q;
      last_s20_q <= last_s19_q;
      and_548_s20_q <= and_548_s19_q;
      equal_573_s20_q <= equal_573_s19_q;
      not_574_s20_q <= not_574_s19_q;
      so_s20_q <= drew_q;
      less_651_s20_q <= less_651_s19_q;
      less_652_s20_q <= less_652_s19_q;
      less_653_s20_q <= less_653_s19_q;
      less_654_s20_q <= less_654_s19_q;
      less_655_s20_q <= less_655_s19_q;
      less_656_s20_q <= less_656_s19_q;
      less_657_s20_q <= less_657_s19_q;
      less_658_s20_q <= less_658_s19_q;
      less_659_s20_q <= less_659_s19_q;
      less_660_s20_q <= less_660_s19_q;
      less_661_s20_q <= less_661_s19_q;
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
      and_682_s20_q <= and_682_s19_q;
      and_707_s20_q <= and_707_s19_q;
      and_708_s20_q <= and_708_s19_q;
      sum_730_s20_q <= sum_730[13:5];
      and_738_s20_q <= and_738_s19_q;
      less_739_s20_q <= less_739_s19_q;
      and_744_s20_q <= (and_707_s19_q & and_734_s19_q) & less_743_s19_q;
      less_745_s20_q <= less_745_s19_q;
      equal_1606_s20_q <= equal_1606_s19_q;
      equal_1614_s20_q <= equal_1614_s19_q;
      equal_1616_s20_q <= equal_1616_s19_q;
      equal_1618_s20_q <= equal_1618_s19_q;
      equal_1620_s20_q <= equal_1620_s19_q;
      equal_1622_s20_q <= equal_1622_s19_q;
      equal_1624_s20_q <= equal_1624_s19_q;
      equal_1783_s20_q <= equal_1783_s19_q;
      equal_1785_s20_q <= equal_1785_s19_q;
      select_1810_s20_q <= or_1809_s19_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1813_s20_q <= select_1813_s19_q;
      and_1823_s20_q <= sample_pair_whole_s19_q & and_1822;
      select_1838_s20_q <= or_1837_s19_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1842_s20_q <= sample_pair_whole_s19_q & and_1841;
      column_4_s20_q <= column_4;
      select_1857_s20_q <= select_1857_s19_q;
      select_1858_s20_q <= or_1850_s19_q ? row_starts_s19_q : patches_left_next_0_q[4];
      and_1865_s20_q <= and_1865;
      less_1961_s20_q <= less_1961_s19_q;
      equal_1962_s20_q <= equal_1962_s19_q;
      not_1963_s20_q <= not_1963_s19_q;
      equal_1964_s20_q <= equal_1964_s19_q;
      not_1991_s20_q <= not_1991_s19_q;
      and_2057_s20_q <= and_2057_s19_q;
      less_2058_s20_q <= less_2058_s19_q;
      index_2_s20_q <= index_2_s19_q;
      sum_2063_s20_q <= sum_2063_s19_q;
      is_seen_s20_q <= is_seen;
      and_2127_s20_q <= is_seen & less_2126_s19_q;
      and_2137_s20_q <= and_2137_s19_q;
      equal_2280_s20_q <= equal_2280_s19_q;
      sum_2283_s20_q <= sum_2283[13:5];
      equal_2295_s20_q <= equal_2295_s19_q;
      not_2326_s20_q <= ~moments_ends_q;
      and_2347_s20_q <= cfg_prove_i & and_2346;
      equal_2398_s20_q <= equal_2398_s19_q;
      less_2399_s20_q <= less_2399_s19_q;
      select_2411_s20_q <= select_2411;
      select_2421_s20_q <= select_2421;
      equal_2442_s20_q <= equal_2442_s19_q;
      and_2594_s20_q <= and_2594_s19_q;
      and_2641_s20_q <= not_574_s19_q & (drew_q & and_2639);
      select_2645_s20_q <= select_2645_s19_q;
      select_2648_s20_q <= select_2648_s19_q;
      select_2655_s20_q <= select_2655;
      and_2676_s20_q <= drew_q & (ends_cell_s19_q & (not_2619_s19_q & and_2673));
      and_2696_s20_q <= and_2696_s19_q;
      equal_2895_s20_q <= equal_2895_s19_q;
      parity_3226_s20_q <= parity_3226_s19_q;
      parity_3355_s20_q <= parity_3355_s19_q;
      parity_3417_s20_q <= parity_3417;
      xor_3445_s20_q <= parity_3432 ^ parity_3444;
      parity_3457_s20_q <= ^{or_3454, or_3450, and_3446};
      and_3458_s20_q <= or_3450 & or_3454;
      and_3460_s20_q <= and_3446 & (or_3450 | or_3454);
      equal_3462_s20_q <= equal_3462_s19_q;
      or_3605_s20_q <= or_3605;
      difference_3652_s20_q <= difference_3652[5:0];
      not_3654_s20_q <= ~less_3653;
      not_3664_s20_q <= ~($signed(difference_3652) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3702_s20_q <= equal_3702_s19_q;
      less_3776_s20_q <= $signed(15'h10) < $signed(difference_3652);
      less_3777_s20_q <= $signed(difference_3652[14:4]) < $signed(11'h7ff);
      less_3827_s20_q <= less_3827_s19_q;
      or_3924_s20_q <= or_3924_s19_q;
      select_3932_s20_q <= select_3932_s19_q;
      equal_3943_s20_q <= equal_3943_s19_q;
      equal_3946_s20_q <= equal_3946_s19_q;
      equal_3948_s20_q <= equal_3948_s19_q;
      equal_3949_s20_q <= equal_3949_s19_q;
      equal_3950_s20_q <= equal_3950_s19_q;
      equal_3951_s20_q <= equal_3951_s19_q;
      and_4105_s20_q <= said_q;
      and_4120_s20_q <= and_4120;
      select_4190_s20_q <= select_4190_s19_q;
      select_4197_s20_q <= select_4197_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
  logic moments_out_of_step_q;
  logic moments_begins_alone_q;
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [13:0] counts_unproven_q;
  logic [13:0] counts_regions_bad_q;
  logic [13:0] counts_skin_unproven_q;
  logic [13:0] counts_on_skin_q;
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
  logic proven_q;
  // hls/stages/moments.hpp:51
  logic or_2328;
  assign or_2328 = moments_begins_alone_q | (moments_out_of_step_q & not_2326_s20_q);
  // hls/stages/census.hpp:395
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2411_s20_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2414;
  assign select_2414 = equal_2398_s20_q ? (less_2399_s20_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:395
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2421_s20_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2424;
  assign select_2424 = equal_2398_s20_q ? (less_2399_s20_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2643;
  assign select_2643 = and_2594_s20_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2641_s20_q});
  logic [13:0] select_2657;
  assign select_2657 = and_2594_s20_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2655_s20_q});
  // hls/stages/agreement.hpp:788
  logic and_2677;
  assign and_2677 = not_574_s20_q & and_2676_s20_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2679;
  assign select_2679 = and_2594_s20_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2677});
  logic [13:0] select_2698;
  assign select_2698 = and_2594_s20_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2696_s20_q});
  // hls/stages/count_bits.hpp:27
  logic or_3461;
  assign or_3461 = and_3458_s20_q | and_3460_s20_q;
  // hls/stages/patches.hpp:526
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3461, parity_3457_s20_q, xor_3445_s20_q, parity_3417_s20_q, parity_3355_s20_q, parity_3226_s20_q} + (equal_3462_s20_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:185
  logic [9:0] select_3466;
  assign select_3466 = equal_1783_s20_q ? patches_sums_values_0_q : (equal_1785_s20_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3467;
  assign select_3467 = equal_1785_s20_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3469;
  assign select_3469 = equal_1785_s20_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3471;
  assign select_3471 = equal_1785_s20_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3473;
  assign select_3473 = equal_1785_s20_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3475;
  assign select_3475 = equal_1785_s20_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3477;
  assign select_3477 = equal_1785_s20_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3479;
  assign select_3479 = equal_1785_s20_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3481;
  assign select_3481 = equal_1785_s20_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3483;
  assign select_3483 = equal_1785_s20_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3485;
  assign select_3485 = equal_1785_s20_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3487;
  assign select_3487 = equal_1785_s20_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3489;
  assign select_3489 = equal_1785_s20_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3491;
  assign select_3491 = equal_1785_s20_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3493;
  assign select_3493 = equal_1785_s20_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3495;
  assign select_3495 = equal_1785_s20_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3497;
  assign select_3497 = equal_1785_s20_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:580
  logic not_3606;
  assign not_3606 = ~or_3605_s20_q;
  // hls/stages/patches.hpp:561
  logic and_3607;
  assign and_3607 = equal_1964_s20_q & not_3606;
  // hls/stages/patches.hpp:185
  logic and_3610;
  assign and_3610 = equal_1783_s20_q & (less_1961_s20_q ? (not_1963_s20_q & and_3607) : and_3607);
  // hls/stages/patches.hpp:561
  logic and_3613;
  assign and_3613 = equal_1964_s20_q & (patches_second_s20_q & not_3606);
  // hls/stages/patches.hpp:185
  logic and_3616;
  assign and_3616 = equal_1783_s20_q & (less_1961_s20_q ? (not_1963_s20_q & and_3613) : and_3613);
  // hls/stages/patches.hpp:561
  logic and_3656;
  assign and_3656 = equal_1964_s20_q & (not_3606 & not_3654_s20_q);
  // hls/stages/patches.hpp:185
  logic and_3659;
  assign and_3659 = equal_1783_s20_q & (less_1961_s20_q ? (not_1963_s20_q & and_3656) : and_3656);
  // hls/stages/patches.hpp:561
  logic and_3666;
  assign and_3666 = equal_1964_s20_q & (not_3606 & not_3664_s20_q);
  // hls/stages/patches.hpp:185
  logic and_3669;
  assign and_3669 = equal_1783_s20_q & (less_1961_s20_q ? (not_1963_s20_q & and_3666) : and_3666);
  // hls/stages/agreement.hpp:1130
  logic less_3703;
  assign less_3703 = x_s20_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3707;
  assign and_3707 = equal_573_s20_q & (x_s20_q[6] & (not_1991_s20_q & (equal_3702_s20_q & less_3703)));
  // hls/stages/agreement.hpp:1142
  logic and_3712;
  assign and_3712 = x_s20_q[6] & (not_1991_s20_q & (less_3703 & (x_s20_q[2:0] == 3'h1)));
  logic and_3719;
  assign and_3719 = x_s20_q[6] & (not_1991_s20_q & (less_3703 & (x_s20_q[2:0] == 3'h2)));
  logic and_3726;
  assign and_3726 = x_s20_q[6] & (not_1991_s20_q & (less_3703 & (x_s20_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:200
  logic select_3733;
  assign select_3733 = (x_s20_q[5:3] == 3'h2) ? x_s20_q[1] : (x_s20_q[0] & (x_s20_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:203
  logic [4:0] sum_3760;
  assign sum_3760 = {2'h0, x_s20_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:607
  logic [5:0] select_3779;
  assign select_3779 = less_3776_s20_q ? 6'h10 : (less_3777_s20_q ? 6'h30 : difference_3652_s20_q);
  // hls/stages/patches.hpp:561
  logic [5:0] select_3781;
  assign select_3781 = equal_1964_s20_q ? (or_3605_s20_q ? 6'h0 : select_3779) : 6'h0;
  logic [5:0] select_3783;
  assign select_3783 = less_1961_s20_q ? (equal_1962_s20_q ? 6'h0 : select_3781) : select_3781;
  // hls/stages/agreement.hpp:788
  logic and_3790;
  assign and_3790 = equal_573_s20_q & (x_s20_q[6] & (not_1991_s20_q & (equal_2895_s20_q & less_3703)));
  // hls/stages/agreement.hpp:1142
  logic and_3794;
  assign and_3794 = x_s20_q[6] & (not_1991_s20_q & (less_3703 & (x_s20_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:561
  logic and_3829;
  assign and_3829 = equal_1964_s20_q & (not_3606 & less_3827_s20_q);
  // hls/stages/patches.hpp:185
  logic and_3832;
  assign and_3832 = equal_1783_s20_q & (less_1961_s20_q ? (not_1963_s20_q & and_3829) : and_3829);
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3953;
  assign select_3953 = equal_3950_s20_q ? counts_skin_unproven_q : (equal_3951_s20_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3955;
  assign select_3955 = equal_3949_s20_q ? counts_regions_bad_q : (equal_3946_s20_q ? counts_nearer_s20_q : select_3953);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3948_s20_q ? counts_on_skin_q : select_3955;
  // hls/stages/agreement.hpp:788
  logic and_4181;
  assign and_4181 = equal_573_s20_q & (x_s20_q[6] & (not_1991_s20_q | (4'hc < x_s20_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4191;
  assign select_4191 = equal_1624_s20_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4190_s20_q;
  logic [31:0] select_4192;
  assign select_4192 = equal_1622_s20_q ? {8'h0, sharpness_sums_detail_0_s20_q} : select_4191;
  logic [31:0] select_4193;
  assign select_4193 = equal_1620_s20_q ? {8'h0, sharpness_sums_detail_1_s20_q} : select_4192;
  logic [31:0] select_4194;
  assign select_4194 = equal_1618_s20_q ? {8'h0, sharpness_sums_contrast_0_s20_q} : select_4193;
  logic [31:0] select_4195;
  assign select_4195 = equal_1616_s20_q ? {8'h0, sharpness_sums_contrast_1_s20_q} : select_4194;

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1813_s20_q, select_1810_s20_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s20_en & and_1823_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s20_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_0_raddr_s8_sim;
  logic patches_right_0_re_s8_sim;
  logic [9:0] patches_right_0_raddr_s9_sim;
  logic patches_right_0_re_s9_sim;
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
      patches_right_0_re_s8_sim <= 1'b0;
      patches_right_0_re_s9_sim <= 1'b0;
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
      patches_right_0_re_s8_sim <= patches_right_0_re;
      patches_right_0_raddr_s8_sim <= patches_right_0_raddr;
      patches_right_0_re_s9_sim <= patches_right_0_re_s8_sim;
      patches_right_0_raddr_s9_sim <= patches_right_0_raddr_s8_sim;
      patches_right_0_re_s10_sim <= patches_right_0_re_s9_sim;
      patches_right_0_raddr_s10_sim <= patches_right_0_raddr_s9_sim;
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
      if (patches_right_0_re_s8_sim && patches_right_0_raddr_s8_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s9_sim && patches_right_0_raddr_s9_sim == patches_right_0_waddr) begin
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
  assign patches_right_1_waddr = {select_1813_s20_q, select_1838_s20_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s20_en & and_1842_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s20_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_1_raddr_s8_sim;
  logic patches_right_1_re_s8_sim;
  logic [9:0] patches_right_1_raddr_s9_sim;
  logic patches_right_1_re_s9_sim;
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
      patches_right_1_re_s8_sim <= 1'b0;
      patches_right_1_re_s9_sim <= 1'b0;
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
      patches_right_1_re_s8_sim <= patches_right_1_re;
      patches_right_1_raddr_s8_sim <= patches_right_1_raddr;
      patches_right_1_re_s9_sim <= patches_right_1_re_s8_sim;
      patches_right_1_raddr_s9_sim <= patches_right_1_raddr_s8_sim;
      patches_right_1_re_s10_sim <= patches_right_1_re_s9_sim;
      patches_right_1_raddr_s10_sim <= patches_right_1_raddr_s9_sim;
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
      if (patches_right_1_re_s8_sim && patches_right_1_raddr_s8_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s9_sim && patches_right_1_raddr_s9_sim == patches_right_1_waddr) begin
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
  assign patches_left_waddr = {select_1858_s20_q, select_1857_s20_q, column_4_s20_q};
  logic patches_left_we;
  assign patches_left_we = s20_en & and_1865_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s20_q;
  end
`ifndef SYNTHESIS
  logic [8:0] patches_left_raddr_s9_sim;
  logic patches_left_re_s9_sim;
  logic [8:0] patches_left_raddr_s10_sim;
  logic patches_left_re_s10_sim;
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
      patches_left_re_s9_sim <= 1'b0;
      patches_left_re_s10_sim <= 1'b0;
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
      patches_left_re_s9_sim <= patches_left_re;
      patches_left_raddr_s9_sim <= patches_left_raddr;
      patches_left_re_s10_sim <= patches_left_re_s9_sim;
      patches_left_raddr_s10_sim <= patches_left_raddr_s9_sim;
      patches_left_re_s11_sim <= patches_left_re_s10_sim;
      patches_left_raddr_s11_sim <= patches_left_raddr_s10_sim;
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
      if (patches_left_re_s9_sim && patches_left_raddr_s9_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s10_sim && patches_left_raddr_s10_sim == patches_left_waddr) begin
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
  assign map_waddr = {sum_2063_s20_q, index_2_s20_q};
  logic map_we;
  assign map_we = s20_en & and_2137_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2127_s20_q, is_seen_s20_q};
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
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      counts_unproven_q <= 14'h0;
      counts_regions_bad_q <= 14'h0;
      counts_skin_unproven_q <= 14'h0;
      counts_on_skin_q <= 14'h0;
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
      proven_q <= 1'b0;
    end else if (s20_en) begin
      moments_out_of_step_q <= or_2328;
      moments_begins_alone_q <= equal_573_s20_q & (equal_2295_s20_q & and_2347_s20_q);
      sharpness_comparing_rest_0_q <= so_s20_q ? select_2414 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s20_q ? select_2424 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2643;
      counts_regions_bad_q <= select_2657;
      counts_skin_unproven_q <= select_2679;
      counts_on_skin_q <= select_2698;
      patches_sums_values_0_q <= select_3466;
      patches_sums_values_1_q <= equal_1783_s20_q ? patches_sums_values_1_q : select_3467;
      patches_sums_values_2_q <= equal_1783_s20_q ? patches_sums_values_2_q : select_3469;
      patches_sums_values_3_q <= equal_1783_s20_q ? patches_sums_values_3_q : select_3471;
      patches_sums_values_4_q <= equal_1783_s20_q ? patches_sums_values_4_q : select_3473;
      patches_sums_values_5_q <= equal_1783_s20_q ? patches_sums_values_5_q : select_3475;
      patches_sums_values_6_q <= equal_1783_s20_q ? patches_sums_values_6_q : select_3477;
      patches_sums_values_7_q <= equal_1783_s20_q ? patches_sums_values_7_q : select_3479;
      patches_sums_values_8_q <= equal_1783_s20_q ? patches_sums_values_8_q : select_3481;
      patches_sums_values_9_q <= equal_1783_s20_q ? patches_sums_values_9_q : select_3483;
      patches_sums_values_10_q <= equal_1783_s20_q ? patches_sums_values_10_q : select_3485;
      patches_sums_values_11_q <= equal_1783_s20_q ? patches_sums_values_11_q : select_3487;
      patches_sums_values_12_q <= equal_1783_s20_q ? patches_sums_values_12_q : select_3489;
      patches_sums_values_13_q <= equal_1783_s20_q ? patches_sums_values_13_q : select_3491;
      patches_sums_values_14_q <= equal_1783_s20_q ? patches_sums_values_14_q : select_3493;
      patches_sums_values_15_q <= equal_1783_s20_q ? patches_sums_values_15_q : select_3495;
      patches_sums_values_16_q <= equal_1783_s20_q ? patches_sums_values_16_q : select_3497;
      patches_frame_ended_q <= equal_573_s20_q & equal_2295_s20_q;
      proven_q <= marks_first_s20_q ? done_s20_q : proven_q;
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
  logic [9:0] patches_sums_values_0_s21_q;
  logic [4:0] patches_summed_row_column_s21_q;
  logic patches_summed_first_s21_q;
  logic patches_summed_last_s21_q;
  logic [4:0] patches_summed_down_by_s21_q;
  logic patches_frame_ended_s21_q;
  logic [13:0] product_s21_q;
  logic [6:0] last_s21_q;
  logic and_548_s21_q;
  logic equal_573_s21_q;
  logic so_s21_q;
  logic less_651_s21_q;
  logic less_652_s21_q;
  logic less_653_s21_q;
  logic less_654_s21_q;
  logic less_655_s21_q;
  logic less_656_s21_q;
  logic less_657_s21_q;
  logic less_658_s21_q;
  logic less_659_s21_q;
  logic less_660_s21_q;
  logic less_661_s21_q;
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
  logic and_682_s21_q;
  logic and_707_s21_q;
  logic and_708_s21_q;
  logic less_731_s21_q;
  logic and_738_s21_q;
  logic less_739_s21_q;
  logic and_744_s21_q;
  logic less_745_s21_q;
  logic equal_1606_s21_q;
  logic equal_1614_s21_q;
  logic and_2057_s21_q;
  logic less_2058_s21_q;
  logic [1:0] map_rdata_s21_q;
  logic is_seen_s21_q;
  logic and_2127_s21_q;
  logic equal_2280_s21_q;
  logic and_2285_s21_q;
  logic equal_2398_s21_q;
  logic sum_s21_q;
  logic sum_2_s21_q;
  logic equal_2442_s21_q;
  logic select_2460_s21_q;
  logic select_2466_s21_q;
  logic [9:0] select_2645_s21_q;
  logic [9:0] select_2648_s21_q;
  logic and_3610_s21_q;
  logic and_3616_s21_q;
  logic and_3659_s21_q;
  logic and_3669_s21_q;
  logic equal_3702_s21_q;
  logic and_3707_s21_q;
  logic and_3713_s21_q;
  logic and_3720_s21_q;
  logic and_3727_s21_q;
  logic and_3736_s21_q;
  logic and_3763_s21_q;
  logic [5:0] select_3784_s21_q;
  logic and_3790_s21_q;
  logic and_3795_s21_q;
  logic and_3833_s21_q;
  logic or_3924_s21_q;
  logic select_3932_s21_q;
  logic equal_3943_s21_q;
  logic and_3947_s21_q;
  logic [13:0] before_v_4_s21_q;
  logic not_3992_s21_q;
  logic or_3996_s21_q;
  logic and_4001_s21_q;
  logic less_4002_s21_q;
  logic and_4105_s21_q;
  logic and_4120_s21_q;
  logic not_4134_s21_q;
  logic and_4181_s21_q;
  logic [5:0] select_4183_s21_q;
  logic [31:0] select_4195_s21_q;
  logic [9:0] select_4197_s21_q;
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
      patches_sums_values_0_s21_q <= patches_sums_values_0_q;
      patches_summed_row_column_s21_q <= patches_summed_row_column_s20_q;
      patches_summed_first_s21_q <= patches_summed_first_s20_q;
      patches_summed_last_s21_q <= patches_summed_last_s20_q;
      patches_summed_down_by_s21_q <= patches_summed_down_by_s20_q;
      patches_frame_ended_s21_q <= patches_frame_ended_q;
      product_s21_q <= product_s20_q;
      last_s21_q <= last_s20_q;
      and_548_s21_q <= and_548_s20_q;
      equal_573_s21_q <= equal_573_s20_q;
      so_s21_q <= so_s20_q;
      less_651_s21_q <= less_651_s20_q;
      less_652_s21_q <= less_652_s20_q;
      less_653_s21_q <= less_653_s20_q;
      less_654_s21_q <= less_654_s20_q;
      less_655_s21_q <= less_655_s20_q;
      less_656_s21_q <= less_656_s20_q;
      less_657_s21_q <= less_657_s20_q;
      less_658_s21_q <= less_658_s20_q;
      less_659_s21_q <= less_659_s20_q;
      less_660_s21_q <= less_660_s20_q;
      less_661_s21_q <= less_661_s20_q;
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
      and_682_s21_q <= and_682_s20_q;
      and_707_s21_q <= and_707_s20_q;
      and_708_s21_q <= and_708_s20_q;
      less_731_s21_q <= 9'h4 < sum_730_s20_q;
      and_738_s21_q <= and_738_s20_q;
      less_739_s21_q <= less_739_s20_q;
      and_744_s21_q <= and_744_s20_q;
      less_745_s21_q <= less_745_s20_q;
      equal_1606_s21_q <= equal_1606_s20_q;
      equal_1614_s21_q <= equal_1614_s20_q;
      and_2057_s21_q <= and_2057_s20_q;
      less_2058_s21_q <= less_2058_s20_q;
      map_rdata_s21_q <= map_rdata_q;
      is_seen_s21_q <= is_seen_s20_q;
      and_2127_s21_q <= and_2127_s20_q;
      equal_2280_s21_q <= equal_2280_s20_q;
      and_2285_s21_q <= and_707_s20_q & (9'h4 < sum_2283_s20_q);
      equal_2398_s21_q <= equal_2398_s20_q;
      sum_s21_q <= sum[0];
      sum_2_s21_q <= sum_2[0];
      equal_2442_s21_q <= equal_2442_s20_q;
      select_2460_s21_q <= sharpness_comparing_less_contrast_0_q;
      select_2466_s21_q <= sharpness_comparing_less_contrast_1_q;
      select_2645_s21_q <= select_2645_s20_q;
      select_2648_s21_q <= select_2648_s20_q;
      and_3610_s21_q <= and_3610;
      and_3616_s21_q <= and_3616;
      and_3659_s21_q <= and_3659;
      and_3669_s21_q <= and_3669;
      equal_3702_s21_q <= equal_3702_s20_q;
      and_3707_s21_q <= and_3707;
      and_3713_s21_q <= equal_573_s20_q & and_3712;
      and_3720_s21_q <= equal_573_s20_q & and_3719;
      and_3727_s21_q <= equal_573_s20_q & and_3726;
      and_3736_s21_q <= x_s20_q[6] & (not_1991_s20_q & (less_3703 & select_3733));
      and_3763_s21_q <= not_1991_s20_q & (less_3703 & (sum_3760[4:2] == 3'h0));
      select_3784_s21_q <= equal_1783_s20_q ? select_3783 : 6'h0;
      and_3790_s21_q <= and_3790;
      and_3795_s21_q <= equal_573_s20_q & and_3794;
      and_3833_s21_q <= and_3610 & and_3832;
      or_3924_s21_q <= or_3924_s20_q;
      select_3932_s21_q <= select_3932_s20_q;
      equal_3943_s21_q <= equal_3943_s20_q;
      and_3947_s21_q <= equal_3946_s20_q & equal_3702_s20_q;
      before_v_4_s21_q <= before_v_4;
      not_3992_s21_q <= ~(equal_3951_s20_q & equal_3702_s20_q);
      or_3996_s21_q <= (equal_3951_s20_q | equal_3950_s20_q) | (x_s20_q[6:3] == 4'hf);
      and_4001_s21_q <= equal_3948_s20_q & equal_3702_s20_q;
      less_4002_s21_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4105_s21_q <= and_4105_s20_q;
      and_4120_s21_q <= and_4120_s20_q;
      not_4134_s21_q <= ~proven_q;
      and_4181_s21_q <= and_4181;
      select_4183_s21_q <= equal_573_s20_q ? (x_s20_q[6] ? x_s20_q[5:0] : 6'h0) : 6'h0;
      select_4195_s21_q <= select_4195;
      select_4197_s21_q <= select_4197_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [19:0] census_left_misses_q;
  logic [2:0] sharpness_comparing_product_0_q;
  logic [2:0] sharpness_comparing_product_1_q;
  logic sharpness_comparing_carry_0_q;
  logic sharpness_comparing_carry_1_q;
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
  logic hides_q;
  // hls/stages/census.hpp:317
  logic and_732;
  assign and_732 = and_682_s21_q & less_731_s21_q;
  // hls/stages/patches.hpp:185
  logic less_1973;
  assign less_1973 = patches_sums_values_0_s21_q < patches_best_differing_q;
  // hls/stages/patches.hpp:186
  logic not_1974;
  assign not_1974 = ~less_1973;
  logic [1:0] select_1975;
  assign select_1975 = patches_summed_first_s21_q ? 2'h2 : {less_1973, not_1974};
  logic [12:0] select_1977;
  assign select_1977 = select_1975[0] ? {4'h0, patches_summed_first_s21_q, 3'h0, patches_summed_row_column_s21_q} : {patches_summed_row_column_s21_q, patches_sums_values_0_s21_q[7:0]};
  logic [14:0] select_1978;
  assign select_1978 = select_1975[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1979;
  assign select_1979 = (select_1975 == 2'h2) ? {select_1977[12:8], patches_sums_values_0_s21_q[9:8], select_1977[7:0]} : select_1978;
  // hls/stages/census.hpp:324
  logic and_2286;
  assign and_2286 = and_707_s21_q & less_731_s21_q;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2287;
  assign sum_2287 = census_left_misses_q + {{17{and_2286}}, and_2285_s21_q, 1'b0, and_2285_s21_q};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2289;
  assign select_2289 = and_548_s21_q ? (equal_2280_s21_q ? 20'h0 : sum_2287) : census_left_misses_q;
  // hls/stages/agreement.hpp:216
  logic [2:0] select_2426;
  assign select_2426 = equal_2398_s21_q ? {sharpness_comparing_product_0_q[1:0], sum_s21_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2428;
  assign select_2428 = equal_2398_s21_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s21_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s21_q});
  // hls/stages/agreement.hpp:216
  logic select_2437;
  assign select_2437 = so_s21_q ? (equal_2398_s21_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s21_q});
  // hls/stages/agreement.hpp:216
  logic select_2440;
  assign select_2440 = equal_2398_s21_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:403
  logic xor_2443;
  assign xor_2443 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2449;
  assign xor_2449 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:658
  logic not_3611;
  assign not_3611 = ~patches_lower_s21_q;
  logic not_3617;
  assign not_3617 = ~and_3616_s21_q;
  // hls/stages/patches.hpp:189
  logic and_3619;
  assign and_3619 = and_3610_s21_q & (not_3611 & not_3617);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3621;
  assign sum_3621 = {7'h0, and_3619} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:661
  logic and_3660;
  assign and_3660 = and_3659_s21_q & and_3619;
  logic [7:0] sum_3661;
  assign sum_3661 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3660};
  // hls/stages/patches.hpp:662
  logic and_3670;
  assign and_3670 = and_3669_s21_q & and_3619;
  logic [7:0] sum_3671;
  assign sum_3671 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3670};
  // hls/stages/patches.hpp:189
  logic and_3673;
  assign and_3673 = and_3610_s21_q & (and_3616_s21_q & not_3611);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3675;
  assign sum_3675 = {7'h0, and_3673} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:661
  logic and_3677;
  assign and_3677 = and_3659_s21_q & and_3673;
  logic [7:0] sum_3678;
  assign sum_3678 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3677};
  // hls/stages/patches.hpp:662
  logic and_3680;
  assign and_3680 = and_3669_s21_q & and_3673;
  logic [7:0] sum_3681;
  assign sum_3681 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3680};
  // hls/stages/patches.hpp:189
  logic and_3683;
  assign and_3683 = and_3610_s21_q & (patches_lower_s21_q & not_3617);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3685;
  assign sum_3685 = {7'h0, and_3683} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:661
  logic and_3687;
  assign and_3687 = and_3659_s21_q & and_3683;
  logic [7:0] sum_3688;
  assign sum_3688 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3687};
  // hls/stages/patches.hpp:662
  logic and_3690;
  assign and_3690 = and_3669_s21_q & and_3683;
  logic [7:0] sum_3691;
  assign sum_3691 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3690};
  // hls/stages/patches.hpp:189
  logic and_3693;
  assign and_3693 = and_3610_s21_q & (patches_lower_s21_q & and_3616_s21_q);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3695;
  assign sum_3695 = {7'h0, and_3693} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:661
  logic and_3697;
  assign and_3697 = and_3659_s21_q & and_3693;
  logic [7:0] sum_3698;
  assign sum_3698 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3697};
  // hls/stages/patches.hpp:662
  logic and_3700;
  assign and_3700 = and_3669_s21_q & and_3693;
  logic [7:0] sum_3701;
  assign sum_3701 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3700};
  // hls/stages/patches.hpp:624
  logic [7:0] or_3715;
  assign or_3715 = (and_3707_s21_q ? patches_quarters_0_places_q : 8'h0) | (and_3713_s21_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3729;
  assign or_3729 = (or_3715 | (and_3720_s21_q ? patches_quarters_2_places_q : 8'h0)) | (and_3727_s21_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_3737;
  assign and_3737 = equal_573_s21_q & and_3736_s21_q;
  // hls/stages/patches.hpp:625
  logic [7:0] select_3739;
  assign select_3739 = and_3707_s21_q ? (and_3737 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3741;
  assign select_3741 = and_3713_s21_q ? (and_3737 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3744;
  assign select_3744 = and_3720_s21_q ? (and_3737 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3747;
  assign select_3747 = and_3727_s21_q ? (and_3737 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:626
  logic [7:0] select_3750;
  assign select_3750 = and_3707_s21_q ? (and_3737 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3752;
  assign select_3752 = and_3713_s21_q ? (and_3737 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3755;
  assign select_3755 = and_3720_s21_q ? (and_3737 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3758;
  assign select_3758 = and_3727_s21_q ? (and_3737 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_3765;
  assign and_3765 = equal_573_s21_q & (x_s21_q & and_3763_s21_q);
  // hls/stages/patches.hpp:619
  logic [7:0] sum_3767;
  assign sum_3767 = patches_word_places_q + (and_3713_s21_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:621
  logic [7:0] select_3771;
  assign select_3771 = and_3765 ? (patches_word_up_q + (and_3713_s21_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3773;
  assign sum_3773 = patches_word_down_q + (and_3713_s21_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:664
  logic [5:0] select_3785;
  assign select_3785 = and_3610_s21_q ? select_3784_s21_q : 6'h0;
  logic [11:0] sum_3786;
  assign sum_3786 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3785[5]}}, select_3785};
  // hls/stages/patches.hpp:648
  logic [7:0] select_3797;
  assign select_3797 = and_3790_s21_q ? (and_3795_s21_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:650
  logic or_3801;
  assign or_3801 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic or_3804;
  assign or_3804 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:652
  logic [8:0] sum_3805;
  assign sum_3805 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:647
  logic select_3807;
  assign select_3807 = and_3790_s21_q ? (and_3795_s21_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:189
  logic and_3810;
  assign and_3810 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:647
  logic [2:0] select_3811;
  assign select_3811 = and_3790_s21_q ? {and_3810, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3813;
  assign select_3813 = and_3790_s21_q ? (and_3795_s21_q ? {and_3810, patches_found_q[2:1]} : select_3811) : patches_found_q;
  // hls/stages/patches.hpp:646
  logic or_3816;
  assign or_3816 = patches_partly_q | (patches_doubted_q & (~and_3795_s21_q));
  // hls/stages/patches.hpp:647
  logic select_3818;
  assign select_3818 = and_3795_s21_q ? or_3816 : (and_3790_s21_q ? or_3816 : patches_doubted_q);
  // hls/stages/patches.hpp:645
  logic select_3820;
  assign select_3820 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_3824;
  assign select_3824 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:665
  logic [7:0] sum_3834;
  assign sum_3834 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3833_s21_q};
  // hls/stages/patches.hpp:636
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:637
  logic select_3857;
  assign select_3857 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:638
  logic and_3863;
  assign and_3863 = patches_frame_ended_s21_q & (~patches_age_q[9]);
  logic [9:0] sum_3864;
  assign sum_3864 = patches_age_q + {9'h0, and_3863};
  logic [9:0] select_3867;
  assign select_3867 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3864)) : sum_3864;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_s21_q} - {1'b0, before_v_4_s21_q};
  // hls/stages/agreement.hpp:1230
  logic select_3958;
  assign select_3958 = and_3947_s21_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4121;
  assign select_4121 = and_4120_s21_q ? {and_2127_s21_q, is_seen_s21_q} : map_rdata_s21_q;
  // hls/stages/agreement.hpp:1309
  logic and_4122;
  assign and_4122 = proven_q & less_4110;
  // hls/stages/agreement.hpp:1239
  logic or_4135;
  assign or_4135 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4134_s21_q;
  // hls/stages/agreement.hpp:788
  logic and_4150;
  assign and_4150 = equal_3943_s21_q & (cfg_prove_i & (registration_moved_s21_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4153;
  assign or_4153 = select_2460_s21_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:788
  logic and_4177;
  assign and_4177 = equal_573_s21_q & (equal_3943_s21_q & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4196;
  assign select_4196 = equal_1614_s21_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4195_s21_q;
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4198;
  assign select_4198 = equal_1606_s21_q ? select_4196 : {2'h0, select_4197_s21_q, select_2648_s21_q, select_2645_s21_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s21_q;
  logic fresh_we;
  assign fresh_we = s21_en & and_548_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_745_s21_q, and_744_s21_q, less_739_s21_q, and_738_s21_q, census_columns_values_1_cell_2_of_skin_s21_q, and_732, and_708_s21_q, and_707_s21_q, and_682_s21_q, less_674_s21_q, less_673_s21_q, less_672_s21_q, less_671_s21_q, less_670_s21_q, less_669_s21_q, less_668_s21_q, less_667_s21_q, less_666_s21_q, less_665_s21_q, less_664_s21_q, less_663_s21_q, less_662_s21_q, less_661_s21_q, less_660_s21_q, less_659_s21_q, less_658_s21_q, less_657_s21_q, less_656_s21_q, less_655_s21_q, less_654_s21_q, less_653_s21_q, less_652_s21_q, less_651_s21_q};
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
      hides_q <= 1'b0;
    end else if (s21_en) begin
      census_left_misses_q <= select_2289;
      sharpness_comparing_product_0_q <= so_s21_q ? select_2426 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s21_q ? select_2428 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2437;
      sharpness_comparing_carry_1_q <= so_s21_q ? select_2440 : sharpness_comparing_carry_1_q;
      patches_best_differing_q <= select_1979[9:0];
      patches_best_column_q <= select_1979[14:10];
      patches_quarters_0_places_q <= sum_3621;
      patches_quarters_0_up_q <= sum_3661;
      patches_quarters_0_down_q <= sum_3671;
      patches_quarters_1_places_q <= sum_3675;
      patches_quarters_1_up_q <= sum_3678;
      patches_quarters_1_down_q <= sum_3681;
      patches_quarters_2_places_q <= sum_3685;
      patches_quarters_2_up_q <= sum_3688;
      patches_quarters_2_down_q <= sum_3691;
      patches_quarters_3_places_q <= sum_3695;
      patches_quarters_3_up_q <= sum_3698;
      patches_quarters_3_down_q <= sum_3701;
      patches_word_places_q <= or_3729;
      patches_word_up_q <= ((select_3739 | select_3741) | select_3744) | select_3747;
      patches_word_down_q <= ((select_3750 | select_3752) | select_3755) | select_3758;
      patches_sum_places_q <= and_3765 ? sum_3767 : patches_sum_places_q;
      patches_sum_up_q <= select_3771;
      patches_sum_down_q <= and_3765 ? sum_3773 : patches_sum_down_q;
      patches_across_q <= sum_3786;
      patches_places_q <= select_3797;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3801;
      patches_partly_q <= or_3804;
      patches_clear_limit_q <= sum_3805[8:2];
      patches_complete_q <= select_3807;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3813;
      patches_doubted_q <= and_3790_s21_q ? select_3818 : patches_doubted_q;
      patches_doubted_before_q <= select_3820;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3824;
      patches_on_skin_q <= sum_3834;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3857;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3867;
      hides_q <= equal_573_s21_q ? select_3958 : hides_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s21_en) begin
      left_pixel_q <= left_pixel_q;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic patches_summed_last_s22_q;
  logic [4:0] patches_summed_down_by_s22_q;
  logic patches_round_ends_s22_q;
  logic [7:0] patches_on_skin_s22_q;
  logic equal_573_s22_q;
  logic so_s22_q;
  logic and_2057_s22_q;
  logic less_2058_s22_q;
  logic equal_2398_s22_q;
  logic or_2444_s22_q;
  logic and_2445_s22_q;
  logic or_2450_s22_q;
  logic and_2451_s22_q;
  logic select_2466_s22_q;
  logic or_3924_s22_q;
  logic select_3932_s22_q;
  logic equal_3943_s22_q;
  logic select_3958_s22_q;
  logic and_3990_s22_q;
  logic not_3992_s22_q;
  logic or_3996_s22_q;
  logic and_4001_s22_q;
  logic and_4003_s22_q;
  logic and_4105_s22_q;
  logic and_4123_s22_q;
  logic and_4126_s22_q;
  logic and_4138_s22_q;
  logic and_4151_s22_q;
  logic or_4153_s22_q;
  logic and_4177_s22_q;
  logic and_4181_s22_q;
  logic [5:0] select_4183_s22_q;
  logic [31:0] select_4200_s22_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      patches_summed_last_s22_q <= patches_summed_last_s21_q;
      patches_summed_down_by_s22_q <= patches_summed_down_by_s21_q;
      patches_round_ends_s22_q <= patches_round_ends_q;
      patches_on_skin_s22_q <= patches_on_skin_q;
      equal_573_s22_q <= equal_573_s21_q;
      so_s22_q <= so_s21_q;
      and_2057_s22_q <= and_2057_s21_q;
      less_2058_s22_q <= less_2058_s21_q;
      equal_2398_s22_q <= equal_2398_s21_q;
      or_2444_s22_q <= equal_2442_s21_q | xor_2443;
      and_2445_s22_q <= five_times[0] & xor_2443;
      or_2450_s22_q <= equal_2442_s21_q | xor_2449;
      and_2451_s22_q <= five_times_2[0] & xor_2449;
      select_2466_s22_q <= select_2466_s21_q;
      or_3924_s22_q <= or_3924_s21_q;
      select_3932_s22_q <= select_3932_s21_q;
      equal_3943_s22_q <= equal_3943_s21_q;
      select_3958_s22_q <= select_3958;
      and_3990_s22_q <= over[14] & equal_3702_s21_q;
      not_3992_s22_q <= not_3992_s21_q;
      or_3996_s22_q <= or_3996_s21_q;
      and_4001_s22_q <= and_4001_s21_q;
      and_4003_s22_q <= over[14] & less_4002_s21_q;
      and_4105_s22_q <= and_4105_s21_q;
      and_4123_s22_q <= select_4121[0] & and_4122;
      and_4126_s22_q <= select_4121[1] & and_4122;
      and_4138_s22_q <= equal_573_s21_q & (equal_3943_s21_q & (cfg_prove_i & or_4135));
      and_4151_s22_q <= equal_573_s21_q & and_4150;
      or_4153_s22_q <= or_4153;
      and_4177_s22_q <= and_4177;
      and_4181_s22_q <= and_4181_s21_q;
      select_4183_s22_q <= select_4183_s21_q;
      select_4200_s22_q <= equal_573_s21_q ? (x_s21_q ? select_4198 : 32'h0) : 32'h0;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic overlooks_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:403
  logic select_2446;
  assign select_2446 = or_2444_s22_q ? and_2445_s22_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2447;
  assign select_2447 = equal_2398_s22_q ? select_2446 : sharpness_comparing_less_detail_0_q;
  logic select_2448;
  assign select_2448 = so_s22_q ? select_2447 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic select_2452;
  assign select_2452 = or_2450_s22_q ? and_2451_s22_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2453;
  assign select_2453 = equal_2398_s22_q ? select_2452 : sharpness_comparing_less_detail_1_q;
  logic select_2454;
  assign select_2454 = so_s22_q ? select_2453 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:654
  logic [12:0] product_3839;
  assign product_3839 = {8'h0, cfg_on_skin_limit_i} * {5'h0, patches_places_q};
  // hls/stages/agreement.hpp:1148
  logic not_3959;
  assign not_3959 = ~hidden_for_q[7];
  logic [7:0] select_3961;
  assign select_3961 = select_3958_s22_q ? (hidden_for_q + {7'h0, not_3959}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3963;
  assign select_3963 = equal_573_s22_q ? (equal_3943_s22_q ? select_3961 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1228
  logic and_3993;
  assign and_3993 = too_much_q & not_3992_s22_q;
  // hls/stages/agreement.hpp:1229
  logic select_3998;
  assign select_3998 = and_3990_s22_q ? (and_3993 | or_3996_s22_q) : and_3993;
  // hls/stages/agreement.hpp:1231
  logic select_4004;
  assign select_4004 = and_4001_s22_q ? and_4003_s22_q : overlooks_q;
  // hls/stages/agreement.hpp:438
  logic select_4125;
  assign select_4125 = and_2057_s22_q ? (less_2058_s22_q ? and_4123_s22_q : seen_q) : seen_q;
  logic select_4128;
  assign select_4128 = and_2057_s22_q ? (less_2058_s22_q ? and_4126_s22_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:788
  logic and_4141;
  assign and_4141 = equal_573_s22_q & (equal_3943_s22_q & (cfg_prove_i & or_3924_s22_q));
  // hls/stages/agreement.hpp:1241
  logic not_4143;
  assign not_4143 = ~(or_3924_s22_q | not_2350);
  // hls/stages/agreement.hpp:788
  logic and_4146;
  assign and_4146 = equal_3943_s22_q & (not_4143 & (select_3932_s22_q | select_3998));
  logic and_4160;
  assign and_4160 = equal_3943_s22_q & (not_4143 & (select_2454 | select_2466_s22_q));

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s22_q;
  logic patches_rows_we;
  assign patches_rows_we = s22_en & patches_summed_last_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= {patches_best_column_q, patches_best_differing_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_rows_raddr_s8_sim;
  logic patches_rows_re_s8_sim;
  logic [4:0] patches_rows_raddr_s9_sim;
  logic patches_rows_re_s9_sim;
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_rows_re_s8_sim <= 1'b0;
      patches_rows_re_s9_sim <= 1'b0;
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
    end else if (en_i) begin
      patches_rows_re_s8_sim <= patches_rows_re;
      patches_rows_raddr_s8_sim <= patches_rows_raddr;
      patches_rows_re_s9_sim <= patches_rows_re_s8_sim;
      patches_rows_raddr_s9_sim <= patches_rows_raddr_s8_sim;
      patches_rows_re_s10_sim <= patches_rows_re_s9_sim;
      patches_rows_raddr_s10_sim <= patches_rows_raddr_s9_sim;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s8_sim && patches_rows_raddr_s8_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s9_sim && patches_rows_raddr_s9_sim == patches_rows_waddr) begin
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
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s22_en) begin
      sharpness_comparing_less_detail_0_q <= select_2448;
      sharpness_comparing_less_detail_1_q <= select_2454;
      hidden_for_q <= select_3963;
      too_much_q <= equal_573_s22_q ? select_3998 : too_much_q;
      overlooks_q <= equal_573_s22_q ? select_4004 : overlooks_q;
      seen_q <= select_4125;
      nearer_q <= select_4128;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic patches_round_ends_s23_q;
  logic [7:0] patches_on_skin_s23_q;
  logic equal_573_s23_q;
  logic [7:0] product_3839_s23_q;
  logic equal_3943_s23_q;
  logic and_4105_s23_q;
  logic and_4138_s23_q;
  logic and_4141_s23_q;
  logic and_4147_s23_q;
  logic and_4151_s23_q;
  logic and_4156_s23_q;
  logic and_4160_s23_q;
  logic not_4165_s23_q;
  logic or_4171_s23_q;
  logic and_4177_s23_q;
  logic and_4181_s23_q;
  logic [5:0] select_4183_s23_q;
  logic [31:0] select_4200_s23_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      patches_round_ends_s23_q <= patches_round_ends_s22_q;
      patches_on_skin_s23_q <= patches_on_skin_s22_q;
      equal_573_s23_q <= equal_573_s22_q;
      product_3839_s23_q <= product_3839[12:5];
      equal_3943_s23_q <= equal_3943_s22_q;
      and_4105_s23_q <= and_4105_s22_q;
      and_4138_s23_q <= and_4138_s22_q;
      and_4141_s23_q <= and_4141;
      and_4147_s23_q <= equal_573_s22_q & and_4146;
      and_4151_s23_q <= and_4151_s22_q;
      and_4156_s23_q <= equal_3943_s22_q & (not_4143 & (select_2448 | or_4153_s22_q));
      and_4160_s23_q <= and_4160;
      not_4165_s23_q <= ~(select_3961 < cfg_hidden_frames_i);
      or_4171_s23_q <= not_2350 | (select_4004 & not_3836);
      and_4177_s23_q <= and_4177_s22_q;
      and_4181_s23_q <= and_4181_s22_q;
      select_4183_s23_q <= select_4183_s22_q;
      select_4200_s23_q <= select_4200_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:189
  logic and_3841;
  assign and_3841 = (~(patches_on_skin_s23_q[7:2] == 6'h0)) & (product_3839_s23_q < patches_on_skin_s23_q);
  logic select_3846;
  assign select_3846 = patches_round_ends_s23_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:635
  logic or_3850;
  assign or_3850 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s23_q));
  // hls/stages/agreement.hpp:1150
  logic and_4167;
  assign and_4167 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4165_s23_q);
  // hls/stages/agreement.hpp:788
  logic and_4173;
  assign and_4173 = equal_3943_s23_q & (or_4171_s23_q ? cfg_prove_i : patches_overlooked_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s23_en) begin
      patches_large_q <= not_3836 & and_3841;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3846;
      patches_spoiled_q <= or_3850;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic and_4105_s24_q;
  logic or_4129_s24_q;
  logic and_4130_s24_q;
  logic and_4138_s24_q;
  logic and_4141_s24_q;
  logic and_4147_s24_q;
  logic and_4151_s24_q;
  logic and_4157_s24_q;
  logic and_4161_s24_q;
  logic and_4169_s24_q;
  logic and_4174_s24_q;
  logic and_4177_s24_q;
  logic and_4181_s24_q;
  logic [5:0] select_4183_s24_q;
  logic [31:0] select_4200_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      and_4105_s24_q <= and_4105_s23_q;
      or_4129_s24_q <= not_2350 | seen_q;
      and_4130_s24_q <= cfg_prove_i & nearer_q;
      and_4138_s24_q <= and_4138_s23_q;
      and_4141_s24_q <= and_4141_s23_q;
      and_4147_s24_q <= and_4147_s23_q;
      and_4151_s24_q <= and_4151_s23_q;
      and_4157_s24_q <= equal_573_s23_q & and_4156_s23_q;
      and_4161_s24_q <= equal_573_s23_q & and_4160_s23_q;
      and_4169_s24_q <= equal_573_s23_q & (equal_3943_s23_q & and_4167);
      and_4174_s24_q <= equal_573_s23_q & and_4173;
      and_4177_s24_q <= and_4177_s23_q;
      and_4181_s24_q <= and_4181_s23_q;
      select_4183_s24_q <= select_4183_s23_q;
      select_4200_s24_q <= select_4200_s23_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s24_q;
  assign pixel_1_o = pixel_1_s24_q;
  assign saturated_o = saturated_s24_q;
  assign mask_o = mask_s24_q;
  assign marks_first_o = marks_first_s24_q;
  assign marks_last_o = marks_last_s24_q;
  assign marks_seen_o = or_4129_s24_q;
  assign marks_nearer_o = and_4130_s24_q;
  assign verdict_valid_o = and_4105_s24_q;
  assign verdict_unproven_yet_o = and_4138_s24_q;
  assign verdict_untextured_o = and_4141_s24_q;
  assign verdict_disagree_o = and_4147_s24_q;
  assign verdict_moved_o = and_4151_s24_q;
  assign verdict_unsharp_left_o = and_4157_s24_q;
  assign verdict_unsharp_right_o = and_4161_s24_q;
  assign verdict_hidden_o = and_4169_s24_q;
  assign verdict_overlooked_o = and_4174_s24_q;
  assign verdict_out_of_step_o = and_4177_s24_q;
  assign frame_valid_o = and_4181_s24_q;
  assign frame_index_o = select_4183_s24_q;
  assign frame_word_o = select_4200_s24_q;
  assign valid_o = valid_s24_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], product_3839[4:0], sum_3805[1:0], sum_3760[1:0], product_3651[4:0], sum_2744[0], difference_2685[1:0], detail_4[1:0], detail_3[1:0], sum_2283[4:0], sum_1764[1:0], sum_1763[1:0], sum_1759[0], sum_1708[0], sum_1704[0], sum_730[4:0], cfg_width_i[3:0]};

endmodule
