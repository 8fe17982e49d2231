// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 26 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3115 bits, pipeline 8767 bits, memories 157167 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en;
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

  // Of the configuration alone: not pipelined.
  logic not_2349;
  assign not_2349 = ~cfg_prove_i;
  logic [6:0] sum_2562;
  assign sum_2562 = {1'b0, cfg_height_i[10:5]} + 7'h5;
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
  // hls/stages/census.hpp:36
  logic [3:0] select_507;
  assign select_507 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_507 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_507_s1_q;
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
      raster_row_ended_s1_q <= raster_row_ended_q;
      select_507_s1_q <= select_507;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:36
  logic [6:0] select_510;
  assign select_510 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_s1_q ? select_510 : 7'h0;
  // hls/stages/census.hpp:51
  logic equal_542;
  assign equal_542 = select_507_s1_q == 4'hf;
  // hls/stages/agreement.hpp:276
  logic [6:0] select_2146;
  assign select_2146 = sample_pair_whole_s1_q ? (select_510 + {6'h0, equal_542}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2146;
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
  logic [6:0] select_510_s2_q;
  logic [6:0] last_s2_q;
  logic equal_542_s2_q;
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
      select_510_s2_q <= select_510;
      last_s2_q <= last;
      equal_542_s2_q <= equal_542;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:110
  logic equal_508;
  assign equal_508 = select_507_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:116
  logic [8:0] select_513;
  assign select_513 = ({select_510_s2_q, select_507_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:117
  logic [8:0] select_514;
  assign select_514 = equal_508 ? select_513 : averager_place_q;
  // hls/stages/census.hpp:42
  logic [3:0] select_525;
  assign select_525 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2144;
  assign select_2144 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_525 + 4'h1) : select_525) : raster_at_y_q;
  // hls/stages/agreement.hpp:459
  logic [7:0] sum_2467;
  assign sum_2467 = {1'b0, last_s2_q} + 8'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2144;
      averager_place_q <= sample_pair_whole_s2_q ? select_514 : averager_place_q;
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
  logic [3:0] select_507_s3_q;
  logic equal_508_s3_q;
  logic [6:0] select_510_s3_q;
  logic [8:0] select_514_s3_q;
  logic equal_516_s3_q;
  logic [3:0] select_525_s3_q;
  logic [6:0] last_s3_q;
  logic equal_542_s3_q;
  logic equal_543_s3_q;
  logic equal_2468_s3_q;
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
      sample_last_s3_q <= sample_last_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      select_507_s3_q <= select_507_s2_q;
      equal_508_s3_q <= equal_508;
      select_510_s3_q <= select_510_s2_q;
      select_514_s3_q <= select_514;
      equal_516_s3_q <= select_507_s2_q[1:0] == 2'h3;
      select_525_s3_q <= select_525;
      last_s3_q <= last_s2_q;
      equal_542_s3_q <= equal_542_s2_q;
      equal_543_s3_q <= select_525 == 4'hf;
      equal_2468_s3_q <= {sum_2467[7], cfg_width_i[10:4]} == {1'b0, sum_2467[6:0]};
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:42
  logic or_515;
  assign or_515 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_520;
  assign and_520 = (or_515 & equal_516_s3_q) & (~(select_514_s3_q[8:5] == 4'hf));
  // hls/stages/census.hpp:127
  logic and_544;
  assign and_544 = equal_543_s3_q & and_520;
  // hls/stages/agreement.hpp:276
  logic and_546;
  assign and_546 = sample_pair_whole_s3_q & (equal_542_s3_q & and_544);
  // hls/stages/census.hpp:42
  logic [6:0] select_674;
  assign select_674 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_674 : 7'h0;
  // hls/stages/census.hpp:58
  logic [6:0] select_2148;
  assign select_2148 = sample_last_s3_q ? (select_674 + {6'h0, equal_543_s3_q}) : select_674;
  // hls/stages/agreement.hpp:276
  logic select_2153;
  assign select_2153 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_515 & (~raster_final_row_q)) : or_515) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [10:0] select_2155;
  assign select_2155 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:276
  logic select_2159;
  assign select_2159 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2148 : raster_at_row_q;
      raster_at_live_q <= select_2153;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2155 : raster_rows_left_q;
      raster_final_row_q <= select_2159;
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
  logic [3:0] select_507_s4_q;
  logic equal_508_s4_q;
  logic [6:0] select_510_s4_q;
  logic [8:0] select_514_s4_q;
  logic and_520_s4_q;
  logic [3:0] select_525_s4_q;
  logic [6:0] last_s4_q;
  logic and_544_s4_q;
  logic and_546_s4_q;
  logic [3:0] select_674_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1678_s4_q;
  logic equal_2468_s4_q;
  logic and_2469_s4_q;
  logic [7:0] sum_2558_s4_q;
  logic [2:0] or_2999_s4_q;
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
      select_507_s4_q <= select_507_s3_q;
      equal_508_s4_q <= equal_508_s3_q;
      select_510_s4_q <= select_510_s3_q;
      select_514_s4_q <= select_514_s3_q;
      and_520_s4_q <= and_520;
      select_525_s4_q <= select_525_s3_q;
      last_s4_q <= last_s3_q;
      and_544_s4_q <= and_544;
      and_546_s4_q <= and_546;
      select_674_s4_q <= select_674[3:0];
      row_s4_q <= row;
      equal_1678_s4_q <= {or_515, select_525_s3_q} == 5'h18;
      equal_2468_s4_q <= equal_2468_s3_q;
      and_2469_s4_q <= and_546 & equal_2468_s3_q;
      sum_2558_s4_q <= {1'b0, row} + 8'h1;
      or_2999_s4_q <= select_510_s3_q[2:0] | select_674[6:4];
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
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_575;
  assign equal_575 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:614
  logic equal_590;
  assign equal_590 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_591;
  assign equal_591 = run_phase_q == 3'h2;
  // hls/stages/patches.hpp:122
  logic and_1672;
  assign and_1672 = (select_507_s4_q == 4'h0) & (select_510_s4_q == 7'h0);
  // hls/stages/agreement.hpp:523
  logic select_2472;
  assign select_2472 = (and_2469_s4_q | (~ends_cell_q)) ? and_2469_s4_q : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2472 ? (and_2469_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2476;
  assign select_2476 = select_2472 ? (and_2469_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2479;
  assign select_2479 = select_2472 ? (following_last_shift_q & (~and_2469_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:535
  logic [7:0] select_2481;
  assign select_2481 = select_2472 ? (and_2469_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:607
  logic and_2482;
  assign and_2482 = run_last_shift_q & equal_590;
  // hls/stages/agreement.hpp:616
  logic select_2484;
  assign select_2484 = equal_590 ? (~run_last_shift_q) : equal_591;
  // hls/stages/agreement.hpp:620
  logic equal_2485;
  assign equal_2485 = run_phase_q == 3'h1;
  logic not_2488;
  assign not_2488 = ~select_2484;
  // hls/stages/agreement.hpp:623
  logic equal_2490;
  assign equal_2490 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2491;
  assign and_2491 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2492;
  assign select_2492 = equal_2490 ? 2'h1 : {2{and_2491}};
  logic [2:0] select_2494;
  assign select_2494 = (and_2482 | (select_2484 | equal_2485)) ? (equal_2485 ? 3'h2 : {not_2488, {2{select_2484}}}) : (equal_575 ? 3'h6 : {select_2492[0], select_2492});
  // hls/stages/agreement.hpp:607
  logic and_2497;
  assign and_2497 = select_2484 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2500;
  assign select_2500 = (plan_shift_q[5] & select_2484) ? value : 7'h0;
  logic [1:0] or_2501;
  assign or_2501 = {2{so}} | select_2500[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2505;
  assign or_2505 = (select_2484 ? plan_columns_q : 8'h0) | ((equal_2485 | equal_2490) ? whole_q : 8'h0);
  logic [1:0] or_2506;
  assign or_2506 = {2{and_2482}} | or_2505[4:3];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2508;
  assign or_2508 = {or_2505[7:5], or_2506, or_2505[2:0]} | (equal_575 ? drawn_q : 8'h0);
  logic [4:0] or_2509;
  assign or_2509 = {5{so}} | {or_2508[6], or_2508[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2513;
  assign not_2513 = ~run_shift_q[5];
  logic [7:0] select_2516;
  assign select_2516 = equal_590 ? ({{7{not_2513}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2520;
  assign select_2520 = and_2469_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2522;
  assign select_2522 = select_2472 ? {select_2520[6], select_2520} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2525;
  assign select_2525 = select_2472 ? (and_2469_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:460
  logic [6:0] select_2532;
  assign select_2532 = equal_2468_s4_q ? ((6'he < last_s4_q[6:1]) ? 7'h1d : last_s4_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2534;
  assign sum_2534 = {1'b0, last_s4_q[6:3]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2536;
  assign select_2536 = and_546_s4_q ? (equal_2468_s4_q ? {sum_2534, last_s4_q[2:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_2537;
  assign sum_2537 = {1'b0, last_s4_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2539;
  assign select_2539 = and_546_s4_q ? (equal_2468_s4_q ? {sum_2537, last_s4_q[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2553;
  assign select_2553 = (ends_cell_q | select_2472) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_590 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2557;
  assign and_2557 = (~select_2472) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic equal_2559;
  assign equal_2559 = {sum_2558_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2558_s4_q[6:0]};
  // hls/stages/agreement.hpp:520
  logic select_2561;
  assign select_2561 = and_546_s4_q ? (equal_2468_s4_q ? equal_2559 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2936;
  assign select_2936 = and_1672 ? (sample_pair_first_s4_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/patches.hpp:371
  logic [8:0] sum_3000;
  assign sum_3000 = {1'b0, select_510_s4_q[3], or_2999_s4_q, select_674_s4_q} + 9'h1;

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
      run_shift_q <= select_2476;
      run_last_shift_q <= select_2479;
      run_span_q <= select_2481;
      following_phase_q <= select_2494;
      following_shift_q <= select_2484 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2497;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2500[6], or_2501, select_2500[3:0]};
      following_columns_q <= {or_2508[7], or_2509[4], or_2508[5:4], or_2509[3:0]};
      plan_shift_q <= equal_590 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2516;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2522;
      columns_left_q <= select_2525;
      last_q <= and_546_s4_q ? (equal_2468_s4_q ? last_s4_q : last_q) : last_q;
      least_q <= and_546_s4_q ? select_2532 : least_q;
      whole_q <= select_2536;
      drawn_q <= select_2539;
      slot_q <= select_2472 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2553;
      ends_q <= and_2557;
      final_row_q <= select_2561;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= sample_pair_whole_s4_q ? select_2936 : patches_phase_q;
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
  logic [3:0] select_507_s5_q;
  logic equal_508_s5_q;
  logic [6:0] select_510_s5_q;
  logic [8:0] select_514_s5_q;
  logic and_520_s5_q;
  logic equal_526_s5_q;
  logic [6:0] last_s5_2_q;
  logic and_544_s5_q;
  logic and_546_s5_q;
  logic equal_571_s5_q;
  logic so_s5_q;
  logic equal_575_s5_q;
  logic [7:0] sum_577_s5_q;
  logic equal_590_s5_q;
  logic equal_591_s5_q;
  logic [7:0] sum_608_s5_q;
  logic [6:0] row_s5_q;
  logic and_1672_s5_q;
  logic equal_1678_s5_q;
  logic equal_2468_s5_q;
  logic and_2469_s5_q;
  logic select_2472_s5_q;
  logic [3:0] phase_s5_q;
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
      run_shift_s5_q <= run_shift_q;
      x_s5_q <= x_q;
      last_s5_q <= last_q;
      slot_s5_q <= slot_q;
      ends_cell_s5_q <= ends_cell_q;
      shift_first_s5_q <= shift_first_q;
      select_507_s5_q <= select_507_s4_q;
      equal_508_s5_q <= equal_508_s4_q;
      select_510_s5_q <= select_510_s4_q;
      select_514_s5_q <= select_514_s4_q;
      and_520_s5_q <= and_520_s4_q;
      equal_526_s5_q <= select_525_s4_q == 4'h0;
      last_s5_2_q <= last_s4_q;
      and_544_s5_q <= and_544_s4_q;
      and_546_s5_q <= and_546_s4_q;
      equal_571_s5_q <= run_phase_q == 3'h7;
      so_s5_q <= so;
      equal_575_s5_q <= equal_575;
      sum_577_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      equal_590_s5_q <= equal_590;
      equal_591_s5_q <= equal_591;
      sum_608_s5_q <= {1'b0, last_q} + 8'h3;
      row_s5_q <= row_s4_q;
      and_1672_s5_q <= and_1672;
      equal_1678_s5_q <= equal_1678_s4_q;
      equal_2468_s5_q <= equal_2468_s4_q;
      and_2469_s5_q <= and_2469_s4_q;
      select_2472_s5_q <= select_2472;
      phase_s5_q <= phase;
      not_3002_s5_q <= ~({sum_3000, select_525_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_578;
  assign select_578 = run_shift_s5_q[5] ? x_s5_q : sum_577_s5_q;
  logic less_579;
  assign less_579 = {1'b0, last_s5_q} < select_578;
  // hls/stages/agreement.hpp:226
  logic not_580;
  assign not_580 = ~less_579;
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:528
  logic [6:0] select_2541;
  assign select_2541 = select_2472_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2541;
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
  logic [3:0] select_507_s6_q;
  logic equal_508_s6_q;
  logic [6:0] select_510_s6_q;
  logic [8:0] select_514_s6_q;
  logic and_520_s6_q;
  logic equal_526_s6_q;
  logic [6:0] last_s6_2_q;
  logic and_544_s6_q;
  logic and_546_s6_q;
  logic equal_571_s6_q;
  logic so_s6_q;
  logic equal_575_s6_q;
  logic [6:0] sum_577_s6_q;
  logic less_579_s6_q;
  logic not_580_s6_q;
  logic equal_590_s6_q;
  logic and_592_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_612_s6_q;
  logic [6:0] row_s6_q;
  logic equal_1559_s6_q;
  logic and_1672_s6_q;
  logic equal_1678_s6_q;
  logic equal_2468_s6_q;
  logic and_2469_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2956_s6_q;
  logic [3:0] select_2959_s6_q;
  logic not_3002_s6_q;
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
      age_s6_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s6_q <= slot_s5_q;
      ends_cell_s6_q <= ends_cell_s5_q;
      shift_first_s6_q <= shift_first_s5_q;
      select_507_s6_q <= select_507_s5_q;
      equal_508_s6_q <= equal_508_s5_q;
      select_510_s6_q <= select_510_s5_q;
      select_514_s6_q <= select_514_s5_q;
      and_520_s6_q <= and_520_s5_q;
      equal_526_s6_q <= equal_526_s5_q;
      last_s6_2_q <= last_s5_2_q;
      and_544_s6_q <= and_544_s5_q;
      and_546_s6_q <= and_546_s5_q;
      equal_571_s6_q <= equal_571_s5_q;
      so_s6_q <= so_s5_q;
      equal_575_s6_q <= equal_575_s5_q;
      sum_577_s6_q <= sum_577_s5_q[6:0];
      less_579_s6_q <= less_579;
      not_580_s6_q <= not_580;
      equal_590_s6_q <= equal_590_s5_q;
      and_592_s6_q <= equal_591_s5_q & not_580;
      x_s6_2_q <= x[6:0];
      and_612_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_608_s5_q < select_578)));
      row_s6_q <= row_s5_q;
      equal_1559_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      and_1672_s6_q <= and_1672_s5_q;
      equal_1678_s6_q <= equal_1678_s5_q;
      equal_2468_s6_q <= equal_2468_s5_q;
      and_2469_s6_q <= and_2469_s5_q;
      phase_s6_q <= phase_s5_q;
      equal_2956_s6_q <= row_s5_q == 7'h3;
      select_2959_s6_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_3002_s6_q <= not_3002_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:594
  logic or_576;
  assign or_576 = so_s6_q | equal_575_s6_q;
  // hls/stages/agreement.hpp:149
  logic select_594;
  assign select_594 = or_576 ? not_580_s6_q : (equal_590_s6_q ? not_580_s6_q : and_592_s6_q);
  logic and_613;
  assign and_613 = equal_590_s6_q & and_612_s6_q;
  logic select_614;
  assign select_614 = or_576 ? not_580_s6_q : and_613;
  // hls/stages/agreement.hpp:821
  logic [6:0] right;
  assign right = sum_577_s6_q + 7'h7d;
  // hls/stages/agreement.hpp:149
  logic [6:0] select_638;
  assign select_638 = or_576 ? x_s6_q[6:0] : (equal_590_s6_q ? sum_577_s6_q : x_s6_q[6:0]);
  // hls/stages/agreement.hpp:720
  logic not_644;
  assign not_644 = ~or_576;
  // hls/stages/agreement.hpp:520
  logic and_2826;
  assign and_2826 = and_546_s6_q & (equal_2468_s6_q & (row_s6_q[6:2] == 5'h0));
  // hls/stages/patches.hpp:87
  logic [3:0] select_2960;
  assign select_2960 = equal_2956_s6_q ? select_2959_s6_q : patches_choosing_rows_to_next_q;
  logic equal_2961;
  assign equal_2961 = select_2960 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2964;
  assign select_2964 = equal_2468_s6_q ? (equal_2961 ? 4'h2 : (select_2960 + 4'hf)) : patches_choosing_rows_to_next_q;

  // Memory left, 120 x 85, DISTANCE 24, hls/stages/agreement.hpp:1373; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [84:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 85'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
`ifndef SYNTHESIS
  logic left_re;
  assign left_re = s6_en & select_594;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 99, DISTANCE 24, hls/stages/agreement.hpp:1374; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [98:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_638;
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s6_en & select_594;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1375; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [61:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 62'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_576 ? x_s6_q[6:0] : x_s6_2_q;
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s6_en & select_614;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s6_en) begin
      patches_choosing_rows_to_next_q <= and_546_s6_q ? select_2964 : patches_choosing_rows_to_next_q;
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
  logic [3:0] select_507_s7_q;
  logic equal_508_s7_q;
  logic [6:0] select_510_s7_q;
  logic [8:0] select_514_s7_q;
  logic and_520_s7_q;
  logic equal_526_s7_q;
  logic [6:0] last_s7_2_q;
  logic and_544_s7_q;
  logic and_546_s7_q;
  logic equal_571_s7_q;
  logic so_s7_q;
  logic equal_575_s7_q;
  logic or_576_s7_q;
  logic less_579_s7_q;
  logic not_580_s7_q;
  logic equal_590_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_614_s7_q;
  logic [6:0] right_s7_q;
  logic and_647_s7_q;
  logic [6:0] row_s7_q;
  logic and_1558_s7_q;
  logic equal_1559_s7_q;
  logic and_1672_s7_q;
  logic equal_1678_s7_q;
  logic equal_2468_s7_q;
  logic and_2827_s7_q;
  logic and_2829_s7_q;
  logic and_2836_s7_q;
  logic [3:0] phase_s7_q;
  logic equal_2956_s7_q;
  logic equal_2961_s7_q;
  logic not_3002_s7_q;
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
      patches_choosing_rows_to_next_s7_q <= patches_choosing_rows_to_next_q;
      select_507_s7_q <= select_507_s6_q;
      equal_508_s7_q <= equal_508_s6_q;
      select_510_s7_q <= select_510_s6_q;
      select_514_s7_q <= select_514_s6_q;
      and_520_s7_q <= and_520_s6_q;
      equal_526_s7_q <= equal_526_s6_q;
      last_s7_2_q <= last_s6_2_q;
      and_544_s7_q <= and_544_s6_q;
      and_546_s7_q <= and_546_s6_q;
      equal_571_s7_q <= equal_571_s6_q;
      so_s7_q <= so_s6_q;
      equal_575_s7_q <= equal_575_s6_q;
      or_576_s7_q <= or_576;
      less_579_s7_q <= less_579_s6_q;
      not_580_s7_q <= not_580_s6_q;
      equal_590_s7_q <= equal_590_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_614_s7_q <= select_614;
      right_s7_q <= right;
      and_647_s7_q <= not_644 & ((~equal_590_s6_q) & and_592_s6_q);
      row_s7_q <= row_s6_q;
      and_1558_s7_q <= not_644 & and_613;
      equal_1559_s7_q <= equal_1559_s6_q;
      and_1672_s7_q <= and_1672_s6_q;
      equal_1678_s7_q <= equal_1678_s6_q;
      equal_2468_s7_q <= equal_2468_s6_q;
      and_2827_s7_q <= and_2469_s6_q & and_2826;
      and_2829_s7_q <= and_2469_s6_q & (~and_2826);
      and_2836_s7_q <= ends_cell_s6_q & so_s6_q;
      phase_s7_q <= phase_s6_q;
      equal_2956_s7_q <= equal_2956_s6_q;
      equal_2961_s7_q <= equal_2961;
      not_3002_s7_q <= not_3002_s6_q;
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
  logic not_1676;
  assign not_1676 = ~sample_pair_first_s7_q;
  // hls/stages/patches.hpp:311
  logic equal_1680;
  assign equal_1680 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1752;
  assign select_1752 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1995;
  assign sum_1995 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2830;
  assign select_2830 = and_2829_s7_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2832;
  assign select_2832 = and_2827_s7_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2830[15]}}, select_2830});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2833;
  assign select_2833 = and_2829_s7_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2833[15]}}, select_2833};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2835;
  assign select_2835 = and_2827_s7_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2836_s7_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:373
  logic and_2938;
  assign and_2938 = not_1676 & equal_1678_s7_q;
  logic [8:0] select_2939;
  assign select_2939 = and_2938 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s7_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2940;
  assign select_2940 = and_2938 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2941;
  assign select_2941 = sample_pair_first_s7_q ? select_2939 : select_2940;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2942;
  assign select_2942 = and_1672_s7_q ? select_2941[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2943;
  assign select_2943 = sample_pair_whole_s7_q ? select_2942 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2945;
  assign select_2945 = sample_pair_whole_s7_q ? (and_1672_s7_q ? select_2941[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2948;
  assign select_2948 = sample_pair_whole_s7_q ? (equal_1680 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2950;
  assign select_2950 = sample_pair_whole_s7_q ? (patches_band_rows_number_q + {4'h0, equal_1680}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2951;
  assign equal_2951 = phase_s7_q == 4'h0;
  // hls/stages/patches.hpp:331
  logic not_2952;
  assign not_2952 = ~equal_2951;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2954;
  assign select_2954 = sample_pair_whole_s7_q ? (phase_s7_q + {{2{not_2952}}, 1'b1, not_2952}) : patches_first_band_rows_to_next_q;
  logic select_2955;
  assign select_2955 = sample_pair_whole_s7_q ? equal_2951 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2966;
  assign select_2966 = equal_2956_s7_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2968;
  assign select_2968 = equal_2468_s7_q ? (select_2966 + {4'h0, equal_2961_s7_q}) : patches_choosing_number_q;
  logic select_2972;
  assign select_2972 = equal_2468_s7_q ? ((7'h2 < row_s7_q) & equal_2961_s7_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:520
  logic [4:0] select_2975;
  assign select_2975 = and_546_s7_q ? (equal_2468_s7_q ? select_2966 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3884;
  assign select_3884 = so_s7_q ? (and_2836_s7_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3886;
  assign sum_3886 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3887;
  assign select_3887 = sum_1995[5] ? {1'b1, sum_1995[4:0], region_across_rest_q[2:0]} : sum_3886;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3889;
  assign select_3889 = equal_2468_s7_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3892;
  assign select_3892 = equal_2468_s7_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1372; read in stage 7, written in stage 23: 7 < 23 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 33'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
`ifndef SYNTHESIS
  logic fresh_re;
  assign fresh_re = s7_en & and_647_s7_q;
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
    end else if (s7_en) begin
      registration_slope_row_q <= select_2832;
      registration_slope_change_q <= select_2835;
      registration_slope_q <= so_s7_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2943;
      patches_band_rows_number_q <= select_2945;
      patches_next_band_rows_to_next_q <= select_2948;
      patches_next_band_number_q <= select_2950;
      patches_first_band_rows_to_next_q <= select_2954;
      patches_first_band_number_q <= select_2955;
      patches_choosing_number_q <= and_546_s7_q ? select_2968 : patches_choosing_number_q;
      patches_chooses_q <= and_546_s7_q ? select_2972 : patches_chooses_q;
      patches_choosing_band_q <= select_2975;
      region_across_rest_q <= select_3884;
      region_across_back_q <= so_s7_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3887;
      columns_begin_rest_q <= and_546_s7_q ? select_3889 : columns_begin_rest_q;
      columns_begin_back_q <= and_546_s7_q ? select_3892 : columns_begin_back_q;
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
  logic [3:0] select_507_s8_q;
  logic equal_508_s8_q;
  logic [6:0] select_510_s8_q;
  logic [8:0] select_514_s8_q;
  logic and_520_s8_q;
  logic equal_526_s8_q;
  logic [6:0] last_s8_2_q;
  logic and_544_s8_q;
  logic and_546_s8_q;
  logic equal_571_s8_q;
  logic so_s8_q;
  logic equal_575_s8_q;
  logic or_576_s8_q;
  logic less_579_s8_q;
  logic not_580_s8_q;
  logic equal_590_s8_q;
  logic [84:0] left_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_614_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic [6:0] right_s8_q;
  logic [98:0] right_codes_rdata_s8_q;
  logic and_647_s8_q;
  logic [6:0] row_s8_q;
  logic and_1558_s8_q;
  logic equal_1559_s8_q;
  logic and_1672_s8_q;
  logic not_1676_s8_q;
  logic or_1682_s8_q;
  logic [16:0] select_1752_s8_q;
  logic sum_1995_s8_q;
  logic equal_2468_s8_q;
  logic not_3002_s8_q;
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
      registration_slope_s8_q <= registration_slope_q[27:16];
      patches_band_rows_number_s8_q <= patches_band_rows_number_q;
      patches_chooses_s8_q <= patches_chooses_q;
      patches_choosing_band_s8_q <= patches_choosing_band_q;
      select_507_s8_q <= select_507_s7_q;
      equal_508_s8_q <= equal_508_s7_q;
      select_510_s8_q <= select_510_s7_q;
      select_514_s8_q <= select_514_s7_q;
      and_520_s8_q <= and_520_s7_q;
      equal_526_s8_q <= equal_526_s7_q;
      last_s8_2_q <= last_s7_2_q;
      and_544_s8_q <= and_544_s7_q;
      and_546_s8_q <= and_546_s7_q;
      equal_571_s8_q <= equal_571_s7_q;
      so_s8_q <= so_s7_q;
      equal_575_s8_q <= equal_575_s7_q;
      or_576_s8_q <= or_576_s7_q;
      less_579_s8_q <= less_579_s7_q;
      not_580_s8_q <= not_580_s7_q;
      equal_590_s8_q <= equal_590_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_614_s8_q <= select_614_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      right_s8_q <= right_s7_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      and_647_s8_q <= and_647_s7_q;
      row_s8_q <= row_s7_q;
      and_1558_s8_q <= and_1558_s7_q;
      equal_1559_s8_q <= equal_1559_s7_q;
      and_1672_s8_q <= and_1672_s7_q;
      not_1676_s8_q <= not_1676;
      or_1682_s8_q <= (~equal_1678_s7_q) | (~equal_1680);
      select_1752_s8_q <= select_1752;
      sum_1995_s8_q <= sum_1995[5];
      equal_2468_s8_q <= equal_2468_s7_q;
      not_3002_s8_q <= not_3002_s7_q;
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
  // hls/stages/agreement.hpp:668
  logic equal_565;
  assign equal_565 = row_q == 7'h0;
  // hls/stages/agreement.hpp:975
  logic and_604;
  assign and_604 = (or_576_s8_q & (left_rdata_s8_q[67] & not_580_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:668
  logic not_744;
  assign not_744 = ~equal_565;
  // hls/stages/agreement.hpp:221
  logic and_759;
  assign and_759 = left_rdata_s8_q[48] & not_580_s8_q;
  logic and_760;
  assign and_760 = right_codes_rdata_s8_q[42] & not_580_s8_q;
  logic [11:0] select_761;
  assign select_761 = less_579_s8_q ? 12'h0 : left_rdata_s8_q[47:36];
  logic [11:0] select_762;
  assign select_762 = less_579_s8_q ? 12'h0 : right_codes_rdata_s8_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_766;
  assign select_766 = and_759 ? (and_760 ? (~(select_761 ^ select_762)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_782;
  assign and_782 = left_rdata_s8_q[66] & not_580_s8_q;
  logic and_783;
  assign and_783 = right_codes_rdata_s8_q[57] & not_580_s8_q;
  logic [11:0] select_784;
  assign select_784 = less_579_s8_q ? 12'h0 : left_rdata_s8_q[65:54];
  logic [11:0] select_785;
  assign select_785 = less_579_s8_q ? 12'h0 : right_codes_rdata_s8_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_789;
  assign select_789 = and_782 ? (and_783 ? (~(select_784 ^ select_785)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_799;
  assign and_799 = left_rdata_s8_q[84] & not_580_s8_q;
  logic and_800;
  assign and_800 = right_codes_rdata_s8_q[72] & not_580_s8_q;
  logic [11:0] select_801;
  assign select_801 = less_579_s8_q ? 12'h0 : left_rdata_s8_q[83:72];
  logic [11:0] select_802;
  assign select_802 = less_579_s8_q ? 12'h0 : right_codes_rdata_s8_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_806;
  assign select_806 = and_799 ? (and_800 ? (~(select_801 ^ select_802)) : 12'h0) : 12'h0;
  logic [11:0] select_1014;
  assign select_1014 = (slot_s8_q[0] ? and_800 : and_783) ? (~(select_761 ^ (slot_s8_q[0] ? select_802 : select_785))) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_1031;
  assign and_1031 = right_codes_rdata_s8_q[85] & not_580_s8_q;
  logic [11:0] select_1033;
  assign select_1033 = less_579_s8_q ? 12'h0 : right_codes_rdata_s8_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1037;
  assign select_1037 = (slot_s8_q[0] ? and_1031 : and_800) ? (~(select_784 ^ (slot_s8_q[0] ? select_1033 : select_802))) : 12'h0;
  // hls/stages/agreement.hpp:734
  logic select_1049;
  assign select_1049 = slot_s8_q[0] ? (right_codes_rdata_s8_q[98] & not_580_s8_q) : and_1031;
  logic [11:0] select_1051;
  assign select_1051 = slot_s8_q[0] ? (less_579_s8_q ? 12'h0 : right_codes_rdata_s8_q[97:86]) : select_1033;
  // hls/stages/agreement.hpp:221
  logic and_1260;
  assign and_1260 = right_codes_rdata_s8_q[27] & not_580_s8_q;
  // hls/stages/agreement.hpp:734
  logic select_1261;
  assign select_1261 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_580_s8_q) : and_1260;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1263;
  assign select_1263 = less_579_s8_q ? 12'h0 : right_codes_rdata_s8_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1264;
  assign select_1264 = slot_s8_q[0] ? (less_579_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1263;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1288;
  assign select_1288 = (slot_s8_q[0] ? and_1260 : and_760) ? (~(select_784 ^ (slot_s8_q[0] ? select_1263 : select_762))) : 12'h0;
  logic [11:0] select_1303;
  assign select_1303 = (slot_s8_q[0] ? and_760 : and_783) ? (~(select_801 ^ (slot_s8_q[0] ? select_762 : select_785))) : 12'h0;
  // hls/stages/patches.hpp:392
  logic not_1673;
  assign not_1673 = ~patches_begins_q;
  // hls/stages/patches.hpp:362
  logic and_1677;
  assign and_1677 = patches_capturing_q & not_1676_s8_q;
  // hls/stages/patches.hpp:125
  logic and_1685;
  assign and_1685 = (not_1673 & (patches_work_q == 3'h0)) & (~(and_1677 | or_1682_s8_q));
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s8_q[6:1]} < x_s8_q;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_576_s8_q ? (less_579_s8_q ? 6'h0 : best_left_rdata_s8_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1754;
  assign select_1754 = ($signed(10'h0) < $signed(select_1752_s8_q[16:7])) ? 14'h7f : select_1752_s8_q[13:0];
  // hls/stages/patches.hpp:534
  logic equal_1784;
  assign equal_1784 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:505
  logic equal_1786;
  assign equal_1786 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:499
  logic equal_1788;
  assign equal_1788 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1789;
  assign equal_1789 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:534
  logic or_1790;
  assign or_1790 = equal_1788 | equal_1789;
  // hls/stages/patches.hpp:460
  logic not_1791;
  assign not_1791 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_1813;
  assign select_1813 = and_1685 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1814;
  assign select_1814 = and_1672_s8_q ? select_1813 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1816;
  assign and_1816 = and_1677 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1820;
  assign select_1820 = and_1672_s8_q ? (and_1685 | (and_1677 & (~and_1816))) : patches_capturing_q;
  // hls/stages/patches.hpp:167
  logic not_1845;
  assign not_1845 = ~equal_1789;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1859;
  assign select_1859 = and_1672_s8_q ? {select_1813[4], select_1813[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:546
  logic less_1963;
  assign less_1963 = patches_step_q[4:0] < 5'h11;
  logic equal_1964;
  assign equal_1964 = patches_step_q[6:5] == 2'h0;
  logic not_1965;
  assign not_1965 = ~equal_1964;
  logic equal_1966;
  assign equal_1966 = patches_step_q[6:5] == 2'h3;
  logic not_1967;
  assign not_1967 = ~equal_1966;
  // hls/stages/patches.hpp:560
  logic select_1970;
  assign select_1970 = equal_1966 ? (less_1963 & (less_1963 & not_1967)) : less_1963;
  // hls/stages/agreement.hpp:460
  logic select_2565;
  assign select_2565 = equal_2468_s8_q ? (~({row_s8_q, 1'b0} < {sum_2562, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2726;
  assign select_2726 = or_576_s8_q ? (less_579_s8_q ? 8'h0 : best_left_rdata_s8_q[32:25]) : 8'h0;
  logic [7:0] select_2728;
  assign select_2728 = or_576_s8_q ? (less_579_s8_q ? 8'h0 : best_left_rdata_s8_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:91
  logic parity_2979;
  assign parity_2979 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2980;
  assign select_2980 = equal_2468_s8_q ? {patches_chance_q[14:0], parity_2979} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s8_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:393
  logic or_3043;
  assign or_3043 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3049;
  assign and_3049 = equal_1784 & not_1791;
  // hls/stages/patches.hpp:399
  logic and_3050;
  assign and_3050 = not_1845 & and_3049;
  logic [1:0] select_3052;
  assign select_3052 = equal_1786 ? 2'h0 : (equal_1788 ? 2'h3 : {equal_1789, and_3050});
  // hls/stages/patches.hpp:279
  logic equal_3054;
  assign equal_3054 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3055;
  assign not_3055 = ~equal_3054;
  // hls/stages/patches.hpp:279
  logic equal_3056;
  assign equal_3056 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3057;
  assign not_3057 = ~equal_3056;
  // hls/stages/patches.hpp:283
  logic not_3059;
  assign not_3059 = ~(patches_following_q == 3'h2);
  logic and_3062;
  assign and_3062 = (~(patches_following_q == 3'h1)) & not_3059;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3063;
  assign select_3063 = equal_3056 ? 2'h2 : {and_3062, not_3059};
  logic [3:0] select_3064;
  assign select_3064 = equal_3054 ? 4'h2 : {select_3063, {2{not_3057}}};
  // hls/stages/patches.hpp:405
  logic not_3067;
  assign not_3067 = ~or_3043;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3072;
  assign select_3072 = or_3043 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

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
      row_q <= and_546_s8_q ? (equal_2468_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_546_s8_q ? select_2565 : lower_half_q;
      patches_chance_q <= and_546_s8_q ? select_2980 : patches_chance_q;
      patches_capturing_q <= sample_pair_whole_s8_q ? select_1820 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s8_q ? select_1814 : patches_row_q;
      patches_work_q <= or_3043 ? following : patches_work_q;
      patches_second_q <= not_1673 & (patches_second_q | (patches_ends_q & equal_1784));
      patches_following_q <= equal_1784 ? {2'h0, and_3049} : {equal_1786, select_3052};
      patches_following_beats_q <= {select_3064, not_3055};
      patches_begins_q <= sample_pair_whole_s8_q & (and_1672_s8_q & and_1816);
      patches_ends_q <= not_3067 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3072;
      patches_step_q <= or_3043 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic [3:0] select_507_s9_q;
  logic equal_508_s9_q;
  logic [6:0] select_510_s9_q;
  logic [8:0] select_514_s9_q;
  logic and_520_s9_q;
  logic equal_526_s9_q;
  logic [6:0] last_s9_2_q;
  logic and_544_s9_q;
  logic and_546_s9_q;
  logic equal_565_s9_q;
  logic equal_571_s9_q;
  logic so_s9_q;
  logic equal_575_s9_q;
  logic or_576_s9_q;
  logic less_579_s9_q;
  logic not_580_s9_q;
  logic equal_590_s9_q;
  logic [62:0] left_rdata_s9_q;
  logic and_597_s9_q;
  logic and_605_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_614_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic and_636_s9_q;
  logic [77:0] right_codes_rdata_s9_q;
  logic and_641_s9_q;
  logic and_643_s9_q;
  logic and_647_s9_q;
  logic [32:0] fresh_rdata_s9_q;
  logic equal_676_s9_q;
  logic and_745_s9_q;
  logic and_746_s9_q;
  logic and_747_s9_q;
  logic and_748_s9_q;
  logic and_749_s9_q;
  logic and_750_s9_q;
  logic and_751_s9_q;
  logic and_752_s9_q;
  logic and_753_s9_q;
  logic and_754_s9_q;
  logic and_759_s9_q;
  logic [11:0] select_766_s9_q;
  logic and_782_s9_q;
  logic [11:0] select_789_s9_q;
  logic and_799_s9_q;
  logic [11:0] select_806_s9_q;
  logic [11:0] select_1014_s9_q;
  logic [11:0] select_1037_s9_q;
  logic [11:0] select_1054_s9_q;
  logic [11:0] select_1267_s9_q;
  logic [11:0] select_1288_s9_q;
  logic [11:0] select_1303_s9_q;
  logic and_1558_s9_q;
  logic equal_1559_s9_q;
  logic and_1672_s9_q;
  logic and_1685_s9_q;
  logic right_3_s9_q;
  logic less_1699_s9_q;
  logic [5:0] b_s9_q;
  logic [13:0] select_1754_s9_q;
  logic equal_1784_s9_q;
  logic equal_1786_s9_q;
  logic equal_1788_s9_q;
  logic equal_1789_s9_q;
  logic or_1790_s9_q;
  logic and_1793_s9_q;
  logic [4:0] select_1814_s9_q;
  logic select_1820_s9_q;
  logic and_1826_s9_q;
  logic and_1846_s9_q;
  logic [3:0] select_1859_s9_q;
  logic less_1963_s9_q;
  logic equal_1964_s9_q;
  logic not_1965_s9_q;
  logic equal_1966_s9_q;
  logic not_1967_s9_q;
  logic select_1970_s9_q;
  logic and_1971_s9_q;
  logic sum_1995_s9_q;
  logic and_2016_s9_q;
  logic and_2133_s9_q;
  logic equal_2279_s9_q;
  logic equal_2468_s9_q;
  logic and_2594_s9_q;
  logic [7:0] select_2726_s9_q;
  logic [7:0] select_2728_s9_q;
  logic [5:0] further_s9_q;
  logic not_3002_s9_q;
  logic or_3043_s9_q;
  logic not_3067_s9_q;
  logic and_3539_s9_q;
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
      select_507_s9_q <= select_507_s8_q;
      equal_508_s9_q <= equal_508_s8_q;
      select_510_s9_q <= select_510_s8_q;
      select_514_s9_q <= select_514_s8_q;
      and_520_s9_q <= and_520_s8_q;
      equal_526_s9_q <= equal_526_s8_q;
      last_s9_2_q <= last_s8_2_q;
      and_544_s9_q <= and_544_s8_q;
      and_546_s9_q <= and_546_s8_q;
      equal_565_s9_q <= equal_565;
      equal_571_s9_q <= equal_571_s8_q;
      so_s9_q <= so_s8_q;
      equal_575_s9_q <= equal_575_s8_q;
      or_576_s9_q <= or_576_s8_q;
      less_579_s9_q <= less_579_s8_q;
      not_580_s9_q <= not_580_s8_q;
      equal_590_s9_q <= equal_590_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[65:49], left_rdata_s8_q[47:31], left_rdata_s8_q[29:13], left_rdata_s8_q[11:0]};
      and_597_s9_q <= or_576_s8_q & (left_rdata_s8_q[70] & not_580_s8_q);
      and_605_s9_q <= (or_576_s8_q & (left_rdata_s8_q[68] & not_580_s8_q)) & and_604;
      x_s9_2_q <= x_s8_2_q;
      select_614_s9_q <= select_614_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      and_636_s9_q <= or_576_s8_q & (left_rdata_s8_q[71] & not_580_s8_q);
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[84:73], right_codes_rdata_s8_q[71:60], right_codes_rdata_s8_q[56:43], right_codes_rdata_s8_q[41:28], right_codes_rdata_s8_q[26:13], right_codes_rdata_s8_q[11:0]};
      and_641_s9_q <= or_576_s8_q & (right_codes_rdata_s8_q[58] & not_580_s8_q);
      and_643_s9_q <= or_576_s8_q & (right_codes_rdata_s8_q[59] & not_580_s8_q);
      and_647_s9_q <= and_647_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_676_s9_q <= row_s8_q == 7'h0;
      and_745_s9_q <= left_rdata_s8_q[12] & not_744;
      and_746_s9_q <= left_rdata_s8_q[30] & not_744;
      and_747_s9_q <= left_rdata_s8_q[48] & not_744;
      and_748_s9_q <= left_rdata_s8_q[66] & not_744;
      and_749_s9_q <= right_codes_rdata_s8_q[12] & not_744;
      and_750_s9_q <= right_codes_rdata_s8_q[27] & not_744;
      and_751_s9_q <= right_codes_rdata_s8_q[42] & not_744;
      and_752_s9_q <= right_codes_rdata_s8_q[57] & not_744;
      and_753_s9_q <= right_codes_rdata_s8_q[72] & not_744;
      and_754_s9_q <= right_codes_rdata_s8_q[85] & not_744;
      and_759_s9_q <= and_759;
      select_766_s9_q <= select_766;
      and_782_s9_q <= and_782;
      select_789_s9_q <= select_789;
      and_799_s9_q <= and_799;
      select_806_s9_q <= select_806;
      select_1014_s9_q <= select_1014;
      select_1037_s9_q <= select_1037;
      select_1054_s9_q <= select_1049 ? (~(select_801 ^ select_1051)) : 12'h0;
      select_1267_s9_q <= select_1261 ? (~(select_761 ^ select_1264)) : 12'h0;
      select_1288_s9_q <= select_1288;
      select_1303_s9_q <= select_1303;
      and_1558_s9_q <= and_1558_s8_q;
      equal_1559_s9_q <= equal_1559_s8_q;
      and_1672_s9_q <= and_1672_s8_q;
      and_1685_s9_q <= and_1685;
      right_3_s9_q <= right_3;
      less_1699_s9_q <= 6'h4 < row_q[6:1];
      b_s9_q <= b;
      select_1754_s9_q <= select_1754;
      equal_1784_s9_q <= equal_1784;
      equal_1786_s9_q <= equal_1786;
      equal_1788_s9_q <= equal_1788;
      equal_1789_s9_q <= equal_1789;
      or_1790_s9_q <= or_1790;
      and_1793_s9_q <= or_1790 & (equal_1789 & not_1791);
      select_1814_s9_q <= select_1814;
      select_1820_s9_q <= select_1820;
      and_1826_s9_q <= or_1790 & (patches_second_q & equal_1789);
      and_1846_s9_q <= not_1845 & or_1790;
      select_1859_s9_q <= select_1859;
      less_1963_s9_q <= less_1963;
      equal_1964_s9_q <= equal_1964;
      not_1965_s9_q <= not_1965;
      equal_1966_s9_q <= equal_1966;
      not_1967_s9_q <= not_1967;
      select_1970_s9_q <= select_1970;
      and_1971_s9_q <= not_1965 & select_1970;
      sum_1995_s9_q <= sum_1995_s8_q;
      and_2016_s9_q <= or_576_s8_q & (left_rdata_s8_q[69] & not_580_s8_q);
      and_2133_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2279_s9_q <= (last_s8_2_q | row_s8_q) == 7'h0;
      equal_2468_s9_q <= equal_2468_s8_q;
      and_2594_s9_q <= not_580_s8_q & and_604;
      select_2726_s9_q <= select_2726;
      select_2728_s9_q <= select_2728;
      further_s9_q <= further;
      not_3002_s9_q <= not_3002_s8_q;
      or_3043_s9_q <= or_3043;
      not_3067_s9_q <= not_3067;
      and_3539_s9_q <= less_1963 & (patches_step_q[6:5] == 2'h1);
      equal_3546_s9_q <= patches_step_q[6:5] == 2'h2;
      less_3872_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_4091_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/count_bits.hpp:24
  logic parity_772;
  assign parity_772 = ^select_766_s9_q[5:3];
  logic parity_775;
  assign parity_775 = ^select_766_s9_q[8:6];
  logic parity_778;
  assign parity_778 = ^select_766_s9_q[11:3];
  logic parity_792;
  assign parity_792 = ^select_789_s9_q[8:6];
  logic parity_795;
  assign parity_795 = ^select_789_s9_q[11:9];
  logic parity_812;
  assign parity_812 = ^select_806_s9_q[2:0];
  logic parity_815;
  assign parity_815 = ^select_806_s9_q[5:3];
  logic parity_818;
  assign parity_818 = ^select_806_s9_q[8:0];
  logic parity_824;
  assign parity_824 = ^select_806_s9_q[11:9];
  logic parity_827;
  assign parity_827 = ^select_789_s9_q[2:0];
  logic parity_830;
  assign parity_830 = ^{select_806_s9_q[11:9], select_789_s9_q[5:0]};
  logic parity_833;
  assign parity_833 = ^{select_806_s9_q, select_789_s9_q, select_766_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_838;
  assign or_838 = (select_766_s9_q[1:0] == 2'h3) | (select_766_s9_q[2] & (select_766_s9_q[0] | select_766_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_842;
  assign or_842 = (select_789_s9_q[7:6] == 2'h3) | (select_789_s9_q[8] & (select_789_s9_q[6] | select_789_s9_q[7]));
  logic or_846;
  assign or_846 = (select_789_s9_q[10:9] == 2'h3) | (select_789_s9_q[11] & (select_789_s9_q[9] | select_789_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_854;
  assign or_854 = (select_806_s9_q[7:6] == 2'h3) | (select_806_s9_q[8] & (~(select_806_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_858;
  assign or_858 = (select_806_s9_q[1:0] == 2'h3) | (select_806_s9_q[2] & (select_806_s9_q[0] | select_806_s9_q[1]));
  logic or_862;
  assign or_862 = (select_806_s9_q[4:3] == 2'h3) | (select_806_s9_q[5] & (select_806_s9_q[3] | select_806_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_865;
  assign parity_865 = ^{or_862, or_858, or_854};
  // hls/stages/count_bits.hpp:23
  logic or_869;
  assign or_869 = (select_789_s9_q[4:3] == 2'h3) | (select_789_s9_q[5] & (select_789_s9_q[3] | select_789_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_873;
  assign or_873 = (select_806_s9_q[10:9] == 2'h3) | (select_806_s9_q[11] & (select_806_s9_q[9] | select_806_s9_q[10]));
  logic or_877;
  assign or_877 = (select_789_s9_q[1:0] == 2'h3) | (select_789_s9_q[2] & (select_789_s9_q[0] | select_789_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_880;
  assign parity_880 = ^{or_877, or_873, or_869};
  logic parity_883;
  assign parity_883 = ^{or_877, or_873, or_869, or_862, or_858, or_854, or_846, or_842, or_838};
  // hls/stages/count_bits.hpp:25
  logic or_888;
  assign or_888 = (parity_772 & parity_775) | ((^select_766_s9_q[11:9]) & (parity_772 | parity_775));
  logic and_891;
  assign and_891 = (^{select_789_s9_q[11:6], select_766_s9_q[2:0]}) & (parity_818 | parity_830);
  // hls/stages/count_bits.hpp:23
  logic or_899;
  assign or_899 = (select_766_s9_q[10:9] == 2'h3) | (select_766_s9_q[11] & (select_766_s9_q[9] | select_766_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_903;
  assign or_903 = (select_766_s9_q[4:3] == 2'h3) | (select_766_s9_q[5] & (select_766_s9_q[3] | select_766_s9_q[4]));
  logic or_907;
  assign or_907 = (select_766_s9_q[7:6] == 2'h3) | (select_766_s9_q[8] & (select_766_s9_q[6] | select_766_s9_q[7]));
  logic or_914;
  assign or_914 = (parity_792 & parity_795) | ((^select_766_s9_q[2:0]) & (parity_792 | parity_795));
  logic or_918;
  assign or_918 = (parity_812 & parity_815) | ((^select_806_s9_q[8:6]) & (parity_812 | parity_815));
  logic or_922;
  assign or_922 = (parity_824 & parity_827) | ((^select_789_s9_q[5:3]) & (parity_824 | parity_827));
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1015;
  assign select_1015 = and_759_s9_q ? select_1014_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1021;
  assign parity_1021 = ^select_1015[5:3];
  logic parity_1024;
  assign parity_1024 = ^select_1015[8:6];
  logic parity_1027;
  assign parity_1027 = ^select_1015[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1038;
  assign select_1038 = and_782_s9_q ? select_1037_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1041;
  assign parity_1041 = ^select_1038[8:6];
  logic parity_1044;
  assign parity_1044 = ^select_1038[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1055;
  assign select_1055 = and_799_s9_q ? select_1054_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1061;
  assign parity_1061 = ^select_1055[2:0];
  logic parity_1064;
  assign parity_1064 = ^select_1055[5:3];
  logic parity_1067;
  assign parity_1067 = ^select_1055[8:0];
  logic parity_1073;
  assign parity_1073 = ^select_1055[11:9];
  logic parity_1076;
  assign parity_1076 = ^select_1038[2:0];
  logic parity_1079;
  assign parity_1079 = ^{select_1055[11:9], select_1038[5:0]};
  logic parity_1082;
  assign parity_1082 = ^{select_1055, select_1038, select_1015[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1087;
  assign or_1087 = (select_1015[1:0] == 2'h3) | (select_1015[2] & (select_1015[0] | select_1015[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1091;
  assign or_1091 = (select_1038[7:6] == 2'h3) | (select_1038[8] & (select_1038[6] | select_1038[7]));
  logic or_1095;
  assign or_1095 = (select_1038[10:9] == 2'h3) | (select_1038[11] & (select_1038[9] | select_1038[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1103;
  assign or_1103 = (select_1055[7:6] == 2'h3) | (select_1055[8] & (~(select_1055[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1107;
  assign or_1107 = (select_1055[1:0] == 2'h3) | (select_1055[2] & (select_1055[0] | select_1055[1]));
  logic or_1111;
  assign or_1111 = (select_1055[4:3] == 2'h3) | (select_1055[5] & (select_1055[3] | select_1055[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1114;
  assign parity_1114 = ^{or_1111, or_1107, or_1103};
  // hls/stages/count_bits.hpp:23
  logic or_1118;
  assign or_1118 = (select_1038[4:3] == 2'h3) | (select_1038[5] & (select_1038[3] | select_1038[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1122;
  assign or_1122 = (select_1055[10:9] == 2'h3) | (select_1055[11] & (select_1055[9] | select_1055[10]));
  logic or_1126;
  assign or_1126 = (select_1038[1:0] == 2'h3) | (select_1038[2] & (select_1038[0] | select_1038[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1129;
  assign parity_1129 = ^{or_1126, or_1122, or_1118};
  logic parity_1132;
  assign parity_1132 = ^{or_1126, or_1122, or_1118, or_1111, or_1107, or_1103, or_1095, or_1091, or_1087};
  // hls/stages/count_bits.hpp:25
  logic or_1137;
  assign or_1137 = (parity_1021 & parity_1024) | ((^select_1015[11:9]) & (parity_1021 | parity_1024));
  logic and_1140;
  assign and_1140 = (^{select_1038[11:6], select_1015[2:0]}) & (parity_1067 | parity_1079);
  // hls/stages/count_bits.hpp:23
  logic or_1148;
  assign or_1148 = (select_1015[10:9] == 2'h3) | (select_1015[11] & (select_1015[9] | select_1015[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1152;
  assign or_1152 = (select_1015[4:3] == 2'h3) | (select_1015[5] & (select_1015[3] | select_1015[4]));
  logic or_1156;
  assign or_1156 = (select_1015[7:6] == 2'h3) | (select_1015[8] & (select_1015[6] | select_1015[7]));
  logic or_1163;
  assign or_1163 = (parity_1041 & parity_1044) | ((^select_1015[2:0]) & (parity_1041 | parity_1044));
  logic or_1167;
  assign or_1167 = (parity_1061 & parity_1064) | ((^select_1055[8:6]) & (parity_1061 | parity_1064));
  logic or_1171;
  assign or_1171 = (parity_1073 & parity_1076) | ((^select_1038[5:3]) & (parity_1073 | parity_1076));
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1268;
  assign select_1268 = and_759_s9_q ? select_1267_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1274;
  assign parity_1274 = ^select_1268[5:3];
  logic parity_1277;
  assign parity_1277 = ^select_1268[8:6];
  logic parity_1280;
  assign parity_1280 = ^select_1268[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1289;
  assign select_1289 = and_782_s9_q ? select_1288_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1292;
  assign parity_1292 = ^select_1289[8:6];
  logic parity_1295;
  assign parity_1295 = ^select_1289[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1304;
  assign select_1304 = and_799_s9_q ? select_1303_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1310;
  assign parity_1310 = ^select_1304[2:0];
  logic parity_1313;
  assign parity_1313 = ^select_1304[5:3];
  logic parity_1316;
  assign parity_1316 = ^select_1304[8:0];
  logic parity_1322;
  assign parity_1322 = ^select_1304[11:9];
  logic parity_1325;
  assign parity_1325 = ^select_1289[2:0];
  logic parity_1328;
  assign parity_1328 = ^{select_1304[11:9], select_1289[5:0]};
  logic parity_1331;
  assign parity_1331 = ^{select_1304, select_1289, select_1268[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1336;
  assign or_1336 = (select_1268[1:0] == 2'h3) | (select_1268[2] & (select_1268[0] | select_1268[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1340;
  assign or_1340 = (select_1289[7:6] == 2'h3) | (select_1289[8] & (select_1289[6] | select_1289[7]));
  logic or_1344;
  assign or_1344 = (select_1289[10:9] == 2'h3) | (select_1289[11] & (select_1289[9] | select_1289[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1352;
  assign or_1352 = (select_1304[7:6] == 2'h3) | (select_1304[8] & (~(select_1304[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1356;
  assign or_1356 = (select_1304[1:0] == 2'h3) | (select_1304[2] & (select_1304[0] | select_1304[1]));
  logic or_1360;
  assign or_1360 = (select_1304[4:3] == 2'h3) | (select_1304[5] & (select_1304[3] | select_1304[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1363;
  assign parity_1363 = ^{or_1360, or_1356, or_1352};
  // hls/stages/count_bits.hpp:23
  logic or_1367;
  assign or_1367 = (select_1289[4:3] == 2'h3) | (select_1289[5] & (select_1289[3] | select_1289[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1371;
  assign or_1371 = (select_1304[10:9] == 2'h3) | (select_1304[11] & (select_1304[9] | select_1304[10]));
  logic or_1375;
  assign or_1375 = (select_1289[1:0] == 2'h3) | (select_1289[2] & (select_1289[0] | select_1289[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1378;
  assign parity_1378 = ^{or_1375, or_1371, or_1367};
  logic parity_1381;
  assign parity_1381 = ^{or_1375, or_1371, or_1367, or_1360, or_1356, or_1352, or_1344, or_1340, or_1336};
  // hls/stages/count_bits.hpp:25
  logic or_1386;
  assign or_1386 = (parity_1274 & parity_1277) | ((^select_1268[11:9]) & (parity_1274 | parity_1277));
  logic and_1389;
  assign and_1389 = (^{select_1289[11:6], select_1268[2:0]}) & (parity_1316 | parity_1328);
  // hls/stages/count_bits.hpp:23
  logic or_1397;
  assign or_1397 = (select_1268[10:9] == 2'h3) | (select_1268[11] & (select_1268[9] | select_1268[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1401;
  assign or_1401 = (select_1268[4:3] == 2'h3) | (select_1268[5] & (select_1268[3] | select_1268[4]));
  logic or_1405;
  assign or_1405 = (select_1268[7:6] == 2'h3) | (select_1268[8] & (select_1268[6] | select_1268[7]));
  logic or_1412;
  assign or_1412 = (parity_1292 & parity_1295) | ((^select_1268[2:0]) & (parity_1292 | parity_1295));
  logic or_1416;
  assign or_1416 = (parity_1310 & parity_1313) | ((^select_1304[8:6]) & (parity_1310 | parity_1313));
  logic or_1420;
  assign or_1420 = (parity_1322 & parity_1325) | ((^select_1289[5:3]) & (parity_1322 | parity_1325));
  // hls/stages/agreement.hpp:247
  logic or_1579;
  assign or_1579 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));
  // hls/stages/agreement.hpp:1009
  logic [5:0] sum_1644;
  assign sum_1644 = {1'b0, last_s9_q[6:2]} + 6'h1;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1728;
  assign sum_1728 = {2'h0, x_s9_q} + {{4{b_s9_q[5]}}, b_s9_q};
  // hls/stages/registration.hpp:213
  logic [9:0] select_1755;
  assign select_1755 = b_s9_q[4] ? select_1754_s9_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1760;
  assign sum_1760 = (b_s9_q[0] ? select_1754_s9_q[13:1] : 13'h0) + (b_s9_q[1] ? select_1754_s9_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1761;
  assign select_1761 = b_s9_q[2] ? select_1754_s9_q[11:0] : 12'h0;
  // hls/stages/patches.hpp:512
  logic not_1785;
  assign not_1785 = ~equal_1784_s9_q;
  // hls/stages/patches.hpp:458
  logic not_1787;
  assign not_1787 = ~equal_1786_s9_q;
  logic and_1869;
  assign and_1869 = not_1785 & (or_1790_s9_q & not_1787);
  // hls/stages/patches.hpp:184
  logic and_1973;
  assign and_1973 = equal_1784_s9_q & (less_1963_s9_q ? and_1971_s9_q : select_1970_s9_q);
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2724;
  assign select_2724 = or_576_s9_q ? (less_579_s9_q ? 8'h0 : best_left_rdata_s9_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2726_s9_q} - {1'b0, select_2728_s9_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2985;
  assign select_2985 = right_3_s9_q ? last_s9_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s9_q} + {1'b0, select_2985};
  // hls/stages/patches.hpp:126
  logic select_3004;
  assign select_3004 = and_1672_s9_q ? (and_1685_s9_q ? not_3002_s9_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:187
  logic [4:0] select_3074;
  assign select_3074 = or_3043_s9_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:560
  logic select_3542;
  assign select_3542 = equal_1966_s9_q ? (less_1963_s9_q ? (not_1967_s9_q & and_3539_s9_q) : and_3539_s9_q) : and_3539_s9_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:779; read in stage 9, written in stage 22: 9 < 22 < 9 + DISTANCE.
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
  assign patches_right_0_re = s9_en & (not_1785 & (not_1787 & and_1793_s9_q));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:779; read in stage 9, written in stage 22: 9 < 22 < 9 + DISTANCE.
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
  assign patches_right_1_re = s9_en & (not_1785 & (not_1787 & and_1826_s9_q));
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:791; read in stage 9, written in stage 13: 9 < 13 < 9 + DISTANCE.
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
  assign patches_columns_above_re = s9_en & and_1869;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:811; read in stage 9, written in stage 24: 9 < 24 < 9 + DISTANCE.
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
  assign patches_rows_re = s9_en & and_1973;
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_647_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_748_s9_q, left_rdata_s9_q[62:46], and_747_s9_q, left_rdata_s9_q[45:29], and_746_s9_q, left_rdata_s9_q[28:12], and_745_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[30:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_647_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_754_s9_q, right_codes_rdata_s9_q[77:66], and_753_s9_q, right_codes_rdata_s9_q[65:54], and_752_s9_q, right_codes_rdata_s9_q[53:40], and_751_s9_q, right_codes_rdata_s9_q[39:26], and_750_s9_q, right_codes_rdata_s9_q[25:12], and_749_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[32:31], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
      patches_lower_q <= sample_pair_whole_s9_q ? select_3004 : patches_lower_q;
      patches_code_row_q <= select_3074;
      patches_column_q <= or_3043_s9_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3067_s9_q & (patches_column_q == 5'h1e);
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
  logic [3:0] select_507_s10_q;
  logic equal_508_s10_q;
  logic [6:0] select_510_s10_q;
  logic [8:0] select_514_s10_q;
  logic and_520_s10_q;
  logic equal_526_s10_q;
  logic [6:0] last_s10_q;
  logic and_544_s10_q;
  logic and_546_s10_q;
  logic equal_565_s10_q;
  logic equal_571_s10_q;
  logic so_s10_q;
  logic equal_575_s10_q;
  logic or_576_s10_q;
  logic less_579_s10_q;
  logic not_580_s10_q;
  logic equal_590_s10_q;
  logic and_597_s10_q;
  logic and_605_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_614_s10_q;
  logic [61:0] best_left_rdata_s10_q;
  logic [6:0] select_623_s10_q;
  logic [6:0] right_s10_q;
  logic and_636_s10_q;
  logic and_641_s10_q;
  logic and_643_s10_q;
  logic equal_676_s10_q;
  logic xor_834_s10_q;
  logic parity_883_s10_q;
  logic and_884_s10_q;
  logic or_888_s10_q;
  logic or_892_s10_q;
  logic or_899_s10_q;
  logic or_903_s10_q;
  logic or_907_s10_q;
  logic or_914_s10_q;
  logic or_918_s10_q;
  logic or_922_s10_q;
  logic and_931_s10_q;
  logic and_933_s10_q;
  logic or_945_s10_q;
  logic or_949_s10_q;
  logic or_953_s10_q;
  logic xor_1083_s10_q;
  logic parity_1098_s10_q;
  logic parity_1132_s10_q;
  logic and_1133_s10_q;
  logic or_1137_s10_q;
  logic or_1141_s10_q;
  logic or_1148_s10_q;
  logic or_1152_s10_q;
  logic or_1156_s10_q;
  logic or_1163_s10_q;
  logic or_1167_s10_q;
  logic or_1171_s10_q;
  logic and_1180_s10_q;
  logic or_1181_s10_q;
  logic or_1194_s10_q;
  logic or_1198_s10_q;
  logic or_1202_s10_q;
  logic xor_1332_s10_q;
  logic parity_1347_s10_q;
  logic parity_1381_s10_q;
  logic and_1382_s10_q;
  logic or_1386_s10_q;
  logic or_1390_s10_q;
  logic or_1397_s10_q;
  logic or_1401_s10_q;
  logic or_1405_s10_q;
  logic or_1412_s10_q;
  logic or_1416_s10_q;
  logic or_1420_s10_q;
  logic and_1429_s10_q;
  logic or_1430_s10_q;
  logic or_1443_s10_q;
  logic or_1447_s10_q;
  logic or_1451_s10_q;
  logic and_1558_s10_q;
  logic equal_1559_s10_q;
  logic or_1579_s10_q;
  logic less_1645_s10_q;
  logic and_1672_s10_q;
  logic and_1685_s10_q;
  logic right_3_s10_q;
  logic less_1699_s10_q;
  logic [5:0] b_s10_q;
  logic less_1720_s10_q;
  logic not_1724_s10_q;
  logic less_1729_s10_q;
  logic less_1730_s10_q;
  logic select_1755_s10_q;
  logic [8:0] difference_1757_s10_q;
  logic [11:0] sum_1760_s10_q;
  logic select_1761_s10_q;
  logic [10:0] sum_1763_s10_q;
  logic equal_1777_s10_q;
  logic equal_1784_s10_q;
  logic not_1785_s10_q;
  logic equal_1786_s10_q;
  logic not_1787_s10_q;
  logic equal_1788_s10_q;
  logic equal_1789_s10_q;
  logic or_1790_s10_q;
  logic [4:0] select_1814_s10_q;
  logic select_1820_s10_q;
  logic and_1848_s10_q;
  logic [3:0] select_1859_s10_q;
  logic and_1869_s10_q;
  logic less_1963_s10_q;
  logic equal_1964_s10_q;
  logic not_1965_s10_q;
  logic equal_1966_s10_q;
  logic not_1967_s10_q;
  logic sum_1995_s10_q;
  logic and_2016_s10_q;
  logic and_2136_s10_q;
  logic equal_2279_s10_q;
  logic equal_2468_s10_q;
  logic and_2595_s10_q;
  logic equal_2680_s10_q;
  logic [7:0] select_2724_s10_q;
  logic rise_2_s10_q;
  logic [7:0] select_2730_s10_q;
  logic [7:0] xor_2735_s10_q;
  logic less_2761_s10_q;
  logic not_2988_s10_q;
  logic or_3043_s10_q;
  logic not_3067_s10_q;
  logic select_3544_s10_q;
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
      patches_lower_s10_q <= patches_lower_q;
      patches_second_s10_q <= patches_second_s9_q;
      patches_code_row_s10_q <= patches_code_row_q;
      patches_column_s10_q <= patches_column_q;
      patches_step_s10_q <= patches_step_s9_q;
      select_507_s10_q <= select_507_s9_q;
      equal_508_s10_q <= equal_508_s9_q;
      select_510_s10_q <= select_510_s9_q;
      select_514_s10_q <= select_514_s9_q;
      and_520_s10_q <= and_520_s9_q;
      equal_526_s10_q <= equal_526_s9_q;
      last_s10_q <= last_s9_2_q;
      and_544_s10_q <= and_544_s9_q;
      and_546_s10_q <= and_546_s9_q;
      equal_565_s10_q <= equal_565_s9_q;
      equal_571_s10_q <= equal_571_s9_q;
      so_s10_q <= so_s9_q;
      equal_575_s10_q <= equal_575_s9_q;
      or_576_s10_q <= or_576_s9_q;
      less_579_s10_q <= less_579_s9_q;
      not_580_s10_q <= not_580_s9_q;
      equal_590_s10_q <= equal_590_s9_q;
      and_597_s10_q <= and_597_s9_q;
      and_605_s10_q <= and_605_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_614_s10_q <= select_614_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_623_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      and_636_s10_q <= and_636_s9_q;
      and_641_s10_q <= and_641_s9_q;
      and_643_s10_q <= and_643_s9_q;
      equal_676_s10_q <= equal_676_s9_q;
      xor_834_s10_q <= parity_778 ^ parity_833;
      parity_883_s10_q <= parity_883;
      and_884_s10_q <= parity_778 & parity_833;
      or_888_s10_q <= or_888;
      or_892_s10_q <= (parity_818 & parity_830) | and_891;
      or_899_s10_q <= or_899;
      or_903_s10_q <= or_903;
      or_907_s10_q <= or_907;
      or_914_s10_q <= or_914;
      or_918_s10_q <= or_918;
      or_922_s10_q <= or_922;
      and_931_s10_q <= parity_865 & parity_880;
      and_933_s10_q <= (^{or_846, or_842, or_838}) & (parity_865 | parity_880);
      or_945_s10_q <= (or_842 & or_846) | (or_838 & (or_842 | or_846));
      or_949_s10_q <= (or_858 & or_862) | (or_854 & (or_858 | or_862));
      or_953_s10_q <= (or_873 & or_877) | (or_869 & (or_873 | or_877));
      xor_1083_s10_q <= parity_1027 ^ parity_1082;
      parity_1098_s10_q <= ^{or_1095, or_1091, or_1087};
      parity_1132_s10_q <= parity_1132;
      and_1133_s10_q <= parity_1027 & parity_1082;
      or_1137_s10_q <= or_1137;
      or_1141_s10_q <= (parity_1067 & parity_1079) | and_1140;
      or_1148_s10_q <= or_1148;
      or_1152_s10_q <= or_1152;
      or_1156_s10_q <= or_1156;
      or_1163_s10_q <= or_1163;
      or_1167_s10_q <= or_1167;
      or_1171_s10_q <= or_1171;
      and_1180_s10_q <= parity_1114 & parity_1129;
      or_1181_s10_q <= parity_1114 | parity_1129;
      or_1194_s10_q <= (or_1091 & or_1095) | (or_1087 & (or_1091 | or_1095));
      or_1198_s10_q <= (or_1107 & or_1111) | (or_1103 & (or_1107 | or_1111));
      or_1202_s10_q <= (or_1122 & or_1126) | (or_1118 & (or_1122 | or_1126));
      xor_1332_s10_q <= parity_1280 ^ parity_1331;
      parity_1347_s10_q <= ^{or_1344, or_1340, or_1336};
      parity_1381_s10_q <= parity_1381;
      and_1382_s10_q <= parity_1280 & parity_1331;
      or_1386_s10_q <= or_1386;
      or_1390_s10_q <= (parity_1316 & parity_1328) | and_1389;
      or_1397_s10_q <= or_1397;
      or_1401_s10_q <= or_1401;
      or_1405_s10_q <= or_1405;
      or_1412_s10_q <= or_1412;
      or_1416_s10_q <= or_1416;
      or_1420_s10_q <= or_1420;
      and_1429_s10_q <= parity_1363 & parity_1378;
      or_1430_s10_q <= parity_1363 | parity_1378;
      or_1443_s10_q <= (or_1340 & or_1344) | (or_1336 & (or_1340 | or_1344));
      or_1447_s10_q <= (or_1356 & or_1360) | (or_1352 & (or_1356 | or_1360));
      or_1451_s10_q <= (or_1371 & or_1375) | (or_1367 & (or_1371 | or_1375));
      and_1558_s10_q <= and_1558_s9_q;
      equal_1559_s10_q <= equal_1559_s9_q;
      or_1579_s10_q <= or_1579;
      less_1645_s10_q <= {1'b0, sum_1644, last_s9_q[1]} < x_s9_q;
      and_1672_s10_q <= and_1672_s9_q;
      and_1685_s10_q <= and_1685_s9_q;
      right_3_s10_q <= right_3_s9_q;
      less_1699_s10_q <= less_1699_s9_q;
      b_s10_q <= b_s9_q;
      less_1720_s10_q <= {3'h0, last_s9_q[6:1]} < ({1'b0, x_s9_q} + 9'h1);
      not_1724_s10_q <= ~(x_s9_q < {1'b0, last_s9_q});
      less_1729_s10_q <= $signed(10'h0) < $signed(sum_1728);
      less_1730_s10_q <= $signed(sum_1728) < $signed({3'h0, last_s9_q});
      select_1755_s10_q <= select_1755[0];
      difference_1757_s10_q <= select_1755[9:1] - (b_s9_q[5] ? select_1754_s9_q[8:0] : 9'h0);
      sum_1760_s10_q <= sum_1760[12:1];
      select_1761_s10_q <= select_1761[0];
      sum_1763_s10_q <= select_1761[11:1] + (b_s9_q[3] ? select_1754_s9_q[10:0] : 11'h0);
      equal_1777_s10_q <= x_s9_q == {1'b0, last_s9_q};
      equal_1784_s10_q <= equal_1784_s9_q;
      not_1785_s10_q <= not_1785;
      equal_1786_s10_q <= equal_1786_s9_q;
      not_1787_s10_q <= not_1787;
      equal_1788_s10_q <= equal_1788_s9_q;
      equal_1789_s10_q <= equal_1789_s9_q;
      or_1790_s10_q <= or_1790_s9_q;
      select_1814_s10_q <= select_1814_s9_q;
      select_1820_s10_q <= select_1820_s9_q;
      and_1848_s10_q <= not_1785 & (not_1787 & and_1846_s9_q);
      select_1859_s10_q <= select_1859_s9_q;
      and_1869_s10_q <= and_1869;
      less_1963_s10_q <= less_1963_s9_q;
      equal_1964_s10_q <= equal_1964_s9_q;
      not_1965_s10_q <= not_1965_s9_q;
      equal_1966_s10_q <= equal_1966_s9_q;
      not_1967_s10_q <= not_1967_s9_q;
      sum_1995_s10_q <= sum_1995_s9_q;
      and_2016_s10_q <= and_2016_s9_q;
      and_2136_s10_q <= and_2133_s9_q & (~({sum_1644, last_s9_q[1:0]} < x_s9_q));
      equal_2279_s10_q <= equal_2279_s9_q;
      equal_2468_s10_q <= equal_2468_s9_q;
      and_2595_s10_q <= or_576_s9_q & and_2594_s9_q;
      equal_2680_s10_q <= shift_s9_q == 6'h0;
      select_2724_s10_q <= select_2724;
      rise_2_s10_q <= rise_2[8];
      select_2730_s10_q <= rise_2[8] ? select_2726_s9_q : select_2728_s9_q;
      xor_2735_s10_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2761_s10_q <= select_2726_s9_q < select_2728_s9_q;
      not_2988_s10_q <= ~(x_s9_q < {1'b0, from});
      or_3043_s10_q <= or_3043_s9_q;
      not_3067_s10_q <= not_3067_s9_q;
      select_3544_s10_q <= less_1963_s9_q ? (not_1965_s9_q & select_3542) : select_3542;
      equal_3546_s10_q <= equal_3546_s9_q;
      less_3872_s10_q <= less_3872_s9_q;
      equal_4091_s10_q <= equal_4091_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/patches.hpp:106
  logic equal_566;
  assign equal_566 = x_s10_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_565_s10_q & equal_566;
  // hls/stages/count_bits.hpp:24
  logic parity_910;
  assign parity_910 = ^{or_907_s10_q, or_903_s10_q, or_899_s10_q};
  logic parity_925;
  assign parity_925 = ^{or_922_s10_q, or_918_s10_q, or_914_s10_q};
  logic parity_928;
  assign parity_928 = ^{or_922_s10_q, or_918_s10_q, or_914_s10_q, or_907_s10_q, or_903_s10_q, or_899_s10_q, or_892_s10_q, or_888_s10_q, and_884_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_930;
  assign and_930 = parity_883_s10_q & parity_928;
  logic or_934;
  assign or_934 = and_931_s10_q | and_933_s10_q;
  logic and_937;
  assign and_937 = (^{or_892_s10_q, or_888_s10_q, and_884_s10_q}) & (parity_910 | parity_925);
  logic or_938;
  assign or_938 = (parity_910 & parity_925) | and_937;
  // hls/stages/count_bits.hpp:24
  logic parity_956;
  assign parity_956 = ^{or_953_s10_q, or_949_s10_q, or_945_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_960;
  assign or_960 = (or_888_s10_q & or_892_s10_q) | (and_884_s10_q & (or_888_s10_q | or_892_s10_q));
  logic or_964;
  assign or_964 = (or_903_s10_q & or_907_s10_q) | (or_899_s10_q & (or_903_s10_q | or_907_s10_q));
  logic or_968;
  assign or_968 = (or_918_s10_q & or_922_s10_q) | (or_914_s10_q & (or_918_s10_q | or_922_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_971;
  assign parity_971 = ^{or_968, or_964, or_960};
  logic parity_974;
  assign parity_974 = ^{or_968, or_964, or_960, or_953_s10_q, or_949_s10_q, or_945_s10_q, or_938, or_934, and_930};
  // hls/stages/count_bits.hpp:25
  logic or_986;
  assign or_986 = (or_949_s10_q & or_953_s10_q) | (or_945_s10_q & (or_949_s10_q | or_953_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1159;
  assign parity_1159 = ^{or_1156_s10_q, or_1152_s10_q, or_1148_s10_q};
  logic parity_1174;
  assign parity_1174 = ^{or_1171_s10_q, or_1167_s10_q, or_1163_s10_q};
  logic parity_1177;
  assign parity_1177 = ^{or_1171_s10_q, or_1167_s10_q, or_1163_s10_q, or_1156_s10_q, or_1152_s10_q, or_1148_s10_q, or_1141_s10_q, or_1137_s10_q, and_1133_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1179;
  assign and_1179 = parity_1132_s10_q & parity_1177;
  logic or_1183;
  assign or_1183 = and_1180_s10_q | (parity_1098_s10_q & or_1181_s10_q);
  logic and_1186;
  assign and_1186 = (^{or_1141_s10_q, or_1137_s10_q, and_1133_s10_q}) & (parity_1159 | parity_1174);
  logic or_1187;
  assign or_1187 = (parity_1159 & parity_1174) | and_1186;
  // hls/stages/count_bits.hpp:24
  logic parity_1205;
  assign parity_1205 = ^{or_1202_s10_q, or_1198_s10_q, or_1194_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1209;
  assign or_1209 = (or_1137_s10_q & or_1141_s10_q) | (and_1133_s10_q & (or_1137_s10_q | or_1141_s10_q));
  logic or_1213;
  assign or_1213 = (or_1152_s10_q & or_1156_s10_q) | (or_1148_s10_q & (or_1152_s10_q | or_1156_s10_q));
  logic or_1217;
  assign or_1217 = (or_1167_s10_q & or_1171_s10_q) | (or_1163_s10_q & (or_1167_s10_q | or_1171_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1220;
  assign parity_1220 = ^{or_1217, or_1213, or_1209};
  logic parity_1223;
  assign parity_1223 = ^{or_1217, or_1213, or_1209, or_1202_s10_q, or_1198_s10_q, or_1194_s10_q, or_1187, or_1183, and_1179};
  // hls/stages/count_bits.hpp:25
  logic or_1235;
  assign or_1235 = (or_1198_s10_q & or_1202_s10_q) | (or_1194_s10_q & (or_1198_s10_q | or_1202_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1408;
  assign parity_1408 = ^{or_1405_s10_q, or_1401_s10_q, or_1397_s10_q};
  logic parity_1423;
  assign parity_1423 = ^{or_1420_s10_q, or_1416_s10_q, or_1412_s10_q};
  logic parity_1426;
  assign parity_1426 = ^{or_1420_s10_q, or_1416_s10_q, or_1412_s10_q, or_1405_s10_q, or_1401_s10_q, or_1397_s10_q, or_1390_s10_q, or_1386_s10_q, and_1382_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1428;
  assign and_1428 = parity_1381_s10_q & parity_1426;
  logic or_1432;
  assign or_1432 = and_1429_s10_q | (parity_1347_s10_q & or_1430_s10_q);
  logic and_1435;
  assign and_1435 = (^{or_1390_s10_q, or_1386_s10_q, and_1382_s10_q}) & (parity_1408 | parity_1423);
  logic or_1436;
  assign or_1436 = (parity_1408 & parity_1423) | and_1435;
  // hls/stages/count_bits.hpp:24
  logic parity_1454;
  assign parity_1454 = ^{or_1451_s10_q, or_1447_s10_q, or_1443_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1458;
  assign or_1458 = (or_1386_s10_q & or_1390_s10_q) | (and_1382_s10_q & (or_1386_s10_q | or_1390_s10_q));
  logic or_1462;
  assign or_1462 = (or_1401_s10_q & or_1405_s10_q) | (or_1397_s10_q & (or_1401_s10_q | or_1405_s10_q));
  logic or_1466;
  assign or_1466 = (or_1416_s10_q & or_1420_s10_q) | (or_1412_s10_q & (or_1416_s10_q | or_1420_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1469;
  assign parity_1469 = ^{or_1466, or_1462, or_1458};
  logic parity_1472;
  assign parity_1472 = ^{or_1466, or_1462, or_1458, or_1451_s10_q, or_1447_s10_q, or_1443_s10_q, or_1436, or_1432, and_1428};
  // hls/stages/count_bits.hpp:25
  logic or_1484;
  assign or_1484 = (or_1447_s10_q & or_1451_s10_q) | (or_1443_s10_q & (or_1447_s10_q | or_1451_s10_q));
  // hls/stages/patches.hpp:104
  logic and_1722;
  assign and_1722 = less_1720_s10_q & (~right_3_s10_q);
  // hls/stages/agreement.hpp:1018
  logic and_1732;
  assign and_1732 = (~(and_1722 | (equal_566 | not_1724_s10_q))) & (less_1729_s10_q & less_1730_s10_q);
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1764;
  assign sum_1764 = sum_1760_s10_q + {sum_1763_s10_q, select_1761_s10_q};
  logic [9:0] sum_1765;
  assign sum_1765 = {difference_1757_s10_q, select_1755_s10_q} + sum_1764[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2724_s10_q} - {1'b0, select_2730_s10_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s10_q} + {1'b0, xor_2735_s10_q};

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1376; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_576_s10_q ? select_623_s10_q : right_s10_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s10_en & select_614_s10_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:780; read in stage 10, written in stage 21: 10 < 21 < 10 + DISTANCE.
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
  assign patches_left_re = s10_en & and_1848_s10_q;
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s10_en) begin
      patches_read_searches_q <= equal_1784_s10_q ? select_3544_s10_q : patches_read_searches_q;
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
  logic [3:0] select_507_s11_q;
  logic equal_508_s11_q;
  logic [6:0] select_510_s11_q;
  logic [8:0] select_514_s11_q;
  logic and_520_s11_q;
  logic equal_526_s11_q;
  logic [6:0] last_s11_q;
  logic and_544_s11_q;
  logic and_546_s11_q;
  logic equal_566_s11_q;
  logic first_s11_q;
  logic equal_571_s11_q;
  logic so_s11_q;
  logic equal_575_s11_q;
  logic or_576_s11_q;
  logic less_579_s11_q;
  logic not_580_s11_q;
  logic equal_590_s11_q;
  logic and_597_s11_q;
  logic and_605_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic [6:0] select_623_s11_q;
  logic [6:0] right_s11_q;
  logic and_636_s11_q;
  logic and_641_s11_q;
  logic and_643_s11_q;
  logic equal_676_s11_q;
  logic xor_834_s11_q;
  logic xor_929_s11_q;
  logic parity_974_s11_q;
  logic and_975_s11_q;
  logic and_977_s11_q;
  logic and_979_s11_q;
  logic and_981_s11_q;
  logic or_986_s11_q;
  logic or_990_s11_q;
  logic xor_1083_s11_q;
  logic xor_1178_s11_q;
  logic parity_1223_s11_q;
  logic and_1224_s11_q;
  logic and_1226_s11_q;
  logic and_1228_s11_q;
  logic and_1230_s11_q;
  logic or_1235_s11_q;
  logic or_1239_s11_q;
  logic xor_1332_s11_q;
  logic xor_1427_s11_q;
  logic parity_1472_s11_q;
  logic and_1473_s11_q;
  logic and_1475_s11_q;
  logic and_1477_s11_q;
  logic and_1479_s11_q;
  logic or_1484_s11_q;
  logic or_1488_s11_q;
  logic and_1558_s11_q;
  logic equal_1559_s11_q;
  logic or_1579_s11_q;
  logic less_1645_s11_q;
  logic and_1672_s11_q;
  logic and_1685_s11_q;
  logic right_3_s11_q;
  logic less_1699_s11_q;
  logic [5:0] b_s11_q;
  logic and_1732_s11_q;
  logic [7:0] sum_1765_s11_q;
  logic equal_1777_s11_q;
  logic or_1778_s11_q;
  logic equal_1784_s11_q;
  logic not_1785_s11_q;
  logic equal_1786_s11_q;
  logic not_1787_s11_q;
  logic equal_1788_s11_q;
  logic equal_1789_s11_q;
  logic or_1790_s11_q;
  logic [7:0] patches_right_0_rdata_s11_q;
  logic [4:0] select_1814_s11_q;
  logic select_1820_s11_q;
  logic [7:0] patches_right_1_rdata_s11_q;
  logic [3:0] select_1859_s11_q;
  logic and_1869_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic less_1963_s11_q;
  logic equal_1964_s11_q;
  logic not_1965_s11_q;
  logic equal_1966_s11_q;
  logic not_1967_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_1995_s11_q;
  logic and_2016_s11_q;
  logic and_2138_s11_q;
  logic equal_2279_s11_q;
  logic equal_2468_s11_q;
  logic and_2595_s11_q;
  logic equal_2680_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] size_3_s11_q;
  logic less_2761_s11_q;
  logic not_2988_s11_q;
  logic or_3043_s11_q;
  logic not_3067_s11_q;
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
      select_507_s11_q <= select_507_s10_q;
      equal_508_s11_q <= equal_508_s10_q;
      select_510_s11_q <= select_510_s10_q;
      select_514_s11_q <= select_514_s10_q;
      and_520_s11_q <= and_520_s10_q;
      equal_526_s11_q <= equal_526_s10_q;
      last_s11_q <= last_s10_q;
      and_544_s11_q <= and_544_s10_q;
      and_546_s11_q <= and_546_s10_q;
      equal_566_s11_q <= equal_566;
      first_s11_q <= first;
      equal_571_s11_q <= equal_571_s10_q;
      so_s11_q <= so_s10_q;
      equal_575_s11_q <= equal_575_s10_q;
      or_576_s11_q <= or_576_s10_q;
      less_579_s11_q <= less_579_s10_q;
      not_580_s11_q <= not_580_s10_q;
      equal_590_s11_q <= equal_590_s10_q;
      and_597_s11_q <= and_597_s10_q;
      and_605_s11_q <= and_605_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_623_s11_q <= select_623_s10_q;
      right_s11_q <= right_s10_q;
      and_636_s11_q <= and_636_s10_q;
      and_641_s11_q <= and_641_s10_q;
      and_643_s11_q <= and_643_s10_q;
      equal_676_s11_q <= equal_676_s10_q;
      xor_834_s11_q <= xor_834_s10_q;
      xor_929_s11_q <= parity_883_s10_q ^ parity_928;
      parity_974_s11_q <= parity_974;
      and_975_s11_q <= parity_956 & parity_971;
      and_977_s11_q <= (^{or_938, or_934, and_930}) & (parity_956 | parity_971);
      and_979_s11_q <= or_934 & or_938;
      and_981_s11_q <= and_930 & (or_934 | or_938);
      or_986_s11_q <= or_986;
      or_990_s11_q <= (or_964 & or_968) | (or_960 & (or_964 | or_968));
      xor_1083_s11_q <= xor_1083_s10_q;
      xor_1178_s11_q <= parity_1132_s10_q ^ parity_1177;
      parity_1223_s11_q <= parity_1223;
      and_1224_s11_q <= parity_1205 & parity_1220;
      and_1226_s11_q <= (^{or_1187, or_1183, and_1179}) & (parity_1205 | parity_1220);
      and_1228_s11_q <= or_1183 & or_1187;
      and_1230_s11_q <= and_1179 & (or_1183 | or_1187);
      or_1235_s11_q <= or_1235;
      or_1239_s11_q <= (or_1213 & or_1217) | (or_1209 & (or_1213 | or_1217));
      xor_1332_s11_q <= xor_1332_s10_q;
      xor_1427_s11_q <= parity_1381_s10_q ^ parity_1426;
      parity_1472_s11_q <= parity_1472;
      and_1473_s11_q <= parity_1454 & parity_1469;
      and_1475_s11_q <= (^{or_1436, or_1432, and_1428}) & (parity_1454 | parity_1469);
      and_1477_s11_q <= or_1432 & or_1436;
      and_1479_s11_q <= and_1428 & (or_1432 | or_1436);
      or_1484_s11_q <= or_1484;
      or_1488_s11_q <= (or_1462 & or_1466) | (or_1458 & (or_1462 | or_1466));
      and_1558_s11_q <= and_1558_s10_q;
      equal_1559_s11_q <= equal_1559_s10_q;
      or_1579_s11_q <= or_1579_s10_q;
      less_1645_s11_q <= less_1645_s10_q;
      and_1672_s11_q <= and_1672_s10_q;
      and_1685_s11_q <= and_1685_s10_q;
      right_3_s11_q <= right_3_s10_q;
      less_1699_s11_q <= less_1699_s10_q;
      b_s11_q <= b_s10_q;
      and_1732_s11_q <= and_1732;
      sum_1765_s11_q <= sum_1765[9:2];
      equal_1777_s11_q <= equal_1777_s10_q;
      or_1778_s11_q <= and_1722 | equal_1777_s10_q;
      equal_1784_s11_q <= equal_1784_s10_q;
      not_1785_s11_q <= not_1785_s10_q;
      equal_1786_s11_q <= equal_1786_s10_q;
      not_1787_s11_q <= not_1787_s10_q;
      equal_1788_s11_q <= equal_1788_s10_q;
      equal_1789_s11_q <= equal_1789_s10_q;
      or_1790_s11_q <= or_1790_s10_q;
      patches_right_0_rdata_s11_q <= patches_right_0_rdata_q;
      select_1814_s11_q <= select_1814_s10_q;
      select_1820_s11_q <= select_1820_s10_q;
      patches_right_1_rdata_s11_q <= patches_right_1_rdata_q;
      select_1859_s11_q <= select_1859_s10_q;
      and_1869_s11_q <= and_1869_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_q;
      less_1963_s11_q <= less_1963_s10_q;
      equal_1964_s11_q <= equal_1964_s10_q;
      not_1965_s11_q <= not_1965_s10_q;
      equal_1966_s11_q <= equal_1966_s10_q;
      not_1967_s11_q <= not_1967_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_1995_s11_q <= sum_1995_s10_q;
      and_2016_s11_q <= and_2016_s10_q;
      and_2138_s11_q <= so_s10_q & (ends_cell_s10_q & and_2136_s10_q);
      equal_2279_s11_q <= equal_2279_s10_q;
      equal_2468_s11_q <= equal_2468_s10_q;
      and_2595_s11_q <= and_2595_s10_q;
      equal_2680_s11_q <= equal_2680_s10_q;
      wide_s11_q <= wide;
      size_3_s11_q <= size_3;
      less_2761_s11_q <= less_2761_s10_q;
      not_2988_s11_q <= not_2988_s10_q;
      or_3043_s11_q <= or_3043_s10_q;
      not_3067_s11_q <= not_3067_s10_q;
      equal_3546_s11_q <= equal_3546_s10_q;
      less_3872_s11_q <= less_3872_s10_q;
      equal_4091_s11_q <= equal_4091_s10_q;
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
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_576_s11_q & not_580_s11_q;
  // hls/stages/count_bits.hpp:25
  logic or_978;
  assign or_978 = and_975_s11_q | and_977_s11_q;
  logic or_982;
  assign or_982 = and_979_s11_q | and_981_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_995;
  assign parity_995 = ^{or_990_s11_q, or_986_s11_q, or_982, or_978};
  // hls/stages/count_bits.hpp:25
  logic or_999;
  assign or_999 = (or_986_s11_q & or_990_s11_q) | (or_982 & (or_986_s11_q | or_990_s11_q));
  logic and_1000;
  assign and_1000 = or_978 & (^{or_990_s11_q, or_986_s11_q, or_982});
  // hls/stages/count_bits.hpp:24
  logic xor_1001;
  assign xor_1001 = or_999 ^ and_1000;
  // hls/stages/count_bits.hpp:27
  logic and_1002;
  assign and_1002 = or_999 & and_1000;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1003;
  assign select_1003 = equal_590_s11_q ? {and_1002, xor_1001, parity_995, parity_974_s11_q, xor_929_s11_q, xor_834_s11_q} : 6'h0;
  logic [5:0] column;
  assign column = or_576_s11_q ? 6'h0 : select_1003;
  // hls/stages/count_bits.hpp:25
  logic or_1227;
  assign or_1227 = and_1224_s11_q | and_1226_s11_q;
  logic or_1231;
  assign or_1231 = and_1228_s11_q | and_1230_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1244;
  assign parity_1244 = ^{or_1239_s11_q, or_1235_s11_q, or_1231, or_1227};
  // hls/stages/count_bits.hpp:25
  logic or_1248;
  assign or_1248 = (or_1235_s11_q & or_1239_s11_q) | (or_1231 & (or_1235_s11_q | or_1239_s11_q));
  logic and_1249;
  assign and_1249 = or_1227 & (^{or_1239_s11_q, or_1235_s11_q, or_1231});
  // hls/stages/count_bits.hpp:24
  logic xor_1250;
  assign xor_1250 = or_1248 ^ and_1249;
  // hls/stages/count_bits.hpp:27
  logic and_1251;
  assign and_1251 = or_1248 & and_1249;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1252;
  assign select_1252 = equal_590_s11_q ? {and_1251, xor_1250, parity_1244, parity_1223_s11_q, xor_1178_s11_q, xor_1083_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_576_s11_q ? 6'h0 : select_1252;
  // hls/stages/count_bits.hpp:25
  logic or_1476;
  assign or_1476 = and_1473_s11_q | and_1475_s11_q;
  logic or_1480;
  assign or_1480 = and_1477_s11_q | and_1479_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1493;
  assign parity_1493 = ^{or_1488_s11_q, or_1484_s11_q, or_1480, or_1476};
  // hls/stages/count_bits.hpp:25
  logic or_1497;
  assign or_1497 = (or_1484_s11_q & or_1488_s11_q) | (or_1480 & (or_1484_s11_q | or_1488_s11_q));
  logic and_1498;
  assign and_1498 = or_1476 & (^{or_1488_s11_q, or_1484_s11_q, or_1480});
  // hls/stages/count_bits.hpp:24
  logic xor_1499;
  assign xor_1499 = or_1497 ^ and_1498;
  // hls/stages/count_bits.hpp:27
  logic and_1500;
  assign and_1500 = or_1497 & and_1498;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1501;
  assign select_1501 = equal_590_s11_q ? {and_1500, xor_1499, parity_1493, parity_1472_s11_q, xor_1427_s11_q, xor_1332_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_576_s11_q ? 6'h0 : select_1501;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1537;
  assign sum_1537 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1540;
  assign sum_1540 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v & less_1645_s11_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1766;
  assign sum_1766 = {registration_slope_s11_q[11], registration_slope_s11_q} + {{5{sum_1765_s11_q[7]}}, sum_1765_s11_q};
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1789_s11_q ? (patches_second_s11_q ? 8'h0 : patches_right_0_rdata_s11_q) : 8'h0;
  // hls/stages/patches.hpp:467
  logic [8:0] sum_1916;
  assign sum_1916 = {1'b0, patches_columns_above_rdata_s11_q[23:16]} + {3'h0, patches_columns_above_rdata_s11_q[31:26]};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2738;
  assign select_2738 = ({wide_s11_q, 1'b0} < size_3_s11_q) ? {wide_s11_q, 1'b0} : size_3_s11_q;
  logic [8:0] taken;
  assign taken = ~select_2738;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3509;
  assign select_3509 = less_1963_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3511;
  assign select_3511 = less_1963_s11_q ? (equal_1966_s11_q ? 10'h0 : select_3509) : 10'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3516;
  assign select_3516 = less_1963_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3519;
  assign select_3519 = equal_1966_s11_q ? (less_1963_s11_q ? (equal_1966_s11_q ? 5'h0 : select_3516) : 5'h0) : select_3516;

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
  logic [3:0] select_507_s12_q;
  logic equal_508_s12_q;
  logic [6:0] select_510_s12_q;
  logic [8:0] select_514_s12_q;
  logic and_520_s12_q;
  logic equal_526_s12_q;
  logic [6:0] last_s12_q;
  logic and_544_s12_q;
  logic and_546_s12_q;
  logic equal_566_s12_q;
  logic first_s12_q;
  logic equal_571_s12_q;
  logic so_s12_q;
  logic equal_575_s12_q;
  logic or_576_s12_q;
  logic less_579_s12_q;
  logic not_580_s12_q;
  logic inside_v_s12_q;
  logic and_597_s12_q;
  logic and_605_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic [6:0] select_623_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic and_636_s12_q;
  logic and_641_s12_q;
  logic and_643_s12_q;
  logic equal_676_s12_q;
  logic [5:0] column_s12_q;
  logic [5:0] select_1254_s12_q;
  logic [5:0] select_1503_s12_q;
  logic [6:0] sum_1538_s12_q;
  logic [6:0] sum_1541_s12_q;
  logic and_1558_s12_q;
  logic equal_1559_s12_q;
  logic or_1579_s12_q;
  logic right_2_s12_q;
  logic and_1672_s12_q;
  logic and_1685_s12_q;
  logic and_1697_s12_q;
  logic less_1699_s12_q;
  logic [5:0] b_s12_q;
  logic and_1732_s12_q;
  logic [7:0] sum_1766_s12_q;
  logic less_1767_s12_q;
  logic less_1768_s12_q;
  logic equal_1777_s12_q;
  logic and_1781_s12_q;
  logic equal_1784_s12_q;
  logic not_1785_s12_q;
  logic equal_1786_s12_q;
  logic not_1787_s12_q;
  logic equal_1788_s12_q;
  logic equal_1789_s12_q;
  logic or_1790_s12_q;
  logic [4:0] select_1814_s12_q;
  logic select_1820_s12_q;
  logic [7:0] patches_left_rdata_s12_q;
  logic [3:0] select_1859_s12_q;
  logic and_1869_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] select_1873_s12_q;
  logic [8:0] sum_1916_s12_q;
  logic less_1963_s12_q;
  logic equal_1964_s12_q;
  logic not_1965_s12_q;
  logic equal_1966_s12_q;
  logic not_1967_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1995_s12_q;
  logic and_2016_s12_q;
  logic and_2138_s12_q;
  logic equal_2279_s12_q;
  logic equal_2468_s12_q;
  logic and_2595_s12_q;
  logic equal_2680_s12_q;
  logic less_2722_s12_q;
  logic [7:0] wide_s12_q;
  logic [8:0] taken_s12_q;
  logic [7:0] not_2740_s12_q;
  logic less_2761_s12_q;
  logic and_2991_s12_q;
  logic or_3043_s12_q;
  logic not_3067_s12_q;
  logic [9:0] select_3512_s12_q;
  logic [4:0] select_3519_s12_q;
  logic equal_3546_s12_q;
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
      select_507_s12_q <= select_507_s11_q;
      equal_508_s12_q <= equal_508_s11_q;
      select_510_s12_q <= select_510_s11_q;
      select_514_s12_q <= select_514_s11_q;
      and_520_s12_q <= and_520_s11_q;
      equal_526_s12_q <= equal_526_s11_q;
      last_s12_q <= last_s11_q;
      and_544_s12_q <= and_544_s11_q;
      and_546_s12_q <= and_546_s11_q;
      equal_566_s12_q <= equal_566_s11_q;
      first_s12_q <= first_s11_q;
      equal_571_s12_q <= equal_571_s11_q;
      so_s12_q <= so_s11_q;
      equal_575_s12_q <= equal_575_s11_q;
      or_576_s12_q <= or_576_s11_q;
      less_579_s12_q <= less_579_s11_q;
      not_580_s12_q <= not_580_s11_q;
      inside_v_s12_q <= inside_v;
      and_597_s12_q <= and_597_s11_q;
      and_605_s12_q <= and_605_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_623_s12_q <= select_623_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      and_636_s12_q <= and_636_s11_q;
      and_641_s12_q <= and_641_s11_q;
      and_643_s12_q <= and_643_s11_q;
      equal_676_s12_q <= equal_676_s11_q;
      column_s12_q <= column;
      select_1254_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1503_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1538_s12_q <= {1'b0, before_v_2} + sum_1537;
      sum_1541_s12_q <= {1'b0, before_v_3} + sum_1540;
      and_1558_s12_q <= and_1558_s11_q;
      equal_1559_s12_q <= equal_1559_s11_q;
      or_1579_s12_q <= or_1579_s11_q;
      right_2_s12_q <= right_2;
      and_1672_s12_q <= and_1672_s11_q;
      and_1685_s12_q <= and_1685_s11_q;
      and_1697_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & right_3_s11_q));
      less_1699_s12_q <= less_1699_s11_q;
      b_s12_q <= b_s11_q;
      and_1732_s12_q <= and_1732_s11_q;
      sum_1766_s12_q <= sum_1766[7:0];
      less_1767_s12_q <= $signed(6'h0) < $signed(sum_1766[12:7]);
      less_1768_s12_q <= $signed(sum_1766[12:7]) < $signed(6'h3f);
      equal_1777_s12_q <= equal_1777_s11_q;
      and_1781_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & or_1778_s11_q));
      equal_1784_s12_q <= equal_1784_s11_q;
      not_1785_s12_q <= not_1785_s11_q;
      equal_1786_s12_q <= equal_1786_s11_q;
      not_1787_s12_q <= not_1787_s11_q;
      equal_1788_s12_q <= equal_1788_s11_q;
      equal_1789_s12_q <= equal_1789_s11_q;
      or_1790_s12_q <= or_1790_s11_q;
      select_1814_s12_q <= select_1814_s11_q;
      select_1820_s12_q <= select_1820_s11_q;
      patches_left_rdata_s12_q <= patches_left_rdata_q;
      select_1859_s12_q <= select_1859_s11_q;
      and_1869_s12_q <= and_1869_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      select_1873_s12_q <= patches_second_s11_q ? patches_right_1_rdata_s11_q : pixel;
      sum_1916_s12_q <= sum_1916;
      less_1963_s12_q <= less_1963_s11_q;
      equal_1964_s12_q <= equal_1964_s11_q;
      not_1965_s12_q <= not_1965_s11_q;
      equal_1966_s12_q <= equal_1966_s11_q;
      not_1967_s12_q <= not_1967_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_1995_s12_q <= sum_1995_s11_q;
      and_2016_s12_q <= and_2016_s11_q;
      and_2138_s12_q <= and_2138_s11_q;
      equal_2279_s12_q <= equal_2279_s11_q;
      equal_2468_s12_q <= equal_2468_s11_q;
      and_2595_s12_q <= and_2595_s11_q;
      equal_2680_s12_q <= equal_2680_s11_q;
      less_2722_s12_q <= slot_s11_q < 3'h3;
      wide_s12_q <= wide_s11_q;
      taken_s12_q <= taken;
      not_2740_s12_q <= ~wide_s11_q;
      less_2761_s12_q <= less_2761_s11_q;
      and_2991_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & not_2988_s11_q));
      or_3043_s12_q <= or_3043_s11_q;
      not_3067_s12_q <= not_3067_s11_q;
      select_3512_s12_q <= equal_1966_s11_q ? select_3511 : select_3509;
      select_3519_s12_q <= select_3519;
      equal_3546_s12_q <= equal_3546_s11_q;
      less_3872_s12_q <= less_3872_s11_q;
      equal_4091_s12_q <= equal_4091_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/moments.hpp:57
  logic [13:0] select_569;
  assign select_569 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:1009
  logic not_572;
  assign not_572 = ~equal_571_s12_q;
  // hls/stages/agreement.hpp:201
  logic not_574;
  assign not_574 = ~so_s12_q;
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:807
  logic or_756;
  assign or_756 = shift_first_s12_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1005;
  assign select_1005 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1533;
  assign sum_1533 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1543;
  assign select_1543 = (sum_1538_s12_q < sum_1541_s12_q) ? sum_1541_s12_q : sum_1538_s12_q;
  // hls/stages/agreement.hpp:788
  logic and_1569;
  assign and_1569 = ends_cell_s12_q & inside_v_s12_q;
  logic and_1571;
  assign and_1571 = not_572 & (so_s12_q & and_1569);
  // hls/stages/registration.hpp:83
  logic equal_1700;
  assign equal_1700 = slot_s12_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1703;
  assign select_1703 = b_s12_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1704;
  assign select_1704 = b_s12_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1705;
  assign sum_1705 = {{2{select_1703[6]}}, select_1703} + {select_1704[7], select_1704};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1706;
  assign select_1706 = b_s12_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1707;
  assign select_1707 = b_s12_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1708;
  assign sum_1708 = {{2{select_1706[7]}}, select_1706[7:1]} + {select_1707[7], select_1707};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1710;
  assign select_1710 = b_s12_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1711;
  assign select_1711 = b_s12_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1712;
  assign difference_1712 = {{2{select_1710[7]}}, select_1710[7:1]} - {select_1711[7], select_1711};
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1748;
  assign select_1748 = so_s12_q ? (ends_cell_s12_q ? (inside_v_s12_q ? b_s12_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1770;
  assign select_1770 = less_1767_s12_q ? 8'h7f : (less_1768_s12_q ? 8'h80 : sum_1766_s12_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1700 ? registration_slope_here_q : select_1770;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1774;
  assign select_1774 = so_s12_q ? (ends_cell_s12_q ? (inside_v_s12_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1782;
  assign and_1782 = not_572 & and_1781_s12_q;
  // hls/stages/patches.hpp:172
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1789_s12_q ? select_1873_s12_q : patches_left_rdata_s12_q;
  // hls/stages/patches.hpp:467
  logic [9:0] sum_1917;
  assign sum_1917 = {2'h0, patches_columns_above_rdata_s12_q[15:8]} + {1'b0, sum_1916_s12_q};
  // hls/stages/agreement.hpp:788
  logic and_2331;
  assign and_2331 = not_572 & (not_574 & (equal_575_s12_q & (inside_v_s12_q & first_s12_q)));
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2568;
  assign select_2568 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2569;
  assign select_2569 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2570;
  assign select_2570 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2571;
  assign select_2571 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2572;
  assign select_2572 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2573;
  assign select_2573 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s12_q[61:54]} - {1'b0, best_left_rdata_s12_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2733;
  assign not_2733 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2722_s12_q ? {1'b0, wide_s12_q, 1'b0} : {registration_displacement_over_q[8:0], not_2733};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2741;
  assign select_2741 = registration_displacement_over_q[9] ? wide_s12_q : not_2740_s12_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2722_s12_q ? {taken_s12_q, 1'b1} : {not_2733, select_2741, not_2733};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2743;
  assign sum_2743 = {left, 1'b1} + {taken_2, less_2722_s12_q};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2745;
  assign select_2745 = so_s12_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2747;
  assign select_2747 = equal_571_s12_q ? registration_slope_here_q : (so_s12_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2756;
  assign select_2756 = or_576_s12_q ? (less_579_s12_q ? 3'h0 : best_left_rdata_s12_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3514;
  assign select_3514 = less_1963_s12_q ? (equal_1964_s12_q ? 10'h0 : select_3512_s12_q) : select_3512_s12_q;
  logic [4:0] select_3521;
  assign select_3521 = less_1963_s12_q ? (equal_1964_s12_q ? 5'h0 : select_3519_s12_q) : select_3519_s12_q;
  // hls/stages/patches.hpp:556
  logic and_3531;
  assign and_3531 = less_1963_s12_q & (patches_step_s12_q == 5'h0);
  // hls/stages/patches.hpp:560
  logic select_3534;
  assign select_3534 = equal_1966_s12_q ? (less_1963_s12_q ? (not_1967_s12_q & and_3531) : and_3531) : and_3531;

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1405; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s12_q[6:0];
`ifndef SYNTHESIS
  logic seen_columns_re;
  assign seen_columns_re = s12_en & and_1571;
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
    end else if (s12_en) begin
      moments_place_q <= select_569;
      moments_taken_q <= not_572 & (not_574 & (equal_575_s12_q & inside_v_s12_q));
      moments_starts_q <= and_2331;
      shift_not_right_q <= $signed(run_shift_s12_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s12_q ? sum_2743[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2745;
      registration_slope_here_q <= select_2747;
      patches_read_row_differing_q <= equal_1784_s12_q ? select_3514 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1784_s12_q ? select_3521 : patches_read_row_column_q;
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
      middle_sum_columns_values_0_q <= slot_s12_q[0] ? middle_sum_columns_values_0_q : column_s12_q;
      middle_sum_columns_values_1_q <= select_2568;
      middle_sum_columns_values_2_q <= select_2569;
      middle_sum_columns_values_3_q <= select_2570;
      middle_sum_columns_values_4_q <= select_2571;
      middle_sum_columns_values_5_q <= select_2572;
      middle_sum_columns_values_6_q <= select_2573;
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
  logic [3:0] select_507_s13_q;
  logic equal_508_s13_q;
  logic [6:0] select_510_s13_q;
  logic [8:0] select_514_s13_q;
  logic and_520_s13_q;
  logic equal_526_s13_q;
  logic [6:0] last_s13_q;
  logic and_544_s13_q;
  logic and_546_s13_q;
  logic equal_566_s13_q;
  logic first_s13_q;
  logic equal_571_s13_q;
  logic not_572_s13_q;
  logic so_s13_q;
  logic not_574_s13_q;
  logic equal_575_s13_q;
  logic or_576_s13_q;
  logic less_579_s13_q;
  logic not_580_s13_q;
  logic inside_v_s13_q;
  logic and_597_s13_q;
  logic and_605_s13_q;
  logic [6:0] x_s13_2_q;
  logic [61:0] best_left_rdata_s13_q;
  logic less_616_s13_q;
  logic [6:0] select_623_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic [6:0] chosen_s13_q;
  logic and_636_s13_q;
  logic and_641_s13_q;
  logic and_643_s13_q;
  logic equal_676_s13_q;
  logic select_758_s13_q;
  logic [6:0] difference_1006_s13_q;
  logic [6:0] difference_1255_s13_q;
  logic equal_1256_s13_q;
  logic [6:0] difference_1504_s13_q;
  logic [6:0] sum_1534_s13_q;
  logic [6:0] select_1543_s13_q;
  logic and_1558_s13_q;
  logic select_1560_s13_q;
  logic and_1569_s13_q;
  logic and_1571_s13_q;
  logic or_1579_s13_q;
  logic right_2_s13_q;
  logic and_1672_s13_q;
  logic and_1685_s13_q;
  logic and_1698_s13_q;
  logic less_1699_s13_q;
  logic equal_1700_s13_q;
  logic [7:0] sum_1705_s13_q;
  logic select_1706_s13_q;
  logic [8:0] sum_1708_s13_q;
  logic select_1710_s13_q;
  logic [8:0] difference_1712_s13_q;
  logic and_1732_s13_q;
  logic [5:0] select_1749_s13_q;
  logic [7:0] select_1775_s13_q;
  logic equal_1777_s13_q;
  logic and_1782_s13_q;
  logic and_1783_s13_q;
  logic equal_1784_s13_q;
  logic not_1785_s13_q;
  logic equal_1786_s13_q;
  logic not_1787_s13_q;
  logic equal_1788_s13_q;
  logic equal_1789_s13_q;
  logic or_1790_s13_q;
  logic [4:0] select_1814_s13_q;
  logic select_1820_s13_q;
  logic [3:0] select_1859_s13_q;
  logic and_1869_s13_q;
  logic [31:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [9:0] sum_1917_s13_q;
  logic less_1963_s13_q;
  logic equal_1964_s13_q;
  logic not_1965_s13_q;
  logic equal_1966_s13_q;
  logic not_1967_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1995_s13_q;
  logic and_2016_s13_q;
  logic and_2139_s13_q;
  logic equal_2279_s13_q;
  logic equal_2468_s13_q;
  logic and_2595_s13_q;
  logic equal_2680_s13_q;
  logic rise_s13_q;
  logic [7:0] xor_2685_s13_q;
  logic select_2756_s13_q;
  logic or_2759_s13_q;
  logic [1:0] sum_2760_s13_q;
  logic less_2761_s13_q;
  logic and_2992_s13_q;
  logic or_3043_s13_q;
  logic not_3067_s13_q;
  logic select_3534_s13_q;
  logic equal_3546_s13_q;
  logic less_3872_s13_q;
  logic equal_4091_s13_q;
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
      moments_starts_s13_q <= moments_starts_q;
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
      select_507_s13_q <= select_507_s12_q;
      equal_508_s13_q <= equal_508_s12_q;
      select_510_s13_q <= select_510_s12_q;
      select_514_s13_q <= select_514_s12_q;
      and_520_s13_q <= and_520_s12_q;
      equal_526_s13_q <= equal_526_s12_q;
      last_s13_q <= last_s12_q;
      and_544_s13_q <= and_544_s12_q;
      and_546_s13_q <= and_546_s12_q;
      equal_566_s13_q <= equal_566_s12_q;
      first_s13_q <= first_s12_q;
      equal_571_s13_q <= equal_571_s12_q;
      not_572_s13_q <= not_572;
      so_s13_q <= so_s12_q;
      not_574_s13_q <= not_574;
      equal_575_s13_q <= equal_575_s12_q;
      or_576_s13_q <= or_576_s12_q;
      less_579_s13_q <= less_579_s12_q;
      not_580_s13_q <= not_580_s12_q;
      inside_v_s13_q <= inside_v_s12_q;
      and_597_s13_q <= and_597_s12_q;
      and_605_s13_q <= and_605_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      less_616_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      select_623_s13_q <= select_623_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      chosen_s13_q <= chosen;
      and_636_s13_q <= and_636_s12_q;
      and_641_s13_q <= and_641_s12_q;
      and_643_s13_q <= and_643_s12_q;
      equal_676_s13_q <= equal_676_s12_q;
      select_758_s13_q <= or_756 ? shift_first_s12_q : (~age_s12_q[1]);
      difference_1006_s13_q <= {1'b0, column_s12_q} - {1'b0, select_1005};
      difference_1255_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1254_s12_q};
      equal_1256_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1504_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1503_s12_q};
      sum_1534_s13_q <= {1'b0, before_v} + sum_1533;
      select_1543_s13_q <= select_1543;
      and_1558_s13_q <= and_1558_s12_q;
      select_1560_s13_q <= or_756 ? shift_first_s12_q : equal_1559_s12_q;
      and_1569_s13_q <= and_1569;
      and_1571_s13_q <= and_1571;
      or_1579_s13_q <= or_1579_s12_q;
      right_2_s13_q <= right_2_s12_q;
      and_1672_s13_q <= and_1672_s12_q;
      and_1685_s13_q <= and_1685_s12_q;
      and_1698_s13_q <= not_572 & and_1697_s12_q;
      less_1699_s13_q <= less_1699_s12_q;
      equal_1700_s13_q <= equal_1700;
      sum_1705_s13_q <= sum_1705[8:1];
      select_1706_s13_q <= select_1706[0];
      sum_1708_s13_q <= sum_1708;
      select_1710_s13_q <= select_1710[0];
      difference_1712_s13_q <= difference_1712;
      and_1732_s13_q <= and_1732_s12_q;
      select_1749_s13_q <= equal_571_s12_q ? 6'h0 : select_1748;
      select_1775_s13_q <= equal_571_s12_q ? 8'h0 : select_1774;
      equal_1777_s13_q <= equal_1777_s12_q;
      and_1782_s13_q <= and_1782;
      and_1783_s13_q <= patches_chooses_s12_q & and_1782;
      equal_1784_s13_q <= equal_1784_s12_q;
      not_1785_s13_q <= not_1785_s12_q;
      equal_1786_s13_q <= equal_1786_s12_q;
      not_1787_s13_q <= not_1787_s12_q;
      equal_1788_s13_q <= equal_1788_s12_q;
      equal_1789_s13_q <= equal_1789_s12_q;
      or_1790_s13_q <= or_1790_s12_q;
      select_1814_s13_q <= select_1814_s12_q;
      select_1820_s13_q <= select_1820_s12_q;
      select_1859_s13_q <= select_1859_s12_q;
      and_1869_s13_q <= and_1869_s12_q;
      patches_columns_above_rdata_s13_q <= patches_columns_above_rdata_s12_q;
      pixel_2_s13_q <= pixel_2;
      sum_1917_s13_q <= sum_1917;
      less_1963_s13_q <= less_1963_s12_q;
      equal_1964_s13_q <= equal_1964_s12_q;
      not_1965_s13_q <= not_1965_s12_q;
      equal_1966_s13_q <= equal_1966_s12_q;
      not_1967_s13_q <= not_1967_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1995_s13_q <= sum_1995_s12_q;
      and_2016_s13_q <= and_2016_s12_q;
      and_2139_s13_q <= not_572 & and_2138_s12_q;
      equal_2279_s13_q <= equal_2279_s12_q;
      equal_2468_s13_q <= equal_2468_s12_q;
      and_2595_s13_q <= and_2595_s12_q;
      equal_2680_s13_q <= equal_2680_s12_q;
      rise_s13_q <= rise[8];
      xor_2685_s13_q <= rise[7:0] ^ {8{rise[8]}};
      select_2756_s13_q <= select_2756[0];
      or_2759_s13_q <= (select_2756 == 3'h0) | (select_2756 == 3'h4);
      sum_2760_s13_q <= select_2756[2:1] + 2'h3;
      less_2761_s13_q <= less_2761_s12_q;
      and_2992_s13_q <= not_572 & and_2991_s12_q;
      or_3043_s13_q <= or_3043_s12_q;
      not_3067_s13_q <= not_3067_s12_q;
      select_3534_s13_q <= select_3534;
      equal_3546_s13_q <= equal_3546_s12_q;
      less_3872_s13_q <= less_3872_s12_q;
      equal_4091_s13_q <= equal_4091_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:120
  logic and_521;
  assign and_521 = sample_pair_whole_s13_q & and_520_s13_q;
  // hls/stages/moments.hpp:63
  logic [10:0] place;
  assign place = first_s13_q ? 11'h0 : moments_place_q[13:3];
  // hls/stages/moments.hpp:104
  logic not_584;
  assign not_584 = ~(11'h3ec < place);
  // hls/stages/agreement.hpp:978
  logic select_618;
  assign select_618 = slot_s13_q[2] ? less_616_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_628;
  assign difference_628 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1008;
  assign sum_1008 = {difference_1006_s13_q[6], difference_1006_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1258;
  assign sum_1258 = {difference_1255_s13_q[6], difference_1255_s13_q} + (equal_1256_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1506;
  assign sum_1506 = {difference_1504_s13_q[6], difference_1504_s13_q} + (equal_1256_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1535;
  assign select_1535 = slot_s13_q[0] ? chosen_near_q : sum_1534_s13_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1545;
  assign select_1545 = (select_1535 < select_1543_s13_q) ? select_1543_s13_q : select_1535;
  // hls/stages/agreement.hpp:788
  logic [6:0] select_1575;
  assign select_1575 = so_s13_q ? x_s13_q[6:0] : (or_576_s13_q ? (less_579_s13_q ? 7'h0 : select_623_s13_q) : 7'h0);
  // hls/stages/agreement.hpp:149
  logic and_1588;
  assign and_1588 = or_576_s13_q & (slot_s13_q[2] & not_580_s13_q);
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1709;
  assign sum_1709 = {{3{sum_1705_s13_q[7]}}, sum_1705_s13_q} + {sum_1708_s13_q[8], sum_1708_s13_q, select_1706_s13_q};
  logic [9:0] sum_1713;
  assign sum_1713 = {difference_1712_s13_q, select_1710_s13_q} + {sum_1709[10], sum_1709[10:2]};
  // hls/stages/patches.hpp:469
  logic [8:0] sum_1897;
  assign sum_1897 = {1'b0, patches_columns_above_rdata_s13_q[7:0]} + {2'h0, pixel_2_s13_q[7:1]};
  logic [8:0] sum_1898;
  assign sum_1898 = {1'b0, patches_columns_above_rdata_s13_q[23:16]} + {2'h0, patches_columns_above_rdata_s13_q[31:25]};
  // hls/stages/patches.hpp:467
  logic [10:0] sum_1918;
  assign sum_1918 = {3'h0, patches_columns_above_rdata_s13_q[15:8]} + {sum_1917_s13_q, patches_columns_above_rdata_s13_q[25]};
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2580;
  assign select_2580 = slot_s13_q[0] ? 7'h0 : sum_1534_s13_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2582;
  assign select_2582 = (select_2580 < select_1543_s13_q) ? select_1543_s13_q : select_2580;
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise_s13_q ? best_left_rdata_s13_q[61:54] : best_left_rdata_s13_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2762;
  assign difference_2762 = {sum_2760_s13_q, select_2756_s13_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2763;
  assign select_2763 = less_2761_s13_q ? difference_2762 : {sum_2760_s13_q, select_2756_s13_q, registration_displacement_fraction_q};
  logic [7:0] select_2764;
  assign select_2764 = or_2759_s13_q ? {sum_2760_s13_q, select_2756_s13_q, 5'h0} : select_2763;
  // hls/stages/patches.hpp:187
  logic select_3082;
  assign select_3082 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:175
  logic and_3143;
  assign and_3143 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3148;
  assign select_3148 = or_3043_s13_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3150;
  assign select_3150 = and_3143 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:556
  logic [4:0] select_3523;
  assign select_3523 = less_1963_s13_q ? patches_step_s13_q : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3526;
  assign select_3526 = equal_1966_s13_q ? (less_1963_s13_q ? (equal_1966_s13_q ? 5'h0 : select_3523) : 5'h0) : select_3523;
  logic [4:0] select_3528;
  assign select_3528 = less_1963_s13_q ? (equal_1964_s13_q ? 5'h0 : select_3526) : select_3526;
  logic select_3536;
  assign select_3536 = less_1963_s13_q ? (not_1965_s13_q & select_3534_s13_q) : select_3534_s13_q;
  // hls/stages/patches.hpp:178
  logic or_3548;
  assign or_3548 = patches_read_first_q | (patches_read_row_differing_s13_q < patches_peak_best_differing_q);
  logic and_3549;
  assign and_3549 = patches_read_searches_s13_q & or_3548;
  // hls/stages/patches.hpp:539
  logic [14:0] select_3581;
  assign select_3581 = and_3549 ? {patches_read_row_column_s13_q, patches_read_row_differing_s13_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3582;
  assign select_3582 = equal_1784_s13_q ? select_3581[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3583;
  assign select_3583 = equal_1784_s13_q ? select_3581[14:10] : patches_peak_best_column_q;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:227; read in stage 13, written in stage 16: 13 < 16 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_514_s13_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s13_en & and_521;
`endif
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1377; read in stage 13, written in stage 16: 13 < 16 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s13_q[6:0];
`ifndef SYNTHESIS
  logic shown_right_re;
  assign shown_right_re = s13_en & and_1571_s13_q;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1378; read in stage 13, written in stage 17: 13 < 17 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] left_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_turns_mem[i] = 2'h0;
`endif
  logic [6:0] left_turns_raddr;
  assign left_turns_raddr = x_s13_q[6:0];
`ifndef SYNTHESIS
  logic left_turns_re;
  assign left_turns_re = s13_en & and_1588;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1378; read in stage 13, written in stage 17: 13 < 17 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] right_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_623_s13_q;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s13_en & and_1588;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s13_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s13_en & and_1869_s13_q;
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
      chosen_near_q <= select_2582;
      patches_along_ends_q <= not_3067_s13_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3067_s13_q & select_3082;
      patches_down_by_q <= or_3043_s13_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3143});
      patches_along_q <= select_3148;
      patches_match_row_q <= or_3043_s13_q ? 4'h0 : select_3150;
      patches_summed_last_q <= not_1785_s13_q & (equal_1786_s13_q & and_3143);
      patches_read_first_q <= equal_1784_s13_q ? select_3536 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3582;
      patches_peak_best_column_q <= select_3583;
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
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_1008;
      sums_0_sum_sums_values_0_q <= sum_1258;
      sums_0_sum_sums_values_1_q <= equal_1256_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1506;
      sums_1_sum_sums_values_1_q <= equal_1256_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic moments_starts_s14_q;
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
  logic [3:0] select_507_s14_q;
  logic equal_508_s14_q;
  logic [6:0] select_510_s14_q;
  logic [8:0] select_514_s14_q;
  logic and_520_s14_q;
  logic and_521_s14_q;
  logic equal_526_s14_q;
  logic [6:0] last_s14_q;
  logic and_544_s14_q;
  logic and_546_s14_q;
  logic equal_566_s14_q;
  logic [12:0] select_570_s14_q;
  logic equal_571_s14_q;
  logic not_572_s14_q;
  logic so_s14_q;
  logic not_574_s14_q;
  logic equal_575_s14_q;
  logic or_576_s14_q;
  logic less_579_s14_q;
  logic not_580_s14_q;
  logic inside_v_s14_q;
  logic not_584_s14_q;
  logic and_587_s14_q;
  logic and_597_s14_q;
  logic and_605_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_618_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic [9:0] sum_629_s14_q;
  logic and_636_s14_q;
  logic and_641_s14_q;
  logic and_643_s14_q;
  logic equal_676_s14_q;
  logic select_758_s14_q;
  logic [7:0] sum_1008_s14_q;
  logic less_1507_s14_q;
  logic [6:0] select_1545_s14_q;
  logic [7:0] select_1553_s14_q;
  logic [7:0] select_1556_s14_q;
  logic and_1558_s14_q;
  logic select_1560_s14_q;
  logic and_1569_s14_q;
  logic and_1571_s14_q;
  logic [6:0] select_1575_s14_q;
  logic or_1579_s14_q;
  logic and_1597_s14_q;
  logic right_2_s14_q;
  logic and_1672_s14_q;
  logic and_1685_s14_q;
  logic and_1698_s14_q;
  logic less_1699_s14_q;
  logic equal_1700_s14_q;
  logic sum_1709_s14_q;
  logic [9:0] sum_1713_s14_q;
  logic and_1732_s14_q;
  logic [5:0] select_1749_s14_q;
  logic [7:0] select_1775_s14_q;
  logic equal_1777_s14_q;
  logic and_1782_s14_q;
  logic and_1783_s14_q;
  logic equal_1784_s14_q;
  logic not_1785_s14_q;
  logic equal_1786_s14_q;
  logic not_1787_s14_q;
  logic equal_1788_s14_q;
  logic equal_1789_s14_q;
  logic or_1790_s14_q;
  logic [4:0] select_1814_s14_q;
  logic select_1820_s14_q;
  logic [3:0] select_1859_s14_q;
  logic [8:0] patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic [4:0] sum_1883_s14_q;
  logic [8:0] sum_1897_s14_q;
  logic [8:0] sum_1898_s14_q;
  logic [10:0] sum_1918_s14_q;
  logic less_1963_s14_q;
  logic equal_1964_s14_q;
  logic not_1965_s14_q;
  logic equal_1966_s14_q;
  logic not_1967_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic sum_1995_s14_q;
  logic and_2016_s14_q;
  logic [17:0] seen_columns_rdata_s14_q;
  logic and_2139_s14_q;
  logic equal_2279_s14_q;
  logic equal_2468_s14_q;
  logic and_2595_s14_q;
  logic equal_2680_s14_q;
  logic [7:0] lower_s14_q;
  logic [7:0] sum_2686_s14_q;
  logic [7:0] select_2764_s14_q;
  logic and_2992_s14_q;
  logic [4:0] select_3528_s14_q;
  logic equal_3546_s14_q;
  logic and_3549_s14_q;
  logic [14:0] select_3581_s14_q;
  logic less_3872_s14_q;
  logic equal_4091_s14_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s14_q <= pixel_0_s13_q;
      pixel_1_s14_q <= pixel_1_s13_q;
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_whole_s14_q <= sample_pair_whole_s13_q;
      sample_present_s14_q <= sample_present_s13_q;
      moments_starts_s14_q <= moments_starts_s13_q;
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
      select_507_s14_q <= select_507_s13_q;
      equal_508_s14_q <= equal_508_s13_q;
      select_510_s14_q <= select_510_s13_q;
      select_514_s14_q <= select_514_s13_q;
      and_520_s14_q <= and_520_s13_q;
      and_521_s14_q <= and_521;
      equal_526_s14_q <= equal_526_s13_q;
      last_s14_q <= last_s13_q;
      and_544_s14_q <= and_544_s13_q;
      and_546_s14_q <= and_546_s13_q;
      equal_566_s14_q <= equal_566_s13_q;
      select_570_s14_q <= first_s13_q ? 13'h0 : moments_place_q[12:0];
      equal_571_s14_q <= equal_571_s13_q;
      not_572_s14_q <= not_572_s13_q;
      so_s14_q <= so_s13_q;
      not_574_s14_q <= not_574_s13_q;
      equal_575_s14_q <= equal_575_s13_q;
      or_576_s14_q <= or_576_s13_q;
      less_579_s14_q <= less_579_s13_q;
      not_580_s14_q <= not_580_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      not_584_s14_q <= not_584;
      and_587_s14_q <= not_574_s13_q & (equal_575_s13_q & (inside_v_s13_q & not_584));
      and_597_s14_q <= and_597_s13_q;
      and_605_s14_q <= and_605_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[45:0];
      select_618_s14_q <= select_618;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      sum_629_s14_q <= {difference_628[8], difference_628} + 10'h1;
      and_636_s14_q <= and_636_s13_q;
      and_641_s14_q <= and_641_s13_q;
      and_643_s14_q <= and_643_s13_q;
      equal_676_s14_q <= equal_676_s13_q;
      select_758_s14_q <= select_758_s13_q;
      sum_1008_s14_q <= sum_1008;
      less_1507_s14_q <= sum_1258 < sum_1506;
      select_1545_s14_q <= select_1545;
      select_1553_s14_q <= select_758_s13_q ? 8'h0 : best_left_rdata_s13_q[53:46];
      select_1556_s14_q <= select_758_s13_q ? 8'h0 : best_left_rdata_s13_q[61:54];
      and_1558_s14_q <= and_1558_s13_q;
      select_1560_s14_q <= select_1560_s13_q;
      and_1569_s14_q <= and_1569_s13_q;
      and_1571_s14_q <= and_1571_s13_q;
      select_1575_s14_q <= select_1575;
      or_1579_s14_q <= or_1579_s13_q;
      and_1597_s14_q <= moments_taken_q;
      right_2_s14_q <= right_2_s13_q;
      and_1672_s14_q <= and_1672_s13_q;
      and_1685_s14_q <= and_1685_s13_q;
      and_1698_s14_q <= and_1698_s13_q;
      less_1699_s14_q <= less_1699_s13_q;
      equal_1700_s14_q <= equal_1700_s13_q;
      sum_1709_s14_q <= sum_1709[1];
      sum_1713_s14_q <= sum_1713;
      and_1732_s14_q <= and_1732_s13_q;
      select_1749_s14_q <= select_1749_s13_q;
      select_1775_s14_q <= select_1775_s13_q;
      equal_1777_s14_q <= equal_1777_s13_q;
      and_1782_s14_q <= and_1782_s13_q;
      and_1783_s14_q <= and_1783_s13_q;
      equal_1784_s14_q <= equal_1784_s13_q;
      not_1785_s14_q <= not_1785_s13_q;
      equal_1786_s14_q <= equal_1786_s13_q;
      not_1787_s14_q <= not_1787_s13_q;
      equal_1788_s14_q <= equal_1788_s13_q;
      equal_1789_s14_q <= equal_1789_s13_q;
      or_1790_s14_q <= or_1790_s13_q;
      select_1814_s14_q <= select_1814_s13_q;
      select_1820_s14_q <= select_1820_s13_q;
      select_1859_s14_q <= select_1859_s13_q;
      patches_columns_above_rdata_s14_q <= {patches_columns_above_rdata_s13_q[24], patches_columns_above_rdata_s13_q[7:0]};
      pixel_2_s14_q <= pixel_2_s13_q;
      sum_1883_s14_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1897_s14_q <= sum_1897;
      sum_1898_s14_q <= sum_1898;
      sum_1918_s14_q <= sum_1918;
      less_1963_s14_q <= less_1963_s13_q;
      equal_1964_s14_q <= equal_1964_s13_q;
      not_1965_s14_q <= not_1965_s13_q;
      equal_1966_s14_q <= equal_1966_s13_q;
      not_1967_s14_q <= not_1967_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      sum_1995_s14_q <= sum_1995_s13_q;
      and_2016_s14_q <= and_2016_s13_q;
      seen_columns_rdata_s14_q <= seen_columns_rdata_q;
      and_2139_s14_q <= and_2139_s13_q;
      equal_2279_s14_q <= equal_2279_s13_q;
      equal_2468_s14_q <= equal_2468_s13_q;
      and_2595_s14_q <= and_2595_s13_q;
      equal_2680_s14_q <= equal_2680_s13_q;
      lower_s14_q <= lower;
      sum_2686_s14_q <= {7'h0, rise_s13_q} + xor_2685_s13_q;
      select_2764_s14_q <= select_2764;
      and_2992_s14_q <= and_2992_s13_q;
      select_3528_s14_q <= select_3528;
      equal_3546_s14_q <= equal_3546_s13_q;
      and_3549_s14_q <= and_3549;
      select_3581_s14_q <= select_3581;
      less_3872_s14_q <= less_3872_s13_q;
      equal_4091_s14_q <= equal_4091_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [13:0] averager_running_0_q;
  logic [13:0] averager_running_1_q;
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
  // hls/stages/census.hpp:113
  logic [13:0] select_524;
  assign select_524 = equal_508_s14_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_530;
  assign sum_530 = {6'h0, sample_pair_pixel_1_q} + (equal_508_s14_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:788
  logic and_588;
  assign and_588 = not_572_s14_q & and_587_s14_q;
  // hls/stages/agreement.hpp:247
  logic and_631;
  assign and_631 = (and_605_s14_q & select_618_s14_q) & ({{22{sum_629_s14_q[9]}}, sum_629_s14_q} < 32'h3);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_1009;
  assign select_1009 = slot_s14_q[0] ? chosen_score_q : sum_1008_s14_q;
  // hls/stages/agreement.hpp:751
  logic [7:0] select_1508;
  assign select_1508 = less_1507_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1509;
  assign less_1509 = select_1009 < select_1508;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1509 ? select_1508 : select_1009) : 8'h0;
  // hls/stages/agreement.hpp:720
  logic not_1515;
  assign not_1515 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1516;
  assign select_1516 = less_1507_s14_q ? {slot_s14_q[0], not_1515} : 2'h0;
  logic [2:0] select_1518;
  assign select_1518 = less_1509 ? {select_1516, not_1515} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1545_s14_q : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1547;
  assign less_1547 = best_left_rdata_s14_q[39:33] < of_near;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s14_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:210
  logic equal_1618;
  assign equal_1618 = x_s14_q[5:0] == 6'h3c;
  logic equal_1620;
  assign equal_1620 = x_s14_q[5:0] == 6'h3b;
  logic equal_1622;
  assign equal_1622 = x_s14_q[5:0] == 6'h36;
  logic equal_1624;
  assign equal_1624 = x_s14_q[5:0] == 6'h35;
  logic equal_1626;
  assign equal_1626 = x_s14_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_1630;
  assign and_1630 = (~equal_1620) & ((~equal_1622) & ((~equal_1624) & (~equal_1626)));
  // hls/stages/patches.hpp:373
  logic [1:0] select_1686;
  assign select_1686 = and_1685_s14_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1687;
  assign select_1687 = and_1685_s14_q ? patches_band_rows_number_s14_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1688;
  assign select_1688 = and_1672_s14_q ? {select_1687, select_1686[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1689;
  assign select_1689 = and_1672_s14_q ? select_1686 : patches_fetch_q;
  logic equal_1690;
  assign equal_1690 = select_1689 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1700_s14_q ? {sum_1713_s14_q, sum_1709_s14_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1797;
  assign select_1797 = and_1672_s14_q ? select_1687 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_1798;
  assign equal_1798 = {patches_choosing_band_s14_q, and_1698_s14_q} == {select_1797, select_1689[1]};
  // hls/stages/patches.hpp:500
  logic less_1875;
  assign less_1875 = 5'he < patches_along_s14_q;
  // hls/stages/patches.hpp:501
  logic or_1876;
  assign or_1876 = equal_1788_s14_q | less_1875;
  // hls/stages/patches.hpp:504
  logic new_row;
  assign new_row = patches_along_s14_q == 5'h0;
  logic select_1881;
  assign select_1881 = equal_1788_s14_q ? patches_column_s14_q[0] : (or_1876 ? (patches_along_s14_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:502
  logic [4:0] select_1884;
  assign select_1884 = patches_match_row_ends_s14_q ? patches_down_by_s14_q : sum_1883_s14_q;
  // hls/stages/patches.hpp:505
  logic [4:0] select_1887;
  assign select_1887 = equal_1788_s14_q ? 5'h0 : (or_1876 ? (select_1884 + 5'h1) : sum_1883_s14_q);
  // hls/stages/patches.hpp:481
  logic equal_1890;
  assign equal_1890 = patches_column_s14_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s14_q == 5'h11;
  logic equal_1892;
  assign equal_1892 = patches_column_s14_q == 5'h18;
  // hls/stages/patches.hpp:483
  logic and_1894;
  assign and_1894 = of_row & (~equal_1892);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1890 ? 2'h3 : {equal_1892, and_1894};
  // hls/stages/patches.hpp:469
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1897_s14_q, pixel_2_s14_q[0]} - {1'b0, sum_1898_s14_q, patches_columns_above_rdata_s14_q[8]};
  // hls/stages/patches.hpp:467
  logic [9:0] sum_1919;
  assign sum_1919 = {2'h0, patches_columns_above_rdata_s14_q[7:0]} + sum_1918_s14_q[10:1];
  // hls/stages/patches.hpp:482
  logic or_1938;
  assign or_1938 = (((patches_column_s14_q == 5'ha) | of_row) | equal_1892) | equal_1890;
  // hls/stages/patches.hpp:477
  logic and_1943;
  assign and_1943 = (~(patches_code_row_s14_q[4:2] == 3'h0)) & (~(patches_column_s14_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:172
  logic and_1957;
  assign and_1957 = (~(equal_1789_s14_q | (~and_1943))) & (~patches_column_s14_q[4]);
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1982;
  assign select_1982 = so_s14_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1985;
  assign or_1985 = select_1982[7] | (~({select_1982[5], select_1982[3], select_1982[1]} == 3'h0));
  // hls/stages/agreement.hpp:1058
  logic or_1997;
  assign or_1997 = (~sum_1995_s14_q) | equal_1777_s14_q;
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s14_q & (or_576_s14_q & (not_580_s14_q & and_605_s14_q));
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2080;
  assign select_2080 = inside_v_s14_q ? (sum_1995_s14_q ? select_1982 : {select_1982[6:0], 1'b0}) : select_1982;
  // hls/stages/agreement.hpp:1050
  logic or_2083;
  assign or_2083 = select_2080[7] | (~({select_2080[5], select_2080[3], select_2080[1]} == 3'h0));
  // hls/stages/agreement.hpp:239
  logic [7:0] select_2577;
  assign select_2577 = slot_s14_q[0] ? 8'h0 : sum_1008_s14_q;
  // hls/stages/agreement.hpp:751
  logic less_2578;
  assign less_2578 = select_2577 < select_1508;
  // hls/stages/agreement.hpp:788
  logic less_2584;
  assign less_2584 = $signed(run_shift_s14_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2586;
  assign less_2586 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s14_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2684;
  assign difference_2684 = best_left_rdata_s14_q[16:9] - lower_s14_q;
  // hls/stages/agreement.hpp:788
  logic [10:0] select_2749;
  assign select_2749 = equal_571_s14_q ? registration_expected_q : (so_s14_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2764_s14_q[7]}}, select_2764_s14_q} - {sum_1713_s14_q[9], sum_1713_s14_q, sum_1709_s14_q};
  // hls/stages/patches.hpp:354
  logic not_3008;
  assign not_3008 = ~select_1689[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3010;
  assign select_3010 = sample_pair_whole_s14_q ? (equal_1690 ? select_1689 : {not_3008, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:184
  logic [4:0] select_3505;
  assign select_3505 = equal_1786_s14_q ? patches_down_by_s14_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:540
  logic [4:0] select_3550;
  assign select_3550 = and_3549_s14_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:547
  logic [5:0] away;
  assign away = {1'b0, patches_step_s14_q} - {1'b0, select_3550};
  // hls/stages/division.hpp:34
  logic [7:0] sum_3873;
  assign sum_3873 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3882;
  assign select_3882 = equal_571_s14_q ? select_1982 : (so_s14_q ? (ends_cell_s14_q ? select_2080 : select_1982) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3896;
  assign select_3896 = equal_676_s14_q ? {difference_3894[7], difference_3894} : (less_3872_s14_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3898;
  assign select_3898 = and_546_s14_q ? (equal_2468_s14_q ? select_3896 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3900;
  assign select_3900 = equal_676_s14_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3902;
  assign select_3902 = and_546_s14_q ? (equal_2468_s14_q ? select_3900 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3904;
  assign select_3904 = sum_3873[7] ? {1'b1, sum_3873[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory moments_memory, 8040 x 4, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 14, written in stage 15: 14 < 15 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:8039];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8040; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_570_s14_q;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s14_en & and_588;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
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
      sample_pair_pixel_0_q <= pixel_0_s14_q;
      sample_pair_pixel_1_q <= pixel_1_s14_q;
      chosen_score_q <= less_2578 ? select_1508 : select_2577;
      chosen_place_q <= less_2578 ? {select_1516, not_1515} : 3'h2;
      before_0_q <= select_2577;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2584) & (~less_2586);
      registration_expected_q <= select_2749;
      patches_band_q <= sample_pair_whole_s14_q ? select_1797 : patches_band_q;
      patches_fetch_q <= select_3010;
      patches_summed_down_by_q <= equal_1784_s14_q ? patches_summed_down_by_q : select_3505;
      patches_read_at_q <= equal_1784_s14_q ? select_3528_s14_q : patches_read_at_q;
      patches_peak_row_q <= equal_1784_s14_q ? select_3550 : patches_peak_row_q;
      region_columns_q <= select_3882;
      region_down_rest_q <= select_3898;
      region_down_back_q <= select_3902;
      region_down_next_q <= select_3904;
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
    if (s14_en) begin
      averager_running_0_q <= sample_pair_whole_s14_q ? select_524 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s14_q ? sum_530 : averager_running_1_q;
    end
  end

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
  logic [3:0] select_507_s15_q;
  logic equal_508_s15_q;
  logic [6:0] select_510_s15_q;
  logic [8:0] select_514_s15_q;
  logic and_520_s15_q;
  logic and_521_s15_q;
  logic [29:0] averager_memory_rdata_s15_q;
  logic [13:0] select_524_s15_q;
  logic equal_526_s15_q;
  logic [13:0] sum_530_s15_q;
  logic [6:0] last_s15_q;
  logic and_544_s15_q;
  logic and_546_s15_q;
  logic equal_566_s15_q;
  logic [12:0] select_570_s15_q;
  logic equal_571_s15_q;
  logic not_572_s15_q;
  logic so_s15_q;
  logic not_574_s15_q;
  logic equal_575_s15_q;
  logic or_576_s15_q;
  logic less_579_s15_q;
  logic not_580_s15_q;
  logic inside_v_s15_q;
  logic not_584_s15_q;
  logic and_588_s15_q;
  logic and_597_s15_q;
  logic [6:0] x_s15_2_q;
  logic [32:0] best_left_rdata_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic and_631_s15_q;
  logic and_636_s15_q;
  logic and_641_s15_q;
  logic and_643_s15_q;
  logic equal_676_s15_q;
  logic select_758_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1518_s15_q;
  logic [6:0] of_near_s15_q;
  logic [6:0] select_1548_s15_q;
  logic [5:0] select_1550_s15_q;
  logic [7:0] select_1553_s15_q;
  logic [7:0] select_1556_s15_q;
  logic and_1558_s15_q;
  logic select_1560_s15_q;
  logic or_1566_s15_q;
  logic and_1569_s15_q;
  logic and_1571_s15_q;
  logic [1:0] shown_right_rdata_s15_q;
  logic [6:0] select_1575_s15_q;
  logic and_1580_s15_q;
  logic [1:0] left_turns_rdata_s15_q;
  logic and_1597_s15_q;
  logic [1:0] right_turns_rdata_s15_q;
  logic equal_1604_s15_q;
  logic all_s15_q;
  logic equal_1618_s15_q;
  logic equal_1620_s15_q;
  logic equal_1622_s15_q;
  logic equal_1624_s15_q;
  logic equal_1626_s15_q;
  logic and_1631_s15_q;
  logic right_2_s15_q;
  logic and_1672_s15_q;
  logic [5:0] select_1688_s15_q;
  logic select_1689_s15_q;
  logic equal_1690_s15_q;
  logic and_1698_s15_q;
  logic less_1699_s15_q;
  logic equal_1700_s15_q;
  logic expected_s15_q;
  logic [10:0] sum_1715_s15_q;
  logic and_1732_s15_q;
  logic [5:0] select_1749_s15_q;
  logic [7:0] select_1775_s15_q;
  logic and_1782_s15_q;
  logic and_1783_s15_q;
  logic equal_1784_s15_q;
  logic not_1785_s15_q;
  logic equal_1786_s15_q;
  logic not_1787_s15_q;
  logic equal_1789_s15_q;
  logic or_1790_s15_q;
  logic and_1799_s15_q;
  logic [4:0] select_1814_s15_q;
  logic select_1820_s15_q;
  logic [3:0] select_1859_s15_q;
  logic patches_columns_above_rdata_s15_q;
  logic [7:0] pixel_2_s15_q;
  logic less_1875_s15_q;
  logic new_row_s15_q;
  logic select_1881_s15_q;
  logic not_1882_s15_q;
  logic [4:0] select_1887_s15_q;
  logic or_1888_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [10:0] down_2_s15_q;
  logic sum_1918_s15_q;
  logic [9:0] sum_1919_s15_q;
  logic and_1946_s15_q;
  logic and_1957_s15_q;
  logic and_1960_s15_q;
  logic less_1963_s15_q;
  logic equal_1964_s15_q;
  logic not_1965_s15_q;
  logic equal_1966_s15_q;
  logic not_1967_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic or_1985_s15_q;
  logic or_1988_s15_q;
  logic or_1991_s15_q;
  logic and_2000_s15_q;
  logic textured_s15_q;
  logic and_2016_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic and_2066_s15_q;
  logic and_2068_s15_q;
  logic or_2083_s15_q;
  logic or_2086_s15_q;
  logic or_2089_s15_q;
  logic and_2100_s15_q;
  logic and_2116_s15_q;
  logic and_2139_s15_q;
  logic equal_2279_s15_q;
  logic equal_2468_s15_q;
  logic and_2595_s15_q;
  logic and_2619_s15_q;
  logic equal_2680_s15_q;
  logic [5:0] difference_2684_s15_q;
  logic [7:0] sum_2686_s15_q;
  logic [11:0] select_2767_s15_q;
  logic and_2992_s15_q;
  logic less_3119_s15_q;
  logic equal_3546_s15_q;
  logic [4:0] select_3550_s15_q;
  logic [5:0] away_s15_q;
  logic equal_3552_s15_q;
  logic equal_3561_s15_q;
  logic [14:0] select_3581_s15_q;
  logic less_3872_s15_q;
  logic sum_3873_s15_q;
  logic select_3915_s15_q;
  logic equal_3926_s15_q;
  logic equal_3965_s15_q;
  logic and_4081_s15_q;
  logic equal_4091_s15_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s15_q <= saturated_s14_q;
      mask_s15_q <= mask_s14_q;
      marks_first_s15_q <= marks_first_s14_q;
      marks_last_s15_q <= marks_last_s14_q;
      sample_pair_pixel_0_s15_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s15_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s15_q <= sample_pair_whole_s14_q;
      sample_present_s15_q <= sample_present_s14_q;
      moments_starts_s15_q <= moments_starts_s14_q;
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
      select_507_s15_q <= select_507_s14_q;
      equal_508_s15_q <= equal_508_s14_q;
      select_510_s15_q <= select_510_s14_q;
      select_514_s15_q <= select_514_s14_q;
      and_520_s15_q <= and_520_s14_q;
      and_521_s15_q <= and_521_s14_q;
      averager_memory_rdata_s15_q <= averager_memory_rdata_q;
      select_524_s15_q <= select_524;
      equal_526_s15_q <= equal_526_s14_q;
      sum_530_s15_q <= sum_530;
      last_s15_q <= last_s14_q;
      and_544_s15_q <= and_544_s14_q;
      and_546_s15_q <= and_546_s14_q;
      equal_566_s15_q <= equal_566_s14_q;
      select_570_s15_q <= select_570_s14_q;
      equal_571_s15_q <= equal_571_s14_q;
      not_572_s15_q <= not_572_s14_q;
      so_s15_q <= so_s14_q;
      not_574_s15_q <= not_574_s14_q;
      equal_575_s15_q <= equal_575_s14_q;
      or_576_s15_q <= or_576_s14_q;
      less_579_s15_q <= less_579_s14_q;
      not_580_s15_q <= not_580_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      not_584_s15_q <= not_584_s14_q;
      and_588_s15_q <= and_588;
      and_597_s15_q <= and_597_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q[32:0];
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      and_631_s15_q <= and_631;
      and_636_s15_q <= and_636_s14_q;
      and_641_s15_q <= and_641_s14_q;
      and_643_s15_q <= and_643_s14_q;
      equal_676_s15_q <= equal_676_s14_q;
      select_758_s15_q <= select_758_s14_q;
      of_best_s15_q <= of_best;
      select_1518_s15_q <= select_1518;
      of_near_s15_q <= of_near;
      select_1548_s15_q <= less_1547 ? of_near : best_left_rdata_s14_q[39:33];
      select_1550_s15_q <= less_1547 ? run_shift_s14_q : best_left_rdata_s14_q[45:40];
      select_1553_s15_q <= select_1553_s14_q;
      select_1556_s15_q <= select_1556_s14_q;
      and_1558_s15_q <= and_1558_s14_q;
      select_1560_s15_q <= select_1560_s14_q;
      or_1566_s15_q <= select_1560_s14_q | (best_right_rdata_s14_q[21:15] < of_near);
      and_1569_s15_q <= and_1569_s14_q;
      and_1571_s15_q <= and_1571_s14_q;
      shown_right_rdata_s15_q <= shown_right_rdata_q;
      select_1575_s15_q <= select_1575_s14_q;
      and_1580_s15_q <= and_631 & or_1579_s14_q;
      left_turns_rdata_s15_q <= left_turns_rdata_q;
      and_1597_s15_q <= and_1597_s14_q;
      right_turns_rdata_s15_q <= right_turns_rdata_q;
      equal_1604_s15_q <= x_s14_q[6:4] == 3'h7;
      all_s15_q <= all;
      equal_1618_s15_q <= equal_1618;
      equal_1620_s15_q <= equal_1620;
      equal_1622_s15_q <= equal_1622;
      equal_1624_s15_q <= equal_1624;
      equal_1626_s15_q <= equal_1626;
      and_1631_s15_q <= (~equal_1618) & and_1630;
      right_2_s15_q <= right_2_s14_q;
      and_1672_s15_q <= and_1672_s14_q;
      select_1688_s15_q <= select_1688;
      select_1689_s15_q <= select_1689[1];
      equal_1690_s15_q <= equal_1690;
      and_1698_s15_q <= and_1698_s14_q;
      less_1699_s15_q <= less_1699_s14_q;
      equal_1700_s15_q <= equal_1700_s14_q;
      expected_s15_q <= expected[0];
      sum_1715_s15_q <= {expected[10], expected[10:1]} + 11'h5;
      and_1732_s15_q <= and_1732_s14_q;
      select_1749_s15_q <= select_1749_s14_q;
      select_1775_s15_q <= select_1775_s14_q;
      and_1782_s15_q <= and_1782_s14_q;
      and_1783_s15_q <= and_1783_s14_q;
      equal_1784_s15_q <= equal_1784_s14_q;
      not_1785_s15_q <= not_1785_s14_q;
      equal_1786_s15_q <= equal_1786_s14_q;
      not_1787_s15_q <= not_1787_s14_q;
      equal_1789_s15_q <= equal_1789_s14_q;
      or_1790_s15_q <= or_1790_s14_q;
      and_1799_s15_q <= and_1783_s14_q & equal_1798;
      select_1814_s15_q <= select_1814_s14_q;
      select_1820_s15_q <= select_1820_s14_q;
      select_1859_s15_q <= select_1859_s14_q;
      patches_columns_above_rdata_s15_q <= patches_columns_above_rdata_s14_q[8];
      pixel_2_s15_q <= pixel_2_s14_q;
      less_1875_s15_q <= less_1875;
      new_row_s15_q <= new_row;
      select_1881_s15_q <= select_1881;
      not_1882_s15_q <= ~or_1876;
      select_1887_s15_q <= select_1887;
      or_1888_s15_q <= equal_1788_s14_q | equal_1786_s14_q;
      of_row_2_s15_q <= of_row_2;
      down_2_s15_q <= down_2;
      sum_1918_s15_q <= sum_1918_s14_q[0];
      sum_1919_s15_q <= sum_1919;
      and_1946_s15_q <= or_1790_s14_q & (or_1938 & (equal_1789_s14_q & and_1943));
      and_1957_s15_q <= and_1957;
      and_1960_s15_q <= or_1790_s14_q & (and_1957 & (patches_column_s14_q == 5'hf));
      less_1963_s15_q <= less_1963_s14_q;
      equal_1964_s15_q <= equal_1964_s14_q;
      not_1965_s15_q <= not_1965_s14_q;
      equal_1966_s15_q <= equal_1966_s14_q;
      not_1967_s15_q <= not_1967_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      or_1985_s15_q <= or_1985;
      or_1988_s15_q <= select_1982[7] | (~({select_1982[6], select_1982[3:2]} == 3'h0));
      or_1991_s15_q <= select_1982[7] | (~(select_1982[6:4] == 3'h0));
      and_2000_s15_q <= so_s14_q & (ends_cell_s14_q & (inside_v_s14_q & or_1997));
      textured_s15_q <= textured;
      and_2016_s15_q <= and_2016_s14_q;
      seen_columns_rdata_s15_q <= {seen_columns_rdata_s14_q[13:7], seen_columns_rdata_s14_q[5:0]};
      and_2066_s15_q <= seen_columns_rdata_s14_q[14] & inside_v_s14_q;
      and_2068_s15_q <= seen_columns_rdata_s14_q[5] & inside_v_s14_q;
      or_2083_s15_q <= or_2083;
      or_2086_s15_q <= select_2080[7] | (~({select_2080[6], select_2080[3:2]} == 3'h0));
      or_2089_s15_q <= select_2080[7] | (~(select_2080[6:4] == 3'h0));
      and_2100_s15_q <= seen_columns_rdata_s14_q[16] & inside_v_s14_q;
      and_2116_s15_q <= seen_columns_rdata_s14_q[17] & inside_v_s14_q;
      and_2139_s15_q <= and_2139_s14_q;
      equal_2279_s15_q <= equal_2279_s14_q;
      equal_2468_s15_q <= equal_2468_s14_q;
      and_2595_s15_q <= and_2595_s14_q;
      and_2619_s15_q <= seen_columns_rdata_s14_q[15] & inside_v_s14_q;
      equal_2680_s15_q <= equal_2680_s14_q;
      difference_2684_s15_q <= difference_2684[7:2];
      sum_2686_s15_q <= sum_2686_s14_q;
      select_2767_s15_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_2992_s15_q <= and_2992_s14_q;
      less_3119_s15_q <= 4'he < patches_column_s14_q[4:1];
      equal_3546_s15_q <= equal_3546_s14_q;
      select_3550_s15_q <= select_3550;
      away_s15_q <= away;
      equal_3552_s15_q <= away == 6'h3f;
      equal_3561_s15_q <= away == 6'h1;
      select_3581_s15_q <= select_3581_s14_q;
      less_3872_s15_q <= less_3872_s14_q;
      sum_3873_s15_q <= sum_3873[7];
      select_3915_s15_q <= sum_1995_s14_q ? (equal_1777_s14_q & or_1997) : or_1997;
      equal_3926_s15_q <= x_s14_q[6:3] == 4'h7;
      equal_3965_s15_q <= x_s14_q[6:3] == 4'h6;
      and_4081_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      equal_4091_s15_q <= equal_4091_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
  logic sample_of_skin_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
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
  // hls/stages/census.hpp:122
  logic [13:0] sum_528;
  assign sum_528 = select_524_s15_q + (equal_526_s15_q ? 14'h0 : averager_memory_rdata_s15_q[13:0]);
  logic [13:0] sum_532;
  assign sum_532 = sum_530_s15_q + (equal_526_s15_q ? 14'h0 : averager_memory_rdata_s15_q[27:14]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = equal_508_s15_q ? sample_present_s15_q : (sample_present_s15_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_508_s15_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:124
  logic and_540;
  assign and_540 = all_of_skin & (averager_memory_rdata_s15_q[29] | equal_526_s15_q);
  // hls/stages/agreement.hpp:149
  logic and_633;
  assign and_633 = or_576_s15_q & (not_580_s15_q & and_631_s15_q);
  // hls/stages/moments.hpp:77
  logic and_634;
  assign and_634 = and_597_s15_q & and_633;
  // hls/stages/agreement.hpp:810
  logic equal_1521;
  assign equal_1521 = select_1518_s15_q == 3'h1;
  logic or_1524;
  assign or_1524 = equal_1521 | (~(select_1518_s15_q == 3'h2));
  logic [7:0] select_1526;
  assign select_1526 = or_1524 ? before_0_s15_q : before_1_s15_q;
  logic [7:0] select_1527;
  assign select_1527 = equal_1521 ? (or_1524 ? before_1_q : {7'h0, shift_not_right_s15_q}) : select_1526;
  // hls/stages/agreement.hpp:811
  logic [7:0] select_1530;
  assign select_1530 = equal_1521 ? select_1526 : (or_1524 ? before_2_q : before_2_s15_q);
  // hls/stages/agreement.hpp:824
  logic or_1562;
  assign or_1562 = select_1560_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:149
  logic and_1582;
  assign and_1582 = or_576_s15_q & (not_580_s15_q & and_1580_s15_q);
  // hls/stages/agreement.hpp:788
  logic and_1586;
  assign and_1586 = not_572_s15_q & (so_s15_q ? and_1569_s15_q : (equal_575_s15_q & and_633));
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s15_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1607;
  assign select_1607 = x_s15_q[4] ? {x_s15_q[3], x_s15_q[0]} : {x_s15_q[0], x_s15_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1609;
  assign select_1609 = equal_1604_s15_q ? {2'h0, quarter} : (all_s15_q ? {1'b0, x_s15_q[2:0]} : {x_s15_q[2:1], select_1607});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1610;
  assign sum_1610 = slot_s15_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1611;
  assign select_1611 = equal_571_s15_q ? select_1609 : {sum_1610, lower_half_s15_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1612;
  assign equal_1612 = x_s15_q[5:0] == 6'h3f;
  logic equal_1614;
  assign equal_1614 = x_s15_q[5:0] == 6'h3e;
  logic equal_1616;
  assign equal_1616 = x_s15_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1178
  logic and_1634;
  assign and_1634 = (~equal_1612) & ((~equal_1614) & ((~equal_1616) & and_1631_s15_q));
  // hls/stages/agreement.hpp:1129
  logic less_1635;
  assign less_1635 = x_s15_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s15_q ? {1'b0, x_s15_q[2]} : x_s15_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1639;
  assign or_1639 = (kind == 2'h3) | (x_s15_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s15_q ? (right_2_s15_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1650;
  assign sum_1650 = {2'h0, slot_s15_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1656;
  assign not_1656 = ~lower_half_s15_q;
  logic [3:0] select_1657;
  assign select_1657 = registration_of_right_q ? {lower_half_s15_q, 1'b0, not_1656, 1'b0} : {1'b0, lower_half_s15_q, 1'b0, not_1656};
  // hls/stages/patches.hpp:98
  logic less_1716;
  assign less_1716 = {{4{sum_1715_s15_q[10]}}, sum_1715_s15_q, expected_s15_q} < 16'h15;
  // hls/stages/patches.hpp:471
  logic [11:0] sum_1900;
  assign sum_1900 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1901;
  assign sum_1901 = {{4{down_2_s15_q[10]}}, down_2_s15_q[10:2]} + {sum_1900[11], sum_1900};
  // hls/stages/patches.hpp:468
  logic [11:0] smooth;
  assign smooth = {sum_1919_s15_q, sum_1918_s15_q, patches_columns_above_rdata_s15_q} + {4'h0, pixel_2_s15_q};
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1992;
  assign select_1992 = equal_571_s15_q ? x_s15_q[5:0] : {region_row_q, or_1991_s15_q, or_1988_s15_q, or_1985_s15_q};
  // hls/stages/agreement.hpp:1128
  logic not_1993;
  assign not_1993 = ~equal_1604_s15_q;
  // hls/stages/agreement.hpp:149
  logic and_2018;
  assign and_2018 = or_576_s15_q & (not_580_s15_q & and_2016_s15_q);
  // hls/stages/agreement.hpp:1014
  logic select_2028;
  assign select_2028 = slot_s15_q[2] ? shown_shown_q : and_633;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s15_q & (shown_right_rdata_s15_q[0] | select_2028);
  // hls/stages/agreement.hpp:1014
  logic select_2031;
  assign select_2031 = slot_s15_q[2] ? shown_nearer_q : and_1582;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s15_q & (select_2028 ? select_2031 : shown_right_rdata_s15_q[1]);
  // hls/stages/agreement.hpp:276
  logic select_2192;
  assign select_2192 = sample_pair_whole_s15_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:788
  logic and_2599;
  assign and_2599 = not_572_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_2595_s15_q)));
  // hls/stages/agreement.hpp:1105
  logic not_2618;
  assign not_2618 = ~(x_s15_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:788
  logic and_2660;
  assign and_2660 = so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & (and_2595_s15_q & and_2018)));
  // hls/stages/agreement.hpp:1110
  logic and_2665;
  assign and_2665 = not_2618 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:247
  logic and_2689;
  assign and_2689 = ((and_2016_s15_q & and_631_s15_q) & equal_2680_s15_q) & (~({2'h0, difference_2684_s15_q} < sum_2686_s15_q));
  // hls/stages/agreement.hpp:149
  logic and_2699;
  assign and_2699 = not_580_s15_q & (slot_s15_q[2] & left_turns_rdata_s15_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2701;
  assign and_2701 = not_580_s15_q & (slot_s15_q[2] & left_turns_rdata_s15_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2702;
  assign select_2702 = or_576_s15_q ? {and_2701, and_2699} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2704;
  assign select_2704 = less_579_s15_q ? 2'h0 : (slot_s15_q[2] ? right_turns_rdata_s15_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2705;
  assign select_2705 = or_576_s15_q ? select_2704 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2750;
  assign equal_2750 = slot_s15_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2767_s15_q[11:7])) ? 12'h7f : select_2767_s15_q;
  // hls/stages/agreement.hpp:788
  logic select_2811;
  assign select_2811 = so_s15_q ? (equal_2750 ? right_2_s15_q : registration_of_right_q) : registration_of_right_q;
  logic select_2814;
  assign select_2814 = so_s15_q ? (equal_1700_s15_q ? inside_v_s15_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all_s15_q ? x_s15_q[1:0] : select_1607;
  // hls/stages/patches.hpp:184
  logic [10:0] select_3097;
  assign select_3097 = equal_1786_s15_q ? patches_down_values_0_q : (or_1790_s15_q ? down_2_s15_q : patches_down_values_0_q);
  logic [10:0] select_3099;
  assign select_3099 = or_1790_s15_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3101;
  assign select_3101 = equal_1784_s15_q ? patches_down_values_1_q : (equal_1786_s15_q ? patches_down_values_1_q : select_3099);
  // hls/stages/patches.hpp:556
  logic and_3554;
  assign and_3554 = less_1963_s15_q & (equal_3546_s15_q & equal_3552_s15_q);
  // hls/stages/patches.hpp:560
  logic select_3557;
  assign select_3557 = equal_1966_s15_q ? (less_1963_s15_q ? (not_1967_s15_q & and_3554) : and_3554) : and_3554;
  // hls/stages/patches.hpp:556
  logic and_3563;
  assign and_3563 = less_1963_s15_q & (equal_3546_s15_q & equal_3561_s15_q);
  // hls/stages/patches.hpp:560
  logic select_3566;
  assign select_3566 = equal_1966_s15_q ? (less_1963_s15_q ? (not_1967_s15_q & and_3563) : and_3563) : and_3563;
  // hls/stages/patches.hpp:553
  logic [6:0] sum_3570;
  assign sum_3570 = {away_s15_q[5], away_s15_q} + 7'h7d;
  // hls/stages/agreement.hpp:788
  logic select_3869;
  assign select_3869 = equal_571_s15_q ? shown_shown_q : (so_s15_q ? select_2028 : shown_shown_q);
  logic select_3871;
  assign select_3871 = equal_571_s15_q ? shown_nearer_q : (so_s15_q ? select_2031 : shown_nearer_q);
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3875;
  assign select_3875 = less_3872_s15_q ? (sum_3873_s15_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3877;
  assign select_3877 = equal_2468_s15_q ? (equal_676_s15_q ? 3'h0 : select_3875) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3873_s15_q;
  // hls/stages/agreement.hpp:460
  logic select_3908;
  assign select_3908 = equal_2468_s15_q ? (equal_676_s15_q | (less_3872_s15_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3913;
  assign or_3913 = segment_starts_q | not_574_s15_q;
  // hls/stages/agreement.hpp:788
  logic select_3917;
  assign select_3917 = ends_cell_s15_q ? (inside_v_s15_q ? select_3915_s15_q : or_3913) : or_3913;
  // hls/stages/agreement.hpp:1217
  logic equal_3946;
  assign equal_3946 = x_s15_q[6:3] == 4'ha;
  logic equal_3950;
  assign equal_3950 = x_s15_q[6:3] == 4'h9;
  logic equal_3951;
  assign equal_3951 = x_s15_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3967;
  assign select_3967 = equal_3926_s15_q ? cfg_unproven_limit_i : (equal_3965_s15_q ? cfg_explained_limit_i : cfg_regions_limit_i);
  logic [7:0] select_3969;
  assign select_3969 = equal_3950 ? cfg_hidden_limit_i : (equal_3951 ? cfg_unproven_skin_limit_i : select_3967);
  // hls/stages/agreement.hpp:788
  logic select_4079;
  assign select_4079 = so_s15_q ? (ends_cell_s15_q ? and_2068_s15_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4083;
  assign select_4083 = so_s15_q ? (ends_cell_s15_q ? and_4081_s15_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4085;
  assign select_4085 = ends_cell_s15_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4087;
  assign select_4087 = equal_571_s15_q ? centres_values_1_textured_q : (so_s15_q ? select_4085 : centres_values_1_textured_q);
  logic select_4088;
  assign select_4088 = ends_cell_s15_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4090;
  assign select_4090 = equal_571_s15_q ? centres_values_1_of_skin_q : (so_s15_q ? select_4088 : centres_values_1_of_skin_q);

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:340; read in stage 15, written in stage 17: 15 < 17 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = last_s15_q;
`ifndef SYNTHESIS
  logic census_memory_re;
  assign census_memory_re = s15_en & and_546_s15_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:767; read in stage 15, written in stage 17: 15 < 17 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1688_s15_q;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s15_en & (sample_pair_whole_s15_q & (~equal_1690_s15_q));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:796; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1887_s15_q, not_1882_s15_q, select_1881_s15_q};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s15_en & or_1888_s15_q;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:797; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
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
  assign patches_left_codes_re = s15_en & (not_1785_s15_q & (new_row_s15_q & equal_1786_s15_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1398; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1992;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s15_en & (equal_571_s15_q ? (x_s15_q[6] & not_1993) : and_2000_s15_q);
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory moments_memory, write
  logic [12:0] moments_memory_waddr;
  assign moments_memory_waddr = select_570_s15_q;
  logic moments_memory_we;
  assign moments_memory_we = s15_en & and_588_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_643_s15_q, and_641_s15_q, and_636_s15_q, and_634};
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
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
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
    end else if (s15_en) begin
      sample_of_skin_q <= mask_s15_q;
      averager_running_mask_q <= sample_pair_whole_s15_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2192;
      registration_of_right_q <= equal_571_s15_q ? registration_of_right_q : select_2811;
      registration_was_inside_q <= equal_571_s15_q ? registration_was_inside_q : select_2814;
      patches_down_values_0_q <= equal_1784_s15_q ? patches_down_values_0_q : select_3097;
      patches_down_values_1_q <= select_3101;
      shown_shown_q <= select_3869;
      shown_nearer_q <= select_3871;
      region_row_q <= and_546_s15_q ? select_3877 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_546_s15_q ? select_3908 : region_fresh_q;
      segment_starts_q <= equal_571_s15_q ? or_3913 : (so_s15_q ? select_3917 : or_3913);
      centres_values_0_textured_q <= equal_571_s15_q ? centres_values_0_textured_q : select_4079;
      centres_values_0_of_skin_q <= equal_571_s15_q ? centres_values_0_of_skin_q : select_4083;
      centres_values_1_textured_q <= select_4087;
      centres_values_1_of_skin_q <= select_4090;
    end
  end

  logic [7:0] pixel_0_s16_q;
  logic [7:0] pixel_1_s16_q;
  logic saturated_s16_q;
  logic marks_first_s16_q;
  logic marks_last_s16_q;
  logic [7:0] sample_pair_pixel_0_s16_q;
  logic [7:0] sample_pair_pixel_1_s16_q;
  logic sample_pair_whole_s16_q;
  logic sample_present_s16_q;
  logic moments_starts_s16_q;
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
  logic [3:0] select_507_s16_q;
  logic [6:0] select_510_s16_q;
  logic [8:0] select_514_s16_q;
  logic and_520_s16_q;
  logic and_521_s16_q;
  logic [13:0] sum_528_s16_q;
  logic [13:0] sum_532_s16_q;
  logic and_536_s16_q;
  logic and_540_s16_q;
  logic [6:0] last_s16_q;
  logic and_544_s16_q;
  logic and_546_s16_q;
  logic equal_549_s16_q;
  logic equal_566_s16_q;
  logic equal_571_s16_q;
  logic not_572_s16_q;
  logic so_s16_q;
  logic not_574_s16_q;
  logic equal_575_s16_q;
  logic inside_v_s16_q;
  logic not_584_s16_q;
  logic [3:0] moments_memory_rdata_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic and_633_s16_q;
  logic and_636_s16_q;
  logic and_643_s16_q;
  logic equal_676_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1513_s16_q;
  logic [2:0] select_1518_s16_q;
  logic [7:0] select_1527_s16_q;
  logic [7:0] select_1530_s16_q;
  logic [6:0] select_1549_s16_q;
  logic [5:0] select_1551_s16_q;
  logic [7:0] select_1554_s16_q;
  logic [7:0] select_1557_s16_q;
  logic and_1558_s16_q;
  logic or_1562_s16_q;
  logic [6:0] select_1567_s16_q;
  logic [6:0] select_1568_s16_q;
  logic and_1571_s16_q;
  logic [6:0] select_1575_s16_q;
  logic and_1582_s16_q;
  logic and_1586_s16_q;
  logic and_1597_s16_q;
  logic equal_1604_s16_q;
  logic [1:0] quarter_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1610_s16_q;
  logic [3:0] select_1611_s16_q;
  logic equal_1612_s16_q;
  logic equal_1614_s16_q;
  logic equal_1616_s16_q;
  logic equal_1618_s16_q;
  logic equal_1620_s16_q;
  logic equal_1622_s16_q;
  logic equal_1624_s16_q;
  logic equal_1626_s16_q;
  logic less_1635_s16_q;
  logic or_1639_s16_q;
  logic select_1642_s16_q;
  logic and_1652_s16_q;
  logic [3:0] select_1657_s16_q;
  logic and_1672_s16_q;
  logic select_1689_s16_q;
  logic equal_1690_s16_q;
  logic and_1698_s16_q;
  logic equal_1700_s16_q;
  logic and_1733_s16_q;
  logic [5:0] select_1749_s16_q;
  logic [7:0] select_1775_s16_q;
  logic and_1782_s16_q;
  logic and_1783_s16_q;
  logic equal_1784_s16_q;
  logic equal_1786_s16_q;
  logic equal_1789_s16_q;
  logic or_1790_s16_q;
  logic and_1799_s16_q;
  logic [4:0] select_1814_s16_q;
  logic select_1820_s16_q;
  logic [3:0] select_1859_s16_q;
  logic less_1875_s16_q;
  logic new_row_s16_q;
  logic or_1888_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic [1:0] down_2_s16_q;
  logic [12:0] sum_1901_s16_q;
  logic [11:0] smooth_s16_q;
  logic and_1948_s16_q;
  logic and_1957_s16_q;
  logic and_1962_s16_q;
  logic less_1963_s16_q;
  logic equal_1964_s16_q;
  logic not_1965_s16_q;
  logic equal_1966_s16_q;
  logic [9:0] patches_rows_rdata_s16_q;
  logic or_1985_s16_q;
  logic or_1988_s16_q;
  logic or_1991_s16_q;
  logic not_1993_s16_q;
  logic textured_s16_q;
  logic and_2018_s16_q;
  logic and_2025_s16_q;
  logic [12:0] seen_columns_rdata_s16_q;
  logic shown_s16_q;
  logic near_s16_q;
  logic and_2066_s16_q;
  logic and_2068_s16_q;
  logic or_2083_s16_q;
  logic or_2086_s16_q;
  logic or_2089_s16_q;
  logic and_2100_s16_q;
  logic and_2102_s16_q;
  logic and_2103_s16_q;
  logic and_2116_s16_q;
  logic and_2118_s16_q;
  logic and_2119_s16_q;
  logic and_2139_s16_q;
  logic equal_2279_s16_q;
  logic equal_2468_s16_q;
  logic and_2599_s16_q;
  logic not_2618_s16_q;
  logic and_2619_s16_q;
  logic and_2621_s16_q;
  logic and_2622_s16_q;
  logic and_2661_s16_q;
  logic and_2668_s16_q;
  logic and_2692_s16_q;
  logic select_2702_s16_q;
  logic select_2705_s16_q;
  logic and_2706_s16_q;
  logic and_2753_s16_q;
  logic and_2754_s16_q;
  logic [11:0] residual_s16_q;
  logic equal_2816_s16_q;
  logic [3:0] not_2817_s16_q;
  logic [1:0] quarter_2_s16_q;
  logic and_2992_s16_q;
  logic less_3119_s16_q;
  logic equal_3462_s16_q;
  logic [4:0] select_3550_s16_q;
  logic select_3557_s16_q;
  logic select_3566_s16_q;
  logic and_3572_s16_q;
  logic [14:0] select_3581_s16_q;
  logic equal_3926_s16_q;
  logic equal_3946_s16_q;
  logic equal_3949_s16_q;
  logic equal_3950_s16_q;
  logic equal_3951_s16_q;
  logic [7:0] select_3970_s16_q;
  logic equal_4091_s16_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s16_q <= sample_pair_pixel_0_q;
      pixel_1_s16_q <= sample_pair_pixel_1_q;
      saturated_s16_q <= saturated_s15_q;
      marks_first_s16_q <= marks_first_s15_q;
      marks_last_s16_q <= marks_last_s15_q;
      sample_pair_pixel_0_s16_q <= sample_pair_pixel_0_s15_q;
      sample_pair_pixel_1_s16_q <= sample_pair_pixel_1_s15_q;
      sample_pair_whole_s16_q <= sample_pair_whole_s15_q;
      sample_present_s16_q <= sample_present_s15_q;
      moments_starts_s16_q <= moments_starts_s15_q;
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
      select_507_s16_q <= select_507_s15_q;
      select_510_s16_q <= select_510_s15_q;
      select_514_s16_q <= select_514_s15_q;
      and_520_s16_q <= and_520_s15_q;
      and_521_s16_q <= and_521_s15_q;
      sum_528_s16_q <= sum_528;
      sum_532_s16_q <= sum_532;
      and_536_s16_q <= whole & (averager_memory_rdata_s15_q[28] | equal_526_s15_q);
      and_540_s16_q <= and_540;
      last_s16_q <= last_s15_q;
      and_544_s16_q <= and_544_s15_q;
      and_546_s16_q <= and_546_s15_q;
      equal_549_s16_q <= select_507_s15_q == 4'h3;
      equal_566_s16_q <= equal_566_s15_q;
      equal_571_s16_q <= equal_571_s15_q;
      not_572_s16_q <= not_572_s15_q;
      so_s16_q <= so_s15_q;
      not_574_s16_q <= not_574_s15_q;
      equal_575_s16_q <= equal_575_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      not_584_s16_q <= not_584_s15_q;
      moments_memory_rdata_s16_q <= moments_memory_rdata_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      and_633_s16_q <= and_633;
      and_636_s16_q <= and_636_s15_q;
      and_643_s16_q <= and_643_s15_q;
      equal_676_s16_q <= equal_676_s15_q;
      of_best_s16_q <= of_best_s15_q;
      or_1513_s16_q <= select_758_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1518_s16_q <= select_1518_s15_q;
      select_1527_s16_q <= select_1527;
      select_1530_s16_q <= select_1530;
      select_1549_s16_q <= select_758_s15_q ? of_near_s15_q : select_1548_s15_q;
      select_1551_s16_q <= select_758_s15_q ? run_shift_s15_q : select_1550_s15_q;
      select_1554_s16_q <= (run_shift_s15_q == 6'h3f) ? of_best_s15_q : select_1553_s15_q;
      select_1557_s16_q <= (run_shift_s15_q == 6'h1) ? of_best_s15_q : select_1556_s15_q;
      and_1558_s16_q <= and_1558_s15_q;
      or_1562_s16_q <= or_1562;
      select_1567_s16_q <= or_1566_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1568_s16_q <= or_1566_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      and_1571_s16_q <= and_1571_s15_q;
      select_1575_s16_q <= select_1575_s15_q;
      and_1582_s16_q <= and_1582;
      and_1586_s16_q <= and_1586;
      and_1597_s16_q <= and_1597_s15_q;
      equal_1604_s16_q <= equal_1604_s15_q;
      quarter_s16_q <= quarter;
      all_s16_q <= all_s15_q;
      sum_1610_s16_q <= sum_1610;
      select_1611_s16_q <= select_1611;
      equal_1612_s16_q <= equal_1612;
      equal_1614_s16_q <= equal_1614;
      equal_1616_s16_q <= equal_1616;
      equal_1618_s16_q <= equal_1618_s15_q;
      equal_1620_s16_q <= equal_1620_s15_q;
      equal_1622_s16_q <= equal_1622_s15_q;
      equal_1624_s16_q <= equal_1624_s15_q;
      equal_1626_s16_q <= equal_1626_s15_q;
      less_1635_s16_q <= less_1635;
      or_1639_s16_q <= or_1639;
      select_1642_s16_q <= equal_1604_s15_q ? and_1634 : (less_1635 & (~or_1639));
      and_1652_s16_q <= half_ends & ({{3{sum_1650[4]}}, sum_1650} < 8'h3);
      select_1657_s16_q <= select_1657;
      and_1672_s16_q <= and_1672_s15_q;
      select_1689_s16_q <= select_1689_s15_q;
      equal_1690_s16_q <= equal_1690_s15_q;
      and_1698_s16_q <= and_1698_s15_q;
      equal_1700_s16_q <= equal_1700_s15_q;
      and_1733_s16_q <= (less_1699_s15_q & (and_633 & less_1716)) & and_1732_s15_q;
      select_1749_s16_q <= select_1749_s15_q;
      select_1775_s16_q <= select_1775_s15_q;
      and_1782_s16_q <= and_1782_s15_q;
      and_1783_s16_q <= and_1783_s15_q;
      equal_1784_s16_q <= equal_1784_s15_q;
      equal_1786_s16_q <= equal_1786_s15_q;
      equal_1789_s16_q <= equal_1789_s15_q;
      or_1790_s16_q <= or_1790_s15_q;
      and_1799_s16_q <= and_1799_s15_q;
      select_1814_s16_q <= select_1814_s15_q;
      select_1820_s16_q <= select_1820_s15_q;
      select_1859_s16_q <= select_1859_s15_q;
      less_1875_s16_q <= less_1875_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1888_s16_q <= or_1888_s15_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[1:0];
      sum_1901_s16_q <= sum_1901;
      smooth_s16_q <= smooth;
      and_1948_s16_q <= not_1785_s15_q & (not_1787_s15_q & and_1946_s15_q);
      and_1957_s16_q <= and_1957_s15_q;
      and_1962_s16_q <= not_1785_s15_q & (not_1787_s15_q & and_1960_s15_q);
      less_1963_s16_q <= less_1963_s15_q;
      equal_1964_s16_q <= equal_1964_s15_q;
      not_1965_s16_q <= not_1965_s15_q;
      equal_1966_s16_q <= equal_1966_s15_q;
      patches_rows_rdata_s16_q <= patches_rows_rdata_s15_q;
      or_1985_s16_q <= or_1985_s15_q;
      or_1988_s16_q <= or_1988_s15_q;
      or_1991_s16_q <= or_1991_s15_q;
      not_1993_s16_q <= not_1993;
      textured_s16_q <= textured_s15_q;
      and_2018_s16_q <= and_2018;
      and_2025_s16_q <= not_572_s15_q & and_2000_s15_q;
      seen_columns_rdata_s16_q <= seen_columns_rdata_s15_q;
      shown_s16_q <= shown;
      near_s16_q <= near;
      and_2066_s16_q <= and_2066_s15_q;
      and_2068_s16_q <= and_2068_s15_q;
      or_2083_s16_q <= or_2083_s15_q;
      or_2086_s16_q <= or_2086_s15_q;
      or_2089_s16_q <= or_2089_s15_q;
      and_2100_s16_q <= and_2100_s15_q;
      and_2102_s16_q <= seen_columns_rdata_s15_q[7] & inside_v_s15_q;
      and_2103_s16_q <= seen_columns_rdata_s15_q[3] & inside_v_s15_q;
      and_2116_s16_q <= and_2116_s15_q;
      and_2118_s16_q <= seen_columns_rdata_s15_q[8] & inside_v_s15_q;
      and_2119_s16_q <= seen_columns_rdata_s15_q[4] & inside_v_s15_q;
      and_2139_s16_q <= and_2139_s15_q;
      equal_2279_s16_q <= equal_2279_s15_q;
      equal_2468_s16_q <= equal_2468_s15_q;
      and_2599_s16_q <= and_2599;
      not_2618_s16_q <= not_2618;
      and_2619_s16_q <= and_2619_s15_q;
      and_2621_s16_q <= seen_columns_rdata_s15_q[6] & inside_v_s15_q;
      and_2622_s16_q <= seen_columns_rdata_s15_q[2] & inside_v_s15_q;
      and_2661_s16_q <= not_572_s15_q & and_2660;
      and_2668_s16_q <= not_572_s15_q & (so_s15_q & (ends_cell_s15_q & and_2665));
      and_2692_s16_q <= inside_v_s15_q & (or_576_s15_q & (not_580_s15_q & and_2689));
      select_2702_s16_q <= select_2702[1];
      select_2705_s16_q <= select_2705[1];
      and_2706_s16_q <= select_2702[0] & select_2705[0];
      and_2753_s16_q <= not_572_s15_q & (so_s15_q & (half_ends & equal_2750));
      and_2754_s16_q <= and_633 & less_1699_s15_q;
      residual_s16_q <= residual;
      equal_2816_s16_q <= sum_1610 == 2'h2;
      not_2817_s16_q <= ~select_1657;
      quarter_2_s16_q <= quarter_2;
      and_2992_s16_q <= and_2992_s15_q;
      less_3119_s16_q <= less_3119_s15_q;
      equal_3462_s16_q <= patches_match_row_s15_q == 4'h0;
      select_3550_s16_q <= select_3550_s15_q;
      select_3557_s16_q <= select_3557;
      select_3566_s16_q <= select_3566;
      and_3572_s16_q <= equal_3546_s15_q & ({sum_3570[6], sum_3570} < 8'hfb);
      select_3581_s16_q <= select_3581_s15_q;
      equal_3926_s16_q <= equal_3926_s15_q;
      equal_3946_s16_q <= equal_3946;
      equal_3949_s16_q <= x_s15_q[6:3] == 4'hb;
      equal_3950_s16_q <= equal_3950;
      equal_3951_s16_q <= equal_3951;
      select_3970_s16_q <= equal_3946 ? cfg_regions_limit_i : select_3969;
      equal_4091_s16_q <= equal_4091_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
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
  logic segment_started_q;
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_520_s16_q ? sum_528_s16_q[13:5] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_549_s16_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_520_s16_q ? sum_532_s16_q[13:5] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_549_s16_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:207
  logic and_557;
  assign and_557 = and_520_s16_q & and_536_s16_q;
  // hls/stages/census.hpp:127
  logic select_559;
  assign select_559 = equal_549_s16_q ? and_557 : (averager_mask_q & and_557);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s16_q & select_559;
  // hls/stages/census.hpp:207
  logic and_561;
  assign and_561 = and_520_s16_q & and_540_s16_q;
  // hls/stages/census.hpp:127
  logic select_563;
  assign select_563 = equal_549_s16_q ? and_561 : (averager_of_skin_q & and_561);
  // hls/stages/agreement.hpp:455
  logic equal_673;
  assign equal_673 = last_s16_q == 7'h0;
  logic [3:0] select_677;
  assign select_677 = equal_676_s16_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_678;
  assign select_678 = equal_673 ? {select_677, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_679;
  assign select_679 = equal_673 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:788
  logic and_1583;
  assign and_1583 = not_574_s16_q & and_1582_s16_q;
  // hls/stages/moments.hpp:73
  logic and_1590;
  assign and_1590 = moments_has_before_q & moments_memory_rdata_s16_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1594;
  assign and_1594 = not_584_s16_q & (and_1590 & (moments_memory_rdata_s16_q[1] ^ and_636_s16_q));
  // hls/stages/moments.hpp:73
  logic and_1599;
  assign and_1599 = moments_has_before_q & moments_memory_rdata_s16_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1603;
  assign and_1603 = not_584_s16_q & (and_1599 & (moments_memory_rdata_s16_q[3] ^ and_643_s16_q));
  // hls/stages/agreement.hpp:788
  logic and_1653;
  assign and_1653 = so_s16_q & and_1652_s16_q;
  logic and_1737;
  assign and_1737 = not_572_s16_q & (so_s16_q & (ends_cell_s16_q & (inside_v_s16_q & and_1733_s16_q)));
  logic [7:0] select_1743;
  assign select_1743 = so_s16_q ? (ends_cell_s16_q ? (inside_v_s16_q ? x_s16_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:471
  logic [13:0] sum_1902;
  assign sum_1902 = {{3{patches_down_values_1_s16_q[10]}}, patches_down_values_1_s16_q} + {sum_1901_s16_q, down_2_s16_q[1]};
  logic [12:0] sum_1903;
  assign sum_1903 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1902[13:1];
  // hls/stages/patches.hpp:470
  logic [12:0] sum_1921;
  assign sum_1921 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s16_q[11:1]};
  logic [12:0] sum_1922;
  assign sum_1922 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1923;
  assign difference_1923 = {1'b0, sum_1921, smooth_s16_q[0]} - {1'b0, sum_1922, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:262
  logic explained;
  assign explained = inside_v_s16_q & and_633_s16_q;
  logic and_2027;
  assign and_2027 = inside_v_s16_q & and_2018_s16_q;
  // hls/stages/agreement.hpp:1030
  logic and_2069;
  assign and_2069 = seen_columns_rdata_s16_q[0] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2071;
  assign sum_2071 = {1'b0, and_2068_s16_q} + ({1'b0, textured_s16_q} + {1'b0, and_2069});
  // hls/stages/agreement.hpp:1030
  logic and_2101;
  assign and_2101 = seen_columns_rdata_s16_q[11] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2105;
  assign sum_2105 = {1'b0, and_2102_s16_q} + ({1'b0, shown_s16_q} + {1'b0, and_2103_s16_q});
  // hls/stages/agreement.hpp:1030
  logic and_2117;
  assign and_2117 = seen_columns_rdata_s16_q[12] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2121;
  assign sum_2121 = {1'b0, and_2118_s16_q} + ({1'b0, near_s16_q} + {1'b0, and_2119_s16_q});
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2171;
  assign select_2171 = sample_pair_whole_s16_q ? (and_544_s16_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2173;
  assign select_2173 = sample_pair_whole_s16_q ? (and_544_s16_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2194;
  assign select_2194 = sample_pair_whole_s16_q ? (and_544_s16_q ? select_559 : averager_mask_q) : averager_mask_q;
  logic select_2196;
  assign select_2196 = sample_pair_whole_s16_q ? (and_544_s16_q ? select_563 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:1142
  logic equal_2294;
  assign equal_2294 = x_s16_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:788
  logic select_2300;
  assign select_2300 = equal_571_s16_q ? (moments_has_before_q | equal_2294) : moments_has_before_q;
  // hls/stages/agreement.hpp:520
  logic and_2593;
  assign and_2593 = and_546_s16_q & (equal_676_s16_q & equal_2468_s16_q);
  // hls/stages/agreement.hpp:788
  logic and_2604;
  assign and_2604 = not_572_s16_q & (so_s16_q & (ends_cell_s16_q & textured_s16_q));
  // hls/stages/agreement.hpp:1030
  logic and_2620;
  assign and_2620 = seen_columns_rdata_s16_q[10] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2624;
  assign sum_2624 = {1'b0, and_2621_s16_q} + ({1'b0, explained} + {1'b0, and_2622_s16_q});
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2663;
  assign select_2663 = and_2593 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2661_s16_q});
  logic [13:0] select_2670;
  assign select_2670 = and_2593 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2668_s16_q});
  // hls/stages/agreement.hpp:1027
  logic and_2707;
  assign and_2707 = and_633_s16_q & and_2706_s16_q;
  // hls/stages/agreement.hpp:788
  logic and_2710;
  assign and_2710 = ends_cell_s16_q & (inside_v_s16_q & (select_2702_s16_q & and_2707));
  logic and_2717;
  assign and_2717 = ends_cell_s16_q & (inside_v_s16_q & (select_2705_s16_q & and_2707));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2788;
  assign difference_2788 = 13'h0 - {residual_s16_q[11], residual_s16_q};
  logic less_2803;
  assign less_2803 = $signed(difference_2788) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2819;
  assign select_2819 = equal_2816_s16_q ? (registration_fresh_q & not_2817_s16_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2821;
  assign select_2821 = so_s16_q ? (and_1652_s16_q ? select_2819 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2823;
  assign select_2823 = and_2593 ? 4'hf : (equal_571_s16_q ? registration_fresh_q : select_2821);
  // hls/stages/registration.hpp:258
  logic not_2844;
  assign not_2844 = ~quarter_2_s16_q[1];
  logic [3:0] select_2845;
  assign select_2845 = quarter_2_s16_q[0] ? {quarter_2_s16_q[1], 1'b0, not_2844, 1'b0} : {1'b0, quarter_2_s16_q[1], 1'b0, not_2844};
  // hls/stages/patches.hpp:184
  logic [11:0] select_3085;
  assign select_3085 = equal_1786_s16_q ? patches_smooth_values_0_q : (or_1790_s16_q ? smooth_s16_q : patches_smooth_values_0_q);
  logic [11:0] select_3087;
  assign select_3087 = or_1790_s16_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3089;
  assign select_3089 = equal_1784_s16_q ? patches_smooth_values_1_q : (equal_1786_s16_q ? patches_smooth_values_1_q : select_3087);
  logic [11:0] select_3090;
  assign select_3090 = or_1790_s16_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3092;
  assign select_3092 = equal_1784_s16_q ? patches_smooth_values_2_q : (equal_1786_s16_q ? patches_smooth_values_2_q : select_3090);
  logic [11:0] select_3093;
  assign select_3093 = or_1790_s16_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3095;
  assign select_3095 = equal_1784_s16_q ? patches_smooth_values_3_q : (equal_1786_s16_q ? patches_smooth_values_3_q : select_3093);
  logic [10:0] select_3102;
  assign select_3102 = or_1790_s16_q ? patches_down_values_1_s16_q : patches_down_values_2_q;
  logic [10:0] select_3104;
  assign select_3104 = equal_1784_s16_q ? patches_down_values_2_q : (equal_1786_s16_q ? patches_down_values_2_q : select_3102);
  logic [10:0] select_3105;
  assign select_3105 = or_1790_s16_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3107;
  assign select_3107 = equal_1784_s16_q ? patches_down_values_3_q : (equal_1786_s16_q ? patches_down_values_3_q : select_3105);
  // hls/stages/patches.hpp:560
  logic select_3559;
  assign select_3559 = less_1963_s16_q ? (not_1965_s16_q & select_3557_s16_q) : select_3557_s16_q;
  logic select_3568;
  assign select_3568 = less_1963_s16_q ? (not_1965_s16_q & select_3566_s16_q) : select_3566_s16_q;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3574;
  assign select_3574 = less_1963_s16_q ? (and_3572_s16_q ? patches_rows_rdata_s16_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:541
  logic [9:0] select_3585;
  assign select_3585 = patches_read_above_q ? patches_read_row_differing_s16_q : patches_peak_above_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3587;
  assign select_3587 = patches_read_below_q ? patches_read_row_differing_s16_q : patches_peak_below_q;
  // hls/stages/patches.hpp:579
  logic less_3624;
  assign less_3624 = select_3585 < select_3587;
  // hls/stages/patches.hpp:580
  logic [9:0] high;
  assign high = less_3624 ? select_3587 : select_3585;
  logic [9:0] low;
  assign low = (select_3587 < select_3585) ? select_3587 : select_3585;
  // hls/stages/agreement.hpp:1223
  logic equal_3702;
  assign equal_3702 = x_s16_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1217
  logic equal_3948;
  assign equal_3948 = x_s16_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3971;
  assign select_3971 = equal_3949_s16_q ? {cfg_on_skin_limit_i, 3'h0} : select_3970_s16_q;
  logic [7:0] limit;
  assign limit = equal_3948 ? cfg_regions_limit_i : select_3971;
  // hls/stages/agreement.hpp:1231
  logic not_3973;
  assign not_3973 = ~x_s16_q[2];
  logic [3:0] select_3974;
  assign select_3974 = x_s16_q[1] ? {x_s16_q[2], 1'b0, not_3973, 1'b0} : {1'b0, x_s16_q[2], 1'b0, not_3973};
  logic [7:0] select_3975;
  assign select_3975 = x_s16_q[0] ? {select_3974[3], 1'b0, select_3974[2], 1'b0, select_3974[1], 1'b0, select_3974[0], 1'b0} : {1'b0, select_3974[3], 1'b0, select_3974[2], 1'b0, select_3974[1], 1'b0, select_3974[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3979;
  assign select_3979 = equal_3950_s16_q ? counts_skin_supervised_q : (equal_3951_s16_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3981;
  assign select_3981 = equal_3949_s16_q ? counts_skin_textured_q : (equal_3946_s16_q ? counts_textured_q : select_3979);
  logic [13:0] of;
  assign of = equal_3948 ? counts_textured_q : select_3981;
  // hls/stages/registration.hpp:258
  logic not_4184;
  assign not_4184 = ~quarter_s16_q[1];
  logic [3:0] select_4185;
  assign select_4185 = quarter_s16_q[0] ? {quarter_s16_q[1], 1'b0, not_4184, 1'b0} : {1'b0, quarter_s16_q[1], 1'b0, not_4184};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 16, written in stage 20: 16 < 20 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1611_s16_q;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s16_en & (equal_571_s16_q ? (x_s16_q[6] & select_1642_s16_q) : and_1653);
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_514_s16_q;
  logic averager_memory_we;
  assign averager_memory_we = s16_en & and_521_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_540_s16_q, and_536_s16_q, sum_532_s16_q, sum_528_s16_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s14_sim;
  logic averager_memory_re_s14_sim;
  logic [8:0] averager_memory_raddr_s15_sim;
  logic averager_memory_re_s15_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s14_sim <= 1'b0;
      averager_memory_re_s15_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s14_sim <= averager_memory_re;
      averager_memory_raddr_s14_sim <= averager_memory_raddr;
      averager_memory_re_s15_sim <= averager_memory_re_s14_sim;
      averager_memory_raddr_s15_sim <= averager_memory_raddr_s14_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s14_sim && averager_memory_raddr_s14_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s15_sim && averager_memory_raddr_s15_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1575_s16_q;
  logic shown_right_we;
  assign shown_right_we = s16_en & and_1586_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1583, not_574_s16_q};
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
  assign seen_columns_we = s16_en & and_1571_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s16_q, near_s16_q, shown_s16_q, explained, and_2027, textured_s16_q};
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
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
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
      patches_read_above_q <= 1'b0;
      patches_read_below_q <= 1'b0;
      patches_peak_above_q <= 10'h0;
      patches_peak_below_q <= 10'h0;
      segment_started_q <= 1'b0;
    end else if (s16_en) begin
      averager_mask_q <= select_2194;
      averager_of_skin_q <= select_2196;
      census_filled_q <= and_546_s16_q ? {select_679[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2300;
      rows_passed_above_q <= and_546_s16_q ? select_678 : rows_passed_above_q;
      counts_textured_q <= and_2593 ? 14'h0 : (counts_textured_q + {13'h0, and_2604});
      counts_skin_supervised_q <= select_2663;
      counts_skin_textured_q <= select_2670;
      registration_fresh_q <= select_2823;
      patches_smooth_values_0_q <= equal_1784_s16_q ? patches_smooth_values_0_q : select_3085;
      patches_smooth_values_1_q <= select_3089;
      patches_smooth_values_2_q <= select_3092;
      patches_smooth_values_3_q <= select_3095;
      patches_down_values_2_q <= select_3104;
      patches_down_values_3_q <= select_3107;
      patches_read_above_q <= equal_1784_s16_q ? select_3559 : patches_read_above_q;
      patches_read_below_q <= equal_1784_s16_q ? select_3568 : patches_read_below_q;
      patches_peak_above_q <= equal_1784_s16_q ? select_3585 : patches_peak_above_q;
      patches_peak_below_q <= equal_1784_s16_q ? select_3587 : patches_peak_below_q;
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
    if (s16_en) begin
      averager_total_0_q <= select_2171;
      averager_total_1_q <= select_2173;
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
  logic moments_starts_s17_q;
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
  logic segment_started_s17_q;
  logic centres_values_1_textured_s17_q;
  logic centres_values_1_of_skin_s17_q;
  logic [3:0] select_507_s17_q;
  logic [6:0] select_510_s17_q;
  logic [6:0] last_s17_q;
  logic and_544_s17_q;
  logic and_546_s17_q;
  logic [77:0] census_memory_rdata_s17_q;
  logic [8:0] grey_s17_q;
  logic equal_549_s17_q;
  logic [8:0] select_552_s17_q;
  logic [8:0] grey_2_s17_q;
  logic [8:0] select_556_s17_q;
  logic whole_2_s17_q;
  logic and_564_s17_q;
  logic equal_566_s17_q;
  logic equal_571_s17_q;
  logic not_572_s17_q;
  logic so_s17_q;
  logic not_574_s17_q;
  logic equal_575_s17_q;
  logic inside_v_s17_q;
  logic [6:0] x_s17_2_q;
  logic [6:0] right_s17_q;
  logic and_680_s17_q;
  logic [5:0] select_1514_s17_q;
  logic [2:0] select_1519_s17_q;
  logic [7:0] select_1520_s17_q;
  logic [7:0] select_1528_s17_q;
  logic [7:0] select_1531_s17_q;
  logic [6:0] select_1549_s17_q;
  logic [5:0] select_1551_s17_q;
  logic [7:0] select_1554_s17_q;
  logic [7:0] select_1557_s17_q;
  logic and_1558_s17_q;
  logic [7:0] select_1563_s17_q;
  logic [6:0] select_1564_s17_q;
  logic [6:0] select_1567_s17_q;
  logic [6:0] select_1568_s17_q;
  logic and_1591_s17_q;
  logic and_1594_s17_q;
  logic and_1597_s17_q;
  logic and_1600_s17_q;
  logic and_1603_s17_q;
  logic equal_1604_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1610_s17_q;
  logic equal_1612_s17_q;
  logic equal_1614_s17_q;
  logic equal_1616_s17_q;
  logic equal_1618_s17_q;
  logic equal_1620_s17_q;
  logic equal_1622_s17_q;
  logic equal_1624_s17_q;
  logic equal_1626_s17_q;
  logic less_1635_s17_q;
  logic or_1639_s17_q;
  logic equal_1659_s17_q;
  logic and_1669_s17_q;
  logic and_1672_s17_q;
  logic select_1689_s17_q;
  logic equal_1690_s17_q;
  logic [22:0] patches_choices_rdata_s17_q;
  logic and_1698_s17_q;
  logic equal_1700_s17_q;
  logic and_1737_s17_q;
  logic [7:0] select_1744_s17_q;
  logic [5:0] select_1749_s17_q;
  logic [7:0] select_1775_s17_q;
  logic and_1782_s17_q;
  logic and_1783_s17_q;
  logic equal_1784_s17_q;
  logic equal_1786_s17_q;
  logic equal_1789_s17_q;
  logic or_1790_s17_q;
  logic and_1799_s17_q;
  logic [4:0] select_1814_s17_q;
  logic select_1820_s17_q;
  logic [3:0] select_1859_s17_q;
  logic less_1875_s17_q;
  logic new_row_s17_q;
  logic or_1888_s17_q;
  logic [27:0] patches_right_codes_rdata_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic down_2_s17_q;
  logic sum_1902_s17_q;
  logic [12:0] sum_1903_s17_q;
  logic [14:0] difference_1923_s17_q;
  logic and_1948_s17_q;
  logic [47:0] patches_left_codes_rdata_s17_q;
  logic and_1957_s17_q;
  logic and_1962_s17_q;
  logic less_1963_s17_q;
  logic equal_1964_s17_q;
  logic not_1965_s17_q;
  logic equal_1966_s17_q;
  logic or_1985_s17_q;
  logic or_1988_s17_q;
  logic or_1991_s17_q;
  logic not_1993_s17_q;
  logic [29:0] regions_rdata_s17_q;
  logic textured_s17_q;
  logic explained_s17_q;
  logic and_2020_s17_q;
  logic and_2025_s17_q;
  logic and_2066_s17_q;
  logic and_2067_s17_q;
  logic [1:0] sum_2071_s17_q;
  logic or_2083_s17_q;
  logic or_2086_s17_q;
  logic or_2089_s17_q;
  logic and_2100_s17_q;
  logic [2:0] sum_2106_s17_q;
  logic and_2116_s17_q;
  logic [2:0] sum_2122_s17_q;
  logic and_2139_s17_q;
  logic equal_2279_s17_q;
  logic equal_2294_s17_q;
  logic equal_2468_s17_q;
  logic and_2593_s17_q;
  logic and_2599_s17_q;
  logic and_2604_s17_q;
  logic not_2618_s17_q;
  logic and_2619_s17_q;
  logic [2:0] sum_2625_s17_q;
  logic and_2695_s17_q;
  logic and_2712_s17_q;
  logic and_2719_s17_q;
  logic and_2753_s17_q;
  logic and_2754_s17_q;
  logic [7:0] residual_s17_q;
  logic less_2789_s17_q;
  logic less_2803_s17_q;
  logic equal_2847_s17_q;
  logic and_2992_s17_q;
  logic less_3119_s17_q;
  logic equal_3462_s17_q;
  logic [4:0] select_3550_s17_q;
  logic [9:0] select_3574_s17_q;
  logic [14:0] select_3581_s17_q;
  logic less_3624_s17_q;
  logic [9:0] high_s17_q;
  logic [9:0] low_s17_q;
  logic equal_3702_s17_q;
  logic and_3927_s17_q;
  logic equal_3946_s17_q;
  logic equal_3948_s17_q;
  logic equal_3949_s17_q;
  logic equal_3950_s17_q;
  logic equal_3951_s17_q;
  logic equal_3977_s17_q;
  logic [13:0] of_s17_q;
  logic equal_4091_s17_q;
  logic equal_4187_s17_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s17_q <= pixel_0_s16_q;
      pixel_1_s17_q <= pixel_1_s16_q;
      saturated_s17_q <= saturated_s16_q;
      mask_s17_q <= sample_of_skin_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      sample_pair_pixel_0_s17_q <= sample_pair_pixel_0_s16_q;
      sample_pair_pixel_1_s17_q <= sample_pair_pixel_1_s16_q;
      sample_pair_whole_s17_q <= sample_pair_whole_s16_q;
      sample_present_s17_q <= sample_present_s16_q;
      moments_starts_s17_q <= moments_starts_s16_q;
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
      segment_started_s17_q <= segment_started_q;
      centres_values_1_textured_s17_q <= centres_values_1_textured_s16_q;
      centres_values_1_of_skin_s17_q <= centres_values_1_of_skin_s16_q;
      select_507_s17_q <= select_507_s16_q;
      select_510_s17_q <= select_510_s16_q;
      last_s17_q <= last_s16_q;
      and_544_s17_q <= and_544_s16_q;
      and_546_s17_q <= and_546_s16_q;
      census_memory_rdata_s17_q <= census_memory_rdata_q;
      grey_s17_q <= grey;
      equal_549_s17_q <= equal_549_s16_q;
      select_552_s17_q <= sample_pair_whole_s16_q ? total[10:2] : 9'h0;
      grey_2_s17_q <= grey_2;
      select_556_s17_q <= sample_pair_whole_s16_q ? total_2[10:2] : 9'h0;
      whole_2_s17_q <= whole_2;
      and_564_s17_q <= sample_pair_whole_s16_q & select_563;
      equal_566_s17_q <= equal_566_s16_q;
      equal_571_s17_q <= equal_571_s16_q;
      not_572_s17_q <= not_572_s16_q;
      so_s17_q <= so_s16_q;
      not_574_s17_q <= not_574_s16_q;
      equal_575_s17_q <= equal_575_s16_q;
      inside_v_s17_q <= inside_v_s16_q;
      x_s17_2_q <= x_s16_2_q;
      right_s17_q <= right_s16_q;
      and_680_s17_q <= select_678[4] & select_679[3];
      select_1514_s17_q <= or_1513_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1519_s17_q <= or_1513_s16_q ? select_1518_s16_q : best_left_rdata_s16_q[8:6];
      select_1520_s17_q <= or_1513_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1528_s17_q <= or_1513_s16_q ? select_1527_s16_q : best_left_rdata_s16_q[24:17];
      select_1531_s17_q <= or_1513_s16_q ? select_1530_s16_q : best_left_rdata_s16_q[32:25];
      select_1549_s17_q <= select_1549_s16_q;
      select_1551_s17_q <= select_1551_s16_q;
      select_1554_s17_q <= select_1554_s16_q;
      select_1557_s17_q <= select_1557_s16_q;
      and_1558_s17_q <= and_1558_s16_q;
      select_1563_s17_q <= or_1562_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1564_s17_q <= or_1562_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1567_s17_q <= select_1567_s16_q;
      select_1568_s17_q <= select_1568_s16_q;
      and_1591_s17_q <= not_584_s16_q & and_1590;
      and_1594_s17_q <= and_1594;
      and_1597_s17_q <= and_1597_s16_q;
      and_1600_s17_q <= not_584_s16_q & and_1599;
      and_1603_s17_q <= and_1603;
      equal_1604_s17_q <= equal_1604_s16_q;
      all_s17_q <= all_s16_q;
      sum_1610_s17_q <= sum_1610_s16_q;
      equal_1612_s17_q <= equal_1612_s16_q;
      equal_1614_s17_q <= equal_1614_s16_q;
      equal_1616_s17_q <= equal_1616_s16_q;
      equal_1618_s17_q <= equal_1618_s16_q;
      equal_1620_s17_q <= equal_1620_s16_q;
      equal_1622_s17_q <= equal_1622_s16_q;
      equal_1624_s17_q <= equal_1624_s16_q;
      equal_1626_s17_q <= equal_1626_s16_q;
      less_1635_s17_q <= less_1635_s16_q;
      or_1639_s17_q <= or_1639_s16_q;
      equal_1659_s17_q <= (registration_fresh_q & select_1657_s16_q) == 4'h0;
      and_1669_s17_q <= not_572_s16_q & and_1653;
      and_1672_s17_q <= and_1672_s16_q;
      select_1689_s17_q <= select_1689_s16_q;
      equal_1690_s17_q <= equal_1690_s16_q;
      patches_choices_rdata_s17_q <= patches_choices_rdata_q;
      and_1698_s17_q <= and_1698_s16_q;
      equal_1700_s17_q <= equal_1700_s16_q;
      and_1737_s17_q <= and_1737;
      select_1744_s17_q <= equal_571_s16_q ? 8'h0 : select_1743;
      select_1749_s17_q <= select_1749_s16_q;
      select_1775_s17_q <= select_1775_s16_q;
      and_1782_s17_q <= and_1782_s16_q;
      and_1783_s17_q <= and_1783_s16_q;
      equal_1784_s17_q <= equal_1784_s16_q;
      equal_1786_s17_q <= equal_1786_s16_q;
      equal_1789_s17_q <= equal_1789_s16_q;
      or_1790_s17_q <= or_1790_s16_q;
      and_1799_s17_q <= and_1799_s16_q;
      select_1814_s17_q <= select_1814_s16_q;
      select_1820_s17_q <= select_1820_s16_q;
      select_1859_s17_q <= select_1859_s16_q;
      less_1875_s17_q <= less_1875_s16_q;
      new_row_s17_q <= new_row_s16_q;
      or_1888_s17_q <= or_1888_s16_q;
      patches_right_codes_rdata_s17_q <= patches_right_codes_rdata_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      down_2_s17_q <= down_2_s16_q[0];
      sum_1902_s17_q <= sum_1902[0];
      sum_1903_s17_q <= sum_1903;
      difference_1923_s17_q <= difference_1923;
      and_1948_s17_q <= and_1948_s16_q;
      patches_left_codes_rdata_s17_q <= patches_left_codes_rdata_q;
      and_1957_s17_q <= and_1957_s16_q;
      and_1962_s17_q <= and_1962_s16_q;
      less_1963_s17_q <= less_1963_s16_q;
      equal_1964_s17_q <= equal_1964_s16_q;
      not_1965_s17_q <= not_1965_s16_q;
      equal_1966_s17_q <= equal_1966_s16_q;
      or_1985_s17_q <= or_1985_s16_q;
      or_1988_s17_q <= or_1988_s16_q;
      or_1991_s17_q <= or_1991_s16_q;
      not_1993_s17_q <= not_1993_s16_q;
      regions_rdata_s17_q <= regions_rdata_q;
      textured_s17_q <= textured_s16_q;
      explained_s17_q <= explained;
      and_2020_s17_q <= inside_v_s16_q & (and_2018_s16_q & and_1582_s16_q);
      and_2025_s17_q <= and_2025_s16_q;
      and_2066_s17_q <= and_2066_s16_q;
      and_2067_s17_q <= seen_columns_rdata_s16_q[9] & inside_v_s16_q;
      sum_2071_s17_q <= sum_2071;
      or_2083_s17_q <= or_2083_s16_q;
      or_2086_s17_q <= or_2086_s16_q;
      or_2089_s17_q <= or_2089_s16_q;
      and_2100_s17_q <= and_2100_s16_q;
      sum_2106_s17_q <= {2'h0, and_2101} + {1'b0, sum_2105};
      and_2116_s17_q <= and_2116_s16_q;
      sum_2122_s17_q <= {2'h0, and_2117} + {1'b0, sum_2121};
      and_2139_s17_q <= and_2139_s16_q;
      equal_2279_s17_q <= equal_2279_s16_q;
      equal_2294_s17_q <= equal_2294;
      equal_2468_s17_q <= equal_2468_s16_q;
      and_2593_s17_q <= and_2593;
      and_2599_s17_q <= and_2599_s16_q;
      and_2604_s17_q <= and_2604;
      not_2618_s17_q <= not_2618_s16_q;
      and_2619_s17_q <= and_2619_s16_q;
      sum_2625_s17_q <= {2'h0, and_2620} + {1'b0, sum_2624};
      and_2695_s17_q <= not_572_s16_q & (so_s16_q & (ends_cell_s16_q & and_2692_s16_q));
      and_2712_s17_q <= not_572_s16_q & (so_s16_q & and_2710);
      and_2719_s17_q <= not_572_s16_q & (so_s16_q & and_2717);
      and_2753_s17_q <= and_2753_s16_q;
      and_2754_s17_q <= and_2754_s16_q;
      residual_s17_q <= residual_s16_q[7:0];
      less_2789_s17_q <= $signed(difference_2788) < $signed({7'h0, cfg_moved_limit_i});
      less_2803_s17_q <= less_2803;
      equal_2847_s17_q <= (registration_fresh_q & select_2845) == 4'h0;
      and_2992_s17_q <= and_2992_s16_q;
      less_3119_s17_q <= less_3119_s16_q;
      equal_3462_s17_q <= equal_3462_s16_q;
      select_3550_s17_q <= select_3550_s16_q;
      select_3574_s17_q <= select_3574;
      select_3581_s17_q <= select_3581_s16_q;
      less_3624_s17_q <= less_3624;
      high_s17_q <= high;
      low_s17_q <= low;
      equal_3702_s17_q <= equal_3702;
      and_3927_s17_q <= equal_3926_s16_q & equal_3702;
      equal_3946_s17_q <= equal_3946_s16_q;
      equal_3948_s17_q <= equal_3948;
      equal_3949_s17_q <= equal_3949_s16_q;
      equal_3950_s17_q <= equal_3950_s16_q;
      equal_3951_s17_q <= equal_3951_s16_q;
      equal_3977_s17_q <= (limit & select_3975) == 8'h0;
      of_s17_q <= of;
      equal_4091_s17_q <= equal_4091_s16_q;
      equal_4187_s17_q <= (registration_fresh_q & select_4185) == 4'h0;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:296
  logic less_649;
  assign less_649 = census_memory_rdata_s17_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_650;
  assign less_650 = census_memory_rdata_s17_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_661;
  assign less_661 = census_memory_rdata_s17_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_662;
  assign less_662 = census_memory_rdata_s17_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:288
  logic and_682;
  assign and_682 = census_memory_rdata_s17_q[38] & (census_memory_rdata_s17_q[18] & whole_2_s17_q);
  logic and_684;
  assign and_684 = census_memory_rdata_s17_q[77] & (census_memory_rdata_s17_q[58] & and_682);
  // hls/stages/census.hpp:272
  logic [9:0] difference_707;
  assign difference_707 = {1'b0, select_552_s17_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_710;
  assign difference_710 = {1'b0, census_memory_rdata_s17_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_714;
  assign difference_714 = {1'b0, census_memory_rdata_s17_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_718;
  assign difference_718 = {1'b0, census_memory_rdata_s17_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_722;
  assign difference_722 = {1'b0, census_memory_rdata_s17_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/patches.hpp:156
  logic and_1739;
  assign and_1739 = and_1737_s17_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_1740;
  assign select_1740 = and_1739 ? and_1737_s17_q : patches_choice_valid_q;
  logic [7:0] select_1745;
  assign select_1745 = and_1739 ? select_1744_s17_q : patches_choice_column_q;
  logic [5:0] select_1750;
  assign select_1750 = and_1739 ? select_1749_s17_q : patches_choice_shift_q;
  logic [7:0] select_1776;
  assign select_1776 = and_1739 ? select_1775_s17_q : patches_choice_slope_q;
  // hls/stages/patches.hpp:353
  logic [22:0] select_1800;
  assign select_1800 = and_1799_s17_q ? {select_1776, select_1750, select_1745, select_1740} : patches_choices_rdata_s17_q;
  // hls/stages/patches.hpp:471
  logic [14:0] sum_1904;
  assign sum_1904 = {{4{patches_down_values_3_s17_q[10]}}, patches_down_values_3_s17_q} + {sum_1903_s17_q, sum_1902_s17_q, down_2_s17_q};
  // hls/stages/patches.hpp:450
  logic and_1927;
  assign and_1927 = difference_1923_s17_q[8] & (~(difference_1923_s17_q[7:0] == 8'h0));
  // hls/stages/patches.hpp:453
  logic and_1931;
  assign and_1931 = (~difference_1923_s17_q[14]) & (and_1927 | (~(difference_1923_s17_q[13:9] == 5'h0)));
  // hls/stages/patches.hpp:449
  logic and_1934;
  assign and_1934 = difference_1923_s17_q[14] & (~(difference_1923_s17_q[13:8] == 6'h3f));
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2006;
  assign select_2006 = segment_started_s17_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2007;
  assign sum_2007 = {6'h0, textured_s17_q} + select_2006;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2009;
  assign sum_2009 = {3'h0, sum_2007} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2011;
  assign select_2011 = segment_started_s17_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2012;
  assign sum_2012 = {6'h0, explained_s17_q} + select_2011;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2014;
  assign sum_2014 = {3'h0, sum_2012} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2021;
  assign select_2021 = segment_started_s17_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2022;
  assign sum_2022 = {6'h0, and_2020_s17_q} + select_2021;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2024;
  assign sum_2024 = {3'h0, sum_2022} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[29:20]);
  // hls/stages/agreement.hpp:1275
  logic or_2034;
  assign or_2034 = marks_first_s17_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [12:0] select_2036;
  assign select_2036 = marks_first_s17_q ? 13'h1 : (or_2034 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2038;
  assign select_2038 = or_2034 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2040;
  assign select_2040 = cfg_compete_i ? (or_2034 & select_2036[12]) : (select_2038[8] & select_2036[9]);
  // hls/stages/agreement.hpp:1087
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2066_s17_q} + ({2'h0, and_2067_s17_q} + {1'b0, sum_2071_s17_q});
  // hls/stages/agreement.hpp:1089
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2100_s17_q} + sum_2106_s17_q;
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2108;
  assign select_2108 = age_s17_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1090
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2116_s17_q} + sum_2122_s17_q;
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2124;
  assign select_2124 = age_s17_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2163;
  assign select_2163 = sample_pair_whole_s17_q ? (and_544_s17_q ? grey_s17_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2165;
  assign select_2165 = sample_pair_whole_s17_q ? (and_544_s17_q ? grey_2_s17_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2167;
  assign select_2167 = sample_pair_whole_s17_q ? (and_544_s17_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2169;
  assign select_2169 = sample_pair_whole_s17_q ? (and_544_s17_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2174;
  assign sum_2174 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s17_q};
  logic [9:0] sum_2182;
  assign sum_2182 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s17_q};
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2197;
  assign select_2197 = and_546_s17_q ? select_552_s17_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2198;
  assign select_2198 = and_546_s17_q ? select_556_s17_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2200;
  assign select_2200 = and_546_s17_q ? census_memory_rdata_s17_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2201;
  assign select_2201 = and_546_s17_q ? census_memory_rdata_s17_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2202;
  assign select_2202 = and_546_s17_q ? census_memory_rdata_s17_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2203;
  assign select_2203 = and_546_s17_q ? census_memory_rdata_s17_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2204;
  assign select_2204 = and_546_s17_q ? census_memory_rdata_s17_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2205;
  assign select_2205 = and_546_s17_q ? census_memory_rdata_s17_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2206;
  assign select_2206 = and_546_s17_q ? census_memory_rdata_s17_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2207;
  assign select_2207 = and_546_s17_q ? census_memory_rdata_s17_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2208;
  assign select_2208 = and_546_s17_q ? census_memory_rdata_s17_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2209;
  assign select_2209 = and_546_s17_q ? census_memory_rdata_s17_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2210;
  assign select_2210 = and_546_s17_q ? census_memory_rdata_s17_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2211;
  assign select_2211 = and_546_s17_q ? census_memory_rdata_s17_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2212;
  assign select_2212 = and_546_s17_q ? census_memory_rdata_s17_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2213;
  assign select_2213 = and_546_s17_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2214;
  assign select_2214 = and_546_s17_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2216;
  assign select_2216 = and_546_s17_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2217;
  assign select_2217 = and_546_s17_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2219;
  assign select_2219 = and_546_s17_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2220;
  assign select_2220 = and_546_s17_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2222;
  assign select_2222 = and_546_s17_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2223;
  assign select_2223 = and_546_s17_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2224;
  assign select_2224 = and_546_s17_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2226;
  assign select_2226 = and_546_s17_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2227;
  assign select_2227 = and_546_s17_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2229;
  assign select_2229 = and_546_s17_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2230;
  assign select_2230 = and_546_s17_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2232;
  assign select_2232 = and_546_s17_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2233;
  assign select_2233 = and_546_s17_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2235;
  assign select_2235 = and_546_s17_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2236;
  assign select_2236 = and_546_s17_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2238;
  assign select_2238 = and_546_s17_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2239;
  assign select_2239 = and_546_s17_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2241;
  assign select_2241 = and_546_s17_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2242;
  assign select_2242 = and_546_s17_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2245;
  assign select_2245 = and_546_s17_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2246;
  assign select_2246 = and_546_s17_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2249;
  assign select_2249 = and_546_s17_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2250;
  assign select_2250 = and_546_s17_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2254;
  assign difference_2254 = {1'b0, select_556_s17_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2257;
  assign difference_2257 = {1'b0, census_memory_rdata_s17_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2261;
  assign difference_2261 = {1'b0, census_memory_rdata_s17_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2265;
  assign difference_2265 = {1'b0, census_memory_rdata_s17_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2269;
  assign difference_2269 = {1'b0, census_memory_rdata_s17_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2291;
  assign sum_2291 = {13'h0, moments_turns_0_q} + (moments_starts_s17_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2293;
  assign sum_2293 = {13'h0, moments_turns_1_q} + (moments_starts_s17_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:788
  logic and_2334;
  assign and_2334 = not_574_s17_q & (equal_575_s17_q & (inside_v_s17_q & and_1594_s17_q));
  logic and_2338;
  assign and_2338 = not_574_s17_q & (equal_575_s17_q & (inside_v_s17_q & and_1603_s17_q));
  // hls/stages/census.hpp:359
  logic [9:0] difference_2365;
  assign difference_2365 = {1'b0, select_552_s17_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2377;
  assign difference_2377 = {1'b0, select_556_s17_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:788
  logic and_2609;
  assign and_2609 = not_572_s17_q & (so_s17_q & (ends_cell_s17_q & explained_s17_q));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2611;
  assign select_2611 = and_2593_s17_q ? 14'h0 : (counts_explained_q + {13'h0, and_2609});
  // hls/stages/agreement.hpp:788
  logic and_2614;
  assign and_2614 = not_572_s17_q & (so_s17_q & (ends_cell_s17_q & and_2020_s17_q));
  // hls/stages/agreement.hpp:1088
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2619_s17_q} + sum_2625_s17_q;
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2627;
  assign select_2627 = age_s17_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1132
  logic less_2643;
  assign less_2643 = region_row_s17_q < x_s17_q[5:3];
  // hls/stages/patches.hpp:345
  logic not_2982;
  assign not_2982 = ~and_1782_s17_q;
  // hls/stages/patches.hpp:505
  logic [27:0] word;
  assign word = or_1888_s17_q ? patches_right_codes_rdata_s17_q : 28'h0;
  // hls/stages/patches.hpp:522
  logic [47:0] select_3152;
  assign select_3152 = new_row_s17_q ? patches_left_codes_rdata_s17_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3154;
  assign select_3154 = equal_1784_s17_q ? patches_left_row_q : (equal_1786_s17_q ? select_3152 : patches_left_row_q);
  logic [4:0] select_3499;
  assign select_3499 = equal_1786_s17_q ? patches_along_s17_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3576;
  assign select_3576 = less_1963_s17_q ? (equal_1966_s17_q ? 10'h3ff : select_3574_s17_q) : 10'h3ff;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3577;
  assign select_3577 = equal_1966_s17_q ? select_3576 : select_3574_s17_q;
  logic [9:0] select_3579;
  assign select_3579 = less_1963_s17_q ? (equal_1964_s17_q ? 10'h3ff : select_3577) : select_3577;
  // hls/stages/patches.hpp:581
  logic [9:0] eight;
  assign eight = high_s17_q - low_s17_q;
  logic [9:0] fall_2;
  assign fall_2 = high_s17_q - select_3581_s17_q[9:0];
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3964;
  assign select_3964 = equal_3702_s17_q ? 14'h0 : product_q;
  logic [13:0] select_3983;
  assign select_3983 = equal_3977_s17_q ? 14'h0 : of_s17_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3964} + {1'b0, select_3983};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4025;
  assign select_4025 = so_s17_q ? (ends_cell_s17_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4027;
  assign select_4027 = ends_cell_s17_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4029;
  assign select_4029 = equal_571_s17_q ? box_explained_columns_values_1_q : (so_s17_q ? select_4027 : box_explained_columns_values_1_q);
  logic [2:0] select_4030;
  assign select_4030 = ends_cell_s17_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4032;
  assign select_4032 = equal_571_s17_q ? box_explained_columns_values_2_q : (so_s17_q ? select_4030 : box_explained_columns_values_2_q);
  logic [2:0] select_4033;
  assign select_4033 = ends_cell_s17_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4035;
  assign select_4035 = equal_571_s17_q ? box_explained_columns_values_3_q : (so_s17_q ? select_4033 : box_explained_columns_values_3_q);
  logic [2:0] select_4036;
  assign select_4036 = ends_cell_s17_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4038;
  assign select_4038 = equal_571_s17_q ? box_explained_columns_values_4_q : (so_s17_q ? select_4036 : box_explained_columns_values_4_q);
  logic [2:0] select_4043;
  assign select_4043 = so_s17_q ? (ends_cell_s17_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4045;
  assign select_4045 = ends_cell_s17_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4047;
  assign select_4047 = equal_571_s17_q ? box_shown_columns_values_1_q : (so_s17_q ? select_4045 : box_shown_columns_values_1_q);
  logic [2:0] select_4048;
  assign select_4048 = ends_cell_s17_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4050;
  assign select_4050 = equal_571_s17_q ? box_shown_columns_values_2_q : (so_s17_q ? select_4048 : box_shown_columns_values_2_q);
  logic [2:0] select_4051;
  assign select_4051 = ends_cell_s17_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4053;
  assign select_4053 = equal_571_s17_q ? box_shown_columns_values_3_q : (so_s17_q ? select_4051 : box_shown_columns_values_3_q);
  logic [2:0] select_4054;
  assign select_4054 = ends_cell_s17_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4056;
  assign select_4056 = equal_571_s17_q ? box_shown_columns_values_4_q : (so_s17_q ? select_4054 : box_shown_columns_values_4_q);
  logic [2:0] select_4061;
  assign select_4061 = so_s17_q ? (ends_cell_s17_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4063;
  assign select_4063 = ends_cell_s17_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4065;
  assign select_4065 = equal_571_s17_q ? box_nearer_columns_values_1_q : (so_s17_q ? select_4063 : box_nearer_columns_values_1_q);
  logic [2:0] select_4066;
  assign select_4066 = ends_cell_s17_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4068;
  assign select_4068 = equal_571_s17_q ? box_nearer_columns_values_2_q : (so_s17_q ? select_4066 : box_nearer_columns_values_2_q);
  logic [2:0] select_4069;
  assign select_4069 = ends_cell_s17_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4071;
  assign select_4071 = equal_571_s17_q ? box_nearer_columns_values_3_q : (so_s17_q ? select_4069 : box_nearer_columns_values_3_q);
  logic [2:0] select_4072;
  assign select_4072 = ends_cell_s17_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4074;
  assign select_4074 = equal_571_s17_q ? box_nearer_columns_values_4_q : (so_s17_q ? select_4072 : box_nearer_columns_values_4_q);

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = last_s17_q;
  logic census_memory_we;
  assign census_memory_we = s17_en & and_546_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s17_q[58:40], census_memory_rdata_s17_q[38:0], and_564_s17_q, whole_2_s17_q, select_556_s17_q, select_552_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s16_sim;
  logic census_memory_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s16_sim <= census_memory_re;
      census_memory_raddr_s16_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s16_sim && census_memory_raddr_s16_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1558_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1557_s17_q, select_1554_s17_q, select_1551_s17_q, select_1549_s17_q, select_1531_s17_q, select_1528_s17_q, select_1520_s17_q, select_1519_s17_q, select_1514_s17_q};
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
  assign best_right_we = s17_en & and_1558_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1568_s17_q, select_1567_s17_q, select_1564_s17_q, select_1563_s17_q};
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

  // Memory left_turns, write
  logic [6:0] left_turns_waddr;
  assign left_turns_waddr = x_s17_q[6:0];
  logic left_turns_we;
  assign left_turns_we = s17_en & and_1597_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1594_s17_q, and_1591_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] left_turns_raddr_s14_sim;
  logic left_turns_re_s14_sim;
  logic [6:0] left_turns_raddr_s15_sim;
  logic left_turns_re_s15_sim;
  logic [6:0] left_turns_raddr_s16_sim;
  logic left_turns_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_turns_re_s14_sim <= 1'b0;
      left_turns_re_s15_sim <= 1'b0;
      left_turns_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      left_turns_re_s14_sim <= left_turns_re;
      left_turns_raddr_s14_sim <= left_turns_raddr;
      left_turns_re_s15_sim <= left_turns_re_s14_sim;
      left_turns_raddr_s15_sim <= left_turns_raddr_s14_sim;
      left_turns_re_s16_sim <= left_turns_re_s15_sim;
      left_turns_raddr_s16_sim <= left_turns_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_turns_we) begin
      if (left_turns_re && left_turns_raddr == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s14_sim && left_turns_raddr_s14_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s15_sim && left_turns_raddr_s15_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s16_sim && left_turns_raddr_s16_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_waddr >= 7'd120) $error("left_turns: write outside, address %0d", left_turns_waddr);
    end
    if (rst_ni && left_turns_re && left_turns_raddr >= 7'd120) $error("left_turns: read outside, address %0d", left_turns_raddr);
  end
`endif

  // Memory right_turns, write
  logic [6:0] right_turns_waddr;
  assign right_turns_waddr = x_s17_q[6:0];
  logic right_turns_we;
  assign right_turns_we = s17_en & and_1597_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1603_s17_q, and_1600_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] right_turns_raddr_s14_sim;
  logic right_turns_re_s14_sim;
  logic [6:0] right_turns_raddr_s15_sim;
  logic right_turns_re_s15_sim;
  logic [6:0] right_turns_raddr_s16_sim;
  logic right_turns_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_turns_re_s14_sim <= 1'b0;
      right_turns_re_s15_sim <= 1'b0;
      right_turns_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      right_turns_re_s14_sim <= right_turns_re;
      right_turns_raddr_s14_sim <= right_turns_raddr;
      right_turns_re_s15_sim <= right_turns_re_s14_sim;
      right_turns_raddr_s15_sim <= right_turns_raddr_s14_sim;
      right_turns_re_s16_sim <= right_turns_re_s15_sim;
      right_turns_raddr_s16_sim <= right_turns_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_turns_we) begin
      if (right_turns_re && right_turns_raddr == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s14_sim && right_turns_raddr_s14_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s15_sim && right_turns_raddr_s15_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s16_sim && right_turns_raddr_s16_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_waddr >= 7'd120) $error("right_turns: write outside, address %0d", right_turns_waddr);
    end
    if (rst_ni && right_turns_re && right_turns_raddr >= 7'd120) $error("right_turns: read outside, address %0d", right_turns_raddr);
  end
`endif

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s17_q, and_1698_s17_q};
  logic patches_choices_we;
  assign patches_choices_we = s17_en & and_1783_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {select_1776, select_1750, select_1745, select_1740};
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
      patches_read_far_q <= 10'h3ff;
      segment_textured_q <= 7'h0;
      segment_explained_q <= 7'h0;
      segment_nearer_q <= 7'h0;
      product_q <= 14'h0;
      rows_passed_q <= 13'h0;
      columns_passed_q <= 9'h0;
      line_ended_q <= 1'b1;
    end else if (s17_en) begin
      moments_turned_0_q <= sum_2291;
      moments_turned_1_q <= sum_2293;
      moments_turns_0_q <= not_572_s17_q & and_2334;
      moments_turns_1_q <= not_572_s17_q & and_2338;
      counts_explained_q <= select_2611;
      patches_fixed_q <= not_2982 & (patches_fixed_q | (and_2992_s17_q & and_1739));
      patches_choice_valid_q <= and_1782_s17_q ? (select_1740 & not_2982) : select_1740;
      patches_choice_column_q <= select_1745;
      patches_choice_shift_q <= select_1750;
      patches_choice_slope_q <= select_1776;
      patches_left_row_q <= select_3154;
      patches_summed_row_column_q <= equal_1784_s17_q ? patches_summed_row_column_q : select_3499;
      patches_read_far_q <= equal_1784_s17_q ? select_3579 : patches_read_far_q;
      segment_textured_q <= select_2006 + {6'h0, and_2604_s17_q};
      segment_explained_q <= select_2011 + {6'h0, and_2609};
      segment_nearer_q <= select_2021 + {6'h0, and_2614};
      product_q <= equal_571_s17_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2036;
      columns_passed_q <= {select_2038[7:0], or_2034};
      line_ended_q <= marks_last_s17_q;
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
    if (s17_en) begin
      averager_quarter_1_0_q <= select_2163;
      averager_quarter_1_1_q <= select_2165;
      averager_quarter_2_0_q <= select_2167;
      averager_quarter_2_1_q <= select_2169;
      census_columns_values_0_cell_0_left_q <= select_2197;
      census_columns_values_0_cell_0_right_q <= select_2198;
      census_columns_values_0_cell_1_left_q <= select_2200;
      census_columns_values_0_cell_1_right_q <= select_2201;
      census_columns_values_0_cell_1_mask_q <= select_2202;
      census_columns_values_0_cell_2_left_q <= select_2203;
      census_columns_values_0_cell_2_right_q <= select_2204;
      census_columns_values_0_cell_2_mask_q <= select_2205;
      census_columns_values_0_cell_2_of_skin_q <= select_2206;
      census_columns_values_0_cell_3_left_q <= select_2207;
      census_columns_values_0_cell_3_right_q <= select_2208;
      census_columns_values_0_cell_3_mask_q <= select_2209;
      census_columns_values_0_cell_4_left_q <= select_2210;
      census_columns_values_0_cell_4_right_q <= select_2211;
      census_columns_values_0_cell_4_mask_q <= select_2212;
      census_columns_values_1_cell_0_left_q <= select_2213;
      census_columns_values_1_cell_0_right_q <= select_2214;
      census_columns_values_1_cell_1_left_q <= select_2216;
      census_columns_values_1_cell_1_right_q <= select_2217;
      census_columns_values_1_cell_2_left_q <= select_2219;
      census_columns_values_1_cell_2_right_q <= select_2220;
      census_columns_values_1_cell_2_of_skin_q <= select_2222;
      census_columns_values_1_cell_3_left_q <= select_2223;
      census_columns_values_1_cell_3_right_q <= select_2224;
      census_columns_values_1_cell_4_left_q <= select_2226;
      census_columns_values_1_cell_4_right_q <= select_2227;
      census_columns_values_2_cell_0_left_q <= select_2229;
      census_columns_values_2_cell_0_right_q <= select_2230;
      census_columns_values_2_cell_1_left_q <= select_2232;
      census_columns_values_2_cell_1_right_q <= select_2233;
      census_columns_values_2_cell_2_left_q <= select_2235;
      census_columns_values_2_cell_2_right_q <= select_2236;
      census_columns_values_2_cell_3_left_q <= select_2238;
      census_columns_values_2_cell_3_right_q <= select_2239;
      census_columns_values_2_cell_4_left_q <= select_2241;
      census_columns_values_2_cell_4_right_q <= select_2242;
      census_columns_values_3_cell_1_left_q <= select_2245;
      census_columns_values_3_cell_1_right_q <= select_2246;
      census_columns_values_3_cell_3_left_q <= select_2249;
      census_columns_values_3_cell_3_right_q <= select_2250;
      sharpness_last_mean_0_q <= and_546_s17_q ? select_552_s17_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_546_s17_q ? select_556_s17_q : sharpness_last_mean_1_q;
      box_explained_columns_values_0_q <= equal_571_s17_q ? box_explained_columns_values_0_q : select_4025;
      box_explained_columns_values_1_q <= select_4029;
      box_explained_columns_values_2_q <= select_4032;
      box_explained_columns_values_3_q <= select_4035;
      box_explained_columns_values_4_q <= select_4038;
      box_shown_columns_values_0_q <= equal_571_s17_q ? box_shown_columns_values_0_q : select_4043;
      box_shown_columns_values_1_q <= select_4047;
      box_shown_columns_values_2_q <= select_4050;
      box_shown_columns_values_3_q <= select_4053;
      box_shown_columns_values_4_q <= select_4056;
      box_nearer_columns_values_0_q <= equal_571_s17_q ? box_nearer_columns_values_0_q : select_4061;
      box_nearer_columns_values_1_q <= select_4065;
      box_nearer_columns_values_2_q <= select_4068;
      box_nearer_columns_values_3_q <= select_4071;
      box_nearer_columns_values_4_q <= select_4074;
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
  logic census_columns_values_0_cell_1_mask_s18_q;
  logic census_columns_values_0_cell_2_mask_s18_q;
  logic census_columns_values_0_cell_3_mask_s18_q;
  logic census_columns_values_0_cell_4_mask_s18_q;
  logic census_columns_values_1_cell_2_of_skin_s18_q;
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
  logic [3:0] select_507_s18_q;
  logic [6:0] select_510_s18_q;
  logic [6:0] last_s18_q;
  logic and_544_s18_q;
  logic and_546_s18_q;
  logic equal_549_s18_q;
  logic whole_2_s18_q;
  logic equal_566_s18_q;
  logic equal_571_s18_q;
  logic not_572_s18_q;
  logic so_s18_q;
  logic less_649_s18_q;
  logic less_650_s18_q;
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
  logic and_680_s18_q;
  logic and_684_s18_q;
  logic difference_707_s18_q;
  logic [8:0] xor_708_s18_q;
  logic difference_710_s18_q;
  logic [8:0] xor_711_s18_q;
  logic difference_714_s18_q;
  logic [8:0] xor_715_s18_q;
  logic difference_718_s18_q;
  logic [8:0] xor_719_s18_q;
  logic difference_722_s18_q;
  logic [8:0] xor_723_s18_q;
  logic [9:0] half_grey_levels_s18_q;
  logic [9:0] half_grey_levels_2_s18_q;
  logic equal_1604_s18_q;
  logic all_s18_q;
  logic [1:0] sum_1610_s18_q;
  logic equal_1612_s18_q;
  logic equal_1614_s18_q;
  logic equal_1616_s18_q;
  logic equal_1618_s18_q;
  logic equal_1620_s18_q;
  logic equal_1622_s18_q;
  logic equal_1624_s18_q;
  logic equal_1626_s18_q;
  logic less_1635_s18_q;
  logic or_1639_s18_q;
  logic [31:0] registration_sums_rdata_s18_q;
  logic equal_1659_s18_q;
  logic and_1669_s18_q;
  logic and_1672_s18_q;
  logic select_1689_s18_q;
  logic equal_1690_s18_q;
  logic equal_1700_s18_q;
  logic equal_1784_s18_q;
  logic equal_1786_s18_q;
  logic equal_1789_s18_q;
  logic or_1790_s18_q;
  logic [22:0] select_1800_s18_q;
  logic [4:0] select_1814_s18_q;
  logic select_1820_s18_q;
  logic [3:0] select_1859_s18_q;
  logic less_1875_s18_q;
  logic new_row_s18_q;
  logic [1:0] of_row_2_s18_q;
  logic not_1905_s18_q;
  logic and_1908_s18_q;
  logic not_1910_s18_q;
  logic and_1915_s18_q;
  logic and_1931_s18_q;
  logic and_1934_s18_q;
  logic and_1948_s18_q;
  logic and_1957_s18_q;
  logic and_1962_s18_q;
  logic less_1963_s18_q;
  logic equal_1964_s18_q;
  logic not_1965_s18_q;
  logic equal_1966_s18_q;
  logic or_1985_s18_q;
  logic or_1988_s18_q;
  logic or_1991_s18_q;
  logic not_1993_s18_q;
  logic [9:0] sum_2009_s18_q;
  logic [9:0] sum_2014_s18_q;
  logic [9:0] sum_2024_s18_q;
  logic and_2025_s18_q;
  logic select_2040_s18_q;
  logic [2:0] textured_2_s18_q;
  logic or_2083_s18_q;
  logic or_2086_s18_q;
  logic or_2089_s18_q;
  logic [3:0] difference_2109_s18_q;
  logic [3:0] difference_2125_s18_q;
  logic and_2139_s18_q;
  logic sum_2174_s18_q;
  logic [9:0] difference_2175_s18_q;
  logic sum_2182_s18_q;
  logic [9:0] difference_2183_s18_q;
  logic difference_2254_s18_q;
  logic [8:0] xor_2255_s18_q;
  logic difference_2257_s18_q;
  logic [8:0] xor_2258_s18_q;
  logic difference_2261_s18_q;
  logic [8:0] xor_2262_s18_q;
  logic difference_2265_s18_q;
  logic [8:0] xor_2266_s18_q;
  logic difference_2269_s18_q;
  logic [8:0] xor_2270_s18_q;
  logic equal_2279_s18_q;
  logic equal_2294_s18_q;
  logic difference_2365_s18_q;
  logic [8:0] xor_2366_s18_q;
  logic difference_2377_s18_q;
  logic [8:0] xor_2378_s18_q;
  logic equal_2468_s18_q;
  logic and_2593_s18_q;
  logic and_2599_s18_q;
  logic and_2614_s18_q;
  logic not_2618_s18_q;
  logic [3:0] difference_2628_s18_q;
  logic [9:0] select_2644_s18_q;
  logic [9:0] select_2647_s18_q;
  logic and_2695_s18_q;
  logic and_2712_s18_q;
  logic and_2719_s18_q;
  logic and_2753_s18_q;
  logic and_2754_s18_q;
  logic [7:0] residual_s18_q;
  logic and_2790_s18_q;
  logic and_2804_s18_q;
  logic equal_2847_s18_q;
  logic [27:0] word_s18_q;
  logic equal_3113_s18_q;
  logic less_3119_s18_q;
  logic [47:0] select_3152_s18_q;
  logic equal_3462_s18_q;
  logic [4:0] select_3550_s18_q;
  logic [14:0] select_3581_s18_q;
  logic less_3624_s18_q;
  logic [9:0] eight_s18_q;
  logic [9:0] fall_2_s18_q;
  logic equal_3702_s18_q;
  logic and_3927_s18_q;
  logic less_3928_s18_q;
  logic equal_3929_s18_q;
  logic equal_3946_s18_q;
  logic equal_3948_s18_q;
  logic equal_3949_s18_q;
  logic equal_3950_s18_q;
  logic equal_3951_s18_q;
  logic sum_4_s18_q;
  logic equal_4091_s18_q;
  logic equal_4187_s18_q;
  logic [9:0] select_4197_s18_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      sample_pair_pixel_0_s18_q <= sample_pair_pixel_0_s17_q;
      sample_pair_pixel_1_s18_q <= sample_pair_pixel_1_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      sample_present_s18_q <= sample_present_s17_q;
      census_columns_values_0_cell_1_mask_s18_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s18_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s18_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s18_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s18_q <= census_columns_values_1_cell_2_of_skin_q;
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
      select_507_s18_q <= select_507_s17_q;
      select_510_s18_q <= select_510_s17_q;
      last_s18_q <= last_s17_q;
      and_544_s18_q <= and_544_s17_q;
      and_546_s18_q <= and_546_s17_q;
      equal_549_s18_q <= equal_549_s17_q;
      whole_2_s18_q <= whole_2_s17_q;
      equal_566_s18_q <= equal_566_s17_q;
      equal_571_s18_q <= equal_571_s17_q;
      not_572_s18_q <= not_572_s17_q;
      so_s18_q <= so_s17_q;
      less_649_s18_q <= less_649;
      less_650_s18_q <= less_650;
      less_651_s18_q <= less_651;
      less_652_s18_q <= less_652;
      less_653_s18_q <= less_653;
      less_654_s18_q <= less_654;
      less_655_s18_q <= less_655;
      less_656_s18_q <= less_656;
      less_657_s18_q <= less_657;
      less_658_s18_q <= less_658;
      less_659_s18_q <= less_659;
      less_660_s18_q <= less_660;
      less_661_s18_q <= less_661;
      less_662_s18_q <= less_662;
      less_663_s18_q <= less_663;
      less_664_s18_q <= less_664;
      less_665_s18_q <= less_665;
      less_666_s18_q <= less_666;
      less_667_s18_q <= less_667;
      less_668_s18_q <= less_668;
      less_669_s18_q <= less_669;
      less_670_s18_q <= less_670;
      less_671_s18_q <= less_671;
      less_672_s18_q <= less_672;
      and_680_s18_q <= and_680_s17_q;
      and_684_s18_q <= and_684;
      difference_707_s18_q <= difference_707[9];
      xor_708_s18_q <= difference_707[8:0] ^ {9{difference_707[9]}};
      difference_710_s18_q <= difference_710[9];
      xor_711_s18_q <= difference_710[8:0] ^ {9{difference_710[9]}};
      difference_714_s18_q <= difference_714[9];
      xor_715_s18_q <= difference_714[8:0] ^ {9{difference_714[9]}};
      difference_718_s18_q <= difference_718[9];
      xor_719_s18_q <= difference_718[8:0] ^ {9{difference_718[9]}};
      difference_722_s18_q <= difference_722[9];
      xor_723_s18_q <= difference_722[8:0] ^ {9{difference_722[9]}};
      half_grey_levels_s18_q <= half_grey_levels;
      half_grey_levels_2_s18_q <= half_grey_levels_2;
      equal_1604_s18_q <= equal_1604_s17_q;
      all_s18_q <= all_s17_q;
      sum_1610_s18_q <= sum_1610_s17_q;
      equal_1612_s18_q <= equal_1612_s17_q;
      equal_1614_s18_q <= equal_1614_s17_q;
      equal_1616_s18_q <= equal_1616_s17_q;
      equal_1618_s18_q <= equal_1618_s17_q;
      equal_1620_s18_q <= equal_1620_s17_q;
      equal_1622_s18_q <= equal_1622_s17_q;
      equal_1624_s18_q <= equal_1624_s17_q;
      equal_1626_s18_q <= equal_1626_s17_q;
      less_1635_s18_q <= less_1635_s17_q;
      or_1639_s18_q <= or_1639_s17_q;
      registration_sums_rdata_s18_q <= registration_sums_rdata_q;
      equal_1659_s18_q <= equal_1659_s17_q;
      and_1669_s18_q <= and_1669_s17_q;
      and_1672_s18_q <= and_1672_s17_q;
      select_1689_s18_q <= select_1689_s17_q;
      equal_1690_s18_q <= equal_1690_s17_q;
      equal_1700_s18_q <= equal_1700_s17_q;
      equal_1784_s18_q <= equal_1784_s17_q;
      equal_1786_s18_q <= equal_1786_s17_q;
      equal_1789_s18_q <= equal_1789_s17_q;
      or_1790_s18_q <= or_1790_s17_q;
      select_1800_s18_q <= select_1800;
      select_1814_s18_q <= select_1814_s17_q;
      select_1820_s18_q <= select_1820_s17_q;
      select_1859_s18_q <= select_1859_s17_q;
      less_1875_s18_q <= less_1875_s17_q;
      new_row_s18_q <= new_row_s17_q;
      of_row_2_s18_q <= of_row_2_s17_q;
      not_1905_s18_q <= ~sum_1904[14];
      and_1908_s18_q <= sum_1904[8] & (~(sum_1904[7:0] == 8'h0));
      not_1910_s18_q <= ~(sum_1904[13:9] == 5'h0);
      and_1915_s18_q <= sum_1904[14] & (~(sum_1904[13:8] == 6'h3f));
      and_1931_s18_q <= and_1931;
      and_1934_s18_q <= and_1934;
      and_1948_s18_q <= and_1948_s17_q;
      and_1957_s18_q <= and_1957_s17_q;
      and_1962_s18_q <= and_1962_s17_q;
      less_1963_s18_q <= less_1963_s17_q;
      equal_1964_s18_q <= equal_1964_s17_q;
      not_1965_s18_q <= not_1965_s17_q;
      equal_1966_s18_q <= equal_1966_s17_q;
      or_1985_s18_q <= or_1985_s17_q;
      or_1988_s18_q <= or_1988_s17_q;
      or_1991_s18_q <= or_1991_s17_q;
      not_1993_s18_q <= not_1993_s17_q;
      sum_2009_s18_q <= sum_2009;
      sum_2014_s18_q <= sum_2014;
      sum_2024_s18_q <= sum_2024;
      and_2025_s18_q <= and_2025_s17_q;
      select_2040_s18_q <= select_2040;
      textured_2_s18_q <= textured_2;
      or_2083_s18_q <= or_2083_s17_q;
      or_2086_s18_q <= or_2086_s17_q;
      or_2089_s18_q <= or_2089_s17_q;
      difference_2109_s18_q <= {1'b0, shown_2} - {1'b0, select_2108};
      difference_2125_s18_q <= {1'b0, near_2} - {1'b0, select_2124};
      and_2139_s18_q <= and_2139_s17_q;
      sum_2174_s18_q <= sum_2174[0];
      difference_2175_s18_q <= {1'b0, sum_2174[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2182_s18_q <= sum_2182[0];
      difference_2183_s18_q <= {1'b0, sum_2182[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2254_s18_q <= difference_2254[9];
      xor_2255_s18_q <= difference_2254[8:0] ^ {9{difference_2254[9]}};
      difference_2257_s18_q <= difference_2257[9];
      xor_2258_s18_q <= difference_2257[8:0] ^ {9{difference_2257[9]}};
      difference_2261_s18_q <= difference_2261[9];
      xor_2262_s18_q <= difference_2261[8:0] ^ {9{difference_2261[9]}};
      difference_2265_s18_q <= difference_2265[9];
      xor_2266_s18_q <= difference_2265[8:0] ^ {9{difference_2265[9]}};
      difference_2269_s18_q <= difference_2269[9];
      xor_2270_s18_q <= difference_2269[8:0] ^ {9{difference_2269[9]}};
      equal_2279_s18_q <= equal_2279_s17_q;
      equal_2294_s18_q <= equal_2294_s17_q;
      difference_2365_s18_q <= difference_2365[9];
      xor_2366_s18_q <= difference_2365[8:0] ^ {9{difference_2365[9]}};
      difference_2377_s18_q <= difference_2377[9];
      xor_2378_s18_q <= difference_2377[8:0] ^ {9{difference_2377[9]}};
      equal_2468_s18_q <= equal_2468_s17_q;
      and_2593_s18_q <= and_2593_s17_q;
      and_2599_s18_q <= and_2599_s17_q;
      and_2614_s18_q <= and_2614;
      not_2618_s18_q <= not_2618_s17_q;
      difference_2628_s18_q <= {1'b0, explained_2} - {1'b0, select_2627};
      select_2644_s18_q <= less_2643 ? 10'h0 : regions_rdata_s17_q[9:0];
      select_2647_s18_q <= less_2643 ? 10'h0 : regions_rdata_s17_q[19:10];
      and_2695_s18_q <= and_2695_s17_q;
      and_2712_s18_q <= and_2712_s17_q;
      and_2719_s18_q <= and_2719_s17_q;
      and_2753_s18_q <= and_2753_s17_q;
      and_2754_s18_q <= and_2754_s17_q;
      residual_s18_q <= residual_s17_q;
      and_2790_s18_q <= and_2754_s17_q & less_2789_s17_q;
      and_2804_s18_q <= and_2754_s17_q & less_2803_s17_q;
      equal_2847_s18_q <= equal_2847_s17_q;
      word_s18_q <= word;
      equal_3113_s18_q <= patches_along_s17_q == 5'h7;
      less_3119_s18_q <= less_3119_s17_q;
      select_3152_s18_q <= select_3152;
      equal_3462_s18_q <= equal_3462_s17_q;
      select_3550_s18_q <= select_3550_s17_q;
      select_3581_s18_q <= select_3581_s17_q;
      less_3624_s18_q <= less_3624_s17_q;
      eight_s18_q <= eight;
      fall_2_s18_q <= fall_2;
      equal_3702_s18_q <= equal_3702_s17_q;
      and_3927_s18_q <= and_3927_s17_q;
      less_3928_s18_q <= counts_explained_q < product_q;
      equal_3929_s18_q <= counts_explained_q == product_q;
      equal_3946_s18_q <= equal_3946_s17_q;
      equal_3948_s18_q <= equal_3948_s17_q;
      equal_3949_s18_q <= equal_3949_s17_q;
      equal_3950_s18_q <= equal_3950_s17_q;
      equal_3951_s18_q <= equal_3951_s17_q;
      sum_4_s18_q <= sum_4[0];
      equal_4091_s18_q <= equal_4091_s17_q;
      equal_4187_s18_q <= equal_4187_s17_q;
      select_4197_s18_q <= less_2643 ? 10'h0 : regions_rdata_s17_q[29:20];
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_684_s18_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s18_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s18_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s18_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s18_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:272
  logic [9:0] sum_709;
  assign sum_709 = {9'h0, difference_707_s18_q} + {1'b0, xor_708_s18_q};
  logic [9:0] sum_712;
  assign sum_712 = {9'h0, difference_710_s18_q} + {1'b0, xor_711_s18_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_734;
  assign sum_734 = {half_grey_levels_s18_q[9], half_grey_levels_s18_q[9:4]} + 7'h7f;
  logic less_735;
  assign less_735 = {{5{sum_734[6]}}, sum_734, half_grey_levels_s18_q[3:0]} < 16'hffe1;
  logic [6:0] sum_740;
  assign sum_740 = {half_grey_levels_2_s18_q[9], half_grey_levels_2_s18_q[9:4]} + 7'h7f;
  logic less_741;
  assign less_741 = {{5{sum_740[6]}}, sum_740, half_grey_levels_2_s18_q[3:0]} < 16'hffe1;
  // hls/stages/registration.hpp:265
  logic equal_1661;
  assign equal_1661 = sum_1610_s18_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1610_s18_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1667;
  assign select_1667 = equal_1661 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1668;
  assign sum_1668 = (equal_1659_s18_q ? registration_sums_rdata_s18_q[31:20] : 12'h0) + {{5{select_1667[6]}}, select_1667};
  // hls/stages/patches.hpp:354
  logic [21:0] select_1803;
  assign select_1803 = select_1689_s18_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1800_s18_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1804;
  assign select_1804 = equal_1690_s18_q ? patches_place_0_column_q : select_1803[7:0];
  logic [5:0] select_1805;
  assign select_1805 = equal_1690_s18_q ? patches_place_0_shift_q : select_1803[13:8];
  // hls/stages/patches.hpp:354
  logic [21:0] select_1832;
  assign select_1832 = select_1689_s18_q ? select_1800_s18_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1833;
  assign select_1833 = equal_1690_s18_q ? patches_place_1_column_q : select_1832[7:0];
  logic [5:0] select_1834;
  assign select_1834 = equal_1690_s18_q ? patches_place_1_shift_q : select_1832[13:8];
  // hls/stages/patches.hpp:132
  logic equal_1850;
  assign equal_1850 = {select_1804[7], select_510_s18_q, select_507_s18_q} == {1'b0, select_1804[6:0], 4'h0};
  logic equal_1854;
  assign equal_1854 = {select_1833[7], select_510_s18_q, select_507_s18_q} == {1'b0, select_1833[6:0], 4'h0};
  // hls/stages/patches.hpp:486
  logic [2:0] sum_1896;
  assign sum_1896 = patches_code_row_s18_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:453
  logic and_1912;
  assign and_1912 = not_1905_s18_q & (and_1908_s18_q | not_1910_s18_q);
  // hls/stages/patches.hpp:490
  logic [1:0] sum_1952;
  assign sum_1952 = patches_code_row_s18_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2040_s18_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2043;
  assign select_2043 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1301
  logic equal_2046;
  assign equal_2046 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1274
  logic not_2053;
  assign not_2053 = ~marks_first_s18_q;
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2074;
  assign select_2074 = age_s18_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2090;
  assign not_2090 = ~region_row_s18_q[2];
  logic [2:0] select_2091;
  assign select_2091 = region_row_s18_q[1] ? {1'b0, not_2090, 1'b0} : {region_row_s18_q[2], 1'b0, not_2090};
  logic [5:0] select_2092;
  assign select_2092 = region_row_s18_q[0] ? {select_2091[2], 1'b0, select_2091[1], 1'b0, select_2091[0], 1'b0} : {1'b0, select_2091[2], 1'b0, select_2091[1], 1'b0, select_2091[0]};
  logic [11:0] select_2093;
  assign select_2093 = or_2089_s18_q ? {select_2092[5], 1'b0, select_2092[4], 1'b0, select_2092[3], 1'b0, select_2092[2], 1'b0, select_2092[1], 1'b0, select_2092[0], 1'b0} : {1'b0, select_2092[5], 1'b0, select_2092[4], 1'b0, select_2092[3], 1'b0, select_2092[2], 1'b0, select_2092[1], 1'b0, select_2092[0]};
  logic [23:0] select_2094;
  assign select_2094 = or_2086_s18_q ? {select_2093[11], 1'b0, select_2093[10], 1'b0, select_2093[9], 1'b0, select_2093[8], 1'b0, select_2093[7], 1'b0, select_2093[6], 1'b0, select_2093[5], 1'b0, select_2093[4], 1'b0, select_2093[3], 1'b0, select_2093[2], 1'b0, select_2093[1], 1'b0, select_2093[0], 1'b0} : {1'b0, select_2093[11], 1'b0, select_2093[10], 1'b0, select_2093[9], 1'b0, select_2093[8], 1'b0, select_2093[7], 1'b0, select_2093[6], 1'b0, select_2093[5], 1'b0, select_2093[4], 1'b0, select_2093[3], 1'b0, select_2093[2], 1'b0, select_2093[1], 1'b0, select_2093[0]};
  // hls/stages/agreement.hpp:1096
  logic [4:0] around;
  assign around = {difference_2109_s18_q[3], difference_2109_s18_q} + (equal_566_s18_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1097
  logic [4:0] n;
  assign n = {difference_2125_s18_q[3], difference_2125_s18_q} + (equal_566_s18_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:210
  logic [9:0] xor_2176;
  assign xor_2176 = {difference_2175_s18_q[8:0], sum_2174_s18_q} ^ {10{difference_2175_s18_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2175_s18_q[9]} + {1'b0, xor_2176};
  logic [9:0] xor_2184;
  assign xor_2184 = {difference_2183_s18_q[8:0], sum_2182_s18_q} ^ {10{difference_2183_s18_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2183_s18_q[9]} + {1'b0, xor_2184};
  // hls/stages/agreement.hpp:520
  logic select_2199;
  assign select_2199 = and_546_s18_q ? whole_2_s18_q : census_columns_values_0_cell_0_mask_q;
  logic select_2215;
  assign select_2215 = and_546_s18_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2218;
  assign select_2218 = and_546_s18_q ? census_columns_values_0_cell_1_mask_s18_q : census_columns_values_1_cell_1_mask_q;
  logic select_2225;
  assign select_2225 = and_546_s18_q ? census_columns_values_0_cell_3_mask_s18_q : census_columns_values_1_cell_3_mask_q;
  logic select_2228;
  assign select_2228 = and_546_s18_q ? census_columns_values_0_cell_4_mask_s18_q : census_columns_values_1_cell_4_mask_q;
  logic select_2231;
  assign select_2231 = and_546_s18_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2234;
  assign select_2234 = and_546_s18_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] sum_2256;
  assign sum_2256 = {9'h0, difference_2254_s18_q} + {1'b0, xor_2255_s18_q};
  logic [9:0] sum_2259;
  assign sum_2259 = {9'h0, difference_2257_s18_q} + {1'b0, xor_2258_s18_q};
  // hls/stages/moments.hpp:117
  logic [13:0] select_2295;
  assign select_2295 = equal_2294_s18_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2297;
  assign select_2297 = equal_2294_s18_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2308;
  assign sum_2308 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2318;
  assign sum_2318 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/census.hpp:359
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2365_s18_q} + xor_2366_s18_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2377_s18_q} + xor_2378_s18_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2601;
  assign select_2601 = and_2593_s18_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2599_s18_q});
  logic [13:0] select_2616;
  assign select_2616 = and_2593_s18_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2614_s18_q});
  // hls/stages/agreement.hpp:1095
  logic [4:0] e;
  assign e = {difference_2628_s18_q[3], difference_2628_s18_q} + (equal_566_s18_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2714;
  assign select_2714 = and_2593_s18_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2712_s18_q});
  logic [13:0] select_2721;
  assign select_2721 = and_2593_s18_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2719_s18_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2771;
  assign select_2771 = equal_1700_s18_q ? (and_2754_s18_q ? residual_s18_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_2778;
  assign and_2778 = not_572_s18_q & (so_s18_q & (and_2754_s18_q & equal_1700_s18_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2780;
  assign select_2780 = and_2753_s18_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2778});
  // hls/stages/registration.hpp:107
  logic and_2782;
  assign and_2782 = and_2754_s18_q & ($signed(residual_s18_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2784;
  assign select_2784 = so_s18_q ? (equal_1700_s18_q ? {and_2782, and_2754_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2792;
  assign select_2792 = so_s18_q ? (equal_1700_s18_q ? {and_2790_s18_q, and_2754_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2793;
  assign select_2793 = equal_571_s18_q ? 2'h0 : select_2792;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2794;
  assign sum_2794 = registration_half_votes_up_q + {{5{select_2793[1]}}, select_2793};
  // hls/stages/registration.hpp:205
  logic less_2796;
  assign less_2796 = $signed(residual_s18_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2797;
  assign and_2797 = and_2754_s18_q & less_2796;
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2799;
  assign select_2799 = so_s18_q ? (equal_1700_s18_q ? {and_2797, and_2754_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2806;
  assign select_2806 = so_s18_q ? (equal_1700_s18_q ? {and_2804_s18_q, and_2754_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2807;
  assign select_2807 = equal_571_s18_q ? 2'h0 : select_2806;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2808;
  assign sum_2808 = registration_half_half_votes_up_q + {{5{select_2807[1]}}, select_2807};
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2849;
  assign select_2849 = or_1639_s18_q ? 12'h0 : (equal_2847_s18_q ? registration_sums_rdata_s18_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2851;
  assign select_2851 = equal_1604_s18_q ? 12'h0 : (less_1635_s18_q ? select_2849 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2854;
  assign and_2854 = x_s18_q[1] & all_s18_q;
  // hls/stages/agreement.hpp:1142
  logic and_2857;
  assign and_2857 = not_1993_s18_q & (less_1635_s18_q & ({and_2854, x_s18_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2864;
  assign select_2864 = or_1639_s18_q ? 12'h0 : (equal_2847_s18_q ? registration_sums_rdata_s18_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2866;
  assign select_2866 = equal_1604_s18_q ? 12'h0 : (less_1635_s18_q ? select_2864 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2872;
  assign not_2872 = ~all_s18_q;
  // hls/stages/agreement.hpp:1142
  logic and_2875;
  assign and_2875 = not_1993_s18_q & (less_1635_s18_q & (x_s18_q[2:0] == {all_s18_q, not_2872, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2881;
  assign and_2881 = equal_571_s18_q & (x_s18_q[6] & (not_1993_s18_q & (less_1635_s18_q & all_s18_q)));
  // hls/stages/registration.hpp:157
  logic equal_2908;
  assign equal_2908 = x_s18_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2911;
  assign and_2911 = not_1993_s18_q & (less_1635_s18_q & (x_s18_q[5] ? x_s18_q[3] : equal_2908));
  logic and_2920;
  assign and_2920 = not_1993_s18_q & (less_1635_s18_q & ((~x_s18_q[5]) & (x_s18_q[3] & equal_2908)));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3015;
  assign select_3015 = sample_pair_whole_s18_q ? (equal_1690_s18_q ? patches_place_0_slope_q : select_1803[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3020;
  assign select_3020 = sample_pair_whole_s18_q ? (equal_1690_s18_q ? patches_place_1_slope_q : select_1832[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:522
  logic [55:0] other;
  assign other = new_row_s18_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3109;
  assign select_3109 = or_1790_s18_q ? {and_1934_s18_q, and_1931_s18_q, and_1915_s18_q, and_1912, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3111;
  assign select_3111 = equal_1784_s18_q ? patches_codes_at_q : (equal_1786_s18_q ? other[55:4] : select_3109);
  // hls/stages/patches.hpp:521
  logic [27:0] select_3114;
  assign select_3114 = equal_3113_s18_q ? word_s18_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3116;
  assign select_3116 = equal_1786_s18_q ? (new_row_s18_q ? word_s18_q : select_3114) : patches_codes_further_q;
  // hls/stages/patches.hpp:523
  logic [55:0] select_3118;
  assign select_3118 = less_1875_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:493
  logic [55:0] select_3120;
  assign select_3120 = less_3119_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3122;
  assign select_3122 = or_1790_s18_q ? (equal_1789_s18_q ? patches_next_codes_q : select_3120) : patches_next_codes_q;
  logic [55:0] select_3124;
  assign select_3124 = equal_1784_s18_q ? patches_next_codes_q : (equal_1786_s18_q ? select_3118 : select_3122);
  // hls/stages/count_bits.hpp:24
  logic parity_3129;
  assign parity_3129 = ^{and_1934_s18_q, and_1931_s18_q, and_1915_s18_q, and_1912};
  // hls/stages/count_bits.hpp:25
  logic or_3133;
  assign or_3133 = ({and_1915_s18_q, and_1912} == 2'h3) | (and_1931_s18_q & (and_1915_s18_q | and_1912));
  logic and_3134;
  assign and_3134 = and_1934_s18_q & (^{and_1931_s18_q, and_1915_s18_q, and_1912});
  // hls/stages/count_bits.hpp:24
  logic xor_3135;
  assign xor_3135 = or_3133 ^ and_3134;
  // hls/stages/count_bits.hpp:27
  logic and_3136;
  assign and_3136 = or_3133 & and_3134;
  // hls/stages/patches.hpp:524
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3152_s18_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3158;
  assign xor_3158 = bits[17] ^ (^{select_3152_s18_q[16:15], other[16:15]});
  logic xor_3161;
  assign xor_3161 = bits[11] ^ (^{select_3152_s18_q[10:9], other[10:9]});
  logic xor_3164;
  assign xor_3164 = bits[14] ^ (^{select_3152_s18_q[13:12], other[13:12]});
  logic xor_3167;
  assign xor_3167 = xor_3158 ^ (^{select_3152_s18_q[14:9], other[14:9]});
  logic xor_3170;
  assign xor_3170 = bits[47] ^ (^{select_3152_s18_q[46:45], other[46:45]});
  logic xor_3173;
  assign xor_3173 = bits[8] ^ (^{select_3152_s18_q[7:6], other[7:6]});
  logic xor_3176;
  assign xor_3176 = bits[2] ^ (^{select_3152_s18_q[1:0], other[1:0]});
  logic xor_3179;
  assign xor_3179 = bits[5] ^ (^{select_3152_s18_q[4:3], other[4:3]});
  logic xor_3182;
  assign xor_3182 = xor_3173 ^ (^{select_3152_s18_q[5:0], other[5:0]});
  logic parity_3184;
  assign parity_3184 = ^{select_3152_s18_q[47:45], select_3152_s18_q[8:0], other[47:45], other[8:0]};
  logic xor_3188;
  assign xor_3188 = bits[44] ^ (^{select_3152_s18_q[43:42], other[43:42]});
  logic xor_3191;
  assign xor_3191 = bits[38] ^ (^{select_3152_s18_q[37:36], other[37:36]});
  logic xor_3194;
  assign xor_3194 = bits[41] ^ (^{select_3152_s18_q[40:39], other[40:39]});
  logic xor_3200;
  assign xor_3200 = bits[26] ^ (^{select_3152_s18_q[25:24], other[25:24]});
  logic xor_3203;
  assign xor_3203 = bits[20] ^ (^{select_3152_s18_q[19:18], other[19:18]});
  logic xor_3206;
  assign xor_3206 = bits[23] ^ (^{select_3152_s18_q[22:21], other[22:21]});
  logic xor_3212;
  assign xor_3212 = bits[35] ^ (^{select_3152_s18_q[34:33], other[34:33]});
  logic xor_3215;
  assign xor_3215 = bits[29] ^ (^{select_3152_s18_q[28:27], other[28:27]});
  logic xor_3218;
  assign xor_3218 = bits[32] ^ (^{select_3152_s18_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:184
  logic select_3502;
  assign select_3502 = equal_1784_s18_q ? patches_summed_first_q : (equal_1786_s18_q ? new_row_s18_q : patches_summed_first_q);
  // hls/stages/patches.hpp:543
  logic [9:0] select_3590;
  assign select_3590 = (patches_read_far_s18_q < patches_peak_far_q) ? patches_read_far_s18_q : patches_peak_far_q;
  logic [9:0] select_3591;
  assign select_3591 = patches_read_first_s18_q ? patches_read_far_s18_q : select_3590;
  // hls/stages/patches.hpp:583
  logic [10:0] sum_3633;
  assign sum_3633 = {1'b0, fall_2_s18_q} + {2'h0, fall_2_s18_q[9:1]};
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3637;
  assign sum_3637 = {1'b0, fall_2_s18_q} + {3'h0, fall_2_s18_q[9:2]};
  logic less_3641;
  assign less_3641 = {eight_s18_q, 3'h0} < ({fall_2_s18_q, 3'h0} - {3'h0, fall_2_s18_q});
  // hls/stages/patches.hpp:597
  logic [7:0] select_3647;
  assign select_3647 = patches_second_s18_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:596
  logic [3:0] sum_3648;
  assign sum_3648 = {2'h0, select_3581_s18_q[14:13]} + 4'hf;
  logic [5:0] select_3649;
  assign select_3649 = patches_second_s18_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3650;
  assign sum_3650 = {select_3649[5], select_3649} + {{4{sum_3648[3]}}, sum_3648[3:1]};
  // hls/stages/agreement.hpp:1188
  logic or_3924;
  assign or_3924 = ({counts_textured_s18_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s18_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = less_3928_s18_q | (product_rest_q & equal_3929_s18_q);
  // hls/stages/agreement.hpp:1227
  logic select_3932;
  assign select_3932 = and_3927_s18_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3935;
  assign sum_3935 = {1'b0, select_2647_s18_q} + {2'h0, select_2647_s18_q[9:1]};
  // hls/stages/agreement.hpp:788
  logic select_3988;
  assign select_3988 = equal_571_s18_q ? (equal_3702_s18_q ? sum_4_s18_q : (product_rest_q | sum_4_s18_q)) : product_rest_q;
  logic [2:0] select_4006;
  assign select_4006 = ends_cell_s18_q ? textured_2_s18_q : box_textured_columns_values_0_q;
  logic [2:0] select_4008;
  assign select_4008 = equal_571_s18_q ? box_textured_columns_values_0_q : (so_s18_q ? select_4006 : box_textured_columns_values_0_q);
  logic [2:0] select_4009;
  assign select_4009 = ends_cell_s18_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4011;
  assign select_4011 = equal_571_s18_q ? box_textured_columns_values_1_q : (so_s18_q ? select_4009 : box_textured_columns_values_1_q);
  logic [2:0] select_4012;
  assign select_4012 = ends_cell_s18_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4014;
  assign select_4014 = equal_571_s18_q ? box_textured_columns_values_2_q : (so_s18_q ? select_4012 : box_textured_columns_values_2_q);
  logic [2:0] select_4015;
  assign select_4015 = ends_cell_s18_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4017;
  assign select_4017 = equal_571_s18_q ? box_textured_columns_values_3_q : (so_s18_q ? select_4015 : box_textured_columns_values_3_q);
  logic [2:0] select_4018;
  assign select_4018 = ends_cell_s18_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4020;
  assign select_4020 = equal_571_s18_q ? box_textured_columns_values_4_q : (so_s18_q ? select_4018 : box_textured_columns_values_4_q);
  logic [4:0] select_4040;
  assign select_4040 = so_s18_q ? (ends_cell_s18_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4041;
  assign select_4041 = equal_571_s18_q ? box_explained_sum_sums_values_0_q : select_4040;
  logic [4:0] select_4058;
  assign select_4058 = so_s18_q ? (ends_cell_s18_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4076;
  assign select_4076 = so_s18_q ? (ends_cell_s18_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1300
  logic [3:0] select_4108;
  assign select_4108 = select_2040_s18_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4114;
  assign select_4114 = marks_first_s18_q ? (less_4110 ? {sum_4111, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4189;
  assign select_4189 = equal_1626_s18_q ? {2'h0, counts_explained_s18_q, 2'h0, counts_textured_s18_q} : (equal_4187_s18_q ? registration_sums_rdata_s18_q : 32'h0);
  logic [31:0] select_4190;
  assign select_4190 = equal_1624_s18_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4189;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1896, patches_code_row_s18_q[1:0], of_row_2_s18_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s18_en & and_1948_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1934_s18_q, and_1931_s18_q, and_1915_s18_q, and_1912, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1952, patches_code_row_s18_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s18_en & and_1962_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1934_s18_q, and_1931_s18_q, and_1915_s18_q, and_1912, patches_codes_at_q[51:8]};
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
  assign regions_waddr = {region_row_s18_q, or_1991_s18_q, or_1988_s18_q, or_1985_s18_q};
  logic regions_we;
  assign regions_we = s18_en & and_2025_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2024_s18_q, sum_2014_s18_q, sum_2009_s18_q};
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
      moments_before_0_q <= 14'h0;
      moments_before_1_q <= 14'h0;
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
      moments_before_0_q <= equal_571_s18_q ? select_2295 : moments_before_0_q;
      moments_before_1_q <= equal_571_s18_q ? select_2297 : moments_before_1_q;
      counts_supervised_q <= select_2601;
      counts_nearer_q <= select_2616;
      counts_turned_left_q <= select_2714;
      counts_turned_right_q <= select_2721;
      registration_half_measured_q <= select_2780;
      registration_half_votes_up_q <= and_2753_s18_q ? 7'h0 : sum_2794;
      registration_half_half_votes_up_q <= and_2753_s18_q ? 7'h0 : sum_2808;
      patches_place_0_column_q <= sample_pair_whole_s18_q ? select_1804 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s18_q ? select_1805 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3015;
      patches_place_1_column_q <= sample_pair_whole_s18_q ? select_1833 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s18_q ? select_1834 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3020;
      patches_codes_at_q <= select_3111;
      patches_codes_further_q <= equal_1784_s18_q ? patches_codes_further_q : select_3116;
      patches_next_codes_q <= select_3124;
      patches_summed_first_q <= select_3502;
      patches_peak_far_q <= equal_1784_s18_q ? select_3591 : patches_peak_far_q;
      product_rest_q <= select_3988;
      disagree_q <= equal_571_s18_q ? select_3932 : disagree_q;
      began_q <= not_2053 & (began_q | select_2040_s18_q);
      seen_x_q <= select_2040_s18_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s18_q ? 4'h0 : select_4108;
      seen_column_q <= select_2040_s18_q ? 8'h0 : (seen_column_q + {7'h0, equal_2046});
      seen_rows_left_q <= select_4114;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s18_q ? 13'h0 : (seen_base_q + {6'h0, select_2043});
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
    if (s18_en) begin
      census_columns_values_0_cell_0_mask_q <= select_2199;
      census_columns_values_1_cell_0_mask_q <= select_2215;
      census_columns_values_1_cell_1_mask_q <= select_2218;
      census_columns_values_1_cell_3_mask_q <= select_2225;
      census_columns_values_1_cell_4_mask_q <= select_2228;
      census_columns_values_2_cell_0_mask_q <= select_2231;
      census_columns_values_2_cell_1_mask_q <= select_2234;
      box_textured_columns_values_0_q <= select_4008;
      box_textured_columns_values_1_q <= select_4011;
      box_textured_columns_values_2_q <= select_4014;
      box_textured_columns_values_3_q <= select_4017;
      box_textured_columns_values_4_q <= select_4020;
      box_explained_sum_sums_values_0_q <= select_4041;
      box_shown_sum_sums_values_0_q <= equal_571_s18_q ? box_shown_sum_sums_values_0_q : select_4058;
      box_nearer_sum_sums_values_0_q <= equal_571_s18_q ? box_nearer_sum_sums_values_0_q : select_4076;
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
  logic census_columns_values_0_cell_2_mask_s19_q;
  logic census_columns_values_1_cell_2_of_skin_s19_q;
  logic census_columns_values_1_cell_3_mask_s19_q;
  logic census_columns_values_1_cell_4_mask_s19_q;
  logic census_columns_values_2_cell_0_mask_s19_q;
  logic census_columns_values_2_cell_1_mask_s19_q;
  logic [6:0] x_s19_q;
  logic [2:0] slot_s19_q;
  logic ends_cell_s19_q;
  logic lower_half_s19_q;
  logic [13:0] counts_nearer_s19_q;
  logic [11:0] counts_turned_left_s19_q;
  logic [11:0] counts_turned_right_s19_q;
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
  logic [3:0] select_507_s19_q;
  logic [6:0] select_510_s19_q;
  logic [6:0] last_s19_q;
  logic and_544_s19_q;
  logic and_546_s19_q;
  logic equal_549_s19_q;
  logic whole_2_s19_q;
  logic equal_566_s19_q;
  logic equal_571_s19_q;
  logic not_572_s19_q;
  logic so_s19_q;
  logic less_649_s19_q;
  logic less_650_s19_q;
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
  logic and_680_s19_q;
  logic whole_9_s19_q;
  logic [10:0] sum_713_s19_q;
  logic [9:0] sum_716_s19_q;
  logic [9:0] sum_720_s19_q;
  logic [9:0] sum_724_s19_q;
  logic less_735_s19_q;
  logic less_737_s19_q;
  logic less_741_s19_q;
  logic less_743_s19_q;
  logic equal_1604_s19_q;
  logic [1:0] sum_1610_s19_q;
  logic equal_1612_s19_q;
  logic equal_1614_s19_q;
  logic equal_1616_s19_q;
  logic equal_1618_s19_q;
  logic equal_1620_s19_q;
  logic equal_1622_s19_q;
  logic less_1635_s19_q;
  logic [19:0] select_1660_s19_q;
  logic equal_1661_s19_q;
  logic [11:0] sum_1668_s19_q;
  logic and_1669_s19_q;
  logic and_1672_s19_q;
  logic select_1689_s19_q;
  logic equal_1690_s19_q;
  logic equal_1784_s19_q;
  logic equal_1786_s19_q;
  logic equal_1789_s19_q;
  logic or_1790_s19_q;
  logic select_1800_s19_q;
  logic [7:0] sum_1806_s19_q;
  logic [4:0] select_1814_s19_q;
  logic select_1820_s19_q;
  logic [7:0] sum_1835_s19_q;
  logic equal_1850_s19_q;
  logic equal_1854_s19_q;
  logic [3:0] select_1859_s19_q;
  logic less_1963_s19_q;
  logic equal_1964_s19_q;
  logic not_1965_s19_q;
  logic equal_1966_s19_q;
  logic not_1993_s19_q;
  logic not_2053_s19_q;
  logic [7:0] sum_2063_s19_q;
  logic [3:0] difference_2075_s19_q;
  logic or_2083_s19_q;
  logic [23:0] select_2094_s19_q;
  logic [4:0] around_s19_q;
  logic less_2128_s19_q;
  logic and_2139_s19_q;
  logic [10:0] size_s19_q;
  logic [10:0] size_2_s19_q;
  logic [10:0] sum_2260_s19_q;
  logic [9:0] sum_2263_s19_q;
  logic [9:0] sum_2267_s19_q;
  logic [9:0] sum_2271_s19_q;
  logic equal_2279_s19_q;
  logic equal_2294_s19_q;
  logic [13:0] select_2302_s19_q;
  logic not_2310_s19_q;
  logic not_2313_s19_q;
  logic not_2320_s19_q;
  logic not_2323_s19_q;
  logic [8:0] contrast_s19_q;
  logic [8:0] contrast_2_s19_q;
  logic equal_2397_s19_q;
  logic equal_2468_s19_q;
  logic and_2593_s19_q;
  logic not_2618_s19_q;
  logic [4:0] e_s19_q;
  logic [9:0] select_2644_s19_q;
  logic [9:0] select_2647_s19_q;
  logic and_2695_s19_q;
  logic and_2753_s19_q;
  logic [7:0] select_2773_s19_q;
  logic [1:0] select_2785_s19_q;
  logic [1:0] select_2800_s19_q;
  logic [11:0] select_2851_s19_q;
  logic and_2859_s19_q;
  logic [11:0] select_2866_s19_q;
  logic and_2877_s19_q;
  logic and_2881_s19_q;
  logic and_2913_s19_q;
  logic and_2921_s19_q;
  logic [8:0] other_s19_q;
  logic [2:0] select_3137_s19_q;
  logic [8:0] select_3152_s19_q;
  logic xor_3167_s19_q;
  logic xor_3185_s19_q;
  logic xor_3197_s19_q;
  logic xor_3209_s19_q;
  logic xor_3221_s19_q;
  logic or_3230_s19_q;
  logic or_3234_s19_q;
  logic or_3238_s19_q;
  logic or_3245_s19_q;
  logic or_3249_s19_q;
  logic or_3253_s19_q;
  logic or_3260_s19_q;
  logic or_3264_s19_q;
  logic or_3268_s19_q;
  logic or_3278_s19_q;
  logic or_3282_s19_q;
  logic or_3286_s19_q;
  logic or_3294_s19_q;
  logic or_3298_s19_q;
  logic or_3302_s19_q;
  logic or_3309_s19_q;
  logic or_3313_s19_q;
  logic or_3317_s19_q;
  logic or_3327_s19_q;
  logic or_3331_s19_q;
  logic or_3335_s19_q;
  logic and_3340_s19_q;
  logic or_3341_s19_q;
  logic equal_3462_s19_q;
  logic [4:0] select_3550_s19_q;
  logic [12:0] select_3581_s19_q;
  logic [9:0] select_3591_s19_q;
  logic less_3624_s19_q;
  logic not_3632_s19_q;
  logic not_3635_s19_q;
  logic not_3639_s19_q;
  logic not_3642_s19_q;
  logic [7:0] select_3647_s19_q;
  logic sum_3648_s19_q;
  logic [6:0] sum_3650_s19_q;
  logic equal_3702_s19_q;
  logic equal_3921_s19_q;
  logic or_3924_s19_q;
  logic select_3932_s19_q;
  logic not_3937_s19_q;
  logic equal_3946_s19_q;
  logic equal_3948_s19_q;
  logic equal_3949_s19_q;
  logic equal_3950_s19_q;
  logic equal_3951_s19_q;
  logic equal_4091_s19_q;
  logic [31:0] select_4190_s19_q;
  logic [9:0] select_4197_s19_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      census_columns_values_0_cell_2_mask_s19_q <= census_columns_values_0_cell_2_mask_s18_q;
      census_columns_values_1_cell_2_of_skin_s19_q <= census_columns_values_1_cell_2_of_skin_s18_q;
      census_columns_values_1_cell_3_mask_s19_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s19_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s19_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s19_q <= census_columns_values_2_cell_1_mask_q;
      x_s19_q <= x_s18_q[6:0];
      slot_s19_q <= slot_s18_q;
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      counts_nearer_s19_q <= counts_nearer_q;
      counts_turned_left_s19_q <= counts_turned_left_q[13:2];
      counts_turned_right_s19_q <= counts_turned_right_q[13:2];
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
      select_507_s19_q <= select_507_s18_q;
      select_510_s19_q <= select_510_s18_q;
      last_s19_q <= last_s18_q;
      and_544_s19_q <= and_544_s18_q;
      and_546_s19_q <= and_546_s18_q;
      equal_549_s19_q <= equal_549_s18_q;
      whole_2_s19_q <= whole_2_s18_q;
      equal_566_s19_q <= equal_566_s18_q;
      equal_571_s19_q <= equal_571_s18_q;
      not_572_s19_q <= not_572_s18_q;
      so_s19_q <= so_s18_q;
      less_649_s19_q <= less_649_s18_q;
      less_650_s19_q <= less_650_s18_q;
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
      and_680_s19_q <= and_680_s18_q;
      whole_9_s19_q <= whole_9;
      sum_713_s19_q <= {1'b0, sum_709} + {1'b0, sum_712};
      sum_716_s19_q <= {9'h0, difference_714_s18_q} + {1'b0, xor_715_s18_q};
      sum_720_s19_q <= {9'h0, difference_718_s18_q} + {1'b0, xor_719_s18_q};
      sum_724_s19_q <= {9'h0, difference_722_s18_q} + {1'b0, xor_723_s18_q};
      less_735_s19_q <= less_735;
      less_737_s19_q <= $signed(10'h0) < $signed(half_grey_levels_s18_q);
      less_741_s19_q <= less_741;
      less_743_s19_q <= $signed(10'h0) < $signed(half_grey_levels_2_s18_q);
      equal_1604_s19_q <= equal_1604_s18_q;
      sum_1610_s19_q <= sum_1610_s18_q;
      equal_1612_s19_q <= equal_1612_s18_q;
      equal_1614_s19_q <= equal_1614_s18_q;
      equal_1616_s19_q <= equal_1616_s18_q;
      equal_1618_s19_q <= equal_1618_s18_q;
      equal_1620_s19_q <= equal_1620_s18_q;
      equal_1622_s19_q <= equal_1622_s18_q;
      less_1635_s19_q <= less_1635_s18_q;
      select_1660_s19_q <= equal_1659_s18_q ? registration_sums_rdata_s18_q[19:0] : 20'h0;
      equal_1661_s19_q <= equal_1661;
      sum_1668_s19_q <= sum_1668;
      and_1669_s19_q <= and_1669_s18_q;
      and_1672_s19_q <= and_1672_s18_q;
      select_1689_s19_q <= select_1689_s18_q;
      equal_1690_s19_q <= equal_1690_s18_q;
      equal_1784_s19_q <= equal_1784_s18_q;
      equal_1786_s19_q <= equal_1786_s18_q;
      equal_1789_s19_q <= equal_1789_s18_q;
      or_1790_s19_q <= or_1790_s18_q;
      select_1800_s19_q <= select_1800_s18_q[0];
      sum_1806_s19_q <= select_1804 + {{2{select_1805[5]}}, select_1805};
      select_1814_s19_q <= select_1814_s18_q;
      select_1820_s19_q <= select_1820_s18_q;
      sum_1835_s19_q <= select_1833 + {{2{select_1834[5]}}, select_1834};
      equal_1850_s19_q <= equal_1850;
      equal_1854_s19_q <= equal_1854;
      select_1859_s19_q <= select_1859_s18_q;
      less_1963_s19_q <= less_1963_s18_q;
      equal_1964_s19_q <= equal_1964_s18_q;
      not_1965_s19_q <= not_1965_s18_q;
      equal_1966_s19_q <= equal_1966_s18_q;
      not_1993_s19_q <= not_1993_s18_q;
      not_2053_s19_q <= not_2053;
      sum_2063_s19_q <= {2'h0, x_s18_q[7:2]} + 8'hff;
      difference_2075_s19_q <= {1'b0, textured_2_s18_q} - {1'b0, select_2074};
      or_2083_s19_q <= or_2083_s18_q;
      select_2094_s19_q <= select_2094;
      around_s19_q <= around;
      less_2128_s19_q <= {1'b0, around[4:1]} < n;
      and_2139_s19_q <= and_2139_s18_q;
      size_s19_q <= size;
      size_2_s19_q <= size_2;
      sum_2260_s19_q <= {1'b0, sum_2256} + {1'b0, sum_2259};
      sum_2263_s19_q <= {9'h0, difference_2261_s18_q} + {1'b0, xor_2262_s18_q};
      sum_2267_s19_q <= {9'h0, difference_2265_s18_q} + {1'b0, xor_2266_s18_q};
      sum_2271_s19_q <= {9'h0, difference_2269_s18_q} + {1'b0, xor_2270_s18_q};
      equal_2279_s19_q <= equal_2279_s18_q;
      equal_2294_s19_q <= equal_2294_s18_q;
      select_2302_s19_q <= (select_2297 < select_2295) ? select_2295 : select_2297;
      not_2310_s19_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2308);
      not_2313_s19_q <= ~({3'h0, select_2297[13:2]} < sum_2308);
      not_2320_s19_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2318);
      not_2323_s19_q <= ~({3'h0, select_2295[13:2]} < sum_2318);
      contrast_s19_q <= contrast;
      contrast_2_s19_q <= contrast_2;
      equal_2397_s19_q <= x_s18_q[7:3] == 5'h0;
      equal_2468_s19_q <= equal_2468_s18_q;
      and_2593_s19_q <= and_2593_s18_q;
      not_2618_s19_q <= not_2618_s18_q;
      e_s19_q <= e;
      select_2644_s19_q <= select_2644_s18_q;
      select_2647_s19_q <= select_2647_s18_q;
      and_2695_s19_q <= and_2695_s18_q;
      and_2753_s19_q <= and_2753_s18_q;
      select_2773_s19_q <= equal_571_s18_q ? 8'h0 : (so_s18_q ? select_2771 : 8'h0);
      select_2785_s19_q <= equal_571_s18_q ? 2'h0 : select_2784;
      select_2800_s19_q <= equal_571_s18_q ? 2'h0 : select_2799;
      select_2851_s19_q <= select_2851;
      and_2859_s19_q <= equal_571_s18_q & (x_s18_q[6] & and_2857);
      select_2866_s19_q <= select_2866;
      and_2877_s19_q <= equal_571_s18_q & (x_s18_q[6] & and_2875);
      and_2881_s19_q <= and_2881;
      and_2913_s19_q <= equal_571_s18_q & (x_s18_q[6] & and_2911);
      and_2921_s19_q <= x_s18_q[6] & and_2920;
      other_s19_q <= other[44:36];
      select_3137_s19_q <= and_1957_s18_q ? {and_3136, xor_3135, parity_3129} : 3'h0;
      select_3152_s19_q <= select_3152_s18_q[44:36];
      xor_3167_s19_q <= xor_3167;
      xor_3185_s19_q <= xor_3167 ^ parity_3184;
      xor_3197_s19_q <= xor_3188 ^ (^{select_3152_s18_q[41:36], other[41:36]});
      xor_3209_s19_q <= xor_3200 ^ (^{select_3152_s18_q[23:18], other[23:18]});
      xor_3221_s19_q <= xor_3212 ^ (^{select_3152_s18_q[32:27], other[32:27]});
      or_3230_s19_q <= (xor_3161 & xor_3164) | (xor_3158 & (xor_3161 | xor_3164));
      or_3234_s19_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3238_s19_q <= (xor_3176 & xor_3179) | (xor_3173 & (xor_3176 | xor_3179));
      or_3245_s19_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3249_s19_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3253_s19_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3260_s19_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3264_s19_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3268_s19_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3278_s19_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3282_s19_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3286_s19_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3294_s19_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3298_s19_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3302_s19_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3309_s19_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3313_s19_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3317_s19_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3327_s19_q <= (xor_3191 & xor_3194) | (xor_3188 & (xor_3191 | xor_3194));
      or_3331_s19_q <= (xor_3203 & xor_3206) | (xor_3200 & (xor_3203 | xor_3206));
      or_3335_s19_q <= (xor_3215 & xor_3218) | (xor_3212 & (xor_3215 | xor_3218));
      and_3340_s19_q <= xor_3170 & xor_3182;
      or_3341_s19_q <= xor_3170 | xor_3182;
      equal_3462_s19_q <= equal_3462_s18_q;
      select_3550_s19_q <= select_3550_s18_q;
      select_3581_s19_q <= select_3581_s18_q[12:0];
      select_3591_s19_q <= select_3591;
      less_3624_s19_q <= less_3624_s18_q;
      not_3632_s19_q <= ~({eight_s18_q, 3'h0} < {3'h0, fall_2_s18_q});
      not_3635_s19_q <= ~({eight_s18_q, 3'h0} < {1'b0, sum_3633, fall_2_s18_q[0]});
      not_3639_s19_q <= ~({eight_s18_q, 3'h0} < {sum_3637, fall_2_s18_q[1:0]});
      not_3642_s19_q <= ~less_3641;
      select_3647_s19_q <= select_3647;
      sum_3648_s19_q <= sum_3648[0];
      sum_3650_s19_q <= sum_3650;
      equal_3702_s19_q <= equal_3702_s18_q;
      equal_3921_s19_q <= select_2644_s18_q[9:3] == 7'h0;
      or_3924_s19_q <= or_3924;
      select_3932_s19_q <= select_3932;
      not_3937_s19_q <= ~({sum_3935, select_2647_s18_q[0]} < {2'h0, select_2644_s18_q});
      equal_3946_s19_q <= equal_3946_s18_q;
      equal_3948_s19_q <= equal_3948_s18_q;
      equal_3949_s19_q <= equal_3949_s18_q;
      equal_3950_s19_q <= equal_3950_s18_q;
      equal_3951_s19_q <= equal_3951_s18_q;
      equal_4091_s19_q <= equal_4091_s18_q;
      select_4190_s19_q <= select_4190;
      select_4197_s19_q <= select_4197_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:456
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_q & whole_9_s19_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s19_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s19_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s19_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s19_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:272
  logic [10:0] sum_717;
  assign sum_717 = sum_713_s19_q + {1'b0, sum_716_s19_q};
  // hls/stages/agreement.hpp:456
  logic and_731;
  assign and_731 = census_columns_values_0_cell_2_mask_s19_q & census_columns_values_1_cell_2_mask_q;
  logic and_732;
  assign and_732 = and_680_s19_q & and_731;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1610_s19_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1663;
  assign select_1663 = equal_1661_s19_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1802;
  assign select_1802 = equal_1690_s19_q ? patches_place_0_valid_q : (select_1689_s19_q ? patches_place_0_valid_q : select_1800_s19_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1807;
  assign sum_1807 = sum_1806_s19_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1808;
  assign equal_1808 = {sum_1807[7], select_510_s19_q, select_507_s19_q} == {1'b0, sum_1807[6:0], 4'h8};
  // hls/stages/patches.hpp:127
  logic select_1831;
  assign select_1831 = equal_1690_s19_q ? patches_place_1_valid_q : (select_1689_s19_q ? select_1800_s19_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1836;
  assign sum_1836 = sum_1835_s19_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1837;
  assign equal_1837 = {sum_1836[7], select_510_s19_q, select_507_s19_q} == {1'b0, sum_1836[6:0], 4'h8};
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1275
  logic select_2051;
  assign select_2051 = marks_first_s19_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2052;
  assign sum_2052 = {1'b0, {5{select_2051}}, 1'b0, {2{select_2051}}, 1'b0, select_2051} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1111
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2063_s19_q[7]}}, sum_2063_s19_q, x_s19_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2065;
  assign sum_2065 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1094
  logic [4:0] t;
  assign t = {difference_2075_s19_q[3], difference_2075_s19_q} + (equal_566_s19_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic [47:0] select_2095;
  assign select_2095 = or_2083_s19_q ? {select_2094_s19_q[23], 1'b0, select_2094_s19_q[22], 1'b0, select_2094_s19_q[21], 1'b0, select_2094_s19_q[20], 1'b0, select_2094_s19_q[19], 1'b0, select_2094_s19_q[18], 1'b0, select_2094_s19_q[17], 1'b0, select_2094_s19_q[16], 1'b0, select_2094_s19_q[15], 1'b0, select_2094_s19_q[14], 1'b0, select_2094_s19_q[13], 1'b0, select_2094_s19_q[12], 1'b0, select_2094_s19_q[11], 1'b0, select_2094_s19_q[10], 1'b0, select_2094_s19_q[9], 1'b0, select_2094_s19_q[8], 1'b0, select_2094_s19_q[7], 1'b0, select_2094_s19_q[6], 1'b0, select_2094_s19_q[5], 1'b0, select_2094_s19_q[4], 1'b0, select_2094_s19_q[3], 1'b0, select_2094_s19_q[2], 1'b0, select_2094_s19_q[1], 1'b0, select_2094_s19_q[0], 1'b0} : {1'b0, select_2094_s19_q[23], 1'b0, select_2094_s19_q[22], 1'b0, select_2094_s19_q[21], 1'b0, select_2094_s19_q[20], 1'b0, select_2094_s19_q[19], 1'b0, select_2094_s19_q[18], 1'b0, select_2094_s19_q[17], 1'b0, select_2094_s19_q[16], 1'b0, select_2094_s19_q[15], 1'b0, select_2094_s19_q[14], 1'b0, select_2094_s19_q[13], 1'b0, select_2094_s19_q[12], 1'b0, select_2094_s19_q[11], 1'b0, select_2094_s19_q[10], 1'b0, select_2094_s19_q[9], 1'b0, select_2094_s19_q[8], 1'b0, select_2094_s19_q[7], 1'b0, select_2094_s19_q[6], 1'b0, select_2094_s19_q[5], 1'b0, select_2094_s19_q[4], 1'b0, select_2094_s19_q[3], 1'b0, select_2094_s19_q[2], 1'b0, select_2094_s19_q[1], 1'b0, select_2094_s19_q[0]};
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2112;
  assign sum_2112 = {1'b0, around_s19_q} + {2'h0, around_s19_q[4:1]};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size_s19_q} + (equal_549_s19_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2181;
  assign select_2181 = sample_pair_whole_s19_q ? (and_544_s19_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s19_q} + (equal_549_s19_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2189;
  assign select_2189 = sample_pair_whole_s19_q ? (and_544_s19_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:520
  logic select_2221;
  assign select_2221 = and_546_s19_q ? census_columns_values_0_cell_2_mask_s19_q : census_columns_values_1_cell_2_mask_q;
  logic select_2237;
  assign select_2237 = and_546_s19_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2240;
  assign select_2240 = and_546_s19_q ? census_columns_values_1_cell_3_mask_s19_q : census_columns_values_2_cell_3_mask_q;
  logic select_2243;
  assign select_2243 = and_546_s19_q ? census_columns_values_1_cell_4_mask_s19_q : census_columns_values_2_cell_4_mask_q;
  logic select_2244;
  assign select_2244 = and_546_s19_q ? census_columns_values_2_cell_0_mask_s19_q : census_columns_values_3_cell_0_mask_q;
  logic select_2247;
  assign select_2247 = and_546_s19_q ? census_columns_values_2_cell_1_mask_s19_q : census_columns_values_3_cell_1_mask_q;
  logic select_2248;
  assign select_2248 = and_546_s19_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2251;
  assign select_2251 = and_546_s19_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:274
  logic [10:0] sum_2264;
  assign sum_2264 = sum_2260_s19_q + {1'b0, sum_2263_s19_q};
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2304;
  assign sum_2304 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:520
  logic select_2361;
  assign select_2361 = and_546_s19_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2364;
  assign and_2364 = whole_2_s19_q & (~(last_s19_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2370;
  assign and_2370 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s19_q[8:2]));
  logic and_2371;
  assign and_2371 = and_2364 & and_2370;
  logic and_2382;
  assign and_2382 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s19_q[8:2]));
  logic and_2383;
  assign and_2383 = and_2364 & and_2382;
  // hls/stages/census.hpp:415
  logic not_2400;
  assign not_2400 = ~x_s19_q[1];
  logic [2:0] select_2401;
  assign select_2401 = x_s19_q[0] ? {1'b0, not_2400, 1'b0} : {x_s19_q[1], 1'b0, not_2400};
  logic [5:0] select_2402;
  assign select_2402 = slot_s19_q[2] ? {select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0], 1'b0} : {1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0]};
  logic [11:0] select_2403;
  assign select_2403 = slot_s19_q[1] ? {select_2402[5], 1'b0, select_2402[4], 1'b0, select_2402[3], 1'b0, select_2402[2], 1'b0, select_2402[1], 1'b0, select_2402[0], 1'b0} : {1'b0, select_2402[5], 1'b0, select_2402[4], 1'b0, select_2402[3], 1'b0, select_2402[2], 1'b0, select_2402[1], 1'b0, select_2402[0]};
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2631;
  assign sum_2631 = {1'b0, e_s19_q} + {2'h0, e_s19_q[4:1]};
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2648;
  assign sum_2648 = {1'b0, select_2647_s19_q} + {3'h0, select_2647_s19_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2774;
  assign sum_2774 = registration_half_across_q + {{6{select_2773_s19_q[7]}}, select_2773_s19_q};
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2786;
  assign sum_2786 = registration_half_votes_down_q + {{5{select_2785_s19_q[1]}}, select_2785_s19_q};
  logic [6:0] sum_2801;
  assign sum_2801 = registration_half_half_votes_down_q + {{5{select_2800_s19_q[1]}}, select_2800_s19_q};
  // hls/stages/agreement.hpp:788
  logic and_2842;
  assign and_2842 = equal_571_s19_q & (x_s19_q[6] & (not_1993_s19_q & less_1635_s19_q));
  logic [11:0] select_2853;
  assign select_2853 = equal_571_s19_q ? (x_s19_q[6] ? select_2851_s19_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2861;
  assign sum_2861 = {{2{select_2853[11]}}, select_2853} + (and_2859_s19_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2868;
  assign select_2868 = equal_571_s19_q ? (x_s19_q[6] ? select_2866_s19_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2870;
  assign sum_2870 = {{2{select_2868[11]}}, select_2868} + (and_2859_s19_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2882;
  assign not_2882 = ~and_2881_s19_q;
  logic less_2883;
  assign less_2883 = $signed({9'h1, {2{not_2882}}, and_2881_s19_q}) < $signed(registration_up_q[13:2]);
  logic select_2884;
  assign select_2884 = and_2877_s19_q ? less_2883 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2888;
  assign and_2888 = x_s19_q[6] & (not_1993_s19_q & (less_1635_s19_q & (x_s19_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2889;
  assign and_2889 = equal_571_s19_q & and_2888;
  // hls/stages/registration.hpp:242
  logic less_2890;
  assign less_2890 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2892;
  assign less_2892 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2894;
  assign equal_2894 = x_s19_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2898;
  assign and_2898 = equal_571_s19_q & (x_s19_q[6] & (not_1993_s19_q & (less_1635_s19_q & equal_2894)));
  // hls/stages/agreement.hpp:1142
  logic and_2905;
  assign and_2905 = x_s19_q[6] & (not_1993_s19_q & (less_1635_s19_q & (x_s19_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2923;
  assign and_2923 = registration_votes_up_q & registration_other_down_q;
  logic select_2925;
  assign select_2925 = registration_votes_down_q ? (registration_other_up_q | and_2923) : and_2923;
  // hls/stages/registration.hpp:138
  logic and_2927;
  assign and_2927 = (equal_571_s19_q & and_2921_s19_q) & (registration_other_enough_q & select_2925);
  logic and_2929;
  assign and_2929 = registration_enough_q & ((and_2913_s19_q & (less_2892 | less_2890)) | and_2927);
  // hls/stages/patches.hpp:184
  logic [2:0] select_3139;
  assign select_3139 = equal_1786_s19_q ? 3'h0 : (or_1790_s19_q ? select_3137_s19_q : 3'h0);
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3142;
  assign sum_3142 = {7'h0, patches_set_q} + (equal_1789_s19_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3222;
  assign xor_3222 = xor_3209_s19_q ^ xor_3221_s19_q;
  // hls/stages/count_bits.hpp:25
  logic or_3347;
  assign or_3347 = (xor_3209_s19_q & xor_3221_s19_q) | (xor_3197_s19_q & (xor_3209_s19_q | xor_3221_s19_q));
  // hls/stages/patches.hpp:583
  logic [1:0] sum_3636;
  assign sum_3636 = {1'b0, not_3632_s19_q} + {1'b0, not_3635_s19_q};
  // hls/stages/patches.hpp:584
  logic [1:0] sum_3643;
  assign sum_3643 = {1'b0, not_3639_s19_q} + {1'b0, not_3642_s19_q};
  // hls/stages/patches.hpp:583
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3636} + {1'b0, sum_3643};
  // hls/stages/patches.hpp:597
  logic [18:0] product_3651;
  assign product_3651 = $signed({{11{select_3647_s19_q[7]}}, select_3647_s19_q}) * $signed({{8{sum_3650_s19_q[6]}}, sum_3650_s19_q, sum_3648_s19_q, select_3581_s19_q[12:10]});
  // hls/stages/patches.hpp:605
  logic [11:0] sum_3826;
  assign sum_3826 = {sum_3650_s19_q[6], sum_3650_s19_q, sum_3648_s19_q, select_3581_s19_q[12:10]} + 12'h1;
  // hls/stages/agreement.hpp:1135
  logic select_3938;
  assign select_3938 = equal_3921_s19_q ? ((~or_3924_s19_q) & (~select_3932_s19_q)) : not_3937_s19_q;
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3940;
  assign select_3940 = x_s19_q[6] ? (equal_1604_s19_q ? good_q : {select_3938, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:1147
  logic equal_3943;
  assign equal_3943 = x_s19_q == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic [4:0] select_4022;
  assign select_4022 = so_s19_q ? (ends_cell_s19_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4094;
  assign select_4094 = equal_2468_s19_q ? (equal_4091_s19_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4097;
  assign select_4097 = and_546_s19_q ? (equal_2468_s19_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
      moments_most_before_q <= equal_571_s19_q ? select_2302_s19_q : moments_most_before_q;
      moments_left_alone_q <= equal_571_s19_q ? not_2310_s19_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_571_s19_q ? not_2313_s19_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_571_s19_q ? not_2320_s19_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_571_s19_q ? not_2323_s19_q : moments_right_other_stops_q;
      sharpness_before_last_mask_q <= select_2361;
      registration_half_across_q <= and_2753_s19_q ? 14'h0 : sum_2774;
      registration_half_votes_down_q <= and_2753_s19_q ? 7'h0 : sum_2786;
      registration_half_half_votes_down_q <= and_2753_s19_q ? 7'h0 : sum_2801;
      registration_down_q <= and_2842 ? sum_2861 : registration_down_q;
      registration_up_q <= and_2842 ? sum_2870 : registration_up_q;
      registration_enough_q <= select_2884;
      registration_votes_down_q <= and_2889 ? less_2890 : registration_votes_down_q;
      registration_votes_up_q <= and_2889 ? less_2892 : registration_votes_up_q;
      registration_other_enough_q <= and_2898 ? select_2884 : registration_other_enough_q;
      registration_other_down_q <= and_2898 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2898 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s19_q ? select_1802 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s19_q ? select_1831 : patches_place_1_valid_q;
      patches_set_q <= equal_1784_s19_q ? 3'h0 : select_3139;
      patches_size_q <= sum_3142;
      good_q <= equal_571_s19_q ? select_3940 : good_q;
      map_row_q <= and_546_s19_q ? select_4094 : map_row_q;
      map_width_q <= select_4097;
      write_half_q <= marks_first_s19_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2051;
      done_q <= not_2053_s19_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s19_q;
      said_q <= equal_571_s19_q & equal_3943;
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
    if (s19_en) begin
      averager_detail_0_q <= select_2181;
      averager_detail_1_q <= select_2189;
      census_columns_values_1_cell_2_mask_q <= select_2221;
      census_columns_values_2_cell_2_mask_q <= select_2237;
      census_columns_values_2_cell_3_mask_q <= select_2240;
      census_columns_values_2_cell_4_mask_q <= select_2243;
      census_columns_values_3_cell_0_mask_q <= select_2244;
      census_columns_values_3_cell_1_mask_q <= select_2247;
      census_columns_values_3_cell_2_mask_q <= select_2248;
      census_columns_values_3_cell_3_mask_q <= select_2251;
      sharpness_last_mask_q <= and_546_s19_q ? whole_2_s19_q : sharpness_last_mask_q;
      box_textured_sum_sums_values_0_q <= equal_571_s19_q ? box_textured_sum_sums_values_0_q : select_4022;
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
  logic census_columns_values_2_cell_4_mask_s20_q;
  logic census_columns_values_3_cell_0_mask_s20_q;
  logic census_columns_values_3_cell_1_mask_s20_q;
  logic census_columns_values_3_cell_2_mask_s20_q;
  logic census_columns_values_3_cell_3_mask_s20_q;
  logic moments_left_alone_s20_q;
  logic moments_left_other_stops_s20_q;
  logic moments_right_alone_s20_q;
  logic moments_right_other_stops_s20_q;
  logic [6:0] x_s20_q;
  logic slot_s20_q;
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
  logic [6:0] last_s20_q;
  logic and_546_s20_q;
  logic equal_571_s20_q;
  logic not_572_s20_q;
  logic less_649_s20_q;
  logic less_650_s20_q;
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
  logic and_680_s20_q;
  logic whole_16_s20_q;
  logic and_706_s20_q;
  logic [11:0] sum_721_s20_q;
  logic [9:0] sum_724_s20_q;
  logic and_732_s20_q;
  logic and_736_s20_q;
  logic less_737_s20_q;
  logic less_741_s20_q;
  logic less_743_s20_q;
  logic equal_1604_s20_q;
  logic [1:0] sum_1610_s20_q;
  logic equal_1612_s20_q;
  logic equal_1614_s20_q;
  logic equal_1616_s20_q;
  logic equal_1618_s20_q;
  logic equal_1620_s20_q;
  logic equal_1622_s20_q;
  logic [19:0] sum_1664_s20_q;
  logic [11:0] sum_1668_s20_q;
  logic and_1669_s20_q;
  logic and_1672_s20_q;
  logic select_1689_s20_q;
  logic equal_1690_s20_q;
  logic equal_1784_s20_q;
  logic equal_1786_s20_q;
  logic select_1800_s20_q;
  logic select_1802_s20_q;
  logic equal_1808_s20_q;
  logic [4:0] select_1814_s20_q;
  logic select_1820_s20_q;
  logic select_1831_s20_q;
  logic equal_1837_s20_q;
  logic or_1852_s20_q;
  logic or_1856_s20_q;
  logic [3:0] select_1859_s20_q;
  logic less_1963_s20_q;
  logic equal_1964_s20_q;
  logic not_1965_s20_q;
  logic equal_1966_s20_q;
  logic not_1993_s20_q;
  logic [2:0] index_s20_q;
  logic [10:0] sum_2052_s20_q;
  logic and_2059_s20_q;
  logic less_2060_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_2065_s20_q;
  logic equal_2078_s20_q;
  logic not_2098_s20_q;
  logic not_2114_s20_q;
  logic less_2128_s20_q;
  logic and_2139_s20_q;
  logic [11:0] sum_2268_s20_q;
  logic [9:0] sum_2271_s20_q;
  logic equal_2279_s20_q;
  logic equal_2294_s20_q;
  logic not_2306_s20_q;
  logic not_2316_s20_q;
  logic [27:0] select_2358_s20_q;
  logic and_2371_s20_q;
  logic and_2383_s20_q;
  logic [8:0] select_2390_s20_q;
  logic [8:0] select_2394_s20_q;
  logic equal_2397_s20_q;
  logic less_2398_s20_q;
  logic [11:0] select_2403_s20_q;
  logic equal_2441_s20_q;
  logic and_2593_s20_q;
  logic not_2618_s20_q;
  logic not_2633_s20_q;
  logic [9:0] select_2644_s20_q;
  logic [9:0] select_2647_s20_q;
  logic less_2649_s20_q;
  logic and_2695_s20_q;
  logic equal_2894_s20_q;
  logic not_2907_s20_q;
  logic and_2929_s20_q;
  logic parity_3226_s20_q;
  logic or_3230_s20_q;
  logic or_3234_s20_q;
  logic or_3238_s20_q;
  logic or_3245_s20_q;
  logic or_3249_s20_q;
  logic or_3253_s20_q;
  logic or_3260_s20_q;
  logic or_3264_s20_q;
  logic or_3268_s20_q;
  logic or_3278_s20_q;
  logic or_3282_s20_q;
  logic or_3286_s20_q;
  logic or_3294_s20_q;
  logic or_3298_s20_q;
  logic or_3302_s20_q;
  logic or_3309_s20_q;
  logic or_3313_s20_q;
  logic or_3317_s20_q;
  logic or_3327_s20_q;
  logic or_3331_s20_q;
  logic or_3335_s20_q;
  logic and_3339_s20_q;
  logic or_3343_s20_q;
  logic or_3347_s20_q;
  logic equal_3462_s20_q;
  logic [4:0] select_3550_s20_q;
  logic [9:0] select_3581_s20_q;
  logic [9:0] select_3591_s20_q;
  logic less_3624_s20_q;
  logic [2:0] fraction_s20_q;
  logic [13:0] product_3651_s20_q;
  logic equal_3702_s20_q;
  logic less_3827_s20_q;
  logic or_3924_s20_q;
  logic select_3932_s20_q;
  logic equal_3943_s20_q;
  logic equal_3946_s20_q;
  logic equal_3948_s20_q;
  logic equal_3949_s20_q;
  logic equal_3950_s20_q;
  logic equal_3951_s20_q;
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
      sample_pair_whole_s20_q <= sample_pair_whole_s19_q;
      sample_present_s20_q <= sample_present_s19_q;
      census_columns_values_1_cell_2_of_skin_s20_q <= census_columns_values_1_cell_2_of_skin_s19_q;
      census_columns_values_2_cell_4_mask_s20_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s20_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s20_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s20_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s20_q <= census_columns_values_3_cell_3_mask_q;
      moments_left_alone_s20_q <= moments_left_alone_q;
      moments_left_other_stops_s20_q <= moments_left_other_stops_q;
      moments_right_alone_s20_q <= moments_right_alone_q;
      moments_right_other_stops_s20_q <= moments_right_other_stops_q;
      x_s20_q <= x_s19_q;
      slot_s20_q <= slot_s19_q[0];
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
      last_s20_q <= last_s19_q;
      and_546_s20_q <= and_546_s19_q;
      equal_571_s20_q <= equal_571_s19_q;
      not_572_s20_q <= not_572_s19_q;
      less_649_s20_q <= less_649_s19_q;
      less_650_s20_q <= less_650_s19_q;
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
      and_680_s20_q <= and_680_s19_q;
      whole_16_s20_q <= whole_16;
      and_706_s20_q <= census_columns_values_1_cell_2_mask_q & and_680_s19_q;
      sum_721_s20_q <= {1'b0, sum_717} + {2'h0, sum_720_s19_q};
      sum_724_s20_q <= sum_724_s19_q;
      and_732_s20_q <= and_732;
      and_736_s20_q <= and_732 & less_735_s19_q;
      less_737_s20_q <= less_737_s19_q;
      less_741_s20_q <= less_741_s19_q;
      less_743_s20_q <= less_743_s19_q;
      equal_1604_s20_q <= equal_1604_s19_q;
      sum_1610_s20_q <= sum_1610_s19_q;
      equal_1612_s20_q <= equal_1612_s19_q;
      equal_1614_s20_q <= equal_1614_s19_q;
      equal_1616_s20_q <= equal_1616_s19_q;
      equal_1618_s20_q <= equal_1618_s19_q;
      equal_1620_s20_q <= equal_1620_s19_q;
      equal_1622_s20_q <= equal_1622_s19_q;
      sum_1664_s20_q <= select_1660_s19_q + {{6{select_1663[13]}}, select_1663};
      sum_1668_s20_q <= sum_1668_s19_q;
      and_1669_s20_q <= and_1669_s19_q;
      and_1672_s20_q <= and_1672_s19_q;
      select_1689_s20_q <= select_1689_s19_q;
      equal_1690_s20_q <= equal_1690_s19_q;
      equal_1784_s20_q <= equal_1784_s19_q;
      equal_1786_s20_q <= equal_1786_s19_q;
      select_1800_s20_q <= select_1800_s19_q;
      select_1802_s20_q <= select_1802;
      equal_1808_s20_q <= equal_1808;
      select_1814_s20_q <= select_1814_s19_q;
      select_1820_s20_q <= select_1820_s19_q;
      select_1831_s20_q <= select_1831;
      equal_1837_s20_q <= equal_1837;
      or_1852_s20_q <= and_1672_s19_q | (select_1802 & equal_1850_s19_q);
      or_1856_s20_q <= and_1672_s19_q | (select_1831 & equal_1854_s19_q);
      select_1859_s20_q <= select_1859_s19_q;
      less_1963_s20_q <= less_1963_s19_q;
      equal_1964_s20_q <= equal_1964_s19_q;
      not_1965_s20_q <= not_1965_s19_q;
      equal_1966_s20_q <= equal_1966_s19_q;
      not_1993_s20_q <= not_1993_s19_q;
      index_s20_q <= index[2:0];
      sum_2052_s20_q <= sum_2052;
      and_2059_s20_q <= began_q & (seen_x_q == 4'h0);
      less_2060_s20_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s20_q <= index_2[2:0];
      sum_2065_s20_q <= sum_2065;
      equal_2078_s20_q <= t[4:1] == 4'h0;
      not_2098_s20_q <= ~((good_q & select_2095) == 48'h0);
      not_2114_s20_q <= ~({sum_2112, around_s19_q[0]} < {2'h0, t});
      less_2128_s20_q <= less_2128_s19_q;
      and_2139_s20_q <= and_2139_s19_q;
      sum_2268_s20_q <= {1'b0, sum_2264} + {2'h0, sum_2267_s19_q};
      sum_2271_s20_q <= sum_2271_s19_q;
      equal_2279_s20_q <= equal_2279_s19_q;
      equal_2294_s20_q <= equal_2294_s19_q;
      not_2306_s20_q <= ~({3'h0, counts_turned_left_s19_q} < sum_2304);
      not_2316_s20_q <= ~({3'h0, counts_turned_right_s19_q} < sum_2304);
      select_2358_s20_q <= sample_pair_whole_s19_q ? {detail_2, detail} : 28'h0;
      and_2371_s20_q <= and_2371;
      and_2383_s20_q <= and_2383;
      select_2390_s20_q <= and_2371 ? contrast_s19_q : 9'h0;
      select_2394_s20_q <= and_2383 ? contrast_2_s19_q : 9'h0;
      equal_2397_s20_q <= equal_2397_s19_q;
      less_2398_s20_q <= 7'h2 < {x_s19_q[4:0], slot_s19_q[2:1]};
      select_2403_s20_q <= select_2403;
      equal_2441_s20_q <= {x_s19_q[4:0], slot_s19_q} == 8'h0;
      and_2593_s20_q <= and_2593_s19_q;
      not_2618_s20_q <= not_2618_s19_q;
      not_2633_s20_q <= ~({sum_2631, e_s19_q[0]} < {2'h0, t});
      select_2644_s20_q <= select_2644_s19_q;
      select_2647_s20_q <= select_2647_s19_q;
      less_2649_s20_q <= {sum_2648, select_2647_s19_q[1:0]} < {3'h0, select_2644_s19_q};
      and_2695_s20_q <= and_2695_s19_q;
      equal_2894_s20_q <= equal_2894;
      not_2907_s20_q <= ~(equal_571_s19_q & and_2905);
      and_2929_s20_q <= and_2929;
      parity_3226_s20_q <= ^{xor_3222, xor_3185_s19_q, select_3152_s19_q, other_s19_q};
      or_3230_s20_q <= or_3230_s19_q;
      or_3234_s20_q <= or_3234_s19_q;
      or_3238_s20_q <= or_3238_s19_q;
      or_3245_s20_q <= or_3245_s19_q;
      or_3249_s20_q <= or_3249_s19_q;
      or_3253_s20_q <= or_3253_s19_q;
      or_3260_s20_q <= or_3260_s19_q;
      or_3264_s20_q <= or_3264_s19_q;
      or_3268_s20_q <= or_3268_s19_q;
      or_3278_s20_q <= or_3278_s19_q;
      or_3282_s20_q <= or_3282_s19_q;
      or_3286_s20_q <= or_3286_s19_q;
      or_3294_s20_q <= or_3294_s19_q;
      or_3298_s20_q <= or_3298_s19_q;
      or_3302_s20_q <= or_3302_s19_q;
      or_3309_s20_q <= or_3309_s19_q;
      or_3313_s20_q <= or_3313_s19_q;
      or_3317_s20_q <= or_3317_s19_q;
      or_3327_s20_q <= or_3327_s19_q;
      or_3331_s20_q <= or_3331_s19_q;
      or_3335_s20_q <= or_3335_s19_q;
      and_3339_s20_q <= xor_3185_s19_q & (^{xor_3222, select_3152_s19_q, other_s19_q});
      or_3343_s20_q <= and_3340_s19_q | (xor_3167_s19_q & or_3341_s19_q);
      or_3347_s20_q <= or_3347;
      equal_3462_s20_q <= equal_3462_s19_q;
      select_3550_s20_q <= select_3550_s19_q;
      select_3581_s20_q <= select_3581_s19_q[9:0];
      select_3591_s20_q <= select_3591_s19_q;
      less_3624_s20_q <= less_3624_s19_q;
      fraction_s20_q <= fraction;
      product_3651_s20_q <= product_3651[18:5];
      equal_3702_s20_q <= equal_3702_s19_q;
      less_3827_s20_q <= {{4{sum_3826[11]}}, sum_3826} < 16'h3;
      or_3924_s20_q <= or_3924_s19_q;
      select_3932_s20_q <= select_3932_s19_q;
      equal_3943_s20_q <= equal_3943;
      equal_3946_s20_q <= equal_3946_s19_q;
      equal_3948_s20_q <= equal_3948_s19_q;
      equal_3949_s20_q <= equal_3949_s19_q;
      equal_3950_s20_q <= equal_3950_s19_q;
      equal_3951_s20_q <= equal_3951_s19_q;
      select_4190_s20_q <= select_4190_s19_q;
      select_4197_s20_q <= select_4197_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
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
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic good_known_q;
  // hls/stages/agreement.hpp:456
  logic whole_17;
  assign whole_17 = census_columns_values_2_cell_4_mask_s20_q & whole_16_s20_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s20_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s20_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s20_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s20_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:272
  logic [11:0] texture;
  assign texture = sum_721_s20_q + {2'h0, sum_724_s20_q};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1853;
  assign select_1853 = or_1852_s20_q ? {and_1672_s20_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1857;
  assign select_1857 = or_1856_s20_q ? {and_1672_s20_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_4;
  assign column_4 = select_1853[4] ? select_1857[3:0] : select_1853[3:0];
  logic and_1862;
  assign and_1862 = select_1820_s20_q & (select_1814_s20_q[3] ^ select_1814_s20_q[4]);
  logic and_1867;
  assign and_1867 = sample_pair_whole_s20_q & (and_1862 & ((~select_1853[4]) | (~select_1857[4])));
  // hls/stages/agreement.hpp:1030
  logic and_2099;
  assign and_2099 = good_known_q & not_2098_s20_q;
  // hls/stages/agreement.hpp:1103
  logic is_seen;
  assign is_seen = equal_2078_s20_q ? and_2099 : not_2114_s20_q;
  // hls/stages/agreement.hpp:520
  logic select_2252;
  assign select_2252 = and_546_s20_q ? census_columns_values_2_cell_4_mask_s20_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2272;
  assign sum_2272 = sum_2268_s20_q + {2'h0, sum_2271_s20_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2274;
  assign select_2274 = and_546_s20_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2275;
  assign select_2275 = and_546_s20_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:94
  logic and_2341;
  assign and_2341 = moments_right_alone_s20_q & (moments_right_begins_q | moments_right_other_stops_s20_q);
  logic or_2343;
  assign or_2343 = moments_left_begins_q | (moments_left_other_stops_s20_q | and_2341);
  logic and_2345;
  assign and_2345 = cfg_same_table_i & (moments_left_alone_s20_q ? or_2343 : and_2341);
  // hls/stages/moments.hpp:95
  logic and_2351;
  assign and_2351 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/agreement.hpp:520
  logic [13:0] select_2359;
  assign select_2359 = and_546_s20_q ? select_2358_s20_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2360;
  assign select_2360 = and_546_s20_q ? select_2358_s20_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2358_s20_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2358_s20_q[27:14]};
  // hls/stages/census.hpp:363
  logic [23:0] sum_2391;
  assign sum_2391 = (equal_2279_s20_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2390_s20_q};
  logic [23:0] sum_2395;
  assign sum_2395 = (equal_2279_s20_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2394_s20_q};
  // hls/stages/census.hpp:415
  logic less_2399;
  assign less_2399 = x_s20_q[4:0] < 5'h3;
  logic [23:0] select_2404;
  assign select_2404 = slot_s20_q ? {select_2403_s20_q[11], 1'b0, select_2403_s20_q[10], 1'b0, select_2403_s20_q[9], 1'b0, select_2403_s20_q[8], 1'b0, select_2403_s20_q[7], 1'b0, select_2403_s20_q[6], 1'b0, select_2403_s20_q[5], 1'b0, select_2403_s20_q[4], 1'b0, select_2403_s20_q[3], 1'b0, select_2403_s20_q[2], 1'b0, select_2403_s20_q[1], 1'b0, select_2403_s20_q[0], 1'b0} : {1'b0, select_2403_s20_q[11], 1'b0, select_2403_s20_q[10], 1'b0, select_2403_s20_q[9], 1'b0, select_2403_s20_q[8], 1'b0, select_2403_s20_q[7], 1'b0, select_2403_s20_q[6], 1'b0, select_2403_s20_q[5], 1'b0, select_2403_s20_q[4], 1'b0, select_2403_s20_q[3], 1'b0, select_2403_s20_q[2], 1'b0, select_2403_s20_q[1], 1'b0, select_2403_s20_q[0]};
  // hls/stages/census.hpp:378
  logic and_2408;
  assign and_2408 = less_2399 & (~((sharpness_sums_contrast_1_q & select_2404) == 24'h0));
  logic and_2418;
  assign and_2418 = less_2399 & (~((sharpness_sums_contrast_0_q & select_2404) == 24'h0));
  // hls/stages/agreement.hpp:1106
  logic not_2635;
  assign not_2635 = ~(equal_2078_s20_q ? and_2099 : not_2633_s20_q);
  // hls/stages/agreement.hpp:788
  logic and_2638;
  assign and_2638 = ends_cell_s20_q & (not_2618_s20_q & (centres_values_1_textured_s20_q & not_2635));
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_2651;
  assign select_2651 = ((~(select_2644_s20_q[9:4] == 6'h0)) & less_2649_s20_q) ? select_2644_s20_q : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2654;
  assign select_2654 = equal_571_s20_q ? (x_s20_q[6] ? (equal_1604_s20_q ? 10'h0 : select_2651) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1110
  logic and_2672;
  assign and_2672 = centres_values_1_textured_s20_q & (centres_values_1_of_skin_s20_q & not_2635);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3039;
  assign select_3039 = sample_pair_whole_s20_q ? (select_1853[4] ? {1'b1, select_1853[3:0]} : (select_1853 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3042;
  assign select_3042 = sample_pair_whole_s20_q ? (select_1857[4] ? {1'b1, select_1857[3:0]} : (select_1857 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3256;
  assign parity_3256 = ^{or_3253_s20_q, or_3249_s20_q, or_3245_s20_q};
  logic parity_3271;
  assign parity_3271 = ^{or_3268_s20_q, or_3264_s20_q, or_3260_s20_q};
  logic parity_3274;
  assign parity_3274 = ^{or_3268_s20_q, or_3264_s20_q, or_3260_s20_q, or_3253_s20_q, or_3249_s20_q, or_3245_s20_q, or_3238_s20_q, or_3234_s20_q, or_3230_s20_q};
  logic parity_3305;
  assign parity_3305 = ^{or_3302_s20_q, or_3298_s20_q, or_3294_s20_q};
  logic parity_3320;
  assign parity_3320 = ^{or_3317_s20_q, or_3313_s20_q, or_3309_s20_q};
  logic parity_3323;
  assign parity_3323 = ^{or_3317_s20_q, or_3313_s20_q, or_3309_s20_q, or_3302_s20_q, or_3298_s20_q, or_3294_s20_q, or_3286_s20_q, or_3282_s20_q, or_3278_s20_q};
  logic parity_3338;
  assign parity_3338 = ^{or_3335_s20_q, or_3331_s20_q, or_3327_s20_q};
  logic parity_3350;
  assign parity_3350 = ^{or_3347_s20_q, or_3343_s20_q, and_3339_s20_q};
  logic parity_3353;
  assign parity_3353 = ^{or_3347_s20_q, or_3343_s20_q, and_3339_s20_q, or_3335_s20_q, or_3331_s20_q, or_3327_s20_q, or_3317_s20_q, or_3313_s20_q, or_3309_s20_q, or_3302_s20_q, or_3298_s20_q, or_3294_s20_q, or_3286_s20_q, or_3282_s20_q, or_3278_s20_q};
  logic parity_3355;
  assign parity_3355 = ^{or_3347_s20_q, or_3343_s20_q, and_3339_s20_q, or_3335_s20_q, or_3331_s20_q, or_3327_s20_q, or_3317_s20_q, or_3313_s20_q, or_3309_s20_q, or_3302_s20_q, or_3298_s20_q, or_3294_s20_q, or_3286_s20_q, or_3282_s20_q, or_3278_s20_q, or_3268_s20_q, or_3264_s20_q, or_3260_s20_q, or_3253_s20_q, or_3249_s20_q, or_3245_s20_q, or_3238_s20_q, or_3234_s20_q, or_3230_s20_q};
  // hls/stages/count_bits.hpp:25
  logic and_3356;
  assign and_3356 = parity_3274 & parity_3353;
  logic and_3359;
  assign and_3359 = (^{or_3238_s20_q, or_3234_s20_q, or_3230_s20_q}) & (parity_3256 | parity_3271);
  logic or_3360;
  assign or_3360 = (parity_3256 & parity_3271) | and_3359;
  logic or_3364;
  assign or_3364 = (parity_3338 & parity_3350) | (parity_3323 & (parity_3338 | parity_3350));
  logic and_3370;
  assign and_3370 = (^{or_3286_s20_q, or_3282_s20_q, or_3278_s20_q}) & (parity_3305 | parity_3320);
  logic or_3371;
  assign or_3371 = (parity_3305 & parity_3320) | and_3370;
  logic or_3375;
  assign or_3375 = (or_3331_s20_q & or_3335_s20_q) | (or_3327_s20_q & (or_3331_s20_q | or_3335_s20_q));
  logic or_3379;
  assign or_3379 = (or_3343_s20_q & or_3347_s20_q) | (and_3339_s20_q & (or_3343_s20_q | or_3347_s20_q));
  // hls/stages/count_bits.hpp:23
  logic or_3386;
  assign or_3386 = (or_3282_s20_q & or_3286_s20_q) | (or_3278_s20_q & (or_3282_s20_q | or_3286_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3390;
  assign or_3390 = (or_3298_s20_q & or_3302_s20_q) | (or_3294_s20_q & (or_3298_s20_q | or_3302_s20_q));
  logic or_3394;
  assign or_3394 = (or_3313_s20_q & or_3317_s20_q) | (or_3309_s20_q & (or_3313_s20_q | or_3317_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3397;
  assign parity_3397 = ^{or_3394, or_3390, or_3386};
  // hls/stages/count_bits.hpp:23
  logic or_3401;
  assign or_3401 = (or_3234_s20_q & or_3238_s20_q) | (or_3230_s20_q & (or_3234_s20_q | or_3238_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3405;
  assign or_3405 = (or_3249_s20_q & or_3253_s20_q) | (or_3245_s20_q & (or_3249_s20_q | or_3253_s20_q));
  logic or_3409;
  assign or_3409 = (or_3264_s20_q & or_3268_s20_q) | (or_3260_s20_q & (or_3264_s20_q | or_3268_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3412;
  assign parity_3412 = ^{or_3409, or_3405, or_3401};
  logic parity_3415;
  assign parity_3415 = ^{or_3409, or_3405, or_3401, or_3394, or_3390, or_3386, or_3379, or_3375, or_3371};
  // hls/stages/patches.hpp:594
  logic [9:0] difference_3594;
  assign difference_3594 = select_3591_s20_q - select_3581_s20_q;
  // hls/stages/patches.hpp:599
  logic or_3601;
  assign or_3601 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3581_s20_q);
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3625;
  assign sum_3625 = select_3550_s20_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:586
  logic [7:0] difference_3645;
  assign difference_3645 = {sum_3625, select_3550_s20_q[2:0], 3'h0} - {5'h0, fraction_s20_q};
  logic [7:0] select_3646;
  assign select_3646 = less_3624_s20_q ? difference_3645 : {sum_3625, select_3550_s20_q[2:0], fraction_s20_q};
  // hls/stages/agreement.hpp:788
  logic select_3945;
  assign select_3945 = equal_571_s20_q ? ((x_s20_q[6] & good_known_q) | equal_3943_s20_q) : good_known_q;
  // hls/stages/agreement.hpp:1308
  logic and_4120;
  assign and_4120 = and_2139_s20_q & ({sum_2065_s20_q, index_2_s20_q} == {sum_2052_s20_q, index_s20_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1409; read in stage 20, written in stage 21: 20 < 21 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2052_s20_q, index_s20_q};
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s20_en & (and_2059_s20_q & less_2060_s20_q);
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1610_s20_q, lower_half_s20_q, registration_of_right_s20_q};
  logic registration_sums_we;
  assign registration_sums_we = s20_en & and_1669_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1668_s20_q, sum_1664_s20_q};
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
      moments_left_begins_q <= 1'b0;
      moments_right_begins_q <= 1'b0;
      moments_ends_q <= 1'b0;
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      registration_moved_q <= 1'b0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      good_known_q <= 1'b0;
    end else if (s20_en) begin
      moments_left_begins_q <= equal_571_s20_q ? not_2306_s20_q : moments_left_begins_q;
      moments_right_begins_q <= equal_571_s20_q ? not_2316_s20_q : moments_right_begins_q;
      moments_ends_q <= equal_571_s20_q & (equal_2294_s20_q & (not_2349 | and_2351));
      sharpness_sums_contrast_0_q <= and_546_s20_q ? sum_2391 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_546_s20_q ? sum_2395 : sharpness_sums_contrast_1_q;
      registration_moved_q <= not_2907_s20_q & (registration_moved_q | and_2929_s20_q);
      patches_left_next_0_q <= select_3039;
      patches_left_next_1_q <= select_3042;
      good_known_q <= select_3945;
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
    if (s20_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2252;
      census_changes_values_0_left_q <= and_546_s20_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_546_s20_q ? sum_2272 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2274;
      census_changes_values_1_right_q <= select_2275;
      sharpness_last_detail_0_q <= select_2359;
      sharpness_last_detail_1_q <= select_2360;
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
  logic [11:0] census_changes_values_1_left_s21_q;
  logic [11:0] census_changes_values_1_right_s21_q;
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
  logic [6:0] last_s21_q;
  logic and_546_s21_q;
  logic equal_571_s21_q;
  logic not_572_s21_q;
  logic so_s21_q;
  logic less_649_s21_q;
  logic less_650_s21_q;
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
  logic and_680_s21_q;
  logic and_705_s21_q;
  logic and_706_s21_q;
  logic [12:0] sum_726_s21_q;
  logic and_732_s21_q;
  logic and_736_s21_q;
  logic less_737_s21_q;
  logic less_741_s21_q;
  logic less_743_s21_q;
  logic equal_1604_s21_q;
  logic equal_1612_s21_q;
  logic equal_1614_s21_q;
  logic equal_1616_s21_q;
  logic equal_1618_s21_q;
  logic equal_1620_s21_q;
  logic equal_1622_s21_q;
  logic and_1672_s21_q;
  logic select_1689_s21_q;
  logic equal_1690_s21_q;
  logic equal_1784_s21_q;
  logic equal_1786_s21_q;
  logic select_1800_s21_q;
  logic or_1810_s21_q;
  logic [4:0] select_1814_s21_q;
  logic select_1820_s21_q;
  logic or_1839_s21_q;
  logic [3:0] column_4_s21_q;
  logic [3:0] select_1859_s21_q;
  logic select_1860_s21_q;
  logic and_1867_s21_q;
  logic less_1963_s21_q;
  logic equal_1964_s21_q;
  logic not_1965_s21_q;
  logic equal_1966_s21_q;
  logic not_1993_s21_q;
  logic and_2059_s21_q;
  logic less_2060_s21_q;
  logic [2:0] index_2_s21_q;
  logic [10:0] sum_2065_s21_q;
  logic is_seen_s21_q;
  logic and_2129_s21_q;
  logic and_2139_s21_q;
  logic equal_2279_s21_q;
  logic [12:0] sum_2280_s21_q;
  logic equal_2294_s21_q;
  logic not_2325_s21_q;
  logic and_2346_s21_q;
  logic [12:0] select_2373_s21_q;
  logic [12:0] select_2385_s21_q;
  logic equal_2397_s21_q;
  logic less_2398_s21_q;
  logic and_2408_s21_q;
  logic and_2418_s21_q;
  logic equal_2441_s21_q;
  logic and_2593_s21_q;
  logic and_2640_s21_q;
  logic [9:0] select_2644_s21_q;
  logic [9:0] select_2647_s21_q;
  logic [9:0] select_2654_s21_q;
  logic and_2675_s21_q;
  logic and_2695_s21_q;
  logic equal_2894_s21_q;
  logic parity_3226_s21_q;
  logic parity_3355_s21_q;
  logic and_3356_s21_q;
  logic or_3360_s21_q;
  logic or_3364_s21_q;
  logic or_3371_s21_q;
  logic or_3375_s21_q;
  logic or_3379_s21_q;
  logic or_3386_s21_q;
  logic or_3390_s21_q;
  logic or_3394_s21_q;
  logic or_3401_s21_q;
  logic or_3405_s21_q;
  logic or_3409_s21_q;
  logic parity_3415_s21_q;
  logic or_3425_s21_q;
  logic or_3429_s21_q;
  logic and_3436_s21_q;
  logic and_3438_s21_q;
  logic and_3440_s21_q;
  logic equal_3462_s21_q;
  logic equal_3593_s21_q;
  logic less_3595_s21_q;
  logic less_3596_s21_q;
  logic or_3601_s21_q;
  logic [7:0] select_3646_s21_q;
  logic [13:0] product_3651_s21_q;
  logic equal_3702_s21_q;
  logic less_3827_s21_q;
  logic or_3924_s21_q;
  logic select_3932_s21_q;
  logic equal_3943_s21_q;
  logic equal_3946_s21_q;
  logic equal_3948_s21_q;
  logic equal_3949_s21_q;
  logic equal_3950_s21_q;
  logic equal_3951_s21_q;
  logic and_4105_s21_q;
  logic and_4120_s21_q;
  logic [31:0] select_4190_s21_q;
  logic [9:0] select_4197_s21_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      census_changes_values_1_left_s21_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s21_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s21_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s21_q <= sharpness_sums_contrast_1_q;
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
      last_s21_q <= last_s20_q;
      and_546_s21_q <= and_546_s20_q;
      equal_571_s21_q <= equal_571_s20_q;
      not_572_s21_q <= not_572_s20_q;
      so_s21_q <= drew_q;
      less_649_s21_q <= less_649_s20_q;
      less_650_s21_q <= less_650_s20_q;
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
      and_680_s21_q <= and_680_s20_q;
      and_705_s21_q <= whole_22 & and_680_s20_q;
      and_706_s21_q <= and_706_s20_q;
      sum_726_s21_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_732_s21_q <= and_732_s20_q;
      and_736_s21_q <= and_736_s20_q;
      less_737_s21_q <= less_737_s20_q;
      less_741_s21_q <= less_741_s20_q;
      less_743_s21_q <= less_743_s20_q;
      equal_1604_s21_q <= equal_1604_s20_q;
      equal_1612_s21_q <= equal_1612_s20_q;
      equal_1614_s21_q <= equal_1614_s20_q;
      equal_1616_s21_q <= equal_1616_s20_q;
      equal_1618_s21_q <= equal_1618_s20_q;
      equal_1620_s21_q <= equal_1620_s20_q;
      equal_1622_s21_q <= equal_1622_s20_q;
      and_1672_s21_q <= and_1672_s20_q;
      select_1689_s21_q <= select_1689_s20_q;
      equal_1690_s21_q <= equal_1690_s20_q;
      equal_1784_s21_q <= equal_1784_s20_q;
      equal_1786_s21_q <= equal_1786_s20_q;
      select_1800_s21_q <= select_1800_s20_q;
      or_1810_s21_q <= and_1672_s20_q | (select_1802_s20_q & equal_1808_s20_q);
      select_1814_s21_q <= select_1814_s20_q;
      select_1820_s21_q <= select_1820_s20_q;
      or_1839_s21_q <= and_1672_s20_q | (select_1831_s20_q & equal_1837_s20_q);
      column_4_s21_q <= column_4;
      select_1859_s21_q <= select_1859_s20_q;
      select_1860_s21_q <= or_1852_s20_q ? and_1672_s20_q : patches_left_next_0_q[4];
      and_1867_s21_q <= and_1867;
      less_1963_s21_q <= less_1963_s20_q;
      equal_1964_s21_q <= equal_1964_s20_q;
      not_1965_s21_q <= not_1965_s20_q;
      equal_1966_s21_q <= equal_1966_s20_q;
      not_1993_s21_q <= not_1993_s20_q;
      and_2059_s21_q <= and_2059_s20_q;
      less_2060_s21_q <= less_2060_s20_q;
      index_2_s21_q <= index_2_s20_q;
      sum_2065_s21_q <= sum_2065_s20_q;
      is_seen_s21_q <= is_seen;
      and_2129_s21_q <= is_seen & less_2128_s20_q;
      and_2139_s21_q <= and_2139_s20_q;
      equal_2279_s21_q <= equal_2279_s20_q;
      sum_2280_s21_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2272};
      equal_2294_s21_q <= equal_2294_s20_q;
      not_2325_s21_q <= ~moments_ends_q;
      and_2346_s21_q <= cfg_prove_i & and_2345;
      select_2373_s21_q <= and_2371_s20_q ? detail_3[14:2] : 13'h0;
      select_2385_s21_q <= and_2383_s20_q ? detail_4[14:2] : 13'h0;
      equal_2397_s21_q <= equal_2397_s20_q;
      less_2398_s21_q <= less_2398_s20_q;
      and_2408_s21_q <= and_2408;
      and_2418_s21_q <= and_2418;
      equal_2441_s21_q <= equal_2441_s20_q;
      and_2593_s21_q <= and_2593_s20_q;
      and_2640_s21_q <= not_572_s20_q & (drew_q & and_2638);
      select_2644_s21_q <= select_2644_s20_q;
      select_2647_s21_q <= select_2647_s20_q;
      select_2654_s21_q <= select_2654;
      and_2675_s21_q <= drew_q & (ends_cell_s20_q & (not_2618_s20_q & and_2672));
      and_2695_s21_q <= and_2695_s20_q;
      equal_2894_s21_q <= equal_2894_s20_q;
      parity_3226_s21_q <= parity_3226_s20_q;
      parity_3355_s21_q <= parity_3355;
      and_3356_s21_q <= and_3356;
      or_3360_s21_q <= or_3360;
      or_3364_s21_q <= or_3364;
      or_3371_s21_q <= or_3371;
      or_3375_s21_q <= or_3375;
      or_3379_s21_q <= or_3379;
      or_3386_s21_q <= or_3386;
      or_3390_s21_q <= or_3390;
      or_3394_s21_q <= or_3394;
      or_3401_s21_q <= or_3401;
      or_3405_s21_q <= or_3405;
      or_3409_s21_q <= or_3409;
      parity_3415_s21_q <= parity_3415;
      or_3425_s21_q <= (or_3390 & or_3394) | (or_3386 & (or_3390 | or_3394));
      or_3429_s21_q <= (or_3405 & or_3409) | (or_3401 & (or_3405 | or_3409));
      and_3436_s21_q <= and_3356 & (or_3360 | or_3364);
      and_3438_s21_q <= parity_3397 & parity_3412;
      and_3440_s21_q <= (^{or_3379, or_3375, or_3371}) & (parity_3397 | parity_3412);
      equal_3462_s21_q <= equal_3462_s20_q;
      equal_3593_s21_q <= select_3550_s20_q[3:0] == 4'h0;
      less_3595_s21_q <= {difference_3594, 3'h0} < {3'h0, patches_size_q};
      less_3596_s21_q <= select_3591_s20_q < select_3581_s20_q;
      or_3601_s21_q <= or_3601;
      select_3646_s21_q <= select_3646;
      product_3651_s21_q <= product_3651_s20_q;
      equal_3702_s21_q <= equal_3702_s20_q;
      less_3827_s21_q <= less_3827_s20_q;
      or_3924_s21_q <= or_3924_s20_q;
      select_3932_s21_q <= select_3932_s20_q;
      equal_3943_s21_q <= equal_3943_s20_q;
      equal_3946_s21_q <= equal_3946_s20_q;
      equal_3948_s21_q <= equal_3948_s20_q;
      equal_3949_s21_q <= equal_3949_s20_q;
      equal_3950_s21_q <= equal_3950_s20_q;
      equal_3951_s21_q <= equal_3951_s20_q;
      and_4105_s21_q <= said_q;
      and_4120_s21_q <= and_4120;
      select_4190_s21_q <= select_4190_s20_q;
      select_4197_s21_q <= select_4197_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
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
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic proven_q;
  // hls/stages/census.hpp:283
  logic [13:0] sum_727;
  assign sum_727 = {2'h0, census_changes_values_1_left_s21_q} + {1'b0, sum_726_s21_q};
  logic [13:0] sum_728;
  assign sum_728 = {2'h0, census_changes_values_2_left_q} + sum_727;
  // hls/stages/patches.hpp:133
  logic [5:0] select_1821;
  assign select_1821 = or_1810_s21_q ? {and_1672_s21_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1823;
  assign and_1823 = select_1820_s21_q & (~select_1821[5]);
  // hls/stages/patches.hpp:133
  logic [5:0] select_1841;
  assign select_1841 = or_1839_s21_q ? {and_1672_s21_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1843;
  assign and_1843 = select_1820_s21_q & (~select_1841[5]);
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2276;
  assign select_2276 = and_546_s21_q ? census_changes_values_1_left_s21_q : census_changes_values_2_left_q;
  logic [11:0] select_2277;
  assign select_2277 = and_546_s21_q ? census_changes_values_1_right_s21_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [13:0] sum_2281;
  assign sum_2281 = {2'h0, census_changes_values_1_right_s21_q} + {1'b0, sum_2280_s21_q};
  logic [13:0] sum_2282;
  assign sum_2282 = {2'h0, census_changes_values_2_right_q} + sum_2281;
  // hls/stages/moments.hpp:51
  logic or_2327;
  assign or_2327 = moments_begins_alone_q | (moments_out_of_step_q & not_2325_s21_q);
  // hls/stages/census.hpp:363
  logic [23:0] select_2375;
  assign select_2375 = equal_2279_s21_q ? {11'h0, select_2373_s21_q} : (sharpness_sums_detail_0_q + {11'h0, select_2373_s21_q});
  logic [23:0] select_2387;
  assign select_2387 = equal_2279_s21_q ? {11'h0, select_2385_s21_q} : (sharpness_sums_detail_1_q + {11'h0, select_2385_s21_q});
  // hls/stages/census.hpp:383
  logic [17:0] select_2410;
  assign select_2410 = (less_2398_s21_q & and_2408_s21_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2420;
  assign select_2420 = (less_2398_s21_q & and_2418_s21_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:216
  logic [1:0] select_2429;
  assign select_2429 = equal_2397_s21_q ? {sharpness_comparing_contrast_0_q[0], and_2418_s21_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2431;
  assign select_2431 = equal_2397_s21_q ? {sharpness_comparing_contrast_1_q[0], and_2408_s21_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:392
  logic xor_2454;
  assign xor_2454 = sharpness_comparing_contrast_0_q[1] ^ and_2408_s21_q;
  logic select_2457;
  assign select_2457 = (equal_2441_s21_q | xor_2454) ? (and_2408_s21_q & xor_2454) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2458;
  assign select_2458 = equal_2397_s21_q ? select_2457 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2460;
  assign xor_2460 = sharpness_comparing_contrast_1_q[1] ^ and_2418_s21_q;
  logic select_2463;
  assign select_2463 = (equal_2441_s21_q | xor_2460) ? (and_2418_s21_q & xor_2460) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2464;
  assign select_2464 = equal_2397_s21_q ? select_2463 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2642;
  assign select_2642 = and_2593_s21_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2640_s21_q});
  logic [13:0] select_2656;
  assign select_2656 = and_2593_s21_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2654_s21_q});
  // hls/stages/agreement.hpp:788
  logic and_2676;
  assign and_2676 = not_572_s21_q & and_2675_s21_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2678;
  assign select_2678 = and_2593_s21_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2676});
  logic [13:0] select_2697;
  assign select_2697 = and_2593_s21_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2695_s21_q});
  // hls/stages/patches.hpp:127
  logic select_3022;
  assign select_3022 = equal_1690_s21_q ? patches_valid_0_q : (select_1689_s21_q ? patches_valid_0_q : select_1800_s21_q);
  // hls/stages/agreement.hpp:276
  logic select_3025;
  assign select_3025 = sample_pair_whole_s21_q ? (and_1823 ? (sample_present_s21_q & select_3022) : select_3022) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3027;
  assign select_3027 = equal_1690_s21_q ? patches_valid_1_q : (select_1689_s21_q ? select_1800_s21_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3030;
  assign select_3030 = sample_pair_whole_s21_q ? (and_1843 ? (sample_present_s21_q & select_3027) : select_3027) : patches_valid_1_q;
  logic [5:0] select_3033;
  assign select_3033 = sample_pair_whole_s21_q ? (select_1821[5] ? {1'b1, select_1821[4:0]} : (select_1821 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3036;
  assign select_3036 = sample_pair_whole_s21_q ? (select_1841[5] ? {1'b1, select_1841[4:0]} : (select_1841 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3417;
  assign parity_3417 = ^{or_3409_s21_q, or_3405_s21_q, or_3401_s21_q, or_3394_s21_q, or_3390_s21_q, or_3386_s21_q, or_3379_s21_q, or_3375_s21_q, or_3371_s21_q, or_3364_s21_q, or_3360_s21_q, and_3356_s21_q};
  // hls/stages/count_bits.hpp:25
  logic or_3421;
  assign or_3421 = (or_3375_s21_q & or_3379_s21_q) | (or_3371_s21_q & (or_3375_s21_q | or_3379_s21_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3432;
  assign parity_3432 = ^{or_3429_s21_q, or_3425_s21_q, or_3421};
  // hls/stages/count_bits.hpp:25
  logic and_3433;
  assign and_3433 = (^{or_3364_s21_q, or_3360_s21_q, and_3356_s21_q}) & parity_3415_s21_q;
  logic or_3437;
  assign or_3437 = (or_3360_s21_q & or_3364_s21_q) | and_3436_s21_q;
  logic or_3441;
  assign or_3441 = and_3438_s21_q | and_3440_s21_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3444;
  assign parity_3444 = ^{or_3441, or_3437, and_3433};
  // hls/stages/count_bits.hpp:25
  logic and_3446;
  assign and_3446 = parity_3432 & parity_3444;
  logic or_3450;
  assign or_3450 = (or_3425_s21_q & or_3429_s21_q) | (or_3421 & (or_3425_s21_q | or_3429_s21_q));
  logic or_3454;
  assign or_3454 = (or_3437 & or_3441) | (and_3433 & (or_3437 | or_3441));
  // hls/stages/patches.hpp:599
  logic or_3602;
  assign or_3602 = (~(patches_second_s21_q ? patches_valid_1_q : patches_valid_0_q)) | or_3601_s21_q;
  logic or_3605;
  assign or_3605 = equal_3593_s21_q | (less_3595_s21_q | (less_3596_s21_q | or_3602));
  // hls/stages/patches.hpp:598
  logic [14:0] difference_3652;
  assign difference_3652 = {{7{select_3646_s21_q[7]}}, select_3646_s21_q} - {product_3651_s21_q[13], product_3651_s21_q};
  // hls/stages/patches.hpp:604
  logic less_3653;
  assign less_3653 = $signed({{8{difference_3623[6]}}, difference_3623}) < $signed(difference_3652);
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3953;
  assign select_3953 = equal_3950_s21_q ? counts_skin_unproven_q : (equal_3951_s21_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3955;
  assign select_3955 = equal_3949_s21_q ? counts_regions_bad_q : (equal_3946_s21_q ? counts_nearer_s21_q : select_3953);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3948_s21_q ? counts_on_skin_q : select_3955;
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4191;
  assign select_4191 = equal_1622_s21_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4190_s21_q;
  logic [31:0] select_4192;
  assign select_4192 = equal_1620_s21_q ? {8'h0, sharpness_sums_detail_0_q} : select_4191;
  logic [31:0] select_4193;
  assign select_4193 = equal_1618_s21_q ? {8'h0, sharpness_sums_detail_1_q} : select_4192;
  logic [31:0] select_4194;
  assign select_4194 = equal_1616_s21_q ? {8'h0, sharpness_sums_contrast_0_s21_q} : select_4193;
  logic [31:0] select_4195;
  assign select_4195 = equal_1614_s21_q ? {8'h0, sharpness_sums_contrast_1_s21_q} : select_4194;

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1860_s21_q, select_1859_s21_q, column_4_s21_q};
  logic patches_left_we;
  assign patches_left_we = s21_en & and_1867_s21_q;
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
  assign map_waddr = {sum_2065_s21_q, index_2_s21_q};
  logic map_we;
  assign map_we = s21_en & and_2139_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2129_s21_q, is_seen_s21_q};
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
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      proven_q <= 1'b0;
    end else if (s21_en) begin
      moments_out_of_step_q <= or_2327;
      moments_begins_alone_q <= equal_571_s21_q & (equal_2294_s21_q & and_2346_s21_q);
      sharpness_sums_detail_0_q <= and_546_s21_q ? select_2375 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_546_s21_q ? select_2387 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s21_q ? select_2429 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s21_q ? select_2431 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s21_q ? select_2458 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s21_q ? select_2464 : sharpness_comparing_less_contrast_1_q;
      counts_unproven_q <= select_2642;
      counts_regions_bad_q <= select_2656;
      counts_skin_unproven_q <= select_2678;
      counts_on_skin_q <= select_2697;
      patches_valid_0_q <= select_3025;
      patches_valid_1_q <= select_3030;
      patches_right_next_0_q <= select_3033;
      patches_right_next_1_q <= select_3036;
      proven_q <= marks_first_s21_q ? done_s21_q : proven_q;
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
    if (s21_en) begin
      census_changes_values_2_left_q <= select_2276;
      census_changes_values_2_right_q <= select_2277;
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
  logic [6:0] last_s22_q;
  logic and_546_s22_q;
  logic equal_571_s22_q;
  logic so_s22_q;
  logic less_649_s22_q;
  logic less_650_s22_q;
  logic less_651_s22_q;
  logic less_652_s22_q;
  logic less_653_s22_q;
  logic less_654_s22_q;
  logic less_655_s22_q;
  logic less_656_s22_q;
  logic less_657_s22_q;
  logic less_658_s22_q;
  logic less_659_s22_q;
  logic less_660_s22_q;
  logic less_661_s22_q;
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
  logic and_680_s22_q;
  logic and_705_s22_q;
  logic and_706_s22_q;
  logic [8:0] sum_728_s22_q;
  logic and_736_s22_q;
  logic less_737_s22_q;
  logic and_742_s22_q;
  logic less_743_s22_q;
  logic equal_1604_s22_q;
  logic equal_1612_s22_q;
  logic equal_1784_s22_q;
  logic equal_1786_s22_q;
  logic [4:0] select_1811_s22_q;
  logic [4:0] select_1814_s22_q;
  logic and_1824_s22_q;
  logic [4:0] select_1840_s22_q;
  logic and_1844_s22_q;
  logic less_1963_s22_q;
  logic equal_1964_s22_q;
  logic not_1965_s22_q;
  logic equal_1966_s22_q;
  logic not_1993_s22_q;
  logic and_2059_s22_q;
  logic less_2060_s22_q;
  logic [1:0] map_rdata_s22_q;
  logic is_seen_s22_q;
  logic and_2129_s22_q;
  logic equal_2279_s22_q;
  logic [8:0] sum_2282_s22_q;
  logic equal_2397_s22_q;
  logic less_2398_s22_q;
  logic [17:0] select_2410_s22_q;
  logic [17:0] select_2420_s22_q;
  logic equal_2441_s22_q;
  logic [9:0] select_2644_s22_q;
  logic [9:0] select_2647_s22_q;
  logic equal_2894_s22_q;
  logic parity_3226_s22_q;
  logic parity_3355_s22_q;
  logic parity_3417_s22_q;
  logic xor_3445_s22_q;
  logic parity_3457_s22_q;
  logic and_3458_s22_q;
  logic and_3460_s22_q;
  logic equal_3462_s22_q;
  logic or_3605_s22_q;
  logic [5:0] difference_3652_s22_q;
  logic not_3654_s22_q;
  logic not_3664_s22_q;
  logic equal_3702_s22_q;
  logic less_3776_s22_q;
  logic less_3777_s22_q;
  logic and_3808_s22_q;
  logic less_3827_s22_q;
  logic or_3924_s22_q;
  logic select_3932_s22_q;
  logic equal_3943_s22_q;
  logic and_3947_s22_q;
  logic [13:0] before_v_4_s22_q;
  logic not_3992_s22_q;
  logic or_3996_s22_q;
  logic and_4001_s22_q;
  logic less_4002_s22_q;
  logic and_4105_s22_q;
  logic and_4120_s22_q;
  logic not_4134_s22_q;
  logic [31:0] select_4195_s22_q;
  logic [9:0] select_4197_s22_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      last_s22_q <= last_s21_q;
      and_546_s22_q <= and_546_s21_q;
      equal_571_s22_q <= equal_571_s21_q;
      so_s22_q <= so_s21_q;
      less_649_s22_q <= less_649_s21_q;
      less_650_s22_q <= less_650_s21_q;
      less_651_s22_q <= less_651_s21_q;
      less_652_s22_q <= less_652_s21_q;
      less_653_s22_q <= less_653_s21_q;
      less_654_s22_q <= less_654_s21_q;
      less_655_s22_q <= less_655_s21_q;
      less_656_s22_q <= less_656_s21_q;
      less_657_s22_q <= less_657_s21_q;
      less_658_s22_q <= less_658_s21_q;
      less_659_s22_q <= less_659_s21_q;
      less_660_s22_q <= less_660_s21_q;
      less_661_s22_q <= less_661_s21_q;
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
      and_680_s22_q <= and_680_s21_q;
      and_705_s22_q <= and_705_s21_q;
      and_706_s22_q <= and_706_s21_q;
      sum_728_s22_q <= sum_728[13:5];
      and_736_s22_q <= and_736_s21_q;
      less_737_s22_q <= less_737_s21_q;
      and_742_s22_q <= (and_705_s21_q & and_732_s21_q) & less_741_s21_q;
      less_743_s22_q <= less_743_s21_q;
      equal_1604_s22_q <= equal_1604_s21_q;
      equal_1612_s22_q <= equal_1612_s21_q;
      equal_1784_s22_q <= equal_1784_s21_q;
      equal_1786_s22_q <= equal_1786_s21_q;
      select_1811_s22_q <= or_1810_s21_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1814_s22_q <= select_1814_s21_q;
      and_1824_s22_q <= sample_pair_whole_s21_q & and_1823;
      select_1840_s22_q <= or_1839_s21_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1844_s22_q <= sample_pair_whole_s21_q & and_1843;
      less_1963_s22_q <= less_1963_s21_q;
      equal_1964_s22_q <= equal_1964_s21_q;
      not_1965_s22_q <= not_1965_s21_q;
      equal_1966_s22_q <= equal_1966_s21_q;
      not_1993_s22_q <= not_1993_s21_q;
      and_2059_s22_q <= and_2059_s21_q;
      less_2060_s22_q <= less_2060_s21_q;
      map_rdata_s22_q <= map_rdata_q;
      is_seen_s22_q <= is_seen_s21_q;
      and_2129_s22_q <= and_2129_s21_q;
      equal_2279_s22_q <= equal_2279_s21_q;
      sum_2282_s22_q <= sum_2282[13:5];
      equal_2397_s22_q <= equal_2397_s21_q;
      less_2398_s22_q <= less_2398_s21_q;
      select_2410_s22_q <= select_2410;
      select_2420_s22_q <= select_2420;
      equal_2441_s22_q <= equal_2441_s21_q;
      select_2644_s22_q <= select_2644_s21_q;
      select_2647_s22_q <= select_2647_s21_q;
      equal_2894_s22_q <= equal_2894_s21_q;
      parity_3226_s22_q <= parity_3226_s21_q;
      parity_3355_s22_q <= parity_3355_s21_q;
      parity_3417_s22_q <= parity_3417;
      xor_3445_s22_q <= parity_3432 ^ parity_3444;
      parity_3457_s22_q <= ^{or_3454, or_3450, and_3446};
      and_3458_s22_q <= or_3450 & or_3454;
      and_3460_s22_q <= and_3446 & (or_3450 | or_3454);
      equal_3462_s22_q <= equal_3462_s21_q;
      or_3605_s22_q <= or_3605;
      difference_3652_s22_q <= difference_3652[5:0];
      not_3654_s22_q <= ~less_3653;
      not_3664_s22_q <= ~($signed(difference_3652) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3702_s22_q <= equal_3702_s21_q;
      less_3776_s22_q <= $signed(15'h10) < $signed(difference_3652);
      less_3777_s22_q <= $signed(difference_3652[14:4]) < $signed(11'h7ff);
      and_3808_s22_q <= equal_571_s21_q & equal_2294_s21_q;
      less_3827_s22_q <= less_3827_s21_q;
      or_3924_s22_q <= or_3924_s21_q;
      select_3932_s22_q <= select_3932_s21_q;
      equal_3943_s22_q <= equal_3943_s21_q;
      and_3947_s22_q <= equal_3946_s21_q & equal_3702_s21_q;
      before_v_4_s22_q <= before_v_4;
      not_3992_s22_q <= ~(equal_3951_s21_q & equal_3702_s21_q);
      or_3996_s22_q <= (equal_3951_s21_q | equal_3950_s21_q) | (x_s21_q[6:3] == 4'hf);
      and_4001_s22_q <= equal_3948_s21_q & equal_3702_s21_q;
      less_4002_s22_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4105_s22_q <= and_4105_s21_q;
      and_4120_s22_q <= and_4120_s21_q;
      not_4134_s22_q <= ~proven_q;
      select_4195_s22_q <= select_4195;
      select_4197_s22_q <= select_4197_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
  logic [17:0] sharpness_comparing_rest_0_q;
  logic [17:0] sharpness_comparing_rest_1_q;
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
  // hls/stages/census.hpp:383
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2410_s22_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2413;
  assign select_2413 = equal_2397_s22_q ? (less_2398_s22_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:383
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2420_s22_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2423;
  assign select_2423 = equal_2397_s22_q ? (less_2398_s22_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/count_bits.hpp:27
  logic or_3461;
  assign or_3461 = and_3458_s22_q | and_3460_s22_q;
  // hls/stages/patches.hpp:525
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3461, parity_3457_s22_q, xor_3445_s22_q, parity_3417_s22_q, parity_3355_s22_q, parity_3226_s22_q} + (equal_3462_s22_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3466;
  assign select_3466 = equal_1784_s22_q ? patches_sums_values_0_q : (equal_1786_s22_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3467;
  assign select_3467 = equal_1786_s22_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3469;
  assign select_3469 = equal_1786_s22_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3471;
  assign select_3471 = equal_1786_s22_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3473;
  assign select_3473 = equal_1786_s22_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3475;
  assign select_3475 = equal_1786_s22_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3477;
  assign select_3477 = equal_1786_s22_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3479;
  assign select_3479 = equal_1786_s22_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3481;
  assign select_3481 = equal_1786_s22_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3483;
  assign select_3483 = equal_1786_s22_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3485;
  assign select_3485 = equal_1786_s22_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3487;
  assign select_3487 = equal_1786_s22_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3489;
  assign select_3489 = equal_1786_s22_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3491;
  assign select_3491 = equal_1786_s22_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3493;
  assign select_3493 = equal_1786_s22_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3495;
  assign select_3495 = equal_1786_s22_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3497;
  assign select_3497 = equal_1786_s22_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:579
  logic not_3606;
  assign not_3606 = ~or_3605_s22_q;
  // hls/stages/patches.hpp:560
  logic and_3607;
  assign and_3607 = equal_1966_s22_q & not_3606;
  // hls/stages/patches.hpp:184
  logic and_3610;
  assign and_3610 = equal_1784_s22_q & (less_1963_s22_q ? (not_1965_s22_q & and_3607) : and_3607);
  // hls/stages/patches.hpp:560
  logic and_3613;
  assign and_3613 = equal_1966_s22_q & (patches_second_s22_q & not_3606);
  // hls/stages/patches.hpp:184
  logic and_3616;
  assign and_3616 = equal_1784_s22_q & (less_1963_s22_q ? (not_1965_s22_q & and_3613) : and_3613);
  // hls/stages/patches.hpp:560
  logic and_3656;
  assign and_3656 = equal_1966_s22_q & (not_3606 & not_3654_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3659;
  assign and_3659 = equal_1784_s22_q & (less_1963_s22_q ? (not_1965_s22_q & and_3656) : and_3656);
  // hls/stages/patches.hpp:560
  logic and_3666;
  assign and_3666 = equal_1966_s22_q & (not_3606 & not_3664_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3669;
  assign and_3669 = equal_1784_s22_q & (less_1963_s22_q ? (not_1965_s22_q & and_3666) : and_3666);
  // hls/stages/agreement.hpp:1130
  logic less_3703;
  assign less_3703 = x_s22_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3707;
  assign and_3707 = equal_571_s22_q & (x_s22_q[6] & (not_1993_s22_q & (equal_3702_s22_q & less_3703)));
  // hls/stages/agreement.hpp:1142
  logic and_3712;
  assign and_3712 = x_s22_q[6] & (not_1993_s22_q & (less_3703 & (x_s22_q[2:0] == 3'h1)));
  logic and_3719;
  assign and_3719 = x_s22_q[6] & (not_1993_s22_q & (less_3703 & (x_s22_q[2:0] == 3'h2)));
  logic and_3726;
  assign and_3726 = x_s22_q[6] & (not_1993_s22_q & (less_3703 & (x_s22_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:199
  logic select_3733;
  assign select_3733 = (x_s22_q[5:3] == 3'h2) ? x_s22_q[1] : (x_s22_q[0] & (x_s22_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3760;
  assign sum_3760 = {2'h0, x_s22_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:606
  logic [5:0] select_3779;
  assign select_3779 = less_3776_s22_q ? 6'h10 : (less_3777_s22_q ? 6'h30 : difference_3652_s22_q);
  // hls/stages/patches.hpp:560
  logic [5:0] select_3781;
  assign select_3781 = equal_1966_s22_q ? (or_3605_s22_q ? 6'h0 : select_3779) : 6'h0;
  logic [5:0] select_3783;
  assign select_3783 = less_1963_s22_q ? (equal_1964_s22_q ? 6'h0 : select_3781) : select_3781;
  // hls/stages/agreement.hpp:788
  logic and_3790;
  assign and_3790 = equal_571_s22_q & (x_s22_q[6] & (not_1993_s22_q & (equal_2894_s22_q & less_3703)));
  // hls/stages/agreement.hpp:1142
  logic and_3794;
  assign and_3794 = x_s22_q[6] & (not_1993_s22_q & (less_3703 & (x_s22_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:560
  logic and_3829;
  assign and_3829 = equal_1966_s22_q & (not_3606 & less_3827_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3832;
  assign and_3832 = equal_1784_s22_q & (less_1963_s22_q ? (not_1965_s22_q & and_3829) : and_3829);
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_s22_q} - {1'b0, before_v_4_s22_q};
  // hls/stages/agreement.hpp:1230
  logic select_3958;
  assign select_3958 = and_3947_s22_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4121;
  assign select_4121 = and_4120_s22_q ? {and_2129_s22_q, is_seen_s22_q} : map_rdata_s22_q;
  // hls/stages/agreement.hpp:1309
  logic and_4122;
  assign and_4122 = proven_q & less_4110;
  // hls/stages/agreement.hpp:788
  logic and_4177;
  assign and_4177 = equal_571_s22_q & (equal_3943_s22_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4181;
  assign and_4181 = equal_571_s22_q & (x_s22_q[6] & (not_1993_s22_q | (4'hc < x_s22_q[5:2])));

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1814_s22_q, select_1811_s22_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s22_en & and_1824_s22_q;
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
  assign patches_right_1_waddr = {select_1814_s22_q, select_1840_s22_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s22_en & and_1844_s22_q;
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
      sharpness_comparing_rest_0_q <= 18'h0;
      sharpness_comparing_rest_1_q <= 18'h0;
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
      sharpness_comparing_rest_0_q <= so_s22_q ? select_2413 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s22_q ? select_2423 : sharpness_comparing_rest_1_q;
      patches_sums_values_0_q <= select_3466;
      patches_sums_values_1_q <= equal_1784_s22_q ? patches_sums_values_1_q : select_3467;
      patches_sums_values_2_q <= equal_1784_s22_q ? patches_sums_values_2_q : select_3469;
      patches_sums_values_3_q <= equal_1784_s22_q ? patches_sums_values_3_q : select_3471;
      patches_sums_values_4_q <= equal_1784_s22_q ? patches_sums_values_4_q : select_3473;
      patches_sums_values_5_q <= equal_1784_s22_q ? patches_sums_values_5_q : select_3475;
      patches_sums_values_6_q <= equal_1784_s22_q ? patches_sums_values_6_q : select_3477;
      patches_sums_values_7_q <= equal_1784_s22_q ? patches_sums_values_7_q : select_3479;
      patches_sums_values_8_q <= equal_1784_s22_q ? patches_sums_values_8_q : select_3481;
      patches_sums_values_9_q <= equal_1784_s22_q ? patches_sums_values_9_q : select_3483;
      patches_sums_values_10_q <= equal_1784_s22_q ? patches_sums_values_10_q : select_3485;
      patches_sums_values_11_q <= equal_1784_s22_q ? patches_sums_values_11_q : select_3487;
      patches_sums_values_12_q <= equal_1784_s22_q ? patches_sums_values_12_q : select_3489;
      patches_sums_values_13_q <= equal_1784_s22_q ? patches_sums_values_13_q : select_3491;
      patches_sums_values_14_q <= equal_1784_s22_q ? patches_sums_values_14_q : select_3493;
      patches_sums_values_15_q <= equal_1784_s22_q ? patches_sums_values_15_q : select_3495;
      patches_sums_values_16_q <= equal_1784_s22_q ? patches_sums_values_16_q : select_3497;
      patches_frame_ended_q <= and_3808_s22_q;
      hides_q <= equal_571_s22_q ? select_3958 : hides_q;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic x_s23_q;
  logic registration_moved_s23_q;
  logic patches_lower_s23_q;
  logic [9:0] patches_sums_values_0_s23_q;
  logic [4:0] patches_summed_row_column_s23_q;
  logic patches_summed_first_s23_q;
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic patches_frame_ended_s23_q;
  logic [6:0] last_s23_q;
  logic and_546_s23_q;
  logic equal_571_s23_q;
  logic so_s23_q;
  logic less_649_s23_q;
  logic less_650_s23_q;
  logic less_651_s23_q;
  logic less_652_s23_q;
  logic less_653_s23_q;
  logic less_654_s23_q;
  logic less_655_s23_q;
  logic less_656_s23_q;
  logic less_657_s23_q;
  logic less_658_s23_q;
  logic less_659_s23_q;
  logic less_660_s23_q;
  logic less_661_s23_q;
  logic less_662_s23_q;
  logic less_663_s23_q;
  logic less_664_s23_q;
  logic less_665_s23_q;
  logic less_666_s23_q;
  logic less_667_s23_q;
  logic less_668_s23_q;
  logic less_669_s23_q;
  logic less_670_s23_q;
  logic less_671_s23_q;
  logic less_672_s23_q;
  logic and_680_s23_q;
  logic and_705_s23_q;
  logic and_706_s23_q;
  logic less_729_s23_q;
  logic and_736_s23_q;
  logic less_737_s23_q;
  logic and_742_s23_q;
  logic less_743_s23_q;
  logic equal_1604_s23_q;
  logic equal_1612_s23_q;
  logic and_2059_s23_q;
  logic less_2060_s23_q;
  logic equal_2279_s23_q;
  logic and_2284_s23_q;
  logic equal_2397_s23_q;
  logic sum_s23_q;
  logic sum_2_s23_q;
  logic equal_2441_s23_q;
  logic select_2459_s23_q;
  logic select_2465_s23_q;
  logic [9:0] select_2644_s23_q;
  logic [9:0] select_2647_s23_q;
  logic and_3610_s23_q;
  logic and_3616_s23_q;
  logic and_3659_s23_q;
  logic and_3669_s23_q;
  logic and_3707_s23_q;
  logic and_3713_s23_q;
  logic and_3720_s23_q;
  logic and_3727_s23_q;
  logic and_3736_s23_q;
  logic and_3763_s23_q;
  logic [5:0] select_3784_s23_q;
  logic and_3790_s23_q;
  logic and_3795_s23_q;
  logic and_3833_s23_q;
  logic or_3924_s23_q;
  logic select_3932_s23_q;
  logic equal_3943_s23_q;
  logic select_3958_s23_q;
  logic and_3990_s23_q;
  logic not_3992_s23_q;
  logic or_3996_s23_q;
  logic and_4001_s23_q;
  logic and_4003_s23_q;
  logic and_4105_s23_q;
  logic and_4123_s23_q;
  logic and_4126_s23_q;
  logic not_4134_s23_q;
  logic and_4177_s23_q;
  logic and_4181_s23_q;
  logic [5:0] select_4183_s23_q;
  logic [31:0] select_4195_s23_q;
  logic [9:0] select_4197_s23_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_s22_q;
      x_s23_q <= x_s22_q[6];
      registration_moved_s23_q <= registration_moved_s22_q;
      patches_lower_s23_q <= patches_lower_s22_q;
      patches_sums_values_0_s23_q <= patches_sums_values_0_q;
      patches_summed_row_column_s23_q <= patches_summed_row_column_s22_q;
      patches_summed_first_s23_q <= patches_summed_first_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_s22_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_s22_q;
      patches_frame_ended_s23_q <= patches_frame_ended_q;
      last_s23_q <= last_s22_q;
      and_546_s23_q <= and_546_s22_q;
      equal_571_s23_q <= equal_571_s22_q;
      so_s23_q <= so_s22_q;
      less_649_s23_q <= less_649_s22_q;
      less_650_s23_q <= less_650_s22_q;
      less_651_s23_q <= less_651_s22_q;
      less_652_s23_q <= less_652_s22_q;
      less_653_s23_q <= less_653_s22_q;
      less_654_s23_q <= less_654_s22_q;
      less_655_s23_q <= less_655_s22_q;
      less_656_s23_q <= less_656_s22_q;
      less_657_s23_q <= less_657_s22_q;
      less_658_s23_q <= less_658_s22_q;
      less_659_s23_q <= less_659_s22_q;
      less_660_s23_q <= less_660_s22_q;
      less_661_s23_q <= less_661_s22_q;
      less_662_s23_q <= less_662_s22_q;
      less_663_s23_q <= less_663_s22_q;
      less_664_s23_q <= less_664_s22_q;
      less_665_s23_q <= less_665_s22_q;
      less_666_s23_q <= less_666_s22_q;
      less_667_s23_q <= less_667_s22_q;
      less_668_s23_q <= less_668_s22_q;
      less_669_s23_q <= less_669_s22_q;
      less_670_s23_q <= less_670_s22_q;
      less_671_s23_q <= less_671_s22_q;
      less_672_s23_q <= less_672_s22_q;
      and_680_s23_q <= and_680_s22_q;
      and_705_s23_q <= and_705_s22_q;
      and_706_s23_q <= and_706_s22_q;
      less_729_s23_q <= 9'h4 < sum_728_s22_q;
      and_736_s23_q <= and_736_s22_q;
      less_737_s23_q <= less_737_s22_q;
      and_742_s23_q <= and_742_s22_q;
      less_743_s23_q <= less_743_s22_q;
      equal_1604_s23_q <= equal_1604_s22_q;
      equal_1612_s23_q <= equal_1612_s22_q;
      and_2059_s23_q <= and_2059_s22_q;
      less_2060_s23_q <= less_2060_s22_q;
      equal_2279_s23_q <= equal_2279_s22_q;
      and_2284_s23_q <= and_705_s22_q & (9'h4 < sum_2282_s22_q);
      equal_2397_s23_q <= equal_2397_s22_q;
      sum_s23_q <= sum[0];
      sum_2_s23_q <= sum_2[0];
      equal_2441_s23_q <= equal_2441_s22_q;
      select_2459_s23_q <= sharpness_comparing_less_contrast_0_q;
      select_2465_s23_q <= sharpness_comparing_less_contrast_1_q;
      select_2644_s23_q <= select_2644_s22_q;
      select_2647_s23_q <= select_2647_s22_q;
      and_3610_s23_q <= and_3610;
      and_3616_s23_q <= and_3616;
      and_3659_s23_q <= and_3659;
      and_3669_s23_q <= and_3669;
      and_3707_s23_q <= and_3707;
      and_3713_s23_q <= equal_571_s22_q & and_3712;
      and_3720_s23_q <= equal_571_s22_q & and_3719;
      and_3727_s23_q <= equal_571_s22_q & and_3726;
      and_3736_s23_q <= x_s22_q[6] & (not_1993_s22_q & (less_3703 & select_3733));
      and_3763_s23_q <= not_1993_s22_q & (less_3703 & (sum_3760[4:2] == 3'h0));
      select_3784_s23_q <= equal_1784_s22_q ? select_3783 : 6'h0;
      and_3790_s23_q <= and_3790;
      and_3795_s23_q <= equal_571_s22_q & and_3794;
      and_3833_s23_q <= and_3610 & and_3832;
      or_3924_s23_q <= or_3924_s22_q;
      select_3932_s23_q <= select_3932_s22_q;
      equal_3943_s23_q <= equal_3943_s22_q;
      select_3958_s23_q <= select_3958;
      and_3990_s23_q <= over[14] & equal_3702_s22_q;
      not_3992_s23_q <= not_3992_s22_q;
      or_3996_s23_q <= or_3996_s22_q;
      and_4001_s23_q <= and_4001_s22_q;
      and_4003_s23_q <= over[14] & less_4002_s22_q;
      and_4105_s23_q <= and_4105_s22_q;
      and_4123_s23_q <= select_4121[0] & and_4122;
      and_4126_s23_q <= select_4121[1] & and_4122;
      not_4134_s23_q <= not_4134_s22_q;
      and_4177_s23_q <= and_4177;
      and_4181_s23_q <= and_4181;
      select_4183_s23_q <= equal_571_s22_q ? (x_s22_q[6] ? x_s22_q[5:0] : 6'h0) : 6'h0;
      select_4195_s23_q <= select_4195_s22_q;
      select_4197_s23_q <= select_4197_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
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
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic overlooks_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:305
  logic and_730;
  assign and_730 = and_680_s23_q & less_729_s23_q;
  // hls/stages/patches.hpp:184
  logic less_1975;
  assign less_1975 = patches_sums_values_0_s23_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1976;
  assign not_1976 = ~less_1975;
  logic [1:0] select_1977;
  assign select_1977 = patches_summed_first_s23_q ? 2'h2 : {less_1975, not_1976};
  logic [12:0] select_1979;
  assign select_1979 = select_1977[0] ? {4'h0, patches_summed_first_s23_q, 3'h0, patches_summed_row_column_s23_q} : {patches_summed_row_column_s23_q, patches_sums_values_0_s23_q[7:0]};
  logic [14:0] select_1980;
  assign select_1980 = select_1977[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1981;
  assign select_1981 = (select_1977 == 2'h2) ? {select_1979[12:8], patches_sums_values_0_s23_q[9:8], select_1979[7:0]} : select_1980;
  // hls/stages/census.hpp:312
  logic and_2285;
  assign and_2285 = and_705_s23_q & less_729_s23_q;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2286;
  assign sum_2286 = census_left_misses_q + {{17{and_2285}}, and_2284_s23_q, 1'b0, and_2284_s23_q};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2288;
  assign select_2288 = and_546_s23_q ? (equal_2279_s23_q ? 20'h0 : sum_2286) : census_left_misses_q;
  // hls/stages/agreement.hpp:216
  logic [2:0] select_2425;
  assign select_2425 = equal_2397_s23_q ? {sharpness_comparing_product_0_q[1:0], sum_s23_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2427;
  assign select_2427 = equal_2397_s23_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s23_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s23_q});
  // hls/stages/agreement.hpp:216
  logic select_2436;
  assign select_2436 = so_s23_q ? (equal_2397_s23_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s23_q});
  // hls/stages/agreement.hpp:216
  logic select_2439;
  assign select_2439 = equal_2397_s23_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:391
  logic xor_2442;
  assign xor_2442 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2448;
  assign xor_2448 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:657
  logic not_3611;
  assign not_3611 = ~patches_lower_s23_q;
  logic not_3617;
  assign not_3617 = ~and_3616_s23_q;
  // hls/stages/patches.hpp:188
  logic and_3619;
  assign and_3619 = and_3610_s23_q & (not_3611 & not_3617);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3621;
  assign sum_3621 = {7'h0, and_3619} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:660
  logic and_3660;
  assign and_3660 = and_3659_s23_q & and_3619;
  logic [7:0] sum_3661;
  assign sum_3661 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3660};
  // hls/stages/patches.hpp:661
  logic and_3670;
  assign and_3670 = and_3669_s23_q & and_3619;
  logic [7:0] sum_3671;
  assign sum_3671 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3670};
  // hls/stages/patches.hpp:188
  logic and_3673;
  assign and_3673 = and_3610_s23_q & (and_3616_s23_q & not_3611);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3675;
  assign sum_3675 = {7'h0, and_3673} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:660
  logic and_3677;
  assign and_3677 = and_3659_s23_q & and_3673;
  logic [7:0] sum_3678;
  assign sum_3678 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3677};
  // hls/stages/patches.hpp:661
  logic and_3680;
  assign and_3680 = and_3669_s23_q & and_3673;
  logic [7:0] sum_3681;
  assign sum_3681 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3680};
  // hls/stages/patches.hpp:188
  logic and_3683;
  assign and_3683 = and_3610_s23_q & (patches_lower_s23_q & not_3617);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3685;
  assign sum_3685 = {7'h0, and_3683} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:660
  logic and_3687;
  assign and_3687 = and_3659_s23_q & and_3683;
  logic [7:0] sum_3688;
  assign sum_3688 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3687};
  // hls/stages/patches.hpp:661
  logic and_3690;
  assign and_3690 = and_3669_s23_q & and_3683;
  logic [7:0] sum_3691;
  assign sum_3691 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3690};
  // hls/stages/patches.hpp:188
  logic and_3693;
  assign and_3693 = and_3610_s23_q & (patches_lower_s23_q & and_3616_s23_q);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3695;
  assign sum_3695 = {7'h0, and_3693} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:660
  logic and_3697;
  assign and_3697 = and_3659_s23_q & and_3693;
  logic [7:0] sum_3698;
  assign sum_3698 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3697};
  // hls/stages/patches.hpp:661
  logic and_3700;
  assign and_3700 = and_3669_s23_q & and_3693;
  logic [7:0] sum_3701;
  assign sum_3701 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3700};
  // hls/stages/patches.hpp:623
  logic [7:0] or_3715;
  assign or_3715 = (and_3707_s23_q ? patches_quarters_0_places_q : 8'h0) | (and_3713_s23_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3729;
  assign or_3729 = (or_3715 | (and_3720_s23_q ? patches_quarters_2_places_q : 8'h0)) | (and_3727_s23_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_3737;
  assign and_3737 = equal_571_s23_q & and_3736_s23_q;
  // hls/stages/patches.hpp:624
  logic [7:0] select_3739;
  assign select_3739 = and_3707_s23_q ? (and_3737 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3741;
  assign select_3741 = and_3713_s23_q ? (and_3737 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3744;
  assign select_3744 = and_3720_s23_q ? (and_3737 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3747;
  assign select_3747 = and_3727_s23_q ? (and_3737 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:625
  logic [7:0] select_3750;
  assign select_3750 = and_3707_s23_q ? (and_3737 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3752;
  assign select_3752 = and_3713_s23_q ? (and_3737 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3755;
  assign select_3755 = and_3720_s23_q ? (and_3737 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3758;
  assign select_3758 = and_3727_s23_q ? (and_3737 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_3765;
  assign and_3765 = equal_571_s23_q & (x_s23_q & and_3763_s23_q);
  // hls/stages/patches.hpp:618
  logic [7:0] sum_3767;
  assign sum_3767 = patches_word_places_q + (and_3713_s23_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:620
  logic [7:0] select_3771;
  assign select_3771 = and_3765 ? (patches_word_up_q + (and_3713_s23_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3773;
  assign sum_3773 = patches_word_down_q + (and_3713_s23_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:663
  logic [5:0] select_3785;
  assign select_3785 = and_3610_s23_q ? select_3784_s23_q : 6'h0;
  logic [11:0] sum_3786;
  assign sum_3786 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3785[5]}}, select_3785};
  // hls/stages/patches.hpp:647
  logic [7:0] select_3797;
  assign select_3797 = and_3790_s23_q ? (and_3795_s23_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:649
  logic or_3801;
  assign or_3801 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:650
  logic or_3804;
  assign or_3804 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic [8:0] sum_3805;
  assign sum_3805 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:646
  logic select_3807;
  assign select_3807 = and_3790_s23_q ? (and_3795_s23_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3810;
  assign and_3810 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:646
  logic [2:0] select_3811;
  assign select_3811 = and_3790_s23_q ? {and_3810, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3813;
  assign select_3813 = and_3790_s23_q ? (and_3795_s23_q ? {and_3810, patches_found_q[2:1]} : select_3811) : patches_found_q;
  // hls/stages/patches.hpp:645
  logic or_3816;
  assign or_3816 = patches_partly_q | (patches_doubted_q & (~and_3795_s23_q));
  // hls/stages/patches.hpp:646
  logic select_3818;
  assign select_3818 = and_3795_s23_q ? or_3816 : (and_3790_s23_q ? or_3816 : patches_doubted_q);
  // hls/stages/patches.hpp:644
  logic select_3820;
  assign select_3820 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:633
  logic [7:0] select_3824;
  assign select_3824 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:664
  logic [7:0] sum_3834;
  assign sum_3834 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3833_s23_q};
  // hls/stages/patches.hpp:635
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:636
  logic select_3857;
  assign select_3857 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:637
  logic and_3863;
  assign and_3863 = patches_frame_ended_s23_q & (~patches_age_q[9]);
  logic [9:0] sum_3864;
  assign sum_3864 = patches_age_q + {9'h0, and_3863};
  logic [9:0] select_3867;
  assign select_3867 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3864)) : sum_3864;
  // hls/stages/agreement.hpp:1148
  logic not_3959;
  assign not_3959 = ~hidden_for_q[7];
  logic [7:0] select_3961;
  assign select_3961 = select_3958_s23_q ? (hidden_for_q + {7'h0, not_3959}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3963;
  assign select_3963 = equal_571_s23_q ? (equal_3943_s23_q ? select_3961 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1228
  logic and_3993;
  assign and_3993 = too_much_q & not_3992_s23_q;
  // hls/stages/agreement.hpp:1229
  logic select_3998;
  assign select_3998 = and_3990_s23_q ? (and_3993 | or_3996_s23_q) : and_3993;
  // hls/stages/agreement.hpp:1231
  logic select_4004;
  assign select_4004 = and_4001_s23_q ? and_4003_s23_q : overlooks_q;
  // hls/stages/agreement.hpp:438
  logic select_4125;
  assign select_4125 = and_2059_s23_q ? (less_2060_s23_q ? and_4123_s23_q : seen_q) : seen_q;
  logic select_4128;
  assign select_4128 = and_2059_s23_q ? (less_2060_s23_q ? and_4126_s23_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4135;
  assign or_4135 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4134_s23_q;
  // hls/stages/agreement.hpp:788
  logic and_4150;
  assign and_4150 = equal_3943_s23_q & (cfg_prove_i & (registration_moved_s23_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4153;
  assign or_4153 = select_2459_s23_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4196;
  assign select_4196 = equal_1612_s23_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4195_s23_q;
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4198;
  assign select_4198 = equal_1604_s23_q ? select_4196 : {2'h0, select_4197_s23_q, select_2647_s23_q, select_2644_s23_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s23_q;
  logic fresh_we;
  assign fresh_we = s23_en & and_546_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_743_s23_q, and_742_s23_q, less_737_s23_q, and_736_s23_q, census_columns_values_1_cell_2_of_skin_s23_q, and_730, and_706_s23_q, and_705_s23_q, and_680_s23_q, less_672_s23_q, less_671_s23_q, less_670_s23_q, less_669_s23_q, less_668_s23_q, less_667_s23_q, less_666_s23_q, less_665_s23_q, less_664_s23_q, less_663_s23_q, less_662_s23_q, less_661_s23_q, less_660_s23_q, less_659_s23_q, less_658_s23_q, less_657_s23_q, less_656_s23_q, less_655_s23_q, less_654_s23_q, less_653_s23_q, less_652_s23_q, less_651_s23_q, less_650_s23_q, less_649_s23_q};
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
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s23_en) begin
      census_left_misses_q <= select_2288;
      sharpness_comparing_product_0_q <= so_s23_q ? select_2425 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s23_q ? select_2427 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2436;
      sharpness_comparing_carry_1_q <= so_s23_q ? select_2439 : sharpness_comparing_carry_1_q;
      patches_best_differing_q <= select_1981[9:0];
      patches_best_column_q <= select_1981[14:10];
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
      patches_doubted_q <= and_3790_s23_q ? select_3818 : patches_doubted_q;
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
      hidden_for_q <= select_3963;
      too_much_q <= equal_571_s23_q ? select_3998 : too_much_q;
      overlooks_q <= equal_571_s23_q ? select_4004 : overlooks_q;
      seen_q <= select_4125;
      nearer_q <= select_4128;
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
  logic equal_571_s24_q;
  logic so_s24_q;
  logic equal_2397_s24_q;
  logic or_2443_s24_q;
  logic and_2444_s24_q;
  logic or_2449_s24_q;
  logic and_2450_s24_q;
  logic select_2465_s24_q;
  logic or_3924_s24_q;
  logic equal_3943_s24_q;
  logic and_4105_s24_q;
  logic and_4138_s24_q;
  logic or_4144_s24_q;
  logic and_4151_s24_q;
  logic or_4153_s24_q;
  logic not_4165_s24_q;
  logic or_4171_s24_q;
  logic and_4177_s24_q;
  logic and_4181_s24_q;
  logic [5:0] select_4183_s24_q;
  logic [31:0] select_4200_s24_q;
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
      patches_round_ends_s24_q <= patches_round_ends_q;
      patches_on_skin_s24_q <= patches_on_skin_q;
      equal_571_s24_q <= equal_571_s23_q;
      so_s24_q <= so_s23_q;
      equal_2397_s24_q <= equal_2397_s23_q;
      or_2443_s24_q <= equal_2441_s23_q | xor_2442;
      and_2444_s24_q <= five_times[0] & xor_2442;
      or_2449_s24_q <= equal_2441_s23_q | xor_2448;
      and_2450_s24_q <= five_times_2[0] & xor_2448;
      select_2465_s24_q <= select_2465_s23_q;
      or_3924_s24_q <= or_3924_s23_q;
      equal_3943_s24_q <= equal_3943_s23_q;
      and_4105_s24_q <= and_4105_s23_q;
      and_4138_s24_q <= equal_571_s23_q & (equal_3943_s23_q & (cfg_prove_i & or_4135));
      or_4144_s24_q <= select_3932_s23_q | select_3998;
      and_4151_s24_q <= equal_571_s23_q & and_4150;
      or_4153_s24_q <= or_4153;
      not_4165_s24_q <= ~(select_3961 < cfg_hidden_frames_i);
      or_4171_s24_q <= not_2349 | (select_4004 & not_3836);
      and_4177_s24_q <= and_4177_s23_q;
      and_4181_s24_q <= and_4181_s23_q;
      select_4183_s24_q <= select_4183_s23_q;
      select_4200_s24_q <= equal_571_s23_q ? (x_s23_q ? select_4198 : 32'h0) : 32'h0;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:391
  logic select_2445;
  assign select_2445 = or_2443_s24_q ? and_2444_s24_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2446;
  assign select_2446 = equal_2397_s24_q ? select_2445 : sharpness_comparing_less_detail_0_q;
  logic select_2447;
  assign select_2447 = so_s24_q ? select_2446 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic select_2451;
  assign select_2451 = or_2449_s24_q ? and_2450_s24_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2452;
  assign select_2452 = equal_2397_s24_q ? select_2451 : sharpness_comparing_less_detail_1_q;
  logic select_2453;
  assign select_2453 = so_s24_q ? select_2452 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:653
  logic [12:0] product_3839;
  assign product_3839 = {8'h0, cfg_on_skin_limit_i} * {5'h0, patches_places_q};
  // hls/stages/agreement.hpp:788
  logic and_4141;
  assign and_4141 = equal_571_s24_q & (equal_3943_s24_q & (cfg_prove_i & or_3924_s24_q));
  // hls/stages/agreement.hpp:1241
  logic not_4143;
  assign not_4143 = ~(or_3924_s24_q | not_2349);
  // hls/stages/agreement.hpp:788
  logic and_4147;
  assign and_4147 = equal_571_s24_q & (equal_3943_s24_q & (not_4143 & or_4144_s24_q));
  logic and_4160;
  assign and_4160 = equal_3943_s24_q & (not_4143 & (select_2453 | select_2465_s24_q));
  // hls/stages/agreement.hpp:1150
  logic and_4167;
  assign and_4167 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4165_s24_q);

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
      sharpness_comparing_less_detail_0_q <= 1'b0;
      sharpness_comparing_less_detail_1_q <= 1'b0;
    end else if (s24_en) begin
      sharpness_comparing_less_detail_0_q <= select_2447;
      sharpness_comparing_less_detail_1_q <= select_2453;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic patches_round_ends_s25_q;
  logic [7:0] patches_on_skin_s25_q;
  logic equal_571_s25_q;
  logic [7:0] product_3839_s25_q;
  logic equal_3943_s25_q;
  logic and_4105_s25_q;
  logic or_4129_s25_q;
  logic and_4130_s25_q;
  logic and_4138_s25_q;
  logic and_4141_s25_q;
  logic and_4147_s25_q;
  logic and_4151_s25_q;
  logic and_4156_s25_q;
  logic and_4160_s25_q;
  logic and_4169_s25_q;
  logic or_4171_s25_q;
  logic and_4177_s25_q;
  logic and_4181_s25_q;
  logic [5:0] select_4183_s25_q;
  logic [31:0] select_4200_s25_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      patches_round_ends_s25_q <= patches_round_ends_s24_q;
      patches_on_skin_s25_q <= patches_on_skin_s24_q;
      equal_571_s25_q <= equal_571_s24_q;
      product_3839_s25_q <= product_3839[12:5];
      equal_3943_s25_q <= equal_3943_s24_q;
      and_4105_s25_q <= and_4105_s24_q;
      or_4129_s25_q <= not_2349 | seen_q;
      and_4130_s25_q <= cfg_prove_i & nearer_q;
      and_4138_s25_q <= and_4138_s24_q;
      and_4141_s25_q <= and_4141;
      and_4147_s25_q <= and_4147;
      and_4151_s25_q <= and_4151_s24_q;
      and_4156_s25_q <= equal_3943_s24_q & (not_4143 & (select_2447 | or_4153_s24_q));
      and_4160_s25_q <= and_4160;
      and_4169_s25_q <= equal_571_s24_q & (equal_3943_s24_q & and_4167);
      or_4171_s25_q <= or_4171_s24_q;
      and_4177_s25_q <= and_4177_s24_q;
      and_4181_s25_q <= and_4181_s24_q;
      select_4183_s25_q <= select_4183_s24_q;
      select_4200_s25_q <= select_4200_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:188
  logic and_3841;
  assign and_3841 = (~(patches_on_skin_s25_q[7:2] == 6'h0)) & (product_3839_s25_q < patches_on_skin_s25_q);
  logic select_3846;
  assign select_3846 = patches_round_ends_s25_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:634
  logic or_3850;
  assign or_3850 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s25_q));
  // hls/stages/agreement.hpp:788
  logic and_4173;
  assign and_4173 = equal_3943_s25_q & (or_4171_s25_q ? cfg_prove_i : patches_overlooked_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s25_en) begin
      patches_large_q <= not_3836 & and_3841;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3846;
      patches_spoiled_q <= or_3850;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic and_4105_s26_q;
  logic or_4129_s26_q;
  logic and_4130_s26_q;
  logic and_4138_s26_q;
  logic and_4141_s26_q;
  logic and_4147_s26_q;
  logic and_4151_s26_q;
  logic and_4157_s26_q;
  logic and_4161_s26_q;
  logic and_4169_s26_q;
  logic and_4174_s26_q;
  logic and_4177_s26_q;
  logic and_4181_s26_q;
  logic [5:0] select_4183_s26_q;
  logic [31:0] select_4200_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      and_4105_s26_q <= and_4105_s25_q;
      or_4129_s26_q <= or_4129_s25_q;
      and_4130_s26_q <= and_4130_s25_q;
      and_4138_s26_q <= and_4138_s25_q;
      and_4141_s26_q <= and_4141_s25_q;
      and_4147_s26_q <= and_4147_s25_q;
      and_4151_s26_q <= and_4151_s25_q;
      and_4157_s26_q <= equal_571_s25_q & and_4156_s25_q;
      and_4161_s26_q <= equal_571_s25_q & and_4160_s25_q;
      and_4169_s26_q <= and_4169_s25_q;
      and_4174_s26_q <= equal_571_s25_q & and_4173;
      and_4177_s26_q <= and_4177_s25_q;
      and_4181_s26_q <= and_4181_s25_q;
      select_4183_s26_q <= select_4183_s25_q;
      select_4200_s26_q <= select_4200_s25_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s26_q;
  assign pixel_1_o = pixel_1_s26_q;
  assign saturated_o = saturated_s26_q;
  assign mask_o = mask_s26_q;
  assign marks_first_o = marks_first_s26_q;
  assign marks_last_o = marks_last_s26_q;
  assign marks_seen_o = or_4129_s26_q;
  assign marks_nearer_o = and_4130_s26_q;
  assign verdict_valid_o = and_4105_s26_q;
  assign verdict_unproven_yet_o = and_4138_s26_q;
  assign verdict_untextured_o = and_4141_s26_q;
  assign verdict_disagree_o = and_4147_s26_q;
  assign verdict_moved_o = and_4151_s26_q;
  assign verdict_unsharp_left_o = and_4157_s26_q;
  assign verdict_unsharp_right_o = and_4161_s26_q;
  assign verdict_hidden_o = and_4169_s26_q;
  assign verdict_overlooked_o = and_4174_s26_q;
  assign verdict_out_of_step_o = and_4177_s26_q;
  assign frame_valid_o = and_4181_s26_q;
  assign frame_index_o = select_4183_s26_q;
  assign frame_word_o = select_4200_s26_q;
  assign valid_o = valid_s26_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], product_3839[4:0], sum_3805[1:0], sum_3760[1:0], product_3651[4:0], sum_2743[0], difference_2684[1:0], detail_4[1:0], detail_3[1:0], sum_2282[4:0], sum_1765[1:0], sum_1764[1:0], sum_1760[0], sum_1709[0], sum_1705[0], sum_728[4:0], cfg_width_i[3:0]};

endmodule
