// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 24 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3133 bits, pipeline 8699 bits, memories 157167 bits.
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
  logic not_2360;
  assign not_2360 = ~cfg_prove_i;
  logic [6:0] sum_2573;
  assign sum_2573 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic less_2578;
  assign less_2578 = 7'h8 < cfg_height_i[10:4];
  logic [6:0] difference_3612;
  assign difference_3612 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3805;
  assign not_3805 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3842;
  assign difference_3842 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic [5:0] sum_4083;
  assign sum_4083 = {1'b0, cfg_height_i[10:6]} + 6'h3f;
  logic [7:0] select_4084;
  assign select_4084 = (7'h4 < cfg_height_i[10:4]) ? {sum_4083, cfg_height_i[5:4]} : 8'h0;

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
  logic [3:0] select_2150;
  assign select_2150 = sample_pair_whole_q ? (sample_last_q ? 4'h0 : (select_511 + 4'h1)) : raster_at_x_q;
  logic [3:0] select_2153;
  assign select_2153 = sample_pair_whole_q ? (sample_last_q ? (select_530 + 4'h1) : select_530) : raster_at_y_q;

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
      raster_at_x_q <= select_2150;
      raster_at_y_q <= select_2153;
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
  logic [6:0] select_683;
  assign select_683 = sample_pair_first_s1_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
  logic [6:0] row;
  assign row = sample_pair_whole_s1_q ? select_683 : 7'h0;
  logic [6:0] select_2156;
  assign select_2156 = sample_pair_whole_s1_q ? (sample_last_s1_q ? 7'h0 : (select_546 + {6'h0, equal_548})) : raster_at_column_q;
  // hls/stages/census.hpp:62
  logic [6:0] select_2158;
  assign select_2158 = sample_last_s1_q ? (select_683 + {6'h0, equal_549_s1_q}) : select_683;
  // hls/stages/agreement.hpp:277
  logic select_2163;
  assign select_2163 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_522 & (~raster_final_row_q)) : or_522) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [10:0] select_2165;
  assign select_2165 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:277
  logic select_2169;
  assign select_2169 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_inside_q <= 1'b1;
    end else if (s1_en) begin
      raster_at_column_q <= select_2156;
      raster_at_row_q <= sample_pair_whole_s1_q ? select_2158 : raster_at_row_q;
      raster_at_live_q <= select_2163;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_2165 : raster_rows_left_q;
      raster_final_row_q <= select_2169;
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
  logic [6:0] select_683_s2_q;
  logic [6:0] row_s2_q;
  logic equal_1685_s2_q;
  logic [7:0] sum_2478_s2_q;
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
      select_683_s2_q <= select_683;
      row_s2_q <= row;
      equal_1685_s2_q <= {or_522, select_530_s1_q} == 5'h18;
      sum_2478_s2_q <= {1'b0, last} + 8'h1;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:464
  logic equal_2479;
  assign equal_2479 = {sum_2478_s2_q[7], cfg_width_i[10:4]} == {1'b0, sum_2478_s2_q[6:0]};
  // hls/stages/agreement.hpp:484
  logic [7:0] sum_2569;
  assign sum_2569 = {1'b0, row_s2_q} + 8'h1;
  // hls/stages/patches.hpp:375
  logic [7:0] sum_3026;
  assign sum_3026 = {1'b0, select_683_s2_q} + 8'h1;

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
  logic equal_1685_s3_q;
  logic equal_2479_s3_q;
  logic and_2480_s3_q;
  logic equal_2570_s3_q;
  logic not_3028_s3_q;
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
      equal_1685_s3_q <= equal_1685_s2_q;
      equal_2479_s3_q <= equal_2479;
      and_2480_s3_q <= and_552_s2_q & equal_2479;
      equal_2570_s3_q <= {sum_2569[7], cfg_height_i[10:4]} == {1'b0, sum_2569[6:0]};
      not_3028_s3_q <= ~({sum_3026, select_530_s2_q, 1'b0} < {2'h0, cfg_height_i});
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
  logic select_2483;
  assign select_2483 = (and_2480_s3_q | (~ends_cell_q)) ? and_2480_s3_q : ends_q;
  // hls/stages/agreement.hpp:539
  logic [2:0] now;
  assign now = select_2483 ? (and_2480_s3_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:544
  logic [5:0] select_2487;
  assign select_2487 = select_2483 ? (and_2480_s3_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2490;
  assign select_2490 = select_2483 ? (following_last_shift_q & (~and_2480_s3_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:545
  logic [7:0] select_2492;
  assign select_2492 = select_2483 ? (and_2480_s3_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:617
  logic and_2493;
  assign and_2493 = run_last_shift_q & equal_596;
  // hls/stages/agreement.hpp:626
  logic select_2495;
  assign select_2495 = equal_596 ? (~run_last_shift_q) : equal_597;
  // hls/stages/agreement.hpp:630
  logic equal_2496;
  assign equal_2496 = run_phase_q == 3'h1;
  logic not_2499;
  assign not_2499 = ~select_2495;
  // hls/stages/agreement.hpp:633
  logic equal_2501;
  assign equal_2501 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:617
  logic and_2502;
  assign and_2502 = final_row_q & so;
  // hls/stages/agreement.hpp:630
  logic [1:0] select_2503;
  assign select_2503 = equal_2501 ? 2'h1 : {2{and_2502}};
  logic [2:0] select_2505;
  assign select_2505 = (and_2493 | (select_2495 | equal_2496)) ? (equal_2496 ? 3'h2 : {not_2499, {2{select_2495}}}) : (equal_581 ? 3'h6 : {select_2503[0], select_2503});
  // hls/stages/agreement.hpp:617
  logic and_2508;
  assign and_2508 = select_2495 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:640
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2511;
  assign select_2511 = (plan_shift_q[5] & select_2495) ? value : 7'h0;
  logic [1:0] or_2512;
  assign or_2512 = {2{so}} | select_2511[5:4];
  // hls/stages/agreement.hpp:643
  logic [7:0] or_2516;
  assign or_2516 = (select_2495 ? plan_columns_q : 8'h0) | ((equal_2496 | equal_2501) ? whole_q : 8'h0);
  logic [1:0] or_2517;
  assign or_2517 = {2{and_2493}} | or_2516[4:3];
  // hls/stages/agreement.hpp:644
  logic [7:0] or_2519;
  assign or_2519 = {or_2516[7:5], or_2517, or_2516[2:0]} | (equal_581 ? drawn_q : 8'h0);
  logic [4:0] or_2520;
  assign or_2520 = {5{so}} | {or_2519[6], or_2519[3:0]};
  // hls/stages/agreement.hpp:650
  logic not_2524;
  assign not_2524 = ~run_shift_q[5];
  logic [7:0] select_2527;
  assign select_2527 = equal_596 ? ({{7{not_2524}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:533
  logic [6:0] select_2531;
  assign select_2531 = and_2480_s3_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:536
  logic [7:0] select_2533;
  assign select_2533 = select_2483 ? {select_2531[6], select_2531} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2536;
  assign select_2536 = select_2483 ? (and_2480_s3_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:465
  logic [6:0] select_2543;
  assign select_2543 = equal_2479_s3_q ? ((6'he < last_s3_q[6:1]) ? 7'h1d : last_s3_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [4:0] sum_2545;
  assign sum_2545 = {1'b0, last_s3_q[6:3]} + 5'h3;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_2547;
  assign select_2547 = and_552_s3_q ? (equal_2479_s3_q ? {sum_2545, last_s3_q[2:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [5:0] sum_2548;
  assign sum_2548 = {1'b0, last_s3_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_2550;
  assign select_2550 = and_552_s3_q ? (equal_2479_s3_q ? {sum_2548, last_s3_q[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:541
  logic select_2564;
  assign select_2564 = (ends_cell_q | select_2483) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_596 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:536
  logic and_2568;
  assign and_2568 = (~select_2483) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:530
  logic select_2572;
  assign select_2572 = and_552_s3_q ? (equal_2479_s3_q ? equal_2570_s3_q : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2963;
  assign select_2963 = row_starts_s3_q ? (sample_pair_first_s3_q ? phase : patches_phase_q) : patches_phase_q;

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
      run_shift_q <= select_2487;
      run_last_shift_q <= select_2490;
      run_span_q <= select_2492;
      following_phase_q <= select_2505;
      following_shift_q <= select_2495 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2508;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2511[6], or_2512, select_2511[3:0]};
      following_columns_q <= {or_2519[7], or_2520[4], or_2519[5:4], or_2520[3:0]};
      plan_shift_q <= equal_596 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2527;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2533;
      columns_left_q <= select_2536;
      last_q <= and_552_s3_q ? (equal_2479_s3_q ? last_s3_q : last_q) : last_q;
      least_q <= and_552_s3_q ? select_2543 : least_q;
      whole_q <= select_2547;
      drawn_q <= select_2550;
      slot_q <= select_2483 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2564;
      ends_q <= and_2568;
      final_row_q <= select_2572;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= sample_pair_whole_s3_q ? select_2963 : patches_phase_q;
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
  logic [7:0] sum_615_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1685_s4_q;
  logic equal_2479_s4_q;
  logic and_2480_s4_q;
  logic select_2483_s4_q;
  logic [3:0] phase_s4_q;
  logic not_3028_s4_q;
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
      sum_615_s4_q <= {1'b0, last_q} + 8'h3;
      row_s4_q <= row_s3_q;
      equal_1685_s4_q <= equal_1685_s3_q;
      equal_2479_s4_q <= equal_2479_s3_q;
      and_2480_s4_q <= and_2480_s3_q;
      select_2483_s4_q <= select_2483;
      phase_s4_q <= phase;
      not_3028_s4_q <= not_3028_s3_q;
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
  logic [6:0] select_2552;
  assign select_2552 = select_2483_s4_q ? 7'h0 : (ends_cell_s4_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s4_en) begin
      age_q <= select_2552;
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
  logic and_619_s5_q;
  logic [6:0] row_s5_q;
  logic equal_1569_s5_q;
  logic equal_1685_s5_q;
  logic equal_2479_s5_q;
  logic and_2480_s5_q;
  logic [3:0] phase_s5_q;
  logic equal_2983_s5_q;
  logic [3:0] select_2986_s5_q;
  logic not_3028_s5_q;
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
      and_619_s5_q <= age_q[2] & (ends_cell_s4_q & (~(sum_615_s4_q < select_584)));
      row_s5_q <= row_s4_q;
      equal_1569_s5_q <= {x[7], last_s4_q} == {1'b0, x[6:0]};
      equal_1685_s5_q <= equal_1685_s4_q;
      equal_2479_s5_q <= equal_2479_s4_q;
      and_2480_s5_q <= and_2480_s4_q;
      phase_s5_q <= phase_s4_q;
      equal_2983_s5_q <= row_s4_q == 7'h3;
      select_2986_s5_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_3028_s5_q <= not_3028_s4_q;
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
  logic and_620;
  assign and_620 = equal_596_s5_q & and_619_s5_q;
  logic select_621;
  assign select_621 = or_582 ? not_586_s5_q : and_620;
  // hls/stages/agreement.hpp:831
  logic [6:0] right;
  assign right = sum_583_s5_q + 7'h7d;
  // hls/stages/agreement.hpp:150
  logic [6:0] select_647;
  assign select_647 = or_582 ? x_s5_q[6:0] : (equal_596_s5_q ? sum_583_s5_q : x_s5_q[6:0]);
  // hls/stages/agreement.hpp:730
  logic not_653;
  assign not_653 = ~or_582;
  // hls/stages/agreement.hpp:473
  logic equal_2584;
  assign equal_2584 = row_s5_q[6:2] == 5'h0;
  // hls/stages/agreement.hpp:530
  logic and_2853;
  assign and_2853 = and_552_s5_q & (equal_2479_s5_q & equal_2584);
  // hls/stages/registration.hpp:127
  logic and_2856;
  assign and_2856 = and_2480_s5_q & (~and_2853);
  // hls/stages/patches.hpp:87
  logic [3:0] select_2987;
  assign select_2987 = equal_2983_s5_q ? select_2986_s5_q : patches_choosing_rows_to_next_q;
  logic equal_2988;
  assign equal_2988 = select_2987 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_2991;
  assign select_2991 = equal_2479_s5_q ? (equal_2988 ? 4'h2 : (select_2987 + 4'hf)) : patches_choosing_rows_to_next_q;

  // Memory left, 120 x 85, DISTANCE 24, hls/stages/agreement.hpp:1387; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
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

  // Memory right_codes, 120 x 99, DISTANCE 24, hls/stages/agreement.hpp:1388; read in stage 5, written in stage 8: 5 < 8 < 5 + DISTANCE.
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

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1389; read in stage 5, written in stage 16: 5 < 16 < 5 + DISTANCE.
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
  assign best_left_re = s5_en & select_621;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s5_en) begin
      patches_choosing_rows_to_next_q <= and_552_s5_q ? select_2991 : patches_choosing_rows_to_next_q;
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
  logic select_621_s6_q;
  logic [6:0] right_s6_q;
  logic and_656_s6_q;
  logic [6:0] row_s6_q;
  logic and_1568_s6_q;
  logic equal_1569_s6_q;
  logic equal_1685_s6_q;
  logic equal_2479_s6_q;
  logic equal_2584_s6_q;
  logic and_2854_s6_q;
  logic [15:0] select_2857_s6_q;
  logic [15:0] select_2860_s6_q;
  logic and_2863_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2983_s6_q;
  logic equal_2988_s6_q;
  logic not_3028_s6_q;
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
      select_621_s6_q <= select_621;
      right_s6_q <= right;
      and_656_s6_q <= not_653 & ((~equal_596_s5_q) & and_598_s5_q);
      row_s6_q <= row_s5_q;
      and_1568_s6_q <= not_653 & and_620;
      equal_1569_s6_q <= equal_1569_s5_q;
      equal_1685_s6_q <= equal_1685_s5_q;
      equal_2479_s6_q <= equal_2479_s5_q;
      equal_2584_s6_q <= equal_2584;
      and_2854_s6_q <= and_2480_s5_q & and_2853;
      select_2857_s6_q <= and_2856 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
      select_2860_s6_q <= and_2856 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
      and_2863_s6_q <= ends_cell_s5_q & so_s5_q;
      phase_s6_q <= phase_s5_q;
      equal_2983_s6_q <= equal_2983_s5_q;
      equal_2988_s6_q <= equal_2988;
      not_3028_s6_q <= not_3028_s5_q;
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
  logic not_1683;
  assign not_1683 = ~sample_pair_first_s6_q;
  // hls/stages/patches.hpp:315
  logic equal_1687;
  assign equal_1687 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1759;
  assign select_1759 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1996;
  assign sum_1996 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [23:0] sum_2858;
  assign sum_2858 = registration_slope_row_q + {{8{select_2857_s6_q[15]}}, select_2857_s6_q};
  // hls/stages/registration.hpp:132
  logic [23:0] select_2859;
  assign select_2859 = and_2854_s6_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : sum_2858;
  // hls/stages/registration.hpp:130
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2860_s6_q[15]}}, select_2860_s6_q};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2862;
  assign select_2862 = and_2854_s6_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2863_s6_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:377
  logic and_2965;
  assign and_2965 = not_1683 & equal_1685_s6_q;
  logic [8:0] select_2966;
  assign select_2966 = and_2965 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s6_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2967;
  assign select_2967 = and_2965 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2968;
  assign select_2968 = sample_pair_first_s6_q ? select_2966 : select_2967;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2969;
  assign select_2969 = row_starts_s6_q ? select_2968[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2970;
  assign select_2970 = sample_pair_whole_s6_q ? select_2969 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2972;
  assign select_2972 = sample_pair_whole_s6_q ? (row_starts_s6_q ? select_2968[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2975;
  assign select_2975 = sample_pair_whole_s6_q ? (equal_1687 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2977;
  assign select_2977 = sample_pair_whole_s6_q ? (patches_band_rows_number_q + {4'h0, equal_1687}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_2978;
  assign equal_2978 = phase_s6_q == 4'h0;
  // hls/stages/patches.hpp:335
  logic not_2979;
  assign not_2979 = ~equal_2978;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2981;
  assign select_2981 = sample_pair_whole_s6_q ? (phase_s6_q + {{2{not_2979}}, 1'b1, not_2979}) : patches_first_band_rows_to_next_q;
  logic select_2982;
  assign select_2982 = sample_pair_whole_s6_q ? equal_2978 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2993;
  assign select_2993 = equal_2983_s6_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_2995;
  assign select_2995 = equal_2479_s6_q ? (select_2993 + {4'h0, equal_2988_s6_q}) : patches_choosing_number_q;
  logic select_2999;
  assign select_2999 = equal_2479_s6_q ? ((7'h2 < row_s6_q) & equal_2988_s6_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:530
  logic [4:0] select_3002;
  assign select_3002 = and_552_s6_q ? (equal_2479_s6_q ? select_2993 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_3855;
  assign select_3855 = so_s6_q ? (and_2863_s6_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3857;
  assign sum_3857 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3858;
  assign select_3858 = sum_1996[5] ? {1'b1, sum_1996[4:0], region_across_rest_q[2:0]} : sum_3857;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3860;
  assign select_3860 = equal_2479_s6_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3863;
  assign select_3863 = equal_2479_s6_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1386; read in stage 6, written in stage 21: 6 < 21 < 6 + DISTANCE.
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
  assign fresh_re = s6_en & and_656_s6_q;
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
      registration_slope_row_q <= select_2859;
      registration_slope_change_q <= select_2862;
      registration_slope_q <= so_s6_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2970;
      patches_band_rows_number_q <= select_2972;
      patches_next_band_rows_to_next_q <= select_2975;
      patches_next_band_number_q <= select_2977;
      patches_first_band_rows_to_next_q <= select_2981;
      patches_first_band_number_q <= select_2982;
      patches_choosing_number_q <= and_552_s6_q ? select_2995 : patches_choosing_number_q;
      patches_chooses_q <= and_552_s6_q ? select_2999 : patches_chooses_q;
      patches_choosing_band_q <= select_3002;
      region_across_rest_q <= select_3855;
      region_across_back_q <= so_s6_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3858;
      columns_begin_rest_q <= and_552_s6_q ? select_3860 : columns_begin_rest_q;
      columns_begin_back_q <= and_552_s6_q ? select_3863 : columns_begin_back_q;
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
  logic select_621_s7_q;
  logic [61:0] best_left_rdata_s7_q;
  logic [6:0] right_s7_q;
  logic [98:0] right_codes_rdata_s7_q;
  logic and_656_s7_q;
  logic [6:0] row_s7_q;
  logic and_1568_s7_q;
  logic equal_1569_s7_q;
  logic not_1683_s7_q;
  logic or_1689_s7_q;
  logic [16:0] select_1759_s7_q;
  logic sum_1996_s7_q;
  logic equal_2479_s7_q;
  logic equal_2584_s7_q;
  logic not_3028_s7_q;
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
      select_621_s7_q <= select_621_s6_q;
      best_left_rdata_s7_q <= best_left_rdata_q;
      right_s7_q <= right_s6_q;
      right_codes_rdata_s7_q <= right_codes_rdata_q;
      and_656_s7_q <= and_656_s6_q;
      row_s7_q <= row_s6_q;
      and_1568_s7_q <= and_1568_s6_q;
      equal_1569_s7_q <= equal_1569_s6_q;
      not_1683_s7_q <= not_1683;
      or_1689_s7_q <= (~equal_1685_s6_q) | (~equal_1687);
      select_1759_s7_q <= select_1759;
      sum_1996_s7_q <= sum_1996[5];
      equal_2479_s7_q <= equal_2479_s6_q;
      equal_2584_s7_q <= equal_2584_s6_q;
      not_3028_s7_q <= not_3028_s6_q;
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
  logic and_611;
  assign and_611 = (or_582_s7_q & (left_rdata_s7_q[67] & not_586_s7_q)) & (late_q | (~(row_q[6:3] == 4'h0)));
  // hls/stages/agreement.hpp:976
  logic [5:0] shift;
  assign shift = slot_s7_q[2] ? best_left_rdata_s7_q[5:0] : best_left_rdata_s7_q[45:40];
  // hls/stages/agreement.hpp:679
  logic or_754;
  assign or_754 = late_q | (~equal_571);
  // hls/stages/agreement.hpp:222
  logic and_769;
  assign and_769 = left_rdata_s7_q[48] & not_586_s7_q;
  logic and_770;
  assign and_770 = right_codes_rdata_s7_q[42] & not_586_s7_q;
  logic [11:0] select_771;
  assign select_771 = less_585_s7_q ? 12'h0 : left_rdata_s7_q[47:36];
  logic [11:0] select_772;
  assign select_772 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[41:30];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_776;
  assign select_776 = and_769 ? (and_770 ? (~(select_771 ^ select_772)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_792;
  assign and_792 = left_rdata_s7_q[66] & not_586_s7_q;
  logic and_793;
  assign and_793 = right_codes_rdata_s7_q[57] & not_586_s7_q;
  logic [11:0] select_794;
  assign select_794 = less_585_s7_q ? 12'h0 : left_rdata_s7_q[65:54];
  logic [11:0] select_795;
  assign select_795 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[56:45];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_799;
  assign select_799 = and_792 ? (and_793 ? (~(select_794 ^ select_795)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_809;
  assign and_809 = left_rdata_s7_q[84] & not_586_s7_q;
  logic and_810;
  assign and_810 = right_codes_rdata_s7_q[72] & not_586_s7_q;
  logic [11:0] select_811;
  assign select_811 = less_585_s7_q ? 12'h0 : left_rdata_s7_q[83:72];
  logic [11:0] select_812;
  assign select_812 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[71:60];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_816;
  assign select_816 = and_809 ? (and_810 ? (~(select_811 ^ select_812)) : 12'h0) : 12'h0;
  logic [11:0] select_1024;
  assign select_1024 = (slot_s7_q[0] ? and_810 : and_793) ? (~(select_771 ^ (slot_s7_q[0] ? select_812 : select_795))) : 12'h0;
  // hls/stages/agreement.hpp:222
  logic and_1041;
  assign and_1041 = right_codes_rdata_s7_q[85] & not_586_s7_q;
  logic [11:0] select_1043;
  assign select_1043 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[84:73];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1047;
  assign select_1047 = (slot_s7_q[0] ? and_1041 : and_810) ? (~(select_794 ^ (slot_s7_q[0] ? select_1043 : select_812))) : 12'h0;
  // hls/stages/agreement.hpp:744
  logic select_1059;
  assign select_1059 = slot_s7_q[0] ? (right_codes_rdata_s7_q[98] & not_586_s7_q) : and_1041;
  logic [11:0] select_1061;
  assign select_1061 = slot_s7_q[0] ? (less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[97:86]) : select_1043;
  // hls/stages/agreement.hpp:222
  logic and_1270;
  assign and_1270 = right_codes_rdata_s7_q[27] & not_586_s7_q;
  // hls/stages/agreement.hpp:744
  logic select_1271;
  assign select_1271 = slot_s7_q[0] ? (right_codes_rdata_s7_q[12] & not_586_s7_q) : and_1270;
  // hls/stages/agreement.hpp:222
  logic [11:0] select_1273;
  assign select_1273 = less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[26:15];
  // hls/stages/agreement.hpp:744
  logic [11:0] select_1274;
  assign select_1274 = slot_s7_q[0] ? (less_585_s7_q ? 12'h0 : right_codes_rdata_s7_q[11:0]) : select_1273;
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1298;
  assign select_1298 = (slot_s7_q[0] ? and_1270 : and_770) ? (~(select_794 ^ (slot_s7_q[0] ? select_1273 : select_772))) : 12'h0;
  logic [11:0] select_1313;
  assign select_1313 = (slot_s7_q[0] ? and_770 : and_793) ? (~(select_811 ^ (slot_s7_q[0] ? select_772 : select_795))) : 12'h0;
  // hls/stages/patches.hpp:396
  logic not_1680;
  assign not_1680 = ~patches_begins_q;
  // hls/stages/patches.hpp:366
  logic and_1684;
  assign and_1684 = patches_capturing_q & not_1683_s7_q;
  // hls/stages/patches.hpp:125
  logic and_1692;
  assign and_1692 = (not_1680 & (patches_work_q == 3'h0)) & (~(and_1684 | or_1689_s7_q));
  // hls/stages/agreement.hpp:150
  logic [5:0] b;
  assign b = or_582_s7_q ? (less_585_s7_q ? 6'h0 : best_left_rdata_s7_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1761;
  assign select_1761 = ($signed(10'h0) < $signed(select_1759_s7_q[16:7])) ? 14'h7f : select_1759_s7_q[13:0];
  // hls/stages/patches.hpp:537
  logic equal_1791;
  assign equal_1791 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:509
  logic equal_1793;
  assign equal_1793 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:503
  logic equal_1795;
  assign equal_1795 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1796;
  assign equal_1796 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_1797;
  assign or_1797 = equal_1795 | equal_1796;
  // hls/stages/patches.hpp:464
  logic not_1798;
  assign not_1798 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_1820;
  assign select_1820 = and_1692 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1821;
  assign select_1821 = row_starts_s7_q ? select_1820 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1823;
  assign and_1823 = and_1684 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1827;
  assign select_1827 = row_starts_s7_q ? (and_1692 | (and_1684 & (~and_1823))) : patches_capturing_q;
  // hls/stages/patches.hpp:168
  logic not_1851;
  assign not_1851 = ~equal_1796;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_1865;
  assign select_1865 = row_starts_s7_q ? {select_1820[4], select_1820[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/agreement.hpp:1286
  logic not_2058;
  assign not_2058 = ~marks_first_s7_q;
  // hls/stages/agreement.hpp:472
  logic and_2579;
  assign and_2579 = proven_q & less_2578;
  // hls/stages/agreement.hpp:530
  logic select_2583;
  assign select_2583 = and_552_s7_q ? (equal_2479_s7_q ? (and_2579 & (row_s7_q[6:1] == 6'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:474
  logic and_2585;
  assign and_2585 = and_2579 & equal_2584_s7_q;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2754;
  assign select_2754 = or_582_s7_q ? (less_585_s7_q ? 8'h0 : best_left_rdata_s7_q[32:25]) : 8'h0;
  logic [7:0] select_2756;
  assign select_2756 = or_582_s7_q ? (less_585_s7_q ? 8'h0 : best_left_rdata_s7_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:397
  logic or_3069;
  assign or_3069 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3074;
  assign select_3074 = (patches_second_q | patches_begins_q) ? not_1680 : (patches_ends_q & equal_1791);
  logic and_3075;
  assign and_3075 = equal_1791 & not_1798;
  // hls/stages/patches.hpp:403
  logic and_3076;
  assign and_3076 = not_1851 & and_3075;
  logic [1:0] select_3078;
  assign select_3078 = equal_1793 ? 2'h0 : (equal_1795 ? 2'h3 : {equal_1796, and_3076});
  // hls/stages/patches.hpp:283
  logic equal_3080;
  assign equal_3080 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3081;
  assign not_3081 = ~equal_3080;
  // hls/stages/patches.hpp:283
  logic equal_3082;
  assign equal_3082 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3083;
  assign not_3083 = ~equal_3082;
  // hls/stages/patches.hpp:287
  logic not_3085;
  assign not_3085 = ~(patches_following_q == 3'h2);
  logic and_3088;
  assign and_3088 = (~(patches_following_q == 3'h1)) & not_3085;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3089;
  assign select_3089 = equal_3082 ? 2'h2 : {and_3088, not_3085};
  logic [3:0] select_3090;
  assign select_3090 = equal_3080 ? 4'h2 : {select_3089, {2{not_3083}}};
  // hls/stages/patches.hpp:409
  logic not_3093;
  assign not_3093 = ~or_3069;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3098;
  assign select_3098 = or_3069 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/agreement.hpp:1159
  logic equal_3913;
  assign equal_3913 = x_s7_q[6:0] == 7'h7f;

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
      row_q <= and_552_s7_q ? (equal_2479_s7_q ? row_s7_q : row_q) : row_q;
      late_q <= select_2583;
      patches_capturing_q <= sample_pair_whole_s7_q ? select_1827 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s7_q ? select_1821 : patches_row_q;
      patches_work_q <= or_3069 ? following : patches_work_q;
      patches_second_q <= select_3074;
      patches_following_q <= equal_1791 ? {2'h0, and_3075} : {equal_1793, select_3078};
      patches_following_beats_q <= {select_3090, not_3081};
      patches_begins_q <= sample_pair_whole_s7_q & (row_starts_s7_q & and_1823);
      patches_ends_q <= not_3093 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3098;
      done_q <= not_2058 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s7_q ? done_q : proven_q;
      drew_q <= so_s7_q;
      said_q <= equal_577_s7_q & equal_3913;
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
  logic and_603_s8_q;
  logic and_612_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_621_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic [5:0] shift_s8_q;
  logic [6:0] right_s8_q;
  logic not_641_s8_q;
  logic and_645_s8_q;
  logic [77:0] right_codes_rdata_s8_q;
  logic and_650_s8_q;
  logic and_652_s8_q;
  logic and_656_s8_q;
  logic [32:0] fresh_rdata_s8_q;
  logic equal_685_s8_q;
  logic and_755_s8_q;
  logic and_756_s8_q;
  logic and_757_s8_q;
  logic and_758_s8_q;
  logic and_759_s8_q;
  logic and_760_s8_q;
  logic and_761_s8_q;
  logic and_762_s8_q;
  logic and_763_s8_q;
  logic and_764_s8_q;
  logic and_769_s8_q;
  logic [11:0] select_776_s8_q;
  logic and_792_s8_q;
  logic [11:0] select_799_s8_q;
  logic and_809_s8_q;
  logic [11:0] select_816_s8_q;
  logic [11:0] select_1024_s8_q;
  logic [11:0] select_1047_s8_q;
  logic [11:0] select_1064_s8_q;
  logic [11:0] select_1277_s8_q;
  logic [11:0] select_1298_s8_q;
  logic [11:0] select_1313_s8_q;
  logic and_1568_s8_q;
  logic equal_1569_s8_q;
  logic and_1692_s8_q;
  logic less_1706_s8_q;
  logic [5:0] b_s8_q;
  logic [13:0] select_1761_s8_q;
  logic equal_1791_s8_q;
  logic equal_1793_s8_q;
  logic equal_1795_s8_q;
  logic equal_1796_s8_q;
  logic or_1797_s8_q;
  logic not_1798_s8_q;
  logic and_1800_s8_q;
  logic [4:0] select_1821_s8_q;
  logic select_1827_s8_q;
  logic and_1833_s8_q;
  logic and_1852_s8_q;
  logic [3:0] select_1865_s8_q;
  logic sum_1996_s8_q;
  logic and_2018_s8_q;
  logic not_2058_s8_q;
  logic less_2136_s8_q;
  logic equal_2290_s8_q;
  logic equal_2479_s8_q;
  logic not_2575_s8_q;
  logic and_2585_s8_q;
  logic and_2615_s8_q;
  logic [7:0] select_2754_s8_q;
  logic [7:0] select_2756_s8_q;
  logic not_3028_s8_q;
  logic or_3069_s8_q;
  logic not_3093_s8_q;
  logic less_3841_s8_q;
  logic equal_3913_s8_q;
  logic or_4063_s8_q;
  logic not_4106_s8_q;
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
      and_603_s8_q <= or_582_s7_q & (left_rdata_s7_q[70] & not_586_s7_q);
      and_612_s8_q <= (or_582_s7_q & (left_rdata_s7_q[68] & not_586_s7_q)) & and_611;
      x_s8_2_q <= x_s7_2_q;
      select_621_s8_q <= select_621_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_s7_q;
      shift_s8_q <= shift;
      right_s8_q <= right_s7_q;
      not_641_s8_q <= ~late_q;
      and_645_s8_q <= or_582_s7_q & (left_rdata_s7_q[71] & not_586_s7_q);
      right_codes_rdata_s8_q <= {right_codes_rdata_s7_q[84:73], right_codes_rdata_s7_q[71:60], right_codes_rdata_s7_q[56:43], right_codes_rdata_s7_q[41:28], right_codes_rdata_s7_q[26:13], right_codes_rdata_s7_q[11:0]};
      and_650_s8_q <= or_582_s7_q & (right_codes_rdata_s7_q[58] & not_586_s7_q);
      and_652_s8_q <= or_582_s7_q & (right_codes_rdata_s7_q[59] & not_586_s7_q);
      and_656_s8_q <= and_656_s7_q;
      fresh_rdata_s8_q <= fresh_rdata_q;
      equal_685_s8_q <= row_s7_q == 7'h0;
      and_755_s8_q <= left_rdata_s7_q[12] & or_754;
      and_756_s8_q <= left_rdata_s7_q[30] & or_754;
      and_757_s8_q <= left_rdata_s7_q[48] & or_754;
      and_758_s8_q <= left_rdata_s7_q[66] & or_754;
      and_759_s8_q <= right_codes_rdata_s7_q[12] & or_754;
      and_760_s8_q <= right_codes_rdata_s7_q[27] & or_754;
      and_761_s8_q <= right_codes_rdata_s7_q[42] & or_754;
      and_762_s8_q <= right_codes_rdata_s7_q[57] & or_754;
      and_763_s8_q <= right_codes_rdata_s7_q[72] & or_754;
      and_764_s8_q <= right_codes_rdata_s7_q[85] & or_754;
      and_769_s8_q <= and_769;
      select_776_s8_q <= select_776;
      and_792_s8_q <= and_792;
      select_799_s8_q <= select_799;
      and_809_s8_q <= and_809;
      select_816_s8_q <= select_816;
      select_1024_s8_q <= select_1024;
      select_1047_s8_q <= select_1047;
      select_1064_s8_q <= select_1059 ? (~(select_811 ^ select_1061)) : 12'h0;
      select_1277_s8_q <= select_1271 ? (~(select_771 ^ select_1274)) : 12'h0;
      select_1298_s8_q <= select_1298;
      select_1313_s8_q <= select_1313;
      and_1568_s8_q <= and_1568_s7_q;
      equal_1569_s8_q <= equal_1569_s7_q;
      and_1692_s8_q <= and_1692;
      less_1706_s8_q <= 6'h4 < row_q[6:1];
      b_s8_q <= b;
      select_1761_s8_q <= select_1761;
      equal_1791_s8_q <= equal_1791;
      equal_1793_s8_q <= equal_1793;
      equal_1795_s8_q <= equal_1795;
      equal_1796_s8_q <= equal_1796;
      or_1797_s8_q <= or_1797;
      not_1798_s8_q <= not_1798;
      and_1800_s8_q <= or_1797 & (equal_1796 & not_1798);
      select_1821_s8_q <= select_1821;
      select_1827_s8_q <= select_1827;
      and_1833_s8_q <= or_1797 & (patches_second_q & equal_1796);
      and_1852_s8_q <= not_1851 & or_1797;
      select_1865_s8_q <= select_1865;
      sum_1996_s8_q <= sum_1996_s7_q;
      and_2018_s8_q <= or_582_s7_q & (left_rdata_s7_q[69] & not_586_s7_q);
      not_2058_s8_q <= not_2058;
      less_2136_s8_q <= 7'h6 < row_q;
      equal_2290_s8_q <= (last_s7_2_q | row_s7_q) == 7'h0;
      equal_2479_s8_q <= equal_2479_s7_q;
      not_2575_s8_q <= ~({row_s7_q, 1'b0} < {sum_2573, cfg_height_i[4]});
      and_2585_s8_q <= and_2585;
      and_2615_s8_q <= not_586_s7_q & and_611;
      select_2754_s8_q <= select_2754;
      select_2756_s8_q <= select_2756;
      not_3028_s8_q <= not_3028_s7_q;
      or_3069_s8_q <= or_3069;
      not_3093_s8_q <= not_3093;
      less_3841_s8_q <= 6'h2 < row_s7_q[6:1];
      equal_3913_s8_q <= equal_3913;
      or_4063_s8_q <= and_2585 | (~(row_s7_q[6:3] == 4'h0));
      not_4106_s8_q <= ~proven_q;
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
  logic parity_782;
  assign parity_782 = ^select_776_s8_q[5:3];
  logic parity_785;
  assign parity_785 = ^select_776_s8_q[8:6];
  logic parity_788;
  assign parity_788 = ^select_776_s8_q[11:3];
  logic parity_802;
  assign parity_802 = ^select_799_s8_q[8:6];
  logic parity_805;
  assign parity_805 = ^select_799_s8_q[11:9];
  logic parity_822;
  assign parity_822 = ^select_816_s8_q[2:0];
  logic parity_825;
  assign parity_825 = ^select_816_s8_q[5:3];
  logic parity_828;
  assign parity_828 = ^select_816_s8_q[8:0];
  logic parity_834;
  assign parity_834 = ^select_816_s8_q[11:9];
  logic parity_837;
  assign parity_837 = ^select_799_s8_q[2:0];
  logic parity_840;
  assign parity_840 = ^{select_816_s8_q[11:9], select_799_s8_q[5:0]};
  logic parity_843;
  assign parity_843 = ^{select_816_s8_q, select_799_s8_q, select_776_s8_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_848;
  assign or_848 = (select_776_s8_q[1:0] == 2'h3) | (select_776_s8_q[2] & (select_776_s8_q[0] | select_776_s8_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_852;
  assign or_852 = (select_799_s8_q[7:6] == 2'h3) | (select_799_s8_q[8] & (select_799_s8_q[6] | select_799_s8_q[7]));
  logic or_856;
  assign or_856 = (select_799_s8_q[10:9] == 2'h3) | (select_799_s8_q[11] & (select_799_s8_q[9] | select_799_s8_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_864;
  assign or_864 = (select_816_s8_q[7:6] == 2'h3) | (select_816_s8_q[8] & (~(select_816_s8_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_868;
  assign or_868 = (select_816_s8_q[1:0] == 2'h3) | (select_816_s8_q[2] & (select_816_s8_q[0] | select_816_s8_q[1]));
  logic or_872;
  assign or_872 = (select_816_s8_q[4:3] == 2'h3) | (select_816_s8_q[5] & (select_816_s8_q[3] | select_816_s8_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_875;
  assign parity_875 = ^{or_872, or_868, or_864};
  // hls/stages/count_bits.hpp:23
  logic or_879;
  assign or_879 = (select_799_s8_q[4:3] == 2'h3) | (select_799_s8_q[5] & (select_799_s8_q[3] | select_799_s8_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_883;
  assign or_883 = (select_816_s8_q[10:9] == 2'h3) | (select_816_s8_q[11] & (select_816_s8_q[9] | select_816_s8_q[10]));
  logic or_887;
  assign or_887 = (select_799_s8_q[1:0] == 2'h3) | (select_799_s8_q[2] & (select_799_s8_q[0] | select_799_s8_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_890;
  assign parity_890 = ^{or_887, or_883, or_879};
  logic parity_893;
  assign parity_893 = ^{or_887, or_883, or_879, or_872, or_868, or_864, or_856, or_852, or_848};
  // hls/stages/count_bits.hpp:25
  logic or_898;
  assign or_898 = (parity_782 & parity_785) | ((^select_776_s8_q[11:9]) & (parity_782 | parity_785));
  logic and_901;
  assign and_901 = (^{select_799_s8_q[11:6], select_776_s8_q[2:0]}) & (parity_828 | parity_840);
  // hls/stages/count_bits.hpp:23
  logic or_909;
  assign or_909 = (select_776_s8_q[10:9] == 2'h3) | (select_776_s8_q[11] & (select_776_s8_q[9] | select_776_s8_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_913;
  assign or_913 = (select_776_s8_q[4:3] == 2'h3) | (select_776_s8_q[5] & (select_776_s8_q[3] | select_776_s8_q[4]));
  logic or_917;
  assign or_917 = (select_776_s8_q[7:6] == 2'h3) | (select_776_s8_q[8] & (select_776_s8_q[6] | select_776_s8_q[7]));
  logic or_924;
  assign or_924 = (parity_802 & parity_805) | ((^select_776_s8_q[2:0]) & (parity_802 | parity_805));
  logic or_928;
  assign or_928 = (parity_822 & parity_825) | ((^select_816_s8_q[8:6]) & (parity_822 | parity_825));
  logic or_932;
  assign or_932 = (parity_834 & parity_837) | ((^select_799_s8_q[5:3]) & (parity_834 | parity_837));
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1025;
  assign select_1025 = and_769_s8_q ? select_1024_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1031;
  assign parity_1031 = ^select_1025[5:3];
  logic parity_1034;
  assign parity_1034 = ^select_1025[8:6];
  logic parity_1037;
  assign parity_1037 = ^select_1025[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1048;
  assign select_1048 = and_792_s8_q ? select_1047_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1051;
  assign parity_1051 = ^select_1048[8:6];
  logic parity_1054;
  assign parity_1054 = ^select_1048[11:9];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1065;
  assign select_1065 = and_809_s8_q ? select_1064_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1071;
  assign parity_1071 = ^select_1065[2:0];
  logic parity_1074;
  assign parity_1074 = ^select_1065[5:3];
  logic parity_1077;
  assign parity_1077 = ^select_1065[8:0];
  logic parity_1083;
  assign parity_1083 = ^select_1065[11:9];
  logic parity_1086;
  assign parity_1086 = ^select_1048[2:0];
  logic parity_1089;
  assign parity_1089 = ^{select_1065[11:9], select_1048[5:0]};
  logic parity_1092;
  assign parity_1092 = ^{select_1065, select_1048, select_1025[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1097;
  assign or_1097 = (select_1025[1:0] == 2'h3) | (select_1025[2] & (select_1025[0] | select_1025[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1101;
  assign or_1101 = (select_1048[7:6] == 2'h3) | (select_1048[8] & (select_1048[6] | select_1048[7]));
  logic or_1105;
  assign or_1105 = (select_1048[10:9] == 2'h3) | (select_1048[11] & (select_1048[9] | select_1048[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1113;
  assign or_1113 = (select_1065[7:6] == 2'h3) | (select_1065[8] & (~(select_1065[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1117;
  assign or_1117 = (select_1065[1:0] == 2'h3) | (select_1065[2] & (select_1065[0] | select_1065[1]));
  logic or_1121;
  assign or_1121 = (select_1065[4:3] == 2'h3) | (select_1065[5] & (select_1065[3] | select_1065[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1124;
  assign parity_1124 = ^{or_1121, or_1117, or_1113};
  // hls/stages/count_bits.hpp:23
  logic or_1128;
  assign or_1128 = (select_1048[4:3] == 2'h3) | (select_1048[5] & (select_1048[3] | select_1048[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1132;
  assign or_1132 = (select_1065[10:9] == 2'h3) | (select_1065[11] & (select_1065[9] | select_1065[10]));
  logic or_1136;
  assign or_1136 = (select_1048[1:0] == 2'h3) | (select_1048[2] & (select_1048[0] | select_1048[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1139;
  assign parity_1139 = ^{or_1136, or_1132, or_1128};
  logic parity_1142;
  assign parity_1142 = ^{or_1136, or_1132, or_1128, or_1121, or_1117, or_1113, or_1105, or_1101, or_1097};
  // hls/stages/count_bits.hpp:25
  logic or_1147;
  assign or_1147 = (parity_1031 & parity_1034) | ((^select_1025[11:9]) & (parity_1031 | parity_1034));
  logic and_1150;
  assign and_1150 = (^{select_1048[11:6], select_1025[2:0]}) & (parity_1077 | parity_1089);
  // hls/stages/count_bits.hpp:23
  logic or_1158;
  assign or_1158 = (select_1025[10:9] == 2'h3) | (select_1025[11] & (select_1025[9] | select_1025[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1162;
  assign or_1162 = (select_1025[4:3] == 2'h3) | (select_1025[5] & (select_1025[3] | select_1025[4]));
  logic or_1166;
  assign or_1166 = (select_1025[7:6] == 2'h3) | (select_1025[8] & (select_1025[6] | select_1025[7]));
  logic or_1173;
  assign or_1173 = (parity_1051 & parity_1054) | ((^select_1025[2:0]) & (parity_1051 | parity_1054));
  logic or_1177;
  assign or_1177 = (parity_1071 & parity_1074) | ((^select_1065[8:6]) & (parity_1071 | parity_1074));
  logic or_1181;
  assign or_1181 = (parity_1083 & parity_1086) | ((^select_1048[5:3]) & (parity_1083 | parity_1086));
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1278;
  assign select_1278 = and_769_s8_q ? select_1277_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1284;
  assign parity_1284 = ^select_1278[5:3];
  logic parity_1287;
  assign parity_1287 = ^select_1278[8:6];
  logic parity_1290;
  assign parity_1290 = ^select_1278[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1299;
  assign select_1299 = and_792_s8_q ? select_1298_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1302;
  assign parity_1302 = ^select_1299[8:6];
  logic parity_1305;
  assign parity_1305 = ^select_1299[11:9];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1314;
  assign select_1314 = and_809_s8_q ? select_1313_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1320;
  assign parity_1320 = ^select_1314[2:0];
  logic parity_1323;
  assign parity_1323 = ^select_1314[5:3];
  logic parity_1326;
  assign parity_1326 = ^select_1314[8:0];
  logic parity_1332;
  assign parity_1332 = ^select_1314[11:9];
  logic parity_1335;
  assign parity_1335 = ^select_1299[2:0];
  logic parity_1338;
  assign parity_1338 = ^{select_1314[11:9], select_1299[5:0]};
  logic parity_1341;
  assign parity_1341 = ^{select_1314, select_1299, select_1278[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1346;
  assign or_1346 = (select_1278[1:0] == 2'h3) | (select_1278[2] & (select_1278[0] | select_1278[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1350;
  assign or_1350 = (select_1299[7:6] == 2'h3) | (select_1299[8] & (select_1299[6] | select_1299[7]));
  logic or_1354;
  assign or_1354 = (select_1299[10:9] == 2'h3) | (select_1299[11] & (select_1299[9] | select_1299[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1362;
  assign or_1362 = (select_1314[7:6] == 2'h3) | (select_1314[8] & (~(select_1314[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1366;
  assign or_1366 = (select_1314[1:0] == 2'h3) | (select_1314[2] & (select_1314[0] | select_1314[1]));
  logic or_1370;
  assign or_1370 = (select_1314[4:3] == 2'h3) | (select_1314[5] & (select_1314[3] | select_1314[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1373;
  assign parity_1373 = ^{or_1370, or_1366, or_1362};
  // hls/stages/count_bits.hpp:23
  logic or_1377;
  assign or_1377 = (select_1299[4:3] == 2'h3) | (select_1299[5] & (select_1299[3] | select_1299[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1381;
  assign or_1381 = (select_1314[10:9] == 2'h3) | (select_1314[11] & (select_1314[9] | select_1314[10]));
  logic or_1385;
  assign or_1385 = (select_1299[1:0] == 2'h3) | (select_1299[2] & (select_1299[0] | select_1299[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1388;
  assign parity_1388 = ^{or_1385, or_1381, or_1377};
  logic parity_1391;
  assign parity_1391 = ^{or_1385, or_1381, or_1377, or_1370, or_1366, or_1362, or_1354, or_1350, or_1346};
  // hls/stages/count_bits.hpp:25
  logic or_1396;
  assign or_1396 = (parity_1284 & parity_1287) | ((^select_1278[11:9]) & (parity_1284 | parity_1287));
  logic and_1399;
  assign and_1399 = (^{select_1299[11:6], select_1278[2:0]}) & (parity_1326 | parity_1338);
  // hls/stages/count_bits.hpp:23
  logic or_1407;
  assign or_1407 = (select_1278[10:9] == 2'h3) | (select_1278[11] & (select_1278[9] | select_1278[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1411;
  assign or_1411 = (select_1278[4:3] == 2'h3) | (select_1278[5] & (select_1278[3] | select_1278[4]));
  logic or_1415;
  assign or_1415 = (select_1278[7:6] == 2'h3) | (select_1278[8] & (select_1278[6] | select_1278[7]));
  logic or_1422;
  assign or_1422 = (parity_1302 & parity_1305) | ((^select_1278[2:0]) & (parity_1302 | parity_1305));
  logic or_1426;
  assign or_1426 = (parity_1320 & parity_1323) | ((^select_1314[8:6]) & (parity_1320 | parity_1323));
  logic or_1430;
  assign or_1430 = (parity_1332 & parity_1335) | ((^select_1299[5:3]) & (parity_1332 | parity_1335));
  // hls/stages/agreement.hpp:248
  logic or_1589;
  assign or_1589 = (cfg_nearer_below_i & shift_s8_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s8_q)));
  // hls/stages/registration.hpp:213
  logic [9:0] select_1762;
  assign select_1762 = b_s8_q[4] ? select_1761_s8_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1767;
  assign sum_1767 = (b_s8_q[0] ? select_1761_s8_q[13:1] : 13'h0) + (b_s8_q[1] ? select_1761_s8_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1768;
  assign select_1768 = b_s8_q[2] ? select_1761_s8_q[11:0] : 12'h0;
  // hls/stages/patches.hpp:516
  logic not_1792;
  assign not_1792 = ~equal_1791_s8_q;
  // hls/stages/patches.hpp:462
  logic not_1794;
  assign not_1794 = ~equal_1793_s8_q;
  logic and_1875;
  assign and_1875 = not_1792 & (or_1797_s8_q & not_1794);
  // hls/stages/patches.hpp:549
  logic less_1969;
  assign less_1969 = patches_step_q[4:0] < 5'h11;
  logic equal_1970;
  assign equal_1970 = patches_step_q[6:5] == 2'h2;
  logic equal_1971;
  assign equal_1971 = patches_step_q[6:5] == 2'h1;
  logic or_1972;
  assign or_1972 = equal_1970 | equal_1971;
  // hls/stages/agreement.hpp:530
  logic select_2577;
  assign select_2577 = and_552_s8_q ? (equal_2479_s8_q ? not_2575_s8_q : lower_half_q) : lower_half_q;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2752;
  assign select_2752 = or_582_s8_q ? (less_585_s8_q ? 8'h0 : best_left_rdata_s8_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2754_s8_q} - {1'b0, select_2756_s8_q};
  // hls/stages/patches.hpp:126
  logic select_3030;
  assign select_3030 = row_starts_s8_q ? (and_1692_s8_q ? not_3028_s8_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:191
  logic [4:0] select_3100;
  assign select_3100 = or_3069_s8_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/agreement.hpp:276
  logic select_3550;
  assign select_3550 = equal_1791_s8_q ? (less_1969 & (equal_1971 & or_1972)) : patches_read_searches_q;

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
  assign patches_right_0_re = s8_en & (not_1792 & (not_1794 & and_1800_s8_q));
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
  assign patches_right_1_re = s8_en & (not_1792 & (not_1794 & and_1833_s8_q));
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
  assign patches_columns_above_re = s8_en & and_1875;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s8_q[6:0];
  logic left_we;
  assign left_we = s8_en & and_656_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_758_s8_q, left_rdata_s8_q[62:46], and_757_s8_q, left_rdata_s8_q[45:29], and_756_s8_q, left_rdata_s8_q[28:12], and_755_s8_q, left_rdata_s8_q[11:0], fresh_rdata_s8_q[30:26], fresh_rdata_s8_q[24], fresh_rdata_s8_q[11:0]};
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
  assign right_codes_we = s8_en & and_656_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_764_s8_q, right_codes_rdata_s8_q[77:66], and_763_s8_q, right_codes_rdata_s8_q[65:54], and_762_s8_q, right_codes_rdata_s8_q[53:40], and_761_s8_q, right_codes_rdata_s8_q[39:26], and_760_s8_q, right_codes_rdata_s8_q[25:12], and_759_s8_q, right_codes_rdata_s8_q[11:0], fresh_rdata_s8_q[32:31], fresh_rdata_s8_q[25], fresh_rdata_s8_q[23:12]};
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
      lower_half_q <= select_2577;
      patches_lower_q <= sample_pair_whole_s8_q ? select_3030 : patches_lower_q;
      patches_code_row_q <= select_3100;
      patches_column_q <= or_3069_s8_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3093_s8_q & (patches_column_q == 5'h1e);
      patches_step_q <= or_3069_s8_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3550;
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
  logic and_603_s9_q;
  logic and_612_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_621_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic [6:0] select_630_s9_q;
  logic [6:0] right_s9_q;
  logic not_641_s9_q;
  logic and_645_s9_q;
  logic and_650_s9_q;
  logic and_652_s9_q;
  logic equal_685_s9_q;
  logic xor_844_s9_q;
  logic parity_893_s9_q;
  logic and_894_s9_q;
  logic or_898_s9_q;
  logic or_902_s9_q;
  logic or_909_s9_q;
  logic or_913_s9_q;
  logic or_917_s9_q;
  logic or_924_s9_q;
  logic or_928_s9_q;
  logic or_932_s9_q;
  logic and_941_s9_q;
  logic and_943_s9_q;
  logic or_955_s9_q;
  logic or_959_s9_q;
  logic or_963_s9_q;
  logic xor_1093_s9_q;
  logic parity_1108_s9_q;
  logic parity_1142_s9_q;
  logic and_1143_s9_q;
  logic or_1147_s9_q;
  logic or_1151_s9_q;
  logic or_1158_s9_q;
  logic or_1162_s9_q;
  logic or_1166_s9_q;
  logic or_1173_s9_q;
  logic or_1177_s9_q;
  logic or_1181_s9_q;
  logic and_1190_s9_q;
  logic or_1191_s9_q;
  logic or_1204_s9_q;
  logic or_1208_s9_q;
  logic or_1212_s9_q;
  logic xor_1342_s9_q;
  logic parity_1357_s9_q;
  logic parity_1391_s9_q;
  logic and_1392_s9_q;
  logic or_1396_s9_q;
  logic or_1400_s9_q;
  logic or_1407_s9_q;
  logic or_1411_s9_q;
  logic or_1415_s9_q;
  logic or_1422_s9_q;
  logic or_1426_s9_q;
  logic or_1430_s9_q;
  logic and_1439_s9_q;
  logic or_1440_s9_q;
  logic or_1453_s9_q;
  logic or_1457_s9_q;
  logic or_1461_s9_q;
  logic and_1568_s9_q;
  logic equal_1569_s9_q;
  logic or_1589_s9_q;
  logic and_1692_s9_q;
  logic less_1706_s9_q;
  logic [5:0] b_s9_q;
  logic select_1762_s9_q;
  logic [8:0] difference_1764_s9_q;
  logic [11:0] sum_1767_s9_q;
  logic select_1768_s9_q;
  logic [10:0] sum_1770_s9_q;
  logic equal_1791_s9_q;
  logic not_1792_s9_q;
  logic equal_1793_s9_q;
  logic not_1794_s9_q;
  logic equal_1795_s9_q;
  logic equal_1796_s9_q;
  logic or_1797_s9_q;
  logic not_1798_s9_q;
  logic [4:0] select_1821_s9_q;
  logic select_1827_s9_q;
  logic and_1854_s9_q;
  logic [3:0] select_1865_s9_q;
  logic and_1875_s9_q;
  logic less_1969_s9_q;
  logic equal_1970_s9_q;
  logic or_1972_s9_q;
  logic sum_1996_s9_q;
  logic and_2018_s9_q;
  logic not_2058_s9_q;
  logic less_2136_s9_q;
  logic equal_2290_s9_q;
  logic equal_2479_s9_q;
  logic and_2585_s9_q;
  logic and_2616_s9_q;
  logic equal_2705_s9_q;
  logic [7:0] select_2752_s9_q;
  logic rise_2_s9_q;
  logic [7:0] select_2758_s9_q;
  logic [7:0] xor_2763_s9_q;
  logic less_2789_s9_q;
  logic or_3069_s9_q;
  logic not_3093_s9_q;
  logic equal_3585_s9_q;
  logic less_3841_s9_q;
  logic equal_3913_s9_q;
  logic or_4063_s9_q;
  logic and_4077_s9_q;
  logic and_4094_s9_q;
  logic not_4106_s9_q;
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
      and_603_s9_q <= and_603_s8_q;
      and_612_s9_q <= and_612_s8_q;
      x_s9_2_q <= x_s8_2_q;
      select_621_s9_q <= select_621_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_630_s9_q <= ({1'b0, last_s8_q} < found) ? 7'h0 : found[6:0];
      right_s9_q <= right_s8_q;
      not_641_s9_q <= not_641_s8_q;
      and_645_s9_q <= and_645_s8_q;
      and_650_s9_q <= and_650_s8_q;
      and_652_s9_q <= and_652_s8_q;
      equal_685_s9_q <= equal_685_s8_q;
      xor_844_s9_q <= parity_788 ^ parity_843;
      parity_893_s9_q <= parity_893;
      and_894_s9_q <= parity_788 & parity_843;
      or_898_s9_q <= or_898;
      or_902_s9_q <= (parity_828 & parity_840) | and_901;
      or_909_s9_q <= or_909;
      or_913_s9_q <= or_913;
      or_917_s9_q <= or_917;
      or_924_s9_q <= or_924;
      or_928_s9_q <= or_928;
      or_932_s9_q <= or_932;
      and_941_s9_q <= parity_875 & parity_890;
      and_943_s9_q <= (^{or_856, or_852, or_848}) & (parity_875 | parity_890);
      or_955_s9_q <= (or_852 & or_856) | (or_848 & (or_852 | or_856));
      or_959_s9_q <= (or_868 & or_872) | (or_864 & (or_868 | or_872));
      or_963_s9_q <= (or_883 & or_887) | (or_879 & (or_883 | or_887));
      xor_1093_s9_q <= parity_1037 ^ parity_1092;
      parity_1108_s9_q <= ^{or_1105, or_1101, or_1097};
      parity_1142_s9_q <= parity_1142;
      and_1143_s9_q <= parity_1037 & parity_1092;
      or_1147_s9_q <= or_1147;
      or_1151_s9_q <= (parity_1077 & parity_1089) | and_1150;
      or_1158_s9_q <= or_1158;
      or_1162_s9_q <= or_1162;
      or_1166_s9_q <= or_1166;
      or_1173_s9_q <= or_1173;
      or_1177_s9_q <= or_1177;
      or_1181_s9_q <= or_1181;
      and_1190_s9_q <= parity_1124 & parity_1139;
      or_1191_s9_q <= parity_1124 | parity_1139;
      or_1204_s9_q <= (or_1101 & or_1105) | (or_1097 & (or_1101 | or_1105));
      or_1208_s9_q <= (or_1117 & or_1121) | (or_1113 & (or_1117 | or_1121));
      or_1212_s9_q <= (or_1132 & or_1136) | (or_1128 & (or_1132 | or_1136));
      xor_1342_s9_q <= parity_1290 ^ parity_1341;
      parity_1357_s9_q <= ^{or_1354, or_1350, or_1346};
      parity_1391_s9_q <= parity_1391;
      and_1392_s9_q <= parity_1290 & parity_1341;
      or_1396_s9_q <= or_1396;
      or_1400_s9_q <= (parity_1326 & parity_1338) | and_1399;
      or_1407_s9_q <= or_1407;
      or_1411_s9_q <= or_1411;
      or_1415_s9_q <= or_1415;
      or_1422_s9_q <= or_1422;
      or_1426_s9_q <= or_1426;
      or_1430_s9_q <= or_1430;
      and_1439_s9_q <= parity_1373 & parity_1388;
      or_1440_s9_q <= parity_1373 | parity_1388;
      or_1453_s9_q <= (or_1350 & or_1354) | (or_1346 & (or_1350 | or_1354));
      or_1457_s9_q <= (or_1366 & or_1370) | (or_1362 & (or_1366 | or_1370));
      or_1461_s9_q <= (or_1381 & or_1385) | (or_1377 & (or_1381 | or_1385));
      and_1568_s9_q <= and_1568_s8_q;
      equal_1569_s9_q <= equal_1569_s8_q;
      or_1589_s9_q <= or_1589;
      and_1692_s9_q <= and_1692_s8_q;
      less_1706_s9_q <= less_1706_s8_q;
      b_s9_q <= b_s8_q;
      select_1762_s9_q <= select_1762[0];
      difference_1764_s9_q <= select_1762[9:1] - (b_s8_q[5] ? select_1761_s8_q[8:0] : 9'h0);
      sum_1767_s9_q <= sum_1767[12:1];
      select_1768_s9_q <= select_1768[0];
      sum_1770_s9_q <= select_1768[11:1] + (b_s8_q[3] ? select_1761_s8_q[10:0] : 11'h0);
      equal_1791_s9_q <= equal_1791_s8_q;
      not_1792_s9_q <= not_1792;
      equal_1793_s9_q <= equal_1793_s8_q;
      not_1794_s9_q <= not_1794;
      equal_1795_s9_q <= equal_1795_s8_q;
      equal_1796_s9_q <= equal_1796_s8_q;
      or_1797_s9_q <= or_1797_s8_q;
      not_1798_s9_q <= not_1798_s8_q;
      select_1821_s9_q <= select_1821_s8_q;
      select_1827_s9_q <= select_1827_s8_q;
      and_1854_s9_q <= not_1792 & (not_1794 & and_1852_s8_q);
      select_1865_s9_q <= select_1865_s8_q;
      and_1875_s9_q <= and_1875;
      less_1969_s9_q <= less_1969;
      equal_1970_s9_q <= equal_1970;
      or_1972_s9_q <= or_1972;
      sum_1996_s9_q <= sum_1996_s8_q;
      and_2018_s9_q <= and_2018_s8_q;
      not_2058_s9_q <= not_2058_s8_q;
      less_2136_s9_q <= less_2136_s8_q;
      equal_2290_s9_q <= equal_2290_s8_q;
      equal_2479_s9_q <= equal_2479_s8_q;
      and_2585_s9_q <= and_2585_s8_q;
      and_2616_s9_q <= or_582_s8_q & and_2615_s8_q;
      equal_2705_s9_q <= shift_s8_q == 6'h0;
      select_2752_s9_q <= select_2752;
      rise_2_s9_q <= rise_2[8];
      select_2758_s9_q <= rise_2[8] ? select_2754_s8_q : select_2756_s8_q;
      xor_2763_s9_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2789_s9_q <= select_2754_s8_q < select_2756_s8_q;
      or_3069_s9_q <= or_3069_s8_q;
      not_3093_s9_q <= not_3093_s8_q;
      equal_3585_s9_q <= patches_step_q[6:5] == 2'h3;
      less_3841_s9_q <= less_3841_s8_q;
      equal_3913_s9_q <= equal_3913_s8_q;
      or_4063_s9_q <= or_4063_s8_q;
      and_4077_s9_q <= said_q;
      and_4094_s9_q <= less_2578 & proven_q;
      not_4106_s9_q <= not_4106_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic [15:0] patches_chance_q;
  // hls/stages/count_bits.hpp:24
  logic parity_920;
  assign parity_920 = ^{or_917_s9_q, or_913_s9_q, or_909_s9_q};
  logic parity_935;
  assign parity_935 = ^{or_932_s9_q, or_928_s9_q, or_924_s9_q};
  logic parity_938;
  assign parity_938 = ^{or_932_s9_q, or_928_s9_q, or_924_s9_q, or_917_s9_q, or_913_s9_q, or_909_s9_q, or_902_s9_q, or_898_s9_q, and_894_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_940;
  assign and_940 = parity_893_s9_q & parity_938;
  logic or_944;
  assign or_944 = and_941_s9_q | and_943_s9_q;
  logic and_947;
  assign and_947 = (^{or_902_s9_q, or_898_s9_q, and_894_s9_q}) & (parity_920 | parity_935);
  logic or_948;
  assign or_948 = (parity_920 & parity_935) | and_947;
  // hls/stages/count_bits.hpp:24
  logic parity_966;
  assign parity_966 = ^{or_963_s9_q, or_959_s9_q, or_955_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_970;
  assign or_970 = (or_898_s9_q & or_902_s9_q) | (and_894_s9_q & (or_898_s9_q | or_902_s9_q));
  logic or_974;
  assign or_974 = (or_913_s9_q & or_917_s9_q) | (or_909_s9_q & (or_913_s9_q | or_917_s9_q));
  logic or_978;
  assign or_978 = (or_928_s9_q & or_932_s9_q) | (or_924_s9_q & (or_928_s9_q | or_932_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_981;
  assign parity_981 = ^{or_978, or_974, or_970};
  logic parity_984;
  assign parity_984 = ^{or_978, or_974, or_970, or_963_s9_q, or_959_s9_q, or_955_s9_q, or_948, or_944, and_940};
  // hls/stages/count_bits.hpp:25
  logic or_996;
  assign or_996 = (or_959_s9_q & or_963_s9_q) | (or_955_s9_q & (or_959_s9_q | or_963_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1169;
  assign parity_1169 = ^{or_1166_s9_q, or_1162_s9_q, or_1158_s9_q};
  logic parity_1184;
  assign parity_1184 = ^{or_1181_s9_q, or_1177_s9_q, or_1173_s9_q};
  logic parity_1187;
  assign parity_1187 = ^{or_1181_s9_q, or_1177_s9_q, or_1173_s9_q, or_1166_s9_q, or_1162_s9_q, or_1158_s9_q, or_1151_s9_q, or_1147_s9_q, and_1143_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1189;
  assign and_1189 = parity_1142_s9_q & parity_1187;
  logic or_1193;
  assign or_1193 = and_1190_s9_q | (parity_1108_s9_q & or_1191_s9_q);
  logic and_1196;
  assign and_1196 = (^{or_1151_s9_q, or_1147_s9_q, and_1143_s9_q}) & (parity_1169 | parity_1184);
  logic or_1197;
  assign or_1197 = (parity_1169 & parity_1184) | and_1196;
  // hls/stages/count_bits.hpp:24
  logic parity_1215;
  assign parity_1215 = ^{or_1212_s9_q, or_1208_s9_q, or_1204_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1219;
  assign or_1219 = (or_1147_s9_q & or_1151_s9_q) | (and_1143_s9_q & (or_1147_s9_q | or_1151_s9_q));
  logic or_1223;
  assign or_1223 = (or_1162_s9_q & or_1166_s9_q) | (or_1158_s9_q & (or_1162_s9_q | or_1166_s9_q));
  logic or_1227;
  assign or_1227 = (or_1177_s9_q & or_1181_s9_q) | (or_1173_s9_q & (or_1177_s9_q | or_1181_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1230;
  assign parity_1230 = ^{or_1227, or_1223, or_1219};
  logic parity_1233;
  assign parity_1233 = ^{or_1227, or_1223, or_1219, or_1212_s9_q, or_1208_s9_q, or_1204_s9_q, or_1197, or_1193, and_1189};
  // hls/stages/count_bits.hpp:25
  logic or_1245;
  assign or_1245 = (or_1208_s9_q & or_1212_s9_q) | (or_1204_s9_q & (or_1208_s9_q | or_1212_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1418;
  assign parity_1418 = ^{or_1415_s9_q, or_1411_s9_q, or_1407_s9_q};
  logic parity_1433;
  assign parity_1433 = ^{or_1430_s9_q, or_1426_s9_q, or_1422_s9_q};
  logic parity_1436;
  assign parity_1436 = ^{or_1430_s9_q, or_1426_s9_q, or_1422_s9_q, or_1415_s9_q, or_1411_s9_q, or_1407_s9_q, or_1400_s9_q, or_1396_s9_q, and_1392_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1438;
  assign and_1438 = parity_1391_s9_q & parity_1436;
  logic or_1442;
  assign or_1442 = and_1439_s9_q | (parity_1357_s9_q & or_1440_s9_q);
  logic and_1445;
  assign and_1445 = (^{or_1400_s9_q, or_1396_s9_q, and_1392_s9_q}) & (parity_1418 | parity_1433);
  logic or_1446;
  assign or_1446 = (parity_1418 & parity_1433) | and_1445;
  // hls/stages/count_bits.hpp:24
  logic parity_1464;
  assign parity_1464 = ^{or_1461_s9_q, or_1457_s9_q, or_1453_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1468;
  assign or_1468 = (or_1396_s9_q & or_1400_s9_q) | (and_1392_s9_q & (or_1396_s9_q | or_1400_s9_q));
  logic or_1472;
  assign or_1472 = (or_1411_s9_q & or_1415_s9_q) | (or_1407_s9_q & (or_1411_s9_q | or_1415_s9_q));
  logic or_1476;
  assign or_1476 = (or_1426_s9_q & or_1430_s9_q) | (or_1422_s9_q & (or_1426_s9_q | or_1430_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1479;
  assign parity_1479 = ^{or_1476, or_1472, or_1468};
  logic parity_1482;
  assign parity_1482 = ^{or_1476, or_1472, or_1468, or_1461_s9_q, or_1457_s9_q, or_1453_s9_q, or_1446, or_1442, and_1438};
  // hls/stages/count_bits.hpp:25
  logic or_1494;
  assign or_1494 = (or_1457_s9_q & or_1461_s9_q) | (or_1453_s9_q & (or_1457_s9_q | or_1461_s9_q));
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s9_q[6:1]} < x_s9_q;
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1771;
  assign sum_1771 = sum_1767_s9_q + {sum_1770_s9_q, select_1768_s9_q};
  logic [9:0] sum_1772;
  assign sum_1772 = {difference_1764_s9_q, select_1762_s9_q} + sum_1771[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2752_s9_q} - {1'b0, select_2758_s9_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s9_q} + {1'b0, xor_2763_s9_q};
  // hls/stages/patches.hpp:91
  logic parity_3006;
  assign parity_3006 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3007;
  assign select_3007 = equal_2479_s9_q ? {patches_chance_q[14:0], parity_3006} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s9_q[6] ? {of_32, 1'b0} : {1'b0, of_32};

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1390; read in stage 9, written in stage 16: 9 < 16 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_582_s9_q ? select_630_s9_q : right_s9_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s9_en & select_621_s9_q;
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
  assign patches_left_re = s9_en & and_1854_s9_q;
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
  assign patches_rows_re = s9_en & (equal_1791_s9_q & (less_1969_s9_q & or_1972_s9_q));
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_chance_q <= 16'h1;
    end else if (s9_en) begin
      patches_chance_q <= and_552_s9_q ? select_3007 : patches_chance_q;
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
  logic and_603_s10_q;
  logic and_612_s10_q;
  logic [6:0] x_s10_2_q;
  logic [61:0] best_left_rdata_s10_q;
  logic [6:0] select_630_s10_q;
  logic [6:0] right_s10_q;
  logic not_641_s10_q;
  logic and_645_s10_q;
  logic and_650_s10_q;
  logic and_652_s10_q;
  logic equal_685_s10_q;
  logic xor_844_s10_q;
  logic xor_939_s10_q;
  logic parity_984_s10_q;
  logic and_985_s10_q;
  logic and_987_s10_q;
  logic and_989_s10_q;
  logic and_991_s10_q;
  logic or_996_s10_q;
  logic or_1000_s10_q;
  logic xor_1093_s10_q;
  logic xor_1188_s10_q;
  logic parity_1233_s10_q;
  logic and_1234_s10_q;
  logic and_1236_s10_q;
  logic and_1238_s10_q;
  logic and_1240_s10_q;
  logic or_1245_s10_q;
  logic or_1249_s10_q;
  logic xor_1342_s10_q;
  logic xor_1437_s10_q;
  logic parity_1482_s10_q;
  logic and_1483_s10_q;
  logic and_1485_s10_q;
  logic and_1487_s10_q;
  logic and_1489_s10_q;
  logic or_1494_s10_q;
  logic or_1498_s10_q;
  logic and_1568_s10_q;
  logic equal_1569_s10_q;
  logic or_1589_s10_q;
  logic and_1692_s10_q;
  logic right_3_s10_q;
  logic less_1706_s10_q;
  logic [5:0] b_s10_q;
  logic [7:0] sum_1772_s10_q;
  logic equal_1791_s10_q;
  logic not_1792_s10_q;
  logic equal_1793_s10_q;
  logic not_1794_s10_q;
  logic equal_1795_s10_q;
  logic equal_1796_s10_q;
  logic or_1797_s10_q;
  logic not_1798_s10_q;
  logic [7:0] patches_right_0_rdata_s10_q;
  logic [4:0] select_1821_s10_q;
  logic select_1827_s10_q;
  logic [7:0] patches_right_1_rdata_s10_q;
  logic [3:0] select_1865_s10_q;
  logic and_1875_s10_q;
  logic [31:0] patches_columns_above_rdata_s10_q;
  logic less_1969_s10_q;
  logic equal_1970_s10_q;
  logic or_1972_s10_q;
  logic sum_1996_s10_q;
  logic and_2018_s10_q;
  logic not_2058_s10_q;
  logic less_2136_s10_q;
  logic equal_2290_s10_q;
  logic equal_2479_s10_q;
  logic and_2585_s10_q;
  logic and_2616_s10_q;
  logic equal_2705_s10_q;
  logic [7:0] wide_s10_q;
  logic [8:0] size_3_s10_q;
  logic less_2789_s10_q;
  logic [5:0] further_s10_q;
  logic or_3069_s10_q;
  logic not_3093_s10_q;
  logic equal_3585_s10_q;
  logic less_3841_s10_q;
  logic equal_3913_s10_q;
  logic or_4063_s10_q;
  logic and_4077_s10_q;
  logic and_4094_s10_q;
  logic not_4106_s10_q;
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
      and_603_s10_q <= and_603_s9_q;
      and_612_s10_q <= and_612_s9_q;
      x_s10_2_q <= x_s9_2_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_630_s10_q <= select_630_s9_q;
      right_s10_q <= right_s9_q;
      not_641_s10_q <= not_641_s9_q;
      and_645_s10_q <= and_645_s9_q;
      and_650_s10_q <= and_650_s9_q;
      and_652_s10_q <= and_652_s9_q;
      equal_685_s10_q <= equal_685_s9_q;
      xor_844_s10_q <= xor_844_s9_q;
      xor_939_s10_q <= parity_893_s9_q ^ parity_938;
      parity_984_s10_q <= parity_984;
      and_985_s10_q <= parity_966 & parity_981;
      and_987_s10_q <= (^{or_948, or_944, and_940}) & (parity_966 | parity_981);
      and_989_s10_q <= or_944 & or_948;
      and_991_s10_q <= and_940 & (or_944 | or_948);
      or_996_s10_q <= or_996;
      or_1000_s10_q <= (or_974 & or_978) | (or_970 & (or_974 | or_978));
      xor_1093_s10_q <= xor_1093_s9_q;
      xor_1188_s10_q <= parity_1142_s9_q ^ parity_1187;
      parity_1233_s10_q <= parity_1233;
      and_1234_s10_q <= parity_1215 & parity_1230;
      and_1236_s10_q <= (^{or_1197, or_1193, and_1189}) & (parity_1215 | parity_1230);
      and_1238_s10_q <= or_1193 & or_1197;
      and_1240_s10_q <= and_1189 & (or_1193 | or_1197);
      or_1245_s10_q <= or_1245;
      or_1249_s10_q <= (or_1223 & or_1227) | (or_1219 & (or_1223 | or_1227));
      xor_1342_s10_q <= xor_1342_s9_q;
      xor_1437_s10_q <= parity_1391_s9_q ^ parity_1436;
      parity_1482_s10_q <= parity_1482;
      and_1483_s10_q <= parity_1464 & parity_1479;
      and_1485_s10_q <= (^{or_1446, or_1442, and_1438}) & (parity_1464 | parity_1479);
      and_1487_s10_q <= or_1442 & or_1446;
      and_1489_s10_q <= and_1438 & (or_1442 | or_1446);
      or_1494_s10_q <= or_1494;
      or_1498_s10_q <= (or_1472 & or_1476) | (or_1468 & (or_1472 | or_1476));
      and_1568_s10_q <= and_1568_s9_q;
      equal_1569_s10_q <= equal_1569_s9_q;
      or_1589_s10_q <= or_1589_s9_q;
      and_1692_s10_q <= and_1692_s9_q;
      right_3_s10_q <= right_3;
      less_1706_s10_q <= less_1706_s9_q;
      b_s10_q <= b_s9_q;
      sum_1772_s10_q <= sum_1772[9:2];
      equal_1791_s10_q <= equal_1791_s9_q;
      not_1792_s10_q <= not_1792_s9_q;
      equal_1793_s10_q <= equal_1793_s9_q;
      not_1794_s10_q <= not_1794_s9_q;
      equal_1795_s10_q <= equal_1795_s9_q;
      equal_1796_s10_q <= equal_1796_s9_q;
      or_1797_s10_q <= or_1797_s9_q;
      not_1798_s10_q <= not_1798_s9_q;
      patches_right_0_rdata_s10_q <= patches_right_0_rdata_q;
      select_1821_s10_q <= select_1821_s9_q;
      select_1827_s10_q <= select_1827_s9_q;
      patches_right_1_rdata_s10_q <= patches_right_1_rdata_q;
      select_1865_s10_q <= select_1865_s9_q;
      and_1875_s10_q <= and_1875_s9_q;
      patches_columns_above_rdata_s10_q <= patches_columns_above_rdata_q;
      less_1969_s10_q <= less_1969_s9_q;
      equal_1970_s10_q <= equal_1970_s9_q;
      or_1972_s10_q <= or_1972_s9_q;
      sum_1996_s10_q <= sum_1996_s9_q;
      and_2018_s10_q <= and_2018_s9_q;
      not_2058_s10_q <= not_2058_s9_q;
      less_2136_s10_q <= less_2136_s9_q;
      equal_2290_s10_q <= equal_2290_s9_q;
      equal_2479_s10_q <= equal_2479_s9_q;
      and_2585_s10_q <= and_2585_s9_q;
      and_2616_s10_q <= and_2616_s9_q;
      equal_2705_s10_q <= equal_2705_s9_q;
      wide_s10_q <= wide;
      size_3_s10_q <= size_3;
      less_2789_s10_q <= less_2789_s9_q;
      further_s10_q <= further;
      or_3069_s10_q <= or_3069_s9_q;
      not_3093_s10_q <= not_3093_s9_q;
      equal_3585_s10_q <= equal_3585_s9_q;
      less_3841_s10_q <= less_3841_s9_q;
      equal_3913_s10_q <= equal_3913_s9_q;
      or_4063_s10_q <= or_4063_s9_q;
      and_4077_s10_q <= and_4077_s9_q;
      and_4094_s10_q <= and_4094_s9_q;
      not_4106_s10_q <= not_4106_s9_q;
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
  logic or_988;
  assign or_988 = and_985_s10_q | and_987_s10_q;
  logic or_992;
  assign or_992 = and_989_s10_q | and_991_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1005;
  assign parity_1005 = ^{or_1000_s10_q, or_996_s10_q, or_992, or_988};
  // hls/stages/count_bits.hpp:25
  logic or_1009;
  assign or_1009 = (or_996_s10_q & or_1000_s10_q) | (or_992 & (or_996_s10_q | or_1000_s10_q));
  logic and_1010;
  assign and_1010 = or_988 & (^{or_1000_s10_q, or_996_s10_q, or_992});
  // hls/stages/count_bits.hpp:24
  logic xor_1011;
  assign xor_1011 = or_1009 ^ and_1010;
  // hls/stages/count_bits.hpp:27
  logic and_1012;
  assign and_1012 = or_1009 & and_1010;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1013;
  assign select_1013 = equal_596_s10_q ? {and_1012, xor_1011, parity_1005, parity_984_s10_q, xor_939_s10_q, xor_844_s10_q} : 6'h0;
  logic [5:0] column;
  assign column = or_582_s10_q ? 6'h0 : select_1013;
  // hls/stages/count_bits.hpp:25
  logic or_1237;
  assign or_1237 = and_1234_s10_q | and_1236_s10_q;
  logic or_1241;
  assign or_1241 = and_1238_s10_q | and_1240_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1254;
  assign parity_1254 = ^{or_1249_s10_q, or_1245_s10_q, or_1241, or_1237};
  // hls/stages/count_bits.hpp:25
  logic or_1258;
  assign or_1258 = (or_1245_s10_q & or_1249_s10_q) | (or_1241 & (or_1245_s10_q | or_1249_s10_q));
  logic and_1259;
  assign and_1259 = or_1237 & (^{or_1249_s10_q, or_1245_s10_q, or_1241});
  // hls/stages/count_bits.hpp:24
  logic xor_1260;
  assign xor_1260 = or_1258 ^ and_1259;
  // hls/stages/count_bits.hpp:27
  logic and_1261;
  assign and_1261 = or_1258 & and_1259;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1262;
  assign select_1262 = equal_596_s10_q ? {and_1261, xor_1260, parity_1254, parity_1233_s10_q, xor_1188_s10_q, xor_1093_s10_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_582_s10_q ? 6'h0 : select_1262;
  // hls/stages/count_bits.hpp:25
  logic or_1486;
  assign or_1486 = and_1483_s10_q | and_1485_s10_q;
  logic or_1490;
  assign or_1490 = and_1487_s10_q | and_1489_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1503;
  assign parity_1503 = ^{or_1498_s10_q, or_1494_s10_q, or_1490, or_1486};
  // hls/stages/count_bits.hpp:25
  logic or_1507;
  assign or_1507 = (or_1494_s10_q & or_1498_s10_q) | (or_1490 & (or_1494_s10_q | or_1498_s10_q));
  logic and_1508;
  assign and_1508 = or_1486 & (^{or_1498_s10_q, or_1494_s10_q, or_1490});
  // hls/stages/count_bits.hpp:24
  logic xor_1509;
  assign xor_1509 = or_1507 ^ and_1508;
  // hls/stages/count_bits.hpp:27
  logic and_1510;
  assign and_1510 = or_1507 & and_1508;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1511;
  assign select_1511 = equal_596_s10_q ? {and_1510, xor_1509, parity_1503, parity_1482_s10_q, xor_1437_s10_q, xor_1342_s10_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_582_s10_q ? 6'h0 : select_1511;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_2;
  assign before_v_2 = age_s10_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1547;
  assign sum_1547 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_3;
  assign before_v_3 = age_s10_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1550;
  assign sum_1550 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:1019
  logic [5:0] sum_1654;
  assign sum_1654 = {1'b0, last_s10_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:263
  logic right_2;
  assign right_2 = inside_v & ({1'b0, sum_1654, last_s10_q[1]} < x_s10_q);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1735;
  assign sum_1735 = {2'h0, x_s10_q} + {{4{b_s10_q[5]}}, b_s10_q};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1773;
  assign sum_1773 = {registration_slope_s10_q[11], registration_slope_s10_q} + {{5{sum_1772_s10_q[7]}}, sum_1772_s10_q};
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_1796_s10_q ? (patches_second_s10_q ? 8'h0 : patches_right_0_rdata_s10_q) : 8'h0;
  // hls/stages/patches.hpp:471
  logic [8:0] sum_1922;
  assign sum_1922 = {1'b0, patches_columns_above_rdata_s10_q[23:16]} + {3'h0, patches_columns_above_rdata_s10_q[31:26]};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2766;
  assign select_2766 = ({wide_s10_q, 1'b0} < size_3_s10_q) ? {wide_s10_q, 1'b0} : size_3_s10_q;
  logic [8:0] taken;
  assign taken = ~select_2766;
  // hls/stages/patches.hpp:110
  logic [5:0] select_3012;
  assign select_3012 = right_3_s10_q ? last_s10_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s10_q} + {1'b0, select_3012};

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
  logic and_603_s11_q;
  logic and_612_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic [6:0] select_630_s11_q;
  logic [6:0] right_s11_q;
  logic [28:0] best_right_rdata_s11_q;
  logic not_641_s11_q;
  logic and_645_s11_q;
  logic and_650_s11_q;
  logic and_652_s11_q;
  logic equal_685_s11_q;
  logic [5:0] column_s11_q;
  logic [5:0] select_1264_s11_q;
  logic [5:0] select_1513_s11_q;
  logic [6:0] sum_1548_s11_q;
  logic [6:0] sum_1551_s11_q;
  logic and_1568_s11_q;
  logic equal_1569_s11_q;
  logic or_1589_s11_q;
  logic right_2_s11_q;
  logic and_1692_s11_q;
  logic right_3_s11_q;
  logic less_1706_s11_q;
  logic [5:0] b_s11_q;
  logic less_1727_s11_q;
  logic not_1731_s11_q;
  logic less_1736_s11_q;
  logic less_1737_s11_q;
  logic [7:0] sum_1773_s11_q;
  logic less_1774_s11_q;
  logic less_1775_s11_q;
  logic equal_1784_s11_q;
  logic equal_1791_s11_q;
  logic not_1792_s11_q;
  logic equal_1793_s11_q;
  logic not_1794_s11_q;
  logic equal_1795_s11_q;
  logic equal_1796_s11_q;
  logic or_1797_s11_q;
  logic not_1798_s11_q;
  logic [4:0] select_1821_s11_q;
  logic select_1827_s11_q;
  logic [7:0] patches_left_rdata_s11_q;
  logic [3:0] select_1865_s11_q;
  logic and_1875_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic [7:0] select_1879_s11_q;
  logic [8:0] sum_1922_s11_q;
  logic less_1969_s11_q;
  logic equal_1970_s11_q;
  logic or_1972_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_1996_s11_q;
  logic and_2018_s11_q;
  logic not_2058_s11_q;
  logic less_2136_s11_q;
  logic not_2140_s11_q;
  logic equal_2290_s11_q;
  logic equal_2479_s11_q;
  logic and_2585_s11_q;
  logic and_2616_s11_q;
  logic equal_2705_s11_q;
  logic less_2750_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] taken_s11_q;
  logic [7:0] not_2768_s11_q;
  logic less_2789_s11_q;
  logic not_3015_s11_q;
  logic or_3069_s11_q;
  logic not_3093_s11_q;
  logic equal_3585_s11_q;
  logic less_3841_s11_q;
  logic equal_3913_s11_q;
  logic or_4063_s11_q;
  logic and_4077_s11_q;
  logic and_4094_s11_q;
  logic not_4106_s11_q;
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
      and_603_s11_q <= and_603_s10_q;
      and_612_s11_q <= and_612_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_630_s11_q <= select_630_s10_q;
      right_s11_q <= right_s10_q;
      best_right_rdata_s11_q <= best_right_rdata_q;
      not_641_s11_q <= not_641_s10_q;
      and_645_s11_q <= and_645_s10_q;
      and_650_s11_q <= and_650_s10_q;
      and_652_s11_q <= and_652_s10_q;
      equal_685_s11_q <= equal_685_s10_q;
      column_s11_q <= column;
      select_1264_s11_q <= age_s10_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1513_s11_q <= age_s10_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1548_s11_q <= {1'b0, before_v_2} + sum_1547;
      sum_1551_s11_q <= {1'b0, before_v_3} + sum_1550;
      and_1568_s11_q <= and_1568_s10_q;
      equal_1569_s11_q <= equal_1569_s10_q;
      or_1589_s11_q <= or_1589_s10_q;
      right_2_s11_q <= right_2;
      and_1692_s11_q <= and_1692_s10_q;
      right_3_s11_q <= right_3_s10_q;
      less_1706_s11_q <= less_1706_s10_q;
      b_s11_q <= b_s10_q;
      less_1727_s11_q <= {3'h0, last_s10_q[6:1]} < ({1'b0, x_s10_q} + 9'h1);
      not_1731_s11_q <= ~(x_s10_q < {1'b0, last_s10_q});
      less_1736_s11_q <= $signed(10'h0) < $signed(sum_1735);
      less_1737_s11_q <= $signed(sum_1735) < $signed({3'h0, last_s10_q});
      sum_1773_s11_q <= sum_1773[7:0];
      less_1774_s11_q <= $signed(6'h0) < $signed(sum_1773[12:7]);
      less_1775_s11_q <= $signed(sum_1773[12:7]) < $signed(6'h3f);
      equal_1784_s11_q <= x_s10_q == {1'b0, last_s10_q};
      equal_1791_s11_q <= equal_1791_s10_q;
      not_1792_s11_q <= not_1792_s10_q;
      equal_1793_s11_q <= equal_1793_s10_q;
      not_1794_s11_q <= not_1794_s10_q;
      equal_1795_s11_q <= equal_1795_s10_q;
      equal_1796_s11_q <= equal_1796_s10_q;
      or_1797_s11_q <= or_1797_s10_q;
      not_1798_s11_q <= not_1798_s10_q;
      select_1821_s11_q <= select_1821_s10_q;
      select_1827_s11_q <= select_1827_s10_q;
      patches_left_rdata_s11_q <= patches_left_rdata_q;
      select_1865_s11_q <= select_1865_s10_q;
      and_1875_s11_q <= and_1875_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_s10_q;
      select_1879_s11_q <= patches_second_s10_q ? patches_right_1_rdata_s10_q : pixel;
      sum_1922_s11_q <= sum_1922;
      less_1969_s11_q <= less_1969_s10_q;
      equal_1970_s11_q <= equal_1970_s10_q;
      or_1972_s11_q <= or_1972_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_1996_s11_q <= sum_1996_s10_q;
      and_2018_s11_q <= and_2018_s10_q;
      not_2058_s11_q <= not_2058_s10_q;
      less_2136_s11_q <= less_2136_s10_q;
      not_2140_s11_q <= ~({sum_1654, last_s10_q[1:0]} < x_s10_q);
      equal_2290_s11_q <= equal_2290_s10_q;
      equal_2479_s11_q <= equal_2479_s10_q;
      and_2585_s11_q <= and_2585_s10_q;
      and_2616_s11_q <= and_2616_s10_q;
      equal_2705_s11_q <= equal_2705_s10_q;
      less_2750_s11_q <= slot_s10_q < 3'h3;
      wide_s11_q <= wide_s10_q;
      taken_s11_q <= taken;
      not_2768_s11_q <= ~wide_s10_q;
      less_2789_s11_q <= less_2789_s10_q;
      not_3015_s11_q <= ~(x_s10_q < {1'b0, from});
      or_3069_s11_q <= or_3069_s10_q;
      not_3093_s11_q <= not_3093_s10_q;
      equal_3585_s11_q <= equal_3585_s10_q;
      less_3841_s11_q <= less_3841_s10_q;
      equal_3913_s11_q <= equal_3913_s10_q;
      or_4063_s11_q <= or_4063_s10_q;
      and_4077_s11_q <= and_4077_s10_q;
      and_4094_s11_q <= and_4094_s10_q;
      not_4106_s11_q <= not_4106_s10_q;
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
  // hls/stages/moments.hpp:57
  logic [13:0] select_575;
  assign select_575 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:1019
  logic not_578;
  assign not_578 = ~equal_577_s11_q;
  // hls/stages/agreement.hpp:202
  logic not_580;
  assign not_580 = ~so_s11_q;
  // hls/stages/agreement.hpp:989
  logic [6:0] chosen;
  assign chosen = slot_s11_q[2] ? best_right_rdata_s11_q[14:8] : best_right_rdata_s11_q[28:22];
  // hls/stages/agreement.hpp:817
  logic or_766;
  assign or_766 = shift_first_s11_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1015;
  assign select_1015 = age_s11_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v;
  assign before_v = age_s11_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1543;
  assign sum_1543 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:761
  logic [6:0] select_1553;
  assign select_1553 = (sum_1548_s11_q < sum_1551_s11_q) ? sum_1551_s11_q : sum_1548_s11_q;
  // hls/stages/agreement.hpp:798
  logic and_1579;
  assign and_1579 = ends_cell_s11_q & inside_v_s11_q;
  logic and_1581;
  assign and_1581 = not_578 & (so_s11_q & and_1579);
  logic and_1705;
  assign and_1705 = not_578 & (so_s11_q & (ends_cell_s11_q & (inside_v_s11_q & right_3_s11_q)));
  // hls/stages/registration.hpp:83
  logic equal_1707;
  assign equal_1707 = slot_s11_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1710;
  assign select_1710 = b_s11_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1711;
  assign select_1711 = b_s11_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1712;
  assign sum_1712 = {{2{select_1710[6]}}, select_1710} + {select_1711[7], select_1711};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1713;
  assign select_1713 = b_s11_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1714;
  assign select_1714 = b_s11_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1715;
  assign sum_1715 = {{2{select_1713[7]}}, select_1713[7:1]} + {select_1714[7], select_1714};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1717;
  assign select_1717 = b_s11_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1718;
  assign select_1718 = b_s11_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1719;
  assign difference_1719 = {{2{select_1717[7]}}, select_1717[7:1]} - {select_1718[7], select_1718};
  // hls/stages/patches.hpp:104
  logic and_1729;
  assign and_1729 = less_1727_s11_q & (~right_3_s11_q);
  // hls/stages/agreement.hpp:1028
  logic and_1739;
  assign and_1739 = (~(and_1729 | (equal_572 | not_1731_s11_q))) & (less_1736_s11_q & less_1737_s11_q);
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1755;
  assign select_1755 = so_s11_q ? (ends_cell_s11_q ? (inside_v_s11_q ? b_s11_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1777;
  assign select_1777 = less_1774_s11_q ? 8'h7f : (less_1775_s11_q ? 8'h80 : sum_1773_s11_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1707 ? registration_slope_here_q : select_1777;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1781;
  assign select_1781 = so_s11_q ? (ends_cell_s11_q ? (inside_v_s11_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1787;
  assign and_1787 = ends_cell_s11_q & (inside_v_s11_q & (and_1729 | equal_1784_s11_q));
  logic and_1789;
  assign and_1789 = not_578 & (so_s11_q & and_1787);
  // hls/stages/patches.hpp:174
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1796_s11_q ? select_1879_s11_q : patches_left_rdata_s11_q;
  // hls/stages/patches.hpp:471
  logic [9:0] sum_1923;
  assign sum_1923 = {2'h0, patches_columns_above_rdata_s11_q[15:8]} + {1'b0, sum_1922_s11_q};
  // hls/stages/agreement.hpp:1122
  logic not_2138;
  assign not_2138 = ~(x_s11_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:798
  logic select_2144;
  assign select_2144 = less_2136_s11_q ? (not_2138 & not_2140_s11_q) : ((draws_late_q & not_2138) & not_2140_s11_q);
  logic and_2342;
  assign and_2342 = not_578 & (not_580 & (equal_581_s11_q & (inside_v_s11_q & first)));
  // hls/stages/agreement.hpp:530
  logic select_2587;
  assign select_2587 = and_552_s11_q ? (equal_2479_s11_q ? and_2585_s11_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:240
  logic [5:0] select_2589;
  assign select_2589 = slot_s11_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2590;
  assign select_2590 = slot_s11_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2591;
  assign select_2591 = slot_s11_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2592;
  assign select_2592 = slot_s11_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2593;
  assign select_2593 = slot_s11_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2594;
  assign select_2594 = slot_s11_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:996
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s11_q[61:54]} - {1'b0, best_left_rdata_s11_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2761;
  assign not_2761 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2750_s11_q ? {1'b0, wide_s11_q, 1'b0} : {registration_displacement_over_q[8:0], not_2761};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2769;
  assign select_2769 = registration_displacement_over_q[9] ? wide_s11_q : not_2768_s11_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2750_s11_q ? {taken_s11_q, 1'b1} : {not_2761, select_2769, not_2761};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2771;
  assign sum_2771 = {left, 1'b1} + {taken_2, less_2750_s11_q};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_2773;
  assign select_2773 = so_s11_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2775;
  assign select_2775 = equal_577_s11_q ? registration_slope_here_q : (so_s11_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:150
  logic [2:0] select_2784;
  assign select_2784 = or_582_s11_q ? (less_585_s11_q ? 3'h0 : best_left_rdata_s11_q[8:6]) : 3'h0;
  // hls/stages/agreement.hpp:798
  logic and_3019;
  assign and_3019 = not_578 & (so_s11_q & (ends_cell_s11_q & (inside_v_s11_q & not_3015_s11_q)));
  // hls/stages/patches.hpp:559
  logic [9:0] select_3536;
  assign select_3536 = less_1969_s11_q ? (or_1972_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3539;
  assign select_3539 = less_1969_s11_q ? (or_1972_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0) : 5'h0;

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

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1419; read in stage 11, written in stage 15: 11 < 15 < 11 + DISTANCE.
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
  assign seen_columns_re = s11_en & and_1581;
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
      moments_starts_q <= and_2342;
      draws_late_q <= select_2587;
      shift_not_right_q <= $signed(run_shift_s11_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s11_q ? sum_2771[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2773;
      registration_slope_here_q <= select_2775;
      patches_read_row_differing_q <= equal_1791_s11_q ? select_3536 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1791_s11_q ? select_3539 : patches_read_row_column_q;
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
      middle_sum_columns_values_1_q <= select_2589;
      middle_sum_columns_values_2_q <= select_2590;
      middle_sum_columns_values_3_q <= select_2591;
      middle_sum_columns_values_4_q <= select_2592;
      middle_sum_columns_values_5_q <= select_2593;
      middle_sum_columns_values_6_q <= select_2594;
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
  logic and_603_s12_q;
  logic and_612_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic less_623_s12_q;
  logic [6:0] select_630_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic [6:0] chosen_s12_q;
  logic not_641_s12_q;
  logic and_645_s12_q;
  logic and_650_s12_q;
  logic and_652_s12_q;
  logic equal_685_s12_q;
  logic select_768_s12_q;
  logic [6:0] difference_1016_s12_q;
  logic [6:0] difference_1265_s12_q;
  logic equal_1266_s12_q;
  logic [6:0] difference_1514_s12_q;
  logic [6:0] sum_1544_s12_q;
  logic [6:0] select_1553_s12_q;
  logic and_1568_s12_q;
  logic select_1570_s12_q;
  logic and_1579_s12_q;
  logic and_1581_s12_q;
  logic or_1589_s12_q;
  logic and_1598_s12_q;
  logic right_2_s12_q;
  logic and_1692_s12_q;
  logic and_1705_s12_q;
  logic less_1706_s12_q;
  logic equal_1707_s12_q;
  logic [7:0] sum_1712_s12_q;
  logic select_1713_s12_q;
  logic [8:0] sum_1715_s12_q;
  logic select_1717_s12_q;
  logic [8:0] difference_1719_s12_q;
  logic and_1739_s12_q;
  logic [5:0] select_1756_s12_q;
  logic [7:0] select_1782_s12_q;
  logic equal_1784_s12_q;
  logic and_1789_s12_q;
  logic and_1790_s12_q;
  logic equal_1791_s12_q;
  logic not_1792_s12_q;
  logic equal_1793_s12_q;
  logic not_1794_s12_q;
  logic equal_1795_s12_q;
  logic equal_1796_s12_q;
  logic or_1797_s12_q;
  logic not_1798_s12_q;
  logic [4:0] select_1821_s12_q;
  logic select_1827_s12_q;
  logic [3:0] select_1865_s12_q;
  logic and_1875_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] pixel_2_s12_q;
  logic [9:0] sum_1923_s12_q;
  logic less_1969_s12_q;
  logic equal_1970_s12_q;
  logic or_1972_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1996_s12_q;
  logic and_2018_s12_q;
  logic not_2058_s12_q;
  logic and_2145_s12_q;
  logic equal_2290_s12_q;
  logic equal_2479_s12_q;
  logic and_2585_s12_q;
  logic and_2616_s12_q;
  logic equal_2705_s12_q;
  logic rise_s12_q;
  logic [7:0] xor_2710_s12_q;
  logic select_2784_s12_q;
  logic or_2787_s12_q;
  logic [1:0] sum_2788_s12_q;
  logic less_2789_s12_q;
  logic and_3019_s12_q;
  logic or_3069_s12_q;
  logic not_3093_s12_q;
  logic equal_3585_s12_q;
  logic less_3841_s12_q;
  logic equal_3913_s12_q;
  logic or_4063_s12_q;
  logic and_4077_s12_q;
  logic and_4094_s12_q;
  logic not_4106_s12_q;
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
      and_603_s12_q <= and_603_s11_q;
      and_612_s12_q <= and_612_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      less_623_s12_q <= 8'hb6 < best_left_rdata_s11_q[16:9];
      select_630_s12_q <= select_630_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_s11_q;
      chosen_s12_q <= chosen;
      not_641_s12_q <= not_641_s11_q;
      and_645_s12_q <= and_645_s11_q;
      and_650_s12_q <= and_650_s11_q;
      and_652_s12_q <= and_652_s11_q;
      equal_685_s12_q <= equal_685_s11_q;
      select_768_s12_q <= or_766 ? shift_first_s11_q : (~age_s11_q[1]);
      difference_1016_s12_q <= {1'b0, column_s11_q} - {1'b0, select_1015};
      difference_1265_s12_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1264_s11_q};
      equal_1266_s12_q <= {age_s11_q[0], slot_s11_q[0]} == 2'h0;
      difference_1514_s12_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1513_s11_q};
      sum_1544_s12_q <= {1'b0, before_v} + sum_1543;
      select_1553_s12_q <= select_1553;
      and_1568_s12_q <= and_1568_s11_q;
      select_1570_s12_q <= or_766 ? shift_first_s11_q : equal_1569_s11_q;
      and_1579_s12_q <= and_1579;
      and_1581_s12_q <= and_1581;
      or_1589_s12_q <= or_1589_s11_q;
      and_1598_s12_q <= or_582_s11_q & (slot_s11_q[2] & not_586_s11_q);
      right_2_s12_q <= right_2_s11_q;
      and_1692_s12_q <= and_1692_s11_q;
      and_1705_s12_q <= and_1705;
      less_1706_s12_q <= less_1706_s11_q;
      equal_1707_s12_q <= equal_1707;
      sum_1712_s12_q <= sum_1712[8:1];
      select_1713_s12_q <= select_1713[0];
      sum_1715_s12_q <= sum_1715;
      select_1717_s12_q <= select_1717[0];
      difference_1719_s12_q <= difference_1719;
      and_1739_s12_q <= and_1739;
      select_1756_s12_q <= equal_577_s11_q ? 6'h0 : select_1755;
      select_1782_s12_q <= equal_577_s11_q ? 8'h0 : select_1781;
      equal_1784_s12_q <= equal_1784_s11_q;
      and_1789_s12_q <= and_1789;
      and_1790_s12_q <= patches_chooses_s11_q & and_1789;
      equal_1791_s12_q <= equal_1791_s11_q;
      not_1792_s12_q <= not_1792_s11_q;
      equal_1793_s12_q <= equal_1793_s11_q;
      not_1794_s12_q <= not_1794_s11_q;
      equal_1795_s12_q <= equal_1795_s11_q;
      equal_1796_s12_q <= equal_1796_s11_q;
      or_1797_s12_q <= or_1797_s11_q;
      not_1798_s12_q <= not_1798_s11_q;
      select_1821_s12_q <= select_1821_s11_q;
      select_1827_s12_q <= select_1827_s11_q;
      select_1865_s12_q <= select_1865_s11_q;
      and_1875_s12_q <= and_1875_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      pixel_2_s12_q <= pixel_2;
      sum_1923_s12_q <= sum_1923;
      less_1969_s12_q <= less_1969_s11_q;
      equal_1970_s12_q <= equal_1970_s11_q;
      or_1972_s12_q <= or_1972_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_1996_s12_q <= sum_1996_s11_q;
      and_2018_s12_q <= and_2018_s11_q;
      not_2058_s12_q <= not_2058_s11_q;
      and_2145_s12_q <= ends_cell_s11_q & select_2144;
      equal_2290_s12_q <= equal_2290_s11_q;
      equal_2479_s12_q <= equal_2479_s11_q;
      and_2585_s12_q <= and_2585_s11_q;
      and_2616_s12_q <= and_2616_s11_q;
      equal_2705_s12_q <= equal_2705_s11_q;
      rise_s12_q <= rise[8];
      xor_2710_s12_q <= rise[7:0] ^ {8{rise[8]}};
      select_2784_s12_q <= select_2784[0];
      or_2787_s12_q <= (select_2784 == 3'h0) | (select_2784 == 3'h4);
      sum_2788_s12_q <= select_2784[2:1] + 2'h3;
      less_2789_s12_q <= less_2789_s11_q;
      and_3019_s12_q <= and_3019;
      or_3069_s12_q <= or_3069_s11_q;
      not_3093_s12_q <= not_3093_s11_q;
      equal_3585_s12_q <= equal_3585_s11_q;
      less_3841_s12_q <= less_3841_s11_q;
      equal_3913_s12_q <= equal_3913_s11_q;
      or_4063_s12_q <= or_4063_s11_q;
      and_4077_s12_q <= and_4077_s11_q;
      and_4094_s12_q <= and_4094_s11_q;
      not_4106_s12_q <= not_4106_s11_q;
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
  // hls/stages/moments.hpp:63
  logic [10:0] place;
  assign place = first_s12_q ? 11'h0 : moments_place_q[13:3];
  // hls/stages/moments.hpp:104
  logic not_590;
  assign not_590 = ~(11'h3ec < place);
  // hls/stages/agreement.hpp:988
  logic select_625;
  assign select_625 = slot_s12_q[2] ? less_623_s12_q : (6'h2a < best_left_rdata_s12_q[39:34]);
  // hls/stages/agreement.hpp:1002
  logic [8:0] difference_635;
  assign difference_635 = {2'h0, chosen_s12_q} - {1'b0, x_s12_q};
  // hls/stages/agreement.hpp:788
  logic [7:0] sum_1018;
  assign sum_1018 = {difference_1016_s12_q[6], difference_1016_s12_q} + (age_s12_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1268;
  assign sum_1268 = {difference_1265_s12_q[6], difference_1265_s12_q} + (equal_1266_s12_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1516;
  assign sum_1516 = {difference_1514_s12_q[6], difference_1514_s12_q} + (equal_1266_s12_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:765
  logic [6:0] select_1545;
  assign select_1545 = slot_s12_q[0] ? chosen_near_q : sum_1544_s12_q;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_1555;
  assign select_1555 = (select_1545 < select_1553_s12_q) ? select_1553_s12_q : select_1545;
  // hls/stages/agreement.hpp:798
  logic [6:0] select_1585;
  assign select_1585 = so_s12_q ? x_s12_q[6:0] : (or_582_s12_q ? (less_585_s12_q ? 7'h0 : select_630_s12_q) : 7'h0);
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1716;
  assign sum_1716 = {{3{sum_1712_s12_q[7]}}, sum_1712_s12_q} + {sum_1715_s12_q[8], sum_1715_s12_q, select_1713_s12_q};
  logic [9:0] sum_1720;
  assign sum_1720 = {difference_1719_s12_q, select_1717_s12_q} + {sum_1716[10], sum_1716[10:2]};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_1903;
  assign sum_1903 = {1'b0, patches_columns_above_rdata_s12_q[7:0]} + {2'h0, pixel_2_s12_q[7:1]};
  logic [8:0] sum_1904;
  assign sum_1904 = {1'b0, patches_columns_above_rdata_s12_q[23:16]} + {2'h0, patches_columns_above_rdata_s12_q[31:25]};
  // hls/stages/patches.hpp:471
  logic [10:0] sum_1924;
  assign sum_1924 = {3'h0, patches_columns_above_rdata_s12_q[15:8]} + {sum_1923_s12_q, patches_columns_above_rdata_s12_q[25]};
  // hls/stages/agreement.hpp:240
  logic [6:0] select_2601;
  assign select_2601 = slot_s12_q[0] ? 7'h0 : sum_1544_s12_q;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_2603;
  assign select_2603 = (select_2601 < select_1553_s12_q) ? select_1553_s12_q : select_2601;
  // hls/stages/agreement.hpp:997
  logic [7:0] lower;
  assign lower = rise_s12_q ? best_left_rdata_s12_q[61:54] : best_left_rdata_s12_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2790;
  assign difference_2790 = {sum_2788_s12_q, select_2784_s12_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2791;
  assign select_2791 = less_2789_s12_q ? difference_2790 : {sum_2788_s12_q, select_2784_s12_q, registration_displacement_fraction_q};
  logic [7:0] select_2792;
  assign select_2792 = or_2787_s12_q ? {sum_2788_s12_q, select_2784_s12_q, 5'h0} : select_2791;
  // hls/stages/patches.hpp:191
  logic select_3108;
  assign select_3108 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:177
  logic and_3169;
  assign and_3169 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3174;
  assign select_3174 = or_3069_s12_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3176;
  assign select_3176 = and_3169 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:276
  logic select_3547;
  assign select_3547 = equal_1791_s12_q ? (less_1969_s12_q & (or_1972_s12_q & (patches_step_s12_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3552;
  assign or_3552 = patches_read_first_q | (patches_read_row_differing_s12_q < patches_peak_best_differing_q);
  logic and_3553;
  assign and_3553 = patches_read_searches_s12_q & or_3552;
  // hls/stages/patches.hpp:542
  logic [14:0] select_3573;
  assign select_3573 = and_3553 ? {patches_read_row_column_s12_q, patches_read_row_differing_s12_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3574;
  assign select_3574 = equal_1791_s12_q ? select_3573[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3575;
  assign select_3575 = equal_1791_s12_q ? select_3573[14:10] : patches_peak_best_column_q;
  // hls/stages/agreement.hpp:499
  logic [8:0] select_3843;
  assign select_3843 = equal_685_s12_q ? {difference_3842[7], difference_3842} : region_down_rest_q;
  // hls/stages/division.hpp:18
  logic [7:0] sum_3844;
  assign sum_3844 = select_3843[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3866;
  assign select_3866 = equal_2479_s12_q ? (less_3841_s12_q ? region_down_next_q : select_3843) : region_down_rest_q;
  // hls/stages/agreement.hpp:499
  logic [7:0] select_3869;
  assign select_3869 = equal_685_s12_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:530
  logic [7:0] select_3871;
  assign select_3871 = and_552_s12_q ? (equal_2479_s12_q ? select_3869 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3872;
  assign sum_3872 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:36
  logic [8:0] select_3874;
  assign select_3874 = sum_3872[7] ? {1'b1, sum_3872[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1391; read in stage 12, written in stage 15: 12 < 15 < 12 + DISTANCE.
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
  assign shown_right_re = s12_en & and_1581_s12_q;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1392; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
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
  assign left_turns_re = s12_en & and_1598_s12_q;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1392; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_630_s12_q;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s12_en & and_1598_s12_q;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s12_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s12_en & and_1875_s12_q;
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
      chosen_near_q <= select_2603;
      patches_along_ends_q <= not_3093_s12_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3093_s12_q & select_3108;
      patches_down_by_q <= or_3069_s12_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3169});
      patches_along_q <= select_3174;
      patches_match_row_q <= or_3069_s12_q ? 4'h0 : select_3176;
      patches_summed_last_q <= not_1792_s12_q & (equal_1793_s12_q & and_3169);
      patches_read_first_q <= select_3547;
      patches_peak_best_differing_q <= select_3574;
      patches_peak_best_column_q <= select_3575;
      region_down_rest_q <= and_552_s12_q ? select_3866 : region_down_rest_q;
      region_down_back_q <= select_3871;
      region_down_next_q <= select_3874;
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
      middle_sum_sum_sums_values_0_q <= slot_s12_q[0] ? middle_sum_sum_sums_values_0_q : sum_1018;
      sums_0_sum_sums_values_0_q <= sum_1268;
      sums_0_sum_sums_values_1_q <= equal_1266_s12_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1516;
      sums_1_sum_sums_values_1_q <= equal_1266_s12_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic and_603_s13_q;
  logic and_612_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_625_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic [9:0] sum_636_s13_q;
  logic not_641_s13_q;
  logic and_645_s13_q;
  logic and_650_s13_q;
  logic and_652_s13_q;
  logic equal_685_s13_q;
  logic select_768_s13_q;
  logic [7:0] sum_1018_s13_q;
  logic less_1517_s13_q;
  logic [6:0] select_1555_s13_q;
  logic [7:0] select_1563_s13_q;
  logic [7:0] select_1566_s13_q;
  logic and_1568_s13_q;
  logic select_1570_s13_q;
  logic and_1579_s13_q;
  logic and_1581_s13_q;
  logic [6:0] select_1585_s13_q;
  logic or_1589_s13_q;
  logic and_1607_s13_q;
  logic right_2_s13_q;
  logic and_1692_s13_q;
  logic and_1705_s13_q;
  logic less_1706_s13_q;
  logic equal_1707_s13_q;
  logic sum_1716_s13_q;
  logic [9:0] sum_1720_s13_q;
  logic and_1739_s13_q;
  logic [5:0] select_1756_s13_q;
  logic [7:0] select_1782_s13_q;
  logic equal_1784_s13_q;
  logic and_1789_s13_q;
  logic and_1790_s13_q;
  logic equal_1791_s13_q;
  logic not_1792_s13_q;
  logic equal_1793_s13_q;
  logic not_1794_s13_q;
  logic equal_1795_s13_q;
  logic equal_1796_s13_q;
  logic or_1797_s13_q;
  logic not_1798_s13_q;
  logic [4:0] select_1821_s13_q;
  logic select_1827_s13_q;
  logic [3:0] select_1865_s13_q;
  logic [8:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [4:0] sum_1889_s13_q;
  logic [8:0] sum_1903_s13_q;
  logic [8:0] sum_1904_s13_q;
  logic [10:0] sum_1924_s13_q;
  logic less_1969_s13_q;
  logic equal_1970_s13_q;
  logic or_1972_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1996_s13_q;
  logic and_2018_s13_q;
  logic [17:0] seen_columns_rdata_s13_q;
  logic not_2058_s13_q;
  logic and_2147_s13_q;
  logic equal_2290_s13_q;
  logic equal_2479_s13_q;
  logic and_2585_s13_q;
  logic and_2616_s13_q;
  logic equal_2705_s13_q;
  logic [7:0] lower_s13_q;
  logic [7:0] sum_2711_s13_q;
  logic [7:0] select_2792_s13_q;
  logic and_3019_s13_q;
  logic and_3553_s13_q;
  logic equal_3585_s13_q;
  logic less_3841_s13_q;
  logic sum_3844_s13_q;
  logic equal_3913_s13_q;
  logic or_4063_s13_q;
  logic and_4077_s13_q;
  logic and_4094_s13_q;
  logic not_4106_s13_q;
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
      and_603_s13_q <= and_603_s12_q;
      and_612_s13_q <= and_612_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q[45:0];
      select_625_s13_q <= select_625;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      sum_636_s13_q <= {difference_635[8], difference_635} + 10'h1;
      not_641_s13_q <= not_641_s12_q;
      and_645_s13_q <= and_645_s12_q;
      and_650_s13_q <= and_650_s12_q;
      and_652_s13_q <= and_652_s12_q;
      equal_685_s13_q <= equal_685_s12_q;
      select_768_s13_q <= select_768_s12_q;
      sum_1018_s13_q <= sum_1018;
      less_1517_s13_q <= sum_1268 < sum_1516;
      select_1555_s13_q <= select_1555;
      select_1563_s13_q <= select_768_s12_q ? 8'h0 : best_left_rdata_s12_q[53:46];
      select_1566_s13_q <= select_768_s12_q ? 8'h0 : best_left_rdata_s12_q[61:54];
      and_1568_s13_q <= and_1568_s12_q;
      select_1570_s13_q <= select_1570_s12_q;
      and_1579_s13_q <= and_1579_s12_q;
      and_1581_s13_q <= and_1581_s12_q;
      select_1585_s13_q <= select_1585;
      or_1589_s13_q <= or_1589_s12_q;
      and_1607_s13_q <= moments_taken_q;
      right_2_s13_q <= right_2_s12_q;
      and_1692_s13_q <= and_1692_s12_q;
      and_1705_s13_q <= and_1705_s12_q;
      less_1706_s13_q <= less_1706_s12_q;
      equal_1707_s13_q <= equal_1707_s12_q;
      sum_1716_s13_q <= sum_1716[1];
      sum_1720_s13_q <= sum_1720;
      and_1739_s13_q <= and_1739_s12_q;
      select_1756_s13_q <= select_1756_s12_q;
      select_1782_s13_q <= select_1782_s12_q;
      equal_1784_s13_q <= equal_1784_s12_q;
      and_1789_s13_q <= and_1789_s12_q;
      and_1790_s13_q <= and_1790_s12_q;
      equal_1791_s13_q <= equal_1791_s12_q;
      not_1792_s13_q <= not_1792_s12_q;
      equal_1793_s13_q <= equal_1793_s12_q;
      not_1794_s13_q <= not_1794_s12_q;
      equal_1795_s13_q <= equal_1795_s12_q;
      equal_1796_s13_q <= equal_1796_s12_q;
      or_1797_s13_q <= or_1797_s12_q;
      not_1798_s13_q <= not_1798_s12_q;
      select_1821_s13_q <= select_1821_s12_q;
      select_1827_s13_q <= select_1827_s12_q;
      select_1865_s13_q <= select_1865_s12_q;
      patches_columns_above_rdata_s13_q <= {patches_columns_above_rdata_s12_q[24], patches_columns_above_rdata_s12_q[7:0]};
      pixel_2_s13_q <= pixel_2_s12_q;
      sum_1889_s13_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1903_s13_q <= sum_1903;
      sum_1904_s13_q <= sum_1904;
      sum_1924_s13_q <= sum_1924;
      less_1969_s13_q <= less_1969_s12_q;
      equal_1970_s13_q <= equal_1970_s12_q;
      or_1972_s13_q <= or_1972_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1996_s13_q <= sum_1996_s12_q;
      and_2018_s13_q <= and_2018_s12_q;
      seen_columns_rdata_s13_q <= seen_columns_rdata_q;
      not_2058_s13_q <= not_2058_s12_q;
      and_2147_s13_q <= not_578_s12_q & (so_s12_q & and_2145_s12_q);
      equal_2290_s13_q <= equal_2290_s12_q;
      equal_2479_s13_q <= equal_2479_s12_q;
      and_2585_s13_q <= and_2585_s12_q;
      and_2616_s13_q <= and_2616_s12_q;
      equal_2705_s13_q <= equal_2705_s12_q;
      lower_s13_q <= lower;
      sum_2711_s13_q <= {7'h0, rise_s12_q} + xor_2710_s12_q;
      select_2792_s13_q <= select_2792;
      and_3019_s13_q <= and_3019_s12_q;
      and_3553_s13_q <= and_3553;
      equal_3585_s13_q <= equal_3585_s12_q;
      less_3841_s13_q <= less_3841_s12_q;
      sum_3844_s13_q <= sum_3844[7];
      equal_3913_s13_q <= equal_3913_s12_q;
      or_4063_s13_q <= or_4063_s12_q;
      and_4077_s13_q <= and_4077_s12_q;
      and_4094_s13_q <= and_4094_s12_q;
      not_4106_s13_q <= not_4106_s12_q;
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
  logic and_638;
  assign and_638 = (and_612_s13_q & select_625_s13_q) & ({{22{sum_636_s13_q[9]}}, sum_636_s13_q} < 32'h3);
  // hls/stages/agreement.hpp:765
  logic [7:0] select_1019;
  assign select_1019 = slot_s13_q[0] ? chosen_score_q : sum_1018_s13_q;
  // hls/stages/agreement.hpp:761
  logic [7:0] select_1518;
  assign select_1518 = less_1517_s13_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1519;
  assign less_1519 = select_1019 < select_1518;
  // hls/stages/agreement.hpp:811
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1519 ? select_1518 : select_1019) : 8'h0;
  // hls/stages/agreement.hpp:730
  logic not_1525;
  assign not_1525 = ~slot_s13_q[0];
  // hls/stages/agreement.hpp:762
  logic [1:0] select_1526;
  assign select_1526 = less_1517_s13_q ? {slot_s13_q[0], not_1525} : 2'h0;
  logic [2:0] select_1528;
  assign select_1528 = less_1519 ? {select_1526, not_1525} : (slot_s13_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:812
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1555_s13_q : 7'h0;
  // hls/stages/agreement.hpp:823
  logic less_1557;
  assign less_1557 = best_left_rdata_s13_q[39:33] < of_near;
  // hls/stages/agreement.hpp:1140
  logic equal_1614;
  assign equal_1614 = x_s13_q[6:4] == 3'h7;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s13_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:214
  logic equal_1628;
  assign equal_1628 = x_s13_q[5:0] == 6'h3c;
  logic equal_1630;
  assign equal_1630 = x_s13_q[5:0] == 6'h3b;
  logic equal_1632;
  assign equal_1632 = x_s13_q[5:0] == 6'h36;
  logic equal_1634;
  assign equal_1634 = x_s13_q[5:0] == 6'h35;
  logic equal_1636;
  assign equal_1636 = x_s13_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1190
  logic and_1640;
  assign and_1640 = (~equal_1630) & ((~equal_1632) & ((~equal_1634) & (~equal_1636)));
  // hls/stages/patches.hpp:377
  logic [1:0] select_1693;
  assign select_1693 = and_1692_s13_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1694;
  assign select_1694 = and_1692_s13_q ? patches_band_rows_number_s13_q : patches_band_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] select_1695;
  assign select_1695 = row_starts_s13_q ? {select_1694, select_1693[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1696;
  assign select_1696 = row_starts_s13_q ? select_1693 : patches_fetch_q;
  logic equal_1697;
  assign equal_1697 = select_1696 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1707_s13_q ? {sum_1720_s13_q, sum_1716_s13_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1804;
  assign select_1804 = row_starts_s13_q ? select_1694 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_1805;
  assign equal_1805 = {patches_choosing_band_s13_q, and_1705_s13_q} == {select_1804, select_1696[1]};
  // hls/stages/patches.hpp:504
  logic less_1881;
  assign less_1881 = 5'he < patches_along_s13_q;
  // hls/stages/patches.hpp:505
  logic or_1882;
  assign or_1882 = equal_1795_s13_q | less_1881;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_s13_q == 5'h0;
  logic select_1887;
  assign select_1887 = equal_1795_s13_q ? patches_column_s13_q[0] : (or_1882 ? (patches_along_s13_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:506
  logic [4:0] select_1890;
  assign select_1890 = patches_match_row_ends_s13_q ? patches_down_by_s13_q : sum_1889_s13_q;
  // hls/stages/patches.hpp:509
  logic [4:0] select_1893;
  assign select_1893 = equal_1795_s13_q ? 5'h0 : (or_1882 ? (select_1890 + 5'h1) : sum_1889_s13_q);
  // hls/stages/patches.hpp:485
  logic equal_1896;
  assign equal_1896 = patches_column_s13_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s13_q == 5'h11;
  logic equal_1898;
  assign equal_1898 = patches_column_s13_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_1900;
  assign and_1900 = of_row & (~equal_1898);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1896 ? 2'h3 : {equal_1898, and_1900};
  // hls/stages/patches.hpp:473
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1903_s13_q, pixel_2_s13_q[0]} - {1'b0, sum_1904_s13_q, patches_columns_above_rdata_s13_q[8]};
  // hls/stages/patches.hpp:471
  logic [9:0] sum_1925;
  assign sum_1925 = {2'h0, patches_columns_above_rdata_s13_q[7:0]} + sum_1924_s13_q[10:1];
  // hls/stages/patches.hpp:486
  logic or_1944;
  assign or_1944 = (((patches_column_s13_q == 5'ha) | of_row) | equal_1898) | equal_1896;
  // hls/stages/patches.hpp:481
  logic and_1949;
  assign and_1949 = (~(patches_code_row_s13_q[4:2] == 3'h0)) & (~(patches_column_s13_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:174
  logic and_1963;
  assign and_1963 = (~(equal_1796_s13_q | (~and_1949))) & (~patches_column_s13_q[4]);
  // hls/stages/agreement.hpp:206
  logic [7:0] select_1983;
  assign select_1983 = so_s13_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1061
  logic or_1986;
  assign or_1986 = select_1983[7] | (~({select_1983[5], select_1983[3], select_1983[1]} == 3'h0));
  // hls/stages/agreement.hpp:1060
  logic or_1989;
  assign or_1989 = select_1983[7] | (~({select_1983[6], select_1983[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1059
  logic or_1992;
  assign or_1992 = select_1983[7] | (~(select_1983[6:4] == 3'h0));
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1993;
  assign select_1993 = equal_577_s13_q ? x_s13_q[5:0] : {region_row_q, or_1992, or_1989, or_1986};
  // hls/stages/agreement.hpp:1140
  logic not_1994;
  assign not_1994 = ~equal_1614;
  // hls/stages/agreement.hpp:1069
  logic or_1998;
  assign or_1998 = (~sum_1996_s13_q) | equal_1784_s13_q;
  // hls/stages/agreement.hpp:798
  logic and_2001;
  assign and_2001 = so_s13_q & (ends_cell_s13_q & (inside_v_s13_q & or_1998));
  // hls/stages/agreement.hpp:1040
  logic [7:0] select_2086;
  assign select_2086 = inside_v_s13_q ? (sum_1996_s13_q ? select_1983 : {select_1983[6:0], 1'b0}) : select_1983;
  // hls/stages/agreement.hpp:1061
  logic or_2089;
  assign or_2089 = select_2086[7] | (~({select_2086[5], select_2086[3], select_2086[1]} == 3'h0));
  // hls/stages/agreement.hpp:277
  logic select_2203;
  assign select_2203 = sample_pair_whole_s13_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:240
  logic [7:0] select_2598;
  assign select_2598 = slot_s13_q[0] ? 8'h0 : sum_1018_s13_q;
  // hls/stages/agreement.hpp:761
  logic less_2599;
  assign less_2599 = select_2598 < select_1518;
  // hls/stages/agreement.hpp:798
  logic less_2605;
  assign less_2605 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2607;
  assign less_2607 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:998
  logic [7:0] difference_2709;
  assign difference_2709 = best_left_rdata_s13_q[16:9] - lower_s13_q;
  // hls/stages/agreement.hpp:798
  logic [10:0] select_2777;
  assign select_2777 = equal_577_s13_q ? registration_expected_q : (so_s13_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2792_s13_q[7]}}, select_2792_s13_q} - {sum_1720_s13_q[9], sum_1720_s13_q, sum_1716_s13_q};
  // hls/stages/patches.hpp:358
  logic not_3034;
  assign not_3034 = ~select_1696[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3036;
  assign select_3036 = sample_pair_whole_s13_q ? (equal_1697 ? select_1696 : {not_3034, 1'b0}) : patches_fetch_q;
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3531;
  assign select_3531 = equal_1793_s13_q ? patches_down_by_s13_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:559
  logic [4:0] select_3542;
  assign select_3542 = less_1969_s13_q ? (or_1972_s13_q ? patches_step_s13_q : 5'h0) : 5'h0;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3554;
  assign select_3554 = and_3553_s13_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s13_q} - {1'b0, select_3554};
  // hls/stages/agreement.hpp:465
  logic [2:0] select_3847;
  assign select_3847 = less_3841_s13_q ? (sum_3844_s13_q ? region_row_q : next_region_row_q) : (and_2585_s13_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:530
  logic [2:0] select_3849;
  assign select_3849 = and_552_s13_q ? (equal_2479_s13_q ? select_3847 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3853;
  assign select_3853 = equal_577_s13_q ? select_1983 : (so_s13_q ? (ends_cell_s13_q ? select_2086 : select_1983) : 8'h1);
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3844_s13_q;
  // hls/stages/agreement.hpp:465
  logic select_3878;
  assign select_3878 = equal_2479_s13_q ? (less_3841_s13_q ? next : (region_fresh_q | equal_685_s13_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1229
  logic equal_3896;
  assign equal_3896 = x_s13_q[6:3] == 4'h7;
  logic equal_3921;
  assign equal_3921 = x_s13_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1137
  logic [7:0] select_3936;
  assign select_3936 = (x_s13_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3938;
  assign select_3938 = equal_3921 ? cfg_unproven_skin_limit_i : (equal_3896 ? cfg_unproven_limit_i : select_3936);

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

  // Memory moments_memory, 8040 x 4, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 13, written in stage 14: 13 < 14 < 13 + DISTANCE.
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
      averager_running_of_skin_q <= select_2203;
      chosen_score_q <= less_2599 ? select_1518 : select_2598;
      chosen_place_q <= less_2599 ? {select_1526, not_1525} : 3'h2;
      before_0_q <= select_2598;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2605) & (~less_2607);
      registration_expected_q <= select_2777;
      patches_band_q <= sample_pair_whole_s13_q ? select_1804 : patches_band_q;
      patches_fetch_q <= select_3036;
      patches_summed_down_by_q <= equal_1791_s13_q ? patches_summed_down_by_q : select_3531;
      patches_read_at_q <= equal_1791_s13_q ? select_3542 : patches_read_at_q;
      patches_peak_row_q <= equal_1791_s13_q ? select_3554 : patches_peak_row_q;
      region_row_q <= select_3849;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3853;
      region_fresh_q <= and_552_s13_q ? select_3878 : region_fresh_q;
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
  logic and_603_s14_q;
  logic [6:0] x_s14_2_q;
  logic [32:0] best_left_rdata_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic and_639_s14_q;
  logic not_641_s14_q;
  logic and_645_s14_q;
  logic and_650_s14_q;
  logic and_652_s14_q;
  logic equal_685_s14_q;
  logic select_768_s14_q;
  logic [7:0] of_best_s14_q;
  logic [2:0] select_1528_s14_q;
  logic [6:0] of_near_s14_q;
  logic [6:0] select_1558_s14_q;
  logic [5:0] select_1560_s14_q;
  logic [7:0] select_1563_s14_q;
  logic [7:0] select_1566_s14_q;
  logic and_1568_s14_q;
  logic select_1570_s14_q;
  logic or_1576_s14_q;
  logic and_1579_s14_q;
  logic and_1581_s14_q;
  logic [1:0] shown_right_rdata_s14_q;
  logic [6:0] select_1585_s14_q;
  logic and_1590_s14_q;
  logic [1:0] left_turns_rdata_s14_q;
  logic and_1607_s14_q;
  logic [1:0] right_turns_rdata_s14_q;
  logic equal_1614_s14_q;
  logic all_s14_q;
  logic equal_1628_s14_q;
  logic equal_1630_s14_q;
  logic equal_1632_s14_q;
  logic equal_1634_s14_q;
  logic equal_1636_s14_q;
  logic and_1641_s14_q;
  logic right_2_s14_q;
  logic [5:0] select_1695_s14_q;
  logic select_1696_s14_q;
  logic equal_1697_s14_q;
  logic and_1705_s14_q;
  logic less_1706_s14_q;
  logic equal_1707_s14_q;
  logic expected_s14_q;
  logic [10:0] sum_1722_s14_q;
  logic and_1739_s14_q;
  logic [5:0] select_1756_s14_q;
  logic [7:0] select_1782_s14_q;
  logic and_1789_s14_q;
  logic and_1790_s14_q;
  logic equal_1791_s14_q;
  logic not_1792_s14_q;
  logic equal_1793_s14_q;
  logic not_1794_s14_q;
  logic equal_1796_s14_q;
  logic or_1797_s14_q;
  logic not_1798_s14_q;
  logic and_1806_s14_q;
  logic [4:0] select_1821_s14_q;
  logic select_1827_s14_q;
  logic [3:0] select_1865_s14_q;
  logic patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic less_1881_s14_q;
  logic new_row_s14_q;
  logic select_1887_s14_q;
  logic not_1888_s14_q;
  logic [4:0] select_1893_s14_q;
  logic or_1894_s14_q;
  logic [1:0] of_row_2_s14_q;
  logic [10:0] down_2_s14_q;
  logic sum_1924_s14_q;
  logic [9:0] sum_1925_s14_q;
  logic and_1952_s14_q;
  logic and_1963_s14_q;
  logic and_1966_s14_q;
  logic less_1969_s14_q;
  logic equal_1970_s14_q;
  logic or_1972_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic or_1986_s14_q;
  logic or_1989_s14_q;
  logic or_1992_s14_q;
  logic [5:0] select_1993_s14_q;
  logic not_1994_s14_q;
  logic select_2002_s14_q;
  logic and_2005_s14_q;
  logic and_2020_s14_q;
  logic and_2028_s14_q;
  logic [12:0] seen_columns_rdata_s14_q;
  logic not_2058_s14_q;
  logic and_2072_s14_q;
  logic and_2074_s14_q;
  logic or_2089_s14_q;
  logic or_2092_s14_q;
  logic or_2095_s14_q;
  logic and_2106_s14_q;
  logic and_2122_s14_q;
  logic and_2147_s14_q;
  logic equal_2290_s14_q;
  logic equal_2479_s14_q;
  logic and_2616_s14_q;
  logic and_2643_s14_q;
  logic and_2704_s14_q;
  logic equal_2705_s14_q;
  logic [5:0] difference_2709_s14_q;
  logic [7:0] sum_2711_s14_q;
  logic [11:0] select_2795_s14_q;
  logic and_3019_s14_q;
  logic less_3145_s14_q;
  logic [5:0] away_s14_q;
  logic [9:0] select_3574_s14_q;
  logic [4:0] select_3575_s14_q;
  logic equal_3585_s14_q;
  logic select_3885_s14_q;
  logic equal_3896_s14_q;
  logic equal_3913_s14_q;
  logic equal_3921_s14_q;
  logic [7:0] select_3938_s14_q;
  logic and_4051_s14_q;
  logic or_4063_s14_q;
  logic and_4077_s14_q;
  logic and_4094_s14_q;
  logic not_4106_s14_q;
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
      and_603_s14_q <= and_603_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[32:0];
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      and_639_s14_q <= not_586_s13_q & and_638;
      not_641_s14_q <= not_641_s13_q;
      and_645_s14_q <= and_645_s13_q;
      and_650_s14_q <= and_650_s13_q;
      and_652_s14_q <= and_652_s13_q;
      equal_685_s14_q <= equal_685_s13_q;
      select_768_s14_q <= select_768_s13_q;
      of_best_s14_q <= of_best;
      select_1528_s14_q <= select_1528;
      of_near_s14_q <= of_near;
      select_1558_s14_q <= less_1557 ? of_near : best_left_rdata_s13_q[39:33];
      select_1560_s14_q <= less_1557 ? run_shift_s13_q : best_left_rdata_s13_q[45:40];
      select_1563_s14_q <= select_1563_s13_q;
      select_1566_s14_q <= select_1566_s13_q;
      and_1568_s14_q <= and_1568_s13_q;
      select_1570_s14_q <= select_1570_s13_q;
      or_1576_s14_q <= select_1570_s13_q | (best_right_rdata_s13_q[21:15] < of_near);
      and_1579_s14_q <= and_1579_s13_q;
      and_1581_s14_q <= and_1581_s13_q;
      shown_right_rdata_s14_q <= shown_right_rdata_q;
      select_1585_s14_q <= select_1585_s13_q;
      and_1590_s14_q <= and_638 & or_1589_s13_q;
      left_turns_rdata_s14_q <= left_turns_rdata_q;
      and_1607_s14_q <= and_1607_s13_q;
      right_turns_rdata_s14_q <= right_turns_rdata_q;
      equal_1614_s14_q <= equal_1614;
      all_s14_q <= all;
      equal_1628_s14_q <= equal_1628;
      equal_1630_s14_q <= equal_1630;
      equal_1632_s14_q <= equal_1632;
      equal_1634_s14_q <= equal_1634;
      equal_1636_s14_q <= equal_1636;
      and_1641_s14_q <= (~equal_1628) & and_1640;
      right_2_s14_q <= right_2_s13_q;
      select_1695_s14_q <= select_1695;
      select_1696_s14_q <= select_1696[1];
      equal_1697_s14_q <= equal_1697;
      and_1705_s14_q <= and_1705_s13_q;
      less_1706_s14_q <= less_1706_s13_q;
      equal_1707_s14_q <= equal_1707_s13_q;
      expected_s14_q <= expected[0];
      sum_1722_s14_q <= {expected[10], expected[10:1]} + 11'h5;
      and_1739_s14_q <= and_1739_s13_q;
      select_1756_s14_q <= select_1756_s13_q;
      select_1782_s14_q <= select_1782_s13_q;
      and_1789_s14_q <= and_1789_s13_q;
      and_1790_s14_q <= and_1790_s13_q;
      equal_1791_s14_q <= equal_1791_s13_q;
      not_1792_s14_q <= not_1792_s13_q;
      equal_1793_s14_q <= equal_1793_s13_q;
      not_1794_s14_q <= not_1794_s13_q;
      equal_1796_s14_q <= equal_1796_s13_q;
      or_1797_s14_q <= or_1797_s13_q;
      not_1798_s14_q <= not_1798_s13_q;
      and_1806_s14_q <= and_1790_s13_q & equal_1805;
      select_1821_s14_q <= select_1821_s13_q;
      select_1827_s14_q <= select_1827_s13_q;
      select_1865_s14_q <= select_1865_s13_q;
      patches_columns_above_rdata_s14_q <= patches_columns_above_rdata_s13_q[8];
      pixel_2_s14_q <= pixel_2_s13_q;
      less_1881_s14_q <= less_1881;
      new_row_s14_q <= new_row;
      select_1887_s14_q <= select_1887;
      not_1888_s14_q <= ~or_1882;
      select_1893_s14_q <= select_1893;
      or_1894_s14_q <= equal_1795_s13_q | equal_1793_s13_q;
      of_row_2_s14_q <= of_row_2;
      down_2_s14_q <= down_2;
      sum_1924_s14_q <= sum_1924_s13_q[0];
      sum_1925_s14_q <= sum_1925;
      and_1952_s14_q <= or_1797_s13_q & (or_1944 & (equal_1796_s13_q & and_1949));
      and_1963_s14_q <= and_1963;
      and_1966_s14_q <= or_1797_s13_q & (and_1963 & (patches_column_s13_q == 5'hf));
      less_1969_s14_q <= less_1969_s13_q;
      equal_1970_s14_q <= equal_1970_s13_q;
      or_1972_s14_q <= or_1972_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      or_1986_s14_q <= or_1986;
      or_1989_s14_q <= or_1989;
      or_1992_s14_q <= or_1992;
      select_1993_s14_q <= select_1993;
      not_1994_s14_q <= not_1994;
      select_2002_s14_q <= equal_577_s13_q ? (x_s13_q[6] & not_1994) : and_2001;
      and_2005_s14_q <= or_582_s13_q & (not_586_s13_q & and_612_s13_q);
      and_2020_s14_q <= or_582_s13_q & (not_586_s13_q & and_2018_s13_q);
      and_2028_s14_q <= not_578_s13_q & and_2001;
      seen_columns_rdata_s14_q <= {seen_columns_rdata_s13_q[13:7], seen_columns_rdata_s13_q[5:0]};
      not_2058_s14_q <= not_2058_s13_q;
      and_2072_s14_q <= seen_columns_rdata_s13_q[14] & inside_v_s13_q;
      and_2074_s14_q <= seen_columns_rdata_s13_q[5] & inside_v_s13_q;
      or_2089_s14_q <= or_2089;
      or_2092_s14_q <= select_2086[7] | (~({select_2086[6], select_2086[3:2]} == 3'h0));
      or_2095_s14_q <= select_2086[7] | (~(select_2086[6:4] == 3'h0));
      and_2106_s14_q <= seen_columns_rdata_s13_q[16] & inside_v_s13_q;
      and_2122_s14_q <= seen_columns_rdata_s13_q[17] & inside_v_s13_q;
      and_2147_s14_q <= and_2147_s13_q;
      equal_2290_s14_q <= equal_2290_s13_q;
      equal_2479_s14_q <= equal_2479_s13_q;
      and_2616_s14_q <= and_2616_s13_q;
      and_2643_s14_q <= seen_columns_rdata_s13_q[15] & inside_v_s13_q;
      and_2704_s14_q <= and_2018_s13_q & and_638;
      equal_2705_s14_q <= equal_2705_s13_q;
      difference_2709_s14_q <= difference_2709[7:2];
      sum_2711_s14_q <= sum_2711_s13_q;
      select_2795_s14_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_3019_s14_q <= and_3019_s13_q;
      less_3145_s14_q <= 4'he < patches_column_s13_q[4:1];
      away_s14_q <= away;
      select_3574_s14_q <= patches_peak_best_differing_q;
      select_3575_s14_q <= patches_peak_best_column_q;
      equal_3585_s14_q <= equal_3585_s13_q;
      select_3885_s14_q <= sum_1996_s13_q ? (equal_1784_s13_q & or_1998) : or_1998;
      equal_3896_s14_q <= equal_3896;
      equal_3913_s14_q <= equal_3913_s13_q;
      equal_3921_s14_q <= equal_3921;
      select_3938_s14_q <= select_3938;
      and_4051_s14_q <= seen_columns_rdata_s13_q[6] & inside_v_s13_q;
      or_4063_s14_q <= or_4063_s13_q;
      and_4077_s14_q <= and_4077_s13_q;
      and_4094_s14_q <= and_4094_s13_q;
      not_4106_s14_q <= not_4106_s13_q;
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
  logic and_640;
  assign and_640 = or_582_s14_q & and_639_s14_q;
  // hls/stages/agreement.hpp:263
  logic and_642;
  assign and_642 = and_640 & not_641_s14_q;
  // hls/stages/moments.hpp:77
  logic and_643;
  assign and_643 = and_603_s14_q & and_642;
  // hls/stages/agreement.hpp:820
  logic equal_1531;
  assign equal_1531 = select_1528_s14_q == 3'h1;
  logic or_1534;
  assign or_1534 = equal_1531 | (~(select_1528_s14_q == 3'h2));
  logic [7:0] select_1536;
  assign select_1536 = or_1534 ? before_0_s14_q : before_1_s14_q;
  logic [7:0] select_1537;
  assign select_1537 = equal_1531 ? (or_1534 ? before_1_q : {7'h0, shift_not_right_s14_q}) : select_1536;
  // hls/stages/agreement.hpp:821
  logic [7:0] select_1540;
  assign select_1540 = equal_1531 ? select_1536 : (or_1534 ? before_2_q : before_2_s14_q);
  // hls/stages/agreement.hpp:834
  logic or_1572;
  assign or_1572 = select_1570_s14_q | (best_right_rdata_s14_q[7:0] < of_best_s14_q);
  // hls/stages/agreement.hpp:150
  logic and_1592;
  assign and_1592 = or_582_s14_q & (not_586_s14_q & and_1590_s14_q);
  // hls/stages/agreement.hpp:798
  logic and_1596;
  assign and_1596 = not_578_s14_q & (so_s14_q ? and_1579_s14_q : (equal_581_s14_q & and_640));
  // hls/stages/agreement.hpp:1190
  logic [1:0] quarter;
  assign quarter = x_s14_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1141
  logic [1:0] select_1617;
  assign select_1617 = x_s14_q[4] ? {x_s14_q[3], x_s14_q[0]} : {x_s14_q[0], x_s14_q[3]};
  // hls/stages/agreement.hpp:1154
  logic [3:0] select_1619;
  assign select_1619 = equal_1614_s14_q ? {2'h0, quarter} : (all_s14_q ? {1'b0, x_s14_q[2:0]} : {x_s14_q[2:1], select_1617});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1620;
  assign sum_1620 = slot_s14_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_1621;
  assign select_1621 = equal_577_s14_q ? select_1619 : {sum_1620, lower_half_s14_q, registration_of_right_q};
  // hls/stages/patches.hpp:214
  logic equal_1622;
  assign equal_1622 = x_s14_q[5:0] == 6'h3f;
  logic equal_1624;
  assign equal_1624 = x_s14_q[5:0] == 6'h3e;
  logic equal_1626;
  assign equal_1626 = x_s14_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1190
  logic and_1644;
  assign and_1644 = (~equal_1622) & ((~equal_1624) & ((~equal_1626) & and_1641_s14_q));
  // hls/stages/agreement.hpp:1141
  logic less_1645;
  assign less_1645 = x_s14_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s14_q ? {1'b0, x_s14_q[2]} : x_s14_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1649;
  assign or_1649 = (kind == 2'h3) | (x_s14_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s14_q ? (right_2_s14_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1660;
  assign sum_1660 = {2'h0, slot_s14_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1666;
  assign not_1666 = ~lower_half_s14_q;
  logic [3:0] select_1667;
  assign select_1667 = registration_of_right_q ? {lower_half_s14_q, 1'b0, not_1666, 1'b0} : {1'b0, lower_half_s14_q, 1'b0, not_1666};
  // hls/stages/patches.hpp:98
  logic less_1723;
  assign less_1723 = {{4{sum_1722_s14_q[10]}}, sum_1722_s14_q, expected_s14_q} < 16'h15;
  // hls/stages/patches.hpp:475
  logic [11:0] sum_1906;
  assign sum_1906 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1907;
  assign sum_1907 = {{4{down_2_s14_q[10]}}, down_2_s14_q[10:2]} + {sum_1906[11], sum_1906};
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_1925_s14_q, sum_1924_s14_q, patches_columns_above_rdata_s14_q} + {4'h0, pixel_2_s14_q};
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s14_q & and_2005_s14_q;
  // hls/stages/agreement.hpp:1024
  logic select_2033;
  assign select_2033 = slot_s14_q[2] ? shown_shown_q : and_640;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s14_q & (shown_right_rdata_s14_q[0] | select_2033);
  // hls/stages/agreement.hpp:1024
  logic select_2036;
  assign select_2036 = slot_s14_q[2] ? shown_nearer_q : and_1592;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s14_q & (select_2033 ? select_2036 : shown_right_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:1287
  logic select_2056;
  assign select_2056 = marks_first_s14_q ? (done_s14_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2181;
  assign select_2181 = sample_pair_whole_s14_q ? (and_550_s14_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2183;
  assign select_2183 = sample_pair_whole_s14_q ? (and_550_s14_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2205;
  assign select_2205 = sample_pair_whole_s14_q ? (and_550_s14_q ? select_565 : averager_mask_q) : averager_mask_q;
  logic select_2207;
  assign select_2207 = sample_pair_whole_s14_q ? (and_550_s14_q ? select_569 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:798
  logic and_2619;
  assign and_2619 = ends_cell_s14_q & (inside_v_s14_q & (and_2616_s14_q & not_641_s14_q));
  // hls/stages/agreement.hpp:1117
  logic not_2642;
  assign not_2642 = ~((draws_late_s14_q & not_641_s14_q) | (x_s14_q[7:1] == 7'h0));
  // hls/stages/agreement.hpp:263
  logic and_2683;
  assign and_2683 = inside_v_s14_q & (not_641_s14_q & (and_2616_s14_q & and_2020_s14_q));
  // hls/stages/agreement.hpp:1122
  logic and_2690;
  assign and_2690 = not_2642 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:248
  logic and_2714;
  assign and_2714 = (and_2704_s14_q & equal_2705_s14_q) & (~({2'h0, difference_2709_s14_q} < sum_2711_s14_q));
  // hls/stages/agreement.hpp:150
  logic and_2725;
  assign and_2725 = not_586_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_2727;
  assign and_2727 = not_586_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2728;
  assign select_2728 = or_582_s14_q ? {and_2727, and_2725} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_2730;
  assign select_2730 = less_585_s14_q ? 2'h0 : (slot_s14_q[2] ? right_turns_rdata_s14_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2731;
  assign select_2731 = or_582_s14_q ? select_2730 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2778;
  assign equal_2778 = slot_s14_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2795_s14_q[11:7])) ? 12'h7f : select_2795_s14_q;
  // hls/stages/agreement.hpp:798
  logic select_2839;
  assign select_2839 = so_s14_q ? (equal_2778 ? right_2_s14_q : registration_of_right_q) : registration_of_right_q;
  logic select_2842;
  assign select_2842 = so_s14_q ? (equal_1707_s14_q ? inside_v_s14_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1141
  logic [1:0] quarter_2;
  assign quarter_2 = all_s14_q ? x_s14_q[1:0] : select_1617;
  // hls/stages/agreement.hpp:276
  logic [10:0] select_3123;
  assign select_3123 = equal_1793_s14_q ? patches_down_values_0_q : (or_1797_s14_q ? down_2_s14_q : patches_down_values_0_q);
  logic [10:0] select_3125;
  assign select_3125 = or_1797_s14_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3127;
  assign select_3127 = equal_1791_s14_q ? patches_down_values_1_q : (equal_1793_s14_q ? patches_down_values_1_q : select_3125);
  // hls/stages/patches.hpp:559
  logic and_3559;
  assign and_3559 = less_1969_s14_q & (or_1972_s14_q & (equal_1970_s14_q & (away_s14_q == 6'h3f)));
  logic and_3564;
  assign and_3564 = less_1969_s14_q & (or_1972_s14_q & (equal_1970_s14_q & (away_s14_q == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3566;
  assign sum_3566 = {away_s14_q[5], away_s14_q} + 7'h7d;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3577;
  assign select_3577 = patches_read_above_q ? patches_read_row_differing_s14_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3578;
  assign select_3578 = equal_1791_s14_q ? select_3577 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_3579;
  assign select_3579 = patches_read_below_q ? patches_read_row_differing_s14_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3580;
  assign select_3580 = equal_1791_s14_q ? select_3579 : patches_peak_below_q;
  // hls/stages/agreement.hpp:798
  logic select_3838;
  assign select_3838 = equal_577_s14_q ? shown_shown_q : (so_s14_q ? select_2033 : shown_shown_q);
  logic select_3840;
  assign select_3840 = equal_577_s14_q ? shown_nearer_q : (so_s14_q ? select_2036 : shown_nearer_q);
  // hls/stages/agreement.hpp:206
  logic or_3883;
  assign or_3883 = segment_starts_q | not_580_s14_q;
  // hls/stages/agreement.hpp:798
  logic select_3887;
  assign select_3887 = ends_cell_s14_q ? (inside_v_s14_q ? select_3885_s14_q : or_3883) : or_3883;
  // hls/stages/agreement.hpp:1229
  logic equal_3916;
  assign equal_3916 = x_s14_q[6:3] == 4'ha;
  logic equal_3919;
  assign equal_3919 = x_s14_q[6:3] == 4'hb;
  logic equal_3920;
  assign equal_3920 = x_s14_q[6:3] == 4'h9;
  // hls/stages/agreement.hpp:1137
  logic [7:0] select_3940;
  assign select_3940 = equal_3916 ? cfg_regions_limit_i : (equal_3920 ? cfg_hidden_limit_i : select_3938_s14_q);
  // hls/stages/agreement.hpp:798
  logic select_4049;
  assign select_4049 = so_s14_q ? (ends_cell_s14_q ? and_2074_s14_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4053;
  assign select_4053 = so_s14_q ? (ends_cell_s14_q ? and_4051_s14_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4055;
  assign select_4055 = ends_cell_s14_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4057;
  assign select_4057 = equal_577_s14_q ? centres_values_1_textured_q : (so_s14_q ? select_4055 : centres_values_1_textured_q);
  logic select_4058;
  assign select_4058 = ends_cell_s14_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4060;
  assign select_4060 = equal_577_s14_q ? centres_values_1_of_skin_q : (so_s14_q ? select_4058 : centres_values_1_of_skin_q);

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:777; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1695_s14_q;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s14_en & (sample_pair_whole_s14_q & (~equal_1697_s14_q));
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
  assign patches_right_codes_raddr = {select_1893_s14_q, not_1888_s14_q, select_1887_s14_q};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s14_en & or_1894_s14_q;
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
  assign patches_left_codes_re = s14_en & (not_1792_s14_q & (new_row_s14_q & equal_1793_s14_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1412; read in stage 14, written in stage 17: 14 < 17 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1993_s14_q;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s14_en & select_2002_s14_q;
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
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_652_s14_q, and_650_s14_q, and_645_s14_q, and_643};
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
      averager_mask_q <= select_2205;
      averager_of_skin_q <= select_2207;
      registration_of_right_q <= equal_577_s14_q ? registration_of_right_q : select_2839;
      registration_was_inside_q <= equal_577_s14_q ? registration_was_inside_q : select_2842;
      patches_down_values_0_q <= equal_1791_s14_q ? patches_down_values_0_q : select_3123;
      patches_down_values_1_q <= select_3127;
      patches_read_above_q <= equal_1791_s14_q ? and_3559 : patches_read_above_q;
      patches_read_below_q <= equal_1791_s14_q ? and_3564 : patches_read_below_q;
      patches_peak_above_q <= select_3578;
      patches_peak_below_q <= select_3580;
      shown_shown_q <= select_3838;
      shown_nearer_q <= select_3840;
      segment_starts_q <= equal_577_s14_q ? or_3883 : (so_s14_q ? select_3887 : or_3883);
      centres_values_0_textured_q <= equal_577_s14_q ? centres_values_0_textured_q : select_4049;
      centres_values_0_of_skin_q <= equal_577_s14_q ? centres_values_0_of_skin_q : select_4053;
      centres_values_1_textured_q <= select_4057;
      centres_values_1_of_skin_q <= select_4060;
      write_half_q <= marks_first_s14_q ? (write_half_q ^ done_s14_q) : write_half_q;
      read_half_q <= select_2056;
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
      averager_total_0_q <= select_2181;
      averager_total_1_q <= select_2183;
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
  logic and_640_s15_q;
  logic not_641_s15_q;
  logic and_645_s15_q;
  logic and_652_s15_q;
  logic equal_685_s15_q;
  logic [7:0] of_best_s15_q;
  logic or_1523_s15_q;
  logic [2:0] select_1528_s15_q;
  logic [7:0] select_1537_s15_q;
  logic [7:0] select_1540_s15_q;
  logic [6:0] select_1559_s15_q;
  logic [5:0] select_1561_s15_q;
  logic [7:0] select_1564_s15_q;
  logic [7:0] select_1567_s15_q;
  logic and_1568_s15_q;
  logic or_1572_s15_q;
  logic [6:0] select_1577_s15_q;
  logic [6:0] select_1578_s15_q;
  logic and_1581_s15_q;
  logic [6:0] select_1585_s15_q;
  logic and_1592_s15_q;
  logic and_1596_s15_q;
  logic and_1607_s15_q;
  logic equal_1614_s15_q;
  logic [1:0] quarter_s15_q;
  logic all_s15_q;
  logic [1:0] sum_1620_s15_q;
  logic [3:0] select_1621_s15_q;
  logic equal_1622_s15_q;
  logic equal_1624_s15_q;
  logic equal_1626_s15_q;
  logic equal_1628_s15_q;
  logic equal_1630_s15_q;
  logic equal_1632_s15_q;
  logic equal_1634_s15_q;
  logic equal_1636_s15_q;
  logic less_1645_s15_q;
  logic or_1649_s15_q;
  logic select_1652_s15_q;
  logic and_1662_s15_q;
  logic [3:0] select_1667_s15_q;
  logic select_1696_s15_q;
  logic equal_1697_s15_q;
  logic and_1705_s15_q;
  logic equal_1707_s15_q;
  logic and_1740_s15_q;
  logic [5:0] select_1756_s15_q;
  logic [7:0] select_1782_s15_q;
  logic and_1789_s15_q;
  logic and_1790_s15_q;
  logic equal_1791_s15_q;
  logic equal_1793_s15_q;
  logic equal_1796_s15_q;
  logic or_1797_s15_q;
  logic not_1798_s15_q;
  logic and_1806_s15_q;
  logic [4:0] select_1821_s15_q;
  logic select_1827_s15_q;
  logic [3:0] select_1865_s15_q;
  logic less_1881_s15_q;
  logic new_row_s15_q;
  logic or_1894_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [1:0] down_2_s15_q;
  logic [12:0] sum_1907_s15_q;
  logic [11:0] smooth_s15_q;
  logic and_1954_s15_q;
  logic and_1963_s15_q;
  logic and_1968_s15_q;
  logic less_1969_s15_q;
  logic or_1972_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic or_1986_s15_q;
  logic or_1989_s15_q;
  logic or_1992_s15_q;
  logic not_1994_s15_q;
  logic and_2007_s15_q;
  logic and_2012_s15_q;
  logic and_2020_s15_q;
  logic and_2028_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic textured_s15_q;
  logic shown_s15_q;
  logic near_s15_q;
  logic not_2058_s15_q;
  logic select_2070_s15_q;
  logic and_2072_s15_q;
  logic and_2074_s15_q;
  logic or_2089_s15_q;
  logic or_2092_s15_q;
  logic or_2095_s15_q;
  logic and_2106_s15_q;
  logic and_2108_s15_q;
  logic and_2109_s15_q;
  logic and_2122_s15_q;
  logic and_2124_s15_q;
  logic and_2125_s15_q;
  logic and_2147_s15_q;
  logic equal_2290_s15_q;
  logic equal_2479_s15_q;
  logic and_2621_s15_q;
  logic not_2642_s15_q;
  logic and_2643_s15_q;
  logic and_2645_s15_q;
  logic and_2646_s15_q;
  logic and_2686_s15_q;
  logic and_2693_s15_q;
  logic and_2717_s15_q;
  logic select_2728_s15_q;
  logic select_2731_s15_q;
  logic and_2732_s15_q;
  logic and_2781_s15_q;
  logic and_2782_s15_q;
  logic [11:0] residual_s15_q;
  logic equal_2844_s15_q;
  logic [3:0] not_2845_s15_q;
  logic [1:0] quarter_2_s15_q;
  logic and_3019_s15_q;
  logic less_3145_s15_q;
  logic equal_3488_s15_q;
  logic and_3568_s15_q;
  logic [9:0] select_3574_s15_q;
  logic [4:0] select_3575_s15_q;
  logic [4:0] select_3576_s15_q;
  logic equal_3585_s15_q;
  logic less_3613_s15_q;
  logic less_3616_s15_q;
  logic equal_3896_s15_q;
  logic equal_3913_s15_q;
  logic equal_3916_s15_q;
  logic equal_3919_s15_q;
  logic equal_3920_s15_q;
  logic equal_3921_s15_q;
  logic [7:0] select_3941_s15_q;
  logic or_4063_s15_q;
  logic and_4077_s15_q;
  logic and_4094_s15_q;
  logic not_4106_s15_q;
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
      and_640_s15_q <= and_640;
      not_641_s15_q <= not_641_s14_q;
      and_645_s15_q <= and_645_s14_q;
      and_652_s15_q <= and_652_s14_q;
      equal_685_s15_q <= equal_685_s14_q;
      of_best_s15_q <= of_best_s14_q;
      or_1523_s15_q <= select_768_s14_q | (best_left_rdata_s14_q[16:9] < of_best_s14_q);
      select_1528_s15_q <= select_1528_s14_q;
      select_1537_s15_q <= select_1537;
      select_1540_s15_q <= select_1540;
      select_1559_s15_q <= select_768_s14_q ? of_near_s14_q : select_1558_s14_q;
      select_1561_s15_q <= select_768_s14_q ? run_shift_s14_q : select_1560_s14_q;
      select_1564_s15_q <= (run_shift_s14_q == 6'h3f) ? of_best_s14_q : select_1563_s14_q;
      select_1567_s15_q <= (run_shift_s14_q == 6'h1) ? of_best_s14_q : select_1566_s14_q;
      and_1568_s15_q <= and_1568_s14_q;
      or_1572_s15_q <= or_1572;
      select_1577_s15_q <= or_1576_s14_q ? of_near_s14_q : best_right_rdata_s14_q[21:15];
      select_1578_s15_q <= or_1576_s14_q ? x_s14_2_q : best_right_rdata_s14_q[28:22];
      and_1581_s15_q <= and_1581_s14_q;
      select_1585_s15_q <= select_1585_s14_q;
      and_1592_s15_q <= and_1592;
      and_1596_s15_q <= and_1596;
      and_1607_s15_q <= and_1607_s14_q;
      equal_1614_s15_q <= equal_1614_s14_q;
      quarter_s15_q <= quarter;
      all_s15_q <= all_s14_q;
      sum_1620_s15_q <= sum_1620;
      select_1621_s15_q <= select_1621;
      equal_1622_s15_q <= equal_1622;
      equal_1624_s15_q <= equal_1624;
      equal_1626_s15_q <= equal_1626;
      equal_1628_s15_q <= equal_1628_s14_q;
      equal_1630_s15_q <= equal_1630_s14_q;
      equal_1632_s15_q <= equal_1632_s14_q;
      equal_1634_s15_q <= equal_1634_s14_q;
      equal_1636_s15_q <= equal_1636_s14_q;
      less_1645_s15_q <= less_1645;
      or_1649_s15_q <= or_1649;
      select_1652_s15_q <= equal_1614_s14_q ? and_1644 : (less_1645 & (~or_1649));
      and_1662_s15_q <= half_ends & ({{3{sum_1660[4]}}, sum_1660} < 8'h3);
      select_1667_s15_q <= select_1667;
      select_1696_s15_q <= select_1696_s14_q;
      equal_1697_s15_q <= equal_1697_s14_q;
      and_1705_s15_q <= and_1705_s14_q;
      equal_1707_s15_q <= equal_1707_s14_q;
      and_1740_s15_q <= (less_1706_s14_q & (and_640 & less_1723)) & and_1739_s14_q;
      select_1756_s15_q <= select_1756_s14_q;
      select_1782_s15_q <= select_1782_s14_q;
      and_1789_s15_q <= and_1789_s14_q;
      and_1790_s15_q <= and_1790_s14_q;
      equal_1791_s15_q <= equal_1791_s14_q;
      equal_1793_s15_q <= equal_1793_s14_q;
      equal_1796_s15_q <= equal_1796_s14_q;
      or_1797_s15_q <= or_1797_s14_q;
      not_1798_s15_q <= not_1798_s14_q;
      and_1806_s15_q <= and_1806_s14_q;
      select_1821_s15_q <= select_1821_s14_q;
      select_1827_s15_q <= select_1827_s14_q;
      select_1865_s15_q <= select_1865_s14_q;
      less_1881_s15_q <= less_1881_s14_q;
      new_row_s15_q <= new_row_s14_q;
      or_1894_s15_q <= or_1894_s14_q;
      of_row_2_s15_q <= of_row_2_s14_q;
      down_2_s15_q <= down_2_s14_q[1:0];
      sum_1907_s15_q <= sum_1907;
      smooth_s15_q <= smooth;
      and_1954_s15_q <= not_1792_s14_q & (not_1794_s14_q & and_1952_s14_q);
      and_1963_s15_q <= and_1963_s14_q;
      and_1968_s15_q <= not_1792_s14_q & (not_1794_s14_q & and_1966_s14_q);
      less_1969_s15_q <= less_1969_s14_q;
      or_1972_s15_q <= or_1972_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      or_1986_s15_q <= or_1986_s14_q;
      or_1989_s15_q <= or_1989_s14_q;
      or_1992_s15_q <= or_1992_s14_q;
      not_1994_s15_q <= not_1994_s14_q;
      and_2007_s15_q <= inside_v_s14_q & (and_2005_s14_q & not_641_s14_q);
      and_2012_s15_q <= inside_v_s14_q & and_642;
      and_2020_s15_q <= and_2020_s14_q;
      and_2028_s15_q <= and_2028_s14_q;
      seen_columns_rdata_s15_q <= seen_columns_rdata_s14_q;
      textured_s15_q <= textured;
      shown_s15_q <= shown;
      near_s15_q <= near;
      not_2058_s15_q <= not_2058_s14_q;
      select_2070_s15_q <= draws_late_s14_q ? read_half_q : write_half_q;
      and_2072_s15_q <= and_2072_s14_q;
      and_2074_s15_q <= and_2074_s14_q;
      or_2089_s15_q <= or_2089_s14_q;
      or_2092_s15_q <= or_2092_s14_q;
      or_2095_s15_q <= or_2095_s14_q;
      and_2106_s15_q <= and_2106_s14_q;
      and_2108_s15_q <= seen_columns_rdata_s14_q[7] & inside_v_s14_q;
      and_2109_s15_q <= seen_columns_rdata_s14_q[3] & inside_v_s14_q;
      and_2122_s15_q <= and_2122_s14_q;
      and_2124_s15_q <= seen_columns_rdata_s14_q[8] & inside_v_s14_q;
      and_2125_s15_q <= seen_columns_rdata_s14_q[4] & inside_v_s14_q;
      and_2147_s15_q <= and_2147_s14_q;
      equal_2290_s15_q <= equal_2290_s14_q;
      equal_2479_s15_q <= equal_2479_s14_q;
      and_2621_s15_q <= not_578_s14_q & (so_s14_q & and_2619);
      not_2642_s15_q <= not_2642;
      and_2643_s15_q <= and_2643_s14_q;
      and_2645_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      and_2646_s15_q <= seen_columns_rdata_s14_q[2] & inside_v_s14_q;
      and_2686_s15_q <= not_578_s14_q & (so_s14_q & (ends_cell_s14_q & and_2683));
      and_2693_s15_q <= not_578_s14_q & (so_s14_q & (ends_cell_s14_q & and_2690));
      and_2717_s15_q <= (or_582_s14_q & (not_586_s14_q & and_2714)) & not_641_s14_q;
      select_2728_s15_q <= select_2728[1];
      select_2731_s15_q <= select_2731[1];
      and_2732_s15_q <= select_2728[0] & select_2731[0];
      and_2781_s15_q <= not_578_s14_q & (so_s14_q & (half_ends & equal_2778));
      and_2782_s15_q <= and_640 & less_1706_s14_q;
      residual_s15_q <= residual;
      equal_2844_s15_q <= sum_1620 == 2'h2;
      not_2845_s15_q <= ~select_1667;
      quarter_2_s15_q <= quarter_2;
      and_3019_s15_q <= and_3019_s14_q;
      less_3145_s15_q <= less_3145_s14_q;
      equal_3488_s15_q <= patches_match_row_s14_q == 4'h0;
      and_3568_s15_q <= equal_1970_s14_q & ({sum_3566[6], sum_3566} < 8'hfb);
      select_3574_s15_q <= select_3574_s14_q;
      select_3575_s15_q <= select_3575_s14_q;
      select_3576_s15_q <= patches_peak_row_q;
      equal_3585_s15_q <= equal_3585_s14_q;
      less_3613_s15_q <= select_3578 < select_3580;
      less_3616_s15_q <= select_3580 < select_3578;
      equal_3896_s15_q <= equal_3896_s14_q;
      equal_3913_s15_q <= equal_3913_s14_q;
      equal_3916_s15_q <= equal_3916;
      equal_3919_s15_q <= equal_3919;
      equal_3920_s15_q <= equal_3920;
      equal_3921_s15_q <= equal_3921_s14_q;
      select_3941_s15_q <= equal_3919 ? {cfg_on_skin_limit_i, 3'h0} : select_3940;
      or_4063_s15_q <= or_4063_s14_q;
      and_4077_s15_q <= and_4077_s14_q;
      and_4094_s15_q <= and_4094_s14_q;
      not_4106_s15_q <= not_4106_s14_q;
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
  logic less_658;
  assign less_658 = census_memory_rdata_s15_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_memory_rdata_s15_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_663;
  assign less_663 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_664;
  assign less_664 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_665;
  assign less_665 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_666;
  assign less_666 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_667;
  assign less_667 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_668;
  assign less_668 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_669;
  assign less_669 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_670;
  assign less_670 = census_memory_rdata_s15_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_memory_rdata_s15_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_675;
  assign less_675 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_676;
  assign less_676 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_677;
  assign less_677 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_678;
  assign less_678 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_679;
  assign less_679 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_680;
  assign less_680 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_681;
  assign less_681 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:460
  logic equal_682;
  assign equal_682 = last_s15_q == 7'h0;
  logic [3:0] select_686;
  assign select_686 = equal_685_s15_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
  logic [4:0] select_687;
  assign select_687 = equal_682 ? {select_686, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_688;
  assign select_688 = equal_682 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:300
  logic and_691;
  assign and_691 = census_memory_rdata_s15_q[38] & (census_memory_rdata_s15_q[18] & whole_2_s15_q);
  logic and_693;
  assign and_693 = census_memory_rdata_s15_q[77] & (census_memory_rdata_s15_q[58] & and_691);
  // hls/stages/census.hpp:284
  logic [9:0] difference_716;
  assign difference_716 = {1'b0, select_558_s15_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_719;
  assign difference_719 = {1'b0, census_memory_rdata_s15_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_723;
  assign difference_723 = {1'b0, census_memory_rdata_s15_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_727;
  assign difference_727 = {1'b0, census_memory_rdata_s15_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_731;
  assign difference_731 = {1'b0, census_memory_rdata_s15_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/agreement.hpp:798
  logic and_1593;
  assign and_1593 = not_580_s15_q & and_1592_s15_q;
  // hls/stages/moments.hpp:73
  logic and_1600;
  assign and_1600 = moments_has_before_q & moments_memory_rdata_s15_q[0];
  // hls/stages/agreement.hpp:1013
  logic and_1604;
  assign and_1604 = not_590_s15_q & (and_1600 & (moments_memory_rdata_s15_q[1] ^ and_645_s15_q));
  // hls/stages/moments.hpp:73
  logic and_1609;
  assign and_1609 = moments_has_before_q & moments_memory_rdata_s15_q[2];
  // hls/stages/agreement.hpp:1013
  logic and_1613;
  assign and_1613 = not_590_s15_q & (and_1609 & (moments_memory_rdata_s15_q[3] ^ and_652_s15_q));
  // hls/stages/agreement.hpp:798
  logic and_1663;
  assign and_1663 = so_s15_q & and_1662_s15_q;
  logic and_1744;
  assign and_1744 = not_578_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_1740_s15_q)));
  logic [7:0] select_1750;
  assign select_1750 = so_s15_q ? (ends_cell_s15_q ? (inside_v_s15_q ? x_s15_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:475
  logic [13:0] sum_1908;
  assign sum_1908 = {{3{patches_down_values_1_s15_q[10]}}, patches_down_values_1_s15_q} + {sum_1907_s15_q, down_2_s15_q[1]};
  logic [12:0] sum_1909;
  assign sum_1909 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1908[13:1];
  // hls/stages/patches.hpp:474
  logic [12:0] sum_1927;
  assign sum_1927 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s15_q[11:1]};
  logic [12:0] sum_1928;
  assign sum_1928 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1929;
  assign difference_1929 = {1'b0, sum_1927, smooth_s15_q[0]} - {1'b0, sum_1928, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:263
  logic and_2023;
  assign and_2023 = inside_v_s15_q & (not_641_s15_q & (and_2020_s15_q & and_1592_s15_q));
  logic and_2031;
  assign and_2031 = inside_v_s15_q & and_2020_s15_q;
  logic explained;
  assign explained = inside_v_s15_q & and_640_s15_q;
  // hls/stages/agreement.hpp:1040
  logic and_2075;
  assign and_2075 = seen_columns_rdata_s15_q[0] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1098
  logic [1:0] sum_2077;
  assign sum_2077 = {1'b0, and_2074_s15_q} + ({1'b0, textured_s15_q} + {1'b0, and_2075});
  // hls/stages/agreement.hpp:1040
  logic and_2107;
  assign and_2107 = seen_columns_rdata_s15_q[11] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1100
  logic [1:0] sum_2111;
  assign sum_2111 = {1'b0, and_2108_s15_q} + ({1'b0, shown_s15_q} + {1'b0, and_2109_s15_q});
  // hls/stages/agreement.hpp:1040
  logic and_2123;
  assign and_2123 = seen_columns_rdata_s15_q[12] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1101
  logic [1:0] sum_2127;
  assign sum_2127 = {1'b0, and_2124_s15_q} + ({1'b0, near_s15_q} + {1'b0, and_2125_s15_q});
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2173;
  assign select_2173 = sample_pair_whole_s15_q ? (and_550_s15_q ? grey_s15_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2175;
  assign select_2175 = sample_pair_whole_s15_q ? (and_550_s15_q ? grey_2_s15_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2177;
  assign select_2177 = sample_pair_whole_s15_q ? (and_550_s15_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2179;
  assign select_2179 = sample_pair_whole_s15_q ? (and_550_s15_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2184;
  assign sum_2184 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s15_q};
  logic [9:0] sum_2192;
  assign sum_2192 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s15_q};
  // hls/stages/agreement.hpp:530
  logic [8:0] select_2208;
  assign select_2208 = and_552_s15_q ? select_558_s15_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_552_s15_q ? select_562_s15_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2211;
  assign select_2211 = and_552_s15_q ? census_memory_rdata_s15_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_552_s15_q ? census_memory_rdata_s15_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2213;
  assign select_2213 = and_552_s15_q ? census_memory_rdata_s15_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_552_s15_q ? census_memory_rdata_s15_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_552_s15_q ? census_memory_rdata_s15_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2216;
  assign select_2216 = and_552_s15_q ? census_memory_rdata_s15_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2217;
  assign select_2217 = and_552_s15_q ? census_memory_rdata_s15_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2218;
  assign select_2218 = and_552_s15_q ? census_memory_rdata_s15_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2219;
  assign select_2219 = and_552_s15_q ? census_memory_rdata_s15_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2220;
  assign select_2220 = and_552_s15_q ? census_memory_rdata_s15_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2221;
  assign select_2221 = and_552_s15_q ? census_memory_rdata_s15_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2222;
  assign select_2222 = and_552_s15_q ? census_memory_rdata_s15_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2223;
  assign select_2223 = and_552_s15_q ? census_memory_rdata_s15_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2224;
  assign select_2224 = and_552_s15_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_552_s15_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2227;
  assign select_2227 = and_552_s15_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_552_s15_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2230;
  assign select_2230 = and_552_s15_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_552_s15_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2233;
  assign select_2233 = and_552_s15_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2234;
  assign select_2234 = and_552_s15_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2235;
  assign select_2235 = and_552_s15_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2237;
  assign select_2237 = and_552_s15_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2238;
  assign select_2238 = and_552_s15_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2240;
  assign select_2240 = and_552_s15_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2241;
  assign select_2241 = and_552_s15_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2243;
  assign select_2243 = and_552_s15_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2244;
  assign select_2244 = and_552_s15_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2246;
  assign select_2246 = and_552_s15_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2247;
  assign select_2247 = and_552_s15_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2249;
  assign select_2249 = and_552_s15_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2250;
  assign select_2250 = and_552_s15_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2252;
  assign select_2252 = and_552_s15_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2253;
  assign select_2253 = and_552_s15_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2256;
  assign select_2256 = and_552_s15_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2257;
  assign select_2257 = and_552_s15_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2260;
  assign select_2260 = and_552_s15_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2261;
  assign select_2261 = and_552_s15_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2265;
  assign difference_2265 = {1'b0, select_562_s15_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2268;
  assign difference_2268 = {1'b0, census_memory_rdata_s15_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2272;
  assign difference_2272 = {1'b0, census_memory_rdata_s15_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2276;
  assign difference_2276 = {1'b0, census_memory_rdata_s15_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2280;
  assign difference_2280 = {1'b0, census_memory_rdata_s15_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/agreement.hpp:1154
  logic equal_2305;
  assign equal_2305 = x_s15_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:798
  logic select_2311;
  assign select_2311 = equal_577_s15_q ? (moments_has_before_q | equal_2305) : moments_has_before_q;
  // hls/stages/census.hpp:371
  logic [9:0] difference_2376;
  assign difference_2376 = {1'b0, select_558_s15_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2388;
  assign difference_2388 = {1'b0, select_562_s15_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:530
  logic and_2614;
  assign and_2614 = and_552_s15_q & (equal_685_s15_q & equal_2479_s15_q);
  // hls/stages/agreement.hpp:798
  logic and_2626;
  assign and_2626 = not_578_s15_q & (so_s15_q & (ends_cell_s15_q & and_2007_s15_q));
  // hls/stages/agreement.hpp:1040
  logic and_2644;
  assign and_2644 = seen_columns_rdata_s15_q[10] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1099
  logic [1:0] sum_2648;
  assign sum_2648 = {1'b0, and_2645_s15_q} + ({1'b0, explained} + {1'b0, and_2646_s15_q});
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2688;
  assign select_2688 = and_2614 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2686_s15_q});
  logic [13:0] select_2695;
  assign select_2695 = and_2614 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2693_s15_q});
  // hls/stages/agreement.hpp:798
  logic and_2721;
  assign and_2721 = not_578_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_2717_s15_q)));
  // hls/stages/agreement.hpp:1037
  logic and_2733;
  assign and_2733 = and_640_s15_q & and_2732_s15_q;
  // hls/stages/agreement.hpp:263
  logic and_2736;
  assign and_2736 = inside_v_s15_q & (not_641_s15_q & (select_2728_s15_q & and_2733));
  logic and_2744;
  assign and_2744 = inside_v_s15_q & (not_641_s15_q & (select_2731_s15_q & and_2733));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2816;
  assign difference_2816 = 13'h0 - {residual_s15_q[11], residual_s15_q};
  logic less_2831;
  assign less_2831 = $signed(difference_2816) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2847;
  assign select_2847 = equal_2844_s15_q ? (registration_fresh_q & not_2845_s15_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_2849;
  assign select_2849 = so_s15_q ? (and_1662_s15_q ? select_2847 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2851;
  assign select_2851 = and_2614 ? 4'hf : (equal_577_s15_q ? registration_fresh_q : select_2849);
  // hls/stages/registration.hpp:258
  logic not_2871;
  assign not_2871 = ~quarter_2_s15_q[1];
  logic [3:0] select_2872;
  assign select_2872 = quarter_2_s15_q[0] ? {quarter_2_s15_q[1], 1'b0, not_2871, 1'b0} : {1'b0, quarter_2_s15_q[1], 1'b0, not_2871};
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3111;
  assign select_3111 = equal_1793_s15_q ? patches_smooth_values_0_q : (or_1797_s15_q ? smooth_s15_q : patches_smooth_values_0_q);
  logic [11:0] select_3113;
  assign select_3113 = or_1797_s15_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3115;
  assign select_3115 = equal_1791_s15_q ? patches_smooth_values_1_q : (equal_1793_s15_q ? patches_smooth_values_1_q : select_3113);
  logic [11:0] select_3116;
  assign select_3116 = or_1797_s15_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3118;
  assign select_3118 = equal_1791_s15_q ? patches_smooth_values_2_q : (equal_1793_s15_q ? patches_smooth_values_2_q : select_3116);
  logic [11:0] select_3119;
  assign select_3119 = or_1797_s15_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3121;
  assign select_3121 = equal_1791_s15_q ? patches_smooth_values_3_q : (equal_1793_s15_q ? patches_smooth_values_3_q : select_3119);
  logic [10:0] select_3128;
  assign select_3128 = or_1797_s15_q ? patches_down_values_1_s15_q : patches_down_values_2_q;
  logic [10:0] select_3130;
  assign select_3130 = equal_1791_s15_q ? patches_down_values_2_q : (equal_1793_s15_q ? patches_down_values_2_q : select_3128);
  logic [10:0] select_3131;
  assign select_3131 = or_1797_s15_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3133;
  assign select_3133 = equal_1791_s15_q ? patches_down_values_3_q : (equal_1793_s15_q ? patches_down_values_3_q : select_3131);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3570;
  assign select_3570 = or_1972_s15_q ? (and_3568_s15_q ? patches_rows_rdata_s15_q : 10'h3ff) : 10'h3ff;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3572;
  assign select_3572 = equal_1791_s15_q ? (less_1969_s15_q ? select_3570 : 10'h3ff) : patches_read_far_q;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3613_s15_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = less_3616_s15_q ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3574_s15_q;
  // hls/stages/agreement.hpp:1235
  logic equal_3681;
  assign equal_3681 = x_s15_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1229
  logic equal_3918;
  assign equal_3918 = x_s15_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1137
  logic [7:0] limit;
  assign limit = equal_3918 ? cfg_regions_limit_i : select_3941_s15_q;
  // hls/stages/agreement.hpp:1243
  logic not_3943;
  assign not_3943 = ~x_s15_q[2];
  logic [3:0] select_3944;
  assign select_3944 = x_s15_q[1] ? {x_s15_q[2], 1'b0, not_3943, 1'b0} : {1'b0, x_s15_q[2], 1'b0, not_3943};
  logic [7:0] select_3945;
  assign select_3945 = x_s15_q[0] ? {select_3944[3], 1'b0, select_3944[2], 1'b0, select_3944[1], 1'b0, select_3944[0], 1'b0} : {1'b0, select_3944[3], 1'b0, select_3944[2], 1'b0, select_3944[1], 1'b0, select_3944[0]};
  // hls/stages/agreement.hpp:1137
  logic [13:0] select_3949;
  assign select_3949 = equal_3920_s15_q ? counts_skin_supervised_q : (equal_3921_s15_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3951;
  assign select_3951 = equal_3919_s15_q ? counts_skin_textured_q : (equal_3916_s15_q ? counts_textured_q : select_3949);
  logic [13:0] of;
  assign of = equal_3918 ? counts_textured_q : select_3951;
  // hls/stages/registration.hpp:258
  logic not_4156;
  assign not_4156 = ~quarter_s15_q[1];
  logic [3:0] select_4157;
  assign select_4157 = quarter_s15_q[0] ? {quarter_s15_q[1], 1'b0, not_4156, 1'b0} : {1'b0, quarter_s15_q[1], 1'b0, not_4156};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1621_s15_q;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s15_en & (equal_577_s15_q ? (x_s15_q[6] & select_1652_s15_q) : and_1663);
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
  assign shown_right_waddr = select_1585_s15_q;
  logic shown_right_we;
  assign shown_right_we = s15_en & and_1596_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1593, not_580_s15_q};
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
  assign seen_columns_we = s15_en & and_1581_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s15_q, near_s15_q, shown_s15_q, explained, and_2031, textured_s15_q};
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
      census_filled_q <= and_552_s15_q ? {select_688[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2311;
      rows_passed_above_q <= and_552_s15_q ? select_687 : rows_passed_above_q;
      counts_textured_q <= and_2614 ? 14'h0 : (counts_textured_q + {13'h0, and_2626});
      counts_skin_supervised_q <= select_2688;
      counts_skin_textured_q <= select_2695;
      registration_fresh_q <= select_2851;
      patches_smooth_values_0_q <= equal_1791_s15_q ? patches_smooth_values_0_q : select_3111;
      patches_smooth_values_1_q <= select_3115;
      patches_smooth_values_2_q <= select_3118;
      patches_smooth_values_3_q <= select_3121;
      patches_down_values_2_q <= select_3130;
      patches_down_values_3_q <= select_3133;
      patches_read_far_q <= select_3572;
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
      averager_quarter_1_0_q <= select_2173;
      averager_quarter_1_1_q <= select_2175;
      averager_quarter_2_0_q <= select_2177;
      averager_quarter_2_1_q <= select_2179;
      census_columns_values_0_cell_0_left_q <= select_2208;
      census_columns_values_0_cell_0_right_q <= select_2209;
      census_columns_values_0_cell_1_left_q <= select_2211;
      census_columns_values_0_cell_1_right_q <= select_2212;
      census_columns_values_0_cell_1_mask_q <= select_2213;
      census_columns_values_0_cell_2_left_q <= select_2214;
      census_columns_values_0_cell_2_right_q <= select_2215;
      census_columns_values_0_cell_2_mask_q <= select_2216;
      census_columns_values_0_cell_2_of_skin_q <= select_2217;
      census_columns_values_0_cell_3_left_q <= select_2218;
      census_columns_values_0_cell_3_right_q <= select_2219;
      census_columns_values_0_cell_3_mask_q <= select_2220;
      census_columns_values_0_cell_4_left_q <= select_2221;
      census_columns_values_0_cell_4_right_q <= select_2222;
      census_columns_values_0_cell_4_mask_q <= select_2223;
      census_columns_values_1_cell_0_left_q <= select_2224;
      census_columns_values_1_cell_0_right_q <= select_2225;
      census_columns_values_1_cell_1_left_q <= select_2227;
      census_columns_values_1_cell_1_right_q <= select_2228;
      census_columns_values_1_cell_2_left_q <= select_2230;
      census_columns_values_1_cell_2_right_q <= select_2231;
      census_columns_values_1_cell_2_of_skin_q <= select_2233;
      census_columns_values_1_cell_3_left_q <= select_2234;
      census_columns_values_1_cell_3_right_q <= select_2235;
      census_columns_values_1_cell_4_left_q <= select_2237;
      census_columns_values_1_cell_4_right_q <= select_2238;
      census_columns_values_2_cell_0_left_q <= select_2240;
      census_columns_values_2_cell_0_right_q <= select_2241;
      census_columns_values_2_cell_1_left_q <= select_2243;
      census_columns_values_2_cell_1_right_q <= select_2244;
      census_columns_values_2_cell_2_left_q <= select_2246;
      census_columns_values_2_cell_2_right_q <= select_2247;
      census_columns_values_2_cell_3_left_q <= select_2249;
      census_columns_values_2_cell_3_right_q <= select_2250;
      census_columns_values_2_cell_4_left_q <= select_2252;
      census_columns_values_2_cell_4_right_q <= select_2253;
      census_columns_values_3_cell_1_left_q <= select_2256;
      census_columns_values_3_cell_1_right_q <= select_2257;
      census_columns_values_3_cell_3_left_q <= select_2260;
      census_columns_values_3_cell_3_right_q <= select_2261;
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
  logic less_675_s16_q;
  logic less_676_s16_q;
  logic less_677_s16_q;
  logic less_678_s16_q;
  logic less_679_s16_q;
  logic less_680_s16_q;
  logic less_681_s16_q;
  logic and_689_s16_q;
  logic and_693_s16_q;
  logic difference_716_s16_q;
  logic [8:0] xor_717_s16_q;
  logic difference_719_s16_q;
  logic [8:0] xor_720_s16_q;
  logic difference_723_s16_q;
  logic [8:0] xor_724_s16_q;
  logic difference_727_s16_q;
  logic [8:0] xor_728_s16_q;
  logic difference_731_s16_q;
  logic [8:0] xor_732_s16_q;
  logic [9:0] half_grey_levels_s16_q;
  logic [9:0] half_grey_levels_2_s16_q;
  logic [5:0] select_1524_s16_q;
  logic [2:0] select_1529_s16_q;
  logic [7:0] select_1530_s16_q;
  logic [7:0] select_1538_s16_q;
  logic [7:0] select_1541_s16_q;
  logic [6:0] select_1559_s16_q;
  logic [5:0] select_1561_s16_q;
  logic [7:0] select_1564_s16_q;
  logic [7:0] select_1567_s16_q;
  logic and_1568_s16_q;
  logic [7:0] select_1573_s16_q;
  logic [6:0] select_1574_s16_q;
  logic [6:0] select_1577_s16_q;
  logic [6:0] select_1578_s16_q;
  logic and_1601_s16_q;
  logic and_1604_s16_q;
  logic and_1607_s16_q;
  logic and_1610_s16_q;
  logic and_1613_s16_q;
  logic equal_1614_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1620_s16_q;
  logic equal_1622_s16_q;
  logic equal_1624_s16_q;
  logic equal_1626_s16_q;
  logic equal_1628_s16_q;
  logic equal_1630_s16_q;
  logic equal_1632_s16_q;
  logic equal_1634_s16_q;
  logic equal_1636_s16_q;
  logic less_1645_s16_q;
  logic or_1649_s16_q;
  logic equal_1669_s16_q;
  logic and_1679_s16_q;
  logic select_1696_s16_q;
  logic equal_1697_s16_q;
  logic [22:0] patches_choices_rdata_s16_q;
  logic and_1705_s16_q;
  logic equal_1707_s16_q;
  logic and_1744_s16_q;
  logic [7:0] select_1751_s16_q;
  logic [5:0] select_1756_s16_q;
  logic [7:0] select_1782_s16_q;
  logic and_1789_s16_q;
  logic and_1790_s16_q;
  logic equal_1791_s16_q;
  logic equal_1793_s16_q;
  logic equal_1796_s16_q;
  logic or_1797_s16_q;
  logic not_1798_s16_q;
  logic and_1806_s16_q;
  logic [4:0] select_1821_s16_q;
  logic select_1827_s16_q;
  logic [3:0] select_1865_s16_q;
  logic less_1881_s16_q;
  logic new_row_s16_q;
  logic or_1894_s16_q;
  logic [27:0] patches_right_codes_rdata_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic down_2_s16_q;
  logic sum_1908_s16_q;
  logic [12:0] sum_1909_s16_q;
  logic [14:0] difference_1929_s16_q;
  logic and_1954_s16_q;
  logic [47:0] patches_left_codes_rdata_s16_q;
  logic and_1963_s16_q;
  logic and_1968_s16_q;
  logic or_1986_s16_q;
  logic or_1989_s16_q;
  logic or_1992_s16_q;
  logic not_1994_s16_q;
  logic [29:0] regions_rdata_s16_q;
  logic and_2007_s16_q;
  logic and_2012_s16_q;
  logic and_2023_s16_q;
  logic and_2028_s16_q;
  logic select_2056_s16_q;
  logic not_2058_s16_q;
  logic select_2070_s16_q;
  logic and_2072_s16_q;
  logic and_2073_s16_q;
  logic [1:0] sum_2077_s16_q;
  logic or_2089_s16_q;
  logic or_2092_s16_q;
  logic or_2095_s16_q;
  logic and_2106_s16_q;
  logic [2:0] sum_2112_s16_q;
  logic and_2122_s16_q;
  logic [2:0] sum_2128_s16_q;
  logic and_2147_s16_q;
  logic sum_2184_s16_q;
  logic [9:0] difference_2185_s16_q;
  logic sum_2192_s16_q;
  logic [9:0] difference_2193_s16_q;
  logic difference_2265_s16_q;
  logic [8:0] xor_2266_s16_q;
  logic difference_2268_s16_q;
  logic [8:0] xor_2269_s16_q;
  logic difference_2272_s16_q;
  logic [8:0] xor_2273_s16_q;
  logic difference_2276_s16_q;
  logic [8:0] xor_2277_s16_q;
  logic difference_2280_s16_q;
  logic [8:0] xor_2281_s16_q;
  logic equal_2290_s16_q;
  logic equal_2305_s16_q;
  logic difference_2376_s16_q;
  logic [8:0] xor_2377_s16_q;
  logic difference_2388_s16_q;
  logic [8:0] xor_2389_s16_q;
  logic equal_2479_s16_q;
  logic and_2614_s16_q;
  logic and_2621_s16_q;
  logic and_2626_s16_q;
  logic not_2642_s16_q;
  logic and_2643_s16_q;
  logic [2:0] sum_2649_s16_q;
  logic and_2721_s16_q;
  logic and_2739_s16_q;
  logic and_2747_s16_q;
  logic and_2781_s16_q;
  logic and_2782_s16_q;
  logic [7:0] residual_s16_q;
  logic less_2817_s16_q;
  logic less_2831_s16_q;
  logic equal_2874_s16_q;
  logic and_3019_s16_q;
  logic less_3145_s16_q;
  logic equal_3488_s16_q;
  logic [9:0] select_3574_s16_q;
  logic [4:0] select_3575_s16_q;
  logic [4:0] select_3576_s16_q;
  logic equal_3585_s16_q;
  logic less_3613_s16_q;
  logic [9:0] eight_s16_q;
  logic [9:0] fall_2_s16_q;
  logic equal_3681_s16_q;
  logic and_3897_s16_q;
  logic equal_3913_s16_q;
  logic equal_3916_s16_q;
  logic equal_3918_s16_q;
  logic equal_3919_s16_q;
  logic equal_3920_s16_q;
  logic equal_3921_s16_q;
  logic equal_3947_s16_q;
  logic [13:0] of_s16_q;
  logic or_4063_s16_q;
  logic and_4077_s16_q;
  logic and_4094_s16_q;
  logic not_4106_s16_q;
  logic equal_4159_s16_q;
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
      less_675_s16_q <= less_675;
      less_676_s16_q <= less_676;
      less_677_s16_q <= less_677;
      less_678_s16_q <= less_678;
      less_679_s16_q <= less_679;
      less_680_s16_q <= less_680;
      less_681_s16_q <= less_681;
      and_689_s16_q <= select_687[4] & select_688[3];
      and_693_s16_q <= and_693;
      difference_716_s16_q <= difference_716[9];
      xor_717_s16_q <= difference_716[8:0] ^ {9{difference_716[9]}};
      difference_719_s16_q <= difference_719[9];
      xor_720_s16_q <= difference_719[8:0] ^ {9{difference_719[9]}};
      difference_723_s16_q <= difference_723[9];
      xor_724_s16_q <= difference_723[8:0] ^ {9{difference_723[9]}};
      difference_727_s16_q <= difference_727[9];
      xor_728_s16_q <= difference_727[8:0] ^ {9{difference_727[9]}};
      difference_731_s16_q <= difference_731[9];
      xor_732_s16_q <= difference_731[8:0] ^ {9{difference_731[9]}};
      half_grey_levels_s16_q <= half_grey_levels;
      half_grey_levels_2_s16_q <= half_grey_levels_2;
      select_1524_s16_q <= or_1523_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[5:0];
      select_1529_s16_q <= or_1523_s15_q ? select_1528_s15_q : best_left_rdata_s15_q[8:6];
      select_1530_s16_q <= or_1523_s15_q ? of_best_s15_q : best_left_rdata_s15_q[16:9];
      select_1538_s16_q <= or_1523_s15_q ? select_1537_s15_q : best_left_rdata_s15_q[24:17];
      select_1541_s16_q <= or_1523_s15_q ? select_1540_s15_q : best_left_rdata_s15_q[32:25];
      select_1559_s16_q <= select_1559_s15_q;
      select_1561_s16_q <= select_1561_s15_q;
      select_1564_s16_q <= select_1564_s15_q;
      select_1567_s16_q <= select_1567_s15_q;
      and_1568_s16_q <= and_1568_s15_q;
      select_1573_s16_q <= or_1572_s15_q ? of_best_s15_q : best_right_rdata_s15_q[7:0];
      select_1574_s16_q <= or_1572_s15_q ? x_s15_2_q : best_right_rdata_s15_q[14:8];
      select_1577_s16_q <= select_1577_s15_q;
      select_1578_s16_q <= select_1578_s15_q;
      and_1601_s16_q <= not_590_s15_q & and_1600;
      and_1604_s16_q <= and_1604;
      and_1607_s16_q <= and_1607_s15_q;
      and_1610_s16_q <= not_590_s15_q & and_1609;
      and_1613_s16_q <= and_1613;
      equal_1614_s16_q <= equal_1614_s15_q;
      all_s16_q <= all_s15_q;
      sum_1620_s16_q <= sum_1620_s15_q;
      equal_1622_s16_q <= equal_1622_s15_q;
      equal_1624_s16_q <= equal_1624_s15_q;
      equal_1626_s16_q <= equal_1626_s15_q;
      equal_1628_s16_q <= equal_1628_s15_q;
      equal_1630_s16_q <= equal_1630_s15_q;
      equal_1632_s16_q <= equal_1632_s15_q;
      equal_1634_s16_q <= equal_1634_s15_q;
      equal_1636_s16_q <= equal_1636_s15_q;
      less_1645_s16_q <= less_1645_s15_q;
      or_1649_s16_q <= or_1649_s15_q;
      equal_1669_s16_q <= (registration_fresh_q & select_1667_s15_q) == 4'h0;
      and_1679_s16_q <= not_578_s15_q & and_1663;
      select_1696_s16_q <= select_1696_s15_q;
      equal_1697_s16_q <= equal_1697_s15_q;
      patches_choices_rdata_s16_q <= patches_choices_rdata_q;
      and_1705_s16_q <= and_1705_s15_q;
      equal_1707_s16_q <= equal_1707_s15_q;
      and_1744_s16_q <= and_1744;
      select_1751_s16_q <= equal_577_s15_q ? 8'h0 : select_1750;
      select_1756_s16_q <= select_1756_s15_q;
      select_1782_s16_q <= select_1782_s15_q;
      and_1789_s16_q <= and_1789_s15_q;
      and_1790_s16_q <= and_1790_s15_q;
      equal_1791_s16_q <= equal_1791_s15_q;
      equal_1793_s16_q <= equal_1793_s15_q;
      equal_1796_s16_q <= equal_1796_s15_q;
      or_1797_s16_q <= or_1797_s15_q;
      not_1798_s16_q <= not_1798_s15_q;
      and_1806_s16_q <= and_1806_s15_q;
      select_1821_s16_q <= select_1821_s15_q;
      select_1827_s16_q <= select_1827_s15_q;
      select_1865_s16_q <= select_1865_s15_q;
      less_1881_s16_q <= less_1881_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1894_s16_q <= or_1894_s15_q;
      patches_right_codes_rdata_s16_q <= patches_right_codes_rdata_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[0];
      sum_1908_s16_q <= sum_1908[0];
      sum_1909_s16_q <= sum_1909;
      difference_1929_s16_q <= difference_1929;
      and_1954_s16_q <= and_1954_s15_q;
      patches_left_codes_rdata_s16_q <= patches_left_codes_rdata_q;
      and_1963_s16_q <= and_1963_s15_q;
      and_1968_s16_q <= and_1968_s15_q;
      or_1986_s16_q <= or_1986_s15_q;
      or_1989_s16_q <= or_1989_s15_q;
      or_1992_s16_q <= or_1992_s15_q;
      not_1994_s16_q <= not_1994_s15_q;
      regions_rdata_s16_q <= regions_rdata_q;
      and_2007_s16_q <= and_2007_s15_q;
      and_2012_s16_q <= and_2012_s15_q;
      and_2023_s16_q <= and_2023;
      and_2028_s16_q <= and_2028_s15_q;
      select_2056_s16_q <= read_half_q;
      not_2058_s16_q <= not_2058_s15_q;
      select_2070_s16_q <= select_2070_s15_q;
      and_2072_s16_q <= and_2072_s15_q;
      and_2073_s16_q <= seen_columns_rdata_s15_q[9] & inside_v_s15_q;
      sum_2077_s16_q <= sum_2077;
      or_2089_s16_q <= or_2089_s15_q;
      or_2092_s16_q <= or_2092_s15_q;
      or_2095_s16_q <= or_2095_s15_q;
      and_2106_s16_q <= and_2106_s15_q;
      sum_2112_s16_q <= {2'h0, and_2107} + {1'b0, sum_2111};
      and_2122_s16_q <= and_2122_s15_q;
      sum_2128_s16_q <= {2'h0, and_2123} + {1'b0, sum_2127};
      and_2147_s16_q <= and_2147_s15_q;
      sum_2184_s16_q <= sum_2184[0];
      difference_2185_s16_q <= {1'b0, sum_2184[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2192_s16_q <= sum_2192[0];
      difference_2193_s16_q <= {1'b0, sum_2192[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2265_s16_q <= difference_2265[9];
      xor_2266_s16_q <= difference_2265[8:0] ^ {9{difference_2265[9]}};
      difference_2268_s16_q <= difference_2268[9];
      xor_2269_s16_q <= difference_2268[8:0] ^ {9{difference_2268[9]}};
      difference_2272_s16_q <= difference_2272[9];
      xor_2273_s16_q <= difference_2272[8:0] ^ {9{difference_2272[9]}};
      difference_2276_s16_q <= difference_2276[9];
      xor_2277_s16_q <= difference_2276[8:0] ^ {9{difference_2276[9]}};
      difference_2280_s16_q <= difference_2280[9];
      xor_2281_s16_q <= difference_2280[8:0] ^ {9{difference_2280[9]}};
      equal_2290_s16_q <= equal_2290_s15_q;
      equal_2305_s16_q <= equal_2305;
      difference_2376_s16_q <= difference_2376[9];
      xor_2377_s16_q <= difference_2376[8:0] ^ {9{difference_2376[9]}};
      difference_2388_s16_q <= difference_2388[9];
      xor_2389_s16_q <= difference_2388[8:0] ^ {9{difference_2388[9]}};
      equal_2479_s16_q <= equal_2479_s15_q;
      and_2614_s16_q <= and_2614;
      and_2621_s16_q <= and_2621_s15_q;
      and_2626_s16_q <= and_2626;
      not_2642_s16_q <= not_2642_s15_q;
      and_2643_s16_q <= and_2643_s15_q;
      sum_2649_s16_q <= {2'h0, and_2644} + {1'b0, sum_2648};
      and_2721_s16_q <= and_2721;
      and_2739_s16_q <= not_578_s15_q & (so_s15_q & (ends_cell_s15_q & and_2736));
      and_2747_s16_q <= not_578_s15_q & (so_s15_q & (ends_cell_s15_q & and_2744));
      and_2781_s16_q <= and_2781_s15_q;
      and_2782_s16_q <= and_2782_s15_q;
      residual_s16_q <= residual_s15_q[7:0];
      less_2817_s16_q <= $signed(difference_2816) < $signed({7'h0, cfg_moved_limit_i});
      less_2831_s16_q <= less_2831;
      equal_2874_s16_q <= (registration_fresh_q & select_2872) == 4'h0;
      and_3019_s16_q <= and_3019_s15_q;
      less_3145_s16_q <= less_3145_s15_q;
      equal_3488_s16_q <= equal_3488_s15_q;
      select_3574_s16_q <= select_3574_s15_q;
      select_3575_s16_q <= select_3575_s15_q;
      select_3576_s16_q <= select_3576_s15_q;
      equal_3585_s16_q <= equal_3585_s15_q;
      less_3613_s16_q <= less_3613_s15_q;
      eight_s16_q <= eight;
      fall_2_s16_q <= fall_2;
      equal_3681_s16_q <= equal_3681;
      and_3897_s16_q <= equal_3896_s15_q & equal_3681;
      equal_3913_s16_q <= equal_3913_s15_q;
      equal_3916_s16_q <= equal_3916_s15_q;
      equal_3918_s16_q <= equal_3918;
      equal_3919_s16_q <= equal_3919_s15_q;
      equal_3920_s16_q <= equal_3920_s15_q;
      equal_3921_s16_q <= equal_3921_s15_q;
      equal_3947_s16_q <= (limit & select_3945) == 8'h0;
      of_s16_q <= of;
      or_4063_s16_q <= or_4063_s15_q;
      and_4077_s16_q <= and_4077_s15_q;
      and_4094_s16_q <= and_4094_s15_q;
      not_4106_s16_q <= not_4106_s15_q;
      equal_4159_s16_q <= (registration_fresh_q & select_4157) == 4'h0;
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
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_693_s16_q;
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
  logic [9:0] sum_718;
  assign sum_718 = {9'h0, difference_716_s16_q} + {1'b0, xor_717_s16_q};
  logic [9:0] sum_721;
  assign sum_721 = {9'h0, difference_719_s16_q} + {1'b0, xor_720_s16_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_743;
  assign sum_743 = {half_grey_levels_s16_q[9], half_grey_levels_s16_q[9:4]} + 7'h7f;
  logic less_744;
  assign less_744 = {{5{sum_743[6]}}, sum_743, half_grey_levels_s16_q[3:0]} < 16'hffe1;
  logic [6:0] sum_749;
  assign sum_749 = {half_grey_levels_2_s16_q[9], half_grey_levels_2_s16_q[9:4]} + 7'h7f;
  logic less_750;
  assign less_750 = {{5{sum_749[6]}}, sum_749, half_grey_levels_2_s16_q[3:0]} < 16'hffe1;
  // hls/stages/patches.hpp:157
  logic and_1746;
  assign and_1746 = and_1744_s16_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_1747;
  assign select_1747 = and_1746 ? and_1744_s16_q : patches_choice_valid_q;
  logic [7:0] select_1752;
  assign select_1752 = and_1746 ? select_1751_s16_q : patches_choice_column_q;
  logic [5:0] select_1757;
  assign select_1757 = and_1746 ? select_1756_s16_q : patches_choice_shift_q;
  logic [7:0] select_1783;
  assign select_1783 = and_1746 ? select_1782_s16_q : patches_choice_slope_q;
  // hls/stages/patches.hpp:357
  logic [22:0] select_1807;
  assign select_1807 = and_1806_s16_q ? {select_1783, select_1757, select_1752, select_1747} : patches_choices_rdata_s16_q;
  // hls/stages/patches.hpp:475
  logic [14:0] sum_1910;
  assign sum_1910 = {{4{patches_down_values_3_s16_q[10]}}, patches_down_values_3_s16_q} + {sum_1909_s16_q, sum_1908_s16_q, down_2_s16_q};
  // hls/stages/patches.hpp:454
  logic and_1933;
  assign and_1933 = difference_1929_s16_q[8] & (~(difference_1929_s16_q[7:0] == 8'h0));
  // hls/stages/patches.hpp:457
  logic and_1937;
  assign and_1937 = (~difference_1929_s16_q[14]) & (and_1933 | (~(difference_1929_s16_q[13:9] == 5'h0)));
  // hls/stages/patches.hpp:453
  logic and_1940;
  assign and_1940 = difference_1929_s16_q[14] & (~(difference_1929_s16_q[13:8] == 6'h3f));
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2008;
  assign select_2008 = segment_started_s16_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:911
  logic [6:0] sum_2009;
  assign sum_2009 = {6'h0, and_2007_s16_q} + select_2008;
  // hls/stages/agreement.hpp:1072
  logic [9:0] sum_2011;
  assign sum_2011 = {3'h0, sum_2009} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[9:0]);
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2013;
  assign select_2013 = segment_started_s16_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:911
  logic [6:0] sum_2014;
  assign sum_2014 = {6'h0, and_2012_s16_q} + select_2013;
  // hls/stages/agreement.hpp:1073
  logic [9:0] sum_2016;
  assign sum_2016 = {3'h0, sum_2014} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[19:10]);
  // hls/stages/agreement.hpp:910
  logic [6:0] select_2024;
  assign select_2024 = segment_started_s16_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:912
  logic [6:0] sum_2025;
  assign sum_2025 = {6'h0, and_2023_s16_q} + select_2024;
  // hls/stages/agreement.hpp:1074
  logic [9:0] sum_2027;
  assign sum_2027 = {3'h0, sum_2025} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[29:20]);
  // hls/stages/agreement.hpp:1287
  logic or_2039;
  assign or_2039 = marks_first_s16_q | line_ended_q;
  // hls/stages/agreement.hpp:1289
  logic [12:0] select_2041;
  assign select_2041 = marks_first_s16_q ? 13'h1 : (or_2039 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1288
  logic [8:0] select_2043;
  assign select_2043 = or_2039 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1296
  logic select_2045;
  assign select_2045 = cfg_compete_i ? (or_2039 & select_2041[12]) : (select_2043[8] & select_2041[9]);
  // hls/stages/agreement.hpp:1098
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2072_s16_q} + ({2'h0, and_2073_s16_q} + {1'b0, sum_2077_s16_q});
  // hls/stages/agreement.hpp:1100
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2106_s16_q} + sum_2112_s16_q;
  // hls/stages/agreement.hpp:1107
  logic [2:0] select_2114;
  assign select_2114 = age_s16_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1101
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2122_s16_q} + sum_2128_s16_q;
  // hls/stages/agreement.hpp:1108
  logic [2:0] select_2130;
  assign select_2130 = age_s16_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:221
  logic [9:0] xor_2186;
  assign xor_2186 = {difference_2185_s16_q[8:0], sum_2184_s16_q} ^ {10{difference_2185_s16_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2185_s16_q[9]} + {1'b0, xor_2186};
  logic [9:0] xor_2194;
  assign xor_2194 = {difference_2193_s16_q[8:0], sum_2192_s16_q} ^ {10{difference_2193_s16_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2193_s16_q[9]} + {1'b0, xor_2194};
  // hls/stages/agreement.hpp:530
  logic select_2210;
  assign select_2210 = and_552_s16_q ? whole_2_s16_q : census_columns_values_0_cell_0_mask_q;
  logic select_2226;
  assign select_2226 = and_552_s16_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2229;
  assign select_2229 = and_552_s16_q ? census_columns_values_0_cell_1_mask_s16_q : census_columns_values_1_cell_1_mask_q;
  logic select_2236;
  assign select_2236 = and_552_s16_q ? census_columns_values_0_cell_3_mask_s16_q : census_columns_values_1_cell_3_mask_q;
  logic select_2239;
  assign select_2239 = and_552_s16_q ? census_columns_values_0_cell_4_mask_s16_q : census_columns_values_1_cell_4_mask_q;
  logic select_2242;
  assign select_2242 = and_552_s16_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2245;
  assign select_2245 = and_552_s16_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] sum_2267;
  assign sum_2267 = {9'h0, difference_2265_s16_q} + {1'b0, xor_2266_s16_q};
  logic [9:0] sum_2270;
  assign sum_2270 = {9'h0, difference_2268_s16_q} + {1'b0, xor_2269_s16_q};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2302;
  assign sum_2302 = {13'h0, moments_turns_0_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2304;
  assign sum_2304 = {13'h0, moments_turns_1_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:798
  logic and_2345;
  assign and_2345 = not_580_s16_q & (equal_581_s16_q & (inside_v_s16_q & and_1604_s16_q));
  logic and_2349;
  assign and_2349 = not_580_s16_q & (equal_581_s16_q & (inside_v_s16_q & and_1613_s16_q));
  // hls/stages/census.hpp:371
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2376_s16_q} + xor_2377_s16_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2388_s16_q} + xor_2389_s16_q;
  // hls/stages/agreement.hpp:798
  logic and_2631;
  assign and_2631 = not_578_s16_q & (so_s16_q & (ends_cell_s16_q & and_2012_s16_q));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2633;
  assign select_2633 = and_2614_s16_q ? 14'h0 : (counts_explained_q + {13'h0, and_2631});
  // hls/stages/agreement.hpp:798
  logic and_2636;
  assign and_2636 = not_578_s16_q & (so_s16_q & (ends_cell_s16_q & and_2023_s16_q));
  // hls/stages/agreement.hpp:1099
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2643_s16_q} + sum_2649_s16_q;
  // hls/stages/agreement.hpp:1106
  logic [2:0] select_2651;
  assign select_2651 = age_s16_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1144
  logic less_2667;
  assign less_2667 = region_row_s16_q < x_s16_q[5:3];
  // hls/stages/patches.hpp:349
  logic not_3009;
  assign not_3009 = ~and_1789_s16_q;
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_1894_s16_q ? patches_right_codes_rdata_s16_q : 28'h0;
  // hls/stages/patches.hpp:526
  logic [47:0] select_3178;
  assign select_3178 = new_row_s16_q ? patches_left_codes_rdata_s16_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3180;
  assign select_3180 = equal_1791_s16_q ? patches_left_row_q : (equal_1793_s16_q ? select_3178 : patches_left_row_q);
  logic [4:0] select_3525;
  assign select_3525 = equal_1793_s16_q ? patches_along_s16_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3582;
  assign select_3582 = (patches_read_far_s16_q < patches_peak_far_q) ? patches_read_far_s16_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3584;
  assign select_3584 = equal_1791_s16_q ? (patches_read_first_s16_q ? patches_read_far_s16_q : select_3582) : patches_peak_far_q;
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3622;
  assign sum_3622 = {1'b0, fall_2_s16_q} + {2'h0, fall_2_s16_q[9:1]};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3626;
  assign sum_3626 = {1'b0, fall_2_s16_q} + {3'h0, fall_2_s16_q[9:2]};
  logic less_3630;
  assign less_3630 = {eight_s16_q, 3'h0} < ({fall_2_s16_q, 3'h0} - {3'h0, fall_2_s16_q});
  // hls/stages/agreement.hpp:1243
  logic [13:0] select_3934;
  assign select_3934 = equal_3681_s16_q ? 14'h0 : product_q;
  logic [13:0] select_3953;
  assign select_3953 = equal_3947_s16_q ? 14'h0 : of_s16_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3934} + {1'b0, select_3953};
  // hls/stages/agreement.hpp:798
  logic [2:0] select_3995;
  assign select_3995 = so_s16_q ? (ends_cell_s16_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3997;
  assign select_3997 = ends_cell_s16_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3999;
  assign select_3999 = equal_577_s16_q ? box_explained_columns_values_1_q : (so_s16_q ? select_3997 : box_explained_columns_values_1_q);
  logic [2:0] select_4000;
  assign select_4000 = ends_cell_s16_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4002;
  assign select_4002 = equal_577_s16_q ? box_explained_columns_values_2_q : (so_s16_q ? select_4000 : box_explained_columns_values_2_q);
  logic [2:0] select_4003;
  assign select_4003 = ends_cell_s16_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4005;
  assign select_4005 = equal_577_s16_q ? box_explained_columns_values_3_q : (so_s16_q ? select_4003 : box_explained_columns_values_3_q);
  logic [2:0] select_4006;
  assign select_4006 = ends_cell_s16_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4008;
  assign select_4008 = equal_577_s16_q ? box_explained_columns_values_4_q : (so_s16_q ? select_4006 : box_explained_columns_values_4_q);
  logic [2:0] select_4013;
  assign select_4013 = so_s16_q ? (ends_cell_s16_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4015;
  assign select_4015 = ends_cell_s16_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4017;
  assign select_4017 = equal_577_s16_q ? box_shown_columns_values_1_q : (so_s16_q ? select_4015 : box_shown_columns_values_1_q);
  logic [2:0] select_4018;
  assign select_4018 = ends_cell_s16_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4020;
  assign select_4020 = equal_577_s16_q ? box_shown_columns_values_2_q : (so_s16_q ? select_4018 : box_shown_columns_values_2_q);
  logic [2:0] select_4021;
  assign select_4021 = ends_cell_s16_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4023;
  assign select_4023 = equal_577_s16_q ? box_shown_columns_values_3_q : (so_s16_q ? select_4021 : box_shown_columns_values_3_q);
  logic [2:0] select_4024;
  assign select_4024 = ends_cell_s16_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4026;
  assign select_4026 = equal_577_s16_q ? box_shown_columns_values_4_q : (so_s16_q ? select_4024 : box_shown_columns_values_4_q);
  logic [2:0] select_4031;
  assign select_4031 = so_s16_q ? (ends_cell_s16_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4033;
  assign select_4033 = ends_cell_s16_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4035;
  assign select_4035 = equal_577_s16_q ? box_nearer_columns_values_1_q : (so_s16_q ? select_4033 : box_nearer_columns_values_1_q);
  logic [2:0] select_4036;
  assign select_4036 = ends_cell_s16_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4038;
  assign select_4038 = equal_577_s16_q ? box_nearer_columns_values_2_q : (so_s16_q ? select_4036 : box_nearer_columns_values_2_q);
  logic [2:0] select_4039;
  assign select_4039 = ends_cell_s16_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4041;
  assign select_4041 = equal_577_s16_q ? box_nearer_columns_values_3_q : (so_s16_q ? select_4039 : box_nearer_columns_values_3_q);
  logic [2:0] select_4042;
  assign select_4042 = ends_cell_s16_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4044;
  assign select_4044 = equal_577_s16_q ? box_nearer_columns_values_4_q : (so_s16_q ? select_4042 : box_nearer_columns_values_4_q);

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s16_2_q;
  logic best_left_we;
  assign best_left_we = s16_en & and_1568_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1567_s16_q, select_1564_s16_q, select_1561_s16_q, select_1559_s16_q, select_1541_s16_q, select_1538_s16_q, select_1530_s16_q, select_1529_s16_q, select_1524_s16_q};
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
  assign best_right_we = s16_en & and_1568_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1578_s16_q, select_1577_s16_q, select_1574_s16_q, select_1573_s16_q};
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
  assign left_turns_we = s16_en & and_1607_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1604_s16_q, and_1601_s16_q};
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
  assign right_turns_we = s16_en & and_1607_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1613_s16_q, and_1610_s16_q};
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
  assign patches_choices_waddr = {patches_choosing_band_s16_q, and_1705_s16_q};
  logic patches_choices_we;
  assign patches_choices_we = s16_en & and_1790_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {select_1783, select_1757, select_1752, select_1747};
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
      moments_turned_0_q <= sum_2302;
      moments_turned_1_q <= sum_2304;
      moments_turns_0_q <= not_578_s16_q & and_2345;
      moments_turns_1_q <= not_578_s16_q & and_2349;
      counts_explained_q <= select_2633;
      patches_fixed_q <= not_3009 & (patches_fixed_q | (and_3019_s16_q & and_1746));
      patches_choice_valid_q <= and_1789_s16_q ? (select_1747 & not_3009) : select_1747;
      patches_choice_column_q <= select_1752;
      patches_choice_shift_q <= select_1757;
      patches_choice_slope_q <= select_1783;
      patches_left_row_q <= select_3180;
      patches_summed_row_column_q <= equal_1791_s16_q ? patches_summed_row_column_q : select_3525;
      patches_peak_far_q <= select_3584;
      segment_textured_q <= select_2008 + {6'h0, and_2626_s16_q};
      segment_explained_q <= select_2013 + {6'h0, and_2631};
      segment_nearer_q <= select_2024 + {6'h0, and_2636};
      product_q <= equal_577_s16_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2041;
      columns_passed_q <= {select_2043[7:0], or_2039};
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
      census_columns_values_0_cell_0_mask_q <= select_2210;
      census_columns_values_1_cell_0_mask_q <= select_2226;
      census_columns_values_1_cell_1_mask_q <= select_2229;
      census_columns_values_1_cell_3_mask_q <= select_2236;
      census_columns_values_1_cell_4_mask_q <= select_2239;
      census_columns_values_2_cell_0_mask_q <= select_2242;
      census_columns_values_2_cell_1_mask_q <= select_2245;
      box_explained_columns_values_0_q <= equal_577_s16_q ? box_explained_columns_values_0_q : select_3995;
      box_explained_columns_values_1_q <= select_3999;
      box_explained_columns_values_2_q <= select_4002;
      box_explained_columns_values_3_q <= select_4005;
      box_explained_columns_values_4_q <= select_4008;
      box_shown_columns_values_0_q <= equal_577_s16_q ? box_shown_columns_values_0_q : select_4013;
      box_shown_columns_values_1_q <= select_4017;
      box_shown_columns_values_2_q <= select_4020;
      box_shown_columns_values_3_q <= select_4023;
      box_shown_columns_values_4_q <= select_4026;
      box_nearer_columns_values_0_q <= equal_577_s16_q ? box_nearer_columns_values_0_q : select_4031;
      box_nearer_columns_values_1_q <= select_4035;
      box_nearer_columns_values_2_q <= select_4038;
      box_nearer_columns_values_3_q <= select_4041;
      box_nearer_columns_values_4_q <= select_4044;
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
  logic less_675_s17_q;
  logic less_676_s17_q;
  logic less_677_s17_q;
  logic less_678_s17_q;
  logic less_679_s17_q;
  logic less_680_s17_q;
  logic less_681_s17_q;
  logic and_689_s17_q;
  logic whole_9_s17_q;
  logic [10:0] sum_722_s17_q;
  logic [9:0] sum_725_s17_q;
  logic [9:0] sum_729_s17_q;
  logic [9:0] sum_733_s17_q;
  logic less_744_s17_q;
  logic less_746_s17_q;
  logic less_750_s17_q;
  logic less_752_s17_q;
  logic equal_1614_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1620_s17_q;
  logic equal_1622_s17_q;
  logic equal_1624_s17_q;
  logic equal_1626_s17_q;
  logic equal_1628_s17_q;
  logic equal_1630_s17_q;
  logic equal_1632_s17_q;
  logic equal_1634_s17_q;
  logic equal_1636_s17_q;
  logic less_1645_s17_q;
  logic or_1649_s17_q;
  logic [31:0] registration_sums_rdata_s17_q;
  logic equal_1669_s17_q;
  logic and_1679_s17_q;
  logic select_1696_s17_q;
  logic equal_1697_s17_q;
  logic equal_1707_s17_q;
  logic equal_1791_s17_q;
  logic equal_1793_s17_q;
  logic equal_1796_s17_q;
  logic or_1797_s17_q;
  logic not_1798_s17_q;
  logic [22:0] select_1807_s17_q;
  logic [4:0] select_1821_s17_q;
  logic select_1827_s17_q;
  logic [3:0] select_1865_s17_q;
  logic less_1881_s17_q;
  logic new_row_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic not_1911_s17_q;
  logic and_1914_s17_q;
  logic not_1916_s17_q;
  logic and_1921_s17_q;
  logic and_1937_s17_q;
  logic and_1940_s17_q;
  logic and_1954_s17_q;
  logic and_1963_s17_q;
  logic and_1968_s17_q;
  logic or_1986_s17_q;
  logic or_1989_s17_q;
  logic or_1992_s17_q;
  logic not_1994_s17_q;
  logic [9:0] sum_2011_s17_q;
  logic [9:0] sum_2016_s17_q;
  logic [9:0] sum_2027_s17_q;
  logic and_2028_s17_q;
  logic select_2045_s17_q;
  logic select_2056_s17_q;
  logic not_2058_s17_q;
  logic select_2070_s17_q;
  logic [2:0] textured_2_s17_q;
  logic or_2089_s17_q;
  logic or_2092_s17_q;
  logic or_2095_s17_q;
  logic [3:0] difference_2115_s17_q;
  logic [3:0] difference_2131_s17_q;
  logic and_2147_s17_q;
  logic [10:0] size_s17_q;
  logic [10:0] size_2_s17_q;
  logic [10:0] sum_2271_s17_q;
  logic [9:0] sum_2274_s17_q;
  logic [9:0] sum_2278_s17_q;
  logic [9:0] sum_2282_s17_q;
  logic equal_2290_s17_q;
  logic equal_2305_s17_q;
  logic [8:0] contrast_s17_q;
  logic [8:0] contrast_2_s17_q;
  logic equal_2479_s17_q;
  logic and_2614_s17_q;
  logic and_2621_s17_q;
  logic and_2636_s17_q;
  logic not_2642_s17_q;
  logic [3:0] difference_2652_s17_q;
  logic [9:0] select_2668_s17_q;
  logic [9:0] select_2671_s17_q;
  logic and_2721_s17_q;
  logic and_2739_s17_q;
  logic and_2747_s17_q;
  logic and_2781_s17_q;
  logic and_2782_s17_q;
  logic [7:0] residual_s17_q;
  logic and_2818_s17_q;
  logic and_2832_s17_q;
  logic equal_2874_s17_q;
  logic [27:0] word_s17_q;
  logic equal_3139_s17_q;
  logic less_3145_s17_q;
  logic [47:0] select_3178_s17_q;
  logic equal_3488_s17_q;
  logic [9:0] select_3574_s17_q;
  logic [4:0] select_3575_s17_q;
  logic [4:0] select_3576_s17_q;
  logic equal_3585_s17_q;
  logic less_3613_s17_q;
  logic not_3621_s17_q;
  logic not_3624_s17_q;
  logic not_3628_s17_q;
  logic not_3631_s17_q;
  logic equal_3681_s17_q;
  logic and_3897_s17_q;
  logic less_3898_s17_q;
  logic equal_3899_s17_q;
  logic equal_3913_s17_q;
  logic equal_3916_s17_q;
  logic equal_3918_s17_q;
  logic equal_3919_s17_q;
  logic equal_3920_s17_q;
  logic equal_3921_s17_q;
  logic sum_4_s17_q;
  logic or_4063_s17_q;
  logic and_4077_s17_q;
  logic and_4094_s17_q;
  logic not_4106_s17_q;
  logic equal_4159_s17_q;
  logic [9:0] select_4169_s17_q;
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
      less_675_s17_q <= less_675_s16_q;
      less_676_s17_q <= less_676_s16_q;
      less_677_s17_q <= less_677_s16_q;
      less_678_s17_q <= less_678_s16_q;
      less_679_s17_q <= less_679_s16_q;
      less_680_s17_q <= less_680_s16_q;
      less_681_s17_q <= less_681_s16_q;
      and_689_s17_q <= and_689_s16_q;
      whole_9_s17_q <= whole_9;
      sum_722_s17_q <= {1'b0, sum_718} + {1'b0, sum_721};
      sum_725_s17_q <= {9'h0, difference_723_s16_q} + {1'b0, xor_724_s16_q};
      sum_729_s17_q <= {9'h0, difference_727_s16_q} + {1'b0, xor_728_s16_q};
      sum_733_s17_q <= {9'h0, difference_731_s16_q} + {1'b0, xor_732_s16_q};
      less_744_s17_q <= less_744;
      less_746_s17_q <= $signed(10'h0) < $signed(half_grey_levels_s16_q);
      less_750_s17_q <= less_750;
      less_752_s17_q <= $signed(10'h0) < $signed(half_grey_levels_2_s16_q);
      equal_1614_s17_q <= equal_1614_s16_q;
      all_s17_q <= all_s16_q;
      sum_1620_s17_q <= sum_1620_s16_q;
      equal_1622_s17_q <= equal_1622_s16_q;
      equal_1624_s17_q <= equal_1624_s16_q;
      equal_1626_s17_q <= equal_1626_s16_q;
      equal_1628_s17_q <= equal_1628_s16_q;
      equal_1630_s17_q <= equal_1630_s16_q;
      equal_1632_s17_q <= equal_1632_s16_q;
      equal_1634_s17_q <= equal_1634_s16_q;
      equal_1636_s17_q <= equal_1636_s16_q;
      less_1645_s17_q <= less_1645_s16_q;
      or_1649_s17_q <= or_1649_s16_q;
      registration_sums_rdata_s17_q <= registration_sums_rdata_q;
      equal_1669_s17_q <= equal_1669_s16_q;
      and_1679_s17_q <= and_1679_s16_q;
      select_1696_s17_q <= select_1696_s16_q;
      equal_1697_s17_q <= equal_1697_s16_q;
      equal_1707_s17_q <= equal_1707_s16_q;
      equal_1791_s17_q <= equal_1791_s16_q;
      equal_1793_s17_q <= equal_1793_s16_q;
      equal_1796_s17_q <= equal_1796_s16_q;
      or_1797_s17_q <= or_1797_s16_q;
      not_1798_s17_q <= not_1798_s16_q;
      select_1807_s17_q <= select_1807;
      select_1821_s17_q <= select_1821_s16_q;
      select_1827_s17_q <= select_1827_s16_q;
      select_1865_s17_q <= select_1865_s16_q;
      less_1881_s17_q <= less_1881_s16_q;
      new_row_s17_q <= new_row_s16_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      not_1911_s17_q <= ~sum_1910[14];
      and_1914_s17_q <= sum_1910[8] & (~(sum_1910[7:0] == 8'h0));
      not_1916_s17_q <= ~(sum_1910[13:9] == 5'h0);
      and_1921_s17_q <= sum_1910[14] & (~(sum_1910[13:8] == 6'h3f));
      and_1937_s17_q <= and_1937;
      and_1940_s17_q <= and_1940;
      and_1954_s17_q <= and_1954_s16_q;
      and_1963_s17_q <= and_1963_s16_q;
      and_1968_s17_q <= and_1968_s16_q;
      or_1986_s17_q <= or_1986_s16_q;
      or_1989_s17_q <= or_1989_s16_q;
      or_1992_s17_q <= or_1992_s16_q;
      not_1994_s17_q <= not_1994_s16_q;
      sum_2011_s17_q <= sum_2011;
      sum_2016_s17_q <= sum_2016;
      sum_2027_s17_q <= sum_2027;
      and_2028_s17_q <= and_2028_s16_q;
      select_2045_s17_q <= select_2045;
      select_2056_s17_q <= select_2056_s16_q;
      not_2058_s17_q <= not_2058_s16_q;
      select_2070_s17_q <= select_2070_s16_q;
      textured_2_s17_q <= textured_2;
      or_2089_s17_q <= or_2089_s16_q;
      or_2092_s17_q <= or_2092_s16_q;
      or_2095_s17_q <= or_2095_s16_q;
      difference_2115_s17_q <= {1'b0, shown_2} - {1'b0, select_2114};
      difference_2131_s17_q <= {1'b0, near_2} - {1'b0, select_2130};
      and_2147_s17_q <= and_2147_s16_q;
      size_s17_q <= size;
      size_2_s17_q <= size_2;
      sum_2271_s17_q <= {1'b0, sum_2267} + {1'b0, sum_2270};
      sum_2274_s17_q <= {9'h0, difference_2272_s16_q} + {1'b0, xor_2273_s16_q};
      sum_2278_s17_q <= {9'h0, difference_2276_s16_q} + {1'b0, xor_2277_s16_q};
      sum_2282_s17_q <= {9'h0, difference_2280_s16_q} + {1'b0, xor_2281_s16_q};
      equal_2290_s17_q <= equal_2290_s16_q;
      equal_2305_s17_q <= equal_2305_s16_q;
      contrast_s17_q <= contrast;
      contrast_2_s17_q <= contrast_2;
      equal_2479_s17_q <= equal_2479_s16_q;
      and_2614_s17_q <= and_2614_s16_q;
      and_2621_s17_q <= and_2621_s16_q;
      and_2636_s17_q <= and_2636;
      not_2642_s17_q <= not_2642_s16_q;
      difference_2652_s17_q <= {1'b0, explained_2} - {1'b0, select_2651};
      select_2668_s17_q <= less_2667 ? 10'h0 : regions_rdata_s16_q[9:0];
      select_2671_s17_q <= less_2667 ? 10'h0 : regions_rdata_s16_q[19:10];
      and_2721_s17_q <= and_2721_s16_q;
      and_2739_s17_q <= and_2739_s16_q;
      and_2747_s17_q <= and_2747_s16_q;
      and_2781_s17_q <= and_2781_s16_q;
      and_2782_s17_q <= and_2782_s16_q;
      residual_s17_q <= residual_s16_q;
      and_2818_s17_q <= and_2782_s16_q & less_2817_s16_q;
      and_2832_s17_q <= and_2782_s16_q & less_2831_s16_q;
      equal_2874_s17_q <= equal_2874_s16_q;
      word_s17_q <= word;
      equal_3139_s17_q <= patches_along_s16_q == 5'h7;
      less_3145_s17_q <= less_3145_s16_q;
      select_3178_s17_q <= select_3178;
      equal_3488_s17_q <= equal_3488_s16_q;
      select_3574_s17_q <= select_3574_s16_q;
      select_3575_s17_q <= select_3575_s16_q;
      select_3576_s17_q <= select_3576_s16_q;
      equal_3585_s17_q <= equal_3585_s16_q;
      less_3613_s17_q <= less_3613_s16_q;
      not_3621_s17_q <= ~({eight_s16_q, 3'h0} < {3'h0, fall_2_s16_q});
      not_3624_s17_q <= ~({eight_s16_q, 3'h0} < {1'b0, sum_3622, fall_2_s16_q[0]});
      not_3628_s17_q <= ~({eight_s16_q, 3'h0} < {sum_3626, fall_2_s16_q[1:0]});
      not_3631_s17_q <= ~less_3630;
      equal_3681_s17_q <= equal_3681_s16_q;
      and_3897_s17_q <= and_3897_s16_q;
      less_3898_s17_q <= counts_explained_q < product_q;
      equal_3899_s17_q <= counts_explained_q == product_q;
      equal_3913_s17_q <= equal_3913_s16_q;
      equal_3916_s17_q <= equal_3916_s16_q;
      equal_3918_s17_q <= equal_3918_s16_q;
      equal_3919_s17_q <= equal_3919_s16_q;
      equal_3920_s17_q <= equal_3920_s16_q;
      equal_3921_s17_q <= equal_3921_s16_q;
      sum_4_s17_q <= sum_4[0];
      or_4063_s17_q <= or_4063_s16_q;
      and_4077_s17_q <= and_4077_s16_q;
      and_4094_s17_q <= and_4094_s16_q;
      not_4106_s17_q <= not_4106_s16_q;
      equal_4159_s17_q <= equal_4159_s16_q;
      select_4169_s17_q <= less_2667 ? 10'h0 : regions_rdata_s16_q[29:20];
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
  logic [10:0] sum_726;
  assign sum_726 = sum_722_s17_q + {1'b0, sum_725_s17_q};
  // hls/stages/agreement.hpp:461
  logic and_740;
  assign and_740 = census_columns_values_0_cell_2_mask_s17_q & census_columns_values_1_cell_2_mask_q;
  logic and_741;
  assign and_741 = and_689_s17_q & and_740;
  // hls/stages/registration.hpp:265
  logic equal_1671;
  assign equal_1671 = sum_1620_s17_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1620_s17_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1677;
  assign select_1677 = equal_1671 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1678;
  assign sum_1678 = (equal_1669_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0) + {{5{select_1677[6]}}, select_1677};
  // hls/stages/patches.hpp:358
  logic [21:0] select_1811;
  assign select_1811 = select_1696_s17_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1807_s17_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1812;
  assign select_1812 = equal_1697_s17_q ? patches_place_0_column_q : select_1811[7:0];
  logic [5:0] select_1813;
  assign select_1813 = equal_1697_s17_q ? patches_place_0_shift_q : select_1811[13:8];
  // hls/stages/patches.hpp:358
  logic [21:0] select_1839;
  assign select_1839 = select_1696_s17_q ? select_1807_s17_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1840;
  assign select_1840 = equal_1697_s17_q ? patches_place_1_column_q : select_1839[7:0];
  logic [5:0] select_1841;
  assign select_1841 = equal_1697_s17_q ? patches_place_1_shift_q : select_1839[13:8];
  // hls/stages/patches.hpp:133
  logic equal_1856;
  assign equal_1856 = {select_1812[7], select_546_s17_q, select_511_s17_q} == {1'b0, select_1812[6:0], 4'h0};
  logic equal_1860;
  assign equal_1860 = {select_1840[7], select_546_s17_q, select_511_s17_q} == {1'b0, select_1840[6:0], 4'h0};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_1902;
  assign sum_1902 = patches_code_row_s17_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_1918;
  assign and_1918 = not_1911_s17_q & (and_1914_s17_q | not_1916_s17_q);
  // hls/stages/patches.hpp:494
  logic [1:0] sum_1958;
  assign sum_1958 = patches_code_row_s17_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = select_2045_s17_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1303
  logic [6:0] select_2048;
  assign select_2048 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1314
  logic equal_2051;
  assign equal_2051 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1105
  logic [2:0] select_2080;
  assign select_2080 = age_s17_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1112
  logic not_2096;
  assign not_2096 = ~region_row_s17_q[2];
  logic [2:0] select_2097;
  assign select_2097 = region_row_s17_q[1] ? {1'b0, not_2096, 1'b0} : {region_row_s17_q[2], 1'b0, not_2096};
  logic [5:0] select_2098;
  assign select_2098 = region_row_s17_q[0] ? {select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0], 1'b0} : {1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0]};
  logic [11:0] select_2099;
  assign select_2099 = or_2095_s17_q ? {select_2098[5], 1'b0, select_2098[4], 1'b0, select_2098[3], 1'b0, select_2098[2], 1'b0, select_2098[1], 1'b0, select_2098[0], 1'b0} : {1'b0, select_2098[5], 1'b0, select_2098[4], 1'b0, select_2098[3], 1'b0, select_2098[2], 1'b0, select_2098[1], 1'b0, select_2098[0]};
  logic [23:0] select_2100;
  assign select_2100 = or_2092_s17_q ? {select_2099[11], 1'b0, select_2099[10], 1'b0, select_2099[9], 1'b0, select_2099[8], 1'b0, select_2099[7], 1'b0, select_2099[6], 1'b0, select_2099[5], 1'b0, select_2099[4], 1'b0, select_2099[3], 1'b0, select_2099[2], 1'b0, select_2099[1], 1'b0, select_2099[0], 1'b0} : {1'b0, select_2099[11], 1'b0, select_2099[10], 1'b0, select_2099[9], 1'b0, select_2099[8], 1'b0, select_2099[7], 1'b0, select_2099[6], 1'b0, select_2099[5], 1'b0, select_2099[4], 1'b0, select_2099[3], 1'b0, select_2099[2], 1'b0, select_2099[1], 1'b0, select_2099[0]};
  // hls/stages/agreement.hpp:1107
  logic [4:0] around;
  assign around = {difference_2115_s17_q[3], difference_2115_s17_q} + (equal_572_s17_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1108
  logic [4:0] n;
  assign n = {difference_2131_s17_q[3], difference_2131_s17_q} + (equal_572_s17_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size_s17_q} + (equal_555_s17_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2191;
  assign select_2191 = sample_pair_whole_s17_q ? (and_550_s17_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s17_q} + (equal_555_s17_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2199;
  assign select_2199 = sample_pair_whole_s17_q ? (and_550_s17_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:530
  logic select_2232;
  assign select_2232 = and_552_s17_q ? census_columns_values_0_cell_2_mask_s17_q : census_columns_values_1_cell_2_mask_q;
  logic select_2248;
  assign select_2248 = and_552_s17_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2251;
  assign select_2251 = and_552_s17_q ? census_columns_values_1_cell_3_mask_s17_q : census_columns_values_2_cell_3_mask_q;
  logic select_2254;
  assign select_2254 = and_552_s17_q ? census_columns_values_1_cell_4_mask_s17_q : census_columns_values_2_cell_4_mask_q;
  logic select_2255;
  assign select_2255 = and_552_s17_q ? census_columns_values_2_cell_0_mask_s17_q : census_columns_values_3_cell_0_mask_q;
  logic select_2258;
  assign select_2258 = and_552_s17_q ? census_columns_values_2_cell_1_mask_s17_q : census_columns_values_3_cell_1_mask_q;
  logic select_2259;
  assign select_2259 = and_552_s17_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2262;
  assign select_2262 = and_552_s17_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:286
  logic [10:0] sum_2275;
  assign sum_2275 = sum_2271_s17_q + {1'b0, sum_2274_s17_q};
  // hls/stages/moments.hpp:117
  logic [13:0] select_2306;
  assign select_2306 = equal_2305_s17_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2308;
  assign select_2308 = equal_2305_s17_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2319;
  assign sum_2319 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2329;
  assign sum_2329 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/agreement.hpp:530
  logic select_2372;
  assign select_2372 = and_552_s17_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2375;
  assign and_2375 = whole_2_s17_q & (~(last_s17_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:462
  logic and_2381;
  assign and_2381 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s17_q[8:2]));
  logic and_2382;
  assign and_2382 = and_2375 & and_2381;
  logic and_2393;
  assign and_2393 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s17_q[8:2]));
  logic and_2394;
  assign and_2394 = and_2375 & and_2393;
  // hls/stages/census.hpp:427
  logic not_2411;
  assign not_2411 = ~x_s17_q[1];
  logic [2:0] select_2412;
  assign select_2412 = x_s17_q[0] ? {1'b0, not_2411, 1'b0} : {x_s17_q[1], 1'b0, not_2411};
  logic [5:0] select_2413;
  assign select_2413 = slot_s17_q[2] ? {select_2412[2], 1'b0, select_2412[1], 1'b0, select_2412[0], 1'b0} : {1'b0, select_2412[2], 1'b0, select_2412[1], 1'b0, select_2412[0]};
  logic [11:0] select_2414;
  assign select_2414 = slot_s17_q[1] ? {select_2413[5], 1'b0, select_2413[4], 1'b0, select_2413[3], 1'b0, select_2413[2], 1'b0, select_2413[1], 1'b0, select_2413[0], 1'b0} : {1'b0, select_2413[5], 1'b0, select_2413[4], 1'b0, select_2413[3], 1'b0, select_2413[2], 1'b0, select_2413[1], 1'b0, select_2413[0]};
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2623;
  assign select_2623 = and_2614_s17_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2621_s17_q});
  logic [13:0] select_2638;
  assign select_2638 = and_2614_s17_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2636_s17_q});
  // hls/stages/agreement.hpp:1106
  logic [4:0] e;
  assign e = {difference_2652_s17_q[3], difference_2652_s17_q} + (equal_572_s17_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2741;
  assign select_2741 = and_2614_s17_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2739_s17_q});
  logic [13:0] select_2749;
  assign select_2749 = and_2614_s17_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2747_s17_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2799;
  assign select_2799 = equal_1707_s17_q ? (and_2782_s17_q ? residual_s17_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic and_2806;
  assign and_2806 = not_578_s17_q & (so_s17_q & (and_2782_s17_q & equal_1707_s17_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2808;
  assign select_2808 = and_2781_s17_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2806});
  // hls/stages/registration.hpp:107
  logic and_2810;
  assign and_2810 = and_2782_s17_q & ($signed(residual_s17_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2820;
  assign select_2820 = so_s17_q ? (equal_1707_s17_q ? {and_2818_s17_q, and_2782_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2821;
  assign select_2821 = equal_577_s17_q ? 2'h0 : select_2820;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2822;
  assign sum_2822 = registration_half_votes_up_q + {{5{select_2821[1]}}, select_2821};
  // hls/stages/registration.hpp:205
  logic less_2824;
  assign less_2824 = $signed(residual_s17_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2825;
  assign and_2825 = and_2782_s17_q & less_2824;
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2834;
  assign select_2834 = so_s17_q ? (equal_1707_s17_q ? {and_2832_s17_q, and_2782_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2835;
  assign select_2835 = equal_577_s17_q ? 2'h0 : select_2834;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2836;
  assign sum_2836 = registration_half_half_votes_up_q + {{5{select_2835[1]}}, select_2835};
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2876;
  assign select_2876 = or_1649_s17_q ? 12'h0 : (equal_2874_s17_q ? registration_sums_rdata_s17_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1154
  logic [11:0] select_2878;
  assign select_2878 = equal_1614_s17_q ? 12'h0 : (less_1645_s17_q ? select_2876 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2881;
  assign and_2881 = x_s17_q[1] & all_s17_q;
  // hls/stages/agreement.hpp:1154
  logic and_2884;
  assign and_2884 = not_1994_s17_q & (less_1645_s17_q & ({and_2881, x_s17_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2891;
  assign select_2891 = or_1649_s17_q ? 12'h0 : (equal_2874_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1154
  logic [11:0] select_2893;
  assign select_2893 = equal_1614_s17_q ? 12'h0 : (less_1645_s17_q ? select_2891 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2899;
  assign not_2899 = ~all_s17_q;
  // hls/stages/agreement.hpp:1154
  logic and_2902;
  assign and_2902 = not_1994_s17_q & (less_1645_s17_q & (x_s17_q[2:0] == {all_s17_q, not_2899, 1'b0}));
  // hls/stages/agreement.hpp:798
  logic and_2908;
  assign and_2908 = equal_577_s17_q & (x_s17_q[6] & (not_1994_s17_q & (less_1645_s17_q & all_s17_q)));
  // hls/stages/registration.hpp:157
  logic equal_2935;
  assign equal_2935 = x_s17_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1154
  logic and_2938;
  assign and_2938 = not_1994_s17_q & (less_1645_s17_q & (x_s17_q[5] ? x_s17_q[3] : equal_2935));
  logic and_2947;
  assign and_2947 = not_1994_s17_q & (less_1645_s17_q & ((~x_s17_q[5]) & (x_s17_q[3] & equal_2935)));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3041;
  assign select_3041 = sample_pair_whole_s17_q ? (equal_1697_s17_q ? patches_place_0_slope_q : select_1811[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3046;
  assign select_3046 = sample_pair_whole_s17_q ? (equal_1697_s17_q ? patches_place_1_slope_q : select_1839[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s17_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3135;
  assign select_3135 = or_1797_s17_q ? {and_1940_s17_q, and_1937_s17_q, and_1921_s17_q, and_1918, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3137;
  assign select_3137 = equal_1791_s17_q ? patches_codes_at_q : (equal_1793_s17_q ? other[55:4] : select_3135);
  // hls/stages/patches.hpp:525
  logic [27:0] select_3140;
  assign select_3140 = equal_3139_s17_q ? word_s17_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3142;
  assign select_3142 = equal_1793_s17_q ? (new_row_s17_q ? word_s17_q : select_3140) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3144;
  assign select_3144 = less_1881_s17_q ? {word_s17_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3146;
  assign select_3146 = less_3145_s17_q ? {word_s17_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3148;
  assign select_3148 = or_1797_s17_q ? (equal_1796_s17_q ? patches_next_codes_q : select_3146) : patches_next_codes_q;
  logic [55:0] select_3150;
  assign select_3150 = equal_1791_s17_q ? patches_next_codes_q : (equal_1793_s17_q ? select_3144 : select_3148);
  // hls/stages/count_bits.hpp:24
  logic parity_3155;
  assign parity_3155 = ^{and_1940_s17_q, and_1937_s17_q, and_1921_s17_q, and_1918};
  // hls/stages/count_bits.hpp:25
  logic or_3159;
  assign or_3159 = ({and_1921_s17_q, and_1918} == 2'h3) | (and_1937_s17_q & (and_1921_s17_q | and_1918));
  logic and_3160;
  assign and_3160 = and_1940_s17_q & (^{and_1937_s17_q, and_1921_s17_q, and_1918});
  // hls/stages/count_bits.hpp:24
  logic xor_3161;
  assign xor_3161 = or_3159 ^ and_3160;
  // hls/stages/count_bits.hpp:27
  logic and_3162;
  assign and_3162 = or_3159 & and_3160;
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3178_s17_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3184;
  assign xor_3184 = bits[17] ^ (^{select_3178_s17_q[16:15], other[16:15]});
  logic xor_3187;
  assign xor_3187 = bits[11] ^ (^{select_3178_s17_q[10:9], other[10:9]});
  logic xor_3190;
  assign xor_3190 = bits[14] ^ (^{select_3178_s17_q[13:12], other[13:12]});
  logic xor_3193;
  assign xor_3193 = xor_3184 ^ (^{select_3178_s17_q[14:9], other[14:9]});
  logic xor_3196;
  assign xor_3196 = bits[47] ^ (^{select_3178_s17_q[46:45], other[46:45]});
  logic xor_3199;
  assign xor_3199 = bits[8] ^ (^{select_3178_s17_q[7:6], other[7:6]});
  logic xor_3202;
  assign xor_3202 = bits[2] ^ (^{select_3178_s17_q[1:0], other[1:0]});
  logic xor_3205;
  assign xor_3205 = bits[5] ^ (^{select_3178_s17_q[4:3], other[4:3]});
  logic xor_3208;
  assign xor_3208 = xor_3199 ^ (^{select_3178_s17_q[5:0], other[5:0]});
  logic parity_3210;
  assign parity_3210 = ^{select_3178_s17_q[47:45], select_3178_s17_q[8:0], other[47:45], other[8:0]};
  logic xor_3214;
  assign xor_3214 = bits[44] ^ (^{select_3178_s17_q[43:42], other[43:42]});
  logic xor_3217;
  assign xor_3217 = bits[38] ^ (^{select_3178_s17_q[37:36], other[37:36]});
  logic xor_3220;
  assign xor_3220 = bits[41] ^ (^{select_3178_s17_q[40:39], other[40:39]});
  logic xor_3226;
  assign xor_3226 = bits[26] ^ (^{select_3178_s17_q[25:24], other[25:24]});
  logic xor_3229;
  assign xor_3229 = bits[20] ^ (^{select_3178_s17_q[19:18], other[19:18]});
  logic xor_3232;
  assign xor_3232 = bits[23] ^ (^{select_3178_s17_q[22:21], other[22:21]});
  logic xor_3238;
  assign xor_3238 = bits[35] ^ (^{select_3178_s17_q[34:33], other[34:33]});
  logic xor_3241;
  assign xor_3241 = bits[29] ^ (^{select_3178_s17_q[28:27], other[28:27]});
  logic xor_3244;
  assign xor_3244 = bits[32] ^ (^{select_3178_s17_q[31:30], other[31:30]});
  // hls/stages/agreement.hpp:276
  logic select_3528;
  assign select_3528 = equal_1791_s17_q ? patches_summed_first_q : (equal_1793_s17_q ? new_row_s17_q : patches_summed_first_q);
  // hls/stages/patches.hpp:584
  logic [1:0] sum_3625;
  assign sum_3625 = {1'b0, not_3621_s17_q} + {1'b0, not_3624_s17_q};
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3632;
  assign sum_3632 = {1'b0, not_3628_s17_q} + {1'b0, not_3631_s17_q};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3625} + {1'b0, sum_3632};
  // hls/stages/patches.hpp:604
  logic [7:0] select_3636;
  assign select_3636 = patches_second_s17_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [3:0] sum_3637;
  assign sum_3637 = {2'h0, select_3575_s17_q[4:3]} + 4'hf;
  logic [5:0] select_3638;
  assign select_3638 = patches_second_s17_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3639;
  assign sum_3639 = {select_3638[5], select_3638} + {{4{sum_3637[3]}}, sum_3637[3:1]};
  // hls/stages/agreement.hpp:1200
  logic or_3894;
  assign or_3894 = ({counts_textured_s17_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s17_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1238
  logic too_little;
  assign too_little = less_3898_s17_q | (product_rest_q & equal_3899_s17_q);
  // hls/stages/agreement.hpp:1239
  logic select_3902;
  assign select_3902 = and_3897_s17_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1147
  logic [10:0] sum_3905;
  assign sum_3905 = {1'b0, select_2671_s17_q} + {2'h0, select_2671_s17_q[9:1]};
  // hls/stages/agreement.hpp:798
  logic select_3958;
  assign select_3958 = equal_577_s17_q ? (equal_3681_s17_q ? sum_4_s17_q : (product_rest_q | sum_4_s17_q)) : product_rest_q;
  logic [2:0] select_3976;
  assign select_3976 = ends_cell_s17_q ? textured_2_s17_q : box_textured_columns_values_0_q;
  logic [2:0] select_3978;
  assign select_3978 = equal_577_s17_q ? box_textured_columns_values_0_q : (so_s17_q ? select_3976 : box_textured_columns_values_0_q);
  logic [2:0] select_3979;
  assign select_3979 = ends_cell_s17_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3981;
  assign select_3981 = equal_577_s17_q ? box_textured_columns_values_1_q : (so_s17_q ? select_3979 : box_textured_columns_values_1_q);
  logic [2:0] select_3982;
  assign select_3982 = ends_cell_s17_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3984;
  assign select_3984 = equal_577_s17_q ? box_textured_columns_values_2_q : (so_s17_q ? select_3982 : box_textured_columns_values_2_q);
  logic [2:0] select_3985;
  assign select_3985 = ends_cell_s17_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3987;
  assign select_3987 = equal_577_s17_q ? box_textured_columns_values_3_q : (so_s17_q ? select_3985 : box_textured_columns_values_3_q);
  logic [2:0] select_3988;
  assign select_3988 = ends_cell_s17_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3990;
  assign select_3990 = equal_577_s17_q ? box_textured_columns_values_4_q : (so_s17_q ? select_3988 : box_textured_columns_values_4_q);
  logic [4:0] select_4010;
  assign select_4010 = so_s17_q ? (ends_cell_s17_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4011;
  assign select_4011 = equal_577_s17_q ? box_explained_sum_sums_values_0_q : select_4010;
  logic [4:0] select_4028;
  assign select_4028 = so_s17_q ? (ends_cell_s17_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4046;
  assign select_4046 = so_s17_q ? (ends_cell_s17_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1313
  logic [3:0] select_4080;
  assign select_4080 = select_2045_s17_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4086;
  assign select_4086 = marks_first_s17_q ? select_4084 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1152
  logic [31:0] select_4161;
  assign select_4161 = equal_1636_s17_q ? {2'h0, counts_explained_s17_q, 2'h0, counts_textured_s17_q} : (equal_4159_s17_q ? registration_sums_rdata_s17_q : 32'h0);
  logic [31:0] select_4162;
  assign select_4162 = equal_1634_s17_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4161;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1902, patches_code_row_s17_q[1:0], of_row_2_s17_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s17_en & and_1954_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1940_s17_q, and_1937_s17_q, and_1921_s17_q, and_1918, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1958, patches_code_row_s17_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s17_en & and_1968_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1940_s17_q, and_1937_s17_q, and_1921_s17_q, and_1918, patches_codes_at_q[51:8]};
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
  assign regions_waddr = {region_row_s17_q, or_1992_s17_q, or_1989_s17_q, or_1986_s17_q};
  logic regions_we;
  assign regions_we = s17_en & and_2028_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2027_s17_q, sum_2016_s17_q, sum_2011_s17_q};
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
      moments_before_0_q <= equal_577_s17_q ? select_2306 : moments_before_0_q;
      moments_before_1_q <= equal_577_s17_q ? select_2308 : moments_before_1_q;
      sharpness_before_last_mask_q <= select_2372;
      counts_supervised_q <= select_2623;
      counts_nearer_q <= select_2638;
      counts_turned_left_q <= select_2741;
      counts_turned_right_q <= select_2749;
      registration_half_measured_q <= select_2808;
      registration_half_votes_up_q <= and_2781_s17_q ? 7'h0 : sum_2822;
      registration_half_half_votes_up_q <= and_2781_s17_q ? 7'h0 : sum_2836;
      patches_place_0_column_q <= sample_pair_whole_s17_q ? select_1812 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s17_q ? select_1813 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3041;
      patches_place_1_column_q <= sample_pair_whole_s17_q ? select_1840 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s17_q ? select_1841 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3046;
      patches_codes_at_q <= select_3137;
      patches_codes_further_q <= equal_1791_s17_q ? patches_codes_further_q : select_3142;
      patches_next_codes_q <= select_3150;
      patches_summed_first_q <= select_3528;
      product_rest_q <= select_3958;
      disagree_q <= equal_577_s17_q ? select_3902 : disagree_q;
      began_q <= not_2058_s17_q & (began_q | select_2045_s17_q);
      seen_x_q <= select_2045_s17_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s17_q ? 4'h0 : select_4080;
      seen_column_q <= select_2045_s17_q ? 8'h0 : (seen_column_q + {7'h0, equal_2051});
      seen_rows_left_q <= select_4086;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s17_q ? 13'h0 : (seen_base_q + {6'h0, select_2048});
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
      averager_detail_0_q <= select_2191;
      averager_detail_1_q <= select_2199;
      census_columns_values_1_cell_2_mask_q <= select_2232;
      census_columns_values_2_cell_2_mask_q <= select_2248;
      census_columns_values_2_cell_3_mask_q <= select_2251;
      census_columns_values_2_cell_4_mask_q <= select_2254;
      census_columns_values_3_cell_0_mask_q <= select_2255;
      census_columns_values_3_cell_1_mask_q <= select_2258;
      census_columns_values_3_cell_2_mask_q <= select_2259;
      census_columns_values_3_cell_3_mask_q <= select_2262;
      sharpness_last_mask_q <= and_552_s17_q ? whole_2_s17_q : sharpness_last_mask_q;
      box_textured_columns_values_0_q <= select_3978;
      box_textured_columns_values_1_q <= select_3981;
      box_textured_columns_values_2_q <= select_3984;
      box_textured_columns_values_3_q <= select_3987;
      box_textured_columns_values_4_q <= select_3990;
      box_explained_sum_sums_values_0_q <= select_4011;
      box_shown_sum_sums_values_0_q <= equal_577_s17_q ? box_shown_sum_sums_values_0_q : select_4028;
      box_nearer_sum_sums_values_0_q <= equal_577_s17_q ? box_nearer_sum_sums_values_0_q : select_4046;
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
  logic less_675_s18_q;
  logic less_676_s18_q;
  logic less_677_s18_q;
  logic less_678_s18_q;
  logic less_679_s18_q;
  logic less_680_s18_q;
  logic less_681_s18_q;
  logic and_689_s18_q;
  logic whole_16_s18_q;
  logic and_715_s18_q;
  logic [11:0] sum_730_s18_q;
  logic [9:0] sum_733_s18_q;
  logic and_741_s18_q;
  logic and_745_s18_q;
  logic less_746_s18_q;
  logic less_750_s18_q;
  logic less_752_s18_q;
  logic equal_1614_s18_q;
  logic [1:0] sum_1620_s18_q;
  logic equal_1622_s18_q;
  logic equal_1624_s18_q;
  logic equal_1626_s18_q;
  logic equal_1628_s18_q;
  logic equal_1630_s18_q;
  logic equal_1632_s18_q;
  logic less_1645_s18_q;
  logic [19:0] select_1670_s18_q;
  logic equal_1671_s18_q;
  logic [11:0] sum_1678_s18_q;
  logic and_1679_s18_q;
  logic select_1696_s18_q;
  logic equal_1697_s18_q;
  logic equal_1791_s18_q;
  logic equal_1793_s18_q;
  logic equal_1796_s18_q;
  logic or_1797_s18_q;
  logic not_1798_s18_q;
  logic select_1807_s18_q;
  logic [8:0] sum_1810_s18_q;
  logic [8:0] sum_1814_s18_q;
  logic [4:0] select_1821_s18_q;
  logic select_1827_s18_q;
  logic [8:0] sum_1842_s18_q;
  logic equal_1856_s18_q;
  logic equal_1860_s18_q;
  logic [3:0] select_1865_s18_q;
  logic not_1994_s18_q;
  logic select_2056_s18_q;
  logic [7:0] sum_2068_s18_q;
  logic select_2070_s18_q;
  logic [3:0] difference_2081_s18_q;
  logic or_2089_s18_q;
  logic [23:0] select_2100_s18_q;
  logic [4:0] around_s18_q;
  logic less_2134_s18_q;
  logic and_2147_s18_q;
  logic [11:0] sum_2279_s18_q;
  logic [9:0] sum_2282_s18_q;
  logic equal_2290_s18_q;
  logic equal_2305_s18_q;
  logic [13:0] select_2313_s18_q;
  logic not_2321_s18_q;
  logic not_2324_s18_q;
  logic not_2331_s18_q;
  logic not_2334_s18_q;
  logic [27:0] select_2369_s18_q;
  logic and_2382_s18_q;
  logic and_2394_s18_q;
  logic [8:0] select_2401_s18_q;
  logic [8:0] select_2405_s18_q;
  logic equal_2408_s18_q;
  logic less_2409_s18_q;
  logic [11:0] select_2414_s18_q;
  logic equal_2452_s18_q;
  logic equal_2479_s18_q;
  logic and_2614_s18_q;
  logic not_2642_s18_q;
  logic [4:0] e_s18_q;
  logic [9:0] select_2668_s18_q;
  logic [9:0] select_2671_s18_q;
  logic and_2721_s18_q;
  logic and_2781_s18_q;
  logic [7:0] select_2801_s18_q;
  logic [1:0] select_2811_s18_q;
  logic [1:0] select_2826_s18_q;
  logic [11:0] select_2878_s18_q;
  logic and_2886_s18_q;
  logic [11:0] select_2893_s18_q;
  logic and_2904_s18_q;
  logic and_2908_s18_q;
  logic and_2940_s18_q;
  logic and_2948_s18_q;
  logic [8:0] other_s18_q;
  logic [2:0] select_3163_s18_q;
  logic [8:0] select_3178_s18_q;
  logic xor_3193_s18_q;
  logic xor_3211_s18_q;
  logic xor_3223_s18_q;
  logic xor_3235_s18_q;
  logic xor_3247_s18_q;
  logic or_3256_s18_q;
  logic or_3260_s18_q;
  logic or_3264_s18_q;
  logic or_3271_s18_q;
  logic or_3275_s18_q;
  logic or_3279_s18_q;
  logic or_3286_s18_q;
  logic or_3290_s18_q;
  logic or_3294_s18_q;
  logic or_3304_s18_q;
  logic or_3308_s18_q;
  logic or_3312_s18_q;
  logic or_3320_s18_q;
  logic or_3324_s18_q;
  logic or_3328_s18_q;
  logic or_3335_s18_q;
  logic or_3339_s18_q;
  logic or_3343_s18_q;
  logic or_3353_s18_q;
  logic or_3357_s18_q;
  logic or_3361_s18_q;
  logic and_3366_s18_q;
  logic or_3367_s18_q;
  logic equal_3488_s18_q;
  logic [9:0] select_3574_s18_q;
  logic [2:0] select_3575_s18_q;
  logic [4:0] select_3576_s18_q;
  logic [9:0] select_3584_s18_q;
  logic equal_3585_s18_q;
  logic less_3613_s18_q;
  logic [2:0] fraction_s18_q;
  logic [7:0] select_3636_s18_q;
  logic sum_3637_s18_q;
  logic [6:0] sum_3639_s18_q;
  logic equal_3681_s18_q;
  logic equal_3891_s18_q;
  logic or_3894_s18_q;
  logic select_3902_s18_q;
  logic not_3907_s18_q;
  logic equal_3913_s18_q;
  logic equal_3916_s18_q;
  logic equal_3918_s18_q;
  logic equal_3919_s18_q;
  logic equal_3920_s18_q;
  logic equal_3921_s18_q;
  logic or_4063_s18_q;
  logic and_4077_s18_q;
  logic and_4094_s18_q;
  logic not_4106_s18_q;
  logic [31:0] select_4162_s18_q;
  logic [9:0] select_4169_s18_q;
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
      less_675_s18_q <= less_675_s17_q;
      less_676_s18_q <= less_676_s17_q;
      less_677_s18_q <= less_677_s17_q;
      less_678_s18_q <= less_678_s17_q;
      less_679_s18_q <= less_679_s17_q;
      less_680_s18_q <= less_680_s17_q;
      less_681_s18_q <= less_681_s17_q;
      and_689_s18_q <= and_689_s17_q;
      whole_16_s18_q <= whole_16;
      and_715_s18_q <= census_columns_values_1_cell_2_mask_q & and_689_s17_q;
      sum_730_s18_q <= {1'b0, sum_726} + {2'h0, sum_729_s17_q};
      sum_733_s18_q <= sum_733_s17_q;
      and_741_s18_q <= and_741;
      and_745_s18_q <= and_741 & less_744_s17_q;
      less_746_s18_q <= less_746_s17_q;
      less_750_s18_q <= less_750_s17_q;
      less_752_s18_q <= less_752_s17_q;
      equal_1614_s18_q <= equal_1614_s17_q;
      sum_1620_s18_q <= sum_1620_s17_q;
      equal_1622_s18_q <= equal_1622_s17_q;
      equal_1624_s18_q <= equal_1624_s17_q;
      equal_1626_s18_q <= equal_1626_s17_q;
      equal_1628_s18_q <= equal_1628_s17_q;
      equal_1630_s18_q <= equal_1630_s17_q;
      equal_1632_s18_q <= equal_1632_s17_q;
      less_1645_s18_q <= less_1645_s17_q;
      select_1670_s18_q <= equal_1669_s17_q ? registration_sums_rdata_s17_q[19:0] : 20'h0;
      equal_1671_s18_q <= equal_1671;
      sum_1678_s18_q <= sum_1678;
      and_1679_s18_q <= and_1679_s17_q;
      select_1696_s18_q <= select_1696_s17_q;
      equal_1697_s18_q <= equal_1697_s17_q;
      equal_1791_s18_q <= equal_1791_s17_q;
      equal_1793_s18_q <= equal_1793_s17_q;
      equal_1796_s18_q <= equal_1796_s17_q;
      or_1797_s18_q <= or_1797_s17_q;
      not_1798_s18_q <= not_1798_s17_q;
      select_1807_s18_q <= select_1807_s17_q[0];
      sum_1810_s18_q <= {1'b0, select_546_s17_q, select_511_s17_q[3]} + 9'h1;
      sum_1814_s18_q <= {1'b0, select_1812} + {{3{select_1813[5]}}, select_1813};
      select_1821_s18_q <= select_1821_s17_q;
      select_1827_s18_q <= select_1827_s17_q;
      sum_1842_s18_q <= {1'b0, select_1840} + {{3{select_1841[5]}}, select_1841};
      equal_1856_s18_q <= equal_1856;
      equal_1860_s18_q <= equal_1860;
      select_1865_s18_q <= select_1865_s17_q;
      not_1994_s18_q <= not_1994_s17_q;
      select_2056_s18_q <= select_2056_s17_q;
      sum_2068_s18_q <= {2'h0, x_s17_q[7:2]} + 8'hff;
      select_2070_s18_q <= select_2070_s17_q;
      difference_2081_s18_q <= {1'b0, textured_2_s17_q} - {1'b0, select_2080};
      or_2089_s18_q <= or_2089_s17_q;
      select_2100_s18_q <= select_2100;
      around_s18_q <= around;
      less_2134_s18_q <= {1'b0, around[4:1]} < n;
      and_2147_s18_q <= and_2147_s17_q;
      sum_2279_s18_q <= {1'b0, sum_2275} + {2'h0, sum_2278_s17_q};
      sum_2282_s18_q <= sum_2282_s17_q;
      equal_2290_s18_q <= equal_2290_s17_q;
      equal_2305_s18_q <= equal_2305_s17_q;
      select_2313_s18_q <= (select_2308 < select_2306) ? select_2306 : select_2308;
      not_2321_s18_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2319);
      not_2324_s18_q <= ~({3'h0, select_2308[13:2]} < sum_2319);
      not_2331_s18_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2329);
      not_2334_s18_q <= ~({3'h0, select_2306[13:2]} < sum_2329);
      select_2369_s18_q <= sample_pair_whole_s17_q ? {detail_2, detail} : 28'h0;
      and_2382_s18_q <= and_2382;
      and_2394_s18_q <= and_2394;
      select_2401_s18_q <= and_2382 ? contrast_s17_q : 9'h0;
      select_2405_s18_q <= and_2394 ? contrast_2_s17_q : 9'h0;
      equal_2408_s18_q <= x_s17_q[7:3] == 5'h0;
      less_2409_s18_q <= 7'h2 < {x_s17_q[4:0], slot_s17_q[2:1]};
      select_2414_s18_q <= select_2414;
      equal_2452_s18_q <= {x_s17_q[4:0], slot_s17_q} == 8'h0;
      equal_2479_s18_q <= equal_2479_s17_q;
      and_2614_s18_q <= and_2614_s17_q;
      not_2642_s18_q <= not_2642_s17_q;
      e_s18_q <= e;
      select_2668_s18_q <= select_2668_s17_q;
      select_2671_s18_q <= select_2671_s17_q;
      and_2721_s18_q <= and_2721_s17_q;
      and_2781_s18_q <= and_2781_s17_q;
      select_2801_s18_q <= equal_577_s17_q ? 8'h0 : (so_s17_q ? select_2799 : 8'h0);
      select_2811_s18_q <= equal_1707_s17_q ? {and_2810, and_2782_s17_q} : 2'h0;
      select_2826_s18_q <= equal_1707_s17_q ? {and_2825, and_2782_s17_q} : 2'h0;
      select_2878_s18_q <= select_2878;
      and_2886_s18_q <= equal_577_s17_q & (x_s17_q[6] & and_2884);
      select_2893_s18_q <= select_2893;
      and_2904_s18_q <= equal_577_s17_q & (x_s17_q[6] & and_2902);
      and_2908_s18_q <= and_2908;
      and_2940_s18_q <= equal_577_s17_q & (x_s17_q[6] & and_2938);
      and_2948_s18_q <= x_s17_q[6] & and_2947;
      other_s18_q <= other[44:36];
      select_3163_s18_q <= and_1963_s17_q ? {and_3162, xor_3161, parity_3155} : 3'h0;
      select_3178_s18_q <= select_3178_s17_q[44:36];
      xor_3193_s18_q <= xor_3193;
      xor_3211_s18_q <= xor_3193 ^ parity_3210;
      xor_3223_s18_q <= xor_3214 ^ (^{select_3178_s17_q[41:36], other[41:36]});
      xor_3235_s18_q <= xor_3226 ^ (^{select_3178_s17_q[23:18], other[23:18]});
      xor_3247_s18_q <= xor_3238 ^ (^{select_3178_s17_q[32:27], other[32:27]});
      or_3256_s18_q <= (xor_3187 & xor_3190) | (xor_3184 & (xor_3187 | xor_3190));
      or_3260_s18_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3264_s18_q <= (xor_3202 & xor_3205) | (xor_3199 & (xor_3202 | xor_3205));
      or_3271_s18_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3275_s18_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3279_s18_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3286_s18_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3290_s18_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3294_s18_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3304_s18_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3308_s18_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3312_s18_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3320_s18_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3324_s18_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3328_s18_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3335_s18_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3339_s18_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3343_s18_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3353_s18_q <= (xor_3217 & xor_3220) | (xor_3214 & (xor_3217 | xor_3220));
      or_3357_s18_q <= (xor_3229 & xor_3232) | (xor_3226 & (xor_3229 | xor_3232));
      or_3361_s18_q <= (xor_3241 & xor_3244) | (xor_3238 & (xor_3241 | xor_3244));
      and_3366_s18_q <= xor_3196 & xor_3208;
      or_3367_s18_q <= xor_3196 | xor_3208;
      equal_3488_s18_q <= equal_3488_s17_q;
      select_3574_s18_q <= select_3574_s17_q;
      select_3575_s18_q <= select_3575_s17_q[2:0];
      select_3576_s18_q <= select_3576_s17_q;
      select_3584_s18_q <= patches_peak_far_q;
      equal_3585_s18_q <= equal_3585_s17_q;
      less_3613_s18_q <= less_3613_s17_q;
      fraction_s18_q <= fraction;
      select_3636_s18_q <= select_3636;
      sum_3637_s18_q <= sum_3637[0];
      sum_3639_s18_q <= sum_3639;
      equal_3681_s18_q <= equal_3681_s17_q;
      equal_3891_s18_q <= select_2668_s17_q[9:3] == 7'h0;
      or_3894_s18_q <= or_3894;
      select_3902_s18_q <= select_3902;
      not_3907_s18_q <= ~({sum_3905, select_2671_s17_q[0]} < {2'h0, select_2668_s17_q});
      equal_3913_s18_q <= equal_3913_s17_q;
      equal_3916_s18_q <= equal_3916_s17_q;
      equal_3918_s18_q <= equal_3918_s17_q;
      equal_3919_s18_q <= equal_3919_s17_q;
      equal_3920_s18_q <= equal_3920_s17_q;
      equal_3921_s18_q <= equal_3921_s17_q;
      or_4063_s18_q <= or_4063_s17_q;
      and_4077_s18_q <= and_4077_s17_q;
      and_4094_s18_q <= and_4094_s17_q;
      not_4106_s18_q <= not_4106_s17_q;
      select_4162_s18_q <= select_4162;
      select_4169_s18_q <= select_4169_s17_q;
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
  assign texture = sum_730_s18_q + {2'h0, sum_733_s18_q};
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1620_s18_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1673;
  assign select_1673 = equal_1671_s18_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1809;
  assign select_1809 = equal_1697_s18_q ? patches_place_0_valid_q : (select_1696_s18_q ? patches_place_0_valid_q : select_1807_s18_q);
  // hls/stages/patches.hpp:132
  logic equal_1815;
  assign equal_1815 = {sum_1814_s18_q, sum_1810_s18_q[0], select_511_s18_q} == {1'b0, sum_1810_s18_q[8:1], 4'h0};
  // hls/stages/patches.hpp:127
  logic select_1838;
  assign select_1838 = equal_1697_s18_q ? patches_place_1_valid_q : (select_1696_s18_q ? select_1807_s18_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:132
  logic equal_1843;
  assign equal_1843 = {sum_1842_s18_q[8], sum_1810_s18_q, select_511_s18_q} == {1'b0, sum_1842_s18_q[7:0], 4'h0};
  // hls/stages/agreement.hpp:1321
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1273
  logic [10:0] sum_2057;
  assign sum_2057 = {1'b0, {5{select_2056_s18_q}}, 1'b0, {2{select_2056_s18_q}}, 1'b0, select_2056_s18_q} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1123
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2068_s18_q[7]}}, sum_2068_s18_q, x_s18_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1273
  logic [10:0] sum_2071;
  assign sum_2071 = {1'b0, {5{select_2070_s18_q}}, 1'b0, {2{select_2070_s18_q}}, 1'b0, select_2070_s18_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1105
  logic [4:0] t;
  assign t = {difference_2081_s18_q[3], difference_2081_s18_q} + (equal_572_s18_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic [47:0] select_2101;
  assign select_2101 = or_2089_s18_q ? {select_2100_s18_q[23], 1'b0, select_2100_s18_q[22], 1'b0, select_2100_s18_q[21], 1'b0, select_2100_s18_q[20], 1'b0, select_2100_s18_q[19], 1'b0, select_2100_s18_q[18], 1'b0, select_2100_s18_q[17], 1'b0, select_2100_s18_q[16], 1'b0, select_2100_s18_q[15], 1'b0, select_2100_s18_q[14], 1'b0, select_2100_s18_q[13], 1'b0, select_2100_s18_q[12], 1'b0, select_2100_s18_q[11], 1'b0, select_2100_s18_q[10], 1'b0, select_2100_s18_q[9], 1'b0, select_2100_s18_q[8], 1'b0, select_2100_s18_q[7], 1'b0, select_2100_s18_q[6], 1'b0, select_2100_s18_q[5], 1'b0, select_2100_s18_q[4], 1'b0, select_2100_s18_q[3], 1'b0, select_2100_s18_q[2], 1'b0, select_2100_s18_q[1], 1'b0, select_2100_s18_q[0], 1'b0} : {1'b0, select_2100_s18_q[23], 1'b0, select_2100_s18_q[22], 1'b0, select_2100_s18_q[21], 1'b0, select_2100_s18_q[20], 1'b0, select_2100_s18_q[19], 1'b0, select_2100_s18_q[18], 1'b0, select_2100_s18_q[17], 1'b0, select_2100_s18_q[16], 1'b0, select_2100_s18_q[15], 1'b0, select_2100_s18_q[14], 1'b0, select_2100_s18_q[13], 1'b0, select_2100_s18_q[12], 1'b0, select_2100_s18_q[11], 1'b0, select_2100_s18_q[10], 1'b0, select_2100_s18_q[9], 1'b0, select_2100_s18_q[8], 1'b0, select_2100_s18_q[7], 1'b0, select_2100_s18_q[6], 1'b0, select_2100_s18_q[5], 1'b0, select_2100_s18_q[4], 1'b0, select_2100_s18_q[3], 1'b0, select_2100_s18_q[2], 1'b0, select_2100_s18_q[1], 1'b0, select_2100_s18_q[0]};
  // hls/stages/agreement.hpp:1114
  logic [5:0] sum_2118;
  assign sum_2118 = {1'b0, around_s18_q} + {2'h0, around_s18_q[4:1]};
  // hls/stages/agreement.hpp:530
  logic select_2263;
  assign select_2263 = and_552_s18_q ? census_columns_values_2_cell_4_mask_s18_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2283;
  assign sum_2283 = sum_2279_s18_q + {2'h0, sum_2282_s18_q};
  // hls/stages/agreement.hpp:530
  logic [11:0] select_2285;
  assign select_2285 = and_552_s18_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2286;
  assign select_2286 = and_552_s18_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2315;
  assign sum_2315 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:530
  logic [13:0] select_2370;
  assign select_2370 = and_552_s18_q ? select_2369_s18_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2371;
  assign select_2371 = and_552_s18_q ? select_2369_s18_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2369_s18_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2369_s18_q[27:14]};
  // hls/stages/census.hpp:375
  logic [23:0] sum_2402;
  assign sum_2402 = (equal_2290_s18_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2401_s18_q};
  logic [23:0] sum_2406;
  assign sum_2406 = (equal_2290_s18_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2405_s18_q};
  // hls/stages/census.hpp:427
  logic less_2410;
  assign less_2410 = x_s18_q[4:0] < 5'h3;
  logic [23:0] select_2415;
  assign select_2415 = slot_s18_q ? {select_2414_s18_q[11], 1'b0, select_2414_s18_q[10], 1'b0, select_2414_s18_q[9], 1'b0, select_2414_s18_q[8], 1'b0, select_2414_s18_q[7], 1'b0, select_2414_s18_q[6], 1'b0, select_2414_s18_q[5], 1'b0, select_2414_s18_q[4], 1'b0, select_2414_s18_q[3], 1'b0, select_2414_s18_q[2], 1'b0, select_2414_s18_q[1], 1'b0, select_2414_s18_q[0], 1'b0} : {1'b0, select_2414_s18_q[11], 1'b0, select_2414_s18_q[10], 1'b0, select_2414_s18_q[9], 1'b0, select_2414_s18_q[8], 1'b0, select_2414_s18_q[7], 1'b0, select_2414_s18_q[6], 1'b0, select_2414_s18_q[5], 1'b0, select_2414_s18_q[4], 1'b0, select_2414_s18_q[3], 1'b0, select_2414_s18_q[2], 1'b0, select_2414_s18_q[1], 1'b0, select_2414_s18_q[0]};
  // hls/stages/census.hpp:390
  logic and_2419;
  assign and_2419 = less_2410 & (~((sharpness_sums_contrast_1_q & select_2415) == 24'h0));
  logic and_2429;
  assign and_2429 = less_2410 & (~((sharpness_sums_contrast_0_q & select_2415) == 24'h0));
  // hls/stages/agreement.hpp:1113
  logic [5:0] sum_2655;
  assign sum_2655 = {1'b0, e_s18_q} + {2'h0, e_s18_q[4:1]};
  // hls/stages/agreement.hpp:1145
  logic [10:0] sum_2672;
  assign sum_2672 = {1'b0, select_2671_s18_q} + {3'h0, select_2671_s18_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2802;
  assign sum_2802 = registration_half_across_q + {{6{select_2801_s18_q[7]}}, select_2801_s18_q};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2813;
  assign select_2813 = equal_577_s18_q ? 2'h0 : (so_s18_q ? select_2811_s18_q : 2'h0);
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2814;
  assign sum_2814 = registration_half_votes_down_q + {{5{select_2813[1]}}, select_2813};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2828;
  assign select_2828 = equal_577_s18_q ? 2'h0 : (so_s18_q ? select_2826_s18_q : 2'h0);
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2829;
  assign sum_2829 = registration_half_half_votes_down_q + {{5{select_2828[1]}}, select_2828};
  // hls/stages/agreement.hpp:798
  logic and_2869;
  assign and_2869 = equal_577_s18_q & (x_s18_q[6] & (not_1994_s18_q & less_1645_s18_q));
  logic [11:0] select_2880;
  assign select_2880 = equal_577_s18_q ? (x_s18_q[6] ? select_2878_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2888;
  assign sum_2888 = {{2{select_2880[11]}}, select_2880} + (and_2886_s18_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:798
  logic [11:0] select_2895;
  assign select_2895 = equal_577_s18_q ? (x_s18_q[6] ? select_2893_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2897;
  assign sum_2897 = {{2{select_2895[11]}}, select_2895} + (and_2886_s18_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2909;
  assign not_2909 = ~and_2908_s18_q;
  logic less_2910;
  assign less_2910 = $signed({9'h1, {2{not_2909}}, and_2908_s18_q}) < $signed(registration_up_q[13:2]);
  logic select_2911;
  assign select_2911 = and_2904_s18_q ? less_2910 : registration_enough_q;
  // hls/stages/agreement.hpp:1154
  logic and_2915;
  assign and_2915 = x_s18_q[6] & (not_1994_s18_q & (less_1645_s18_q & (x_s18_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:798
  logic and_2916;
  assign and_2916 = equal_577_s18_q & and_2915;
  // hls/stages/registration.hpp:242
  logic less_2917;
  assign less_2917 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2919;
  assign less_2919 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2921;
  assign equal_2921 = x_s18_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:798
  logic and_2925;
  assign and_2925 = equal_577_s18_q & (x_s18_q[6] & (not_1994_s18_q & (less_1645_s18_q & equal_2921)));
  // hls/stages/agreement.hpp:1154
  logic and_2932;
  assign and_2932 = x_s18_q[6] & (not_1994_s18_q & (less_1645_s18_q & (x_s18_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2950;
  assign and_2950 = registration_votes_up_q & registration_other_down_q;
  logic select_2952;
  assign select_2952 = registration_votes_down_q ? (registration_other_up_q | and_2950) : and_2950;
  // hls/stages/registration.hpp:138
  logic and_2954;
  assign and_2954 = (equal_577_s18_q & and_2948_s18_q) & (registration_other_enough_q & select_2952);
  logic and_2956;
  assign and_2956 = registration_enough_q & ((and_2940_s18_q & (less_2919 | less_2917)) | and_2954);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3165;
  assign select_3165 = equal_1793_s18_q ? 3'h0 : (or_1797_s18_q ? select_3163_s18_q : 3'h0);
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3168;
  assign sum_3168 = {7'h0, patches_set_q} + (equal_1796_s18_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3248;
  assign xor_3248 = xor_3235_s18_q ^ xor_3247_s18_q;
  // hls/stages/count_bits.hpp:25
  logic or_3373;
  assign or_3373 = (xor_3235_s18_q & xor_3247_s18_q) | (xor_3223_s18_q & (xor_3235_s18_q | xor_3247_s18_q));
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3587;
  assign select_3587 = equal_1791_s18_q ? (equal_3585_s18_q ? sum_3168 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3614;
  assign sum_3614 = select_3576_s18_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:587
  logic [7:0] difference_3634;
  assign difference_3634 = {sum_3614, select_3576_s18_q[2:0], 3'h0} - {5'h0, fraction_s18_q};
  logic [7:0] select_3635;
  assign select_3635 = less_3613_s18_q ? difference_3634 : {sum_3614, select_3576_s18_q[2:0], fraction_s18_q};
  // hls/stages/patches.hpp:604
  logic [18:0] product_3640;
  assign product_3640 = $signed({{11{select_3636_s18_q[7]}}, select_3636_s18_q}) * $signed({{8{sum_3639_s18_q[6]}}, sum_3639_s18_q, sum_3637_s18_q, select_3575_s18_q});
  // hls/stages/patches.hpp:612
  logic [11:0] sum_3800;
  assign sum_3800 = {sum_3639_s18_q[6], sum_3639_s18_q, sum_3637_s18_q, select_3575_s18_q} + 12'h1;
  // hls/stages/agreement.hpp:1147
  logic select_3908;
  assign select_3908 = equal_3891_s18_q ? ((~or_3894_s18_q) & (~select_3902_s18_q)) : not_3907_s18_q;
  // hls/stages/agreement.hpp:1154
  logic [47:0] select_3910;
  assign select_3910 = x_s18_q[6] ? (equal_1614_s18_q ? good_q : {select_3908, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:798
  logic [4:0] select_3992;
  assign select_3992 = so_s18_q ? (ends_cell_s18_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:465
  logic [12:0] select_4066;
  assign select_4066 = equal_2479_s18_q ? (or_4063_s18_q ? (map_row_q + {6'h0, map_width_q}) : 13'h0) : map_row_q;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_4069;
  assign select_4069 = and_552_s18_q ? (equal_2479_s18_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
      moments_most_before_q <= equal_577_s18_q ? select_2313_s18_q : moments_most_before_q;
      moments_left_alone_q <= equal_577_s18_q ? not_2321_s18_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_577_s18_q ? not_2324_s18_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_577_s18_q ? not_2331_s18_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_577_s18_q ? not_2334_s18_q : moments_right_other_stops_q;
      sharpness_sums_contrast_0_q <= and_552_s18_q ? sum_2402 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_552_s18_q ? sum_2406 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2781_s18_q ? 14'h0 : sum_2802;
      registration_half_votes_down_q <= and_2781_s18_q ? 7'h0 : sum_2814;
      registration_half_half_votes_down_q <= and_2781_s18_q ? 7'h0 : sum_2829;
      registration_down_q <= and_2869 ? sum_2888 : registration_down_q;
      registration_up_q <= and_2869 ? sum_2897 : registration_up_q;
      registration_enough_q <= select_2911;
      registration_votes_down_q <= and_2916 ? less_2917 : registration_votes_down_q;
      registration_votes_up_q <= and_2916 ? less_2919 : registration_votes_up_q;
      registration_other_enough_q <= and_2925 ? select_2911 : registration_other_enough_q;
      registration_other_down_q <= and_2925 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2925 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s18_q ? select_1809 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s18_q ? select_1838 : patches_place_1_valid_q;
      patches_set_q <= equal_1791_s18_q ? 3'h0 : select_3165;
      patches_size_q <= sum_3168;
      patches_peak_size_q <= select_3587;
      good_q <= equal_577_s18_q ? select_3910 : good_q;
      map_row_q <= and_552_s18_q ? select_4066 : map_row_q;
      map_width_q <= select_4069;
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
      census_columns_values_3_cell_4_mask_q <= select_2263;
      census_changes_values_0_left_q <= and_552_s18_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_552_s18_q ? sum_2283 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2285;
      census_changes_values_1_right_q <= select_2286;
      sharpness_last_detail_0_q <= select_2370;
      sharpness_last_detail_1_q <= select_2371;
      box_textured_sum_sums_values_0_q <= equal_577_s18_q ? box_textured_sum_sums_values_0_q : select_3992;
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
  logic less_675_s19_q;
  logic less_676_s19_q;
  logic less_677_s19_q;
  logic less_678_s19_q;
  logic less_679_s19_q;
  logic less_680_s19_q;
  logic less_681_s19_q;
  logic and_689_s19_q;
  logic and_714_s19_q;
  logic and_715_s19_q;
  logic [12:0] sum_735_s19_q;
  logic and_741_s19_q;
  logic and_745_s19_q;
  logic less_746_s19_q;
  logic less_750_s19_q;
  logic less_752_s19_q;
  logic equal_1614_s19_q;
  logic [1:0] sum_1620_s19_q;
  logic equal_1622_s19_q;
  logic equal_1624_s19_q;
  logic equal_1626_s19_q;
  logic equal_1628_s19_q;
  logic equal_1630_s19_q;
  logic equal_1632_s19_q;
  logic [19:0] sum_1674_s19_q;
  logic [11:0] sum_1678_s19_q;
  logic and_1679_s19_q;
  logic select_1696_s19_q;
  logic equal_1697_s19_q;
  logic equal_1791_s19_q;
  logic equal_1793_s19_q;
  logic not_1798_s19_q;
  logic select_1807_s19_q;
  logic or_1817_s19_q;
  logic [4:0] select_1821_s19_q;
  logic select_1827_s19_q;
  logic or_1845_s19_q;
  logic or_1858_s19_q;
  logic or_1862_s19_q;
  logic [3:0] select_1865_s19_q;
  logic not_1994_s19_q;
  logic [2:0] index_s19_q;
  logic [10:0] sum_2057_s19_q;
  logic and_2064_s19_q;
  logic less_2065_s19_q;
  logic [2:0] index_2_s19_q;
  logic [10:0] sum_2071_s19_q;
  logic equal_2084_s19_q;
  logic not_2104_s19_q;
  logic not_2120_s19_q;
  logic less_2134_s19_q;
  logic and_2147_s19_q;
  logic equal_2290_s19_q;
  logic [12:0] sum_2291_s19_q;
  logic equal_2305_s19_q;
  logic not_2317_s19_q;
  logic not_2327_s19_q;
  logic [12:0] select_2384_s19_q;
  logic [12:0] select_2396_s19_q;
  logic equal_2408_s19_q;
  logic less_2409_s19_q;
  logic and_2419_s19_q;
  logic and_2429_s19_q;
  logic equal_2452_s19_q;
  logic and_2614_s19_q;
  logic not_2642_s19_q;
  logic not_2657_s19_q;
  logic [9:0] select_2668_s19_q;
  logic [9:0] select_2671_s19_q;
  logic less_2673_s19_q;
  logic and_2721_s19_q;
  logic equal_2921_s19_q;
  logic not_2934_s19_q;
  logic and_2956_s19_q;
  logic parity_3252_s19_q;
  logic or_3256_s19_q;
  logic or_3260_s19_q;
  logic or_3264_s19_q;
  logic or_3271_s19_q;
  logic or_3275_s19_q;
  logic or_3279_s19_q;
  logic or_3286_s19_q;
  logic or_3290_s19_q;
  logic or_3294_s19_q;
  logic or_3304_s19_q;
  logic or_3308_s19_q;
  logic or_3312_s19_q;
  logic or_3320_s19_q;
  logic or_3324_s19_q;
  logic or_3328_s19_q;
  logic or_3335_s19_q;
  logic or_3339_s19_q;
  logic or_3343_s19_q;
  logic or_3353_s19_q;
  logic or_3357_s19_q;
  logic or_3361_s19_q;
  logic and_3365_s19_q;
  logic or_3369_s19_q;
  logic or_3373_s19_q;
  logic equal_3488_s19_q;
  logic [9:0] select_3574_s19_q;
  logic and_3588_s19_q;
  logic not_3590_s19_q;
  logic not_3593_s19_q;
  logic [9:0] difference_3594_s19_q;
  logic [7:0] select_3635_s19_q;
  logic [13:0] product_3640_s19_q;
  logic equal_3681_s19_q;
  logic less_3801_s19_q;
  logic or_3894_s19_q;
  logic select_3902_s19_q;
  logic equal_3913_s19_q;
  logic equal_3916_s19_q;
  logic equal_3918_s19_q;
  logic equal_3919_s19_q;
  logic equal_3920_s19_q;
  logic equal_3921_s19_q;
  logic and_4077_s19_q;
  logic and_4094_s19_q;
  logic not_4106_s19_q;
  logic [31:0] select_4162_s19_q;
  logic [9:0] select_4169_s19_q;
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
      less_675_s19_q <= less_675_s18_q;
      less_676_s19_q <= less_676_s18_q;
      less_677_s19_q <= less_677_s18_q;
      less_678_s19_q <= less_678_s18_q;
      less_679_s19_q <= less_679_s18_q;
      less_680_s19_q <= less_680_s18_q;
      less_681_s19_q <= less_681_s18_q;
      and_689_s19_q <= and_689_s18_q;
      and_714_s19_q <= whole_22 & and_689_s18_q;
      and_715_s19_q <= and_715_s18_q;
      sum_735_s19_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_741_s19_q <= and_741_s18_q;
      and_745_s19_q <= and_745_s18_q;
      less_746_s19_q <= less_746_s18_q;
      less_750_s19_q <= less_750_s18_q;
      less_752_s19_q <= less_752_s18_q;
      equal_1614_s19_q <= equal_1614_s18_q;
      sum_1620_s19_q <= sum_1620_s18_q;
      equal_1622_s19_q <= equal_1622_s18_q;
      equal_1624_s19_q <= equal_1624_s18_q;
      equal_1626_s19_q <= equal_1626_s18_q;
      equal_1628_s19_q <= equal_1628_s18_q;
      equal_1630_s19_q <= equal_1630_s18_q;
      equal_1632_s19_q <= equal_1632_s18_q;
      sum_1674_s19_q <= select_1670_s18_q + {{6{select_1673[13]}}, select_1673};
      sum_1678_s19_q <= sum_1678_s18_q;
      and_1679_s19_q <= and_1679_s18_q;
      select_1696_s19_q <= select_1696_s18_q;
      equal_1697_s19_q <= equal_1697_s18_q;
      equal_1791_s19_q <= equal_1791_s18_q;
      equal_1793_s19_q <= equal_1793_s18_q;
      not_1798_s19_q <= not_1798_s18_q;
      select_1807_s19_q <= select_1807_s18_q;
      or_1817_s19_q <= row_starts_s18_q | (select_1809 & equal_1815);
      select_1821_s19_q <= select_1821_s18_q;
      select_1827_s19_q <= select_1827_s18_q;
      or_1845_s19_q <= row_starts_s18_q | (select_1838 & equal_1843);
      or_1858_s19_q <= row_starts_s18_q | (select_1809 & equal_1856_s18_q);
      or_1862_s19_q <= row_starts_s18_q | (select_1838 & equal_1860_s18_q);
      select_1865_s19_q <= select_1865_s18_q;
      not_1994_s19_q <= not_1994_s18_q;
      index_s19_q <= index[2:0];
      sum_2057_s19_q <= sum_2057;
      and_2064_s19_q <= began_q & (seen_x_q == 4'h0);
      less_2065_s19_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s19_q <= index_2[2:0];
      sum_2071_s19_q <= sum_2071;
      equal_2084_s19_q <= t[4:1] == 4'h0;
      not_2104_s19_q <= ~((good_q & select_2101) == 48'h0);
      not_2120_s19_q <= ~({sum_2118, around_s18_q[0]} < {2'h0, t});
      less_2134_s19_q <= less_2134_s18_q;
      and_2147_s19_q <= and_2147_s18_q;
      equal_2290_s19_q <= equal_2290_s18_q;
      sum_2291_s19_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2283};
      equal_2305_s19_q <= equal_2305_s18_q;
      not_2317_s19_q <= ~({3'h0, counts_turned_left_s18_q} < sum_2315);
      not_2327_s19_q <= ~({3'h0, counts_turned_right_s18_q} < sum_2315);
      select_2384_s19_q <= and_2382_s18_q ? detail_3[14:2] : 13'h0;
      select_2396_s19_q <= and_2394_s18_q ? detail_4[14:2] : 13'h0;
      equal_2408_s19_q <= equal_2408_s18_q;
      less_2409_s19_q <= less_2409_s18_q;
      and_2419_s19_q <= and_2419;
      and_2429_s19_q <= and_2429;
      equal_2452_s19_q <= equal_2452_s18_q;
      and_2614_s19_q <= and_2614_s18_q;
      not_2642_s19_q <= not_2642_s18_q;
      not_2657_s19_q <= ~({sum_2655, e_s18_q[0]} < {2'h0, t});
      select_2668_s19_q <= select_2668_s18_q;
      select_2671_s19_q <= select_2671_s18_q;
      less_2673_s19_q <= {sum_2672, select_2671_s18_q[1:0]} < {3'h0, select_2668_s18_q};
      and_2721_s19_q <= and_2721_s18_q;
      equal_2921_s19_q <= equal_2921;
      not_2934_s19_q <= ~(equal_577_s18_q & and_2932);
      and_2956_s19_q <= and_2956;
      parity_3252_s19_q <= ^{xor_3248, xor_3211_s18_q, select_3178_s18_q, other_s18_q};
      or_3256_s19_q <= or_3256_s18_q;
      or_3260_s19_q <= or_3260_s18_q;
      or_3264_s19_q <= or_3264_s18_q;
      or_3271_s19_q <= or_3271_s18_q;
      or_3275_s19_q <= or_3275_s18_q;
      or_3279_s19_q <= or_3279_s18_q;
      or_3286_s19_q <= or_3286_s18_q;
      or_3290_s19_q <= or_3290_s18_q;
      or_3294_s19_q <= or_3294_s18_q;
      or_3304_s19_q <= or_3304_s18_q;
      or_3308_s19_q <= or_3308_s18_q;
      or_3312_s19_q <= or_3312_s18_q;
      or_3320_s19_q <= or_3320_s18_q;
      or_3324_s19_q <= or_3324_s18_q;
      or_3328_s19_q <= or_3328_s18_q;
      or_3335_s19_q <= or_3335_s18_q;
      or_3339_s19_q <= or_3339_s18_q;
      or_3343_s19_q <= or_3343_s18_q;
      or_3353_s19_q <= or_3353_s18_q;
      or_3357_s19_q <= or_3357_s18_q;
      or_3361_s19_q <= or_3361_s18_q;
      and_3365_s19_q <= xor_3211_s18_q & (^{xor_3248, select_3178_s18_q, other_s18_q});
      or_3369_s19_q <= and_3366_s18_q | (xor_3193_s18_q & or_3367_s18_q);
      or_3373_s19_q <= or_3373;
      equal_3488_s19_q <= equal_3488_s18_q;
      select_3574_s19_q <= select_3574_s18_q;
      and_3588_s19_q <= equal_1791_s18_q & equal_3585_s18_q;
      not_3590_s19_q <= ~(select_3576_s18_q[3:0] == 4'h0);
      not_3593_s19_q <= ~(select_3584_s18_q < select_3574_s18_q);
      difference_3594_s19_q <= select_3584_s18_q - select_3574_s18_q;
      select_3635_s19_q <= select_3635;
      product_3640_s19_q <= product_3640[18:5];
      equal_3681_s19_q <= equal_3681_s18_q;
      less_3801_s19_q <= {{4{sum_3800[11]}}, sum_3800} < 16'h3;
      or_3894_s19_q <= or_3894_s18_q;
      select_3902_s19_q <= select_3902_s18_q;
      equal_3913_s19_q <= equal_3913_s18_q;
      equal_3916_s19_q <= equal_3916_s18_q;
      equal_3918_s19_q <= equal_3918_s18_q;
      equal_3919_s19_q <= equal_3919_s18_q;
      equal_3920_s19_q <= equal_3920_s18_q;
      equal_3921_s19_q <= equal_3921_s18_q;
      and_4077_s19_q <= and_4077_s18_q;
      and_4094_s19_q <= and_4094_s18_q;
      not_4106_s19_q <= not_4106_s18_q;
      select_4162_s19_q <= select_4162_s18_q;
      select_4169_s19_q <= select_4169_s18_q;
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
  logic [13:0] sum_736;
  assign sum_736 = {2'h0, census_changes_values_1_left_s19_q} + {1'b0, sum_735_s19_q};
  logic [13:0] sum_737;
  assign sum_737 = {2'h0, census_changes_values_2_left_q} + sum_736;
  // hls/stages/patches.hpp:134
  logic [5:0] select_1828;
  assign select_1828 = or_1817_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1830;
  assign and_1830 = select_1827_s19_q & (~select_1828[5]);
  // hls/stages/patches.hpp:134
  logic [5:0] select_1847;
  assign select_1847 = or_1845_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1849;
  assign and_1849 = select_1827_s19_q & (~select_1847[5]);
  // hls/stages/patches.hpp:135
  logic [4:0] select_1859;
  assign select_1859 = or_1858_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1863;
  assign select_1863 = or_1862_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1859[4] ? select_1863[3:0] : select_1859[3:0];
  logic and_1868;
  assign and_1868 = select_1827_s19_q & (select_1821_s19_q[3] ^ select_1821_s19_q[4]);
  logic and_1873;
  assign and_1873 = sample_pair_whole_s19_q & (and_1868 & ((~select_1859[4]) | (~select_1863[4])));
  // hls/stages/agreement.hpp:1040
  logic and_2105;
  assign and_2105 = good_known_q & not_2104_s19_q;
  // hls/stages/agreement.hpp:1114
  logic is_seen;
  assign is_seen = equal_2084_s19_q ? and_2105 : not_2120_s19_q;
  // hls/stages/agreement.hpp:530
  logic [11:0] select_2287;
  assign select_2287 = and_552_s19_q ? census_changes_values_1_left_s19_q : census_changes_values_2_left_q;
  logic [11:0] select_2288;
  assign select_2288 = and_552_s19_q ? census_changes_values_1_right_s19_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [13:0] sum_2292;
  assign sum_2292 = {2'h0, census_changes_values_1_right_s19_q} + {1'b0, sum_2291_s19_q};
  logic [13:0] sum_2293;
  assign sum_2293 = {2'h0, census_changes_values_2_right_q} + sum_2292;
  // hls/stages/moments.hpp:94
  logic and_2352;
  assign and_2352 = moments_right_alone_s19_q & (moments_right_begins_q | moments_right_other_stops_s19_q);
  logic or_2354;
  assign or_2354 = moments_left_begins_q | (moments_left_other_stops_s19_q | and_2352);
  logic and_2356;
  assign and_2356 = cfg_same_table_i & (moments_left_alone_s19_q ? or_2354 : and_2352);
  // hls/stages/moments.hpp:95
  logic and_2362;
  assign and_2362 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:375
  logic [23:0] select_2386;
  assign select_2386 = equal_2290_s19_q ? {11'h0, select_2384_s19_q} : (sharpness_sums_detail_0_q + {11'h0, select_2384_s19_q});
  logic [23:0] select_2398;
  assign select_2398 = equal_2290_s19_q ? {11'h0, select_2396_s19_q} : (sharpness_sums_detail_1_q + {11'h0, select_2396_s19_q});
  // hls/stages/census.hpp:395
  logic [17:0] select_2421;
  assign select_2421 = (less_2409_s19_q & and_2419_s19_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2431;
  assign select_2431 = (less_2409_s19_q & and_2429_s19_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:217
  logic [1:0] select_2440;
  assign select_2440 = equal_2408_s19_q ? {sharpness_comparing_contrast_0_q[0], and_2429_s19_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2442;
  assign select_2442 = equal_2408_s19_q ? {sharpness_comparing_contrast_1_q[0], and_2419_s19_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:404
  logic xor_2465;
  assign xor_2465 = sharpness_comparing_contrast_0_q[1] ^ and_2419_s19_q;
  logic select_2468;
  assign select_2468 = (equal_2452_s19_q | xor_2465) ? (and_2419_s19_q & xor_2465) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2469;
  assign select_2469 = equal_2408_s19_q ? select_2468 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2471;
  assign xor_2471 = sharpness_comparing_contrast_1_q[1] ^ and_2429_s19_q;
  logic select_2474;
  assign select_2474 = (equal_2452_s19_q | xor_2471) ? (and_2429_s19_q & xor_2471) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2475;
  assign select_2475 = equal_2408_s19_q ? select_2474 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1118
  logic not_2659;
  assign not_2659 = ~(equal_2084_s19_q ? and_2105 : not_2657_s19_q);
  // hls/stages/agreement.hpp:798
  logic and_2662;
  assign and_2662 = ends_cell_s19_q & (not_2642_s19_q & (centres_values_1_textured_s19_q & not_2659));
  // hls/stages/agreement.hpp:1150
  logic [9:0] select_2675;
  assign select_2675 = ((~(select_2668_s19_q[9:4] == 6'h0)) & less_2673_s19_q) ? select_2668_s19_q : 10'h0;
  // hls/stages/agreement.hpp:798
  logic [9:0] select_2678;
  assign select_2678 = equal_577_s19_q ? (x_s19_q[6] ? (equal_1614_s19_q ? 10'h0 : select_2675) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1122
  logic and_2697;
  assign and_2697 = centres_values_1_textured_s19_q & (centres_values_1_of_skin_s19_q & not_2659);
  // hls/stages/patches.hpp:127
  logic select_3048;
  assign select_3048 = equal_1697_s19_q ? patches_valid_0_q : (select_1696_s19_q ? patches_valid_0_q : select_1807_s19_q);
  // hls/stages/agreement.hpp:277
  logic select_3051;
  assign select_3051 = sample_pair_whole_s19_q ? (and_1830 ? (sample_present_s19_q & select_3048) : select_3048) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3053;
  assign select_3053 = equal_1697_s19_q ? patches_valid_1_q : (select_1696_s19_q ? select_1807_s19_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3056;
  assign select_3056 = sample_pair_whole_s19_q ? (and_1849 ? (sample_present_s19_q & select_3053) : select_3053) : patches_valid_1_q;
  logic [5:0] select_3059;
  assign select_3059 = sample_pair_whole_s19_q ? (select_1828[5] ? {1'b1, select_1828[4:0]} : (select_1828 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3062;
  assign select_3062 = sample_pair_whole_s19_q ? (select_1847[5] ? {1'b1, select_1847[4:0]} : (select_1847 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3065;
  assign select_3065 = sample_pair_whole_s19_q ? (select_1859[4] ? {1'b1, select_1859[3:0]} : (select_1859 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3068;
  assign select_3068 = sample_pair_whole_s19_q ? (select_1863[4] ? {1'b1, select_1863[3:0]} : (select_1863 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3282;
  assign parity_3282 = ^{or_3279_s19_q, or_3275_s19_q, or_3271_s19_q};
  logic parity_3297;
  assign parity_3297 = ^{or_3294_s19_q, or_3290_s19_q, or_3286_s19_q};
  logic parity_3300;
  assign parity_3300 = ^{or_3294_s19_q, or_3290_s19_q, or_3286_s19_q, or_3279_s19_q, or_3275_s19_q, or_3271_s19_q, or_3264_s19_q, or_3260_s19_q, or_3256_s19_q};
  logic parity_3331;
  assign parity_3331 = ^{or_3328_s19_q, or_3324_s19_q, or_3320_s19_q};
  logic parity_3346;
  assign parity_3346 = ^{or_3343_s19_q, or_3339_s19_q, or_3335_s19_q};
  logic parity_3349;
  assign parity_3349 = ^{or_3343_s19_q, or_3339_s19_q, or_3335_s19_q, or_3328_s19_q, or_3324_s19_q, or_3320_s19_q, or_3312_s19_q, or_3308_s19_q, or_3304_s19_q};
  logic parity_3364;
  assign parity_3364 = ^{or_3361_s19_q, or_3357_s19_q, or_3353_s19_q};
  logic parity_3376;
  assign parity_3376 = ^{or_3373_s19_q, or_3369_s19_q, and_3365_s19_q};
  logic parity_3379;
  assign parity_3379 = ^{or_3373_s19_q, or_3369_s19_q, and_3365_s19_q, or_3361_s19_q, or_3357_s19_q, or_3353_s19_q, or_3343_s19_q, or_3339_s19_q, or_3335_s19_q, or_3328_s19_q, or_3324_s19_q, or_3320_s19_q, or_3312_s19_q, or_3308_s19_q, or_3304_s19_q};
  logic parity_3381;
  assign parity_3381 = ^{or_3373_s19_q, or_3369_s19_q, and_3365_s19_q, or_3361_s19_q, or_3357_s19_q, or_3353_s19_q, or_3343_s19_q, or_3339_s19_q, or_3335_s19_q, or_3328_s19_q, or_3324_s19_q, or_3320_s19_q, or_3312_s19_q, or_3308_s19_q, or_3304_s19_q, or_3294_s19_q, or_3290_s19_q, or_3286_s19_q, or_3279_s19_q, or_3275_s19_q, or_3271_s19_q, or_3264_s19_q, or_3260_s19_q, or_3256_s19_q};
  // hls/stages/count_bits.hpp:25
  logic and_3382;
  assign and_3382 = parity_3300 & parity_3379;
  logic and_3385;
  assign and_3385 = (^{or_3264_s19_q, or_3260_s19_q, or_3256_s19_q}) & (parity_3282 | parity_3297);
  logic or_3386;
  assign or_3386 = (parity_3282 & parity_3297) | and_3385;
  logic or_3390;
  assign or_3390 = (parity_3364 & parity_3376) | (parity_3349 & (parity_3364 | parity_3376));
  logic and_3396;
  assign and_3396 = (^{or_3312_s19_q, or_3308_s19_q, or_3304_s19_q}) & (parity_3331 | parity_3346);
  logic or_3397;
  assign or_3397 = (parity_3331 & parity_3346) | and_3396;
  logic or_3401;
  assign or_3401 = (or_3357_s19_q & or_3361_s19_q) | (or_3353_s19_q & (or_3357_s19_q | or_3361_s19_q));
  logic or_3405;
  assign or_3405 = (or_3369_s19_q & or_3373_s19_q) | (and_3365_s19_q & (or_3369_s19_q | or_3373_s19_q));
  // hls/stages/count_bits.hpp:23
  logic or_3412;
  assign or_3412 = (or_3308_s19_q & or_3312_s19_q) | (or_3304_s19_q & (or_3308_s19_q | or_3312_s19_q));
  // hls/stages/count_bits.hpp:25
  logic or_3416;
  assign or_3416 = (or_3324_s19_q & or_3328_s19_q) | (or_3320_s19_q & (or_3324_s19_q | or_3328_s19_q));
  logic or_3420;
  assign or_3420 = (or_3339_s19_q & or_3343_s19_q) | (or_3335_s19_q & (or_3339_s19_q | or_3343_s19_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3423;
  assign parity_3423 = ^{or_3420, or_3416, or_3412};
  // hls/stages/count_bits.hpp:23
  logic or_3427;
  assign or_3427 = (or_3260_s19_q & or_3264_s19_q) | (or_3256_s19_q & (or_3260_s19_q | or_3264_s19_q));
  // hls/stages/count_bits.hpp:25
  logic or_3431;
  assign or_3431 = (or_3275_s19_q & or_3279_s19_q) | (or_3271_s19_q & (or_3275_s19_q | or_3279_s19_q));
  logic or_3435;
  assign or_3435 = (or_3290_s19_q & or_3294_s19_q) | (or_3286_s19_q & (or_3290_s19_q | or_3294_s19_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3438;
  assign parity_3438 = ^{or_3435, or_3431, or_3427};
  logic parity_3441;
  assign parity_3441 = ^{or_3435, or_3431, or_3427, or_3420, or_3416, or_3412, or_3405, or_3401, or_3397};
  // hls/stages/patches.hpp:601
  logic and_3597;
  assign and_3597 = not_3593_s19_q & (~({difference_3594_s19_q, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:608
  logic and_3601;
  assign and_3601 = (10'h38 < patches_peak_size_q) & (~({1'b0, patches_peak_size_q[9:1]} < select_3574_s19_q));
  logic and_3603;
  assign and_3603 = (patches_second_s19_q ? patches_valid_1_q : patches_valid_0_q) & (and_3597 & and_3601);
  // hls/stages/patches.hpp:605
  logic [14:0] difference_3641;
  assign difference_3641 = {{7{select_3635_s19_q[7]}}, select_3635_s19_q} - {product_3640_s19_q[13], product_3640_s19_q};
  // hls/stages/agreement.hpp:798
  logic select_3915;
  assign select_3915 = equal_577_s19_q ? ((x_s19_q[6] & good_known_q) | equal_3913_s19_q) : good_known_q;
  // hls/stages/agreement.hpp:1321
  logic and_4092;
  assign and_4092 = and_2147_s19_q & ({sum_2071_s19_q, index_2_s19_q} == {sum_2057_s19_q, index_s19_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1423; read in stage 19, written in stage 20: 19 < 20 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2057_s19_q, index_s19_q};
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s19_en & (and_2064_s19_q & less_2065_s19_q);
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1620_s19_q, lower_half_s19_q, registration_of_right_s19_q};
  logic registration_sums_we;
  assign registration_sums_we = s19_en & and_1679_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1678_s19_q, sum_1674_s19_q};
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
      moments_left_begins_q <= equal_577_s19_q ? not_2317_s19_q : moments_left_begins_q;
      moments_right_begins_q <= equal_577_s19_q ? not_2327_s19_q : moments_right_begins_q;
      moments_ends_q <= equal_577_s19_q & (equal_2305_s19_q & (not_2360 | and_2362));
      sharpness_sums_detail_0_q <= and_552_s19_q ? select_2386 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_552_s19_q ? select_2398 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s19_q ? select_2440 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s19_q ? select_2442 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s19_q ? select_2469 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s19_q ? select_2475 : sharpness_comparing_less_contrast_1_q;
      registration_moved_q <= not_2934_s19_q & (registration_moved_q | and_2956_s19_q);
      patches_valid_0_q <= select_3051;
      patches_valid_1_q <= select_3056;
      patches_right_next_0_q <= select_3059;
      patches_right_next_1_q <= select_3062;
      patches_left_next_0_q <= select_3065;
      patches_left_next_1_q <= select_3068;
      good_known_q <= select_3915;
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
      census_changes_values_2_left_q <= select_2287;
      census_changes_values_2_right_q <= select_2288;
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
  logic less_675_s20_q;
  logic less_676_s20_q;
  logic less_677_s20_q;
  logic less_678_s20_q;
  logic less_679_s20_q;
  logic less_680_s20_q;
  logic less_681_s20_q;
  logic and_689_s20_q;
  logic and_714_s20_q;
  logic and_715_s20_q;
  logic [8:0] sum_737_s20_q;
  logic and_745_s20_q;
  logic less_746_s20_q;
  logic and_751_s20_q;
  logic less_752_s20_q;
  logic equal_1614_s20_q;
  logic equal_1622_s20_q;
  logic equal_1624_s20_q;
  logic equal_1626_s20_q;
  logic equal_1628_s20_q;
  logic equal_1630_s20_q;
  logic equal_1632_s20_q;
  logic equal_1791_s20_q;
  logic equal_1793_s20_q;
  logic not_1798_s20_q;
  logic [4:0] select_1818_s20_q;
  logic [4:0] select_1821_s20_q;
  logic and_1831_s20_q;
  logic [4:0] select_1846_s20_q;
  logic and_1850_s20_q;
  logic [3:0] column_4_s20_q;
  logic [3:0] select_1865_s20_q;
  logic select_1866_s20_q;
  logic and_1873_s20_q;
  logic not_1994_s20_q;
  logic and_2064_s20_q;
  logic less_2065_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_2071_s20_q;
  logic is_seen_s20_q;
  logic and_2135_s20_q;
  logic and_2147_s20_q;
  logic equal_2290_s20_q;
  logic [8:0] sum_2293_s20_q;
  logic equal_2305_s20_q;
  logic not_2336_s20_q;
  logic and_2357_s20_q;
  logic equal_2408_s20_q;
  logic less_2409_s20_q;
  logic [17:0] select_2421_s20_q;
  logic [17:0] select_2431_s20_q;
  logic equal_2452_s20_q;
  logic and_2614_s20_q;
  logic and_2664_s20_q;
  logic [9:0] select_2668_s20_q;
  logic [9:0] select_2671_s20_q;
  logic [9:0] select_2678_s20_q;
  logic and_2700_s20_q;
  logic and_2721_s20_q;
  logic equal_2921_s20_q;
  logic parity_3252_s20_q;
  logic parity_3381_s20_q;
  logic and_3382_s20_q;
  logic or_3386_s20_q;
  logic or_3390_s20_q;
  logic or_3397_s20_q;
  logic or_3401_s20_q;
  logic or_3405_s20_q;
  logic or_3412_s20_q;
  logic or_3416_s20_q;
  logic or_3420_s20_q;
  logic or_3427_s20_q;
  logic or_3431_s20_q;
  logic or_3435_s20_q;
  logic parity_3441_s20_q;
  logic or_3451_s20_q;
  logic or_3455_s20_q;
  logic and_3462_s20_q;
  logic and_3464_s20_q;
  logic and_3466_s20_q;
  logic equal_3488_s20_q;
  logic and_3588_s20_q;
  logic and_3604_s20_q;
  logic [14:0] difference_3641_s20_q;
  logic equal_3681_s20_q;
  logic less_3801_s20_q;
  logic or_3894_s20_q;
  logic select_3902_s20_q;
  logic equal_3913_s20_q;
  logic equal_3916_s20_q;
  logic equal_3918_s20_q;
  logic equal_3919_s20_q;
  logic equal_3920_s20_q;
  logic equal_3921_s20_q;
  logic and_4077_s20_q;
  logic and_4092_s20_q;
  logic and_4094_s20_q;
  logic not_4106_s20_q;
  logic [31:0] select_4162_s20_q;
  logic [9:0] select_4169_s20_q;
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
      less_675_s20_q <= less_675_s19_q;
      less_676_s20_q <= less_676_s19_q;
      less_677_s20_q <= less_677_s19_q;
      less_678_s20_q <= less_678_s19_q;
      less_679_s20_q <= less_679_s19_q;
      less_680_s20_q <= less_680_s19_q;
      less_681_s20_q <= less_681_s19_q;
      and_689_s20_q <= and_689_s19_q;
      and_714_s20_q <= and_714_s19_q;
      and_715_s20_q <= and_715_s19_q;
      sum_737_s20_q <= sum_737[13:5];
      and_745_s20_q <= and_745_s19_q;
      less_746_s20_q <= less_746_s19_q;
      and_751_s20_q <= (and_714_s19_q & and_741_s19_q) & less_750_s19_q;
      less_752_s20_q <= less_752_s19_q;
      equal_1614_s20_q <= equal_1614_s19_q;
      equal_1622_s20_q <= equal_1622_s19_q;
      equal_1624_s20_q <= equal_1624_s19_q;
      equal_1626_s20_q <= equal_1626_s19_q;
      equal_1628_s20_q <= equal_1628_s19_q;
      equal_1630_s20_q <= equal_1630_s19_q;
      equal_1632_s20_q <= equal_1632_s19_q;
      equal_1791_s20_q <= equal_1791_s19_q;
      equal_1793_s20_q <= equal_1793_s19_q;
      not_1798_s20_q <= not_1798_s19_q;
      select_1818_s20_q <= or_1817_s19_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1821_s20_q <= select_1821_s19_q;
      and_1831_s20_q <= sample_pair_whole_s19_q & and_1830;
      select_1846_s20_q <= or_1845_s19_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1850_s20_q <= sample_pair_whole_s19_q & and_1849;
      column_4_s20_q <= column_4;
      select_1865_s20_q <= select_1865_s19_q;
      select_1866_s20_q <= or_1858_s19_q ? row_starts_s19_q : patches_left_next_0_q[4];
      and_1873_s20_q <= and_1873;
      not_1994_s20_q <= not_1994_s19_q;
      and_2064_s20_q <= and_2064_s19_q;
      less_2065_s20_q <= less_2065_s19_q;
      index_2_s20_q <= index_2_s19_q;
      sum_2071_s20_q <= sum_2071_s19_q;
      is_seen_s20_q <= is_seen;
      and_2135_s20_q <= is_seen & less_2134_s19_q;
      and_2147_s20_q <= and_2147_s19_q;
      equal_2290_s20_q <= equal_2290_s19_q;
      sum_2293_s20_q <= sum_2293[13:5];
      equal_2305_s20_q <= equal_2305_s19_q;
      not_2336_s20_q <= ~moments_ends_q;
      and_2357_s20_q <= cfg_prove_i & and_2356;
      equal_2408_s20_q <= equal_2408_s19_q;
      less_2409_s20_q <= less_2409_s19_q;
      select_2421_s20_q <= select_2421;
      select_2431_s20_q <= select_2431;
      equal_2452_s20_q <= equal_2452_s19_q;
      and_2614_s20_q <= and_2614_s19_q;
      and_2664_s20_q <= not_578_s19_q & (so_s19_q & and_2662);
      select_2668_s20_q <= select_2668_s19_q;
      select_2671_s20_q <= select_2671_s19_q;
      select_2678_s20_q <= select_2678;
      and_2700_s20_q <= so_s19_q & (ends_cell_s19_q & (not_2642_s19_q & and_2697));
      and_2721_s20_q <= and_2721_s19_q;
      equal_2921_s20_q <= equal_2921_s19_q;
      parity_3252_s20_q <= parity_3252_s19_q;
      parity_3381_s20_q <= parity_3381;
      and_3382_s20_q <= and_3382;
      or_3386_s20_q <= or_3386;
      or_3390_s20_q <= or_3390;
      or_3397_s20_q <= or_3397;
      or_3401_s20_q <= or_3401;
      or_3405_s20_q <= or_3405;
      or_3412_s20_q <= or_3412;
      or_3416_s20_q <= or_3416;
      or_3420_s20_q <= or_3420;
      or_3427_s20_q <= or_3427;
      or_3431_s20_q <= or_3431;
      or_3435_s20_q <= or_3435;
      parity_3441_s20_q <= parity_3441;
      or_3451_s20_q <= (or_3416 & or_3420) | (or_3412 & (or_3416 | or_3420));
      or_3455_s20_q <= (or_3431 & or_3435) | (or_3427 & (or_3431 | or_3435));
      and_3462_s20_q <= and_3382 & (or_3386 | or_3390);
      and_3464_s20_q <= parity_3423 & parity_3438;
      and_3466_s20_q <= (^{or_3405, or_3401, or_3397}) & (parity_3423 | parity_3438);
      equal_3488_s20_q <= equal_3488_s19_q;
      and_3588_s20_q <= and_3588_s19_q;
      and_3604_s20_q <= not_3590_s19_q & and_3603;
      difference_3641_s20_q <= difference_3641;
      equal_3681_s20_q <= equal_3681_s19_q;
      less_3801_s20_q <= less_3801_s19_q;
      or_3894_s20_q <= or_3894_s19_q;
      select_3902_s20_q <= select_3902_s19_q;
      equal_3913_s20_q <= equal_3913_s19_q;
      equal_3916_s20_q <= equal_3916_s19_q;
      equal_3918_s20_q <= equal_3918_s19_q;
      equal_3919_s20_q <= equal_3919_s19_q;
      equal_3920_s20_q <= equal_3920_s19_q;
      equal_3921_s20_q <= equal_3921_s19_q;
      and_4077_s20_q <= and_4077_s19_q;
      and_4092_s20_q <= and_4092;
      and_4094_s20_q <= and_4094_s19_q;
      not_4106_s20_q <= not_4106_s19_q;
      select_4162_s20_q <= select_4162_s19_q;
      select_4169_s20_q <= select_4169_s19_q;
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
  // hls/stages/moments.hpp:51
  logic or_2338;
  assign or_2338 = moments_begins_alone_q | (moments_out_of_step_q & not_2336_s20_q);
  // hls/stages/census.hpp:395
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2421_s20_q};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2424;
  assign select_2424 = equal_2408_s20_q ? (less_2409_s20_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:395
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2431_s20_q};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2434;
  assign select_2434 = equal_2408_s20_q ? (less_2409_s20_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2666;
  assign select_2666 = and_2614_s20_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2664_s20_q});
  logic [13:0] select_2680;
  assign select_2680 = and_2614_s20_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2678_s20_q});
  // hls/stages/agreement.hpp:798
  logic and_2701;
  assign and_2701 = not_578_s20_q & and_2700_s20_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2703;
  assign select_2703 = and_2614_s20_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2701});
  logic [13:0] select_2723;
  assign select_2723 = and_2614_s20_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2721_s20_q});
  // hls/stages/count_bits.hpp:24
  logic parity_3443;
  assign parity_3443 = ^{or_3435_s20_q, or_3431_s20_q, or_3427_s20_q, or_3420_s20_q, or_3416_s20_q, or_3412_s20_q, or_3405_s20_q, or_3401_s20_q, or_3397_s20_q, or_3390_s20_q, or_3386_s20_q, and_3382_s20_q};
  // hls/stages/count_bits.hpp:25
  logic or_3447;
  assign or_3447 = (or_3401_s20_q & or_3405_s20_q) | (or_3397_s20_q & (or_3401_s20_q | or_3405_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3458;
  assign parity_3458 = ^{or_3455_s20_q, or_3451_s20_q, or_3447};
  // hls/stages/count_bits.hpp:25
  logic and_3459;
  assign and_3459 = (^{or_3390_s20_q, or_3386_s20_q, and_3382_s20_q}) & parity_3441_s20_q;
  logic or_3463;
  assign or_3463 = (or_3386_s20_q & or_3390_s20_q) | and_3462_s20_q;
  logic or_3467;
  assign or_3467 = and_3464_s20_q | and_3466_s20_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3470;
  assign parity_3470 = ^{or_3467, or_3463, and_3459};
  // hls/stages/count_bits.hpp:25
  logic and_3472;
  assign and_3472 = parity_3458 & parity_3470;
  logic or_3476;
  assign or_3476 = (or_3451_s20_q & or_3455_s20_q) | (or_3447 & (or_3451_s20_q | or_3455_s20_q));
  logic or_3480;
  assign or_3480 = (or_3463 & or_3467) | (and_3459 & (or_3463 | or_3467));
  // hls/stages/patches.hpp:190
  logic and_3605;
  assign and_3605 = and_3588_s20_q & and_3604_s20_q;
  // hls/stages/patches.hpp:667
  logic not_3606;
  assign not_3606 = ~patches_lower_s20_q;
  // hls/stages/patches.hpp:611
  logic less_3642;
  assign less_3642 = $signed({{8{difference_3612[6]}}, difference_3612}) < $signed(difference_3641_s20_q);
  // hls/stages/patches.hpp:610
  logic less_3647;
  assign less_3647 = $signed(difference_3641_s20_q) < $signed({9'h0, cfg_patch_limit_i});
  // hls/stages/agreement.hpp:1142
  logic less_3682;
  assign less_3682 = x_s20_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:798
  logic and_3686;
  assign and_3686 = equal_577_s20_q & (x_s20_q[6] & (not_1994_s20_q & (equal_3681_s20_q & less_3682)));
  // hls/stages/agreement.hpp:1154
  logic and_3691;
  assign and_3691 = x_s20_q[6] & (not_1994_s20_q & (less_3682 & (x_s20_q[2:0] == 3'h1)));
  logic and_3698;
  assign and_3698 = x_s20_q[6] & (not_1994_s20_q & (less_3682 & (x_s20_q[2:0] == 3'h2)));
  logic and_3705;
  assign and_3705 = x_s20_q[6] & (not_1994_s20_q & (less_3682 & (x_s20_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:203
  logic select_3712;
  assign select_3712 = (x_s20_q[5:3] == 3'h2) ? x_s20_q[1] : (x_s20_q[0] & (x_s20_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3739;
  assign sum_3739 = {2'h0, x_s20_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3756;
  assign select_3756 = ($signed(difference_3641_s20_q[14:4]) < $signed(11'h7ff)) ? 6'h30 : difference_3641_s20_q[5:0];
  logic [5:0] select_3757;
  assign select_3757 = ($signed(15'h10) < $signed(difference_3641_s20_q)) ? 6'h10 : select_3756;
  // hls/stages/agreement.hpp:798
  logic and_3764;
  assign and_3764 = equal_577_s20_q & (x_s20_q[6] & (not_1994_s20_q & (equal_2921_s20_q & less_3682)));
  // hls/stages/agreement.hpp:1154
  logic and_3768;
  assign and_3768 = x_s20_q[6] & (not_1994_s20_q & (less_3682 & (x_s20_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:1137
  logic [13:0] select_3923;
  assign select_3923 = equal_3920_s20_q ? counts_skin_unproven_q : (equal_3921_s20_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3925;
  assign select_3925 = equal_3919_s20_q ? counts_regions_bad_q : (equal_3916_s20_q ? counts_nearer_s20_q : select_3923);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3918_s20_q ? counts_on_skin_q : select_3925;
  // hls/stages/agreement.hpp:798
  logic and_4153;
  assign and_4153 = equal_577_s20_q & (x_s20_q[6] & (not_1994_s20_q | (4'hc < x_s20_q[5:2])));
  // hls/stages/agreement.hpp:1152
  logic [31:0] select_4163;
  assign select_4163 = equal_1632_s20_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4162_s20_q;
  logic [31:0] select_4164;
  assign select_4164 = equal_1630_s20_q ? {8'h0, sharpness_sums_detail_0_s20_q} : select_4163;
  logic [31:0] select_4165;
  assign select_4165 = equal_1628_s20_q ? {8'h0, sharpness_sums_detail_1_s20_q} : select_4164;
  logic [31:0] select_4166;
  assign select_4166 = equal_1626_s20_q ? {8'h0, sharpness_sums_contrast_0_s20_q} : select_4165;
  logic [31:0] select_4167;
  assign select_4167 = equal_1624_s20_q ? {8'h0, sharpness_sums_contrast_1_s20_q} : select_4166;

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1821_s20_q, select_1818_s20_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s20_en & and_1831_s20_q;
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
  assign patches_right_1_waddr = {select_1821_s20_q, select_1846_s20_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s20_en & and_1850_s20_q;
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
  assign patches_left_waddr = {select_1866_s20_q, select_1865_s20_q, column_4_s20_q};
  logic patches_left_we;
  assign patches_left_we = s20_en & and_1873_s20_q;
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
  assign map_waddr = {sum_2071_s20_q, index_2_s20_q};
  logic map_we;
  assign map_we = s20_en & and_2147_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2135_s20_q, is_seen_s20_q};
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
      moments_out_of_step_q <= or_2338;
      moments_begins_alone_q <= equal_577_s20_q & (equal_2305_s20_q & and_2357_s20_q);
      sharpness_comparing_rest_0_q <= so_s20_q ? select_2424 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s20_q ? select_2434 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2666;
      counts_regions_bad_q <= select_2680;
      counts_skin_unproven_q <= select_2703;
      counts_on_skin_q <= select_2723;
      patches_frame_ended_q <= equal_577_s20_q & equal_2305_s20_q;
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
  logic less_675_s21_q;
  logic less_676_s21_q;
  logic less_677_s21_q;
  logic less_678_s21_q;
  logic less_679_s21_q;
  logic less_680_s21_q;
  logic less_681_s21_q;
  logic and_689_s21_q;
  logic and_714_s21_q;
  logic and_715_s21_q;
  logic less_738_s21_q;
  logic and_745_s21_q;
  logic less_746_s21_q;
  logic and_751_s21_q;
  logic less_752_s21_q;
  logic equal_1614_s21_q;
  logic equal_1622_s21_q;
  logic equal_1791_s21_q;
  logic equal_1793_s21_q;
  logic and_2064_s21_q;
  logic less_2065_s21_q;
  logic [1:0] map_rdata_s21_q;
  logic is_seen_s21_q;
  logic and_2135_s21_q;
  logic equal_2290_s21_q;
  logic and_2295_s21_q;
  logic equal_2408_s21_q;
  logic sum_s21_q;
  logic sum_2_s21_q;
  logic equal_2452_s21_q;
  logic select_2470_s21_q;
  logic select_2476_s21_q;
  logic [9:0] select_2668_s21_q;
  logic [9:0] select_2671_s21_q;
  logic parity_3252_s21_q;
  logic parity_3381_s21_q;
  logic parity_3443_s21_q;
  logic xor_3471_s21_q;
  logic parity_3483_s21_q;
  logic and_3484_s21_q;
  logic and_3486_s21_q;
  logic equal_3488_s21_q;
  logic and_3608_s21_q;
  logic not_3643_s21_q;
  logic not_3648_s21_q;
  logic and_3652_s21_q;
  logic and_3662_s21_q;
  logic and_3672_s21_q;
  logic equal_3681_s21_q;
  logic and_3686_s21_q;
  logic and_3692_s21_q;
  logic and_3699_s21_q;
  logic and_3706_s21_q;
  logic and_3715_s21_q;
  logic and_3742_s21_q;
  logic [5:0] select_3758_s21_q;
  logic and_3764_s21_q;
  logic and_3769_s21_q;
  logic and_3802_s21_q;
  logic or_3894_s21_q;
  logic select_3902_s21_q;
  logic equal_3913_s21_q;
  logic and_3917_s21_q;
  logic [13:0] before_v_4_s21_q;
  logic not_3962_s21_q;
  logic or_3966_s21_q;
  logic and_3971_s21_q;
  logic less_3972_s21_q;
  logic and_4077_s21_q;
  logic and_4092_s21_q;
  logic and_4094_s21_q;
  logic not_4106_s21_q;
  logic and_4153_s21_q;
  logic [5:0] select_4155_s21_q;
  logic [31:0] select_4167_s21_q;
  logic [9:0] select_4169_s21_q;
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
      less_675_s21_q <= less_675_s20_q;
      less_676_s21_q <= less_676_s20_q;
      less_677_s21_q <= less_677_s20_q;
      less_678_s21_q <= less_678_s20_q;
      less_679_s21_q <= less_679_s20_q;
      less_680_s21_q <= less_680_s20_q;
      less_681_s21_q <= less_681_s20_q;
      and_689_s21_q <= and_689_s20_q;
      and_714_s21_q <= and_714_s20_q;
      and_715_s21_q <= and_715_s20_q;
      less_738_s21_q <= 9'h4 < sum_737_s20_q;
      and_745_s21_q <= and_745_s20_q;
      less_746_s21_q <= less_746_s20_q;
      and_751_s21_q <= and_751_s20_q;
      less_752_s21_q <= less_752_s20_q;
      equal_1614_s21_q <= equal_1614_s20_q;
      equal_1622_s21_q <= equal_1622_s20_q;
      equal_1791_s21_q <= equal_1791_s20_q;
      equal_1793_s21_q <= equal_1793_s20_q;
      and_2064_s21_q <= and_2064_s20_q;
      less_2065_s21_q <= less_2065_s20_q;
      map_rdata_s21_q <= map_rdata_q;
      is_seen_s21_q <= is_seen_s20_q;
      and_2135_s21_q <= and_2135_s20_q;
      equal_2290_s21_q <= equal_2290_s20_q;
      and_2295_s21_q <= and_714_s20_q & (9'h4 < sum_2293_s20_q);
      equal_2408_s21_q <= equal_2408_s20_q;
      sum_s21_q <= sum[0];
      sum_2_s21_q <= sum_2[0];
      equal_2452_s21_q <= equal_2452_s20_q;
      select_2470_s21_q <= sharpness_comparing_less_contrast_0_q;
      select_2476_s21_q <= sharpness_comparing_less_contrast_1_q;
      select_2668_s21_q <= select_2668_s20_q;
      select_2671_s21_q <= select_2671_s20_q;
      parity_3252_s21_q <= parity_3252_s20_q;
      parity_3381_s21_q <= parity_3381_s20_q;
      parity_3443_s21_q <= parity_3443;
      xor_3471_s21_q <= parity_3458 ^ parity_3470;
      parity_3483_s21_q <= ^{or_3480, or_3476, and_3472};
      and_3484_s21_q <= or_3476 & or_3480;
      and_3486_s21_q <= and_3472 & (or_3476 | or_3480);
      equal_3488_s21_q <= equal_3488_s20_q;
      and_3608_s21_q <= and_3605 & (not_1798_s20_q & not_3606);
      not_3643_s21_q <= ~less_3642;
      not_3648_s21_q <= ~less_3647;
      and_3652_s21_q <= and_3605 & (patches_second_s20_q & not_3606);
      and_3662_s21_q <= and_3605 & (patches_lower_s20_q & not_1798_s20_q);
      and_3672_s21_q <= and_3605 & (patches_lower_s20_q & patches_second_s20_q);
      equal_3681_s21_q <= equal_3681_s20_q;
      and_3686_s21_q <= and_3686;
      and_3692_s21_q <= equal_577_s20_q & and_3691;
      and_3699_s21_q <= equal_577_s20_q & and_3698;
      and_3706_s21_q <= equal_577_s20_q & and_3705;
      and_3715_s21_q <= x_s20_q[6] & (not_1994_s20_q & (less_3682 & select_3712));
      and_3742_s21_q <= not_1994_s20_q & (less_3682 & (sum_3739[4:2] == 3'h0));
      select_3758_s21_q <= and_3605 ? select_3757 : 6'h0;
      and_3764_s21_q <= and_3764;
      and_3769_s21_q <= equal_577_s20_q & and_3768;
      and_3802_s21_q <= less_3801_s20_q & and_3605;
      or_3894_s21_q <= or_3894_s20_q;
      select_3902_s21_q <= select_3902_s20_q;
      equal_3913_s21_q <= equal_3913_s20_q;
      and_3917_s21_q <= equal_3916_s20_q & equal_3681_s20_q;
      before_v_4_s21_q <= before_v_4;
      not_3962_s21_q <= ~(equal_3921_s20_q & equal_3681_s20_q);
      or_3966_s21_q <= (equal_3921_s20_q | equal_3920_s20_q) | (x_s20_q[6:3] == 4'hf);
      and_3971_s21_q <= equal_3918_s20_q & equal_3681_s20_q;
      less_3972_s21_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4077_s21_q <= and_4077_s20_q;
      and_4092_s21_q <= and_4092_s20_q;
      and_4094_s21_q <= and_4094_s20_q;
      not_4106_s21_q <= not_4106_s20_q;
      and_4153_s21_q <= and_4153;
      select_4155_s21_q <= equal_577_s20_q ? (x_s20_q[6] ? x_s20_q[5:0] : 6'h0) : 6'h0;
      select_4167_s21_q <= select_4167;
      select_4169_s21_q <= select_4169_s20_q;
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
  logic and_739;
  assign and_739 = and_689_s21_q & less_738_s21_q;
  // hls/stages/census.hpp:324
  logic and_2296;
  assign and_2296 = and_714_s21_q & less_738_s21_q;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2297;
  assign sum_2297 = census_left_misses_q + {{17{and_2296}}, and_2295_s21_q, 1'b0, and_2295_s21_q};
  // hls/stages/agreement.hpp:530
  logic [19:0] select_2299;
  assign select_2299 = and_552_s21_q ? (equal_2290_s21_q ? 20'h0 : sum_2297) : census_left_misses_q;
  // hls/stages/agreement.hpp:217
  logic [2:0] select_2436;
  assign select_2436 = equal_2408_s21_q ? {sharpness_comparing_product_0_q[1:0], sum_s21_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2438;
  assign select_2438 = equal_2408_s21_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s21_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s21_q});
  // hls/stages/agreement.hpp:217
  logic select_2447;
  assign select_2447 = so_s21_q ? (equal_2408_s21_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s21_q});
  // hls/stages/agreement.hpp:217
  logic select_2450;
  assign select_2450 = equal_2408_s21_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:403
  logic xor_2453;
  assign xor_2453 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2459;
  assign xor_2459 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/count_bits.hpp:27
  logic or_3487;
  assign or_3487 = and_3484_s21_q | and_3486_s21_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3487, parity_3483_s21_q, xor_3471_s21_q, parity_3443_s21_q, parity_3381_s21_q, parity_3252_s21_q} + (equal_3488_s21_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3492;
  assign select_3492 = equal_1791_s21_q ? patches_sums_values_0_q : (equal_1793_s21_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3493;
  assign select_3493 = equal_1793_s21_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3495;
  assign select_3495 = equal_1793_s21_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3497;
  assign select_3497 = equal_1793_s21_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3499;
  assign select_3499 = equal_1793_s21_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3501;
  assign select_3501 = equal_1793_s21_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3503;
  assign select_3503 = equal_1793_s21_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3505;
  assign select_3505 = equal_1793_s21_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3507;
  assign select_3507 = equal_1793_s21_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3509;
  assign select_3509 = equal_1793_s21_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3511;
  assign select_3511 = equal_1793_s21_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3513;
  assign select_3513 = equal_1793_s21_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3515;
  assign select_3515 = equal_1793_s21_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3517;
  assign select_3517 = equal_1793_s21_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3519;
  assign select_3519 = equal_1793_s21_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3521;
  assign select_3521 = equal_1793_s21_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3523;
  assign select_3523 = equal_1793_s21_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3610;
  assign sum_3610 = {7'h0, and_3608_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:670
  logic and_3644;
  assign and_3644 = not_3643_s21_q & and_3608_s21_q;
  logic [7:0] sum_3645;
  assign sum_3645 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3644};
  // hls/stages/patches.hpp:671
  logic and_3649;
  assign and_3649 = not_3648_s21_q & and_3608_s21_q;
  logic [7:0] sum_3650;
  assign sum_3650 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3649};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3654;
  assign sum_3654 = {7'h0, and_3652_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_3656;
  assign and_3656 = not_3643_s21_q & and_3652_s21_q;
  logic [7:0] sum_3657;
  assign sum_3657 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3656};
  // hls/stages/patches.hpp:671
  logic and_3659;
  assign and_3659 = not_3648_s21_q & and_3652_s21_q;
  logic [7:0] sum_3660;
  assign sum_3660 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3659};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3664;
  assign sum_3664 = {7'h0, and_3662_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_3666;
  assign and_3666 = not_3643_s21_q & and_3662_s21_q;
  logic [7:0] sum_3667;
  assign sum_3667 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3666};
  // hls/stages/patches.hpp:671
  logic and_3669;
  assign and_3669 = not_3648_s21_q & and_3662_s21_q;
  logic [7:0] sum_3670;
  assign sum_3670 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3669};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3674;
  assign sum_3674 = {7'h0, and_3672_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_3676;
  assign and_3676 = not_3643_s21_q & and_3672_s21_q;
  logic [7:0] sum_3677;
  assign sum_3677 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3676};
  // hls/stages/patches.hpp:671
  logic and_3679;
  assign and_3679 = not_3648_s21_q & and_3672_s21_q;
  logic [7:0] sum_3680;
  assign sum_3680 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3679};
  // hls/stages/patches.hpp:633
  logic [7:0] or_3694;
  assign or_3694 = (and_3686_s21_q ? patches_quarters_0_places_q : 8'h0) | (and_3692_s21_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3708;
  assign or_3708 = (or_3694 | (and_3699_s21_q ? patches_quarters_2_places_q : 8'h0)) | (and_3706_s21_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:798
  logic and_3716;
  assign and_3716 = equal_577_s21_q & and_3715_s21_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_3718;
  assign select_3718 = and_3686_s21_q ? (and_3716 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3720;
  assign select_3720 = and_3692_s21_q ? (and_3716 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3723;
  assign select_3723 = and_3699_s21_q ? (and_3716 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3726;
  assign select_3726 = and_3706_s21_q ? (and_3716 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_3729;
  assign select_3729 = and_3686_s21_q ? (and_3716 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3731;
  assign select_3731 = and_3692_s21_q ? (and_3716 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3734;
  assign select_3734 = and_3699_s21_q ? (and_3716 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3737;
  assign select_3737 = and_3706_s21_q ? (and_3716 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic and_3744;
  assign and_3744 = equal_577_s21_q & (x_s21_q & and_3742_s21_q);
  // hls/stages/patches.hpp:628
  logic [7:0] sum_3746;
  assign sum_3746 = patches_word_places_q + (and_3692_s21_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:630
  logic [7:0] select_3750;
  assign select_3750 = and_3744 ? (patches_word_up_q + (and_3692_s21_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3752;
  assign sum_3752 = patches_word_down_q + (and_3692_s21_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:673
  logic [11:0] sum_3759;
  assign sum_3759 = patches_across_q + {{6{select_3758_s21_q[5]}}, select_3758_s21_q};
  // hls/stages/patches.hpp:674
  logic [11:0] select_3760;
  assign select_3760 = patches_round_ends_q ? {{6{select_3758_s21_q[5]}}, select_3758_s21_q} : sum_3759;
  // hls/stages/patches.hpp:657
  logic [7:0] select_3771;
  assign select_3771 = and_3764_s21_q ? (and_3769_s21_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_3775;
  assign or_3775 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_3778;
  assign or_3778 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_3779;
  assign sum_3779 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_3781;
  assign select_3781 = and_3764_s21_q ? (and_3769_s21_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3784;
  assign and_3784 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_3785;
  assign select_3785 = and_3764_s21_q ? {and_3784, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3787;
  assign select_3787 = and_3764_s21_q ? (and_3769_s21_q ? {and_3784, patches_found_q[2:1]} : select_3785) : patches_found_q;
  // hls/stages/patches.hpp:655
  logic or_3790;
  assign or_3790 = patches_partly_q | (patches_doubted_q & (~and_3769_s21_q));
  // hls/stages/patches.hpp:656
  logic select_3792;
  assign select_3792 = and_3769_s21_q ? or_3790 : (and_3764_s21_q ? or_3790 : patches_doubted_q);
  // hls/stages/patches.hpp:654
  logic select_3794;
  assign select_3794 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3798;
  assign select_3798 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3803;
  assign sum_3803 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3802_s21_q};
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_3826;
  assign select_3826 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_3832;
  assign and_3832 = patches_frame_ended_s21_q & (~patches_age_q[9]);
  logic [9:0] sum_3833;
  assign sum_3833 = patches_age_q + {9'h0, and_3832};
  logic [9:0] select_3836;
  assign select_3836 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3833)) : sum_3833;
  // hls/stages/agreement.hpp:1234
  logic [14:0] over;
  assign over = {1'b0, product_s21_q} - {1'b0, before_v_4_s21_q};
  // hls/stages/agreement.hpp:1242
  logic select_3928;
  assign select_3928 = and_3917_s21_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1321
  logic [1:0] select_4093;
  assign select_4093 = and_4092_s21_q ? {and_2135_s21_q, is_seen_s21_q} : map_rdata_s21_q;
  // hls/stages/agreement.hpp:1251
  logic or_4107;
  assign or_4107 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4106_s21_q;
  // hls/stages/agreement.hpp:798
  logic and_4122;
  assign and_4122 = equal_3913_s21_q & (cfg_prove_i & (registration_moved_s21_q | patches_moved_q));
  // hls/stages/agreement.hpp:1162
  logic or_4125;
  assign or_4125 = select_2470_s21_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:798
  logic and_4149;
  assign and_4149 = equal_577_s21_q & (equal_3913_s21_q & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/agreement.hpp:1152
  logic [31:0] select_4168;
  assign select_4168 = equal_1622_s21_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4167_s21_q;
  // hls/stages/agreement.hpp:1154
  logic [31:0] select_4170;
  assign select_4170 = equal_1614_s21_q ? select_4168 : {2'h0, select_4169_s21_q, select_2671_s21_q, select_2668_s21_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s21_q;
  logic fresh_we;
  assign fresh_we = s21_en & and_552_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_752_s21_q, and_751_s21_q, less_746_s21_q, and_745_s21_q, census_columns_values_1_cell_2_of_skin_s21_q, and_739, and_715_s21_q, and_714_s21_q, and_689_s21_q, less_681_s21_q, less_680_s21_q, less_679_s21_q, less_678_s21_q, less_677_s21_q, less_676_s21_q, less_675_s21_q, less_674_s21_q, less_673_s21_q, less_672_s21_q, less_671_s21_q, less_670_s21_q, less_669_s21_q, less_668_s21_q, less_667_s21_q, less_666_s21_q, less_665_s21_q, less_664_s21_q, less_663_s21_q, less_662_s21_q, less_661_s21_q, less_660_s21_q, less_659_s21_q, less_658_s21_q};
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
      census_left_misses_q <= select_2299;
      sharpness_comparing_product_0_q <= so_s21_q ? select_2436 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s21_q ? select_2438 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2447;
      sharpness_comparing_carry_1_q <= so_s21_q ? select_2450 : sharpness_comparing_carry_1_q;
      patches_sums_values_0_q <= select_3492;
      patches_sums_values_1_q <= equal_1791_s21_q ? patches_sums_values_1_q : select_3493;
      patches_sums_values_2_q <= equal_1791_s21_q ? patches_sums_values_2_q : select_3495;
      patches_sums_values_3_q <= equal_1791_s21_q ? patches_sums_values_3_q : select_3497;
      patches_sums_values_4_q <= equal_1791_s21_q ? patches_sums_values_4_q : select_3499;
      patches_sums_values_5_q <= equal_1791_s21_q ? patches_sums_values_5_q : select_3501;
      patches_sums_values_6_q <= equal_1791_s21_q ? patches_sums_values_6_q : select_3503;
      patches_sums_values_7_q <= equal_1791_s21_q ? patches_sums_values_7_q : select_3505;
      patches_sums_values_8_q <= equal_1791_s21_q ? patches_sums_values_8_q : select_3507;
      patches_sums_values_9_q <= equal_1791_s21_q ? patches_sums_values_9_q : select_3509;
      patches_sums_values_10_q <= equal_1791_s21_q ? patches_sums_values_10_q : select_3511;
      patches_sums_values_11_q <= equal_1791_s21_q ? patches_sums_values_11_q : select_3513;
      patches_sums_values_12_q <= equal_1791_s21_q ? patches_sums_values_12_q : select_3515;
      patches_sums_values_13_q <= equal_1791_s21_q ? patches_sums_values_13_q : select_3517;
      patches_sums_values_14_q <= equal_1791_s21_q ? patches_sums_values_14_q : select_3519;
      patches_sums_values_15_q <= equal_1791_s21_q ? patches_sums_values_15_q : select_3521;
      patches_sums_values_16_q <= equal_1791_s21_q ? patches_sums_values_16_q : select_3523;
      patches_quarters_0_places_q <= sum_3610;
      patches_quarters_0_up_q <= sum_3645;
      patches_quarters_0_down_q <= sum_3650;
      patches_quarters_1_places_q <= sum_3654;
      patches_quarters_1_up_q <= sum_3657;
      patches_quarters_1_down_q <= sum_3660;
      patches_quarters_2_places_q <= sum_3664;
      patches_quarters_2_up_q <= sum_3667;
      patches_quarters_2_down_q <= sum_3670;
      patches_quarters_3_places_q <= sum_3674;
      patches_quarters_3_up_q <= sum_3677;
      patches_quarters_3_down_q <= sum_3680;
      patches_word_places_q <= or_3708;
      patches_word_up_q <= ((select_3718 | select_3720) | select_3723) | select_3726;
      patches_word_down_q <= ((select_3729 | select_3731) | select_3734) | select_3737;
      patches_sum_places_q <= and_3744 ? sum_3746 : patches_sum_places_q;
      patches_sum_up_q <= select_3750;
      patches_sum_down_q <= and_3744 ? sum_3752 : patches_sum_down_q;
      patches_across_q <= select_3760;
      patches_places_q <= select_3771;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3775;
      patches_partly_q <= or_3778;
      patches_clear_limit_q <= sum_3779[8:2];
      patches_complete_q <= select_3781;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3787;
      patches_doubted_q <= and_3764_s21_q ? select_3792 : patches_doubted_q;
      patches_doubted_before_q <= select_3794;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3798;
      patches_on_skin_q <= sum_3803;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3826;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3836;
      hides_q <= equal_577_s21_q ? select_3928 : hides_q;
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
  logic and_2064_s22_q;
  logic less_2065_s22_q;
  logic equal_2408_s22_q;
  logic or_2454_s22_q;
  logic and_2455_s22_q;
  logic or_2460_s22_q;
  logic and_2461_s22_q;
  logic select_2476_s22_q;
  logic or_3894_s22_q;
  logic select_3902_s22_q;
  logic equal_3913_s22_q;
  logic select_3928_s22_q;
  logic and_3960_s22_q;
  logic not_3962_s22_q;
  logic or_3966_s22_q;
  logic and_3971_s22_q;
  logic and_3973_s22_q;
  logic and_4077_s22_q;
  logic and_4095_s22_q;
  logic and_4098_s22_q;
  logic and_4110_s22_q;
  logic and_4123_s22_q;
  logic or_4125_s22_q;
  logic and_4149_s22_q;
  logic and_4153_s22_q;
  logic [5:0] select_4155_s22_q;
  logic [31:0] select_4172_s22_q;
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
      and_2064_s22_q <= and_2064_s21_q;
      less_2065_s22_q <= less_2065_s21_q;
      equal_2408_s22_q <= equal_2408_s21_q;
      or_2454_s22_q <= equal_2452_s21_q | xor_2453;
      and_2455_s22_q <= five_times[0] & xor_2453;
      or_2460_s22_q <= equal_2452_s21_q | xor_2459;
      and_2461_s22_q <= five_times_2[0] & xor_2459;
      select_2476_s22_q <= select_2476_s21_q;
      or_3894_s22_q <= or_3894_s21_q;
      select_3902_s22_q <= select_3902_s21_q;
      equal_3913_s22_q <= equal_3913_s21_q;
      select_3928_s22_q <= select_3928;
      and_3960_s22_q <= over[14] & equal_3681_s21_q;
      not_3962_s22_q <= not_3962_s21_q;
      or_3966_s22_q <= or_3966_s21_q;
      and_3971_s22_q <= and_3971_s21_q;
      and_3973_s22_q <= over[14] & less_3972_s21_q;
      and_4077_s22_q <= and_4077_s21_q;
      and_4095_s22_q <= select_4093[0] & and_4094_s21_q;
      and_4098_s22_q <= select_4093[1] & and_4094_s21_q;
      and_4110_s22_q <= equal_577_s21_q & (equal_3913_s21_q & (cfg_prove_i & or_4107));
      and_4123_s22_q <= equal_577_s21_q & and_4122;
      or_4125_s22_q <= or_4125;
      and_4149_s22_q <= and_4149;
      and_4153_s22_q <= and_4153_s21_q;
      select_4155_s22_q <= select_4155_s21_q;
      select_4172_s22_q <= equal_577_s21_q ? (x_s21_q ? select_4170 : 32'h0) : 32'h0;
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
  logic less_1976;
  assign less_1976 = patches_sums_values_0_s22_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_1977;
  assign not_1977 = ~less_1976;
  logic [1:0] select_1978;
  assign select_1978 = patches_summed_first_s22_q ? 2'h2 : {less_1976, not_1977};
  logic [12:0] select_1980;
  assign select_1980 = select_1978[0] ? {4'h0, patches_summed_first_s22_q, 3'h0, patches_summed_row_column_s22_q} : {patches_summed_row_column_s22_q, patches_sums_values_0_s22_q[7:0]};
  logic [14:0] select_1981;
  assign select_1981 = select_1978[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1982;
  assign select_1982 = (select_1978 == 2'h2) ? {select_1980[12:8], patches_sums_values_0_s22_q[9:8], select_1980[7:0]} : select_1981;
  // hls/stages/census.hpp:403
  logic select_2456;
  assign select_2456 = or_2454_s22_q ? and_2455_s22_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2457;
  assign select_2457 = equal_2408_s22_q ? select_2456 : sharpness_comparing_less_detail_0_q;
  logic select_2458;
  assign select_2458 = so_s22_q ? select_2457 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic select_2462;
  assign select_2462 = or_2460_s22_q ? and_2461_s22_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2463;
  assign select_2463 = equal_2408_s22_q ? select_2462 : sharpness_comparing_less_detail_1_q;
  logic select_2464;
  assign select_2464 = so_s22_q ? select_2463 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:663
  logic [12:0] product_3808;
  assign product_3808 = {8'h0, patches_on_skin_limit_q} * {5'h0, patches_places_q};
  // hls/stages/agreement.hpp:1160
  logic not_3929;
  assign not_3929 = ~hidden_for_q[7];
  logic [7:0] select_3931;
  assign select_3931 = select_3928_s22_q ? (hidden_for_q + {7'h0, not_3929}) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3933;
  assign select_3933 = equal_577_s22_q ? (equal_3913_s22_q ? select_3931 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1240
  logic and_3963;
  assign and_3963 = too_much_q & not_3962_s22_q;
  // hls/stages/agreement.hpp:1241
  logic select_3968;
  assign select_3968 = and_3960_s22_q ? (and_3963 | or_3966_s22_q) : and_3963;
  // hls/stages/agreement.hpp:1243
  logic select_3974;
  assign select_3974 = and_3971_s22_q ? and_3973_s22_q : overlooks_q;
  // hls/stages/agreement.hpp:443
  logic select_4097;
  assign select_4097 = and_2064_s22_q ? (less_2065_s22_q ? and_4095_s22_q : seen_q) : seen_q;
  logic select_4100;
  assign select_4100 = and_2064_s22_q ? (less_2065_s22_q ? and_4098_s22_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:798
  logic and_4113;
  assign and_4113 = equal_577_s22_q & (equal_3913_s22_q & (cfg_prove_i & or_3894_s22_q));
  // hls/stages/agreement.hpp:1253
  logic not_4115;
  assign not_4115 = ~(or_3894_s22_q | not_2360);
  // hls/stages/agreement.hpp:798
  logic and_4118;
  assign and_4118 = equal_3913_s22_q & (not_4115 & (select_3902_s22_q | select_3968));
  logic and_4132;
  assign and_4132 = equal_3913_s22_q & (not_4115 & (select_2464 | select_2476_s22_q));

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
      sharpness_comparing_less_detail_0_q <= select_2458;
      sharpness_comparing_less_detail_1_q <= select_2464;
      patches_best_differing_q <= select_1982[9:0];
      patches_best_column_q <= select_1982[14:10];
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      hidden_for_q <= select_3933;
      too_much_q <= equal_577_s22_q ? select_3968 : too_much_q;
      overlooks_q <= equal_577_s22_q ? select_3974 : overlooks_q;
      seen_q <= select_4097;
      nearer_q <= select_4100;
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
  logic [7:0] product_3808_s23_q;
  logic equal_3913_s23_q;
  logic and_4077_s23_q;
  logic and_4110_s23_q;
  logic and_4113_s23_q;
  logic and_4119_s23_q;
  logic and_4123_s23_q;
  logic and_4128_s23_q;
  logic and_4132_s23_q;
  logic not_4137_s23_q;
  logic or_4143_s23_q;
  logic and_4149_s23_q;
  logic and_4153_s23_q;
  logic [5:0] select_4155_s23_q;
  logic [31:0] select_4172_s23_q;
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
      product_3808_s23_q <= product_3808[12:5];
      equal_3913_s23_q <= equal_3913_s22_q;
      and_4077_s23_q <= and_4077_s22_q;
      and_4110_s23_q <= and_4110_s22_q;
      and_4113_s23_q <= and_4113;
      and_4119_s23_q <= equal_577_s22_q & and_4118;
      and_4123_s23_q <= and_4123_s22_q;
      and_4128_s23_q <= equal_3913_s22_q & (not_4115 & (select_2458 | or_4125_s22_q));
      and_4132_s23_q <= and_4132;
      not_4137_s23_q <= ~(select_3931 < cfg_hidden_frames_i);
      or_4143_s23_q <= not_2360 | (select_3974 & not_3805);
      and_4149_s23_q <= and_4149_s22_q;
      and_4153_s23_q <= and_4153_s22_q;
      select_4155_s23_q <= select_4155_s22_q;
      select_4172_s23_q <= select_4172_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:192
  logic and_3810;
  assign and_3810 = (~(patches_on_skin_s23_q[7:2] == 6'h0)) & (product_3808_s23_q < patches_on_skin_s23_q);
  logic select_3815;
  assign select_3815 = patches_round_ends_s23_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_3819;
  assign or_3819 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s23_q));
  // hls/stages/agreement.hpp:1162
  logic and_4139;
  assign and_4139 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4137_s23_q);
  // hls/stages/agreement.hpp:798
  logic and_4145;
  assign and_4145 = equal_3913_s23_q & (or_4143_s23_q ? cfg_prove_i : patches_overlooked_q);

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
      patches_large_q <= not_3805 & and_3810;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3815;
      patches_spoiled_q <= or_3819;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic and_4077_s24_q;
  logic or_4101_s24_q;
  logic and_4102_s24_q;
  logic and_4110_s24_q;
  logic and_4113_s24_q;
  logic and_4119_s24_q;
  logic and_4123_s24_q;
  logic and_4129_s24_q;
  logic and_4133_s24_q;
  logic and_4141_s24_q;
  logic and_4146_s24_q;
  logic and_4149_s24_q;
  logic and_4153_s24_q;
  logic [5:0] select_4155_s24_q;
  logic [31:0] select_4172_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      and_4077_s24_q <= and_4077_s23_q;
      or_4101_s24_q <= not_2360 | seen_q;
      and_4102_s24_q <= cfg_prove_i & nearer_q;
      and_4110_s24_q <= and_4110_s23_q;
      and_4113_s24_q <= and_4113_s23_q;
      and_4119_s24_q <= and_4119_s23_q;
      and_4123_s24_q <= and_4123_s23_q;
      and_4129_s24_q <= equal_577_s23_q & and_4128_s23_q;
      and_4133_s24_q <= equal_577_s23_q & and_4132_s23_q;
      and_4141_s24_q <= equal_577_s23_q & (equal_3913_s23_q & and_4139);
      and_4146_s24_q <= equal_577_s23_q & and_4145;
      and_4149_s24_q <= and_4149_s23_q;
      and_4153_s24_q <= and_4153_s23_q;
      select_4155_s24_q <= select_4155_s23_q;
      select_4172_s24_q <= select_4172_s23_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s24_q;
  assign pixel_1_o = pixel_1_s24_q;
  assign saturated_o = saturated_s24_q;
  assign mask_o = mask_s24_q;
  assign marks_first_o = marks_first_s24_q;
  assign marks_last_o = marks_last_s24_q;
  assign marks_seen_o = or_4101_s24_q;
  assign marks_nearer_o = and_4102_s24_q;
  assign verdict_valid_o = and_4077_s24_q;
  assign verdict_unproven_yet_o = and_4110_s24_q;
  assign verdict_untextured_o = and_4113_s24_q;
  assign verdict_disagree_o = and_4119_s24_q;
  assign verdict_moved_o = and_4123_s24_q;
  assign verdict_unsharp_left_o = and_4129_s24_q;
  assign verdict_unsharp_right_o = and_4133_s24_q;
  assign verdict_hidden_o = and_4141_s24_q;
  assign verdict_overlooked_o = and_4146_s24_q;
  assign verdict_out_of_step_o = and_4149_s24_q;
  assign frame_valid_o = and_4153_s24_q;
  assign frame_index_o = select_4155_s24_q;
  assign frame_word_o = select_4172_s24_q;
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
  assign unused_bits = ^{over[13:0], sum_3844[6:0], product_3808[4:0], sum_3779[1:0], sum_3739[1:0], product_3640[4:0], sum_2771[0], difference_2709[1:0], detail_4[1:0], detail_3[1:0], sum_2293[4:0], sum_1772[1:0], sum_1771[1:0], sum_1767[0], sum_1716[0], sum_1712[0], sum_737[4:0], cfg_width_i[3:0]};

endmodule
