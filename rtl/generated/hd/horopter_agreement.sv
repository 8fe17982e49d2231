// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 30 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2952 bits, pipeline 8742 bits, memories 120207 bits.
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
  logic [6:0] sum_2388;
  assign sum_2388 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3393;
  assign difference_3393 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [7:0] difference_3641;
  assign difference_3641 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_3843;
  assign less_3843 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_3844;
  assign sum_3844 = {1'b0, cfg_height_i[10:7]} + 5'h1f;
  logic not_3862;
  assign not_3862 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:35
  logic [3:0] select_471;
  assign select_471 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_471 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_471_s1_q;
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
      select_471_s1_q <= select_471;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:35
  logic [6:0] select_474;
  assign select_474 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:50
  logic equal_506;
  assign equal_506 = select_471_s1_q == 4'hf;
  // hls/stages/agreement.hpp:263
  logic [6:0] select_2037;
  assign select_2037 = sample_pair_whole_s1_q ? (select_474 + {6'h0, equal_506}) : raster_at_column_q;

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
  logic [3:0] select_471_s2_q;
  logic [6:0] select_474_s2_q;
  logic equal_506_s2_q;
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
      select_471_s2_q <= select_471_s1_q;
      select_474_s2_q <= select_474;
      equal_506_s2_q <= equal_506;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:109
  logic equal_472;
  assign equal_472 = select_471_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:115
  logic [8:0] select_477;
  assign select_477 = ({select_474_s2_q, select_471_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_478;
  assign select_478 = equal_472 ? select_477 : averager_place_q;
  // hls/stages/census.hpp:41
  logic [3:0] select_489;
  assign select_489 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2035;
  assign select_2035 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_489 + 4'h1) : select_489) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2035;
      averager_place_q <= sample_pair_whole_s2_q ? select_478 : averager_place_q;
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
  logic [3:0] select_471_s3_q;
  logic equal_472_s3_q;
  logic [6:0] select_474_s3_q;
  logic [8:0] select_478_s3_q;
  logic equal_480_s3_q;
  logic [3:0] select_489_s3_q;
  logic equal_506_s3_q;
  logic equal_507_s3_q;
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
      select_471_s3_q <= select_471_s2_q;
      equal_472_s3_q <= equal_472;
      select_474_s3_q <= select_474_s2_q;
      select_478_s3_q <= select_478;
      equal_480_s3_q <= select_471_s2_q[1:0] == 2'h3;
      select_489_s3_q <= select_489;
      equal_506_s3_q <= equal_506_s2_q;
      equal_507_s3_q <= select_489 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:41
  logic or_479;
  assign or_479 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_484;
  assign and_484 = (or_479 & equal_480_s3_q) & (~(select_478_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_474_s3_q : 7'h0;
  // hls/stages/census.hpp:126
  logic and_508;
  assign and_508 = equal_507_s3_q & and_484;
  // hls/stages/agreement.hpp:263
  logic and_510;
  assign and_510 = sample_pair_whole_s3_q & (equal_506_s3_q & and_508);
  // hls/stages/census.hpp:41
  logic [6:0] select_569;
  assign select_569 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_569 : 7'h0;
  // hls/stages/census.hpp:57
  logic [6:0] select_2039;
  assign select_2039 = sample_last_s3_q ? (select_569 + {6'h0, equal_507_s3_q}) : select_569;
  // hls/stages/agreement.hpp:263
  logic select_2044;
  assign select_2044 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_479 & (~raster_final_row_q)) : or_479) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [10:0] select_2046;
  assign select_2046 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:263
  logic select_2050;
  assign select_2050 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
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
  logic [3:0] select_471_s4_q;
  logic equal_472_s4_q;
  logic [6:0] select_474_s4_q;
  logic [8:0] select_478_s4_q;
  logic and_484_s4_q;
  logic [3:0] select_489_s4_q;
  logic [6:0] column_s4_q;
  logic and_508_s4_q;
  logic and_510_s4_q;
  logic [3:0] select_569_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1598_s4_q;
  logic equal_2294_s4_q;
  logic and_2295_s4_q;
  logic [7:0] sum_2384_s4_q;
  logic [2:0] or_2769_s4_q;
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
      select_471_s4_q <= select_471_s3_q;
      equal_472_s4_q <= equal_472_s3_q;
      select_474_s4_q <= select_474_s3_q;
      select_478_s4_q <= select_478_s3_q;
      and_484_s4_q <= and_484;
      select_489_s4_q <= select_489_s3_q;
      column_s4_q <= column;
      and_508_s4_q <= and_508;
      and_510_s4_q <= and_510;
      select_569_s4_q <= select_569[3:0];
      row_s4_q <= row;
      equal_1598_s4_q <= {or_479, select_489_s3_q} == 5'h18;
      equal_2294_s4_q <= equal_2294;
      and_2295_s4_q <= and_510 & equal_2294;
      sum_2384_s4_q <= {1'b0, row} + 8'h1;
      or_2769_s4_q <= select_474_s3_q[2:0] | select_569[6:4];
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
  logic equal_530;
  assign equal_530 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:601
  logic equal_533;
  assign equal_533 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_535;
  assign equal_535 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:510
  logic select_2298;
  assign select_2298 = (and_2295_s4_q | (~ends_cell_q)) ? and_2295_s4_q : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2298 ? (and_2295_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2302;
  assign select_2302 = select_2298 ? (and_2295_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2305;
  assign select_2305 = select_2298 ? (following_last_shift_q & (~and_2295_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:522
  logic [7:0] select_2307;
  assign select_2307 = select_2298 ? (and_2295_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:594
  logic and_2308;
  assign and_2308 = run_last_shift_q & equal_533;
  // hls/stages/agreement.hpp:603
  logic select_2310;
  assign select_2310 = equal_533 ? (~run_last_shift_q) : equal_535;
  // hls/stages/agreement.hpp:607
  logic equal_2311;
  assign equal_2311 = run_phase_q == 3'h1;
  logic not_2314;
  assign not_2314 = ~select_2310;
  // hls/stages/agreement.hpp:610
  logic equal_2316;
  assign equal_2316 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2317;
  assign and_2317 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2318;
  assign select_2318 = equal_2316 ? 2'h1 : {2{and_2317}};
  logic [2:0] select_2320;
  assign select_2320 = (and_2308 | (select_2310 | equal_2311)) ? (equal_2311 ? 3'h2 : {not_2314, {2{select_2310}}}) : (equal_530 ? 3'h6 : {select_2318[0], select_2318});
  // hls/stages/agreement.hpp:594
  logic and_2323;
  assign and_2323 = select_2310 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2326;
  assign select_2326 = (plan_shift_q[5] & select_2310) ? value : 7'h0;
  logic [1:0] or_2327;
  assign or_2327 = {2{so}} | select_2326[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_2331;
  assign or_2331 = (select_2310 ? plan_columns_q : 8'h0) | ((equal_2311 | equal_2316) ? whole_q : 8'h0);
  logic [1:0] or_2332;
  assign or_2332 = {2{and_2308}} | or_2331[4:3];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2334;
  assign or_2334 = {or_2331[7:5], or_2332, or_2331[2:0]} | (equal_530 ? drawn_q : 8'h0);
  logic [4:0] or_2335;
  assign or_2335 = {5{so}} | {or_2334[6], or_2334[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2339;
  assign not_2339 = ~run_shift_q[5];
  logic [7:0] select_2342;
  assign select_2342 = equal_533 ? ({{7{not_2339}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2346;
  assign select_2346 = and_2295_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2348;
  assign select_2348 = select_2298 ? {select_2346[6], select_2346} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2351;
  assign select_2351 = select_2298 ? (and_2295_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:447
  logic [6:0] select_2358;
  assign select_2358 = equal_2294_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_2362;
  assign select_2362 = and_510_s4_q ? (equal_2294_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2365;
  assign select_2365 = and_510_s4_q ? (equal_2294_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2379;
  assign select_2379 = (ends_cell_q | select_2298) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_533 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2383;
  assign and_2383 = (~select_2298) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic equal_2385;
  assign equal_2385 = {sum_2384_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2384_s4_q[6:0]};
  // hls/stages/agreement.hpp:507
  logic select_2387;
  assign select_2387 = and_510_s4_q ? (equal_2294_s4_q ? equal_2385 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:361
  logic [8:0] sum_2770;
  assign sum_2770 = {1'b0, select_474_s4_q[3], or_2769_s4_q, select_569_s4_q} + 9'h1;

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
      run_shift_q <= select_2302;
      run_last_shift_q <= select_2305;
      run_span_q <= select_2307;
      following_phase_q <= select_2320;
      following_shift_q <= select_2310 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2323;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2326[6], or_2327, select_2326[3:0]};
      following_columns_q <= {or_2334[7], or_2335[4], or_2334[5:4], or_2335[3:0]};
      plan_shift_q <= equal_533 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2342;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2348;
      columns_left_q <= select_2351;
      last_q <= and_510_s4_q ? (equal_2294_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_510_s4_q ? select_2358 : least_q;
      whole_q <= select_2362;
      drawn_q <= select_2365;
      slot_q <= select_2298 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2379;
      ends_q <= and_2383;
      final_row_q <= select_2387;
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
  logic [3:0] select_471_s5_q;
  logic equal_472_s5_q;
  logic [6:0] select_474_s5_q;
  logic [8:0] select_478_s5_q;
  logic and_484_s5_q;
  logic equal_490_s5_q;
  logic [6:0] column_s5_q;
  logic and_508_s5_q;
  logic and_510_s5_q;
  logic so_s5_q;
  logic equal_530_s5_q;
  logic equal_533_s5_q;
  logic equal_535_s5_q;
  logic [7:0] sum_536_s5_q;
  logic [6:0] row_s5_q;
  logic [7:0] sum_646_s5_q;
  logic equal_655_s5_q;
  logic equal_1479_s5_q;
  logic equal_1598_s5_q;
  logic equal_2294_s5_q;
  logic and_2295_s5_q;
  logic select_2298_s5_q;
  logic not_2772_s5_q;
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
      select_471_s5_q <= select_471_s4_q;
      equal_472_s5_q <= equal_472_s4_q;
      select_474_s5_q <= select_474_s4_q;
      select_478_s5_q <= select_478_s4_q;
      and_484_s5_q <= and_484_s4_q;
      equal_490_s5_q <= select_489_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_508_s5_q <= and_508_s4_q;
      and_510_s5_q <= and_510_s4_q;
      so_s5_q <= so;
      equal_530_s5_q <= equal_530;
      equal_533_s5_q <= equal_533;
      equal_535_s5_q <= equal_535;
      sum_536_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      row_s5_q <= row_s4_q;
      sum_646_s5_q <= {1'b0, last_q} + 8'h3;
      equal_655_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      equal_1479_s5_q <= run_phase_q == 3'h7;
      equal_1598_s5_q <= equal_1598_s4_q;
      equal_2294_s5_q <= equal_2294_s4_q;
      and_2295_s5_q <= and_2295_s4_q;
      select_2298_s5_q <= select_2298;
      not_2772_s5_q <= ~({sum_2770, select_489_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_537;
  assign select_537 = run_shift_s5_q[5] ? x_s5_q : sum_536_s5_q;
  logic less_538;
  assign less_538 = {1'b0, last_s5_q} < select_537;
  // hls/stages/agreement.hpp:216
  logic not_539;
  assign not_539 = ~less_538;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:515
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
  logic [3:0] select_471_s6_q;
  logic equal_472_s6_q;
  logic [6:0] select_474_s6_q;
  logic [8:0] select_478_s6_q;
  logic and_484_s6_q;
  logic equal_490_s6_q;
  logic [6:0] column_s6_q;
  logic and_508_s6_q;
  logic and_510_s6_q;
  logic so_s6_q;
  logic equal_530_s6_q;
  logic equal_533_s6_q;
  logic [6:0] sum_536_s6_q;
  logic less_538_s6_q;
  logic not_539_s6_q;
  logic and_540_s6_q;
  logic [6:0] row_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_650_s6_q;
  logic equal_655_s6_q;
  logic equal_1469_s6_q;
  logic equal_1479_s6_q;
  logic equal_1598_s6_q;
  logic equal_2294_s6_q;
  logic and_2295_s6_q;
  logic not_2772_s6_q;
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
      select_471_s6_q <= select_471_s5_q;
      equal_472_s6_q <= equal_472_s5_q;
      select_474_s6_q <= select_474_s5_q;
      select_478_s6_q <= select_478_s5_q;
      and_484_s6_q <= and_484_s5_q;
      equal_490_s6_q <= equal_490_s5_q;
      column_s6_q <= column_s5_q;
      and_508_s6_q <= and_508_s5_q;
      and_510_s6_q <= and_510_s5_q;
      so_s6_q <= so_s5_q;
      equal_530_s6_q <= equal_530_s5_q;
      equal_533_s6_q <= equal_533_s5_q;
      sum_536_s6_q <= sum_536_s5_q[6:0];
      less_538_s6_q <= less_538;
      not_539_s6_q <= not_539;
      and_540_s6_q <= equal_535_s5_q & not_539;
      row_s6_q <= row_s5_q;
      x_s6_2_q <= x[6:0];
      and_650_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_646_s5_q < select_537)));
      equal_655_s6_q <= equal_655_s5_q;
      equal_1469_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      equal_1479_s6_q <= equal_1479_s5_q;
      equal_1598_s6_q <= equal_1598_s5_q;
      equal_2294_s6_q <= equal_2294_s5_q;
      and_2295_s6_q <= and_2295_s5_q;
      not_2772_s6_q <= not_2772_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  // hls/stages/agreement.hpp:581
  logic or_531;
  assign or_531 = so_s6_q | equal_530_s6_q;
  // hls/stages/agreement.hpp:704
  logic not_532;
  assign not_532 = ~or_531;
  // hls/stages/agreement.hpp:141
  logic select_626;
  assign select_626 = equal_533_s6_q ? not_539_s6_q : and_540_s6_q;
  logic and_651;
  assign and_651 = equal_533_s6_q & and_650_s6_q;
  logic select_652;
  assign select_652 = or_531 ? not_539_s6_q : and_651;
  // hls/stages/agreement.hpp:782
  logic or_657;
  assign or_657 = equal_655_s6_q | ($signed(6'h0) < $signed(run_shift_s6_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_536_s6_q + 7'h7d;

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
  assign left_re = s6_en & (or_531 ? not_539_s6_q : select_626);
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
  assign right_codes_raddr = equal_533_s6_q ? sum_536_s6_q : x_s6_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s6_en & (not_532 & select_626);
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
  assign best_left_raddr = or_531 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_652;
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
  logic [3:0] select_471_s7_q;
  logic equal_472_s7_q;
  logic [6:0] select_474_s7_q;
  logic [8:0] select_478_s7_q;
  logic and_484_s7_q;
  logic equal_490_s7_q;
  logic [6:0] column_s7_q;
  logic and_508_s7_q;
  logic and_510_s7_q;
  logic so_s7_q;
  logic equal_530_s7_q;
  logic or_531_s7_q;
  logic equal_533_s7_q;
  logic less_538_s7_q;
  logic not_539_s7_q;
  logic and_542_s7_q;
  logic [6:0] row_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_652_s7_q;
  logic select_659_s7_q;
  logic and_1461_s7_q;
  logic [6:0] right_s7_q;
  logic select_1470_s7_q;
  logic equal_1479_s7_q;
  logic equal_1598_s7_q;
  logic equal_2294_s7_q;
  logic and_2295_s7_q;
  logic not_2772_s7_q;
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
      select_471_s7_q <= select_471_s6_q;
      equal_472_s7_q <= equal_472_s6_q;
      select_474_s7_q <= select_474_s6_q;
      select_478_s7_q <= select_478_s6_q;
      and_484_s7_q <= and_484_s6_q;
      equal_490_s7_q <= equal_490_s6_q;
      column_s7_q <= column_s6_q;
      and_508_s7_q <= and_508_s6_q;
      and_510_s7_q <= and_510_s6_q;
      so_s7_q <= so_s6_q;
      equal_530_s7_q <= equal_530_s6_q;
      or_531_s7_q <= or_531;
      equal_533_s7_q <= equal_533_s6_q;
      less_538_s7_q <= less_538_s6_q;
      not_539_s7_q <= not_539_s6_q;
      and_542_s7_q <= not_532 & ((~equal_533_s6_q) & and_540_s6_q);
      row_s7_q <= row_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_652_s7_q <= select_652;
      select_659_s7_q <= or_657 ? equal_655_s6_q : (~age_s6_q[1]);
      and_1461_s7_q <= not_532 & and_651;
      right_s7_q <= right;
      select_1470_s7_q <= or_657 ? equal_655_s6_q : equal_1469_s6_q;
      equal_1479_s7_q <= equal_1479_s6_q;
      equal_1598_s7_q <= equal_1598_s6_q;
      equal_2294_s7_q <= equal_2294_s6_q;
      and_2295_s7_q <= and_2295_s6_q;
      not_2772_s7_q <= not_2772_s6_q;
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
  assign fresh_re = s7_en & and_542_s7_q;
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
  logic [3:0] select_471_s8_q;
  logic equal_472_s8_q;
  logic [6:0] select_474_s8_q;
  logic [8:0] select_478_s8_q;
  logic and_484_s8_q;
  logic equal_490_s8_q;
  logic [6:0] column_s8_q;
  logic and_508_s8_q;
  logic and_510_s8_q;
  logic so_s8_q;
  logic equal_530_s8_q;
  logic or_531_s8_q;
  logic equal_533_s8_q;
  logic less_538_s8_q;
  logic not_539_s8_q;
  logic and_542_s8_q;
  logic [6:0] row_s8_q;
  logic [76:0] left_rdata_s8_q;
  logic [90:0] right_codes_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_652_s8_q;
  logic [45:0] best_left_rdata_s8_q;
  logic select_659_s8_q;
  logic and_1461_s8_q;
  logic [6:0] right_s8_q;
  logic select_1470_s8_q;
  logic equal_1479_s8_q;
  logic equal_1598_s8_q;
  logic equal_2294_s8_q;
  logic and_2295_s8_q;
  logic not_2772_s8_q;
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
      select_471_s8_q <= select_471_s7_q;
      equal_472_s8_q <= equal_472_s7_q;
      select_474_s8_q <= select_474_s7_q;
      select_478_s8_q <= select_478_s7_q;
      and_484_s8_q <= and_484_s7_q;
      equal_490_s8_q <= equal_490_s7_q;
      column_s8_q <= column_s7_q;
      and_508_s8_q <= and_508_s7_q;
      and_510_s8_q <= and_510_s7_q;
      so_s8_q <= so_s7_q;
      equal_530_s8_q <= equal_530_s7_q;
      or_531_s8_q <= or_531_s7_q;
      equal_533_s8_q <= equal_533_s7_q;
      less_538_s8_q <= less_538_s7_q;
      not_539_s8_q <= not_539_s7_q;
      and_542_s8_q <= and_542_s7_q;
      row_s8_q <= row_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_652_s8_q <= select_652_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      select_659_s8_q <= select_659_s7_q;
      and_1461_s8_q <= and_1461_s7_q;
      right_s8_q <= right_s7_q;
      select_1470_s8_q <= select_1470_s7_q;
      equal_1479_s8_q <= equal_1479_s7_q;
      equal_1598_s8_q <= equal_1598_s7_q;
      equal_2294_s8_q <= equal_2294_s7_q;
      and_2295_s8_q <= and_2295_s7_q;
      not_2772_s8_q <= not_2772_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  // hls/stages/agreement.hpp:653
  logic not_630;
  assign not_630 = ~(row_q == 7'h0);
  // hls/stages/agreement.hpp:212
  logic and_665;
  assign and_665 = left_rdata_s8_q[44] & not_539_s8_q;
  logic and_666;
  assign and_666 = right_codes_rdata_s8_q[38] & not_539_s8_q;
  logic [11:0] select_667;
  assign select_667 = less_538_s8_q ? 12'h0 : right_codes_rdata_s8_q[37:26];
  logic [11:0] select_668;
  assign select_668 = less_538_s8_q ? 12'h0 : left_rdata_s8_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_672;
  assign select_672 = and_665 ? (and_666 ? (~(select_667 ^ select_668)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_688;
  assign and_688 = left_rdata_s8_q[60] & not_539_s8_q;
  logic and_689;
  assign and_689 = right_codes_rdata_s8_q[51] & not_539_s8_q;
  logic [11:0] select_690;
  assign select_690 = less_538_s8_q ? 12'h0 : right_codes_rdata_s8_q[50:39];
  logic [11:0] select_691;
  assign select_691 = less_538_s8_q ? 12'h0 : left_rdata_s8_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_695;
  assign select_695 = and_688 ? (and_689 ? (~(select_690 ^ select_691)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_705;
  assign and_705 = left_rdata_s8_q[76] & not_539_s8_q;
  logic and_706;
  assign and_706 = right_codes_rdata_s8_q[64] & not_539_s8_q;
  logic [11:0] select_707;
  assign select_707 = less_538_s8_q ? 12'h0 : right_codes_rdata_s8_q[63:52];
  logic [11:0] select_708;
  assign select_708 = less_538_s8_q ? 12'h0 : left_rdata_s8_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_712;
  assign select_712 = and_705 ? (and_706 ? (~(select_707 ^ select_708)) : 12'h0) : 12'h0;
  logic [11:0] select_920;
  assign select_920 = (slot_s8_q[0] ? and_706 : and_689) ? (~(select_668 ^ (slot_s8_q[0] ? select_707 : select_690))) : 12'h0;
  // hls/stages/agreement.hpp:212
  logic and_937;
  assign and_937 = right_codes_rdata_s8_q[77] & not_539_s8_q;
  logic [11:0] select_939;
  assign select_939 = less_538_s8_q ? 12'h0 : right_codes_rdata_s8_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_943;
  assign select_943 = (slot_s8_q[0] ? and_937 : and_706) ? (~(select_691 ^ (slot_s8_q[0] ? select_939 : select_707))) : 12'h0;
  // hls/stages/agreement.hpp:718
  logic select_955;
  assign select_955 = slot_s8_q[0] ? (right_codes_rdata_s8_q[90] & not_539_s8_q) : and_937;
  logic [11:0] select_957;
  assign select_957 = slot_s8_q[0] ? (less_538_s8_q ? 12'h0 : right_codes_rdata_s8_q[89:78]) : select_939;
  // hls/stages/agreement.hpp:212
  logic and_1166;
  assign and_1166 = right_codes_rdata_s8_q[25] & not_539_s8_q;
  // hls/stages/agreement.hpp:718
  logic select_1167;
  assign select_1167 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_539_s8_q) : and_1166;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1169;
  assign select_1169 = less_538_s8_q ? 12'h0 : right_codes_rdata_s8_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1170;
  assign select_1170 = slot_s8_q[0] ? (less_538_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1169;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1194;
  assign select_1194 = (slot_s8_q[0] ? and_1166 : and_666) ? (~(select_691 ^ (slot_s8_q[0] ? select_1169 : select_667))) : 12'h0;
  logic [11:0] select_1209;
  assign select_1209 = (slot_s8_q[0] ? and_666 : and_689) ? (~(select_708 ^ (slot_s8_q[0] ? select_667 : select_690))) : 12'h0;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:932
  logic and_1485;
  assign and_1485 = (or_531_s8_q & (left_rdata_s8_q[61] & not_539_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:235
  logic and_1493;
  assign and_1493 = not_539_s8_q & (or_531_s8_q & (left_rdata_s8_q[63] & not_539_s8_q));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      row_q <= 7'h0;
    end else if (s8_en) begin
      row_q <= and_510_s8_q ? (equal_2294_s8_q ? row_s8_q : row_q) : row_q;
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
  logic [3:0] select_471_s9_q;
  logic equal_472_s9_q;
  logic [6:0] select_474_s9_q;
  logic [8:0] select_478_s9_q;
  logic and_484_s9_q;
  logic equal_490_s9_q;
  logic [6:0] column_s9_q;
  logic and_508_s9_q;
  logic and_510_s9_q;
  logic so_s9_q;
  logic equal_530_s9_q;
  logic or_531_s9_q;
  logic equal_533_s9_q;
  logic less_538_s9_q;
  logic not_539_s9_q;
  logic and_542_s9_q;
  logic [28:0] fresh_rdata_s9_q;
  logic [6:0] row_s9_q;
  logic [56:0] left_rdata_s9_q;
  logic and_631_s9_q;
  logic and_632_s9_q;
  logic and_633_s9_q;
  logic and_634_s9_q;
  logic [71:0] right_codes_rdata_s9_q;
  logic and_638_s9_q;
  logic and_639_s9_q;
  logic and_640_s9_q;
  logic and_641_s9_q;
  logic and_642_s9_q;
  logic and_643_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_652_s9_q;
  logic [45:0] best_left_rdata_s9_q;
  logic select_659_s9_q;
  logic and_665_s9_q;
  logic [11:0] select_672_s9_q;
  logic and_688_s9_q;
  logic [11:0] select_695_s9_q;
  logic and_705_s9_q;
  logic [11:0] select_712_s9_q;
  logic [11:0] select_920_s9_q;
  logic [11:0] select_943_s9_q;
  logic [11:0] select_960_s9_q;
  logic [11:0] select_1173_s9_q;
  logic [11:0] select_1194_s9_q;
  logic [11:0] select_1209_s9_q;
  logic and_1461_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic select_1470_s9_q;
  logic equal_1479_s9_q;
  logic and_1486_s9_q;
  logic and_1489_s9_q;
  logic and_1493_s9_q;
  logic equal_1598_s9_q;
  logic less_1619_s9_q;
  logic and_2024_s9_q;
  logic equal_2294_s9_q;
  logic and_2295_s9_q;
  logic not_2772_s9_q;
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
      select_471_s9_q <= select_471_s8_q;
      equal_472_s9_q <= equal_472_s8_q;
      select_474_s9_q <= select_474_s8_q;
      select_478_s9_q <= select_478_s8_q;
      and_484_s9_q <= and_484_s8_q;
      equal_490_s9_q <= equal_490_s8_q;
      column_s9_q <= column_s8_q;
      and_508_s9_q <= and_508_s8_q;
      and_510_s9_q <= and_510_s8_q;
      so_s9_q <= so_s8_q;
      equal_530_s9_q <= equal_530_s8_q;
      or_531_s9_q <= or_531_s8_q;
      equal_533_s9_q <= equal_533_s8_q;
      less_538_s9_q <= less_538_s8_q;
      not_539_s9_q <= not_539_s8_q;
      and_542_s9_q <= and_542_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      row_s9_q <= row_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[59:45], left_rdata_s8_q[43:29], left_rdata_s8_q[27:13], left_rdata_s8_q[11:0]};
      and_631_s9_q <= left_rdata_s8_q[12] & not_630;
      and_632_s9_q <= left_rdata_s8_q[28] & not_630;
      and_633_s9_q <= left_rdata_s8_q[44] & not_630;
      and_634_s9_q <= left_rdata_s8_q[60] & not_630;
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[76:65], right_codes_rdata_s8_q[63:52], right_codes_rdata_s8_q[50:39], right_codes_rdata_s8_q[37:26], right_codes_rdata_s8_q[24:13], right_codes_rdata_s8_q[11:0]};
      and_638_s9_q <= right_codes_rdata_s8_q[12] & not_630;
      and_639_s9_q <= right_codes_rdata_s8_q[25] & not_630;
      and_640_s9_q <= right_codes_rdata_s8_q[38] & not_630;
      and_641_s9_q <= right_codes_rdata_s8_q[51] & not_630;
      and_642_s9_q <= right_codes_rdata_s8_q[64] & not_630;
      and_643_s9_q <= right_codes_rdata_s8_q[77] & not_630;
      x_s9_2_q <= x_s8_2_q;
      select_652_s9_q <= select_652_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      select_659_s9_q <= select_659_s8_q;
      and_665_s9_q <= and_665;
      select_672_s9_q <= select_672;
      and_688_s9_q <= and_688;
      select_695_s9_q <= select_695;
      and_705_s9_q <= and_705;
      select_712_s9_q <= select_712;
      select_920_s9_q <= select_920;
      select_943_s9_q <= select_943;
      select_960_s9_q <= select_955 ? (~(select_708 ^ select_957)) : 12'h0;
      select_1173_s9_q <= select_1167 ? (~(select_668 ^ select_1170)) : 12'h0;
      select_1194_s9_q <= select_1194;
      select_1209_s9_q <= select_1209;
      and_1461_s9_q <= and_1461_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      select_1470_s9_q <= select_1470_s8_q;
      equal_1479_s9_q <= equal_1479_s8_q;
      and_1486_s9_q <= not_539_s8_q & and_1485;
      and_1489_s9_q <= (or_531_s8_q & (left_rdata_s8_q[62] & not_539_s8_q)) & and_1485;
      and_1493_s9_q <= and_1493;
      equal_1598_s9_q <= equal_1598_s8_q;
      less_1619_s9_q <= 6'h4 < row_q[6:1];
      and_2024_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2294_s9_q <= equal_2294_s8_q;
      and_2295_s9_q <= and_2295_s8_q;
      not_2772_s9_q <= not_2772_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  // hls/stages/count_bits.hpp:24
  logic parity_678;
  assign parity_678 = ^select_672_s9_q[5:3];
  logic parity_681;
  assign parity_681 = ^select_672_s9_q[8:6];
  logic parity_684;
  assign parity_684 = ^select_672_s9_q[11:3];
  logic parity_698;
  assign parity_698 = ^select_695_s9_q[8:6];
  logic parity_701;
  assign parity_701 = ^select_695_s9_q[11:9];
  logic parity_718;
  assign parity_718 = ^select_712_s9_q[2:0];
  logic parity_721;
  assign parity_721 = ^select_712_s9_q[5:3];
  logic parity_724;
  assign parity_724 = ^select_712_s9_q[8:0];
  logic parity_730;
  assign parity_730 = ^select_712_s9_q[11:9];
  logic parity_733;
  assign parity_733 = ^select_695_s9_q[2:0];
  logic parity_736;
  assign parity_736 = ^{select_712_s9_q[11:9], select_695_s9_q[5:0]};
  logic parity_739;
  assign parity_739 = ^{select_712_s9_q, select_695_s9_q, select_672_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_744;
  assign or_744 = (select_672_s9_q[1:0] == 2'h3) | (select_672_s9_q[2] & (select_672_s9_q[0] | select_672_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_748;
  assign or_748 = (select_695_s9_q[7:6] == 2'h3) | (select_695_s9_q[8] & (select_695_s9_q[6] | select_695_s9_q[7]));
  logic or_752;
  assign or_752 = (select_695_s9_q[10:9] == 2'h3) | (select_695_s9_q[11] & (select_695_s9_q[9] | select_695_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_760;
  assign or_760 = (select_712_s9_q[7:6] == 2'h3) | (select_712_s9_q[8] & (~(select_712_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_764;
  assign or_764 = (select_712_s9_q[1:0] == 2'h3) | (select_712_s9_q[2] & (select_712_s9_q[0] | select_712_s9_q[1]));
  logic or_768;
  assign or_768 = (select_712_s9_q[4:3] == 2'h3) | (select_712_s9_q[5] & (select_712_s9_q[3] | select_712_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_771;
  assign parity_771 = ^{or_768, or_764, or_760};
  // hls/stages/count_bits.hpp:23
  logic or_775;
  assign or_775 = (select_695_s9_q[4:3] == 2'h3) | (select_695_s9_q[5] & (select_695_s9_q[3] | select_695_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_779;
  assign or_779 = (select_712_s9_q[10:9] == 2'h3) | (select_712_s9_q[11] & (select_712_s9_q[9] | select_712_s9_q[10]));
  logic or_783;
  assign or_783 = (select_695_s9_q[1:0] == 2'h3) | (select_695_s9_q[2] & (select_695_s9_q[0] | select_695_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_786;
  assign parity_786 = ^{or_783, or_779, or_775};
  logic parity_789;
  assign parity_789 = ^{or_783, or_779, or_775, or_768, or_764, or_760, or_752, or_748, or_744};
  // hls/stages/count_bits.hpp:25
  logic or_794;
  assign or_794 = (parity_678 & parity_681) | ((^select_672_s9_q[11:9]) & (parity_678 | parity_681));
  logic and_797;
  assign and_797 = (^{select_695_s9_q[11:6], select_672_s9_q[2:0]}) & (parity_724 | parity_736);
  // hls/stages/count_bits.hpp:23
  logic or_805;
  assign or_805 = (select_672_s9_q[10:9] == 2'h3) | (select_672_s9_q[11] & (select_672_s9_q[9] | select_672_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_809;
  assign or_809 = (select_672_s9_q[4:3] == 2'h3) | (select_672_s9_q[5] & (select_672_s9_q[3] | select_672_s9_q[4]));
  logic or_813;
  assign or_813 = (select_672_s9_q[7:6] == 2'h3) | (select_672_s9_q[8] & (select_672_s9_q[6] | select_672_s9_q[7]));
  logic or_820;
  assign or_820 = (parity_698 & parity_701) | ((^select_672_s9_q[2:0]) & (parity_698 | parity_701));
  logic or_824;
  assign or_824 = (parity_718 & parity_721) | ((^select_712_s9_q[8:6]) & (parity_718 | parity_721));
  logic or_828;
  assign or_828 = (parity_730 & parity_733) | ((^select_695_s9_q[5:3]) & (parity_730 | parity_733));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_921;
  assign select_921 = and_665_s9_q ? select_920_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_927;
  assign parity_927 = ^select_921[5:3];
  logic parity_930;
  assign parity_930 = ^select_921[8:6];
  logic parity_933;
  assign parity_933 = ^select_921[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_944;
  assign select_944 = and_688_s9_q ? select_943_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_947;
  assign parity_947 = ^select_944[8:6];
  logic parity_950;
  assign parity_950 = ^select_944[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_961;
  assign select_961 = and_705_s9_q ? select_960_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_967;
  assign parity_967 = ^select_961[2:0];
  logic parity_970;
  assign parity_970 = ^select_961[5:3];
  logic parity_973;
  assign parity_973 = ^select_961[8:0];
  logic parity_979;
  assign parity_979 = ^select_961[11:9];
  logic parity_982;
  assign parity_982 = ^select_944[2:0];
  logic parity_985;
  assign parity_985 = ^{select_961[11:9], select_944[5:0]};
  logic parity_988;
  assign parity_988 = ^{select_961, select_944, select_921[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_993;
  assign or_993 = (select_921[1:0] == 2'h3) | (select_921[2] & (select_921[0] | select_921[1]));
  // hls/stages/count_bits.hpp:25
  logic or_997;
  assign or_997 = (select_944[7:6] == 2'h3) | (select_944[8] & (select_944[6] | select_944[7]));
  logic or_1001;
  assign or_1001 = (select_944[10:9] == 2'h3) | (select_944[11] & (select_944[9] | select_944[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1009;
  assign or_1009 = (select_961[7:6] == 2'h3) | (select_961[8] & (~(select_961[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1013;
  assign or_1013 = (select_961[1:0] == 2'h3) | (select_961[2] & (select_961[0] | select_961[1]));
  logic or_1017;
  assign or_1017 = (select_961[4:3] == 2'h3) | (select_961[5] & (select_961[3] | select_961[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1020;
  assign parity_1020 = ^{or_1017, or_1013, or_1009};
  // hls/stages/count_bits.hpp:23
  logic or_1024;
  assign or_1024 = (select_944[4:3] == 2'h3) | (select_944[5] & (select_944[3] | select_944[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1028;
  assign or_1028 = (select_961[10:9] == 2'h3) | (select_961[11] & (select_961[9] | select_961[10]));
  logic or_1032;
  assign or_1032 = (select_944[1:0] == 2'h3) | (select_944[2] & (select_944[0] | select_944[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1035;
  assign parity_1035 = ^{or_1032, or_1028, or_1024};
  logic parity_1038;
  assign parity_1038 = ^{or_1032, or_1028, or_1024, or_1017, or_1013, or_1009, or_1001, or_997, or_993};
  // hls/stages/count_bits.hpp:25
  logic or_1043;
  assign or_1043 = (parity_927 & parity_930) | ((^select_921[11:9]) & (parity_927 | parity_930));
  logic and_1046;
  assign and_1046 = (^{select_944[11:6], select_921[2:0]}) & (parity_973 | parity_985);
  // hls/stages/count_bits.hpp:23
  logic or_1054;
  assign or_1054 = (select_921[10:9] == 2'h3) | (select_921[11] & (select_921[9] | select_921[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1058;
  assign or_1058 = (select_921[4:3] == 2'h3) | (select_921[5] & (select_921[3] | select_921[4]));
  logic or_1062;
  assign or_1062 = (select_921[7:6] == 2'h3) | (select_921[8] & (select_921[6] | select_921[7]));
  logic or_1069;
  assign or_1069 = (parity_947 & parity_950) | ((^select_921[2:0]) & (parity_947 | parity_950));
  logic or_1073;
  assign or_1073 = (parity_967 & parity_970) | ((^select_961[8:6]) & (parity_967 | parity_970));
  logic or_1077;
  assign or_1077 = (parity_979 & parity_982) | ((^select_944[5:3]) & (parity_979 | parity_982));
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1174;
  assign select_1174 = and_665_s9_q ? select_1173_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1180;
  assign parity_1180 = ^select_1174[5:3];
  logic parity_1183;
  assign parity_1183 = ^select_1174[8:6];
  logic parity_1186;
  assign parity_1186 = ^select_1174[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1195;
  assign select_1195 = and_688_s9_q ? select_1194_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1198;
  assign parity_1198 = ^select_1195[8:6];
  logic parity_1201;
  assign parity_1201 = ^select_1195[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1210;
  assign select_1210 = and_705_s9_q ? select_1209_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1216;
  assign parity_1216 = ^select_1210[2:0];
  logic parity_1219;
  assign parity_1219 = ^select_1210[5:3];
  logic parity_1222;
  assign parity_1222 = ^select_1210[8:0];
  logic parity_1228;
  assign parity_1228 = ^select_1210[11:9];
  logic parity_1231;
  assign parity_1231 = ^select_1195[2:0];
  logic parity_1234;
  assign parity_1234 = ^{select_1210[11:9], select_1195[5:0]};
  logic parity_1237;
  assign parity_1237 = ^{select_1210, select_1195, select_1174[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1242;
  assign or_1242 = (select_1174[1:0] == 2'h3) | (select_1174[2] & (select_1174[0] | select_1174[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1246;
  assign or_1246 = (select_1195[7:6] == 2'h3) | (select_1195[8] & (select_1195[6] | select_1195[7]));
  logic or_1250;
  assign or_1250 = (select_1195[10:9] == 2'h3) | (select_1195[11] & (select_1195[9] | select_1195[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1258;
  assign or_1258 = (select_1210[7:6] == 2'h3) | (select_1210[8] & (~(select_1210[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1262;
  assign or_1262 = (select_1210[1:0] == 2'h3) | (select_1210[2] & (select_1210[0] | select_1210[1]));
  logic or_1266;
  assign or_1266 = (select_1210[4:3] == 2'h3) | (select_1210[5] & (select_1210[3] | select_1210[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1269;
  assign parity_1269 = ^{or_1266, or_1262, or_1258};
  // hls/stages/count_bits.hpp:23
  logic or_1273;
  assign or_1273 = (select_1195[4:3] == 2'h3) | (select_1195[5] & (select_1195[3] | select_1195[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1277;
  assign or_1277 = (select_1210[10:9] == 2'h3) | (select_1210[11] & (select_1210[9] | select_1210[10]));
  logic or_1281;
  assign or_1281 = (select_1195[1:0] == 2'h3) | (select_1195[2] & (select_1195[0] | select_1195[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1284;
  assign parity_1284 = ^{or_1281, or_1277, or_1273};
  logic parity_1287;
  assign parity_1287 = ^{or_1281, or_1277, or_1273, or_1266, or_1262, or_1258, or_1250, or_1246, or_1242};
  // hls/stages/count_bits.hpp:25
  logic or_1292;
  assign or_1292 = (parity_1180 & parity_1183) | ((^select_1174[11:9]) & (parity_1180 | parity_1183));
  logic and_1295;
  assign and_1295 = (^{select_1195[11:6], select_1174[2:0]}) & (parity_1222 | parity_1234);
  // hls/stages/count_bits.hpp:23
  logic or_1303;
  assign or_1303 = (select_1174[10:9] == 2'h3) | (select_1174[11] & (select_1174[9] | select_1174[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1307;
  assign or_1307 = (select_1174[4:3] == 2'h3) | (select_1174[5] & (select_1174[3] | select_1174[4]));
  logic or_1311;
  assign or_1311 = (select_1174[7:6] == 2'h3) | (select_1174[8] & (select_1174[6] | select_1174[7]));
  logic or_1318;
  assign or_1318 = (parity_1198 & parity_1201) | ((^select_1174[2:0]) & (parity_1198 | parity_1201));
  logic or_1322;
  assign or_1322 = (parity_1216 & parity_1219) | ((^select_1210[8:6]) & (parity_1216 | parity_1219));
  logic or_1326;
  assign or_1326 = (parity_1228 & parity_1231) | ((^select_1195[5:3]) & (parity_1228 | parity_1231));
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/agreement.hpp:235
  logic or_1507;
  assign or_1507 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_542_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_634_s9_q, left_rdata_s9_q[56:42], and_633_s9_q, left_rdata_s9_q[41:27], and_632_s9_q, left_rdata_s9_q[26:12], and_631_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[28:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_542_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_643_s9_q, right_codes_rdata_s9_q[71:60], and_642_s9_q, right_codes_rdata_s9_q[59:48], and_641_s9_q, right_codes_rdata_s9_q[47:36], and_640_s9_q, right_codes_rdata_s9_q[35:24], and_639_s9_q, right_codes_rdata_s9_q[23:12], and_638_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
  logic [3:0] select_471_s10_q;
  logic equal_472_s10_q;
  logic [6:0] select_474_s10_q;
  logic [8:0] select_478_s10_q;
  logic and_484_s10_q;
  logic equal_490_s10_q;
  logic [6:0] column_s10_q;
  logic and_508_s10_q;
  logic and_510_s10_q;
  logic so_s10_q;
  logic equal_530_s10_q;
  logic or_531_s10_q;
  logic equal_533_s10_q;
  logic less_538_s10_q;
  logic not_539_s10_q;
  logic [6:0] row_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_652_s10_q;
  logic [45:0] best_left_rdata_s10_q;
  logic select_659_s10_q;
  logic xor_740_s10_q;
  logic parity_789_s10_q;
  logic and_790_s10_q;
  logic or_794_s10_q;
  logic or_798_s10_q;
  logic or_805_s10_q;
  logic or_809_s10_q;
  logic or_813_s10_q;
  logic or_820_s10_q;
  logic or_824_s10_q;
  logic or_828_s10_q;
  logic and_837_s10_q;
  logic and_839_s10_q;
  logic or_851_s10_q;
  logic or_855_s10_q;
  logic or_859_s10_q;
  logic xor_989_s10_q;
  logic parity_1004_s10_q;
  logic parity_1038_s10_q;
  logic and_1039_s10_q;
  logic or_1043_s10_q;
  logic or_1047_s10_q;
  logic or_1054_s10_q;
  logic or_1058_s10_q;
  logic or_1062_s10_q;
  logic or_1069_s10_q;
  logic or_1073_s10_q;
  logic or_1077_s10_q;
  logic and_1086_s10_q;
  logic or_1087_s10_q;
  logic or_1100_s10_q;
  logic or_1104_s10_q;
  logic or_1108_s10_q;
  logic xor_1238_s10_q;
  logic parity_1253_s10_q;
  logic parity_1287_s10_q;
  logic and_1288_s10_q;
  logic or_1292_s10_q;
  logic or_1296_s10_q;
  logic or_1303_s10_q;
  logic or_1307_s10_q;
  logic or_1311_s10_q;
  logic or_1318_s10_q;
  logic or_1322_s10_q;
  logic or_1326_s10_q;
  logic and_1335_s10_q;
  logic or_1336_s10_q;
  logic or_1349_s10_q;
  logic or_1353_s10_q;
  logic or_1357_s10_q;
  logic and_1461_s10_q;
  logic [6:0] select_1465_s10_q;
  logic [6:0] right_s10_q;
  logic select_1470_s10_q;
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
  logic not_2772_s10_q;
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
      select_471_s10_q <= select_471_s9_q;
      equal_472_s10_q <= equal_472_s9_q;
      select_474_s10_q <= select_474_s9_q;
      select_478_s10_q <= select_478_s9_q;
      and_484_s10_q <= and_484_s9_q;
      equal_490_s10_q <= equal_490_s9_q;
      column_s10_q <= column_s9_q;
      and_508_s10_q <= and_508_s9_q;
      and_510_s10_q <= and_510_s9_q;
      so_s10_q <= so_s9_q;
      equal_530_s10_q <= equal_530_s9_q;
      or_531_s10_q <= or_531_s9_q;
      equal_533_s10_q <= equal_533_s9_q;
      less_538_s10_q <= less_538_s9_q;
      not_539_s10_q <= not_539_s9_q;
      row_s10_q <= row_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_652_s10_q <= select_652_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_659_s10_q <= select_659_s9_q;
      xor_740_s10_q <= parity_684 ^ parity_739;
      parity_789_s10_q <= parity_789;
      and_790_s10_q <= parity_684 & parity_739;
      or_794_s10_q <= or_794;
      or_798_s10_q <= (parity_724 & parity_736) | and_797;
      or_805_s10_q <= or_805;
      or_809_s10_q <= or_809;
      or_813_s10_q <= or_813;
      or_820_s10_q <= or_820;
      or_824_s10_q <= or_824;
      or_828_s10_q <= or_828;
      and_837_s10_q <= parity_771 & parity_786;
      and_839_s10_q <= (^{or_752, or_748, or_744}) & (parity_771 | parity_786);
      or_851_s10_q <= (or_748 & or_752) | (or_744 & (or_748 | or_752));
      or_855_s10_q <= (or_764 & or_768) | (or_760 & (or_764 | or_768));
      or_859_s10_q <= (or_779 & or_783) | (or_775 & (or_779 | or_783));
      xor_989_s10_q <= parity_933 ^ parity_988;
      parity_1004_s10_q <= ^{or_1001, or_997, or_993};
      parity_1038_s10_q <= parity_1038;
      and_1039_s10_q <= parity_933 & parity_988;
      or_1043_s10_q <= or_1043;
      or_1047_s10_q <= (parity_973 & parity_985) | and_1046;
      or_1054_s10_q <= or_1054;
      or_1058_s10_q <= or_1058;
      or_1062_s10_q <= or_1062;
      or_1069_s10_q <= or_1069;
      or_1073_s10_q <= or_1073;
      or_1077_s10_q <= or_1077;
      and_1086_s10_q <= parity_1020 & parity_1035;
      or_1087_s10_q <= parity_1020 | parity_1035;
      or_1100_s10_q <= (or_997 & or_1001) | (or_993 & (or_997 | or_1001));
      or_1104_s10_q <= (or_1013 & or_1017) | (or_1009 & (or_1013 | or_1017));
      or_1108_s10_q <= (or_1028 & or_1032) | (or_1024 & (or_1028 | or_1032));
      xor_1238_s10_q <= parity_1186 ^ parity_1237;
      parity_1253_s10_q <= ^{or_1250, or_1246, or_1242};
      parity_1287_s10_q <= parity_1287;
      and_1288_s10_q <= parity_1186 & parity_1237;
      or_1292_s10_q <= or_1292;
      or_1296_s10_q <= (parity_1222 & parity_1234) | and_1295;
      or_1303_s10_q <= or_1303;
      or_1307_s10_q <= or_1307;
      or_1311_s10_q <= or_1311;
      or_1318_s10_q <= or_1318;
      or_1322_s10_q <= or_1322;
      or_1326_s10_q <= or_1326;
      and_1335_s10_q <= parity_1269 & parity_1284;
      or_1336_s10_q <= parity_1269 | parity_1284;
      or_1349_s10_q <= (or_1246 & or_1250) | (or_1242 & (or_1246 | or_1250));
      or_1353_s10_q <= (or_1262 & or_1266) | (or_1258 & (or_1262 | or_1266));
      or_1357_s10_q <= (or_1277 & or_1281) | (or_1273 & (or_1277 | or_1281));
      and_1461_s10_q <= and_1461_s9_q;
      select_1465_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      select_1470_s10_q <= select_1470_s9_q;
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
      not_2772_s10_q <= not_2772_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_phase_q;
  // hls/stages/count_bits.hpp:24
  logic parity_816;
  assign parity_816 = ^{or_813_s10_q, or_809_s10_q, or_805_s10_q};
  logic parity_831;
  assign parity_831 = ^{or_828_s10_q, or_824_s10_q, or_820_s10_q};
  logic parity_834;
  assign parity_834 = ^{or_828_s10_q, or_824_s10_q, or_820_s10_q, or_813_s10_q, or_809_s10_q, or_805_s10_q, or_798_s10_q, or_794_s10_q, and_790_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_836;
  assign and_836 = parity_789_s10_q & parity_834;
  logic or_840;
  assign or_840 = and_837_s10_q | and_839_s10_q;
  logic and_843;
  assign and_843 = (^{or_798_s10_q, or_794_s10_q, and_790_s10_q}) & (parity_816 | parity_831);
  logic or_844;
  assign or_844 = (parity_816 & parity_831) | and_843;
  // hls/stages/count_bits.hpp:24
  logic parity_862;
  assign parity_862 = ^{or_859_s10_q, or_855_s10_q, or_851_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_866;
  assign or_866 = (or_794_s10_q & or_798_s10_q) | (and_790_s10_q & (or_794_s10_q | or_798_s10_q));
  logic or_870;
  assign or_870 = (or_809_s10_q & or_813_s10_q) | (or_805_s10_q & (or_809_s10_q | or_813_s10_q));
  logic or_874;
  assign or_874 = (or_824_s10_q & or_828_s10_q) | (or_820_s10_q & (or_824_s10_q | or_828_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_877;
  assign parity_877 = ^{or_874, or_870, or_866};
  logic parity_880;
  assign parity_880 = ^{or_874, or_870, or_866, or_859_s10_q, or_855_s10_q, or_851_s10_q, or_844, or_840, and_836};
  // hls/stages/count_bits.hpp:25
  logic or_892;
  assign or_892 = (or_855_s10_q & or_859_s10_q) | (or_851_s10_q & (or_855_s10_q | or_859_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1065;
  assign parity_1065 = ^{or_1062_s10_q, or_1058_s10_q, or_1054_s10_q};
  logic parity_1080;
  assign parity_1080 = ^{or_1077_s10_q, or_1073_s10_q, or_1069_s10_q};
  logic parity_1083;
  assign parity_1083 = ^{or_1077_s10_q, or_1073_s10_q, or_1069_s10_q, or_1062_s10_q, or_1058_s10_q, or_1054_s10_q, or_1047_s10_q, or_1043_s10_q, and_1039_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1085;
  assign and_1085 = parity_1038_s10_q & parity_1083;
  logic or_1089;
  assign or_1089 = and_1086_s10_q | (parity_1004_s10_q & or_1087_s10_q);
  logic and_1092;
  assign and_1092 = (^{or_1047_s10_q, or_1043_s10_q, and_1039_s10_q}) & (parity_1065 | parity_1080);
  logic or_1093;
  assign or_1093 = (parity_1065 & parity_1080) | and_1092;
  // hls/stages/count_bits.hpp:24
  logic parity_1111;
  assign parity_1111 = ^{or_1108_s10_q, or_1104_s10_q, or_1100_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1115;
  assign or_1115 = (or_1043_s10_q & or_1047_s10_q) | (and_1039_s10_q & (or_1043_s10_q | or_1047_s10_q));
  logic or_1119;
  assign or_1119 = (or_1058_s10_q & or_1062_s10_q) | (or_1054_s10_q & (or_1058_s10_q | or_1062_s10_q));
  logic or_1123;
  assign or_1123 = (or_1073_s10_q & or_1077_s10_q) | (or_1069_s10_q & (or_1073_s10_q | or_1077_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1126;
  assign parity_1126 = ^{or_1123, or_1119, or_1115};
  logic parity_1129;
  assign parity_1129 = ^{or_1123, or_1119, or_1115, or_1108_s10_q, or_1104_s10_q, or_1100_s10_q, or_1093, or_1089, and_1085};
  // hls/stages/count_bits.hpp:25
  logic or_1141;
  assign or_1141 = (or_1104_s10_q & or_1108_s10_q) | (or_1100_s10_q & (or_1104_s10_q | or_1108_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1314;
  assign parity_1314 = ^{or_1311_s10_q, or_1307_s10_q, or_1303_s10_q};
  logic parity_1329;
  assign parity_1329 = ^{or_1326_s10_q, or_1322_s10_q, or_1318_s10_q};
  logic parity_1332;
  assign parity_1332 = ^{or_1326_s10_q, or_1322_s10_q, or_1318_s10_q, or_1311_s10_q, or_1307_s10_q, or_1303_s10_q, or_1296_s10_q, or_1292_s10_q, and_1288_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1334;
  assign and_1334 = parity_1287_s10_q & parity_1332;
  logic or_1338;
  assign or_1338 = and_1335_s10_q | (parity_1253_s10_q & or_1336_s10_q);
  logic and_1341;
  assign and_1341 = (^{or_1296_s10_q, or_1292_s10_q, and_1288_s10_q}) & (parity_1314 | parity_1329);
  logic or_1342;
  assign or_1342 = (parity_1314 & parity_1329) | and_1341;
  // hls/stages/count_bits.hpp:24
  logic parity_1360;
  assign parity_1360 = ^{or_1357_s10_q, or_1353_s10_q, or_1349_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1364;
  assign or_1364 = (or_1292_s10_q & or_1296_s10_q) | (and_1288_s10_q & (or_1292_s10_q | or_1296_s10_q));
  logic or_1368;
  assign or_1368 = (or_1307_s10_q & or_1311_s10_q) | (or_1303_s10_q & (or_1307_s10_q | or_1311_s10_q));
  logic or_1372;
  assign or_1372 = (or_1322_s10_q & or_1326_s10_q) | (or_1318_s10_q & (or_1322_s10_q | or_1326_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1375;
  assign parity_1375 = ^{or_1372, or_1368, or_1364};
  logic parity_1378;
  assign parity_1378 = ^{or_1372, or_1368, or_1364, or_1357_s10_q, or_1353_s10_q, or_1349_s10_q, or_1342, or_1338, and_1334};
  // hls/stages/count_bits.hpp:25
  logic or_1390;
  assign or_1390 = (or_1353_s10_q & or_1357_s10_q) | (or_1349_s10_q & (or_1353_s10_q | or_1357_s10_q));
  // hls/stages/agreement.hpp:141
  logic [6:0] select_1517;
  assign select_1517 = or_531_s10_q ? (less_538_s10_q ? 7'h0 : select_1465_s10_q) : 7'h0;
  // hls/stages/patches.hpp:114
  logic and_1592;
  assign and_1592 = (select_471_s10_q == 4'h0) & (select_474_s10_q == 7'h0);
  // hls/stages/patches.hpp:308
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:118
  logic [3:0] select_2706;
  assign select_2706 = and_1592 ? (sample_pair_first_s10_q ? phase : patches_phase_q) : patches_phase_q;

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1298; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_531_s10_q ? select_1465_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_652_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_phase_q <= 4'h0;
    end else if (s10_en) begin
      patches_phase_q <= sample_pair_whole_s10_q ? select_2706 : patches_phase_q;
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
  logic [3:0] select_471_s11_q;
  logic equal_472_s11_q;
  logic [6:0] select_474_s11_q;
  logic [8:0] select_478_s11_q;
  logic and_484_s11_q;
  logic equal_490_s11_q;
  logic [6:0] column_s11_q;
  logic and_508_s11_q;
  logic and_510_s11_q;
  logic so_s11_q;
  logic equal_530_s11_q;
  logic or_531_s11_q;
  logic equal_533_s11_q;
  logic less_538_s11_q;
  logic not_539_s11_q;
  logic [6:0] row_s11_q;
  logic [6:0] x_s11_2_q;
  logic [45:0] best_left_rdata_s11_q;
  logic select_659_s11_q;
  logic xor_740_s11_q;
  logic xor_835_s11_q;
  logic parity_880_s11_q;
  logic and_881_s11_q;
  logic and_883_s11_q;
  logic and_885_s11_q;
  logic and_887_s11_q;
  logic or_892_s11_q;
  logic or_896_s11_q;
  logic xor_989_s11_q;
  logic xor_1084_s11_q;
  logic parity_1129_s11_q;
  logic and_1130_s11_q;
  logic and_1132_s11_q;
  logic and_1134_s11_q;
  logic and_1136_s11_q;
  logic or_1141_s11_q;
  logic or_1145_s11_q;
  logic xor_1238_s11_q;
  logic xor_1333_s11_q;
  logic parity_1378_s11_q;
  logic and_1379_s11_q;
  logic and_1381_s11_q;
  logic and_1383_s11_q;
  logic and_1385_s11_q;
  logic or_1390_s11_q;
  logic or_1394_s11_q;
  logic and_1461_s11_q;
  logic [6:0] right_s11_q;
  logic select_1470_s11_q;
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
  logic not_2772_s11_q;
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
      select_471_s11_q <= select_471_s10_q;
      equal_472_s11_q <= equal_472_s10_q;
      select_474_s11_q <= select_474_s10_q;
      select_478_s11_q <= select_478_s10_q;
      and_484_s11_q <= and_484_s10_q;
      equal_490_s11_q <= equal_490_s10_q;
      column_s11_q <= column_s10_q;
      and_508_s11_q <= and_508_s10_q;
      and_510_s11_q <= and_510_s10_q;
      so_s11_q <= so_s10_q;
      equal_530_s11_q <= equal_530_s10_q;
      or_531_s11_q <= or_531_s10_q;
      equal_533_s11_q <= equal_533_s10_q;
      less_538_s11_q <= less_538_s10_q;
      not_539_s11_q <= not_539_s10_q;
      row_s11_q <= row_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_659_s11_q <= select_659_s10_q;
      xor_740_s11_q <= xor_740_s10_q;
      xor_835_s11_q <= parity_789_s10_q ^ parity_834;
      parity_880_s11_q <= parity_880;
      and_881_s11_q <= parity_862 & parity_877;
      and_883_s11_q <= (^{or_844, or_840, and_836}) & (parity_862 | parity_877);
      and_885_s11_q <= or_840 & or_844;
      and_887_s11_q <= and_836 & (or_840 | or_844);
      or_892_s11_q <= or_892;
      or_896_s11_q <= (or_870 & or_874) | (or_866 & (or_870 | or_874));
      xor_989_s11_q <= xor_989_s10_q;
      xor_1084_s11_q <= parity_1038_s10_q ^ parity_1083;
      parity_1129_s11_q <= parity_1129;
      and_1130_s11_q <= parity_1111 & parity_1126;
      and_1132_s11_q <= (^{or_1093, or_1089, and_1085}) & (parity_1111 | parity_1126);
      and_1134_s11_q <= or_1089 & or_1093;
      and_1136_s11_q <= and_1085 & (or_1089 | or_1093);
      or_1141_s11_q <= or_1141;
      or_1145_s11_q <= (or_1119 & or_1123) | (or_1115 & (or_1119 | or_1123));
      xor_1238_s11_q <= xor_1238_s10_q;
      xor_1333_s11_q <= parity_1287_s10_q ^ parity_1332;
      parity_1378_s11_q <= parity_1378;
      and_1379_s11_q <= parity_1360 & parity_1375;
      and_1381_s11_q <= (^{or_1342, or_1338, and_1334}) & (parity_1360 | parity_1375);
      and_1383_s11_q <= or_1338 & or_1342;
      and_1385_s11_q <= and_1334 & (or_1338 | or_1342);
      or_1390_s11_q <= or_1390;
      or_1394_s11_q <= (or_1368 & or_1372) | (or_1364 & (or_1368 | or_1372));
      and_1461_s11_q <= and_1461_s10_q;
      right_s11_q <= right_s10_q;
      select_1470_s11_q <= select_1470_s10_q;
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
      not_2772_s11_q <= not_2772_s10_q;
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
  logic or_884;
  assign or_884 = and_881_s11_q | and_883_s11_q;
  logic or_888;
  assign or_888 = and_885_s11_q | and_887_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_901;
  assign parity_901 = ^{or_896_s11_q, or_892_s11_q, or_888, or_884};
  // hls/stages/count_bits.hpp:25
  logic or_905;
  assign or_905 = (or_892_s11_q & or_896_s11_q) | (or_888 & (or_892_s11_q | or_896_s11_q));
  logic and_906;
  assign and_906 = or_884 & (^{or_896_s11_q, or_892_s11_q, or_888});
  // hls/stages/count_bits.hpp:24
  logic xor_907;
  assign xor_907 = or_905 ^ and_906;
  // hls/stages/count_bits.hpp:27
  logic and_908;
  assign and_908 = or_905 & and_906;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_909;
  assign select_909 = equal_533_s11_q ? {and_908, xor_907, parity_901, parity_880_s11_q, xor_835_s11_q, xor_740_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_531_s11_q ? 6'h0 : select_909;
  // hls/stages/count_bits.hpp:25
  logic or_1133;
  assign or_1133 = and_1130_s11_q | and_1132_s11_q;
  logic or_1137;
  assign or_1137 = and_1134_s11_q | and_1136_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1150;
  assign parity_1150 = ^{or_1145_s11_q, or_1141_s11_q, or_1137, or_1133};
  // hls/stages/count_bits.hpp:25
  logic or_1154;
  assign or_1154 = (or_1141_s11_q & or_1145_s11_q) | (or_1137 & (or_1141_s11_q | or_1145_s11_q));
  logic and_1155;
  assign and_1155 = or_1133 & (^{or_1145_s11_q, or_1141_s11_q, or_1137});
  // hls/stages/count_bits.hpp:24
  logic xor_1156;
  assign xor_1156 = or_1154 ^ and_1155;
  // hls/stages/count_bits.hpp:27
  logic and_1157;
  assign and_1157 = or_1154 & and_1155;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1158;
  assign select_1158 = equal_533_s11_q ? {and_1157, xor_1156, parity_1150, parity_1129_s11_q, xor_1084_s11_q, xor_989_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_531_s11_q ? 6'h0 : select_1158;
  // hls/stages/count_bits.hpp:25
  logic or_1382;
  assign or_1382 = and_1379_s11_q | and_1381_s11_q;
  logic or_1386;
  assign or_1386 = and_1383_s11_q | and_1385_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1399;
  assign parity_1399 = ^{or_1394_s11_q, or_1390_s11_q, or_1386, or_1382};
  // hls/stages/count_bits.hpp:25
  logic or_1403;
  assign or_1403 = (or_1390_s11_q & or_1394_s11_q) | (or_1386 & (or_1390_s11_q | or_1394_s11_q));
  logic and_1404;
  assign and_1404 = or_1382 & (^{or_1394_s11_q, or_1390_s11_q, or_1386});
  // hls/stages/count_bits.hpp:24
  logic xor_1405;
  assign xor_1405 = or_1403 ^ and_1404;
  // hls/stages/count_bits.hpp:27
  logic and_1406;
  assign and_1406 = or_1403 & and_1404;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1407;
  assign select_1407 = equal_533_s11_q ? {and_1406, xor_1405, parity_1399, parity_1378_s11_q, xor_1333_s11_q, xor_1238_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_531_s11_q ? 6'h0 : select_1407;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1447;
  assign sum_1447 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1450;
  assign sum_1450 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:447
  logic select_2391;
  assign select_2391 = equal_2294_s11_q ? (~({row_s11_q, 1'b0} < {sum_2388, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2596;
  assign and_2596 = and_510_s11_q & (equal_2294_s11_q & (row_s11_q[6:2] == 5'h0));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      lower_half_q <= 1'b0;
    end else if (s11_en) begin
      lower_half_q <= and_510_s11_q ? select_2391 : lower_half_q;
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
  logic [3:0] select_471_s12_q;
  logic equal_472_s12_q;
  logic [6:0] select_474_s12_q;
  logic [8:0] select_478_s12_q;
  logic and_484_s12_q;
  logic equal_490_s12_q;
  logic [6:0] column_s12_q;
  logic and_508_s12_q;
  logic and_510_s12_q;
  logic so_s12_q;
  logic equal_530_s12_q;
  logic or_531_s12_q;
  logic less_538_s12_q;
  logic not_539_s12_q;
  logic equal_571_s12_q;
  logic [6:0] x_s12_2_q;
  logic [45:0] best_left_rdata_s12_q;
  logic select_659_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1160_s12_q;
  logic [5:0] select_1409_s12_q;
  logic [6:0] sum_1448_s12_q;
  logic [6:0] sum_1451_s12_q;
  logic and_1461_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic select_1470_s12_q;
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
  logic and_2597_s12_q;
  logic and_2599_s12_q;
  logic [3:0] phase_s12_q;
  logic equal_2726_s12_q;
  logic [3:0] select_2729_s12_q;
  logic less_2740_s12_q;
  logic not_2772_s12_q;
  logic less_3619_s12_q;
  logic equal_3824_s12_q;
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
      select_471_s12_q <= select_471_s11_q;
      equal_472_s12_q <= equal_472_s11_q;
      select_474_s12_q <= select_474_s11_q;
      select_478_s12_q <= select_478_s11_q;
      and_484_s12_q <= and_484_s11_q;
      equal_490_s12_q <= equal_490_s11_q;
      column_s12_q <= column_s11_q;
      and_508_s12_q <= and_508_s11_q;
      and_510_s12_q <= and_510_s11_q;
      so_s12_q <= so_s11_q;
      equal_530_s12_q <= equal_530_s11_q;
      or_531_s12_q <= or_531_s11_q;
      less_538_s12_q <= less_538_s11_q;
      not_539_s12_q <= not_539_s11_q;
      equal_571_s12_q <= row_s11_q == 7'h0;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_659_s12_q <= select_659_s11_q;
      column_2_s12_q <= column_2;
      select_1160_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1409_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1448_s12_q <= {1'b0, before_v_2} + sum_1447;
      sum_1451_s12_q <= {1'b0, before_v_3} + sum_1450;
      and_1461_s12_q <= and_1461_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      select_1470_s12_q <= select_1470_s11_q;
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
      and_2597_s12_q <= and_2295_s11_q & and_2596;
      and_2599_s12_q <= and_2295_s11_q & (~and_2596);
      phase_s12_q <= phase_s11_q;
      equal_2726_s12_q <= row_s11_q == 7'h3;
      select_2729_s12_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      less_2740_s12_q <= 7'h2 < row_s11_q;
      not_2772_s12_q <= not_2772_s11_q;
      less_3619_s12_q <= 6'h2 < row_s11_q[6:1];
      equal_3824_s12_q <= row_s11_q[6:3] == 4'h0;
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
  logic [5:0] select_911;
  assign select_911 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1443;
  assign sum_1443 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1453;
  assign select_1453 = (sum_1448_s12_q < sum_1451_s12_q) ? sum_1451_s12_q : sum_1448_s12_q;
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:227
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
  // hls/stages/patches.hpp:79
  logic [3:0] select_2730;
  assign select_2730 = equal_2726_s12_q ? select_2729_s12_q : patches_choosing_rows_to_next_q;
  logic equal_2731;
  assign equal_2731 = select_2730 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2734;
  assign select_2734 = equal_2294_s12_q ? (equal_2731 ? 4'h2 : (select_2730 + 4'hf)) : patches_choosing_rows_to_next_q;
  logic select_2742;
  assign select_2742 = equal_2294_s12_q ? (less_2740_s12_q & equal_2731) : patches_chooses_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_chooses_q <= 1'b0;
    end else if (s12_en) begin
      patches_choosing_rows_to_next_q <= and_510_s12_q ? select_2734 : patches_choosing_rows_to_next_q;
      patches_chooses_q <= and_510_s12_q ? select_2742 : patches_chooses_q;
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
  logic [3:0] patches_choosing_rows_to_next_s13_q;
  logic patches_chooses_s13_q;
  logic [3:0] select_471_s13_q;
  logic equal_472_s13_q;
  logic [6:0] select_474_s13_q;
  logic [8:0] select_478_s13_q;
  logic and_484_s13_q;
  logic equal_490_s13_q;
  logic [6:0] column_s13_q;
  logic and_508_s13_q;
  logic and_510_s13_q;
  logic so_s13_q;
  logic equal_530_s13_q;
  logic or_531_s13_q;
  logic less_538_s13_q;
  logic not_539_s13_q;
  logic equal_571_s13_q;
  logic [6:0] x_s13_2_q;
  logic [45:0] best_left_rdata_s13_q;
  logic select_659_s13_q;
  logic [6:0] difference_912_s13_q;
  logic [6:0] difference_1161_s13_q;
  logic equal_1162_s13_q;
  logic [6:0] difference_1410_s13_q;
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
  logic and_2597_s13_q;
  logic and_2599_s13_q;
  logic and_2606_s13_q;
  logic [3:0] phase_s13_q;
  logic equal_2726_s13_q;
  logic equal_2731_s13_q;
  logic not_2772_s13_q;
  logic less_3619_s13_q;
  logic equal_3824_s13_q;
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
      select_471_s13_q <= select_471_s12_q;
      equal_472_s13_q <= equal_472_s12_q;
      select_474_s13_q <= select_474_s12_q;
      select_478_s13_q <= select_478_s12_q;
      and_484_s13_q <= and_484_s12_q;
      equal_490_s13_q <= equal_490_s12_q;
      column_s13_q <= column_s12_q;
      and_508_s13_q <= and_508_s12_q;
      and_510_s13_q <= and_510_s12_q;
      so_s13_q <= so_s12_q;
      equal_530_s13_q <= equal_530_s12_q;
      or_531_s13_q <= or_531_s12_q;
      less_538_s13_q <= less_538_s12_q;
      not_539_s13_q <= not_539_s12_q;
      equal_571_s13_q <= equal_571_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_659_s13_q <= select_659_s12_q;
      difference_912_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_911};
      difference_1161_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1160_s12_q};
      equal_1162_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1410_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1409_s12_q};
      sum_1444_s13_q <= {1'b0, before_v} + sum_1443;
      select_1453_s13_q <= select_1453;
      and_1461_s13_q <= and_1461_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      select_1470_s13_q <= select_1470_s12_q;
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
      and_2597_s13_q <= and_2597_s12_q;
      and_2599_s13_q <= and_2599_s12_q;
      and_2606_s13_q <= ends_cell_s12_q & so_s12_q;
      phase_s13_q <= phase_s12_q;
      equal_2726_s13_q <= equal_2726_s12_q;
      equal_2731_s13_q <= equal_2731;
      not_2772_s13_q <= not_2772_s12_q;
      less_3619_s13_q <= less_3619_s12_q;
      equal_3824_s13_q <= equal_3824_s12_q;
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
  logic less_660;
  assign less_660 = $signed(run_shift_s13_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_662;
  assign less_662 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s13_q);
  // hls/stages/agreement.hpp:231
  logic and_664;
  assign and_664 = (~less_660) & (~less_662);
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_914;
  assign sum_914 = {difference_912_s13_q[6], difference_912_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1164;
  assign sum_1164 = {difference_1161_s13_q[6], difference_1161_s13_q} + (equal_1162_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1412;
  assign sum_1412 = {difference_1410_s13_q[6], difference_1410_s13_q} + (equal_1162_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1445;
  assign select_1445 = slot_s13_q[0] ? chosen_near_q : sum_1444_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1455;
  assign select_1455 = (select_1445 < select_1453_s13_q) ? select_1453_s13_q : select_1445;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_664 ? select_1455 : 7'h0;
  // hls/stages/agreement.hpp:935
  logic select_1496;
  assign select_1496 = slot_s13_q[2] ? less_1494_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1499;
  assign difference_1499 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/census.hpp:31
  logic not_1596;
  assign not_1596 = ~sample_pair_first_s13_q;
  // hls/stages/patches.hpp:302
  logic equal_1600;
  assign equal_1600 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1668;
  assign select_1668 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1892;
  assign sum_1892 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2405;
  assign select_2405 = slot_s13_q[0] ? 7'h0 : sum_1444_s13_q;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_2407;
  assign select_2407 = (select_2405 < select_1453_s13_q) ? select_1453_s13_q : select_2405;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2600;
  assign select_2600 = and_2599_s13_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2602;
  assign select_2602 = and_2597_s13_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2600[15]}}, select_2600});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2603;
  assign select_2603 = and_2599_s13_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2603[15]}}, select_2603};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2605;
  assign select_2605 = and_2597_s13_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2606_s13_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:363
  logic and_2708;
  assign and_2708 = not_1596 & equal_1598_s13_q;
  logic [8:0] select_2709;
  assign select_2709 = and_2708 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s13_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2710;
  assign select_2710 = and_2708 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2711;
  assign select_2711 = sample_pair_first_s13_q ? select_2709 : select_2710;
  // hls/stages/patches.hpp:118
  logic [3:0] select_2712;
  assign select_2712 = and_1592_s13_q ? select_2711[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2713;
  assign select_2713 = sample_pair_whole_s13_q ? select_2712 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2715;
  assign select_2715 = sample_pair_whole_s13_q ? (and_1592_s13_q ? select_2711[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2718;
  assign select_2718 = sample_pair_whole_s13_q ? (equal_1600 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2720;
  assign select_2720 = sample_pair_whole_s13_q ? (patches_band_rows_number_q + {4'h0, equal_1600}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:321
  logic equal_2721;
  assign equal_2721 = phase_s13_q == 4'h0;
  // hls/stages/patches.hpp:322
  logic not_2722;
  assign not_2722 = ~equal_2721;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2724;
  assign select_2724 = sample_pair_whole_s13_q ? (phase_s13_q + {{2{not_2722}}, 1'b1, not_2722}) : patches_first_band_rows_to_next_q;
  logic select_2725;
  assign select_2725 = sample_pair_whole_s13_q ? equal_2721 : patches_first_band_number_q;
  // hls/stages/patches.hpp:79
  logic [4:0] select_2736;
  assign select_2736 = equal_2726_s13_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2738;
  assign select_2738 = equal_2294_s13_q ? (select_2736 + {4'h0, equal_2731_s13_q}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2745;
  assign select_2745 = and_510_s13_q ? (equal_2294_s13_q ? select_2736 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3631;
  assign select_3631 = so_s13_q ? (and_2606_s13_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3633;
  assign sum_3633 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3634;
  assign select_3634 = sum_1892[5] ? {1'b1, sum_1892[4:0], region_across_rest_q[2:0]} : sum_3633;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3636;
  assign select_3636 = equal_2294_s13_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3639;
  assign select_3639 = equal_2294_s13_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

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
      chosen_near_q <= select_2407;
      registration_slope_row_q <= select_2602;
      registration_slope_change_q <= select_2605;
      registration_slope_q <= so_s13_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2713;
      patches_band_rows_number_q <= select_2715;
      patches_next_band_rows_to_next_q <= select_2718;
      patches_next_band_number_q <= select_2720;
      patches_first_band_rows_to_next_q <= select_2724;
      patches_first_band_number_q <= select_2725;
      patches_choosing_number_q <= and_510_s13_q ? select_2738 : patches_choosing_number_q;
      patches_choosing_band_q <= select_2745;
      region_across_rest_q <= select_3631;
      region_across_back_q <= so_s13_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3634;
      columns_begin_rest_q <= and_510_s13_q ? select_3636 : columns_begin_rest_q;
      columns_begin_back_q <= and_510_s13_q ? select_3639 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_914;
      sums_0_sum_sums_values_0_q <= sum_1164;
      sums_0_sum_sums_values_1_q <= equal_1162_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1412;
      sums_1_sum_sums_values_1_q <= equal_1162_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [3:0] select_471_s14_q;
  logic equal_472_s14_q;
  logic [6:0] select_474_s14_q;
  logic [8:0] select_478_s14_q;
  logic and_484_s14_q;
  logic equal_490_s14_q;
  logic [6:0] column_s14_q;
  logic and_508_s14_q;
  logic and_510_s14_q;
  logic so_s14_q;
  logic equal_530_s14_q;
  logic or_531_s14_q;
  logic less_538_s14_q;
  logic not_539_s14_q;
  logic equal_571_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_659_s14_q;
  logic and_664_s14_q;
  logic [7:0] sum_914_s14_q;
  logic less_1413_s14_q;
  logic [6:0] of_near_s14_q;
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
  logic not_2772_s14_q;
  logic less_3619_s14_q;
  logic equal_3824_s14_q;
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
      select_471_s14_q <= select_471_s13_q;
      equal_472_s14_q <= equal_472_s13_q;
      select_474_s14_q <= select_474_s13_q;
      select_478_s14_q <= select_478_s13_q;
      and_484_s14_q <= and_484_s13_q;
      equal_490_s14_q <= equal_490_s13_q;
      column_s14_q <= column_s13_q;
      and_508_s14_q <= and_508_s13_q;
      and_510_s14_q <= and_510_s13_q;
      so_s14_q <= so_s13_q;
      equal_530_s14_q <= equal_530_s13_q;
      or_531_s14_q <= or_531_s13_q;
      less_538_s14_q <= less_538_s13_q;
      not_539_s14_q <= not_539_s13_q;
      equal_571_s14_q <= equal_571_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      select_659_s14_q <= select_659_s13_q;
      and_664_s14_q <= and_664;
      sum_914_s14_q <= sum_914;
      less_1413_s14_q <= sum_1164 < sum_1412;
      of_near_s14_q <= of_near;
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
      not_2772_s14_q <= not_2772_s13_q;
      less_3619_s14_q <= less_3619_s13_q;
      equal_3824_s14_q <= equal_3824_s13_q;
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
  logic [7:0] select_915;
  assign select_915 = slot_s14_q[0] ? chosen_score_q : sum_914_s14_q;
  // hls/stages/agreement.hpp:735
  logic [7:0] select_1414;
  assign select_1414 = less_1413_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1415;
  assign less_1415 = select_915 < select_1414;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_664_s14_q ? (less_1415 ? select_1414 : select_915) : 8'h0;
  // hls/stages/agreement.hpp:704
  logic not_1421;
  assign not_1421 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1422;
  assign select_1422 = less_1413_s14_q ? {slot_s14_q[0], not_1421} : 2'h0;
  logic [2:0] select_1424;
  assign select_1424 = less_1415 ? {select_1422, not_1421} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1433;
  assign select_1433 = slot_s14_q[0] ? 8'h0 : sum_914_s14_q;
  // hls/stages/agreement.hpp:788
  logic or_1458;
  assign or_1458 = select_659_s14_q | (best_left_rdata_s14_q[39:33] < of_near_s14_q);
  // hls/stages/agreement.hpp:801
  logic or_1476;
  assign or_1476 = select_1470_s14_q | (best_right_rdata_s14_q[21:15] < of_near_s14_q);
  // hls/stages/agreement.hpp:235
  logic and_1502;
  assign and_1502 = (and_1489_s14_q & select_1496_s14_q) & ({{22{sum_1500_s14_q[9]}}, sum_1500_s14_q} < 32'h3);
  // hls/stages/patches.hpp:382
  logic not_1593;
  assign not_1593 = ~patches_begins_q;
  // hls/stages/patches.hpp:352
  logic and_1597;
  assign and_1597 = patches_capturing_q & not_1596_s14_q;
  // hls/stages/patches.hpp:117
  logic and_1605;
  assign and_1605 = (not_1593 & (patches_work_q == 3'h0)) & (~(and_1597 | or_1602_s14_q));
  // hls/stages/registration.hpp:218
  logic [13:0] select_1670;
  assign select_1670 = ($signed(10'h0) < $signed(select_1668_s14_q[16:7])) ? 14'h7f : select_1668_s14_q[13:0];
  // hls/stages/patches.hpp:520
  logic equal_1700;
  assign equal_1700 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:491
  logic equal_1702;
  assign equal_1702 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:485
  logic equal_1704;
  assign equal_1704 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:159
  logic equal_1705;
  assign equal_1705 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:520
  logic or_1706;
  assign or_1706 = equal_1704 | equal_1705;
  // hls/stages/patches.hpp:446
  logic not_1707;
  assign not_1707 = ~patches_second_q;
  // hls/stages/patches.hpp:363
  logic [4:0] select_1729;
  assign select_1729 = and_1605 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:118
  logic [4:0] select_1730;
  assign select_1730 = and_1592_s14_q ? select_1729 : patches_row_q;
  // hls/stages/patches.hpp:117
  logic and_1732;
  assign and_1732 = and_1597 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:118
  logic select_1736;
  assign select_1736 = and_1592_s14_q ? (and_1605 | (and_1597 & (~and_1732))) : patches_capturing_q;
  // hls/stages/patches.hpp:159
  logic not_1761;
  assign not_1761 = ~equal_1705;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1775;
  assign select_1775 = and_1592_s14_q ? {select_1729[4], select_1729[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:532
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
  // hls/stages/patches.hpp:546
  logic select_1868;
  assign select_1868 = equal_1864 ? (less_1861 & (less_1861 & not_1865)) : less_1861;
  // hls/stages/agreement.hpp:735
  logic less_2403;
  assign less_2403 = select_1433 < select_1414;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2498;
  assign select_2498 = or_531_s14_q ? (less_538_s14_q ? 8'h0 : best_left_rdata_s14_q[32:25]) : 8'h0;
  logic [7:0] select_2500;
  assign select_2500 = or_531_s14_q ? (less_538_s14_q ? 8'h0 : best_left_rdata_s14_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:383
  logic or_2813;
  assign or_2813 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:385
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:179
  logic and_2819;
  assign and_2819 = equal_1700 & not_1707;
  // hls/stages/patches.hpp:389
  logic and_2820;
  assign and_2820 = not_1761 & and_2819;
  logic [1:0] select_2822;
  assign select_2822 = equal_1702 ? 2'h0 : (equal_1704 ? 2'h3 : {equal_1705, and_2820});
  // hls/stages/patches.hpp:270
  logic equal_2824;
  assign equal_2824 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:268
  logic not_2825;
  assign not_2825 = ~equal_2824;
  // hls/stages/patches.hpp:270
  logic equal_2826;
  assign equal_2826 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:266
  logic not_2827;
  assign not_2827 = ~equal_2826;
  // hls/stages/patches.hpp:274
  logic not_2829;
  assign not_2829 = ~(patches_following_q == 3'h2);
  logic and_2832;
  assign and_2832 = (~(patches_following_q == 3'h1)) & not_2829;
  // hls/stages/patches.hpp:387
  logic [1:0] select_2833;
  assign select_2833 = equal_2826 ? 2'h2 : {and_2832, not_2829};
  logic [3:0] select_2834;
  assign select_2834 = equal_2824 ? 4'h2 : {select_2833, {2{not_2827}}};
  // hls/stages/patches.hpp:395
  logic not_2837;
  assign not_2837 = ~or_2813;
  // hls/stages/patches.hpp:384
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:396
  logic [11:0] select_2842;
  assign select_2842 = or_2813 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

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
      chosen_score_q <= less_2403 ? select_1414 : select_1433;
      chosen_place_q <= less_2403 ? {select_1422, not_1421} : 3'h2;
      before_0_q <= select_1433;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      patches_capturing_q <= sample_pair_whole_s14_q ? select_1736 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s14_q ? select_1730 : patches_row_q;
      patches_work_q <= or_2813 ? following : patches_work_q;
      patches_second_q <= not_1593 & (patches_second_q | (patches_ends_q & equal_1700));
      patches_following_q <= equal_1700 ? {2'h0, and_2819} : {equal_1702, select_2822};
      patches_following_beats_q <= {select_2834, not_2825};
      patches_begins_q <= sample_pair_whole_s14_q & (and_1592_s14_q & and_1732);
      patches_ends_q <= not_2837 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2842;
      patches_step_q <= or_2813 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic [3:0] select_471_s15_q;
  logic equal_472_s15_q;
  logic [6:0] select_474_s15_q;
  logic [8:0] select_478_s15_q;
  logic and_484_s15_q;
  logic equal_490_s15_q;
  logic [6:0] column_s15_q;
  logic and_508_s15_q;
  logic and_510_s15_q;
  logic so_s15_q;
  logic equal_530_s15_q;
  logic or_531_s15_q;
  logic less_538_s15_q;
  logic not_539_s15_q;
  logic equal_571_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_659_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1424_s15_q;
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
  logic [7:0] select_2498_s15_q;
  logic [7:0] select_2500_s15_q;
  logic not_2772_s15_q;
  logic or_2813_s15_q;
  logic not_2837_s15_q;
  logic and_3309_s15_q;
  logic equal_3316_s15_q;
  logic less_3619_s15_q;
  logic equal_3824_s15_q;
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
      select_471_s15_q <= select_471_s14_q;
      equal_472_s15_q <= equal_472_s14_q;
      select_474_s15_q <= select_474_s14_q;
      select_478_s15_q <= select_478_s14_q;
      and_484_s15_q <= and_484_s14_q;
      equal_490_s15_q <= equal_490_s14_q;
      column_s15_q <= column_s14_q;
      and_508_s15_q <= and_508_s14_q;
      and_510_s15_q <= and_510_s14_q;
      so_s15_q <= so_s14_q;
      equal_530_s15_q <= equal_530_s14_q;
      or_531_s15_q <= or_531_s14_q;
      less_538_s15_q <= less_538_s14_q;
      not_539_s15_q <= not_539_s14_q;
      equal_571_s15_q <= equal_571_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q;
      select_659_s15_q <= select_659_s14_q;
      of_best_s15_q <= of_best;
      select_1424_s15_q <= select_1424;
      of_near_s15_q <= of_near_s14_q;
      or_1458_s15_q <= or_1458;
      and_1461_s15_q <= and_1461_s14_q;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      select_1470_s15_q <= select_1470_s14_q;
      or_1476_s15_q <= or_1476;
      equal_1479_s15_q <= equal_1479_s14_q;
      and_1486_s15_q <= and_1486_s14_q;
      and_1490_s15_q <= not_539_s14_q & and_1489_s14_q;
      and_1493_s15_q <= and_1493_s14_q;
      and_1503_s15_q <= not_539_s14_q & and_1502;
      and_1508_s15_q <= and_1502 & or_1507_s14_q;
      select_1510_s15_q <= less_538_s14_q ? 9'h0 : best_left_rdata_s14_q[8:0];
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
      select_2498_s15_q <= select_2498;
      select_2500_s15_q <= select_2500;
      not_2772_s15_q <= not_2772_s14_q;
      or_2813_s15_q <= or_2813;
      not_2837_s15_q <= not_2837;
      and_3309_s15_q <= less_1861 & (patches_step_q[6:5] == 2'h1);
      equal_3316_s15_q <= patches_step_q[6:5] == 2'h2;
      less_3619_s15_q <= less_3619_s14_q;
      equal_3824_s15_q <= equal_3824_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic [15:0] patches_chance_q;
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:785
  logic equal_1427;
  assign equal_1427 = select_1424_s15_q == 3'h1;
  logic equal_1428;
  assign equal_1428 = select_1424_s15_q == 3'h2;
  logic not_1429;
  assign not_1429 = ~equal_1428;
  logic [2:0] select_1430;
  assign select_1430 = equal_1427 ? 3'h2 : {not_1429, {2{equal_1428}}};
  logic [7:0] select_1435;
  assign select_1435 = select_1430[1] ? (select_1430[0] ? before_1_s15_q : before_1_q) : (select_1430[0] ? before_1_q : before_0_q);
  logic [7:0] select_1436;
  assign select_1436 = select_1430[2] ? (select_1430[0] ? before_2_s15_q : before_0_s15_q) : select_1435;
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1438;
  assign select_1438 = equal_1427 ? 2'h0 : {not_1429, equal_1428};
  logic [7:0] select_1440;
  assign select_1440 = select_1438[1] ? before_2_q : (select_1438[0] ? before_2_s15_q : before_0_s15_q);
  // hls/stages/agreement.hpp:797
  logic or_1472;
  assign or_1472 = select_1470_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:235
  logic and_1509;
  assign and_1509 = not_539_s15_q & and_1508_s15_q;
  // hls/stages/agreement.hpp:141
  logic [14:0] shift_2;
  assign shift_2 = or_531_s15_q ? {select_1510_s15_q, and_1509, and_1503_s15_q, and_1493_s15_q, and_1490_s15_q, and_1486_s15_q, not_539_s15_q} : 15'h0;
  // hls/stages/patches.hpp:95
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
  // hls/stages/patches.hpp:498
  logic not_1701;
  assign not_1701 = ~equal_1700_s15_q;
  // hls/stages/patches.hpp:444
  logic not_1703;
  assign not_1703 = ~equal_1702_s15_q;
  logic and_1785;
  assign and_1785 = not_1701 & (or_1706_s15_q & not_1703);
  // hls/stages/patches.hpp:176
  logic and_1871;
  assign and_1871 = equal_1700_s15_q & (less_1861_s15_q ? and_1869_s15_q : select_1868_s15_q);
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2496;
  assign select_2496 = or_531_s15_q ? (less_538_s15_q ? 8'h0 : best_left_rdata_s15_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2498_s15_q} - {1'b0, select_2500_s15_q};
  // hls/stages/patches.hpp:83
  logic parity_2749;
  assign parity_2749 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2750;
  assign select_2750 = equal_2294_s15_q ? {patches_chance_q[14:0], parity_2749} : patches_chance_q;
  // hls/stages/patches.hpp:100
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:101
  logic [5:0] further;
  assign further = last_s15_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:118
  logic select_2774;
  assign select_2774 = and_1592_s15_q ? (and_1605_s15_q ? not_2772_s15_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:179
  logic [4:0] select_2844;
  assign select_2844 = or_2813_s15_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:543
  logic select_3311;
  assign select_3311 = less_1861_s15_q ? (not_1865_s15_q & and_3309_s15_q) : and_3309_s15_q;
  // hls/stages/patches.hpp:546
  logic select_3312;
  assign select_3312 = equal_1864_s15_q ? select_3311 : and_3309_s15_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:757; read in stage 15, written in stage 28: 15 < 28 < 15 + DISTANCE.
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

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:757; read in stage 15, written in stage 28: 15 < 28 < 15 + DISTANCE.
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

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:769; read in stage 15, written in stage 19: 15 < 19 < 15 + DISTANCE.
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

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:789; read in stage 15, written in stage 29: 15 < 29 < 15 + DISTANCE.
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
      patches_chance_q <= and_510_s15_q ? select_2750 : patches_chance_q;
      patches_lower_q <= sample_pair_whole_s15_q ? select_2774 : patches_lower_q;
      patches_code_row_q <= select_2844;
      patches_column_q <= or_2813_s15_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2837_s15_q & (patches_column_q == 5'h1e);
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
  logic [3:0] select_471_s16_q;
  logic equal_472_s16_q;
  logic [6:0] select_474_s16_q;
  logic [8:0] select_478_s16_q;
  logic and_484_s16_q;
  logic equal_490_s16_q;
  logic [6:0] column_s16_q;
  logic and_508_s16_q;
  logic and_510_s16_q;
  logic so_s16_q;
  logic equal_571_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1419_s16_q;
  logic [2:0] select_1424_s16_q;
  logic [7:0] select_1436_s16_q;
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
  logic [7:0] select_2496_s16_q;
  logic rise_s16_q;
  logic [7:0] select_2502_s16_q;
  logic [7:0] xor_2507_s16_q;
  logic less_2531_s16_q;
  logic [5:0] further_s16_q;
  logic or_2813_s16_q;
  logic not_2837_s16_q;
  logic select_3314_s16_q;
  logic equal_3316_s16_q;
  logic less_3619_s16_q;
  logic equal_3824_s16_q;
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
      select_471_s16_q <= select_471_s15_q;
      equal_472_s16_q <= equal_472_s15_q;
      select_474_s16_q <= select_474_s15_q;
      select_478_s16_q <= select_478_s15_q;
      and_484_s16_q <= and_484_s15_q;
      equal_490_s16_q <= equal_490_s15_q;
      column_s16_q <= column_s15_q;
      and_508_s16_q <= and_508_s15_q;
      and_510_s16_q <= and_510_s15_q;
      so_s16_q <= so_s15_q;
      equal_571_s16_q <= equal_571_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      of_best_s16_q <= of_best_s15_q;
      or_1419_s16_q <= select_659_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1424_s16_q <= select_1424_s15_q;
      select_1436_s16_q <= select_1436;
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
      and_1521_s16_q <= equal_530_s15_q & shift_2[4];
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
      select_2496_s16_q <= select_2496;
      rise_s16_q <= rise[8];
      select_2502_s16_q <= rise[8] ? select_2498_s15_q : select_2500_s15_q;
      xor_2507_s16_q <= rise[7:0] ^ {8{rise[8]}};
      less_2531_s16_q <= select_2498_s15_q < select_2500_s15_q;
      further_s16_q <= further;
      or_2813_s16_q <= or_2813_s15_q;
      not_2837_s16_q <= not_2837_s15_q;
      select_3314_s16_q <= less_1861_s15_q ? (not_1863_s15_q & select_3312) : select_3312;
      equal_3316_s16_q <= equal_3316_s15_q;
      less_3619_s16_q <= less_3619_s15_q;
      equal_3824_s16_q <= equal_3824_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/agreement.hpp:955
  logic not_1480;
  assign not_1480 = ~equal_1479_s16_q;
  // hls/stages/patches.hpp:330
  logic and_1512;
  assign and_1512 = ends_cell_s16_q & shift_2_s16_q[0];
  logic and_1514;
  assign and_1514 = not_1480 & (so_s16_q & and_1512);
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_1564;
  assign sum_1564 = {1'b0, last_s16_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s16_q[0] & ({1'b0, sum_1564, last_s16_q[1]} < x_s16_q);
  // hls/stages/patches.hpp:94
  logic [9:0] sum_1647;
  assign sum_1647 = {2'h0, x_s16_q} + {{4{shift_2_s16_q[10]}}, shift_2_s16_q[10:5]};
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1680;
  assign sum_1680 = sum_1676_s16_q + {sum_1679_s16_q, select_1677_s16_q};
  logic [9:0] sum_1681;
  assign sum_1681 = {difference_1673_s16_q, select_1671_s16_q} + sum_1680[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] difference_2503;
  assign difference_2503 = {1'b0, select_2496_s16_q} - {1'b0, select_2502_s16_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2503[8] ? 8'h0 : difference_2503[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_s16_q} + {1'b0, xor_2507_s16_q};
  // hls/stages/patches.hpp:102
  logic [5:0] select_2755;
  assign select_2755 = right_3_s16_q ? last_s16_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s16_q} + {1'b0, select_2755};

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
  assign shown_right_re = s16_en & and_1514;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:758; read in stage 16, written in stage 27: 16 < 27 < 16 + DISTANCE.
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
  assign seen_columns_re = s16_en & and_1514;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s16_en) begin
      patches_read_searches_q <= equal_1700_s16_q ? select_3314_s16_q : patches_read_searches_q;
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
  logic [3:0] select_471_s17_q;
  logic equal_472_s17_q;
  logic [6:0] select_474_s17_q;
  logic [8:0] select_478_s17_q;
  logic and_484_s17_q;
  logic equal_490_s17_q;
  logic [6:0] column_s17_q;
  logic and_508_s17_q;
  logic and_510_s17_q;
  logic so_s17_q;
  logic equal_571_s17_q;
  logic [6:0] x_s17_2_q;
  logic [5:0] select_1420_s17_q;
  logic [2:0] select_1425_s17_q;
  logic [7:0] select_1426_s17_q;
  logic [7:0] select_1437_s17_q;
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
  logic less_2531_s17_q;
  logic not_2758_s17_q;
  logic or_2813_s17_q;
  logic not_2837_s17_q;
  logic equal_3316_s17_q;
  logic less_3619_s17_q;
  logic equal_3824_s17_q;
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
      select_471_s17_q <= select_471_s16_q;
      equal_472_s17_q <= equal_472_s16_q;
      select_474_s17_q <= select_474_s16_q;
      select_478_s17_q <= select_478_s16_q;
      and_484_s17_q <= and_484_s16_q;
      equal_490_s17_q <= equal_490_s16_q;
      column_s17_q <= column_s16_q;
      and_508_s17_q <= and_508_s16_q;
      and_510_s17_q <= and_510_s16_q;
      so_s17_q <= so_s16_q;
      equal_571_s17_q <= equal_571_s16_q;
      x_s17_2_q <= x_s16_2_q;
      select_1420_s17_q <= or_1419_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1425_s17_q <= or_1419_s16_q ? select_1424_s16_q : best_left_rdata_s16_q[8:6];
      select_1426_s17_q <= or_1419_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1437_s17_q <= or_1419_s16_q ? select_1436_s16_q : best_left_rdata_s16_q[24:17];
      select_1441_s17_q <= or_1419_s16_q ? select_1440_s16_q : best_left_rdata_s16_q[32:25];
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
      less_2531_s17_q <= less_2531_s16_q;
      not_2758_s17_q <= ~(x_s16_q < {1'b0, from});
      or_2813_s17_q <= or_2813_s16_q;
      not_2837_s17_q <= not_2837_s16_q;
      equal_3316_s17_q <= equal_3316_s16_q;
      less_3619_s17_q <= less_3619_s16_q;
      equal_3824_s17_q <= equal_3824_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
  // hls/stages/census.hpp:119
  logic and_485;
  assign and_485 = sample_pair_whole_s17_q & and_484_s17_q;
  // hls/stages/agreement.hpp:193
  logic not_1519;
  assign not_1519 = ~so_s17_q;
  // hls/stages/patches.hpp:330
  logic and_1520;
  assign and_1520 = not_1519 & shift_2_s17_q[4];
  logic and_1617;
  assign and_1617 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & right_3_s17_q));
  // hls/stages/patches.hpp:96
  logic and_1640;
  assign and_1640 = less_1638_s17_q & (~right_3_s17_q);
  // hls/stages/patches.hpp:98
  logic equal_1641;
  assign equal_1641 = x_s17_q == 8'h0;
  // hls/stages/agreement.hpp:964
  logic and_1651;
  assign and_1651 = (~(and_1640 | (equal_1641 | not_1643_s17_q))) & (less_1648_s17_q & less_1649_s17_q);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1682;
  assign sum_1682 = {registration_slope_s17_q[11], registration_slope_s17_q} + {{5{sum_1681_s17_q[7]}}, sum_1681_s17_q};
  // hls/stages/patches.hpp:330
  logic and_1696;
  assign and_1696 = ends_cell_s17_q & (shift_2_s17_q[0] & (and_1640 | equal_1693_s17_q));
  logic and_1698;
  assign and_1698 = not_1480_s17_q & (so_s17_q & and_1696);
  // hls/stages/patches.hpp:164
  logic [7:0] pixel;
  assign pixel = equal_1705_s17_q ? (patches_second_s17_q ? 8'h0 : patches_right_0_rdata_s17_q) : 8'h0;
  // hls/stages/patches.hpp:453
  logic [8:0] sum_1823;
  assign sum_1823 = {1'b0, patches_columns_above_rdata_s17_q[23:16]} + {3'h0, patches_columns_above_rdata_s17_q[31:26]};
  // hls/stages/agreement.hpp:1000
  logic or_1894;
  assign or_1894 = (~sum_1892_s17_q) | equal_1693_s17_q;
  // hls/stages/registration.hpp:40
  logic [8:0] select_2510;
  assign select_2510 = ({wide_s17_q, 1'b0} < size_3_s17_q) ? {wide_s17_q, 1'b0} : size_3_s17_q;
  logic [8:0] taken;
  assign taken = ~select_2510;
  // hls/stages/patches.hpp:330
  logic and_2761;
  assign and_2761 = so_s17_q & (ends_cell_s17_q & (shift_2_s17_q[0] & not_2758_s17_q));
  // hls/stages/patches.hpp:542
  logic [9:0] select_3279;
  assign select_3279 = less_1861_s17_q ? patches_rows_rdata_s17_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3281;
  assign select_3281 = less_1861_s17_q ? (equal_1864_s17_q ? 10'h0 : select_3279) : 10'h0;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3286;
  assign select_3286 = less_1861_s17_q ? patches_rows_rdata_s17_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3289;
  assign select_3289 = equal_1864_s17_q ? (less_1861_s17_q ? (equal_1864_s17_q ? 5'h0 : select_3286) : 5'h0) : select_3286;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:226; read in stage 17, written in stage 20: 17 < 20 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_478_s17_q;
  logic averager_memory_re;
  assign averager_memory_re = s17_en & and_485;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1461_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1460_s17_q, select_1459_s17_q, select_1441_s17_q, select_1437_s17_q, select_1426_s17_q, select_1425_s17_q, select_1420_s17_q};
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
  logic [3:0] select_471_s18_q;
  logic equal_472_s18_q;
  logic [6:0] select_474_s18_q;
  logic [8:0] select_478_s18_q;
  logic and_484_s18_q;
  logic and_485_s18_q;
  logic equal_490_s18_q;
  logic [6:0] column_s18_q;
  logic and_508_s18_q;
  logic and_510_s18_q;
  logic so_s18_q;
  logic equal_571_s18_q;
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
  logic [17:0] seen_columns_rdata_s18_q;
  logic and_2030_s18_q;
  logic equal_2170_s18_q;
  logic equal_2294_s18_q;
  logic less_2494_s18_q;
  logic [7:0] wide_s18_q;
  logic [8:0] taken_s18_q;
  logic [7:0] not_2512_s18_q;
  logic less_2531_s18_q;
  logic and_2762_s18_q;
  logic or_2813_s18_q;
  logic not_2837_s18_q;
  logic [9:0] select_3282_s18_q;
  logic [4:0] select_3289_s18_q;
  logic equal_3316_s18_q;
  logic less_3619_s18_q;
  logic select_3662_s18_q;
  logic equal_3824_s18_q;
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
      select_471_s18_q <= select_471_s17_q;
      equal_472_s18_q <= equal_472_s17_q;
      select_474_s18_q <= select_474_s17_q;
      select_478_s18_q <= select_478_s17_q;
      and_484_s18_q <= and_484_s17_q;
      and_485_s18_q <= and_485;
      equal_490_s18_q <= equal_490_s17_q;
      column_s18_q <= column_s17_q;
      and_508_s18_q <= and_508_s17_q;
      and_510_s18_q <= and_510_s17_q;
      so_s18_q <= so_s17_q;
      equal_571_s18_q <= equal_571_s17_q;
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
      seen_columns_rdata_s18_q <= seen_columns_rdata_q;
      and_2030_s18_q <= not_1480_s17_q & (so_s17_q & (ends_cell_s17_q & and_2027_s17_q));
      equal_2170_s18_q <= equal_2170_s17_q;
      equal_2294_s18_q <= equal_2294_s17_q;
      less_2494_s18_q <= slot_s17_q < 3'h3;
      wide_s18_q <= wide_s17_q;
      taken_s18_q <= taken;
      not_2512_s18_q <= ~wide_s17_q;
      less_2531_s18_q <= less_2531_s17_q;
      and_2762_s18_q <= not_1480_s17_q & and_2761;
      or_2813_s18_q <= or_2813_s17_q;
      not_2837_s18_q <= not_2837_s17_q;
      select_3282_s18_q <= equal_1864_s17_q ? select_3281 : select_3279;
      select_3289_s18_q <= select_3289;
      equal_3316_s18_q <= equal_3316_s17_q;
      less_3619_s18_q <= less_3619_s17_q;
      select_3662_s18_q <= sum_1892_s17_q ? (equal_1693_s17_q & or_1894) : or_1894;
      equal_3824_s18_q <= equal_3824_s17_q;
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
  logic [13:0] select_488;
  assign select_488 = equal_472_s18_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_494;
  assign sum_494 = {6'h0, sample_pair_pixel_1_q} + (equal_472_s18_q ? 14'h0 : averager_running_1_q);
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
  // hls/stages/patches.hpp:330
  logic [5:0] select_1664;
  assign select_1664 = ends_cell_s18_q ? (shift_2_s18_q[0] ? shift_2_s18_q[10:5] : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1686;
  assign select_1686 = less_1683_s18_q ? 8'h7f : (less_1684_s18_q ? 8'h80 : sum_1682_s18_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1620 ? registration_slope_here_q : select_1686;
  // hls/stages/patches.hpp:330
  logic [7:0] select_1690;
  assign select_1690 = so_s18_q ? (ends_cell_s18_q ? (shift_2_s18_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:164
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1705_s18_q ? select_1789_s18_q : patches_left_rdata_s18_q;
  // hls/stages/patches.hpp:453
  logic [9:0] sum_1824;
  assign sum_1824 = {2'h0, patches_columns_above_rdata_s18_q[15:8]} + {1'b0, sum_1823_s18_q};
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1879;
  assign select_1879 = so_s18_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_1882;
  assign or_1882 = select_1879[7] | (~({select_1879[5], select_1879[3], select_1879[1]} == 3'h0));
  // hls/stages/agreement.hpp:250
  logic and_1911;
  assign and_1911 = shift_2_s18_q[0] & ({shift_2_s18_q[4], shift_2_s18_q[2]} == 2'h3);
  // hls/stages/agreement.hpp:960
  logic select_1919;
  assign select_1919 = slot_s18_q[2] ? shown_shown_q : shift_2_s18_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s18_q[0] & (shown_right_rdata_s18_q[0] | select_1919);
  // hls/stages/agreement.hpp:960
  logic select_1922;
  assign select_1922 = slot_s18_q[2] ? shown_nearer_q : shift_2_s18_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s18_q[0] & (select_1919 ? select_1922 : shown_right_rdata_s18_q[1]);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_1971;
  assign select_1971 = shift_2_s18_q[0] ? (sum_1892_s18_q ? select_1879 : {select_1879[6:0], 1'b0}) : select_1879;
  // hls/stages/agreement.hpp:992
  logic or_1974;
  assign or_1974 = select_1971[7] | (~({select_1971[5], select_1971[3], select_1971[1]} == 3'h0));
  // hls/stages/registration.hpp:37
  logic not_2505;
  assign not_2505 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2494_s18_q ? {1'b0, wide_s18_q, 1'b0} : {registration_displacement_over_q[8:0], not_2505};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2513;
  assign select_2513 = registration_displacement_over_q[9] ? wide_s18_q : not_2512_s18_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2494_s18_q ? {taken_s18_q, 1'b1} : {not_2505, select_2513, not_2505};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2515;
  assign sum_2515 = {left, 1'b1} + {taken_2, less_2494_s18_q};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2517;
  assign select_2517 = so_s18_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/patches.hpp:330
  logic [7:0] select_2519;
  assign select_2519 = equal_1479_s18_q ? registration_slope_here_q : (so_s18_q ? slope : registration_slope_here_q);
  // hls/stages/patches.hpp:546
  logic [9:0] select_3284;
  assign select_3284 = less_1861_s18_q ? (equal_1862_s18_q ? 10'h0 : select_3282_s18_q) : select_3282_s18_q;
  logic [4:0] select_3291;
  assign select_3291 = less_1861_s18_q ? (equal_1862_s18_q ? 5'h0 : select_3289_s18_q) : select_3289_s18_q;
  // hls/stages/patches.hpp:542
  logic and_3301;
  assign and_3301 = less_1861_s18_q & (patches_step_s18_q == 5'h0);
  // hls/stages/patches.hpp:546
  logic select_3304;
  assign select_3304 = equal_1864_s18_q ? (less_1861_s18_q ? (not_1865_s18_q & and_3301) : and_3301) : and_3301;
  // hls/stages/patches.hpp:330
  logic select_3616;
  assign select_3616 = equal_1479_s18_q ? shown_shown_q : (so_s18_q ? select_1919 : shown_shown_q);
  logic select_3618;
  assign select_3618 = equal_1479_s18_q ? shown_nearer_q : (so_s18_q ? select_1922 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3620;
  assign sum_3620 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/patches.hpp:330
  logic [7:0] select_3629;
  assign select_3629 = equal_1479_s18_q ? select_1879 : (so_s18_q ? (ends_cell_s18_q ? select_1971 : select_1879) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3643;
  assign select_3643 = equal_571_s18_q ? {difference_3641[7], difference_3641} : (less_3619_s18_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3645;
  assign select_3645 = and_510_s18_q ? (equal_2294_s18_q ? select_3643 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3647;
  assign select_3647 = equal_571_s18_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [7:0] select_3649;
  assign select_3649 = and_510_s18_q ? (equal_2294_s18_q ? select_3647 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3651;
  assign select_3651 = sum_3620[7] ? {1'b1, sum_3620[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});
  // hls/stages/agreement.hpp:197
  logic or_3660;
  assign or_3660 = segment_starts_q | not_1519_s18_q;
  // hls/stages/patches.hpp:330
  logic select_3664;
  assign select_3664 = ends_cell_s18_q ? (shift_2_s18_q[0] ? select_3662_s18_q : or_3660) : or_3660;

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
      registration_displacement_over_q <= so_s18_q ? sum_2515[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2517;
      registration_slope_here_q <= select_2519;
      patches_read_row_differing_q <= equal_1700_s18_q ? select_3284 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1700_s18_q ? select_3291 : patches_read_row_column_q;
      shown_shown_q <= select_3616;
      shown_nearer_q <= select_3618;
      region_columns_q <= select_3629;
      region_down_rest_q <= select_3645;
      region_down_back_q <= select_3649;
      region_down_next_q <= select_3651;
      segment_starts_q <= equal_1479_s18_q ? or_3660 : (so_s18_q ? select_3664 : or_3660);
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
      averager_running_0_q <= sample_pair_whole_s18_q ? select_488 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s18_q ? sum_494 : averager_running_1_q;
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
  logic [3:0] select_471_s19_q;
  logic equal_472_s19_q;
  logic [6:0] select_474_s19_q;
  logic [8:0] select_478_s19_q;
  logic and_484_s19_q;
  logic and_485_s19_q;
  logic [29:0] averager_memory_rdata_s19_q;
  logic [13:0] select_488_s19_q;
  logic equal_490_s19_q;
  logic [13:0] sum_494_s19_q;
  logic [6:0] column_s19_q;
  logic and_508_s19_q;
  logic and_510_s19_q;
  logic so_s19_q;
  logic equal_571_s19_q;
  logic equal_1479_s19_q;
  logic not_1480_s19_q;
  logic [4:0] shift_2_s19_q;
  logic and_1514_s19_q;
  logic equal_1524_s19_q;
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
  logic or_1882_s19_q;
  logic or_1885_s19_q;
  logic or_1888_s19_q;
  logic and_1897_s19_q;
  logic textured_s19_q;
  logic and_1911_s19_q;
  logic [12:0] seen_columns_rdata_s19_q;
  logic shown_s19_q;
  logic near_s19_q;
  logic and_1957_s19_q;
  logic and_1959_s19_q;
  logic or_1974_s19_q;
  logic or_1977_s19_q;
  logic or_1980_s19_q;
  logic and_1991_s19_q;
  logic and_1993_s19_q;
  logic and_1994_s19_q;
  logic and_2007_s19_q;
  logic and_2009_s19_q;
  logic and_2010_s19_q;
  logic and_2030_s19_q;
  logic equal_2170_s19_q;
  logic equal_2294_s19_q;
  logic and_2434_s19_q;
  logic and_2436_s19_q;
  logic and_2437_s19_q;
  logic or_2529_s19_q;
  logic [1:0] sum_2530_s19_q;
  logic less_2531_s19_q;
  logic and_2762_s19_q;
  logic or_2813_s19_q;
  logic not_2837_s19_q;
  logic select_3304_s19_q;
  logic equal_3316_s19_q;
  logic less_3619_s19_q;
  logic sum_3620_s19_q;
  logic and_3814_s19_q;
  logic equal_3824_s19_q;
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
      select_471_s19_q <= select_471_s18_q;
      equal_472_s19_q <= equal_472_s18_q;
      select_474_s19_q <= select_474_s18_q;
      select_478_s19_q <= select_478_s18_q;
      and_484_s19_q <= and_484_s18_q;
      and_485_s19_q <= and_485_s18_q;
      averager_memory_rdata_s19_q <= averager_memory_rdata_q;
      select_488_s19_q <= select_488;
      equal_490_s19_q <= equal_490_s18_q;
      sum_494_s19_q <= sum_494;
      column_s19_q <= column_s18_q;
      and_508_s19_q <= and_508_s18_q;
      and_510_s19_q <= and_510_s18_q;
      so_s19_q <= so_s18_q;
      equal_571_s19_q <= equal_571_s18_q;
      equal_1479_s19_q <= equal_1479_s18_q;
      not_1480_s19_q <= not_1480_s18_q;
      shift_2_s19_q <= {shift_2_s18_q[11], shift_2_s18_q[3:0]};
      and_1514_s19_q <= and_1514_s18_q;
      equal_1524_s19_q <= x_s18_q[6:4] == 3'h7;
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
      or_1882_s19_q <= or_1882;
      or_1885_s19_q <= select_1879[7] | (~({select_1879[6], select_1879[3:2]} == 3'h0));
      or_1888_s19_q <= select_1879[7] | (~(select_1879[6:4] == 3'h0));
      and_1897_s19_q <= and_1897_s18_q;
      textured_s19_q <= textured_s18_q;
      and_1911_s19_q <= and_1911;
      seen_columns_rdata_s19_q <= {seen_columns_rdata_s18_q[13:7], seen_columns_rdata_s18_q[5:0]};
      shown_s19_q <= shown;
      near_s19_q <= near;
      and_1957_s19_q <= seen_columns_rdata_s18_q[14] & shift_2_s18_q[0];
      and_1959_s19_q <= seen_columns_rdata_s18_q[5] & shift_2_s18_q[0];
      or_1974_s19_q <= or_1974;
      or_1977_s19_q <= select_1971[7] | (~({select_1971[6], select_1971[3:2]} == 3'h0));
      or_1980_s19_q <= select_1971[7] | (~(select_1971[6:4] == 3'h0));
      and_1991_s19_q <= seen_columns_rdata_s18_q[16] & shift_2_s18_q[0];
      and_1993_s19_q <= seen_columns_rdata_s18_q[8] & shift_2_s18_q[0];
      and_1994_s19_q <= seen_columns_rdata_s18_q[3] & shift_2_s18_q[0];
      and_2007_s19_q <= seen_columns_rdata_s18_q[17] & shift_2_s18_q[0];
      and_2009_s19_q <= seen_columns_rdata_s18_q[9] & shift_2_s18_q[0];
      and_2010_s19_q <= seen_columns_rdata_s18_q[4] & shift_2_s18_q[0];
      and_2030_s19_q <= and_2030_s18_q;
      equal_2170_s19_q <= equal_2170_s18_q;
      equal_2294_s19_q <= equal_2294_s18_q;
      and_2434_s19_q <= seen_columns_rdata_s18_q[15] & shift_2_s18_q[0];
      and_2436_s19_q <= seen_columns_rdata_s18_q[7] & shift_2_s18_q[0];
      and_2437_s19_q <= seen_columns_rdata_s18_q[2] & shift_2_s18_q[0];
      or_2529_s19_q <= (shift_2_s18_q[13:11] == 3'h0) | (shift_2_s18_q[13:11] == 3'h4);
      sum_2530_s19_q <= shift_2_s18_q[13:12] + 2'h3;
      less_2531_s19_q <= less_2531_s18_q;
      and_2762_s19_q <= and_2762_s18_q;
      or_2813_s19_q <= or_2813_s18_q;
      not_2837_s19_q <= not_2837_s18_q;
      select_3304_s19_q <= select_3304;
      equal_3316_s19_q <= equal_3316_s18_q;
      less_3619_s19_q <= less_3619_s18_q;
      sum_3620_s19_q <= sum_3620[7];
      and_3814_s19_q <= seen_columns_rdata_s18_q[6] & shift_2_s18_q[0];
      equal_3824_s19_q <= equal_3824_s18_q;
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
  logic [13:0] sum_492;
  assign sum_492 = select_488_s19_q + (equal_490_s19_q ? 14'h0 : averager_memory_rdata_s19_q[13:0]);
  logic [13:0] sum_496;
  assign sum_496 = sum_494_s19_q + (equal_490_s19_q ? 14'h0 : averager_memory_rdata_s19_q[27:14]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = equal_472_s19_q ? sample_present_s19_q : (sample_present_s19_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_472_s19_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:123
  logic and_504;
  assign and_504 = all_of_skin & (averager_memory_rdata_s19_q[29] | equal_490_s19_q);
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s19_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:201
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
  // hls/stages/agreement.hpp:1116
  logic and_1550;
  assign and_1550 = (~equal_1540) & ((~equal_1542) & ((~equal_1544) & (~equal_1546)));
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1627;
  assign sum_1627 = {{3{sum_1623_s19_q[7]}}, sum_1623_s19_q} + {sum_1626_s19_q[8], sum_1626_s19_q, select_1624_s19_q};
  logic [9:0] sum_1631;
  assign sum_1631 = {difference_1630_s19_q, select_1628_s19_q} + {sum_1627[10], sum_1627[10:2]};
  // hls/stages/patches.hpp:455
  logic [8:0] sum_1813;
  assign sum_1813 = {1'b0, patches_columns_above_rdata_s19_q[7:0]} + {2'h0, pixel_2_s19_q[7:1]};
  logic [8:0] sum_1814;
  assign sum_1814 = {1'b0, patches_columns_above_rdata_s19_q[23:16]} + {2'h0, patches_columns_above_rdata_s19_q[31:25]};
  // hls/stages/patches.hpp:453
  logic [10:0] sum_1825;
  assign sum_1825 = {3'h0, patches_columns_above_rdata_s19_q[15:8]} + {sum_1824_s19_q, patches_columns_above_rdata_s19_q[25]};
  // hls/stages/patches.hpp:330
  logic [5:0] select_1889;
  assign select_1889 = equal_1479_s19_q ? x_s19_q[5:0] : {region_row_q, or_1888_s19_q, or_1885_s19_q, or_1882_s19_q};
  // hls/stages/agreement.hpp:1070
  logic not_1890;
  assign not_1890 = ~equal_1524_s19_q;
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s19_q[0] & shift_2_s19_q[3];
  logic and_1918;
  assign and_1918 = shift_2_s19_q[0] & shift_2_s19_q[2];
  // hls/stages/agreement.hpp:976
  logic and_1960;
  assign and_1960 = seen_columns_rdata_s19_q[0] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_1962;
  assign sum_1962 = {1'b0, and_1959_s19_q} + ({1'b0, textured_s19_q} + {1'b0, and_1960});
  // hls/stages/agreement.hpp:976
  logic and_1992;
  assign and_1992 = seen_columns_rdata_s19_q[11] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1996;
  assign sum_1996 = {1'b0, and_1993_s19_q} + ({1'b0, shown_s19_q} + {1'b0, and_1994_s19_q});
  // hls/stages/agreement.hpp:976
  logic and_2008;
  assign and_2008 = seen_columns_rdata_s19_q[12] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_2012;
  assign sum_2012 = {1'b0, and_2009_s19_q} + ({1'b0, near_s19_q} + {1'b0, and_2010_s19_q});
  // hls/stages/agreement.hpp:263
  logic select_2083;
  assign select_2083 = sample_pair_whole_s19_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/patches.hpp:330
  logic and_2413;
  assign and_2413 = so_s19_q & (ends_cell_s19_q & (shift_2_s19_q[0] & shift_2_s19_q[1]));
  // hls/stages/agreement.hpp:1047
  logic not_2433;
  assign not_2433 = ~(x_s19_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:976
  logic and_2435;
  assign and_2435 = seen_columns_rdata_s19_q[10] & shift_2_s19_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2439;
  assign sum_2439 = {1'b0, and_2436_s19_q} + ({1'b0, explained} + {1'b0, and_2437_s19_q});
  // hls/stages/patches.hpp:330
  logic and_2474;
  assign and_2474 = ends_cell_s19_q & (shift_2_s19_q[0] & (shift_2_s19_q[2:1] == 2'h3));
  // hls/stages/agreement.hpp:1052
  logic and_2480;
  assign and_2480 = not_2433 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2532;
  assign difference_2532 = {sum_2530_s19_q, shift_2_s19_q[4], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2533;
  assign select_2533 = less_2531_s19_q ? difference_2532 : {sum_2530_s19_q, shift_2_s19_q[4], registration_displacement_fraction_q};
  logic [7:0] select_2534;
  assign select_2534 = or_2529_s19_q ? {sum_2530_s19_q, shift_2_s19_q[4], 5'h0} : select_2533;
  // hls/stages/patches.hpp:179
  logic select_2852;
  assign select_2852 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:167
  logic and_2913;
  assign and_2913 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:403
  logic [4:0] select_2918;
  assign select_2918 = or_2813_s19_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:405
  logic [3:0] select_2920;
  assign select_2920 = and_2913 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:542
  logic [4:0] select_3293;
  assign select_3293 = less_1861_s19_q ? patches_step_s19_q : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3296;
  assign select_3296 = equal_1864_s19_q ? (less_1861_s19_q ? (equal_1864_s19_q ? 5'h0 : select_3293) : 5'h0) : select_3293;
  logic [4:0] select_3298;
  assign select_3298 = less_1861_s19_q ? (equal_1862_s19_q ? 5'h0 : select_3296) : select_3296;
  logic select_3306;
  assign select_3306 = less_1861_s19_q ? (not_1863_s19_q & select_3304_s19_q) : select_3304_s19_q;
  // hls/stages/patches.hpp:170
  logic or_3318;
  assign or_3318 = patches_read_first_q | (patches_read_row_differing_s19_q < patches_peak_best_differing_q);
  logic and_3319;
  assign and_3319 = patches_read_searches_s19_q & or_3318;
  // hls/stages/patches.hpp:525
  logic [14:0] select_3351;
  assign select_3351 = and_3319 ? {patches_read_row_column_s19_q, patches_read_row_differing_s19_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:176
  logic [9:0] select_3352;
  assign select_3352 = equal_1700_s19_q ? select_3351[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3353;
  assign select_3353 = equal_1700_s19_q ? select_3351[14:10] : patches_peak_best_column_q;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3622;
  assign select_3622 = less_3619_s19_q ? (sum_3620_s19_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3624;
  assign select_3624 = equal_2294_s19_q ? (equal_571_s19_q ? 3'h0 : select_3622) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3620_s19_q;
  // hls/stages/agreement.hpp:447
  logic select_3655;
  assign select_3655 = equal_2294_s19_q ? (equal_571_s19_q | (less_3619_s19_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:1148
  logic equal_3673;
  assign equal_3673 = x_s19_q[6:3] == 4'h7;
  logic equal_3695;
  assign equal_3695 = x_s19_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_3708;
  assign select_3708 = (x_s19_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3710;
  assign select_3710 = equal_3695 ? cfg_unproven_skin_limit_i : (equal_3673 ? cfg_unproven_limit_i : select_3708);
  // hls/stages/patches.hpp:330
  logic select_3812;
  assign select_3812 = so_s19_q ? (ends_cell_s19_q ? and_1959_s19_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3816;
  assign select_3816 = so_s19_q ? (ends_cell_s19_q ? and_3814_s19_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_3818;
  assign select_3818 = ends_cell_s19_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3820;
  assign select_3820 = equal_1479_s19_q ? centres_values_1_textured_q : (so_s19_q ? select_3818 : centres_values_1_textured_q);
  logic select_3821;
  assign select_3821 = ends_cell_s19_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3823;
  assign select_3823 = equal_1479_s19_q ? centres_values_1_of_skin_q : (so_s19_q ? select_3821 : centres_values_1_of_skin_q);

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
  assign census_memory_re = s19_en & and_510_s19_q;
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
  assign regions_raddr = select_1889;
  logic regions_re;
  assign regions_re = s19_en & (equal_1479_s19_q ? (x_s19_q[6] & not_1890) : and_1897_s19_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

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
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s19_q, near_s19_q, shown_s19_q, explained, and_1918, textured_s19_q};
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
      averager_running_of_skin_q <= select_2083;
      patches_along_ends_q <= not_2837_s19_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2837_s19_q & select_2852;
      patches_down_by_q <= or_2813_s19_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2913});
      patches_along_q <= select_2918;
      patches_match_row_q <= or_2813_s19_q ? 4'h0 : select_2920;
      patches_summed_last_q <= not_1701_s19_q & (equal_1702_s19_q & and_2913);
      patches_read_first_q <= equal_1700_s19_q ? select_3306 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3352;
      patches_peak_best_column_q <= select_3353;
      region_row_q <= and_510_s19_q ? select_3624 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_510_s19_q ? select_3655 : region_fresh_q;
      segment_started_q <= ~segment_starts_q;
      centres_values_0_textured_q <= equal_1479_s19_q ? centres_values_0_textured_q : select_3812;
      centres_values_0_of_skin_q <= equal_1479_s19_q ? centres_values_0_of_skin_q : select_3816;
      centres_values_1_textured_q <= select_3820;
      centres_values_1_of_skin_q <= select_3823;
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
  logic [3:0] select_471_s20_q;
  logic [6:0] select_474_s20_q;
  logic [8:0] select_478_s20_q;
  logic and_484_s20_q;
  logic and_485_s20_q;
  logic [13:0] sum_492_s20_q;
  logic [13:0] sum_496_s20_q;
  logic and_500_s20_q;
  logic and_504_s20_q;
  logic [6:0] column_s20_q;
  logic and_508_s20_q;
  logic and_510_s20_q;
  logic equal_513_s20_q;
  logic so_s20_q;
  logic equal_571_s20_q;
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
  logic not_1890_s20_q;
  logic textured_s20_q;
  logic explained_s20_q;
  logic and_1911_s20_q;
  logic and_1916_s20_q;
  logic and_1957_s20_q;
  logic and_1958_s20_q;
  logic [1:0] sum_1962_s20_q;
  logic or_1974_s20_q;
  logic or_1977_s20_q;
  logic or_1980_s20_q;
  logic and_1991_s20_q;
  logic [2:0] sum_1997_s20_q;
  logic and_2007_s20_q;
  logic [2:0] sum_2013_s20_q;
  logic and_2030_s20_q;
  logic equal_2170_s20_q;
  logic equal_2294_s20_q;
  logic and_2414_s20_q;
  logic not_2433_s20_q;
  logic and_2434_s20_q;
  logic [2:0] sum_2440_s20_q;
  logic and_2476_s20_q;
  logic and_2483_s20_q;
  logic [7:0] select_2534_s20_q;
  logic and_2762_s20_q;
  logic [4:0] select_3298_s20_q;
  logic equal_3316_s20_q;
  logic and_3319_s20_q;
  logic [14:0] select_3351_s20_q;
  logic equal_3673_s20_q;
  logic equal_3694_s20_q;
  logic equal_3695_s20_q;
  logic [7:0] select_3710_s20_q;
  logic equal_3824_s20_q;
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
      select_471_s20_q <= select_471_s19_q;
      select_474_s20_q <= select_474_s19_q;
      select_478_s20_q <= select_478_s19_q;
      and_484_s20_q <= and_484_s19_q;
      and_485_s20_q <= and_485_s19_q;
      sum_492_s20_q <= sum_492;
      sum_496_s20_q <= sum_496;
      and_500_s20_q <= whole & (averager_memory_rdata_s19_q[28] | equal_490_s19_q);
      and_504_s20_q <= and_504;
      column_s20_q <= column_s19_q;
      and_508_s20_q <= and_508_s19_q;
      and_510_s20_q <= and_510_s19_q;
      equal_513_s20_q <= select_471_s19_q == 4'h3;
      so_s20_q <= so_s19_q;
      equal_571_s20_q <= equal_571_s19_q;
      equal_1479_s20_q <= equal_1479_s19_q;
      not_1480_s20_q <= not_1480_s19_q;
      shift_2_s20_q <= {shift_2_s19_q[3], shift_2_s19_q[0]};
      equal_1524_s20_q <= equal_1524_s19_q;
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
      or_1882_s20_q <= or_1882_s19_q;
      or_1885_s20_q <= or_1885_s19_q;
      or_1888_s20_q <= or_1888_s19_q;
      not_1890_s20_q <= not_1890;
      textured_s20_q <= textured_s19_q;
      explained_s20_q <= explained;
      and_1911_s20_q <= and_1911_s19_q;
      and_1916_s20_q <= not_1480_s19_q & and_1897_s19_q;
      and_1957_s20_q <= and_1957_s19_q;
      and_1958_s20_q <= seen_columns_rdata_s19_q[9] & shift_2_s19_q[0];
      sum_1962_s20_q <= sum_1962;
      or_1974_s20_q <= or_1974_s19_q;
      or_1977_s20_q <= or_1977_s19_q;
      or_1980_s20_q <= or_1980_s19_q;
      and_1991_s20_q <= and_1991_s19_q;
      sum_1997_s20_q <= {2'h0, and_1992} + {1'b0, sum_1996};
      and_2007_s20_q <= and_2007_s19_q;
      sum_2013_s20_q <= {2'h0, and_2008} + {1'b0, sum_2012};
      and_2030_s20_q <= and_2030_s19_q;
      equal_2170_s20_q <= equal_2170_s19_q;
      equal_2294_s20_q <= equal_2294_s19_q;
      and_2414_s20_q <= not_1480_s19_q & and_2413;
      not_2433_s20_q <= not_2433;
      and_2434_s20_q <= and_2434_s19_q;
      sum_2440_s20_q <= {2'h0, and_2435} + {1'b0, sum_2439};
      and_2476_s20_q <= not_1480_s19_q & (so_s19_q & and_2474);
      and_2483_s20_q <= not_1480_s19_q & (so_s19_q & (ends_cell_s19_q & and_2480));
      select_2534_s20_q <= select_2534;
      and_2762_s20_q <= and_2762_s19_q;
      select_3298_s20_q <= select_3298;
      equal_3316_s20_q <= equal_3316_s19_q;
      and_3319_s20_q <= and_3319;
      select_3351_s20_q <= select_3351;
      equal_3673_s20_q <= equal_3673;
      equal_3694_s20_q <= x_s19_q[6:3] == 4'h9;
      equal_3695_s20_q <= equal_3695;
      select_3710_s20_q <= select_3710;
      equal_3824_s20_q <= equal_3824_s19_q;
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
  assign grey = and_484_s20_q ? sum_492_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_513_s20_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_484_s20_q ? sum_496_s20_q[13:5] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_513_s20_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:206
  logic and_521;
  assign and_521 = and_484_s20_q & and_500_s20_q;
  // hls/stages/census.hpp:126
  logic select_523;
  assign select_523 = equal_513_s20_q ? and_521 : (averager_mask_q & and_521);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s20_q & select_523;
  // hls/stages/census.hpp:206
  logic and_525;
  assign and_525 = and_484_s20_q & and_504_s20_q;
  // hls/stages/census.hpp:126
  logic select_527;
  assign select_527 = equal_513_s20_q ? and_525 : (averager_of_skin_q & and_525);
  // hls/stages/agreement.hpp:442
  logic equal_568;
  assign equal_568 = column_s20_q == 7'h0;
  logic [3:0] select_572;
  assign select_572 = equal_571_s20_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_573;
  assign select_573 = equal_568 ? {select_572, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_574;
  assign select_574 = equal_568 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s20_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1527;
  assign select_1527 = x_s20_q[4] ? {x_s20_q[3], x_s20_q[0]} : {x_s20_q[0], x_s20_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1529;
  assign select_1529 = equal_1524_s20_q ? {2'h0, quarter} : (all_s20_q ? {1'b0, x_s20_q[2:0]} : {x_s20_q[2:1], select_1527});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1530;
  assign sum_1530 = slot_s20_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:330
  logic [3:0] select_1531;
  assign select_1531 = equal_1479_s20_q ? select_1529 : {sum_1530, lower_half_s20_q, registration_of_right_q};
  // hls/stages/patches.hpp:201
  logic equal_1532;
  assign equal_1532 = x_s20_q[5:0] == 6'h3f;
  logic equal_1534;
  assign equal_1534 = x_s20_q[5:0] == 6'h3e;
  logic equal_1536;
  assign equal_1536 = x_s20_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1116
  logic and_1554;
  assign and_1554 = (~equal_1532) & ((~equal_1534) & ((~equal_1536) & and_1551_s20_q));
  // hls/stages/agreement.hpp:1071
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
  // hls/stages/patches.hpp:363
  logic [1:0] select_1606;
  assign select_1606 = and_1605_s20_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1607;
  assign select_1607 = and_1605_s20_q ? patches_band_rows_number_s20_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1608;
  assign select_1608 = and_1592_s20_q ? {select_1607, select_1606[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:118
  logic [1:0] select_1609;
  assign select_1609 = and_1592_s20_q ? select_1606 : patches_fetch_q;
  logic equal_1610;
  assign equal_1610 = select_1609 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1620_s20_q ? {sum_1631_s20_q, sum_1627_s20_q} : registration_expected_q;
  // hls/stages/patches.hpp:118
  logic [4:0] select_1713;
  assign select_1713 = and_1592_s20_q ? select_1607 : patches_band_q;
  // hls/stages/patches.hpp:343
  logic equal_1714;
  assign equal_1714 = {patches_choosing_band_s20_q, and_1618_s20_q} == {select_1713, select_1609[1]};
  // hls/stages/patches.hpp:486
  logic less_1791;
  assign less_1791 = 5'he < patches_along_s20_q;
  // hls/stages/patches.hpp:487
  logic or_1792;
  assign or_1792 = equal_1704_s20_q | less_1791;
  // hls/stages/patches.hpp:490
  logic new_row;
  assign new_row = patches_along_s20_q == 5'h0;
  logic select_1797;
  assign select_1797 = equal_1704_s20_q ? patches_column_s20_q[0] : (or_1792 ? (patches_along_s20_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:488
  logic [4:0] select_1800;
  assign select_1800 = patches_match_row_ends_s20_q ? patches_down_by_s20_q : sum_1799_s20_q;
  // hls/stages/patches.hpp:491
  logic [4:0] select_1803;
  assign select_1803 = equal_1704_s20_q ? 5'h0 : (or_1792 ? (select_1800 + 5'h1) : sum_1799_s20_q);
  // hls/stages/patches.hpp:467
  logic equal_1806;
  assign equal_1806 = patches_column_s20_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s20_q == 5'h11;
  logic equal_1808;
  assign equal_1808 = patches_column_s20_q == 5'h18;
  // hls/stages/patches.hpp:469
  logic and_1810;
  assign and_1810 = of_row & (~equal_1808);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1806 ? 2'h3 : {equal_1808, and_1810};
  // hls/stages/patches.hpp:455
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1813_s20_q, pixel_2_s20_q[0]} - {1'b0, sum_1814_s20_q, patches_columns_above_rdata_s20_q[8]};
  // hls/stages/patches.hpp:453
  logic [9:0] sum_1826;
  assign sum_1826 = {2'h0, patches_columns_above_rdata_s20_q[7:0]} + sum_1825_s20_q[10:1];
  // hls/stages/patches.hpp:468
  logic or_1836;
  assign or_1836 = (((patches_column_s20_q == 5'ha) | of_row) | equal_1808) | equal_1806;
  // hls/stages/patches.hpp:463
  logic and_1841;
  assign and_1841 = (~(patches_code_row_s20_q[4:2] == 3'h0)) & (~(patches_column_s20_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:164
  logic and_1855;
  assign and_1855 = (~(equal_1705_s20_q | (~and_1841))) & (~patches_column_s20_q[4]);
  // hls/stages/agreement.hpp:1029
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1957_s20_q} + ({2'h0, and_1958_s20_q} + {1'b0, sum_1962_s20_q});
  // hls/stages/agreement.hpp:1031
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1991_s20_q} + sum_1997_s20_q;
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1999;
  assign select_1999 = age_s20_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1032
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2007_s20_q} + sum_2013_s20_q;
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_2015;
  assign select_2015 = age_s20_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2062;
  assign select_2062 = sample_pair_whole_s20_q ? (and_508_s20_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2064;
  assign select_2064 = sample_pair_whole_s20_q ? (and_508_s20_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2085;
  assign select_2085 = sample_pair_whole_s20_q ? (and_508_s20_q ? select_523 : averager_mask_q) : averager_mask_q;
  logic select_2087;
  assign select_2087 = sample_pair_whole_s20_q ? (and_508_s20_q ? select_527 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic and_2410;
  assign and_2410 = and_510_s20_q & (equal_571_s20_q & equal_2294_s20_q);
  // hls/stages/patches.hpp:330
  logic and_2419;
  assign and_2419 = not_1480_s20_q & (so_s20_q & (ends_cell_s20_q & textured_s20_q));
  // hls/stages/agreement.hpp:1030
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2434_s20_q} + sum_2440_s20_q;
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2442;
  assign select_2442 = age_s20_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2478;
  assign select_2478 = and_2410 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2476_s20_q});
  logic [13:0] select_2485;
  assign select_2485 = and_2410 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2483_s20_q});
  // hls/stages/patches.hpp:330
  logic [10:0] select_2521;
  assign select_2521 = equal_1479_s20_q ? registration_expected_q : (so_s20_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2522;
  assign equal_2522 = slot_s20_q == 3'h4;
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2534_s20_q[7]}}, select_2534_s20_q} - {sum_1631_s20_q[9], sum_1631_s20_q, sum_1627_s20_q};
  // hls/stages/patches.hpp:330
  logic select_2581;
  assign select_2581 = so_s20_q ? (equal_2522 ? right_2_s20_q : registration_of_right_q) : registration_of_right_q;
  logic select_2584;
  assign select_2584 = so_s20_q ? (equal_1620_s20_q ? shift_2_s20_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all_s20_q ? x_s20_q[1:0] : select_1527;
  // hls/stages/patches.hpp:344
  logic not_2778;
  assign not_2778 = ~select_1609[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2780;
  assign select_2780 = sample_pair_whole_s20_q ? (equal_1610 ? select_1609 : {not_2778, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:176
  logic [4:0] select_3275;
  assign select_3275 = equal_1702_s20_q ? patches_down_by_s20_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:526
  logic [4:0] select_3320;
  assign select_3320 = and_3319_s20_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:533
  logic [5:0] away;
  assign away = {1'b0, patches_step_s20_q} - {1'b0, select_3320};
  // hls/stages/agreement.hpp:1154
  logic equal_3472;
  assign equal_3472 = x_s20_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1148
  logic equal_3692;
  assign equal_3692 = x_s20_q[6:3] == 4'ha;
  // hls/stages/agreement.hpp:1067
  logic [7:0] limit;
  assign limit = equal_3692 ? cfg_regions_limit_i : (equal_3694_s20_q ? cfg_hidden_limit_i : select_3710_s20_q);
  // hls/stages/agreement.hpp:1161
  logic not_3713;
  assign not_3713 = ~x_s20_q[2];
  logic [3:0] select_3714;
  assign select_3714 = x_s20_q[1] ? {x_s20_q[2], 1'b0, not_3713, 1'b0} : {1'b0, x_s20_q[2], 1'b0, not_3713};
  logic [7:0] select_3715;
  assign select_3715 = x_s20_q[0] ? {select_3714[3], 1'b0, select_3714[2], 1'b0, select_3714[1], 1'b0, select_3714[0], 1'b0} : {1'b0, select_3714[3], 1'b0, select_3714[2], 1'b0, select_3714[1], 1'b0, select_3714[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3719;
  assign select_3719 = equal_3694_s20_q ? counts_skin_supervised_q : (equal_3695_s20_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3692 ? counts_textured_q : select_3719;
  // hls/stages/patches.hpp:330
  logic [2:0] select_3758;
  assign select_3758 = so_s20_q ? (ends_cell_s20_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3759;
  assign select_3759 = equal_1479_s20_q ? box_explained_columns_values_0_q : select_3758;
  logic [2:0] select_3760;
  assign select_3760 = ends_cell_s20_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3762;
  assign select_3762 = equal_1479_s20_q ? box_explained_columns_values_1_q : (so_s20_q ? select_3760 : box_explained_columns_values_1_q);
  logic [2:0] select_3763;
  assign select_3763 = ends_cell_s20_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3765;
  assign select_3765 = equal_1479_s20_q ? box_explained_columns_values_2_q : (so_s20_q ? select_3763 : box_explained_columns_values_2_q);
  logic [2:0] select_3766;
  assign select_3766 = ends_cell_s20_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3768;
  assign select_3768 = equal_1479_s20_q ? box_explained_columns_values_3_q : (so_s20_q ? select_3766 : box_explained_columns_values_3_q);
  logic [2:0] select_3769;
  assign select_3769 = ends_cell_s20_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3771;
  assign select_3771 = equal_1479_s20_q ? box_explained_columns_values_4_q : (so_s20_q ? select_3769 : box_explained_columns_values_4_q);
  logic [2:0] select_3776;
  assign select_3776 = so_s20_q ? (ends_cell_s20_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3778;
  assign select_3778 = ends_cell_s20_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3780;
  assign select_3780 = equal_1479_s20_q ? box_shown_columns_values_1_q : (so_s20_q ? select_3778 : box_shown_columns_values_1_q);
  logic [2:0] select_3781;
  assign select_3781 = ends_cell_s20_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3783;
  assign select_3783 = equal_1479_s20_q ? box_shown_columns_values_2_q : (so_s20_q ? select_3781 : box_shown_columns_values_2_q);
  logic [2:0] select_3784;
  assign select_3784 = ends_cell_s20_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3786;
  assign select_3786 = equal_1479_s20_q ? box_shown_columns_values_3_q : (so_s20_q ? select_3784 : box_shown_columns_values_3_q);
  logic [2:0] select_3787;
  assign select_3787 = ends_cell_s20_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3789;
  assign select_3789 = equal_1479_s20_q ? box_shown_columns_values_4_q : (so_s20_q ? select_3787 : box_shown_columns_values_4_q);
  logic [2:0] select_3794;
  assign select_3794 = so_s20_q ? (ends_cell_s20_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3796;
  assign select_3796 = ends_cell_s20_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3798;
  assign select_3798 = equal_1479_s20_q ? box_nearer_columns_values_1_q : (so_s20_q ? select_3796 : box_nearer_columns_values_1_q);
  logic [2:0] select_3799;
  assign select_3799 = ends_cell_s20_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3801;
  assign select_3801 = equal_1479_s20_q ? box_nearer_columns_values_2_q : (so_s20_q ? select_3799 : box_nearer_columns_values_2_q);
  logic [2:0] select_3802;
  assign select_3802 = ends_cell_s20_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3804;
  assign select_3804 = equal_1479_s20_q ? box_nearer_columns_values_3_q : (so_s20_q ? select_3802 : box_nearer_columns_values_3_q);
  logic [2:0] select_3805;
  assign select_3805 = ends_cell_s20_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3807;
  assign select_3807 = equal_1479_s20_q ? box_nearer_columns_values_4_q : (so_s20_q ? select_3805 : box_nearer_columns_values_4_q);

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_478_s20_q;
  logic averager_memory_we;
  assign averager_memory_we = s20_en & and_485_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_504_s20_q, and_500_s20_q, sum_496_s20_q, sum_492_s20_q};
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
      averager_mask_q <= select_2085;
      averager_of_skin_q <= select_2087;
      census_filled_q <= and_510_s20_q ? {select_574[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_510_s20_q ? select_573 : rows_passed_above_q;
      counts_textured_q <= and_2410 ? 14'h0 : (counts_textured_q + {13'h0, and_2419});
      counts_skin_supervised_q <= select_2478;
      counts_skin_textured_q <= select_2485;
      registration_expected_q <= select_2521;
      registration_of_right_q <= equal_1479_s20_q ? registration_of_right_q : select_2581;
      registration_was_inside_q <= equal_1479_s20_q ? registration_was_inside_q : select_2584;
      patches_band_q <= sample_pair_whole_s20_q ? select_1713 : patches_band_q;
      patches_fetch_q <= select_2780;
      patches_summed_down_by_q <= equal_1700_s20_q ? patches_summed_down_by_q : select_3275;
      patches_read_at_q <= equal_1700_s20_q ? select_3298_s20_q : patches_read_at_q;
      patches_peak_row_q <= equal_1700_s20_q ? select_3320 : patches_peak_row_q;
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
      averager_total_0_q <= select_2062;
      averager_total_1_q <= select_2064;
      box_explained_columns_values_0_q <= select_3759;
      box_explained_columns_values_1_q <= select_3762;
      box_explained_columns_values_2_q <= select_3765;
      box_explained_columns_values_3_q <= select_3768;
      box_explained_columns_values_4_q <= select_3771;
      box_shown_columns_values_0_q <= equal_1479_s20_q ? box_shown_columns_values_0_q : select_3776;
      box_shown_columns_values_1_q <= select_3780;
      box_shown_columns_values_2_q <= select_3783;
      box_shown_columns_values_3_q <= select_3786;
      box_shown_columns_values_4_q <= select_3789;
      box_nearer_columns_values_0_q <= equal_1479_s20_q ? box_nearer_columns_values_0_q : select_3794;
      box_nearer_columns_values_1_q <= select_3798;
      box_nearer_columns_values_2_q <= select_3801;
      box_nearer_columns_values_3_q <= select_3804;
      box_nearer_columns_values_4_q <= select_3807;
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
  logic [3:0] select_471_s21_q;
  logic [6:0] select_474_s21_q;
  logic [6:0] column_s21_q;
  logic and_508_s21_q;
  logic and_510_s21_q;
  logic [77:0] census_memory_rdata_s21_q;
  logic [8:0] grey_s21_q;
  logic equal_513_s21_q;
  logic [8:0] select_516_s21_q;
  logic [8:0] grey_2_s21_q;
  logic [8:0] select_520_s21_q;
  logic whole_2_s21_q;
  logic and_528_s21_q;
  logic so_s21_q;
  logic and_575_s21_q;
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
  logic [29:0] regions_rdata_s21_q;
  logic textured_s21_q;
  logic explained_s21_q;
  logic and_1911_s21_q;
  logic and_1916_s21_q;
  logic [2:0] textured_2_s21_q;
  logic or_1974_s21_q;
  logic or_1977_s21_q;
  logic or_1980_s21_q;
  logic [3:0] difference_2000_s21_q;
  logic [3:0] difference_2016_s21_q;
  logic and_2030_s21_q;
  logic equal_2170_s21_q;
  logic equal_2294_s21_q;
  logic and_2410_s21_q;
  logic and_2414_s21_q;
  logic and_2419_s21_q;
  logic not_2433_s21_q;
  logic [3:0] difference_2443_s21_q;
  logic and_2525_s21_q;
  logic [11:0] select_2537_s21_q;
  logic equal_2586_s21_q;
  logic [3:0] not_2587_s21_q;
  logic [1:0] quarter_2_s21_q;
  logic and_2762_s21_q;
  logic less_2889_s21_q;
  logic equal_3316_s21_q;
  logic [4:0] select_3320_s21_q;
  logic [5:0] away_s21_q;
  logic equal_3322_s21_q;
  logic equal_3331_s21_q;
  logic [14:0] select_3351_s21_q;
  logic equal_3472_s21_q;
  logic and_3674_s21_q;
  logic equal_3692_s21_q;
  logic equal_3694_s21_q;
  logic equal_3695_s21_q;
  logic equal_3717_s21_q;
  logic [13:0] of_s21_q;
  logic equal_3824_s21_q;
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
      select_471_s21_q <= select_471_s20_q;
      select_474_s21_q <= select_474_s20_q;
      column_s21_q <= column_s20_q;
      and_508_s21_q <= and_508_s20_q;
      and_510_s21_q <= and_510_s20_q;
      census_memory_rdata_s21_q <= census_memory_rdata_q;
      grey_s21_q <= grey;
      equal_513_s21_q <= equal_513_s20_q;
      select_516_s21_q <= sample_pair_whole_s20_q ? total[10:2] : 9'h0;
      grey_2_s21_q <= grey_2;
      select_520_s21_q <= sample_pair_whole_s20_q ? total_2[10:2] : 9'h0;
      whole_2_s21_q <= whole_2;
      and_528_s21_q <= sample_pair_whole_s20_q & select_527;
      so_s21_q <= so_s20_q;
      and_575_s21_q <= select_573[4] & select_574[3];
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
      not_1890_s21_q <= not_1890_s20_q;
      regions_rdata_s21_q <= regions_rdata_q;
      textured_s21_q <= textured_s20_q;
      explained_s21_q <= explained_s20_q;
      and_1911_s21_q <= and_1911_s20_q;
      and_1916_s21_q <= and_1916_s20_q;
      textured_2_s21_q <= textured_2;
      or_1974_s21_q <= or_1974_s20_q;
      or_1977_s21_q <= or_1977_s20_q;
      or_1980_s21_q <= or_1980_s20_q;
      difference_2000_s21_q <= {1'b0, shown_2} - {1'b0, select_1999};
      difference_2016_s21_q <= {1'b0, near_2} - {1'b0, select_2015};
      and_2030_s21_q <= and_2030_s20_q;
      equal_2170_s21_q <= equal_2170_s20_q;
      equal_2294_s21_q <= equal_2294_s20_q;
      and_2410_s21_q <= and_2410;
      and_2414_s21_q <= and_2414_s20_q;
      and_2419_s21_q <= and_2419;
      not_2433_s21_q <= not_2433_s20_q;
      difference_2443_s21_q <= {1'b0, explained_2} - {1'b0, select_2442};
      and_2525_s21_q <= not_1480_s20_q & (so_s20_q & (half_ends & equal_2522));
      select_2537_s21_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      equal_2586_s21_q <= sum_1530 == 2'h2;
      not_2587_s21_q <= ~select_1577;
      quarter_2_s21_q <= quarter_2;
      and_2762_s21_q <= and_2762_s20_q;
      less_2889_s21_q <= 4'he < patches_column_s20_q[4:1];
      equal_3316_s21_q <= equal_3316_s20_q;
      select_3320_s21_q <= select_3320;
      away_s21_q <= away;
      equal_3322_s21_q <= away == 6'h3f;
      equal_3331_s21_q <= away == 6'h1;
      select_3351_s21_q <= select_3351_s20_q;
      equal_3472_s21_q <= equal_3472;
      and_3674_s21_q <= equal_3673_s20_q & equal_3472;
      equal_3692_s21_q <= equal_3692;
      equal_3694_s21_q <= equal_3694_s20_q;
      equal_3695_s21_q <= equal_3695_s20_q;
      equal_3717_s21_q <= (limit & select_3715) == 8'h0;
      of_s21_q <= of;
      equal_3824_s21_q <= equal_3824_s20_q;
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
  logic less_544;
  assign less_544 = census_memory_rdata_s21_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_545;
  assign less_545 = census_memory_rdata_s21_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_546;
  assign less_546 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_547;
  assign less_547 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_548;
  assign less_548 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_549;
  assign less_549 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_550;
  assign less_550 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_551;
  assign less_551 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_552;
  assign less_552 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_553;
  assign less_553 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_554;
  assign less_554 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_555;
  assign less_555 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_556;
  assign less_556 = census_memory_rdata_s21_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_557;
  assign less_557 = census_memory_rdata_s21_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_558;
  assign less_558 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_559;
  assign less_559 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_560;
  assign less_560 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_561;
  assign less_561 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_562;
  assign less_562 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_563;
  assign less_563 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_564;
  assign less_564 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_565;
  assign less_565 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_566;
  assign less_566 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_567;
  assign less_567 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:286
  logic and_577;
  assign and_577 = census_memory_rdata_s21_q[38] & (census_memory_rdata_s21_q[18] & whole_2_s21_q);
  logic and_579;
  assign and_579 = census_memory_rdata_s21_q[77] & (census_memory_rdata_s21_q[58] & and_577);
  // hls/stages/census.hpp:270
  logic [9:0] difference_602;
  assign difference_602 = {1'b0, select_516_s21_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_605;
  assign difference_605 = {1'b0, census_memory_rdata_s21_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_609;
  assign difference_609 = {1'b0, census_memory_rdata_s21_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_613;
  assign difference_613 = {1'b0, census_memory_rdata_s21_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_617;
  assign difference_617 = {1'b0, census_memory_rdata_s21_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/patches.hpp:330
  logic and_1573;
  assign and_1573 = so_s21_q & and_1572_s21_q;
  // hls/stages/patches.hpp:90
  logic less_1634;
  assign less_1634 = {{4{sum_1633_s21_q[10]}}, sum_1633_s21_q, expected_s21_q} < 16'h15;
  // hls/stages/patches.hpp:103
  logic and_1652;
  assign and_1652 = (less_1619_s21_q & (shift_2_s21_q[1] & less_1634)) & and_1651_s21_q;
  // hls/stages/patches.hpp:457
  logic [11:0] sum_1816;
  assign sum_1816 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1817;
  assign sum_1817 = {{4{down_2_s21_q[10]}}, down_2_s21_q[10:2]} + {sum_1816[11], sum_1816};
  // hls/stages/patches.hpp:454
  logic [11:0] smooth;
  assign smooth = {sum_1826_s21_q, sum_1825_s21_q, patches_columns_above_rdata_s21_q} + {4'h0, pixel_2_s21_q};
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1901;
  assign select_1901 = segment_started_s21_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1902;
  assign sum_1902 = {6'h0, textured_s21_q} + select_1901;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1904;
  assign sum_1904 = {3'h0, sum_1902} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1906;
  assign select_1906 = segment_started_s21_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_1907;
  assign sum_1907 = {6'h0, explained_s21_q} + select_1906;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1909;
  assign sum_1909 = {3'h0, sum_1907} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_1912;
  assign select_1912 = segment_started_s21_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_1913;
  assign sum_1913 = {6'h0, and_1911_s21_q} + select_1912;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_1915;
  assign sum_1915 = {3'h0, sum_1913} + (region_fresh_s21_q ? 10'h0 : regions_rdata_s21_q[29:20]);
  // hls/stages/agreement.hpp:1202
  logic or_1925;
  assign or_1925 = marks_first_s21_q | line_ended_q;
  // hls/stages/agreement.hpp:1204
  logic [12:0] select_1927;
  assign select_1927 = marks_first_s21_q ? 13'h1 : (or_1925 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1203
  logic [8:0] select_1929;
  assign select_1929 = or_1925 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1211
  logic select_1931;
  assign select_1931 = cfg_compete_i ? (or_1925 & select_1927[12]) : (select_1929[8] & select_1927[9]);
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_1965;
  assign select_1965 = age_s21_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1038
  logic [4:0] around;
  assign around = {difference_2000_s21_q[3], difference_2000_s21_q} + (equal_1641_s21_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1039
  logic [4:0] n;
  assign n = {difference_2016_s21_q[3], difference_2016_s21_q} + (equal_1641_s21_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2054;
  assign select_2054 = sample_pair_whole_s21_q ? (and_508_s21_q ? grey_s21_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2056;
  assign select_2056 = sample_pair_whole_s21_q ? (and_508_s21_q ? grey_2_s21_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2058;
  assign select_2058 = sample_pair_whole_s21_q ? (and_508_s21_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2060;
  assign select_2060 = sample_pair_whole_s21_q ? (and_508_s21_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2065;
  assign sum_2065 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s21_q};
  logic [9:0] sum_2073;
  assign sum_2073 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s21_q};
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2088;
  assign select_2088 = and_510_s21_q ? select_516_s21_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2089;
  assign select_2089 = and_510_s21_q ? select_520_s21_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2091;
  assign select_2091 = and_510_s21_q ? census_memory_rdata_s21_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2092;
  assign select_2092 = and_510_s21_q ? census_memory_rdata_s21_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2093;
  assign select_2093 = and_510_s21_q ? census_memory_rdata_s21_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2094;
  assign select_2094 = and_510_s21_q ? census_memory_rdata_s21_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2095;
  assign select_2095 = and_510_s21_q ? census_memory_rdata_s21_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2096;
  assign select_2096 = and_510_s21_q ? census_memory_rdata_s21_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2097;
  assign select_2097 = and_510_s21_q ? census_memory_rdata_s21_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2098;
  assign select_2098 = and_510_s21_q ? census_memory_rdata_s21_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2099;
  assign select_2099 = and_510_s21_q ? census_memory_rdata_s21_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2100;
  assign select_2100 = and_510_s21_q ? census_memory_rdata_s21_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2101;
  assign select_2101 = and_510_s21_q ? census_memory_rdata_s21_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2102;
  assign select_2102 = and_510_s21_q ? census_memory_rdata_s21_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2103;
  assign select_2103 = and_510_s21_q ? census_memory_rdata_s21_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2104;
  assign select_2104 = and_510_s21_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2105;
  assign select_2105 = and_510_s21_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2107;
  assign select_2107 = and_510_s21_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2108;
  assign select_2108 = and_510_s21_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2110;
  assign select_2110 = and_510_s21_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2111;
  assign select_2111 = and_510_s21_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2113;
  assign select_2113 = and_510_s21_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2114;
  assign select_2114 = and_510_s21_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2115;
  assign select_2115 = and_510_s21_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2117;
  assign select_2117 = and_510_s21_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2118;
  assign select_2118 = and_510_s21_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2120;
  assign select_2120 = and_510_s21_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2121;
  assign select_2121 = and_510_s21_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2123;
  assign select_2123 = and_510_s21_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2124;
  assign select_2124 = and_510_s21_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2126;
  assign select_2126 = and_510_s21_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2127;
  assign select_2127 = and_510_s21_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2129;
  assign select_2129 = and_510_s21_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2130;
  assign select_2130 = and_510_s21_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2132;
  assign select_2132 = and_510_s21_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2133;
  assign select_2133 = and_510_s21_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2136;
  assign select_2136 = and_510_s21_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2137;
  assign select_2137 = and_510_s21_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2140;
  assign select_2140 = and_510_s21_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2141;
  assign select_2141 = and_510_s21_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2145;
  assign difference_2145 = {1'b0, select_520_s21_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2148;
  assign difference_2148 = {1'b0, census_memory_rdata_s21_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2152;
  assign difference_2152 = {1'b0, census_memory_rdata_s21_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2156;
  assign difference_2156 = {1'b0, census_memory_rdata_s21_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2160;
  assign difference_2160 = {1'b0, census_memory_rdata_s21_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2191;
  assign difference_2191 = {1'b0, select_516_s21_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2203;
  assign difference_2203 = {1'b0, select_520_s21_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/patches.hpp:330
  logic and_2424;
  assign and_2424 = not_1480_s21_q & (so_s21_q & (ends_cell_s21_q & explained_s21_q));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2426;
  assign select_2426 = and_2410_s21_q ? 14'h0 : (counts_explained_q + {13'h0, and_2424});
  // hls/stages/patches.hpp:330
  logic and_2429;
  assign and_2429 = not_1480_s21_q & (so_s21_q & (ends_cell_s21_q & and_1911_s21_q));
  // hls/stages/agreement.hpp:1037
  logic [4:0] e;
  assign e = {difference_2443_s21_q[3], difference_2443_s21_q} + (equal_1641_s21_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1074
  logic less_2458;
  assign less_2458 = region_row_s21_q < x_s21_q[5:3];
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2537_s21_q[11:7])) ? 12'h7f : select_2537_s21_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2589;
  assign select_2589 = equal_2586_s21_q ? (registration_fresh_q & not_2587_s21_q) : registration_fresh_q;
  // hls/stages/patches.hpp:330
  logic [3:0] select_2591;
  assign select_2591 = so_s21_q ? (and_1572_s21_q ? select_2589 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2593;
  assign select_2593 = and_2410_s21_q ? 4'hf : (equal_1479_s21_q ? registration_fresh_q : select_2591);
  // hls/stages/registration.hpp:258
  logic not_2614;
  assign not_2614 = ~quarter_2_s21_q[1];
  logic [3:0] select_2615;
  assign select_2615 = quarter_2_s21_q[0] ? {quarter_2_s21_q[1], 1'b0, not_2614, 1'b0} : {1'b0, quarter_2_s21_q[1], 1'b0, not_2614};
  // hls/stages/patches.hpp:176
  logic [10:0] select_2867;
  assign select_2867 = equal_1702_s21_q ? patches_down_values_0_q : (or_1706_s21_q ? down_2_s21_q : patches_down_values_0_q);
  logic [10:0] select_2869;
  assign select_2869 = or_1706_s21_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_2871;
  assign select_2871 = equal_1700_s21_q ? patches_down_values_1_q : (equal_1702_s21_q ? patches_down_values_1_q : select_2869);
  // hls/stages/patches.hpp:542
  logic and_3324;
  assign and_3324 = less_1861_s21_q & (equal_3316_s21_q & equal_3322_s21_q);
  // hls/stages/patches.hpp:546
  logic select_3327;
  assign select_3327 = equal_1864_s21_q ? (less_1861_s21_q ? (not_1865_s21_q & and_3324) : and_3324) : and_3324;
  // hls/stages/patches.hpp:542
  logic and_3333;
  assign and_3333 = less_1861_s21_q & (equal_3316_s21_q & equal_3331_s21_q);
  // hls/stages/patches.hpp:546
  logic select_3336;
  assign select_3336 = equal_1864_s21_q ? (less_1861_s21_q ? (not_1865_s21_q & and_3333) : and_3333) : and_3333;
  // hls/stages/patches.hpp:539
  logic [6:0] sum_3340;
  assign sum_3340 = {away_s21_q[5], away_s21_q} + 7'h7d;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3706;
  assign select_3706 = equal_3472_s21_q ? 14'h0 : product_q;
  logic [13:0] select_3721;
  assign select_3721 = equal_3717_s21_q ? 14'h0 : of_s21_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3706} + {1'b0, select_3721};
  // hls/stages/patches.hpp:330
  logic [2:0] select_3739;
  assign select_3739 = ends_cell_s21_q ? textured_2_s21_q : box_textured_columns_values_0_q;
  logic [2:0] select_3741;
  assign select_3741 = equal_1479_s21_q ? box_textured_columns_values_0_q : (so_s21_q ? select_3739 : box_textured_columns_values_0_q);
  logic [2:0] select_3742;
  assign select_3742 = ends_cell_s21_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3744;
  assign select_3744 = equal_1479_s21_q ? box_textured_columns_values_1_q : (so_s21_q ? select_3742 : box_textured_columns_values_1_q);
  logic [2:0] select_3745;
  assign select_3745 = ends_cell_s21_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3747;
  assign select_3747 = equal_1479_s21_q ? box_textured_columns_values_2_q : (so_s21_q ? select_3745 : box_textured_columns_values_2_q);
  logic [2:0] select_3748;
  assign select_3748 = ends_cell_s21_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3750;
  assign select_3750 = equal_1479_s21_q ? box_textured_columns_values_3_q : (so_s21_q ? select_3748 : box_textured_columns_values_3_q);
  logic [2:0] select_3751;
  assign select_3751 = ends_cell_s21_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3753;
  assign select_3753 = equal_1479_s21_q ? box_textured_columns_values_4_q : (so_s21_q ? select_3751 : box_textured_columns_values_4_q);
  logic [4:0] select_3773;
  assign select_3773 = so_s21_q ? (ends_cell_s21_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3774;
  assign select_3774 = equal_1479_s21_q ? box_explained_sum_sums_values_0_q : select_3773;
  logic [4:0] select_3791;
  assign select_3791 = so_s21_q ? (ends_cell_s21_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_3809;
  assign select_3809 = so_s21_q ? (ends_cell_s21_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/registration.hpp:258
  logic not_3910;
  assign not_3910 = ~quarter_s21_q[1];
  logic [3:0] select_3911;
  assign select_3911 = quarter_s21_q[0] ? {quarter_s21_q[1], 1'b0, not_3910, 1'b0} : {1'b0, quarter_s21_q[1], 1'b0, not_3910};

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

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:745; read in stage 21, written in stage 23: 21 < 23 < 21 + DISTANCE.
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

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:774; read in stage 21, written in stage 24: 21 < 24 < 21 + DISTANCE.
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

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:775; read in stage 21, written in stage 24: 21 < 24 < 21 + DISTANCE.
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

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s21_q;
  logic census_memory_we;
  assign census_memory_we = s21_en & and_510_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s21_q[58:40], census_memory_rdata_s21_q[38:0], and_528_s21_q, whole_2_s21_q, select_520_s21_q, select_516_s21_q};
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
      counts_explained_q <= select_2426;
      registration_fresh_q <= select_2593;
      patches_down_values_0_q <= equal_1700_s21_q ? patches_down_values_0_q : select_2867;
      patches_down_values_1_q <= select_2871;
      segment_textured_q <= select_1901 + {6'h0, and_2419_s21_q};
      segment_explained_q <= select_1906 + {6'h0, and_2424};
      segment_nearer_q <= select_1912 + {6'h0, and_2429};
      product_q <= equal_1479_s21_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_1927;
      columns_passed_q <= {select_1929[7:0], or_1925};
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
      sharpness_last_mean_0_q <= and_510_s21_q ? select_516_s21_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_510_s21_q ? select_520_s21_q : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= select_3741;
      box_textured_columns_values_1_q <= select_3744;
      box_textured_columns_values_2_q <= select_3747;
      box_textured_columns_values_3_q <= select_3750;
      box_textured_columns_values_4_q <= select_3753;
      box_explained_sum_sums_values_0_q <= select_3774;
      box_shown_sum_sums_values_0_q <= equal_1479_s21_q ? box_shown_sum_sums_values_0_q : select_3791;
      box_nearer_sum_sums_values_0_q <= equal_1479_s21_q ? box_nearer_sum_sums_values_0_q : select_3809;
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
  logic [3:0] select_471_s22_q;
  logic [6:0] select_474_s22_q;
  logic [6:0] column_s22_q;
  logic and_508_s22_q;
  logic and_510_s22_q;
  logic equal_513_s22_q;
  logic whole_2_s22_q;
  logic so_s22_q;
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
  logic less_561_s22_q;
  logic less_562_s22_q;
  logic less_563_s22_q;
  logic less_564_s22_q;
  logic less_565_s22_q;
  logic less_566_s22_q;
  logic less_567_s22_q;
  logic and_575_s22_q;
  logic and_579_s22_q;
  logic difference_602_s22_q;
  logic [8:0] xor_603_s22_q;
  logic difference_605_s22_q;
  logic [8:0] xor_606_s22_q;
  logic difference_609_s22_q;
  logic [8:0] xor_610_s22_q;
  logic difference_613_s22_q;
  logic [8:0] xor_614_s22_q;
  logic difference_617_s22_q;
  logic [8:0] xor_618_s22_q;
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
  logic [9:0] sum_1904_s22_q;
  logic [9:0] sum_1909_s22_q;
  logic [9:0] sum_1915_s22_q;
  logic and_1916_s22_q;
  logic select_1931_s22_q;
  logic [3:0] difference_1966_s22_q;
  logic or_1974_s22_q;
  logic or_1977_s22_q;
  logic or_1980_s22_q;
  logic [4:0] around_s22_q;
  logic less_2019_s22_q;
  logic and_2030_s22_q;
  logic sum_2065_s22_q;
  logic [9:0] difference_2066_s22_q;
  logic sum_2073_s22_q;
  logic [9:0] difference_2074_s22_q;
  logic difference_2145_s22_q;
  logic [8:0] xor_2146_s22_q;
  logic difference_2148_s22_q;
  logic [8:0] xor_2149_s22_q;
  logic difference_2152_s22_q;
  logic [8:0] xor_2153_s22_q;
  logic difference_2156_s22_q;
  logic [8:0] xor_2157_s22_q;
  logic difference_2160_s22_q;
  logic [8:0] xor_2161_s22_q;
  logic equal_2170_s22_q;
  logic difference_2191_s22_q;
  logic [8:0] xor_2192_s22_q;
  logic difference_2203_s22_q;
  logic [8:0] xor_2204_s22_q;
  logic equal_2294_s22_q;
  logic and_2410_s22_q;
  logic and_2414_s22_q;
  logic and_2429_s22_q;
  logic not_2433_s22_q;
  logic [4:0] e_s22_q;
  logic [9:0] select_2459_s22_q;
  logic [9:0] select_2462_s22_q;
  logic and_2525_s22_q;
  logic and_2526_s22_q;
  logic [11:0] residual_s22_q;
  logic equal_2617_s22_q;
  logic and_2762_s22_q;
  logic less_2889_s22_q;
  logic equal_3232_s22_q;
  logic [4:0] select_3320_s22_q;
  logic select_3327_s22_q;
  logic select_3336_s22_q;
  logic and_3342_s22_q;
  logic [14:0] select_3351_s22_q;
  logic equal_3472_s22_q;
  logic and_3674_s22_q;
  logic less_3675_s22_q;
  logic equal_3676_s22_q;
  logic equal_3692_s22_q;
  logic equal_3694_s22_q;
  logic equal_3695_s22_q;
  logic sum_4_s22_q;
  logic equal_3824_s22_q;
  logic equal_3913_s22_q;
  logic [9:0] select_3923_s22_q;
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
      select_471_s22_q <= select_471_s21_q;
      select_474_s22_q <= select_474_s21_q;
      column_s22_q <= column_s21_q;
      and_508_s22_q <= and_508_s21_q;
      and_510_s22_q <= and_510_s21_q;
      equal_513_s22_q <= equal_513_s21_q;
      whole_2_s22_q <= whole_2_s21_q;
      so_s22_q <= so_s21_q;
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
      less_561_s22_q <= less_561;
      less_562_s22_q <= less_562;
      less_563_s22_q <= less_563;
      less_564_s22_q <= less_564;
      less_565_s22_q <= less_565;
      less_566_s22_q <= less_566;
      less_567_s22_q <= less_567;
      and_575_s22_q <= and_575_s21_q;
      and_579_s22_q <= and_579;
      difference_602_s22_q <= difference_602[9];
      xor_603_s22_q <= difference_602[8:0] ^ {9{difference_602[9]}};
      difference_605_s22_q <= difference_605[9];
      xor_606_s22_q <= difference_605[8:0] ^ {9{difference_605[9]}};
      difference_609_s22_q <= difference_609[9];
      xor_610_s22_q <= difference_609[8:0] ^ {9{difference_609[9]}};
      difference_613_s22_q <= difference_613[9];
      xor_614_s22_q <= difference_613[8:0] ^ {9{difference_613[9]}};
      difference_617_s22_q <= difference_617[9];
      xor_618_s22_q <= difference_617[8:0] ^ {9{difference_617[9]}};
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
      sum_1904_s22_q <= sum_1904;
      sum_1909_s22_q <= sum_1909;
      sum_1915_s22_q <= sum_1915;
      and_1916_s22_q <= and_1916_s21_q;
      select_1931_s22_q <= select_1931;
      difference_1966_s22_q <= {1'b0, textured_2_s21_q} - {1'b0, select_1965};
      or_1974_s22_q <= or_1974_s21_q;
      or_1977_s22_q <= or_1977_s21_q;
      or_1980_s22_q <= or_1980_s21_q;
      around_s22_q <= around;
      less_2019_s22_q <= {1'b0, around[4:1]} < n;
      and_2030_s22_q <= and_2030_s21_q;
      sum_2065_s22_q <= sum_2065[0];
      difference_2066_s22_q <= {1'b0, sum_2065[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2073_s22_q <= sum_2073[0];
      difference_2074_s22_q <= {1'b0, sum_2073[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2145_s22_q <= difference_2145[9];
      xor_2146_s22_q <= difference_2145[8:0] ^ {9{difference_2145[9]}};
      difference_2148_s22_q <= difference_2148[9];
      xor_2149_s22_q <= difference_2148[8:0] ^ {9{difference_2148[9]}};
      difference_2152_s22_q <= difference_2152[9];
      xor_2153_s22_q <= difference_2152[8:0] ^ {9{difference_2152[9]}};
      difference_2156_s22_q <= difference_2156[9];
      xor_2157_s22_q <= difference_2156[8:0] ^ {9{difference_2156[9]}};
      difference_2160_s22_q <= difference_2160[9];
      xor_2161_s22_q <= difference_2160[8:0] ^ {9{difference_2160[9]}};
      equal_2170_s22_q <= equal_2170_s21_q;
      difference_2191_s22_q <= difference_2191[9];
      xor_2192_s22_q <= difference_2191[8:0] ^ {9{difference_2191[9]}};
      difference_2203_s22_q <= difference_2203[9];
      xor_2204_s22_q <= difference_2203[8:0] ^ {9{difference_2203[9]}};
      equal_2294_s22_q <= equal_2294_s21_q;
      and_2410_s22_q <= and_2410_s21_q;
      and_2414_s22_q <= and_2414_s21_q;
      and_2429_s22_q <= and_2429;
      not_2433_s22_q <= not_2433_s21_q;
      e_s22_q <= e;
      select_2459_s22_q <= less_2458 ? 10'h0 : regions_rdata_s21_q[9:0];
      select_2462_s22_q <= less_2458 ? 10'h0 : regions_rdata_s21_q[19:10];
      and_2525_s22_q <= and_2525_s21_q;
      and_2526_s22_q <= shift_2_s21_q[1] & less_1619_s21_q;
      residual_s22_q <= residual;
      equal_2617_s22_q <= (registration_fresh_q & select_2615) == 4'h0;
      and_2762_s22_q <= and_2762_s21_q;
      less_2889_s22_q <= less_2889_s21_q;
      equal_3232_s22_q <= patches_match_row_s21_q == 4'h0;
      select_3320_s22_q <= select_3320_s21_q;
      select_3327_s22_q <= select_3327;
      select_3336_s22_q <= select_3336;
      and_3342_s22_q <= equal_3316_s21_q & ({sum_3340[6], sum_3340} < 8'hfb);
      select_3351_s22_q <= select_3351_s21_q;
      equal_3472_s22_q <= equal_3472_s21_q;
      and_3674_s22_q <= and_3674_s21_q;
      less_3675_s22_q <= counts_explained_q < product_q;
      equal_3676_s22_q <= counts_explained_q == product_q;
      equal_3692_s22_q <= equal_3692_s21_q;
      equal_3694_s22_q <= equal_3694_s21_q;
      equal_3695_s22_q <= equal_3695_s21_q;
      sum_4_s22_q <= sum_4[0];
      equal_3824_s22_q <= equal_3824_s21_q;
      equal_3913_s22_q <= (registration_fresh_q & select_3911) == 4'h0;
      select_3923_s22_q <= less_2458 ? 10'h0 : regions_rdata_s21_q[29:20];
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
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_579_s22_q;
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
  logic [9:0] sum_604;
  assign sum_604 = {9'h0, difference_602_s22_q} + {1'b0, xor_603_s22_q};
  logic [9:0] sum_607;
  assign sum_607 = {9'h0, difference_605_s22_q} + {1'b0, xor_606_s22_q};
  // hls/stages/patches.hpp:330
  logic and_1656;
  assign and_1656 = not_1480_s22_q & (so_s22_q & (ends_cell_s22_q & (shift_2_s22_q & and_1652_s22_q)));
  logic [7:0] select_1661;
  assign select_1661 = so_s22_q ? (ends_cell_s22_q ? (shift_2_s22_q ? x_s22_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:457
  logic [13:0] sum_1818;
  assign sum_1818 = {{3{patches_down_values_1_s22_q[10]}}, patches_down_values_1_s22_q} + {sum_1817_s22_q, down_2_s22_q[1]};
  logic [12:0] sum_1819;
  assign sum_1819 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1818[13:1];
  // hls/stages/patches.hpp:456
  logic [12:0] sum_1828;
  assign sum_1828 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s22_q[11:1]};
  logic [12:0] sum_1829;
  assign sum_1829 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1830;
  assign difference_1830 = {1'b0, sum_1828, smooth_s22_q[0]} - {1'b0, sum_1829, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_1931_s22_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1218
  logic [6:0] select_1934;
  assign select_1934 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1228
  logic equal_1937;
  assign equal_1937 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1201
  logic not_1944;
  assign not_1944 = ~marks_first_s22_q;
  // hls/stages/agreement.hpp:1036
  logic [4:0] t;
  assign t = {difference_1966_s22_q[3], difference_1966_s22_q} + (equal_1641_s22_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1043
  logic not_1981;
  assign not_1981 = ~region_row_s22_q[2];
  logic [2:0] select_1982;
  assign select_1982 = region_row_s22_q[1] ? {1'b0, not_1981, 1'b0} : {region_row_s22_q[2], 1'b0, not_1981};
  logic [5:0] select_1983;
  assign select_1983 = region_row_s22_q[0] ? {select_1982[2], 1'b0, select_1982[1], 1'b0, select_1982[0], 1'b0} : {1'b0, select_1982[2], 1'b0, select_1982[1], 1'b0, select_1982[0]};
  logic [11:0] select_1984;
  assign select_1984 = or_1980_s22_q ? {select_1983[5], 1'b0, select_1983[4], 1'b0, select_1983[3], 1'b0, select_1983[2], 1'b0, select_1983[1], 1'b0, select_1983[0], 1'b0} : {1'b0, select_1983[5], 1'b0, select_1983[4], 1'b0, select_1983[3], 1'b0, select_1983[2], 1'b0, select_1983[1], 1'b0, select_1983[0]};
  logic [23:0] select_1985;
  assign select_1985 = or_1977_s22_q ? {select_1984[11], 1'b0, select_1984[10], 1'b0, select_1984[9], 1'b0, select_1984[8], 1'b0, select_1984[7], 1'b0, select_1984[6], 1'b0, select_1984[5], 1'b0, select_1984[4], 1'b0, select_1984[3], 1'b0, select_1984[2], 1'b0, select_1984[1], 1'b0, select_1984[0], 1'b0} : {1'b0, select_1984[11], 1'b0, select_1984[10], 1'b0, select_1984[9], 1'b0, select_1984[8], 1'b0, select_1984[7], 1'b0, select_1984[6], 1'b0, select_1984[5], 1'b0, select_1984[4], 1'b0, select_1984[3], 1'b0, select_1984[2], 1'b0, select_1984[1], 1'b0, select_1984[0]};
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_2003;
  assign sum_2003 = {1'b0, around_s22_q} + {2'h0, around_s22_q[4:1]};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2067;
  assign xor_2067 = {difference_2066_s22_q[8:0], sum_2065_s22_q} ^ {10{difference_2066_s22_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2066_s22_q[9]} + {1'b0, xor_2067};
  logic [9:0] xor_2075;
  assign xor_2075 = {difference_2074_s22_q[8:0], sum_2073_s22_q} ^ {10{difference_2074_s22_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2074_s22_q[9]} + {1'b0, xor_2075};
  // hls/stages/agreement.hpp:507
  logic select_2090;
  assign select_2090 = and_510_s22_q ? whole_2_s22_q : census_columns_values_0_cell_0_mask_q;
  logic select_2106;
  assign select_2106 = and_510_s22_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2109;
  assign select_2109 = and_510_s22_q ? census_columns_values_0_cell_1_mask_s22_q : census_columns_values_1_cell_1_mask_q;
  logic select_2112;
  assign select_2112 = and_510_s22_q ? census_columns_values_0_cell_2_mask_s22_q : census_columns_values_1_cell_2_mask_q;
  logic select_2116;
  assign select_2116 = and_510_s22_q ? census_columns_values_0_cell_3_mask_s22_q : census_columns_values_1_cell_3_mask_q;
  logic select_2119;
  assign select_2119 = and_510_s22_q ? census_columns_values_0_cell_4_mask_s22_q : census_columns_values_1_cell_4_mask_q;
  logic select_2122;
  assign select_2122 = and_510_s22_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2125;
  assign select_2125 = and_510_s22_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] sum_2147;
  assign sum_2147 = {9'h0, difference_2145_s22_q} + {1'b0, xor_2146_s22_q};
  logic [9:0] sum_2150;
  assign sum_2150 = {9'h0, difference_2148_s22_q} + {1'b0, xor_2149_s22_q};
  // hls/stages/census.hpp:353
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2191_s22_q} + xor_2192_s22_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2203_s22_q} + xor_2204_s22_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2416;
  assign select_2416 = and_2410_s22_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2414_s22_q});
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2446;
  assign sum_2446 = {1'b0, e_s22_q} + {2'h0, e_s22_q[4:1]};
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2558;
  assign difference_2558 = 13'h0 - {residual_s22_q[11], residual_s22_q};
  logic less_2573;
  assign less_2573 = $signed(difference_2558) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:176
  logic [11:0] select_2855;
  assign select_2855 = equal_1702_s22_q ? patches_smooth_values_0_q : (or_1706_s22_q ? smooth_s22_q : patches_smooth_values_0_q);
  logic [11:0] select_2857;
  assign select_2857 = or_1706_s22_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2859;
  assign select_2859 = equal_1700_s22_q ? patches_smooth_values_1_q : (equal_1702_s22_q ? patches_smooth_values_1_q : select_2857);
  logic [11:0] select_2860;
  assign select_2860 = or_1706_s22_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2862;
  assign select_2862 = equal_1700_s22_q ? patches_smooth_values_2_q : (equal_1702_s22_q ? patches_smooth_values_2_q : select_2860);
  logic [11:0] select_2863;
  assign select_2863 = or_1706_s22_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2865;
  assign select_2865 = equal_1700_s22_q ? patches_smooth_values_3_q : (equal_1702_s22_q ? patches_smooth_values_3_q : select_2863);
  logic [10:0] select_2872;
  assign select_2872 = or_1706_s22_q ? patches_down_values_1_s22_q : patches_down_values_2_q;
  logic [10:0] select_2874;
  assign select_2874 = equal_1700_s22_q ? patches_down_values_2_q : (equal_1702_s22_q ? patches_down_values_2_q : select_2872);
  logic [10:0] select_2875;
  assign select_2875 = or_1706_s22_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_2877;
  assign select_2877 = equal_1700_s22_q ? patches_down_values_3_q : (equal_1702_s22_q ? patches_down_values_3_q : select_2875);
  // hls/stages/patches.hpp:546
  logic select_3329;
  assign select_3329 = less_1861_s22_q ? (not_1863_s22_q & select_3327_s22_q) : select_3327_s22_q;
  logic select_3338;
  assign select_3338 = less_1861_s22_q ? (not_1863_s22_q & select_3336_s22_q) : select_3336_s22_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3344;
  assign select_3344 = less_1861_s22_q ? (and_3342_s22_q ? patches_rows_rdata_s22_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:527
  logic [9:0] select_3355;
  assign select_3355 = patches_read_above_q ? patches_read_row_differing_s22_q : patches_peak_above_q;
  // hls/stages/patches.hpp:528
  logic [9:0] select_3357;
  assign select_3357 = patches_read_below_q ? patches_read_row_differing_s22_q : patches_peak_below_q;
  // hls/stages/patches.hpp:565
  logic less_3394;
  assign less_3394 = select_3355 < select_3357;
  // hls/stages/patches.hpp:566
  logic [9:0] high;
  assign high = less_3394 ? select_3357 : select_3355;
  logic [9:0] low;
  assign low = (select_3357 < select_3355) ? select_3357 : select_3355;
  // hls/stages/agreement.hpp:1126
  logic or_3671;
  assign or_3671 = ({counts_textured_s22_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s22_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = less_3675_s22_q | (product_rest_q & equal_3676_s22_q);
  // hls/stages/agreement.hpp:1158
  logic select_3679;
  assign select_3679 = and_3674_s22_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_3682;
  assign sum_3682 = {1'b0, select_2462_s22_q} + {2'h0, select_2462_s22_q[9:1]};
  // hls/stages/patches.hpp:330
  logic select_3726;
  assign select_3726 = equal_1479_s22_q ? (equal_3472_s22_q ? sum_4_s22_q : (product_rest_q | sum_4_s22_q)) : product_rest_q;
  logic [4:0] select_3755;
  assign select_3755 = so_s22_q ? (ends_cell_s22_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [4:0] select_3756;
  assign select_3756 = equal_1479_s22_q ? box_textured_sum_sums_values_0_q : select_3755;
  // hls/stages/agreement.hpp:1227
  logic [3:0] select_3841;
  assign select_3841 = select_1931_s22_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3847;
  assign select_3847 = marks_first_s22_q ? (less_3843 ? {sum_3844, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s22_q, or_1888_s22_q, or_1885_s22_q, or_1882_s22_q};
  logic regions_we;
  assign regions_we = s22_en & and_1916_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1915_s22_q, sum_1909_s22_q, sum_1904_s22_q};
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
      counts_supervised_q <= select_2416;
      patches_smooth_values_0_q <= equal_1700_s22_q ? patches_smooth_values_0_q : select_2855;
      patches_smooth_values_1_q <= select_2859;
      patches_smooth_values_2_q <= select_2862;
      patches_smooth_values_3_q <= select_2865;
      patches_down_values_2_q <= select_2874;
      patches_down_values_3_q <= select_2877;
      patches_read_above_q <= equal_1700_s22_q ? select_3329 : patches_read_above_q;
      patches_read_below_q <= equal_1700_s22_q ? select_3338 : patches_read_below_q;
      patches_peak_above_q <= equal_1700_s22_q ? select_3355 : patches_peak_above_q;
      patches_peak_below_q <= equal_1700_s22_q ? select_3357 : patches_peak_below_q;
      product_rest_q <= select_3726;
      disagree_q <= equal_1479_s22_q ? select_3679 : disagree_q;
      began_q <= not_1944 & (began_q | select_1931_s22_q);
      seen_x_q <= select_1931_s22_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s22_q ? 4'h0 : select_3841;
      seen_column_q <= select_1931_s22_q ? 8'h0 : (seen_column_q + {7'h0, equal_1937});
      seen_rows_left_q <= select_3847;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s22_q ? 13'h0 : (seen_base_q + {6'h0, select_1934});
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
      census_columns_values_0_cell_0_mask_q <= select_2090;
      census_columns_values_1_cell_0_mask_q <= select_2106;
      census_columns_values_1_cell_1_mask_q <= select_2109;
      census_columns_values_1_cell_2_mask_q <= select_2112;
      census_columns_values_1_cell_3_mask_q <= select_2116;
      census_columns_values_1_cell_4_mask_q <= select_2119;
      census_columns_values_2_cell_0_mask_q <= select_2122;
      census_columns_values_2_cell_1_mask_q <= select_2125;
      box_textured_sum_sums_values_0_q <= select_3756;
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
  logic [3:0] select_471_s23_q;
  logic [6:0] select_474_s23_q;
  logic [6:0] column_s23_q;
  logic and_508_s23_q;
  logic and_510_s23_q;
  logic equal_513_s23_q;
  logic whole_2_s23_q;
  logic so_s23_q;
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
  logic less_561_s23_q;
  logic less_562_s23_q;
  logic less_563_s23_q;
  logic less_564_s23_q;
  logic less_565_s23_q;
  logic less_566_s23_q;
  logic less_567_s23_q;
  logic and_575_s23_q;
  logic whole_9_s23_q;
  logic [10:0] sum_608_s23_q;
  logic [9:0] sum_611_s23_q;
  logic [9:0] sum_615_s23_q;
  logic [9:0] sum_619_s23_q;
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
  logic not_1890_s23_q;
  logic not_1944_s23_q;
  logic [7:0] sum_1954_s23_q;
  logic equal_1969_s23_q;
  logic or_1974_s23_q;
  logic [23:0] select_1985_s23_q;
  logic not_2005_s23_q;
  logic less_2019_s23_q;
  logic and_2030_s23_q;
  logic [10:0] size_s23_q;
  logic [10:0] size_2_s23_q;
  logic [10:0] sum_2151_s23_q;
  logic [9:0] sum_2154_s23_q;
  logic [9:0] sum_2158_s23_q;
  logic [9:0] sum_2162_s23_q;
  logic equal_2170_s23_q;
  logic [8:0] contrast_s23_q;
  logic [8:0] contrast_2_s23_q;
  logic equal_2223_s23_q;
  logic equal_2294_s23_q;
  logic and_2410_s23_q;
  logic and_2429_s23_q;
  logic not_2433_s23_q;
  logic not_2448_s23_q;
  logic [9:0] select_2459_s23_q;
  logic [9:0] select_2462_s23_q;
  logic and_2525_s23_q;
  logic and_2526_s23_q;
  logic [7:0] residual_s23_q;
  logic less_2559_s23_q;
  logic less_2573_s23_q;
  logic equal_2617_s23_q;
  logic and_2762_s23_q;
  logic less_2889_s23_q;
  logic equal_3232_s23_q;
  logic [4:0] select_3320_s23_q;
  logic [9:0] select_3344_s23_q;
  logic [14:0] select_3351_s23_q;
  logic less_3394_s23_q;
  logic [9:0] high_s23_q;
  logic [9:0] low_s23_q;
  logic equal_3472_s23_q;
  logic equal_3668_s23_q;
  logic or_3671_s23_q;
  logic select_3679_s23_q;
  logic not_3684_s23_q;
  logic equal_3692_s23_q;
  logic equal_3694_s23_q;
  logic equal_3695_s23_q;
  logic equal_3824_s23_q;
  logic equal_3913_s23_q;
  logic [9:0] select_3923_s23_q;
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
      select_471_s23_q <= select_471_s22_q;
      select_474_s23_q <= select_474_s22_q;
      column_s23_q <= column_s22_q;
      and_508_s23_q <= and_508_s22_q;
      and_510_s23_q <= and_510_s22_q;
      equal_513_s23_q <= equal_513_s22_q;
      whole_2_s23_q <= whole_2_s22_q;
      so_s23_q <= so_s22_q;
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
      less_561_s23_q <= less_561_s22_q;
      less_562_s23_q <= less_562_s22_q;
      less_563_s23_q <= less_563_s22_q;
      less_564_s23_q <= less_564_s22_q;
      less_565_s23_q <= less_565_s22_q;
      less_566_s23_q <= less_566_s22_q;
      less_567_s23_q <= less_567_s22_q;
      and_575_s23_q <= and_575_s22_q;
      whole_9_s23_q <= whole_9;
      sum_608_s23_q <= {1'b0, sum_604} + {1'b0, sum_607};
      sum_611_s23_q <= {9'h0, difference_609_s22_q} + {1'b0, xor_610_s22_q};
      sum_615_s23_q <= {9'h0, difference_613_s22_q} + {1'b0, xor_614_s22_q};
      sum_619_s23_q <= {9'h0, difference_617_s22_q} + {1'b0, xor_618_s22_q};
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
      not_1890_s23_q <= not_1890_s22_q;
      not_1944_s23_q <= not_1944;
      sum_1954_s23_q <= {2'h0, x_s22_q[7:2]} + 8'hff;
      equal_1969_s23_q <= t[4:1] == 4'h0;
      or_1974_s23_q <= or_1974_s22_q;
      select_1985_s23_q <= select_1985;
      not_2005_s23_q <= ~({sum_2003, around_s22_q[0]} < {2'h0, t});
      less_2019_s23_q <= less_2019_s22_q;
      and_2030_s23_q <= and_2030_s22_q;
      size_s23_q <= size;
      size_2_s23_q <= size_2;
      sum_2151_s23_q <= {1'b0, sum_2147} + {1'b0, sum_2150};
      sum_2154_s23_q <= {9'h0, difference_2152_s22_q} + {1'b0, xor_2153_s22_q};
      sum_2158_s23_q <= {9'h0, difference_2156_s22_q} + {1'b0, xor_2157_s22_q};
      sum_2162_s23_q <= {9'h0, difference_2160_s22_q} + {1'b0, xor_2161_s22_q};
      equal_2170_s23_q <= equal_2170_s22_q;
      contrast_s23_q <= contrast;
      contrast_2_s23_q <= contrast_2;
      equal_2223_s23_q <= x_s22_q[7:3] == 5'h0;
      equal_2294_s23_q <= equal_2294_s22_q;
      and_2410_s23_q <= and_2410_s22_q;
      and_2429_s23_q <= and_2429_s22_q;
      not_2433_s23_q <= not_2433_s22_q;
      not_2448_s23_q <= ~({sum_2446, e_s22_q[0]} < {2'h0, t});
      select_2459_s23_q <= select_2459_s22_q;
      select_2462_s23_q <= select_2462_s22_q;
      and_2525_s23_q <= and_2525_s22_q;
      and_2526_s23_q <= and_2526_s22_q;
      residual_s23_q <= residual_s22_q[7:0];
      less_2559_s23_q <= $signed(difference_2558) < $signed({7'h0, cfg_moved_limit_i});
      less_2573_s23_q <= less_2573;
      equal_2617_s23_q <= equal_2617_s22_q;
      and_2762_s23_q <= and_2762_s22_q;
      less_2889_s23_q <= less_2889_s22_q;
      equal_3232_s23_q <= equal_3232_s22_q;
      select_3320_s23_q <= select_3320_s22_q;
      select_3344_s23_q <= select_3344;
      select_3351_s23_q <= select_3351_s22_q;
      less_3394_s23_q <= less_3394;
      high_s23_q <= high;
      low_s23_q <= low;
      equal_3472_s23_q <= equal_3472_s22_q;
      equal_3668_s23_q <= select_2459_s22_q[9:3] == 7'h0;
      or_3671_s23_q <= or_3671;
      select_3679_s23_q <= select_3679;
      not_3684_s23_q <= ~({sum_3682, select_2462_s22_q[0]} < {2'h0, select_2459_s22_q});
      equal_3692_s23_q <= equal_3692_s22_q;
      equal_3694_s23_q <= equal_3694_s22_q;
      equal_3695_s23_q <= equal_3695_s22_q;
      equal_3824_s23_q <= equal_3824_s22_q;
      equal_3913_s23_q <= equal_3913_s22_q;
      select_3923_s23_q <= select_3923_s22_q;
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
  logic [10:0] sum_612;
  assign sum_612 = sum_608_s23_q + {1'b0, sum_611_s23_q};
  // hls/stages/patches.hpp:148
  logic and_1658;
  assign and_1658 = and_1656_s23_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:333
  logic [22:0] select_1692;
  assign select_1692 = and_1658 ? {select_1691_s23_q, select_1666_s23_q, select_1662_s23_q, and_1656_s23_q} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:457
  logic [14:0] sum_1820;
  assign sum_1820 = {{4{patches_down_values_3_s23_q[10]}}, patches_down_values_3_s23_q} + {sum_1819_s23_q, sum_1818_s23_q, down_2_s23_q};
  // hls/stages/agreement.hpp:1235
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1202
  logic select_1942;
  assign select_1942 = marks_first_s23_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1188
  logic [10:0] sum_1943;
  assign sum_1943 = {1'b0, {5{select_1942}}, 1'b0, {2{select_1942}}, 1'b0, select_1942} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1053
  logic [12:0] index_2;
  assign index_2 = {{3{sum_1954_s23_q[7]}}, sum_1954_s23_q, x_s23_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1188
  logic [10:0] sum_1956;
  assign sum_1956 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1043
  logic [47:0] select_1986;
  assign select_1986 = or_1974_s23_q ? {select_1985_s23_q[23], 1'b0, select_1985_s23_q[22], 1'b0, select_1985_s23_q[21], 1'b0, select_1985_s23_q[20], 1'b0, select_1985_s23_q[19], 1'b0, select_1985_s23_q[18], 1'b0, select_1985_s23_q[17], 1'b0, select_1985_s23_q[16], 1'b0, select_1985_s23_q[15], 1'b0, select_1985_s23_q[14], 1'b0, select_1985_s23_q[13], 1'b0, select_1985_s23_q[12], 1'b0, select_1985_s23_q[11], 1'b0, select_1985_s23_q[10], 1'b0, select_1985_s23_q[9], 1'b0, select_1985_s23_q[8], 1'b0, select_1985_s23_q[7], 1'b0, select_1985_s23_q[6], 1'b0, select_1985_s23_q[5], 1'b0, select_1985_s23_q[4], 1'b0, select_1985_s23_q[3], 1'b0, select_1985_s23_q[2], 1'b0, select_1985_s23_q[1], 1'b0, select_1985_s23_q[0], 1'b0} : {1'b0, select_1985_s23_q[23], 1'b0, select_1985_s23_q[22], 1'b0, select_1985_s23_q[21], 1'b0, select_1985_s23_q[20], 1'b0, select_1985_s23_q[19], 1'b0, select_1985_s23_q[18], 1'b0, select_1985_s23_q[17], 1'b0, select_1985_s23_q[16], 1'b0, select_1985_s23_q[15], 1'b0, select_1985_s23_q[14], 1'b0, select_1985_s23_q[13], 1'b0, select_1985_s23_q[12], 1'b0, select_1985_s23_q[11], 1'b0, select_1985_s23_q[10], 1'b0, select_1985_s23_q[9], 1'b0, select_1985_s23_q[8], 1'b0, select_1985_s23_q[7], 1'b0, select_1985_s23_q[6], 1'b0, select_1985_s23_q[5], 1'b0, select_1985_s23_q[4], 1'b0, select_1985_s23_q[3], 1'b0, select_1985_s23_q[2], 1'b0, select_1985_s23_q[1], 1'b0, select_1985_s23_q[0]};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size_s23_q} + (equal_513_s23_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2072;
  assign select_2072 = sample_pair_whole_s23_q ? (and_508_s23_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s23_q} + (equal_513_s23_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2080;
  assign select_2080 = sample_pair_whole_s23_q ? (and_508_s23_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:507
  logic select_2128;
  assign select_2128 = and_510_s23_q ? census_columns_values_1_cell_2_mask_s23_q : census_columns_values_2_cell_2_mask_q;
  logic select_2131;
  assign select_2131 = and_510_s23_q ? census_columns_values_1_cell_3_mask_s23_q : census_columns_values_2_cell_3_mask_q;
  logic select_2134;
  assign select_2134 = and_510_s23_q ? census_columns_values_1_cell_4_mask_s23_q : census_columns_values_2_cell_4_mask_q;
  logic select_2135;
  assign select_2135 = and_510_s23_q ? census_columns_values_2_cell_0_mask_s23_q : census_columns_values_3_cell_0_mask_q;
  logic select_2138;
  assign select_2138 = and_510_s23_q ? census_columns_values_2_cell_1_mask_s23_q : census_columns_values_3_cell_1_mask_q;
  logic select_2139;
  assign select_2139 = and_510_s23_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2142;
  assign select_2142 = and_510_s23_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:272
  logic [10:0] sum_2155;
  assign sum_2155 = sum_2151_s23_q + {1'b0, sum_2154_s23_q};
  // hls/stages/agreement.hpp:507
  logic select_2187;
  assign select_2187 = and_510_s23_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2190;
  assign and_2190 = whole_2_s23_q & (~(column_s23_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
  logic and_2196;
  assign and_2196 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s23_q[8:2]));
  logic and_2197;
  assign and_2197 = and_2190 & and_2196;
  logic and_2208;
  assign and_2208 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s23_q[8:2]));
  logic and_2209;
  assign and_2209 = and_2190 & and_2208;
  // hls/stages/census.hpp:409
  logic not_2226;
  assign not_2226 = ~x_s23_q[1];
  logic [2:0] select_2227;
  assign select_2227 = x_s23_q[0] ? {1'b0, not_2226, 1'b0} : {x_s23_q[1], 1'b0, not_2226};
  logic [5:0] select_2228;
  assign select_2228 = slot_s23_q[2] ? {select_2227[2], 1'b0, select_2227[1], 1'b0, select_2227[0], 1'b0} : {1'b0, select_2227[2], 1'b0, select_2227[1], 1'b0, select_2227[0]};
  logic [11:0] select_2229;
  assign select_2229 = slot_s23_q[1] ? {select_2228[5], 1'b0, select_2228[4], 1'b0, select_2228[3], 1'b0, select_2228[2], 1'b0, select_2228[1], 1'b0, select_2228[0], 1'b0} : {1'b0, select_2228[5], 1'b0, select_2228[4], 1'b0, select_2228[3], 1'b0, select_2228[2], 1'b0, select_2228[1], 1'b0, select_2228[0]};
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2431;
  assign select_2431 = and_2410_s23_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2429_s23_q});
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2463;
  assign sum_2463 = {1'b0, select_2462_s23_q} + {3'h0, select_2462_s23_q[9:2]};
  // hls/stages/registration.hpp:107
  logic [7:0] select_2541;
  assign select_2541 = equal_1620_s23_q ? (and_2526_s23_q ? residual_s23_q : 8'h0) : 8'h0;
  logic and_2552;
  assign and_2552 = and_2526_s23_q & ($signed(residual_s23_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2566;
  assign less_2566 = $signed(residual_s23_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2619;
  assign select_2619 = or_1559_s23_q ? 12'h0 : (equal_2617_s23_q ? registration_sums_rdata_s23_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2621;
  assign select_2621 = equal_1524_s23_q ? 12'h0 : (less_1555_s23_q ? select_2619 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2624;
  assign and_2624 = x_s23_q[1] & all_s23_q;
  // hls/stages/agreement.hpp:1084
  logic and_2627;
  assign and_2627 = not_1890_s23_q & (less_1555_s23_q & ({and_2624, x_s23_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2634;
  assign select_2634 = or_1559_s23_q ? 12'h0 : (equal_2617_s23_q ? registration_sums_rdata_s23_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2636;
  assign select_2636 = equal_1524_s23_q ? 12'h0 : (less_1555_s23_q ? select_2634 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2642;
  assign not_2642 = ~all_s23_q;
  // hls/stages/agreement.hpp:1084
  logic and_2645;
  assign and_2645 = not_1890_s23_q & (less_1555_s23_q & (x_s23_q[2:0] == {all_s23_q, not_2642, 1'b0}));
  // hls/stages/patches.hpp:330
  logic and_2651;
  assign and_2651 = equal_1479_s23_q & (x_s23_q[6] & (not_1890_s23_q & (less_1555_s23_q & all_s23_q)));
  // hls/stages/registration.hpp:157
  logic equal_2678;
  assign equal_2678 = x_s23_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_2681;
  assign and_2681 = not_1890_s23_q & (less_1555_s23_q & (x_s23_q[5] ? x_s23_q[3] : equal_2678));
  logic and_2690;
  assign and_2690 = not_1890_s23_q & (less_1555_s23_q & ((~x_s23_q[5]) & (x_s23_q[3] & equal_2678)));
  // hls/stages/patches.hpp:335
  logic not_2752;
  assign not_2752 = ~and_1698_s23_q;
  // hls/stages/patches.hpp:491
  logic [27:0] word;
  assign word = or_1804_s23_q ? patches_right_codes_rdata_s23_q : 28'h0;
  // hls/stages/patches.hpp:508
  logic [47:0] select_2922;
  assign select_2922 = new_row_s23_q ? patches_left_codes_rdata_s23_q : patches_left_row_q;
  // hls/stages/patches.hpp:176
  logic [47:0] select_2924;
  assign select_2924 = equal_1700_s23_q ? patches_left_row_q : (equal_1702_s23_q ? select_2922 : patches_left_row_q);
  logic [4:0] select_3269;
  assign select_3269 = equal_1702_s23_q ? patches_along_s23_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3346;
  assign select_3346 = less_1861_s23_q ? (equal_1864_s23_q ? 10'h3ff : select_3344_s23_q) : 10'h3ff;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3347;
  assign select_3347 = equal_1864_s23_q ? select_3346 : select_3344_s23_q;
  logic [9:0] select_3349;
  assign select_3349 = less_1861_s23_q ? (equal_1862_s23_q ? 10'h3ff : select_3347) : select_3347;
  // hls/stages/patches.hpp:567
  logic [9:0] eight;
  assign eight = high_s23_q - low_s23_q;
  logic [9:0] fall;
  assign fall = high_s23_q - select_3351_s23_q[9:0];
  // hls/stages/agreement.hpp:1086
  logic equal_3579;
  assign equal_3579 = x_s23_q == 7'h7f;
  // hls/stages/agreement.hpp:1077
  logic select_3685;
  assign select_3685 = equal_3668_s23_q ? ((~or_3671_s23_q) & (~select_3679_s23_q)) : not_3684_s23_q;
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_3687;
  assign select_3687 = x_s23_q[6] ? (equal_1524_s23_q ? good_q : {select_3685, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:447
  logic [12:0] select_3827;
  assign select_3827 = equal_2294_s23_q ? (equal_3824_s23_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3830;
  assign select_3830 = and_510_s23_q ? (equal_2294_s23_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3915;
  assign select_3915 = equal_1546_s23_q ? {2'h0, counts_explained_s23_q, 2'h0, counts_textured_s23_q} : (equal_3913_s23_q ? registration_sums_rdata_s23_q : 32'h0);
  logic [31:0] select_3916;
  assign select_3916 = equal_1544_s23_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_s23_q} : select_3915;

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
      sharpness_before_last_mask_q <= select_2187;
      counts_nearer_q <= select_2431;
      patches_fixed_q <= not_2752 & (patches_fixed_q | (and_2762_s23_q & and_1658));
      patches_choice_valid_q <= and_1698_s23_q ? (select_1692[0] & not_2752) : select_1692[0];
      patches_choice_column_q <= select_1692[8:1];
      patches_choice_shift_q <= select_1692[14:9];
      patches_choice_slope_q <= select_1692[22:15];
      patches_left_row_q <= select_2924;
      patches_summed_row_column_q <= equal_1700_s23_q ? patches_summed_row_column_q : select_3269;
      patches_read_far_q <= equal_1700_s23_q ? select_3349 : patches_read_far_q;
      good_q <= equal_1479_s23_q ? select_3687 : good_q;
      map_row_q <= and_510_s23_q ? select_3827 : map_row_q;
      map_width_q <= select_3830;
      write_half_q <= marks_first_s23_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_1942;
      done_q <= not_1944_s23_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s23_q;
      said_q <= equal_1479_s23_q & equal_3579;
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
      averager_detail_0_q <= select_2072;
      averager_detail_1_q <= select_2080;
      census_columns_values_2_cell_2_mask_q <= select_2128;
      census_columns_values_2_cell_3_mask_q <= select_2131;
      census_columns_values_2_cell_4_mask_q <= select_2134;
      census_columns_values_3_cell_0_mask_q <= select_2135;
      census_columns_values_3_cell_1_mask_q <= select_2138;
      census_columns_values_3_cell_2_mask_q <= select_2139;
      census_columns_values_3_cell_3_mask_q <= select_2142;
      sharpness_last_mask_q <= and_510_s23_q ? whole_2_s23_q : sharpness_last_mask_q;
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
  logic [3:0] select_471_s24_q;
  logic [6:0] select_474_s24_q;
  logic [6:0] column_s24_q;
  logic and_510_s24_q;
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
  logic less_561_s24_q;
  logic less_562_s24_q;
  logic less_563_s24_q;
  logic less_564_s24_q;
  logic less_565_s24_q;
  logic less_566_s24_q;
  logic less_567_s24_q;
  logic and_575_s24_q;
  logic whole_16_s24_q;
  logic and_601_s24_q;
  logic [11:0] sum_616_s24_q;
  logic [9:0] sum_619_s24_q;
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
  logic [2:0] index_s24_q;
  logic [10:0] sum_1943_s24_q;
  logic and_1950_s24_q;
  logic less_1951_s24_q;
  logic [2:0] index_2_s24_q;
  logic [10:0] sum_1956_s24_q;
  logic equal_1969_s24_q;
  logic not_1989_s24_q;
  logic not_2005_s24_q;
  logic less_2019_s24_q;
  logic and_2030_s24_q;
  logic [11:0] sum_2159_s24_q;
  logic [9:0] sum_2162_s24_q;
  logic equal_2170_s24_q;
  logic [27:0] select_2184_s24_q;
  logic and_2197_s24_q;
  logic and_2209_s24_q;
  logic [8:0] select_2216_s24_q;
  logic [8:0] select_2220_s24_q;
  logic equal_2223_s24_q;
  logic less_2224_s24_q;
  logic [11:0] select_2229_s24_q;
  logic equal_2267_s24_q;
  logic and_2410_s24_q;
  logic not_2433_s24_q;
  logic not_2448_s24_q;
  logic [9:0] select_2459_s24_q;
  logic [9:0] select_2462_s24_q;
  logic less_2464_s24_q;
  logic and_2525_s24_q;
  logic and_2526_s24_q;
  logic [7:0] select_2543_s24_q;
  logic and_2552_s24_q;
  logic and_2560_s24_q;
  logic and_2567_s24_q;
  logic and_2574_s24_q;
  logic [11:0] select_2621_s24_q;
  logic and_2629_s24_q;
  logic [11:0] select_2636_s24_q;
  logic and_2647_s24_q;
  logic and_2651_s24_q;
  logic and_2683_s24_q;
  logic and_2691_s24_q;
  logic [27:0] word_s24_q;
  logic equal_2883_s24_q;
  logic less_2889_s24_q;
  logic [47:0] select_2922_s24_q;
  logic equal_3232_s24_q;
  logic [4:0] select_3320_s24_q;
  logic [14:0] select_3351_s24_q;
  logic less_3394_s24_q;
  logic [9:0] eight_s24_q;
  logic [9:0] fall_s24_q;
  logic equal_3472_s24_q;
  logic equal_3579_s24_q;
  logic or_3671_s24_q;
  logic select_3679_s24_q;
  logic equal_3692_s24_q;
  logic equal_3694_s24_q;
  logic equal_3695_s24_q;
  logic [31:0] select_3916_s24_q;
  logic [9:0] select_3923_s24_q;
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
      select_471_s24_q <= select_471_s23_q;
      select_474_s24_q <= select_474_s23_q;
      column_s24_q <= column_s23_q;
      and_510_s24_q <= and_510_s23_q;
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
      less_561_s24_q <= less_561_s23_q;
      less_562_s24_q <= less_562_s23_q;
      less_563_s24_q <= less_563_s23_q;
      less_564_s24_q <= less_564_s23_q;
      less_565_s24_q <= less_565_s23_q;
      less_566_s24_q <= less_566_s23_q;
      less_567_s24_q <= less_567_s23_q;
      and_575_s24_q <= and_575_s23_q;
      whole_16_s24_q <= whole_16;
      and_601_s24_q <= census_columns_values_1_cell_2_mask_s23_q & and_575_s23_q;
      sum_616_s24_q <= {1'b0, sum_612} + {2'h0, sum_615_s23_q};
      sum_619_s24_q <= sum_619_s23_q;
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
      index_s24_q <= index[2:0];
      sum_1943_s24_q <= sum_1943;
      and_1950_s24_q <= began_q & (seen_x_q == 4'h0);
      less_1951_s24_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s24_q <= index_2[2:0];
      sum_1956_s24_q <= sum_1956;
      equal_1969_s24_q <= equal_1969_s23_q;
      not_1989_s24_q <= ~((good_q & select_1986) == 48'h0);
      not_2005_s24_q <= not_2005_s23_q;
      less_2019_s24_q <= less_2019_s23_q;
      and_2030_s24_q <= and_2030_s23_q;
      sum_2159_s24_q <= {1'b0, sum_2155} + {2'h0, sum_2158_s23_q};
      sum_2162_s24_q <= sum_2162_s23_q;
      equal_2170_s24_q <= equal_2170_s23_q;
      select_2184_s24_q <= sample_pair_whole_s23_q ? {detail_2, detail} : 28'h0;
      and_2197_s24_q <= and_2197;
      and_2209_s24_q <= and_2209;
      select_2216_s24_q <= and_2197 ? contrast_s23_q : 9'h0;
      select_2220_s24_q <= and_2209 ? contrast_2_s23_q : 9'h0;
      equal_2223_s24_q <= equal_2223_s23_q;
      less_2224_s24_q <= 7'h2 < {x_s23_q[4:0], slot_s23_q[2:1]};
      select_2229_s24_q <= select_2229;
      equal_2267_s24_q <= {x_s23_q[4:0], slot_s23_q} == 8'h0;
      and_2410_s24_q <= and_2410_s23_q;
      not_2433_s24_q <= not_2433_s23_q;
      not_2448_s24_q <= not_2448_s23_q;
      select_2459_s24_q <= select_2459_s23_q;
      select_2462_s24_q <= select_2462_s23_q;
      less_2464_s24_q <= {sum_2463, select_2462_s23_q[1:0]} < {3'h0, select_2459_s23_q};
      and_2525_s24_q <= and_2525_s23_q;
      and_2526_s24_q <= and_2526_s23_q;
      select_2543_s24_q <= equal_1479_s23_q ? 8'h0 : (so_s23_q ? select_2541 : 8'h0);
      and_2552_s24_q <= and_2552;
      and_2560_s24_q <= and_2526_s23_q & less_2559_s23_q;
      and_2567_s24_q <= and_2526_s23_q & less_2566;
      and_2574_s24_q <= and_2526_s23_q & less_2573_s23_q;
      select_2621_s24_q <= select_2621;
      and_2629_s24_q <= equal_1479_s23_q & (x_s23_q[6] & and_2627);
      select_2636_s24_q <= select_2636;
      and_2647_s24_q <= equal_1479_s23_q & (x_s23_q[6] & and_2645);
      and_2651_s24_q <= and_2651;
      and_2683_s24_q <= equal_1479_s23_q & (x_s23_q[6] & and_2681);
      and_2691_s24_q <= x_s23_q[6] & and_2690;
      word_s24_q <= word;
      equal_2883_s24_q <= patches_along_s23_q == 5'h7;
      less_2889_s24_q <= less_2889_s23_q;
      select_2922_s24_q <= select_2922;
      equal_3232_s24_q <= equal_3232_s23_q;
      select_3320_s24_q <= select_3320_s23_q;
      select_3351_s24_q <= select_3351_s23_q;
      less_3394_s24_q <= less_3394_s23_q;
      eight_s24_q <= eight;
      fall_s24_q <= fall;
      equal_3472_s24_q <= equal_3472_s23_q;
      equal_3579_s24_q <= equal_3579;
      or_3671_s24_q <= or_3671_s23_q;
      select_3679_s24_q <= select_3679_s23_q;
      equal_3692_s24_q <= equal_3692_s23_q;
      equal_3694_s24_q <= equal_3694_s23_q;
      equal_3695_s24_q <= equal_3695_s23_q;
      select_3916_s24_q <= select_3916;
      select_3923_s24_q <= select_3923_s23_q;
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
  assign texture = sum_616_s24_q + {2'h0, sum_619_s24_q};
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
  // hls/stages/patches.hpp:344
  logic [21:0] select_1719;
  assign select_1719 = select_1609_s24_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1716_s24_q[22:1];
  // hls/stages/patches.hpp:119
  logic [7:0] select_1720;
  assign select_1720 = equal_1610_s24_q ? patches_place_0_column_q : select_1719[7:0];
  logic [5:0] select_1721;
  assign select_1721 = equal_1610_s24_q ? patches_place_0_shift_q : select_1719[13:8];
  // hls/stages/patches.hpp:344
  logic [21:0] select_1748;
  assign select_1748 = select_1609_s24_q ? select_1716_s24_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:119
  logic [7:0] select_1749;
  assign select_1749 = equal_1610_s24_q ? patches_place_1_column_q : select_1748[7:0];
  logic [5:0] select_1750;
  assign select_1750 = equal_1610_s24_q ? patches_place_1_shift_q : select_1748[13:8];
  // hls/stages/patches.hpp:124
  logic equal_1766;
  assign equal_1766 = {select_1720[7], select_474_s24_q, select_471_s24_q} == {1'b0, select_1720[6:0], 4'h0};
  logic equal_1770;
  assign equal_1770 = {select_1749[7], select_474_s24_q, select_471_s24_q} == {1'b0, select_1749[6:0], 4'h0};
  // hls/stages/patches.hpp:472
  logic [2:0] sum_1812;
  assign sum_1812 = patches_code_row_s24_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:476
  logic [1:0] sum_1850;
  assign sum_1850 = patches_code_row_s24_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:976
  logic and_1990;
  assign and_1990 = good_known_q & not_1989_s24_q;
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_1969_s24_q ? and_1990 : not_2005_s24_q;
  // hls/stages/agreement.hpp:507
  logic select_2143;
  assign select_2143 = and_510_s24_q ? census_columns_values_2_cell_4_mask_s24_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2163;
  assign sum_2163 = sum_2159_s24_q + {2'h0, sum_2162_s24_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2165;
  assign select_2165 = and_510_s24_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2166;
  assign select_2166 = and_510_s24_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [13:0] select_2185;
  assign select_2185 = and_510_s24_q ? select_2184_s24_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2186;
  assign select_2186 = and_510_s24_q ? select_2184_s24_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2184_s24_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2184_s24_q[27:14]};
  // hls/stages/census.hpp:357
  logic [23:0] sum_2217;
  assign sum_2217 = (equal_2170_s24_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2216_s24_q};
  logic [23:0] sum_2221;
  assign sum_2221 = (equal_2170_s24_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2220_s24_q};
  // hls/stages/census.hpp:409
  logic less_2225;
  assign less_2225 = x_s24_q[4:0] < 5'h3;
  logic [23:0] select_2230;
  assign select_2230 = slot_s24_q ? {select_2229_s24_q[11], 1'b0, select_2229_s24_q[10], 1'b0, select_2229_s24_q[9], 1'b0, select_2229_s24_q[8], 1'b0, select_2229_s24_q[7], 1'b0, select_2229_s24_q[6], 1'b0, select_2229_s24_q[5], 1'b0, select_2229_s24_q[4], 1'b0, select_2229_s24_q[3], 1'b0, select_2229_s24_q[2], 1'b0, select_2229_s24_q[1], 1'b0, select_2229_s24_q[0], 1'b0} : {1'b0, select_2229_s24_q[11], 1'b0, select_2229_s24_q[10], 1'b0, select_2229_s24_q[9], 1'b0, select_2229_s24_q[8], 1'b0, select_2229_s24_q[7], 1'b0, select_2229_s24_q[6], 1'b0, select_2229_s24_q[5], 1'b0, select_2229_s24_q[4], 1'b0, select_2229_s24_q[3], 1'b0, select_2229_s24_q[2], 1'b0, select_2229_s24_q[1], 1'b0, select_2229_s24_q[0]};
  // hls/stages/census.hpp:372
  logic and_2234;
  assign and_2234 = less_2225 & (~((sharpness_sums_contrast_1_q & select_2230) == 24'h0));
  logic and_2244;
  assign and_2244 = less_2225 & (~((sharpness_sums_contrast_0_q & select_2230) == 24'h0));
  // hls/stages/agreement.hpp:1048
  logic not_2450;
  assign not_2450 = ~(equal_1969_s24_q ? and_1990 : not_2448_s24_q);
  // hls/stages/patches.hpp:330
  logic and_2453;
  assign and_2453 = ends_cell_s24_q & (not_2433_s24_q & (centres_values_1_textured_s24_q & not_2450));
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_2466;
  assign select_2466 = ((~(select_2459_s24_q[9:4] == 6'h0)) & less_2464_s24_q) ? select_2459_s24_q : 10'h0;
  // hls/stages/patches.hpp:330
  logic [9:0] select_2469;
  assign select_2469 = equal_1479_s24_q ? (x_s24_q[6] ? (equal_1524_s24_q ? 10'h0 : select_2466) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1052
  logic and_2487;
  assign and_2487 = centres_values_1_textured_s24_q & (centres_values_1_of_skin_s24_q & not_2450);
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2544;
  assign sum_2544 = registration_half_across_q + {{6{select_2543_s24_q[7]}}, select_2543_s24_q};
  // hls/stages/patches.hpp:330
  logic and_2548;
  assign and_2548 = not_1480_s24_q & (drew_q & (and_2526_s24_q & equal_1620_s24_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2550;
  assign select_2550 = and_2525_s24_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2548});
  // hls/stages/patches.hpp:330
  logic [1:0] select_2554;
  assign select_2554 = drew_q ? (equal_1620_s24_q ? {and_2552_s24_q, and_2526_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2555;
  assign select_2555 = equal_1479_s24_q ? 2'h0 : select_2554;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2556;
  assign sum_2556 = registration_half_votes_down_q + {{5{select_2555[1]}}, select_2555};
  // hls/stages/patches.hpp:330
  logic [1:0] select_2562;
  assign select_2562 = drew_q ? (equal_1620_s24_q ? {and_2560_s24_q, and_2526_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2563;
  assign select_2563 = equal_1479_s24_q ? 2'h0 : select_2562;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2564;
  assign sum_2564 = registration_half_votes_up_q + {{5{select_2563[1]}}, select_2563};
  // hls/stages/patches.hpp:330
  logic [1:0] select_2569;
  assign select_2569 = drew_q ? (equal_1620_s24_q ? {and_2567_s24_q, and_2526_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2570;
  assign select_2570 = equal_1479_s24_q ? 2'h0 : select_2569;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2571;
  assign sum_2571 = registration_half_half_votes_down_q + {{5{select_2570[1]}}, select_2570};
  // hls/stages/patches.hpp:330
  logic [1:0] select_2576;
  assign select_2576 = drew_q ? (equal_1620_s24_q ? {and_2574_s24_q, and_2526_s24_q} : 2'h0) : 2'h0;
  logic [1:0] select_2577;
  assign select_2577 = equal_1479_s24_q ? 2'h0 : select_2576;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2578;
  assign sum_2578 = registration_half_half_votes_up_q + {{5{select_2577[1]}}, select_2577};
  // hls/stages/patches.hpp:330
  logic and_2612;
  assign and_2612 = equal_1479_s24_q & (x_s24_q[6] & (not_1890_s24_q & less_1555_s24_q));
  logic [11:0] select_2623;
  assign select_2623 = equal_1479_s24_q ? (x_s24_q[6] ? select_2621_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2631;
  assign sum_2631 = {{2{select_2623[11]}}, select_2623} + (and_2629_s24_q ? 14'h0 : registration_down_q);
  // hls/stages/patches.hpp:330
  logic [11:0] select_2638;
  assign select_2638 = equal_1479_s24_q ? (x_s24_q[6] ? select_2636_s24_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2640;
  assign sum_2640 = {{2{select_2638[11]}}, select_2638} + (and_2629_s24_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2652;
  assign not_2652 = ~and_2651_s24_q;
  logic less_2653;
  assign less_2653 = $signed({9'h1, {2{not_2652}}, and_2651_s24_q}) < $signed(registration_up_q[13:2]);
  logic select_2654;
  assign select_2654 = and_2647_s24_q ? less_2653 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_2658;
  assign and_2658 = x_s24_q[6] & (not_1890_s24_q & (less_1555_s24_q & (x_s24_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:330
  logic and_2659;
  assign and_2659 = equal_1479_s24_q & and_2658;
  // hls/stages/registration.hpp:242
  logic less_2660;
  assign less_2660 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2662;
  assign less_2662 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2664;
  assign equal_2664 = x_s24_q[2:0] == 3'h7;
  // hls/stages/patches.hpp:330
  logic and_2668;
  assign and_2668 = equal_1479_s24_q & (x_s24_q[6] & (not_1890_s24_q & (less_1555_s24_q & equal_2664)));
  // hls/stages/agreement.hpp:1084
  logic and_2675;
  assign and_2675 = x_s24_q[6] & (not_1890_s24_q & (less_1555_s24_q & (x_s24_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2693;
  assign and_2693 = registration_votes_up_q & registration_other_down_q;
  logic select_2695;
  assign select_2695 = registration_votes_down_q ? (registration_other_up_q | and_2693) : and_2693;
  // hls/stages/registration.hpp:138
  logic and_2697;
  assign and_2697 = (equal_1479_s24_q & and_2691_s24_q) & (registration_other_enough_q & select_2695);
  logic and_2699;
  assign and_2699 = registration_enough_q & ((and_2683_s24_q & (less_2662 | less_2660)) | and_2697);
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2785;
  assign select_2785 = sample_pair_whole_s24_q ? (equal_1610_s24_q ? patches_place_0_slope_q : select_1719[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_2790;
  assign select_2790 = sample_pair_whole_s24_q ? (equal_1610_s24_q ? patches_place_1_slope_q : select_1748[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:508
  logic [55:0] other;
  assign other = new_row_s24_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:176
  logic [51:0] select_2879;
  assign select_2879 = or_1706_s24_q ? {less_1832_s24_q, less_1831_s24_q, less_1822_s24_q, less_1821_s24_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2881;
  assign select_2881 = equal_1700_s24_q ? patches_codes_at_q : (equal_1702_s24_q ? other[55:4] : select_2879);
  // hls/stages/patches.hpp:507
  logic [27:0] select_2884;
  assign select_2884 = equal_2883_s24_q ? word_s24_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:176
  logic [27:0] select_2886;
  assign select_2886 = equal_1702_s24_q ? (new_row_s24_q ? word_s24_q : select_2884) : patches_codes_further_q;
  // hls/stages/patches.hpp:509
  logic [55:0] select_2888;
  assign select_2888 = less_1791_s24_q ? {word_s24_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:479
  logic [55:0] select_2890;
  assign select_2890 = less_2889_s24_q ? {word_s24_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:176
  logic [55:0] select_2892;
  assign select_2892 = or_1706_s24_q ? (equal_1705_s24_q ? patches_next_codes_q : select_2890) : patches_next_codes_q;
  logic [55:0] select_2894;
  assign select_2894 = equal_1700_s24_q ? patches_next_codes_q : (equal_1702_s24_q ? select_2888 : select_2892);
  // hls/stages/count_bits.hpp:24
  logic parity_2899;
  assign parity_2899 = ^{less_1832_s24_q, less_1831_s24_q, less_1822_s24_q, less_1821_s24_q};
  // hls/stages/count_bits.hpp:25
  logic or_2903;
  assign or_2903 = ({less_1822_s24_q, less_1821_s24_q} == 2'h3) | (less_1831_s24_q & (less_1822_s24_q | less_1821_s24_q));
  logic and_2904;
  assign and_2904 = less_1832_s24_q & (^{less_1831_s24_q, less_1822_s24_q, less_1821_s24_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2905;
  assign xor_2905 = or_2903 ^ and_2904;
  // hls/stages/count_bits.hpp:27
  logic and_2906;
  assign and_2906 = or_2903 & and_2904;
  // hls/stages/patches.hpp:176
  logic [2:0] select_2908;
  assign select_2908 = or_1706_s24_q ? (and_1855_s24_q ? {and_2906, xor_2905, parity_2899} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:510
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2922_s24_q;
  // hls/stages/count_bits.hpp:24
  logic xor_2928;
  assign xor_2928 = bits[17] ^ (^{select_2922_s24_q[16:15], other[16:15]});
  logic xor_2931;
  assign xor_2931 = bits[11] ^ (^{select_2922_s24_q[10:9], other[10:9]});
  logic xor_2934;
  assign xor_2934 = bits[14] ^ (^{select_2922_s24_q[13:12], other[13:12]});
  logic xor_2937;
  assign xor_2937 = xor_2928 ^ (^{select_2922_s24_q[14:9], other[14:9]});
  logic xor_2940;
  assign xor_2940 = bits[47] ^ (^{select_2922_s24_q[46:45], other[46:45]});
  logic xor_2943;
  assign xor_2943 = bits[8] ^ (^{select_2922_s24_q[7:6], other[7:6]});
  logic xor_2946;
  assign xor_2946 = bits[2] ^ (^{select_2922_s24_q[1:0], other[1:0]});
  logic xor_2949;
  assign xor_2949 = bits[5] ^ (^{select_2922_s24_q[4:3], other[4:3]});
  logic xor_2952;
  assign xor_2952 = xor_2943 ^ (^{select_2922_s24_q[5:0], other[5:0]});
  logic parity_2954;
  assign parity_2954 = ^{select_2922_s24_q[47:45], select_2922_s24_q[8:0], other[47:45], other[8:0]};
  logic xor_2958;
  assign xor_2958 = bits[44] ^ (^{select_2922_s24_q[43:42], other[43:42]});
  logic xor_2961;
  assign xor_2961 = bits[38] ^ (^{select_2922_s24_q[37:36], other[37:36]});
  logic xor_2964;
  assign xor_2964 = bits[41] ^ (^{select_2922_s24_q[40:39], other[40:39]});
  logic xor_2970;
  assign xor_2970 = bits[26] ^ (^{select_2922_s24_q[25:24], other[25:24]});
  logic xor_2973;
  assign xor_2973 = bits[20] ^ (^{select_2922_s24_q[19:18], other[19:18]});
  logic xor_2976;
  assign xor_2976 = bits[23] ^ (^{select_2922_s24_q[22:21], other[22:21]});
  logic xor_2982;
  assign xor_2982 = bits[35] ^ (^{select_2922_s24_q[34:33], other[34:33]});
  logic xor_2985;
  assign xor_2985 = bits[29] ^ (^{select_2922_s24_q[28:27], other[28:27]});
  logic xor_2988;
  assign xor_2988 = bits[32] ^ (^{select_2922_s24_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:176
  logic select_3272;
  assign select_3272 = equal_1700_s24_q ? patches_summed_first_q : (equal_1702_s24_q ? new_row_s24_q : patches_summed_first_q);
  // hls/stages/patches.hpp:529
  logic [9:0] select_3360;
  assign select_3360 = (patches_read_far_s24_q < patches_peak_far_q) ? patches_read_far_s24_q : patches_peak_far_q;
  logic [9:0] select_3361;
  assign select_3361 = patches_read_first_s24_q ? patches_read_far_s24_q : select_3360;
  // hls/stages/patches.hpp:569
  logic [10:0] sum_3403;
  assign sum_3403 = {1'b0, fall_s24_q} + {2'h0, fall_s24_q[9:1]};
  // hls/stages/patches.hpp:570
  logic [10:0] sum_3407;
  assign sum_3407 = {1'b0, fall_s24_q} + {3'h0, fall_s24_q[9:2]};
  logic not_3412;
  assign not_3412 = ~({eight_s24_q, 3'h0} < ({fall_s24_q, 3'h0} - {3'h0, fall_s24_q}));
  // hls/stages/patches.hpp:583
  logic [7:0] select_3417;
  assign select_3417 = patches_second_s24_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:582
  logic [3:0] sum_3418;
  assign sum_3418 = {2'h0, select_3351_s24_q[14:13]} + 4'hf;
  logic [5:0] select_3419;
  assign select_3419 = patches_second_s24_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3420;
  assign sum_3420 = {select_3419[5], select_3419} + {{4{sum_3418[3]}}, sum_3418[3:1]};
  // hls/stages/patches.hpp:330
  logic select_3691;
  assign select_3691 = equal_1479_s24_q ? ((x_s24_q[6] & good_known_q) | equal_3579_s24_q) : good_known_q;
  // hls/stages/agreement.hpp:1235
  logic and_3853;
  assign and_3853 = and_2030_s24_q & ({sum_1956_s24_q, index_2_s24_q} == {sum_1943_s24_q, index_s24_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1330; read in stage 24, written in stage 25: 24 < 25 < 24 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_1943_s24_q, index_s24_q};
  logic map_re;
  assign map_re = s24_en & (and_1950_s24_q & less_1951_s24_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

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
      sharpness_sums_contrast_0_q <= and_510_s24_q ? sum_2217 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_510_s24_q ? sum_2221 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2525_s24_q ? 14'h0 : sum_2544;
      registration_half_measured_q <= select_2550;
      registration_half_votes_down_q <= and_2525_s24_q ? 7'h0 : sum_2556;
      registration_half_votes_up_q <= and_2525_s24_q ? 7'h0 : sum_2564;
      registration_half_half_votes_down_q <= and_2525_s24_q ? 7'h0 : sum_2571;
      registration_half_half_votes_up_q <= and_2525_s24_q ? 7'h0 : sum_2578;
      registration_down_q <= and_2612 ? sum_2631 : registration_down_q;
      registration_up_q <= and_2612 ? sum_2640 : registration_up_q;
      registration_enough_q <= select_2654;
      registration_votes_down_q <= and_2659 ? less_2660 : registration_votes_down_q;
      registration_votes_up_q <= and_2659 ? less_2662 : registration_votes_up_q;
      registration_other_enough_q <= and_2668 ? select_2654 : registration_other_enough_q;
      registration_other_down_q <= and_2668 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2668 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_column_q <= sample_pair_whole_s24_q ? select_1720 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s24_q ? select_1721 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2785;
      patches_place_1_column_q <= sample_pair_whole_s24_q ? select_1749 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s24_q ? select_1750 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2790;
      patches_codes_at_q <= select_2881;
      patches_codes_further_q <= equal_1700_s24_q ? patches_codes_further_q : select_2886;
      patches_next_codes_q <= select_2894;
      patches_summed_first_q <= select_3272;
      patches_peak_far_q <= equal_1700_s24_q ? select_3361 : patches_peak_far_q;
      good_known_q <= select_3691;
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
      census_columns_values_3_cell_4_mask_q <= select_2143;
      census_changes_values_0_left_q <= and_510_s24_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_510_s24_q ? sum_2163 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2165;
      census_changes_values_1_right_q <= select_2166;
      sharpness_last_detail_0_q <= select_2185;
      sharpness_last_detail_1_q <= select_2186;
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
  logic [3:0] select_471_s25_q;
  logic [6:0] select_474_s25_q;
  logic [6:0] column_s25_q;
  logic and_510_s25_q;
  logic so_s25_q;
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
  logic less_561_s25_q;
  logic less_562_s25_q;
  logic less_563_s25_q;
  logic less_564_s25_q;
  logic less_565_s25_q;
  logic less_566_s25_q;
  logic less_567_s25_q;
  logic and_575_s25_q;
  logic and_600_s25_q;
  logic and_601_s25_q;
  logic [12:0] sum_621_s25_q;
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
  logic and_1950_s25_q;
  logic less_1951_s25_q;
  logic [2:0] index_2_s25_q;
  logic [10:0] sum_1956_s25_q;
  logic is_seen_s25_q;
  logic and_2020_s25_q;
  logic and_2030_s25_q;
  logic equal_2170_s25_q;
  logic [12:0] sum_2171_s25_q;
  logic [12:0] select_2199_s25_q;
  logic [12:0] select_2211_s25_q;
  logic equal_2223_s25_q;
  logic less_2224_s25_q;
  logic and_2234_s25_q;
  logic and_2244_s25_q;
  logic equal_2267_s25_q;
  logic and_2410_s25_q;
  logic and_2455_s25_q;
  logic [9:0] select_2459_s25_q;
  logic [9:0] select_2462_s25_q;
  logic [9:0] select_2469_s25_q;
  logic and_2490_s25_q;
  logic equal_2664_s25_q;
  logic not_2677_s25_q;
  logic and_2699_s25_q;
  logic [8:0] other_s25_q;
  logic [2:0] select_2909_s25_q;
  logic [8:0] select_2922_s25_q;
  logic xor_2937_s25_q;
  logic xor_2955_s25_q;
  logic xor_2967_s25_q;
  logic xor_2979_s25_q;
  logic xor_2991_s25_q;
  logic or_3000_s25_q;
  logic or_3004_s25_q;
  logic or_3008_s25_q;
  logic or_3015_s25_q;
  logic or_3019_s25_q;
  logic or_3023_s25_q;
  logic or_3030_s25_q;
  logic or_3034_s25_q;
  logic or_3038_s25_q;
  logic or_3048_s25_q;
  logic or_3052_s25_q;
  logic or_3056_s25_q;
  logic or_3064_s25_q;
  logic or_3068_s25_q;
  logic or_3072_s25_q;
  logic or_3079_s25_q;
  logic or_3083_s25_q;
  logic or_3087_s25_q;
  logic or_3097_s25_q;
  logic or_3101_s25_q;
  logic or_3105_s25_q;
  logic and_3110_s25_q;
  logic or_3111_s25_q;
  logic equal_3232_s25_q;
  logic [4:0] select_3320_s25_q;
  logic [12:0] select_3351_s25_q;
  logic [9:0] select_3361_s25_q;
  logic less_3394_s25_q;
  logic not_3402_s25_q;
  logic not_3405_s25_q;
  logic not_3409_s25_q;
  logic not_3412_s25_q;
  logic [7:0] select_3417_s25_q;
  logic sum_3418_s25_q;
  logic [6:0] sum_3420_s25_q;
  logic equal_3472_s25_q;
  logic equal_3579_s25_q;
  logic or_3671_s25_q;
  logic select_3679_s25_q;
  logic equal_3692_s25_q;
  logic equal_3694_s25_q;
  logic equal_3695_s25_q;
  logic and_3838_s25_q;
  logic and_3853_s25_q;
  logic [31:0] select_3916_s25_q;
  logic [9:0] select_3923_s25_q;
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
      select_471_s25_q <= select_471_s24_q;
      select_474_s25_q <= select_474_s24_q;
      column_s25_q <= column_s24_q;
      and_510_s25_q <= and_510_s24_q;
      so_s25_q <= drew_q;
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
      less_561_s25_q <= less_561_s24_q;
      less_562_s25_q <= less_562_s24_q;
      less_563_s25_q <= less_563_s24_q;
      less_564_s25_q <= less_564_s24_q;
      less_565_s25_q <= less_565_s24_q;
      less_566_s25_q <= less_566_s24_q;
      less_567_s25_q <= less_567_s24_q;
      and_575_s25_q <= and_575_s24_q;
      and_600_s25_q <= whole_22 & and_575_s24_q;
      and_601_s25_q <= and_601_s24_q;
      sum_621_s25_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
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
      and_1950_s25_q <= and_1950_s24_q;
      less_1951_s25_q <= less_1951_s24_q;
      index_2_s25_q <= index_2_s24_q;
      sum_1956_s25_q <= sum_1956_s24_q;
      is_seen_s25_q <= is_seen;
      and_2020_s25_q <= is_seen & less_2019_s24_q;
      and_2030_s25_q <= and_2030_s24_q;
      equal_2170_s25_q <= equal_2170_s24_q;
      sum_2171_s25_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2163};
      select_2199_s25_q <= and_2197_s24_q ? detail_3[14:2] : 13'h0;
      select_2211_s25_q <= and_2209_s24_q ? detail_4[14:2] : 13'h0;
      equal_2223_s25_q <= equal_2223_s24_q;
      less_2224_s25_q <= less_2224_s24_q;
      and_2234_s25_q <= and_2234;
      and_2244_s25_q <= and_2244;
      equal_2267_s25_q <= equal_2267_s24_q;
      and_2410_s25_q <= and_2410_s24_q;
      and_2455_s25_q <= not_1480_s24_q & (drew_q & and_2453);
      select_2459_s25_q <= select_2459_s24_q;
      select_2462_s25_q <= select_2462_s24_q;
      select_2469_s25_q <= select_2469;
      and_2490_s25_q <= drew_q & (ends_cell_s24_q & (not_2433_s24_q & and_2487));
      equal_2664_s25_q <= equal_2664;
      not_2677_s25_q <= ~(equal_1479_s24_q & and_2675);
      and_2699_s25_q <= and_2699;
      other_s25_q <= other[44:36];
      select_2909_s25_q <= equal_1702_s24_q ? 3'h0 : select_2908;
      select_2922_s25_q <= select_2922_s24_q[44:36];
      xor_2937_s25_q <= xor_2937;
      xor_2955_s25_q <= xor_2937 ^ parity_2954;
      xor_2967_s25_q <= xor_2958 ^ (^{select_2922_s24_q[41:36], other[41:36]});
      xor_2979_s25_q <= xor_2970 ^ (^{select_2922_s24_q[23:18], other[23:18]});
      xor_2991_s25_q <= xor_2982 ^ (^{select_2922_s24_q[32:27], other[32:27]});
      or_3000_s25_q <= (xor_2931 & xor_2934) | (xor_2928 & (xor_2931 | xor_2934));
      or_3004_s25_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3008_s25_q <= (xor_2946 & xor_2949) | (xor_2943 & (xor_2946 | xor_2949));
      or_3015_s25_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3019_s25_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3023_s25_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3030_s25_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3034_s25_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3038_s25_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3048_s25_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3052_s25_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3056_s25_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3064_s25_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3068_s25_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3072_s25_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3079_s25_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3083_s25_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3087_s25_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3097_s25_q <= (xor_2961 & xor_2964) | (xor_2958 & (xor_2961 | xor_2964));
      or_3101_s25_q <= (xor_2973 & xor_2976) | (xor_2970 & (xor_2973 | xor_2976));
      or_3105_s25_q <= (xor_2985 & xor_2988) | (xor_2982 & (xor_2985 | xor_2988));
      and_3110_s25_q <= xor_2940 & xor_2952;
      or_3111_s25_q <= xor_2940 | xor_2952;
      equal_3232_s25_q <= equal_3232_s24_q;
      select_3320_s25_q <= select_3320_s24_q;
      select_3351_s25_q <= select_3351_s24_q[12:0];
      select_3361_s25_q <= select_3361;
      less_3394_s25_q <= less_3394_s24_q;
      not_3402_s25_q <= ~({eight_s24_q, 3'h0} < {3'h0, fall_s24_q});
      not_3405_s25_q <= ~({eight_s24_q, 3'h0} < {1'b0, sum_3403, fall_s24_q[0]});
      not_3409_s25_q <= ~({eight_s24_q, 3'h0} < {sum_3407, fall_s24_q[1:0]});
      not_3412_s25_q <= not_3412;
      select_3417_s25_q <= select_3417;
      sum_3418_s25_q <= sum_3418[0];
      sum_3420_s25_q <= sum_3420;
      equal_3472_s25_q <= equal_3472_s24_q;
      equal_3579_s25_q <= equal_3579_s24_q;
      or_3671_s25_q <= or_3671_s24_q;
      select_3679_s25_q <= select_3679_s24_q;
      equal_3692_s25_q <= equal_3692_s24_q;
      equal_3694_s25_q <= equal_3694_s24_q;
      equal_3695_s25_q <= equal_3695_s24_q;
      and_3838_s25_q <= said_q;
      and_3853_s25_q <= and_3853;
      select_3916_s25_q <= select_3916_s24_q;
      select_3923_s25_q <= select_3923_s24_q;
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
  logic [13:0] sum_622;
  assign sum_622 = {2'h0, census_changes_values_1_left_s25_q} + {1'b0, sum_621_s25_q};
  logic [13:0] sum_623;
  assign sum_623 = {2'h0, census_changes_values_2_left_q} + sum_622;
  // hls/stages/patches.hpp:119
  logic select_1718;
  assign select_1718 = equal_1610_s25_q ? patches_place_0_valid_q : (select_1609_s25_q ? patches_place_0_valid_q : select_1716_s25_q);
  // hls/stages/patches.hpp:315
  logic [7:0] sum_1723;
  assign sum_1723 = sum_1722_s25_q + 8'hff;
  // hls/stages/patches.hpp:123
  logic equal_1724;
  assign equal_1724 = {sum_1723[7], select_474_s25_q, select_471_s25_q} == {1'b0, sum_1723[6:0], 4'h8};
  // hls/stages/patches.hpp:119
  logic select_1747;
  assign select_1747 = equal_1610_s25_q ? patches_place_1_valid_q : (select_1609_s25_q ? select_1716_s25_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:315
  logic [7:0] sum_1752;
  assign sum_1752 = sum_1751_s25_q + 8'hff;
  // hls/stages/patches.hpp:123
  logic equal_1753;
  assign equal_1753 = {sum_1752[7], select_474_s25_q, select_471_s25_q} == {1'b0, sum_1752[6:0], 4'h8};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2167;
  assign select_2167 = and_510_s25_q ? census_changes_values_1_left_s25_q : census_changes_values_2_left_q;
  logic [11:0] select_2168;
  assign select_2168 = and_510_s25_q ? census_changes_values_1_right_s25_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [13:0] sum_2172;
  assign sum_2172 = {2'h0, census_changes_values_1_right_s25_q} + {1'b0, sum_2171_s25_q};
  logic [13:0] sum_2173;
  assign sum_2173 = {2'h0, census_changes_values_2_right_q} + sum_2172;
  // hls/stages/census.hpp:357
  logic [23:0] select_2201;
  assign select_2201 = equal_2170_s25_q ? {11'h0, select_2199_s25_q} : (sharpness_sums_detail_0_q + {11'h0, select_2199_s25_q});
  logic [23:0] select_2213;
  assign select_2213 = equal_2170_s25_q ? {11'h0, select_2211_s25_q} : (sharpness_sums_detail_1_q + {11'h0, select_2211_s25_q});
  // hls/stages/census.hpp:377
  logic [17:0] select_2236;
  assign select_2236 = (less_2224_s25_q & and_2234_s25_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2246;
  assign select_2246 = (less_2224_s25_q & and_2244_s25_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:207
  logic [1:0] select_2255;
  assign select_2255 = equal_2223_s25_q ? {sharpness_comparing_contrast_0_q[0], and_2244_s25_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2257;
  assign select_2257 = equal_2223_s25_q ? {sharpness_comparing_contrast_1_q[0], and_2234_s25_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:386
  logic xor_2280;
  assign xor_2280 = sharpness_comparing_contrast_0_q[1] ^ and_2234_s25_q;
  logic select_2283;
  assign select_2283 = (equal_2267_s25_q | xor_2280) ? (and_2234_s25_q & xor_2280) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2284;
  assign select_2284 = equal_2223_s25_q ? select_2283 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2286;
  assign xor_2286 = sharpness_comparing_contrast_1_q[1] ^ and_2244_s25_q;
  logic select_2289;
  assign select_2289 = (equal_2267_s25_q | xor_2286) ? (and_2244_s25_q & xor_2286) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2290;
  assign select_2290 = equal_2223_s25_q ? select_2289 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2457;
  assign select_2457 = and_2410_s25_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2455_s25_q});
  logic [13:0] select_2471;
  assign select_2471 = and_2410_s25_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2469_s25_q});
  // hls/stages/patches.hpp:330
  logic and_2491;
  assign and_2491 = not_1480_s25_q & and_2490_s25_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2493;
  assign select_2493 = and_2410_s25_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2491});
  // hls/stages/patches.hpp:159
  logic [9:0] sum_2912;
  assign sum_2912 = {7'h0, patches_set_q} + (equal_1705_s25_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_2992;
  assign xor_2992 = xor_2979_s25_q ^ xor_2991_s25_q;
  // hls/stages/count_bits.hpp:25
  logic or_3117;
  assign or_3117 = (xor_2979_s25_q & xor_2991_s25_q) | (xor_2967_s25_q & (xor_2979_s25_q | xor_2991_s25_q));
  // hls/stages/patches.hpp:569
  logic [1:0] sum_3406;
  assign sum_3406 = {1'b0, not_3402_s25_q} + {1'b0, not_3405_s25_q};
  // hls/stages/patches.hpp:570
  logic [1:0] sum_3413;
  assign sum_3413 = {1'b0, not_3409_s25_q} + {1'b0, not_3412_s25_q};
  // hls/stages/patches.hpp:569
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3406} + {1'b0, sum_3413};
  // hls/stages/patches.hpp:583
  logic [18:0] product_3421;
  assign product_3421 = $signed({{11{select_3417_s25_q[7]}}, select_3417_s25_q}) * $signed({{8{sum_3420_s25_q[6]}}, sum_3420_s25_q, sum_3418_s25_q, select_3351_s25_q[12:10]});
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3697;
  assign select_3697 = equal_3694_s25_q ? counts_skin_unproven_q : (equal_3695_s25_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3692_s25_q ? counts_nearer_s25_q : select_3697;
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3917;
  assign select_3917 = equal_1542_s25_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3916_s25_q;
  logic [31:0] select_3918;
  assign select_3918 = equal_1540_s25_q ? {8'h0, sharpness_sums_detail_0_q} : select_3917;
  logic [31:0] select_3919;
  assign select_3919 = equal_1538_s25_q ? {8'h0, sharpness_sums_detail_1_q} : select_3918;
  logic [31:0] select_3920;
  assign select_3920 = equal_1536_s25_q ? {8'h0, sharpness_sums_contrast_0_s25_q} : select_3919;
  logic [31:0] select_3921;
  assign select_3921 = equal_1534_s25_q ? {8'h0, sharpness_sums_contrast_1_s25_q} : select_3920;

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

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_1956_s25_q, index_2_s25_q};
  logic map_we;
  assign map_we = s25_en & and_2030_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2020_s25_q, is_seen_s25_q};
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
      sharpness_sums_detail_0_q <= and_510_s25_q ? select_2201 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_510_s25_q ? select_2213 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s25_q ? select_2255 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s25_q ? select_2257 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s25_q ? select_2284 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s25_q ? select_2290 : sharpness_comparing_less_contrast_1_q;
      counts_unproven_q <= select_2457;
      counts_regions_bad_q <= select_2471;
      counts_skin_unproven_q <= select_2493;
      registration_moved_q <= not_2677_s25_q & (registration_moved_q | and_2699_s25_q);
      patches_place_0_valid_q <= sample_pair_whole_s25_q ? select_1718 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s25_q ? select_1747 : patches_place_1_valid_q;
      patches_set_q <= equal_1700_s25_q ? 3'h0 : select_2909_s25_q;
      patches_size_q <= sum_2912;
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
      census_changes_values_2_left_q <= select_2167;
      census_changes_values_2_right_q <= select_2168;
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
  logic and_510_s26_q;
  logic so_s26_q;
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
  logic less_561_s26_q;
  logic less_562_s26_q;
  logic less_563_s26_q;
  logic less_564_s26_q;
  logic less_565_s26_q;
  logic less_566_s26_q;
  logic less_567_s26_q;
  logic and_575_s26_q;
  logic and_600_s26_q;
  logic and_601_s26_q;
  logic [8:0] sum_623_s26_q;
  logic equal_1479_s26_q;
  logic equal_1524_s26_q;
  logic equal_1532_s26_q;
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
  logic [1:0] map_rdata_s26_q;
  logic is_seen_s26_q;
  logic and_2020_s26_q;
  logic equal_2170_s26_q;
  logic [8:0] sum_2173_s26_q;
  logic equal_2223_s26_q;
  logic less_2224_s26_q;
  logic [17:0] select_2236_s26_q;
  logic [17:0] select_2246_s26_q;
  logic equal_2267_s26_q;
  logic [9:0] select_2459_s26_q;
  logic [9:0] select_2462_s26_q;
  logic equal_2664_s26_q;
  logic parity_2996_s26_q;
  logic or_3000_s26_q;
  logic or_3004_s26_q;
  logic or_3008_s26_q;
  logic or_3015_s26_q;
  logic or_3019_s26_q;
  logic or_3023_s26_q;
  logic or_3030_s26_q;
  logic or_3034_s26_q;
  logic or_3038_s26_q;
  logic or_3048_s26_q;
  logic or_3052_s26_q;
  logic or_3056_s26_q;
  logic or_3064_s26_q;
  logic or_3068_s26_q;
  logic or_3072_s26_q;
  logic or_3079_s26_q;
  logic or_3083_s26_q;
  logic or_3087_s26_q;
  logic or_3097_s26_q;
  logic or_3101_s26_q;
  logic or_3105_s26_q;
  logic and_3109_s26_q;
  logic or_3113_s26_q;
  logic or_3117_s26_q;
  logic equal_3232_s26_q;
  logic [4:0] select_3320_s26_q;
  logic [9:0] select_3351_s26_q;
  logic [9:0] select_3361_s26_q;
  logic less_3394_s26_q;
  logic [2:0] fraction_s26_q;
  logic [13:0] product_3421_s26_q;
  logic equal_3472_s26_q;
  logic equal_3579_s26_q;
  logic or_3671_s26_q;
  logic select_3679_s26_q;
  logic and_3693_s26_q;
  logic [13:0] before_v_4_s26_q;
  logic not_3730_s26_q;
  logic or_3734_s26_q;
  logic and_3838_s26_q;
  logic and_3853_s26_q;
  logic not_3868_s26_q;
  logic [31:0] select_3921_s26_q;
  logic [9:0] select_3923_s26_q;
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
      and_510_s26_q <= and_510_s25_q;
      so_s26_q <= so_s25_q;
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
      less_561_s26_q <= less_561_s25_q;
      less_562_s26_q <= less_562_s25_q;
      less_563_s26_q <= less_563_s25_q;
      less_564_s26_q <= less_564_s25_q;
      less_565_s26_q <= less_565_s25_q;
      less_566_s26_q <= less_566_s25_q;
      less_567_s26_q <= less_567_s25_q;
      and_575_s26_q <= and_575_s25_q;
      and_600_s26_q <= and_600_s25_q;
      and_601_s26_q <= and_601_s25_q;
      sum_623_s26_q <= sum_623[13:5];
      equal_1479_s26_q <= equal_1479_s25_q;
      equal_1524_s26_q <= equal_1524_s25_q;
      equal_1532_s26_q <= equal_1532_s25_q;
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
      map_rdata_s26_q <= map_rdata_q;
      is_seen_s26_q <= is_seen_s25_q;
      and_2020_s26_q <= and_2020_s25_q;
      equal_2170_s26_q <= equal_2170_s25_q;
      sum_2173_s26_q <= sum_2173[13:5];
      equal_2223_s26_q <= equal_2223_s25_q;
      less_2224_s26_q <= less_2224_s25_q;
      select_2236_s26_q <= select_2236;
      select_2246_s26_q <= select_2246;
      equal_2267_s26_q <= equal_2267_s25_q;
      select_2459_s26_q <= select_2459_s25_q;
      select_2462_s26_q <= select_2462_s25_q;
      equal_2664_s26_q <= equal_2664_s25_q;
      parity_2996_s26_q <= ^{xor_2992, xor_2955_s25_q, select_2922_s25_q, other_s25_q};
      or_3000_s26_q <= or_3000_s25_q;
      or_3004_s26_q <= or_3004_s25_q;
      or_3008_s26_q <= or_3008_s25_q;
      or_3015_s26_q <= or_3015_s25_q;
      or_3019_s26_q <= or_3019_s25_q;
      or_3023_s26_q <= or_3023_s25_q;
      or_3030_s26_q <= or_3030_s25_q;
      or_3034_s26_q <= or_3034_s25_q;
      or_3038_s26_q <= or_3038_s25_q;
      or_3048_s26_q <= or_3048_s25_q;
      or_3052_s26_q <= or_3052_s25_q;
      or_3056_s26_q <= or_3056_s25_q;
      or_3064_s26_q <= or_3064_s25_q;
      or_3068_s26_q <= or_3068_s25_q;
      or_3072_s26_q <= or_3072_s25_q;
      or_3079_s26_q <= or_3079_s25_q;
      or_3083_s26_q <= or_3083_s25_q;
      or_3087_s26_q <= or_3087_s25_q;
      or_3097_s26_q <= or_3097_s25_q;
      or_3101_s26_q <= or_3101_s25_q;
      or_3105_s26_q <= or_3105_s25_q;
      and_3109_s26_q <= xor_2955_s25_q & (^{xor_2992, select_2922_s25_q, other_s25_q});
      or_3113_s26_q <= and_3110_s25_q | (xor_2937_s25_q & or_3111_s25_q);
      or_3117_s26_q <= or_3117;
      equal_3232_s26_q <= equal_3232_s25_q;
      select_3320_s26_q <= select_3320_s25_q;
      select_3351_s26_q <= select_3351_s25_q[9:0];
      select_3361_s26_q <= select_3361_s25_q;
      less_3394_s26_q <= less_3394_s25_q;
      fraction_s26_q <= fraction;
      product_3421_s26_q <= product_3421[18:5];
      equal_3472_s26_q <= equal_3472_s25_q;
      equal_3579_s26_q <= equal_3579_s25_q;
      or_3671_s26_q <= or_3671_s25_q;
      select_3679_s26_q <= select_3679_s25_q;
      and_3693_s26_q <= equal_3692_s25_q & equal_3472_s25_q;
      before_v_4_s26_q <= before_v_4;
      not_3730_s26_q <= ~(equal_3695_s25_q & equal_3472_s25_q);
      or_3734_s26_q <= (equal_3695_s25_q | equal_3694_s25_q) | (x_s25_q[6:3] == 4'hf);
      and_3838_s26_q <= and_3838_s25_q;
      and_3853_s26_q <= and_3853_s25_q;
      not_3868_s26_q <= ~proven_q;
      select_3921_s26_q <= select_3921;
      select_3923_s26_q <= select_3923_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic hides_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1769;
  assign select_1769 = or_1768_s26_q ? {and_1592_s26_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1773;
  assign select_1773 = or_1772_s26_q ? {and_1592_s26_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:134
  logic [3:0] column_5;
  assign column_5 = select_1769[4] ? select_1773[3:0] : select_1769[3:0];
  logic and_1778;
  assign and_1778 = select_1736_s26_q & (select_1730_s26_q[3] ^ select_1730_s26_q[4]);
  logic and_1783;
  assign and_1783 = sample_pair_whole_s26_q & (and_1778 & ((~select_1769[4]) | (~select_1773[4])));
  // hls/stages/census.hpp:377
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2236_s26_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2239;
  assign select_2239 = equal_2223_s26_q ? (less_2224_s26_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:377
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2246_s26_q};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2249;
  assign select_2249 = equal_2223_s26_q ? (less_2224_s26_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2809;
  assign select_2809 = sample_pair_whole_s26_q ? (select_1769[4] ? {1'b1, select_1769[3:0]} : (select_1769 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2812;
  assign select_2812 = sample_pair_whole_s26_q ? (select_1773[4] ? {1'b1, select_1773[3:0]} : (select_1773 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3026;
  assign parity_3026 = ^{or_3023_s26_q, or_3019_s26_q, or_3015_s26_q};
  logic parity_3041;
  assign parity_3041 = ^{or_3038_s26_q, or_3034_s26_q, or_3030_s26_q};
  logic parity_3044;
  assign parity_3044 = ^{or_3038_s26_q, or_3034_s26_q, or_3030_s26_q, or_3023_s26_q, or_3019_s26_q, or_3015_s26_q, or_3008_s26_q, or_3004_s26_q, or_3000_s26_q};
  logic parity_3075;
  assign parity_3075 = ^{or_3072_s26_q, or_3068_s26_q, or_3064_s26_q};
  logic parity_3090;
  assign parity_3090 = ^{or_3087_s26_q, or_3083_s26_q, or_3079_s26_q};
  logic parity_3093;
  assign parity_3093 = ^{or_3087_s26_q, or_3083_s26_q, or_3079_s26_q, or_3072_s26_q, or_3068_s26_q, or_3064_s26_q, or_3056_s26_q, or_3052_s26_q, or_3048_s26_q};
  logic parity_3108;
  assign parity_3108 = ^{or_3105_s26_q, or_3101_s26_q, or_3097_s26_q};
  logic parity_3120;
  assign parity_3120 = ^{or_3117_s26_q, or_3113_s26_q, and_3109_s26_q};
  logic parity_3123;
  assign parity_3123 = ^{or_3117_s26_q, or_3113_s26_q, and_3109_s26_q, or_3105_s26_q, or_3101_s26_q, or_3097_s26_q, or_3087_s26_q, or_3083_s26_q, or_3079_s26_q, or_3072_s26_q, or_3068_s26_q, or_3064_s26_q, or_3056_s26_q, or_3052_s26_q, or_3048_s26_q};
  logic parity_3125;
  assign parity_3125 = ^{or_3117_s26_q, or_3113_s26_q, and_3109_s26_q, or_3105_s26_q, or_3101_s26_q, or_3097_s26_q, or_3087_s26_q, or_3083_s26_q, or_3079_s26_q, or_3072_s26_q, or_3068_s26_q, or_3064_s26_q, or_3056_s26_q, or_3052_s26_q, or_3048_s26_q, or_3038_s26_q, or_3034_s26_q, or_3030_s26_q, or_3023_s26_q, or_3019_s26_q, or_3015_s26_q, or_3008_s26_q, or_3004_s26_q, or_3000_s26_q};
  // hls/stages/count_bits.hpp:25
  logic and_3126;
  assign and_3126 = parity_3044 & parity_3123;
  logic and_3129;
  assign and_3129 = (^{or_3008_s26_q, or_3004_s26_q, or_3000_s26_q}) & (parity_3026 | parity_3041);
  logic or_3130;
  assign or_3130 = (parity_3026 & parity_3041) | and_3129;
  logic or_3134;
  assign or_3134 = (parity_3108 & parity_3120) | (parity_3093 & (parity_3108 | parity_3120));
  logic and_3140;
  assign and_3140 = (^{or_3056_s26_q, or_3052_s26_q, or_3048_s26_q}) & (parity_3075 | parity_3090);
  logic or_3141;
  assign or_3141 = (parity_3075 & parity_3090) | and_3140;
  logic or_3145;
  assign or_3145 = (or_3101_s26_q & or_3105_s26_q) | (or_3097_s26_q & (or_3101_s26_q | or_3105_s26_q));
  logic or_3149;
  assign or_3149 = (or_3113_s26_q & or_3117_s26_q) | (and_3109_s26_q & (or_3113_s26_q | or_3117_s26_q));
  // hls/stages/count_bits.hpp:23
  logic or_3156;
  assign or_3156 = (or_3052_s26_q & or_3056_s26_q) | (or_3048_s26_q & (or_3052_s26_q | or_3056_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3160;
  assign or_3160 = (or_3068_s26_q & or_3072_s26_q) | (or_3064_s26_q & (or_3068_s26_q | or_3072_s26_q));
  logic or_3164;
  assign or_3164 = (or_3083_s26_q & or_3087_s26_q) | (or_3079_s26_q & (or_3083_s26_q | or_3087_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3167;
  assign parity_3167 = ^{or_3164, or_3160, or_3156};
  // hls/stages/count_bits.hpp:23
  logic or_3171;
  assign or_3171 = (or_3004_s26_q & or_3008_s26_q) | (or_3000_s26_q & (or_3004_s26_q | or_3008_s26_q));
  // hls/stages/count_bits.hpp:25
  logic or_3175;
  assign or_3175 = (or_3019_s26_q & or_3023_s26_q) | (or_3015_s26_q & (or_3019_s26_q | or_3023_s26_q));
  logic or_3179;
  assign or_3179 = (or_3034_s26_q & or_3038_s26_q) | (or_3030_s26_q & (or_3034_s26_q | or_3038_s26_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3182;
  assign parity_3182 = ^{or_3179, or_3175, or_3171};
  logic parity_3185;
  assign parity_3185 = ^{or_3179, or_3175, or_3171, or_3164, or_3160, or_3156, or_3149, or_3145, or_3141};
  // hls/stages/patches.hpp:580
  logic [9:0] difference_3364;
  assign difference_3364 = select_3361_s26_q - select_3351_s26_q;
  // hls/stages/patches.hpp:585
  logic or_3371;
  assign or_3371 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3351_s26_q);
  // hls/stages/patches.hpp:571
  logic [1:0] sum_3395;
  assign sum_3395 = select_3320_s26_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:572
  logic [7:0] difference_3415;
  assign difference_3415 = {sum_3395, select_3320_s26_q[2:0], 3'h0} - {5'h0, fraction_s26_q};
  logic [7:0] select_3416;
  assign select_3416 = less_3394_s26_q ? difference_3415 : {sum_3395, select_3320_s26_q[2:0], fraction_s26_q};
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_s26_q} - {1'b0, before_v_4_s26_q};
  // hls/stages/agreement.hpp:1161
  logic select_3700;
  assign select_3700 = and_3693_s26_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1235
  logic [1:0] select_3854;
  assign select_3854 = and_3853_s26_q ? {and_2020_s26_q, is_seen_s26_q} : map_rdata_s26_q;
  // hls/stages/agreement.hpp:1236
  logic and_3855;
  assign and_3855 = proven_q & less_3843;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      hides_q <= 1'b0;
    end else if (s26_en) begin
      sharpness_comparing_rest_0_q <= so_s26_q ? select_2239 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s26_q ? select_2249 : sharpness_comparing_rest_1_q;
      patches_left_next_0_q <= select_2809;
      patches_left_next_1_q <= select_2812;
      hides_q <= equal_1479_s26_q ? select_3700 : hides_q;
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
  logic and_510_s27_q;
  logic so_s27_q;
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
  logic less_561_s27_q;
  logic less_562_s27_q;
  logic less_563_s27_q;
  logic less_564_s27_q;
  logic less_565_s27_q;
  logic less_566_s27_q;
  logic less_567_s27_q;
  logic and_575_s27_q;
  logic and_600_s27_q;
  logic and_601_s27_q;
  logic less_624_s27_q;
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
  logic equal_2170_s27_q;
  logic and_2175_s27_q;
  logic equal_2223_s27_q;
  logic sum_s27_q;
  logic sum_2_s27_q;
  logic equal_2267_s27_q;
  logic select_2285_s27_q;
  logic select_2291_s27_q;
  logic [9:0] select_2459_s27_q;
  logic [9:0] select_2462_s27_q;
  logic equal_2664_s27_q;
  logic parity_2996_s27_q;
  logic parity_3125_s27_q;
  logic and_3126_s27_q;
  logic or_3130_s27_q;
  logic or_3134_s27_q;
  logic or_3141_s27_q;
  logic or_3145_s27_q;
  logic or_3149_s27_q;
  logic or_3156_s27_q;
  logic or_3160_s27_q;
  logic or_3164_s27_q;
  logic or_3171_s27_q;
  logic or_3175_s27_q;
  logic or_3179_s27_q;
  logic parity_3185_s27_q;
  logic or_3195_s27_q;
  logic or_3199_s27_q;
  logic and_3206_s27_q;
  logic and_3208_s27_q;
  logic and_3210_s27_q;
  logic equal_3232_s27_q;
  logic equal_3363_s27_q;
  logic less_3365_s27_q;
  logic less_3366_s27_q;
  logic or_3371_s27_q;
  logic [7:0] select_3416_s27_q;
  logic [13:0] product_3421_s27_q;
  logic equal_3472_s27_q;
  logic equal_3579_s27_q;
  logic or_3671_s27_q;
  logic select_3679_s27_q;
  logic select_3700_s27_q;
  logic and_3728_s27_q;
  logic not_3730_s27_q;
  logic or_3734_s27_q;
  logic and_3838_s27_q;
  logic and_3856_s27_q;
  logic and_3859_s27_q;
  logic not_3868_s27_q;
  logic [31:0] select_3921_s27_q;
  logic [9:0] select_3923_s27_q;
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
      and_510_s27_q <= and_510_s26_q;
      so_s27_q <= so_s26_q;
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
      less_561_s27_q <= less_561_s26_q;
      less_562_s27_q <= less_562_s26_q;
      less_563_s27_q <= less_563_s26_q;
      less_564_s27_q <= less_564_s26_q;
      less_565_s27_q <= less_565_s26_q;
      less_566_s27_q <= less_566_s26_q;
      less_567_s27_q <= less_567_s26_q;
      and_575_s27_q <= and_575_s26_q;
      and_600_s27_q <= and_600_s26_q;
      and_601_s27_q <= and_601_s26_q;
      less_624_s27_q <= 9'h4 < sum_623_s26_q;
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
      equal_2170_s27_q <= equal_2170_s26_q;
      and_2175_s27_q <= and_600_s26_q & (9'h4 < sum_2173_s26_q);
      equal_2223_s27_q <= equal_2223_s26_q;
      sum_s27_q <= sum[0];
      sum_2_s27_q <= sum_2[0];
      equal_2267_s27_q <= equal_2267_s26_q;
      select_2285_s27_q <= sharpness_comparing_less_contrast_0_q;
      select_2291_s27_q <= sharpness_comparing_less_contrast_1_q;
      select_2459_s27_q <= select_2459_s26_q;
      select_2462_s27_q <= select_2462_s26_q;
      equal_2664_s27_q <= equal_2664_s26_q;
      parity_2996_s27_q <= parity_2996_s26_q;
      parity_3125_s27_q <= parity_3125;
      and_3126_s27_q <= and_3126;
      or_3130_s27_q <= or_3130;
      or_3134_s27_q <= or_3134;
      or_3141_s27_q <= or_3141;
      or_3145_s27_q <= or_3145;
      or_3149_s27_q <= or_3149;
      or_3156_s27_q <= or_3156;
      or_3160_s27_q <= or_3160;
      or_3164_s27_q <= or_3164;
      or_3171_s27_q <= or_3171;
      or_3175_s27_q <= or_3175;
      or_3179_s27_q <= or_3179;
      parity_3185_s27_q <= parity_3185;
      or_3195_s27_q <= (or_3160 & or_3164) | (or_3156 & (or_3160 | or_3164));
      or_3199_s27_q <= (or_3175 & or_3179) | (or_3171 & (or_3175 | or_3179));
      and_3206_s27_q <= and_3126 & (or_3130 | or_3134);
      and_3208_s27_q <= parity_3167 & parity_3182;
      and_3210_s27_q <= (^{or_3149, or_3145, or_3141}) & (parity_3167 | parity_3182);
      equal_3232_s27_q <= equal_3232_s26_q;
      equal_3363_s27_q <= select_3320_s26_q[3:0] == 4'h0;
      less_3365_s27_q <= {difference_3364, 3'h0} < {3'h0, patches_size_q};
      less_3366_s27_q <= select_3361_s26_q < select_3351_s26_q;
      or_3371_s27_q <= or_3371;
      select_3416_s27_q <= select_3416;
      product_3421_s27_q <= product_3421_s26_q;
      equal_3472_s27_q <= equal_3472_s26_q;
      equal_3579_s27_q <= equal_3579_s26_q;
      or_3671_s27_q <= or_3671_s26_q;
      select_3679_s27_q <= select_3679_s26_q;
      select_3700_s27_q <= select_3700;
      and_3728_s27_q <= over[14] & equal_3472_s26_q;
      not_3730_s27_q <= not_3730_s26_q;
      or_3734_s27_q <= or_3734_s26_q;
      and_3838_s27_q <= and_3838_s26_q;
      and_3856_s27_q <= select_3854[0] & and_3855;
      and_3859_s27_q <= select_3854[1] & and_3855;
      not_3868_s27_q <= not_3868_s26_q;
      select_3921_s27_q <= select_3921_s26_q;
      select_3923_s27_q <= select_3923_s26_q;
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
  logic and_625;
  assign and_625 = and_575_s27_q & less_624_s27_q;
  // hls/stages/patches.hpp:125
  logic [5:0] select_1737;
  assign select_1737 = or_1726_s27_q ? {and_1592_s27_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:129
  logic and_1739;
  assign and_1739 = select_1736_s27_q & (~select_1737[5]);
  // hls/stages/patches.hpp:125
  logic [5:0] select_1757;
  assign select_1757 = or_1755_s27_q ? {and_1592_s27_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:129
  logic and_1759;
  assign and_1759 = select_1736_s27_q & (~select_1757[5]);
  // hls/stages/census.hpp:306
  logic and_2176;
  assign and_2176 = and_600_s27_q & less_624_s27_q;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2177;
  assign sum_2177 = census_left_misses_q + {{17{and_2176}}, and_2175_s27_q, 1'b0, and_2175_s27_q};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2179;
  assign select_2179 = and_510_s27_q ? (equal_2170_s27_q ? 20'h0 : sum_2177) : census_left_misses_q;
  // hls/stages/agreement.hpp:207
  logic [2:0] select_2251;
  assign select_2251 = equal_2223_s27_q ? {sharpness_comparing_product_0_q[1:0], sum_s27_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2253;
  assign select_2253 = equal_2223_s27_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s27_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s27_q});
  // hls/stages/agreement.hpp:207
  logic select_2262;
  assign select_2262 = so_s27_q ? (equal_2223_s27_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s27_q});
  // hls/stages/agreement.hpp:207
  logic select_2265;
  assign select_2265 = equal_2223_s27_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:385
  logic xor_2268;
  assign xor_2268 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2274;
  assign xor_2274 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:119
  logic select_2792;
  assign select_2792 = equal_1610_s27_q ? patches_valid_0_q : (select_1609_s27_q ? patches_valid_0_q : select_1716_s27_q);
  // hls/stages/agreement.hpp:263
  logic select_2795;
  assign select_2795 = sample_pair_whole_s27_q ? (and_1739 ? (sample_present_s27_q & select_2792) : select_2792) : patches_valid_0_q;
  // hls/stages/patches.hpp:119
  logic select_2797;
  assign select_2797 = equal_1610_s27_q ? patches_valid_1_q : (select_1609_s27_q ? select_1716_s27_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2800;
  assign select_2800 = sample_pair_whole_s27_q ? (and_1759 ? (sample_present_s27_q & select_2797) : select_2797) : patches_valid_1_q;
  logic [5:0] select_2803;
  assign select_2803 = sample_pair_whole_s27_q ? (select_1737[5] ? {1'b1, select_1737[4:0]} : (select_1737 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2806;
  assign select_2806 = sample_pair_whole_s27_q ? (select_1757[5] ? {1'b1, select_1757[4:0]} : (select_1757 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3187;
  assign parity_3187 = ^{or_3179_s27_q, or_3175_s27_q, or_3171_s27_q, or_3164_s27_q, or_3160_s27_q, or_3156_s27_q, or_3149_s27_q, or_3145_s27_q, or_3141_s27_q, or_3134_s27_q, or_3130_s27_q, and_3126_s27_q};
  // hls/stages/count_bits.hpp:25
  logic or_3191;
  assign or_3191 = (or_3145_s27_q & or_3149_s27_q) | (or_3141_s27_q & (or_3145_s27_q | or_3149_s27_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3202;
  assign parity_3202 = ^{or_3199_s27_q, or_3195_s27_q, or_3191};
  // hls/stages/count_bits.hpp:25
  logic and_3203;
  assign and_3203 = (^{or_3134_s27_q, or_3130_s27_q, and_3126_s27_q}) & parity_3185_s27_q;
  logic or_3207;
  assign or_3207 = (or_3130_s27_q & or_3134_s27_q) | and_3206_s27_q;
  logic or_3211;
  assign or_3211 = and_3208_s27_q | and_3210_s27_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3214;
  assign parity_3214 = ^{or_3211, or_3207, and_3203};
  // hls/stages/count_bits.hpp:25
  logic and_3216;
  assign and_3216 = parity_3202 & parity_3214;
  logic or_3220;
  assign or_3220 = (or_3195_s27_q & or_3199_s27_q) | (or_3191 & (or_3195_s27_q | or_3199_s27_q));
  logic or_3224;
  assign or_3224 = (or_3207 & or_3211) | (and_3203 & (or_3207 | or_3211));
  // hls/stages/patches.hpp:585
  logic or_3372;
  assign or_3372 = (~(patches_second_s27_q ? patches_valid_1_q : patches_valid_0_q)) | or_3371_s27_q;
  logic or_3375;
  assign or_3375 = equal_3363_s27_q | (less_3365_s27_q | (less_3366_s27_q | or_3372));
  // hls/stages/patches.hpp:584
  logic [14:0] difference_3422;
  assign difference_3422 = {{7{select_3416_s27_q[7]}}, select_3416_s27_q} - {product_3421_s27_q[13], product_3421_s27_q};
  // hls/stages/patches.hpp:590
  logic less_3423;
  assign less_3423 = $signed({{8{difference_3393[6]}}, difference_3393}) < $signed(difference_3422);
  // hls/stages/agreement.hpp:1086
  logic not_3701;
  assign not_3701 = ~hidden_for_q[7];
  logic [7:0] select_3703;
  assign select_3703 = select_3700_s27_q ? (hidden_for_q + {7'h0, not_3701}) : 8'h0;
  // hls/stages/patches.hpp:330
  logic [7:0] select_3705;
  assign select_3705 = equal_1479_s27_q ? (equal_3579_s27_q ? select_3703 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1159
  logic and_3731;
  assign and_3731 = too_much_q & not_3730_s27_q;
  // hls/stages/agreement.hpp:1160
  logic select_3736;
  assign select_3736 = and_3728_s27_q ? (and_3731 | or_3734_s27_q) : and_3731;
  // hls/stages/agreement.hpp:424
  logic select_3858;
  assign select_3858 = and_1950_s27_q ? (less_1951_s27_q ? and_3856_s27_q : seen_q) : seen_q;
  logic select_3861;
  assign select_3861 = and_1950_s27_q ? (less_1951_s27_q ? and_3859_s27_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1088
  logic or_3887;
  assign or_3887 = select_2285_s27_q | ($signed(20'h0) < $signed(census_left_misses_q));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s27_q;
  logic fresh_we;
  assign fresh_we = s27_en & and_510_s27_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s27_q, and_625, and_601_s27_q, and_600_s27_q, and_575_s27_q, less_567_s27_q, less_566_s27_q, less_565_s27_q, less_564_s27_q, less_563_s27_q, less_562_s27_q, less_561_s27_q, less_560_s27_q, less_559_s27_q, less_558_s27_q, less_557_s27_q, less_556_s27_q, less_555_s27_q, less_554_s27_q, less_553_s27_q, less_552_s27_q, less_551_s27_q, less_550_s27_q, less_549_s27_q, less_548_s27_q, less_547_s27_q, less_546_s27_q, less_545_s27_q, less_544_s27_q};
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
      census_left_misses_q <= select_2179;
      sharpness_comparing_product_0_q <= so_s27_q ? select_2251 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s27_q ? select_2253 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2262;
      sharpness_comparing_carry_1_q <= so_s27_q ? select_2265 : sharpness_comparing_carry_1_q;
      patches_valid_0_q <= select_2795;
      patches_valid_1_q <= select_2800;
      patches_right_next_0_q <= select_2803;
      patches_right_next_1_q <= select_2806;
      hidden_for_q <= select_3705;
      too_much_q <= equal_1479_s27_q ? select_3736 : too_much_q;
      seen_q <= select_3858;
      nearer_q <= select_3861;
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
  logic equal_2223_s28_q;
  logic or_2269_s28_q;
  logic and_2270_s28_q;
  logic or_2275_s28_q;
  logic and_2276_s28_q;
  logic select_2291_s28_q;
  logic [9:0] select_2459_s28_q;
  logic [9:0] select_2462_s28_q;
  logic equal_2664_s28_q;
  logic parity_2996_s28_q;
  logic parity_3125_s28_q;
  logic parity_3187_s28_q;
  logic xor_3215_s28_q;
  logic parity_3227_s28_q;
  logic and_3228_s28_q;
  logic and_3230_s28_q;
  logic equal_3232_s28_q;
  logic or_3375_s28_q;
  logic [5:0] difference_3422_s28_q;
  logic not_3424_s28_q;
  logic not_3434_s28_q;
  logic equal_3472_s28_q;
  logic less_3546_s28_q;
  logic less_3547_s28_q;
  logic equal_3579_s28_q;
  logic or_3671_s28_q;
  logic and_3838_s28_q;
  logic not_3868_s28_q;
  logic or_3878_s28_q;
  logic or_3887_s28_q;
  logic not_3899_s28_q;
  logic [31:0] select_3921_s28_q;
  logic [9:0] select_3923_s28_q;
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
      equal_2223_s28_q <= equal_2223_s27_q;
      or_2269_s28_q <= equal_2267_s27_q | xor_2268;
      and_2270_s28_q <= five_times[0] & xor_2268;
      or_2275_s28_q <= equal_2267_s27_q | xor_2274;
      and_2276_s28_q <= five_times_2[0] & xor_2274;
      select_2291_s28_q <= select_2291_s27_q;
      select_2459_s28_q <= select_2459_s27_q;
      select_2462_s28_q <= select_2462_s27_q;
      equal_2664_s28_q <= equal_2664_s27_q;
      parity_2996_s28_q <= parity_2996_s27_q;
      parity_3125_s28_q <= parity_3125_s27_q;
      parity_3187_s28_q <= parity_3187;
      xor_3215_s28_q <= parity_3202 ^ parity_3214;
      parity_3227_s28_q <= ^{or_3224, or_3220, and_3216};
      and_3228_s28_q <= or_3220 & or_3224;
      and_3230_s28_q <= and_3216 & (or_3220 | or_3224);
      equal_3232_s28_q <= equal_3232_s27_q;
      or_3375_s28_q <= or_3375;
      difference_3422_s28_q <= difference_3422[5:0];
      not_3424_s28_q <= ~less_3423;
      not_3434_s28_q <= ~($signed(difference_3422) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3472_s28_q <= equal_3472_s27_q;
      less_3546_s28_q <= $signed(15'h10) < $signed(difference_3422);
      less_3547_s28_q <= $signed(difference_3422[14:4]) < $signed(11'h7ff);
      equal_3579_s28_q <= equal_3579_s27_q;
      or_3671_s28_q <= or_3671_s27_q;
      and_3838_s28_q <= and_3838_s27_q;
      not_3868_s28_q <= not_3868_s27_q;
      or_3878_s28_q <= select_3679_s27_q | select_3736;
      or_3887_s28_q <= or_3887;
      not_3899_s28_q <= ~(select_3703 < cfg_hidden_frames_i);
      select_3921_s28_q <= select_3921_s27_q;
      select_3923_s28_q <= select_3923_s27_q;
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
  logic patches_frame_ended_q;
  // hls/stages/patches.hpp:176
  logic less_1873;
  assign less_1873 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:177
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
  // hls/stages/census.hpp:385
  logic select_2271;
  assign select_2271 = or_2269_s28_q ? and_2270_s28_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2272;
  assign select_2272 = equal_2223_s28_q ? select_2271 : sharpness_comparing_less_detail_0_q;
  logic select_2273;
  assign select_2273 = so_s28_q ? select_2272 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic select_2277;
  assign select_2277 = or_2275_s28_q ? and_2276_s28_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2278;
  assign select_2278 = equal_2223_s28_q ? select_2277 : sharpness_comparing_less_detail_1_q;
  logic select_2279;
  assign select_2279 = so_s28_q ? select_2278 : sharpness_comparing_less_detail_1_q;
  // hls/stages/count_bits.hpp:27
  logic or_3231;
  assign or_3231 = and_3228_s28_q | and_3230_s28_q;
  // hls/stages/patches.hpp:511
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3231, parity_3227_s28_q, xor_3215_s28_q, parity_3187_s28_q, parity_3125_s28_q, parity_2996_s28_q} + (equal_3232_s28_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:176
  logic [9:0] select_3236;
  assign select_3236 = equal_1700_s28_q ? patches_sums_values_0_q : (equal_1702_s28_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3237;
  assign select_3237 = equal_1702_s28_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3239;
  assign select_3239 = equal_1702_s28_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3241;
  assign select_3241 = equal_1702_s28_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3243;
  assign select_3243 = equal_1702_s28_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3245;
  assign select_3245 = equal_1702_s28_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3247;
  assign select_3247 = equal_1702_s28_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3249;
  assign select_3249 = equal_1702_s28_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3251;
  assign select_3251 = equal_1702_s28_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3253;
  assign select_3253 = equal_1702_s28_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3255;
  assign select_3255 = equal_1702_s28_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3257;
  assign select_3257 = equal_1702_s28_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3259;
  assign select_3259 = equal_1702_s28_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3261;
  assign select_3261 = equal_1702_s28_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3263;
  assign select_3263 = equal_1702_s28_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3265;
  assign select_3265 = equal_1702_s28_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3267;
  assign select_3267 = equal_1702_s28_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:565
  logic not_3376;
  assign not_3376 = ~or_3375_s28_q;
  // hls/stages/patches.hpp:546
  logic and_3377;
  assign and_3377 = equal_1864_s28_q & not_3376;
  // hls/stages/patches.hpp:176
  logic and_3380;
  assign and_3380 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3377) : and_3377);
  // hls/stages/patches.hpp:546
  logic and_3383;
  assign and_3383 = equal_1864_s28_q & (patches_second_s28_q & not_3376);
  // hls/stages/patches.hpp:176
  logic and_3386;
  assign and_3386 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3383) : and_3383);
  // hls/stages/patches.hpp:546
  logic and_3426;
  assign and_3426 = equal_1864_s28_q & (not_3376 & not_3424_s28_q);
  // hls/stages/patches.hpp:176
  logic and_3429;
  assign and_3429 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3426) : and_3426);
  // hls/stages/patches.hpp:546
  logic and_3436;
  assign and_3436 = equal_1864_s28_q & (not_3376 & not_3434_s28_q);
  // hls/stages/patches.hpp:176
  logic and_3439;
  assign and_3439 = equal_1700_s28_q & (less_1861_s28_q ? (not_1863_s28_q & and_3436) : and_3436);
  // hls/stages/agreement.hpp:1072
  logic less_3473;
  assign less_3473 = x_s28_q[5:3] < 3'h3;
  // hls/stages/patches.hpp:330
  logic and_3477;
  assign and_3477 = equal_1479_s28_q & (x_s28_q[6] & (not_1890_s28_q & (equal_3472_s28_q & less_3473)));
  // hls/stages/agreement.hpp:1084
  logic and_3482;
  assign and_3482 = x_s28_q[6] & (not_1890_s28_q & (less_3473 & (x_s28_q[2:0] == 3'h1)));
  logic and_3489;
  assign and_3489 = x_s28_q[6] & (not_1890_s28_q & (less_3473 & (x_s28_q[2:0] == 3'h2)));
  logic and_3496;
  assign and_3496 = x_s28_q[6] & (not_1890_s28_q & (less_3473 & (x_s28_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:191
  logic select_3503;
  assign select_3503 = (x_s28_q[5:3] == 3'h2) ? x_s28_q[1] : (x_s28_q[0] & (x_s28_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:194
  logic [4:0] sum_3530;
  assign sum_3530 = {2'h0, x_s28_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3549;
  assign select_3549 = less_3546_s28_q ? 6'h10 : (less_3547_s28_q ? 6'h30 : difference_3422_s28_q);
  // hls/stages/patches.hpp:546
  logic [5:0] select_3551;
  assign select_3551 = equal_1864_s28_q ? (or_3375_s28_q ? 6'h0 : select_3549) : 6'h0;
  logic [5:0] select_3553;
  assign select_3553 = less_1861_s28_q ? (equal_1862_s28_q ? 6'h0 : select_3551) : select_3551;
  // hls/stages/patches.hpp:330
  logic and_3560;
  assign and_3560 = equal_1479_s28_q & (x_s28_q[6] & (not_1890_s28_q & (equal_2664_s28_q & less_3473)));
  // hls/stages/agreement.hpp:1084
  logic and_3564;
  assign and_3564 = x_s28_q[6] & (not_1890_s28_q & (less_3473 & (x_s28_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:330
  logic and_3875;
  assign and_3875 = equal_1479_s28_q & (equal_3579_s28_q & (cfg_prove_i & or_3671_s28_q));
  // hls/stages/agreement.hpp:1171
  logic not_3877;
  assign not_3877 = ~(or_3671_s28_q | not_3862);
  // hls/stages/patches.hpp:330
  logic and_3881;
  assign and_3881 = equal_1479_s28_q & (equal_3579_s28_q & (not_3877 & or_3878_s28_q));
  logic and_3894;
  assign and_3894 = equal_3579_s28_q & (not_3877 & (select_2279 | select_2291_s28_q));
  // hls/stages/agreement.hpp:1088
  logic and_3901;
  assign and_3901 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_3899_s28_q);
  // hls/stages/patches.hpp:330
  logic and_3907;
  assign and_3907 = equal_1479_s28_q & (x_s28_q[6] & (not_1890_s28_q | (4'hc < x_s28_q[5:2])));

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
      patches_frame_ended_q <= 1'b0;
    end else if (s28_en) begin
      sharpness_comparing_less_detail_0_q <= select_2273;
      sharpness_comparing_less_detail_1_q <= select_2279;
      patches_sums_values_0_q <= select_3236;
      patches_sums_values_1_q <= equal_1700_s28_q ? patches_sums_values_1_q : select_3237;
      patches_sums_values_2_q <= equal_1700_s28_q ? patches_sums_values_2_q : select_3239;
      patches_sums_values_3_q <= equal_1700_s28_q ? patches_sums_values_3_q : select_3241;
      patches_sums_values_4_q <= equal_1700_s28_q ? patches_sums_values_4_q : select_3243;
      patches_sums_values_5_q <= equal_1700_s28_q ? patches_sums_values_5_q : select_3245;
      patches_sums_values_6_q <= equal_1700_s28_q ? patches_sums_values_6_q : select_3247;
      patches_sums_values_7_q <= equal_1700_s28_q ? patches_sums_values_7_q : select_3249;
      patches_sums_values_8_q <= equal_1700_s28_q ? patches_sums_values_8_q : select_3251;
      patches_sums_values_9_q <= equal_1700_s28_q ? patches_sums_values_9_q : select_3253;
      patches_sums_values_10_q <= equal_1700_s28_q ? patches_sums_values_10_q : select_3255;
      patches_sums_values_11_q <= equal_1700_s28_q ? patches_sums_values_11_q : select_3257;
      patches_sums_values_12_q <= equal_1700_s28_q ? patches_sums_values_12_q : select_3259;
      patches_sums_values_13_q <= equal_1700_s28_q ? patches_sums_values_13_q : select_3261;
      patches_sums_values_14_q <= equal_1700_s28_q ? patches_sums_values_14_q : select_3263;
      patches_sums_values_15_q <= equal_1700_s28_q ? patches_sums_values_15_q : select_3265;
      patches_sums_values_16_q <= equal_1700_s28_q ? patches_sums_values_16_q : select_3267;
      patches_best_differing_q <= select_1878[9:0];
      patches_best_column_q <= select_1878[14:10];
      patches_frame_ended_q <= equal_1479_s28_q & ((x_s28_q == 7'h70) & (~equal_3579_s28_q));
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
  logic equal_1479_s29_q;
  logic equal_1524_s29_q;
  logic equal_1532_s29_q;
  logic [9:0] select_2459_s29_q;
  logic [9:0] select_2462_s29_q;
  logic and_3380_s29_q;
  logic and_3386_s29_q;
  logic and_3429_s29_q;
  logic and_3439_s29_q;
  logic and_3477_s29_q;
  logic and_3483_s29_q;
  logic and_3490_s29_q;
  logic and_3497_s29_q;
  logic and_3506_s29_q;
  logic and_3533_s29_q;
  logic [5:0] select_3554_s29_q;
  logic and_3560_s29_q;
  logic and_3565_s29_q;
  logic equal_3579_s29_q;
  logic and_3838_s29_q;
  logic or_3863_s29_q;
  logic and_3864_s29_q;
  logic not_3868_s29_q;
  logic and_3875_s29_q;
  logic and_3881_s29_q;
  logic and_3890_s29_q;
  logic and_3894_s29_q;
  logic and_3903_s29_q;
  logic and_3907_s29_q;
  logic [5:0] select_3909_s29_q;
  logic [31:0] select_3921_s29_q;
  logic [9:0] select_3923_s29_q;
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
      equal_1479_s29_q <= equal_1479_s28_q;
      equal_1524_s29_q <= equal_1524_s28_q;
      equal_1532_s29_q <= equal_1532_s28_q;
      select_2459_s29_q <= select_2459_s28_q;
      select_2462_s29_q <= select_2462_s28_q;
      and_3380_s29_q <= and_3380;
      and_3386_s29_q <= and_3386;
      and_3429_s29_q <= and_3429;
      and_3439_s29_q <= and_3439;
      and_3477_s29_q <= and_3477;
      and_3483_s29_q <= equal_1479_s28_q & and_3482;
      and_3490_s29_q <= equal_1479_s28_q & and_3489;
      and_3497_s29_q <= equal_1479_s28_q & and_3496;
      and_3506_s29_q <= x_s28_q[6] & (not_1890_s28_q & (less_3473 & select_3503));
      and_3533_s29_q <= not_1890_s28_q & (less_3473 & (sum_3530[4:2] == 3'h0));
      select_3554_s29_q <= equal_1700_s28_q ? select_3553 : 6'h0;
      and_3560_s29_q <= and_3560;
      and_3565_s29_q <= equal_1479_s28_q & and_3564;
      equal_3579_s29_q <= equal_3579_s28_q;
      and_3838_s29_q <= and_3838_s28_q;
      or_3863_s29_q <= not_3862 | seen_q;
      and_3864_s29_q <= cfg_prove_i & nearer_q;
      not_3868_s29_q <= not_3868_s28_q;
      and_3875_s29_q <= and_3875;
      and_3881_s29_q <= and_3881;
      and_3890_s29_q <= equal_3579_s28_q & (not_3877 & (select_2273 | or_3887_s28_q));
      and_3894_s29_q <= and_3894;
      and_3903_s29_q <= equal_1479_s28_q & (equal_3579_s28_q & and_3901);
      and_3907_s29_q <= and_3907;
      select_3909_s29_q <= equal_1479_s28_q ? (x_s28_q[6] ? x_s28_q[5:0] : 6'h0) : 6'h0;
      select_3921_s29_q <= select_3921_s28_q;
      select_3923_s29_q <= select_3923_s28_q;
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
  logic patches_suspected_q;
  logic patches_moved_q;
  logic patches_twice_q;
  logic patches_clear_q;
  logic [9:0] patches_age_q;
  // hls/stages/patches.hpp:636
  logic not_3381;
  assign not_3381 = ~patches_lower_s29_q;
  logic not_3387;
  assign not_3387 = ~and_3386_s29_q;
  // hls/stages/patches.hpp:180
  logic and_3389;
  assign and_3389 = and_3380_s29_q & (not_3381 & not_3387);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3391;
  assign sum_3391 = {7'h0, and_3389} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:639
  logic and_3430;
  assign and_3430 = and_3429_s29_q & and_3389;
  logic [7:0] sum_3431;
  assign sum_3431 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3430};
  // hls/stages/patches.hpp:640
  logic and_3440;
  assign and_3440 = and_3439_s29_q & and_3389;
  logic [7:0] sum_3441;
  assign sum_3441 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3440};
  // hls/stages/patches.hpp:180
  logic and_3443;
  assign and_3443 = and_3380_s29_q & (and_3386_s29_q & not_3381);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3445;
  assign sum_3445 = {7'h0, and_3443} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:639
  logic and_3447;
  assign and_3447 = and_3429_s29_q & and_3443;
  logic [7:0] sum_3448;
  assign sum_3448 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3447};
  // hls/stages/patches.hpp:640
  logic and_3450;
  assign and_3450 = and_3439_s29_q & and_3443;
  logic [7:0] sum_3451;
  assign sum_3451 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3450};
  // hls/stages/patches.hpp:180
  logic and_3453;
  assign and_3453 = and_3380_s29_q & (patches_lower_s29_q & not_3387);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3455;
  assign sum_3455 = {7'h0, and_3453} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:639
  logic and_3457;
  assign and_3457 = and_3429_s29_q & and_3453;
  logic [7:0] sum_3458;
  assign sum_3458 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3457};
  // hls/stages/patches.hpp:640
  logic and_3460;
  assign and_3460 = and_3439_s29_q & and_3453;
  logic [7:0] sum_3461;
  assign sum_3461 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3460};
  // hls/stages/patches.hpp:180
  logic and_3463;
  assign and_3463 = and_3380_s29_q & (patches_lower_s29_q & and_3386_s29_q);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3465;
  assign sum_3465 = {7'h0, and_3463} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:639
  logic and_3467;
  assign and_3467 = and_3429_s29_q & and_3463;
  logic [7:0] sum_3468;
  assign sum_3468 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3467};
  // hls/stages/patches.hpp:640
  logic and_3470;
  assign and_3470 = and_3439_s29_q & and_3463;
  logic [7:0] sum_3471;
  assign sum_3471 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3470};
  // hls/stages/patches.hpp:607
  logic [7:0] or_3485;
  assign or_3485 = (and_3477_s29_q ? patches_quarters_0_places_q : 8'h0) | (and_3483_s29_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3499;
  assign or_3499 = (or_3485 | (and_3490_s29_q ? patches_quarters_2_places_q : 8'h0)) | (and_3497_s29_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:330
  logic and_3507;
  assign and_3507 = equal_1479_s29_q & and_3506_s29_q;
  // hls/stages/patches.hpp:608
  logic [7:0] select_3509;
  assign select_3509 = and_3477_s29_q ? (and_3507 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3511;
  assign select_3511 = and_3483_s29_q ? (and_3507 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3514;
  assign select_3514 = and_3490_s29_q ? (and_3507 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3517;
  assign select_3517 = and_3497_s29_q ? (and_3507 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:609
  logic [7:0] select_3520;
  assign select_3520 = and_3477_s29_q ? (and_3507 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3522;
  assign select_3522 = and_3483_s29_q ? (and_3507 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3525;
  assign select_3525 = and_3490_s29_q ? (and_3507 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3528;
  assign select_3528 = and_3497_s29_q ? (and_3507 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:330
  logic and_3535;
  assign and_3535 = equal_1479_s29_q & (x_s29_q & and_3533_s29_q);
  // hls/stages/patches.hpp:602
  logic [7:0] sum_3537;
  assign sum_3537 = patches_word_places_q + (and_3483_s29_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:604
  logic [7:0] select_3541;
  assign select_3541 = and_3535 ? (patches_word_up_q + (and_3483_s29_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3543;
  assign sum_3543 = patches_word_down_q + (and_3483_s29_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:642
  logic [5:0] select_3555;
  assign select_3555 = and_3380_s29_q ? select_3554_s29_q : 6'h0;
  logic [11:0] sum_3556;
  assign sum_3556 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3555[5]}}, select_3555};
  // hls/stages/patches.hpp:629
  logic [7:0] select_3567;
  assign select_3567 = and_3560_s29_q ? (and_3565_s29_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:631
  logic or_3571;
  assign or_3571 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:632
  logic or_3574;
  assign or_3574 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:633
  logic [8:0] sum_3575;
  assign sum_3575 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:628
  logic select_3577;
  assign select_3577 = and_3560_s29_q ? (and_3565_s29_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:180
  logic and_3584;
  assign and_3584 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:628
  logic [2:0] select_3585;
  assign select_3585 = and_3560_s29_q ? {and_3584, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3587;
  assign select_3587 = and_3560_s29_q ? (and_3565_s29_q ? {and_3584, patches_found_q[2:1]} : select_3585) : patches_found_q;
  // hls/stages/patches.hpp:627
  logic or_3590;
  assign or_3590 = patches_partly_q | (patches_doubted_q & (~and_3565_s29_q));
  // hls/stages/patches.hpp:628
  logic select_3592;
  assign select_3592 = and_3565_s29_q ? or_3590 : (and_3560_s29_q ? or_3590 : patches_doubted_q);
  // hls/stages/patches.hpp:626
  logic select_3594;
  assign select_3594 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:617
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:618
  logic select_3604;
  assign select_3604 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:619
  logic and_3610;
  assign and_3610 = patches_frame_ended_s29_q & (~patches_age_q[9]);
  logic [9:0] sum_3611;
  assign sum_3611 = patches_age_q + {9'h0, and_3610};
  logic [9:0] select_3614;
  assign select_3614 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3611)) : sum_3611;
  // hls/stages/agreement.hpp:1169
  logic or_3869;
  assign or_3869 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_3868_s29_q;
  // hls/stages/patches.hpp:330
  logic and_3884;
  assign and_3884 = equal_3579_s29_q & (cfg_prove_i & (registration_moved_s29_q | patches_moved_q));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3922;
  assign select_3922 = equal_1532_s29_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3921_s29_q;
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_3924;
  assign select_3924 = equal_1524_s29_q ? select_3922 : {2'h0, select_3923_s29_q, select_2462_s29_q, select_2459_s29_q};

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
      patches_suspected_q <= 1'b0;
      patches_moved_q <= 1'b0;
      patches_twice_q <= 1'b0;
      patches_clear_q <= 1'b0;
      patches_age_q <= 10'h200;
    end else if (s29_en) begin
      patches_quarters_0_places_q <= sum_3391;
      patches_quarters_0_up_q <= sum_3431;
      patches_quarters_0_down_q <= sum_3441;
      patches_quarters_1_places_q <= sum_3445;
      patches_quarters_1_up_q <= sum_3448;
      patches_quarters_1_down_q <= sum_3451;
      patches_quarters_2_places_q <= sum_3455;
      patches_quarters_2_up_q <= sum_3458;
      patches_quarters_2_down_q <= sum_3461;
      patches_quarters_3_places_q <= sum_3465;
      patches_quarters_3_up_q <= sum_3468;
      patches_quarters_3_down_q <= sum_3471;
      patches_word_places_q <= or_3499;
      patches_word_up_q <= ((select_3509 | select_3511) | select_3514) | select_3517;
      patches_word_down_q <= ((select_3520 | select_3522) | select_3525) | select_3528;
      patches_sum_places_q <= and_3535 ? sum_3537 : patches_sum_places_q;
      patches_sum_up_q <= select_3541;
      patches_sum_down_q <= and_3535 ? sum_3543 : patches_sum_down_q;
      patches_across_q <= sum_3556;
      patches_places_q <= select_3567;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3571;
      patches_partly_q <= or_3574;
      patches_clear_limit_q <= sum_3575[8:2];
      patches_complete_q <= select_3577;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3587;
      patches_doubted_q <= and_3560_s29_q ? select_3592 : patches_doubted_q;
      patches_doubted_before_q <= select_3594;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3604;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3614;
    end
  end

  logic [7:0] pixel_0_s30_q;
  logic [7:0] pixel_1_s30_q;
  logic saturated_s30_q;
  logic mask_s30_q;
  logic marks_first_s30_q;
  logic marks_last_s30_q;
  logic and_3838_s30_q;
  logic or_3863_s30_q;
  logic and_3864_s30_q;
  logic and_3872_s30_q;
  logic and_3875_s30_q;
  logic and_3881_s30_q;
  logic and_3885_s30_q;
  logic and_3891_s30_q;
  logic and_3895_s30_q;
  logic and_3903_s30_q;
  logic and_3907_s30_q;
  logic [5:0] select_3909_s30_q;
  logic [31:0] select_3926_s30_q;
  always_ff @(posedge clk_i) begin
    if (s29_en) begin
      pixel_0_s30_q <= pixel_0_s29_q;
      pixel_1_s30_q <= pixel_1_s29_q;
      saturated_s30_q <= saturated_s29_q;
      mask_s30_q <= mask_s29_q;
      marks_first_s30_q <= marks_first_s29_q;
      marks_last_s30_q <= marks_last_s29_q;
      and_3838_s30_q <= and_3838_s29_q;
      or_3863_s30_q <= or_3863_s29_q;
      and_3864_s30_q <= and_3864_s29_q;
      and_3872_s30_q <= equal_1479_s29_q & (equal_3579_s29_q & (cfg_prove_i & or_3869));
      and_3875_s30_q <= and_3875_s29_q;
      and_3881_s30_q <= and_3881_s29_q;
      and_3885_s30_q <= equal_1479_s29_q & and_3884;
      and_3891_s30_q <= equal_1479_s29_q & and_3890_s29_q;
      and_3895_s30_q <= equal_1479_s29_q & and_3894_s29_q;
      and_3903_s30_q <= and_3903_s29_q;
      and_3907_s30_q <= and_3907_s29_q;
      select_3909_s30_q <= select_3909_s29_q;
      select_3926_s30_q <= equal_1479_s29_q ? (x_s29_q ? select_3924 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s30_q;
  assign pixel_1_o = pixel_1_s30_q;
  assign saturated_o = saturated_s30_q;
  assign mask_o = mask_s30_q;
  assign marks_first_o = marks_first_s30_q;
  assign marks_last_o = marks_last_s30_q;
  assign marks_seen_o = or_3863_s30_q;
  assign marks_nearer_o = and_3864_s30_q;
  assign verdict_valid_o = and_3838_s30_q;
  assign verdict_unproven_yet_o = and_3872_s30_q;
  assign verdict_untextured_o = and_3875_s30_q;
  assign verdict_disagree_o = and_3881_s30_q;
  assign verdict_moved_o = and_3885_s30_q;
  assign verdict_unsharp_left_o = and_3891_s30_q;
  assign verdict_unsharp_right_o = and_3895_s30_q;
  assign verdict_hidden_o = and_3903_s30_q;
  assign frame_valid_o = and_3907_s30_q;
  assign frame_index_o = select_3909_s30_q;
  assign frame_word_o = select_3926_s30_q;
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
  assign unused_bits = ^{over[13:0], sum_3575[1:0], sum_3530[1:0], product_3421[4:0], sum_2515[0], detail_4[1:0], detail_3[1:0], sum_2173[4:0], sum_1681[1:0], sum_1680[1:0], sum_1676[0], sum_1627[0], sum_1623[0], sum_623[4:0], cfg_width_i[3:0]};

endmodule
