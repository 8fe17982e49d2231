// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 31 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2982 bits, pipeline 8780 bits, memories 120207 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q, valid_s28_q, valid_s29_q, valid_s30_q, valid_s31_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en, s27_en, s28_en, s29_en, s30_en;
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
  assign s30_en = en_i & valid_s30_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_2388;
  assign sum_2388 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3402;
  assign difference_3402 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [7:0] difference_3677;
  assign difference_3677 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_3879;
  assign less_3879 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_3880;
  assign sum_3880 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_3898;
  assign not_3898 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_482;
  assign select_482 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_482 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_482_s1_q;
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
      select_482_s1_q <= select_482;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:35
  logic [6:0] select_485;
  assign select_485 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:50
  logic equal_517;
  assign equal_517 = select_482_s1_q == 4'hf;
  // hls/stages/agreement.hpp:267
  logic [6:0] select_2037;
  assign select_2037 = sample_pair_whole_s1_q ? (select_485 + {6'h0, equal_517}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2037;
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
  logic [3:0] select_482_s2_q;
  logic [6:0] select_485_s2_q;
  logic equal_517_s2_q;
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
      select_482_s2_q <= select_482_s1_q;
      select_485_s2_q <= select_485;
      equal_517_s2_q <= equal_517;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:109
  logic equal_483;
  assign equal_483 = select_482_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:115
  logic [8:0] select_488;
  assign select_488 = ({select_485_s2_q, select_482_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_489;
  assign select_489 = equal_483 ? select_488 : averager_place_q;
  // hls/stages/census.hpp:41
  logic [3:0] select_500;
  assign select_500 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_2035;
  assign select_2035 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_500 + 4'h1) : select_500) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2035;
      averager_place_q <= sample_pair_whole_s2_q ? select_489 : averager_place_q;
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
  logic [3:0] select_482_s3_q;
  logic equal_483_s3_q;
  logic [6:0] select_485_s3_q;
  logic [8:0] select_489_s3_q;
  logic equal_491_s3_q;
  logic [3:0] select_500_s3_q;
  logic equal_517_s3_q;
  logic equal_518_s3_q;
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
      select_482_s3_q <= select_482_s2_q;
      equal_483_s3_q <= equal_483;
      select_485_s3_q <= select_485_s2_q;
      select_489_s3_q <= select_489;
      equal_491_s3_q <= select_482_s2_q[1:0] == 2'h3;
      select_500_s3_q <= select_500;
      equal_517_s3_q <= equal_517_s2_q;
      equal_518_s3_q <= select_500 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:41
  logic or_490;
  assign or_490 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:408
  logic and_495;
  assign and_495 = (or_490 & equal_491_s3_q) & (~(select_489_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:267
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_485_s3_q : 7'h0;
  // hls/stages/census.hpp:126
  logic and_519;
  assign and_519 = equal_518_s3_q & and_495;
  // hls/stages/agreement.hpp:267
  logic and_521;
  assign and_521 = sample_pair_whole_s3_q & (equal_517_s3_q & and_519);
  // hls/stages/census.hpp:41
  logic [6:0] select_580;
  assign select_580 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:267
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_580 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_2039;
  assign select_2039 = sample_last_s3_q ? (select_580 + {6'h0, equal_518_s3_q}) : select_580;
  // hls/stages/agreement.hpp:267
  logic select_2044;
  assign select_2044 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_490 & (~raster_final_row_q)) : or_490) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_2046;
  assign select_2046 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:267
  logic select_2050;
  assign select_2050 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:450
  logic equal_2294;
  assign equal_2294 = {last[7], column} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2039 : raster_at_row_q;
      raster_at_live_q <= select_2044;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2046 : raster_rows_left_q;
      raster_final_row_q <= select_2050;
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
  logic [3:0] select_482_s4_q;
  logic equal_483_s4_q;
  logic [6:0] select_485_s4_q;
  logic [8:0] select_489_s4_q;
  logic and_495_s4_q;
  logic [3:0] select_500_s4_q;
  logic [6:0] column_s4_q;
  logic and_519_s4_q;
  logic and_521_s4_q;
  logic [3:0] select_580_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1598_s4_q;
  logic equal_2294_s4_q;
  logic and_2295_s4_q;
  logic [7:0] sum_2384_s4_q;
  logic [2:0] or_2778_s4_q;
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
      select_482_s4_q <= select_482_s3_q;
      equal_483_s4_q <= equal_483_s3_q;
      select_485_s4_q <= select_485_s3_q;
      select_489_s4_q <= select_489_s3_q;
      and_495_s4_q <= and_495;
      select_500_s4_q <= select_500_s3_q;
      column_s4_q <= column;
      and_519_s4_q <= and_519;
      and_521_s4_q <= and_521;
      select_580_s4_q <= select_580[3:0];
      row_s4_q <= row;
      equal_1598_s4_q <= {or_490, select_500_s3_q} == 5'h18;
      equal_2294_s4_q <= equal_2294;
      and_2295_s4_q <= and_521 & equal_2294;
      sum_2384_s4_q <= {1'b0, row} + 8'h1;
      or_2778_s4_q <= select_485_s3_q[2:0] | select_580[6:4];
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
  // hls/stages/agreement.hpp:191
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:614
  logic equal_541;
  assign equal_541 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:605
  logic equal_544;
  assign equal_544 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:606
  logic equal_546;
  assign equal_546 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:514
  logic select_2298;
  assign select_2298 = (and_2295_s4_q | (~ends_cell_q)) ? and_2295_s4_q : ends_q;
  // hls/stages/agreement.hpp:520
  logic [2:0] now;
  assign now = select_2298 ? (and_2295_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:525
  logic [5:0] select_2302;
  assign select_2302 = select_2298 ? (and_2295_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2305;
  assign select_2305 = select_2298 ? (following_last_shift_q & (~and_2295_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2307;
  assign select_2307 = select_2298 ? (and_2295_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:598
  logic and_2308;
  assign and_2308 = run_last_shift_q & equal_544;
  // hls/stages/agreement.hpp:607
  logic select_2310;
  assign select_2310 = equal_544 ? (~run_last_shift_q) : equal_546;
  // hls/stages/agreement.hpp:611
  logic equal_2311;
  assign equal_2311 = run_phase_q == 3'h1;
  logic not_2314;
  assign not_2314 = ~select_2310;
  // hls/stages/agreement.hpp:614
  logic equal_2316;
  assign equal_2316 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:598
  logic and_2317;
  assign and_2317 = final_row_q & so;
  // hls/stages/agreement.hpp:611
  logic [1:0] select_2318;
  assign select_2318 = equal_2316 ? 2'h1 : {2{and_2317}};
  logic [2:0] select_2320;
  assign select_2320 = (and_2308 | (select_2310 | equal_2311)) ? (equal_2311 ? 3'h2 : {not_2314, {2{select_2310}}}) : (equal_541 ? 3'h6 : {select_2318[0], select_2318});
  // hls/stages/agreement.hpp:598
  logic and_2323;
  assign and_2323 = select_2310 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:621
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2326;
  assign select_2326 = (plan_shift_q[5] & select_2310) ? value : 7'h0;
  logic [1:0] or_2327;
  assign or_2327 = {2{so}} | select_2326[5:4];
  // hls/stages/agreement.hpp:624
  logic [7:0] or_2331;
  assign or_2331 = (select_2310 ? plan_columns_q : 8'h0) | ((equal_2311 | equal_2316) ? whole_q : 8'h0);
  logic [1:0] or_2332;
  assign or_2332 = {2{and_2308}} | or_2331[4:3];
  // hls/stages/agreement.hpp:625
  logic [7:0] or_2334;
  assign or_2334 = {or_2331[7:5], or_2332, or_2331[2:0]} | (equal_541 ? drawn_q : 8'h0);
  logic [4:0] or_2335;
  assign or_2335 = {5{so}} | {or_2334[6], or_2334[3:0]};
  // hls/stages/agreement.hpp:631
  logic not_2339;
  assign not_2339 = ~run_shift_q[5];
  logic [7:0] select_2342;
  assign select_2342 = equal_544 ? ({{7{not_2339}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:514
  logic [6:0] select_2346;
  assign select_2346 = and_2295_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:517
  logic [7:0] select_2348;
  assign select_2348 = select_2298 ? {select_2346[6], select_2346} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2351;
  assign select_2351 = select_2298 ? (and_2295_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:451
  logic [6:0] select_2358;
  assign select_2358 = equal_2294_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:511
  logic [7:0] select_2362;
  assign select_2362 = and_521_s4_q ? (equal_2294_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2365;
  assign select_2365 = and_521_s4_q ? (equal_2294_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:522
  logic select_2379;
  assign select_2379 = (ends_cell_q | select_2298) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_544 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:517
  logic and_2383;
  assign and_2383 = (~select_2298) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:467
  logic equal_2385;
  assign equal_2385 = {sum_2384_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2384_s4_q[6:0]};
  // hls/stages/agreement.hpp:511
  logic select_2387;
  assign select_2387 = and_521_s4_q ? (equal_2294_s4_q ? equal_2385 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:370
  logic [8:0] sum_2779;
  assign sum_2779 = {1'b0, select_485_s4_q[3], or_2778_s4_q, select_580_s4_q} + 9'h1;

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
    end else if (s4_en) begin
      run_phase_q <= now;
      run_shift_q <= select_2302;
      run_last_shift_q <= select_2305;
      run_span_q <= select_2307;
      following_phase_q <= select_2320;
      following_shift_q <= select_2310 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2323;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2326[6], or_2327, select_2326[3:0]};
      following_columns_q <= {or_2334[7], or_2335[4], or_2334[5:4], or_2335[3:0]};
      plan_shift_q <= equal_544 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2342;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2348;
      columns_left_q <= select_2351;
      last_q <= and_521_s4_q ? (equal_2294_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_521_s4_q ? select_2358 : least_q;
      whole_q <= select_2362;
      drawn_q <= select_2365;
      slot_q <= select_2298 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2379;
      ends_q <= and_2383;
      final_row_q <= select_2387;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
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
  logic [3:0] select_482_s5_q;
  logic equal_483_s5_q;
  logic [6:0] select_485_s5_q;
  logic [8:0] select_489_s5_q;
  logic and_495_s5_q;
  logic equal_501_s5_q;
  logic [6:0] column_s5_q;
  logic and_519_s5_q;
  logic and_521_s5_q;
  logic so_s5_q;
  logic equal_541_s5_q;
  logic equal_544_s5_q;
  logic equal_546_s5_q;
  logic [7:0] sum_547_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_657_s5_q;
  logic equal_1479_s5_q;
  logic equal_1598_s5_q;
  logic equal_2294_s5_q;
  logic and_2295_s5_q;
  logic select_2298_s5_q;
  logic not_2781_s5_q;
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
      select_482_s5_q <= select_482_s4_q;
      equal_483_s5_q <= equal_483_s4_q;
      select_485_s5_q <= select_485_s4_q;
      select_489_s5_q <= select_489_s4_q;
      and_495_s5_q <= and_495_s4_q;
      equal_501_s5_q <= select_500_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_519_s5_q <= and_519_s4_q;
      and_521_s5_q <= and_521_s4_q;
      so_s5_q <= so;
      equal_541_s5_q <= equal_541;
      equal_544_s5_q <= equal_544;
      equal_546_s5_q <= equal_546;
      sum_547_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_657_s5_q <= {1'b0, last_q} + 8'h3;
      equal_1479_s5_q <= run_phase_q == 3'h7;
      equal_1598_s5_q <= equal_1598_s4_q;
      equal_2294_s5_q <= equal_2294_s4_q;
      and_2295_s5_q <= and_2295_s4_q;
      select_2298_s5_q <= select_2298;
      not_2781_s5_q <= ~({sum_2779, select_500_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:585
  logic [7:0] select_548;
  assign select_548 = run_shift_s5_q[5] ? x_s5_q : sum_547_s5_q;
  logic less_549;
  assign less_549 = {1'b0, last_s5_q} < select_548;
  // hls/stages/agreement.hpp:219
  logic not_550;
  assign not_550 = ~less_549;
  // hls/stages/agreement.hpp:786
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:519
  logic [6:0] select_2367;
  assign select_2367 = select_2298_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2367;
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
  logic [3:0] select_482_s6_q;
  logic equal_483_s6_q;
  logic [6:0] select_485_s6_q;
  logic [8:0] select_489_s6_q;
  logic and_495_s6_q;
  logic equal_501_s6_q;
  logic [6:0] column_s6_q;
  logic and_519_s6_q;
  logic and_521_s6_q;
  logic so_s6_q;
  logic equal_541_s6_q;
  logic equal_544_s6_q;
  logic [6:0] sum_547_s6_q;
  logic less_549_s6_q;
  logic not_550_s6_q;
  logic and_551_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_661_s6_q;
  logic equal_1469_s6_q;
  logic equal_1479_s6_q;
  logic equal_1598_s6_q;
  logic equal_2294_s6_q;
  logic and_2295_s6_q;
  logic not_2781_s6_q;
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
      select_482_s6_q <= select_482_s5_q;
      equal_483_s6_q <= equal_483_s5_q;
      select_485_s6_q <= select_485_s5_q;
      select_489_s6_q <= select_489_s5_q;
      and_495_s6_q <= and_495_s5_q;
      equal_501_s6_q <= equal_501_s5_q;
      column_s6_q <= column_s5_q;
      and_519_s6_q <= and_519_s5_q;
      and_521_s6_q <= and_521_s5_q;
      so_s6_q <= so_s5_q;
      equal_541_s6_q <= equal_541_s5_q;
      equal_544_s6_q <= equal_544_s5_q;
      sum_547_s6_q <= sum_547_s5_q[6:0];
      less_549_s6_q <= less_549;
      not_550_s6_q <= not_550;
      and_551_s6_q <= equal_546_s5_q & not_550;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_661_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_657_s5_q < select_548)));
      equal_1469_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1479_s6_q <= equal_1479_s5_q;
      equal_1598_s6_q <= equal_1598_s5_q;
      equal_2294_s6_q <= equal_2294_s5_q;
      and_2295_s6_q <= and_2295_s5_q;
      not_2781_s6_q <= not_2781_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:585
  logic or_542;
  assign or_542 = so_s6_q | equal_541_s6_q;
  // hls/stages/agreement.hpp:708
  logic not_543;
  assign not_543 = ~or_542;
  // hls/stages/agreement.hpp:144
  logic select_637;
  assign select_637 = equal_544_s6_q ? not_550_s6_q : and_551_s6_q;
  logic and_662;
  assign and_662 = equal_544_s6_q & and_661_s6_q;
  logic select_663;
  assign select_663 = or_542 ? not_550_s6_q : and_662;
  // hls/stages/agreement.hpp:807
  logic [6:0] right;
  assign right = sum_547_s6_q + 7'h7d;

  // Memory left, 120 x 77, DISTANCE 24, hls/stages/agreement.hpp:1310; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 77'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & (or_542 ? not_550_s6_q : select_637);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 91, DISTANCE 24, hls/stages/agreement.hpp:1311; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_544_s6_q ? sum_547_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_543 & select_637);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 46, DISTANCE 24, hls/stages/agreement.hpp:1312; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 46'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_542 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_663;
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
  logic shift_first_s7_q;
  logic [3:0] select_482_s7_q;
  logic equal_483_s7_q;
  logic [6:0] select_485_s7_q;
  logic [8:0] select_489_s7_q;
  logic and_495_s7_q;
  logic equal_501_s7_q;
  logic [6:0] column_s7_q;
  logic and_519_s7_q;
  logic and_521_s7_q;
  logic so_s7_q;
  logic equal_541_s7_q;
  logic or_542_s7_q;
  logic equal_544_s7_q;
  logic less_549_s7_q;
  logic not_550_s7_q;
  logic and_553_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_663_s7_q;
  logic and_1461_s7_q;
  logic [6:0] right_s7_q;
  logic equal_1469_s7_q;
  logic equal_1479_s7_q;
  logic equal_1598_s7_q;
  logic equal_2294_s7_q;
  logic and_2295_s7_q;
  logic not_2781_s7_q;
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
      select_482_s7_q <= select_482_s6_q;
      equal_483_s7_q <= equal_483_s6_q;
      select_485_s7_q <= select_485_s6_q;
      select_489_s7_q <= select_489_s6_q;
      and_495_s7_q <= and_495_s6_q;
      equal_501_s7_q <= equal_501_s6_q;
      column_s7_q <= column_s6_q;
      and_519_s7_q <= and_519_s6_q;
      and_521_s7_q <= and_521_s6_q;
      so_s7_q <= so_s6_q;
      equal_541_s7_q <= equal_541_s6_q;
      or_542_s7_q <= or_542;
      equal_544_s7_q <= equal_544_s6_q;
      less_549_s7_q <= less_549_s6_q;
      not_550_s7_q <= not_550_s6_q;
      and_553_s7_q <= not_543 & ((~equal_544_s6_q) & and_551_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_663_s7_q <= select_663;
      and_1461_s7_q <= not_543 & and_662;
      right_s7_q <= right;
      equal_1469_s7_q <= equal_1469_s6_q;
      equal_1479_s7_q <= equal_1479_s6_q;
      equal_1598_s7_q <= equal_1598_s6_q;
      equal_2294_s7_q <= equal_2294_s6_q;
      and_2295_s7_q <= and_2295_s6_q;
      not_2781_s7_q <= not_2781_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------

  // Memory fresh, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1309; read in stage 7, written in stage 28: 7 < 28 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 29'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_553_s7_q;
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
  logic shift_first_s8_q;
  logic [3:0] select_482_s8_q;
  logic equal_483_s8_q;
  logic [6:0] select_485_s8_q;
  logic [8:0] select_489_s8_q;
  logic and_495_s8_q;
  logic equal_501_s8_q;
  logic [6:0] column_s8_q;
  logic and_519_s8_q;
  logic and_521_s8_q;
  logic so_s8_q;
  logic equal_541_s8_q;
  logic or_542_s8_q;
  logic equal_544_s8_q;
  logic less_549_s8_q;
  logic not_550_s8_q;
  logic and_553_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_663_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic and_1461_s8_q;
  logic [6:0] right_s8_q;
  logic equal_1469_s8_q;
  logic equal_1479_s8_q;
  logic equal_1598_s8_q;
  logic equal_2294_s8_q;
  logic and_2295_s8_q;
  logic not_2781_s8_q;
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
      shift_first_s8_q <= shift_first_s7_q;
      select_482_s8_q <= select_482_s7_q;
      equal_483_s8_q <= equal_483_s7_q;
      select_485_s8_q <= select_485_s7_q;
      select_489_s8_q <= select_489_s7_q;
      and_495_s8_q <= and_495_s7_q;
      equal_501_s8_q <= equal_501_s7_q;
      column_s8_q <= column_s7_q;
      and_519_s8_q <= and_519_s7_q;
      and_521_s8_q <= and_521_s7_q;
      so_s8_q <= so_s7_q;
      equal_541_s8_q <= equal_541_s7_q;
      or_542_s8_q <= or_542_s7_q;
      equal_544_s8_q <= equal_544_s7_q;
      less_549_s8_q <= less_549_s7_q;
      not_550_s8_q <= not_550_s7_q;
      and_553_s8_q <= and_553_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_663_s8_q <= select_663_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      and_1461_s8_q <= and_1461_s7_q;
      right_s8_q <= right_s7_q;
      equal_1469_s8_q <= equal_1469_s7_q;
      equal_1479_s8_q <= equal_1479_s7_q;
      equal_1598_s8_q <= equal_1598_s7_q;
      equal_2294_s8_q <= equal_2294_s7_q;
      and_2295_s8_q <= and_2295_s7_q;
      not_2781_s8_q <= not_2781_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  // hls/stages/agreement.hpp:657
  logic not_641;
  assign not_641 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:215
  logic and_669;
  assign and_669 = left_rdata_s8_q[44] & not_550_s8_q;
  logic and_670;
  assign and_670 = right_codes_rdata_s8_q[38] & not_550_s8_q;
  logic [11:0] select_671;
  assign select_671 = less_549_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_672;
  assign select_672 = less_549_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_676;
  assign select_676 = and_669 ? (and_670 ? (~(select_671 ^ select_672)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:215
  logic and_692;
  assign and_692 = left_rdata_s8_q[60] & not_550_s8_q;
  logic and_693;
  assign and_693 = right_codes_rdata_s8_q[51] & not_550_s8_q;
  logic [11:0] select_694;
  assign select_694 = less_549_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_695;
  assign select_695 = less_549_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_699;
  assign select_699 = and_692 ? (and_693 ? (~(select_694 ^ select_695)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:215
  logic and_709;
  assign and_709 = left_rdata_s8_q[76] & not_550_s8_q;
  logic and_710;
  assign and_710 = right_codes_rdata_s8_q[64] & not_550_s8_q;
  logic [11:0] select_711;
  assign select_711 = less_549_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_712;
  assign select_712 = less_549_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_716;
  assign select_716 = and_709 ? (and_710 ? (~(select_711 ^ select_712)) : 12'h0) : 12'h0;
  logic [11:0] select_924;
  assign select_924 = (slot_s8_q[0] ? and_710 : and_693) ? (~(select_672 ^ (slot_s8_q[0] ? select_711 : select_694))) : 12'h0;
  // hls/stages/agreement.hpp:215
  logic and_941;
  assign and_941 = right_codes_rdata_s8_q[77] & not_550_s8_q;
  logic [11:0] select_943;
  assign select_943 = less_549_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_947;
  assign select_947 = (slot_s8_q[0] ? and_941 : and_710) ? (~(select_695 ^ (slot_s8_q[0] ? select_943 : select_711))) : 12'h0;
  // hls/stages/agreement.hpp:722
  logic select_959;
  assign select_959 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_550_s8_q) : and_941;
  logic [11:0] select_961;
  assign select_961 = slot_s8_q[0] ? (less_549_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_943;
  // hls/stages/agreement.hpp:215
  logic and_1170;
  assign and_1170 = right_codes_rdata_s8_q[25] & not_550_s8_q;
  // hls/stages/agreement.hpp:722
  logic select_1171;
  assign select_1171 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_550_s8_q) : and_1170;
  // hls/stages/agreement.hpp:215
  logic [11:0] select_1173;
  assign select_1173 = less_549_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:722
  logic [11:0] select_1174;
  assign select_1174 = slot_s8_q[0] ? (less_549_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1173;
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1198;
  assign select_1198 = (slot_s8_q[0] ? and_1170 : and_670) ? (~(select_695 ^ (slot_s8_q[0] ? select_1173 : select_671))) : 12'h0;
  logic [11:0] select_1213;
  assign select_1213 = (slot_s8_q[0] ? and_670 : and_693) ? (~(select_712 ^ (slot_s8_q[0] ? select_671 : select_694))) : 12'h0;
  // hls/stages/agreement.hpp:940
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:945
  logic and_1485;
  assign and_1485 = (or_542_s8_q & (left_rdata_s8_q[61] & not_550_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:238
  logic and_1493;
  assign and_1493 = not_550_s8_q & (or_542_s8_q & (left_rdata_s8_q[63] & not_550_s8_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
    end else if (s8_en) begin
      row_q <= and_521_s8_q ? (equal_2294_s8_q ? row_s8_q : row_q) : row_q;
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
  logic shift_first_s9_q;
  logic [3:0] select_482_s9_q;
  logic equal_483_s9_q;
  logic [6:0] select_485_s9_q;
  logic [8:0] select_489_s9_q;
  logic and_495_s9_q;
  logic equal_501_s9_q;
  logic [6:0] column_s9_q;
  logic and_519_s9_q;
  logic and_521_s9_q;
  logic so_s9_q;
  logic equal_541_s9_q;
  logic or_542_s9_q;
  logic equal_544_s9_q;
  logic less_549_s9_q;
  logic not_550_s9_q;
  logic and_553_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic [6:0] row_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_642_s9_q;
  logic and_643_s9_q;
  logic and_644_s9_q;
  logic and_645_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_649_s9_q;
  logic and_650_s9_q;
  logic and_651_s9_q;
  logic and_652_s9_q;
  logic and_653_s9_q;
  logic and_654_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_663_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic and_669_s9_q;
  logic [11:0] select_676_s9_q;
  logic and_692_s9_q;
  logic [11:0] select_699_s9_q;
  logic and_709_s9_q;
  logic [11:0] select_716_s9_q;
  logic [11:0] select_924_s9_q;
  logic [11:0] select_947_s9_q;
  logic [11:0] select_964_s9_q;
  logic [11:0] select_1177_s9_q;
  logic [11:0] select_1198_s9_q;
  logic [11:0] select_1213_s9_q;
  logic and_1461_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic equal_1469_s9_q;
  logic equal_1479_s9_q;
  logic and_1486_s9_q;
  logic and_1489_s9_q;
  logic and_1493_s9_q;
  logic equal_1598_s9_q;
  logic less_1619_s9_q;
  logic and_2024_s9_q;
  logic equal_2294_s9_q;
  logic and_2295_s9_q;
  logic not_2781_s9_q;
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
      shift_first_s9_q <= shift_first_s8_q;
      select_482_s9_q <= select_482_s8_q;
      equal_483_s9_q <= equal_483_s8_q;
      select_485_s9_q <= select_485_s8_q;
      select_489_s9_q <= select_489_s8_q;
      and_495_s9_q <= and_495_s8_q;
      equal_501_s9_q <= equal_501_s8_q;
      column_s9_q <= column_s8_q;
      and_519_s9_q <= and_519_s8_q;
      and_521_s9_q <= and_521_s8_q;
      so_s9_q <= so_s8_q;
      equal_541_s9_q <= equal_541_s8_q;
      or_542_s9_q <= or_542_s8_q;
      equal_544_s9_q <= equal_544_s8_q;
      less_549_s9_q <= less_549_s8_q;
      not_550_s9_q <= not_550_s8_q;
      and_553_s9_q <= and_553_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      row_s9_q <= row_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_642_s9_q <= left_rdata_s8_q[12] & not_641;
      and_643_s9_q <= left_rdata_s8_q[28] & not_641;
      and_644_s9_q <= left_rdata_s8_q[44] & not_641;
      and_645_s9_q <= left_rdata_s8_q[60] & not_641;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_649_s9_q <= right_codes_rdata_s8_q[12] & not_641;
      and_650_s9_q <= right_codes_rdata_s8_q[25] & not_641;
      and_651_s9_q <= right_codes_rdata_s8_q[38] & not_641;
      and_652_s9_q <= right_codes_rdata_s8_q[51] & not_641;
      and_653_s9_q <= right_codes_rdata_s8_q[64] & not_641;
      and_654_s9_q <= right_codes_rdata_s8_q[77] & not_641;
      x_s9_2_q <= x_s8_2_q;
      select_663_s9_q <= select_663_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      and_669_s9_q <= and_669;
      select_676_s9_q <= select_676;
      and_692_s9_q <= and_692;
      select_699_s9_q <= select_699;
      and_709_s9_q <= and_709;
      select_716_s9_q <= select_716;
      select_924_s9_q <= select_924;
      select_947_s9_q <= select_947;
      select_964_s9_q <= select_959 ? (~(select_712 ^ select_961)) : 12'h0;
      select_1177_s9_q <= select_1171 ? (~(select_672 ^ select_1174)) : 12'h0;
      select_1198_s9_q <= select_1198;
      select_1213_s9_q <= select_1213;
      and_1461_s9_q <= and_1461_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      equal_1469_s9_q <= equal_1469_s8_q;
      equal_1479_s9_q <= equal_1479_s8_q;
      and_1486_s9_q <= not_550_s8_q & and_1485;
      and_1489_s9_q <= (or_542_s8_q & (left_rdata_s8_q[62] & not_550_s8_q)) & and_1485;
      and_1493_s9_q <= and_1493;
      equal_1598_s9_q <= equal_1598_s8_q;
      less_1619_s9_q <= 6'h4 < row_q[6:1];
      and_2024_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2294_s9_q <= equal_2294_s8_q;
      and_2295_s9_q <= and_2295_s8_q;
      not_2781_s9_q <= not_2781_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/count_bits.hpp:24
  logic parity_682;
  assign parity_682 = ^select_676_s9_q[5:3];
  logic parity_685;
  assign parity_685 = ^select_676_s9_q[8:6];
  logic parity_688;
  assign parity_688 = ^select_676_s9_q[11:3];
  logic parity_702;
  assign parity_702 = ^select_699_s9_q[8:6];
  logic parity_705;
  assign parity_705 = ^select_699_s9_q[11:9];
  logic parity_722;
  assign parity_722 = ^select_716_s9_q[2:0];
  logic parity_725;
  assign parity_725 = ^select_716_s9_q[5:3];
  logic parity_728;
  assign parity_728 = ^select_716_s9_q[8:0];
  logic parity_734;
  assign parity_734 = ^select_716_s9_q[11:9];
  logic parity_737;
  assign parity_737 = ^select_699_s9_q[2:0];
  logic parity_740;
  assign parity_740 = ^{select_716_s9_q[11:9], select_699_s9_q[5:0]};
  logic parity_743;
  assign parity_743 = ^{select_716_s9_q, select_699_s9_q, select_676_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_748;
  assign or_748 = (select_676_s9_q[1:0] == 2'h3) | (select_676_s9_q[2] & (select_676_s9_q[0] | select_676_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_752;
  assign or_752 = (select_699_s9_q[7:6] == 2'h3) | (select_699_s9_q[8] & (select_699_s9_q[6] | select_699_s9_q[7]));
  logic or_756;
  assign or_756 = (select_699_s9_q[10:9] == 2'h3) | (select_699_s9_q[11] & (select_699_s9_q[9] | select_699_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_764;
  assign or_764 = (select_716_s9_q[7:6] == 2'h3) | (select_716_s9_q[8] & (~(select_716_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_768;
  assign or_768 = (select_716_s9_q[1:0] == 2'h3) | (select_716_s9_q[2] & (select_716_s9_q[0] | select_716_s9_q[1]));
  logic or_772;
  assign or_772 = (select_716_s9_q[4:3] == 2'h3) | (select_716_s9_q[5] & (select_716_s9_q[3] | select_716_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_775;
  assign parity_775 = ^{or_772, or_768, or_764};
  // hls/stages/count_bits.hpp:23
  logic or_779;
  assign or_779 = (select_699_s9_q[4:3] == 2'h3) | (select_699_s9_q[5] & (select_699_s9_q[3] | select_699_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_783;
  assign or_783 = (select_716_s9_q[10:9] == 2'h3) | (select_716_s9_q[11] & (select_716_s9_q[9] | select_716_s9_q[10]));
  logic or_787;
  assign or_787 = (select_699_s9_q[1:0] == 2'h3) | (select_699_s9_q[2] & (select_699_s9_q[0] | select_699_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_790;
  assign parity_790 = ^{or_787, or_783, or_779};
  logic parity_793;
  assign parity_793 = ^{or_787, or_783, or_779, or_772, or_768, or_764, or_756, or_752, or_748};
  // hls/stages/count_bits.hpp:25
  logic or_798;
  assign or_798 = (parity_682 & parity_685) | ((^select_676_s9_q[11:9]) & (parity_682 | parity_685));
  logic and_801;
  assign and_801 = (^{select_699_s9_q[11:6], select_676_s9_q[2:0]}) & (parity_728 | parity_740);
  // hls/stages/count_bits.hpp:23
  logic or_809;
  assign or_809 = (select_676_s9_q[10:9] == 2'h3) | (select_676_s9_q[11] & (select_676_s9_q[9] | select_676_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_813;
  assign or_813 = (select_676_s9_q[4:3] == 2'h3) | (select_676_s9_q[5] & (select_676_s9_q[3] | select_676_s9_q[4]));
  logic or_817;
  assign or_817 = (select_676_s9_q[7:6] == 2'h3) | (select_676_s9_q[8] & (select_676_s9_q[6] | select_676_s9_q[7]));
  logic or_824;
  assign or_824 = (parity_702 & parity_705) | ((^select_676_s9_q[2:0]) & (parity_702 | parity_705));
  logic or_828;
  assign or_828 = (parity_722 & parity_725) | ((^select_716_s9_q[8:6]) & (parity_722 | parity_725));
  logic or_832;
  assign or_832 = (parity_734 & parity_737) | ((^select_699_s9_q[5:3]) & (parity_734 | parity_737));
  // hls/stages/agreement.hpp:673
  logic [11:0] select_925;
  assign select_925 = and_669_s9_q ? select_924_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_931;
  assign parity_931 = ^select_925[5:3];
  logic parity_934;
  assign parity_934 = ^select_925[8:6];
  logic parity_937;
  assign parity_937 = ^select_925[11:3];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_948;
  assign select_948 = and_692_s9_q ? select_947_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_951;
  assign parity_951 = ^select_948[8:6];
  logic parity_954;
  assign parity_954 = ^select_948[11:9];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_965;
  assign select_965 = and_709_s9_q ? select_964_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_971;
  assign parity_971 = ^select_965[2:0];
  logic parity_974;
  assign parity_974 = ^select_965[5:3];
  logic parity_977;
  assign parity_977 = ^select_965[8:0];
  logic parity_983;
  assign parity_983 = ^select_965[11:9];
  logic parity_986;
  assign parity_986 = ^select_948[2:0];
  logic parity_989;
  assign parity_989 = ^{select_965[11:9], select_948[5:0]};
  logic parity_992;
  assign parity_992 = ^{select_965, select_948, select_925[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_997;
  assign or_997 = (select_925[1:0] == 2'h3) | (select_925[2] & (select_925[0] | select_925[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1001;
  assign or_1001 = (select_948[7:6] == 2'h3) | (select_948[8] & (select_948[6] | select_948[7]));
  logic or_1005;
  assign or_1005 = (select_948[10:9] == 2'h3) | (select_948[11] & (select_948[9] | select_948[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1013;
  assign or_1013 = (select_965[7:6] == 2'h3) | (select_965[8] & (~(select_965[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1017;
  assign or_1017 = (select_965[1:0] == 2'h3) | (select_965[2] & (select_965[0] | select_965[1]));
  logic or_1021;
  assign or_1021 = (select_965[4:3] == 2'h3) | (select_965[5] & (select_965[3] | select_965[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1024;
  assign parity_1024 = ^{or_1021, or_1017, or_1013};
  // hls/stages/count_bits.hpp:23
  logic or_1028;
  assign or_1028 = (select_948[4:3] == 2'h3) | (select_948[5] & (select_948[3] | select_948[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1032;
  assign or_1032 = (select_965[10:9] == 2'h3) | (select_965[11] & (select_965[9] | select_965[10]));
  logic or_1036;
  assign or_1036 = (select_948[1:0] == 2'h3) | (select_948[2] & (select_948[0] | select_948[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1039;
  assign parity_1039 = ^{or_1036, or_1032, or_1028};
  logic parity_1042;
  assign parity_1042 = ^{or_1036, or_1032, or_1028, or_1021, or_1017, or_1013, or_1005, or_1001, or_997};
  // hls/stages/count_bits.hpp:25
  logic or_1047;
  assign or_1047 = (parity_931 & parity_934) | ((^select_925[11:9]) & (parity_931 | parity_934));
  logic and_1050;
  assign and_1050 = (^{select_948[11:6], select_925[2:0]}) & (parity_977 | parity_989);
  // hls/stages/count_bits.hpp:23
  logic or_1058;
  assign or_1058 = (select_925[10:9] == 2'h3) | (select_925[11] & (select_925[9] | select_925[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1062;
  assign or_1062 = (select_925[4:3] == 2'h3) | (select_925[5] & (select_925[3] | select_925[4]));
  logic or_1066;
  assign or_1066 = (select_925[7:6] == 2'h3) | (select_925[8] & (select_925[6] | select_925[7]));
  logic or_1073;
  assign or_1073 = (parity_951 & parity_954) | ((^select_925[2:0]) & (parity_951 | parity_954));
  logic or_1077;
  assign or_1077 = (parity_971 & parity_974) | ((^select_965[8:6]) & (parity_971 | parity_974));
  logic or_1081;
  assign or_1081 = (parity_983 & parity_986) | ((^select_948[5:3]) & (parity_983 | parity_986));
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1178;
  assign select_1178 = and_669_s9_q ? select_1177_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1184;
  assign parity_1184 = ^select_1178[5:3];
  logic parity_1187;
  assign parity_1187 = ^select_1178[8:6];
  logic parity_1190;
  assign parity_1190 = ^select_1178[11:3];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1199;
  assign select_1199 = and_692_s9_q ? select_1198_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1202;
  assign parity_1202 = ^select_1199[8:6];
  logic parity_1205;
  assign parity_1205 = ^select_1199[11:9];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1214;
  assign select_1214 = and_709_s9_q ? select_1213_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1220;
  assign parity_1220 = ^select_1214[2:0];
  logic parity_1223;
  assign parity_1223 = ^select_1214[5:3];
  logic parity_1226;
  assign parity_1226 = ^select_1214[8:0];
  logic parity_1232;
  assign parity_1232 = ^select_1214[11:9];
  logic parity_1235;
  assign parity_1235 = ^select_1199[2:0];
  logic parity_1238;
  assign parity_1238 = ^{select_1214[11:9], select_1199[5:0]};
  logic parity_1241;
  assign parity_1241 = ^{select_1214, select_1199, select_1178[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1246;
  assign or_1246 = (select_1178[1:0] == 2'h3) | (select_1178[2] & (select_1178[0] | select_1178[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1250;
  assign or_1250 = (select_1199[7:6] == 2'h3) | (select_1199[8] & (select_1199[6] | select_1199[7]));
  logic or_1254;
  assign or_1254 = (select_1199[10:9] == 2'h3) | (select_1199[11] & (select_1199[9] | select_1199[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1262;
  assign or_1262 = (select_1214[7:6] == 2'h3) | (select_1214[8] & (~(select_1214[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1266;
  assign or_1266 = (select_1214[1:0] == 2'h3) | (select_1214[2] & (select_1214[0] | select_1214[1]));
  logic or_1270;
  assign or_1270 = (select_1214[4:3] == 2'h3) | (select_1214[5] & (select_1214[3] | select_1214[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1273;
  assign parity_1273 = ^{or_1270, or_1266, or_1262};
  // hls/stages/count_bits.hpp:23
  logic or_1277;
  assign or_1277 = (select_1199[4:3] == 2'h3) | (select_1199[5] & (select_1199[3] | select_1199[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1281;
  assign or_1281 = (select_1214[10:9] == 2'h3) | (select_1214[11] & (select_1214[9] | select_1214[10]));
  logic or_1285;
  assign or_1285 = (select_1199[1:0] == 2'h3) | (select_1199[2] & (select_1199[0] | select_1199[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1288;
  assign parity_1288 = ^{or_1285, or_1281, or_1277};
  logic parity_1291;
  assign parity_1291 = ^{or_1285, or_1281, or_1277, or_1270, or_1266, or_1262, or_1254, or_1250, or_1246};
  // hls/stages/count_bits.hpp:25
  logic or_1296;
  assign or_1296 = (parity_1184 & parity_1187) | ((^select_1178[11:9]) & (parity_1184 | parity_1187));
  logic and_1299;
  assign and_1299 = (^{select_1199[11:6], select_1178[2:0]}) & (parity_1226 | parity_1238);
  // hls/stages/count_bits.hpp:23
  logic or_1307;
  assign or_1307 = (select_1178[10:9] == 2'h3) | (select_1178[11] & (select_1178[9] | select_1178[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1311;
  assign or_1311 = (select_1178[4:3] == 2'h3) | (select_1178[5] & (select_1178[3] | select_1178[4]));
  logic or_1315;
  assign or_1315 = (select_1178[7:6] == 2'h3) | (select_1178[8] & (select_1178[6] | select_1178[7]));
  logic or_1322;
  assign or_1322 = (parity_1202 & parity_1205) | ((^select_1178[2:0]) & (parity_1202 | parity_1205));
  logic or_1326;
  assign or_1326 = (parity_1220 & parity_1223) | ((^select_1214[8:6]) & (parity_1220 | parity_1223));
  logic or_1330;
  assign or_1330 = (parity_1232 & parity_1235) | ((^select_1199[5:3]) & (parity_1232 | parity_1235));
  // hls/stages/agreement.hpp:941
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:238
  logic or_1507;
  assign or_1507 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_553_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_645_s9_q, left_rdata_s9_q[56:42], and_644_s9_q, left_rdata_s9_q[41:27], and_643_s9_q, left_rdata_s9_q[26:12], and_642_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_553_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_654_s9_q, right_codes_rdata_s9_q[71:60], and_653_s9_q, right_codes_rdata_s9_q[59:48], and_652_s9_q, right_codes_rdata_s9_q[47:36], and_651_s9_q, right_codes_rdata_s9_q[35:24], and_650_s9_q, right_codes_rdata_s9_q[23:12], and_649_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
  logic shift_first_s10_q;
  logic [3:0] select_482_s10_q;
  logic equal_483_s10_q;
  logic [6:0] select_485_s10_q;
  logic [8:0] select_489_s10_q;
  logic and_495_s10_q;
  logic equal_501_s10_q;
  logic [6:0] column_s10_q;
  logic and_519_s10_q;
  logic and_521_s10_q;
  logic so_s10_q;
  logic equal_541_s10_q;
  logic or_542_s10_q;
  logic equal_544_s10_q;
  logic less_549_s10_q;
  logic not_550_s10_q;
  logic [6:0] row_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_663_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic xor_744_s10_q;
  logic parity_793_s10_q;
  logic and_794_s10_q;
  logic or_798_s10_q;
  logic or_802_s10_q;
  logic or_809_s10_q;
  logic or_813_s10_q;
  logic or_817_s10_q;
  logic or_824_s10_q;
  logic or_828_s10_q;
  logic or_832_s10_q;
  logic and_841_s10_q;
  logic and_843_s10_q;
  logic or_855_s10_q;
  logic or_859_s10_q;
  logic or_863_s10_q;
  logic xor_993_s10_q;
  logic parity_1008_s10_q;
  logic parity_1042_s10_q;
  logic and_1043_s10_q;
  logic or_1047_s10_q;
  logic or_1051_s10_q;
  logic or_1058_s10_q;
  logic or_1062_s10_q;
  logic or_1066_s10_q;
  logic or_1073_s10_q;
  logic or_1077_s10_q;
  logic or_1081_s10_q;
  logic and_1090_s10_q;
  logic or_1091_s10_q;
  logic or_1104_s10_q;
  logic or_1108_s10_q;
  logic or_1112_s10_q;
  logic xor_1242_s10_q;
  logic parity_1257_s10_q;
  logic parity_1291_s10_q;
  logic and_1292_s10_q;
  logic or_1296_s10_q;
  logic or_1300_s10_q;
  logic or_1307_s10_q;
  logic or_1311_s10_q;
  logic or_1315_s10_q;
  logic or_1322_s10_q;
  logic or_1326_s10_q;
  logic or_1330_s10_q;
  logic and_1339_s10_q;
  logic or_1340_s10_q;
  logic or_1353_s10_q;
  logic or_1357_s10_q;
  logic or_1361_s10_q;
  logic and_1461_s10_q;
  logic [6:0] select_1465_s10_q;
  logic [6:0] right_s10_q;
  logic equal_1469_s10_q;
  logic equal_1479_s10_q;
  logic and_1486_s10_q;
  logic and_1489_s10_q;
  logic and_1493_s10_q;
  logic or_1507_s10_q;
  logic equal_1598_s10_q;
  logic less_1619_s10_q;
  logic and_2024_s10_q;
  logic equal_2294_s10_q;
  logic and_2295_s10_q;
  logic not_2781_s10_q;
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
      shift_first_s10_q <= shift_first_s9_q;
      select_482_s10_q <= select_482_s9_q;
      equal_483_s10_q <= equal_483_s9_q;
      select_485_s10_q <= select_485_s9_q;
      select_489_s10_q <= select_489_s9_q;
      and_495_s10_q <= and_495_s9_q;
      equal_501_s10_q <= equal_501_s9_q;
      column_s10_q <= column_s9_q;
      and_519_s10_q <= and_519_s9_q;
      and_521_s10_q <= and_521_s9_q;
      so_s10_q <= so_s9_q;
      equal_541_s10_q <= equal_541_s9_q;
      or_542_s10_q <= or_542_s9_q;
      equal_544_s10_q <= equal_544_s9_q;
      less_549_s10_q <= less_549_s9_q;
      not_550_s10_q <= not_550_s9_q;
      row_s10_q <= row_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_663_s10_q <= select_663_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      xor_744_s10_q <= parity_688 ^ parity_743;
      parity_793_s10_q <= parity_793;
      and_794_s10_q <= parity_688 & parity_743;
      or_798_s10_q <= or_798;
      or_802_s10_q <= (parity_728 & parity_740) | and_801;
      or_809_s10_q <= or_809;
      or_813_s10_q <= or_813;
      or_817_s10_q <= or_817;
      or_824_s10_q <= or_824;
      or_828_s10_q <= or_828;
      or_832_s10_q <= or_832;
      and_841_s10_q <= parity_775 & parity_790;
      and_843_s10_q <= (^{or_756, or_752, or_748}) & (parity_775 | parity_790);
      or_855_s10_q <= (or_752 & or_756) | (or_748 & (or_752 | or_756));
      or_859_s10_q <= (or_768 & or_772) | (or_764 & (or_768 | or_772));
      or_863_s10_q <= (or_783 & or_787) | (or_779 & (or_783 | or_787));
      xor_993_s10_q <= parity_937 ^ parity_992;
      parity_1008_s10_q <= ^{or_1005, or_1001, or_997};
      parity_1042_s10_q <= parity_1042;
      and_1043_s10_q <= parity_937 & parity_992;
      or_1047_s10_q <= or_1047;
      or_1051_s10_q <= (parity_977 & parity_989) | and_1050;
      or_1058_s10_q <= or_1058;
      or_1062_s10_q <= or_1062;
      or_1066_s10_q <= or_1066;
      or_1073_s10_q <= or_1073;
      or_1077_s10_q <= or_1077;
      or_1081_s10_q <= or_1081;
      and_1090_s10_q <= parity_1024 & parity_1039;
      or_1091_s10_q <= parity_1024 | parity_1039;
      or_1104_s10_q <= (or_1001 & or_1005) | (or_997 & (or_1001 | or_1005));
      or_1108_s10_q <= (or_1017 & or_1021) | (or_1013 & (or_1017 | or_1021));
      or_1112_s10_q <= (or_1032 & or_1036) | (or_1028 & (or_1032 | or_1036));
      xor_1242_s10_q <= parity_1190 ^ parity_1241;
      parity_1257_s10_q <= ^{or_1254, or_1250, or_1246};
      parity_1291_s10_q <= parity_1291;
      and_1292_s10_q <= parity_1190 & parity_1241;
      or_1296_s10_q <= or_1296;
      or_1300_s10_q <= (parity_1226 & parity_1238) | and_1299;
      or_1307_s10_q <= or_1307;
      or_1311_s10_q <= or_1311;
      or_1315_s10_q <= or_1315;
      or_1322_s10_q <= or_1322;
      or_1326_s10_q <= or_1326;
      or_1330_s10_q <= or_1330;
      and_1339_s10_q <= parity_1273 & parity_1288;
      or_1340_s10_q <= parity_1273 | parity_1288;
      or_1353_s10_q <= (or_1250 & or_1254) | (or_1246 & (or_1250 | or_1254));
      or_1357_s10_q <= (or_1266 & or_1270) | (or_1262 & (or_1266 | or_1270));
      or_1361_s10_q <= (or_1281 & or_1285) | (or_1277 & (or_1281 | or_1285));
      and_1461_s10_q <= and_1461_s9_q;
      select_1465_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      equal_1469_s10_q <= equal_1469_s9_q;
      equal_1479_s10_q <= equal_1479_s9_q;
      and_1486_s10_q <= and_1486_s9_q;
      and_1489_s10_q <= and_1489_s9_q;
      and_1493_s10_q <= and_1493_s9_q;
      or_1507_s10_q <= or_1507;
      equal_1598_s10_q <= equal_1598_s9_q;
      less_1619_s10_q <= less_1619_s9_q;
      and_2024_s10_q <= and_2024_s9_q;
      equal_2294_s10_q <= equal_2294_s9_q;
      and_2295_s10_q <= and_2295_s9_q;
      not_2781_s10_q <= not_2781_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_phase_q;
  // hls/stages/count_bits.hpp:24
  logic parity_820;
  assign parity_820 = ^{or_817_s10_q, or_813_s10_q, or_809_s10_q};
  logic parity_835;
  assign parity_835 = ^{or_832_s10_q, or_828_s10_q, or_824_s10_q};
  logic parity_838;
  assign parity_838 = ^{or_832_s10_q, or_828_s10_q, or_824_s10_q, or_817_s10_q, or_813_s10_q, or_809_s10_q, or_802_s10_q, or_798_s10_q, and_794_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_840;
  assign and_840 = parity_793_s10_q & parity_838;
  logic or_844;
  assign or_844 = and_841_s10_q | and_843_s10_q;
  logic and_847;
  assign and_847 = (^{or_802_s10_q, or_798_s10_q, and_794_s10_q}) & (parity_820 | parity_835);
  logic or_848;
  assign or_848 = (parity_820 & parity_835) | and_847;
  // hls/stages/count_bits.hpp:24
  logic parity_866;
  assign parity_866 = ^{or_863_s10_q, or_859_s10_q, or_855_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_870;
  assign or_870 = (or_798_s10_q & or_802_s10_q) | (and_794_s10_q & (or_798_s10_q | or_802_s10_q));
  logic or_874;
  assign or_874 = (or_813_s10_q & or_817_s10_q) | (or_809_s10_q & (or_813_s10_q | or_817_s10_q));
  logic or_878;
  assign or_878 = (or_828_s10_q & or_832_s10_q) | (or_824_s10_q & (or_828_s10_q | or_832_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_881;
  assign parity_881 = ^{or_878, or_874, or_870};
  logic parity_884;
  assign parity_884 = ^{or_878, or_874, or_870, or_863_s10_q, or_859_s10_q, or_855_s10_q, or_848, or_844, and_840};
  // hls/stages/count_bits.hpp:25
  logic or_896;
  assign or_896 = (or_859_s10_q & or_863_s10_q) | (or_855_s10_q & (or_859_s10_q | or_863_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1069;
  assign parity_1069 = ^{or_1066_s10_q, or_1062_s10_q, or_1058_s10_q};
  logic parity_1084;
  assign parity_1084 = ^{or_1081_s10_q, or_1077_s10_q, or_1073_s10_q};
  logic parity_1087;
  assign parity_1087 = ^{or_1081_s10_q, or_1077_s10_q, or_1073_s10_q, or_1066_s10_q, or_1062_s10_q, or_1058_s10_q, or_1051_s10_q, or_1047_s10_q, and_1043_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1089;
  assign and_1089 = parity_1042_s10_q & parity_1087;
  logic or_1093;
  assign or_1093 = and_1090_s10_q | (parity_1008_s10_q & or_1091_s10_q);
  logic and_1096;
  assign and_1096 = (^{or_1051_s10_q, or_1047_s10_q, and_1043_s10_q}) & (parity_1069 | parity_1084);
  logic or_1097;
  assign or_1097 = (parity_1069 & parity_1084) | and_1096;
  // hls/stages/count_bits.hpp:24
  logic parity_1115;
  assign parity_1115 = ^{or_1112_s10_q, or_1108_s10_q, or_1104_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1119;
  assign or_1119 = (or_1047_s10_q & or_1051_s10_q) | (and_1043_s10_q & (or_1047_s10_q | or_1051_s10_q));
  logic or_1123;
  assign or_1123 = (or_1062_s10_q & or_1066_s10_q) | (or_1058_s10_q & (or_1062_s10_q | or_1066_s10_q));
  logic or_1127;
  assign or_1127 = (or_1077_s10_q & or_1081_s10_q) | (or_1073_s10_q & (or_1077_s10_q | or_1081_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1130;
  assign parity_1130 = ^{or_1127, or_1123, or_1119};
  logic parity_1133;
  assign parity_1133 = ^{or_1127, or_1123, or_1119, or_1112_s10_q, or_1108_s10_q, or_1104_s10_q, or_1097, or_1093, and_1089};
  // hls/stages/count_bits.hpp:25
  logic or_1145;
  assign or_1145 = (or_1108_s10_q & or_1112_s10_q) | (or_1104_s10_q & (or_1108_s10_q | or_1112_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1318;
  assign parity_1318 = ^{or_1315_s10_q, or_1311_s10_q, or_1307_s10_q};
  logic parity_1333;
  assign parity_1333 = ^{or_1330_s10_q, or_1326_s10_q, or_1322_s10_q};
  logic parity_1336;
  assign parity_1336 = ^{or_1330_s10_q, or_1326_s10_q, or_1322_s10_q, or_1315_s10_q, or_1311_s10_q, or_1307_s10_q, or_1300_s10_q, or_1296_s10_q, and_1292_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1338;
  assign and_1338 = parity_1291_s10_q & parity_1336;
  logic or_1342;
  assign or_1342 = and_1339_s10_q | (parity_1257_s10_q & or_1340_s10_q);
  logic and_1345;
  assign and_1345 = (^{or_1300_s10_q, or_1296_s10_q, and_1292_s10_q}) & (parity_1318 | parity_1333);
  logic or_1346;
  assign or_1346 = (parity_1318 & parity_1333) | and_1345;
  // hls/stages/count_bits.hpp:24
  logic parity_1364;
  assign parity_1364 = ^{or_1361_s10_q, or_1357_s10_q, or_1353_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1368;
  assign or_1368 = (or_1296_s10_q & or_1300_s10_q) | (and_1292_s10_q & (or_1296_s10_q | or_1300_s10_q));
  logic or_1372;
  assign or_1372 = (or_1311_s10_q & or_1315_s10_q) | (or_1307_s10_q & (or_1311_s10_q | or_1315_s10_q));
  logic or_1376;
  assign or_1376 = (or_1326_s10_q & or_1330_s10_q) | (or_1322_s10_q & (or_1326_s10_q | or_1330_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1379;
  assign parity_1379 = ^{or_1376, or_1372, or_1368};
  logic parity_1382;
  assign parity_1382 = ^{or_1376, or_1372, or_1368, or_1361_s10_q, or_1357_s10_q, or_1353_s10_q, or_1346, or_1342, and_1338};
  // hls/stages/count_bits.hpp:25
  logic or_1394;
  assign or_1394 = (or_1357_s10_q & or_1361_s10_q) | (or_1353_s10_q & (or_1357_s10_q | or_1361_s10_q));
  // hls/stages/agreement.hpp:144
  logic [6:0] select_1517;
  assign select_1517 = or_542_s10_q ? (less_549_s10_q ? 7'h0 : select_1465_s10_q) : 7'h0;
  // hls/stages/patches.hpp:122
  logic and_1592;
  assign and_1592 = (select_482_s10_q == 4'h0) & (select_485_s10_q == 7'h0);
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2715;
  assign select_2715 = and_1592 ? (sample_pair_first_s10_q ? phase : patches_phase_q) : patches_phase_q;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1313; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_542_s10_q ? select_1465_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_663_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_phase_q <= 4'h0;
    end else if (s10_en) begin
      patches_phase_q <= sample_pair_whole_s10_q ? select_2715 : patches_phase_q;
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
  logic shift_first_s11_q;
  logic [3:0] select_482_s11_q;
  logic equal_483_s11_q;
  logic [6:0] select_485_s11_q;
  logic [8:0] select_489_s11_q;
  logic and_495_s11_q;
  logic equal_501_s11_q;
  logic [6:0] column_s11_q;
  logic and_519_s11_q;
  logic and_521_s11_q;
  logic so_s11_q;
  logic equal_541_s11_q;
  logic or_542_s11_q;
  logic equal_544_s11_q;
  logic less_549_s11_q;
  logic not_550_s11_q;
  logic [6:0] row_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic xor_744_s11_q;
  logic xor_839_s11_q;
  logic parity_884_s11_q;
  logic and_885_s11_q;
  logic and_887_s11_q;
  logic and_889_s11_q;
  logic and_891_s11_q;
  logic or_896_s11_q;
  logic or_900_s11_q;
  logic xor_993_s11_q;
  logic xor_1088_s11_q;
  logic parity_1133_s11_q;
  logic and_1134_s11_q;
  logic and_1136_s11_q;
  logic and_1138_s11_q;
  logic and_1140_s11_q;
  logic or_1145_s11_q;
  logic or_1149_s11_q;
  logic xor_1242_s11_q;
  logic xor_1337_s11_q;
  logic parity_1382_s11_q;
  logic and_1383_s11_q;
  logic and_1385_s11_q;
  logic and_1387_s11_q;
  logic and_1389_s11_q;
  logic or_1394_s11_q;
  logic or_1398_s11_q;
  logic and_1461_s11_q;
  logic [6:0] right_s11_q;
  logic equal_1469_s11_q;
  logic equal_1479_s11_q;
  logic and_1486_s11_q;
  logic and_1489_s11_q;
  logic and_1493_s11_q;
  logic or_1507_s11_q;
  logic [6:0] select_1518_s11_q;
  logic and_1592_s11_q;
  logic equal_1598_s11_q;
  logic less_1619_s11_q;
  logic and_2024_s11_q;
  logic equal_2294_s11_q;
  logic and_2295_s11_q;
  logic [3:0] phase_s11_q;
  logic not_2781_s11_q;
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
      shift_first_s11_q <= shift_first_s10_q;
      select_482_s11_q <= select_482_s10_q;
      equal_483_s11_q <= equal_483_s10_q;
      select_485_s11_q <= select_485_s10_q;
      select_489_s11_q <= select_489_s10_q;
      and_495_s11_q <= and_495_s10_q;
      equal_501_s11_q <= equal_501_s10_q;
      column_s11_q <= column_s10_q;
      and_519_s11_q <= and_519_s10_q;
      and_521_s11_q <= and_521_s10_q;
      so_s11_q <= so_s10_q;
      equal_541_s11_q <= equal_541_s10_q;
      or_542_s11_q <= or_542_s10_q;
      equal_544_s11_q <= equal_544_s10_q;
      less_549_s11_q <= less_549_s10_q;
      not_550_s11_q <= not_550_s10_q;
      row_s11_q <= row_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      xor_744_s11_q <= xor_744_s10_q;
      xor_839_s11_q <= parity_793_s10_q ^ parity_838;
      parity_884_s11_q <= parity_884;
      and_885_s11_q <= parity_866 & parity_881;
      and_887_s11_q <= (^{or_848, or_844, and_840}) & (parity_866 | parity_881);
      and_889_s11_q <= or_844 & or_848;
      and_891_s11_q <= and_840 & (or_844 | or_848);
      or_896_s11_q <= or_896;
      or_900_s11_q <= (or_874 & or_878) | (or_870 & (or_874 | or_878));
      xor_993_s11_q <= xor_993_s10_q;
      xor_1088_s11_q <= parity_1042_s10_q ^ parity_1087;
      parity_1133_s11_q <= parity_1133;
      and_1134_s11_q <= parity_1115 & parity_1130;
      and_1136_s11_q <= (^{or_1097, or_1093, and_1089}) & (parity_1115 | parity_1130);
      and_1138_s11_q <= or_1093 & or_1097;
      and_1140_s11_q <= and_1089 & (or_1093 | or_1097);
      or_1145_s11_q <= or_1145;
      or_1149_s11_q <= (or_1123 & or_1127) | (or_1119 & (or_1123 | or_1127));
      xor_1242_s11_q <= xor_1242_s10_q;
      xor_1337_s11_q <= parity_1291_s10_q ^ parity_1336;
      parity_1382_s11_q <= parity_1382;
      and_1383_s11_q <= parity_1364 & parity_1379;
      and_1385_s11_q <= (^{or_1346, or_1342, and_1338}) & (parity_1364 | parity_1379);
      and_1387_s11_q <= or_1342 & or_1346;
      and_1389_s11_q <= and_1338 & (or_1342 | or_1346);
      or_1394_s11_q <= or_1394;
      or_1398_s11_q <= (or_1372 & or_1376) | (or_1368 & (or_1372 | or_1376));
      and_1461_s11_q <= and_1461_s10_q;
      right_s11_q <= right_s10_q;
      equal_1469_s11_q <= equal_1469_s10_q;
      equal_1479_s11_q <= equal_1479_s10_q;
      and_1486_s11_q <= and_1486_s10_q;
      and_1489_s11_q <= and_1489_s10_q;
      and_1493_s11_q <= and_1493_s10_q;
      or_1507_s11_q <= or_1507_s10_q;
      select_1518_s11_q <= so_s10_q ? x_s10_q[6:0] : select_1517;
      and_1592_s11_q <= and_1592;
      equal_1598_s11_q <= equal_1598_s10_q;
      less_1619_s11_q <= less_1619_s10_q;
      and_2024_s11_q <= and_2024_s10_q;
      equal_2294_s11_q <= equal_2294_s10_q;
      and_2295_s11_q <= and_2295_s10_q;
      phase_s11_q <= phase;
      not_2781_s11_q <= not_2781_s10_q;
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
  logic or_888;
  assign or_888 = and_885_s11_q | and_887_s11_q;
  logic or_892;
  assign or_892 = and_889_s11_q | and_891_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_905;
  assign parity_905 = ^{or_900_s11_q, or_896_s11_q, or_892, or_888};
  // hls/stages/count_bits.hpp:25
  logic or_909;
  assign or_909 = (or_896_s11_q & or_900_s11_q) | (or_892 & (or_896_s11_q | or_900_s11_q));
  logic and_910;
  assign and_910 = or_888 & (^{or_900_s11_q, or_896_s11_q, or_892});
  // hls/stages/count_bits.hpp:24
  logic xor_911;
  assign xor_911 = or_909 ^ and_910;
  // hls/stages/count_bits.hpp:27
  logic and_912;
  assign and_912 = or_909 & and_910;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_913;
  assign select_913 = equal_544_s11_q ? {and_912, xor_911, parity_905, parity_884_s11_q, xor_839_s11_q, xor_744_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_542_s11_q ? 6'h0 : select_913;
  // hls/stages/count_bits.hpp:25
  logic or_1137;
  assign or_1137 = and_1134_s11_q | and_1136_s11_q;
  logic or_1141;
  assign or_1141 = and_1138_s11_q | and_1140_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1154;
  assign parity_1154 = ^{or_1149_s11_q, or_1145_s11_q, or_1141, or_1137};
  // hls/stages/count_bits.hpp:25
  logic or_1158;
  assign or_1158 = (or_1145_s11_q & or_1149_s11_q) | (or_1141 & (or_1145_s11_q | or_1149_s11_q));
  logic and_1159;
  assign and_1159 = or_1137 & (^{or_1149_s11_q, or_1145_s11_q, or_1141});
  // hls/stages/count_bits.hpp:24
  logic xor_1160;
  assign xor_1160 = or_1158 ^ and_1159;
  // hls/stages/count_bits.hpp:27
  logic and_1161;
  assign and_1161 = or_1158 & and_1159;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_1162;
  assign select_1162 = equal_544_s11_q ? {and_1161, xor_1160, parity_1154, parity_1133_s11_q, xor_1088_s11_q, xor_993_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_542_s11_q ? 6'h0 : select_1162;
  // hls/stages/count_bits.hpp:25
  logic or_1386;
  assign or_1386 = and_1383_s11_q | and_1385_s11_q;
  logic or_1390;
  assign or_1390 = and_1387_s11_q | and_1389_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1403;
  assign parity_1403 = ^{or_1398_s11_q, or_1394_s11_q, or_1390, or_1386};
  // hls/stages/count_bits.hpp:25
  logic or_1407;
  assign or_1407 = (or_1394_s11_q & or_1398_s11_q) | (or_1390 & (or_1394_s11_q | or_1398_s11_q));
  logic and_1408;
  assign and_1408 = or_1386 & (^{or_1398_s11_q, or_1394_s11_q, or_1390});
  // hls/stages/count_bits.hpp:24
  logic xor_1409;
  assign xor_1409 = or_1407 ^ and_1408;
  // hls/stages/count_bits.hpp:27
  logic and_1410;
  assign and_1410 = or_1407 & and_1408;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_1411;
  assign select_1411 = equal_544_s11_q ? {and_1410, xor_1409, parity_1403, parity_1382_s11_q, xor_1337_s11_q, xor_1242_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_542_s11_q ? 6'h0 : select_1411;
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1447;
  assign sum_1447 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1450;
  assign sum_1450 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:451
  logic select_2391;
  assign select_2391 = equal_2294_s11_q ? (~({row_s11_q, 1'b0} < {sum_2388, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:511
  logic and_2605;
  assign and_2605 = and_521_s11_q & (equal_2294_s11_q & (row_s11_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      lower_half_q <= 1'b0;
    end else if (s11_en) begin
      lower_half_q <= and_521_s11_q ? select_2391 : lower_half_q;
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
  logic shift_first_s12_q;
  logic [3:0] select_482_s12_q;
  logic equal_483_s12_q;
  logic [6:0] select_485_s12_q;
  logic [8:0] select_489_s12_q;
  logic and_495_s12_q;
  logic equal_501_s12_q;
  logic [6:0] column_s12_q;
  logic and_519_s12_q;
  logic and_521_s12_q;
  logic so_s12_q;
  logic equal_541_s12_q;
  logic or_542_s12_q;
  logic less_549_s12_q;
  logic not_550_s12_q;
  logic equal_582_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1164_s12_q;
  logic [5:0] select_1413_s12_q;
  logic [6:0] sum_1448_s12_q;
  logic [6:0] sum_1451_s12_q;
  logic and_1461_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic equal_1469_s12_q;
  logic equal_1479_s12_q;
  logic and_1486_s12_q;
  logic and_1489_s12_q;
  logic and_1493_s12_q;
  logic or_1507_s12_q;
  logic [6:0] select_1518_s12_q;
  logic and_1592_s12_q;
  logic equal_1598_s12_q;
  logic less_1619_s12_q;
  logic and_2024_s12_q;
  logic equal_2170_s12_q;
  logic equal_2294_s12_q;
  logic and_2606_s12_q;
  logic and_2608_s12_q;
  logic [3:0] phase_s12_q;
  logic equal_2735_s12_q;
  logic [3:0] select_2738_s12_q;
  logic less_2749_s12_q;
  logic not_2781_s12_q;
  logic less_3655_s12_q;
  logic equal_3860_s12_q;
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
      shift_first_s12_q <= shift_first_s11_q;
      select_482_s12_q <= select_482_s11_q;
      equal_483_s12_q <= equal_483_s11_q;
      select_485_s12_q <= select_485_s11_q;
      select_489_s12_q <= select_489_s11_q;
      and_495_s12_q <= and_495_s11_q;
      equal_501_s12_q <= equal_501_s11_q;
      column_s12_q <= column_s11_q;
      and_519_s12_q <= and_519_s11_q;
      and_521_s12_q <= and_521_s11_q;
      so_s12_q <= so_s11_q;
      equal_541_s12_q <= equal_541_s11_q;
      or_542_s12_q <= or_542_s11_q;
      less_549_s12_q <= less_549_s11_q;
      not_550_s12_q <= not_550_s11_q;
      equal_582_s12_q <= row_s11_q == 7'h0;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      column_2_s12_q <= column_2;
      select_1164_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1413_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1448_s12_q <= {1'b0, before_v_2} + sum_1447;
      sum_1451_s12_q <= {1'b0, before_v_3} + sum_1450;
      and_1461_s12_q <= and_1461_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      equal_1469_s12_q <= equal_1469_s11_q;
      equal_1479_s12_q <= equal_1479_s11_q;
      and_1486_s12_q <= and_1486_s11_q;
      and_1489_s12_q <= and_1489_s11_q;
      and_1493_s12_q <= and_1493_s11_q;
      or_1507_s12_q <= or_1507_s11_q;
      select_1518_s12_q <= select_1518_s11_q;
      and_1592_s12_q <= and_1592_s11_q;
      equal_1598_s12_q <= equal_1598_s11_q;
      less_1619_s12_q <= less_1619_s11_q;
      and_2024_s12_q <= and_2024_s11_q;
      equal_2170_s12_q <= (column_s11_q | row_s11_q) == 7'h0;
      equal_2294_s12_q <= equal_2294_s11_q;
      and_2606_s12_q <= and_2295_s11_q & and_2605;
      and_2608_s12_q <= and_2295_s11_q & (~and_2605);
      phase_s12_q <= phase_s11_q;
      equal_2735_s12_q <= row_s11_q == 7'h3;
      select_2738_s12_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      less_2749_s12_q <= 7'h2 < row_s11_q;
      not_2781_s12_q <= not_2781_s11_q;
      less_3655_s12_q <= 6'h2 < row_s11_q[6:1];
      equal_3860_s12_q <= row_s11_q[6:3] == 4'h0;
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
  logic [3:0] patches_choosing_rows_to_next_q;
  logic patches_chooses_q;
  // hls/stages/agreement.hpp:795
  logic or_666;
  assign or_666 = shift_first_s12_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:766
  logic [5:0] select_915;
  assign select_915 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1443;
  assign sum_1443 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1453;
  assign select_1453 = (sum_1448_s12_q < sum_1451_s12_q) ? sum_1451_s12_q : sum_1448_s12_q;
  // hls/stages/agreement.hpp:949
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:230
  logic [5:0] select_2394;
  assign select_2394 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2395;
  assign select_2395 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2396;
  assign select_2396 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2397;
  assign select_2397 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2398;
  assign select_2398 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2399;
  assign select_2399 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2739;
  assign select_2739 = equal_2735_s12_q ? select_2738_s12_q : patches_choosing_rows_to_next_q;
  logic equal_2740;
  assign equal_2740 = select_2739 == 4'h0;
  // hls/stages/agreement.hpp:451
  logic [3:0] select_2743;
  assign select_2743 = equal_2294_s12_q ? (equal_2740 ? 4'h2 : (select_2739 + 4'hf)) : patches_choosing_rows_to_next_q;
  logic select_2751;
  assign select_2751 = equal_2294_s12_q ? (less_2749_s12_q & equal_2740) : patches_chooses_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      shift_not_right_q <= 1'b0;
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_chooses_q <= 1'b0;
    end else if (s12_en) begin
      shift_not_right_q <= $signed(run_shift_s12_q) < $signed(6'h1);
      patches_choosing_rows_to_next_q <= and_521_s12_q ? select_2743 : patches_choosing_rows_to_next_q;
      patches_chooses_q <= and_521_s12_q ? select_2751 : patches_chooses_q;
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
      middle_sum_columns_values_1_q <= select_2394;
      middle_sum_columns_values_2_q <= select_2395;
      middle_sum_columns_values_3_q <= select_2396;
      middle_sum_columns_values_4_q <= select_2397;
      middle_sum_columns_values_5_q <= select_2398;
      middle_sum_columns_values_6_q <= select_2399;
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
  logic shift_not_right_s13_q;
  logic [3:0] patches_choosing_rows_to_next_s13_q;
  logic patches_chooses_s13_q;
  logic [3:0] select_482_s13_q;
  logic equal_483_s13_q;
  logic [6:0] select_485_s13_q;
  logic [8:0] select_489_s13_q;
  logic and_495_s13_q;
  logic equal_501_s13_q;
  logic [6:0] column_s13_q;
  logic and_519_s13_q;
  logic and_521_s13_q;
  logic so_s13_q;
  logic equal_541_s13_q;
  logic or_542_s13_q;
  logic less_549_s13_q;
  logic not_550_s13_q;
  logic equal_582_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_668_s13_q;
  logic [6:0] difference_916_s13_q;
  logic [6:0] difference_1165_s13_q;
  logic equal_1166_s13_q;
  logic [6:0] difference_1414_s13_q;
  logic [6:0] sum_1444_s13_q;
  logic [6:0] select_1453_s13_q;
  logic and_1461_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic select_1470_s13_q;
  logic equal_1479_s13_q;
  logic and_1486_s13_q;
  logic and_1489_s13_q;
  logic and_1493_s13_q;
  logic less_1494_s13_q;
  logic [6:0] chosen_s13_q;
  logic or_1507_s13_q;
  logic [6:0] select_1518_s13_q;
  logic and_1592_s13_q;
  logic equal_1598_s13_q;
  logic less_1619_s13_q;
  logic and_2024_s13_q;
  logic equal_2170_s13_q;
  logic equal_2294_s13_q;
  logic and_2606_s13_q;
  logic and_2608_s13_q;
  logic and_2615_s13_q;
  logic [3:0] phase_s13_q;
  logic equal_2735_s13_q;
  logic equal_2740_s13_q;
  logic not_2781_s13_q;
  logic less_3655_s13_q;
  logic equal_3860_s13_q;
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
      shift_not_right_s13_q <= shift_not_right_q;
      patches_choosing_rows_to_next_s13_q <= patches_choosing_rows_to_next_q;
      patches_chooses_s13_q <= patches_chooses_q;
      select_482_s13_q <= select_482_s12_q;
      equal_483_s13_q <= equal_483_s12_q;
      select_485_s13_q <= select_485_s12_q;
      select_489_s13_q <= select_489_s12_q;
      and_495_s13_q <= and_495_s12_q;
      equal_501_s13_q <= equal_501_s12_q;
      column_s13_q <= column_s12_q;
      and_519_s13_q <= and_519_s12_q;
      and_521_s13_q <= and_521_s12_q;
      so_s13_q <= so_s12_q;
      equal_541_s13_q <= equal_541_s12_q;
      or_542_s13_q <= or_542_s12_q;
      less_549_s13_q <= less_549_s12_q;
      not_550_s13_q <= not_550_s12_q;
      equal_582_s13_q <= equal_582_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_668_s13_q <= or_666 ? shift_first_s12_q : (~age_s12_q[1]);
      difference_916_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_915};
      difference_1165_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1164_s12_q};
      equal_1166_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1414_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1413_s12_q};
      sum_1444_s13_q <= {1'b0, before_v} + sum_1443;
      select_1453_s13_q <= select_1453;
      and_1461_s13_q <= and_1461_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1470_s13_q <= or_666 ? shift_first_s12_q : equal_1469_s12_q;
      equal_1479_s13_q <= equal_1479_s12_q;
      and_1486_s13_q <= and_1486_s12_q;
      and_1489_s13_q <= and_1489_s12_q;
      and_1493_s13_q <= and_1493_s12_q;
      less_1494_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      chosen_s13_q <= chosen;
      or_1507_s13_q <= or_1507_s12_q;
      select_1518_s13_q <= select_1518_s12_q;
      and_1592_s13_q <= and_1592_s12_q;
      equal_1598_s13_q <= equal_1598_s12_q;
      less_1619_s13_q <= less_1619_s12_q;
      and_2024_s13_q <= and_2024_s12_q;
      equal_2170_s13_q <= equal_2170_s12_q;
      equal_2294_s13_q <= equal_2294_s12_q;
      and_2606_s13_q <= and_2606_s12_q;
      and_2608_s13_q <= and_2608_s12_q;
      and_2615_s13_q <= ends_cell_s12_q & so_s12_q;
      phase_s13_q <= phase_s12_q;
      equal_2735_s13_q <= equal_2735_s12_q;
      equal_2740_s13_q <= equal_2740;
      not_2781_s13_q <= not_2781_s12_q;
      less_3655_s13_q <= less_3655_s12_q;
      equal_3860_s13_q <= equal_3860_s12_q;
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
  // hls/stages/agreement.hpp:766
  logic [7:0] sum_918;
  assign sum_918 = {difference_916_s13_q[6], difference_916_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1168;
  assign sum_1168 = {difference_1165_s13_q[6], difference_1165_s13_q} + (equal_1166_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1416;
  assign sum_1416 = {difference_1414_s13_q[6], difference_1414_s13_q} + (equal_1166_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:743
  logic [6:0] select_1445;
  assign select_1445 = slot_s13_q[0] ? chosen_near_q : sum_1444_s13_q;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1455;
  assign select_1455 = (select_1445 < select_1453_s13_q) ? select_1453_s13_q : select_1445;
  // hls/stages/agreement.hpp:948
  logic select_1496;
  assign select_1496 = slot_s13_q[2] ? less_1494_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:955
  logic [8:0] difference_1499;
  assign difference_1499 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/census.hpp:31
  logic not_1596;
  assign not_1596 = ~sample_pair_first_s13_q;
  // hls/stages/patches.hpp:311
  logic equal_1600;
  assign equal_1600 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1668;
  assign select_1668 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1892;
  assign sum_1892 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:230
  logic [6:0] select_2406;
  assign select_2406 = slot_s13_q[0] ? 7'h0 : sum_1444_s13_q;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_2408;
  assign select_2408 = (select_2406 < select_1453_s13_q) ? select_1453_s13_q : select_2406;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2609;
  assign select_2609 = and_2608_s13_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2611;
  assign select_2611 = and_2606_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2609[15]}}, select_2609});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2612;
  assign select_2612 = and_2608_s13_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2612[15]}}, select_2612};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2614;
  assign select_2614 = and_2606_s13_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2615_s13_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:372
  logic and_2717;
  assign and_2717 = not_1596 & equal_1598_s13_q;
  logic [8:0] select_2718;
  assign select_2718 = and_2717 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s13_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2719;
  assign select_2719 = and_2717 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2720;
  assign select_2720 = sample_pair_first_s13_q ? select_2718 : select_2719;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2721;
  assign select_2721 = and_1592_s13_q ? select_2720[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_2722;
  assign select_2722 = sample_pair_whole_s13_q ? select_2721 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2724;
  assign select_2724 = sample_pair_whole_s13_q ? (and_1592_s13_q ? select_2720[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2727;
  assign select_2727 = sample_pair_whole_s13_q ? (equal_1600 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2729;
  assign select_2729 = sample_pair_whole_s13_q ? (patches_band_rows_number_q + {4'h0, equal_1600}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2730;
  assign equal_2730 = phase_s13_q == 4'h0;
  // hls/stages/patches.hpp:331
  logic not_2731;
  assign not_2731 = ~equal_2730;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_2733;
  assign select_2733 = sample_pair_whole_s13_q ? (phase_s13_q + {{2{not_2731}}, 1'b1, not_2731}) : patches_first_band_rows_to_next_q;
  logic select_2734;
  assign select_2734 = sample_pair_whole_s13_q ? equal_2730 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2745;
  assign select_2745 = equal_2735_s13_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:451
  logic [4:0] select_2747;
  assign select_2747 = equal_2294_s13_q ? (select_2745 + {4'h0, equal_2740_s13_q}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:511
  logic [4:0] select_2754;
  assign select_2754 = and_521_s13_q ? (equal_2294_s13_q ? select_2745 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:200
  logic [8:0] select_3667;
  assign select_3667 = so_s13_q ? (and_2615_s13_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3669;
  assign sum_3669 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3670;
  assign select_3670 = sum_1892[5] ? {1'b1, sum_1892[4:0], region_across_rest_q[2:0]} : sum_3669;
  // hls/stages/agreement.hpp:451
  logic [8:0] select_3672;
  assign select_3672 = equal_2294_s13_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3675;
  assign select_3675 = equal_2294_s13_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

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
      chosen_near_q <= select_2408;
      registration_slope_row_q <= select_2611;
      registration_slope_change_q <= select_2614;
      registration_slope_q <= so_s13_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2722;
      patches_band_rows_number_q <= select_2724;
      patches_next_band_rows_to_next_q <= select_2727;
      patches_next_band_number_q <= select_2729;
      patches_first_band_rows_to_next_q <= select_2733;
      patches_first_band_number_q <= select_2734;
      patches_choosing_number_q <= and_521_s13_q ? select_2747 : patches_choosing_number_q;
      patches_choosing_band_q <= select_2754;
      region_across_rest_q <= select_3667;
      region_across_back_q <= so_s13_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3670;
      columns_begin_rest_q <= and_521_s13_q ? select_3672 : columns_begin_rest_q;
      columns_begin_back_q <= and_521_s13_q ? select_3675 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_918;
      sums_0_sum_sums_values_0_q <= sum_1168;
      sums_0_sum_sums_values_1_q <= equal_1166_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1416;
      sums_1_sum_sums_values_1_q <= equal_1166_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic shift_not_right_s14_q;
  logic [11:0] registration_slope_s14_q;
  logic [4:0] patches_band_rows_number_s14_q;
  logic patches_chooses_s14_q;
  logic [4:0] patches_choosing_band_s14_q;
  logic [3:0] select_482_s14_q;
  logic equal_483_s14_q;
  logic [6:0] select_485_s14_q;
  logic [8:0] select_489_s14_q;
  logic and_495_s14_q;
  logic equal_501_s14_q;
  logic [6:0] column_s14_q;
  logic and_519_s14_q;
  logic and_521_s14_q;
  logic so_s14_q;
  logic equal_541_s14_q;
  logic or_542_s14_q;
  logic less_549_s14_q;
  logic not_550_s14_q;
  logic equal_582_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_668_s14_q;
  logic [7:0] sum_918_s14_q;
  logic less_1417_s14_q;
  logic [6:0] select_1455_s14_q;
  logic and_1461_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic select_1470_s14_q;
  logic equal_1479_s14_q;
  logic and_1486_s14_q;
  logic and_1489_s14_q;
  logic and_1493_s14_q;
  logic select_1496_s14_q;
  logic [9:0] sum_1500_s14_q;
  logic or_1507_s14_q;
  logic [6:0] select_1518_s14_q;
  logic and_1592_s14_q;
  logic not_1596_s14_q;
  logic or_1602_s14_q;
  logic less_1619_s14_q;
  logic [16:0] select_1668_s14_q;
  logic sum_1892_s14_q;
  logic and_2024_s14_q;
  logic equal_2170_s14_q;
  logic equal_2294_s14_q;
  logic not_2781_s14_q;
  logic less_3655_s14_q;
  logic equal_3860_s14_q;
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
      shift_not_right_s14_q <= shift_not_right_s13_q;
      registration_slope_s14_q <= registration_slope_q[27:16];
      patches_band_rows_number_s14_q <= patches_band_rows_number_q;
      patches_chooses_s14_q <= patches_chooses_s13_q;
      patches_choosing_band_s14_q <= patches_choosing_band_q;
      select_482_s14_q <= select_482_s13_q;
      equal_483_s14_q <= equal_483_s13_q;
      select_485_s14_q <= select_485_s13_q;
      select_489_s14_q <= select_489_s13_q;
      and_495_s14_q <= and_495_s13_q;
      equal_501_s14_q <= equal_501_s13_q;
      column_s14_q <= column_s13_q;
      and_519_s14_q <= and_519_s13_q;
      and_521_s14_q <= and_521_s13_q;
      so_s14_q <= so_s13_q;
      equal_541_s14_q <= equal_541_s13_q;
      or_542_s14_q <= or_542_s13_q;
      less_549_s14_q <= less_549_s13_q;
      not_550_s14_q <= not_550_s13_q;
      equal_582_s14_q <= equal_582_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_668_s14_q <= select_668_s13_q;
      sum_918_s14_q <= sum_918;
      less_1417_s14_q <= sum_1168 < sum_1416;
      select_1455_s14_q <= select_1455;
      and_1461_s14_q <= and_1461_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      select_1470_s14_q <= select_1470_s13_q;
      equal_1479_s14_q <= equal_1479_s13_q;
      and_1486_s14_q <= and_1486_s13_q;
      and_1489_s14_q <= and_1489_s13_q;
      and_1493_s14_q <= and_1493_s13_q;
      select_1496_s14_q <= select_1496;
      sum_1500_s14_q <= {difference_1499[8], difference_1499} + 10'h1;
      or_1507_s14_q <= or_1507_s13_q;
      select_1518_s14_q <= select_1518_s13_q;
      and_1592_s14_q <= and_1592_s13_q;
      not_1596_s14_q <= not_1596;
      or_1602_s14_q <= (~equal_1598_s13_q) | (~equal_1600);
      less_1619_s14_q <= less_1619_s13_q;
      select_1668_s14_q <= select_1668;
      sum_1892_s14_q <= sum_1892[5];
      and_2024_s14_q <= and_2024_s13_q;
      equal_2170_s14_q <= equal_2170_s13_q;
      equal_2294_s14_q <= equal_2294_s13_q;
      not_2781_s14_q <= not_2781_s13_q;
      less_3655_s14_q <= less_3655_s13_q;
      equal_3860_s14_q <= equal_3860_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [7:0] chosen_score_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  logic shift_allowed_q;
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
  // hls/stages/agreement.hpp:743
  logic [7:0] select_919;
  assign select_919 = slot_s14_q[0] ? chosen_score_q : sum_918_s14_q;
  // hls/stages/agreement.hpp:739
  logic [7:0] select_1418;
  assign select_1418 = less_1417_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1419;
  assign less_1419 = select_919 < select_1418;
  // hls/stages/agreement.hpp:789
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1419 ? select_1418 : select_919) : 8'h0;
  // hls/stages/agreement.hpp:708
  logic not_1425;
  assign not_1425 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:740
  logic [1:0] select_1426;
  assign select_1426 = less_1417_s14_q ? {slot_s14_q[0], not_1425} : 2'h0;
  logic [2:0] select_1428;
  assign select_1428 = less_1419 ? {select_1426, not_1425} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:790
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1455_s14_q : 7'h0;
  // hls/stages/agreement.hpp:238
  logic and_1502;
  assign and_1502 = (and_1489_s14_q & select_1496_s14_q) & ({{22{sum_1500_s14_q[9]}}, sum_1500_s14_q} < 32'h3);
  // hls/stages/patches.hpp:391
  logic not_1593;
  assign not_1593 = ~patches_begins_q;
  // hls/stages/patches.hpp:361
  logic and_1597;
  assign and_1597 = patches_capturing_q & not_1596_s14_q;
  // hls/stages/patches.hpp:125
  logic and_1605;
  assign and_1605 = (not_1593 & (patches_work_q == 3'h0)) & (~(and_1597 | or_1602_s14_q));
  // hls/stages/registration.hpp:218
  logic [13:0] select_1670;
  assign select_1670 = ($signed(10'h0) < $signed(select_1668_s14_q[16:7])) ? 14'h7f : select_1668_s14_q[13:0];
  // hls/stages/patches.hpp:529
  logic equal_1700;
  assign equal_1700 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:500
  logic equal_1702;
  assign equal_1702 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:494
  logic equal_1704;
  assign equal_1704 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1705;
  assign equal_1705 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_1706;
  assign or_1706 = equal_1704 | equal_1705;
  // hls/stages/patches.hpp:455
  logic not_1707;
  assign not_1707 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_1729;
  assign select_1729 = and_1605 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1730;
  assign select_1730 = and_1592_s14_q ? select_1729 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1732;
  assign and_1732 = and_1597 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1736;
  assign select_1736 = and_1592_s14_q ? (and_1605 | (and_1597 & (~and_1732))) : patches_capturing_q;
  // hls/stages/patches.hpp:167
  logic not_1761;
  assign not_1761 = ~equal_1705;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_1775;
  assign select_1775 = and_1592_s14_q ? {select_1729[4], select_1729[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:541
  logic less_1861;
  assign less_1861 = patches_step_q[4:0] < 5'h11;
  logic equal_1862;
  assign equal_1862 = patches_step_q[6:5] == 2'h0;
  logic not_1863;
  assign not_1863 = ~equal_1862;
  logic equal_1864;
  assign equal_1864 = patches_step_q[6:5] == 2'h3;
  logic not_1865;
  assign not_1865 = ~equal_1864;
  // hls/stages/patches.hpp:555
  logic select_1868;
  assign select_1868 = equal_1864 ? (less_1861 & (less_1861 & not_1865)) : less_1861;
  // hls/stages/agreement.hpp:230
  logic [7:0] select_2403;
  assign select_2403 = slot_s14_q[0] ? 8'h0 : sum_918_s14_q;
  // hls/stages/agreement.hpp:739
  logic less_2404;
  assign less_2404 = select_2403 < select_1418;
  // hls/stages/agreement.hpp:776
  logic less_2410;
  assign less_2410 = $signed(run_shift_s14_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2412;
  assign less_2412 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s14_q);
  // hls/stages/agreement.hpp:144
  logic [7:0] select_2507;
  assign select_2507 = or_542_s14_q ? (less_549_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2509;
  assign select_2509 = or_542_s14_q ? (less_549_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:392
  logic or_2822;
  assign or_2822 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_2828;
  assign and_2828 = equal_1700 & not_1707;
  // hls/stages/patches.hpp:398
  logic and_2829;
  assign and_2829 = not_1761 & and_2828;
  logic [1:0] select_2831;
  assign select_2831 = equal_1702 ? 2'h0 : (equal_1704 ? 2'h3 : {equal_1705, and_2829});
  // hls/stages/patches.hpp:279
  logic equal_2833;
  assign equal_2833 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_2834;
  assign not_2834 = ~equal_2833;
  // hls/stages/patches.hpp:279
  logic equal_2835;
  assign equal_2835 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_2836;
  assign not_2836 = ~equal_2835;
  // hls/stages/patches.hpp:283
  logic not_2838;
  assign not_2838 = ~(patches_following_q == 3'h2);
  logic and_2841;
  assign and_2841 = (~(patches_following_q == 3'h1)) & not_2838;
  // hls/stages/patches.hpp:396
  logic [1:0] select_2842;
  assign select_2842 = equal_2835 ? 2'h2 : {and_2841, not_2838};
  logic [3:0] select_2843;
  assign select_2843 = equal_2833 ? 4'h2 : {select_2842, {2{not_2836}}};
  // hls/stages/patches.hpp:404
  logic not_2846;
  assign not_2846 = ~or_2822;
  // hls/stages/patches.hpp:393
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:405
  logic [11:0] select_2851;
  assign select_2851 = or_2822 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_score_q <= 8'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      shift_allowed_q <= 1'b0;
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
      chosen_score_q <= less_2404 ? select_1418 : select_2403;
      chosen_place_q <= less_2404 ? {select_1426, not_1425} : 3'h2;
      before_0_q <= select_2403;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2410) & (~less_2412);
      patches_capturing_q <= sample_pair_whole_s14_q ? select_1736 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s14_q ? select_1730 : patches_row_q;
      patches_work_q <= or_2822 ? following : patches_work_q;
      patches_second_q <= not_1593 & (patches_second_q | (patches_ends_q & equal_1700));
      patches_following_q <= equal_1700 ? {2'h0, and_2828} : {equal_1702, select_2831};
      patches_following_beats_q <= {select_2843, not_2834};
      patches_begins_q <= sample_pair_whole_s14_q & (and_1592_s14_q & and_1732);
      patches_ends_q <= not_2846 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2851;
      patches_step_q <= or_2822 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic shift_not_right_s15_q;
  logic [11:0] registration_slope_s15_q;
  logic [4:0] patches_band_rows_number_s15_q;
  logic patches_chooses_s15_q;
  logic [4:0] patches_choosing_band_s15_q;
  logic patches_second_s15_q;
  logic [4:0] patches_step_s15_q;
  logic [3:0] select_482_s15_q;
  logic equal_483_s15_q;
  logic [6:0] select_485_s15_q;
  logic [8:0] select_489_s15_q;
  logic and_495_s15_q;
  logic equal_501_s15_q;
  logic [6:0] column_s15_q;
  logic and_519_s15_q;
  logic and_521_s15_q;
  logic so_s15_q;
  logic equal_541_s15_q;
  logic or_542_s15_q;
  logic less_549_s15_q;
  logic not_550_s15_q;
  logic equal_582_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_668_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1428_s15_q;
  logic [6:0] of_near_s15_q;
  logic or_1458_s15_q;
  logic and_1461_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic select_1470_s15_q;
  logic or_1476_s15_q;
  logic equal_1479_s15_q;
  logic and_1486_s15_q;
  logic and_1490_s15_q;
  logic and_1493_s15_q;
  logic and_1503_s15_q;
  logic and_1508_s15_q;
  logic [8:0] select_1510_s15_q;
  logic [6:0] select_1518_s15_q;
  logic and_1592_s15_q;
  logic and_1605_s15_q;
  logic less_1619_s15_q;
  logic [13:0] select_1670_s15_q;
  logic equal_1700_s15_q;
  logic equal_1702_s15_q;
  logic equal_1704_s15_q;
  logic equal_1705_s15_q;
  logic or_1706_s15_q;
  logic and_1709_s15_q;
  logic [4:0] select_1730_s15_q;
  logic select_1736_s15_q;
  logic and_1742_s15_q;
  logic and_1762_s15_q;
  logic [3:0] select_1775_s15_q;
  logic less_1861_s15_q;
  logic equal_1862_s15_q;
  logic not_1863_s15_q;
  logic equal_1864_s15_q;
  logic not_1865_s15_q;
  logic select_1868_s15_q;
  logic and_1869_s15_q;
  logic sum_1892_s15_q;
  logic and_2024_s15_q;
  logic equal_2170_s15_q;
  logic equal_2294_s15_q;
  logic [7:0] select_2507_s15_q;
  logic [7:0] select_2509_s15_q;
  logic not_2781_s15_q;
  logic or_2822_s15_q;
  logic not_2846_s15_q;
  logic and_3318_s15_q;
  logic equal_3325_s15_q;
  logic less_3655_s15_q;
  logic equal_3860_s15_q;
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
      shift_not_right_s15_q <= shift_not_right_s14_q;
      registration_slope_s15_q <= registration_slope_s14_q;
      patches_band_rows_number_s15_q <= patches_band_rows_number_s14_q;
      patches_chooses_s15_q <= patches_chooses_s14_q;
      patches_choosing_band_s15_q <= patches_choosing_band_s14_q;
      patches_second_s15_q <= patches_second_q;
      patches_step_s15_q <= patches_step_q[4:0];
      select_482_s15_q <= select_482_s14_q;
      equal_483_s15_q <= equal_483_s14_q;
      select_485_s15_q <= select_485_s14_q;
      select_489_s15_q <= select_489_s14_q;
      and_495_s15_q <= and_495_s14_q;
      equal_501_s15_q <= equal_501_s14_q;
      column_s15_q <= column_s14_q;
      and_519_s15_q <= and_519_s14_q;
      and_521_s15_q <= and_521_s14_q;
      so_s15_q <= so_s14_q;
      equal_541_s15_q <= equal_541_s14_q;
      or_542_s15_q <= or_542_s14_q;
      less_549_s15_q <= less_549_s14_q;
      not_550_s15_q <= not_550_s14_q;
      equal_582_s15_q <= equal_582_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_668_s15_q <= select_668_s14_q;
      of_best_s15_q <= of_best;
      select_1428_s15_q <= select_1428;
      of_near_s15_q <= of_near;
      or_1458_s15_q <= select_668_s14_q | (best_left_rdata_s14_q[39:33] < of_near);
      and_1461_s15_q <= and_1461_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1470_s15_q <= select_1470_s14_q;
      or_1476_s15_q <= select_1470_s14_q | (best_right_rdata_s14_q[21:15] < of_near);
      equal_1479_s15_q <= equal_1479_s14_q;
      and_1486_s15_q <= and_1486_s14_q;
      and_1490_s15_q <= not_550_s14_q & and_1489_s14_q;
      and_1493_s15_q <= and_1493_s14_q;
      and_1503_s15_q <= not_550_s14_q & and_1502;
      and_1508_s15_q <= and_1502 & or_1507_s14_q;
      select_1510_s15_q <= less_549_s14_q ? 9'h0 : best_left_rdata_s14_q[8:0];
      select_1518_s15_q <= select_1518_s14_q;
      and_1592_s15_q <= and_1592_s14_q;
      and_1605_s15_q <= and_1605;
      less_1619_s15_q <= less_1619_s14_q;
      select_1670_s15_q <= select_1670;
      equal_1700_s15_q <= equal_1700;
      equal_1702_s15_q <= equal_1702;
      equal_1704_s15_q <= equal_1704;
      equal_1705_s15_q <= equal_1705;
      or_1706_s15_q <= or_1706;
      and_1709_s15_q <= or_1706 & (equal_1705 & not_1707);
      select_1730_s15_q <= select_1730;
      select_1736_s15_q <= select_1736;
      and_1742_s15_q <= or_1706 & (patches_second_q & equal_1705);
      and_1762_s15_q <= not_1761 & or_1706;
      select_1775_s15_q <= select_1775;
      less_1861_s15_q <= less_1861;
      equal_1862_s15_q <= equal_1862;
      not_1863_s15_q <= not_1863;
      equal_1864_s15_q <= equal_1864;
      not_1865_s15_q <= not_1865;
      select_1868_s15_q <= select_1868;
      and_1869_s15_q <= not_1863 & select_1868;
      sum_1892_s15_q <= sum_1892_s14_q;
      and_2024_s15_q <= and_2024_s14_q;
      equal_2170_s15_q <= equal_2170_s14_q;
      equal_2294_s15_q <= equal_2294_s14_q;
      select_2507_s15_q <= select_2507;
      select_2509_s15_q <= select_2509;
      not_2781_s15_q <= not_2781_s14_q;
      or_2822_s15_q <= or_2822;
      not_2846_s15_q <= not_2846;
      and_3318_s15_q <= less_1861 & (patches_step_q[6:5] == 2'h1);
      equal_3325_s15_q <= patches_step_q[6:5] == 2'h2;
      less_3655_s15_q <= less_3655_s14_q;
      equal_3860_s15_q <= equal_3860_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [15:0] patches_chance_q;
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:798
  logic equal_1431;
  assign equal_1431 = select_1428_s15_q == 3'h1;
  logic or_1434;
  assign or_1434 = equal_1431 | (~(select_1428_s15_q == 3'h2));
  logic [7:0] select_1436;
  assign select_1436 = or_1434 ? before_0_s15_q : before_1_s15_q;
  logic [7:0] select_1437;
  assign select_1437 = equal_1431 ? (or_1434 ? before_1_q : {7'h0, shift_not_right_s15_q}) : select_1436;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_1440;
  assign select_1440 = equal_1431 ? select_1436 : (or_1434 ? before_2_q : before_2_s15_q);
  // hls/stages/agreement.hpp:810
  logic or_1472;
  assign or_1472 = select_1470_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:238
  logic and_1509;
  assign and_1509 = not_550_s15_q & and_1508_s15_q;
  // hls/stages/agreement.hpp:144
  logic [14:0] shift_2;
  assign shift_2 = or_542_s15_q ? {select_1510_s15_q, and_1509, and_1503_s15_q, and_1493_s15_q, and_1490_s15_q, and_1486_s15_q, not_550_s15_q} : 15'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s15_q[6:1]} < x_s15_q;
  // hls/stages/registration.hpp:213
  logic [9:0] select_1671;
  assign select_1671 = shift_2[10] ? select_1670_s15_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1676;
  assign sum_1676 = (shift_2[6] ? select_1670_s15_q[13:1] : 13'h0) + (shift_2[7] ? select_1670_s15_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1677;
  assign select_1677 = shift_2[8] ? select_1670_s15_q[11:0] : 12'h0;
  logic [10:0] sum_1679;
  assign sum_1679 = select_1677[11:1] + (shift_2[9] ? select_1670_s15_q[10:0] : 11'h0);
  // hls/stages/patches.hpp:507
  logic not_1701;
  assign not_1701 = ~equal_1700_s15_q;
  // hls/stages/patches.hpp:453
  logic not_1703;
  assign not_1703 = ~equal_1702_s15_q;
  logic and_1785;
  assign and_1785 = not_1701 & (or_1706_s15_q & not_1703);
  // hls/stages/patches.hpp:184
  logic and_1871;
  assign and_1871 = equal_1700_s15_q & (less_1861_s15_q ? and_1869_s15_q : select_1868_s15_q);
  // hls/stages/agreement.hpp:253
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:144
  logic [7:0] select_2505;
  assign select_2505 = or_542_s15_q ? (less_549_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2507_s15_q} - {1'b0, select_2509_s15_q};
  // hls/stages/patches.hpp:91
  logic parity_2758;
  assign parity_2758 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:451
  logic [15:0] select_2759;
  assign select_2759 = equal_2294_s15_q ? {patches_chance_q[14:0], parity_2758} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s15_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:126
  logic select_2783;
  assign select_2783 = and_1592_s15_q ? (and_1605_s15_q ? not_2781_s15_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:187
  logic [4:0] select_2853;
  assign select_2853 = or_2822_s15_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:552
  logic select_3320;
  assign select_3320 = less_1861_s15_q ? (not_1865_s15_q & and_3318_s15_q) : and_3318_s15_q;
  // hls/stages/patches.hpp:555
  logic select_3321;
  assign select_3321 = equal_1864_s15_q ? select_3320 : and_3318_s15_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:774; read in stage 15, written in stage 28: 15 < 28 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s15_en & (not_1701 & (not_1703 & and_1709_s15_q));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:774; read in stage 15, written in stage 28: 15 < 28 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s15_en & (not_1701 & (not_1703 & and_1742_s15_q));
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:786; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
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
  assign patches_columns_above_re = s15_en & and_1785;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:806; read in stage 15, written in stage 29: 15 < 29 < 15 + DISTANCE.
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
  assign patches_rows_re = s15_en & and_1871;
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
      patches_chance_q <= and_521_s15_q ? select_2759 : patches_chance_q;
      patches_lower_q <= sample_pair_whole_s15_q ? select_2783 : patches_lower_q;
      patches_code_row_q <= select_2853;
      patches_column_q <= or_2822_s15_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2846_s15_q & (patches_column_q == 5'h1e);
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
  logic [3:0] select_482_s16_q;
  logic equal_483_s16_q;
  logic [6:0] select_485_s16_q;
  logic [8:0] select_489_s16_q;
  logic and_495_s16_q;
  logic equal_501_s16_q;
  logic [6:0] column_s16_q;
  logic and_519_s16_q;
  logic and_521_s16_q;
  logic so_s16_q;
  logic equal_582_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1423_s16_q;
  logic [2:0] select_1428_s16_q;
  logic [7:0] select_1437_s16_q;
  logic [7:0] select_1440_s16_q;
  logic [6:0] select_1459_s16_q;
  logic [5:0] select_1460_s16_q;
  logic and_1461_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic or_1472_s16_q;
  logic [6:0] select_1477_s16_q;
  logic [6:0] select_1478_s16_q;
  logic equal_1479_s16_q;
  logic [13:0] shift_2_s16_q;
  logic [6:0] select_1518_s16_q;
  logic and_1521_s16_q;
  logic and_1592_s16_q;
  logic and_1605_s16_q;
  logic right_3_s16_q;
  logic less_1619_s16_q;
  logic select_1671_s16_q;
  logic [8:0] difference_1673_s16_q;
  logic [11:0] sum_1676_s16_q;
  logic select_1677_s16_q;
  logic [10:0] sum_1679_s16_q;
  logic equal_1700_s16_q;
  logic not_1701_s16_q;
  logic equal_1702_s16_q;
  logic not_1703_s16_q;
  logic equal_1704_s16_q;
  logic equal_1705_s16_q;
  logic or_1706_s16_q;
  logic [4:0] select_1730_s16_q;
  logic select_1736_s16_q;
  logic and_1764_s16_q;
  logic [3:0] select_1775_s16_q;
  logic and_1785_s16_q;
  logic less_1861_s16_q;
  logic equal_1862_s16_q;
  logic not_1863_s16_q;
  logic equal_1864_s16_q;
  logic not_1865_s16_q;
  logic sum_1892_s16_q;
  logic textured_s16_q;
  logic and_2024_s16_q;
  logic equal_2170_s16_q;
  logic equal_2294_s16_q;
  logic [7:0] select_2505_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2511_s16_q;
  logic [7:0] xor_2516_s16_q;
  logic less_2540_s16_q;
  logic [5:0] further_s16_q;
  logic or_2822_s16_q;
  logic not_2846_s16_q;
  logic select_3323_s16_q;
  logic equal_3325_s16_q;
  logic less_3655_s16_q;
  logic equal_3860_s16_q;
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
      select_482_s16_q <= select_482_s15_q;
      equal_483_s16_q <= equal_483_s15_q;
      select_485_s16_q <= select_485_s15_q;
      select_489_s16_q <= select_489_s15_q;
      and_495_s16_q <= and_495_s15_q;
      equal_501_s16_q <= equal_501_s15_q;
      column_s16_q <= column_s15_q;
      and_519_s16_q <= and_519_s15_q;
      and_521_s16_q <= and_521_s15_q;
      so_s16_q <= so_s15_q;
      equal_582_s16_q <= equal_582_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1423_s16_q <= select_668_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1428_s16_q <= select_1428_s15_q;
      select_1437_s16_q <= select_1437;
      select_1440_s16_q <= select_1440;
      select_1459_s16_q <= or_1458_s15_q ? of_near_s15_q : best_left_rdata_s15_q[39:33];
      select_1460_s16_q <= or_1458_s15_q ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      and_1461_s16_q <= and_1461_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      or_1472_s16_q <= or_1472;
      select_1477_s16_q <= or_1476_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1478_s16_q <= or_1476_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      equal_1479_s16_q <= equal_1479_s15_q;
      shift_2_s16_q <= {shift_2[14:3], shift_2[1:0]};
      select_1518_s16_q <= select_1518_s15_q;
      and_1521_s16_q <= equal_541_s15_q & shift_2[4];
      and_1592_s16_q <= and_1592_s15_q;
      and_1605_s16_q <= and_1605_s15_q;
      right_3_s16_q <= right_3;
      less_1619_s16_q <= less_1619_s15_q;
      select_1671_s16_q <= select_1671[0];
      difference_1673_s16_q <= select_1671[9:1] - (shift_2[11] ? select_1670_s15_q[8:0] : 9'h0);
      sum_1676_s16_q <= sum_1676[12:1];
      select_1677_s16_q <= select_1677[0];
      sum_1679_s16_q <= sum_1679;
      equal_1700_s16_q <= equal_1700_s15_q;
      not_1701_s16_q <= not_1701;
      equal_1702_s16_q <= equal_1702_s15_q;
      not_1703_s16_q <= not_1703;
      equal_1704_s16_q <= equal_1704_s15_q;
      equal_1705_s16_q <= equal_1705_s15_q;
      or_1706_s16_q <= or_1706_s15_q;
      select_1730_s16_q <= select_1730_s15_q;
      select_1736_s16_q <= select_1736_s15_q;
      and_1764_s16_q <= not_1701 & (not_1703 & and_1762_s15_q);
      select_1775_s16_q <= select_1775_s15_q;
      and_1785_s16_q <= and_1785;
      less_1861_s16_q <= less_1861_s15_q;
      equal_1862_s16_q <= equal_1862_s15_q;
      not_1863_s16_q <= not_1863_s15_q;
      equal_1864_s16_q <= equal_1864_s15_q;
      not_1865_s16_q <= not_1865_s15_q;
      sum_1892_s16_q <= sum_1892_s15_q;
      textured_s16_q <= textured;
      and_2024_s16_q <= and_2024_s15_q;
      equal_2170_s16_q <= equal_2170_s15_q;
      equal_2294_s16_q <= equal_2294_s15_q;
      select_2505_s16_q <= select_2505;
      rise_s16_q <= rise[8];
      select_2511_s16_q <= rise[8] ? select_2507_s15_q : select_2509_s15_q;
      xor_2516_s16_q <= rise[7:0] ^ {8{rise[8]}};
      less_2540_s16_q <= select_2507_s15_q < select_2509_s15_q;
      further_s16_q <= further;
      or_2822_s16_q <= or_2822_s15_q;
      not_2846_s16_q <= not_2846_s15_q;
      select_3323_s16_q <= less_1861_s15_q ? (not_1863_s15_q & select_3321) : select_3321;
      equal_3325_s16_q <= equal_3325_s15_q;
      less_3655_s16_q <= less_3655_s15_q;
      equal_3860_s16_q <= equal_3860_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/agreement.hpp:968
  logic not_1480;
  assign not_1480 = ~equal_1479_s16_q;
  // hls/stages/agreement.hpp:776
  logic and_1512;
  assign and_1512 = ends_cell_s16_q & shift_2_s16_q[0];
  logic and_1514;
  assign and_1514 = not_1480 & (so_s16_q & and_1512);
  // hls/stages/agreement.hpp:968
  logic [5:0] sum_1564;
  assign sum_1564 = {1'b0, last_s16_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:253
  logic right_2;
  assign right_2 = shift_2_s16_q[0] & ({1'b0, sum_1564, last_s16_q[1]} < x_s16_q);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1647;
  assign sum_1647 = {2'h0, x_s16_q} + {{4{shift_2_s16_q[10]}}, shift_2_s16_q[10:5]};
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1680;
  assign sum_1680 = sum_1676_s16_q + {sum_1679_s16_q, select_1677_s16_q};
  logic [9:0] sum_1681;
  assign sum_1681 = {difference_1673_s16_q, select_1671_s16_q} + sum_1680[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2512;
  assign difference_2512 = {1'b0, select_2505_s16_q} - {1'b0, select_2511_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2512[8] ? 8'h0 : difference_2512[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2516_s16_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2764;
  assign select_2764 = right_3_s16_q ? last_s16_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s16_q} + {1'b0, select_2764};

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1314; read in stage 16, written in stage 17: 16 < 17 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s16_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s16_en & and_1514;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:775; read in stage 16, written in stage 27: 16 < 27 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s16_q, patches_code_row_s16_q[3:0], patches_column_s16_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s16_en & and_1764_s16_q;
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s16_en) begin
      patches_read_searches_q <= equal_1700_s16_q ? select_3323_s16_q : patches_read_searches_q;
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
  logic [3:0] select_482_s17_q;
  logic equal_483_s17_q;
  logic [6:0] select_485_s17_q;
  logic [8:0] select_489_s17_q;
  logic and_495_s17_q;
  logic equal_501_s17_q;
  logic [6:0] column_s17_q;
  logic and_519_s17_q;
  logic and_521_s17_q;
  logic so_s17_q;
  logic equal_582_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1424_s17_q;
  logic [2:0] select_1429_s17_q;
  logic [7:0] select_1430_s17_q;
  logic [7:0] select_1438_s17_q;
  logic [7:0] select_1441_s17_q;
  logic [6:0] select_1459_s17_q;
  logic [5:0] select_1460_s17_q;
  logic and_1461_s17_q;
  logic [6:0] right_s17_q;
  logic [7:0] select_1473_s17_q;
  logic [6:0] select_1474_s17_q;
  logic [6:0] select_1477_s17_q;
  logic [6:0] select_1478_s17_q;
  logic equal_1479_s17_q;
  logic not_1480_s17_q;
  logic [13:0] shift_2_s17_q;
  logic and_1514_s17_q;
  logic [6:0] select_1518_s17_q;
  logic and_1523_s17_q;
  logic right_2_s17_q;
  logic and_1592_s17_q;
  logic and_1605_s17_q;
  logic right_3_s17_q;
  logic less_1619_s17_q;
  logic less_1638_s17_q;
  logic not_1643_s17_q;
  logic less_1648_s17_q;
  logic less_1649_s17_q;
  logic [7:0] sum_1681_s17_q;
  logic equal_1693_s17_q;
  logic equal_1700_s17_q;
  logic not_1701_s17_q;
  logic equal_1702_s17_q;
  logic not_1703_s17_q;
  logic equal_1704_s17_q;
  logic equal_1705_s17_q;
  logic or_1706_s17_q;
  logic [7:0] patches_right_0_rdata_s17_q;
  logic [4:0] select_1730_s17_q;
  logic select_1736_s17_q;
  logic [7:0] patches_right_1_rdata_s17_q;
  logic [3:0] select_1775_s17_q;
  logic and_1785_s17_q;
  logic [31:0] patches_columns_above_rdata_s17_q;
  logic less_1861_s17_q;
  logic equal_1862_s17_q;
  logic not_1863_s17_q;
  logic equal_1864_s17_q;
  logic not_1865_s17_q;
  logic [14:0] patches_rows_rdata_s17_q;
  logic sum_1892_s17_q;
  logic textured_s17_q;
  logic and_2027_s17_q;
  logic equal_2170_s17_q;
  logic equal_2294_s17_q;
  logic [7:0] wide_s17_q;
  logic [8:0] size_3_s17_q;
  logic less_2540_s17_q;
  logic not_2767_s17_q;
  logic or_2822_s17_q;
  logic not_2846_s17_q;
  logic equal_3325_s17_q;
  logic less_3655_s17_q;
  logic equal_3860_s17_q;
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
      select_482_s17_q <= select_482_s16_q;
      equal_483_s17_q <= equal_483_s16_q;
      select_485_s17_q <= select_485_s16_q;
      select_489_s17_q <= select_489_s16_q;
      and_495_s17_q <= and_495_s16_q;
      equal_501_s17_q <= equal_501_s16_q;
      column_s17_q <= column_s16_q;
      and_519_s17_q <= and_519_s16_q;
      and_521_s17_q <= and_521_s16_q;
      so_s17_q <= so_s16_q;
      equal_582_s17_q <= equal_582_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1424_s17_q <= or_1423_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1429_s17_q <= or_1423_s16_q ? select_1428_s16_q : best_left_rdata_s16_q[8:6];
      select_1430_s17_q <= or_1423_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1438_s17_q <= or_1423_s16_q ? select_1437_s16_q : best_left_rdata_s16_q[24:17];
      select_1441_s17_q <= or_1423_s16_q ? select_1440_s16_q : best_left_rdata_s16_q[32:25];
      select_1459_s17_q <= select_1459_s16_q;
      select_1460_s17_q <= select_1460_s16_q;
      and_1461_s17_q <= and_1461_s16_q;
      right_s17_q <= right_s16_q;
      select_1473_s17_q <= or_1472_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1474_s17_q <= or_1472_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1477_s17_q <= select_1477_s16_q;
      select_1478_s17_q <= select_1478_s16_q;
      equal_1479_s17_q <= equal_1479_s16_q;
      not_1480_s17_q <= not_1480;
      shift_2_s17_q <= shift_2_s16_q;
      and_1514_s17_q <= and_1514;
      select_1518_s17_q <= select_1518_s16_q;
      and_1523_s17_q <= not_1480 & (so_s16_q ? and_1512 : and_1521_s16_q);
      right_2_s17_q <= right_2;
      and_1592_s17_q <= and_1592_s16_q;
      and_1605_s17_q <= and_1605_s16_q;
      right_3_s17_q <= right_3_s16_q;
      less_1619_s17_q <= less_1619_s16_q;
      less_1638_s17_q <= {3'h0, last_s16_q[6:1]} < ({1'b0, x_s16_q} + 9'h1);
      not_1643_s17_q <= ~(x_s16_q < {1'b0, last_s16_q});
      less_1648_s17_q <= $signed(10'h0) < $signed(sum_1647);
      less_1649_s17_q <= $signed(sum_1647) < $signed({3'h0, last_s16_q});
      sum_1681_s17_q <= sum_1681[9:2];
      equal_1693_s17_q <= x_s16_q == {1'b0, last_s16_q};
      equal_1700_s17_q <= equal_1700_s16_q;
      not_1701_s17_q <= not_1701_s16_q;
      equal_1702_s17_q <= equal_1702_s16_q;
      not_1703_s17_q <= not_1703_s16_q;
      equal_1704_s17_q <= equal_1704_s16_q;
      equal_1705_s17_q <= equal_1705_s16_q;
      or_1706_s17_q <= or_1706_s16_q;
      patches_right_0_rdata_s17_q <= patches_right_0_rdata_q;
      select_1730_s17_q <= select_1730_s16_q;
      select_1736_s17_q <= select_1736_s16_q;
      patches_right_1_rdata_s17_q <= patches_right_1_rdata_q;
      select_1775_s17_q <= select_1775_s16_q;
      and_1785_s17_q <= and_1785_s16_q;
      patches_columns_above_rdata_s17_q <= patches_columns_above_rdata_q;
      less_1861_s17_q <= less_1861_s16_q;
      equal_1862_s17_q <= equal_1862_s16_q;
      not_1863_s17_q <= not_1863_s16_q;
      equal_1864_s17_q <= equal_1864_s16_q;
      not_1865_s17_q <= not_1865_s16_q;
      patches_rows_rdata_s17_q <= patches_rows_rdata_q;
      sum_1892_s17_q <= sum_1892_s16_q;
      textured_s17_q <= textured_s16_q;
      and_2027_s17_q <= and_2024_s16_q & (~({sum_1564, last_s16_q[1:0]} < x_s16_q));
      equal_2170_s17_q <= equal_2170_s16_q;
      equal_2294_s17_q <= equal_2294_s16_q;
      wide_s17_q <= wide;
      size_3_s17_q <= size_3;
      less_2540_s17_q <= less_2540_s16_q;
      not_2767_s17_q <= ~(x_s16_q < {1'b0, from});
      or_2822_s17_q <= or_2822_s16_q;
      not_2846_s17_q <= not_2846_s16_q;
      equal_3325_s17_q <= equal_3325_s16_q;
      less_3655_s17_q <= less_3655_s16_q;
      equal_3860_s17_q <= equal_3860_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:196
  logic not_1519;
  assign not_1519 = ~so_s17_q;
  // hls/stages/agreement.hpp:776
  logic and_1520;
  assign and_1520 = not_1519 & shift_2_s17_q[4];
  logic and_1617;
  assign and_1617 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & right_3_s17_q));
  // hls/stages/patches.hpp:104
  logic and_1640;
  assign and_1640 = less_1638_s17_q & (~right_3_s17_q);
  // hls/stages/patches.hpp:106
  logic equal_1641;
  assign equal_1641 = x_s17_q == 8'h0;
  // hls/stages/agreement.hpp:977
  logic and_1651;
  assign and_1651 = (~(and_1640 | (equal_1641 | not_1643_s17_q))) & (less_1648_s17_q & less_1649_s17_q);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1682;
  assign sum_1682 = {registration_slope_s17_q[11], registration_slope_s17_q} + {{5{sum_1681_s17_q[7]}}, sum_1681_s17_q};
  // hls/stages/agreement.hpp:776
  logic and_1696;
  assign and_1696 = ends_cell_s17_q & (shift_2_s17_q[0] & (and_1640 | equal_1693_s17_q));
  logic and_1698;
  assign and_1698 = not_1480_s17_q & (so_s17_q & and_1696);
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1705_s17_q ? (patches_second_s17_q ? 8'h0 : patches_right_0_rdata_s17_q) : 8'h0;
  // hls/stages/patches.hpp:462
  logic [8:0] sum_1823;
  assign sum_1823 = {1'b0, patches_columns_above_rdata_s17_q[23:16]} + {3'h0, patches_columns_above_rdata_s17_q[31:26]};
  // hls/stages/agreement.hpp:1013
  logic or_1894;
  assign or_1894 = (~sum_1892_s17_q) | equal_1693_s17_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2519;
  assign select_2519 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2519;
  // hls/stages/agreement.hpp:776
  logic and_2770;
  assign and_2770 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & not_2767_s17_q));
  // hls/stages/patches.hpp:551
  logic [9:0] select_3288;
  assign select_3288 = less_1861_s17_q ? patches_rows_rdata_s17_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3290;
  assign select_3290 = less_1861_s17_q ? (equal_1864_s17_q ? 10'h0 : select_3288) : 10'h0;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3295;
  assign select_3295 = less_1861_s17_q ? patches_rows_rdata_s17_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3298;
  assign select_3298 = equal_1864_s17_q ? (less_1861_s17_q ? (equal_1864_s17_q ? 5'h0 : select_3295) : 5'h0) : select_3295;

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1341; read in stage 17, written in stage 19: 17 < 19 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s17_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s17_en & and_1514_s17_q;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1461_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1460_s17_q, select_1459_s17_q, select_1441_s17_q, select_1438_s17_q, select_1430_s17_q, select_1429_s17_q, select_1424_s17_q};
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
  assign best_right_we = s17_en & and_1461_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1478_s17_q, select_1477_s17_q, select_1474_s17_q, select_1473_s17_q};
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
  assign shown_right_waddr = select_1518_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1523_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1520, not_1519};
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
  logic [3:0] select_482_s18_q;
  logic equal_483_s18_q;
  logic [6:0] select_485_s18_q;
  logic [8:0] select_489_s18_q;
  logic and_495_s18_q;
  logic equal_501_s18_q;
  logic [6:0] column_s18_q;
  logic and_519_s18_q;
  logic and_521_s18_q;
  logic so_s18_q;
  logic equal_582_s18_q;
  logic equal_1479_s18_q;
  logic not_1480_s18_q;
  logic [13:0] shift_2_s18_q;
  logic and_1514_s18_q;
  logic [1:0] shown_right_rdata_s18_q;
  logic not_1519_s18_q;
  logic right_2_s18_q;
  logic and_1592_s18_q;
  logic and_1605_s18_q;
  logic and_1618_s18_q;
  logic less_1619_s18_q;
  logic equal_1641_s18_q;
  logic and_1651_s18_q;
  logic [7:0] sum_1682_s18_q;
  logic less_1683_s18_q;
  logic less_1684_s18_q;
  logic and_1698_s18_q;
  logic and_1699_s18_q;
  logic equal_1700_s18_q;
  logic not_1701_s18_q;
  logic equal_1702_s18_q;
  logic not_1703_s18_q;
  logic equal_1704_s18_q;
  logic equal_1705_s18_q;
  logic or_1706_s18_q;
  logic [4:0] select_1730_s18_q;
  logic select_1736_s18_q;
  logic [7:0] patches_left_rdata_s18_q;
  logic [3:0] select_1775_s18_q;
  logic and_1785_s18_q;
  logic [31:0] patches_columns_above_rdata_s18_q;
  logic [7:0] select_1789_s18_q;
  logic [8:0] sum_1823_s18_q;
  logic less_1861_s18_q;
  logic equal_1862_s18_q;
  logic not_1863_s18_q;
  logic equal_1864_s18_q;
  logic not_1865_s18_q;
  logic [9:0] patches_rows_rdata_s18_q;
  logic sum_1892_s18_q;
  logic and_1897_s18_q;
  logic textured_s18_q;
  logic and_2030_s18_q;
  logic equal_2170_s18_q;
  logic equal_2294_s18_q;
  logic less_2503_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2521_s18_q;
  logic less_2540_s18_q;
  logic and_2771_s18_q;
  logic or_2822_s18_q;
  logic not_2846_s18_q;
  logic [9:0] select_3291_s18_q;
  logic [4:0] select_3298_s18_q;
  logic equal_3325_s18_q;
  logic less_3655_s18_q;
  logic select_3698_s18_q;
  logic equal_3860_s18_q;
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
      select_482_s18_q <= select_482_s17_q;
      equal_483_s18_q <= equal_483_s17_q;
      select_485_s18_q <= select_485_s17_q;
      select_489_s18_q <= select_489_s17_q;
      and_495_s18_q <= and_495_s17_q;
      equal_501_s18_q <= equal_501_s17_q;
      column_s18_q <= column_s17_q;
      and_519_s18_q <= and_519_s17_q;
      and_521_s18_q <= and_521_s17_q;
      so_s18_q <= so_s17_q;
      equal_582_s18_q <= equal_582_s17_q;
      equal_1479_s18_q <= equal_1479_s17_q;
      not_1480_s18_q <= not_1480_s17_q;
      shift_2_s18_q <= shift_2_s17_q;
      and_1514_s18_q <= and_1514_s17_q;
      shown_right_rdata_s18_q <= shown_right_rdata_q;
      not_1519_s18_q <= not_1519;
      right_2_s18_q <= right_2_s17_q;
      and_1592_s18_q <= and_1592_s17_q;
      and_1605_s18_q <= and_1605_s17_q;
      and_1618_s18_q <= not_1480_s17_q & and_1617;
      less_1619_s18_q <= less_1619_s17_q;
      equal_1641_s18_q <= equal_1641;
      and_1651_s18_q <= and_1651;
      sum_1682_s18_q <= sum_1682[7:0];
      less_1683_s18_q <= $signed(6'h0) < $signed(sum_1682[12:7]);
      less_1684_s18_q <= $signed(sum_1682[12:7]) < $signed(6'h3f);
      and_1698_s18_q <= and_1698;
      and_1699_s18_q <= patches_chooses_s17_q & and_1698;
      equal_1700_s18_q <= equal_1700_s17_q;
      not_1701_s18_q <= not_1701_s17_q;
      equal_1702_s18_q <= equal_1702_s17_q;
      not_1703_s18_q <= not_1703_s17_q;
      equal_1704_s18_q <= equal_1704_s17_q;
      equal_1705_s18_q <= equal_1705_s17_q;
      or_1706_s18_q <= or_1706_s17_q;
      select_1730_s18_q <= select_1730_s17_q;
      select_1736_s18_q <= select_1736_s17_q;
      patches_left_rdata_s18_q <= patches_left_rdata_q;
      select_1775_s18_q <= select_1775_s17_q;
      and_1785_s18_q <= and_1785_s17_q;
      patches_columns_above_rdata_s18_q <= patches_columns_above_rdata_s17_q;
      select_1789_s18_q <= patches_second_s17_q ? patches_right_1_rdata_s17_q : pixel;
      sum_1823_s18_q <= sum_1823;
      less_1861_s18_q <= less_1861_s17_q;
      equal_1862_s18_q <= equal_1862_s17_q;
      not_1863_s18_q <= not_1863_s17_q;
      equal_1864_s18_q <= equal_1864_s17_q;
      not_1865_s18_q <= not_1865_s17_q;
      patches_rows_rdata_s18_q <= patches_rows_rdata_s17_q[9:0];
      sum_1892_s18_q <= sum_1892_s17_q;
      and_1897_s18_q <= so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & or_1894));
      textured_s18_q <= textured_s17_q;
      and_2030_s18_q <= not_1480_s17_q & (so_s17_q & (ends_cell_s17_q & and_2027_s17_q));
      equal_2170_s18_q <= equal_2170_s17_q;
      equal_2294_s18_q <= equal_2294_s17_q;
      less_2503_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2521_s18_q <= ~wide_s17_q;
      less_2540_s18_q <= less_2540_s17_q;
      and_2771_s18_q <= not_1480_s17_q & and_2770;
      or_2822_s18_q <= or_2822_s17_q;
      not_2846_s18_q <= not_2846_s17_q;
      select_3291_s18_q <= equal_1864_s17_q ? select_3290 : select_3288;
      select_3298_s18_q <= select_3298;
      equal_3325_s18_q <= equal_3325_s17_q;
      less_3655_s18_q <= less_3655_s17_q;
      select_3698_s18_q <= sum_1892_s17_q ? (equal_1693_s17_q & or_1894) : or_1894;
      equal_3860_s18_q <= equal_3860_s17_q;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [7:0] registration_slope_here_q;
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic segment_starts_q;
  // hls/stages/census.hpp:119
  logic and_496;
  assign and_496 = sample_pair_whole_s18_q & and_495_s18_q;
  // hls/stages/registration.hpp:83
  logic equal_1620;
  assign equal_1620 = slot_s18_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1621;
  assign select_1621 = shift_2_s18_q[5] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1622;
  assign select_1622 = shift_2_s18_q[6] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1623;
  assign sum_1623 = {{2{select_1621[6]}}, select_1621} + {select_1622[7], select_1622};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1624;
  assign select_1624 = shift_2_s18_q[7] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1625;
  assign select_1625 = shift_2_s18_q[8] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1626;
  assign sum_1626 = {{2{select_1624[7]}}, select_1624[7:1]} + {select_1625[7], select_1625};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1628;
  assign select_1628 = shift_2_s18_q[9] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1629;
  assign select_1629 = shift_2_s18_q[10] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1630;
  assign difference_1630 = {{2{select_1628[7]}}, select_1628[7:1]} - {select_1629[7], select_1629};
  // hls/stages/agreement.hpp:776
  logic [5:0] select_1664;
  assign select_1664 = ends_cell_s18_q ? (shift_2_s18_q[0] ? shift_2_s18_q[10:5] : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1686;
  assign select_1686 = less_1683_s18_q ? 8'h7f : (less_1684_s18_q ? 8'h80 : sum_1682_s18_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1620 ? registration_slope_here_q : select_1686;
  // hls/stages/agreement.hpp:776
  logic [7:0] select_1690;
  assign select_1690 = so_s18_q ? (ends_cell_s18_q ? (shift_2_s18_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:172
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1705_s18_q ? select_1789_s18_q : patches_left_rdata_s18_q;
  // hls/stages/patches.hpp:462
  logic [9:0] sum_1824;
  assign sum_1824 = {2'h0, patches_columns_above_rdata_s18_q[15:8]} + {1'b0, sum_1823_s18_q};
  // hls/stages/agreement.hpp:253
  logic and_1911;
  assign and_1911 = shift_2_s18_q[0] & ({shift_2_s18_q[4], shift_2_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:973
  logic select_1919;
  assign select_1919 = slot_s18_q[2] ? shown_shown_q : shift_2_s18_q[3];
  // hls/stages/agreement.hpp:253
  logic shown;
  assign shown = shift_2_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1919);
  // hls/stages/agreement.hpp:973
  logic select_1922;
  assign select_1922 = slot_s18_q[2] ? shown_nearer_q : shift_2_s18_q[4];
  // hls/stages/agreement.hpp:253
  logic near;
  assign near = shift_2_s18_q[0] & (select_1919 ? select_1922 : shown_right_rdata_s18_q[1]);
  // hls/stages/registration.hpp:37
  logic not_2514;
  assign not_2514 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2503_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2514};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2522;
  assign select_2522 = registration_displacement_over_q[9] ? wide_s18_q : not_2521_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2503_s18_q ? {taken_s18_q, 1'b1} : {not_2514, select_2522, not_2514};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2524;
  assign sum_2524 = {left, 1'b1} + {taken_2, less_2503_s18_q};
  // hls/stages/agreement.hpp:248
  logic [4:0] select_2526;
  assign select_2526 = so_s18_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:776
  logic [7:0] select_2528;
  assign select_2528 = equal_1479_s18_q ? registration_slope_here_q : (so_s18_q ? slope : registration_slope_here_q);
  // hls/stages/patches.hpp:555
  logic [9:0] select_3293;
  assign select_3293 = less_1861_s18_q ? (equal_1862_s18_q ? 10'h0 : select_3291_s18_q) : select_3291_s18_q;
  logic [4:0] select_3300;
  assign select_3300 = less_1861_s18_q ? (equal_1862_s18_q ? 5'h0 : select_3298_s18_q) : select_3298_s18_q;
  // hls/stages/patches.hpp:551
  logic and_3310;
  assign and_3310 = less_1861_s18_q & (patches_step_s18_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3313;
  assign select_3313 = equal_1864_s18_q ? (less_1861_s18_q ? (not_1865_s18_q & and_3310) : and_3310) : and_3310;
  // hls/stages/agreement.hpp:776
  logic select_3652;
  assign select_3652 = equal_1479_s18_q ? shown_shown_q : (so_s18_q ? select_1919 : shown_shown_q);
  logic select_3654;
  assign select_3654 = equal_1479_s18_q ? shown_nearer_q : (so_s18_q ? select_1922 : shown_nearer_q);
  // hls/stages/agreement.hpp:200
  logic or_3696;
  assign or_3696 = segment_starts_q | not_1519_s18_q;
  // hls/stages/agreement.hpp:776
  logic select_3700;
  assign select_3700 = ends_cell_s18_q ? (shift_2_s18_q[0] ? select_3698_s18_q : or_3696) : or_3696;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 18, written in stage 21: 18 < 21 < 18 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_489_s18_q;
  logic averager_memory_re;
  assign averager_memory_re = s18_en & and_496;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      segment_starts_q <= 1'b1;
    end else if (s18_en) begin
      registration_displacement_over_q <= so_s18_q ? sum_2524[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2526;
      registration_slope_here_q <= select_2528;
      patches_read_row_differing_q <= equal_1700_s18_q ? select_3293 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1700_s18_q ? select_3300 : patches_read_row_column_q;
      shown_shown_q <= select_3652;
      shown_nearer_q <= select_3654;
      segment_starts_q <= equal_1479_s18_q ? or_3696 : (so_s18_q ? select_3700 : or_3696);
    end
  end

  logic [7:0] pixel_0_s19_q;
  logic [7:0] pixel_1_s19_q;
  logic saturated_s19_q;
  logic mask_s19_q;
  logic marks_first_s19_q;
  logic marks_last_s19_q;
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
  logic [3:0] select_482_s19_q;
  logic equal_483_s19_q;
  logic [6:0] select_485_s19_q;
  logic [8:0] select_489_s19_q;
  logic and_495_s19_q;
  logic and_496_s19_q;
  logic equal_501_s19_q;
  logic [6:0] column_s19_q;
  logic and_519_s19_q;
  logic and_521_s19_q;
  logic so_s19_q;
  logic equal_582_s19_q;
  logic equal_1479_s19_q;
  logic not_1480_s19_q;
  logic [4:0] shift_2_s19_q;
  logic and_1514_s19_q;
  logic right_2_s19_q;
  logic and_1592_s19_q;
  logic and_1605_s19_q;
  logic and_1618_s19_q;
  logic less_1619_s19_q;
  logic equal_1620_s19_q;
  logic [7:0] sum_1623_s19_q;
  logic select_1624_s19_q;
  logic [8:0] sum_1626_s19_q;
  logic select_1628_s19_q;
  logic [8:0] difference_1630_s19_q;
  logic equal_1641_s19_q;
  logic and_1651_s19_q;
  logic [5:0] select_1666_s19_q;
  logic [7:0] select_1691_s19_q;
  logic and_1698_s19_q;
  logic and_1699_s19_q;
  logic equal_1700_s19_q;
  logic not_1701_s19_q;
  logic equal_1702_s19_q;
  logic not_1703_s19_q;
  logic equal_1704_s19_q;
  logic equal_1705_s19_q;
  logic or_1706_s19_q;
  logic [4:0] select_1730_s19_q;
  logic select_1736_s19_q;
  logic [3:0] select_1775_s19_q;
  logic and_1785_s19_q;
  logic [31:0] patches_columns_above_rdata_s19_q;
  logic [7:0] pixel_2_s19_q;
  logic [9:0] sum_1824_s19_q;
  logic less_1861_s19_q;
  logic equal_1862_s19_q;
  logic not_1863_s19_q;
  logic equal_1864_s19_q;
  logic not_1865_s19_q;
  logic [9:0] patches_rows_rdata_s19_q;
  logic sum_1892_s19_q;
  logic and_1897_s19_q;
  logic textured_s19_q;
  logic and_1911_s19_q;
  logic [17:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_2030_s19_q;
  logic equal_2170_s19_q;
  logic equal_2294_s19_q;
  logic or_2538_s19_q;
  logic [1:0] sum_2539_s19_q;
  logic less_2540_s19_q;
  logic and_2771_s19_q;
  logic or_2822_s19_q;
  logic not_2846_s19_q;
  logic select_3313_s19_q;
  logic equal_3325_s19_q;
  logic less_3655_s19_q;
  logic equal_3860_s19_q;
  always_ff @(posedge clk_i) begin
    if (s18_en) begin
      pixel_0_s19_q <= pixel_0_s18_q;
      pixel_1_s19_q <= pixel_1_s18_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      marks_last_s19_q <= marks_last_s18_q;
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
      select_482_s19_q <= select_482_s18_q;
      equal_483_s19_q <= equal_483_s18_q;
      select_485_s19_q <= select_485_s18_q;
      select_489_s19_q <= select_489_s18_q;
      and_495_s19_q <= and_495_s18_q;
      and_496_s19_q <= and_496;
      equal_501_s19_q <= equal_501_s18_q;
      column_s19_q <= column_s18_q;
      and_519_s19_q <= and_519_s18_q;
      and_521_s19_q <= and_521_s18_q;
      so_s19_q <= so_s18_q;
      equal_582_s19_q <= equal_582_s18_q;
      equal_1479_s19_q <= equal_1479_s18_q;
      not_1480_s19_q <= not_1480_s18_q;
      shift_2_s19_q <= {shift_2_s18_q[11], shift_2_s18_q[3:0]};
      and_1514_s19_q <= and_1514_s18_q;
      right_2_s19_q <= right_2_s18_q;
      and_1592_s19_q <= and_1592_s18_q;
      and_1605_s19_q <= and_1605_s18_q;
      and_1618_s19_q <= and_1618_s18_q;
      less_1619_s19_q <= less_1619_s18_q;
      equal_1620_s19_q <= equal_1620;
      sum_1623_s19_q <= sum_1623[8:1];
      select_1624_s19_q <= select_1624[0];
      sum_1626_s19_q <= sum_1626;
      select_1628_s19_q <= select_1628[0];
      difference_1630_s19_q <= difference_1630;
      equal_1641_s19_q <= equal_1641_s18_q;
      and_1651_s19_q <= and_1651_s18_q;
      select_1666_s19_q <= equal_1479_s18_q ? 6'h0 : (so_s18_q ? select_1664 : 6'h0);
      select_1691_s19_q <= equal_1479_s18_q ? 8'h0 : select_1690;
      and_1698_s19_q <= and_1698_s18_q;
      and_1699_s19_q <= and_1699_s18_q;
      equal_1700_s19_q <= equal_1700_s18_q;
      not_1701_s19_q <= not_1701_s18_q;
      equal_1702_s19_q <= equal_1702_s18_q;
      not_1703_s19_q <= not_1703_s18_q;
      equal_1704_s19_q <= equal_1704_s18_q;
      equal_1705_s19_q <= equal_1705_s18_q;
      or_1706_s19_q <= or_1706_s18_q;
      select_1730_s19_q <= select_1730_s18_q;
      select_1736_s19_q <= select_1736_s18_q;
      select_1775_s19_q <= select_1775_s18_q;
      and_1785_s19_q <= and_1785_s18_q;
      patches_columns_above_rdata_s19_q <= patches_columns_above_rdata_s18_q;
      pixel_2_s19_q <= pixel_2;
      sum_1824_s19_q <= sum_1824;
      less_1861_s19_q <= less_1861_s18_q;
      equal_1862_s19_q <= equal_1862_s18_q;
      not_1863_s19_q <= not_1863_s18_q;
      equal_1864_s19_q <= equal_1864_s18_q;
      not_1865_s19_q <= not_1865_s18_q;
      patches_rows_rdata_s19_q <= patches_rows_rdata_s18_q;
      sum_1892_s19_q <= sum_1892_s18_q;
      and_1897_s19_q <= and_1897_s18_q;
      textured_s19_q <= textured_s18_q;
      and_1911_s19_q <= and_1911;
      seen_columns_rdata_s19_q <= seen_columns_rdata_q;
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_2030_s19_q <= and_2030_s18_q;
      equal_2170_s19_q <= equal_2170_s18_q;
      equal_2294_s19_q <= equal_2294_s18_q;
      or_2538_s19_q <= (shift_2_s18_q[13:11] == 3'h0) | (shift_2_s18_q[13:11] == 3'h4);
      sum_2539_s19_q <= shift_2_s18_q[13:12] + 2'h3;
      less_2540_s19_q <= less_2540_s18_q;
      and_2771_s19_q <= and_2771_s18_q;
      or_2822_s19_q <= or_2822_s18_q;
      not_2846_s19_q <= not_2846_s18_q;
      select_3313_s19_q <= select_3313;
      equal_3325_s19_q <= equal_3325_s18_q;
      less_3655_s19_q <= less_3655_s18_q;
      equal_3860_s19_q <= equal_3860_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic patches_summed_last_q;
  logic patches_read_first_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_down_rest_q;
  logic [7:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic segment_started_q;
  // hls/stages/census.hpp:112
  logic [13:0] select_499;
  assign select_499 = equal_483_s19_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_505;
  assign sum_505 = {6'h0, sample_pair_pixel_1_q} + (equal_483_s19_q ? 14'h0 : averager_running_1_q);
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s19_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:210
  logic equal_1538;
  assign equal_1538 = x_s19_q[5:0] == 6'h3c;
  logic equal_1540;
  assign equal_1540 = x_s19_q[5:0] == 6'h3b;
  logic equal_1542;
  assign equal_1542 = x_s19_q[5:0] == 6'h36;
  logic equal_1544;
  assign equal_1544 = x_s19_q[5:0] == 6'h35;
  logic equal_1546;
  assign equal_1546 = x_s19_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1129
  logic and_1550;
  assign and_1550 = (~equal_1540) & ((~equal_1542) & ((~equal_1544) & (~equal_1546)));
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1627;
  assign sum_1627 = {{3{sum_1623_s19_q[7]}}, sum_1623_s19_q} + {sum_1626_s19_q[8], sum_1626_s19_q, select_1624_s19_q};
  logic [9:0] sum_1631;
  assign sum_1631 = {difference_1630_s19_q, select_1628_s19_q} + {sum_1627[10], sum_1627[10:2]};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_1813;
  assign sum_1813 = {1'b0, patches_columns_above_rdata_s19_q[7:0]} + {2'h0, pixel_2_s19_q[7:1]};
  logic [8:0] sum_1814;
  assign sum_1814 = {1'b0, patches_columns_above_rdata_s19_q[23:16]} + {2'h0, patches_columns_above_rdata_s19_q[31:25]};
  // hls/stages/patches.hpp:462
  logic [10:0] sum_1825;
  assign sum_1825 = {3'h0, patches_columns_above_rdata_s19_q[15:8]} + {sum_1824_s19_q, patches_columns_above_rdata_s19_q[25]};
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1879;
  assign select_1879 = so_s19_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1005
  logic or_1882;
  assign or_1882 = select_1879[7] | (~({select_1879[5], select_1879[3], select_1879[1]} == 3'h0));
  // hls/stages/agreement.hpp:253
  logic explained;
  assign explained = shift_2_s19_q[0] & shift_2_s19_q[3];
  logic and_1918;
  assign and_1918 = shift_2_s19_q[0] & shift_2_s19_q[2];
  // hls/stages/agreement.hpp:989
  logic and_1959;
  assign and_1959 = seen_columns_rdata_s19_q[5] & shift_2_s19_q[0];
  logic and_1960;
  assign and_1960 = seen_columns_rdata_s19_q[0] & shift_2_s19_q[0];
  logic [7:0] select_1971;
  assign select_1971 = shift_2_s19_q[0] ? (sum_1892_s19_q ? select_1879 : {select_1879[6:0], 1'b0}) : select_1879;
  // hls/stages/agreement.hpp:1005
  logic or_1974;
  assign or_1974 = select_1971[7] | (~({select_1971[5], select_1971[3], select_1971[1]} == 3'h0));
  // hls/stages/agreement.hpp:989
  logic and_1993;
  assign and_1993 = seen_columns_rdata_s19_q[8] & shift_2_s19_q[0];
  logic and_1994;
  assign and_1994 = seen_columns_rdata_s19_q[3] & shift_2_s19_q[0];
  logic and_2009;
  assign and_2009 = seen_columns_rdata_s19_q[9] & shift_2_s19_q[0];
  logic and_2010;
  assign and_2010 = seen_columns_rdata_s19_q[4] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:776
  logic and_2422;
  assign and_2422 = so_s19_q & (ends_cell_s19_q & (shift_2_s19_q[0] & shift_2_s19_q[1]));
  // hls/stages/agreement.hpp:989
  logic and_2445;
  assign and_2445 = seen_columns_rdata_s19_q[7] & shift_2_s19_q[0];
  logic and_2446;
  assign and_2446 = seen_columns_rdata_s19_q[2] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:776
  logic and_2483;
  assign and_2483 = ends_cell_s19_q & (shift_2_s19_q[0] & (shift_2_s19_q[2:1] == 2'h3));
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2541;
  assign difference_2541 = {sum_2539_s19_q, shift_2_s19_q[4], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2542;
  assign select_2542 = less_2540_s19_q ? difference_2541 : {sum_2539_s19_q, shift_2_s19_q[4], registration_displacement_fraction_q};
  logic [7:0] select_2543;
  assign select_2543 = or_2538_s19_q ? {sum_2539_s19_q, shift_2_s19_q[4], 5'h0} : select_2542;
  // hls/stages/patches.hpp:187
  logic select_2861;
  assign select_2861 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:175
  logic and_2922;
  assign and_2922 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_2927;
  assign select_2927 = or_2822_s19_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_2929;
  assign select_2929 = and_2922 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:551
  logic [4:0] select_3302;
  assign select_3302 = less_1861_s19_q ? patches_step_s19_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3305;
  assign select_3305 = equal_1864_s19_q ? (less_1861_s19_q ? (equal_1864_s19_q ? 5'h0 : select_3302) : 5'h0) : select_3302;
  logic [4:0] select_3307;
  assign select_3307 = less_1861_s19_q ? (equal_1862_s19_q ? 5'h0 : select_3305) : select_3305;
  logic select_3315;
  assign select_3315 = less_1861_s19_q ? (not_1863_s19_q & select_3313_s19_q) : select_3313_s19_q;
  // hls/stages/patches.hpp:178
  logic or_3327;
  assign or_3327 = patches_read_first_q | (patches_read_row_differing_s19_q < patches_peak_best_differing_q);
  logic and_3328;
  assign and_3328 = patches_read_searches_s19_q & or_3327;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3360;
  assign select_3360 = and_3328 ? {patches_read_row_column_s19_q, patches_read_row_differing_s19_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3361;
  assign select_3361 = equal_1700_s19_q ? select_3360[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3362;
  assign select_3362 = equal_1700_s19_q ? select_3360[14:10] : patches_peak_best_column_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3656;
  assign sum_3656 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:776
  logic [7:0] select_3665;
  assign select_3665 = equal_1479_s19_q ? select_1879 : (so_s19_q ? (ends_cell_s19_q ? select_1971 : select_1879) : 8'h1);
  // hls/stages/agreement.hpp:451
  logic [8:0] select_3679;
  assign select_3679 = equal_582_s19_q ? {difference_3677[7], difference_3677} : (less_3655_s19_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:511
  logic [8:0] select_3681;
  assign select_3681 = and_521_s19_q ? (equal_2294_s19_q ? select_3679 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:451
  logic [7:0] select_3683;
  assign select_3683 = equal_582_s19_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:511
  logic [7:0] select_3685;
  assign select_3685 = and_521_s19_q ? (equal_2294_s19_q ? select_3683 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3687;
  assign select_3687 = sum_3656[7] ? {1'b1, sum_3656[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s19_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s19_en & and_1785_s19_q;
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
  assign seen_columns_we = s19_en & and_1514_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q[13:7], seen_columns_rdata_s19_q[5:0], near_s19_q, shown_s19_q, explained, and_1918, textured_s19_q};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s18_sim;
  logic seen_columns_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s18_sim <= seen_columns_re;
      seen_columns_raddr_s18_sim <= seen_columns_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
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
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      patches_along_ends_q <= 1'b0;
      patches_match_row_ends_q <= 1'b0;
      patches_down_by_q <= 5'h0;
      patches_along_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_last_q <= 1'b0;
      patches_read_first_q <= 1'b0;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 8'h0;
      region_down_next_q <= 9'h0;
      segment_started_q <= 1'b0;
    end else if (s19_en) begin
      sample_pair_pixel_0_q <= pixel_0_s19_q;
      sample_pair_pixel_1_q <= pixel_1_s19_q;
      patches_along_ends_q <= not_2846_s19_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2846_s19_q & select_2861;
      patches_down_by_q <= or_2822_s19_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2922});
      patches_along_q <= select_2927;
      patches_match_row_q <= or_2822_s19_q ? 4'h0 : select_2929;
      patches_summed_last_q <= not_1701_s19_q & (equal_1702_s19_q & and_2922);
      patches_read_first_q <= equal_1700_s19_q ? select_3315 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3361;
      patches_peak_best_column_q <= select_3362;
      region_columns_q <= select_3665;
      region_down_rest_q <= select_3681;
      region_down_back_q <= select_3685;
      region_down_next_q <= select_3687;
      segment_started_q <= ~segment_starts_q;
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
    if (s19_en) begin
      averager_running_0_q <= sample_pair_whole_s19_q ? select_499 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s19_q ? sum_505 : averager_running_1_q;
    end
  end

  logic saturated_s20_q;
  logic mask_s20_q;
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
  logic segment_started_s20_q;
  logic [3:0] select_482_s20_q;
  logic equal_483_s20_q;
  logic [6:0] select_485_s20_q;
  logic [8:0] select_489_s20_q;
  logic and_495_s20_q;
  logic and_496_s20_q;
  logic [29:0] averager_memory_rdata_s20_q;
  logic [13:0] select_499_s20_q;
  logic equal_501_s20_q;
  logic [13:0] sum_505_s20_q;
  logic [6:0] column_s20_q;
  logic and_519_s20_q;
  logic and_521_s20_q;
  logic so_s20_q;
  logic equal_582_s20_q;
  logic equal_1479_s20_q;
  logic not_1480_s20_q;
  logic [1:0] shift_2_s20_q;
  logic equal_1524_s20_q;
  logic all_s20_q;
  logic equal_1538_s20_q;
  logic equal_1540_s20_q;
  logic equal_1542_s20_q;
  logic equal_1544_s20_q;
  logic equal_1546_s20_q;
  logic and_1551_s20_q;
  logic right_2_s20_q;
  logic and_1592_s20_q;
  logic and_1605_s20_q;
  logic and_1618_s20_q;
  logic less_1619_s20_q;
  logic equal_1620_s20_q;
  logic sum_1627_s20_q;
  logic [9:0] sum_1631_s20_q;
  logic equal_1641_s20_q;
  logic and_1651_s20_q;
  logic [5:0] select_1666_s20_q;
  logic [7:0] select_1691_s20_q;
  logic and_1698_s20_q;
  logic and_1699_s20_q;
  logic equal_1700_s20_q;
  logic not_1701_s20_q;
  logic equal_1702_s20_q;
  logic not_1703_s20_q;
  logic equal_1704_s20_q;
  logic equal_1705_s20_q;
  logic or_1706_s20_q;
  logic [4:0] select_1730_s20_q;
  logic select_1736_s20_q;
  logic [3:0] select_1775_s20_q;
  logic [8:0] patches_columns_above_rdata_s20_q;
  logic [7:0] pixel_2_s20_q;
  logic [4:0] sum_1799_s20_q;
  logic [8:0] sum_1813_s20_q;
  logic [8:0] sum_1814_s20_q;
  logic [10:0] sum_1825_s20_q;
  logic less_1861_s20_q;
  logic equal_1862_s20_q;
  logic not_1863_s20_q;
  logic equal_1864_s20_q;
  logic not_1865_s20_q;
  logic [9:0] patches_rows_rdata_s20_q;
  logic or_1882_s20_q;
  logic or_1885_s20_q;
  logic or_1888_s20_q;
  logic and_1897_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1911_s20_q;
  logic and_1957_s20_q;
  logic and_1958_s20_q;
  logic and_1959_s20_q;
  logic [1:0] sum_1962_s20_q;
  logic or_1974_s20_q;
  logic or_1977_s20_q;
  logic or_1980_s20_q;
  logic and_1991_s20_q;
  logic and_1992_s20_q;
  logic [1:0] sum_1996_s20_q;
  logic and_2007_s20_q;
  logic and_2008_s20_q;
  logic [1:0] sum_2012_s20_q;
  logic and_2030_s20_q;
  logic equal_2170_s20_q;
  logic equal_2294_s20_q;
  logic and_2423_s20_q;
  logic and_2443_s20_q;
  logic and_2444_s20_q;
  logic [1:0] sum_2448_s20_q;
  logic and_2485_s20_q;
  logic [7:0] select_2543_s20_q;
  logic and_2771_s20_q;
  logic [4:0] select_3307_s20_q;
  logic equal_3325_s20_q;
  logic and_3328_s20_q;
  logic [14:0] select_3360_s20_q;
  logic less_3655_s20_q;
  logic sum_3656_s20_q;
  logic and_3850_s20_q;
  logic equal_3860_s20_q;
  always_ff @(posedge clk_i) begin
    if (s19_en) begin
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= mask_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= marks_last_s19_q;
      sample_pair_pixel_0_s20_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s20_q <= sample_pair_pixel_1_q;
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
      segment_started_s20_q <= segment_started_q;
      select_482_s20_q <= select_482_s19_q;
      equal_483_s20_q <= equal_483_s19_q;
      select_485_s20_q <= select_485_s19_q;
      select_489_s20_q <= select_489_s19_q;
      and_495_s20_q <= and_495_s19_q;
      and_496_s20_q <= and_496_s19_q;
      averager_memory_rdata_s20_q <= averager_memory_rdata_q;
      select_499_s20_q <= select_499;
      equal_501_s20_q <= equal_501_s19_q;
      sum_505_s20_q <= sum_505;
      column_s20_q <= column_s19_q;
      and_519_s20_q <= and_519_s19_q;
      and_521_s20_q <= and_521_s19_q;
      so_s20_q <= so_s19_q;
      equal_582_s20_q <= equal_582_s19_q;
      equal_1479_s20_q <= equal_1479_s19_q;
      not_1480_s20_q <= not_1480_s19_q;
      shift_2_s20_q <= {shift_2_s19_q[3], shift_2_s19_q[0]};
      equal_1524_s20_q <= x_s19_q[6:4] == 3'h7;
      all_s20_q <= all;
      equal_1538_s20_q <= equal_1538;
      equal_1540_s20_q <= equal_1540;
      equal_1542_s20_q <= equal_1542;
      equal_1544_s20_q <= equal_1544;
      equal_1546_s20_q <= equal_1546;
      and_1551_s20_q <= (~equal_1538) & and_1550;
      right_2_s20_q <= right_2_s19_q;
      and_1592_s20_q <= and_1592_s19_q;
      and_1605_s20_q <= and_1605_s19_q;
      and_1618_s20_q <= and_1618_s19_q;
      less_1619_s20_q <= less_1619_s19_q;
      equal_1620_s20_q <= equal_1620_s19_q;
      sum_1627_s20_q <= sum_1627[1];
      sum_1631_s20_q <= sum_1631;
      equal_1641_s20_q <= equal_1641_s19_q;
      and_1651_s20_q <= and_1651_s19_q;
      select_1666_s20_q <= select_1666_s19_q;
      select_1691_s20_q <= select_1691_s19_q;
      and_1698_s20_q <= and_1698_s19_q;
      and_1699_s20_q <= and_1699_s19_q;
      equal_1700_s20_q <= equal_1700_s19_q;
      not_1701_s20_q <= not_1701_s19_q;
      equal_1702_s20_q <= equal_1702_s19_q;
      not_1703_s20_q <= not_1703_s19_q;
      equal_1704_s20_q <= equal_1704_s19_q;
      equal_1705_s20_q <= equal_1705_s19_q;
      or_1706_s20_q <= or_1706_s19_q;
      select_1730_s20_q <= select_1730_s19_q;
      select_1736_s20_q <= select_1736_s19_q;
      select_1775_s20_q <= select_1775_s19_q;
      patches_columns_above_rdata_s20_q <= {patches_columns_above_rdata_s19_q[24], patches_columns_above_rdata_s19_q[7:0]};
      pixel_2_s20_q <= pixel_2_s19_q;
      sum_1799_s20_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1813_s20_q <= sum_1813;
      sum_1814_s20_q <= sum_1814;
      sum_1825_s20_q <= sum_1825;
      less_1861_s20_q <= less_1861_s19_q;
      equal_1862_s20_q <= equal_1862_s19_q;
      not_1863_s20_q <= not_1863_s19_q;
      equal_1864_s20_q <= equal_1864_s19_q;
      not_1865_s20_q <= not_1865_s19_q;
      patches_rows_rdata_s20_q <= patches_rows_rdata_s19_q;
      or_1882_s20_q <= or_1882;
      or_1885_s20_q <= select_1879[7] | (~({select_1879[6], select_1879[3:2]} == 3'h0));
      or_1888_s20_q <= select_1879[7] | (~(select_1879[6:4] == 3'h0));
      and_1897_s20_q <= and_1897_s19_q;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained;
      and_1911_s20_q <= and_1911_s19_q;
      and_1957_s20_q <= seen_columns_rdata_s19_q[14] & shift_2_s19_q[0];
      and_1958_s20_q <= seen_columns_rdata_s19_q[10] & shift_2_s19_q[0];
      and_1959_s20_q <= and_1959;
      sum_1962_s20_q <= {1'b0, and_1959} + ({1'b0, textured_s19_q} + {1'b0, and_1960});
      or_1974_s20_q <= or_1974;
      or_1977_s20_q <= select_1971[7] | (~({select_1971[6], select_1971[3:2]} == 3'h0));
      or_1980_s20_q <= select_1971[7] | (~(select_1971[6:4] == 3'h0));
      and_1991_s20_q <= seen_columns_rdata_s19_q[16] & shift_2_s19_q[0];
      and_1992_s20_q <= seen_columns_rdata_s19_q[12] & shift_2_s19_q[0];
      sum_1996_s20_q <= {1'b0, and_1993} + ({1'b0, shown_s19_q} + {1'b0, and_1994});
      and_2007_s20_q <= seen_columns_rdata_s19_q[17] & shift_2_s19_q[0];
      and_2008_s20_q <= seen_columns_rdata_s19_q[13] & shift_2_s19_q[0];
      sum_2012_s20_q <= {1'b0, and_2009} + ({1'b0, near_s19_q} + {1'b0, and_2010});
      and_2030_s20_q <= and_2030_s19_q;
      equal_2170_s20_q <= equal_2170_s19_q;
      equal_2294_s20_q <= equal_2294_s19_q;
      and_2423_s20_q <= not_1480_s19_q & and_2422;
      and_2443_s20_q <= seen_columns_rdata_s19_q[15] & shift_2_s19_q[0];
      and_2444_s20_q <= seen_columns_rdata_s19_q[11] & shift_2_s19_q[0];
      sum_2448_s20_q <= {1'b0, and_2445} + ({1'b0, explained} + {1'b0, and_2446});
      and_2485_s20_q <= not_1480_s19_q & (so_s19_q & and_2483);
      select_2543_s20_q <= select_2543;
      and_2771_s20_q <= and_2771_s19_q;
      select_3307_s20_q <= select_3307;
      equal_3325_s20_q <= equal_3325_s19_q;
      and_3328_s20_q <= and_3328;
      select_3360_s20_q <= select_3360;
      less_3655_s20_q <= less_3655_s19_q;
      sum_3656_s20_q <= sum_3656[7];
      and_3850_s20_q <= seen_columns_rdata_s19_q[6] & shift_2_s19_q[0];
      equal_3860_s20_q <= equal_3860_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
  logic sample_of_skin_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic [10:0] registration_expected_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [4:0] patches_band_q;
  logic [1:0] patches_fetch_q;
  logic [4:0] patches_summed_down_by_q;
  logic [4:0] patches_read_at_q;
  logic [4:0] patches_peak_row_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic region_fresh_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/census.hpp:121
  logic [13:0] sum_503;
  assign sum_503 = select_499_s20_q + (equal_501_s20_q ? 14'h0 : averager_memory_rdata_s20_q[13:0]);
  logic [13:0] sum_507;
  assign sum_507 = sum_505_s20_q + (equal_501_s20_q ? 14'h0 : averager_memory_rdata_s20_q[27:14]);
  // hls/stages/agreement.hpp:408
  logic whole;
  assign whole = equal_483_s20_q ? sample_present_s20_q : (sample_present_s20_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_483_s20_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:123
  logic and_515;
  assign and_515 = all_of_skin & (averager_memory_rdata_s20_q[29] | equal_501_s20_q);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter;
  assign quarter = x_s20_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1084
  logic [1:0] select_1527;
  assign select_1527 = x_s20_q[4] ? {x_s20_q[3], x_s20_q[0]} : {x_s20_q[0], x_s20_q[3]};
  // hls/stages/agreement.hpp:1097
  logic [3:0] select_1529;
  assign select_1529 = equal_1524_s20_q ? {2'h0, quarter} : (all_s20_q ? {1'b0, x_s20_q[2:0]} : {x_s20_q[2:1], select_1527});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1530;
  assign sum_1530 = slot_s20_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:776
  logic [3:0] select_1531;
  assign select_1531 = equal_1479_s20_q ? select_1529 : {sum_1530, lower_half_s20_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1532;
  assign equal_1532 = x_s20_q[5:0] == 6'h3f;
  logic equal_1534;
  assign equal_1534 = x_s20_q[5:0] == 6'h3e;
  logic equal_1536;
  assign equal_1536 = x_s20_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1129
  logic and_1554;
  assign and_1554 = (~equal_1532) & ((~equal_1534) & ((~equal_1536) & and_1551_s20_q));
  // hls/stages/agreement.hpp:1084
  logic less_1555;
  assign less_1555 = x_s20_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s20_q ? {1'b0, x_s20_q[2]} : x_s20_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1559;
  assign or_1559 = (kind == 2'h3) | (x_s20_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s20_q[0] ? (right_2_s20_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1570;
  assign sum_1570 = {2'h0, slot_s20_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1576;
  assign not_1576 = ~lower_half_s20_q;
  logic [3:0] select_1577;
  assign select_1577 = registration_of_right_q ? {lower_half_s20_q, 1'b0, not_1576, 1'b0} : {1'b0, lower_half_s20_q, 1'b0, not_1576};
  // hls/stages/patches.hpp:372
  logic [1:0] select_1606;
  assign select_1606 = and_1605_s20_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1607;
  assign select_1607 = and_1605_s20_q ? patches_band_rows_number_s20_q : patches_band_q;
  // hls/stages/agreement.hpp:267
  logic [5:0] select_1608;
  assign select_1608 = and_1592_s20_q ? {select_1607, select_1606[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1609;
  assign select_1609 = and_1592_s20_q ? select_1606 : patches_fetch_q;
  logic equal_1610;
  assign equal_1610 = select_1609 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1620_s20_q ? {sum_1631_s20_q, sum_1627_s20_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1713;
  assign select_1713 = and_1592_s20_q ? select_1607 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_1714;
  assign equal_1714 = {patches_choosing_band_s20_q, and_1618_s20_q} == {select_1713, select_1609[1]};
  // hls/stages/patches.hpp:495
  logic less_1791;
  assign less_1791 = 5'he < patches_along_s20_q;
  // hls/stages/patches.hpp:496
  logic or_1792;
  assign or_1792 = equal_1704_s20_q | less_1791;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_s20_q == 5'h0;
  logic select_1797;
  assign select_1797 = equal_1704_s20_q ? patches_column_s20_q[0] : (or_1792 ? (patches_along_s20_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:497
  logic [4:0] select_1800;
  assign select_1800 = patches_match_row_ends_s20_q ? patches_down_by_s20_q : sum_1799_s20_q;
  // hls/stages/patches.hpp:500
  logic [4:0] select_1803;
  assign select_1803 = equal_1704_s20_q ? 5'h0 : (or_1792 ? (select_1800 + 5'h1) : sum_1799_s20_q);
  // hls/stages/patches.hpp:476
  logic equal_1806;
  assign equal_1806 = patches_column_s20_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s20_q == 5'h11;
  logic equal_1808;
  assign equal_1808 = patches_column_s20_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_1810;
  assign and_1810 = of_row & (~equal_1808);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1806 ? 2'h3 : {equal_1808, and_1810};
  // hls/stages/patches.hpp:464
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1813_s20_q, pixel_2_s20_q[0]} - {1'b0, sum_1814_s20_q, patches_columns_above_rdata_s20_q[8]};
  // hls/stages/patches.hpp:462
  logic [9:0] sum_1826;
  assign sum_1826 = {2'h0, patches_columns_above_rdata_s20_q[7:0]} + sum_1825_s20_q[10:1];
  // hls/stages/patches.hpp:477
  logic or_1836;
  assign or_1836 = (((patches_column_s20_q == 5'ha) | of_row) | equal_1808) | equal_1806;
  // hls/stages/patches.hpp:472
  logic and_1841;
  assign and_1841 = (~(patches_code_row_s20_q[4:2] == 3'h0)) & (~(patches_column_s20_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:172
  logic and_1855;
  assign and_1855 = (~(equal_1705_s20_q | (~and_1841))) & (~patches_column_s20_q[4]);
  // hls/stages/agreement.hpp:776
  logic [5:0] select_1889;
  assign select_1889 = equal_1479_s20_q ? x_s20_q[5:0] : {region_row_q, or_1888_s20_q, or_1885_s20_q, or_1882_s20_q};
  // hls/stages/agreement.hpp:1083
  logic not_1890;
  assign not_1890 = ~equal_1524_s20_q;
  // hls/stages/agreement.hpp:1042
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1957_s20_q} + ({2'h0, and_1958_s20_q} + {1'b0, sum_1962_s20_q});
  // hls/stages/agreement.hpp:1044
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1991_s20_q} + ({2'h0, and_1992_s20_q} + {1'b0, sum_1996_s20_q});
  // hls/stages/agreement.hpp:1045
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2007_s20_q} + ({2'h0, and_2008_s20_q} + {1'b0, sum_2012_s20_q});
  // hls/stages/agreement.hpp:267
  logic select_2083;
  assign select_2083 = sample_pair_whole_s20_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:1060
  logic not_2442;
  assign not_2442 = ~(x_s20_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1043
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2443_s20_q} + ({2'h0, and_2444_s20_q} + {1'b0, sum_2448_s20_q});
  // hls/stages/agreement.hpp:1065
  logic and_2489;
  assign and_2489 = not_2442 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:776
  logic [10:0] select_2530;
  assign select_2530 = equal_1479_s20_q ? registration_expected_q : (so_s20_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2531;
  assign equal_2531 = slot_s20_q == 3'h4;
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2543_s20_q[7]}}, select_2543_s20_q} - {sum_1631_s20_q[9], sum_1631_s20_q, sum_1627_s20_q};
  // hls/stages/agreement.hpp:776
  logic select_2590;
  assign select_2590 = so_s20_q ? (equal_2531 ? right_2_s20_q : registration_of_right_q) : registration_of_right_q;
  logic select_2593;
  assign select_2593 = so_s20_q ? (equal_1620_s20_q ? shift_2_s20_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1084
  logic [1:0] quarter_2;
  assign quarter_2 = all_s20_q ? x_s20_q[1:0] : select_1527;
  // hls/stages/patches.hpp:353
  logic not_2787;
  assign not_2787 = ~select_1609[1];
  // hls/stages/agreement.hpp:267
  logic [1:0] select_2789;
  assign select_2789 = sample_pair_whole_s20_q ? (equal_1610 ? select_1609 : {not_2787, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:184
  logic [4:0] select_3284;
  assign select_3284 = equal_1702_s20_q ? patches_down_by_s20_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3329;
  assign select_3329 = and_3328_s20_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s20_q} - {1'b0, select_3329};
  // hls/stages/agreement.hpp:451
  logic [2:0] select_3658;
  assign select_3658 = less_3655_s20_q ? (sum_3656_s20_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3660;
  assign select_3660 = equal_2294_s20_q ? (equal_582_s20_q ? 3'h0 : select_3658) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3656_s20_q;
  // hls/stages/agreement.hpp:451
  logic select_3691;
  assign select_3691 = equal_2294_s20_q ? (equal_582_s20_q | (less_3655_s20_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1161
  logic equal_3709;
  assign equal_3709 = x_s20_q[6:3] == 4'h7;
  logic equal_3731;
  assign equal_3731 = x_s20_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1080
  logic [7:0] select_3744;
  assign select_3744 = (x_s20_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3746;
  assign select_3746 = equal_3731 ? cfg_unproven_skin_limit_i : (equal_3709 ? cfg_unproven_limit_i : select_3744);
  // hls/stages/agreement.hpp:776
  logic select_3848;
  assign select_3848 = so_s20_q ? (ends_cell_s20_q ? and_1959_s20_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3852;
  assign select_3852 = so_s20_q ? (ends_cell_s20_q ? and_3850_s20_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_3854;
  assign select_3854 = ends_cell_s20_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3856;
  assign select_3856 = equal_1479_s20_q ? centres_values_1_textured_q : (so_s20_q ? select_3854 : centres_values_1_textured_q);
  logic select_3857;
  assign select_3857 = ends_cell_s20_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3859;
  assign select_3859 = equal_1479_s20_q ? centres_values_1_of_skin_q : (so_s20_q ? select_3857 : centres_values_1_of_skin_q);

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 20, written in stage 22: 20 < 22 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s20_q;
  logic census_memory_re;
  assign census_memory_re = s20_en & and_521_s20_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1334; read in stage 20, written in stage 23: 20 < 23 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1889;
  logic regions_re;
  assign regions_re = s20_en & (equal_1479_s20_q ? (x_s20_q[6] & not_1890) : and_1897_s20_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_of_skin_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      registration_expected_q <= 11'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      patches_band_q <= 5'h0;
      patches_fetch_q <= 2'h0;
      patches_summed_down_by_q <= 5'h0;
      patches_read_at_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_fresh_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
    end else if (s20_en) begin
      sample_of_skin_q <= mask_s20_q;
      averager_running_mask_q <= sample_pair_whole_s20_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2083;
      registration_expected_q <= select_2530;
      registration_of_right_q <= equal_1479_s20_q ? registration_of_right_q : select_2590;
      registration_was_inside_q <= equal_1479_s20_q ? registration_was_inside_q : select_2593;
      patches_band_q <= sample_pair_whole_s20_q ? select_1713 : patches_band_q;
      patches_fetch_q <= select_2789;
      patches_summed_down_by_q <= equal_1700_s20_q ? patches_summed_down_by_q : select_3284;
      patches_read_at_q <= equal_1700_s20_q ? select_3307_s20_q : patches_read_at_q;
      patches_peak_row_q <= equal_1700_s20_q ? select_3329 : patches_peak_row_q;
      region_row_q <= and_521_s20_q ? select_3660 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_521_s20_q ? select_3691 : region_fresh_q;
      centres_values_0_textured_q <= equal_1479_s20_q ? centres_values_0_textured_q : select_3848;
      centres_values_0_of_skin_q <= equal_1479_s20_q ? centres_values_0_of_skin_q : select_3852;
      centres_values_1_textured_q <= select_3856;
      centres_values_1_of_skin_q <= select_3859;
    end
  end

  logic [7:0] pixel_0_s21_q;
  logic [7:0] pixel_1_s21_q;
  logic saturated_s21_q;
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
  logic [3:0] select_482_s21_q;
  logic [6:0] select_485_s21_q;
  logic [8:0] select_489_s21_q;
  logic and_495_s21_q;
  logic and_496_s21_q;
  logic [13:0] sum_503_s21_q;
  logic [13:0] sum_507_s21_q;
  logic and_511_s21_q;
  logic and_515_s21_q;
  logic [6:0] column_s21_q;
  logic and_519_s21_q;
  logic and_521_s21_q;
  logic equal_524_s21_q;
  logic so_s21_q;
  logic equal_582_s21_q;
  logic equal_1479_s21_q;
  logic not_1480_s21_q;
  logic [1:0] shift_2_s21_q;
  logic equal_1524_s21_q;
  logic [1:0] quarter_s21_q;
  logic all_s21_q;
  logic [1:0] sum_1530_s21_q;
  logic [3:0] select_1531_s21_q;
  logic equal_1532_s21_q;
  logic equal_1534_s21_q;
  logic equal_1536_s21_q;
  logic equal_1538_s21_q;
  logic equal_1540_s21_q;
  logic equal_1542_s21_q;
  logic equal_1544_s21_q;
  logic equal_1546_s21_q;
  logic less_1555_s21_q;
  logic or_1559_s21_q;
  logic select_1562_s21_q;
  logic and_1572_s21_q;
  logic [3:0] select_1577_s21_q;
  logic and_1592_s21_q;
  logic [5:0] select_1608_s21_q;
  logic select_1609_s21_q;
  logic equal_1610_s21_q;
  logic and_1618_s21_q;
  logic less_1619_s21_q;
  logic equal_1620_s21_q;
  logic expected_s21_q;
  logic [10:0] sum_1633_s21_q;
  logic equal_1641_s21_q;
  logic and_1651_s21_q;
  logic [5:0] select_1666_s21_q;
  logic [7:0] select_1691_s21_q;
  logic and_1698_s21_q;
  logic and_1699_s21_q;
  logic equal_1700_s21_q;
  logic not_1701_s21_q;
  logic equal_1702_s21_q;
  logic not_1703_s21_q;
  logic equal_1705_s21_q;
  logic or_1706_s21_q;
  logic and_1715_s21_q;
  logic [4:0] select_1730_s21_q;
  logic select_1736_s21_q;
  logic [3:0] select_1775_s21_q;
  logic patches_columns_above_rdata_s21_q;
  logic [7:0] pixel_2_s21_q;
  logic less_1791_s21_q;
  logic new_row_s21_q;
  logic select_1797_s21_q;
  logic not_1798_s21_q;
  logic [4:0] select_1803_s21_q;
  logic or_1804_s21_q;
  logic [1:0] of_row_2_s21_q;
  logic [10:0] down_2_s21_q;
  logic sum_1825_s21_q;
  logic [9:0] sum_1826_s21_q;
  logic and_1844_s21_q;
  logic and_1855_s21_q;
  logic and_1858_s21_q;
  logic less_1861_s21_q;
  logic equal_1862_s21_q;
  logic not_1863_s21_q;
  logic equal_1864_s21_q;
  logic not_1865_s21_q;
  logic [9:0] patches_rows_rdata_s21_q;
  logic or_1882_s21_q;
  logic or_1885_s21_q;
  logic or_1888_s21_q;
  logic not_1890_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1911_s21_q;
  logic and_1916_s21_q;
  logic [2:0] textured_2_s21_q;
  logic or_1974_s21_q;
  logic or_1977_s21_q;
  logic or_1980_s21_q;
  logic [2:0] shown_2_s21_q;
  logic [2:0] near_2_s21_q;
  logic and_2030_s21_q;
  logic equal_2170_s21_q;
  logic equal_2294_s21_q;
  logic and_2423_s21_q;
  logic not_2442_s21_q;
  logic [2:0] explained_2_s21_q;
  logic and_2485_s21_q;
  logic and_2492_s21_q;
  logic and_2534_s21_q;
  logic [11:0] select_2546_s21_q;
  logic equal_2595_s21_q;
  logic [3:0] not_2596_s21_q;
  logic [1:0] quarter_2_s21_q;
  logic and_2771_s21_q;
  logic less_2898_s21_q;
  logic equal_3325_s21_q;
  logic [4:0] select_3329_s21_q;
  logic [5:0] away_s21_q;
  logic equal_3331_s21_q;
  logic equal_3340_s21_q;
  logic [14:0] select_3360_s21_q;
  logic equal_3709_s21_q;
  logic equal_3730_s21_q;
  logic equal_3731_s21_q;
  logic [7:0] select_3746_s21_q;
  logic equal_3860_s21_q;
  always_ff @(posedge clk_i) begin
    if (s20_en) begin
      pixel_0_s21_q <= sample_pair_pixel_0_q;
      pixel_1_s21_q <= sample_pair_pixel_1_q;
      saturated_s21_q <= saturated_s20_q;
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
      region_row_s21_q <= region_row_q;
      region_fresh_s21_q <= region_fresh_q;
      segment_started_s21_q <= segment_started_s20_q;
      centres_values_1_textured_s21_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s21_q <= centres_values_1_of_skin_q;
      select_482_s21_q <= select_482_s20_q;
      select_485_s21_q <= select_485_s20_q;
      select_489_s21_q <= select_489_s20_q;
      and_495_s21_q <= and_495_s20_q;
      and_496_s21_q <= and_496_s20_q;
      sum_503_s21_q <= sum_503;
      sum_507_s21_q <= sum_507;
      and_511_s21_q <= whole & (averager_memory_rdata_s20_q[28] | equal_501_s20_q);
      and_515_s21_q <= and_515;
      column_s21_q <= column_s20_q;
      and_519_s21_q <= and_519_s20_q;
      and_521_s21_q <= and_521_s20_q;
      equal_524_s21_q <= select_482_s20_q == 4'h3;
      so_s21_q <= so_s20_q;
      equal_582_s21_q <= equal_582_s20_q;
      equal_1479_s21_q <= equal_1479_s20_q;
      not_1480_s21_q <= not_1480_s20_q;
      shift_2_s21_q <= shift_2_s20_q;
      equal_1524_s21_q <= equal_1524_s20_q;
      quarter_s21_q <= quarter;
      all_s21_q <= all_s20_q;
      sum_1530_s21_q <= sum_1530;
      select_1531_s21_q <= select_1531;
      equal_1532_s21_q <= equal_1532;
      equal_1534_s21_q <= equal_1534;
      equal_1536_s21_q <= equal_1536;
      equal_1538_s21_q <= equal_1538_s20_q;
      equal_1540_s21_q <= equal_1540_s20_q;
      equal_1542_s21_q <= equal_1542_s20_q;
      equal_1544_s21_q <= equal_1544_s20_q;
      equal_1546_s21_q <= equal_1546_s20_q;
      less_1555_s21_q <= less_1555;
      or_1559_s21_q <= or_1559;
      select_1562_s21_q <= equal_1524_s20_q ? and_1554 : (less_1555 & (~or_1559));
      and_1572_s21_q <= half_ends & ({{3{sum_1570[4]}}, sum_1570} < 8'h3);
      select_1577_s21_q <= select_1577;
      and_1592_s21_q <= and_1592_s20_q;
      select_1608_s21_q <= select_1608;
      select_1609_s21_q <= select_1609[1];
      equal_1610_s21_q <= equal_1610;
      and_1618_s21_q <= and_1618_s20_q;
      less_1619_s21_q <= less_1619_s20_q;
      equal_1620_s21_q <= equal_1620_s20_q;
      expected_s21_q <= expected[0];
      sum_1633_s21_q <= {expected[10], expected[10:1]} + 11'h5;
      equal_1641_s21_q <= equal_1641_s20_q;
      and_1651_s21_q <= and_1651_s20_q;
      select_1666_s21_q <= select_1666_s20_q;
      select_1691_s21_q <= select_1691_s20_q;
      and_1698_s21_q <= and_1698_s20_q;
      and_1699_s21_q <= and_1699_s20_q;
      equal_1700_s21_q <= equal_1700_s20_q;
      not_1701_s21_q <= not_1701_s20_q;
      equal_1702_s21_q <= equal_1702_s20_q;
      not_1703_s21_q <= not_1703_s20_q;
      equal_1705_s21_q <= equal_1705_s20_q;
      or_1706_s21_q <= or_1706_s20_q;
      and_1715_s21_q <= and_1699_s20_q & equal_1714;
      select_1730_s21_q <= select_1730_s20_q;
      select_1736_s21_q <= select_1736_s20_q;
      select_1775_s21_q <= select_1775_s20_q;
      patches_columns_above_rdata_s21_q <= patches_columns_above_rdata_s20_q[8];
      pixel_2_s21_q <= pixel_2_s20_q;
      less_1791_s21_q <= less_1791;
      new_row_s21_q <= new_row;
      select_1797_s21_q <= select_1797;
      not_1798_s21_q <= ~or_1792;
      select_1803_s21_q <= select_1803;
      or_1804_s21_q <= equal_1704_s20_q | equal_1702_s20_q;
      of_row_2_s21_q <= of_row_2;
      down_2_s21_q <= down_2;
      sum_1825_s21_q <= sum_1825_s20_q[0];
      sum_1826_s21_q <= sum_1826;
      and_1844_s21_q <= or_1706_s20_q & (or_1836 & (equal_1705_s20_q & and_1841));
      and_1855_s21_q <= and_1855;
      and_1858_s21_q <= or_1706_s20_q & (and_1855 & (patches_column_s20_q == 5'hf));
      less_1861_s21_q <= less_1861_s20_q;
      equal_1862_s21_q <= equal_1862_s20_q;
      not_1863_s21_q <= not_1863_s20_q;
      equal_1864_s21_q <= equal_1864_s20_q;
      not_1865_s21_q <= not_1865_s20_q;
      patches_rows_rdata_s21_q <= patches_rows_rdata_s20_q;
      or_1882_s21_q <= or_1882_s20_q;
      or_1885_s21_q <= or_1885_s20_q;
      or_1888_s21_q <= or_1888_s20_q;
      not_1890_s21_q <= not_1890;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1911_s21_q <= and_1911_s20_q;
      and_1916_s21_q <= not_1480_s20_q & and_1897_s20_q;
      textured_2_s21_q <= textured_2;
      or_1974_s21_q <= or_1974_s20_q;
      or_1977_s21_q <= or_1977_s20_q;
      or_1980_s21_q <= or_1980_s20_q;
      shown_2_s21_q <= shown_2;
      near_2_s21_q <= near_2;
      and_2030_s21_q <= and_2030_s20_q;
      equal_2170_s21_q <= equal_2170_s20_q;
      equal_2294_s21_q <= equal_2294_s20_q;
      and_2423_s21_q <= and_2423_s20_q;
      not_2442_s21_q <= not_2442;
      explained_2_s21_q <= explained_2;
      and_2485_s21_q <= and_2485_s20_q;
      and_2492_s21_q <= not_1480_s20_q & (so_s20_q & (ends_cell_s20_q & and_2489));
      and_2534_s21_q <= not_1480_s20_q & (so_s20_q & (half_ends & equal_2531));
      select_2546_s21_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2595_s21_q <= sum_1530 == 2'h2;
      not_2596_s21_q <= ~select_1577;
      quarter_2_s21_q <= quarter_2;
      and_2771_s21_q <= and_2771_s20_q;
      less_2898_s21_q <= 4'he < patches_column_s20_q[4:1];
      equal_3325_s21_q <= equal_3325_s20_q;
      select_3329_s21_q <= select_3329;
      away_s21_q <= away;
      equal_3331_s21_q <= away == 6'h3f;
      equal_3340_s21_q <= away == 6'h1;
      select_3360_s21_q <= select_3360_s20_q;
      equal_3709_s21_q <= equal_3709;
      equal_3730_s21_q <= x_s20_q[6:3] == 4'h9;
      equal_3731_s21_q <= equal_3731;
      select_3746_s21_q <= select_3746;
      equal_3860_s21_q <= equal_3860_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [3:0] census_filled_q;
  logic [4:0] rows_passed_above_q;
  logic [13:0] counts_textured_q;
  logic [13:0] counts_skin_supervised_q;
  logic [13:0] counts_skin_textured_q;
  logic [3:0] registration_fresh_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [2:0] box_textured_columns_values_0_q;
  logic [2:0] box_textured_columns_values_1_q;
  logic [2:0] box_textured_columns_values_2_q;
  logic [2:0] box_textured_columns_values_3_q;
  logic [2:0] box_textured_columns_values_4_q;
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
  assign grey = and_495_s21_q ? sum_503_s21_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_524_s21_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_495_s21_q ? sum_507_s21_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_524_s21_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_532;
  assign and_532 = and_495_s21_q & and_511_s21_q;
  // hls/stages/census.hpp:126
  logic select_534;
  assign select_534 = equal_524_s21_q ? and_532 : (averager_mask_q & and_532);
  // hls/stages/agreement.hpp:267
  logic whole_2;
  assign whole_2 = sample_pair_whole_s21_q & select_534;
  // hls/stages/census.hpp:206
  logic and_536;
  assign and_536 = and_495_s21_q & and_515_s21_q;
  // hls/stages/census.hpp:126
  logic select_538;
  assign select_538 = equal_524_s21_q ? and_536 : (averager_of_skin_q & and_536);
  // hls/stages/agreement.hpp:446
  logic equal_579;
  assign equal_579 = column_s21_q == 7'h0;
  logic [3:0] select_583;
  assign select_583 = equal_582_s21_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:447
  logic [4:0] select_584;
  assign select_584 = equal_579 ? {select_583, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_585;
  assign select_585 = equal_579 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:776
  logic and_1573;
  assign and_1573 = so_s21_q & and_1572_s21_q;
  // hls/stages/patches.hpp:98
  logic less_1634;
  assign less_1634 = {{4{sum_1633_s21_q[10]}}, sum_1633_s21_q, expected_s21_q} < 16'h15;
  // hls/stages/patches.hpp:111
  logic and_1652;
  assign and_1652 = (less_1619_s21_q & (shift_2_s21_q[1] & less_1634)) & and_1651_s21_q;
  // hls/stages/patches.hpp:466
  logic [11:0] sum_1816;
  assign sum_1816 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1817;
  assign sum_1817 = {{4{down_2_s21_q[10]}}, down_2_s21_q[10:2]} + {sum_1816[11], sum_1816};
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_1826_s21_q, sum_1825_s21_q, patches_columns_above_rdata_s21_q} + {4'h0, pixel_2_s21_q};
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_1965;
  assign select_1965 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_1999;
  assign select_1999 = age_s21_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1052
  logic [2:0] select_2015;
  assign select_2015 = age_s21_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:267
  logic [10:0] select_2062;
  assign select_2062 = sample_pair_whole_s21_q ? (and_519_s21_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2064;
  assign select_2064 = sample_pair_whole_s21_q ? (and_519_s21_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2085;
  assign select_2085 = sample_pair_whole_s21_q ? (and_519_s21_q ? select_534 : averager_mask_q) : averager_mask_q;
  logic select_2087;
  assign select_2087 = sample_pair_whole_s21_q ? (and_519_s21_q ? select_538 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:511
  logic and_2419;
  assign and_2419 = and_521_s21_q & (equal_582_s21_q & equal_2294_s21_q);
  // hls/stages/agreement.hpp:776
  logic and_2428;
  assign and_2428 = not_1480_s21_q & (so_s21_q & (ends_cell_s21_q & textured_s21_q));
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_2451;
  assign select_2451 = age_s21_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2487;
  assign select_2487 = and_2419 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2485_s21_q});
  logic [13:0] select_2494;
  assign select_2494 = and_2419 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2492_s21_q});
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2546_s21_q[11:7])) ? 12'h7f : select_2546_s21_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2598;
  assign select_2598 = equal_2595_s21_q ? (registration_fresh_q & not_2596_s21_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:776
  logic [3:0] select_2600;
  assign select_2600 = so_s21_q ? (and_1572_s21_q ? select_2598 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2602;
  assign select_2602 = and_2419 ? 4'hf : (equal_1479_s21_q ? registration_fresh_q : select_2600);
  // hls/stages/registration.hpp:258
  logic not_2623;
  assign not_2623 = ~quarter_2_s21_q[1];
  logic [3:0] select_2624;
  assign select_2624 = quarter_2_s21_q[0] ? {quarter_2_s21_q[1], 1'b0, not_2623, 1'b0} : {1'b0, quarter_2_s21_q[1], 1'b0, not_2623};
  // hls/stages/patches.hpp:184
  logic [10:0] select_2876;
  assign select_2876 = equal_1702_s21_q ? patches_down_values_0_q : (or_1706_s21_q ? down_2_s21_q : patches_down_values_0_q);
  logic [10:0] select_2878;
  assign select_2878 = or_1706_s21_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_2880;
  assign select_2880 = equal_1700_s21_q ? patches_down_values_1_q : (equal_1702_s21_q ? patches_down_values_1_q : select_2878);
  // hls/stages/patches.hpp:551
  logic and_3333;
  assign and_3333 = less_1861_s21_q & (equal_3325_s21_q & equal_3331_s21_q);
  // hls/stages/patches.hpp:555
  logic select_3336;
  assign select_3336 = equal_1864_s21_q ? (less_1861_s21_q ? (not_1865_s21_q & and_3333) : and_3333) : and_3333;
  // hls/stages/patches.hpp:551
  logic and_3342;
  assign and_3342 = less_1861_s21_q & (equal_3325_s21_q & equal_3340_s21_q);
  // hls/stages/patches.hpp:555
  logic select_3345;
  assign select_3345 = equal_1864_s21_q ? (less_1861_s21_q ? (not_1865_s21_q & and_3342) : and_3342) : and_3342;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3349;
  assign sum_3349 = {away_s21_q[5], away_s21_q} + 7'h7d;
  // hls/stages/agreement.hpp:1167
  logic equal_3481;
  assign equal_3481 = x_s21_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1161
  logic equal_3728;
  assign equal_3728 = x_s21_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1080
  logic [7:0] limit;
  assign limit = equal_3728 ? cfg_regions_limit_i : (equal_3730_s21_q ? cfg_hidden_limit_i : select_3746_s21_q);
  // hls/stages/agreement.hpp:1174
  logic not_3749;
  assign not_3749 = ~x_s21_q[2];
  logic [3:0] select_3750;
  assign select_3750 = x_s21_q[1] ? {x_s21_q[2], 1'b0, not_3749, 1'b0} : {1'b0, x_s21_q[2], 1'b0, not_3749};
  logic [7:0] select_3751;
  assign select_3751 = x_s21_q[0] ? {select_3750[3], 1'b0, select_3750[2], 1'b0, select_3750[1], 1'b0, select_3750[0], 1'b0} : {1'b0, select_3750[3], 1'b0, select_3750[2], 1'b0, select_3750[1], 1'b0, select_3750[0]};
  // hls/stages/agreement.hpp:1080
  logic [13:0] select_3755;
  assign select_3755 = equal_3730_s21_q ? counts_skin_supervised_q : (equal_3731_s21_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3728 ? counts_textured_q : select_3755;
  // hls/stages/agreement.hpp:776
  logic [2:0] select_3775;
  assign select_3775 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_3777;
  assign select_3777 = equal_1479_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_3775 : box_textured_columns_values_0_q);
  logic [2:0] select_3778;
  assign select_3778 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3780;
  assign select_3780 = equal_1479_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_3778 : box_textured_columns_values_1_q);
  logic [2:0] select_3781;
  assign select_3781 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3783;
  assign select_3783 = equal_1479_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_3781 : box_textured_columns_values_2_q);
  logic [2:0] select_3784;
  assign select_3784 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3786;
  assign select_3786 = equal_1479_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_3784 : box_textured_columns_values_3_q);
  logic [2:0] select_3787;
  assign select_3787 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3789;
  assign select_3789 = equal_1479_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_3787 : box_textured_columns_values_4_q);
  logic [2:0] select_3793;
  assign select_3793 = ends_cell_s21_q ? explained_2_s21_q : box_explained_columns_values_0_q;
  logic [2:0] select_3795;
  assign select_3795 = equal_1479_s21_q ? box_explained_columns_values_0_q : (so_s21_q ? select_3793 : box_explained_columns_values_0_q);
  logic [2:0] select_3796;
  assign select_3796 = ends_cell_s21_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3798;
  assign select_3798 = equal_1479_s21_q ? box_explained_columns_values_1_q : (so_s21_q ? select_3796 : box_explained_columns_values_1_q);
  logic [2:0] select_3799;
  assign select_3799 = ends_cell_s21_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3801;
  assign select_3801 = equal_1479_s21_q ? box_explained_columns_values_2_q : (so_s21_q ? select_3799 : box_explained_columns_values_2_q);
  logic [2:0] select_3802;
  assign select_3802 = ends_cell_s21_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3804;
  assign select_3804 = equal_1479_s21_q ? box_explained_columns_values_3_q : (so_s21_q ? select_3802 : box_explained_columns_values_3_q);
  logic [2:0] select_3805;
  assign select_3805 = ends_cell_s21_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3807;
  assign select_3807 = equal_1479_s21_q ? box_explained_columns_values_4_q : (so_s21_q ? select_3805 : box_explained_columns_values_4_q);
  logic [2:0] select_3812;
  assign select_3812 = so_s21_q ? (ends_cell_s21_q ? shown_2_s21_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3814;
  assign select_3814 = ends_cell_s21_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3816;
  assign select_3816 = equal_1479_s21_q ? box_shown_columns_values_1_q : (so_s21_q ? select_3814 : box_shown_columns_values_1_q);
  logic [2:0] select_3817;
  assign select_3817 = ends_cell_s21_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3819;
  assign select_3819 = equal_1479_s21_q ? box_shown_columns_values_2_q : (so_s21_q ? select_3817 : box_shown_columns_values_2_q);
  logic [2:0] select_3820;
  assign select_3820 = ends_cell_s21_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3822;
  assign select_3822 = equal_1479_s21_q ? box_shown_columns_values_3_q : (so_s21_q ? select_3820 : box_shown_columns_values_3_q);
  logic [2:0] select_3823;
  assign select_3823 = ends_cell_s21_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3825;
  assign select_3825 = equal_1479_s21_q ? box_shown_columns_values_4_q : (so_s21_q ? select_3823 : box_shown_columns_values_4_q);
  logic [2:0] select_3830;
  assign select_3830 = so_s21_q ? (ends_cell_s21_q ? near_2_s21_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3832;
  assign select_3832 = ends_cell_s21_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3834;
  assign select_3834 = equal_1479_s21_q ? box_nearer_columns_values_1_q : (so_s21_q ? select_3832 : box_nearer_columns_values_1_q);
  logic [2:0] select_3835;
  assign select_3835 = ends_cell_s21_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3837;
  assign select_3837 = equal_1479_s21_q ? box_nearer_columns_values_2_q : (so_s21_q ? select_3835 : box_nearer_columns_values_2_q);
  logic [2:0] select_3838;
  assign select_3838 = ends_cell_s21_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3840;
  assign select_3840 = equal_1479_s21_q ? box_nearer_columns_values_3_q : (so_s21_q ? select_3838 : box_nearer_columns_values_3_q);
  logic [2:0] select_3841;
  assign select_3841 = ends_cell_s21_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3843;
  assign select_3843 = equal_1479_s21_q ? box_nearer_columns_values_4_q : (so_s21_q ? select_3841 : box_nearer_columns_values_4_q);
  // hls/stages/registration.hpp:258
  logic not_3949;
  assign not_3949 = ~quarter_s21_q[1];
  logic [3:0] select_3950;
  assign select_3950 = quarter_s21_q[0] ? {quarter_s21_q[1], 1'b0, not_3949, 1'b0} : {1'b0, quarter_s21_q[1], 1'b0, not_3949};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 21, written in stage 25: 21 < 25 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1531_s21_q;
  logic registration_sums_re;
  assign registration_sums_re = s21_en & (equal_1479_s21_q ? (x_s21_q[6] & select_1562_s21_q) : and_1573);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:762; read in stage 21, written in stage 23: 21 < 23 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1608_s21_q;
  logic patches_choices_re;
  assign patches_choices_re = s21_en & (sample_pair_whole_s21_q & (~equal_1610_s21_q));
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:791; read in stage 21, written in stage 24: 21 < 24 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1803_s21_q, not_1798_s21_q, select_1797_s21_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s21_en & or_1804_s21_q;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:792; read in stage 21, written in stage 24: 21 < 24 < 21 + DISTANCE.
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
  assign patches_left_codes_re = s21_en & (not_1701_s21_q & (new_row_s21_q & equal_1702_s21_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_489_s21_q;
  logic averager_memory_we;
  assign averager_memory_we = s21_en & and_496_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_515_s21_q, and_511_s21_q, sum_507_s21_q, sum_503_s21_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s19_sim;
  logic averager_memory_re_s19_sim;
  logic [8:0] averager_memory_raddr_s20_sim;
  logic averager_memory_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s19_sim <= 1'b0;
      averager_memory_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s19_sim <= averager_memory_re;
      averager_memory_raddr_s19_sim <= averager_memory_raddr;
      averager_memory_re_s20_sim <= averager_memory_re_s19_sim;
      averager_memory_raddr_s20_sim <= averager_memory_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s19_sim && averager_memory_raddr_s19_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s20_sim && averager_memory_raddr_s20_sim == averager_memory_waddr) begin
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
      registration_fresh_q <= 4'hf;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
    end else if (s21_en) begin
      averager_mask_q <= select_2085;
      averager_of_skin_q <= select_2087;
      census_filled_q <= and_521_s21_q ? {select_585[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_521_s21_q ? select_584 : rows_passed_above_q;
      counts_textured_q <= and_2419 ? 14'h0 : (counts_textured_q + {13'h0, and_2428});
      counts_skin_supervised_q <= select_2487;
      counts_skin_textured_q <= select_2494;
      registration_fresh_q <= select_2602;
      patches_down_values_0_q <= equal_1700_s21_q ? patches_down_values_0_q : select_2876;
      patches_down_values_1_q <= select_2880;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
    box_textured_columns_values_0_q = 3'h0;
    box_textured_columns_values_1_q = 3'h0;
    box_textured_columns_values_2_q = 3'h0;
    box_textured_columns_values_3_q = 3'h0;
    box_textured_columns_values_4_q = 3'h0;
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
    if (s21_en) begin
      averager_total_0_q <= select_2062;
      averager_total_1_q <= select_2064;
      box_textured_columns_values_0_q <= select_3777;
      box_textured_columns_values_1_q <= select_3780;
      box_textured_columns_values_2_q <= select_3783;
      box_textured_columns_values_3_q <= select_3786;
      box_textured_columns_values_4_q <= select_3789;
      box_explained_columns_values_0_q <= select_3795;
      box_explained_columns_values_1_q <= select_3798;
      box_explained_columns_values_2_q <= select_3801;
      box_explained_columns_values_3_q <= select_3804;
      box_explained_columns_values_4_q <= select_3807;
      box_shown_columns_values_0_q <= equal_1479_s21_q ? box_shown_columns_values_0_q : select_3812;
      box_shown_columns_values_1_q <= select_3816;
      box_shown_columns_values_2_q <= select_3819;
      box_shown_columns_values_3_q <= select_3822;
      box_shown_columns_values_4_q <= select_3825;
      box_nearer_columns_values_0_q <= equal_1479_s21_q ? box_nearer_columns_values_0_q : select_3830;
      box_nearer_columns_values_1_q <= select_3834;
      box_nearer_columns_values_2_q <= select_3837;
      box_nearer_columns_values_3_q <= select_3840;
      box_nearer_columns_values_4_q <= select_3843;
    end
  end

  logic [7:0] pixel_0_s22_q;
  logic [7:0] pixel_1_s22_q;
  logic saturated_s22_q;
  logic mask_s22_q;
  logic marks_first_s22_q;
  logic marks_last_s22_q;
  logic [7:0] sample_pair_pixel_0_s22_q;
  logic [7:0] sample_pair_pixel_1_s22_q;
  logic sample_pair_whole_s22_q;
  logic sample_present_s22_q;
  logic [7:0] x_s22_q;
  logic [2:0] slot_s22_q;
  logic ends_cell_s22_q;
  logic lower_half_s22_q;
  logic [13:0] counts_textured_s22_q;
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
  logic region_fresh_s22_q;
  logic segment_started_s22_q;
  logic centres_values_1_textured_s22_q;
  logic centres_values_1_of_skin_s22_q;
  logic [3:0] select_482_s22_q;
  logic [6:0] select_485_s22_q;
  logic [6:0] column_s22_q;
  logic and_519_s22_q;
  logic and_521_s22_q;
  logic [77:0] census_memory_rdata_s22_q;
  logic [8:0] grey_s22_q;
  logic equal_524_s22_q;
  logic [8:0] select_527_s22_q;
  logic [8:0] grey_2_s22_q;
  logic [8:0] select_531_s22_q;
  logic whole_2_s22_q;
  logic and_539_s22_q;
  logic so_s22_q;
  logic and_586_s22_q;
  logic equal_1479_s22_q;
  logic not_1480_s22_q;
  logic shift_2_s22_q;
  logic equal_1524_s22_q;
  logic all_s22_q;
  logic [1:0] sum_1530_s22_q;
  logic equal_1532_s22_q;
  logic equal_1534_s22_q;
  logic equal_1536_s22_q;
  logic equal_1538_s22_q;
  logic equal_1540_s22_q;
  logic equal_1542_s22_q;
  logic equal_1544_s22_q;
  logic equal_1546_s22_q;
  logic less_1555_s22_q;
  logic or_1559_s22_q;
  logic equal_1579_s22_q;
  logic and_1589_s22_q;
  logic and_1592_s22_q;
  logic select_1609_s22_q;
  logic equal_1610_s22_q;
  logic and_1618_s22_q;
  logic equal_1620_s22_q;
  logic equal_1641_s22_q;
  logic and_1652_s22_q;
  logic [5:0] select_1666_s22_q;
  logic [7:0] select_1691_s22_q;
  logic and_1698_s22_q;
  logic and_1699_s22_q;
  logic equal_1700_s22_q;
  logic equal_1702_s22_q;
  logic equal_1705_s22_q;
  logic or_1706_s22_q;
  logic and_1715_s22_q;
  logic [4:0] select_1730_s22_q;
  logic select_1736_s22_q;
  logic [3:0] select_1775_s22_q;
  logic less_1791_s22_q;
  logic new_row_s22_q;
  logic or_1804_s22_q;
  logic [1:0] of_row_2_s22_q;
  logic [1:0] down_2_s22_q;
  logic [12:0] sum_1817_s22_q;
  logic [11:0] smooth_s22_q;
  logic and_1846_s22_q;
  logic and_1855_s22_q;
  logic and_1860_s22_q;
  logic less_1861_s22_q;
  logic equal_1862_s22_q;
  logic not_1863_s22_q;
  logic equal_1864_s22_q;
  logic [9:0] patches_rows_rdata_s22_q;
  logic or_1882_s22_q;
  logic or_1885_s22_q;
  logic or_1888_s22_q;
  logic not_1890_s22_q;
  logic [29:0] regions_rdata_s22_q;
  logic textured_s22_q;
  logic explained_s22_q;
  logic and_1911_s22_q;
  logic and_1916_s22_q;
  logic [3:0] difference_1966_s22_q;
  logic or_1974_s22_q;
  logic or_1977_s22_q;
  logic or_1980_s22_q;
  logic [3:0] difference_2000_s22_q;
  logic [3:0] difference_2016_s22_q;
  logic and_2030_s22_q;
  logic equal_2170_s22_q;
  logic equal_2294_s22_q;
  logic and_2419_s22_q;
  logic and_2423_s22_q;
  logic and_2428_s22_q;
  logic not_2442_s22_q;
  logic [3:0] difference_2452_s22_q;
  logic and_2534_s22_q;
  logic and_2535_s22_q;
  logic [11:0] residual_s22_q;
  logic equal_2626_s22_q;
  logic and_2771_s22_q;
  logic less_2898_s22_q;
  logic equal_3241_s22_q;
  logic [4:0] select_3329_s22_q;
  logic select_3336_s22_q;
  logic select_3345_s22_q;
  logic and_3351_s22_q;
  logic [14:0] select_3360_s22_q;
  logic equal_3481_s22_q;
  logic and_3710_s22_q;
  logic equal_3728_s22_q;
  logic equal_3730_s22_q;
  logic equal_3731_s22_q;
  logic equal_3753_s22_q;
  logic [13:0] of_s22_q;
  logic equal_3860_s22_q;
  logic equal_3952_s22_q;
  always_ff @(posedge clk_i) begin
    if (s21_en) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= sample_of_skin_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      sample_pair_pixel_0_s22_q <= sample_pair_pixel_0_s21_q;
      sample_pair_pixel_1_s22_q <= sample_pair_pixel_1_s21_q;
      sample_pair_whole_s22_q <= sample_pair_whole_s21_q;
      sample_present_s22_q <= sample_present_s21_q;
      x_s22_q <= x_s21_q;
      slot_s22_q <= slot_s21_q;
      ends_cell_s22_q <= ends_cell_s21_q;
      lower_half_s22_q <= lower_half_s21_q;
      counts_textured_s22_q <= counts_textured_q;
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
      region_fresh_s22_q <= region_fresh_s21_q;
      segment_started_s22_q <= segment_started_s21_q;
      centres_values_1_textured_s22_q <= centres_values_1_textured_s21_q;
      centres_values_1_of_skin_s22_q <= centres_values_1_of_skin_s21_q;
      select_482_s22_q <= select_482_s21_q;
      select_485_s22_q <= select_485_s21_q;
      column_s22_q <= column_s21_q;
      and_519_s22_q <= and_519_s21_q;
      and_521_s22_q <= and_521_s21_q;
      census_memory_rdata_s22_q <= census_memory_rdata_q;
      grey_s22_q <= grey;
      equal_524_s22_q <= equal_524_s21_q;
      select_527_s22_q <= sample_pair_whole_s21_q ? total[10:2] : 9'h0;
      grey_2_s22_q <= grey_2;
      select_531_s22_q <= sample_pair_whole_s21_q ? total_2[10:2] : 9'h0;
      whole_2_s22_q <= whole_2;
      and_539_s22_q <= sample_pair_whole_s21_q & select_538;
      so_s22_q <= so_s21_q;
      and_586_s22_q <= select_584[4] & select_585[3];
      equal_1479_s22_q <= equal_1479_s21_q;
      not_1480_s22_q <= not_1480_s21_q;
      shift_2_s22_q <= shift_2_s21_q[0];
      equal_1524_s22_q <= equal_1524_s21_q;
      all_s22_q <= all_s21_q;
      sum_1530_s22_q <= sum_1530_s21_q;
      equal_1532_s22_q <= equal_1532_s21_q;
      equal_1534_s22_q <= equal_1534_s21_q;
      equal_1536_s22_q <= equal_1536_s21_q;
      equal_1538_s22_q <= equal_1538_s21_q;
      equal_1540_s22_q <= equal_1540_s21_q;
      equal_1542_s22_q <= equal_1542_s21_q;
      equal_1544_s22_q <= equal_1544_s21_q;
      equal_1546_s22_q <= equal_1546_s21_q;
      less_1555_s22_q <= less_1555_s21_q;
      or_1559_s22_q <= or_1559_s21_q;
      equal_1579_s22_q <= (registration_fresh_q & select_1577_s21_q) == 4'h0;
      and_1589_s22_q <= not_1480_s21_q & and_1573;
      and_1592_s22_q <= and_1592_s21_q;
      select_1609_s22_q <= select_1609_s21_q;
      equal_1610_s22_q <= equal_1610_s21_q;
      and_1618_s22_q <= and_1618_s21_q;
      equal_1620_s22_q <= equal_1620_s21_q;
      equal_1641_s22_q <= equal_1641_s21_q;
      and_1652_s22_q <= and_1652;
      select_1666_s22_q <= select_1666_s21_q;
      select_1691_s22_q <= select_1691_s21_q;
      and_1698_s22_q <= and_1698_s21_q;
      and_1699_s22_q <= and_1699_s21_q;
      equal_1700_s22_q <= equal_1700_s21_q;
      equal_1702_s22_q <= equal_1702_s21_q;
      equal_1705_s22_q <= equal_1705_s21_q;
      or_1706_s22_q <= or_1706_s21_q;
      and_1715_s22_q <= and_1715_s21_q;
      select_1730_s22_q <= select_1730_s21_q;
      select_1736_s22_q <= select_1736_s21_q;
      select_1775_s22_q <= select_1775_s21_q;
      less_1791_s22_q <= less_1791_s21_q;
      new_row_s22_q <= new_row_s21_q;
      or_1804_s22_q <= or_1804_s21_q;
      of_row_2_s22_q <= of_row_2_s21_q;
      down_2_s22_q <= down_2_s21_q[1:0];
      sum_1817_s22_q <= sum_1817;
      smooth_s22_q <= smooth;
      and_1846_s22_q <= not_1701_s21_q & (not_1703_s21_q & and_1844_s21_q);
      and_1855_s22_q <= and_1855_s21_q;
      and_1860_s22_q <= not_1701_s21_q & (not_1703_s21_q & and_1858_s21_q);
      less_1861_s22_q <= less_1861_s21_q;
      equal_1862_s22_q <= equal_1862_s21_q;
      not_1863_s22_q <= not_1863_s21_q;
      equal_1864_s22_q <= equal_1864_s21_q;
      patches_rows_rdata_s22_q <= patches_rows_rdata_s21_q;
      or_1882_s22_q <= or_1882_s21_q;
      or_1885_s22_q <= or_1885_s21_q;
      or_1888_s22_q <= or_1888_s21_q;
      not_1890_s22_q <= not_1890_s21_q;
      regions_rdata_s22_q <= regions_rdata_q;
      textured_s22_q <= textured_s21_q;
      explained_s22_q <= explained_s21_q;
      and_1911_s22_q <= and_1911_s21_q;
      and_1916_s22_q <= and_1916_s21_q;
      difference_1966_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1965};
      or_1974_s22_q <= or_1974_s21_q;
      or_1977_s22_q <= or_1977_s21_q;
      or_1980_s22_q <= or_1980_s21_q;
      difference_2000_s22_q <= {1'b0, shown_2_s21_q} - {1'b0, select_1999};
      difference_2016_s22_q <= {1'b0, near_2_s21_q} - {1'b0, select_2015};
      and_2030_s22_q <= and_2030_s21_q;
      equal_2170_s22_q <= equal_2170_s21_q;
      equal_2294_s22_q <= equal_2294_s21_q;
      and_2419_s22_q <= and_2419;
      and_2423_s22_q <= and_2423_s21_q;
      and_2428_s22_q <= and_2428;
      not_2442_s22_q <= not_2442_s21_q;
      difference_2452_s22_q <= {1'b0, explained_2_s21_q} - {1'b0, select_2451};
      and_2534_s22_q <= and_2534_s21_q;
      and_2535_s22_q <= shift_2_s21_q[1] & less_1619_s21_q;
      residual_s22_q <= residual;
      equal_2626_s22_q <= (registration_fresh_q & select_2624) == 4'h0;
      and_2771_s22_q <= and_2771_s21_q;
      less_2898_s22_q <= less_2898_s21_q;
      equal_3241_s22_q <= patches_match_row_s21_q == 4'h0;
      select_3329_s22_q <= select_3329_s21_q;
      select_3336_s22_q <= select_3336;
      select_3345_s22_q <= select_3345;
      and_3351_s22_q <= equal_3325_s21_q & ({sum_3349[6], sum_3349} < 8'hfb);
      select_3360_s22_q <= select_3360_s21_q;
      equal_3481_s22_q <= equal_3481;
      and_3710_s22_q <= equal_3709_s21_q & equal_3481;
      equal_3728_s22_q <= equal_3728;
      equal_3730_s22_q <= equal_3730_s21_q;
      equal_3731_s22_q <= equal_3731_s21_q;
      equal_3753_s22_q <= (limit & select_3751) == 8'h0;
      of_s22_q <= of;
      equal_3860_s22_q <= equal_3860_s21_q;
      equal_3952_s22_q <= (registration_fresh_q & select_3950) == 4'h0;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  logic [6:0] segment_textured_q;
  logic [6:0] segment_explained_q;
  logic [6:0] segment_nearer_q;
  logic [13:0] product_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [4:0] box_explained_sum_sums_values_0_q;
  logic [4:0] box_shown_sum_sums_values_0_q;
  logic [4:0] box_nearer_sum_sums_values_0_q;
  logic [12:0] rows_passed_q;
  logic [8:0] columns_passed_q;
  logic line_ended_q;
  // hls/stages/census.hpp:294
  logic less_555;
  assign less_555 = census_memory_rdata_s22_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_556;
  assign less_556 = census_memory_rdata_s22_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_557;
  assign less_557 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_558;
  assign less_558 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_559;
  assign less_559 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_560;
  assign less_560 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_561;
  assign less_561 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_562;
  assign less_562 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_563;
  assign less_563 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_564;
  assign less_564 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_565;
  assign less_565 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_566;
  assign less_566 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_567;
  assign less_567 = census_memory_rdata_s22_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_568;
  assign less_568 = census_memory_rdata_s22_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_569;
  assign less_569 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_570;
  assign less_570 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_571;
  assign less_571 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_572;
  assign less_572 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_573;
  assign less_573 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_574;
  assign less_574 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_575;
  assign less_575 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_576;
  assign less_576 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_577;
  assign less_577 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_578;
  assign less_578 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:286
  logic and_588;
  assign and_588 = census_memory_rdata_s22_q[38] & (census_memory_rdata_s22_q[18] & whole_2_s22_q);
  logic and_590;
  assign and_590 = census_memory_rdata_s22_q[77] & (census_memory_rdata_s22_q[58] & and_588);
  // hls/stages/census.hpp:270
  logic [9:0] difference_613;
  assign difference_613 = {1'b0, select_527_s22_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_616;
  assign difference_616 = {1'b0, census_memory_rdata_s22_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_620;
  assign difference_620 = {1'b0, census_memory_rdata_s22_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_624;
  assign difference_624 = {1'b0, census_memory_rdata_s22_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_628;
  assign difference_628 = {1'b0, census_memory_rdata_s22_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/agreement.hpp:776
  logic and_1656;
  assign and_1656 = not_1480_s22_q & (so_s22_q & (ends_cell_s22_q & (shift_2_s22_q & and_1652_s22_q)));
  logic [7:0] select_1661;
  assign select_1661 = so_s22_q ? (ends_cell_s22_q ? (shift_2_s22_q ? x_s22_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:466
  logic [13:0] sum_1818;
  assign sum_1818 = {{3{patches_down_values_1_s22_q[10]}}, patches_down_values_1_s22_q} + {sum_1817_s22_q, down_2_s22_q[1]};
  logic [12:0] sum_1819;
  assign sum_1819 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1818[13:1];
  // hls/stages/patches.hpp:465
  logic [12:0] sum_1828;
  assign sum_1828 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s22_q[11:1]};
  logic [12:0] sum_1829;
  assign sum_1829 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1830;
  assign difference_1830 = {1'b0, sum_1828, smooth_s22_q[0]} - {1'b0, sum_1829, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:879
  logic [6:0] select_1901;
  assign select_1901 = segment_started_s22_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:880
  logic [6:0] sum_1902;
  assign sum_1902 = {6'h0, textured_s22_q} + select_1901;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_1904;
  assign sum_1904 = {3'h0, sum_1902} + (region_fresh_s22_q ? 10'h0 : regions_rdata_s22_q[9:0]);
  // hls/stages/agreement.hpp:879
  logic [6:0] select_1906;
  assign select_1906 = segment_started_s22_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:880
  logic [6:0] sum_1907;
  assign sum_1907 = {6'h0, explained_s22_q} + select_1906;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_1909;
  assign sum_1909 = {3'h0, sum_1907} + (region_fresh_s22_q ? 10'h0 : regions_rdata_s22_q[19:10]);
  // hls/stages/agreement.hpp:879
  logic [6:0] select_1912;
  assign select_1912 = segment_started_s22_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:881
  logic [6:0] sum_1913;
  assign sum_1913 = {6'h0, and_1911_s22_q} + select_1912;
  // hls/stages/agreement.hpp:1018
  logic [9:0] sum_1915;
  assign sum_1915 = {3'h0, sum_1913} + (region_fresh_s22_q ? 10'h0 : regions_rdata_s22_q[29:20]);
  // hls/stages/agreement.hpp:1216
  logic or_1925;
  assign or_1925 = marks_first_s22_q | line_ended_q;
  // hls/stages/agreement.hpp:1218
  logic [12:0] select_1927;
  assign select_1927 = marks_first_s22_q ? 13'h1 : (or_1925 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1217
  logic [8:0] select_1929;
  assign select_1929 = or_1925 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1225
  logic select_1931;
  assign select_1931 = cfg_compete_i ? (or_1925 & select_1927[12]) : (select_1929[8] & select_1927[9]);
  // hls/stages/agreement.hpp:1049
  logic [4:0] t;
  assign t = {difference_1966_s22_q[3], difference_1966_s22_q} + (equal_1641_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1051
  logic [4:0] around;
  assign around = {difference_2000_s22_q[3], difference_2000_s22_q} + (equal_1641_s22_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1052
  logic [4:0] n;
  assign n = {difference_2016_s22_q[3], difference_2016_s22_q} + (equal_1641_s22_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:267
  logic [8:0] select_2054;
  assign select_2054 = sample_pair_whole_s22_q ? (and_519_s22_q ? grey_s22_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2056;
  assign select_2056 = sample_pair_whole_s22_q ? (and_519_s22_q ? grey_2_s22_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2058;
  assign select_2058 = sample_pair_whole_s22_q ? (and_519_s22_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2060;
  assign select_2060 = sample_pair_whole_s22_q ? (and_519_s22_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2065;
  assign sum_2065 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s22_q};
  logic [9:0] sum_2073;
  assign sum_2073 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s22_q};
  // hls/stages/agreement.hpp:511
  logic [8:0] select_2088;
  assign select_2088 = and_521_s22_q ? select_527_s22_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2089;
  assign select_2089 = and_521_s22_q ? select_531_s22_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2091;
  assign select_2091 = and_521_s22_q ? census_memory_rdata_s22_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2092;
  assign select_2092 = and_521_s22_q ? census_memory_rdata_s22_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2093;
  assign select_2093 = and_521_s22_q ? census_memory_rdata_s22_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2094;
  assign select_2094 = and_521_s22_q ? census_memory_rdata_s22_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2095;
  assign select_2095 = and_521_s22_q ? census_memory_rdata_s22_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2096;
  assign select_2096 = and_521_s22_q ? census_memory_rdata_s22_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2097;
  assign select_2097 = and_521_s22_q ? census_memory_rdata_s22_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2098;
  assign select_2098 = and_521_s22_q ? census_memory_rdata_s22_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2099;
  assign select_2099 = and_521_s22_q ? census_memory_rdata_s22_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2100;
  assign select_2100 = and_521_s22_q ? census_memory_rdata_s22_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2101;
  assign select_2101 = and_521_s22_q ? census_memory_rdata_s22_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2102;
  assign select_2102 = and_521_s22_q ? census_memory_rdata_s22_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2103;
  assign select_2103 = and_521_s22_q ? census_memory_rdata_s22_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2104;
  assign select_2104 = and_521_s22_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2105;
  assign select_2105 = and_521_s22_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2107;
  assign select_2107 = and_521_s22_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2108;
  assign select_2108 = and_521_s22_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2110;
  assign select_2110 = and_521_s22_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2111;
  assign select_2111 = and_521_s22_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2113;
  assign select_2113 = and_521_s22_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2114;
  assign select_2114 = and_521_s22_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2115;
  assign select_2115 = and_521_s22_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2117;
  assign select_2117 = and_521_s22_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2118;
  assign select_2118 = and_521_s22_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2120;
  assign select_2120 = and_521_s22_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2121;
  assign select_2121 = and_521_s22_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2123;
  assign select_2123 = and_521_s22_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2124;
  assign select_2124 = and_521_s22_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2126;
  assign select_2126 = and_521_s22_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2127;
  assign select_2127 = and_521_s22_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2129;
  assign select_2129 = and_521_s22_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2130;
  assign select_2130 = and_521_s22_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2132;
  assign select_2132 = and_521_s22_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2133;
  assign select_2133 = and_521_s22_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2136;
  assign select_2136 = and_521_s22_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2137;
  assign select_2137 = and_521_s22_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2140;
  assign select_2140 = and_521_s22_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2141;
  assign select_2141 = and_521_s22_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2145;
  assign difference_2145 = {1'b0, select_531_s22_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2148;
  assign difference_2148 = {1'b0, census_memory_rdata_s22_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2152;
  assign difference_2152 = {1'b0, census_memory_rdata_s22_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2156;
  assign difference_2156 = {1'b0, census_memory_rdata_s22_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2160;
  assign difference_2160 = {1'b0, census_memory_rdata_s22_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2191;
  assign difference_2191 = {1'b0, select_527_s22_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2203;
  assign difference_2203 = {1'b0, select_531_s22_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:776
  logic and_2433;
  assign and_2433 = not_1480_s22_q & (so_s22_q & (ends_cell_s22_q & explained_s22_q));
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2435;
  assign select_2435 = and_2419_s22_q ? 14'h0 : (counts_explained_q + {13'h0, and_2433});
  // hls/stages/agreement.hpp:776
  logic and_2438;
  assign and_2438 = not_1480_s22_q & (so_s22_q & (ends_cell_s22_q & and_1911_s22_q));
  // hls/stages/agreement.hpp:1050
  logic [4:0] e;
  assign e = {difference_2452_s22_q[3], difference_2452_s22_q} + (equal_1641_s22_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1087
  logic less_2467;
  assign less_2467 = region_row_s22_q < x_s22_q[5:3];
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2567;
  assign difference_2567 = 13'h0 - {residual_s22_q[11], residual_s22_q};
  logic less_2582;
  assign less_2582 = $signed(difference_2567) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:184
  logic [11:0] select_2864;
  assign select_2864 = equal_1702_s22_q ? patches_smooth_values_0_q : (or_1706_s22_q ? smooth_s22_q : patches_smooth_values_0_q);
  logic [11:0] select_2866;
  assign select_2866 = or_1706_s22_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2868;
  assign select_2868 = equal_1700_s22_q ? patches_smooth_values_1_q : (equal_1702_s22_q ? patches_smooth_values_1_q : select_2866);
  logic [11:0] select_2869;
  assign select_2869 = or_1706_s22_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2871;
  assign select_2871 = equal_1700_s22_q ? patches_smooth_values_2_q : (equal_1702_s22_q ? patches_smooth_values_2_q : select_2869);
  logic [11:0] select_2872;
  assign select_2872 = or_1706_s22_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2874;
  assign select_2874 = equal_1700_s22_q ? patches_smooth_values_3_q : (equal_1702_s22_q ? patches_smooth_values_3_q : select_2872);
  logic [10:0] select_2881;
  assign select_2881 = or_1706_s22_q ? patches_down_values_1_s22_q : patches_down_values_2_q;
  logic [10:0] select_2883;
  assign select_2883 = equal_1700_s22_q ? patches_down_values_2_q : (equal_1702_s22_q ? patches_down_values_2_q : select_2881);
  logic [10:0] select_2884;
  assign select_2884 = or_1706_s22_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_2886;
  assign select_2886 = equal_1700_s22_q ? patches_down_values_3_q : (equal_1702_s22_q ? patches_down_values_3_q : select_2884);
  // hls/stages/patches.hpp:555
  logic select_3338;
  assign select_3338 = less_1861_s22_q ? (not_1863_s22_q & select_3336_s22_q) : select_3336_s22_q;
  logic select_3347;
  assign select_3347 = less_1861_s22_q ? (not_1863_s22_q & select_3345_s22_q) : select_3345_s22_q;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3353;
  assign select_3353 = less_1861_s22_q ? (and_3351_s22_q ? patches_rows_rdata_s22_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3364;
  assign select_3364 = patches_read_above_q ? patches_read_row_differing_s22_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3366;
  assign select_3366 = patches_read_below_q ? patches_read_row_differing_s22_q : patches_peak_below_q;
  // hls/stages/patches.hpp:574
  logic less_3403;
  assign less_3403 = select_3364 < select_3366;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_3403 ? select_3366 : select_3364;
  logic [9:0] low;
  assign low = (select_3366 < select_3364) ? select_3366 : select_3364;
  // hls/stages/agreement.hpp:1174
  logic [13:0] select_3742;
  assign select_3742 = equal_3481_s22_q ? 14'h0 : product_q;
  logic [13:0] select_3757;
  assign select_3757 = equal_3753_s22_q ? 14'h0 : of_s22_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3742} + {1'b0, select_3757};
  // hls/stages/agreement.hpp:776
  logic [4:0] select_3791;
  assign select_3791 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_3792;
  assign select_3792 = equal_1479_s22_q ? box_textured_sum_sums_values_0_q : select_3791;
  logic [4:0] select_3809;
  assign select_3809 = so_s22_q ? (ends_cell_s22_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3810;
  assign select_3810 = equal_1479_s22_q ? box_explained_sum_sums_values_0_q : select_3809;
  logic [4:0] select_3827;
  assign select_3827 = so_s22_q ? (ends_cell_s22_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_3845;
  assign select_3845 = so_s22_q ? (ends_cell_s22_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s22_q;
  logic census_memory_we;
  assign census_memory_we = s22_en & and_521_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s22_q[58:40], census_memory_rdata_s22_q[38:0], and_539_s22_q, whole_2_s22_q, select_531_s22_q, select_527_s22_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s21_sim;
  logic census_memory_re_s21_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s21_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s21_sim <= census_memory_re;
      census_memory_raddr_s21_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s21_sim && census_memory_raddr_s21_sim == census_memory_waddr) begin
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
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s22_en) begin
      counts_explained_q <= select_2435;
      patches_smooth_values_0_q <= equal_1700_s22_q ? patches_smooth_values_0_q : select_2864;
      patches_smooth_values_1_q <= select_2868;
      patches_smooth_values_2_q <= select_2871;
      patches_smooth_values_3_q <= select_2874;
      patches_down_values_2_q <= select_2883;
      patches_down_values_3_q <= select_2886;
      patches_read_above_q <= equal_1700_s22_q ? select_3338 : patches_read_above_q;
      patches_read_below_q <= equal_1700_s22_q ? select_3347 : patches_read_below_q;
      patches_peak_above_q <= equal_1700_s22_q ? select_3364 : patches_peak_above_q;
      patches_peak_below_q <= equal_1700_s22_q ? select_3366 : patches_peak_below_q;
      segment_textured_q <= select_1901 + {6'h0, and_2428_s22_q};
      segment_explained_q <= select_1906 + {6'h0, and_2433};
      segment_nearer_q <= select_1912 + {6'h0, and_2438};
      product_q <= equal_1479_s22_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_1927;
      columns_passed_q <= {select_1929[7:0], or_1925};
      line_ended_q <= marks_last_s22_q;
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
    box_textured_sum_sums_values_0_q = 5'h0;
    box_explained_sum_sums_values_0_q = 5'h0;
    box_shown_sum_sums_values_0_q = 5'h0;
    box_nearer_sum_sums_values_0_q = 5'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s22_en) begin
      averager_quarter_1_0_q <= select_2054;
      averager_quarter_1_1_q <= select_2056;
      averager_quarter_2_0_q <= select_2058;
      averager_quarter_2_1_q <= select_2060;
      census_columns_values_0_cell_0_left_q <= select_2088;
      census_columns_values_0_cell_0_right_q <= select_2089;
      census_columns_values_0_cell_1_left_q <= select_2091;
      census_columns_values_0_cell_1_right_q <= select_2092;
      census_columns_values_0_cell_1_mask_q <= select_2093;
      census_columns_values_0_cell_2_left_q <= select_2094;
      census_columns_values_0_cell_2_right_q <= select_2095;
      census_columns_values_0_cell_2_mask_q <= select_2096;
      census_columns_values_0_cell_2_of_skin_q <= select_2097;
      census_columns_values_0_cell_3_left_q <= select_2098;
      census_columns_values_0_cell_3_right_q <= select_2099;
      census_columns_values_0_cell_3_mask_q <= select_2100;
      census_columns_values_0_cell_4_left_q <= select_2101;
      census_columns_values_0_cell_4_right_q <= select_2102;
      census_columns_values_0_cell_4_mask_q <= select_2103;
      census_columns_values_1_cell_0_left_q <= select_2104;
      census_columns_values_1_cell_0_right_q <= select_2105;
      census_columns_values_1_cell_1_left_q <= select_2107;
      census_columns_values_1_cell_1_right_q <= select_2108;
      census_columns_values_1_cell_2_left_q <= select_2110;
      census_columns_values_1_cell_2_right_q <= select_2111;
      census_columns_values_1_cell_2_of_skin_q <= select_2113;
      census_columns_values_1_cell_3_left_q <= select_2114;
      census_columns_values_1_cell_3_right_q <= select_2115;
      census_columns_values_1_cell_4_left_q <= select_2117;
      census_columns_values_1_cell_4_right_q <= select_2118;
      census_columns_values_2_cell_0_left_q <= select_2120;
      census_columns_values_2_cell_0_right_q <= select_2121;
      census_columns_values_2_cell_1_left_q <= select_2123;
      census_columns_values_2_cell_1_right_q <= select_2124;
      census_columns_values_2_cell_2_left_q <= select_2126;
      census_columns_values_2_cell_2_right_q <= select_2127;
      census_columns_values_2_cell_3_left_q <= select_2129;
      census_columns_values_2_cell_3_right_q <= select_2130;
      census_columns_values_2_cell_4_left_q <= select_2132;
      census_columns_values_2_cell_4_right_q <= select_2133;
      census_columns_values_3_cell_1_left_q <= select_2136;
      census_columns_values_3_cell_1_right_q <= select_2137;
      census_columns_values_3_cell_3_left_q <= select_2140;
      census_columns_values_3_cell_3_right_q <= select_2141;
      sharpness_last_mean_0_q <= and_521_s22_q ? select_527_s22_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_521_s22_q ? select_531_s22_q : sharpness_last_mean_1_q;
      box_textured_sum_sums_values_0_q <= select_3792;
      box_explained_sum_sums_values_0_q <= select_3810;
      box_shown_sum_sums_values_0_q <= equal_1479_s22_q ? box_shown_sum_sums_values_0_q : select_3827;
      box_nearer_sum_sums_values_0_q <= equal_1479_s22_q ? box_nearer_sum_sums_values_0_q : select_3845;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic [7:0] sample_pair_pixel_0_s23_q;
  logic [7:0] sample_pair_pixel_1_s23_q;
  logic sample_pair_whole_s23_q;
  logic sample_present_s23_q;
  logic census_columns_values_0_cell_1_mask_s23_q;
  logic census_columns_values_0_cell_2_mask_s23_q;
  logic census_columns_values_0_cell_3_mask_s23_q;
  logic census_columns_values_0_cell_4_mask_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic [7:0] x_s23_q;
  logic [2:0] slot_s23_q;
  logic ends_cell_s23_q;
  logic lower_half_s23_q;
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
  logic [2:0] region_row_s23_q;
  logic [13:0] product_s23_q;
  logic centres_values_1_textured_s23_q;
  logic centres_values_1_of_skin_s23_q;
  logic [3:0] select_482_s23_q;
  logic [6:0] select_485_s23_q;
  logic [6:0] column_s23_q;
  logic and_519_s23_q;
  logic and_521_s23_q;
  logic equal_524_s23_q;
  logic whole_2_s23_q;
  logic so_s23_q;
  logic less_555_s23_q;
  logic less_556_s23_q;
  logic less_557_s23_q;
  logic less_558_s23_q;
  logic less_559_s23_q;
  logic less_560_s23_q;
  logic less_561_s23_q;
  logic less_562_s23_q;
  logic less_563_s23_q;
  logic less_564_s23_q;
  logic less_565_s23_q;
  logic less_566_s23_q;
  logic less_567_s23_q;
  logic less_568_s23_q;
  logic less_569_s23_q;
  logic less_570_s23_q;
  logic less_571_s23_q;
  logic less_572_s23_q;
  logic less_573_s23_q;
  logic less_574_s23_q;
  logic less_575_s23_q;
  logic less_576_s23_q;
  logic less_577_s23_q;
  logic less_578_s23_q;
  logic and_586_s23_q;
  logic and_590_s23_q;
  logic difference_613_s23_q;
  logic [8:0] xor_614_s23_q;
  logic difference_616_s23_q;
  logic [8:0] xor_617_s23_q;
  logic difference_620_s23_q;
  logic [8:0] xor_621_s23_q;
  logic difference_624_s23_q;
  logic [8:0] xor_625_s23_q;
  logic difference_628_s23_q;
  logic [8:0] xor_629_s23_q;
  logic equal_1479_s23_q;
  logic not_1480_s23_q;
  logic equal_1524_s23_q;
  logic all_s23_q;
  logic [1:0] sum_1530_s23_q;
  logic equal_1532_s23_q;
  logic equal_1534_s23_q;
  logic equal_1536_s23_q;
  logic equal_1538_s23_q;
  logic equal_1540_s23_q;
  logic equal_1542_s23_q;
  logic equal_1544_s23_q;
  logic equal_1546_s23_q;
  logic less_1555_s23_q;
  logic or_1559_s23_q;
  logic [31:0] registration_sums_rdata_s23_q;
  logic equal_1579_s23_q;
  logic and_1589_s23_q;
  logic and_1592_s23_q;
  logic select_1609_s23_q;
  logic equal_1610_s23_q;
  logic [22:0] patches_choices_rdata_s23_q;
  logic and_1618_s23_q;
  logic equal_1620_s23_q;
  logic and_1656_s23_q;
  logic [7:0] select_1662_s23_q;
  logic [5:0] select_1666_s23_q;
  logic [7:0] select_1691_s23_q;
  logic and_1698_s23_q;
  logic and_1699_s23_q;
  logic equal_1700_s23_q;
  logic equal_1702_s23_q;
  logic equal_1705_s23_q;
  logic or_1706_s23_q;
  logic and_1715_s23_q;
  logic [4:0] select_1730_s23_q;
  logic select_1736_s23_q;
  logic [3:0] select_1775_s23_q;
  logic less_1791_s23_q;
  logic new_row_s23_q;
  logic or_1804_s23_q;
  logic [27:0] patches_right_codes_rdata_s23_q;
  logic [1:0] of_row_2_s23_q;
  logic down_2_s23_q;
  logic sum_1818_s23_q;
  logic [12:0] sum_1819_s23_q;
  logic [14:0] difference_1830_s23_q;
  logic and_1846_s23_q;
  logic [47:0] patches_left_codes_rdata_s23_q;
  logic and_1855_s23_q;
  logic and_1860_s23_q;
  logic less_1861_s23_q;
  logic equal_1862_s23_q;
  logic not_1863_s23_q;
  logic equal_1864_s23_q;
  logic or_1882_s23_q;
  logic or_1885_s23_q;
  logic or_1888_s23_q;
  logic not_1890_s23_q;
  logic [9:0] sum_1904_s23_q;
  logic [9:0] sum_1909_s23_q;
  logic [9:0] sum_1915_s23_q;
  logic and_1916_s23_q;
  logic select_1931_s23_q;
  logic [4:0] t_s23_q;
  logic or_1974_s23_q;
  logic or_1977_s23_q;
  logic or_1980_s23_q;
  logic [4:0] around_s23_q;
  logic less_2019_s23_q;
  logic and_2030_s23_q;
  logic sum_2065_s23_q;
  logic [9:0] difference_2066_s23_q;
  logic sum_2073_s23_q;
  logic [9:0] difference_2074_s23_q;
  logic difference_2145_s23_q;
  logic [8:0] xor_2146_s23_q;
  logic difference_2148_s23_q;
  logic [8:0] xor_2149_s23_q;
  logic difference_2152_s23_q;
  logic [8:0] xor_2153_s23_q;
  logic difference_2156_s23_q;
  logic [8:0] xor_2157_s23_q;
  logic difference_2160_s23_q;
  logic [8:0] xor_2161_s23_q;
  logic equal_2170_s23_q;
  logic difference_2191_s23_q;
  logic [8:0] xor_2192_s23_q;
  logic difference_2203_s23_q;
  logic [8:0] xor_2204_s23_q;
  logic equal_2294_s23_q;
  logic and_2419_s23_q;
  logic and_2423_s23_q;
  logic and_2438_s23_q;
  logic not_2442_s23_q;
  logic [4:0] e_s23_q;
  logic [9:0] select_2468_s23_q;
  logic [9:0] select_2471_s23_q;
  logic and_2534_s23_q;
  logic and_2535_s23_q;
  logic [7:0] residual_s23_q;
  logic less_2568_s23_q;
  logic less_2582_s23_q;
  logic equal_2626_s23_q;
  logic and_2771_s23_q;
  logic less_2898_s23_q;
  logic equal_3241_s23_q;
  logic [4:0] select_3329_s23_q;
  logic [9:0] select_3353_s23_q;
  logic [14:0] select_3360_s23_q;
  logic less_3403_s23_q;
  logic [9:0] high_s23_q;
  logic [9:0] low_s23_q;
  logic equal_3481_s23_q;
  logic and_3710_s23_q;
  logic less_3711_s23_q;
  logic equal_3712_s23_q;
  logic equal_3728_s23_q;
  logic equal_3730_s23_q;
  logic equal_3731_s23_q;
  logic sum_4_s23_q;
  logic equal_3860_s23_q;
  logic equal_3952_s23_q;
  logic [9:0] select_3962_s23_q;
  always_ff @(posedge clk_i) begin
    if (s22_en) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      sample_pair_pixel_0_s23_q <= sample_pair_pixel_0_s22_q;
      sample_pair_pixel_1_s23_q <= sample_pair_pixel_1_s22_q;
      sample_pair_whole_s23_q <= sample_pair_whole_s22_q;
      sample_present_s23_q <= sample_present_s22_q;
      census_columns_values_0_cell_1_mask_s23_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s23_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s23_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s23_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s23_q <= x_s22_q;
      slot_s23_q <= slot_s22_q;
      ends_cell_s23_q <= ends_cell_s22_q;
      lower_half_s23_q <= lower_half_s22_q;
      counts_textured_s23_q <= counts_textured_s22_q;
      counts_explained_s23_q <= counts_explained_q;
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
      region_row_s23_q <= region_row_s22_q;
      product_s23_q <= product_q;
      centres_values_1_textured_s23_q <= centres_values_1_textured_s22_q;
      centres_values_1_of_skin_s23_q <= centres_values_1_of_skin_s22_q;
      select_482_s23_q <= select_482_s22_q;
      select_485_s23_q <= select_485_s22_q;
      column_s23_q <= column_s22_q;
      and_519_s23_q <= and_519_s22_q;
      and_521_s23_q <= and_521_s22_q;
      equal_524_s23_q <= equal_524_s22_q;
      whole_2_s23_q <= whole_2_s22_q;
      so_s23_q <= so_s22_q;
      less_555_s23_q <= less_555;
      less_556_s23_q <= less_556;
      less_557_s23_q <= less_557;
      less_558_s23_q <= less_558;
      less_559_s23_q <= less_559;
      less_560_s23_q <= less_560;
      less_561_s23_q <= less_561;
      less_562_s23_q <= less_562;
      less_563_s23_q <= less_563;
      less_564_s23_q <= less_564;
      less_565_s23_q <= less_565;
      less_566_s23_q <= less_566;
      less_567_s23_q <= less_567;
      less_568_s23_q <= less_568;
      less_569_s23_q <= less_569;
      less_570_s23_q <= less_570;
      less_571_s23_q <= less_571;
      less_572_s23_q <= less_572;
      less_573_s23_q <= less_573;
      less_574_s23_q <= less_574;
      less_575_s23_q <= less_575;
      less_576_s23_q <= less_576;
      less_577_s23_q <= less_577;
      less_578_s23_q <= less_578;
      and_586_s23_q <= and_586_s22_q;
      and_590_s23_q <= and_590;
      difference_613_s23_q <= difference_613[9];
      xor_614_s23_q <= difference_613[8:0] ^ {9{difference_613[9]}};
      difference_616_s23_q <= difference_616[9];
      xor_617_s23_q <= difference_616[8:0] ^ {9{difference_616[9]}};
      difference_620_s23_q <= difference_620[9];
      xor_621_s23_q <= difference_620[8:0] ^ {9{difference_620[9]}};
      difference_624_s23_q <= difference_624[9];
      xor_625_s23_q <= difference_624[8:0] ^ {9{difference_624[9]}};
      difference_628_s23_q <= difference_628[9];
      xor_629_s23_q <= difference_628[8:0] ^ {9{difference_628[9]}};
      equal_1479_s23_q <= equal_1479_s22_q;
      not_1480_s23_q <= not_1480_s22_q;
      equal_1524_s23_q <= equal_1524_s22_q;
      all_s23_q <= all_s22_q;
      sum_1530_s23_q <= sum_1530_s22_q;
      equal_1532_s23_q <= equal_1532_s22_q;
      equal_1534_s23_q <= equal_1534_s22_q;
      equal_1536_s23_q <= equal_1536_s22_q;
      equal_1538_s23_q <= equal_1538_s22_q;
      equal_1540_s23_q <= equal_1540_s22_q;
      equal_1542_s23_q <= equal_1542_s22_q;
      equal_1544_s23_q <= equal_1544_s22_q;
      equal_1546_s23_q <= equal_1546_s22_q;
      less_1555_s23_q <= less_1555_s22_q;
      or_1559_s23_q <= or_1559_s22_q;
      registration_sums_rdata_s23_q <= registration_sums_rdata_q;
      equal_1579_s23_q <= equal_1579_s22_q;
      and_1589_s23_q <= and_1589_s22_q;
      and_1592_s23_q <= and_1592_s22_q;
      select_1609_s23_q <= select_1609_s22_q;
      equal_1610_s23_q <= equal_1610_s22_q;
      patches_choices_rdata_s23_q <= patches_choices_rdata_q;
      and_1618_s23_q <= and_1618_s22_q;
      equal_1620_s23_q <= equal_1620_s22_q;
      and_1656_s23_q <= and_1656;
      select_1662_s23_q <= equal_1479_s22_q ? 8'h0 : select_1661;
      select_1666_s23_q <= select_1666_s22_q;
      select_1691_s23_q <= select_1691_s22_q;
      and_1698_s23_q <= and_1698_s22_q;
      and_1699_s23_q <= and_1699_s22_q;
      equal_1700_s23_q <= equal_1700_s22_q;
      equal_1702_s23_q <= equal_1702_s22_q;
      equal_1705_s23_q <= equal_1705_s22_q;
      or_1706_s23_q <= or_1706_s22_q;
      and_1715_s23_q <= and_1715_s22_q;
      select_1730_s23_q <= select_1730_s22_q;
      select_1736_s23_q <= select_1736_s22_q;
      select_1775_s23_q <= select_1775_s22_q;
      less_1791_s23_q <= less_1791_s22_q;
      new_row_s23_q <= new_row_s22_q;
      or_1804_s23_q <= or_1804_s22_q;
      patches_right_codes_rdata_s23_q <= patches_right_codes_rdata_q;
      of_row_2_s23_q <= of_row_2_s22_q;
      down_2_s23_q <= down_2_s22_q[0];
      sum_1818_s23_q <= sum_1818[0];
      sum_1819_s23_q <= sum_1819;
      difference_1830_s23_q <= difference_1830;
      and_1846_s23_q <= and_1846_s22_q;
      patches_left_codes_rdata_s23_q <= patches_left_codes_rdata_q;
      and_1855_s23_q <= and_1855_s22_q;
      and_1860_s23_q <= and_1860_s22_q;
      less_1861_s23_q <= less_1861_s22_q;
      equal_1862_s23_q <= equal_1862_s22_q;
      not_1863_s23_q <= not_1863_s22_q;
      equal_1864_s23_q <= equal_1864_s22_q;
      or_1882_s23_q <= or_1882_s22_q;
      or_1885_s23_q <= or_1885_s22_q;
      or_1888_s23_q <= or_1888_s22_q;
      not_1890_s23_q <= not_1890_s22_q;
      sum_1904_s23_q <= sum_1904;
      sum_1909_s23_q <= sum_1909;
      sum_1915_s23_q <= sum_1915;
      and_1916_s23_q <= and_1916_s22_q;
      select_1931_s23_q <= select_1931;
      t_s23_q <= t;
      or_1974_s23_q <= or_1974_s22_q;
      or_1977_s23_q <= or_1977_s22_q;
      or_1980_s23_q <= or_1980_s22_q;
      around_s23_q <= around;
      less_2019_s23_q <= {1'b0, around[4:1]} < n;
      and_2030_s23_q <= and_2030_s22_q;
      sum_2065_s23_q <= sum_2065[0];
      difference_2066_s23_q <= {1'b0, sum_2065[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2073_s23_q <= sum_2073[0];
      difference_2074_s23_q <= {1'b0, sum_2073[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2145_s23_q <= difference_2145[9];
      xor_2146_s23_q <= difference_2145[8:0] ^ {9{difference_2145[9]}};
      difference_2148_s23_q <= difference_2148[9];
      xor_2149_s23_q <= difference_2148[8:0] ^ {9{difference_2148[9]}};
      difference_2152_s23_q <= difference_2152[9];
      xor_2153_s23_q <= difference_2152[8:0] ^ {9{difference_2152[9]}};
      difference_2156_s23_q <= difference_2156[9];
      xor_2157_s23_q <= difference_2156[8:0] ^ {9{difference_2156[9]}};
      difference_2160_s23_q <= difference_2160[9];
      xor_2161_s23_q <= difference_2160[8:0] ^ {9{difference_2160[9]}};
      equal_2170_s23_q <= equal_2170_s22_q;
      difference_2191_s23_q <= difference_2191[9];
      xor_2192_s23_q <= difference_2191[8:0] ^ {9{difference_2191[9]}};
      difference_2203_s23_q <= difference_2203[9];
      xor_2204_s23_q <= difference_2203[8:0] ^ {9{difference_2203[9]}};
      equal_2294_s23_q <= equal_2294_s22_q;
      and_2419_s23_q <= and_2419_s22_q;
      and_2423_s23_q <= and_2423_s22_q;
      and_2438_s23_q <= and_2438;
      not_2442_s23_q <= not_2442_s22_q;
      e_s23_q <= e;
      select_2468_s23_q <= less_2467 ? 10'h0 : regions_rdata_s22_q[9:0];
      select_2471_s23_q <= less_2467 ? 10'h0 : regions_rdata_s22_q[19:10];
      and_2534_s23_q <= and_2534_s22_q;
      and_2535_s23_q <= and_2535_s22_q;
      residual_s23_q <= residual_s22_q[7:0];
      less_2568_s23_q <= $signed(difference_2567) < $signed({7'h0, cfg_moved_limit_i});
      less_2582_s23_q <= less_2582;
      equal_2626_s23_q <= equal_2626_s22_q;
      and_2771_s23_q <= and_2771_s22_q;
      less_2898_s23_q <= less_2898_s22_q;
      equal_3241_s23_q <= equal_3241_s22_q;
      select_3329_s23_q <= select_3329_s22_q;
      select_3353_s23_q <= select_3353;
      select_3360_s23_q <= select_3360_s22_q;
      less_3403_s23_q <= less_3403;
      high_s23_q <= high;
      low_s23_q <= low;
      equal_3481_s23_q <= equal_3481_s22_q;
      and_3710_s23_q <= and_3710_s22_q;
      less_3711_s23_q <= counts_explained_q < product_q;
      equal_3712_s23_q <= counts_explained_q == product_q;
      equal_3728_s23_q <= equal_3728_s22_q;
      equal_3730_s23_q <= equal_3730_s22_q;
      equal_3731_s23_q <= equal_3731_s22_q;
      sum_4_s23_q <= sum_4[0];
      equal_3860_s23_q <= equal_3860_s22_q;
      equal_3952_s23_q <= equal_3952_s22_q;
      select_3962_s23_q <= less_2467 ? 10'h0 : regions_rdata_s22_q[29:20];
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic [13:0] counts_supervised_q;
  logic [13:0] counts_nearer_q;
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [7:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
  logic [9:0] patches_read_far_q;
  logic product_rest_q;
  logic disagree_q;
  logic began_q;
  logic [3:0] seen_x_q;
  logic [3:0] seen_y_q;
  logic [7:0] seen_column_q;
  logic [7:0] seen_rows_left_q;
  logic at_cell_end_q;
  logic was_next_row_q;
  logic [12:0] seen_base_q;
  // hls/stages/agreement.hpp:447
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_590_s23_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s23_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s23_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s23_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s23_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:270
  logic [9:0] sum_615;
  assign sum_615 = {9'h0, difference_613_s23_q} + {1'b0, xor_614_s23_q};
  logic [9:0] sum_618;
  assign sum_618 = {9'h0, difference_616_s23_q} + {1'b0, xor_617_s23_q};
  // hls/stages/patches.hpp:156
  logic and_1658;
  assign and_1658 = and_1656_s23_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:342
  logic [22:0] select_1692;
  assign select_1692 = and_1658 ? {select_1691_s23_q, select_1666_s23_q, select_1662_s23_q, and_1656_s23_q} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:466
  logic [14:0] sum_1820;
  assign sum_1820 = {{4{patches_down_values_3_s23_q[10]}}, patches_down_values_3_s23_q} + {sum_1819_s23_q, sum_1818_s23_q, down_2_s23_q};
  // hls/stages/agreement.hpp:426
  logic next_row;
  assign next_row = select_1931_s23_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1232
  logic [6:0] select_1934;
  assign select_1934 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1242
  logic equal_1937;
  assign equal_1937 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1215
  logic not_1944;
  assign not_1944 = ~marks_first_s23_q;
  // hls/stages/agreement.hpp:1056
  logic not_1981;
  assign not_1981 = ~region_row_s23_q[2];
  logic [2:0] select_1982;
  assign select_1982 = region_row_s23_q[1] ? {1'b0, not_1981, 1'b0} : {region_row_s23_q[2], 1'b0, not_1981};
  logic [5:0] select_1983;
  assign select_1983 = region_row_s23_q[0] ? {select_1982[2], 1'b0, select_1982[1], 1'b0, select_1982[0], 1'b0} : {1'b0, select_1982[2], 1'b0, select_1982[1], 1'b0, select_1982[0]};
  logic [11:0] select_1984;
  assign select_1984 = or_1980_s23_q ? {select_1983[5], 1'b0, select_1983[4], 1'b0, select_1983[3], 1'b0, select_1983[2], 1'b0, select_1983[1], 1'b0, select_1983[0], 1'b0} : {1'b0, select_1983[5], 1'b0, select_1983[4], 1'b0, select_1983[3], 1'b0, select_1983[2], 1'b0, select_1983[1], 1'b0, select_1983[0]};
  logic [23:0] select_1985;
  assign select_1985 = or_1977_s23_q ? {select_1984[11], 1'b0, select_1984[10], 1'b0, select_1984[9], 1'b0, select_1984[8], 1'b0, select_1984[7], 1'b0, select_1984[6], 1'b0, select_1984[5], 1'b0, select_1984[4], 1'b0, select_1984[3], 1'b0, select_1984[2], 1'b0, select_1984[1], 1'b0, select_1984[0], 1'b0} : {1'b0, select_1984[11], 1'b0, select_1984[10], 1'b0, select_1984[9], 1'b0, select_1984[8], 1'b0, select_1984[7], 1'b0, select_1984[6], 1'b0, select_1984[5], 1'b0, select_1984[4], 1'b0, select_1984[3], 1'b0, select_1984[2], 1'b0, select_1984[1], 1'b0, select_1984[0]};
  // hls/stages/agreement.hpp:1058
  logic [5:0] sum_2003;
  assign sum_2003 = {1'b0, around_s23_q} + {2'h0, around_s23_q[4:1]};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2067;
  assign xor_2067 = {difference_2066_s23_q[8:0], sum_2065_s23_q} ^ {10{difference_2066_s23_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2066_s23_q[9]} + {1'b0, xor_2067};
  logic [9:0] xor_2075;
  assign xor_2075 = {difference_2074_s23_q[8:0], sum_2073_s23_q} ^ {10{difference_2074_s23_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2074_s23_q[9]} + {1'b0, xor_2075};
  // hls/stages/agreement.hpp:511
  logic select_2090;
  assign select_2090 = and_521_s23_q ? whole_2_s23_q : census_columns_values_0_cell_0_mask_q;
  logic select_2106;
  assign select_2106 = and_521_s23_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2109;
  assign select_2109 = and_521_s23_q ? census_columns_values_0_cell_1_mask_s23_q : census_columns_values_1_cell_1_mask_q;
  logic select_2112;
  assign select_2112 = and_521_s23_q ? census_columns_values_0_cell_2_mask_s23_q : census_columns_values_1_cell_2_mask_q;
  logic select_2116;
  assign select_2116 = and_521_s23_q ? census_columns_values_0_cell_3_mask_s23_q : census_columns_values_1_cell_3_mask_q;
  logic select_2119;
  assign select_2119 = and_521_s23_q ? census_columns_values_0_cell_4_mask_s23_q : census_columns_values_1_cell_4_mask_q;
  logic select_2122;
  assign select_2122 = and_521_s23_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2125;
  assign select_2125 = and_521_s23_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_2147;
  assign sum_2147 = {9'h0, difference_2145_s23_q} + {1'b0, xor_2146_s23_q};
  logic [9:0] sum_2150;
  assign sum_2150 = {9'h0, difference_2148_s23_q} + {1'b0, xor_2149_s23_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2191_s23_q} + xor_2192_s23_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2203_s23_q} + xor_2204_s23_q;
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2425;
  assign select_2425 = and_2419_s23_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2423_s23_q});
  logic [13:0] select_2440;
  assign select_2440 = and_2419_s23_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2438_s23_q});
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_2455;
  assign sum_2455 = {1'b0, e_s23_q} + {2'h0, e_s23_q[4:1]};
  // hls/stages/registration.hpp:107
  logic [7:0] select_2550;
  assign select_2550 = equal_1620_s23_q ? (and_2535_s23_q ? residual_s23_q : 8'h0) : 8'h0;
  logic and_2561;
  assign and_2561 = and_2535_s23_q & ($signed(residual_s23_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2575;
  assign less_2575 = $signed(residual_s23_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2628;
  assign select_2628 = or_1559_s23_q ? 12'h0 : (equal_2626_s23_q ? registration_sums_rdata_s23_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1097
  logic [11:0] select_2630;
  assign select_2630 = equal_1524_s23_q ? 12'h0 : (less_1555_s23_q ? select_2628 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2633;
  assign and_2633 = x_s23_q[1] & all_s23_q;
  // hls/stages/agreement.hpp:1097
  logic and_2636;
  assign and_2636 = not_1890_s23_q & (less_1555_s23_q & ({and_2633, x_s23_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2643;
  assign select_2643 = or_1559_s23_q ? 12'h0 : (equal_2626_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1097
  logic [11:0] select_2645;
  assign select_2645 = equal_1524_s23_q ? 12'h0 : (less_1555_s23_q ? select_2643 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2651;
  assign not_2651 = ~all_s23_q;
  // hls/stages/agreement.hpp:1097
  logic and_2654;
  assign and_2654 = not_1890_s23_q & (less_1555_s23_q & (x_s23_q[2:0] == {all_s23_q, not_2651, 1'b0}));
  // hls/stages/agreement.hpp:776
  logic and_2660;
  assign and_2660 = equal_1479_s23_q & (x_s23_q[6] & (not_1890_s23_q & (less_1555_s23_q & all_s23_q)));
  // hls/stages/registration.hpp:157
  logic equal_2687;
  assign equal_2687 = x_s23_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1097
  logic and_2690;
  assign and_2690 = not_1890_s23_q & (less_1555_s23_q & (x_s23_q[5] ? x_s23_q[3] : equal_2687));
  logic and_2699;
  assign and_2699 = not_1890_s23_q & (less_1555_s23_q & ((~x_s23_q[5]) & (x_s23_q[3] & equal_2687)));
  // hls/stages/patches.hpp:344
  logic not_2761;
  assign not_2761 = ~and_1698_s23_q;
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_1804_s23_q ? patches_right_codes_rdata_s23_q : 28'h0;
  // hls/stages/patches.hpp:517
  logic [47:0] select_2931;
  assign select_2931 = new_row_s23_q ? patches_left_codes_rdata_s23_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_2933;
  assign select_2933 = equal_1700_s23_q ? patches_left_row_q : (equal_1702_s23_q ? select_2931 : patches_left_row_q);
  logic [4:0] select_3278;
  assign select_3278 = equal_1702_s23_q ? patches_along_s23_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3355;
  assign select_3355 = less_1861_s23_q ? (equal_1864_s23_q ? 10'h3ff : select_3353_s23_q) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3356;
  assign select_3356 = equal_1864_s23_q ? select_3355 : select_3353_s23_q;
  logic [9:0] select_3358;
  assign select_3358 = less_1861_s23_q ? (equal_1862_s23_q ? 10'h3ff : select_3356) : select_3356;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high_s23_q - low_s23_q;
  logic [9:0] fall;
  assign fall = high_s23_q - select_3360_s23_q[9:0];
  // hls/stages/agreement.hpp:1139
  logic or_3707;
  assign or_3707 = ({counts_textured_s23_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s23_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1170
  logic too_little;
  assign too_little = less_3711_s23_q | (product_rest_q & equal_3712_s23_q);
  // hls/stages/agreement.hpp:1171
  logic select_3715;
  assign select_3715 = and_3710_s23_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1090
  logic [10:0] sum_3718;
  assign sum_3718 = {1'b0, select_2471_s23_q} + {2'h0, select_2471_s23_q[9:1]};
  // hls/stages/agreement.hpp:776
  logic select_3762;
  assign select_3762 = equal_1479_s23_q ? (equal_3481_s23_q ? sum_4_s23_q : (product_rest_q | sum_4_s23_q)) : product_rest_q;
  // hls/stages/agreement.hpp:1241
  logic [3:0] select_3877;
  assign select_3877 = select_1931_s23_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:426
  logic [7:0] select_3883;
  assign select_3883 = marks_first_s23_q ? (less_3879 ? {sum_3880, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_3954;
  assign select_3954 = equal_1546_s23_q ? {2'h0, counts_explained_s23_q, 2'h0, counts_textured_s23_q} : (equal_3952_s23_q ? registration_sums_rdata_s23_q : 32'h0);
  logic [31:0] select_3955;
  assign select_3955 = equal_1544_s23_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3954;

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s23_q, and_1618_s23_q};
  logic patches_choices_we;
  assign patches_choices_we = s23_en & and_1699_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= select_1692;
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

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s23_q, or_1888_s23_q, or_1885_s23_q, or_1882_s23_q};
  logic regions_we;
  assign regions_we = s23_en & and_1916_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1915_s23_q, sum_1909_s23_q, sum_1904_s23_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s21_sim;
  logic regions_re_s21_sim;
  logic [5:0] regions_raddr_s22_sim;
  logic regions_re_s22_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s21_sim <= 1'b0;
      regions_re_s22_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s21_sim <= regions_re;
      regions_raddr_s21_sim <= regions_raddr;
      regions_re_s22_sim <= regions_re_s21_sim;
      regions_raddr_s22_sim <= regions_raddr_s21_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s21_sim && regions_raddr_s21_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s22_sim && regions_raddr_s22_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      counts_supervised_q <= 14'h0;
      counts_nearer_q <= 14'h0;
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
      patches_read_far_q <= 10'h3ff;
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
    end else if (s23_en) begin
      counts_supervised_q <= select_2425;
      counts_nearer_q <= select_2440;
      patches_fixed_q <= not_2761 & (patches_fixed_q | (and_2771_s23_q & and_1658));
      patches_choice_valid_q <= and_1698_s23_q ? (select_1692[0] & not_2761) : select_1692[0];
      patches_choice_column_q <= select_1692[8:1];
      patches_choice_shift_q <= select_1692[14:9];
      patches_choice_slope_q <= select_1692[22:15];
      patches_left_row_q <= select_2933;
      patches_summed_row_column_q <= equal_1700_s23_q ? patches_summed_row_column_q : select_3278;
      patches_read_far_q <= equal_1700_s23_q ? select_3358 : patches_read_far_q;
      product_rest_q <= select_3762;
      disagree_q <= equal_1479_s23_q ? select_3715 : disagree_q;
      began_q <= not_1944 & (began_q | select_1931_s23_q);
      seen_x_q <= select_1931_s23_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s23_q ? 4'h0 : select_3877;
      seen_column_q <= select_1931_s23_q ? 8'h0 : (seen_column_q + {7'h0, equal_1937});
      seen_rows_left_q <= select_3883;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s23_q ? 13'h0 : (seen_base_q + {6'h0, select_1934});
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s23_en) begin
      census_columns_values_0_cell_0_mask_q <= select_2090;
      census_columns_values_1_cell_0_mask_q <= select_2106;
      census_columns_values_1_cell_1_mask_q <= select_2109;
      census_columns_values_1_cell_2_mask_q <= select_2112;
      census_columns_values_1_cell_3_mask_q <= select_2116;
      census_columns_values_1_cell_4_mask_q <= select_2119;
      census_columns_values_2_cell_0_mask_q <= select_2122;
      census_columns_values_2_cell_1_mask_q <= select_2125;
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
  logic census_columns_values_1_cell_2_mask_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic census_columns_values_1_cell_3_mask_s24_q;
  logic census_columns_values_1_cell_4_mask_s24_q;
  logic census_columns_values_2_cell_0_mask_s24_q;
  logic census_columns_values_2_cell_1_mask_s24_q;
  logic [6:0] x_s24_q;
  logic [2:0] slot_s24_q;
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
  logic [3:0] select_482_s24_q;
  logic [6:0] select_485_s24_q;
  logic [6:0] column_s24_q;
  logic and_519_s24_q;
  logic and_521_s24_q;
  logic equal_524_s24_q;
  logic whole_2_s24_q;
  logic so_s24_q;
  logic less_555_s24_q;
  logic less_556_s24_q;
  logic less_557_s24_q;
  logic less_558_s24_q;
  logic less_559_s24_q;
  logic less_560_s24_q;
  logic less_561_s24_q;
  logic less_562_s24_q;
  logic less_563_s24_q;
  logic less_564_s24_q;
  logic less_565_s24_q;
  logic less_566_s24_q;
  logic less_567_s24_q;
  logic less_568_s24_q;
  logic less_569_s24_q;
  logic less_570_s24_q;
  logic less_571_s24_q;
  logic less_572_s24_q;
  logic less_573_s24_q;
  logic less_574_s24_q;
  logic less_575_s24_q;
  logic less_576_s24_q;
  logic less_577_s24_q;
  logic less_578_s24_q;
  logic and_586_s24_q;
  logic whole_9_s24_q;
  logic [10:0] sum_619_s24_q;
  logic [9:0] sum_622_s24_q;
  logic [9:0] sum_626_s24_q;
  logic [9:0] sum_630_s24_q;
  logic equal_1479_s24_q;
  logic not_1480_s24_q;
  logic equal_1524_s24_q;
  logic [1:0] sum_1530_s24_q;
  logic equal_1532_s24_q;
  logic equal_1534_s24_q;
  logic equal_1536_s24_q;
  logic equal_1538_s24_q;
  logic equal_1540_s24_q;
  logic equal_1542_s24_q;
  logic less_1555_s24_q;
  logic [19:0] select_1580_s24_q;
  logic [11:0] select_1585_s24_q;
  logic and_1589_s24_q;
  logic and_1592_s24_q;
  logic select_1609_s24_q;
  logic equal_1610_s24_q;
  logic equal_1620_s24_q;
  logic equal_1700_s24_q;
  logic equal_1702_s24_q;
  logic equal_1705_s24_q;
  logic or_1706_s24_q;
  logic [22:0] select_1716_s24_q;
  logic [4:0] select_1730_s24_q;
  logic select_1736_s24_q;
  logic [3:0] select_1775_s24_q;
  logic less_1791_s24_q;
  logic new_row_s24_q;
  logic [1:0] of_row_2_s24_q;
  logic less_1821_s24_q;
  logic less_1822_s24_q;
  logic less_1831_s24_q;
  logic less_1832_s24_q;
  logic and_1846_s24_q;
  logic and_1855_s24_q;
  logic and_1860_s24_q;
  logic less_1861_s24_q;
  logic equal_1862_s24_q;
  logic not_1863_s24_q;
  logic equal_1864_s24_q;
  logic not_1890_s24_q;
  logic not_1944_s24_q;
  logic [7:0] sum_1954_s24_q;
  logic equal_1969_s24_q;
  logic or_1974_s24_q;
  logic [23:0] select_1985_s24_q;
  logic not_2005_s24_q;
  logic less_2019_s24_q;
  logic and_2030_s24_q;
  logic [10:0] size_s24_q;
  logic [10:0] size_2_s24_q;
  logic [10:0] sum_2151_s24_q;
  logic [9:0] sum_2154_s24_q;
  logic [9:0] sum_2158_s24_q;
  logic [9:0] sum_2162_s24_q;
  logic equal_2170_s24_q;
  logic [8:0] contrast_s24_q;
  logic [8:0] contrast_2_s24_q;
  logic equal_2223_s24_q;
  logic equal_2294_s24_q;
  logic and_2419_s24_q;
  logic not_2442_s24_q;
  logic not_2457_s24_q;
  logic [9:0] select_2468_s24_q;
  logic [9:0] select_2471_s24_q;
  logic and_2534_s24_q;
  logic and_2535_s24_q;
  logic [7:0] select_2552_s24_q;
  logic and_2561_s24_q;
  logic and_2569_s24_q;
  logic and_2576_s24_q;
  logic and_2583_s24_q;
  logic [11:0] select_2630_s24_q;
  logic and_2638_s24_q;
  logic [11:0] select_2645_s24_q;
  logic and_2656_s24_q;
  logic and_2660_s24_q;
  logic and_2692_s24_q;
  logic and_2700_s24_q;
  logic [27:0] word_s24_q;
  logic equal_2892_s24_q;
  logic less_2898_s24_q;
  logic [47:0] select_2931_s24_q;
  logic equal_3241_s24_q;
  logic [4:0] select_3329_s24_q;
  logic [14:0] select_3360_s24_q;
  logic less_3403_s24_q;
  logic [9:0] eight_s24_q;
  logic [9:0] fall_s24_q;
  logic equal_3481_s24_q;
  logic equal_3704_s24_q;
  logic or_3707_s24_q;
  logic select_3715_s24_q;
  logic not_3720_s24_q;
  logic equal_3728_s24_q;
  logic equal_3730_s24_q;
  logic equal_3731_s24_q;
  logic equal_3860_s24_q;
  logic [31:0] select_3955_s24_q;
  logic [9:0] select_3962_s24_q;
  always_ff @(posedge clk_i) begin
    if (s23_en) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= line_ended_q;
      sample_pair_pixel_0_s24_q <= sample_pair_pixel_0_s23_q;
      sample_pair_pixel_1_s24_q <= sample_pair_pixel_1_s23_q;
      sample_pair_whole_s24_q <= sample_pair_whole_s23_q;
      sample_present_s24_q <= sample_present_s23_q;
      census_columns_values_1_cell_2_mask_s24_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      census_columns_values_1_cell_3_mask_s24_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s24_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s24_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s24_q <= census_columns_values_2_cell_1_mask_q;
      x_s24_q <= x_s23_q[6:0];
      slot_s24_q <= slot_s23_q;
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
      select_482_s24_q <= select_482_s23_q;
      select_485_s24_q <= select_485_s23_q;
      column_s24_q <= column_s23_q;
      and_519_s24_q <= and_519_s23_q;
      and_521_s24_q <= and_521_s23_q;
      equal_524_s24_q <= equal_524_s23_q;
      whole_2_s24_q <= whole_2_s23_q;
      so_s24_q <= so_s23_q;
      less_555_s24_q <= less_555_s23_q;
      less_556_s24_q <= less_556_s23_q;
      less_557_s24_q <= less_557_s23_q;
      less_558_s24_q <= less_558_s23_q;
      less_559_s24_q <= less_559_s23_q;
      less_560_s24_q <= less_560_s23_q;
      less_561_s24_q <= less_561_s23_q;
      less_562_s24_q <= less_562_s23_q;
      less_563_s24_q <= less_563_s23_q;
      less_564_s24_q <= less_564_s23_q;
      less_565_s24_q <= less_565_s23_q;
      less_566_s24_q <= less_566_s23_q;
      less_567_s24_q <= less_567_s23_q;
      less_568_s24_q <= less_568_s23_q;
      less_569_s24_q <= less_569_s23_q;
      less_570_s24_q <= less_570_s23_q;
      less_571_s24_q <= less_571_s23_q;
      less_572_s24_q <= less_572_s23_q;
      less_573_s24_q <= less_573_s23_q;
      less_574_s24_q <= less_574_s23_q;
      less_575_s24_q <= less_575_s23_q;
      less_576_s24_q <= less_576_s23_q;
      less_577_s24_q <= less_577_s23_q;
      less_578_s24_q <= less_578_s23_q;
      and_586_s24_q <= and_586_s23_q;
      whole_9_s24_q <= whole_9;
      sum_619_s24_q <= {1'b0, sum_615} + {1'b0, sum_618};
      sum_622_s24_q <= {9'h0, difference_620_s23_q} + {1'b0, xor_621_s23_q};
      sum_626_s24_q <= {9'h0, difference_624_s23_q} + {1'b0, xor_625_s23_q};
      sum_630_s24_q <= {9'h0, difference_628_s23_q} + {1'b0, xor_629_s23_q};
      equal_1479_s24_q <= equal_1479_s23_q;
      not_1480_s24_q <= not_1480_s23_q;
      equal_1524_s24_q <= equal_1524_s23_q;
      sum_1530_s24_q <= sum_1530_s23_q;
      equal_1532_s24_q <= equal_1532_s23_q;
      equal_1534_s24_q <= equal_1534_s23_q;
      equal_1536_s24_q <= equal_1536_s23_q;
      equal_1538_s24_q <= equal_1538_s23_q;
      equal_1540_s24_q <= equal_1540_s23_q;
      equal_1542_s24_q <= equal_1542_s23_q;
      less_1555_s24_q <= less_1555_s23_q;
      select_1580_s24_q <= equal_1579_s23_q ? registration_sums_rdata_s23_q[19:0] : 20'h0;
      select_1585_s24_q <= equal_1579_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0;
      and_1589_s24_q <= and_1589_s23_q;
      and_1592_s24_q <= and_1592_s23_q;
      select_1609_s24_q <= select_1609_s23_q;
      equal_1610_s24_q <= equal_1610_s23_q;
      equal_1620_s24_q <= equal_1620_s23_q;
      equal_1700_s24_q <= equal_1700_s23_q;
      equal_1702_s24_q <= equal_1702_s23_q;
      equal_1705_s24_q <= equal_1705_s23_q;
      or_1706_s24_q <= or_1706_s23_q;
      select_1716_s24_q <= and_1715_s23_q ? select_1692 : patches_choices_rdata_s23_q;
      select_1730_s24_q <= select_1730_s23_q;
      select_1736_s24_q <= select_1736_s23_q;
      select_1775_s24_q <= select_1775_s23_q;
      less_1791_s24_q <= less_1791_s23_q;
      new_row_s24_q <= new_row_s23_q;
      of_row_2_s24_q <= of_row_2_s23_q;
      less_1821_s24_q <= $signed(15'h100) < $signed(sum_1820);
      less_1822_s24_q <= $signed(sum_1820[14:8]) < $signed(7'h7f);
      less_1831_s24_q <= $signed(15'h100) < $signed(difference_1830_s23_q);
      less_1832_s24_q <= $signed(difference_1830_s23_q[14:8]) < $signed(7'h7f);
      and_1846_s24_q <= and_1846_s23_q;
      and_1855_s24_q <= and_1855_s23_q;
      and_1860_s24_q <= and_1860_s23_q;
      less_1861_s24_q <= less_1861_s23_q;
      equal_1862_s24_q <= equal_1862_s23_q;
      not_1863_s24_q <= not_1863_s23_q;
      equal_1864_s24_q <= equal_1864_s23_q;
      not_1890_s24_q <= not_1890_s23_q;
      not_1944_s24_q <= not_1944;
      sum_1954_s24_q <= {2'h0, x_s23_q[7:2]} + 8'hff;
      equal_1969_s24_q <= t_s23_q[4:1] == 4'h0;
      or_1974_s24_q <= or_1974_s23_q;
      select_1985_s24_q <= select_1985;
      not_2005_s24_q <= ~({sum_2003, around_s23_q[0]} < {2'h0, t_s23_q});
      less_2019_s24_q <= less_2019_s23_q;
      and_2030_s24_q <= and_2030_s23_q;
      size_s24_q <= size;
      size_2_s24_q <= size_2;
      sum_2151_s24_q <= {1'b0, sum_2147} + {1'b0, sum_2150};
      sum_2154_s24_q <= {9'h0, difference_2152_s23_q} + {1'b0, xor_2153_s23_q};
      sum_2158_s24_q <= {9'h0, difference_2156_s23_q} + {1'b0, xor_2157_s23_q};
      sum_2162_s24_q <= {9'h0, difference_2160_s23_q} + {1'b0, xor_2161_s23_q};
      equal_2170_s24_q <= equal_2170_s23_q;
      contrast_s24_q <= contrast;
      contrast_2_s24_q <= contrast_2;
      equal_2223_s24_q <= x_s23_q[7:3] == 5'h0;
      equal_2294_s24_q <= equal_2294_s23_q;
      and_2419_s24_q <= and_2419_s23_q;
      not_2442_s24_q <= not_2442_s23_q;
      not_2457_s24_q <= ~({sum_2455, e_s23_q[0]} < {2'h0, t_s23_q});
      select_2468_s24_q <= select_2468_s23_q;
      select_2471_s24_q <= select_2471_s23_q;
      and_2534_s24_q <= and_2534_s23_q;
      and_2535_s24_q <= and_2535_s23_q;
      select_2552_s24_q <= equal_1479_s23_q ? 8'h0 : (so_s23_q ? select_2550 : 8'h0);
      and_2561_s24_q <= and_2561;
      and_2569_s24_q <= and_2535_s23_q & less_2568_s23_q;
      and_2576_s24_q <= and_2535_s23_q & less_2575;
      and_2583_s24_q <= and_2535_s23_q & less_2582_s23_q;
      select_2630_s24_q <= select_2630;
      and_2638_s24_q <= equal_1479_s23_q & (x_s23_q[6] & and_2636);
      select_2645_s24_q <= select_2645;
      and_2656_s24_q <= equal_1479_s23_q & (x_s23_q[6] & and_2654);
      and_2660_s24_q <= and_2660;
      and_2692_s24_q <= equal_1479_s23_q & (x_s23_q[6] & and_2690);
      and_2700_s24_q <= x_s23_q[6] & and_2699;
      word_s24_q <= word;
      equal_2892_s24_q <= patches_along_s23_q == 5'h7;
      less_2898_s24_q <= less_2898_s23_q;
      select_2931_s24_q <= select_2931;
      equal_3241_s24_q <= equal_3241_s23_q;
      select_3329_s24_q <= select_3329_s23_q;
      select_3360_s24_q <= select_3360_s23_q;
      less_3403_s24_q <= less_3403_s23_q;
      eight_s24_q <= eight;
      fall_s24_q <= fall;
      equal_3481_s24_q <= equal_3481_s23_q;
      equal_3704_s24_q <= select_2468_s23_q[9:3] == 7'h0;
      or_3707_s24_q <= or_3707;
      select_3715_s24_q <= select_3715;
      not_3720_s24_q <= ~({sum_3718, select_2471_s23_q[0]} < {2'h0, select_2468_s23_q});
      equal_3728_s24_q <= equal_3728_s23_q;
      equal_3730_s24_q <= equal_3730_s23_q;
      equal_3731_s24_q <= equal_3731_s23_q;
      equal_3860_s24_q <= equal_3860_s23_q;
      select_3955_s24_q <= select_3955;
      select_3962_s24_q <= select_3962_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
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
  logic [47:0] good_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:447
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_s24_q & whole_9_s24_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s24_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s24_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s24_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s24_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:270
  logic [10:0] sum_623;
  assign sum_623 = sum_619_s24_q + {1'b0, sum_622_s24_q};
  // hls/stages/registration.hpp:265
  logic equal_1581;
  assign equal_1581 = sum_1530_s24_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1530_s24_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1583;
  assign select_1583 = equal_1581 ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1530_s24_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1587;
  assign select_1587 = equal_1581 ? {1'b0, registration_half_measured_q} : up;
  // hls/stages/patches.hpp:353
  logic [21:0] select_1719;
  assign select_1719 = select_1609_s24_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1716_s24_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1720;
  assign select_1720 = equal_1610_s24_q ? patches_place_0_column_q : select_1719[7:0];
  logic [5:0] select_1721;
  assign select_1721 = equal_1610_s24_q ? patches_place_0_shift_q : select_1719[13:8];
  // hls/stages/patches.hpp:353
  logic [21:0] select_1748;
  assign select_1748 = select_1609_s24_q ? select_1716_s24_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1749;
  assign select_1749 = equal_1610_s24_q ? patches_place_1_column_q : select_1748[7:0];
  logic [5:0] select_1750;
  assign select_1750 = equal_1610_s24_q ? patches_place_1_shift_q : select_1748[13:8];
  // hls/stages/patches.hpp:132
  logic equal_1766;
  assign equal_1766 = {select_1720[7], select_485_s24_q, select_482_s24_q} == {1'b0, select_1720[6:0], 4'h0};
  logic equal_1770;
  assign equal_1770 = {select_1749[7], select_485_s24_q, select_482_s24_q} == {1'b0, select_1749[6:0], 4'h0};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_1812;
  assign sum_1812 = patches_code_row_s24_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_1850;
  assign sum_1850 = patches_code_row_s24_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:1249
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1216
  logic select_1942;
  assign select_1942 = marks_first_s24_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1202
  logic [10:0] sum_1943;
  assign sum_1943 = {1'b0, {5{select_1942}}, 1'b0, {2{select_1942}}, 1'b0, select_1942} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1066
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1954_s24_q[7]}}, sum_1954_s24_q, x_s24_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1202
  logic [10:0] sum_1956;
  assign sum_1956 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1056
  logic [47:0] select_1986;
  assign select_1986 = or_1974_s24_q ? {select_1985_s24_q[23], 1'b0, select_1985_s24_q[22], 1'b0, select_1985_s24_q[21], 1'b0, select_1985_s24_q[20], 1'b0, select_1985_s24_q[19], 1'b0, select_1985_s24_q[18], 1'b0, select_1985_s24_q[17], 1'b0, select_1985_s24_q[16], 1'b0, select_1985_s24_q[15], 1'b0, select_1985_s24_q[14], 1'b0, select_1985_s24_q[13], 1'b0, select_1985_s24_q[12], 1'b0, select_1985_s24_q[11], 1'b0, select_1985_s24_q[10], 1'b0, select_1985_s24_q[9], 1'b0, select_1985_s24_q[8], 1'b0, select_1985_s24_q[7], 1'b0, select_1985_s24_q[6], 1'b0, select_1985_s24_q[5], 1'b0, select_1985_s24_q[4], 1'b0, select_1985_s24_q[3], 1'b0, select_1985_s24_q[2], 1'b0, select_1985_s24_q[1], 1'b0, select_1985_s24_q[0], 1'b0} : {1'b0, select_1985_s24_q[23], 1'b0, select_1985_s24_q[22], 1'b0, select_1985_s24_q[21], 1'b0, select_1985_s24_q[20], 1'b0, select_1985_s24_q[19], 1'b0, select_1985_s24_q[18], 1'b0, select_1985_s24_q[17], 1'b0, select_1985_s24_q[16], 1'b0, select_1985_s24_q[15], 1'b0, select_1985_s24_q[14], 1'b0, select_1985_s24_q[13], 1'b0, select_1985_s24_q[12], 1'b0, select_1985_s24_q[11], 1'b0, select_1985_s24_q[10], 1'b0, select_1985_s24_q[9], 1'b0, select_1985_s24_q[8], 1'b0, select_1985_s24_q[7], 1'b0, select_1985_s24_q[6], 1'b0, select_1985_s24_q[5], 1'b0, select_1985_s24_q[4], 1'b0, select_1985_s24_q[3], 1'b0, select_1985_s24_q[2], 1'b0, select_1985_s24_q[1], 1'b0, select_1985_s24_q[0]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s24_q} + (equal_524_s24_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:267
  logic [13:0] select_2072;
  assign select_2072 = sample_pair_whole_s24_q ? (and_519_s24_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s24_q} + (equal_524_s24_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:267
  logic [13:0] select_2080;
  assign select_2080 = sample_pair_whole_s24_q ? (and_519_s24_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:511
  logic select_2128;
  assign select_2128 = and_521_s24_q ? census_columns_values_1_cell_2_mask_s24_q : census_columns_values_2_cell_2_mask_q;
  logic select_2131;
  assign select_2131 = and_521_s24_q ? census_columns_values_1_cell_3_mask_s24_q : census_columns_values_2_cell_3_mask_q;
  logic select_2134;
  assign select_2134 = and_521_s24_q ? census_columns_values_1_cell_4_mask_s24_q : census_columns_values_2_cell_4_mask_q;
  logic select_2135;
  assign select_2135 = and_521_s24_q ? census_columns_values_2_cell_0_mask_s24_q : census_columns_values_3_cell_0_mask_q;
  logic select_2138;
  assign select_2138 = and_521_s24_q ? census_columns_values_2_cell_1_mask_s24_q : census_columns_values_3_cell_1_mask_q;
  logic select_2139;
  assign select_2139 = and_521_s24_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2142;
  assign select_2142 = and_521_s24_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_2155;
  assign sum_2155 = sum_2151_s24_q + {1'b0, sum_2154_s24_q};
  // hls/stages/agreement.hpp:511
  logic select_2187;
  assign select_2187 = and_521_s24_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2190;
  assign and_2190 = whole_2_s24_q & (~(column_s24_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:448
  logic and_2196;
  assign and_2196 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s24_q[8:2]));
  logic and_2197;
  assign and_2197 = and_2190 & and_2196;
  logic and_2208;
  assign and_2208 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s24_q[8:2]));
  logic and_2209;
  assign and_2209 = and_2190 & and_2208;
  // hls/stages/census.hpp:409
  logic not_2226;
  assign not_2226 = ~x_s24_q[1];
  logic [2:0] select_2227;
  assign select_2227 = x_s24_q[0] ? {1'b0, not_2226, 1'b0} : {x_s24_q[1], 1'b0, not_2226};
  logic [5:0] select_2228;
  assign select_2228 = slot_s24_q[2] ? {select_2227[2], 1'b0, select_2227[1], 1'b0, select_2227[0], 1'b0} : {1'b0, select_2227[2], 1'b0, select_2227[1], 1'b0, select_2227[0]};
  logic [11:0] select_2229;
  assign select_2229 = slot_s24_q[1] ? {select_2228[5], 1'b0, select_2228[4], 1'b0, select_2228[3], 1'b0, select_2228[2], 1'b0, select_2228[1], 1'b0, select_2228[0], 1'b0} : {1'b0, select_2228[5], 1'b0, select_2228[4], 1'b0, select_2228[3], 1'b0, select_2228[2], 1'b0, select_2228[1], 1'b0, select_2228[0]};
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2472;
  assign sum_2472 = {1'b0, select_2471_s24_q} + {3'h0, select_2471_s24_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2553;
  assign sum_2553 = registration_half_across_q + {{6{select_2552_s24_q[7]}}, select_2552_s24_q};
  // hls/stages/agreement.hpp:776
  logic and_2557;
  assign and_2557 = not_1480_s24_q & (so_s24_q & (and_2535_s24_q & equal_1620_s24_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2559;
  assign select_2559 = and_2534_s24_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2557});
  // hls/stages/agreement.hpp:776
  logic [1:0] select_2563;
  assign select_2563 = so_s24_q ? (equal_1620_s24_q ? {and_2561_s24_q, and_2535_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2564;
  assign select_2564 = equal_1479_s24_q ? 2'h0 : select_2563;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2565;
  assign sum_2565 = registration_half_votes_down_q + {{5{select_2564[1]}}, select_2564};
  // hls/stages/agreement.hpp:776
  logic [1:0] select_2571;
  assign select_2571 = so_s24_q ? (equal_1620_s24_q ? {and_2569_s24_q, and_2535_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2572;
  assign select_2572 = equal_1479_s24_q ? 2'h0 : select_2571;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2573;
  assign sum_2573 = registration_half_votes_up_q + {{5{select_2572[1]}}, select_2572};
  // hls/stages/agreement.hpp:776
  logic [1:0] select_2578;
  assign select_2578 = so_s24_q ? (equal_1620_s24_q ? {and_2576_s24_q, and_2535_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2579;
  assign select_2579 = equal_1479_s24_q ? 2'h0 : select_2578;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2580;
  assign sum_2580 = registration_half_half_votes_down_q + {{5{select_2579[1]}}, select_2579};
  // hls/stages/agreement.hpp:776
  logic [1:0] select_2585;
  assign select_2585 = so_s24_q ? (equal_1620_s24_q ? {and_2583_s24_q, and_2535_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2586;
  assign select_2586 = equal_1479_s24_q ? 2'h0 : select_2585;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2587;
  assign sum_2587 = registration_half_half_votes_up_q + {{5{select_2586[1]}}, select_2586};
  // hls/stages/agreement.hpp:776
  logic and_2621;
  assign and_2621 = equal_1479_s24_q & (x_s24_q[6] & (not_1890_s24_q & less_1555_s24_q));
  logic [11:0] select_2632;
  assign select_2632 = equal_1479_s24_q ? (x_s24_q[6] ? select_2630_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2640;
  assign sum_2640 = {{2{select_2632[11]}}, select_2632} + (and_2638_s24_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:776
  logic [11:0] select_2647;
  assign select_2647 = equal_1479_s24_q ? (x_s24_q[6] ? select_2645_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2649;
  assign sum_2649 = {{2{select_2647[11]}}, select_2647} + (and_2638_s24_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2661;
  assign not_2661 = ~and_2660_s24_q;
  logic less_2662;
  assign less_2662 = $signed({9'h1, {2{not_2661}}, and_2660_s24_q}) < $signed(registration_up_q[13:2]);
  logic select_2663;
  assign select_2663 = and_2656_s24_q ? less_2662 : registration_enough_q;
  // hls/stages/agreement.hpp:1097
  logic and_2667;
  assign and_2667 = x_s24_q[6] & (not_1890_s24_q & (less_1555_s24_q & (x_s24_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:776
  logic and_2668;
  assign and_2668 = equal_1479_s24_q & and_2667;
  // hls/stages/registration.hpp:242
  logic less_2669;
  assign less_2669 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2671;
  assign less_2671 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2673;
  assign equal_2673 = x_s24_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:776
  logic and_2677;
  assign and_2677 = equal_1479_s24_q & (x_s24_q[6] & (not_1890_s24_q & (less_1555_s24_q & equal_2673)));
  // hls/stages/agreement.hpp:1097
  logic and_2684;
  assign and_2684 = x_s24_q[6] & (not_1890_s24_q & (less_1555_s24_q & (x_s24_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2702;
  assign and_2702 = registration_votes_up_q & registration_other_down_q;
  logic select_2704;
  assign select_2704 = registration_votes_down_q ? (registration_other_up_q | and_2702) : and_2702;
  // hls/stages/registration.hpp:138
  logic and_2706;
  assign and_2706 = (equal_1479_s24_q & and_2700_s24_q) & (registration_other_enough_q & select_2704);
  logic and_2708;
  assign and_2708 = registration_enough_q & ((and_2692_s24_q & (less_2671 | less_2669)) | and_2706);
  // hls/stages/agreement.hpp:267
  logic [7:0] select_2794;
  assign select_2794 = sample_pair_whole_s24_q ? (equal_1610_s24_q ? patches_place_0_slope_q : select_1719[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_2799;
  assign select_2799 = sample_pair_whole_s24_q ? (equal_1610_s24_q ? patches_place_1_slope_q : select_1748[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s24_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_2888;
  assign select_2888 = or_1706_s24_q ? {less_1832_s24_q, less_1831_s24_q, less_1822_s24_q, less_1821_s24_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2890;
  assign select_2890 = equal_1700_s24_q ? patches_codes_at_q : (equal_1702_s24_q ? other[55:4] : select_2888);
  // hls/stages/patches.hpp:516
  logic [27:0] select_2893;
  assign select_2893 = equal_2892_s24_q ? word_s24_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_2895;
  assign select_2895 = equal_1702_s24_q ? (new_row_s24_q ? word_s24_q : select_2893) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_2897;
  assign select_2897 = less_1791_s24_q ? {word_s24_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_2899;
  assign select_2899 = less_2898_s24_q ? {word_s24_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_2901;
  assign select_2901 = or_1706_s24_q ? (equal_1705_s24_q ? patches_next_codes_q : select_2899) : patches_next_codes_q;
  logic [55:0] select_2903;
  assign select_2903 = equal_1700_s24_q ? patches_next_codes_q : (equal_1702_s24_q ? select_2897 : select_2901);
  // hls/stages/count_bits.hpp:24
  logic parity_2908;
  assign parity_2908 = ^{less_1832_s24_q, less_1831_s24_q, less_1822_s24_q, less_1821_s24_q};
  // hls/stages/count_bits.hpp:25
  logic or_2912;
  assign or_2912 = ({less_1822_s24_q, less_1821_s24_q} == 2'h3) | (less_1831_s24_q & (less_1822_s24_q | less_1821_s24_q));
  logic and_2913;
  assign and_2913 = less_1832_s24_q & (^{less_1831_s24_q, less_1822_s24_q, less_1821_s24_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2914;
  assign xor_2914 = or_2912 ^ and_2913;
  // hls/stages/count_bits.hpp:27
  logic and_2915;
  assign and_2915 = or_2912 & and_2913;
  // hls/stages/patches.hpp:184
  logic [2:0] select_2917;
  assign select_2917 = or_1706_s24_q ? (and_1855_s24_q ? {and_2915, xor_2914, parity_2908} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2931_s24_q;
  // hls/stages/count_bits.hpp:24
  logic xor_2937;
  assign xor_2937 = bits[17] ^ (^{select_2931_s24_q[16:15], other[16:15]});
  logic xor_2940;
  assign xor_2940 = bits[11] ^ (^{select_2931_s24_q[10:9], other[10:9]});
  logic xor_2943;
  assign xor_2943 = bits[14] ^ (^{select_2931_s24_q[13:12], other[13:12]});
  logic xor_2946;
  assign xor_2946 = xor_2937 ^ (^{select_2931_s24_q[14:9], other[14:9]});
  logic xor_2949;
  assign xor_2949 = bits[47] ^ (^{select_2931_s24_q[46:45], other[46:45]});
  logic xor_2952;
  assign xor_2952 = bits[8] ^ (^{select_2931_s24_q[7:6], other[7:6]});
  logic xor_2955;
  assign xor_2955 = bits[2] ^ (^{select_2931_s24_q[1:0], other[1:0]});
  logic xor_2958;
  assign xor_2958 = bits[5] ^ (^{select_2931_s24_q[4:3], other[4:3]});
  logic xor_2961;
  assign xor_2961 = xor_2952 ^ (^{select_2931_s24_q[5:0], other[5:0]});
  logic parity_2963;
  assign parity_2963 = ^{select_2931_s24_q[47:45], select_2931_s24_q[8:0], other[47:45], other[8:0]};
  logic xor_2967;
  assign xor_2967 = bits[44] ^ (^{select_2931_s24_q[43:42], other[43:42]});
  logic xor_2970;
  assign xor_2970 = bits[38] ^ (^{select_2931_s24_q[37:36], other[37:36]});
  logic xor_2973;
  assign xor_2973 = bits[41] ^ (^{select_2931_s24_q[40:39], other[40:39]});
  logic xor_2979;
  assign xor_2979 = bits[26] ^ (^{select_2931_s24_q[25:24], other[25:24]});
  logic xor_2982;
  assign xor_2982 = bits[20] ^ (^{select_2931_s24_q[19:18], other[19:18]});
  logic xor_2985;
  assign xor_2985 = bits[23] ^ (^{select_2931_s24_q[22:21], other[22:21]});
  logic xor_2991;
  assign xor_2991 = bits[35] ^ (^{select_2931_s24_q[34:33], other[34:33]});
  logic xor_2994;
  assign xor_2994 = bits[29] ^ (^{select_2931_s24_q[28:27], other[28:27]});
  logic xor_2997;
  assign xor_2997 = bits[32] ^ (^{select_2931_s24_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:184
  logic select_3281;
  assign select_3281 = equal_1700_s24_q ? patches_summed_first_q : (equal_1702_s24_q ? new_row_s24_q : patches_summed_first_q);
  // hls/stages/patches.hpp:538
  logic [9:0] select_3369;
  assign select_3369 = (patches_read_far_s24_q < patches_peak_far_q) ? patches_read_far_s24_q : patches_peak_far_q;
  logic [9:0] select_3370;
  assign select_3370 = patches_read_first_s24_q ? patches_read_far_s24_q : select_3369;
  // hls/stages/patches.hpp:578
  logic [10:0] sum_3412;
  assign sum_3412 = {1'b0, fall_s24_q} + {2'h0, fall_s24_q[9:1]};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3416;
  assign sum_3416 = {1'b0, fall_s24_q} + {3'h0, fall_s24_q[9:2]};
  logic not_3421;
  assign not_3421 = ~({eight_s24_q, 3'h0} < ({fall_s24_q, 3'h0} - {3'h0, fall_s24_q}));
  // hls/stages/patches.hpp:592
  logic [7:0] select_3426;
  assign select_3426 = patches_second_s24_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [3:0] sum_3427;
  assign sum_3427 = {2'h0, select_3360_s24_q[14:13]} + 4'hf;
  logic [5:0] select_3428;
  assign select_3428 = patches_second_s24_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3429;
  assign sum_3429 = {select_3428[5], select_3428} + {{4{sum_3427[3]}}, sum_3427[3:1]};
  // hls/stages/agreement.hpp:1099
  logic equal_3588;
  assign equal_3588 = x_s24_q == 7'h7f;
  // hls/stages/agreement.hpp:1090
  logic select_3721;
  assign select_3721 = equal_3704_s24_q ? ((~or_3707_s24_q) & (~select_3715_s24_q)) : not_3720_s24_q;
  // hls/stages/agreement.hpp:1097
  logic [47:0] select_3723;
  assign select_3723 = x_s24_q[6] ? (equal_1524_s24_q ? good_q : {select_3721, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:451
  logic [12:0] select_3863;
  assign select_3863 = equal_2294_s24_q ? (equal_3860_s24_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:511
  logic [6:0] select_3866;
  assign select_3866 = and_521_s24_q ? (equal_2294_s24_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1812, patches_code_row_s24_q[1:0], of_row_2_s24_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s24_en & and_1846_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1832_s24_q, less_1831_s24_q, less_1822_s24_q, less_1821_s24_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1850, patches_code_row_s24_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s24_en & and_1860_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1832_s24_q, less_1831_s24_q, less_1822_s24_q, less_1821_s24_q, patches_codes_at_q[51:8]};
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
      sharpness_before_last_mask_q <= 1'b0;
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
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s24_en) begin
      sharpness_before_last_mask_q <= select_2187;
      registration_half_across_q <= and_2534_s24_q ? 14'h0 : sum_2553;
      registration_half_measured_q <= select_2559;
      registration_half_votes_down_q <= and_2534_s24_q ? 7'h0 : sum_2565;
      registration_half_votes_up_q <= and_2534_s24_q ? 7'h0 : sum_2573;
      registration_half_half_votes_down_q <= and_2534_s24_q ? 7'h0 : sum_2580;
      registration_half_half_votes_up_q <= and_2534_s24_q ? 7'h0 : sum_2587;
      registration_down_q <= and_2621 ? sum_2640 : registration_down_q;
      registration_up_q <= and_2621 ? sum_2649 : registration_up_q;
      registration_enough_q <= select_2663;
      registration_votes_down_q <= and_2668 ? less_2669 : registration_votes_down_q;
      registration_votes_up_q <= and_2668 ? less_2671 : registration_votes_up_q;
      registration_other_enough_q <= and_2677 ? select_2663 : registration_other_enough_q;
      registration_other_down_q <= and_2677 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2677 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_column_q <= sample_pair_whole_s24_q ? select_1720 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s24_q ? select_1721 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2794;
      patches_place_1_column_q <= sample_pair_whole_s24_q ? select_1749 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s24_q ? select_1750 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2799;
      patches_codes_at_q <= select_2890;
      patches_codes_further_q <= equal_1700_s24_q ? patches_codes_further_q : select_2895;
      patches_next_codes_q <= select_2903;
      patches_summed_first_q <= select_3281;
      patches_peak_far_q <= equal_1700_s24_q ? select_3370 : patches_peak_far_q;
      good_q <= equal_1479_s24_q ? select_3723 : good_q;
      map_row_q <= and_521_s24_q ? select_3863 : map_row_q;
      map_width_q <= select_3866;
      write_half_q <= marks_first_s24_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1942;
      done_q <= not_1944_s24_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s24_q;
      said_q <= equal_1479_s24_q & equal_3588;
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
    if (s24_en) begin
      averager_detail_0_q <= select_2072;
      averager_detail_1_q <= select_2080;
      census_columns_values_2_cell_2_mask_q <= select_2128;
      census_columns_values_2_cell_3_mask_q <= select_2131;
      census_columns_values_2_cell_4_mask_q <= select_2134;
      census_columns_values_3_cell_0_mask_q <= select_2135;
      census_columns_values_3_cell_1_mask_q <= select_2138;
      census_columns_values_3_cell_2_mask_q <= select_2139;
      census_columns_values_3_cell_3_mask_q <= select_2142;
      sharpness_last_mask_q <= and_521_s24_q ? whole_2_s24_q : sharpness_last_mask_q;
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
  logic census_columns_values_2_cell_4_mask_s25_q;
  logic census_columns_values_3_cell_0_mask_s25_q;
  logic census_columns_values_3_cell_1_mask_s25_q;
  logic census_columns_values_3_cell_2_mask_s25_q;
  logic census_columns_values_3_cell_3_mask_s25_q;
  logic [6:0] x_s25_q;
  logic slot_s25_q;
  logic ends_cell_s25_q;
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
  logic centres_values_1_textured_s25_q;
  logic centres_values_1_of_skin_s25_q;
  logic done_s25_q;
  logic [3:0] select_482_s25_q;
  logic [6:0] select_485_s25_q;
  logic [6:0] column_s25_q;
  logic and_521_s25_q;
  logic less_555_s25_q;
  logic less_556_s25_q;
  logic less_557_s25_q;
  logic less_558_s25_q;
  logic less_559_s25_q;
  logic less_560_s25_q;
  logic less_561_s25_q;
  logic less_562_s25_q;
  logic less_563_s25_q;
  logic less_564_s25_q;
  logic less_565_s25_q;
  logic less_566_s25_q;
  logic less_567_s25_q;
  logic less_568_s25_q;
  logic less_569_s25_q;
  logic less_570_s25_q;
  logic less_571_s25_q;
  logic less_572_s25_q;
  logic less_573_s25_q;
  logic less_574_s25_q;
  logic less_575_s25_q;
  logic less_576_s25_q;
  logic less_577_s25_q;
  logic less_578_s25_q;
  logic and_586_s25_q;
  logic whole_16_s25_q;
  logic and_612_s25_q;
  logic [11:0] sum_627_s25_q;
  logic [9:0] sum_630_s25_q;
  logic equal_1479_s25_q;
  logic not_1480_s25_q;
  logic equal_1524_s25_q;
  logic [1:0] sum_1530_s25_q;
  logic equal_1532_s25_q;
  logic equal_1534_s25_q;
  logic equal_1536_s25_q;
  logic equal_1538_s25_q;
  logic equal_1540_s25_q;
  logic equal_1542_s25_q;
  logic [19:0] sum_1584_s25_q;
  logic [11:0] sum_1588_s25_q;
  logic and_1589_s25_q;
  logic and_1592_s25_q;
  logic select_1609_s25_q;
  logic equal_1610_s25_q;
  logic equal_1700_s25_q;
  logic equal_1702_s25_q;
  logic equal_1705_s25_q;
  logic select_1716_s25_q;
  logic [7:0] sum_1722_s25_q;
  logic [4:0] select_1730_s25_q;
  logic select_1736_s25_q;
  logic [7:0] sum_1751_s25_q;
  logic equal_1766_s25_q;
  logic equal_1770_s25_q;
  logic [3:0] select_1775_s25_q;
  logic less_1861_s25_q;
  logic equal_1862_s25_q;
  logic not_1863_s25_q;
  logic equal_1864_s25_q;
  logic not_1890_s25_q;
  logic [2:0] index_s25_q;
  logic [10:0] sum_1943_s25_q;
  logic and_1950_s25_q;
  logic less_1951_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1956_s25_q;
  logic equal_1969_s25_q;
  logic not_1989_s25_q;
  logic not_2005_s25_q;
  logic less_2019_s25_q;
  logic and_2030_s25_q;
  logic [11:0] sum_2159_s25_q;
  logic [9:0] sum_2162_s25_q;
  logic equal_2170_s25_q;
  logic [27:0] select_2184_s25_q;
  logic and_2197_s25_q;
  logic and_2209_s25_q;
  logic [8:0] select_2216_s25_q;
  logic [8:0] select_2220_s25_q;
  logic equal_2223_s25_q;
  logic less_2224_s25_q;
  logic [11:0] select_2229_s25_q;
  logic equal_2267_s25_q;
  logic and_2419_s25_q;
  logic not_2442_s25_q;
  logic not_2457_s25_q;
  logic [9:0] select_2468_s25_q;
  logic [9:0] select_2471_s25_q;
  logic less_2473_s25_q;
  logic equal_2673_s25_q;
  logic not_2686_s25_q;
  logic and_2708_s25_q;
  logic [8:0] other_s25_q;
  logic [2:0] select_2918_s25_q;
  logic [8:0] select_2931_s25_q;
  logic xor_2946_s25_q;
  logic xor_2964_s25_q;
  logic xor_2976_s25_q;
  logic xor_2988_s25_q;
  logic xor_3000_s25_q;
  logic or_3009_s25_q;
  logic or_3013_s25_q;
  logic or_3017_s25_q;
  logic or_3024_s25_q;
  logic or_3028_s25_q;
  logic or_3032_s25_q;
  logic or_3039_s25_q;
  logic or_3043_s25_q;
  logic or_3047_s25_q;
  logic or_3057_s25_q;
  logic or_3061_s25_q;
  logic or_3065_s25_q;
  logic or_3073_s25_q;
  logic or_3077_s25_q;
  logic or_3081_s25_q;
  logic or_3088_s25_q;
  logic or_3092_s25_q;
  logic or_3096_s25_q;
  logic or_3106_s25_q;
  logic or_3110_s25_q;
  logic or_3114_s25_q;
  logic and_3119_s25_q;
  logic or_3120_s25_q;
  logic equal_3241_s25_q;
  logic [4:0] select_3329_s25_q;
  logic [12:0] select_3360_s25_q;
  logic [9:0] select_3370_s25_q;
  logic less_3403_s25_q;
  logic not_3411_s25_q;
  logic not_3414_s25_q;
  logic not_3418_s25_q;
  logic not_3421_s25_q;
  logic [7:0] select_3426_s25_q;
  logic sum_3427_s25_q;
  logic [6:0] sum_3429_s25_q;
  logic equal_3481_s25_q;
  logic equal_3588_s25_q;
  logic or_3707_s25_q;
  logic select_3715_s25_q;
  logic equal_3728_s25_q;
  logic equal_3730_s25_q;
  logic equal_3731_s25_q;
  logic [31:0] select_3955_s25_q;
  logic [9:0] select_3962_s25_q;
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
      census_columns_values_2_cell_4_mask_s25_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s25_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s25_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s25_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s25_q <= census_columns_values_3_cell_3_mask_q;
      x_s25_q <= x_s24_q;
      slot_s25_q <= slot_s24_q[0];
      ends_cell_s25_q <= ends_cell_s24_q;
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
      centres_values_1_textured_s25_q <= centres_values_1_textured_s24_q;
      centres_values_1_of_skin_s25_q <= centres_values_1_of_skin_s24_q;
      done_s25_q <= done_q;
      select_482_s25_q <= select_482_s24_q;
      select_485_s25_q <= select_485_s24_q;
      column_s25_q <= column_s24_q;
      and_521_s25_q <= and_521_s24_q;
      less_555_s25_q <= less_555_s24_q;
      less_556_s25_q <= less_556_s24_q;
      less_557_s25_q <= less_557_s24_q;
      less_558_s25_q <= less_558_s24_q;
      less_559_s25_q <= less_559_s24_q;
      less_560_s25_q <= less_560_s24_q;
      less_561_s25_q <= less_561_s24_q;
      less_562_s25_q <= less_562_s24_q;
      less_563_s25_q <= less_563_s24_q;
      less_564_s25_q <= less_564_s24_q;
      less_565_s25_q <= less_565_s24_q;
      less_566_s25_q <= less_566_s24_q;
      less_567_s25_q <= less_567_s24_q;
      less_568_s25_q <= less_568_s24_q;
      less_569_s25_q <= less_569_s24_q;
      less_570_s25_q <= less_570_s24_q;
      less_571_s25_q <= less_571_s24_q;
      less_572_s25_q <= less_572_s24_q;
      less_573_s25_q <= less_573_s24_q;
      less_574_s25_q <= less_574_s24_q;
      less_575_s25_q <= less_575_s24_q;
      less_576_s25_q <= less_576_s24_q;
      less_577_s25_q <= less_577_s24_q;
      less_578_s25_q <= less_578_s24_q;
      and_586_s25_q <= and_586_s24_q;
      whole_16_s25_q <= whole_16;
      and_612_s25_q <= census_columns_values_1_cell_2_mask_s24_q & and_586_s24_q;
      sum_627_s25_q <= {1'b0, sum_623} + {2'h0, sum_626_s24_q};
      sum_630_s25_q <= sum_630_s24_q;
      equal_1479_s25_q <= equal_1479_s24_q;
      not_1480_s25_q <= not_1480_s24_q;
      equal_1524_s25_q <= equal_1524_s24_q;
      sum_1530_s25_q <= sum_1530_s24_q;
      equal_1532_s25_q <= equal_1532_s24_q;
      equal_1534_s25_q <= equal_1534_s24_q;
      equal_1536_s25_q <= equal_1536_s24_q;
      equal_1538_s25_q <= equal_1538_s24_q;
      equal_1540_s25_q <= equal_1540_s24_q;
      equal_1542_s25_q <= equal_1542_s24_q;
      sum_1584_s25_q <= select_1580_s24_q + {{6{select_1583[13]}}, select_1583};
      sum_1588_s25_q <= select_1585_s24_q + {{5{select_1587[6]}}, select_1587};
      and_1589_s25_q <= and_1589_s24_q;
      and_1592_s25_q <= and_1592_s24_q;
      select_1609_s25_q <= select_1609_s24_q;
      equal_1610_s25_q <= equal_1610_s24_q;
      equal_1700_s25_q <= equal_1700_s24_q;
      equal_1702_s25_q <= equal_1702_s24_q;
      equal_1705_s25_q <= equal_1705_s24_q;
      select_1716_s25_q <= select_1716_s24_q[0];
      sum_1722_s25_q <= select_1720 + {{2{select_1721[5]}}, select_1721};
      select_1730_s25_q <= select_1730_s24_q;
      select_1736_s25_q <= select_1736_s24_q;
      sum_1751_s25_q <= select_1749 + {{2{select_1750[5]}}, select_1750};
      equal_1766_s25_q <= equal_1766;
      equal_1770_s25_q <= equal_1770;
      select_1775_s25_q <= select_1775_s24_q;
      less_1861_s25_q <= less_1861_s24_q;
      equal_1862_s25_q <= equal_1862_s24_q;
      not_1863_s25_q <= not_1863_s24_q;
      equal_1864_s25_q <= equal_1864_s24_q;
      not_1890_s25_q <= not_1890_s24_q;
      index_s25_q <= index[2:0];
      sum_1943_s25_q <= sum_1943;
      and_1950_s25_q <= began_q & (seen_x_q == 4'h0);
      less_1951_s25_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s25_q <= index_2[2:0];
      sum_1956_s25_q <= sum_1956;
      equal_1969_s25_q <= equal_1969_s24_q;
      not_1989_s25_q <= ~((good_q & select_1986) == 48'h0);
      not_2005_s25_q <= not_2005_s24_q;
      less_2019_s25_q <= less_2019_s24_q;
      and_2030_s25_q <= and_2030_s24_q;
      sum_2159_s25_q <= {1'b0, sum_2155} + {2'h0, sum_2158_s24_q};
      sum_2162_s25_q <= sum_2162_s24_q;
      equal_2170_s25_q <= equal_2170_s24_q;
      select_2184_s25_q <= sample_pair_whole_s24_q ? {detail_2, detail} : 28'h0;
      and_2197_s25_q <= and_2197;
      and_2209_s25_q <= and_2209;
      select_2216_s25_q <= and_2197 ? contrast_s24_q : 9'h0;
      select_2220_s25_q <= and_2209 ? contrast_2_s24_q : 9'h0;
      equal_2223_s25_q <= equal_2223_s24_q;
      less_2224_s25_q <= 7'h2 < {x_s24_q[4:0], slot_s24_q[2:1]};
      select_2229_s25_q <= select_2229;
      equal_2267_s25_q <= {x_s24_q[4:0], slot_s24_q} == 8'h0;
      and_2419_s25_q <= and_2419_s24_q;
      not_2442_s25_q <= not_2442_s24_q;
      not_2457_s25_q <= not_2457_s24_q;
      select_2468_s25_q <= select_2468_s24_q;
      select_2471_s25_q <= select_2471_s24_q;
      less_2473_s25_q <= {sum_2472, select_2471_s24_q[1:0]} < {3'h0, select_2468_s24_q};
      equal_2673_s25_q <= equal_2673;
      not_2686_s25_q <= ~(equal_1479_s24_q & and_2684);
      and_2708_s25_q <= and_2708;
      other_s25_q <= other[44:36];
      select_2918_s25_q <= equal_1702_s24_q ? 3'h0 : select_2917;
      select_2931_s25_q <= select_2931_s24_q[44:36];
      xor_2946_s25_q <= xor_2946;
      xor_2964_s25_q <= xor_2946 ^ parity_2963;
      xor_2976_s25_q <= xor_2967 ^ (^{select_2931_s24_q[41:36], other[41:36]});
      xor_2988_s25_q <= xor_2979 ^ (^{select_2931_s24_q[23:18], other[23:18]});
      xor_3000_s25_q <= xor_2991 ^ (^{select_2931_s24_q[32:27], other[32:27]});
      or_3009_s25_q <= (xor_2940 & xor_2943) | (xor_2937 & (xor_2940 | xor_2943));
      or_3013_s25_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3017_s25_q <= (xor_2955 & xor_2958) | (xor_2952 & (xor_2955 | xor_2958));
      or_3024_s25_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3028_s25_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3032_s25_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3039_s25_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3043_s25_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3047_s25_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3057_s25_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3061_s25_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3065_s25_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3073_s25_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3077_s25_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3081_s25_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3088_s25_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3092_s25_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3096_s25_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3106_s25_q <= (xor_2970 & xor_2973) | (xor_2967 & (xor_2970 | xor_2973));
      or_3110_s25_q <= (xor_2982 & xor_2985) | (xor_2979 & (xor_2982 | xor_2985));
      or_3114_s25_q <= (xor_2994 & xor_2997) | (xor_2991 & (xor_2994 | xor_2997));
      and_3119_s25_q <= xor_2949 & xor_2961;
      or_3120_s25_q <= xor_2949 | xor_2961;
      equal_3241_s25_q <= equal_3241_s24_q;
      select_3329_s25_q <= select_3329_s24_q;
      select_3360_s25_q <= select_3360_s24_q[12:0];
      select_3370_s25_q <= select_3370;
      less_3403_s25_q <= less_3403_s24_q;
      not_3411_s25_q <= ~({eight_s24_q, 3'h0} < {3'h0, fall_s24_q});
      not_3414_s25_q <= ~({eight_s24_q, 3'h0} < {1'b0, sum_3412, fall_s24_q[0]});
      not_3418_s25_q <= ~({eight_s24_q, 3'h0} < {sum_3416, fall_s24_q[1:0]});
      not_3421_s25_q <= not_3421;
      select_3426_s25_q <= select_3426;
      sum_3427_s25_q <= sum_3427[0];
      sum_3429_s25_q <= sum_3429;
      equal_3481_s25_q <= equal_3481_s24_q;
      equal_3588_s25_q <= equal_3588;
      or_3707_s25_q <= or_3707_s24_q;
      select_3715_s25_q <= select_3715_s24_q;
      equal_3728_s25_q <= equal_3728_s24_q;
      equal_3730_s25_q <= equal_3730_s24_q;
      equal_3731_s25_q <= equal_3731_s24_q;
      select_3955_s25_q <= select_3955_s24_q;
      select_3962_s25_q <= select_3962_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic census_columns_values_3_cell_4_mask_q;
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic registration_moved_q;
  logic patches_place_0_valid_q;
  logic patches_place_1_valid_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic good_known_q;
  // hls/stages/agreement.hpp:447
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s25_q & whole_16_s25_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s25_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s25_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s25_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s25_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:270
  logic [11:0] texture;
  assign texture = sum_627_s25_q + {2'h0, sum_630_s25_q};
  // hls/stages/patches.hpp:127
  logic select_1718;
  assign select_1718 = equal_1610_s25_q ? patches_place_0_valid_q : (select_1609_s25_q ? patches_place_0_valid_q : select_1716_s25_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1723;
  assign sum_1723 = sum_1722_s25_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1724;
  assign equal_1724 = {sum_1723[7], select_485_s25_q, select_482_s25_q} == {1'b0, sum_1723[6:0], 4'h8};
  // hls/stages/patches.hpp:127
  logic select_1747;
  assign select_1747 = equal_1610_s25_q ? patches_place_1_valid_q : (select_1609_s25_q ? select_1716_s25_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1752;
  assign sum_1752 = sum_1751_s25_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1753;
  assign equal_1753 = {sum_1752[7], select_485_s25_q, select_482_s25_q} == {1'b0, sum_1752[6:0], 4'h8};
  // hls/stages/agreement.hpp:989
  logic and_1990;
  assign and_1990 = good_known_q & not_1989_s25_q;
  // hls/stages/agreement.hpp:1058
  logic is_seen;
  assign is_seen = equal_1969_s25_q ? and_1990 : not_2005_s25_q;
  // hls/stages/agreement.hpp:511
  logic select_2143;
  assign select_2143 = and_521_s25_q ? census_columns_values_2_cell_4_mask_s25_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2163;
  assign sum_2163 = sum_2159_s25_q + {2'h0, sum_2162_s25_q};
  // hls/stages/agreement.hpp:511
  logic [11:0] select_2165;
  assign select_2165 = and_521_s25_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2166;
  assign select_2166 = and_521_s25_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2185;
  assign select_2185 = and_521_s25_q ? select_2184_s25_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2186;
  assign select_2186 = and_521_s25_q ? select_2184_s25_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2184_s25_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2184_s25_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_2217;
  assign sum_2217 = (equal_2170_s25_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2216_s25_q};
  logic [23:0] sum_2221;
  assign sum_2221 = (equal_2170_s25_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2220_s25_q};
  // hls/stages/census.hpp:409
  logic less_2225;
  assign less_2225 = x_s25_q[4:0] < 5'h3;
  logic [23:0] select_2230;
  assign select_2230 = slot_s25_q ? {select_2229_s25_q[11], 1'b0, select_2229_s25_q[10], 1'b0, select_2229_s25_q[9], 1'b0, select_2229_s25_q[8], 1'b0, select_2229_s25_q[7], 1'b0, select_2229_s25_q[6], 1'b0, select_2229_s25_q[5], 1'b0, select_2229_s25_q[4], 1'b0, select_2229_s25_q[3], 1'b0, select_2229_s25_q[2], 1'b0, select_2229_s25_q[1], 1'b0, select_2229_s25_q[0], 1'b0} : {1'b0, select_2229_s25_q[11], 1'b0, select_2229_s25_q[10], 1'b0, select_2229_s25_q[9], 1'b0, select_2229_s25_q[8], 1'b0, select_2229_s25_q[7], 1'b0, select_2229_s25_q[6], 1'b0, select_2229_s25_q[5], 1'b0, select_2229_s25_q[4], 1'b0, select_2229_s25_q[3], 1'b0, select_2229_s25_q[2], 1'b0, select_2229_s25_q[1], 1'b0, select_2229_s25_q[0]};
  // hls/stages/census.hpp:372
  logic and_2234;
  assign and_2234 = less_2225 & (~((sharpness_sums_contrast_1_q & select_2230) == 24'h0));
  logic and_2244;
  assign and_2244 = less_2225 & (~((sharpness_sums_contrast_0_q & select_2230) == 24'h0));
  // hls/stages/agreement.hpp:1061
  logic not_2459;
  assign not_2459 = ~(equal_1969_s25_q ? and_1990 : not_2457_s25_q);
  // hls/stages/agreement.hpp:776
  logic and_2462;
  assign and_2462 = ends_cell_s25_q & (not_2442_s25_q & (centres_values_1_textured_s25_q & not_2459));
  // hls/stages/agreement.hpp:1093
  logic [9:0] select_2475;
  assign select_2475 = ((~(select_2468_s25_q[9:4] == 6'h0)) & less_2473_s25_q) ? select_2468_s25_q : 10'h0;
  // hls/stages/agreement.hpp:776
  logic [9:0] select_2478;
  assign select_2478 = equal_1479_s25_q ? (x_s25_q[6] ? (equal_1524_s25_q ? 10'h0 : select_2475) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1065
  logic and_2496;
  assign and_2496 = centres_values_1_textured_s25_q & (centres_values_1_of_skin_s25_q & not_2459);
  // hls/stages/patches.hpp:167
  logic [9:0] sum_2921;
  assign sum_2921 = {7'h0, patches_set_q} + (equal_1705_s25_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3001;
  assign xor_3001 = xor_2988_s25_q ^ xor_3000_s25_q;
  // hls/stages/count_bits.hpp:25
  logic or_3126;
  assign or_3126 = (xor_2988_s25_q & xor_3000_s25_q) | (xor_2976_s25_q & (xor_2988_s25_q | xor_3000_s25_q));
  // hls/stages/patches.hpp:578
  logic [1:0] sum_3415;
  assign sum_3415 = {1'b0, not_3411_s25_q} + {1'b0, not_3414_s25_q};
  // hls/stages/patches.hpp:579
  logic [1:0] sum_3422;
  assign sum_3422 = {1'b0, not_3418_s25_q} + {1'b0, not_3421_s25_q};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3415} + {1'b0, sum_3422};
  // hls/stages/patches.hpp:592
  logic [18:0] product_3430;
  assign product_3430 = $signed({{11{select_3426_s25_q[7]}}, select_3426_s25_q}) * $signed({{8{sum_3429_s25_q[6]}}, sum_3429_s25_q, sum_3427_s25_q, select_3360_s25_q[12:10]});
  // hls/stages/patches.hpp:600
  logic [11:0] sum_3609;
  assign sum_3609 = {sum_3429_s25_q[6], sum_3429_s25_q, sum_3427_s25_q, select_3360_s25_q[12:10]} + 12'h1;
  // hls/stages/agreement.hpp:776
  logic select_3727;
  assign select_3727 = equal_1479_s25_q ? ((x_s25_q[6] & good_known_q) | equal_3588_s25_q) : good_known_q;
  // hls/stages/agreement.hpp:1249
  logic and_3889;
  assign and_3889 = and_2030_s25_q & ({sum_1956_s25_q, index_2_s25_q} == {sum_1943_s25_q, index_s25_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1345; read in stage 25, written in stage 26: 25 < 26 < 25 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1943_s25_q, index_s25_q};
  logic map_re;
  assign map_re = s25_en & (and_1950_s25_q & less_1951_s25_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1530_s25_q, lower_half_s25_q, registration_of_right_s25_q};
  logic registration_sums_we;
  assign registration_sums_we = s25_en & and_1589_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1588_s25_q, sum_1584_s25_q};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      registration_moved_q <= 1'b0;
      patches_place_0_valid_q <= 1'b0;
      patches_place_1_valid_q <= 1'b0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      good_known_q <= 1'b0;
    end else if (s25_en) begin
      sharpness_sums_contrast_0_q <= and_521_s25_q ? sum_2217 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_521_s25_q ? sum_2221 : sharpness_sums_contrast_1_q;
      registration_moved_q <= not_2686_s25_q & (registration_moved_q | and_2708_s25_q);
      patches_place_0_valid_q <= sample_pair_whole_s25_q ? select_1718 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s25_q ? select_1747 : patches_place_1_valid_q;
      patches_set_q <= equal_1700_s25_q ? 3'h0 : select_2918_s25_q;
      patches_size_q <= sum_2921;
      good_known_q <= select_3727;
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
    if (s25_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2143;
      census_changes_values_0_left_q <= and_521_s25_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_521_s25_q ? sum_2163 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2165;
      census_changes_values_1_right_q <= select_2166;
      sharpness_last_detail_0_q <= select_2185;
      sharpness_last_detail_1_q <= select_2186;
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
  logic [11:0] census_changes_values_1_left_s26_q;
  logic [11:0] census_changes_values_1_right_s26_q;
  logic [23:0] sharpness_sums_contrast_0_s26_q;
  logic [23:0] sharpness_sums_contrast_1_s26_q;
  logic [6:0] x_s26_q;
  logic [13:0] counts_nearer_s26_q;
  logic registration_moved_s26_q;
  logic patches_lower_s26_q;
  logic patches_second_s26_q;
  logic [4:0] patches_summed_row_column_s26_q;
  logic patches_summed_first_s26_q;
  logic patches_summed_last_s26_q;
  logic [4:0] patches_summed_down_by_s26_q;
  logic [13:0] product_s26_q;
  logic done_s26_q;
  logic [6:0] column_s26_q;
  logic and_521_s26_q;
  logic so_s26_q;
  logic less_555_s26_q;
  logic less_556_s26_q;
  logic less_557_s26_q;
  logic less_558_s26_q;
  logic less_559_s26_q;
  logic less_560_s26_q;
  logic less_561_s26_q;
  logic less_562_s26_q;
  logic less_563_s26_q;
  logic less_564_s26_q;
  logic less_565_s26_q;
  logic less_566_s26_q;
  logic less_567_s26_q;
  logic less_568_s26_q;
  logic less_569_s26_q;
  logic less_570_s26_q;
  logic less_571_s26_q;
  logic less_572_s26_q;
  logic less_573_s26_q;
  logic less_574_s26_q;
  logic less_575_s26_q;
  logic less_576_s26_q;
  logic less_577_s26_q;
  logic less_578_s26_q;
  logic and_586_s26_q;
  logic and_611_s26_q;
  logic and_612_s26_q;
  logic [12:0] sum_632_s26_q;
  logic equal_1479_s26_q;
  logic not_1480_s26_q;
  logic equal_1524_s26_q;
  logic equal_1532_s26_q;
  logic equal_1534_s26_q;
  logic equal_1536_s26_q;
  logic equal_1538_s26_q;
  logic equal_1540_s26_q;
  logic equal_1542_s26_q;
  logic and_1592_s26_q;
  logic select_1609_s26_q;
  logic equal_1610_s26_q;
  logic equal_1700_s26_q;
  logic equal_1702_s26_q;
  logic select_1716_s26_q;
  logic select_1718_s26_q;
  logic equal_1724_s26_q;
  logic [4:0] select_1730_s26_q;
  logic select_1736_s26_q;
  logic select_1747_s26_q;
  logic equal_1753_s26_q;
  logic or_1768_s26_q;
  logic or_1772_s26_q;
  logic [3:0] select_1775_s26_q;
  logic less_1861_s26_q;
  logic equal_1862_s26_q;
  logic not_1863_s26_q;
  logic equal_1864_s26_q;
  logic not_1890_s26_q;
  logic and_1950_s26_q;
  logic less_1951_s26_q;
  logic [2:0] index_2_s26_q;
  logic [10:0] sum_1956_s26_q;
  logic is_seen_s26_q;
  logic and_2020_s26_q;
  logic and_2030_s26_q;
  logic equal_2170_s26_q;
  logic [12:0] sum_2171_s26_q;
  logic [12:0] select_2199_s26_q;
  logic [12:0] select_2211_s26_q;
  logic equal_2223_s26_q;
  logic less_2224_s26_q;
  logic and_2234_s26_q;
  logic and_2244_s26_q;
  logic equal_2267_s26_q;
  logic and_2419_s26_q;
  logic and_2464_s26_q;
  logic [9:0] select_2468_s26_q;
  logic [9:0] select_2471_s26_q;
  logic [9:0] select_2478_s26_q;
  logic and_2499_s26_q;
  logic equal_2673_s26_q;
  logic parity_3005_s26_q;
  logic or_3009_s26_q;
  logic or_3013_s26_q;
  logic or_3017_s26_q;
  logic or_3024_s26_q;
  logic or_3028_s26_q;
  logic or_3032_s26_q;
  logic or_3039_s26_q;
  logic or_3043_s26_q;
  logic or_3047_s26_q;
  logic or_3057_s26_q;
  logic or_3061_s26_q;
  logic or_3065_s26_q;
  logic or_3073_s26_q;
  logic or_3077_s26_q;
  logic or_3081_s26_q;
  logic or_3088_s26_q;
  logic or_3092_s26_q;
  logic or_3096_s26_q;
  logic or_3106_s26_q;
  logic or_3110_s26_q;
  logic or_3114_s26_q;
  logic and_3118_s26_q;
  logic or_3122_s26_q;
  logic or_3126_s26_q;
  logic equal_3241_s26_q;
  logic [4:0] select_3329_s26_q;
  logic [9:0] select_3360_s26_q;
  logic [9:0] select_3370_s26_q;
  logic less_3403_s26_q;
  logic [2:0] fraction_s26_q;
  logic [13:0] product_3430_s26_q;
  logic equal_3481_s26_q;
  logic equal_3588_s26_q;
  logic less_3610_s26_q;
  logic or_3707_s26_q;
  logic select_3715_s26_q;
  logic equal_3728_s26_q;
  logic equal_3730_s26_q;
  logic equal_3731_s26_q;
  logic and_3874_s26_q;
  logic and_3889_s26_q;
  logic [31:0] select_3955_s26_q;
  logic [9:0] select_3962_s26_q;
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
      census_changes_values_1_left_s26_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s26_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s26_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s26_q <= sharpness_sums_contrast_1_q;
      x_s26_q <= x_s25_q;
      counts_nearer_s26_q <= counts_nearer_s25_q;
      registration_moved_s26_q <= registration_moved_q;
      patches_lower_s26_q <= patches_lower_s25_q;
      patches_second_s26_q <= patches_second_s25_q;
      patches_summed_row_column_s26_q <= patches_summed_row_column_s25_q;
      patches_summed_first_s26_q <= patches_summed_first_s25_q;
      patches_summed_last_s26_q <= patches_summed_last_s25_q;
      patches_summed_down_by_s26_q <= patches_summed_down_by_s25_q;
      product_s26_q <= product_s25_q;
      done_s26_q <= done_s25_q;
      column_s26_q <= column_s25_q;
      and_521_s26_q <= and_521_s25_q;
      so_s26_q <= drew_q;
      less_555_s26_q <= less_555_s25_q;
      less_556_s26_q <= less_556_s25_q;
      less_557_s26_q <= less_557_s25_q;
      less_558_s26_q <= less_558_s25_q;
      less_559_s26_q <= less_559_s25_q;
      less_560_s26_q <= less_560_s25_q;
      less_561_s26_q <= less_561_s25_q;
      less_562_s26_q <= less_562_s25_q;
      less_563_s26_q <= less_563_s25_q;
      less_564_s26_q <= less_564_s25_q;
      less_565_s26_q <= less_565_s25_q;
      less_566_s26_q <= less_566_s25_q;
      less_567_s26_q <= less_567_s25_q;
      less_568_s26_q <= less_568_s25_q;
      less_569_s26_q <= less_569_s25_q;
      less_570_s26_q <= less_570_s25_q;
      less_571_s26_q <= less_571_s25_q;
      less_572_s26_q <= less_572_s25_q;
      less_573_s26_q <= less_573_s25_q;
      less_574_s26_q <= less_574_s25_q;
      less_575_s26_q <= less_575_s25_q;
      less_576_s26_q <= less_576_s25_q;
      less_577_s26_q <= less_577_s25_q;
      less_578_s26_q <= less_578_s25_q;
      and_586_s26_q <= and_586_s25_q;
      and_611_s26_q <= whole_22 & and_586_s25_q;
      and_612_s26_q <= and_612_s25_q;
      sum_632_s26_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      equal_1479_s26_q <= equal_1479_s25_q;
      not_1480_s26_q <= not_1480_s25_q;
      equal_1524_s26_q <= equal_1524_s25_q;
      equal_1532_s26_q <= equal_1532_s25_q;
      equal_1534_s26_q <= equal_1534_s25_q;
      equal_1536_s26_q <= equal_1536_s25_q;
      equal_1538_s26_q <= equal_1538_s25_q;
      equal_1540_s26_q <= equal_1540_s25_q;
      equal_1542_s26_q <= equal_1542_s25_q;
      and_1592_s26_q <= and_1592_s25_q;
      select_1609_s26_q <= select_1609_s25_q;
      equal_1610_s26_q <= equal_1610_s25_q;
      equal_1700_s26_q <= equal_1700_s25_q;
      equal_1702_s26_q <= equal_1702_s25_q;
      select_1716_s26_q <= select_1716_s25_q;
      select_1718_s26_q <= select_1718;
      equal_1724_s26_q <= equal_1724;
      select_1730_s26_q <= select_1730_s25_q;
      select_1736_s26_q <= select_1736_s25_q;
      select_1747_s26_q <= select_1747;
      equal_1753_s26_q <= equal_1753;
      or_1768_s26_q <= and_1592_s25_q | (select_1718 & equal_1766_s25_q);
      or_1772_s26_q <= and_1592_s25_q | (select_1747 & equal_1770_s25_q);
      select_1775_s26_q <= select_1775_s25_q;
      less_1861_s26_q <= less_1861_s25_q;
      equal_1862_s26_q <= equal_1862_s25_q;
      not_1863_s26_q <= not_1863_s25_q;
      equal_1864_s26_q <= equal_1864_s25_q;
      not_1890_s26_q <= not_1890_s25_q;
      and_1950_s26_q <= and_1950_s25_q;
      less_1951_s26_q <= less_1951_s25_q;
      index_2_s26_q <= index_2_s25_q;
      sum_1956_s26_q <= sum_1956_s25_q;
      is_seen_s26_q <= is_seen;
      and_2020_s26_q <= is_seen & less_2019_s25_q;
      and_2030_s26_q <= and_2030_s25_q;
      equal_2170_s26_q <= equal_2170_s25_q;
      sum_2171_s26_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2163};
      select_2199_s26_q <= and_2197_s25_q ? detail_3[14:2] : 13'h0;
      select_2211_s26_q <= and_2209_s25_q ? detail_4[14:2] : 13'h0;
      equal_2223_s26_q <= equal_2223_s25_q;
      less_2224_s26_q <= less_2224_s25_q;
      and_2234_s26_q <= and_2234;
      and_2244_s26_q <= and_2244;
      equal_2267_s26_q <= equal_2267_s25_q;
      and_2419_s26_q <= and_2419_s25_q;
      and_2464_s26_q <= not_1480_s25_q & (drew_q & and_2462);
      select_2468_s26_q <= select_2468_s25_q;
      select_2471_s26_q <= select_2471_s25_q;
      select_2478_s26_q <= select_2478;
      and_2499_s26_q <= drew_q & (ends_cell_s25_q & (not_2442_s25_q & and_2496));
      equal_2673_s26_q <= equal_2673_s25_q;
      parity_3005_s26_q <= ^{xor_3001, xor_2964_s25_q, select_2931_s25_q, other_s25_q};
      or_3009_s26_q <= or_3009_s25_q;
      or_3013_s26_q <= or_3013_s25_q;
      or_3017_s26_q <= or_3017_s25_q;
      or_3024_s26_q <= or_3024_s25_q;
      or_3028_s26_q <= or_3028_s25_q;
      or_3032_s26_q <= or_3032_s25_q;
      or_3039_s26_q <= or_3039_s25_q;
      or_3043_s26_q <= or_3043_s25_q;
      or_3047_s26_q <= or_3047_s25_q;
      or_3057_s26_q <= or_3057_s25_q;
      or_3061_s26_q <= or_3061_s25_q;
      or_3065_s26_q <= or_3065_s25_q;
      or_3073_s26_q <= or_3073_s25_q;
      or_3077_s26_q <= or_3077_s25_q;
      or_3081_s26_q <= or_3081_s25_q;
      or_3088_s26_q <= or_3088_s25_q;
      or_3092_s26_q <= or_3092_s25_q;
      or_3096_s26_q <= or_3096_s25_q;
      or_3106_s26_q <= or_3106_s25_q;
      or_3110_s26_q <= or_3110_s25_q;
      or_3114_s26_q <= or_3114_s25_q;
      and_3118_s26_q <= xor_2964_s25_q & (^{xor_3001, select_2931_s25_q, other_s25_q});
      or_3122_s26_q <= and_3119_s25_q | (xor_2946_s25_q & or_3120_s25_q);
      or_3126_s26_q <= or_3126;
      equal_3241_s26_q <= equal_3241_s25_q;
      select_3329_s26_q <= select_3329_s25_q;
      select_3360_s26_q <= select_3360_s25_q[9:0];
      select_3370_s26_q <= select_3370_s25_q;
      less_3403_s26_q <= less_3403_s25_q;
      fraction_s26_q <= fraction;
      product_3430_s26_q <= product_3430[18:5];
      equal_3481_s26_q <= equal_3481_s25_q;
      equal_3588_s26_q <= equal_3588_s25_q;
      less_3610_s26_q <= {{4{sum_3609[11]}}, sum_3609} < 16'h3;
      or_3707_s26_q <= or_3707_s25_q;
      select_3715_s26_q <= select_3715_s25_q;
      equal_3728_s26_q <= equal_3728_s25_q;
      equal_3730_s26_q <= equal_3730_s25_q;
      equal_3731_s26_q <= equal_3731_s25_q;
      and_3874_s26_q <= said_q;
      and_3889_s26_q <= and_3889;
      select_3955_s26_q <= select_3955_s25_q;
      select_3962_s26_q <= select_3962_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
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
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic proven_q;
  // hls/stages/census.hpp:281
  logic [13:0] sum_633;
  assign sum_633 = {2'h0, census_changes_values_1_left_s26_q} + {1'b0, sum_632_s26_q};
  logic [13:0] sum_634;
  assign sum_634 = {2'h0, census_changes_values_2_left_q} + sum_633;
  // hls/stages/patches.hpp:134
  logic [4:0] select_1769;
  assign select_1769 = or_1768_s26_q ? {and_1592_s26_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1773;
  assign select_1773 = or_1772_s26_q ? {and_1592_s26_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1769[4] ? select_1773[3:0] : select_1769[3:0];
  logic and_1778;
  assign and_1778 = select_1736_s26_q & (select_1730_s26_q[3] ^ select_1730_s26_q[4]);
  logic and_1783;
  assign and_1783 = sample_pair_whole_s26_q & (and_1778 & ((~select_1769[4]) | (~select_1773[4])));
  // hls/stages/agreement.hpp:511
  logic [11:0] select_2167;
  assign select_2167 = and_521_s26_q ? census_changes_values_1_left_s26_q : census_changes_values_2_left_q;
  logic [11:0] select_2168;
  assign select_2168 = and_521_s26_q ? census_changes_values_1_right_s26_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_2172;
  assign sum_2172 = {2'h0, census_changes_values_1_right_s26_q} + {1'b0, sum_2171_s26_q};
  logic [13:0] sum_2173;
  assign sum_2173 = {2'h0, census_changes_values_2_right_q} + sum_2172;
  // hls/stages/census.hpp:357
  logic [23:0] select_2201;
  assign select_2201 = equal_2170_s26_q ? {11'h0, select_2199_s26_q} : (sharpness_sums_detail_0_q + {11'h0, select_2199_s26_q});
  logic [23:0] select_2213;
  assign select_2213 = equal_2170_s26_q ? {11'h0, select_2211_s26_q} : (sharpness_sums_detail_1_q + {11'h0, select_2211_s26_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_2236;
  assign select_2236 = (less_2224_s26_q & and_2234_s26_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2246;
  assign select_2246 = (less_2224_s26_q & and_2244_s26_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:210
  logic [1:0] select_2255;
  assign select_2255 = equal_2223_s26_q ? {sharpness_comparing_contrast_0_q[0], and_2244_s26_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2257;
  assign select_2257 = equal_2223_s26_q ? {sharpness_comparing_contrast_1_q[0], and_2234_s26_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_2280;
  assign xor_2280 = sharpness_comparing_contrast_0_q[1] ^ and_2234_s26_q;
  logic select_2283;
  assign select_2283 = (equal_2267_s26_q | xor_2280) ? (and_2234_s26_q & xor_2280) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:210
  logic select_2284;
  assign select_2284 = equal_2223_s26_q ? select_2283 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2286;
  assign xor_2286 = sharpness_comparing_contrast_1_q[1] ^ and_2244_s26_q;
  logic select_2289;
  assign select_2289 = (equal_2267_s26_q | xor_2286) ? (and_2244_s26_q & xor_2286) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:210
  logic select_2290;
  assign select_2290 = equal_2223_s26_q ? select_2289 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2466;
  assign select_2466 = and_2419_s26_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2464_s26_q});
  logic [13:0] select_2480;
  assign select_2480 = and_2419_s26_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2478_s26_q});
  // hls/stages/agreement.hpp:776
  logic and_2500;
  assign and_2500 = not_1480_s26_q & and_2499_s26_q;
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2502;
  assign select_2502 = and_2419_s26_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2500});
  // hls/stages/agreement.hpp:267
  logic [4:0] select_2818;
  assign select_2818 = sample_pair_whole_s26_q ? (select_1769[4] ? {1'b1, select_1769[3:0]} : (select_1769 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2821;
  assign select_2821 = sample_pair_whole_s26_q ? (select_1773[4] ? {1'b1, select_1773[3:0]} : (select_1773 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3035;
  assign parity_3035 = ^{or_3032_s26_q, or_3028_s26_q, or_3024_s26_q};
  logic parity_3050;
  assign parity_3050 = ^{or_3047_s26_q, or_3043_s26_q, or_3039_s26_q};
  logic parity_3053;
  assign parity_3053 = ^{or_3047_s26_q, or_3043_s26_q, or_3039_s26_q, or_3032_s26_q, or_3028_s26_q, or_3024_s26_q, or_3017_s26_q, or_3013_s26_q, or_3009_s26_q};
  logic parity_3084;
  assign parity_3084 = ^{or_3081_s26_q, or_3077_s26_q, or_3073_s26_q};
  logic parity_3099;
  assign parity_3099 = ^{or_3096_s26_q, or_3092_s26_q, or_3088_s26_q};
  logic parity_3102;
  assign parity_3102 = ^{or_3096_s26_q, or_3092_s26_q, or_3088_s26_q, or_3081_s26_q, or_3077_s26_q, or_3073_s26_q, or_3065_s26_q, or_3061_s26_q, or_3057_s26_q};
  logic parity_3117;
  assign parity_3117 = ^{or_3114_s26_q, or_3110_s26_q, or_3106_s26_q};
  logic parity_3129;
  assign parity_3129 = ^{or_3126_s26_q, or_3122_s26_q, and_3118_s26_q};
  logic parity_3132;
  assign parity_3132 = ^{or_3126_s26_q, or_3122_s26_q, and_3118_s26_q, or_3114_s26_q, or_3110_s26_q, or_3106_s26_q, or_3096_s26_q, or_3092_s26_q, or_3088_s26_q, or_3081_s26_q, or_3077_s26_q, or_3073_s26_q, or_3065_s26_q, or_3061_s26_q, or_3057_s26_q};
  logic parity_3134;
  assign parity_3134 = ^{or_3126_s26_q, or_3122_s26_q, and_3118_s26_q, or_3114_s26_q, or_3110_s26_q, or_3106_s26_q, or_3096_s26_q, or_3092_s26_q, or_3088_s26_q, or_3081_s26_q, or_3077_s26_q, or_3073_s26_q, or_3065_s26_q, or_3061_s26_q, or_3057_s26_q, or_3047_s26_q, or_3043_s26_q, or_3039_s26_q, or_3032_s26_q, or_3028_s26_q, or_3024_s26_q, or_3017_s26_q, or_3013_s26_q, or_3009_s26_q};
  // hls/stages/count_bits.hpp:25
  logic and_3135;
  assign and_3135 = parity_3053 & parity_3132;
  logic and_3138;
  assign and_3138 = (^{or_3017_s26_q, or_3013_s26_q, or_3009_s26_q}) & (parity_3035 | parity_3050);
  logic or_3139;
  assign or_3139 = (parity_3035 & parity_3050) | and_3138;
  logic or_3143;
  assign or_3143 = (parity_3117 & parity_3129) | (parity_3102 & (parity_3117 | parity_3129));
  logic and_3149;
  assign and_3149 = (^{or_3065_s26_q, or_3061_s26_q, or_3057_s26_q}) & (parity_3084 | parity_3099);
  logic or_3150;
  assign or_3150 = (parity_3084 & parity_3099) | and_3149;
  logic or_3154;
  assign or_3154 = (or_3110_s26_q & or_3114_s26_q) | (or_3106_s26_q & (or_3110_s26_q | or_3114_s26_q));
  logic or_3158;
  assign or_3158 = (or_3122_s26_q & or_3126_s26_q) | (and_3118_s26_q & (or_3122_s26_q | or_3126_s26_q));
  // hls/stages/count_bits.hpp:23
  logic or_3165;
  assign or_3165 = (or_3061_s26_q & or_3065_s26_q) | (or_3057_s26_q & (or_3061_s26_q | or_3065_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3169;
  assign or_3169 = (or_3077_s26_q & or_3081_s26_q) | (or_3073_s26_q & (or_3077_s26_q | or_3081_s26_q));
  logic or_3173;
  assign or_3173 = (or_3092_s26_q & or_3096_s26_q) | (or_3088_s26_q & (or_3092_s26_q | or_3096_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3176;
  assign parity_3176 = ^{or_3173, or_3169, or_3165};
  // hls/stages/count_bits.hpp:23
  logic or_3180;
  assign or_3180 = (or_3013_s26_q & or_3017_s26_q) | (or_3009_s26_q & (or_3013_s26_q | or_3017_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3184;
  assign or_3184 = (or_3028_s26_q & or_3032_s26_q) | (or_3024_s26_q & (or_3028_s26_q | or_3032_s26_q));
  logic or_3188;
  assign or_3188 = (or_3043_s26_q & or_3047_s26_q) | (or_3039_s26_q & (or_3043_s26_q | or_3047_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3191;
  assign parity_3191 = ^{or_3188, or_3184, or_3180};
  logic parity_3194;
  assign parity_3194 = ^{or_3188, or_3184, or_3180, or_3173, or_3169, or_3165, or_3158, or_3154, or_3150};
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3373;
  assign difference_3373 = select_3370_s26_q - select_3360_s26_q;
  // hls/stages/patches.hpp:594
  logic or_3380;
  assign or_3380 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3360_s26_q);
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3404;
  assign sum_3404 = select_3329_s26_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [7:0] difference_3424;
  assign difference_3424 = {sum_3404, select_3329_s26_q[2:0], 3'h0} - {5'h0, fraction_s26_q};
  logic [7:0] select_3425;
  assign select_3425 = less_3403_s26_q ? difference_3424 : {sum_3404, select_3329_s26_q[2:0], fraction_s26_q};
  // hls/stages/agreement.hpp:1080
  logic [13:0] select_3733;
  assign select_3733 = equal_3730_s26_q ? counts_skin_unproven_q : (equal_3731_s26_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3728_s26_q ? counts_nearer_s26_q : select_3733;
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_3956;
  assign select_3956 = equal_1542_s26_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3955_s26_q;
  logic [31:0] select_3957;
  assign select_3957 = equal_1540_s26_q ? {8'h0, sharpness_sums_detail_0_q} : select_3956;
  logic [31:0] select_3958;
  assign select_3958 = equal_1538_s26_q ? {8'h0, sharpness_sums_detail_1_q} : select_3957;
  logic [31:0] select_3959;
  assign select_3959 = equal_1536_s26_q ? {8'h0, sharpness_sums_contrast_0_s26_q} : select_3958;
  logic [31:0] select_3960;
  assign select_3960 = equal_1534_s26_q ? {8'h0, sharpness_sums_contrast_1_s26_q} : select_3959;

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1956_s26_q, index_2_s26_q};
  logic map_we;
  assign map_we = s26_en & and_2030_s26_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2020_s26_q, is_seen_s26_q};
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
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      proven_q <= 1'b0;
    end else if (s26_en) begin
      sharpness_sums_detail_0_q <= and_521_s26_q ? select_2201 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_521_s26_q ? select_2213 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s26_q ? select_2255 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s26_q ? select_2257 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s26_q ? select_2284 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s26_q ? select_2290 : sharpness_comparing_less_contrast_1_q;
      counts_unproven_q <= select_2466;
      counts_regions_bad_q <= select_2480;
      counts_skin_unproven_q <= select_2502;
      patches_left_next_0_q <= select_2818;
      patches_left_next_1_q <= select_2821;
      proven_q <= marks_first_s26_q ? done_s26_q : proven_q;
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
    if (s26_en) begin
      census_changes_values_2_left_q <= select_2167;
      census_changes_values_2_right_q <= select_2168;
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
  logic [13:0] product_s27_q;
  logic [6:0] column_s27_q;
  logic and_521_s27_q;
  logic so_s27_q;
  logic less_555_s27_q;
  logic less_556_s27_q;
  logic less_557_s27_q;
  logic less_558_s27_q;
  logic less_559_s27_q;
  logic less_560_s27_q;
  logic less_561_s27_q;
  logic less_562_s27_q;
  logic less_563_s27_q;
  logic less_564_s27_q;
  logic less_565_s27_q;
  logic less_566_s27_q;
  logic less_567_s27_q;
  logic less_568_s27_q;
  logic less_569_s27_q;
  logic less_570_s27_q;
  logic less_571_s27_q;
  logic less_572_s27_q;
  logic less_573_s27_q;
  logic less_574_s27_q;
  logic less_575_s27_q;
  logic less_576_s27_q;
  logic less_577_s27_q;
  logic less_578_s27_q;
  logic and_586_s27_q;
  logic and_611_s27_q;
  logic and_612_s27_q;
  logic [8:0] sum_634_s27_q;
  logic equal_1479_s27_q;
  logic equal_1524_s27_q;
  logic equal_1532_s27_q;
  logic and_1592_s27_q;
  logic select_1609_s27_q;
  logic equal_1610_s27_q;
  logic equal_1700_s27_q;
  logic equal_1702_s27_q;
  logic select_1716_s27_q;
  logic or_1726_s27_q;
  logic [4:0] select_1730_s27_q;
  logic select_1736_s27_q;
  logic or_1755_s27_q;
  logic [3:0] column_5_s27_q;
  logic [3:0] select_1775_s27_q;
  logic select_1776_s27_q;
  logic and_1783_s27_q;
  logic less_1861_s27_q;
  logic equal_1862_s27_q;
  logic not_1863_s27_q;
  logic equal_1864_s27_q;
  logic not_1890_s27_q;
  logic and_1950_s27_q;
  logic less_1951_s27_q;
  logic [1:0] map_rdata_s27_q;
  logic is_seen_s27_q;
  logic and_2020_s27_q;
  logic equal_2170_s27_q;
  logic [8:0] sum_2173_s27_q;
  logic equal_2223_s27_q;
  logic less_2224_s27_q;
  logic [17:0] select_2236_s27_q;
  logic [17:0] select_2246_s27_q;
  logic equal_2267_s27_q;
  logic [9:0] select_2468_s27_q;
  logic [9:0] select_2471_s27_q;
  logic equal_2673_s27_q;
  logic parity_3005_s27_q;
  logic parity_3134_s27_q;
  logic and_3135_s27_q;
  logic or_3139_s27_q;
  logic or_3143_s27_q;
  logic or_3150_s27_q;
  logic or_3154_s27_q;
  logic or_3158_s27_q;
  logic or_3165_s27_q;
  logic or_3169_s27_q;
  logic or_3173_s27_q;
  logic or_3180_s27_q;
  logic or_3184_s27_q;
  logic or_3188_s27_q;
  logic parity_3194_s27_q;
  logic or_3204_s27_q;
  logic or_3208_s27_q;
  logic and_3215_s27_q;
  logic and_3217_s27_q;
  logic and_3219_s27_q;
  logic equal_3241_s27_q;
  logic equal_3372_s27_q;
  logic less_3374_s27_q;
  logic less_3375_s27_q;
  logic or_3380_s27_q;
  logic [7:0] select_3425_s27_q;
  logic [13:0] product_3430_s27_q;
  logic equal_3481_s27_q;
  logic equal_3588_s27_q;
  logic less_3610_s27_q;
  logic or_3707_s27_q;
  logic select_3715_s27_q;
  logic and_3729_s27_q;
  logic [13:0] before_v_4_s27_q;
  logic not_3766_s27_q;
  logic or_3770_s27_q;
  logic and_3874_s27_q;
  logic and_3889_s27_q;
  logic not_3904_s27_q;
  logic [31:0] select_3960_s27_q;
  logic [9:0] select_3962_s27_q;
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
      product_s27_q <= product_s26_q;
      column_s27_q <= column_s26_q;
      and_521_s27_q <= and_521_s26_q;
      so_s27_q <= so_s26_q;
      less_555_s27_q <= less_555_s26_q;
      less_556_s27_q <= less_556_s26_q;
      less_557_s27_q <= less_557_s26_q;
      less_558_s27_q <= less_558_s26_q;
      less_559_s27_q <= less_559_s26_q;
      less_560_s27_q <= less_560_s26_q;
      less_561_s27_q <= less_561_s26_q;
      less_562_s27_q <= less_562_s26_q;
      less_563_s27_q <= less_563_s26_q;
      less_564_s27_q <= less_564_s26_q;
      less_565_s27_q <= less_565_s26_q;
      less_566_s27_q <= less_566_s26_q;
      less_567_s27_q <= less_567_s26_q;
      less_568_s27_q <= less_568_s26_q;
      less_569_s27_q <= less_569_s26_q;
      less_570_s27_q <= less_570_s26_q;
      less_571_s27_q <= less_571_s26_q;
      less_572_s27_q <= less_572_s26_q;
      less_573_s27_q <= less_573_s26_q;
      less_574_s27_q <= less_574_s26_q;
      less_575_s27_q <= less_575_s26_q;
      less_576_s27_q <= less_576_s26_q;
      less_577_s27_q <= less_577_s26_q;
      less_578_s27_q <= less_578_s26_q;
      and_586_s27_q <= and_586_s26_q;
      and_611_s27_q <= and_611_s26_q;
      and_612_s27_q <= and_612_s26_q;
      sum_634_s27_q <= sum_634[13:5];
      equal_1479_s27_q <= equal_1479_s26_q;
      equal_1524_s27_q <= equal_1524_s26_q;
      equal_1532_s27_q <= equal_1532_s26_q;
      and_1592_s27_q <= and_1592_s26_q;
      select_1609_s27_q <= select_1609_s26_q;
      equal_1610_s27_q <= equal_1610_s26_q;
      equal_1700_s27_q <= equal_1700_s26_q;
      equal_1702_s27_q <= equal_1702_s26_q;
      select_1716_s27_q <= select_1716_s26_q;
      or_1726_s27_q <= and_1592_s26_q | (select_1718_s26_q & equal_1724_s26_q);
      select_1730_s27_q <= select_1730_s26_q;
      select_1736_s27_q <= select_1736_s26_q;
      or_1755_s27_q <= and_1592_s26_q | (select_1747_s26_q & equal_1753_s26_q);
      column_5_s27_q <= column_5;
      select_1775_s27_q <= select_1775_s26_q;
      select_1776_s27_q <= or_1768_s26_q ? and_1592_s26_q : patches_left_next_0_q[4];
      and_1783_s27_q <= and_1783;
      less_1861_s27_q <= less_1861_s26_q;
      equal_1862_s27_q <= equal_1862_s26_q;
      not_1863_s27_q <= not_1863_s26_q;
      equal_1864_s27_q <= equal_1864_s26_q;
      not_1890_s27_q <= not_1890_s26_q;
      and_1950_s27_q <= and_1950_s26_q;
      less_1951_s27_q <= less_1951_s26_q;
      map_rdata_s27_q <= map_rdata_q;
      is_seen_s27_q <= is_seen_s26_q;
      and_2020_s27_q <= and_2020_s26_q;
      equal_2170_s27_q <= equal_2170_s26_q;
      sum_2173_s27_q <= sum_2173[13:5];
      equal_2223_s27_q <= equal_2223_s26_q;
      less_2224_s27_q <= less_2224_s26_q;
      select_2236_s27_q <= select_2236;
      select_2246_s27_q <= select_2246;
      equal_2267_s27_q <= equal_2267_s26_q;
      select_2468_s27_q <= select_2468_s26_q;
      select_2471_s27_q <= select_2471_s26_q;
      equal_2673_s27_q <= equal_2673_s26_q;
      parity_3005_s27_q <= parity_3005_s26_q;
      parity_3134_s27_q <= parity_3134;
      and_3135_s27_q <= and_3135;
      or_3139_s27_q <= or_3139;
      or_3143_s27_q <= or_3143;
      or_3150_s27_q <= or_3150;
      or_3154_s27_q <= or_3154;
      or_3158_s27_q <= or_3158;
      or_3165_s27_q <= or_3165;
      or_3169_s27_q <= or_3169;
      or_3173_s27_q <= or_3173;
      or_3180_s27_q <= or_3180;
      or_3184_s27_q <= or_3184;
      or_3188_s27_q <= or_3188;
      parity_3194_s27_q <= parity_3194;
      or_3204_s27_q <= (or_3169 & or_3173) | (or_3165 & (or_3169 | or_3173));
      or_3208_s27_q <= (or_3184 & or_3188) | (or_3180 & (or_3184 | or_3188));
      and_3215_s27_q <= and_3135 & (or_3139 | or_3143);
      and_3217_s27_q <= parity_3176 & parity_3191;
      and_3219_s27_q <= (^{or_3158, or_3154, or_3150}) & (parity_3176 | parity_3191);
      equal_3241_s27_q <= equal_3241_s26_q;
      equal_3372_s27_q <= select_3329_s26_q[3:0] == 4'h0;
      less_3374_s27_q <= {difference_3373, 3'h0} < {3'h0, patches_size_q};
      less_3375_s27_q <= select_3370_s26_q < select_3360_s26_q;
      or_3380_s27_q <= or_3380;
      select_3425_s27_q <= select_3425;
      product_3430_s27_q <= product_3430_s26_q;
      equal_3481_s27_q <= equal_3481_s26_q;
      equal_3588_s27_q <= equal_3588_s26_q;
      less_3610_s27_q <= less_3610_s26_q;
      or_3707_s27_q <= or_3707_s26_q;
      select_3715_s27_q <= select_3715_s26_q;
      and_3729_s27_q <= equal_3728_s26_q & equal_3481_s26_q;
      before_v_4_s27_q <= before_v_4;
      not_3766_s27_q <= ~(equal_3731_s26_q & equal_3481_s26_q);
      or_3770_s27_q <= (equal_3731_s26_q | equal_3730_s26_q) | (x_s26_q[6:3] == 4'hf);
      and_3874_s27_q <= and_3874_s26_q;
      and_3889_s27_q <= and_3889_s26_q;
      not_3904_s27_q <= ~proven_q;
      select_3960_s27_q <= select_3960;
      select_3962_s27_q <= select_3962_s26_q;
    end
  end

  // Stage 27 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic hides_q;
  // hls/stages/patches.hpp:133
  logic [5:0] select_1737;
  assign select_1737 = or_1726_s27_q ? {and_1592_s27_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1739;
  assign and_1739 = select_1736_s27_q & (~select_1737[5]);
  // hls/stages/patches.hpp:133
  logic [5:0] select_1757;
  assign select_1757 = or_1755_s27_q ? {and_1592_s27_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1759;
  assign and_1759 = select_1736_s27_q & (~select_1757[5]);
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2236_s27_q};
  // hls/stages/agreement.hpp:210
  logic [17:0] select_2239;
  assign select_2239 = equal_2223_s27_q ? (less_2224_s27_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2246_s27_q};
  // hls/stages/agreement.hpp:210
  logic [17:0] select_2249;
  assign select_2249 = equal_2223_s27_q ? (less_2224_s27_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/patches.hpp:127
  logic select_2801;
  assign select_2801 = equal_1610_s27_q ? patches_valid_0_q : (select_1609_s27_q ? patches_valid_0_q : select_1716_s27_q);
  // hls/stages/agreement.hpp:267
  logic select_2804;
  assign select_2804 = sample_pair_whole_s27_q ? (and_1739 ? (sample_present_s27_q & select_2801) : select_2801) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_2806;
  assign select_2806 = equal_1610_s27_q ? patches_valid_1_q : (select_1609_s27_q ? select_1716_s27_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:267
  logic select_2809;
  assign select_2809 = sample_pair_whole_s27_q ? (and_1759 ? (sample_present_s27_q & select_2806) : select_2806) : patches_valid_1_q;
  logic [5:0] select_2812;
  assign select_2812 = sample_pair_whole_s27_q ? (select_1737[5] ? {1'b1, select_1737[4:0]} : (select_1737 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2815;
  assign select_2815 = sample_pair_whole_s27_q ? (select_1757[5] ? {1'b1, select_1757[4:0]} : (select_1757 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3196;
  assign parity_3196 = ^{or_3188_s27_q, or_3184_s27_q, or_3180_s27_q, or_3173_s27_q, or_3169_s27_q, or_3165_s27_q, or_3158_s27_q, or_3154_s27_q, or_3150_s27_q, or_3143_s27_q, or_3139_s27_q, and_3135_s27_q};
  // hls/stages/count_bits.hpp:25
  logic or_3200;
  assign or_3200 = (or_3154_s27_q & or_3158_s27_q) | (or_3150_s27_q & (or_3154_s27_q | or_3158_s27_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3211;
  assign parity_3211 = ^{or_3208_s27_q, or_3204_s27_q, or_3200};
  // hls/stages/count_bits.hpp:25
  logic and_3212;
  assign and_3212 = (^{or_3143_s27_q, or_3139_s27_q, and_3135_s27_q}) & parity_3194_s27_q;
  logic or_3216;
  assign or_3216 = (or_3139_s27_q & or_3143_s27_q) | and_3215_s27_q;
  logic or_3220;
  assign or_3220 = and_3217_s27_q | and_3219_s27_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3223;
  assign parity_3223 = ^{or_3220, or_3216, and_3212};
  // hls/stages/count_bits.hpp:25
  logic and_3225;
  assign and_3225 = parity_3211 & parity_3223;
  logic or_3229;
  assign or_3229 = (or_3204_s27_q & or_3208_s27_q) | (or_3200 & (or_3204_s27_q | or_3208_s27_q));
  logic or_3233;
  assign or_3233 = (or_3216 & or_3220) | (and_3212 & (or_3216 | or_3220));
  // hls/stages/patches.hpp:594
  logic or_3381;
  assign or_3381 = (~(patches_second_s27_q ? patches_valid_1_q : patches_valid_0_q)) | or_3380_s27_q;
  logic or_3384;
  assign or_3384 = equal_3372_s27_q | (less_3374_s27_q | (less_3375_s27_q | or_3381));
  // hls/stages/patches.hpp:593
  logic [14:0] difference_3431;
  assign difference_3431 = {{7{select_3425_s27_q[7]}}, select_3425_s27_q} - {product_3430_s27_q[13], product_3430_s27_q};
  // hls/stages/patches.hpp:599
  logic less_3432;
  assign less_3432 = $signed({{8{difference_3402[6]}}, difference_3402}) < $signed(difference_3431);
  // hls/stages/agreement.hpp:1166
  logic [14:0] over;
  assign over = {1'b0, product_s27_q} - {1'b0, before_v_4_s27_q};
  // hls/stages/agreement.hpp:1174
  logic select_3736;
  assign select_3736 = and_3729_s27_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1249
  logic [1:0] select_3890;
  assign select_3890 = and_3889_s27_q ? {and_2020_s27_q, is_seen_s27_q} : map_rdata_s27_q;
  // hls/stages/agreement.hpp:1250
  logic and_3891;
  assign and_3891 = proven_q & less_3879;

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1776_s27_q, select_1775_s27_q, column_5_s27_q};
  logic patches_left_we;
  assign patches_left_we = s27_en & and_1783_s27_q;
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
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      hides_q <= 1'b0;
    end else if (s27_en) begin
      sharpness_comparing_rest_0_q <= so_s27_q ? select_2239 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s27_q ? select_2249 : sharpness_comparing_rest_1_q;
      patches_valid_0_q <= select_2804;
      patches_valid_1_q <= select_2809;
      patches_right_next_0_q <= select_2812;
      patches_right_next_1_q <= select_2815;
      hides_q <= equal_1479_s27_q ? select_3736 : hides_q;
    end
  end

  logic [7:0] pixel_0_s28_q;
  logic [7:0] pixel_1_s28_q;
  logic saturated_s28_q;
  logic mask_s28_q;
  logic marks_first_s28_q;
  logic marks_last_s28_q;
  logic [7:0] sample_pair_pixel_1_s28_q;
  logic census_columns_values_1_cell_2_of_skin_s28_q;
  logic [6:0] x_s28_q;
  logic registration_moved_s28_q;
  logic patches_lower_s28_q;
  logic patches_second_s28_q;
  logic [4:0] patches_summed_row_column_s28_q;
  logic patches_summed_first_s28_q;
  logic patches_summed_last_s28_q;
  logic [4:0] patches_summed_down_by_s28_q;
  logic [6:0] column_s28_q;
  logic and_521_s28_q;
  logic so_s28_q;
  logic less_555_s28_q;
  logic less_556_s28_q;
  logic less_557_s28_q;
  logic less_558_s28_q;
  logic less_559_s28_q;
  logic less_560_s28_q;
  logic less_561_s28_q;
  logic less_562_s28_q;
  logic less_563_s28_q;
  logic less_564_s28_q;
  logic less_565_s28_q;
  logic less_566_s28_q;
  logic less_567_s28_q;
  logic less_568_s28_q;
  logic less_569_s28_q;
  logic less_570_s28_q;
  logic less_571_s28_q;
  logic less_572_s28_q;
  logic less_573_s28_q;
  logic less_574_s28_q;
  logic less_575_s28_q;
  logic less_576_s28_q;
  logic less_577_s28_q;
  logic less_578_s28_q;
  logic and_586_s28_q;
  logic and_611_s28_q;
  logic and_612_s28_q;
  logic less_635_s28_q;
  logic equal_1479_s28_q;
  logic equal_1524_s28_q;
  logic equal_1532_s28_q;
  logic equal_1700_s28_q;
  logic equal_1702_s28_q;
  logic [4:0] select_1727_s28_q;
  logic [4:0] select_1730_s28_q;
  logic and_1740_s28_q;
  logic [4:0] select_1756_s28_q;
  logic and_1760_s28_q;
  logic less_1861_s28_q;
  logic equal_1862_s28_q;
  logic not_1863_s28_q;
  logic equal_1864_s28_q;
  logic not_1890_s28_q;
  logic and_1950_s28_q;
  logic less_1951_s28_q;
  logic equal_2170_s28_q;
  logic and_2175_s28_q;
  logic equal_2223_s28_q;
  logic sum_s28_q;
  logic sum_2_s28_q;
  logic equal_2267_s28_q;
  logic select_2285_s28_q;
  logic select_2291_s28_q;
  logic [9:0] select_2468_s28_q;
  logic [9:0] select_2471_s28_q;
  logic equal_2673_s28_q;
  logic parity_3005_s28_q;
  logic parity_3134_s28_q;
  logic parity_3196_s28_q;
  logic xor_3224_s28_q;
  logic parity_3236_s28_q;
  logic and_3237_s28_q;
  logic and_3239_s28_q;
  logic equal_3241_s28_q;
  logic or_3384_s28_q;
  logic [5:0] difference_3431_s28_q;
  logic not_3433_s28_q;
  logic not_3443_s28_q;
  logic equal_3481_s28_q;
  logic less_3555_s28_q;
  logic less_3556_s28_q;
  logic equal_3588_s28_q;
  logic less_3610_s28_q;
  logic or_3707_s28_q;
  logic select_3715_s28_q;
  logic select_3736_s28_q;
  logic and_3764_s28_q;
  logic not_3766_s28_q;
  logic or_3770_s28_q;
  logic and_3874_s28_q;
  logic and_3892_s28_q;
  logic and_3895_s28_q;
  logic not_3904_s28_q;
  logic [31:0] select_3960_s28_q;
  logic [9:0] select_3962_s28_q;
  always_ff @(posedge clk_i) begin
    if (s27_en) begin
      pixel_0_s28_q <= pixel_0_s27_q;
      pixel_1_s28_q <= pixel_1_s27_q;
      saturated_s28_q <= saturated_s27_q;
      mask_s28_q <= mask_s27_q;
      marks_first_s28_q <= marks_first_s27_q;
      marks_last_s28_q <= marks_last_s27_q;
      sample_pair_pixel_1_s28_q <= sample_pair_pixel_1_s27_q;
      census_columns_values_1_cell_2_of_skin_s28_q <= census_columns_values_1_cell_2_of_skin_s27_q;
      x_s28_q <= x_s27_q;
      registration_moved_s28_q <= registration_moved_s27_q;
      patches_lower_s28_q <= patches_lower_s27_q;
      patches_second_s28_q <= patches_second_s27_q;
      patches_summed_row_column_s28_q <= patches_summed_row_column_s27_q;
      patches_summed_first_s28_q <= patches_summed_first_s27_q;
      patches_summed_last_s28_q <= patches_summed_last_s27_q;
      patches_summed_down_by_s28_q <= patches_summed_down_by_s27_q;
      column_s28_q <= column_s27_q;
      and_521_s28_q <= and_521_s27_q;
      so_s28_q <= so_s27_q;
      less_555_s28_q <= less_555_s27_q;
      less_556_s28_q <= less_556_s27_q;
      less_557_s28_q <= less_557_s27_q;
      less_558_s28_q <= less_558_s27_q;
      less_559_s28_q <= less_559_s27_q;
      less_560_s28_q <= less_560_s27_q;
      less_561_s28_q <= less_561_s27_q;
      less_562_s28_q <= less_562_s27_q;
      less_563_s28_q <= less_563_s27_q;
      less_564_s28_q <= less_564_s27_q;
      less_565_s28_q <= less_565_s27_q;
      less_566_s28_q <= less_566_s27_q;
      less_567_s28_q <= less_567_s27_q;
      less_568_s28_q <= less_568_s27_q;
      less_569_s28_q <= less_569_s27_q;
      less_570_s28_q <= less_570_s27_q;
      less_571_s28_q <= less_571_s27_q;
      less_572_s28_q <= less_572_s27_q;
      less_573_s28_q <= less_573_s27_q;
      less_574_s28_q <= less_574_s27_q;
      less_575_s28_q <= less_575_s27_q;
      less_576_s28_q <= less_576_s27_q;
      less_577_s28_q <= less_577_s27_q;
      less_578_s28_q <= less_578_s27_q;
      and_586_s28_q <= and_586_s27_q;
      and_611_s28_q <= and_611_s27_q;
      and_612_s28_q <= and_612_s27_q;
      less_635_s28_q <= 9'h4 < sum_634_s27_q;
      equal_1479_s28_q <= equal_1479_s27_q;
      equal_1524_s28_q <= equal_1524_s27_q;
      equal_1532_s28_q <= equal_1532_s27_q;
      equal_1700_s28_q <= equal_1700_s27_q;
      equal_1702_s28_q <= equal_1702_s27_q;
      select_1727_s28_q <= or_1726_s27_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1730_s28_q <= select_1730_s27_q;
      and_1740_s28_q <= sample_pair_whole_s27_q & and_1739;
      select_1756_s28_q <= or_1755_s27_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1760_s28_q <= sample_pair_whole_s27_q & and_1759;
      less_1861_s28_q <= less_1861_s27_q;
      equal_1862_s28_q <= equal_1862_s27_q;
      not_1863_s28_q <= not_1863_s27_q;
      equal_1864_s28_q <= equal_1864_s27_q;
      not_1890_s28_q <= not_1890_s27_q;
      and_1950_s28_q <= and_1950_s27_q;
      less_1951_s28_q <= less_1951_s27_q;
      equal_2170_s28_q <= equal_2170_s27_q;
      and_2175_s28_q <= and_611_s27_q & (9'h4 < sum_2173_s27_q);
      equal_2223_s28_q <= equal_2223_s27_q;
      sum_s28_q <= sum[0];
      sum_2_s28_q <= sum_2[0];
      equal_2267_s28_q <= equal_2267_s27_q;
      select_2285_s28_q <= sharpness_comparing_less_contrast_0_q;
      select_2291_s28_q <= sharpness_comparing_less_contrast_1_q;
      select_2468_s28_q <= select_2468_s27_q;
      select_2471_s28_q <= select_2471_s27_q;
      equal_2673_s28_q <= equal_2673_s27_q;
      parity_3005_s28_q <= parity_3005_s27_q;
      parity_3134_s28_q <= parity_3134_s27_q;
      parity_3196_s28_q <= parity_3196;
      xor_3224_s28_q <= parity_3211 ^ parity_3223;
      parity_3236_s28_q <= ^{or_3233, or_3229, and_3225};
      and_3237_s28_q <= or_3229 & or_3233;
      and_3239_s28_q <= and_3225 & (or_3229 | or_3233);
      equal_3241_s28_q <= equal_3241_s27_q;
      or_3384_s28_q <= or_3384;
      difference_3431_s28_q <= difference_3431[5:0];
      not_3433_s28_q <= ~less_3432;
      not_3443_s28_q <= ~($signed(difference_3431) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3481_s28_q <= equal_3481_s27_q;
      less_3555_s28_q <= $signed(15'h10) < $signed(difference_3431);
      less_3556_s28_q <= $signed(difference_3431[14:4]) < $signed(11'h7ff);
      equal_3588_s28_q <= equal_3588_s27_q;
      less_3610_s28_q <= less_3610_s27_q;
      or_3707_s28_q <= or_3707_s27_q;
      select_3715_s28_q <= select_3715_s27_q;
      select_3736_s28_q <= select_3736;
      and_3764_s28_q <= over[14] & equal_3481_s27_q;
      not_3766_s28_q <= not_3766_s27_q;
      or_3770_s28_q <= or_3770_s27_q;
      and_3874_s28_q <= and_3874_s27_q;
      and_3892_s28_q <= select_3890[0] & and_3891;
      and_3895_s28_q <= select_3890[1] & and_3891;
      not_3904_s28_q <= not_3904_s27_q;
      select_3960_s28_q <= select_3960_s27_q;
      select_3962_s28_q <= select_3962_s27_q;
    end
  end

  // Stage 28 ----------------------------------------------------------------------------------------------------------
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
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:303
  logic and_636;
  assign and_636 = and_586_s28_q & less_635_s28_q;
  // hls/stages/patches.hpp:184
  logic less_1873;
  assign less_1873 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1874;
  assign not_1874 = ~less_1873;
  logic [1:0] select_1875;
  assign select_1875 = patches_summed_first_s28_q ? 2'h2 : {less_1873, not_1874};
  logic [12:0] select_1876;
  assign select_1876 = select_1875[0] ? {4'h0, patches_summed_first_s28_q, 3'h0, patches_summed_row_column_s28_q} : {patches_summed_row_column_s28_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1877;
  assign select_1877 = select_1875[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1878;
  assign select_1878 = select_1875[1] ? {select_1876[12:8], patches_sums_values_0_q[9:8], select_1876[7:0]} : select_1877;
  // hls/stages/census.hpp:306
  logic and_2176;
  assign and_2176 = and_611_s28_q & less_635_s28_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2177;
  assign sum_2177 = census_left_misses_q + {{17{and_2176}}, and_2175_s28_q, 1'b0, and_2175_s28_q};
  // hls/stages/agreement.hpp:511
  logic [19:0] select_2179;
  assign select_2179 = and_521_s28_q ? (equal_2170_s28_q ? 20'h0 : sum_2177) : census_left_misses_q;
  // hls/stages/agreement.hpp:210
  logic [2:0] select_2251;
  assign select_2251 = equal_2223_s28_q ? {sharpness_comparing_product_0_q[1:0], sum_s28_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2253;
  assign select_2253 = equal_2223_s28_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s28_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s28_q});
  // hls/stages/agreement.hpp:210
  logic select_2262;
  assign select_2262 = so_s28_q ? (equal_2223_s28_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s28_q});
  // hls/stages/agreement.hpp:210
  logic select_2265;
  assign select_2265 = equal_2223_s28_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_2268;
  assign xor_2268 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2274;
  assign xor_2274 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/count_bits.hpp:27
  logic or_3240;
  assign or_3240 = and_3237_s28_q | and_3239_s28_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3240, parity_3236_s28_q, xor_3224_s28_q, parity_3196_s28_q, parity_3134_s28_q, parity_3005_s28_q} + (equal_3241_s28_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3245;
  assign select_3245 = equal_1700_s28_q ? patches_sums_values_0_q : (equal_1702_s28_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3246;
  assign select_3246 = equal_1702_s28_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3248;
  assign select_3248 = equal_1702_s28_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3250;
  assign select_3250 = equal_1702_s28_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3252;
  assign select_3252 = equal_1702_s28_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3254;
  assign select_3254 = equal_1702_s28_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3256;
  assign select_3256 = equal_1702_s28_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3258;
  assign select_3258 = equal_1702_s28_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3260;
  assign select_3260 = equal_1702_s28_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3262;
  assign select_3262 = equal_1702_s28_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3264;
  assign select_3264 = equal_1702_s28_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3266;
  assign select_3266 = equal_1702_s28_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3268;
  assign select_3268 = equal_1702_s28_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3270;
  assign select_3270 = equal_1702_s28_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3272;
  assign select_3272 = equal_1702_s28_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3274;
  assign select_3274 = equal_1702_s28_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3276;
  assign select_3276 = equal_1702_s28_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:574
  logic not_3385;
  assign not_3385 = ~or_3384_s28_q;
  // hls/stages/patches.hpp:555
  logic and_3386;
  assign and_3386 = equal_1864_s28_q & not_3385;
  // hls/stages/patches.hpp:184
  logic and_3389;
  assign and_3389 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3386) : and_3386);
  // hls/stages/patches.hpp:555
  logic and_3392;
  assign and_3392 = equal_1864_s28_q & (patches_second_s28_q & not_3385);
  // hls/stages/patches.hpp:184
  logic and_3395;
  assign and_3395 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3392) : and_3392);
  // hls/stages/patches.hpp:555
  logic and_3435;
  assign and_3435 = equal_1864_s28_q & (not_3385 & not_3433_s28_q);
  // hls/stages/patches.hpp:184
  logic and_3438;
  assign and_3438 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3435) : and_3435);
  // hls/stages/patches.hpp:555
  logic and_3445;
  assign and_3445 = equal_1864_s28_q & (not_3385 & not_3443_s28_q);
  // hls/stages/patches.hpp:184
  logic and_3448;
  assign and_3448 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3445) : and_3445);
  // hls/stages/agreement.hpp:1085
  logic less_3482;
  assign less_3482 = x_s28_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:776
  logic and_3486;
  assign and_3486 = equal_1479_s28_q & (x_s28_q[6] & (not_1890_s28_q & (equal_3481_s28_q & less_3482)));
  // hls/stages/agreement.hpp:1097
  logic and_3491;
  assign and_3491 = x_s28_q[6] & (not_1890_s28_q & (less_3482 & (x_s28_q[2:0] == 3'h1)));
  logic and_3498;
  assign and_3498 = x_s28_q[6] & (not_1890_s28_q & (less_3482 & (x_s28_q[2:0] == 3'h2)));
  logic and_3505;
  assign and_3505 = x_s28_q[6] & (not_1890_s28_q & (less_3482 & (x_s28_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:199
  logic select_3512;
  assign select_3512 = (x_s28_q[5:3] == 3'h2) ? x_s28_q[1] : (x_s28_q[0] & (x_s28_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3539;
  assign sum_3539 = {2'h0, x_s28_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:601
  logic [5:0] select_3558;
  assign select_3558 = less_3555_s28_q ? 6'h10 : (less_3556_s28_q ? 6'h30 : difference_3431_s28_q);
  // hls/stages/patches.hpp:555
  logic [5:0] select_3560;
  assign select_3560 = equal_1864_s28_q ? (or_3384_s28_q ? 6'h0 : select_3558) : 6'h0;
  logic [5:0] select_3562;
  assign select_3562 = less_1861_s28_q ? (equal_1862_s28_q ? 6'h0 : select_3560) : select_3560;
  // hls/stages/agreement.hpp:776
  logic and_3569;
  assign and_3569 = equal_1479_s28_q & (x_s28_q[6] & (not_1890_s28_q & (equal_2673_s28_q & less_3482)));
  // hls/stages/agreement.hpp:1097
  logic and_3573;
  assign and_3573 = x_s28_q[6] & (not_1890_s28_q & (less_3482 & (x_s28_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:555
  logic and_3612;
  assign and_3612 = equal_1864_s28_q & (not_3385 & less_3610_s28_q);
  // hls/stages/patches.hpp:184
  logic and_3615;
  assign and_3615 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3612) : and_3612);
  // hls/stages/agreement.hpp:1099
  logic not_3737;
  assign not_3737 = ~hidden_for_q[7];
  logic [7:0] select_3739;
  assign select_3739 = select_3736_s28_q ? (hidden_for_q + {7'h0, not_3737}) : 8'h0;
  // hls/stages/agreement.hpp:776
  logic [7:0] select_3741;
  assign select_3741 = equal_1479_s28_q ? (equal_3588_s28_q ? select_3739 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1172
  logic and_3767;
  assign and_3767 = too_much_q & not_3766_s28_q;
  // hls/stages/agreement.hpp:1173
  logic select_3772;
  assign select_3772 = and_3764_s28_q ? (and_3767 | or_3770_s28_q) : and_3767;
  // hls/stages/agreement.hpp:428
  logic select_3894;
  assign select_3894 = and_1950_s28_q ? (less_1951_s28_q ? and_3892_s28_q : seen_q) : seen_q;
  logic select_3897;
  assign select_3897 = and_1950_s28_q ? (less_1951_s28_q ? and_3895_s28_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1101
  logic or_3923;
  assign or_3923 = select_2285_s28_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:776
  logic and_3946;
  assign and_3946 = equal_1479_s28_q & (x_s28_q[6] & (not_1890_s28_q | (4'hc < x_s28_q[5:2])));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s28_q;
  logic fresh_we;
  assign fresh_we = s28_en & and_521_s28_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s28_q, and_636, and_612_s28_q, and_611_s28_q, and_586_s28_q, less_578_s28_q, less_577_s28_q, less_576_s28_q, less_575_s28_q, less_574_s28_q, less_573_s28_q, less_572_s28_q, less_571_s28_q, less_570_s28_q, less_569_s28_q, less_568_s28_q, less_567_s28_q, less_566_s28_q, less_565_s28_q, less_564_s28_q, less_563_s28_q, less_562_s28_q, less_561_s28_q, less_560_s28_q, less_559_s28_q, less_558_s28_q, less_557_s28_q, less_556_s28_q, less_555_s28_q};
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
  logic [6:0] fresh_raddr_s27_sim;
  logic fresh_re_s27_sim;
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
      fresh_re_s27_sim <= 1'b0;
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
      fresh_re_s27_sim <= fresh_re_s26_sim;
      fresh_raddr_s27_sim <= fresh_raddr_s26_sim;
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
      if (fresh_re_s27_sim && fresh_raddr_s27_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_waddr >= 7'd120) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd120) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1730_s28_q, select_1727_s28_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s28_en & and_1740_s28_q;
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
  assign patches_right_1_waddr = {select_1730_s28_q, select_1756_s28_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s28_en & and_1760_s28_q;
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
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s28_en) begin
      census_left_misses_q <= select_2179;
      sharpness_comparing_product_0_q <= so_s28_q ? select_2251 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s28_q ? select_2253 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2262;
      sharpness_comparing_carry_1_q <= so_s28_q ? select_2265 : sharpness_comparing_carry_1_q;
      patches_sums_values_0_q <= select_3245;
      patches_sums_values_1_q <= equal_1700_s28_q ? patches_sums_values_1_q : select_3246;
      patches_sums_values_2_q <= equal_1700_s28_q ? patches_sums_values_2_q : select_3248;
      patches_sums_values_3_q <= equal_1700_s28_q ? patches_sums_values_3_q : select_3250;
      patches_sums_values_4_q <= equal_1700_s28_q ? patches_sums_values_4_q : select_3252;
      patches_sums_values_5_q <= equal_1700_s28_q ? patches_sums_values_5_q : select_3254;
      patches_sums_values_6_q <= equal_1700_s28_q ? patches_sums_values_6_q : select_3256;
      patches_sums_values_7_q <= equal_1700_s28_q ? patches_sums_values_7_q : select_3258;
      patches_sums_values_8_q <= equal_1700_s28_q ? patches_sums_values_8_q : select_3260;
      patches_sums_values_9_q <= equal_1700_s28_q ? patches_sums_values_9_q : select_3262;
      patches_sums_values_10_q <= equal_1700_s28_q ? patches_sums_values_10_q : select_3264;
      patches_sums_values_11_q <= equal_1700_s28_q ? patches_sums_values_11_q : select_3266;
      patches_sums_values_12_q <= equal_1700_s28_q ? patches_sums_values_12_q : select_3268;
      patches_sums_values_13_q <= equal_1700_s28_q ? patches_sums_values_13_q : select_3270;
      patches_sums_values_14_q <= equal_1700_s28_q ? patches_sums_values_14_q : select_3272;
      patches_sums_values_15_q <= equal_1700_s28_q ? patches_sums_values_15_q : select_3274;
      patches_sums_values_16_q <= equal_1700_s28_q ? patches_sums_values_16_q : select_3276;
      patches_best_differing_q <= select_1878[9:0];
      patches_best_column_q <= select_1878[14:10];
      patches_frame_ended_q <= equal_1479_s28_q & ((x_s28_q == 7'h70) & (~equal_3588_s28_q));
      hidden_for_q <= select_3741;
      too_much_q <= equal_1479_s28_q ? select_3772 : too_much_q;
      seen_q <= select_3894;
      nearer_q <= select_3897;
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
  logic x_s29_q;
  logic registration_moved_s29_q;
  logic patches_lower_s29_q;
  logic patches_summed_last_s29_q;
  logic [4:0] patches_summed_down_by_s29_q;
  logic patches_frame_ended_s29_q;
  logic so_s29_q;
  logic equal_1479_s29_q;
  logic equal_1524_s29_q;
  logic equal_1532_s29_q;
  logic equal_2223_s29_q;
  logic or_2269_s29_q;
  logic and_2270_s29_q;
  logic or_2275_s29_q;
  logic and_2276_s29_q;
  logic select_2291_s29_q;
  logic [9:0] select_2468_s29_q;
  logic [9:0] select_2471_s29_q;
  logic and_3389_s29_q;
  logic and_3395_s29_q;
  logic and_3438_s29_q;
  logic and_3448_s29_q;
  logic and_3486_s29_q;
  logic and_3492_s29_q;
  logic and_3499_s29_q;
  logic and_3506_s29_q;
  logic and_3515_s29_q;
  logic and_3542_s29_q;
  logic [5:0] select_3563_s29_q;
  logic and_3569_s29_q;
  logic and_3574_s29_q;
  logic equal_3588_s29_q;
  logic and_3616_s29_q;
  logic or_3707_s29_q;
  logic and_3874_s29_q;
  logic not_3904_s29_q;
  logic or_3914_s29_q;
  logic or_3923_s29_q;
  logic not_3935_s29_q;
  logic and_3946_s29_q;
  logic [5:0] select_3948_s29_q;
  logic [31:0] select_3960_s29_q;
  logic [9:0] select_3962_s29_q;
  always_ff @(posedge clk_i) begin
    if (s28_en) begin
      pixel_0_s29_q <= pixel_0_s28_q;
      pixel_1_s29_q <= pixel_1_s28_q;
      saturated_s29_q <= saturated_s28_q;
      mask_s29_q <= mask_s28_q;
      marks_first_s29_q <= marks_first_s28_q;
      marks_last_s29_q <= marks_last_s28_q;
      x_s29_q <= x_s28_q[6];
      registration_moved_s29_q <= registration_moved_s28_q;
      patches_lower_s29_q <= patches_lower_s28_q;
      patches_summed_last_s29_q <= patches_summed_last_s28_q;
      patches_summed_down_by_s29_q <= patches_summed_down_by_s28_q;
      patches_frame_ended_s29_q <= patches_frame_ended_q;
      so_s29_q <= so_s28_q;
      equal_1479_s29_q <= equal_1479_s28_q;
      equal_1524_s29_q <= equal_1524_s28_q;
      equal_1532_s29_q <= equal_1532_s28_q;
      equal_2223_s29_q <= equal_2223_s28_q;
      or_2269_s29_q <= equal_2267_s28_q | xor_2268;
      and_2270_s29_q <= five_times[0] & xor_2268;
      or_2275_s29_q <= equal_2267_s28_q | xor_2274;
      and_2276_s29_q <= five_times_2[0] & xor_2274;
      select_2291_s29_q <= select_2291_s28_q;
      select_2468_s29_q <= select_2468_s28_q;
      select_2471_s29_q <= select_2471_s28_q;
      and_3389_s29_q <= and_3389;
      and_3395_s29_q <= and_3395;
      and_3438_s29_q <= and_3438;
      and_3448_s29_q <= and_3448;
      and_3486_s29_q <= and_3486;
      and_3492_s29_q <= equal_1479_s28_q & and_3491;
      and_3499_s29_q <= equal_1479_s28_q & and_3498;
      and_3506_s29_q <= equal_1479_s28_q & and_3505;
      and_3515_s29_q <= x_s28_q[6] & (not_1890_s28_q & (less_3482 & select_3512));
      and_3542_s29_q <= not_1890_s28_q & (less_3482 & (sum_3539[4:2] == 3'h0));
      select_3563_s29_q <= equal_1700_s28_q ? select_3562 : 6'h0;
      and_3569_s29_q <= and_3569;
      and_3574_s29_q <= equal_1479_s28_q & and_3573;
      equal_3588_s29_q <= equal_3588_s28_q;
      and_3616_s29_q <= and_3389 & and_3615;
      or_3707_s29_q <= or_3707_s28_q;
      and_3874_s29_q <= and_3874_s28_q;
      not_3904_s29_q <= not_3904_s28_q;
      or_3914_s29_q <= select_3715_s28_q | select_3772;
      or_3923_s29_q <= or_3923;
      not_3935_s29_q <= ~(select_3739 < cfg_hidden_frames_i);
      and_3946_s29_q <= and_3946;
      select_3948_s29_q <= equal_1479_s28_q ? (x_s28_q[6] ? x_s28_q[5:0] : 6'h0) : 6'h0;
      select_3960_s29_q <= select_3960_s28_q;
      select_3962_s29_q <= select_3962_s28_q;
    end
  end

  // Stage 29 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:385
  logic select_2271;
  assign select_2271 = or_2269_s29_q ? and_2270_s29_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:210
  logic select_2272;
  assign select_2272 = equal_2223_s29_q ? select_2271 : sharpness_comparing_less_detail_0_q;
  logic select_2273;
  assign select_2273 = so_s29_q ? select_2272 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_2277;
  assign select_2277 = or_2275_s29_q ? and_2276_s29_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:210
  logic select_2278;
  assign select_2278 = equal_2223_s29_q ? select_2277 : sharpness_comparing_less_detail_1_q;
  logic select_2279;
  assign select_2279 = so_s29_q ? select_2278 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:652
  logic not_3390;
  assign not_3390 = ~patches_lower_s29_q;
  logic not_3396;
  assign not_3396 = ~and_3395_s29_q;
  // hls/stages/patches.hpp:188
  logic and_3398;
  assign and_3398 = and_3389_s29_q & (not_3390 & not_3396);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3400;
  assign sum_3400 = {7'h0, and_3398} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:655
  logic and_3439;
  assign and_3439 = and_3438_s29_q & and_3398;
  logic [7:0] sum_3440;
  assign sum_3440 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3439};
  // hls/stages/patches.hpp:656
  logic and_3449;
  assign and_3449 = and_3448_s29_q & and_3398;
  logic [7:0] sum_3450;
  assign sum_3450 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3449};
  // hls/stages/patches.hpp:188
  logic and_3452;
  assign and_3452 = and_3389_s29_q & (and_3395_s29_q & not_3390);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3454;
  assign sum_3454 = {7'h0, and_3452} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_3456;
  assign and_3456 = and_3438_s29_q & and_3452;
  logic [7:0] sum_3457;
  assign sum_3457 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3456};
  // hls/stages/patches.hpp:656
  logic and_3459;
  assign and_3459 = and_3448_s29_q & and_3452;
  logic [7:0] sum_3460;
  assign sum_3460 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3459};
  // hls/stages/patches.hpp:188
  logic and_3462;
  assign and_3462 = and_3389_s29_q & (patches_lower_s29_q & not_3396);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3464;
  assign sum_3464 = {7'h0, and_3462} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_3466;
  assign and_3466 = and_3438_s29_q & and_3462;
  logic [7:0] sum_3467;
  assign sum_3467 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3466};
  // hls/stages/patches.hpp:656
  logic and_3469;
  assign and_3469 = and_3448_s29_q & and_3462;
  logic [7:0] sum_3470;
  assign sum_3470 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3469};
  // hls/stages/patches.hpp:188
  logic and_3472;
  assign and_3472 = and_3389_s29_q & (patches_lower_s29_q & and_3395_s29_q);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3474;
  assign sum_3474 = {7'h0, and_3472} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_3476;
  assign and_3476 = and_3438_s29_q & and_3472;
  logic [7:0] sum_3477;
  assign sum_3477 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3476};
  // hls/stages/patches.hpp:656
  logic and_3479;
  assign and_3479 = and_3448_s29_q & and_3472;
  logic [7:0] sum_3480;
  assign sum_3480 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3479};
  // hls/stages/patches.hpp:618
  logic [7:0] or_3494;
  assign or_3494 = (and_3486_s29_q ? patches_quarters_0_places_q : 8'h0) | (and_3492_s29_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3508;
  assign or_3508 = (or_3494 | (and_3499_s29_q ? patches_quarters_2_places_q : 8'h0)) | (and_3506_s29_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:776
  logic and_3516;
  assign and_3516 = equal_1479_s29_q & and_3515_s29_q;
  // hls/stages/patches.hpp:619
  logic [7:0] select_3518;
  assign select_3518 = and_3486_s29_q ? (and_3516 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3520;
  assign select_3520 = and_3492_s29_q ? (and_3516 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3523;
  assign select_3523 = and_3499_s29_q ? (and_3516 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3526;
  assign select_3526 = and_3506_s29_q ? (and_3516 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3529;
  assign select_3529 = and_3486_s29_q ? (and_3516 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3531;
  assign select_3531 = and_3492_s29_q ? (and_3516 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3534;
  assign select_3534 = and_3499_s29_q ? (and_3516 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3537;
  assign select_3537 = and_3506_s29_q ? (and_3516 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:776
  logic and_3544;
  assign and_3544 = equal_1479_s29_q & (x_s29_q & and_3542_s29_q);
  // hls/stages/patches.hpp:613
  logic [7:0] sum_3546;
  assign sum_3546 = patches_word_places_q + (and_3492_s29_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:615
  logic [7:0] select_3550;
  assign select_3550 = and_3544 ? (patches_word_up_q + (and_3492_s29_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3552;
  assign sum_3552 = patches_word_down_q + (and_3492_s29_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:658
  logic [5:0] select_3564;
  assign select_3564 = and_3389_s29_q ? select_3563_s29_q : 6'h0;
  logic [11:0] sum_3565;
  assign sum_3565 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3564[5]}}, select_3564};
  // hls/stages/patches.hpp:642
  logic [7:0] select_3576;
  assign select_3576 = and_3569_s29_q ? (and_3574_s29_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:644
  logic or_3580;
  assign or_3580 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:645
  logic or_3583;
  assign or_3583 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic [8:0] sum_3584;
  assign sum_3584 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:641
  logic select_3586;
  assign select_3586 = and_3569_s29_q ? (and_3574_s29_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3593;
  assign and_3593 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_3594;
  assign select_3594 = and_3569_s29_q ? {and_3593, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3596;
  assign select_3596 = and_3569_s29_q ? (and_3574_s29_q ? {and_3593, patches_found_q[2:1]} : select_3594) : patches_found_q;
  // hls/stages/patches.hpp:640
  logic or_3599;
  assign or_3599 = patches_partly_q | (patches_doubted_q & (~and_3574_s29_q));
  // hls/stages/patches.hpp:641
  logic select_3601;
  assign select_3601 = and_3574_s29_q ? or_3599 : (and_3569_s29_q ? or_3599 : patches_doubted_q);
  // hls/stages/patches.hpp:639
  logic select_3603;
  assign select_3603 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_3607;
  assign select_3607 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3617;
  assign sum_3617 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3616_s29_q};
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_3640;
  assign select_3640 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_3646;
  assign and_3646 = patches_frame_ended_s29_q & (~patches_age_q[9]);
  logic [9:0] sum_3647;
  assign sum_3647 = patches_age_q + {9'h0, and_3646};
  logic [9:0] select_3650;
  assign select_3650 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3647)) : sum_3647;
  // hls/stages/agreement.hpp:1182
  logic or_3905;
  assign or_3905 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_3904_s29_q;
  // hls/stages/agreement.hpp:776
  logic and_3911;
  assign and_3911 = equal_1479_s29_q & (equal_3588_s29_q & (cfg_prove_i & or_3707_s29_q));
  // hls/stages/agreement.hpp:1184
  logic not_3913;
  assign not_3913 = ~(or_3707_s29_q | not_3898);
  // hls/stages/agreement.hpp:776
  logic and_3917;
  assign and_3917 = equal_1479_s29_q & (equal_3588_s29_q & (not_3913 & or_3914_s29_q));
  logic and_3920;
  assign and_3920 = equal_3588_s29_q & (cfg_prove_i & (registration_moved_s29_q | patches_moved_q));
  logic and_3930;
  assign and_3930 = equal_3588_s29_q & (not_3913 & (select_2279 | select_2291_s29_q));
  // hls/stages/agreement.hpp:1101
  logic and_3937;
  assign and_3937 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_3935_s29_q);
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_3961;
  assign select_3961 = equal_1532_s29_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3960_s29_q;
  // hls/stages/agreement.hpp:1097
  logic [31:0] select_3963;
  assign select_3963 = equal_1524_s29_q ? select_3961 : {2'h0, select_3962_s29_q, select_2471_s29_q, select_2468_s29_q};

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
    end else if (s29_en) begin
      sharpness_comparing_less_detail_0_q <= select_2273;
      sharpness_comparing_less_detail_1_q <= select_2279;
      patches_quarters_0_places_q <= sum_3400;
      patches_quarters_0_up_q <= sum_3440;
      patches_quarters_0_down_q <= sum_3450;
      patches_quarters_1_places_q <= sum_3454;
      patches_quarters_1_up_q <= sum_3457;
      patches_quarters_1_down_q <= sum_3460;
      patches_quarters_2_places_q <= sum_3464;
      patches_quarters_2_up_q <= sum_3467;
      patches_quarters_2_down_q <= sum_3470;
      patches_quarters_3_places_q <= sum_3474;
      patches_quarters_3_up_q <= sum_3477;
      patches_quarters_3_down_q <= sum_3480;
      patches_word_places_q <= or_3508;
      patches_word_up_q <= ((select_3518 | select_3520) | select_3523) | select_3526;
      patches_word_down_q <= ((select_3529 | select_3531) | select_3534) | select_3537;
      patches_sum_places_q <= and_3544 ? sum_3546 : patches_sum_places_q;
      patches_sum_up_q <= select_3550;
      patches_sum_down_q <= and_3544 ? sum_3552 : patches_sum_down_q;
      patches_across_q <= sum_3565;
      patches_places_q <= select_3576;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3580;
      patches_partly_q <= or_3583;
      patches_clear_limit_q <= sum_3584[8:2];
      patches_complete_q <= select_3586;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3596;
      patches_doubted_q <= and_3569_s29_q ? select_3601 : patches_doubted_q;
      patches_doubted_before_q <= select_3603;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3607;
      patches_on_skin_q <= sum_3617;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3640;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3650;
    end
  end

  logic [7:0] pixel_0_s30_q;
  logic [7:0] pixel_1_s30_q;
  logic saturated_s30_q;
  logic mask_s30_q;
  logic marks_first_s30_q;
  logic marks_last_s30_q;
  logic patches_round_ends_s30_q;
  logic [7:0] patches_on_skin_s30_q;
  logic equal_1479_s30_q;
  logic equal_3588_s30_q;
  logic and_3874_s30_q;
  logic or_3899_s30_q;
  logic and_3900_s30_q;
  logic and_3908_s30_q;
  logic and_3911_s30_q;
  logic and_3917_s30_q;
  logic and_3921_s30_q;
  logic and_3926_s30_q;
  logic and_3930_s30_q;
  logic and_3939_s30_q;
  logic and_3946_s30_q;
  logic [5:0] select_3948_s30_q;
  logic [31:0] select_3965_s30_q;
  always_ff @(posedge clk_i) begin
    if (s29_en) begin
      pixel_0_s30_q <= pixel_0_s29_q;
      pixel_1_s30_q <= pixel_1_s29_q;
      saturated_s30_q <= saturated_s29_q;
      mask_s30_q <= mask_s29_q;
      marks_first_s30_q <= marks_first_s29_q;
      marks_last_s30_q <= marks_last_s29_q;
      patches_round_ends_s30_q <= patches_round_ends_q;
      patches_on_skin_s30_q <= patches_on_skin_q;
      equal_1479_s30_q <= equal_1479_s29_q;
      equal_3588_s30_q <= equal_3588_s29_q;
      and_3874_s30_q <= and_3874_s29_q;
      or_3899_s30_q <= not_3898 | seen_q;
      and_3900_s30_q <= cfg_prove_i & nearer_q;
      and_3908_s30_q <= equal_1479_s29_q & (equal_3588_s29_q & (cfg_prove_i & or_3905));
      and_3911_s30_q <= and_3911;
      and_3917_s30_q <= and_3917;
      and_3921_s30_q <= equal_1479_s29_q & and_3920;
      and_3926_s30_q <= equal_3588_s29_q & (not_3913 & (select_2273 | or_3923_s29_q));
      and_3930_s30_q <= and_3930;
      and_3939_s30_q <= equal_1479_s29_q & (equal_3588_s29_q & and_3937);
      and_3946_s30_q <= and_3946_s29_q;
      select_3948_s30_q <= select_3948_s29_q;
      select_3965_s30_q <= equal_1479_s29_q ? (x_s29_q ? select_3963 : 32'h0) : 32'h0;
    end
  end

  // Stage 30 ----------------------------------------------------------------------------------------------------------
  logic [7:0] patches_on_skin_most_q;
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:649
  logic [12:0] product_3618;
  assign product_3618 = {8'h0, cfg_on_skin_limit_i} * {5'h0, patches_places_q};
  // hls/stages/patches.hpp:188
  logic and_3624;
  assign and_3624 = (~(patches_on_skin_s30_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_s30_q);
  logic select_3629;
  assign select_3629 = patches_round_ends_s30_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_3633;
  assign or_3633 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s30_q));
  // hls/stages/agreement.hpp:776
  logic and_3942;
  assign and_3942 = equal_1479_s30_q & (equal_3588_s30_q & (cfg_prove_i & patches_overlooked_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_on_skin_most_q <= 8'h0;
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s30_en) begin
      patches_on_skin_most_q <= product_3618[12:5];
      patches_large_q <= (~(cfg_on_skin_limit_i == 5'h1f)) & and_3624;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3629;
      patches_spoiled_q <= or_3633;
    end
  end

  logic [7:0] pixel_0_s31_q;
  logic [7:0] pixel_1_s31_q;
  logic saturated_s31_q;
  logic mask_s31_q;
  logic marks_first_s31_q;
  logic marks_last_s31_q;
  logic and_3874_s31_q;
  logic or_3899_s31_q;
  logic and_3900_s31_q;
  logic and_3908_s31_q;
  logic and_3911_s31_q;
  logic and_3917_s31_q;
  logic and_3921_s31_q;
  logic and_3927_s31_q;
  logic and_3931_s31_q;
  logic and_3939_s31_q;
  logic and_3942_s31_q;
  logic and_3946_s31_q;
  logic [5:0] select_3948_s31_q;
  logic [31:0] select_3965_s31_q;
  always_ff @(posedge clk_i) begin
    if (s30_en) begin
      pixel_0_s31_q <= pixel_0_s30_q;
      pixel_1_s31_q <= pixel_1_s30_q;
      saturated_s31_q <= saturated_s30_q;
      mask_s31_q <= mask_s30_q;
      marks_first_s31_q <= marks_first_s30_q;
      marks_last_s31_q <= marks_last_s30_q;
      and_3874_s31_q <= and_3874_s30_q;
      or_3899_s31_q <= or_3899_s30_q;
      and_3900_s31_q <= and_3900_s30_q;
      and_3908_s31_q <= and_3908_s30_q;
      and_3911_s31_q <= and_3911_s30_q;
      and_3917_s31_q <= and_3917_s30_q;
      and_3921_s31_q <= and_3921_s30_q;
      and_3927_s31_q <= equal_1479_s30_q & and_3926_s30_q;
      and_3931_s31_q <= equal_1479_s30_q & and_3930_s30_q;
      and_3939_s31_q <= and_3939_s30_q;
      and_3942_s31_q <= and_3942;
      and_3946_s31_q <= and_3946_s30_q;
      select_3948_s31_q <= select_3948_s30_q;
      select_3965_s31_q <= select_3965_s30_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s31_q;
  assign pixel_1_o = pixel_1_s31_q;
  assign saturated_o = saturated_s31_q;
  assign mask_o = mask_s31_q;
  assign marks_first_o = marks_first_s31_q;
  assign marks_last_o = marks_last_s31_q;
  assign marks_seen_o = or_3899_s31_q;
  assign marks_nearer_o = and_3900_s31_q;
  assign verdict_valid_o = and_3874_s31_q;
  assign verdict_unproven_yet_o = and_3908_s31_q;
  assign verdict_untextured_o = and_3911_s31_q;
  assign verdict_disagree_o = and_3917_s31_q;
  assign verdict_moved_o = and_3921_s31_q;
  assign verdict_unsharp_left_o = and_3927_s31_q;
  assign verdict_unsharp_right_o = and_3931_s31_q;
  assign verdict_hidden_o = and_3939_s31_q;
  assign verdict_overlooked_o = and_3942_s31_q;
  assign frame_valid_o = and_3946_s31_q;
  assign frame_index_o = select_3948_s31_q;
  assign frame_word_o = select_3965_s31_q;
  assign valid_o = valid_s31_q;

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
      valid_s31_q <= 1'b0;
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
      valid_s31_q <= valid_s30_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], product_3618[4:0], sum_3584[1:0], sum_3539[1:0], product_3430[4:0], sum_2524[0], detail_4[1:0], detail_3[1:0], sum_2173[4:0], sum_1681[1:0], sum_1680[1:0], sum_1676[0], sum_1627[0], sum_1623[0], sum_634[4:0], cfg_width_i[3:0]};

endmodule
