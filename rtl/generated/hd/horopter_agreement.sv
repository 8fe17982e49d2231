// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 24 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3131 bits, pipeline 8607 bits, memories 157167 bits.
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
  logic not_2347;
  assign not_2347 = ~cfg_prove_i;
  logic [6:0] sum_2560;
  assign sum_2560 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3583;
  assign difference_3583 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3776;
  assign not_3776 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3834;
  assign difference_3834 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_4050;
  assign less_4050 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_4051;
  assign sum_4051 = {1'b0, cfg_height_i[10:7]} + 5'h1f;

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
  logic [3:0] select_509;
  assign select_509 = sample_pair_first_q ? 4'h0 : raster_at_x_q;
  // hls/stages/census.hpp:114
  logic equal_510;
  assign equal_510 = select_509[1:0] == 2'h0;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [8:0] select_514;
  assign select_514 = equal_510 ? (row_starts ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/census.hpp:42
  logic [3:0] select_528;
  assign select_528 = sample_pair_first_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2137;
  assign select_2137 = sample_pair_whole_q ? (sample_last_q ? 4'h0 : (select_509 + 4'h1)) : raster_at_x_q;
  logic [3:0] select_2140;
  assign select_2140 = sample_pair_whole_q ? (sample_last_q ? (select_528 + 4'h1) : select_528) : raster_at_y_q;

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
      raster_at_x_q <= select_2137;
      raster_at_y_q <= select_2140;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      averager_place_q <= sample_pair_whole_q ? select_514 : averager_place_q;
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
  logic [3:0] select_509_s1_q;
  logic equal_510_s1_q;
  logic row_starts_s1_q;
  logic [8:0] select_514_s1_q;
  logic not_516_s1_q;
  logic [3:0] select_528_s1_q;
  logic equal_547_s1_q;
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
      select_509_s1_q <= select_509;
      equal_510_s1_q <= equal_510;
      row_starts_s1_q <= row_starts;
      select_514_s1_q <= select_514;
      not_516_s1_q <= ~(averager_place_q == 9'h1df);
      select_528_s1_q <= select_528;
      equal_547_s1_q <= select_528 == 4'hf;
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
  logic select_519;
  assign select_519 = equal_510_s1_q ? (row_starts_s1_q | (averager_inside_q & not_516_s1_q)) : averager_inside_q;
  // hls/stages/census.hpp:42
  logic or_520;
  assign or_520 = sample_pair_first_s1_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_523;
  assign and_523 = select_519 & (or_520 & (select_509_s1_q[1:0] == 2'h3));
  // hls/stages/census.hpp:42
  logic [6:0] select_544;
  assign select_544 = sample_pair_first_s1_q ? 7'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_s1_q ? select_544 : 7'h0;
  // hls/stages/census.hpp:53
  logic equal_546;
  assign equal_546 = select_509_s1_q == 4'hf;
  // hls/stages/census.hpp:134
  logic and_548;
  assign and_548 = equal_547_s1_q & and_523;
  // hls/stages/census.hpp:42
  logic [6:0] select_678;
  assign select_678 = sample_pair_first_s1_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] row;
  assign row = sample_pair_whole_s1_q ? select_678 : 7'h0;
  logic [6:0] select_2143;
  assign select_2143 = sample_pair_whole_s1_q ? (sample_last_s1_q ? 7'h0 : (select_544 + {6'h0, equal_546})) : raster_at_column_q;
  // hls/stages/census.hpp:62
  logic [6:0] select_2145;
  assign select_2145 = sample_last_s1_q ? (select_678 + {6'h0, equal_547_s1_q}) : select_678;
  // hls/stages/agreement.hpp:276
  logic select_2150;
  assign select_2150 = sample_pair_whole_s1_q ? (sample_last_s1_q ? (or_520 & (~raster_final_row_q)) : or_520) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [10:0] select_2152;
  assign select_2152 = sample_pair_first_s1_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s1_q});
  // hls/stages/agreement.hpp:276
  logic select_2156;
  assign select_2156 = sample_pair_whole_s1_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_inside_q <= 1'b1;
    end else if (s1_en) begin
      raster_at_column_q <= select_2143;
      raster_at_row_q <= sample_pair_whole_s1_q ? select_2145 : raster_at_row_q;
      raster_at_live_q <= select_2150;
      raster_rows_left_q <= sample_pair_whole_s1_q ? select_2152 : raster_rows_left_q;
      raster_final_row_q <= select_2156;
      averager_inside_q <= sample_pair_whole_s1_q ? select_519 : averager_inside_q;
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
  logic [3:0] select_509_s2_q;
  logic equal_510_s2_q;
  logic row_starts_s2_q;
  logic [8:0] select_514_s2_q;
  logic and_523_s2_q;
  logic [3:0] select_528_s2_q;
  logic [6:0] select_544_s2_q;
  logic [6:0] last_s2_q;
  logic and_548_s2_q;
  logic and_550_s2_q;
  logic [6:0] select_678_s2_q;
  logic [6:0] row_s2_q;
  logic equal_1679_s2_q;
  logic [7:0] sum_2465_s2_q;
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
      select_509_s2_q <= select_509_s1_q;
      equal_510_s2_q <= equal_510_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_514_s2_q <= select_514_s1_q;
      and_523_s2_q <= and_523;
      select_528_s2_q <= select_528_s1_q;
      select_544_s2_q <= select_544;
      last_s2_q <= last;
      and_548_s2_q <= and_548;
      and_550_s2_q <= sample_pair_whole_s1_q & (equal_546 & and_548);
      select_678_s2_q <= select_678;
      row_s2_q <= row;
      equal_1679_s2_q <= {or_520, select_528_s1_q} == 5'h18;
      sum_2465_s2_q <= {1'b0, last} + 8'h1;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:459
  logic equal_2466;
  assign equal_2466 = {sum_2465_s2_q[7], cfg_width_i[10:4]} == {1'b0, sum_2465_s2_q[6:0]};
  // hls/stages/agreement.hpp:476
  logic [7:0] sum_2556;
  assign sum_2556 = {1'b0, row_s2_q} + 8'h1;
  // hls/stages/patches.hpp:375
  logic [7:0] sum_2997;
  assign sum_2997 = {1'b0, select_678_s2_q} + 8'h1;

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic [3:0] select_509_s3_q;
  logic equal_510_s3_q;
  logic row_starts_s3_q;
  logic [8:0] select_514_s3_q;
  logic and_523_s3_q;
  logic equal_529_s3_q;
  logic [6:0] select_544_s3_q;
  logic [6:0] last_s3_q;
  logic and_548_s3_q;
  logic and_550_s3_q;
  logic [6:0] row_s3_q;
  logic equal_1679_s3_q;
  logic equal_2466_s3_q;
  logic and_2467_s3_q;
  logic equal_2557_s3_q;
  logic not_2999_s3_q;
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
      select_509_s3_q <= select_509_s2_q;
      equal_510_s3_q <= equal_510_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_514_s3_q <= select_514_s2_q;
      and_523_s3_q <= and_523_s2_q;
      equal_529_s3_q <= select_528_s2_q == 4'h0;
      select_544_s3_q <= select_544_s2_q;
      last_s3_q <= last_s2_q;
      and_548_s3_q <= and_548_s2_q;
      and_550_s3_q <= and_550_s2_q;
      row_s3_q <= row_s2_q;
      equal_1679_s3_q <= equal_1679_s2_q;
      equal_2466_s3_q <= equal_2466;
      and_2467_s3_q <= and_550_s2_q & equal_2466;
      equal_2557_s3_q <= {sum_2556[7], cfg_height_i[10:4]} == {1'b0, sum_2556[6:0]};
      not_2999_s3_q <= ~({sum_2997, select_528_s2_q, 1'b0} < {2'h0, cfg_height_i});
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
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_579;
  assign equal_579 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:614
  logic equal_594;
  assign equal_594 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_595;
  assign equal_595 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:523
  logic select_2470;
  assign select_2470 = (and_2467_s3_q | (~ends_cell_q)) ? and_2467_s3_q : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2470 ? (and_2467_s3_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2474;
  assign select_2474 = select_2470 ? (and_2467_s3_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2477;
  assign select_2477 = select_2470 ? (following_last_shift_q & (~and_2467_s3_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:535
  logic [7:0] select_2479;
  assign select_2479 = select_2470 ? (and_2467_s3_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:607
  logic and_2480;
  assign and_2480 = run_last_shift_q & equal_594;
  // hls/stages/agreement.hpp:616
  logic select_2482;
  assign select_2482 = equal_594 ? (~run_last_shift_q) : equal_595;
  // hls/stages/agreement.hpp:620
  logic equal_2483;
  assign equal_2483 = run_phase_q == 3'h1;
  logic not_2486;
  assign not_2486 = ~select_2482;
  // hls/stages/agreement.hpp:623
  logic equal_2488;
  assign equal_2488 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2489;
  assign and_2489 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2490;
  assign select_2490 = equal_2488 ? 2'h1 : {2{and_2489}};
  logic [2:0] select_2492;
  assign select_2492 = (and_2480 | (select_2482 | equal_2483)) ? (equal_2483 ? 3'h2 : {not_2486, {2{select_2482}}}) : (equal_579 ? 3'h6 : {select_2490[0], select_2490});
  // hls/stages/agreement.hpp:607
  logic and_2495;
  assign and_2495 = select_2482 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2498;
  assign select_2498 = (plan_shift_q[5] & select_2482) ? value : 7'h0;
  logic [1:0] or_2499;
  assign or_2499 = {2{so}} | select_2498[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2503;
  assign or_2503 = (select_2482 ? plan_columns_q : 8'h0) | ((equal_2483 | equal_2488) ? whole_q : 8'h0);
  logic [1:0] or_2504;
  assign or_2504 = {2{and_2480}} | or_2503[4:3];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2506;
  assign or_2506 = {or_2503[7:5], or_2504, or_2503[2:0]} | (equal_579 ? drawn_q : 8'h0);
  logic [4:0] or_2507;
  assign or_2507 = {5{so}} | {or_2506[6], or_2506[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2511;
  assign not_2511 = ~run_shift_q[5];
  logic [7:0] select_2514;
  assign select_2514 = equal_594 ? ({{7{not_2511}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2518;
  assign select_2518 = and_2467_s3_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2520;
  assign select_2520 = select_2470 ? {select_2518[6], select_2518} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2523;
  assign select_2523 = select_2470 ? (and_2467_s3_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:460
  logic [6:0] select_2530;
  assign select_2530 = equal_2466_s3_q ? ((6'he < last_s3_q[6:1]) ? 7'h1d : last_s3_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2532;
  assign sum_2532 = {1'b0, last_s3_q[6:3]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2534;
  assign select_2534 = and_550_s3_q ? (equal_2466_s3_q ? {sum_2532, last_s3_q[2:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_2535;
  assign sum_2535 = {1'b0, last_s3_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2537;
  assign select_2537 = and_550_s3_q ? (equal_2466_s3_q ? {sum_2535, last_s3_q[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2551;
  assign select_2551 = (ends_cell_q | select_2470) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_594 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2555;
  assign and_2555 = (~select_2470) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:520
  logic select_2559;
  assign select_2559 = and_550_s3_q ? (equal_2466_s3_q ? equal_2557_s3_q : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2934;
  assign select_2934 = row_starts_s3_q ? (sample_pair_first_s3_q ? phase : patches_phase_q) : patches_phase_q;

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
      run_shift_q <= select_2474;
      run_last_shift_q <= select_2477;
      run_span_q <= select_2479;
      following_phase_q <= select_2492;
      following_shift_q <= select_2482 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2495;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2498[6], or_2499, select_2498[3:0]};
      following_columns_q <= {or_2506[7], or_2507[4], or_2506[5:4], or_2507[3:0]};
      plan_shift_q <= equal_594 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2514;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2520;
      columns_left_q <= select_2523;
      last_q <= and_550_s3_q ? (equal_2466_s3_q ? last_s3_q : last_q) : last_q;
      least_q <= and_550_s3_q ? select_2530 : least_q;
      whole_q <= select_2534;
      drawn_q <= select_2537;
      slot_q <= select_2470 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2551;
      ends_q <= and_2555;
      final_row_q <= select_2559;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= sample_pair_whole_s3_q ? select_2934 : patches_phase_q;
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
  logic [3:0] select_509_s4_q;
  logic equal_510_s4_q;
  logic row_starts_s4_q;
  logic [8:0] select_514_s4_q;
  logic and_523_s4_q;
  logic equal_529_s4_q;
  logic [6:0] select_544_s4_q;
  logic [6:0] last_s4_2_q;
  logic and_548_s4_q;
  logic and_550_s4_q;
  logic equal_575_s4_q;
  logic so_s4_q;
  logic equal_579_s4_q;
  logic [7:0] sum_581_s4_q;
  logic equal_594_s4_q;
  logic equal_595_s4_q;
  logic [7:0] sum_612_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1679_s4_q;
  logic equal_2466_s4_q;
  logic and_2467_s4_q;
  logic select_2470_s4_q;
  logic [3:0] phase_s4_q;
  logic not_2999_s4_q;
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
      select_509_s4_q <= select_509_s3_q;
      equal_510_s4_q <= equal_510_s3_q;
      row_starts_s4_q <= row_starts_s3_q;
      select_514_s4_q <= select_514_s3_q;
      and_523_s4_q <= and_523_s3_q;
      equal_529_s4_q <= equal_529_s3_q;
      select_544_s4_q <= select_544_s3_q;
      last_s4_2_q <= last_s3_q;
      and_548_s4_q <= and_548_s3_q;
      and_550_s4_q <= and_550_s3_q;
      equal_575_s4_q <= run_phase_q == 3'h7;
      so_s4_q <= so;
      equal_579_s4_q <= equal_579;
      sum_581_s4_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      equal_594_s4_q <= equal_594;
      equal_595_s4_q <= equal_595;
      sum_612_s4_q <= {1'b0, last_q} + 8'h3;
      row_s4_q <= row_s3_q;
      equal_1679_s4_q <= equal_1679_s3_q;
      equal_2466_s4_q <= equal_2466_s3_q;
      and_2467_s4_q <= and_2467_s3_q;
      select_2470_s4_q <= select_2470;
      phase_s4_q <= phase;
      not_2999_s4_q <= not_2999_s3_q;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_582;
  assign select_582 = run_shift_s4_q[5] ? x_s4_q : sum_581_s4_q;
  logic less_583;
  assign less_583 = {1'b0, last_s4_q} < select_582;
  // hls/stages/agreement.hpp:226
  logic not_584;
  assign not_584 = ~less_583;
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_s4_q + 8'hfd;
  // hls/stages/agreement.hpp:528
  logic [6:0] select_2539;
  assign select_2539 = select_2470_s4_q ? 7'h0 : (ends_cell_s4_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s4_en) begin
      age_q <= select_2539;
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
  logic [3:0] select_509_s5_q;
  logic equal_510_s5_q;
  logic row_starts_s5_q;
  logic [8:0] select_514_s5_q;
  logic and_523_s5_q;
  logic equal_529_s5_q;
  logic [6:0] select_544_s5_q;
  logic [6:0] last_s5_2_q;
  logic and_548_s5_q;
  logic and_550_s5_q;
  logic equal_575_s5_q;
  logic so_s5_q;
  logic equal_579_s5_q;
  logic [6:0] sum_581_s5_q;
  logic less_583_s5_q;
  logic not_584_s5_q;
  logic equal_594_s5_q;
  logic and_596_s5_q;
  logic [6:0] x_s5_2_q;
  logic and_616_s5_q;
  logic [6:0] row_s5_q;
  logic equal_1563_s5_q;
  logic equal_1679_s5_q;
  logic equal_2466_s5_q;
  logic and_2467_s5_q;
  logic [3:0] phase_s5_q;
  logic equal_2954_s5_q;
  logic [3:0] select_2957_s5_q;
  logic not_2999_s5_q;
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
      select_509_s5_q <= select_509_s4_q;
      equal_510_s5_q <= equal_510_s4_q;
      row_starts_s5_q <= row_starts_s4_q;
      select_514_s5_q <= select_514_s4_q;
      and_523_s5_q <= and_523_s4_q;
      equal_529_s5_q <= equal_529_s4_q;
      select_544_s5_q <= select_544_s4_q;
      last_s5_2_q <= last_s4_2_q;
      and_548_s5_q <= and_548_s4_q;
      and_550_s5_q <= and_550_s4_q;
      equal_575_s5_q <= equal_575_s4_q;
      so_s5_q <= so_s4_q;
      equal_579_s5_q <= equal_579_s4_q;
      sum_581_s5_q <= sum_581_s4_q[6:0];
      less_583_s5_q <= less_583;
      not_584_s5_q <= not_584;
      equal_594_s5_q <= equal_594_s4_q;
      and_596_s5_q <= equal_595_s4_q & not_584;
      x_s5_2_q <= x[6:0];
      and_616_s5_q <= age_q[2] & (ends_cell_s4_q & (~(sum_612_s4_q < select_582)));
      row_s5_q <= row_s4_q;
      equal_1563_s5_q <= {x[7], last_s4_q} == {1'b0, x[6:0]};
      equal_1679_s5_q <= equal_1679_s4_q;
      equal_2466_s5_q <= equal_2466_s4_q;
      and_2467_s5_q <= and_2467_s4_q;
      phase_s5_q <= phase_s4_q;
      equal_2954_s5_q <= row_s4_q == 7'h3;
      select_2957_s5_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_2999_s5_q <= not_2999_s4_q;
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:594
  logic or_580;
  assign or_580 = so_s5_q | equal_579_s5_q;
  // hls/stages/agreement.hpp:149
  logic select_598;
  assign select_598 = or_580 ? not_584_s5_q : (equal_594_s5_q ? not_584_s5_q : and_596_s5_q);
  logic and_617;
  assign and_617 = equal_594_s5_q & and_616_s5_q;
  logic select_618;
  assign select_618 = or_580 ? not_584_s5_q : and_617;
  // hls/stages/agreement.hpp:821
  logic [6:0] right;
  assign right = sum_581_s5_q + 7'h7d;
  // hls/stages/agreement.hpp:149
  logic [6:0] select_642;
  assign select_642 = or_580 ? x_s5_q[6:0] : (equal_594_s5_q ? sum_581_s5_q : x_s5_q[6:0]);
  // hls/stages/agreement.hpp:720
  logic not_648;
  assign not_648 = ~or_580;
  // hls/stages/agreement.hpp:520
  logic and_2824;
  assign and_2824 = and_550_s5_q & (equal_2466_s5_q & (row_s5_q[6:2] == 5'h0));
  // hls/stages/registration.hpp:127
  logic and_2827;
  assign and_2827 = and_2467_s5_q & (~and_2824);
  // hls/stages/patches.hpp:87
  logic [3:0] select_2958;
  assign select_2958 = equal_2954_s5_q ? select_2957_s5_q : patches_choosing_rows_to_next_q;
  logic equal_2959;
  assign equal_2959 = select_2958 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2962;
  assign select_2962 = equal_2466_s5_q ? (equal_2959 ? 4'h2 : (select_2958 + 4'hf)) : patches_choosing_rows_to_next_q;

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
  assign left_re = s5_en & select_598;
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
  assign right_codes_raddr = select_642;
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s5_en & select_598;
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
  assign best_left_raddr = or_580 ? x_s5_q[6:0] : x_s5_2_q;
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s5_en & select_618;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s5_en) begin
      patches_choosing_rows_to_next_q <= and_550_s5_q ? select_2962 : patches_choosing_rows_to_next_q;
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
  logic [3:0] select_509_s6_q;
  logic equal_510_s6_q;
  logic row_starts_s6_q;
  logic [8:0] select_514_s6_q;
  logic and_523_s6_q;
  logic equal_529_s6_q;
  logic [6:0] select_544_s6_q;
  logic [6:0] last_s6_2_q;
  logic and_548_s6_q;
  logic and_550_s6_q;
  logic equal_575_s6_q;
  logic so_s6_q;
  logic equal_579_s6_q;
  logic or_580_s6_q;
  logic less_583_s6_q;
  logic not_584_s6_q;
  logic equal_594_s6_q;
  logic [6:0] x_s6_2_q;
  logic select_618_s6_q;
  logic [6:0] right_s6_q;
  logic and_651_s6_q;
  logic [6:0] row_s6_q;
  logic and_1562_s6_q;
  logic equal_1563_s6_q;
  logic equal_1679_s6_q;
  logic equal_2466_s6_q;
  logic and_2825_s6_q;
  logic [15:0] select_2828_s6_q;
  logic [15:0] select_2831_s6_q;
  logic and_2834_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2954_s6_q;
  logic equal_2959_s6_q;
  logic not_2999_s6_q;
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
      select_509_s6_q <= select_509_s5_q;
      equal_510_s6_q <= equal_510_s5_q;
      row_starts_s6_q <= row_starts_s5_q;
      select_514_s6_q <= select_514_s5_q;
      and_523_s6_q <= and_523_s5_q;
      equal_529_s6_q <= equal_529_s5_q;
      select_544_s6_q <= select_544_s5_q;
      last_s6_2_q <= last_s5_2_q;
      and_548_s6_q <= and_548_s5_q;
      and_550_s6_q <= and_550_s5_q;
      equal_575_s6_q <= equal_575_s5_q;
      so_s6_q <= so_s5_q;
      equal_579_s6_q <= equal_579_s5_q;
      or_580_s6_q <= or_580;
      less_583_s6_q <= less_583_s5_q;
      not_584_s6_q <= not_584_s5_q;
      equal_594_s6_q <= equal_594_s5_q;
      x_s6_2_q <= x_s5_2_q;
      select_618_s6_q <= select_618;
      right_s6_q <= right;
      and_651_s6_q <= not_648 & ((~equal_594_s5_q) & and_596_s5_q);
      row_s6_q <= row_s5_q;
      and_1562_s6_q <= not_648 & and_617;
      equal_1563_s6_q <= equal_1563_s5_q;
      equal_1679_s6_q <= equal_1679_s5_q;
      equal_2466_s6_q <= equal_2466_s5_q;
      and_2825_s6_q <= and_2467_s5_q & and_2824;
      select_2828_s6_q <= and_2827 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
      select_2831_s6_q <= and_2827 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
      and_2834_s6_q <= ends_cell_s5_q & so_s5_q;
      phase_s6_q <= phase_s5_q;
      equal_2954_s6_q <= equal_2954_s5_q;
      equal_2959_s6_q <= equal_2959;
      not_2999_s6_q <= not_2999_s5_q;
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
  logic not_1677;
  assign not_1677 = ~sample_pair_first_s6_q;
  // hls/stages/patches.hpp:315
  logic equal_1681;
  assign equal_1681 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1753;
  assign select_1753 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1990;
  assign sum_1990 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [23:0] sum_2829;
  assign sum_2829 = registration_slope_row_q + {{8{select_2828_s6_q[15]}}, select_2828_s6_q};
  // hls/stages/registration.hpp:132
  logic [23:0] select_2830;
  assign select_2830 = and_2825_s6_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : sum_2829;
  // hls/stages/registration.hpp:130
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2831_s6_q[15]}}, select_2831_s6_q};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2833;
  assign select_2833 = and_2825_s6_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2834_s6_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:377
  logic and_2936;
  assign and_2936 = not_1677 & equal_1679_s6_q;
  logic [8:0] select_2937;
  assign select_2937 = and_2936 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s6_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2938;
  assign select_2938 = and_2936 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2939;
  assign select_2939 = sample_pair_first_s6_q ? select_2937 : select_2938;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2940;
  assign select_2940 = row_starts_s6_q ? select_2939[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2941;
  assign select_2941 = sample_pair_whole_s6_q ? select_2940 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2943;
  assign select_2943 = sample_pair_whole_s6_q ? (row_starts_s6_q ? select_2939[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2946;
  assign select_2946 = sample_pair_whole_s6_q ? (equal_1681 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2948;
  assign select_2948 = sample_pair_whole_s6_q ? (patches_band_rows_number_q + {4'h0, equal_1681}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_2949;
  assign equal_2949 = phase_s6_q == 4'h0;
  // hls/stages/patches.hpp:335
  logic not_2950;
  assign not_2950 = ~equal_2949;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2952;
  assign select_2952 = sample_pair_whole_s6_q ? (phase_s6_q + {{2{not_2950}}, 1'b1, not_2950}) : patches_first_band_rows_to_next_q;
  logic select_2953;
  assign select_2953 = sample_pair_whole_s6_q ? equal_2949 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2964;
  assign select_2964 = equal_2954_s6_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2966;
  assign select_2966 = equal_2466_s6_q ? (select_2964 + {4'h0, equal_2959_s6_q}) : patches_choosing_number_q;
  logic select_2970;
  assign select_2970 = equal_2466_s6_q ? ((7'h2 < row_s6_q) & equal_2959_s6_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:520
  logic [4:0] select_2973;
  assign select_2973 = and_550_s6_q ? (equal_2466_s6_q ? select_2964 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3824;
  assign select_3824 = so_s6_q ? (and_2834_s6_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3826;
  assign sum_3826 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3827;
  assign select_3827 = sum_1990[5] ? {1'b1, sum_1990[4:0], region_across_rest_q[2:0]} : sum_3826;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3829;
  assign select_3829 = equal_2466_s6_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3832;
  assign select_3832 = equal_2466_s6_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

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
  assign fresh_re = s6_en & and_651_s6_q;
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
      registration_slope_row_q <= select_2830;
      registration_slope_change_q <= select_2833;
      registration_slope_q <= so_s6_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2941;
      patches_band_rows_number_q <= select_2943;
      patches_next_band_rows_to_next_q <= select_2946;
      patches_next_band_number_q <= select_2948;
      patches_first_band_rows_to_next_q <= select_2952;
      patches_first_band_number_q <= select_2953;
      patches_choosing_number_q <= and_550_s6_q ? select_2966 : patches_choosing_number_q;
      patches_chooses_q <= and_550_s6_q ? select_2970 : patches_chooses_q;
      patches_choosing_band_q <= select_2973;
      region_across_rest_q <= select_3824;
      region_across_back_q <= so_s6_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3827;
      columns_begin_rest_q <= and_550_s6_q ? select_3829 : columns_begin_rest_q;
      columns_begin_back_q <= and_550_s6_q ? select_3832 : columns_begin_back_q;
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
  logic [3:0] select_509_s7_q;
  logic equal_510_s7_q;
  logic row_starts_s7_q;
  logic [8:0] select_514_s7_q;
  logic and_523_s7_q;
  logic equal_529_s7_q;
  logic [6:0] select_544_s7_q;
  logic [6:0] last_s7_2_q;
  logic and_548_s7_q;
  logic and_550_s7_q;
  logic equal_575_s7_q;
  logic so_s7_q;
  logic equal_579_s7_q;
  logic or_580_s7_q;
  logic less_583_s7_q;
  logic not_584_s7_q;
  logic equal_594_s7_q;
  logic [84:0] left_rdata_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_618_s7_q;
  logic [61:0] best_left_rdata_s7_q;
  logic [6:0] right_s7_q;
  logic [98:0] right_codes_rdata_s7_q;
  logic and_651_s7_q;
  logic [6:0] row_s7_q;
  logic and_1562_s7_q;
  logic equal_1563_s7_q;
  logic not_1677_s7_q;
  logic or_1683_s7_q;
  logic [16:0] select_1753_s7_q;
  logic sum_1990_s7_q;
  logic equal_2466_s7_q;
  logic not_2999_s7_q;
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
      select_509_s7_q <= select_509_s6_q;
      equal_510_s7_q <= equal_510_s6_q;
      row_starts_s7_q <= row_starts_s6_q;
      select_514_s7_q <= select_514_s6_q;
      and_523_s7_q <= and_523_s6_q;
      equal_529_s7_q <= equal_529_s6_q;
      select_544_s7_q <= select_544_s6_q;
      last_s7_2_q <= last_s6_2_q;
      and_548_s7_q <= and_548_s6_q;
      and_550_s7_q <= and_550_s6_q;
      equal_575_s7_q <= equal_575_s6_q;
      so_s7_q <= so_s6_q;
      equal_579_s7_q <= equal_579_s6_q;
      or_580_s7_q <= or_580_s6_q;
      less_583_s7_q <= less_583_s6_q;
      not_584_s7_q <= not_584_s6_q;
      equal_594_s7_q <= equal_594_s6_q;
      left_rdata_s7_q <= left_rdata_q;
      x_s7_2_q <= x_s6_2_q;
      select_618_s7_q <= select_618_s6_q;
      best_left_rdata_s7_q <= best_left_rdata_q;
      right_s7_q <= right_s6_q;
      right_codes_rdata_s7_q <= right_codes_rdata_q;
      and_651_s7_q <= and_651_s6_q;
      row_s7_q <= row_s6_q;
      and_1562_s7_q <= and_1562_s6_q;
      equal_1563_s7_q <= equal_1563_s6_q;
      not_1677_s7_q <= not_1677;
      or_1683_s7_q <= (~equal_1679_s6_q) | (~equal_1681);
      select_1753_s7_q <= select_1753;
      sum_1990_s7_q <= sum_1990[5];
      equal_2466_s7_q <= equal_2466_s6_q;
      not_2999_s7_q <= not_2999_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
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
  // hls/stages/agreement.hpp:668
  logic equal_569;
  assign equal_569 = row_q == 7'h0;
  // hls/stages/agreement.hpp:975
  logic and_608;
  assign and_608 = (or_580_s7_q & (left_rdata_s7_q[67] & not_584_s7_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s7_q[2] ? best_left_rdata_s7_q[5:0] : best_left_rdata_s7_q[45:40];
  // hls/stages/agreement.hpp:668
  logic not_748;
  assign not_748 = ~equal_569;
  // hls/stages/agreement.hpp:221
  logic and_763;
  assign and_763 = left_rdata_s7_q[48] & not_584_s7_q;
  logic and_764;
  assign and_764 = right_codes_rdata_s7_q[42] & not_584_s7_q;
  logic [11:0] select_765;
  assign select_765 = less_583_s7_q ? 12'h0 : left_rdata_s7_q[47:36];
  logic [11:0] select_766;
  assign select_766 = less_583_s7_q ? 12'h0 : right_codes_rdata_s7_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_770;
  assign select_770 = and_763 ? (and_764 ? (~(select_765 ^ select_766)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_786;
  assign and_786 = left_rdata_s7_q[66] & not_584_s7_q;
  logic and_787;
  assign and_787 = right_codes_rdata_s7_q[57] & not_584_s7_q;
  logic [11:0] select_788;
  assign select_788 = less_583_s7_q ? 12'h0 : left_rdata_s7_q[65:54];
  logic [11:0] select_789;
  assign select_789 = less_583_s7_q ? 12'h0 : right_codes_rdata_s7_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_793;
  assign select_793 = and_786 ? (and_787 ? (~(select_788 ^ select_789)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_803;
  assign and_803 = left_rdata_s7_q[84] & not_584_s7_q;
  logic and_804;
  assign and_804 = right_codes_rdata_s7_q[72] & not_584_s7_q;
  logic [11:0] select_805;
  assign select_805 = less_583_s7_q ? 12'h0 : left_rdata_s7_q[83:72];
  logic [11:0] select_806;
  assign select_806 = less_583_s7_q ? 12'h0 : right_codes_rdata_s7_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_810;
  assign select_810 = and_803 ? (and_804 ? (~(select_805 ^ select_806)) : 12'h0) : 12'h0;
  logic [11:0] select_1018;
  assign select_1018 = (slot_s7_q[0] ? and_804 : and_787) ? (~(select_765 ^ (slot_s7_q[0] ? select_806 : select_789))) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_1035;
  assign and_1035 = right_codes_rdata_s7_q[85] & not_584_s7_q;
  logic [11:0] select_1037;
  assign select_1037 = less_583_s7_q ? 12'h0 : right_codes_rdata_s7_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1041;
  assign select_1041 = (slot_s7_q[0] ? and_1035 : and_804) ? (~(select_788 ^ (slot_s7_q[0] ? select_1037 : select_806))) : 12'h0;
  // hls/stages/agreement.hpp:734
  logic select_1053;
  assign select_1053 = slot_s7_q[0] ? (right_codes_rdata_s7_q[98] & not_584_s7_q) : and_1035;
  logic [11:0] select_1055;
  assign select_1055 = slot_s7_q[0] ? (less_583_s7_q ? 12'h0 : right_codes_rdata_s7_q[97:86]) : select_1037;
  // hls/stages/agreement.hpp:221
  logic and_1264;
  assign and_1264 = right_codes_rdata_s7_q[27] & not_584_s7_q;
  // hls/stages/agreement.hpp:734
  logic select_1265;
  assign select_1265 = slot_s7_q[0] ? (right_codes_rdata_s7_q[12] & not_584_s7_q) : and_1264;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1267;
  assign select_1267 = less_583_s7_q ? 12'h0 : right_codes_rdata_s7_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1268;
  assign select_1268 = slot_s7_q[0] ? (less_583_s7_q ? 12'h0 : right_codes_rdata_s7_q[11:0]) : select_1267;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1292;
  assign select_1292 = (slot_s7_q[0] ? and_1264 : and_764) ? (~(select_788 ^ (slot_s7_q[0] ? select_1267 : select_766))) : 12'h0;
  logic [11:0] select_1307;
  assign select_1307 = (slot_s7_q[0] ? and_764 : and_787) ? (~(select_805 ^ (slot_s7_q[0] ? select_766 : select_789))) : 12'h0;
  // hls/stages/patches.hpp:396
  logic not_1674;
  assign not_1674 = ~patches_begins_q;
  // hls/stages/patches.hpp:366
  logic and_1678;
  assign and_1678 = patches_capturing_q & not_1677_s7_q;
  // hls/stages/patches.hpp:125
  logic and_1686;
  assign and_1686 = (not_1674 & (patches_work_q == 3'h0)) & (~(and_1678 | or_1683_s7_q));
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s7_q[6:1]} < x_s7_q;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_580_s7_q ? (less_583_s7_q ? 6'h0 : best_left_rdata_s7_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1755;
  assign select_1755 = ($signed(10'h0) < $signed(select_1753_s7_q[16:7])) ? 14'h7f : select_1753_s7_q[13:0];
  // hls/stages/patches.hpp:537
  logic equal_1785;
  assign equal_1785 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:509
  logic equal_1787;
  assign equal_1787 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:503
  logic equal_1789;
  assign equal_1789 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1790;
  assign equal_1790 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_1791;
  assign or_1791 = equal_1789 | equal_1790;
  // hls/stages/patches.hpp:464
  logic not_1792;
  assign not_1792 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_1814;
  assign select_1814 = and_1686 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1815;
  assign select_1815 = row_starts_s7_q ? select_1814 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1817;
  assign and_1817 = and_1678 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1821;
  assign select_1821 = row_starts_s7_q ? (and_1686 | (and_1678 & (~and_1817))) : patches_capturing_q;
  // hls/stages/patches.hpp:168
  logic not_1845;
  assign not_1845 = ~equal_1790;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1859;
  assign select_1859 = row_starts_s7_q ? {select_1814[4], select_1814[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2724;
  assign select_2724 = or_580_s7_q ? (less_583_s7_q ? 8'h0 : best_left_rdata_s7_q[32:25]) : 8'h0;
  logic [7:0] select_2726;
  assign select_2726 = or_580_s7_q ? (less_583_s7_q ? 8'h0 : best_left_rdata_s7_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:91
  logic parity_2977;
  assign parity_2977 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2978;
  assign select_2978 = equal_2466_s7_q ? {patches_chance_q[14:0], parity_2977} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s7_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:397
  logic or_3040;
  assign or_3040 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3045;
  assign select_3045 = (patches_second_q | patches_begins_q) ? not_1674 : (patches_ends_q & equal_1785);
  logic and_3046;
  assign and_3046 = equal_1785 & not_1792;
  // hls/stages/patches.hpp:403
  logic and_3047;
  assign and_3047 = not_1845 & and_3046;
  logic [1:0] select_3049;
  assign select_3049 = equal_1787 ? 2'h0 : (equal_1789 ? 2'h3 : {equal_1790, and_3047});
  // hls/stages/patches.hpp:283
  logic equal_3051;
  assign equal_3051 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3052;
  assign not_3052 = ~equal_3051;
  // hls/stages/patches.hpp:283
  logic equal_3053;
  assign equal_3053 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3054;
  assign not_3054 = ~equal_3053;
  // hls/stages/patches.hpp:287
  logic not_3056;
  assign not_3056 = ~(patches_following_q == 3'h2);
  logic and_3059;
  assign and_3059 = (~(patches_following_q == 3'h1)) & not_3056;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3060;
  assign select_3060 = equal_3053 ? 2'h2 : {and_3059, not_3056};
  logic [3:0] select_3061;
  assign select_3061 = equal_3051 ? 4'h2 : {select_3060, {2{not_3054}}};
  // hls/stages/patches.hpp:409
  logic not_3064;
  assign not_3064 = ~or_3040;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3069;
  assign select_3069 = or_3040 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
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
    end else if (s7_en) begin
      row_q <= and_550_s7_q ? (equal_2466_s7_q ? row_s7_q : row_q) : row_q;
      patches_chance_q <= and_550_s7_q ? select_2978 : patches_chance_q;
      patches_capturing_q <= sample_pair_whole_s7_q ? select_1821 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s7_q ? select_1815 : patches_row_q;
      patches_work_q <= or_3040 ? following : patches_work_q;
      patches_second_q <= select_3045;
      patches_following_q <= equal_1785 ? {2'h0, and_3046} : {equal_1787, select_3049};
      patches_following_beats_q <= {select_3061, not_3052};
      patches_begins_q <= sample_pair_whole_s7_q & (row_starts_s7_q & and_1817);
      patches_ends_q <= not_3064 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3069;
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
  logic [3:0] select_509_s8_q;
  logic equal_510_s8_q;
  logic row_starts_s8_q;
  logic [8:0] select_514_s8_q;
  logic and_523_s8_q;
  logic equal_529_s8_q;
  logic [6:0] select_544_s8_q;
  logic [6:0] last_s8_2_q;
  logic and_548_s8_q;
  logic and_550_s8_q;
  logic equal_569_s8_q;
  logic equal_575_s8_q;
  logic so_s8_q;
  logic equal_579_s8_q;
  logic or_580_s8_q;
  logic less_583_s8_q;
  logic not_584_s8_q;
  logic equal_594_s8_q;
  logic [62:0] left_rdata_s8_q;
  logic and_601_s8_q;
  logic and_609_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_618_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic [5:0] shift_s8_q;
  logic [6:0] right_s8_q;
  logic and_640_s8_q;
  logic [77:0] right_codes_rdata_s8_q;
  logic and_645_s8_q;
  logic and_647_s8_q;
  logic and_651_s8_q;
  logic [32:0] fresh_rdata_s8_q;
  logic equal_680_s8_q;
  logic and_749_s8_q;
  logic and_750_s8_q;
  logic and_751_s8_q;
  logic and_752_s8_q;
  logic and_753_s8_q;
  logic and_754_s8_q;
  logic and_755_s8_q;
  logic and_756_s8_q;
  logic and_757_s8_q;
  logic and_758_s8_q;
  logic and_763_s8_q;
  logic [11:0] select_770_s8_q;
  logic and_786_s8_q;
  logic [11:0] select_793_s8_q;
  logic and_803_s8_q;
  logic [11:0] select_810_s8_q;
  logic [11:0] select_1018_s8_q;
  logic [11:0] select_1041_s8_q;
  logic [11:0] select_1058_s8_q;
  logic [11:0] select_1271_s8_q;
  logic [11:0] select_1292_s8_q;
  logic [11:0] select_1307_s8_q;
  logic and_1562_s8_q;
  logic equal_1563_s8_q;
  logic and_1686_s8_q;
  logic right_3_s8_q;
  logic less_1700_s8_q;
  logic [5:0] b_s8_q;
  logic [13:0] select_1755_s8_q;
  logic equal_1785_s8_q;
  logic equal_1787_s8_q;
  logic equal_1789_s8_q;
  logic equal_1790_s8_q;
  logic or_1791_s8_q;
  logic not_1792_s8_q;
  logic and_1794_s8_q;
  logic [4:0] select_1815_s8_q;
  logic select_1821_s8_q;
  logic and_1827_s8_q;
  logic and_1846_s8_q;
  logic [3:0] select_1859_s8_q;
  logic sum_1990_s8_q;
  logic and_2011_s8_q;
  logic and_2128_s8_q;
  logic equal_2277_s8_q;
  logic equal_2466_s8_q;
  logic not_2562_s8_q;
  logic and_2592_s8_q;
  logic [7:0] select_2724_s8_q;
  logic [7:0] select_2726_s8_q;
  logic [5:0] further_s8_q;
  logic not_2999_s8_q;
  logic or_3040_s8_q;
  logic not_3064_s8_q;
  logic less_3812_s8_q;
  logic equal_4031_s8_q;
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
      select_509_s8_q <= select_509_s7_q;
      equal_510_s8_q <= equal_510_s7_q;
      row_starts_s8_q <= row_starts_s7_q;
      select_514_s8_q <= select_514_s7_q;
      and_523_s8_q <= and_523_s7_q;
      equal_529_s8_q <= equal_529_s7_q;
      select_544_s8_q <= select_544_s7_q;
      last_s8_2_q <= last_s7_2_q;
      and_548_s8_q <= and_548_s7_q;
      and_550_s8_q <= and_550_s7_q;
      equal_569_s8_q <= equal_569;
      equal_575_s8_q <= equal_575_s7_q;
      so_s8_q <= so_s7_q;
      equal_579_s8_q <= equal_579_s7_q;
      or_580_s8_q <= or_580_s7_q;
      less_583_s8_q <= less_583_s7_q;
      not_584_s8_q <= not_584_s7_q;
      equal_594_s8_q <= equal_594_s7_q;
      left_rdata_s8_q <= {left_rdata_s7_q[65:49], left_rdata_s7_q[47:31], left_rdata_s7_q[29:13], left_rdata_s7_q[11:0]};
      and_601_s8_q <= or_580_s7_q & (left_rdata_s7_q[70] & not_584_s7_q);
      and_609_s8_q <= (or_580_s7_q & (left_rdata_s7_q[68] & not_584_s7_q)) & and_608;
      x_s8_2_q <= x_s7_2_q;
      select_618_s8_q <= select_618_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_s7_q;
      shift_s8_q <= shift;
      right_s8_q <= right_s7_q;
      and_640_s8_q <= or_580_s7_q & (left_rdata_s7_q[71] & not_584_s7_q);
      right_codes_rdata_s8_q <= {right_codes_rdata_s7_q[84:73], right_codes_rdata_s7_q[71:60], right_codes_rdata_s7_q[56:43], right_codes_rdata_s7_q[41:28], right_codes_rdata_s7_q[26:13], right_codes_rdata_s7_q[11:0]};
      and_645_s8_q <= or_580_s7_q & (right_codes_rdata_s7_q[58] & not_584_s7_q);
      and_647_s8_q <= or_580_s7_q & (right_codes_rdata_s7_q[59] & not_584_s7_q);
      and_651_s8_q <= and_651_s7_q;
      fresh_rdata_s8_q <= fresh_rdata_q;
      equal_680_s8_q <= row_s7_q == 7'h0;
      and_749_s8_q <= left_rdata_s7_q[12] & not_748;
      and_750_s8_q <= left_rdata_s7_q[30] & not_748;
      and_751_s8_q <= left_rdata_s7_q[48] & not_748;
      and_752_s8_q <= left_rdata_s7_q[66] & not_748;
      and_753_s8_q <= right_codes_rdata_s7_q[12] & not_748;
      and_754_s8_q <= right_codes_rdata_s7_q[27] & not_748;
      and_755_s8_q <= right_codes_rdata_s7_q[42] & not_748;
      and_756_s8_q <= right_codes_rdata_s7_q[57] & not_748;
      and_757_s8_q <= right_codes_rdata_s7_q[72] & not_748;
      and_758_s8_q <= right_codes_rdata_s7_q[85] & not_748;
      and_763_s8_q <= and_763;
      select_770_s8_q <= select_770;
      and_786_s8_q <= and_786;
      select_793_s8_q <= select_793;
      and_803_s8_q <= and_803;
      select_810_s8_q <= select_810;
      select_1018_s8_q <= select_1018;
      select_1041_s8_q <= select_1041;
      select_1058_s8_q <= select_1053 ? (~(select_805 ^ select_1055)) : 12'h0;
      select_1271_s8_q <= select_1265 ? (~(select_765 ^ select_1268)) : 12'h0;
      select_1292_s8_q <= select_1292;
      select_1307_s8_q <= select_1307;
      and_1562_s8_q <= and_1562_s7_q;
      equal_1563_s8_q <= equal_1563_s7_q;
      and_1686_s8_q <= and_1686;
      right_3_s8_q <= right_3;
      less_1700_s8_q <= 6'h4 < row_q[6:1];
      b_s8_q <= b;
      select_1755_s8_q <= select_1755;
      equal_1785_s8_q <= equal_1785;
      equal_1787_s8_q <= equal_1787;
      equal_1789_s8_q <= equal_1789;
      equal_1790_s8_q <= equal_1790;
      or_1791_s8_q <= or_1791;
      not_1792_s8_q <= not_1792;
      and_1794_s8_q <= or_1791 & (equal_1790 & not_1792);
      select_1815_s8_q <= select_1815;
      select_1821_s8_q <= select_1821;
      and_1827_s8_q <= or_1791 & (patches_second_q & equal_1790);
      and_1846_s8_q <= not_1845 & or_1791;
      select_1859_s8_q <= select_1859;
      sum_1990_s8_q <= sum_1990_s7_q;
      and_2011_s8_q <= or_580_s7_q & (left_rdata_s7_q[69] & not_584_s7_q);
      and_2128_s8_q <= (7'h6 < row_q) & (~(x_s7_q[7:2] == 6'h0));
      equal_2277_s8_q <= (last_s7_2_q | row_s7_q) == 7'h0;
      equal_2466_s8_q <= equal_2466_s7_q;
      not_2562_s8_q <= ~({row_s7_q, 1'b0} < {sum_2560, cfg_height_i[4]});
      and_2592_s8_q <= not_584_s7_q & and_608;
      select_2724_s8_q <= select_2724;
      select_2726_s8_q <= select_2726;
      further_s8_q <= further;
      not_2999_s8_q <= not_2999_s7_q;
      or_3040_s8_q <= or_3040;
      not_3064_s8_q <= not_3064;
      less_3812_s8_q <= 6'h2 < row_s7_q[6:1];
      equal_4031_s8_q <= row_s7_q[6:3] == 4'h0;
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
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s8_q + {{2{shift_s8_q[5]}}, shift_s8_q};
  // hls/stages/count_bits.hpp:24
  logic parity_776;
  assign parity_776 = ^select_770_s8_q[5:3];
  logic parity_779;
  assign parity_779 = ^select_770_s8_q[8:6];
  logic parity_782;
  assign parity_782 = ^select_770_s8_q[11:3];
  logic parity_796;
  assign parity_796 = ^select_793_s8_q[8:6];
  logic parity_799;
  assign parity_799 = ^select_793_s8_q[11:9];
  logic parity_816;
  assign parity_816 = ^select_810_s8_q[2:0];
  logic parity_819;
  assign parity_819 = ^select_810_s8_q[5:3];
  logic parity_822;
  assign parity_822 = ^select_810_s8_q[8:0];
  logic parity_828;
  assign parity_828 = ^select_810_s8_q[11:9];
  logic parity_831;
  assign parity_831 = ^select_793_s8_q[2:0];
  logic parity_834;
  assign parity_834 = ^{select_810_s8_q[11:9], select_793_s8_q[5:0]};
  logic parity_837;
  assign parity_837 = ^{select_810_s8_q, select_793_s8_q, select_770_s8_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_842;
  assign or_842 = (select_770_s8_q[1:0] == 2'h3) | (select_770_s8_q[2] & (select_770_s8_q[0] | select_770_s8_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_846;
  assign or_846 = (select_793_s8_q[7:6] == 2'h3) | (select_793_s8_q[8] & (select_793_s8_q[6] | select_793_s8_q[7]));
  logic or_850;
  assign or_850 = (select_793_s8_q[10:9] == 2'h3) | (select_793_s8_q[11] & (select_793_s8_q[9] | select_793_s8_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_858;
  assign or_858 = (select_810_s8_q[7:6] == 2'h3) | (select_810_s8_q[8] & (~(select_810_s8_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_862;
  assign or_862 = (select_810_s8_q[1:0] == 2'h3) | (select_810_s8_q[2] & (select_810_s8_q[0] | select_810_s8_q[1]));
  logic or_866;
  assign or_866 = (select_810_s8_q[4:3] == 2'h3) | (select_810_s8_q[5] & (select_810_s8_q[3] | select_810_s8_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_869;
  assign parity_869 = ^{or_866, or_862, or_858};
  // hls/stages/count_bits.hpp:23
  logic or_873;
  assign or_873 = (select_793_s8_q[4:3] == 2'h3) | (select_793_s8_q[5] & (select_793_s8_q[3] | select_793_s8_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_877;
  assign or_877 = (select_810_s8_q[10:9] == 2'h3) | (select_810_s8_q[11] & (select_810_s8_q[9] | select_810_s8_q[10]));
  logic or_881;
  assign or_881 = (select_793_s8_q[1:0] == 2'h3) | (select_793_s8_q[2] & (select_793_s8_q[0] | select_793_s8_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_884;
  assign parity_884 = ^{or_881, or_877, or_873};
  logic parity_887;
  assign parity_887 = ^{or_881, or_877, or_873, or_866, or_862, or_858, or_850, or_846, or_842};
  // hls/stages/count_bits.hpp:25
  logic or_892;
  assign or_892 = (parity_776 & parity_779) | ((^select_770_s8_q[11:9]) & (parity_776 | parity_779));
  logic and_895;
  assign and_895 = (^{select_793_s8_q[11:6], select_770_s8_q[2:0]}) & (parity_822 | parity_834);
  // hls/stages/count_bits.hpp:23
  logic or_903;
  assign or_903 = (select_770_s8_q[10:9] == 2'h3) | (select_770_s8_q[11] & (select_770_s8_q[9] | select_770_s8_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_907;
  assign or_907 = (select_770_s8_q[4:3] == 2'h3) | (select_770_s8_q[5] & (select_770_s8_q[3] | select_770_s8_q[4]));
  logic or_911;
  assign or_911 = (select_770_s8_q[7:6] == 2'h3) | (select_770_s8_q[8] & (select_770_s8_q[6] | select_770_s8_q[7]));
  logic or_918;
  assign or_918 = (parity_796 & parity_799) | ((^select_770_s8_q[2:0]) & (parity_796 | parity_799));
  logic or_922;
  assign or_922 = (parity_816 & parity_819) | ((^select_810_s8_q[8:6]) & (parity_816 | parity_819));
  logic or_926;
  assign or_926 = (parity_828 & parity_831) | ((^select_793_s8_q[5:3]) & (parity_828 | parity_831));
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1019;
  assign select_1019 = and_763_s8_q ? select_1018_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1025;
  assign parity_1025 = ^select_1019[5:3];
  logic parity_1028;
  assign parity_1028 = ^select_1019[8:6];
  logic parity_1031;
  assign parity_1031 = ^select_1019[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1042;
  assign select_1042 = and_786_s8_q ? select_1041_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1045;
  assign parity_1045 = ^select_1042[8:6];
  logic parity_1048;
  assign parity_1048 = ^select_1042[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1059;
  assign select_1059 = and_803_s8_q ? select_1058_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1065;
  assign parity_1065 = ^select_1059[2:0];
  logic parity_1068;
  assign parity_1068 = ^select_1059[5:3];
  logic parity_1071;
  assign parity_1071 = ^select_1059[8:0];
  logic parity_1077;
  assign parity_1077 = ^select_1059[11:9];
  logic parity_1080;
  assign parity_1080 = ^select_1042[2:0];
  logic parity_1083;
  assign parity_1083 = ^{select_1059[11:9], select_1042[5:0]};
  logic parity_1086;
  assign parity_1086 = ^{select_1059, select_1042, select_1019[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1091;
  assign or_1091 = (select_1019[1:0] == 2'h3) | (select_1019[2] & (select_1019[0] | select_1019[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1095;
  assign or_1095 = (select_1042[7:6] == 2'h3) | (select_1042[8] & (select_1042[6] | select_1042[7]));
  logic or_1099;
  assign or_1099 = (select_1042[10:9] == 2'h3) | (select_1042[11] & (select_1042[9] | select_1042[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1107;
  assign or_1107 = (select_1059[7:6] == 2'h3) | (select_1059[8] & (~(select_1059[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1111;
  assign or_1111 = (select_1059[1:0] == 2'h3) | (select_1059[2] & (select_1059[0] | select_1059[1]));
  logic or_1115;
  assign or_1115 = (select_1059[4:3] == 2'h3) | (select_1059[5] & (select_1059[3] | select_1059[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1118;
  assign parity_1118 = ^{or_1115, or_1111, or_1107};
  // hls/stages/count_bits.hpp:23
  logic or_1122;
  assign or_1122 = (select_1042[4:3] == 2'h3) | (select_1042[5] & (select_1042[3] | select_1042[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1126;
  assign or_1126 = (select_1059[10:9] == 2'h3) | (select_1059[11] & (select_1059[9] | select_1059[10]));
  logic or_1130;
  assign or_1130 = (select_1042[1:0] == 2'h3) | (select_1042[2] & (select_1042[0] | select_1042[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1133;
  assign parity_1133 = ^{or_1130, or_1126, or_1122};
  logic parity_1136;
  assign parity_1136 = ^{or_1130, or_1126, or_1122, or_1115, or_1111, or_1107, or_1099, or_1095, or_1091};
  // hls/stages/count_bits.hpp:25
  logic or_1141;
  assign or_1141 = (parity_1025 & parity_1028) | ((^select_1019[11:9]) & (parity_1025 | parity_1028));
  logic and_1144;
  assign and_1144 = (^{select_1042[11:6], select_1019[2:0]}) & (parity_1071 | parity_1083);
  // hls/stages/count_bits.hpp:23
  logic or_1152;
  assign or_1152 = (select_1019[10:9] == 2'h3) | (select_1019[11] & (select_1019[9] | select_1019[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1156;
  assign or_1156 = (select_1019[4:3] == 2'h3) | (select_1019[5] & (select_1019[3] | select_1019[4]));
  logic or_1160;
  assign or_1160 = (select_1019[7:6] == 2'h3) | (select_1019[8] & (select_1019[6] | select_1019[7]));
  logic or_1167;
  assign or_1167 = (parity_1045 & parity_1048) | ((^select_1019[2:0]) & (parity_1045 | parity_1048));
  logic or_1171;
  assign or_1171 = (parity_1065 & parity_1068) | ((^select_1059[8:6]) & (parity_1065 | parity_1068));
  logic or_1175;
  assign or_1175 = (parity_1077 & parity_1080) | ((^select_1042[5:3]) & (parity_1077 | parity_1080));
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1272;
  assign select_1272 = and_763_s8_q ? select_1271_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1278;
  assign parity_1278 = ^select_1272[5:3];
  logic parity_1281;
  assign parity_1281 = ^select_1272[8:6];
  logic parity_1284;
  assign parity_1284 = ^select_1272[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1293;
  assign select_1293 = and_786_s8_q ? select_1292_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1296;
  assign parity_1296 = ^select_1293[8:6];
  logic parity_1299;
  assign parity_1299 = ^select_1293[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1308;
  assign select_1308 = and_803_s8_q ? select_1307_s8_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1314;
  assign parity_1314 = ^select_1308[2:0];
  logic parity_1317;
  assign parity_1317 = ^select_1308[5:3];
  logic parity_1320;
  assign parity_1320 = ^select_1308[8:0];
  logic parity_1326;
  assign parity_1326 = ^select_1308[11:9];
  logic parity_1329;
  assign parity_1329 = ^select_1293[2:0];
  logic parity_1332;
  assign parity_1332 = ^{select_1308[11:9], select_1293[5:0]};
  logic parity_1335;
  assign parity_1335 = ^{select_1308, select_1293, select_1272[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1340;
  assign or_1340 = (select_1272[1:0] == 2'h3) | (select_1272[2] & (select_1272[0] | select_1272[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1344;
  assign or_1344 = (select_1293[7:6] == 2'h3) | (select_1293[8] & (select_1293[6] | select_1293[7]));
  logic or_1348;
  assign or_1348 = (select_1293[10:9] == 2'h3) | (select_1293[11] & (select_1293[9] | select_1293[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1356;
  assign or_1356 = (select_1308[7:6] == 2'h3) | (select_1308[8] & (~(select_1308[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1360;
  assign or_1360 = (select_1308[1:0] == 2'h3) | (select_1308[2] & (select_1308[0] | select_1308[1]));
  logic or_1364;
  assign or_1364 = (select_1308[4:3] == 2'h3) | (select_1308[5] & (select_1308[3] | select_1308[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1367;
  assign parity_1367 = ^{or_1364, or_1360, or_1356};
  // hls/stages/count_bits.hpp:23
  logic or_1371;
  assign or_1371 = (select_1293[4:3] == 2'h3) | (select_1293[5] & (select_1293[3] | select_1293[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1375;
  assign or_1375 = (select_1308[10:9] == 2'h3) | (select_1308[11] & (select_1308[9] | select_1308[10]));
  logic or_1379;
  assign or_1379 = (select_1293[1:0] == 2'h3) | (select_1293[2] & (select_1293[0] | select_1293[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1382;
  assign parity_1382 = ^{or_1379, or_1375, or_1371};
  logic parity_1385;
  assign parity_1385 = ^{or_1379, or_1375, or_1371, or_1364, or_1360, or_1356, or_1348, or_1344, or_1340};
  // hls/stages/count_bits.hpp:25
  logic or_1390;
  assign or_1390 = (parity_1278 & parity_1281) | ((^select_1272[11:9]) & (parity_1278 | parity_1281));
  logic and_1393;
  assign and_1393 = (^{select_1293[11:6], select_1272[2:0]}) & (parity_1320 | parity_1332);
  // hls/stages/count_bits.hpp:23
  logic or_1401;
  assign or_1401 = (select_1272[10:9] == 2'h3) | (select_1272[11] & (select_1272[9] | select_1272[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1405;
  assign or_1405 = (select_1272[4:3] == 2'h3) | (select_1272[5] & (select_1272[3] | select_1272[4]));
  logic or_1409;
  assign or_1409 = (select_1272[7:6] == 2'h3) | (select_1272[8] & (select_1272[6] | select_1272[7]));
  logic or_1416;
  assign or_1416 = (parity_1296 & parity_1299) | ((^select_1272[2:0]) & (parity_1296 | parity_1299));
  logic or_1420;
  assign or_1420 = (parity_1314 & parity_1317) | ((^select_1308[8:6]) & (parity_1314 | parity_1317));
  logic or_1424;
  assign or_1424 = (parity_1326 & parity_1329) | ((^select_1293[5:3]) & (parity_1326 | parity_1329));
  // hls/stages/agreement.hpp:247
  logic or_1583;
  assign or_1583 = (cfg_nearer_below_i & shift_s8_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s8_q)));
  // hls/stages/agreement.hpp:1009
  logic [5:0] sum_1648;
  assign sum_1648 = {1'b0, last_s8_q[6:2]} + 6'h1;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1729;
  assign sum_1729 = {2'h0, x_s8_q} + {{4{b_s8_q[5]}}, b_s8_q};
  // hls/stages/registration.hpp:213
  logic [9:0] select_1756;
  assign select_1756 = b_s8_q[4] ? select_1755_s8_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1761;
  assign sum_1761 = (b_s8_q[0] ? select_1755_s8_q[13:1] : 13'h0) + (b_s8_q[1] ? select_1755_s8_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1762;
  assign select_1762 = b_s8_q[2] ? select_1755_s8_q[11:0] : 12'h0;
  // hls/stages/patches.hpp:516
  logic not_1786;
  assign not_1786 = ~equal_1785_s8_q;
  // hls/stages/patches.hpp:462
  logic not_1788;
  assign not_1788 = ~equal_1787_s8_q;
  logic and_1869;
  assign and_1869 = not_1786 & (or_1791_s8_q & not_1788);
  // hls/stages/patches.hpp:549
  logic less_1963;
  assign less_1963 = patches_step_q[4:0] < 5'h11;
  logic equal_1964;
  assign equal_1964 = patches_step_q[6:5] == 2'h2;
  logic equal_1965;
  assign equal_1965 = patches_step_q[6:5] == 2'h1;
  logic or_1966;
  assign or_1966 = equal_1964 | equal_1965;
  // hls/stages/agreement.hpp:520
  logic select_2564;
  assign select_2564 = and_550_s8_q ? (equal_2466_s8_q ? not_2562_s8_q : lower_half_q) : lower_half_q;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2722;
  assign select_2722 = or_580_s8_q ? (less_583_s8_q ? 8'h0 : best_left_rdata_s8_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2724_s8_q} - {1'b0, select_2726_s8_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2983;
  assign select_2983 = right_3_s8_q ? last_s8_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s8_q} + {1'b0, select_2983};
  // hls/stages/patches.hpp:126
  logic select_3001;
  assign select_3001 = row_starts_s8_q ? (and_1686_s8_q ? not_2999_s8_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:191
  logic [4:0] select_3071;
  assign select_3071 = or_3040_s8_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/agreement.hpp:275
  logic select_3521;
  assign select_3521 = equal_1785_s8_q ? (less_1963 & (equal_1965 & or_1966)) : patches_read_searches_q;

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
  assign patches_right_0_re = s8_en & (not_1786 & (not_1788 & and_1794_s8_q));
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
  assign patches_right_1_re = s8_en & (not_1786 & (not_1788 & and_1827_s8_q));
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
  assign patches_columns_above_re = s8_en & and_1869;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s8_q[6:0];
  logic left_we;
  assign left_we = s8_en & and_651_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_752_s8_q, left_rdata_s8_q[62:46], and_751_s8_q, left_rdata_s8_q[45:29], and_750_s8_q, left_rdata_s8_q[28:12], and_749_s8_q, left_rdata_s8_q[11:0], fresh_rdata_s8_q[30:26], fresh_rdata_s8_q[24], fresh_rdata_s8_q[11:0]};
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
  assign right_codes_we = s8_en & and_651_s8_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_758_s8_q, right_codes_rdata_s8_q[77:66], and_757_s8_q, right_codes_rdata_s8_q[65:54], and_756_s8_q, right_codes_rdata_s8_q[53:40], and_755_s8_q, right_codes_rdata_s8_q[39:26], and_754_s8_q, right_codes_rdata_s8_q[25:12], and_753_s8_q, right_codes_rdata_s8_q[11:0], fresh_rdata_s8_q[32:31], fresh_rdata_s8_q[25], fresh_rdata_s8_q[23:12]};
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
      lower_half_q <= select_2564;
      patches_lower_q <= sample_pair_whole_s8_q ? select_3001 : patches_lower_q;
      patches_code_row_q <= select_3071;
      patches_column_q <= or_3040_s8_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3064_s8_q & (patches_column_q == 5'h1e);
      patches_step_q <= or_3040_s8_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3521;
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
  logic [3:0] select_509_s9_q;
  logic equal_510_s9_q;
  logic row_starts_s9_q;
  logic [8:0] select_514_s9_q;
  logic and_523_s9_q;
  logic equal_529_s9_q;
  logic [6:0] select_544_s9_q;
  logic [6:0] last_s9_q;
  logic and_548_s9_q;
  logic and_550_s9_q;
  logic equal_569_s9_q;
  logic equal_575_s9_q;
  logic so_s9_q;
  logic equal_579_s9_q;
  logic or_580_s9_q;
  logic less_583_s9_q;
  logic not_584_s9_q;
  logic equal_594_s9_q;
  logic and_601_s9_q;
  logic and_609_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_618_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic [6:0] select_627_s9_q;
  logic [6:0] right_s9_q;
  logic and_640_s9_q;
  logic and_645_s9_q;
  logic and_647_s9_q;
  logic equal_680_s9_q;
  logic xor_838_s9_q;
  logic parity_887_s9_q;
  logic and_888_s9_q;
  logic or_892_s9_q;
  logic or_896_s9_q;
  logic or_903_s9_q;
  logic or_907_s9_q;
  logic or_911_s9_q;
  logic or_918_s9_q;
  logic or_922_s9_q;
  logic or_926_s9_q;
  logic and_935_s9_q;
  logic and_937_s9_q;
  logic or_949_s9_q;
  logic or_953_s9_q;
  logic or_957_s9_q;
  logic xor_1087_s9_q;
  logic parity_1102_s9_q;
  logic parity_1136_s9_q;
  logic and_1137_s9_q;
  logic or_1141_s9_q;
  logic or_1145_s9_q;
  logic or_1152_s9_q;
  logic or_1156_s9_q;
  logic or_1160_s9_q;
  logic or_1167_s9_q;
  logic or_1171_s9_q;
  logic or_1175_s9_q;
  logic and_1184_s9_q;
  logic or_1185_s9_q;
  logic or_1198_s9_q;
  logic or_1202_s9_q;
  logic or_1206_s9_q;
  logic xor_1336_s9_q;
  logic parity_1351_s9_q;
  logic parity_1385_s9_q;
  logic and_1386_s9_q;
  logic or_1390_s9_q;
  logic or_1394_s9_q;
  logic or_1401_s9_q;
  logic or_1405_s9_q;
  logic or_1409_s9_q;
  logic or_1416_s9_q;
  logic or_1420_s9_q;
  logic or_1424_s9_q;
  logic and_1433_s9_q;
  logic or_1434_s9_q;
  logic or_1447_s9_q;
  logic or_1451_s9_q;
  logic or_1455_s9_q;
  logic and_1562_s9_q;
  logic equal_1563_s9_q;
  logic or_1583_s9_q;
  logic less_1649_s9_q;
  logic and_1686_s9_q;
  logic right_3_s9_q;
  logic less_1700_s9_q;
  logic [5:0] b_s9_q;
  logic less_1721_s9_q;
  logic not_1725_s9_q;
  logic less_1730_s9_q;
  logic less_1731_s9_q;
  logic select_1756_s9_q;
  logic [8:0] difference_1758_s9_q;
  logic [11:0] sum_1761_s9_q;
  logic select_1762_s9_q;
  logic [10:0] sum_1764_s9_q;
  logic equal_1778_s9_q;
  logic equal_1785_s9_q;
  logic not_1786_s9_q;
  logic equal_1787_s9_q;
  logic not_1788_s9_q;
  logic equal_1789_s9_q;
  logic equal_1790_s9_q;
  logic or_1791_s9_q;
  logic not_1792_s9_q;
  logic [4:0] select_1815_s9_q;
  logic select_1821_s9_q;
  logic and_1848_s9_q;
  logic [3:0] select_1859_s9_q;
  logic and_1869_s9_q;
  logic less_1963_s9_q;
  logic equal_1964_s9_q;
  logic or_1966_s9_q;
  logic sum_1990_s9_q;
  logic and_2011_s9_q;
  logic and_2131_s9_q;
  logic equal_2277_s9_q;
  logic equal_2466_s9_q;
  logic and_2593_s9_q;
  logic equal_2678_s9_q;
  logic [7:0] select_2722_s9_q;
  logic rise_2_s9_q;
  logic [7:0] select_2728_s9_q;
  logic [7:0] xor_2733_s9_q;
  logic less_2759_s9_q;
  logic not_2986_s9_q;
  logic or_3040_s9_q;
  logic not_3064_s9_q;
  logic equal_3556_s9_q;
  logic less_3812_s9_q;
  logic equal_4031_s9_q;
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
      select_509_s9_q <= select_509_s8_q;
      equal_510_s9_q <= equal_510_s8_q;
      row_starts_s9_q <= row_starts_s8_q;
      select_514_s9_q <= select_514_s8_q;
      and_523_s9_q <= and_523_s8_q;
      equal_529_s9_q <= equal_529_s8_q;
      select_544_s9_q <= select_544_s8_q;
      last_s9_q <= last_s8_2_q;
      and_548_s9_q <= and_548_s8_q;
      and_550_s9_q <= and_550_s8_q;
      equal_569_s9_q <= equal_569_s8_q;
      equal_575_s9_q <= equal_575_s8_q;
      so_s9_q <= so_s8_q;
      equal_579_s9_q <= equal_579_s8_q;
      or_580_s9_q <= or_580_s8_q;
      less_583_s9_q <= less_583_s8_q;
      not_584_s9_q <= not_584_s8_q;
      equal_594_s9_q <= equal_594_s8_q;
      and_601_s9_q <= and_601_s8_q;
      and_609_s9_q <= and_609_s8_q;
      x_s9_2_q <= x_s8_2_q;
      select_618_s9_q <= select_618_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_627_s9_q <= ({1'b0, last_s8_q} < found) ? 7'h0 : found[6:0];
      right_s9_q <= right_s8_q;
      and_640_s9_q <= and_640_s8_q;
      and_645_s9_q <= and_645_s8_q;
      and_647_s9_q <= and_647_s8_q;
      equal_680_s9_q <= equal_680_s8_q;
      xor_838_s9_q <= parity_782 ^ parity_837;
      parity_887_s9_q <= parity_887;
      and_888_s9_q <= parity_782 & parity_837;
      or_892_s9_q <= or_892;
      or_896_s9_q <= (parity_822 & parity_834) | and_895;
      or_903_s9_q <= or_903;
      or_907_s9_q <= or_907;
      or_911_s9_q <= or_911;
      or_918_s9_q <= or_918;
      or_922_s9_q <= or_922;
      or_926_s9_q <= or_926;
      and_935_s9_q <= parity_869 & parity_884;
      and_937_s9_q <= (^{or_850, or_846, or_842}) & (parity_869 | parity_884);
      or_949_s9_q <= (or_846 & or_850) | (or_842 & (or_846 | or_850));
      or_953_s9_q <= (or_862 & or_866) | (or_858 & (or_862 | or_866));
      or_957_s9_q <= (or_877 & or_881) | (or_873 & (or_877 | or_881));
      xor_1087_s9_q <= parity_1031 ^ parity_1086;
      parity_1102_s9_q <= ^{or_1099, or_1095, or_1091};
      parity_1136_s9_q <= parity_1136;
      and_1137_s9_q <= parity_1031 & parity_1086;
      or_1141_s9_q <= or_1141;
      or_1145_s9_q <= (parity_1071 & parity_1083) | and_1144;
      or_1152_s9_q <= or_1152;
      or_1156_s9_q <= or_1156;
      or_1160_s9_q <= or_1160;
      or_1167_s9_q <= or_1167;
      or_1171_s9_q <= or_1171;
      or_1175_s9_q <= or_1175;
      and_1184_s9_q <= parity_1118 & parity_1133;
      or_1185_s9_q <= parity_1118 | parity_1133;
      or_1198_s9_q <= (or_1095 & or_1099) | (or_1091 & (or_1095 | or_1099));
      or_1202_s9_q <= (or_1111 & or_1115) | (or_1107 & (or_1111 | or_1115));
      or_1206_s9_q <= (or_1126 & or_1130) | (or_1122 & (or_1126 | or_1130));
      xor_1336_s9_q <= parity_1284 ^ parity_1335;
      parity_1351_s9_q <= ^{or_1348, or_1344, or_1340};
      parity_1385_s9_q <= parity_1385;
      and_1386_s9_q <= parity_1284 & parity_1335;
      or_1390_s9_q <= or_1390;
      or_1394_s9_q <= (parity_1320 & parity_1332) | and_1393;
      or_1401_s9_q <= or_1401;
      or_1405_s9_q <= or_1405;
      or_1409_s9_q <= or_1409;
      or_1416_s9_q <= or_1416;
      or_1420_s9_q <= or_1420;
      or_1424_s9_q <= or_1424;
      and_1433_s9_q <= parity_1367 & parity_1382;
      or_1434_s9_q <= parity_1367 | parity_1382;
      or_1447_s9_q <= (or_1344 & or_1348) | (or_1340 & (or_1344 | or_1348));
      or_1451_s9_q <= (or_1360 & or_1364) | (or_1356 & (or_1360 | or_1364));
      or_1455_s9_q <= (or_1375 & or_1379) | (or_1371 & (or_1375 | or_1379));
      and_1562_s9_q <= and_1562_s8_q;
      equal_1563_s9_q <= equal_1563_s8_q;
      or_1583_s9_q <= or_1583;
      less_1649_s9_q <= {1'b0, sum_1648, last_s8_q[1]} < x_s8_q;
      and_1686_s9_q <= and_1686_s8_q;
      right_3_s9_q <= right_3_s8_q;
      less_1700_s9_q <= less_1700_s8_q;
      b_s9_q <= b_s8_q;
      less_1721_s9_q <= {3'h0, last_s8_q[6:1]} < ({1'b0, x_s8_q} + 9'h1);
      not_1725_s9_q <= ~(x_s8_q < {1'b0, last_s8_q});
      less_1730_s9_q <= $signed(10'h0) < $signed(sum_1729);
      less_1731_s9_q <= $signed(sum_1729) < $signed({3'h0, last_s8_q});
      select_1756_s9_q <= select_1756[0];
      difference_1758_s9_q <= select_1756[9:1] - (b_s8_q[5] ? select_1755_s8_q[8:0] : 9'h0);
      sum_1761_s9_q <= sum_1761[12:1];
      select_1762_s9_q <= select_1762[0];
      sum_1764_s9_q <= select_1762[11:1] + (b_s8_q[3] ? select_1755_s8_q[10:0] : 11'h0);
      equal_1778_s9_q <= x_s8_q == {1'b0, last_s8_q};
      equal_1785_s9_q <= equal_1785_s8_q;
      not_1786_s9_q <= not_1786;
      equal_1787_s9_q <= equal_1787_s8_q;
      not_1788_s9_q <= not_1788;
      equal_1789_s9_q <= equal_1789_s8_q;
      equal_1790_s9_q <= equal_1790_s8_q;
      or_1791_s9_q <= or_1791_s8_q;
      not_1792_s9_q <= not_1792_s8_q;
      select_1815_s9_q <= select_1815_s8_q;
      select_1821_s9_q <= select_1821_s8_q;
      and_1848_s9_q <= not_1786 & (not_1788 & and_1846_s8_q);
      select_1859_s9_q <= select_1859_s8_q;
      and_1869_s9_q <= and_1869;
      less_1963_s9_q <= less_1963;
      equal_1964_s9_q <= equal_1964;
      or_1966_s9_q <= or_1966;
      sum_1990_s9_q <= sum_1990_s8_q;
      and_2011_s9_q <= and_2011_s8_q;
      and_2131_s9_q <= and_2128_s8_q & (~({sum_1648, last_s8_q[1:0]} < x_s8_q));
      equal_2277_s9_q <= equal_2277_s8_q;
      equal_2466_s9_q <= equal_2466_s8_q;
      and_2593_s9_q <= or_580_s8_q & and_2592_s8_q;
      equal_2678_s9_q <= shift_s8_q == 6'h0;
      select_2722_s9_q <= select_2722;
      rise_2_s9_q <= rise_2[8];
      select_2728_s9_q <= rise_2[8] ? select_2724_s8_q : select_2726_s8_q;
      xor_2733_s9_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2759_s9_q <= select_2724_s8_q < select_2726_s8_q;
      not_2986_s9_q <= ~(x_s8_q < {1'b0, from});
      or_3040_s9_q <= or_3040_s8_q;
      not_3064_s9_q <= not_3064_s8_q;
      equal_3556_s9_q <= patches_step_q[6:5] == 2'h3;
      less_3812_s9_q <= less_3812_s8_q;
      equal_4031_s9_q <= equal_4031_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/patches.hpp:106
  logic equal_570;
  assign equal_570 = x_s9_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_569_s9_q & equal_570;
  // hls/stages/count_bits.hpp:24
  logic parity_914;
  assign parity_914 = ^{or_911_s9_q, or_907_s9_q, or_903_s9_q};
  logic parity_929;
  assign parity_929 = ^{or_926_s9_q, or_922_s9_q, or_918_s9_q};
  logic parity_932;
  assign parity_932 = ^{or_926_s9_q, or_922_s9_q, or_918_s9_q, or_911_s9_q, or_907_s9_q, or_903_s9_q, or_896_s9_q, or_892_s9_q, and_888_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_934;
  assign and_934 = parity_887_s9_q & parity_932;
  logic or_938;
  assign or_938 = and_935_s9_q | and_937_s9_q;
  logic and_941;
  assign and_941 = (^{or_896_s9_q, or_892_s9_q, and_888_s9_q}) & (parity_914 | parity_929);
  logic or_942;
  assign or_942 = (parity_914 & parity_929) | and_941;
  // hls/stages/count_bits.hpp:24
  logic parity_960;
  assign parity_960 = ^{or_957_s9_q, or_953_s9_q, or_949_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_964;
  assign or_964 = (or_892_s9_q & or_896_s9_q) | (and_888_s9_q & (or_892_s9_q | or_896_s9_q));
  logic or_968;
  assign or_968 = (or_907_s9_q & or_911_s9_q) | (or_903_s9_q & (or_907_s9_q | or_911_s9_q));
  logic or_972;
  assign or_972 = (or_922_s9_q & or_926_s9_q) | (or_918_s9_q & (or_922_s9_q | or_926_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_975;
  assign parity_975 = ^{or_972, or_968, or_964};
  logic parity_978;
  assign parity_978 = ^{or_972, or_968, or_964, or_957_s9_q, or_953_s9_q, or_949_s9_q, or_942, or_938, and_934};
  // hls/stages/count_bits.hpp:25
  logic or_990;
  assign or_990 = (or_953_s9_q & or_957_s9_q) | (or_949_s9_q & (or_953_s9_q | or_957_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1163;
  assign parity_1163 = ^{or_1160_s9_q, or_1156_s9_q, or_1152_s9_q};
  logic parity_1178;
  assign parity_1178 = ^{or_1175_s9_q, or_1171_s9_q, or_1167_s9_q};
  logic parity_1181;
  assign parity_1181 = ^{or_1175_s9_q, or_1171_s9_q, or_1167_s9_q, or_1160_s9_q, or_1156_s9_q, or_1152_s9_q, or_1145_s9_q, or_1141_s9_q, and_1137_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1183;
  assign and_1183 = parity_1136_s9_q & parity_1181;
  logic or_1187;
  assign or_1187 = and_1184_s9_q | (parity_1102_s9_q & or_1185_s9_q);
  logic and_1190;
  assign and_1190 = (^{or_1145_s9_q, or_1141_s9_q, and_1137_s9_q}) & (parity_1163 | parity_1178);
  logic or_1191;
  assign or_1191 = (parity_1163 & parity_1178) | and_1190;
  // hls/stages/count_bits.hpp:24
  logic parity_1209;
  assign parity_1209 = ^{or_1206_s9_q, or_1202_s9_q, or_1198_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1213;
  assign or_1213 = (or_1141_s9_q & or_1145_s9_q) | (and_1137_s9_q & (or_1141_s9_q | or_1145_s9_q));
  logic or_1217;
  assign or_1217 = (or_1156_s9_q & or_1160_s9_q) | (or_1152_s9_q & (or_1156_s9_q | or_1160_s9_q));
  logic or_1221;
  assign or_1221 = (or_1171_s9_q & or_1175_s9_q) | (or_1167_s9_q & (or_1171_s9_q | or_1175_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1224;
  assign parity_1224 = ^{or_1221, or_1217, or_1213};
  logic parity_1227;
  assign parity_1227 = ^{or_1221, or_1217, or_1213, or_1206_s9_q, or_1202_s9_q, or_1198_s9_q, or_1191, or_1187, and_1183};
  // hls/stages/count_bits.hpp:25
  logic or_1239;
  assign or_1239 = (or_1202_s9_q & or_1206_s9_q) | (or_1198_s9_q & (or_1202_s9_q | or_1206_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1412;
  assign parity_1412 = ^{or_1409_s9_q, or_1405_s9_q, or_1401_s9_q};
  logic parity_1427;
  assign parity_1427 = ^{or_1424_s9_q, or_1420_s9_q, or_1416_s9_q};
  logic parity_1430;
  assign parity_1430 = ^{or_1424_s9_q, or_1420_s9_q, or_1416_s9_q, or_1409_s9_q, or_1405_s9_q, or_1401_s9_q, or_1394_s9_q, or_1390_s9_q, and_1386_s9_q};
  // hls/stages/count_bits.hpp:25
  logic and_1432;
  assign and_1432 = parity_1385_s9_q & parity_1430;
  logic or_1436;
  assign or_1436 = and_1433_s9_q | (parity_1351_s9_q & or_1434_s9_q);
  logic and_1439;
  assign and_1439 = (^{or_1394_s9_q, or_1390_s9_q, and_1386_s9_q}) & (parity_1412 | parity_1427);
  logic or_1440;
  assign or_1440 = (parity_1412 & parity_1427) | and_1439;
  // hls/stages/count_bits.hpp:24
  logic parity_1458;
  assign parity_1458 = ^{or_1455_s9_q, or_1451_s9_q, or_1447_s9_q};
  // hls/stages/count_bits.hpp:25
  logic or_1462;
  assign or_1462 = (or_1390_s9_q & or_1394_s9_q) | (and_1386_s9_q & (or_1390_s9_q | or_1394_s9_q));
  logic or_1466;
  assign or_1466 = (or_1405_s9_q & or_1409_s9_q) | (or_1401_s9_q & (or_1405_s9_q | or_1409_s9_q));
  logic or_1470;
  assign or_1470 = (or_1420_s9_q & or_1424_s9_q) | (or_1416_s9_q & (or_1420_s9_q | or_1424_s9_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1473;
  assign parity_1473 = ^{or_1470, or_1466, or_1462};
  logic parity_1476;
  assign parity_1476 = ^{or_1470, or_1466, or_1462, or_1455_s9_q, or_1451_s9_q, or_1447_s9_q, or_1440, or_1436, and_1432};
  // hls/stages/count_bits.hpp:25
  logic or_1488;
  assign or_1488 = (or_1451_s9_q & or_1455_s9_q) | (or_1447_s9_q & (or_1451_s9_q | or_1455_s9_q));
  // hls/stages/patches.hpp:104
  logic and_1723;
  assign and_1723 = less_1721_s9_q & (~right_3_s9_q);
  // hls/stages/agreement.hpp:1018
  logic and_1733;
  assign and_1733 = (~(and_1723 | (equal_570 | not_1725_s9_q))) & (less_1730_s9_q & less_1731_s9_q);
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1765;
  assign sum_1765 = sum_1761_s9_q + {sum_1764_s9_q, select_1762_s9_q};
  logic [9:0] sum_1766;
  assign sum_1766 = {difference_1758_s9_q, select_1756_s9_q} + sum_1765[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2722_s9_q} - {1'b0, select_2728_s9_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s9_q} + {1'b0, xor_2733_s9_q};

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1376; read in stage 9, written in stage 16: 9 < 16 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_580_s9_q ? select_627_s9_q : right_s9_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s9_en & select_618_s9_q;
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
  assign patches_left_re = s9_en & and_1848_s9_q;
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
  assign patches_rows_re = s9_en & (equal_1785_s9_q & (less_1963_s9_q & or_1966_s9_q));
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
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
  logic [3:0] select_509_s10_q;
  logic equal_510_s10_q;
  logic row_starts_s10_q;
  logic [8:0] select_514_s10_q;
  logic and_523_s10_q;
  logic equal_529_s10_q;
  logic [6:0] select_544_s10_q;
  logic [6:0] last_s10_q;
  logic and_548_s10_q;
  logic and_550_s10_q;
  logic equal_570_s10_q;
  logic first_s10_q;
  logic equal_575_s10_q;
  logic so_s10_q;
  logic equal_579_s10_q;
  logic or_580_s10_q;
  logic less_583_s10_q;
  logic not_584_s10_q;
  logic equal_594_s10_q;
  logic and_601_s10_q;
  logic and_609_s10_q;
  logic [6:0] x_s10_2_q;
  logic [61:0] best_left_rdata_s10_q;
  logic [6:0] select_627_s10_q;
  logic [6:0] right_s10_q;
  logic and_640_s10_q;
  logic and_645_s10_q;
  logic and_647_s10_q;
  logic equal_680_s10_q;
  logic xor_838_s10_q;
  logic xor_933_s10_q;
  logic parity_978_s10_q;
  logic and_979_s10_q;
  logic and_981_s10_q;
  logic and_983_s10_q;
  logic and_985_s10_q;
  logic or_990_s10_q;
  logic or_994_s10_q;
  logic xor_1087_s10_q;
  logic xor_1182_s10_q;
  logic parity_1227_s10_q;
  logic and_1228_s10_q;
  logic and_1230_s10_q;
  logic and_1232_s10_q;
  logic and_1234_s10_q;
  logic or_1239_s10_q;
  logic or_1243_s10_q;
  logic xor_1336_s10_q;
  logic xor_1431_s10_q;
  logic parity_1476_s10_q;
  logic and_1477_s10_q;
  logic and_1479_s10_q;
  logic and_1481_s10_q;
  logic and_1483_s10_q;
  logic or_1488_s10_q;
  logic or_1492_s10_q;
  logic and_1562_s10_q;
  logic equal_1563_s10_q;
  logic or_1583_s10_q;
  logic less_1649_s10_q;
  logic and_1686_s10_q;
  logic right_3_s10_q;
  logic less_1700_s10_q;
  logic [5:0] b_s10_q;
  logic and_1733_s10_q;
  logic [7:0] sum_1766_s10_q;
  logic equal_1778_s10_q;
  logic or_1779_s10_q;
  logic equal_1785_s10_q;
  logic not_1786_s10_q;
  logic equal_1787_s10_q;
  logic not_1788_s10_q;
  logic equal_1789_s10_q;
  logic equal_1790_s10_q;
  logic or_1791_s10_q;
  logic not_1792_s10_q;
  logic [7:0] patches_right_0_rdata_s10_q;
  logic [4:0] select_1815_s10_q;
  logic select_1821_s10_q;
  logic [7:0] patches_right_1_rdata_s10_q;
  logic [3:0] select_1859_s10_q;
  logic and_1869_s10_q;
  logic [31:0] patches_columns_above_rdata_s10_q;
  logic less_1963_s10_q;
  logic equal_1964_s10_q;
  logic or_1966_s10_q;
  logic sum_1990_s10_q;
  logic and_2011_s10_q;
  logic and_2133_s10_q;
  logic equal_2277_s10_q;
  logic equal_2466_s10_q;
  logic and_2593_s10_q;
  logic equal_2678_s10_q;
  logic [7:0] wide_s10_q;
  logic [8:0] size_3_s10_q;
  logic less_2759_s10_q;
  logic not_2986_s10_q;
  logic or_3040_s10_q;
  logic not_3064_s10_q;
  logic equal_3556_s10_q;
  logic less_3812_s10_q;
  logic equal_4031_s10_q;
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
      select_509_s10_q <= select_509_s9_q;
      equal_510_s10_q <= equal_510_s9_q;
      row_starts_s10_q <= row_starts_s9_q;
      select_514_s10_q <= select_514_s9_q;
      and_523_s10_q <= and_523_s9_q;
      equal_529_s10_q <= equal_529_s9_q;
      select_544_s10_q <= select_544_s9_q;
      last_s10_q <= last_s9_q;
      and_548_s10_q <= and_548_s9_q;
      and_550_s10_q <= and_550_s9_q;
      equal_570_s10_q <= equal_570;
      first_s10_q <= first;
      equal_575_s10_q <= equal_575_s9_q;
      so_s10_q <= so_s9_q;
      equal_579_s10_q <= equal_579_s9_q;
      or_580_s10_q <= or_580_s9_q;
      less_583_s10_q <= less_583_s9_q;
      not_584_s10_q <= not_584_s9_q;
      equal_594_s10_q <= equal_594_s9_q;
      and_601_s10_q <= and_601_s9_q;
      and_609_s10_q <= and_609_s9_q;
      x_s10_2_q <= x_s9_2_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_627_s10_q <= select_627_s9_q;
      right_s10_q <= right_s9_q;
      and_640_s10_q <= and_640_s9_q;
      and_645_s10_q <= and_645_s9_q;
      and_647_s10_q <= and_647_s9_q;
      equal_680_s10_q <= equal_680_s9_q;
      xor_838_s10_q <= xor_838_s9_q;
      xor_933_s10_q <= parity_887_s9_q ^ parity_932;
      parity_978_s10_q <= parity_978;
      and_979_s10_q <= parity_960 & parity_975;
      and_981_s10_q <= (^{or_942, or_938, and_934}) & (parity_960 | parity_975);
      and_983_s10_q <= or_938 & or_942;
      and_985_s10_q <= and_934 & (or_938 | or_942);
      or_990_s10_q <= or_990;
      or_994_s10_q <= (or_968 & or_972) | (or_964 & (or_968 | or_972));
      xor_1087_s10_q <= xor_1087_s9_q;
      xor_1182_s10_q <= parity_1136_s9_q ^ parity_1181;
      parity_1227_s10_q <= parity_1227;
      and_1228_s10_q <= parity_1209 & parity_1224;
      and_1230_s10_q <= (^{or_1191, or_1187, and_1183}) & (parity_1209 | parity_1224);
      and_1232_s10_q <= or_1187 & or_1191;
      and_1234_s10_q <= and_1183 & (or_1187 | or_1191);
      or_1239_s10_q <= or_1239;
      or_1243_s10_q <= (or_1217 & or_1221) | (or_1213 & (or_1217 | or_1221));
      xor_1336_s10_q <= xor_1336_s9_q;
      xor_1431_s10_q <= parity_1385_s9_q ^ parity_1430;
      parity_1476_s10_q <= parity_1476;
      and_1477_s10_q <= parity_1458 & parity_1473;
      and_1479_s10_q <= (^{or_1440, or_1436, and_1432}) & (parity_1458 | parity_1473);
      and_1481_s10_q <= or_1436 & or_1440;
      and_1483_s10_q <= and_1432 & (or_1436 | or_1440);
      or_1488_s10_q <= or_1488;
      or_1492_s10_q <= (or_1466 & or_1470) | (or_1462 & (or_1466 | or_1470));
      and_1562_s10_q <= and_1562_s9_q;
      equal_1563_s10_q <= equal_1563_s9_q;
      or_1583_s10_q <= or_1583_s9_q;
      less_1649_s10_q <= less_1649_s9_q;
      and_1686_s10_q <= and_1686_s9_q;
      right_3_s10_q <= right_3_s9_q;
      less_1700_s10_q <= less_1700_s9_q;
      b_s10_q <= b_s9_q;
      and_1733_s10_q <= and_1733;
      sum_1766_s10_q <= sum_1766[9:2];
      equal_1778_s10_q <= equal_1778_s9_q;
      or_1779_s10_q <= and_1723 | equal_1778_s9_q;
      equal_1785_s10_q <= equal_1785_s9_q;
      not_1786_s10_q <= not_1786_s9_q;
      equal_1787_s10_q <= equal_1787_s9_q;
      not_1788_s10_q <= not_1788_s9_q;
      equal_1789_s10_q <= equal_1789_s9_q;
      equal_1790_s10_q <= equal_1790_s9_q;
      or_1791_s10_q <= or_1791_s9_q;
      not_1792_s10_q <= not_1792_s9_q;
      patches_right_0_rdata_s10_q <= patches_right_0_rdata_q;
      select_1815_s10_q <= select_1815_s9_q;
      select_1821_s10_q <= select_1821_s9_q;
      patches_right_1_rdata_s10_q <= patches_right_1_rdata_q;
      select_1859_s10_q <= select_1859_s9_q;
      and_1869_s10_q <= and_1869_s9_q;
      patches_columns_above_rdata_s10_q <= patches_columns_above_rdata_q;
      less_1963_s10_q <= less_1963_s9_q;
      equal_1964_s10_q <= equal_1964_s9_q;
      or_1966_s10_q <= or_1966_s9_q;
      sum_1990_s10_q <= sum_1990_s9_q;
      and_2011_s10_q <= and_2011_s9_q;
      and_2133_s10_q <= so_s9_q & (ends_cell_s9_q & and_2131_s9_q);
      equal_2277_s10_q <= equal_2277_s9_q;
      equal_2466_s10_q <= equal_2466_s9_q;
      and_2593_s10_q <= and_2593_s9_q;
      equal_2678_s10_q <= equal_2678_s9_q;
      wide_s10_q <= wide;
      size_3_s10_q <= size_3;
      less_2759_s10_q <= less_2759_s9_q;
      not_2986_s10_q <= not_2986_s9_q;
      or_3040_s10_q <= or_3040_s9_q;
      not_3064_s10_q <= not_3064_s9_q;
      equal_3556_s10_q <= equal_3556_s9_q;
      less_3812_s10_q <= less_3812_s9_q;
      equal_4031_s10_q <= equal_4031_s9_q;
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
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_580_s10_q & not_584_s10_q;
  // hls/stages/count_bits.hpp:25
  logic or_982;
  assign or_982 = and_979_s10_q | and_981_s10_q;
  logic or_986;
  assign or_986 = and_983_s10_q | and_985_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_999;
  assign parity_999 = ^{or_994_s10_q, or_990_s10_q, or_986, or_982};
  // hls/stages/count_bits.hpp:25
  logic or_1003;
  assign or_1003 = (or_990_s10_q & or_994_s10_q) | (or_986 & (or_990_s10_q | or_994_s10_q));
  logic and_1004;
  assign and_1004 = or_982 & (^{or_994_s10_q, or_990_s10_q, or_986});
  // hls/stages/count_bits.hpp:24
  logic xor_1005;
  assign xor_1005 = or_1003 ^ and_1004;
  // hls/stages/count_bits.hpp:27
  logic and_1006;
  assign and_1006 = or_1003 & and_1004;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1007;
  assign select_1007 = equal_594_s10_q ? {and_1006, xor_1005, parity_999, parity_978_s10_q, xor_933_s10_q, xor_838_s10_q} : 6'h0;
  logic [5:0] column;
  assign column = or_580_s10_q ? 6'h0 : select_1007;
  // hls/stages/count_bits.hpp:25
  logic or_1231;
  assign or_1231 = and_1228_s10_q | and_1230_s10_q;
  logic or_1235;
  assign or_1235 = and_1232_s10_q | and_1234_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1248;
  assign parity_1248 = ^{or_1243_s10_q, or_1239_s10_q, or_1235, or_1231};
  // hls/stages/count_bits.hpp:25
  logic or_1252;
  assign or_1252 = (or_1239_s10_q & or_1243_s10_q) | (or_1235 & (or_1239_s10_q | or_1243_s10_q));
  logic and_1253;
  assign and_1253 = or_1231 & (^{or_1243_s10_q, or_1239_s10_q, or_1235});
  // hls/stages/count_bits.hpp:24
  logic xor_1254;
  assign xor_1254 = or_1252 ^ and_1253;
  // hls/stages/count_bits.hpp:27
  logic and_1255;
  assign and_1255 = or_1252 & and_1253;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1256;
  assign select_1256 = equal_594_s10_q ? {and_1255, xor_1254, parity_1248, parity_1227_s10_q, xor_1182_s10_q, xor_1087_s10_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_580_s10_q ? 6'h0 : select_1256;
  // hls/stages/count_bits.hpp:25
  logic or_1480;
  assign or_1480 = and_1477_s10_q | and_1479_s10_q;
  logic or_1484;
  assign or_1484 = and_1481_s10_q | and_1483_s10_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1497;
  assign parity_1497 = ^{or_1492_s10_q, or_1488_s10_q, or_1484, or_1480};
  // hls/stages/count_bits.hpp:25
  logic or_1501;
  assign or_1501 = (or_1488_s10_q & or_1492_s10_q) | (or_1484 & (or_1488_s10_q | or_1492_s10_q));
  logic and_1502;
  assign and_1502 = or_1480 & (^{or_1492_s10_q, or_1488_s10_q, or_1484});
  // hls/stages/count_bits.hpp:24
  logic xor_1503;
  assign xor_1503 = or_1501 ^ and_1502;
  // hls/stages/count_bits.hpp:27
  logic and_1504;
  assign and_1504 = or_1501 & and_1502;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1505;
  assign select_1505 = equal_594_s10_q ? {and_1504, xor_1503, parity_1497, parity_1476_s10_q, xor_1431_s10_q, xor_1336_s10_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_580_s10_q ? 6'h0 : select_1505;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s10_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1541;
  assign sum_1541 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s10_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1544;
  assign sum_1544 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v & less_1649_s10_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1767;
  assign sum_1767 = {registration_slope_s10_q[11], registration_slope_s10_q} + {{5{sum_1766_s10_q[7]}}, sum_1766_s10_q};
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_1790_s10_q ? (patches_second_s10_q ? 8'h0 : patches_right_0_rdata_s10_q) : 8'h0;
  // hls/stages/patches.hpp:471
  logic [8:0] sum_1916;
  assign sum_1916 = {1'b0, patches_columns_above_rdata_s10_q[23:16]} + {3'h0, patches_columns_above_rdata_s10_q[31:26]};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2736;
  assign select_2736 = ({wide_s10_q, 1'b0} < size_3_s10_q) ? {wide_s10_q, 1'b0} : size_3_s10_q;
  logic [8:0] taken;
  assign taken = ~select_2736;

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
  logic [3:0] select_509_s11_q;
  logic equal_510_s11_q;
  logic row_starts_s11_q;
  logic [8:0] select_514_s11_q;
  logic and_523_s11_q;
  logic equal_529_s11_q;
  logic [6:0] select_544_s11_q;
  logic [6:0] last_s11_q;
  logic and_548_s11_q;
  logic and_550_s11_q;
  logic equal_570_s11_q;
  logic first_s11_q;
  logic equal_575_s11_q;
  logic so_s11_q;
  logic equal_579_s11_q;
  logic or_580_s11_q;
  logic less_583_s11_q;
  logic not_584_s11_q;
  logic inside_v_s11_q;
  logic and_601_s11_q;
  logic and_609_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic [6:0] select_627_s11_q;
  logic [6:0] right_s11_q;
  logic [28:0] best_right_rdata_s11_q;
  logic and_640_s11_q;
  logic and_645_s11_q;
  logic and_647_s11_q;
  logic equal_680_s11_q;
  logic [5:0] column_s11_q;
  logic [5:0] select_1258_s11_q;
  logic [5:0] select_1507_s11_q;
  logic [6:0] sum_1542_s11_q;
  logic [6:0] sum_1545_s11_q;
  logic and_1562_s11_q;
  logic equal_1563_s11_q;
  logic or_1583_s11_q;
  logic right_2_s11_q;
  logic and_1686_s11_q;
  logic and_1698_s11_q;
  logic less_1700_s11_q;
  logic [5:0] b_s11_q;
  logic and_1733_s11_q;
  logic [7:0] sum_1767_s11_q;
  logic less_1768_s11_q;
  logic less_1769_s11_q;
  logic equal_1778_s11_q;
  logic and_1782_s11_q;
  logic equal_1785_s11_q;
  logic not_1786_s11_q;
  logic equal_1787_s11_q;
  logic not_1788_s11_q;
  logic equal_1789_s11_q;
  logic equal_1790_s11_q;
  logic or_1791_s11_q;
  logic not_1792_s11_q;
  logic [4:0] select_1815_s11_q;
  logic select_1821_s11_q;
  logic [7:0] patches_left_rdata_s11_q;
  logic [3:0] select_1859_s11_q;
  logic and_1869_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic [7:0] select_1873_s11_q;
  logic [8:0] sum_1916_s11_q;
  logic less_1963_s11_q;
  logic equal_1964_s11_q;
  logic or_1966_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_1990_s11_q;
  logic and_2011_s11_q;
  logic and_2133_s11_q;
  logic equal_2277_s11_q;
  logic equal_2466_s11_q;
  logic and_2593_s11_q;
  logic equal_2678_s11_q;
  logic less_2720_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] taken_s11_q;
  logic [7:0] not_2738_s11_q;
  logic less_2759_s11_q;
  logic and_2989_s11_q;
  logic or_3040_s11_q;
  logic not_3064_s11_q;
  logic equal_3556_s11_q;
  logic less_3812_s11_q;
  logic equal_4031_s11_q;
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
      select_509_s11_q <= select_509_s10_q;
      equal_510_s11_q <= equal_510_s10_q;
      row_starts_s11_q <= row_starts_s10_q;
      select_514_s11_q <= select_514_s10_q;
      and_523_s11_q <= and_523_s10_q;
      equal_529_s11_q <= equal_529_s10_q;
      select_544_s11_q <= select_544_s10_q;
      last_s11_q <= last_s10_q;
      and_548_s11_q <= and_548_s10_q;
      and_550_s11_q <= and_550_s10_q;
      equal_570_s11_q <= equal_570_s10_q;
      first_s11_q <= first_s10_q;
      equal_575_s11_q <= equal_575_s10_q;
      so_s11_q <= so_s10_q;
      equal_579_s11_q <= equal_579_s10_q;
      or_580_s11_q <= or_580_s10_q;
      less_583_s11_q <= less_583_s10_q;
      not_584_s11_q <= not_584_s10_q;
      inside_v_s11_q <= inside_v;
      and_601_s11_q <= and_601_s10_q;
      and_609_s11_q <= and_609_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_627_s11_q <= select_627_s10_q;
      right_s11_q <= right_s10_q;
      best_right_rdata_s11_q <= best_right_rdata_q;
      and_640_s11_q <= and_640_s10_q;
      and_645_s11_q <= and_645_s10_q;
      and_647_s11_q <= and_647_s10_q;
      equal_680_s11_q <= equal_680_s10_q;
      column_s11_q <= column;
      select_1258_s11_q <= age_s10_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1507_s11_q <= age_s10_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1542_s11_q <= {1'b0, before_v_2} + sum_1541;
      sum_1545_s11_q <= {1'b0, before_v_3} + sum_1544;
      and_1562_s11_q <= and_1562_s10_q;
      equal_1563_s11_q <= equal_1563_s10_q;
      or_1583_s11_q <= or_1583_s10_q;
      right_2_s11_q <= right_2;
      and_1686_s11_q <= and_1686_s10_q;
      and_1698_s11_q <= so_s10_q & (ends_cell_s10_q & (inside_v & right_3_s10_q));
      less_1700_s11_q <= less_1700_s10_q;
      b_s11_q <= b_s10_q;
      and_1733_s11_q <= and_1733_s10_q;
      sum_1767_s11_q <= sum_1767[7:0];
      less_1768_s11_q <= $signed(6'h0) < $signed(sum_1767[12:7]);
      less_1769_s11_q <= $signed(sum_1767[12:7]) < $signed(6'h3f);
      equal_1778_s11_q <= equal_1778_s10_q;
      and_1782_s11_q <= so_s10_q & (ends_cell_s10_q & (inside_v & or_1779_s10_q));
      equal_1785_s11_q <= equal_1785_s10_q;
      not_1786_s11_q <= not_1786_s10_q;
      equal_1787_s11_q <= equal_1787_s10_q;
      not_1788_s11_q <= not_1788_s10_q;
      equal_1789_s11_q <= equal_1789_s10_q;
      equal_1790_s11_q <= equal_1790_s10_q;
      or_1791_s11_q <= or_1791_s10_q;
      not_1792_s11_q <= not_1792_s10_q;
      select_1815_s11_q <= select_1815_s10_q;
      select_1821_s11_q <= select_1821_s10_q;
      patches_left_rdata_s11_q <= patches_left_rdata_q;
      select_1859_s11_q <= select_1859_s10_q;
      and_1869_s11_q <= and_1869_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_s10_q;
      select_1873_s11_q <= patches_second_s10_q ? patches_right_1_rdata_s10_q : pixel;
      sum_1916_s11_q <= sum_1916;
      less_1963_s11_q <= less_1963_s10_q;
      equal_1964_s11_q <= equal_1964_s10_q;
      or_1966_s11_q <= or_1966_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_1990_s11_q <= sum_1990_s10_q;
      and_2011_s11_q <= and_2011_s10_q;
      and_2133_s11_q <= and_2133_s10_q;
      equal_2277_s11_q <= equal_2277_s10_q;
      equal_2466_s11_q <= equal_2466_s10_q;
      and_2593_s11_q <= and_2593_s10_q;
      equal_2678_s11_q <= equal_2678_s10_q;
      less_2720_s11_q <= slot_s10_q < 3'h3;
      wide_s11_q <= wide_s10_q;
      taken_s11_q <= taken;
      not_2738_s11_q <= ~wide_s10_q;
      less_2759_s11_q <= less_2759_s10_q;
      and_2989_s11_q <= so_s10_q & (ends_cell_s10_q & (inside_v & not_2986_s10_q));
      or_3040_s11_q <= or_3040_s10_q;
      not_3064_s11_q <= not_3064_s10_q;
      equal_3556_s11_q <= equal_3556_s10_q;
      less_3812_s11_q <= less_3812_s10_q;
      equal_4031_s11_q <= equal_4031_s10_q;
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
  // hls/stages/census.hpp:127
  logic and_524;
  assign and_524 = sample_pair_whole_s11_q & and_523_s11_q;
  // hls/stages/moments.hpp:57
  logic [13:0] select_573;
  assign select_573 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:1009
  logic not_576;
  assign not_576 = ~equal_575_s11_q;
  // hls/stages/agreement.hpp:201
  logic not_578;
  assign not_578 = ~so_s11_q;
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s11_q[2] ? best_right_rdata_s11_q[14:8] : best_right_rdata_s11_q[28:22];
  // hls/stages/agreement.hpp:807
  logic or_760;
  assign or_760 = shift_first_s11_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1009;
  assign select_1009 = age_s11_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s11_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1537;
  assign sum_1537 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1547;
  assign select_1547 = (sum_1542_s11_q < sum_1545_s11_q) ? sum_1545_s11_q : sum_1542_s11_q;
  // hls/stages/agreement.hpp:788
  logic and_1573;
  assign and_1573 = ends_cell_s11_q & inside_v_s11_q;
  logic and_1575;
  assign and_1575 = not_576 & (so_s11_q & and_1573);
  // hls/stages/registration.hpp:83
  logic equal_1701;
  assign equal_1701 = slot_s11_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1704;
  assign select_1704 = b_s11_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1705;
  assign select_1705 = b_s11_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1706;
  assign sum_1706 = {{2{select_1704[6]}}, select_1704} + {select_1705[7], select_1705};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1707;
  assign select_1707 = b_s11_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1708;
  assign select_1708 = b_s11_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1709;
  assign sum_1709 = {{2{select_1707[7]}}, select_1707[7:1]} + {select_1708[7], select_1708};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1711;
  assign select_1711 = b_s11_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1712;
  assign select_1712 = b_s11_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1713;
  assign difference_1713 = {{2{select_1711[7]}}, select_1711[7:1]} - {select_1712[7], select_1712};
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1749;
  assign select_1749 = so_s11_q ? (ends_cell_s11_q ? (inside_v_s11_q ? b_s11_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1771;
  assign select_1771 = less_1768_s11_q ? 8'h7f : (less_1769_s11_q ? 8'h80 : sum_1767_s11_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1701 ? registration_slope_here_q : select_1771;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1775;
  assign select_1775 = so_s11_q ? (ends_cell_s11_q ? (inside_v_s11_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1783;
  assign and_1783 = not_576 & and_1782_s11_q;
  // hls/stages/patches.hpp:174
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1790_s11_q ? select_1873_s11_q : patches_left_rdata_s11_q;
  // hls/stages/patches.hpp:471
  logic [9:0] sum_1917;
  assign sum_1917 = {2'h0, patches_columns_above_rdata_s11_q[15:8]} + {1'b0, sum_1916_s11_q};
  // hls/stages/agreement.hpp:788
  logic and_2329;
  assign and_2329 = not_576 & (not_578 & (equal_579_s11_q & (inside_v_s11_q & first_s11_q)));
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2566;
  assign select_2566 = slot_s11_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2567;
  assign select_2567 = slot_s11_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2568;
  assign select_2568 = slot_s11_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2569;
  assign select_2569 = slot_s11_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2570;
  assign select_2570 = slot_s11_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2571;
  assign select_2571 = slot_s11_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s11_q[61:54]} - {1'b0, best_left_rdata_s11_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2731;
  assign not_2731 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2720_s11_q ? {1'b0, wide_s11_q, 1'b0} : {registration_displacement_over_q[8:0], not_2731};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2739;
  assign select_2739 = registration_displacement_over_q[9] ? wide_s11_q : not_2738_s11_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2720_s11_q ? {taken_s11_q, 1'b1} : {not_2731, select_2739, not_2731};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2741;
  assign sum_2741 = {left, 1'b1} + {taken_2, less_2720_s11_q};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2743;
  assign select_2743 = so_s11_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2745;
  assign select_2745 = equal_575_s11_q ? registration_slope_here_q : (so_s11_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2754;
  assign select_2754 = or_580_s11_q ? (less_583_s11_q ? 3'h0 : best_left_rdata_s11_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:559
  logic [9:0] select_3507;
  assign select_3507 = less_1963_s11_q ? (or_1966_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3510;
  assign select_3510 = less_1963_s11_q ? (or_1966_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0) : 5'h0;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:238; read in stage 11, written in stage 14: 11 < 14 < 11 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_514_s11_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s11_en & and_524;
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
  assign seen_columns_re = s11_en & and_1575;
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
      moments_place_q <= select_573;
      moments_taken_q <= not_576 & (not_578 & (equal_579_s11_q & inside_v_s11_q));
      moments_starts_q <= and_2329;
      shift_not_right_q <= $signed(run_shift_s11_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s11_q ? sum_2741[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2743;
      registration_slope_here_q <= select_2745;
      patches_read_row_differing_q <= equal_1785_s11_q ? select_3507 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1785_s11_q ? select_3510 : patches_read_row_column_q;
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
      middle_sum_columns_values_1_q <= select_2566;
      middle_sum_columns_values_2_q <= select_2567;
      middle_sum_columns_values_3_q <= select_2568;
      middle_sum_columns_values_4_q <= select_2569;
      middle_sum_columns_values_5_q <= select_2570;
      middle_sum_columns_values_6_q <= select_2571;
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
  logic [4:0] patches_step_s12_q;
  logic [9:0] patches_read_row_differing_s12_q;
  logic [4:0] patches_read_row_column_s12_q;
  logic patches_read_searches_s12_q;
  logic [3:0] select_509_s12_q;
  logic equal_510_s12_q;
  logic row_starts_s12_q;
  logic [8:0] select_514_s12_q;
  logic and_523_s12_q;
  logic and_524_s12_q;
  logic equal_529_s12_q;
  logic [6:0] select_544_s12_q;
  logic [6:0] last_s12_q;
  logic and_548_s12_q;
  logic and_550_s12_q;
  logic equal_570_s12_q;
  logic first_s12_q;
  logic equal_575_s12_q;
  logic not_576_s12_q;
  logic so_s12_q;
  logic not_578_s12_q;
  logic equal_579_s12_q;
  logic or_580_s12_q;
  logic less_583_s12_q;
  logic not_584_s12_q;
  logic inside_v_s12_q;
  logic and_601_s12_q;
  logic and_609_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic less_620_s12_q;
  logic [6:0] select_627_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic [6:0] chosen_s12_q;
  logic and_640_s12_q;
  logic and_645_s12_q;
  logic and_647_s12_q;
  logic equal_680_s12_q;
  logic select_762_s12_q;
  logic [6:0] difference_1010_s12_q;
  logic [6:0] difference_1259_s12_q;
  logic equal_1260_s12_q;
  logic [6:0] difference_1508_s12_q;
  logic [6:0] sum_1538_s12_q;
  logic [6:0] select_1547_s12_q;
  logic and_1562_s12_q;
  logic select_1564_s12_q;
  logic and_1573_s12_q;
  logic and_1575_s12_q;
  logic or_1583_s12_q;
  logic and_1592_s12_q;
  logic right_2_s12_q;
  logic and_1686_s12_q;
  logic and_1699_s12_q;
  logic less_1700_s12_q;
  logic equal_1701_s12_q;
  logic [7:0] sum_1706_s12_q;
  logic select_1707_s12_q;
  logic [8:0] sum_1709_s12_q;
  logic select_1711_s12_q;
  logic [8:0] difference_1713_s12_q;
  logic and_1733_s12_q;
  logic [5:0] select_1750_s12_q;
  logic [7:0] select_1776_s12_q;
  logic equal_1778_s12_q;
  logic and_1783_s12_q;
  logic and_1784_s12_q;
  logic equal_1785_s12_q;
  logic not_1786_s12_q;
  logic equal_1787_s12_q;
  logic not_1788_s12_q;
  logic equal_1789_s12_q;
  logic equal_1790_s12_q;
  logic or_1791_s12_q;
  logic not_1792_s12_q;
  logic [4:0] select_1815_s12_q;
  logic select_1821_s12_q;
  logic [3:0] select_1859_s12_q;
  logic and_1869_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] pixel_2_s12_q;
  logic [9:0] sum_1917_s12_q;
  logic less_1963_s12_q;
  logic equal_1964_s12_q;
  logic or_1966_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1990_s12_q;
  logic and_2011_s12_q;
  logic and_2134_s12_q;
  logic equal_2277_s12_q;
  logic equal_2466_s12_q;
  logic and_2593_s12_q;
  logic equal_2678_s12_q;
  logic rise_s12_q;
  logic [7:0] xor_2683_s12_q;
  logic select_2754_s12_q;
  logic or_2757_s12_q;
  logic [1:0] sum_2758_s12_q;
  logic less_2759_s12_q;
  logic and_2990_s12_q;
  logic or_3040_s12_q;
  logic not_3064_s12_q;
  logic equal_3556_s12_q;
  logic less_3812_s12_q;
  logic equal_4031_s12_q;
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
      patches_step_s12_q <= patches_step_s11_q;
      patches_read_row_differing_s12_q <= patches_read_row_differing_q;
      patches_read_row_column_s12_q <= patches_read_row_column_q;
      patches_read_searches_s12_q <= patches_read_searches_s11_q;
      select_509_s12_q <= select_509_s11_q;
      equal_510_s12_q <= equal_510_s11_q;
      row_starts_s12_q <= row_starts_s11_q;
      select_514_s12_q <= select_514_s11_q;
      and_523_s12_q <= and_523_s11_q;
      and_524_s12_q <= and_524;
      equal_529_s12_q <= equal_529_s11_q;
      select_544_s12_q <= select_544_s11_q;
      last_s12_q <= last_s11_q;
      and_548_s12_q <= and_548_s11_q;
      and_550_s12_q <= and_550_s11_q;
      equal_570_s12_q <= equal_570_s11_q;
      first_s12_q <= first_s11_q;
      equal_575_s12_q <= equal_575_s11_q;
      not_576_s12_q <= not_576;
      so_s12_q <= so_s11_q;
      not_578_s12_q <= not_578;
      equal_579_s12_q <= equal_579_s11_q;
      or_580_s12_q <= or_580_s11_q;
      less_583_s12_q <= less_583_s11_q;
      not_584_s12_q <= not_584_s11_q;
      inside_v_s12_q <= inside_v_s11_q;
      and_601_s12_q <= and_601_s11_q;
      and_609_s12_q <= and_609_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      less_620_s12_q <= 8'hb6 < best_left_rdata_s11_q[16:9];
      select_627_s12_q <= select_627_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_s11_q;
      chosen_s12_q <= chosen;
      and_640_s12_q <= and_640_s11_q;
      and_645_s12_q <= and_645_s11_q;
      and_647_s12_q <= and_647_s11_q;
      equal_680_s12_q <= equal_680_s11_q;
      select_762_s12_q <= or_760 ? shift_first_s11_q : (~age_s11_q[1]);
      difference_1010_s12_q <= {1'b0, column_s11_q} - {1'b0, select_1009};
      difference_1259_s12_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1258_s11_q};
      equal_1260_s12_q <= {age_s11_q[0], slot_s11_q[0]} == 2'h0;
      difference_1508_s12_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1507_s11_q};
      sum_1538_s12_q <= {1'b0, before_v} + sum_1537;
      select_1547_s12_q <= select_1547;
      and_1562_s12_q <= and_1562_s11_q;
      select_1564_s12_q <= or_760 ? shift_first_s11_q : equal_1563_s11_q;
      and_1573_s12_q <= and_1573;
      and_1575_s12_q <= and_1575;
      or_1583_s12_q <= or_1583_s11_q;
      and_1592_s12_q <= or_580_s11_q & (slot_s11_q[2] & not_584_s11_q);
      right_2_s12_q <= right_2_s11_q;
      and_1686_s12_q <= and_1686_s11_q;
      and_1699_s12_q <= not_576 & and_1698_s11_q;
      less_1700_s12_q <= less_1700_s11_q;
      equal_1701_s12_q <= equal_1701;
      sum_1706_s12_q <= sum_1706[8:1];
      select_1707_s12_q <= select_1707[0];
      sum_1709_s12_q <= sum_1709;
      select_1711_s12_q <= select_1711[0];
      difference_1713_s12_q <= difference_1713;
      and_1733_s12_q <= and_1733_s11_q;
      select_1750_s12_q <= equal_575_s11_q ? 6'h0 : select_1749;
      select_1776_s12_q <= equal_575_s11_q ? 8'h0 : select_1775;
      equal_1778_s12_q <= equal_1778_s11_q;
      and_1783_s12_q <= and_1783;
      and_1784_s12_q <= patches_chooses_s11_q & and_1783;
      equal_1785_s12_q <= equal_1785_s11_q;
      not_1786_s12_q <= not_1786_s11_q;
      equal_1787_s12_q <= equal_1787_s11_q;
      not_1788_s12_q <= not_1788_s11_q;
      equal_1789_s12_q <= equal_1789_s11_q;
      equal_1790_s12_q <= equal_1790_s11_q;
      or_1791_s12_q <= or_1791_s11_q;
      not_1792_s12_q <= not_1792_s11_q;
      select_1815_s12_q <= select_1815_s11_q;
      select_1821_s12_q <= select_1821_s11_q;
      select_1859_s12_q <= select_1859_s11_q;
      and_1869_s12_q <= and_1869_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      pixel_2_s12_q <= pixel_2;
      sum_1917_s12_q <= sum_1917;
      less_1963_s12_q <= less_1963_s11_q;
      equal_1964_s12_q <= equal_1964_s11_q;
      or_1966_s12_q <= or_1966_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_1990_s12_q <= sum_1990_s11_q;
      and_2011_s12_q <= and_2011_s11_q;
      and_2134_s12_q <= not_576 & and_2133_s11_q;
      equal_2277_s12_q <= equal_2277_s11_q;
      equal_2466_s12_q <= equal_2466_s11_q;
      and_2593_s12_q <= and_2593_s11_q;
      equal_2678_s12_q <= equal_2678_s11_q;
      rise_s12_q <= rise[8];
      xor_2683_s12_q <= rise[7:0] ^ {8{rise[8]}};
      select_2754_s12_q <= select_2754[0];
      or_2757_s12_q <= (select_2754 == 3'h0) | (select_2754 == 3'h4);
      sum_2758_s12_q <= select_2754[2:1] + 2'h3;
      less_2759_s12_q <= less_2759_s11_q;
      and_2990_s12_q <= not_576 & and_2989_s11_q;
      or_3040_s12_q <= or_3040_s11_q;
      not_3064_s12_q <= not_3064_s11_q;
      equal_3556_s12_q <= equal_3556_s11_q;
      less_3812_s12_q <= less_3812_s11_q;
      equal_4031_s12_q <= equal_4031_s11_q;
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
  logic [13:0] select_527;
  assign select_527 = equal_510_s12_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_533;
  assign sum_533 = {6'h0, sample_pair_pixel_1_q} + (equal_510_s12_q ? 14'h0 : averager_running_1_q);
  // hls/stages/moments.hpp:63
  logic [10:0] place;
  assign place = first_s12_q ? 11'h0 : moments_place_q[13:3];
  // hls/stages/moments.hpp:104
  logic not_588;
  assign not_588 = ~(11'h3ec < place);
  // hls/stages/agreement.hpp:978
  logic select_622;
  assign select_622 = slot_s12_q[2] ? less_620_s12_q : (6'h2a < best_left_rdata_s12_q[39:34]);
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_632;
  assign difference_632 = {2'h0, chosen_s12_q} - {1'b0, x_s12_q};
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1012;
  assign sum_1012 = {difference_1010_s12_q[6], difference_1010_s12_q} + (age_s12_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1262;
  assign sum_1262 = {difference_1259_s12_q[6], difference_1259_s12_q} + (equal_1260_s12_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1510;
  assign sum_1510 = {difference_1508_s12_q[6], difference_1508_s12_q} + (equal_1260_s12_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1539;
  assign select_1539 = slot_s12_q[0] ? chosen_near_q : sum_1538_s12_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1549;
  assign select_1549 = (select_1539 < select_1547_s12_q) ? select_1547_s12_q : select_1539;
  // hls/stages/agreement.hpp:788
  logic [6:0] select_1579;
  assign select_1579 = so_s12_q ? x_s12_q[6:0] : (or_580_s12_q ? (less_583_s12_q ? 7'h0 : select_627_s12_q) : 7'h0);
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1710;
  assign sum_1710 = {{3{sum_1706_s12_q[7]}}, sum_1706_s12_q} + {sum_1709_s12_q[8], sum_1709_s12_q, select_1707_s12_q};
  logic [9:0] sum_1714;
  assign sum_1714 = {difference_1713_s12_q, select_1711_s12_q} + {sum_1710[10], sum_1710[10:2]};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_1897;
  assign sum_1897 = {1'b0, patches_columns_above_rdata_s12_q[7:0]} + {2'h0, pixel_2_s12_q[7:1]};
  logic [8:0] sum_1898;
  assign sum_1898 = {1'b0, patches_columns_above_rdata_s12_q[23:16]} + {2'h0, patches_columns_above_rdata_s12_q[31:25]};
  // hls/stages/patches.hpp:471
  logic [10:0] sum_1918;
  assign sum_1918 = {3'h0, patches_columns_above_rdata_s12_q[15:8]} + {sum_1917_s12_q, patches_columns_above_rdata_s12_q[25]};
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2578;
  assign select_2578 = slot_s12_q[0] ? 7'h0 : sum_1538_s12_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2580;
  assign select_2580 = (select_2578 < select_1547_s12_q) ? select_1547_s12_q : select_2578;
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise_s12_q ? best_left_rdata_s12_q[61:54] : best_left_rdata_s12_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2760;
  assign difference_2760 = {sum_2758_s12_q, select_2754_s12_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2761;
  assign select_2761 = less_2759_s12_q ? difference_2760 : {sum_2758_s12_q, select_2754_s12_q, registration_displacement_fraction_q};
  logic [7:0] select_2762;
  assign select_2762 = or_2757_s12_q ? {sum_2758_s12_q, select_2754_s12_q, 5'h0} : select_2761;
  // hls/stages/patches.hpp:191
  logic select_3079;
  assign select_3079 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:177
  logic and_3140;
  assign and_3140 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3145;
  assign select_3145 = or_3040_s12_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3147;
  assign select_3147 = and_3140 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:275
  logic select_3518;
  assign select_3518 = equal_1785_s12_q ? (less_1963_s12_q & (or_1966_s12_q & (patches_step_s12_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3523;
  assign or_3523 = patches_read_first_q | (patches_read_row_differing_s12_q < patches_peak_best_differing_q);
  logic and_3524;
  assign and_3524 = patches_read_searches_s12_q & or_3523;
  // hls/stages/patches.hpp:542
  logic [14:0] select_3544;
  assign select_3544 = and_3524 ? {patches_read_row_column_s12_q, patches_read_row_differing_s12_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3545;
  assign select_3545 = equal_1785_s12_q ? select_3544[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3546;
  assign select_3546 = equal_1785_s12_q ? select_3544[14:10] : patches_peak_best_column_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3813;
  assign sum_3813 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3836;
  assign select_3836 = equal_680_s12_q ? {difference_3834[7], difference_3834} : (less_3812_s12_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3838;
  assign select_3838 = and_550_s12_q ? (equal_2466_s12_q ? select_3836 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3840;
  assign select_3840 = equal_680_s12_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3842;
  assign select_3842 = and_550_s12_q ? (equal_2466_s12_q ? select_3840 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3844;
  assign select_3844 = sum_3813[7] ? {1'b1, sum_3813[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

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
  assign shown_right_re = s12_en & and_1575_s12_q;
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
  assign left_turns_re = s12_en & and_1592_s12_q;
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
  assign right_turns_raddr = select_627_s12_q;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s12_en & and_1592_s12_q;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s12_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s12_en & and_1869_s12_q;
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
      chosen_near_q <= select_2580;
      patches_along_ends_q <= not_3064_s12_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3064_s12_q & select_3079;
      patches_down_by_q <= or_3040_s12_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3140});
      patches_along_q <= select_3145;
      patches_match_row_q <= or_3040_s12_q ? 4'h0 : select_3147;
      patches_summed_last_q <= not_1786_s12_q & (equal_1787_s12_q & and_3140);
      patches_read_first_q <= select_3518;
      patches_peak_best_differing_q <= select_3545;
      patches_peak_best_column_q <= select_3546;
      region_down_rest_q <= select_3838;
      region_down_back_q <= select_3842;
      region_down_next_q <= select_3844;
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
      averager_running_0_q <= sample_pair_whole_s12_q ? select_527 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s12_q ? sum_533 : averager_running_1_q;
      middle_sum_sum_sums_values_0_q <= slot_s12_q[0] ? middle_sum_sum_sums_values_0_q : sum_1012;
      sums_0_sum_sums_values_0_q <= sum_1262;
      sums_0_sum_sums_values_1_q <= equal_1260_s12_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1510;
      sums_1_sum_sums_values_1_q <= equal_1260_s12_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [4:0] patches_column_s13_q;
  logic patches_match_row_ends_s13_q;
  logic [4:0] patches_down_by_s13_q;
  logic [4:0] patches_along_s13_q;
  logic [3:0] patches_match_row_s13_q;
  logic patches_summed_last_s13_q;
  logic [4:0] patches_step_s13_q;
  logic [9:0] patches_read_row_differing_s13_q;
  logic patches_read_first_s13_q;
  logic [3:0] select_509_s13_q;
  logic equal_510_s13_q;
  logic row_starts_s13_q;
  logic [8:0] select_514_s13_q;
  logic and_523_s13_q;
  logic and_524_s13_q;
  logic [29:0] averager_memory_rdata_s13_q;
  logic [13:0] select_527_s13_q;
  logic equal_529_s13_q;
  logic [13:0] sum_533_s13_q;
  logic [6:0] select_544_s13_q;
  logic [6:0] last_s13_q;
  logic and_548_s13_q;
  logic and_550_s13_q;
  logic equal_570_s13_q;
  logic [12:0] select_574_s13_q;
  logic equal_575_s13_q;
  logic not_576_s13_q;
  logic so_s13_q;
  logic not_578_s13_q;
  logic equal_579_s13_q;
  logic or_580_s13_q;
  logic less_583_s13_q;
  logic not_584_s13_q;
  logic inside_v_s13_q;
  logic not_588_s13_q;
  logic and_591_s13_q;
  logic and_601_s13_q;
  logic and_609_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_622_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic [9:0] sum_633_s13_q;
  logic and_640_s13_q;
  logic and_645_s13_q;
  logic and_647_s13_q;
  logic equal_680_s13_q;
  logic select_762_s13_q;
  logic [7:0] sum_1012_s13_q;
  logic less_1511_s13_q;
  logic [6:0] select_1549_s13_q;
  logic [7:0] select_1557_s13_q;
  logic [7:0] select_1560_s13_q;
  logic and_1562_s13_q;
  logic select_1564_s13_q;
  logic and_1573_s13_q;
  logic and_1575_s13_q;
  logic [6:0] select_1579_s13_q;
  logic or_1583_s13_q;
  logic and_1601_s13_q;
  logic right_2_s13_q;
  logic and_1686_s13_q;
  logic and_1699_s13_q;
  logic less_1700_s13_q;
  logic equal_1701_s13_q;
  logic sum_1710_s13_q;
  logic [9:0] sum_1714_s13_q;
  logic and_1733_s13_q;
  logic [5:0] select_1750_s13_q;
  logic [7:0] select_1776_s13_q;
  logic equal_1778_s13_q;
  logic and_1783_s13_q;
  logic and_1784_s13_q;
  logic equal_1785_s13_q;
  logic not_1786_s13_q;
  logic equal_1787_s13_q;
  logic not_1788_s13_q;
  logic equal_1789_s13_q;
  logic equal_1790_s13_q;
  logic or_1791_s13_q;
  logic not_1792_s13_q;
  logic [4:0] select_1815_s13_q;
  logic select_1821_s13_q;
  logic [3:0] select_1859_s13_q;
  logic [8:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [4:0] sum_1883_s13_q;
  logic [8:0] sum_1897_s13_q;
  logic [8:0] sum_1898_s13_q;
  logic [10:0] sum_1918_s13_q;
  logic less_1963_s13_q;
  logic equal_1964_s13_q;
  logic or_1966_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1990_s13_q;
  logic and_2011_s13_q;
  logic [17:0] seen_columns_rdata_s13_q;
  logic and_2134_s13_q;
  logic equal_2277_s13_q;
  logic equal_2466_s13_q;
  logic and_2593_s13_q;
  logic equal_2678_s13_q;
  logic [7:0] lower_s13_q;
  logic [7:0] sum_2684_s13_q;
  logic [7:0] select_2762_s13_q;
  logic and_2990_s13_q;
  logic and_3524_s13_q;
  logic equal_3556_s13_q;
  logic less_3812_s13_q;
  logic sum_3813_s13_q;
  logic equal_4031_s13_q;
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
      patches_column_s13_q <= patches_column_s12_q;
      patches_match_row_ends_s13_q <= patches_match_row_ends_q;
      patches_down_by_s13_q <= patches_down_by_q;
      patches_along_s13_q <= patches_along_q;
      patches_match_row_s13_q <= patches_match_row_q;
      patches_summed_last_s13_q <= patches_summed_last_q;
      patches_step_s13_q <= patches_step_s12_q;
      patches_read_row_differing_s13_q <= patches_read_row_differing_s12_q;
      patches_read_first_s13_q <= patches_read_first_q;
      select_509_s13_q <= select_509_s12_q;
      equal_510_s13_q <= equal_510_s12_q;
      row_starts_s13_q <= row_starts_s12_q;
      select_514_s13_q <= select_514_s12_q;
      and_523_s13_q <= and_523_s12_q;
      and_524_s13_q <= and_524_s12_q;
      averager_memory_rdata_s13_q <= averager_memory_rdata_q;
      select_527_s13_q <= select_527;
      equal_529_s13_q <= equal_529_s12_q;
      sum_533_s13_q <= sum_533;
      select_544_s13_q <= select_544_s12_q;
      last_s13_q <= last_s12_q;
      and_548_s13_q <= and_548_s12_q;
      and_550_s13_q <= and_550_s12_q;
      equal_570_s13_q <= equal_570_s12_q;
      select_574_s13_q <= first_s12_q ? 13'h0 : moments_place_q[12:0];
      equal_575_s13_q <= equal_575_s12_q;
      not_576_s13_q <= not_576_s12_q;
      so_s13_q <= so_s12_q;
      not_578_s13_q <= not_578_s12_q;
      equal_579_s13_q <= equal_579_s12_q;
      or_580_s13_q <= or_580_s12_q;
      less_583_s13_q <= less_583_s12_q;
      not_584_s13_q <= not_584_s12_q;
      inside_v_s13_q <= inside_v_s12_q;
      not_588_s13_q <= not_588;
      and_591_s13_q <= not_578_s12_q & (equal_579_s12_q & (inside_v_s12_q & not_588));
      and_601_s13_q <= and_601_s12_q;
      and_609_s13_q <= and_609_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q[45:0];
      select_622_s13_q <= select_622;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      sum_633_s13_q <= {difference_632[8], difference_632} + 10'h1;
      and_640_s13_q <= and_640_s12_q;
      and_645_s13_q <= and_645_s12_q;
      and_647_s13_q <= and_647_s12_q;
      equal_680_s13_q <= equal_680_s12_q;
      select_762_s13_q <= select_762_s12_q;
      sum_1012_s13_q <= sum_1012;
      less_1511_s13_q <= sum_1262 < sum_1510;
      select_1549_s13_q <= select_1549;
      select_1557_s13_q <= select_762_s12_q ? 8'h0 : best_left_rdata_s12_q[53:46];
      select_1560_s13_q <= select_762_s12_q ? 8'h0 : best_left_rdata_s12_q[61:54];
      and_1562_s13_q <= and_1562_s12_q;
      select_1564_s13_q <= select_1564_s12_q;
      and_1573_s13_q <= and_1573_s12_q;
      and_1575_s13_q <= and_1575_s12_q;
      select_1579_s13_q <= select_1579;
      or_1583_s13_q <= or_1583_s12_q;
      and_1601_s13_q <= moments_taken_q;
      right_2_s13_q <= right_2_s12_q;
      and_1686_s13_q <= and_1686_s12_q;
      and_1699_s13_q <= and_1699_s12_q;
      less_1700_s13_q <= less_1700_s12_q;
      equal_1701_s13_q <= equal_1701_s12_q;
      sum_1710_s13_q <= sum_1710[1];
      sum_1714_s13_q <= sum_1714;
      and_1733_s13_q <= and_1733_s12_q;
      select_1750_s13_q <= select_1750_s12_q;
      select_1776_s13_q <= select_1776_s12_q;
      equal_1778_s13_q <= equal_1778_s12_q;
      and_1783_s13_q <= and_1783_s12_q;
      and_1784_s13_q <= and_1784_s12_q;
      equal_1785_s13_q <= equal_1785_s12_q;
      not_1786_s13_q <= not_1786_s12_q;
      equal_1787_s13_q <= equal_1787_s12_q;
      not_1788_s13_q <= not_1788_s12_q;
      equal_1789_s13_q <= equal_1789_s12_q;
      equal_1790_s13_q <= equal_1790_s12_q;
      or_1791_s13_q <= or_1791_s12_q;
      not_1792_s13_q <= not_1792_s12_q;
      select_1815_s13_q <= select_1815_s12_q;
      select_1821_s13_q <= select_1821_s12_q;
      select_1859_s13_q <= select_1859_s12_q;
      patches_columns_above_rdata_s13_q <= {patches_columns_above_rdata_s12_q[24], patches_columns_above_rdata_s12_q[7:0]};
      pixel_2_s13_q <= pixel_2_s12_q;
      sum_1883_s13_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1897_s13_q <= sum_1897;
      sum_1898_s13_q <= sum_1898;
      sum_1918_s13_q <= sum_1918;
      less_1963_s13_q <= less_1963_s12_q;
      equal_1964_s13_q <= equal_1964_s12_q;
      or_1966_s13_q <= or_1966_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1990_s13_q <= sum_1990_s12_q;
      and_2011_s13_q <= and_2011_s12_q;
      seen_columns_rdata_s13_q <= seen_columns_rdata_q;
      and_2134_s13_q <= and_2134_s12_q;
      equal_2277_s13_q <= equal_2277_s12_q;
      equal_2466_s13_q <= equal_2466_s12_q;
      and_2593_s13_q <= and_2593_s12_q;
      equal_2678_s13_q <= equal_2678_s12_q;
      lower_s13_q <= lower;
      sum_2684_s13_q <= {7'h0, rise_s12_q} + xor_2683_s12_q;
      select_2762_s13_q <= select_2762;
      and_2990_s13_q <= and_2990_s12_q;
      and_3524_s13_q <= and_3524;
      equal_3556_s13_q <= equal_3556_s12_q;
      less_3812_s13_q <= less_3812_s12_q;
      sum_3813_s13_q <= sum_3813[7];
      equal_4031_s13_q <= equal_4031_s12_q;
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
  logic [13:0] sum_531;
  assign sum_531 = select_527_s13_q + (equal_529_s13_q ? 14'h0 : averager_memory_rdata_s13_q[13:0]);
  logic [13:0] sum_535;
  assign sum_535 = sum_533_s13_q + (equal_529_s13_q ? 14'h0 : averager_memory_rdata_s13_q[27:14]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = equal_510_s13_q ? sample_present_s13_q : (sample_present_s13_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_510_s13_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:131
  logic and_543;
  assign and_543 = all_of_skin & (averager_memory_rdata_s13_q[29] | equal_529_s13_q);
  // hls/stages/agreement.hpp:788
  logic and_592;
  assign and_592 = not_576_s13_q & and_591_s13_q;
  // hls/stages/agreement.hpp:247
  logic and_635;
  assign and_635 = (and_609_s13_q & select_622_s13_q) & ({{22{sum_633_s13_q[9]}}, sum_633_s13_q} < 32'h3);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_1013;
  assign select_1013 = slot_s13_q[0] ? chosen_score_q : sum_1012_s13_q;
  // hls/stages/agreement.hpp:751
  logic [7:0] select_1512;
  assign select_1512 = less_1511_s13_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1513;
  assign less_1513 = select_1013 < select_1512;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1513 ? select_1512 : select_1013) : 8'h0;
  // hls/stages/agreement.hpp:720
  logic not_1519;
  assign not_1519 = ~slot_s13_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1520;
  assign select_1520 = less_1511_s13_q ? {slot_s13_q[0], not_1519} : 2'h0;
  logic [2:0] select_1522;
  assign select_1522 = less_1513 ? {select_1520, not_1519} : (slot_s13_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1549_s13_q : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1551;
  assign less_1551 = best_left_rdata_s13_q[39:33] < of_near;
  // hls/stages/agreement.hpp:1128
  logic equal_1608;
  assign equal_1608 = x_s13_q[6:4] == 3'h7;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s13_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:214
  logic equal_1622;
  assign equal_1622 = x_s13_q[5:0] == 6'h3c;
  logic equal_1624;
  assign equal_1624 = x_s13_q[5:0] == 6'h3b;
  logic equal_1626;
  assign equal_1626 = x_s13_q[5:0] == 6'h36;
  logic equal_1628;
  assign equal_1628 = x_s13_q[5:0] == 6'h35;
  logic equal_1630;
  assign equal_1630 = x_s13_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_1634;
  assign and_1634 = (~equal_1624) & ((~equal_1626) & ((~equal_1628) & (~equal_1630)));
  // hls/stages/patches.hpp:377
  logic [1:0] select_1687;
  assign select_1687 = and_1686_s13_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1688;
  assign select_1688 = and_1686_s13_q ? patches_band_rows_number_s13_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1689;
  assign select_1689 = row_starts_s13_q ? {select_1688, select_1687[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1690;
  assign select_1690 = row_starts_s13_q ? select_1687 : patches_fetch_q;
  logic equal_1691;
  assign equal_1691 = select_1690 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1701_s13_q ? {sum_1714_s13_q, sum_1710_s13_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1798;
  assign select_1798 = row_starts_s13_q ? select_1688 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_1799;
  assign equal_1799 = {patches_choosing_band_s13_q, and_1699_s13_q} == {select_1798, select_1690[1]};
  // hls/stages/patches.hpp:504
  logic less_1875;
  assign less_1875 = 5'he < patches_along_s13_q;
  // hls/stages/patches.hpp:505
  logic or_1876;
  assign or_1876 = equal_1789_s13_q | less_1875;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_s13_q == 5'h0;
  logic select_1881;
  assign select_1881 = equal_1789_s13_q ? patches_column_s13_q[0] : (or_1876 ? (patches_along_s13_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:506
  logic [4:0] select_1884;
  assign select_1884 = patches_match_row_ends_s13_q ? patches_down_by_s13_q : sum_1883_s13_q;
  // hls/stages/patches.hpp:509
  logic [4:0] select_1887;
  assign select_1887 = equal_1789_s13_q ? 5'h0 : (or_1876 ? (select_1884 + 5'h1) : sum_1883_s13_q);
  // hls/stages/patches.hpp:485
  logic equal_1890;
  assign equal_1890 = patches_column_s13_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s13_q == 5'h11;
  logic equal_1892;
  assign equal_1892 = patches_column_s13_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_1894;
  assign and_1894 = of_row & (~equal_1892);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1890 ? 2'h3 : {equal_1892, and_1894};
  // hls/stages/patches.hpp:473
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1897_s13_q, pixel_2_s13_q[0]} - {1'b0, sum_1898_s13_q, patches_columns_above_rdata_s13_q[8]};
  // hls/stages/patches.hpp:471
  logic [9:0] sum_1919;
  assign sum_1919 = {2'h0, patches_columns_above_rdata_s13_q[7:0]} + sum_1918_s13_q[10:1];
  // hls/stages/patches.hpp:486
  logic or_1938;
  assign or_1938 = (((patches_column_s13_q == 5'ha) | of_row) | equal_1892) | equal_1890;
  // hls/stages/patches.hpp:481
  logic and_1943;
  assign and_1943 = (~(patches_code_row_s13_q[4:2] == 3'h0)) & (~(patches_column_s13_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:174
  logic and_1957;
  assign and_1957 = (~(equal_1790_s13_q | (~and_1943))) & (~patches_column_s13_q[4]);
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1977;
  assign select_1977 = so_s13_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1980;
  assign or_1980 = select_1977[7] | (~({select_1977[5], select_1977[3], select_1977[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1983;
  assign or_1983 = select_1977[7] | (~({select_1977[6], select_1977[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_1986;
  assign or_1986 = select_1977[7] | (~(select_1977[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1987;
  assign select_1987 = equal_575_s13_q ? x_s13_q[5:0] : {region_row_q, or_1986, or_1983, or_1980};
  // hls/stages/agreement.hpp:1128
  logic not_1988;
  assign not_1988 = ~equal_1608;
  // hls/stages/agreement.hpp:1058
  logic or_1992;
  assign or_1992 = (~sum_1990_s13_q) | equal_1778_s13_q;
  // hls/stages/agreement.hpp:788
  logic and_1995;
  assign and_1995 = so_s13_q & (ends_cell_s13_q & (inside_v_s13_q & or_1992));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s13_q & (or_580_s13_q & (not_584_s13_q & and_609_s13_q));
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2075;
  assign select_2075 = inside_v_s13_q ? (sum_1990_s13_q ? select_1977 : {select_1977[6:0], 1'b0}) : select_1977;
  // hls/stages/agreement.hpp:1050
  logic or_2078;
  assign or_2078 = select_2075[7] | (~({select_2075[5], select_2075[3], select_2075[1]} == 3'h0));
  // hls/stages/agreement.hpp:276
  logic select_2190;
  assign select_2190 = sample_pair_whole_s13_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:239
  logic [7:0] select_2575;
  assign select_2575 = slot_s13_q[0] ? 8'h0 : sum_1012_s13_q;
  // hls/stages/agreement.hpp:751
  logic less_2576;
  assign less_2576 = select_2575 < select_1512;
  // hls/stages/agreement.hpp:788
  logic less_2582;
  assign less_2582 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2584;
  assign less_2584 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2682;
  assign difference_2682 = best_left_rdata_s13_q[16:9] - lower_s13_q;
  // hls/stages/agreement.hpp:788
  logic [10:0] select_2747;
  assign select_2747 = equal_575_s13_q ? registration_expected_q : (so_s13_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2762_s13_q[7]}}, select_2762_s13_q} - {sum_1714_s13_q[9], sum_1714_s13_q, sum_1710_s13_q};
  // hls/stages/patches.hpp:358
  logic not_3005;
  assign not_3005 = ~select_1690[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3007;
  assign select_3007 = sample_pair_whole_s13_q ? (equal_1691 ? select_1690 : {not_3005, 1'b0}) : patches_fetch_q;
  // hls/stages/agreement.hpp:275
  logic [4:0] select_3502;
  assign select_3502 = equal_1787_s13_q ? patches_down_by_s13_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:559
  logic [4:0] select_3513;
  assign select_3513 = less_1963_s13_q ? (or_1966_s13_q ? patches_step_s13_q : 5'h0) : 5'h0;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3525;
  assign select_3525 = and_3524_s13_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s13_q} - {1'b0, select_3525};
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3815;
  assign select_3815 = less_3812_s13_q ? (sum_3813_s13_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3817;
  assign select_3817 = equal_2466_s13_q ? (equal_680_s13_q ? 3'h0 : select_3815) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3822;
  assign select_3822 = equal_575_s13_q ? select_1977 : (so_s13_q ? (ends_cell_s13_q ? select_2075 : select_1977) : 8'h1);
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3813_s13_q;
  // hls/stages/agreement.hpp:460
  logic select_3848;
  assign select_3848 = equal_2466_s13_q ? (equal_680_s13_q | (less_3812_s13_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1217
  logic equal_3866;
  assign equal_3866 = x_s13_q[6:3] == 4'h7;
  logic equal_3891;
  assign equal_3891 = x_s13_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3906;
  assign select_3906 = (x_s13_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3908;
  assign select_3908 = equal_3891 ? cfg_unproven_skin_limit_i : (equal_3866 ? cfg_unproven_limit_i : select_3906);

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
  assign census_memory_re = s13_en & and_550_s13_q;
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
  assign moments_memory_raddr = select_574_s13_q;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s13_en & and_592;
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
      averager_running_of_skin_q <= select_2190;
      chosen_score_q <= less_2576 ? select_1512 : select_2575;
      chosen_place_q <= less_2576 ? {select_1520, not_1519} : 3'h2;
      before_0_q <= select_2575;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2582) & (~less_2584);
      registration_expected_q <= select_2747;
      patches_band_q <= sample_pair_whole_s13_q ? select_1798 : patches_band_q;
      patches_fetch_q <= select_3007;
      patches_summed_down_by_q <= equal_1785_s13_q ? patches_summed_down_by_q : select_3502;
      patches_read_at_q <= equal_1785_s13_q ? select_3513 : patches_read_at_q;
      patches_peak_row_q <= equal_1785_s13_q ? select_3525 : patches_peak_row_q;
      region_row_q <= and_550_s13_q ? select_3817 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3822;
      region_fresh_q <= and_550_s13_q ? select_3848 : region_fresh_q;
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
  logic [4:0] patches_along_s14_q;
  logic [3:0] patches_match_row_s14_q;
  logic patches_summed_last_s14_q;
  logic [4:0] patches_summed_down_by_s14_q;
  logic [9:0] patches_read_row_differing_s14_q;
  logic patches_read_first_s14_q;
  logic [2:0] region_row_s14_q;
  logic region_fresh_s14_q;
  logic [3:0] select_509_s14_q;
  logic row_starts_s14_q;
  logic [8:0] select_514_s14_q;
  logic and_523_s14_q;
  logic and_524_s14_q;
  logic [13:0] sum_531_s14_q;
  logic [13:0] sum_535_s14_q;
  logic and_539_s14_q;
  logic and_543_s14_q;
  logic [6:0] select_544_s14_q;
  logic [6:0] last_s14_q;
  logic and_548_s14_q;
  logic and_550_s14_q;
  logic equal_553_s14_q;
  logic equal_570_s14_q;
  logic [12:0] select_574_s14_q;
  logic equal_575_s14_q;
  logic not_576_s14_q;
  logic so_s14_q;
  logic not_578_s14_q;
  logic equal_579_s14_q;
  logic or_580_s14_q;
  logic less_583_s14_q;
  logic not_584_s14_q;
  logic inside_v_s14_q;
  logic not_588_s14_q;
  logic and_592_s14_q;
  logic and_601_s14_q;
  logic [6:0] x_s14_2_q;
  logic [32:0] best_left_rdata_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic and_635_s14_q;
  logic and_640_s14_q;
  logic and_645_s14_q;
  logic and_647_s14_q;
  logic equal_680_s14_q;
  logic select_762_s14_q;
  logic [7:0] of_best_s14_q;
  logic [2:0] select_1522_s14_q;
  logic [6:0] of_near_s14_q;
  logic [6:0] select_1552_s14_q;
  logic [5:0] select_1554_s14_q;
  logic [7:0] select_1557_s14_q;
  logic [7:0] select_1560_s14_q;
  logic and_1562_s14_q;
  logic select_1564_s14_q;
  logic or_1570_s14_q;
  logic and_1573_s14_q;
  logic and_1575_s14_q;
  logic [1:0] shown_right_rdata_s14_q;
  logic [6:0] select_1579_s14_q;
  logic and_1584_s14_q;
  logic [1:0] left_turns_rdata_s14_q;
  logic and_1601_s14_q;
  logic [1:0] right_turns_rdata_s14_q;
  logic equal_1608_s14_q;
  logic all_s14_q;
  logic equal_1622_s14_q;
  logic equal_1624_s14_q;
  logic equal_1626_s14_q;
  logic equal_1628_s14_q;
  logic equal_1630_s14_q;
  logic and_1635_s14_q;
  logic right_2_s14_q;
  logic [5:0] select_1689_s14_q;
  logic select_1690_s14_q;
  logic equal_1691_s14_q;
  logic and_1699_s14_q;
  logic less_1700_s14_q;
  logic equal_1701_s14_q;
  logic expected_s14_q;
  logic [10:0] sum_1716_s14_q;
  logic and_1733_s14_q;
  logic [5:0] select_1750_s14_q;
  logic [7:0] select_1776_s14_q;
  logic and_1783_s14_q;
  logic and_1784_s14_q;
  logic equal_1785_s14_q;
  logic not_1786_s14_q;
  logic equal_1787_s14_q;
  logic not_1788_s14_q;
  logic equal_1790_s14_q;
  logic or_1791_s14_q;
  logic not_1792_s14_q;
  logic and_1800_s14_q;
  logic [4:0] select_1815_s14_q;
  logic select_1821_s14_q;
  logic [3:0] select_1859_s14_q;
  logic patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic less_1875_s14_q;
  logic new_row_s14_q;
  logic select_1881_s14_q;
  logic not_1882_s14_q;
  logic [4:0] select_1887_s14_q;
  logic or_1888_s14_q;
  logic [1:0] of_row_2_s14_q;
  logic [10:0] down_2_s14_q;
  logic sum_1918_s14_q;
  logic [9:0] sum_1919_s14_q;
  logic and_1946_s14_q;
  logic and_1957_s14_q;
  logic and_1960_s14_q;
  logic less_1963_s14_q;
  logic equal_1964_s14_q;
  logic or_1966_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic or_1980_s14_q;
  logic or_1983_s14_q;
  logic or_1986_s14_q;
  logic [5:0] select_1987_s14_q;
  logic not_1988_s14_q;
  logic select_1996_s14_q;
  logic textured_s14_q;
  logic and_2011_s14_q;
  logic and_2020_s14_q;
  logic [12:0] seen_columns_rdata_s14_q;
  logic and_2061_s14_q;
  logic and_2063_s14_q;
  logic or_2078_s14_q;
  logic or_2081_s14_q;
  logic or_2084_s14_q;
  logic and_2095_s14_q;
  logic and_2111_s14_q;
  logic and_2134_s14_q;
  logic equal_2277_s14_q;
  logic equal_2466_s14_q;
  logic and_2593_s14_q;
  logic and_2617_s14_q;
  logic equal_2678_s14_q;
  logic [5:0] difference_2682_s14_q;
  logic [7:0] sum_2684_s14_q;
  logic [11:0] select_2765_s14_q;
  logic and_2990_s14_q;
  logic less_3116_s14_q;
  logic [5:0] away_s14_q;
  logic [9:0] select_3545_s14_q;
  logic [4:0] select_3546_s14_q;
  logic equal_3556_s14_q;
  logic select_3855_s14_q;
  logic equal_3866_s14_q;
  logic equal_3891_s14_q;
  logic [7:0] select_3908_s14_q;
  logic and_4021_s14_q;
  logic equal_4031_s14_q;
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
      patches_along_s14_q <= patches_along_s13_q;
      patches_match_row_s14_q <= patches_match_row_s13_q;
      patches_summed_last_s14_q <= patches_summed_last_s13_q;
      patches_summed_down_by_s14_q <= patches_summed_down_by_q;
      patches_read_row_differing_s14_q <= patches_read_row_differing_s13_q;
      patches_read_first_s14_q <= patches_read_first_s13_q;
      region_row_s14_q <= region_row_q;
      region_fresh_s14_q <= region_fresh_q;
      select_509_s14_q <= select_509_s13_q;
      row_starts_s14_q <= row_starts_s13_q;
      select_514_s14_q <= select_514_s13_q;
      and_523_s14_q <= and_523_s13_q;
      and_524_s14_q <= and_524_s13_q;
      sum_531_s14_q <= sum_531;
      sum_535_s14_q <= sum_535;
      and_539_s14_q <= whole & (averager_memory_rdata_s13_q[28] | equal_529_s13_q);
      and_543_s14_q <= and_543;
      select_544_s14_q <= select_544_s13_q;
      last_s14_q <= last_s13_q;
      and_548_s14_q <= and_548_s13_q;
      and_550_s14_q <= and_550_s13_q;
      equal_553_s14_q <= select_509_s13_q == 4'h3;
      equal_570_s14_q <= equal_570_s13_q;
      select_574_s14_q <= select_574_s13_q;
      equal_575_s14_q <= equal_575_s13_q;
      not_576_s14_q <= not_576_s13_q;
      so_s14_q <= so_s13_q;
      not_578_s14_q <= not_578_s13_q;
      equal_579_s14_q <= equal_579_s13_q;
      or_580_s14_q <= or_580_s13_q;
      less_583_s14_q <= less_583_s13_q;
      not_584_s14_q <= not_584_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      not_588_s14_q <= not_588_s13_q;
      and_592_s14_q <= and_592;
      and_601_s14_q <= and_601_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[32:0];
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      and_635_s14_q <= and_635;
      and_640_s14_q <= and_640_s13_q;
      and_645_s14_q <= and_645_s13_q;
      and_647_s14_q <= and_647_s13_q;
      equal_680_s14_q <= equal_680_s13_q;
      select_762_s14_q <= select_762_s13_q;
      of_best_s14_q <= of_best;
      select_1522_s14_q <= select_1522;
      of_near_s14_q <= of_near;
      select_1552_s14_q <= less_1551 ? of_near : best_left_rdata_s13_q[39:33];
      select_1554_s14_q <= less_1551 ? run_shift_s13_q : best_left_rdata_s13_q[45:40];
      select_1557_s14_q <= select_1557_s13_q;
      select_1560_s14_q <= select_1560_s13_q;
      and_1562_s14_q <= and_1562_s13_q;
      select_1564_s14_q <= select_1564_s13_q;
      or_1570_s14_q <= select_1564_s13_q | (best_right_rdata_s13_q[21:15] < of_near);
      and_1573_s14_q <= and_1573_s13_q;
      and_1575_s14_q <= and_1575_s13_q;
      shown_right_rdata_s14_q <= shown_right_rdata_q;
      select_1579_s14_q <= select_1579_s13_q;
      and_1584_s14_q <= and_635 & or_1583_s13_q;
      left_turns_rdata_s14_q <= left_turns_rdata_q;
      and_1601_s14_q <= and_1601_s13_q;
      right_turns_rdata_s14_q <= right_turns_rdata_q;
      equal_1608_s14_q <= equal_1608;
      all_s14_q <= all;
      equal_1622_s14_q <= equal_1622;
      equal_1624_s14_q <= equal_1624;
      equal_1626_s14_q <= equal_1626;
      equal_1628_s14_q <= equal_1628;
      equal_1630_s14_q <= equal_1630;
      and_1635_s14_q <= (~equal_1622) & and_1634;
      right_2_s14_q <= right_2_s13_q;
      select_1689_s14_q <= select_1689;
      select_1690_s14_q <= select_1690[1];
      equal_1691_s14_q <= equal_1691;
      and_1699_s14_q <= and_1699_s13_q;
      less_1700_s14_q <= less_1700_s13_q;
      equal_1701_s14_q <= equal_1701_s13_q;
      expected_s14_q <= expected[0];
      sum_1716_s14_q <= {expected[10], expected[10:1]} + 11'h5;
      and_1733_s14_q <= and_1733_s13_q;
      select_1750_s14_q <= select_1750_s13_q;
      select_1776_s14_q <= select_1776_s13_q;
      and_1783_s14_q <= and_1783_s13_q;
      and_1784_s14_q <= and_1784_s13_q;
      equal_1785_s14_q <= equal_1785_s13_q;
      not_1786_s14_q <= not_1786_s13_q;
      equal_1787_s14_q <= equal_1787_s13_q;
      not_1788_s14_q <= not_1788_s13_q;
      equal_1790_s14_q <= equal_1790_s13_q;
      or_1791_s14_q <= or_1791_s13_q;
      not_1792_s14_q <= not_1792_s13_q;
      and_1800_s14_q <= and_1784_s13_q & equal_1799;
      select_1815_s14_q <= select_1815_s13_q;
      select_1821_s14_q <= select_1821_s13_q;
      select_1859_s14_q <= select_1859_s13_q;
      patches_columns_above_rdata_s14_q <= patches_columns_above_rdata_s13_q[8];
      pixel_2_s14_q <= pixel_2_s13_q;
      less_1875_s14_q <= less_1875;
      new_row_s14_q <= new_row;
      select_1881_s14_q <= select_1881;
      not_1882_s14_q <= ~or_1876;
      select_1887_s14_q <= select_1887;
      or_1888_s14_q <= equal_1789_s13_q | equal_1787_s13_q;
      of_row_2_s14_q <= of_row_2;
      down_2_s14_q <= down_2;
      sum_1918_s14_q <= sum_1918_s13_q[0];
      sum_1919_s14_q <= sum_1919;
      and_1946_s14_q <= or_1791_s13_q & (or_1938 & (equal_1790_s13_q & and_1943));
      and_1957_s14_q <= and_1957;
      and_1960_s14_q <= or_1791_s13_q & (and_1957 & (patches_column_s13_q == 5'hf));
      less_1963_s14_q <= less_1963_s13_q;
      equal_1964_s14_q <= equal_1964_s13_q;
      or_1966_s14_q <= or_1966_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      or_1980_s14_q <= or_1980;
      or_1983_s14_q <= or_1983;
      or_1986_s14_q <= or_1986;
      select_1987_s14_q <= select_1987;
      not_1988_s14_q <= not_1988;
      select_1996_s14_q <= equal_575_s13_q ? (x_s13_q[6] & not_1988) : and_1995;
      textured_s14_q <= textured;
      and_2011_s14_q <= and_2011_s13_q;
      and_2020_s14_q <= not_576_s13_q & and_1995;
      seen_columns_rdata_s14_q <= {seen_columns_rdata_s13_q[13:7], seen_columns_rdata_s13_q[5:0]};
      and_2061_s14_q <= seen_columns_rdata_s13_q[14] & inside_v_s13_q;
      and_2063_s14_q <= seen_columns_rdata_s13_q[5] & inside_v_s13_q;
      or_2078_s14_q <= or_2078;
      or_2081_s14_q <= select_2075[7] | (~({select_2075[6], select_2075[3:2]} == 3'h0));
      or_2084_s14_q <= select_2075[7] | (~(select_2075[6:4] == 3'h0));
      and_2095_s14_q <= seen_columns_rdata_s13_q[16] & inside_v_s13_q;
      and_2111_s14_q <= seen_columns_rdata_s13_q[17] & inside_v_s13_q;
      and_2134_s14_q <= and_2134_s13_q;
      equal_2277_s14_q <= equal_2277_s13_q;
      equal_2466_s14_q <= equal_2466_s13_q;
      and_2593_s14_q <= and_2593_s13_q;
      and_2617_s14_q <= seen_columns_rdata_s13_q[15] & inside_v_s13_q;
      equal_2678_s14_q <= equal_2678_s13_q;
      difference_2682_s14_q <= difference_2682[7:2];
      sum_2684_s14_q <= sum_2684_s13_q;
      select_2765_s14_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_2990_s14_q <= and_2990_s13_q;
      less_3116_s14_q <= 4'he < patches_column_s13_q[4:1];
      away_s14_q <= away;
      select_3545_s14_q <= patches_peak_best_differing_q;
      select_3546_s14_q <= patches_peak_best_column_q;
      equal_3556_s14_q <= equal_3556_s13_q;
      select_3855_s14_q <= sum_1990_s13_q ? (equal_1778_s13_q & or_1992) : or_1992;
      equal_3866_s14_q <= equal_3866;
      equal_3891_s14_q <= equal_3891;
      select_3908_s14_q <= select_3908;
      and_4021_s14_q <= seen_columns_rdata_s13_q[6] & inside_v_s13_q;
      equal_4031_s14_q <= equal_4031_s13_q;
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
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_523_s14_q ? sum_531_s14_q[13:5] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_553_s14_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_523_s14_q ? sum_535_s14_q[13:5] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_553_s14_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:218
  logic and_561;
  assign and_561 = and_523_s14_q & and_539_s14_q;
  // hls/stages/census.hpp:134
  logic select_563;
  assign select_563 = equal_553_s14_q ? and_561 : (averager_mask_q & and_561);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s14_q & select_563;
  // hls/stages/census.hpp:218
  logic and_565;
  assign and_565 = and_523_s14_q & and_543_s14_q;
  // hls/stages/census.hpp:134
  logic select_567;
  assign select_567 = equal_553_s14_q ? and_565 : (averager_of_skin_q & and_565);
  // hls/stages/agreement.hpp:149
  logic and_637;
  assign and_637 = or_580_s14_q & (not_584_s14_q & and_635_s14_q);
  // hls/stages/moments.hpp:77
  logic and_638;
  assign and_638 = and_601_s14_q & and_637;
  // hls/stages/agreement.hpp:810
  logic equal_1525;
  assign equal_1525 = select_1522_s14_q == 3'h1;
  logic or_1528;
  assign or_1528 = equal_1525 | (~(select_1522_s14_q == 3'h2));
  logic [7:0] select_1530;
  assign select_1530 = or_1528 ? before_0_s14_q : before_1_s14_q;
  logic [7:0] select_1531;
  assign select_1531 = equal_1525 ? (or_1528 ? before_1_q : {7'h0, shift_not_right_s14_q}) : select_1530;
  // hls/stages/agreement.hpp:811
  logic [7:0] select_1534;
  assign select_1534 = equal_1525 ? select_1530 : (or_1528 ? before_2_q : before_2_s14_q);
  // hls/stages/agreement.hpp:824
  logic or_1566;
  assign or_1566 = select_1564_s14_q | (best_right_rdata_s14_q[7:0] < of_best_s14_q);
  // hls/stages/agreement.hpp:149
  logic and_1586;
  assign and_1586 = or_580_s14_q & (not_584_s14_q & and_1584_s14_q);
  // hls/stages/agreement.hpp:788
  logic and_1590;
  assign and_1590 = not_576_s14_q & (so_s14_q ? and_1573_s14_q : (equal_579_s14_q & and_637));
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s14_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1611;
  assign select_1611 = x_s14_q[4] ? {x_s14_q[3], x_s14_q[0]} : {x_s14_q[0], x_s14_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1613;
  assign select_1613 = equal_1608_s14_q ? {2'h0, quarter} : (all_s14_q ? {1'b0, x_s14_q[2:0]} : {x_s14_q[2:1], select_1611});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1614;
  assign sum_1614 = slot_s14_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1615;
  assign select_1615 = equal_575_s14_q ? select_1613 : {sum_1614, lower_half_s14_q, registration_of_right_q};
  // hls/stages/patches.hpp:214
  logic equal_1616;
  assign equal_1616 = x_s14_q[5:0] == 6'h3f;
  logic equal_1618;
  assign equal_1618 = x_s14_q[5:0] == 6'h3e;
  logic equal_1620;
  assign equal_1620 = x_s14_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1178
  logic and_1638;
  assign and_1638 = (~equal_1616) & ((~equal_1618) & ((~equal_1620) & and_1635_s14_q));
  // hls/stages/agreement.hpp:1129
  logic less_1639;
  assign less_1639 = x_s14_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s14_q ? {1'b0, x_s14_q[2]} : x_s14_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1643;
  assign or_1643 = (kind == 2'h3) | (x_s14_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s14_q ? (right_2_s14_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1654;
  assign sum_1654 = {2'h0, slot_s14_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1660;
  assign not_1660 = ~lower_half_s14_q;
  logic [3:0] select_1661;
  assign select_1661 = registration_of_right_q ? {lower_half_s14_q, 1'b0, not_1660, 1'b0} : {1'b0, lower_half_s14_q, 1'b0, not_1660};
  // hls/stages/patches.hpp:98
  logic less_1717;
  assign less_1717 = {{4{sum_1716_s14_q[10]}}, sum_1716_s14_q, expected_s14_q} < 16'h15;
  // hls/stages/patches.hpp:475
  logic [11:0] sum_1900;
  assign sum_1900 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1901;
  assign sum_1901 = {{4{down_2_s14_q[10]}}, down_2_s14_q[10:2]} + {sum_1900[11], sum_1900};
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_1919_s14_q, sum_1918_s14_q, patches_columns_above_rdata_s14_q} + {4'h0, pixel_2_s14_q};
  // hls/stages/agreement.hpp:149
  logic and_2013;
  assign and_2013 = or_580_s14_q & (not_584_s14_q & and_2011_s14_q);
  // hls/stages/agreement.hpp:1014
  logic select_2023;
  assign select_2023 = slot_s14_q[2] ? shown_shown_q : and_637;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s14_q & (shown_right_rdata_s14_q[0] | select_2023);
  // hls/stages/agreement.hpp:1014
  logic select_2026;
  assign select_2026 = slot_s14_q[2] ? shown_nearer_q : and_1586;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s14_q & (select_2023 ? select_2026 : shown_right_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2168;
  assign select_2168 = sample_pair_whole_s14_q ? (and_548_s14_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2170;
  assign select_2170 = sample_pair_whole_s14_q ? (and_548_s14_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2192;
  assign select_2192 = sample_pair_whole_s14_q ? (and_548_s14_q ? select_563 : averager_mask_q) : averager_mask_q;
  logic select_2194;
  assign select_2194 = sample_pair_whole_s14_q ? (and_548_s14_q ? select_567 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:788
  logic and_2597;
  assign and_2597 = not_576_s14_q & (so_s14_q & (ends_cell_s14_q & (inside_v_s14_q & and_2593_s14_q)));
  // hls/stages/agreement.hpp:1105
  logic not_2616;
  assign not_2616 = ~(x_s14_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:788
  logic and_2658;
  assign and_2658 = so_s14_q & (ends_cell_s14_q & (inside_v_s14_q & (and_2593_s14_q & and_2013)));
  // hls/stages/agreement.hpp:1110
  logic and_2663;
  assign and_2663 = not_2616 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:247
  logic and_2687;
  assign and_2687 = ((and_2011_s14_q & and_635_s14_q) & equal_2678_s14_q) & (~({2'h0, difference_2682_s14_q} < sum_2684_s14_q));
  // hls/stages/agreement.hpp:149
  logic and_2697;
  assign and_2697 = not_584_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2699;
  assign and_2699 = not_584_s14_q & (slot_s14_q[2] & left_turns_rdata_s14_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2700;
  assign select_2700 = or_580_s14_q ? {and_2699, and_2697} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2702;
  assign select_2702 = less_583_s14_q ? 2'h0 : (slot_s14_q[2] ? right_turns_rdata_s14_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2703;
  assign select_2703 = or_580_s14_q ? select_2702 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2748;
  assign equal_2748 = slot_s14_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2765_s14_q[11:7])) ? 12'h7f : select_2765_s14_q;
  // hls/stages/agreement.hpp:788
  logic select_2809;
  assign select_2809 = so_s14_q ? (equal_2748 ? right_2_s14_q : registration_of_right_q) : registration_of_right_q;
  logic select_2812;
  assign select_2812 = so_s14_q ? (equal_1701_s14_q ? inside_v_s14_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all_s14_q ? x_s14_q[1:0] : select_1611;
  // hls/stages/agreement.hpp:275
  logic [10:0] select_3094;
  assign select_3094 = equal_1787_s14_q ? patches_down_values_0_q : (or_1791_s14_q ? down_2_s14_q : patches_down_values_0_q);
  logic [10:0] select_3096;
  assign select_3096 = or_1791_s14_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3098;
  assign select_3098 = equal_1785_s14_q ? patches_down_values_1_q : (equal_1787_s14_q ? patches_down_values_1_q : select_3096);
  // hls/stages/patches.hpp:559
  logic and_3530;
  assign and_3530 = less_1963_s14_q & (or_1966_s14_q & (equal_1964_s14_q & (away_s14_q == 6'h3f)));
  logic and_3535;
  assign and_3535 = less_1963_s14_q & (or_1966_s14_q & (equal_1964_s14_q & (away_s14_q == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3537;
  assign sum_3537 = {away_s14_q[5], away_s14_q} + 7'h7d;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3548;
  assign select_3548 = patches_read_above_q ? patches_read_row_differing_s14_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3549;
  assign select_3549 = equal_1785_s14_q ? select_3548 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_3550;
  assign select_3550 = patches_read_below_q ? patches_read_row_differing_s14_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3551;
  assign select_3551 = equal_1785_s14_q ? select_3550 : patches_peak_below_q;
  // hls/stages/agreement.hpp:788
  logic select_3809;
  assign select_3809 = equal_575_s14_q ? shown_shown_q : (so_s14_q ? select_2023 : shown_shown_q);
  logic select_3811;
  assign select_3811 = equal_575_s14_q ? shown_nearer_q : (so_s14_q ? select_2026 : shown_nearer_q);
  // hls/stages/agreement.hpp:205
  logic or_3853;
  assign or_3853 = segment_starts_q | not_578_s14_q;
  // hls/stages/agreement.hpp:788
  logic select_3857;
  assign select_3857 = ends_cell_s14_q ? (inside_v_s14_q ? select_3855_s14_q : or_3853) : or_3853;
  // hls/stages/agreement.hpp:1217
  logic equal_3886;
  assign equal_3886 = x_s14_q[6:3] == 4'ha;
  logic equal_3889;
  assign equal_3889 = x_s14_q[6:3] == 4'hb;
  logic equal_3890;
  assign equal_3890 = x_s14_q[6:3] == 4'h9;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3910;
  assign select_3910 = equal_3886 ? cfg_regions_limit_i : (equal_3890 ? cfg_hidden_limit_i : select_3908_s14_q);
  // hls/stages/agreement.hpp:788
  logic select_4019;
  assign select_4019 = so_s14_q ? (ends_cell_s14_q ? and_2063_s14_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4023;
  assign select_4023 = so_s14_q ? (ends_cell_s14_q ? and_4021_s14_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4025;
  assign select_4025 = ends_cell_s14_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4027;
  assign select_4027 = equal_575_s14_q ? centres_values_1_textured_q : (so_s14_q ? select_4025 : centres_values_1_textured_q);
  logic select_4028;
  assign select_4028 = ends_cell_s14_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4030;
  assign select_4030 = equal_575_s14_q ? centres_values_1_of_skin_q : (so_s14_q ? select_4028 : centres_values_1_of_skin_q);

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:777; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1689_s14_q;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s14_en & (sample_pair_whole_s14_q & (~equal_1691_s14_q));
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
  assign patches_right_codes_raddr = {select_1887_s14_q, not_1882_s14_q, select_1881_s14_q};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s14_en & or_1888_s14_q;
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
  assign patches_left_codes_re = s14_en & (not_1786_s14_q & (new_row_s14_q & equal_1787_s14_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
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
  assign regions_raddr = select_1987_s14_q;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s14_en & select_1996_s14_q;
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_514_s14_q;
  logic averager_memory_we;
  assign averager_memory_we = s14_en & and_524_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_543_s14_q, and_539_s14_q, sum_535_s14_q, sum_531_s14_q};
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
  assign moments_memory_waddr = select_574_s14_q;
  logic moments_memory_we;
  assign moments_memory_we = s14_en & and_592_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_647_s14_q, and_645_s14_q, and_640_s14_q, and_638};
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
    end else if (s14_en) begin
      averager_mask_q <= select_2192;
      averager_of_skin_q <= select_2194;
      registration_of_right_q <= equal_575_s14_q ? registration_of_right_q : select_2809;
      registration_was_inside_q <= equal_575_s14_q ? registration_was_inside_q : select_2812;
      patches_down_values_0_q <= equal_1785_s14_q ? patches_down_values_0_q : select_3094;
      patches_down_values_1_q <= select_3098;
      patches_read_above_q <= equal_1785_s14_q ? and_3530 : patches_read_above_q;
      patches_read_below_q <= equal_1785_s14_q ? and_3535 : patches_read_below_q;
      patches_peak_above_q <= select_3549;
      patches_peak_below_q <= select_3551;
      shown_shown_q <= select_3809;
      shown_nearer_q <= select_3811;
      segment_starts_q <= equal_575_s14_q ? or_3853 : (so_s14_q ? select_3857 : or_3853);
      centres_values_0_textured_q <= equal_575_s14_q ? centres_values_0_textured_q : select_4019;
      centres_values_0_of_skin_q <= equal_575_s14_q ? centres_values_0_of_skin_q : select_4023;
      centres_values_1_textured_q <= select_4027;
      centres_values_1_of_skin_q <= select_4030;
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
      averager_total_0_q <= select_2168;
      averager_total_1_q <= select_2170;
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
  logic [3:0] select_509_s15_q;
  logic row_starts_s15_q;
  logic [6:0] select_544_s15_q;
  logic [6:0] last_s15_q;
  logic and_548_s15_q;
  logic and_550_s15_q;
  logic [77:0] census_memory_rdata_s15_q;
  logic [8:0] grey_s15_q;
  logic equal_553_s15_q;
  logic [8:0] select_556_s15_q;
  logic [8:0] grey_2_s15_q;
  logic [8:0] select_560_s15_q;
  logic whole_2_s15_q;
  logic and_568_s15_q;
  logic equal_570_s15_q;
  logic equal_575_s15_q;
  logic not_576_s15_q;
  logic so_s15_q;
  logic not_578_s15_q;
  logic equal_579_s15_q;
  logic inside_v_s15_q;
  logic not_588_s15_q;
  logic [3:0] moments_memory_rdata_s15_q;
  logic [6:0] x_s15_2_q;
  logic [32:0] best_left_rdata_s15_q;
  logic [6:0] right_s15_q;
  logic [14:0] best_right_rdata_s15_q;
  logic and_637_s15_q;
  logic and_640_s15_q;
  logic and_647_s15_q;
  logic equal_680_s15_q;
  logic [7:0] of_best_s15_q;
  logic or_1517_s15_q;
  logic [2:0] select_1522_s15_q;
  logic [7:0] select_1531_s15_q;
  logic [7:0] select_1534_s15_q;
  logic [6:0] select_1553_s15_q;
  logic [5:0] select_1555_s15_q;
  logic [7:0] select_1558_s15_q;
  logic [7:0] select_1561_s15_q;
  logic and_1562_s15_q;
  logic or_1566_s15_q;
  logic [6:0] select_1571_s15_q;
  logic [6:0] select_1572_s15_q;
  logic and_1575_s15_q;
  logic [6:0] select_1579_s15_q;
  logic and_1586_s15_q;
  logic and_1590_s15_q;
  logic and_1601_s15_q;
  logic equal_1608_s15_q;
  logic [1:0] quarter_s15_q;
  logic all_s15_q;
  logic [1:0] sum_1614_s15_q;
  logic [3:0] select_1615_s15_q;
  logic equal_1616_s15_q;
  logic equal_1618_s15_q;
  logic equal_1620_s15_q;
  logic equal_1622_s15_q;
  logic equal_1624_s15_q;
  logic equal_1626_s15_q;
  logic equal_1628_s15_q;
  logic equal_1630_s15_q;
  logic less_1639_s15_q;
  logic or_1643_s15_q;
  logic select_1646_s15_q;
  logic and_1656_s15_q;
  logic [3:0] select_1661_s15_q;
  logic select_1690_s15_q;
  logic equal_1691_s15_q;
  logic and_1699_s15_q;
  logic equal_1701_s15_q;
  logic and_1734_s15_q;
  logic [5:0] select_1750_s15_q;
  logic [7:0] select_1776_s15_q;
  logic and_1783_s15_q;
  logic and_1784_s15_q;
  logic equal_1785_s15_q;
  logic equal_1787_s15_q;
  logic equal_1790_s15_q;
  logic or_1791_s15_q;
  logic not_1792_s15_q;
  logic and_1800_s15_q;
  logic [4:0] select_1815_s15_q;
  logic select_1821_s15_q;
  logic [3:0] select_1859_s15_q;
  logic less_1875_s15_q;
  logic new_row_s15_q;
  logic or_1888_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [1:0] down_2_s15_q;
  logic [12:0] sum_1901_s15_q;
  logic [11:0] smooth_s15_q;
  logic and_1948_s15_q;
  logic and_1957_s15_q;
  logic and_1962_s15_q;
  logic less_1963_s15_q;
  logic or_1966_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic or_1980_s15_q;
  logic or_1983_s15_q;
  logic or_1986_s15_q;
  logic not_1988_s15_q;
  logic textured_s15_q;
  logic and_2013_s15_q;
  logic and_2020_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic shown_s15_q;
  logic near_s15_q;
  logic and_2061_s15_q;
  logic and_2063_s15_q;
  logic or_2078_s15_q;
  logic or_2081_s15_q;
  logic or_2084_s15_q;
  logic and_2095_s15_q;
  logic and_2097_s15_q;
  logic and_2098_s15_q;
  logic and_2111_s15_q;
  logic and_2113_s15_q;
  logic and_2114_s15_q;
  logic and_2134_s15_q;
  logic equal_2277_s15_q;
  logic equal_2466_s15_q;
  logic and_2597_s15_q;
  logic not_2616_s15_q;
  logic and_2617_s15_q;
  logic and_2619_s15_q;
  logic and_2620_s15_q;
  logic and_2659_s15_q;
  logic and_2666_s15_q;
  logic and_2690_s15_q;
  logic select_2700_s15_q;
  logic select_2703_s15_q;
  logic and_2704_s15_q;
  logic and_2751_s15_q;
  logic and_2752_s15_q;
  logic [11:0] residual_s15_q;
  logic equal_2814_s15_q;
  logic [3:0] not_2815_s15_q;
  logic [1:0] quarter_2_s15_q;
  logic and_2990_s15_q;
  logic less_3116_s15_q;
  logic equal_3459_s15_q;
  logic and_3539_s15_q;
  logic [9:0] select_3545_s15_q;
  logic [4:0] select_3546_s15_q;
  logic [4:0] select_3547_s15_q;
  logic equal_3556_s15_q;
  logic less_3584_s15_q;
  logic less_3587_s15_q;
  logic equal_3866_s15_q;
  logic equal_3886_s15_q;
  logic equal_3889_s15_q;
  logic equal_3890_s15_q;
  logic equal_3891_s15_q;
  logic [7:0] select_3911_s15_q;
  logic equal_4031_s15_q;
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
      select_509_s15_q <= select_509_s14_q;
      row_starts_s15_q <= row_starts_s14_q;
      select_544_s15_q <= select_544_s14_q;
      last_s15_q <= last_s14_q;
      and_548_s15_q <= and_548_s14_q;
      and_550_s15_q <= and_550_s14_q;
      census_memory_rdata_s15_q <= census_memory_rdata_q;
      grey_s15_q <= grey;
      equal_553_s15_q <= equal_553_s14_q;
      select_556_s15_q <= sample_pair_whole_s14_q ? total[10:2] : 9'h0;
      grey_2_s15_q <= grey_2;
      select_560_s15_q <= sample_pair_whole_s14_q ? total_2[10:2] : 9'h0;
      whole_2_s15_q <= whole_2;
      and_568_s15_q <= sample_pair_whole_s14_q & select_567;
      equal_570_s15_q <= equal_570_s14_q;
      equal_575_s15_q <= equal_575_s14_q;
      not_576_s15_q <= not_576_s14_q;
      so_s15_q <= so_s14_q;
      not_578_s15_q <= not_578_s14_q;
      equal_579_s15_q <= equal_579_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      not_588_s15_q <= not_588_s14_q;
      moments_memory_rdata_s15_q <= moments_memory_rdata_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q[14:0];
      and_637_s15_q <= and_637;
      and_640_s15_q <= and_640_s14_q;
      and_647_s15_q <= and_647_s14_q;
      equal_680_s15_q <= equal_680_s14_q;
      of_best_s15_q <= of_best_s14_q;
      or_1517_s15_q <= select_762_s14_q | (best_left_rdata_s14_q[16:9] < of_best_s14_q);
      select_1522_s15_q <= select_1522_s14_q;
      select_1531_s15_q <= select_1531;
      select_1534_s15_q <= select_1534;
      select_1553_s15_q <= select_762_s14_q ? of_near_s14_q : select_1552_s14_q;
      select_1555_s15_q <= select_762_s14_q ? run_shift_s14_q : select_1554_s14_q;
      select_1558_s15_q <= (run_shift_s14_q == 6'h3f) ? of_best_s14_q : select_1557_s14_q;
      select_1561_s15_q <= (run_shift_s14_q == 6'h1) ? of_best_s14_q : select_1560_s14_q;
      and_1562_s15_q <= and_1562_s14_q;
      or_1566_s15_q <= or_1566;
      select_1571_s15_q <= or_1570_s14_q ? of_near_s14_q : best_right_rdata_s14_q[21:15];
      select_1572_s15_q <= or_1570_s14_q ? x_s14_2_q : best_right_rdata_s14_q[28:22];
      and_1575_s15_q <= and_1575_s14_q;
      select_1579_s15_q <= select_1579_s14_q;
      and_1586_s15_q <= and_1586;
      and_1590_s15_q <= and_1590;
      and_1601_s15_q <= and_1601_s14_q;
      equal_1608_s15_q <= equal_1608_s14_q;
      quarter_s15_q <= quarter;
      all_s15_q <= all_s14_q;
      sum_1614_s15_q <= sum_1614;
      select_1615_s15_q <= select_1615;
      equal_1616_s15_q <= equal_1616;
      equal_1618_s15_q <= equal_1618;
      equal_1620_s15_q <= equal_1620;
      equal_1622_s15_q <= equal_1622_s14_q;
      equal_1624_s15_q <= equal_1624_s14_q;
      equal_1626_s15_q <= equal_1626_s14_q;
      equal_1628_s15_q <= equal_1628_s14_q;
      equal_1630_s15_q <= equal_1630_s14_q;
      less_1639_s15_q <= less_1639;
      or_1643_s15_q <= or_1643;
      select_1646_s15_q <= equal_1608_s14_q ? and_1638 : (less_1639 & (~or_1643));
      and_1656_s15_q <= half_ends & ({{3{sum_1654[4]}}, sum_1654} < 8'h3);
      select_1661_s15_q <= select_1661;
      select_1690_s15_q <= select_1690_s14_q;
      equal_1691_s15_q <= equal_1691_s14_q;
      and_1699_s15_q <= and_1699_s14_q;
      equal_1701_s15_q <= equal_1701_s14_q;
      and_1734_s15_q <= (less_1700_s14_q & (and_637 & less_1717)) & and_1733_s14_q;
      select_1750_s15_q <= select_1750_s14_q;
      select_1776_s15_q <= select_1776_s14_q;
      and_1783_s15_q <= and_1783_s14_q;
      and_1784_s15_q <= and_1784_s14_q;
      equal_1785_s15_q <= equal_1785_s14_q;
      equal_1787_s15_q <= equal_1787_s14_q;
      equal_1790_s15_q <= equal_1790_s14_q;
      or_1791_s15_q <= or_1791_s14_q;
      not_1792_s15_q <= not_1792_s14_q;
      and_1800_s15_q <= and_1800_s14_q;
      select_1815_s15_q <= select_1815_s14_q;
      select_1821_s15_q <= select_1821_s14_q;
      select_1859_s15_q <= select_1859_s14_q;
      less_1875_s15_q <= less_1875_s14_q;
      new_row_s15_q <= new_row_s14_q;
      or_1888_s15_q <= or_1888_s14_q;
      of_row_2_s15_q <= of_row_2_s14_q;
      down_2_s15_q <= down_2_s14_q[1:0];
      sum_1901_s15_q <= sum_1901;
      smooth_s15_q <= smooth;
      and_1948_s15_q <= not_1786_s14_q & (not_1788_s14_q & and_1946_s14_q);
      and_1957_s15_q <= and_1957_s14_q;
      and_1962_s15_q <= not_1786_s14_q & (not_1788_s14_q & and_1960_s14_q);
      less_1963_s15_q <= less_1963_s14_q;
      or_1966_s15_q <= or_1966_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      or_1980_s15_q <= or_1980_s14_q;
      or_1983_s15_q <= or_1983_s14_q;
      or_1986_s15_q <= or_1986_s14_q;
      not_1988_s15_q <= not_1988_s14_q;
      textured_s15_q <= textured_s14_q;
      and_2013_s15_q <= and_2013;
      and_2020_s15_q <= and_2020_s14_q;
      seen_columns_rdata_s15_q <= seen_columns_rdata_s14_q;
      shown_s15_q <= shown;
      near_s15_q <= near;
      and_2061_s15_q <= and_2061_s14_q;
      and_2063_s15_q <= and_2063_s14_q;
      or_2078_s15_q <= or_2078_s14_q;
      or_2081_s15_q <= or_2081_s14_q;
      or_2084_s15_q <= or_2084_s14_q;
      and_2095_s15_q <= and_2095_s14_q;
      and_2097_s15_q <= seen_columns_rdata_s14_q[7] & inside_v_s14_q;
      and_2098_s15_q <= seen_columns_rdata_s14_q[3] & inside_v_s14_q;
      and_2111_s15_q <= and_2111_s14_q;
      and_2113_s15_q <= seen_columns_rdata_s14_q[8] & inside_v_s14_q;
      and_2114_s15_q <= seen_columns_rdata_s14_q[4] & inside_v_s14_q;
      and_2134_s15_q <= and_2134_s14_q;
      equal_2277_s15_q <= equal_2277_s14_q;
      equal_2466_s15_q <= equal_2466_s14_q;
      and_2597_s15_q <= and_2597;
      not_2616_s15_q <= not_2616;
      and_2617_s15_q <= and_2617_s14_q;
      and_2619_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      and_2620_s15_q <= seen_columns_rdata_s14_q[2] & inside_v_s14_q;
      and_2659_s15_q <= not_576_s14_q & and_2658;
      and_2666_s15_q <= not_576_s14_q & (so_s14_q & (ends_cell_s14_q & and_2663));
      and_2690_s15_q <= inside_v_s14_q & (or_580_s14_q & (not_584_s14_q & and_2687));
      select_2700_s15_q <= select_2700[1];
      select_2703_s15_q <= select_2703[1];
      and_2704_s15_q <= select_2700[0] & select_2703[0];
      and_2751_s15_q <= not_576_s14_q & (so_s14_q & (half_ends & equal_2748));
      and_2752_s15_q <= and_637 & less_1700_s14_q;
      residual_s15_q <= residual;
      equal_2814_s15_q <= sum_1614 == 2'h2;
      not_2815_s15_q <= ~select_1661;
      quarter_2_s15_q <= quarter_2;
      and_2990_s15_q <= and_2990_s14_q;
      less_3116_s15_q <= less_3116_s14_q;
      equal_3459_s15_q <= patches_match_row_s14_q == 4'h0;
      and_3539_s15_q <= equal_1964_s14_q & ({sum_3537[6], sum_3537} < 8'hfb);
      select_3545_s15_q <= select_3545_s14_q;
      select_3546_s15_q <= select_3546_s14_q;
      select_3547_s15_q <= patches_peak_row_q;
      equal_3556_s15_q <= equal_3556_s14_q;
      less_3584_s15_q <= select_3549 < select_3551;
      less_3587_s15_q <= select_3551 < select_3549;
      equal_3866_s15_q <= equal_3866_s14_q;
      equal_3886_s15_q <= equal_3886;
      equal_3889_s15_q <= equal_3889;
      equal_3890_s15_q <= equal_3890;
      equal_3891_s15_q <= equal_3891_s14_q;
      select_3911_s15_q <= equal_3889 ? {cfg_on_skin_limit_i, 3'h0} : select_3910;
      equal_4031_s15_q <= equal_4031_s14_q;
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
  logic less_653;
  assign less_653 = census_memory_rdata_s15_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_memory_rdata_s15_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_663;
  assign less_663 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_664;
  assign less_664 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_665;
  assign less_665 = census_memory_rdata_s15_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_memory_rdata_s15_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_675;
  assign less_675 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_676;
  assign less_676 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_677;
  assign equal_677 = last_s15_q == 7'h0;
  logic [3:0] select_681;
  assign select_681 = equal_680_s15_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_682;
  assign select_682 = equal_677 ? {select_681, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_683;
  assign select_683 = equal_677 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:300
  logic and_686;
  assign and_686 = census_memory_rdata_s15_q[38] & (census_memory_rdata_s15_q[18] & whole_2_s15_q);
  logic and_688;
  assign and_688 = census_memory_rdata_s15_q[77] & (census_memory_rdata_s15_q[58] & and_686);
  // hls/stages/census.hpp:284
  logic [9:0] difference_711;
  assign difference_711 = {1'b0, select_556_s15_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_714;
  assign difference_714 = {1'b0, census_memory_rdata_s15_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_718;
  assign difference_718 = {1'b0, census_memory_rdata_s15_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_722;
  assign difference_722 = {1'b0, census_memory_rdata_s15_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_726;
  assign difference_726 = {1'b0, census_memory_rdata_s15_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/agreement.hpp:788
  logic and_1587;
  assign and_1587 = not_578_s15_q & and_1586_s15_q;
  // hls/stages/moments.hpp:73
  logic and_1594;
  assign and_1594 = moments_has_before_q & moments_memory_rdata_s15_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1598;
  assign and_1598 = not_588_s15_q & (and_1594 & (moments_memory_rdata_s15_q[1] ^ and_640_s15_q));
  // hls/stages/moments.hpp:73
  logic and_1603;
  assign and_1603 = moments_has_before_q & moments_memory_rdata_s15_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1607;
  assign and_1607 = not_588_s15_q & (and_1603 & (moments_memory_rdata_s15_q[3] ^ and_647_s15_q));
  // hls/stages/agreement.hpp:788
  logic and_1657;
  assign and_1657 = so_s15_q & and_1656_s15_q;
  logic and_1738;
  assign and_1738 = not_576_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_1734_s15_q)));
  logic [7:0] select_1744;
  assign select_1744 = so_s15_q ? (ends_cell_s15_q ? (inside_v_s15_q ? x_s15_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:475
  logic [13:0] sum_1902;
  assign sum_1902 = {{3{patches_down_values_1_s15_q[10]}}, patches_down_values_1_s15_q} + {sum_1901_s15_q, down_2_s15_q[1]};
  logic [12:0] sum_1903;
  assign sum_1903 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1902[13:1];
  // hls/stages/patches.hpp:474
  logic [12:0] sum_1921;
  assign sum_1921 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s15_q[11:1]};
  logic [12:0] sum_1922;
  assign sum_1922 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1923;
  assign difference_1923 = {1'b0, sum_1921, smooth_s15_q[0]} - {1'b0, sum_1922, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:262
  logic explained;
  assign explained = inside_v_s15_q & and_637_s15_q;
  logic and_2022;
  assign and_2022 = inside_v_s15_q & and_2013_s15_q;
  // hls/stages/agreement.hpp:1030
  logic and_2064;
  assign and_2064 = seen_columns_rdata_s15_q[0] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2066;
  assign sum_2066 = {1'b0, and_2063_s15_q} + ({1'b0, textured_s15_q} + {1'b0, and_2064});
  // hls/stages/agreement.hpp:1030
  logic and_2096;
  assign and_2096 = seen_columns_rdata_s15_q[11] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2100;
  assign sum_2100 = {1'b0, and_2097_s15_q} + ({1'b0, shown_s15_q} + {1'b0, and_2098_s15_q});
  // hls/stages/agreement.hpp:1030
  logic and_2112;
  assign and_2112 = seen_columns_rdata_s15_q[12] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2116;
  assign sum_2116 = {1'b0, and_2113_s15_q} + ({1'b0, near_s15_q} + {1'b0, and_2114_s15_q});
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2160;
  assign select_2160 = sample_pair_whole_s15_q ? (and_548_s15_q ? grey_s15_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2162;
  assign select_2162 = sample_pair_whole_s15_q ? (and_548_s15_q ? grey_2_s15_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2164;
  assign select_2164 = sample_pair_whole_s15_q ? (and_548_s15_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2166;
  assign select_2166 = sample_pair_whole_s15_q ? (and_548_s15_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2171;
  assign sum_2171 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s15_q};
  logic [9:0] sum_2179;
  assign sum_2179 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s15_q};
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2195;
  assign select_2195 = and_550_s15_q ? select_556_s15_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2196;
  assign select_2196 = and_550_s15_q ? select_560_s15_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2198;
  assign select_2198 = and_550_s15_q ? census_memory_rdata_s15_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2199;
  assign select_2199 = and_550_s15_q ? census_memory_rdata_s15_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2200;
  assign select_2200 = and_550_s15_q ? census_memory_rdata_s15_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2201;
  assign select_2201 = and_550_s15_q ? census_memory_rdata_s15_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_550_s15_q ? census_memory_rdata_s15_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2203;
  assign select_2203 = and_550_s15_q ? census_memory_rdata_s15_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2204;
  assign select_2204 = and_550_s15_q ? census_memory_rdata_s15_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2205;
  assign select_2205 = and_550_s15_q ? census_memory_rdata_s15_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2206;
  assign select_2206 = and_550_s15_q ? census_memory_rdata_s15_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2207;
  assign select_2207 = and_550_s15_q ? census_memory_rdata_s15_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2208;
  assign select_2208 = and_550_s15_q ? census_memory_rdata_s15_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_550_s15_q ? census_memory_rdata_s15_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2210;
  assign select_2210 = and_550_s15_q ? census_memory_rdata_s15_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2211;
  assign select_2211 = and_550_s15_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_550_s15_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2214;
  assign select_2214 = and_550_s15_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_550_s15_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2217;
  assign select_2217 = and_550_s15_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_550_s15_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2220;
  assign select_2220 = and_550_s15_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2221;
  assign select_2221 = and_550_s15_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2222;
  assign select_2222 = and_550_s15_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2224;
  assign select_2224 = and_550_s15_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_550_s15_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2227;
  assign select_2227 = and_550_s15_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_550_s15_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2230;
  assign select_2230 = and_550_s15_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_550_s15_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2233;
  assign select_2233 = and_550_s15_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_550_s15_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2236;
  assign select_2236 = and_550_s15_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2237;
  assign select_2237 = and_550_s15_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2239;
  assign select_2239 = and_550_s15_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2240;
  assign select_2240 = and_550_s15_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2243;
  assign select_2243 = and_550_s15_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2244;
  assign select_2244 = and_550_s15_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2247;
  assign select_2247 = and_550_s15_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2248;
  assign select_2248 = and_550_s15_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2252;
  assign difference_2252 = {1'b0, select_560_s15_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2255;
  assign difference_2255 = {1'b0, census_memory_rdata_s15_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2259;
  assign difference_2259 = {1'b0, census_memory_rdata_s15_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2263;
  assign difference_2263 = {1'b0, census_memory_rdata_s15_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2267;
  assign difference_2267 = {1'b0, census_memory_rdata_s15_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/agreement.hpp:1142
  logic equal_2292;
  assign equal_2292 = x_s15_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:788
  logic select_2298;
  assign select_2298 = equal_575_s15_q ? (moments_has_before_q | equal_2292) : moments_has_before_q;
  // hls/stages/census.hpp:371
  logic [9:0] difference_2363;
  assign difference_2363 = {1'b0, select_556_s15_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2375;
  assign difference_2375 = {1'b0, select_560_s15_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:520
  logic and_2591;
  assign and_2591 = and_550_s15_q & (equal_680_s15_q & equal_2466_s15_q);
  // hls/stages/agreement.hpp:788
  logic and_2602;
  assign and_2602 = not_576_s15_q & (so_s15_q & (ends_cell_s15_q & textured_s15_q));
  // hls/stages/agreement.hpp:1030
  logic and_2618;
  assign and_2618 = seen_columns_rdata_s15_q[10] & inside_v_s15_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2622;
  assign sum_2622 = {1'b0, and_2619_s15_q} + ({1'b0, explained} + {1'b0, and_2620_s15_q});
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2661;
  assign select_2661 = and_2591 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2659_s15_q});
  logic [13:0] select_2668;
  assign select_2668 = and_2591 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2666_s15_q});
  // hls/stages/agreement.hpp:1027
  logic and_2705;
  assign and_2705 = and_637_s15_q & and_2704_s15_q;
  // hls/stages/agreement.hpp:788
  logic and_2708;
  assign and_2708 = ends_cell_s15_q & (inside_v_s15_q & (select_2700_s15_q & and_2705));
  logic and_2715;
  assign and_2715 = ends_cell_s15_q & (inside_v_s15_q & (select_2703_s15_q & and_2705));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2786;
  assign difference_2786 = 13'h0 - {residual_s15_q[11], residual_s15_q};
  logic less_2801;
  assign less_2801 = $signed(difference_2786) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2817;
  assign select_2817 = equal_2814_s15_q ? (registration_fresh_q & not_2815_s15_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2819;
  assign select_2819 = so_s15_q ? (and_1656_s15_q ? select_2817 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2821;
  assign select_2821 = and_2591 ? 4'hf : (equal_575_s15_q ? registration_fresh_q : select_2819);
  // hls/stages/registration.hpp:258
  logic not_2842;
  assign not_2842 = ~quarter_2_s15_q[1];
  logic [3:0] select_2843;
  assign select_2843 = quarter_2_s15_q[0] ? {quarter_2_s15_q[1], 1'b0, not_2842, 1'b0} : {1'b0, quarter_2_s15_q[1], 1'b0, not_2842};
  // hls/stages/agreement.hpp:275
  logic [11:0] select_3082;
  assign select_3082 = equal_1787_s15_q ? patches_smooth_values_0_q : (or_1791_s15_q ? smooth_s15_q : patches_smooth_values_0_q);
  logic [11:0] select_3084;
  assign select_3084 = or_1791_s15_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3086;
  assign select_3086 = equal_1785_s15_q ? patches_smooth_values_1_q : (equal_1787_s15_q ? patches_smooth_values_1_q : select_3084);
  logic [11:0] select_3087;
  assign select_3087 = or_1791_s15_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3089;
  assign select_3089 = equal_1785_s15_q ? patches_smooth_values_2_q : (equal_1787_s15_q ? patches_smooth_values_2_q : select_3087);
  logic [11:0] select_3090;
  assign select_3090 = or_1791_s15_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3092;
  assign select_3092 = equal_1785_s15_q ? patches_smooth_values_3_q : (equal_1787_s15_q ? patches_smooth_values_3_q : select_3090);
  logic [10:0] select_3099;
  assign select_3099 = or_1791_s15_q ? patches_down_values_1_s15_q : patches_down_values_2_q;
  logic [10:0] select_3101;
  assign select_3101 = equal_1785_s15_q ? patches_down_values_2_q : (equal_1787_s15_q ? patches_down_values_2_q : select_3099);
  logic [10:0] select_3102;
  assign select_3102 = or_1791_s15_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3104;
  assign select_3104 = equal_1785_s15_q ? patches_down_values_3_q : (equal_1787_s15_q ? patches_down_values_3_q : select_3102);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3541;
  assign select_3541 = or_1966_s15_q ? (and_3539_s15_q ? patches_rows_rdata_s15_q : 10'h3ff) : 10'h3ff;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3543;
  assign select_3543 = equal_1785_s15_q ? (less_1963_s15_q ? select_3541 : 10'h3ff) : patches_read_far_q;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3584_s15_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = less_3587_s15_q ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3545_s15_q;
  // hls/stages/agreement.hpp:1223
  logic equal_3652;
  assign equal_3652 = x_s15_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1217
  logic equal_3888;
  assign equal_3888 = x_s15_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1125
  logic [7:0] limit;
  assign limit = equal_3888 ? cfg_regions_limit_i : select_3911_s15_q;
  // hls/stages/agreement.hpp:1231
  logic not_3913;
  assign not_3913 = ~x_s15_q[2];
  logic [3:0] select_3914;
  assign select_3914 = x_s15_q[1] ? {x_s15_q[2], 1'b0, not_3913, 1'b0} : {1'b0, x_s15_q[2], 1'b0, not_3913};
  logic [7:0] select_3915;
  assign select_3915 = x_s15_q[0] ? {select_3914[3], 1'b0, select_3914[2], 1'b0, select_3914[1], 1'b0, select_3914[0], 1'b0} : {1'b0, select_3914[3], 1'b0, select_3914[2], 1'b0, select_3914[1], 1'b0, select_3914[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3919;
  assign select_3919 = equal_3890_s15_q ? counts_skin_supervised_q : (equal_3891_s15_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3921;
  assign select_3921 = equal_3889_s15_q ? counts_skin_textured_q : (equal_3886_s15_q ? counts_textured_q : select_3919);
  logic [13:0] of;
  assign of = equal_3888 ? counts_textured_q : select_3921;
  // hls/stages/registration.hpp:258
  logic not_4124;
  assign not_4124 = ~quarter_s15_q[1];
  logic [3:0] select_4125;
  assign select_4125 = quarter_s15_q[0] ? {quarter_s15_q[1], 1'b0, not_4124, 1'b0} : {1'b0, quarter_s15_q[1], 1'b0, not_4124};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1615_s15_q;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s15_en & (equal_575_s15_q ? (x_s15_q[6] & select_1646_s15_q) : and_1657);
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = last_s15_q;
  logic census_memory_we;
  assign census_memory_we = s15_en & and_550_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s15_q[58:40], census_memory_rdata_s15_q[38:0], and_568_s15_q, whole_2_s15_q, select_560_s15_q, select_556_s15_q};
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
  assign shown_right_waddr = select_1579_s15_q;
  logic shown_right_we;
  assign shown_right_we = s15_en & and_1590_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1587, not_578_s15_q};
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
  assign seen_columns_we = s15_en & and_1575_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s15_q, near_s15_q, shown_s15_q, explained, and_2022, textured_s15_q};
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
      census_filled_q <= and_550_s15_q ? {select_683[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2298;
      rows_passed_above_q <= and_550_s15_q ? select_682 : rows_passed_above_q;
      counts_textured_q <= and_2591 ? 14'h0 : (counts_textured_q + {13'h0, and_2602});
      counts_skin_supervised_q <= select_2661;
      counts_skin_textured_q <= select_2668;
      registration_fresh_q <= select_2821;
      patches_smooth_values_0_q <= equal_1785_s15_q ? patches_smooth_values_0_q : select_3082;
      patches_smooth_values_1_q <= select_3086;
      patches_smooth_values_2_q <= select_3089;
      patches_smooth_values_3_q <= select_3092;
      patches_down_values_2_q <= select_3101;
      patches_down_values_3_q <= select_3104;
      patches_read_far_q <= select_3543;
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
      averager_quarter_1_0_q <= select_2160;
      averager_quarter_1_1_q <= select_2162;
      averager_quarter_2_0_q <= select_2164;
      averager_quarter_2_1_q <= select_2166;
      census_columns_values_0_cell_0_left_q <= select_2195;
      census_columns_values_0_cell_0_right_q <= select_2196;
      census_columns_values_0_cell_1_left_q <= select_2198;
      census_columns_values_0_cell_1_right_q <= select_2199;
      census_columns_values_0_cell_1_mask_q <= select_2200;
      census_columns_values_0_cell_2_left_q <= select_2201;
      census_columns_values_0_cell_2_right_q <= select_2202;
      census_columns_values_0_cell_2_mask_q <= select_2203;
      census_columns_values_0_cell_2_of_skin_q <= select_2204;
      census_columns_values_0_cell_3_left_q <= select_2205;
      census_columns_values_0_cell_3_right_q <= select_2206;
      census_columns_values_0_cell_3_mask_q <= select_2207;
      census_columns_values_0_cell_4_left_q <= select_2208;
      census_columns_values_0_cell_4_right_q <= select_2209;
      census_columns_values_0_cell_4_mask_q <= select_2210;
      census_columns_values_1_cell_0_left_q <= select_2211;
      census_columns_values_1_cell_0_right_q <= select_2212;
      census_columns_values_1_cell_1_left_q <= select_2214;
      census_columns_values_1_cell_1_right_q <= select_2215;
      census_columns_values_1_cell_2_left_q <= select_2217;
      census_columns_values_1_cell_2_right_q <= select_2218;
      census_columns_values_1_cell_2_of_skin_q <= select_2220;
      census_columns_values_1_cell_3_left_q <= select_2221;
      census_columns_values_1_cell_3_right_q <= select_2222;
      census_columns_values_1_cell_4_left_q <= select_2224;
      census_columns_values_1_cell_4_right_q <= select_2225;
      census_columns_values_2_cell_0_left_q <= select_2227;
      census_columns_values_2_cell_0_right_q <= select_2228;
      census_columns_values_2_cell_1_left_q <= select_2230;
      census_columns_values_2_cell_1_right_q <= select_2231;
      census_columns_values_2_cell_2_left_q <= select_2233;
      census_columns_values_2_cell_2_right_q <= select_2234;
      census_columns_values_2_cell_3_left_q <= select_2236;
      census_columns_values_2_cell_3_right_q <= select_2237;
      census_columns_values_2_cell_4_left_q <= select_2239;
      census_columns_values_2_cell_4_right_q <= select_2240;
      census_columns_values_3_cell_1_left_q <= select_2243;
      census_columns_values_3_cell_1_right_q <= select_2244;
      census_columns_values_3_cell_3_left_q <= select_2247;
      census_columns_values_3_cell_3_right_q <= select_2248;
      sharpness_last_mean_0_q <= and_550_s15_q ? select_556_s15_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_550_s15_q ? select_560_s15_q : sharpness_last_mean_1_q;
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
  logic [3:0] select_509_s16_q;
  logic row_starts_s16_q;
  logic [6:0] select_544_s16_q;
  logic [6:0] last_s16_q;
  logic and_548_s16_q;
  logic and_550_s16_q;
  logic equal_553_s16_q;
  logic whole_2_s16_q;
  logic equal_570_s16_q;
  logic equal_575_s16_q;
  logic not_576_s16_q;
  logic so_s16_q;
  logic not_578_s16_q;
  logic equal_579_s16_q;
  logic inside_v_s16_q;
  logic [6:0] x_s16_2_q;
  logic [6:0] right_s16_q;
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
  logic less_675_s16_q;
  logic less_676_s16_q;
  logic and_684_s16_q;
  logic and_688_s16_q;
  logic difference_711_s16_q;
  logic [8:0] xor_712_s16_q;
  logic difference_714_s16_q;
  logic [8:0] xor_715_s16_q;
  logic difference_718_s16_q;
  logic [8:0] xor_719_s16_q;
  logic difference_722_s16_q;
  logic [8:0] xor_723_s16_q;
  logic difference_726_s16_q;
  logic [8:0] xor_727_s16_q;
  logic [9:0] half_grey_levels_s16_q;
  logic [9:0] half_grey_levels_2_s16_q;
  logic [5:0] select_1518_s16_q;
  logic [2:0] select_1523_s16_q;
  logic [7:0] select_1524_s16_q;
  logic [7:0] select_1532_s16_q;
  logic [7:0] select_1535_s16_q;
  logic [6:0] select_1553_s16_q;
  logic [5:0] select_1555_s16_q;
  logic [7:0] select_1558_s16_q;
  logic [7:0] select_1561_s16_q;
  logic and_1562_s16_q;
  logic [7:0] select_1567_s16_q;
  logic [6:0] select_1568_s16_q;
  logic [6:0] select_1571_s16_q;
  logic [6:0] select_1572_s16_q;
  logic and_1595_s16_q;
  logic and_1598_s16_q;
  logic and_1601_s16_q;
  logic and_1604_s16_q;
  logic and_1607_s16_q;
  logic equal_1608_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1614_s16_q;
  logic equal_1616_s16_q;
  logic equal_1618_s16_q;
  logic equal_1620_s16_q;
  logic equal_1622_s16_q;
  logic equal_1624_s16_q;
  logic equal_1626_s16_q;
  logic equal_1628_s16_q;
  logic equal_1630_s16_q;
  logic less_1639_s16_q;
  logic or_1643_s16_q;
  logic equal_1663_s16_q;
  logic and_1673_s16_q;
  logic select_1690_s16_q;
  logic equal_1691_s16_q;
  logic [22:0] patches_choices_rdata_s16_q;
  logic and_1699_s16_q;
  logic equal_1701_s16_q;
  logic and_1738_s16_q;
  logic [7:0] select_1745_s16_q;
  logic [5:0] select_1750_s16_q;
  logic [7:0] select_1776_s16_q;
  logic and_1783_s16_q;
  logic and_1784_s16_q;
  logic equal_1785_s16_q;
  logic equal_1787_s16_q;
  logic equal_1790_s16_q;
  logic or_1791_s16_q;
  logic not_1792_s16_q;
  logic and_1800_s16_q;
  logic [4:0] select_1815_s16_q;
  logic select_1821_s16_q;
  logic [3:0] select_1859_s16_q;
  logic less_1875_s16_q;
  logic new_row_s16_q;
  logic or_1888_s16_q;
  logic [27:0] patches_right_codes_rdata_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic down_2_s16_q;
  logic sum_1902_s16_q;
  logic [12:0] sum_1903_s16_q;
  logic [14:0] difference_1923_s16_q;
  logic and_1948_s16_q;
  logic [47:0] patches_left_codes_rdata_s16_q;
  logic and_1957_s16_q;
  logic and_1962_s16_q;
  logic or_1980_s16_q;
  logic or_1983_s16_q;
  logic or_1986_s16_q;
  logic not_1988_s16_q;
  logic [29:0] regions_rdata_s16_q;
  logic textured_s16_q;
  logic explained_s16_q;
  logic and_2015_s16_q;
  logic and_2020_s16_q;
  logic and_2061_s16_q;
  logic and_2062_s16_q;
  logic [1:0] sum_2066_s16_q;
  logic or_2078_s16_q;
  logic or_2081_s16_q;
  logic or_2084_s16_q;
  logic and_2095_s16_q;
  logic [2:0] sum_2101_s16_q;
  logic and_2111_s16_q;
  logic [2:0] sum_2117_s16_q;
  logic and_2134_s16_q;
  logic sum_2171_s16_q;
  logic [9:0] difference_2172_s16_q;
  logic sum_2179_s16_q;
  logic [9:0] difference_2180_s16_q;
  logic difference_2252_s16_q;
  logic [8:0] xor_2253_s16_q;
  logic difference_2255_s16_q;
  logic [8:0] xor_2256_s16_q;
  logic difference_2259_s16_q;
  logic [8:0] xor_2260_s16_q;
  logic difference_2263_s16_q;
  logic [8:0] xor_2264_s16_q;
  logic difference_2267_s16_q;
  logic [8:0] xor_2268_s16_q;
  logic equal_2277_s16_q;
  logic equal_2292_s16_q;
  logic difference_2363_s16_q;
  logic [8:0] xor_2364_s16_q;
  logic difference_2375_s16_q;
  logic [8:0] xor_2376_s16_q;
  logic equal_2466_s16_q;
  logic and_2591_s16_q;
  logic and_2597_s16_q;
  logic and_2602_s16_q;
  logic not_2616_s16_q;
  logic and_2617_s16_q;
  logic [2:0] sum_2623_s16_q;
  logic and_2693_s16_q;
  logic and_2710_s16_q;
  logic and_2717_s16_q;
  logic and_2751_s16_q;
  logic and_2752_s16_q;
  logic [7:0] residual_s16_q;
  logic less_2787_s16_q;
  logic less_2801_s16_q;
  logic equal_2845_s16_q;
  logic and_2990_s16_q;
  logic less_3116_s16_q;
  logic equal_3459_s16_q;
  logic [9:0] select_3545_s16_q;
  logic [4:0] select_3546_s16_q;
  logic [4:0] select_3547_s16_q;
  logic equal_3556_s16_q;
  logic less_3584_s16_q;
  logic [9:0] eight_s16_q;
  logic [9:0] fall_2_s16_q;
  logic equal_3652_s16_q;
  logic and_3867_s16_q;
  logic equal_3886_s16_q;
  logic equal_3888_s16_q;
  logic equal_3889_s16_q;
  logic equal_3890_s16_q;
  logic equal_3891_s16_q;
  logic equal_3917_s16_q;
  logic [13:0] of_s16_q;
  logic equal_4031_s16_q;
  logic equal_4127_s16_q;
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
      select_509_s16_q <= select_509_s15_q;
      row_starts_s16_q <= row_starts_s15_q;
      select_544_s16_q <= select_544_s15_q;
      last_s16_q <= last_s15_q;
      and_548_s16_q <= and_548_s15_q;
      and_550_s16_q <= and_550_s15_q;
      equal_553_s16_q <= equal_553_s15_q;
      whole_2_s16_q <= whole_2_s15_q;
      equal_570_s16_q <= equal_570_s15_q;
      equal_575_s16_q <= equal_575_s15_q;
      not_576_s16_q <= not_576_s15_q;
      so_s16_q <= so_s15_q;
      not_578_s16_q <= not_578_s15_q;
      equal_579_s16_q <= equal_579_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      x_s16_2_q <= x_s15_2_q;
      right_s16_q <= right_s15_q;
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
      less_675_s16_q <= less_675;
      less_676_s16_q <= less_676;
      and_684_s16_q <= select_682[4] & select_683[3];
      and_688_s16_q <= and_688;
      difference_711_s16_q <= difference_711[9];
      xor_712_s16_q <= difference_711[8:0] ^ {9{difference_711[9]}};
      difference_714_s16_q <= difference_714[9];
      xor_715_s16_q <= difference_714[8:0] ^ {9{difference_714[9]}};
      difference_718_s16_q <= difference_718[9];
      xor_719_s16_q <= difference_718[8:0] ^ {9{difference_718[9]}};
      difference_722_s16_q <= difference_722[9];
      xor_723_s16_q <= difference_722[8:0] ^ {9{difference_722[9]}};
      difference_726_s16_q <= difference_726[9];
      xor_727_s16_q <= difference_726[8:0] ^ {9{difference_726[9]}};
      half_grey_levels_s16_q <= half_grey_levels;
      half_grey_levels_2_s16_q <= half_grey_levels_2;
      select_1518_s16_q <= or_1517_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[5:0];
      select_1523_s16_q <= or_1517_s15_q ? select_1522_s15_q : best_left_rdata_s15_q[8:6];
      select_1524_s16_q <= or_1517_s15_q ? of_best_s15_q : best_left_rdata_s15_q[16:9];
      select_1532_s16_q <= or_1517_s15_q ? select_1531_s15_q : best_left_rdata_s15_q[24:17];
      select_1535_s16_q <= or_1517_s15_q ? select_1534_s15_q : best_left_rdata_s15_q[32:25];
      select_1553_s16_q <= select_1553_s15_q;
      select_1555_s16_q <= select_1555_s15_q;
      select_1558_s16_q <= select_1558_s15_q;
      select_1561_s16_q <= select_1561_s15_q;
      and_1562_s16_q <= and_1562_s15_q;
      select_1567_s16_q <= or_1566_s15_q ? of_best_s15_q : best_right_rdata_s15_q[7:0];
      select_1568_s16_q <= or_1566_s15_q ? x_s15_2_q : best_right_rdata_s15_q[14:8];
      select_1571_s16_q <= select_1571_s15_q;
      select_1572_s16_q <= select_1572_s15_q;
      and_1595_s16_q <= not_588_s15_q & and_1594;
      and_1598_s16_q <= and_1598;
      and_1601_s16_q <= and_1601_s15_q;
      and_1604_s16_q <= not_588_s15_q & and_1603;
      and_1607_s16_q <= and_1607;
      equal_1608_s16_q <= equal_1608_s15_q;
      all_s16_q <= all_s15_q;
      sum_1614_s16_q <= sum_1614_s15_q;
      equal_1616_s16_q <= equal_1616_s15_q;
      equal_1618_s16_q <= equal_1618_s15_q;
      equal_1620_s16_q <= equal_1620_s15_q;
      equal_1622_s16_q <= equal_1622_s15_q;
      equal_1624_s16_q <= equal_1624_s15_q;
      equal_1626_s16_q <= equal_1626_s15_q;
      equal_1628_s16_q <= equal_1628_s15_q;
      equal_1630_s16_q <= equal_1630_s15_q;
      less_1639_s16_q <= less_1639_s15_q;
      or_1643_s16_q <= or_1643_s15_q;
      equal_1663_s16_q <= (registration_fresh_q & select_1661_s15_q) == 4'h0;
      and_1673_s16_q <= not_576_s15_q & and_1657;
      select_1690_s16_q <= select_1690_s15_q;
      equal_1691_s16_q <= equal_1691_s15_q;
      patches_choices_rdata_s16_q <= patches_choices_rdata_q;
      and_1699_s16_q <= and_1699_s15_q;
      equal_1701_s16_q <= equal_1701_s15_q;
      and_1738_s16_q <= and_1738;
      select_1745_s16_q <= equal_575_s15_q ? 8'h0 : select_1744;
      select_1750_s16_q <= select_1750_s15_q;
      select_1776_s16_q <= select_1776_s15_q;
      and_1783_s16_q <= and_1783_s15_q;
      and_1784_s16_q <= and_1784_s15_q;
      equal_1785_s16_q <= equal_1785_s15_q;
      equal_1787_s16_q <= equal_1787_s15_q;
      equal_1790_s16_q <= equal_1790_s15_q;
      or_1791_s16_q <= or_1791_s15_q;
      not_1792_s16_q <= not_1792_s15_q;
      and_1800_s16_q <= and_1800_s15_q;
      select_1815_s16_q <= select_1815_s15_q;
      select_1821_s16_q <= select_1821_s15_q;
      select_1859_s16_q <= select_1859_s15_q;
      less_1875_s16_q <= less_1875_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1888_s16_q <= or_1888_s15_q;
      patches_right_codes_rdata_s16_q <= patches_right_codes_rdata_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[0];
      sum_1902_s16_q <= sum_1902[0];
      sum_1903_s16_q <= sum_1903;
      difference_1923_s16_q <= difference_1923;
      and_1948_s16_q <= and_1948_s15_q;
      patches_left_codes_rdata_s16_q <= patches_left_codes_rdata_q;
      and_1957_s16_q <= and_1957_s15_q;
      and_1962_s16_q <= and_1962_s15_q;
      or_1980_s16_q <= or_1980_s15_q;
      or_1983_s16_q <= or_1983_s15_q;
      or_1986_s16_q <= or_1986_s15_q;
      not_1988_s16_q <= not_1988_s15_q;
      regions_rdata_s16_q <= regions_rdata_q;
      textured_s16_q <= textured_s15_q;
      explained_s16_q <= explained;
      and_2015_s16_q <= inside_v_s15_q & (and_2013_s15_q & and_1586_s15_q);
      and_2020_s16_q <= and_2020_s15_q;
      and_2061_s16_q <= and_2061_s15_q;
      and_2062_s16_q <= seen_columns_rdata_s15_q[9] & inside_v_s15_q;
      sum_2066_s16_q <= sum_2066;
      or_2078_s16_q <= or_2078_s15_q;
      or_2081_s16_q <= or_2081_s15_q;
      or_2084_s16_q <= or_2084_s15_q;
      and_2095_s16_q <= and_2095_s15_q;
      sum_2101_s16_q <= {2'h0, and_2096} + {1'b0, sum_2100};
      and_2111_s16_q <= and_2111_s15_q;
      sum_2117_s16_q <= {2'h0, and_2112} + {1'b0, sum_2116};
      and_2134_s16_q <= and_2134_s15_q;
      sum_2171_s16_q <= sum_2171[0];
      difference_2172_s16_q <= {1'b0, sum_2171[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2179_s16_q <= sum_2179[0];
      difference_2180_s16_q <= {1'b0, sum_2179[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2252_s16_q <= difference_2252[9];
      xor_2253_s16_q <= difference_2252[8:0] ^ {9{difference_2252[9]}};
      difference_2255_s16_q <= difference_2255[9];
      xor_2256_s16_q <= difference_2255[8:0] ^ {9{difference_2255[9]}};
      difference_2259_s16_q <= difference_2259[9];
      xor_2260_s16_q <= difference_2259[8:0] ^ {9{difference_2259[9]}};
      difference_2263_s16_q <= difference_2263[9];
      xor_2264_s16_q <= difference_2263[8:0] ^ {9{difference_2263[9]}};
      difference_2267_s16_q <= difference_2267[9];
      xor_2268_s16_q <= difference_2267[8:0] ^ {9{difference_2267[9]}};
      equal_2277_s16_q <= equal_2277_s15_q;
      equal_2292_s16_q <= equal_2292;
      difference_2363_s16_q <= difference_2363[9];
      xor_2364_s16_q <= difference_2363[8:0] ^ {9{difference_2363[9]}};
      difference_2375_s16_q <= difference_2375[9];
      xor_2376_s16_q <= difference_2375[8:0] ^ {9{difference_2375[9]}};
      equal_2466_s16_q <= equal_2466_s15_q;
      and_2591_s16_q <= and_2591;
      and_2597_s16_q <= and_2597_s15_q;
      and_2602_s16_q <= and_2602;
      not_2616_s16_q <= not_2616_s15_q;
      and_2617_s16_q <= and_2617_s15_q;
      sum_2623_s16_q <= {2'h0, and_2618} + {1'b0, sum_2622};
      and_2693_s16_q <= not_576_s15_q & (so_s15_q & (ends_cell_s15_q & and_2690_s15_q));
      and_2710_s16_q <= not_576_s15_q & (so_s15_q & and_2708);
      and_2717_s16_q <= not_576_s15_q & (so_s15_q & and_2715);
      and_2751_s16_q <= and_2751_s15_q;
      and_2752_s16_q <= and_2752_s15_q;
      residual_s16_q <= residual_s15_q[7:0];
      less_2787_s16_q <= $signed(difference_2786) < $signed({7'h0, cfg_moved_limit_i});
      less_2801_s16_q <= less_2801;
      equal_2845_s16_q <= (registration_fresh_q & select_2843) == 4'h0;
      and_2990_s16_q <= and_2990_s15_q;
      less_3116_s16_q <= less_3116_s15_q;
      equal_3459_s16_q <= equal_3459_s15_q;
      select_3545_s16_q <= select_3545_s15_q;
      select_3546_s16_q <= select_3546_s15_q;
      select_3547_s16_q <= select_3547_s15_q;
      equal_3556_s16_q <= equal_3556_s15_q;
      less_3584_s16_q <= less_3584_s15_q;
      eight_s16_q <= eight;
      fall_2_s16_q <= fall_2;
      equal_3652_s16_q <= equal_3652;
      and_3867_s16_q <= equal_3866_s15_q & equal_3652;
      equal_3886_s16_q <= equal_3886_s15_q;
      equal_3888_s16_q <= equal_3888;
      equal_3889_s16_q <= equal_3889_s15_q;
      equal_3890_s16_q <= equal_3890_s15_q;
      equal_3891_s16_q <= equal_3891_s15_q;
      equal_3917_s16_q <= (limit & select_3915) == 8'h0;
      of_s16_q <= of;
      equal_4031_s16_q <= equal_4031_s15_q;
      equal_4127_s16_q <= (registration_fresh_q & select_4125) == 4'h0;
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
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_688_s16_q;
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
  logic [9:0] sum_713;
  assign sum_713 = {9'h0, difference_711_s16_q} + {1'b0, xor_712_s16_q};
  logic [9:0] sum_716;
  assign sum_716 = {9'h0, difference_714_s16_q} + {1'b0, xor_715_s16_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_738;
  assign sum_738 = {half_grey_levels_s16_q[9], half_grey_levels_s16_q[9:4]} + 7'h7f;
  logic less_739;
  assign less_739 = {{5{sum_738[6]}}, sum_738, half_grey_levels_s16_q[3:0]} < 16'hffe1;
  logic [6:0] sum_744;
  assign sum_744 = {half_grey_levels_2_s16_q[9], half_grey_levels_2_s16_q[9:4]} + 7'h7f;
  logic less_745;
  assign less_745 = {{5{sum_744[6]}}, sum_744, half_grey_levels_2_s16_q[3:0]} < 16'hffe1;
  // hls/stages/patches.hpp:157
  logic and_1740;
  assign and_1740 = and_1738_s16_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_1741;
  assign select_1741 = and_1740 ? and_1738_s16_q : patches_choice_valid_q;
  logic [7:0] select_1746;
  assign select_1746 = and_1740 ? select_1745_s16_q : patches_choice_column_q;
  logic [5:0] select_1751;
  assign select_1751 = and_1740 ? select_1750_s16_q : patches_choice_shift_q;
  logic [7:0] select_1777;
  assign select_1777 = and_1740 ? select_1776_s16_q : patches_choice_slope_q;
  // hls/stages/patches.hpp:357
  logic [22:0] select_1801;
  assign select_1801 = and_1800_s16_q ? {select_1777, select_1751, select_1746, select_1741} : patches_choices_rdata_s16_q;
  // hls/stages/patches.hpp:475
  logic [14:0] sum_1904;
  assign sum_1904 = {{4{patches_down_values_3_s16_q[10]}}, patches_down_values_3_s16_q} + {sum_1903_s16_q, sum_1902_s16_q, down_2_s16_q};
  // hls/stages/patches.hpp:454
  logic and_1927;
  assign and_1927 = difference_1923_s16_q[8] & (~(difference_1923_s16_q[7:0] == 8'h0));
  // hls/stages/patches.hpp:457
  logic and_1931;
  assign and_1931 = (~difference_1923_s16_q[14]) & (and_1927 | (~(difference_1923_s16_q[13:9] == 5'h0)));
  // hls/stages/patches.hpp:453
  logic and_1934;
  assign and_1934 = difference_1923_s16_q[14] & (~(difference_1923_s16_q[13:8] == 6'h3f));
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2001;
  assign select_2001 = segment_started_s16_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2002;
  assign sum_2002 = {6'h0, textured_s16_q} + select_2001;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2004;
  assign sum_2004 = {3'h0, sum_2002} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2006;
  assign select_2006 = segment_started_s16_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2007;
  assign sum_2007 = {6'h0, explained_s16_q} + select_2006;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2009;
  assign sum_2009 = {3'h0, sum_2007} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2016;
  assign select_2016 = segment_started_s16_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2017;
  assign sum_2017 = {6'h0, and_2015_s16_q} + select_2016;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2019;
  assign sum_2019 = {3'h0, sum_2017} + (region_fresh_s16_q ? 10'h0 : regions_rdata_s16_q[29:20]);
  // hls/stages/agreement.hpp:1275
  logic or_2029;
  assign or_2029 = marks_first_s16_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [12:0] select_2031;
  assign select_2031 = marks_first_s16_q ? 13'h1 : (or_2029 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2033;
  assign select_2033 = or_2029 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2035;
  assign select_2035 = cfg_compete_i ? (or_2029 & select_2031[12]) : (select_2033[8] & select_2031[9]);
  // hls/stages/agreement.hpp:1087
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2061_s16_q} + ({2'h0, and_2062_s16_q} + {1'b0, sum_2066_s16_q});
  // hls/stages/agreement.hpp:1089
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2095_s16_q} + sum_2101_s16_q;
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2103;
  assign select_2103 = age_s16_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1090
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2111_s16_q} + sum_2117_s16_q;
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2119;
  assign select_2119 = age_s16_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:221
  logic [9:0] xor_2173;
  assign xor_2173 = {difference_2172_s16_q[8:0], sum_2171_s16_q} ^ {10{difference_2172_s16_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2172_s16_q[9]} + {1'b0, xor_2173};
  logic [9:0] xor_2181;
  assign xor_2181 = {difference_2180_s16_q[8:0], sum_2179_s16_q} ^ {10{difference_2180_s16_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2180_s16_q[9]} + {1'b0, xor_2181};
  // hls/stages/agreement.hpp:520
  logic select_2197;
  assign select_2197 = and_550_s16_q ? whole_2_s16_q : census_columns_values_0_cell_0_mask_q;
  logic select_2213;
  assign select_2213 = and_550_s16_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2216;
  assign select_2216 = and_550_s16_q ? census_columns_values_0_cell_1_mask_s16_q : census_columns_values_1_cell_1_mask_q;
  logic select_2223;
  assign select_2223 = and_550_s16_q ? census_columns_values_0_cell_3_mask_s16_q : census_columns_values_1_cell_3_mask_q;
  logic select_2226;
  assign select_2226 = and_550_s16_q ? census_columns_values_0_cell_4_mask_s16_q : census_columns_values_1_cell_4_mask_q;
  logic select_2229;
  assign select_2229 = and_550_s16_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2232;
  assign select_2232 = and_550_s16_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] sum_2254;
  assign sum_2254 = {9'h0, difference_2252_s16_q} + {1'b0, xor_2253_s16_q};
  logic [9:0] sum_2257;
  assign sum_2257 = {9'h0, difference_2255_s16_q} + {1'b0, xor_2256_s16_q};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2289;
  assign sum_2289 = {13'h0, moments_turns_0_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2291;
  assign sum_2291 = {13'h0, moments_turns_1_q} + (moments_starts_s16_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:788
  logic and_2332;
  assign and_2332 = not_578_s16_q & (equal_579_s16_q & (inside_v_s16_q & and_1598_s16_q));
  logic and_2336;
  assign and_2336 = not_578_s16_q & (equal_579_s16_q & (inside_v_s16_q & and_1607_s16_q));
  // hls/stages/census.hpp:371
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2363_s16_q} + xor_2364_s16_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2375_s16_q} + xor_2376_s16_q;
  // hls/stages/agreement.hpp:788
  logic and_2607;
  assign and_2607 = not_576_s16_q & (so_s16_q & (ends_cell_s16_q & explained_s16_q));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2609;
  assign select_2609 = and_2591_s16_q ? 14'h0 : (counts_explained_q + {13'h0, and_2607});
  // hls/stages/agreement.hpp:788
  logic and_2612;
  assign and_2612 = not_576_s16_q & (so_s16_q & (ends_cell_s16_q & and_2015_s16_q));
  // hls/stages/agreement.hpp:1088
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2617_s16_q} + sum_2623_s16_q;
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2625;
  assign select_2625 = age_s16_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1132
  logic less_2641;
  assign less_2641 = region_row_s16_q < x_s16_q[5:3];
  // hls/stages/patches.hpp:349
  logic not_2980;
  assign not_2980 = ~and_1783_s16_q;
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_1888_s16_q ? patches_right_codes_rdata_s16_q : 28'h0;
  // hls/stages/patches.hpp:526
  logic [47:0] select_3149;
  assign select_3149 = new_row_s16_q ? patches_left_codes_rdata_s16_q : patches_left_row_q;
  // hls/stages/agreement.hpp:275
  logic [47:0] select_3151;
  assign select_3151 = equal_1785_s16_q ? patches_left_row_q : (equal_1787_s16_q ? select_3149 : patches_left_row_q);
  logic [4:0] select_3496;
  assign select_3496 = equal_1787_s16_q ? patches_along_s16_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3553;
  assign select_3553 = (patches_read_far_s16_q < patches_peak_far_q) ? patches_read_far_s16_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3555;
  assign select_3555 = equal_1785_s16_q ? (patches_read_first_s16_q ? patches_read_far_s16_q : select_3553) : patches_peak_far_q;
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3593;
  assign sum_3593 = {1'b0, fall_2_s16_q} + {2'h0, fall_2_s16_q[9:1]};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3597;
  assign sum_3597 = {1'b0, fall_2_s16_q} + {3'h0, fall_2_s16_q[9:2]};
  logic less_3601;
  assign less_3601 = {eight_s16_q, 3'h0} < ({fall_2_s16_q, 3'h0} - {3'h0, fall_2_s16_q});
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3904;
  assign select_3904 = equal_3652_s16_q ? 14'h0 : product_q;
  logic [13:0] select_3923;
  assign select_3923 = equal_3917_s16_q ? 14'h0 : of_s16_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3904} + {1'b0, select_3923};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_3965;
  assign select_3965 = so_s16_q ? (ends_cell_s16_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3967;
  assign select_3967 = ends_cell_s16_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3969;
  assign select_3969 = equal_575_s16_q ? box_explained_columns_values_1_q : (so_s16_q ? select_3967 : box_explained_columns_values_1_q);
  logic [2:0] select_3970;
  assign select_3970 = ends_cell_s16_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3972;
  assign select_3972 = equal_575_s16_q ? box_explained_columns_values_2_q : (so_s16_q ? select_3970 : box_explained_columns_values_2_q);
  logic [2:0] select_3973;
  assign select_3973 = ends_cell_s16_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3975;
  assign select_3975 = equal_575_s16_q ? box_explained_columns_values_3_q : (so_s16_q ? select_3973 : box_explained_columns_values_3_q);
  logic [2:0] select_3976;
  assign select_3976 = ends_cell_s16_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3978;
  assign select_3978 = equal_575_s16_q ? box_explained_columns_values_4_q : (so_s16_q ? select_3976 : box_explained_columns_values_4_q);
  logic [2:0] select_3983;
  assign select_3983 = so_s16_q ? (ends_cell_s16_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3985;
  assign select_3985 = ends_cell_s16_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3987;
  assign select_3987 = equal_575_s16_q ? box_shown_columns_values_1_q : (so_s16_q ? select_3985 : box_shown_columns_values_1_q);
  logic [2:0] select_3988;
  assign select_3988 = ends_cell_s16_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3990;
  assign select_3990 = equal_575_s16_q ? box_shown_columns_values_2_q : (so_s16_q ? select_3988 : box_shown_columns_values_2_q);
  logic [2:0] select_3991;
  assign select_3991 = ends_cell_s16_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3993;
  assign select_3993 = equal_575_s16_q ? box_shown_columns_values_3_q : (so_s16_q ? select_3991 : box_shown_columns_values_3_q);
  logic [2:0] select_3994;
  assign select_3994 = ends_cell_s16_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3996;
  assign select_3996 = equal_575_s16_q ? box_shown_columns_values_4_q : (so_s16_q ? select_3994 : box_shown_columns_values_4_q);
  logic [2:0] select_4001;
  assign select_4001 = so_s16_q ? (ends_cell_s16_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4003;
  assign select_4003 = ends_cell_s16_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4005;
  assign select_4005 = equal_575_s16_q ? box_nearer_columns_values_1_q : (so_s16_q ? select_4003 : box_nearer_columns_values_1_q);
  logic [2:0] select_4006;
  assign select_4006 = ends_cell_s16_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4008;
  assign select_4008 = equal_575_s16_q ? box_nearer_columns_values_2_q : (so_s16_q ? select_4006 : box_nearer_columns_values_2_q);
  logic [2:0] select_4009;
  assign select_4009 = ends_cell_s16_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4011;
  assign select_4011 = equal_575_s16_q ? box_nearer_columns_values_3_q : (so_s16_q ? select_4009 : box_nearer_columns_values_3_q);
  logic [2:0] select_4012;
  assign select_4012 = ends_cell_s16_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4014;
  assign select_4014 = equal_575_s16_q ? box_nearer_columns_values_4_q : (so_s16_q ? select_4012 : box_nearer_columns_values_4_q);

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s16_2_q;
  logic best_left_we;
  assign best_left_we = s16_en & and_1562_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1561_s16_q, select_1558_s16_q, select_1555_s16_q, select_1553_s16_q, select_1535_s16_q, select_1532_s16_q, select_1524_s16_q, select_1523_s16_q, select_1518_s16_q};
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
  assign best_right_we = s16_en & and_1562_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1572_s16_q, select_1571_s16_q, select_1568_s16_q, select_1567_s16_q};
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
  assign left_turns_we = s16_en & and_1601_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1598_s16_q, and_1595_s16_q};
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
  assign right_turns_we = s16_en & and_1601_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1607_s16_q, and_1604_s16_q};
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
  assign patches_choices_waddr = {patches_choosing_band_s16_q, and_1699_s16_q};
  logic patches_choices_we;
  assign patches_choices_we = s16_en & and_1784_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {select_1777, select_1751, select_1746, select_1741};
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
      moments_turned_0_q <= sum_2289;
      moments_turned_1_q <= sum_2291;
      moments_turns_0_q <= not_576_s16_q & and_2332;
      moments_turns_1_q <= not_576_s16_q & and_2336;
      counts_explained_q <= select_2609;
      patches_fixed_q <= not_2980 & (patches_fixed_q | (and_2990_s16_q & and_1740));
      patches_choice_valid_q <= and_1783_s16_q ? (select_1741 & not_2980) : select_1741;
      patches_choice_column_q <= select_1746;
      patches_choice_shift_q <= select_1751;
      patches_choice_slope_q <= select_1777;
      patches_left_row_q <= select_3151;
      patches_summed_row_column_q <= equal_1785_s16_q ? patches_summed_row_column_q : select_3496;
      patches_peak_far_q <= select_3555;
      segment_textured_q <= select_2001 + {6'h0, and_2602_s16_q};
      segment_explained_q <= select_2006 + {6'h0, and_2607};
      segment_nearer_q <= select_2016 + {6'h0, and_2612};
      product_q <= equal_575_s16_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2031;
      columns_passed_q <= {select_2033[7:0], or_2029};
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
      census_columns_values_0_cell_0_mask_q <= select_2197;
      census_columns_values_1_cell_0_mask_q <= select_2213;
      census_columns_values_1_cell_1_mask_q <= select_2216;
      census_columns_values_1_cell_3_mask_q <= select_2223;
      census_columns_values_1_cell_4_mask_q <= select_2226;
      census_columns_values_2_cell_0_mask_q <= select_2229;
      census_columns_values_2_cell_1_mask_q <= select_2232;
      box_explained_columns_values_0_q <= equal_575_s16_q ? box_explained_columns_values_0_q : select_3965;
      box_explained_columns_values_1_q <= select_3969;
      box_explained_columns_values_2_q <= select_3972;
      box_explained_columns_values_3_q <= select_3975;
      box_explained_columns_values_4_q <= select_3978;
      box_shown_columns_values_0_q <= equal_575_s16_q ? box_shown_columns_values_0_q : select_3983;
      box_shown_columns_values_1_q <= select_3987;
      box_shown_columns_values_2_q <= select_3990;
      box_shown_columns_values_3_q <= select_3993;
      box_shown_columns_values_4_q <= select_3996;
      box_nearer_columns_values_0_q <= equal_575_s16_q ? box_nearer_columns_values_0_q : select_4001;
      box_nearer_columns_values_1_q <= select_4005;
      box_nearer_columns_values_2_q <= select_4008;
      box_nearer_columns_values_3_q <= select_4011;
      box_nearer_columns_values_4_q <= select_4014;
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
  logic [3:0] select_509_s17_q;
  logic row_starts_s17_q;
  logic [6:0] select_544_s17_q;
  logic [6:0] last_s17_q;
  logic and_548_s17_q;
  logic and_550_s17_q;
  logic equal_553_s17_q;
  logic whole_2_s17_q;
  logic equal_570_s17_q;
  logic equal_575_s17_q;
  logic not_576_s17_q;
  logic so_s17_q;
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
  logic less_675_s17_q;
  logic less_676_s17_q;
  logic and_684_s17_q;
  logic whole_9_s17_q;
  logic [10:0] sum_717_s17_q;
  logic [9:0] sum_720_s17_q;
  logic [9:0] sum_724_s17_q;
  logic [9:0] sum_728_s17_q;
  logic less_739_s17_q;
  logic less_741_s17_q;
  logic less_745_s17_q;
  logic less_747_s17_q;
  logic equal_1608_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1614_s17_q;
  logic equal_1616_s17_q;
  logic equal_1618_s17_q;
  logic equal_1620_s17_q;
  logic equal_1622_s17_q;
  logic equal_1624_s17_q;
  logic equal_1626_s17_q;
  logic equal_1628_s17_q;
  logic equal_1630_s17_q;
  logic less_1639_s17_q;
  logic or_1643_s17_q;
  logic [31:0] registration_sums_rdata_s17_q;
  logic equal_1663_s17_q;
  logic and_1673_s17_q;
  logic select_1690_s17_q;
  logic equal_1691_s17_q;
  logic equal_1701_s17_q;
  logic equal_1785_s17_q;
  logic equal_1787_s17_q;
  logic equal_1790_s17_q;
  logic or_1791_s17_q;
  logic not_1792_s17_q;
  logic [22:0] select_1801_s17_q;
  logic [4:0] select_1815_s17_q;
  logic select_1821_s17_q;
  logic [3:0] select_1859_s17_q;
  logic less_1875_s17_q;
  logic new_row_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic not_1905_s17_q;
  logic and_1908_s17_q;
  logic not_1910_s17_q;
  logic and_1915_s17_q;
  logic and_1931_s17_q;
  logic and_1934_s17_q;
  logic and_1948_s17_q;
  logic and_1957_s17_q;
  logic and_1962_s17_q;
  logic or_1980_s17_q;
  logic or_1983_s17_q;
  logic or_1986_s17_q;
  logic not_1988_s17_q;
  logic [9:0] sum_2004_s17_q;
  logic [9:0] sum_2009_s17_q;
  logic [9:0] sum_2019_s17_q;
  logic and_2020_s17_q;
  logic select_2035_s17_q;
  logic [2:0] textured_2_s17_q;
  logic or_2078_s17_q;
  logic or_2081_s17_q;
  logic or_2084_s17_q;
  logic [3:0] difference_2104_s17_q;
  logic [3:0] difference_2120_s17_q;
  logic and_2134_s17_q;
  logic [10:0] size_s17_q;
  logic [10:0] size_2_s17_q;
  logic [10:0] sum_2258_s17_q;
  logic [9:0] sum_2261_s17_q;
  logic [9:0] sum_2265_s17_q;
  logic [9:0] sum_2269_s17_q;
  logic equal_2277_s17_q;
  logic equal_2292_s17_q;
  logic [8:0] contrast_s17_q;
  logic [8:0] contrast_2_s17_q;
  logic equal_2466_s17_q;
  logic and_2591_s17_q;
  logic and_2597_s17_q;
  logic and_2612_s17_q;
  logic not_2616_s17_q;
  logic [3:0] difference_2626_s17_q;
  logic [9:0] select_2642_s17_q;
  logic [9:0] select_2645_s17_q;
  logic and_2693_s17_q;
  logic and_2710_s17_q;
  logic and_2717_s17_q;
  logic and_2751_s17_q;
  logic and_2752_s17_q;
  logic [7:0] residual_s17_q;
  logic and_2788_s17_q;
  logic and_2802_s17_q;
  logic equal_2845_s17_q;
  logic [27:0] word_s17_q;
  logic equal_3110_s17_q;
  logic less_3116_s17_q;
  logic [47:0] select_3149_s17_q;
  logic equal_3459_s17_q;
  logic [9:0] select_3545_s17_q;
  logic [4:0] select_3546_s17_q;
  logic [4:0] select_3547_s17_q;
  logic equal_3556_s17_q;
  logic less_3584_s17_q;
  logic not_3592_s17_q;
  logic not_3595_s17_q;
  logic not_3599_s17_q;
  logic not_3602_s17_q;
  logic equal_3652_s17_q;
  logic and_3867_s17_q;
  logic less_3868_s17_q;
  logic equal_3869_s17_q;
  logic equal_3886_s17_q;
  logic equal_3888_s17_q;
  logic equal_3889_s17_q;
  logic equal_3890_s17_q;
  logic equal_3891_s17_q;
  logic sum_4_s17_q;
  logic equal_4031_s17_q;
  logic equal_4127_s17_q;
  logic [9:0] select_4137_s17_q;
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
      select_509_s17_q <= select_509_s16_q;
      row_starts_s17_q <= row_starts_s16_q;
      select_544_s17_q <= select_544_s16_q;
      last_s17_q <= last_s16_q;
      and_548_s17_q <= and_548_s16_q;
      and_550_s17_q <= and_550_s16_q;
      equal_553_s17_q <= equal_553_s16_q;
      whole_2_s17_q <= whole_2_s16_q;
      equal_570_s17_q <= equal_570_s16_q;
      equal_575_s17_q <= equal_575_s16_q;
      not_576_s17_q <= not_576_s16_q;
      so_s17_q <= so_s16_q;
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
      less_675_s17_q <= less_675_s16_q;
      less_676_s17_q <= less_676_s16_q;
      and_684_s17_q <= and_684_s16_q;
      whole_9_s17_q <= whole_9;
      sum_717_s17_q <= {1'b0, sum_713} + {1'b0, sum_716};
      sum_720_s17_q <= {9'h0, difference_718_s16_q} + {1'b0, xor_719_s16_q};
      sum_724_s17_q <= {9'h0, difference_722_s16_q} + {1'b0, xor_723_s16_q};
      sum_728_s17_q <= {9'h0, difference_726_s16_q} + {1'b0, xor_727_s16_q};
      less_739_s17_q <= less_739;
      less_741_s17_q <= $signed(10'h0) < $signed(half_grey_levels_s16_q);
      less_745_s17_q <= less_745;
      less_747_s17_q <= $signed(10'h0) < $signed(half_grey_levels_2_s16_q);
      equal_1608_s17_q <= equal_1608_s16_q;
      all_s17_q <= all_s16_q;
      sum_1614_s17_q <= sum_1614_s16_q;
      equal_1616_s17_q <= equal_1616_s16_q;
      equal_1618_s17_q <= equal_1618_s16_q;
      equal_1620_s17_q <= equal_1620_s16_q;
      equal_1622_s17_q <= equal_1622_s16_q;
      equal_1624_s17_q <= equal_1624_s16_q;
      equal_1626_s17_q <= equal_1626_s16_q;
      equal_1628_s17_q <= equal_1628_s16_q;
      equal_1630_s17_q <= equal_1630_s16_q;
      less_1639_s17_q <= less_1639_s16_q;
      or_1643_s17_q <= or_1643_s16_q;
      registration_sums_rdata_s17_q <= registration_sums_rdata_q;
      equal_1663_s17_q <= equal_1663_s16_q;
      and_1673_s17_q <= and_1673_s16_q;
      select_1690_s17_q <= select_1690_s16_q;
      equal_1691_s17_q <= equal_1691_s16_q;
      equal_1701_s17_q <= equal_1701_s16_q;
      equal_1785_s17_q <= equal_1785_s16_q;
      equal_1787_s17_q <= equal_1787_s16_q;
      equal_1790_s17_q <= equal_1790_s16_q;
      or_1791_s17_q <= or_1791_s16_q;
      not_1792_s17_q <= not_1792_s16_q;
      select_1801_s17_q <= select_1801;
      select_1815_s17_q <= select_1815_s16_q;
      select_1821_s17_q <= select_1821_s16_q;
      select_1859_s17_q <= select_1859_s16_q;
      less_1875_s17_q <= less_1875_s16_q;
      new_row_s17_q <= new_row_s16_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      not_1905_s17_q <= ~sum_1904[14];
      and_1908_s17_q <= sum_1904[8] & (~(sum_1904[7:0] == 8'h0));
      not_1910_s17_q <= ~(sum_1904[13:9] == 5'h0);
      and_1915_s17_q <= sum_1904[14] & (~(sum_1904[13:8] == 6'h3f));
      and_1931_s17_q <= and_1931;
      and_1934_s17_q <= and_1934;
      and_1948_s17_q <= and_1948_s16_q;
      and_1957_s17_q <= and_1957_s16_q;
      and_1962_s17_q <= and_1962_s16_q;
      or_1980_s17_q <= or_1980_s16_q;
      or_1983_s17_q <= or_1983_s16_q;
      or_1986_s17_q <= or_1986_s16_q;
      not_1988_s17_q <= not_1988_s16_q;
      sum_2004_s17_q <= sum_2004;
      sum_2009_s17_q <= sum_2009;
      sum_2019_s17_q <= sum_2019;
      and_2020_s17_q <= and_2020_s16_q;
      select_2035_s17_q <= select_2035;
      textured_2_s17_q <= textured_2;
      or_2078_s17_q <= or_2078_s16_q;
      or_2081_s17_q <= or_2081_s16_q;
      or_2084_s17_q <= or_2084_s16_q;
      difference_2104_s17_q <= {1'b0, shown_2} - {1'b0, select_2103};
      difference_2120_s17_q <= {1'b0, near_2} - {1'b0, select_2119};
      and_2134_s17_q <= and_2134_s16_q;
      size_s17_q <= size;
      size_2_s17_q <= size_2;
      sum_2258_s17_q <= {1'b0, sum_2254} + {1'b0, sum_2257};
      sum_2261_s17_q <= {9'h0, difference_2259_s16_q} + {1'b0, xor_2260_s16_q};
      sum_2265_s17_q <= {9'h0, difference_2263_s16_q} + {1'b0, xor_2264_s16_q};
      sum_2269_s17_q <= {9'h0, difference_2267_s16_q} + {1'b0, xor_2268_s16_q};
      equal_2277_s17_q <= equal_2277_s16_q;
      equal_2292_s17_q <= equal_2292_s16_q;
      contrast_s17_q <= contrast;
      contrast_2_s17_q <= contrast_2;
      equal_2466_s17_q <= equal_2466_s16_q;
      and_2591_s17_q <= and_2591_s16_q;
      and_2597_s17_q <= and_2597_s16_q;
      and_2612_s17_q <= and_2612;
      not_2616_s17_q <= not_2616_s16_q;
      difference_2626_s17_q <= {1'b0, explained_2} - {1'b0, select_2625};
      select_2642_s17_q <= less_2641 ? 10'h0 : regions_rdata_s16_q[9:0];
      select_2645_s17_q <= less_2641 ? 10'h0 : regions_rdata_s16_q[19:10];
      and_2693_s17_q <= and_2693_s16_q;
      and_2710_s17_q <= and_2710_s16_q;
      and_2717_s17_q <= and_2717_s16_q;
      and_2751_s17_q <= and_2751_s16_q;
      and_2752_s17_q <= and_2752_s16_q;
      residual_s17_q <= residual_s16_q;
      and_2788_s17_q <= and_2752_s16_q & less_2787_s16_q;
      and_2802_s17_q <= and_2752_s16_q & less_2801_s16_q;
      equal_2845_s17_q <= equal_2845_s16_q;
      word_s17_q <= word;
      equal_3110_s17_q <= patches_along_s16_q == 5'h7;
      less_3116_s17_q <= less_3116_s16_q;
      select_3149_s17_q <= select_3149;
      equal_3459_s17_q <= equal_3459_s16_q;
      select_3545_s17_q <= select_3545_s16_q;
      select_3546_s17_q <= select_3546_s16_q;
      select_3547_s17_q <= select_3547_s16_q;
      equal_3556_s17_q <= equal_3556_s16_q;
      less_3584_s17_q <= less_3584_s16_q;
      not_3592_s17_q <= ~({eight_s16_q, 3'h0} < {3'h0, fall_2_s16_q});
      not_3595_s17_q <= ~({eight_s16_q, 3'h0} < {1'b0, sum_3593, fall_2_s16_q[0]});
      not_3599_s17_q <= ~({eight_s16_q, 3'h0} < {sum_3597, fall_2_s16_q[1:0]});
      not_3602_s17_q <= ~less_3601;
      equal_3652_s17_q <= equal_3652_s16_q;
      and_3867_s17_q <= and_3867_s16_q;
      less_3868_s17_q <= counts_explained_q < product_q;
      equal_3869_s17_q <= counts_explained_q == product_q;
      equal_3886_s17_q <= equal_3886_s16_q;
      equal_3888_s17_q <= equal_3888_s16_q;
      equal_3889_s17_q <= equal_3889_s16_q;
      equal_3890_s17_q <= equal_3890_s16_q;
      equal_3891_s17_q <= equal_3891_s16_q;
      sum_4_s17_q <= sum_4[0];
      equal_4031_s17_q <= equal_4031_s16_q;
      equal_4127_s17_q <= equal_4127_s16_q;
      select_4137_s17_q <= less_2641 ? 10'h0 : regions_rdata_s16_q[29:20];
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
  logic [10:0] sum_721;
  assign sum_721 = sum_717_s17_q + {1'b0, sum_720_s17_q};
  // hls/stages/agreement.hpp:456
  logic and_735;
  assign and_735 = census_columns_values_0_cell_2_mask_s17_q & census_columns_values_1_cell_2_mask_q;
  logic and_736;
  assign and_736 = and_684_s17_q & and_735;
  // hls/stages/registration.hpp:265
  logic equal_1665;
  assign equal_1665 = sum_1614_s17_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1614_s17_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1671;
  assign select_1671 = equal_1665 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1672;
  assign sum_1672 = (equal_1663_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0) + {{5{select_1671[6]}}, select_1671};
  // hls/stages/patches.hpp:358
  logic [21:0] select_1805;
  assign select_1805 = select_1690_s17_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1801_s17_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1806;
  assign select_1806 = equal_1691_s17_q ? patches_place_0_column_q : select_1805[7:0];
  logic [5:0] select_1807;
  assign select_1807 = equal_1691_s17_q ? patches_place_0_shift_q : select_1805[13:8];
  // hls/stages/patches.hpp:358
  logic [21:0] select_1833;
  assign select_1833 = select_1690_s17_q ? select_1801_s17_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1834;
  assign select_1834 = equal_1691_s17_q ? patches_place_1_column_q : select_1833[7:0];
  logic [5:0] select_1835;
  assign select_1835 = equal_1691_s17_q ? patches_place_1_shift_q : select_1833[13:8];
  // hls/stages/patches.hpp:133
  logic equal_1850;
  assign equal_1850 = {select_1806[7], select_544_s17_q, select_509_s17_q} == {1'b0, select_1806[6:0], 4'h0};
  logic equal_1854;
  assign equal_1854 = {select_1834[7], select_544_s17_q, select_509_s17_q} == {1'b0, select_1834[6:0], 4'h0};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_1896;
  assign sum_1896 = patches_code_row_s17_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_1912;
  assign and_1912 = not_1905_s17_q & (and_1908_s17_q | not_1910_s17_q);
  // hls/stages/patches.hpp:494
  logic [1:0] sum_1952;
  assign sum_1952 = patches_code_row_s17_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2035_s17_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2038;
  assign select_2038 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1301
  logic equal_2041;
  assign equal_2041 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1274
  logic not_2048;
  assign not_2048 = ~marks_first_s17_q;
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2069;
  assign select_2069 = age_s17_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2085;
  assign not_2085 = ~region_row_s17_q[2];
  logic [2:0] select_2086;
  assign select_2086 = region_row_s17_q[1] ? {1'b0, not_2085, 1'b0} : {region_row_s17_q[2], 1'b0, not_2085};
  logic [5:0] select_2087;
  assign select_2087 = region_row_s17_q[0] ? {select_2086[2], 1'b0, select_2086[1], 1'b0, select_2086[0], 1'b0} : {1'b0, select_2086[2], 1'b0, select_2086[1], 1'b0, select_2086[0]};
  logic [11:0] select_2088;
  assign select_2088 = or_2084_s17_q ? {select_2087[5], 1'b0, select_2087[4], 1'b0, select_2087[3], 1'b0, select_2087[2], 1'b0, select_2087[1], 1'b0, select_2087[0], 1'b0} : {1'b0, select_2087[5], 1'b0, select_2087[4], 1'b0, select_2087[3], 1'b0, select_2087[2], 1'b0, select_2087[1], 1'b0, select_2087[0]};
  logic [23:0] select_2089;
  assign select_2089 = or_2081_s17_q ? {select_2088[11], 1'b0, select_2088[10], 1'b0, select_2088[9], 1'b0, select_2088[8], 1'b0, select_2088[7], 1'b0, select_2088[6], 1'b0, select_2088[5], 1'b0, select_2088[4], 1'b0, select_2088[3], 1'b0, select_2088[2], 1'b0, select_2088[1], 1'b0, select_2088[0], 1'b0} : {1'b0, select_2088[11], 1'b0, select_2088[10], 1'b0, select_2088[9], 1'b0, select_2088[8], 1'b0, select_2088[7], 1'b0, select_2088[6], 1'b0, select_2088[5], 1'b0, select_2088[4], 1'b0, select_2088[3], 1'b0, select_2088[2], 1'b0, select_2088[1], 1'b0, select_2088[0]};
  // hls/stages/agreement.hpp:1096
  logic [4:0] around;
  assign around = {difference_2104_s17_q[3], difference_2104_s17_q} + (equal_570_s17_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1097
  logic [4:0] n;
  assign n = {difference_2120_s17_q[3], difference_2120_s17_q} + (equal_570_s17_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size_s17_q} + (equal_553_s17_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2178;
  assign select_2178 = sample_pair_whole_s17_q ? (and_548_s17_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s17_q} + (equal_553_s17_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2186;
  assign select_2186 = sample_pair_whole_s17_q ? (and_548_s17_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:520
  logic select_2219;
  assign select_2219 = and_550_s17_q ? census_columns_values_0_cell_2_mask_s17_q : census_columns_values_1_cell_2_mask_q;
  logic select_2235;
  assign select_2235 = and_550_s17_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2238;
  assign select_2238 = and_550_s17_q ? census_columns_values_1_cell_3_mask_s17_q : census_columns_values_2_cell_3_mask_q;
  logic select_2241;
  assign select_2241 = and_550_s17_q ? census_columns_values_1_cell_4_mask_s17_q : census_columns_values_2_cell_4_mask_q;
  logic select_2242;
  assign select_2242 = and_550_s17_q ? census_columns_values_2_cell_0_mask_s17_q : census_columns_values_3_cell_0_mask_q;
  logic select_2245;
  assign select_2245 = and_550_s17_q ? census_columns_values_2_cell_1_mask_s17_q : census_columns_values_3_cell_1_mask_q;
  logic select_2246;
  assign select_2246 = and_550_s17_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2249;
  assign select_2249 = and_550_s17_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:286
  logic [10:0] sum_2262;
  assign sum_2262 = sum_2258_s17_q + {1'b0, sum_2261_s17_q};
  // hls/stages/moments.hpp:117
  logic [13:0] select_2293;
  assign select_2293 = equal_2292_s17_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2295;
  assign select_2295 = equal_2292_s17_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2306;
  assign sum_2306 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2316;
  assign sum_2316 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/agreement.hpp:520
  logic select_2359;
  assign select_2359 = and_550_s17_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2362;
  assign and_2362 = whole_2_s17_q & (~(last_s17_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2368;
  assign and_2368 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s17_q[8:2]));
  logic and_2369;
  assign and_2369 = and_2362 & and_2368;
  logic and_2380;
  assign and_2380 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s17_q[8:2]));
  logic and_2381;
  assign and_2381 = and_2362 & and_2380;
  // hls/stages/census.hpp:427
  logic not_2398;
  assign not_2398 = ~x_s17_q[1];
  logic [2:0] select_2399;
  assign select_2399 = x_s17_q[0] ? {1'b0, not_2398, 1'b0} : {x_s17_q[1], 1'b0, not_2398};
  logic [5:0] select_2400;
  assign select_2400 = slot_s17_q[2] ? {select_2399[2], 1'b0, select_2399[1], 1'b0, select_2399[0], 1'b0} : {1'b0, select_2399[2], 1'b0, select_2399[1], 1'b0, select_2399[0]};
  logic [11:0] select_2401;
  assign select_2401 = slot_s17_q[1] ? {select_2400[5], 1'b0, select_2400[4], 1'b0, select_2400[3], 1'b0, select_2400[2], 1'b0, select_2400[1], 1'b0, select_2400[0], 1'b0} : {1'b0, select_2400[5], 1'b0, select_2400[4], 1'b0, select_2400[3], 1'b0, select_2400[2], 1'b0, select_2400[1], 1'b0, select_2400[0]};
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2599;
  assign select_2599 = and_2591_s17_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2597_s17_q});
  logic [13:0] select_2614;
  assign select_2614 = and_2591_s17_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2612_s17_q});
  // hls/stages/agreement.hpp:1095
  logic [4:0] e;
  assign e = {difference_2626_s17_q[3], difference_2626_s17_q} + (equal_570_s17_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2712;
  assign select_2712 = and_2591_s17_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2710_s17_q});
  logic [13:0] select_2719;
  assign select_2719 = and_2591_s17_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2717_s17_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2769;
  assign select_2769 = equal_1701_s17_q ? (and_2752_s17_q ? residual_s17_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_2776;
  assign and_2776 = not_576_s17_q & (so_s17_q & (and_2752_s17_q & equal_1701_s17_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2778;
  assign select_2778 = and_2751_s17_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2776});
  // hls/stages/registration.hpp:107
  logic and_2780;
  assign and_2780 = and_2752_s17_q & ($signed(residual_s17_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2790;
  assign select_2790 = so_s17_q ? (equal_1701_s17_q ? {and_2788_s17_q, and_2752_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2791;
  assign select_2791 = equal_575_s17_q ? 2'h0 : select_2790;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2792;
  assign sum_2792 = registration_half_votes_up_q + {{5{select_2791[1]}}, select_2791};
  // hls/stages/registration.hpp:205
  logic less_2794;
  assign less_2794 = $signed(residual_s17_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2795;
  assign and_2795 = and_2752_s17_q & less_2794;
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2804;
  assign select_2804 = so_s17_q ? (equal_1701_s17_q ? {and_2802_s17_q, and_2752_s17_q} : 2'h0) : 2'h0;
  logic [1:0] select_2805;
  assign select_2805 = equal_575_s17_q ? 2'h0 : select_2804;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2806;
  assign sum_2806 = registration_half_half_votes_up_q + {{5{select_2805[1]}}, select_2805};
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2847;
  assign select_2847 = or_1643_s17_q ? 12'h0 : (equal_2845_s17_q ? registration_sums_rdata_s17_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2849;
  assign select_2849 = equal_1608_s17_q ? 12'h0 : (less_1639_s17_q ? select_2847 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2852;
  assign and_2852 = x_s17_q[1] & all_s17_q;
  // hls/stages/agreement.hpp:1142
  logic and_2855;
  assign and_2855 = not_1988_s17_q & (less_1639_s17_q & ({and_2852, x_s17_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2862;
  assign select_2862 = or_1643_s17_q ? 12'h0 : (equal_2845_s17_q ? registration_sums_rdata_s17_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2864;
  assign select_2864 = equal_1608_s17_q ? 12'h0 : (less_1639_s17_q ? select_2862 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2870;
  assign not_2870 = ~all_s17_q;
  // hls/stages/agreement.hpp:1142
  logic and_2873;
  assign and_2873 = not_1988_s17_q & (less_1639_s17_q & (x_s17_q[2:0] == {all_s17_q, not_2870, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2879;
  assign and_2879 = equal_575_s17_q & (x_s17_q[6] & (not_1988_s17_q & (less_1639_s17_q & all_s17_q)));
  // hls/stages/registration.hpp:157
  logic equal_2906;
  assign equal_2906 = x_s17_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2909;
  assign and_2909 = not_1988_s17_q & (less_1639_s17_q & (x_s17_q[5] ? x_s17_q[3] : equal_2906));
  logic and_2918;
  assign and_2918 = not_1988_s17_q & (less_1639_s17_q & ((~x_s17_q[5]) & (x_s17_q[3] & equal_2906)));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3012;
  assign select_3012 = sample_pair_whole_s17_q ? (equal_1691_s17_q ? patches_place_0_slope_q : select_1805[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3017;
  assign select_3017 = sample_pair_whole_s17_q ? (equal_1691_s17_q ? patches_place_1_slope_q : select_1833[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s17_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:275
  logic [51:0] select_3106;
  assign select_3106 = or_1791_s17_q ? {and_1934_s17_q, and_1931_s17_q, and_1915_s17_q, and_1912, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3108;
  assign select_3108 = equal_1785_s17_q ? patches_codes_at_q : (equal_1787_s17_q ? other[55:4] : select_3106);
  // hls/stages/patches.hpp:525
  logic [27:0] select_3111;
  assign select_3111 = equal_3110_s17_q ? word_s17_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:275
  logic [27:0] select_3113;
  assign select_3113 = equal_1787_s17_q ? (new_row_s17_q ? word_s17_q : select_3111) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3115;
  assign select_3115 = less_1875_s17_q ? {word_s17_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3117;
  assign select_3117 = less_3116_s17_q ? {word_s17_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:275
  logic [55:0] select_3119;
  assign select_3119 = or_1791_s17_q ? (equal_1790_s17_q ? patches_next_codes_q : select_3117) : patches_next_codes_q;
  logic [55:0] select_3121;
  assign select_3121 = equal_1785_s17_q ? patches_next_codes_q : (equal_1787_s17_q ? select_3115 : select_3119);
  // hls/stages/count_bits.hpp:24
  logic parity_3126;
  assign parity_3126 = ^{and_1934_s17_q, and_1931_s17_q, and_1915_s17_q, and_1912};
  // hls/stages/count_bits.hpp:25
  logic or_3130;
  assign or_3130 = ({and_1915_s17_q, and_1912} == 2'h3) | (and_1931_s17_q & (and_1915_s17_q | and_1912));
  logic and_3131;
  assign and_3131 = and_1934_s17_q & (^{and_1931_s17_q, and_1915_s17_q, and_1912});
  // hls/stages/count_bits.hpp:24
  logic xor_3132;
  assign xor_3132 = or_3130 ^ and_3131;
  // hls/stages/count_bits.hpp:27
  logic and_3133;
  assign and_3133 = or_3130 & and_3131;
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3149_s17_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3155;
  assign xor_3155 = bits[17] ^ (^{select_3149_s17_q[16:15], other[16:15]});
  logic xor_3158;
  assign xor_3158 = bits[11] ^ (^{select_3149_s17_q[10:9], other[10:9]});
  logic xor_3161;
  assign xor_3161 = bits[14] ^ (^{select_3149_s17_q[13:12], other[13:12]});
  logic xor_3164;
  assign xor_3164 = xor_3155 ^ (^{select_3149_s17_q[14:9], other[14:9]});
  logic xor_3167;
  assign xor_3167 = bits[47] ^ (^{select_3149_s17_q[46:45], other[46:45]});
  logic xor_3170;
  assign xor_3170 = bits[8] ^ (^{select_3149_s17_q[7:6], other[7:6]});
  logic xor_3173;
  assign xor_3173 = bits[2] ^ (^{select_3149_s17_q[1:0], other[1:0]});
  logic xor_3176;
  assign xor_3176 = bits[5] ^ (^{select_3149_s17_q[4:3], other[4:3]});
  logic xor_3179;
  assign xor_3179 = xor_3170 ^ (^{select_3149_s17_q[5:0], other[5:0]});
  logic parity_3181;
  assign parity_3181 = ^{select_3149_s17_q[47:45], select_3149_s17_q[8:0], other[47:45], other[8:0]};
  logic xor_3185;
  assign xor_3185 = bits[44] ^ (^{select_3149_s17_q[43:42], other[43:42]});
  logic xor_3188;
  assign xor_3188 = bits[38] ^ (^{select_3149_s17_q[37:36], other[37:36]});
  logic xor_3191;
  assign xor_3191 = bits[41] ^ (^{select_3149_s17_q[40:39], other[40:39]});
  logic xor_3197;
  assign xor_3197 = bits[26] ^ (^{select_3149_s17_q[25:24], other[25:24]});
  logic xor_3200;
  assign xor_3200 = bits[20] ^ (^{select_3149_s17_q[19:18], other[19:18]});
  logic xor_3203;
  assign xor_3203 = bits[23] ^ (^{select_3149_s17_q[22:21], other[22:21]});
  logic xor_3209;
  assign xor_3209 = bits[35] ^ (^{select_3149_s17_q[34:33], other[34:33]});
  logic xor_3212;
  assign xor_3212 = bits[29] ^ (^{select_3149_s17_q[28:27], other[28:27]});
  logic xor_3215;
  assign xor_3215 = bits[32] ^ (^{select_3149_s17_q[31:30], other[31:30]});
  // hls/stages/agreement.hpp:275
  logic select_3499;
  assign select_3499 = equal_1785_s17_q ? patches_summed_first_q : (equal_1787_s17_q ? new_row_s17_q : patches_summed_first_q);
  // hls/stages/patches.hpp:584
  logic [1:0] sum_3596;
  assign sum_3596 = {1'b0, not_3592_s17_q} + {1'b0, not_3595_s17_q};
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3603;
  assign sum_3603 = {1'b0, not_3599_s17_q} + {1'b0, not_3602_s17_q};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3596} + {1'b0, sum_3603};
  // hls/stages/patches.hpp:604
  logic [7:0] select_3607;
  assign select_3607 = patches_second_s17_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [3:0] sum_3608;
  assign sum_3608 = {2'h0, select_3546_s17_q[4:3]} + 4'hf;
  logic [5:0] select_3609;
  assign select_3609 = patches_second_s17_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3610;
  assign sum_3610 = {select_3609[5], select_3609} + {{4{sum_3608[3]}}, sum_3608[3:1]};
  // hls/stages/agreement.hpp:1188
  logic or_3864;
  assign or_3864 = ({counts_textured_s17_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s17_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = less_3868_s17_q | (product_rest_q & equal_3869_s17_q);
  // hls/stages/agreement.hpp:1227
  logic select_3872;
  assign select_3872 = and_3867_s17_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3875;
  assign sum_3875 = {1'b0, select_2645_s17_q} + {2'h0, select_2645_s17_q[9:1]};
  // hls/stages/agreement.hpp:788
  logic select_3928;
  assign select_3928 = equal_575_s17_q ? (equal_3652_s17_q ? sum_4_s17_q : (product_rest_q | sum_4_s17_q)) : product_rest_q;
  logic [2:0] select_3946;
  assign select_3946 = ends_cell_s17_q ? textured_2_s17_q : box_textured_columns_values_0_q;
  logic [2:0] select_3948;
  assign select_3948 = equal_575_s17_q ? box_textured_columns_values_0_q : (so_s17_q ? select_3946 : box_textured_columns_values_0_q);
  logic [2:0] select_3949;
  assign select_3949 = ends_cell_s17_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3951;
  assign select_3951 = equal_575_s17_q ? box_textured_columns_values_1_q : (so_s17_q ? select_3949 : box_textured_columns_values_1_q);
  logic [2:0] select_3952;
  assign select_3952 = ends_cell_s17_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3954;
  assign select_3954 = equal_575_s17_q ? box_textured_columns_values_2_q : (so_s17_q ? select_3952 : box_textured_columns_values_2_q);
  logic [2:0] select_3955;
  assign select_3955 = ends_cell_s17_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3957;
  assign select_3957 = equal_575_s17_q ? box_textured_columns_values_3_q : (so_s17_q ? select_3955 : box_textured_columns_values_3_q);
  logic [2:0] select_3958;
  assign select_3958 = ends_cell_s17_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3960;
  assign select_3960 = equal_575_s17_q ? box_textured_columns_values_4_q : (so_s17_q ? select_3958 : box_textured_columns_values_4_q);
  logic [4:0] select_3980;
  assign select_3980 = so_s17_q ? (ends_cell_s17_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3981;
  assign select_3981 = equal_575_s17_q ? box_explained_sum_sums_values_0_q : select_3980;
  logic [4:0] select_3998;
  assign select_3998 = so_s17_q ? (ends_cell_s17_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4016;
  assign select_4016 = so_s17_q ? (ends_cell_s17_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1300
  logic [3:0] select_4048;
  assign select_4048 = select_2035_s17_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4054;
  assign select_4054 = marks_first_s17_q ? (less_4050 ? {sum_4051, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4129;
  assign select_4129 = equal_1630_s17_q ? {2'h0, counts_explained_s17_q, 2'h0, counts_textured_s17_q} : (equal_4127_s17_q ? registration_sums_rdata_s17_q : 32'h0);
  logic [31:0] select_4130;
  assign select_4130 = equal_1628_s17_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4129;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1896, patches_code_row_s17_q[1:0], of_row_2_s17_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s17_en & and_1948_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1934_s17_q, and_1931_s17_q, and_1915_s17_q, and_1912, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1952, patches_code_row_s17_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s17_en & and_1962_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1934_s17_q, and_1931_s17_q, and_1915_s17_q, and_1912, patches_codes_at_q[51:8]};
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
  assign regions_waddr = {region_row_s17_q, or_1986_s17_q, or_1983_s17_q, or_1980_s17_q};
  logic regions_we;
  assign regions_we = s17_en & and_2020_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2019_s17_q, sum_2009_s17_q, sum_2004_s17_q};
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
      moments_before_0_q <= equal_575_s17_q ? select_2293 : moments_before_0_q;
      moments_before_1_q <= equal_575_s17_q ? select_2295 : moments_before_1_q;
      sharpness_before_last_mask_q <= select_2359;
      counts_supervised_q <= select_2599;
      counts_nearer_q <= select_2614;
      counts_turned_left_q <= select_2712;
      counts_turned_right_q <= select_2719;
      registration_half_measured_q <= select_2778;
      registration_half_votes_up_q <= and_2751_s17_q ? 7'h0 : sum_2792;
      registration_half_half_votes_up_q <= and_2751_s17_q ? 7'h0 : sum_2806;
      patches_place_0_column_q <= sample_pair_whole_s17_q ? select_1806 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s17_q ? select_1807 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3012;
      patches_place_1_column_q <= sample_pair_whole_s17_q ? select_1834 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s17_q ? select_1835 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3017;
      patches_codes_at_q <= select_3108;
      patches_codes_further_q <= equal_1785_s17_q ? patches_codes_further_q : select_3113;
      patches_next_codes_q <= select_3121;
      patches_summed_first_q <= select_3499;
      product_rest_q <= select_3928;
      disagree_q <= equal_575_s17_q ? select_3872 : disagree_q;
      began_q <= not_2048 & (began_q | select_2035_s17_q);
      seen_x_q <= select_2035_s17_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s17_q ? 4'h0 : select_4048;
      seen_column_q <= select_2035_s17_q ? 8'h0 : (seen_column_q + {7'h0, equal_2041});
      seen_rows_left_q <= select_4054;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s17_q ? 13'h0 : (seen_base_q + {6'h0, select_2038});
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
      averager_detail_0_q <= select_2178;
      averager_detail_1_q <= select_2186;
      census_columns_values_1_cell_2_mask_q <= select_2219;
      census_columns_values_2_cell_2_mask_q <= select_2235;
      census_columns_values_2_cell_3_mask_q <= select_2238;
      census_columns_values_2_cell_4_mask_q <= select_2241;
      census_columns_values_3_cell_0_mask_q <= select_2242;
      census_columns_values_3_cell_1_mask_q <= select_2245;
      census_columns_values_3_cell_2_mask_q <= select_2246;
      census_columns_values_3_cell_3_mask_q <= select_2249;
      sharpness_last_mask_q <= and_550_s17_q ? whole_2_s17_q : sharpness_last_mask_q;
      box_textured_columns_values_0_q <= select_3948;
      box_textured_columns_values_1_q <= select_3951;
      box_textured_columns_values_2_q <= select_3954;
      box_textured_columns_values_3_q <= select_3957;
      box_textured_columns_values_4_q <= select_3960;
      box_explained_sum_sums_values_0_q <= select_3981;
      box_shown_sum_sums_values_0_q <= equal_575_s17_q ? box_shown_sum_sums_values_0_q : select_3998;
      box_nearer_sum_sums_values_0_q <= equal_575_s17_q ? box_nearer_sum_sums_values_0_q : select_4016;
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
  logic [2:0] select_509_s18_q;
  logic row_starts_s18_q;
  logic [6:0] last_s18_q;
  logic and_550_s18_q;
  logic equal_570_s18_q;
  logic equal_575_s18_q;
  logic not_576_s18_q;
  logic so_s18_q;
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
  logic less_675_s18_q;
  logic less_676_s18_q;
  logic and_684_s18_q;
  logic whole_16_s18_q;
  logic and_710_s18_q;
  logic [11:0] sum_725_s18_q;
  logic [9:0] sum_728_s18_q;
  logic and_736_s18_q;
  logic and_740_s18_q;
  logic less_741_s18_q;
  logic less_745_s18_q;
  logic less_747_s18_q;
  logic equal_1608_s18_q;
  logic [1:0] sum_1614_s18_q;
  logic equal_1616_s18_q;
  logic equal_1618_s18_q;
  logic equal_1620_s18_q;
  logic equal_1622_s18_q;
  logic equal_1624_s18_q;
  logic equal_1626_s18_q;
  logic less_1639_s18_q;
  logic [19:0] select_1664_s18_q;
  logic equal_1665_s18_q;
  logic [11:0] sum_1672_s18_q;
  logic and_1673_s18_q;
  logic select_1690_s18_q;
  logic equal_1691_s18_q;
  logic equal_1785_s18_q;
  logic equal_1787_s18_q;
  logic equal_1790_s18_q;
  logic or_1791_s18_q;
  logic not_1792_s18_q;
  logic select_1801_s18_q;
  logic [8:0] sum_1804_s18_q;
  logic [8:0] sum_1808_s18_q;
  logic [4:0] select_1815_s18_q;
  logic select_1821_s18_q;
  logic [8:0] sum_1836_s18_q;
  logic equal_1850_s18_q;
  logic equal_1854_s18_q;
  logic [3:0] select_1859_s18_q;
  logic not_1988_s18_q;
  logic not_2048_s18_q;
  logic [7:0] sum_2058_s18_q;
  logic [3:0] difference_2070_s18_q;
  logic or_2078_s18_q;
  logic [23:0] select_2089_s18_q;
  logic [4:0] around_s18_q;
  logic less_2123_s18_q;
  logic and_2134_s18_q;
  logic [11:0] sum_2266_s18_q;
  logic [9:0] sum_2269_s18_q;
  logic equal_2277_s18_q;
  logic equal_2292_s18_q;
  logic [13:0] select_2300_s18_q;
  logic not_2308_s18_q;
  logic not_2311_s18_q;
  logic not_2318_s18_q;
  logic not_2321_s18_q;
  logic [27:0] select_2356_s18_q;
  logic and_2369_s18_q;
  logic and_2381_s18_q;
  logic [8:0] select_2388_s18_q;
  logic [8:0] select_2392_s18_q;
  logic equal_2395_s18_q;
  logic less_2396_s18_q;
  logic [11:0] select_2401_s18_q;
  logic equal_2439_s18_q;
  logic equal_2466_s18_q;
  logic and_2591_s18_q;
  logic not_2616_s18_q;
  logic [4:0] e_s18_q;
  logic [9:0] select_2642_s18_q;
  logic [9:0] select_2645_s18_q;
  logic and_2693_s18_q;
  logic and_2751_s18_q;
  logic [7:0] select_2771_s18_q;
  logic [1:0] select_2781_s18_q;
  logic [1:0] select_2796_s18_q;
  logic [11:0] select_2849_s18_q;
  logic and_2857_s18_q;
  logic [11:0] select_2864_s18_q;
  logic and_2875_s18_q;
  logic and_2879_s18_q;
  logic and_2911_s18_q;
  logic and_2919_s18_q;
  logic [8:0] other_s18_q;
  logic [2:0] select_3134_s18_q;
  logic [8:0] select_3149_s18_q;
  logic xor_3164_s18_q;
  logic xor_3182_s18_q;
  logic xor_3194_s18_q;
  logic xor_3206_s18_q;
  logic xor_3218_s18_q;
  logic or_3227_s18_q;
  logic or_3231_s18_q;
  logic or_3235_s18_q;
  logic or_3242_s18_q;
  logic or_3246_s18_q;
  logic or_3250_s18_q;
  logic or_3257_s18_q;
  logic or_3261_s18_q;
  logic or_3265_s18_q;
  logic or_3275_s18_q;
  logic or_3279_s18_q;
  logic or_3283_s18_q;
  logic or_3291_s18_q;
  logic or_3295_s18_q;
  logic or_3299_s18_q;
  logic or_3306_s18_q;
  logic or_3310_s18_q;
  logic or_3314_s18_q;
  logic or_3324_s18_q;
  logic or_3328_s18_q;
  logic or_3332_s18_q;
  logic and_3337_s18_q;
  logic or_3338_s18_q;
  logic equal_3459_s18_q;
  logic [9:0] select_3545_s18_q;
  logic [2:0] select_3546_s18_q;
  logic [4:0] select_3547_s18_q;
  logic [9:0] select_3555_s18_q;
  logic equal_3556_s18_q;
  logic less_3584_s18_q;
  logic [2:0] fraction_s18_q;
  logic [7:0] select_3607_s18_q;
  logic sum_3608_s18_q;
  logic [6:0] sum_3610_s18_q;
  logic equal_3652_s18_q;
  logic equal_3861_s18_q;
  logic or_3864_s18_q;
  logic select_3872_s18_q;
  logic not_3877_s18_q;
  logic equal_3886_s18_q;
  logic equal_3888_s18_q;
  logic equal_3889_s18_q;
  logic equal_3890_s18_q;
  logic equal_3891_s18_q;
  logic equal_4031_s18_q;
  logic [31:0] select_4130_s18_q;
  logic [9:0] select_4137_s18_q;
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
      select_509_s18_q <= select_509_s17_q[2:0];
      row_starts_s18_q <= row_starts_s17_q;
      last_s18_q <= last_s17_q;
      and_550_s18_q <= and_550_s17_q;
      equal_570_s18_q <= equal_570_s17_q;
      equal_575_s18_q <= equal_575_s17_q;
      not_576_s18_q <= not_576_s17_q;
      so_s18_q <= so_s17_q;
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
      less_675_s18_q <= less_675_s17_q;
      less_676_s18_q <= less_676_s17_q;
      and_684_s18_q <= and_684_s17_q;
      whole_16_s18_q <= whole_16;
      and_710_s18_q <= census_columns_values_1_cell_2_mask_q & and_684_s17_q;
      sum_725_s18_q <= {1'b0, sum_721} + {2'h0, sum_724_s17_q};
      sum_728_s18_q <= sum_728_s17_q;
      and_736_s18_q <= and_736;
      and_740_s18_q <= and_736 & less_739_s17_q;
      less_741_s18_q <= less_741_s17_q;
      less_745_s18_q <= less_745_s17_q;
      less_747_s18_q <= less_747_s17_q;
      equal_1608_s18_q <= equal_1608_s17_q;
      sum_1614_s18_q <= sum_1614_s17_q;
      equal_1616_s18_q <= equal_1616_s17_q;
      equal_1618_s18_q <= equal_1618_s17_q;
      equal_1620_s18_q <= equal_1620_s17_q;
      equal_1622_s18_q <= equal_1622_s17_q;
      equal_1624_s18_q <= equal_1624_s17_q;
      equal_1626_s18_q <= equal_1626_s17_q;
      less_1639_s18_q <= less_1639_s17_q;
      select_1664_s18_q <= equal_1663_s17_q ? registration_sums_rdata_s17_q[19:0] : 20'h0;
      equal_1665_s18_q <= equal_1665;
      sum_1672_s18_q <= sum_1672;
      and_1673_s18_q <= and_1673_s17_q;
      select_1690_s18_q <= select_1690_s17_q;
      equal_1691_s18_q <= equal_1691_s17_q;
      equal_1785_s18_q <= equal_1785_s17_q;
      equal_1787_s18_q <= equal_1787_s17_q;
      equal_1790_s18_q <= equal_1790_s17_q;
      or_1791_s18_q <= or_1791_s17_q;
      not_1792_s18_q <= not_1792_s17_q;
      select_1801_s18_q <= select_1801_s17_q[0];
      sum_1804_s18_q <= {1'b0, select_544_s17_q, select_509_s17_q[3]} + 9'h1;
      sum_1808_s18_q <= {1'b0, select_1806} + {{3{select_1807[5]}}, select_1807};
      select_1815_s18_q <= select_1815_s17_q;
      select_1821_s18_q <= select_1821_s17_q;
      sum_1836_s18_q <= {1'b0, select_1834} + {{3{select_1835[5]}}, select_1835};
      equal_1850_s18_q <= equal_1850;
      equal_1854_s18_q <= equal_1854;
      select_1859_s18_q <= select_1859_s17_q;
      not_1988_s18_q <= not_1988_s17_q;
      not_2048_s18_q <= not_2048;
      sum_2058_s18_q <= {2'h0, x_s17_q[7:2]} + 8'hff;
      difference_2070_s18_q <= {1'b0, textured_2_s17_q} - {1'b0, select_2069};
      or_2078_s18_q <= or_2078_s17_q;
      select_2089_s18_q <= select_2089;
      around_s18_q <= around;
      less_2123_s18_q <= {1'b0, around[4:1]} < n;
      and_2134_s18_q <= and_2134_s17_q;
      sum_2266_s18_q <= {1'b0, sum_2262} + {2'h0, sum_2265_s17_q};
      sum_2269_s18_q <= sum_2269_s17_q;
      equal_2277_s18_q <= equal_2277_s17_q;
      equal_2292_s18_q <= equal_2292_s17_q;
      select_2300_s18_q <= (select_2295 < select_2293) ? select_2293 : select_2295;
      not_2308_s18_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2306);
      not_2311_s18_q <= ~({3'h0, select_2295[13:2]} < sum_2306);
      not_2318_s18_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2316);
      not_2321_s18_q <= ~({3'h0, select_2293[13:2]} < sum_2316);
      select_2356_s18_q <= sample_pair_whole_s17_q ? {detail_2, detail} : 28'h0;
      and_2369_s18_q <= and_2369;
      and_2381_s18_q <= and_2381;
      select_2388_s18_q <= and_2369 ? contrast_s17_q : 9'h0;
      select_2392_s18_q <= and_2381 ? contrast_2_s17_q : 9'h0;
      equal_2395_s18_q <= x_s17_q[7:3] == 5'h0;
      less_2396_s18_q <= 7'h2 < {x_s17_q[4:0], slot_s17_q[2:1]};
      select_2401_s18_q <= select_2401;
      equal_2439_s18_q <= {x_s17_q[4:0], slot_s17_q} == 8'h0;
      equal_2466_s18_q <= equal_2466_s17_q;
      and_2591_s18_q <= and_2591_s17_q;
      not_2616_s18_q <= not_2616_s17_q;
      e_s18_q <= e;
      select_2642_s18_q <= select_2642_s17_q;
      select_2645_s18_q <= select_2645_s17_q;
      and_2693_s18_q <= and_2693_s17_q;
      and_2751_s18_q <= and_2751_s17_q;
      select_2771_s18_q <= equal_575_s17_q ? 8'h0 : (so_s17_q ? select_2769 : 8'h0);
      select_2781_s18_q <= equal_1701_s17_q ? {and_2780, and_2752_s17_q} : 2'h0;
      select_2796_s18_q <= equal_1701_s17_q ? {and_2795, and_2752_s17_q} : 2'h0;
      select_2849_s18_q <= select_2849;
      and_2857_s18_q <= equal_575_s17_q & (x_s17_q[6] & and_2855);
      select_2864_s18_q <= select_2864;
      and_2875_s18_q <= equal_575_s17_q & (x_s17_q[6] & and_2873);
      and_2879_s18_q <= and_2879;
      and_2911_s18_q <= equal_575_s17_q & (x_s17_q[6] & and_2909);
      and_2919_s18_q <= x_s17_q[6] & and_2918;
      other_s18_q <= other[44:36];
      select_3134_s18_q <= and_1957_s17_q ? {and_3133, xor_3132, parity_3126} : 3'h0;
      select_3149_s18_q <= select_3149_s17_q[44:36];
      xor_3164_s18_q <= xor_3164;
      xor_3182_s18_q <= xor_3164 ^ parity_3181;
      xor_3194_s18_q <= xor_3185 ^ (^{select_3149_s17_q[41:36], other[41:36]});
      xor_3206_s18_q <= xor_3197 ^ (^{select_3149_s17_q[23:18], other[23:18]});
      xor_3218_s18_q <= xor_3209 ^ (^{select_3149_s17_q[32:27], other[32:27]});
      or_3227_s18_q <= (xor_3158 & xor_3161) | (xor_3155 & (xor_3158 | xor_3161));
      or_3231_s18_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3235_s18_q <= (xor_3173 & xor_3176) | (xor_3170 & (xor_3173 | xor_3176));
      or_3242_s18_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3246_s18_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3250_s18_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3257_s18_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3261_s18_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3265_s18_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3275_s18_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3279_s18_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3283_s18_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3291_s18_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3295_s18_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3299_s18_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3306_s18_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3310_s18_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3314_s18_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3324_s18_q <= (xor_3188 & xor_3191) | (xor_3185 & (xor_3188 | xor_3191));
      or_3328_s18_q <= (xor_3200 & xor_3203) | (xor_3197 & (xor_3200 | xor_3203));
      or_3332_s18_q <= (xor_3212 & xor_3215) | (xor_3209 & (xor_3212 | xor_3215));
      and_3337_s18_q <= xor_3167 & xor_3179;
      or_3338_s18_q <= xor_3167 | xor_3179;
      equal_3459_s18_q <= equal_3459_s17_q;
      select_3545_s18_q <= select_3545_s17_q;
      select_3546_s18_q <= select_3546_s17_q[2:0];
      select_3547_s18_q <= select_3547_s17_q;
      select_3555_s18_q <= patches_peak_far_q;
      equal_3556_s18_q <= equal_3556_s17_q;
      less_3584_s18_q <= less_3584_s17_q;
      fraction_s18_q <= fraction;
      select_3607_s18_q <= select_3607;
      sum_3608_s18_q <= sum_3608[0];
      sum_3610_s18_q <= sum_3610;
      equal_3652_s18_q <= equal_3652_s17_q;
      equal_3861_s18_q <= select_2642_s17_q[9:3] == 7'h0;
      or_3864_s18_q <= or_3864;
      select_3872_s18_q <= select_3872;
      not_3877_s18_q <= ~({sum_3875, select_2645_s17_q[0]} < {2'h0, select_2642_s17_q});
      equal_3886_s18_q <= equal_3886_s17_q;
      equal_3888_s18_q <= equal_3888_s17_q;
      equal_3889_s18_q <= equal_3889_s17_q;
      equal_3890_s18_q <= equal_3890_s17_q;
      equal_3891_s18_q <= equal_3891_s17_q;
      equal_4031_s18_q <= equal_4031_s17_q;
      select_4130_s18_q <= select_4130;
      select_4137_s18_q <= select_4137_s17_q;
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
  assign texture = sum_725_s18_q + {2'h0, sum_728_s18_q};
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1614_s18_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1667;
  assign select_1667 = equal_1665_s18_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1803;
  assign select_1803 = equal_1691_s18_q ? patches_place_0_valid_q : (select_1690_s18_q ? patches_place_0_valid_q : select_1801_s18_q);
  // hls/stages/patches.hpp:132
  logic equal_1809;
  assign equal_1809 = {sum_1808_s18_q, sum_1804_s18_q[0], select_509_s18_q} == {1'b0, sum_1804_s18_q[8:1], 4'h0};
  // hls/stages/patches.hpp:127
  logic select_1832;
  assign select_1832 = equal_1691_s18_q ? patches_place_1_valid_q : (select_1690_s18_q ? select_1801_s18_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:132
  logic equal_1837;
  assign equal_1837 = {sum_1836_s18_q[8], sum_1804_s18_q, select_509_s18_q} == {1'b0, sum_1836_s18_q[7:0], 4'h0};
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1275
  logic select_2046;
  assign select_2046 = marks_first_s18_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2047;
  assign sum_2047 = {1'b0, {5{select_2046}}, 1'b0, {2{select_2046}}, 1'b0, select_2046} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1111
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2058_s18_q[7]}}, sum_2058_s18_q, x_s18_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2060;
  assign sum_2060 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1094
  logic [4:0] t;
  assign t = {difference_2070_s18_q[3], difference_2070_s18_q} + (equal_570_s18_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic [47:0] select_2090;
  assign select_2090 = or_2078_s18_q ? {select_2089_s18_q[23], 1'b0, select_2089_s18_q[22], 1'b0, select_2089_s18_q[21], 1'b0, select_2089_s18_q[20], 1'b0, select_2089_s18_q[19], 1'b0, select_2089_s18_q[18], 1'b0, select_2089_s18_q[17], 1'b0, select_2089_s18_q[16], 1'b0, select_2089_s18_q[15], 1'b0, select_2089_s18_q[14], 1'b0, select_2089_s18_q[13], 1'b0, select_2089_s18_q[12], 1'b0, select_2089_s18_q[11], 1'b0, select_2089_s18_q[10], 1'b0, select_2089_s18_q[9], 1'b0, select_2089_s18_q[8], 1'b0, select_2089_s18_q[7], 1'b0, select_2089_s18_q[6], 1'b0, select_2089_s18_q[5], 1'b0, select_2089_s18_q[4], 1'b0, select_2089_s18_q[3], 1'b0, select_2089_s18_q[2], 1'b0, select_2089_s18_q[1], 1'b0, select_2089_s18_q[0], 1'b0} : {1'b0, select_2089_s18_q[23], 1'b0, select_2089_s18_q[22], 1'b0, select_2089_s18_q[21], 1'b0, select_2089_s18_q[20], 1'b0, select_2089_s18_q[19], 1'b0, select_2089_s18_q[18], 1'b0, select_2089_s18_q[17], 1'b0, select_2089_s18_q[16], 1'b0, select_2089_s18_q[15], 1'b0, select_2089_s18_q[14], 1'b0, select_2089_s18_q[13], 1'b0, select_2089_s18_q[12], 1'b0, select_2089_s18_q[11], 1'b0, select_2089_s18_q[10], 1'b0, select_2089_s18_q[9], 1'b0, select_2089_s18_q[8], 1'b0, select_2089_s18_q[7], 1'b0, select_2089_s18_q[6], 1'b0, select_2089_s18_q[5], 1'b0, select_2089_s18_q[4], 1'b0, select_2089_s18_q[3], 1'b0, select_2089_s18_q[2], 1'b0, select_2089_s18_q[1], 1'b0, select_2089_s18_q[0]};
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2107;
  assign sum_2107 = {1'b0, around_s18_q} + {2'h0, around_s18_q[4:1]};
  // hls/stages/agreement.hpp:520
  logic select_2250;
  assign select_2250 = and_550_s18_q ? census_columns_values_2_cell_4_mask_s18_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2270;
  assign sum_2270 = sum_2266_s18_q + {2'h0, sum_2269_s18_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2272;
  assign select_2272 = and_550_s18_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2273;
  assign select_2273 = and_550_s18_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2302;
  assign sum_2302 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:520
  logic [13:0] select_2357;
  assign select_2357 = and_550_s18_q ? select_2356_s18_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2358;
  assign select_2358 = and_550_s18_q ? select_2356_s18_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2356_s18_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2356_s18_q[27:14]};
  // hls/stages/census.hpp:375
  logic [23:0] sum_2389;
  assign sum_2389 = (equal_2277_s18_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2388_s18_q};
  logic [23:0] sum_2393;
  assign sum_2393 = (equal_2277_s18_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2392_s18_q};
  // hls/stages/census.hpp:427
  logic less_2397;
  assign less_2397 = x_s18_q[4:0] < 5'h3;
  logic [23:0] select_2402;
  assign select_2402 = slot_s18_q ? {select_2401_s18_q[11], 1'b0, select_2401_s18_q[10], 1'b0, select_2401_s18_q[9], 1'b0, select_2401_s18_q[8], 1'b0, select_2401_s18_q[7], 1'b0, select_2401_s18_q[6], 1'b0, select_2401_s18_q[5], 1'b0, select_2401_s18_q[4], 1'b0, select_2401_s18_q[3], 1'b0, select_2401_s18_q[2], 1'b0, select_2401_s18_q[1], 1'b0, select_2401_s18_q[0], 1'b0} : {1'b0, select_2401_s18_q[11], 1'b0, select_2401_s18_q[10], 1'b0, select_2401_s18_q[9], 1'b0, select_2401_s18_q[8], 1'b0, select_2401_s18_q[7], 1'b0, select_2401_s18_q[6], 1'b0, select_2401_s18_q[5], 1'b0, select_2401_s18_q[4], 1'b0, select_2401_s18_q[3], 1'b0, select_2401_s18_q[2], 1'b0, select_2401_s18_q[1], 1'b0, select_2401_s18_q[0]};
  // hls/stages/census.hpp:390
  logic and_2406;
  assign and_2406 = less_2397 & (~((sharpness_sums_contrast_1_q & select_2402) == 24'h0));
  logic and_2416;
  assign and_2416 = less_2397 & (~((sharpness_sums_contrast_0_q & select_2402) == 24'h0));
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2629;
  assign sum_2629 = {1'b0, e_s18_q} + {2'h0, e_s18_q[4:1]};
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2646;
  assign sum_2646 = {1'b0, select_2645_s18_q} + {3'h0, select_2645_s18_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2772;
  assign sum_2772 = registration_half_across_q + {{6{select_2771_s18_q[7]}}, select_2771_s18_q};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2783;
  assign select_2783 = equal_575_s18_q ? 2'h0 : (so_s18_q ? select_2781_s18_q : 2'h0);
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2784;
  assign sum_2784 = registration_half_votes_down_q + {{5{select_2783[1]}}, select_2783};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2798;
  assign select_2798 = equal_575_s18_q ? 2'h0 : (so_s18_q ? select_2796_s18_q : 2'h0);
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2799;
  assign sum_2799 = registration_half_half_votes_down_q + {{5{select_2798[1]}}, select_2798};
  // hls/stages/agreement.hpp:788
  logic and_2840;
  assign and_2840 = equal_575_s18_q & (x_s18_q[6] & (not_1988_s18_q & less_1639_s18_q));
  logic [11:0] select_2851;
  assign select_2851 = equal_575_s18_q ? (x_s18_q[6] ? select_2849_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2859;
  assign sum_2859 = {{2{select_2851[11]}}, select_2851} + (and_2857_s18_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2866;
  assign select_2866 = equal_575_s18_q ? (x_s18_q[6] ? select_2864_s18_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2868;
  assign sum_2868 = {{2{select_2866[11]}}, select_2866} + (and_2857_s18_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2880;
  assign not_2880 = ~and_2879_s18_q;
  logic less_2881;
  assign less_2881 = $signed({9'h1, {2{not_2880}}, and_2879_s18_q}) < $signed(registration_up_q[13:2]);
  logic select_2882;
  assign select_2882 = and_2875_s18_q ? less_2881 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2886;
  assign and_2886 = x_s18_q[6] & (not_1988_s18_q & (less_1639_s18_q & (x_s18_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2887;
  assign and_2887 = equal_575_s18_q & and_2886;
  // hls/stages/registration.hpp:242
  logic less_2888;
  assign less_2888 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2890;
  assign less_2890 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2892;
  assign equal_2892 = x_s18_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2896;
  assign and_2896 = equal_575_s18_q & (x_s18_q[6] & (not_1988_s18_q & (less_1639_s18_q & equal_2892)));
  // hls/stages/agreement.hpp:1142
  logic and_2903;
  assign and_2903 = x_s18_q[6] & (not_1988_s18_q & (less_1639_s18_q & (x_s18_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2921;
  assign and_2921 = registration_votes_up_q & registration_other_down_q;
  logic select_2923;
  assign select_2923 = registration_votes_down_q ? (registration_other_up_q | and_2921) : and_2921;
  // hls/stages/registration.hpp:138
  logic and_2925;
  assign and_2925 = (equal_575_s18_q & and_2919_s18_q) & (registration_other_enough_q & select_2923);
  logic and_2927;
  assign and_2927 = registration_enough_q & ((and_2911_s18_q & (less_2890 | less_2888)) | and_2925);
  // hls/stages/agreement.hpp:275
  logic [2:0] select_3136;
  assign select_3136 = equal_1787_s18_q ? 3'h0 : (or_1791_s18_q ? select_3134_s18_q : 3'h0);
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3139;
  assign sum_3139 = {7'h0, patches_set_q} + (equal_1790_s18_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3219;
  assign xor_3219 = xor_3206_s18_q ^ xor_3218_s18_q;
  // hls/stages/count_bits.hpp:25
  logic or_3344;
  assign or_3344 = (xor_3206_s18_q & xor_3218_s18_q) | (xor_3194_s18_q & (xor_3206_s18_q | xor_3218_s18_q));
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3558;
  assign select_3558 = equal_1785_s18_q ? (equal_3556_s18_q ? sum_3139 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3585;
  assign sum_3585 = select_3547_s18_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:587
  logic [7:0] difference_3605;
  assign difference_3605 = {sum_3585, select_3547_s18_q[2:0], 3'h0} - {5'h0, fraction_s18_q};
  logic [7:0] select_3606;
  assign select_3606 = less_3584_s18_q ? difference_3605 : {sum_3585, select_3547_s18_q[2:0], fraction_s18_q};
  // hls/stages/patches.hpp:604
  logic [18:0] product_3611;
  assign product_3611 = $signed({{11{select_3607_s18_q[7]}}, select_3607_s18_q}) * $signed({{8{sum_3610_s18_q[6]}}, sum_3610_s18_q, sum_3608_s18_q, select_3546_s18_q});
  // hls/stages/patches.hpp:612
  logic [11:0] sum_3771;
  assign sum_3771 = {sum_3610_s18_q[6], sum_3610_s18_q, sum_3608_s18_q, select_3546_s18_q} + 12'h1;
  // hls/stages/agreement.hpp:1135
  logic select_3878;
  assign select_3878 = equal_3861_s18_q ? ((~or_3864_s18_q) & (~select_3872_s18_q)) : not_3877_s18_q;
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3880;
  assign select_3880 = x_s18_q[6] ? (equal_1608_s18_q ? good_q : {select_3878, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:1147
  logic equal_3883;
  assign equal_3883 = x_s18_q == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic [4:0] select_3962;
  assign select_3962 = so_s18_q ? (ends_cell_s18_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4034;
  assign select_4034 = equal_2466_s18_q ? (equal_4031_s18_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4037;
  assign select_4037 = and_550_s18_q ? (equal_2466_s18_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s18_en) begin
      moments_most_before_q <= equal_575_s18_q ? select_2300_s18_q : moments_most_before_q;
      moments_left_alone_q <= equal_575_s18_q ? not_2308_s18_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_575_s18_q ? not_2311_s18_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_575_s18_q ? not_2318_s18_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_575_s18_q ? not_2321_s18_q : moments_right_other_stops_q;
      sharpness_sums_contrast_0_q <= and_550_s18_q ? sum_2389 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_550_s18_q ? sum_2393 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2751_s18_q ? 14'h0 : sum_2772;
      registration_half_votes_down_q <= and_2751_s18_q ? 7'h0 : sum_2784;
      registration_half_half_votes_down_q <= and_2751_s18_q ? 7'h0 : sum_2799;
      registration_down_q <= and_2840 ? sum_2859 : registration_down_q;
      registration_up_q <= and_2840 ? sum_2868 : registration_up_q;
      registration_enough_q <= select_2882;
      registration_votes_down_q <= and_2887 ? less_2888 : registration_votes_down_q;
      registration_votes_up_q <= and_2887 ? less_2890 : registration_votes_up_q;
      registration_other_enough_q <= and_2896 ? select_2882 : registration_other_enough_q;
      registration_other_down_q <= and_2896 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2896 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s18_q ? select_1803 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s18_q ? select_1832 : patches_place_1_valid_q;
      patches_set_q <= equal_1785_s18_q ? 3'h0 : select_3136;
      patches_size_q <= sum_3139;
      patches_peak_size_q <= select_3558;
      good_q <= equal_575_s18_q ? select_3880 : good_q;
      map_row_q <= and_550_s18_q ? select_4034 : map_row_q;
      map_width_q <= select_4037;
      write_half_q <= marks_first_s18_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2046;
      done_q <= not_2048_s18_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s18_q;
      said_q <= equal_575_s18_q & equal_3883;
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
      census_columns_values_3_cell_4_mask_q <= select_2250;
      census_changes_values_0_left_q <= and_550_s18_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_550_s18_q ? sum_2270 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2272;
      census_changes_values_1_right_q <= select_2273;
      sharpness_last_detail_0_q <= select_2357;
      sharpness_last_detail_1_q <= select_2358;
      box_textured_sum_sums_values_0_q <= equal_575_s18_q ? box_textured_sum_sums_values_0_q : select_3962;
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
  logic and_550_s19_q;
  logic equal_575_s19_q;
  logic not_576_s19_q;
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
  logic less_675_s19_q;
  logic less_676_s19_q;
  logic and_684_s19_q;
  logic and_709_s19_q;
  logic and_710_s19_q;
  logic [12:0] sum_730_s19_q;
  logic and_736_s19_q;
  logic and_740_s19_q;
  logic less_741_s19_q;
  logic less_745_s19_q;
  logic less_747_s19_q;
  logic equal_1608_s19_q;
  logic [1:0] sum_1614_s19_q;
  logic equal_1616_s19_q;
  logic equal_1618_s19_q;
  logic equal_1620_s19_q;
  logic equal_1622_s19_q;
  logic equal_1624_s19_q;
  logic equal_1626_s19_q;
  logic [19:0] sum_1668_s19_q;
  logic [11:0] sum_1672_s19_q;
  logic and_1673_s19_q;
  logic select_1690_s19_q;
  logic equal_1691_s19_q;
  logic equal_1785_s19_q;
  logic equal_1787_s19_q;
  logic not_1792_s19_q;
  logic select_1801_s19_q;
  logic or_1811_s19_q;
  logic [4:0] select_1815_s19_q;
  logic select_1821_s19_q;
  logic or_1839_s19_q;
  logic or_1852_s19_q;
  logic or_1856_s19_q;
  logic [3:0] select_1859_s19_q;
  logic not_1988_s19_q;
  logic [2:0] index_s19_q;
  logic [10:0] sum_2047_s19_q;
  logic and_2054_s19_q;
  logic less_2055_s19_q;
  logic [2:0] index_2_s19_q;
  logic [10:0] sum_2060_s19_q;
  logic equal_2073_s19_q;
  logic not_2093_s19_q;
  logic not_2109_s19_q;
  logic less_2123_s19_q;
  logic and_2134_s19_q;
  logic equal_2277_s19_q;
  logic [12:0] sum_2278_s19_q;
  logic equal_2292_s19_q;
  logic not_2304_s19_q;
  logic not_2314_s19_q;
  logic [12:0] select_2371_s19_q;
  logic [12:0] select_2383_s19_q;
  logic equal_2395_s19_q;
  logic less_2396_s19_q;
  logic and_2406_s19_q;
  logic and_2416_s19_q;
  logic equal_2439_s19_q;
  logic and_2591_s19_q;
  logic not_2616_s19_q;
  logic not_2631_s19_q;
  logic [9:0] select_2642_s19_q;
  logic [9:0] select_2645_s19_q;
  logic less_2647_s19_q;
  logic and_2693_s19_q;
  logic equal_2892_s19_q;
  logic not_2905_s19_q;
  logic and_2927_s19_q;
  logic parity_3223_s19_q;
  logic or_3227_s19_q;
  logic or_3231_s19_q;
  logic or_3235_s19_q;
  logic or_3242_s19_q;
  logic or_3246_s19_q;
  logic or_3250_s19_q;
  logic or_3257_s19_q;
  logic or_3261_s19_q;
  logic or_3265_s19_q;
  logic or_3275_s19_q;
  logic or_3279_s19_q;
  logic or_3283_s19_q;
  logic or_3291_s19_q;
  logic or_3295_s19_q;
  logic or_3299_s19_q;
  logic or_3306_s19_q;
  logic or_3310_s19_q;
  logic or_3314_s19_q;
  logic or_3324_s19_q;
  logic or_3328_s19_q;
  logic or_3332_s19_q;
  logic and_3336_s19_q;
  logic or_3340_s19_q;
  logic or_3344_s19_q;
  logic equal_3459_s19_q;
  logic [9:0] select_3545_s19_q;
  logic and_3559_s19_q;
  logic not_3561_s19_q;
  logic not_3564_s19_q;
  logic [9:0] difference_3565_s19_q;
  logic [7:0] select_3606_s19_q;
  logic [13:0] product_3611_s19_q;
  logic equal_3652_s19_q;
  logic less_3772_s19_q;
  logic or_3864_s19_q;
  logic select_3872_s19_q;
  logic equal_3883_s19_q;
  logic equal_3886_s19_q;
  logic equal_3888_s19_q;
  logic equal_3889_s19_q;
  logic equal_3890_s19_q;
  logic equal_3891_s19_q;
  logic [31:0] select_4130_s19_q;
  logic [9:0] select_4137_s19_q;
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
      and_550_s19_q <= and_550_s18_q;
      equal_575_s19_q <= equal_575_s18_q;
      not_576_s19_q <= not_576_s18_q;
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
      less_675_s19_q <= less_675_s18_q;
      less_676_s19_q <= less_676_s18_q;
      and_684_s19_q <= and_684_s18_q;
      and_709_s19_q <= whole_22 & and_684_s18_q;
      and_710_s19_q <= and_710_s18_q;
      sum_730_s19_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_736_s19_q <= and_736_s18_q;
      and_740_s19_q <= and_740_s18_q;
      less_741_s19_q <= less_741_s18_q;
      less_745_s19_q <= less_745_s18_q;
      less_747_s19_q <= less_747_s18_q;
      equal_1608_s19_q <= equal_1608_s18_q;
      sum_1614_s19_q <= sum_1614_s18_q;
      equal_1616_s19_q <= equal_1616_s18_q;
      equal_1618_s19_q <= equal_1618_s18_q;
      equal_1620_s19_q <= equal_1620_s18_q;
      equal_1622_s19_q <= equal_1622_s18_q;
      equal_1624_s19_q <= equal_1624_s18_q;
      equal_1626_s19_q <= equal_1626_s18_q;
      sum_1668_s19_q <= select_1664_s18_q + {{6{select_1667[13]}}, select_1667};
      sum_1672_s19_q <= sum_1672_s18_q;
      and_1673_s19_q <= and_1673_s18_q;
      select_1690_s19_q <= select_1690_s18_q;
      equal_1691_s19_q <= equal_1691_s18_q;
      equal_1785_s19_q <= equal_1785_s18_q;
      equal_1787_s19_q <= equal_1787_s18_q;
      not_1792_s19_q <= not_1792_s18_q;
      select_1801_s19_q <= select_1801_s18_q;
      or_1811_s19_q <= row_starts_s18_q | (select_1803 & equal_1809);
      select_1815_s19_q <= select_1815_s18_q;
      select_1821_s19_q <= select_1821_s18_q;
      or_1839_s19_q <= row_starts_s18_q | (select_1832 & equal_1837);
      or_1852_s19_q <= row_starts_s18_q | (select_1803 & equal_1850_s18_q);
      or_1856_s19_q <= row_starts_s18_q | (select_1832 & equal_1854_s18_q);
      select_1859_s19_q <= select_1859_s18_q;
      not_1988_s19_q <= not_1988_s18_q;
      index_s19_q <= index[2:0];
      sum_2047_s19_q <= sum_2047;
      and_2054_s19_q <= began_q & (seen_x_q == 4'h0);
      less_2055_s19_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s19_q <= index_2[2:0];
      sum_2060_s19_q <= sum_2060;
      equal_2073_s19_q <= t[4:1] == 4'h0;
      not_2093_s19_q <= ~((good_q & select_2090) == 48'h0);
      not_2109_s19_q <= ~({sum_2107, around_s18_q[0]} < {2'h0, t});
      less_2123_s19_q <= less_2123_s18_q;
      and_2134_s19_q <= and_2134_s18_q;
      equal_2277_s19_q <= equal_2277_s18_q;
      sum_2278_s19_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2270};
      equal_2292_s19_q <= equal_2292_s18_q;
      not_2304_s19_q <= ~({3'h0, counts_turned_left_s18_q} < sum_2302);
      not_2314_s19_q <= ~({3'h0, counts_turned_right_s18_q} < sum_2302);
      select_2371_s19_q <= and_2369_s18_q ? detail_3[14:2] : 13'h0;
      select_2383_s19_q <= and_2381_s18_q ? detail_4[14:2] : 13'h0;
      equal_2395_s19_q <= equal_2395_s18_q;
      less_2396_s19_q <= less_2396_s18_q;
      and_2406_s19_q <= and_2406;
      and_2416_s19_q <= and_2416;
      equal_2439_s19_q <= equal_2439_s18_q;
      and_2591_s19_q <= and_2591_s18_q;
      not_2616_s19_q <= not_2616_s18_q;
      not_2631_s19_q <= ~({sum_2629, e_s18_q[0]} < {2'h0, t});
      select_2642_s19_q <= select_2642_s18_q;
      select_2645_s19_q <= select_2645_s18_q;
      less_2647_s19_q <= {sum_2646, select_2645_s18_q[1:0]} < {3'h0, select_2642_s18_q};
      and_2693_s19_q <= and_2693_s18_q;
      equal_2892_s19_q <= equal_2892;
      not_2905_s19_q <= ~(equal_575_s18_q & and_2903);
      and_2927_s19_q <= and_2927;
      parity_3223_s19_q <= ^{xor_3219, xor_3182_s18_q, select_3149_s18_q, other_s18_q};
      or_3227_s19_q <= or_3227_s18_q;
      or_3231_s19_q <= or_3231_s18_q;
      or_3235_s19_q <= or_3235_s18_q;
      or_3242_s19_q <= or_3242_s18_q;
      or_3246_s19_q <= or_3246_s18_q;
      or_3250_s19_q <= or_3250_s18_q;
      or_3257_s19_q <= or_3257_s18_q;
      or_3261_s19_q <= or_3261_s18_q;
      or_3265_s19_q <= or_3265_s18_q;
      or_3275_s19_q <= or_3275_s18_q;
      or_3279_s19_q <= or_3279_s18_q;
      or_3283_s19_q <= or_3283_s18_q;
      or_3291_s19_q <= or_3291_s18_q;
      or_3295_s19_q <= or_3295_s18_q;
      or_3299_s19_q <= or_3299_s18_q;
      or_3306_s19_q <= or_3306_s18_q;
      or_3310_s19_q <= or_3310_s18_q;
      or_3314_s19_q <= or_3314_s18_q;
      or_3324_s19_q <= or_3324_s18_q;
      or_3328_s19_q <= or_3328_s18_q;
      or_3332_s19_q <= or_3332_s18_q;
      and_3336_s19_q <= xor_3182_s18_q & (^{xor_3219, select_3149_s18_q, other_s18_q});
      or_3340_s19_q <= and_3337_s18_q | (xor_3164_s18_q & or_3338_s18_q);
      or_3344_s19_q <= or_3344;
      equal_3459_s19_q <= equal_3459_s18_q;
      select_3545_s19_q <= select_3545_s18_q;
      and_3559_s19_q <= equal_1785_s18_q & equal_3556_s18_q;
      not_3561_s19_q <= ~(select_3547_s18_q[3:0] == 4'h0);
      not_3564_s19_q <= ~(select_3555_s18_q < select_3545_s18_q);
      difference_3565_s19_q <= select_3555_s18_q - select_3545_s18_q;
      select_3606_s19_q <= select_3606;
      product_3611_s19_q <= product_3611[18:5];
      equal_3652_s19_q <= equal_3652_s18_q;
      less_3772_s19_q <= {{4{sum_3771[11]}}, sum_3771} < 16'h3;
      or_3864_s19_q <= or_3864_s18_q;
      select_3872_s19_q <= select_3872_s18_q;
      equal_3883_s19_q <= equal_3883;
      equal_3886_s19_q <= equal_3886_s18_q;
      equal_3888_s19_q <= equal_3888_s18_q;
      equal_3889_s19_q <= equal_3889_s18_q;
      equal_3890_s19_q <= equal_3890_s18_q;
      equal_3891_s19_q <= equal_3891_s18_q;
      select_4130_s19_q <= select_4130_s18_q;
      select_4137_s19_q <= select_4137_s18_q;
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
  logic [13:0] sum_731;
  assign sum_731 = {2'h0, census_changes_values_1_left_s19_q} + {1'b0, sum_730_s19_q};
  logic [13:0] sum_732;
  assign sum_732 = {2'h0, census_changes_values_2_left_q} + sum_731;
  // hls/stages/patches.hpp:134
  logic [5:0] select_1822;
  assign select_1822 = or_1811_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1824;
  assign and_1824 = select_1821_s19_q & (~select_1822[5]);
  // hls/stages/patches.hpp:134
  logic [5:0] select_1841;
  assign select_1841 = or_1839_s19_q ? {row_starts_s19_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1843;
  assign and_1843 = select_1821_s19_q & (~select_1841[5]);
  // hls/stages/patches.hpp:135
  logic [4:0] select_1853;
  assign select_1853 = or_1852_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1857;
  assign select_1857 = or_1856_s19_q ? {row_starts_s19_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1853[4] ? select_1857[3:0] : select_1853[3:0];
  logic and_1862;
  assign and_1862 = select_1821_s19_q & (select_1815_s19_q[3] ^ select_1815_s19_q[4]);
  logic and_1867;
  assign and_1867 = sample_pair_whole_s19_q & (and_1862 & ((~select_1853[4]) | (~select_1857[4])));
  // hls/stages/agreement.hpp:1030
  logic and_2094;
  assign and_2094 = good_known_q & not_2093_s19_q;
  // hls/stages/agreement.hpp:1103
  logic is_seen;
  assign is_seen = equal_2073_s19_q ? and_2094 : not_2109_s19_q;
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2274;
  assign select_2274 = and_550_s19_q ? census_changes_values_1_left_s19_q : census_changes_values_2_left_q;
  logic [11:0] select_2275;
  assign select_2275 = and_550_s19_q ? census_changes_values_1_right_s19_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [13:0] sum_2279;
  assign sum_2279 = {2'h0, census_changes_values_1_right_s19_q} + {1'b0, sum_2278_s19_q};
  logic [13:0] sum_2280;
  assign sum_2280 = {2'h0, census_changes_values_2_right_q} + sum_2279;
  // hls/stages/moments.hpp:94
  logic and_2339;
  assign and_2339 = moments_right_alone_s19_q & (moments_right_begins_q | moments_right_other_stops_s19_q);
  logic or_2341;
  assign or_2341 = moments_left_begins_q | (moments_left_other_stops_s19_q | and_2339);
  logic and_2343;
  assign and_2343 = cfg_same_table_i & (moments_left_alone_s19_q ? or_2341 : and_2339);
  // hls/stages/moments.hpp:95
  logic and_2349;
  assign and_2349 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:375
  logic [23:0] select_2373;
  assign select_2373 = equal_2277_s19_q ? {11'h0, select_2371_s19_q} : (sharpness_sums_detail_0_q + {11'h0, select_2371_s19_q});
  logic [23:0] select_2385;
  assign select_2385 = equal_2277_s19_q ? {11'h0, select_2383_s19_q} : (sharpness_sums_detail_1_q + {11'h0, select_2383_s19_q});
  // hls/stages/census.hpp:395
  logic [17:0] select_2408;
  assign select_2408 = (less_2396_s19_q & and_2406_s19_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2418;
  assign select_2418 = (less_2396_s19_q & and_2416_s19_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:216
  logic [1:0] select_2427;
  assign select_2427 = equal_2395_s19_q ? {sharpness_comparing_contrast_0_q[0], and_2416_s19_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2429;
  assign select_2429 = equal_2395_s19_q ? {sharpness_comparing_contrast_1_q[0], and_2406_s19_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:404
  logic xor_2452;
  assign xor_2452 = sharpness_comparing_contrast_0_q[1] ^ and_2406_s19_q;
  logic select_2455;
  assign select_2455 = (equal_2439_s19_q | xor_2452) ? (and_2406_s19_q & xor_2452) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2456;
  assign select_2456 = equal_2395_s19_q ? select_2455 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2458;
  assign xor_2458 = sharpness_comparing_contrast_1_q[1] ^ and_2416_s19_q;
  logic select_2461;
  assign select_2461 = (equal_2439_s19_q | xor_2458) ? (and_2416_s19_q & xor_2458) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2462;
  assign select_2462 = equal_2395_s19_q ? select_2461 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1106
  logic not_2633;
  assign not_2633 = ~(equal_2073_s19_q ? and_2094 : not_2631_s19_q);
  // hls/stages/agreement.hpp:788
  logic and_2636;
  assign and_2636 = ends_cell_s19_q & (not_2616_s19_q & (centres_values_1_textured_s19_q & not_2633));
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_2649;
  assign select_2649 = ((~(select_2642_s19_q[9:4] == 6'h0)) & less_2647_s19_q) ? select_2642_s19_q : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2652;
  assign select_2652 = equal_575_s19_q ? (x_s19_q[6] ? (equal_1608_s19_q ? 10'h0 : select_2649) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1110
  logic and_2670;
  assign and_2670 = centres_values_1_textured_s19_q & (centres_values_1_of_skin_s19_q & not_2633);
  // hls/stages/patches.hpp:127
  logic select_3019;
  assign select_3019 = equal_1691_s19_q ? patches_valid_0_q : (select_1690_s19_q ? patches_valid_0_q : select_1801_s19_q);
  // hls/stages/agreement.hpp:276
  logic select_3022;
  assign select_3022 = sample_pair_whole_s19_q ? (and_1824 ? (sample_present_s19_q & select_3019) : select_3019) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3024;
  assign select_3024 = equal_1691_s19_q ? patches_valid_1_q : (select_1690_s19_q ? select_1801_s19_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3027;
  assign select_3027 = sample_pair_whole_s19_q ? (and_1843 ? (sample_present_s19_q & select_3024) : select_3024) : patches_valid_1_q;
  logic [5:0] select_3030;
  assign select_3030 = sample_pair_whole_s19_q ? (select_1822[5] ? {1'b1, select_1822[4:0]} : (select_1822 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3033;
  assign select_3033 = sample_pair_whole_s19_q ? (select_1841[5] ? {1'b1, select_1841[4:0]} : (select_1841 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3036;
  assign select_3036 = sample_pair_whole_s19_q ? (select_1853[4] ? {1'b1, select_1853[3:0]} : (select_1853 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3039;
  assign select_3039 = sample_pair_whole_s19_q ? (select_1857[4] ? {1'b1, select_1857[3:0]} : (select_1857 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3253;
  assign parity_3253 = ^{or_3250_s19_q, or_3246_s19_q, or_3242_s19_q};
  logic parity_3268;
  assign parity_3268 = ^{or_3265_s19_q, or_3261_s19_q, or_3257_s19_q};
  logic parity_3271;
  assign parity_3271 = ^{or_3265_s19_q, or_3261_s19_q, or_3257_s19_q, or_3250_s19_q, or_3246_s19_q, or_3242_s19_q, or_3235_s19_q, or_3231_s19_q, or_3227_s19_q};
  logic parity_3302;
  assign parity_3302 = ^{or_3299_s19_q, or_3295_s19_q, or_3291_s19_q};
  logic parity_3317;
  assign parity_3317 = ^{or_3314_s19_q, or_3310_s19_q, or_3306_s19_q};
  logic parity_3320;
  assign parity_3320 = ^{or_3314_s19_q, or_3310_s19_q, or_3306_s19_q, or_3299_s19_q, or_3295_s19_q, or_3291_s19_q, or_3283_s19_q, or_3279_s19_q, or_3275_s19_q};
  logic parity_3335;
  assign parity_3335 = ^{or_3332_s19_q, or_3328_s19_q, or_3324_s19_q};
  logic parity_3347;
  assign parity_3347 = ^{or_3344_s19_q, or_3340_s19_q, and_3336_s19_q};
  logic parity_3350;
  assign parity_3350 = ^{or_3344_s19_q, or_3340_s19_q, and_3336_s19_q, or_3332_s19_q, or_3328_s19_q, or_3324_s19_q, or_3314_s19_q, or_3310_s19_q, or_3306_s19_q, or_3299_s19_q, or_3295_s19_q, or_3291_s19_q, or_3283_s19_q, or_3279_s19_q, or_3275_s19_q};
  logic parity_3352;
  assign parity_3352 = ^{or_3344_s19_q, or_3340_s19_q, and_3336_s19_q, or_3332_s19_q, or_3328_s19_q, or_3324_s19_q, or_3314_s19_q, or_3310_s19_q, or_3306_s19_q, or_3299_s19_q, or_3295_s19_q, or_3291_s19_q, or_3283_s19_q, or_3279_s19_q, or_3275_s19_q, or_3265_s19_q, or_3261_s19_q, or_3257_s19_q, or_3250_s19_q, or_3246_s19_q, or_3242_s19_q, or_3235_s19_q, or_3231_s19_q, or_3227_s19_q};
  // hls/stages/count_bits.hpp:25
  logic and_3353;
  assign and_3353 = parity_3271 & parity_3350;
  logic and_3356;
  assign and_3356 = (^{or_3235_s19_q, or_3231_s19_q, or_3227_s19_q}) & (parity_3253 | parity_3268);
  logic or_3357;
  assign or_3357 = (parity_3253 & parity_3268) | and_3356;
  logic or_3361;
  assign or_3361 = (parity_3335 & parity_3347) | (parity_3320 & (parity_3335 | parity_3347));
  logic and_3367;
  assign and_3367 = (^{or_3283_s19_q, or_3279_s19_q, or_3275_s19_q}) & (parity_3302 | parity_3317);
  logic or_3368;
  assign or_3368 = (parity_3302 & parity_3317) | and_3367;
  logic or_3372;
  assign or_3372 = (or_3328_s19_q & or_3332_s19_q) | (or_3324_s19_q & (or_3328_s19_q | or_3332_s19_q));
  logic or_3376;
  assign or_3376 = (or_3340_s19_q & or_3344_s19_q) | (and_3336_s19_q & (or_3340_s19_q | or_3344_s19_q));
  // hls/stages/count_bits.hpp:23
  logic or_3383;
  assign or_3383 = (or_3279_s19_q & or_3283_s19_q) | (or_3275_s19_q & (or_3279_s19_q | or_3283_s19_q));
  // hls/stages/count_bits.hpp:25
  logic or_3387;
  assign or_3387 = (or_3295_s19_q & or_3299_s19_q) | (or_3291_s19_q & (or_3295_s19_q | or_3299_s19_q));
  logic or_3391;
  assign or_3391 = (or_3310_s19_q & or_3314_s19_q) | (or_3306_s19_q & (or_3310_s19_q | or_3314_s19_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3394;
  assign parity_3394 = ^{or_3391, or_3387, or_3383};
  // hls/stages/count_bits.hpp:23
  logic or_3398;
  assign or_3398 = (or_3231_s19_q & or_3235_s19_q) | (or_3227_s19_q & (or_3231_s19_q | or_3235_s19_q));
  // hls/stages/count_bits.hpp:25
  logic or_3402;
  assign or_3402 = (or_3246_s19_q & or_3250_s19_q) | (or_3242_s19_q & (or_3246_s19_q | or_3250_s19_q));
  logic or_3406;
  assign or_3406 = (or_3261_s19_q & or_3265_s19_q) | (or_3257_s19_q & (or_3261_s19_q | or_3265_s19_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3409;
  assign parity_3409 = ^{or_3406, or_3402, or_3398};
  logic parity_3412;
  assign parity_3412 = ^{or_3406, or_3402, or_3398, or_3391, or_3387, or_3383, or_3376, or_3372, or_3368};
  // hls/stages/patches.hpp:601
  logic and_3568;
  assign and_3568 = not_3564_s19_q & (~({difference_3565_s19_q, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:608
  logic and_3572;
  assign and_3572 = (10'h38 < patches_peak_size_q) & (~({1'b0, patches_peak_size_q[9:1]} < select_3545_s19_q));
  logic and_3574;
  assign and_3574 = (patches_second_s19_q ? patches_valid_1_q : patches_valid_0_q) & (and_3568 & and_3572);
  // hls/stages/patches.hpp:605
  logic [14:0] difference_3612;
  assign difference_3612 = {{7{select_3606_s19_q[7]}}, select_3606_s19_q} - {product_3611_s19_q[13], product_3611_s19_q};
  // hls/stages/agreement.hpp:788
  logic select_3885;
  assign select_3885 = equal_575_s19_q ? ((x_s19_q[6] & good_known_q) | equal_3883_s19_q) : good_known_q;
  // hls/stages/agreement.hpp:1308
  logic and_4060;
  assign and_4060 = and_2134_s19_q & ({sum_2060_s19_q, index_2_s19_q} == {sum_2047_s19_q, index_s19_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1409; read in stage 19, written in stage 20: 19 < 20 < 19 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2047_s19_q, index_s19_q};
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s19_en & (and_2054_s19_q & less_2055_s19_q);
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1614_s19_q, lower_half_s19_q, registration_of_right_s19_q};
  logic registration_sums_we;
  assign registration_sums_we = s19_en & and_1673_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1672_s19_q, sum_1668_s19_q};
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
      moments_left_begins_q <= equal_575_s19_q ? not_2304_s19_q : moments_left_begins_q;
      moments_right_begins_q <= equal_575_s19_q ? not_2314_s19_q : moments_right_begins_q;
      moments_ends_q <= equal_575_s19_q & (equal_2292_s19_q & (not_2347 | and_2349));
      sharpness_sums_detail_0_q <= and_550_s19_q ? select_2373 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_550_s19_q ? select_2385 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2427 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2429 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_2456 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_2462 : sharpness_comparing_less_contrast_1_q;
      registration_moved_q <= not_2905_s19_q & (registration_moved_q | and_2927_s19_q);
      patches_valid_0_q <= select_3022;
      patches_valid_1_q <= select_3027;
      patches_right_next_0_q <= select_3030;
      patches_right_next_1_q <= select_3033;
      patches_left_next_0_q <= select_3036;
      patches_left_next_1_q <= select_3039;
      good_known_q <= select_3885;
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
      census_changes_values_2_left_q <= select_2274;
      census_changes_values_2_right_q <= select_2275;
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
  logic and_550_s20_q;
  logic equal_575_s20_q;
  logic not_576_s20_q;
  logic so_s20_q;
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
  logic less_675_s20_q;
  logic less_676_s20_q;
  logic and_684_s20_q;
  logic and_709_s20_q;
  logic and_710_s20_q;
  logic [8:0] sum_732_s20_q;
  logic and_740_s20_q;
  logic less_741_s20_q;
  logic and_746_s20_q;
  logic less_747_s20_q;
  logic equal_1608_s20_q;
  logic equal_1616_s20_q;
  logic equal_1618_s20_q;
  logic equal_1620_s20_q;
  logic equal_1622_s20_q;
  logic equal_1624_s20_q;
  logic equal_1626_s20_q;
  logic equal_1785_s20_q;
  logic equal_1787_s20_q;
  logic not_1792_s20_q;
  logic [4:0] select_1812_s20_q;
  logic [4:0] select_1815_s20_q;
  logic and_1825_s20_q;
  logic [4:0] select_1840_s20_q;
  logic and_1844_s20_q;
  logic [3:0] column_4_s20_q;
  logic [3:0] select_1859_s20_q;
  logic select_1860_s20_q;
  logic and_1867_s20_q;
  logic not_1988_s20_q;
  logic and_2054_s20_q;
  logic less_2055_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_2060_s20_q;
  logic is_seen_s20_q;
  logic and_2124_s20_q;
  logic and_2134_s20_q;
  logic equal_2277_s20_q;
  logic [8:0] sum_2280_s20_q;
  logic equal_2292_s20_q;
  logic not_2323_s20_q;
  logic and_2344_s20_q;
  logic equal_2395_s20_q;
  logic less_2396_s20_q;
  logic [17:0] select_2408_s20_q;
  logic [17:0] select_2418_s20_q;
  logic equal_2439_s20_q;
  logic and_2591_s20_q;
  logic and_2638_s20_q;
  logic [9:0] select_2642_s20_q;
  logic [9:0] select_2645_s20_q;
  logic [9:0] select_2652_s20_q;
  logic and_2673_s20_q;
  logic and_2693_s20_q;
  logic equal_2892_s20_q;
  logic parity_3223_s20_q;
  logic parity_3352_s20_q;
  logic and_3353_s20_q;
  logic or_3357_s20_q;
  logic or_3361_s20_q;
  logic or_3368_s20_q;
  logic or_3372_s20_q;
  logic or_3376_s20_q;
  logic or_3383_s20_q;
  logic or_3387_s20_q;
  logic or_3391_s20_q;
  logic or_3398_s20_q;
  logic or_3402_s20_q;
  logic or_3406_s20_q;
  logic parity_3412_s20_q;
  logic or_3422_s20_q;
  logic or_3426_s20_q;
  logic and_3433_s20_q;
  logic and_3435_s20_q;
  logic and_3437_s20_q;
  logic equal_3459_s20_q;
  logic and_3559_s20_q;
  logic and_3575_s20_q;
  logic [14:0] difference_3612_s20_q;
  logic equal_3652_s20_q;
  logic less_3772_s20_q;
  logic or_3864_s20_q;
  logic select_3872_s20_q;
  logic equal_3883_s20_q;
  logic equal_3886_s20_q;
  logic equal_3888_s20_q;
  logic equal_3889_s20_q;
  logic equal_3890_s20_q;
  logic equal_3891_s20_q;
  logic and_4045_s20_q;
  logic and_4060_s20_q;
  logic [31:0] select_4130_s20_q;
  logic [9:0] select_4137_s20_q;
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
      and_550_s20_q <= and_550_s19_q;
      equal_575_s20_q <= equal_575_s19_q;
      not_576_s20_q <= not_576_s19_q;
      so_s20_q <= drew_q;
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
      less_675_s20_q <= less_675_s19_q;
      less_676_s20_q <= less_676_s19_q;
      and_684_s20_q <= and_684_s19_q;
      and_709_s20_q <= and_709_s19_q;
      and_710_s20_q <= and_710_s19_q;
      sum_732_s20_q <= sum_732[13:5];
      and_740_s20_q <= and_740_s19_q;
      less_741_s20_q <= less_741_s19_q;
      and_746_s20_q <= (and_709_s19_q & and_736_s19_q) & less_745_s19_q;
      less_747_s20_q <= less_747_s19_q;
      equal_1608_s20_q <= equal_1608_s19_q;
      equal_1616_s20_q <= equal_1616_s19_q;
      equal_1618_s20_q <= equal_1618_s19_q;
      equal_1620_s20_q <= equal_1620_s19_q;
      equal_1622_s20_q <= equal_1622_s19_q;
      equal_1624_s20_q <= equal_1624_s19_q;
      equal_1626_s20_q <= equal_1626_s19_q;
      equal_1785_s20_q <= equal_1785_s19_q;
      equal_1787_s20_q <= equal_1787_s19_q;
      not_1792_s20_q <= not_1792_s19_q;
      select_1812_s20_q <= or_1811_s19_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1815_s20_q <= select_1815_s19_q;
      and_1825_s20_q <= sample_pair_whole_s19_q & and_1824;
      select_1840_s20_q <= or_1839_s19_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1844_s20_q <= sample_pair_whole_s19_q & and_1843;
      column_4_s20_q <= column_4;
      select_1859_s20_q <= select_1859_s19_q;
      select_1860_s20_q <= or_1852_s19_q ? row_starts_s19_q : patches_left_next_0_q[4];
      and_1867_s20_q <= and_1867;
      not_1988_s20_q <= not_1988_s19_q;
      and_2054_s20_q <= and_2054_s19_q;
      less_2055_s20_q <= less_2055_s19_q;
      index_2_s20_q <= index_2_s19_q;
      sum_2060_s20_q <= sum_2060_s19_q;
      is_seen_s20_q <= is_seen;
      and_2124_s20_q <= is_seen & less_2123_s19_q;
      and_2134_s20_q <= and_2134_s19_q;
      equal_2277_s20_q <= equal_2277_s19_q;
      sum_2280_s20_q <= sum_2280[13:5];
      equal_2292_s20_q <= equal_2292_s19_q;
      not_2323_s20_q <= ~moments_ends_q;
      and_2344_s20_q <= cfg_prove_i & and_2343;
      equal_2395_s20_q <= equal_2395_s19_q;
      less_2396_s20_q <= less_2396_s19_q;
      select_2408_s20_q <= select_2408;
      select_2418_s20_q <= select_2418;
      equal_2439_s20_q <= equal_2439_s19_q;
      and_2591_s20_q <= and_2591_s19_q;
      and_2638_s20_q <= not_576_s19_q & (drew_q & and_2636);
      select_2642_s20_q <= select_2642_s19_q;
      select_2645_s20_q <= select_2645_s19_q;
      select_2652_s20_q <= select_2652;
      and_2673_s20_q <= drew_q & (ends_cell_s19_q & (not_2616_s19_q & and_2670));
      and_2693_s20_q <= and_2693_s19_q;
      equal_2892_s20_q <= equal_2892_s19_q;
      parity_3223_s20_q <= parity_3223_s19_q;
      parity_3352_s20_q <= parity_3352;
      and_3353_s20_q <= and_3353;
      or_3357_s20_q <= or_3357;
      or_3361_s20_q <= or_3361;
      or_3368_s20_q <= or_3368;
      or_3372_s20_q <= or_3372;
      or_3376_s20_q <= or_3376;
      or_3383_s20_q <= or_3383;
      or_3387_s20_q <= or_3387;
      or_3391_s20_q <= or_3391;
      or_3398_s20_q <= or_3398;
      or_3402_s20_q <= or_3402;
      or_3406_s20_q <= or_3406;
      parity_3412_s20_q <= parity_3412;
      or_3422_s20_q <= (or_3387 & or_3391) | (or_3383 & (or_3387 | or_3391));
      or_3426_s20_q <= (or_3402 & or_3406) | (or_3398 & (or_3402 | or_3406));
      and_3433_s20_q <= and_3353 & (or_3357 | or_3361);
      and_3435_s20_q <= parity_3394 & parity_3409;
      and_3437_s20_q <= (^{or_3376, or_3372, or_3368}) & (parity_3394 | parity_3409);
      equal_3459_s20_q <= equal_3459_s19_q;
      and_3559_s20_q <= and_3559_s19_q;
      and_3575_s20_q <= not_3561_s19_q & and_3574;
      difference_3612_s20_q <= difference_3612;
      equal_3652_s20_q <= equal_3652_s19_q;
      less_3772_s20_q <= less_3772_s19_q;
      or_3864_s20_q <= or_3864_s19_q;
      select_3872_s20_q <= select_3872_s19_q;
      equal_3883_s20_q <= equal_3883_s19_q;
      equal_3886_s20_q <= equal_3886_s19_q;
      equal_3888_s20_q <= equal_3888_s19_q;
      equal_3889_s20_q <= equal_3889_s19_q;
      equal_3890_s20_q <= equal_3890_s19_q;
      equal_3891_s20_q <= equal_3891_s19_q;
      and_4045_s20_q <= said_q;
      and_4060_s20_q <= and_4060;
      select_4130_s20_q <= select_4130_s19_q;
      select_4137_s20_q <= select_4137_s19_q;
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
  logic proven_q;
  // hls/stages/moments.hpp:51
  logic or_2325;
  assign or_2325 = moments_begins_alone_q | (moments_out_of_step_q & not_2323_s20_q);
  // hls/stages/census.hpp:395
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2408_s20_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2411;
  assign select_2411 = equal_2395_s20_q ? (less_2396_s20_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:395
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2418_s20_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2421;
  assign select_2421 = equal_2395_s20_q ? (less_2396_s20_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2640;
  assign select_2640 = and_2591_s20_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2638_s20_q});
  logic [13:0] select_2654;
  assign select_2654 = and_2591_s20_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2652_s20_q});
  // hls/stages/agreement.hpp:788
  logic and_2674;
  assign and_2674 = not_576_s20_q & and_2673_s20_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2676;
  assign select_2676 = and_2591_s20_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2674});
  logic [13:0] select_2695;
  assign select_2695 = and_2591_s20_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2693_s20_q});
  // hls/stages/count_bits.hpp:24
  logic parity_3414;
  assign parity_3414 = ^{or_3406_s20_q, or_3402_s20_q, or_3398_s20_q, or_3391_s20_q, or_3387_s20_q, or_3383_s20_q, or_3376_s20_q, or_3372_s20_q, or_3368_s20_q, or_3361_s20_q, or_3357_s20_q, and_3353_s20_q};
  // hls/stages/count_bits.hpp:25
  logic or_3418;
  assign or_3418 = (or_3372_s20_q & or_3376_s20_q) | (or_3368_s20_q & (or_3372_s20_q | or_3376_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3429;
  assign parity_3429 = ^{or_3426_s20_q, or_3422_s20_q, or_3418};
  // hls/stages/count_bits.hpp:25
  logic and_3430;
  assign and_3430 = (^{or_3361_s20_q, or_3357_s20_q, and_3353_s20_q}) & parity_3412_s20_q;
  logic or_3434;
  assign or_3434 = (or_3357_s20_q & or_3361_s20_q) | and_3433_s20_q;
  logic or_3438;
  assign or_3438 = and_3435_s20_q | and_3437_s20_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3441;
  assign parity_3441 = ^{or_3438, or_3434, and_3430};
  // hls/stages/count_bits.hpp:25
  logic and_3443;
  assign and_3443 = parity_3429 & parity_3441;
  logic or_3447;
  assign or_3447 = (or_3422_s20_q & or_3426_s20_q) | (or_3418 & (or_3422_s20_q | or_3426_s20_q));
  logic or_3451;
  assign or_3451 = (or_3434 & or_3438) | (and_3430 & (or_3434 | or_3438));
  // hls/stages/patches.hpp:190
  logic and_3576;
  assign and_3576 = and_3559_s20_q & and_3575_s20_q;
  // hls/stages/patches.hpp:667
  logic not_3577;
  assign not_3577 = ~patches_lower_s20_q;
  // hls/stages/patches.hpp:611
  logic less_3613;
  assign less_3613 = $signed({{8{difference_3583[6]}}, difference_3583}) < $signed(difference_3612_s20_q);
  // hls/stages/patches.hpp:610
  logic less_3618;
  assign less_3618 = $signed(difference_3612_s20_q) < $signed({9'h0, cfg_patch_limit_i});
  // hls/stages/agreement.hpp:1130
  logic less_3653;
  assign less_3653 = x_s20_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3657;
  assign and_3657 = equal_575_s20_q & (x_s20_q[6] & (not_1988_s20_q & (equal_3652_s20_q & less_3653)));
  // hls/stages/agreement.hpp:1142
  logic and_3662;
  assign and_3662 = x_s20_q[6] & (not_1988_s20_q & (less_3653 & (x_s20_q[2:0] == 3'h1)));
  logic and_3669;
  assign and_3669 = x_s20_q[6] & (not_1988_s20_q & (less_3653 & (x_s20_q[2:0] == 3'h2)));
  logic and_3676;
  assign and_3676 = x_s20_q[6] & (not_1988_s20_q & (less_3653 & (x_s20_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:203
  logic select_3683;
  assign select_3683 = (x_s20_q[5:3] == 3'h2) ? x_s20_q[1] : (x_s20_q[0] & (x_s20_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3710;
  assign sum_3710 = {2'h0, x_s20_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3727;
  assign select_3727 = ($signed(difference_3612_s20_q[14:4]) < $signed(11'h7ff)) ? 6'h30 : difference_3612_s20_q[5:0];
  logic [5:0] select_3728;
  assign select_3728 = ($signed(15'h10) < $signed(difference_3612_s20_q)) ? 6'h10 : select_3727;
  // hls/stages/agreement.hpp:788
  logic and_3735;
  assign and_3735 = equal_575_s20_q & (x_s20_q[6] & (not_1988_s20_q & (equal_2892_s20_q & less_3653)));
  // hls/stages/agreement.hpp:1142
  logic and_3739;
  assign and_3739 = x_s20_q[6] & (not_1988_s20_q & (less_3653 & (x_s20_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3893;
  assign select_3893 = equal_3890_s20_q ? counts_skin_unproven_q : (equal_3891_s20_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3895;
  assign select_3895 = equal_3889_s20_q ? counts_regions_bad_q : (equal_3886_s20_q ? counts_nearer_s20_q : select_3893);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3888_s20_q ? counts_on_skin_q : select_3895;
  // hls/stages/agreement.hpp:788
  logic and_4121;
  assign and_4121 = equal_575_s20_q & (x_s20_q[6] & (not_1988_s20_q | (4'hc < x_s20_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4131;
  assign select_4131 = equal_1626_s20_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4130_s20_q;
  logic [31:0] select_4132;
  assign select_4132 = equal_1624_s20_q ? {8'h0, sharpness_sums_detail_0_s20_q} : select_4131;
  logic [31:0] select_4133;
  assign select_4133 = equal_1622_s20_q ? {8'h0, sharpness_sums_detail_1_s20_q} : select_4132;
  logic [31:0] select_4134;
  assign select_4134 = equal_1620_s20_q ? {8'h0, sharpness_sums_contrast_0_s20_q} : select_4133;
  logic [31:0] select_4135;
  assign select_4135 = equal_1618_s20_q ? {8'h0, sharpness_sums_contrast_1_s20_q} : select_4134;

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1815_s20_q, select_1812_s20_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s20_en & and_1825_s20_q;
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
  assign patches_right_1_waddr = {select_1815_s20_q, select_1840_s20_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s20_en & and_1844_s20_q;
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
  assign patches_left_waddr = {select_1860_s20_q, select_1859_s20_q, column_4_s20_q};
  logic patches_left_we;
  assign patches_left_we = s20_en & and_1867_s20_q;
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
  assign map_waddr = {sum_2060_s20_q, index_2_s20_q};
  logic map_we;
  assign map_we = s20_en & and_2134_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2124_s20_q, is_seen_s20_q};
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
      proven_q <= 1'b0;
    end else if (s20_en) begin
      moments_out_of_step_q <= or_2325;
      moments_begins_alone_q <= equal_575_s20_q & (equal_2292_s20_q & and_2344_s20_q);
      sharpness_comparing_rest_0_q <= so_s20_q ? select_2411 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s20_q ? select_2421 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2640;
      counts_regions_bad_q <= select_2654;
      counts_skin_unproven_q <= select_2676;
      counts_on_skin_q <= select_2695;
      patches_frame_ended_q <= equal_575_s20_q & equal_2292_s20_q;
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
  logic [4:0] patches_summed_row_column_s21_q;
  logic patches_summed_first_s21_q;
  logic patches_summed_last_s21_q;
  logic [4:0] patches_summed_down_by_s21_q;
  logic patches_frame_ended_s21_q;
  logic [13:0] product_s21_q;
  logic [6:0] last_s21_q;
  logic and_550_s21_q;
  logic equal_575_s21_q;
  logic so_s21_q;
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
  logic less_675_s21_q;
  logic less_676_s21_q;
  logic and_684_s21_q;
  logic and_709_s21_q;
  logic and_710_s21_q;
  logic less_733_s21_q;
  logic and_740_s21_q;
  logic less_741_s21_q;
  logic and_746_s21_q;
  logic less_747_s21_q;
  logic equal_1608_s21_q;
  logic equal_1616_s21_q;
  logic equal_1785_s21_q;
  logic equal_1787_s21_q;
  logic and_2054_s21_q;
  logic less_2055_s21_q;
  logic [1:0] map_rdata_s21_q;
  logic is_seen_s21_q;
  logic and_2124_s21_q;
  logic equal_2277_s21_q;
  logic and_2282_s21_q;
  logic equal_2395_s21_q;
  logic sum_s21_q;
  logic sum_2_s21_q;
  logic equal_2439_s21_q;
  logic select_2457_s21_q;
  logic select_2463_s21_q;
  logic [9:0] select_2642_s21_q;
  logic [9:0] select_2645_s21_q;
  logic parity_3223_s21_q;
  logic parity_3352_s21_q;
  logic parity_3414_s21_q;
  logic xor_3442_s21_q;
  logic parity_3454_s21_q;
  logic and_3455_s21_q;
  logic and_3457_s21_q;
  logic equal_3459_s21_q;
  logic and_3579_s21_q;
  logic not_3614_s21_q;
  logic not_3619_s21_q;
  logic and_3623_s21_q;
  logic and_3633_s21_q;
  logic and_3643_s21_q;
  logic equal_3652_s21_q;
  logic and_3657_s21_q;
  logic and_3663_s21_q;
  logic and_3670_s21_q;
  logic and_3677_s21_q;
  logic and_3686_s21_q;
  logic and_3713_s21_q;
  logic [5:0] select_3729_s21_q;
  logic and_3735_s21_q;
  logic and_3740_s21_q;
  logic and_3773_s21_q;
  logic or_3864_s21_q;
  logic select_3872_s21_q;
  logic equal_3883_s21_q;
  logic and_3887_s21_q;
  logic [13:0] before_v_4_s21_q;
  logic not_3932_s21_q;
  logic or_3936_s21_q;
  logic and_3941_s21_q;
  logic less_3942_s21_q;
  logic and_4045_s21_q;
  logic and_4060_s21_q;
  logic not_4074_s21_q;
  logic and_4121_s21_q;
  logic [5:0] select_4123_s21_q;
  logic [31:0] select_4135_s21_q;
  logic [9:0] select_4137_s21_q;
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
      and_550_s21_q <= and_550_s20_q;
      equal_575_s21_q <= equal_575_s20_q;
      so_s21_q <= so_s20_q;
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
      less_675_s21_q <= less_675_s20_q;
      less_676_s21_q <= less_676_s20_q;
      and_684_s21_q <= and_684_s20_q;
      and_709_s21_q <= and_709_s20_q;
      and_710_s21_q <= and_710_s20_q;
      less_733_s21_q <= 9'h4 < sum_732_s20_q;
      and_740_s21_q <= and_740_s20_q;
      less_741_s21_q <= less_741_s20_q;
      and_746_s21_q <= and_746_s20_q;
      less_747_s21_q <= less_747_s20_q;
      equal_1608_s21_q <= equal_1608_s20_q;
      equal_1616_s21_q <= equal_1616_s20_q;
      equal_1785_s21_q <= equal_1785_s20_q;
      equal_1787_s21_q <= equal_1787_s20_q;
      and_2054_s21_q <= and_2054_s20_q;
      less_2055_s21_q <= less_2055_s20_q;
      map_rdata_s21_q <= map_rdata_q;
      is_seen_s21_q <= is_seen_s20_q;
      and_2124_s21_q <= and_2124_s20_q;
      equal_2277_s21_q <= equal_2277_s20_q;
      and_2282_s21_q <= and_709_s20_q & (9'h4 < sum_2280_s20_q);
      equal_2395_s21_q <= equal_2395_s20_q;
      sum_s21_q <= sum[0];
      sum_2_s21_q <= sum_2[0];
      equal_2439_s21_q <= equal_2439_s20_q;
      select_2457_s21_q <= sharpness_comparing_less_contrast_0_q;
      select_2463_s21_q <= sharpness_comparing_less_contrast_1_q;
      select_2642_s21_q <= select_2642_s20_q;
      select_2645_s21_q <= select_2645_s20_q;
      parity_3223_s21_q <= parity_3223_s20_q;
      parity_3352_s21_q <= parity_3352_s20_q;
      parity_3414_s21_q <= parity_3414;
      xor_3442_s21_q <= parity_3429 ^ parity_3441;
      parity_3454_s21_q <= ^{or_3451, or_3447, and_3443};
      and_3455_s21_q <= or_3447 & or_3451;
      and_3457_s21_q <= and_3443 & (or_3447 | or_3451);
      equal_3459_s21_q <= equal_3459_s20_q;
      and_3579_s21_q <= and_3576 & (not_1792_s20_q & not_3577);
      not_3614_s21_q <= ~less_3613;
      not_3619_s21_q <= ~less_3618;
      and_3623_s21_q <= and_3576 & (patches_second_s20_q & not_3577);
      and_3633_s21_q <= and_3576 & (patches_lower_s20_q & not_1792_s20_q);
      and_3643_s21_q <= and_3576 & (patches_lower_s20_q & patches_second_s20_q);
      equal_3652_s21_q <= equal_3652_s20_q;
      and_3657_s21_q <= and_3657;
      and_3663_s21_q <= equal_575_s20_q & and_3662;
      and_3670_s21_q <= equal_575_s20_q & and_3669;
      and_3677_s21_q <= equal_575_s20_q & and_3676;
      and_3686_s21_q <= x_s20_q[6] & (not_1988_s20_q & (less_3653 & select_3683));
      and_3713_s21_q <= not_1988_s20_q & (less_3653 & (sum_3710[4:2] == 3'h0));
      select_3729_s21_q <= and_3576 ? select_3728 : 6'h0;
      and_3735_s21_q <= and_3735;
      and_3740_s21_q <= equal_575_s20_q & and_3739;
      and_3773_s21_q <= less_3772_s20_q & and_3576;
      or_3864_s21_q <= or_3864_s20_q;
      select_3872_s21_q <= select_3872_s20_q;
      equal_3883_s21_q <= equal_3883_s20_q;
      and_3887_s21_q <= equal_3886_s20_q & equal_3652_s20_q;
      before_v_4_s21_q <= before_v_4;
      not_3932_s21_q <= ~(equal_3891_s20_q & equal_3652_s20_q);
      or_3936_s21_q <= (equal_3891_s20_q | equal_3890_s20_q) | (x_s20_q[6:3] == 4'hf);
      and_3941_s21_q <= equal_3888_s20_q & equal_3652_s20_q;
      less_3942_s21_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4045_s21_q <= and_4045_s20_q;
      and_4060_s21_q <= and_4060_s20_q;
      not_4074_s21_q <= ~proven_q;
      and_4121_s21_q <= and_4121;
      select_4123_s21_q <= equal_575_s20_q ? (x_s20_q[6] ? x_s20_q[5:0] : 6'h0) : 6'h0;
      select_4135_s21_q <= select_4135;
      select_4137_s21_q <= select_4137_s20_q;
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
  logic and_734;
  assign and_734 = and_684_s21_q & less_733_s21_q;
  // hls/stages/census.hpp:324
  logic and_2283;
  assign and_2283 = and_709_s21_q & less_733_s21_q;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2284;
  assign sum_2284 = census_left_misses_q + {{17{and_2283}}, and_2282_s21_q, 1'b0, and_2282_s21_q};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2286;
  assign select_2286 = and_550_s21_q ? (equal_2277_s21_q ? 20'h0 : sum_2284) : census_left_misses_q;
  // hls/stages/agreement.hpp:216
  logic [2:0] select_2423;
  assign select_2423 = equal_2395_s21_q ? {sharpness_comparing_product_0_q[1:0], sum_s21_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2425;
  assign select_2425 = equal_2395_s21_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s21_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s21_q});
  // hls/stages/agreement.hpp:216
  logic select_2434;
  assign select_2434 = so_s21_q ? (equal_2395_s21_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s21_q});
  // hls/stages/agreement.hpp:216
  logic select_2437;
  assign select_2437 = equal_2395_s21_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:403
  logic xor_2440;
  assign xor_2440 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2446;
  assign xor_2446 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/count_bits.hpp:27
  logic or_3458;
  assign or_3458 = and_3455_s21_q | and_3457_s21_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3458, parity_3454_s21_q, xor_3442_s21_q, parity_3414_s21_q, parity_3352_s21_q, parity_3223_s21_q} + (equal_3459_s21_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:275
  logic [9:0] select_3463;
  assign select_3463 = equal_1785_s21_q ? patches_sums_values_0_q : (equal_1787_s21_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3464;
  assign select_3464 = equal_1787_s21_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3466;
  assign select_3466 = equal_1787_s21_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3468;
  assign select_3468 = equal_1787_s21_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3470;
  assign select_3470 = equal_1787_s21_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3472;
  assign select_3472 = equal_1787_s21_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3474;
  assign select_3474 = equal_1787_s21_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3476;
  assign select_3476 = equal_1787_s21_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3478;
  assign select_3478 = equal_1787_s21_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3480;
  assign select_3480 = equal_1787_s21_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3482;
  assign select_3482 = equal_1787_s21_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3484;
  assign select_3484 = equal_1787_s21_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3486;
  assign select_3486 = equal_1787_s21_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3488;
  assign select_3488 = equal_1787_s21_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3490;
  assign select_3490 = equal_1787_s21_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3492;
  assign select_3492 = equal_1787_s21_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3494;
  assign select_3494 = equal_1787_s21_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3581;
  assign sum_3581 = {7'h0, and_3579_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:670
  logic and_3615;
  assign and_3615 = not_3614_s21_q & and_3579_s21_q;
  logic [7:0] sum_3616;
  assign sum_3616 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3615};
  // hls/stages/patches.hpp:671
  logic and_3620;
  assign and_3620 = not_3619_s21_q & and_3579_s21_q;
  logic [7:0] sum_3621;
  assign sum_3621 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3620};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3625;
  assign sum_3625 = {7'h0, and_3623_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_3627;
  assign and_3627 = not_3614_s21_q & and_3623_s21_q;
  logic [7:0] sum_3628;
  assign sum_3628 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3627};
  // hls/stages/patches.hpp:671
  logic and_3630;
  assign and_3630 = not_3619_s21_q & and_3623_s21_q;
  logic [7:0] sum_3631;
  assign sum_3631 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3630};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3635;
  assign sum_3635 = {7'h0, and_3633_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_3637;
  assign and_3637 = not_3614_s21_q & and_3633_s21_q;
  logic [7:0] sum_3638;
  assign sum_3638 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3637};
  // hls/stages/patches.hpp:671
  logic and_3640;
  assign and_3640 = not_3619_s21_q & and_3633_s21_q;
  logic [7:0] sum_3641;
  assign sum_3641 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3640};
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3645;
  assign sum_3645 = {7'h0, and_3643_s21_q} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_3647;
  assign and_3647 = not_3614_s21_q & and_3643_s21_q;
  logic [7:0] sum_3648;
  assign sum_3648 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3647};
  // hls/stages/patches.hpp:671
  logic and_3650;
  assign and_3650 = not_3619_s21_q & and_3643_s21_q;
  logic [7:0] sum_3651;
  assign sum_3651 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3650};
  // hls/stages/patches.hpp:633
  logic [7:0] or_3665;
  assign or_3665 = (and_3657_s21_q ? patches_quarters_0_places_q : 8'h0) | (and_3663_s21_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3679;
  assign or_3679 = (or_3665 | (and_3670_s21_q ? patches_quarters_2_places_q : 8'h0)) | (and_3677_s21_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_3687;
  assign and_3687 = equal_575_s21_q & and_3686_s21_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_3689;
  assign select_3689 = and_3657_s21_q ? (and_3687 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3691;
  assign select_3691 = and_3663_s21_q ? (and_3687 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3694;
  assign select_3694 = and_3670_s21_q ? (and_3687 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3697;
  assign select_3697 = and_3677_s21_q ? (and_3687 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_3700;
  assign select_3700 = and_3657_s21_q ? (and_3687 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3702;
  assign select_3702 = and_3663_s21_q ? (and_3687 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3705;
  assign select_3705 = and_3670_s21_q ? (and_3687 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3708;
  assign select_3708 = and_3677_s21_q ? (and_3687 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_3715;
  assign and_3715 = equal_575_s21_q & (x_s21_q & and_3713_s21_q);
  // hls/stages/patches.hpp:628
  logic [7:0] sum_3717;
  assign sum_3717 = patches_word_places_q + (and_3663_s21_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:630
  logic [7:0] select_3721;
  assign select_3721 = and_3715 ? (patches_word_up_q + (and_3663_s21_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3723;
  assign sum_3723 = patches_word_down_q + (and_3663_s21_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:673
  logic [11:0] sum_3730;
  assign sum_3730 = patches_across_q + {{6{select_3729_s21_q[5]}}, select_3729_s21_q};
  // hls/stages/patches.hpp:674
  logic [11:0] select_3731;
  assign select_3731 = patches_round_ends_q ? {{6{select_3729_s21_q[5]}}, select_3729_s21_q} : sum_3730;
  // hls/stages/patches.hpp:657
  logic [7:0] select_3742;
  assign select_3742 = and_3735_s21_q ? (and_3740_s21_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_3746;
  assign or_3746 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_3749;
  assign or_3749 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_3750;
  assign sum_3750 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_3752;
  assign select_3752 = and_3735_s21_q ? (and_3740_s21_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3755;
  assign and_3755 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_3756;
  assign select_3756 = and_3735_s21_q ? {and_3755, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3758;
  assign select_3758 = and_3735_s21_q ? (and_3740_s21_q ? {and_3755, patches_found_q[2:1]} : select_3756) : patches_found_q;
  // hls/stages/patches.hpp:655
  logic or_3761;
  assign or_3761 = patches_partly_q | (patches_doubted_q & (~and_3740_s21_q));
  // hls/stages/patches.hpp:656
  logic select_3763;
  assign select_3763 = and_3740_s21_q ? or_3761 : (and_3735_s21_q ? or_3761 : patches_doubted_q);
  // hls/stages/patches.hpp:654
  logic select_3765;
  assign select_3765 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3769;
  assign select_3769 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3774;
  assign sum_3774 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3773_s21_q};
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_3797;
  assign select_3797 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_3803;
  assign and_3803 = patches_frame_ended_s21_q & (~patches_age_q[9]);
  logic [9:0] sum_3804;
  assign sum_3804 = patches_age_q + {9'h0, and_3803};
  logic [9:0] select_3807;
  assign select_3807 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3804)) : sum_3804;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_s21_q} - {1'b0, before_v_4_s21_q};
  // hls/stages/agreement.hpp:1230
  logic select_3898;
  assign select_3898 = and_3887_s21_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4061;
  assign select_4061 = and_4060_s21_q ? {and_2124_s21_q, is_seen_s21_q} : map_rdata_s21_q;
  // hls/stages/agreement.hpp:1309
  logic and_4062;
  assign and_4062 = proven_q & less_4050;
  // hls/stages/agreement.hpp:1239
  logic or_4075;
  assign or_4075 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4074_s21_q;
  // hls/stages/agreement.hpp:788
  logic and_4090;
  assign and_4090 = equal_3883_s21_q & (cfg_prove_i & (registration_moved_s21_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4093;
  assign or_4093 = select_2457_s21_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:788
  logic and_4117;
  assign and_4117 = equal_575_s21_q & (equal_3883_s21_q & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4136;
  assign select_4136 = equal_1616_s21_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4135_s21_q;
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4138;
  assign select_4138 = equal_1608_s21_q ? select_4136 : {2'h0, select_4137_s21_q, select_2645_s21_q, select_2642_s21_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s21_q;
  logic fresh_we;
  assign fresh_we = s21_en & and_550_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_747_s21_q, and_746_s21_q, less_741_s21_q, and_740_s21_q, census_columns_values_1_cell_2_of_skin_s21_q, and_734, and_710_s21_q, and_709_s21_q, and_684_s21_q, less_676_s21_q, less_675_s21_q, less_674_s21_q, less_673_s21_q, less_672_s21_q, less_671_s21_q, less_670_s21_q, less_669_s21_q, less_668_s21_q, less_667_s21_q, less_666_s21_q, less_665_s21_q, less_664_s21_q, less_663_s21_q, less_662_s21_q, less_661_s21_q, less_660_s21_q, less_659_s21_q, less_658_s21_q, less_657_s21_q, less_656_s21_q, less_655_s21_q, less_654_s21_q, less_653_s21_q};
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
      census_left_misses_q <= select_2286;
      sharpness_comparing_product_0_q <= so_s21_q ? select_2423 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s21_q ? select_2425 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2434;
      sharpness_comparing_carry_1_q <= so_s21_q ? select_2437 : sharpness_comparing_carry_1_q;
      patches_sums_values_0_q <= select_3463;
      patches_sums_values_1_q <= equal_1785_s21_q ? patches_sums_values_1_q : select_3464;
      patches_sums_values_2_q <= equal_1785_s21_q ? patches_sums_values_2_q : select_3466;
      patches_sums_values_3_q <= equal_1785_s21_q ? patches_sums_values_3_q : select_3468;
      patches_sums_values_4_q <= equal_1785_s21_q ? patches_sums_values_4_q : select_3470;
      patches_sums_values_5_q <= equal_1785_s21_q ? patches_sums_values_5_q : select_3472;
      patches_sums_values_6_q <= equal_1785_s21_q ? patches_sums_values_6_q : select_3474;
      patches_sums_values_7_q <= equal_1785_s21_q ? patches_sums_values_7_q : select_3476;
      patches_sums_values_8_q <= equal_1785_s21_q ? patches_sums_values_8_q : select_3478;
      patches_sums_values_9_q <= equal_1785_s21_q ? patches_sums_values_9_q : select_3480;
      patches_sums_values_10_q <= equal_1785_s21_q ? patches_sums_values_10_q : select_3482;
      patches_sums_values_11_q <= equal_1785_s21_q ? patches_sums_values_11_q : select_3484;
      patches_sums_values_12_q <= equal_1785_s21_q ? patches_sums_values_12_q : select_3486;
      patches_sums_values_13_q <= equal_1785_s21_q ? patches_sums_values_13_q : select_3488;
      patches_sums_values_14_q <= equal_1785_s21_q ? patches_sums_values_14_q : select_3490;
      patches_sums_values_15_q <= equal_1785_s21_q ? patches_sums_values_15_q : select_3492;
      patches_sums_values_16_q <= equal_1785_s21_q ? patches_sums_values_16_q : select_3494;
      patches_quarters_0_places_q <= sum_3581;
      patches_quarters_0_up_q <= sum_3616;
      patches_quarters_0_down_q <= sum_3621;
      patches_quarters_1_places_q <= sum_3625;
      patches_quarters_1_up_q <= sum_3628;
      patches_quarters_1_down_q <= sum_3631;
      patches_quarters_2_places_q <= sum_3635;
      patches_quarters_2_up_q <= sum_3638;
      patches_quarters_2_down_q <= sum_3641;
      patches_quarters_3_places_q <= sum_3645;
      patches_quarters_3_up_q <= sum_3648;
      patches_quarters_3_down_q <= sum_3651;
      patches_word_places_q <= or_3679;
      patches_word_up_q <= ((select_3689 | select_3691) | select_3694) | select_3697;
      patches_word_down_q <= ((select_3700 | select_3702) | select_3705) | select_3708;
      patches_sum_places_q <= and_3715 ? sum_3717 : patches_sum_places_q;
      patches_sum_up_q <= select_3721;
      patches_sum_down_q <= and_3715 ? sum_3723 : patches_sum_down_q;
      patches_across_q <= select_3731;
      patches_places_q <= select_3742;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3746;
      patches_partly_q <= or_3749;
      patches_clear_limit_q <= sum_3750[8:2];
      patches_complete_q <= select_3752;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3758;
      patches_doubted_q <= and_3735_s21_q ? select_3763 : patches_doubted_q;
      patches_doubted_before_q <= select_3765;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3769;
      patches_on_skin_q <= sum_3774;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3797;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3807;
      hides_q <= equal_575_s21_q ? select_3898 : hides_q;
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
  logic equal_575_s22_q;
  logic so_s22_q;
  logic and_2054_s22_q;
  logic less_2055_s22_q;
  logic equal_2395_s22_q;
  logic or_2441_s22_q;
  logic and_2442_s22_q;
  logic or_2447_s22_q;
  logic and_2448_s22_q;
  logic select_2463_s22_q;
  logic or_3864_s22_q;
  logic select_3872_s22_q;
  logic equal_3883_s22_q;
  logic select_3898_s22_q;
  logic and_3930_s22_q;
  logic not_3932_s22_q;
  logic or_3936_s22_q;
  logic and_3941_s22_q;
  logic and_3943_s22_q;
  logic and_4045_s22_q;
  logic and_4063_s22_q;
  logic and_4066_s22_q;
  logic and_4078_s22_q;
  logic and_4091_s22_q;
  logic or_4093_s22_q;
  logic and_4117_s22_q;
  logic and_4121_s22_q;
  logic [5:0] select_4123_s22_q;
  logic [31:0] select_4140_s22_q;
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
      equal_575_s22_q <= equal_575_s21_q;
      so_s22_q <= so_s21_q;
      and_2054_s22_q <= and_2054_s21_q;
      less_2055_s22_q <= less_2055_s21_q;
      equal_2395_s22_q <= equal_2395_s21_q;
      or_2441_s22_q <= equal_2439_s21_q | xor_2440;
      and_2442_s22_q <= five_times[0] & xor_2440;
      or_2447_s22_q <= equal_2439_s21_q | xor_2446;
      and_2448_s22_q <= five_times_2[0] & xor_2446;
      select_2463_s22_q <= select_2463_s21_q;
      or_3864_s22_q <= or_3864_s21_q;
      select_3872_s22_q <= select_3872_s21_q;
      equal_3883_s22_q <= equal_3883_s21_q;
      select_3898_s22_q <= select_3898;
      and_3930_s22_q <= over[14] & equal_3652_s21_q;
      not_3932_s22_q <= not_3932_s21_q;
      or_3936_s22_q <= or_3936_s21_q;
      and_3941_s22_q <= and_3941_s21_q;
      and_3943_s22_q <= over[14] & less_3942_s21_q;
      and_4045_s22_q <= and_4045_s21_q;
      and_4063_s22_q <= select_4061[0] & and_4062;
      and_4066_s22_q <= select_4061[1] & and_4062;
      and_4078_s22_q <= equal_575_s21_q & (equal_3883_s21_q & (cfg_prove_i & or_4075));
      and_4091_s22_q <= equal_575_s21_q & and_4090;
      or_4093_s22_q <= or_4093;
      and_4117_s22_q <= and_4117;
      and_4121_s22_q <= and_4121_s21_q;
      select_4123_s22_q <= select_4123_s21_q;
      select_4140_s22_q <= equal_575_s21_q ? (x_s21_q ? select_4138 : 32'h0) : 32'h0;
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
  logic less_1970;
  assign less_1970 = patches_sums_values_0_s22_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_1971;
  assign not_1971 = ~less_1970;
  logic [1:0] select_1972;
  assign select_1972 = patches_summed_first_s22_q ? 2'h2 : {less_1970, not_1971};
  logic [12:0] select_1974;
  assign select_1974 = select_1972[0] ? {4'h0, patches_summed_first_s22_q, 3'h0, patches_summed_row_column_s22_q} : {patches_summed_row_column_s22_q, patches_sums_values_0_s22_q[7:0]};
  logic [14:0] select_1975;
  assign select_1975 = select_1972[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1976;
  assign select_1976 = (select_1972 == 2'h2) ? {select_1974[12:8], patches_sums_values_0_s22_q[9:8], select_1974[7:0]} : select_1975;
  // hls/stages/census.hpp:403
  logic select_2443;
  assign select_2443 = or_2441_s22_q ? and_2442_s22_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2444;
  assign select_2444 = equal_2395_s22_q ? select_2443 : sharpness_comparing_less_detail_0_q;
  logic select_2445;
  assign select_2445 = so_s22_q ? select_2444 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic select_2449;
  assign select_2449 = or_2447_s22_q ? and_2448_s22_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2450;
  assign select_2450 = equal_2395_s22_q ? select_2449 : sharpness_comparing_less_detail_1_q;
  logic select_2451;
  assign select_2451 = so_s22_q ? select_2450 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:663
  logic [12:0] product_3779;
  assign product_3779 = {8'h0, patches_on_skin_limit_q} * {5'h0, patches_places_q};
  // hls/stages/agreement.hpp:1148
  logic not_3899;
  assign not_3899 = ~hidden_for_q[7];
  logic [7:0] select_3901;
  assign select_3901 = select_3898_s22_q ? (hidden_for_q + {7'h0, not_3899}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3903;
  assign select_3903 = equal_575_s22_q ? (equal_3883_s22_q ? select_3901 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1228
  logic and_3933;
  assign and_3933 = too_much_q & not_3932_s22_q;
  // hls/stages/agreement.hpp:1229
  logic select_3938;
  assign select_3938 = and_3930_s22_q ? (and_3933 | or_3936_s22_q) : and_3933;
  // hls/stages/agreement.hpp:1231
  logic select_3944;
  assign select_3944 = and_3941_s22_q ? and_3943_s22_q : overlooks_q;
  // hls/stages/agreement.hpp:438
  logic select_4065;
  assign select_4065 = and_2054_s22_q ? (less_2055_s22_q ? and_4063_s22_q : seen_q) : seen_q;
  logic select_4068;
  assign select_4068 = and_2054_s22_q ? (less_2055_s22_q ? and_4066_s22_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:788
  logic and_4081;
  assign and_4081 = equal_575_s22_q & (equal_3883_s22_q & (cfg_prove_i & or_3864_s22_q));
  // hls/stages/agreement.hpp:1241
  logic not_4083;
  assign not_4083 = ~(or_3864_s22_q | not_2347);
  // hls/stages/agreement.hpp:788
  logic and_4086;
  assign and_4086 = equal_3883_s22_q & (not_4083 & (select_3872_s22_q | select_3938));
  logic and_4100;
  assign and_4100 = equal_3883_s22_q & (not_4083 & (select_2451 | select_2463_s22_q));

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
      sharpness_comparing_less_detail_0_q <= select_2445;
      sharpness_comparing_less_detail_1_q <= select_2451;
      patches_best_differing_q <= select_1976[9:0];
      patches_best_column_q <= select_1976[14:10];
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      hidden_for_q <= select_3903;
      too_much_q <= equal_575_s22_q ? select_3938 : too_much_q;
      overlooks_q <= equal_575_s22_q ? select_3944 : overlooks_q;
      seen_q <= select_4065;
      nearer_q <= select_4068;
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
  logic equal_575_s23_q;
  logic [7:0] product_3779_s23_q;
  logic equal_3883_s23_q;
  logic and_4045_s23_q;
  logic and_4078_s23_q;
  logic and_4081_s23_q;
  logic and_4087_s23_q;
  logic and_4091_s23_q;
  logic and_4096_s23_q;
  logic and_4100_s23_q;
  logic not_4105_s23_q;
  logic or_4111_s23_q;
  logic and_4117_s23_q;
  logic and_4121_s23_q;
  logic [5:0] select_4123_s23_q;
  logic [31:0] select_4140_s23_q;
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
      equal_575_s23_q <= equal_575_s22_q;
      product_3779_s23_q <= product_3779[12:5];
      equal_3883_s23_q <= equal_3883_s22_q;
      and_4045_s23_q <= and_4045_s22_q;
      and_4078_s23_q <= and_4078_s22_q;
      and_4081_s23_q <= and_4081;
      and_4087_s23_q <= equal_575_s22_q & and_4086;
      and_4091_s23_q <= and_4091_s22_q;
      and_4096_s23_q <= equal_3883_s22_q & (not_4083 & (select_2445 | or_4093_s22_q));
      and_4100_s23_q <= and_4100;
      not_4105_s23_q <= ~(select_3901 < cfg_hidden_frames_i);
      or_4111_s23_q <= not_2347 | (select_3944 & not_3776);
      and_4117_s23_q <= and_4117_s22_q;
      and_4121_s23_q <= and_4121_s22_q;
      select_4123_s23_q <= select_4123_s22_q;
      select_4140_s23_q <= select_4140_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:192
  logic and_3781;
  assign and_3781 = (~(patches_on_skin_s23_q[7:2] == 6'h0)) & (product_3779_s23_q < patches_on_skin_s23_q);
  logic select_3786;
  assign select_3786 = patches_round_ends_s23_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_3790;
  assign or_3790 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s23_q));
  // hls/stages/agreement.hpp:1150
  logic and_4107;
  assign and_4107 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4105_s23_q);
  // hls/stages/agreement.hpp:788
  logic and_4113;
  assign and_4113 = equal_3883_s23_q & (or_4111_s23_q ? cfg_prove_i : patches_overlooked_q);

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
      patches_large_q <= not_3776 & and_3781;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3786;
      patches_spoiled_q <= or_3790;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic and_4045_s24_q;
  logic or_4069_s24_q;
  logic and_4070_s24_q;
  logic and_4078_s24_q;
  logic and_4081_s24_q;
  logic and_4087_s24_q;
  logic and_4091_s24_q;
  logic and_4097_s24_q;
  logic and_4101_s24_q;
  logic and_4109_s24_q;
  logic and_4114_s24_q;
  logic and_4117_s24_q;
  logic and_4121_s24_q;
  logic [5:0] select_4123_s24_q;
  logic [31:0] select_4140_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      and_4045_s24_q <= and_4045_s23_q;
      or_4069_s24_q <= not_2347 | seen_q;
      and_4070_s24_q <= cfg_prove_i & nearer_q;
      and_4078_s24_q <= and_4078_s23_q;
      and_4081_s24_q <= and_4081_s23_q;
      and_4087_s24_q <= and_4087_s23_q;
      and_4091_s24_q <= and_4091_s23_q;
      and_4097_s24_q <= equal_575_s23_q & and_4096_s23_q;
      and_4101_s24_q <= equal_575_s23_q & and_4100_s23_q;
      and_4109_s24_q <= equal_575_s23_q & (equal_3883_s23_q & and_4107);
      and_4114_s24_q <= equal_575_s23_q & and_4113;
      and_4117_s24_q <= and_4117_s23_q;
      and_4121_s24_q <= and_4121_s23_q;
      select_4123_s24_q <= select_4123_s23_q;
      select_4140_s24_q <= select_4140_s23_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s24_q;
  assign pixel_1_o = pixel_1_s24_q;
  assign saturated_o = saturated_s24_q;
  assign mask_o = mask_s24_q;
  assign marks_first_o = marks_first_s24_q;
  assign marks_last_o = marks_last_s24_q;
  assign marks_seen_o = or_4069_s24_q;
  assign marks_nearer_o = and_4070_s24_q;
  assign verdict_valid_o = and_4045_s24_q;
  assign verdict_unproven_yet_o = and_4078_s24_q;
  assign verdict_untextured_o = and_4081_s24_q;
  assign verdict_disagree_o = and_4087_s24_q;
  assign verdict_moved_o = and_4091_s24_q;
  assign verdict_unsharp_left_o = and_4097_s24_q;
  assign verdict_unsharp_right_o = and_4101_s24_q;
  assign verdict_hidden_o = and_4109_s24_q;
  assign verdict_overlooked_o = and_4114_s24_q;
  assign verdict_out_of_step_o = and_4117_s24_q;
  assign frame_valid_o = and_4121_s24_q;
  assign frame_index_o = select_4123_s24_q;
  assign frame_word_o = select_4140_s24_q;
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
  assign unused_bits = ^{over[13:0], product_3779[4:0], sum_3750[1:0], sum_3710[1:0], product_3611[4:0], sum_2741[0], difference_2682[1:0], detail_4[1:0], detail_3[1:0], sum_2280[4:0], sum_1766[1:0], sum_1765[1:0], sum_1761[0], sum_1710[0], sum_1706[0], sum_732[4:0], cfg_width_i[3:0]};

endmodule
