// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 27 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3116 bits, pipeline 8817 bits, memories 157167 bits.
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
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q, valid_s6_q, valid_s7_q, valid_s8_q, valid_s9_q, valid_s10_q, valid_s11_q, valid_s12_q, valid_s13_q, valid_s14_q, valid_s15_q, valid_s16_q, valid_s17_q, valid_s18_q, valid_s19_q, valid_s20_q, valid_s21_q, valid_s22_q, valid_s23_q, valid_s24_q, valid_s25_q, valid_s26_q, valid_s27_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en, s5_en, s6_en, s7_en, s8_en, s9_en, s10_en, s11_en, s12_en, s13_en, s14_en, s15_en, s16_en, s17_en, s18_en, s19_en, s20_en, s21_en, s22_en, s23_en, s24_en, s25_en, s26_en;
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

  // Of the configuration alone: not pipelined.
  logic not_2354;
  assign not_2354 = ~cfg_prove_i;
  logic [6:0] sum_2567;
  assign sum_2567 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3628;
  assign difference_3628 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3841;
  assign not_3841 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3899;
  assign difference_3899 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_4115;
  assign less_4115 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_4116;
  assign sum_4116 = {1'b0, cfg_height_i[10:7]} + 5'h1f;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic [3:0] raster_at_x_q;
  logic raster_row_ended_q;
  // hls/stages/census.hpp:36
  logic [3:0] select_508;
  assign select_508 = sample_pair_first_q ? 4'h0 : (raster_row_ended_q ? 4'h0 : raster_at_x_q);

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
      raster_at_x_q <= sample_pair_whole_q ? (select_508 + 4'h1) : raster_at_x_q;
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
  logic [3:0] select_508_s1_q;
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
      select_508_s1_q <= select_508;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_column_q;
  // hls/stages/census.hpp:36
  logic [6:0] select_511;
  assign select_511 = sample_pair_first_s1_q ? 7'h0 : (raster_row_ended_s1_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:51
  logic equal_546;
  assign equal_546 = select_508_s1_q == 4'hf;
  // hls/stages/agreement.hpp:276
  logic [6:0] select_2150;
  assign select_2150 = sample_pair_whole_s1_q ? (select_511 + {6'h0, equal_546}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2150;
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
  logic [3:0] select_508_s2_q;
  logic [6:0] select_511_s2_q;
  logic equal_546_s2_q;
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
      select_508_s2_q <= select_508_s1_q;
      select_511_s2_q <= select_511;
      equal_546_s2_q <= equal_546;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:110
  logic equal_509;
  assign equal_509 = select_508_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:117
  logic equal_512;
  assign equal_512 = {select_511_s2_q, select_508_s2_q} == 11'h0;
  // hls/stages/census.hpp:121
  logic [8:0] select_515;
  assign select_515 = equal_509 ? (equal_512 ? 9'h0 : (averager_place_q + 9'h1)) : averager_place_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] last;
  assign last = sample_pair_whole_s2_q ? select_511_s2_q : 7'h0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      averager_place_q <= sample_pair_whole_s2_q ? select_515 : averager_place_q;
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
  logic [3:0] select_508_s3_q;
  logic equal_509_s3_q;
  logic [6:0] select_511_s3_q;
  logic equal_512_s3_q;
  logic [8:0] select_515_s3_q;
  logic not_517_s3_q;
  logic [6:0] last_s3_q;
  logic equal_546_s3_q;
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
      select_508_s3_q <= select_508_s2_q;
      equal_509_s3_q <= equal_509;
      select_511_s3_q <= select_511_s2_q;
      equal_512_s3_q <= equal_512;
      select_515_s3_q <= select_515;
      not_517_s3_q <= ~(averager_place_q == 9'h1df);
      last_s3_q <= last;
      equal_546_s3_q <= equal_546_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  logic averager_inside_q;
  // hls/stages/census.hpp:121
  logic select_520;
  assign select_520 = equal_509_s3_q ? (equal_512_s3_q | (averager_inside_q & not_517_s3_q)) : averager_inside_q;
  // hls/stages/census.hpp:42
  logic or_521;
  assign or_521 = sample_pair_first_s3_q | raster_at_live_q;
  logic [3:0] select_529;
  assign select_529 = sample_pair_first_s3_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2148;
  assign select_2148 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (select_529 + 4'h1) : select_529) : raster_at_y_q;
  logic select_2157;
  assign select_2157 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_521 & (~raster_final_row_q)) : or_521) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [10:0] select_2159;
  assign select_2159 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:276
  logic select_2163;
  assign select_2163 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [7:0] sum_2472;
  assign sum_2472 = {1'b0, last_s3_q} + 8'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_inside_q <= 1'b1;
    end else if (s3_en) begin
      raster_at_y_q <= select_2148;
      raster_at_live_q <= select_2157;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2159 : raster_rows_left_q;
      raster_final_row_q <= select_2163;
      averager_inside_q <= sample_pair_whole_s3_q ? select_520 : averager_inside_q;
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
  logic sample_last_s4_q;
  logic sample_present_s4_q;
  logic [3:0] select_508_s4_q;
  logic equal_509_s4_q;
  logic [6:0] select_511_s4_q;
  logic [8:0] select_515_s4_q;
  logic and_524_s4_q;
  logic [3:0] select_529_s4_q;
  logic [6:0] last_s4_q;
  logic equal_546_s4_q;
  logic equal_547_s4_q;
  logic equal_1682_s4_q;
  logic equal_2473_s4_q;
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
      sample_last_s4_q <= sample_last_s3_q;
      sample_present_s4_q <= sample_present_s3_q;
      select_508_s4_q <= select_508_s3_q;
      equal_509_s4_q <= equal_509_s3_q;
      select_511_s4_q <= select_511_s3_q;
      select_515_s4_q <= select_515_s3_q;
      and_524_s4_q <= select_520 & (or_521 & (select_508_s3_q[1:0] == 2'h3));
      select_529_s4_q <= select_529;
      last_s4_q <= last_s3_q;
      equal_546_s4_q <= equal_546_s3_q;
      equal_547_s4_q <= select_529 == 4'hf;
      equal_1682_s4_q <= {or_521, select_529} == 5'h18;
      equal_2473_s4_q <= {sum_2472[7], cfg_width_i[10:4]} == {1'b0, sum_2472[6:0]};
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  // hls/stages/census.hpp:131
  logic and_548;
  assign and_548 = equal_547_s4_q & and_524_s4_q;
  // hls/stages/agreement.hpp:276
  logic and_550;
  assign and_550 = sample_pair_whole_s4_q & (equal_546_s4_q & and_548);
  // hls/stages/census.hpp:42
  logic [6:0] select_678;
  assign select_678 = sample_pair_first_s4_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] row;
  assign row = sample_pair_whole_s4_q ? select_678 : 7'h0;
  // hls/stages/census.hpp:58
  logic [6:0] select_2152;
  assign select_2152 = sample_last_s4_q ? (select_678 + {6'h0, equal_547_s4_q}) : select_678;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
    end else if (s4_en) begin
      raster_at_row_q <= sample_pair_whole_s4_q ? select_2152 : raster_at_row_q;
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
  logic [3:0] select_508_s5_q;
  logic equal_509_s5_q;
  logic [6:0] select_511_s5_q;
  logic [8:0] select_515_s5_q;
  logic and_524_s5_q;
  logic [3:0] select_529_s5_q;
  logic [6:0] last_s5_q;
  logic and_548_s5_q;
  logic and_550_s5_q;
  logic [3:0] select_678_s5_q;
  logic [6:0] row_s5_q;
  logic equal_1682_s5_q;
  logic equal_2473_s5_q;
  logic and_2474_s5_q;
  logic [7:0] sum_2563_s5_q;
  logic [2:0] or_3004_s5_q;
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
      select_508_s5_q <= select_508_s4_q;
      equal_509_s5_q <= equal_509_s4_q;
      select_511_s5_q <= select_511_s4_q;
      select_515_s5_q <= select_515_s4_q;
      and_524_s5_q <= and_524_s4_q;
      select_529_s5_q <= select_529_s4_q;
      last_s5_q <= last_s4_q;
      and_548_s5_q <= and_548;
      and_550_s5_q <= and_550;
      select_678_s5_q <= select_678[3:0];
      row_s5_q <= row;
      equal_1682_s5_q <= equal_1682_s4_q;
      equal_2473_s5_q <= equal_2473_s4_q;
      and_2474_s5_q <= and_550 & equal_2473_s4_q;
      sum_2563_s5_q <= {1'b0, row} + 8'h1;
      or_3004_s5_q <= select_511_s4_q[2:0] | select_678[6:4];
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/patches.hpp:122
  logic and_1676;
  assign and_1676 = (select_508_s5_q == 4'h0) & (select_511_s5_q == 7'h0);
  // hls/stages/agreement.hpp:523
  logic select_2477;
  assign select_2477 = (and_2474_s5_q | (~ends_cell_q)) ? and_2474_s5_q : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2477 ? (and_2474_s5_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2481;
  assign select_2481 = select_2477 ? (and_2474_s5_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2484;
  assign select_2484 = select_2477 ? (following_last_shift_q & (~and_2474_s5_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:535
  logic [7:0] select_2486;
  assign select_2486 = select_2477 ? (and_2474_s5_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:607
  logic and_2487;
  assign and_2487 = run_last_shift_q & equal_594;
  // hls/stages/agreement.hpp:616
  logic select_2489;
  assign select_2489 = equal_594 ? (~run_last_shift_q) : equal_595;
  // hls/stages/agreement.hpp:620
  logic equal_2490;
  assign equal_2490 = run_phase_q == 3'h1;
  logic not_2493;
  assign not_2493 = ~select_2489;
  // hls/stages/agreement.hpp:623
  logic equal_2495;
  assign equal_2495 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2496;
  assign and_2496 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2497;
  assign select_2497 = equal_2495 ? 2'h1 : {2{and_2496}};
  logic [2:0] select_2499;
  assign select_2499 = (and_2487 | (select_2489 | equal_2490)) ? (equal_2490 ? 3'h2 : {not_2493, {2{select_2489}}}) : (equal_579 ? 3'h6 : {select_2497[0], select_2497});
  // hls/stages/agreement.hpp:607
  logic and_2502;
  assign and_2502 = select_2489 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2505;
  assign select_2505 = (plan_shift_q[5] & select_2489) ? value : 7'h0;
  logic [1:0] or_2506;
  assign or_2506 = {2{so}} | select_2505[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2510;
  assign or_2510 = (select_2489 ? plan_columns_q : 8'h0) | ((equal_2490 | equal_2495) ? whole_q : 8'h0);
  logic [1:0] or_2511;
  assign or_2511 = {2{and_2487}} | or_2510[4:3];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2513;
  assign or_2513 = {or_2510[7:5], or_2511, or_2510[2:0]} | (equal_579 ? drawn_q : 8'h0);
  logic [4:0] or_2514;
  assign or_2514 = {5{so}} | {or_2513[6], or_2513[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2518;
  assign not_2518 = ~run_shift_q[5];
  logic [7:0] select_2521;
  assign select_2521 = equal_594 ? ({{7{not_2518}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2525;
  assign select_2525 = and_2474_s5_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2527;
  assign select_2527 = select_2477 ? {select_2525[6], select_2525} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2530;
  assign select_2530 = select_2477 ? (and_2474_s5_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:460
  logic [6:0] select_2537;
  assign select_2537 = equal_2473_s5_q ? ((6'he < last_s5_q[6:1]) ? 7'h1d : last_s5_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2539;
  assign sum_2539 = {1'b0, last_s5_q[6:3]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2541;
  assign select_2541 = and_550_s5_q ? (equal_2473_s5_q ? {sum_2539, last_s5_q[2:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_2542;
  assign sum_2542 = {1'b0, last_s5_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2544;
  assign select_2544 = and_550_s5_q ? (equal_2473_s5_q ? {sum_2542, last_s5_q[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2558;
  assign select_2558 = (ends_cell_q | select_2477) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_594 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2562;
  assign and_2562 = (~select_2477) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic equal_2564;
  assign equal_2564 = {sum_2563_s5_q[7], cfg_height_i[10:4]} == {1'b0, sum_2563_s5_q[6:0]};
  // hls/stages/agreement.hpp:520
  logic select_2566;
  assign select_2566 = and_550_s5_q ? (equal_2473_s5_q ? equal_2564 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2941;
  assign select_2941 = and_1676 ? (sample_pair_first_s5_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/patches.hpp:371
  logic [8:0] sum_3005;
  assign sum_3005 = {1'b0, select_511_s5_q[3], or_3004_s5_q, select_678_s5_q} + 9'h1;

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
    end else if (s5_en) begin
      run_phase_q <= now;
      run_shift_q <= select_2481;
      run_last_shift_q <= select_2484;
      run_span_q <= select_2486;
      following_phase_q <= select_2499;
      following_shift_q <= select_2489 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2502;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2505[6], or_2506, select_2505[3:0]};
      following_columns_q <= {or_2513[7], or_2514[4], or_2513[5:4], or_2514[3:0]};
      plan_shift_q <= equal_594 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2521;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2527;
      columns_left_q <= select_2530;
      last_q <= and_550_s5_q ? (equal_2473_s5_q ? last_s5_q : last_q) : last_q;
      least_q <= and_550_s5_q ? select_2537 : least_q;
      whole_q <= select_2541;
      drawn_q <= select_2544;
      slot_q <= select_2477 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2558;
      ends_q <= and_2562;
      final_row_q <= select_2566;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= sample_pair_whole_s5_q ? select_2941 : patches_phase_q;
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
  logic [2:0] slot_s6_q;
  logic ends_cell_s6_q;
  logic shift_first_s6_q;
  logic [3:0] select_508_s6_q;
  logic equal_509_s6_q;
  logic [6:0] select_511_s6_q;
  logic [8:0] select_515_s6_q;
  logic and_524_s6_q;
  logic equal_530_s6_q;
  logic [6:0] last_s6_2_q;
  logic and_548_s6_q;
  logic and_550_s6_q;
  logic equal_575_s6_q;
  logic so_s6_q;
  logic equal_579_s6_q;
  logic [7:0] sum_581_s6_q;
  logic equal_594_s6_q;
  logic equal_595_s6_q;
  logic [7:0] sum_612_s6_q;
  logic [6:0] row_s6_q;
  logic and_1676_s6_q;
  logic equal_1682_s6_q;
  logic equal_2473_s6_q;
  logic and_2474_s6_q;
  logic select_2477_s6_q;
  logic [3:0] phase_s6_q;
  logic not_3007_s6_q;
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
      run_shift_s6_q <= run_shift_q;
      x_s6_q <= x_q;
      last_s6_q <= last_q;
      slot_s6_q <= slot_q;
      ends_cell_s6_q <= ends_cell_q;
      shift_first_s6_q <= shift_first_q;
      select_508_s6_q <= select_508_s5_q;
      equal_509_s6_q <= equal_509_s5_q;
      select_511_s6_q <= select_511_s5_q;
      select_515_s6_q <= select_515_s5_q;
      and_524_s6_q <= and_524_s5_q;
      equal_530_s6_q <= select_529_s5_q == 4'h0;
      last_s6_2_q <= last_s5_q;
      and_548_s6_q <= and_548_s5_q;
      and_550_s6_q <= and_550_s5_q;
      equal_575_s6_q <= run_phase_q == 3'h7;
      so_s6_q <= so;
      equal_579_s6_q <= equal_579;
      sum_581_s6_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      equal_594_s6_q <= equal_594;
      equal_595_s6_q <= equal_595;
      sum_612_s6_q <= {1'b0, last_q} + 8'h3;
      row_s6_q <= row_s5_q;
      and_1676_s6_q <= and_1676;
      equal_1682_s6_q <= equal_1682_s5_q;
      equal_2473_s6_q <= equal_2473_s5_q;
      and_2474_s6_q <= and_2474_s5_q;
      select_2477_s6_q <= select_2477;
      phase_s6_q <= phase;
      not_3007_s6_q <= ~({sum_3005, select_529_s5_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_582;
  assign select_582 = run_shift_s6_q[5] ? x_s6_q : sum_581_s6_q;
  logic less_583;
  assign less_583 = {1'b0, last_s6_q} < select_582;
  // hls/stages/agreement.hpp:226
  logic not_584;
  assign not_584 = ~less_583;
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_s6_q + 8'hfd;
  // hls/stages/agreement.hpp:528
  logic [6:0] select_2546;
  assign select_2546 = select_2477_s6_q ? 7'h0 : (ends_cell_s6_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s6_en) begin
      age_q <= select_2546;
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
  logic [3:0] select_508_s7_q;
  logic equal_509_s7_q;
  logic [6:0] select_511_s7_q;
  logic [8:0] select_515_s7_q;
  logic and_524_s7_q;
  logic equal_530_s7_q;
  logic [6:0] last_s7_2_q;
  logic and_548_s7_q;
  logic and_550_s7_q;
  logic equal_575_s7_q;
  logic so_s7_q;
  logic equal_579_s7_q;
  logic [6:0] sum_581_s7_q;
  logic less_583_s7_q;
  logic not_584_s7_q;
  logic equal_594_s7_q;
  logic and_596_s7_q;
  logic [6:0] x_s7_2_q;
  logic and_616_s7_q;
  logic [6:0] row_s7_q;
  logic equal_1563_s7_q;
  logic and_1676_s7_q;
  logic equal_1682_s7_q;
  logic equal_2473_s7_q;
  logic and_2474_s7_q;
  logic [3:0] phase_s7_q;
  logic equal_2961_s7_q;
  logic [3:0] select_2964_s7_q;
  logic not_3007_s7_q;
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
      age_s7_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s7_q <= slot_s6_q;
      ends_cell_s7_q <= ends_cell_s6_q;
      shift_first_s7_q <= shift_first_s6_q;
      select_508_s7_q <= select_508_s6_q;
      equal_509_s7_q <= equal_509_s6_q;
      select_511_s7_q <= select_511_s6_q;
      select_515_s7_q <= select_515_s6_q;
      and_524_s7_q <= and_524_s6_q;
      equal_530_s7_q <= equal_530_s6_q;
      last_s7_2_q <= last_s6_2_q;
      and_548_s7_q <= and_548_s6_q;
      and_550_s7_q <= and_550_s6_q;
      equal_575_s7_q <= equal_575_s6_q;
      so_s7_q <= so_s6_q;
      equal_579_s7_q <= equal_579_s6_q;
      sum_581_s7_q <= sum_581_s6_q[6:0];
      less_583_s7_q <= less_583;
      not_584_s7_q <= not_584;
      equal_594_s7_q <= equal_594_s6_q;
      and_596_s7_q <= equal_595_s6_q & not_584;
      x_s7_2_q <= x[6:0];
      and_616_s7_q <= age_q[2] & (ends_cell_s6_q & (~(sum_612_s6_q < select_582)));
      row_s7_q <= row_s6_q;
      equal_1563_s7_q <= {x[7], last_s6_q} == {1'b0, x[6:0]};
      and_1676_s7_q <= and_1676_s6_q;
      equal_1682_s7_q <= equal_1682_s6_q;
      equal_2473_s7_q <= equal_2473_s6_q;
      and_2474_s7_q <= and_2474_s6_q;
      phase_s7_q <= phase_s6_q;
      equal_2961_s7_q <= row_s6_q == 7'h3;
      select_2964_s7_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_3007_s7_q <= not_3007_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:594
  logic or_580;
  assign or_580 = so_s7_q | equal_579_s7_q;
  // hls/stages/agreement.hpp:149
  logic select_598;
  assign select_598 = or_580 ? not_584_s7_q : (equal_594_s7_q ? not_584_s7_q : and_596_s7_q);
  logic and_617;
  assign and_617 = equal_594_s7_q & and_616_s7_q;
  logic select_618;
  assign select_618 = or_580 ? not_584_s7_q : and_617;
  // hls/stages/agreement.hpp:821
  logic [6:0] right;
  assign right = sum_581_s7_q + 7'h7d;
  // hls/stages/agreement.hpp:149
  logic [6:0] select_642;
  assign select_642 = or_580 ? x_s7_q[6:0] : (equal_594_s7_q ? sum_581_s7_q : x_s7_q[6:0]);
  // hls/stages/agreement.hpp:720
  logic not_648;
  assign not_648 = ~or_580;
  // hls/stages/agreement.hpp:520
  logic and_2831;
  assign and_2831 = and_550_s7_q & (equal_2473_s7_q & (row_s7_q[6:2] == 5'h0));
  // hls/stages/patches.hpp:87
  logic [3:0] select_2965;
  assign select_2965 = equal_2961_s7_q ? select_2964_s7_q : patches_choosing_rows_to_next_q;
  logic equal_2966;
  assign equal_2966 = select_2965 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2969;
  assign select_2969 = equal_2473_s7_q ? (equal_2966 ? 4'h2 : (select_2965 + 4'hf)) : patches_choosing_rows_to_next_q;

  // Memory left, 120 x 85, DISTANCE 24, hls/stages/agreement.hpp:1373; read in stage 7, written in stage 10: 7 < 10 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [84:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 85'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s7_q[6:0];
`ifndef SYNTHESIS
  logic left_re;
  assign left_re = s7_en & select_598;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 99, DISTANCE 24, hls/stages/agreement.hpp:1374; read in stage 7, written in stage 10: 7 < 10 < 7 + DISTANCE.
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
  assign right_codes_re = s7_en & select_598;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1375; read in stage 7, written in stage 18: 7 < 18 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [61:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 62'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_580 ? x_s7_q[6:0] : x_s7_2_q;
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s7_en & select_618;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s7_en) begin
      patches_choosing_rows_to_next_q <= and_550_s7_q ? select_2969 : patches_choosing_rows_to_next_q;
    end
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
  logic [3:0] patches_choosing_rows_to_next_s8_q;
  logic [3:0] select_508_s8_q;
  logic equal_509_s8_q;
  logic [6:0] select_511_s8_q;
  logic [8:0] select_515_s8_q;
  logic and_524_s8_q;
  logic equal_530_s8_q;
  logic [6:0] last_s8_2_q;
  logic and_548_s8_q;
  logic and_550_s8_q;
  logic equal_575_s8_q;
  logic so_s8_q;
  logic equal_579_s8_q;
  logic or_580_s8_q;
  logic less_583_s8_q;
  logic not_584_s8_q;
  logic equal_594_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_618_s8_q;
  logic [6:0] right_s8_q;
  logic and_651_s8_q;
  logic [6:0] row_s8_q;
  logic and_1562_s8_q;
  logic equal_1563_s8_q;
  logic and_1676_s8_q;
  logic equal_1682_s8_q;
  logic equal_2473_s8_q;
  logic and_2832_s8_q;
  logic and_2834_s8_q;
  logic and_2841_s8_q;
  logic [3:0] phase_s8_q;
  logic equal_2961_s8_q;
  logic equal_2966_s8_q;
  logic not_3007_s8_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      patches_choosing_rows_to_next_s8_q <= patches_choosing_rows_to_next_q;
      select_508_s8_q <= select_508_s7_q;
      equal_509_s8_q <= equal_509_s7_q;
      select_511_s8_q <= select_511_s7_q;
      select_515_s8_q <= select_515_s7_q;
      and_524_s8_q <= and_524_s7_q;
      equal_530_s8_q <= equal_530_s7_q;
      last_s8_2_q <= last_s7_2_q;
      and_548_s8_q <= and_548_s7_q;
      and_550_s8_q <= and_550_s7_q;
      equal_575_s8_q <= equal_575_s7_q;
      so_s8_q <= so_s7_q;
      equal_579_s8_q <= equal_579_s7_q;
      or_580_s8_q <= or_580;
      less_583_s8_q <= less_583_s7_q;
      not_584_s8_q <= not_584_s7_q;
      equal_594_s8_q <= equal_594_s7_q;
      x_s8_2_q <= x_s7_2_q;
      select_618_s8_q <= select_618;
      right_s8_q <= right;
      and_651_s8_q <= not_648 & ((~equal_594_s7_q) & and_596_s7_q);
      row_s8_q <= row_s7_q;
      and_1562_s8_q <= not_648 & and_617;
      equal_1563_s8_q <= equal_1563_s7_q;
      and_1676_s8_q <= and_1676_s7_q;
      equal_1682_s8_q <= equal_1682_s7_q;
      equal_2473_s8_q <= equal_2473_s7_q;
      and_2832_s8_q <= and_2474_s7_q & and_2831;
      and_2834_s8_q <= and_2474_s7_q & (~and_2831);
      and_2841_s8_q <= ends_cell_s7_q & so_s7_q;
      phase_s8_q <= phase_s7_q;
      equal_2961_s8_q <= equal_2961_s7_q;
      equal_2966_s8_q <= equal_2966;
      not_3007_s8_q <= not_3007_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
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
  logic not_1680;
  assign not_1680 = ~sample_pair_first_s8_q;
  // hls/stages/patches.hpp:311
  logic equal_1684;
  assign equal_1684 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1756;
  assign select_1756 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1999;
  assign sum_1999 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2835;
  assign select_2835 = and_2834_s8_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2837;
  assign select_2837 = and_2832_s8_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2835[15]}}, select_2835});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2838;
  assign select_2838 = and_2834_s8_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2838[15]}}, select_2838};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2840;
  assign select_2840 = and_2832_s8_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2841_s8_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:373
  logic and_2943;
  assign and_2943 = not_1680 & equal_1682_s8_q;
  logic [8:0] select_2944;
  assign select_2944 = and_2943 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s8_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2945;
  assign select_2945 = and_2943 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2946;
  assign select_2946 = sample_pair_first_s8_q ? select_2944 : select_2945;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2947;
  assign select_2947 = and_1676_s8_q ? select_2946[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2948;
  assign select_2948 = sample_pair_whole_s8_q ? select_2947 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2950;
  assign select_2950 = sample_pair_whole_s8_q ? (and_1676_s8_q ? select_2946[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2953;
  assign select_2953 = sample_pair_whole_s8_q ? (equal_1684 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2955;
  assign select_2955 = sample_pair_whole_s8_q ? (patches_band_rows_number_q + {4'h0, equal_1684}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2956;
  assign equal_2956 = phase_s8_q == 4'h0;
  // hls/stages/patches.hpp:331
  logic not_2957;
  assign not_2957 = ~equal_2956;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2959;
  assign select_2959 = sample_pair_whole_s8_q ? (phase_s8_q + {{2{not_2957}}, 1'b1, not_2957}) : patches_first_band_rows_to_next_q;
  logic select_2960;
  assign select_2960 = sample_pair_whole_s8_q ? equal_2956 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2971;
  assign select_2971 = equal_2961_s8_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2973;
  assign select_2973 = equal_2473_s8_q ? (select_2971 + {4'h0, equal_2966_s8_q}) : patches_choosing_number_q;
  logic select_2977;
  assign select_2977 = equal_2473_s8_q ? ((7'h2 < row_s8_q) & equal_2966_s8_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:520
  logic [4:0] select_2980;
  assign select_2980 = and_550_s8_q ? (equal_2473_s8_q ? select_2971 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3889;
  assign select_3889 = so_s8_q ? (and_2841_s8_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3891;
  assign sum_3891 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3892;
  assign select_3892 = sum_1999[5] ? {1'b1, sum_1999[4:0], region_across_rest_q[2:0]} : sum_3891;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3894;
  assign select_3894 = equal_2473_s8_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3897;
  assign select_3897 = equal_2473_s8_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1372; read in stage 8, written in stage 24: 8 < 24 < 8 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 33'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s8_q[6:0];
`ifndef SYNTHESIS
  logic fresh_re;
  assign fresh_re = s8_en & and_651_s8_q;
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
    end else if (s8_en) begin
      registration_slope_row_q <= select_2837;
      registration_slope_change_q <= select_2840;
      registration_slope_q <= so_s8_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2948;
      patches_band_rows_number_q <= select_2950;
      patches_next_band_rows_to_next_q <= select_2953;
      patches_next_band_number_q <= select_2955;
      patches_first_band_rows_to_next_q <= select_2959;
      patches_first_band_number_q <= select_2960;
      patches_choosing_number_q <= and_550_s8_q ? select_2973 : patches_choosing_number_q;
      patches_chooses_q <= and_550_s8_q ? select_2977 : patches_chooses_q;
      patches_choosing_band_q <= select_2980;
      region_across_rest_q <= select_3889;
      region_across_back_q <= so_s8_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3892;
      columns_begin_rest_q <= and_550_s8_q ? select_3894 : columns_begin_rest_q;
      columns_begin_back_q <= and_550_s8_q ? select_3897 : columns_begin_back_q;
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
  logic shift_first_s9_q;
  logic [11:0] registration_slope_s9_q;
  logic [4:0] patches_band_rows_number_s9_q;
  logic patches_chooses_s9_q;
  logic [4:0] patches_choosing_band_s9_q;
  logic [3:0] select_508_s9_q;
  logic equal_509_s9_q;
  logic [6:0] select_511_s9_q;
  logic [8:0] select_515_s9_q;
  logic and_524_s9_q;
  logic equal_530_s9_q;
  logic [6:0] last_s9_2_q;
  logic and_548_s9_q;
  logic and_550_s9_q;
  logic equal_575_s9_q;
  logic so_s9_q;
  logic equal_579_s9_q;
  logic or_580_s9_q;
  logic less_583_s9_q;
  logic not_584_s9_q;
  logic equal_594_s9_q;
  logic [84:0] left_rdata_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_618_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic [6:0] right_s9_q;
  logic [98:0] right_codes_rdata_s9_q;
  logic and_651_s9_q;
  logic [6:0] row_s9_q;
  logic and_1562_s9_q;
  logic equal_1563_s9_q;
  logic and_1676_s9_q;
  logic not_1680_s9_q;
  logic or_1686_s9_q;
  logic [16:0] select_1756_s9_q;
  logic sum_1999_s9_q;
  logic equal_2473_s9_q;
  logic not_3007_s9_q;
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
      shift_first_s9_q <= shift_first_s8_q;
      registration_slope_s9_q <= registration_slope_q[27:16];
      patches_band_rows_number_s9_q <= patches_band_rows_number_q;
      patches_chooses_s9_q <= patches_chooses_q;
      patches_choosing_band_s9_q <= patches_choosing_band_q;
      select_508_s9_q <= select_508_s8_q;
      equal_509_s9_q <= equal_509_s8_q;
      select_511_s9_q <= select_511_s8_q;
      select_515_s9_q <= select_515_s8_q;
      and_524_s9_q <= and_524_s8_q;
      equal_530_s9_q <= equal_530_s8_q;
      last_s9_2_q <= last_s8_2_q;
      and_548_s9_q <= and_548_s8_q;
      and_550_s9_q <= and_550_s8_q;
      equal_575_s9_q <= equal_575_s8_q;
      so_s9_q <= so_s8_q;
      equal_579_s9_q <= equal_579_s8_q;
      or_580_s9_q <= or_580_s8_q;
      less_583_s9_q <= less_583_s8_q;
      not_584_s9_q <= not_584_s8_q;
      equal_594_s9_q <= equal_594_s8_q;
      left_rdata_s9_q <= left_rdata_q;
      x_s9_2_q <= x_s8_2_q;
      select_618_s9_q <= select_618_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_q;
      right_s9_q <= right_s8_q;
      right_codes_rdata_s9_q <= right_codes_rdata_q;
      and_651_s9_q <= and_651_s8_q;
      row_s9_q <= row_s8_q;
      and_1562_s9_q <= and_1562_s8_q;
      equal_1563_s9_q <= equal_1563_s8_q;
      and_1676_s9_q <= and_1676_s8_q;
      not_1680_s9_q <= not_1680;
      or_1686_s9_q <= (~equal_1682_s8_q) | (~equal_1684);
      select_1756_s9_q <= select_1756;
      sum_1999_s9_q <= sum_1999[5];
      equal_2473_s9_q <= equal_2473_s8_q;
      not_3007_s9_q <= not_3007_s8_q;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
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
  logic equal_569;
  assign equal_569 = row_q == 7'h0;
  // hls/stages/agreement.hpp:975
  logic and_608;
  assign and_608 = (or_580_s9_q & (left_rdata_s9_q[67] & not_584_s9_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s9_q[2] ? best_left_rdata_s9_q[5:0] : best_left_rdata_s9_q[45:40];
  // hls/stages/agreement.hpp:668
  logic not_748;
  assign not_748 = ~equal_569;
  // hls/stages/agreement.hpp:221
  logic and_763;
  assign and_763 = left_rdata_s9_q[48] & not_584_s9_q;
  logic and_764;
  assign and_764 = right_codes_rdata_s9_q[42] & not_584_s9_q;
  logic [11:0] select_765;
  assign select_765 = less_583_s9_q ? 12'h0 : left_rdata_s9_q[47:36];
  logic [11:0] select_766;
  assign select_766 = less_583_s9_q ? 12'h0 : right_codes_rdata_s9_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_770;
  assign select_770 = and_763 ? (and_764 ? (~(select_765 ^ select_766)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_786;
  assign and_786 = left_rdata_s9_q[66] & not_584_s9_q;
  logic and_787;
  assign and_787 = right_codes_rdata_s9_q[57] & not_584_s9_q;
  logic [11:0] select_788;
  assign select_788 = less_583_s9_q ? 12'h0 : left_rdata_s9_q[65:54];
  logic [11:0] select_789;
  assign select_789 = less_583_s9_q ? 12'h0 : right_codes_rdata_s9_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_793;
  assign select_793 = and_786 ? (and_787 ? (~(select_788 ^ select_789)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_803;
  assign and_803 = left_rdata_s9_q[84] & not_584_s9_q;
  logic and_804;
  assign and_804 = right_codes_rdata_s9_q[72] & not_584_s9_q;
  logic [11:0] select_805;
  assign select_805 = less_583_s9_q ? 12'h0 : left_rdata_s9_q[83:72];
  logic [11:0] select_806;
  assign select_806 = less_583_s9_q ? 12'h0 : right_codes_rdata_s9_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_810;
  assign select_810 = and_803 ? (and_804 ? (~(select_805 ^ select_806)) : 12'h0) : 12'h0;
  logic [11:0] select_1018;
  assign select_1018 = (slot_s9_q[0] ? and_804 : and_787) ? (~(select_765 ^ (slot_s9_q[0] ? select_806 : select_789))) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_1035;
  assign and_1035 = right_codes_rdata_s9_q[85] & not_584_s9_q;
  logic [11:0] select_1037;
  assign select_1037 = less_583_s9_q ? 12'h0 : right_codes_rdata_s9_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1041;
  assign select_1041 = (slot_s9_q[0] ? and_1035 : and_804) ? (~(select_788 ^ (slot_s9_q[0] ? select_1037 : select_806))) : 12'h0;
  // hls/stages/agreement.hpp:734
  logic select_1053;
  assign select_1053 = slot_s9_q[0] ? (right_codes_rdata_s9_q[98] & not_584_s9_q) : and_1035;
  logic [11:0] select_1055;
  assign select_1055 = slot_s9_q[0] ? (less_583_s9_q ? 12'h0 : right_codes_rdata_s9_q[97:86]) : select_1037;
  // hls/stages/agreement.hpp:221
  logic and_1264;
  assign and_1264 = right_codes_rdata_s9_q[27] & not_584_s9_q;
  // hls/stages/agreement.hpp:734
  logic select_1265;
  assign select_1265 = slot_s9_q[0] ? (right_codes_rdata_s9_q[12] & not_584_s9_q) : and_1264;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1267;
  assign select_1267 = less_583_s9_q ? 12'h0 : right_codes_rdata_s9_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1268;
  assign select_1268 = slot_s9_q[0] ? (less_583_s9_q ? 12'h0 : right_codes_rdata_s9_q[11:0]) : select_1267;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1292;
  assign select_1292 = (slot_s9_q[0] ? and_1264 : and_764) ? (~(select_788 ^ (slot_s9_q[0] ? select_1267 : select_766))) : 12'h0;
  logic [11:0] select_1307;
  assign select_1307 = (slot_s9_q[0] ? and_764 : and_787) ? (~(select_805 ^ (slot_s9_q[0] ? select_766 : select_789))) : 12'h0;
  // hls/stages/patches.hpp:392
  logic not_1677;
  assign not_1677 = ~patches_begins_q;
  // hls/stages/patches.hpp:362
  logic and_1681;
  assign and_1681 = patches_capturing_q & not_1680_s9_q;
  // hls/stages/patches.hpp:125
  logic and_1689;
  assign and_1689 = (not_1677 & (patches_work_q == 3'h0)) & (~(and_1681 | or_1686_s9_q));
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s9_q[6:1]} < x_s9_q;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_580_s9_q ? (less_583_s9_q ? 6'h0 : best_left_rdata_s9_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1758;
  assign select_1758 = ($signed(10'h0) < $signed(select_1756_s9_q[16:7])) ? 14'h7f : select_1756_s9_q[13:0];
  // hls/stages/patches.hpp:534
  logic equal_1788;
  assign equal_1788 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:505
  logic equal_1790;
  assign equal_1790 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:499
  logic equal_1792;
  assign equal_1792 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1793;
  assign equal_1793 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:534
  logic or_1794;
  assign or_1794 = equal_1792 | equal_1793;
  // hls/stages/patches.hpp:460
  logic not_1795;
  assign not_1795 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_1817;
  assign select_1817 = and_1689 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1818;
  assign select_1818 = and_1676_s9_q ? select_1817 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1820;
  assign and_1820 = and_1681 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1824;
  assign select_1824 = and_1676_s9_q ? (and_1689 | (and_1681 & (~and_1820))) : patches_capturing_q;
  // hls/stages/patches.hpp:167
  logic not_1849;
  assign not_1849 = ~equal_1793;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1863;
  assign select_1863 = and_1676_s9_q ? {select_1817[4], select_1817[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:546
  logic less_1967;
  assign less_1967 = patches_step_q[4:0] < 5'h11;
  logic equal_1968;
  assign equal_1968 = patches_step_q[6:5] == 2'h0;
  logic not_1969;
  assign not_1969 = ~equal_1968;
  logic equal_1970;
  assign equal_1970 = patches_step_q[6:5] == 2'h3;
  logic not_1971;
  assign not_1971 = ~equal_1970;
  // hls/stages/patches.hpp:560
  logic select_1974;
  assign select_1974 = equal_1970 ? (less_1967 & (less_1967 & not_1971)) : less_1967;
  // hls/stages/agreement.hpp:460
  logic select_2570;
  assign select_2570 = equal_2473_s9_q ? (~({row_s9_q, 1'b0} < {sum_2567, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2731;
  assign select_2731 = or_580_s9_q ? (less_583_s9_q ? 8'h0 : best_left_rdata_s9_q[32:25]) : 8'h0;
  logic [7:0] select_2733;
  assign select_2733 = or_580_s9_q ? (less_583_s9_q ? 8'h0 : best_left_rdata_s9_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:91
  logic parity_2984;
  assign parity_2984 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2985;
  assign select_2985 = equal_2473_s9_q ? {patches_chance_q[14:0], parity_2984} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s9_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:393
  logic or_3048;
  assign or_3048 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3054;
  assign and_3054 = equal_1788 & not_1795;
  // hls/stages/patches.hpp:399
  logic and_3055;
  assign and_3055 = not_1849 & and_3054;
  logic [1:0] select_3057;
  assign select_3057 = equal_1790 ? 2'h0 : (equal_1792 ? 2'h3 : {equal_1793, and_3055});
  // hls/stages/patches.hpp:279
  logic equal_3059;
  assign equal_3059 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3060;
  assign not_3060 = ~equal_3059;
  // hls/stages/patches.hpp:279
  logic equal_3061;
  assign equal_3061 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3062;
  assign not_3062 = ~equal_3061;
  // hls/stages/patches.hpp:283
  logic not_3064;
  assign not_3064 = ~(patches_following_q == 3'h2);
  logic and_3067;
  assign and_3067 = (~(patches_following_q == 3'h1)) & not_3064;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3068;
  assign select_3068 = equal_3061 ? 2'h2 : {and_3067, not_3064};
  logic [3:0] select_3069;
  assign select_3069 = equal_3059 ? 4'h2 : {select_3068, {2{not_3062}}};
  // hls/stages/patches.hpp:405
  logic not_3072;
  assign not_3072 = ~or_3048;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3077;
  assign select_3077 = or_3048 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

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
    end else if (s9_en) begin
      row_q <= and_550_s9_q ? (equal_2473_s9_q ? row_s9_q : row_q) : row_q;
      lower_half_q <= and_550_s9_q ? select_2570 : lower_half_q;
      patches_chance_q <= and_550_s9_q ? select_2985 : patches_chance_q;
      patches_capturing_q <= sample_pair_whole_s9_q ? select_1824 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s9_q ? select_1818 : patches_row_q;
      patches_work_q <= or_3048 ? following : patches_work_q;
      patches_second_q <= not_1677 & (patches_second_q | (patches_ends_q & equal_1788));
      patches_following_q <= equal_1788 ? {2'h0, and_3054} : {equal_1790, select_3057};
      patches_following_beats_q <= {select_3069, not_3060};
      patches_begins_q <= sample_pair_whole_s9_q & (and_1676_s9_q & and_1820);
      patches_ends_q <= not_3072 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3077;
      patches_step_q <= or_3048 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic patches_second_s10_q;
  logic [4:0] patches_step_s10_q;
  logic [3:0] select_508_s10_q;
  logic equal_509_s10_q;
  logic [6:0] select_511_s10_q;
  logic [8:0] select_515_s10_q;
  logic and_524_s10_q;
  logic equal_530_s10_q;
  logic [6:0] last_s10_2_q;
  logic and_548_s10_q;
  logic and_550_s10_q;
  logic equal_569_s10_q;
  logic equal_575_s10_q;
  logic so_s10_q;
  logic equal_579_s10_q;
  logic or_580_s10_q;
  logic less_583_s10_q;
  logic not_584_s10_q;
  logic equal_594_s10_q;
  logic [62:0] left_rdata_s10_q;
  logic and_601_s10_q;
  logic and_609_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_618_s10_q;
  logic [61:0] best_left_rdata_s10_q;
  logic [5:0] shift_s10_q;
  logic [6:0] right_s10_q;
  logic and_640_s10_q;
  logic [77:0] right_codes_rdata_s10_q;
  logic and_645_s10_q;
  logic and_647_s10_q;
  logic and_651_s10_q;
  logic [32:0] fresh_rdata_s10_q;
  logic equal_680_s10_q;
  logic and_749_s10_q;
  logic and_750_s10_q;
  logic and_751_s10_q;
  logic and_752_s10_q;
  logic and_753_s10_q;
  logic and_754_s10_q;
  logic and_755_s10_q;
  logic and_756_s10_q;
  logic and_757_s10_q;
  logic and_758_s10_q;
  logic and_763_s10_q;
  logic [11:0] select_770_s10_q;
  logic and_786_s10_q;
  logic [11:0] select_793_s10_q;
  logic and_803_s10_q;
  logic [11:0] select_810_s10_q;
  logic [11:0] select_1018_s10_q;
  logic [11:0] select_1041_s10_q;
  logic [11:0] select_1058_s10_q;
  logic [11:0] select_1271_s10_q;
  logic [11:0] select_1292_s10_q;
  logic [11:0] select_1307_s10_q;
  logic and_1562_s10_q;
  logic equal_1563_s10_q;
  logic and_1676_s10_q;
  logic and_1689_s10_q;
  logic right_3_s10_q;
  logic less_1703_s10_q;
  logic [5:0] b_s10_q;
  logic [13:0] select_1758_s10_q;
  logic equal_1788_s10_q;
  logic equal_1790_s10_q;
  logic equal_1792_s10_q;
  logic equal_1793_s10_q;
  logic or_1794_s10_q;
  logic and_1797_s10_q;
  logic [4:0] select_1818_s10_q;
  logic select_1824_s10_q;
  logic and_1830_s10_q;
  logic and_1850_s10_q;
  logic [3:0] select_1863_s10_q;
  logic less_1967_s10_q;
  logic equal_1968_s10_q;
  logic not_1969_s10_q;
  logic equal_1970_s10_q;
  logic not_1971_s10_q;
  logic select_1974_s10_q;
  logic and_1975_s10_q;
  logic sum_1999_s10_q;
  logic and_2020_s10_q;
  logic and_2137_s10_q;
  logic equal_2284_s10_q;
  logic equal_2473_s10_q;
  logic and_2599_s10_q;
  logic [7:0] select_2731_s10_q;
  logic [7:0] select_2733_s10_q;
  logic [5:0] further_s10_q;
  logic not_3007_s10_q;
  logic or_3048_s10_q;
  logic not_3072_s10_q;
  logic and_3544_s10_q;
  logic equal_3551_s10_q;
  logic less_3877_s10_q;
  logic equal_4096_s10_q;
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
      lower_half_s10_q <= lower_half_q;
      shift_first_s10_q <= shift_first_s9_q;
      registration_slope_s10_q <= registration_slope_s9_q;
      patches_band_rows_number_s10_q <= patches_band_rows_number_s9_q;
      patches_chooses_s10_q <= patches_chooses_s9_q;
      patches_choosing_band_s10_q <= patches_choosing_band_s9_q;
      patches_second_s10_q <= patches_second_q;
      patches_step_s10_q <= patches_step_q[4:0];
      select_508_s10_q <= select_508_s9_q;
      equal_509_s10_q <= equal_509_s9_q;
      select_511_s10_q <= select_511_s9_q;
      select_515_s10_q <= select_515_s9_q;
      and_524_s10_q <= and_524_s9_q;
      equal_530_s10_q <= equal_530_s9_q;
      last_s10_2_q <= last_s9_2_q;
      and_548_s10_q <= and_548_s9_q;
      and_550_s10_q <= and_550_s9_q;
      equal_569_s10_q <= equal_569;
      equal_575_s10_q <= equal_575_s9_q;
      so_s10_q <= so_s9_q;
      equal_579_s10_q <= equal_579_s9_q;
      or_580_s10_q <= or_580_s9_q;
      less_583_s10_q <= less_583_s9_q;
      not_584_s10_q <= not_584_s9_q;
      equal_594_s10_q <= equal_594_s9_q;
      left_rdata_s10_q <= {left_rdata_s9_q[65:49], left_rdata_s9_q[47:31], left_rdata_s9_q[29:13], left_rdata_s9_q[11:0]};
      and_601_s10_q <= or_580_s9_q & (left_rdata_s9_q[70] & not_584_s9_q);
      and_609_s10_q <= (or_580_s9_q & (left_rdata_s9_q[68] & not_584_s9_q)) & and_608;
      x_s10_2_q <= x_s9_2_q;
      select_618_s10_q <= select_618_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      shift_s10_q <= shift;
      right_s10_q <= right_s9_q;
      and_640_s10_q <= or_580_s9_q & (left_rdata_s9_q[71] & not_584_s9_q);
      right_codes_rdata_s10_q <= {right_codes_rdata_s9_q[84:73], right_codes_rdata_s9_q[71:60], right_codes_rdata_s9_q[56:43], right_codes_rdata_s9_q[41:28], right_codes_rdata_s9_q[26:13], right_codes_rdata_s9_q[11:0]};
      and_645_s10_q <= or_580_s9_q & (right_codes_rdata_s9_q[58] & not_584_s9_q);
      and_647_s10_q <= or_580_s9_q & (right_codes_rdata_s9_q[59] & not_584_s9_q);
      and_651_s10_q <= and_651_s9_q;
      fresh_rdata_s10_q <= fresh_rdata_q;
      equal_680_s10_q <= row_s9_q == 7'h0;
      and_749_s10_q <= left_rdata_s9_q[12] & not_748;
      and_750_s10_q <= left_rdata_s9_q[30] & not_748;
      and_751_s10_q <= left_rdata_s9_q[48] & not_748;
      and_752_s10_q <= left_rdata_s9_q[66] & not_748;
      and_753_s10_q <= right_codes_rdata_s9_q[12] & not_748;
      and_754_s10_q <= right_codes_rdata_s9_q[27] & not_748;
      and_755_s10_q <= right_codes_rdata_s9_q[42] & not_748;
      and_756_s10_q <= right_codes_rdata_s9_q[57] & not_748;
      and_757_s10_q <= right_codes_rdata_s9_q[72] & not_748;
      and_758_s10_q <= right_codes_rdata_s9_q[85] & not_748;
      and_763_s10_q <= and_763;
      select_770_s10_q <= select_770;
      and_786_s10_q <= and_786;
      select_793_s10_q <= select_793;
      and_803_s10_q <= and_803;
      select_810_s10_q <= select_810;
      select_1018_s10_q <= select_1018;
      select_1041_s10_q <= select_1041;
      select_1058_s10_q <= select_1053 ? (~(select_805 ^ select_1055)) : 12'h0;
      select_1271_s10_q <= select_1265 ? (~(select_765 ^ select_1268)) : 12'h0;
      select_1292_s10_q <= select_1292;
      select_1307_s10_q <= select_1307;
      and_1562_s10_q <= and_1562_s9_q;
      equal_1563_s10_q <= equal_1563_s9_q;
      and_1676_s10_q <= and_1676_s9_q;
      and_1689_s10_q <= and_1689;
      right_3_s10_q <= right_3;
      less_1703_s10_q <= 6'h4 < row_q[6:1];
      b_s10_q <= b;
      select_1758_s10_q <= select_1758;
      equal_1788_s10_q <= equal_1788;
      equal_1790_s10_q <= equal_1790;
      equal_1792_s10_q <= equal_1792;
      equal_1793_s10_q <= equal_1793;
      or_1794_s10_q <= or_1794;
      and_1797_s10_q <= or_1794 & (equal_1793 & not_1795);
      select_1818_s10_q <= select_1818;
      select_1824_s10_q <= select_1824;
      and_1830_s10_q <= or_1794 & (patches_second_q & equal_1793);
      and_1850_s10_q <= not_1849 & or_1794;
      select_1863_s10_q <= select_1863;
      less_1967_s10_q <= less_1967;
      equal_1968_s10_q <= equal_1968;
      not_1969_s10_q <= not_1969;
      equal_1970_s10_q <= equal_1970;
      not_1971_s10_q <= not_1971;
      select_1974_s10_q <= select_1974;
      and_1975_s10_q <= not_1969 & select_1974;
      sum_1999_s10_q <= sum_1999_s9_q;
      and_2020_s10_q <= or_580_s9_q & (left_rdata_s9_q[69] & not_584_s9_q);
      and_2137_s10_q <= (7'h6 < row_q) & (~(x_s9_q[7:2] == 6'h0));
      equal_2284_s10_q <= (last_s9_2_q | row_s9_q) == 7'h0;
      equal_2473_s10_q <= equal_2473_s9_q;
      and_2599_s10_q <= not_584_s9_q & and_608;
      select_2731_s10_q <= select_2731;
      select_2733_s10_q <= select_2733;
      further_s10_q <= further;
      not_3007_s10_q <= not_3007_s9_q;
      or_3048_s10_q <= or_3048;
      not_3072_s10_q <= not_3072;
      and_3544_s10_q <= less_1967 & (patches_step_q[6:5] == 2'h1);
      equal_3551_s10_q <= patches_step_q[6:5] == 2'h2;
      less_3877_s10_q <= 6'h2 < row_s9_q[6:1];
      equal_4096_s10_q <= row_s9_q[6:3] == 4'h0;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s10_q + {{2{shift_s10_q[5]}}, shift_s10_q};
  // hls/stages/count_bits.hpp:24
  logic parity_776;
  assign parity_776 = ^select_770_s10_q[5:3];
  logic parity_779;
  assign parity_779 = ^select_770_s10_q[8:6];
  logic parity_782;
  assign parity_782 = ^select_770_s10_q[11:3];
  logic parity_796;
  assign parity_796 = ^select_793_s10_q[8:6];
  logic parity_799;
  assign parity_799 = ^select_793_s10_q[11:9];
  logic parity_816;
  assign parity_816 = ^select_810_s10_q[2:0];
  logic parity_819;
  assign parity_819 = ^select_810_s10_q[5:3];
  logic parity_822;
  assign parity_822 = ^select_810_s10_q[8:0];
  logic parity_828;
  assign parity_828 = ^select_810_s10_q[11:9];
  logic parity_831;
  assign parity_831 = ^select_793_s10_q[2:0];
  logic parity_834;
  assign parity_834 = ^{select_810_s10_q[11:9], select_793_s10_q[5:0]};
  logic parity_837;
  assign parity_837 = ^{select_810_s10_q, select_793_s10_q, select_770_s10_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic and_841;
  assign and_841 = select_770_s10_q[2] & (select_770_s10_q[0] | select_770_s10_q[1]);
  logic or_842;
  assign or_842 = (select_770_s10_q[1:0] == 2'h3) | and_841;
  // hls/stages/count_bits.hpp:25
  logic and_845;
  assign and_845 = select_793_s10_q[8] & (select_793_s10_q[6] | select_793_s10_q[7]);
  logic or_846;
  assign or_846 = (select_793_s10_q[7:6] == 2'h3) | and_845;
  logic and_849;
  assign and_849 = select_793_s10_q[11] & (select_793_s10_q[9] | select_793_s10_q[10]);
  logic or_850;
  assign or_850 = (select_793_s10_q[10:9] == 2'h3) | and_849;
  // hls/stages/count_bits.hpp:23
  logic or_858;
  assign or_858 = (select_810_s10_q[7:6] == 2'h3) | (select_810_s10_q[8] & (~(select_810_s10_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic and_861;
  assign and_861 = select_810_s10_q[2] & (select_810_s10_q[0] | select_810_s10_q[1]);
  logic or_862;
  assign or_862 = (select_810_s10_q[1:0] == 2'h3) | and_861;
  logic and_865;
  assign and_865 = select_810_s10_q[5] & (select_810_s10_q[3] | select_810_s10_q[4]);
  logic or_866;
  assign or_866 = (select_810_s10_q[4:3] == 2'h3) | and_865;
  // hls/stages/count_bits.hpp:24
  logic parity_869;
  assign parity_869 = ^{or_866, or_862, or_858};
  // hls/stages/count_bits.hpp:23
  logic and_872;
  assign and_872 = select_793_s10_q[5] & (select_793_s10_q[3] | select_793_s10_q[4]);
  logic or_873;
  assign or_873 = (select_793_s10_q[4:3] == 2'h3) | and_872;
  // hls/stages/count_bits.hpp:25
  logic and_876;
  assign and_876 = select_810_s10_q[11] & (select_810_s10_q[9] | select_810_s10_q[10]);
  logic or_877;
  assign or_877 = (select_810_s10_q[10:9] == 2'h3) | and_876;
  logic and_880;
  assign and_880 = select_793_s10_q[2] & (select_793_s10_q[0] | select_793_s10_q[1]);
  logic or_881;
  assign or_881 = (select_793_s10_q[1:0] == 2'h3) | and_880;
  // hls/stages/count_bits.hpp:24
  logic parity_884;
  assign parity_884 = ^{or_881, or_877, or_873};
  logic parity_887;
  assign parity_887 = ^{or_881, or_877, or_873, or_866, or_862, or_858, or_850, or_846, or_842};
  // hls/stages/count_bits.hpp:25
  logic or_892;
  assign or_892 = (parity_776 & parity_779) | ((^select_770_s10_q[11:9]) & (parity_776 | parity_779));
  logic and_895;
  assign and_895 = (^{select_793_s10_q[11:6], select_770_s10_q[2:0]}) & (parity_822 | parity_834);
  // hls/stages/count_bits.hpp:23
  logic and_902;
  assign and_902 = select_770_s10_q[11] & (select_770_s10_q[9] | select_770_s10_q[10]);
  // hls/stages/count_bits.hpp:25
  logic and_906;
  assign and_906 = select_770_s10_q[5] & (select_770_s10_q[3] | select_770_s10_q[4]);
  logic and_910;
  assign and_910 = select_770_s10_q[8] & (select_770_s10_q[6] | select_770_s10_q[7]);
  logic or_918;
  assign or_918 = (parity_796 & parity_799) | ((^select_770_s10_q[2:0]) & (parity_796 | parity_799));
  logic or_922;
  assign or_922 = (parity_816 & parity_819) | ((^select_810_s10_q[8:6]) & (parity_816 | parity_819));
  logic or_926;
  assign or_926 = (parity_828 & parity_831) | ((^select_793_s10_q[5:3]) & (parity_828 | parity_831));
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1019;
  assign select_1019 = and_763_s10_q ? select_1018_s10_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1025;
  assign parity_1025 = ^select_1019[5:3];
  logic parity_1028;
  assign parity_1028 = ^select_1019[8:6];
  logic parity_1031;
  assign parity_1031 = ^select_1019[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1042;
  assign select_1042 = and_786_s10_q ? select_1041_s10_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1045;
  assign parity_1045 = ^select_1042[8:6];
  logic parity_1048;
  assign parity_1048 = ^select_1042[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1059;
  assign select_1059 = and_803_s10_q ? select_1058_s10_q : 12'h0;
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
  assign select_1272 = and_763_s10_q ? select_1271_s10_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1278;
  assign parity_1278 = ^select_1272[5:3];
  logic parity_1281;
  assign parity_1281 = ^select_1272[8:6];
  logic parity_1284;
  assign parity_1284 = ^select_1272[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1293;
  assign select_1293 = and_786_s10_q ? select_1292_s10_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1296;
  assign parity_1296 = ^select_1293[8:6];
  logic parity_1299;
  assign parity_1299 = ^select_1293[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1308;
  assign select_1308 = and_803_s10_q ? select_1307_s10_q : 12'h0;
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
  assign or_1583 = (cfg_nearer_below_i & shift_s10_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s10_q)));
  // hls/stages/agreement.hpp:1009
  logic [5:0] sum_1648;
  assign sum_1648 = {1'b0, last_s10_q[6:2]} + 6'h1;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1732;
  assign sum_1732 = {2'h0, x_s10_q} + {{4{b_s10_q[5]}}, b_s10_q};
  // hls/stages/registration.hpp:213
  logic [9:0] select_1759;
  assign select_1759 = b_s10_q[4] ? select_1758_s10_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1764;
  assign sum_1764 = (b_s10_q[0] ? select_1758_s10_q[13:1] : 13'h0) + (b_s10_q[1] ? select_1758_s10_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1765;
  assign select_1765 = b_s10_q[2] ? select_1758_s10_q[11:0] : 12'h0;
  logic [10:0] sum_1767;
  assign sum_1767 = select_1765[11:1] + (b_s10_q[3] ? select_1758_s10_q[10:0] : 11'h0);
  // hls/stages/patches.hpp:512
  logic not_1789;
  assign not_1789 = ~equal_1788_s10_q;
  // hls/stages/patches.hpp:458
  logic not_1791;
  assign not_1791 = ~equal_1790_s10_q;
  logic and_1873;
  assign and_1873 = not_1789 & (or_1794_s10_q & not_1791);
  // hls/stages/patches.hpp:184
  logic and_1977;
  assign and_1977 = equal_1788_s10_q & (less_1967_s10_q ? and_1975_s10_q : select_1974_s10_q);
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2729;
  assign select_2729 = or_580_s10_q ? (less_583_s10_q ? 8'h0 : best_left_rdata_s10_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2731_s10_q} - {1'b0, select_2733_s10_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2990;
  assign select_2990 = right_3_s10_q ? last_s10_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s10_q} + {1'b0, select_2990};
  // hls/stages/patches.hpp:126
  logic select_3009;
  assign select_3009 = and_1676_s10_q ? (and_1689_s10_q ? not_3007_s10_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:187
  logic [4:0] select_3079;
  assign select_3079 = or_3048_s10_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:557
  logic select_3546;
  assign select_3546 = less_1967_s10_q ? (not_1971_s10_q & and_3544_s10_q) : and_3544_s10_q;
  // hls/stages/patches.hpp:560
  logic select_3547;
  assign select_3547 = equal_1970_s10_q ? select_3546 : and_3544_s10_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:779; read in stage 10, written in stage 23: 10 < 23 < 10 + DISTANCE.
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
  assign patches_right_0_re = s10_en & (not_1789 & (not_1791 & and_1797_s10_q));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:779; read in stage 10, written in stage 23: 10 < 23 < 10 + DISTANCE.
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
  assign patches_right_1_re = s10_en & (not_1789 & (not_1791 & and_1830_s10_q));
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:791; read in stage 10, written in stage 14: 10 < 14 < 10 + DISTANCE.
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
  assign patches_columns_above_re = s10_en & and_1873;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:811; read in stage 10, written in stage 25: 10 < 25 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_s10_q;
`ifndef SYNTHESIS
  logic patches_rows_re;
  assign patches_rows_re = s10_en & and_1977;
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s10_q[6:0];
  logic left_we;
  assign left_we = s10_en & and_651_s10_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_752_s10_q, left_rdata_s10_q[62:46], and_751_s10_q, left_rdata_s10_q[45:29], and_750_s10_q, left_rdata_s10_q[28:12], and_749_s10_q, left_rdata_s10_q[11:0], fresh_rdata_s10_q[30:26], fresh_rdata_s10_q[24], fresh_rdata_s10_q[11:0]};
  end
`ifndef SYNTHESIS
  logic [6:0] left_raddr_s8_sim;
  logic left_re_s8_sim;
  logic [6:0] left_raddr_s9_sim;
  logic left_re_s9_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_re_s8_sim <= 1'b0;
      left_re_s9_sim <= 1'b0;
    end else if (en_i) begin
      left_re_s8_sim <= left_re;
      left_raddr_s8_sim <= left_raddr;
      left_re_s9_sim <= left_re_s8_sim;
      left_raddr_s9_sim <= left_raddr_s8_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_we) begin
      if (left_re && left_raddr == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s8_sim && left_raddr_s8_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_re_s9_sim && left_raddr_s9_sim == left_waddr) begin
        $error("left: address %0d is read less than DISTANCE steps after its write", left_waddr);
      end
      if (left_waddr >= 7'd120) $error("left: write outside, address %0d", left_waddr);
    end
    if (rst_ni && left_re && left_raddr >= 7'd120) $error("left: read outside, address %0d", left_raddr);
  end
`endif

  // Memory right_codes, write
  logic [6:0] right_codes_waddr;
  assign right_codes_waddr = x_s10_q[6:0];
  logic right_codes_we;
  assign right_codes_we = s10_en & and_651_s10_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_758_s10_q, right_codes_rdata_s10_q[77:66], and_757_s10_q, right_codes_rdata_s10_q[65:54], and_756_s10_q, right_codes_rdata_s10_q[53:40], and_755_s10_q, right_codes_rdata_s10_q[39:26], and_754_s10_q, right_codes_rdata_s10_q[25:12], and_753_s10_q, right_codes_rdata_s10_q[11:0], fresh_rdata_s10_q[32:31], fresh_rdata_s10_q[25], fresh_rdata_s10_q[23:12]};
  end
`ifndef SYNTHESIS
  logic [6:0] right_codes_raddr_s8_sim;
  logic right_codes_re_s8_sim;
  logic [6:0] right_codes_raddr_s9_sim;
  logic right_codes_re_s9_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_codes_re_s8_sim <= 1'b0;
      right_codes_re_s9_sim <= 1'b0;
    end else if (en_i) begin
      right_codes_re_s8_sim <= right_codes_re;
      right_codes_raddr_s8_sim <= right_codes_raddr;
      right_codes_re_s9_sim <= right_codes_re_s8_sim;
      right_codes_raddr_s9_sim <= right_codes_raddr_s8_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_codes_we) begin
      if (right_codes_re && right_codes_raddr == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s8_sim && right_codes_raddr_s8_sim == right_codes_waddr) begin
        $error("right_codes: address %0d is read less than DISTANCE steps after its write", right_codes_waddr);
      end
      if (right_codes_re_s9_sim && right_codes_raddr_s9_sim == right_codes_waddr) begin
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
    end else if (s10_en) begin
      patches_lower_q <= sample_pair_whole_s10_q ? select_3009 : patches_lower_q;
      patches_code_row_q <= select_3079;
      patches_column_q <= or_3048_s10_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3072_s10_q & (patches_column_q == 5'h1e);
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
  logic [3:0] select_508_s11_q;
  logic equal_509_s11_q;
  logic [6:0] select_511_s11_q;
  logic [8:0] select_515_s11_q;
  logic and_524_s11_q;
  logic equal_530_s11_q;
  logic [6:0] last_s11_q;
  logic and_548_s11_q;
  logic and_550_s11_q;
  logic equal_569_s11_q;
  logic equal_575_s11_q;
  logic so_s11_q;
  logic equal_579_s11_q;
  logic or_580_s11_q;
  logic less_583_s11_q;
  logic not_584_s11_q;
  logic equal_594_s11_q;
  logic and_601_s11_q;
  logic and_609_s11_q;
  logic [6:0] x_s11_2_q;
  logic select_618_s11_q;
  logic [61:0] best_left_rdata_s11_q;
  logic [6:0] select_627_s11_q;
  logic [6:0] right_s11_q;
  logic and_640_s11_q;
  logic and_645_s11_q;
  logic and_647_s11_q;
  logic equal_680_s11_q;
  logic xor_838_s11_q;
  logic parity_887_s11_q;
  logic and_888_s11_q;
  logic or_892_s11_q;
  logic or_896_s11_q;
  logic or_903_s11_q;
  logic or_907_s11_q;
  logic or_911_s11_q;
  logic or_918_s11_q;
  logic or_922_s11_q;
  logic or_926_s11_q;
  logic and_935_s11_q;
  logic and_937_s11_q;
  logic or_949_s11_q;
  logic or_953_s11_q;
  logic or_957_s11_q;
  logic xor_1087_s11_q;
  logic parity_1102_s11_q;
  logic parity_1136_s11_q;
  logic and_1137_s11_q;
  logic or_1141_s11_q;
  logic or_1145_s11_q;
  logic or_1152_s11_q;
  logic or_1156_s11_q;
  logic or_1160_s11_q;
  logic or_1167_s11_q;
  logic or_1171_s11_q;
  logic or_1175_s11_q;
  logic and_1184_s11_q;
  logic or_1185_s11_q;
  logic or_1198_s11_q;
  logic or_1202_s11_q;
  logic or_1206_s11_q;
  logic xor_1336_s11_q;
  logic parity_1351_s11_q;
  logic parity_1385_s11_q;
  logic and_1386_s11_q;
  logic or_1390_s11_q;
  logic or_1394_s11_q;
  logic or_1401_s11_q;
  logic or_1405_s11_q;
  logic or_1409_s11_q;
  logic or_1416_s11_q;
  logic or_1420_s11_q;
  logic or_1424_s11_q;
  logic and_1433_s11_q;
  logic or_1434_s11_q;
  logic or_1447_s11_q;
  logic or_1451_s11_q;
  logic or_1455_s11_q;
  logic and_1562_s11_q;
  logic equal_1563_s11_q;
  logic or_1583_s11_q;
  logic less_1649_s11_q;
  logic and_1676_s11_q;
  logic and_1689_s11_q;
  logic right_3_s11_q;
  logic less_1703_s11_q;
  logic [5:0] b_s11_q;
  logic less_1724_s11_q;
  logic not_1728_s11_q;
  logic less_1733_s11_q;
  logic less_1734_s11_q;
  logic select_1759_s11_q;
  logic [8:0] difference_1761_s11_q;
  logic [11:0] sum_1764_s11_q;
  logic select_1765_s11_q;
  logic [10:0] sum_1767_s11_q;
  logic equal_1781_s11_q;
  logic equal_1788_s11_q;
  logic not_1789_s11_q;
  logic equal_1790_s11_q;
  logic not_1791_s11_q;
  logic equal_1792_s11_q;
  logic equal_1793_s11_q;
  logic or_1794_s11_q;
  logic [4:0] select_1818_s11_q;
  logic select_1824_s11_q;
  logic and_1852_s11_q;
  logic [3:0] select_1863_s11_q;
  logic and_1873_s11_q;
  logic less_1967_s11_q;
  logic equal_1968_s11_q;
  logic not_1969_s11_q;
  logic equal_1970_s11_q;
  logic not_1971_s11_q;
  logic sum_1999_s11_q;
  logic and_2020_s11_q;
  logic and_2140_s11_q;
  logic equal_2284_s11_q;
  logic equal_2473_s11_q;
  logic and_2600_s11_q;
  logic equal_2685_s11_q;
  logic [7:0] select_2729_s11_q;
  logic rise_2_s11_q;
  logic [7:0] select_2735_s11_q;
  logic [7:0] xor_2740_s11_q;
  logic less_2766_s11_q;
  logic not_2993_s11_q;
  logic or_3048_s11_q;
  logic not_3072_s11_q;
  logic select_3549_s11_q;
  logic equal_3551_s11_q;
  logic less_3877_s11_q;
  logic equal_4096_s11_q;
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
      patches_lower_s11_q <= patches_lower_q;
      patches_second_s11_q <= patches_second_s10_q;
      patches_code_row_s11_q <= patches_code_row_q;
      patches_column_s11_q <= patches_column_q;
      patches_step_s11_q <= patches_step_s10_q;
      select_508_s11_q <= select_508_s10_q;
      equal_509_s11_q <= equal_509_s10_q;
      select_511_s11_q <= select_511_s10_q;
      select_515_s11_q <= select_515_s10_q;
      and_524_s11_q <= and_524_s10_q;
      equal_530_s11_q <= equal_530_s10_q;
      last_s11_q <= last_s10_2_q;
      and_548_s11_q <= and_548_s10_q;
      and_550_s11_q <= and_550_s10_q;
      equal_569_s11_q <= equal_569_s10_q;
      equal_575_s11_q <= equal_575_s10_q;
      so_s11_q <= so_s10_q;
      equal_579_s11_q <= equal_579_s10_q;
      or_580_s11_q <= or_580_s10_q;
      less_583_s11_q <= less_583_s10_q;
      not_584_s11_q <= not_584_s10_q;
      equal_594_s11_q <= equal_594_s10_q;
      and_601_s11_q <= and_601_s10_q;
      and_609_s11_q <= and_609_s10_q;
      x_s11_2_q <= x_s10_2_q;
      select_618_s11_q <= select_618_s10_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_627_s11_q <= ({1'b0, last_s10_q} < found) ? 7'h0 : found[6:0];
      right_s11_q <= right_s10_q;
      and_640_s11_q <= and_640_s10_q;
      and_645_s11_q <= and_645_s10_q;
      and_647_s11_q <= and_647_s10_q;
      equal_680_s11_q <= equal_680_s10_q;
      xor_838_s11_q <= parity_782 ^ parity_837;
      parity_887_s11_q <= parity_887;
      and_888_s11_q <= parity_782 & parity_837;
      or_892_s11_q <= or_892;
      or_896_s11_q <= (parity_822 & parity_834) | and_895;
      or_903_s11_q <= (select_770_s10_q[10:9] == 2'h3) | and_902;
      or_907_s11_q <= (select_770_s10_q[4:3] == 2'h3) | and_906;
      or_911_s11_q <= (select_770_s10_q[7:6] == 2'h3) | and_910;
      or_918_s11_q <= or_918;
      or_922_s11_q <= or_922;
      or_926_s11_q <= or_926;
      and_935_s11_q <= parity_869 & parity_884;
      and_937_s11_q <= (^{or_850, or_846, or_842}) & (parity_869 | parity_884);
      or_949_s11_q <= (or_846 & or_850) | (or_842 & (or_846 | or_850));
      or_953_s11_q <= (or_862 & or_866) | (or_858 & (or_862 | or_866));
      or_957_s11_q <= (or_877 & or_881) | (or_873 & (or_877 | or_881));
      xor_1087_s11_q <= parity_1031 ^ parity_1086;
      parity_1102_s11_q <= ^{or_1099, or_1095, or_1091};
      parity_1136_s11_q <= parity_1136;
      and_1137_s11_q <= parity_1031 & parity_1086;
      or_1141_s11_q <= or_1141;
      or_1145_s11_q <= (parity_1071 & parity_1083) | and_1144;
      or_1152_s11_q <= or_1152;
      or_1156_s11_q <= or_1156;
      or_1160_s11_q <= or_1160;
      or_1167_s11_q <= or_1167;
      or_1171_s11_q <= or_1171;
      or_1175_s11_q <= or_1175;
      and_1184_s11_q <= parity_1118 & parity_1133;
      or_1185_s11_q <= parity_1118 | parity_1133;
      or_1198_s11_q <= (or_1095 & or_1099) | (or_1091 & (or_1095 | or_1099));
      or_1202_s11_q <= (or_1111 & or_1115) | (or_1107 & (or_1111 | or_1115));
      or_1206_s11_q <= (or_1126 & or_1130) | (or_1122 & (or_1126 | or_1130));
      xor_1336_s11_q <= parity_1284 ^ parity_1335;
      parity_1351_s11_q <= ^{or_1348, or_1344, or_1340};
      parity_1385_s11_q <= parity_1385;
      and_1386_s11_q <= parity_1284 & parity_1335;
      or_1390_s11_q <= or_1390;
      or_1394_s11_q <= (parity_1320 & parity_1332) | and_1393;
      or_1401_s11_q <= or_1401;
      or_1405_s11_q <= or_1405;
      or_1409_s11_q <= or_1409;
      or_1416_s11_q <= or_1416;
      or_1420_s11_q <= or_1420;
      or_1424_s11_q <= or_1424;
      and_1433_s11_q <= parity_1367 & parity_1382;
      or_1434_s11_q <= parity_1367 | parity_1382;
      or_1447_s11_q <= (or_1344 & or_1348) | (or_1340 & (or_1344 | or_1348));
      or_1451_s11_q <= (or_1360 & or_1364) | (or_1356 & (or_1360 | or_1364));
      or_1455_s11_q <= (or_1375 & or_1379) | (or_1371 & (or_1375 | or_1379));
      and_1562_s11_q <= and_1562_s10_q;
      equal_1563_s11_q <= equal_1563_s10_q;
      or_1583_s11_q <= or_1583;
      less_1649_s11_q <= {1'b0, sum_1648, last_s10_q[1]} < x_s10_q;
      and_1676_s11_q <= and_1676_s10_q;
      and_1689_s11_q <= and_1689_s10_q;
      right_3_s11_q <= right_3_s10_q;
      less_1703_s11_q <= less_1703_s10_q;
      b_s11_q <= b_s10_q;
      less_1724_s11_q <= {3'h0, last_s10_q[6:1]} < ({1'b0, x_s10_q} + 9'h1);
      not_1728_s11_q <= ~(x_s10_q < {1'b0, last_s10_q});
      less_1733_s11_q <= $signed(10'h0) < $signed(sum_1732);
      less_1734_s11_q <= $signed(sum_1732) < $signed({3'h0, last_s10_q});
      select_1759_s11_q <= select_1759[0];
      difference_1761_s11_q <= select_1759[9:1] - (b_s10_q[5] ? select_1758_s10_q[8:0] : 9'h0);
      sum_1764_s11_q <= sum_1764[12:1];
      select_1765_s11_q <= select_1765[0];
      sum_1767_s11_q <= sum_1767;
      equal_1781_s11_q <= x_s10_q == {1'b0, last_s10_q};
      equal_1788_s11_q <= equal_1788_s10_q;
      not_1789_s11_q <= not_1789;
      equal_1790_s11_q <= equal_1790_s10_q;
      not_1791_s11_q <= not_1791;
      equal_1792_s11_q <= equal_1792_s10_q;
      equal_1793_s11_q <= equal_1793_s10_q;
      or_1794_s11_q <= or_1794_s10_q;
      select_1818_s11_q <= select_1818_s10_q;
      select_1824_s11_q <= select_1824_s10_q;
      and_1852_s11_q <= not_1789 & (not_1791 & and_1850_s10_q);
      select_1863_s11_q <= select_1863_s10_q;
      and_1873_s11_q <= and_1873;
      less_1967_s11_q <= less_1967_s10_q;
      equal_1968_s11_q <= equal_1968_s10_q;
      not_1969_s11_q <= not_1969_s10_q;
      equal_1970_s11_q <= equal_1970_s10_q;
      not_1971_s11_q <= not_1971_s10_q;
      sum_1999_s11_q <= sum_1999_s10_q;
      and_2020_s11_q <= and_2020_s10_q;
      and_2140_s11_q <= and_2137_s10_q & (~({sum_1648, last_s10_q[1:0]} < x_s10_q));
      equal_2284_s11_q <= equal_2284_s10_q;
      equal_2473_s11_q <= equal_2473_s10_q;
      and_2600_s11_q <= or_580_s10_q & and_2599_s10_q;
      equal_2685_s11_q <= shift_s10_q == 6'h0;
      select_2729_s11_q <= select_2729;
      rise_2_s11_q <= rise_2[8];
      select_2735_s11_q <= rise_2[8] ? select_2731_s10_q : select_2733_s10_q;
      xor_2740_s11_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2766_s11_q <= select_2731_s10_q < select_2733_s10_q;
      not_2993_s11_q <= ~(x_s10_q < {1'b0, from});
      or_3048_s11_q <= or_3048_s10_q;
      not_3072_s11_q <= not_3072_s10_q;
      select_3549_s11_q <= less_1967_s10_q ? (not_1969_s10_q & select_3547) : select_3547;
      equal_3551_s11_q <= equal_3551_s10_q;
      less_3877_s11_q <= less_3877_s10_q;
      equal_4096_s11_q <= equal_4096_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/patches.hpp:106
  logic equal_570;
  assign equal_570 = x_s11_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_569_s11_q & equal_570;
  // hls/stages/count_bits.hpp:24
  logic parity_914;
  assign parity_914 = ^{or_911_s11_q, or_907_s11_q, or_903_s11_q};
  logic parity_929;
  assign parity_929 = ^{or_926_s11_q, or_922_s11_q, or_918_s11_q};
  logic parity_932;
  assign parity_932 = ^{or_926_s11_q, or_922_s11_q, or_918_s11_q, or_911_s11_q, or_907_s11_q, or_903_s11_q, or_896_s11_q, or_892_s11_q, and_888_s11_q};
  // hls/stages/count_bits.hpp:25
  logic and_934;
  assign and_934 = parity_887_s11_q & parity_932;
  logic or_938;
  assign or_938 = and_935_s11_q | and_937_s11_q;
  logic and_941;
  assign and_941 = (^{or_896_s11_q, or_892_s11_q, and_888_s11_q}) & (parity_914 | parity_929);
  logic or_942;
  assign or_942 = (parity_914 & parity_929) | and_941;
  // hls/stages/count_bits.hpp:24
  logic parity_960;
  assign parity_960 = ^{or_957_s11_q, or_953_s11_q, or_949_s11_q};
  // hls/stages/count_bits.hpp:25
  logic or_964;
  assign or_964 = (or_892_s11_q & or_896_s11_q) | (and_888_s11_q & (or_892_s11_q | or_896_s11_q));
  logic or_968;
  assign or_968 = (or_907_s11_q & or_911_s11_q) | (or_903_s11_q & (or_907_s11_q | or_911_s11_q));
  logic or_972;
  assign or_972 = (or_922_s11_q & or_926_s11_q) | (or_918_s11_q & (or_922_s11_q | or_926_s11_q));
  // hls/stages/count_bits.hpp:24
  logic parity_975;
  assign parity_975 = ^{or_972, or_968, or_964};
  logic parity_978;
  assign parity_978 = ^{or_972, or_968, or_964, or_957_s11_q, or_953_s11_q, or_949_s11_q, or_942, or_938, and_934};
  // hls/stages/count_bits.hpp:25
  logic or_990;
  assign or_990 = (or_953_s11_q & or_957_s11_q) | (or_949_s11_q & (or_953_s11_q | or_957_s11_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1163;
  assign parity_1163 = ^{or_1160_s11_q, or_1156_s11_q, or_1152_s11_q};
  logic parity_1178;
  assign parity_1178 = ^{or_1175_s11_q, or_1171_s11_q, or_1167_s11_q};
  logic parity_1181;
  assign parity_1181 = ^{or_1175_s11_q, or_1171_s11_q, or_1167_s11_q, or_1160_s11_q, or_1156_s11_q, or_1152_s11_q, or_1145_s11_q, or_1141_s11_q, and_1137_s11_q};
  // hls/stages/count_bits.hpp:25
  logic and_1183;
  assign and_1183 = parity_1136_s11_q & parity_1181;
  logic or_1187;
  assign or_1187 = and_1184_s11_q | (parity_1102_s11_q & or_1185_s11_q);
  logic and_1190;
  assign and_1190 = (^{or_1145_s11_q, or_1141_s11_q, and_1137_s11_q}) & (parity_1163 | parity_1178);
  logic or_1191;
  assign or_1191 = (parity_1163 & parity_1178) | and_1190;
  // hls/stages/count_bits.hpp:24
  logic parity_1209;
  assign parity_1209 = ^{or_1206_s11_q, or_1202_s11_q, or_1198_s11_q};
  // hls/stages/count_bits.hpp:25
  logic or_1213;
  assign or_1213 = (or_1141_s11_q & or_1145_s11_q) | (and_1137_s11_q & (or_1141_s11_q | or_1145_s11_q));
  logic or_1217;
  assign or_1217 = (or_1156_s11_q & or_1160_s11_q) | (or_1152_s11_q & (or_1156_s11_q | or_1160_s11_q));
  logic or_1221;
  assign or_1221 = (or_1171_s11_q & or_1175_s11_q) | (or_1167_s11_q & (or_1171_s11_q | or_1175_s11_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1224;
  assign parity_1224 = ^{or_1221, or_1217, or_1213};
  logic parity_1227;
  assign parity_1227 = ^{or_1221, or_1217, or_1213, or_1206_s11_q, or_1202_s11_q, or_1198_s11_q, or_1191, or_1187, and_1183};
  // hls/stages/count_bits.hpp:25
  logic or_1239;
  assign or_1239 = (or_1202_s11_q & or_1206_s11_q) | (or_1198_s11_q & (or_1202_s11_q | or_1206_s11_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1412;
  assign parity_1412 = ^{or_1409_s11_q, or_1405_s11_q, or_1401_s11_q};
  logic parity_1427;
  assign parity_1427 = ^{or_1424_s11_q, or_1420_s11_q, or_1416_s11_q};
  logic parity_1430;
  assign parity_1430 = ^{or_1424_s11_q, or_1420_s11_q, or_1416_s11_q, or_1409_s11_q, or_1405_s11_q, or_1401_s11_q, or_1394_s11_q, or_1390_s11_q, and_1386_s11_q};
  // hls/stages/count_bits.hpp:25
  logic and_1432;
  assign and_1432 = parity_1385_s11_q & parity_1430;
  logic or_1436;
  assign or_1436 = and_1433_s11_q | (parity_1351_s11_q & or_1434_s11_q);
  logic and_1439;
  assign and_1439 = (^{or_1394_s11_q, or_1390_s11_q, and_1386_s11_q}) & (parity_1412 | parity_1427);
  logic or_1440;
  assign or_1440 = (parity_1412 & parity_1427) | and_1439;
  // hls/stages/count_bits.hpp:24
  logic parity_1458;
  assign parity_1458 = ^{or_1455_s11_q, or_1451_s11_q, or_1447_s11_q};
  // hls/stages/count_bits.hpp:25
  logic or_1462;
  assign or_1462 = (or_1390_s11_q & or_1394_s11_q) | (and_1386_s11_q & (or_1390_s11_q | or_1394_s11_q));
  logic or_1466;
  assign or_1466 = (or_1405_s11_q & or_1409_s11_q) | (or_1401_s11_q & (or_1405_s11_q | or_1409_s11_q));
  logic or_1470;
  assign or_1470 = (or_1420_s11_q & or_1424_s11_q) | (or_1416_s11_q & (or_1420_s11_q | or_1424_s11_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1473;
  assign parity_1473 = ^{or_1470, or_1466, or_1462};
  logic parity_1476;
  assign parity_1476 = ^{or_1470, or_1466, or_1462, or_1455_s11_q, or_1451_s11_q, or_1447_s11_q, or_1440, or_1436, and_1432};
  // hls/stages/count_bits.hpp:25
  logic or_1488;
  assign or_1488 = (or_1451_s11_q & or_1455_s11_q) | (or_1447_s11_q & (or_1451_s11_q | or_1455_s11_q));
  // hls/stages/patches.hpp:104
  logic and_1726;
  assign and_1726 = less_1724_s11_q & (~right_3_s11_q);
  // hls/stages/agreement.hpp:1018
  logic and_1736;
  assign and_1736 = (~(and_1726 | (equal_570 | not_1728_s11_q))) & (less_1733_s11_q & less_1734_s11_q);
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1768;
  assign sum_1768 = sum_1764_s11_q + {sum_1767_s11_q, select_1765_s11_q};
  logic [9:0] sum_1769;
  assign sum_1769 = {difference_1761_s11_q, select_1759_s11_q} + sum_1768[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2729_s11_q} - {1'b0, select_2735_s11_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s11_q} + {1'b0, xor_2740_s11_q};

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1376; read in stage 11, written in stage 18: 11 < 18 < 11 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_580_s11_q ? select_627_s11_q : right_s11_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s11_en & select_618_s11_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:780; read in stage 11, written in stage 22: 11 < 22 < 11 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s11_q, patches_code_row_s11_q[3:0], patches_column_s11_q[3:0]};
`ifndef SYNTHESIS
  logic patches_left_re;
  assign patches_left_re = s11_en & and_1852_s11_q;
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s11_en) begin
      patches_read_searches_q <= equal_1788_s11_q ? select_3549_s11_q : patches_read_searches_q;
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
  logic [11:0] registration_slope_s12_q;
  logic [4:0] patches_band_rows_number_s12_q;
  logic patches_chooses_s12_q;
  logic [4:0] patches_choosing_band_s12_q;
  logic patches_lower_s12_q;
  logic patches_second_s12_q;
  logic [4:0] patches_code_row_s12_q;
  logic [4:0] patches_column_s12_q;
  logic [4:0] patches_step_s12_q;
  logic patches_read_searches_s12_q;
  logic [3:0] select_508_s12_q;
  logic equal_509_s12_q;
  logic [6:0] select_511_s12_q;
  logic [8:0] select_515_s12_q;
  logic and_524_s12_q;
  logic equal_530_s12_q;
  logic [6:0] last_s12_q;
  logic and_548_s12_q;
  logic and_550_s12_q;
  logic equal_570_s12_q;
  logic first_s12_q;
  logic equal_575_s12_q;
  logic so_s12_q;
  logic equal_579_s12_q;
  logic or_580_s12_q;
  logic less_583_s12_q;
  logic not_584_s12_q;
  logic equal_594_s12_q;
  logic and_601_s12_q;
  logic and_609_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic [6:0] select_627_s12_q;
  logic [6:0] right_s12_q;
  logic and_640_s12_q;
  logic and_645_s12_q;
  logic and_647_s12_q;
  logic equal_680_s12_q;
  logic xor_838_s12_q;
  logic xor_933_s12_q;
  logic parity_978_s12_q;
  logic and_979_s12_q;
  logic and_981_s12_q;
  logic and_983_s12_q;
  logic and_985_s12_q;
  logic or_990_s12_q;
  logic or_994_s12_q;
  logic xor_1087_s12_q;
  logic xor_1182_s12_q;
  logic parity_1227_s12_q;
  logic and_1228_s12_q;
  logic and_1230_s12_q;
  logic and_1232_s12_q;
  logic and_1234_s12_q;
  logic or_1239_s12_q;
  logic or_1243_s12_q;
  logic xor_1336_s12_q;
  logic xor_1431_s12_q;
  logic parity_1476_s12_q;
  logic and_1477_s12_q;
  logic and_1479_s12_q;
  logic and_1481_s12_q;
  logic and_1483_s12_q;
  logic or_1488_s12_q;
  logic or_1492_s12_q;
  logic and_1562_s12_q;
  logic equal_1563_s12_q;
  logic or_1583_s12_q;
  logic less_1649_s12_q;
  logic and_1676_s12_q;
  logic and_1689_s12_q;
  logic right_3_s12_q;
  logic less_1703_s12_q;
  logic [5:0] b_s12_q;
  logic and_1736_s12_q;
  logic [7:0] sum_1769_s12_q;
  logic equal_1781_s12_q;
  logic or_1782_s12_q;
  logic equal_1788_s12_q;
  logic not_1789_s12_q;
  logic equal_1790_s12_q;
  logic not_1791_s12_q;
  logic equal_1792_s12_q;
  logic equal_1793_s12_q;
  logic or_1794_s12_q;
  logic [7:0] patches_right_0_rdata_s12_q;
  logic [4:0] select_1818_s12_q;
  logic select_1824_s12_q;
  logic [7:0] patches_right_1_rdata_s12_q;
  logic [3:0] select_1863_s12_q;
  logic and_1873_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic less_1967_s12_q;
  logic equal_1968_s12_q;
  logic not_1969_s12_q;
  logic equal_1970_s12_q;
  logic not_1971_s12_q;
  logic [14:0] patches_rows_rdata_s12_q;
  logic sum_1999_s12_q;
  logic and_2020_s12_q;
  logic and_2142_s12_q;
  logic equal_2284_s12_q;
  logic equal_2473_s12_q;
  logic and_2600_s12_q;
  logic equal_2685_s12_q;
  logic [7:0] wide_s12_q;
  logic [8:0] size_3_s12_q;
  logic less_2766_s12_q;
  logic not_2993_s12_q;
  logic or_3048_s12_q;
  logic not_3072_s12_q;
  logic equal_3551_s12_q;
  logic less_3877_s12_q;
  logic equal_4096_s12_q;
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
      registration_slope_s12_q <= registration_slope_s11_q;
      patches_band_rows_number_s12_q <= patches_band_rows_number_s11_q;
      patches_chooses_s12_q <= patches_chooses_s11_q;
      patches_choosing_band_s12_q <= patches_choosing_band_s11_q;
      patches_lower_s12_q <= patches_lower_s11_q;
      patches_second_s12_q <= patches_second_s11_q;
      patches_code_row_s12_q <= patches_code_row_s11_q;
      patches_column_s12_q <= patches_column_s11_q;
      patches_step_s12_q <= patches_step_s11_q;
      patches_read_searches_s12_q <= patches_read_searches_q;
      select_508_s12_q <= select_508_s11_q;
      equal_509_s12_q <= equal_509_s11_q;
      select_511_s12_q <= select_511_s11_q;
      select_515_s12_q <= select_515_s11_q;
      and_524_s12_q <= and_524_s11_q;
      equal_530_s12_q <= equal_530_s11_q;
      last_s12_q <= last_s11_q;
      and_548_s12_q <= and_548_s11_q;
      and_550_s12_q <= and_550_s11_q;
      equal_570_s12_q <= equal_570;
      first_s12_q <= first;
      equal_575_s12_q <= equal_575_s11_q;
      so_s12_q <= so_s11_q;
      equal_579_s12_q <= equal_579_s11_q;
      or_580_s12_q <= or_580_s11_q;
      less_583_s12_q <= less_583_s11_q;
      not_584_s12_q <= not_584_s11_q;
      equal_594_s12_q <= equal_594_s11_q;
      and_601_s12_q <= and_601_s11_q;
      and_609_s12_q <= and_609_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_627_s12_q <= select_627_s11_q;
      right_s12_q <= right_s11_q;
      and_640_s12_q <= and_640_s11_q;
      and_645_s12_q <= and_645_s11_q;
      and_647_s12_q <= and_647_s11_q;
      equal_680_s12_q <= equal_680_s11_q;
      xor_838_s12_q <= xor_838_s11_q;
      xor_933_s12_q <= parity_887_s11_q ^ parity_932;
      parity_978_s12_q <= parity_978;
      and_979_s12_q <= parity_960 & parity_975;
      and_981_s12_q <= (^{or_942, or_938, and_934}) & (parity_960 | parity_975);
      and_983_s12_q <= or_938 & or_942;
      and_985_s12_q <= and_934 & (or_938 | or_942);
      or_990_s12_q <= or_990;
      or_994_s12_q <= (or_968 & or_972) | (or_964 & (or_968 | or_972));
      xor_1087_s12_q <= xor_1087_s11_q;
      xor_1182_s12_q <= parity_1136_s11_q ^ parity_1181;
      parity_1227_s12_q <= parity_1227;
      and_1228_s12_q <= parity_1209 & parity_1224;
      and_1230_s12_q <= (^{or_1191, or_1187, and_1183}) & (parity_1209 | parity_1224);
      and_1232_s12_q <= or_1187 & or_1191;
      and_1234_s12_q <= and_1183 & (or_1187 | or_1191);
      or_1239_s12_q <= or_1239;
      or_1243_s12_q <= (or_1217 & or_1221) | (or_1213 & (or_1217 | or_1221));
      xor_1336_s12_q <= xor_1336_s11_q;
      xor_1431_s12_q <= parity_1385_s11_q ^ parity_1430;
      parity_1476_s12_q <= parity_1476;
      and_1477_s12_q <= parity_1458 & parity_1473;
      and_1479_s12_q <= (^{or_1440, or_1436, and_1432}) & (parity_1458 | parity_1473);
      and_1481_s12_q <= or_1436 & or_1440;
      and_1483_s12_q <= and_1432 & (or_1436 | or_1440);
      or_1488_s12_q <= or_1488;
      or_1492_s12_q <= (or_1466 & or_1470) | (or_1462 & (or_1466 | or_1470));
      and_1562_s12_q <= and_1562_s11_q;
      equal_1563_s12_q <= equal_1563_s11_q;
      or_1583_s12_q <= or_1583_s11_q;
      less_1649_s12_q <= less_1649_s11_q;
      and_1676_s12_q <= and_1676_s11_q;
      and_1689_s12_q <= and_1689_s11_q;
      right_3_s12_q <= right_3_s11_q;
      less_1703_s12_q <= less_1703_s11_q;
      b_s12_q <= b_s11_q;
      and_1736_s12_q <= and_1736;
      sum_1769_s12_q <= sum_1769[9:2];
      equal_1781_s12_q <= equal_1781_s11_q;
      or_1782_s12_q <= and_1726 | equal_1781_s11_q;
      equal_1788_s12_q <= equal_1788_s11_q;
      not_1789_s12_q <= not_1789_s11_q;
      equal_1790_s12_q <= equal_1790_s11_q;
      not_1791_s12_q <= not_1791_s11_q;
      equal_1792_s12_q <= equal_1792_s11_q;
      equal_1793_s12_q <= equal_1793_s11_q;
      or_1794_s12_q <= or_1794_s11_q;
      patches_right_0_rdata_s12_q <= patches_right_0_rdata_q;
      select_1818_s12_q <= select_1818_s11_q;
      select_1824_s12_q <= select_1824_s11_q;
      patches_right_1_rdata_s12_q <= patches_right_1_rdata_q;
      select_1863_s12_q <= select_1863_s11_q;
      and_1873_s12_q <= and_1873_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_q;
      less_1967_s12_q <= less_1967_s11_q;
      equal_1968_s12_q <= equal_1968_s11_q;
      not_1969_s12_q <= not_1969_s11_q;
      equal_1970_s12_q <= equal_1970_s11_q;
      not_1971_s12_q <= not_1971_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_q;
      sum_1999_s12_q <= sum_1999_s11_q;
      and_2020_s12_q <= and_2020_s11_q;
      and_2142_s12_q <= so_s11_q & (ends_cell_s11_q & and_2140_s11_q);
      equal_2284_s12_q <= equal_2284_s11_q;
      equal_2473_s12_q <= equal_2473_s11_q;
      and_2600_s12_q <= and_2600_s11_q;
      equal_2685_s12_q <= equal_2685_s11_q;
      wide_s12_q <= wide;
      size_3_s12_q <= size_3;
      less_2766_s12_q <= less_2766_s11_q;
      not_2993_s12_q <= not_2993_s11_q;
      or_3048_s12_q <= or_3048_s11_q;
      not_3072_s12_q <= not_3072_s11_q;
      equal_3551_s12_q <= equal_3551_s11_q;
      less_3877_s12_q <= less_3877_s11_q;
      equal_4096_s12_q <= equal_4096_s11_q;
    end
  end

  // Stage 12 ----------------------------------------------------------------------------------------------------------
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
  assign inside_v = or_580_s12_q & not_584_s12_q;
  // hls/stages/count_bits.hpp:25
  logic or_982;
  assign or_982 = and_979_s12_q | and_981_s12_q;
  logic or_986;
  assign or_986 = and_983_s12_q | and_985_s12_q;
  // hls/stages/count_bits.hpp:24
  logic parity_999;
  assign parity_999 = ^{or_994_s12_q, or_990_s12_q, or_986, or_982};
  // hls/stages/count_bits.hpp:25
  logic or_1003;
  assign or_1003 = (or_990_s12_q & or_994_s12_q) | (or_986 & (or_990_s12_q | or_994_s12_q));
  logic and_1004;
  assign and_1004 = or_982 & (^{or_994_s12_q, or_990_s12_q, or_986});
  // hls/stages/count_bits.hpp:24
  logic xor_1005;
  assign xor_1005 = or_1003 ^ and_1004;
  // hls/stages/count_bits.hpp:27
  logic and_1006;
  assign and_1006 = or_1003 & and_1004;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1007;
  assign select_1007 = equal_594_s12_q ? {and_1006, xor_1005, parity_999, parity_978_s12_q, xor_933_s12_q, xor_838_s12_q} : 6'h0;
  logic [5:0] column;
  assign column = or_580_s12_q ? 6'h0 : select_1007;
  // hls/stages/count_bits.hpp:25
  logic or_1231;
  assign or_1231 = and_1228_s12_q | and_1230_s12_q;
  logic or_1235;
  assign or_1235 = and_1232_s12_q | and_1234_s12_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1248;
  assign parity_1248 = ^{or_1243_s12_q, or_1239_s12_q, or_1235, or_1231};
  // hls/stages/count_bits.hpp:25
  logic or_1252;
  assign or_1252 = (or_1239_s12_q & or_1243_s12_q) | (or_1235 & (or_1239_s12_q | or_1243_s12_q));
  logic and_1253;
  assign and_1253 = or_1231 & (^{or_1243_s12_q, or_1239_s12_q, or_1235});
  // hls/stages/count_bits.hpp:24
  logic xor_1254;
  assign xor_1254 = or_1252 ^ and_1253;
  // hls/stages/count_bits.hpp:27
  logic and_1255;
  assign and_1255 = or_1252 & and_1253;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1256;
  assign select_1256 = equal_594_s12_q ? {and_1255, xor_1254, parity_1248, parity_1227_s12_q, xor_1182_s12_q, xor_1087_s12_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_580_s12_q ? 6'h0 : select_1256;
  // hls/stages/count_bits.hpp:25
  logic or_1480;
  assign or_1480 = and_1477_s12_q | and_1479_s12_q;
  logic or_1484;
  assign or_1484 = and_1481_s12_q | and_1483_s12_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1497;
  assign parity_1497 = ^{or_1492_s12_q, or_1488_s12_q, or_1484, or_1480};
  // hls/stages/count_bits.hpp:25
  logic or_1501;
  assign or_1501 = (or_1488_s12_q & or_1492_s12_q) | (or_1484 & (or_1488_s12_q | or_1492_s12_q));
  logic and_1502;
  assign and_1502 = or_1480 & (^{or_1492_s12_q, or_1488_s12_q, or_1484});
  // hls/stages/count_bits.hpp:24
  logic xor_1503;
  assign xor_1503 = or_1501 ^ and_1502;
  // hls/stages/count_bits.hpp:27
  logic and_1504;
  assign and_1504 = or_1501 & and_1502;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1505;
  assign select_1505 = equal_594_s12_q ? {and_1504, xor_1503, parity_1497, parity_1476_s12_q, xor_1431_s12_q, xor_1336_s12_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_580_s12_q ? 6'h0 : select_1505;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s12_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1541;
  assign sum_1541 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s12_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1544;
  assign sum_1544 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v & less_1649_s12_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1770;
  assign sum_1770 = {registration_slope_s12_q[11], registration_slope_s12_q} + {{5{sum_1769_s12_q[7]}}, sum_1769_s12_q};
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1793_s12_q ? (patches_second_s12_q ? 8'h0 : patches_right_0_rdata_s12_q) : 8'h0;
  // hls/stages/patches.hpp:467
  logic [8:0] sum_1920;
  assign sum_1920 = {1'b0, patches_columns_above_rdata_s12_q[23:16]} + {3'h0, patches_columns_above_rdata_s12_q[31:26]};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2743;
  assign select_2743 = ({wide_s12_q, 1'b0} < size_3_s12_q) ? {wide_s12_q, 1'b0} : size_3_s12_q;
  logic [8:0] taken;
  assign taken = ~select_2743;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3514;
  assign select_3514 = less_1967_s12_q ? patches_rows_rdata_s12_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3516;
  assign select_3516 = less_1967_s12_q ? (equal_1970_s12_q ? 10'h0 : select_3514) : 10'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3521;
  assign select_3521 = less_1967_s12_q ? patches_rows_rdata_s12_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3524;
  assign select_3524 = equal_1970_s12_q ? (less_1967_s12_q ? (equal_1970_s12_q ? 5'h0 : select_3521) : 5'h0) : select_3521;

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
    if (s12_en) begin
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
  logic [3:0] age_s13_q;
  logic [2:0] slot_s13_q;
  logic ends_cell_s13_q;
  logic lower_half_s13_q;
  logic shift_first_s13_q;
  logic [4:0] patches_band_rows_number_s13_q;
  logic patches_chooses_s13_q;
  logic [4:0] patches_choosing_band_s13_q;
  logic patches_lower_s13_q;
  logic patches_second_s13_q;
  logic [4:0] patches_code_row_s13_q;
  logic [4:0] patches_column_s13_q;
  logic [4:0] patches_step_s13_q;
  logic patches_read_searches_s13_q;
  logic [3:0] select_508_s13_q;
  logic equal_509_s13_q;
  logic [6:0] select_511_s13_q;
  logic [8:0] select_515_s13_q;
  logic and_524_s13_q;
  logic equal_530_s13_q;
  logic [6:0] last_s13_q;
  logic and_548_s13_q;
  logic and_550_s13_q;
  logic equal_570_s13_q;
  logic first_s13_q;
  logic equal_575_s13_q;
  logic so_s13_q;
  logic equal_579_s13_q;
  logic or_580_s13_q;
  logic less_583_s13_q;
  logic not_584_s13_q;
  logic inside_v_s13_q;
  logic and_601_s13_q;
  logic and_609_s13_q;
  logic [6:0] x_s13_2_q;
  logic [61:0] best_left_rdata_s13_q;
  logic [6:0] select_627_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic and_640_s13_q;
  logic and_645_s13_q;
  logic and_647_s13_q;
  logic equal_680_s13_q;
  logic [5:0] column_s13_q;
  logic [5:0] select_1258_s13_q;
  logic [5:0] select_1507_s13_q;
  logic [6:0] sum_1542_s13_q;
  logic [6:0] sum_1545_s13_q;
  logic and_1562_s13_q;
  logic equal_1563_s13_q;
  logic or_1583_s13_q;
  logic right_2_s13_q;
  logic and_1676_s13_q;
  logic and_1689_s13_q;
  logic and_1701_s13_q;
  logic less_1703_s13_q;
  logic [5:0] b_s13_q;
  logic and_1736_s13_q;
  logic [7:0] sum_1770_s13_q;
  logic less_1771_s13_q;
  logic less_1772_s13_q;
  logic equal_1781_s13_q;
  logic and_1785_s13_q;
  logic equal_1788_s13_q;
  logic not_1789_s13_q;
  logic equal_1790_s13_q;
  logic not_1791_s13_q;
  logic equal_1792_s13_q;
  logic equal_1793_s13_q;
  logic or_1794_s13_q;
  logic [4:0] select_1818_s13_q;
  logic select_1824_s13_q;
  logic [7:0] patches_left_rdata_s13_q;
  logic [3:0] select_1863_s13_q;
  logic and_1873_s13_q;
  logic [31:0] patches_columns_above_rdata_s13_q;
  logic [7:0] select_1877_s13_q;
  logic [8:0] sum_1920_s13_q;
  logic less_1967_s13_q;
  logic equal_1968_s13_q;
  logic not_1969_s13_q;
  logic equal_1970_s13_q;
  logic not_1971_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1999_s13_q;
  logic and_2020_s13_q;
  logic and_2142_s13_q;
  logic equal_2284_s13_q;
  logic equal_2473_s13_q;
  logic and_2600_s13_q;
  logic equal_2685_s13_q;
  logic less_2727_s13_q;
  logic [7:0] wide_s13_q;
  logic [8:0] taken_s13_q;
  logic [7:0] not_2745_s13_q;
  logic less_2766_s13_q;
  logic and_2996_s13_q;
  logic or_3048_s13_q;
  logic not_3072_s13_q;
  logic [9:0] select_3517_s13_q;
  logic [4:0] select_3524_s13_q;
  logic equal_3551_s13_q;
  logic less_3877_s13_q;
  logic equal_4096_s13_q;
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
      run_shift_s13_q <= run_shift_s12_q;
      x_s13_q <= x_s12_q;
      age_s13_q <= age_s12_q;
      slot_s13_q <= slot_s12_q;
      ends_cell_s13_q <= ends_cell_s12_q;
      lower_half_s13_q <= lower_half_s12_q;
      shift_first_s13_q <= shift_first_s12_q;
      patches_band_rows_number_s13_q <= patches_band_rows_number_s12_q;
      patches_chooses_s13_q <= patches_chooses_s12_q;
      patches_choosing_band_s13_q <= patches_choosing_band_s12_q;
      patches_lower_s13_q <= patches_lower_s12_q;
      patches_second_s13_q <= patches_second_s12_q;
      patches_code_row_s13_q <= patches_code_row_s12_q;
      patches_column_s13_q <= patches_column_s12_q;
      patches_step_s13_q <= patches_step_s12_q;
      patches_read_searches_s13_q <= patches_read_searches_s12_q;
      select_508_s13_q <= select_508_s12_q;
      equal_509_s13_q <= equal_509_s12_q;
      select_511_s13_q <= select_511_s12_q;
      select_515_s13_q <= select_515_s12_q;
      and_524_s13_q <= and_524_s12_q;
      equal_530_s13_q <= equal_530_s12_q;
      last_s13_q <= last_s12_q;
      and_548_s13_q <= and_548_s12_q;
      and_550_s13_q <= and_550_s12_q;
      equal_570_s13_q <= equal_570_s12_q;
      first_s13_q <= first_s12_q;
      equal_575_s13_q <= equal_575_s12_q;
      so_s13_q <= so_s12_q;
      equal_579_s13_q <= equal_579_s12_q;
      or_580_s13_q <= or_580_s12_q;
      less_583_s13_q <= less_583_s12_q;
      not_584_s13_q <= not_584_s12_q;
      inside_v_s13_q <= inside_v;
      and_601_s13_q <= and_601_s12_q;
      and_609_s13_q <= and_609_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      select_627_s13_q <= select_627_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_q;
      and_640_s13_q <= and_640_s12_q;
      and_645_s13_q <= and_645_s12_q;
      and_647_s13_q <= and_647_s12_q;
      equal_680_s13_q <= equal_680_s12_q;
      column_s13_q <= column;
      select_1258_s13_q <= age_s12_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1507_s13_q <= age_s12_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1542_s13_q <= {1'b0, before_v_2} + sum_1541;
      sum_1545_s13_q <= {1'b0, before_v_3} + sum_1544;
      and_1562_s13_q <= and_1562_s12_q;
      equal_1563_s13_q <= equal_1563_s12_q;
      or_1583_s13_q <= or_1583_s12_q;
      right_2_s13_q <= right_2;
      and_1676_s13_q <= and_1676_s12_q;
      and_1689_s13_q <= and_1689_s12_q;
      and_1701_s13_q <= so_s12_q & (ends_cell_s12_q & (inside_v & right_3_s12_q));
      less_1703_s13_q <= less_1703_s12_q;
      b_s13_q <= b_s12_q;
      and_1736_s13_q <= and_1736_s12_q;
      sum_1770_s13_q <= sum_1770[7:0];
      less_1771_s13_q <= $signed(6'h0) < $signed(sum_1770[12:7]);
      less_1772_s13_q <= $signed(sum_1770[12:7]) < $signed(6'h3f);
      equal_1781_s13_q <= equal_1781_s12_q;
      and_1785_s13_q <= so_s12_q & (ends_cell_s12_q & (inside_v & or_1782_s12_q));
      equal_1788_s13_q <= equal_1788_s12_q;
      not_1789_s13_q <= not_1789_s12_q;
      equal_1790_s13_q <= equal_1790_s12_q;
      not_1791_s13_q <= not_1791_s12_q;
      equal_1792_s13_q <= equal_1792_s12_q;
      equal_1793_s13_q <= equal_1793_s12_q;
      or_1794_s13_q <= or_1794_s12_q;
      select_1818_s13_q <= select_1818_s12_q;
      select_1824_s13_q <= select_1824_s12_q;
      patches_left_rdata_s13_q <= patches_left_rdata_q;
      select_1863_s13_q <= select_1863_s12_q;
      and_1873_s13_q <= and_1873_s12_q;
      patches_columns_above_rdata_s13_q <= patches_columns_above_rdata_s12_q;
      select_1877_s13_q <= patches_second_s12_q ? patches_right_1_rdata_s12_q : pixel;
      sum_1920_s13_q <= sum_1920;
      less_1967_s13_q <= less_1967_s12_q;
      equal_1968_s13_q <= equal_1968_s12_q;
      not_1969_s13_q <= not_1969_s12_q;
      equal_1970_s13_q <= equal_1970_s12_q;
      not_1971_s13_q <= not_1971_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q[9:0];
      sum_1999_s13_q <= sum_1999_s12_q;
      and_2020_s13_q <= and_2020_s12_q;
      and_2142_s13_q <= and_2142_s12_q;
      equal_2284_s13_q <= equal_2284_s12_q;
      equal_2473_s13_q <= equal_2473_s12_q;
      and_2600_s13_q <= and_2600_s12_q;
      equal_2685_s13_q <= equal_2685_s12_q;
      less_2727_s13_q <= slot_s12_q < 3'h3;
      wide_s13_q <= wide_s12_q;
      taken_s13_q <= taken;
      not_2745_s13_q <= ~wide_s12_q;
      less_2766_s13_q <= less_2766_s12_q;
      and_2996_s13_q <= so_s12_q & (ends_cell_s12_q & (inside_v & not_2993_s12_q));
      or_3048_s13_q <= or_3048_s12_q;
      not_3072_s13_q <= not_3072_s12_q;
      select_3517_s13_q <= equal_1970_s12_q ? select_3516 : select_3514;
      select_3524_s13_q <= select_3524;
      equal_3551_s13_q <= equal_3551_s12_q;
      less_3877_s13_q <= less_3877_s12_q;
      equal_4096_s13_q <= equal_4096_s12_q;
    end
  end

  // Stage 13 ----------------------------------------------------------------------------------------------------------
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
  logic [13:0] select_573;
  assign select_573 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:1009
  logic not_576;
  assign not_576 = ~equal_575_s13_q;
  // hls/stages/agreement.hpp:201
  logic not_578;
  assign not_578 = ~so_s13_q;
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s13_q[2] ? best_right_rdata_s13_q[14:8] : best_right_rdata_s13_q[28:22];
  // hls/stages/agreement.hpp:807
  logic or_760;
  assign or_760 = shift_first_s13_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1009;
  assign select_1009 = age_s13_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s13_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1537;
  assign sum_1537 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1547;
  assign select_1547 = (sum_1542_s13_q < sum_1545_s13_q) ? sum_1545_s13_q : sum_1542_s13_q;
  // hls/stages/agreement.hpp:788
  logic and_1573;
  assign and_1573 = ends_cell_s13_q & inside_v_s13_q;
  logic and_1575;
  assign and_1575 = not_576 & (so_s13_q & and_1573);
  // hls/stages/registration.hpp:83
  logic equal_1704;
  assign equal_1704 = slot_s13_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1707;
  assign select_1707 = b_s13_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1708;
  assign select_1708 = b_s13_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1709;
  assign sum_1709 = {{2{select_1707[6]}}, select_1707} + {select_1708[7], select_1708};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1710;
  assign select_1710 = b_s13_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1711;
  assign select_1711 = b_s13_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1712;
  assign sum_1712 = {{2{select_1710[7]}}, select_1710[7:1]} + {select_1711[7], select_1711};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1714;
  assign select_1714 = b_s13_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1715;
  assign select_1715 = b_s13_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1716;
  assign difference_1716 = {{2{select_1714[7]}}, select_1714[7:1]} - {select_1715[7], select_1715};
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1752;
  assign select_1752 = so_s13_q ? (ends_cell_s13_q ? (inside_v_s13_q ? b_s13_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1774;
  assign select_1774 = less_1771_s13_q ? 8'h7f : (less_1772_s13_q ? 8'h80 : sum_1770_s13_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1704 ? registration_slope_here_q : select_1774;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1778;
  assign select_1778 = so_s13_q ? (ends_cell_s13_q ? (inside_v_s13_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1786;
  assign and_1786 = not_576 & and_1785_s13_q;
  // hls/stages/patches.hpp:172
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1793_s13_q ? select_1877_s13_q : patches_left_rdata_s13_q;
  // hls/stages/patches.hpp:467
  logic [9:0] sum_1921;
  assign sum_1921 = {2'h0, patches_columns_above_rdata_s13_q[15:8]} + {1'b0, sum_1920_s13_q};
  // hls/stages/agreement.hpp:788
  logic and_2336;
  assign and_2336 = not_576 & (not_578 & (equal_579_s13_q & (inside_v_s13_q & first_s13_q)));
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2573;
  assign select_2573 = slot_s13_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2574;
  assign select_2574 = slot_s13_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2575;
  assign select_2575 = slot_s13_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2576;
  assign select_2576 = slot_s13_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2577;
  assign select_2577 = slot_s13_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2578;
  assign select_2578 = slot_s13_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s13_q[61:54]} - {1'b0, best_left_rdata_s13_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2738;
  assign not_2738 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2727_s13_q ? {1'b0, wide_s13_q, 1'b0} : {registration_displacement_over_q[8:0], not_2738};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2746;
  assign select_2746 = registration_displacement_over_q[9] ? wide_s13_q : not_2745_s13_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2727_s13_q ? {taken_s13_q, 1'b1} : {not_2738, select_2746, not_2738};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2748;
  assign sum_2748 = {left, 1'b1} + {taken_2, less_2727_s13_q};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2750;
  assign select_2750 = so_s13_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2752;
  assign select_2752 = equal_575_s13_q ? registration_slope_here_q : (so_s13_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2761;
  assign select_2761 = or_580_s13_q ? (less_583_s13_q ? 3'h0 : best_left_rdata_s13_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3519;
  assign select_3519 = less_1967_s13_q ? (equal_1968_s13_q ? 10'h0 : select_3517_s13_q) : select_3517_s13_q;
  logic [4:0] select_3526;
  assign select_3526 = less_1967_s13_q ? (equal_1968_s13_q ? 5'h0 : select_3524_s13_q) : select_3524_s13_q;
  // hls/stages/patches.hpp:556
  logic and_3536;
  assign and_3536 = less_1967_s13_q & (patches_step_s13_q == 5'h0);
  // hls/stages/patches.hpp:560
  logic select_3539;
  assign select_3539 = equal_1970_s13_q ? (less_1967_s13_q ? (not_1971_s13_q & and_3536) : and_3536) : and_3536;

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1405; read in stage 13, written in stage 17: 13 < 17 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s13_q[6:0];
`ifndef SYNTHESIS
  logic seen_columns_re;
  assign seen_columns_re = s13_en & and_1575;
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
    end else if (s13_en) begin
      moments_place_q <= select_573;
      moments_taken_q <= not_576 & (not_578 & (equal_579_s13_q & inside_v_s13_q));
      moments_starts_q <= and_2336;
      shift_not_right_q <= $signed(run_shift_s13_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s13_q ? sum_2748[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2750;
      registration_slope_here_q <= select_2752;
      patches_read_row_differing_q <= equal_1788_s13_q ? select_3519 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1788_s13_q ? select_3526 : patches_read_row_column_q;
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
    if (s13_en) begin
      middle_sum_columns_values_0_q <= slot_s13_q[0] ? middle_sum_columns_values_0_q : column_s13_q;
      middle_sum_columns_values_1_q <= select_2573;
      middle_sum_columns_values_2_q <= select_2574;
      middle_sum_columns_values_3_q <= select_2575;
      middle_sum_columns_values_4_q <= select_2576;
      middle_sum_columns_values_5_q <= select_2577;
      middle_sum_columns_values_6_q <= select_2578;
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
  logic [1:0] age_s14_q;
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
  logic [4:0] patches_step_s14_q;
  logic [9:0] patches_read_row_differing_s14_q;
  logic [4:0] patches_read_row_column_s14_q;
  logic patches_read_searches_s14_q;
  logic [3:0] select_508_s14_q;
  logic equal_509_s14_q;
  logic [6:0] select_511_s14_q;
  logic [8:0] select_515_s14_q;
  logic and_524_s14_q;
  logic equal_530_s14_q;
  logic [6:0] last_s14_q;
  logic and_548_s14_q;
  logic and_550_s14_q;
  logic equal_570_s14_q;
  logic first_s14_q;
  logic equal_575_s14_q;
  logic not_576_s14_q;
  logic so_s14_q;
  logic not_578_s14_q;
  logic equal_579_s14_q;
  logic or_580_s14_q;
  logic less_583_s14_q;
  logic not_584_s14_q;
  logic inside_v_s14_q;
  logic and_601_s14_q;
  logic and_609_s14_q;
  logic [6:0] x_s14_2_q;
  logic [61:0] best_left_rdata_s14_q;
  logic less_620_s14_q;
  logic [6:0] select_627_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic [6:0] chosen_s14_q;
  logic and_640_s14_q;
  logic and_645_s14_q;
  logic and_647_s14_q;
  logic equal_680_s14_q;
  logic select_762_s14_q;
  logic [6:0] difference_1010_s14_q;
  logic [6:0] difference_1259_s14_q;
  logic equal_1260_s14_q;
  logic [6:0] difference_1508_s14_q;
  logic [6:0] sum_1538_s14_q;
  logic [6:0] select_1547_s14_q;
  logic and_1562_s14_q;
  logic select_1564_s14_q;
  logic and_1573_s14_q;
  logic and_1575_s14_q;
  logic or_1583_s14_q;
  logic right_2_s14_q;
  logic and_1676_s14_q;
  logic and_1689_s14_q;
  logic and_1702_s14_q;
  logic less_1703_s14_q;
  logic equal_1704_s14_q;
  logic [7:0] sum_1709_s14_q;
  logic select_1710_s14_q;
  logic [8:0] sum_1712_s14_q;
  logic select_1714_s14_q;
  logic [8:0] difference_1716_s14_q;
  logic and_1736_s14_q;
  logic [5:0] select_1753_s14_q;
  logic [7:0] select_1779_s14_q;
  logic equal_1781_s14_q;
  logic and_1786_s14_q;
  logic and_1787_s14_q;
  logic equal_1788_s14_q;
  logic not_1789_s14_q;
  logic equal_1790_s14_q;
  logic not_1791_s14_q;
  logic equal_1792_s14_q;
  logic equal_1793_s14_q;
  logic or_1794_s14_q;
  logic [4:0] select_1818_s14_q;
  logic select_1824_s14_q;
  logic [3:0] select_1863_s14_q;
  logic and_1873_s14_q;
  logic [31:0] patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic [9:0] sum_1921_s14_q;
  logic less_1967_s14_q;
  logic equal_1968_s14_q;
  logic not_1969_s14_q;
  logic equal_1970_s14_q;
  logic not_1971_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic sum_1999_s14_q;
  logic and_2020_s14_q;
  logic and_2143_s14_q;
  logic equal_2284_s14_q;
  logic equal_2473_s14_q;
  logic and_2600_s14_q;
  logic equal_2685_s14_q;
  logic rise_s14_q;
  logic [7:0] xor_2690_s14_q;
  logic select_2761_s14_q;
  logic or_2764_s14_q;
  logic [1:0] sum_2765_s14_q;
  logic less_2766_s14_q;
  logic and_2997_s14_q;
  logic or_3048_s14_q;
  logic not_3072_s14_q;
  logic select_3539_s14_q;
  logic equal_3551_s14_q;
  logic less_3877_s14_q;
  logic equal_4096_s14_q;
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
      moments_starts_s14_q <= moments_starts_q;
      run_shift_s14_q <= run_shift_s13_q;
      x_s14_q <= x_s13_q;
      age_s14_q <= {age_s13_q[2], age_s13_q[0]};
      slot_s14_q <= slot_s13_q;
      ends_cell_s14_q <= ends_cell_s13_q;
      lower_half_s14_q <= lower_half_s13_q;
      shift_not_right_s14_q <= shift_not_right_q;
      patches_band_rows_number_s14_q <= patches_band_rows_number_s13_q;
      patches_choosing_band_s14_q <= patches_choosing_band_s13_q;
      patches_lower_s14_q <= patches_lower_s13_q;
      patches_second_s14_q <= patches_second_s13_q;
      patches_code_row_s14_q <= patches_code_row_s13_q;
      patches_column_s14_q <= patches_column_s13_q;
      patches_step_s14_q <= patches_step_s13_q;
      patches_read_row_differing_s14_q <= patches_read_row_differing_q;
      patches_read_row_column_s14_q <= patches_read_row_column_q;
      patches_read_searches_s14_q <= patches_read_searches_s13_q;
      select_508_s14_q <= select_508_s13_q;
      equal_509_s14_q <= equal_509_s13_q;
      select_511_s14_q <= select_511_s13_q;
      select_515_s14_q <= select_515_s13_q;
      and_524_s14_q <= and_524_s13_q;
      equal_530_s14_q <= equal_530_s13_q;
      last_s14_q <= last_s13_q;
      and_548_s14_q <= and_548_s13_q;
      and_550_s14_q <= and_550_s13_q;
      equal_570_s14_q <= equal_570_s13_q;
      first_s14_q <= first_s13_q;
      equal_575_s14_q <= equal_575_s13_q;
      not_576_s14_q <= not_576;
      so_s14_q <= so_s13_q;
      not_578_s14_q <= not_578;
      equal_579_s14_q <= equal_579_s13_q;
      or_580_s14_q <= or_580_s13_q;
      less_583_s14_q <= less_583_s13_q;
      not_584_s14_q <= not_584_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      and_601_s14_q <= and_601_s13_q;
      and_609_s14_q <= and_609_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q;
      less_620_s14_q <= 8'hb6 < best_left_rdata_s13_q[16:9];
      select_627_s14_q <= select_627_s13_q;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      chosen_s14_q <= chosen;
      and_640_s14_q <= and_640_s13_q;
      and_645_s14_q <= and_645_s13_q;
      and_647_s14_q <= and_647_s13_q;
      equal_680_s14_q <= equal_680_s13_q;
      select_762_s14_q <= or_760 ? shift_first_s13_q : (~age_s13_q[1]);
      difference_1010_s14_q <= {1'b0, column_s13_q} - {1'b0, select_1009};
      difference_1259_s14_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1258_s13_q};
      equal_1260_s14_q <= {age_s13_q[0], slot_s13_q[0]} == 2'h0;
      difference_1508_s14_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1507_s13_q};
      sum_1538_s14_q <= {1'b0, before_v} + sum_1537;
      select_1547_s14_q <= select_1547;
      and_1562_s14_q <= and_1562_s13_q;
      select_1564_s14_q <= or_760 ? shift_first_s13_q : equal_1563_s13_q;
      and_1573_s14_q <= and_1573;
      and_1575_s14_q <= and_1575;
      or_1583_s14_q <= or_1583_s13_q;
      right_2_s14_q <= right_2_s13_q;
      and_1676_s14_q <= and_1676_s13_q;
      and_1689_s14_q <= and_1689_s13_q;
      and_1702_s14_q <= not_576 & and_1701_s13_q;
      less_1703_s14_q <= less_1703_s13_q;
      equal_1704_s14_q <= equal_1704;
      sum_1709_s14_q <= sum_1709[8:1];
      select_1710_s14_q <= select_1710[0];
      sum_1712_s14_q <= sum_1712;
      select_1714_s14_q <= select_1714[0];
      difference_1716_s14_q <= difference_1716;
      and_1736_s14_q <= and_1736_s13_q;
      select_1753_s14_q <= equal_575_s13_q ? 6'h0 : select_1752;
      select_1779_s14_q <= equal_575_s13_q ? 8'h0 : select_1778;
      equal_1781_s14_q <= equal_1781_s13_q;
      and_1786_s14_q <= and_1786;
      and_1787_s14_q <= patches_chooses_s13_q & and_1786;
      equal_1788_s14_q <= equal_1788_s13_q;
      not_1789_s14_q <= not_1789_s13_q;
      equal_1790_s14_q <= equal_1790_s13_q;
      not_1791_s14_q <= not_1791_s13_q;
      equal_1792_s14_q <= equal_1792_s13_q;
      equal_1793_s14_q <= equal_1793_s13_q;
      or_1794_s14_q <= or_1794_s13_q;
      select_1818_s14_q <= select_1818_s13_q;
      select_1824_s14_q <= select_1824_s13_q;
      select_1863_s14_q <= select_1863_s13_q;
      and_1873_s14_q <= and_1873_s13_q;
      patches_columns_above_rdata_s14_q <= patches_columns_above_rdata_s13_q;
      pixel_2_s14_q <= pixel_2;
      sum_1921_s14_q <= sum_1921;
      less_1967_s14_q <= less_1967_s13_q;
      equal_1968_s14_q <= equal_1968_s13_q;
      not_1969_s14_q <= not_1969_s13_q;
      equal_1970_s14_q <= equal_1970_s13_q;
      not_1971_s14_q <= not_1971_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      sum_1999_s14_q <= sum_1999_s13_q;
      and_2020_s14_q <= and_2020_s13_q;
      and_2143_s14_q <= not_576 & and_2142_s13_q;
      equal_2284_s14_q <= equal_2284_s13_q;
      equal_2473_s14_q <= equal_2473_s13_q;
      and_2600_s14_q <= and_2600_s13_q;
      equal_2685_s14_q <= equal_2685_s13_q;
      rise_s14_q <= rise[8];
      xor_2690_s14_q <= rise[7:0] ^ {8{rise[8]}};
      select_2761_s14_q <= select_2761[0];
      or_2764_s14_q <= (select_2761 == 3'h0) | (select_2761 == 3'h4);
      sum_2765_s14_q <= select_2761[2:1] + 2'h3;
      less_2766_s14_q <= less_2766_s13_q;
      and_2997_s14_q <= not_576 & and_2996_s13_q;
      or_3048_s14_q <= or_3048_s13_q;
      not_3072_s14_q <= not_3072_s13_q;
      select_3539_s14_q <= select_3539;
      equal_3551_s14_q <= equal_3551_s13_q;
      less_3877_s14_q <= less_3877_s13_q;
      equal_4096_s14_q <= equal_4096_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:124
  logic and_525;
  assign and_525 = sample_pair_whole_s14_q & and_524_s14_q;
  // hls/stages/moments.hpp:63
  logic [10:0] place;
  assign place = first_s14_q ? 11'h0 : moments_place_q[13:3];
  // hls/stages/moments.hpp:104
  logic not_588;
  assign not_588 = ~(11'h3ec < place);
  // hls/stages/agreement.hpp:978
  logic select_622;
  assign select_622 = slot_s14_q[2] ? less_620_s14_q : (6'h2a < best_left_rdata_s14_q[39:34]);
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_632;
  assign difference_632 = {2'h0, chosen_s14_q} - {1'b0, x_s14_q};
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1012;
  assign sum_1012 = {difference_1010_s14_q[6], difference_1010_s14_q} + (age_s14_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1262;
  assign sum_1262 = {difference_1259_s14_q[6], difference_1259_s14_q} + (equal_1260_s14_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1510;
  assign sum_1510 = {difference_1508_s14_q[6], difference_1508_s14_q} + (equal_1260_s14_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1539;
  assign select_1539 = slot_s14_q[0] ? chosen_near_q : sum_1538_s14_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1549;
  assign select_1549 = (select_1539 < select_1547_s14_q) ? select_1547_s14_q : select_1539;
  // hls/stages/agreement.hpp:788
  logic [6:0] select_1579;
  assign select_1579 = so_s14_q ? x_s14_q[6:0] : (or_580_s14_q ? (less_583_s14_q ? 7'h0 : select_627_s14_q) : 7'h0);
  // hls/stages/agreement.hpp:149
  logic and_1592;
  assign and_1592 = or_580_s14_q & (slot_s14_q[2] & not_584_s14_q);
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1713;
  assign sum_1713 = {{3{sum_1709_s14_q[7]}}, sum_1709_s14_q} + {sum_1712_s14_q[8], sum_1712_s14_q, select_1710_s14_q};
  logic [9:0] sum_1717;
  assign sum_1717 = {difference_1716_s14_q, select_1714_s14_q} + {sum_1713[10], sum_1713[10:2]};
  // hls/stages/patches.hpp:469
  logic [8:0] sum_1901;
  assign sum_1901 = {1'b0, patches_columns_above_rdata_s14_q[7:0]} + {2'h0, pixel_2_s14_q[7:1]};
  logic [8:0] sum_1902;
  assign sum_1902 = {1'b0, patches_columns_above_rdata_s14_q[23:16]} + {2'h0, patches_columns_above_rdata_s14_q[31:25]};
  // hls/stages/patches.hpp:467
  logic [10:0] sum_1922;
  assign sum_1922 = {3'h0, patches_columns_above_rdata_s14_q[15:8]} + {sum_1921_s14_q, patches_columns_above_rdata_s14_q[25]};
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2585;
  assign select_2585 = slot_s14_q[0] ? 7'h0 : sum_1538_s14_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2587;
  assign select_2587 = (select_2585 < select_1547_s14_q) ? select_1547_s14_q : select_2585;
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise_s14_q ? best_left_rdata_s14_q[61:54] : best_left_rdata_s14_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2767;
  assign difference_2767 = {sum_2765_s14_q, select_2761_s14_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2768;
  assign select_2768 = less_2766_s14_q ? difference_2767 : {sum_2765_s14_q, select_2761_s14_q, registration_displacement_fraction_q};
  logic [7:0] select_2769;
  assign select_2769 = or_2764_s14_q ? {sum_2765_s14_q, select_2761_s14_q, 5'h0} : select_2768;
  // hls/stages/patches.hpp:187
  logic select_3087;
  assign select_3087 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:175
  logic and_3148;
  assign and_3148 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3153;
  assign select_3153 = or_3048_s14_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3155;
  assign select_3155 = and_3148 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:556
  logic [4:0] select_3528;
  assign select_3528 = less_1967_s14_q ? patches_step_s14_q : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3531;
  assign select_3531 = equal_1970_s14_q ? (less_1967_s14_q ? (equal_1970_s14_q ? 5'h0 : select_3528) : 5'h0) : select_3528;
  logic [4:0] select_3533;
  assign select_3533 = less_1967_s14_q ? (equal_1968_s14_q ? 5'h0 : select_3531) : select_3531;
  logic select_3541;
  assign select_3541 = less_1967_s14_q ? (not_1969_s14_q & select_3539_s14_q) : select_3539_s14_q;
  // hls/stages/patches.hpp:178
  logic or_3553;
  assign or_3553 = patches_read_first_q | (patches_read_row_differing_s14_q < patches_peak_best_differing_q);
  logic and_3554;
  assign and_3554 = patches_read_searches_s14_q & or_3553;
  // hls/stages/patches.hpp:539
  logic [14:0] select_3586;
  assign select_3586 = and_3554 ? {patches_read_row_column_s14_q, patches_read_row_differing_s14_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3587;
  assign select_3587 = equal_1788_s14_q ? select_3586[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3588;
  assign select_3588 = equal_1788_s14_q ? select_3586[14:10] : patches_peak_best_column_q;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:235; read in stage 14, written in stage 17: 14 < 17 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_515_s14_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s14_en & and_525;
`endif
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1377; read in stage 14, written in stage 17: 14 < 17 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s14_q[6:0];
`ifndef SYNTHESIS
  logic shown_right_re;
  assign shown_right_re = s14_en & and_1575_s14_q;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1378; read in stage 14, written in stage 18: 14 < 18 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] left_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_turns_mem[i] = 2'h0;
`endif
  logic [6:0] left_turns_raddr;
  assign left_turns_raddr = x_s14_q[6:0];
`ifndef SYNTHESIS
  logic left_turns_re;
  assign left_turns_re = s14_en & and_1592;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1378; read in stage 14, written in stage 18: 14 < 18 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] right_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_627_s14_q;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s14_en & and_1592;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s14_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s14_en & and_1873_s14_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_s14_q[23:0], pixel_2_s14_q};
  end
`ifndef SYNTHESIS
  logic [4:0] patches_columns_above_raddr_s11_sim;
  logic patches_columns_above_re_s11_sim;
  logic [4:0] patches_columns_above_raddr_s12_sim;
  logic patches_columns_above_re_s12_sim;
  logic [4:0] patches_columns_above_raddr_s13_sim;
  logic patches_columns_above_re_s13_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_columns_above_re_s11_sim <= 1'b0;
      patches_columns_above_re_s12_sim <= 1'b0;
      patches_columns_above_re_s13_sim <= 1'b0;
    end else if (en_i) begin
      patches_columns_above_re_s11_sim <= patches_columns_above_re;
      patches_columns_above_raddr_s11_sim <= patches_columns_above_raddr;
      patches_columns_above_re_s12_sim <= patches_columns_above_re_s11_sim;
      patches_columns_above_raddr_s12_sim <= patches_columns_above_raddr_s11_sim;
      patches_columns_above_re_s13_sim <= patches_columns_above_re_s12_sim;
      patches_columns_above_raddr_s13_sim <= patches_columns_above_raddr_s12_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s11_sim && patches_columns_above_raddr_s11_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s12_sim && patches_columns_above_raddr_s12_sim == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
      if (patches_columns_above_re_s13_sim && patches_columns_above_raddr_s13_sim == patches_columns_above_waddr) begin
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
    end else if (s14_en) begin
      chosen_near_q <= select_2587;
      patches_along_ends_q <= not_3072_s14_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3072_s14_q & select_3087;
      patches_down_by_q <= or_3048_s14_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3148});
      patches_along_q <= select_3153;
      patches_match_row_q <= or_3048_s14_q ? 4'h0 : select_3155;
      patches_summed_last_q <= not_1789_s14_q & (equal_1790_s14_q & and_3148);
      patches_read_first_q <= equal_1788_s14_q ? select_3541 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3587;
      patches_peak_best_column_q <= select_3588;
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
    if (s14_en) begin
      middle_sum_sum_sums_values_0_q <= slot_s14_q[0] ? middle_sum_sum_sums_values_0_q : sum_1012;
      sums_0_sum_sums_values_0_q <= sum_1262;
      sums_0_sum_sums_values_1_q <= equal_1260_s14_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1510;
      sums_1_sum_sums_values_1_q <= equal_1260_s14_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic moments_starts_s15_q;
  logic [5:0] run_shift_s15_q;
  logic [7:0] x_s15_q;
  logic age_s15_q;
  logic [2:0] slot_s15_q;
  logic ends_cell_s15_q;
  logic lower_half_s15_q;
  logic shift_not_right_s15_q;
  logic [4:0] patches_band_rows_number_s15_q;
  logic [4:0] patches_choosing_band_s15_q;
  logic patches_lower_s15_q;
  logic patches_second_s15_q;
  logic [4:0] patches_code_row_s15_q;
  logic [4:0] patches_column_s15_q;
  logic patches_match_row_ends_s15_q;
  logic [4:0] patches_down_by_s15_q;
  logic [4:0] patches_along_s15_q;
  logic [3:0] patches_match_row_s15_q;
  logic patches_summed_last_s15_q;
  logic [4:0] patches_step_s15_q;
  logic [9:0] patches_read_row_differing_s15_q;
  logic patches_read_first_s15_q;
  logic [3:0] select_508_s15_q;
  logic equal_509_s15_q;
  logic [6:0] select_511_s15_q;
  logic [8:0] select_515_s15_q;
  logic and_524_s15_q;
  logic and_525_s15_q;
  logic equal_530_s15_q;
  logic [6:0] last_s15_q;
  logic and_548_s15_q;
  logic and_550_s15_q;
  logic equal_570_s15_q;
  logic [12:0] select_574_s15_q;
  logic equal_575_s15_q;
  logic not_576_s15_q;
  logic so_s15_q;
  logic not_578_s15_q;
  logic equal_579_s15_q;
  logic or_580_s15_q;
  logic less_583_s15_q;
  logic not_584_s15_q;
  logic inside_v_s15_q;
  logic not_588_s15_q;
  logic and_591_s15_q;
  logic and_601_s15_q;
  logic and_609_s15_q;
  logic [6:0] x_s15_2_q;
  logic [45:0] best_left_rdata_s15_q;
  logic select_622_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic [9:0] sum_633_s15_q;
  logic and_640_s15_q;
  logic and_645_s15_q;
  logic and_647_s15_q;
  logic equal_680_s15_q;
  logic select_762_s15_q;
  logic [7:0] sum_1012_s15_q;
  logic less_1511_s15_q;
  logic [6:0] select_1549_s15_q;
  logic [7:0] select_1557_s15_q;
  logic [7:0] select_1560_s15_q;
  logic and_1562_s15_q;
  logic select_1564_s15_q;
  logic and_1573_s15_q;
  logic and_1575_s15_q;
  logic [6:0] select_1579_s15_q;
  logic or_1583_s15_q;
  logic and_1601_s15_q;
  logic right_2_s15_q;
  logic and_1676_s15_q;
  logic and_1689_s15_q;
  logic and_1702_s15_q;
  logic less_1703_s15_q;
  logic equal_1704_s15_q;
  logic sum_1713_s15_q;
  logic [9:0] sum_1717_s15_q;
  logic and_1736_s15_q;
  logic [5:0] select_1753_s15_q;
  logic [7:0] select_1779_s15_q;
  logic equal_1781_s15_q;
  logic and_1786_s15_q;
  logic and_1787_s15_q;
  logic equal_1788_s15_q;
  logic not_1789_s15_q;
  logic equal_1790_s15_q;
  logic not_1791_s15_q;
  logic equal_1792_s15_q;
  logic equal_1793_s15_q;
  logic or_1794_s15_q;
  logic [4:0] select_1818_s15_q;
  logic select_1824_s15_q;
  logic [3:0] select_1863_s15_q;
  logic [8:0] patches_columns_above_rdata_s15_q;
  logic [7:0] pixel_2_s15_q;
  logic [4:0] sum_1887_s15_q;
  logic [8:0] sum_1901_s15_q;
  logic [8:0] sum_1902_s15_q;
  logic [10:0] sum_1922_s15_q;
  logic less_1967_s15_q;
  logic equal_1968_s15_q;
  logic not_1969_s15_q;
  logic equal_1970_s15_q;
  logic not_1971_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic sum_1999_s15_q;
  logic and_2020_s15_q;
  logic [17:0] seen_columns_rdata_s15_q;
  logic and_2143_s15_q;
  logic equal_2284_s15_q;
  logic equal_2473_s15_q;
  logic and_2600_s15_q;
  logic equal_2685_s15_q;
  logic [7:0] lower_s15_q;
  logic [7:0] sum_2691_s15_q;
  logic [7:0] select_2769_s15_q;
  logic and_2997_s15_q;
  logic [4:0] select_3533_s15_q;
  logic equal_3551_s15_q;
  logic and_3554_s15_q;
  logic [14:0] select_3586_s15_q;
  logic less_3877_s15_q;
  logic equal_4096_s15_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s15_q <= pixel_0_s14_q;
      pixel_1_s15_q <= pixel_1_s14_q;
      saturated_s15_q <= saturated_s14_q;
      mask_s15_q <= mask_s14_q;
      marks_first_s15_q <= marks_first_s14_q;
      marks_last_s15_q <= marks_last_s14_q;
      sample_pair_whole_s15_q <= sample_pair_whole_s14_q;
      sample_present_s15_q <= sample_present_s14_q;
      moments_starts_s15_q <= moments_starts_s14_q;
      run_shift_s15_q <= run_shift_s14_q;
      x_s15_q <= x_s14_q;
      age_s15_q <= age_s14_q[1];
      slot_s15_q <= slot_s14_q;
      ends_cell_s15_q <= ends_cell_s14_q;
      lower_half_s15_q <= lower_half_s14_q;
      shift_not_right_s15_q <= shift_not_right_s14_q;
      patches_band_rows_number_s15_q <= patches_band_rows_number_s14_q;
      patches_choosing_band_s15_q <= patches_choosing_band_s14_q;
      patches_lower_s15_q <= patches_lower_s14_q;
      patches_second_s15_q <= patches_second_s14_q;
      patches_code_row_s15_q <= patches_code_row_s14_q;
      patches_column_s15_q <= patches_column_s14_q;
      patches_match_row_ends_s15_q <= patches_match_row_ends_q;
      patches_down_by_s15_q <= patches_down_by_q;
      patches_along_s15_q <= patches_along_q;
      patches_match_row_s15_q <= patches_match_row_q;
      patches_summed_last_s15_q <= patches_summed_last_q;
      patches_step_s15_q <= patches_step_s14_q;
      patches_read_row_differing_s15_q <= patches_read_row_differing_s14_q;
      patches_read_first_s15_q <= patches_read_first_q;
      select_508_s15_q <= select_508_s14_q;
      equal_509_s15_q <= equal_509_s14_q;
      select_511_s15_q <= select_511_s14_q;
      select_515_s15_q <= select_515_s14_q;
      and_524_s15_q <= and_524_s14_q;
      and_525_s15_q <= and_525;
      equal_530_s15_q <= equal_530_s14_q;
      last_s15_q <= last_s14_q;
      and_548_s15_q <= and_548_s14_q;
      and_550_s15_q <= and_550_s14_q;
      equal_570_s15_q <= equal_570_s14_q;
      select_574_s15_q <= first_s14_q ? 13'h0 : moments_place_q[12:0];
      equal_575_s15_q <= equal_575_s14_q;
      not_576_s15_q <= not_576_s14_q;
      so_s15_q <= so_s14_q;
      not_578_s15_q <= not_578_s14_q;
      equal_579_s15_q <= equal_579_s14_q;
      or_580_s15_q <= or_580_s14_q;
      less_583_s15_q <= less_583_s14_q;
      not_584_s15_q <= not_584_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      not_588_s15_q <= not_588;
      and_591_s15_q <= not_578_s14_q & (equal_579_s14_q & (inside_v_s14_q & not_588));
      and_601_s15_q <= and_601_s14_q;
      and_609_s15_q <= and_609_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q[45:0];
      select_622_s15_q <= select_622;
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      sum_633_s15_q <= {difference_632[8], difference_632} + 10'h1;
      and_640_s15_q <= and_640_s14_q;
      and_645_s15_q <= and_645_s14_q;
      and_647_s15_q <= and_647_s14_q;
      equal_680_s15_q <= equal_680_s14_q;
      select_762_s15_q <= select_762_s14_q;
      sum_1012_s15_q <= sum_1012;
      less_1511_s15_q <= sum_1262 < sum_1510;
      select_1549_s15_q <= select_1549;
      select_1557_s15_q <= select_762_s14_q ? 8'h0 : best_left_rdata_s14_q[53:46];
      select_1560_s15_q <= select_762_s14_q ? 8'h0 : best_left_rdata_s14_q[61:54];
      and_1562_s15_q <= and_1562_s14_q;
      select_1564_s15_q <= select_1564_s14_q;
      and_1573_s15_q <= and_1573_s14_q;
      and_1575_s15_q <= and_1575_s14_q;
      select_1579_s15_q <= select_1579;
      or_1583_s15_q <= or_1583_s14_q;
      and_1601_s15_q <= moments_taken_q;
      right_2_s15_q <= right_2_s14_q;
      and_1676_s15_q <= and_1676_s14_q;
      and_1689_s15_q <= and_1689_s14_q;
      and_1702_s15_q <= and_1702_s14_q;
      less_1703_s15_q <= less_1703_s14_q;
      equal_1704_s15_q <= equal_1704_s14_q;
      sum_1713_s15_q <= sum_1713[1];
      sum_1717_s15_q <= sum_1717;
      and_1736_s15_q <= and_1736_s14_q;
      select_1753_s15_q <= select_1753_s14_q;
      select_1779_s15_q <= select_1779_s14_q;
      equal_1781_s15_q <= equal_1781_s14_q;
      and_1786_s15_q <= and_1786_s14_q;
      and_1787_s15_q <= and_1787_s14_q;
      equal_1788_s15_q <= equal_1788_s14_q;
      not_1789_s15_q <= not_1789_s14_q;
      equal_1790_s15_q <= equal_1790_s14_q;
      not_1791_s15_q <= not_1791_s14_q;
      equal_1792_s15_q <= equal_1792_s14_q;
      equal_1793_s15_q <= equal_1793_s14_q;
      or_1794_s15_q <= or_1794_s14_q;
      select_1818_s15_q <= select_1818_s14_q;
      select_1824_s15_q <= select_1824_s14_q;
      select_1863_s15_q <= select_1863_s14_q;
      patches_columns_above_rdata_s15_q <= {patches_columns_above_rdata_s14_q[24], patches_columns_above_rdata_s14_q[7:0]};
      pixel_2_s15_q <= pixel_2_s14_q;
      sum_1887_s15_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1901_s15_q <= sum_1901;
      sum_1902_s15_q <= sum_1902;
      sum_1922_s15_q <= sum_1922;
      less_1967_s15_q <= less_1967_s14_q;
      equal_1968_s15_q <= equal_1968_s14_q;
      not_1969_s15_q <= not_1969_s14_q;
      equal_1970_s15_q <= equal_1970_s14_q;
      not_1971_s15_q <= not_1971_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      sum_1999_s15_q <= sum_1999_s14_q;
      and_2020_s15_q <= and_2020_s14_q;
      seen_columns_rdata_s15_q <= seen_columns_rdata_q;
      and_2143_s15_q <= and_2143_s14_q;
      equal_2284_s15_q <= equal_2284_s14_q;
      equal_2473_s15_q <= equal_2473_s14_q;
      and_2600_s15_q <= and_2600_s14_q;
      equal_2685_s15_q <= equal_2685_s14_q;
      lower_s15_q <= lower;
      sum_2691_s15_q <= {7'h0, rise_s14_q} + xor_2690_s14_q;
      select_2769_s15_q <= select_2769;
      and_2997_s15_q <= and_2997_s14_q;
      select_3533_s15_q <= select_3533;
      equal_3551_s15_q <= equal_3551_s14_q;
      and_3554_s15_q <= and_3554;
      select_3586_s15_q <= select_3586;
      less_3877_s15_q <= less_3877_s14_q;
      equal_4096_s15_q <= equal_4096_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
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
  logic [13:0] select_528;
  assign select_528 = equal_509_s15_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_534;
  assign sum_534 = {6'h0, sample_pair_pixel_1_q} + (equal_509_s15_q ? 14'h0 : averager_running_1_q);
  // hls/stages/agreement.hpp:788
  logic and_592;
  assign and_592 = not_576_s15_q & and_591_s15_q;
  // hls/stages/agreement.hpp:247
  logic and_635;
  assign and_635 = (and_609_s15_q & select_622_s15_q) & ({{22{sum_633_s15_q[9]}}, sum_633_s15_q} < 32'h3);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_1013;
  assign select_1013 = slot_s15_q[0] ? chosen_score_q : sum_1012_s15_q;
  // hls/stages/agreement.hpp:751
  logic [7:0] select_1512;
  assign select_1512 = less_1511_s15_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1513;
  assign less_1513 = select_1013 < select_1512;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1513 ? select_1512 : select_1013) : 8'h0;
  // hls/stages/agreement.hpp:720
  logic not_1519;
  assign not_1519 = ~slot_s15_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1520;
  assign select_1520 = less_1511_s15_q ? {slot_s15_q[0], not_1519} : 2'h0;
  logic [2:0] select_1522;
  assign select_1522 = less_1513 ? {select_1520, not_1519} : (slot_s15_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1549_s15_q : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1551;
  assign less_1551 = best_left_rdata_s15_q[39:33] < of_near;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s15_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:210
  logic equal_1622;
  assign equal_1622 = x_s15_q[5:0] == 6'h3c;
  logic equal_1624;
  assign equal_1624 = x_s15_q[5:0] == 6'h3b;
  logic equal_1626;
  assign equal_1626 = x_s15_q[5:0] == 6'h36;
  logic equal_1628;
  assign equal_1628 = x_s15_q[5:0] == 6'h35;
  logic equal_1630;
  assign equal_1630 = x_s15_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_1634;
  assign and_1634 = (~equal_1624) & ((~equal_1626) & ((~equal_1628) & (~equal_1630)));
  // hls/stages/patches.hpp:373
  logic [1:0] select_1690;
  assign select_1690 = and_1689_s15_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1691;
  assign select_1691 = and_1689_s15_q ? patches_band_rows_number_s15_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1692;
  assign select_1692 = and_1676_s15_q ? {select_1691, select_1690[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1693;
  assign select_1693 = and_1676_s15_q ? select_1690 : patches_fetch_q;
  logic equal_1694;
  assign equal_1694 = select_1693 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1704_s15_q ? {sum_1717_s15_q, sum_1713_s15_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1801;
  assign select_1801 = and_1676_s15_q ? select_1691 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_1802;
  assign equal_1802 = {patches_choosing_band_s15_q, and_1702_s15_q} == {select_1801, select_1693[1]};
  // hls/stages/patches.hpp:500
  logic less_1879;
  assign less_1879 = 5'he < patches_along_s15_q;
  // hls/stages/patches.hpp:501
  logic or_1880;
  assign or_1880 = equal_1792_s15_q | less_1879;
  // hls/stages/patches.hpp:504
  logic new_row;
  assign new_row = patches_along_s15_q == 5'h0;
  logic select_1885;
  assign select_1885 = equal_1792_s15_q ? patches_column_s15_q[0] : (or_1880 ? (patches_along_s15_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:502
  logic [4:0] select_1888;
  assign select_1888 = patches_match_row_ends_s15_q ? patches_down_by_s15_q : sum_1887_s15_q;
  // hls/stages/patches.hpp:505
  logic [4:0] select_1891;
  assign select_1891 = equal_1792_s15_q ? 5'h0 : (or_1880 ? (select_1888 + 5'h1) : sum_1887_s15_q);
  // hls/stages/patches.hpp:481
  logic equal_1894;
  assign equal_1894 = patches_column_s15_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s15_q == 5'h11;
  logic equal_1896;
  assign equal_1896 = patches_column_s15_q == 5'h18;
  // hls/stages/patches.hpp:483
  logic and_1898;
  assign and_1898 = of_row & (~equal_1896);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1894 ? 2'h3 : {equal_1896, and_1898};
  // hls/stages/patches.hpp:469
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1901_s15_q, pixel_2_s15_q[0]} - {1'b0, sum_1902_s15_q, patches_columns_above_rdata_s15_q[8]};
  // hls/stages/patches.hpp:467
  logic [9:0] sum_1923;
  assign sum_1923 = {2'h0, patches_columns_above_rdata_s15_q[7:0]} + sum_1922_s15_q[10:1];
  // hls/stages/patches.hpp:482
  logic or_1942;
  assign or_1942 = (((patches_column_s15_q == 5'ha) | of_row) | equal_1896) | equal_1894;
  // hls/stages/patches.hpp:477
  logic and_1947;
  assign and_1947 = (~(patches_code_row_s15_q[4:2] == 3'h0)) & (~(patches_column_s15_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:172
  logic and_1961;
  assign and_1961 = (~(equal_1793_s15_q | (~and_1947))) & (~patches_column_s15_q[4]);
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1986;
  assign select_1986 = so_s15_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1989;
  assign or_1989 = select_1986[7] | (~({select_1986[5], select_1986[3], select_1986[1]} == 3'h0));
  // hls/stages/agreement.hpp:1058
  logic or_2001;
  assign or_2001 = (~sum_1999_s15_q) | equal_1781_s15_q;
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s15_q & (or_580_s15_q & (not_584_s15_q & and_609_s15_q));
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2084;
  assign select_2084 = inside_v_s15_q ? (sum_1999_s15_q ? select_1986 : {select_1986[6:0], 1'b0}) : select_1986;
  // hls/stages/agreement.hpp:1050
  logic or_2087;
  assign or_2087 = select_2084[7] | (~({select_2084[5], select_2084[3], select_2084[1]} == 3'h0));
  // hls/stages/agreement.hpp:239
  logic [7:0] select_2582;
  assign select_2582 = slot_s15_q[0] ? 8'h0 : sum_1012_s15_q;
  // hls/stages/agreement.hpp:751
  logic less_2583;
  assign less_2583 = select_2582 < select_1512;
  // hls/stages/agreement.hpp:788
  logic less_2589;
  assign less_2589 = $signed(run_shift_s15_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2591;
  assign less_2591 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s15_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2689;
  assign difference_2689 = best_left_rdata_s15_q[16:9] - lower_s15_q;
  // hls/stages/agreement.hpp:788
  logic [10:0] select_2754;
  assign select_2754 = equal_575_s15_q ? registration_expected_q : (so_s15_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2769_s15_q[7]}}, select_2769_s15_q} - {sum_1717_s15_q[9], sum_1717_s15_q, sum_1713_s15_q};
  // hls/stages/patches.hpp:354
  logic not_3013;
  assign not_3013 = ~select_1693[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3015;
  assign select_3015 = sample_pair_whole_s15_q ? (equal_1694 ? select_1693 : {not_3013, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:184
  logic [4:0] select_3510;
  assign select_3510 = equal_1790_s15_q ? patches_down_by_s15_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:540
  logic [4:0] select_3555;
  assign select_3555 = and_3554_s15_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:547
  logic [5:0] away;
  assign away = {1'b0, patches_step_s15_q} - {1'b0, select_3555};
  // hls/stages/division.hpp:34
  logic [7:0] sum_3878;
  assign sum_3878 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3887;
  assign select_3887 = equal_575_s15_q ? select_1986 : (so_s15_q ? (ends_cell_s15_q ? select_2084 : select_1986) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3901;
  assign select_3901 = equal_680_s15_q ? {difference_3899[7], difference_3899} : (less_3877_s15_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3903;
  assign select_3903 = and_550_s15_q ? (equal_2473_s15_q ? select_3901 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3905;
  assign select_3905 = equal_680_s15_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3907;
  assign select_3907 = and_550_s15_q ? (equal_2473_s15_q ? select_3905 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3909;
  assign select_3909 = sum_3878[7] ? {1'b1, sum_3878[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory moments_memory, 8040 x 4, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 15, written in stage 16: 15 < 16 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:8039];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8040; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_574_s15_q;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s15_en & and_592;
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
    end else if (s15_en) begin
      sample_pair_pixel_0_q <= pixel_0_s15_q;
      sample_pair_pixel_1_q <= pixel_1_s15_q;
      chosen_score_q <= less_2583 ? select_1512 : select_2582;
      chosen_place_q <= less_2583 ? {select_1520, not_1519} : 3'h2;
      before_0_q <= select_2582;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2589) & (~less_2591);
      registration_expected_q <= select_2754;
      patches_band_q <= sample_pair_whole_s15_q ? select_1801 : patches_band_q;
      patches_fetch_q <= select_3015;
      patches_summed_down_by_q <= equal_1788_s15_q ? patches_summed_down_by_q : select_3510;
      patches_read_at_q <= equal_1788_s15_q ? select_3533_s15_q : patches_read_at_q;
      patches_peak_row_q <= equal_1788_s15_q ? select_3555 : patches_peak_row_q;
      region_columns_q <= select_3887;
      region_down_rest_q <= select_3903;
      region_down_back_q <= select_3907;
      region_down_next_q <= select_3909;
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
    if (s15_en) begin
      averager_running_0_q <= sample_pair_whole_s15_q ? select_528 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s15_q ? sum_534 : averager_running_1_q;
    end
  end

  logic saturated_s16_q;
  logic mask_s16_q;
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
  logic [7:0] before_0_s16_q;
  logic [7:0] before_1_s16_q;
  logic [7:0] before_2_s16_q;
  logic shift_not_right_s16_q;
  logic [4:0] patches_choosing_band_s16_q;
  logic patches_lower_s16_q;
  logic patches_second_s16_q;
  logic [4:0] patches_code_row_s16_q;
  logic [4:0] patches_along_s16_q;
  logic [3:0] patches_match_row_s16_q;
  logic patches_summed_last_s16_q;
  logic [4:0] patches_summed_down_by_s16_q;
  logic [9:0] patches_read_row_differing_s16_q;
  logic patches_read_first_s16_q;
  logic [3:0] select_508_s16_q;
  logic equal_509_s16_q;
  logic [6:0] select_511_s16_q;
  logic [8:0] select_515_s16_q;
  logic and_524_s16_q;
  logic and_525_s16_q;
  logic [29:0] averager_memory_rdata_s16_q;
  logic [13:0] select_528_s16_q;
  logic equal_530_s16_q;
  logic [13:0] sum_534_s16_q;
  logic [6:0] last_s16_q;
  logic and_548_s16_q;
  logic and_550_s16_q;
  logic equal_570_s16_q;
  logic [12:0] select_574_s16_q;
  logic equal_575_s16_q;
  logic not_576_s16_q;
  logic so_s16_q;
  logic not_578_s16_q;
  logic equal_579_s16_q;
  logic or_580_s16_q;
  logic less_583_s16_q;
  logic not_584_s16_q;
  logic inside_v_s16_q;
  logic not_588_s16_q;
  logic and_592_s16_q;
  logic and_601_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [6:0] right_s16_q;
  logic [28:0] best_right_rdata_s16_q;
  logic and_635_s16_q;
  logic and_640_s16_q;
  logic and_645_s16_q;
  logic and_647_s16_q;
  logic equal_680_s16_q;
  logic select_762_s16_q;
  logic [7:0] of_best_s16_q;
  logic [2:0] select_1522_s16_q;
  logic [6:0] of_near_s16_q;
  logic [6:0] select_1552_s16_q;
  logic [5:0] select_1554_s16_q;
  logic [7:0] select_1557_s16_q;
  logic [7:0] select_1560_s16_q;
  logic and_1562_s16_q;
  logic select_1564_s16_q;
  logic or_1570_s16_q;
  logic and_1573_s16_q;
  logic and_1575_s16_q;
  logic [1:0] shown_right_rdata_s16_q;
  logic [6:0] select_1579_s16_q;
  logic and_1584_s16_q;
  logic [1:0] left_turns_rdata_s16_q;
  logic and_1601_s16_q;
  logic [1:0] right_turns_rdata_s16_q;
  logic equal_1608_s16_q;
  logic all_s16_q;
  logic equal_1622_s16_q;
  logic equal_1624_s16_q;
  logic equal_1626_s16_q;
  logic equal_1628_s16_q;
  logic equal_1630_s16_q;
  logic and_1635_s16_q;
  logic right_2_s16_q;
  logic and_1676_s16_q;
  logic [5:0] select_1692_s16_q;
  logic select_1693_s16_q;
  logic equal_1694_s16_q;
  logic and_1702_s16_q;
  logic less_1703_s16_q;
  logic equal_1704_s16_q;
  logic expected_s16_q;
  logic [10:0] sum_1719_s16_q;
  logic and_1736_s16_q;
  logic [5:0] select_1753_s16_q;
  logic [7:0] select_1779_s16_q;
  logic and_1786_s16_q;
  logic and_1787_s16_q;
  logic equal_1788_s16_q;
  logic not_1789_s16_q;
  logic equal_1790_s16_q;
  logic not_1791_s16_q;
  logic equal_1793_s16_q;
  logic or_1794_s16_q;
  logic and_1803_s16_q;
  logic [4:0] select_1818_s16_q;
  logic select_1824_s16_q;
  logic [3:0] select_1863_s16_q;
  logic patches_columns_above_rdata_s16_q;
  logic [7:0] pixel_2_s16_q;
  logic less_1879_s16_q;
  logic new_row_s16_q;
  logic select_1885_s16_q;
  logic not_1886_s16_q;
  logic [4:0] select_1891_s16_q;
  logic or_1892_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic [10:0] down_2_s16_q;
  logic sum_1922_s16_q;
  logic [9:0] sum_1923_s16_q;
  logic and_1950_s16_q;
  logic and_1961_s16_q;
  logic and_1964_s16_q;
  logic less_1967_s16_q;
  logic equal_1968_s16_q;
  logic not_1969_s16_q;
  logic equal_1970_s16_q;
  logic not_1971_s16_q;
  logic [9:0] patches_rows_rdata_s16_q;
  logic or_1989_s16_q;
  logic or_1992_s16_q;
  logic or_1995_s16_q;
  logic and_2004_s16_q;
  logic textured_s16_q;
  logic and_2020_s16_q;
  logic [12:0] seen_columns_rdata_s16_q;
  logic and_2070_s16_q;
  logic and_2072_s16_q;
  logic or_2087_s16_q;
  logic or_2090_s16_q;
  logic or_2093_s16_q;
  logic and_2104_s16_q;
  logic and_2120_s16_q;
  logic and_2143_s16_q;
  logic equal_2284_s16_q;
  logic equal_2473_s16_q;
  logic and_2600_s16_q;
  logic and_2624_s16_q;
  logic equal_2685_s16_q;
  logic [5:0] difference_2689_s16_q;
  logic [7:0] sum_2691_s16_q;
  logic [11:0] select_2772_s16_q;
  logic and_2997_s16_q;
  logic less_3124_s16_q;
  logic equal_3551_s16_q;
  logic [4:0] select_3555_s16_q;
  logic [5:0] away_s16_q;
  logic equal_3557_s16_q;
  logic equal_3566_s16_q;
  logic [14:0] select_3586_s16_q;
  logic less_3877_s16_q;
  logic sum_3878_s16_q;
  logic select_3920_s16_q;
  logic equal_3931_s16_q;
  logic equal_3970_s16_q;
  logic and_4086_s16_q;
  logic equal_4096_s16_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s16_q <= saturated_s15_q;
      mask_s16_q <= mask_s15_q;
      marks_first_s16_q <= marks_first_s15_q;
      marks_last_s16_q <= marks_last_s15_q;
      sample_pair_pixel_0_s16_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s16_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s16_q <= sample_pair_whole_s15_q;
      sample_present_s16_q <= sample_present_s15_q;
      moments_starts_s16_q <= moments_starts_s15_q;
      run_shift_s16_q <= run_shift_s15_q;
      x_s16_q <= x_s15_q;
      age_s16_q <= age_s15_q;
      slot_s16_q <= slot_s15_q;
      ends_cell_s16_q <= ends_cell_s15_q;
      lower_half_s16_q <= lower_half_s15_q;
      before_0_s16_q <= before_0_q;
      before_1_s16_q <= before_1_q;
      before_2_s16_q <= before_2_q;
      shift_not_right_s16_q <= shift_not_right_s15_q;
      patches_choosing_band_s16_q <= patches_choosing_band_s15_q;
      patches_lower_s16_q <= patches_lower_s15_q;
      patches_second_s16_q <= patches_second_s15_q;
      patches_code_row_s16_q <= patches_code_row_s15_q;
      patches_along_s16_q <= patches_along_s15_q;
      patches_match_row_s16_q <= patches_match_row_s15_q;
      patches_summed_last_s16_q <= patches_summed_last_s15_q;
      patches_summed_down_by_s16_q <= patches_summed_down_by_q;
      patches_read_row_differing_s16_q <= patches_read_row_differing_s15_q;
      patches_read_first_s16_q <= patches_read_first_s15_q;
      select_508_s16_q <= select_508_s15_q;
      equal_509_s16_q <= equal_509_s15_q;
      select_511_s16_q <= select_511_s15_q;
      select_515_s16_q <= select_515_s15_q;
      and_524_s16_q <= and_524_s15_q;
      and_525_s16_q <= and_525_s15_q;
      averager_memory_rdata_s16_q <= averager_memory_rdata_q;
      select_528_s16_q <= select_528;
      equal_530_s16_q <= equal_530_s15_q;
      sum_534_s16_q <= sum_534;
      last_s16_q <= last_s15_q;
      and_548_s16_q <= and_548_s15_q;
      and_550_s16_q <= and_550_s15_q;
      equal_570_s16_q <= equal_570_s15_q;
      select_574_s16_q <= select_574_s15_q;
      equal_575_s16_q <= equal_575_s15_q;
      not_576_s16_q <= not_576_s15_q;
      so_s16_q <= so_s15_q;
      not_578_s16_q <= not_578_s15_q;
      equal_579_s16_q <= equal_579_s15_q;
      or_580_s16_q <= or_580_s15_q;
      less_583_s16_q <= less_583_s15_q;
      not_584_s16_q <= not_584_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      not_588_s16_q <= not_588_s15_q;
      and_592_s16_q <= and_592;
      and_601_s16_q <= and_601_s15_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q[32:0];
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q;
      and_635_s16_q <= and_635;
      and_640_s16_q <= and_640_s15_q;
      and_645_s16_q <= and_645_s15_q;
      and_647_s16_q <= and_647_s15_q;
      equal_680_s16_q <= equal_680_s15_q;
      select_762_s16_q <= select_762_s15_q;
      of_best_s16_q <= of_best;
      select_1522_s16_q <= select_1522;
      of_near_s16_q <= of_near;
      select_1552_s16_q <= less_1551 ? of_near : best_left_rdata_s15_q[39:33];
      select_1554_s16_q <= less_1551 ? run_shift_s15_q : best_left_rdata_s15_q[45:40];
      select_1557_s16_q <= select_1557_s15_q;
      select_1560_s16_q <= select_1560_s15_q;
      and_1562_s16_q <= and_1562_s15_q;
      select_1564_s16_q <= select_1564_s15_q;
      or_1570_s16_q <= select_1564_s15_q | (best_right_rdata_s15_q[21:15] < of_near);
      and_1573_s16_q <= and_1573_s15_q;
      and_1575_s16_q <= and_1575_s15_q;
      shown_right_rdata_s16_q <= shown_right_rdata_q;
      select_1579_s16_q <= select_1579_s15_q;
      and_1584_s16_q <= and_635 & or_1583_s15_q;
      left_turns_rdata_s16_q <= left_turns_rdata_q;
      and_1601_s16_q <= and_1601_s15_q;
      right_turns_rdata_s16_q <= right_turns_rdata_q;
      equal_1608_s16_q <= x_s15_q[6:4] == 3'h7;
      all_s16_q <= all;
      equal_1622_s16_q <= equal_1622;
      equal_1624_s16_q <= equal_1624;
      equal_1626_s16_q <= equal_1626;
      equal_1628_s16_q <= equal_1628;
      equal_1630_s16_q <= equal_1630;
      and_1635_s16_q <= (~equal_1622) & and_1634;
      right_2_s16_q <= right_2_s15_q;
      and_1676_s16_q <= and_1676_s15_q;
      select_1692_s16_q <= select_1692;
      select_1693_s16_q <= select_1693[1];
      equal_1694_s16_q <= equal_1694;
      and_1702_s16_q <= and_1702_s15_q;
      less_1703_s16_q <= less_1703_s15_q;
      equal_1704_s16_q <= equal_1704_s15_q;
      expected_s16_q <= expected[0];
      sum_1719_s16_q <= {expected[10], expected[10:1]} + 11'h5;
      and_1736_s16_q <= and_1736_s15_q;
      select_1753_s16_q <= select_1753_s15_q;
      select_1779_s16_q <= select_1779_s15_q;
      and_1786_s16_q <= and_1786_s15_q;
      and_1787_s16_q <= and_1787_s15_q;
      equal_1788_s16_q <= equal_1788_s15_q;
      not_1789_s16_q <= not_1789_s15_q;
      equal_1790_s16_q <= equal_1790_s15_q;
      not_1791_s16_q <= not_1791_s15_q;
      equal_1793_s16_q <= equal_1793_s15_q;
      or_1794_s16_q <= or_1794_s15_q;
      and_1803_s16_q <= and_1787_s15_q & equal_1802;
      select_1818_s16_q <= select_1818_s15_q;
      select_1824_s16_q <= select_1824_s15_q;
      select_1863_s16_q <= select_1863_s15_q;
      patches_columns_above_rdata_s16_q <= patches_columns_above_rdata_s15_q[8];
      pixel_2_s16_q <= pixel_2_s15_q;
      less_1879_s16_q <= less_1879;
      new_row_s16_q <= new_row;
      select_1885_s16_q <= select_1885;
      not_1886_s16_q <= ~or_1880;
      select_1891_s16_q <= select_1891;
      or_1892_s16_q <= equal_1792_s15_q | equal_1790_s15_q;
      of_row_2_s16_q <= of_row_2;
      down_2_s16_q <= down_2;
      sum_1922_s16_q <= sum_1922_s15_q[0];
      sum_1923_s16_q <= sum_1923;
      and_1950_s16_q <= or_1794_s15_q & (or_1942 & (equal_1793_s15_q & and_1947));
      and_1961_s16_q <= and_1961;
      and_1964_s16_q <= or_1794_s15_q & (and_1961 & (patches_column_s15_q == 5'hf));
      less_1967_s16_q <= less_1967_s15_q;
      equal_1968_s16_q <= equal_1968_s15_q;
      not_1969_s16_q <= not_1969_s15_q;
      equal_1970_s16_q <= equal_1970_s15_q;
      not_1971_s16_q <= not_1971_s15_q;
      patches_rows_rdata_s16_q <= patches_rows_rdata_s15_q;
      or_1989_s16_q <= or_1989;
      or_1992_s16_q <= select_1986[7] | (~({select_1986[6], select_1986[3:2]} == 3'h0));
      or_1995_s16_q <= select_1986[7] | (~(select_1986[6:4] == 3'h0));
      and_2004_s16_q <= so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & or_2001));
      textured_s16_q <= textured;
      and_2020_s16_q <= and_2020_s15_q;
      seen_columns_rdata_s16_q <= {seen_columns_rdata_s15_q[13:7], seen_columns_rdata_s15_q[5:0]};
      and_2070_s16_q <= seen_columns_rdata_s15_q[14] & inside_v_s15_q;
      and_2072_s16_q <= seen_columns_rdata_s15_q[5] & inside_v_s15_q;
      or_2087_s16_q <= or_2087;
      or_2090_s16_q <= select_2084[7] | (~({select_2084[6], select_2084[3:2]} == 3'h0));
      or_2093_s16_q <= select_2084[7] | (~(select_2084[6:4] == 3'h0));
      and_2104_s16_q <= seen_columns_rdata_s15_q[16] & inside_v_s15_q;
      and_2120_s16_q <= seen_columns_rdata_s15_q[17] & inside_v_s15_q;
      and_2143_s16_q <= and_2143_s15_q;
      equal_2284_s16_q <= equal_2284_s15_q;
      equal_2473_s16_q <= equal_2473_s15_q;
      and_2600_s16_q <= and_2600_s15_q;
      and_2624_s16_q <= seen_columns_rdata_s15_q[15] & inside_v_s15_q;
      equal_2685_s16_q <= equal_2685_s15_q;
      difference_2689_s16_q <= difference_2689[7:2];
      sum_2691_s16_q <= sum_2691_s15_q;
      select_2772_s16_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_2997_s16_q <= and_2997_s15_q;
      less_3124_s16_q <= 4'he < patches_column_s15_q[4:1];
      equal_3551_s16_q <= equal_3551_s15_q;
      select_3555_s16_q <= select_3555;
      away_s16_q <= away;
      equal_3557_s16_q <= away == 6'h3f;
      equal_3566_s16_q <= away == 6'h1;
      select_3586_s16_q <= select_3586_s15_q;
      less_3877_s16_q <= less_3877_s15_q;
      sum_3878_s16_q <= sum_3878[7];
      select_3920_s16_q <= sum_1999_s15_q ? (equal_1781_s15_q & or_2001) : or_2001;
      equal_3931_s16_q <= x_s15_q[6:3] == 4'h7;
      equal_3970_s16_q <= x_s15_q[6:3] == 4'h6;
      and_4086_s16_q <= seen_columns_rdata_s15_q[6] & inside_v_s15_q;
      equal_4096_s16_q <= equal_4096_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:126
  logic [13:0] sum_532;
  assign sum_532 = select_528_s16_q + (equal_530_s16_q ? 14'h0 : averager_memory_rdata_s16_q[13:0]);
  logic [13:0] sum_536;
  assign sum_536 = sum_534_s16_q + (equal_530_s16_q ? 14'h0 : averager_memory_rdata_s16_q[27:14]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = equal_509_s16_q ? sample_present_s16_q : (sample_present_s16_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_509_s16_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:128
  logic and_544;
  assign and_544 = all_of_skin & (averager_memory_rdata_s16_q[29] | equal_530_s16_q);
  // hls/stages/agreement.hpp:149
  logic and_637;
  assign and_637 = or_580_s16_q & (not_584_s16_q & and_635_s16_q);
  // hls/stages/moments.hpp:77
  logic and_638;
  assign and_638 = and_601_s16_q & and_637;
  // hls/stages/agreement.hpp:810
  logic equal_1525;
  assign equal_1525 = select_1522_s16_q == 3'h1;
  logic or_1528;
  assign or_1528 = equal_1525 | (~(select_1522_s16_q == 3'h2));
  logic [7:0] select_1530;
  assign select_1530 = or_1528 ? before_0_s16_q : before_1_s16_q;
  logic [7:0] select_1531;
  assign select_1531 = equal_1525 ? (or_1528 ? before_1_q : {7'h0, shift_not_right_s16_q}) : select_1530;
  // hls/stages/agreement.hpp:811
  logic [7:0] select_1534;
  assign select_1534 = equal_1525 ? select_1530 : (or_1528 ? before_2_q : before_2_s16_q);
  // hls/stages/agreement.hpp:824
  logic or_1566;
  assign or_1566 = select_1564_s16_q | (best_right_rdata_s16_q[7:0] < of_best_s16_q);
  // hls/stages/agreement.hpp:149
  logic and_1586;
  assign and_1586 = or_580_s16_q & (not_584_s16_q & and_1584_s16_q);
  // hls/stages/agreement.hpp:788
  logic and_1590;
  assign and_1590 = not_576_s16_q & (so_s16_q ? and_1573_s16_q : (equal_579_s16_q & and_637));
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s16_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1611;
  assign select_1611 = x_s16_q[4] ? {x_s16_q[3], x_s16_q[0]} : {x_s16_q[0], x_s16_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1613;
  assign select_1613 = equal_1608_s16_q ? {2'h0, quarter} : (all_s16_q ? {1'b0, x_s16_q[2:0]} : {x_s16_q[2:1], select_1611});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1614;
  assign sum_1614 = slot_s16_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1615;
  assign select_1615 = equal_575_s16_q ? select_1613 : {sum_1614, lower_half_s16_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1616;
  assign equal_1616 = x_s16_q[5:0] == 6'h3f;
  logic equal_1618;
  assign equal_1618 = x_s16_q[5:0] == 6'h3e;
  logic equal_1620;
  assign equal_1620 = x_s16_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1178
  logic and_1638;
  assign and_1638 = (~equal_1616) & ((~equal_1618) & ((~equal_1620) & and_1635_s16_q));
  // hls/stages/agreement.hpp:1129
  logic less_1639;
  assign less_1639 = x_s16_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s16_q ? {1'b0, x_s16_q[2]} : x_s16_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1643;
  assign or_1643 = (kind == 2'h3) | (x_s16_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s16_q ? (right_2_s16_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1654;
  assign sum_1654 = {2'h0, slot_s16_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1660;
  assign not_1660 = ~lower_half_s16_q;
  logic [3:0] select_1661;
  assign select_1661 = registration_of_right_q ? {lower_half_s16_q, 1'b0, not_1660, 1'b0} : {1'b0, lower_half_s16_q, 1'b0, not_1660};
  // hls/stages/patches.hpp:98
  logic less_1720;
  assign less_1720 = {{4{sum_1719_s16_q[10]}}, sum_1719_s16_q, expected_s16_q} < 16'h15;
  // hls/stages/patches.hpp:471
  logic [11:0] sum_1904;
  assign sum_1904 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1905;
  assign sum_1905 = {{4{down_2_s16_q[10]}}, down_2_s16_q[10:2]} + {sum_1904[11], sum_1904};
  // hls/stages/patches.hpp:468
  logic [11:0] smooth;
  assign smooth = {sum_1923_s16_q, sum_1922_s16_q, patches_columns_above_rdata_s16_q} + {4'h0, pixel_2_s16_q};
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1996;
  assign select_1996 = equal_575_s16_q ? x_s16_q[5:0] : {region_row_q, or_1995_s16_q, or_1992_s16_q, or_1989_s16_q};
  // hls/stages/agreement.hpp:1128
  logic not_1997;
  assign not_1997 = ~equal_1608_s16_q;
  // hls/stages/agreement.hpp:149
  logic and_2022;
  assign and_2022 = or_580_s16_q & (not_584_s16_q & and_2020_s16_q);
  // hls/stages/agreement.hpp:1014
  logic select_2032;
  assign select_2032 = slot_s16_q[2] ? shown_shown_q : and_637;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s16_q & (shown_right_rdata_s16_q[0] | select_2032);
  // hls/stages/agreement.hpp:1014
  logic select_2035;
  assign select_2035 = slot_s16_q[2] ? shown_nearer_q : and_1586;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s16_q & (select_2032 ? select_2035 : shown_right_rdata_s16_q[1]);
  // hls/stages/agreement.hpp:276
  logic select_2197;
  assign select_2197 = sample_pair_whole_s16_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:788
  logic and_2604;
  assign and_2604 = not_576_s16_q & (so_s16_q & (ends_cell_s16_q & (inside_v_s16_q & and_2600_s16_q)));
  // hls/stages/agreement.hpp:1105
  logic not_2623;
  assign not_2623 = ~(x_s16_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:788
  logic and_2665;
  assign and_2665 = so_s16_q & (ends_cell_s16_q & (inside_v_s16_q & (and_2600_s16_q & and_2022)));
  // hls/stages/agreement.hpp:1110
  logic and_2670;
  assign and_2670 = not_2623 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:247
  logic and_2694;
  assign and_2694 = ((and_2020_s16_q & and_635_s16_q) & equal_2685_s16_q) & (~({2'h0, difference_2689_s16_q} < sum_2691_s16_q));
  // hls/stages/agreement.hpp:149
  logic and_2704;
  assign and_2704 = not_584_s16_q & (slot_s16_q[2] & left_turns_rdata_s16_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2706;
  assign and_2706 = not_584_s16_q & (slot_s16_q[2] & left_turns_rdata_s16_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2707;
  assign select_2707 = or_580_s16_q ? {and_2706, and_2704} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2709;
  assign select_2709 = less_583_s16_q ? 2'h0 : (slot_s16_q[2] ? right_turns_rdata_s16_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2710;
  assign select_2710 = or_580_s16_q ? select_2709 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2755;
  assign equal_2755 = slot_s16_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2772_s16_q[11:7])) ? 12'h7f : select_2772_s16_q;
  // hls/stages/agreement.hpp:788
  logic select_2816;
  assign select_2816 = so_s16_q ? (equal_2755 ? right_2_s16_q : registration_of_right_q) : registration_of_right_q;
  logic select_2819;
  assign select_2819 = so_s16_q ? (equal_1704_s16_q ? inside_v_s16_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all_s16_q ? x_s16_q[1:0] : select_1611;
  // hls/stages/patches.hpp:184
  logic [10:0] select_3102;
  assign select_3102 = equal_1790_s16_q ? patches_down_values_0_q : (or_1794_s16_q ? down_2_s16_q : patches_down_values_0_q);
  logic [10:0] select_3104;
  assign select_3104 = or_1794_s16_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3106;
  assign select_3106 = equal_1788_s16_q ? patches_down_values_1_q : (equal_1790_s16_q ? patches_down_values_1_q : select_3104);
  // hls/stages/patches.hpp:556
  logic and_3559;
  assign and_3559 = less_1967_s16_q & (equal_3551_s16_q & equal_3557_s16_q);
  // hls/stages/patches.hpp:560
  logic select_3562;
  assign select_3562 = equal_1970_s16_q ? (less_1967_s16_q ? (not_1971_s16_q & and_3559) : and_3559) : and_3559;
  // hls/stages/patches.hpp:556
  logic and_3568;
  assign and_3568 = less_1967_s16_q & (equal_3551_s16_q & equal_3566_s16_q);
  // hls/stages/patches.hpp:560
  logic select_3571;
  assign select_3571 = equal_1970_s16_q ? (less_1967_s16_q ? (not_1971_s16_q & and_3568) : and_3568) : and_3568;
  // hls/stages/patches.hpp:553
  logic [6:0] sum_3575;
  assign sum_3575 = {away_s16_q[5], away_s16_q} + 7'h7d;
  // hls/stages/agreement.hpp:788
  logic select_3874;
  assign select_3874 = equal_575_s16_q ? shown_shown_q : (so_s16_q ? select_2032 : shown_shown_q);
  logic select_3876;
  assign select_3876 = equal_575_s16_q ? shown_nearer_q : (so_s16_q ? select_2035 : shown_nearer_q);
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3880;
  assign select_3880 = less_3877_s16_q ? (sum_3878_s16_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3882;
  assign select_3882 = equal_2473_s16_q ? (equal_680_s16_q ? 3'h0 : select_3880) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3878_s16_q;
  // hls/stages/agreement.hpp:460
  logic select_3913;
  assign select_3913 = equal_2473_s16_q ? (equal_680_s16_q | (less_3877_s16_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3918;
  assign or_3918 = segment_starts_q | not_578_s16_q;
  // hls/stages/agreement.hpp:788
  logic select_3922;
  assign select_3922 = ends_cell_s16_q ? (inside_v_s16_q ? select_3920_s16_q : or_3918) : or_3918;
  // hls/stages/agreement.hpp:1217
  logic equal_3951;
  assign equal_3951 = x_s16_q[6:3] == 4'ha;
  logic equal_3955;
  assign equal_3955 = x_s16_q[6:3] == 4'h9;
  logic equal_3956;
  assign equal_3956 = x_s16_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3972;
  assign select_3972 = equal_3931_s16_q ? cfg_unproven_limit_i : (equal_3970_s16_q ? cfg_explained_limit_i : cfg_regions_limit_i);
  logic [7:0] select_3974;
  assign select_3974 = equal_3955 ? cfg_hidden_limit_i : (equal_3956 ? cfg_unproven_skin_limit_i : select_3972);
  // hls/stages/agreement.hpp:788
  logic select_4084;
  assign select_4084 = so_s16_q ? (ends_cell_s16_q ? and_2072_s16_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4088;
  assign select_4088 = so_s16_q ? (ends_cell_s16_q ? and_4086_s16_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4090;
  assign select_4090 = ends_cell_s16_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4092;
  assign select_4092 = equal_575_s16_q ? centres_values_1_textured_q : (so_s16_q ? select_4090 : centres_values_1_textured_q);
  logic select_4093;
  assign select_4093 = ends_cell_s16_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4095;
  assign select_4095 = equal_575_s16_q ? centres_values_1_of_skin_q : (so_s16_q ? select_4093 : centres_values_1_of_skin_q);

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:349; read in stage 16, written in stage 18: 16 < 18 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = last_s16_q;
`ifndef SYNTHESIS
  logic census_memory_re;
  assign census_memory_re = s16_en & and_550_s16_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:767; read in stage 16, written in stage 18: 16 < 18 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1692_s16_q;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s16_en & (sample_pair_whole_s16_q & (~equal_1694_s16_q));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:796; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1891_s16_q, not_1886_s16_q, select_1885_s16_q};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s16_en & or_1892_s16_q;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:797; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_s16_q;
`ifndef SYNTHESIS
  logic patches_left_codes_re;
  assign patches_left_codes_re = s16_en & (not_1789_s16_q & (new_row_s16_q & equal_1790_s16_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1398; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1996;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s16_en & (equal_575_s16_q ? (x_s16_q[6] & not_1997) : and_2004_s16_q);
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory moments_memory, write
  logic [12:0] moments_memory_waddr;
  assign moments_memory_waddr = select_574_s16_q;
  logic moments_memory_we;
  assign moments_memory_we = s16_en & and_592_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_647_s16_q, and_645_s16_q, and_640_s16_q, and_638};
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
    end else if (s16_en) begin
      sample_of_skin_q <= mask_s16_q;
      averager_running_mask_q <= sample_pair_whole_s16_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2197;
      registration_of_right_q <= equal_575_s16_q ? registration_of_right_q : select_2816;
      registration_was_inside_q <= equal_575_s16_q ? registration_was_inside_q : select_2819;
      patches_down_values_0_q <= equal_1788_s16_q ? patches_down_values_0_q : select_3102;
      patches_down_values_1_q <= select_3106;
      shown_shown_q <= select_3874;
      shown_nearer_q <= select_3876;
      region_row_q <= and_550_s16_q ? select_3882 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_550_s16_q ? select_3913 : region_fresh_q;
      segment_starts_q <= equal_575_s16_q ? or_3918 : (so_s16_q ? select_3922 : or_3918);
      centres_values_0_textured_q <= equal_575_s16_q ? centres_values_0_textured_q : select_4084;
      centres_values_0_of_skin_q <= equal_575_s16_q ? centres_values_0_of_skin_q : select_4088;
      centres_values_1_textured_q <= select_4092;
      centres_values_1_of_skin_q <= select_4095;
    end
  end

  logic [7:0] pixel_0_s17_q;
  logic [7:0] pixel_1_s17_q;
  logic saturated_s17_q;
  logic marks_first_s17_q;
  logic marks_last_s17_q;
  logic [7:0] sample_pair_pixel_0_s17_q;
  logic [7:0] sample_pair_pixel_1_s17_q;
  logic sample_pair_whole_s17_q;
  logic sample_present_s17_q;
  logic moments_starts_s17_q;
  logic [5:0] run_shift_s17_q;
  logic [7:0] x_s17_q;
  logic age_s17_q;
  logic [2:0] slot_s17_q;
  logic ends_cell_s17_q;
  logic lower_half_s17_q;
  logic registration_of_right_s17_q;
  logic [4:0] patches_choosing_band_s17_q;
  logic patches_lower_s17_q;
  logic patches_second_s17_q;
  logic [4:0] patches_code_row_s17_q;
  logic [10:0] patches_down_values_1_s17_q;
  logic [4:0] patches_along_s17_q;
  logic patches_summed_last_s17_q;
  logic [4:0] patches_summed_down_by_s17_q;
  logic [9:0] patches_read_row_differing_s17_q;
  logic patches_read_first_s17_q;
  logic [2:0] region_row_s17_q;
  logic region_fresh_s17_q;
  logic centres_values_1_textured_s17_q;
  logic centres_values_1_of_skin_s17_q;
  logic [3:0] select_508_s17_q;
  logic [6:0] select_511_s17_q;
  logic [8:0] select_515_s17_q;
  logic and_524_s17_q;
  logic and_525_s17_q;
  logic [13:0] sum_532_s17_q;
  logic [13:0] sum_536_s17_q;
  logic and_540_s17_q;
  logic and_544_s17_q;
  logic [6:0] last_s17_q;
  logic and_548_s17_q;
  logic and_550_s17_q;
  logic equal_553_s17_q;
  logic equal_570_s17_q;
  logic equal_575_s17_q;
  logic not_576_s17_q;
  logic so_s17_q;
  logic not_578_s17_q;
  logic equal_579_s17_q;
  logic inside_v_s17_q;
  logic not_588_s17_q;
  logic [3:0] moments_memory_rdata_s17_q;
  logic [6:0] x_s17_2_q;
  logic [32:0] best_left_rdata_s17_q;
  logic [6:0] right_s17_q;
  logic [14:0] best_right_rdata_s17_q;
  logic and_637_s17_q;
  logic and_640_s17_q;
  logic and_647_s17_q;
  logic equal_680_s17_q;
  logic [7:0] of_best_s17_q;
  logic or_1517_s17_q;
  logic [2:0] select_1522_s17_q;
  logic [7:0] select_1531_s17_q;
  logic [7:0] select_1534_s17_q;
  logic [6:0] select_1553_s17_q;
  logic [5:0] select_1555_s17_q;
  logic [7:0] select_1558_s17_q;
  logic [7:0] select_1561_s17_q;
  logic and_1562_s17_q;
  logic or_1566_s17_q;
  logic [6:0] select_1571_s17_q;
  logic [6:0] select_1572_s17_q;
  logic and_1575_s17_q;
  logic [6:0] select_1579_s17_q;
  logic and_1586_s17_q;
  logic and_1590_s17_q;
  logic and_1601_s17_q;
  logic equal_1608_s17_q;
  logic [1:0] quarter_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1614_s17_q;
  logic [3:0] select_1615_s17_q;
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
  logic select_1646_s17_q;
  logic and_1656_s17_q;
  logic [3:0] select_1661_s17_q;
  logic and_1676_s17_q;
  logic select_1693_s17_q;
  logic equal_1694_s17_q;
  logic and_1702_s17_q;
  logic equal_1704_s17_q;
  logic and_1737_s17_q;
  logic [5:0] select_1753_s17_q;
  logic [7:0] select_1779_s17_q;
  logic and_1786_s17_q;
  logic and_1787_s17_q;
  logic equal_1788_s17_q;
  logic equal_1790_s17_q;
  logic equal_1793_s17_q;
  logic or_1794_s17_q;
  logic and_1803_s17_q;
  logic [4:0] select_1818_s17_q;
  logic select_1824_s17_q;
  logic [3:0] select_1863_s17_q;
  logic less_1879_s17_q;
  logic new_row_s17_q;
  logic or_1892_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic [1:0] down_2_s17_q;
  logic [12:0] sum_1905_s17_q;
  logic [11:0] smooth_s17_q;
  logic and_1952_s17_q;
  logic and_1961_s17_q;
  logic and_1966_s17_q;
  logic less_1967_s17_q;
  logic equal_1968_s17_q;
  logic not_1969_s17_q;
  logic equal_1970_s17_q;
  logic [9:0] patches_rows_rdata_s17_q;
  logic or_1989_s17_q;
  logic or_1992_s17_q;
  logic or_1995_s17_q;
  logic not_1997_s17_q;
  logic textured_s17_q;
  logic and_2022_s17_q;
  logic and_2029_s17_q;
  logic [12:0] seen_columns_rdata_s17_q;
  logic shown_s17_q;
  logic near_s17_q;
  logic and_2070_s17_q;
  logic and_2072_s17_q;
  logic or_2087_s17_q;
  logic or_2090_s17_q;
  logic or_2093_s17_q;
  logic and_2104_s17_q;
  logic and_2106_s17_q;
  logic and_2107_s17_q;
  logic and_2120_s17_q;
  logic and_2122_s17_q;
  logic and_2123_s17_q;
  logic and_2143_s17_q;
  logic equal_2284_s17_q;
  logic equal_2473_s17_q;
  logic and_2604_s17_q;
  logic not_2623_s17_q;
  logic and_2624_s17_q;
  logic and_2626_s17_q;
  logic and_2627_s17_q;
  logic and_2666_s17_q;
  logic and_2673_s17_q;
  logic and_2697_s17_q;
  logic select_2707_s17_q;
  logic select_2710_s17_q;
  logic and_2711_s17_q;
  logic and_2758_s17_q;
  logic and_2759_s17_q;
  logic [11:0] residual_s17_q;
  logic equal_2821_s17_q;
  logic [3:0] not_2822_s17_q;
  logic [1:0] quarter_2_s17_q;
  logic and_2997_s17_q;
  logic less_3124_s17_q;
  logic equal_3467_s17_q;
  logic [4:0] select_3555_s17_q;
  logic select_3562_s17_q;
  logic select_3571_s17_q;
  logic and_3577_s17_q;
  logic [14:0] select_3586_s17_q;
  logic equal_3931_s17_q;
  logic equal_3951_s17_q;
  logic equal_3954_s17_q;
  logic equal_3955_s17_q;
  logic equal_3956_s17_q;
  logic [7:0] select_3975_s17_q;
  logic equal_4096_s17_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s17_q <= sample_pair_pixel_0_q;
      pixel_1_s17_q <= sample_pair_pixel_1_q;
      saturated_s17_q <= saturated_s16_q;
      marks_first_s17_q <= marks_first_s16_q;
      marks_last_s17_q <= marks_last_s16_q;
      sample_pair_pixel_0_s17_q <= sample_pair_pixel_0_s16_q;
      sample_pair_pixel_1_s17_q <= sample_pair_pixel_1_s16_q;
      sample_pair_whole_s17_q <= sample_pair_whole_s16_q;
      sample_present_s17_q <= sample_present_s16_q;
      moments_starts_s17_q <= moments_starts_s16_q;
      run_shift_s17_q <= run_shift_s16_q;
      x_s17_q <= x_s16_q;
      age_s17_q <= age_s16_q;
      slot_s17_q <= slot_s16_q;
      ends_cell_s17_q <= ends_cell_s16_q;
      lower_half_s17_q <= lower_half_s16_q;
      registration_of_right_s17_q <= registration_of_right_q;
      patches_choosing_band_s17_q <= patches_choosing_band_s16_q;
      patches_lower_s17_q <= patches_lower_s16_q;
      patches_second_s17_q <= patches_second_s16_q;
      patches_code_row_s17_q <= patches_code_row_s16_q;
      patches_down_values_1_s17_q <= patches_down_values_1_q;
      patches_along_s17_q <= patches_along_s16_q;
      patches_summed_last_s17_q <= patches_summed_last_s16_q;
      patches_summed_down_by_s17_q <= patches_summed_down_by_s16_q;
      patches_read_row_differing_s17_q <= patches_read_row_differing_s16_q;
      patches_read_first_s17_q <= patches_read_first_s16_q;
      region_row_s17_q <= region_row_q;
      region_fresh_s17_q <= region_fresh_q;
      centres_values_1_textured_s17_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s17_q <= centres_values_1_of_skin_q;
      select_508_s17_q <= select_508_s16_q;
      select_511_s17_q <= select_511_s16_q;
      select_515_s17_q <= select_515_s16_q;
      and_524_s17_q <= and_524_s16_q;
      and_525_s17_q <= and_525_s16_q;
      sum_532_s17_q <= sum_532;
      sum_536_s17_q <= sum_536;
      and_540_s17_q <= whole & (averager_memory_rdata_s16_q[28] | equal_530_s16_q);
      and_544_s17_q <= and_544;
      last_s17_q <= last_s16_q;
      and_548_s17_q <= and_548_s16_q;
      and_550_s17_q <= and_550_s16_q;
      equal_553_s17_q <= select_508_s16_q == 4'h3;
      equal_570_s17_q <= equal_570_s16_q;
      equal_575_s17_q <= equal_575_s16_q;
      not_576_s17_q <= not_576_s16_q;
      so_s17_q <= so_s16_q;
      not_578_s17_q <= not_578_s16_q;
      equal_579_s17_q <= equal_579_s16_q;
      inside_v_s17_q <= inside_v_s16_q;
      not_588_s17_q <= not_588_s16_q;
      moments_memory_rdata_s17_q <= moments_memory_rdata_q;
      x_s17_2_q <= x_s16_2_q;
      best_left_rdata_s17_q <= best_left_rdata_s16_q;
      right_s17_q <= right_s16_q;
      best_right_rdata_s17_q <= best_right_rdata_s16_q[14:0];
      and_637_s17_q <= and_637;
      and_640_s17_q <= and_640_s16_q;
      and_647_s17_q <= and_647_s16_q;
      equal_680_s17_q <= equal_680_s16_q;
      of_best_s17_q <= of_best_s16_q;
      or_1517_s17_q <= select_762_s16_q | (best_left_rdata_s16_q[16:9] < of_best_s16_q);
      select_1522_s17_q <= select_1522_s16_q;
      select_1531_s17_q <= select_1531;
      select_1534_s17_q <= select_1534;
      select_1553_s17_q <= select_762_s16_q ? of_near_s16_q : select_1552_s16_q;
      select_1555_s17_q <= select_762_s16_q ? run_shift_s16_q : select_1554_s16_q;
      select_1558_s17_q <= (run_shift_s16_q == 6'h3f) ? of_best_s16_q : select_1557_s16_q;
      select_1561_s17_q <= (run_shift_s16_q == 6'h1) ? of_best_s16_q : select_1560_s16_q;
      and_1562_s17_q <= and_1562_s16_q;
      or_1566_s17_q <= or_1566;
      select_1571_s17_q <= or_1570_s16_q ? of_near_s16_q : best_right_rdata_s16_q[21:15];
      select_1572_s17_q <= or_1570_s16_q ? x_s16_2_q : best_right_rdata_s16_q[28:22];
      and_1575_s17_q <= and_1575_s16_q;
      select_1579_s17_q <= select_1579_s16_q;
      and_1586_s17_q <= and_1586;
      and_1590_s17_q <= and_1590;
      and_1601_s17_q <= and_1601_s16_q;
      equal_1608_s17_q <= equal_1608_s16_q;
      quarter_s17_q <= quarter;
      all_s17_q <= all_s16_q;
      sum_1614_s17_q <= sum_1614;
      select_1615_s17_q <= select_1615;
      equal_1616_s17_q <= equal_1616;
      equal_1618_s17_q <= equal_1618;
      equal_1620_s17_q <= equal_1620;
      equal_1622_s17_q <= equal_1622_s16_q;
      equal_1624_s17_q <= equal_1624_s16_q;
      equal_1626_s17_q <= equal_1626_s16_q;
      equal_1628_s17_q <= equal_1628_s16_q;
      equal_1630_s17_q <= equal_1630_s16_q;
      less_1639_s17_q <= less_1639;
      or_1643_s17_q <= or_1643;
      select_1646_s17_q <= equal_1608_s16_q ? and_1638 : (less_1639 & (~or_1643));
      and_1656_s17_q <= half_ends & ({{3{sum_1654[4]}}, sum_1654} < 8'h3);
      select_1661_s17_q <= select_1661;
      and_1676_s17_q <= and_1676_s16_q;
      select_1693_s17_q <= select_1693_s16_q;
      equal_1694_s17_q <= equal_1694_s16_q;
      and_1702_s17_q <= and_1702_s16_q;
      equal_1704_s17_q <= equal_1704_s16_q;
      and_1737_s17_q <= (less_1703_s16_q & (and_637 & less_1720)) & and_1736_s16_q;
      select_1753_s17_q <= select_1753_s16_q;
      select_1779_s17_q <= select_1779_s16_q;
      and_1786_s17_q <= and_1786_s16_q;
      and_1787_s17_q <= and_1787_s16_q;
      equal_1788_s17_q <= equal_1788_s16_q;
      equal_1790_s17_q <= equal_1790_s16_q;
      equal_1793_s17_q <= equal_1793_s16_q;
      or_1794_s17_q <= or_1794_s16_q;
      and_1803_s17_q <= and_1803_s16_q;
      select_1818_s17_q <= select_1818_s16_q;
      select_1824_s17_q <= select_1824_s16_q;
      select_1863_s17_q <= select_1863_s16_q;
      less_1879_s17_q <= less_1879_s16_q;
      new_row_s17_q <= new_row_s16_q;
      or_1892_s17_q <= or_1892_s16_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      down_2_s17_q <= down_2_s16_q[1:0];
      sum_1905_s17_q <= sum_1905;
      smooth_s17_q <= smooth;
      and_1952_s17_q <= not_1789_s16_q & (not_1791_s16_q & and_1950_s16_q);
      and_1961_s17_q <= and_1961_s16_q;
      and_1966_s17_q <= not_1789_s16_q & (not_1791_s16_q & and_1964_s16_q);
      less_1967_s17_q <= less_1967_s16_q;
      equal_1968_s17_q <= equal_1968_s16_q;
      not_1969_s17_q <= not_1969_s16_q;
      equal_1970_s17_q <= equal_1970_s16_q;
      patches_rows_rdata_s17_q <= patches_rows_rdata_s16_q;
      or_1989_s17_q <= or_1989_s16_q;
      or_1992_s17_q <= or_1992_s16_q;
      or_1995_s17_q <= or_1995_s16_q;
      not_1997_s17_q <= not_1997;
      textured_s17_q <= textured_s16_q;
      and_2022_s17_q <= and_2022;
      and_2029_s17_q <= not_576_s16_q & and_2004_s16_q;
      seen_columns_rdata_s17_q <= seen_columns_rdata_s16_q;
      shown_s17_q <= shown;
      near_s17_q <= near;
      and_2070_s17_q <= and_2070_s16_q;
      and_2072_s17_q <= and_2072_s16_q;
      or_2087_s17_q <= or_2087_s16_q;
      or_2090_s17_q <= or_2090_s16_q;
      or_2093_s17_q <= or_2093_s16_q;
      and_2104_s17_q <= and_2104_s16_q;
      and_2106_s17_q <= seen_columns_rdata_s16_q[7] & inside_v_s16_q;
      and_2107_s17_q <= seen_columns_rdata_s16_q[3] & inside_v_s16_q;
      and_2120_s17_q <= and_2120_s16_q;
      and_2122_s17_q <= seen_columns_rdata_s16_q[8] & inside_v_s16_q;
      and_2123_s17_q <= seen_columns_rdata_s16_q[4] & inside_v_s16_q;
      and_2143_s17_q <= and_2143_s16_q;
      equal_2284_s17_q <= equal_2284_s16_q;
      equal_2473_s17_q <= equal_2473_s16_q;
      and_2604_s17_q <= and_2604;
      not_2623_s17_q <= not_2623;
      and_2624_s17_q <= and_2624_s16_q;
      and_2626_s17_q <= seen_columns_rdata_s16_q[6] & inside_v_s16_q;
      and_2627_s17_q <= seen_columns_rdata_s16_q[2] & inside_v_s16_q;
      and_2666_s17_q <= not_576_s16_q & and_2665;
      and_2673_s17_q <= not_576_s16_q & (so_s16_q & (ends_cell_s16_q & and_2670));
      and_2697_s17_q <= inside_v_s16_q & (or_580_s16_q & (not_584_s16_q & and_2694));
      select_2707_s17_q <= select_2707[1];
      select_2710_s17_q <= select_2710[1];
      and_2711_s17_q <= select_2707[0] & select_2710[0];
      and_2758_s17_q <= not_576_s16_q & (so_s16_q & (half_ends & equal_2755));
      and_2759_s17_q <= and_637 & less_1703_s16_q;
      residual_s17_q <= residual;
      equal_2821_s17_q <= sum_1614 == 2'h2;
      not_2822_s17_q <= ~select_1661;
      quarter_2_s17_q <= quarter_2;
      and_2997_s17_q <= and_2997_s16_q;
      less_3124_s17_q <= less_3124_s16_q;
      equal_3467_s17_q <= patches_match_row_s16_q == 4'h0;
      select_3555_s17_q <= select_3555_s16_q;
      select_3562_s17_q <= select_3562;
      select_3571_s17_q <= select_3571;
      and_3577_s17_q <= equal_3551_s16_q & ({sum_3575[6], sum_3575} < 8'hfb);
      select_3586_s17_q <= select_3586_s16_q;
      equal_3931_s17_q <= equal_3931_s16_q;
      equal_3951_s17_q <= equal_3951;
      equal_3954_s17_q <= x_s16_q[6:3] == 4'hb;
      equal_3955_s17_q <= equal_3955;
      equal_3956_s17_q <= equal_3956;
      select_3975_s17_q <= equal_3951 ? cfg_regions_limit_i : select_3974;
      equal_4096_s17_q <= equal_4096_s16_q;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:215
  logic [8:0] grey;
  assign grey = and_524_s17_q ? sum_532_s17_q[13:5] : 9'h0;
  // hls/stages/census.hpp:216
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_553_s17_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:215
  logic [8:0] grey_2;
  assign grey_2 = and_524_s17_q ? sum_536_s17_q[13:5] : 9'h0;
  // hls/stages/census.hpp:216
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_553_s17_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:215
  logic and_561;
  assign and_561 = and_524_s17_q & and_540_s17_q;
  // hls/stages/census.hpp:131
  logic select_563;
  assign select_563 = equal_553_s17_q ? and_561 : (averager_mask_q & and_561);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s17_q & select_563;
  // hls/stages/census.hpp:215
  logic and_565;
  assign and_565 = and_524_s17_q & and_544_s17_q;
  // hls/stages/census.hpp:131
  logic select_567;
  assign select_567 = equal_553_s17_q ? and_565 : (averager_of_skin_q & and_565);
  // hls/stages/agreement.hpp:455
  logic equal_677;
  assign equal_677 = last_s17_q == 7'h0;
  logic [3:0] select_681;
  assign select_681 = equal_680_s17_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_682;
  assign select_682 = equal_677 ? {select_681, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:287
  logic [3:0] select_683;
  assign select_683 = equal_677 ? 4'h0 : census_filled_q;
  // hls/stages/agreement.hpp:788
  logic and_1587;
  assign and_1587 = not_578_s17_q & and_1586_s17_q;
  // hls/stages/moments.hpp:73
  logic and_1594;
  assign and_1594 = moments_has_before_q & moments_memory_rdata_s17_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1598;
  assign and_1598 = not_588_s17_q & (and_1594 & (moments_memory_rdata_s17_q[1] ^ and_640_s17_q));
  // hls/stages/moments.hpp:73
  logic and_1603;
  assign and_1603 = moments_has_before_q & moments_memory_rdata_s17_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1607;
  assign and_1607 = not_588_s17_q & (and_1603 & (moments_memory_rdata_s17_q[3] ^ and_647_s17_q));
  // hls/stages/agreement.hpp:788
  logic and_1657;
  assign and_1657 = so_s17_q & and_1656_s17_q;
  logic and_1741;
  assign and_1741 = not_576_s17_q & (so_s17_q & (ends_cell_s17_q & (inside_v_s17_q & and_1737_s17_q)));
  logic [7:0] select_1747;
  assign select_1747 = so_s17_q ? (ends_cell_s17_q ? (inside_v_s17_q ? x_s17_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:471
  logic [13:0] sum_1906;
  assign sum_1906 = {{3{patches_down_values_1_s17_q[10]}}, patches_down_values_1_s17_q} + {sum_1905_s17_q, down_2_s17_q[1]};
  logic [12:0] sum_1907;
  assign sum_1907 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1906[13:1];
  // hls/stages/patches.hpp:470
  logic [12:0] sum_1925;
  assign sum_1925 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s17_q[11:1]};
  logic [12:0] sum_1926;
  assign sum_1926 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1927;
  assign difference_1927 = {1'b0, sum_1925, smooth_s17_q[0]} - {1'b0, sum_1926, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:262
  logic explained;
  assign explained = inside_v_s17_q & and_637_s17_q;
  logic and_2031;
  assign and_2031 = inside_v_s17_q & and_2022_s17_q;
  // hls/stages/agreement.hpp:1030
  logic and_2073;
  assign and_2073 = seen_columns_rdata_s17_q[0] & inside_v_s17_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2075;
  assign sum_2075 = {1'b0, and_2072_s17_q} + ({1'b0, textured_s17_q} + {1'b0, and_2073});
  // hls/stages/agreement.hpp:1030
  logic and_2105;
  assign and_2105 = seen_columns_rdata_s17_q[11] & inside_v_s17_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2109;
  assign sum_2109 = {1'b0, and_2106_s17_q} + ({1'b0, shown_s17_q} + {1'b0, and_2107_s17_q});
  // hls/stages/agreement.hpp:1030
  logic and_2121;
  assign and_2121 = seen_columns_rdata_s17_q[12] & inside_v_s17_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2125;
  assign sum_2125 = {1'b0, and_2122_s17_q} + ({1'b0, near_s17_q} + {1'b0, and_2123_s17_q});
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2175;
  assign select_2175 = sample_pair_whole_s17_q ? (and_548_s17_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2177;
  assign select_2177 = sample_pair_whole_s17_q ? (and_548_s17_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2199;
  assign select_2199 = sample_pair_whole_s17_q ? (and_548_s17_q ? select_563 : averager_mask_q) : averager_mask_q;
  logic select_2201;
  assign select_2201 = sample_pair_whole_s17_q ? (and_548_s17_q ? select_567 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:1142
  logic equal_2299;
  assign equal_2299 = x_s17_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:788
  logic select_2305;
  assign select_2305 = equal_575_s17_q ? (moments_has_before_q | equal_2299) : moments_has_before_q;
  // hls/stages/agreement.hpp:520
  logic and_2598;
  assign and_2598 = and_550_s17_q & (equal_680_s17_q & equal_2473_s17_q);
  // hls/stages/agreement.hpp:788
  logic and_2609;
  assign and_2609 = not_576_s17_q & (so_s17_q & (ends_cell_s17_q & textured_s17_q));
  // hls/stages/agreement.hpp:1030
  logic and_2625;
  assign and_2625 = seen_columns_rdata_s17_q[10] & inside_v_s17_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2629;
  assign sum_2629 = {1'b0, and_2626_s17_q} + ({1'b0, explained} + {1'b0, and_2627_s17_q});
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2668;
  assign select_2668 = and_2598 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2666_s17_q});
  logic [13:0] select_2675;
  assign select_2675 = and_2598 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2673_s17_q});
  // hls/stages/agreement.hpp:1027
  logic and_2712;
  assign and_2712 = and_637_s17_q & and_2711_s17_q;
  // hls/stages/agreement.hpp:788
  logic and_2715;
  assign and_2715 = ends_cell_s17_q & (inside_v_s17_q & (select_2707_s17_q & and_2712));
  logic and_2722;
  assign and_2722 = ends_cell_s17_q & (inside_v_s17_q & (select_2710_s17_q & and_2712));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2793;
  assign difference_2793 = 13'h0 - {residual_s17_q[11], residual_s17_q};
  logic less_2808;
  assign less_2808 = $signed(difference_2793) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2824;
  assign select_2824 = equal_2821_s17_q ? (registration_fresh_q & not_2822_s17_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2826;
  assign select_2826 = so_s17_q ? (and_1656_s17_q ? select_2824 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2828;
  assign select_2828 = and_2598 ? 4'hf : (equal_575_s17_q ? registration_fresh_q : select_2826);
  // hls/stages/registration.hpp:258
  logic not_2849;
  assign not_2849 = ~quarter_2_s17_q[1];
  logic [3:0] select_2850;
  assign select_2850 = quarter_2_s17_q[0] ? {quarter_2_s17_q[1], 1'b0, not_2849, 1'b0} : {1'b0, quarter_2_s17_q[1], 1'b0, not_2849};
  // hls/stages/patches.hpp:184
  logic [11:0] select_3090;
  assign select_3090 = equal_1790_s17_q ? patches_smooth_values_0_q : (or_1794_s17_q ? smooth_s17_q : patches_smooth_values_0_q);
  logic [11:0] select_3092;
  assign select_3092 = or_1794_s17_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3094;
  assign select_3094 = equal_1788_s17_q ? patches_smooth_values_1_q : (equal_1790_s17_q ? patches_smooth_values_1_q : select_3092);
  logic [11:0] select_3095;
  assign select_3095 = or_1794_s17_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3097;
  assign select_3097 = equal_1788_s17_q ? patches_smooth_values_2_q : (equal_1790_s17_q ? patches_smooth_values_2_q : select_3095);
  logic [11:0] select_3098;
  assign select_3098 = or_1794_s17_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3100;
  assign select_3100 = equal_1788_s17_q ? patches_smooth_values_3_q : (equal_1790_s17_q ? patches_smooth_values_3_q : select_3098);
  logic [10:0] select_3107;
  assign select_3107 = or_1794_s17_q ? patches_down_values_1_s17_q : patches_down_values_2_q;
  logic [10:0] select_3109;
  assign select_3109 = equal_1788_s17_q ? patches_down_values_2_q : (equal_1790_s17_q ? patches_down_values_2_q : select_3107);
  logic [10:0] select_3110;
  assign select_3110 = or_1794_s17_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3112;
  assign select_3112 = equal_1788_s17_q ? patches_down_values_3_q : (equal_1790_s17_q ? patches_down_values_3_q : select_3110);
  // hls/stages/patches.hpp:560
  logic select_3564;
  assign select_3564 = less_1967_s17_q ? (not_1969_s17_q & select_3562_s17_q) : select_3562_s17_q;
  logic select_3573;
  assign select_3573 = less_1967_s17_q ? (not_1969_s17_q & select_3571_s17_q) : select_3571_s17_q;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3579;
  assign select_3579 = less_1967_s17_q ? (and_3577_s17_q ? patches_rows_rdata_s17_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:541
  logic [9:0] select_3590;
  assign select_3590 = patches_read_above_q ? patches_read_row_differing_s17_q : patches_peak_above_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3592;
  assign select_3592 = patches_read_below_q ? patches_read_row_differing_s17_q : patches_peak_below_q;
  // hls/stages/patches.hpp:579
  logic less_3629;
  assign less_3629 = select_3590 < select_3592;
  // hls/stages/patches.hpp:580
  logic [9:0] high;
  assign high = less_3629 ? select_3592 : select_3590;
  logic [9:0] low;
  assign low = (select_3592 < select_3590) ? select_3592 : select_3590;
  // hls/stages/agreement.hpp:1223
  logic equal_3707;
  assign equal_3707 = x_s17_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1217
  logic equal_3953;
  assign equal_3953 = x_s17_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3976;
  assign select_3976 = equal_3954_s17_q ? {cfg_on_skin_limit_i, 3'h0} : select_3975_s17_q;
  logic [7:0] limit;
  assign limit = equal_3953 ? cfg_regions_limit_i : select_3976;
  // hls/stages/agreement.hpp:1231
  logic not_3978;
  assign not_3978 = ~x_s17_q[2];
  logic [3:0] select_3979;
  assign select_3979 = x_s17_q[1] ? {x_s17_q[2], 1'b0, not_3978, 1'b0} : {1'b0, x_s17_q[2], 1'b0, not_3978};
  logic [7:0] select_3980;
  assign select_3980 = x_s17_q[0] ? {select_3979[3], 1'b0, select_3979[2], 1'b0, select_3979[1], 1'b0, select_3979[0], 1'b0} : {1'b0, select_3979[3], 1'b0, select_3979[2], 1'b0, select_3979[1], 1'b0, select_3979[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3984;
  assign select_3984 = equal_3955_s17_q ? counts_skin_supervised_q : (equal_3956_s17_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3986;
  assign select_3986 = equal_3954_s17_q ? counts_skin_textured_q : (equal_3951_s17_q ? counts_textured_q : select_3984);
  logic [13:0] of;
  assign of = equal_3953 ? counts_textured_q : select_3986;
  // hls/stages/registration.hpp:258
  logic not_4189;
  assign not_4189 = ~quarter_s17_q[1];
  logic [3:0] select_4190;
  assign select_4190 = quarter_s17_q[0] ? {quarter_s17_q[1], 1'b0, not_4189, 1'b0} : {1'b0, quarter_s17_q[1], 1'b0, not_4189};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 17, written in stage 21: 17 < 21 < 17 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1615_s17_q;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s17_en & (equal_575_s17_q ? (x_s17_q[6] & select_1646_s17_q) : and_1657);
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_515_s17_q;
  logic averager_memory_we;
  assign averager_memory_we = s17_en & and_525_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_544_s17_q, and_540_s17_q, sum_536_s17_q, sum_532_s17_q};
  end
`ifndef SYNTHESIS
  logic [8:0] averager_memory_raddr_s15_sim;
  logic averager_memory_re_s15_sim;
  logic [8:0] averager_memory_raddr_s16_sim;
  logic averager_memory_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      averager_memory_re_s15_sim <= 1'b0;
      averager_memory_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      averager_memory_re_s15_sim <= averager_memory_re;
      averager_memory_raddr_s15_sim <= averager_memory_raddr;
      averager_memory_re_s16_sim <= averager_memory_re_s15_sim;
      averager_memory_raddr_s16_sim <= averager_memory_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && averager_memory_we) begin
      if (averager_memory_re && averager_memory_raddr == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s15_sim && averager_memory_raddr_s15_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_re_s16_sim && averager_memory_raddr_s16_sim == averager_memory_waddr) begin
        $error("averager_memory: address %0d is read less than DISTANCE steps after its write", averager_memory_waddr);
      end
      if (averager_memory_waddr >= 9'd480) $error("averager_memory: write outside, address %0d", averager_memory_waddr);
    end
    if (rst_ni && averager_memory_re && averager_memory_raddr >= 9'd480) $error("averager_memory: read outside, address %0d", averager_memory_raddr);
  end
`endif

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1579_s17_q;
  logic shown_right_we;
  assign shown_right_we = s17_en & and_1590_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1587, not_578_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] shown_right_raddr_s15_sim;
  logic shown_right_re_s15_sim;
  logic [6:0] shown_right_raddr_s16_sim;
  logic shown_right_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      shown_right_re_s15_sim <= 1'b0;
      shown_right_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      shown_right_re_s15_sim <= shown_right_re;
      shown_right_raddr_s15_sim <= shown_right_raddr;
      shown_right_re_s16_sim <= shown_right_re_s15_sim;
      shown_right_raddr_s16_sim <= shown_right_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && shown_right_we) begin
      if (shown_right_re && shown_right_raddr == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_re_s15_sim && shown_right_raddr_s15_sim == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_re_s16_sim && shown_right_raddr_s16_sim == shown_right_waddr) begin
        $error("shown_right: address %0d is read less than DISTANCE steps after its write", shown_right_waddr);
      end
      if (shown_right_waddr >= 7'd120) $error("shown_right: write outside, address %0d", shown_right_waddr);
    end
    if (rst_ni && shown_right_re && shown_right_raddr >= 7'd120) $error("shown_right: read outside, address %0d", shown_right_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s17_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s17_en & and_1575_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s17_q, near_s17_q, shown_s17_q, explained, and_2031, textured_s17_q};
  end
`ifndef SYNTHESIS
  logic [6:0] seen_columns_raddr_s14_sim;
  logic seen_columns_re_s14_sim;
  logic [6:0] seen_columns_raddr_s15_sim;
  logic seen_columns_re_s15_sim;
  logic [6:0] seen_columns_raddr_s16_sim;
  logic seen_columns_re_s16_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      seen_columns_re_s14_sim <= 1'b0;
      seen_columns_re_s15_sim <= 1'b0;
      seen_columns_re_s16_sim <= 1'b0;
    end else if (en_i) begin
      seen_columns_re_s14_sim <= seen_columns_re;
      seen_columns_raddr_s14_sim <= seen_columns_raddr;
      seen_columns_re_s15_sim <= seen_columns_re_s14_sim;
      seen_columns_raddr_s15_sim <= seen_columns_raddr_s14_sim;
      seen_columns_re_s16_sim <= seen_columns_re_s15_sim;
      seen_columns_raddr_s16_sim <= seen_columns_raddr_s15_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && seen_columns_we) begin
      if (seen_columns_re && seen_columns_raddr == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s14_sim && seen_columns_raddr_s14_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s15_sim && seen_columns_raddr_s15_sim == seen_columns_waddr) begin
        $error("seen_columns: address %0d is read less than DISTANCE steps after its write", seen_columns_waddr);
      end
      if (seen_columns_re_s16_sim && seen_columns_raddr_s16_sim == seen_columns_waddr) begin
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
    end else if (s17_en) begin
      averager_mask_q <= select_2199;
      averager_of_skin_q <= select_2201;
      census_filled_q <= and_550_s17_q ? {select_683[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2305;
      rows_passed_above_q <= and_550_s17_q ? select_682 : rows_passed_above_q;
      counts_textured_q <= and_2598 ? 14'h0 : (counts_textured_q + {13'h0, and_2609});
      counts_skin_supervised_q <= select_2668;
      counts_skin_textured_q <= select_2675;
      registration_fresh_q <= select_2828;
      patches_smooth_values_0_q <= equal_1788_s17_q ? patches_smooth_values_0_q : select_3090;
      patches_smooth_values_1_q <= select_3094;
      patches_smooth_values_2_q <= select_3097;
      patches_smooth_values_3_q <= select_3100;
      patches_down_values_2_q <= select_3109;
      patches_down_values_3_q <= select_3112;
      patches_read_above_q <= equal_1788_s17_q ? select_3564 : patches_read_above_q;
      patches_read_below_q <= equal_1788_s17_q ? select_3573 : patches_read_below_q;
      patches_peak_above_q <= equal_1788_s17_q ? select_3590 : patches_peak_above_q;
      patches_peak_below_q <= equal_1788_s17_q ? select_3592 : patches_peak_below_q;
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
    if (s17_en) begin
      averager_total_0_q <= select_2175;
      averager_total_1_q <= select_2177;
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
  logic moments_starts_s18_q;
  logic [7:0] x_s18_q;
  logic age_s18_q;
  logic [2:0] slot_s18_q;
  logic ends_cell_s18_q;
  logic lower_half_s18_q;
  logic [13:0] counts_textured_s18_q;
  logic registration_of_right_s18_q;
  logic [4:0] patches_choosing_band_s18_q;
  logic patches_lower_s18_q;
  logic patches_second_s18_q;
  logic [4:0] patches_code_row_s18_q;
  logic [10:0] patches_down_values_3_s18_q;
  logic [4:0] patches_along_s18_q;
  logic patches_summed_last_s18_q;
  logic [4:0] patches_summed_down_by_s18_q;
  logic patches_read_first_s18_q;
  logic [2:0] region_row_s18_q;
  logic region_fresh_s18_q;
  logic segment_started_s18_q;
  logic centres_values_1_textured_s18_q;
  logic centres_values_1_of_skin_s18_q;
  logic [3:0] select_508_s18_q;
  logic [6:0] select_511_s18_q;
  logic [6:0] last_s18_q;
  logic and_548_s18_q;
  logic and_550_s18_q;
  logic [77:0] census_memory_rdata_s18_q;
  logic [8:0] grey_s18_q;
  logic equal_553_s18_q;
  logic [8:0] select_556_s18_q;
  logic [8:0] grey_2_s18_q;
  logic [8:0] select_560_s18_q;
  logic whole_2_s18_q;
  logic and_568_s18_q;
  logic equal_570_s18_q;
  logic equal_575_s18_q;
  logic not_576_s18_q;
  logic so_s18_q;
  logic not_578_s18_q;
  logic equal_579_s18_q;
  logic inside_v_s18_q;
  logic [6:0] x_s18_2_q;
  logic [6:0] right_s18_q;
  logic and_684_s18_q;
  logic [5:0] select_1518_s18_q;
  logic [2:0] select_1523_s18_q;
  logic [7:0] select_1524_s18_q;
  logic [7:0] select_1532_s18_q;
  logic [7:0] select_1535_s18_q;
  logic [6:0] select_1553_s18_q;
  logic [5:0] select_1555_s18_q;
  logic [7:0] select_1558_s18_q;
  logic [7:0] select_1561_s18_q;
  logic and_1562_s18_q;
  logic [7:0] select_1567_s18_q;
  logic [6:0] select_1568_s18_q;
  logic [6:0] select_1571_s18_q;
  logic [6:0] select_1572_s18_q;
  logic and_1595_s18_q;
  logic and_1598_s18_q;
  logic and_1601_s18_q;
  logic and_1604_s18_q;
  logic and_1607_s18_q;
  logic equal_1608_s18_q;
  logic all_s18_q;
  logic [1:0] sum_1614_s18_q;
  logic equal_1616_s18_q;
  logic equal_1618_s18_q;
  logic equal_1620_s18_q;
  logic equal_1622_s18_q;
  logic equal_1624_s18_q;
  logic equal_1626_s18_q;
  logic equal_1628_s18_q;
  logic equal_1630_s18_q;
  logic less_1639_s18_q;
  logic or_1643_s18_q;
  logic equal_1663_s18_q;
  logic and_1673_s18_q;
  logic and_1676_s18_q;
  logic select_1693_s18_q;
  logic equal_1694_s18_q;
  logic [22:0] patches_choices_rdata_s18_q;
  logic and_1702_s18_q;
  logic equal_1704_s18_q;
  logic and_1741_s18_q;
  logic [7:0] select_1748_s18_q;
  logic [5:0] select_1753_s18_q;
  logic [7:0] select_1779_s18_q;
  logic and_1786_s18_q;
  logic and_1787_s18_q;
  logic equal_1788_s18_q;
  logic equal_1790_s18_q;
  logic equal_1793_s18_q;
  logic or_1794_s18_q;
  logic and_1803_s18_q;
  logic [4:0] select_1818_s18_q;
  logic select_1824_s18_q;
  logic [3:0] select_1863_s18_q;
  logic less_1879_s18_q;
  logic new_row_s18_q;
  logic or_1892_s18_q;
  logic [27:0] patches_right_codes_rdata_s18_q;
  logic [1:0] of_row_2_s18_q;
  logic down_2_s18_q;
  logic sum_1906_s18_q;
  logic [12:0] sum_1907_s18_q;
  logic [14:0] difference_1927_s18_q;
  logic and_1952_s18_q;
  logic [47:0] patches_left_codes_rdata_s18_q;
  logic and_1961_s18_q;
  logic and_1966_s18_q;
  logic less_1967_s18_q;
  logic equal_1968_s18_q;
  logic not_1969_s18_q;
  logic equal_1970_s18_q;
  logic or_1989_s18_q;
  logic or_1992_s18_q;
  logic or_1995_s18_q;
  logic not_1997_s18_q;
  logic [29:0] regions_rdata_s18_q;
  logic textured_s18_q;
  logic explained_s18_q;
  logic and_2024_s18_q;
  logic and_2029_s18_q;
  logic and_2070_s18_q;
  logic and_2071_s18_q;
  logic [1:0] sum_2075_s18_q;
  logic or_2087_s18_q;
  logic or_2090_s18_q;
  logic or_2093_s18_q;
  logic and_2104_s18_q;
  logic [2:0] sum_2110_s18_q;
  logic and_2120_s18_q;
  logic [2:0] sum_2126_s18_q;
  logic and_2143_s18_q;
  logic equal_2284_s18_q;
  logic equal_2299_s18_q;
  logic equal_2473_s18_q;
  logic and_2598_s18_q;
  logic and_2604_s18_q;
  logic and_2609_s18_q;
  logic not_2623_s18_q;
  logic and_2624_s18_q;
  logic [2:0] sum_2630_s18_q;
  logic and_2700_s18_q;
  logic and_2717_s18_q;
  logic and_2724_s18_q;
  logic and_2758_s18_q;
  logic and_2759_s18_q;
  logic [7:0] residual_s18_q;
  logic less_2794_s18_q;
  logic less_2808_s18_q;
  logic equal_2852_s18_q;
  logic and_2997_s18_q;
  logic less_3124_s18_q;
  logic equal_3467_s18_q;
  logic [4:0] select_3555_s18_q;
  logic [9:0] select_3579_s18_q;
  logic [14:0] select_3586_s18_q;
  logic less_3629_s18_q;
  logic [9:0] high_s18_q;
  logic [9:0] low_s18_q;
  logic equal_3707_s18_q;
  logic and_3932_s18_q;
  logic equal_3951_s18_q;
  logic equal_3953_s18_q;
  logic equal_3954_s18_q;
  logic equal_3955_s18_q;
  logic equal_3956_s18_q;
  logic equal_3982_s18_q;
  logic [13:0] of_s18_q;
  logic equal_4096_s18_q;
  logic equal_4192_s18_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= sample_of_skin_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      sample_pair_pixel_0_s18_q <= sample_pair_pixel_0_s17_q;
      sample_pair_pixel_1_s18_q <= sample_pair_pixel_1_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      sample_present_s18_q <= sample_present_s17_q;
      moments_starts_s18_q <= moments_starts_s17_q;
      x_s18_q <= x_s17_q;
      age_s18_q <= age_s17_q;
      slot_s18_q <= slot_s17_q;
      ends_cell_s18_q <= ends_cell_s17_q;
      lower_half_s18_q <= lower_half_s17_q;
      counts_textured_s18_q <= counts_textured_q;
      registration_of_right_s18_q <= registration_of_right_s17_q;
      patches_choosing_band_s18_q <= patches_choosing_band_s17_q;
      patches_lower_s18_q <= patches_lower_s17_q;
      patches_second_s18_q <= patches_second_s17_q;
      patches_code_row_s18_q <= patches_code_row_s17_q;
      patches_down_values_3_s18_q <= patches_down_values_3_q;
      patches_along_s18_q <= patches_along_s17_q;
      patches_summed_last_s18_q <= patches_summed_last_s17_q;
      patches_summed_down_by_s18_q <= patches_summed_down_by_s17_q;
      patches_read_first_s18_q <= patches_read_first_s17_q;
      region_row_s18_q <= region_row_s17_q;
      region_fresh_s18_q <= region_fresh_s17_q;
      segment_started_s18_q <= segment_started_q;
      centres_values_1_textured_s18_q <= centres_values_1_textured_s17_q;
      centres_values_1_of_skin_s18_q <= centres_values_1_of_skin_s17_q;
      select_508_s18_q <= select_508_s17_q;
      select_511_s18_q <= select_511_s17_q;
      last_s18_q <= last_s17_q;
      and_548_s18_q <= and_548_s17_q;
      and_550_s18_q <= and_550_s17_q;
      census_memory_rdata_s18_q <= census_memory_rdata_q;
      grey_s18_q <= grey;
      equal_553_s18_q <= equal_553_s17_q;
      select_556_s18_q <= sample_pair_whole_s17_q ? total[10:2] : 9'h0;
      grey_2_s18_q <= grey_2;
      select_560_s18_q <= sample_pair_whole_s17_q ? total_2[10:2] : 9'h0;
      whole_2_s18_q <= whole_2;
      and_568_s18_q <= sample_pair_whole_s17_q & select_567;
      equal_570_s18_q <= equal_570_s17_q;
      equal_575_s18_q <= equal_575_s17_q;
      not_576_s18_q <= not_576_s17_q;
      so_s18_q <= so_s17_q;
      not_578_s18_q <= not_578_s17_q;
      equal_579_s18_q <= equal_579_s17_q;
      inside_v_s18_q <= inside_v_s17_q;
      x_s18_2_q <= x_s17_2_q;
      right_s18_q <= right_s17_q;
      and_684_s18_q <= select_682[4] & select_683[3];
      select_1518_s18_q <= or_1517_s17_q ? run_shift_s17_q : best_left_rdata_s17_q[5:0];
      select_1523_s18_q <= or_1517_s17_q ? select_1522_s17_q : best_left_rdata_s17_q[8:6];
      select_1524_s18_q <= or_1517_s17_q ? of_best_s17_q : best_left_rdata_s17_q[16:9];
      select_1532_s18_q <= or_1517_s17_q ? select_1531_s17_q : best_left_rdata_s17_q[24:17];
      select_1535_s18_q <= or_1517_s17_q ? select_1534_s17_q : best_left_rdata_s17_q[32:25];
      select_1553_s18_q <= select_1553_s17_q;
      select_1555_s18_q <= select_1555_s17_q;
      select_1558_s18_q <= select_1558_s17_q;
      select_1561_s18_q <= select_1561_s17_q;
      and_1562_s18_q <= and_1562_s17_q;
      select_1567_s18_q <= or_1566_s17_q ? of_best_s17_q : best_right_rdata_s17_q[7:0];
      select_1568_s18_q <= or_1566_s17_q ? x_s17_2_q : best_right_rdata_s17_q[14:8];
      select_1571_s18_q <= select_1571_s17_q;
      select_1572_s18_q <= select_1572_s17_q;
      and_1595_s18_q <= not_588_s17_q & and_1594;
      and_1598_s18_q <= and_1598;
      and_1601_s18_q <= and_1601_s17_q;
      and_1604_s18_q <= not_588_s17_q & and_1603;
      and_1607_s18_q <= and_1607;
      equal_1608_s18_q <= equal_1608_s17_q;
      all_s18_q <= all_s17_q;
      sum_1614_s18_q <= sum_1614_s17_q;
      equal_1616_s18_q <= equal_1616_s17_q;
      equal_1618_s18_q <= equal_1618_s17_q;
      equal_1620_s18_q <= equal_1620_s17_q;
      equal_1622_s18_q <= equal_1622_s17_q;
      equal_1624_s18_q <= equal_1624_s17_q;
      equal_1626_s18_q <= equal_1626_s17_q;
      equal_1628_s18_q <= equal_1628_s17_q;
      equal_1630_s18_q <= equal_1630_s17_q;
      less_1639_s18_q <= less_1639_s17_q;
      or_1643_s18_q <= or_1643_s17_q;
      equal_1663_s18_q <= (registration_fresh_q & select_1661_s17_q) == 4'h0;
      and_1673_s18_q <= not_576_s17_q & and_1657;
      and_1676_s18_q <= and_1676_s17_q;
      select_1693_s18_q <= select_1693_s17_q;
      equal_1694_s18_q <= equal_1694_s17_q;
      patches_choices_rdata_s18_q <= patches_choices_rdata_q;
      and_1702_s18_q <= and_1702_s17_q;
      equal_1704_s18_q <= equal_1704_s17_q;
      and_1741_s18_q <= and_1741;
      select_1748_s18_q <= equal_575_s17_q ? 8'h0 : select_1747;
      select_1753_s18_q <= select_1753_s17_q;
      select_1779_s18_q <= select_1779_s17_q;
      and_1786_s18_q <= and_1786_s17_q;
      and_1787_s18_q <= and_1787_s17_q;
      equal_1788_s18_q <= equal_1788_s17_q;
      equal_1790_s18_q <= equal_1790_s17_q;
      equal_1793_s18_q <= equal_1793_s17_q;
      or_1794_s18_q <= or_1794_s17_q;
      and_1803_s18_q <= and_1803_s17_q;
      select_1818_s18_q <= select_1818_s17_q;
      select_1824_s18_q <= select_1824_s17_q;
      select_1863_s18_q <= select_1863_s17_q;
      less_1879_s18_q <= less_1879_s17_q;
      new_row_s18_q <= new_row_s17_q;
      or_1892_s18_q <= or_1892_s17_q;
      patches_right_codes_rdata_s18_q <= patches_right_codes_rdata_q;
      of_row_2_s18_q <= of_row_2_s17_q;
      down_2_s18_q <= down_2_s17_q[0];
      sum_1906_s18_q <= sum_1906[0];
      sum_1907_s18_q <= sum_1907;
      difference_1927_s18_q <= difference_1927;
      and_1952_s18_q <= and_1952_s17_q;
      patches_left_codes_rdata_s18_q <= patches_left_codes_rdata_q;
      and_1961_s18_q <= and_1961_s17_q;
      and_1966_s18_q <= and_1966_s17_q;
      less_1967_s18_q <= less_1967_s17_q;
      equal_1968_s18_q <= equal_1968_s17_q;
      not_1969_s18_q <= not_1969_s17_q;
      equal_1970_s18_q <= equal_1970_s17_q;
      or_1989_s18_q <= or_1989_s17_q;
      or_1992_s18_q <= or_1992_s17_q;
      or_1995_s18_q <= or_1995_s17_q;
      not_1997_s18_q <= not_1997_s17_q;
      regions_rdata_s18_q <= regions_rdata_q;
      textured_s18_q <= textured_s17_q;
      explained_s18_q <= explained;
      and_2024_s18_q <= inside_v_s17_q & (and_2022_s17_q & and_1586_s17_q);
      and_2029_s18_q <= and_2029_s17_q;
      and_2070_s18_q <= and_2070_s17_q;
      and_2071_s18_q <= seen_columns_rdata_s17_q[9] & inside_v_s17_q;
      sum_2075_s18_q <= sum_2075;
      or_2087_s18_q <= or_2087_s17_q;
      or_2090_s18_q <= or_2090_s17_q;
      or_2093_s18_q <= or_2093_s17_q;
      and_2104_s18_q <= and_2104_s17_q;
      sum_2110_s18_q <= {2'h0, and_2105} + {1'b0, sum_2109};
      and_2120_s18_q <= and_2120_s17_q;
      sum_2126_s18_q <= {2'h0, and_2121} + {1'b0, sum_2125};
      and_2143_s18_q <= and_2143_s17_q;
      equal_2284_s18_q <= equal_2284_s17_q;
      equal_2299_s18_q <= equal_2299;
      equal_2473_s18_q <= equal_2473_s17_q;
      and_2598_s18_q <= and_2598;
      and_2604_s18_q <= and_2604_s17_q;
      and_2609_s18_q <= and_2609;
      not_2623_s18_q <= not_2623_s17_q;
      and_2624_s18_q <= and_2624_s17_q;
      sum_2630_s18_q <= {2'h0, and_2625} + {1'b0, sum_2629};
      and_2700_s18_q <= not_576_s17_q & (so_s17_q & (ends_cell_s17_q & and_2697_s17_q));
      and_2717_s18_q <= not_576_s17_q & (so_s17_q & and_2715);
      and_2724_s18_q <= not_576_s17_q & (so_s17_q & and_2722);
      and_2758_s18_q <= and_2758_s17_q;
      and_2759_s18_q <= and_2759_s17_q;
      residual_s18_q <= residual_s17_q[7:0];
      less_2794_s18_q <= $signed(difference_2793) < $signed({7'h0, cfg_moved_limit_i});
      less_2808_s18_q <= less_2808;
      equal_2852_s18_q <= (registration_fresh_q & select_2850) == 4'h0;
      and_2997_s18_q <= and_2997_s17_q;
      less_3124_s18_q <= less_3124_s17_q;
      equal_3467_s18_q <= equal_3467_s17_q;
      select_3555_s18_q <= select_3555_s17_q;
      select_3579_s18_q <= select_3579;
      select_3586_s18_q <= select_3586_s17_q;
      less_3629_s18_q <= less_3629;
      high_s18_q <= high;
      low_s18_q <= low;
      equal_3707_s18_q <= equal_3707;
      and_3932_s18_q <= equal_3931_s17_q & equal_3707;
      equal_3951_s18_q <= equal_3951_s17_q;
      equal_3953_s18_q <= equal_3953;
      equal_3954_s18_q <= equal_3954_s17_q;
      equal_3955_s18_q <= equal_3955_s17_q;
      equal_3956_s18_q <= equal_3956_s17_q;
      equal_3982_s18_q <= (limit & select_3980) == 8'h0;
      of_s18_q <= of;
      equal_4096_s18_q <= equal_4096_s17_q;
      equal_4192_s18_q <= (registration_fresh_q & select_4190) == 4'h0;
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:305
  logic less_653;
  assign less_653 = census_memory_rdata_s18_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_memory_rdata_s18_q[48:40] < census_columns_values_1_cell_2_left_q;
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
  // hls/stages/census.hpp:306
  logic less_665;
  assign less_665 = census_memory_rdata_s18_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_memory_rdata_s18_q[57:49] < census_columns_values_1_cell_2_right_q;
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
  // hls/stages/census.hpp:297
  logic and_686;
  assign and_686 = census_memory_rdata_s18_q[38] & (census_memory_rdata_s18_q[18] & whole_2_s18_q);
  logic and_688;
  assign and_688 = census_memory_rdata_s18_q[77] & (census_memory_rdata_s18_q[58] & and_686);
  // hls/stages/census.hpp:281
  logic [9:0] difference_711;
  assign difference_711 = {1'b0, select_556_s18_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_714;
  assign difference_714 = {1'b0, census_memory_rdata_s18_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_718;
  assign difference_718 = {1'b0, census_memory_rdata_s18_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_722;
  assign difference_722 = {1'b0, census_memory_rdata_s18_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_726;
  assign difference_726 = {1'b0, census_memory_rdata_s18_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:317
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:318
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/patches.hpp:156
  logic and_1743;
  assign and_1743 = and_1741_s18_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_1744;
  assign select_1744 = and_1743 ? and_1741_s18_q : patches_choice_valid_q;
  logic [7:0] select_1749;
  assign select_1749 = and_1743 ? select_1748_s18_q : patches_choice_column_q;
  logic [5:0] select_1754;
  assign select_1754 = and_1743 ? select_1753_s18_q : patches_choice_shift_q;
  logic [7:0] select_1780;
  assign select_1780 = and_1743 ? select_1779_s18_q : patches_choice_slope_q;
  // hls/stages/patches.hpp:353
  logic [22:0] select_1804;
  assign select_1804 = and_1803_s18_q ? {select_1780, select_1754, select_1749, select_1744} : patches_choices_rdata_s18_q;
  // hls/stages/patches.hpp:471
  logic [14:0] sum_1908;
  assign sum_1908 = {{4{patches_down_values_3_s18_q[10]}}, patches_down_values_3_s18_q} + {sum_1907_s18_q, sum_1906_s18_q, down_2_s18_q};
  // hls/stages/patches.hpp:450
  logic and_1931;
  assign and_1931 = difference_1927_s18_q[8] & (~(difference_1927_s18_q[7:0] == 8'h0));
  // hls/stages/patches.hpp:453
  logic and_1935;
  assign and_1935 = (~difference_1927_s18_q[14]) & (and_1931 | (~(difference_1927_s18_q[13:9] == 5'h0)));
  // hls/stages/patches.hpp:449
  logic and_1938;
  assign and_1938 = difference_1927_s18_q[14] & (~(difference_1927_s18_q[13:8] == 6'h3f));
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2010;
  assign select_2010 = segment_started_s18_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2011;
  assign sum_2011 = {6'h0, textured_s18_q} + select_2010;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2013;
  assign sum_2013 = {3'h0, sum_2011} + (region_fresh_s18_q ? 10'h0 : regions_rdata_s18_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2015;
  assign select_2015 = segment_started_s18_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2016;
  assign sum_2016 = {6'h0, explained_s18_q} + select_2015;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2018;
  assign sum_2018 = {3'h0, sum_2016} + (region_fresh_s18_q ? 10'h0 : regions_rdata_s18_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2025;
  assign select_2025 = segment_started_s18_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2026;
  assign sum_2026 = {6'h0, and_2024_s18_q} + select_2025;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2028;
  assign sum_2028 = {3'h0, sum_2026} + (region_fresh_s18_q ? 10'h0 : regions_rdata_s18_q[29:20]);
  // hls/stages/agreement.hpp:1275
  logic or_2038;
  assign or_2038 = marks_first_s18_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [12:0] select_2040;
  assign select_2040 = marks_first_s18_q ? 13'h1 : (or_2038 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2042;
  assign select_2042 = or_2038 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2044;
  assign select_2044 = cfg_compete_i ? (or_2038 & select_2040[12]) : (select_2042[8] & select_2040[9]);
  // hls/stages/agreement.hpp:1087
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2070_s18_q} + ({2'h0, and_2071_s18_q} + {1'b0, sum_2075_s18_q});
  // hls/stages/agreement.hpp:1089
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2104_s18_q} + sum_2110_s18_q;
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2112;
  assign select_2112 = age_s18_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1090
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2120_s18_q} + sum_2126_s18_q;
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2128;
  assign select_2128 = age_s18_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2167;
  assign select_2167 = sample_pair_whole_s18_q ? (and_548_s18_q ? grey_s18_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2169;
  assign select_2169 = sample_pair_whole_s18_q ? (and_548_s18_q ? grey_2_s18_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2171;
  assign select_2171 = sample_pair_whole_s18_q ? (and_548_s18_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2173;
  assign select_2173 = sample_pair_whole_s18_q ? (and_548_s18_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2178;
  assign sum_2178 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s18_q};
  logic [9:0] sum_2186;
  assign sum_2186 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s18_q};
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2202;
  assign select_2202 = and_550_s18_q ? select_556_s18_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2203;
  assign select_2203 = and_550_s18_q ? select_560_s18_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2205;
  assign select_2205 = and_550_s18_q ? census_memory_rdata_s18_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2206;
  assign select_2206 = and_550_s18_q ? census_memory_rdata_s18_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2207;
  assign select_2207 = and_550_s18_q ? census_memory_rdata_s18_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2208;
  assign select_2208 = and_550_s18_q ? census_memory_rdata_s18_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_550_s18_q ? census_memory_rdata_s18_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2210;
  assign select_2210 = and_550_s18_q ? census_memory_rdata_s18_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2211;
  assign select_2211 = and_550_s18_q ? census_memory_rdata_s18_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2212;
  assign select_2212 = and_550_s18_q ? census_memory_rdata_s18_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2213;
  assign select_2213 = and_550_s18_q ? census_memory_rdata_s18_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2214;
  assign select_2214 = and_550_s18_q ? census_memory_rdata_s18_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2215;
  assign select_2215 = and_550_s18_q ? census_memory_rdata_s18_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2216;
  assign select_2216 = and_550_s18_q ? census_memory_rdata_s18_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2217;
  assign select_2217 = and_550_s18_q ? census_memory_rdata_s18_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2218;
  assign select_2218 = and_550_s18_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2219;
  assign select_2219 = and_550_s18_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2221;
  assign select_2221 = and_550_s18_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2222;
  assign select_2222 = and_550_s18_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2224;
  assign select_2224 = and_550_s18_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_550_s18_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2227;
  assign select_2227 = and_550_s18_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2228;
  assign select_2228 = and_550_s18_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2229;
  assign select_2229 = and_550_s18_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2231;
  assign select_2231 = and_550_s18_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2232;
  assign select_2232 = and_550_s18_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2234;
  assign select_2234 = and_550_s18_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2235;
  assign select_2235 = and_550_s18_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2237;
  assign select_2237 = and_550_s18_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2238;
  assign select_2238 = and_550_s18_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2240;
  assign select_2240 = and_550_s18_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2241;
  assign select_2241 = and_550_s18_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2243;
  assign select_2243 = and_550_s18_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2244;
  assign select_2244 = and_550_s18_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2246;
  assign select_2246 = and_550_s18_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2247;
  assign select_2247 = and_550_s18_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2250;
  assign select_2250 = and_550_s18_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2251;
  assign select_2251 = and_550_s18_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2254;
  assign select_2254 = and_550_s18_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2255;
  assign select_2255 = and_550_s18_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:283
  logic [9:0] difference_2259;
  assign difference_2259 = {1'b0, select_560_s18_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2262;
  assign difference_2262 = {1'b0, census_memory_rdata_s18_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2266;
  assign difference_2266 = {1'b0, census_memory_rdata_s18_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2270;
  assign difference_2270 = {1'b0, census_memory_rdata_s18_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2274;
  assign difference_2274 = {1'b0, census_memory_rdata_s18_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2296;
  assign sum_2296 = {13'h0, moments_turns_0_q} + (moments_starts_s18_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2298;
  assign sum_2298 = {13'h0, moments_turns_1_q} + (moments_starts_s18_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:788
  logic and_2339;
  assign and_2339 = not_578_s18_q & (equal_579_s18_q & (inside_v_s18_q & and_1598_s18_q));
  logic and_2343;
  assign and_2343 = not_578_s18_q & (equal_579_s18_q & (inside_v_s18_q & and_1607_s18_q));
  // hls/stages/census.hpp:368
  logic [9:0] difference_2370;
  assign difference_2370 = {1'b0, select_556_s18_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2382;
  assign difference_2382 = {1'b0, select_560_s18_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:788
  logic and_2614;
  assign and_2614 = not_576_s18_q & (so_s18_q & (ends_cell_s18_q & explained_s18_q));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2616;
  assign select_2616 = and_2598_s18_q ? 14'h0 : (counts_explained_q + {13'h0, and_2614});
  // hls/stages/agreement.hpp:788
  logic and_2619;
  assign and_2619 = not_576_s18_q & (so_s18_q & (ends_cell_s18_q & and_2024_s18_q));
  // hls/stages/agreement.hpp:1088
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2624_s18_q} + sum_2630_s18_q;
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2632;
  assign select_2632 = age_s18_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1132
  logic less_2648;
  assign less_2648 = region_row_s18_q < x_s18_q[5:3];
  // hls/stages/patches.hpp:345
  logic not_2987;
  assign not_2987 = ~and_1786_s18_q;
  // hls/stages/patches.hpp:505
  logic [27:0] word;
  assign word = or_1892_s18_q ? patches_right_codes_rdata_s18_q : 28'h0;
  // hls/stages/patches.hpp:522
  logic [47:0] select_3157;
  assign select_3157 = new_row_s18_q ? patches_left_codes_rdata_s18_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3159;
  assign select_3159 = equal_1788_s18_q ? patches_left_row_q : (equal_1790_s18_q ? select_3157 : patches_left_row_q);
  logic [4:0] select_3504;
  assign select_3504 = equal_1790_s18_q ? patches_along_s18_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3581;
  assign select_3581 = less_1967_s18_q ? (equal_1970_s18_q ? 10'h3ff : select_3579_s18_q) : 10'h3ff;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3582;
  assign select_3582 = equal_1970_s18_q ? select_3581 : select_3579_s18_q;
  logic [9:0] select_3584;
  assign select_3584 = less_1967_s18_q ? (equal_1968_s18_q ? 10'h3ff : select_3582) : select_3582;
  // hls/stages/patches.hpp:581
  logic [9:0] eight;
  assign eight = high_s18_q - low_s18_q;
  logic [9:0] fall_2;
  assign fall_2 = high_s18_q - select_3586_s18_q[9:0];
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3969;
  assign select_3969 = equal_3707_s18_q ? 14'h0 : product_q;
  logic [13:0] select_3988;
  assign select_3988 = equal_3982_s18_q ? 14'h0 : of_s18_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3969} + {1'b0, select_3988};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4030;
  assign select_4030 = so_s18_q ? (ends_cell_s18_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4032;
  assign select_4032 = ends_cell_s18_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4034;
  assign select_4034 = equal_575_s18_q ? box_explained_columns_values_1_q : (so_s18_q ? select_4032 : box_explained_columns_values_1_q);
  logic [2:0] select_4035;
  assign select_4035 = ends_cell_s18_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4037;
  assign select_4037 = equal_575_s18_q ? box_explained_columns_values_2_q : (so_s18_q ? select_4035 : box_explained_columns_values_2_q);
  logic [2:0] select_4038;
  assign select_4038 = ends_cell_s18_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4040;
  assign select_4040 = equal_575_s18_q ? box_explained_columns_values_3_q : (so_s18_q ? select_4038 : box_explained_columns_values_3_q);
  logic [2:0] select_4041;
  assign select_4041 = ends_cell_s18_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4043;
  assign select_4043 = equal_575_s18_q ? box_explained_columns_values_4_q : (so_s18_q ? select_4041 : box_explained_columns_values_4_q);
  logic [2:0] select_4048;
  assign select_4048 = so_s18_q ? (ends_cell_s18_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4050;
  assign select_4050 = ends_cell_s18_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4052;
  assign select_4052 = equal_575_s18_q ? box_shown_columns_values_1_q : (so_s18_q ? select_4050 : box_shown_columns_values_1_q);
  logic [2:0] select_4053;
  assign select_4053 = ends_cell_s18_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4055;
  assign select_4055 = equal_575_s18_q ? box_shown_columns_values_2_q : (so_s18_q ? select_4053 : box_shown_columns_values_2_q);
  logic [2:0] select_4056;
  assign select_4056 = ends_cell_s18_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4058;
  assign select_4058 = equal_575_s18_q ? box_shown_columns_values_3_q : (so_s18_q ? select_4056 : box_shown_columns_values_3_q);
  logic [2:0] select_4059;
  assign select_4059 = ends_cell_s18_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4061;
  assign select_4061 = equal_575_s18_q ? box_shown_columns_values_4_q : (so_s18_q ? select_4059 : box_shown_columns_values_4_q);
  logic [2:0] select_4066;
  assign select_4066 = so_s18_q ? (ends_cell_s18_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4068;
  assign select_4068 = ends_cell_s18_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4070;
  assign select_4070 = equal_575_s18_q ? box_nearer_columns_values_1_q : (so_s18_q ? select_4068 : box_nearer_columns_values_1_q);
  logic [2:0] select_4071;
  assign select_4071 = ends_cell_s18_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4073;
  assign select_4073 = equal_575_s18_q ? box_nearer_columns_values_2_q : (so_s18_q ? select_4071 : box_nearer_columns_values_2_q);
  logic [2:0] select_4074;
  assign select_4074 = ends_cell_s18_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4076;
  assign select_4076 = equal_575_s18_q ? box_nearer_columns_values_3_q : (so_s18_q ? select_4074 : box_nearer_columns_values_3_q);
  logic [2:0] select_4077;
  assign select_4077 = ends_cell_s18_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4079;
  assign select_4079 = equal_575_s18_q ? box_nearer_columns_values_4_q : (so_s18_q ? select_4077 : box_nearer_columns_values_4_q);

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = last_s18_q;
  logic census_memory_we;
  assign census_memory_we = s18_en & and_550_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s18_q[58:40], census_memory_rdata_s18_q[38:0], and_568_s18_q, whole_2_s18_q, select_560_s18_q, select_556_s18_q};
  end
`ifndef SYNTHESIS
  logic [6:0] census_memory_raddr_s17_sim;
  logic census_memory_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      census_memory_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      census_memory_re_s17_sim <= census_memory_re;
      census_memory_raddr_s17_sim <= census_memory_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && census_memory_we) begin
      if (census_memory_re && census_memory_raddr == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_re_s17_sim && census_memory_raddr_s17_sim == census_memory_waddr) begin
        $error("census_memory: address %0d is read less than DISTANCE steps after its write", census_memory_waddr);
      end
      if (census_memory_waddr >= 7'd120) $error("census_memory: write outside, address %0d", census_memory_waddr);
    end
    if (rst_ni && census_memory_re && census_memory_raddr >= 7'd120) $error("census_memory: read outside, address %0d", census_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s18_2_q;
  logic best_left_we;
  assign best_left_we = s18_en & and_1562_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1561_s18_q, select_1558_s18_q, select_1555_s18_q, select_1553_s18_q, select_1535_s18_q, select_1532_s18_q, select_1524_s18_q, select_1523_s18_q, select_1518_s18_q};
  end
`ifndef SYNTHESIS
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
  logic [6:0] best_left_raddr_s17_sim;
  logic best_left_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_left_re_s8_sim <= 1'b0;
      best_left_re_s9_sim <= 1'b0;
      best_left_re_s10_sim <= 1'b0;
      best_left_re_s11_sim <= 1'b0;
      best_left_re_s12_sim <= 1'b0;
      best_left_re_s13_sim <= 1'b0;
      best_left_re_s14_sim <= 1'b0;
      best_left_re_s15_sim <= 1'b0;
      best_left_re_s16_sim <= 1'b0;
      best_left_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      best_left_re_s8_sim <= best_left_re;
      best_left_raddr_s8_sim <= best_left_raddr;
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
      best_left_re_s17_sim <= best_left_re_s16_sim;
      best_left_raddr_s17_sim <= best_left_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_left_we) begin
      if (best_left_re && best_left_raddr == best_left_waddr) begin
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
      if (best_left_re_s17_sim && best_left_raddr_s17_sim == best_left_waddr) begin
        $error("best_left: address %0d is read less than DISTANCE steps after its write", best_left_waddr);
      end
      if (best_left_waddr >= 7'd120) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 7'd120) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [6:0] best_right_waddr;
  assign best_right_waddr = right_s18_q;
  logic best_right_we;
  assign best_right_we = s18_en & and_1562_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1572_s18_q, select_1571_s18_q, select_1568_s18_q, select_1567_s18_q};
  end
`ifndef SYNTHESIS
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
  logic [6:0] best_right_raddr_s17_sim;
  logic best_right_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      best_right_re_s12_sim <= 1'b0;
      best_right_re_s13_sim <= 1'b0;
      best_right_re_s14_sim <= 1'b0;
      best_right_re_s15_sim <= 1'b0;
      best_right_re_s16_sim <= 1'b0;
      best_right_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      best_right_re_s12_sim <= best_right_re;
      best_right_raddr_s12_sim <= best_right_raddr;
      best_right_re_s13_sim <= best_right_re_s12_sim;
      best_right_raddr_s13_sim <= best_right_raddr_s12_sim;
      best_right_re_s14_sim <= best_right_re_s13_sim;
      best_right_raddr_s14_sim <= best_right_raddr_s13_sim;
      best_right_re_s15_sim <= best_right_re_s14_sim;
      best_right_raddr_s15_sim <= best_right_raddr_s14_sim;
      best_right_re_s16_sim <= best_right_re_s15_sim;
      best_right_raddr_s16_sim <= best_right_raddr_s15_sim;
      best_right_re_s17_sim <= best_right_re_s16_sim;
      best_right_raddr_s17_sim <= best_right_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && best_right_we) begin
      if (best_right_re && best_right_raddr == best_right_waddr) begin
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
      if (best_right_re_s17_sim && best_right_raddr_s17_sim == best_right_waddr) begin
        $error("best_right: address %0d is read less than DISTANCE steps after its write", best_right_waddr);
      end
      if (best_right_waddr >= 7'd120) $error("best_right: write outside, address %0d", best_right_waddr);
    end
    if (rst_ni && best_right_re && best_right_raddr >= 7'd120) $error("best_right: read outside, address %0d", best_right_raddr);
  end
`endif

  // Memory left_turns, write
  logic [6:0] left_turns_waddr;
  assign left_turns_waddr = x_s18_q[6:0];
  logic left_turns_we;
  assign left_turns_we = s18_en & and_1601_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1598_s18_q, and_1595_s18_q};
  end
`ifndef SYNTHESIS
  logic [6:0] left_turns_raddr_s15_sim;
  logic left_turns_re_s15_sim;
  logic [6:0] left_turns_raddr_s16_sim;
  logic left_turns_re_s16_sim;
  logic [6:0] left_turns_raddr_s17_sim;
  logic left_turns_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_turns_re_s15_sim <= 1'b0;
      left_turns_re_s16_sim <= 1'b0;
      left_turns_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      left_turns_re_s15_sim <= left_turns_re;
      left_turns_raddr_s15_sim <= left_turns_raddr;
      left_turns_re_s16_sim <= left_turns_re_s15_sim;
      left_turns_raddr_s16_sim <= left_turns_raddr_s15_sim;
      left_turns_re_s17_sim <= left_turns_re_s16_sim;
      left_turns_raddr_s17_sim <= left_turns_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_turns_we) begin
      if (left_turns_re && left_turns_raddr == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s15_sim && left_turns_raddr_s15_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s16_sim && left_turns_raddr_s16_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_re_s17_sim && left_turns_raddr_s17_sim == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_waddr >= 7'd120) $error("left_turns: write outside, address %0d", left_turns_waddr);
    end
    if (rst_ni && left_turns_re && left_turns_raddr >= 7'd120) $error("left_turns: read outside, address %0d", left_turns_raddr);
  end
`endif

  // Memory right_turns, write
  logic [6:0] right_turns_waddr;
  assign right_turns_waddr = x_s18_q[6:0];
  logic right_turns_we;
  assign right_turns_we = s18_en & and_1601_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1607_s18_q, and_1604_s18_q};
  end
`ifndef SYNTHESIS
  logic [6:0] right_turns_raddr_s15_sim;
  logic right_turns_re_s15_sim;
  logic [6:0] right_turns_raddr_s16_sim;
  logic right_turns_re_s16_sim;
  logic [6:0] right_turns_raddr_s17_sim;
  logic right_turns_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      right_turns_re_s15_sim <= 1'b0;
      right_turns_re_s16_sim <= 1'b0;
      right_turns_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      right_turns_re_s15_sim <= right_turns_re;
      right_turns_raddr_s15_sim <= right_turns_raddr;
      right_turns_re_s16_sim <= right_turns_re_s15_sim;
      right_turns_raddr_s16_sim <= right_turns_raddr_s15_sim;
      right_turns_re_s17_sim <= right_turns_re_s16_sim;
      right_turns_raddr_s17_sim <= right_turns_raddr_s16_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_turns_we) begin
      if (right_turns_re && right_turns_raddr == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s15_sim && right_turns_raddr_s15_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s16_sim && right_turns_raddr_s16_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_re_s17_sim && right_turns_raddr_s17_sim == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_waddr >= 7'd120) $error("right_turns: write outside, address %0d", right_turns_waddr);
    end
    if (rst_ni && right_turns_re && right_turns_raddr >= 7'd120) $error("right_turns: read outside, address %0d", right_turns_raddr);
  end
`endif

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s18_q, and_1702_s18_q};
  logic patches_choices_we;
  assign patches_choices_we = s18_en & and_1787_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {select_1780, select_1754, select_1749, select_1744};
  end
`ifndef SYNTHESIS
  logic [5:0] patches_choices_raddr_s17_sim;
  logic patches_choices_re_s17_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choices_re_s17_sim <= 1'b0;
    end else if (en_i) begin
      patches_choices_re_s17_sim <= patches_choices_re;
      patches_choices_raddr_s17_sim <= patches_choices_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_choices_we) begin
      if (patches_choices_re && patches_choices_raddr == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
      if (patches_choices_re_s17_sim && patches_choices_raddr_s17_sim == patches_choices_waddr) begin
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
    end else if (s18_en) begin
      moments_turned_0_q <= sum_2296;
      moments_turned_1_q <= sum_2298;
      moments_turns_0_q <= not_576_s18_q & and_2339;
      moments_turns_1_q <= not_576_s18_q & and_2343;
      counts_explained_q <= select_2616;
      patches_fixed_q <= not_2987 & (patches_fixed_q | (and_2997_s18_q & and_1743));
      patches_choice_valid_q <= and_1786_s18_q ? (select_1744 & not_2987) : select_1744;
      patches_choice_column_q <= select_1749;
      patches_choice_shift_q <= select_1754;
      patches_choice_slope_q <= select_1780;
      patches_left_row_q <= select_3159;
      patches_summed_row_column_q <= equal_1788_s18_q ? patches_summed_row_column_q : select_3504;
      patches_read_far_q <= equal_1788_s18_q ? select_3584 : patches_read_far_q;
      segment_textured_q <= select_2010 + {6'h0, and_2609_s18_q};
      segment_explained_q <= select_2015 + {6'h0, and_2614};
      segment_nearer_q <= select_2025 + {6'h0, and_2619};
      product_q <= equal_575_s18_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2040;
      columns_passed_q <= {select_2042[7:0], or_2038};
      line_ended_q <= marks_last_s18_q;
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
    if (s18_en) begin
      averager_quarter_1_0_q <= select_2167;
      averager_quarter_1_1_q <= select_2169;
      averager_quarter_2_0_q <= select_2171;
      averager_quarter_2_1_q <= select_2173;
      census_columns_values_0_cell_0_left_q <= select_2202;
      census_columns_values_0_cell_0_right_q <= select_2203;
      census_columns_values_0_cell_1_left_q <= select_2205;
      census_columns_values_0_cell_1_right_q <= select_2206;
      census_columns_values_0_cell_1_mask_q <= select_2207;
      census_columns_values_0_cell_2_left_q <= select_2208;
      census_columns_values_0_cell_2_right_q <= select_2209;
      census_columns_values_0_cell_2_mask_q <= select_2210;
      census_columns_values_0_cell_2_of_skin_q <= select_2211;
      census_columns_values_0_cell_3_left_q <= select_2212;
      census_columns_values_0_cell_3_right_q <= select_2213;
      census_columns_values_0_cell_3_mask_q <= select_2214;
      census_columns_values_0_cell_4_left_q <= select_2215;
      census_columns_values_0_cell_4_right_q <= select_2216;
      census_columns_values_0_cell_4_mask_q <= select_2217;
      census_columns_values_1_cell_0_left_q <= select_2218;
      census_columns_values_1_cell_0_right_q <= select_2219;
      census_columns_values_1_cell_1_left_q <= select_2221;
      census_columns_values_1_cell_1_right_q <= select_2222;
      census_columns_values_1_cell_2_left_q <= select_2224;
      census_columns_values_1_cell_2_right_q <= select_2225;
      census_columns_values_1_cell_2_of_skin_q <= select_2227;
      census_columns_values_1_cell_3_left_q <= select_2228;
      census_columns_values_1_cell_3_right_q <= select_2229;
      census_columns_values_1_cell_4_left_q <= select_2231;
      census_columns_values_1_cell_4_right_q <= select_2232;
      census_columns_values_2_cell_0_left_q <= select_2234;
      census_columns_values_2_cell_0_right_q <= select_2235;
      census_columns_values_2_cell_1_left_q <= select_2237;
      census_columns_values_2_cell_1_right_q <= select_2238;
      census_columns_values_2_cell_2_left_q <= select_2240;
      census_columns_values_2_cell_2_right_q <= select_2241;
      census_columns_values_2_cell_3_left_q <= select_2243;
      census_columns_values_2_cell_3_right_q <= select_2244;
      census_columns_values_2_cell_4_left_q <= select_2246;
      census_columns_values_2_cell_4_right_q <= select_2247;
      census_columns_values_3_cell_1_left_q <= select_2250;
      census_columns_values_3_cell_1_right_q <= select_2251;
      census_columns_values_3_cell_3_left_q <= select_2254;
      census_columns_values_3_cell_3_right_q <= select_2255;
      sharpness_last_mean_0_q <= and_550_s18_q ? select_556_s18_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_550_s18_q ? select_560_s18_q : sharpness_last_mean_1_q;
      box_explained_columns_values_0_q <= equal_575_s18_q ? box_explained_columns_values_0_q : select_4030;
      box_explained_columns_values_1_q <= select_4034;
      box_explained_columns_values_2_q <= select_4037;
      box_explained_columns_values_3_q <= select_4040;
      box_explained_columns_values_4_q <= select_4043;
      box_shown_columns_values_0_q <= equal_575_s18_q ? box_shown_columns_values_0_q : select_4048;
      box_shown_columns_values_1_q <= select_4052;
      box_shown_columns_values_2_q <= select_4055;
      box_shown_columns_values_3_q <= select_4058;
      box_shown_columns_values_4_q <= select_4061;
      box_nearer_columns_values_0_q <= equal_575_s18_q ? box_nearer_columns_values_0_q : select_4066;
      box_nearer_columns_values_1_q <= select_4070;
      box_nearer_columns_values_2_q <= select_4073;
      box_nearer_columns_values_3_q <= select_4076;
      box_nearer_columns_values_4_q <= select_4079;
    end
  end

  logic [7:0] pixel_0_s19_q;
  logic [7:0] pixel_1_s19_q;
  logic saturated_s19_q;
  logic mask_s19_q;
  logic marks_first_s19_q;
  logic [7:0] sample_pair_pixel_0_s19_q;
  logic [7:0] sample_pair_pixel_1_s19_q;
  logic sample_pair_whole_s19_q;
  logic sample_present_s19_q;
  logic census_columns_values_0_cell_1_mask_s19_q;
  logic census_columns_values_0_cell_2_mask_s19_q;
  logic census_columns_values_0_cell_3_mask_s19_q;
  logic census_columns_values_0_cell_4_mask_s19_q;
  logic census_columns_values_1_cell_2_of_skin_s19_q;
  logic [7:0] x_s19_q;
  logic age_s19_q;
  logic [2:0] slot_s19_q;
  logic ends_cell_s19_q;
  logic lower_half_s19_q;
  logic [13:0] counts_textured_s19_q;
  logic [13:0] counts_explained_s19_q;
  logic registration_of_right_s19_q;
  logic patches_lower_s19_q;
  logic patches_second_s19_q;
  logic [4:0] patches_code_row_s19_q;
  logic [4:0] patches_summed_row_column_s19_q;
  logic patches_summed_last_s19_q;
  logic [4:0] patches_summed_down_by_s19_q;
  logic patches_read_first_s19_q;
  logic [9:0] patches_read_far_s19_q;
  logic [2:0] region_row_s19_q;
  logic [13:0] product_s19_q;
  logic centres_values_1_textured_s19_q;
  logic centres_values_1_of_skin_s19_q;
  logic [3:0] select_508_s19_q;
  logic [6:0] select_511_s19_q;
  logic [6:0] last_s19_q;
  logic and_548_s19_q;
  logic and_550_s19_q;
  logic equal_553_s19_q;
  logic whole_2_s19_q;
  logic equal_570_s19_q;
  logic equal_575_s19_q;
  logic not_576_s19_q;
  logic so_s19_q;
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
  logic and_688_s19_q;
  logic difference_711_s19_q;
  logic [8:0] xor_712_s19_q;
  logic difference_714_s19_q;
  logic [8:0] xor_715_s19_q;
  logic difference_718_s19_q;
  logic [8:0] xor_719_s19_q;
  logic difference_722_s19_q;
  logic [8:0] xor_723_s19_q;
  logic difference_726_s19_q;
  logic [8:0] xor_727_s19_q;
  logic [9:0] half_grey_levels_s19_q;
  logic [9:0] half_grey_levels_2_s19_q;
  logic equal_1608_s19_q;
  logic all_s19_q;
  logic [1:0] sum_1614_s19_q;
  logic equal_1616_s19_q;
  logic equal_1618_s19_q;
  logic equal_1620_s19_q;
  logic equal_1622_s19_q;
  logic equal_1624_s19_q;
  logic equal_1626_s19_q;
  logic equal_1628_s19_q;
  logic equal_1630_s19_q;
  logic less_1639_s19_q;
  logic or_1643_s19_q;
  logic [31:0] registration_sums_rdata_s19_q;
  logic equal_1663_s19_q;
  logic and_1673_s19_q;
  logic and_1676_s19_q;
  logic select_1693_s19_q;
  logic equal_1694_s19_q;
  logic equal_1704_s19_q;
  logic equal_1788_s19_q;
  logic equal_1790_s19_q;
  logic equal_1793_s19_q;
  logic or_1794_s19_q;
  logic [22:0] select_1804_s19_q;
  logic [4:0] select_1818_s19_q;
  logic select_1824_s19_q;
  logic [3:0] select_1863_s19_q;
  logic less_1879_s19_q;
  logic new_row_s19_q;
  logic [1:0] of_row_2_s19_q;
  logic not_1909_s19_q;
  logic and_1912_s19_q;
  logic not_1914_s19_q;
  logic and_1919_s19_q;
  logic and_1935_s19_q;
  logic and_1938_s19_q;
  logic and_1952_s19_q;
  logic and_1961_s19_q;
  logic and_1966_s19_q;
  logic less_1967_s19_q;
  logic equal_1968_s19_q;
  logic not_1969_s19_q;
  logic equal_1970_s19_q;
  logic or_1989_s19_q;
  logic or_1992_s19_q;
  logic or_1995_s19_q;
  logic not_1997_s19_q;
  logic [9:0] sum_2013_s19_q;
  logic [9:0] sum_2018_s19_q;
  logic [9:0] sum_2028_s19_q;
  logic and_2029_s19_q;
  logic select_2044_s19_q;
  logic [2:0] textured_2_s19_q;
  logic or_2087_s19_q;
  logic or_2090_s19_q;
  logic or_2093_s19_q;
  logic [3:0] difference_2113_s19_q;
  logic [3:0] difference_2129_s19_q;
  logic and_2143_s19_q;
  logic sum_2178_s19_q;
  logic [9:0] difference_2179_s19_q;
  logic sum_2186_s19_q;
  logic [9:0] difference_2187_s19_q;
  logic difference_2259_s19_q;
  logic [8:0] xor_2260_s19_q;
  logic difference_2262_s19_q;
  logic [8:0] xor_2263_s19_q;
  logic difference_2266_s19_q;
  logic [8:0] xor_2267_s19_q;
  logic difference_2270_s19_q;
  logic [8:0] xor_2271_s19_q;
  logic difference_2274_s19_q;
  logic [8:0] xor_2275_s19_q;
  logic equal_2284_s19_q;
  logic equal_2299_s19_q;
  logic difference_2370_s19_q;
  logic [8:0] xor_2371_s19_q;
  logic difference_2382_s19_q;
  logic [8:0] xor_2383_s19_q;
  logic equal_2473_s19_q;
  logic and_2598_s19_q;
  logic and_2604_s19_q;
  logic and_2619_s19_q;
  logic not_2623_s19_q;
  logic [3:0] difference_2633_s19_q;
  logic [9:0] select_2649_s19_q;
  logic [9:0] select_2652_s19_q;
  logic and_2700_s19_q;
  logic and_2717_s19_q;
  logic and_2724_s19_q;
  logic and_2758_s19_q;
  logic and_2759_s19_q;
  logic [7:0] residual_s19_q;
  logic and_2795_s19_q;
  logic and_2809_s19_q;
  logic equal_2852_s19_q;
  logic [27:0] word_s19_q;
  logic equal_3118_s19_q;
  logic less_3124_s19_q;
  logic [47:0] select_3157_s19_q;
  logic equal_3467_s19_q;
  logic [4:0] select_3555_s19_q;
  logic [14:0] select_3586_s19_q;
  logic less_3629_s19_q;
  logic [9:0] eight_s19_q;
  logic [9:0] fall_2_s19_q;
  logic equal_3707_s19_q;
  logic and_3932_s19_q;
  logic less_3933_s19_q;
  logic equal_3934_s19_q;
  logic equal_3951_s19_q;
  logic equal_3953_s19_q;
  logic equal_3954_s19_q;
  logic equal_3955_s19_q;
  logic equal_3956_s19_q;
  logic sum_4_s19_q;
  logic equal_4096_s19_q;
  logic equal_4192_s19_q;
  logic [9:0] select_4202_s19_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s19_q <= pixel_0_s18_q;
      pixel_1_s19_q <= pixel_1_s18_q;
      saturated_s19_q <= saturated_s18_q;
      mask_s19_q <= mask_s18_q;
      marks_first_s19_q <= marks_first_s18_q;
      sample_pair_pixel_0_s19_q <= sample_pair_pixel_0_s18_q;
      sample_pair_pixel_1_s19_q <= sample_pair_pixel_1_s18_q;
      sample_pair_whole_s19_q <= sample_pair_whole_s18_q;
      sample_present_s19_q <= sample_present_s18_q;
      census_columns_values_0_cell_1_mask_s19_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s19_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s19_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s19_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s19_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s19_q <= x_s18_q;
      age_s19_q <= age_s18_q;
      slot_s19_q <= slot_s18_q;
      ends_cell_s19_q <= ends_cell_s18_q;
      lower_half_s19_q <= lower_half_s18_q;
      counts_textured_s19_q <= counts_textured_s18_q;
      counts_explained_s19_q <= counts_explained_q;
      registration_of_right_s19_q <= registration_of_right_s18_q;
      patches_lower_s19_q <= patches_lower_s18_q;
      patches_second_s19_q <= patches_second_s18_q;
      patches_code_row_s19_q <= patches_code_row_s18_q;
      patches_summed_row_column_s19_q <= patches_summed_row_column_q;
      patches_summed_last_s19_q <= patches_summed_last_s18_q;
      patches_summed_down_by_s19_q <= patches_summed_down_by_s18_q;
      patches_read_first_s19_q <= patches_read_first_s18_q;
      patches_read_far_s19_q <= patches_read_far_q;
      region_row_s19_q <= region_row_s18_q;
      product_s19_q <= product_q;
      centres_values_1_textured_s19_q <= centres_values_1_textured_s18_q;
      centres_values_1_of_skin_s19_q <= centres_values_1_of_skin_s18_q;
      select_508_s19_q <= select_508_s18_q;
      select_511_s19_q <= select_511_s18_q;
      last_s19_q <= last_s18_q;
      and_548_s19_q <= and_548_s18_q;
      and_550_s19_q <= and_550_s18_q;
      equal_553_s19_q <= equal_553_s18_q;
      whole_2_s19_q <= whole_2_s18_q;
      equal_570_s19_q <= equal_570_s18_q;
      equal_575_s19_q <= equal_575_s18_q;
      not_576_s19_q <= not_576_s18_q;
      so_s19_q <= so_s18_q;
      less_653_s19_q <= less_653;
      less_654_s19_q <= less_654;
      less_655_s19_q <= less_655;
      less_656_s19_q <= less_656;
      less_657_s19_q <= less_657;
      less_658_s19_q <= less_658;
      less_659_s19_q <= less_659;
      less_660_s19_q <= less_660;
      less_661_s19_q <= less_661;
      less_662_s19_q <= less_662;
      less_663_s19_q <= less_663;
      less_664_s19_q <= less_664;
      less_665_s19_q <= less_665;
      less_666_s19_q <= less_666;
      less_667_s19_q <= less_667;
      less_668_s19_q <= less_668;
      less_669_s19_q <= less_669;
      less_670_s19_q <= less_670;
      less_671_s19_q <= less_671;
      less_672_s19_q <= less_672;
      less_673_s19_q <= less_673;
      less_674_s19_q <= less_674;
      less_675_s19_q <= less_675;
      less_676_s19_q <= less_676;
      and_684_s19_q <= and_684_s18_q;
      and_688_s19_q <= and_688;
      difference_711_s19_q <= difference_711[9];
      xor_712_s19_q <= difference_711[8:0] ^ {9{difference_711[9]}};
      difference_714_s19_q <= difference_714[9];
      xor_715_s19_q <= difference_714[8:0] ^ {9{difference_714[9]}};
      difference_718_s19_q <= difference_718[9];
      xor_719_s19_q <= difference_718[8:0] ^ {9{difference_718[9]}};
      difference_722_s19_q <= difference_722[9];
      xor_723_s19_q <= difference_722[8:0] ^ {9{difference_722[9]}};
      difference_726_s19_q <= difference_726[9];
      xor_727_s19_q <= difference_726[8:0] ^ {9{difference_726[9]}};
      half_grey_levels_s19_q <= half_grey_levels;
      half_grey_levels_2_s19_q <= half_grey_levels_2;
      equal_1608_s19_q <= equal_1608_s18_q;
      all_s19_q <= all_s18_q;
      sum_1614_s19_q <= sum_1614_s18_q;
      equal_1616_s19_q <= equal_1616_s18_q;
      equal_1618_s19_q <= equal_1618_s18_q;
      equal_1620_s19_q <= equal_1620_s18_q;
      equal_1622_s19_q <= equal_1622_s18_q;
      equal_1624_s19_q <= equal_1624_s18_q;
      equal_1626_s19_q <= equal_1626_s18_q;
      equal_1628_s19_q <= equal_1628_s18_q;
      equal_1630_s19_q <= equal_1630_s18_q;
      less_1639_s19_q <= less_1639_s18_q;
      or_1643_s19_q <= or_1643_s18_q;
      registration_sums_rdata_s19_q <= registration_sums_rdata_q;
      equal_1663_s19_q <= equal_1663_s18_q;
      and_1673_s19_q <= and_1673_s18_q;
      and_1676_s19_q <= and_1676_s18_q;
      select_1693_s19_q <= select_1693_s18_q;
      equal_1694_s19_q <= equal_1694_s18_q;
      equal_1704_s19_q <= equal_1704_s18_q;
      equal_1788_s19_q <= equal_1788_s18_q;
      equal_1790_s19_q <= equal_1790_s18_q;
      equal_1793_s19_q <= equal_1793_s18_q;
      or_1794_s19_q <= or_1794_s18_q;
      select_1804_s19_q <= select_1804;
      select_1818_s19_q <= select_1818_s18_q;
      select_1824_s19_q <= select_1824_s18_q;
      select_1863_s19_q <= select_1863_s18_q;
      less_1879_s19_q <= less_1879_s18_q;
      new_row_s19_q <= new_row_s18_q;
      of_row_2_s19_q <= of_row_2_s18_q;
      not_1909_s19_q <= ~sum_1908[14];
      and_1912_s19_q <= sum_1908[8] & (~(sum_1908[7:0] == 8'h0));
      not_1914_s19_q <= ~(sum_1908[13:9] == 5'h0);
      and_1919_s19_q <= sum_1908[14] & (~(sum_1908[13:8] == 6'h3f));
      and_1935_s19_q <= and_1935;
      and_1938_s19_q <= and_1938;
      and_1952_s19_q <= and_1952_s18_q;
      and_1961_s19_q <= and_1961_s18_q;
      and_1966_s19_q <= and_1966_s18_q;
      less_1967_s19_q <= less_1967_s18_q;
      equal_1968_s19_q <= equal_1968_s18_q;
      not_1969_s19_q <= not_1969_s18_q;
      equal_1970_s19_q <= equal_1970_s18_q;
      or_1989_s19_q <= or_1989_s18_q;
      or_1992_s19_q <= or_1992_s18_q;
      or_1995_s19_q <= or_1995_s18_q;
      not_1997_s19_q <= not_1997_s18_q;
      sum_2013_s19_q <= sum_2013;
      sum_2018_s19_q <= sum_2018;
      sum_2028_s19_q <= sum_2028;
      and_2029_s19_q <= and_2029_s18_q;
      select_2044_s19_q <= select_2044;
      textured_2_s19_q <= textured_2;
      or_2087_s19_q <= or_2087_s18_q;
      or_2090_s19_q <= or_2090_s18_q;
      or_2093_s19_q <= or_2093_s18_q;
      difference_2113_s19_q <= {1'b0, shown_2} - {1'b0, select_2112};
      difference_2129_s19_q <= {1'b0, near_2} - {1'b0, select_2128};
      and_2143_s19_q <= and_2143_s18_q;
      sum_2178_s19_q <= sum_2178[0];
      difference_2179_s19_q <= {1'b0, sum_2178[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2186_s19_q <= sum_2186[0];
      difference_2187_s19_q <= {1'b0, sum_2186[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2259_s19_q <= difference_2259[9];
      xor_2260_s19_q <= difference_2259[8:0] ^ {9{difference_2259[9]}};
      difference_2262_s19_q <= difference_2262[9];
      xor_2263_s19_q <= difference_2262[8:0] ^ {9{difference_2262[9]}};
      difference_2266_s19_q <= difference_2266[9];
      xor_2267_s19_q <= difference_2266[8:0] ^ {9{difference_2266[9]}};
      difference_2270_s19_q <= difference_2270[9];
      xor_2271_s19_q <= difference_2270[8:0] ^ {9{difference_2270[9]}};
      difference_2274_s19_q <= difference_2274[9];
      xor_2275_s19_q <= difference_2274[8:0] ^ {9{difference_2274[9]}};
      equal_2284_s19_q <= equal_2284_s18_q;
      equal_2299_s19_q <= equal_2299_s18_q;
      difference_2370_s19_q <= difference_2370[9];
      xor_2371_s19_q <= difference_2370[8:0] ^ {9{difference_2370[9]}};
      difference_2382_s19_q <= difference_2382[9];
      xor_2383_s19_q <= difference_2382[8:0] ^ {9{difference_2382[9]}};
      equal_2473_s19_q <= equal_2473_s18_q;
      and_2598_s19_q <= and_2598_s18_q;
      and_2604_s19_q <= and_2604_s18_q;
      and_2619_s19_q <= and_2619;
      not_2623_s19_q <= not_2623_s18_q;
      difference_2633_s19_q <= {1'b0, explained_2} - {1'b0, select_2632};
      select_2649_s19_q <= less_2648 ? 10'h0 : regions_rdata_s18_q[9:0];
      select_2652_s19_q <= less_2648 ? 10'h0 : regions_rdata_s18_q[19:10];
      and_2700_s19_q <= and_2700_s18_q;
      and_2717_s19_q <= and_2717_s18_q;
      and_2724_s19_q <= and_2724_s18_q;
      and_2758_s19_q <= and_2758_s18_q;
      and_2759_s19_q <= and_2759_s18_q;
      residual_s19_q <= residual_s18_q;
      and_2795_s19_q <= and_2759_s18_q & less_2794_s18_q;
      and_2809_s19_q <= and_2759_s18_q & less_2808_s18_q;
      equal_2852_s19_q <= equal_2852_s18_q;
      word_s19_q <= word;
      equal_3118_s19_q <= patches_along_s18_q == 5'h7;
      less_3124_s19_q <= less_3124_s18_q;
      select_3157_s19_q <= select_3157;
      equal_3467_s19_q <= equal_3467_s18_q;
      select_3555_s19_q <= select_3555_s18_q;
      select_3586_s19_q <= select_3586_s18_q;
      less_3629_s19_q <= less_3629_s18_q;
      eight_s19_q <= eight;
      fall_2_s19_q <= fall_2;
      equal_3707_s19_q <= equal_3707_s18_q;
      and_3932_s19_q <= and_3932_s18_q;
      less_3933_s19_q <= counts_explained_q < product_q;
      equal_3934_s19_q <= counts_explained_q == product_q;
      equal_3951_s19_q <= equal_3951_s18_q;
      equal_3953_s19_q <= equal_3953_s18_q;
      equal_3954_s19_q <= equal_3954_s18_q;
      equal_3955_s19_q <= equal_3955_s18_q;
      equal_3956_s19_q <= equal_3956_s18_q;
      sum_4_s19_q <= sum_4[0];
      equal_4096_s19_q <= equal_4096_s18_q;
      equal_4192_s19_q <= equal_4192_s18_q;
      select_4202_s19_q <= less_2648 ? 10'h0 : regions_rdata_s18_q[29:20];
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
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
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_688_s19_q;
  logic whole_4;
  assign whole_4 = census_columns_values_0_cell_1_mask_s19_q & whole_3;
  logic whole_5;
  assign whole_5 = census_columns_values_0_cell_2_mask_s19_q & whole_4;
  logic whole_6;
  assign whole_6 = census_columns_values_0_cell_3_mask_s19_q & whole_5;
  logic whole_7;
  assign whole_7 = census_columns_values_0_cell_4_mask_s19_q & whole_6;
  logic whole_8;
  assign whole_8 = census_columns_values_1_cell_0_mask_q & whole_7;
  logic whole_9;
  assign whole_9 = census_columns_values_1_cell_1_mask_q & whole_8;
  // hls/stages/census.hpp:281
  logic [9:0] sum_713;
  assign sum_713 = {9'h0, difference_711_s19_q} + {1'b0, xor_712_s19_q};
  logic [9:0] sum_716;
  assign sum_716 = {9'h0, difference_714_s19_q} + {1'b0, xor_715_s19_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_738;
  assign sum_738 = {half_grey_levels_s19_q[9], half_grey_levels_s19_q[9:4]} + 7'h7f;
  logic less_739;
  assign less_739 = {{5{sum_738[6]}}, sum_738, half_grey_levels_s19_q[3:0]} < 16'hffe1;
  logic [6:0] sum_744;
  assign sum_744 = {half_grey_levels_2_s19_q[9], half_grey_levels_2_s19_q[9:4]} + 7'h7f;
  logic less_745;
  assign less_745 = {{5{sum_744[6]}}, sum_744, half_grey_levels_2_s19_q[3:0]} < 16'hffe1;
  // hls/stages/registration.hpp:265
  logic equal_1665;
  assign equal_1665 = sum_1614_s19_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1614_s19_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1671;
  assign select_1671 = equal_1665 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1672;
  assign sum_1672 = (equal_1663_s19_q ? registration_sums_rdata_s19_q[31:20] : 12'h0) + {{5{select_1671[6]}}, select_1671};
  // hls/stages/patches.hpp:354
  logic [21:0] select_1807;
  assign select_1807 = select_1693_s19_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1804_s19_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1808;
  assign select_1808 = equal_1694_s19_q ? patches_place_0_column_q : select_1807[7:0];
  logic [5:0] select_1809;
  assign select_1809 = equal_1694_s19_q ? patches_place_0_shift_q : select_1807[13:8];
  // hls/stages/patches.hpp:354
  logic [21:0] select_1836;
  assign select_1836 = select_1693_s19_q ? select_1804_s19_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1837;
  assign select_1837 = equal_1694_s19_q ? patches_place_1_column_q : select_1836[7:0];
  logic [5:0] select_1838;
  assign select_1838 = equal_1694_s19_q ? patches_place_1_shift_q : select_1836[13:8];
  // hls/stages/patches.hpp:132
  logic equal_1854;
  assign equal_1854 = {select_1808[7], select_511_s19_q, select_508_s19_q} == {1'b0, select_1808[6:0], 4'h0};
  logic equal_1858;
  assign equal_1858 = {select_1837[7], select_511_s19_q, select_508_s19_q} == {1'b0, select_1837[6:0], 4'h0};
  // hls/stages/patches.hpp:486
  logic [2:0] sum_1900;
  assign sum_1900 = patches_code_row_s19_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:453
  logic and_1916;
  assign and_1916 = not_1909_s19_q & (and_1912_s19_q | not_1914_s19_q);
  // hls/stages/patches.hpp:490
  logic [1:0] sum_1956;
  assign sum_1956 = patches_code_row_s19_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2044_s19_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2047;
  assign select_2047 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1301
  logic equal_2050;
  assign equal_2050 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1274
  logic not_2057;
  assign not_2057 = ~marks_first_s19_q;
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2078;
  assign select_2078 = age_s19_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2094;
  assign not_2094 = ~region_row_s19_q[2];
  logic [2:0] select_2095;
  assign select_2095 = region_row_s19_q[1] ? {1'b0, not_2094, 1'b0} : {region_row_s19_q[2], 1'b0, not_2094};
  logic [5:0] select_2096;
  assign select_2096 = region_row_s19_q[0] ? {select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0], 1'b0} : {1'b0, select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0]};
  logic [11:0] select_2097;
  assign select_2097 = or_2093_s19_q ? {select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0], 1'b0} : {1'b0, select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0]};
  logic [23:0] select_2098;
  assign select_2098 = or_2090_s19_q ? {select_2097[11], 1'b0, select_2097[10], 1'b0, select_2097[9], 1'b0, select_2097[8], 1'b0, select_2097[7], 1'b0, select_2097[6], 1'b0, select_2097[5], 1'b0, select_2097[4], 1'b0, select_2097[3], 1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0], 1'b0} : {1'b0, select_2097[11], 1'b0, select_2097[10], 1'b0, select_2097[9], 1'b0, select_2097[8], 1'b0, select_2097[7], 1'b0, select_2097[6], 1'b0, select_2097[5], 1'b0, select_2097[4], 1'b0, select_2097[3], 1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0]};
  // hls/stages/agreement.hpp:1096
  logic [4:0] around;
  assign around = {difference_2113_s19_q[3], difference_2113_s19_q} + (equal_570_s19_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1097
  logic [4:0] n;
  assign n = {difference_2129_s19_q[3], difference_2129_s19_q} + (equal_570_s19_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:218
  logic [9:0] xor_2180;
  assign xor_2180 = {difference_2179_s19_q[8:0], sum_2178_s19_q} ^ {10{difference_2179_s19_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2179_s19_q[9]} + {1'b0, xor_2180};
  logic [9:0] xor_2188;
  assign xor_2188 = {difference_2187_s19_q[8:0], sum_2186_s19_q} ^ {10{difference_2187_s19_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2187_s19_q[9]} + {1'b0, xor_2188};
  // hls/stages/agreement.hpp:520
  logic select_2204;
  assign select_2204 = and_550_s19_q ? whole_2_s19_q : census_columns_values_0_cell_0_mask_q;
  logic select_2220;
  assign select_2220 = and_550_s19_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2223;
  assign select_2223 = and_550_s19_q ? census_columns_values_0_cell_1_mask_s19_q : census_columns_values_1_cell_1_mask_q;
  logic select_2230;
  assign select_2230 = and_550_s19_q ? census_columns_values_0_cell_3_mask_s19_q : census_columns_values_1_cell_3_mask_q;
  logic select_2233;
  assign select_2233 = and_550_s19_q ? census_columns_values_0_cell_4_mask_s19_q : census_columns_values_1_cell_4_mask_q;
  logic select_2236;
  assign select_2236 = and_550_s19_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2239;
  assign select_2239 = and_550_s19_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:283
  logic [9:0] sum_2261;
  assign sum_2261 = {9'h0, difference_2259_s19_q} + {1'b0, xor_2260_s19_q};
  logic [9:0] sum_2264;
  assign sum_2264 = {9'h0, difference_2262_s19_q} + {1'b0, xor_2263_s19_q};
  // hls/stages/moments.hpp:117
  logic [13:0] select_2300;
  assign select_2300 = equal_2299_s19_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2302;
  assign select_2302 = equal_2299_s19_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2313;
  assign sum_2313 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2323;
  assign sum_2323 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/census.hpp:368
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2370_s19_q} + xor_2371_s19_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2382_s19_q} + xor_2383_s19_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2606;
  assign select_2606 = and_2598_s19_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2604_s19_q});
  logic [13:0] select_2621;
  assign select_2621 = and_2598_s19_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2619_s19_q});
  // hls/stages/agreement.hpp:1095
  logic [4:0] e;
  assign e = {difference_2633_s19_q[3], difference_2633_s19_q} + (equal_570_s19_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2719;
  assign select_2719 = and_2598_s19_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2717_s19_q});
  logic [13:0] select_2726;
  assign select_2726 = and_2598_s19_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2724_s19_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2776;
  assign select_2776 = equal_1704_s19_q ? (and_2759_s19_q ? residual_s19_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_2783;
  assign and_2783 = not_576_s19_q & (so_s19_q & (and_2759_s19_q & equal_1704_s19_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2785;
  assign select_2785 = and_2758_s19_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2783});
  // hls/stages/registration.hpp:107
  logic and_2787;
  assign and_2787 = and_2759_s19_q & ($signed(residual_s19_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2789;
  assign select_2789 = so_s19_q ? (equal_1704_s19_q ? {and_2787, and_2759_s19_q} : 2'h0) : 2'h0;
  logic [1:0] select_2797;
  assign select_2797 = so_s19_q ? (equal_1704_s19_q ? {and_2795_s19_q, and_2759_s19_q} : 2'h0) : 2'h0;
  logic [1:0] select_2798;
  assign select_2798 = equal_575_s19_q ? 2'h0 : select_2797;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2799;
  assign sum_2799 = registration_half_votes_up_q + {{5{select_2798[1]}}, select_2798};
  // hls/stages/registration.hpp:205
  logic less_2801;
  assign less_2801 = $signed(residual_s19_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2802;
  assign and_2802 = and_2759_s19_q & less_2801;
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2804;
  assign select_2804 = so_s19_q ? (equal_1704_s19_q ? {and_2802, and_2759_s19_q} : 2'h0) : 2'h0;
  logic [1:0] select_2811;
  assign select_2811 = so_s19_q ? (equal_1704_s19_q ? {and_2809_s19_q, and_2759_s19_q} : 2'h0) : 2'h0;
  logic [1:0] select_2812;
  assign select_2812 = equal_575_s19_q ? 2'h0 : select_2811;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2813;
  assign sum_2813 = registration_half_half_votes_up_q + {{5{select_2812[1]}}, select_2812};
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2854;
  assign select_2854 = or_1643_s19_q ? 12'h0 : (equal_2852_s19_q ? registration_sums_rdata_s19_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2856;
  assign select_2856 = equal_1608_s19_q ? 12'h0 : (less_1639_s19_q ? select_2854 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2859;
  assign and_2859 = x_s19_q[1] & all_s19_q;
  // hls/stages/agreement.hpp:1142
  logic and_2862;
  assign and_2862 = not_1997_s19_q & (less_1639_s19_q & ({and_2859, x_s19_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2869;
  assign select_2869 = or_1643_s19_q ? 12'h0 : (equal_2852_s19_q ? registration_sums_rdata_s19_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2871;
  assign select_2871 = equal_1608_s19_q ? 12'h0 : (less_1639_s19_q ? select_2869 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2877;
  assign not_2877 = ~all_s19_q;
  // hls/stages/agreement.hpp:1142
  logic and_2880;
  assign and_2880 = not_1997_s19_q & (less_1639_s19_q & (x_s19_q[2:0] == {all_s19_q, not_2877, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2886;
  assign and_2886 = equal_575_s19_q & (x_s19_q[6] & (not_1997_s19_q & (less_1639_s19_q & all_s19_q)));
  // hls/stages/registration.hpp:157
  logic equal_2913;
  assign equal_2913 = x_s19_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2916;
  assign and_2916 = not_1997_s19_q & (less_1639_s19_q & (x_s19_q[5] ? x_s19_q[3] : equal_2913));
  logic and_2925;
  assign and_2925 = not_1997_s19_q & (less_1639_s19_q & ((~x_s19_q[5]) & (x_s19_q[3] & equal_2913)));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3020;
  assign select_3020 = sample_pair_whole_s19_q ? (equal_1694_s19_q ? patches_place_0_slope_q : select_1807[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3025;
  assign select_3025 = sample_pair_whole_s19_q ? (equal_1694_s19_q ? patches_place_1_slope_q : select_1836[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:522
  logic [55:0] other;
  assign other = new_row_s19_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3114;
  assign select_3114 = or_1794_s19_q ? {and_1938_s19_q, and_1935_s19_q, and_1919_s19_q, and_1916, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3116;
  assign select_3116 = equal_1788_s19_q ? patches_codes_at_q : (equal_1790_s19_q ? other[55:4] : select_3114);
  // hls/stages/patches.hpp:521
  logic [27:0] select_3119;
  assign select_3119 = equal_3118_s19_q ? word_s19_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3121;
  assign select_3121 = equal_1790_s19_q ? (new_row_s19_q ? word_s19_q : select_3119) : patches_codes_further_q;
  // hls/stages/patches.hpp:523
  logic [55:0] select_3123;
  assign select_3123 = less_1879_s19_q ? {word_s19_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:493
  logic [55:0] select_3125;
  assign select_3125 = less_3124_s19_q ? {word_s19_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3127;
  assign select_3127 = or_1794_s19_q ? (equal_1793_s19_q ? patches_next_codes_q : select_3125) : patches_next_codes_q;
  logic [55:0] select_3129;
  assign select_3129 = equal_1788_s19_q ? patches_next_codes_q : (equal_1790_s19_q ? select_3123 : select_3127);
  // hls/stages/count_bits.hpp:24
  logic parity_3134;
  assign parity_3134 = ^{and_1938_s19_q, and_1935_s19_q, and_1919_s19_q, and_1916};
  // hls/stages/count_bits.hpp:25
  logic or_3138;
  assign or_3138 = ({and_1919_s19_q, and_1916} == 2'h3) | (and_1935_s19_q & (and_1919_s19_q | and_1916));
  logic and_3139;
  assign and_3139 = and_1938_s19_q & (^{and_1935_s19_q, and_1919_s19_q, and_1916});
  // hls/stages/count_bits.hpp:24
  logic xor_3140;
  assign xor_3140 = or_3138 ^ and_3139;
  // hls/stages/count_bits.hpp:27
  logic and_3141;
  assign and_3141 = or_3138 & and_3139;
  // hls/stages/patches.hpp:524
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3157_s19_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3163;
  assign xor_3163 = bits[17] ^ (^{select_3157_s19_q[16:15], other[16:15]});
  logic xor_3166;
  assign xor_3166 = bits[11] ^ (^{select_3157_s19_q[10:9], other[10:9]});
  logic xor_3169;
  assign xor_3169 = bits[14] ^ (^{select_3157_s19_q[13:12], other[13:12]});
  logic xor_3172;
  assign xor_3172 = xor_3163 ^ (^{select_3157_s19_q[14:9], other[14:9]});
  logic xor_3175;
  assign xor_3175 = bits[47] ^ (^{select_3157_s19_q[46:45], other[46:45]});
  logic xor_3178;
  assign xor_3178 = bits[8] ^ (^{select_3157_s19_q[7:6], other[7:6]});
  logic xor_3181;
  assign xor_3181 = bits[2] ^ (^{select_3157_s19_q[1:0], other[1:0]});
  logic xor_3184;
  assign xor_3184 = bits[5] ^ (^{select_3157_s19_q[4:3], other[4:3]});
  logic xor_3187;
  assign xor_3187 = xor_3178 ^ (^{select_3157_s19_q[5:0], other[5:0]});
  logic parity_3189;
  assign parity_3189 = ^{select_3157_s19_q[47:45], select_3157_s19_q[8:0], other[47:45], other[8:0]};
  logic xor_3193;
  assign xor_3193 = bits[44] ^ (^{select_3157_s19_q[43:42], other[43:42]});
  logic xor_3196;
  assign xor_3196 = bits[38] ^ (^{select_3157_s19_q[37:36], other[37:36]});
  logic xor_3199;
  assign xor_3199 = bits[41] ^ (^{select_3157_s19_q[40:39], other[40:39]});
  logic xor_3205;
  assign xor_3205 = bits[26] ^ (^{select_3157_s19_q[25:24], other[25:24]});
  logic xor_3208;
  assign xor_3208 = bits[20] ^ (^{select_3157_s19_q[19:18], other[19:18]});
  logic xor_3211;
  assign xor_3211 = bits[23] ^ (^{select_3157_s19_q[22:21], other[22:21]});
  logic xor_3217;
  assign xor_3217 = bits[35] ^ (^{select_3157_s19_q[34:33], other[34:33]});
  logic xor_3220;
  assign xor_3220 = bits[29] ^ (^{select_3157_s19_q[28:27], other[28:27]});
  logic xor_3223;
  assign xor_3223 = bits[32] ^ (^{select_3157_s19_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:184
  logic select_3507;
  assign select_3507 = equal_1788_s19_q ? patches_summed_first_q : (equal_1790_s19_q ? new_row_s19_q : patches_summed_first_q);
  // hls/stages/patches.hpp:543
  logic [9:0] select_3595;
  assign select_3595 = (patches_read_far_s19_q < patches_peak_far_q) ? patches_read_far_s19_q : patches_peak_far_q;
  logic [9:0] select_3596;
  assign select_3596 = patches_read_first_s19_q ? patches_read_far_s19_q : select_3595;
  // hls/stages/patches.hpp:583
  logic [10:0] sum_3638;
  assign sum_3638 = {1'b0, fall_2_s19_q} + {2'h0, fall_2_s19_q[9:1]};
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3642;
  assign sum_3642 = {1'b0, fall_2_s19_q} + {3'h0, fall_2_s19_q[9:2]};
  logic less_3646;
  assign less_3646 = {eight_s19_q, 3'h0} < ({fall_2_s19_q, 3'h0} - {3'h0, fall_2_s19_q});
  // hls/stages/patches.hpp:597
  logic [7:0] select_3652;
  assign select_3652 = patches_second_s19_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:596
  logic [3:0] sum_3653;
  assign sum_3653 = {2'h0, select_3586_s19_q[14:13]} + 4'hf;
  logic [5:0] select_3654;
  assign select_3654 = patches_second_s19_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3655;
  assign sum_3655 = {select_3654[5], select_3654} + {{4{sum_3653[3]}}, sum_3653[3:1]};
  // hls/stages/agreement.hpp:1188
  logic or_3929;
  assign or_3929 = ({counts_textured_s19_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s19_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = less_3933_s19_q | (product_rest_q & equal_3934_s19_q);
  // hls/stages/agreement.hpp:1227
  logic select_3937;
  assign select_3937 = and_3932_s19_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3940;
  assign sum_3940 = {1'b0, select_2652_s19_q} + {2'h0, select_2652_s19_q[9:1]};
  // hls/stages/agreement.hpp:788
  logic select_3993;
  assign select_3993 = equal_575_s19_q ? (equal_3707_s19_q ? sum_4_s19_q : (product_rest_q | sum_4_s19_q)) : product_rest_q;
  logic [2:0] select_4011;
  assign select_4011 = ends_cell_s19_q ? textured_2_s19_q : box_textured_columns_values_0_q;
  logic [2:0] select_4013;
  assign select_4013 = equal_575_s19_q ? box_textured_columns_values_0_q : (so_s19_q ? select_4011 : box_textured_columns_values_0_q);
  logic [2:0] select_4014;
  assign select_4014 = ends_cell_s19_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4016;
  assign select_4016 = equal_575_s19_q ? box_textured_columns_values_1_q : (so_s19_q ? select_4014 : box_textured_columns_values_1_q);
  logic [2:0] select_4017;
  assign select_4017 = ends_cell_s19_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4019;
  assign select_4019 = equal_575_s19_q ? box_textured_columns_values_2_q : (so_s19_q ? select_4017 : box_textured_columns_values_2_q);
  logic [2:0] select_4020;
  assign select_4020 = ends_cell_s19_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4022;
  assign select_4022 = equal_575_s19_q ? box_textured_columns_values_3_q : (so_s19_q ? select_4020 : box_textured_columns_values_3_q);
  logic [2:0] select_4023;
  assign select_4023 = ends_cell_s19_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4025;
  assign select_4025 = equal_575_s19_q ? box_textured_columns_values_4_q : (so_s19_q ? select_4023 : box_textured_columns_values_4_q);
  logic [4:0] select_4045;
  assign select_4045 = so_s19_q ? (ends_cell_s19_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4046;
  assign select_4046 = equal_575_s19_q ? box_explained_sum_sums_values_0_q : select_4045;
  logic [4:0] select_4063;
  assign select_4063 = so_s19_q ? (ends_cell_s19_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4081;
  assign select_4081 = so_s19_q ? (ends_cell_s19_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1300
  logic [3:0] select_4113;
  assign select_4113 = select_2044_s19_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4119;
  assign select_4119 = marks_first_s19_q ? (less_4115 ? {sum_4116, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4194;
  assign select_4194 = equal_1630_s19_q ? {2'h0, counts_explained_s19_q, 2'h0, counts_textured_s19_q} : (equal_4192_s19_q ? registration_sums_rdata_s19_q : 32'h0);
  logic [31:0] select_4195;
  assign select_4195 = equal_1628_s19_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4194;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1900, patches_code_row_s19_q[1:0], of_row_2_s19_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s19_en & and_1952_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1938_s19_q, and_1935_s19_q, and_1919_s19_q, and_1916, patches_codes_at_q[51:28]};
  end
`ifndef SYNTHESIS
  logic [6:0] patches_right_codes_raddr_s17_sim;
  logic patches_right_codes_re_s17_sim;
  logic [6:0] patches_right_codes_raddr_s18_sim;
  logic patches_right_codes_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_codes_re_s17_sim <= 1'b0;
      patches_right_codes_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_codes_re_s17_sim <= patches_right_codes_re;
      patches_right_codes_raddr_s17_sim <= patches_right_codes_raddr;
      patches_right_codes_re_s18_sim <= patches_right_codes_re_s17_sim;
      patches_right_codes_raddr_s18_sim <= patches_right_codes_raddr_s17_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s17_sim && patches_right_codes_raddr_s17_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_re_s18_sim && patches_right_codes_raddr_s18_sim == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 7'd112) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 7'd112) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1956, patches_code_row_s19_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s19_en & and_1966_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1938_s19_q, and_1935_s19_q, and_1919_s19_q, and_1916, patches_codes_at_q[51:8]};
  end
`ifndef SYNTHESIS
  logic [3:0] patches_left_codes_raddr_s17_sim;
  logic patches_left_codes_re_s17_sim;
  logic [3:0] patches_left_codes_raddr_s18_sim;
  logic patches_left_codes_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_codes_re_s17_sim <= 1'b0;
      patches_left_codes_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_codes_re_s17_sim <= patches_left_codes_re;
      patches_left_codes_raddr_s17_sim <= patches_left_codes_raddr;
      patches_left_codes_re_s18_sim <= patches_left_codes_re_s17_sim;
      patches_left_codes_raddr_s18_sim <= patches_left_codes_raddr_s17_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s17_sim && patches_left_codes_raddr_s17_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_re_s18_sim && patches_left_codes_raddr_s18_sim == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s19_q, or_1995_s19_q, or_1992_s19_q, or_1989_s19_q};
  logic regions_we;
  assign regions_we = s19_en & and_2029_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2028_s19_q, sum_2018_s19_q, sum_2013_s19_q};
  end
`ifndef SYNTHESIS
  logic [5:0] regions_raddr_s17_sim;
  logic regions_re_s17_sim;
  logic [5:0] regions_raddr_s18_sim;
  logic regions_re_s18_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      regions_re_s17_sim <= 1'b0;
      regions_re_s18_sim <= 1'b0;
    end else if (en_i) begin
      regions_re_s17_sim <= regions_re;
      regions_raddr_s17_sim <= regions_raddr;
      regions_re_s18_sim <= regions_re_s17_sim;
      regions_raddr_s18_sim <= regions_raddr_s17_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && regions_we) begin
      if (regions_re && regions_raddr == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s17_sim && regions_raddr_s17_sim == regions_waddr) begin
        $error("regions: address %0d is read less than DISTANCE steps after its write", regions_waddr);
      end
      if (regions_re_s18_sim && regions_raddr_s18_sim == regions_waddr) begin
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
    end else if (s19_en) begin
      moments_before_0_q <= equal_575_s19_q ? select_2300 : moments_before_0_q;
      moments_before_1_q <= equal_575_s19_q ? select_2302 : moments_before_1_q;
      counts_supervised_q <= select_2606;
      counts_nearer_q <= select_2621;
      counts_turned_left_q <= select_2719;
      counts_turned_right_q <= select_2726;
      registration_half_measured_q <= select_2785;
      registration_half_votes_up_q <= and_2758_s19_q ? 7'h0 : sum_2799;
      registration_half_half_votes_up_q <= and_2758_s19_q ? 7'h0 : sum_2813;
      patches_place_0_column_q <= sample_pair_whole_s19_q ? select_1808 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s19_q ? select_1809 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3020;
      patches_place_1_column_q <= sample_pair_whole_s19_q ? select_1837 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s19_q ? select_1838 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3025;
      patches_codes_at_q <= select_3116;
      patches_codes_further_q <= equal_1788_s19_q ? patches_codes_further_q : select_3121;
      patches_next_codes_q <= select_3129;
      patches_summed_first_q <= select_3507;
      patches_peak_far_q <= equal_1788_s19_q ? select_3596 : patches_peak_far_q;
      product_rest_q <= select_3993;
      disagree_q <= equal_575_s19_q ? select_3937 : disagree_q;
      began_q <= not_2057 & (began_q | select_2044_s19_q);
      seen_x_q <= select_2044_s19_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s19_q ? 4'h0 : select_4113;
      seen_column_q <= select_2044_s19_q ? 8'h0 : (seen_column_q + {7'h0, equal_2050});
      seen_rows_left_q <= select_4119;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s19_q ? 13'h0 : (seen_base_q + {6'h0, select_2047});
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
    if (s19_en) begin
      census_columns_values_0_cell_0_mask_q <= select_2204;
      census_columns_values_1_cell_0_mask_q <= select_2220;
      census_columns_values_1_cell_1_mask_q <= select_2223;
      census_columns_values_1_cell_3_mask_q <= select_2230;
      census_columns_values_1_cell_4_mask_q <= select_2233;
      census_columns_values_2_cell_0_mask_q <= select_2236;
      census_columns_values_2_cell_1_mask_q <= select_2239;
      box_textured_columns_values_0_q <= select_4013;
      box_textured_columns_values_1_q <= select_4016;
      box_textured_columns_values_2_q <= select_4019;
      box_textured_columns_values_3_q <= select_4022;
      box_textured_columns_values_4_q <= select_4025;
      box_explained_sum_sums_values_0_q <= select_4046;
      box_shown_sum_sums_values_0_q <= equal_575_s19_q ? box_shown_sum_sums_values_0_q : select_4063;
      box_nearer_sum_sums_values_0_q <= equal_575_s19_q ? box_nearer_sum_sums_values_0_q : select_4081;
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
  logic census_columns_values_0_cell_2_mask_s20_q;
  logic census_columns_values_1_cell_2_of_skin_s20_q;
  logic census_columns_values_1_cell_3_mask_s20_q;
  logic census_columns_values_1_cell_4_mask_s20_q;
  logic census_columns_values_2_cell_0_mask_s20_q;
  logic census_columns_values_2_cell_1_mask_s20_q;
  logic [6:0] x_s20_q;
  logic [2:0] slot_s20_q;
  logic ends_cell_s20_q;
  logic lower_half_s20_q;
  logic [13:0] counts_nearer_s20_q;
  logic [11:0] counts_turned_left_s20_q;
  logic [11:0] counts_turned_right_s20_q;
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
  logic [3:0] select_508_s20_q;
  logic [6:0] select_511_s20_q;
  logic [6:0] last_s20_q;
  logic and_548_s20_q;
  logic and_550_s20_q;
  logic equal_553_s20_q;
  logic whole_2_s20_q;
  logic equal_570_s20_q;
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
  logic whole_9_s20_q;
  logic [10:0] sum_717_s20_q;
  logic [9:0] sum_720_s20_q;
  logic [9:0] sum_724_s20_q;
  logic [9:0] sum_728_s20_q;
  logic less_739_s20_q;
  logic less_741_s20_q;
  logic less_745_s20_q;
  logic less_747_s20_q;
  logic equal_1608_s20_q;
  logic [1:0] sum_1614_s20_q;
  logic equal_1616_s20_q;
  logic equal_1618_s20_q;
  logic equal_1620_s20_q;
  logic equal_1622_s20_q;
  logic equal_1624_s20_q;
  logic equal_1626_s20_q;
  logic less_1639_s20_q;
  logic [19:0] select_1664_s20_q;
  logic equal_1665_s20_q;
  logic [11:0] sum_1672_s20_q;
  logic and_1673_s20_q;
  logic and_1676_s20_q;
  logic select_1693_s20_q;
  logic equal_1694_s20_q;
  logic equal_1788_s20_q;
  logic equal_1790_s20_q;
  logic equal_1793_s20_q;
  logic or_1794_s20_q;
  logic select_1804_s20_q;
  logic [7:0] sum_1810_s20_q;
  logic [4:0] select_1818_s20_q;
  logic select_1824_s20_q;
  logic [7:0] sum_1839_s20_q;
  logic equal_1854_s20_q;
  logic equal_1858_s20_q;
  logic [3:0] select_1863_s20_q;
  logic less_1967_s20_q;
  logic equal_1968_s20_q;
  logic not_1969_s20_q;
  logic equal_1970_s20_q;
  logic not_1997_s20_q;
  logic not_2057_s20_q;
  logic [7:0] sum_2067_s20_q;
  logic [3:0] difference_2079_s20_q;
  logic or_2087_s20_q;
  logic [23:0] select_2098_s20_q;
  logic [4:0] around_s20_q;
  logic less_2132_s20_q;
  logic and_2143_s20_q;
  logic [10:0] size_s20_q;
  logic [10:0] size_2_s20_q;
  logic [10:0] sum_2265_s20_q;
  logic [9:0] sum_2268_s20_q;
  logic [9:0] sum_2272_s20_q;
  logic [9:0] sum_2276_s20_q;
  logic equal_2284_s20_q;
  logic equal_2299_s20_q;
  logic [13:0] select_2307_s20_q;
  logic not_2315_s20_q;
  logic not_2318_s20_q;
  logic not_2325_s20_q;
  logic not_2328_s20_q;
  logic [8:0] contrast_s20_q;
  logic [8:0] contrast_2_s20_q;
  logic equal_2402_s20_q;
  logic equal_2473_s20_q;
  logic and_2598_s20_q;
  logic not_2623_s20_q;
  logic [4:0] e_s20_q;
  logic [9:0] select_2649_s20_q;
  logic [9:0] select_2652_s20_q;
  logic and_2700_s20_q;
  logic and_2758_s20_q;
  logic [7:0] select_2778_s20_q;
  logic [1:0] select_2790_s20_q;
  logic [1:0] select_2805_s20_q;
  logic [11:0] select_2856_s20_q;
  logic and_2864_s20_q;
  logic [11:0] select_2871_s20_q;
  logic and_2882_s20_q;
  logic and_2886_s20_q;
  logic and_2918_s20_q;
  logic and_2926_s20_q;
  logic [8:0] other_s20_q;
  logic [2:0] select_3142_s20_q;
  logic [8:0] select_3157_s20_q;
  logic xor_3172_s20_q;
  logic xor_3190_s20_q;
  logic xor_3202_s20_q;
  logic xor_3214_s20_q;
  logic xor_3226_s20_q;
  logic or_3235_s20_q;
  logic or_3239_s20_q;
  logic or_3243_s20_q;
  logic or_3250_s20_q;
  logic or_3254_s20_q;
  logic or_3258_s20_q;
  logic or_3265_s20_q;
  logic or_3269_s20_q;
  logic or_3273_s20_q;
  logic or_3283_s20_q;
  logic or_3287_s20_q;
  logic or_3291_s20_q;
  logic or_3299_s20_q;
  logic or_3303_s20_q;
  logic or_3307_s20_q;
  logic or_3314_s20_q;
  logic or_3318_s20_q;
  logic or_3322_s20_q;
  logic or_3332_s20_q;
  logic or_3336_s20_q;
  logic or_3340_s20_q;
  logic and_3345_s20_q;
  logic or_3346_s20_q;
  logic equal_3467_s20_q;
  logic [4:0] select_3555_s20_q;
  logic [12:0] select_3586_s20_q;
  logic [9:0] select_3596_s20_q;
  logic less_3629_s20_q;
  logic not_3637_s20_q;
  logic not_3640_s20_q;
  logic not_3644_s20_q;
  logic not_3647_s20_q;
  logic [7:0] select_3652_s20_q;
  logic sum_3653_s20_q;
  logic [6:0] sum_3655_s20_q;
  logic equal_3707_s20_q;
  logic equal_3926_s20_q;
  logic or_3929_s20_q;
  logic select_3937_s20_q;
  logic not_3942_s20_q;
  logic equal_3951_s20_q;
  logic equal_3953_s20_q;
  logic equal_3954_s20_q;
  logic equal_3955_s20_q;
  logic equal_3956_s20_q;
  logic equal_4096_s20_q;
  logic [31:0] select_4195_s20_q;
  logic [9:0] select_4202_s20_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s20_q <= pixel_0_s19_q;
      pixel_1_s20_q <= pixel_1_s19_q;
      saturated_s20_q <= saturated_s19_q;
      mask_s20_q <= mask_s19_q;
      marks_first_s20_q <= marks_first_s19_q;
      marks_last_s20_q <= line_ended_q;
      sample_pair_pixel_0_s20_q <= sample_pair_pixel_0_s19_q;
      sample_pair_pixel_1_s20_q <= sample_pair_pixel_1_s19_q;
      sample_pair_whole_s20_q <= sample_pair_whole_s19_q;
      sample_present_s20_q <= sample_present_s19_q;
      census_columns_values_0_cell_2_mask_s20_q <= census_columns_values_0_cell_2_mask_s19_q;
      census_columns_values_1_cell_2_of_skin_s20_q <= census_columns_values_1_cell_2_of_skin_s19_q;
      census_columns_values_1_cell_3_mask_s20_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s20_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s20_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s20_q <= census_columns_values_2_cell_1_mask_q;
      x_s20_q <= x_s19_q[6:0];
      slot_s20_q <= slot_s19_q;
      ends_cell_s20_q <= ends_cell_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      counts_nearer_s20_q <= counts_nearer_q;
      counts_turned_left_s20_q <= counts_turned_left_q[13:2];
      counts_turned_right_s20_q <= counts_turned_right_q[13:2];
      registration_of_right_s20_q <= registration_of_right_s19_q;
      patches_lower_s20_q <= patches_lower_s19_q;
      patches_second_s20_q <= patches_second_s19_q;
      patches_summed_row_column_s20_q <= patches_summed_row_column_s19_q;
      patches_summed_first_s20_q <= patches_summed_first_q;
      patches_summed_last_s20_q <= patches_summed_last_s19_q;
      patches_summed_down_by_s20_q <= patches_summed_down_by_s19_q;
      product_s20_q <= product_s19_q;
      centres_values_1_textured_s20_q <= centres_values_1_textured_s19_q;
      centres_values_1_of_skin_s20_q <= centres_values_1_of_skin_s19_q;
      select_508_s20_q <= select_508_s19_q;
      select_511_s20_q <= select_511_s19_q;
      last_s20_q <= last_s19_q;
      and_548_s20_q <= and_548_s19_q;
      and_550_s20_q <= and_550_s19_q;
      equal_553_s20_q <= equal_553_s19_q;
      whole_2_s20_q <= whole_2_s19_q;
      equal_570_s20_q <= equal_570_s19_q;
      equal_575_s20_q <= equal_575_s19_q;
      not_576_s20_q <= not_576_s19_q;
      so_s20_q <= so_s19_q;
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
      whole_9_s20_q <= whole_9;
      sum_717_s20_q <= {1'b0, sum_713} + {1'b0, sum_716};
      sum_720_s20_q <= {9'h0, difference_718_s19_q} + {1'b0, xor_719_s19_q};
      sum_724_s20_q <= {9'h0, difference_722_s19_q} + {1'b0, xor_723_s19_q};
      sum_728_s20_q <= {9'h0, difference_726_s19_q} + {1'b0, xor_727_s19_q};
      less_739_s20_q <= less_739;
      less_741_s20_q <= $signed(10'h0) < $signed(half_grey_levels_s19_q);
      less_745_s20_q <= less_745;
      less_747_s20_q <= $signed(10'h0) < $signed(half_grey_levels_2_s19_q);
      equal_1608_s20_q <= equal_1608_s19_q;
      sum_1614_s20_q <= sum_1614_s19_q;
      equal_1616_s20_q <= equal_1616_s19_q;
      equal_1618_s20_q <= equal_1618_s19_q;
      equal_1620_s20_q <= equal_1620_s19_q;
      equal_1622_s20_q <= equal_1622_s19_q;
      equal_1624_s20_q <= equal_1624_s19_q;
      equal_1626_s20_q <= equal_1626_s19_q;
      less_1639_s20_q <= less_1639_s19_q;
      select_1664_s20_q <= equal_1663_s19_q ? registration_sums_rdata_s19_q[19:0] : 20'h0;
      equal_1665_s20_q <= equal_1665;
      sum_1672_s20_q <= sum_1672;
      and_1673_s20_q <= and_1673_s19_q;
      and_1676_s20_q <= and_1676_s19_q;
      select_1693_s20_q <= select_1693_s19_q;
      equal_1694_s20_q <= equal_1694_s19_q;
      equal_1788_s20_q <= equal_1788_s19_q;
      equal_1790_s20_q <= equal_1790_s19_q;
      equal_1793_s20_q <= equal_1793_s19_q;
      or_1794_s20_q <= or_1794_s19_q;
      select_1804_s20_q <= select_1804_s19_q[0];
      sum_1810_s20_q <= select_1808 + {{2{select_1809[5]}}, select_1809};
      select_1818_s20_q <= select_1818_s19_q;
      select_1824_s20_q <= select_1824_s19_q;
      sum_1839_s20_q <= select_1837 + {{2{select_1838[5]}}, select_1838};
      equal_1854_s20_q <= equal_1854;
      equal_1858_s20_q <= equal_1858;
      select_1863_s20_q <= select_1863_s19_q;
      less_1967_s20_q <= less_1967_s19_q;
      equal_1968_s20_q <= equal_1968_s19_q;
      not_1969_s20_q <= not_1969_s19_q;
      equal_1970_s20_q <= equal_1970_s19_q;
      not_1997_s20_q <= not_1997_s19_q;
      not_2057_s20_q <= not_2057;
      sum_2067_s20_q <= {2'h0, x_s19_q[7:2]} + 8'hff;
      difference_2079_s20_q <= {1'b0, textured_2_s19_q} - {1'b0, select_2078};
      or_2087_s20_q <= or_2087_s19_q;
      select_2098_s20_q <= select_2098;
      around_s20_q <= around;
      less_2132_s20_q <= {1'b0, around[4:1]} < n;
      and_2143_s20_q <= and_2143_s19_q;
      size_s20_q <= size;
      size_2_s20_q <= size_2;
      sum_2265_s20_q <= {1'b0, sum_2261} + {1'b0, sum_2264};
      sum_2268_s20_q <= {9'h0, difference_2266_s19_q} + {1'b0, xor_2267_s19_q};
      sum_2272_s20_q <= {9'h0, difference_2270_s19_q} + {1'b0, xor_2271_s19_q};
      sum_2276_s20_q <= {9'h0, difference_2274_s19_q} + {1'b0, xor_2275_s19_q};
      equal_2284_s20_q <= equal_2284_s19_q;
      equal_2299_s20_q <= equal_2299_s19_q;
      select_2307_s20_q <= (select_2302 < select_2300) ? select_2300 : select_2302;
      not_2315_s20_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2313);
      not_2318_s20_q <= ~({3'h0, select_2302[13:2]} < sum_2313);
      not_2325_s20_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2323);
      not_2328_s20_q <= ~({3'h0, select_2300[13:2]} < sum_2323);
      contrast_s20_q <= contrast;
      contrast_2_s20_q <= contrast_2;
      equal_2402_s20_q <= x_s19_q[7:3] == 5'h0;
      equal_2473_s20_q <= equal_2473_s19_q;
      and_2598_s20_q <= and_2598_s19_q;
      not_2623_s20_q <= not_2623_s19_q;
      e_s20_q <= e;
      select_2649_s20_q <= select_2649_s19_q;
      select_2652_s20_q <= select_2652_s19_q;
      and_2700_s20_q <= and_2700_s19_q;
      and_2758_s20_q <= and_2758_s19_q;
      select_2778_s20_q <= equal_575_s19_q ? 8'h0 : (so_s19_q ? select_2776 : 8'h0);
      select_2790_s20_q <= equal_575_s19_q ? 2'h0 : select_2789;
      select_2805_s20_q <= equal_575_s19_q ? 2'h0 : select_2804;
      select_2856_s20_q <= select_2856;
      and_2864_s20_q <= equal_575_s19_q & (x_s19_q[6] & and_2862);
      select_2871_s20_q <= select_2871;
      and_2882_s20_q <= equal_575_s19_q & (x_s19_q[6] & and_2880);
      and_2886_s20_q <= and_2886;
      and_2918_s20_q <= equal_575_s19_q & (x_s19_q[6] & and_2916);
      and_2926_s20_q <= x_s19_q[6] & and_2925;
      other_s20_q <= other[44:36];
      select_3142_s20_q <= and_1961_s19_q ? {and_3141, xor_3140, parity_3134} : 3'h0;
      select_3157_s20_q <= select_3157_s19_q[44:36];
      xor_3172_s20_q <= xor_3172;
      xor_3190_s20_q <= xor_3172 ^ parity_3189;
      xor_3202_s20_q <= xor_3193 ^ (^{select_3157_s19_q[41:36], other[41:36]});
      xor_3214_s20_q <= xor_3205 ^ (^{select_3157_s19_q[23:18], other[23:18]});
      xor_3226_s20_q <= xor_3217 ^ (^{select_3157_s19_q[32:27], other[32:27]});
      or_3235_s20_q <= (xor_3166 & xor_3169) | (xor_3163 & (xor_3166 | xor_3169));
      or_3239_s20_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3243_s20_q <= (xor_3181 & xor_3184) | (xor_3178 & (xor_3181 | xor_3184));
      or_3250_s20_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3254_s20_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3258_s20_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3265_s20_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3269_s20_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3273_s20_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3283_s20_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3287_s20_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3291_s20_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3299_s20_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3303_s20_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3307_s20_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3314_s20_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3318_s20_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3322_s20_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3332_s20_q <= (xor_3196 & xor_3199) | (xor_3193 & (xor_3196 | xor_3199));
      or_3336_s20_q <= (xor_3208 & xor_3211) | (xor_3205 & (xor_3208 | xor_3211));
      or_3340_s20_q <= (xor_3220 & xor_3223) | (xor_3217 & (xor_3220 | xor_3223));
      and_3345_s20_q <= xor_3175 & xor_3187;
      or_3346_s20_q <= xor_3175 | xor_3187;
      equal_3467_s20_q <= equal_3467_s19_q;
      select_3555_s20_q <= select_3555_s19_q;
      select_3586_s20_q <= select_3586_s19_q[12:0];
      select_3596_s20_q <= select_3596;
      less_3629_s20_q <= less_3629_s19_q;
      not_3637_s20_q <= ~({eight_s19_q, 3'h0} < {3'h0, fall_2_s19_q});
      not_3640_s20_q <= ~({eight_s19_q, 3'h0} < {1'b0, sum_3638, fall_2_s19_q[0]});
      not_3644_s20_q <= ~({eight_s19_q, 3'h0} < {sum_3642, fall_2_s19_q[1:0]});
      not_3647_s20_q <= ~less_3646;
      select_3652_s20_q <= select_3652;
      sum_3653_s20_q <= sum_3653[0];
      sum_3655_s20_q <= sum_3655;
      equal_3707_s20_q <= equal_3707_s19_q;
      equal_3926_s20_q <= select_2649_s19_q[9:3] == 7'h0;
      or_3929_s20_q <= or_3929;
      select_3937_s20_q <= select_3937;
      not_3942_s20_q <= ~({sum_3940, select_2652_s19_q[0]} < {2'h0, select_2649_s19_q});
      equal_3951_s20_q <= equal_3951_s19_q;
      equal_3953_s20_q <= equal_3953_s19_q;
      equal_3954_s20_q <= equal_3954_s19_q;
      equal_3955_s20_q <= equal_3955_s19_q;
      equal_3956_s20_q <= equal_3956_s19_q;
      equal_4096_s20_q <= equal_4096_s19_q;
      select_4195_s20_q <= select_4195;
      select_4202_s20_q <= select_4202_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
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
  assign whole_10 = census_columns_values_1_cell_2_mask_q & whole_9_s20_q;
  logic whole_11;
  assign whole_11 = census_columns_values_1_cell_3_mask_s20_q & whole_10;
  logic whole_12;
  assign whole_12 = census_columns_values_1_cell_4_mask_s20_q & whole_11;
  logic whole_13;
  assign whole_13 = census_columns_values_2_cell_0_mask_s20_q & whole_12;
  logic whole_14;
  assign whole_14 = census_columns_values_2_cell_1_mask_s20_q & whole_13;
  logic whole_15;
  assign whole_15 = census_columns_values_2_cell_2_mask_q & whole_14;
  logic whole_16;
  assign whole_16 = census_columns_values_2_cell_3_mask_q & whole_15;
  // hls/stages/census.hpp:281
  logic [10:0] sum_721;
  assign sum_721 = sum_717_s20_q + {1'b0, sum_720_s20_q};
  // hls/stages/agreement.hpp:456
  logic and_735;
  assign and_735 = census_columns_values_0_cell_2_mask_s20_q & census_columns_values_1_cell_2_mask_q;
  logic and_736;
  assign and_736 = and_684_s20_q & and_735;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1614_s20_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1667;
  assign select_1667 = equal_1665_s20_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1806;
  assign select_1806 = equal_1694_s20_q ? patches_place_0_valid_q : (select_1693_s20_q ? patches_place_0_valid_q : select_1804_s20_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1811;
  assign sum_1811 = sum_1810_s20_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1812;
  assign equal_1812 = {sum_1811[7], select_511_s20_q, select_508_s20_q} == {1'b0, sum_1811[6:0], 4'h8};
  // hls/stages/patches.hpp:127
  logic select_1835;
  assign select_1835 = equal_1694_s20_q ? patches_place_1_valid_q : (select_1693_s20_q ? select_1804_s20_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1840;
  assign sum_1840 = sum_1839_s20_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1841;
  assign equal_1841 = {sum_1840[7], select_511_s20_q, select_508_s20_q} == {1'b0, sum_1840[6:0], 4'h8};
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1275
  logic select_2055;
  assign select_2055 = marks_first_s20_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2056;
  assign sum_2056 = {1'b0, {5{select_2055}}, 1'b0, {2{select_2055}}, 1'b0, select_2055} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1111
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2067_s20_q[7]}}, sum_2067_s20_q, x_s20_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2069;
  assign sum_2069 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1094
  logic [4:0] t;
  assign t = {difference_2079_s20_q[3], difference_2079_s20_q} + (equal_570_s20_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic [47:0] select_2099;
  assign select_2099 = or_2087_s20_q ? {select_2098_s20_q[23], 1'b0, select_2098_s20_q[22], 1'b0, select_2098_s20_q[21], 1'b0, select_2098_s20_q[20], 1'b0, select_2098_s20_q[19], 1'b0, select_2098_s20_q[18], 1'b0, select_2098_s20_q[17], 1'b0, select_2098_s20_q[16], 1'b0, select_2098_s20_q[15], 1'b0, select_2098_s20_q[14], 1'b0, select_2098_s20_q[13], 1'b0, select_2098_s20_q[12], 1'b0, select_2098_s20_q[11], 1'b0, select_2098_s20_q[10], 1'b0, select_2098_s20_q[9], 1'b0, select_2098_s20_q[8], 1'b0, select_2098_s20_q[7], 1'b0, select_2098_s20_q[6], 1'b0, select_2098_s20_q[5], 1'b0, select_2098_s20_q[4], 1'b0, select_2098_s20_q[3], 1'b0, select_2098_s20_q[2], 1'b0, select_2098_s20_q[1], 1'b0, select_2098_s20_q[0], 1'b0} : {1'b0, select_2098_s20_q[23], 1'b0, select_2098_s20_q[22], 1'b0, select_2098_s20_q[21], 1'b0, select_2098_s20_q[20], 1'b0, select_2098_s20_q[19], 1'b0, select_2098_s20_q[18], 1'b0, select_2098_s20_q[17], 1'b0, select_2098_s20_q[16], 1'b0, select_2098_s20_q[15], 1'b0, select_2098_s20_q[14], 1'b0, select_2098_s20_q[13], 1'b0, select_2098_s20_q[12], 1'b0, select_2098_s20_q[11], 1'b0, select_2098_s20_q[10], 1'b0, select_2098_s20_q[9], 1'b0, select_2098_s20_q[8], 1'b0, select_2098_s20_q[7], 1'b0, select_2098_s20_q[6], 1'b0, select_2098_s20_q[5], 1'b0, select_2098_s20_q[4], 1'b0, select_2098_s20_q[3], 1'b0, select_2098_s20_q[2], 1'b0, select_2098_s20_q[1], 1'b0, select_2098_s20_q[0]};
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2116;
  assign sum_2116 = {1'b0, around_s20_q} + {2'h0, around_s20_q[4:1]};
  // hls/stages/census.hpp:219
  logic [13:0] detail;
  assign detail = {3'h0, size_s20_q} + (equal_553_s20_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2185;
  assign select_2185 = sample_pair_whole_s20_q ? (and_548_s20_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:219
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s20_q} + (equal_553_s20_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2193;
  assign select_2193 = sample_pair_whole_s20_q ? (and_548_s20_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:520
  logic select_2226;
  assign select_2226 = and_550_s20_q ? census_columns_values_0_cell_2_mask_s20_q : census_columns_values_1_cell_2_mask_q;
  logic select_2242;
  assign select_2242 = and_550_s20_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2245;
  assign select_2245 = and_550_s20_q ? census_columns_values_1_cell_3_mask_s20_q : census_columns_values_2_cell_3_mask_q;
  logic select_2248;
  assign select_2248 = and_550_s20_q ? census_columns_values_1_cell_4_mask_s20_q : census_columns_values_2_cell_4_mask_q;
  logic select_2249;
  assign select_2249 = and_550_s20_q ? census_columns_values_2_cell_0_mask_s20_q : census_columns_values_3_cell_0_mask_q;
  logic select_2252;
  assign select_2252 = and_550_s20_q ? census_columns_values_2_cell_1_mask_s20_q : census_columns_values_3_cell_1_mask_q;
  logic select_2253;
  assign select_2253 = and_550_s20_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2256;
  assign select_2256 = and_550_s20_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:283
  logic [10:0] sum_2269;
  assign sum_2269 = sum_2265_s20_q + {1'b0, sum_2268_s20_q};
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2309;
  assign sum_2309 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:520
  logic select_2366;
  assign select_2366 = and_550_s20_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:370
  logic and_2369;
  assign and_2369 = whole_2_s20_q & (~(last_s20_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2375;
  assign and_2375 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s20_q[8:2]));
  logic and_2376;
  assign and_2376 = and_2369 & and_2375;
  logic and_2387;
  assign and_2387 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s20_q[8:2]));
  logic and_2388;
  assign and_2388 = and_2369 & and_2387;
  // hls/stages/census.hpp:424
  logic not_2405;
  assign not_2405 = ~x_s20_q[1];
  logic [2:0] select_2406;
  assign select_2406 = x_s20_q[0] ? {1'b0, not_2405, 1'b0} : {x_s20_q[1], 1'b0, not_2405};
  logic [5:0] select_2407;
  assign select_2407 = slot_s20_q[2] ? {select_2406[2], 1'b0, select_2406[1], 1'b0, select_2406[0], 1'b0} : {1'b0, select_2406[2], 1'b0, select_2406[1], 1'b0, select_2406[0]};
  logic [11:0] select_2408;
  assign select_2408 = slot_s20_q[1] ? {select_2407[5], 1'b0, select_2407[4], 1'b0, select_2407[3], 1'b0, select_2407[2], 1'b0, select_2407[1], 1'b0, select_2407[0], 1'b0} : {1'b0, select_2407[5], 1'b0, select_2407[4], 1'b0, select_2407[3], 1'b0, select_2407[2], 1'b0, select_2407[1], 1'b0, select_2407[0]};
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2636;
  assign sum_2636 = {1'b0, e_s20_q} + {2'h0, e_s20_q[4:1]};
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2653;
  assign sum_2653 = {1'b0, select_2652_s20_q} + {3'h0, select_2652_s20_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2779;
  assign sum_2779 = registration_half_across_q + {{6{select_2778_s20_q[7]}}, select_2778_s20_q};
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2791;
  assign sum_2791 = registration_half_votes_down_q + {{5{select_2790_s20_q[1]}}, select_2790_s20_q};
  logic [6:0] sum_2806;
  assign sum_2806 = registration_half_half_votes_down_q + {{5{select_2805_s20_q[1]}}, select_2805_s20_q};
  // hls/stages/agreement.hpp:788
  logic and_2847;
  assign and_2847 = equal_575_s20_q & (x_s20_q[6] & (not_1997_s20_q & less_1639_s20_q));
  logic [11:0] select_2858;
  assign select_2858 = equal_575_s20_q ? (x_s20_q[6] ? select_2856_s20_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2866;
  assign sum_2866 = {{2{select_2858[11]}}, select_2858} + (and_2864_s20_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2873;
  assign select_2873 = equal_575_s20_q ? (x_s20_q[6] ? select_2871_s20_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2875;
  assign sum_2875 = {{2{select_2873[11]}}, select_2873} + (and_2864_s20_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2887;
  assign not_2887 = ~and_2886_s20_q;
  logic less_2888;
  assign less_2888 = $signed({9'h1, {2{not_2887}}, and_2886_s20_q}) < $signed(registration_up_q[13:2]);
  logic select_2889;
  assign select_2889 = and_2882_s20_q ? less_2888 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2893;
  assign and_2893 = x_s20_q[6] & (not_1997_s20_q & (less_1639_s20_q & (x_s20_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2894;
  assign and_2894 = equal_575_s20_q & and_2893;
  // hls/stages/registration.hpp:242
  logic less_2895;
  assign less_2895 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2897;
  assign less_2897 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2899;
  assign equal_2899 = x_s20_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2903;
  assign and_2903 = equal_575_s20_q & (x_s20_q[6] & (not_1997_s20_q & (less_1639_s20_q & equal_2899)));
  // hls/stages/agreement.hpp:1142
  logic and_2910;
  assign and_2910 = x_s20_q[6] & (not_1997_s20_q & (less_1639_s20_q & (x_s20_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2928;
  assign and_2928 = registration_votes_up_q & registration_other_down_q;
  logic select_2930;
  assign select_2930 = registration_votes_down_q ? (registration_other_up_q | and_2928) : and_2928;
  // hls/stages/registration.hpp:138
  logic and_2932;
  assign and_2932 = (equal_575_s20_q & and_2926_s20_q) & (registration_other_enough_q & select_2930);
  logic and_2934;
  assign and_2934 = registration_enough_q & ((and_2918_s20_q & (less_2897 | less_2895)) | and_2932);
  // hls/stages/patches.hpp:184
  logic [2:0] select_3144;
  assign select_3144 = equal_1790_s20_q ? 3'h0 : (or_1794_s20_q ? select_3142_s20_q : 3'h0);
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3147;
  assign sum_3147 = {7'h0, patches_set_q} + (equal_1793_s20_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3227;
  assign xor_3227 = xor_3214_s20_q ^ xor_3226_s20_q;
  // hls/stages/count_bits.hpp:25
  logic or_3352;
  assign or_3352 = (xor_3214_s20_q & xor_3226_s20_q) | (xor_3202_s20_q & (xor_3214_s20_q | xor_3226_s20_q));
  // hls/stages/patches.hpp:583
  logic [1:0] sum_3641;
  assign sum_3641 = {1'b0, not_3637_s20_q} + {1'b0, not_3640_s20_q};
  // hls/stages/patches.hpp:584
  logic [1:0] sum_3648;
  assign sum_3648 = {1'b0, not_3644_s20_q} + {1'b0, not_3647_s20_q};
  // hls/stages/patches.hpp:583
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3641} + {1'b0, sum_3648};
  // hls/stages/patches.hpp:597
  logic [18:0] product_3656;
  assign product_3656 = $signed({{11{select_3652_s20_q[7]}}, select_3652_s20_q}) * $signed({{8{sum_3655_s20_q[6]}}, sum_3655_s20_q, sum_3653_s20_q, select_3586_s20_q[12:10]});
  // hls/stages/patches.hpp:605
  logic [11:0] sum_3831;
  assign sum_3831 = {sum_3655_s20_q[6], sum_3655_s20_q, sum_3653_s20_q, select_3586_s20_q[12:10]} + 12'h1;
  // hls/stages/agreement.hpp:1135
  logic select_3943;
  assign select_3943 = equal_3926_s20_q ? ((~or_3929_s20_q) & (~select_3937_s20_q)) : not_3942_s20_q;
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3945;
  assign select_3945 = x_s20_q[6] ? (equal_1608_s20_q ? good_q : {select_3943, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:1147
  logic equal_3948;
  assign equal_3948 = x_s20_q == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic [4:0] select_4027;
  assign select_4027 = so_s20_q ? (ends_cell_s20_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4099;
  assign select_4099 = equal_2473_s20_q ? (equal_4096_s20_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4102;
  assign select_4102 = and_550_s20_q ? (equal_2473_s20_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
    end else if (s20_en) begin
      moments_most_before_q <= equal_575_s20_q ? select_2307_s20_q : moments_most_before_q;
      moments_left_alone_q <= equal_575_s20_q ? not_2315_s20_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_575_s20_q ? not_2318_s20_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_575_s20_q ? not_2325_s20_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_575_s20_q ? not_2328_s20_q : moments_right_other_stops_q;
      sharpness_before_last_mask_q <= select_2366;
      registration_half_across_q <= and_2758_s20_q ? 14'h0 : sum_2779;
      registration_half_votes_down_q <= and_2758_s20_q ? 7'h0 : sum_2791;
      registration_half_half_votes_down_q <= and_2758_s20_q ? 7'h0 : sum_2806;
      registration_down_q <= and_2847 ? sum_2866 : registration_down_q;
      registration_up_q <= and_2847 ? sum_2875 : registration_up_q;
      registration_enough_q <= select_2889;
      registration_votes_down_q <= and_2894 ? less_2895 : registration_votes_down_q;
      registration_votes_up_q <= and_2894 ? less_2897 : registration_votes_up_q;
      registration_other_enough_q <= and_2903 ? select_2889 : registration_other_enough_q;
      registration_other_down_q <= and_2903 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2903 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s20_q ? select_1806 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s20_q ? select_1835 : patches_place_1_valid_q;
      patches_set_q <= equal_1788_s20_q ? 3'h0 : select_3144;
      patches_size_q <= sum_3147;
      good_q <= equal_575_s20_q ? select_3945 : good_q;
      map_row_q <= and_550_s20_q ? select_4099 : map_row_q;
      map_width_q <= select_4102;
      write_half_q <= marks_first_s20_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2055;
      done_q <= not_2057_s20_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s20_q;
      said_q <= equal_575_s20_q & equal_3948;
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
    if (s20_en) begin
      averager_detail_0_q <= select_2185;
      averager_detail_1_q <= select_2193;
      census_columns_values_1_cell_2_mask_q <= select_2226;
      census_columns_values_2_cell_2_mask_q <= select_2242;
      census_columns_values_2_cell_3_mask_q <= select_2245;
      census_columns_values_2_cell_4_mask_q <= select_2248;
      census_columns_values_3_cell_0_mask_q <= select_2249;
      census_columns_values_3_cell_1_mask_q <= select_2252;
      census_columns_values_3_cell_2_mask_q <= select_2253;
      census_columns_values_3_cell_3_mask_q <= select_2256;
      sharpness_last_mask_q <= and_550_s20_q ? whole_2_s20_q : sharpness_last_mask_q;
      box_textured_sum_sums_values_0_q <= equal_575_s20_q ? box_textured_sum_sums_values_0_q : select_4027;
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
  logic census_columns_values_2_cell_4_mask_s21_q;
  logic census_columns_values_3_cell_0_mask_s21_q;
  logic census_columns_values_3_cell_1_mask_s21_q;
  logic census_columns_values_3_cell_2_mask_s21_q;
  logic census_columns_values_3_cell_3_mask_s21_q;
  logic moments_left_alone_s21_q;
  logic moments_left_other_stops_s21_q;
  logic moments_right_alone_s21_q;
  logic moments_right_other_stops_s21_q;
  logic [6:0] x_s21_q;
  logic slot_s21_q;
  logic ends_cell_s21_q;
  logic lower_half_s21_q;
  logic [13:0] counts_nearer_s21_q;
  logic registration_of_right_s21_q;
  logic patches_lower_s21_q;
  logic patches_second_s21_q;
  logic [4:0] patches_summed_row_column_s21_q;
  logic patches_summed_first_s21_q;
  logic patches_summed_last_s21_q;
  logic [4:0] patches_summed_down_by_s21_q;
  logic [13:0] product_s21_q;
  logic centres_values_1_textured_s21_q;
  logic centres_values_1_of_skin_s21_q;
  logic done_s21_q;
  logic [6:0] last_s21_q;
  logic and_550_s21_q;
  logic equal_575_s21_q;
  logic not_576_s21_q;
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
  logic whole_16_s21_q;
  logic and_710_s21_q;
  logic [11:0] sum_725_s21_q;
  logic [9:0] sum_728_s21_q;
  logic and_736_s21_q;
  logic and_740_s21_q;
  logic less_741_s21_q;
  logic less_745_s21_q;
  logic less_747_s21_q;
  logic equal_1608_s21_q;
  logic [1:0] sum_1614_s21_q;
  logic equal_1616_s21_q;
  logic equal_1618_s21_q;
  logic equal_1620_s21_q;
  logic equal_1622_s21_q;
  logic equal_1624_s21_q;
  logic equal_1626_s21_q;
  logic [19:0] sum_1668_s21_q;
  logic [11:0] sum_1672_s21_q;
  logic and_1673_s21_q;
  logic and_1676_s21_q;
  logic select_1693_s21_q;
  logic equal_1694_s21_q;
  logic equal_1788_s21_q;
  logic equal_1790_s21_q;
  logic select_1804_s21_q;
  logic select_1806_s21_q;
  logic equal_1812_s21_q;
  logic [4:0] select_1818_s21_q;
  logic select_1824_s21_q;
  logic select_1835_s21_q;
  logic equal_1841_s21_q;
  logic or_1856_s21_q;
  logic or_1860_s21_q;
  logic [3:0] select_1863_s21_q;
  logic less_1967_s21_q;
  logic equal_1968_s21_q;
  logic not_1969_s21_q;
  logic equal_1970_s21_q;
  logic not_1997_s21_q;
  logic [2:0] index_s21_q;
  logic [10:0] sum_2056_s21_q;
  logic and_2063_s21_q;
  logic less_2064_s21_q;
  logic [2:0] index_2_s21_q;
  logic [10:0] sum_2069_s21_q;
  logic equal_2082_s21_q;
  logic not_2102_s21_q;
  logic not_2118_s21_q;
  logic less_2132_s21_q;
  logic and_2143_s21_q;
  logic [11:0] sum_2273_s21_q;
  logic [9:0] sum_2276_s21_q;
  logic equal_2284_s21_q;
  logic equal_2299_s21_q;
  logic not_2311_s21_q;
  logic not_2321_s21_q;
  logic [27:0] select_2363_s21_q;
  logic and_2376_s21_q;
  logic and_2388_s21_q;
  logic [8:0] select_2395_s21_q;
  logic [8:0] select_2399_s21_q;
  logic equal_2402_s21_q;
  logic less_2403_s21_q;
  logic [11:0] select_2408_s21_q;
  logic equal_2446_s21_q;
  logic and_2598_s21_q;
  logic not_2623_s21_q;
  logic not_2638_s21_q;
  logic [9:0] select_2649_s21_q;
  logic [9:0] select_2652_s21_q;
  logic less_2654_s21_q;
  logic and_2700_s21_q;
  logic equal_2899_s21_q;
  logic not_2912_s21_q;
  logic and_2934_s21_q;
  logic parity_3231_s21_q;
  logic or_3235_s21_q;
  logic or_3239_s21_q;
  logic or_3243_s21_q;
  logic or_3250_s21_q;
  logic or_3254_s21_q;
  logic or_3258_s21_q;
  logic or_3265_s21_q;
  logic or_3269_s21_q;
  logic or_3273_s21_q;
  logic or_3283_s21_q;
  logic or_3287_s21_q;
  logic or_3291_s21_q;
  logic or_3299_s21_q;
  logic or_3303_s21_q;
  logic or_3307_s21_q;
  logic or_3314_s21_q;
  logic or_3318_s21_q;
  logic or_3322_s21_q;
  logic or_3332_s21_q;
  logic or_3336_s21_q;
  logic or_3340_s21_q;
  logic and_3344_s21_q;
  logic or_3348_s21_q;
  logic or_3352_s21_q;
  logic equal_3467_s21_q;
  logic [4:0] select_3555_s21_q;
  logic [9:0] select_3586_s21_q;
  logic [9:0] select_3596_s21_q;
  logic less_3629_s21_q;
  logic [2:0] fraction_s21_q;
  logic [13:0] product_3656_s21_q;
  logic equal_3707_s21_q;
  logic less_3832_s21_q;
  logic or_3929_s21_q;
  logic select_3937_s21_q;
  logic equal_3948_s21_q;
  logic equal_3951_s21_q;
  logic equal_3953_s21_q;
  logic equal_3954_s21_q;
  logic equal_3955_s21_q;
  logic equal_3956_s21_q;
  logic [31:0] select_4195_s21_q;
  logic [9:0] select_4202_s21_q;
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
      census_columns_values_2_cell_4_mask_s21_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s21_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s21_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s21_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s21_q <= census_columns_values_3_cell_3_mask_q;
      moments_left_alone_s21_q <= moments_left_alone_q;
      moments_left_other_stops_s21_q <= moments_left_other_stops_q;
      moments_right_alone_s21_q <= moments_right_alone_q;
      moments_right_other_stops_s21_q <= moments_right_other_stops_q;
      x_s21_q <= x_s20_q;
      slot_s21_q <= slot_s20_q[0];
      ends_cell_s21_q <= ends_cell_s20_q;
      lower_half_s21_q <= lower_half_s20_q;
      counts_nearer_s21_q <= counts_nearer_s20_q;
      registration_of_right_s21_q <= registration_of_right_s20_q;
      patches_lower_s21_q <= patches_lower_s20_q;
      patches_second_s21_q <= patches_second_s20_q;
      patches_summed_row_column_s21_q <= patches_summed_row_column_s20_q;
      patches_summed_first_s21_q <= patches_summed_first_s20_q;
      patches_summed_last_s21_q <= patches_summed_last_s20_q;
      patches_summed_down_by_s21_q <= patches_summed_down_by_s20_q;
      product_s21_q <= product_s20_q;
      centres_values_1_textured_s21_q <= centres_values_1_textured_s20_q;
      centres_values_1_of_skin_s21_q <= centres_values_1_of_skin_s20_q;
      done_s21_q <= done_q;
      last_s21_q <= last_s20_q;
      and_550_s21_q <= and_550_s20_q;
      equal_575_s21_q <= equal_575_s20_q;
      not_576_s21_q <= not_576_s20_q;
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
      whole_16_s21_q <= whole_16;
      and_710_s21_q <= census_columns_values_1_cell_2_mask_q & and_684_s20_q;
      sum_725_s21_q <= {1'b0, sum_721} + {2'h0, sum_724_s20_q};
      sum_728_s21_q <= sum_728_s20_q;
      and_736_s21_q <= and_736;
      and_740_s21_q <= and_736 & less_739_s20_q;
      less_741_s21_q <= less_741_s20_q;
      less_745_s21_q <= less_745_s20_q;
      less_747_s21_q <= less_747_s20_q;
      equal_1608_s21_q <= equal_1608_s20_q;
      sum_1614_s21_q <= sum_1614_s20_q;
      equal_1616_s21_q <= equal_1616_s20_q;
      equal_1618_s21_q <= equal_1618_s20_q;
      equal_1620_s21_q <= equal_1620_s20_q;
      equal_1622_s21_q <= equal_1622_s20_q;
      equal_1624_s21_q <= equal_1624_s20_q;
      equal_1626_s21_q <= equal_1626_s20_q;
      sum_1668_s21_q <= select_1664_s20_q + {{6{select_1667[13]}}, select_1667};
      sum_1672_s21_q <= sum_1672_s20_q;
      and_1673_s21_q <= and_1673_s20_q;
      and_1676_s21_q <= and_1676_s20_q;
      select_1693_s21_q <= select_1693_s20_q;
      equal_1694_s21_q <= equal_1694_s20_q;
      equal_1788_s21_q <= equal_1788_s20_q;
      equal_1790_s21_q <= equal_1790_s20_q;
      select_1804_s21_q <= select_1804_s20_q;
      select_1806_s21_q <= select_1806;
      equal_1812_s21_q <= equal_1812;
      select_1818_s21_q <= select_1818_s20_q;
      select_1824_s21_q <= select_1824_s20_q;
      select_1835_s21_q <= select_1835;
      equal_1841_s21_q <= equal_1841;
      or_1856_s21_q <= and_1676_s20_q | (select_1806 & equal_1854_s20_q);
      or_1860_s21_q <= and_1676_s20_q | (select_1835 & equal_1858_s20_q);
      select_1863_s21_q <= select_1863_s20_q;
      less_1967_s21_q <= less_1967_s20_q;
      equal_1968_s21_q <= equal_1968_s20_q;
      not_1969_s21_q <= not_1969_s20_q;
      equal_1970_s21_q <= equal_1970_s20_q;
      not_1997_s21_q <= not_1997_s20_q;
      index_s21_q <= index[2:0];
      sum_2056_s21_q <= sum_2056;
      and_2063_s21_q <= began_q & (seen_x_q == 4'h0);
      less_2064_s21_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s21_q <= index_2[2:0];
      sum_2069_s21_q <= sum_2069;
      equal_2082_s21_q <= t[4:1] == 4'h0;
      not_2102_s21_q <= ~((good_q & select_2099) == 48'h0);
      not_2118_s21_q <= ~({sum_2116, around_s20_q[0]} < {2'h0, t});
      less_2132_s21_q <= less_2132_s20_q;
      and_2143_s21_q <= and_2143_s20_q;
      sum_2273_s21_q <= {1'b0, sum_2269} + {2'h0, sum_2272_s20_q};
      sum_2276_s21_q <= sum_2276_s20_q;
      equal_2284_s21_q <= equal_2284_s20_q;
      equal_2299_s21_q <= equal_2299_s20_q;
      not_2311_s21_q <= ~({3'h0, counts_turned_left_s20_q} < sum_2309);
      not_2321_s21_q <= ~({3'h0, counts_turned_right_s20_q} < sum_2309);
      select_2363_s21_q <= sample_pair_whole_s20_q ? {detail_2, detail} : 28'h0;
      and_2376_s21_q <= and_2376;
      and_2388_s21_q <= and_2388;
      select_2395_s21_q <= and_2376 ? contrast_s20_q : 9'h0;
      select_2399_s21_q <= and_2388 ? contrast_2_s20_q : 9'h0;
      equal_2402_s21_q <= equal_2402_s20_q;
      less_2403_s21_q <= 7'h2 < {x_s20_q[4:0], slot_s20_q[2:1]};
      select_2408_s21_q <= select_2408;
      equal_2446_s21_q <= {x_s20_q[4:0], slot_s20_q} == 8'h0;
      and_2598_s21_q <= and_2598_s20_q;
      not_2623_s21_q <= not_2623_s20_q;
      not_2638_s21_q <= ~({sum_2636, e_s20_q[0]} < {2'h0, t});
      select_2649_s21_q <= select_2649_s20_q;
      select_2652_s21_q <= select_2652_s20_q;
      less_2654_s21_q <= {sum_2653, select_2652_s20_q[1:0]} < {3'h0, select_2649_s20_q};
      and_2700_s21_q <= and_2700_s20_q;
      equal_2899_s21_q <= equal_2899;
      not_2912_s21_q <= ~(equal_575_s20_q & and_2910);
      and_2934_s21_q <= and_2934;
      parity_3231_s21_q <= ^{xor_3227, xor_3190_s20_q, select_3157_s20_q, other_s20_q};
      or_3235_s21_q <= or_3235_s20_q;
      or_3239_s21_q <= or_3239_s20_q;
      or_3243_s21_q <= or_3243_s20_q;
      or_3250_s21_q <= or_3250_s20_q;
      or_3254_s21_q <= or_3254_s20_q;
      or_3258_s21_q <= or_3258_s20_q;
      or_3265_s21_q <= or_3265_s20_q;
      or_3269_s21_q <= or_3269_s20_q;
      or_3273_s21_q <= or_3273_s20_q;
      or_3283_s21_q <= or_3283_s20_q;
      or_3287_s21_q <= or_3287_s20_q;
      or_3291_s21_q <= or_3291_s20_q;
      or_3299_s21_q <= or_3299_s20_q;
      or_3303_s21_q <= or_3303_s20_q;
      or_3307_s21_q <= or_3307_s20_q;
      or_3314_s21_q <= or_3314_s20_q;
      or_3318_s21_q <= or_3318_s20_q;
      or_3322_s21_q <= or_3322_s20_q;
      or_3332_s21_q <= or_3332_s20_q;
      or_3336_s21_q <= or_3336_s20_q;
      or_3340_s21_q <= or_3340_s20_q;
      and_3344_s21_q <= xor_3190_s20_q & (^{xor_3227, select_3157_s20_q, other_s20_q});
      or_3348_s21_q <= and_3345_s20_q | (xor_3172_s20_q & or_3346_s20_q);
      or_3352_s21_q <= or_3352;
      equal_3467_s21_q <= equal_3467_s20_q;
      select_3555_s21_q <= select_3555_s20_q;
      select_3586_s21_q <= select_3586_s20_q[9:0];
      select_3596_s21_q <= select_3596_s20_q;
      less_3629_s21_q <= less_3629_s20_q;
      fraction_s21_q <= fraction;
      product_3656_s21_q <= product_3656[18:5];
      equal_3707_s21_q <= equal_3707_s20_q;
      less_3832_s21_q <= {{4{sum_3831[11]}}, sum_3831} < 16'h3;
      or_3929_s21_q <= or_3929_s20_q;
      select_3937_s21_q <= select_3937_s20_q;
      equal_3948_s21_q <= equal_3948;
      equal_3951_s21_q <= equal_3951_s20_q;
      equal_3953_s21_q <= equal_3953_s20_q;
      equal_3954_s21_q <= equal_3954_s20_q;
      equal_3955_s21_q <= equal_3955_s20_q;
      equal_3956_s21_q <= equal_3956_s20_q;
      select_4195_s21_q <= select_4195_s20_q;
      select_4202_s21_q <= select_4202_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
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
  assign whole_17 = census_columns_values_2_cell_4_mask_s21_q & whole_16_s21_q;
  logic whole_18;
  assign whole_18 = census_columns_values_3_cell_0_mask_s21_q & whole_17;
  logic whole_19;
  assign whole_19 = census_columns_values_3_cell_1_mask_s21_q & whole_18;
  logic whole_20;
  assign whole_20 = census_columns_values_3_cell_2_mask_s21_q & whole_19;
  logic whole_21;
  assign whole_21 = census_columns_values_3_cell_3_mask_s21_q & whole_20;
  logic whole_22;
  assign whole_22 = census_columns_values_3_cell_4_mask_q & whole_21;
  // hls/stages/census.hpp:281
  logic [11:0] texture;
  assign texture = sum_725_s21_q + {2'h0, sum_728_s21_q};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1857;
  assign select_1857 = or_1856_s21_q ? {and_1676_s21_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1861;
  assign select_1861 = or_1860_s21_q ? {and_1676_s21_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_4;
  assign column_4 = select_1857[4] ? select_1861[3:0] : select_1857[3:0];
  logic and_1866;
  assign and_1866 = select_1824_s21_q & (select_1818_s21_q[3] ^ select_1818_s21_q[4]);
  logic and_1871;
  assign and_1871 = sample_pair_whole_s21_q & (and_1866 & ((~select_1857[4]) | (~select_1861[4])));
  // hls/stages/agreement.hpp:1030
  logic and_2103;
  assign and_2103 = good_known_q & not_2102_s21_q;
  // hls/stages/agreement.hpp:1103
  logic is_seen;
  assign is_seen = equal_2082_s21_q ? and_2103 : not_2118_s21_q;
  // hls/stages/agreement.hpp:520
  logic select_2257;
  assign select_2257 = and_550_s21_q ? census_columns_values_2_cell_4_mask_s21_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:283
  logic [11:0] sum_2277;
  assign sum_2277 = sum_2273_s21_q + {2'h0, sum_2276_s21_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2279;
  assign select_2279 = and_550_s21_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2280;
  assign select_2280 = and_550_s21_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:94
  logic and_2346;
  assign and_2346 = moments_right_alone_s21_q & (moments_right_begins_q | moments_right_other_stops_s21_q);
  logic or_2348;
  assign or_2348 = moments_left_begins_q | (moments_left_other_stops_s21_q | and_2346);
  logic and_2350;
  assign and_2350 = cfg_same_table_i & (moments_left_alone_s21_q ? or_2348 : and_2346);
  // hls/stages/moments.hpp:95
  logic and_2356;
  assign and_2356 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/agreement.hpp:520
  logic [13:0] select_2364;
  assign select_2364 = and_550_s21_q ? select_2363_s21_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2365;
  assign select_2365 = and_550_s21_q ? select_2363_s21_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:369
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2363_s21_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2363_s21_q[27:14]};
  // hls/stages/census.hpp:372
  logic [23:0] sum_2396;
  assign sum_2396 = (equal_2284_s21_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2395_s21_q};
  logic [23:0] sum_2400;
  assign sum_2400 = (equal_2284_s21_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2399_s21_q};
  // hls/stages/census.hpp:424
  logic less_2404;
  assign less_2404 = x_s21_q[4:0] < 5'h3;
  logic [23:0] select_2409;
  assign select_2409 = slot_s21_q ? {select_2408_s21_q[11], 1'b0, select_2408_s21_q[10], 1'b0, select_2408_s21_q[9], 1'b0, select_2408_s21_q[8], 1'b0, select_2408_s21_q[7], 1'b0, select_2408_s21_q[6], 1'b0, select_2408_s21_q[5], 1'b0, select_2408_s21_q[4], 1'b0, select_2408_s21_q[3], 1'b0, select_2408_s21_q[2], 1'b0, select_2408_s21_q[1], 1'b0, select_2408_s21_q[0], 1'b0} : {1'b0, select_2408_s21_q[11], 1'b0, select_2408_s21_q[10], 1'b0, select_2408_s21_q[9], 1'b0, select_2408_s21_q[8], 1'b0, select_2408_s21_q[7], 1'b0, select_2408_s21_q[6], 1'b0, select_2408_s21_q[5], 1'b0, select_2408_s21_q[4], 1'b0, select_2408_s21_q[3], 1'b0, select_2408_s21_q[2], 1'b0, select_2408_s21_q[1], 1'b0, select_2408_s21_q[0]};
  // hls/stages/census.hpp:387
  logic and_2413;
  assign and_2413 = less_2404 & (~((sharpness_sums_contrast_1_q & select_2409) == 24'h0));
  logic and_2423;
  assign and_2423 = less_2404 & (~((sharpness_sums_contrast_0_q & select_2409) == 24'h0));
  // hls/stages/agreement.hpp:1106
  logic not_2640;
  assign not_2640 = ~(equal_2082_s21_q ? and_2103 : not_2638_s21_q);
  // hls/stages/agreement.hpp:788
  logic and_2643;
  assign and_2643 = ends_cell_s21_q & (not_2623_s21_q & (centres_values_1_textured_s21_q & not_2640));
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_2656;
  assign select_2656 = ((~(select_2649_s21_q[9:4] == 6'h0)) & less_2654_s21_q) ? select_2649_s21_q : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2659;
  assign select_2659 = equal_575_s21_q ? (x_s21_q[6] ? (equal_1608_s21_q ? 10'h0 : select_2656) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1110
  logic and_2677;
  assign and_2677 = centres_values_1_textured_s21_q & (centres_values_1_of_skin_s21_q & not_2640);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3044;
  assign select_3044 = sample_pair_whole_s21_q ? (select_1857[4] ? {1'b1, select_1857[3:0]} : (select_1857 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3047;
  assign select_3047 = sample_pair_whole_s21_q ? (select_1861[4] ? {1'b1, select_1861[3:0]} : (select_1861 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3261;
  assign parity_3261 = ^{or_3258_s21_q, or_3254_s21_q, or_3250_s21_q};
  logic parity_3276;
  assign parity_3276 = ^{or_3273_s21_q, or_3269_s21_q, or_3265_s21_q};
  logic parity_3279;
  assign parity_3279 = ^{or_3273_s21_q, or_3269_s21_q, or_3265_s21_q, or_3258_s21_q, or_3254_s21_q, or_3250_s21_q, or_3243_s21_q, or_3239_s21_q, or_3235_s21_q};
  logic parity_3310;
  assign parity_3310 = ^{or_3307_s21_q, or_3303_s21_q, or_3299_s21_q};
  logic parity_3325;
  assign parity_3325 = ^{or_3322_s21_q, or_3318_s21_q, or_3314_s21_q};
  logic parity_3328;
  assign parity_3328 = ^{or_3322_s21_q, or_3318_s21_q, or_3314_s21_q, or_3307_s21_q, or_3303_s21_q, or_3299_s21_q, or_3291_s21_q, or_3287_s21_q, or_3283_s21_q};
  logic parity_3343;
  assign parity_3343 = ^{or_3340_s21_q, or_3336_s21_q, or_3332_s21_q};
  logic parity_3355;
  assign parity_3355 = ^{or_3352_s21_q, or_3348_s21_q, and_3344_s21_q};
  logic parity_3358;
  assign parity_3358 = ^{or_3352_s21_q, or_3348_s21_q, and_3344_s21_q, or_3340_s21_q, or_3336_s21_q, or_3332_s21_q, or_3322_s21_q, or_3318_s21_q, or_3314_s21_q, or_3307_s21_q, or_3303_s21_q, or_3299_s21_q, or_3291_s21_q, or_3287_s21_q, or_3283_s21_q};
  logic parity_3360;
  assign parity_3360 = ^{or_3352_s21_q, or_3348_s21_q, and_3344_s21_q, or_3340_s21_q, or_3336_s21_q, or_3332_s21_q, or_3322_s21_q, or_3318_s21_q, or_3314_s21_q, or_3307_s21_q, or_3303_s21_q, or_3299_s21_q, or_3291_s21_q, or_3287_s21_q, or_3283_s21_q, or_3273_s21_q, or_3269_s21_q, or_3265_s21_q, or_3258_s21_q, or_3254_s21_q, or_3250_s21_q, or_3243_s21_q, or_3239_s21_q, or_3235_s21_q};
  // hls/stages/count_bits.hpp:25
  logic and_3361;
  assign and_3361 = parity_3279 & parity_3358;
  logic and_3364;
  assign and_3364 = (^{or_3243_s21_q, or_3239_s21_q, or_3235_s21_q}) & (parity_3261 | parity_3276);
  logic or_3365;
  assign or_3365 = (parity_3261 & parity_3276) | and_3364;
  logic or_3369;
  assign or_3369 = (parity_3343 & parity_3355) | (parity_3328 & (parity_3343 | parity_3355));
  logic and_3375;
  assign and_3375 = (^{or_3291_s21_q, or_3287_s21_q, or_3283_s21_q}) & (parity_3310 | parity_3325);
  logic or_3376;
  assign or_3376 = (parity_3310 & parity_3325) | and_3375;
  logic or_3380;
  assign or_3380 = (or_3336_s21_q & or_3340_s21_q) | (or_3332_s21_q & (or_3336_s21_q | or_3340_s21_q));
  logic or_3384;
  assign or_3384 = (or_3348_s21_q & or_3352_s21_q) | (and_3344_s21_q & (or_3348_s21_q | or_3352_s21_q));
  // hls/stages/count_bits.hpp:23
  logic or_3391;
  assign or_3391 = (or_3287_s21_q & or_3291_s21_q) | (or_3283_s21_q & (or_3287_s21_q | or_3291_s21_q));
  // hls/stages/count_bits.hpp:25
  logic or_3395;
  assign or_3395 = (or_3303_s21_q & or_3307_s21_q) | (or_3299_s21_q & (or_3303_s21_q | or_3307_s21_q));
  logic or_3399;
  assign or_3399 = (or_3318_s21_q & or_3322_s21_q) | (or_3314_s21_q & (or_3318_s21_q | or_3322_s21_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3402;
  assign parity_3402 = ^{or_3399, or_3395, or_3391};
  // hls/stages/count_bits.hpp:23
  logic or_3406;
  assign or_3406 = (or_3239_s21_q & or_3243_s21_q) | (or_3235_s21_q & (or_3239_s21_q | or_3243_s21_q));
  // hls/stages/count_bits.hpp:25
  logic or_3410;
  assign or_3410 = (or_3254_s21_q & or_3258_s21_q) | (or_3250_s21_q & (or_3254_s21_q | or_3258_s21_q));
  logic or_3414;
  assign or_3414 = (or_3269_s21_q & or_3273_s21_q) | (or_3265_s21_q & (or_3269_s21_q | or_3273_s21_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3417;
  assign parity_3417 = ^{or_3414, or_3410, or_3406};
  logic parity_3420;
  assign parity_3420 = ^{or_3414, or_3410, or_3406, or_3399, or_3395, or_3391, or_3384, or_3380, or_3376};
  // hls/stages/patches.hpp:594
  logic [9:0] difference_3599;
  assign difference_3599 = select_3596_s21_q - select_3586_s21_q;
  // hls/stages/patches.hpp:599
  logic or_3606;
  assign or_3606 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3586_s21_q);
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3630;
  assign sum_3630 = select_3555_s21_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:586
  logic [7:0] difference_3650;
  assign difference_3650 = {sum_3630, select_3555_s21_q[2:0], 3'h0} - {5'h0, fraction_s21_q};
  logic [7:0] select_3651;
  assign select_3651 = less_3629_s21_q ? difference_3650 : {sum_3630, select_3555_s21_q[2:0], fraction_s21_q};
  // hls/stages/agreement.hpp:788
  logic select_3950;
  assign select_3950 = equal_575_s21_q ? ((x_s21_q[6] & good_known_q) | equal_3948_s21_q) : good_known_q;
  // hls/stages/agreement.hpp:1308
  logic and_4125;
  assign and_4125 = and_2143_s21_q & ({sum_2069_s21_q, index_2_s21_q} == {sum_2056_s21_q, index_s21_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1409; read in stage 21, written in stage 22: 21 < 22 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2056_s21_q, index_s21_q};
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s21_en & (and_2063_s21_q & less_2064_s21_q);
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1614_s21_q, lower_half_s21_q, registration_of_right_s21_q};
  logic registration_sums_we;
  assign registration_sums_we = s21_en & and_1673_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1672_s21_q, sum_1668_s21_q};
  end
`ifndef SYNTHESIS
  logic [3:0] registration_sums_raddr_s18_sim;
  logic registration_sums_re_s18_sim;
  logic [3:0] registration_sums_raddr_s19_sim;
  logic registration_sums_re_s19_sim;
  logic [3:0] registration_sums_raddr_s20_sim;
  logic registration_sums_re_s20_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      registration_sums_re_s18_sim <= 1'b0;
      registration_sums_re_s19_sim <= 1'b0;
      registration_sums_re_s20_sim <= 1'b0;
    end else if (en_i) begin
      registration_sums_re_s18_sim <= registration_sums_re;
      registration_sums_raddr_s18_sim <= registration_sums_raddr;
      registration_sums_re_s19_sim <= registration_sums_re_s18_sim;
      registration_sums_raddr_s19_sim <= registration_sums_raddr_s18_sim;
      registration_sums_re_s20_sim <= registration_sums_re_s19_sim;
      registration_sums_raddr_s20_sim <= registration_sums_raddr_s19_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && registration_sums_we) begin
      if (registration_sums_re && registration_sums_raddr == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s18_sim && registration_sums_raddr_s18_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s19_sim && registration_sums_raddr_s19_sim == registration_sums_waddr) begin
        $error("registration_sums: address %0d is read less than DISTANCE steps after its write", registration_sums_waddr);
      end
      if (registration_sums_re_s20_sim && registration_sums_raddr_s20_sim == registration_sums_waddr) begin
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
    end else if (s21_en) begin
      moments_left_begins_q <= equal_575_s21_q ? not_2311_s21_q : moments_left_begins_q;
      moments_right_begins_q <= equal_575_s21_q ? not_2321_s21_q : moments_right_begins_q;
      moments_ends_q <= equal_575_s21_q & (equal_2299_s21_q & (not_2354 | and_2356));
      sharpness_sums_contrast_0_q <= and_550_s21_q ? sum_2396 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_550_s21_q ? sum_2400 : sharpness_sums_contrast_1_q;
      registration_moved_q <= not_2912_s21_q & (registration_moved_q | and_2934_s21_q);
      patches_left_next_0_q <= select_3044;
      patches_left_next_1_q <= select_3047;
      good_known_q <= select_3950;
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
    if (s21_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2257;
      census_changes_values_0_left_q <= and_550_s21_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_550_s21_q ? sum_2277 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2279;
      census_changes_values_1_right_q <= select_2280;
      sharpness_last_detail_0_q <= select_2364;
      sharpness_last_detail_1_q <= select_2365;
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
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic [11:0] census_changes_values_1_left_s22_q;
  logic [11:0] census_changes_values_1_right_s22_q;
  logic [23:0] sharpness_sums_contrast_0_s22_q;
  logic [23:0] sharpness_sums_contrast_1_s22_q;
  logic [6:0] x_s22_q;
  logic [13:0] counts_nearer_s22_q;
  logic registration_moved_s22_q;
  logic patches_lower_s22_q;
  logic patches_second_s22_q;
  logic [4:0] patches_summed_row_column_s22_q;
  logic patches_summed_first_s22_q;
  logic patches_summed_last_s22_q;
  logic [4:0] patches_summed_down_by_s22_q;
  logic [13:0] product_s22_q;
  logic done_s22_q;
  logic [6:0] last_s22_q;
  logic and_550_s22_q;
  logic equal_575_s22_q;
  logic not_576_s22_q;
  logic so_s22_q;
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
  logic less_673_s22_q;
  logic less_674_s22_q;
  logic less_675_s22_q;
  logic less_676_s22_q;
  logic and_684_s22_q;
  logic and_709_s22_q;
  logic and_710_s22_q;
  logic [12:0] sum_730_s22_q;
  logic and_736_s22_q;
  logic and_740_s22_q;
  logic less_741_s22_q;
  logic less_745_s22_q;
  logic less_747_s22_q;
  logic equal_1608_s22_q;
  logic equal_1616_s22_q;
  logic equal_1618_s22_q;
  logic equal_1620_s22_q;
  logic equal_1622_s22_q;
  logic equal_1624_s22_q;
  logic equal_1626_s22_q;
  logic and_1676_s22_q;
  logic select_1693_s22_q;
  logic equal_1694_s22_q;
  logic equal_1788_s22_q;
  logic equal_1790_s22_q;
  logic select_1804_s22_q;
  logic or_1814_s22_q;
  logic [4:0] select_1818_s22_q;
  logic select_1824_s22_q;
  logic or_1843_s22_q;
  logic [3:0] column_4_s22_q;
  logic [3:0] select_1863_s22_q;
  logic select_1864_s22_q;
  logic and_1871_s22_q;
  logic less_1967_s22_q;
  logic equal_1968_s22_q;
  logic not_1969_s22_q;
  logic equal_1970_s22_q;
  logic not_1997_s22_q;
  logic and_2063_s22_q;
  logic less_2064_s22_q;
  logic [2:0] index_2_s22_q;
  logic [10:0] sum_2069_s22_q;
  logic is_seen_s22_q;
  logic and_2133_s22_q;
  logic and_2143_s22_q;
  logic equal_2284_s22_q;
  logic [12:0] sum_2285_s22_q;
  logic equal_2299_s22_q;
  logic not_2330_s22_q;
  logic and_2351_s22_q;
  logic [12:0] select_2378_s22_q;
  logic [12:0] select_2390_s22_q;
  logic equal_2402_s22_q;
  logic less_2403_s22_q;
  logic and_2413_s22_q;
  logic and_2423_s22_q;
  logic equal_2446_s22_q;
  logic and_2598_s22_q;
  logic and_2645_s22_q;
  logic [9:0] select_2649_s22_q;
  logic [9:0] select_2652_s22_q;
  logic [9:0] select_2659_s22_q;
  logic and_2680_s22_q;
  logic and_2700_s22_q;
  logic equal_2899_s22_q;
  logic parity_3231_s22_q;
  logic parity_3360_s22_q;
  logic and_3361_s22_q;
  logic or_3365_s22_q;
  logic or_3369_s22_q;
  logic or_3376_s22_q;
  logic or_3380_s22_q;
  logic or_3384_s22_q;
  logic or_3391_s22_q;
  logic or_3395_s22_q;
  logic or_3399_s22_q;
  logic or_3406_s22_q;
  logic or_3410_s22_q;
  logic or_3414_s22_q;
  logic parity_3420_s22_q;
  logic or_3430_s22_q;
  logic or_3434_s22_q;
  logic and_3441_s22_q;
  logic and_3443_s22_q;
  logic and_3445_s22_q;
  logic equal_3467_s22_q;
  logic equal_3598_s22_q;
  logic less_3600_s22_q;
  logic less_3601_s22_q;
  logic or_3606_s22_q;
  logic [7:0] select_3651_s22_q;
  logic [13:0] product_3656_s22_q;
  logic equal_3707_s22_q;
  logic less_3832_s22_q;
  logic or_3929_s22_q;
  logic select_3937_s22_q;
  logic equal_3948_s22_q;
  logic equal_3951_s22_q;
  logic equal_3953_s22_q;
  logic equal_3954_s22_q;
  logic equal_3955_s22_q;
  logic equal_3956_s22_q;
  logic and_4110_s22_q;
  logic and_4125_s22_q;
  logic [31:0] select_4195_s22_q;
  logic [9:0] select_4202_s22_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s22_q <= pixel_0_s21_q;
      pixel_1_s22_q <= pixel_1_s21_q;
      saturated_s22_q <= saturated_s21_q;
      mask_s22_q <= mask_s21_q;
      marks_first_s22_q <= marks_first_s21_q;
      marks_last_s22_q <= marks_last_s21_q;
      sample_pair_pixel_0_s22_q <= sample_pair_pixel_0_s21_q;
      sample_pair_pixel_1_s22_q <= sample_pair_pixel_1_s21_q;
      sample_pair_whole_s22_q <= sample_pair_whole_s21_q;
      sample_present_s22_q <= sample_present_s21_q;
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_s21_q;
      census_changes_values_1_left_s22_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s22_q <= census_changes_values_1_right_q;
      sharpness_sums_contrast_0_s22_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s22_q <= sharpness_sums_contrast_1_q;
      x_s22_q <= x_s21_q;
      counts_nearer_s22_q <= counts_nearer_s21_q;
      registration_moved_s22_q <= registration_moved_q;
      patches_lower_s22_q <= patches_lower_s21_q;
      patches_second_s22_q <= patches_second_s21_q;
      patches_summed_row_column_s22_q <= patches_summed_row_column_s21_q;
      patches_summed_first_s22_q <= patches_summed_first_s21_q;
      patches_summed_last_s22_q <= patches_summed_last_s21_q;
      patches_summed_down_by_s22_q <= patches_summed_down_by_s21_q;
      product_s22_q <= product_s21_q;
      done_s22_q <= done_s21_q;
      last_s22_q <= last_s21_q;
      and_550_s22_q <= and_550_s21_q;
      equal_575_s22_q <= equal_575_s21_q;
      not_576_s22_q <= not_576_s21_q;
      so_s22_q <= drew_q;
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
      less_673_s22_q <= less_673_s21_q;
      less_674_s22_q <= less_674_s21_q;
      less_675_s22_q <= less_675_s21_q;
      less_676_s22_q <= less_676_s21_q;
      and_684_s22_q <= and_684_s21_q;
      and_709_s22_q <= whole_22 & and_684_s21_q;
      and_710_s22_q <= and_710_s21_q;
      sum_730_s22_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_736_s22_q <= and_736_s21_q;
      and_740_s22_q <= and_740_s21_q;
      less_741_s22_q <= less_741_s21_q;
      less_745_s22_q <= less_745_s21_q;
      less_747_s22_q <= less_747_s21_q;
      equal_1608_s22_q <= equal_1608_s21_q;
      equal_1616_s22_q <= equal_1616_s21_q;
      equal_1618_s22_q <= equal_1618_s21_q;
      equal_1620_s22_q <= equal_1620_s21_q;
      equal_1622_s22_q <= equal_1622_s21_q;
      equal_1624_s22_q <= equal_1624_s21_q;
      equal_1626_s22_q <= equal_1626_s21_q;
      and_1676_s22_q <= and_1676_s21_q;
      select_1693_s22_q <= select_1693_s21_q;
      equal_1694_s22_q <= equal_1694_s21_q;
      equal_1788_s22_q <= equal_1788_s21_q;
      equal_1790_s22_q <= equal_1790_s21_q;
      select_1804_s22_q <= select_1804_s21_q;
      or_1814_s22_q <= and_1676_s21_q | (select_1806_s21_q & equal_1812_s21_q);
      select_1818_s22_q <= select_1818_s21_q;
      select_1824_s22_q <= select_1824_s21_q;
      or_1843_s22_q <= and_1676_s21_q | (select_1835_s21_q & equal_1841_s21_q);
      column_4_s22_q <= column_4;
      select_1863_s22_q <= select_1863_s21_q;
      select_1864_s22_q <= or_1856_s21_q ? and_1676_s21_q : patches_left_next_0_q[4];
      and_1871_s22_q <= and_1871;
      less_1967_s22_q <= less_1967_s21_q;
      equal_1968_s22_q <= equal_1968_s21_q;
      not_1969_s22_q <= not_1969_s21_q;
      equal_1970_s22_q <= equal_1970_s21_q;
      not_1997_s22_q <= not_1997_s21_q;
      and_2063_s22_q <= and_2063_s21_q;
      less_2064_s22_q <= less_2064_s21_q;
      index_2_s22_q <= index_2_s21_q;
      sum_2069_s22_q <= sum_2069_s21_q;
      is_seen_s22_q <= is_seen;
      and_2133_s22_q <= is_seen & less_2132_s21_q;
      and_2143_s22_q <= and_2143_s21_q;
      equal_2284_s22_q <= equal_2284_s21_q;
      sum_2285_s22_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2277};
      equal_2299_s22_q <= equal_2299_s21_q;
      not_2330_s22_q <= ~moments_ends_q;
      and_2351_s22_q <= cfg_prove_i & and_2350;
      select_2378_s22_q <= and_2376_s21_q ? detail_3[14:2] : 13'h0;
      select_2390_s22_q <= and_2388_s21_q ? detail_4[14:2] : 13'h0;
      equal_2402_s22_q <= equal_2402_s21_q;
      less_2403_s22_q <= less_2403_s21_q;
      and_2413_s22_q <= and_2413;
      and_2423_s22_q <= and_2423;
      equal_2446_s22_q <= equal_2446_s21_q;
      and_2598_s22_q <= and_2598_s21_q;
      and_2645_s22_q <= not_576_s21_q & (drew_q & and_2643);
      select_2649_s22_q <= select_2649_s21_q;
      select_2652_s22_q <= select_2652_s21_q;
      select_2659_s22_q <= select_2659;
      and_2680_s22_q <= drew_q & (ends_cell_s21_q & (not_2623_s21_q & and_2677));
      and_2700_s22_q <= and_2700_s21_q;
      equal_2899_s22_q <= equal_2899_s21_q;
      parity_3231_s22_q <= parity_3231_s21_q;
      parity_3360_s22_q <= parity_3360;
      and_3361_s22_q <= and_3361;
      or_3365_s22_q <= or_3365;
      or_3369_s22_q <= or_3369;
      or_3376_s22_q <= or_3376;
      or_3380_s22_q <= or_3380;
      or_3384_s22_q <= or_3384;
      or_3391_s22_q <= or_3391;
      or_3395_s22_q <= or_3395;
      or_3399_s22_q <= or_3399;
      or_3406_s22_q <= or_3406;
      or_3410_s22_q <= or_3410;
      or_3414_s22_q <= or_3414;
      parity_3420_s22_q <= parity_3420;
      or_3430_s22_q <= (or_3395 & or_3399) | (or_3391 & (or_3395 | or_3399));
      or_3434_s22_q <= (or_3410 & or_3414) | (or_3406 & (or_3410 | or_3414));
      and_3441_s22_q <= and_3361 & (or_3365 | or_3369);
      and_3443_s22_q <= parity_3402 & parity_3417;
      and_3445_s22_q <= (^{or_3384, or_3380, or_3376}) & (parity_3402 | parity_3417);
      equal_3467_s22_q <= equal_3467_s21_q;
      equal_3598_s22_q <= select_3555_s21_q[3:0] == 4'h0;
      less_3600_s22_q <= {difference_3599, 3'h0} < {3'h0, patches_size_q};
      less_3601_s22_q <= select_3596_s21_q < select_3586_s21_q;
      or_3606_s22_q <= or_3606;
      select_3651_s22_q <= select_3651;
      product_3656_s22_q <= product_3656_s21_q;
      equal_3707_s22_q <= equal_3707_s21_q;
      less_3832_s22_q <= less_3832_s21_q;
      or_3929_s22_q <= or_3929_s21_q;
      select_3937_s22_q <= select_3937_s21_q;
      equal_3948_s22_q <= equal_3948_s21_q;
      equal_3951_s22_q <= equal_3951_s21_q;
      equal_3953_s22_q <= equal_3953_s21_q;
      equal_3954_s22_q <= equal_3954_s21_q;
      equal_3955_s22_q <= equal_3955_s21_q;
      equal_3956_s22_q <= equal_3956_s21_q;
      and_4110_s22_q <= said_q;
      and_4125_s22_q <= and_4125;
      select_4195_s22_q <= select_4195_s21_q;
      select_4202_s22_q <= select_4202_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:292
  logic [13:0] sum_731;
  assign sum_731 = {2'h0, census_changes_values_1_left_s22_q} + {1'b0, sum_730_s22_q};
  logic [13:0] sum_732;
  assign sum_732 = {2'h0, census_changes_values_2_left_q} + sum_731;
  // hls/stages/patches.hpp:133
  logic [5:0] select_1825;
  assign select_1825 = or_1814_s22_q ? {and_1676_s22_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1827;
  assign and_1827 = select_1824_s22_q & (~select_1825[5]);
  // hls/stages/patches.hpp:133
  logic [5:0] select_1845;
  assign select_1845 = or_1843_s22_q ? {and_1676_s22_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1847;
  assign and_1847 = select_1824_s22_q & (~select_1845[5]);
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2281;
  assign select_2281 = and_550_s22_q ? census_changes_values_1_left_s22_q : census_changes_values_2_left_q;
  logic [11:0] select_2282;
  assign select_2282 = and_550_s22_q ? census_changes_values_1_right_s22_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:293
  logic [13:0] sum_2286;
  assign sum_2286 = {2'h0, census_changes_values_1_right_s22_q} + {1'b0, sum_2285_s22_q};
  logic [13:0] sum_2287;
  assign sum_2287 = {2'h0, census_changes_values_2_right_q} + sum_2286;
  // hls/stages/moments.hpp:51
  logic or_2332;
  assign or_2332 = moments_begins_alone_q | (moments_out_of_step_q & not_2330_s22_q);
  // hls/stages/census.hpp:372
  logic [23:0] select_2380;
  assign select_2380 = equal_2284_s22_q ? {11'h0, select_2378_s22_q} : (sharpness_sums_detail_0_q + {11'h0, select_2378_s22_q});
  logic [23:0] select_2392;
  assign select_2392 = equal_2284_s22_q ? {11'h0, select_2390_s22_q} : (sharpness_sums_detail_1_q + {11'h0, select_2390_s22_q});
  // hls/stages/census.hpp:392
  logic [17:0] select_2415;
  assign select_2415 = (less_2403_s22_q & and_2413_s22_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2425;
  assign select_2425 = (less_2403_s22_q & and_2423_s22_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:216
  logic [1:0] select_2434;
  assign select_2434 = equal_2402_s22_q ? {sharpness_comparing_contrast_0_q[0], and_2423_s22_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2436;
  assign select_2436 = equal_2402_s22_q ? {sharpness_comparing_contrast_1_q[0], and_2413_s22_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic xor_2459;
  assign xor_2459 = sharpness_comparing_contrast_0_q[1] ^ and_2413_s22_q;
  logic select_2462;
  assign select_2462 = (equal_2446_s22_q | xor_2459) ? (and_2413_s22_q & xor_2459) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2463;
  assign select_2463 = equal_2402_s22_q ? select_2462 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:401
  logic xor_2465;
  assign xor_2465 = sharpness_comparing_contrast_1_q[1] ^ and_2423_s22_q;
  logic select_2468;
  assign select_2468 = (equal_2446_s22_q | xor_2465) ? (and_2423_s22_q & xor_2465) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2469;
  assign select_2469 = equal_2402_s22_q ? select_2468 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2647;
  assign select_2647 = and_2598_s22_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2645_s22_q});
  logic [13:0] select_2661;
  assign select_2661 = and_2598_s22_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2659_s22_q});
  // hls/stages/agreement.hpp:788
  logic and_2681;
  assign and_2681 = not_576_s22_q & and_2680_s22_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2683;
  assign select_2683 = and_2598_s22_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2681});
  logic [13:0] select_2702;
  assign select_2702 = and_2598_s22_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2700_s22_q});
  // hls/stages/patches.hpp:127
  logic select_3027;
  assign select_3027 = equal_1694_s22_q ? patches_valid_0_q : (select_1693_s22_q ? patches_valid_0_q : select_1804_s22_q);
  // hls/stages/agreement.hpp:276
  logic select_3030;
  assign select_3030 = sample_pair_whole_s22_q ? (and_1827 ? (sample_present_s22_q & select_3027) : select_3027) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3032;
  assign select_3032 = equal_1694_s22_q ? patches_valid_1_q : (select_1693_s22_q ? select_1804_s22_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3035;
  assign select_3035 = sample_pair_whole_s22_q ? (and_1847 ? (sample_present_s22_q & select_3032) : select_3032) : patches_valid_1_q;
  logic [5:0] select_3038;
  assign select_3038 = sample_pair_whole_s22_q ? (select_1825[5] ? {1'b1, select_1825[4:0]} : (select_1825 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3041;
  assign select_3041 = sample_pair_whole_s22_q ? (select_1845[5] ? {1'b1, select_1845[4:0]} : (select_1845 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3422;
  assign parity_3422 = ^{or_3414_s22_q, or_3410_s22_q, or_3406_s22_q, or_3399_s22_q, or_3395_s22_q, or_3391_s22_q, or_3384_s22_q, or_3380_s22_q, or_3376_s22_q, or_3369_s22_q, or_3365_s22_q, and_3361_s22_q};
  // hls/stages/count_bits.hpp:25
  logic or_3426;
  assign or_3426 = (or_3380_s22_q & or_3384_s22_q) | (or_3376_s22_q & (or_3380_s22_q | or_3384_s22_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3437;
  assign parity_3437 = ^{or_3434_s22_q, or_3430_s22_q, or_3426};
  // hls/stages/count_bits.hpp:25
  logic and_3438;
  assign and_3438 = (^{or_3369_s22_q, or_3365_s22_q, and_3361_s22_q}) & parity_3420_s22_q;
  logic or_3442;
  assign or_3442 = (or_3365_s22_q & or_3369_s22_q) | and_3441_s22_q;
  logic or_3446;
  assign or_3446 = and_3443_s22_q | and_3445_s22_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3449;
  assign parity_3449 = ^{or_3446, or_3442, and_3438};
  // hls/stages/count_bits.hpp:25
  logic and_3451;
  assign and_3451 = parity_3437 & parity_3449;
  logic or_3455;
  assign or_3455 = (or_3430_s22_q & or_3434_s22_q) | (or_3426 & (or_3430_s22_q | or_3434_s22_q));
  logic or_3459;
  assign or_3459 = (or_3442 & or_3446) | (and_3438 & (or_3442 | or_3446));
  // hls/stages/patches.hpp:599
  logic or_3607;
  assign or_3607 = (~(patches_second_s22_q ? patches_valid_1_q : patches_valid_0_q)) | or_3606_s22_q;
  logic or_3610;
  assign or_3610 = equal_3598_s22_q | (less_3600_s22_q | (less_3601_s22_q | or_3607));
  // hls/stages/patches.hpp:598
  logic [14:0] difference_3657;
  assign difference_3657 = {{7{select_3651_s22_q[7]}}, select_3651_s22_q} - {product_3656_s22_q[13], product_3656_s22_q};
  // hls/stages/patches.hpp:604
  logic less_3658;
  assign less_3658 = $signed({{8{difference_3628[6]}}, difference_3628}) < $signed(difference_3657);
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3958;
  assign select_3958 = equal_3955_s22_q ? counts_skin_unproven_q : (equal_3956_s22_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3960;
  assign select_3960 = equal_3954_s22_q ? counts_regions_bad_q : (equal_3951_s22_q ? counts_nearer_s22_q : select_3958);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3953_s22_q ? counts_on_skin_q : select_3960;
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4196;
  assign select_4196 = equal_1626_s22_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4195_s22_q;
  logic [31:0] select_4197;
  assign select_4197 = equal_1624_s22_q ? {8'h0, sharpness_sums_detail_0_q} : select_4196;
  logic [31:0] select_4198;
  assign select_4198 = equal_1622_s22_q ? {8'h0, sharpness_sums_detail_1_q} : select_4197;
  logic [31:0] select_4199;
  assign select_4199 = equal_1620_s22_q ? {8'h0, sharpness_sums_contrast_0_s22_q} : select_4198;
  logic [31:0] select_4200;
  assign select_4200 = equal_1618_s22_q ? {8'h0, sharpness_sums_contrast_1_s22_q} : select_4199;

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1864_s22_q, select_1863_s22_q, column_4_s22_q};
  logic patches_left_we;
  assign patches_left_we = s22_en & and_1871_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s22_q;
  end
`ifndef SYNTHESIS
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
  logic [8:0] patches_left_raddr_s21_sim;
  logic patches_left_re_s21_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_re_s12_sim <= 1'b0;
      patches_left_re_s13_sim <= 1'b0;
      patches_left_re_s14_sim <= 1'b0;
      patches_left_re_s15_sim <= 1'b0;
      patches_left_re_s16_sim <= 1'b0;
      patches_left_re_s17_sim <= 1'b0;
      patches_left_re_s18_sim <= 1'b0;
      patches_left_re_s19_sim <= 1'b0;
      patches_left_re_s20_sim <= 1'b0;
      patches_left_re_s21_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_re_s12_sim <= patches_left_re;
      patches_left_raddr_s12_sim <= patches_left_raddr;
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
      patches_left_re_s21_sim <= patches_left_re_s20_sim;
      patches_left_raddr_s21_sim <= patches_left_raddr_s20_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_we) begin
      if (patches_left_re && patches_left_raddr == patches_left_waddr) begin
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
      if (patches_left_re_s21_sim && patches_left_raddr_s21_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
    end
  end
`endif

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_2069_s22_q, index_2_s22_q};
  logic map_we;
  assign map_we = s22_en & and_2143_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2133_s22_q, is_seen_s22_q};
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
    end else if (s22_en) begin
      moments_out_of_step_q <= or_2332;
      moments_begins_alone_q <= equal_575_s22_q & (equal_2299_s22_q & and_2351_s22_q);
      sharpness_sums_detail_0_q <= and_550_s22_q ? select_2380 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_550_s22_q ? select_2392 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= so_s22_q ? select_2434 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s22_q ? select_2436 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= so_s22_q ? select_2463 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= so_s22_q ? select_2469 : sharpness_comparing_less_contrast_1_q;
      counts_unproven_q <= select_2647;
      counts_regions_bad_q <= select_2661;
      counts_skin_unproven_q <= select_2683;
      counts_on_skin_q <= select_2702;
      patches_valid_0_q <= select_3030;
      patches_valid_1_q <= select_3035;
      patches_right_next_0_q <= select_3038;
      patches_right_next_1_q <= select_3041;
      proven_q <= marks_first_s22_q ? done_s22_q : proven_q;
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
    if (s22_en) begin
      census_changes_values_2_left_q <= select_2281;
      census_changes_values_2_right_q <= select_2282;
    end
  end

  logic [7:0] pixel_0_s23_q;
  logic [7:0] pixel_1_s23_q;
  logic saturated_s23_q;
  logic mask_s23_q;
  logic marks_first_s23_q;
  logic marks_last_s23_q;
  logic [7:0] sample_pair_pixel_1_s23_q;
  logic census_columns_values_1_cell_2_of_skin_s23_q;
  logic [6:0] x_s23_q;
  logic registration_moved_s23_q;
  logic patches_lower_s23_q;
  logic patches_second_s23_q;
  logic [4:0] patches_summed_row_column_s23_q;
  logic patches_summed_first_s23_q;
  logic patches_summed_last_s23_q;
  logic [4:0] patches_summed_down_by_s23_q;
  logic [13:0] product_s23_q;
  logic [6:0] last_s23_q;
  logic and_550_s23_q;
  logic equal_575_s23_q;
  logic so_s23_q;
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
  logic less_673_s23_q;
  logic less_674_s23_q;
  logic less_675_s23_q;
  logic less_676_s23_q;
  logic and_684_s23_q;
  logic and_709_s23_q;
  logic and_710_s23_q;
  logic [8:0] sum_732_s23_q;
  logic and_740_s23_q;
  logic less_741_s23_q;
  logic and_746_s23_q;
  logic less_747_s23_q;
  logic equal_1608_s23_q;
  logic equal_1616_s23_q;
  logic equal_1788_s23_q;
  logic equal_1790_s23_q;
  logic [4:0] select_1815_s23_q;
  logic [4:0] select_1818_s23_q;
  logic and_1828_s23_q;
  logic [4:0] select_1844_s23_q;
  logic and_1848_s23_q;
  logic less_1967_s23_q;
  logic equal_1968_s23_q;
  logic not_1969_s23_q;
  logic equal_1970_s23_q;
  logic not_1997_s23_q;
  logic and_2063_s23_q;
  logic less_2064_s23_q;
  logic [1:0] map_rdata_s23_q;
  logic is_seen_s23_q;
  logic and_2133_s23_q;
  logic equal_2284_s23_q;
  logic [8:0] sum_2287_s23_q;
  logic equal_2402_s23_q;
  logic less_2403_s23_q;
  logic [17:0] select_2415_s23_q;
  logic [17:0] select_2425_s23_q;
  logic equal_2446_s23_q;
  logic [9:0] select_2649_s23_q;
  logic [9:0] select_2652_s23_q;
  logic equal_2899_s23_q;
  logic parity_3231_s23_q;
  logic parity_3360_s23_q;
  logic parity_3422_s23_q;
  logic xor_3450_s23_q;
  logic parity_3462_s23_q;
  logic and_3463_s23_q;
  logic and_3465_s23_q;
  logic equal_3467_s23_q;
  logic or_3610_s23_q;
  logic [5:0] difference_3657_s23_q;
  logic not_3659_s23_q;
  logic not_3669_s23_q;
  logic equal_3707_s23_q;
  logic less_3781_s23_q;
  logic less_3782_s23_q;
  logic and_3813_s23_q;
  logic less_3832_s23_q;
  logic or_3929_s23_q;
  logic select_3937_s23_q;
  logic equal_3948_s23_q;
  logic and_3952_s23_q;
  logic [13:0] before_v_4_s23_q;
  logic not_3997_s23_q;
  logic or_4001_s23_q;
  logic and_4006_s23_q;
  logic less_4007_s23_q;
  logic and_4110_s23_q;
  logic and_4125_s23_q;
  logic not_4139_s23_q;
  logic [31:0] select_4200_s23_q;
  logic [9:0] select_4202_s23_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s23_q <= pixel_0_s22_q;
      pixel_1_s23_q <= pixel_1_s22_q;
      saturated_s23_q <= saturated_s22_q;
      mask_s23_q <= mask_s22_q;
      marks_first_s23_q <= marks_first_s22_q;
      marks_last_s23_q <= marks_last_s22_q;
      sample_pair_pixel_1_s23_q <= sample_pair_pixel_1_s22_q;
      census_columns_values_1_cell_2_of_skin_s23_q <= census_columns_values_1_cell_2_of_skin_s22_q;
      x_s23_q <= x_s22_q;
      registration_moved_s23_q <= registration_moved_s22_q;
      patches_lower_s23_q <= patches_lower_s22_q;
      patches_second_s23_q <= patches_second_s22_q;
      patches_summed_row_column_s23_q <= patches_summed_row_column_s22_q;
      patches_summed_first_s23_q <= patches_summed_first_s22_q;
      patches_summed_last_s23_q <= patches_summed_last_s22_q;
      patches_summed_down_by_s23_q <= patches_summed_down_by_s22_q;
      product_s23_q <= product_s22_q;
      last_s23_q <= last_s22_q;
      and_550_s23_q <= and_550_s22_q;
      equal_575_s23_q <= equal_575_s22_q;
      so_s23_q <= so_s22_q;
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
      less_673_s23_q <= less_673_s22_q;
      less_674_s23_q <= less_674_s22_q;
      less_675_s23_q <= less_675_s22_q;
      less_676_s23_q <= less_676_s22_q;
      and_684_s23_q <= and_684_s22_q;
      and_709_s23_q <= and_709_s22_q;
      and_710_s23_q <= and_710_s22_q;
      sum_732_s23_q <= sum_732[13:5];
      and_740_s23_q <= and_740_s22_q;
      less_741_s23_q <= less_741_s22_q;
      and_746_s23_q <= (and_709_s22_q & and_736_s22_q) & less_745_s22_q;
      less_747_s23_q <= less_747_s22_q;
      equal_1608_s23_q <= equal_1608_s22_q;
      equal_1616_s23_q <= equal_1616_s22_q;
      equal_1788_s23_q <= equal_1788_s22_q;
      equal_1790_s23_q <= equal_1790_s22_q;
      select_1815_s23_q <= or_1814_s22_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1818_s23_q <= select_1818_s22_q;
      and_1828_s23_q <= sample_pair_whole_s22_q & and_1827;
      select_1844_s23_q <= or_1843_s22_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1848_s23_q <= sample_pair_whole_s22_q & and_1847;
      less_1967_s23_q <= less_1967_s22_q;
      equal_1968_s23_q <= equal_1968_s22_q;
      not_1969_s23_q <= not_1969_s22_q;
      equal_1970_s23_q <= equal_1970_s22_q;
      not_1997_s23_q <= not_1997_s22_q;
      and_2063_s23_q <= and_2063_s22_q;
      less_2064_s23_q <= less_2064_s22_q;
      map_rdata_s23_q <= map_rdata_q;
      is_seen_s23_q <= is_seen_s22_q;
      and_2133_s23_q <= and_2133_s22_q;
      equal_2284_s23_q <= equal_2284_s22_q;
      sum_2287_s23_q <= sum_2287[13:5];
      equal_2402_s23_q <= equal_2402_s22_q;
      less_2403_s23_q <= less_2403_s22_q;
      select_2415_s23_q <= select_2415;
      select_2425_s23_q <= select_2425;
      equal_2446_s23_q <= equal_2446_s22_q;
      select_2649_s23_q <= select_2649_s22_q;
      select_2652_s23_q <= select_2652_s22_q;
      equal_2899_s23_q <= equal_2899_s22_q;
      parity_3231_s23_q <= parity_3231_s22_q;
      parity_3360_s23_q <= parity_3360_s22_q;
      parity_3422_s23_q <= parity_3422;
      xor_3450_s23_q <= parity_3437 ^ parity_3449;
      parity_3462_s23_q <= ^{or_3459, or_3455, and_3451};
      and_3463_s23_q <= or_3455 & or_3459;
      and_3465_s23_q <= and_3451 & (or_3455 | or_3459);
      equal_3467_s23_q <= equal_3467_s22_q;
      or_3610_s23_q <= or_3610;
      difference_3657_s23_q <= difference_3657[5:0];
      not_3659_s23_q <= ~less_3658;
      not_3669_s23_q <= ~($signed(difference_3657) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3707_s23_q <= equal_3707_s22_q;
      less_3781_s23_q <= $signed(15'h10) < $signed(difference_3657);
      less_3782_s23_q <= $signed(difference_3657[14:4]) < $signed(11'h7ff);
      and_3813_s23_q <= equal_575_s22_q & equal_2299_s22_q;
      less_3832_s23_q <= less_3832_s22_q;
      or_3929_s23_q <= or_3929_s22_q;
      select_3937_s23_q <= select_3937_s22_q;
      equal_3948_s23_q <= equal_3948_s22_q;
      and_3952_s23_q <= equal_3951_s22_q & equal_3707_s22_q;
      before_v_4_s23_q <= before_v_4;
      not_3997_s23_q <= ~(equal_3956_s22_q & equal_3707_s22_q);
      or_4001_s23_q <= (equal_3956_s22_q | equal_3955_s22_q) | (x_s22_q[6:3] == 4'hf);
      and_4006_s23_q <= equal_3953_s22_q & equal_3707_s22_q;
      less_4007_s23_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4110_s23_q <= and_4110_s22_q;
      and_4125_s23_q <= and_4125_s22_q;
      not_4139_s23_q <= ~proven_q;
      select_4200_s23_q <= select_4200;
      select_4202_s23_q <= select_4202_s22_q;
    end
  end

  // Stage 23 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:392
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2415_s23_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2418;
  assign select_2418 = equal_2402_s23_q ? (less_2403_s23_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:392
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2425_s23_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2428;
  assign select_2428 = equal_2402_s23_q ? (less_2403_s23_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/count_bits.hpp:27
  logic or_3466;
  assign or_3466 = and_3463_s23_q | and_3465_s23_q;
  // hls/stages/patches.hpp:525
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3466, parity_3462_s23_q, xor_3450_s23_q, parity_3422_s23_q, parity_3360_s23_q, parity_3231_s23_q} + (equal_3467_s23_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3471;
  assign select_3471 = equal_1788_s23_q ? patches_sums_values_0_q : (equal_1790_s23_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3472;
  assign select_3472 = equal_1790_s23_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3474;
  assign select_3474 = equal_1790_s23_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3476;
  assign select_3476 = equal_1790_s23_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3478;
  assign select_3478 = equal_1790_s23_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3480;
  assign select_3480 = equal_1790_s23_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3482;
  assign select_3482 = equal_1790_s23_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3484;
  assign select_3484 = equal_1790_s23_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3486;
  assign select_3486 = equal_1790_s23_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3488;
  assign select_3488 = equal_1790_s23_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3490;
  assign select_3490 = equal_1790_s23_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3492;
  assign select_3492 = equal_1790_s23_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3494;
  assign select_3494 = equal_1790_s23_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3496;
  assign select_3496 = equal_1790_s23_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3498;
  assign select_3498 = equal_1790_s23_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3500;
  assign select_3500 = equal_1790_s23_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3502;
  assign select_3502 = equal_1790_s23_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:579
  logic not_3611;
  assign not_3611 = ~or_3610_s23_q;
  // hls/stages/patches.hpp:560
  logic and_3612;
  assign and_3612 = equal_1970_s23_q & not_3611;
  // hls/stages/patches.hpp:184
  logic and_3615;
  assign and_3615 = equal_1788_s23_q & (less_1967_s23_q ? (not_1969_s23_q & and_3612) : and_3612);
  // hls/stages/patches.hpp:560
  logic and_3618;
  assign and_3618 = equal_1970_s23_q & (patches_second_s23_q & not_3611);
  // hls/stages/patches.hpp:184
  logic and_3621;
  assign and_3621 = equal_1788_s23_q & (less_1967_s23_q ? (not_1969_s23_q & and_3618) : and_3618);
  // hls/stages/patches.hpp:560
  logic and_3661;
  assign and_3661 = equal_1970_s23_q & (not_3611 & not_3659_s23_q);
  // hls/stages/patches.hpp:184
  logic and_3664;
  assign and_3664 = equal_1788_s23_q & (less_1967_s23_q ? (not_1969_s23_q & and_3661) : and_3661);
  // hls/stages/patches.hpp:560
  logic and_3671;
  assign and_3671 = equal_1970_s23_q & (not_3611 & not_3669_s23_q);
  // hls/stages/patches.hpp:184
  logic and_3674;
  assign and_3674 = equal_1788_s23_q & (less_1967_s23_q ? (not_1969_s23_q & and_3671) : and_3671);
  // hls/stages/agreement.hpp:1130
  logic less_3708;
  assign less_3708 = x_s23_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3712;
  assign and_3712 = equal_575_s23_q & (x_s23_q[6] & (not_1997_s23_q & (equal_3707_s23_q & less_3708)));
  // hls/stages/agreement.hpp:1142
  logic and_3717;
  assign and_3717 = x_s23_q[6] & (not_1997_s23_q & (less_3708 & (x_s23_q[2:0] == 3'h1)));
  logic and_3724;
  assign and_3724 = x_s23_q[6] & (not_1997_s23_q & (less_3708 & (x_s23_q[2:0] == 3'h2)));
  logic and_3731;
  assign and_3731 = x_s23_q[6] & (not_1997_s23_q & (less_3708 & (x_s23_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:199
  logic select_3738;
  assign select_3738 = (x_s23_q[5:3] == 3'h2) ? x_s23_q[1] : (x_s23_q[0] & (x_s23_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3765;
  assign sum_3765 = {2'h0, x_s23_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:606
  logic [5:0] select_3784;
  assign select_3784 = less_3781_s23_q ? 6'h10 : (less_3782_s23_q ? 6'h30 : difference_3657_s23_q);
  // hls/stages/patches.hpp:560
  logic [5:0] select_3786;
  assign select_3786 = equal_1970_s23_q ? (or_3610_s23_q ? 6'h0 : select_3784) : 6'h0;
  logic [5:0] select_3788;
  assign select_3788 = less_1967_s23_q ? (equal_1968_s23_q ? 6'h0 : select_3786) : select_3786;
  // hls/stages/agreement.hpp:788
  logic and_3795;
  assign and_3795 = equal_575_s23_q & (x_s23_q[6] & (not_1997_s23_q & (equal_2899_s23_q & less_3708)));
  // hls/stages/agreement.hpp:1142
  logic and_3799;
  assign and_3799 = x_s23_q[6] & (not_1997_s23_q & (less_3708 & (x_s23_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:560
  logic and_3834;
  assign and_3834 = equal_1970_s23_q & (not_3611 & less_3832_s23_q);
  // hls/stages/patches.hpp:184
  logic and_3837;
  assign and_3837 = equal_1788_s23_q & (less_1967_s23_q ? (not_1969_s23_q & and_3834) : and_3834);
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_s23_q} - {1'b0, before_v_4_s23_q};
  // hls/stages/agreement.hpp:1230
  logic select_3963;
  assign select_3963 = and_3952_s23_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4126;
  assign select_4126 = and_4125_s23_q ? {and_2133_s23_q, is_seen_s23_q} : map_rdata_s23_q;
  // hls/stages/agreement.hpp:1309
  logic and_4127;
  assign and_4127 = proven_q & less_4115;
  // hls/stages/agreement.hpp:788
  logic and_4182;
  assign and_4182 = equal_575_s23_q & (equal_3948_s23_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4186;
  assign and_4186 = equal_575_s23_q & (x_s23_q[6] & (not_1997_s23_q | (4'hc < x_s23_q[5:2])));

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1818_s23_q, select_1815_s23_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s23_en & and_1828_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s23_q;
  end
`ifndef SYNTHESIS
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
  logic [9:0] patches_right_0_raddr_s22_sim;
  logic patches_right_0_re_s22_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      patches_right_0_re_s22_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_0_re_s11_sim <= patches_right_0_re;
      patches_right_0_raddr_s11_sim <= patches_right_0_raddr;
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
      patches_right_0_re_s22_sim <= patches_right_0_re_s21_sim;
      patches_right_0_raddr_s22_sim <= patches_right_0_raddr_s21_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_0_we) begin
      if (patches_right_0_re && patches_right_0_raddr == patches_right_0_waddr) begin
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
      if (patches_right_0_re_s22_sim && patches_right_0_raddr_s22_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_1818_s23_q, select_1844_s23_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s23_en & and_1848_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s23_q;
  end
`ifndef SYNTHESIS
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
  logic [9:0] patches_right_1_raddr_s22_sim;
  logic patches_right_1_re_s22_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      patches_right_1_re_s22_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_1_re_s11_sim <= patches_right_1_re;
      patches_right_1_raddr_s11_sim <= patches_right_1_raddr;
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
      patches_right_1_re_s22_sim <= patches_right_1_re_s21_sim;
      patches_right_1_raddr_s22_sim <= patches_right_1_raddr_s21_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_1_we) begin
      if (patches_right_1_re && patches_right_1_raddr == patches_right_1_waddr) begin
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
      if (patches_right_1_re_s22_sim && patches_right_1_raddr_s22_sim == patches_right_1_waddr) begin
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
    end else if (s23_en) begin
      sharpness_comparing_rest_0_q <= so_s23_q ? select_2418 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s23_q ? select_2428 : sharpness_comparing_rest_1_q;
      patches_sums_values_0_q <= select_3471;
      patches_sums_values_1_q <= equal_1788_s23_q ? patches_sums_values_1_q : select_3472;
      patches_sums_values_2_q <= equal_1788_s23_q ? patches_sums_values_2_q : select_3474;
      patches_sums_values_3_q <= equal_1788_s23_q ? patches_sums_values_3_q : select_3476;
      patches_sums_values_4_q <= equal_1788_s23_q ? patches_sums_values_4_q : select_3478;
      patches_sums_values_5_q <= equal_1788_s23_q ? patches_sums_values_5_q : select_3480;
      patches_sums_values_6_q <= equal_1788_s23_q ? patches_sums_values_6_q : select_3482;
      patches_sums_values_7_q <= equal_1788_s23_q ? patches_sums_values_7_q : select_3484;
      patches_sums_values_8_q <= equal_1788_s23_q ? patches_sums_values_8_q : select_3486;
      patches_sums_values_9_q <= equal_1788_s23_q ? patches_sums_values_9_q : select_3488;
      patches_sums_values_10_q <= equal_1788_s23_q ? patches_sums_values_10_q : select_3490;
      patches_sums_values_11_q <= equal_1788_s23_q ? patches_sums_values_11_q : select_3492;
      patches_sums_values_12_q <= equal_1788_s23_q ? patches_sums_values_12_q : select_3494;
      patches_sums_values_13_q <= equal_1788_s23_q ? patches_sums_values_13_q : select_3496;
      patches_sums_values_14_q <= equal_1788_s23_q ? patches_sums_values_14_q : select_3498;
      patches_sums_values_15_q <= equal_1788_s23_q ? patches_sums_values_15_q : select_3500;
      patches_sums_values_16_q <= equal_1788_s23_q ? patches_sums_values_16_q : select_3502;
      patches_frame_ended_q <= and_3813_s23_q;
      hides_q <= equal_575_s23_q ? select_3963 : hides_q;
    end
  end

  logic [7:0] pixel_0_s24_q;
  logic [7:0] pixel_1_s24_q;
  logic saturated_s24_q;
  logic mask_s24_q;
  logic marks_first_s24_q;
  logic marks_last_s24_q;
  logic census_columns_values_1_cell_2_of_skin_s24_q;
  logic x_s24_q;
  logic registration_moved_s24_q;
  logic patches_lower_s24_q;
  logic [9:0] patches_sums_values_0_s24_q;
  logic [4:0] patches_summed_row_column_s24_q;
  logic patches_summed_first_s24_q;
  logic patches_summed_last_s24_q;
  logic [4:0] patches_summed_down_by_s24_q;
  logic patches_frame_ended_s24_q;
  logic [6:0] last_s24_q;
  logic and_550_s24_q;
  logic equal_575_s24_q;
  logic so_s24_q;
  logic less_653_s24_q;
  logic less_654_s24_q;
  logic less_655_s24_q;
  logic less_656_s24_q;
  logic less_657_s24_q;
  logic less_658_s24_q;
  logic less_659_s24_q;
  logic less_660_s24_q;
  logic less_661_s24_q;
  logic less_662_s24_q;
  logic less_663_s24_q;
  logic less_664_s24_q;
  logic less_665_s24_q;
  logic less_666_s24_q;
  logic less_667_s24_q;
  logic less_668_s24_q;
  logic less_669_s24_q;
  logic less_670_s24_q;
  logic less_671_s24_q;
  logic less_672_s24_q;
  logic less_673_s24_q;
  logic less_674_s24_q;
  logic less_675_s24_q;
  logic less_676_s24_q;
  logic and_684_s24_q;
  logic and_709_s24_q;
  logic and_710_s24_q;
  logic less_733_s24_q;
  logic and_740_s24_q;
  logic less_741_s24_q;
  logic and_746_s24_q;
  logic less_747_s24_q;
  logic equal_1608_s24_q;
  logic equal_1616_s24_q;
  logic and_2063_s24_q;
  logic less_2064_s24_q;
  logic equal_2284_s24_q;
  logic and_2289_s24_q;
  logic equal_2402_s24_q;
  logic sum_s24_q;
  logic sum_2_s24_q;
  logic equal_2446_s24_q;
  logic select_2464_s24_q;
  logic select_2470_s24_q;
  logic [9:0] select_2649_s24_q;
  logic [9:0] select_2652_s24_q;
  logic and_3615_s24_q;
  logic and_3621_s24_q;
  logic and_3664_s24_q;
  logic and_3674_s24_q;
  logic and_3712_s24_q;
  logic and_3718_s24_q;
  logic and_3725_s24_q;
  logic and_3732_s24_q;
  logic and_3741_s24_q;
  logic and_3768_s24_q;
  logic [5:0] select_3789_s24_q;
  logic and_3795_s24_q;
  logic and_3800_s24_q;
  logic and_3838_s24_q;
  logic or_3929_s24_q;
  logic select_3937_s24_q;
  logic equal_3948_s24_q;
  logic select_3963_s24_q;
  logic and_3995_s24_q;
  logic not_3997_s24_q;
  logic or_4001_s24_q;
  logic and_4006_s24_q;
  logic and_4008_s24_q;
  logic and_4110_s24_q;
  logic and_4128_s24_q;
  logic and_4131_s24_q;
  logic not_4139_s24_q;
  logic and_4182_s24_q;
  logic and_4186_s24_q;
  logic [5:0] select_4188_s24_q;
  logic [31:0] select_4200_s24_q;
  logic [9:0] select_4202_s24_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s24_q <= pixel_0_s23_q;
      pixel_1_s24_q <= pixel_1_s23_q;
      saturated_s24_q <= saturated_s23_q;
      mask_s24_q <= mask_s23_q;
      marks_first_s24_q <= marks_first_s23_q;
      marks_last_s24_q <= marks_last_s23_q;
      census_columns_values_1_cell_2_of_skin_s24_q <= census_columns_values_1_cell_2_of_skin_s23_q;
      x_s24_q <= x_s23_q[6];
      registration_moved_s24_q <= registration_moved_s23_q;
      patches_lower_s24_q <= patches_lower_s23_q;
      patches_sums_values_0_s24_q <= patches_sums_values_0_q;
      patches_summed_row_column_s24_q <= patches_summed_row_column_s23_q;
      patches_summed_first_s24_q <= patches_summed_first_s23_q;
      patches_summed_last_s24_q <= patches_summed_last_s23_q;
      patches_summed_down_by_s24_q <= patches_summed_down_by_s23_q;
      patches_frame_ended_s24_q <= patches_frame_ended_q;
      last_s24_q <= last_s23_q;
      and_550_s24_q <= and_550_s23_q;
      equal_575_s24_q <= equal_575_s23_q;
      so_s24_q <= so_s23_q;
      less_653_s24_q <= less_653_s23_q;
      less_654_s24_q <= less_654_s23_q;
      less_655_s24_q <= less_655_s23_q;
      less_656_s24_q <= less_656_s23_q;
      less_657_s24_q <= less_657_s23_q;
      less_658_s24_q <= less_658_s23_q;
      less_659_s24_q <= less_659_s23_q;
      less_660_s24_q <= less_660_s23_q;
      less_661_s24_q <= less_661_s23_q;
      less_662_s24_q <= less_662_s23_q;
      less_663_s24_q <= less_663_s23_q;
      less_664_s24_q <= less_664_s23_q;
      less_665_s24_q <= less_665_s23_q;
      less_666_s24_q <= less_666_s23_q;
      less_667_s24_q <= less_667_s23_q;
      less_668_s24_q <= less_668_s23_q;
      less_669_s24_q <= less_669_s23_q;
      less_670_s24_q <= less_670_s23_q;
      less_671_s24_q <= less_671_s23_q;
      less_672_s24_q <= less_672_s23_q;
      less_673_s24_q <= less_673_s23_q;
      less_674_s24_q <= less_674_s23_q;
      less_675_s24_q <= less_675_s23_q;
      less_676_s24_q <= less_676_s23_q;
      and_684_s24_q <= and_684_s23_q;
      and_709_s24_q <= and_709_s23_q;
      and_710_s24_q <= and_710_s23_q;
      less_733_s24_q <= 9'h4 < sum_732_s23_q;
      and_740_s24_q <= and_740_s23_q;
      less_741_s24_q <= less_741_s23_q;
      and_746_s24_q <= and_746_s23_q;
      less_747_s24_q <= less_747_s23_q;
      equal_1608_s24_q <= equal_1608_s23_q;
      equal_1616_s24_q <= equal_1616_s23_q;
      and_2063_s24_q <= and_2063_s23_q;
      less_2064_s24_q <= less_2064_s23_q;
      equal_2284_s24_q <= equal_2284_s23_q;
      and_2289_s24_q <= and_709_s23_q & (9'h4 < sum_2287_s23_q);
      equal_2402_s24_q <= equal_2402_s23_q;
      sum_s24_q <= sum[0];
      sum_2_s24_q <= sum_2[0];
      equal_2446_s24_q <= equal_2446_s23_q;
      select_2464_s24_q <= sharpness_comparing_less_contrast_0_q;
      select_2470_s24_q <= sharpness_comparing_less_contrast_1_q;
      select_2649_s24_q <= select_2649_s23_q;
      select_2652_s24_q <= select_2652_s23_q;
      and_3615_s24_q <= and_3615;
      and_3621_s24_q <= and_3621;
      and_3664_s24_q <= and_3664;
      and_3674_s24_q <= and_3674;
      and_3712_s24_q <= and_3712;
      and_3718_s24_q <= equal_575_s23_q & and_3717;
      and_3725_s24_q <= equal_575_s23_q & and_3724;
      and_3732_s24_q <= equal_575_s23_q & and_3731;
      and_3741_s24_q <= x_s23_q[6] & (not_1997_s23_q & (less_3708 & select_3738));
      and_3768_s24_q <= not_1997_s23_q & (less_3708 & (sum_3765[4:2] == 3'h0));
      select_3789_s24_q <= equal_1788_s23_q ? select_3788 : 6'h0;
      and_3795_s24_q <= and_3795;
      and_3800_s24_q <= equal_575_s23_q & and_3799;
      and_3838_s24_q <= and_3615 & and_3837;
      or_3929_s24_q <= or_3929_s23_q;
      select_3937_s24_q <= select_3937_s23_q;
      equal_3948_s24_q <= equal_3948_s23_q;
      select_3963_s24_q <= select_3963;
      and_3995_s24_q <= over[14] & equal_3707_s23_q;
      not_3997_s24_q <= not_3997_s23_q;
      or_4001_s24_q <= or_4001_s23_q;
      and_4006_s24_q <= and_4006_s23_q;
      and_4008_s24_q <= over[14] & less_4007_s23_q;
      and_4110_s24_q <= and_4110_s23_q;
      and_4128_s24_q <= select_4126[0] & and_4127;
      and_4131_s24_q <= select_4126[1] & and_4127;
      not_4139_s24_q <= not_4139_s23_q;
      and_4182_s24_q <= and_4182;
      and_4186_s24_q <= and_4186;
      select_4188_s24_q <= equal_575_s23_q ? (x_s23_q[6] ? x_s23_q[5:0] : 6'h0) : 6'h0;
      select_4200_s24_q <= select_4200_s23_q;
      select_4202_s24_q <= select_4202_s23_q;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:314
  logic and_734;
  assign and_734 = and_684_s24_q & less_733_s24_q;
  // hls/stages/patches.hpp:184
  logic less_1979;
  assign less_1979 = patches_sums_values_0_s24_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1980;
  assign not_1980 = ~less_1979;
  logic [1:0] select_1981;
  assign select_1981 = patches_summed_first_s24_q ? 2'h2 : {less_1979, not_1980};
  logic [12:0] select_1983;
  assign select_1983 = select_1981[0] ? {4'h0, patches_summed_first_s24_q, 3'h0, patches_summed_row_column_s24_q} : {patches_summed_row_column_s24_q, patches_sums_values_0_s24_q[7:0]};
  logic [14:0] select_1984;
  assign select_1984 = select_1981[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1985;
  assign select_1985 = (select_1981 == 2'h2) ? {select_1983[12:8], patches_sums_values_0_s24_q[9:8], select_1983[7:0]} : select_1984;
  // hls/stages/census.hpp:321
  logic and_2290;
  assign and_2290 = and_709_s24_q & less_733_s24_q;
  // hls/stages/census.hpp:322
  logic [19:0] sum_2291;
  assign sum_2291 = census_left_misses_q + {{17{and_2290}}, and_2289_s24_q, 1'b0, and_2289_s24_q};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2293;
  assign select_2293 = and_550_s24_q ? (equal_2284_s24_q ? 20'h0 : sum_2291) : census_left_misses_q;
  // hls/stages/agreement.hpp:216
  logic [2:0] select_2430;
  assign select_2430 = equal_2402_s24_q ? {sharpness_comparing_product_0_q[1:0], sum_s24_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2432;
  assign select_2432 = equal_2402_s24_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s24_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s24_q});
  // hls/stages/agreement.hpp:216
  logic select_2441;
  assign select_2441 = so_s24_q ? (equal_2402_s24_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s24_q});
  // hls/stages/agreement.hpp:216
  logic select_2444;
  assign select_2444 = equal_2402_s24_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:400
  logic xor_2447;
  assign xor_2447 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2453;
  assign xor_2453 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:657
  logic not_3616;
  assign not_3616 = ~patches_lower_s24_q;
  logic not_3622;
  assign not_3622 = ~and_3621_s24_q;
  // hls/stages/patches.hpp:188
  logic and_3624;
  assign and_3624 = and_3615_s24_q & (not_3616 & not_3622);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3626;
  assign sum_3626 = {7'h0, and_3624} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:660
  logic and_3665;
  assign and_3665 = and_3664_s24_q & and_3624;
  logic [7:0] sum_3666;
  assign sum_3666 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3665};
  // hls/stages/patches.hpp:661
  logic and_3675;
  assign and_3675 = and_3674_s24_q & and_3624;
  logic [7:0] sum_3676;
  assign sum_3676 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3675};
  // hls/stages/patches.hpp:188
  logic and_3678;
  assign and_3678 = and_3615_s24_q & (and_3621_s24_q & not_3616);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3680;
  assign sum_3680 = {7'h0, and_3678} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:660
  logic and_3682;
  assign and_3682 = and_3664_s24_q & and_3678;
  logic [7:0] sum_3683;
  assign sum_3683 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3682};
  // hls/stages/patches.hpp:661
  logic and_3685;
  assign and_3685 = and_3674_s24_q & and_3678;
  logic [7:0] sum_3686;
  assign sum_3686 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3685};
  // hls/stages/patches.hpp:188
  logic and_3688;
  assign and_3688 = and_3615_s24_q & (patches_lower_s24_q & not_3622);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3690;
  assign sum_3690 = {7'h0, and_3688} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:660
  logic and_3692;
  assign and_3692 = and_3664_s24_q & and_3688;
  logic [7:0] sum_3693;
  assign sum_3693 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3692};
  // hls/stages/patches.hpp:661
  logic and_3695;
  assign and_3695 = and_3674_s24_q & and_3688;
  logic [7:0] sum_3696;
  assign sum_3696 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3695};
  // hls/stages/patches.hpp:188
  logic and_3698;
  assign and_3698 = and_3615_s24_q & (patches_lower_s24_q & and_3621_s24_q);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3700;
  assign sum_3700 = {7'h0, and_3698} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:660
  logic and_3702;
  assign and_3702 = and_3664_s24_q & and_3698;
  logic [7:0] sum_3703;
  assign sum_3703 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3702};
  // hls/stages/patches.hpp:661
  logic and_3705;
  assign and_3705 = and_3674_s24_q & and_3698;
  logic [7:0] sum_3706;
  assign sum_3706 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3705};
  // hls/stages/patches.hpp:623
  logic [7:0] or_3720;
  assign or_3720 = (and_3712_s24_q ? patches_quarters_0_places_q : 8'h0) | (and_3718_s24_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3734;
  assign or_3734 = (or_3720 | (and_3725_s24_q ? patches_quarters_2_places_q : 8'h0)) | (and_3732_s24_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_3742;
  assign and_3742 = equal_575_s24_q & and_3741_s24_q;
  // hls/stages/patches.hpp:624
  logic [7:0] select_3744;
  assign select_3744 = and_3712_s24_q ? (and_3742 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3746;
  assign select_3746 = and_3718_s24_q ? (and_3742 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3749;
  assign select_3749 = and_3725_s24_q ? (and_3742 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3752;
  assign select_3752 = and_3732_s24_q ? (and_3742 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:625
  logic [7:0] select_3755;
  assign select_3755 = and_3712_s24_q ? (and_3742 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3757;
  assign select_3757 = and_3718_s24_q ? (and_3742 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3760;
  assign select_3760 = and_3725_s24_q ? (and_3742 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3763;
  assign select_3763 = and_3732_s24_q ? (and_3742 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_3770;
  assign and_3770 = equal_575_s24_q & (x_s24_q & and_3768_s24_q);
  // hls/stages/patches.hpp:618
  logic [7:0] sum_3772;
  assign sum_3772 = patches_word_places_q + (and_3718_s24_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:620
  logic [7:0] select_3776;
  assign select_3776 = and_3770 ? (patches_word_up_q + (and_3718_s24_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3778;
  assign sum_3778 = patches_word_down_q + (and_3718_s24_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:663
  logic [5:0] select_3790;
  assign select_3790 = and_3615_s24_q ? select_3789_s24_q : 6'h0;
  logic [11:0] sum_3791;
  assign sum_3791 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3790[5]}}, select_3790};
  // hls/stages/patches.hpp:647
  logic [7:0] select_3802;
  assign select_3802 = and_3795_s24_q ? (and_3800_s24_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:649
  logic or_3806;
  assign or_3806 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:650
  logic or_3809;
  assign or_3809 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic [8:0] sum_3810;
  assign sum_3810 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:646
  logic select_3812;
  assign select_3812 = and_3795_s24_q ? (and_3800_s24_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3815;
  assign and_3815 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:646
  logic [2:0] select_3816;
  assign select_3816 = and_3795_s24_q ? {and_3815, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3818;
  assign select_3818 = and_3795_s24_q ? (and_3800_s24_q ? {and_3815, patches_found_q[2:1]} : select_3816) : patches_found_q;
  // hls/stages/patches.hpp:645
  logic or_3821;
  assign or_3821 = patches_partly_q | (patches_doubted_q & (~and_3800_s24_q));
  // hls/stages/patches.hpp:646
  logic select_3823;
  assign select_3823 = and_3800_s24_q ? or_3821 : (and_3795_s24_q ? or_3821 : patches_doubted_q);
  // hls/stages/patches.hpp:644
  logic select_3825;
  assign select_3825 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:633
  logic [7:0] select_3829;
  assign select_3829 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:664
  logic [7:0] sum_3839;
  assign sum_3839 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3838_s24_q};
  // hls/stages/patches.hpp:635
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:636
  logic select_3862;
  assign select_3862 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:637
  logic and_3868;
  assign and_3868 = patches_frame_ended_s24_q & (~patches_age_q[9]);
  logic [9:0] sum_3869;
  assign sum_3869 = patches_age_q + {9'h0, and_3868};
  logic [9:0] select_3872;
  assign select_3872 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3869)) : sum_3869;
  // hls/stages/agreement.hpp:1148
  logic not_3964;
  assign not_3964 = ~hidden_for_q[7];
  logic [7:0] select_3966;
  assign select_3966 = select_3963_s24_q ? (hidden_for_q + {7'h0, not_3964}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3968;
  assign select_3968 = equal_575_s24_q ? (equal_3948_s24_q ? select_3966 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1228
  logic and_3998;
  assign and_3998 = too_much_q & not_3997_s24_q;
  // hls/stages/agreement.hpp:1229
  logic select_4003;
  assign select_4003 = and_3995_s24_q ? (and_3998 | or_4001_s24_q) : and_3998;
  // hls/stages/agreement.hpp:1231
  logic select_4009;
  assign select_4009 = and_4006_s24_q ? and_4008_s24_q : overlooks_q;
  // hls/stages/agreement.hpp:438
  logic select_4130;
  assign select_4130 = and_2063_s24_q ? (less_2064_s24_q ? and_4128_s24_q : seen_q) : seen_q;
  logic select_4133;
  assign select_4133 = and_2063_s24_q ? (less_2064_s24_q ? and_4131_s24_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4140;
  assign or_4140 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4139_s24_q;
  // hls/stages/agreement.hpp:788
  logic and_4155;
  assign and_4155 = equal_3948_s24_q & (cfg_prove_i & (registration_moved_s24_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4158;
  assign or_4158 = select_2464_s24_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4201;
  assign select_4201 = equal_1616_s24_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4200_s24_q;
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4203;
  assign select_4203 = equal_1608_s24_q ? select_4201 : {2'h0, select_4202_s24_q, select_2652_s24_q, select_2649_s24_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s24_q;
  logic fresh_we;
  assign fresh_we = s24_en & and_550_s24_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_747_s24_q, and_746_s24_q, less_741_s24_q, and_740_s24_q, census_columns_values_1_cell_2_of_skin_s24_q, and_734, and_710_s24_q, and_709_s24_q, and_684_s24_q, less_676_s24_q, less_675_s24_q, less_674_s24_q, less_673_s24_q, less_672_s24_q, less_671_s24_q, less_670_s24_q, less_669_s24_q, less_668_s24_q, less_667_s24_q, less_666_s24_q, less_665_s24_q, less_664_s24_q, less_663_s24_q, less_662_s24_q, less_661_s24_q, less_660_s24_q, less_659_s24_q, less_658_s24_q, less_657_s24_q, less_656_s24_q, less_655_s24_q, less_654_s24_q, less_653_s24_q};
  end
`ifndef SYNTHESIS
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
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
    end else if (en_i) begin
      fresh_re_s9_sim <= fresh_re;
      fresh_raddr_s9_sim <= fresh_raddr;
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
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && fresh_we) begin
      if (fresh_re && fresh_raddr == fresh_waddr) begin
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
    end else if (s24_en) begin
      census_left_misses_q <= select_2293;
      sharpness_comparing_product_0_q <= so_s24_q ? select_2430 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s24_q ? select_2432 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2441;
      sharpness_comparing_carry_1_q <= so_s24_q ? select_2444 : sharpness_comparing_carry_1_q;
      patches_best_differing_q <= select_1985[9:0];
      patches_best_column_q <= select_1985[14:10];
      patches_quarters_0_places_q <= sum_3626;
      patches_quarters_0_up_q <= sum_3666;
      patches_quarters_0_down_q <= sum_3676;
      patches_quarters_1_places_q <= sum_3680;
      patches_quarters_1_up_q <= sum_3683;
      patches_quarters_1_down_q <= sum_3686;
      patches_quarters_2_places_q <= sum_3690;
      patches_quarters_2_up_q <= sum_3693;
      patches_quarters_2_down_q <= sum_3696;
      patches_quarters_3_places_q <= sum_3700;
      patches_quarters_3_up_q <= sum_3703;
      patches_quarters_3_down_q <= sum_3706;
      patches_word_places_q <= or_3734;
      patches_word_up_q <= ((select_3744 | select_3746) | select_3749) | select_3752;
      patches_word_down_q <= ((select_3755 | select_3757) | select_3760) | select_3763;
      patches_sum_places_q <= and_3770 ? sum_3772 : patches_sum_places_q;
      patches_sum_up_q <= select_3776;
      patches_sum_down_q <= and_3770 ? sum_3778 : patches_sum_down_q;
      patches_across_q <= sum_3791;
      patches_places_q <= select_3802;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3806;
      patches_partly_q <= or_3809;
      patches_clear_limit_q <= sum_3810[8:2];
      patches_complete_q <= select_3812;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3818;
      patches_doubted_q <= and_3795_s24_q ? select_3823 : patches_doubted_q;
      patches_doubted_before_q <= select_3825;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3829;
      patches_on_skin_q <= sum_3839;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3862;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3872;
      hidden_for_q <= select_3968;
      too_much_q <= equal_575_s24_q ? select_4003 : too_much_q;
      overlooks_q <= equal_575_s24_q ? select_4009 : overlooks_q;
      seen_q <= select_4130;
      nearer_q <= select_4133;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s24_en) begin
      left_pixel_q <= left_pixel_q;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic patches_summed_last_s25_q;
  logic [4:0] patches_summed_down_by_s25_q;
  logic patches_round_ends_s25_q;
  logic [7:0] patches_on_skin_s25_q;
  logic equal_575_s25_q;
  logic so_s25_q;
  logic equal_2402_s25_q;
  logic or_2448_s25_q;
  logic and_2449_s25_q;
  logic or_2454_s25_q;
  logic and_2455_s25_q;
  logic select_2470_s25_q;
  logic or_3929_s25_q;
  logic equal_3948_s25_q;
  logic and_4110_s25_q;
  logic and_4143_s25_q;
  logic or_4149_s25_q;
  logic and_4156_s25_q;
  logic or_4158_s25_q;
  logic not_4170_s25_q;
  logic or_4176_s25_q;
  logic and_4182_s25_q;
  logic and_4186_s25_q;
  logic [5:0] select_4188_s25_q;
  logic [31:0] select_4205_s25_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      patches_summed_last_s25_q <= patches_summed_last_s24_q;
      patches_summed_down_by_s25_q <= patches_summed_down_by_s24_q;
      patches_round_ends_s25_q <= patches_round_ends_q;
      patches_on_skin_s25_q <= patches_on_skin_q;
      equal_575_s25_q <= equal_575_s24_q;
      so_s25_q <= so_s24_q;
      equal_2402_s25_q <= equal_2402_s24_q;
      or_2448_s25_q <= equal_2446_s24_q | xor_2447;
      and_2449_s25_q <= five_times[0] & xor_2447;
      or_2454_s25_q <= equal_2446_s24_q | xor_2453;
      and_2455_s25_q <= five_times_2[0] & xor_2453;
      select_2470_s25_q <= select_2470_s24_q;
      or_3929_s25_q <= or_3929_s24_q;
      equal_3948_s25_q <= equal_3948_s24_q;
      and_4110_s25_q <= and_4110_s24_q;
      and_4143_s25_q <= equal_575_s24_q & (equal_3948_s24_q & (cfg_prove_i & or_4140));
      or_4149_s25_q <= select_3937_s24_q | select_4003;
      and_4156_s25_q <= equal_575_s24_q & and_4155;
      or_4158_s25_q <= or_4158;
      not_4170_s25_q <= ~(select_3966 < cfg_hidden_frames_i);
      or_4176_s25_q <= not_2354 | (select_4009 & not_3841);
      and_4182_s25_q <= and_4182_s24_q;
      and_4186_s25_q <= and_4186_s24_q;
      select_4188_s25_q <= select_4188_s24_q;
      select_4205_s25_q <= equal_575_s24_q ? (x_s24_q ? select_4203 : 32'h0) : 32'h0;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:400
  logic select_2450;
  assign select_2450 = or_2448_s25_q ? and_2449_s25_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2451;
  assign select_2451 = equal_2402_s25_q ? select_2450 : sharpness_comparing_less_detail_0_q;
  logic select_2452;
  assign select_2452 = so_s25_q ? select_2451 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:400
  logic select_2456;
  assign select_2456 = or_2454_s25_q ? and_2455_s25_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2457;
  assign select_2457 = equal_2402_s25_q ? select_2456 : sharpness_comparing_less_detail_1_q;
  logic select_2458;
  assign select_2458 = so_s25_q ? select_2457 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:653
  logic [12:0] product_3844;
  assign product_3844 = {8'h0, cfg_on_skin_limit_i} * {5'h0, patches_places_q};
  // hls/stages/agreement.hpp:788
  logic and_4146;
  assign and_4146 = equal_575_s25_q & (equal_3948_s25_q & (cfg_prove_i & or_3929_s25_q));
  // hls/stages/agreement.hpp:1241
  logic not_4148;
  assign not_4148 = ~(or_3929_s25_q | not_2354);
  // hls/stages/agreement.hpp:788
  logic and_4152;
  assign and_4152 = equal_575_s25_q & (equal_3948_s25_q & (not_4148 & or_4149_s25_q));
  logic and_4165;
  assign and_4165 = equal_3948_s25_q & (not_4148 & (select_2458 | select_2470_s25_q));
  // hls/stages/agreement.hpp:1150
  logic and_4172;
  assign and_4172 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4170_s25_q);

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s25_q;
  logic patches_rows_we;
  assign patches_rows_we = s25_en & patches_summed_last_s25_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= {patches_best_column_q, patches_best_differing_q};
  end
`ifndef SYNTHESIS
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
  logic [4:0] patches_rows_raddr_s24_sim;
  logic patches_rows_re_s24_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
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
      patches_rows_re_s24_sim <= 1'b0;
    end else if (en_i) begin
      patches_rows_re_s11_sim <= patches_rows_re;
      patches_rows_raddr_s11_sim <= patches_rows_raddr;
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
      patches_rows_re_s24_sim <= patches_rows_re_s23_sim;
      patches_rows_raddr_s24_sim <= patches_rows_raddr_s23_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
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
      if (patches_rows_re_s24_sim && patches_rows_raddr_s24_sim == patches_rows_waddr) begin
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
    end else if (s25_en) begin
      sharpness_comparing_less_detail_0_q <= select_2452;
      sharpness_comparing_less_detail_1_q <= select_2458;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic patches_round_ends_s26_q;
  logic [7:0] patches_on_skin_s26_q;
  logic equal_575_s26_q;
  logic [7:0] product_3844_s26_q;
  logic equal_3948_s26_q;
  logic and_4110_s26_q;
  logic or_4134_s26_q;
  logic and_4135_s26_q;
  logic and_4143_s26_q;
  logic and_4146_s26_q;
  logic and_4152_s26_q;
  logic and_4156_s26_q;
  logic and_4161_s26_q;
  logic and_4165_s26_q;
  logic and_4174_s26_q;
  logic or_4176_s26_q;
  logic and_4182_s26_q;
  logic and_4186_s26_q;
  logic [5:0] select_4188_s26_q;
  logic [31:0] select_4205_s26_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      patches_round_ends_s26_q <= patches_round_ends_s25_q;
      patches_on_skin_s26_q <= patches_on_skin_s25_q;
      equal_575_s26_q <= equal_575_s25_q;
      product_3844_s26_q <= product_3844[12:5];
      equal_3948_s26_q <= equal_3948_s25_q;
      and_4110_s26_q <= and_4110_s25_q;
      or_4134_s26_q <= not_2354 | seen_q;
      and_4135_s26_q <= cfg_prove_i & nearer_q;
      and_4143_s26_q <= and_4143_s25_q;
      and_4146_s26_q <= and_4146;
      and_4152_s26_q <= and_4152;
      and_4156_s26_q <= and_4156_s25_q;
      and_4161_s26_q <= equal_3948_s25_q & (not_4148 & (select_2452 | or_4158_s25_q));
      and_4165_s26_q <= and_4165;
      and_4174_s26_q <= equal_575_s25_q & (equal_3948_s25_q & and_4172);
      or_4176_s26_q <= or_4176_s25_q;
      and_4182_s26_q <= and_4182_s25_q;
      and_4186_s26_q <= and_4186_s25_q;
      select_4188_s26_q <= select_4188_s25_q;
      select_4205_s26_q <= select_4205_s25_q;
    end
  end

  // Stage 26 ----------------------------------------------------------------------------------------------------------
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:188
  logic and_3846;
  assign and_3846 = (~(patches_on_skin_s26_q[7:2] == 6'h0)) & (product_3844_s26_q < patches_on_skin_s26_q);
  logic select_3851;
  assign select_3851 = patches_round_ends_s26_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:634
  logic or_3855;
  assign or_3855 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s26_q));
  // hls/stages/agreement.hpp:788
  logic and_4178;
  assign and_4178 = equal_3948_s26_q & (or_4176_s26_q ? cfg_prove_i : patches_overlooked_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s26_en) begin
      patches_large_q <= not_3841 & and_3846;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3851;
      patches_spoiled_q <= or_3855;
    end
  end

  logic [7:0] pixel_0_s27_q;
  logic [7:0] pixel_1_s27_q;
  logic saturated_s27_q;
  logic mask_s27_q;
  logic marks_first_s27_q;
  logic marks_last_s27_q;
  logic and_4110_s27_q;
  logic or_4134_s27_q;
  logic and_4135_s27_q;
  logic and_4143_s27_q;
  logic and_4146_s27_q;
  logic and_4152_s27_q;
  logic and_4156_s27_q;
  logic and_4162_s27_q;
  logic and_4166_s27_q;
  logic and_4174_s27_q;
  logic and_4179_s27_q;
  logic and_4182_s27_q;
  logic and_4186_s27_q;
  logic [5:0] select_4188_s27_q;
  logic [31:0] select_4205_s27_q;
  always_ff @(posedge clk_i) begin
    if (s26_en) begin
      pixel_0_s27_q <= pixel_0_s26_q;
      pixel_1_s27_q <= pixel_1_s26_q;
      saturated_s27_q <= saturated_s26_q;
      mask_s27_q <= mask_s26_q;
      marks_first_s27_q <= marks_first_s26_q;
      marks_last_s27_q <= marks_last_s26_q;
      and_4110_s27_q <= and_4110_s26_q;
      or_4134_s27_q <= or_4134_s26_q;
      and_4135_s27_q <= and_4135_s26_q;
      and_4143_s27_q <= and_4143_s26_q;
      and_4146_s27_q <= and_4146_s26_q;
      and_4152_s27_q <= and_4152_s26_q;
      and_4156_s27_q <= and_4156_s26_q;
      and_4162_s27_q <= equal_575_s26_q & and_4161_s26_q;
      and_4166_s27_q <= equal_575_s26_q & and_4165_s26_q;
      and_4174_s27_q <= and_4174_s26_q;
      and_4179_s27_q <= equal_575_s26_q & and_4178;
      and_4182_s27_q <= and_4182_s26_q;
      and_4186_s27_q <= and_4186_s26_q;
      select_4188_s27_q <= select_4188_s26_q;
      select_4205_s27_q <= select_4205_s26_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s27_q;
  assign pixel_1_o = pixel_1_s27_q;
  assign saturated_o = saturated_s27_q;
  assign mask_o = mask_s27_q;
  assign marks_first_o = marks_first_s27_q;
  assign marks_last_o = marks_last_s27_q;
  assign marks_seen_o = or_4134_s27_q;
  assign marks_nearer_o = and_4135_s27_q;
  assign verdict_valid_o = and_4110_s27_q;
  assign verdict_unproven_yet_o = and_4143_s27_q;
  assign verdict_untextured_o = and_4146_s27_q;
  assign verdict_disagree_o = and_4152_s27_q;
  assign verdict_moved_o = and_4156_s27_q;
  assign verdict_unsharp_left_o = and_4162_s27_q;
  assign verdict_unsharp_right_o = and_4166_s27_q;
  assign verdict_hidden_o = and_4174_s27_q;
  assign verdict_overlooked_o = and_4179_s27_q;
  assign verdict_out_of_step_o = and_4182_s27_q;
  assign frame_valid_o = and_4186_s27_q;
  assign frame_index_o = select_4188_s27_q;
  assign frame_word_o = select_4205_s27_q;
  assign valid_o = valid_s27_q;

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
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], product_3844[4:0], sum_3810[1:0], sum_3765[1:0], product_3656[4:0], sum_2748[0], difference_2689[1:0], detail_4[1:0], detail_3[1:0], sum_2287[4:0], sum_1769[1:0], sum_1768[1:0], sum_1764[0], sum_1713[0], sum_1709[0], sum_732[4:0], cfg_width_i[3:0]};

endmodule
