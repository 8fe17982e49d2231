// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 24 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3133 bits, pipeline 8697 bits, memories 157167 bits.
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
  logic s0_en, s1_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en;
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

  // Of the configuration alone: not pipelined.
  logic not_2363;
  assign not_2363 = ~cfg_prove_i;
  logic [6:0] sum_2576;
  assign sum_2576 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic less_2581;
  assign less_2581 = 7'h8 < cfg_height_i[10:4];
  logic [6:0] difference_3615;
  assign difference_3615 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3808;
  assign not_3808 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3845;
  assign difference_3845 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic [5:0] sum_4086;
  assign sum_4086 = {1'b0, cfg_height_i[10:6]} + 6'h3f;
  logic [7:0] select_4087;
  assign select_4087 = (7'h4 < cfg_height_i[10:4]) ? {sum_4086, cfg_height_i[5:4]} : 8'h0;

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
  logic [3:0] select_511;
  assign select_511 = sample_pair_first_q ? 4'h0 : raster_at_x_q;
  // hls/stages/census.hpp:114
  logic equal_512;
  assign equal_512 = select_511[1:0] == 2'h0;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [8:0] select_516;
  assign select_516 = equal_512 ? (row_starts ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/census.hpp:42
  logic [3:0] select_530;
  assign select_530 = sample_pair_first_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2153;
  assign select_2153 = sample_pair_whole_q ? (sample_last_q ? 4'h0 : (select_511 + 4'h1)) : raster_at_x_q;
  logic [3:0] select_2156;
  assign select_2156 = sample_pair_whole_q ? (sample_last_q ? (select_530 + 4'h1) : select_530) : raster_at_y_q;

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
      raster_at_x_q <= select_2153;
      raster_at_y_q <= select_2156;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      averager_place_q <= sample_pair_whole_q ? select_516 : averager_place_q;
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
  logic [3:0] select_511_s1_q;
  logic equal_512_s1_q;
  logic row_starts_s1_q;
  logic [8:0] select_516_s1_q;
  logic not_518_s1_q;
  logic [3:0] select_530_s1_q;
  logic equal_549_s1_q;
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
      select_511_s1_q <= select_511;
      equal_512_s1_q <= equal_512;
      row_starts_s1_q <= row_starts;
      select_516_s1_q <= select_516;
      not_518_s1_q <= ~(averager_place_q == 9'h1df);
      select_530_s1_q <= select_530;
      equal_549_s1_q <= select_530 == 4'hf;
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
  logic select_521;
  assign select_521 = equal_512_s1_q ? (row_starts_s1_q | (averager_inside_q & not_518_s1_q)) : averager_inside_q;
  // hls/stages/census.hpp:42
  logic or_522;
  assign or_522 = sample_pair_first_s1_q | raster_at_live_q;
  // hls/stages/agreement.hpp:423
  logic and_525;
  assign and_525 = select_521 & (or_522 & (select_511_s1_q[1:0] == 2'h3));
  // hls/stages/census.hpp:42
  logic [6:0] select_546;
  assign select_546 = sample_pair_first_s1_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:277
  logic [6:0] last;
  assign last = sample_pair_whole_s1_q ? select_546 : 7'h0;
  // hls/stages/census.hpp:53
  logic equal_548;
  assign equal_548 = select_511_s1_q == 4'hf;
  // hls/stages/census.hpp:134
  logic and_550;
  assign and_550 = equal_549_s1_q & and_525;
  // hls/stages/census.hpp:42
  logic [6:0] select_684;
  assign select_684 = sample_pair_first_s1_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
  logic [6:0] row;
  assign row = sample_pair_whole_s1_q ? select_684 : 7'h0;
  logic [6:0] select_2159;
  assign select_2159 = sample_pair_whole_s1_q ? (sample_last_s1_q ? 7'h0 : (select_546 + {6'h0, equal_548})) : raster_at_column_q;
  // hls/stages/census.hpp:62
  logic [6:0] select_2161;
  assign select_2161 = sample_last_s1_q ? (select_684 + {6'h0, equal_549_s1_q}) : select_684;
  // hls/stages/agreement.hpp:277
  logic select_2166;
  assign select_2166 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_522 & (~raster_final_row_q)) : or_522) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [10:0] select_2168;
  assign select_2168 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:277
  logic select_2172;
  assign select_2172 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_inside_q <= 1'b1;
    end else if (s1_en) begin
      raster_at_column_q <= select_2159;
      raster_at_row_q <= sample_pair_whole_s1_q ? select_2161 : raster_at_row_q;
      raster_at_live_q <= select_2166;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_2168 : raster_rows_left_q;
      raster_final_row_q <= select_2172;
      averager_inside_q <= sample_pair_whole_s1_q ? select_521 : averager_inside_q;
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
  logic [3:0] select_511_s2_q;
  logic equal_512_s2_q;
  logic row_starts_s2_q;
  logic [8:0] select_516_s2_q;
  logic and_525_s2_q;
  logic [3:0] select_530_s2_q;
  logic [6:0] select_546_s2_q;
  logic [6:0] last_s2_q;
  logic and_550_s2_q;
  logic and_552_s2_q;
  logic [6:0] select_684_s2_q;
  logic [6:0] row_s2_q;
  logic equal_1686_s2_q;
  logic [7:0] sum_2481_s2_q;
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
      select_511_s2_q <= select_511_s1_q;
      equal_512_s2_q <= equal_512_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_516_s2_q <= select_516_s1_q;
      and_525_s2_q <= and_525;
      select_530_s2_q <= select_530_s1_q;
      select_546_s2_q <= select_546;
      last_s2_q <= last;
      and_550_s2_q <= and_550;
      and_552_s2_q <= sample_pair_whole_s1_q & (equal_548 & and_550);
      select_684_s2_q <= select_684;
      row_s2_q <= row;
      equal_1686_s2_q <= {or_522, select_530_s1_q} == 5'h18;
      sum_2481_s2_q <= {1'b0, last} + 8'h1;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:464
  logic equal_2482;
  assign equal_2482 = {sum_2481_s2_q[7], cfg_width_i[10:4]} == {1'b0, sum_2481_s2_q[6:0]};
  // hls/stages/agreement.hpp:484
  logic [7:0] sum_2572;
  assign sum_2572 = {1'b0, row_s2_q} + 8'h1;
  // hls/stages/patches.hpp:375
  logic [7:0] sum_3029;
  assign sum_3029 = {1'b0, select_684_s2_q} + 8'h1;

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic [3:0] select_511_s3_q;
  logic equal_512_s3_q;
  logic row_starts_s3_q;
  logic [8:0] select_516_s3_q;
  logic and_525_s3_q;
  logic equal_531_s3_q;
  logic [6:0] select_546_s3_q;
  logic [6:0] last_s3_q;
  logic and_550_s3_q;
  logic and_552_s3_q;
  logic [6:0] row_s3_q;
  logic equal_1686_s3_q;
  logic equal_2482_s3_q;
  logic and_2483_s3_q;
  logic equal_2573_s3_q;
  logic not_3031_s3_q;
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
      select_511_s3_q <= select_511_s2_q;
      equal_512_s3_q <= equal_512_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_516_s3_q <= select_516_s2_q;
      and_525_s3_q <= and_525_s2_q;
      equal_531_s3_q <= select_530_s2_q == 4'h0;
      select_546_s3_q <= select_546_s2_q;
      last_s3_q <= last_s2_q;
      and_550_s3_q <= and_550_s2_q;
      and_552_s3_q <= and_552_s2_q;
      row_s3_q <= row_s2_q;
      equal_1686_s3_q <= equal_1686_s2_q;
      equal_2482_s3_q <= equal_2482;
      and_2483_s3_q <= and_552_s2_q & equal_2482;
      equal_2573_s3_q <= {sum_2572[7], cfg_height_i[10:4]} == {1'b0, sum_2572[6:0]};
      not_3031_s3_q <= ~({sum_3029, select_530_s2_q, 1'b0} < {2'h0, cfg_height_i});
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
  logic [3:0] patches_phase_q;
  // hls/stages/agreement.hpp:197
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:633
  logic equal_581;
  assign equal_581 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:624
  logic equal_596;
  assign equal_596 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:625
  logic equal_597;
  assign equal_597 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:533
  logic select_2486;
  assign select_2486 = (and_2483_s3_q | (~ends_cell_q)) ? and_2483_s3_q : ends_q;
  // hls/stages/agreement.hpp:539
  logic [2:0] now;
  assign now = select_2486 ? (and_2483_s3_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:544
  logic [5:0] select_2490;
  assign select_2490 = select_2486 ? (and_2483_s3_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2493;
  assign select_2493 = select_2486 ? (following_last_shift_q & (~and_2483_s3_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:545
  logic [7:0] select_2495;
  assign select_2495 = select_2486 ? (and_2483_s3_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:617
  logic and_2496;
  assign and_2496 = run_last_shift_q & equal_596;
  // hls/stages/agreement.hpp:626
  logic select_2498;
  assign select_2498 = equal_596 ? (~run_last_shift_q) : equal_597;
  // hls/stages/agreement.hpp:630
  logic equal_2499;
  assign equal_2499 = run_phase_q == 3'h1;
  logic not_2502;
  assign not_2502 = ~select_2498;
  // hls/stages/agreement.hpp:633
  logic equal_2504;
  assign equal_2504 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:617
  logic and_2505;
  assign and_2505 = final_row_q & so;
  // hls/stages/agreement.hpp:630
  logic [1:0] select_2506;
  assign select_2506 = equal_2504 ? 2'h1 : {2{and_2505}};
  logic [2:0] select_2508;
  assign select_2508 = (and_2496 | (select_2498 | equal_2499)) ? (equal_2499 ? 3'h2 : {not_2502, {2{select_2498}}}) : (equal_581 ? 3'h6 : {select_2506[0], select_2506});
  // hls/stages/agreement.hpp:617
  logic and_2511;
  assign and_2511 = select_2498 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:640
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2514;
  assign select_2514 = (plan_shift_q[5] & select_2498) ? value : 7'h0;
  logic [1:0] or_2515;
  assign or_2515 = {2{so}} | select_2514[5:4];
  // hls/stages/agreement.hpp:643
  logic [7:0] or_2519;
  assign or_2519 = (select_2498 ? plan_columns_q : 8'h0) | ((equal_2499 | equal_2504) ? whole_q : 8'h0);
  logic [1:0] or_2520;
  assign or_2520 = {2{and_2496}} | or_2519[4:3];
  // hls/stages/agreement.hpp:644
  logic [7:0] or_2522;
  assign or_2522 = {or_2519[7:5], or_2520, or_2519[2:0]} | (equal_581 ? drawn_q : 8'h0);
  logic [4:0] or_2523;
  assign or_2523 = {5{so}} | {or_2522[6], or_2522[3:0]};
  // hls/stages/agreement.hpp:650
  logic not_2527;
  assign not_2527 = ~run_shift_q[5];
  logic [7:0] select_2530;
  assign select_2530 = equal_596 ? ({{7{not_2527}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:533
  logic [6:0] select_2534;
  assign select_2534 = and_2483_s3_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:536
  logic [7:0] select_2536;
  assign select_2536 = select_2486 ? {select_2534[6], select_2534} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2539;
  assign select_2539 = select_2486 ? (and_2483_s3_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:465
  logic [6:0] select_2546;
  assign select_2546 = equal_2482_s3_q ? ((6'he < last_s3_q[6:1]) ? 7'h1d : last_s3_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [4:0] sum_2548;
  assign sum_2548 = {1'b0, last_s3_q[6:3]} + 5'h3;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_2550;
  assign select_2550 = and_552_s3_q ? (equal_2482_s3_q ? {sum_2548, last_s3_q[2:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [5:0] sum_2551;
  assign sum_2551 = {1'b0, last_s3_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_2553;
  assign select_2553 = and_552_s3_q ? (equal_2482_s3_q ? {sum_2551, last_s3_q[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:541
  logic select_2567;
  assign select_2567 = (ends_cell_q | select_2486) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_596 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:536
  logic and_2571;
  assign and_2571 = (~select_2486) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:530
  logic select_2575;
  assign select_2575 = and_552_s3_q ? (equal_2482_s3_q ? equal_2573_s3_q : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2966;
  assign select_2966 = row_starts_s3_q ? (sample_pair_first_s3_q ? phase : patches_phase_q) : patches_phase_q;

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
    end else if (s3_en) begin
      run_phase_q <= now;
      run_shift_q <= select_2490;
      run_last_shift_q <= select_2493;
      run_span_q <= select_2495;
      following_phase_q <= select_2508;
      following_shift_q <= select_2498 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2511;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2514[6], or_2515, select_2514[3:0]};
      following_columns_q <= {or_2522[7], or_2523[4], or_2522[5:4], or_2523[3:0]};
      plan_shift_q <= equal_596 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2530;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2536;
      columns_left_q <= select_2539;
      last_q <= and_552_s3_q ? (equal_2482_s3_q ? last_s3_q : last_q) : last_q;
      least_q <= and_552_s3_q ? select_2546 : least_q;
      whole_q <= select_2550;
      drawn_q <= select_2553;
      slot_q <= select_2486 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2567;
      ends_q <= and_2571;
      final_row_q <= select_2575;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= sample_pair_whole_s3_q ? select_2966 : patches_phase_q;
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
  logic [3:0] select_511_s4_q;
  logic equal_512_s4_q;
  logic row_starts_s4_q;
  logic [8:0] select_516_s4_q;
  logic and_525_s4_q;
  logic equal_531_s4_q;
  logic [6:0] select_546_s4_q;
  logic [6:0] last_s4_2_q;
  logic and_550_s4_q;
  logic and_552_s4_q;
  logic equal_577_s4_q;
  logic so_s4_q;
  logic equal_581_s4_q;
  logic [7:0] sum_583_s4_q;
  logic equal_596_s4_q;
  logic equal_597_s4_q;
  logic [7:0] sum_613_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1686_s4_q;
  logic equal_2482_s4_q;
  logic and_2483_s4_q;
  logic select_2486_s4_q;
  logic [3:0] phase_s4_q;
  logic not_3031_s4_q;
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
      select_511_s4_q <= select_511_s3_q;
      equal_512_s4_q <= equal_512_s3_q;
      row_starts_s4_q <= row_starts_s3_q;
      select_516_s4_q <= select_516_s3_q;
      and_525_s4_q <= and_525_s3_q;
      equal_531_s4_q <= equal_531_s3_q;
      select_546_s4_q <= select_546_s3_q;
      last_s4_2_q <= last_s3_q;
      and_550_s4_q <= and_550_s3_q;
      and_552_s4_q <= and_552_s3_q;
      equal_577_s4_q <= run_phase_q == 3'h7;
      so_s4_q <= so;
      equal_581_s4_q <= equal_581;
      sum_583_s4_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      equal_596_s4_q <= equal_596;
      equal_597_s4_q <= equal_597;
      sum_613_s4_q <= {1'b0, last_q} + 8'h3;
      row_s4_q <= row_s3_q;
      equal_1686_s4_q <= equal_1686_s3_q;
      equal_2482_s4_q <= equal_2482_s3_q;
      and_2483_s4_q <= and_2483_s3_q;
      select_2486_s4_q <= select_2486;
      phase_s4_q <= phase;
      not_3031_s4_q <= not_3031_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:604
  logic [7:0] select_584;
  assign select_584 = run_shift_s4_q[5] ? x_s4_q : sum_583_s4_q;
  logic less_585;
  assign less_585 = {1'b0, last_s4_q} < select_584;
  // hls/stages/agreement.hpp:227
  logic not_586;
  assign not_586 = ~less_585;
  // hls/stages/agreement.hpp:808
  logic [7:0] x;
  assign x = x_s4_q + 8'hfd;
  // hls/stages/agreement.hpp:538
  logic [6:0] select_2555;
  assign select_2555 = select_2486_s4_q ? 7'h0 : (ends_cell_s4_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s4_en) begin
      age_q <= select_2555;
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
  logic [3:0] select_511_s5_q;
  logic equal_512_s5_q;
  logic row_starts_s5_q;
  logic [8:0] select_516_s5_q;
  logic and_525_s5_q;
  logic equal_531_s5_q;
  logic [6:0] select_546_s5_q;
  logic [6:0] last_s5_2_q;
  logic and_550_s5_q;
  logic and_552_s5_q;
  logic equal_577_s5_q;
  logic so_s5_q;
  logic equal_581_s5_q;
  logic [6:0] sum_583_s5_q;
  logic less_585_s5_q;
  logic not_586_s5_q;
  logic equal_596_s5_q;
  logic and_598_s5_q;
  logic [6:0] x_s5_2_q;
  logic and_617_s5_q;
  logic [6:0] row_s5_q;
  logic equal_1570_s5_q;
  logic equal_1686_s5_q;
  logic equal_2482_s5_q;
  logic and_2483_s5_q;
  logic [3:0] phase_s5_q;
  logic equal_2986_s5_q;
  logic [3:0] select_2989_s5_q;
  logic not_3031_s5_q;
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
      select_511_s5_q <= select_511_s4_q;
      equal_512_s5_q <= equal_512_s4_q;
      row_starts_s5_q <= row_starts_s4_q;
      select_516_s5_q <= select_516_s4_q;
      and_525_s5_q <= and_525_s4_q;
      equal_531_s5_q <= equal_531_s4_q;
      select_546_s5_q <= select_546_s4_q;
      last_s5_2_q <= last_s4_2_q;
      and_550_s5_q <= and_550_s4_q;
      and_552_s5_q <= and_552_s4_q;
      equal_577_s5_q <= equal_577_s4_q;
      so_s5_q <= so_s4_q;
      equal_581_s5_q <= equal_581_s4_q;
      sum_583_s5_q <= sum_583_s4_q[6:0];
      less_585_s5_q <= less_585;
      not_586_s5_q <= not_586;
      equal_596_s5_q <= equal_596_s4_q;
      and_598_s5_q <= equal_597_s4_q & not_586;
      x_s5_2_q <= x[6:0];
      and_617_s5_q <= age_q[2] & (ends_cell_s4_q & (~(sum_613_s4_q < select_584)));
      row_s5_q <= row_s4_q;
      equal_1570_s5_q <= {x[7], last_s4_q} == {1'b0, x[6:0]};
      equal_1686_s5_q <= equal_1686_s4_q;
      equal_2482_s5_q <= equal_2482_s4_q;
      and_2483_s5_q <= and_2483_s4_q;
      phase_s5_q <= phase_s4_q;
      equal_2986_s5_q <= row_s4_q == 7'h3;
      select_2989_s5_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_3031_s5_q <= not_3031_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:604
  logic or_582;
  assign or_582 = so_s5_q | equal_581_s5_q;
  // hls/stages/agreement.hpp:150
  logic select_600;
  assign select_600 = or_582 ? not_586_s5_q : (equal_596_s5_q ? not_586_s5_q : and_598_s5_q);
  logic and_618;
  assign and_618 = equal_596_s5_q & and_617_s5_q;
  logic select_619;
  assign select_619 = or_582 ? not_586_s5_q : and_618;
  // hls/stages/agreement.hpp:831
  logic [6:0] right;
  assign right = sum_583_s5_q + 7'h7d;
  // hls/stages/agreement.hpp:150
  logic [6:0] select_647;
  assign select_647 = or_582 ? x_s5_q[6:0] : (equal_596_s5_q ? sum_583_s5_q : x_s5_q[6:0]);
  // hls/stages/agreement.hpp:730
  logic not_654;
  assign not_654 = ~or_582;
  // hls/stages/agreement.hpp:473
  logic equal_2587;
  assign equal_2587 = row_s5_q[6:2] == 5'h0;
  // hls/stages/agreement.hpp:530
  logic and_2856;
  assign and_2856 = and_552_s5_q & (equal_2482_s5_q & equal_2587);
  // hls/stages/registration.hpp:127
  logic and_2859;
  assign and_2859 = and_2483_s5_q & (~and_2856);
  // hls/stages/patches.hpp:87
  logic [3:0] select_2990;
  assign select_2990 = equal_2986_s5_q ? select_2989_s5_q : patches_choosing_rows_to_next_q;
  logic equal_2991;
  assign equal_2991 = select_2990 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_2994;
  assign select_2994 = equal_2482_s5_q ? (equal_2991 ? 4'h2 : (select_2990 + 4'hf)) : patches_choosing_rows_to_next_q;

  // Memory left, 120 x 85, DISTANCE 24, hls/stages/agreement.hpp:1390; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
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
  assign left_re = s5_en & select_600;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 99, DISTANCE 24, hls/stages/agreement.hpp:1391; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [98:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_647;
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s5_en & select_600;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1392; read in stage 5, written in stage 16: 5 < 16 < 5 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [61:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 62'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_582 ? x_s5_q[6:0] : x_s5_2_q;
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s5_en & select_619;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s5_en) begin
      patches_choosing_rows_to_next_q <= and_552_s5_q ? select_2994 : patches_choosing_rows_to_next_q;
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
  logic [3:0] patches_choosing_rows_to_next_s6_q;
  logic [3:0] select_511_s6_q;
  logic equal_512_s6_q;
  logic row_starts_s6_q;
  logic [8:0] select_516_s6_q;
  logic and_525_s6_q;
  logic equal_531_s6_q;
  logic [6:0] select_546_s6_q;
  logic [6:0] last_s6_2_q;
  logic and_550_s6_q;
  logic and_552_s6_q;
  logic equal_577_s6_q;
  logic so_s6_q;
  logic equal_581_s6_q;
  logic or_582_s6_q;
  logic less_585_s6_q;
  logic not_586_s6_q;
  logic equal_596_s6_q;
  logic [6:0] x_s6_2_q;
  logic select_619_s6_q;
  logic [6:0] right_s6_q;
  logic and_657_s6_q;
  logic [6:0] row_s6_q;
  logic and_1569_s6_q;
  logic equal_1570_s6_q;
  logic equal_1686_s6_q;
  logic equal_2482_s6_q;
  logic equal_2587_s6_q;
  logic and_2857_s6_q;
  logic [15:0] select_2860_s6_q;
  logic [15:0] select_2863_s6_q;
  logic and_2866_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2986_s6_q;
  logic equal_2991_s6_q;
  logic not_3031_s6_q;
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
      patches_choosing_rows_to_next_s6_q <= patches_choosing_rows_to_next_q;
      select_511_s6_q <= select_511_s5_q;
      equal_512_s6_q <= equal_512_s5_q;
      row_starts_s6_q <= row_starts_s5_q;
      select_516_s6_q <= select_516_s5_q;
      and_525_s6_q <= and_525_s5_q;
      equal_531_s6_q <= equal_531_s5_q;
      select_546_s6_q <= select_546_s5_q;
      last_s6_2_q <= last_s5_2_q;
      and_550_s6_q <= and_550_s5_q;
      and_552_s6_q <= and_552_s5_q;
      equal_577_s6_q <= equal_577_s5_q;
      so_s6_q <= so_s5_q;
      equal_581_s6_q <= equal_581_s5_q;
      or_582_s6_q <= or_582;
      less_585_s6_q <= less_585_s5_q;
      not_586_s6_q <= not_586_s5_q;
      equal_596_s6_q <= equal_596_s5_q;
      x_s6_2_q <= x_s5_2_q;
      select_619_s6_q <= select_619;
      right_s6_q <= right;
      and_657_s6_q <= not_654 & ((~equal_596_s5_q) & and_598_s5_q);
      row_s6_q <= row_s5_q;
      and_1569_s6_q <= not_654 & and_618;
      equal_1570_s6_q <= equal_1570_s5_q;
      equal_1686_s6_q <= equal_1686_s5_q;
      equal_2482_s6_q <= equal_2482_s5_q;
      equal_2587_s6_q <= equal_2587;
      and_2857_s6_q <= and_2483_s5_q & and_2856;
      select_2860_s6_q <= and_2859 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
      select_2863_s6_q <= and_2859 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
      and_2866_s6_q <= ends_cell_s5_q & so_s5_q;
      phase_s6_q <= phase_s5_q;
      equal_2986_s6_q <= equal_2986_s5_q;
      equal_2991_s6_q <= equal_2991;
      not_3031_s6_q <= not_3031_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:33
  logic not_1684;
  assign not_1684 = ~sample_pair_first_s6_q;
  // hls/stages/patches.hpp:315
  logic equal_1688;
  assign equal_1688 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1760;
  assign select_1760 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1997;
  assign sum_1997 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [23:0] sum_2861;
  assign sum_2861 = registration_slope_row_q + {{8{select_2860_s6_q[15]}}, select_2860_s6_q};
  // hls/stages/registration.hpp:132
  logic [23:0] select_2862;
  assign select_2862 = and_2857_s6_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : sum_2861;
  // hls/stages/registration.hpp:130
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2863_s6_q[15]}}, select_2863_s6_q};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2865;
  assign select_2865 = and_2857_s6_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2866_s6_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:377
  logic and_2968;
  assign and_2968 = not_1684 & equal_1686_s6_q;
  logic [8:0] select_2969;
  assign select_2969 = and_2968 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s6_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2970;
  assign select_2970 = and_2968 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2971;
  assign select_2971 = sample_pair_first_s6_q ? select_2969 : select_2970;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2972;
  assign select_2972 = row_starts_s6_q ? select_2971[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2973;
  assign select_2973 = sample_pair_whole_s6_q ? select_2972 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2975;
  assign select_2975 = sample_pair_whole_s6_q ? (row_starts_s6_q ? select_2971[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2978;
  assign select_2978 = sample_pair_whole_s6_q ? (equal_1688 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2980;
  assign select_2980 = sample_pair_whole_s6_q ? (patches_band_rows_number_q + {4'h0, equal_1688}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_2981;
  assign equal_2981 = phase_s6_q == 4'h0;
  // hls/stages/patches.hpp:335
  logic not_2982;
  assign not_2982 = ~equal_2981;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2984;
  assign select_2984 = sample_pair_whole_s6_q ? (phase_s6_q + {{2{not_2982}}, 1'b1, not_2982}) : patches_first_band_rows_to_next_q;
  logic select_2985;
  assign select_2985 = sample_pair_whole_s6_q ? equal_2981 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2996;
  assign select_2996 = equal_2986_s6_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_2998;
  assign select_2998 = equal_2482_s6_q ? (select_2996 + {4'h0, equal_2991_s6_q}) : patches_choosing_number_q;
  logic select_3002;
  assign select_3002 = equal_2482_s6_q ? ((7'h2 < row_s6_q) & equal_2991_s6_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:530
  logic [4:0] select_3005;
  assign select_3005 = and_552_s6_q ? (equal_2482_s6_q ? select_2996 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_3858;
  assign select_3858 = so_s6_q ? (and_2866_s6_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3860;
  assign sum_3860 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3861;
  assign select_3861 = sum_1997[5] ? {1'b1, sum_1997[4:0], region_across_rest_q[2:0]} : sum_3860;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3863;
  assign select_3863 = equal_2482_s6_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3866;
  assign select_3866 = equal_2482_s6_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1389; read in stage 6, written in stage 21: 6 < 21 < 6 + DISTANCE.
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
  assign fresh_re = s6_en & and_657_s6_q;
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
    end else if (s6_en) begin
      registration_slope_row_q <= select_2862;
      registration_slope_change_q <= select_2865;
      registration_slope_q <= so_s6_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2973;
      patches_band_rows_number_q <= select_2975;
      patches_next_band_rows_to_next_q <= select_2978;
      patches_next_band_number_q <= select_2980;
      patches_first_band_rows_to_next_q <= select_2984;
      patches_first_band_number_q <= select_2985;
      patches_choosing_number_q <= and_552_s6_q ? select_2998 : patches_choosing_number_q;
      patches_chooses_q <= and_552_s6_q ? select_3002 : patches_chooses_q;
      patches_choosing_band_q <= select_3005;
      region_across_rest_q <= select_3858;
      region_across_back_q <= so_s6_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3861;
      columns_begin_rest_q <= and_552_s6_q ? select_3863 : columns_begin_rest_q;
      columns_begin_back_q <= and_552_s6_q ? select_3866 : columns_begin_back_q;
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
  logic [3:0] select_511_s7_q;
  logic equal_512_s7_q;
  logic row_starts_s7_q;
  logic [8:0] select_516_s7_q;
  logic and_525_s7_q;
  logic equal_531_s7_q;
  logic [6:0] select_546_s7_q;
  logic [6:0] last_s7_2_q;
  logic and_550_s7_q;
  logic and_552_s7_q;
  logic equal_577_s7_q;
  logic so_s7_q;
  logic equal_581_s7_q;
  logic or_582_s7_q;
  logic less_585_s7_q;
  logic not_586_s7_q;
  logic equal_596_s7_q;
  logic [84:0] left_rdata_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_619_s7_q;
  logic [61:0] best_left_rdata_s7_q;
  logic [6:0] right_s7_q;
  logic [98:0] right_codes_rdata_s7_q;
  logic and_657_s7_q;
  logic [6:0] row_s7_q;
  logic and_1569_s7_q;
  logic equal_1570_s7_q;
  logic not_1684_s7_q;
  logic or_1690_s7_q;
  logic [16:0] select_1760_s7_q;
  logic sum_1997_s7_q;
  logic equal_2482_s7_q;
  logic equal_2587_s7_q;
  logic not_3031_s7_q;
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
      patches_band_rows_number_s7_q <= patches_band_rows_number_q;
      patches_chooses_s7_q <= patches_chooses_q;
      patches_choosing_band_s7_q <= patches_choosing_band_q;
      select_511_s7_q <= select_511_s6_q;
      equal_512_s7_q <= equal_512_s6_q;
      row_starts_s7_q <= row_starts_s6_q;
      select_516_s7_q <= select_516_s6_q;
      and_525_s7_q <= and_525_s6_q;
      equal_531_s7_q <= equal_531_s6_q;
      select_546_s7_q <= select_546_s6_q;
      last_s7_2_q <= last_s6_2_q;
      and_550_s7_q <= and_550_s6_q;
      and_552_s7_q <= and_552_s6_q;
      equal_577_s7_q <= equal_577_s6_q;
      so_s7_q <= so_s6_q;
      equal_581_s7_q <= equal_581_s6_q;
      or_582_s7_q <= or_582_s6_q;
      less_585_s7_q <= less_585_s6_q;
      not_586_s7_q <= not_586_s6_q;
      equal_596_s7_q <= equal_596_s6_q;
      left_rdata_s7_q <= left_rdata_q;
      x_s7_2_q <= x_s6_2_q;
      select_619_s7_q <= select_619_s6_q;
      best_left_rdata_s7_q <= best_left_rdata_q;
      right_s7_q <= right_s6_q;
      right_codes_rdata_s7_q <= right_codes_rdata_q;
      and_657_s7_q <= and_657_s6_q;
      row_s7_q <= row_s6_q;
      and_1569_s7_q <= and_1569_s6_q;
      equal_1570_s7_q <= equal_1570_s6_q;
      not_1684_s7_q <= not_1684;
      or_1690_s7_q <= (~equal_1686_s6_q) | (~equal_1688);
      select_1760_s7_q <= select_1760;
      sum_1997_s7_q <= sum_1997[5];
      equal_2482_s7_q <= equal_2482_s6_q;
      equal_2587_s7_q <= equal_2587_s6_q;
      not_3031_s7_q <= not_3031_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic late_q;
  logic patches_capturing_q;
  logic [4:0] patches_row_q;
  logic [2:0] patches_work_q;
  logic patches_second_q;
  logic [2:0] patches_following_q;
  logic [4:0] patches_following_beats_q;
  logic patches_begins_q;
  logic patches_ends_q;
  logic [11:0] patches_remaining_q;
  logic done_q;
  logic proven_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:678
  logic equal_571;
  assign equal_571 = row_q == 7'h0;
  // hls/stages/agreement.hpp:985
  logic and_609;
  assign and_609 = (or_582_s7_q & (left_rdata_s7_q[67] & not_586_s7_q)) & (late_q | (~(row_q[6:3] == 4'h0)));
  // hls/stages/agreement.hpp:976
  logic [5:0] shift;
  assign shift = slot_s7_q[2] ? best_left_rdata_s7_q[5:0] : best_left_rdata_s7_q[45:40];
  // hls/stages/agreement.hpp:1014
  logic less_641;
  assign less_641 = 7'h2 < row_q;
  // hls/stages/agreement.hpp:1016
  logic and_651;
  assign and_651 = (or_582_s7_q & (right_codes_rdata_s7_q[58] & not_586_s7_q)) & less_641;
  // hls/stages/agreement.hpp:679
  logic or_755;
  assign or_755 = late_q | (~equal_571);
  // hls/stages/agreement.hpp:222
  logic and_770;
  assign and_770 = left_rdata_s7_q[48] & not_586_s7_q;
  logic and_771;
  assign and_771 = right_codes_rdata_s7_q[42] & not_586_s7_q;
  logic [11:0] select_772;
  assign select_772 = less_585_s7_q ? 12'h0 : left_rdata_s7_q[47:36];
  logic [11:0] select_773;
  assign select_773 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[41:30];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_777;
  assign select_777 = and_770 ? (and_771 ? (~(select_772 ^ select_773)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_793;
  assign and_793 = left_rdata_s7_q[66] & not_586_s7_q;
  logic and_794;
  assign and_794 = right_codes_rdata_s7_q[57] & not_586_s7_q;
  logic [11:0] select_795;
  assign select_795 = less_585_s7_q ? 12'h0 : left_rdata_s7_q[65:54];
  logic [11:0] select_796;
  assign select_796 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[56:45];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_800;
  assign select_800 = and_793 ? (and_794 ? (~(select_795 ^ select_796)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_810;
  assign and_810 = left_rdata_s7_q[84] & not_586_s7_q;
  logic and_811;
  assign and_811 = right_codes_rdata_s7_q[72] & not_586_s7_q;
  logic [11:0] select_812;
  assign select_812 = less_585_s7_q ? 12'h0 : left_rdata_s7_q[83:72];
  logic [11:0] select_813;
  assign select_813 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[71:60];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_817;
  assign select_817 = and_810 ? (and_811 ? (~(select_812 ^ select_813)) : 12'h0) : 12'h0;
  logic [11:0] select_1025;
  assign select_1025 = (slot_s7_q[0] ? and_811 : and_794) ? (~(select_772 ^ (slot_s7_q[0] ? select_813 : select_796))) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_1042;
  assign and_1042 = right_codes_rdata_s7_q[85] & not_586_s7_q;
  logic [11:0] select_1044;
  assign select_1044 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[84:73];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1048;
  assign select_1048 = (slot_s7_q[0] ? and_1042 : and_811) ? (~(select_795 ^ (slot_s7_q[0] ? select_1044 : select_813))) : 12'h0;
  // hls/stages/agreement.hpp:744
  logic select_1060;
  assign select_1060 = slot_s7_q[0] ? (right_codes_rdata_s7_q[98] & not_586_s7_q) : and_1042;
  logic [11:0] select_1062;
  assign select_1062 = slot_s7_q[0] ? (less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[97:86]) : select_1044;
  // hls/stages/agreement.hpp:222
  logic and_1271;
  assign and_1271 = right_codes_rdata_s7_q[27] & not_586_s7_q;
  // hls/stages/agreement.hpp:744
  logic select_1272;
  assign select_1272 = slot_s7_q[0] ? (right_codes_rdata_s7_q[12] & not_586_s7_q) : and_1271;
  // hls/stages/agreement.hpp:222
  logic [11:0] select_1274;
  assign select_1274 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[26:15];
  // hls/stages/agreement.hpp:744
  logic [11:0] select_1275;
  assign select_1275 = slot_s7_q[0] ? (less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[11:0]) : select_1274;
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1299;
  assign select_1299 = (slot_s7_q[0] ? and_1271 : and_771) ? (~(select_795 ^ (slot_s7_q[0] ? select_1274 : select_773))) : 12'h0;
  logic [11:0] select_1314;
  assign select_1314 = (slot_s7_q[0] ? and_771 : and_794) ? (~(select_812 ^ (slot_s7_q[0] ? select_773 : select_796))) : 12'h0;
  // hls/stages/patches.hpp:396
  logic not_1681;
  assign not_1681 = ~patches_begins_q;
  // hls/stages/patches.hpp:366
  logic and_1685;
  assign and_1685 = patches_capturing_q & not_1684_s7_q;
  // hls/stages/patches.hpp:125
  logic and_1693;
  assign and_1693 = (not_1681 & (patches_work_q == 3'h0)) & (~(and_1685 | or_1690_s7_q));
  // hls/stages/agreement.hpp:150
  logic [5:0] b;
  assign b = or_582_s7_q ? (less_585_s7_q ? 6'h0 : best_left_rdata_s7_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1762;
  assign select_1762 = ($signed(10'h0) < $signed(select_1760_s7_q[16:7])) ? 14'h7f : select_1760_s7_q[13:0];
  // hls/stages/patches.hpp:537
  logic equal_1792;
  assign equal_1792 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:509
  logic equal_1794;
  assign equal_1794 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:503
  logic equal_1796;
  assign equal_1796 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1797;
  assign equal_1797 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_1798;
  assign or_1798 = equal_1796 | equal_1797;
  // hls/stages/patches.hpp:464
  logic not_1799;
  assign not_1799 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_1821;
  assign select_1821 = and_1693 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1822;
  assign select_1822 = row_starts_s7_q ? select_1821 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1824;
  assign and_1824 = and_1685 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1828;
  assign select_1828 = row_starts_s7_q ? (and_1693 | (and_1685 & (~and_1824))) : patches_capturing_q;
  // hls/stages/patches.hpp:168
  logic not_1852;
  assign not_1852 = ~equal_1797;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_1866;
  assign select_1866 = row_starts_s7_q ? {select_1821[4], select_1821[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/agreement.hpp:1289
  logic not_2061;
  assign not_2061 = ~marks_first_s7_q;
  // hls/stages/agreement.hpp:472
  logic and_2582;
  assign and_2582 = proven_q & less_2581;
  // hls/stages/agreement.hpp:530
  logic select_2586;
  assign select_2586 = and_552_s7_q ? (equal_2482_s7_q ? (and_2582 & (row_s7_q[6:1] == 6'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:474
  logic and_2588;
  assign and_2588 = and_2582 & equal_2587_s7_q;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2757;
  assign select_2757 = or_582_s7_q ? (less_585_s7_q ? 8'h0 : best_left_rdata_s7_q[32:25]) : 8'h0;
  logic [7:0] select_2759;
  assign select_2759 = or_582_s7_q ? (less_585_s7_q ? 8'h0 : best_left_rdata_s7_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:397
  logic or_3072;
  assign or_3072 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3077;
  assign select_3077 = (patches_second_q | patches_begins_q) ? not_1681 : (patches_ends_q & equal_1792);
  logic and_3078;
  assign and_3078 = equal_1792 & not_1799;
  // hls/stages/patches.hpp:403
  logic and_3079;
  assign and_3079 = not_1852 & and_3078;
  logic [1:0] select_3081;
  assign select_3081 = equal_1794 ? 2'h0 : (equal_1796 ? 2'h3 : {equal_1797, and_3079});
  // hls/stages/patches.hpp:283
  logic equal_3083;
  assign equal_3083 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3084;
  assign not_3084 = ~equal_3083;
  // hls/stages/patches.hpp:283
  logic equal_3085;
  assign equal_3085 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3086;
  assign not_3086 = ~equal_3085;
  // hls/stages/patches.hpp:287
  logic not_3088;
  assign not_3088 = ~(patches_following_q == 3'h2);
  logic and_3091;
  assign and_3091 = (~(patches_following_q == 3'h1)) & not_3088;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3092;
  assign select_3092 = equal_3085 ? 2'h2 : {and_3091, not_3088};
  logic [3:0] select_3093;
  assign select_3093 = equal_3083 ? 4'h2 : {select_3092, {2{not_3086}}};
  // hls/stages/patches.hpp:409
  logic not_3096;
  assign not_3096 = ~or_3072;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3101;
  assign select_3101 = or_3072 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/agreement.hpp:1162
  logic equal_3916;
  assign equal_3916 = x_s7_q[6:0] == 7'h7f;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
      late_q <= 1'b0;
      patches_capturing_q <= 1'b0;
      patches_row_q <= 5'h0;
      patches_work_q <= 3'h0;
      patches_second_q <= 1'b0;
      patches_following_q <= 3'h0;
      patches_following_beats_q <= 5'h0;
      patches_begins_q <= 1'b0;
      patches_ends_q <= 1'b0;
      patches_remaining_q <= 12'h0;
      done_q <= 1'b0;
      proven_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s7_en) begin
      row_q <= and_552_s7_q ? (equal_2482_s7_q ? row_s7_q : row_q) : row_q;
      late_q <= select_2586;
      patches_capturing_q <= sample_pair_whole_s7_q ? select_1828 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s7_q ? select_1822 : patches_row_q;
      patches_work_q <= or_3072 ? following : patches_work_q;
      patches_second_q <= select_3077;
      patches_following_q <= equal_1792 ? {2'h0, and_3078} : {equal_1794, select_3081};
      patches_following_beats_q <= {select_3093, not_3084};
      patches_begins_q <= sample_pair_whole_s7_q & (row_starts_s7_q & and_1824);
      patches_ends_q <= not_3096 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3101;
      done_q <= not_2061 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s7_q ? done_q : proven_q;
      drew_q <= so_s7_q;
      said_q <= equal_577_s7_q & equal_3916;
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
  logic patches_second_s8_q;
  logic done_s8_q;
  logic [3:0] select_511_s8_q;
  logic equal_512_s8_q;
  logic row_starts_s8_q;
  logic [8:0] select_516_s8_q;
  logic and_525_s8_q;
  logic equal_531_s8_q;
  logic [6:0] select_546_s8_q;
  logic [6:0] last_s8_2_q;
  logic and_550_s8_q;
  logic and_552_s8_q;
  logic equal_571_s8_q;
  logic equal_577_s8_q;
  logic equal_581_s8_q;
  logic or_582_s8_q;
  logic less_585_s8_q;
  logic not_586_s8_q;
  logic equal_596_s8_q;
  logic [62:0] left_rdata_s8_q;
  logic and_610_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_619_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic [5:0] shift_s8_q;
  logic [6:0] right_s8_q;
  logic and_642_s8_q;
  logic and_645_s8_q;
  logic [77:0] right_codes_rdata_s8_q;
  logic and_651_s8_q;
  logic and_653_s8_q;
  logic and_657_s8_q;
  logic [32:0] fresh_rdata_s8_q;
  logic equal_686_s8_q;
  logic and_756_s8_q;
  logic and_757_s8_q;
  logic and_758_s8_q;
  logic and_759_s8_q;
  logic and_760_s8_q;
  logic and_761_s8_q;
  logic and_762_s8_q;
  logic and_763_s8_q;
  logic and_764_s8_q;
  logic and_765_s8_q;
  logic and_770_s8_q;
  logic [11:0] select_777_s8_q;
  logic and_793_s8_q;
  logic [11:0] select_800_s8_q;
  logic and_810_s8_q;
  logic [11:0] select_817_s8_q;
  logic [11:0] select_1025_s8_q;
  logic [11:0] select_1048_s8_q;
  logic [11:0] select_1065_s8_q;
  logic [11:0] select_1278_s8_q;
  logic [11:0] select_1299_s8_q;
  logic [11:0] select_1314_s8_q;
  logic and_1569_s8_q;
  logic equal_1570_s8_q;
  logic and_1693_s8_q;
  logic less_1707_s8_q;
  logic [5:0] b_s8_q;
  logic [13:0] select_1762_s8_q;
  logic equal_1792_s8_q;
  logic equal_1794_s8_q;
  logic equal_1796_s8_q;
  logic equal_1797_s8_q;
  logic or_1798_s8_q;
  logic not_1799_s8_q;
  logic and_1801_s8_q;
  logic [4:0] select_1822_s8_q;
  logic select_1828_s8_q;
  logic and_1834_s8_q;
  logic and_1853_s8_q;
  logic [3:0] select_1866_s8_q;
  logic sum_1997_s8_q;
  logic not_2007_s8_q;
  logic and_2021_s8_q;
  logic not_2061_s8_q;
  logic less_2139_s8_q;
  logic equal_2293_s8_q;
  logic equal_2482_s8_q;
  logic not_2578_s8_q;
  logic and_2588_s8_q;
  logic and_2618_s8_q;
  logic [7:0] select_2757_s8_q;
  logic [7:0] select_2759_s8_q;
  logic not_3031_s8_q;
  logic or_3072_s8_q;
  logic not_3096_s8_q;
  logic less_3844_s8_q;
  logic equal_3916_s8_q;
  logic or_4066_s8_q;
  logic not_4109_s8_q;
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
      patches_band_rows_number_s8_q <= patches_band_rows_number_s7_q;
      patches_chooses_s8_q <= patches_chooses_s7_q;
      patches_choosing_band_s8_q <= patches_choosing_band_s7_q;
      patches_second_s8_q <= patches_second_q;
      done_s8_q <= done_q;
      select_511_s8_q <= select_511_s7_q;
      equal_512_s8_q <= equal_512_s7_q;
      row_starts_s8_q <= row_starts_s7_q;
      select_516_s8_q <= select_516_s7_q;
      and_525_s8_q <= and_525_s7_q;
      equal_531_s8_q <= equal_531_s7_q;
      select_546_s8_q <= select_546_s7_q;
      last_s8_2_q <= last_s7_2_q;
      and_550_s8_q <= and_550_s7_q;
      and_552_s8_q <= and_552_s7_q;
      equal_571_s8_q <= equal_571;
      equal_577_s8_q <= equal_577_s7_q;
      equal_581_s8_q <= equal_581_s7_q;
      or_582_s8_q <= or_582_s7_q;
      less_585_s8_q <= less_585_s7_q;
      not_586_s8_q <= not_586_s7_q;
      equal_596_s8_q <= equal_596_s7_q;
      left_rdata_s8_q <= {left_rdata_s7_q[65:49], left_rdata_s7_q[47:31], left_rdata_s7_q[29:13], left_rdata_s7_q[11:0]};
      and_610_s8_q <= (or_582_s7_q & (left_rdata_s7_q[68] & not_586_s7_q)) & and_609;
      x_s8_2_q <= x_s7_2_q;
      select_619_s8_q <= select_619_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_s7_q;
      shift_s8_q <= shift;
      right_s8_q <= right_s7_q;
      and_642_s8_q <= (or_582_s7_q & (left_rdata_s7_q[70] & not_586_s7_q)) & less_641;
      and_645_s8_q <= or_582_s7_q & (left_rdata_s7_q[71] & not_586_s7_q);
      right_codes_rdata_s8_q <= {right_codes_rdata_s7_q[84:73], right_codes_rdata_s7_q[71:60], right_codes_rdata_s7_q[56:43], right_codes_rdata_s7_q[41:28], right_codes_rdata_s7_q[26:13], right_codes_rdata_s7_q[11:0]};
      and_651_s8_q <= and_651;
      and_653_s8_q <= or_582_s7_q & (right_codes_rdata_s7_q[59] & not_586_s7_q);
      and_657_s8_q <= and_657_s7_q;
      fresh_rdata_s8_q <= fresh_rdata_q;
      equal_686_s8_q <= row_s7_q == 7'h0;
      and_756_s8_q <= left_rdata_s7_q[12] & or_755;
      and_757_s8_q <= left_rdata_s7_q[30] & or_755;
      and_758_s8_q <= left_rdata_s7_q[48] & or_755;
      and_759_s8_q <= left_rdata_s7_q[66] & or_755;
      and_760_s8_q <= right_codes_rdata_s7_q[12] & or_755;
      and_761_s8_q <= right_codes_rdata_s7_q[27] & or_755;
      and_762_s8_q <= right_codes_rdata_s7_q[42] & or_755;
      and_763_s8_q <= right_codes_rdata_s7_q[57] & or_755;
      and_764_s8_q <= right_codes_rdata_s7_q[72] & or_755;
      and_765_s8_q <= right_codes_rdata_s7_q[85] & or_755;
      and_770_s8_q <= and_770;
      select_777_s8_q <= select_777;
      and_793_s8_q <= and_793;
      select_800_s8_q <= select_800;
      and_810_s8_q <= and_810;
      select_817_s8_q <= select_817;
      select_1025_s8_q <= select_1025;
      select_1048_s8_q <= select_1048;
      select_1065_s8_q <= select_1060 ? (~(select_812 ^ select_1062)) : 12'h0;
      select_1278_s8_q <= select_1272 ? (~(select_772 ^ select_1275)) : 12'h0;
      select_1299_s8_q <= select_1299;
      select_1314_s8_q <= select_1314;
      and_1569_s8_q <= and_1569_s7_q;
      equal_1570_s8_q <= equal_1570_s7_q;
      and_1693_s8_q <= and_1693;
      less_1707_s8_q <= 6'h4 < row_q[6:1];
      b_s8_q <= b;
      select_1762_s8_q <= select_1762;
      equal_1792_s8_q <= equal_1792;
      equal_1794_s8_q <= equal_1794;
      equal_1796_s8_q <= equal_1796;
      equal_1797_s8_q <= equal_1797;
      or_1798_s8_q <= or_1798;
      not_1799_s8_q <= not_1799;
      and_1801_s8_q <= or_1798 & (equal_1797 & not_1799);
      select_1822_s8_q <= select_1822;
      select_1828_s8_q <= select_1828;
      and_1834_s8_q <= or_1798 & (patches_second_q & equal_1797);
      and_1853_s8_q <= not_1852 & or_1798;
      select_1866_s8_q <= select_1866;
      sum_1997_s8_q <= sum_1997_s7_q;
      not_2007_s8_q <= ~late_q;
      and_2021_s8_q <= or_582_s7_q & (left_rdata_s7_q[69] & not_586_s7_q);
      not_2061_s8_q <= not_2061;
      less_2139_s8_q <= 7'h6 < row_q;
      equal_2293_s8_q <= (last_s7_2_q | row_s7_q) == 7'h0;
      equal_2482_s8_q <= equal_2482_s7_q;
      not_2578_s8_q <= ~({row_s7_q, 1'b0} < {sum_2576, cfg_height_i[4]});
      and_2588_s8_q <= and_2588;
      and_2618_s8_q <= not_586_s7_q & and_609;
      select_2757_s8_q <= select_2757;
      select_2759_s8_q <= select_2759;
      not_3031_s8_q <= not_3031_s7_q;
      or_3072_s8_q <= or_3072;
      not_3096_s8_q <= not_3096;
      less_3844_s8_q <= 6'h2 < row_s7_q[6:1];
      equal_3916_s8_q <= equal_3916;
      or_4066_s8_q <= and_2588 | (~(row_s7_q[6:3] == 4'h0));
      not_4109_s8_q <= ~proven_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic lower_half_q;
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  logic [6:0] patches_step_q;
  logic patches_read_searches_q;
  // hls/stages/agreement.hpp:977
  logic [7:0] found;
  assign found = x_s8_q + {{2{shift_s8_q[5]}}, shift_s8_q};
  // hls/stages/count_bits.hpp:24
  logic parity_783;
  assign parity_783 = ^select_777_s8_q[5:3];
  logic parity_786;
  assign parity_786 = ^select_777_s8_q[8:6];
  logic parity_789;
  assign parity_789 = ^select_777_s8_q[11:3];
  logic parity_803;
  assign parity_803 = ^select_800_s8_q[8:6];
  logic parity_806;
  assign parity_806 = ^select_800_s8_q[11:9];
  logic parity_823;
  assign parity_823 = ^select_817_s8_q[2:0];
  logic parity_826;
  assign parity_826 = ^select_817_s8_q[5:3];
  logic parity_829;
  assign parity_829 = ^select_817_s8_q[8:0];
  logic parity_835;
  assign parity_835 = ^select_817_s8_q[11:9];
  logic parity_838;
  assign parity_838 = ^select_800_s8_q[2:0];
  logic parity_841;
  assign parity_841 = ^{select_817_s8_q[11:9], select_800_s8_q[5:0]};
  logic parity_844;
  assign parity_844 = ^{select_817_s8_q, select_800_s8_q, select_777_s8_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_849;
  assign or_849 = (select_777_s8_q[1:0] == 2'h3) | (select_777_s8_q[2] & (select_777_s8_q[0] | select_777_s8_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_853;
  assign or_853 = (select_800_s8_q[7:6] == 2'h3) | (select_800_s8_q[8] & (select_800_s8_q[6] | select_800_s8_q[7]));
  logic or_857;
  assign or_857 = (select_800_s8_q[10:9] == 2'h3) | (select_800_s8_q[11] & (select_800_s8_q[9] | select_800_s8_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_865;
  assign or_865 = (select_817_s8_q[7:6] == 2'h3) | (select_817_s8_q[8] & (~(select_817_s8_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_869;
  assign or_869 = (select_817_s8_q[1:0] == 2'h3) | (select_817_s8_q[2] & (select_817_s8_q[0] | select_817_s8_q[1]));
  logic or_873;
  assign or_873 = (select_817_s8_q[4:3] == 2'h3) | (select_817_s8_q[5] & (select_817_s8_q[3] | select_817_s8_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_876;
  assign parity_876 = ^{or_873, or_869, or_865};
  // hls/stages/count_bits.hpp:23
  logic or_880;
  assign or_880 = (select_800_s8_q[4:3] == 2'h3) | (select_800_s8_q[5] & (select_800_s8_q[3] | select_800_s8_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_884;
  assign or_884 = (select_817_s8_q[10:9] == 2'h3) | (select_817_s8_q[11] & (select_817_s8_q[9] | select_817_s8_q[10]));
  logic or_888;
  assign or_888 = (select_800_s8_q[1:0] == 2'h3) | (select_800_s8_q[2] & (select_800_s8_q[0] | select_800_s8_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_891;
  assign parity_891 = ^{or_888, or_884, or_880};
  logic parity_894;
  assign parity_894 = ^{or_888, or_884, or_880, or_873, or_869, or_865, or_857, or_853, or_849};
  // hls/stages/count_bits.hpp:25
  logic or_899;
  assign or_899 = (parity_783 & parity_786) | ((^select_777_s8_q[11:9]) & (parity_783 | parity_786));
  logic and_902;
  assign and_902 = (^{select_800_s8_q[11:6], select_777_s8_q[2:0]}) & (parity_829 | parity_841);
  // hls/stages/count_bits.hpp:23
  logic or_910;
  assign or_910 = (select_777_s8_q[10:9] == 2'h3) | (select_777_s8_q[11] & (select_777_s8_q[9] | select_777_s8_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_914;
  assign or_914 = (select_777_s8_q[4:3] == 2'h3) | (select_777_s8_q[5] & (select_777_s8_q[3] | select_777_s8_q[4]));
  logic or_918;
  assign or_918 = (select_777_s8_q[7:6] == 2'h3) | (select_777_s8_q[8] & (select_777_s8_q[6] | select_777_s8_q[7]));
  logic or_925;
  assign or_925 = (parity_803 & parity_806) | ((^select_777_s8_q[2:0]) & (parity_803 | parity_806));
  logic or_929;
  assign or_929 = (parity_823 & parity_826) | ((^select_817_s8_q[8:6]) & (parity_823 | parity_826));
  logic or_933;
  assign or_933 = (parity_835 & parity_838) | ((^select_800_s8_q[5:3]) & (parity_835 | parity_838));
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1026;
  assign select_1026 = and_770_s8_q ? select_1025_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1032;
  assign parity_1032 = ^select_1026[5:3];
  logic parity_1035;
  assign parity_1035 = ^select_1026[8:6];
  logic parity_1038;
  assign parity_1038 = ^select_1026[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1049;
  assign select_1049 = and_793_s8_q ? select_1048_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1052;
  assign parity_1052 = ^select_1049[8:6];
  logic parity_1055;
  assign parity_1055 = ^select_1049[11:9];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1066;
  assign select_1066 = and_810_s8_q ? select_1065_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1072;
  assign parity_1072 = ^select_1066[2:0];
  logic parity_1075;
  assign parity_1075 = ^select_1066[5:3];
  logic parity_1078;
  assign parity_1078 = ^select_1066[8:0];
  logic parity_1084;
  assign parity_1084 = ^select_1066[11:9];
  logic parity_1087;
  assign parity_1087 = ^select_1049[2:0];
  logic parity_1090;
  assign parity_1090 = ^{select_1066[11:9], select_1049[5:0]};
  logic parity_1093;
  assign parity_1093 = ^{select_1066, select_1049, select_1026[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1098;
  assign or_1098 = (select_1026[1:0] == 2'h3) | (select_1026[2] & (select_1026[0] | select_1026[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1102;
  assign or_1102 = (select_1049[7:6] == 2'h3) | (select_1049[8] & (select_1049[6] | select_1049[7]));
  logic or_1106;
  assign or_1106 = (select_1049[10:9] == 2'h3) | (select_1049[11] & (select_1049[9] | select_1049[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1114;
  assign or_1114 = (select_1066[7:6] == 2'h3) | (select_1066[8] & (~(select_1066[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1118;
  assign or_1118 = (select_1066[1:0] == 2'h3) | (select_1066[2] & (select_1066[0] | select_1066[1]));
  logic or_1122;
  assign or_1122 = (select_1066[4:3] == 2'h3) | (select_1066[5] & (select_1066[3] | select_1066[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1125;
  assign parity_1125 = ^{or_1122, or_1118, or_1114};
  // hls/stages/count_bits.hpp:23
  logic or_1129;
  assign or_1129 = (select_1049[4:3] == 2'h3) | (select_1049[5] & (select_1049[3] | select_1049[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1133;
  assign or_1133 = (select_1066[10:9] == 2'h3) | (select_1066[11] & (select_1066[9] | select_1066[10]));
  logic or_1137;
  assign or_1137 = (select_1049[1:0] == 2'h3) | (select_1049[2] & (select_1049[0] | select_1049[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1140;
  assign parity_1140 = ^{or_1137, or_1133, or_1129};
  logic parity_1143;
  assign parity_1143 = ^{or_1137, or_1133, or_1129, or_1122, or_1118, or_1114, or_1106, or_1102, or_1098};
  // hls/stages/count_bits.hpp:25
  logic or_1148;
  assign or_1148 = (parity_1032 & parity_1035) | ((^select_1026[11:9]) & (parity_1032 | parity_1035));
  logic and_1151;
  assign and_1151 = (^{select_1049[11:6], select_1026[2:0]}) & (parity_1078 | parity_1090);
  // hls/stages/count_bits.hpp:23
  logic or_1159;
  assign or_1159 = (select_1026[10:9] == 2'h3) | (select_1026[11] & (select_1026[9] | select_1026[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1163;
  assign or_1163 = (select_1026[4:3] == 2'h3) | (select_1026[5] & (select_1026[3] | select_1026[4]));
  logic or_1167;
  assign or_1167 = (select_1026[7:6] == 2'h3) | (select_1026[8] & (select_1026[6] | select_1026[7]));
  logic or_1174;
  assign or_1174 = (parity_1052 & parity_1055) | ((^select_1026[2:0]) & (parity_1052 | parity_1055));
  logic or_1178;
  assign or_1178 = (parity_1072 & parity_1075) | ((^select_1066[8:6]) & (parity_1072 | parity_1075));
  logic or_1182;
  assign or_1182 = (parity_1084 & parity_1087) | ((^select_1049[5:3]) & (parity_1084 | parity_1087));
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1279;
  assign select_1279 = and_770_s8_q ? select_1278_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1285;
  assign parity_1285 = ^select_1279[5:3];
  logic parity_1288;
  assign parity_1288 = ^select_1279[8:6];
  logic parity_1291;
  assign parity_1291 = ^select_1279[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1300;
  assign select_1300 = and_793_s8_q ? select_1299_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1303;
  assign parity_1303 = ^select_1300[8:6];
  logic parity_1306;
  assign parity_1306 = ^select_1300[11:9];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1315;
  assign select_1315 = and_810_s8_q ? select_1314_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1321;
  assign parity_1321 = ^select_1315[2:0];
  logic parity_1324;
  assign parity_1324 = ^select_1315[5:3];
  logic parity_1327;
  assign parity_1327 = ^select_1315[8:0];
  logic parity_1333;
  assign parity_1333 = ^select_1315[11:9];
  logic parity_1336;
  assign parity_1336 = ^select_1300[2:0];
  logic parity_1339;
  assign parity_1339 = ^{select_1315[11:9], select_1300[5:0]};
  logic parity_1342;
  assign parity_1342 = ^{select_1315, select_1300, select_1279[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1347;
  assign or_1347 = (select_1279[1:0] == 2'h3) | (select_1279[2] & (select_1279[0] | select_1279[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1351;
  assign or_1351 = (select_1300[7:6] == 2'h3) | (select_1300[8] & (select_1300[6] | select_1300[7]));
  logic or_1355;
  assign or_1355 = (select_1300[10:9] == 2'h3) | (select_1300[11] & (select_1300[9] | select_1300[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1363;
  assign or_1363 = (select_1315[7:6] == 2'h3) | (select_1315[8] & (~(select_1315[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1367;
  assign or_1367 = (select_1315[1:0] == 2'h3) | (select_1315[2] & (select_1315[0] | select_1315[1]));
  logic or_1371;
  assign or_1371 = (select_1315[4:3] == 2'h3) | (select_1315[5] & (select_1315[3] | select_1315[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1374;
  assign parity_1374 = ^{or_1371, or_1367, or_1363};
  // hls/stages/count_bits.hpp:23
  logic or_1378;
  assign or_1378 = (select_1300[4:3] == 2'h3) | (select_1300[5] & (select_1300[3] | select_1300[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1382;
  assign or_1382 = (select_1315[10:9] == 2'h3) | (select_1315[11] & (select_1315[9] | select_1315[10]));
  logic or_1386;
  assign or_1386 = (select_1300[1:0] == 2'h3) | (select_1300[2] & (select_1300[0] | select_1300[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1389;
  assign parity_1389 = ^{or_1386, or_1382, or_1378};
  logic parity_1392;
  assign parity_1392 = ^{or_1386, or_1382, or_1378, or_1371, or_1367, or_1363, or_1355, or_1351, or_1347};
  // hls/stages/count_bits.hpp:25
  logic or_1397;
  assign or_1397 = (parity_1285 & parity_1288) | ((^select_1279[11:9]) & (parity_1285 | parity_1288));
  logic and_1400;
  assign and_1400 = (^{select_1300[11:6], select_1279[2:0]}) & (parity_1327 | parity_1339);
  // hls/stages/count_bits.hpp:23
  logic or_1408;
  assign or_1408 = (select_1279[10:9] == 2'h3) | (select_1279[11] & (select_1279[9] | select_1279[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1412;
  assign or_1412 = (select_1279[4:3] == 2'h3) | (select_1279[5] & (select_1279[3] | select_1279[4]));
  logic or_1416;
  assign or_1416 = (select_1279[7:6] == 2'h3) | (select_1279[8] & (select_1279[6] | select_1279[7]));
  logic or_1423;
  assign or_1423 = (parity_1303 & parity_1306) | ((^select_1279[2:0]) & (parity_1303 | parity_1306));
  logic or_1427;
  assign or_1427 = (parity_1321 & parity_1324) | ((^select_1315[8:6]) & (parity_1321 | parity_1324));
  logic or_1431;
  assign or_1431 = (parity_1333 & parity_1336) | ((^select_1300[5:3]) & (parity_1333 | parity_1336));
  // hls/stages/agreement.hpp:248
  logic or_1590;
  assign or_1590 = (cfg_nearer_below_i & shift_s8_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s8_q)));
  // hls/stages/registration.hpp:213
  logic [9:0] select_1763;
  assign select_1763 = b_s8_q[4] ? select_1762_s8_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1768;
  assign sum_1768 = (b_s8_q[0] ? select_1762_s8_q[13:1] : 13'h0) + (b_s8_q[1] ? select_1762_s8_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1769;
  assign select_1769 = b_s8_q[2] ? select_1762_s8_q[11:0] : 12'h0;
  // hls/stages/patches.hpp:516
  logic not_1793;
  assign not_1793 = ~equal_1792_s8_q;
  // hls/stages/patches.hpp:462
  logic not_1795;
  assign not_1795 = ~equal_1794_s8_q;
  logic and_1876;
  assign and_1876 = not_1793 & (or_1798_s8_q & not_1795);
  // hls/stages/patches.hpp:549
  logic less_1970;
  assign less_1970 = patches_step_q[4:0] < 5'h11;
  logic equal_1971;
  assign equal_1971 = patches_step_q[6:5] == 2'h2;
  logic equal_1972;
  assign equal_1972 = patches_step_q[6:5] == 2'h1;
  logic or_1973;
  assign or_1973 = equal_1971 | equal_1972;
  // hls/stages/agreement.hpp:530
  logic select_2580;
  assign select_2580 = and_552_s8_q ? (equal_2482_s8_q ? not_2578_s8_q : lower_half_q) : lower_half_q;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2755;
  assign select_2755 = or_582_s8_q ? (less_585_s8_q ? 8'h0 : best_left_rdata_s8_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2757_s8_q} - {1'b0, select_2759_s8_q};
  // hls/stages/patches.hpp:126
  logic select_3033;
  assign select_3033 = row_starts_s8_q ? (and_1693_s8_q ? not_3031_s8_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:191
  logic [4:0] select_3103;
  assign select_3103 = or_3072_s8_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/agreement.hpp:276
  logic select_3553;
  assign select_3553 = equal_1792_s8_q ? (less_1970 & (equal_1972 & or_1973)) : patches_read_searches_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:789; read in stage 8, written in stage 20: 8 < 20 < 8 + DISTANCE.
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
  assign patches_right_0_re = s8_en & (not_1793 & (not_1795 & and_1801_s8_q));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:789; read in stage 8, written in stage 20: 8 < 20 < 8 + DISTANCE.
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
  assign patches_right_1_re = s8_en & (not_1793 & (not_1795 & and_1834_s8_q));
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:801; read in stage 8, written in stage 12: 8 < 12 < 8 + DISTANCE.
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
  assign patches_columns_above_re = s8_en & and_1876;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s8_q[6:0];
  logic left_we;
  assign left_we = s8_en & and_657_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_759_s8_q, left_rdata_s8_q[62:46], and_758_s8_q, left_rdata_s8_q[45:29], and_757_s8_q, left_rdata_s8_q[28:12], and_756_s8_q, left_rdata_s8_q[11:0], fresh_rdata_s8_q[30:26], fresh_rdata_s8_q[24], fresh_rdata_s8_q[11:0]};
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
  assign right_codes_we = s8_en & and_657_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_765_s8_q, right_codes_rdata_s8_q[77:66], and_764_s8_q, right_codes_rdata_s8_q[65:54], and_763_s8_q, right_codes_rdata_s8_q[53:40], and_762_s8_q, right_codes_rdata_s8_q[39:26], and_761_s8_q, right_codes_rdata_s8_q[25:12], and_760_s8_q, right_codes_rdata_s8_q[11:0], fresh_rdata_s8_q[32:31], fresh_rdata_s8_q[25], fresh_rdata_s8_q[23:12]};
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
      patches_lower_q <= 1'b0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
      patches_step_q <= 7'h0;
      patches_read_searches_q <= 1'b0;
    end else if (s8_en) begin
      lower_half_q <= select_2580;
      patches_lower_q <= sample_pair_whole_s8_q ? select_3033 : patches_lower_q;
      patches_code_row_q <= select_3103;
      patches_column_q <= or_3072_s8_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3096_s8_q & (patches_column_q == 5'h1e);
      patches_step_q <= or_3072_s8_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3553;
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
  logic patches_lower_s9_q;
  logic patches_second_s9_q;
  logic [4:0] patches_code_row_s9_q;
  logic [4:0] patches_column_s9_q;
  logic [4:0] patches_step_s9_q;
  logic patches_read_searches_s9_q;
  logic done_s9_q;
  logic [3:0] select_511_s9_q;
  logic equal_512_s9_q;
  logic row_starts_s9_q;
  logic [8:0] select_516_s9_q;
  logic and_525_s9_q;
  logic equal_531_s9_q;
  logic [6:0] select_546_s9_q;
  logic [6:0] last_s9_2_q;
  logic and_550_s9_q;
  logic and_552_s9_q;
  logic equal_571_s9_q;
  logic equal_577_s9_q;
  logic so_s9_q;
  logic equal_581_s9_q;
  logic or_582_s9_q;
  logic less_585_s9_q;
  logic not_586_s9_q;
  logic equal_596_s9_q;
  logic and_610_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_619_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic [6:0] select_628_s9_q;
  logic [6:0] right_s9_q;
  logic and_642_s9_q;
  logic and_645_s9_q;
  logic and_651_s9_q;
  logic and_653_s9_q;
  logic equal_686_s9_q;
  logic xor_845_s9_q;
  logic parity_894_s9_q;
  logic and_895_s9_q;
  logic or_899_s9_q;
  logic or_903_s9_q;
  logic or_910_s9_q;
  logic or_914_s9_q;
  logic or_918_s9_q;
  logic or_925_s9_q;
  logic or_929_s9_q;
  logic or_933_s9_q;
  logic and_942_s9_q;
  logic and_944_s9_q;
  logic or_956_s9_q;
  logic or_960_s9_q;
  logic or_964_s9_q;
  logic xor_1094_s9_q;
  logic parity_1109_s9_q;
  logic parity_1143_s9_q;
  logic and_1144_s9_q;
  logic or_1148_s9_q;
  logic or_1152_s9_q;
  logic or_1159_s9_q;
  logic or_1163_s9_q;
  logic or_1167_s9_q;
  logic or_1174_s9_q;
  logic or_1178_s9_q;
  logic or_1182_s9_q;
  logic and_1191_s9_q;
  logic or_1192_s9_q;
  logic or_1205_s9_q;
  logic or_1209_s9_q;
  logic or_1213_s9_q;
  logic xor_1343_s9_q;
  logic parity_1358_s9_q;
  logic parity_1392_s9_q;
  logic and_1393_s9_q;
  logic or_1397_s9_q;
  logic or_1401_s9_q;
  logic or_1408_s9_q;
  logic or_1412_s9_q;
  logic or_1416_s9_q;
  logic or_1423_s9_q;
  logic or_1427_s9_q;
  logic or_1431_s9_q;
  logic and_1440_s9_q;
  logic or_1441_s9_q;
  logic or_1454_s9_q;
  logic or_1458_s9_q;
  logic or_1462_s9_q;
  logic and_1569_s9_q;
  logic equal_1570_s9_q;
  logic or_1590_s9_q;
  logic and_1693_s9_q;
  logic less_1707_s9_q;
  logic [5:0] b_s9_q;
  logic select_1763_s9_q;
  logic [8:0] difference_1765_s9_q;
  logic [11:0] sum_1768_s9_q;
  logic select_1769_s9_q;
  logic [10:0] sum_1771_s9_q;
  logic equal_1792_s9_q;
  logic not_1793_s9_q;
  logic equal_1794_s9_q;
  logic not_1795_s9_q;
  logic equal_1796_s9_q;
  logic equal_1797_s9_q;
  logic or_1798_s9_q;
  logic not_1799_s9_q;
  logic [4:0] select_1822_s9_q;
  logic select_1828_s9_q;
  logic and_1855_s9_q;
  logic [3:0] select_1866_s9_q;
  logic and_1876_s9_q;
  logic less_1970_s9_q;
  logic equal_1971_s9_q;
  logic or_1973_s9_q;
  logic sum_1997_s9_q;
  logic not_2007_s9_q;
  logic and_2021_s9_q;
  logic not_2061_s9_q;
  logic less_2139_s9_q;
  logic equal_2293_s9_q;
  logic equal_2482_s9_q;
  logic and_2588_s9_q;
  logic and_2619_s9_q;
  logic equal_2708_s9_q;
  logic [7:0] select_2755_s9_q;
  logic rise_2_s9_q;
  logic [7:0] select_2761_s9_q;
  logic [7:0] xor_2766_s9_q;
  logic less_2792_s9_q;
  logic or_3072_s9_q;
  logic not_3096_s9_q;
  logic equal_3588_s9_q;
  logic less_3844_s9_q;
  logic equal_3916_s9_q;
  logic or_4066_s9_q;
  logic and_4080_s9_q;
  logic and_4097_s9_q;
  logic not_4109_s9_q;
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
      patches_chooses_s9_q <= patches_chooses_s8_q;
      patches_choosing_band_s9_q <= patches_choosing_band_s8_q;
      patches_lower_s9_q <= patches_lower_q;
      patches_second_s9_q <= patches_second_s8_q;
      patches_code_row_s9_q <= patches_code_row_q;
      patches_column_s9_q <= patches_column_q;
      patches_step_s9_q <= patches_step_q[4:0];
      patches_read_searches_s9_q <= patches_read_searches_q;
      done_s9_q <= done_s8_q;
      select_511_s9_q <= select_511_s8_q;
      equal_512_s9_q <= equal_512_s8_q;
      row_starts_s9_q <= row_starts_s8_q;
      select_516_s9_q <= select_516_s8_q;
      and_525_s9_q <= and_525_s8_q;
      equal_531_s9_q <= equal_531_s8_q;
      select_546_s9_q <= select_546_s8_q;
      last_s9_2_q <= last_s8_2_q;
      and_550_s9_q <= and_550_s8_q;
      and_552_s9_q <= and_552_s8_q;
      equal_571_s9_q <= equal_571_s8_q;
      equal_577_s9_q <= equal_577_s8_q;
      so_s9_q <= drew_q;
      equal_581_s9_q <= equal_581_s8_q;
      or_582_s9_q <= or_582_s8_q;
      less_585_s9_q <= less_585_s8_q;
      not_586_s9_q <= not_586_s8_q;
      equal_596_s9_q <= equal_596_s8_q;
      and_610_s9_q <= and_610_s8_q;
      x_s9_2_q <= x_s8_2_q;
      select_619_s9_q <= select_619_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_628_s9_q <= ({1'b0, last_s8_q} < found) ? 7'h0 : found[6:0];
      right_s9_q <= right_s8_q;
      and_642_s9_q <= and_642_s8_q;
      and_645_s9_q <= and_645_s8_q;
      and_651_s9_q <= and_651_s8_q;
      and_653_s9_q <= and_653_s8_q;
      equal_686_s9_q <= equal_686_s8_q;
      xor_845_s9_q <= parity_789 ^ parity_844;
      parity_894_s9_q <= parity_894;
      and_895_s9_q <= parity_789 & parity_844;
      or_899_s9_q <= or_899;
      or_903_s9_q <= (parity_829 & parity_841) | and_902;
      or_910_s9_q <= or_910;
      or_914_s9_q <= or_914;
      or_918_s9_q <= or_918;
      or_925_s9_q <= or_925;
      or_929_s9_q <= or_929;
      or_933_s9_q <= or_933;
      and_942_s9_q <= parity_876 & parity_891;
      and_944_s9_q <= (^{or_857, or_853, or_849}) & (parity_876 | parity_891);
      or_956_s9_q <= (or_853 & or_857) | (or_849 & (or_853 | or_857));
      or_960_s9_q <= (or_869 & or_873) | (or_865 & (or_869 | or_873));
      or_964_s9_q <= (or_884 & or_888) | (or_880 & (or_884 | or_888));
      xor_1094_s9_q <= parity_1038 ^ parity_1093;
      parity_1109_s9_q <= ^{or_1106, or_1102, or_1098};
      parity_1143_s9_q <= parity_1143;
      and_1144_s9_q <= parity_1038 & parity_1093;
      or_1148_s9_q <= or_1148;
      or_1152_s9_q <= (parity_1078 & parity_1090) | and_1151;
      or_1159_s9_q <= or_1159;
      or_1163_s9_q <= or_1163;
      or_1167_s9_q <= or_1167;
      or_1174_s9_q <= or_1174;
      or_1178_s9_q <= or_1178;
      or_1182_s9_q <= or_1182;
      and_1191_s9_q <= parity_1125 & parity_1140;
      or_1192_s9_q <= parity_1125 | parity_1140;
      or_1205_s9_q <= (or_1102 & or_1106) | (or_1098 & (or_1102 | or_1106));
      or_1209_s9_q <= (or_1118 & or_1122) | (or_1114 & (or_1118 | or_1122));
      or_1213_s9_q <= (or_1133 & or_1137) | (or_1129 & (or_1133 | or_1137));
      xor_1343_s9_q <= parity_1291 ^ parity_1342;
      parity_1358_s9_q <= ^{or_1355, or_1351, or_1347};
      parity_1392_s9_q <= parity_1392;
      and_1393_s9_q <= parity_1291 & parity_1342;
      or_1397_s9_q <= or_1397;
      or_1401_s9_q <= (parity_1327 & parity_1339) | and_1400;
      or_1408_s9_q <= or_1408;
      or_1412_s9_q <= or_1412;
      or_1416_s9_q <= or_1416;
      or_1423_s9_q <= or_1423;
      or_1427_s9_q <= or_1427;
      or_1431_s9_q <= or_1431;
      and_1440_s9_q <= parity_1374 & parity_1389;
      or_1441_s9_q <= parity_1374 | parity_1389;
      or_1454_s9_q <= (or_1351 & or_1355) | (or_1347 & (or_1351 | or_1355));
      or_1458_s9_q <= (or_1367 & or_1371) | (or_1363 & (or_1367 | or_1371));
      or_1462_s9_q <= (or_1382 & or_1386) | (or_1378 & (or_1382 | or_1386));
      and_1569_s9_q <= and_1569_s8_q;
      equal_1570_s9_q <= equal_1570_s8_q;
      or_1590_s9_q <= or_1590;
      and_1693_s9_q <= and_1693_s8_q;
      less_1707_s9_q <= less_1707_s8_q;
      b_s9_q <= b_s8_q;
      select_1763_s9_q <= select_1763[0];
      difference_1765_s9_q <= select_1763[9:1] - (b_s8_q[5] ? select_1762_s8_q[8:0] : 9'h0);
      sum_1768_s9_q <= sum_1768[12:1];
      select_1769_s9_q <= select_1769[0];
      sum_1771_s9_q <= select_1769[11:1] + (b_s8_q[3] ? select_1762_s8_q[10:0] : 11'h0);
      equal_1792_s9_q <= equal_1792_s8_q;
      not_1793_s9_q <= not_1793;
      equal_1794_s9_q <= equal_1794_s8_q;
      not_1795_s9_q <= not_1795;
      equal_1796_s9_q <= equal_1796_s8_q;
      equal_1797_s9_q <= equal_1797_s8_q;
      or_1798_s9_q <= or_1798_s8_q;
      not_1799_s9_q <= not_1799_s8_q;
      select_1822_s9_q <= select_1822_s8_q;
      select_1828_s9_q <= select_1828_s8_q;
      and_1855_s9_q <= not_1793 & (not_1795 & and_1853_s8_q);
      select_1866_s9_q <= select_1866_s8_q;
      and_1876_s9_q <= and_1876;
      less_1970_s9_q <= less_1970;
      equal_1971_s9_q <= equal_1971;
      or_1973_s9_q <= or_1973;
      sum_1997_s9_q <= sum_1997_s8_q;
      not_2007_s9_q <= not_2007_s8_q;
      and_2021_s9_q <= and_2021_s8_q;
      not_2061_s9_q <= not_2061_s8_q;
      less_2139_s9_q <= less_2139_s8_q;
      equal_2293_s9_q <= equal_2293_s8_q;
      equal_2482_s9_q <= equal_2482_s8_q;
      and_2588_s9_q <= and_2588_s8_q;
      and_2619_s9_q <= or_582_s8_q & and_2618_s8_q;
      equal_2708_s9_q <= shift_s8_q == 6'h0;
      select_2755_s9_q <= select_2755;
      rise_2_s9_q <= rise_2[8];
      select_2761_s9_q <= rise_2[8] ? select_2757_s8_q : select_2759_s8_q;
      xor_2766_s9_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2792_s9_q <= select_2757_s8_q < select_2759_s8_q;
      or_3072_s9_q <= or_3072_s8_q;
      not_3096_s9_q <= not_3096_s8_q;
      equal_3588_s9_q <= patches_step_q[6:5] == 2'h3;
      less_3844_s9_q <= less_3844_s8_q;
      equal_3916_s9_q <= equal_3916_s8_q;
      or_4066_s9_q <= or_4066_s8_q;
      and_4080_s9_q <= said_q;
      and_4097_s9_q <= less_2581 & proven_q;
      not_4109_s9_q <= not_4109_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic [15:0] patches_chance_q;
  // hls/stages/count_bits.hpp:24
  logic parity_921;
  assign parity_921 = ^{or_918_s9_q, or_914_s9_q, or_910_s9_q};
  logic parity_936;
  assign parity_936 = ^{or_933_s9_q, or_929_s9_q, or_925_s9_q};
  logic parity_939;
  assign parity_939 = ^{or_933_s9_q, or_929_s9_q, or_925_s9_q, or_918_s9_q, or_914_s9_q, or_910_s9_q, or_903_s9_q, or_899_s9_q, and_895_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_941;
  assign and_941 = parity_894_s9_q & parity_939;
  logic or_945;
  assign or_945 = and_942_s9_q | and_944_s9_q;
  logic and_948;
  assign and_948 = (^{or_903_s9_q, or_899_s9_q, and_895_s9_q}) & (parity_921 | parity_936);
  logic or_949;
  assign or_949 = (parity_921 & parity_936) | and_948;
  // hls/stages/count_bits.hpp:24
  logic parity_967;
  assign parity_967 = ^{or_964_s9_q, or_960_s9_q, or_956_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_971;
  assign or_971 = (or_899_s9_q & or_903_s9_q) | (and_895_s9_q & (or_899_s9_q | or_903_s9_q));
  logic or_975;
  assign or_975 = (or_914_s9_q & or_918_s9_q) | (or_910_s9_q & (or_914_s9_q | or_918_s9_q));
  logic or_979;
  assign or_979 = (or_929_s9_q & or_933_s9_q) | (or_925_s9_q & (or_929_s9_q | or_933_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_982;
  assign parity_982 = ^{or_979, or_975, or_971};
  logic parity_985;
  assign parity_985 = ^{or_979, or_975, or_971, or_964_s9_q, or_960_s9_q, or_956_s9_q, or_949, or_945, and_941};
  // hls/stages/count_bits.hpp:25
  logic or_997;
  assign or_997 = (or_960_s9_q & or_964_s9_q) | (or_956_s9_q & (or_960_s9_q | or_964_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1170;
  assign parity_1170 = ^{or_1167_s9_q, or_1163_s9_q, or_1159_s9_q};
  logic parity_1185;
  assign parity_1185 = ^{or_1182_s9_q, or_1178_s9_q, or_1174_s9_q};
  logic parity_1188;
  assign parity_1188 = ^{or_1182_s9_q, or_1178_s9_q, or_1174_s9_q, or_1167_s9_q, or_1163_s9_q, or_1159_s9_q, or_1152_s9_q, or_1148_s9_q, and_1144_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1190;
  assign and_1190 = parity_1143_s9_q & parity_1188;
  logic or_1194;
  assign or_1194 = and_1191_s9_q | (parity_1109_s9_q & or_1192_s9_q);
  logic and_1197;
  assign and_1197 = (^{or_1152_s9_q, or_1148_s9_q, and_1144_s9_q}) & (parity_1170 | parity_1185);
  logic or_1198;
  assign or_1198 = (parity_1170 & parity_1185) | and_1197;
  // hls/stages/count_bits.hpp:24
  logic parity_1216;
  assign parity_1216 = ^{or_1213_s9_q, or_1209_s9_q, or_1205_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1220;
  assign or_1220 = (or_1148_s9_q & or_1152_s9_q) | (and_1144_s9_q & (or_1148_s9_q | or_1152_s9_q));
  logic or_1224;
  assign or_1224 = (or_1163_s9_q & or_1167_s9_q) | (or_1159_s9_q & (or_1163_s9_q | or_1167_s9_q));
  logic or_1228;
  assign or_1228 = (or_1178_s9_q & or_1182_s9_q) | (or_1174_s9_q & (or_1178_s9_q | or_1182_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1231;
  assign parity_1231 = ^{or_1228, or_1224, or_1220};
  logic parity_1234;
  assign parity_1234 = ^{or_1228, or_1224, or_1220, or_1213_s9_q, or_1209_s9_q, or_1205_s9_q, or_1198, or_1194, and_1190};
  // hls/stages/count_bits.hpp:25
  logic or_1246;
  assign or_1246 = (or_1209_s9_q & or_1213_s9_q) | (or_1205_s9_q & (or_1209_s9_q | or_1213_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1419;
  assign parity_1419 = ^{or_1416_s9_q, or_1412_s9_q, or_1408_s9_q};
  logic parity_1434;
  assign parity_1434 = ^{or_1431_s9_q, or_1427_s9_q, or_1423_s9_q};
  logic parity_1437;
  assign parity_1437 = ^{or_1431_s9_q, or_1427_s9_q, or_1423_s9_q, or_1416_s9_q, or_1412_s9_q, or_1408_s9_q, or_1401_s9_q, or_1397_s9_q, and_1393_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1439;
  assign and_1439 = parity_1392_s9_q & parity_1437;
  logic or_1443;
  assign or_1443 = and_1440_s9_q | (parity_1358_s9_q & or_1441_s9_q);
  logic and_1446;
  assign and_1446 = (^{or_1401_s9_q, or_1397_s9_q, and_1393_s9_q}) & (parity_1419 | parity_1434);
  logic or_1447;
  assign or_1447 = (parity_1419 & parity_1434) | and_1446;
  // hls/stages/count_bits.hpp:24
  logic parity_1465;
  assign parity_1465 = ^{or_1462_s9_q, or_1458_s9_q, or_1454_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1469;
  assign or_1469 = (or_1397_s9_q & or_1401_s9_q) | (and_1393_s9_q & (or_1397_s9_q | or_1401_s9_q));
  logic or_1473;
  assign or_1473 = (or_1412_s9_q & or_1416_s9_q) | (or_1408_s9_q & (or_1412_s9_q | or_1416_s9_q));
  logic or_1477;
  assign or_1477 = (or_1427_s9_q & or_1431_s9_q) | (or_1423_s9_q & (or_1427_s9_q | or_1431_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1480;
  assign parity_1480 = ^{or_1477, or_1473, or_1469};
  logic parity_1483;
  assign parity_1483 = ^{or_1477, or_1473, or_1469, or_1462_s9_q, or_1458_s9_q, or_1454_s9_q, or_1447, or_1443, and_1439};
  // hls/stages/count_bits.hpp:25
  logic or_1495;
  assign or_1495 = (or_1458_s9_q & or_1462_s9_q) | (or_1454_s9_q & (or_1458_s9_q | or_1462_s9_q));
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s9_q[6:1]} < x_s9_q;
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1772;
  assign sum_1772 = sum_1768_s9_q + {sum_1771_s9_q, select_1769_s9_q};
  logic [9:0] sum_1773;
  assign sum_1773 = {difference_1765_s9_q, select_1763_s9_q} + sum_1772[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2755_s9_q} - {1'b0, select_2761_s9_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s9_q} + {1'b0, xor_2766_s9_q};
  // hls/stages/patches.hpp:91
  logic parity_3009;
  assign parity_3009 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3010;
  assign select_3010 = equal_2482_s9_q ? {patches_chance_q[14:0], parity_3009} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s9_q[6] ? {of_32, 1'b0} : {1'b0, of_32};

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1393; read in stage 9, written in stage 16: 9 < 16 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_582_s9_q ? select_628_s9_q : right_s9_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s9_en & select_619_s9_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:790; read in stage 9, written in stage 20: 9 < 20 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s9_q, patches_code_row_s9_q[3:0], patches_column_s9_q[3:0]};
`ifndef SYNTHESIS
  logic patches_left_re;
  assign patches_left_re = s9_en & and_1855_s9_q;
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:821; read in stage 9, written in stage 23: 9 < 23 < 9 + DISTANCE.
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
  assign patches_rows_re = s9_en & (equal_1792_s9_q & (less_1970_s9_q & or_1973_s9_q));
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_chance_q <= 16'h1;
    end else if (s9_en) begin
      patches_chance_q <= and_552_s9_q ? select_3010 : patches_chance_q;
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
  logic patches_chooses_s10_q;
  logic [4:0] patches_choosing_band_s10_q;
  logic patches_lower_s10_q;
  logic patches_second_s10_q;
  logic [4:0] patches_code_row_s10_q;
  logic [4:0] patches_column_s10_q;
  logic [4:0] patches_step_s10_q;
  logic patches_read_searches_s10_q;
  logic done_s10_q;
  logic [3:0] select_511_s10_q;
  logic equal_512_s10_q;
  logic row_starts_s10_q;
  logic [8:0] select_516_s10_q;
  logic and_525_s10_q;
  logic equal_531_s10_q;
  logic [6:0] select_546_s10_q;
  logic [6:0] last_s10_2_q;
  logic and_550_s10_q;
  logic and_552_s10_q;
  logic equal_571_s10_q;
  logic equal_577_s10_q;
  logic so_s10_q;
  logic equal_581_s10_q;
  logic or_582_s10_q;
  logic less_585_s10_q;
  logic not_586_s10_q;
  logic equal_596_s10_q;
  logic and_610_s10_q;
  logic [6:0] x_s10_2_q;
  logic [61:0] best_left_rdata_s10_q;
  logic [6:0] select_628_s10_q;
  logic [6:0] right_s10_q;
  logic and_642_s10_q;
  logic and_645_s10_q;
  logic and_651_s10_q;
  logic and_653_s10_q;
  logic equal_686_s10_q;
  logic xor_845_s10_q;
  logic xor_940_s10_q;
  logic parity_985_s10_q;
  logic and_986_s10_q;
  logic and_988_s10_q;
  logic and_990_s10_q;
  logic and_992_s10_q;
  logic or_997_s10_q;
  logic or_1001_s10_q;
  logic xor_1094_s10_q;
  logic xor_1189_s10_q;
  logic parity_1234_s10_q;
  logic and_1235_s10_q;
  logic and_1237_s10_q;
  logic and_1239_s10_q;
  logic and_1241_s10_q;
  logic or_1246_s10_q;
  logic or_1250_s10_q;
  logic xor_1343_s10_q;
  logic xor_1438_s10_q;
  logic parity_1483_s10_q;
  logic and_1484_s10_q;
  logic and_1486_s10_q;
  logic and_1488_s10_q;
  logic and_1490_s10_q;
  logic or_1495_s10_q;
  logic or_1499_s10_q;
  logic and_1569_s10_q;
  logic equal_1570_s10_q;
  logic or_1590_s10_q;
  logic and_1693_s10_q;
  logic right_3_s10_q;
  logic less_1707_s10_q;
  logic [5:0] b_s10_q;
  logic [7:0] sum_1773_s10_q;
  logic equal_1792_s10_q;
  logic not_1793_s10_q;
  logic equal_1794_s10_q;
  logic not_1795_s10_q;
  logic equal_1796_s10_q;
  logic equal_1797_s10_q;
  logic or_1798_s10_q;
  logic not_1799_s10_q;
  logic [7:0] patches_right_0_rdata_s10_q;
  logic [4:0] select_1822_s10_q;
  logic select_1828_s10_q;
  logic [7:0] patches_right_1_rdata_s10_q;
  logic [3:0] select_1866_s10_q;
  logic and_1876_s10_q;
  logic [31:0] patches_columns_above_rdata_s10_q;
  logic less_1970_s10_q;
  logic equal_1971_s10_q;
  logic or_1973_s10_q;
  logic sum_1997_s10_q;
  logic not_2007_s10_q;
  logic and_2021_s10_q;
  logic not_2061_s10_q;
  logic less_2139_s10_q;
  logic equal_2293_s10_q;
  logic equal_2482_s10_q;
  logic and_2588_s10_q;
  logic and_2619_s10_q;
  logic equal_2708_s10_q;
  logic [7:0] wide_s10_q;
  logic [8:0] size_3_s10_q;
  logic less_2792_s10_q;
  logic [5:0] further_s10_q;
  logic or_3072_s10_q;
  logic not_3096_s10_q;
  logic equal_3588_s10_q;
  logic less_3844_s10_q;
  logic equal_3916_s10_q;
  logic or_4066_s10_q;
  logic and_4080_s10_q;
  logic and_4097_s10_q;
  logic not_4109_s10_q;
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
      patches_chooses_s10_q <= patches_chooses_s9_q;
      patches_choosing_band_s10_q <= patches_choosing_band_s9_q;
      patches_lower_s10_q <= patches_lower_s9_q;
      patches_second_s10_q <= patches_second_s9_q;
      patches_code_row_s10_q <= patches_code_row_s9_q;
      patches_column_s10_q <= patches_column_s9_q;
      patches_step_s10_q <= patches_step_s9_q;
      patches_read_searches_s10_q <= patches_read_searches_s9_q;
      done_s10_q <= done_s9_q;
      select_511_s10_q <= select_511_s9_q;
      equal_512_s10_q <= equal_512_s9_q;
      row_starts_s10_q <= row_starts_s9_q;
      select_516_s10_q <= select_516_s9_q;
      and_525_s10_q <= and_525_s9_q;
      equal_531_s10_q <= equal_531_s9_q;
      select_546_s10_q <= select_546_s9_q;
      last_s10_2_q <= last_s9_2_q;
      and_550_s10_q <= and_550_s9_q;
      and_552_s10_q <= and_552_s9_q;
      equal_571_s10_q <= equal_571_s9_q;
      equal_577_s10_q <= equal_577_s9_q;
      so_s10_q <= so_s9_q;
      equal_581_s10_q <= equal_581_s9_q;
      or_582_s10_q <= or_582_s9_q;
      less_585_s10_q <= less_585_s9_q;
      not_586_s10_q <= not_586_s9_q;
      equal_596_s10_q <= equal_596_s9_q;
      and_610_s10_q <= and_610_s9_q;
      x_s10_2_q <= x_s9_2_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_628_s10_q <= select_628_s9_q;
      right_s10_q <= right_s9_q;
      and_642_s10_q <= and_642_s9_q;
      and_645_s10_q <= and_645_s9_q;
      and_651_s10_q <= and_651_s9_q;
      and_653_s10_q <= and_653_s9_q;
      equal_686_s10_q <= equal_686_s9_q;
      xor_845_s10_q <= xor_845_s9_q;
      xor_940_s10_q <= parity_894_s9_q ^ parity_939;
      parity_985_s10_q <= parity_985;
      and_986_s10_q <= parity_967 & parity_982;
      and_988_s10_q <= (^{or_949, or_945, and_941}) & (parity_967 | parity_982);
      and_990_s10_q <= or_945 & or_949;
      and_992_s10_q <= and_941 & (or_945 | or_949);
      or_997_s10_q <= or_997;
      or_1001_s10_q <= (or_975 & or_979) | (or_971 & (or_975 | or_979));
      xor_1094_s10_q <= xor_1094_s9_q;
      xor_1189_s10_q <= parity_1143_s9_q ^ parity_1188;
      parity_1234_s10_q <= parity_1234;
      and_1235_s10_q <= parity_1216 & parity_1231;
      and_1237_s10_q <= (^{or_1198, or_1194, and_1190}) & (parity_1216 | parity_1231);
      and_1239_s10_q <= or_1194 & or_1198;
      and_1241_s10_q <= and_1190 & (or_1194 | or_1198);
      or_1246_s10_q <= or_1246;
      or_1250_s10_q <= (or_1224 & or_1228) | (or_1220 & (or_1224 | or_1228));
      xor_1343_s10_q <= xor_1343_s9_q;
      xor_1438_s10_q <= parity_1392_s9_q ^ parity_1437;
      parity_1483_s10_q <= parity_1483;
      and_1484_s10_q <= parity_1465 & parity_1480;
      and_1486_s10_q <= (^{or_1447, or_1443, and_1439}) & (parity_1465 | parity_1480);
      and_1488_s10_q <= or_1443 & or_1447;
      and_1490_s10_q <= and_1439 & (or_1443 | or_1447);
      or_1495_s10_q <= or_1495;
      or_1499_s10_q <= (or_1473 & or_1477) | (or_1469 & (or_1473 | or_1477));
      and_1569_s10_q <= and_1569_s9_q;
      equal_1570_s10_q <= equal_1570_s9_q;
      or_1590_s10_q <= or_1590_s9_q;
      and_1693_s10_q <= and_1693_s9_q;
      right_3_s10_q <= right_3;
      less_1707_s10_q <= less_1707_s9_q;
      b_s10_q <= b_s9_q;
      sum_1773_s10_q <= sum_1773[9:2];
      equal_1792_s10_q <= equal_1792_s9_q;
      not_1793_s10_q <= not_1793_s9_q;
      equal_1794_s10_q <= equal_1794_s9_q;
      not_1795_s10_q <= not_1795_s9_q;
      equal_1796_s10_q <= equal_1796_s9_q;
      equal_1797_s10_q <= equal_1797_s9_q;
      or_1798_s10_q <= or_1798_s9_q;
      not_1799_s10_q <= not_1799_s9_q;
      patches_right_0_rdata_s10_q <= patches_right_0_rdata_q;
      select_1822_s10_q <= select_1822_s9_q;
      select_1828_s10_q <= select_1828_s9_q;
      patches_right_1_rdata_s10_q <= patches_right_1_rdata_q;
      select_1866_s10_q <= select_1866_s9_q;
      and_1876_s10_q <= and_1876_s9_q;
      patches_columns_above_rdata_s10_q <= patches_columns_above_rdata_q;
      less_1970_s10_q <= less_1970_s9_q;
      equal_1971_s10_q <= equal_1971_s9_q;
      or_1973_s10_q <= or_1973_s9_q;
      sum_1997_s10_q <= sum_1997_s9_q;
      not_2007_s10_q <= not_2007_s9_q;
      and_2021_s10_q <= and_2021_s9_q;
      not_2061_s10_q <= not_2061_s9_q;
      less_2139_s10_q <= less_2139_s9_q;
      equal_2293_s10_q <= equal_2293_s9_q;
      equal_2482_s10_q <= equal_2482_s9_q;
      and_2588_s10_q <= and_2588_s9_q;
      and_2619_s10_q <= and_2619_s9_q;
      equal_2708_s10_q <= equal_2708_s9_q;
      wide_s10_q <= wide;
      size_3_s10_q <= size_3;
      less_2792_s10_q <= less_2792_s9_q;
      further_s10_q <= further;
      or_3072_s10_q <= or_3072_s9_q;
      not_3096_s10_q <= not_3096_s9_q;
      equal_3588_s10_q <= equal_3588_s9_q;
      less_3844_s10_q <= less_3844_s9_q;
      equal_3916_s10_q <= equal_3916_s9_q;
      or_4066_s10_q <= or_4066_s9_q;
      and_4080_s10_q <= and_4080_s9_q;
      and_4097_s10_q <= and_4097_s9_q;
      not_4109_s10_q <= not_4109_s9_q;
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
  assign inside_v = or_582_s10_q & not_586_s10_q;
  // hls/stages/count_bits.hpp:25
  logic or_989;
  assign or_989 = and_986_s10_q | and_988_s10_q;
  logic or_993;
  assign or_993 = and_990_s10_q | and_992_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1006;
  assign parity_1006 = ^{or_1001_s10_q, or_997_s10_q, or_993, or_989};
  // hls/stages/count_bits.hpp:25
  logic or_1010;
  assign or_1010 = (or_997_s10_q & or_1001_s10_q) | (or_993 & (or_997_s10_q | or_1001_s10_q));
  logic and_1011;
  assign and_1011 = or_989 & (^{or_1001_s10_q, or_997_s10_q, or_993});
  // hls/stages/count_bits.hpp:24
  logic xor_1012;
  assign xor_1012 = or_1010 ^ and_1011;
  // hls/stages/count_bits.hpp:27
  logic and_1013;
  assign and_1013 = or_1010 & and_1011;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1014;
  assign select_1014 = equal_596_s10_q ? {and_1013, xor_1012, parity_1006, parity_985_s10_q, xor_940_s10_q, xor_845_s10_q} : 6'h0;
  logic [5:0] column;
  assign column = or_582_s10_q ? 6'h0 : select_1014;
  // hls/stages/count_bits.hpp:25
  logic or_1238;
  assign or_1238 = and_1235_s10_q | and_1237_s10_q;
  logic or_1242;
  assign or_1242 = and_1239_s10_q | and_1241_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1255;
  assign parity_1255 = ^{or_1250_s10_q, or_1246_s10_q, or_1242, or_1238};
  // hls/stages/count_bits.hpp:25
  logic or_1259;
  assign or_1259 = (or_1246_s10_q & or_1250_s10_q) | (or_1242 & (or_1246_s10_q | or_1250_s10_q));
  logic and_1260;
  assign and_1260 = or_1238 & (^{or_1250_s10_q, or_1246_s10_q, or_1242});
  // hls/stages/count_bits.hpp:24
  logic xor_1261;
  assign xor_1261 = or_1259 ^ and_1260;
  // hls/stages/count_bits.hpp:27
  logic and_1262;
  assign and_1262 = or_1259 & and_1260;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1263;
  assign select_1263 = equal_596_s10_q ? {and_1262, xor_1261, parity_1255, parity_1234_s10_q, xor_1189_s10_q, xor_1094_s10_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_582_s10_q ? 6'h0 : select_1263;
  // hls/stages/count_bits.hpp:25
  logic or_1487;
  assign or_1487 = and_1484_s10_q | and_1486_s10_q;
  logic or_1491;
  assign or_1491 = and_1488_s10_q | and_1490_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1504;
  assign parity_1504 = ^{or_1499_s10_q, or_1495_s10_q, or_1491, or_1487};
  // hls/stages/count_bits.hpp:25
  logic or_1508;
  assign or_1508 = (or_1495_s10_q & or_1499_s10_q) | (or_1491 & (or_1495_s10_q | or_1499_s10_q));
  logic and_1509;
  assign and_1509 = or_1487 & (^{or_1499_s10_q, or_1495_s10_q, or_1491});
  // hls/stages/count_bits.hpp:24
  logic xor_1510;
  assign xor_1510 = or_1508 ^ and_1509;
  // hls/stages/count_bits.hpp:27
  logic and_1511;
  assign and_1511 = or_1508 & and_1509;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1512;
  assign select_1512 = equal_596_s10_q ? {and_1511, xor_1510, parity_1504, parity_1483_s10_q, xor_1438_s10_q, xor_1343_s10_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_582_s10_q ? 6'h0 : select_1512;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_2;
  assign before_v_2 = age_s10_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1548;
  assign sum_1548 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_3;
  assign before_v_3 = age_s10_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1551;
  assign sum_1551 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:1022
  logic [5:0] sum_1655;
  assign sum_1655 = {1'b0, last_s10_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:263
  logic right_2;
  assign right_2 = inside_v & ({1'b0, sum_1655, last_s10_q[1]} < x_s10_q);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1736;
  assign sum_1736 = {2'h0, x_s10_q} + {{4{b_s10_q[5]}}, b_s10_q};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1774;
  assign sum_1774 = {registration_slope_s10_q[11], registration_slope_s10_q} + {{5{sum_1773_s10_q[7]}}, sum_1773_s10_q};
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_1797_s10_q ? (patches_second_s10_q ? 8'h0 : patches_right_0_rdata_s10_q) : 8'h0;
  // hls/stages/patches.hpp:471
  logic [8:0] sum_1923;
  assign sum_1923 = {1'b0, patches_columns_above_rdata_s10_q[23:16]} + {3'h0, patches_columns_above_rdata_s10_q[31:26]};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2769;
  assign select_2769 = ({wide_s10_q, 1'b0} < size_3_s10_q) ? {wide_s10_q, 1'b0} : size_3_s10_q;
  logic [8:0] taken;
  assign taken = ~select_2769;
  // hls/stages/patches.hpp:110
  logic [5:0] select_3015;
  assign select_3015 = right_3_s10_q ? last_s10_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s10_q} + {1'b0, select_3015};

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
  logic patches_read_searches_s11_q;
  logic done_s11_q;
  logic [3:0] select_511_s11_q;
  logic equal_512_s11_q;
  logic row_starts_s11_q;
  logic [8:0] select_516_s11_q;
  logic and_525_s11_q;
  logic equal_531_s11_q;
  logic [6:0] select_546_s11_q;
  logic [6:0] last_s11_q;
  logic and_550_s11_q;
  logic and_552_s11_q;
  logic equal_571_s11_q;
  logic equal_577_s11_q;
  logic so_s11_q;
  logic equal_581_s11_q;
  logic or_582_s11_q;
  logic less_585_s11_q;
  logic not_586_s11_q;
  logic inside_v_s11_q;
  logic and_610_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic [6:0] select_628_s11_q;
  logic [6:0] right_s11_q;
  logic [28:0] best_right_rdata_s11_q;
  logic and_642_s11_q;
  logic and_645_s11_q;
  logic and_651_s11_q;
  logic and_653_s11_q;
  logic equal_686_s11_q;
  logic [5:0] column_s11_q;
  logic [5:0] select_1265_s11_q;
  logic [5:0] select_1514_s11_q;
  logic [6:0] sum_1549_s11_q;
  logic [6:0] sum_1552_s11_q;
  logic and_1569_s11_q;
  logic equal_1570_s11_q;
  logic or_1590_s11_q;
  logic right_2_s11_q;
  logic and_1693_s11_q;
  logic right_3_s11_q;
  logic less_1707_s11_q;
  logic [5:0] b_s11_q;
  logic less_1728_s11_q;
  logic not_1732_s11_q;
  logic less_1737_s11_q;
  logic less_1738_s11_q;
  logic [7:0] sum_1774_s11_q;
  logic less_1775_s11_q;
  logic less_1776_s11_q;
  logic equal_1785_s11_q;
  logic equal_1792_s11_q;
  logic not_1793_s11_q;
  logic equal_1794_s11_q;
  logic not_1795_s11_q;
  logic equal_1796_s11_q;
  logic equal_1797_s11_q;
  logic or_1798_s11_q;
  logic not_1799_s11_q;
  logic [4:0] select_1822_s11_q;
  logic select_1828_s11_q;
  logic [7:0] patches_left_rdata_s11_q;
  logic [3:0] select_1866_s11_q;
  logic and_1876_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic [7:0] select_1880_s11_q;
  logic [8:0] sum_1923_s11_q;
  logic less_1970_s11_q;
  logic equal_1971_s11_q;
  logic or_1973_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_1997_s11_q;
  logic not_2007_s11_q;
  logic and_2021_s11_q;
  logic not_2061_s11_q;
  logic less_2139_s11_q;
  logic not_2143_s11_q;
  logic equal_2293_s11_q;
  logic equal_2482_s11_q;
  logic and_2588_s11_q;
  logic and_2619_s11_q;
  logic equal_2708_s11_q;
  logic less_2753_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] taken_s11_q;
  logic [7:0] not_2771_s11_q;
  logic less_2792_s11_q;
  logic not_3018_s11_q;
  logic or_3072_s11_q;
  logic not_3096_s11_q;
  logic equal_3588_s11_q;
  logic less_3844_s11_q;
  logic equal_3916_s11_q;
  logic or_4066_s11_q;
  logic and_4080_s11_q;
  logic and_4097_s11_q;
  logic not_4109_s11_q;
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
      patches_read_searches_s11_q <= patches_read_searches_s10_q;
      done_s11_q <= done_s10_q;
      select_511_s11_q <= select_511_s10_q;
      equal_512_s11_q <= equal_512_s10_q;
      row_starts_s11_q <= row_starts_s10_q;
      select_516_s11_q <= select_516_s10_q;
      and_525_s11_q <= and_525_s10_q;
      equal_531_s11_q <= equal_531_s10_q;
      select_546_s11_q <= select_546_s10_q;
      last_s11_q <= last_s10_2_q;
      and_550_s11_q <= and_550_s10_q;
      and_552_s11_q <= and_552_s10_q;
      equal_571_s11_q <= equal_571_s10_q;
      equal_577_s11_q <= equal_577_s10_q;
      so_s11_q <= so_s10_q;
      equal_581_s11_q <= equal_581_s10_q;
      or_582_s11_q <= or_582_s10_q;
      less_585_s11_q <= less_585_s10_q;
      not_586_s11_q <= not_586_s10_q;
      inside_v_s11_q <= inside_v;
      and_610_s11_q <= and_610_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_628_s11_q <= select_628_s10_q;
      right_s11_q <= right_s10_q;
      best_right_rdata_s11_q <= best_right_rdata_q;
      and_642_s11_q <= and_642_s10_q;
      and_645_s11_q <= and_645_s10_q;
      and_651_s11_q <= and_651_s10_q;
      and_653_s11_q <= and_653_s10_q;
      equal_686_s11_q <= equal_686_s10_q;
      column_s11_q <= column;
      select_1265_s11_q <= age_s10_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1514_s11_q <= age_s10_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1549_s11_q <= {1'b0, before_v_2} + sum_1548;
      sum_1552_s11_q <= {1'b0, before_v_3} + sum_1551;
      and_1569_s11_q <= and_1569_s10_q;
      equal_1570_s11_q <= equal_1570_s10_q;
      or_1590_s11_q <= or_1590_s10_q;
      right_2_s11_q <= right_2;
      and_1693_s11_q <= and_1693_s10_q;
      right_3_s11_q <= right_3_s10_q;
      less_1707_s11_q <= less_1707_s10_q;
      b_s11_q <= b_s10_q;
      less_1728_s11_q <= {3'h0, last_s10_q[6:1]} < ({1'b0, x_s10_q} + 9'h1);
      not_1732_s11_q <= ~(x_s10_q < {1'b0, last_s10_q});
      less_1737_s11_q <= $signed(10'h0) < $signed(sum_1736);
      less_1738_s11_q <= $signed(sum_1736) < $signed({3'h0, last_s10_q});
      sum_1774_s11_q <= sum_1774[7:0];
      less_1775_s11_q <= $signed(6'h0) < $signed(sum_1774[12:7]);
      less_1776_s11_q <= $signed(sum_1774[12:7]) < $signed(6'h3f);
      equal_1785_s11_q <= x_s10_q == {1'b0, last_s10_q};
      equal_1792_s11_q <= equal_1792_s10_q;
      not_1793_s11_q <= not_1793_s10_q;
      equal_1794_s11_q <= equal_1794_s10_q;
      not_1795_s11_q <= not_1795_s10_q;
      equal_1796_s11_q <= equal_1796_s10_q;
      equal_1797_s11_q <= equal_1797_s10_q;
      or_1798_s11_q <= or_1798_s10_q;
      not_1799_s11_q <= not_1799_s10_q;
      select_1822_s11_q <= select_1822_s10_q;
      select_1828_s11_q <= select_1828_s10_q;
      patches_left_rdata_s11_q <= patches_left_rdata_q;
      select_1866_s11_q <= select_1866_s10_q;
      and_1876_s11_q <= and_1876_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_s10_q;
      select_1880_s11_q <= patches_second_s10_q ? patches_right_1_rdata_s10_q : pixel;
      sum_1923_s11_q <= sum_1923;
      less_1970_s11_q <= less_1970_s10_q;
      equal_1971_s11_q <= equal_1971_s10_q;
      or_1973_s11_q <= or_1973_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_1997_s11_q <= sum_1997_s10_q;
      not_2007_s11_q <= not_2007_s10_q;
      and_2021_s11_q <= and_2021_s10_q;
      not_2061_s11_q <= not_2061_s10_q;
      less_2139_s11_q <= less_2139_s10_q;
      not_2143_s11_q <= ~({sum_1655, last_s10_q[1:0]} < x_s10_q);
      equal_2293_s11_q <= equal_2293_s10_q;
      equal_2482_s11_q <= equal_2482_s10_q;
      and_2588_s11_q <= and_2588_s10_q;
      and_2619_s11_q <= and_2619_s10_q;
      equal_2708_s11_q <= equal_2708_s10_q;
      less_2753_s11_q <= slot_s10_q < 3'h3;
      wide_s11_q <= wide_s10_q;
      taken_s11_q <= taken;
      not_2771_s11_q <= ~wide_s10_q;
      less_2792_s11_q <= less_2792_s10_q;
      not_3018_s11_q <= ~(x_s10_q < {1'b0, from});
      or_3072_s11_q <= or_3072_s10_q;
      not_3096_s11_q <= not_3096_s10_q;
      equal_3588_s11_q <= equal_3588_s10_q;
      less_3844_s11_q <= less_3844_s10_q;
      equal_3916_s11_q <= equal_3916_s10_q;
      or_4066_s11_q <= or_4066_s10_q;
      and_4080_s11_q <= and_4080_s10_q;
      and_4097_s11_q <= and_4097_s10_q;
      not_4109_s11_q <= not_4109_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  logic [13:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
  logic draws_late_q;
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
  // hls/stages/census.hpp:127
  logic and_526;
  assign and_526 = sample_pair_whole_s11_q & and_525_s11_q;
  // hls/stages/patches.hpp:106
  logic equal_572;
  assign equal_572 = x_s11_q == 8'h0;
  // hls/stages/agreement.hpp:260
  logic first;
  assign first = equal_571_s11_q & equal_572;
  // hls/stages/moments.hpp:68
  logic [13:0] select_575;
  assign select_575 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:1022
  logic not_578;
  assign not_578 = ~equal_577_s11_q;
  // hls/stages/agreement.hpp:202
  logic not_580;
  assign not_580 = ~so_s11_q;
  // hls/stages/agreement.hpp:989
  logic [6:0] chosen;
  assign chosen = slot_s11_q[2] ? best_right_rdata_s11_q[14:8] : best_right_rdata_s11_q[28:22];
  // hls/stages/agreement.hpp:817
  logic or_767;
  assign or_767 = shift_first_s11_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1016;
  assign select_1016 = age_s11_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v;
  assign before_v = age_s11_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1544;
  assign sum_1544 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:761
  logic [6:0] select_1554;
  assign select_1554 = (sum_1549_s11_q < sum_1552_s11_q) ? sum_1552_s11_q : sum_1549_s11_q;
  // hls/stages/agreement.hpp:798
  logic and_1580;
  assign and_1580 = ends_cell_s11_q & inside_v_s11_q;
  logic and_1582;
  assign and_1582 = not_578 & (so_s11_q & and_1580);
  logic and_1706;
  assign and_1706 = not_578 & (so_s11_q & (ends_cell_s11_q & (inside_v_s11_q & right_3_s11_q)));
  // hls/stages/registration.hpp:83
  logic equal_1708;
  assign equal_1708 = slot_s11_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1711;
  assign select_1711 = b_s11_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1712;
  assign select_1712 = b_s11_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1713;
  assign sum_1713 = {{2{select_1711[6]}}, select_1711} + {select_1712[7], select_1712};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1714;
  assign select_1714 = b_s11_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1715;
  assign select_1715 = b_s11_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1716;
  assign sum_1716 = {{2{select_1714[7]}}, select_1714[7:1]} + {select_1715[7], select_1715};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1718;
  assign select_1718 = b_s11_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1719;
  assign select_1719 = b_s11_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1720;
  assign difference_1720 = {{2{select_1718[7]}}, select_1718[7:1]} - {select_1719[7], select_1719};
  // hls/stages/patches.hpp:104
  logic and_1730;
  assign and_1730 = less_1728_s11_q & (~right_3_s11_q);
  // hls/stages/agreement.hpp:1031
  logic and_1740;
  assign and_1740 = (~(and_1730 | (equal_572 | not_1732_s11_q))) & (less_1737_s11_q & less_1738_s11_q);
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1756;
  assign select_1756 = so_s11_q ? (ends_cell_s11_q ? (inside_v_s11_q ? b_s11_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1778;
  assign select_1778 = less_1775_s11_q ? 8'h7f : (less_1776_s11_q ? 8'h80 : sum_1774_s11_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1708 ? registration_slope_here_q : select_1778;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1782;
  assign select_1782 = so_s11_q ? (ends_cell_s11_q ? (inside_v_s11_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1788;
  assign and_1788 = ends_cell_s11_q & (inside_v_s11_q & (and_1730 | equal_1785_s11_q));
  logic and_1790;
  assign and_1790 = not_578 & (so_s11_q & and_1788);
  // hls/stages/patches.hpp:174
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1797_s11_q ? select_1880_s11_q : patches_left_rdata_s11_q;
  // hls/stages/patches.hpp:471
  logic [9:0] sum_1924;
  assign sum_1924 = {2'h0, patches_columns_above_rdata_s11_q[15:8]} + {1'b0, sum_1923_s11_q};
  // hls/stages/agreement.hpp:1125
  logic not_2141;
  assign not_2141 = ~(x_s11_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:798
  logic select_2147;
  assign select_2147 = less_2139_s11_q ? (not_2141 & not_2143_s11_q) : ((draws_late_q & not_2141) & not_2143_s11_q);
  logic and_2345;
  assign and_2345 = not_578 & (not_580 & (equal_581_s11_q & (inside_v_s11_q & first)));
  // hls/stages/agreement.hpp:530
  logic select_2590;
  assign select_2590 = and_552_s11_q ? (equal_2482_s11_q ? and_2588_s11_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:240
  logic [5:0] select_2592;
  assign select_2592 = slot_s11_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2593;
  assign select_2593 = slot_s11_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2594;
  assign select_2594 = slot_s11_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2595;
  assign select_2595 = slot_s11_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2596;
  assign select_2596 = slot_s11_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2597;
  assign select_2597 = slot_s11_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:996
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s11_q[61:54]} - {1'b0, best_left_rdata_s11_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2764;
  assign not_2764 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2753_s11_q ? {1'b0, wide_s11_q, 1'b0} : {registration_displacement_over_q[8:0], not_2764};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2772;
  assign select_2772 = registration_displacement_over_q[9] ? wide_s11_q : not_2771_s11_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2753_s11_q ? {taken_s11_q, 1'b1} : {not_2764, select_2772, not_2764};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2774;
  assign sum_2774 = {left, 1'b1} + {taken_2, less_2753_s11_q};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_2776;
  assign select_2776 = so_s11_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2778;
  assign select_2778 = equal_577_s11_q ? registration_slope_here_q : (so_s11_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:150
  logic [2:0] select_2787;
  assign select_2787 = or_582_s11_q ? (less_585_s11_q ? 3'h0 : best_left_rdata_s11_q[8:6]) : 3'h0;
  // hls/stages/agreement.hpp:798
  logic and_3022;
  assign and_3022 = not_578 & (so_s11_q & (ends_cell_s11_q & (inside_v_s11_q & not_3018_s11_q)));
  // hls/stages/patches.hpp:559
  logic [9:0] select_3539;
  assign select_3539 = less_1970_s11_q ? (or_1973_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3542;
  assign select_3542 = less_1970_s11_q ? (or_1973_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0) : 5'h0;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:238; read in stage 11, written in stage 14: 11 < 14 < 11 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_516_s11_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s11_en & and_526;
`endif
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1422; read in stage 11, written in stage 15: 11 < 15 < 11 + DISTANCE.
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
  assign seen_columns_re = s11_en & and_1582;
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
      draws_late_q <= 1'b0;
      shift_not_right_q <= 1'b0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
    end else if (s11_en) begin
      moments_place_q <= select_575;
      moments_taken_q <= not_578 & (not_580 & (equal_581_s11_q & inside_v_s11_q));
      moments_starts_q <= and_2345;
      draws_late_q <= select_2590;
      shift_not_right_q <= $signed(run_shift_s11_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s11_q ? sum_2774[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2776;
      registration_slope_here_q <= select_2778;
      patches_read_row_differing_q <= equal_1792_s11_q ? select_3539 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1792_s11_q ? select_3542 : patches_read_row_column_q;
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
      middle_sum_columns_values_1_q <= select_2592;
      middle_sum_columns_values_2_q <= select_2593;
      middle_sum_columns_values_3_q <= select_2594;
      middle_sum_columns_values_4_q <= select_2595;
      middle_sum_columns_values_5_q <= select_2596;
      middle_sum_columns_values_6_q <= select_2597;
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
  logic draws_late_s12_q;
  logic shift_not_right_s12_q;
  logic [4:0] patches_band_rows_number_s12_q;
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
  logic [3:0] select_511_s12_q;
  logic equal_512_s12_q;
  logic row_starts_s12_q;
  logic [8:0] select_516_s12_q;
  logic and_525_s12_q;
  logic and_526_s12_q;
  logic equal_531_s12_q;
  logic [6:0] select_546_s12_q;
  logic [6:0] last_s12_q;
  logic and_550_s12_q;
  logic and_552_s12_q;
  logic equal_572_s12_q;
  logic first_s12_q;
  logic equal_577_s12_q;
  logic not_578_s12_q;
  logic so_s12_q;
  logic not_580_s12_q;
  logic equal_581_s12_q;
  logic or_582_s12_q;
  logic less_585_s12_q;
  logic not_586_s12_q;
  logic inside_v_s12_q;
  logic and_610_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic less_621_s12_q;
  logic [6:0] select_628_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic [6:0] chosen_s12_q;
  logic and_642_s12_q;
  logic and_645_s12_q;
  logic and_651_s12_q;
  logic and_653_s12_q;
  logic equal_686_s12_q;
  logic select_769_s12_q;
  logic [6:0] difference_1017_s12_q;
  logic [6:0] difference_1266_s12_q;
  logic equal_1267_s12_q;
  logic [6:0] difference_1515_s12_q;
  logic [6:0] sum_1545_s12_q;
  logic [6:0] select_1554_s12_q;
  logic and_1569_s12_q;
  logic select_1571_s12_q;
  logic and_1580_s12_q;
  logic and_1582_s12_q;
  logic or_1590_s12_q;
  logic and_1599_s12_q;
  logic right_2_s12_q;
  logic and_1693_s12_q;
  logic and_1706_s12_q;
  logic less_1707_s12_q;
  logic equal_1708_s12_q;
  logic [7:0] sum_1713_s12_q;
  logic select_1714_s12_q;
  logic [8:0] sum_1716_s12_q;
  logic select_1718_s12_q;
  logic [8:0] difference_1720_s12_q;
  logic and_1740_s12_q;
  logic [5:0] select_1757_s12_q;
  logic [7:0] select_1783_s12_q;
  logic equal_1785_s12_q;
  logic and_1790_s12_q;
  logic and_1791_s12_q;
  logic equal_1792_s12_q;
  logic not_1793_s12_q;
  logic equal_1794_s12_q;
  logic not_1795_s12_q;
  logic equal_1796_s12_q;
  logic equal_1797_s12_q;
  logic or_1798_s12_q;
  logic not_1799_s12_q;
  logic [4:0] select_1822_s12_q;
  logic select_1828_s12_q;
  logic [3:0] select_1866_s12_q;
  logic and_1876_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] pixel_2_s12_q;
  logic [9:0] sum_1924_s12_q;
  logic less_1970_s12_q;
  logic equal_1971_s12_q;
  logic or_1973_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1997_s12_q;
  logic not_2007_s12_q;
  logic and_2021_s12_q;
  logic not_2061_s12_q;
  logic and_2148_s12_q;
  logic equal_2293_s12_q;
  logic equal_2482_s12_q;
  logic and_2588_s12_q;
  logic and_2619_s12_q;
  logic equal_2708_s12_q;
  logic rise_s12_q;
  logic [7:0] xor_2713_s12_q;
  logic select_2787_s12_q;
  logic or_2790_s12_q;
  logic [1:0] sum_2791_s12_q;
  logic less_2792_s12_q;
  logic and_3022_s12_q;
  logic or_3072_s12_q;
  logic not_3096_s12_q;
  logic equal_3588_s12_q;
  logic less_3844_s12_q;
  logic equal_3916_s12_q;
  logic or_4066_s12_q;
  logic and_4080_s12_q;
  logic and_4097_s12_q;
  logic not_4109_s12_q;
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
      draws_late_s12_q <= draws_late_q;
      shift_not_right_s12_q <= shift_not_right_q;
      patches_band_rows_number_s12_q <= patches_band_rows_number_s11_q;
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
      select_511_s12_q <= select_511_s11_q;
      equal_512_s12_q <= equal_512_s11_q;
      row_starts_s12_q <= row_starts_s11_q;
      select_516_s12_q <= select_516_s11_q;
      and_525_s12_q <= and_525_s11_q;
      and_526_s12_q <= and_526;
      equal_531_s12_q <= equal_531_s11_q;
      select_546_s12_q <= select_546_s11_q;
      last_s12_q <= last_s11_q;
      and_550_s12_q <= and_550_s11_q;
      and_552_s12_q <= and_552_s11_q;
      equal_572_s12_q <= equal_572;
      first_s12_q <= first;
      equal_577_s12_q <= equal_577_s11_q;
      not_578_s12_q <= not_578;
      so_s12_q <= so_s11_q;
      not_580_s12_q <= not_580;
      equal_581_s12_q <= equal_581_s11_q;
      or_582_s12_q <= or_582_s11_q;
      less_585_s12_q <= less_585_s11_q;
      not_586_s12_q <= not_586_s11_q;
      inside_v_s12_q <= inside_v_s11_q;
      and_610_s12_q <= and_610_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      less_621_s12_q <= 8'hb6 < best_left_rdata_s11_q[16:9];
      select_628_s12_q <= select_628_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_s11_q;
      chosen_s12_q <= chosen;
      and_642_s12_q <= and_642_s11_q;
      and_645_s12_q <= and_645_s11_q;
      and_651_s12_q <= and_651_s11_q;
      and_653_s12_q <= and_653_s11_q;
      equal_686_s12_q <= equal_686_s11_q;
      select_769_s12_q <= or_767 ? shift_first_s11_q : (~age_s11_q[1]);
      difference_1017_s12_q <= {1'b0, column_s11_q} - {1'b0, select_1016};
      difference_1266_s12_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1265_s11_q};
      equal_1267_s12_q <= {age_s11_q[0], slot_s11_q[0]} == 2'h0;
      difference_1515_s12_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1514_s11_q};
      sum_1545_s12_q <= {1'b0, before_v} + sum_1544;
      select_1554_s12_q <= select_1554;
      and_1569_s12_q <= and_1569_s11_q;
      select_1571_s12_q <= or_767 ? shift_first_s11_q : equal_1570_s11_q;
      and_1580_s12_q <= and_1580;
      and_1582_s12_q <= and_1582;
      or_1590_s12_q <= or_1590_s11_q;
      and_1599_s12_q <= or_582_s11_q & (slot_s11_q[2] & not_586_s11_q);
      right_2_s12_q <= right_2_s11_q;
      and_1693_s12_q <= and_1693_s11_q;
      and_1706_s12_q <= and_1706;
      less_1707_s12_q <= less_1707_s11_q;
      equal_1708_s12_q <= equal_1708;
      sum_1713_s12_q <= sum_1713[8:1];
      select_1714_s12_q <= select_1714[0];
      sum_1716_s12_q <= sum_1716;
      select_1718_s12_q <= select_1718[0];
      difference_1720_s12_q <= difference_1720;
      and_1740_s12_q <= and_1740;
      select_1757_s12_q <= equal_577_s11_q ? 6'h0 : select_1756;
      select_1783_s12_q <= equal_577_s11_q ? 8'h0 : select_1782;
      equal_1785_s12_q <= equal_1785_s11_q;
      and_1790_s12_q <= and_1790;
      and_1791_s12_q <= patches_chooses_s11_q & and_1790;
      equal_1792_s12_q <= equal_1792_s11_q;
      not_1793_s12_q <= not_1793_s11_q;
      equal_1794_s12_q <= equal_1794_s11_q;
      not_1795_s12_q <= not_1795_s11_q;
      equal_1796_s12_q <= equal_1796_s11_q;
      equal_1797_s12_q <= equal_1797_s11_q;
      or_1798_s12_q <= or_1798_s11_q;
      not_1799_s12_q <= not_1799_s11_q;
      select_1822_s12_q <= select_1822_s11_q;
      select_1828_s12_q <= select_1828_s11_q;
      select_1866_s12_q <= select_1866_s11_q;
      and_1876_s12_q <= and_1876_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      pixel_2_s12_q <= pixel_2;
      sum_1924_s12_q <= sum_1924;
      less_1970_s12_q <= less_1970_s11_q;
      equal_1971_s12_q <= equal_1971_s11_q;
      or_1973_s12_q <= or_1973_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_1997_s12_q <= sum_1997_s11_q;
      not_2007_s12_q <= not_2007_s11_q;
      and_2021_s12_q <= and_2021_s11_q;
      not_2061_s12_q <= not_2061_s11_q;
      and_2148_s12_q <= ends_cell_s11_q & select_2147;
      equal_2293_s12_q <= equal_2293_s11_q;
      equal_2482_s12_q <= equal_2482_s11_q;
      and_2588_s12_q <= and_2588_s11_q;
      and_2619_s12_q <= and_2619_s11_q;
      equal_2708_s12_q <= equal_2708_s11_q;
      rise_s12_q <= rise[8];
      xor_2713_s12_q <= rise[7:0] ^ {8{rise[8]}};
      select_2787_s12_q <= select_2787[0];
      or_2790_s12_q <= (select_2787 == 3'h0) | (select_2787 == 3'h4);
      sum_2791_s12_q <= select_2787[2:1] + 2'h3;
      less_2792_s12_q <= less_2792_s11_q;
      and_3022_s12_q <= and_3022;
      or_3072_s12_q <= or_3072_s11_q;
      not_3096_s12_q <= not_3096_s11_q;
      equal_3588_s12_q <= equal_3588_s11_q;
      less_3844_s12_q <= less_3844_s11_q;
      equal_3916_s12_q <= equal_3916_s11_q;
      or_4066_s12_q <= or_4066_s11_q;
      and_4080_s12_q <= and_4080_s11_q;
      and_4097_s12_q <= and_4097_s11_q;
      not_4109_s12_q <= not_4109_s11_q;
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
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic patches_read_first_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  // hls/stages/census.hpp:117
  logic [13:0] select_529;
  assign select_529 = equal_512_s12_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_535;
  assign sum_535 = {6'h0, sample_pair_pixel_1_q} + (equal_512_s12_q ? 14'h0 : averager_running_1_q);
  // hls/stages/moments.hpp:74
  logic [10:0] place;
  assign place = first_s12_q ? 11'h0 : moments_place_q[13:3];
  // hls/stages/moments.hpp:131
  logic not_590;
  assign not_590 = ~(11'h3ec < place);
  // hls/stages/agreement.hpp:988
  logic select_623;
  assign select_623 = slot_s12_q[2] ? less_621_s12_q : (6'h2a < best_left_rdata_s12_q[39:34]);
  // hls/stages/agreement.hpp:1002
  logic [8:0] difference_633;
  assign difference_633 = {2'h0, chosen_s12_q} - {1'b0, x_s12_q};
  // hls/stages/agreement.hpp:788
  logic [7:0] sum_1019;
  assign sum_1019 = {difference_1017_s12_q[6], difference_1017_s12_q} + (age_s12_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1269;
  assign sum_1269 = {difference_1266_s12_q[6], difference_1266_s12_q} + (equal_1267_s12_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1517;
  assign sum_1517 = {difference_1515_s12_q[6], difference_1515_s12_q} + (equal_1267_s12_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:765
  logic [6:0] select_1546;
  assign select_1546 = slot_s12_q[0] ? chosen_near_q : sum_1545_s12_q;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_1556;
  assign select_1556 = (select_1546 < select_1554_s12_q) ? select_1554_s12_q : select_1546;
  // hls/stages/agreement.hpp:798
  logic [6:0] select_1586;
  assign select_1586 = so_s12_q ? x_s12_q[6:0] : (or_582_s12_q ? (less_585_s12_q ? 7'h0 : select_628_s12_q) : 7'h0);
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1717;
  assign sum_1717 = {{3{sum_1713_s12_q[7]}}, sum_1713_s12_q} + {sum_1716_s12_q[8], sum_1716_s12_q, select_1714_s12_q};
  logic [9:0] sum_1721;
  assign sum_1721 = {difference_1720_s12_q, select_1718_s12_q} + {sum_1717[10], sum_1717[10:2]};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_1904;
  assign sum_1904 = {1'b0, patches_columns_above_rdata_s12_q[7:0]} + {2'h0, pixel_2_s12_q[7:1]};
  logic [8:0] sum_1905;
  assign sum_1905 = {1'b0, patches_columns_above_rdata_s12_q[23:16]} + {2'h0, patches_columns_above_rdata_s12_q[31:25]};
  // hls/stages/patches.hpp:471
  logic [10:0] sum_1925;
  assign sum_1925 = {3'h0, patches_columns_above_rdata_s12_q[15:8]} + {sum_1924_s12_q, patches_columns_above_rdata_s12_q[25]};
  // hls/stages/agreement.hpp:240
  logic [6:0] select_2604;
  assign select_2604 = slot_s12_q[0] ? 7'h0 : sum_1545_s12_q;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_2606;
  assign select_2606 = (select_2604 < select_1554_s12_q) ? select_1554_s12_q : select_2604;
  // hls/stages/agreement.hpp:997
  logic [7:0] lower;
  assign lower = rise_s12_q ? best_left_rdata_s12_q[61:54] : best_left_rdata_s12_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2793;
  assign difference_2793 = {sum_2791_s12_q, select_2787_s12_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2794;
  assign select_2794 = less_2792_s12_q ? difference_2793 : {sum_2791_s12_q, select_2787_s12_q, registration_displacement_fraction_q};
  logic [7:0] select_2795;
  assign select_2795 = or_2790_s12_q ? {sum_2791_s12_q, select_2787_s12_q, 5'h0} : select_2794;
  // hls/stages/patches.hpp:191
  logic select_3111;
  assign select_3111 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:177
  logic and_3172;
  assign and_3172 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3177;
  assign select_3177 = or_3072_s12_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3179;
  assign select_3179 = and_3172 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:276
  logic select_3550;
  assign select_3550 = equal_1792_s12_q ? (less_1970_s12_q & (or_1973_s12_q & (patches_step_s12_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3555;
  assign or_3555 = patches_read_first_q | (patches_read_row_differing_s12_q < patches_peak_best_differing_q);
  logic and_3556;
  assign and_3556 = patches_read_searches_s12_q & or_3555;
  // hls/stages/patches.hpp:542
  logic [14:0] select_3576;
  assign select_3576 = and_3556 ? {patches_read_row_column_s12_q, patches_read_row_differing_s12_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3577;
  assign select_3577 = equal_1792_s12_q ? select_3576[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3578;
  assign select_3578 = equal_1792_s12_q ? select_3576[14:10] : patches_peak_best_column_q;
  // hls/stages/agreement.hpp:499
  logic [8:0] select_3846;
  assign select_3846 = equal_686_s12_q ? {difference_3845[7], difference_3845} : region_down_rest_q;
  // hls/stages/division.hpp:18
  logic [7:0] sum_3847;
  assign sum_3847 = select_3846[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3869;
  assign select_3869 = equal_2482_s12_q ? (less_3844_s12_q ? region_down_next_q : select_3846) : region_down_rest_q;
  // hls/stages/agreement.hpp:499
  logic [7:0] select_3872;
  assign select_3872 = equal_686_s12_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_3874;
  assign select_3874 = and_552_s12_q ? (equal_2482_s12_q ? select_3872 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3875;
  assign sum_3875 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:36
  logic [8:0] select_3877;
  assign select_3877 = sum_3875[7] ? {1'b1, sum_3875[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1394; read in stage 12, written in stage 15: 12 < 15 < 12 + DISTANCE.
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
  assign shown_right_re = s12_en & and_1582_s12_q;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1395; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
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
  assign left_turns_re = s12_en & and_1599_s12_q;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1395; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_628_s12_q;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s12_en & and_1599_s12_q;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s12_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s12_en & and_1876_s12_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_s12_q[23:0], pixel_2_s12_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_columns_above_raddr_s9_sim;
  logic patches_columns_above_re_s9_sim;
  logic [4:0] patches_columns_above_raddr_s10_sim;
  logic patches_columns_above_re_s10_sim;
  logic [4:0] patches_columns_above_raddr_s11_sim;
  logic patches_columns_above_re_s11_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_columns_above_re_s9_sim <= 1'b0;
      patches_columns_above_re_s10_sim <= 1'b0;
      patches_columns_above_re_s11_sim <= 1'b0;
    end else if (en_i) begin
      patches_columns_above_re_s9_sim <= patches_columns_above_re;
      patches_columns_above_raddr_s9_sim <= patches_columns_above_raddr;
      patches_columns_above_re_s10_sim <= patches_columns_above_re_s9_sim;
      patches_columns_above_raddr_s10_sim <= patches_columns_above_raddr_s9_sim;
      patches_columns_above_re_s11_sim <= patches_columns_above_re_s10_sim;
      patches_columns_above_raddr_s11_sim <= patches_columns_above_raddr_s10_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s9_sim && patches_columns_above_raddr_s9_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s10_sim && patches_columns_above_raddr_s10_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s11_sim && patches_columns_above_raddr_s11_sim == patches_columns_above_waddr) begin
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
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
    end else if (s12_en) begin
      sample_pair_pixel_0_q <= pixel_0_s12_q;
      sample_pair_pixel_1_q <= pixel_1_s12_q;
      chosen_near_q <= select_2606;
      patches_along_ends_q <= not_3096_s12_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3096_s12_q & select_3111;
      patches_down_by_q <= or_3072_s12_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3172});
      patches_along_q <= select_3177;
      patches_match_row_q <= or_3072_s12_q ? 4'h0 : select_3179;
      patches_summed_last_q <= not_1793_s12_q & (equal_1794_s12_q & and_3172);
      patches_read_first_q <= select_3550;
      patches_peak_best_differing_q <= select_3577;
      patches_peak_best_column_q <= select_3578;
      region_down_rest_q <= and_552_s12_q ? select_3869 : region_down_rest_q;
      region_down_back_q <= select_3874;
      region_down_next_q <= select_3877;
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
      averager_running_0_q <= sample_pair_whole_s12_q ? select_529 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s12_q ? sum_535 : averager_running_1_q;
      middle_sum_sum_sums_values_0_q <= slot_s12_q[0] ? middle_sum_sum_sums_values_0_q : sum_1019;
      sums_0_sum_sums_values_0_q <= sum_1269;
      sums_0_sum_sums_values_1_q <= equal_1267_s12_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1517;
      sums_1_sum_sums_values_1_q <= equal_1267_s12_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic draws_late_s13_q;
  logic shift_not_right_s13_q;
  logic [4:0] patches_band_rows_number_s13_q;
  logic [4:0] patches_choosing_band_s13_q;
  logic patches_lower_s13_q;
  logic patches_second_s13_q;
  logic [4:0] patches_code_row_s13_q;
  logic [4:0] patches_column_s13_q;
  logic patches_match_row_ends_s13_q;
  logic [4:0] patches_down_by_s13_q;
  logic [4:0] patches_along_s13_q;
  logic [3:0] patches_match_row_s13_q;
  logic patches_summed_last_s13_q;
  logic [4:0] patches_step_s13_q;
  logic [9:0] patches_read_row_differing_s13_q;
  logic patches_read_first_s13_q;
  logic done_s13_q;
  logic [3:0] select_511_s13_q;
  logic equal_512_s13_q;
  logic row_starts_s13_q;
  logic [8:0] select_516_s13_q;
  logic and_525_s13_q;
  logic and_526_s13_q;
  logic [29:0] averager_memory_rdata_s13_q;
  logic [13:0] select_529_s13_q;
  logic equal_531_s13_q;
  logic [13:0] sum_535_s13_q;
  logic [6:0] select_546_s13_q;
  logic [6:0] last_s13_q;
  logic and_550_s13_q;
  logic and_552_s13_q;
  logic equal_572_s13_q;
  logic [12:0] select_576_s13_q;
  logic equal_577_s13_q;
  logic not_578_s13_q;
  logic so_s13_q;
  logic not_580_s13_q;
  logic equal_581_s13_q;
  logic or_582_s13_q;
  logic less_585_s13_q;
  logic not_586_s13_q;
  logic inside_v_s13_q;
  logic not_590_s13_q;
  logic and_593_s13_q;
  logic and_610_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_623_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic [9:0] sum_634_s13_q;
  logic and_642_s13_q;
  logic and_645_s13_q;
  logic and_651_s13_q;
  logic and_653_s13_q;
  logic equal_686_s13_q;
  logic select_769_s13_q;
  logic [7:0] sum_1019_s13_q;
  logic less_1518_s13_q;
  logic [6:0] select_1556_s13_q;
  logic [7:0] select_1564_s13_q;
  logic [7:0] select_1567_s13_q;
  logic and_1569_s13_q;
  logic select_1571_s13_q;
  logic and_1580_s13_q;
  logic and_1582_s13_q;
  logic [6:0] select_1586_s13_q;
  logic or_1590_s13_q;
  logic and_1608_s13_q;
  logic right_2_s13_q;
  logic and_1693_s13_q;
  logic and_1706_s13_q;
  logic less_1707_s13_q;
  logic equal_1708_s13_q;
  logic sum_1717_s13_q;
  logic [9:0] sum_1721_s13_q;
  logic and_1740_s13_q;
  logic [5:0] select_1757_s13_q;
  logic [7:0] select_1783_s13_q;
  logic equal_1785_s13_q;
  logic and_1790_s13_q;
  logic and_1791_s13_q;
  logic equal_1792_s13_q;
  logic not_1793_s13_q;
  logic equal_1794_s13_q;
  logic not_1795_s13_q;
  logic equal_1796_s13_q;
  logic equal_1797_s13_q;
  logic or_1798_s13_q;
  logic not_1799_s13_q;
  logic [4:0] select_1822_s13_q;
  logic select_1828_s13_q;
  logic [3:0] select_1866_s13_q;
  logic [8:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [4:0] sum_1890_s13_q;
  logic [8:0] sum_1904_s13_q;
  logic [8:0] sum_1905_s13_q;
  logic [10:0] sum_1925_s13_q;
  logic less_1970_s13_q;
  logic equal_1971_s13_q;
  logic or_1973_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1997_s13_q;
  logic not_2007_s13_q;
  logic and_2021_s13_q;
  logic [17:0] seen_columns_rdata_s13_q;
  logic not_2061_s13_q;
  logic and_2150_s13_q;
  logic equal_2293_s13_q;
  logic equal_2482_s13_q;
  logic and_2588_s13_q;
  logic and_2619_s13_q;
  logic equal_2708_s13_q;
  logic [7:0] lower_s13_q;
  logic [7:0] sum_2714_s13_q;
  logic [7:0] select_2795_s13_q;
  logic and_3022_s13_q;
  logic and_3556_s13_q;
  logic equal_3588_s13_q;
  logic less_3844_s13_q;
  logic sum_3847_s13_q;
  logic equal_3916_s13_q;
  logic or_4066_s13_q;
  logic and_4080_s13_q;
  logic and_4097_s13_q;
  logic not_4109_s13_q;
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
      draws_late_s13_q <= draws_late_s12_q;
      shift_not_right_s13_q <= shift_not_right_s12_q;
      patches_band_rows_number_s13_q <= patches_band_rows_number_s12_q;
      patches_choosing_band_s13_q <= patches_choosing_band_s12_q;
      patches_lower_s13_q <= patches_lower_s12_q;
      patches_second_s13_q <= patches_second_s12_q;
      patches_code_row_s13_q <= patches_code_row_s12_q;
      patches_column_s13_q <= patches_column_s12_q;
      patches_match_row_ends_s13_q <= patches_match_row_ends_q;
      patches_down_by_s13_q <= patches_down_by_q;
      patches_along_s13_q <= patches_along_q;
      patches_match_row_s13_q <= patches_match_row_q;
      patches_summed_last_s13_q <= patches_summed_last_q;
      patches_step_s13_q <= patches_step_s12_q;
      patches_read_row_differing_s13_q <= patches_read_row_differing_s12_q;
      patches_read_first_s13_q <= patches_read_first_q;
      done_s13_q <= done_s12_q;
      select_511_s13_q <= select_511_s12_q;
      equal_512_s13_q <= equal_512_s12_q;
      row_starts_s13_q <= row_starts_s12_q;
      select_516_s13_q <= select_516_s12_q;
      and_525_s13_q <= and_525_s12_q;
      and_526_s13_q <= and_526_s12_q;
      averager_memory_rdata_s13_q <= averager_memory_rdata_q;
      select_529_s13_q <= select_529;
      equal_531_s13_q <= equal_531_s12_q;
      sum_535_s13_q <= sum_535;
      select_546_s13_q <= select_546_s12_q;
      last_s13_q <= last_s12_q;
      and_550_s13_q <= and_550_s12_q;
      and_552_s13_q <= and_552_s12_q;
      equal_572_s13_q <= equal_572_s12_q;
      select_576_s13_q <= first_s12_q ? 13'h0 : moments_place_q[12:0];
      equal_577_s13_q <= equal_577_s12_q;
      not_578_s13_q <= not_578_s12_q;
      so_s13_q <= so_s12_q;
      not_580_s13_q <= not_580_s12_q;
      equal_581_s13_q <= equal_581_s12_q;
      or_582_s13_q <= or_582_s12_q;
      less_585_s13_q <= less_585_s12_q;
      not_586_s13_q <= not_586_s12_q;
      inside_v_s13_q <= inside_v_s12_q;
      not_590_s13_q <= not_590;
      and_593_s13_q <= not_580_s12_q & (equal_581_s12_q & (inside_v_s12_q & not_590));
      and_610_s13_q <= and_610_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q[45:0];
      select_623_s13_q <= select_623;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      sum_634_s13_q <= {difference_633[8], difference_633} + 10'h1;
      and_642_s13_q <= and_642_s12_q;
      and_645_s13_q <= and_645_s12_q;
      and_651_s13_q <= and_651_s12_q;
      and_653_s13_q <= and_653_s12_q;
      equal_686_s13_q <= equal_686_s12_q;
      select_769_s13_q <= select_769_s12_q;
      sum_1019_s13_q <= sum_1019;
      less_1518_s13_q <= sum_1269 < sum_1517;
      select_1556_s13_q <= select_1556;
      select_1564_s13_q <= select_769_s12_q ? 8'h0 : best_left_rdata_s12_q[53:46];
      select_1567_s13_q <= select_769_s12_q ? 8'h0 : best_left_rdata_s12_q[61:54];
      and_1569_s13_q <= and_1569_s12_q;
      select_1571_s13_q <= select_1571_s12_q;
      and_1580_s13_q <= and_1580_s12_q;
      and_1582_s13_q <= and_1582_s12_q;
      select_1586_s13_q <= select_1586;
      or_1590_s13_q <= or_1590_s12_q;
      and_1608_s13_q <= moments_taken_q;
      right_2_s13_q <= right_2_s12_q;
      and_1693_s13_q <= and_1693_s12_q;
      and_1706_s13_q <= and_1706_s12_q;
      less_1707_s13_q <= less_1707_s12_q;
      equal_1708_s13_q <= equal_1708_s12_q;
      sum_1717_s13_q <= sum_1717[1];
      sum_1721_s13_q <= sum_1721;
      and_1740_s13_q <= and_1740_s12_q;
      select_1757_s13_q <= select_1757_s12_q;
      select_1783_s13_q <= select_1783_s12_q;
      equal_1785_s13_q <= equal_1785_s12_q;
      and_1790_s13_q <= and_1790_s12_q;
      and_1791_s13_q <= and_1791_s12_q;
      equal_1792_s13_q <= equal_1792_s12_q;
      not_1793_s13_q <= not_1793_s12_q;
      equal_1794_s13_q <= equal_1794_s12_q;
      not_1795_s13_q <= not_1795_s12_q;
      equal_1796_s13_q <= equal_1796_s12_q;
      equal_1797_s13_q <= equal_1797_s12_q;
      or_1798_s13_q <= or_1798_s12_q;
      not_1799_s13_q <= not_1799_s12_q;
      select_1822_s13_q <= select_1822_s12_q;
      select_1828_s13_q <= select_1828_s12_q;
      select_1866_s13_q <= select_1866_s12_q;
      patches_columns_above_rdata_s13_q <= {patches_columns_above_rdata_s12_q[24], patches_columns_above_rdata_s12_q[7:0]};
      pixel_2_s13_q <= pixel_2_s12_q;
      sum_1890_s13_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1904_s13_q <= sum_1904;
      sum_1905_s13_q <= sum_1905;
      sum_1925_s13_q <= sum_1925;
      less_1970_s13_q <= less_1970_s12_q;
      equal_1971_s13_q <= equal_1971_s12_q;
      or_1973_s13_q <= or_1973_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1997_s13_q <= sum_1997_s12_q;
      not_2007_s13_q <= not_2007_s12_q;
      and_2021_s13_q <= and_2021_s12_q;
      seen_columns_rdata_s13_q <= seen_columns_rdata_q;
      not_2061_s13_q <= not_2061_s12_q;
      and_2150_s13_q <= not_578_s12_q & (so_s12_q & and_2148_s12_q);
      equal_2293_s13_q <= equal_2293_s12_q;
      equal_2482_s13_q <= equal_2482_s12_q;
      and_2588_s13_q <= and_2588_s12_q;
      and_2619_s13_q <= and_2619_s12_q;
      equal_2708_s13_q <= equal_2708_s12_q;
      lower_s13_q <= lower;
      sum_2714_s13_q <= {7'h0, rise_s12_q} + xor_2713_s12_q;
      select_2795_s13_q <= select_2795;
      and_3022_s13_q <= and_3022_s12_q;
      and_3556_s13_q <= and_3556;
      equal_3588_s13_q <= equal_3588_s12_q;
      less_3844_s13_q <= less_3844_s12_q;
      sum_3847_s13_q <= sum_3847[7];
      equal_3916_s13_q <= equal_3916_s12_q;
      or_4066_s13_q <= or_4066_s12_q;
      and_4080_s13_q <= and_4080_s12_q;
      and_4097_s13_q <= and_4097_s12_q;
      not_4109_s13_q <= not_4109_s12_q;
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
  logic [4:0] patches_summed_down_by_q;
  logic [4:0] patches_read_at_q;
  logic [4:0] patches_peak_row_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
  logic region_fresh_q;
  // hls/stages/census.hpp:129
  logic [13:0] sum_533;
  assign sum_533 = select_529_s13_q + (equal_531_s13_q ? 14'h0 : averager_memory_rdata_s13_q[13:0]);
  logic [13:0] sum_537;
  assign sum_537 = sum_535_s13_q + (equal_531_s13_q ? 14'h0 : averager_memory_rdata_s13_q[27:14]);
  // hls/stages/agreement.hpp:423
  logic whole;
  assign whole = equal_512_s13_q ? sample_present_s13_q : (sample_present_s13_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_512_s13_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:131
  logic and_545;
  assign and_545 = all_of_skin & (averager_memory_rdata_s13_q[29] | equal_531_s13_q);
  // hls/stages/agreement.hpp:798
  logic and_594;
  assign and_594 = not_578_s13_q & and_593_s13_q;
  // hls/stages/agreement.hpp:248
  logic and_636;
  assign and_636 = (and_610_s13_q & select_623_s13_q) & ({{22{sum_634_s13_q[9]}}, sum_634_s13_q} < 32'h3);
  // hls/stages/agreement.hpp:765
  logic [7:0] select_1020;
  assign select_1020 = slot_s13_q[0] ? chosen_score_q : sum_1019_s13_q;
  // hls/stages/agreement.hpp:761
  logic [7:0] select_1519;
  assign select_1519 = less_1518_s13_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1520;
  assign less_1520 = select_1020 < select_1519;
  // hls/stages/agreement.hpp:811
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1520 ? select_1519 : select_1020) : 8'h0;
  // hls/stages/agreement.hpp:730
  logic not_1526;
  assign not_1526 = ~slot_s13_q[0];
  // hls/stages/agreement.hpp:762
  logic [1:0] select_1527;
  assign select_1527 = less_1518_s13_q ? {slot_s13_q[0], not_1526} : 2'h0;
  logic [2:0] select_1529;
  assign select_1529 = less_1520 ? {select_1527, not_1526} : (slot_s13_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:812
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1556_s13_q : 7'h0;
  // hls/stages/agreement.hpp:823
  logic less_1558;
  assign less_1558 = best_left_rdata_s13_q[39:33] < of_near;
  // hls/stages/agreement.hpp:1143
  logic equal_1615;
  assign equal_1615 = x_s13_q[6:4] == 3'h7;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s13_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:214
  logic equal_1629;
  assign equal_1629 = x_s13_q[5:0] == 6'h3c;
  logic equal_1631;
  assign equal_1631 = x_s13_q[5:0] == 6'h3b;
  logic equal_1633;
  assign equal_1633 = x_s13_q[5:0] == 6'h36;
  logic equal_1635;
  assign equal_1635 = x_s13_q[5:0] == 6'h35;
  logic equal_1637;
  assign equal_1637 = x_s13_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1193
  logic and_1641;
  assign and_1641 = (~equal_1631) & ((~equal_1633) & ((~equal_1635) & (~equal_1637)));
  // hls/stages/patches.hpp:377
  logic [1:0] select_1694;
  assign select_1694 = and_1693_s13_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1695;
  assign select_1695 = and_1693_s13_q ? patches_band_rows_number_s13_q : patches_band_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] select_1696;
  assign select_1696 = row_starts_s13_q ? {select_1695, select_1694[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1697;
  assign select_1697 = row_starts_s13_q ? select_1694 : patches_fetch_q;
  logic equal_1698;
  assign equal_1698 = select_1697 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1708_s13_q ? {sum_1721_s13_q, sum_1717_s13_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1805;
  assign select_1805 = row_starts_s13_q ? select_1695 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_1806;
  assign equal_1806 = {patches_choosing_band_s13_q, and_1706_s13_q} == {select_1805, select_1697[1]};
  // hls/stages/patches.hpp:504
  logic less_1882;
  assign less_1882 = 5'he < patches_along_s13_q;
  // hls/stages/patches.hpp:505
  logic or_1883;
  assign or_1883 = equal_1796_s13_q | less_1882;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_s13_q == 5'h0;
  logic select_1888;
  assign select_1888 = equal_1796_s13_q ? patches_column_s13_q[0] : (or_1883 ? (patches_along_s13_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:506
  logic [4:0] select_1891;
  assign select_1891 = patches_match_row_ends_s13_q ? patches_down_by_s13_q : sum_1890_s13_q;
  // hls/stages/patches.hpp:509
  logic [4:0] select_1894;
  assign select_1894 = equal_1796_s13_q ? 5'h0 : (or_1883 ? (select_1891 + 5'h1) : sum_1890_s13_q);
  // hls/stages/patches.hpp:485
  logic equal_1897;
  assign equal_1897 = patches_column_s13_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s13_q == 5'h11;
  logic equal_1899;
  assign equal_1899 = patches_column_s13_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_1901;
  assign and_1901 = of_row & (~equal_1899);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1897 ? 2'h3 : {equal_1899, and_1901};
  // hls/stages/patches.hpp:473
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1904_s13_q, pixel_2_s13_q[0]} - {1'b0, sum_1905_s13_q, patches_columns_above_rdata_s13_q[8]};
  // hls/stages/patches.hpp:471
  logic [9:0] sum_1926;
  assign sum_1926 = {2'h0, patches_columns_above_rdata_s13_q[7:0]} + sum_1925_s13_q[10:1];
  // hls/stages/patches.hpp:486
  logic or_1945;
  assign or_1945 = (((patches_column_s13_q == 5'ha) | of_row) | equal_1899) | equal_1897;
  // hls/stages/patches.hpp:481
  logic and_1950;
  assign and_1950 = (~(patches_code_row_s13_q[4:2] == 3'h0)) & (~(patches_column_s13_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:174
  logic and_1964;
  assign and_1964 = (~(equal_1797_s13_q | (~and_1950))) & (~patches_column_s13_q[4]);
  // hls/stages/agreement.hpp:206
  logic [7:0] select_1984;
  assign select_1984 = so_s13_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1064
  logic or_1987;
  assign or_1987 = select_1984[7] | (~({select_1984[5], select_1984[3], select_1984[1]} == 3'h0));
  // hls/stages/agreement.hpp:1063
  logic or_1990;
  assign or_1990 = select_1984[7] | (~({select_1984[6], select_1984[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1062
  logic or_1993;
  assign or_1993 = select_1984[7] | (~(select_1984[6:4] == 3'h0));
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1994;
  assign select_1994 = equal_577_s13_q ? x_s13_q[5:0] : {region_row_q, or_1993, or_1990, or_1987};
  // hls/stages/agreement.hpp:1143
  logic not_1995;
  assign not_1995 = ~equal_1615;
  // hls/stages/agreement.hpp:1072
  logic or_1999;
  assign or_1999 = (~sum_1997_s13_q) | equal_1785_s13_q;
  // hls/stages/agreement.hpp:798
  logic and_2002;
  assign and_2002 = so_s13_q & (ends_cell_s13_q & (inside_v_s13_q & or_1999));
  // hls/stages/agreement.hpp:1043
  logic [7:0] select_2089;
  assign select_2089 = inside_v_s13_q ? (sum_1997_s13_q ? select_1984 : {select_1984[6:0], 1'b0}) : select_1984;
  // hls/stages/agreement.hpp:1064
  logic or_2092;
  assign or_2092 = select_2089[7] | (~({select_2089[5], select_2089[3], select_2089[1]} == 3'h0));
  // hls/stages/agreement.hpp:277
  logic select_2206;
  assign select_2206 = sample_pair_whole_s13_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:240
  logic [7:0] select_2601;
  assign select_2601 = slot_s13_q[0] ? 8'h0 : sum_1019_s13_q;
  // hls/stages/agreement.hpp:761
  logic less_2602;
  assign less_2602 = select_2601 < select_1519;
  // hls/stages/agreement.hpp:798
  logic less_2608;
  assign less_2608 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2610;
  assign less_2610 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:998
  logic [7:0] difference_2712;
  assign difference_2712 = best_left_rdata_s13_q[16:9] - lower_s13_q;
  // hls/stages/agreement.hpp:798
  logic [10:0] select_2780;
  assign select_2780 = equal_577_s13_q ? registration_expected_q : (so_s13_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2795_s13_q[7]}}, select_2795_s13_q} - {sum_1721_s13_q[9], sum_1721_s13_q, sum_1717_s13_q};
  // hls/stages/patches.hpp:358
  logic not_3037;
  assign not_3037 = ~select_1697[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3039;
  assign select_3039 = sample_pair_whole_s13_q ? (equal_1698 ? select_1697 : {not_3037, 1'b0}) : patches_fetch_q;
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3534;
  assign select_3534 = equal_1794_s13_q ? patches_down_by_s13_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:559
  logic [4:0] select_3545;
  assign select_3545 = less_1970_s13_q ? (or_1973_s13_q ? patches_step_s13_q : 5'h0) : 5'h0;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3557;
  assign select_3557 = and_3556_s13_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s13_q} - {1'b0, select_3557};
  // hls/stages/agreement.hpp:465
  logic [2:0] select_3850;
  assign select_3850 = less_3844_s13_q ? (sum_3847_s13_q ? region_row_q : next_region_row_q) : (and_2588_s13_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:530
  logic [2:0] select_3852;
  assign select_3852 = and_552_s13_q ? (equal_2482_s13_q ? select_3850 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3856;
  assign select_3856 = equal_577_s13_q ? select_1984 : (so_s13_q ? (ends_cell_s13_q ? select_2089 : select_1984) : 8'h1);
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3847_s13_q;
  // hls/stages/agreement.hpp:465
  logic select_3881;
  assign select_3881 = equal_2482_s13_q ? (less_3844_s13_q ? next : (region_fresh_q | equal_686_s13_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1232
  logic equal_3899;
  assign equal_3899 = x_s13_q[6:3] == 4'h7;
  logic equal_3924;
  assign equal_3924 = x_s13_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1140
  logic [7:0] select_3939;
  assign select_3939 = (x_s13_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3941;
  assign select_3941 = equal_3924 ? cfg_unproven_skin_limit_i : (equal_3899 ? cfg_unproven_limit_i : select_3939);

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
  assign census_memory_re = s13_en & and_552_s13_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 8040 x 4, DISTANCE 16, hls/stages/moments.hpp:155; read in stage 13, written in stage 14: 13 < 14 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:8039];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8040; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_576_s13_q;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s13_en & and_594;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
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
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_fresh_q <= 1'b1;
    end else if (s13_en) begin
      sample_of_skin_q <= mask_s13_q;
      averager_running_mask_q <= sample_pair_whole_s13_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2206;
      chosen_score_q <= less_2602 ? select_1519 : select_2601;
      chosen_place_q <= less_2602 ? {select_1527, not_1526} : 3'h2;
      before_0_q <= select_2601;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2608) & (~less_2610);
      registration_expected_q <= select_2780;
      patches_band_q <= sample_pair_whole_s13_q ? select_1805 : patches_band_q;
      patches_fetch_q <= select_3039;
      patches_summed_down_by_q <= equal_1792_s13_q ? patches_summed_down_by_q : select_3534;
      patches_read_at_q <= equal_1792_s13_q ? select_3545 : patches_read_at_q;
      patches_peak_row_q <= equal_1792_s13_q ? select_3557 : patches_peak_row_q;
      region_row_q <= select_3852;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3856;
      region_fresh_q <= and_552_s13_q ? select_3881 : region_fresh_q;
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
  logic draws_late_s14_q;
  logic [7:0] before_0_s14_q;
  logic [7:0] before_1_s14_q;
  logic [7:0] before_2_s14_q;
  logic shift_not_right_s14_q;
  logic [4:0] patches_choosing_band_s14_q;
  logic patches_lower_s14_q;
  logic patches_second_s14_q;
  logic [4:0] patches_code_row_s14_q;
  logic [4:0] patches_along_s14_q;
  logic [3:0] patches_match_row_s14_q;
  logic patches_summed_last_s14_q;
  logic [4:0] patches_summed_down_by_s14_q;
  logic [9:0] patches_read_row_differing_s14_q;
  logic patches_read_first_s14_q;
  logic [2:0] region_row_s14_q;
  logic region_fresh_s14_q;
  logic done_s14_q;
  logic [3:0] select_511_s14_q;
  logic row_starts_s14_q;
  logic [8:0] select_516_s14_q;
  logic and_525_s14_q;
  logic and_526_s14_q;
  logic [13:0] sum_533_s14_q;
  logic [13:0] sum_537_s14_q;
  logic and_541_s14_q;
  logic and_545_s14_q;
  logic [6:0] select_546_s14_q;
  logic [6:0] last_s14_q;
  logic and_550_s14_q;
  logic and_552_s14_q;
  logic equal_555_s14_q;
  logic equal_572_s14_q;
  logic [12:0] select_576_s14_q;
  logic equal_577_s14_q;
  logic not_578_s14_q;
  logic so_s14_q;
  logic not_580_s14_q;
  logic equal_581_s14_q;
  logic or_582_s14_q;
  logic less_585_s14_q;
  logic not_586_s14_q;
  logic inside_v_s14_q;
  logic not_590_s14_q;
  logic and_594_s14_q;
  logic [6:0] x_s14_2_q;
  logic [32:0] best_left_rdata_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic and_636_s14_q;
  logic and_642_s14_q;
  logic and_645_s14_q;
  logic and_651_s14_q;
  logic and_653_s14_q;
  logic equal_686_s14_q;
  logic select_769_s14_q;
  logic [7:0] of_best_s14_q;
  logic [2:0] select_1529_s14_q;
  logic [6:0] of_near_s14_q;
  logic [6:0] select_1559_s14_q;
  logic [5:0] select_1561_s14_q;
  logic [7:0] select_1564_s14_q;
  logic [7:0] select_1567_s14_q;
  logic and_1569_s14_q;
  logic select_1571_s14_q;
  logic or_1577_s14_q;
  logic and_1580_s14_q;
  logic and_1582_s14_q;
  logic [1:0] shown_right_rdata_s14_q;
  logic [6:0] select_1586_s14_q;
  logic and_1591_s14_q;
  logic [1:0] left_turns_rdata_s14_q;
  logic and_1608_s14_q;
  logic [1:0] right_turns_rdata_s14_q;
  logic equal_1615_s14_q;
  logic all_s14_q;
  logic equal_1629_s14_q;
  logic equal_1631_s14_q;
  logic equal_1633_s14_q;
  logic equal_1635_s14_q;
  logic equal_1637_s14_q;
  logic and_1642_s14_q;
  logic right_2_s14_q;
  logic [5:0] select_1696_s14_q;
  logic select_1697_s14_q;
  logic equal_1698_s14_q;
  logic and_1706_s14_q;
  logic less_1707_s14_q;
  logic equal_1708_s14_q;
  logic expected_s14_q;
  logic [10:0] sum_1723_s14_q;
  logic and_1740_s14_q;
  logic [5:0] select_1757_s14_q;
  logic [7:0] select_1783_s14_q;
  logic and_1790_s14_q;
  logic and_1791_s14_q;
  logic equal_1792_s14_q;
  logic not_1793_s14_q;
  logic equal_1794_s14_q;
  logic not_1795_s14_q;
  logic equal_1797_s14_q;
  logic or_1798_s14_q;
  logic not_1799_s14_q;
  logic and_1807_s14_q;
  logic [4:0] select_1822_s14_q;
  logic select_1828_s14_q;
  logic [3:0] select_1866_s14_q;
  logic patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic less_1882_s14_q;
  logic new_row_s14_q;
  logic select_1888_s14_q;
  logic not_1889_s14_q;
  logic [4:0] select_1894_s14_q;
  logic or_1895_s14_q;
  logic [1:0] of_row_2_s14_q;
  logic [10:0] down_2_s14_q;
  logic sum_1925_s14_q;
  logic [9:0] sum_1926_s14_q;
  logic and_1953_s14_q;
  logic and_1964_s14_q;
  logic and_1967_s14_q;
  logic less_1970_s14_q;
  logic equal_1971_s14_q;
  logic or_1973_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic or_1987_s14_q;
  logic or_1990_s14_q;
  logic or_1993_s14_q;
  logic [5:0] select_1994_s14_q;
  logic not_1995_s14_q;
  logic select_2003_s14_q;
  logic and_2006_s14_q;
  logic not_2007_s14_q;
  logic and_2021_s14_q;
  logic and_2031_s14_q;
  logic [12:0] seen_columns_rdata_s14_q;
  logic not_2061_s14_q;
  logic and_2075_s14_q;
  logic and_2077_s14_q;
  logic or_2092_s14_q;
  logic or_2095_s14_q;
  logic or_2098_s14_q;
  logic and_2109_s14_q;
  logic and_2125_s14_q;
  logic and_2150_s14_q;
  logic equal_2293_s14_q;
  logic equal_2482_s14_q;
  logic and_2619_s14_q;
  logic and_2646_s14_q;
  logic equal_2708_s14_q;
  logic [5:0] difference_2712_s14_q;
  logic [7:0] sum_2714_s14_q;
  logic [11:0] select_2798_s14_q;
  logic and_3022_s14_q;
  logic less_3148_s14_q;
  logic [5:0] away_s14_q;
  logic [9:0] select_3577_s14_q;
  logic [4:0] select_3578_s14_q;
  logic equal_3588_s14_q;
  logic select_3888_s14_q;
  logic equal_3899_s14_q;
  logic equal_3916_s14_q;
  logic equal_3924_s14_q;
  logic [7:0] select_3941_s14_q;
  logic and_4054_s14_q;
  logic or_4066_s14_q;
  logic and_4080_s14_q;
  logic and_4097_s14_q;
  logic not_4109_s14_q;
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
      draws_late_s14_q <= draws_late_s13_q;
      before_0_s14_q <= before_0_q;
      before_1_s14_q <= before_1_q;
      before_2_s14_q <= before_2_q;
      shift_not_right_s14_q <= shift_not_right_s13_q;
      patches_choosing_band_s14_q <= patches_choosing_band_s13_q;
      patches_lower_s14_q <= patches_lower_s13_q;
      patches_second_s14_q <= patches_second_s13_q;
      patches_code_row_s14_q <= patches_code_row_s13_q;
      patches_along_s14_q <= patches_along_s13_q;
      patches_match_row_s14_q <= patches_match_row_s13_q;
      patches_summed_last_s14_q <= patches_summed_last_s13_q;
      patches_summed_down_by_s14_q <= patches_summed_down_by_q;
      patches_read_row_differing_s14_q <= patches_read_row_differing_s13_q;
      patches_read_first_s14_q <= patches_read_first_s13_q;
      region_row_s14_q <= region_row_q;
      region_fresh_s14_q <= region_fresh_q;
      done_s14_q <= done_s13_q;
      select_511_s14_q <= select_511_s13_q;
      row_starts_s14_q <= row_starts_s13_q;
      select_516_s14_q <= select_516_s13_q;
      and_525_s14_q <= and_525_s13_q;
      and_526_s14_q <= and_526_s13_q;
      sum_533_s14_q <= sum_533;
      sum_537_s14_q <= sum_537;
      and_541_s14_q <= whole & (averager_memory_rdata_s13_q[28] | equal_531_s13_q);
      and_545_s14_q <= and_545;
      select_546_s14_q <= select_546_s13_q;
      last_s14_q <= last_s13_q;
      and_550_s14_q <= and_550_s13_q;
      and_552_s14_q <= and_552_s13_q;
      equal_555_s14_q <= select_511_s13_q == 4'h3;
      equal_572_s14_q <= equal_572_s13_q;
      select_576_s14_q <= select_576_s13_q;
      equal_577_s14_q <= equal_577_s13_q;
      not_578_s14_q <= not_578_s13_q;
      so_s14_q <= so_s13_q;
      not_580_s14_q <= not_580_s13_q;
      equal_581_s14_q <= equal_581_s13_q;
      or_582_s14_q <= or_582_s13_q;
      less_585_s14_q <= less_585_s13_q;
      not_586_s14_q <= not_586_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      not_590_s14_q <= not_590_s13_q;
      and_594_s14_q <= and_594;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[32:0];
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      and_636_s14_q <= and_636;
      and_642_s14_q <= and_642_s13_q;
      and_645_s14_q <= and_645_s13_q;
      and_651_s14_q <= and_651_s13_q;
      and_653_s14_q <= and_653_s13_q;
      equal_686_s14_q <= equal_686_s13_q;
      select_769_s14_q <= select_769_s13_q;
      of_best_s14_q <= of_best;
      select_1529_s14_q <= select_1529;
      of_near_s14_q <= of_near;
      select_1559_s14_q <= less_1558 ? of_near : best_left_rdata_s13_q[39:33];
      select_1561_s14_q <= less_1558 ? run_shift_s13_q : best_left_rdata_s13_q[45:40];
      select_1564_s14_q <= select_1564_s13_q;
      select_1567_s14_q <= select_1567_s13_q;
      and_1569_s14_q <= and_1569_s13_q;
      select_1571_s14_q <= select_1571_s13_q;
      or_1577_s14_q <= select_1571_s13_q | (best_right_rdata_s13_q[21:15] < of_near);
      and_1580_s14_q <= and_1580_s13_q;
      and_1582_s14_q <= and_1582_s13_q;
      shown_right_rdata_s14_q <= shown_right_rdata_q;
      select_1586_s14_q <= select_1586_s13_q;
      and_1591_s14_q <= and_636 & or_1590_s13_q;
      left_turns_rdata_s14_q <= left_turns_rdata_q;
      and_1608_s14_q <= and_1608_s13_q;
      right_turns_rdata_s14_q <= right_turns_rdata_q;
      equal_1615_s14_q <= equal_1615;
      all_s14_q <= all;
      equal_1629_s14_q <= equal_1629;
      equal_1631_s14_q <= equal_1631;
      equal_1633_s14_q <= equal_1633;
      equal_1635_s14_q <= equal_1635;
      equal_1637_s14_q <= equal_1637;
      and_1642_s14_q <= (~equal_1629) & and_1641;
      right_2_s14_q <= right_2_s13_q;
      select_1696_s14_q <= select_1696;
      select_1697_s14_q <= select_1697[1];
      equal_1698_s14_q <= equal_1698;
      and_1706_s14_q <= and_1706_s13_q;
      less_1707_s14_q <= less_1707_s13_q;
      equal_1708_s14_q <= equal_1708_s13_q;
      expected_s14_q <= expected[0];
      sum_1723_s14_q <= {expected[10], expected[10:1]} + 11'h5;
      and_1740_s14_q <= and_1740_s13_q;
      select_1757_s14_q <= select_1757_s13_q;
      select_1783_s14_q <= select_1783_s13_q;
      and_1790_s14_q <= and_1790_s13_q;
      and_1791_s14_q <= and_1791_s13_q;
      equal_1792_s14_q <= equal_1792_s13_q;
      not_1793_s14_q <= not_1793_s13_q;
      equal_1794_s14_q <= equal_1794_s13_q;
      not_1795_s14_q <= not_1795_s13_q;
      equal_1797_s14_q <= equal_1797_s13_q;
      or_1798_s14_q <= or_1798_s13_q;
      not_1799_s14_q <= not_1799_s13_q;
      and_1807_s14_q <= and_1791_s13_q & equal_1806;
      select_1822_s14_q <= select_1822_s13_q;
      select_1828_s14_q <= select_1828_s13_q;
      select_1866_s14_q <= select_1866_s13_q;
      patches_columns_above_rdata_s14_q <= patches_columns_above_rdata_s13_q[8];
      pixel_2_s14_q <= pixel_2_s13_q;
      less_1882_s14_q <= less_1882;
      new_row_s14_q <= new_row;
      select_1888_s14_q <= select_1888;
      not_1889_s14_q <= ~or_1883;
      select_1894_s14_q <= select_1894;
      or_1895_s14_q <= equal_1796_s13_q | equal_1794_s13_q;
      of_row_2_s14_q <= of_row_2;
      down_2_s14_q <= down_2;
      sum_1925_s14_q <= sum_1925_s13_q[0];
      sum_1926_s14_q <= sum_1926;
      and_1953_s14_q <= or_1798_s13_q & (or_1945 & (equal_1797_s13_q & and_1950));
      and_1964_s14_q <= and_1964;
      and_1967_s14_q <= or_1798_s13_q & (and_1964 & (patches_column_s13_q == 5'hf));
      less_1970_s14_q <= less_1970_s13_q;
      equal_1971_s14_q <= equal_1971_s13_q;
      or_1973_s14_q <= or_1973_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      or_1987_s14_q <= or_1987;
      or_1990_s14_q <= or_1990;
      or_1993_s14_q <= or_1993;
      select_1994_s14_q <= select_1994;
      not_1995_s14_q <= not_1995;
      select_2003_s14_q <= equal_577_s13_q ? (x_s13_q[6] & not_1995) : and_2002;
      and_2006_s14_q <= or_582_s13_q & (not_586_s13_q & and_610_s13_q);
      not_2007_s14_q <= not_2007_s13_q;
      and_2021_s14_q <= and_2021_s13_q;
      and_2031_s14_q <= not_578_s13_q & and_2002;
      seen_columns_rdata_s14_q <= {seen_columns_rdata_s13_q[13:7], seen_columns_rdata_s13_q[5:0]};
      not_2061_s14_q <= not_2061_s13_q;
      and_2075_s14_q <= seen_columns_rdata_s13_q[14] & inside_v_s13_q;
      and_2077_s14_q <= seen_columns_rdata_s13_q[5] & inside_v_s13_q;
      or_2092_s14_q <= or_2092;
      or_2095_s14_q <= select_2089[7] | (~({select_2089[6], select_2089[3:2]} == 3'h0));
      or_2098_s14_q <= select_2089[7] | (~(select_2089[6:4] == 3'h0));
      and_2109_s14_q <= seen_columns_rdata_s13_q[16] & inside_v_s13_q;
      and_2125_s14_q <= seen_columns_rdata_s13_q[17] & inside_v_s13_q;
      and_2150_s14_q <= and_2150_s13_q;
      equal_2293_s14_q <= equal_2293_s13_q;
      equal_2482_s14_q <= equal_2482_s13_q;
      and_2619_s14_q <= and_2619_s13_q;
      and_2646_s14_q <= seen_columns_rdata_s13_q[15] & inside_v_s13_q;
      equal_2708_s14_q <= equal_2708_s13_q;
      difference_2712_s14_q <= difference_2712[7:2];
      sum_2714_s14_q <= sum_2714_s13_q;
      select_2798_s14_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_3022_s14_q <= and_3022_s13_q;
      less_3148_s14_q <= 4'he < patches_column_s13_q[4:1];
      away_s14_q <= away;
      select_3577_s14_q <= patches_peak_best_differing_q;
      select_3578_s14_q <= patches_peak_best_column_q;
      equal_3588_s14_q <= equal_3588_s13_q;
      select_3888_s14_q <= sum_1997_s13_q ? (equal_1785_s13_q & or_1999) : or_1999;
      equal_3899_s14_q <= equal_3899;
      equal_3916_s14_q <= equal_3916_s13_q;
      equal_3924_s14_q <= equal_3924;
      select_3941_s14_q <= select_3941;
      and_4054_s14_q <= seen_columns_rdata_s13_q[6] & inside_v_s13_q;
      or_4066_s14_q <= or_4066_s13_q;
      and_4080_s14_q <= and_4080_s13_q;
      and_4097_s14_q <= and_4097_s13_q;
      not_4109_s14_q <= not_4109_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
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
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_525_s14_q ? sum_533_s14_q[13:5] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_555_s14_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_525_s14_q ? sum_537_s14_q[13:5] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_555_s14_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:218
  logic and_563;
  assign and_563 = and_525_s14_q & and_541_s14_q;
  // hls/stages/census.hpp:134
  logic select_565;
  assign select_565 = equal_555_s14_q ? and_563 : (averager_mask_q & and_563);
  // hls/stages/agreement.hpp:277
  logic whole_2;
  assign whole_2 = sample_pair_whole_s14_q & select_565;
  // hls/stages/census.hpp:218
  logic and_567;
  assign and_567 = and_525_s14_q & and_545_s14_q;
  // hls/stages/census.hpp:134
  logic select_569;
  assign select_569 = equal_555_s14_q ? and_567 : (averager_of_skin_q & and_567);
  // hls/stages/agreement.hpp:150
  logic and_638;
  assign and_638 = or_582_s14_q & (not_586_s14_q & and_636_s14_q);
  // hls/stages/moments.hpp:89
  logic and_643;
  assign and_643 = and_638 & and_642_s14_q;
  // hls/stages/agreement.hpp:820
  logic equal_1532;
  assign equal_1532 = select_1529_s14_q == 3'h1;
  logic or_1535;
  assign or_1535 = equal_1532 | (~(select_1529_s14_q == 3'h2));
  logic [7:0] select_1537;
  assign select_1537 = or_1535 ? before_0_s14_q : before_1_s14_q;
  logic [7:0] select_1538;
  assign select_1538 = equal_1532 ? (or_1535 ? before_1_q : {7'h0, shift_not_right_s14_q}) : select_1537;
  // hls/stages/agreement.hpp:821
  logic [7:0] select_1541;
  assign select_1541 = equal_1532 ? select_1537 : (or_1535 ? before_2_q : before_2_s14_q);
  // hls/stages/agreement.hpp:834
  logic or_1573;
  assign or_1573 = select_1571_s14_q | (best_right_rdata_s14_q[7:0] < of_best_s14_q);
  // hls/stages/agreement.hpp:150
  logic and_1593;
  assign and_1593 = or_582_s14_q & (not_586_s14_q & and_1591_s14_q);
  // hls/stages/agreement.hpp:798
  logic and_1597;
  assign and_1597 = not_578_s14_q & (so_s14_q ? and_1580_s14_q : (equal_581_s14_q & and_638));
  // hls/stages/agreement.hpp:1193
  logic [1:0] quarter;
  assign quarter = x_s14_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1144
  logic [1:0] select_1618;
  assign select_1618 = x_s14_q[4] ? {x_s14_q[3], x_s14_q[0]} : {x_s14_q[0], x_s14_q[3]};
  // hls/stages/agreement.hpp:1157
  logic [3:0] select_1620;
  assign select_1620 = equal_1615_s14_q ? {2'h0, quarter} : (all_s14_q ? {1'b0, x_s14_q[2:0]} : {x_s14_q[2:1], select_1618});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1621;
  assign sum_1621 = slot_s14_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_1622;
  assign select_1622 = equal_577_s14_q ? select_1620 : {sum_1621, lower_half_s14_q, registration_of_right_q};
  // hls/stages/patches.hpp:214
  logic equal_1623;
  assign equal_1623 = x_s14_q[5:0] == 6'h3f;
  logic equal_1625;
  assign equal_1625 = x_s14_q[5:0] == 6'h3e;
  logic equal_1627;
  assign equal_1627 = x_s14_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1193
  logic and_1645;
  assign and_1645 = (~equal_1623) & ((~equal_1625) & ((~equal_1627) & and_1642_s14_q));
  // hls/stages/agreement.hpp:1144
  logic less_1646;
  assign less_1646 = x_s14_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s14_q ? {1'b0, x_s14_q[2]} : x_s14_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1650;
  assign or_1650 = (kind == 2'h3) | (x_s14_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s14_q ? (right_2_s14_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1661;
  assign sum_1661 = {2'h0, slot_s14_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1667;
  assign not_1667 = ~lower_half_s14_q;
  logic [3:0] select_1668;
  assign select_1668 = registration_of_right_q ? {lower_half_s14_q, 1'b0, not_1667, 1'b0} : {1'b0, lower_half_s14_q, 1'b0, not_1667};
  // hls/stages/patches.hpp:98
  logic less_1724;
  assign less_1724 = {{4{sum_1723_s14_q[10]}}, sum_1723_s14_q, expected_s14_q} < 16'h15;
  // hls/stages/patches.hpp:475
  logic [11:0] sum_1907;
  assign sum_1907 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1908;
  assign sum_1908 = {{4{down_2_s14_q[10]}}, down_2_s14_q[10:2]} + {sum_1907[11], sum_1907};
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_1926_s14_q, sum_1925_s14_q, patches_columns_above_rdata_s14_q} + {4'h0, pixel_2_s14_q};
  // hls/stages/agreement.hpp:150
  logic and_2023;
  assign and_2023 = or_582_s14_q & (not_586_s14_q & and_2021_s14_q);
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s14_q & and_2006_s14_q;
  // hls/stages/agreement.hpp:1027
  logic select_2036;
  assign select_2036 = slot_s14_q[2] ? shown_shown_q : and_638;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s14_q & (shown_right_rdata_s14_q[0] | select_2036);
  // hls/stages/agreement.hpp:1027
  logic select_2039;
  assign select_2039 = slot_s14_q[2] ? shown_nearer_q : and_1593;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s14_q & (select_2036 ? select_2039 : shown_right_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:1290
  logic select_2059;
  assign select_2059 = marks_first_s14_q ? (done_s14_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2184;
  assign select_2184 = sample_pair_whole_s14_q ? (and_550_s14_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2186;
  assign select_2186 = sample_pair_whole_s14_q ? (and_550_s14_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2208;
  assign select_2208 = sample_pair_whole_s14_q ? (and_550_s14_q ? select_565 : averager_mask_q) : averager_mask_q;
  logic select_2210;
  assign select_2210 = sample_pair_whole_s14_q ? (and_550_s14_q ? select_569 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:798
  logic and_2622;
  assign and_2622 = ends_cell_s14_q & (inside_v_s14_q & (and_2619_s14_q & not_2007_s14_q));
  // hls/stages/agreement.hpp:1120
  logic not_2645;
  assign not_2645 = ~((draws_late_s14_q & not_2007_s14_q) | (x_s14_q[7:1] == 7'h0));
  // hls/stages/agreement.hpp:798
  logic and_2687;
  assign and_2687 = ends_cell_s14_q & (inside_v_s14_q & (not_2007_s14_q & (and_2619_s14_q & and_2023)));
  // hls/stages/agreement.hpp:1125
  logic and_2693;
  assign and_2693 = not_2645 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:248
  logic and_2717;
  assign and_2717 = ((and_2021_s14_q & and_636_s14_q) & equal_2708_s14_q) & (~({2'h0, difference_2712_s14_q} < sum_2714_s14_q));
  // hls/stages/agreement.hpp:150
  logic and_2728;
  assign and_2728 = not_586_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_2730;
  assign and_2730 = not_586_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2731;
  assign select_2731 = or_582_s14_q ? {and_2730, and_2728} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_2733;
  assign select_2733 = less_585_s14_q ? 2'h0 : (slot_s14_q[2] ? right_turns_rdata_s14_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2734;
  assign select_2734 = or_582_s14_q ? select_2733 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2781;
  assign equal_2781 = slot_s14_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2798_s14_q[11:7])) ? 12'h7f : select_2798_s14_q;
  // hls/stages/agreement.hpp:798
  logic select_2842;
  assign select_2842 = so_s14_q ? (equal_2781 ? right_2_s14_q : registration_of_right_q) : registration_of_right_q;
  logic select_2845;
  assign select_2845 = so_s14_q ? (equal_1708_s14_q ? inside_v_s14_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1144
  logic [1:0] quarter_2;
  assign quarter_2 = all_s14_q ? x_s14_q[1:0] : select_1618;
  // hls/stages/agreement.hpp:276
  logic [10:0] select_3126;
  assign select_3126 = equal_1794_s14_q ? patches_down_values_0_q : (or_1798_s14_q ? down_2_s14_q : patches_down_values_0_q);
  logic [10:0] select_3128;
  assign select_3128 = or_1798_s14_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3130;
  assign select_3130 = equal_1792_s14_q ? patches_down_values_1_q : (equal_1794_s14_q ? patches_down_values_1_q : select_3128);
  // hls/stages/patches.hpp:559
  logic and_3562;
  assign and_3562 = less_1970_s14_q & (or_1973_s14_q & (equal_1971_s14_q & (away_s14_q == 6'h3f)));
  logic and_3567;
  assign and_3567 = less_1970_s14_q & (or_1973_s14_q & (equal_1971_s14_q & (away_s14_q == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3569;
  assign sum_3569 = {away_s14_q[5], away_s14_q} + 7'h7d;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3580;
  assign select_3580 = patches_read_above_q ? patches_read_row_differing_s14_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3581;
  assign select_3581 = equal_1792_s14_q ? select_3580 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_3582;
  assign select_3582 = patches_read_below_q ? patches_read_row_differing_s14_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3583;
  assign select_3583 = equal_1792_s14_q ? select_3582 : patches_peak_below_q;
  // hls/stages/agreement.hpp:798
  logic select_3841;
  assign select_3841 = equal_577_s14_q ? shown_shown_q : (so_s14_q ? select_2036 : shown_shown_q);
  logic select_3843;
  assign select_3843 = equal_577_s14_q ? shown_nearer_q : (so_s14_q ? select_2039 : shown_nearer_q);
  // hls/stages/agreement.hpp:206
  logic or_3886;
  assign or_3886 = segment_starts_q | not_580_s14_q;
  // hls/stages/agreement.hpp:798
  logic select_3890;
  assign select_3890 = ends_cell_s14_q ? (inside_v_s14_q ? select_3888_s14_q : or_3886) : or_3886;
  // hls/stages/agreement.hpp:1232
  logic equal_3919;
  assign equal_3919 = x_s14_q[6:3] == 4'ha;
  logic equal_3922;
  assign equal_3922 = x_s14_q[6:3] == 4'hb;
  logic equal_3923;
  assign equal_3923 = x_s14_q[6:3] == 4'h9;
  // hls/stages/agreement.hpp:1140
  logic [7:0] select_3943;
  assign select_3943 = equal_3919 ? cfg_regions_limit_i : (equal_3923 ? cfg_hidden_limit_i : select_3941_s14_q);
  // hls/stages/agreement.hpp:798
  logic select_4052;
  assign select_4052 = so_s14_q ? (ends_cell_s14_q ? and_2077_s14_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4056;
  assign select_4056 = so_s14_q ? (ends_cell_s14_q ? and_4054_s14_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4058;
  assign select_4058 = ends_cell_s14_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4060;
  assign select_4060 = equal_577_s14_q ? centres_values_1_textured_q : (so_s14_q ? select_4058 : centres_values_1_textured_q);
  logic select_4061;
  assign select_4061 = ends_cell_s14_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4063;
  assign select_4063 = equal_577_s14_q ? centres_values_1_of_skin_q : (so_s14_q ? select_4061 : centres_values_1_of_skin_q);

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:777; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1696_s14_q;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s14_en & (sample_pair_whole_s14_q & (~equal_1698_s14_q));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:806; read in stage 14, written in stage 17: 14 < 17 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1894_s14_q, not_1889_s14_q, select_1888_s14_q};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s14_en & or_1895_s14_q;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:807; read in stage 14, written in stage 17: 14 < 17 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_s14_q;
`ifndef SYNTHESIS
  logic patches_left_codes_re;
  assign patches_left_codes_re = s14_en & (not_1793_s14_q & (new_row_s14_q & equal_1794_s14_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1415; read in stage 14, written in stage 17: 14 < 17 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1994_s14_q;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s14_en & select_2003_s14_q;
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_516_s14_q;
  logic averager_memory_we;
  assign averager_memory_we = s14_en & and_526_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_545_s14_q, and_541_s14_q, sum_537_s14_q, sum_533_s14_q};
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
  assign moments_memory_waddr = select_576_s14_q;
  logic moments_memory_we;
  assign moments_memory_we = s14_en & and_594_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_653_s14_q, and_651_s14_q, and_645_s14_q, and_643};
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
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
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
      averager_mask_q <= select_2208;
      averager_of_skin_q <= select_2210;
      registration_of_right_q <= equal_577_s14_q ? registration_of_right_q : select_2842;
      registration_was_inside_q <= equal_577_s14_q ? registration_was_inside_q : select_2845;
      patches_down_values_0_q <= equal_1792_s14_q ? patches_down_values_0_q : select_3126;
      patches_down_values_1_q <= select_3130;
      patches_read_above_q <= equal_1792_s14_q ? and_3562 : patches_read_above_q;
      patches_read_below_q <= equal_1792_s14_q ? and_3567 : patches_read_below_q;
      patches_peak_above_q <= select_3581;
      patches_peak_below_q <= select_3583;
      shown_shown_q <= select_3841;
      shown_nearer_q <= select_3843;
      segment_starts_q <= equal_577_s14_q ? or_3886 : (so_s14_q ? select_3890 : or_3886);
      centres_values_0_textured_q <= equal_577_s14_q ? centres_values_0_textured_q : select_4052;
      centres_values_0_of_skin_q <= equal_577_s14_q ? centres_values_0_of_skin_q : select_4056;
      centres_values_1_textured_q <= select_4060;
      centres_values_1_of_skin_q <= select_4063;
      write_half_q <= marks_first_s14_q ? (write_half_q ^ done_s14_q) : write_half_q;
      read_half_q <= select_2059;
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
      averager_total_0_q <= select_2184;
      averager_total_1_q <= select_2186;
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
  logic [10:0] patches_down_values_1_s15_q;
  logic [4:0] patches_along_s15_q;
  logic patches_summed_last_s15_q;
  logic [4:0] patches_summed_down_by_s15_q;
  logic patches_read_first_s15_q;
  logic [2:0] region_row_s15_q;
  logic region_fresh_s15_q;
  logic centres_values_1_textured_s15_q;
  logic centres_values_1_of_skin_s15_q;
  logic [3:0] select_511_s15_q;
  logic row_starts_s15_q;
  logic [6:0] select_546_s15_q;
  logic [6:0] last_s15_q;
  logic and_550_s15_q;
  logic and_552_s15_q;
  logic [77:0] census_memory_rdata_s15_q;
  logic [8:0] grey_s15_q;
  logic equal_555_s15_q;
  logic [8:0] select_558_s15_q;
  logic [8:0] grey_2_s15_q;
  logic [8:0] select_562_s15_q;
  logic whole_2_s15_q;
  logic and_570_s15_q;
  logic equal_572_s15_q;
  logic equal_577_s15_q;
  logic not_578_s15_q;
  logic so_s15_q;
  logic not_580_s15_q;
  logic equal_581_s15_q;
  logic inside_v_s15_q;
  logic not_590_s15_q;
  logic [3:0] moments_memory_rdata_s15_q;
  logic [6:0] x_s15_2_q;
  logic [32:0] best_left_rdata_s15_q;
  logic [6:0] right_s15_q;
  logic [14:0] best_right_rdata_s15_q;
  logic and_638_s15_q;
  logic and_645_s15_q;
  logic and_653_s15_q;
  logic equal_686_s15_q;
  logic [7:0] of_best_s15_q;
  logic or_1524_s15_q;
  logic [2:0] select_1529_s15_q;
  logic [7:0] select_1538_s15_q;
  logic [7:0] select_1541_s15_q;
  logic [6:0] select_1560_s15_q;
  logic [5:0] select_1562_s15_q;
  logic [7:0] select_1565_s15_q;
  logic [7:0] select_1568_s15_q;
  logic and_1569_s15_q;
  logic or_1573_s15_q;
  logic [6:0] select_1578_s15_q;
  logic [6:0] select_1579_s15_q;
  logic and_1582_s15_q;
  logic [6:0] select_1586_s15_q;
  logic and_1593_s15_q;
  logic and_1597_s15_q;
  logic and_1608_s15_q;
  logic equal_1615_s15_q;
  logic [1:0] quarter_s15_q;
  logic all_s15_q;
  logic [1:0] sum_1621_s15_q;
  logic [3:0] select_1622_s15_q;
  logic equal_1623_s15_q;
  logic equal_1625_s15_q;
  logic equal_1627_s15_q;
  logic equal_1629_s15_q;
  logic equal_1631_s15_q;
  logic equal_1633_s15_q;
  logic equal_1635_s15_q;
  logic equal_1637_s15_q;
  logic less_1646_s15_q;
  logic or_1650_s15_q;
  logic select_1653_s15_q;
  logic and_1663_s15_q;
  logic [3:0] select_1668_s15_q;
  logic select_1697_s15_q;
  logic equal_1698_s15_q;
  logic and_1706_s15_q;
  logic equal_1708_s15_q;
  logic and_1741_s15_q;
  logic [5:0] select_1757_s15_q;
  logic [7:0] select_1783_s15_q;
  logic and_1790_s15_q;
  logic and_1791_s15_q;
  logic equal_1792_s15_q;
  logic equal_1794_s15_q;
  logic equal_1797_s15_q;
  logic or_1798_s15_q;
  logic not_1799_s15_q;
  logic and_1807_s15_q;
  logic [4:0] select_1822_s15_q;
  logic select_1828_s15_q;
  logic [3:0] select_1866_s15_q;
  logic less_1882_s15_q;
  logic new_row_s15_q;
  logic or_1895_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [1:0] down_2_s15_q;
  logic [12:0] sum_1908_s15_q;
  logic [11:0] smooth_s15_q;
  logic and_1955_s15_q;
  logic and_1964_s15_q;
  logic and_1969_s15_q;
  logic less_1970_s15_q;
  logic or_1973_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic or_1987_s15_q;
  logic or_1990_s15_q;
  logic or_1993_s15_q;
  logic not_1995_s15_q;
  logic not_2007_s15_q;
  logic and_2009_s15_q;
  logic and_2023_s15_q;
  logic and_2031_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic textured_s15_q;
  logic shown_s15_q;
  logic near_s15_q;
  logic not_2061_s15_q;
  logic select_2073_s15_q;
  logic and_2075_s15_q;
  logic and_2077_s15_q;
  logic or_2092_s15_q;
  logic or_2095_s15_q;
  logic or_2098_s15_q;
  logic and_2109_s15_q;
  logic and_2111_s15_q;
  logic and_2112_s15_q;
  logic and_2125_s15_q;
  logic and_2127_s15_q;
  logic and_2128_s15_q;
  logic and_2150_s15_q;
  logic equal_2293_s15_q;
  logic equal_2482_s15_q;
  logic and_2624_s15_q;
  logic not_2645_s15_q;
  logic and_2646_s15_q;
  logic and_2648_s15_q;
  logic and_2649_s15_q;
  logic and_2688_s15_q;
  logic and_2696_s15_q;
  logic and_2720_s15_q;
  logic select_2731_s15_q;
  logic select_2734_s15_q;
  logic and_2735_s15_q;
  logic and_2784_s15_q;
  logic and_2785_s15_q;
  logic [11:0] residual_s15_q;
  logic equal_2847_s15_q;
  logic [3:0] not_2848_s15_q;
  logic [1:0] quarter_2_s15_q;
  logic and_3022_s15_q;
  logic less_3148_s15_q;
  logic equal_3491_s15_q;
  logic and_3571_s15_q;
  logic [9:0] select_3577_s15_q;
  logic [4:0] select_3578_s15_q;
  logic [4:0] select_3579_s15_q;
  logic equal_3588_s15_q;
  logic less_3616_s15_q;
  logic less_3619_s15_q;
  logic equal_3899_s15_q;
  logic equal_3916_s15_q;
  logic equal_3919_s15_q;
  logic equal_3922_s15_q;
  logic equal_3923_s15_q;
  logic equal_3924_s15_q;
  logic [7:0] select_3944_s15_q;
  logic or_4066_s15_q;
  logic and_4080_s15_q;
  logic and_4097_s15_q;
  logic not_4109_s15_q;
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
      patches_down_values_1_s15_q <= patches_down_values_1_q;
      patches_along_s15_q <= patches_along_s14_q;
      patches_summed_last_s15_q <= patches_summed_last_s14_q;
      patches_summed_down_by_s15_q <= patches_summed_down_by_s14_q;
      patches_read_first_s15_q <= patches_read_first_s14_q;
      region_row_s15_q <= region_row_s14_q;
      region_fresh_s15_q <= region_fresh_s14_q;
      centres_values_1_textured_s15_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s15_q <= centres_values_1_of_skin_q;
      select_511_s15_q <= select_511_s14_q;
      row_starts_s15_q <= row_starts_s14_q;
      select_546_s15_q <= select_546_s14_q;
      last_s15_q <= last_s14_q;
      and_550_s15_q <= and_550_s14_q;
      and_552_s15_q <= and_552_s14_q;
      census_memory_rdata_s15_q <= census_memory_rdata_q;
      grey_s15_q <= grey;
      equal_555_s15_q <= equal_555_s14_q;
      select_558_s15_q <= sample_pair_whole_s14_q ? total[10:2] : 9'h0;
      grey_2_s15_q <= grey_2;
      select_562_s15_q <= sample_pair_whole_s14_q ? total_2[10:2] : 9'h0;
      whole_2_s15_q <= whole_2;
      and_570_s15_q <= sample_pair_whole_s14_q & select_569;
      equal_572_s15_q <= equal_572_s14_q;
      equal_577_s15_q <= equal_577_s14_q;
      not_578_s15_q <= not_578_s14_q;
      so_s15_q <= so_s14_q;
      not_580_s15_q <= not_580_s14_q;
      equal_581_s15_q <= equal_581_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      not_590_s15_q <= not_590_s14_q;
      moments_memory_rdata_s15_q <= moments_memory_rdata_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q[14:0];
      and_638_s15_q <= and_638;
      and_645_s15_q <= and_645_s14_q;
      and_653_s15_q <= and_653_s14_q;
      equal_686_s15_q <= equal_686_s14_q;
      of_best_s15_q <= of_best_s14_q;
      or_1524_s15_q <= select_769_s14_q | (best_left_rdata_s14_q[16:9] < of_best_s14_q);
      select_1529_s15_q <= select_1529_s14_q;
      select_1538_s15_q <= select_1538;
      select_1541_s15_q <= select_1541;
      select_1560_s15_q <= select_769_s14_q ? of_near_s14_q : select_1559_s14_q;
      select_1562_s15_q <= select_769_s14_q ? run_shift_s14_q : select_1561_s14_q;
      select_1565_s15_q <= (run_shift_s14_q == 6'h3f) ? of_best_s14_q : select_1564_s14_q;
      select_1568_s15_q <= (run_shift_s14_q == 6'h1) ? of_best_s14_q : select_1567_s14_q;
      and_1569_s15_q <= and_1569_s14_q;
      or_1573_s15_q <= or_1573;
      select_1578_s15_q <= or_1577_s14_q ? of_near_s14_q : best_right_rdata_s14_q[21:15];
      select_1579_s15_q <= or_1577_s14_q ? x_s14_2_q : best_right_rdata_s14_q[28:22];
      and_1582_s15_q <= and_1582_s14_q;
      select_1586_s15_q <= select_1586_s14_q;
      and_1593_s15_q <= and_1593;
      and_1597_s15_q <= and_1597;
      and_1608_s15_q <= and_1608_s14_q;
      equal_1615_s15_q <= equal_1615_s14_q;
      quarter_s15_q <= quarter;
      all_s15_q <= all_s14_q;
      sum_1621_s15_q <= sum_1621;
      select_1622_s15_q <= select_1622;
      equal_1623_s15_q <= equal_1623;
      equal_1625_s15_q <= equal_1625;
      equal_1627_s15_q <= equal_1627;
      equal_1629_s15_q <= equal_1629_s14_q;
      equal_1631_s15_q <= equal_1631_s14_q;
      equal_1633_s15_q <= equal_1633_s14_q;
      equal_1635_s15_q <= equal_1635_s14_q;
      equal_1637_s15_q <= equal_1637_s14_q;
      less_1646_s15_q <= less_1646;
      or_1650_s15_q <= or_1650;
      select_1653_s15_q <= equal_1615_s14_q ? and_1645 : (less_1646 & (~or_1650));
      and_1663_s15_q <= half_ends & ({{3{sum_1661[4]}}, sum_1661} < 8'h3);
      select_1668_s15_q <= select_1668;
      select_1697_s15_q <= select_1697_s14_q;
      equal_1698_s15_q <= equal_1698_s14_q;
      and_1706_s15_q <= and_1706_s14_q;
      equal_1708_s15_q <= equal_1708_s14_q;
      and_1741_s15_q <= (less_1707_s14_q & (and_638 & less_1724)) & and_1740_s14_q;
      select_1757_s15_q <= select_1757_s14_q;
      select_1783_s15_q <= select_1783_s14_q;
      and_1790_s15_q <= and_1790_s14_q;
      and_1791_s15_q <= and_1791_s14_q;
      equal_1792_s15_q <= equal_1792_s14_q;
      equal_1794_s15_q <= equal_1794_s14_q;
      equal_1797_s15_q <= equal_1797_s14_q;
      or_1798_s15_q <= or_1798_s14_q;
      not_1799_s15_q <= not_1799_s14_q;
      and_1807_s15_q <= and_1807_s14_q;
      select_1822_s15_q <= select_1822_s14_q;
      select_1828_s15_q <= select_1828_s14_q;
      select_1866_s15_q <= select_1866_s14_q;
      less_1882_s15_q <= less_1882_s14_q;
      new_row_s15_q <= new_row_s14_q;
      or_1895_s15_q <= or_1895_s14_q;
      of_row_2_s15_q <= of_row_2_s14_q;
      down_2_s15_q <= down_2_s14_q[1:0];
      sum_1908_s15_q <= sum_1908;
      smooth_s15_q <= smooth;
      and_1955_s15_q <= not_1793_s14_q & (not_1795_s14_q & and_1953_s14_q);
      and_1964_s15_q <= and_1964_s14_q;
      and_1969_s15_q <= not_1793_s14_q & (not_1795_s14_q & and_1967_s14_q);
      less_1970_s15_q <= less_1970_s14_q;
      or_1973_s15_q <= or_1973_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      or_1987_s15_q <= or_1987_s14_q;
      or_1990_s15_q <= or_1990_s14_q;
      or_1993_s15_q <= or_1993_s14_q;
      not_1995_s15_q <= not_1995_s14_q;
      not_2007_s15_q <= not_2007_s14_q;
      and_2009_s15_q <= inside_v_s14_q & (and_2006_s14_q & not_2007_s14_q);
      and_2023_s15_q <= and_2023;
      and_2031_s15_q <= and_2031_s14_q;
      seen_columns_rdata_s15_q <= seen_columns_rdata_s14_q;
      textured_s15_q <= textured;
      shown_s15_q <= shown;
      near_s15_q <= near;
      not_2061_s15_q <= not_2061_s14_q;
      select_2073_s15_q <= draws_late_s14_q ? read_half_q : write_half_q;
      and_2075_s15_q <= and_2075_s14_q;
      and_2077_s15_q <= and_2077_s14_q;
      or_2092_s15_q <= or_2092_s14_q;
      or_2095_s15_q <= or_2095_s14_q;
      or_2098_s15_q <= or_2098_s14_q;
      and_2109_s15_q <= and_2109_s14_q;
      and_2111_s15_q <= seen_columns_rdata_s14_q[7] & inside_v_s14_q;
      and_2112_s15_q <= seen_columns_rdata_s14_q[3] & inside_v_s14_q;
      and_2125_s15_q <= and_2125_s14_q;
      and_2127_s15_q <= seen_columns_rdata_s14_q[8] & inside_v_s14_q;
      and_2128_s15_q <= seen_columns_rdata_s14_q[4] & inside_v_s14_q;
      and_2150_s15_q <= and_2150_s14_q;
      equal_2293_s15_q <= equal_2293_s14_q;
      equal_2482_s15_q <= equal_2482_s14_q;
      and_2624_s15_q <= not_578_s14_q & (so_s14_q & and_2622);
      not_2645_s15_q <= not_2645;
      and_2646_s15_q <= and_2646_s14_q;
      and_2648_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      and_2649_s15_q <= seen_columns_rdata_s14_q[2] & inside_v_s14_q;
      and_2688_s15_q <= so_s14_q & and_2687;
      and_2696_s15_q <= not_578_s14_q & (so_s14_q & (ends_cell_s14_q & and_2693));
      and_2720_s15_q <= (or_582_s14_q & (not_586_s14_q & and_2717)) & not_2007_s14_q;
      select_2731_s15_q <= select_2731[1];
      select_2734_s15_q <= select_2734[1];
      and_2735_s15_q <= select_2731[0] & select_2734[0];
      and_2784_s15_q <= not_578_s14_q & (so_s14_q & (half_ends & equal_2781));
      and_2785_s15_q <= and_638 & less_1707_s14_q;
      residual_s15_q <= residual;
      equal_2847_s15_q <= sum_1621 == 2'h2;
      not_2848_s15_q <= ~select_1668;
      quarter_2_s15_q <= quarter_2;
      and_3022_s15_q <= and_3022_s14_q;
      less_3148_s15_q <= less_3148_s14_q;
      equal_3491_s15_q <= patches_match_row_s14_q == 4'h0;
      and_3571_s15_q <= equal_1971_s14_q & ({sum_3569[6], sum_3569} < 8'hfb);
      select_3577_s15_q <= select_3577_s14_q;
      select_3578_s15_q <= select_3578_s14_q;
      select_3579_s15_q <= patches_peak_row_q;
      equal_3588_s15_q <= equal_3588_s14_q;
      less_3616_s15_q <= select_3581 < select_3583;
      less_3619_s15_q <= select_3583 < select_3581;
      equal_3899_s15_q <= equal_3899_s14_q;
      equal_3916_s15_q <= equal_3916_s14_q;
      equal_3919_s15_q <= equal_3919;
      equal_3922_s15_q <= equal_3922;
      equal_3923_s15_q <= equal_3923;
      equal_3924_s15_q <= equal_3924_s14_q;
      select_3944_s15_q <= equal_3922 ? {cfg_on_skin_limit_i, 3'h0} : select_3943;
      or_4066_s15_q <= or_4066_s14_q;
      and_4080_s15_q <= and_4080_s14_q;
      and_4097_s15_q <= and_4097_s14_q;
      not_4109_s15_q <= not_4109_s14_q;
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
  logic [11:0] patches_smooth_values_0_q;
  logic [11:0] patches_smooth_values_1_q;
  logic [11:0] patches_smooth_values_2_q;
  logic [11:0] patches_smooth_values_3_q;
  logic [10:0] patches_down_values_2_q;
  logic [10:0] patches_down_values_3_q;
  logic [9:0] patches_read_far_q;
  logic segment_started_q;
  // hls/stages/census.hpp:308
  logic less_659;
  assign less_659 = census_memory_rdata_s15_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_memory_rdata_s15_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_663;
  assign less_663 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_664;
  assign less_664 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_665;
  assign less_665 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_666;
  assign less_666 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_667;
  assign less_667 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_668;
  assign less_668 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_669;
  assign less_669 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_670;
  assign less_670 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_671;
  assign less_671 = census_memory_rdata_s15_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_memory_rdata_s15_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_675;
  assign less_675 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_676;
  assign less_676 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_677;
  assign less_677 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_678;
  assign less_678 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_679;
  assign less_679 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_680;
  assign less_680 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_681;
  assign less_681 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_682;
  assign less_682 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:460
  logic equal_683;
  assign equal_683 = last_s15_q == 7'h0;
  logic [3:0] select_687;
  assign select_687 = equal_686_s15_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
  logic [4:0] select_688;
  assign select_688 = equal_683 ? {select_687, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_689;
  assign select_689 = equal_683 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:300
  logic and_692;
  assign and_692 = census_memory_rdata_s15_q[38] & (census_memory_rdata_s15_q[18] & whole_2_s15_q);
  logic and_694;
  assign and_694 = census_memory_rdata_s15_q[77] & (census_memory_rdata_s15_q[58] & and_692);
  // hls/stages/census.hpp:284
  logic [9:0] difference_717;
  assign difference_717 = {1'b0, select_558_s15_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_720;
  assign difference_720 = {1'b0, census_memory_rdata_s15_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_724;
  assign difference_724 = {1'b0, census_memory_rdata_s15_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_728;
  assign difference_728 = {1'b0, census_memory_rdata_s15_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_732;
  assign difference_732 = {1'b0, census_memory_rdata_s15_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/agreement.hpp:798
  logic and_1594;
  assign and_1594 = not_580_s15_q & and_1593_s15_q;
  // hls/stages/moments.hpp:85
  logic and_1601;
  assign and_1601 = moments_has_before_q & moments_memory_rdata_s15_q[0];
  // hls/stages/agreement.hpp:1015
  logic and_1605;
  assign and_1605 = not_590_s15_q & (and_1601 & (moments_memory_rdata_s15_q[1] ^ and_645_s15_q));
  // hls/stages/moments.hpp:85
  logic and_1610;
  assign and_1610 = moments_has_before_q & moments_memory_rdata_s15_q[2];
  // hls/stages/agreement.hpp:1015
  logic and_1614;
  assign and_1614 = not_590_s15_q & (and_1610 & (moments_memory_rdata_s15_q[3] ^ and_653_s15_q));
  // hls/stages/agreement.hpp:798
  logic and_1664;
  assign and_1664 = so_s15_q & and_1663_s15_q;
  logic and_1745;
  assign and_1745 = not_578_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_1741_s15_q)));
  logic [7:0] select_1751;
  assign select_1751 = so_s15_q ? (ends_cell_s15_q ? (inside_v_s15_q ? x_s15_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:475
  logic [13:0] sum_1909;
  assign sum_1909 = {{3{patches_down_values_1_s15_q[10]}}, patches_down_values_1_s15_q} + {sum_1908_s15_q, down_2_s15_q[1]};
  logic [12:0] sum_1910;
  assign sum_1910 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1909[13:1];
  // hls/stages/patches.hpp:474
  logic [12:0] sum_1928;
  assign sum_1928 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s15_q[11:1]};
  logic [12:0] sum_1929;
  assign sum_1929 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1930;
  assign difference_1930 = {1'b0, sum_1928, smooth_s15_q[0]} - {1'b0, sum_1929, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:263
  logic and_2026;
  assign and_2026 = inside_v_s15_q & (not_2007_s15_q & (and_2023_s15_q & and_1593_s15_q));
  logic and_2034;
  assign and_2034 = inside_v_s15_q & and_2023_s15_q;
  logic explained;
  assign explained = inside_v_s15_q & and_638_s15_q;
  // hls/stages/agreement.hpp:1043
  logic and_2078;
  assign and_2078 = seen_columns_rdata_s15_q[0] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1101
  logic [1:0] sum_2080;
  assign sum_2080 = {1'b0, and_2077_s15_q} + ({1'b0, textured_s15_q} + {1'b0, and_2078});
  // hls/stages/agreement.hpp:1043
  logic and_2110;
  assign and_2110 = seen_columns_rdata_s15_q[11] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1103
  logic [1:0] sum_2114;
  assign sum_2114 = {1'b0, and_2111_s15_q} + ({1'b0, shown_s15_q} + {1'b0, and_2112_s15_q});
  // hls/stages/agreement.hpp:1043
  logic and_2126;
  assign and_2126 = seen_columns_rdata_s15_q[12] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1104
  logic [1:0] sum_2130;
  assign sum_2130 = {1'b0, and_2127_s15_q} + ({1'b0, near_s15_q} + {1'b0, and_2128_s15_q});
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2176;
  assign select_2176 = sample_pair_whole_s15_q ? (and_550_s15_q ? grey_s15_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2178;
  assign select_2178 = sample_pair_whole_s15_q ? (and_550_s15_q ? grey_2_s15_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2180;
  assign select_2180 = sample_pair_whole_s15_q ? (and_550_s15_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2182;
  assign select_2182 = sample_pair_whole_s15_q ? (and_550_s15_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2187;
  assign sum_2187 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s15_q};
  logic [9:0] sum_2195;
  assign sum_2195 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s15_q};
  // hls/stages/agreement.hpp:530
  logic [8:0] select_2211;
  assign select_2211 = and_552_s15_q ? select_558_s15_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_552_s15_q ? select_562_s15_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2214;
  assign select_2214 = and_552_s15_q ? census_memory_rdata_s15_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_552_s15_q ? census_memory_rdata_s15_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2216;
  assign select_2216 = and_552_s15_q ? census_memory_rdata_s15_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2217;
  assign select_2217 = and_552_s15_q ? census_memory_rdata_s15_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_552_s15_q ? census_memory_rdata_s15_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2219;
  assign select_2219 = and_552_s15_q ? census_memory_rdata_s15_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2220;
  assign select_2220 = and_552_s15_q ? census_memory_rdata_s15_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2221;
  assign select_2221 = and_552_s15_q ? census_memory_rdata_s15_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2222;
  assign select_2222 = and_552_s15_q ? census_memory_rdata_s15_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2223;
  assign select_2223 = and_552_s15_q ? census_memory_rdata_s15_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2224;
  assign select_2224 = and_552_s15_q ? census_memory_rdata_s15_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_552_s15_q ? census_memory_rdata_s15_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2226;
  assign select_2226 = and_552_s15_q ? census_memory_rdata_s15_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2227;
  assign select_2227 = and_552_s15_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_552_s15_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2230;
  assign select_2230 = and_552_s15_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_552_s15_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2233;
  assign select_2233 = and_552_s15_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_552_s15_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2236;
  assign select_2236 = and_552_s15_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2237;
  assign select_2237 = and_552_s15_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2238;
  assign select_2238 = and_552_s15_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2240;
  assign select_2240 = and_552_s15_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2241;
  assign select_2241 = and_552_s15_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2243;
  assign select_2243 = and_552_s15_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2244;
  assign select_2244 = and_552_s15_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2246;
  assign select_2246 = and_552_s15_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2247;
  assign select_2247 = and_552_s15_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2249;
  assign select_2249 = and_552_s15_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2250;
  assign select_2250 = and_552_s15_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2252;
  assign select_2252 = and_552_s15_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2253;
  assign select_2253 = and_552_s15_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2255;
  assign select_2255 = and_552_s15_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2256;
  assign select_2256 = and_552_s15_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2259;
  assign select_2259 = and_552_s15_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2260;
  assign select_2260 = and_552_s15_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2263;
  assign select_2263 = and_552_s15_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2264;
  assign select_2264 = and_552_s15_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2268;
  assign difference_2268 = {1'b0, select_562_s15_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2271;
  assign difference_2271 = {1'b0, census_memory_rdata_s15_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2275;
  assign difference_2275 = {1'b0, census_memory_rdata_s15_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2279;
  assign difference_2279 = {1'b0, census_memory_rdata_s15_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2283;
  assign difference_2283 = {1'b0, census_memory_rdata_s15_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/agreement.hpp:1157
  logic equal_2308;
  assign equal_2308 = x_s15_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:798
  logic select_2314;
  assign select_2314 = equal_577_s15_q ? (moments_has_before_q | equal_2308) : moments_has_before_q;
  // hls/stages/census.hpp:371
  logic [9:0] difference_2379;
  assign difference_2379 = {1'b0, select_558_s15_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2391;
  assign difference_2391 = {1'b0, select_562_s15_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:530
  logic and_2617;
  assign and_2617 = and_552_s15_q & (equal_686_s15_q & equal_2482_s15_q);
  // hls/stages/agreement.hpp:798
  logic and_2629;
  assign and_2629 = not_578_s15_q & (so_s15_q & (ends_cell_s15_q & and_2009_s15_q));
  // hls/stages/agreement.hpp:1043
  logic and_2647;
  assign and_2647 = seen_columns_rdata_s15_q[10] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1102
  logic [1:0] sum_2651;
  assign sum_2651 = {1'b0, and_2648_s15_q} + ({1'b0, explained} + {1'b0, and_2649_s15_q});
  // hls/stages/agreement.hpp:798
  logic and_2689;
  assign and_2689 = not_578_s15_q & and_2688_s15_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2691;
  assign select_2691 = and_2617 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2689});
  logic [13:0] select_2698;
  assign select_2698 = and_2617 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2696_s15_q});
  // hls/stages/agreement.hpp:798
  logic and_2724;
  assign and_2724 = not_578_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_2720_s15_q)));
  // hls/stages/agreement.hpp:1040
  logic and_2736;
  assign and_2736 = and_638_s15_q & and_2735_s15_q;
  // hls/stages/agreement.hpp:263
  logic and_2739;
  assign and_2739 = inside_v_s15_q & (not_2007_s15_q & (select_2731_s15_q & and_2736));
  logic and_2747;
  assign and_2747 = inside_v_s15_q & (not_2007_s15_q & (select_2734_s15_q & and_2736));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2819;
  assign difference_2819 = 13'h0 - {residual_s15_q[11], residual_s15_q};
  logic less_2834;
  assign less_2834 = $signed(difference_2819) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2850;
  assign select_2850 = equal_2847_s15_q ? (registration_fresh_q & not_2848_s15_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_2852;
  assign select_2852 = so_s15_q ? (and_1663_s15_q ? select_2850 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2854;
  assign select_2854 = and_2617 ? 4'hf : (equal_577_s15_q ? registration_fresh_q : select_2852);
  // hls/stages/registration.hpp:258
  logic not_2874;
  assign not_2874 = ~quarter_2_s15_q[1];
  logic [3:0] select_2875;
  assign select_2875 = quarter_2_s15_q[0] ? {quarter_2_s15_q[1], 1'b0, not_2874, 1'b0} : {1'b0, quarter_2_s15_q[1], 1'b0, not_2874};
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3114;
  assign select_3114 = equal_1794_s15_q ? patches_smooth_values_0_q : (or_1798_s15_q ? smooth_s15_q : patches_smooth_values_0_q);
  logic [11:0] select_3116;
  assign select_3116 = or_1798_s15_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3118;
  assign select_3118 = equal_1792_s15_q ? patches_smooth_values_1_q : (equal_1794_s15_q ? patches_smooth_values_1_q : select_3116);
  logic [11:0] select_3119;
  assign select_3119 = or_1798_s15_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3121;
  assign select_3121 = equal_1792_s15_q ? patches_smooth_values_2_q : (equal_1794_s15_q ? patches_smooth_values_2_q : select_3119);
  logic [11:0] select_3122;
  assign select_3122 = or_1798_s15_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3124;
  assign select_3124 = equal_1792_s15_q ? patches_smooth_values_3_q : (equal_1794_s15_q ? patches_smooth_values_3_q : select_3122);
  logic [10:0] select_3131;
  assign select_3131 = or_1798_s15_q ? patches_down_values_1_s15_q : patches_down_values_2_q;
  logic [10:0] select_3133;
  assign select_3133 = equal_1792_s15_q ? patches_down_values_2_q : (equal_1794_s15_q ? patches_down_values_2_q : select_3131);
  logic [10:0] select_3134;
  assign select_3134 = or_1798_s15_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3136;
  assign select_3136 = equal_1792_s15_q ? patches_down_values_3_q : (equal_1794_s15_q ? patches_down_values_3_q : select_3134);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3573;
  assign select_3573 = or_1973_s15_q ? (and_3571_s15_q ? patches_rows_rdata_s15_q : 10'h3ff) : 10'h3ff;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3575;
  assign select_3575 = equal_1792_s15_q ? (less_1970_s15_q ? select_3573 : 10'h3ff) : patches_read_far_q;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3616_s15_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = less_3619_s15_q ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3577_s15_q;
  // hls/stages/agreement.hpp:1238
  logic equal_3684;
  assign equal_3684 = x_s15_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1232
  logic equal_3921;
  assign equal_3921 = x_s15_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1140
  logic [7:0] limit;
  assign limit = equal_3921 ? cfg_regions_limit_i : select_3944_s15_q;
  // hls/stages/agreement.hpp:1246
  logic not_3946;
  assign not_3946 = ~x_s15_q[2];
  logic [3:0] select_3947;
  assign select_3947 = x_s15_q[1] ? {x_s15_q[2], 1'b0, not_3946, 1'b0} : {1'b0, x_s15_q[2], 1'b0, not_3946};
  logic [7:0] select_3948;
  assign select_3948 = x_s15_q[0] ? {select_3947[3], 1'b0, select_3947[2], 1'b0, select_3947[1], 1'b0, select_3947[0], 1'b0} : {1'b0, select_3947[3], 1'b0, select_3947[2], 1'b0, select_3947[1], 1'b0, select_3947[0]};
  // hls/stages/agreement.hpp:1140
  logic [13:0] select_3952;
  assign select_3952 = equal_3923_s15_q ? counts_skin_supervised_q : (equal_3924_s15_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3954;
  assign select_3954 = equal_3922_s15_q ? counts_skin_textured_q : (equal_3919_s15_q ? counts_textured_q : select_3952);
  logic [13:0] of;
  assign of = equal_3921 ? counts_textured_q : select_3954;
  // hls/stages/registration.hpp:258
  logic not_4159;
  assign not_4159 = ~quarter_s15_q[1];
  logic [3:0] select_4160;
  assign select_4160 = quarter_s15_q[0] ? {quarter_s15_q[1], 1'b0, not_4159, 1'b0} : {1'b0, quarter_s15_q[1], 1'b0, not_4159};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1622_s15_q;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s15_en & (equal_577_s15_q ? (x_s15_q[6] & select_1653_s15_q) : and_1664);
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = last_s15_q;
  logic census_memory_we;
  assign census_memory_we = s15_en & and_552_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s15_q[58:40], census_memory_rdata_s15_q[38:0], and_570_s15_q, whole_2_s15_q, select_562_s15_q, select_558_s15_q};
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
  assign shown_right_waddr = select_1586_s15_q;
  logic shown_right_we;
  assign shown_right_we = s15_en & and_1597_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1594, not_580_s15_q};
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
  assign seen_columns_we = s15_en & and_1582_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s15_q, near_s15_q, shown_s15_q, explained, and_2034, textured_s15_q};
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
      patches_smooth_values_0_q <= 12'h0;
      patches_smooth_values_1_q <= 12'h0;
      patches_smooth_values_2_q <= 12'h0;
      patches_smooth_values_3_q <= 12'h0;
      patches_down_values_2_q <= 11'h0;
      patches_down_values_3_q <= 11'h0;
      patches_read_far_q <= 10'h3ff;
      segment_started_q <= 1'b0;
    end else if (s15_en) begin
      census_filled_q <= and_552_s15_q ? {select_689[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2314;
      rows_passed_above_q <= and_552_s15_q ? select_688 : rows_passed_above_q;
      counts_textured_q <= and_2617 ? 14'h0 : (counts_textured_q + {13'h0, and_2629});
      counts_skin_supervised_q <= select_2691;
      counts_skin_textured_q <= select_2698;
      registration_fresh_q <= select_2854;
      patches_smooth_values_0_q <= equal_1792_s15_q ? patches_smooth_values_0_q : select_3114;
      patches_smooth_values_1_q <= select_3118;
      patches_smooth_values_2_q <= select_3121;
      patches_smooth_values_3_q <= select_3124;
      patches_down_values_2_q <= select_3133;
      patches_down_values_3_q <= select_3136;
      patches_read_far_q <= select_3575;
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
      averager_quarter_1_0_q <= select_2176;
      averager_quarter_1_1_q <= select_2178;
      averager_quarter_2_0_q <= select_2180;
      averager_quarter_2_1_q <= select_2182;
      census_columns_values_0_cell_0_left_q <= select_2211;
      census_columns_values_0_cell_0_right_q <= select_2212;
      census_columns_values_0_cell_1_left_q <= select_2214;
      census_columns_values_0_cell_1_right_q <= select_2215;
      census_columns_values_0_cell_1_mask_q <= select_2216;
      census_columns_values_0_cell_2_left_q <= select_2217;
      census_columns_values_0_cell_2_right_q <= select_2218;
      census_columns_values_0_cell_2_mask_q <= select_2219;
      census_columns_values_0_cell_2_of_skin_q <= select_2220;
      census_columns_values_0_cell_3_left_q <= select_2221;
      census_columns_values_0_cell_3_right_q <= select_2222;
      census_columns_values_0_cell_3_mask_q <= select_2223;
      census_columns_values_0_cell_4_left_q <= select_2224;
      census_columns_values_0_cell_4_right_q <= select_2225;
      census_columns_values_0_cell_4_mask_q <= select_2226;
      census_columns_values_1_cell_0_left_q <= select_2227;
      census_columns_values_1_cell_0_right_q <= select_2228;
      census_columns_values_1_cell_1_left_q <= select_2230;
      census_columns_values_1_cell_1_right_q <= select_2231;
      census_columns_values_1_cell_2_left_q <= select_2233;
      census_columns_values_1_cell_2_right_q <= select_2234;
      census_columns_values_1_cell_2_of_skin_q <= select_2236;
      census_columns_values_1_cell_3_left_q <= select_2237;
      census_columns_values_1_cell_3_right_q <= select_2238;
      census_columns_values_1_cell_4_left_q <= select_2240;
      census_columns_values_1_cell_4_right_q <= select_2241;
      census_columns_values_2_cell_0_left_q <= select_2243;
      census_columns_values_2_cell_0_right_q <= select_2244;
      census_columns_values_2_cell_1_left_q <= select_2246;
      census_columns_values_2_cell_1_right_q <= select_2247;
      census_columns_values_2_cell_2_left_q <= select_2249;
      census_columns_values_2_cell_2_right_q <= select_2250;
      census_columns_values_2_cell_3_left_q <= select_2252;
      census_columns_values_2_cell_3_right_q <= select_2253;
      census_columns_values_2_cell_4_left_q <= select_2255;
      census_columns_values_2_cell_4_right_q <= select_2256;
      census_columns_values_3_cell_1_left_q <= select_2259;
      census_columns_values_3_cell_1_right_q <= select_2260;
      census_columns_values_3_cell_3_left_q <= select_2263;
      census_columns_values_3_cell_3_right_q <= select_2264;
      sharpness_last_mean_0_q <= and_552_s15_q ? select_558_s15_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_552_s15_q ? select_562_s15_q : sharpness_last_mean_1_q;
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
  logic [10:0] patches_down_values_3_s16_q;
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
  logic [3:0] select_511_s16_q;
  logic row_starts_s16_q;
  logic [6:0] select_546_s16_q;
  logic [6:0] last_s16_q;
  logic and_550_s16_q;
  logic and_552_s16_q;
  logic equal_555_s16_q;
  logic whole_2_s16_q;
  logic equal_572_s16_q;
  logic equal_577_s16_q;
  logic not_578_s16_q;
  logic so_s16_q;
  logic not_580_s16_q;
  logic equal_581_s16_q;
  logic inside_v_s16_q;
  logic [6:0] x_s16_2_q;
  logic [6:0] right_s16_q;
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
  logic less_675_s16_q;
  logic less_676_s16_q;
  logic less_677_s16_q;
  logic less_678_s16_q;
  logic less_679_s16_q;
  logic less_680_s16_q;
  logic less_681_s16_q;
  logic less_682_s16_q;
  logic and_690_s16_q;
  logic and_694_s16_q;
  logic difference_717_s16_q;
  logic [8:0] xor_718_s16_q;
  logic difference_720_s16_q;
  logic [8:0] xor_721_s16_q;
  logic difference_724_s16_q;
  logic [8:0] xor_725_s16_q;
  logic difference_728_s16_q;
  logic [8:0] xor_729_s16_q;
  logic difference_732_s16_q;
  logic [8:0] xor_733_s16_q;
  logic [9:0] half_grey_levels_s16_q;
  logic [9:0] half_grey_levels_2_s16_q;
  logic [5:0] select_1525_s16_q;
  logic [2:0] select_1530_s16_q;
  logic [7:0] select_1531_s16_q;
  logic [7:0] select_1539_s16_q;
  logic [7:0] select_1542_s16_q;
  logic [6:0] select_1560_s16_q;
  logic [5:0] select_1562_s16_q;
  logic [7:0] select_1565_s16_q;
  logic [7:0] select_1568_s16_q;
  logic and_1569_s16_q;
  logic [7:0] select_1574_s16_q;
  logic [6:0] select_1575_s16_q;
  logic [6:0] select_1578_s16_q;
  logic [6:0] select_1579_s16_q;
  logic and_1602_s16_q;
  logic and_1605_s16_q;
  logic and_1608_s16_q;
  logic and_1611_s16_q;
  logic and_1614_s16_q;
  logic equal_1615_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1621_s16_q;
  logic equal_1623_s16_q;
  logic equal_1625_s16_q;
  logic equal_1627_s16_q;
  logic equal_1629_s16_q;
  logic equal_1631_s16_q;
  logic equal_1633_s16_q;
  logic equal_1635_s16_q;
  logic equal_1637_s16_q;
  logic less_1646_s16_q;
  logic or_1650_s16_q;
  logic equal_1670_s16_q;
  logic and_1680_s16_q;
  logic select_1697_s16_q;
  logic equal_1698_s16_q;
  logic [22:0] patches_choices_rdata_s16_q;
  logic and_1706_s16_q;
  logic equal_1708_s16_q;
  logic and_1745_s16_q;
  logic [7:0] select_1752_s16_q;
  logic [5:0] select_1757_s16_q;
  logic [7:0] select_1783_s16_q;
  logic and_1790_s16_q;
  logic and_1791_s16_q;
  logic equal_1792_s16_q;
  logic equal_1794_s16_q;
  logic equal_1797_s16_q;
  logic or_1798_s16_q;
  logic not_1799_s16_q;
  logic and_1807_s16_q;
  logic [4:0] select_1822_s16_q;
  logic select_1828_s16_q;
  logic [3:0] select_1866_s16_q;
  logic less_1882_s16_q;
  logic new_row_s16_q;
  logic or_1895_s16_q;
  logic [27:0] patches_right_codes_rdata_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic down_2_s16_q;
  logic sum_1909_s16_q;
  logic [12:0] sum_1910_s16_q;
  logic [14:0] difference_1930_s16_q;
  logic and_1955_s16_q;
  logic [47:0] patches_left_codes_rdata_s16_q;
  logic and_1964_s16_q;
  logic and_1969_s16_q;
  logic or_1987_s16_q;
  logic or_1990_s16_q;
  logic or_1993_s16_q;
  logic not_1995_s16_q;
  logic [29:0] regions_rdata_s16_q;
  logic and_2009_s16_q;
  logic and_2015_s16_q;
  logic and_2026_s16_q;
  logic and_2031_s16_q;
  logic select_2059_s16_q;
  logic not_2061_s16_q;
  logic select_2073_s16_q;
  logic and_2075_s16_q;
  logic and_2076_s16_q;
  logic [1:0] sum_2080_s16_q;
  logic or_2092_s16_q;
  logic or_2095_s16_q;
  logic or_2098_s16_q;
  logic and_2109_s16_q;
  logic [2:0] sum_2115_s16_q;
  logic and_2125_s16_q;
  logic [2:0] sum_2131_s16_q;
  logic and_2150_s16_q;
  logic sum_2187_s16_q;
  logic [9:0] difference_2188_s16_q;
  logic sum_2195_s16_q;
  logic [9:0] difference_2196_s16_q;
  logic difference_2268_s16_q;
  logic [8:0] xor_2269_s16_q;
  logic difference_2271_s16_q;
  logic [8:0] xor_2272_s16_q;
  logic difference_2275_s16_q;
  logic [8:0] xor_2276_s16_q;
  logic difference_2279_s16_q;
  logic [8:0] xor_2280_s16_q;
  logic difference_2283_s16_q;
  logic [8:0] xor_2284_s16_q;
  logic equal_2293_s16_q;
  logic equal_2308_s16_q;
  logic difference_2379_s16_q;
  logic [8:0] xor_2380_s16_q;
  logic difference_2391_s16_q;
  logic [8:0] xor_2392_s16_q;
  logic equal_2482_s16_q;
  logic and_2617_s16_q;
  logic and_2624_s16_q;
  logic and_2629_s16_q;
  logic not_2645_s16_q;
  logic and_2646_s16_q;
  logic [2:0] sum_2652_s16_q;
  logic and_2724_s16_q;
  logic and_2742_s16_q;
  logic and_2750_s16_q;
  logic and_2784_s16_q;
  logic and_2785_s16_q;
  logic [7:0] residual_s16_q;
  logic less_2820_s16_q;
  logic less_2834_s16_q;
  logic equal_2877_s16_q;
  logic and_3022_s16_q;
  logic less_3148_s16_q;
  logic equal_3491_s16_q;
  logic [9:0] select_3577_s16_q;
  logic [4:0] select_3578_s16_q;
  logic [4:0] select_3579_s16_q;
  logic equal_3588_s16_q;
  logic less_3616_s16_q;
  logic [9:0] eight_s16_q;
  logic [9:0] fall_2_s16_q;
  logic equal_3684_s16_q;
  logic and_3900_s16_q;
  logic equal_3916_s16_q;
  logic equal_3919_s16_q;
  logic equal_3921_s16_q;
  logic equal_3922_s16_q;
  logic equal_3923_s16_q;
  logic equal_3924_s16_q;
  logic equal_3950_s16_q;
  logic [13:0] of_s16_q;
  logic or_4066_s16_q;
  logic and_4080_s16_q;
  logic and_4097_s16_q;
  logic not_4109_s16_q;
  logic equal_4162_s16_q;
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
      patches_down_values_3_s16_q <= patches_down_values_3_q;
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
      select_511_s16_q <= select_511_s15_q;
      row_starts_s16_q <= row_starts_s15_q;
      select_546_s16_q <= select_546_s15_q;
      last_s16_q <= last_s15_q;
      and_550_s16_q <= and_550_s15_q;
      and_552_s16_q <= and_552_s15_q;
      equal_555_s16_q <= equal_555_s15_q;
      whole_2_s16_q <= whole_2_s15_q;
      equal_572_s16_q <= equal_572_s15_q;
      equal_577_s16_q <= equal_577_s15_q;
      not_578_s16_q <= not_578_s15_q;
      so_s16_q <= so_s15_q;
      not_580_s16_q <= not_580_s15_q;
      equal_581_s16_q <= equal_581_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      x_s16_2_q <= x_s15_2_q;
      right_s16_q <= right_s15_q;
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
      less_675_s16_q <= less_675;
      less_676_s16_q <= less_676;
      less_677_s16_q <= less_677;
      less_678_s16_q <= less_678;
      less_679_s16_q <= less_679;
      less_680_s16_q <= less_680;
      less_681_s16_q <= less_681;
      less_682_s16_q <= less_682;
      and_690_s16_q <= select_688[4] & select_689[3];
      and_694_s16_q <= and_694;
      difference_717_s16_q <= difference_717[9];
      xor_718_s16_q <= difference_717[8:0] ^ {9{difference_717[9]}};
      difference_720_s16_q <= difference_720[9];
      xor_721_s16_q <= difference_720[8:0] ^ {9{difference_720[9]}};
      difference_724_s16_q <= difference_724[9];
      xor_725_s16_q <= difference_724[8:0] ^ {9{difference_724[9]}};
      difference_728_s16_q <= difference_728[9];
      xor_729_s16_q <= difference_728[8:0] ^ {9{difference_728[9]}};
      difference_732_s16_q <= difference_732[9];
      xor_733_s16_q <= difference_732[8:0] ^ {9{difference_732[9]}};
      half_grey_levels_s16_q <= half_grey_levels;
      half_grey_levels_2_s16_q <= half_grey_levels_2;
      select_1525_s16_q <= or_1524_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[5:0];
      select_1530_s16_q <= or_1524_s15_q ? select_1529_s15_q : best_left_rdata_s15_q[8:6];
      select_1531_s16_q <= or_1524_s15_q ? of_best_s15_q : best_left_rdata_s15_q[16:9];
      select_1539_s16_q <= or_1524_s15_q ? select_1538_s15_q : best_left_rdata_s15_q[24:17];
      select_1542_s16_q <= or_1524_s15_q ? select_1541_s15_q : best_left_rdata_s15_q[32:25];
      select_1560_s16_q <= select_1560_s15_q;
      select_1562_s16_q <= select_1562_s15_q;
      select_1565_s16_q <= select_1565_s15_q;
      select_1568_s16_q <= select_1568_s15_q;
      and_1569_s16_q <= and_1569_s15_q;
      select_1574_s16_q <= or_1573_s15_q ? of_best_s15_q : best_right_rdata_s15_q[7:0];
      select_1575_s16_q <= or_1573_s15_q ? x_s15_2_q : best_right_rdata_s15_q[14:8];
      select_1578_s16_q <= select_1578_s15_q;
      select_1579_s16_q <= select_1579_s15_q;
      and_1602_s16_q <= not_590_s15_q & and_1601;
      and_1605_s16_q <= and_1605;
      and_1608_s16_q <= and_1608_s15_q;
      and_1611_s16_q <= not_590_s15_q & and_1610;
      and_1614_s16_q <= and_1614;
      equal_1615_s16_q <= equal_1615_s15_q;
      all_s16_q <= all_s15_q;
      sum_1621_s16_q <= sum_1621_s15_q;
      equal_1623_s16_q <= equal_1623_s15_q;
      equal_1625_s16_q <= equal_1625_s15_q;
      equal_1627_s16_q <= equal_1627_s15_q;
      equal_1629_s16_q <= equal_1629_s15_q;
      equal_1631_s16_q <= equal_1631_s15_q;
      equal_1633_s16_q <= equal_1633_s15_q;
      equal_1635_s16_q <= equal_1635_s15_q;
      equal_1637_s16_q <= equal_1637_s15_q;
      less_1646_s16_q <= less_1646_s15_q;
      or_1650_s16_q <= or_1650_s15_q;
      equal_1670_s16_q <= (registration_fresh_q & select_1668_s15_q) == 4'h0;
      and_1680_s16_q <= not_578_s15_q & and_1664;
      select_1697_s16_q <= select_1697_s15_q;
      equal_1698_s16_q <= equal_1698_s15_q;
      patches_choices_rdata_s16_q <= patches_choices_rdata_q;
      and_1706_s16_q <= and_1706_s15_q;
      equal_1708_s16_q <= equal_1708_s15_q;
      and_1745_s16_q <= and_1745;
      select_1752_s16_q <= equal_577_s15_q ? 8'h0 : select_1751;
      select_1757_s16_q <= select_1757_s15_q;
      select_1783_s16_q <= select_1783_s15_q;
      and_1790_s16_q <= and_1790_s15_q;
      and_1791_s16_q <= and_1791_s15_q;
      equal_1792_s16_q <= equal_1792_s15_q;
      equal_1794_s16_q <= equal_1794_s15_q;
      equal_1797_s16_q <= equal_1797_s15_q;
      or_1798_s16_q <= or_1798_s15_q;
      not_1799_s16_q <= not_1799_s15_q;
      and_1807_s16_q <= and_1807_s15_q;
      select_1822_s16_q <= select_1822_s15_q;
      select_1828_s16_q <= select_1828_s15_q;
      select_1866_s16_q <= select_1866_s15_q;
      less_1882_s16_q <= less_1882_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1895_s16_q <= or_1895_s15_q;
      patches_right_codes_rdata_s16_q <= patches_right_codes_rdata_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[0];
      sum_1909_s16_q <= sum_1909[0];
      sum_1910_s16_q <= sum_1910;
      difference_1930_s16_q <= difference_1930;
      and_1955_s16_q <= and_1955_s15_q;
      patches_left_codes_rdata_s16_q <= patches_left_codes_rdata_q;
      and_1964_s16_q <= and_1964_s15_q;
      and_1969_s16_q <= and_1969_s15_q;
      or_1987_s16_q <= or_1987_s15_q;
      or_1990_s16_q <= or_1990_s15_q;
      or_1993_s16_q <= or_1993_s15_q;
      not_1995_s16_q <= not_1995_s15_q;
      regions_rdata_s16_q <= regions_rdata_q;
      and_2009_s16_q <= and_2009_s15_q;
      and_2015_s16_q <= inside_v_s15_q & (and_638_s15_q & not_2007_s15_q);
      and_2026_s16_q <= and_2026;
      and_2031_s16_q <= and_2031_s15_q;
      select_2059_s16_q <= read_half_q;
      not_2061_s16_q <= not_2061_s15_q;
      select_2073_s16_q <= select_2073_s15_q;
      and_2075_s16_q <= and_2075_s15_q;
      and_2076_s16_q <= seen_columns_rdata_s15_q[9] & inside_v_s15_q;
      sum_2080_s16_q <= sum_2080;
      or_2092_s16_q <= or_2092_s15_q;
      or_2095_s16_q <= or_2095_s15_q;
      or_2098_s16_q <= or_2098_s15_q;
      and_2109_s16_q <= and_2109_s15_q;
      sum_2115_s16_q <= {2'h0, and_2110} + {1'b0, sum_2114};
      and_2125_s16_q <= and_2125_s15_q;
      sum_2131_s16_q <= {2'h0, and_2126} + {1'b0, sum_2130};
      and_2150_s16_q <= and_2150_s15_q;
      sum_2187_s16_q <= sum_2187[0];
      difference_2188_s16_q <= {1'b0, sum_2187[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2195_s16_q <= sum_2195[0];
      difference_2196_s16_q <= {1'b0, sum_2195[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2268_s16_q <= difference_2268[9];
      xor_2269_s16_q <= difference_2268[8:0] ^ {9{difference_2268[9]}};
      difference_2271_s16_q <= difference_2271[9];
      xor_2272_s16_q <= difference_2271[8:0] ^ {9{difference_2271[9]}};
      difference_2275_s16_q <= difference_2275[9];
      xor_2276_s16_q <= difference_2275[8:0] ^ {9{difference_2275[9]}};
      difference_2279_s16_q <= difference_2279[9];
      xor_2280_s16_q <= difference_2279[8:0] ^ {9{difference_2279[9]}};
      difference_2283_s16_q <= difference_2283[9];
      xor_2284_s16_q <= difference_2283[8:0] ^ {9{difference_2283[9]}};
      equal_2293_s16_q <= equal_2293_s15_q;
      equal_2308_s16_q <= equal_2308;
      difference_2379_s16_q <= difference_2379[9];
      xor_2380_s16_q <= difference_2379[8:0] ^ {9{difference_2379[9]}};
      difference_2391_s16_q <= difference_2391[9];
      xor_2392_s16_q <= difference_2391[8:0] ^ {9{difference_2391[9]}};
      equal_2482_s16_q <= equal_2482_s15_q;
      and_2617_s16_q <= and_2617;
      and_2624_s16_q <= and_2624_s15_q;
      and_2629_s16_q <= and_2629;
      not_2645_s16_q <= not_2645_s15_q;
      and_2646_s16_q <= and_2646_s15_q;
      sum_2652_s16_q <= {2'h0, and_2647} + {1'b0, sum_2651};
      and_2724_s16_q <= and_2724;
      and_2742_s16_q <= not_578_s15_q & (so_s15_q & (ends_cell_s15_q & and_2739));
      and_2750_s16_q <= not_578_s15_q & (so_s15_q & (ends_cell_s15_q & and_2747));
      and_2784_s16_q <= and_2784_s15_q;
      and_2785_s16_q <= and_2785_s15_q;
      residual_s16_q <= residual_s15_q[7:0];
      less_2820_s16_q <= $signed(difference_2819) < $signed({7'h0, cfg_moved_limit_i});
      less_2834_s16_q <= less_2834;
      equal_2877_s16_q <= (registration_fresh_q & select_2875) == 4'h0;
      and_3022_s16_q <= and_3022_s15_q;
      less_3148_s16_q <= less_3148_s15_q;
      equal_3491_s16_q <= equal_3491_s15_q;
      select_3577_s16_q <= select_3577_s15_q;
      select_3578_s16_q <= select_3578_s15_q;
      select_3579_s16_q <= select_3579_s15_q;
      equal_3588_s16_q <= equal_3588_s15_q;
      less_3616_s16_q <= less_3616_s15_q;
      eight_s16_q <= eight;
      fall_2_s16_q <= fall_2;
      equal_3684_s16_q <= equal_3684;
      and_3900_s16_q <= equal_3899_s15_q & equal_3684;
      equal_3916_s16_q <= equal_3916_s15_q;
      equal_3919_s16_q <= equal_3919_s15_q;
      equal_3921_s16_q <= equal_3921;
      equal_3922_s16_q <= equal_3922_s15_q;
      equal_3923_s16_q <= equal_3923_s15_q;
      equal_3924_s16_q <= equal_3924_s15_q;
      equal_3950_s16_q <= (limit & select_3948) == 8'h0;
      of_s16_q <= of;
      or_4066_s16_q <= or_4066_s15_q;
      and_4080_s16_q <= and_4080_s15_q;
      and_4097_s16_q <= and_4097_s15_q;
      not_4109_s16_q <= not_4109_s15_q;
      equal_4162_s16_q <= (registration_fresh_q & select_4160) == 4'h0;
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
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
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
  // hls/stages/agreement.hpp:461
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_694_s16_q;
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
  logic [9:0] sum_719;
  assign sum_719 = {9'h0, difference_717_s16_q} + {1'b0, xor_718_s16_q};
  logic [9:0] sum_722;
  assign sum_722 = {9'h0, difference_720_s16_q} + {1'b0, xor_721_s16_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_744;
  assign sum_744 = {half_grey_levels_s16_q[9], half_grey_levels_s16_q[9:4]} + 7'h7f;
  logic less_745;
  assign less_745 = {{5{sum_744[6]}}, sum_744, half_grey_levels_s16_q[3:0]} < 16'hffe1;
  logic [6:0] sum_750;
  assign sum_750 = {half_grey_levels_2_s16_q[9], half_grey_levels_2_s16_q[9:4]} + 7'h7f;
  logic less_751;
  assign less_751 = {{5{sum_750[6]}}, sum_750, half_grey_levels_2_s16_q[3:0]} < 16'hffe1;
  // hls/stages/patches.hpp:157
  logic and_1747;
  assign and_1747 = and_1745_s16_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_1748;
  assign select_1748 = and_1747 ? and_1745_s16_q : patches_choice_valid_q;
  logic [7:0] select_1753;
  assign select_1753 = and_1747 ? select_1752_s16_q : patches_choice_column_q;
  logic [5:0] select_1758;
  assign select_1758 = and_1747 ? select_1757_s16_q : patches_choice_shift_q;
  logic [7:0] select_1784;
  assign select_1784 = and_1747 ? select_1783_s16_q : patches_choice_slope_q;
  // hls/stages/patches.hpp:357
  logic [22:0] select_1808;
  assign select_1808 = and_1807_s16_q ? {select_1784, select_1758, select_1753, select_1748} : patches_choices_rdata_s16_q;
  // hls/stages/patches.hpp:475
  logic [14:0] sum_1911;
  assign sum_1911 = {{4{patches_down_values_3_s16_q[10]}}, patches_down_values_3_s16_q} + {sum_1910_s16_q, sum_1909_s16_q, down_2_s16_q};
  // hls/stages/patches.hpp:454
  logic and_1934;
  assign and_1934 = difference_1930_s16_q[8] & (~(difference_1930_s16_q[7:0] == 8'h0));
  // hls/stages/patches.hpp:457
  logic and_1938;
  assign and_1938 = (~difference_1930_s16_q[14]) & (and_1934 | (~(difference_1930_s16_q[13:9] == 5'h0)));
  // hls/stages/patches.hpp:453
  logic and_1941;
  assign and_1941 = difference_1930_s16_q[14] & (~(difference_1930_s16_q[13:8] == 6'h3f));
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2010;
  assign select_2010 = segment_started_s16_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:911
  logic [6:0] sum_2011;
  assign sum_2011 = {6'h0, and_2009_s16_q} + select_2010;
  // hls/stages/agreement.hpp:1075
  logic [9:0] sum_2013;
  assign sum_2013 = {3'h0, sum_2011} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[9:0]);
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2016;
  assign select_2016 = segment_started_s16_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:911
  logic [6:0] sum_2017;
  assign sum_2017 = {6'h0, and_2015_s16_q} + select_2016;
  // hls/stages/agreement.hpp:1076
  logic [9:0] sum_2019;
  assign sum_2019 = {3'h0, sum_2017} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[19:10]);
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2027;
  assign select_2027 = segment_started_s16_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:912
  logic [6:0] sum_2028;
  assign sum_2028 = {6'h0, and_2026_s16_q} + select_2027;
  // hls/stages/agreement.hpp:1077
  logic [9:0] sum_2030;
  assign sum_2030 = {3'h0, sum_2028} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[29:20]);
  // hls/stages/agreement.hpp:1290
  logic or_2042;
  assign or_2042 = marks_first_s16_q | line_ended_q;
  // hls/stages/agreement.hpp:1292
  logic [12:0] select_2044;
  assign select_2044 = marks_first_s16_q ? 13'h1 : (or_2042 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1291
  logic [8:0] select_2046;
  assign select_2046 = or_2042 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1299
  logic select_2048;
  assign select_2048 = cfg_compete_i ? (or_2042 & select_2044[12]) : (select_2046[8] & select_2044[9]);
  // hls/stages/agreement.hpp:1101
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2075_s16_q} + ({2'h0, and_2076_s16_q} + {1'b0, sum_2080_s16_q});
  // hls/stages/agreement.hpp:1103
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2109_s16_q} + sum_2115_s16_q;
  // hls/stages/agreement.hpp:1110
  logic [2:0] select_2117;
  assign select_2117 = age_s16_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1104
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2125_s16_q} + sum_2131_s16_q;
  // hls/stages/agreement.hpp:1111
  logic [2:0] select_2133;
  assign select_2133 = age_s16_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:221
  logic [9:0] xor_2189;
  assign xor_2189 = {difference_2188_s16_q[8:0], sum_2187_s16_q} ^ {10{difference_2188_s16_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2188_s16_q[9]} + {1'b0, xor_2189};
  logic [9:0] xor_2197;
  assign xor_2197 = {difference_2196_s16_q[8:0], sum_2195_s16_q} ^ {10{difference_2196_s16_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2196_s16_q[9]} + {1'b0, xor_2197};
  // hls/stages/agreement.hpp:530
  logic select_2213;
  assign select_2213 = and_552_s16_q ? whole_2_s16_q : census_columns_values_0_cell_0_mask_q;
  logic select_2229;
  assign select_2229 = and_552_s16_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2232;
  assign select_2232 = and_552_s16_q ? census_columns_values_0_cell_1_mask_s16_q : census_columns_values_1_cell_1_mask_q;
  logic select_2239;
  assign select_2239 = and_552_s16_q ? census_columns_values_0_cell_3_mask_s16_q : census_columns_values_1_cell_3_mask_q;
  logic select_2242;
  assign select_2242 = and_552_s16_q ? census_columns_values_0_cell_4_mask_s16_q : census_columns_values_1_cell_4_mask_q;
  logic select_2245;
  assign select_2245 = and_552_s16_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2248;
  assign select_2248 = and_552_s16_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] sum_2270;
  assign sum_2270 = {9'h0, difference_2268_s16_q} + {1'b0, xor_2269_s16_q};
  logic [9:0] sum_2273;
  assign sum_2273 = {9'h0, difference_2271_s16_q} + {1'b0, xor_2272_s16_q};
  // hls/stages/moments.hpp:65
  logic [13:0] sum_2305;
  assign sum_2305 = {13'h0, moments_turns_0_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2307;
  assign sum_2307 = {13'h0, moments_turns_1_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:798
  logic and_2348;
  assign and_2348 = not_580_s16_q & (equal_581_s16_q & (inside_v_s16_q & and_1605_s16_q));
  logic and_2352;
  assign and_2352 = not_580_s16_q & (equal_581_s16_q & (inside_v_s16_q & and_1614_s16_q));
  // hls/stages/census.hpp:371
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2379_s16_q} + xor_2380_s16_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2391_s16_q} + xor_2392_s16_q;
  // hls/stages/agreement.hpp:798
  logic and_2634;
  assign and_2634 = not_578_s16_q & (so_s16_q & (ends_cell_s16_q & and_2015_s16_q));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2636;
  assign select_2636 = and_2617_s16_q ? 14'h0 : (counts_explained_q + {13'h0, and_2634});
  // hls/stages/agreement.hpp:798
  logic and_2639;
  assign and_2639 = not_578_s16_q & (so_s16_q & (ends_cell_s16_q & and_2026_s16_q));
  // hls/stages/agreement.hpp:1102
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2646_s16_q} + sum_2652_s16_q;
  // hls/stages/agreement.hpp:1109
  logic [2:0] select_2654;
  assign select_2654 = age_s16_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1147
  logic less_2670;
  assign less_2670 = region_row_s16_q < x_s16_q[5:3];
  // hls/stages/patches.hpp:349
  logic not_3012;
  assign not_3012 = ~and_1790_s16_q;
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_1895_s16_q ? patches_right_codes_rdata_s16_q : 28'h0;
  // hls/stages/patches.hpp:526
  logic [47:0] select_3181;
  assign select_3181 = new_row_s16_q ? patches_left_codes_rdata_s16_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3183;
  assign select_3183 = equal_1792_s16_q ? patches_left_row_q : (equal_1794_s16_q ? select_3181 : patches_left_row_q);
  logic [4:0] select_3528;
  assign select_3528 = equal_1794_s16_q ? patches_along_s16_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3585;
  assign select_3585 = (patches_read_far_s16_q < patches_peak_far_q) ? patches_read_far_s16_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3587;
  assign select_3587 = equal_1792_s16_q ? (patches_read_first_s16_q ? patches_read_far_s16_q : select_3585) : patches_peak_far_q;
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3625;
  assign sum_3625 = {1'b0, fall_2_s16_q} + {2'h0, fall_2_s16_q[9:1]};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3629;
  assign sum_3629 = {1'b0, fall_2_s16_q} + {3'h0, fall_2_s16_q[9:2]};
  logic less_3633;
  assign less_3633 = {eight_s16_q, 3'h0} < ({fall_2_s16_q, 3'h0} - {3'h0, fall_2_s16_q});
  // hls/stages/agreement.hpp:1246
  logic [13:0] select_3937;
  assign select_3937 = equal_3684_s16_q ? 14'h0 : product_q;
  logic [13:0] select_3956;
  assign select_3956 = equal_3950_s16_q ? 14'h0 : of_s16_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3937} + {1'b0, select_3956};
  // hls/stages/agreement.hpp:798
  logic [2:0] select_3998;
  assign select_3998 = so_s16_q ? (ends_cell_s16_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4000;
  assign select_4000 = ends_cell_s16_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4002;
  assign select_4002 = equal_577_s16_q ? box_explained_columns_values_1_q : (so_s16_q ? select_4000 : box_explained_columns_values_1_q);
  logic [2:0] select_4003;
  assign select_4003 = ends_cell_s16_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4005;
  assign select_4005 = equal_577_s16_q ? box_explained_columns_values_2_q : (so_s16_q ? select_4003 : box_explained_columns_values_2_q);
  logic [2:0] select_4006;
  assign select_4006 = ends_cell_s16_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4008;
  assign select_4008 = equal_577_s16_q ? box_explained_columns_values_3_q : (so_s16_q ? select_4006 : box_explained_columns_values_3_q);
  logic [2:0] select_4009;
  assign select_4009 = ends_cell_s16_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4011;
  assign select_4011 = equal_577_s16_q ? box_explained_columns_values_4_q : (so_s16_q ? select_4009 : box_explained_columns_values_4_q);
  logic [2:0] select_4016;
  assign select_4016 = so_s16_q ? (ends_cell_s16_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4018;
  assign select_4018 = ends_cell_s16_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4020;
  assign select_4020 = equal_577_s16_q ? box_shown_columns_values_1_q : (so_s16_q ? select_4018 : box_shown_columns_values_1_q);
  logic [2:0] select_4021;
  assign select_4021 = ends_cell_s16_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4023;
  assign select_4023 = equal_577_s16_q ? box_shown_columns_values_2_q : (so_s16_q ? select_4021 : box_shown_columns_values_2_q);
  logic [2:0] select_4024;
  assign select_4024 = ends_cell_s16_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4026;
  assign select_4026 = equal_577_s16_q ? box_shown_columns_values_3_q : (so_s16_q ? select_4024 : box_shown_columns_values_3_q);
  logic [2:0] select_4027;
  assign select_4027 = ends_cell_s16_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4029;
  assign select_4029 = equal_577_s16_q ? box_shown_columns_values_4_q : (so_s16_q ? select_4027 : box_shown_columns_values_4_q);
  logic [2:0] select_4034;
  assign select_4034 = so_s16_q ? (ends_cell_s16_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4036;
  assign select_4036 = ends_cell_s16_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4038;
  assign select_4038 = equal_577_s16_q ? box_nearer_columns_values_1_q : (so_s16_q ? select_4036 : box_nearer_columns_values_1_q);
  logic [2:0] select_4039;
  assign select_4039 = ends_cell_s16_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4041;
  assign select_4041 = equal_577_s16_q ? box_nearer_columns_values_2_q : (so_s16_q ? select_4039 : box_nearer_columns_values_2_q);
  logic [2:0] select_4042;
  assign select_4042 = ends_cell_s16_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4044;
  assign select_4044 = equal_577_s16_q ? box_nearer_columns_values_3_q : (so_s16_q ? select_4042 : box_nearer_columns_values_3_q);
  logic [2:0] select_4045;
  assign select_4045 = ends_cell_s16_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4047;
  assign select_4047 = equal_577_s16_q ? box_nearer_columns_values_4_q : (so_s16_q ? select_4045 : box_nearer_columns_values_4_q);

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s16_2_q;
  logic best_left_we;
  assign best_left_we = s16_en & and_1569_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1568_s16_q, select_1565_s16_q, select_1562_s16_q, select_1560_s16_q, select_1542_s16_q, select_1539_s16_q, select_1531_s16_q, select_1530_s16_q, select_1525_s16_q};
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
  assign best_right_we = s16_en & and_1569_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1579_s16_q, select_1578_s16_q, select_1575_s16_q, select_1574_s16_q};
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
  assign left_turns_we = s16_en & and_1608_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1605_s16_q, and_1602_s16_q};
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
  assign right_turns_we = s16_en & and_1608_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1614_s16_q, and_1611_s16_q};
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
  assign patches_choices_waddr = {patches_choosing_band_s16_q, and_1706_s16_q};
  logic patches_choices_we;
  assign patches_choices_we = s16_en & and_1791_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {select_1784, select_1758, select_1753, select_1748};
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
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
      patches_peak_far_q <= 10'h0;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s16_en) begin
      moments_turned_0_q <= sum_2305;
      moments_turned_1_q <= sum_2307;
      moments_turns_0_q <= not_578_s16_q & and_2348;
      moments_turns_1_q <= not_578_s16_q & and_2352;
      counts_explained_q <= select_2636;
      patches_fixed_q <= not_3012 & (patches_fixed_q | (and_3022_s16_q & and_1747));
      patches_choice_valid_q <= and_1790_s16_q ? (select_1748 & not_3012) : select_1748;
      patches_choice_column_q <= select_1753;
      patches_choice_shift_q <= select_1758;
      patches_choice_slope_q <= select_1784;
      patches_left_row_q <= select_3183;
      patches_summed_row_column_q <= equal_1792_s16_q ? patches_summed_row_column_q : select_3528;
      patches_peak_far_q <= select_3587;
      segment_textured_q <= select_2010 + {6'h0, and_2629_s16_q};
      segment_explained_q <= select_2016 + {6'h0, and_2634};
      segment_nearer_q <= select_2027 + {6'h0, and_2639};
      product_q <= equal_577_s16_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2044;
      columns_passed_q <= {select_2046[7:0], or_2042};
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
      census_columns_values_0_cell_0_mask_q <= select_2213;
      census_columns_values_1_cell_0_mask_q <= select_2229;
      census_columns_values_1_cell_1_mask_q <= select_2232;
      census_columns_values_1_cell_3_mask_q <= select_2239;
      census_columns_values_1_cell_4_mask_q <= select_2242;
      census_columns_values_2_cell_0_mask_q <= select_2245;
      census_columns_values_2_cell_1_mask_q <= select_2248;
      box_explained_columns_values_0_q <= equal_577_s16_q ? box_explained_columns_values_0_q : select_3998;
      box_explained_columns_values_1_q <= select_4002;
      box_explained_columns_values_2_q <= select_4005;
      box_explained_columns_values_3_q <= select_4008;
      box_explained_columns_values_4_q <= select_4011;
      box_shown_columns_values_0_q <= equal_577_s16_q ? box_shown_columns_values_0_q : select_4016;
      box_shown_columns_values_1_q <= select_4020;
      box_shown_columns_values_2_q <= select_4023;
      box_shown_columns_values_3_q <= select_4026;
      box_shown_columns_values_4_q <= select_4029;
      box_nearer_columns_values_0_q <= equal_577_s16_q ? box_nearer_columns_values_0_q : select_4034;
      box_nearer_columns_values_1_q <= select_4038;
      box_nearer_columns_values_2_q <= select_4041;
      box_nearer_columns_values_3_q <= select_4044;
      box_nearer_columns_values_4_q <= select_4047;
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
  logic [4:0] patches_code_row_s17_q;
  logic [4:0] patches_summed_row_column_s17_q;
  logic patches_summed_last_s17_q;
  logic [4:0] patches_summed_down_by_s17_q;
  logic [2:0] region_row_s17_q;
  logic [13:0] product_s17_q;
  logic centres_values_1_textured_s17_q;
  logic centres_values_1_of_skin_s17_q;
  logic [3:0] select_511_s17_q;
  logic row_starts_s17_q;
  logic [6:0] select_546_s17_q;
  logic [6:0] last_s17_q;
  logic and_550_s17_q;
  logic and_552_s17_q;
  logic equal_555_s17_q;
  logic whole_2_s17_q;
  logic equal_572_s17_q;
  logic equal_577_s17_q;
  logic not_578_s17_q;
  logic so_s17_q;
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
  logic less_675_s17_q;
  logic less_676_s17_q;
  logic less_677_s17_q;
  logic less_678_s17_q;
  logic less_679_s17_q;
  logic less_680_s17_q;
  logic less_681_s17_q;
  logic less_682_s17_q;
  logic and_690_s17_q;
  logic whole_9_s17_q;
  logic [10:0] sum_723_s17_q;
  logic [9:0] sum_726_s17_q;
  logic [9:0] sum_730_s17_q;
  logic [9:0] sum_734_s17_q;
  logic less_745_s17_q;
  logic less_747_s17_q;
  logic less_751_s17_q;
  logic less_753_s17_q;
  logic equal_1615_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1621_s17_q;
  logic equal_1623_s17_q;
  logic equal_1625_s17_q;
  logic equal_1627_s17_q;
  logic equal_1629_s17_q;
  logic equal_1631_s17_q;
  logic equal_1633_s17_q;
  logic equal_1635_s17_q;
  logic equal_1637_s17_q;
  logic less_1646_s17_q;
  logic or_1650_s17_q;
  logic [31:0] registration_sums_rdata_s17_q;
  logic equal_1670_s17_q;
  logic and_1680_s17_q;
  logic select_1697_s17_q;
  logic equal_1698_s17_q;
  logic equal_1708_s17_q;
  logic equal_1792_s17_q;
  logic equal_1794_s17_q;
  logic equal_1797_s17_q;
  logic or_1798_s17_q;
  logic not_1799_s17_q;
  logic [22:0] select_1808_s17_q;
  logic [4:0] select_1822_s17_q;
  logic select_1828_s17_q;
  logic [3:0] select_1866_s17_q;
  logic less_1882_s17_q;
  logic new_row_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic not_1912_s17_q;
  logic and_1915_s17_q;
  logic not_1917_s17_q;
  logic and_1922_s17_q;
  logic and_1938_s17_q;
  logic and_1941_s17_q;
  logic and_1955_s17_q;
  logic and_1964_s17_q;
  logic and_1969_s17_q;
  logic or_1987_s17_q;
  logic or_1990_s17_q;
  logic or_1993_s17_q;
  logic not_1995_s17_q;
  logic [9:0] sum_2013_s17_q;
  logic [9:0] sum_2019_s17_q;
  logic [9:0] sum_2030_s17_q;
  logic and_2031_s17_q;
  logic select_2048_s17_q;
  logic select_2059_s17_q;
  logic not_2061_s17_q;
  logic select_2073_s17_q;
  logic [2:0] textured_2_s17_q;
  logic or_2092_s17_q;
  logic or_2095_s17_q;
  logic or_2098_s17_q;
  logic [3:0] difference_2118_s17_q;
  logic [3:0] difference_2134_s17_q;
  logic and_2150_s17_q;
  logic [10:0] size_s17_q;
  logic [10:0] size_2_s17_q;
  logic [10:0] sum_2274_s17_q;
  logic [9:0] sum_2277_s17_q;
  logic [9:0] sum_2281_s17_q;
  logic [9:0] sum_2285_s17_q;
  logic equal_2293_s17_q;
  logic equal_2308_s17_q;
  logic [8:0] contrast_s17_q;
  logic [8:0] contrast_2_s17_q;
  logic equal_2482_s17_q;
  logic and_2617_s17_q;
  logic and_2624_s17_q;
  logic and_2639_s17_q;
  logic not_2645_s17_q;
  logic [3:0] difference_2655_s17_q;
  logic [9:0] select_2671_s17_q;
  logic [9:0] select_2674_s17_q;
  logic and_2724_s17_q;
  logic and_2742_s17_q;
  logic and_2750_s17_q;
  logic and_2784_s17_q;
  logic and_2785_s17_q;
  logic [7:0] residual_s17_q;
  logic and_2821_s17_q;
  logic and_2835_s17_q;
  logic equal_2877_s17_q;
  logic [27:0] word_s17_q;
  logic equal_3142_s17_q;
  logic less_3148_s17_q;
  logic [47:0] select_3181_s17_q;
  logic equal_3491_s17_q;
  logic [9:0] select_3577_s17_q;
  logic [4:0] select_3578_s17_q;
  logic [4:0] select_3579_s17_q;
  logic equal_3588_s17_q;
  logic less_3616_s17_q;
  logic not_3624_s17_q;
  logic not_3627_s17_q;
  logic not_3631_s17_q;
  logic not_3634_s17_q;
  logic equal_3684_s17_q;
  logic and_3900_s17_q;
  logic less_3901_s17_q;
  logic equal_3902_s17_q;
  logic equal_3916_s17_q;
  logic equal_3919_s17_q;
  logic equal_3921_s17_q;
  logic equal_3922_s17_q;
  logic equal_3923_s17_q;
  logic equal_3924_s17_q;
  logic sum_4_s17_q;
  logic or_4066_s17_q;
  logic and_4080_s17_q;
  logic and_4097_s17_q;
  logic not_4109_s17_q;
  logic equal_4162_s17_q;
  logic [9:0] select_4172_s17_q;
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
      patches_code_row_s17_q <= patches_code_row_s16_q;
      patches_summed_row_column_s17_q <= patches_summed_row_column_q;
      patches_summed_last_s17_q <= patches_summed_last_s16_q;
      patches_summed_down_by_s17_q <= patches_summed_down_by_s16_q;
      region_row_s17_q <= region_row_s16_q;
      product_s17_q <= product_q;
      centres_values_1_textured_s17_q <= centres_values_1_textured_s16_q;
      centres_values_1_of_skin_s17_q <= centres_values_1_of_skin_s16_q;
      select_511_s17_q <= select_511_s16_q;
      row_starts_s17_q <= row_starts_s16_q;
      select_546_s17_q <= select_546_s16_q;
      last_s17_q <= last_s16_q;
      and_550_s17_q <= and_550_s16_q;
      and_552_s17_q <= and_552_s16_q;
      equal_555_s17_q <= equal_555_s16_q;
      whole_2_s17_q <= whole_2_s16_q;
      equal_572_s17_q <= equal_572_s16_q;
      equal_577_s17_q <= equal_577_s16_q;
      not_578_s17_q <= not_578_s16_q;
      so_s17_q <= so_s16_q;
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
      less_675_s17_q <= less_675_s16_q;
      less_676_s17_q <= less_676_s16_q;
      less_677_s17_q <= less_677_s16_q;
      less_678_s17_q <= less_678_s16_q;
      less_679_s17_q <= less_679_s16_q;
      less_680_s17_q <= less_680_s16_q;
      less_681_s17_q <= less_681_s16_q;
      less_682_s17_q <= less_682_s16_q;
      and_690_s17_q <= and_690_s16_q;
      whole_9_s17_q <= whole_9;
      sum_723_s17_q <= {1'b0, sum_719} + {1'b0, sum_722};
      sum_726_s17_q <= {9'h0, difference_724_s16_q} + {1'b0, xor_725_s16_q};
      sum_730_s17_q <= {9'h0, difference_728_s16_q} + {1'b0, xor_729_s16_q};
      sum_734_s17_q <= {9'h0, difference_732_s16_q} + {1'b0, xor_733_s16_q};
      less_745_s17_q <= less_745;
      less_747_s17_q <= $signed(10'h0) < $signed(half_grey_levels_s16_q);
      less_751_s17_q <= less_751;
      less_753_s17_q <= $signed(10'h0) < $signed(half_grey_levels_2_s16_q);
      equal_1615_s17_q <= equal_1615_s16_q;
      all_s17_q <= all_s16_q;
      sum_1621_s17_q <= sum_1621_s16_q;
      equal_1623_s17_q <= equal_1623_s16_q;
      equal_1625_s17_q <= equal_1625_s16_q;
      equal_1627_s17_q <= equal_1627_s16_q;
      equal_1629_s17_q <= equal_1629_s16_q;
      equal_1631_s17_q <= equal_1631_s16_q;
      equal_1633_s17_q <= equal_1633_s16_q;
      equal_1635_s17_q <= equal_1635_s16_q;
      equal_1637_s17_q <= equal_1637_s16_q;
      less_1646_s17_q <= less_1646_s16_q;
      or_1650_s17_q <= or_1650_s16_q;
      registration_sums_rdata_s17_q <= registration_sums_rdata_q;
      equal_1670_s17_q <= equal_1670_s16_q;
      and_1680_s17_q <= and_1680_s16_q;
      select_1697_s17_q <= select_1697_s16_q;
      equal_1698_s17_q <= equal_1698_s16_q;
      equal_1708_s17_q <= equal_1708_s16_q;
      equal_1792_s17_q <= equal_1792_s16_q;
      equal_1794_s17_q <= equal_1794_s16_q;
      equal_1797_s17_q <= equal_1797_s16_q;
      or_1798_s17_q <= or_1798_s16_q;
      not_1799_s17_q <= not_1799_s16_q;
      select_1808_s17_q <= select_1808;
      select_1822_s17_q <= select_1822_s16_q;
      select_1828_s17_q <= select_1828_s16_q;
      select_1866_s17_q <= select_1866_s16_q;
      less_1882_s17_q <= less_1882_s16_q;
      new_row_s17_q <= new_row_s16_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      not_1912_s17_q <= ~sum_1911[14];
      and_1915_s17_q <= sum_1911[8] & (~(sum_1911[7:0] == 8'h0));
      not_1917_s17_q <= ~(sum_1911[13:9] == 5'h0);
      and_1922_s17_q <= sum_1911[14] & (~(sum_1911[13:8] == 6'h3f));
      and_1938_s17_q <= and_1938;
      and_1941_s17_q <= and_1941;
      and_1955_s17_q <= and_1955_s16_q;
      and_1964_s17_q <= and_1964_s16_q;
      and_1969_s17_q <= and_1969_s16_q;
      or_1987_s17_q <= or_1987_s16_q;
      or_1990_s17_q <= or_1990_s16_q;
      or_1993_s17_q <= or_1993_s16_q;
      not_1995_s17_q <= not_1995_s16_q;
      sum_2013_s17_q <= sum_2013;
      sum_2019_s17_q <= sum_2019;
      sum_2030_s17_q <= sum_2030;
      and_2031_s17_q <= and_2031_s16_q;
      select_2048_s17_q <= select_2048;
      select_2059_s17_q <= select_2059_s16_q;
      not_2061_s17_q <= not_2061_s16_q;
      select_2073_s17_q <= select_2073_s16_q;
      textured_2_s17_q <= textured_2;
      or_2092_s17_q <= or_2092_s16_q;
      or_2095_s17_q <= or_2095_s16_q;
      or_2098_s17_q <= or_2098_s16_q;
      difference_2118_s17_q <= {1'b0, shown_2} - {1'b0, select_2117};
      difference_2134_s17_q <= {1'b0, near_2} - {1'b0, select_2133};
      and_2150_s17_q <= and_2150_s16_q;
      size_s17_q <= size;
      size_2_s17_q <= size_2;
      sum_2274_s17_q <= {1'b0, sum_2270} + {1'b0, sum_2273};
      sum_2277_s17_q <= {9'h0, difference_2275_s16_q} + {1'b0, xor_2276_s16_q};
      sum_2281_s17_q <= {9'h0, difference_2279_s16_q} + {1'b0, xor_2280_s16_q};
      sum_2285_s17_q <= {9'h0, difference_2283_s16_q} + {1'b0, xor_2284_s16_q};
      equal_2293_s17_q <= equal_2293_s16_q;
      equal_2308_s17_q <= equal_2308_s16_q;
      contrast_s17_q <= contrast;
      contrast_2_s17_q <= contrast_2;
      equal_2482_s17_q <= equal_2482_s16_q;
      and_2617_s17_q <= and_2617_s16_q;
      and_2624_s17_q <= and_2624_s16_q;
      and_2639_s17_q <= and_2639;
      not_2645_s17_q <= not_2645_s16_q;
      difference_2655_s17_q <= {1'b0, explained_2} - {1'b0, select_2654};
      select_2671_s17_q <= less_2670 ? 10'h0 : regions_rdata_s16_q[9:0];
      select_2674_s17_q <= less_2670 ? 10'h0 : regions_rdata_s16_q[19:10];
      and_2724_s17_q <= and_2724_s16_q;
      and_2742_s17_q <= and_2742_s16_q;
      and_2750_s17_q <= and_2750_s16_q;
      and_2784_s17_q <= and_2784_s16_q;
      and_2785_s17_q <= and_2785_s16_q;
      residual_s17_q <= residual_s16_q;
      and_2821_s17_q <= and_2785_s16_q & less_2820_s16_q;
      and_2835_s17_q <= and_2785_s16_q & less_2834_s16_q;
      equal_2877_s17_q <= equal_2877_s16_q;
      word_s17_q <= word;
      equal_3142_s17_q <= patches_along_s16_q == 5'h7;
      less_3148_s17_q <= less_3148_s16_q;
      select_3181_s17_q <= select_3181;
      equal_3491_s17_q <= equal_3491_s16_q;
      select_3577_s17_q <= select_3577_s16_q;
      select_3578_s17_q <= select_3578_s16_q;
      select_3579_s17_q <= select_3579_s16_q;
      equal_3588_s17_q <= equal_3588_s16_q;
      less_3616_s17_q <= less_3616_s16_q;
      not_3624_s17_q <= ~({eight_s16_q, 3'h0} < {3'h0, fall_2_s16_q});
      not_3627_s17_q <= ~({eight_s16_q, 3'h0} < {1'b0, sum_3625, fall_2_s16_q[0]});
      not_3631_s17_q <= ~({eight_s16_q, 3'h0} < {sum_3629, fall_2_s16_q[1:0]});
      not_3634_s17_q <= ~less_3633;
      equal_3684_s17_q <= equal_3684_s16_q;
      and_3900_s17_q <= and_3900_s16_q;
      less_3901_s17_q <= counts_explained_q < product_q;
      equal_3902_s17_q <= counts_explained_q == product_q;
      equal_3916_s17_q <= equal_3916_s16_q;
      equal_3919_s17_q <= equal_3919_s16_q;
      equal_3921_s17_q <= equal_3921_s16_q;
      equal_3922_s17_q <= equal_3922_s16_q;
      equal_3923_s17_q <= equal_3923_s16_q;
      equal_3924_s17_q <= equal_3924_s16_q;
      sum_4_s17_q <= sum_4[0];
      or_4066_s17_q <= or_4066_s16_q;
      and_4080_s17_q <= and_4080_s16_q;
      and_4097_s17_q <= and_4097_s16_q;
      not_4109_s17_q <= not_4109_s16_q;
      equal_4162_s17_q <= equal_4162_s16_q;
      select_4172_s17_q <= less_2670 ? 10'h0 : regions_rdata_s16_q[29:20];
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
  logic [51:0] patches_codes_at_q;
  logic [27:0] patches_codes_further_q;
  logic [55:0] patches_next_codes_q;
  logic patches_summed_first_q;
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
  logic [10:0] sum_727;
  assign sum_727 = sum_723_s17_q + {1'b0, sum_726_s17_q};
  // hls/stages/agreement.hpp:461
  logic and_741;
  assign and_741 = census_columns_values_0_cell_2_mask_s17_q & census_columns_values_1_cell_2_mask_q;
  logic and_742;
  assign and_742 = and_690_s17_q & and_741;
  // hls/stages/registration.hpp:265
  logic equal_1672;
  assign equal_1672 = sum_1621_s17_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1621_s17_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1678;
  assign select_1678 = equal_1672 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1679;
  assign sum_1679 = (equal_1670_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0) + {{5{select_1678[6]}}, select_1678};
  // hls/stages/patches.hpp:358
  logic [21:0] select_1812;
  assign select_1812 = select_1697_s17_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1808_s17_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1813;
  assign select_1813 = equal_1698_s17_q ? patches_place_0_column_q : select_1812[7:0];
  logic [5:0] select_1814;
  assign select_1814 = equal_1698_s17_q ? patches_place_0_shift_q : select_1812[13:8];
  // hls/stages/patches.hpp:358
  logic [21:0] select_1840;
  assign select_1840 = select_1697_s17_q ? select_1808_s17_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1841;
  assign select_1841 = equal_1698_s17_q ? patches_place_1_column_q : select_1840[7:0];
  logic [5:0] select_1842;
  assign select_1842 = equal_1698_s17_q ? patches_place_1_shift_q : select_1840[13:8];
  // hls/stages/patches.hpp:133
  logic equal_1857;
  assign equal_1857 = {select_1813[7], select_546_s17_q, select_511_s17_q} == {1'b0, select_1813[6:0], 4'h0};
  logic equal_1861;
  assign equal_1861 = {select_1841[7], select_546_s17_q, select_511_s17_q} == {1'b0, select_1841[6:0], 4'h0};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_1903;
  assign sum_1903 = patches_code_row_s17_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_1919;
  assign and_1919 = not_1912_s17_q & (and_1915_s17_q | not_1917_s17_q);
  // hls/stages/patches.hpp:494
  logic [1:0] sum_1959;
  assign sum_1959 = patches_code_row_s17_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = select_2048_s17_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1306
  logic [6:0] select_2051;
  assign select_2051 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1317
  logic equal_2054;
  assign equal_2054 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1108
  logic [2:0] select_2083;
  assign select_2083 = age_s17_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1115
  logic not_2099;
  assign not_2099 = ~region_row_s17_q[2];
  logic [2:0] select_2100;
  assign select_2100 = region_row_s17_q[1] ? {1'b0, not_2099, 1'b0} : {region_row_s17_q[2], 1'b0, not_2099};
  logic [5:0] select_2101;
  assign select_2101 = region_row_s17_q[0] ? {select_2100[2], 1'b0, select_2100[1], 1'b0, select_2100[0], 1'b0} : {1'b0, select_2100[2], 1'b0, select_2100[1], 1'b0, select_2100[0]};
  logic [11:0] select_2102;
  assign select_2102 = or_2098_s17_q ? {select_2101[5], 1'b0, select_2101[4], 1'b0, select_2101[3], 1'b0, select_2101[2], 1'b0, select_2101[1], 1'b0, select_2101[0], 1'b0} : {1'b0, select_2101[5], 1'b0, select_2101[4], 1'b0, select_2101[3], 1'b0, select_2101[2], 1'b0, select_2101[1], 1'b0, select_2101[0]};
  logic [23:0] select_2103;
  assign select_2103 = or_2095_s17_q ? {select_2102[11], 1'b0, select_2102[10], 1'b0, select_2102[9], 1'b0, select_2102[8], 1'b0, select_2102[7], 1'b0, select_2102[6], 1'b0, select_2102[5], 1'b0, select_2102[4], 1'b0, select_2102[3], 1'b0, select_2102[2], 1'b0, select_2102[1], 1'b0, select_2102[0], 1'b0} : {1'b0, select_2102[11], 1'b0, select_2102[10], 1'b0, select_2102[9], 1'b0, select_2102[8], 1'b0, select_2102[7], 1'b0, select_2102[6], 1'b0, select_2102[5], 1'b0, select_2102[4], 1'b0, select_2102[3], 1'b0, select_2102[2], 1'b0, select_2102[1], 1'b0, select_2102[0]};
  // hls/stages/agreement.hpp:1110
  logic [4:0] around;
  assign around = {difference_2118_s17_q[3], difference_2118_s17_q} + (equal_572_s17_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1111
  logic [4:0] n;
  assign n = {difference_2134_s17_q[3], difference_2134_s17_q} + (equal_572_s17_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size_s17_q} + (equal_555_s17_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2194;
  assign select_2194 = sample_pair_whole_s17_q ? (and_550_s17_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s17_q} + (equal_555_s17_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2202;
  assign select_2202 = sample_pair_whole_s17_q ? (and_550_s17_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:530
  logic select_2235;
  assign select_2235 = and_552_s17_q ? census_columns_values_0_cell_2_mask_s17_q : census_columns_values_1_cell_2_mask_q;
  logic select_2251;
  assign select_2251 = and_552_s17_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2254;
  assign select_2254 = and_552_s17_q ? census_columns_values_1_cell_3_mask_s17_q : census_columns_values_2_cell_3_mask_q;
  logic select_2257;
  assign select_2257 = and_552_s17_q ? census_columns_values_1_cell_4_mask_s17_q : census_columns_values_2_cell_4_mask_q;
  logic select_2258;
  assign select_2258 = and_552_s17_q ? census_columns_values_2_cell_0_mask_s17_q : census_columns_values_3_cell_0_mask_q;
  logic select_2261;
  assign select_2261 = and_552_s17_q ? census_columns_values_2_cell_1_mask_s17_q : census_columns_values_3_cell_1_mask_q;
  logic select_2262;
  assign select_2262 = and_552_s17_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2265;
  assign select_2265 = and_552_s17_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:286
  logic [10:0] sum_2278;
  assign sum_2278 = sum_2274_s17_q + {1'b0, sum_2277_s17_q};
  // hls/stages/moments.hpp:153
  logic [13:0] select_2309;
  assign select_2309 = equal_2308_s17_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2311;
  assign select_2311 = equal_2308_s17_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2322;
  assign sum_2322 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2332;
  assign sum_2332 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/agreement.hpp:530
  logic select_2375;
  assign select_2375 = and_552_s17_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2378;
  assign and_2378 = whole_2_s17_q & (~(last_s17_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:462
  logic and_2384;
  assign and_2384 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s17_q[8:2]));
  logic and_2385;
  assign and_2385 = and_2378 & and_2384;
  logic and_2396;
  assign and_2396 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s17_q[8:2]));
  logic and_2397;
  assign and_2397 = and_2378 & and_2396;
  // hls/stages/census.hpp:427
  logic not_2414;
  assign not_2414 = ~x_s17_q[1];
  logic [2:0] select_2415;
  assign select_2415 = x_s17_q[0] ? {1'b0, not_2414, 1'b0} : {x_s17_q[1], 1'b0, not_2414};
  logic [5:0] select_2416;
  assign select_2416 = slot_s17_q[2] ? {select_2415[2], 1'b0, select_2415[1], 1'b0, select_2415[0], 1'b0} : {1'b0, select_2415[2], 1'b0, select_2415[1], 1'b0, select_2415[0]};
  logic [11:0] select_2417;
  assign select_2417 = slot_s17_q[1] ? {select_2416[5], 1'b0, select_2416[4], 1'b0, select_2416[3], 1'b0, select_2416[2], 1'b0, select_2416[1], 1'b0, select_2416[0], 1'b0} : {1'b0, select_2416[5], 1'b0, select_2416[4], 1'b0, select_2416[3], 1'b0, select_2416[2], 1'b0, select_2416[1], 1'b0, select_2416[0]};
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2626;
  assign select_2626 = and_2617_s17_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2624_s17_q});
  logic [13:0] select_2641;
  assign select_2641 = and_2617_s17_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2639_s17_q});
  // hls/stages/agreement.hpp:1109
  logic [4:0] e;
  assign e = {difference_2655_s17_q[3], difference_2655_s17_q} + (equal_572_s17_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2744;
  assign select_2744 = and_2617_s17_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2742_s17_q});
  logic [13:0] select_2752;
  assign select_2752 = and_2617_s17_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2750_s17_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2802;
  assign select_2802 = equal_1708_s17_q ? (and_2785_s17_q ? residual_s17_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic and_2809;
  assign and_2809 = not_578_s17_q & (so_s17_q & (and_2785_s17_q & equal_1708_s17_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2811;
  assign select_2811 = and_2784_s17_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2809});
  // hls/stages/registration.hpp:107
  logic and_2813;
  assign and_2813 = and_2785_s17_q & ($signed(residual_s17_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2823;
  assign select_2823 = so_s17_q ? (equal_1708_s17_q ? {and_2821_s17_q, and_2785_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2824;
  assign select_2824 = equal_577_s17_q ? 2'h0 : select_2823;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2825;
  assign sum_2825 = registration_half_votes_up_q + {{5{select_2824[1]}}, select_2824};
  // hls/stages/registration.hpp:205
  logic less_2827;
  assign less_2827 = $signed(residual_s17_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2828;
  assign and_2828 = and_2785_s17_q & less_2827;
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2837;
  assign select_2837 = so_s17_q ? (equal_1708_s17_q ? {and_2835_s17_q, and_2785_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2838;
  assign select_2838 = equal_577_s17_q ? 2'h0 : select_2837;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2839;
  assign sum_2839 = registration_half_half_votes_up_q + {{5{select_2838[1]}}, select_2838};
  // hls/stages/agreement.hpp:1145
  logic [11:0] select_2879;
  assign select_2879 = or_1650_s17_q ? 12'h0 : (equal_2877_s17_q ? registration_sums_rdata_s17_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1157
  logic [11:0] select_2881;
  assign select_2881 = equal_1615_s17_q ? 12'h0 : (less_1646_s17_q ? select_2879 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2884;
  assign and_2884 = x_s17_q[1] & all_s17_q;
  // hls/stages/agreement.hpp:1157
  logic and_2887;
  assign and_2887 = not_1995_s17_q & (less_1646_s17_q & ({and_2884, x_s17_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1145
  logic [11:0] select_2894;
  assign select_2894 = or_1650_s17_q ? 12'h0 : (equal_2877_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1157
  logic [11:0] select_2896;
  assign select_2896 = equal_1615_s17_q ? 12'h0 : (less_1646_s17_q ? select_2894 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2902;
  assign not_2902 = ~all_s17_q;
  // hls/stages/agreement.hpp:1157
  logic and_2905;
  assign and_2905 = not_1995_s17_q & (less_1646_s17_q & (x_s17_q[2:0] == {all_s17_q, not_2902, 1'b0}));
  // hls/stages/agreement.hpp:798
  logic and_2911;
  assign and_2911 = equal_577_s17_q & (x_s17_q[6] & (not_1995_s17_q & (less_1646_s17_q & all_s17_q)));
  // hls/stages/registration.hpp:157
  logic equal_2938;
  assign equal_2938 = x_s17_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1157
  logic and_2941;
  assign and_2941 = not_1995_s17_q & (less_1646_s17_q & (x_s17_q[5] ? x_s17_q[3] : equal_2938));
  logic and_2950;
  assign and_2950 = not_1995_s17_q & (less_1646_s17_q & ((~x_s17_q[5]) & (x_s17_q[3] & equal_2938)));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3044;
  assign select_3044 = sample_pair_whole_s17_q ? (equal_1698_s17_q ? patches_place_0_slope_q : select_1812[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3049;
  assign select_3049 = sample_pair_whole_s17_q ? (equal_1698_s17_q ? patches_place_1_slope_q : select_1840[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s17_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3138;
  assign select_3138 = or_1798_s17_q ? {and_1941_s17_q, and_1938_s17_q, and_1922_s17_q, and_1919, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3140;
  assign select_3140 = equal_1792_s17_q ? patches_codes_at_q : (equal_1794_s17_q ? other[55:4] : select_3138);
  // hls/stages/patches.hpp:525
  logic [27:0] select_3143;
  assign select_3143 = equal_3142_s17_q ? word_s17_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3145;
  assign select_3145 = equal_1794_s17_q ? (new_row_s17_q ? word_s17_q : select_3143) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3147;
  assign select_3147 = less_1882_s17_q ? {word_s17_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3149;
  assign select_3149 = less_3148_s17_q ? {word_s17_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3151;
  assign select_3151 = or_1798_s17_q ? (equal_1797_s17_q ? patches_next_codes_q : select_3149) : patches_next_codes_q;
  logic [55:0] select_3153;
  assign select_3153 = equal_1792_s17_q ? patches_next_codes_q : (equal_1794_s17_q ? select_3147 : select_3151);
  // hls/stages/count_bits.hpp:24
  logic parity_3158;
  assign parity_3158 = ^{and_1941_s17_q, and_1938_s17_q, and_1922_s17_q, and_1919};
  // hls/stages/count_bits.hpp:25
  logic or_3162;
  assign or_3162 = ({and_1922_s17_q, and_1919} == 2'h3) | (and_1938_s17_q & (and_1922_s17_q | and_1919));
  logic and_3163;
  assign and_3163 = and_1941_s17_q & (^{and_1938_s17_q, and_1922_s17_q, and_1919});
  // hls/stages/count_bits.hpp:24
  logic xor_3164;
  assign xor_3164 = or_3162 ^ and_3163;
  // hls/stages/count_bits.hpp:27
  logic and_3165;
  assign and_3165 = or_3162 & and_3163;
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3181_s17_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3187;
  assign xor_3187 = bits[17] ^ (^{select_3181_s17_q[16:15], other[16:15]});
  logic xor_3190;
  assign xor_3190 = bits[11] ^ (^{select_3181_s17_q[10:9], other[10:9]});
  logic xor_3193;
  assign xor_3193 = bits[14] ^ (^{select_3181_s17_q[13:12], other[13:12]});
  logic xor_3196;
  assign xor_3196 = xor_3187 ^ (^{select_3181_s17_q[14:9], other[14:9]});
  logic xor_3199;
  assign xor_3199 = bits[47] ^ (^{select_3181_s17_q[46:45], other[46:45]});
  logic xor_3202;
  assign xor_3202 = bits[8] ^ (^{select_3181_s17_q[7:6], other[7:6]});
  logic xor_3205;
  assign xor_3205 = bits[2] ^ (^{select_3181_s17_q[1:0], other[1:0]});
  logic xor_3208;
  assign xor_3208 = bits[5] ^ (^{select_3181_s17_q[4:3], other[4:3]});
  logic xor_3211;
  assign xor_3211 = xor_3202 ^ (^{select_3181_s17_q[5:0], other[5:0]});
  logic parity_3213;
  assign parity_3213 = ^{select_3181_s17_q[47:45], select_3181_s17_q[8:0], other[47:45], other[8:0]};
  logic xor_3217;
  assign xor_3217 = bits[44] ^ (^{select_3181_s17_q[43:42], other[43:42]});
  logic xor_3220;
  assign xor_3220 = bits[38] ^ (^{select_3181_s17_q[37:36], other[37:36]});
  logic xor_3223;
  assign xor_3223 = bits[41] ^ (^{select_3181_s17_q[40:39], other[40:39]});
  logic xor_3229;
  assign xor_3229 = bits[26] ^ (^{select_3181_s17_q[25:24], other[25:24]});
  logic xor_3232;
  assign xor_3232 = bits[20] ^ (^{select_3181_s17_q[19:18], other[19:18]});
  logic xor_3235;
  assign xor_3235 = bits[23] ^ (^{select_3181_s17_q[22:21], other[22:21]});
  logic xor_3241;
  assign xor_3241 = bits[35] ^ (^{select_3181_s17_q[34:33], other[34:33]});
  logic xor_3244;
  assign xor_3244 = bits[29] ^ (^{select_3181_s17_q[28:27], other[28:27]});
  logic xor_3247;
  assign xor_3247 = bits[32] ^ (^{select_3181_s17_q[31:30], other[31:30]});
  // hls/stages/agreement.hpp:276
  logic select_3531;
  assign select_3531 = equal_1792_s17_q ? patches_summed_first_q : (equal_1794_s17_q ? new_row_s17_q : patches_summed_first_q);
  // hls/stages/patches.hpp:584
  logic [1:0] sum_3628;
  assign sum_3628 = {1'b0, not_3624_s17_q} + {1'b0, not_3627_s17_q};
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3635;
  assign sum_3635 = {1'b0, not_3631_s17_q} + {1'b0, not_3634_s17_q};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3628} + {1'b0, sum_3635};
  // hls/stages/patches.hpp:604
  logic [7:0] select_3639;
  assign select_3639 = patches_second_s17_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [3:0] sum_3640;
  assign sum_3640 = {2'h0, select_3578_s17_q[4:3]} + 4'hf;
  logic [5:0] select_3641;
  assign select_3641 = patches_second_s17_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3642;
  assign sum_3642 = {select_3641[5], select_3641} + {{4{sum_3640[3]}}, sum_3640[3:1]};
  // hls/stages/agreement.hpp:1203
  logic or_3897;
  assign or_3897 = ({counts_textured_s17_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s17_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1241
  logic too_little;
  assign too_little = less_3901_s17_q | (product_rest_q & equal_3902_s17_q);
  // hls/stages/agreement.hpp:1242
  logic select_3905;
  assign select_3905 = and_3900_s17_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1150
  logic [10:0] sum_3908;
  assign sum_3908 = {1'b0, select_2674_s17_q} + {2'h0, select_2674_s17_q[9:1]};
  // hls/stages/agreement.hpp:798
  logic select_3961;
  assign select_3961 = equal_577_s17_q ? (equal_3684_s17_q ? sum_4_s17_q : (product_rest_q | sum_4_s17_q)) : product_rest_q;
  logic [2:0] select_3979;
  assign select_3979 = ends_cell_s17_q ? textured_2_s17_q : box_textured_columns_values_0_q;
  logic [2:0] select_3981;
  assign select_3981 = equal_577_s17_q ? box_textured_columns_values_0_q : (so_s17_q ? select_3979 : box_textured_columns_values_0_q);
  logic [2:0] select_3982;
  assign select_3982 = ends_cell_s17_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3984;
  assign select_3984 = equal_577_s17_q ? box_textured_columns_values_1_q : (so_s17_q ? select_3982 : box_textured_columns_values_1_q);
  logic [2:0] select_3985;
  assign select_3985 = ends_cell_s17_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3987;
  assign select_3987 = equal_577_s17_q ? box_textured_columns_values_2_q : (so_s17_q ? select_3985 : box_textured_columns_values_2_q);
  logic [2:0] select_3988;
  assign select_3988 = ends_cell_s17_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3990;
  assign select_3990 = equal_577_s17_q ? box_textured_columns_values_3_q : (so_s17_q ? select_3988 : box_textured_columns_values_3_q);
  logic [2:0] select_3991;
  assign select_3991 = ends_cell_s17_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3993;
  assign select_3993 = equal_577_s17_q ? box_textured_columns_values_4_q : (so_s17_q ? select_3991 : box_textured_columns_values_4_q);
  logic [4:0] select_4013;
  assign select_4013 = so_s17_q ? (ends_cell_s17_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4014;
  assign select_4014 = equal_577_s17_q ? box_explained_sum_sums_values_0_q : select_4013;
  logic [4:0] select_4031;
  assign select_4031 = so_s17_q ? (ends_cell_s17_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4049;
  assign select_4049 = so_s17_q ? (ends_cell_s17_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1316
  logic [3:0] select_4083;
  assign select_4083 = select_2048_s17_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4089;
  assign select_4089 = marks_first_s17_q ? select_4087 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1155
  logic [31:0] select_4164;
  assign select_4164 = equal_1637_s17_q ? {2'h0, counts_explained_s17_q, 2'h0, counts_textured_s17_q} : (equal_4162_s17_q ? registration_sums_rdata_s17_q : 32'h0);
  logic [31:0] select_4165;
  assign select_4165 = equal_1635_s17_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4164;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1903, patches_code_row_s17_q[1:0], of_row_2_s17_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s17_en & and_1955_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1941_s17_q, and_1938_s17_q, and_1922_s17_q, and_1919, patches_codes_at_q[51:28]};
  end
`ifndef SYNTHESIS
  logic [6:0] patches_right_codes_raddr_s15_sim;
  logic patches_right_codes_re_s15_sim;
  logic [6:0] patches_right_codes_raddr_s16_sim;
  logic patches_right_codes_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_codes_re_s15_sim <= 1'b0;
      patches_right_codes_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_codes_re_s15_sim <= patches_right_codes_re;
      patches_right_codes_raddr_s15_sim <= patches_right_codes_raddr;
      patches_right_codes_re_s16_sim <= patches_right_codes_re_s15_sim;
      patches_right_codes_raddr_s16_sim <= patches_right_codes_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s15_sim && patches_right_codes_raddr_s15_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s16_sim && patches_right_codes_raddr_s16_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 7'd112) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 7'd112) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1959, patches_code_row_s17_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s17_en & and_1969_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1941_s17_q, and_1938_s17_q, and_1922_s17_q, and_1919, patches_codes_at_q[51:8]};
  end
`ifndef SYNTHESIS
  logic [3:0] patches_left_codes_raddr_s15_sim;
  logic patches_left_codes_re_s15_sim;
  logic [3:0] patches_left_codes_raddr_s16_sim;
  logic patches_left_codes_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_codes_re_s15_sim <= 1'b0;
      patches_left_codes_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_codes_re_s15_sim <= patches_left_codes_re;
      patches_left_codes_raddr_s15_sim <= patches_left_codes_raddr;
      patches_left_codes_re_s16_sim <= patches_left_codes_re_s15_sim;
      patches_left_codes_raddr_s16_sim <= patches_left_codes_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s15_sim && patches_left_codes_raddr_s15_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s16_sim && patches_left_codes_raddr_s16_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s17_q, or_1993_s17_q, or_1990_s17_q, or_1987_s17_q};
  logic regions_we;
  assign regions_we = s17_en & and_2031_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2030_s17_q, sum_2019_s17_q, sum_2013_s17_q};
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
      patches_codes_at_q <= 52'h0;
      patches_codes_further_q <= 28'h0;
      patches_next_codes_q <= 56'h0;
      patches_summed_first_q <= 1'b0;
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
      moments_before_0_q <= equal_577_s17_q ? select_2309 : moments_before_0_q;
      moments_before_1_q <= equal_577_s17_q ? select_2311 : moments_before_1_q;
      sharpness_before_last_mask_q <= select_2375;
      counts_supervised_q <= select_2626;
      counts_nearer_q <= select_2641;
      counts_turned_left_q <= select_2744;
      counts_turned_right_q <= select_2752;
      registration_half_measured_q <= select_2811;
      registration_half_votes_up_q <= and_2784_s17_q ? 7'h0 : sum_2825;
      registration_half_half_votes_up_q <= and_2784_s17_q ? 7'h0 : sum_2839;
      patches_place_0_column_q <= sample_pair_whole_s17_q ? select_1813 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s17_q ? select_1814 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3044;
      patches_place_1_column_q <= sample_pair_whole_s17_q ? select_1841 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s17_q ? select_1842 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3049;
      patches_codes_at_q <= select_3140;
      patches_codes_further_q <= equal_1792_s17_q ? patches_codes_further_q : select_3145;
      patches_next_codes_q <= select_3153;
      patches_summed_first_q <= select_3531;
      product_rest_q <= select_3961;
      disagree_q <= equal_577_s17_q ? select_3905 : disagree_q;
      began_q <= not_2061_s17_q & (began_q | select_2048_s17_q);
      seen_x_q <= select_2048_s17_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s17_q ? 4'h0 : select_4083;
      seen_column_q <= select_2048_s17_q ? 8'h0 : (seen_column_q + {7'h0, equal_2054});
      seen_rows_left_q <= select_4089;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s17_q ? 13'h0 : (seen_base_q + {6'h0, select_2051});
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
      averager_detail_0_q <= select_2194;
      averager_detail_1_q <= select_2202;
      census_columns_values_1_cell_2_mask_q <= select_2235;
      census_columns_values_2_cell_2_mask_q <= select_2251;
      census_columns_values_2_cell_3_mask_q <= select_2254;
      census_columns_values_2_cell_4_mask_q <= select_2257;
      census_columns_values_3_cell_0_mask_q <= select_2258;
      census_columns_values_3_cell_1_mask_q <= select_2261;
      census_columns_values_3_cell_2_mask_q <= select_2262;
      census_columns_values_3_cell_3_mask_q <= select_2265;
      sharpness_last_mask_q <= and_552_s17_q ? whole_2_s17_q : sharpness_last_mask_q;
      box_textured_columns_values_0_q <= select_3981;
      box_textured_columns_values_1_q <= select_3984;
      box_textured_columns_values_2_q <= select_3987;
      box_textured_columns_values_3_q <= select_3990;
      box_textured_columns_values_4_q <= select_3993;
      box_explained_sum_sums_values_0_q <= select_4014;
      box_shown_sum_sums_values_0_q <= equal_577_s17_q ? box_shown_sum_sums_values_0_q : select_4031;
      box_nearer_sum_sums_values_0_q <= equal_577_s17_q ? box_nearer_sum_sums_values_0_q : select_4049;
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
  logic [2:0] select_511_s18_q;
  logic row_starts_s18_q;
  logic [6:0] last_s18_q;
  logic and_552_s18_q;
  logic equal_572_s18_q;
  logic equal_577_s18_q;
  logic not_578_s18_q;
  logic so_s18_q;
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
  logic less_675_s18_q;
  logic less_676_s18_q;
  logic less_677_s18_q;
  logic less_678_s18_q;
  logic less_679_s18_q;
  logic less_680_s18_q;
  logic less_681_s18_q;
  logic less_682_s18_q;
  logic and_690_s18_q;
  logic whole_16_s18_q;
  logic and_716_s18_q;
  logic [11:0] sum_731_s18_q;
  logic [9:0] sum_734_s18_q;
  logic and_742_s18_q;
  logic and_746_s18_q;
  logic less_747_s18_q;
  logic less_751_s18_q;
  logic less_753_s18_q;
  logic equal_1615_s18_q;
  logic [1:0] sum_1621_s18_q;
  logic equal_1623_s18_q;
  logic equal_1625_s18_q;
  logic equal_1627_s18_q;
  logic equal_1629_s18_q;
  logic equal_1631_s18_q;
  logic equal_1633_s18_q;
  logic less_1646_s18_q;
  logic [19:0] select_1671_s18_q;
  logic equal_1672_s18_q;
  logic [11:0] sum_1679_s18_q;
  logic and_1680_s18_q;
  logic select_1697_s18_q;
  logic equal_1698_s18_q;
  logic equal_1792_s18_q;
  logic equal_1794_s18_q;
  logic equal_1797_s18_q;
  logic or_1798_s18_q;
  logic not_1799_s18_q;
  logic select_1808_s18_q;
  logic [8:0] sum_1811_s18_q;
  logic [8:0] sum_1815_s18_q;
  logic [4:0] select_1822_s18_q;
  logic select_1828_s18_q;
  logic [8:0] sum_1843_s18_q;
  logic equal_1857_s18_q;
  logic equal_1861_s18_q;
  logic [3:0] select_1866_s18_q;
  logic not_1995_s18_q;
  logic select_2059_s18_q;
  logic [7:0] sum_2071_s18_q;
  logic select_2073_s18_q;
  logic [3:0] difference_2084_s18_q;
  logic or_2092_s18_q;
  logic [23:0] select_2103_s18_q;
  logic [4:0] around_s18_q;
  logic less_2137_s18_q;
  logic and_2150_s18_q;
  logic [11:0] sum_2282_s18_q;
  logic [9:0] sum_2285_s18_q;
  logic equal_2293_s18_q;
  logic equal_2308_s18_q;
  logic [13:0] select_2316_s18_q;
  logic not_2324_s18_q;
  logic not_2327_s18_q;
  logic not_2334_s18_q;
  logic not_2337_s18_q;
  logic [27:0] select_2372_s18_q;
  logic and_2385_s18_q;
  logic and_2397_s18_q;
  logic [8:0] select_2404_s18_q;
  logic [8:0] select_2408_s18_q;
  logic equal_2411_s18_q;
  logic less_2412_s18_q;
  logic [11:0] select_2417_s18_q;
  logic equal_2455_s18_q;
  logic equal_2482_s18_q;
  logic and_2617_s18_q;
  logic not_2645_s18_q;
  logic [4:0] e_s18_q;
  logic [9:0] select_2671_s18_q;
  logic [9:0] select_2674_s18_q;
  logic and_2724_s18_q;
  logic and_2784_s18_q;
  logic [7:0] select_2804_s18_q;
  logic [1:0] select_2814_s18_q;
  logic [1:0] select_2829_s18_q;
  logic [11:0] select_2881_s18_q;
  logic and_2889_s18_q;
  logic [11:0] select_2896_s18_q;
  logic and_2907_s18_q;
  logic and_2911_s18_q;
  logic and_2943_s18_q;
  logic and_2951_s18_q;
  logic [8:0] other_s18_q;
  logic [2:0] select_3166_s18_q;
  logic [8:0] select_3181_s18_q;
  logic xor_3196_s18_q;
  logic xor_3214_s18_q;
  logic xor_3226_s18_q;
  logic xor_3238_s18_q;
  logic xor_3250_s18_q;
  logic or_3259_s18_q;
  logic or_3263_s18_q;
  logic or_3267_s18_q;
  logic or_3274_s18_q;
  logic or_3278_s18_q;
  logic or_3282_s18_q;
  logic or_3289_s18_q;
  logic or_3293_s18_q;
  logic or_3297_s18_q;
  logic or_3307_s18_q;
  logic or_3311_s18_q;
  logic or_3315_s18_q;
  logic or_3323_s18_q;
  logic or_3327_s18_q;
  logic or_3331_s18_q;
  logic or_3338_s18_q;
  logic or_3342_s18_q;
  logic or_3346_s18_q;
  logic or_3356_s18_q;
  logic or_3360_s18_q;
  logic or_3364_s18_q;
  logic and_3369_s18_q;
  logic or_3370_s18_q;
  logic equal_3491_s18_q;
  logic [9:0] select_3577_s18_q;
  logic [2:0] select_3578_s18_q;
  logic [4:0] select_3579_s18_q;
  logic [9:0] select_3587_s18_q;
  logic equal_3588_s18_q;
  logic less_3616_s18_q;
  logic [2:0] fraction_s18_q;
  logic [7:0] select_3639_s18_q;
  logic sum_3640_s18_q;
  logic [6:0] sum_3642_s18_q;
  logic equal_3684_s18_q;
  logic equal_3894_s18_q;
  logic or_3897_s18_q;
  logic select_3905_s18_q;
  logic not_3910_s18_q;
  logic equal_3916_s18_q;
  logic equal_3919_s18_q;
  logic equal_3921_s18_q;
  logic equal_3922_s18_q;
  logic equal_3923_s18_q;
  logic equal_3924_s18_q;
  logic or_4066_s18_q;
  logic and_4080_s18_q;
  logic and_4097_s18_q;
  logic not_4109_s18_q;
  logic [31:0] select_4165_s18_q;
  logic [9:0] select_4172_s18_q;
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
      patches_summed_first_s18_q <= patches_summed_first_q;
      patches_summed_last_s18_q <= patches_summed_last_s17_q;
      patches_summed_down_by_s18_q <= patches_summed_down_by_s17_q;
      product_s18_q <= product_s17_q;
      centres_values_1_textured_s18_q <= centres_values_1_textured_s17_q;
      centres_values_1_of_skin_s18_q <= centres_values_1_of_skin_s17_q;
      select_511_s18_q <= select_511_s17_q[2:0];
      row_starts_s18_q <= row_starts_s17_q;
      last_s18_q <= last_s17_q;
      and_552_s18_q <= and_552_s17_q;
      equal_572_s18_q <= equal_572_s17_q;
      equal_577_s18_q <= equal_577_s17_q;
      not_578_s18_q <= not_578_s17_q;
      so_s18_q <= so_s17_q;
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
      less_675_s18_q <= less_675_s17_q;
      less_676_s18_q <= less_676_s17_q;
      less_677_s18_q <= less_677_s17_q;
      less_678_s18_q <= less_678_s17_q;
      less_679_s18_q <= less_679_s17_q;
      less_680_s18_q <= less_680_s17_q;
      less_681_s18_q <= less_681_s17_q;
      less_682_s18_q <= less_682_s17_q;
      and_690_s18_q <= and_690_s17_q;
      whole_16_s18_q <= whole_16;
      and_716_s18_q <= census_columns_values_1_cell_2_mask_q & and_690_s17_q;
      sum_731_s18_q <= {1'b0, sum_727} + {2'h0, sum_730_s17_q};
      sum_734_s18_q <= sum_734_s17_q;
      and_742_s18_q <= and_742;
      and_746_s18_q <= and_742 & less_745_s17_q;
      less_747_s18_q <= less_747_s17_q;
      less_751_s18_q <= less_751_s17_q;
      less_753_s18_q <= less_753_s17_q;
      equal_1615_s18_q <= equal_1615_s17_q;
      sum_1621_s18_q <= sum_1621_s17_q;
      equal_1623_s18_q <= equal_1623_s17_q;
      equal_1625_s18_q <= equal_1625_s17_q;
      equal_1627_s18_q <= equal_1627_s17_q;
      equal_1629_s18_q <= equal_1629_s17_q;
      equal_1631_s18_q <= equal_1631_s17_q;
      equal_1633_s18_q <= equal_1633_s17_q;
      less_1646_s18_q <= less_1646_s17_q;
      select_1671_s18_q <= equal_1670_s17_q ? registration_sums_rdata_s17_q[19:0] : 20'h0;
      equal_1672_s18_q <= equal_1672;
      sum_1679_s18_q <= sum_1679;
      and_1680_s18_q <= and_1680_s17_q;
      select_1697_s18_q <= select_1697_s17_q;
      equal_1698_s18_q <= equal_1698_s17_q;
      equal_1792_s18_q <= equal_1792_s17_q;
      equal_1794_s18_q <= equal_1794_s17_q;
      equal_1797_s18_q <= equal_1797_s17_q;
      or_1798_s18_q <= or_1798_s17_q;
      not_1799_s18_q <= not_1799_s17_q;
      select_1808_s18_q <= select_1808_s17_q[0];
      sum_1811_s18_q <= {1'b0, select_546_s17_q, select_511_s17_q[3]} + 9'h1;
      sum_1815_s18_q <= {1'b0, select_1813} + {{3{select_1814[5]}}, select_1814};
      select_1822_s18_q <= select_1822_s17_q;
      select_1828_s18_q <= select_1828_s17_q;
      sum_1843_s18_q <= {1'b0, select_1841} + {{3{select_1842[5]}}, select_1842};
      equal_1857_s18_q <= equal_1857;
      equal_1861_s18_q <= equal_1861;
      select_1866_s18_q <= select_1866_s17_q;
      not_1995_s18_q <= not_1995_s17_q;
      select_2059_s18_q <= select_2059_s17_q;
      sum_2071_s18_q <= {2'h0, x_s17_q[7:2]} + 8'hff;
      select_2073_s18_q <= select_2073_s17_q;
      difference_2084_s18_q <= {1'b0, textured_2_s17_q} - {1'b0, select_2083};
      or_2092_s18_q <= or_2092_s17_q;
      select_2103_s18_q <= select_2103;
      around_s18_q <= around;
      less_2137_s18_q <= {1'b0, around[4:1]} < n;
      and_2150_s18_q <= and_2150_s17_q;
      sum_2282_s18_q <= {1'b0, sum_2278} + {2'h0, sum_2281_s17_q};
      sum_2285_s18_q <= sum_2285_s17_q;
      equal_2293_s18_q <= equal_2293_s17_q;
      equal_2308_s18_q <= equal_2308_s17_q;
      select_2316_s18_q <= (select_2311 < select_2309) ? select_2309 : select_2311;
      not_2324_s18_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2322);
      not_2327_s18_q <= ~({3'h0, select_2311[13:2]} < sum_2322);
      not_2334_s18_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2332);
      not_2337_s18_q <= ~({3'h0, select_2309[13:2]} < sum_2332);
      select_2372_s18_q <= sample_pair_whole_s17_q ? {detail_2, detail} : 28'h0;
      and_2385_s18_q <= and_2385;
      and_2397_s18_q <= and_2397;
      select_2404_s18_q <= and_2385 ? contrast_s17_q : 9'h0;
      select_2408_s18_q <= and_2397 ? contrast_2_s17_q : 9'h0;
      equal_2411_s18_q <= x_s17_q[7:3] == 5'h0;
      less_2412_s18_q <= 7'h2 < {x_s17_q[4:0], slot_s17_q[2:1]};
      select_2417_s18_q <= select_2417;
      equal_2455_s18_q <= {x_s17_q[4:0], slot_s17_q} == 8'h0;
      equal_2482_s18_q <= equal_2482_s17_q;
      and_2617_s18_q <= and_2617_s17_q;
      not_2645_s18_q <= not_2645_s17_q;
      e_s18_q <= e;
      select_2671_s18_q <= select_2671_s17_q;
      select_2674_s18_q <= select_2674_s17_q;
      and_2724_s18_q <= and_2724_s17_q;
      and_2784_s18_q <= and_2784_s17_q;
      select_2804_s18_q <= equal_577_s17_q ? 8'h0 : (so_s17_q ? select_2802 : 8'h0);
      select_2814_s18_q <= equal_1708_s17_q ? {and_2813, and_2785_s17_q} : 2'h0;
      select_2829_s18_q <= equal_1708_s17_q ? {and_2828, and_2785_s17_q} : 2'h0;
      select_2881_s18_q <= select_2881;
      and_2889_s18_q <= equal_577_s17_q & (x_s17_q[6] & and_2887);
      select_2896_s18_q <= select_2896;
      and_2907_s18_q <= equal_577_s17_q & (x_s17_q[6] & and_2905);
      and_2911_s18_q <= and_2911;
      and_2943_s18_q <= equal_577_s17_q & (x_s17_q[6] & and_2941);
      and_2951_s18_q <= x_s17_q[6] & and_2950;
      other_s18_q <= other[44:36];
      select_3166_s18_q <= and_1964_s17_q ? {and_3165, xor_3164, parity_3158} : 3'h0;
      select_3181_s18_q <= select_3181_s17_q[44:36];
      xor_3196_s18_q <= xor_3196;
      xor_3214_s18_q <= xor_3196 ^ parity_3213;
      xor_3226_s18_q <= xor_3217 ^ (^{select_3181_s17_q[41:36], other[41:36]});
      xor_3238_s18_q <= xor_3229 ^ (^{select_3181_s17_q[23:18], other[23:18]});
      xor_3250_s18_q <= xor_3241 ^ (^{select_3181_s17_q[32:27], other[32:27]});
      or_3259_s18_q <= (xor_3190 & xor_3193) | (xor_3187 & (xor_3190 | xor_3193));
      or_3263_s18_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3267_s18_q <= (xor_3205 & xor_3208) | (xor_3202 & (xor_3205 | xor_3208));
      or_3274_s18_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3278_s18_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3282_s18_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3289_s18_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3293_s18_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3297_s18_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3307_s18_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3311_s18_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3315_s18_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3323_s18_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3327_s18_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3331_s18_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3338_s18_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3342_s18_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3346_s18_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3356_s18_q <= (xor_3220 & xor_3223) | (xor_3217 & (xor_3220 | xor_3223));
      or_3360_s18_q <= (xor_3232 & xor_3235) | (xor_3229 & (xor_3232 | xor_3235));
      or_3364_s18_q <= (xor_3244 & xor_3247) | (xor_3241 & (xor_3244 | xor_3247));
      and_3369_s18_q <= xor_3199 & xor_3211;
      or_3370_s18_q <= xor_3199 | xor_3211;
      equal_3491_s18_q <= equal_3491_s17_q;
      select_3577_s18_q <= select_3577_s17_q;
      select_3578_s18_q <= select_3578_s17_q[2:0];
      select_3579_s18_q <= select_3579_s17_q;
      select_3587_s18_q <= patches_peak_far_q;
      equal_3588_s18_q <= equal_3588_s17_q;
      less_3616_s18_q <= less_3616_s17_q;
      fraction_s18_q <= fraction;
      select_3639_s18_q <= select_3639;
      sum_3640_s18_q <= sum_3640[0];
      sum_3642_s18_q <= sum_3642;
      equal_3684_s18_q <= equal_3684_s17_q;
      equal_3894_s18_q <= select_2671_s17_q[9:3] == 7'h0;
      or_3897_s18_q <= or_3897;
      select_3905_s18_q <= select_3905;
      not_3910_s18_q <= ~({sum_3908, select_2674_s17_q[0]} < {2'h0, select_2671_s17_q});
      equal_3916_s18_q <= equal_3916_s17_q;
      equal_3919_s18_q <= equal_3919_s17_q;
      equal_3921_s18_q <= equal_3921_s17_q;
      equal_3922_s18_q <= equal_3922_s17_q;
      equal_3923_s18_q <= equal_3923_s17_q;
      equal_3924_s18_q <= equal_3924_s17_q;
      or_4066_s18_q <= or_4066_s17_q;
      and_4080_s18_q <= and_4080_s17_q;
      and_4097_s18_q <= and_4097_s17_q;
      not_4109_s18_q <= not_4109_s17_q;
      select_4165_s18_q <= select_4165;
      select_4172_s18_q <= select_4172_s17_q;
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
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic [9:0] patches_peak_size_q;
  logic [47:0] good_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  // hls/stages/agreement.hpp:461
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
  assign texture = sum_731_s18_q + {2'h0, sum_734_s18_q};
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1621_s18_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1674;
  assign select_1674 = equal_1672_s18_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1810;
  assign select_1810 = equal_1698_s18_q ? patches_place_0_valid_q : (select_1697_s18_q ? patches_place_0_valid_q : select_1808_s18_q);
  // hls/stages/patches.hpp:132
  logic equal_1816;
  assign equal_1816 = {sum_1815_s18_q, sum_1811_s18_q[0], select_511_s18_q} == {1'b0, sum_1811_s18_q[8:1], 4'h0};
  // hls/stages/patches.hpp:127
  logic select_1839;
  assign select_1839 = equal_1698_s18_q ? patches_place_1_valid_q : (select_1697_s18_q ? select_1808_s18_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:132
  logic equal_1844;
  assign equal_1844 = {sum_1843_s18_q[8], sum_1811_s18_q, select_511_s18_q} == {1'b0, sum_1843_s18_q[7:0], 4'h0};
  // hls/stages/agreement.hpp:1324
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1276
  logic [10:0] sum_2060;
  assign sum_2060 = {1'b0, {5{select_2059_s18_q}}, 1'b0, {2{select_2059_s18_q}}, 1'b0, select_2059_s18_q} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1126
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2071_s18_q[7]}}, sum_2071_s18_q, x_s18_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1276
  logic [10:0] sum_2074;
  assign sum_2074 = {1'b0, {5{select_2073_s18_q}}, 1'b0, {2{select_2073_s18_q}}, 1'b0, select_2073_s18_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1108
  logic [4:0] t;
  assign t = {difference_2084_s18_q[3], difference_2084_s18_q} + (equal_572_s18_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1115
  logic [47:0] select_2104;
  assign select_2104 = or_2092_s18_q ? {select_2103_s18_q[23], 1'b0, select_2103_s18_q[22], 1'b0, select_2103_s18_q[21], 1'b0, select_2103_s18_q[20], 1'b0, select_2103_s18_q[19], 1'b0, select_2103_s18_q[18], 1'b0, select_2103_s18_q[17], 1'b0, select_2103_s18_q[16], 1'b0, select_2103_s18_q[15], 1'b0, select_2103_s18_q[14], 1'b0, select_2103_s18_q[13], 1'b0, select_2103_s18_q[12], 1'b0, select_2103_s18_q[11], 1'b0, select_2103_s18_q[10], 1'b0, select_2103_s18_q[9], 1'b0, select_2103_s18_q[8], 1'b0, select_2103_s18_q[7], 1'b0, select_2103_s18_q[6], 1'b0, select_2103_s18_q[5], 1'b0, select_2103_s18_q[4], 1'b0, select_2103_s18_q[3], 1'b0, select_2103_s18_q[2], 1'b0, select_2103_s18_q[1], 1'b0, select_2103_s18_q[0], 1'b0} : {1'b0, select_2103_s18_q[23], 1'b0, select_2103_s18_q[22], 1'b0, select_2103_s18_q[21], 1'b0, select_2103_s18_q[20], 1'b0, select_2103_s18_q[19], 1'b0, select_2103_s18_q[18], 1'b0, select_2103_s18_q[17], 1'b0, select_2103_s18_q[16], 1'b0, select_2103_s18_q[15], 1'b0, select_2103_s18_q[14], 1'b0, select_2103_s18_q[13], 1'b0, select_2103_s18_q[12], 1'b0, select_2103_s18_q[11], 1'b0, select_2103_s18_q[10], 1'b0, select_2103_s18_q[9], 1'b0, select_2103_s18_q[8], 1'b0, select_2103_s18_q[7], 1'b0, select_2103_s18_q[6], 1'b0, select_2103_s18_q[5], 1'b0, select_2103_s18_q[4], 1'b0, select_2103_s18_q[3], 1'b0, select_2103_s18_q[2], 1'b0, select_2103_s18_q[1], 1'b0, select_2103_s18_q[0]};
  // hls/stages/agreement.hpp:1117
  logic [5:0] sum_2121;
  assign sum_2121 = {1'b0, around_s18_q} + {2'h0, around_s18_q[4:1]};
  // hls/stages/agreement.hpp:530
  logic select_2266;
  assign select_2266 = and_552_s18_q ? census_columns_values_2_cell_4_mask_s18_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2286;
  assign sum_2286 = sum_2282_s18_q + {2'h0, sum_2285_s18_q};
  // hls/stages/agreement.hpp:530
  logic [11:0] select_2288;
  assign select_2288 = and_552_s18_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2289;
  assign select_2289 = and_552_s18_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2318;
  assign sum_2318 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:530
  logic [13:0] select_2373;
  assign select_2373 = and_552_s18_q ? select_2372_s18_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2374;
  assign select_2374 = and_552_s18_q ? select_2372_s18_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2372_s18_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2372_s18_q[27:14]};
  // hls/stages/census.hpp:375
  logic [23:0] sum_2405;
  assign sum_2405 = (equal_2293_s18_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2404_s18_q};
  logic [23:0] sum_2409;
  assign sum_2409 = (equal_2293_s18_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2408_s18_q};
  // hls/stages/census.hpp:427
  logic less_2413;
  assign less_2413 = x_s18_q[4:0] < 5'h3;
  logic [23:0] select_2418;
  assign select_2418 = slot_s18_q ? {select_2417_s18_q[11], 1'b0, select_2417_s18_q[10], 1'b0, select_2417_s18_q[9], 1'b0, select_2417_s18_q[8], 1'b0, select_2417_s18_q[7], 1'b0, select_2417_s18_q[6], 1'b0, select_2417_s18_q[5], 1'b0, select_2417_s18_q[4], 1'b0, select_2417_s18_q[3], 1'b0, select_2417_s18_q[2], 1'b0, select_2417_s18_q[1], 1'b0, select_2417_s18_q[0], 1'b0} : {1'b0, select_2417_s18_q[11], 1'b0, select_2417_s18_q[10], 1'b0, select_2417_s18_q[9], 1'b0, select_2417_s18_q[8], 1'b0, select_2417_s18_q[7], 1'b0, select_2417_s18_q[6], 1'b0, select_2417_s18_q[5], 1'b0, select_2417_s18_q[4], 1'b0, select_2417_s18_q[3], 1'b0, select_2417_s18_q[2], 1'b0, select_2417_s18_q[1], 1'b0, select_2417_s18_q[0]};
  // hls/stages/census.hpp:390
  logic and_2422;
  assign and_2422 = less_2413 & (~((sharpness_sums_contrast_1_q & select_2418) == 24'h0));
  logic and_2432;
  assign and_2432 = less_2413 & (~((sharpness_sums_contrast_0_q & select_2418) == 24'h0));
  // hls/stages/agreement.hpp:1116
  logic [5:0] sum_2658;
  assign sum_2658 = {1'b0, e_s18_q} + {2'h0, e_s18_q[4:1]};
  // hls/stages/agreement.hpp:1148
  logic [10:0] sum_2675;
  assign sum_2675 = {1'b0, select_2674_s18_q} + {3'h0, select_2674_s18_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2805;
  assign sum_2805 = registration_half_across_q + {{6{select_2804_s18_q[7]}}, select_2804_s18_q};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2816;
  assign select_2816 = equal_577_s18_q ? 2'h0 : (so_s18_q ? select_2814_s18_q : 2'h0);
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2817;
  assign sum_2817 = registration_half_votes_down_q + {{5{select_2816[1]}}, select_2816};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2831;
  assign select_2831 = equal_577_s18_q ? 2'h0 : (so_s18_q ? select_2829_s18_q : 2'h0);
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2832;
  assign sum_2832 = registration_half_half_votes_down_q + {{5{select_2831[1]}}, select_2831};
  // hls/stages/agreement.hpp:798
  logic and_2872;
  assign and_2872 = equal_577_s18_q & (x_s18_q[6] & (not_1995_s18_q & less_1646_s18_q));
  logic [11:0] select_2883;
  assign select_2883 = equal_577_s18_q ? (x_s18_q[6] ? select_2881_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2891;
  assign sum_2891 = {{2{select_2883[11]}}, select_2883} + (and_2889_s18_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:798
  logic [11:0] select_2898;
  assign select_2898 = equal_577_s18_q ? (x_s18_q[6] ? select_2896_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2900;
  assign sum_2900 = {{2{select_2898[11]}}, select_2898} + (and_2889_s18_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2912;
  assign not_2912 = ~and_2911_s18_q;
  logic less_2913;
  assign less_2913 = $signed({9'h1, {2{not_2912}}, and_2911_s18_q}) < $signed(registration_up_q[13:2]);
  logic select_2914;
  assign select_2914 = and_2907_s18_q ? less_2913 : registration_enough_q;
  // hls/stages/agreement.hpp:1157
  logic and_2918;
  assign and_2918 = x_s18_q[6] & (not_1995_s18_q & (less_1646_s18_q & (x_s18_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:798
  logic and_2919;
  assign and_2919 = equal_577_s18_q & and_2918;
  // hls/stages/registration.hpp:242
  logic less_2920;
  assign less_2920 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2922;
  assign less_2922 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2924;
  assign equal_2924 = x_s18_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:798
  logic and_2928;
  assign and_2928 = equal_577_s18_q & (x_s18_q[6] & (not_1995_s18_q & (less_1646_s18_q & equal_2924)));
  // hls/stages/agreement.hpp:1157
  logic and_2935;
  assign and_2935 = x_s18_q[6] & (not_1995_s18_q & (less_1646_s18_q & (x_s18_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2953;
  assign and_2953 = registration_votes_up_q & registration_other_down_q;
  logic select_2955;
  assign select_2955 = registration_votes_down_q ? (registration_other_up_q | and_2953) : and_2953;
  // hls/stages/registration.hpp:138
  logic and_2957;
  assign and_2957 = (equal_577_s18_q & and_2951_s18_q) & (registration_other_enough_q & select_2955);
  logic and_2959;
  assign and_2959 = registration_enough_q & ((and_2943_s18_q & (less_2922 | less_2920)) | and_2957);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3168;
  assign select_3168 = equal_1794_s18_q ? 3'h0 : (or_1798_s18_q ? select_3166_s18_q : 3'h0);
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3171;
  assign sum_3171 = {7'h0, patches_set_q} + (equal_1797_s18_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3251;
  assign xor_3251 = xor_3238_s18_q ^ xor_3250_s18_q;
  // hls/stages/count_bits.hpp:25
  logic or_3376;
  assign or_3376 = (xor_3238_s18_q & xor_3250_s18_q) | (xor_3226_s18_q & (xor_3238_s18_q | xor_3250_s18_q));
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3590;
  assign select_3590 = equal_1792_s18_q ? (equal_3588_s18_q ? sum_3171 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3617;
  assign sum_3617 = select_3579_s18_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:587
  logic [7:0] difference_3637;
  assign difference_3637 = {sum_3617, select_3579_s18_q[2:0], 3'h0} - {5'h0, fraction_s18_q};
  logic [7:0] select_3638;
  assign select_3638 = less_3616_s18_q ? difference_3637 : {sum_3617, select_3579_s18_q[2:0], fraction_s18_q};
  // hls/stages/patches.hpp:604
  logic [18:0] product_3643;
  assign product_3643 = $signed({{11{select_3639_s18_q[7]}}, select_3639_s18_q}) * $signed({{8{sum_3642_s18_q[6]}}, sum_3642_s18_q, sum_3640_s18_q, select_3578_s18_q});
  // hls/stages/patches.hpp:612
  logic [11:0] sum_3803;
  assign sum_3803 = {sum_3642_s18_q[6], sum_3642_s18_q, sum_3640_s18_q, select_3578_s18_q} + 12'h1;
  // hls/stages/agreement.hpp:1150
  logic select_3911;
  assign select_3911 = equal_3894_s18_q ? ((~or_3897_s18_q) & (~select_3905_s18_q)) : not_3910_s18_q;
  // hls/stages/agreement.hpp:1157
  logic [47:0] select_3913;
  assign select_3913 = x_s18_q[6] ? (equal_1615_s18_q ? good_q : {select_3911, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:798
  logic [4:0] select_3995;
  assign select_3995 = so_s18_q ? (ends_cell_s18_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:465
  logic [12:0] select_4069;
  assign select_4069 = equal_2482_s18_q ? (or_4066_s18_q ? (map_row_q + {6'h0, map_width_q}) : 13'h0) : map_row_q;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_4072;
  assign select_4072 = and_552_s18_q ? (equal_2482_s18_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      patches_peak_size_q <= 10'h0;
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
    end else if (s18_en) begin
      moments_most_before_q <= equal_577_s18_q ? select_2316_s18_q : moments_most_before_q;
      moments_left_alone_q <= equal_577_s18_q ? not_2324_s18_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_577_s18_q ? not_2327_s18_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_577_s18_q ? not_2334_s18_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_577_s18_q ? not_2337_s18_q : moments_right_other_stops_q;
      sharpness_sums_contrast_0_q <= and_552_s18_q ? sum_2405 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_552_s18_q ? sum_2409 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2784_s18_q ? 14'h0 : sum_2805;
      registration_half_votes_down_q <= and_2784_s18_q ? 7'h0 : sum_2817;
      registration_half_half_votes_down_q <= and_2784_s18_q ? 7'h0 : sum_2832;
      registration_down_q <= and_2872 ? sum_2891 : registration_down_q;
      registration_up_q <= and_2872 ? sum_2900 : registration_up_q;
      registration_enough_q <= select_2914;
      registration_votes_down_q <= and_2919 ? less_2920 : registration_votes_down_q;
      registration_votes_up_q <= and_2919 ? less_2922 : registration_votes_up_q;
      registration_other_enough_q <= and_2928 ? select_2914 : registration_other_enough_q;
      registration_other_down_q <= and_2928 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2928 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s18_q ? select_1810 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s18_q ? select_1839 : patches_place_1_valid_q;
      patches_set_q <= equal_1792_s18_q ? 3'h0 : select_3168;
      patches_size_q <= sum_3171;
      patches_peak_size_q <= select_3590;
      good_q <= equal_577_s18_q ? select_3913 : good_q;
      map_row_q <= and_552_s18_q ? select_4069 : map_row_q;
      map_width_q <= select_4072;
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
      census_columns_values_3_cell_4_mask_q <= select_2266;
      census_changes_values_0_left_q <= and_552_s18_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_552_s18_q ? sum_2286 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2288;
      census_changes_values_1_right_q <= select_2289;
      sharpness_last_detail_0_q <= select_2373;
      sharpness_last_detail_1_q <= select_2374;
      box_textured_sum_sums_values_0_q <= equal_577_s18_q ? box_textured_sum_sums_values_0_q : select_3995;
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
  logic row_starts_s19_q;
  logic [6:0] last_s19_q;
  logic and_552_s19_q;
  logic equal_577_s19_q;
  logic not_578_s19_q;
  logic so_s19_q;
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
  logic less_675_s19_q;
  logic less_676_s19_q;
  logic less_677_s19_q;
  logic less_678_s19_q;
  logic less_679_s19_q;
  logic less_680_s19_q;
  logic less_681_s19_q;
  logic less_682_s19_q;
  logic and_690_s19_q;
  logic and_715_s19_q;
  logic and_716_s19_q;
  logic [12:0] sum_736_s19_q;
  logic and_742_s19_q;
  logic and_746_s19_q;
  logic less_747_s19_q;
  logic less_751_s19_q;
  logic less_753_s19_q;
  logic equal_1615_s19_q;
  logic [1:0] sum_1621_s19_q;
  logic equal_1623_s19_q;
  logic equal_1625_s19_q;
  logic equal_1627_s19_q;
  logic equal_1629_s19_q;
  logic equal_1631_s19_q;
  logic equal_1633_s19_q;
  logic [19:0] sum_1675_s19_q;
  logic [11:0] sum_1679_s19_q;
  logic and_1680_s19_q;
  logic select_1697_s19_q;
  logic equal_1698_s19_q;
  logic equal_1792_s19_q;
  logic equal_1794_s19_q;
  logic not_1799_s19_q;
  logic select_1808_s19_q;
  logic or_1818_s19_q;
  logic [4:0] select_1822_s19_q;
  logic select_1828_s19_q;
  logic or_1846_s19_q;
  logic or_1859_s19_q;
  logic or_1863_s19_q;
  logic [3:0] select_1866_s19_q;
  logic not_1995_s19_q;
  logic [2:0] index_s19_q;
  logic [10:0] sum_2060_s19_q;
  logic and_2067_s19_q;
  logic less_2068_s19_q;
  logic [2:0] index_2_s19_q;
  logic [10:0] sum_2074_s19_q;
  logic equal_2087_s19_q;
  logic not_2107_s19_q;
  logic not_2123_s19_q;
  logic less_2137_s19_q;
  logic and_2150_s19_q;
  logic equal_2293_s19_q;
  logic [12:0] sum_2294_s19_q;
  logic equal_2308_s19_q;
  logic not_2320_s19_q;
  logic not_2330_s19_q;
  logic [12:0] select_2387_s19_q;
  logic [12:0] select_2399_s19_q;
  logic equal_2411_s19_q;
  logic less_2412_s19_q;
  logic and_2422_s19_q;
  logic and_2432_s19_q;
  logic equal_2455_s19_q;
  logic and_2617_s19_q;
  logic not_2645_s19_q;
  logic not_2660_s19_q;
  logic [9:0] select_2671_s19_q;
  logic [9:0] select_2674_s19_q;
  logic less_2676_s19_q;
  logic and_2724_s19_q;
  logic equal_2924_s19_q;
  logic not_2937_s19_q;
  logic and_2959_s19_q;
  logic parity_3255_s19_q;
  logic or_3259_s19_q;
  logic or_3263_s19_q;
  logic or_3267_s19_q;
  logic or_3274_s19_q;
  logic or_3278_s19_q;
  logic or_3282_s19_q;
  logic or_3289_s19_q;
  logic or_3293_s19_q;
  logic or_3297_s19_q;
  logic or_3307_s19_q;
  logic or_3311_s19_q;
  logic or_3315_s19_q;
  logic or_3323_s19_q;
  logic or_3327_s19_q;
  logic or_3331_s19_q;
  logic or_3338_s19_q;
  logic or_3342_s19_q;
  logic or_3346_s19_q;
  logic or_3356_s19_q;
  logic or_3360_s19_q;
  logic or_3364_s19_q;
  logic and_3368_s19_q;
  logic or_3372_s19_q;
  logic or_3376_s19_q;
  logic equal_3491_s19_q;
  logic [9:0] select_3577_s19_q;
  logic and_3591_s19_q;
  logic not_3593_s19_q;
  logic not_3596_s19_q;
  logic [9:0] difference_3597_s19_q;
  logic [7:0] select_3638_s19_q;
  logic [13:0] product_3643_s19_q;
  logic equal_3684_s19_q;
  logic less_3804_s19_q;
  logic or_3897_s19_q;
  logic select_3905_s19_q;
  logic equal_3916_s19_q;
  logic equal_3919_s19_q;
  logic equal_3921_s19_q;
  logic equal_3922_s19_q;
  logic equal_3923_s19_q;
  logic equal_3924_s19_q;
  logic and_4080_s19_q;
  logic and_4097_s19_q;
  logic not_4109_s19_q;
  logic [31:0] select_4165_s19_q;
  logic [9:0] select_4172_s19_q;
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
      row_starts_s19_q <= row_starts_s18_q;
      last_s19_q <= last_s18_q;
      and_552_s19_q <= and_552_s18_q;
      equal_577_s19_q <= equal_577_s18_q;
      not_578_s19_q <= not_578_s18_q;
      so_s19_q <= so_s18_q;
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
      less_675_s19_q <= less_675_s18_q;
      less_676_s19_q <= less_676_s18_q;
      less_677_s19_q <= less_677_s18_q;
      less_678_s19_q <= less_678_s18_q;
      less_679_s19_q <= less_679_s18_q;
      less_680_s19_q <= less_680_s18_q;
      less_681_s19_q <= less_681_s18_q;
      less_682_s19_q <= less_682_s18_q;
      and_690_s19_q <= and_690_s18_q;
      and_715_s19_q <= whole_22 & and_690_s18_q;
      and_716_s19_q <= and_716_s18_q;
      sum_736_s19_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_742_s19_q <= and_742_s18_q;
      and_746_s19_q <= and_746_s18_q;
      less_747_s19_q <= less_747_s18_q;
      less_751_s19_q <= less_751_s18_q;
      less_753_s19_q <= less_753_s18_q;
      equal_1615_s19_q <= equal_1615_s18_q;
      sum_1621_s19_q <= sum_1621_s18_q;
      equal_1623_s19_q <= equal_1623_s18_q;
      equal_1625_s19_q <= equal_1625_s18_q;
      equal_1627_s19_q <= equal_1627_s18_q;
      equal_1629_s19_q <= equal_1629_s18_q;
      equal_1631_s19_q <= equal_1631_s18_q;
      equal_1633_s19_q <= equal_1633_s18_q;
      sum_1675_s19_q <= select_1671_s18_q + {{6{select_1674[13]}}, select_1674};
      sum_1679_s19_q <= sum_1679_s18_q;
      and_1680_s19_q <= and_1680_s18_q;
      select_1697_s19_q <= select_1697_s18_q;
      equal_1698_s19_q <= equal_1698_s18_q;
      equal_1792_s19_q <= equal_1792_s18_q;
      equal_1794_s19_q <= equal_1794_s18_q;
      not_1799_s19_q <= not_1799_s18_q;
      select_1808_s19_q <= select_1808_s18_q;
      or_1818_s19_q <= row_starts_s18_q | (select_1810 & equal_1816);
      select_1822_s19_q <= select_1822_s18_q;
      select_1828_s19_q <= select_1828_s18_q;
      or_1846_s19_q <= row_starts_s18_q | (select_1839 & equal_1844);
      or_1859_s19_q <= row_starts_s18_q | (select_1810 & equal_1857_s18_q);
      or_1863_s19_q <= row_starts_s18_q | (select_1839 & equal_1861_s18_q);
      select_1866_s19_q <= select_1866_s18_q;
      not_1995_s19_q <= not_1995_s18_q;
      index_s19_q <= index[2:0];
      sum_2060_s19_q <= sum_2060;
      and_2067_s19_q <= began_q & (seen_x_q == 4'h0);
      less_2068_s19_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s19_q <= index_2[2:0];
      sum_2074_s19_q <= sum_2074;
      equal_2087_s19_q <= t[4:1] == 4'h0;
      not_2107_s19_q <= ~((good_q & select_2104) == 48'h0);
      not_2123_s19_q <= ~({sum_2121, around_s18_q[0]} < {2'h0, t});
      less_2137_s19_q <= less_2137_s18_q;
      and_2150_s19_q <= and_2150_s18_q;
      equal_2293_s19_q <= equal_2293_s18_q;
      sum_2294_s19_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2286};
      equal_2308_s19_q <= equal_2308_s18_q;
      not_2320_s19_q <= ~({3'h0, counts_turned_left_s18_q} < sum_2318);
      not_2330_s19_q <= ~({3'h0, counts_turned_right_s18_q} < sum_2318);
      select_2387_s19_q <= and_2385_s18_q ? detail_3[14:2] : 13'h0;
      select_2399_s19_q <= and_2397_s18_q ? detail_4[14:2] : 13'h0;
      equal_2411_s19_q <= equal_2411_s18_q;
      less_2412_s19_q <= less_2412_s18_q;
      and_2422_s19_q <= and_2422;
      and_2432_s19_q <= and_2432;
      equal_2455_s19_q <= equal_2455_s18_q;
      and_2617_s19_q <= and_2617_s18_q;
      not_2645_s19_q <= not_2645_s18_q;
      not_2660_s19_q <= ~({sum_2658, e_s18_q[0]} < {2'h0, t});
      select_2671_s19_q <= select_2671_s18_q;
      select_2674_s19_q <= select_2674_s18_q;
      less_2676_s19_q <= {sum_2675, select_2674_s18_q[1:0]} < {3'h0, select_2671_s18_q};
      and_2724_s19_q <= and_2724_s18_q;
      equal_2924_s19_q <= equal_2924;
      not_2937_s19_q <= ~(equal_577_s18_q & and_2935);
      and_2959_s19_q <= and_2959;
      parity_3255_s19_q <= ^{xor_3251, xor_3214_s18_q, select_3181_s18_q, other_s18_q};
      or_3259_s19_q <= or_3259_s18_q;
      or_3263_s19_q <= or_3263_s18_q;
      or_3267_s19_q <= or_3267_s18_q;
      or_3274_s19_q <= or_3274_s18_q;
      or_3278_s19_q <= or_3278_s18_q;
      or_3282_s19_q <= or_3282_s18_q;
      or_3289_s19_q <= or_3289_s18_q;
      or_3293_s19_q <= or_3293_s18_q;
      or_3297_s19_q <= or_3297_s18_q;
      or_3307_s19_q <= or_3307_s18_q;
      or_3311_s19_q <= or_3311_s18_q;
      or_3315_s19_q <= or_3315_s18_q;
      or_3323_s19_q <= or_3323_s18_q;
      or_3327_s19_q <= or_3327_s18_q;
      or_3331_s19_q <= or_3331_s18_q;
      or_3338_s19_q <= or_3338_s18_q;
      or_3342_s19_q <= or_3342_s18_q;
      or_3346_s19_q <= or_3346_s18_q;
      or_3356_s19_q <= or_3356_s18_q;
      or_3360_s19_q <= or_3360_s18_q;
      or_3364_s19_q <= or_3364_s18_q;
      and_3368_s19_q <= xor_3214_s18_q & (^{xor_3251, select_3181_s18_q, other_s18_q});
      or_3372_s19_q <= and_3369_s18_q | (xor_3196_s18_q & or_3370_s18_q);
      or_3376_s19_q <= or_3376;
      equal_3491_s19_q <= equal_3491_s18_q;
      select_3577_s19_q <= select_3577_s18_q;
      and_3591_s19_q <= equal_1792_s18_q & equal_3588_s18_q;
      not_3593_s19_q <= ~(select_3579_s18_q[3:0] == 4'h0);
      not_3596_s19_q <= ~(select_3587_s18_q < select_3577_s18_q);
      difference_3597_s19_q <= select_3587_s18_q - select_3577_s18_q;
      select_3638_s19_q <= select_3638;
      product_3643_s19_q <= product_3643[18:5];
      equal_3684_s19_q <= equal_3684_s18_q;
      less_3804_s19_q <= {{4{sum_3803[11]}}, sum_3803} < 16'h3;
      or_3897_s19_q <= or_3897_s18_q;
      select_3905_s19_q <= select_3905_s18_q;
      equal_3916_s19_q <= equal_3916_s18_q;
      equal_3919_s19_q <= equal_3919_s18_q;
      equal_3921_s19_q <= equal_3921_s18_q;
      equal_3922_s19_q <= equal_3922_s18_q;
      equal_3923_s19_q <= equal_3923_s18_q;
      equal_3924_s19_q <= equal_3924_s18_q;
      and_4080_s19_q <= and_4080_s18_q;
      and_4097_s19_q <= and_4097_s18_q;
      not_4109_s19_q <= not_4109_s18_q;
      select_4165_s19_q <= select_4165_s18_q;
      select_4172_s19_q <= select_4172_s18_q;
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
  logic [13:0] sum_737;
  assign sum_737 = {2'h0, census_changes_values_1_left_s19_q} + {1'b0, sum_736_s19_q};
  logic [13:0] sum_738;
  assign sum_738 = {2'h0, census_changes_values_2_left_q} + sum_737;
  // hls/stages/patches.hpp:134
  logic [5:0] select_1829;
  assign select_1829 = or_1818_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1831;
  assign and_1831 = select_1828_s19_q & (~select_1829[5]);
  // hls/stages/patches.hpp:134
  logic [5:0] select_1848;
  assign select_1848 = or_1846_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1850;
  assign and_1850 = select_1828_s19_q & (~select_1848[5]);
  // hls/stages/patches.hpp:135
  logic [4:0] select_1860;
  assign select_1860 = or_1859_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1864;
  assign select_1864 = or_1863_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1860[4] ? select_1864[3:0] : select_1860[3:0];
  logic and_1869;
  assign and_1869 = select_1828_s19_q & (select_1822_s19_q[3] ^ select_1822_s19_q[4]);
  logic and_1874;
  assign and_1874 = sample_pair_whole_s19_q & (and_1869 & ((~select_1860[4]) | (~select_1864[4])));
  // hls/stages/agreement.hpp:1043
  logic and_2108;
  assign and_2108 = good_known_q & not_2107_s19_q;
  // hls/stages/agreement.hpp:1117
  logic is_seen;
  assign is_seen = equal_2087_s19_q ? and_2108 : not_2123_s19_q;
  // hls/stages/agreement.hpp:530
  logic [11:0] select_2290;
  assign select_2290 = and_552_s19_q ? census_changes_values_1_left_s19_q : census_changes_values_2_left_q;
  logic [11:0] select_2291;
  assign select_2291 = and_552_s19_q ? census_changes_values_1_right_s19_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [13:0] sum_2295;
  assign sum_2295 = {2'h0, census_changes_values_1_right_s19_q} + {1'b0, sum_2294_s19_q};
  logic [13:0] sum_2296;
  assign sum_2296 = {2'h0, census_changes_values_2_right_q} + sum_2295;
  // hls/stages/moments.hpp:106
  logic and_2355;
  assign and_2355 = moments_right_alone_s19_q & (moments_right_begins_q | moments_right_other_stops_s19_q);
  logic or_2357;
  assign or_2357 = moments_left_begins_q | (moments_left_other_stops_s19_q | and_2355);
  logic and_2359;
  assign and_2359 = cfg_same_table_i & (moments_left_alone_s19_q ? or_2357 : and_2355);
  // hls/stages/moments.hpp:107
  logic and_2365;
  assign and_2365 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:375
  logic [23:0] select_2389;
  assign select_2389 = equal_2293_s19_q ? {11'h0, select_2387_s19_q} : (sharpness_sums_detail_0_q + {11'h0, select_2387_s19_q});
  logic [23:0] select_2401;
  assign select_2401 = equal_2293_s19_q ? {11'h0, select_2399_s19_q} : (sharpness_sums_detail_1_q + {11'h0, select_2399_s19_q});
  // hls/stages/census.hpp:395
  logic [17:0] select_2424;
  assign select_2424 = (less_2412_s19_q & and_2422_s19_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2434;
  assign select_2434 = (less_2412_s19_q & and_2432_s19_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:217
  logic [1:0] select_2443;
  assign select_2443 = equal_2411_s19_q ? {sharpness_comparing_contrast_0_q[0], and_2432_s19_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2445;
  assign select_2445 = equal_2411_s19_q ? {sharpness_comparing_contrast_1_q[0], and_2422_s19_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:404
  logic xor_2468;
  assign xor_2468 = sharpness_comparing_contrast_0_q[1] ^ and_2422_s19_q;
  logic select_2471;
  assign select_2471 = (equal_2455_s19_q | xor_2468) ? (and_2422_s19_q & xor_2468) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2472;
  assign select_2472 = equal_2411_s19_q ? select_2471 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2474;
  assign xor_2474 = sharpness_comparing_contrast_1_q[1] ^ and_2432_s19_q;
  logic select_2477;
  assign select_2477 = (equal_2455_s19_q | xor_2474) ? (and_2432_s19_q & xor_2474) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2478;
  assign select_2478 = equal_2411_s19_q ? select_2477 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1121
  logic not_2662;
  assign not_2662 = ~(equal_2087_s19_q ? and_2108 : not_2660_s19_q);
  // hls/stages/agreement.hpp:798
  logic and_2665;
  assign and_2665 = ends_cell_s19_q & (not_2645_s19_q & (centres_values_1_textured_s19_q & not_2662));
  // hls/stages/agreement.hpp:1153
  logic [9:0] select_2678;
  assign select_2678 = ((~(select_2671_s19_q[9:4] == 6'h0)) & less_2676_s19_q) ? select_2671_s19_q : 10'h0;
  // hls/stages/agreement.hpp:798
  logic [9:0] select_2681;
  assign select_2681 = equal_577_s19_q ? (x_s19_q[6] ? (equal_1615_s19_q ? 10'h0 : select_2678) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1125
  logic and_2700;
  assign and_2700 = centres_values_1_textured_s19_q & (centres_values_1_of_skin_s19_q & not_2662);
  // hls/stages/patches.hpp:127
  logic select_3051;
  assign select_3051 = equal_1698_s19_q ? patches_valid_0_q : (select_1697_s19_q ? patches_valid_0_q : select_1808_s19_q);
  // hls/stages/agreement.hpp:277
  logic select_3054;
  assign select_3054 = sample_pair_whole_s19_q ? (and_1831 ? (sample_present_s19_q & select_3051) : select_3051) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3056;
  assign select_3056 = equal_1698_s19_q ? patches_valid_1_q : (select_1697_s19_q ? select_1808_s19_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3059;
  assign select_3059 = sample_pair_whole_s19_q ? (and_1850 ? (sample_present_s19_q & select_3056) : select_3056) : patches_valid_1_q;
  logic [5:0] select_3062;
  assign select_3062 = sample_pair_whole_s19_q ? (select_1829[5] ? {1'b1, select_1829[4:0]} : (select_1829 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3065;
  assign select_3065 = sample_pair_whole_s19_q ? (select_1848[5] ? {1'b1, select_1848[4:0]} : (select_1848 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3068;
  assign select_3068 = sample_pair_whole_s19_q ? (select_1860[4] ? {1'b1, select_1860[3:0]} : (select_1860 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3071;
  assign select_3071 = sample_pair_whole_s19_q ? (select_1864[4] ? {1'b1, select_1864[3:0]} : (select_1864 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3285;
  assign parity_3285 = ^{or_3282_s19_q, or_3278_s19_q, or_3274_s19_q};
  logic parity_3300;
  assign parity_3300 = ^{or_3297_s19_q, or_3293_s19_q, or_3289_s19_q};
  logic parity_3303;
  assign parity_3303 = ^{or_3297_s19_q, or_3293_s19_q, or_3289_s19_q, or_3282_s19_q, or_3278_s19_q, or_3274_s19_q, or_3267_s19_q, or_3263_s19_q, or_3259_s19_q};
  logic parity_3334;
  assign parity_3334 = ^{or_3331_s19_q, or_3327_s19_q, or_3323_s19_q};
  logic parity_3349;
  assign parity_3349 = ^{or_3346_s19_q, or_3342_s19_q, or_3338_s19_q};
  logic parity_3352;
  assign parity_3352 = ^{or_3346_s19_q, or_3342_s19_q, or_3338_s19_q, or_3331_s19_q, or_3327_s19_q, or_3323_s19_q, or_3315_s19_q, or_3311_s19_q, or_3307_s19_q};
  logic parity_3367;
  assign parity_3367 = ^{or_3364_s19_q, or_3360_s19_q, or_3356_s19_q};
  logic parity_3379;
  assign parity_3379 = ^{or_3376_s19_q, or_3372_s19_q, and_3368_s19_q};
  logic parity_3382;
  assign parity_3382 = ^{or_3376_s19_q, or_3372_s19_q, and_3368_s19_q, or_3364_s19_q, or_3360_s19_q, or_3356_s19_q, or_3346_s19_q, or_3342_s19_q, or_3338_s19_q, or_3331_s19_q, or_3327_s19_q, or_3323_s19_q, or_3315_s19_q, or_3311_s19_q, or_3307_s19_q};
  logic parity_3384;
  assign parity_3384 = ^{or_3376_s19_q, or_3372_s19_q, and_3368_s19_q, or_3364_s19_q, or_3360_s19_q, or_3356_s19_q, or_3346_s19_q, or_3342_s19_q, or_3338_s19_q, or_3331_s19_q, or_3327_s19_q, or_3323_s19_q, or_3315_s19_q, or_3311_s19_q, or_3307_s19_q, or_3297_s19_q, or_3293_s19_q, or_3289_s19_q, or_3282_s19_q, or_3278_s19_q, or_3274_s19_q, or_3267_s19_q, or_3263_s19_q, or_3259_s19_q};
  // hls/stages/count_bits.hpp:25
  logic and_3385;
  assign and_3385 = parity_3303 & parity_3382;
  logic and_3388;
  assign and_3388 = (^{or_3267_s19_q, or_3263_s19_q, or_3259_s19_q}) & (parity_3285 | parity_3300);
  logic or_3389;
  assign or_3389 = (parity_3285 & parity_3300) | and_3388;
  logic or_3393;
  assign or_3393 = (parity_3367 & parity_3379) | (parity_3352 & (parity_3367 | parity_3379));
  logic and_3399;
  assign and_3399 = (^{or_3315_s19_q, or_3311_s19_q, or_3307_s19_q}) & (parity_3334 | parity_3349);
  logic or_3400;
  assign or_3400 = (parity_3334 & parity_3349) | and_3399;
  logic or_3404;
  assign or_3404 = (or_3360_s19_q & or_3364_s19_q) | (or_3356_s19_q & (or_3360_s19_q | or_3364_s19_q));
  logic or_3408;
  assign or_3408 = (or_3372_s19_q & or_3376_s19_q) | (and_3368_s19_q & (or_3372_s19_q | or_3376_s19_q));
  // hls/stages/count_bits.hpp:23
  logic or_3415;
  assign or_3415 = (or_3311_s19_q & or_3315_s19_q) | (or_3307_s19_q & (or_3311_s19_q | or_3315_s19_q));
  // hls/stages/count_bits.hpp:25
  logic or_3419;
  assign or_3419 = (or_3327_s19_q & or_3331_s19_q) | (or_3323_s19_q & (or_3327_s19_q | or_3331_s19_q));
  logic or_3423;
  assign or_3423 = (or_3342_s19_q & or_3346_s19_q) | (or_3338_s19_q & (or_3342_s19_q | or_3346_s19_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3426;
  assign parity_3426 = ^{or_3423, or_3419, or_3415};
  // hls/stages/count_bits.hpp:23
  logic or_3430;
  assign or_3430 = (or_3263_s19_q & or_3267_s19_q) | (or_3259_s19_q & (or_3263_s19_q | or_3267_s19_q));
  // hls/stages/count_bits.hpp:25
  logic or_3434;
  assign or_3434 = (or_3278_s19_q & or_3282_s19_q) | (or_3274_s19_q & (or_3278_s19_q | or_3282_s19_q));
  logic or_3438;
  assign or_3438 = (or_3293_s19_q & or_3297_s19_q) | (or_3289_s19_q & (or_3293_s19_q | or_3297_s19_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3441;
  assign parity_3441 = ^{or_3438, or_3434, or_3430};
  logic parity_3444;
  assign parity_3444 = ^{or_3438, or_3434, or_3430, or_3423, or_3419, or_3415, or_3408, or_3404, or_3400};
  // hls/stages/patches.hpp:601
  logic and_3600;
  assign and_3600 = not_3596_s19_q & (~({difference_3597_s19_q, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:608
  logic and_3604;
  assign and_3604 = (10'h38 < patches_peak_size_q) & (~({1'b0, patches_peak_size_q[9:1]} < select_3577_s19_q));
  logic and_3606;
  assign and_3606 = (patches_second_s19_q ? patches_valid_1_q : patches_valid_0_q) & (and_3600 & and_3604);
  // hls/stages/patches.hpp:605
  logic [14:0] difference_3644;
  assign difference_3644 = {{7{select_3638_s19_q[7]}}, select_3638_s19_q} - {product_3643_s19_q[13], product_3643_s19_q};
  // hls/stages/agreement.hpp:798
  logic select_3918;
  assign select_3918 = equal_577_s19_q ? ((x_s19_q[6] & good_known_q) | equal_3916_s19_q) : good_known_q;
  // hls/stages/agreement.hpp:1324
  logic and_4095;
  assign and_4095 = and_2150_s19_q & ({sum_2074_s19_q, index_2_s19_q} == {sum_2060_s19_q, index_s19_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1426; read in stage 19, written in stage 20: 19 < 20 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2060_s19_q, index_s19_q};
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s19_en & (and_2067_s19_q & less_2068_s19_q);
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1621_s19_q, lower_half_s19_q, registration_of_right_s19_q};
  logic registration_sums_we;
  assign registration_sums_we = s19_en & and_1680_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1679_s19_q, sum_1675_s19_q};
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
      moments_left_begins_q <= equal_577_s19_q ? not_2320_s19_q : moments_left_begins_q;
      moments_right_begins_q <= equal_577_s19_q ? not_2330_s19_q : moments_right_begins_q;
      moments_ends_q <= equal_577_s19_q & (equal_2308_s19_q & (not_2363 | and_2365));
      sharpness_sums_detail_0_q <= and_552_s19_q ? select_2389 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_552_s19_q ? select_2401 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s19_q ? select_2443 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s19_q ? select_2445 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s19_q ? select_2472 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s19_q ? select_2478 : sharpness_comparing_less_contrast_1_q;
      registration_moved_q <= not_2937_s19_q & (registration_moved_q | and_2959_s19_q);
      patches_valid_0_q <= select_3054;
      patches_valid_1_q <= select_3059;
      patches_right_next_0_q <= select_3062;
      patches_right_next_1_q <= select_3065;
      patches_left_next_0_q <= select_3068;
      patches_left_next_1_q <= select_3071;
      good_known_q <= select_3918;
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
      census_changes_values_2_left_q <= select_2290;
      census_changes_values_2_right_q <= select_2291;
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
  logic [6:0] last_s20_q;
  logic and_552_s20_q;
  logic equal_577_s20_q;
  logic not_578_s20_q;
  logic so_s20_q;
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
  logic less_675_s20_q;
  logic less_676_s20_q;
  logic less_677_s20_q;
  logic less_678_s20_q;
  logic less_679_s20_q;
  logic less_680_s20_q;
  logic less_681_s20_q;
  logic less_682_s20_q;
  logic and_690_s20_q;
  logic and_715_s20_q;
  logic and_716_s20_q;
  logic [8:0] sum_738_s20_q;
  logic and_746_s20_q;
  logic less_747_s20_q;
  logic and_752_s20_q;
  logic less_753_s20_q;
  logic equal_1615_s20_q;
  logic equal_1623_s20_q;
  logic equal_1625_s20_q;
  logic equal_1627_s20_q;
  logic equal_1629_s20_q;
  logic equal_1631_s20_q;
  logic equal_1633_s20_q;
  logic equal_1792_s20_q;
  logic equal_1794_s20_q;
  logic not_1799_s20_q;
  logic [4:0] select_1819_s20_q;
  logic [4:0] select_1822_s20_q;
  logic and_1832_s20_q;
  logic [4:0] select_1847_s20_q;
  logic and_1851_s20_q;
  logic [3:0] column_4_s20_q;
  logic [3:0] select_1866_s20_q;
  logic select_1867_s20_q;
  logic and_1874_s20_q;
  logic not_1995_s20_q;
  logic and_2067_s20_q;
  logic less_2068_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_2074_s20_q;
  logic is_seen_s20_q;
  logic and_2138_s20_q;
  logic and_2150_s20_q;
  logic equal_2293_s20_q;
  logic [8:0] sum_2296_s20_q;
  logic equal_2308_s20_q;
  logic not_2339_s20_q;
  logic and_2360_s20_q;
  logic equal_2411_s20_q;
  logic less_2412_s20_q;
  logic [17:0] select_2424_s20_q;
  logic [17:0] select_2434_s20_q;
  logic equal_2455_s20_q;
  logic and_2617_s20_q;
  logic and_2667_s20_q;
  logic [9:0] select_2671_s20_q;
  logic [9:0] select_2674_s20_q;
  logic [9:0] select_2681_s20_q;
  logic and_2703_s20_q;
  logic and_2724_s20_q;
  logic equal_2924_s20_q;
  logic parity_3255_s20_q;
  logic parity_3384_s20_q;
  logic and_3385_s20_q;
  logic or_3389_s20_q;
  logic or_3393_s20_q;
  logic or_3400_s20_q;
  logic or_3404_s20_q;
  logic or_3408_s20_q;
  logic or_3415_s20_q;
  logic or_3419_s20_q;
  logic or_3423_s20_q;
  logic or_3430_s20_q;
  logic or_3434_s20_q;
  logic or_3438_s20_q;
  logic parity_3444_s20_q;
  logic or_3454_s20_q;
  logic or_3458_s20_q;
  logic and_3465_s20_q;
  logic and_3467_s20_q;
  logic and_3469_s20_q;
  logic equal_3491_s20_q;
  logic and_3591_s20_q;
  logic and_3607_s20_q;
  logic [14:0] difference_3644_s20_q;
  logic equal_3684_s20_q;
  logic less_3804_s20_q;
  logic or_3897_s20_q;
  logic select_3905_s20_q;
  logic equal_3916_s20_q;
  logic equal_3919_s20_q;
  logic equal_3921_s20_q;
  logic equal_3922_s20_q;
  logic equal_3923_s20_q;
  logic equal_3924_s20_q;
  logic and_4080_s20_q;
  logic and_4095_s20_q;
  logic and_4097_s20_q;
  logic not_4109_s20_q;
  logic [31:0] select_4165_s20_q;
  logic [9:0] select_4172_s20_q;
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
      last_s20_q <= last_s19_q;
      and_552_s20_q <= and_552_s19_q;
      equal_577_s20_q <= equal_577_s19_q;
      not_578_s20_q <= not_578_s19_q;
      so_s20_q <= so_s19_q;
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
      less_675_s20_q <= less_675_s19_q;
      less_676_s20_q <= less_676_s19_q;
      less_677_s20_q <= less_677_s19_q;
      less_678_s20_q <= less_678_s19_q;
      less_679_s20_q <= less_679_s19_q;
      less_680_s20_q <= less_680_s19_q;
      less_681_s20_q <= less_681_s19_q;
      less_682_s20_q <= less_682_s19_q;
      and_690_s20_q <= and_690_s19_q;
      and_715_s20_q <= and_715_s19_q;
      and_716_s20_q <= and_716_s19_q;
      sum_738_s20_q <= sum_738[13:5];
      and_746_s20_q <= and_746_s19_q;
      less_747_s20_q <= less_747_s19_q;
      and_752_s20_q <= (and_715_s19_q & and_742_s19_q) & less_751_s19_q;
      less_753_s20_q <= less_753_s19_q;
      equal_1615_s20_q <= equal_1615_s19_q;
      equal_1623_s20_q <= equal_1623_s19_q;
      equal_1625_s20_q <= equal_1625_s19_q;
      equal_1627_s20_q <= equal_1627_s19_q;
      equal_1629_s20_q <= equal_1629_s19_q;
      equal_1631_s20_q <= equal_1631_s19_q;
      equal_1633_s20_q <= equal_1633_s19_q;
      equal_1792_s20_q <= equal_1792_s19_q;
      equal_1794_s20_q <= equal_1794_s19_q;
      not_1799_s20_q <= not_1799_s19_q;
      select_1819_s20_q <= or_1818_s19_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1822_s20_q <= select_1822_s19_q;
      and_1832_s20_q <= sample_pair_whole_s19_q & and_1831;
      select_1847_s20_q <= or_1846_s19_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1851_s20_q <= sample_pair_whole_s19_q & and_1850;
      column_4_s20_q <= column_4;
      select_1866_s20_q <= select_1866_s19_q;
      select_1867_s20_q <= or_1859_s19_q ? row_starts_s19_q : patches_left_next_0_q[4];
      and_1874_s20_q <= and_1874;
      not_1995_s20_q <= not_1995_s19_q;
      and_2067_s20_q <= and_2067_s19_q;
      less_2068_s20_q <= less_2068_s19_q;
      index_2_s20_q <= index_2_s19_q;
      sum_2074_s20_q <= sum_2074_s19_q;
      is_seen_s20_q <= is_seen;
      and_2138_s20_q <= is_seen & less_2137_s19_q;
      and_2150_s20_q <= and_2150_s19_q;
      equal_2293_s20_q <= equal_2293_s19_q;
      sum_2296_s20_q <= sum_2296[13:5];
      equal_2308_s20_q <= equal_2308_s19_q;
      not_2339_s20_q <= ~moments_ends_q;
      and_2360_s20_q <= cfg_prove_i & and_2359;
      equal_2411_s20_q <= equal_2411_s19_q;
      less_2412_s20_q <= less_2412_s19_q;
      select_2424_s20_q <= select_2424;
      select_2434_s20_q <= select_2434;
      equal_2455_s20_q <= equal_2455_s19_q;
      and_2617_s20_q <= and_2617_s19_q;
      and_2667_s20_q <= not_578_s19_q & (so_s19_q & and_2665);
      select_2671_s20_q <= select_2671_s19_q;
      select_2674_s20_q <= select_2674_s19_q;
      select_2681_s20_q <= select_2681;
      and_2703_s20_q <= so_s19_q & (ends_cell_s19_q & (not_2645_s19_q & and_2700));
      and_2724_s20_q <= and_2724_s19_q;
      equal_2924_s20_q <= equal_2924_s19_q;
      parity_3255_s20_q <= parity_3255_s19_q;
      parity_3384_s20_q <= parity_3384;
      and_3385_s20_q <= and_3385;
      or_3389_s20_q <= or_3389;
      or_3393_s20_q <= or_3393;
      or_3400_s20_q <= or_3400;
      or_3404_s20_q <= or_3404;
      or_3408_s20_q <= or_3408;
      or_3415_s20_q <= or_3415;
      or_3419_s20_q <= or_3419;
      or_3423_s20_q <= or_3423;
      or_3430_s20_q <= or_3430;
      or_3434_s20_q <= or_3434;
      or_3438_s20_q <= or_3438;
      parity_3444_s20_q <= parity_3444;
      or_3454_s20_q <= (or_3419 & or_3423) | (or_3415 & (or_3419 | or_3423));
      or_3458_s20_q <= (or_3434 & or_3438) | (or_3430 & (or_3434 | or_3438));
      and_3465_s20_q <= and_3385 & (or_3389 | or_3393);
      and_3467_s20_q <= parity_3426 & parity_3441;
      and_3469_s20_q <= (^{or_3408, or_3404, or_3400}) & (parity_3426 | parity_3441);
      equal_3491_s20_q <= equal_3491_s19_q;
      and_3591_s20_q <= and_3591_s19_q;
      and_3607_s20_q <= not_3593_s19_q & and_3606;
      difference_3644_s20_q <= difference_3644;
      equal_3684_s20_q <= equal_3684_s19_q;
      less_3804_s20_q <= less_3804_s19_q;
      or_3897_s20_q <= or_3897_s19_q;
      select_3905_s20_q <= select_3905_s19_q;
      equal_3916_s20_q <= equal_3916_s19_q;
      equal_3919_s20_q <= equal_3919_s19_q;
      equal_3921_s20_q <= equal_3921_s19_q;
      equal_3922_s20_q <= equal_3922_s19_q;
      equal_3923_s20_q <= equal_3923_s19_q;
      equal_3924_s20_q <= equal_3924_s19_q;
      and_4080_s20_q <= and_4080_s19_q;
      and_4095_s20_q <= and_4095;
      and_4097_s20_q <= and_4097_s19_q;
      not_4109_s20_q <= not_4109_s19_q;
      select_4165_s20_q <= select_4165_s19_q;
      select_4172_s20_q <= select_4172_s19_q;
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
  logic patches_frame_ended_q;
  // hls/stages/moments.hpp:55
  logic out_of_step;
  assign out_of_step = moments_begins_alone_q | (moments_out_of_step_q & not_2339_s20_q);
  // hls/stages/census.hpp:395
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2424_s20_q};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2427;
  assign select_2427 = equal_2411_s20_q ? (less_2412_s20_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:395
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2434_s20_q};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2437;
  assign select_2437 = equal_2411_s20_q ? (less_2412_s20_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2669;
  assign select_2669 = and_2617_s20_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2667_s20_q});
  logic [13:0] select_2683;
  assign select_2683 = and_2617_s20_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2681_s20_q});
  // hls/stages/agreement.hpp:798
  logic and_2704;
  assign and_2704 = not_578_s20_q & and_2703_s20_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2706;
  assign select_2706 = and_2617_s20_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2704});
  logic [13:0] select_2726;
  assign select_2726 = and_2617_s20_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2724_s20_q});
  // hls/stages/count_bits.hpp:24
  logic parity_3446;
  assign parity_3446 = ^{or_3438_s20_q, or_3434_s20_q, or_3430_s20_q, or_3423_s20_q, or_3419_s20_q, or_3415_s20_q, or_3408_s20_q, or_3404_s20_q, or_3400_s20_q, or_3393_s20_q, or_3389_s20_q, and_3385_s20_q};
  // hls/stages/count_bits.hpp:25
  logic or_3450;
  assign or_3450 = (or_3404_s20_q & or_3408_s20_q) | (or_3400_s20_q & (or_3404_s20_q | or_3408_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3461;
  assign parity_3461 = ^{or_3458_s20_q, or_3454_s20_q, or_3450};
  // hls/stages/count_bits.hpp:25
  logic and_3462;
  assign and_3462 = (^{or_3393_s20_q, or_3389_s20_q, and_3385_s20_q}) & parity_3444_s20_q;
  logic or_3466;
  assign or_3466 = (or_3389_s20_q & or_3393_s20_q) | and_3465_s20_q;
  logic or_3470;
  assign or_3470 = and_3467_s20_q | and_3469_s20_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3473;
  assign parity_3473 = ^{or_3470, or_3466, and_3462};
  // hls/stages/count_bits.hpp:25
  logic and_3475;
  assign and_3475 = parity_3461 & parity_3473;
  logic or_3479;
  assign or_3479 = (or_3454_s20_q & or_3458_s20_q) | (or_3450 & (or_3454_s20_q | or_3458_s20_q));
  logic or_3483;
  assign or_3483 = (or_3466 & or_3470) | (and_3462 & (or_3466 | or_3470));
  // hls/stages/patches.hpp:190
  logic and_3608;
  assign and_3608 = and_3591_s20_q & and_3607_s20_q;
  // hls/stages/patches.hpp:667
  logic not_3609;
  assign not_3609 = ~patches_lower_s20_q;
  // hls/stages/patches.hpp:611
  logic less_3645;
  assign less_3645 = $signed({{8{difference_3615[6]}}, difference_3615}) < $signed(difference_3644_s20_q);
  // hls/stages/patches.hpp:610
  logic less_3650;
  assign less_3650 = $signed(difference_3644_s20_q) < $signed({9'h0, cfg_patch_limit_i});
  // hls/stages/agreement.hpp:1145
  logic less_3685;
  assign less_3685 = x_s20_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:798
  logic and_3689;
  assign and_3689 = equal_577_s20_q & (x_s20_q[6] & (not_1995_s20_q & (equal_3684_s20_q & less_3685)));
  // hls/stages/agreement.hpp:1157
  logic and_3694;
  assign and_3694 = x_s20_q[6] & (not_1995_s20_q & (less_3685 & (x_s20_q[2:0] == 3'h1)));
  logic and_3701;
  assign and_3701 = x_s20_q[6] & (not_1995_s20_q & (less_3685 & (x_s20_q[2:0] == 3'h2)));
  logic and_3708;
  assign and_3708 = x_s20_q[6] & (not_1995_s20_q & (less_3685 & (x_s20_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:203
  logic select_3715;
  assign select_3715 = (x_s20_q[5:3] == 3'h2) ? x_s20_q[1] : (x_s20_q[0] & (x_s20_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3742;
  assign sum_3742 = {2'h0, x_s20_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3759;
  assign select_3759 = ($signed(difference_3644_s20_q[14:4]) < $signed(11'h7ff)) ? 6'h30 : difference_3644_s20_q[5:0];
  logic [5:0] select_3760;
  assign select_3760 = ($signed(15'h10) < $signed(difference_3644_s20_q)) ? 6'h10 : select_3759;
  // hls/stages/agreement.hpp:798
  logic and_3767;
  assign and_3767 = equal_577_s20_q & (x_s20_q[6] & (not_1995_s20_q & (equal_2924_s20_q & less_3685)));
  // hls/stages/agreement.hpp:1157
  logic and_3771;
  assign and_3771 = x_s20_q[6] & (not_1995_s20_q & (less_3685 & (x_s20_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:1140
  logic [13:0] select_3926;
  assign select_3926 = equal_3923_s20_q ? counts_skin_unproven_q : (equal_3924_s20_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3928;
  assign select_3928 = equal_3922_s20_q ? counts_regions_bad_q : (equal_3919_s20_q ? counts_nearer_s20_q : select_3926);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3921_s20_q ? counts_on_skin_q : select_3928;
  // hls/stages/agreement.hpp:798
  logic and_4156;
  assign and_4156 = equal_577_s20_q & (x_s20_q[6] & (not_1995_s20_q | (4'hc < x_s20_q[5:2])));
  // hls/stages/agreement.hpp:1155
  logic [31:0] select_4166;
  assign select_4166 = equal_1633_s20_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4165_s20_q;
  logic [31:0] select_4167;
  assign select_4167 = equal_1631_s20_q ? {8'h0, sharpness_sums_detail_0_s20_q} : select_4166;
  logic [31:0] select_4168;
  assign select_4168 = equal_1629_s20_q ? {8'h0, sharpness_sums_detail_1_s20_q} : select_4167;
  logic [31:0] select_4169;
  assign select_4169 = equal_1627_s20_q ? {8'h0, sharpness_sums_contrast_0_s20_q} : select_4168;
  logic [31:0] select_4170;
  assign select_4170 = equal_1625_s20_q ? {8'h0, sharpness_sums_contrast_1_s20_q} : select_4169;

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1822_s20_q, select_1819_s20_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s20_en & and_1832_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s20_q;
  end
`ifndef SYNTHESIS
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
      patches_right_0_re_s9_sim <= patches_right_0_re;
      patches_right_0_raddr_s9_sim <= patches_right_0_raddr;
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
  assign patches_right_1_waddr = {select_1822_s20_q, select_1847_s20_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s20_en & and_1851_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s20_q;
  end
`ifndef SYNTHESIS
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
      patches_right_1_re_s9_sim <= patches_right_1_re;
      patches_right_1_raddr_s9_sim <= patches_right_1_raddr;
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
  assign patches_left_waddr = {select_1867_s20_q, select_1866_s20_q, column_4_s20_q};
  logic patches_left_we;
  assign patches_left_we = s20_en & and_1874_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s20_q;
  end
`ifndef SYNTHESIS
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
      patches_left_re_s10_sim <= patches_left_re;
      patches_left_raddr_s10_sim <= patches_left_raddr;
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
  assign map_waddr = {sum_2074_s20_q, index_2_s20_q};
  logic map_we;
  assign map_we = s20_en & and_2150_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2138_s20_q, is_seen_s20_q};
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
      patches_frame_ended_q <= 1'b0;
    end else if (s20_en) begin
      moments_out_of_step_q <= out_of_step;
      moments_begins_alone_q <= equal_577_s20_q & (equal_2308_s20_q & and_2360_s20_q);
      sharpness_comparing_rest_0_q <= so_s20_q ? select_2427 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s20_q ? select_2437 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2669;
      counts_regions_bad_q <= select_2683;
      counts_skin_unproven_q <= select_2706;
      counts_on_skin_q <= select_2726;
      patches_frame_ended_q <= equal_577_s20_q & equal_2308_s20_q;
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
  logic [4:0] patches_summed_row_column_s21_q;
  logic patches_summed_first_s21_q;
  logic patches_summed_last_s21_q;
  logic [4:0] patches_summed_down_by_s21_q;
  logic patches_frame_ended_s21_q;
  logic [13:0] product_s21_q;
  logic [6:0] last_s21_q;
  logic and_552_s21_q;
  logic equal_577_s21_q;
  logic so_s21_q;
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
  logic less_675_s21_q;
  logic less_676_s21_q;
  logic less_677_s21_q;
  logic less_678_s21_q;
  logic less_679_s21_q;
  logic less_680_s21_q;
  logic less_681_s21_q;
  logic less_682_s21_q;
  logic and_690_s21_q;
  logic and_715_s21_q;
  logic and_716_s21_q;
  logic less_739_s21_q;
  logic and_746_s21_q;
  logic less_747_s21_q;
  logic and_752_s21_q;
  logic less_753_s21_q;
  logic equal_1615_s21_q;
  logic equal_1623_s21_q;
  logic equal_1792_s21_q;
  logic equal_1794_s21_q;
  logic and_2067_s21_q;
  logic less_2068_s21_q;
  logic [1:0] map_rdata_s21_q;
  logic is_seen_s21_q;
  logic and_2138_s21_q;
  logic equal_2293_s21_q;
  logic and_2298_s21_q;
  logic equal_2411_s21_q;
  logic sum_s21_q;
  logic sum_2_s21_q;
  logic equal_2455_s21_q;
  logic select_2473_s21_q;
  logic select_2479_s21_q;
  logic [9:0] select_2671_s21_q;
  logic [9:0] select_2674_s21_q;
  logic parity_3255_s21_q;
  logic parity_3384_s21_q;
  logic parity_3446_s21_q;
  logic xor_3474_s21_q;
  logic parity_3486_s21_q;
  logic and_3487_s21_q;
  logic and_3489_s21_q;
  logic equal_3491_s21_q;
  logic and_3611_s21_q;
  logic not_3646_s21_q;
  logic not_3651_s21_q;
  logic and_3655_s21_q;
  logic and_3665_s21_q;
  logic and_3675_s21_q;
  logic equal_3684_s21_q;
  logic and_3689_s21_q;
  logic and_3695_s21_q;
  logic and_3702_s21_q;
  logic and_3709_s21_q;
  logic and_3718_s21_q;
  logic and_3745_s21_q;
  logic [5:0] select_3761_s21_q;
  logic and_3767_s21_q;
  logic and_3772_s21_q;
  logic and_3805_s21_q;
  logic or_3897_s21_q;
  logic select_3905_s21_q;
  logic equal_3916_s21_q;
  logic and_3920_s21_q;
  logic [13:0] before_v_4_s21_q;
  logic not_3965_s21_q;
  logic or_3969_s21_q;
  logic and_3974_s21_q;
  logic less_3975_s21_q;
  logic and_4080_s21_q;
  logic and_4095_s21_q;
  logic and_4097_s21_q;
  logic not_4109_s21_q;
  logic and_4156_s21_q;
  logic [5:0] select_4158_s21_q;
  logic [31:0] select_4170_s21_q;
  logic [9:0] select_4172_s21_q;
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
      patches_summed_row_column_s21_q <= patches_summed_row_column_s20_q;
      patches_summed_first_s21_q <= patches_summed_first_s20_q;
      patches_summed_last_s21_q <= patches_summed_last_s20_q;
      patches_summed_down_by_s21_q <= patches_summed_down_by_s20_q;
      patches_frame_ended_s21_q <= patches_frame_ended_q;
      product_s21_q <= product_s20_q;
      last_s21_q <= last_s20_q;
      and_552_s21_q <= and_552_s20_q;
      equal_577_s21_q <= equal_577_s20_q;
      so_s21_q <= so_s20_q;
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
      less_675_s21_q <= less_675_s20_q;
      less_676_s21_q <= less_676_s20_q;
      less_677_s21_q <= less_677_s20_q;
      less_678_s21_q <= less_678_s20_q;
      less_679_s21_q <= less_679_s20_q;
      less_680_s21_q <= less_680_s20_q;
      less_681_s21_q <= less_681_s20_q;
      less_682_s21_q <= less_682_s20_q;
      and_690_s21_q <= and_690_s20_q;
      and_715_s21_q <= and_715_s20_q;
      and_716_s21_q <= and_716_s20_q;
      less_739_s21_q <= 9'h4 < sum_738_s20_q;
      and_746_s21_q <= and_746_s20_q;
      less_747_s21_q <= less_747_s20_q;
      and_752_s21_q <= and_752_s20_q;
      less_753_s21_q <= less_753_s20_q;
      equal_1615_s21_q <= equal_1615_s20_q;
      equal_1623_s21_q <= equal_1623_s20_q;
      equal_1792_s21_q <= equal_1792_s20_q;
      equal_1794_s21_q <= equal_1794_s20_q;
      and_2067_s21_q <= and_2067_s20_q;
      less_2068_s21_q <= less_2068_s20_q;
      map_rdata_s21_q <= map_rdata_q;
      is_seen_s21_q <= is_seen_s20_q;
      and_2138_s21_q <= and_2138_s20_q;
      equal_2293_s21_q <= equal_2293_s20_q;
      and_2298_s21_q <= and_715_s20_q & (9'h4 < sum_2296_s20_q);
      equal_2411_s21_q <= equal_2411_s20_q;
      sum_s21_q <= sum[0];
      sum_2_s21_q <= sum_2[0];
      equal_2455_s21_q <= equal_2455_s20_q;
      select_2473_s21_q <= sharpness_comparing_less_contrast_0_q;
      select_2479_s21_q <= sharpness_comparing_less_contrast_1_q;
      select_2671_s21_q <= select_2671_s20_q;
      select_2674_s21_q <= select_2674_s20_q;
      parity_3255_s21_q <= parity_3255_s20_q;
      parity_3384_s21_q <= parity_3384_s20_q;
      parity_3446_s21_q <= parity_3446;
      xor_3474_s21_q <= parity_3461 ^ parity_3473;
      parity_3486_s21_q <= ^{or_3483, or_3479, and_3475};
      and_3487_s21_q <= or_3479 & or_3483;
      and_3489_s21_q <= and_3475 & (or_3479 | or_3483);
      equal_3491_s21_q <= equal_3491_s20_q;
      and_3611_s21_q <= and_3608 & (not_1799_s20_q & not_3609);
      not_3646_s21_q <= ~less_3645;
      not_3651_s21_q <= ~less_3650;
      and_3655_s21_q <= and_3608 & (patches_second_s20_q & not_3609);
      and_3665_s21_q <= and_3608 & (patches_lower_s20_q & not_1799_s20_q);
      and_3675_s21_q <= and_3608 & (patches_lower_s20_q & patches_second_s20_q);
      equal_3684_s21_q <= equal_3684_s20_q;
      and_3689_s21_q <= and_3689;
      and_3695_s21_q <= equal_577_s20_q & and_3694;
      and_3702_s21_q <= equal_577_s20_q & and_3701;
      and_3709_s21_q <= equal_577_s20_q & and_3708;
      and_3718_s21_q <= x_s20_q[6] & (not_1995_s20_q & (less_3685 & select_3715));
      and_3745_s21_q <= not_1995_s20_q & (less_3685 & (sum_3742[4:2] == 3'h0));
      select_3761_s21_q <= and_3608 ? select_3760 : 6'h0;
      and_3767_s21_q <= and_3767;
      and_3772_s21_q <= equal_577_s20_q & and_3771;
      and_3805_s21_q <= less_3804_s20_q & and_3608;
      or_3897_s21_q <= or_3897_s20_q;
      select_3905_s21_q <= select_3905_s20_q;
      equal_3916_s21_q <= equal_3916_s20_q;
      and_3920_s21_q <= equal_3919_s20_q & equal_3684_s20_q;
      before_v_4_s21_q <= before_v_4;
      not_3965_s21_q <= ~(equal_3924_s20_q & equal_3684_s20_q);
      or_3969_s21_q <= (equal_3924_s20_q | equal_3923_s20_q) | (x_s20_q[6:3] == 4'hf);
      and_3974_s21_q <= equal_3921_s20_q & equal_3684_s20_q;
      less_3975_s21_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4080_s21_q <= and_4080_s20_q;
      and_4095_s21_q <= and_4095_s20_q;
      and_4097_s21_q <= and_4097_s20_q;
      not_4109_s21_q <= not_4109_s20_q;
      and_4156_s21_q <= and_4156;
      select_4158_s21_q <= equal_577_s20_q ? (x_s20_q[6] ? x_s20_q[5:0] : 6'h0) : 6'h0;
      select_4170_s21_q <= select_4170;
      select_4172_s21_q <= select_4172_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
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
  logic and_740;
  assign and_740 = and_690_s21_q & less_739_s21_q;
  // hls/stages/census.hpp:324
  logic and_2299;
  assign and_2299 = and_715_s21_q & less_739_s21_q;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2300;
  assign sum_2300 = census_left_misses_q + {{17{and_2299}}, and_2298_s21_q, 1'b0, and_2298_s21_q};
  // hls/stages/agreement.hpp:530
  logic [19:0] select_2302;
  assign select_2302 = and_552_s21_q ? (equal_2293_s21_q ? 20'h0 : sum_2300) : census_left_misses_q;
  // hls/stages/agreement.hpp:217
  logic [2:0] select_2439;
  assign select_2439 = equal_2411_s21_q ? {sharpness_comparing_product_0_q[1:0], sum_s21_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2441;
  assign select_2441 = equal_2411_s21_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s21_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s21_q});
  // hls/stages/agreement.hpp:217
  logic select_2450;
  assign select_2450 = so_s21_q ? (equal_2411_s21_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s21_q});
  // hls/stages/agreement.hpp:217
  logic select_2453;
  assign select_2453 = equal_2411_s21_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:403
  logic xor_2456;
  assign xor_2456 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2462;
  assign xor_2462 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/count_bits.hpp:27
  logic or_3490;
  assign or_3490 = and_3487_s21_q | and_3489_s21_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3490, parity_3486_s21_q, xor_3474_s21_q, parity_3446_s21_q, parity_3384_s21_q, parity_3255_s21_q} + (equal_3491_s21_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3495;
  assign select_3495 = equal_1792_s21_q ? patches_sums_values_0_q : (equal_1794_s21_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3496;
  assign select_3496 = equal_1794_s21_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3498;
  assign select_3498 = equal_1794_s21_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3500;
  assign select_3500 = equal_1794_s21_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3502;
  assign select_3502 = equal_1794_s21_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3504;
  assign select_3504 = equal_1794_s21_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3506;
  assign select_3506 = equal_1794_s21_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3508;
  assign select_3508 = equal_1794_s21_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3510;
  assign select_3510 = equal_1794_s21_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3512;
  assign select_3512 = equal_1794_s21_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3514;
  assign select_3514 = equal_1794_s21_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3516;
  assign select_3516 = equal_1794_s21_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3518;
  assign select_3518 = equal_1794_s21_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3520;
  assign select_3520 = equal_1794_s21_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3522;
  assign select_3522 = equal_1794_s21_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3524;
  assign select_3524 = equal_1794_s21_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3526;
  assign select_3526 = equal_1794_s21_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3613;
  assign sum_3613 = {7'h0, and_3611_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:670
  logic and_3647;
  assign and_3647 = not_3646_s21_q & and_3611_s21_q;
  logic [7:0] sum_3648;
  assign sum_3648 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3647};
  // hls/stages/patches.hpp:671
  logic and_3652;
  assign and_3652 = not_3651_s21_q & and_3611_s21_q;
  logic [7:0] sum_3653;
  assign sum_3653 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3652};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3657;
  assign sum_3657 = {7'h0, and_3655_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_3659;
  assign and_3659 = not_3646_s21_q & and_3655_s21_q;
  logic [7:0] sum_3660;
  assign sum_3660 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3659};
  // hls/stages/patches.hpp:671
  logic and_3662;
  assign and_3662 = not_3651_s21_q & and_3655_s21_q;
  logic [7:0] sum_3663;
  assign sum_3663 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3662};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3667;
  assign sum_3667 = {7'h0, and_3665_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_3669;
  assign and_3669 = not_3646_s21_q & and_3665_s21_q;
  logic [7:0] sum_3670;
  assign sum_3670 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3669};
  // hls/stages/patches.hpp:671
  logic and_3672;
  assign and_3672 = not_3651_s21_q & and_3665_s21_q;
  logic [7:0] sum_3673;
  assign sum_3673 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3672};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3677;
  assign sum_3677 = {7'h0, and_3675_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_3679;
  assign and_3679 = not_3646_s21_q & and_3675_s21_q;
  logic [7:0] sum_3680;
  assign sum_3680 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3679};
  // hls/stages/patches.hpp:671
  logic and_3682;
  assign and_3682 = not_3651_s21_q & and_3675_s21_q;
  logic [7:0] sum_3683;
  assign sum_3683 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3682};
  // hls/stages/patches.hpp:633
  logic [7:0] or_3697;
  assign or_3697 = (and_3689_s21_q ? patches_quarters_0_places_q : 8'h0) | (and_3695_s21_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3711;
  assign or_3711 = (or_3697 | (and_3702_s21_q ? patches_quarters_2_places_q : 8'h0)) | (and_3709_s21_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:798
  logic and_3719;
  assign and_3719 = equal_577_s21_q & and_3718_s21_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_3721;
  assign select_3721 = and_3689_s21_q ? (and_3719 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3723;
  assign select_3723 = and_3695_s21_q ? (and_3719 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3726;
  assign select_3726 = and_3702_s21_q ? (and_3719 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3729;
  assign select_3729 = and_3709_s21_q ? (and_3719 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_3732;
  assign select_3732 = and_3689_s21_q ? (and_3719 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3734;
  assign select_3734 = and_3695_s21_q ? (and_3719 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3737;
  assign select_3737 = and_3702_s21_q ? (and_3719 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3740;
  assign select_3740 = and_3709_s21_q ? (and_3719 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic and_3747;
  assign and_3747 = equal_577_s21_q & (x_s21_q & and_3745_s21_q);
  // hls/stages/patches.hpp:628
  logic [7:0] sum_3749;
  assign sum_3749 = patches_word_places_q + (and_3695_s21_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:630
  logic [7:0] select_3753;
  assign select_3753 = and_3747 ? (patches_word_up_q + (and_3695_s21_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3755;
  assign sum_3755 = patches_word_down_q + (and_3695_s21_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:673
  logic [11:0] sum_3762;
  assign sum_3762 = patches_across_q + {{6{select_3761_s21_q[5]}}, select_3761_s21_q};
  // hls/stages/patches.hpp:674
  logic [11:0] select_3763;
  assign select_3763 = patches_round_ends_q ? {{6{select_3761_s21_q[5]}}, select_3761_s21_q} : sum_3762;
  // hls/stages/patches.hpp:657
  logic [7:0] select_3774;
  assign select_3774 = and_3767_s21_q ? (and_3772_s21_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_3778;
  assign or_3778 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_3781;
  assign or_3781 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_3782;
  assign sum_3782 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_3784;
  assign select_3784 = and_3767_s21_q ? (and_3772_s21_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3787;
  assign and_3787 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_3788;
  assign select_3788 = and_3767_s21_q ? {and_3787, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3790;
  assign select_3790 = and_3767_s21_q ? (and_3772_s21_q ? {and_3787, patches_found_q[2:1]} : select_3788) : patches_found_q;
  // hls/stages/patches.hpp:655
  logic or_3793;
  assign or_3793 = patches_partly_q | (patches_doubted_q & (~and_3772_s21_q));
  // hls/stages/patches.hpp:656
  logic select_3795;
  assign select_3795 = and_3772_s21_q ? or_3793 : (and_3767_s21_q ? or_3793 : patches_doubted_q);
  // hls/stages/patches.hpp:654
  logic select_3797;
  assign select_3797 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3801;
  assign select_3801 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3806;
  assign sum_3806 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3805_s21_q};
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_3829;
  assign select_3829 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_3835;
  assign and_3835 = patches_frame_ended_s21_q & (~patches_age_q[9]);
  logic [9:0] sum_3836;
  assign sum_3836 = patches_age_q + {9'h0, and_3835};
  logic [9:0] select_3839;
  assign select_3839 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3836)) : sum_3836;
  // hls/stages/agreement.hpp:1237
  logic [14:0] over;
  assign over = {1'b0, product_s21_q} - {1'b0, before_v_4_s21_q};
  // hls/stages/agreement.hpp:1245
  logic select_3931;
  assign select_3931 = and_3920_s21_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1324
  logic [1:0] select_4096;
  assign select_4096 = and_4095_s21_q ? {and_2138_s21_q, is_seen_s21_q} : map_rdata_s21_q;
  // hls/stages/agreement.hpp:1254
  logic or_4110;
  assign or_4110 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4109_s21_q;
  // hls/stages/agreement.hpp:798
  logic and_4125;
  assign and_4125 = equal_3916_s21_q & (cfg_prove_i & (registration_moved_s21_q | patches_moved_q));
  // hls/stages/agreement.hpp:1165
  logic or_4128;
  assign or_4128 = select_2473_s21_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:798
  logic and_4152;
  assign and_4152 = equal_577_s21_q & (equal_3916_s21_q & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/agreement.hpp:1155
  logic [31:0] select_4171;
  assign select_4171 = equal_1623_s21_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4170_s21_q;
  // hls/stages/agreement.hpp:1157
  logic [31:0] select_4173;
  assign select_4173 = equal_1615_s21_q ? select_4171 : {2'h0, select_4172_s21_q, select_2674_s21_q, select_2671_s21_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s21_q;
  logic fresh_we;
  assign fresh_we = s21_en & and_552_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_753_s21_q, and_752_s21_q, less_747_s21_q, and_746_s21_q, census_columns_values_1_cell_2_of_skin_s21_q, and_740, and_716_s21_q, and_715_s21_q, and_690_s21_q, less_682_s21_q, less_681_s21_q, less_680_s21_q, less_679_s21_q, less_678_s21_q, less_677_s21_q, less_676_s21_q, less_675_s21_q, less_674_s21_q, less_673_s21_q, less_672_s21_q, less_671_s21_q, less_670_s21_q, less_669_s21_q, less_668_s21_q, less_667_s21_q, less_666_s21_q, less_665_s21_q, less_664_s21_q, less_663_s21_q, less_662_s21_q, less_661_s21_q, less_660_s21_q, less_659_s21_q};
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
      census_left_misses_q <= select_2302;
      sharpness_comparing_product_0_q <= so_s21_q ? select_2439 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s21_q ? select_2441 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2450;
      sharpness_comparing_carry_1_q <= so_s21_q ? select_2453 : sharpness_comparing_carry_1_q;
      patches_sums_values_0_q <= select_3495;
      patches_sums_values_1_q <= equal_1792_s21_q ? patches_sums_values_1_q : select_3496;
      patches_sums_values_2_q <= equal_1792_s21_q ? patches_sums_values_2_q : select_3498;
      patches_sums_values_3_q <= equal_1792_s21_q ? patches_sums_values_3_q : select_3500;
      patches_sums_values_4_q <= equal_1792_s21_q ? patches_sums_values_4_q : select_3502;
      patches_sums_values_5_q <= equal_1792_s21_q ? patches_sums_values_5_q : select_3504;
      patches_sums_values_6_q <= equal_1792_s21_q ? patches_sums_values_6_q : select_3506;
      patches_sums_values_7_q <= equal_1792_s21_q ? patches_sums_values_7_q : select_3508;
      patches_sums_values_8_q <= equal_1792_s21_q ? patches_sums_values_8_q : select_3510;
      patches_sums_values_9_q <= equal_1792_s21_q ? patches_sums_values_9_q : select_3512;
      patches_sums_values_10_q <= equal_1792_s21_q ? patches_sums_values_10_q : select_3514;
      patches_sums_values_11_q <= equal_1792_s21_q ? patches_sums_values_11_q : select_3516;
      patches_sums_values_12_q <= equal_1792_s21_q ? patches_sums_values_12_q : select_3518;
      patches_sums_values_13_q <= equal_1792_s21_q ? patches_sums_values_13_q : select_3520;
      patches_sums_values_14_q <= equal_1792_s21_q ? patches_sums_values_14_q : select_3522;
      patches_sums_values_15_q <= equal_1792_s21_q ? patches_sums_values_15_q : select_3524;
      patches_sums_values_16_q <= equal_1792_s21_q ? patches_sums_values_16_q : select_3526;
      patches_quarters_0_places_q <= sum_3613;
      patches_quarters_0_up_q <= sum_3648;
      patches_quarters_0_down_q <= sum_3653;
      patches_quarters_1_places_q <= sum_3657;
      patches_quarters_1_up_q <= sum_3660;
      patches_quarters_1_down_q <= sum_3663;
      patches_quarters_2_places_q <= sum_3667;
      patches_quarters_2_up_q <= sum_3670;
      patches_quarters_2_down_q <= sum_3673;
      patches_quarters_3_places_q <= sum_3677;
      patches_quarters_3_up_q <= sum_3680;
      patches_quarters_3_down_q <= sum_3683;
      patches_word_places_q <= or_3711;
      patches_word_up_q <= ((select_3721 | select_3723) | select_3726) | select_3729;
      patches_word_down_q <= ((select_3732 | select_3734) | select_3737) | select_3740;
      patches_sum_places_q <= and_3747 ? sum_3749 : patches_sum_places_q;
      patches_sum_up_q <= select_3753;
      patches_sum_down_q <= and_3747 ? sum_3755 : patches_sum_down_q;
      patches_across_q <= select_3763;
      patches_places_q <= select_3774;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3778;
      patches_partly_q <= or_3781;
      patches_clear_limit_q <= sum_3782[8:2];
      patches_complete_q <= select_3784;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3790;
      patches_doubted_q <= and_3767_s21_q ? select_3795 : patches_doubted_q;
      patches_doubted_before_q <= select_3797;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3801;
      patches_on_skin_q <= sum_3806;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3829;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3839;
      hides_q <= equal_577_s21_q ? select_3931 : hides_q;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic [9:0] patches_sums_values_0_s22_q;
  logic [4:0] patches_summed_row_column_s22_q;
  logic patches_summed_first_s22_q;
  logic patches_summed_last_s22_q;
  logic [4:0] patches_summed_down_by_s22_q;
  logic patches_round_ends_s22_q;
  logic [7:0] patches_on_skin_s22_q;
  logic equal_577_s22_q;
  logic so_s22_q;
  logic and_2067_s22_q;
  logic less_2068_s22_q;
  logic equal_2411_s22_q;
  logic or_2457_s22_q;
  logic and_2458_s22_q;
  logic or_2463_s22_q;
  logic and_2464_s22_q;
  logic select_2479_s22_q;
  logic or_3897_s22_q;
  logic select_3905_s22_q;
  logic equal_3916_s22_q;
  logic select_3931_s22_q;
  logic and_3963_s22_q;
  logic not_3965_s22_q;
  logic or_3969_s22_q;
  logic and_3974_s22_q;
  logic and_3976_s22_q;
  logic and_4080_s22_q;
  logic and_4098_s22_q;
  logic and_4101_s22_q;
  logic and_4113_s22_q;
  logic and_4126_s22_q;
  logic or_4128_s22_q;
  logic and_4152_s22_q;
  logic and_4156_s22_q;
  logic [5:0] select_4158_s22_q;
  logic [31:0] select_4175_s22_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      patches_sums_values_0_s22_q <= patches_sums_values_0_q;
      patches_summed_row_column_s22_q <= patches_summed_row_column_s21_q;
      patches_summed_first_s22_q <= patches_summed_first_s21_q;
      patches_summed_last_s22_q <= patches_summed_last_s21_q;
      patches_summed_down_by_s22_q <= patches_summed_down_by_s21_q;
      patches_round_ends_s22_q <= patches_round_ends_q;
      patches_on_skin_s22_q <= patches_on_skin_q;
      equal_577_s22_q <= equal_577_s21_q;
      so_s22_q <= so_s21_q;
      and_2067_s22_q <= and_2067_s21_q;
      less_2068_s22_q <= less_2068_s21_q;
      equal_2411_s22_q <= equal_2411_s21_q;
      or_2457_s22_q <= equal_2455_s21_q | xor_2456;
      and_2458_s22_q <= five_times[0] & xor_2456;
      or_2463_s22_q <= equal_2455_s21_q | xor_2462;
      and_2464_s22_q <= five_times_2[0] & xor_2462;
      select_2479_s22_q <= select_2479_s21_q;
      or_3897_s22_q <= or_3897_s21_q;
      select_3905_s22_q <= select_3905_s21_q;
      equal_3916_s22_q <= equal_3916_s21_q;
      select_3931_s22_q <= select_3931;
      and_3963_s22_q <= over[14] & equal_3684_s21_q;
      not_3965_s22_q <= not_3965_s21_q;
      or_3969_s22_q <= or_3969_s21_q;
      and_3974_s22_q <= and_3974_s21_q;
      and_3976_s22_q <= over[14] & less_3975_s21_q;
      and_4080_s22_q <= and_4080_s21_q;
      and_4098_s22_q <= select_4096[0] & and_4097_s21_q;
      and_4101_s22_q <= select_4096[1] & and_4097_s21_q;
      and_4113_s22_q <= equal_577_s21_q & (equal_3916_s21_q & (cfg_prove_i & or_4110));
      and_4126_s22_q <= equal_577_s21_q & and_4125;
      or_4128_s22_q <= or_4128;
      and_4152_s22_q <= and_4152;
      and_4156_s22_q <= and_4156_s21_q;
      select_4158_s22_q <= select_4158_s21_q;
      select_4175_s22_q <= equal_577_s21_q ? (x_s21_q ? select_4173 : 32'h0) : 32'h0;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic [9:0] patches_best_differing_q;
  logic [4:0] patches_best_column_q;
  logic [4:0] patches_on_skin_limit_q;
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic overlooks_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/patches.hpp:186
  logic less_1977;
  assign less_1977 = patches_sums_values_0_s22_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_1978;
  assign not_1978 = ~less_1977;
  logic [1:0] select_1979;
  assign select_1979 = patches_summed_first_s22_q ? 2'h2 : {less_1977, not_1978};
  logic [12:0] select_1981;
  assign select_1981 = select_1979[0] ? {4'h0, patches_summed_first_s22_q, 3'h0, patches_summed_row_column_s22_q} : {patches_summed_row_column_s22_q, patches_sums_values_0_s22_q[7:0]};
  logic [14:0] select_1982;
  assign select_1982 = select_1979[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1983;
  assign select_1983 = (select_1979 == 2'h2) ? {select_1981[12:8], patches_sums_values_0_s22_q[9:8], select_1981[7:0]} : select_1982;
  // hls/stages/census.hpp:403
  logic select_2459;
  assign select_2459 = or_2457_s22_q ? and_2458_s22_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2460;
  assign select_2460 = equal_2411_s22_q ? select_2459 : sharpness_comparing_less_detail_0_q;
  logic select_2461;
  assign select_2461 = so_s22_q ? select_2460 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic select_2465;
  assign select_2465 = or_2463_s22_q ? and_2464_s22_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2466;
  assign select_2466 = equal_2411_s22_q ? select_2465 : sharpness_comparing_less_detail_1_q;
  logic select_2467;
  assign select_2467 = so_s22_q ? select_2466 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:663
  logic [12:0] product_3811;
  assign product_3811 = {8'h0, patches_on_skin_limit_q} * {5'h0, patches_places_q};
  // hls/stages/agreement.hpp:1163
  logic not_3932;
  assign not_3932 = ~hidden_for_q[7];
  logic [7:0] select_3934;
  assign select_3934 = select_3931_s22_q ? (hidden_for_q + {7'h0, not_3932}) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3936;
  assign select_3936 = equal_577_s22_q ? (equal_3916_s22_q ? select_3934 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1243
  logic and_3966;
  assign and_3966 = too_much_q & not_3965_s22_q;
  // hls/stages/agreement.hpp:1244
  logic select_3971;
  assign select_3971 = and_3963_s22_q ? (and_3966 | or_3969_s22_q) : and_3966;
  // hls/stages/agreement.hpp:1246
  logic select_3977;
  assign select_3977 = and_3974_s22_q ? and_3976_s22_q : overlooks_q;
  // hls/stages/agreement.hpp:443
  logic select_4100;
  assign select_4100 = and_2067_s22_q ? (less_2068_s22_q ? and_4098_s22_q : seen_q) : seen_q;
  logic select_4103;
  assign select_4103 = and_2067_s22_q ? (less_2068_s22_q ? and_4101_s22_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:798
  logic and_4116;
  assign and_4116 = equal_577_s22_q & (equal_3916_s22_q & (cfg_prove_i & or_3897_s22_q));
  // hls/stages/agreement.hpp:1256
  logic not_4118;
  assign not_4118 = ~(or_3897_s22_q | not_2363);
  // hls/stages/agreement.hpp:798
  logic and_4121;
  assign and_4121 = equal_3916_s22_q & (not_4118 & (select_3905_s22_q | select_3971));
  logic and_4135;
  assign and_4135 = equal_3916_s22_q & (not_4118 & (select_2467 | select_2479_s22_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
      patches_best_differing_q <= 10'h0;
      patches_best_column_q <= 5'h0;
      patches_on_skin_limit_q <= 5'h0;
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s22_en) begin
      sharpness_comparing_less_detail_0_q <= select_2461;
      sharpness_comparing_less_detail_1_q <= select_2467;
      patches_best_differing_q <= select_1983[9:0];
      patches_best_column_q <= select_1983[14:10];
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      hidden_for_q <= select_3936;
      too_much_q <= equal_577_s22_q ? select_3971 : too_much_q;
      overlooks_q <= equal_577_s22_q ? select_3977 : overlooks_q;
      seen_q <= select_4100;
      nearer_q <= select_4103;
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
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic patches_round_ends_s23_q;
  logic [7:0] patches_on_skin_s23_q;
  logic equal_577_s23_q;
  logic [7:0] product_3811_s23_q;
  logic equal_3916_s23_q;
  logic and_4080_s23_q;
  logic and_4113_s23_q;
  logic and_4116_s23_q;
  logic and_4122_s23_q;
  logic and_4126_s23_q;
  logic and_4131_s23_q;
  logic and_4135_s23_q;
  logic not_4140_s23_q;
  logic or_4146_s23_q;
  logic and_4152_s23_q;
  logic and_4156_s23_q;
  logic [5:0] select_4158_s23_q;
  logic [31:0] select_4175_s23_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_s22_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_s22_q;
      patches_round_ends_s23_q <= patches_round_ends_s22_q;
      patches_on_skin_s23_q <= patches_on_skin_s22_q;
      equal_577_s23_q <= equal_577_s22_q;
      product_3811_s23_q <= product_3811[12:5];
      equal_3916_s23_q <= equal_3916_s22_q;
      and_4080_s23_q <= and_4080_s22_q;
      and_4113_s23_q <= and_4113_s22_q;
      and_4116_s23_q <= and_4116;
      and_4122_s23_q <= equal_577_s22_q & and_4121;
      and_4126_s23_q <= and_4126_s22_q;
      and_4131_s23_q <= equal_3916_s22_q & (not_4118 & (select_2461 | or_4128_s22_q));
      and_4135_s23_q <= and_4135;
      not_4140_s23_q <= ~(select_3934 < cfg_hidden_frames_i);
      or_4146_s23_q <= not_2363 | (select_3977 & not_3808);
      and_4152_s23_q <= and_4152_s22_q;
      and_4156_s23_q <= and_4156_s22_q;
      select_4158_s23_q <= select_4158_s22_q;
      select_4175_s23_q <= select_4175_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:192
  logic and_3813;
  assign and_3813 = (~(patches_on_skin_s23_q[7:2] == 6'h0)) & (product_3811_s23_q < patches_on_skin_s23_q);
  logic select_3818;
  assign select_3818 = patches_round_ends_s23_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_3822;
  assign or_3822 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s23_q));
  // hls/stages/agreement.hpp:1165
  logic and_4142;
  assign and_4142 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4140_s23_q);
  // hls/stages/agreement.hpp:798
  logic and_4148;
  assign and_4148 = equal_3916_s23_q & (or_4146_s23_q ? cfg_prove_i : patches_overlooked_q);

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
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s23_en) begin
      patches_large_q <= not_3808 & and_3813;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3818;
      patches_spoiled_q <= or_3822;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic and_4080_s24_q;
  logic or_4104_s24_q;
  logic and_4105_s24_q;
  logic and_4113_s24_q;
  logic and_4116_s24_q;
  logic and_4122_s24_q;
  logic and_4126_s24_q;
  logic and_4132_s24_q;
  logic and_4136_s24_q;
  logic and_4144_s24_q;
  logic and_4149_s24_q;
  logic and_4152_s24_q;
  logic and_4156_s24_q;
  logic [5:0] select_4158_s24_q;
  logic [31:0] select_4175_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      and_4080_s24_q <= and_4080_s23_q;
      or_4104_s24_q <= not_2363 | seen_q;
      and_4105_s24_q <= cfg_prove_i & nearer_q;
      and_4113_s24_q <= and_4113_s23_q;
      and_4116_s24_q <= and_4116_s23_q;
      and_4122_s24_q <= and_4122_s23_q;
      and_4126_s24_q <= and_4126_s23_q;
      and_4132_s24_q <= equal_577_s23_q & and_4131_s23_q;
      and_4136_s24_q <= equal_577_s23_q & and_4135_s23_q;
      and_4144_s24_q <= equal_577_s23_q & (equal_3916_s23_q & and_4142);
      and_4149_s24_q <= equal_577_s23_q & and_4148;
      and_4152_s24_q <= and_4152_s23_q;
      and_4156_s24_q <= and_4156_s23_q;
      select_4158_s24_q <= select_4158_s23_q;
      select_4175_s24_q <= select_4175_s23_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s24_q;
  assign pixel_1_o = pixel_1_s24_q;
  assign saturated_o = saturated_s24_q;
  assign mask_o = mask_s24_q;
  assign marks_first_o = marks_first_s24_q;
  assign marks_last_o = marks_last_s24_q;
  assign marks_seen_o = or_4104_s24_q;
  assign marks_nearer_o = and_4105_s24_q;
  assign verdict_valid_o = and_4080_s24_q;
  assign verdict_unproven_yet_o = and_4113_s24_q;
  assign verdict_untextured_o = and_4116_s24_q;
  assign verdict_disagree_o = and_4122_s24_q;
  assign verdict_moved_o = and_4126_s24_q;
  assign verdict_unsharp_left_o = and_4132_s24_q;
  assign verdict_unsharp_right_o = and_4136_s24_q;
  assign verdict_hidden_o = and_4144_s24_q;
  assign verdict_overlooked_o = and_4149_s24_q;
  assign verdict_out_of_step_o = and_4152_s24_q;
  assign frame_valid_o = and_4156_s24_q;
  assign frame_index_o = select_4158_s24_q;
  assign frame_word_o = select_4175_s24_q;
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
  assign unused_bits = ^{over[13:0], sum_3847[6:0], product_3811[4:0], sum_3782[1:0], sum_3742[1:0], product_3643[4:0], sum_2774[0], difference_2712[1:0], detail_4[1:0], detail_3[1:0], sum_2296[4:0], sum_1773[1:0], sum_1772[1:0], sum_1768[0], sum_1717[0], sum_1713[0], sum_738[4:0], cfg_width_i[3:0]};

endmodule
