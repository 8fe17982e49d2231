// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 26 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3116 bits, pipeline 8783 bits, memories 157167 bits.
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
  logic not_2353;
  assign not_2353 = ~cfg_prove_i;
  logic [6:0] sum_2566;
  assign sum_2566 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3627;
  assign difference_3627 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3840;
  assign not_3840 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3898;
  assign difference_3898 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_4114;
  assign less_4114 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_4115;
  assign sum_4115 = {1'b0, cfg_height_i[10:7]} + 5'h1f;

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
  logic [6:0] select_2149;
  assign select_2149 = sample_pair_whole_s1_q ? (select_511 + {6'h0, equal_546}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2149;
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
  logic [3:0] select_2147;
  assign select_2147 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (select_529 + 4'h1) : select_529) : raster_at_y_q;
  logic select_2156;
  assign select_2156 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_521 & (~raster_final_row_q)) : or_521) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [10:0] select_2158;
  assign select_2158 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:276
  logic select_2162;
  assign select_2162 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [7:0] sum_2471;
  assign sum_2471 = {1'b0, last_s3_q} + 8'h1;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
      averager_inside_q <= 1'b1;
    end else if (s3_en) begin
      raster_at_y_q <= select_2147;
      raster_at_live_q <= select_2156;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2158 : raster_rows_left_q;
      raster_final_row_q <= select_2162;
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
  logic equal_2472_s4_q;
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
      equal_2472_s4_q <= {sum_2471[7], cfg_width_i[10:4]} == {1'b0, sum_2471[6:0]};
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic [3:0] patches_phase_q;
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
  // hls/stages/patches.hpp:122
  logic and_1676;
  assign and_1676 = (select_508_s4_q == 4'h0) & (select_511_s4_q == 7'h0);
  // hls/stages/census.hpp:58
  logic [6:0] select_2151;
  assign select_2151 = sample_last_s4_q ? (select_678 + {6'h0, equal_547_s4_q}) : select_678;
  // hls/stages/patches.hpp:318
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2940;
  assign select_2940 = and_1676 ? (sample_pair_first_s4_q ? phase : patches_phase_q) : patches_phase_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      patches_phase_q <= 4'h0;
    end else if (s4_en) begin
      raster_at_row_q <= sample_pair_whole_s4_q ? select_2151 : raster_at_row_q;
      patches_phase_q <= sample_pair_whole_s4_q ? select_2940 : patches_phase_q;
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
  logic and_1676_s5_q;
  logic equal_1682_s5_q;
  logic equal_2472_s5_q;
  logic and_2473_s5_q;
  logic [7:0] sum_2562_s5_q;
  logic [3:0] phase_s5_q;
  logic [2:0] or_3003_s5_q;
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
      and_1676_s5_q <= and_1676;
      equal_1682_s5_q <= equal_1682_s4_q;
      equal_2472_s5_q <= equal_2472_s4_q;
      and_2473_s5_q <= and_550 & equal_2472_s4_q;
      sum_2562_s5_q <= {1'b0, row} + 8'h1;
      phase_s5_q <= phase;
      or_3003_s5_q <= select_511_s4_q[2:0] | select_678[6:4];
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
  logic select_2476;
  assign select_2476 = (and_2473_s5_q | (~ends_cell_q)) ? and_2473_s5_q : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2476 ? (and_2473_s5_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2480;
  assign select_2480 = select_2476 ? (and_2473_s5_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2483;
  assign select_2483 = select_2476 ? (following_last_shift_q & (~and_2473_s5_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:535
  logic [7:0] select_2485;
  assign select_2485 = select_2476 ? (and_2473_s5_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:607
  logic and_2486;
  assign and_2486 = run_last_shift_q & equal_594;
  // hls/stages/agreement.hpp:616
  logic select_2488;
  assign select_2488 = equal_594 ? (~run_last_shift_q) : equal_595;
  // hls/stages/agreement.hpp:620
  logic equal_2489;
  assign equal_2489 = run_phase_q == 3'h1;
  logic not_2492;
  assign not_2492 = ~select_2488;
  // hls/stages/agreement.hpp:623
  logic equal_2494;
  assign equal_2494 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2495;
  assign and_2495 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2496;
  assign select_2496 = equal_2494 ? 2'h1 : {2{and_2495}};
  logic [2:0] select_2498;
  assign select_2498 = (and_2486 | (select_2488 | equal_2489)) ? (equal_2489 ? 3'h2 : {not_2492, {2{select_2488}}}) : (equal_579 ? 3'h6 : {select_2496[0], select_2496});
  // hls/stages/agreement.hpp:607
  logic and_2501;
  assign and_2501 = select_2488 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2504;
  assign select_2504 = (plan_shift_q[5] & select_2488) ? value : 7'h0;
  logic [1:0] or_2505;
  assign or_2505 = {2{so}} | select_2504[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] or_2509;
  assign or_2509 = (select_2488 ? plan_columns_q : 8'h0) | ((equal_2489 | equal_2494) ? whole_q : 8'h0);
  logic [1:0] or_2510;
  assign or_2510 = {2{and_2486}} | or_2509[4:3];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2512;
  assign or_2512 = {or_2509[7:5], or_2510, or_2509[2:0]} | (equal_579 ? drawn_q : 8'h0);
  logic [4:0] or_2513;
  assign or_2513 = {5{so}} | {or_2512[6], or_2512[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2517;
  assign not_2517 = ~run_shift_q[5];
  logic [7:0] select_2520;
  assign select_2520 = equal_594 ? ({{7{not_2517}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2524;
  assign select_2524 = and_2473_s5_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2526;
  assign select_2526 = select_2476 ? {select_2524[6], select_2524} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2529;
  assign select_2529 = select_2476 ? (and_2473_s5_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:460
  logic [6:0] select_2536;
  assign select_2536 = equal_2472_s5_q ? ((6'he < last_s5_q[6:1]) ? 7'h1d : last_s5_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2538;
  assign sum_2538 = {1'b0, last_s5_q[6:3]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2540;
  assign select_2540 = and_550_s5_q ? (equal_2472_s5_q ? {sum_2538, last_s5_q[2:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [5:0] sum_2541;
  assign sum_2541 = {1'b0, last_s5_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2543;
  assign select_2543 = and_550_s5_q ? (equal_2472_s5_q ? {sum_2541, last_s5_q[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2557;
  assign select_2557 = (ends_cell_q | select_2476) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_594 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2561;
  assign and_2561 = (~select_2476) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic equal_2563;
  assign equal_2563 = {sum_2562_s5_q[7], cfg_height_i[10:4]} == {1'b0, sum_2562_s5_q[6:0]};
  // hls/stages/agreement.hpp:520
  logic select_2565;
  assign select_2565 = and_550_s5_q ? (equal_2472_s5_q ? equal_2563 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:372
  logic [8:0] sum_3004;
  assign sum_3004 = {1'b0, select_511_s5_q[3], or_3003_s5_q, select_678_s5_q} + 9'h1;

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
    end else if (s5_en) begin
      run_phase_q <= now;
      run_shift_q <= select_2480;
      run_last_shift_q <= select_2483;
      run_span_q <= select_2485;
      following_phase_q <= select_2498;
      following_shift_q <= select_2488 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2501;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2504[6], or_2505, select_2504[3:0]};
      following_columns_q <= {or_2512[7], or_2513[4], or_2512[5:4], or_2513[3:0]};
      plan_shift_q <= equal_594 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2520;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2526;
      columns_left_q <= select_2529;
      last_q <= and_550_s5_q ? (equal_2472_s5_q ? last_s5_q : last_q) : last_q;
      least_q <= and_550_s5_q ? select_2536 : least_q;
      whole_q <= select_2540;
      drawn_q <= select_2543;
      slot_q <= select_2476 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2557;
      ends_q <= and_2561;
      final_row_q <= select_2565;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
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
  logic equal_2472_s6_q;
  logic and_2473_s6_q;
  logic select_2476_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2960_s6_q;
  logic [3:0] select_2963_s6_q;
  logic not_3006_s6_q;
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
      and_1676_s6_q <= and_1676_s5_q;
      equal_1682_s6_q <= equal_1682_s5_q;
      equal_2472_s6_q <= equal_2472_s5_q;
      and_2473_s6_q <= and_2473_s5_q;
      select_2476_s6_q <= select_2476;
      phase_s6_q <= phase_s5_q;
      equal_2960_s6_q <= row_s5_q == 7'h3;
      select_2963_s6_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_3006_s6_q <= ~({sum_3004, select_529_s5_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  logic [3:0] patches_choosing_rows_to_next_q;
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
  logic [6:0] select_2545;
  assign select_2545 = select_2476_s6_q ? 7'h0 : (ends_cell_s6_q ? {age_q[5:0], 1'b1} : age_q);
  // hls/stages/patches.hpp:87
  logic [3:0] select_2964;
  assign select_2964 = equal_2960_s6_q ? select_2963_s6_q : patches_choosing_rows_to_next_q;
  logic equal_2965;
  assign equal_2965 = select_2964 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2968;
  assign select_2968 = equal_2472_s6_q ? (equal_2965 ? 4'h2 : (select_2964 + 4'hf)) : patches_choosing_rows_to_next_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s6_en) begin
      age_q <= select_2545;
      patches_choosing_rows_to_next_q <= and_550_s6_q ? select_2968 : patches_choosing_rows_to_next_q;
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
  logic equal_2472_s7_q;
  logic and_2473_s7_q;
  logic [3:0] phase_s7_q;
  logic equal_2960_s7_q;
  logic equal_2965_s7_q;
  logic not_3006_s7_q;
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
      patches_choosing_rows_to_next_s7_q <= patches_choosing_rows_to_next_q;
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
      equal_2472_s7_q <= equal_2472_s6_q;
      and_2473_s7_q <= and_2473_s6_q;
      phase_s7_q <= phase_s6_q;
      equal_2960_s7_q <= equal_2960_s6_q;
      equal_2965_s7_q <= equal_2965;
      not_3006_s7_q <= not_3006_s6_q;
    end
  end

  // Stage 7 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:32
  logic not_1680;
  assign not_1680 = ~sample_pair_first_s7_q;
  // hls/stages/patches.hpp:312
  logic equal_1684;
  assign equal_1684 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/agreement.hpp:520
  logic and_2830;
  assign and_2830 = and_550_s7_q & (equal_2472_s7_q & (row_s7_q[6:2] == 5'h0));
  // hls/stages/patches.hpp:374
  logic and_2942;
  assign and_2942 = not_1680 & equal_1682_s7_q;
  logic [8:0] select_2943;
  assign select_2943 = and_2942 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s7_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2944;
  assign select_2944 = and_2942 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2945;
  assign select_2945 = sample_pair_first_s7_q ? select_2943 : select_2944;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2946;
  assign select_2946 = and_1676_s7_q ? select_2945[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2947;
  assign select_2947 = sample_pair_whole_s7_q ? select_2946 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2949;
  assign select_2949 = sample_pair_whole_s7_q ? (and_1676_s7_q ? select_2945[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2952;
  assign select_2952 = sample_pair_whole_s7_q ? (equal_1684 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2954;
  assign select_2954 = sample_pair_whole_s7_q ? (patches_band_rows_number_q + {4'h0, equal_1684}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:331
  logic equal_2955;
  assign equal_2955 = phase_s7_q == 4'h0;
  // hls/stages/patches.hpp:332
  logic not_2956;
  assign not_2956 = ~equal_2955;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2958;
  assign select_2958 = sample_pair_whole_s7_q ? (phase_s7_q + {{2{not_2956}}, 1'b1, not_2956}) : patches_first_band_rows_to_next_q;
  logic select_2959;
  assign select_2959 = sample_pair_whole_s7_q ? equal_2955 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2970;
  assign select_2970 = equal_2960_s7_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2972;
  assign select_2972 = equal_2472_s7_q ? (select_2970 + {4'h0, equal_2965_s7_q}) : patches_choosing_number_q;
  logic select_2976;
  assign select_2976 = equal_2472_s7_q ? ((7'h2 < row_s7_q) & equal_2965_s7_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:520
  logic [4:0] select_2979;
  assign select_2979 = and_550_s7_q ? (equal_2472_s7_q ? select_2970 : patches_choosing_band_q) : patches_choosing_band_q;

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
      patches_band_rows_rows_to_next_q <= 4'h0;
      patches_band_rows_number_q <= 5'h0;
      patches_next_band_rows_to_next_q <= 4'h0;
      patches_next_band_number_q <= 5'h0;
      patches_first_band_rows_to_next_q <= 4'h0;
      patches_first_band_number_q <= 1'b0;
      patches_choosing_number_q <= 5'h0;
      patches_chooses_q <= 1'b0;
      patches_choosing_band_q <= 5'h0;
    end else if (s7_en) begin
      patches_band_rows_rows_to_next_q <= select_2947;
      patches_band_rows_number_q <= select_2949;
      patches_next_band_rows_to_next_q <= select_2952;
      patches_next_band_number_q <= select_2954;
      patches_first_band_rows_to_next_q <= select_2958;
      patches_first_band_number_q <= select_2959;
      patches_choosing_number_q <= and_550_s7_q ? select_2972 : patches_choosing_number_q;
      patches_chooses_q <= and_550_s7_q ? select_2976 : patches_chooses_q;
      patches_choosing_band_q <= select_2979;
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
  logic [4:0] patches_band_rows_number_s8_q;
  logic patches_chooses_s8_q;
  logic [4:0] patches_choosing_band_s8_q;
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
  logic not_1680_s8_q;
  logic or_1686_s8_q;
  logic equal_2472_s8_q;
  logic and_2831_s8_q;
  logic and_2833_s8_q;
  logic and_2840_s8_q;
  logic not_3006_s8_q;
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
      patches_band_rows_number_s8_q <= patches_band_rows_number_q;
      patches_chooses_s8_q <= patches_chooses_q;
      patches_choosing_band_s8_q <= patches_choosing_band_q;
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
      not_1680_s8_q <= not_1680;
      or_1686_s8_q <= (~equal_1682_s7_q) | (~equal_1684);
      equal_2472_s8_q <= equal_2472_s7_q;
      and_2831_s8_q <= and_2473_s7_q & and_2830;
      and_2833_s8_q <= and_2473_s7_q & (~and_2830);
      and_2840_s8_q <= ends_cell_s7_q & so_s7_q;
      not_3006_s8_q <= not_3006_s7_q;
    end
  end

  // Stage 8 -----------------------------------------------------------------------------------------------------------
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
  logic not_1677;
  assign not_1677 = ~patches_begins_q;
  // hls/stages/patches.hpp:363
  logic and_1681;
  assign and_1681 = patches_capturing_q & not_1680_s8_q;
  // hls/stages/patches.hpp:125
  logic and_1689;
  assign and_1689 = (not_1677 & (patches_work_q == 3'h0)) & (~(and_1681 | or_1686_s8_q));
  // hls/stages/registration.hpp:218
  logic [16:0] select_1756;
  assign select_1756 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/patches.hpp:535
  logic equal_1788;
  assign equal_1788 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:506
  logic equal_1790;
  assign equal_1790 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:500
  logic equal_1792;
  assign equal_1792 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1793;
  assign equal_1793 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:535
  logic or_1794;
  assign or_1794 = equal_1792 | equal_1793;
  // hls/stages/patches.hpp:461
  logic not_1795;
  assign not_1795 = ~patches_second_q;
  // hls/stages/patches.hpp:374
  logic [4:0] select_1817;
  assign select_1817 = and_1689 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1818;
  assign select_1818 = and_1676_s8_q ? select_1817 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1820;
  assign and_1820 = and_1681 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1824;
  assign select_1824 = and_1676_s8_q ? (and_1689 | (and_1681 & (~and_1820))) : patches_capturing_q;
  // hls/stages/patches.hpp:168
  logic not_1848;
  assign not_1848 = ~equal_1793;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1862;
  assign select_1862 = and_1676_s8_q ? {select_1817[4], select_1817[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:547
  logic less_1966;
  assign less_1966 = patches_step_q[4:0] < 5'h11;
  logic equal_1967;
  assign equal_1967 = patches_step_q[6:5] == 2'h0;
  logic not_1968;
  assign not_1968 = ~equal_1967;
  logic equal_1969;
  assign equal_1969 = patches_step_q[6:5] == 2'h3;
  logic not_1970;
  assign not_1970 = ~equal_1969;
  // hls/stages/patches.hpp:561
  logic select_1973;
  assign select_1973 = equal_1969 ? (less_1966 & (less_1966 & not_1970)) : less_1966;
  // hls/stages/division.hpp:34
  logic [5:0] sum_1998;
  assign sum_1998 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2834;
  assign select_2834 = and_2833_s8_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2836;
  assign select_2836 = and_2831_s8_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2834[15]}}, select_2834});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2837;
  assign select_2837 = and_2833_s8_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2837[15]}}, select_2837};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2839;
  assign select_2839 = and_2831_s8_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2840_s8_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:394
  logic or_3047;
  assign or_3047 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:396
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:188
  logic and_3053;
  assign and_3053 = equal_1788 & not_1795;
  // hls/stages/patches.hpp:400
  logic and_3054;
  assign and_3054 = not_1848 & and_3053;
  logic [1:0] select_3056;
  assign select_3056 = equal_1790 ? 2'h0 : (equal_1792 ? 2'h3 : {equal_1793, and_3054});
  // hls/stages/patches.hpp:280
  logic equal_3058;
  assign equal_3058 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:278
  logic not_3059;
  assign not_3059 = ~equal_3058;
  // hls/stages/patches.hpp:280
  logic equal_3060;
  assign equal_3060 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:276
  logic not_3061;
  assign not_3061 = ~equal_3060;
  // hls/stages/patches.hpp:284
  logic not_3063;
  assign not_3063 = ~(patches_following_q == 3'h2);
  logic and_3066;
  assign and_3066 = (~(patches_following_q == 3'h1)) & not_3063;
  // hls/stages/patches.hpp:398
  logic [1:0] select_3067;
  assign select_3067 = equal_3060 ? 2'h2 : {and_3066, not_3063};
  logic [3:0] select_3068;
  assign select_3068 = equal_3058 ? 4'h2 : {select_3067, {2{not_3061}}};
  // hls/stages/patches.hpp:406
  logic not_3071;
  assign not_3071 = ~or_3047;
  // hls/stages/patches.hpp:395
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:407
  logic [11:0] select_3076;
  assign select_3076 = or_3047 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3888;
  assign select_3888 = so_s8_q ? (and_2840_s8_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3890;
  assign sum_3890 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3891;
  assign select_3891 = sum_1998[5] ? {1'b1, sum_1998[4:0], region_across_rest_q[2:0]} : sum_3890;
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3893;
  assign select_3893 = equal_2472_s8_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3896;
  assign select_3896 = equal_2472_s8_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1372; read in stage 8, written in stage 23: 8 < 23 < 8 + DISTANCE.
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
    end else if (s8_en) begin
      registration_slope_row_q <= select_2836;
      registration_slope_change_q <= select_2839;
      registration_slope_q <= so_s8_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_capturing_q <= sample_pair_whole_s8_q ? select_1824 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s8_q ? select_1818 : patches_row_q;
      patches_work_q <= or_3047 ? following : patches_work_q;
      patches_second_q <= not_1677 & (patches_second_q | (patches_ends_q & equal_1788));
      patches_following_q <= equal_1788 ? {2'h0, and_3053} : {equal_1790, select_3056};
      patches_following_beats_q <= {select_3068, not_3059};
      patches_begins_q <= sample_pair_whole_s8_q & (and_1676_s8_q & and_1820);
      patches_ends_q <= not_3071 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3076;
      patches_step_q <= or_3047 ? 7'h0 : (patches_step_q + 7'h1);
      region_across_rest_q <= select_3888;
      region_across_back_q <= so_s8_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3891;
      columns_begin_rest_q <= and_550_s8_q ? select_3893 : columns_begin_rest_q;
      columns_begin_back_q <= and_550_s8_q ? select_3896 : columns_begin_back_q;
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
  logic patches_second_s9_q;
  logic [4:0] patches_step_s9_q;
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
  logic and_1689_s9_q;
  logic [16:0] select_1756_s9_q;
  logic equal_1788_s9_q;
  logic equal_1790_s9_q;
  logic equal_1792_s9_q;
  logic equal_1793_s9_q;
  logic or_1794_s9_q;
  logic and_1797_s9_q;
  logic [4:0] select_1818_s9_q;
  logic select_1824_s9_q;
  logic and_1830_s9_q;
  logic and_1849_s9_q;
  logic [3:0] select_1862_s9_q;
  logic less_1966_s9_q;
  logic equal_1967_s9_q;
  logic not_1968_s9_q;
  logic equal_1969_s9_q;
  logic not_1970_s9_q;
  logic select_1973_s9_q;
  logic and_1974_s9_q;
  logic sum_1998_s9_q;
  logic equal_2472_s9_q;
  logic not_3006_s9_q;
  logic or_3047_s9_q;
  logic not_3071_s9_q;
  logic and_3543_s9_q;
  logic equal_3550_s9_q;
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
      patches_band_rows_number_s9_q <= patches_band_rows_number_s8_q;
      patches_chooses_s9_q <= patches_chooses_s8_q;
      patches_choosing_band_s9_q <= patches_choosing_band_s8_q;
      patches_second_s9_q <= patches_second_q;
      patches_step_s9_q <= patches_step_q[4:0];
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
      and_1689_s9_q <= and_1689;
      select_1756_s9_q <= select_1756;
      equal_1788_s9_q <= equal_1788;
      equal_1790_s9_q <= equal_1790;
      equal_1792_s9_q <= equal_1792;
      equal_1793_s9_q <= equal_1793;
      or_1794_s9_q <= or_1794;
      and_1797_s9_q <= or_1794 & (equal_1793 & not_1795);
      select_1818_s9_q <= select_1818;
      select_1824_s9_q <= select_1824;
      and_1830_s9_q <= or_1794 & (patches_second_q & equal_1793);
      and_1849_s9_q <= not_1848 & or_1794;
      select_1862_s9_q <= select_1862;
      less_1966_s9_q <= less_1966;
      equal_1967_s9_q <= equal_1967;
      not_1968_s9_q <= not_1968;
      equal_1969_s9_q <= equal_1969;
      not_1970_s9_q <= not_1970;
      select_1973_s9_q <= select_1973;
      and_1974_s9_q <= not_1968 & select_1973;
      sum_1998_s9_q <= sum_1998[5];
      equal_2472_s9_q <= equal_2472_s8_q;
      not_3006_s9_q <= not_3006_s8_q;
      or_3047_s9_q <= or_3047;
      not_3071_s9_q <= not_3071;
      and_3543_s9_q <= less_1966 & (patches_step_q[6:5] == 2'h1);
      equal_3550_s9_q <= patches_step_q[6:5] == 2'h2;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic [6:0] row_q;
  logic lower_half_q;
  logic [15:0] patches_chance_q;
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
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
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s9_q[6:1]} < x_s9_q;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_580_s9_q ? (less_583_s9_q ? 6'h0 : best_left_rdata_s9_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1758;
  assign select_1758 = ($signed(10'h0) < $signed(select_1756_s9_q[16:7])) ? 14'h7f : select_1756_s9_q[13:0];
  // hls/stages/patches.hpp:513
  logic not_1789;
  assign not_1789 = ~equal_1788_s9_q;
  // hls/stages/patches.hpp:459
  logic not_1791;
  assign not_1791 = ~equal_1790_s9_q;
  logic and_1872;
  assign and_1872 = not_1789 & (or_1794_s9_q & not_1791);
  // hls/stages/patches.hpp:185
  logic and_1976;
  assign and_1976 = equal_1788_s9_q & (less_1966_s9_q ? and_1974_s9_q : select_1973_s9_q);
  // hls/stages/agreement.hpp:460
  logic select_2569;
  assign select_2569 = equal_2472_s9_q ? (~({row_s9_q, 1'b0} < {sum_2566, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2730;
  assign select_2730 = or_580_s9_q ? (less_583_s9_q ? 8'h0 : best_left_rdata_s9_q[32:25]) : 8'h0;
  logic [7:0] select_2732;
  assign select_2732 = or_580_s9_q ? (less_583_s9_q ? 8'h0 : best_left_rdata_s9_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:91
  logic parity_2983;
  assign parity_2983 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2984;
  assign select_2984 = equal_2472_s9_q ? {patches_chance_q[14:0], parity_2983} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s9_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:126
  logic select_3008;
  assign select_3008 = and_1676_s9_q ? (and_1689_s9_q ? not_3006_s9_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:188
  logic [4:0] select_3078;
  assign select_3078 = or_3047_s9_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:561
  logic select_3546;
  assign select_3546 = equal_1969_s9_q ? (less_1966_s9_q ? (not_1970_s9_q & and_3543_s9_q) : and_3543_s9_q) : and_3543_s9_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:780; read in stage 9, written in stage 22: 9 < 22 < 9 + DISTANCE.
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
  assign patches_right_0_re = s9_en & (not_1789 & (not_1791 & and_1797_s9_q));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:780; read in stage 9, written in stage 22: 9 < 22 < 9 + DISTANCE.
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
  assign patches_right_1_re = s9_en & (not_1789 & (not_1791 & and_1830_s9_q));
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:792; read in stage 9, written in stage 13: 9 < 13 < 9 + DISTANCE.
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
  assign patches_columns_above_re = s9_en & and_1872;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:812; read in stage 9, written in stage 24: 9 < 24 < 9 + DISTANCE.
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
  assign patches_rows_re = s9_en & and_1976;
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
    end else if (s9_en) begin
      row_q <= and_550_s9_q ? (equal_2472_s9_q ? row_s9_q : row_q) : row_q;
      lower_half_q <= and_550_s9_q ? select_2569 : lower_half_q;
      patches_chance_q <= and_550_s9_q ? select_2984 : patches_chance_q;
      patches_lower_q <= sample_pair_whole_s9_q ? select_3008 : patches_lower_q;
      patches_code_row_q <= select_3078;
      patches_column_q <= or_3047_s9_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3071_s9_q & (patches_column_q == 5'h1e);
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
  logic not_1789_s10_q;
  logic equal_1790_s10_q;
  logic not_1791_s10_q;
  logic equal_1792_s10_q;
  logic equal_1793_s10_q;
  logic or_1794_s10_q;
  logic [4:0] select_1818_s10_q;
  logic select_1824_s10_q;
  logic and_1851_s10_q;
  logic [3:0] select_1862_s10_q;
  logic and_1872_s10_q;
  logic less_1966_s10_q;
  logic equal_1967_s10_q;
  logic not_1968_s10_q;
  logic equal_1969_s10_q;
  logic not_1970_s10_q;
  logic sum_1998_s10_q;
  logic and_2019_s10_q;
  logic and_2136_s10_q;
  logic equal_2283_s10_q;
  logic equal_2472_s10_q;
  logic and_2598_s10_q;
  logic [7:0] select_2730_s10_q;
  logic [7:0] select_2732_s10_q;
  logic [5:0] further_s10_q;
  logic or_3047_s10_q;
  logic not_3071_s10_q;
  logic select_3548_s10_q;
  logic equal_3550_s10_q;
  logic less_3876_s10_q;
  logic equal_4095_s10_q;
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
      patches_lower_s10_q <= patches_lower_q;
      patches_second_s10_q <= patches_second_s9_q;
      patches_code_row_s10_q <= patches_code_row_q;
      patches_column_s10_q <= patches_column_q;
      patches_step_s10_q <= patches_step_s9_q;
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
      and_1689_s10_q <= and_1689_s9_q;
      right_3_s10_q <= right_3;
      less_1703_s10_q <= 6'h4 < row_q[6:1];
      b_s10_q <= b;
      select_1758_s10_q <= select_1758;
      equal_1788_s10_q <= equal_1788_s9_q;
      not_1789_s10_q <= not_1789;
      equal_1790_s10_q <= equal_1790_s9_q;
      not_1791_s10_q <= not_1791;
      equal_1792_s10_q <= equal_1792_s9_q;
      equal_1793_s10_q <= equal_1793_s9_q;
      or_1794_s10_q <= or_1794_s9_q;
      select_1818_s10_q <= select_1818_s9_q;
      select_1824_s10_q <= select_1824_s9_q;
      and_1851_s10_q <= not_1789 & (not_1791 & and_1849_s9_q);
      select_1862_s10_q <= select_1862_s9_q;
      and_1872_s10_q <= and_1872;
      less_1966_s10_q <= less_1966_s9_q;
      equal_1967_s10_q <= equal_1967_s9_q;
      not_1968_s10_q <= not_1968_s9_q;
      equal_1969_s10_q <= equal_1969_s9_q;
      not_1970_s10_q <= not_1970_s9_q;
      sum_1998_s10_q <= sum_1998_s9_q;
      and_2019_s10_q <= or_580_s9_q & (left_rdata_s9_q[69] & not_584_s9_q);
      and_2136_s10_q <= (7'h6 < row_q) & (~(x_s9_q[7:2] == 6'h0));
      equal_2283_s10_q <= (last_s9_2_q | row_s9_q) == 7'h0;
      equal_2472_s10_q <= equal_2472_s9_q;
      and_2598_s10_q <= not_584_s9_q & and_608;
      select_2730_s10_q <= select_2730;
      select_2732_s10_q <= select_2732;
      further_s10_q <= further;
      or_3047_s10_q <= or_3047_s9_q;
      not_3071_s10_q <= not_3071_s9_q;
      select_3548_s10_q <= less_1966_s9_q ? (not_1968_s9_q & select_3546) : select_3546;
      equal_3550_s10_q <= equal_3550_s9_q;
      less_3876_s10_q <= 6'h2 < row_s9_q[6:1];
      equal_4095_s10_q <= row_s9_q[6:3] == 4'h0;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
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
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2728;
  assign select_2728 = or_580_s10_q ? (less_583_s10_q ? 8'h0 : best_left_rdata_s10_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2730_s10_q} - {1'b0, select_2732_s10_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2989;
  assign select_2989 = right_3_s10_q ? last_s10_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s10_q} + {1'b0, select_2989};

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:781; read in stage 10, written in stage 22: 10 < 22 < 10 + DISTANCE.
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
  assign patches_left_re = s10_en & and_1851_s10_q;
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
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
      patches_read_searches_q <= 1'b0;
    end else if (s10_en) begin
      patches_read_searches_q <= equal_1788_s10_q ? select_3548_s10_q : patches_read_searches_q;
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
  logic [7:0] patches_right_0_rdata_s11_q;
  logic [4:0] select_1818_s11_q;
  logic select_1824_s11_q;
  logic [7:0] patches_right_1_rdata_s11_q;
  logic [3:0] select_1862_s11_q;
  logic and_1872_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic less_1966_s11_q;
  logic equal_1967_s11_q;
  logic not_1968_s11_q;
  logic equal_1969_s11_q;
  logic not_1970_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_1998_s11_q;
  logic and_2019_s11_q;
  logic and_2139_s11_q;
  logic equal_2283_s11_q;
  logic equal_2472_s11_q;
  logic and_2599_s11_q;
  logic equal_2684_s11_q;
  logic [7:0] select_2728_s11_q;
  logic rise_2_s11_q;
  logic [7:0] select_2734_s11_q;
  logic [7:0] xor_2739_s11_q;
  logic less_2765_s11_q;
  logic not_2992_s11_q;
  logic or_3047_s11_q;
  logic not_3071_s11_q;
  logic equal_3550_s11_q;
  logic less_3876_s11_q;
  logic equal_4095_s11_q;
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
      not_1789_s11_q <= not_1789_s10_q;
      equal_1790_s11_q <= equal_1790_s10_q;
      not_1791_s11_q <= not_1791_s10_q;
      equal_1792_s11_q <= equal_1792_s10_q;
      equal_1793_s11_q <= equal_1793_s10_q;
      or_1794_s11_q <= or_1794_s10_q;
      patches_right_0_rdata_s11_q <= patches_right_0_rdata_q;
      select_1818_s11_q <= select_1818_s10_q;
      select_1824_s11_q <= select_1824_s10_q;
      patches_right_1_rdata_s11_q <= patches_right_1_rdata_q;
      select_1862_s11_q <= select_1862_s10_q;
      and_1872_s11_q <= and_1872_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_q;
      less_1966_s11_q <= less_1966_s10_q;
      equal_1967_s11_q <= equal_1967_s10_q;
      not_1968_s11_q <= not_1968_s10_q;
      equal_1969_s11_q <= equal_1969_s10_q;
      not_1970_s11_q <= not_1970_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_1998_s11_q <= sum_1998_s10_q;
      and_2019_s11_q <= and_2019_s10_q;
      and_2139_s11_q <= and_2136_s10_q & (~({sum_1648, last_s10_q[1:0]} < x_s10_q));
      equal_2283_s11_q <= equal_2283_s10_q;
      equal_2472_s11_q <= equal_2472_s10_q;
      and_2599_s11_q <= or_580_s10_q & and_2598_s10_q;
      equal_2684_s11_q <= shift_s10_q == 6'h0;
      select_2728_s11_q <= select_2728;
      rise_2_s11_q <= rise_2[8];
      select_2734_s11_q <= rise_2[8] ? select_2730_s10_q : select_2732_s10_q;
      xor_2739_s11_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2765_s11_q <= select_2730_s10_q < select_2732_s10_q;
      not_2992_s11_q <= ~(x_s10_q < {1'b0, from});
      or_3047_s11_q <= or_3047_s10_q;
      not_3071_s11_q <= not_3071_s10_q;
      equal_3550_s11_q <= equal_3550_s10_q;
      less_3876_s11_q <= less_3876_s10_q;
      equal_4095_s11_q <= equal_4095_s10_q;
    end
  end

  // Stage 11 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/patches.hpp:173
  logic [7:0] pixel;
  assign pixel = equal_1793_s11_q ? (patches_second_s11_q ? 8'h0 : patches_right_0_rdata_s11_q) : 8'h0;
  // hls/stages/patches.hpp:468
  logic [8:0] sum_1919;
  assign sum_1919 = {1'b0, patches_columns_above_rdata_s11_q[23:16]} + {3'h0, patches_columns_above_rdata_s11_q[31:26]};
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2728_s11_q} - {1'b0, select_2734_s11_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s11_q} + {1'b0, xor_2739_s11_q};
  // hls/stages/patches.hpp:557
  logic [9:0] select_3513;
  assign select_3513 = less_1966_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:558
  logic [9:0] select_3515;
  assign select_3515 = less_1966_s11_q ? (equal_1969_s11_q ? 10'h0 : select_3513) : 10'h0;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3520;
  assign select_3520 = less_1966_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3523;
  assign select_3523 = equal_1969_s11_q ? (less_1966_s11_q ? (equal_1969_s11_q ? 5'h0 : select_3520) : 5'h0) : select_3520;

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
  logic [4:0] select_1818_s12_q;
  logic select_1824_s12_q;
  logic [7:0] patches_left_rdata_s12_q;
  logic [3:0] select_1862_s12_q;
  logic and_1872_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] select_1876_s12_q;
  logic [8:0] sum_1919_s12_q;
  logic less_1966_s12_q;
  logic equal_1967_s12_q;
  logic not_1968_s12_q;
  logic equal_1969_s12_q;
  logic not_1970_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1998_s12_q;
  logic and_2019_s12_q;
  logic and_2141_s12_q;
  logic equal_2283_s12_q;
  logic equal_2472_s12_q;
  logic and_2599_s12_q;
  logic equal_2684_s12_q;
  logic [7:0] wide_s12_q;
  logic [8:0] size_3_s12_q;
  logic less_2765_s12_q;
  logic not_2992_s12_q;
  logic or_3047_s12_q;
  logic not_3071_s12_q;
  logic [9:0] select_3516_s12_q;
  logic [4:0] select_3523_s12_q;
  logic equal_3550_s12_q;
  logic less_3876_s12_q;
  logic equal_4095_s12_q;
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
      patches_read_searches_s12_q <= patches_read_searches_s11_q;
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
      select_1818_s12_q <= select_1818_s11_q;
      select_1824_s12_q <= select_1824_s11_q;
      patches_left_rdata_s12_q <= patches_left_rdata_q;
      select_1862_s12_q <= select_1862_s11_q;
      and_1872_s12_q <= and_1872_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      select_1876_s12_q <= patches_second_s11_q ? patches_right_1_rdata_s11_q : pixel;
      sum_1919_s12_q <= sum_1919;
      less_1966_s12_q <= less_1966_s11_q;
      equal_1967_s12_q <= equal_1967_s11_q;
      not_1968_s12_q <= not_1968_s11_q;
      equal_1969_s12_q <= equal_1969_s11_q;
      not_1970_s12_q <= not_1970_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_1998_s12_q <= sum_1998_s11_q;
      and_2019_s12_q <= and_2019_s11_q;
      and_2141_s12_q <= so_s11_q & (ends_cell_s11_q & and_2139_s11_q);
      equal_2283_s12_q <= equal_2283_s11_q;
      equal_2472_s12_q <= equal_2472_s11_q;
      and_2599_s12_q <= and_2599_s11_q;
      equal_2684_s12_q <= equal_2684_s11_q;
      wide_s12_q <= wide;
      size_3_s12_q <= size_3;
      less_2765_s12_q <= less_2765_s11_q;
      not_2992_s12_q <= not_2992_s11_q;
      or_3047_s12_q <= or_3047_s11_q;
      not_3071_s12_q <= not_3071_s11_q;
      select_3516_s12_q <= equal_1969_s11_q ? select_3515 : select_3513;
      select_3523_s12_q <= select_3523;
      equal_3550_s12_q <= equal_3550_s11_q;
      less_3876_s12_q <= less_3876_s11_q;
      equal_4095_s12_q <= equal_4095_s11_q;
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
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
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
  // hls/stages/patches.hpp:173
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1793_s12_q ? select_1876_s12_q : patches_left_rdata_s12_q;
  // hls/stages/patches.hpp:468
  logic [9:0] sum_1920;
  assign sum_1920 = {2'h0, patches_columns_above_rdata_s12_q[15:8]} + {1'b0, sum_1919_s12_q};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2742;
  assign select_2742 = ({wide_s12_q, 1'b0} < size_3_s12_q) ? {wide_s12_q, 1'b0} : size_3_s12_q;
  logic [8:0] taken;
  assign taken = ~select_2742;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3518;
  assign select_3518 = less_1966_s12_q ? (equal_1967_s12_q ? 10'h0 : select_3516_s12_q) : select_3516_s12_q;
  logic [4:0] select_3525;
  assign select_3525 = less_1966_s12_q ? (equal_1967_s12_q ? 5'h0 : select_3523_s12_q) : select_3523_s12_q;
  // hls/stages/patches.hpp:557
  logic and_3535;
  assign and_3535 = less_1966_s12_q & (patches_step_s12_q == 5'h0);
  // hls/stages/patches.hpp:561
  logic select_3538;
  assign select_3538 = equal_1969_s12_q ? (less_1966_s12_q ? (not_1970_s12_q & and_3535) : and_3535) : and_3535;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
    end else if (s12_en) begin
      patches_read_row_differing_q <= equal_1788_s12_q ? select_3518 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1788_s12_q ? select_3525 : patches_read_row_column_q;
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
  logic [9:0] patches_read_row_differing_s13_q;
  logic [4:0] patches_read_row_column_s13_q;
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
  logic [3:0] select_1862_s13_q;
  logic and_1872_s13_q;
  logic [31:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [9:0] sum_1920_s13_q;
  logic less_1966_s13_q;
  logic equal_1967_s13_q;
  logic not_1968_s13_q;
  logic equal_1969_s13_q;
  logic not_1970_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1998_s13_q;
  logic and_2019_s13_q;
  logic and_2141_s13_q;
  logic equal_2283_s13_q;
  logic equal_2472_s13_q;
  logic and_2599_s13_q;
  logic equal_2684_s13_q;
  logic less_2726_s13_q;
  logic [7:0] wide_s13_q;
  logic [8:0] taken_s13_q;
  logic [7:0] not_2744_s13_q;
  logic less_2765_s13_q;
  logic and_2995_s13_q;
  logic or_3047_s13_q;
  logic not_3071_s13_q;
  logic select_3538_s13_q;
  logic equal_3550_s13_q;
  logic less_3876_s13_q;
  logic equal_4095_s13_q;
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
      patches_read_row_differing_s13_q <= patches_read_row_differing_q;
      patches_read_row_column_s13_q <= patches_read_row_column_q;
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
      select_1862_s13_q <= select_1862_s12_q;
      and_1872_s13_q <= and_1872_s12_q;
      patches_columns_above_rdata_s13_q <= patches_columns_above_rdata_s12_q;
      pixel_2_s13_q <= pixel_2;
      sum_1920_s13_q <= sum_1920;
      less_1966_s13_q <= less_1966_s12_q;
      equal_1967_s13_q <= equal_1967_s12_q;
      not_1968_s13_q <= not_1968_s12_q;
      equal_1969_s13_q <= equal_1969_s12_q;
      not_1970_s13_q <= not_1970_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1998_s13_q <= sum_1998_s12_q;
      and_2019_s13_q <= and_2019_s12_q;
      and_2141_s13_q <= and_2141_s12_q;
      equal_2283_s13_q <= equal_2283_s12_q;
      equal_2472_s13_q <= equal_2472_s12_q;
      and_2599_s13_q <= and_2599_s12_q;
      equal_2684_s13_q <= equal_2684_s12_q;
      less_2726_s13_q <= slot_s12_q < 3'h3;
      wide_s13_q <= wide_s12_q;
      taken_s13_q <= taken;
      not_2744_s13_q <= ~wide_s12_q;
      less_2765_s13_q <= less_2765_s12_q;
      and_2995_s13_q <= so_s12_q & (ends_cell_s12_q & (inside_v & not_2992_s12_q));
      or_3047_s13_q <= or_3047_s12_q;
      not_3071_s13_q <= not_3071_s12_q;
      select_3538_s13_q <= select_3538;
      equal_3550_s13_q <= equal_3550_s12_q;
      less_3876_s13_q <= less_3876_s12_q;
      equal_4095_s13_q <= equal_4095_s12_q;
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
  assign and_525 = sample_pair_whole_s13_q & and_524_s13_q;
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
  // hls/stages/patches.hpp:470
  logic [8:0] sum_1900;
  assign sum_1900 = {1'b0, patches_columns_above_rdata_s13_q[7:0]} + {2'h0, pixel_2_s13_q[7:1]};
  logic [8:0] sum_1901;
  assign sum_1901 = {1'b0, patches_columns_above_rdata_s13_q[23:16]} + {2'h0, patches_columns_above_rdata_s13_q[31:25]};
  // hls/stages/patches.hpp:468
  logic [10:0] sum_1921;
  assign sum_1921 = {3'h0, patches_columns_above_rdata_s13_q[15:8]} + {sum_1920_s13_q, patches_columns_above_rdata_s13_q[25]};
  // hls/stages/agreement.hpp:788
  logic and_2335;
  assign and_2335 = not_576 & (not_578 & (equal_579_s13_q & (inside_v_s13_q & first_s13_q)));
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2572;
  assign select_2572 = slot_s13_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2573;
  assign select_2573 = slot_s13_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2574;
  assign select_2574 = slot_s13_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2575;
  assign select_2575 = slot_s13_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2576;
  assign select_2576 = slot_s13_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2577;
  assign select_2577 = slot_s13_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s13_q[61:54]} - {1'b0, best_left_rdata_s13_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2737;
  assign not_2737 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2726_s13_q ? {1'b0, wide_s13_q, 1'b0} : {registration_displacement_over_q[8:0], not_2737};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2745;
  assign select_2745 = registration_displacement_over_q[9] ? wide_s13_q : not_2744_s13_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2726_s13_q ? {taken_s13_q, 1'b1} : {not_2737, select_2745, not_2737};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2747;
  assign sum_2747 = {left, 1'b1} + {taken_2, less_2726_s13_q};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2749;
  assign select_2749 = so_s13_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2751;
  assign select_2751 = equal_575_s13_q ? registration_slope_here_q : (so_s13_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2760;
  assign select_2760 = or_580_s13_q ? (less_583_s13_q ? 3'h0 : best_left_rdata_s13_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:188
  logic select_3086;
  assign select_3086 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:176
  logic and_3147;
  assign and_3147 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:414
  logic [4:0] select_3152;
  assign select_3152 = or_3047_s13_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:416
  logic [3:0] select_3154;
  assign select_3154 = and_3147 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:557
  logic [4:0] select_3527;
  assign select_3527 = less_1966_s13_q ? patches_step_s13_q : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3530;
  assign select_3530 = equal_1969_s13_q ? (less_1966_s13_q ? (equal_1969_s13_q ? 5'h0 : select_3527) : 5'h0) : select_3527;
  logic [4:0] select_3532;
  assign select_3532 = less_1966_s13_q ? (equal_1967_s13_q ? 5'h0 : select_3530) : select_3530;
  logic select_3540;
  assign select_3540 = less_1966_s13_q ? (not_1968_s13_q & select_3538_s13_q) : select_3538_s13_q;
  // hls/stages/patches.hpp:179
  logic or_3552;
  assign or_3552 = patches_read_first_q | (patches_read_row_differing_s13_q < patches_peak_best_differing_q);
  logic and_3553;
  assign and_3553 = patches_read_searches_s13_q & or_3552;
  // hls/stages/patches.hpp:540
  logic [14:0] select_3585;
  assign select_3585 = and_3553 ? {patches_read_row_column_s13_q, patches_read_row_differing_s13_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:185
  logic [9:0] select_3586;
  assign select_3586 = equal_1788_s13_q ? select_3585[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3587;
  assign select_3587 = equal_1788_s13_q ? select_3585[14:10] : patches_peak_best_column_q;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:235; read in stage 13, written in stage 16: 13 < 16 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_515_s13_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s13_en & and_525;
`endif
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

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

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s13_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s13_en & and_1872_s13_q;
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
    end else if (s13_en) begin
      moments_place_q <= select_573;
      moments_taken_q <= not_576 & (not_578 & (equal_579_s13_q & inside_v_s13_q));
      moments_starts_q <= and_2335;
      shift_not_right_q <= $signed(run_shift_s13_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s13_q ? sum_2747[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2749;
      registration_slope_here_q <= select_2751;
      patches_along_ends_q <= not_3071_s13_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3071_s13_q & select_3086;
      patches_down_by_q <= or_3047_s13_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3147});
      patches_along_q <= select_3152;
      patches_match_row_q <= or_3047_s13_q ? 4'h0 : select_3154;
      patches_summed_last_q <= not_1789_s13_q & (equal_1790_s13_q & and_3147);
      patches_read_first_q <= equal_1788_s13_q ? select_3540 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3586;
      patches_peak_best_column_q <= select_3587;
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
      middle_sum_columns_values_1_q <= select_2572;
      middle_sum_columns_values_2_q <= select_2573;
      middle_sum_columns_values_3_q <= select_2574;
      middle_sum_columns_values_4_q <= select_2575;
      middle_sum_columns_values_5_q <= select_2576;
      middle_sum_columns_values_6_q <= select_2577;
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
  logic patches_match_row_ends_s14_q;
  logic [4:0] patches_down_by_s14_q;
  logic [4:0] patches_along_s14_q;
  logic [3:0] patches_match_row_s14_q;
  logic patches_summed_last_s14_q;
  logic [4:0] patches_step_s14_q;
  logic [9:0] patches_read_row_differing_s14_q;
  logic patches_read_first_s14_q;
  logic [3:0] select_508_s14_q;
  logic equal_509_s14_q;
  logic [6:0] select_511_s14_q;
  logic [8:0] select_515_s14_q;
  logic and_524_s14_q;
  logic and_525_s14_q;
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
  logic [3:0] select_1862_s14_q;
  logic [8:0] patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic [4:0] sum_1886_s14_q;
  logic [8:0] sum_1900_s14_q;
  logic [8:0] sum_1901_s14_q;
  logic [10:0] sum_1921_s14_q;
  logic less_1966_s14_q;
  logic equal_1967_s14_q;
  logic not_1968_s14_q;
  logic equal_1969_s14_q;
  logic not_1970_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic sum_1998_s14_q;
  logic and_2019_s14_q;
  logic and_2142_s14_q;
  logic equal_2283_s14_q;
  logic equal_2472_s14_q;
  logic and_2599_s14_q;
  logic equal_2684_s14_q;
  logic rise_s14_q;
  logic [7:0] xor_2689_s14_q;
  logic select_2760_s14_q;
  logic or_2763_s14_q;
  logic [1:0] sum_2764_s14_q;
  logic less_2765_s14_q;
  logic and_2996_s14_q;
  logic [4:0] select_3532_s14_q;
  logic equal_3550_s14_q;
  logic and_3553_s14_q;
  logic [14:0] select_3585_s14_q;
  logic less_3876_s14_q;
  logic equal_4095_s14_q;
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
      patches_match_row_ends_s14_q <= patches_match_row_ends_q;
      patches_down_by_s14_q <= patches_down_by_q;
      patches_along_s14_q <= patches_along_q;
      patches_match_row_s14_q <= patches_match_row_q;
      patches_summed_last_s14_q <= patches_summed_last_q;
      patches_step_s14_q <= patches_step_s13_q;
      patches_read_row_differing_s14_q <= patches_read_row_differing_s13_q;
      patches_read_first_s14_q <= patches_read_first_q;
      select_508_s14_q <= select_508_s13_q;
      equal_509_s14_q <= equal_509_s13_q;
      select_511_s14_q <= select_511_s13_q;
      select_515_s14_q <= select_515_s13_q;
      and_524_s14_q <= and_524_s13_q;
      and_525_s14_q <= and_525;
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
      select_1862_s14_q <= select_1862_s13_q;
      patches_columns_above_rdata_s14_q <= {patches_columns_above_rdata_s13_q[24], patches_columns_above_rdata_s13_q[7:0]};
      pixel_2_s14_q <= pixel_2_s13_q;
      sum_1886_s14_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1900_s14_q <= sum_1900;
      sum_1901_s14_q <= sum_1901;
      sum_1921_s14_q <= sum_1921;
      less_1966_s14_q <= less_1966_s13_q;
      equal_1967_s14_q <= equal_1967_s13_q;
      not_1968_s14_q <= not_1968_s13_q;
      equal_1969_s14_q <= equal_1969_s13_q;
      not_1970_s14_q <= not_1970_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      sum_1998_s14_q <= sum_1998_s13_q;
      and_2019_s14_q <= and_2019_s13_q;
      and_2142_s14_q <= not_576 & and_2141_s13_q;
      equal_2283_s14_q <= equal_2283_s13_q;
      equal_2472_s14_q <= equal_2472_s13_q;
      and_2599_s14_q <= and_2599_s13_q;
      equal_2684_s14_q <= equal_2684_s13_q;
      rise_s14_q <= rise[8];
      xor_2689_s14_q <= rise[7:0] ^ {8{rise[8]}};
      select_2760_s14_q <= select_2760[0];
      or_2763_s14_q <= (select_2760 == 3'h0) | (select_2760 == 3'h4);
      sum_2764_s14_q <= select_2760[2:1] + 2'h3;
      less_2765_s14_q <= less_2765_s13_q;
      and_2996_s14_q <= not_576 & and_2995_s13_q;
      select_3532_s14_q <= select_3532;
      equal_3550_s14_q <= equal_3550_s13_q;
      and_3553_s14_q <= and_3553;
      select_3585_s14_q <= select_3585;
      less_3876_s14_q <= less_3876_s13_q;
      equal_4095_s14_q <= equal_4095_s13_q;
    end
  end

  // Stage 14 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:113
  logic [13:0] select_528;
  assign select_528 = equal_509_s14_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_534;
  assign sum_534 = {6'h0, sample_pair_pixel_1_q} + (equal_509_s14_q ? 14'h0 : averager_running_1_q);
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
  // hls/stages/patches.hpp:501
  logic less_1878;
  assign less_1878 = 5'he < patches_along_s14_q;
  // hls/stages/patches.hpp:502
  logic or_1879;
  assign or_1879 = equal_1792_s14_q | less_1878;
  // hls/stages/patches.hpp:505
  logic new_row;
  assign new_row = patches_along_s14_q == 5'h0;
  logic select_1884;
  assign select_1884 = equal_1792_s14_q ? patches_column_s14_q[0] : (or_1879 ? (patches_along_s14_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:503
  logic [4:0] select_1887;
  assign select_1887 = patches_match_row_ends_s14_q ? patches_down_by_s14_q : sum_1886_s14_q;
  // hls/stages/patches.hpp:506
  logic [4:0] select_1890;
  assign select_1890 = equal_1792_s14_q ? 5'h0 : (or_1879 ? (select_1887 + 5'h1) : sum_1886_s14_q);
  // hls/stages/patches.hpp:482
  logic equal_1893;
  assign equal_1893 = patches_column_s14_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s14_q == 5'h11;
  logic equal_1895;
  assign equal_1895 = patches_column_s14_q == 5'h18;
  // hls/stages/patches.hpp:484
  logic and_1897;
  assign and_1897 = of_row & (~equal_1895);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1893 ? 2'h3 : {equal_1895, and_1897};
  // hls/stages/patches.hpp:470
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1900_s14_q, pixel_2_s14_q[0]} - {1'b0, sum_1901_s14_q, patches_columns_above_rdata_s14_q[8]};
  // hls/stages/patches.hpp:468
  logic [9:0] sum_1922;
  assign sum_1922 = {2'h0, patches_columns_above_rdata_s14_q[7:0]} + sum_1921_s14_q[10:1];
  // hls/stages/patches.hpp:483
  logic or_1941;
  assign or_1941 = (((patches_column_s14_q == 5'ha) | of_row) | equal_1895) | equal_1893;
  // hls/stages/patches.hpp:478
  logic and_1946;
  assign and_1946 = (~(patches_code_row_s14_q[4:2] == 3'h0)) & (~(patches_column_s14_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:173
  logic and_1960;
  assign and_1960 = (~(equal_1793_s14_q | (~and_1946))) & (~patches_column_s14_q[4]);
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2584;
  assign select_2584 = slot_s14_q[0] ? 7'h0 : sum_1538_s14_q;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_2586;
  assign select_2586 = (select_2584 < select_1547_s14_q) ? select_1547_s14_q : select_2584;
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise_s14_q ? best_left_rdata_s14_q[61:54] : best_left_rdata_s14_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2766;
  assign difference_2766 = {sum_2764_s14_q, select_2760_s14_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2767;
  assign select_2767 = less_2765_s14_q ? difference_2766 : {sum_2764_s14_q, select_2760_s14_q, registration_displacement_fraction_q};
  logic [7:0] select_2768;
  assign select_2768 = or_2763_s14_q ? {sum_2764_s14_q, select_2760_s14_q, 5'h0} : select_2767;
  // hls/stages/patches.hpp:185
  logic [4:0] select_3509;
  assign select_3509 = equal_1790_s14_q ? patches_down_by_s14_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:541
  logic [4:0] select_3554;
  assign select_3554 = and_3553_s14_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:548
  logic [5:0] away;
  assign away = {1'b0, patches_step_s14_q} - {1'b0, select_3554};

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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      chosen_near_q <= 7'h0;
      patches_summed_down_by_q <= 5'h0;
      patches_read_at_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
    end else if (s14_en) begin
      sample_pair_pixel_0_q <= pixel_0_s14_q;
      sample_pair_pixel_1_q <= pixel_1_s14_q;
      chosen_near_q <= select_2586;
      patches_summed_down_by_q <= equal_1788_s14_q ? patches_summed_down_by_q : select_3509;
      patches_read_at_q <= equal_1788_s14_q ? select_3532_s14_q : patches_read_at_q;
      patches_peak_row_q <= equal_1788_s14_q ? select_3554 : patches_peak_row_q;
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
    if (s14_en) begin
      averager_running_0_q <= sample_pair_whole_s14_q ? select_528 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s14_q ? sum_534 : averager_running_1_q;
      middle_sum_sum_sums_values_0_q <= slot_s14_q[0] ? middle_sum_sum_sums_values_0_q : sum_1012;
      sums_0_sum_sums_values_0_q <= sum_1262;
      sums_0_sum_sums_values_1_q <= equal_1260_s14_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1510;
      sums_1_sum_sums_values_1_q <= equal_1260_s14_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic shift_not_right_s15_q;
  logic [4:0] patches_band_rows_number_s15_q;
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
  logic [3:0] select_508_s15_q;
  logic equal_509_s15_q;
  logic [6:0] select_511_s15_q;
  logic [8:0] select_515_s15_q;
  logic and_524_s15_q;
  logic and_525_s15_q;
  logic [29:0] averager_memory_rdata_s15_q;
  logic [13:0] select_528_s15_q;
  logic equal_530_s15_q;
  logic [13:0] sum_534_s15_q;
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
  logic equal_1793_s15_q;
  logic or_1794_s15_q;
  logic [4:0] select_1818_s15_q;
  logic select_1824_s15_q;
  logic [3:0] select_1862_s15_q;
  logic patches_columns_above_rdata_s15_q;
  logic [7:0] pixel_2_s15_q;
  logic less_1878_s15_q;
  logic new_row_s15_q;
  logic select_1884_s15_q;
  logic not_1885_s15_q;
  logic [4:0] select_1890_s15_q;
  logic or_1891_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [10:0] down_2_s15_q;
  logic sum_1921_s15_q;
  logic [9:0] sum_1922_s15_q;
  logic and_1949_s15_q;
  logic and_1960_s15_q;
  logic and_1963_s15_q;
  logic less_1966_s15_q;
  logic equal_1967_s15_q;
  logic not_1968_s15_q;
  logic equal_1969_s15_q;
  logic not_1970_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic sum_1998_s15_q;
  logic and_2019_s15_q;
  logic [17:0] seen_columns_rdata_s15_q;
  logic and_2142_s15_q;
  logic equal_2283_s15_q;
  logic equal_2472_s15_q;
  logic and_2599_s15_q;
  logic equal_2684_s15_q;
  logic [7:0] lower_s15_q;
  logic [7:0] sum_2690_s15_q;
  logic [7:0] select_2768_s15_q;
  logic and_2996_s15_q;
  logic less_3123_s15_q;
  logic equal_3550_s15_q;
  logic [4:0] select_3554_s15_q;
  logic [5:0] away_s15_q;
  logic equal_3556_s15_q;
  logic equal_3565_s15_q;
  logic [14:0] select_3585_s15_q;
  logic less_3876_s15_q;
  logic equal_4095_s15_q;
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
      patches_along_s15_q <= patches_along_s14_q;
      patches_match_row_s15_q <= patches_match_row_s14_q;
      patches_summed_last_s15_q <= patches_summed_last_s14_q;
      patches_summed_down_by_s15_q <= patches_summed_down_by_q;
      patches_read_row_differing_s15_q <= patches_read_row_differing_s14_q;
      patches_read_first_s15_q <= patches_read_first_s14_q;
      select_508_s15_q <= select_508_s14_q;
      equal_509_s15_q <= equal_509_s14_q;
      select_511_s15_q <= select_511_s14_q;
      select_515_s15_q <= select_515_s14_q;
      and_524_s15_q <= and_524_s14_q;
      and_525_s15_q <= and_525_s14_q;
      averager_memory_rdata_s15_q <= averager_memory_rdata_q;
      select_528_s15_q <= select_528;
      equal_530_s15_q <= equal_530_s14_q;
      sum_534_s15_q <= sum_534;
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
      equal_1793_s15_q <= equal_1793_s14_q;
      or_1794_s15_q <= or_1794_s14_q;
      select_1818_s15_q <= select_1818_s14_q;
      select_1824_s15_q <= select_1824_s14_q;
      select_1862_s15_q <= select_1862_s14_q;
      patches_columns_above_rdata_s15_q <= patches_columns_above_rdata_s14_q[8];
      pixel_2_s15_q <= pixel_2_s14_q;
      less_1878_s15_q <= less_1878;
      new_row_s15_q <= new_row;
      select_1884_s15_q <= select_1884;
      not_1885_s15_q <= ~or_1879;
      select_1890_s15_q <= select_1890;
      or_1891_s15_q <= equal_1792_s14_q | equal_1790_s14_q;
      of_row_2_s15_q <= of_row_2;
      down_2_s15_q <= down_2;
      sum_1921_s15_q <= sum_1921_s14_q[0];
      sum_1922_s15_q <= sum_1922;
      and_1949_s15_q <= or_1794_s14_q & (or_1941 & (equal_1793_s14_q & and_1946));
      and_1960_s15_q <= and_1960;
      and_1963_s15_q <= or_1794_s14_q & (and_1960 & (patches_column_s14_q == 5'hf));
      less_1966_s15_q <= less_1966_s14_q;
      equal_1967_s15_q <= equal_1967_s14_q;
      not_1968_s15_q <= not_1968_s14_q;
      equal_1969_s15_q <= equal_1969_s14_q;
      not_1970_s15_q <= not_1970_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      sum_1998_s15_q <= sum_1998_s14_q;
      and_2019_s15_q <= and_2019_s14_q;
      seen_columns_rdata_s15_q <= seen_columns_rdata_q;
      and_2142_s15_q <= and_2142_s14_q;
      equal_2283_s15_q <= equal_2283_s14_q;
      equal_2472_s15_q <= equal_2472_s14_q;
      and_2599_s15_q <= and_2599_s14_q;
      equal_2684_s15_q <= equal_2684_s14_q;
      lower_s15_q <= lower;
      sum_2690_s15_q <= {7'h0, rise_s14_q} + xor_2689_s14_q;
      select_2768_s15_q <= select_2768;
      and_2996_s15_q <= and_2996_s14_q;
      less_3123_s15_q <= 4'he < patches_column_s14_q[4:1];
      equal_3550_s15_q <= equal_3550_s14_q;
      select_3554_s15_q <= select_3554;
      away_s15_q <= away;
      equal_3556_s15_q <= away == 6'h3f;
      equal_3565_s15_q <= away == 6'h1;
      select_3585_s15_q <= select_3585_s14_q;
      less_3876_s15_q <= less_3876_s14_q;
      equal_4095_s15_q <= equal_4095_s14_q;
    end
  end

  // Stage 15 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:126
  logic [13:0] sum_532;
  assign sum_532 = select_528_s15_q + (equal_530_s15_q ? 14'h0 : averager_memory_rdata_s15_q[13:0]);
  logic [13:0] sum_536;
  assign sum_536 = sum_534_s15_q + (equal_530_s15_q ? 14'h0 : averager_memory_rdata_s15_q[27:14]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = equal_509_s15_q ? sample_present_s15_q : (sample_present_s15_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_509_s15_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:128
  logic and_544;
  assign and_544 = all_of_skin & (averager_memory_rdata_s15_q[29] | equal_530_s15_q);
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
  // hls/stages/patches.hpp:211
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
  // hls/stages/patches.hpp:374
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
  // hls/stages/patches.hpp:354
  logic equal_1802;
  assign equal_1802 = {patches_choosing_band_s15_q, and_1702_s15_q} == {select_1801, select_1693[1]};
  // hls/stages/patches.hpp:472
  logic [11:0] sum_1903;
  assign sum_1903 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1904;
  assign sum_1904 = {{4{down_2_s15_q[10]}}, down_2_s15_q[10:2]} + {sum_1903[11], sum_1903};
  // hls/stages/patches.hpp:469
  logic [11:0] smooth;
  assign smooth = {sum_1922_s15_q, sum_1921_s15_q, patches_columns_above_rdata_s15_q} + {4'h0, pixel_2_s15_q};
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1985;
  assign select_1985 = so_s15_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1988;
  assign or_1988 = select_1985[7] | (~({select_1985[5], select_1985[3], select_1985[1]} == 3'h0));
  // hls/stages/agreement.hpp:1058
  logic or_2000;
  assign or_2000 = (~sum_1998_s15_q) | equal_1781_s15_q;
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s15_q & (or_580_s15_q & (not_584_s15_q & and_609_s15_q));
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2083;
  assign select_2083 = inside_v_s15_q ? (sum_1998_s15_q ? select_1985 : {select_1985[6:0], 1'b0}) : select_1985;
  // hls/stages/agreement.hpp:1050
  logic or_2086;
  assign or_2086 = select_2083[7] | (~({select_2083[5], select_2083[3], select_2083[1]} == 3'h0));
  // hls/stages/agreement.hpp:276
  logic select_2196;
  assign select_2196 = sample_pair_whole_s15_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:239
  logic [7:0] select_2581;
  assign select_2581 = slot_s15_q[0] ? 8'h0 : sum_1012_s15_q;
  // hls/stages/agreement.hpp:751
  logic less_2582;
  assign less_2582 = select_2581 < select_1512;
  // hls/stages/agreement.hpp:788
  logic less_2588;
  assign less_2588 = $signed(run_shift_s15_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2590;
  assign less_2590 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s15_q);
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2688;
  assign difference_2688 = best_left_rdata_s15_q[16:9] - lower_s15_q;
  // hls/stages/agreement.hpp:788
  logic [10:0] select_2753;
  assign select_2753 = equal_575_s15_q ? registration_expected_q : (so_s15_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2768_s15_q[7]}}, select_2768_s15_q} - {sum_1717_s15_q[9], sum_1717_s15_q, sum_1713_s15_q};
  // hls/stages/patches.hpp:355
  logic not_3012;
  assign not_3012 = ~select_1693[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3014;
  assign select_3014 = sample_pair_whole_s15_q ? (equal_1694 ? select_1693 : {not_3012, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:185
  logic [10:0] select_3101;
  assign select_3101 = equal_1790_s15_q ? patches_down_values_0_q : (or_1794_s15_q ? down_2_s15_q : patches_down_values_0_q);
  logic [10:0] select_3103;
  assign select_3103 = or_1794_s15_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3105;
  assign select_3105 = equal_1788_s15_q ? patches_down_values_1_q : (equal_1790_s15_q ? patches_down_values_1_q : select_3103);
  // hls/stages/patches.hpp:557
  logic and_3558;
  assign and_3558 = less_1966_s15_q & (equal_3550_s15_q & equal_3556_s15_q);
  // hls/stages/patches.hpp:561
  logic select_3561;
  assign select_3561 = equal_1969_s15_q ? (less_1966_s15_q ? (not_1970_s15_q & and_3558) : and_3558) : and_3558;
  // hls/stages/patches.hpp:557
  logic and_3567;
  assign and_3567 = less_1966_s15_q & (equal_3550_s15_q & equal_3565_s15_q);
  // hls/stages/patches.hpp:561
  logic select_3570;
  assign select_3570 = equal_1969_s15_q ? (less_1966_s15_q ? (not_1970_s15_q & and_3567) : and_3567) : and_3567;
  // hls/stages/patches.hpp:554
  logic [6:0] sum_3574;
  assign sum_3574 = {away_s15_q[5], away_s15_q} + 7'h7d;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3877;
  assign sum_3877 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3886;
  assign select_3886 = equal_575_s15_q ? select_1985 : (so_s15_q ? (ends_cell_s15_q ? select_2083 : select_1985) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3900;
  assign select_3900 = equal_680_s15_q ? {difference_3898[7], difference_3898} : (less_3876_s15_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3902;
  assign select_3902 = and_550_s15_q ? (equal_2472_s15_q ? select_3900 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3904;
  assign select_3904 = equal_680_s15_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_3906;
  assign select_3906 = and_550_s15_q ? (equal_2472_s15_q ? select_3904 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3908;
  assign select_3908 = sum_3877[7] ? {1'b1, sum_3877[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:349; read in stage 15, written in stage 17: 15 < 17 < 15 + DISTANCE.
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
  assign census_memory_re = s15_en & and_550_s15_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

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

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:797; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1890_s15_q, not_1885_s15_q, select_1884_s15_q};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s15_en & or_1891_s15_q;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:798; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
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
  assign patches_left_codes_re = s15_en & (not_1789_s15_q & (new_row_s15_q & equal_1790_s15_q));
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
    end else if (s15_en) begin
      sample_of_skin_q <= mask_s15_q;
      averager_running_mask_q <= sample_pair_whole_s15_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2196;
      chosen_score_q <= less_2582 ? select_1512 : select_2581;
      chosen_place_q <= less_2582 ? {select_1520, not_1519} : 3'h2;
      before_0_q <= select_2581;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2588) & (~less_2590);
      registration_expected_q <= select_2753;
      patches_band_q <= sample_pair_whole_s15_q ? select_1801 : patches_band_q;
      patches_fetch_q <= select_3014;
      patches_down_values_0_q <= equal_1788_s15_q ? patches_down_values_0_q : select_3101;
      patches_down_values_1_q <= select_3105;
      region_columns_q <= select_3886;
      region_down_rest_q <= select_3902;
      region_down_back_q <= select_3906;
      region_down_next_q <= select_3908;
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
  logic [7:0] before_0_s16_q;
  logic [7:0] before_1_s16_q;
  logic [7:0] before_2_s16_q;
  logic shift_not_right_s16_q;
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
  logic [3:0] select_508_s16_q;
  logic [6:0] select_511_s16_q;
  logic [8:0] select_515_s16_q;
  logic and_524_s16_q;
  logic and_525_s16_q;
  logic [13:0] sum_532_s16_q;
  logic [13:0] sum_536_s16_q;
  logic and_540_s16_q;
  logic and_544_s16_q;
  logic [6:0] last_s16_q;
  logic and_548_s16_q;
  logic and_550_s16_q;
  logic equal_553_s16_q;
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
  logic equal_1790_s16_q;
  logic equal_1793_s16_q;
  logic or_1794_s16_q;
  logic and_1803_s16_q;
  logic [4:0] select_1818_s16_q;
  logic select_1824_s16_q;
  logic [3:0] select_1862_s16_q;
  logic less_1878_s16_q;
  logic new_row_s16_q;
  logic or_1891_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic [1:0] down_2_s16_q;
  logic [12:0] sum_1904_s16_q;
  logic [11:0] smooth_s16_q;
  logic and_1951_s16_q;
  logic and_1960_s16_q;
  logic and_1965_s16_q;
  logic less_1966_s16_q;
  logic equal_1967_s16_q;
  logic not_1968_s16_q;
  logic equal_1969_s16_q;
  logic [9:0] patches_rows_rdata_s16_q;
  logic or_1988_s16_q;
  logic or_1991_s16_q;
  logic or_1994_s16_q;
  logic and_2003_s16_q;
  logic textured_s16_q;
  logic and_2019_s16_q;
  logic [12:0] seen_columns_rdata_s16_q;
  logic and_2069_s16_q;
  logic and_2071_s16_q;
  logic or_2086_s16_q;
  logic or_2089_s16_q;
  logic or_2092_s16_q;
  logic and_2103_s16_q;
  logic and_2119_s16_q;
  logic and_2142_s16_q;
  logic equal_2283_s16_q;
  logic equal_2472_s16_q;
  logic and_2599_s16_q;
  logic and_2623_s16_q;
  logic equal_2684_s16_q;
  logic [5:0] difference_2688_s16_q;
  logic [7:0] sum_2690_s16_q;
  logic [11:0] select_2771_s16_q;
  logic and_2996_s16_q;
  logic less_3123_s16_q;
  logic equal_3466_s16_q;
  logic [4:0] select_3554_s16_q;
  logic select_3561_s16_q;
  logic select_3570_s16_q;
  logic and_3576_s16_q;
  logic [14:0] select_3585_s16_q;
  logic less_3876_s16_q;
  logic sum_3877_s16_q;
  logic select_3919_s16_q;
  logic equal_3930_s16_q;
  logic equal_3969_s16_q;
  logic and_4085_s16_q;
  logic equal_4095_s16_q;
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
      before_0_s16_q <= before_0_q;
      before_1_s16_q <= before_1_q;
      before_2_s16_q <= before_2_q;
      shift_not_right_s16_q <= shift_not_right_s15_q;
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
      select_508_s16_q <= select_508_s15_q;
      select_511_s16_q <= select_511_s15_q;
      select_515_s16_q <= select_515_s15_q;
      and_524_s16_q <= and_524_s15_q;
      and_525_s16_q <= and_525_s15_q;
      sum_532_s16_q <= sum_532;
      sum_536_s16_q <= sum_536;
      and_540_s16_q <= whole & (averager_memory_rdata_s15_q[28] | equal_530_s15_q);
      and_544_s16_q <= and_544;
      last_s16_q <= last_s15_q;
      and_548_s16_q <= and_548_s15_q;
      and_550_s16_q <= and_550_s15_q;
      equal_553_s16_q <= select_508_s15_q == 4'h3;
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
      equal_1790_s16_q <= equal_1790_s15_q;
      equal_1793_s16_q <= equal_1793_s15_q;
      or_1794_s16_q <= or_1794_s15_q;
      and_1803_s16_q <= and_1787_s15_q & equal_1802;
      select_1818_s16_q <= select_1818_s15_q;
      select_1824_s16_q <= select_1824_s15_q;
      select_1862_s16_q <= select_1862_s15_q;
      less_1878_s16_q <= less_1878_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1891_s16_q <= or_1891_s15_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[1:0];
      sum_1904_s16_q <= sum_1904;
      smooth_s16_q <= smooth;
      and_1951_s16_q <= not_1789_s15_q & (not_1791_s15_q & and_1949_s15_q);
      and_1960_s16_q <= and_1960_s15_q;
      and_1965_s16_q <= not_1789_s15_q & (not_1791_s15_q & and_1963_s15_q);
      less_1966_s16_q <= less_1966_s15_q;
      equal_1967_s16_q <= equal_1967_s15_q;
      not_1968_s16_q <= not_1968_s15_q;
      equal_1969_s16_q <= equal_1969_s15_q;
      patches_rows_rdata_s16_q <= patches_rows_rdata_s15_q;
      or_1988_s16_q <= or_1988;
      or_1991_s16_q <= select_1985[7] | (~({select_1985[6], select_1985[3:2]} == 3'h0));
      or_1994_s16_q <= select_1985[7] | (~(select_1985[6:4] == 3'h0));
      and_2003_s16_q <= so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & or_2000));
      textured_s16_q <= textured;
      and_2019_s16_q <= and_2019_s15_q;
      seen_columns_rdata_s16_q <= {seen_columns_rdata_s15_q[13:7], seen_columns_rdata_s15_q[5:0]};
      and_2069_s16_q <= seen_columns_rdata_s15_q[14] & inside_v_s15_q;
      and_2071_s16_q <= seen_columns_rdata_s15_q[5] & inside_v_s15_q;
      or_2086_s16_q <= or_2086;
      or_2089_s16_q <= select_2083[7] | (~({select_2083[6], select_2083[3:2]} == 3'h0));
      or_2092_s16_q <= select_2083[7] | (~(select_2083[6:4] == 3'h0));
      and_2103_s16_q <= seen_columns_rdata_s15_q[16] & inside_v_s15_q;
      and_2119_s16_q <= seen_columns_rdata_s15_q[17] & inside_v_s15_q;
      and_2142_s16_q <= and_2142_s15_q;
      equal_2283_s16_q <= equal_2283_s15_q;
      equal_2472_s16_q <= equal_2472_s15_q;
      and_2599_s16_q <= and_2599_s15_q;
      and_2623_s16_q <= seen_columns_rdata_s15_q[15] & inside_v_s15_q;
      equal_2684_s16_q <= equal_2684_s15_q;
      difference_2688_s16_q <= difference_2688[7:2];
      sum_2690_s16_q <= sum_2690_s15_q;
      select_2771_s16_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_2996_s16_q <= and_2996_s15_q;
      less_3123_s16_q <= less_3123_s15_q;
      equal_3466_s16_q <= patches_match_row_s15_q == 4'h0;
      select_3554_s16_q <= select_3554_s15_q;
      select_3561_s16_q <= select_3561;
      select_3570_s16_q <= select_3570;
      and_3576_s16_q <= equal_3550_s15_q & ({sum_3574[6], sum_3574} < 8'hfb);
      select_3585_s16_q <= select_3585_s15_q;
      less_3876_s16_q <= less_3876_s15_q;
      sum_3877_s16_q <= sum_3877[7];
      select_3919_s16_q <= sum_1998_s15_q ? (equal_1781_s15_q & or_2000) : or_2000;
      equal_3930_s16_q <= x_s15_q[6:3] == 4'h7;
      equal_3969_s16_q <= x_s15_q[6:3] == 4'h6;
      and_4085_s16_q <= seen_columns_rdata_s15_q[6] & inside_v_s15_q;
      equal_4095_s16_q <= equal_4095_s15_q;
    end
  end

  // Stage 16 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:215
  logic [8:0] grey;
  assign grey = and_524_s16_q ? sum_532_s16_q[13:5] : 9'h0;
  // hls/stages/census.hpp:216
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_553_s16_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:215
  logic [8:0] grey_2;
  assign grey_2 = and_524_s16_q ? sum_536_s16_q[13:5] : 9'h0;
  // hls/stages/census.hpp:216
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_553_s16_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:215
  logic and_561;
  assign and_561 = and_524_s16_q & and_540_s16_q;
  // hls/stages/census.hpp:131
  logic select_563;
  assign select_563 = equal_553_s16_q ? and_561 : (averager_mask_q & and_561);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s16_q & select_563;
  // hls/stages/census.hpp:215
  logic and_565;
  assign and_565 = and_524_s16_q & and_544_s16_q;
  // hls/stages/census.hpp:131
  logic select_567;
  assign select_567 = equal_553_s16_q ? and_565 : (averager_of_skin_q & and_565);
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
  // hls/stages/patches.hpp:211
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
  // hls/stages/patches.hpp:472
  logic [13:0] sum_1905;
  assign sum_1905 = {{3{patches_down_values_1_s16_q[10]}}, patches_down_values_1_s16_q} + {sum_1904_s16_q, down_2_s16_q[1]};
  logic [12:0] sum_1906;
  assign sum_1906 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1905[13:1];
  // hls/stages/patches.hpp:471
  logic [12:0] sum_1924;
  assign sum_1924 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s16_q[11:1]};
  logic [12:0] sum_1925;
  assign sum_1925 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1926;
  assign difference_1926 = {1'b0, sum_1924, smooth_s16_q[0]} - {1'b0, sum_1925, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1995;
  assign select_1995 = equal_575_s16_q ? x_s16_q[5:0] : {region_row_q, or_1994_s16_q, or_1991_s16_q, or_1988_s16_q};
  // hls/stages/agreement.hpp:1128
  logic not_1996;
  assign not_1996 = ~equal_1608_s16_q;
  // hls/stages/agreement.hpp:149
  logic and_2021;
  assign and_2021 = or_580_s16_q & (not_584_s16_q & and_2019_s16_q);
  // hls/stages/agreement.hpp:1014
  logic select_2031;
  assign select_2031 = slot_s16_q[2] ? shown_shown_q : and_637;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s16_q & (shown_right_rdata_s16_q[0] | select_2031);
  // hls/stages/agreement.hpp:1014
  logic select_2034;
  assign select_2034 = slot_s16_q[2] ? shown_nearer_q : and_1586;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s16_q & (select_2031 ? select_2034 : shown_right_rdata_s16_q[1]);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2174;
  assign select_2174 = sample_pair_whole_s16_q ? (and_548_s16_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2176;
  assign select_2176 = sample_pair_whole_s16_q ? (and_548_s16_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2198;
  assign select_2198 = sample_pair_whole_s16_q ? (and_548_s16_q ? select_563 : averager_mask_q) : averager_mask_q;
  logic select_2200;
  assign select_2200 = sample_pair_whole_s16_q ? (and_548_s16_q ? select_567 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:788
  logic and_2603;
  assign and_2603 = not_576_s16_q & (so_s16_q & (ends_cell_s16_q & (inside_v_s16_q & and_2599_s16_q)));
  // hls/stages/agreement.hpp:1105
  logic not_2622;
  assign not_2622 = ~(x_s16_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:788
  logic and_2664;
  assign and_2664 = so_s16_q & (ends_cell_s16_q & (inside_v_s16_q & (and_2599_s16_q & and_2021)));
  // hls/stages/agreement.hpp:1110
  logic and_2669;
  assign and_2669 = not_2622 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:247
  logic and_2693;
  assign and_2693 = ((and_2019_s16_q & and_635_s16_q) & equal_2684_s16_q) & (~({2'h0, difference_2688_s16_q} < sum_2690_s16_q));
  // hls/stages/agreement.hpp:149
  logic and_2703;
  assign and_2703 = not_584_s16_q & (slot_s16_q[2] & left_turns_rdata_s16_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2705;
  assign and_2705 = not_584_s16_q & (slot_s16_q[2] & left_turns_rdata_s16_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2706;
  assign select_2706 = or_580_s16_q ? {and_2705, and_2703} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2708;
  assign select_2708 = less_583_s16_q ? 2'h0 : (slot_s16_q[2] ? right_turns_rdata_s16_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2709;
  assign select_2709 = or_580_s16_q ? select_2708 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2754;
  assign equal_2754 = slot_s16_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2771_s16_q[11:7])) ? 12'h7f : select_2771_s16_q;
  // hls/stages/agreement.hpp:788
  logic select_2815;
  assign select_2815 = so_s16_q ? (equal_2754 ? right_2_s16_q : registration_of_right_q) : registration_of_right_q;
  logic select_2818;
  assign select_2818 = so_s16_q ? (equal_1704_s16_q ? inside_v_s16_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all_s16_q ? x_s16_q[1:0] : select_1611;
  // hls/stages/patches.hpp:185
  logic [11:0] select_3089;
  assign select_3089 = equal_1790_s16_q ? patches_smooth_values_0_q : (or_1794_s16_q ? smooth_s16_q : patches_smooth_values_0_q);
  logic [11:0] select_3091;
  assign select_3091 = or_1794_s16_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3093;
  assign select_3093 = equal_1788_s16_q ? patches_smooth_values_1_q : (equal_1790_s16_q ? patches_smooth_values_1_q : select_3091);
  logic [11:0] select_3094;
  assign select_3094 = or_1794_s16_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3096;
  assign select_3096 = equal_1788_s16_q ? patches_smooth_values_2_q : (equal_1790_s16_q ? patches_smooth_values_2_q : select_3094);
  logic [11:0] select_3097;
  assign select_3097 = or_1794_s16_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3099;
  assign select_3099 = equal_1788_s16_q ? patches_smooth_values_3_q : (equal_1790_s16_q ? patches_smooth_values_3_q : select_3097);
  logic [10:0] select_3106;
  assign select_3106 = or_1794_s16_q ? patches_down_values_1_s16_q : patches_down_values_2_q;
  logic [10:0] select_3108;
  assign select_3108 = equal_1788_s16_q ? patches_down_values_2_q : (equal_1790_s16_q ? patches_down_values_2_q : select_3106);
  logic [10:0] select_3109;
  assign select_3109 = or_1794_s16_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3111;
  assign select_3111 = equal_1788_s16_q ? patches_down_values_3_q : (equal_1790_s16_q ? patches_down_values_3_q : select_3109);
  // hls/stages/patches.hpp:561
  logic select_3563;
  assign select_3563 = less_1966_s16_q ? (not_1968_s16_q & select_3561_s16_q) : select_3561_s16_q;
  logic select_3572;
  assign select_3572 = less_1966_s16_q ? (not_1968_s16_q & select_3570_s16_q) : select_3570_s16_q;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3578;
  assign select_3578 = less_1966_s16_q ? (and_3576_s16_q ? patches_rows_rdata_s16_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3589;
  assign select_3589 = patches_read_above_q ? patches_read_row_differing_s16_q : patches_peak_above_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3591;
  assign select_3591 = patches_read_below_q ? patches_read_row_differing_s16_q : patches_peak_below_q;
  // hls/stages/patches.hpp:580
  logic less_3628;
  assign less_3628 = select_3589 < select_3591;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3628 ? select_3591 : select_3589;
  logic [9:0] low;
  assign low = (select_3591 < select_3589) ? select_3591 : select_3589;
  // hls/stages/agreement.hpp:788
  logic select_3873;
  assign select_3873 = equal_575_s16_q ? shown_shown_q : (so_s16_q ? select_2031 : shown_shown_q);
  logic select_3875;
  assign select_3875 = equal_575_s16_q ? shown_nearer_q : (so_s16_q ? select_2034 : shown_nearer_q);
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3879;
  assign select_3879 = less_3876_s16_q ? (sum_3877_s16_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3881;
  assign select_3881 = equal_2472_s16_q ? (equal_680_s16_q ? 3'h0 : select_3879) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3877_s16_q;
  // hls/stages/agreement.hpp:460
  logic select_3912;
  assign select_3912 = equal_2472_s16_q ? (equal_680_s16_q | (less_3876_s16_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3917;
  assign or_3917 = segment_starts_q | not_578_s16_q;
  // hls/stages/agreement.hpp:788
  logic select_3921;
  assign select_3921 = ends_cell_s16_q ? (inside_v_s16_q ? select_3919_s16_q : or_3917) : or_3917;
  // hls/stages/agreement.hpp:1217
  logic equal_3950;
  assign equal_3950 = x_s16_q[6:3] == 4'ha;
  logic equal_3954;
  assign equal_3954 = x_s16_q[6:3] == 4'h9;
  logic equal_3955;
  assign equal_3955 = x_s16_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3971;
  assign select_3971 = equal_3930_s16_q ? cfg_unproven_limit_i : (equal_3969_s16_q ? cfg_explained_limit_i : cfg_regions_limit_i);
  logic [7:0] select_3973;
  assign select_3973 = equal_3954 ? cfg_hidden_limit_i : (equal_3955 ? cfg_unproven_skin_limit_i : select_3971);
  // hls/stages/agreement.hpp:788
  logic select_4083;
  assign select_4083 = so_s16_q ? (ends_cell_s16_q ? and_2071_s16_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4087;
  assign select_4087 = so_s16_q ? (ends_cell_s16_q ? and_4085_s16_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4089;
  assign select_4089 = ends_cell_s16_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4091;
  assign select_4091 = equal_575_s16_q ? centres_values_1_textured_q : (so_s16_q ? select_4089 : centres_values_1_textured_q);
  logic select_4092;
  assign select_4092 = ends_cell_s16_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4094;
  assign select_4094 = equal_575_s16_q ? centres_values_1_of_skin_q : (so_s16_q ? select_4092 : centres_values_1_of_skin_q);

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:768; read in stage 16, written in stage 18: 16 < 18 < 16 + DISTANCE.
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

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1398; read in stage 16, written in stage 19: 16 < 19 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1995;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s16_en & (equal_575_s16_q ? (x_s16_q[6] & not_1996) : and_2003_s16_q);
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_515_s16_q;
  logic averager_memory_we;
  assign averager_memory_we = s16_en & and_525_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_544_s16_q, and_540_s16_q, sum_536_s16_q, sum_532_s16_q};
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
    end else if (s16_en) begin
      averager_mask_q <= select_2198;
      averager_of_skin_q <= select_2200;
      registration_of_right_q <= equal_575_s16_q ? registration_of_right_q : select_2815;
      registration_was_inside_q <= equal_575_s16_q ? registration_was_inside_q : select_2818;
      patches_smooth_values_0_q <= equal_1788_s16_q ? patches_smooth_values_0_q : select_3089;
      patches_smooth_values_1_q <= select_3093;
      patches_smooth_values_2_q <= select_3096;
      patches_smooth_values_3_q <= select_3099;
      patches_down_values_2_q <= select_3108;
      patches_down_values_3_q <= select_3111;
      patches_read_above_q <= equal_1788_s16_q ? select_3563 : patches_read_above_q;
      patches_read_below_q <= equal_1788_s16_q ? select_3572 : patches_read_below_q;
      patches_peak_above_q <= equal_1788_s16_q ? select_3589 : patches_peak_above_q;
      patches_peak_below_q <= equal_1788_s16_q ? select_3591 : patches_peak_below_q;
      shown_shown_q <= select_3873;
      shown_nearer_q <= select_3875;
      region_row_q <= and_550_s16_q ? select_3881 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_550_s16_q ? select_3912 : region_fresh_q;
      segment_starts_q <= equal_575_s16_q ? or_3917 : (so_s16_q ? select_3921 : or_3917);
      centres_values_0_textured_q <= equal_575_s16_q ? centres_values_0_textured_q : select_4083;
      centres_values_0_of_skin_q <= equal_575_s16_q ? centres_values_0_of_skin_q : select_4087;
      centres_values_1_textured_q <= select_4091;
      centres_values_1_of_skin_q <= select_4094;
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
      averager_total_0_q <= select_2174;
      averager_total_1_q <= select_2176;
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
  logic [10:0] patches_down_values_3_s17_q;
  logic [4:0] patches_along_s17_q;
  logic patches_summed_last_s17_q;
  logic [4:0] patches_summed_down_by_s17_q;
  logic patches_read_first_s17_q;
  logic [2:0] region_row_s17_q;
  logic region_fresh_s17_q;
  logic centres_values_1_textured_s17_q;
  logic centres_values_1_of_skin_s17_q;
  logic [3:0] select_508_s17_q;
  logic [6:0] select_511_s17_q;
  logic [6:0] last_s17_q;
  logic and_548_s17_q;
  logic and_550_s17_q;
  logic [77:0] census_memory_rdata_s17_q;
  logic [8:0] grey_s17_q;
  logic equal_553_s17_q;
  logic [8:0] select_556_s17_q;
  logic [8:0] grey_2_s17_q;
  logic [8:0] select_560_s17_q;
  logic whole_2_s17_q;
  logic and_568_s17_q;
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
  logic [3:0] select_1862_s17_q;
  logic less_1878_s17_q;
  logic new_row_s17_q;
  logic or_1891_s17_q;
  logic [27:0] patches_right_codes_rdata_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic down_2_s17_q;
  logic sum_1905_s17_q;
  logic [12:0] sum_1906_s17_q;
  logic [14:0] difference_1926_s17_q;
  logic and_1951_s17_q;
  logic [47:0] patches_left_codes_rdata_s17_q;
  logic and_1960_s17_q;
  logic and_1965_s17_q;
  logic less_1966_s17_q;
  logic equal_1967_s17_q;
  logic not_1968_s17_q;
  logic equal_1969_s17_q;
  logic or_1988_s17_q;
  logic or_1991_s17_q;
  logic or_1994_s17_q;
  logic not_1996_s17_q;
  logic textured_s17_q;
  logic and_2021_s17_q;
  logic and_2028_s17_q;
  logic [12:0] seen_columns_rdata_s17_q;
  logic shown_s17_q;
  logic near_s17_q;
  logic and_2069_s17_q;
  logic and_2071_s17_q;
  logic or_2086_s17_q;
  logic or_2089_s17_q;
  logic or_2092_s17_q;
  logic and_2103_s17_q;
  logic and_2105_s17_q;
  logic and_2106_s17_q;
  logic and_2119_s17_q;
  logic and_2121_s17_q;
  logic and_2122_s17_q;
  logic and_2142_s17_q;
  logic equal_2283_s17_q;
  logic equal_2472_s17_q;
  logic and_2603_s17_q;
  logic not_2622_s17_q;
  logic and_2623_s17_q;
  logic and_2625_s17_q;
  logic and_2626_s17_q;
  logic and_2665_s17_q;
  logic and_2672_s17_q;
  logic and_2696_s17_q;
  logic select_2706_s17_q;
  logic select_2709_s17_q;
  logic and_2710_s17_q;
  logic and_2757_s17_q;
  logic and_2758_s17_q;
  logic [11:0] residual_s17_q;
  logic equal_2820_s17_q;
  logic [3:0] not_2821_s17_q;
  logic [1:0] quarter_2_s17_q;
  logic and_2996_s17_q;
  logic less_3123_s17_q;
  logic equal_3466_s17_q;
  logic [4:0] select_3554_s17_q;
  logic [9:0] select_3578_s17_q;
  logic [14:0] select_3585_s17_q;
  logic less_3628_s17_q;
  logic [9:0] high_s17_q;
  logic [9:0] low_s17_q;
  logic equal_3930_s17_q;
  logic equal_3950_s17_q;
  logic equal_3953_s17_q;
  logic equal_3954_s17_q;
  logic equal_3955_s17_q;
  logic [7:0] select_3974_s17_q;
  logic equal_4095_s17_q;
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
      patches_down_values_3_s17_q <= patches_down_values_3_q;
      patches_along_s17_q <= patches_along_s16_q;
      patches_summed_last_s17_q <= patches_summed_last_s16_q;
      patches_summed_down_by_s17_q <= patches_summed_down_by_s16_q;
      patches_read_first_s17_q <= patches_read_first_s16_q;
      region_row_s17_q <= region_row_q;
      region_fresh_s17_q <= region_fresh_q;
      centres_values_1_textured_s17_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s17_q <= centres_values_1_of_skin_q;
      select_508_s17_q <= select_508_s16_q;
      select_511_s17_q <= select_511_s16_q;
      last_s17_q <= last_s16_q;
      and_548_s17_q <= and_548_s16_q;
      and_550_s17_q <= and_550_s16_q;
      census_memory_rdata_s17_q <= census_memory_rdata_q;
      grey_s17_q <= grey;
      equal_553_s17_q <= equal_553_s16_q;
      select_556_s17_q <= sample_pair_whole_s16_q ? total[10:2] : 9'h0;
      grey_2_s17_q <= grey_2;
      select_560_s17_q <= sample_pair_whole_s16_q ? total_2[10:2] : 9'h0;
      whole_2_s17_q <= whole_2;
      and_568_s17_q <= sample_pair_whole_s16_q & select_567;
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
      select_1862_s17_q <= select_1862_s16_q;
      less_1878_s17_q <= less_1878_s16_q;
      new_row_s17_q <= new_row_s16_q;
      or_1891_s17_q <= or_1891_s16_q;
      patches_right_codes_rdata_s17_q <= patches_right_codes_rdata_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      down_2_s17_q <= down_2_s16_q[0];
      sum_1905_s17_q <= sum_1905[0];
      sum_1906_s17_q <= sum_1906;
      difference_1926_s17_q <= difference_1926;
      and_1951_s17_q <= and_1951_s16_q;
      patches_left_codes_rdata_s17_q <= patches_left_codes_rdata_q;
      and_1960_s17_q <= and_1960_s16_q;
      and_1965_s17_q <= and_1965_s16_q;
      less_1966_s17_q <= less_1966_s16_q;
      equal_1967_s17_q <= equal_1967_s16_q;
      not_1968_s17_q <= not_1968_s16_q;
      equal_1969_s17_q <= equal_1969_s16_q;
      or_1988_s17_q <= or_1988_s16_q;
      or_1991_s17_q <= or_1991_s16_q;
      or_1994_s17_q <= or_1994_s16_q;
      not_1996_s17_q <= not_1996;
      textured_s17_q <= textured_s16_q;
      and_2021_s17_q <= and_2021;
      and_2028_s17_q <= not_576_s16_q & and_2003_s16_q;
      seen_columns_rdata_s17_q <= seen_columns_rdata_s16_q;
      shown_s17_q <= shown;
      near_s17_q <= near;
      and_2069_s17_q <= and_2069_s16_q;
      and_2071_s17_q <= and_2071_s16_q;
      or_2086_s17_q <= or_2086_s16_q;
      or_2089_s17_q <= or_2089_s16_q;
      or_2092_s17_q <= or_2092_s16_q;
      and_2103_s17_q <= and_2103_s16_q;
      and_2105_s17_q <= seen_columns_rdata_s16_q[7] & inside_v_s16_q;
      and_2106_s17_q <= seen_columns_rdata_s16_q[3] & inside_v_s16_q;
      and_2119_s17_q <= and_2119_s16_q;
      and_2121_s17_q <= seen_columns_rdata_s16_q[8] & inside_v_s16_q;
      and_2122_s17_q <= seen_columns_rdata_s16_q[4] & inside_v_s16_q;
      and_2142_s17_q <= and_2142_s16_q;
      equal_2283_s17_q <= equal_2283_s16_q;
      equal_2472_s17_q <= equal_2472_s16_q;
      and_2603_s17_q <= and_2603;
      not_2622_s17_q <= not_2622;
      and_2623_s17_q <= and_2623_s16_q;
      and_2625_s17_q <= seen_columns_rdata_s16_q[6] & inside_v_s16_q;
      and_2626_s17_q <= seen_columns_rdata_s16_q[2] & inside_v_s16_q;
      and_2665_s17_q <= not_576_s16_q & and_2664;
      and_2672_s17_q <= not_576_s16_q & (so_s16_q & (ends_cell_s16_q & and_2669));
      and_2696_s17_q <= inside_v_s16_q & (or_580_s16_q & (not_584_s16_q & and_2693));
      select_2706_s17_q <= select_2706[1];
      select_2709_s17_q <= select_2709[1];
      and_2710_s17_q <= select_2706[0] & select_2709[0];
      and_2757_s17_q <= not_576_s16_q & (so_s16_q & (half_ends & equal_2754));
      and_2758_s17_q <= and_637 & less_1703_s16_q;
      residual_s17_q <= residual;
      equal_2820_s17_q <= sum_1614 == 2'h2;
      not_2821_s17_q <= ~select_1661;
      quarter_2_s17_q <= quarter_2;
      and_2996_s17_q <= and_2996_s16_q;
      less_3123_s17_q <= less_3123_s16_q;
      equal_3466_s17_q <= equal_3466_s16_q;
      select_3554_s17_q <= select_3554_s16_q;
      select_3578_s17_q <= select_3578;
      select_3585_s17_q <= select_3585_s16_q;
      less_3628_s17_q <= less_3628;
      high_s17_q <= high;
      low_s17_q <= low;
      equal_3930_s17_q <= equal_3930_s16_q;
      equal_3950_s17_q <= equal_3950;
      equal_3953_s17_q <= x_s16_q[6:3] == 4'hb;
      equal_3954_s17_q <= equal_3954;
      equal_3955_s17_q <= equal_3955;
      select_3974_s17_q <= equal_3950 ? cfg_regions_limit_i : select_3973;
      equal_4095_s17_q <= equal_4095_s16_q;
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
  // hls/stages/census.hpp:305
  logic less_653;
  assign less_653 = census_memory_rdata_s17_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_memory_rdata_s17_q[48:40] < census_columns_values_1_cell_2_left_q;
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
  assign less_665 = census_memory_rdata_s17_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_memory_rdata_s17_q[57:49] < census_columns_values_1_cell_2_right_q;
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
  assign equal_677 = last_s17_q == 7'h0;
  logic [3:0] select_681;
  assign select_681 = equal_680_s17_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_682;
  assign select_682 = equal_677 ? {select_681, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:287
  logic [3:0] select_683;
  assign select_683 = equal_677 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:297
  logic and_686;
  assign and_686 = census_memory_rdata_s17_q[38] & (census_memory_rdata_s17_q[18] & whole_2_s17_q);
  logic and_688;
  assign and_688 = census_memory_rdata_s17_q[77] & (census_memory_rdata_s17_q[58] & and_686);
  // hls/stages/census.hpp:281
  logic [9:0] difference_711;
  assign difference_711 = {1'b0, select_556_s17_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_714;
  assign difference_714 = {1'b0, census_memory_rdata_s17_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_718;
  assign difference_718 = {1'b0, census_memory_rdata_s17_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_722;
  assign difference_722 = {1'b0, census_memory_rdata_s17_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_726;
  assign difference_726 = {1'b0, census_memory_rdata_s17_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:317
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:318
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
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
  // hls/stages/patches.hpp:472
  logic [14:0] sum_1907;
  assign sum_1907 = {{4{patches_down_values_3_s17_q[10]}}, patches_down_values_3_s17_q} + {sum_1906_s17_q, sum_1905_s17_q, down_2_s17_q};
  // hls/stages/patches.hpp:451
  logic and_1930;
  assign and_1930 = difference_1926_s17_q[8] & (~(difference_1926_s17_q[7:0] == 8'h0));
  // hls/stages/patches.hpp:454
  logic and_1934;
  assign and_1934 = (~difference_1926_s17_q[14]) & (and_1930 | (~(difference_1926_s17_q[13:9] == 5'h0)));
  // hls/stages/patches.hpp:450
  logic and_1937;
  assign and_1937 = difference_1926_s17_q[14] & (~(difference_1926_s17_q[13:8] == 6'h3f));
  // hls/stages/agreement.hpp:262
  logic explained;
  assign explained = inside_v_s17_q & and_637_s17_q;
  logic and_2030;
  assign and_2030 = inside_v_s17_q & and_2021_s17_q;
  // hls/stages/agreement.hpp:1030
  logic and_2072;
  assign and_2072 = seen_columns_rdata_s17_q[0] & inside_v_s17_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2074;
  assign sum_2074 = {1'b0, and_2071_s17_q} + ({1'b0, textured_s17_q} + {1'b0, and_2072});
  // hls/stages/agreement.hpp:1030
  logic and_2104;
  assign and_2104 = seen_columns_rdata_s17_q[11] & inside_v_s17_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2108;
  assign sum_2108 = {1'b0, and_2105_s17_q} + ({1'b0, shown_s17_q} + {1'b0, and_2106_s17_q});
  // hls/stages/agreement.hpp:1030
  logic and_2120;
  assign and_2120 = seen_columns_rdata_s17_q[12] & inside_v_s17_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2124;
  assign sum_2124 = {1'b0, and_2121_s17_q} + ({1'b0, near_s17_q} + {1'b0, and_2122_s17_q});
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2166;
  assign select_2166 = sample_pair_whole_s17_q ? (and_548_s17_q ? grey_s17_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2168;
  assign select_2168 = sample_pair_whole_s17_q ? (and_548_s17_q ? grey_2_s17_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2170;
  assign select_2170 = sample_pair_whole_s17_q ? (and_548_s17_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2172;
  assign select_2172 = sample_pair_whole_s17_q ? (and_548_s17_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2177;
  assign sum_2177 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s17_q};
  logic [9:0] sum_2185;
  assign sum_2185 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s17_q};
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2201;
  assign select_2201 = and_550_s17_q ? select_556_s17_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_550_s17_q ? select_560_s17_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2204;
  assign select_2204 = and_550_s17_q ? census_memory_rdata_s17_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2205;
  assign select_2205 = and_550_s17_q ? census_memory_rdata_s17_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2206;
  assign select_2206 = and_550_s17_q ? census_memory_rdata_s17_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2207;
  assign select_2207 = and_550_s17_q ? census_memory_rdata_s17_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2208;
  assign select_2208 = and_550_s17_q ? census_memory_rdata_s17_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2209;
  assign select_2209 = and_550_s17_q ? census_memory_rdata_s17_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2210;
  assign select_2210 = and_550_s17_q ? census_memory_rdata_s17_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2211;
  assign select_2211 = and_550_s17_q ? census_memory_rdata_s17_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_550_s17_q ? census_memory_rdata_s17_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2213;
  assign select_2213 = and_550_s17_q ? census_memory_rdata_s17_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_550_s17_q ? census_memory_rdata_s17_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_550_s17_q ? census_memory_rdata_s17_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2216;
  assign select_2216 = and_550_s17_q ? census_memory_rdata_s17_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2217;
  assign select_2217 = and_550_s17_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_550_s17_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2220;
  assign select_2220 = and_550_s17_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2221;
  assign select_2221 = and_550_s17_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2223;
  assign select_2223 = and_550_s17_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2224;
  assign select_2224 = and_550_s17_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2226;
  assign select_2226 = and_550_s17_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2227;
  assign select_2227 = and_550_s17_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_550_s17_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2230;
  assign select_2230 = and_550_s17_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_550_s17_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2233;
  assign select_2233 = and_550_s17_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_550_s17_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2236;
  assign select_2236 = and_550_s17_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2237;
  assign select_2237 = and_550_s17_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2239;
  assign select_2239 = and_550_s17_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2240;
  assign select_2240 = and_550_s17_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2242;
  assign select_2242 = and_550_s17_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2243;
  assign select_2243 = and_550_s17_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2245;
  assign select_2245 = and_550_s17_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2246;
  assign select_2246 = and_550_s17_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2249;
  assign select_2249 = and_550_s17_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2250;
  assign select_2250 = and_550_s17_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2253;
  assign select_2253 = and_550_s17_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2254;
  assign select_2254 = and_550_s17_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:283
  logic [9:0] difference_2258;
  assign difference_2258 = {1'b0, select_560_s17_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2261;
  assign difference_2261 = {1'b0, census_memory_rdata_s17_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2265;
  assign difference_2265 = {1'b0, census_memory_rdata_s17_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2269;
  assign difference_2269 = {1'b0, census_memory_rdata_s17_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2273;
  assign difference_2273 = {1'b0, census_memory_rdata_s17_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/agreement.hpp:1142
  logic equal_2298;
  assign equal_2298 = x_s17_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:788
  logic select_2304;
  assign select_2304 = equal_575_s17_q ? (moments_has_before_q | equal_2298) : moments_has_before_q;
  // hls/stages/census.hpp:368
  logic [9:0] difference_2369;
  assign difference_2369 = {1'b0, select_556_s17_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2381;
  assign difference_2381 = {1'b0, select_560_s17_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:520
  logic and_2597;
  assign and_2597 = and_550_s17_q & (equal_680_s17_q & equal_2472_s17_q);
  // hls/stages/agreement.hpp:788
  logic and_2608;
  assign and_2608 = not_576_s17_q & (so_s17_q & (ends_cell_s17_q & textured_s17_q));
  // hls/stages/agreement.hpp:1030
  logic and_2624;
  assign and_2624 = seen_columns_rdata_s17_q[10] & inside_v_s17_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2628;
  assign sum_2628 = {1'b0, and_2625_s17_q} + ({1'b0, explained} + {1'b0, and_2626_s17_q});
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2667;
  assign select_2667 = and_2597 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2665_s17_q});
  logic [13:0] select_2674;
  assign select_2674 = and_2597 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2672_s17_q});
  // hls/stages/agreement.hpp:1027
  logic and_2711;
  assign and_2711 = and_637_s17_q & and_2710_s17_q;
  // hls/stages/agreement.hpp:788
  logic and_2714;
  assign and_2714 = ends_cell_s17_q & (inside_v_s17_q & (select_2706_s17_q & and_2711));
  logic and_2721;
  assign and_2721 = ends_cell_s17_q & (inside_v_s17_q & (select_2709_s17_q & and_2711));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2792;
  assign difference_2792 = 13'h0 - {residual_s17_q[11], residual_s17_q};
  logic less_2807;
  assign less_2807 = $signed(difference_2792) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2823;
  assign select_2823 = equal_2820_s17_q ? (registration_fresh_q & not_2821_s17_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2825;
  assign select_2825 = so_s17_q ? (and_1656_s17_q ? select_2823 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2827;
  assign select_2827 = and_2597 ? 4'hf : (equal_575_s17_q ? registration_fresh_q : select_2825);
  // hls/stages/registration.hpp:258
  logic not_2848;
  assign not_2848 = ~quarter_2_s17_q[1];
  logic [3:0] select_2849;
  assign select_2849 = quarter_2_s17_q[0] ? {quarter_2_s17_q[1], 1'b0, not_2848, 1'b0} : {1'b0, quarter_2_s17_q[1], 1'b0, not_2848};
  // hls/stages/patches.hpp:506
  logic [27:0] word;
  assign word = or_1891_s17_q ? patches_right_codes_rdata_s17_q : 28'h0;
  // hls/stages/patches.hpp:523
  logic [47:0] select_3156;
  assign select_3156 = new_row_s17_q ? patches_left_codes_rdata_s17_q : patches_left_row_q;
  // hls/stages/patches.hpp:185
  logic [47:0] select_3158;
  assign select_3158 = equal_1788_s17_q ? patches_left_row_q : (equal_1790_s17_q ? select_3156 : patches_left_row_q);
  logic [4:0] select_3503;
  assign select_3503 = equal_1790_s17_q ? patches_along_s17_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:558
  logic [9:0] select_3580;
  assign select_3580 = less_1966_s17_q ? (equal_1969_s17_q ? 10'h3ff : select_3578_s17_q) : 10'h3ff;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3581;
  assign select_3581 = equal_1969_s17_q ? select_3580 : select_3578_s17_q;
  logic [9:0] select_3583;
  assign select_3583 = less_1966_s17_q ? (equal_1967_s17_q ? 10'h3ff : select_3581) : select_3581;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high_s17_q - low_s17_q;
  logic [9:0] fall_2;
  assign fall_2 = high_s17_q - select_3585_s17_q[9:0];
  // hls/stages/agreement.hpp:1223
  logic equal_3706;
  assign equal_3706 = x_s17_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1217
  logic equal_3952;
  assign equal_3952 = x_s17_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3975;
  assign select_3975 = equal_3953_s17_q ? {cfg_on_skin_limit_i, 3'h0} : select_3974_s17_q;
  logic [7:0] limit;
  assign limit = equal_3952 ? cfg_regions_limit_i : select_3975;
  // hls/stages/agreement.hpp:1231
  logic not_3977;
  assign not_3977 = ~x_s17_q[2];
  logic [3:0] select_3978;
  assign select_3978 = x_s17_q[1] ? {x_s17_q[2], 1'b0, not_3977, 1'b0} : {1'b0, x_s17_q[2], 1'b0, not_3977};
  logic [7:0] select_3979;
  assign select_3979 = x_s17_q[0] ? {select_3978[3], 1'b0, select_3978[2], 1'b0, select_3978[1], 1'b0, select_3978[0], 1'b0} : {1'b0, select_3978[3], 1'b0, select_3978[2], 1'b0, select_3978[1], 1'b0, select_3978[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3983;
  assign select_3983 = equal_3954_s17_q ? counts_skin_supervised_q : (equal_3955_s17_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3985;
  assign select_3985 = equal_3953_s17_q ? counts_skin_textured_q : (equal_3950_s17_q ? counts_textured_q : select_3983);
  logic [13:0] of;
  assign of = equal_3952 ? counts_textured_q : select_3985;
  // hls/stages/registration.hpp:258
  logic not_4188;
  assign not_4188 = ~quarter_s17_q[1];
  logic [3:0] select_4189;
  assign select_4189 = quarter_s17_q[0] ? {quarter_s17_q[1], 1'b0, not_4188, 1'b0} : {1'b0, quarter_s17_q[1], 1'b0, not_4188};

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

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = last_s17_q;
  logic census_memory_we;
  assign census_memory_we = s17_en & and_550_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s17_q[58:40], census_memory_rdata_s17_q[38:0], and_568_s17_q, whole_2_s17_q, select_560_s17_q, select_556_s17_q};
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
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s17_q, near_s17_q, shown_s17_q, explained, and_2030, textured_s17_q};
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
    end else if (s17_en) begin
      census_filled_q <= and_550_s17_q ? {select_683[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2304;
      rows_passed_above_q <= and_550_s17_q ? select_682 : rows_passed_above_q;
      counts_textured_q <= and_2597 ? 14'h0 : (counts_textured_q + {13'h0, and_2608});
      counts_skin_supervised_q <= select_2667;
      counts_skin_textured_q <= select_2674;
      registration_fresh_q <= select_2827;
      patches_left_row_q <= select_3158;
      patches_summed_row_column_q <= equal_1788_s17_q ? patches_summed_row_column_q : select_3503;
      patches_read_far_q <= equal_1788_s17_q ? select_3583 : patches_read_far_q;
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
    if (s17_en) begin
      averager_quarter_1_0_q <= select_2166;
      averager_quarter_1_1_q <= select_2168;
      averager_quarter_2_0_q <= select_2170;
      averager_quarter_2_1_q <= select_2172;
      census_columns_values_0_cell_0_left_q <= select_2201;
      census_columns_values_0_cell_0_right_q <= select_2202;
      census_columns_values_0_cell_1_left_q <= select_2204;
      census_columns_values_0_cell_1_right_q <= select_2205;
      census_columns_values_0_cell_1_mask_q <= select_2206;
      census_columns_values_0_cell_2_left_q <= select_2207;
      census_columns_values_0_cell_2_right_q <= select_2208;
      census_columns_values_0_cell_2_mask_q <= select_2209;
      census_columns_values_0_cell_2_of_skin_q <= select_2210;
      census_columns_values_0_cell_3_left_q <= select_2211;
      census_columns_values_0_cell_3_right_q <= select_2212;
      census_columns_values_0_cell_3_mask_q <= select_2213;
      census_columns_values_0_cell_4_left_q <= select_2214;
      census_columns_values_0_cell_4_right_q <= select_2215;
      census_columns_values_0_cell_4_mask_q <= select_2216;
      census_columns_values_1_cell_0_left_q <= select_2217;
      census_columns_values_1_cell_0_right_q <= select_2218;
      census_columns_values_1_cell_1_left_q <= select_2220;
      census_columns_values_1_cell_1_right_q <= select_2221;
      census_columns_values_1_cell_2_left_q <= select_2223;
      census_columns_values_1_cell_2_right_q <= select_2224;
      census_columns_values_1_cell_2_of_skin_q <= select_2226;
      census_columns_values_1_cell_3_left_q <= select_2227;
      census_columns_values_1_cell_3_right_q <= select_2228;
      census_columns_values_1_cell_4_left_q <= select_2230;
      census_columns_values_1_cell_4_right_q <= select_2231;
      census_columns_values_2_cell_0_left_q <= select_2233;
      census_columns_values_2_cell_0_right_q <= select_2234;
      census_columns_values_2_cell_1_left_q <= select_2236;
      census_columns_values_2_cell_1_right_q <= select_2237;
      census_columns_values_2_cell_2_left_q <= select_2239;
      census_columns_values_2_cell_2_right_q <= select_2240;
      census_columns_values_2_cell_3_left_q <= select_2242;
      census_columns_values_2_cell_3_right_q <= select_2243;
      census_columns_values_2_cell_4_left_q <= select_2245;
      census_columns_values_2_cell_4_right_q <= select_2246;
      census_columns_values_3_cell_1_left_q <= select_2249;
      census_columns_values_3_cell_1_right_q <= select_2250;
      census_columns_values_3_cell_3_left_q <= select_2253;
      census_columns_values_3_cell_3_right_q <= select_2254;
      sharpness_last_mean_0_q <= and_550_s17_q ? select_556_s17_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_550_s17_q ? select_560_s17_q : sharpness_last_mean_1_q;
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
  logic census_columns_values_0_cell_1_mask_s18_q;
  logic census_columns_values_0_cell_2_mask_s18_q;
  logic census_columns_values_0_cell_3_mask_s18_q;
  logic census_columns_values_0_cell_4_mask_s18_q;
  logic census_columns_values_1_cell_2_of_skin_s18_q;
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
  logic [4:0] patches_summed_row_column_s18_q;
  logic patches_summed_last_s18_q;
  logic [4:0] patches_summed_down_by_s18_q;
  logic patches_read_first_s18_q;
  logic [9:0] patches_read_far_s18_q;
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
  logic equal_553_s18_q;
  logic whole_2_s18_q;
  logic equal_570_s18_q;
  logic equal_575_s18_q;
  logic not_576_s18_q;
  logic so_s18_q;
  logic not_578_s18_q;
  logic equal_579_s18_q;
  logic inside_v_s18_q;
  logic [6:0] x_s18_2_q;
  logic [6:0] right_s18_q;
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
  logic and_688_s18_q;
  logic difference_711_s18_q;
  logic [8:0] xor_712_s18_q;
  logic difference_714_s18_q;
  logic [8:0] xor_715_s18_q;
  logic difference_718_s18_q;
  logic [8:0] xor_719_s18_q;
  logic difference_722_s18_q;
  logic [8:0] xor_723_s18_q;
  logic difference_726_s18_q;
  logic [8:0] xor_727_s18_q;
  logic [9:0] half_grey_levels_s18_q;
  logic [9:0] half_grey_levels_2_s18_q;
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
  logic [3:0] select_1862_s18_q;
  logic less_1878_s18_q;
  logic new_row_s18_q;
  logic [1:0] of_row_2_s18_q;
  logic not_1908_s18_q;
  logic and_1911_s18_q;
  logic not_1913_s18_q;
  logic and_1918_s18_q;
  logic and_1934_s18_q;
  logic and_1937_s18_q;
  logic and_1951_s18_q;
  logic and_1960_s18_q;
  logic and_1965_s18_q;
  logic less_1966_s18_q;
  logic equal_1967_s18_q;
  logic not_1968_s18_q;
  logic equal_1969_s18_q;
  logic or_1988_s18_q;
  logic or_1991_s18_q;
  logic or_1994_s18_q;
  logic not_1996_s18_q;
  logic [29:0] regions_rdata_s18_q;
  logic textured_s18_q;
  logic explained_s18_q;
  logic and_2023_s18_q;
  logic and_2028_s18_q;
  logic and_2069_s18_q;
  logic and_2070_s18_q;
  logic [1:0] sum_2074_s18_q;
  logic or_2086_s18_q;
  logic or_2089_s18_q;
  logic or_2092_s18_q;
  logic and_2103_s18_q;
  logic [2:0] sum_2109_s18_q;
  logic and_2119_s18_q;
  logic [2:0] sum_2125_s18_q;
  logic and_2142_s18_q;
  logic sum_2177_s18_q;
  logic [9:0] difference_2178_s18_q;
  logic sum_2185_s18_q;
  logic [9:0] difference_2186_s18_q;
  logic difference_2258_s18_q;
  logic [8:0] xor_2259_s18_q;
  logic difference_2261_s18_q;
  logic [8:0] xor_2262_s18_q;
  logic difference_2265_s18_q;
  logic [8:0] xor_2266_s18_q;
  logic difference_2269_s18_q;
  logic [8:0] xor_2270_s18_q;
  logic difference_2273_s18_q;
  logic [8:0] xor_2274_s18_q;
  logic equal_2283_s18_q;
  logic equal_2298_s18_q;
  logic difference_2369_s18_q;
  logic [8:0] xor_2370_s18_q;
  logic difference_2381_s18_q;
  logic [8:0] xor_2382_s18_q;
  logic equal_2472_s18_q;
  logic and_2597_s18_q;
  logic and_2603_s18_q;
  logic and_2608_s18_q;
  logic not_2622_s18_q;
  logic and_2623_s18_q;
  logic [2:0] sum_2629_s18_q;
  logic and_2699_s18_q;
  logic and_2716_s18_q;
  logic and_2723_s18_q;
  logic and_2757_s18_q;
  logic and_2758_s18_q;
  logic [7:0] residual_s18_q;
  logic less_2793_s18_q;
  logic less_2807_s18_q;
  logic equal_2851_s18_q;
  logic and_2996_s18_q;
  logic [27:0] word_s18_q;
  logic equal_3117_s18_q;
  logic less_3123_s18_q;
  logic [47:0] select_3156_s18_q;
  logic equal_3466_s18_q;
  logic [4:0] select_3554_s18_q;
  logic [14:0] select_3585_s18_q;
  logic less_3628_s18_q;
  logic [9:0] eight_s18_q;
  logic [9:0] fall_2_s18_q;
  logic equal_3706_s18_q;
  logic and_3931_s18_q;
  logic equal_3950_s18_q;
  logic equal_3952_s18_q;
  logic equal_3953_s18_q;
  logic equal_3954_s18_q;
  logic equal_3955_s18_q;
  logic equal_3981_s18_q;
  logic [13:0] of_s18_q;
  logic equal_4095_s18_q;
  logic equal_4191_s18_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s18_q <= pixel_0_s17_q;
      pixel_1_s18_q <= pixel_1_s17_q;
      saturated_s18_q <= saturated_s17_q;
      mask_s18_q <= mask_s17_q;
      marks_first_s18_q <= marks_first_s17_q;
      marks_last_s18_q <= marks_last_s17_q;
      sample_pair_pixel_0_s18_q <= sample_pair_pixel_0_s17_q;
      sample_pair_pixel_1_s18_q <= sample_pair_pixel_1_s17_q;
      sample_pair_whole_s18_q <= sample_pair_whole_s17_q;
      sample_present_s18_q <= sample_present_s17_q;
      census_columns_values_0_cell_1_mask_s18_q <= census_columns_values_0_cell_1_mask_q;
      census_columns_values_0_cell_2_mask_s18_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s18_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s18_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s18_q <= census_columns_values_1_cell_2_of_skin_q;
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
      patches_summed_row_column_s18_q <= patches_summed_row_column_q;
      patches_summed_last_s18_q <= patches_summed_last_s17_q;
      patches_summed_down_by_s18_q <= patches_summed_down_by_s17_q;
      patches_read_first_s18_q <= patches_read_first_s17_q;
      patches_read_far_s18_q <= patches_read_far_q;
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
      equal_553_s18_q <= equal_553_s17_q;
      whole_2_s18_q <= whole_2_s17_q;
      equal_570_s18_q <= equal_570_s17_q;
      equal_575_s18_q <= equal_575_s17_q;
      not_576_s18_q <= not_576_s17_q;
      so_s18_q <= so_s17_q;
      not_578_s18_q <= not_578_s17_q;
      equal_579_s18_q <= equal_579_s17_q;
      inside_v_s18_q <= inside_v_s17_q;
      x_s18_2_q <= x_s17_2_q;
      right_s18_q <= right_s17_q;
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
      less_673_s18_q <= less_673;
      less_674_s18_q <= less_674;
      less_675_s18_q <= less_675;
      less_676_s18_q <= less_676;
      and_684_s18_q <= select_682[4] & select_683[3];
      and_688_s18_q <= and_688;
      difference_711_s18_q <= difference_711[9];
      xor_712_s18_q <= difference_711[8:0] ^ {9{difference_711[9]}};
      difference_714_s18_q <= difference_714[9];
      xor_715_s18_q <= difference_714[8:0] ^ {9{difference_714[9]}};
      difference_718_s18_q <= difference_718[9];
      xor_719_s18_q <= difference_718[8:0] ^ {9{difference_718[9]}};
      difference_722_s18_q <= difference_722[9];
      xor_723_s18_q <= difference_722[8:0] ^ {9{difference_722[9]}};
      difference_726_s18_q <= difference_726[9];
      xor_727_s18_q <= difference_726[8:0] ^ {9{difference_726[9]}};
      half_grey_levels_s18_q <= half_grey_levels;
      half_grey_levels_2_s18_q <= half_grey_levels_2;
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
      select_1862_s18_q <= select_1862_s17_q;
      less_1878_s18_q <= less_1878_s17_q;
      new_row_s18_q <= new_row_s17_q;
      of_row_2_s18_q <= of_row_2_s17_q;
      not_1908_s18_q <= ~sum_1907[14];
      and_1911_s18_q <= sum_1907[8] & (~(sum_1907[7:0] == 8'h0));
      not_1913_s18_q <= ~(sum_1907[13:9] == 5'h0);
      and_1918_s18_q <= sum_1907[14] & (~(sum_1907[13:8] == 6'h3f));
      and_1934_s18_q <= and_1934;
      and_1937_s18_q <= and_1937;
      and_1951_s18_q <= and_1951_s17_q;
      and_1960_s18_q <= and_1960_s17_q;
      and_1965_s18_q <= and_1965_s17_q;
      less_1966_s18_q <= less_1966_s17_q;
      equal_1967_s18_q <= equal_1967_s17_q;
      not_1968_s18_q <= not_1968_s17_q;
      equal_1969_s18_q <= equal_1969_s17_q;
      or_1988_s18_q <= or_1988_s17_q;
      or_1991_s18_q <= or_1991_s17_q;
      or_1994_s18_q <= or_1994_s17_q;
      not_1996_s18_q <= not_1996_s17_q;
      regions_rdata_s18_q <= regions_rdata_q;
      textured_s18_q <= textured_s17_q;
      explained_s18_q <= explained;
      and_2023_s18_q <= inside_v_s17_q & (and_2021_s17_q & and_1586_s17_q);
      and_2028_s18_q <= and_2028_s17_q;
      and_2069_s18_q <= and_2069_s17_q;
      and_2070_s18_q <= seen_columns_rdata_s17_q[9] & inside_v_s17_q;
      sum_2074_s18_q <= sum_2074;
      or_2086_s18_q <= or_2086_s17_q;
      or_2089_s18_q <= or_2089_s17_q;
      or_2092_s18_q <= or_2092_s17_q;
      and_2103_s18_q <= and_2103_s17_q;
      sum_2109_s18_q <= {2'h0, and_2104} + {1'b0, sum_2108};
      and_2119_s18_q <= and_2119_s17_q;
      sum_2125_s18_q <= {2'h0, and_2120} + {1'b0, sum_2124};
      and_2142_s18_q <= and_2142_s17_q;
      sum_2177_s18_q <= sum_2177[0];
      difference_2178_s18_q <= {1'b0, sum_2177[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2185_s18_q <= sum_2185[0];
      difference_2186_s18_q <= {1'b0, sum_2185[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2258_s18_q <= difference_2258[9];
      xor_2259_s18_q <= difference_2258[8:0] ^ {9{difference_2258[9]}};
      difference_2261_s18_q <= difference_2261[9];
      xor_2262_s18_q <= difference_2261[8:0] ^ {9{difference_2261[9]}};
      difference_2265_s18_q <= difference_2265[9];
      xor_2266_s18_q <= difference_2265[8:0] ^ {9{difference_2265[9]}};
      difference_2269_s18_q <= difference_2269[9];
      xor_2270_s18_q <= difference_2269[8:0] ^ {9{difference_2269[9]}};
      difference_2273_s18_q <= difference_2273[9];
      xor_2274_s18_q <= difference_2273[8:0] ^ {9{difference_2273[9]}};
      equal_2283_s18_q <= equal_2283_s17_q;
      equal_2298_s18_q <= equal_2298;
      difference_2369_s18_q <= difference_2369[9];
      xor_2370_s18_q <= difference_2369[8:0] ^ {9{difference_2369[9]}};
      difference_2381_s18_q <= difference_2381[9];
      xor_2382_s18_q <= difference_2381[8:0] ^ {9{difference_2381[9]}};
      equal_2472_s18_q <= equal_2472_s17_q;
      and_2597_s18_q <= and_2597;
      and_2603_s18_q <= and_2603_s17_q;
      and_2608_s18_q <= and_2608;
      not_2622_s18_q <= not_2622_s17_q;
      and_2623_s18_q <= and_2623_s17_q;
      sum_2629_s18_q <= {2'h0, and_2624} + {1'b0, sum_2628};
      and_2699_s18_q <= not_576_s17_q & (so_s17_q & (ends_cell_s17_q & and_2696_s17_q));
      and_2716_s18_q <= not_576_s17_q & (so_s17_q & and_2714);
      and_2723_s18_q <= not_576_s17_q & (so_s17_q & and_2721);
      and_2757_s18_q <= and_2757_s17_q;
      and_2758_s18_q <= and_2758_s17_q;
      residual_s18_q <= residual_s17_q[7:0];
      less_2793_s18_q <= $signed(difference_2792) < $signed({7'h0, cfg_moved_limit_i});
      less_2807_s18_q <= less_2807;
      equal_2851_s18_q <= (registration_fresh_q & select_2849) == 4'h0;
      and_2996_s18_q <= and_2996_s17_q;
      word_s18_q <= word;
      equal_3117_s18_q <= patches_along_s17_q == 5'h7;
      less_3123_s18_q <= less_3123_s17_q;
      select_3156_s18_q <= select_3156;
      equal_3466_s18_q <= equal_3466_s17_q;
      select_3554_s18_q <= select_3554_s17_q;
      select_3585_s18_q <= select_3585_s17_q;
      less_3628_s18_q <= less_3628_s17_q;
      eight_s18_q <= eight;
      fall_2_s18_q <= fall_2;
      equal_3706_s18_q <= equal_3706;
      and_3931_s18_q <= equal_3930_s17_q & equal_3706;
      equal_3950_s18_q <= equal_3950_s17_q;
      equal_3952_s18_q <= equal_3952;
      equal_3953_s18_q <= equal_3953_s17_q;
      equal_3954_s18_q <= equal_3954_s17_q;
      equal_3955_s18_q <= equal_3955_s17_q;
      equal_3981_s18_q <= (limit & select_3979) == 8'h0;
      of_s18_q <= of;
      equal_4095_s18_q <= equal_4095_s17_q;
      equal_4191_s18_q <= (registration_fresh_q & select_4189) == 4'h0;
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
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_688_s18_q;
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
  // hls/stages/census.hpp:281
  logic [9:0] sum_713;
  assign sum_713 = {9'h0, difference_711_s18_q} + {1'b0, xor_712_s18_q};
  logic [9:0] sum_716;
  assign sum_716 = {9'h0, difference_714_s18_q} + {1'b0, xor_715_s18_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_738;
  assign sum_738 = {half_grey_levels_s18_q[9], half_grey_levels_s18_q[9:4]} + 7'h7f;
  logic less_739;
  assign less_739 = {{5{sum_738[6]}}, sum_738, half_grey_levels_s18_q[3:0]} < 16'hffe1;
  logic [6:0] sum_744;
  assign sum_744 = {half_grey_levels_2_s18_q[9], half_grey_levels_2_s18_q[9:4]} + 7'h7f;
  logic less_745;
  assign less_745 = {{5{sum_744[6]}}, sum_744, half_grey_levels_2_s18_q[3:0]} < 16'hffe1;
  // hls/stages/patches.hpp:157
  logic and_1743;
  assign and_1743 = and_1741_s18_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:345
  logic select_1744;
  assign select_1744 = and_1743 ? and_1741_s18_q : patches_choice_valid_q;
  logic [7:0] select_1749;
  assign select_1749 = and_1743 ? select_1748_s18_q : patches_choice_column_q;
  logic [5:0] select_1754;
  assign select_1754 = and_1743 ? select_1753_s18_q : patches_choice_shift_q;
  logic [7:0] select_1780;
  assign select_1780 = and_1743 ? select_1779_s18_q : patches_choice_slope_q;
  // hls/stages/patches.hpp:354
  logic [22:0] select_1804;
  assign select_1804 = and_1803_s18_q ? {select_1780, select_1754, select_1749, select_1744} : patches_choices_rdata_s18_q;
  // hls/stages/patches.hpp:487
  logic [2:0] sum_1899;
  assign sum_1899 = patches_code_row_s18_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:454
  logic and_1915;
  assign and_1915 = not_1908_s18_q & (and_1911_s18_q | not_1913_s18_q);
  // hls/stages/patches.hpp:491
  logic [1:0] sum_1955;
  assign sum_1955 = patches_code_row_s18_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2009;
  assign select_2009 = segment_started_s18_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2010;
  assign sum_2010 = {6'h0, textured_s18_q} + select_2009;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2012;
  assign sum_2012 = {3'h0, sum_2010} + (region_fresh_s18_q ? 10'h0 : regions_rdata_s18_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2014;
  assign select_2014 = segment_started_s18_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:901
  logic [6:0] sum_2015;
  assign sum_2015 = {6'h0, explained_s18_q} + select_2014;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2017;
  assign sum_2017 = {3'h0, sum_2015} + (region_fresh_s18_q ? 10'h0 : regions_rdata_s18_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [6:0] select_2024;
  assign select_2024 = segment_started_s18_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2025;
  assign sum_2025 = {6'h0, and_2023_s18_q} + select_2024;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2027;
  assign sum_2027 = {3'h0, sum_2025} + (region_fresh_s18_q ? 10'h0 : regions_rdata_s18_q[29:20]);
  // hls/stages/agreement.hpp:1275
  logic or_2037;
  assign or_2037 = marks_first_s18_q | line_ended_q;
  // hls/stages/agreement.hpp:1277
  logic [12:0] select_2039;
  assign select_2039 = marks_first_s18_q ? 13'h1 : (or_2037 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2041;
  assign select_2041 = or_2037 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1284
  logic select_2043;
  assign select_2043 = cfg_compete_i ? (or_2037 & select_2039[12]) : (select_2041[8] & select_2039[9]);
  // hls/stages/agreement.hpp:1087
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2069_s18_q} + ({2'h0, and_2070_s18_q} + {1'b0, sum_2074_s18_q});
  // hls/stages/agreement.hpp:1089
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2103_s18_q} + sum_2109_s18_q;
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2111;
  assign select_2111 = age_s18_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1090
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2119_s18_q} + sum_2125_s18_q;
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2127;
  assign select_2127 = age_s18_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:218
  logic [9:0] xor_2179;
  assign xor_2179 = {difference_2178_s18_q[8:0], sum_2177_s18_q} ^ {10{difference_2178_s18_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2178_s18_q[9]} + {1'b0, xor_2179};
  logic [9:0] xor_2187;
  assign xor_2187 = {difference_2186_s18_q[8:0], sum_2185_s18_q} ^ {10{difference_2186_s18_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2186_s18_q[9]} + {1'b0, xor_2187};
  // hls/stages/agreement.hpp:520
  logic select_2203;
  assign select_2203 = and_550_s18_q ? whole_2_s18_q : census_columns_values_0_cell_0_mask_q;
  logic select_2219;
  assign select_2219 = and_550_s18_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2222;
  assign select_2222 = and_550_s18_q ? census_columns_values_0_cell_1_mask_s18_q : census_columns_values_1_cell_1_mask_q;
  logic select_2229;
  assign select_2229 = and_550_s18_q ? census_columns_values_0_cell_3_mask_s18_q : census_columns_values_1_cell_3_mask_q;
  logic select_2232;
  assign select_2232 = and_550_s18_q ? census_columns_values_0_cell_4_mask_s18_q : census_columns_values_1_cell_4_mask_q;
  logic select_2235;
  assign select_2235 = and_550_s18_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2238;
  assign select_2238 = and_550_s18_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:283
  logic [9:0] sum_2260;
  assign sum_2260 = {9'h0, difference_2258_s18_q} + {1'b0, xor_2259_s18_q};
  logic [9:0] sum_2263;
  assign sum_2263 = {9'h0, difference_2261_s18_q} + {1'b0, xor_2262_s18_q};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2295;
  assign sum_2295 = {13'h0, moments_turns_0_q} + (moments_starts_s18_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2297;
  assign sum_2297 = {13'h0, moments_turns_1_q} + (moments_starts_s18_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:788
  logic and_2338;
  assign and_2338 = not_578_s18_q & (equal_579_s18_q & (inside_v_s18_q & and_1598_s18_q));
  logic and_2342;
  assign and_2342 = not_578_s18_q & (equal_579_s18_q & (inside_v_s18_q & and_1607_s18_q));
  // hls/stages/census.hpp:368
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2369_s18_q} + xor_2370_s18_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2381_s18_q} + xor_2382_s18_q;
  // hls/stages/agreement.hpp:788
  logic and_2613;
  assign and_2613 = not_576_s18_q & (so_s18_q & (ends_cell_s18_q & explained_s18_q));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2615;
  assign select_2615 = and_2597_s18_q ? 14'h0 : (counts_explained_q + {13'h0, and_2613});
  // hls/stages/agreement.hpp:788
  logic and_2618;
  assign and_2618 = not_576_s18_q & (so_s18_q & (ends_cell_s18_q & and_2023_s18_q));
  // hls/stages/agreement.hpp:1088
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2623_s18_q} + sum_2629_s18_q;
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2631;
  assign select_2631 = age_s18_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1132
  logic less_2647;
  assign less_2647 = region_row_s18_q < x_s18_q[5:3];
  // hls/stages/patches.hpp:346
  logic not_2986;
  assign not_2986 = ~and_1786_s18_q;
  // hls/stages/patches.hpp:523
  logic [55:0] other;
  assign other = new_row_s18_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:185
  logic [51:0] select_3113;
  assign select_3113 = or_1794_s18_q ? {and_1937_s18_q, and_1934_s18_q, and_1918_s18_q, and_1915, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3115;
  assign select_3115 = equal_1788_s18_q ? patches_codes_at_q : (equal_1790_s18_q ? other[55:4] : select_3113);
  // hls/stages/patches.hpp:522
  logic [27:0] select_3118;
  assign select_3118 = equal_3117_s18_q ? word_s18_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:185
  logic [27:0] select_3120;
  assign select_3120 = equal_1790_s18_q ? (new_row_s18_q ? word_s18_q : select_3118) : patches_codes_further_q;
  // hls/stages/patches.hpp:524
  logic [55:0] select_3122;
  assign select_3122 = less_1878_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:494
  logic [55:0] select_3124;
  assign select_3124 = less_3123_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:185
  logic [55:0] select_3126;
  assign select_3126 = or_1794_s18_q ? (equal_1793_s18_q ? patches_next_codes_q : select_3124) : patches_next_codes_q;
  logic [55:0] select_3128;
  assign select_3128 = equal_1788_s18_q ? patches_next_codes_q : (equal_1790_s18_q ? select_3122 : select_3126);
  // hls/stages/count_bits.hpp:24
  logic parity_3133;
  assign parity_3133 = ^{and_1937_s18_q, and_1934_s18_q, and_1918_s18_q, and_1915};
  // hls/stages/count_bits.hpp:25
  logic or_3137;
  assign or_3137 = ({and_1918_s18_q, and_1915} == 2'h3) | (and_1934_s18_q & (and_1918_s18_q | and_1915));
  logic and_3138;
  assign and_3138 = and_1937_s18_q & (^{and_1934_s18_q, and_1918_s18_q, and_1915});
  // hls/stages/count_bits.hpp:24
  logic xor_3139;
  assign xor_3139 = or_3137 ^ and_3138;
  // hls/stages/count_bits.hpp:27
  logic and_3140;
  assign and_3140 = or_3137 & and_3138;
  // hls/stages/patches.hpp:525
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3156_s18_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3162;
  assign xor_3162 = bits[17] ^ (^{select_3156_s18_q[16:15], other[16:15]});
  logic xor_3165;
  assign xor_3165 = bits[11] ^ (^{select_3156_s18_q[10:9], other[10:9]});
  logic xor_3168;
  assign xor_3168 = bits[14] ^ (^{select_3156_s18_q[13:12], other[13:12]});
  logic xor_3171;
  assign xor_3171 = xor_3162 ^ (^{select_3156_s18_q[14:9], other[14:9]});
  logic xor_3174;
  assign xor_3174 = bits[47] ^ (^{select_3156_s18_q[46:45], other[46:45]});
  logic xor_3177;
  assign xor_3177 = bits[8] ^ (^{select_3156_s18_q[7:6], other[7:6]});
  logic xor_3180;
  assign xor_3180 = bits[2] ^ (^{select_3156_s18_q[1:0], other[1:0]});
  logic xor_3183;
  assign xor_3183 = bits[5] ^ (^{select_3156_s18_q[4:3], other[4:3]});
  logic xor_3186;
  assign xor_3186 = xor_3177 ^ (^{select_3156_s18_q[5:0], other[5:0]});
  logic parity_3188;
  assign parity_3188 = ^{select_3156_s18_q[47:45], select_3156_s18_q[8:0], other[47:45], other[8:0]};
  logic xor_3192;
  assign xor_3192 = bits[44] ^ (^{select_3156_s18_q[43:42], other[43:42]});
  logic xor_3195;
  assign xor_3195 = bits[38] ^ (^{select_3156_s18_q[37:36], other[37:36]});
  logic xor_3198;
  assign xor_3198 = bits[41] ^ (^{select_3156_s18_q[40:39], other[40:39]});
  logic xor_3204;
  assign xor_3204 = bits[26] ^ (^{select_3156_s18_q[25:24], other[25:24]});
  logic xor_3207;
  assign xor_3207 = bits[20] ^ (^{select_3156_s18_q[19:18], other[19:18]});
  logic xor_3210;
  assign xor_3210 = bits[23] ^ (^{select_3156_s18_q[22:21], other[22:21]});
  logic xor_3216;
  assign xor_3216 = bits[35] ^ (^{select_3156_s18_q[34:33], other[34:33]});
  logic xor_3219;
  assign xor_3219 = bits[29] ^ (^{select_3156_s18_q[28:27], other[28:27]});
  logic xor_3222;
  assign xor_3222 = bits[32] ^ (^{select_3156_s18_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:185
  logic select_3506;
  assign select_3506 = equal_1788_s18_q ? patches_summed_first_q : (equal_1790_s18_q ? new_row_s18_q : patches_summed_first_q);
  // hls/stages/patches.hpp:544
  logic [9:0] select_3594;
  assign select_3594 = (patches_read_far_s18_q < patches_peak_far_q) ? patches_read_far_s18_q : patches_peak_far_q;
  logic [9:0] select_3595;
  assign select_3595 = patches_read_first_s18_q ? patches_read_far_s18_q : select_3594;
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3637;
  assign sum_3637 = {1'b0, fall_2_s18_q} + {2'h0, fall_2_s18_q[9:1]};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3641;
  assign sum_3641 = {1'b0, fall_2_s18_q} + {3'h0, fall_2_s18_q[9:2]};
  logic less_3645;
  assign less_3645 = {eight_s18_q, 3'h0} < ({fall_2_s18_q, 3'h0} - {3'h0, fall_2_s18_q});
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3968;
  assign select_3968 = equal_3706_s18_q ? 14'h0 : product_q;
  logic [13:0] select_3987;
  assign select_3987 = equal_3981_s18_q ? 14'h0 : of_s18_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3968} + {1'b0, select_3987};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4029;
  assign select_4029 = so_s18_q ? (ends_cell_s18_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4031;
  assign select_4031 = ends_cell_s18_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4033;
  assign select_4033 = equal_575_s18_q ? box_explained_columns_values_1_q : (so_s18_q ? select_4031 : box_explained_columns_values_1_q);
  logic [2:0] select_4034;
  assign select_4034 = ends_cell_s18_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4036;
  assign select_4036 = equal_575_s18_q ? box_explained_columns_values_2_q : (so_s18_q ? select_4034 : box_explained_columns_values_2_q);
  logic [2:0] select_4037;
  assign select_4037 = ends_cell_s18_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4039;
  assign select_4039 = equal_575_s18_q ? box_explained_columns_values_3_q : (so_s18_q ? select_4037 : box_explained_columns_values_3_q);
  logic [2:0] select_4040;
  assign select_4040 = ends_cell_s18_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4042;
  assign select_4042 = equal_575_s18_q ? box_explained_columns_values_4_q : (so_s18_q ? select_4040 : box_explained_columns_values_4_q);
  logic [2:0] select_4047;
  assign select_4047 = so_s18_q ? (ends_cell_s18_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4049;
  assign select_4049 = ends_cell_s18_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4051;
  assign select_4051 = equal_575_s18_q ? box_shown_columns_values_1_q : (so_s18_q ? select_4049 : box_shown_columns_values_1_q);
  logic [2:0] select_4052;
  assign select_4052 = ends_cell_s18_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4054;
  assign select_4054 = equal_575_s18_q ? box_shown_columns_values_2_q : (so_s18_q ? select_4052 : box_shown_columns_values_2_q);
  logic [2:0] select_4055;
  assign select_4055 = ends_cell_s18_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4057;
  assign select_4057 = equal_575_s18_q ? box_shown_columns_values_3_q : (so_s18_q ? select_4055 : box_shown_columns_values_3_q);
  logic [2:0] select_4058;
  assign select_4058 = ends_cell_s18_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4060;
  assign select_4060 = equal_575_s18_q ? box_shown_columns_values_4_q : (so_s18_q ? select_4058 : box_shown_columns_values_4_q);
  logic [2:0] select_4065;
  assign select_4065 = so_s18_q ? (ends_cell_s18_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4067;
  assign select_4067 = ends_cell_s18_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4069;
  assign select_4069 = equal_575_s18_q ? box_nearer_columns_values_1_q : (so_s18_q ? select_4067 : box_nearer_columns_values_1_q);
  logic [2:0] select_4070;
  assign select_4070 = ends_cell_s18_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4072;
  assign select_4072 = equal_575_s18_q ? box_nearer_columns_values_2_q : (so_s18_q ? select_4070 : box_nearer_columns_values_2_q);
  logic [2:0] select_4073;
  assign select_4073 = ends_cell_s18_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4075;
  assign select_4075 = equal_575_s18_q ? box_nearer_columns_values_3_q : (so_s18_q ? select_4073 : box_nearer_columns_values_3_q);
  logic [2:0] select_4076;
  assign select_4076 = ends_cell_s18_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4078;
  assign select_4078 = equal_575_s18_q ? box_nearer_columns_values_4_q : (so_s18_q ? select_4076 : box_nearer_columns_values_4_q);

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

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1899, patches_code_row_s18_q[1:0], of_row_2_s18_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s18_en & and_1951_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1937_s18_q, and_1934_s18_q, and_1918_s18_q, and_1915, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1955, patches_code_row_s18_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s18_en & and_1965_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1937_s18_q, and_1934_s18_q, and_1918_s18_q, and_1915, patches_codes_at_q[51:8]};
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
    end else if (s18_en) begin
      moments_turned_0_q <= sum_2295;
      moments_turned_1_q <= sum_2297;
      moments_turns_0_q <= not_576_s18_q & and_2338;
      moments_turns_1_q <= not_576_s18_q & and_2342;
      counts_explained_q <= select_2615;
      patches_fixed_q <= not_2986 & (patches_fixed_q | (and_2996_s18_q & and_1743));
      patches_choice_valid_q <= and_1786_s18_q ? (select_1744 & not_2986) : select_1744;
      patches_choice_column_q <= select_1749;
      patches_choice_shift_q <= select_1754;
      patches_choice_slope_q <= select_1780;
      patches_codes_at_q <= select_3115;
      patches_codes_further_q <= equal_1788_s18_q ? patches_codes_further_q : select_3120;
      patches_next_codes_q <= select_3128;
      patches_summed_first_q <= select_3506;
      patches_peak_far_q <= equal_1788_s18_q ? select_3595 : patches_peak_far_q;
      segment_textured_q <= select_2009 + {6'h0, and_2608_s18_q};
      segment_explained_q <= select_2014 + {6'h0, and_2613};
      segment_nearer_q <= select_2024 + {6'h0, and_2618};
      product_q <= equal_575_s18_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2039;
      columns_passed_q <= {select_2041[7:0], or_2037};
      line_ended_q <= marks_last_s18_q;
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
    if (s18_en) begin
      census_columns_values_0_cell_0_mask_q <= select_2203;
      census_columns_values_1_cell_0_mask_q <= select_2219;
      census_columns_values_1_cell_1_mask_q <= select_2222;
      census_columns_values_1_cell_3_mask_q <= select_2229;
      census_columns_values_1_cell_4_mask_q <= select_2232;
      census_columns_values_2_cell_0_mask_q <= select_2235;
      census_columns_values_2_cell_1_mask_q <= select_2238;
      box_explained_columns_values_0_q <= equal_575_s18_q ? box_explained_columns_values_0_q : select_4029;
      box_explained_columns_values_1_q <= select_4033;
      box_explained_columns_values_2_q <= select_4036;
      box_explained_columns_values_3_q <= select_4039;
      box_explained_columns_values_4_q <= select_4042;
      box_shown_columns_values_0_q <= equal_575_s18_q ? box_shown_columns_values_0_q : select_4047;
      box_shown_columns_values_1_q <= select_4051;
      box_shown_columns_values_2_q <= select_4054;
      box_shown_columns_values_3_q <= select_4057;
      box_shown_columns_values_4_q <= select_4060;
      box_nearer_columns_values_0_q <= equal_575_s18_q ? box_nearer_columns_values_0_q : select_4065;
      box_nearer_columns_values_1_q <= select_4069;
      box_nearer_columns_values_2_q <= select_4072;
      box_nearer_columns_values_3_q <= select_4075;
      box_nearer_columns_values_4_q <= select_4078;
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
  logic census_columns_values_0_cell_2_mask_s19_q;
  logic census_columns_values_1_cell_2_of_skin_s19_q;
  logic census_columns_values_1_cell_3_mask_s19_q;
  logic census_columns_values_1_cell_4_mask_s19_q;
  logic census_columns_values_2_cell_0_mask_s19_q;
  logic census_columns_values_2_cell_1_mask_s19_q;
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
  logic [4:0] patches_summed_row_column_s19_q;
  logic patches_summed_first_s19_q;
  logic patches_summed_last_s19_q;
  logic [4:0] patches_summed_down_by_s19_q;
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
  logic whole_9_s19_q;
  logic [10:0] sum_717_s19_q;
  logic [9:0] sum_720_s19_q;
  logic [9:0] sum_724_s19_q;
  logic [9:0] sum_728_s19_q;
  logic less_739_s19_q;
  logic less_741_s19_q;
  logic less_745_s19_q;
  logic less_747_s19_q;
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
  logic [3:0] select_1862_s19_q;
  logic less_1966_s19_q;
  logic equal_1967_s19_q;
  logic not_1968_s19_q;
  logic equal_1969_s19_q;
  logic or_1988_s19_q;
  logic or_1991_s19_q;
  logic or_1994_s19_q;
  logic not_1996_s19_q;
  logic [9:0] sum_2012_s19_q;
  logic [9:0] sum_2017_s19_q;
  logic [9:0] sum_2027_s19_q;
  logic and_2028_s19_q;
  logic select_2043_s19_q;
  logic [2:0] textured_2_s19_q;
  logic or_2086_s19_q;
  logic or_2089_s19_q;
  logic or_2092_s19_q;
  logic [3:0] difference_2112_s19_q;
  logic [3:0] difference_2128_s19_q;
  logic and_2142_s19_q;
  logic [10:0] size_s19_q;
  logic [10:0] size_2_s19_q;
  logic [10:0] sum_2264_s19_q;
  logic [9:0] sum_2267_s19_q;
  logic [9:0] sum_2271_s19_q;
  logic [9:0] sum_2275_s19_q;
  logic equal_2283_s19_q;
  logic equal_2298_s19_q;
  logic [8:0] contrast_s19_q;
  logic [8:0] contrast_2_s19_q;
  logic equal_2472_s19_q;
  logic and_2597_s19_q;
  logic and_2603_s19_q;
  logic and_2618_s19_q;
  logic not_2622_s19_q;
  logic [3:0] difference_2632_s19_q;
  logic [9:0] select_2648_s19_q;
  logic [9:0] select_2651_s19_q;
  logic and_2699_s19_q;
  logic and_2716_s19_q;
  logic and_2723_s19_q;
  logic and_2757_s19_q;
  logic and_2758_s19_q;
  logic [7:0] residual_s19_q;
  logic and_2794_s19_q;
  logic and_2808_s19_q;
  logic equal_2851_s19_q;
  logic [8:0] other_s19_q;
  logic [2:0] select_3141_s19_q;
  logic [8:0] select_3156_s19_q;
  logic xor_3171_s19_q;
  logic xor_3189_s19_q;
  logic xor_3201_s19_q;
  logic xor_3213_s19_q;
  logic xor_3225_s19_q;
  logic or_3234_s19_q;
  logic or_3238_s19_q;
  logic or_3242_s19_q;
  logic or_3249_s19_q;
  logic or_3253_s19_q;
  logic or_3257_s19_q;
  logic or_3264_s19_q;
  logic or_3268_s19_q;
  logic or_3272_s19_q;
  logic or_3282_s19_q;
  logic or_3286_s19_q;
  logic or_3290_s19_q;
  logic or_3298_s19_q;
  logic or_3302_s19_q;
  logic or_3306_s19_q;
  logic or_3313_s19_q;
  logic or_3317_s19_q;
  logic or_3321_s19_q;
  logic or_3331_s19_q;
  logic or_3335_s19_q;
  logic or_3339_s19_q;
  logic and_3344_s19_q;
  logic or_3345_s19_q;
  logic equal_3466_s19_q;
  logic [4:0] select_3554_s19_q;
  logic [14:0] select_3585_s19_q;
  logic [9:0] select_3595_s19_q;
  logic less_3628_s19_q;
  logic not_3636_s19_q;
  logic not_3639_s19_q;
  logic not_3643_s19_q;
  logic not_3646_s19_q;
  logic equal_3706_s19_q;
  logic and_3931_s19_q;
  logic less_3932_s19_q;
  logic equal_3933_s19_q;
  logic equal_3950_s19_q;
  logic equal_3952_s19_q;
  logic equal_3953_s19_q;
  logic equal_3954_s19_q;
  logic equal_3955_s19_q;
  logic sum_4_s19_q;
  logic equal_4095_s19_q;
  logic equal_4191_s19_q;
  logic [9:0] select_4201_s19_q;
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
      census_columns_values_0_cell_2_mask_s19_q <= census_columns_values_0_cell_2_mask_s18_q;
      census_columns_values_1_cell_2_of_skin_s19_q <= census_columns_values_1_cell_2_of_skin_s18_q;
      census_columns_values_1_cell_3_mask_s19_q <= census_columns_values_1_cell_3_mask_q;
      census_columns_values_1_cell_4_mask_s19_q <= census_columns_values_1_cell_4_mask_q;
      census_columns_values_2_cell_0_mask_s19_q <= census_columns_values_2_cell_0_mask_q;
      census_columns_values_2_cell_1_mask_s19_q <= census_columns_values_2_cell_1_mask_q;
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
      patches_summed_row_column_s19_q <= patches_summed_row_column_s18_q;
      patches_summed_first_s19_q <= patches_summed_first_q;
      patches_summed_last_s19_q <= patches_summed_last_s18_q;
      patches_summed_down_by_s19_q <= patches_summed_down_by_s18_q;
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
      whole_9_s19_q <= whole_9;
      sum_717_s19_q <= {1'b0, sum_713} + {1'b0, sum_716};
      sum_720_s19_q <= {9'h0, difference_718_s18_q} + {1'b0, xor_719_s18_q};
      sum_724_s19_q <= {9'h0, difference_722_s18_q} + {1'b0, xor_723_s18_q};
      sum_728_s19_q <= {9'h0, difference_726_s18_q} + {1'b0, xor_727_s18_q};
      less_739_s19_q <= less_739;
      less_741_s19_q <= $signed(10'h0) < $signed(half_grey_levels_s18_q);
      less_745_s19_q <= less_745;
      less_747_s19_q <= $signed(10'h0) < $signed(half_grey_levels_2_s18_q);
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
      select_1862_s19_q <= select_1862_s18_q;
      less_1966_s19_q <= less_1966_s18_q;
      equal_1967_s19_q <= equal_1967_s18_q;
      not_1968_s19_q <= not_1968_s18_q;
      equal_1969_s19_q <= equal_1969_s18_q;
      or_1988_s19_q <= or_1988_s18_q;
      or_1991_s19_q <= or_1991_s18_q;
      or_1994_s19_q <= or_1994_s18_q;
      not_1996_s19_q <= not_1996_s18_q;
      sum_2012_s19_q <= sum_2012;
      sum_2017_s19_q <= sum_2017;
      sum_2027_s19_q <= sum_2027;
      and_2028_s19_q <= and_2028_s18_q;
      select_2043_s19_q <= select_2043;
      textured_2_s19_q <= textured_2;
      or_2086_s19_q <= or_2086_s18_q;
      or_2089_s19_q <= or_2089_s18_q;
      or_2092_s19_q <= or_2092_s18_q;
      difference_2112_s19_q <= {1'b0, shown_2} - {1'b0, select_2111};
      difference_2128_s19_q <= {1'b0, near_2} - {1'b0, select_2127};
      and_2142_s19_q <= and_2142_s18_q;
      size_s19_q <= size;
      size_2_s19_q <= size_2;
      sum_2264_s19_q <= {1'b0, sum_2260} + {1'b0, sum_2263};
      sum_2267_s19_q <= {9'h0, difference_2265_s18_q} + {1'b0, xor_2266_s18_q};
      sum_2271_s19_q <= {9'h0, difference_2269_s18_q} + {1'b0, xor_2270_s18_q};
      sum_2275_s19_q <= {9'h0, difference_2273_s18_q} + {1'b0, xor_2274_s18_q};
      equal_2283_s19_q <= equal_2283_s18_q;
      equal_2298_s19_q <= equal_2298_s18_q;
      contrast_s19_q <= contrast;
      contrast_2_s19_q <= contrast_2;
      equal_2472_s19_q <= equal_2472_s18_q;
      and_2597_s19_q <= and_2597_s18_q;
      and_2603_s19_q <= and_2603_s18_q;
      and_2618_s19_q <= and_2618;
      not_2622_s19_q <= not_2622_s18_q;
      difference_2632_s19_q <= {1'b0, explained_2} - {1'b0, select_2631};
      select_2648_s19_q <= less_2647 ? 10'h0 : regions_rdata_s18_q[9:0];
      select_2651_s19_q <= less_2647 ? 10'h0 : regions_rdata_s18_q[19:10];
      and_2699_s19_q <= and_2699_s18_q;
      and_2716_s19_q <= and_2716_s18_q;
      and_2723_s19_q <= and_2723_s18_q;
      and_2757_s19_q <= and_2757_s18_q;
      and_2758_s19_q <= and_2758_s18_q;
      residual_s19_q <= residual_s18_q;
      and_2794_s19_q <= and_2758_s18_q & less_2793_s18_q;
      and_2808_s19_q <= and_2758_s18_q & less_2807_s18_q;
      equal_2851_s19_q <= equal_2851_s18_q;
      other_s19_q <= other[44:36];
      select_3141_s19_q <= and_1960_s18_q ? {and_3140, xor_3139, parity_3133} : 3'h0;
      select_3156_s19_q <= select_3156_s18_q[44:36];
      xor_3171_s19_q <= xor_3171;
      xor_3189_s19_q <= xor_3171 ^ parity_3188;
      xor_3201_s19_q <= xor_3192 ^ (^{select_3156_s18_q[41:36], other[41:36]});
      xor_3213_s19_q <= xor_3204 ^ (^{select_3156_s18_q[23:18], other[23:18]});
      xor_3225_s19_q <= xor_3216 ^ (^{select_3156_s18_q[32:27], other[32:27]});
      or_3234_s19_q <= (xor_3165 & xor_3168) | (xor_3162 & (xor_3165 | xor_3168));
      or_3238_s19_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3242_s19_q <= (xor_3180 & xor_3183) | (xor_3177 & (xor_3180 | xor_3183));
      or_3249_s19_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3253_s19_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3257_s19_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3264_s19_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3268_s19_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3272_s19_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3282_s19_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3286_s19_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3290_s19_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3298_s19_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3302_s19_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3306_s19_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3313_s19_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3317_s19_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3321_s19_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3331_s19_q <= (xor_3195 & xor_3198) | (xor_3192 & (xor_3195 | xor_3198));
      or_3335_s19_q <= (xor_3207 & xor_3210) | (xor_3204 & (xor_3207 | xor_3210));
      or_3339_s19_q <= (xor_3219 & xor_3222) | (xor_3216 & (xor_3219 | xor_3222));
      and_3344_s19_q <= xor_3174 & xor_3186;
      or_3345_s19_q <= xor_3174 | xor_3186;
      equal_3466_s19_q <= equal_3466_s18_q;
      select_3554_s19_q <= select_3554_s18_q;
      select_3585_s19_q <= select_3585_s18_q;
      select_3595_s19_q <= select_3595;
      less_3628_s19_q <= less_3628_s18_q;
      not_3636_s19_q <= ~({eight_s18_q, 3'h0} < {3'h0, fall_2_s18_q});
      not_3639_s19_q <= ~({eight_s18_q, 3'h0} < {1'b0, sum_3637, fall_2_s18_q[0]});
      not_3643_s19_q <= ~({eight_s18_q, 3'h0} < {sum_3641, fall_2_s18_q[1:0]});
      not_3646_s19_q <= ~less_3645;
      equal_3706_s19_q <= equal_3706_s18_q;
      and_3931_s19_q <= and_3931_s18_q;
      less_3932_s19_q <= counts_explained_q < product_q;
      equal_3933_s19_q <= counts_explained_q == product_q;
      equal_3950_s19_q <= equal_3950_s18_q;
      equal_3952_s19_q <= equal_3952_s18_q;
      equal_3953_s19_q <= equal_3953_s18_q;
      equal_3954_s19_q <= equal_3954_s18_q;
      equal_3955_s19_q <= equal_3955_s18_q;
      sum_4_s19_q <= sum_4[0];
      equal_4095_s19_q <= equal_4095_s18_q;
      equal_4191_s19_q <= equal_4191_s18_q;
      select_4201_s19_q <= less_2647 ? 10'h0 : regions_rdata_s18_q[29:20];
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
  // hls/stages/census.hpp:281
  logic [10:0] sum_721;
  assign sum_721 = sum_717_s19_q + {1'b0, sum_720_s19_q};
  // hls/stages/agreement.hpp:456
  logic and_735;
  assign and_735 = census_columns_values_0_cell_2_mask_s19_q & census_columns_values_1_cell_2_mask_q;
  logic and_736;
  assign and_736 = and_684_s19_q & and_735;
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
  // hls/stages/patches.hpp:355
  logic [21:0] select_1808;
  assign select_1808 = select_1693_s19_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1804_s19_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1809;
  assign select_1809 = equal_1694_s19_q ? patches_place_0_column_q : select_1808[7:0];
  logic [5:0] select_1810;
  assign select_1810 = equal_1694_s19_q ? patches_place_0_shift_q : select_1808[13:8];
  // hls/stages/patches.hpp:355
  logic [21:0] select_1836;
  assign select_1836 = select_1693_s19_q ? select_1804_s19_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1837;
  assign select_1837 = equal_1694_s19_q ? patches_place_1_column_q : select_1836[7:0];
  logic [5:0] select_1838;
  assign select_1838 = equal_1694_s19_q ? patches_place_1_shift_q : select_1836[13:8];
  // hls/stages/patches.hpp:133
  logic equal_1853;
  assign equal_1853 = {select_1809[7], select_511_s19_q, select_508_s19_q} == {1'b0, select_1809[6:0], 4'h0};
  logic equal_1857;
  assign equal_1857 = {select_1837[7], select_511_s19_q, select_508_s19_q} == {1'b0, select_1837[6:0], 4'h0};
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2043_s19_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [6:0] select_2046;
  assign select_2046 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1301
  logic equal_2049;
  assign equal_2049 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1274
  logic not_2056;
  assign not_2056 = ~marks_first_s19_q;
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2077;
  assign select_2077 = age_s19_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2093;
  assign not_2093 = ~region_row_s19_q[2];
  logic [2:0] select_2094;
  assign select_2094 = region_row_s19_q[1] ? {1'b0, not_2093, 1'b0} : {region_row_s19_q[2], 1'b0, not_2093};
  logic [5:0] select_2095;
  assign select_2095 = region_row_s19_q[0] ? {select_2094[2], 1'b0, select_2094[1], 1'b0, select_2094[0], 1'b0} : {1'b0, select_2094[2], 1'b0, select_2094[1], 1'b0, select_2094[0]};
  logic [11:0] select_2096;
  assign select_2096 = or_2092_s19_q ? {select_2095[5], 1'b0, select_2095[4], 1'b0, select_2095[3], 1'b0, select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0], 1'b0} : {1'b0, select_2095[5], 1'b0, select_2095[4], 1'b0, select_2095[3], 1'b0, select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0]};
  logic [23:0] select_2097;
  assign select_2097 = or_2089_s19_q ? {select_2096[11], 1'b0, select_2096[10], 1'b0, select_2096[9], 1'b0, select_2096[8], 1'b0, select_2096[7], 1'b0, select_2096[6], 1'b0, select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0], 1'b0} : {1'b0, select_2096[11], 1'b0, select_2096[10], 1'b0, select_2096[9], 1'b0, select_2096[8], 1'b0, select_2096[7], 1'b0, select_2096[6], 1'b0, select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0]};
  // hls/stages/agreement.hpp:1096
  logic [4:0] around;
  assign around = {difference_2112_s19_q[3], difference_2112_s19_q} + (equal_570_s19_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1097
  logic [4:0] n;
  assign n = {difference_2128_s19_q[3], difference_2128_s19_q} + (equal_570_s19_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:219
  logic [13:0] detail;
  assign detail = {3'h0, size_s19_q} + (equal_553_s19_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2184;
  assign select_2184 = sample_pair_whole_s19_q ? (and_548_s19_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:219
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s19_q} + (equal_553_s19_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2192;
  assign select_2192 = sample_pair_whole_s19_q ? (and_548_s19_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:520
  logic select_2225;
  assign select_2225 = and_550_s19_q ? census_columns_values_0_cell_2_mask_s19_q : census_columns_values_1_cell_2_mask_q;
  logic select_2241;
  assign select_2241 = and_550_s19_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2244;
  assign select_2244 = and_550_s19_q ? census_columns_values_1_cell_3_mask_s19_q : census_columns_values_2_cell_3_mask_q;
  logic select_2247;
  assign select_2247 = and_550_s19_q ? census_columns_values_1_cell_4_mask_s19_q : census_columns_values_2_cell_4_mask_q;
  logic select_2248;
  assign select_2248 = and_550_s19_q ? census_columns_values_2_cell_0_mask_s19_q : census_columns_values_3_cell_0_mask_q;
  logic select_2251;
  assign select_2251 = and_550_s19_q ? census_columns_values_2_cell_1_mask_s19_q : census_columns_values_3_cell_1_mask_q;
  logic select_2252;
  assign select_2252 = and_550_s19_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2255;
  assign select_2255 = and_550_s19_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:283
  logic [10:0] sum_2268;
  assign sum_2268 = sum_2264_s19_q + {1'b0, sum_2267_s19_q};
  // hls/stages/moments.hpp:117
  logic [13:0] select_2299;
  assign select_2299 = equal_2298_s19_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2301;
  assign select_2301 = equal_2298_s19_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2312;
  assign sum_2312 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2322;
  assign sum_2322 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/agreement.hpp:520
  logic select_2365;
  assign select_2365 = and_550_s19_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:370
  logic and_2368;
  assign and_2368 = whole_2_s19_q & (~(last_s19_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:457
  logic and_2374;
  assign and_2374 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s19_q[8:2]));
  logic and_2375;
  assign and_2375 = and_2368 & and_2374;
  logic and_2386;
  assign and_2386 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s19_q[8:2]));
  logic and_2387;
  assign and_2387 = and_2368 & and_2386;
  // hls/stages/census.hpp:424
  logic not_2404;
  assign not_2404 = ~x_s19_q[1];
  logic [2:0] select_2405;
  assign select_2405 = x_s19_q[0] ? {1'b0, not_2404, 1'b0} : {x_s19_q[1], 1'b0, not_2404};
  logic [5:0] select_2406;
  assign select_2406 = slot_s19_q[2] ? {select_2405[2], 1'b0, select_2405[1], 1'b0, select_2405[0], 1'b0} : {1'b0, select_2405[2], 1'b0, select_2405[1], 1'b0, select_2405[0]};
  logic [11:0] select_2407;
  assign select_2407 = slot_s19_q[1] ? {select_2406[5], 1'b0, select_2406[4], 1'b0, select_2406[3], 1'b0, select_2406[2], 1'b0, select_2406[1], 1'b0, select_2406[0], 1'b0} : {1'b0, select_2406[5], 1'b0, select_2406[4], 1'b0, select_2406[3], 1'b0, select_2406[2], 1'b0, select_2406[1], 1'b0, select_2406[0]};
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2605;
  assign select_2605 = and_2597_s19_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2603_s19_q});
  logic [13:0] select_2620;
  assign select_2620 = and_2597_s19_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2618_s19_q});
  // hls/stages/agreement.hpp:1095
  logic [4:0] e;
  assign e = {difference_2632_s19_q[3], difference_2632_s19_q} + (equal_570_s19_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2718;
  assign select_2718 = and_2597_s19_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2716_s19_q});
  logic [13:0] select_2725;
  assign select_2725 = and_2597_s19_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2723_s19_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2775;
  assign select_2775 = equal_1704_s19_q ? (and_2758_s19_q ? residual_s19_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_2782;
  assign and_2782 = not_576_s19_q & (so_s19_q & (and_2758_s19_q & equal_1704_s19_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2784;
  assign select_2784 = and_2757_s19_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2782});
  // hls/stages/registration.hpp:107
  logic and_2786;
  assign and_2786 = and_2758_s19_q & ($signed(residual_s19_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2788;
  assign select_2788 = so_s19_q ? (equal_1704_s19_q ? {and_2786, and_2758_s19_q} : 2'h0) : 2'h0;
  logic [1:0] select_2796;
  assign select_2796 = so_s19_q ? (equal_1704_s19_q ? {and_2794_s19_q, and_2758_s19_q} : 2'h0) : 2'h0;
  logic [1:0] select_2797;
  assign select_2797 = equal_575_s19_q ? 2'h0 : select_2796;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2798;
  assign sum_2798 = registration_half_votes_up_q + {{5{select_2797[1]}}, select_2797};
  // hls/stages/registration.hpp:205
  logic less_2800;
  assign less_2800 = $signed(residual_s19_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2801;
  assign and_2801 = and_2758_s19_q & less_2800;
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2803;
  assign select_2803 = so_s19_q ? (equal_1704_s19_q ? {and_2801, and_2758_s19_q} : 2'h0) : 2'h0;
  logic [1:0] select_2810;
  assign select_2810 = so_s19_q ? (equal_1704_s19_q ? {and_2808_s19_q, and_2758_s19_q} : 2'h0) : 2'h0;
  logic [1:0] select_2811;
  assign select_2811 = equal_575_s19_q ? 2'h0 : select_2810;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2812;
  assign sum_2812 = registration_half_half_votes_up_q + {{5{select_2811[1]}}, select_2811};
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2853;
  assign select_2853 = or_1643_s19_q ? 12'h0 : (equal_2851_s19_q ? registration_sums_rdata_s19_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2855;
  assign select_2855 = equal_1608_s19_q ? 12'h0 : (less_1639_s19_q ? select_2853 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2858;
  assign and_2858 = x_s19_q[1] & all_s19_q;
  // hls/stages/agreement.hpp:1142
  logic and_2861;
  assign and_2861 = not_1996_s19_q & (less_1639_s19_q & ({and_2858, x_s19_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2868;
  assign select_2868 = or_1643_s19_q ? 12'h0 : (equal_2851_s19_q ? registration_sums_rdata_s19_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2870;
  assign select_2870 = equal_1608_s19_q ? 12'h0 : (less_1639_s19_q ? select_2868 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2876;
  assign not_2876 = ~all_s19_q;
  // hls/stages/agreement.hpp:1142
  logic and_2879;
  assign and_2879 = not_1996_s19_q & (less_1639_s19_q & (x_s19_q[2:0] == {all_s19_q, not_2876, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2885;
  assign and_2885 = equal_575_s19_q & (x_s19_q[6] & (not_1996_s19_q & (less_1639_s19_q & all_s19_q)));
  // hls/stages/registration.hpp:157
  logic equal_2912;
  assign equal_2912 = x_s19_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2915;
  assign and_2915 = not_1996_s19_q & (less_1639_s19_q & (x_s19_q[5] ? x_s19_q[3] : equal_2912));
  logic and_2924;
  assign and_2924 = not_1996_s19_q & (less_1639_s19_q & ((~x_s19_q[5]) & (x_s19_q[3] & equal_2912)));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3019;
  assign select_3019 = sample_pair_whole_s19_q ? (equal_1694_s19_q ? patches_place_0_slope_q : select_1808[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3024;
  assign select_3024 = sample_pair_whole_s19_q ? (equal_1694_s19_q ? patches_place_1_slope_q : select_1836[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:185
  logic [2:0] select_3143;
  assign select_3143 = equal_1790_s19_q ? 3'h0 : (or_1794_s19_q ? select_3141_s19_q : 3'h0);
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3146;
  assign sum_3146 = {7'h0, patches_set_q} + (equal_1793_s19_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3226;
  assign xor_3226 = xor_3213_s19_q ^ xor_3225_s19_q;
  // hls/stages/count_bits.hpp:25
  logic or_3351;
  assign or_3351 = (xor_3213_s19_q & xor_3225_s19_q) | (xor_3201_s19_q & (xor_3213_s19_q | xor_3225_s19_q));
  // hls/stages/patches.hpp:584
  logic [1:0] sum_3640;
  assign sum_3640 = {1'b0, not_3636_s19_q} + {1'b0, not_3639_s19_q};
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3647;
  assign sum_3647 = {1'b0, not_3643_s19_q} + {1'b0, not_3646_s19_q};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3640} + {1'b0, sum_3647};
  // hls/stages/patches.hpp:598
  logic [7:0] select_3651;
  assign select_3651 = patches_second_s19_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:597
  logic [3:0] sum_3652;
  assign sum_3652 = {2'h0, select_3585_s19_q[14:13]} + 4'hf;
  logic [5:0] select_3653;
  assign select_3653 = patches_second_s19_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3654;
  assign sum_3654 = {select_3653[5], select_3653} + {{4{sum_3652[3]}}, sum_3652[3:1]};
  // hls/stages/agreement.hpp:1188
  logic or_3928;
  assign or_3928 = ({counts_textured_s19_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s19_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = less_3932_s19_q | (product_rest_q & equal_3933_s19_q);
  // hls/stages/agreement.hpp:1227
  logic select_3936;
  assign select_3936 = and_3931_s19_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3939;
  assign sum_3939 = {1'b0, select_2651_s19_q} + {2'h0, select_2651_s19_q[9:1]};
  // hls/stages/agreement.hpp:788
  logic select_3992;
  assign select_3992 = equal_575_s19_q ? (equal_3706_s19_q ? sum_4_s19_q : (product_rest_q | sum_4_s19_q)) : product_rest_q;
  logic [2:0] select_4010;
  assign select_4010 = ends_cell_s19_q ? textured_2_s19_q : box_textured_columns_values_0_q;
  logic [2:0] select_4012;
  assign select_4012 = equal_575_s19_q ? box_textured_columns_values_0_q : (so_s19_q ? select_4010 : box_textured_columns_values_0_q);
  logic [2:0] select_4013;
  assign select_4013 = ends_cell_s19_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4015;
  assign select_4015 = equal_575_s19_q ? box_textured_columns_values_1_q : (so_s19_q ? select_4013 : box_textured_columns_values_1_q);
  logic [2:0] select_4016;
  assign select_4016 = ends_cell_s19_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4018;
  assign select_4018 = equal_575_s19_q ? box_textured_columns_values_2_q : (so_s19_q ? select_4016 : box_textured_columns_values_2_q);
  logic [2:0] select_4019;
  assign select_4019 = ends_cell_s19_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4021;
  assign select_4021 = equal_575_s19_q ? box_textured_columns_values_3_q : (so_s19_q ? select_4019 : box_textured_columns_values_3_q);
  logic [2:0] select_4022;
  assign select_4022 = ends_cell_s19_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4024;
  assign select_4024 = equal_575_s19_q ? box_textured_columns_values_4_q : (so_s19_q ? select_4022 : box_textured_columns_values_4_q);
  logic [4:0] select_4044;
  assign select_4044 = so_s19_q ? (ends_cell_s19_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4045;
  assign select_4045 = equal_575_s19_q ? box_explained_sum_sums_values_0_q : select_4044;
  logic [4:0] select_4062;
  assign select_4062 = so_s19_q ? (ends_cell_s19_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4080;
  assign select_4080 = so_s19_q ? (ends_cell_s19_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1300
  logic [3:0] select_4112;
  assign select_4112 = select_2043_s19_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4118;
  assign select_4118 = marks_first_s19_q ? (less_4114 ? {sum_4115, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4193;
  assign select_4193 = equal_1630_s19_q ? {2'h0, counts_explained_s19_q, 2'h0, counts_textured_s19_q} : (equal_4191_s19_q ? registration_sums_rdata_s19_q : 32'h0);
  logic [31:0] select_4194;
  assign select_4194 = equal_1628_s19_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4193;

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s19_q, or_1994_s19_q, or_1991_s19_q, or_1988_s19_q};
  logic regions_we;
  assign regions_we = s19_en & and_2028_s19_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2027_s19_q, sum_2017_s19_q, sum_2012_s19_q};
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
    end else if (s19_en) begin
      moments_before_0_q <= equal_575_s19_q ? select_2299 : moments_before_0_q;
      moments_before_1_q <= equal_575_s19_q ? select_2301 : moments_before_1_q;
      sharpness_before_last_mask_q <= select_2365;
      counts_supervised_q <= select_2605;
      counts_nearer_q <= select_2620;
      counts_turned_left_q <= select_2718;
      counts_turned_right_q <= select_2725;
      registration_half_measured_q <= select_2784;
      registration_half_votes_up_q <= and_2757_s19_q ? 7'h0 : sum_2798;
      registration_half_half_votes_up_q <= and_2757_s19_q ? 7'h0 : sum_2812;
      patches_place_0_column_q <= sample_pair_whole_s19_q ? select_1809 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s19_q ? select_1810 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3019;
      patches_place_1_column_q <= sample_pair_whole_s19_q ? select_1837 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s19_q ? select_1838 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3024;
      patches_set_q <= equal_1788_s19_q ? 3'h0 : select_3143;
      patches_size_q <= sum_3146;
      product_rest_q <= select_3992;
      disagree_q <= equal_575_s19_q ? select_3936 : disagree_q;
      began_q <= not_2056 & (began_q | select_2043_s19_q);
      seen_x_q <= select_2043_s19_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s19_q ? 4'h0 : select_4112;
      seen_column_q <= select_2043_s19_q ? 8'h0 : (seen_column_q + {7'h0, equal_2049});
      seen_rows_left_q <= select_4118;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s19_q ? 13'h0 : (seen_base_q + {6'h0, select_2046});
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
    if (s19_en) begin
      averager_detail_0_q <= select_2184;
      averager_detail_1_q <= select_2192;
      census_columns_values_1_cell_2_mask_q <= select_2225;
      census_columns_values_2_cell_2_mask_q <= select_2241;
      census_columns_values_2_cell_3_mask_q <= select_2244;
      census_columns_values_2_cell_4_mask_q <= select_2247;
      census_columns_values_3_cell_0_mask_q <= select_2248;
      census_columns_values_3_cell_1_mask_q <= select_2251;
      census_columns_values_3_cell_2_mask_q <= select_2252;
      census_columns_values_3_cell_3_mask_q <= select_2255;
      sharpness_last_mask_q <= and_550_s19_q ? whole_2_s19_q : sharpness_last_mask_q;
      box_textured_columns_values_0_q <= select_4012;
      box_textured_columns_values_1_q <= select_4015;
      box_textured_columns_values_2_q <= select_4018;
      box_textured_columns_values_3_q <= select_4021;
      box_textured_columns_values_4_q <= select_4024;
      box_explained_sum_sums_values_0_q <= select_4045;
      box_shown_sum_sums_values_0_q <= equal_575_s19_q ? box_shown_sum_sums_values_0_q : select_4062;
      box_nearer_sum_sums_values_0_q <= equal_575_s19_q ? box_nearer_sum_sums_values_0_q : select_4080;
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
  logic [6:0] x_s20_q;
  logic slot_s20_q;
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
  logic [2:0] select_508_s20_q;
  logic [6:0] last_s20_q;
  logic and_550_s20_q;
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
  logic whole_16_s20_q;
  logic and_710_s20_q;
  logic [11:0] sum_725_s20_q;
  logic [9:0] sum_728_s20_q;
  logic and_736_s20_q;
  logic and_740_s20_q;
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
  logic select_1804_s20_q;
  logic [8:0] sum_1807_s20_q;
  logic [8:0] sum_1811_s20_q;
  logic [4:0] select_1818_s20_q;
  logic select_1824_s20_q;
  logic [8:0] sum_1839_s20_q;
  logic equal_1853_s20_q;
  logic equal_1857_s20_q;
  logic [3:0] select_1862_s20_q;
  logic less_1966_s20_q;
  logic equal_1967_s20_q;
  logic not_1968_s20_q;
  logic equal_1969_s20_q;
  logic not_1996_s20_q;
  logic not_2056_s20_q;
  logic [7:0] sum_2066_s20_q;
  logic [3:0] difference_2078_s20_q;
  logic or_2086_s20_q;
  logic [23:0] select_2097_s20_q;
  logic [4:0] around_s20_q;
  logic less_2131_s20_q;
  logic and_2142_s20_q;
  logic [11:0] sum_2272_s20_q;
  logic [9:0] sum_2275_s20_q;
  logic equal_2283_s20_q;
  logic equal_2298_s20_q;
  logic [13:0] select_2306_s20_q;
  logic not_2314_s20_q;
  logic not_2317_s20_q;
  logic not_2324_s20_q;
  logic not_2327_s20_q;
  logic [27:0] select_2362_s20_q;
  logic and_2375_s20_q;
  logic and_2387_s20_q;
  logic [8:0] select_2394_s20_q;
  logic [8:0] select_2398_s20_q;
  logic equal_2401_s20_q;
  logic less_2402_s20_q;
  logic [11:0] select_2407_s20_q;
  logic equal_2445_s20_q;
  logic equal_2472_s20_q;
  logic and_2597_s20_q;
  logic not_2622_s20_q;
  logic [4:0] e_s20_q;
  logic [9:0] select_2648_s20_q;
  logic [9:0] select_2651_s20_q;
  logic and_2699_s20_q;
  logic and_2757_s20_q;
  logic [7:0] select_2777_s20_q;
  logic [1:0] select_2789_s20_q;
  logic [1:0] select_2804_s20_q;
  logic [11:0] select_2855_s20_q;
  logic and_2863_s20_q;
  logic [11:0] select_2870_s20_q;
  logic and_2881_s20_q;
  logic and_2885_s20_q;
  logic and_2917_s20_q;
  logic and_2925_s20_q;
  logic parity_3230_s20_q;
  logic or_3234_s20_q;
  logic or_3238_s20_q;
  logic or_3242_s20_q;
  logic or_3249_s20_q;
  logic or_3253_s20_q;
  logic or_3257_s20_q;
  logic or_3264_s20_q;
  logic or_3268_s20_q;
  logic or_3272_s20_q;
  logic or_3282_s20_q;
  logic or_3286_s20_q;
  logic or_3290_s20_q;
  logic or_3298_s20_q;
  logic or_3302_s20_q;
  logic or_3306_s20_q;
  logic or_3313_s20_q;
  logic or_3317_s20_q;
  logic or_3321_s20_q;
  logic or_3331_s20_q;
  logic or_3335_s20_q;
  logic or_3339_s20_q;
  logic and_3343_s20_q;
  logic or_3347_s20_q;
  logic or_3351_s20_q;
  logic equal_3466_s20_q;
  logic [4:0] select_3554_s20_q;
  logic [12:0] select_3585_s20_q;
  logic [9:0] select_3595_s20_q;
  logic less_3628_s20_q;
  logic [2:0] fraction_s20_q;
  logic [7:0] select_3651_s20_q;
  logic sum_3652_s20_q;
  logic [6:0] sum_3654_s20_q;
  logic equal_3706_s20_q;
  logic equal_3925_s20_q;
  logic or_3928_s20_q;
  logic select_3936_s20_q;
  logic not_3941_s20_q;
  logic equal_3950_s20_q;
  logic equal_3952_s20_q;
  logic equal_3953_s20_q;
  logic equal_3954_s20_q;
  logic equal_3955_s20_q;
  logic equal_4095_s20_q;
  logic [31:0] select_4194_s20_q;
  logic [9:0] select_4201_s20_q;
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
      census_columns_values_1_cell_2_of_skin_s20_q <= census_columns_values_1_cell_2_of_skin_s19_q;
      census_columns_values_2_cell_4_mask_s20_q <= census_columns_values_2_cell_4_mask_q;
      census_columns_values_3_cell_0_mask_s20_q <= census_columns_values_3_cell_0_mask_q;
      census_columns_values_3_cell_1_mask_s20_q <= census_columns_values_3_cell_1_mask_q;
      census_columns_values_3_cell_2_mask_s20_q <= census_columns_values_3_cell_2_mask_q;
      census_columns_values_3_cell_3_mask_s20_q <= census_columns_values_3_cell_3_mask_q;
      x_s20_q <= x_s19_q[6:0];
      slot_s20_q <= slot_s19_q[0];
      ends_cell_s20_q <= ends_cell_s19_q;
      lower_half_s20_q <= lower_half_s19_q;
      counts_nearer_s20_q <= counts_nearer_q;
      counts_turned_left_s20_q <= counts_turned_left_q[13:2];
      counts_turned_right_s20_q <= counts_turned_right_q[13:2];
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
      select_508_s20_q <= select_508_s19_q[2:0];
      last_s20_q <= last_s19_q;
      and_550_s20_q <= and_550_s19_q;
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
      whole_16_s20_q <= whole_16;
      and_710_s20_q <= census_columns_values_1_cell_2_mask_q & and_684_s19_q;
      sum_725_s20_q <= {1'b0, sum_721} + {2'h0, sum_724_s19_q};
      sum_728_s20_q <= sum_728_s19_q;
      and_736_s20_q <= and_736;
      and_740_s20_q <= and_736 & less_739_s19_q;
      less_741_s20_q <= less_741_s19_q;
      less_745_s20_q <= less_745_s19_q;
      less_747_s20_q <= less_747_s19_q;
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
      select_1804_s20_q <= select_1804_s19_q[0];
      sum_1807_s20_q <= {1'b0, select_511_s19_q, select_508_s19_q[3]} + 9'h1;
      sum_1811_s20_q <= {1'b0, select_1809} + {{3{select_1810[5]}}, select_1810};
      select_1818_s20_q <= select_1818_s19_q;
      select_1824_s20_q <= select_1824_s19_q;
      sum_1839_s20_q <= {1'b0, select_1837} + {{3{select_1838[5]}}, select_1838};
      equal_1853_s20_q <= equal_1853;
      equal_1857_s20_q <= equal_1857;
      select_1862_s20_q <= select_1862_s19_q;
      less_1966_s20_q <= less_1966_s19_q;
      equal_1967_s20_q <= equal_1967_s19_q;
      not_1968_s20_q <= not_1968_s19_q;
      equal_1969_s20_q <= equal_1969_s19_q;
      not_1996_s20_q <= not_1996_s19_q;
      not_2056_s20_q <= not_2056;
      sum_2066_s20_q <= {2'h0, x_s19_q[7:2]} + 8'hff;
      difference_2078_s20_q <= {1'b0, textured_2_s19_q} - {1'b0, select_2077};
      or_2086_s20_q <= or_2086_s19_q;
      select_2097_s20_q <= select_2097;
      around_s20_q <= around;
      less_2131_s20_q <= {1'b0, around[4:1]} < n;
      and_2142_s20_q <= and_2142_s19_q;
      sum_2272_s20_q <= {1'b0, sum_2268} + {2'h0, sum_2271_s19_q};
      sum_2275_s20_q <= sum_2275_s19_q;
      equal_2283_s20_q <= equal_2283_s19_q;
      equal_2298_s20_q <= equal_2298_s19_q;
      select_2306_s20_q <= (select_2301 < select_2299) ? select_2299 : select_2301;
      not_2314_s20_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2312);
      not_2317_s20_q <= ~({3'h0, select_2301[13:2]} < sum_2312);
      not_2324_s20_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2322);
      not_2327_s20_q <= ~({3'h0, select_2299[13:2]} < sum_2322);
      select_2362_s20_q <= sample_pair_whole_s19_q ? {detail_2, detail} : 28'h0;
      and_2375_s20_q <= and_2375;
      and_2387_s20_q <= and_2387;
      select_2394_s20_q <= and_2375 ? contrast_s19_q : 9'h0;
      select_2398_s20_q <= and_2387 ? contrast_2_s19_q : 9'h0;
      equal_2401_s20_q <= x_s19_q[7:3] == 5'h0;
      less_2402_s20_q <= 7'h2 < {x_s19_q[4:0], slot_s19_q[2:1]};
      select_2407_s20_q <= select_2407;
      equal_2445_s20_q <= {x_s19_q[4:0], slot_s19_q} == 8'h0;
      equal_2472_s20_q <= equal_2472_s19_q;
      and_2597_s20_q <= and_2597_s19_q;
      not_2622_s20_q <= not_2622_s19_q;
      e_s20_q <= e;
      select_2648_s20_q <= select_2648_s19_q;
      select_2651_s20_q <= select_2651_s19_q;
      and_2699_s20_q <= and_2699_s19_q;
      and_2757_s20_q <= and_2757_s19_q;
      select_2777_s20_q <= equal_575_s19_q ? 8'h0 : (so_s19_q ? select_2775 : 8'h0);
      select_2789_s20_q <= equal_575_s19_q ? 2'h0 : select_2788;
      select_2804_s20_q <= equal_575_s19_q ? 2'h0 : select_2803;
      select_2855_s20_q <= select_2855;
      and_2863_s20_q <= equal_575_s19_q & (x_s19_q[6] & and_2861);
      select_2870_s20_q <= select_2870;
      and_2881_s20_q <= equal_575_s19_q & (x_s19_q[6] & and_2879);
      and_2885_s20_q <= and_2885;
      and_2917_s20_q <= equal_575_s19_q & (x_s19_q[6] & and_2915);
      and_2925_s20_q <= x_s19_q[6] & and_2924;
      parity_3230_s20_q <= ^{xor_3226, xor_3189_s19_q, select_3156_s19_q, other_s19_q};
      or_3234_s20_q <= or_3234_s19_q;
      or_3238_s20_q <= or_3238_s19_q;
      or_3242_s20_q <= or_3242_s19_q;
      or_3249_s20_q <= or_3249_s19_q;
      or_3253_s20_q <= or_3253_s19_q;
      or_3257_s20_q <= or_3257_s19_q;
      or_3264_s20_q <= or_3264_s19_q;
      or_3268_s20_q <= or_3268_s19_q;
      or_3272_s20_q <= or_3272_s19_q;
      or_3282_s20_q <= or_3282_s19_q;
      or_3286_s20_q <= or_3286_s19_q;
      or_3290_s20_q <= or_3290_s19_q;
      or_3298_s20_q <= or_3298_s19_q;
      or_3302_s20_q <= or_3302_s19_q;
      or_3306_s20_q <= or_3306_s19_q;
      or_3313_s20_q <= or_3313_s19_q;
      or_3317_s20_q <= or_3317_s19_q;
      or_3321_s20_q <= or_3321_s19_q;
      or_3331_s20_q <= or_3331_s19_q;
      or_3335_s20_q <= or_3335_s19_q;
      or_3339_s20_q <= or_3339_s19_q;
      and_3343_s20_q <= xor_3189_s19_q & (^{xor_3226, select_3156_s19_q, other_s19_q});
      or_3347_s20_q <= and_3344_s19_q | (xor_3171_s19_q & or_3345_s19_q);
      or_3351_s20_q <= or_3351;
      equal_3466_s20_q <= equal_3466_s19_q;
      select_3554_s20_q <= select_3554_s19_q;
      select_3585_s20_q <= select_3585_s19_q[12:0];
      select_3595_s20_q <= select_3595_s19_q;
      less_3628_s20_q <= less_3628_s19_q;
      fraction_s20_q <= fraction;
      select_3651_s20_q <= select_3651;
      sum_3652_s20_q <= sum_3652[0];
      sum_3654_s20_q <= sum_3654;
      equal_3706_s20_q <= equal_3706_s19_q;
      equal_3925_s20_q <= select_2648_s19_q[9:3] == 7'h0;
      or_3928_s20_q <= or_3928;
      select_3936_s20_q <= select_3936;
      not_3941_s20_q <= ~({sum_3939, select_2651_s19_q[0]} < {2'h0, select_2648_s19_q});
      equal_3950_s20_q <= equal_3950_s19_q;
      equal_3952_s20_q <= equal_3952_s19_q;
      equal_3953_s20_q <= equal_3953_s19_q;
      equal_3954_s20_q <= equal_3954_s19_q;
      equal_3955_s20_q <= equal_3955_s19_q;
      equal_4095_s20_q <= equal_4095_s19_q;
      select_4194_s20_q <= select_4194;
      select_4201_s20_q <= select_4201_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:281
  logic [11:0] texture;
  assign texture = sum_725_s20_q + {2'h0, sum_728_s20_q};
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1614_s20_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1667;
  assign select_1667 = equal_1665_s20_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1806;
  assign select_1806 = equal_1694_s20_q ? patches_place_0_valid_q : (select_1693_s20_q ? patches_place_0_valid_q : select_1804_s20_q);
  // hls/stages/patches.hpp:132
  logic equal_1812;
  assign equal_1812 = {sum_1811_s20_q, sum_1807_s20_q[0], select_508_s20_q} == {1'b0, sum_1807_s20_q[8:1], 4'h0};
  // hls/stages/patches.hpp:127
  logic select_1835;
  assign select_1835 = equal_1694_s20_q ? patches_place_1_valid_q : (select_1693_s20_q ? select_1804_s20_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:132
  logic equal_1840;
  assign equal_1840 = {sum_1839_s20_q[8], sum_1807_s20_q, select_508_s20_q} == {1'b0, sum_1839_s20_q[7:0], 4'h0};
  // hls/stages/agreement.hpp:1308
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1275
  logic select_2054;
  assign select_2054 = marks_first_s20_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2055;
  assign sum_2055 = {1'b0, {5{select_2054}}, 1'b0, {2{select_2054}}, 1'b0, select_2054} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1111
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2066_s20_q[7]}}, sum_2066_s20_q, x_s20_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [10:0] sum_2068;
  assign sum_2068 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1094
  logic [4:0] t;
  assign t = {difference_2078_s20_q[3], difference_2078_s20_q} + (equal_570_s20_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic [47:0] select_2098;
  assign select_2098 = or_2086_s20_q ? {select_2097_s20_q[23], 1'b0, select_2097_s20_q[22], 1'b0, select_2097_s20_q[21], 1'b0, select_2097_s20_q[20], 1'b0, select_2097_s20_q[19], 1'b0, select_2097_s20_q[18], 1'b0, select_2097_s20_q[17], 1'b0, select_2097_s20_q[16], 1'b0, select_2097_s20_q[15], 1'b0, select_2097_s20_q[14], 1'b0, select_2097_s20_q[13], 1'b0, select_2097_s20_q[12], 1'b0, select_2097_s20_q[11], 1'b0, select_2097_s20_q[10], 1'b0, select_2097_s20_q[9], 1'b0, select_2097_s20_q[8], 1'b0, select_2097_s20_q[7], 1'b0, select_2097_s20_q[6], 1'b0, select_2097_s20_q[5], 1'b0, select_2097_s20_q[4], 1'b0, select_2097_s20_q[3], 1'b0, select_2097_s20_q[2], 1'b0, select_2097_s20_q[1], 1'b0, select_2097_s20_q[0], 1'b0} : {1'b0, select_2097_s20_q[23], 1'b0, select_2097_s20_q[22], 1'b0, select_2097_s20_q[21], 1'b0, select_2097_s20_q[20], 1'b0, select_2097_s20_q[19], 1'b0, select_2097_s20_q[18], 1'b0, select_2097_s20_q[17], 1'b0, select_2097_s20_q[16], 1'b0, select_2097_s20_q[15], 1'b0, select_2097_s20_q[14], 1'b0, select_2097_s20_q[13], 1'b0, select_2097_s20_q[12], 1'b0, select_2097_s20_q[11], 1'b0, select_2097_s20_q[10], 1'b0, select_2097_s20_q[9], 1'b0, select_2097_s20_q[8], 1'b0, select_2097_s20_q[7], 1'b0, select_2097_s20_q[6], 1'b0, select_2097_s20_q[5], 1'b0, select_2097_s20_q[4], 1'b0, select_2097_s20_q[3], 1'b0, select_2097_s20_q[2], 1'b0, select_2097_s20_q[1], 1'b0, select_2097_s20_q[0]};
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2115;
  assign sum_2115 = {1'b0, around_s20_q} + {2'h0, around_s20_q[4:1]};
  // hls/stages/agreement.hpp:520
  logic select_2256;
  assign select_2256 = and_550_s20_q ? census_columns_values_2_cell_4_mask_s20_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:283
  logic [11:0] sum_2276;
  assign sum_2276 = sum_2272_s20_q + {2'h0, sum_2275_s20_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2278;
  assign select_2278 = and_550_s20_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2279;
  assign select_2279 = and_550_s20_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2308;
  assign sum_2308 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:520
  logic [13:0] select_2363;
  assign select_2363 = and_550_s20_q ? select_2362_s20_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2364;
  assign select_2364 = and_550_s20_q ? select_2362_s20_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:369
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2362_s20_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2362_s20_q[27:14]};
  // hls/stages/census.hpp:372
  logic [23:0] sum_2395;
  assign sum_2395 = (equal_2283_s20_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2394_s20_q};
  logic [23:0] sum_2399;
  assign sum_2399 = (equal_2283_s20_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2398_s20_q};
  // hls/stages/census.hpp:424
  logic less_2403;
  assign less_2403 = x_s20_q[4:0] < 5'h3;
  logic [23:0] select_2408;
  assign select_2408 = slot_s20_q ? {select_2407_s20_q[11], 1'b0, select_2407_s20_q[10], 1'b0, select_2407_s20_q[9], 1'b0, select_2407_s20_q[8], 1'b0, select_2407_s20_q[7], 1'b0, select_2407_s20_q[6], 1'b0, select_2407_s20_q[5], 1'b0, select_2407_s20_q[4], 1'b0, select_2407_s20_q[3], 1'b0, select_2407_s20_q[2], 1'b0, select_2407_s20_q[1], 1'b0, select_2407_s20_q[0], 1'b0} : {1'b0, select_2407_s20_q[11], 1'b0, select_2407_s20_q[10], 1'b0, select_2407_s20_q[9], 1'b0, select_2407_s20_q[8], 1'b0, select_2407_s20_q[7], 1'b0, select_2407_s20_q[6], 1'b0, select_2407_s20_q[5], 1'b0, select_2407_s20_q[4], 1'b0, select_2407_s20_q[3], 1'b0, select_2407_s20_q[2], 1'b0, select_2407_s20_q[1], 1'b0, select_2407_s20_q[0]};
  // hls/stages/census.hpp:387
  logic and_2412;
  assign and_2412 = less_2403 & (~((sharpness_sums_contrast_1_q & select_2408) == 24'h0));
  logic and_2422;
  assign and_2422 = less_2403 & (~((sharpness_sums_contrast_0_q & select_2408) == 24'h0));
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2635;
  assign sum_2635 = {1'b0, e_s20_q} + {2'h0, e_s20_q[4:1]};
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2652;
  assign sum_2652 = {1'b0, select_2651_s20_q} + {3'h0, select_2651_s20_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2778;
  assign sum_2778 = registration_half_across_q + {{6{select_2777_s20_q[7]}}, select_2777_s20_q};
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2790;
  assign sum_2790 = registration_half_votes_down_q + {{5{select_2789_s20_q[1]}}, select_2789_s20_q};
  logic [6:0] sum_2805;
  assign sum_2805 = registration_half_half_votes_down_q + {{5{select_2804_s20_q[1]}}, select_2804_s20_q};
  // hls/stages/agreement.hpp:788
  logic and_2846;
  assign and_2846 = equal_575_s20_q & (x_s20_q[6] & (not_1996_s20_q & less_1639_s20_q));
  logic [11:0] select_2857;
  assign select_2857 = equal_575_s20_q ? (x_s20_q[6] ? select_2855_s20_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2865;
  assign sum_2865 = {{2{select_2857[11]}}, select_2857} + (and_2863_s20_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2872;
  assign select_2872 = equal_575_s20_q ? (x_s20_q[6] ? select_2870_s20_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2874;
  assign sum_2874 = {{2{select_2872[11]}}, select_2872} + (and_2863_s20_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2886;
  assign not_2886 = ~and_2885_s20_q;
  logic less_2887;
  assign less_2887 = $signed({9'h1, {2{not_2886}}, and_2885_s20_q}) < $signed(registration_up_q[13:2]);
  logic select_2888;
  assign select_2888 = and_2881_s20_q ? less_2887 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2892;
  assign and_2892 = x_s20_q[6] & (not_1996_s20_q & (less_1639_s20_q & (x_s20_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2893;
  assign and_2893 = equal_575_s20_q & and_2892;
  // hls/stages/registration.hpp:242
  logic less_2894;
  assign less_2894 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2896;
  assign less_2896 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2898;
  assign equal_2898 = x_s20_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2902;
  assign and_2902 = equal_575_s20_q & (x_s20_q[6] & (not_1996_s20_q & (less_1639_s20_q & equal_2898)));
  // hls/stages/agreement.hpp:1142
  logic and_2909;
  assign and_2909 = x_s20_q[6] & (not_1996_s20_q & (less_1639_s20_q & (x_s20_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2927;
  assign and_2927 = registration_votes_up_q & registration_other_down_q;
  logic select_2929;
  assign select_2929 = registration_votes_down_q ? (registration_other_up_q | and_2927) : and_2927;
  // hls/stages/registration.hpp:138
  logic and_2931;
  assign and_2931 = (equal_575_s20_q & and_2925_s20_q) & (registration_other_enough_q & select_2929);
  logic and_2933;
  assign and_2933 = registration_enough_q & ((and_2917_s20_q & (less_2896 | less_2894)) | and_2931);
  // hls/stages/count_bits.hpp:24
  logic parity_3260;
  assign parity_3260 = ^{or_3257_s20_q, or_3253_s20_q, or_3249_s20_q};
  logic parity_3275;
  assign parity_3275 = ^{or_3272_s20_q, or_3268_s20_q, or_3264_s20_q};
  logic parity_3278;
  assign parity_3278 = ^{or_3272_s20_q, or_3268_s20_q, or_3264_s20_q, or_3257_s20_q, or_3253_s20_q, or_3249_s20_q, or_3242_s20_q, or_3238_s20_q, or_3234_s20_q};
  logic parity_3309;
  assign parity_3309 = ^{or_3306_s20_q, or_3302_s20_q, or_3298_s20_q};
  logic parity_3324;
  assign parity_3324 = ^{or_3321_s20_q, or_3317_s20_q, or_3313_s20_q};
  logic parity_3327;
  assign parity_3327 = ^{or_3321_s20_q, or_3317_s20_q, or_3313_s20_q, or_3306_s20_q, or_3302_s20_q, or_3298_s20_q, or_3290_s20_q, or_3286_s20_q, or_3282_s20_q};
  logic parity_3342;
  assign parity_3342 = ^{or_3339_s20_q, or_3335_s20_q, or_3331_s20_q};
  logic parity_3354;
  assign parity_3354 = ^{or_3351_s20_q, or_3347_s20_q, and_3343_s20_q};
  logic parity_3357;
  assign parity_3357 = ^{or_3351_s20_q, or_3347_s20_q, and_3343_s20_q, or_3339_s20_q, or_3335_s20_q, or_3331_s20_q, or_3321_s20_q, or_3317_s20_q, or_3313_s20_q, or_3306_s20_q, or_3302_s20_q, or_3298_s20_q, or_3290_s20_q, or_3286_s20_q, or_3282_s20_q};
  logic parity_3359;
  assign parity_3359 = ^{or_3351_s20_q, or_3347_s20_q, and_3343_s20_q, or_3339_s20_q, or_3335_s20_q, or_3331_s20_q, or_3321_s20_q, or_3317_s20_q, or_3313_s20_q, or_3306_s20_q, or_3302_s20_q, or_3298_s20_q, or_3290_s20_q, or_3286_s20_q, or_3282_s20_q, or_3272_s20_q, or_3268_s20_q, or_3264_s20_q, or_3257_s20_q, or_3253_s20_q, or_3249_s20_q, or_3242_s20_q, or_3238_s20_q, or_3234_s20_q};
  // hls/stages/count_bits.hpp:25
  logic and_3360;
  assign and_3360 = parity_3278 & parity_3357;
  logic and_3363;
  assign and_3363 = (^{or_3242_s20_q, or_3238_s20_q, or_3234_s20_q}) & (parity_3260 | parity_3275);
  logic or_3364;
  assign or_3364 = (parity_3260 & parity_3275) | and_3363;
  logic or_3368;
  assign or_3368 = (parity_3342 & parity_3354) | (parity_3327 & (parity_3342 | parity_3354));
  logic and_3374;
  assign and_3374 = (^{or_3290_s20_q, or_3286_s20_q, or_3282_s20_q}) & (parity_3309 | parity_3324);
  logic or_3375;
  assign or_3375 = (parity_3309 & parity_3324) | and_3374;
  logic or_3379;
  assign or_3379 = (or_3335_s20_q & or_3339_s20_q) | (or_3331_s20_q & (or_3335_s20_q | or_3339_s20_q));
  logic or_3383;
  assign or_3383 = (or_3347_s20_q & or_3351_s20_q) | (and_3343_s20_q & (or_3347_s20_q | or_3351_s20_q));
  // hls/stages/count_bits.hpp:23
  logic or_3390;
  assign or_3390 = (or_3286_s20_q & or_3290_s20_q) | (or_3282_s20_q & (or_3286_s20_q | or_3290_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3394;
  assign or_3394 = (or_3302_s20_q & or_3306_s20_q) | (or_3298_s20_q & (or_3302_s20_q | or_3306_s20_q));
  logic or_3398;
  assign or_3398 = (or_3317_s20_q & or_3321_s20_q) | (or_3313_s20_q & (or_3317_s20_q | or_3321_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3401;
  assign parity_3401 = ^{or_3398, or_3394, or_3390};
  // hls/stages/count_bits.hpp:23
  logic or_3405;
  assign or_3405 = (or_3238_s20_q & or_3242_s20_q) | (or_3234_s20_q & (or_3238_s20_q | or_3242_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3409;
  assign or_3409 = (or_3253_s20_q & or_3257_s20_q) | (or_3249_s20_q & (or_3253_s20_q | or_3257_s20_q));
  logic or_3413;
  assign or_3413 = (or_3268_s20_q & or_3272_s20_q) | (or_3264_s20_q & (or_3268_s20_q | or_3272_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3416;
  assign parity_3416 = ^{or_3413, or_3409, or_3405};
  logic parity_3419;
  assign parity_3419 = ^{or_3413, or_3409, or_3405, or_3398, or_3394, or_3390, or_3383, or_3379, or_3375};
  // hls/stages/patches.hpp:595
  logic [9:0] difference_3598;
  assign difference_3598 = select_3595_s20_q - select_3585_s20_q[9:0];
  // hls/stages/patches.hpp:600
  logic or_3605;
  assign or_3605 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3585_s20_q[9:0]);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3629;
  assign sum_3629 = select_3554_s20_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:587
  logic [7:0] difference_3649;
  assign difference_3649 = {sum_3629, select_3554_s20_q[2:0], 3'h0} - {5'h0, fraction_s20_q};
  logic [7:0] select_3650;
  assign select_3650 = less_3628_s20_q ? difference_3649 : {sum_3629, select_3554_s20_q[2:0], fraction_s20_q};
  // hls/stages/patches.hpp:598
  logic [18:0] product_3655;
  assign product_3655 = $signed({{11{select_3651_s20_q[7]}}, select_3651_s20_q}) * $signed({{8{sum_3654_s20_q[6]}}, sum_3654_s20_q, sum_3652_s20_q, select_3585_s20_q[12:10]});
  // hls/stages/patches.hpp:606
  logic [11:0] sum_3830;
  assign sum_3830 = {sum_3654_s20_q[6], sum_3654_s20_q, sum_3652_s20_q, select_3585_s20_q[12:10]} + 12'h1;
  // hls/stages/agreement.hpp:1135
  logic select_3942;
  assign select_3942 = equal_3925_s20_q ? ((~or_3928_s20_q) & (~select_3936_s20_q)) : not_3941_s20_q;
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3944;
  assign select_3944 = x_s20_q[6] ? (equal_1608_s20_q ? good_q : {select_3942, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:1147
  logic equal_3947;
  assign equal_3947 = x_s20_q == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic [4:0] select_4026;
  assign select_4026 = so_s20_q ? (ends_cell_s20_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:460
  logic [12:0] select_4098;
  assign select_4098 = equal_2472_s20_q ? (equal_4095_s20_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_4101;
  assign select_4101 = and_550_s20_q ? (equal_2472_s20_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
    end else if (s20_en) begin
      moments_most_before_q <= equal_575_s20_q ? select_2306_s20_q : moments_most_before_q;
      moments_left_alone_q <= equal_575_s20_q ? not_2314_s20_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_575_s20_q ? not_2317_s20_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_575_s20_q ? not_2324_s20_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_575_s20_q ? not_2327_s20_q : moments_right_other_stops_q;
      sharpness_sums_contrast_0_q <= and_550_s20_q ? sum_2395 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_550_s20_q ? sum_2399 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2757_s20_q ? 14'h0 : sum_2778;
      registration_half_votes_down_q <= and_2757_s20_q ? 7'h0 : sum_2790;
      registration_half_half_votes_down_q <= and_2757_s20_q ? 7'h0 : sum_2805;
      registration_down_q <= and_2846 ? sum_2865 : registration_down_q;
      registration_up_q <= and_2846 ? sum_2874 : registration_up_q;
      registration_enough_q <= select_2888;
      registration_votes_down_q <= and_2893 ? less_2894 : registration_votes_down_q;
      registration_votes_up_q <= and_2893 ? less_2896 : registration_votes_up_q;
      registration_other_enough_q <= and_2902 ? select_2888 : registration_other_enough_q;
      registration_other_down_q <= and_2902 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2902 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s20_q ? select_1806 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s20_q ? select_1835 : patches_place_1_valid_q;
      good_q <= equal_575_s20_q ? select_3944 : good_q;
      map_row_q <= and_550_s20_q ? select_4098 : map_row_q;
      map_width_q <= select_4101;
      write_half_q <= marks_first_s20_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2054;
      done_q <= not_2056_s20_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s20_q;
      said_q <= equal_575_s20_q & equal_3947;
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
    if (s20_en) begin
      census_columns_values_3_cell_4_mask_q <= select_2256;
      census_changes_values_0_left_q <= and_550_s20_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_550_s20_q ? sum_2276 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2278;
      census_changes_values_1_right_q <= select_2279;
      sharpness_last_detail_0_q <= select_2363;
      sharpness_last_detail_1_q <= select_2364;
      box_textured_sum_sums_values_0_q <= equal_575_s20_q ? box_textured_sum_sums_values_0_q : select_4026;
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
  logic moments_left_alone_s21_q;
  logic moments_left_other_stops_s21_q;
  logic moments_right_alone_s21_q;
  logic moments_right_other_stops_s21_q;
  logic [23:0] sharpness_sums_contrast_0_s21_q;
  logic [23:0] sharpness_sums_contrast_1_s21_q;
  logic [6:0] x_s21_q;
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
  logic and_709_s21_q;
  logic and_710_s21_q;
  logic [12:0] sum_730_s21_q;
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
  logic or_1814_s21_q;
  logic [4:0] select_1818_s21_q;
  logic select_1824_s21_q;
  logic or_1842_s21_q;
  logic or_1855_s21_q;
  logic or_1859_s21_q;
  logic [3:0] select_1862_s21_q;
  logic less_1966_s21_q;
  logic equal_1967_s21_q;
  logic not_1968_s21_q;
  logic equal_1969_s21_q;
  logic not_1996_s21_q;
  logic [2:0] index_s21_q;
  logic [10:0] sum_2055_s21_q;
  logic and_2062_s21_q;
  logic less_2063_s21_q;
  logic [2:0] index_2_s21_q;
  logic [10:0] sum_2068_s21_q;
  logic equal_2081_s21_q;
  logic not_2101_s21_q;
  logic not_2117_s21_q;
  logic less_2131_s21_q;
  logic and_2142_s21_q;
  logic equal_2283_s21_q;
  logic [12:0] sum_2284_s21_q;
  logic equal_2298_s21_q;
  logic not_2310_s21_q;
  logic not_2320_s21_q;
  logic [12:0] select_2377_s21_q;
  logic [12:0] select_2389_s21_q;
  logic equal_2401_s21_q;
  logic less_2402_s21_q;
  logic and_2412_s21_q;
  logic and_2422_s21_q;
  logic equal_2445_s21_q;
  logic and_2597_s21_q;
  logic not_2622_s21_q;
  logic not_2637_s21_q;
  logic [9:0] select_2648_s21_q;
  logic [9:0] select_2651_s21_q;
  logic less_2653_s21_q;
  logic and_2699_s21_q;
  logic equal_2898_s21_q;
  logic not_2911_s21_q;
  logic and_2933_s21_q;
  logic parity_3230_s21_q;
  logic parity_3359_s21_q;
  logic and_3360_s21_q;
  logic or_3364_s21_q;
  logic or_3368_s21_q;
  logic or_3375_s21_q;
  logic or_3379_s21_q;
  logic or_3383_s21_q;
  logic or_3390_s21_q;
  logic or_3394_s21_q;
  logic or_3398_s21_q;
  logic or_3405_s21_q;
  logic or_3409_s21_q;
  logic or_3413_s21_q;
  logic parity_3419_s21_q;
  logic or_3429_s21_q;
  logic or_3433_s21_q;
  logic and_3440_s21_q;
  logic and_3442_s21_q;
  logic and_3444_s21_q;
  logic equal_3466_s21_q;
  logic equal_3597_s21_q;
  logic less_3599_s21_q;
  logic less_3600_s21_q;
  logic or_3605_s21_q;
  logic [7:0] select_3650_s21_q;
  logic [13:0] product_3655_s21_q;
  logic equal_3706_s21_q;
  logic less_3831_s21_q;
  logic or_3928_s21_q;
  logic select_3936_s21_q;
  logic equal_3947_s21_q;
  logic equal_3950_s21_q;
  logic equal_3952_s21_q;
  logic equal_3953_s21_q;
  logic equal_3954_s21_q;
  logic equal_3955_s21_q;
  logic [31:0] select_4194_s21_q;
  logic [9:0] select_4201_s21_q;
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
      moments_left_alone_s21_q <= moments_left_alone_q;
      moments_left_other_stops_s21_q <= moments_left_other_stops_q;
      moments_right_alone_s21_q <= moments_right_alone_q;
      moments_right_other_stops_s21_q <= moments_right_other_stops_q;
      sharpness_sums_contrast_0_s21_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s21_q <= sharpness_sums_contrast_1_q;
      x_s21_q <= x_s20_q;
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
      and_709_s21_q <= whole_22 & and_684_s20_q;
      and_710_s21_q <= and_710_s20_q;
      sum_730_s21_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_736_s21_q <= and_736_s20_q;
      and_740_s21_q <= and_740_s20_q;
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
      or_1814_s21_q <= and_1676_s20_q | (select_1806 & equal_1812);
      select_1818_s21_q <= select_1818_s20_q;
      select_1824_s21_q <= select_1824_s20_q;
      or_1842_s21_q <= and_1676_s20_q | (select_1835 & equal_1840);
      or_1855_s21_q <= and_1676_s20_q | (select_1806 & equal_1853_s20_q);
      or_1859_s21_q <= and_1676_s20_q | (select_1835 & equal_1857_s20_q);
      select_1862_s21_q <= select_1862_s20_q;
      less_1966_s21_q <= less_1966_s20_q;
      equal_1967_s21_q <= equal_1967_s20_q;
      not_1968_s21_q <= not_1968_s20_q;
      equal_1969_s21_q <= equal_1969_s20_q;
      not_1996_s21_q <= not_1996_s20_q;
      index_s21_q <= index[2:0];
      sum_2055_s21_q <= sum_2055;
      and_2062_s21_q <= began_q & (seen_x_q == 4'h0);
      less_2063_s21_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s21_q <= index_2[2:0];
      sum_2068_s21_q <= sum_2068;
      equal_2081_s21_q <= t[4:1] == 4'h0;
      not_2101_s21_q <= ~((good_q & select_2098) == 48'h0);
      not_2117_s21_q <= ~({sum_2115, around_s20_q[0]} < {2'h0, t});
      less_2131_s21_q <= less_2131_s20_q;
      and_2142_s21_q <= and_2142_s20_q;
      equal_2283_s21_q <= equal_2283_s20_q;
      sum_2284_s21_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2276};
      equal_2298_s21_q <= equal_2298_s20_q;
      not_2310_s21_q <= ~({3'h0, counts_turned_left_s20_q} < sum_2308);
      not_2320_s21_q <= ~({3'h0, counts_turned_right_s20_q} < sum_2308);
      select_2377_s21_q <= and_2375_s20_q ? detail_3[14:2] : 13'h0;
      select_2389_s21_q <= and_2387_s20_q ? detail_4[14:2] : 13'h0;
      equal_2401_s21_q <= equal_2401_s20_q;
      less_2402_s21_q <= less_2402_s20_q;
      and_2412_s21_q <= and_2412;
      and_2422_s21_q <= and_2422;
      equal_2445_s21_q <= equal_2445_s20_q;
      and_2597_s21_q <= and_2597_s20_q;
      not_2622_s21_q <= not_2622_s20_q;
      not_2637_s21_q <= ~({sum_2635, e_s20_q[0]} < {2'h0, t});
      select_2648_s21_q <= select_2648_s20_q;
      select_2651_s21_q <= select_2651_s20_q;
      less_2653_s21_q <= {sum_2652, select_2651_s20_q[1:0]} < {3'h0, select_2648_s20_q};
      and_2699_s21_q <= and_2699_s20_q;
      equal_2898_s21_q <= equal_2898;
      not_2911_s21_q <= ~(equal_575_s20_q & and_2909);
      and_2933_s21_q <= and_2933;
      parity_3230_s21_q <= parity_3230_s20_q;
      parity_3359_s21_q <= parity_3359;
      and_3360_s21_q <= and_3360;
      or_3364_s21_q <= or_3364;
      or_3368_s21_q <= or_3368;
      or_3375_s21_q <= or_3375;
      or_3379_s21_q <= or_3379;
      or_3383_s21_q <= or_3383;
      or_3390_s21_q <= or_3390;
      or_3394_s21_q <= or_3394;
      or_3398_s21_q <= or_3398;
      or_3405_s21_q <= or_3405;
      or_3409_s21_q <= or_3409;
      or_3413_s21_q <= or_3413;
      parity_3419_s21_q <= parity_3419;
      or_3429_s21_q <= (or_3394 & or_3398) | (or_3390 & (or_3394 | or_3398));
      or_3433_s21_q <= (or_3409 & or_3413) | (or_3405 & (or_3409 | or_3413));
      and_3440_s21_q <= and_3360 & (or_3364 | or_3368);
      and_3442_s21_q <= parity_3401 & parity_3416;
      and_3444_s21_q <= (^{or_3383, or_3379, or_3375}) & (parity_3401 | parity_3416);
      equal_3466_s21_q <= equal_3466_s20_q;
      equal_3597_s21_q <= select_3554_s20_q[3:0] == 4'h0;
      less_3599_s21_q <= {difference_3598, 3'h0} < {3'h0, patches_size_q};
      less_3600_s21_q <= select_3595_s20_q < select_3585_s20_q[9:0];
      or_3605_s21_q <= or_3605;
      select_3650_s21_q <= select_3650;
      product_3655_s21_q <= product_3655[18:5];
      equal_3706_s21_q <= equal_3706_s20_q;
      less_3831_s21_q <= {{4{sum_3830[11]}}, sum_3830} < 16'h3;
      or_3928_s21_q <= or_3928_s20_q;
      select_3936_s21_q <= select_3936_s20_q;
      equal_3947_s21_q <= equal_3947;
      equal_3950_s21_q <= equal_3950_s20_q;
      equal_3952_s21_q <= equal_3952_s20_q;
      equal_3953_s21_q <= equal_3953_s20_q;
      equal_3954_s21_q <= equal_3954_s20_q;
      equal_3955_s21_q <= equal_3955_s20_q;
      select_4194_s21_q <= select_4194_s20_q;
      select_4201_s21_q <= select_4201_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:292
  logic [13:0] sum_731;
  assign sum_731 = {2'h0, census_changes_values_1_left_s21_q} + {1'b0, sum_730_s21_q};
  logic [13:0] sum_732;
  assign sum_732 = {2'h0, census_changes_values_2_left_q} + sum_731;
  // hls/stages/patches.hpp:134
  logic [5:0] select_1825;
  assign select_1825 = or_1814_s21_q ? {and_1676_s21_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1827;
  assign and_1827 = select_1824_s21_q & (~select_1825[5]);
  // hls/stages/patches.hpp:134
  logic [5:0] select_1844;
  assign select_1844 = or_1842_s21_q ? {and_1676_s21_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1846;
  assign and_1846 = select_1824_s21_q & (~select_1844[5]);
  // hls/stages/patches.hpp:135
  logic [4:0] select_1856;
  assign select_1856 = or_1855_s21_q ? {and_1676_s21_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1860;
  assign select_1860 = or_1859_s21_q ? {and_1676_s21_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1856[4] ? select_1860[3:0] : select_1856[3:0];
  logic and_1865;
  assign and_1865 = select_1824_s21_q & (select_1818_s21_q[3] ^ select_1818_s21_q[4]);
  logic and_1870;
  assign and_1870 = sample_pair_whole_s21_q & (and_1865 & ((~select_1856[4]) | (~select_1860[4])));
  // hls/stages/agreement.hpp:1030
  logic and_2102;
  assign and_2102 = good_known_q & not_2101_s21_q;
  // hls/stages/agreement.hpp:1103
  logic is_seen;
  assign is_seen = equal_2081_s21_q ? and_2102 : not_2117_s21_q;
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2280;
  assign select_2280 = and_550_s21_q ? census_changes_values_1_left_s21_q : census_changes_values_2_left_q;
  logic [11:0] select_2281;
  assign select_2281 = and_550_s21_q ? census_changes_values_1_right_s21_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:293
  logic [13:0] sum_2285;
  assign sum_2285 = {2'h0, census_changes_values_1_right_s21_q} + {1'b0, sum_2284_s21_q};
  logic [13:0] sum_2286;
  assign sum_2286 = {2'h0, census_changes_values_2_right_q} + sum_2285;
  // hls/stages/moments.hpp:94
  logic and_2345;
  assign and_2345 = moments_right_alone_s21_q & (moments_right_begins_q | moments_right_other_stops_s21_q);
  logic or_2347;
  assign or_2347 = moments_left_begins_q | (moments_left_other_stops_s21_q | and_2345);
  logic and_2349;
  assign and_2349 = cfg_same_table_i & (moments_left_alone_s21_q ? or_2347 : and_2345);
  // hls/stages/moments.hpp:95
  logic and_2355;
  assign and_2355 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:372
  logic [23:0] select_2379;
  assign select_2379 = equal_2283_s21_q ? {11'h0, select_2377_s21_q} : (sharpness_sums_detail_0_q + {11'h0, select_2377_s21_q});
  logic [23:0] select_2391;
  assign select_2391 = equal_2283_s21_q ? {11'h0, select_2389_s21_q} : (sharpness_sums_detail_1_q + {11'h0, select_2389_s21_q});
  // hls/stages/census.hpp:392
  logic [17:0] select_2414;
  assign select_2414 = (less_2402_s21_q & and_2412_s21_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2424;
  assign select_2424 = (less_2402_s21_q & and_2422_s21_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:216
  logic [1:0] select_2433;
  assign select_2433 = equal_2401_s21_q ? {sharpness_comparing_contrast_0_q[0], and_2422_s21_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2435;
  assign select_2435 = equal_2401_s21_q ? {sharpness_comparing_contrast_1_q[0], and_2412_s21_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic xor_2458;
  assign xor_2458 = sharpness_comparing_contrast_0_q[1] ^ and_2412_s21_q;
  logic select_2461;
  assign select_2461 = (equal_2445_s21_q | xor_2458) ? (and_2412_s21_q & xor_2458) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2462;
  assign select_2462 = equal_2401_s21_q ? select_2461 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:401
  logic xor_2464;
  assign xor_2464 = sharpness_comparing_contrast_1_q[1] ^ and_2422_s21_q;
  logic select_2467;
  assign select_2467 = (equal_2445_s21_q | xor_2464) ? (and_2422_s21_q & xor_2464) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2468;
  assign select_2468 = equal_2401_s21_q ? select_2467 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1106
  logic not_2639;
  assign not_2639 = ~(equal_2081_s21_q ? and_2102 : not_2637_s21_q);
  // hls/stages/agreement.hpp:788
  logic and_2642;
  assign and_2642 = ends_cell_s21_q & (not_2622_s21_q & (centres_values_1_textured_s21_q & not_2639));
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_2655;
  assign select_2655 = ((~(select_2648_s21_q[9:4] == 6'h0)) & less_2653_s21_q) ? select_2648_s21_q : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2658;
  assign select_2658 = equal_575_s21_q ? (x_s21_q[6] ? (equal_1608_s21_q ? 10'h0 : select_2655) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1110
  logic and_2676;
  assign and_2676 = centres_values_1_textured_s21_q & (centres_values_1_of_skin_s21_q & not_2639);
  // hls/stages/patches.hpp:127
  logic select_3026;
  assign select_3026 = equal_1694_s21_q ? patches_valid_0_q : (select_1693_s21_q ? patches_valid_0_q : select_1804_s21_q);
  // hls/stages/agreement.hpp:276
  logic select_3029;
  assign select_3029 = sample_pair_whole_s21_q ? (and_1827 ? (sample_present_s21_q & select_3026) : select_3026) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3031;
  assign select_3031 = equal_1694_s21_q ? patches_valid_1_q : (select_1693_s21_q ? select_1804_s21_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3034;
  assign select_3034 = sample_pair_whole_s21_q ? (and_1846 ? (sample_present_s21_q & select_3031) : select_3031) : patches_valid_1_q;
  logic [5:0] select_3037;
  assign select_3037 = sample_pair_whole_s21_q ? (select_1825[5] ? {1'b1, select_1825[4:0]} : (select_1825 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3040;
  assign select_3040 = sample_pair_whole_s21_q ? (select_1844[5] ? {1'b1, select_1844[4:0]} : (select_1844 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3043;
  assign select_3043 = sample_pair_whole_s21_q ? (select_1856[4] ? {1'b1, select_1856[3:0]} : (select_1856 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3046;
  assign select_3046 = sample_pair_whole_s21_q ? (select_1860[4] ? {1'b1, select_1860[3:0]} : (select_1860 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3421;
  assign parity_3421 = ^{or_3413_s21_q, or_3409_s21_q, or_3405_s21_q, or_3398_s21_q, or_3394_s21_q, or_3390_s21_q, or_3383_s21_q, or_3379_s21_q, or_3375_s21_q, or_3368_s21_q, or_3364_s21_q, and_3360_s21_q};
  // hls/stages/count_bits.hpp:25
  logic or_3425;
  assign or_3425 = (or_3379_s21_q & or_3383_s21_q) | (or_3375_s21_q & (or_3379_s21_q | or_3383_s21_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3436;
  assign parity_3436 = ^{or_3433_s21_q, or_3429_s21_q, or_3425};
  // hls/stages/count_bits.hpp:25
  logic and_3437;
  assign and_3437 = (^{or_3368_s21_q, or_3364_s21_q, and_3360_s21_q}) & parity_3419_s21_q;
  logic or_3441;
  assign or_3441 = (or_3364_s21_q & or_3368_s21_q) | and_3440_s21_q;
  logic or_3445;
  assign or_3445 = and_3442_s21_q | and_3444_s21_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3448;
  assign parity_3448 = ^{or_3445, or_3441, and_3437};
  // hls/stages/count_bits.hpp:25
  logic and_3450;
  assign and_3450 = parity_3436 & parity_3448;
  logic or_3454;
  assign or_3454 = (or_3429_s21_q & or_3433_s21_q) | (or_3425 & (or_3429_s21_q | or_3433_s21_q));
  logic or_3458;
  assign or_3458 = (or_3441 & or_3445) | (and_3437 & (or_3441 | or_3445));
  // hls/stages/patches.hpp:600
  logic or_3606;
  assign or_3606 = (~(patches_second_s21_q ? patches_valid_1_q : patches_valid_0_q)) | or_3605_s21_q;
  logic or_3609;
  assign or_3609 = equal_3597_s21_q | (less_3599_s21_q | (less_3600_s21_q | or_3606));
  // hls/stages/patches.hpp:599
  logic [14:0] difference_3656;
  assign difference_3656 = {{7{select_3650_s21_q[7]}}, select_3650_s21_q} - {product_3655_s21_q[13], product_3655_s21_q};
  // hls/stages/patches.hpp:605
  logic less_3657;
  assign less_3657 = $signed({{8{difference_3627[6]}}, difference_3627}) < $signed(difference_3656);
  // hls/stages/agreement.hpp:788
  logic select_3949;
  assign select_3949 = equal_575_s21_q ? ((x_s21_q[6] & good_known_q) | equal_3947_s21_q) : good_known_q;
  // hls/stages/agreement.hpp:1308
  logic and_4124;
  assign and_4124 = and_2142_s21_q & ({sum_2068_s21_q, index_2_s21_q} == {sum_2055_s21_q, index_s21_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1409; read in stage 21, written in stage 22: 21 < 22 < 21 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2055_s21_q, index_s21_q};
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s21_en & (and_2062_s21_q & less_2063_s21_q);
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
    end else if (s21_en) begin
      moments_left_begins_q <= equal_575_s21_q ? not_2310_s21_q : moments_left_begins_q;
      moments_right_begins_q <= equal_575_s21_q ? not_2320_s21_q : moments_right_begins_q;
      moments_ends_q <= equal_575_s21_q & (equal_2298_s21_q & (not_2353 | and_2355));
      sharpness_sums_detail_0_q <= and_550_s21_q ? select_2379 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_550_s21_q ? select_2391 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2433 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2435 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_2462 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_2468 : sharpness_comparing_less_contrast_1_q;
      registration_moved_q <= not_2911_s21_q & (registration_moved_q | and_2933_s21_q);
      patches_valid_0_q <= select_3029;
      patches_valid_1_q <= select_3034;
      patches_right_next_0_q <= select_3037;
      patches_right_next_1_q <= select_3040;
      patches_left_next_0_q <= select_3043;
      patches_left_next_1_q <= select_3046;
      good_known_q <= select_3949;
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
      census_changes_values_2_left_q <= select_2280;
      census_changes_values_2_right_q <= select_2281;
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
  logic census_columns_values_1_cell_2_of_skin_s22_q;
  logic [23:0] sharpness_sums_detail_0_s22_q;
  logic [23:0] sharpness_sums_detail_1_s22_q;
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
  logic [8:0] sum_732_s22_q;
  logic and_740_s22_q;
  logic less_741_s22_q;
  logic and_746_s22_q;
  logic less_747_s22_q;
  logic equal_1608_s22_q;
  logic equal_1616_s22_q;
  logic equal_1618_s22_q;
  logic equal_1620_s22_q;
  logic equal_1622_s22_q;
  logic equal_1624_s22_q;
  logic equal_1626_s22_q;
  logic equal_1788_s22_q;
  logic equal_1790_s22_q;
  logic [4:0] select_1815_s22_q;
  logic [4:0] select_1818_s22_q;
  logic and_1828_s22_q;
  logic [4:0] select_1843_s22_q;
  logic and_1847_s22_q;
  logic [3:0] column_4_s22_q;
  logic [3:0] select_1862_s22_q;
  logic select_1863_s22_q;
  logic and_1870_s22_q;
  logic less_1966_s22_q;
  logic equal_1967_s22_q;
  logic not_1968_s22_q;
  logic equal_1969_s22_q;
  logic not_1996_s22_q;
  logic and_2062_s22_q;
  logic less_2063_s22_q;
  logic [2:0] index_2_s22_q;
  logic [10:0] sum_2068_s22_q;
  logic is_seen_s22_q;
  logic and_2132_s22_q;
  logic and_2142_s22_q;
  logic equal_2283_s22_q;
  logic [8:0] sum_2286_s22_q;
  logic equal_2298_s22_q;
  logic not_2329_s22_q;
  logic and_2350_s22_q;
  logic equal_2401_s22_q;
  logic less_2402_s22_q;
  logic [17:0] select_2414_s22_q;
  logic [17:0] select_2424_s22_q;
  logic equal_2445_s22_q;
  logic and_2597_s22_q;
  logic and_2644_s22_q;
  logic [9:0] select_2648_s22_q;
  logic [9:0] select_2651_s22_q;
  logic [9:0] select_2658_s22_q;
  logic and_2679_s22_q;
  logic and_2699_s22_q;
  logic equal_2898_s22_q;
  logic parity_3230_s22_q;
  logic parity_3359_s22_q;
  logic parity_3421_s22_q;
  logic xor_3449_s22_q;
  logic parity_3461_s22_q;
  logic and_3462_s22_q;
  logic and_3464_s22_q;
  logic equal_3466_s22_q;
  logic or_3609_s22_q;
  logic [5:0] difference_3656_s22_q;
  logic not_3658_s22_q;
  logic not_3668_s22_q;
  logic equal_3706_s22_q;
  logic less_3780_s22_q;
  logic less_3781_s22_q;
  logic less_3831_s22_q;
  logic or_3928_s22_q;
  logic select_3936_s22_q;
  logic equal_3947_s22_q;
  logic equal_3950_s22_q;
  logic equal_3952_s22_q;
  logic equal_3953_s22_q;
  logic equal_3954_s22_q;
  logic equal_3955_s22_q;
  logic and_4109_s22_q;
  logic and_4124_s22_q;
  logic [31:0] select_4194_s22_q;
  logic [9:0] select_4201_s22_q;
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
      census_columns_values_1_cell_2_of_skin_s22_q <= census_columns_values_1_cell_2_of_skin_s21_q;
      sharpness_sums_detail_0_s22_q <= sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_s22_q <= sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_s22_q <= sharpness_sums_contrast_0_s21_q;
      sharpness_sums_contrast_1_s22_q <= sharpness_sums_contrast_1_s21_q;
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
      and_709_s22_q <= and_709_s21_q;
      and_710_s22_q <= and_710_s21_q;
      sum_732_s22_q <= sum_732[13:5];
      and_740_s22_q <= and_740_s21_q;
      less_741_s22_q <= less_741_s21_q;
      and_746_s22_q <= (and_709_s21_q & and_736_s21_q) & less_745_s21_q;
      less_747_s22_q <= less_747_s21_q;
      equal_1608_s22_q <= equal_1608_s21_q;
      equal_1616_s22_q <= equal_1616_s21_q;
      equal_1618_s22_q <= equal_1618_s21_q;
      equal_1620_s22_q <= equal_1620_s21_q;
      equal_1622_s22_q <= equal_1622_s21_q;
      equal_1624_s22_q <= equal_1624_s21_q;
      equal_1626_s22_q <= equal_1626_s21_q;
      equal_1788_s22_q <= equal_1788_s21_q;
      equal_1790_s22_q <= equal_1790_s21_q;
      select_1815_s22_q <= or_1814_s21_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1818_s22_q <= select_1818_s21_q;
      and_1828_s22_q <= sample_pair_whole_s21_q & and_1827;
      select_1843_s22_q <= or_1842_s21_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1847_s22_q <= sample_pair_whole_s21_q & and_1846;
      column_4_s22_q <= column_4;
      select_1862_s22_q <= select_1862_s21_q;
      select_1863_s22_q <= or_1855_s21_q ? and_1676_s21_q : patches_left_next_0_q[4];
      and_1870_s22_q <= and_1870;
      less_1966_s22_q <= less_1966_s21_q;
      equal_1967_s22_q <= equal_1967_s21_q;
      not_1968_s22_q <= not_1968_s21_q;
      equal_1969_s22_q <= equal_1969_s21_q;
      not_1996_s22_q <= not_1996_s21_q;
      and_2062_s22_q <= and_2062_s21_q;
      less_2063_s22_q <= less_2063_s21_q;
      index_2_s22_q <= index_2_s21_q;
      sum_2068_s22_q <= sum_2068_s21_q;
      is_seen_s22_q <= is_seen;
      and_2132_s22_q <= is_seen & less_2131_s21_q;
      and_2142_s22_q <= and_2142_s21_q;
      equal_2283_s22_q <= equal_2283_s21_q;
      sum_2286_s22_q <= sum_2286[13:5];
      equal_2298_s22_q <= equal_2298_s21_q;
      not_2329_s22_q <= ~moments_ends_q;
      and_2350_s22_q <= cfg_prove_i & and_2349;
      equal_2401_s22_q <= equal_2401_s21_q;
      less_2402_s22_q <= less_2402_s21_q;
      select_2414_s22_q <= select_2414;
      select_2424_s22_q <= select_2424;
      equal_2445_s22_q <= equal_2445_s21_q;
      and_2597_s22_q <= and_2597_s21_q;
      and_2644_s22_q <= not_576_s21_q & (drew_q & and_2642);
      select_2648_s22_q <= select_2648_s21_q;
      select_2651_s22_q <= select_2651_s21_q;
      select_2658_s22_q <= select_2658;
      and_2679_s22_q <= drew_q & (ends_cell_s21_q & (not_2622_s21_q & and_2676));
      and_2699_s22_q <= and_2699_s21_q;
      equal_2898_s22_q <= equal_2898_s21_q;
      parity_3230_s22_q <= parity_3230_s21_q;
      parity_3359_s22_q <= parity_3359_s21_q;
      parity_3421_s22_q <= parity_3421;
      xor_3449_s22_q <= parity_3436 ^ parity_3448;
      parity_3461_s22_q <= ^{or_3458, or_3454, and_3450};
      and_3462_s22_q <= or_3454 & or_3458;
      and_3464_s22_q <= and_3450 & (or_3454 | or_3458);
      equal_3466_s22_q <= equal_3466_s21_q;
      or_3609_s22_q <= or_3609;
      difference_3656_s22_q <= difference_3656[5:0];
      not_3658_s22_q <= ~less_3657;
      not_3668_s22_q <= ~($signed(difference_3656) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3706_s22_q <= equal_3706_s21_q;
      less_3780_s22_q <= $signed(15'h10) < $signed(difference_3656);
      less_3781_s22_q <= $signed(difference_3656[14:4]) < $signed(11'h7ff);
      less_3831_s22_q <= less_3831_s21_q;
      or_3928_s22_q <= or_3928_s21_q;
      select_3936_s22_q <= select_3936_s21_q;
      equal_3947_s22_q <= equal_3947_s21_q;
      equal_3950_s22_q <= equal_3950_s21_q;
      equal_3952_s22_q <= equal_3952_s21_q;
      equal_3953_s22_q <= equal_3953_s21_q;
      equal_3954_s22_q <= equal_3954_s21_q;
      equal_3955_s22_q <= equal_3955_s21_q;
      and_4109_s22_q <= said_q;
      and_4124_s22_q <= and_4124;
      select_4194_s22_q <= select_4194_s21_q;
      select_4201_s22_q <= select_4201_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  logic or_2331;
  assign or_2331 = moments_begins_alone_q | (moments_out_of_step_q & not_2329_s22_q);
  // hls/stages/census.hpp:392
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2414_s22_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2417;
  assign select_2417 = equal_2401_s22_q ? (less_2402_s22_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:392
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2424_s22_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2427;
  assign select_2427 = equal_2401_s22_q ? (less_2402_s22_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2646;
  assign select_2646 = and_2597_s22_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2644_s22_q});
  logic [13:0] select_2660;
  assign select_2660 = and_2597_s22_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2658_s22_q});
  // hls/stages/agreement.hpp:788
  logic and_2680;
  assign and_2680 = not_576_s22_q & and_2679_s22_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2682;
  assign select_2682 = and_2597_s22_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2680});
  logic [13:0] select_2701;
  assign select_2701 = and_2597_s22_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2699_s22_q});
  // hls/stages/count_bits.hpp:27
  logic or_3465;
  assign or_3465 = and_3462_s22_q | and_3464_s22_q;
  // hls/stages/patches.hpp:526
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3465, parity_3461_s22_q, xor_3449_s22_q, parity_3421_s22_q, parity_3359_s22_q, parity_3230_s22_q} + (equal_3466_s22_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:185
  logic [9:0] select_3470;
  assign select_3470 = equal_1788_s22_q ? patches_sums_values_0_q : (equal_1790_s22_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3471;
  assign select_3471 = equal_1790_s22_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3473;
  assign select_3473 = equal_1790_s22_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3475;
  assign select_3475 = equal_1790_s22_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3477;
  assign select_3477 = equal_1790_s22_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3479;
  assign select_3479 = equal_1790_s22_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3481;
  assign select_3481 = equal_1790_s22_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3483;
  assign select_3483 = equal_1790_s22_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3485;
  assign select_3485 = equal_1790_s22_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3487;
  assign select_3487 = equal_1790_s22_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3489;
  assign select_3489 = equal_1790_s22_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3491;
  assign select_3491 = equal_1790_s22_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3493;
  assign select_3493 = equal_1790_s22_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3495;
  assign select_3495 = equal_1790_s22_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3497;
  assign select_3497 = equal_1790_s22_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3499;
  assign select_3499 = equal_1790_s22_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3501;
  assign select_3501 = equal_1790_s22_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:580
  logic not_3610;
  assign not_3610 = ~or_3609_s22_q;
  // hls/stages/patches.hpp:561
  logic and_3611;
  assign and_3611 = equal_1969_s22_q & not_3610;
  // hls/stages/patches.hpp:185
  logic and_3614;
  assign and_3614 = equal_1788_s22_q & (less_1966_s22_q ? (not_1968_s22_q & and_3611) : and_3611);
  // hls/stages/patches.hpp:561
  logic and_3617;
  assign and_3617 = equal_1969_s22_q & (patches_second_s22_q & not_3610);
  // hls/stages/patches.hpp:185
  logic and_3620;
  assign and_3620 = equal_1788_s22_q & (less_1966_s22_q ? (not_1968_s22_q & and_3617) : and_3617);
  // hls/stages/patches.hpp:561
  logic and_3660;
  assign and_3660 = equal_1969_s22_q & (not_3610 & not_3658_s22_q);
  // hls/stages/patches.hpp:185
  logic and_3663;
  assign and_3663 = equal_1788_s22_q & (less_1966_s22_q ? (not_1968_s22_q & and_3660) : and_3660);
  // hls/stages/patches.hpp:561
  logic and_3670;
  assign and_3670 = equal_1969_s22_q & (not_3610 & not_3668_s22_q);
  // hls/stages/patches.hpp:185
  logic and_3673;
  assign and_3673 = equal_1788_s22_q & (less_1966_s22_q ? (not_1968_s22_q & and_3670) : and_3670);
  // hls/stages/agreement.hpp:1130
  logic less_3707;
  assign less_3707 = x_s22_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3711;
  assign and_3711 = equal_575_s22_q & (x_s22_q[6] & (not_1996_s22_q & (equal_3706_s22_q & less_3707)));
  // hls/stages/agreement.hpp:1142
  logic and_3716;
  assign and_3716 = x_s22_q[6] & (not_1996_s22_q & (less_3707 & (x_s22_q[2:0] == 3'h1)));
  logic and_3723;
  assign and_3723 = x_s22_q[6] & (not_1996_s22_q & (less_3707 & (x_s22_q[2:0] == 3'h2)));
  logic and_3730;
  assign and_3730 = x_s22_q[6] & (not_1996_s22_q & (less_3707 & (x_s22_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:200
  logic select_3737;
  assign select_3737 = (x_s22_q[5:3] == 3'h2) ? x_s22_q[1] : (x_s22_q[0] & (x_s22_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:203
  logic [4:0] sum_3764;
  assign sum_3764 = {2'h0, x_s22_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:607
  logic [5:0] select_3783;
  assign select_3783 = less_3780_s22_q ? 6'h10 : (less_3781_s22_q ? 6'h30 : difference_3656_s22_q);
  // hls/stages/patches.hpp:561
  logic [5:0] select_3785;
  assign select_3785 = equal_1969_s22_q ? (or_3609_s22_q ? 6'h0 : select_3783) : 6'h0;
  logic [5:0] select_3787;
  assign select_3787 = less_1966_s22_q ? (equal_1967_s22_q ? 6'h0 : select_3785) : select_3785;
  // hls/stages/agreement.hpp:788
  logic and_3794;
  assign and_3794 = equal_575_s22_q & (x_s22_q[6] & (not_1996_s22_q & (equal_2898_s22_q & less_3707)));
  // hls/stages/agreement.hpp:1142
  logic and_3798;
  assign and_3798 = x_s22_q[6] & (not_1996_s22_q & (less_3707 & (x_s22_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:561
  logic and_3833;
  assign and_3833 = equal_1969_s22_q & (not_3610 & less_3831_s22_q);
  // hls/stages/patches.hpp:185
  logic and_3836;
  assign and_3836 = equal_1788_s22_q & (less_1966_s22_q ? (not_1968_s22_q & and_3833) : and_3833);
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3957;
  assign select_3957 = equal_3954_s22_q ? counts_skin_unproven_q : (equal_3955_s22_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3959;
  assign select_3959 = equal_3953_s22_q ? counts_regions_bad_q : (equal_3950_s22_q ? counts_nearer_s22_q : select_3957);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3952_s22_q ? counts_on_skin_q : select_3959;
  // hls/stages/agreement.hpp:788
  logic and_4185;
  assign and_4185 = equal_575_s22_q & (x_s22_q[6] & (not_1996_s22_q | (4'hc < x_s22_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4195;
  assign select_4195 = equal_1626_s22_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4194_s22_q;
  logic [31:0] select_4196;
  assign select_4196 = equal_1624_s22_q ? {8'h0, sharpness_sums_detail_0_s22_q} : select_4195;
  logic [31:0] select_4197;
  assign select_4197 = equal_1622_s22_q ? {8'h0, sharpness_sums_detail_1_s22_q} : select_4196;
  logic [31:0] select_4198;
  assign select_4198 = equal_1620_s22_q ? {8'h0, sharpness_sums_contrast_0_s22_q} : select_4197;
  logic [31:0] select_4199;
  assign select_4199 = equal_1618_s22_q ? {8'h0, sharpness_sums_contrast_1_s22_q} : select_4198;

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1818_s22_q, select_1815_s22_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s22_en & and_1828_s22_q;
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
  assign patches_right_1_waddr = {select_1818_s22_q, select_1843_s22_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s22_en & and_1847_s22_q;
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

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1863_s22_q, select_1862_s22_q, column_4_s22_q};
  logic patches_left_we;
  assign patches_left_we = s22_en & and_1870_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s22_q;
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
  logic [8:0] patches_left_raddr_s21_sim;
  logic patches_left_re_s21_sim;
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
      patches_left_re_s21_sim <= 1'b0;
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
      patches_left_re_s21_sim <= patches_left_re_s20_sim;
      patches_left_raddr_s21_sim <= patches_left_raddr_s20_sim;
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
      if (patches_left_re_s21_sim && patches_left_raddr_s21_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
    end
  end
`endif

  // Memory map, write
  logic [13:0] map_waddr;
  assign map_waddr = {sum_2068_s22_q, index_2_s22_q};
  logic map_we;
  assign map_we = s22_en & and_2142_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2132_s22_q, is_seen_s22_q};
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
    end else if (s22_en) begin
      moments_out_of_step_q <= or_2331;
      moments_begins_alone_q <= equal_575_s22_q & (equal_2298_s22_q & and_2350_s22_q);
      sharpness_comparing_rest_0_q <= so_s22_q ? select_2417 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s22_q ? select_2427 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2646;
      counts_regions_bad_q <= select_2660;
      counts_skin_unproven_q <= select_2682;
      counts_on_skin_q <= select_2701;
      patches_sums_values_0_q <= select_3470;
      patches_sums_values_1_q <= equal_1788_s22_q ? patches_sums_values_1_q : select_3471;
      patches_sums_values_2_q <= equal_1788_s22_q ? patches_sums_values_2_q : select_3473;
      patches_sums_values_3_q <= equal_1788_s22_q ? patches_sums_values_3_q : select_3475;
      patches_sums_values_4_q <= equal_1788_s22_q ? patches_sums_values_4_q : select_3477;
      patches_sums_values_5_q <= equal_1788_s22_q ? patches_sums_values_5_q : select_3479;
      patches_sums_values_6_q <= equal_1788_s22_q ? patches_sums_values_6_q : select_3481;
      patches_sums_values_7_q <= equal_1788_s22_q ? patches_sums_values_7_q : select_3483;
      patches_sums_values_8_q <= equal_1788_s22_q ? patches_sums_values_8_q : select_3485;
      patches_sums_values_9_q <= equal_1788_s22_q ? patches_sums_values_9_q : select_3487;
      patches_sums_values_10_q <= equal_1788_s22_q ? patches_sums_values_10_q : select_3489;
      patches_sums_values_11_q <= equal_1788_s22_q ? patches_sums_values_11_q : select_3491;
      patches_sums_values_12_q <= equal_1788_s22_q ? patches_sums_values_12_q : select_3493;
      patches_sums_values_13_q <= equal_1788_s22_q ? patches_sums_values_13_q : select_3495;
      patches_sums_values_14_q <= equal_1788_s22_q ? patches_sums_values_14_q : select_3497;
      patches_sums_values_15_q <= equal_1788_s22_q ? patches_sums_values_15_q : select_3499;
      patches_sums_values_16_q <= equal_1788_s22_q ? patches_sums_values_16_q : select_3501;
      patches_frame_ended_q <= equal_575_s22_q & equal_2298_s22_q;
      proven_q <= marks_first_s22_q ? done_s22_q : proven_q;
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
  logic less_733_s23_q;
  logic and_740_s23_q;
  logic less_741_s23_q;
  logic and_746_s23_q;
  logic less_747_s23_q;
  logic equal_1608_s23_q;
  logic equal_1616_s23_q;
  logic and_2062_s23_q;
  logic less_2063_s23_q;
  logic [1:0] map_rdata_s23_q;
  logic is_seen_s23_q;
  logic and_2132_s23_q;
  logic equal_2283_s23_q;
  logic and_2288_s23_q;
  logic equal_2401_s23_q;
  logic sum_s23_q;
  logic sum_2_s23_q;
  logic equal_2445_s23_q;
  logic select_2463_s23_q;
  logic select_2469_s23_q;
  logic [9:0] select_2648_s23_q;
  logic [9:0] select_2651_s23_q;
  logic and_3614_s23_q;
  logic and_3620_s23_q;
  logic and_3663_s23_q;
  logic and_3673_s23_q;
  logic equal_3706_s23_q;
  logic and_3711_s23_q;
  logic and_3717_s23_q;
  logic and_3724_s23_q;
  logic and_3731_s23_q;
  logic and_3740_s23_q;
  logic and_3767_s23_q;
  logic [5:0] select_3788_s23_q;
  logic and_3794_s23_q;
  logic and_3799_s23_q;
  logic and_3837_s23_q;
  logic or_3928_s23_q;
  logic select_3936_s23_q;
  logic equal_3947_s23_q;
  logic and_3951_s23_q;
  logic [13:0] before_v_4_s23_q;
  logic not_3996_s23_q;
  logic or_4000_s23_q;
  logic and_4005_s23_q;
  logic less_4006_s23_q;
  logic and_4109_s23_q;
  logic and_4124_s23_q;
  logic not_4138_s23_q;
  logic and_4185_s23_q;
  logic [5:0] select_4187_s23_q;
  logic [31:0] select_4199_s23_q;
  logic [9:0] select_4201_s23_q;
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
      less_733_s23_q <= 9'h4 < sum_732_s22_q;
      and_740_s23_q <= and_740_s22_q;
      less_741_s23_q <= less_741_s22_q;
      and_746_s23_q <= and_746_s22_q;
      less_747_s23_q <= less_747_s22_q;
      equal_1608_s23_q <= equal_1608_s22_q;
      equal_1616_s23_q <= equal_1616_s22_q;
      and_2062_s23_q <= and_2062_s22_q;
      less_2063_s23_q <= less_2063_s22_q;
      map_rdata_s23_q <= map_rdata_q;
      is_seen_s23_q <= is_seen_s22_q;
      and_2132_s23_q <= and_2132_s22_q;
      equal_2283_s23_q <= equal_2283_s22_q;
      and_2288_s23_q <= and_709_s22_q & (9'h4 < sum_2286_s22_q);
      equal_2401_s23_q <= equal_2401_s22_q;
      sum_s23_q <= sum[0];
      sum_2_s23_q <= sum_2[0];
      equal_2445_s23_q <= equal_2445_s22_q;
      select_2463_s23_q <= sharpness_comparing_less_contrast_0_q;
      select_2469_s23_q <= sharpness_comparing_less_contrast_1_q;
      select_2648_s23_q <= select_2648_s22_q;
      select_2651_s23_q <= select_2651_s22_q;
      and_3614_s23_q <= and_3614;
      and_3620_s23_q <= and_3620;
      and_3663_s23_q <= and_3663;
      and_3673_s23_q <= and_3673;
      equal_3706_s23_q <= equal_3706_s22_q;
      and_3711_s23_q <= and_3711;
      and_3717_s23_q <= equal_575_s22_q & and_3716;
      and_3724_s23_q <= equal_575_s22_q & and_3723;
      and_3731_s23_q <= equal_575_s22_q & and_3730;
      and_3740_s23_q <= x_s22_q[6] & (not_1996_s22_q & (less_3707 & select_3737));
      and_3767_s23_q <= not_1996_s22_q & (less_3707 & (sum_3764[4:2] == 3'h0));
      select_3788_s23_q <= equal_1788_s22_q ? select_3787 : 6'h0;
      and_3794_s23_q <= and_3794;
      and_3799_s23_q <= equal_575_s22_q & and_3798;
      and_3837_s23_q <= and_3614 & and_3836;
      or_3928_s23_q <= or_3928_s22_q;
      select_3936_s23_q <= select_3936_s22_q;
      equal_3947_s23_q <= equal_3947_s22_q;
      and_3951_s23_q <= equal_3950_s22_q & equal_3706_s22_q;
      before_v_4_s23_q <= before_v_4;
      not_3996_s23_q <= ~(equal_3955_s22_q & equal_3706_s22_q);
      or_4000_s23_q <= (equal_3955_s22_q | equal_3954_s22_q) | (x_s22_q[6:3] == 4'hf);
      and_4005_s23_q <= equal_3952_s22_q & equal_3706_s22_q;
      less_4006_s23_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4109_s23_q <= and_4109_s22_q;
      and_4124_s23_q <= and_4124_s22_q;
      not_4138_s23_q <= ~proven_q;
      and_4185_s23_q <= and_4185;
      select_4187_s23_q <= equal_575_s22_q ? (x_s22_q[6] ? x_s22_q[5:0] : 6'h0) : 6'h0;
      select_4199_s23_q <= select_4199;
      select_4201_s23_q <= select_4201_s22_q;
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
  logic hides_q;
  // hls/stages/census.hpp:314
  logic and_734;
  assign and_734 = and_684_s23_q & less_733_s23_q;
  // hls/stages/patches.hpp:185
  logic less_1978;
  assign less_1978 = patches_sums_values_0_s23_q < patches_best_differing_q;
  // hls/stages/patches.hpp:186
  logic not_1979;
  assign not_1979 = ~less_1978;
  logic [1:0] select_1980;
  assign select_1980 = patches_summed_first_s23_q ? 2'h2 : {less_1978, not_1979};
  logic [12:0] select_1982;
  assign select_1982 = select_1980[0] ? {4'h0, patches_summed_first_s23_q, 3'h0, patches_summed_row_column_s23_q} : {patches_summed_row_column_s23_q, patches_sums_values_0_s23_q[7:0]};
  logic [14:0] select_1983;
  assign select_1983 = select_1980[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1984;
  assign select_1984 = (select_1980 == 2'h2) ? {select_1982[12:8], patches_sums_values_0_s23_q[9:8], select_1982[7:0]} : select_1983;
  // hls/stages/census.hpp:321
  logic and_2289;
  assign and_2289 = and_709_s23_q & less_733_s23_q;
  // hls/stages/census.hpp:322
  logic [19:0] sum_2290;
  assign sum_2290 = census_left_misses_q + {{17{and_2289}}, and_2288_s23_q, 1'b0, and_2288_s23_q};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2292;
  assign select_2292 = and_550_s23_q ? (equal_2283_s23_q ? 20'h0 : sum_2290) : census_left_misses_q;
  // hls/stages/agreement.hpp:216
  logic [2:0] select_2429;
  assign select_2429 = equal_2401_s23_q ? {sharpness_comparing_product_0_q[1:0], sum_s23_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2431;
  assign select_2431 = equal_2401_s23_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s23_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s23_q});
  // hls/stages/agreement.hpp:216
  logic select_2440;
  assign select_2440 = so_s23_q ? (equal_2401_s23_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s23_q});
  // hls/stages/agreement.hpp:216
  logic select_2443;
  assign select_2443 = equal_2401_s23_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:400
  logic xor_2446;
  assign xor_2446 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2452;
  assign xor_2452 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/patches.hpp:658
  logic not_3615;
  assign not_3615 = ~patches_lower_s23_q;
  logic not_3621;
  assign not_3621 = ~and_3620_s23_q;
  // hls/stages/patches.hpp:189
  logic and_3623;
  assign and_3623 = and_3614_s23_q & (not_3615 & not_3621);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3625;
  assign sum_3625 = {7'h0, and_3623} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:661
  logic and_3664;
  assign and_3664 = and_3663_s23_q & and_3623;
  logic [7:0] sum_3665;
  assign sum_3665 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3664};
  // hls/stages/patches.hpp:662
  logic and_3674;
  assign and_3674 = and_3673_s23_q & and_3623;
  logic [7:0] sum_3675;
  assign sum_3675 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3674};
  // hls/stages/patches.hpp:189
  logic and_3677;
  assign and_3677 = and_3614_s23_q & (and_3620_s23_q & not_3615);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3679;
  assign sum_3679 = {7'h0, and_3677} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:661
  logic and_3681;
  assign and_3681 = and_3663_s23_q & and_3677;
  logic [7:0] sum_3682;
  assign sum_3682 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3681};
  // hls/stages/patches.hpp:662
  logic and_3684;
  assign and_3684 = and_3673_s23_q & and_3677;
  logic [7:0] sum_3685;
  assign sum_3685 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3684};
  // hls/stages/patches.hpp:189
  logic and_3687;
  assign and_3687 = and_3614_s23_q & (patches_lower_s23_q & not_3621);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3689;
  assign sum_3689 = {7'h0, and_3687} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:661
  logic and_3691;
  assign and_3691 = and_3663_s23_q & and_3687;
  logic [7:0] sum_3692;
  assign sum_3692 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3691};
  // hls/stages/patches.hpp:662
  logic and_3694;
  assign and_3694 = and_3673_s23_q & and_3687;
  logic [7:0] sum_3695;
  assign sum_3695 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3694};
  // hls/stages/patches.hpp:189
  logic and_3697;
  assign and_3697 = and_3614_s23_q & (patches_lower_s23_q & and_3620_s23_q);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3699;
  assign sum_3699 = {7'h0, and_3697} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:661
  logic and_3701;
  assign and_3701 = and_3663_s23_q & and_3697;
  logic [7:0] sum_3702;
  assign sum_3702 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3701};
  // hls/stages/patches.hpp:662
  logic and_3704;
  assign and_3704 = and_3673_s23_q & and_3697;
  logic [7:0] sum_3705;
  assign sum_3705 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3704};
  // hls/stages/patches.hpp:624
  logic [7:0] or_3719;
  assign or_3719 = (and_3711_s23_q ? patches_quarters_0_places_q : 8'h0) | (and_3717_s23_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3733;
  assign or_3733 = (or_3719 | (and_3724_s23_q ? patches_quarters_2_places_q : 8'h0)) | (and_3731_s23_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:788
  logic and_3741;
  assign and_3741 = equal_575_s23_q & and_3740_s23_q;
  // hls/stages/patches.hpp:625
  logic [7:0] select_3743;
  assign select_3743 = and_3711_s23_q ? (and_3741 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3745;
  assign select_3745 = and_3717_s23_q ? (and_3741 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3748;
  assign select_3748 = and_3724_s23_q ? (and_3741 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3751;
  assign select_3751 = and_3731_s23_q ? (and_3741 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:626
  logic [7:0] select_3754;
  assign select_3754 = and_3711_s23_q ? (and_3741 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3756;
  assign select_3756 = and_3717_s23_q ? (and_3741 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3759;
  assign select_3759 = and_3724_s23_q ? (and_3741 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3762;
  assign select_3762 = and_3731_s23_q ? (and_3741 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic and_3769;
  assign and_3769 = equal_575_s23_q & (x_s23_q & and_3767_s23_q);
  // hls/stages/patches.hpp:619
  logic [7:0] sum_3771;
  assign sum_3771 = patches_word_places_q + (and_3717_s23_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:621
  logic [7:0] select_3775;
  assign select_3775 = and_3769 ? (patches_word_up_q + (and_3717_s23_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3777;
  assign sum_3777 = patches_word_down_q + (and_3717_s23_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:664
  logic [5:0] select_3789;
  assign select_3789 = and_3614_s23_q ? select_3788_s23_q : 6'h0;
  logic [11:0] sum_3790;
  assign sum_3790 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3789[5]}}, select_3789};
  // hls/stages/patches.hpp:648
  logic [7:0] select_3801;
  assign select_3801 = and_3794_s23_q ? (and_3799_s23_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:650
  logic or_3805;
  assign or_3805 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic or_3808;
  assign or_3808 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:652
  logic [8:0] sum_3809;
  assign sum_3809 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:647
  logic select_3811;
  assign select_3811 = and_3794_s23_q ? (and_3799_s23_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:189
  logic and_3814;
  assign and_3814 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:647
  logic [2:0] select_3815;
  assign select_3815 = and_3794_s23_q ? {and_3814, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3817;
  assign select_3817 = and_3794_s23_q ? (and_3799_s23_q ? {and_3814, patches_found_q[2:1]} : select_3815) : patches_found_q;
  // hls/stages/patches.hpp:646
  logic or_3820;
  assign or_3820 = patches_partly_q | (patches_doubted_q & (~and_3799_s23_q));
  // hls/stages/patches.hpp:647
  logic select_3822;
  assign select_3822 = and_3799_s23_q ? or_3820 : (and_3794_s23_q ? or_3820 : patches_doubted_q);
  // hls/stages/patches.hpp:645
  logic select_3824;
  assign select_3824 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_3828;
  assign select_3828 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:665
  logic [7:0] sum_3838;
  assign sum_3838 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3837_s23_q};
  // hls/stages/patches.hpp:636
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:637
  logic select_3861;
  assign select_3861 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:638
  logic and_3867;
  assign and_3867 = patches_frame_ended_s23_q & (~patches_age_q[9]);
  logic [9:0] sum_3868;
  assign sum_3868 = patches_age_q + {9'h0, and_3867};
  logic [9:0] select_3871;
  assign select_3871 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3868)) : sum_3868;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_s23_q} - {1'b0, before_v_4_s23_q};
  // hls/stages/agreement.hpp:1230
  logic select_3962;
  assign select_3962 = and_3951_s23_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4125;
  assign select_4125 = and_4124_s23_q ? {and_2132_s23_q, is_seen_s23_q} : map_rdata_s23_q;
  // hls/stages/agreement.hpp:1309
  logic and_4126;
  assign and_4126 = proven_q & less_4114;
  // hls/stages/agreement.hpp:1239
  logic or_4139;
  assign or_4139 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4138_s23_q;
  // hls/stages/agreement.hpp:788
  logic and_4154;
  assign and_4154 = equal_3947_s23_q & (cfg_prove_i & (registration_moved_s23_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4157;
  assign or_4157 = select_2463_s23_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:788
  logic and_4181;
  assign and_4181 = equal_575_s23_q & (equal_3947_s23_q & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4200;
  assign select_4200 = equal_1616_s23_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4199_s23_q;
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4202;
  assign select_4202 = equal_1608_s23_q ? select_4200 : {2'h0, select_4201_s23_q, select_2651_s23_q, select_2648_s23_q};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = last_s23_q;
  logic fresh_we;
  assign fresh_we = s23_en & and_550_s23_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_747_s23_q, and_746_s23_q, less_741_s23_q, and_740_s23_q, census_columns_values_1_cell_2_of_skin_s23_q, and_734, and_710_s23_q, and_709_s23_q, and_684_s23_q, less_676_s23_q, less_675_s23_q, less_674_s23_q, less_673_s23_q, less_672_s23_q, less_671_s23_q, less_670_s23_q, less_669_s23_q, less_668_s23_q, less_667_s23_q, less_666_s23_q, less_665_s23_q, less_664_s23_q, less_663_s23_q, less_662_s23_q, less_661_s23_q, less_660_s23_q, less_659_s23_q, less_658_s23_q, less_657_s23_q, less_656_s23_q, less_655_s23_q, less_654_s23_q, less_653_s23_q};
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
    end else if (s23_en) begin
      census_left_misses_q <= select_2292;
      sharpness_comparing_product_0_q <= so_s23_q ? select_2429 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s23_q ? select_2431 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2440;
      sharpness_comparing_carry_1_q <= so_s23_q ? select_2443 : sharpness_comparing_carry_1_q;
      patches_best_differing_q <= select_1984[9:0];
      patches_best_column_q <= select_1984[14:10];
      patches_quarters_0_places_q <= sum_3625;
      patches_quarters_0_up_q <= sum_3665;
      patches_quarters_0_down_q <= sum_3675;
      patches_quarters_1_places_q <= sum_3679;
      patches_quarters_1_up_q <= sum_3682;
      patches_quarters_1_down_q <= sum_3685;
      patches_quarters_2_places_q <= sum_3689;
      patches_quarters_2_up_q <= sum_3692;
      patches_quarters_2_down_q <= sum_3695;
      patches_quarters_3_places_q <= sum_3699;
      patches_quarters_3_up_q <= sum_3702;
      patches_quarters_3_down_q <= sum_3705;
      patches_word_places_q <= or_3733;
      patches_word_up_q <= ((select_3743 | select_3745) | select_3748) | select_3751;
      patches_word_down_q <= ((select_3754 | select_3756) | select_3759) | select_3762;
      patches_sum_places_q <= and_3769 ? sum_3771 : patches_sum_places_q;
      patches_sum_up_q <= select_3775;
      patches_sum_down_q <= and_3769 ? sum_3777 : patches_sum_down_q;
      patches_across_q <= sum_3790;
      patches_places_q <= select_3801;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3805;
      patches_partly_q <= or_3808;
      patches_clear_limit_q <= sum_3809[8:2];
      patches_complete_q <= select_3811;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3817;
      patches_doubted_q <= and_3794_s23_q ? select_3822 : patches_doubted_q;
      patches_doubted_before_q <= select_3824;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3828;
      patches_on_skin_q <= sum_3838;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3861;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3871;
      hides_q <= equal_575_s23_q ? select_3962 : hides_q;
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
  logic equal_575_s24_q;
  logic so_s24_q;
  logic and_2062_s24_q;
  logic less_2063_s24_q;
  logic equal_2401_s24_q;
  logic or_2447_s24_q;
  logic and_2448_s24_q;
  logic or_2453_s24_q;
  logic and_2454_s24_q;
  logic select_2469_s24_q;
  logic or_3928_s24_q;
  logic select_3936_s24_q;
  logic equal_3947_s24_q;
  logic select_3962_s24_q;
  logic and_3994_s24_q;
  logic not_3996_s24_q;
  logic or_4000_s24_q;
  logic and_4005_s24_q;
  logic and_4007_s24_q;
  logic and_4109_s24_q;
  logic and_4127_s24_q;
  logic and_4130_s24_q;
  logic and_4142_s24_q;
  logic and_4155_s24_q;
  logic or_4157_s24_q;
  logic and_4181_s24_q;
  logic and_4185_s24_q;
  logic [5:0] select_4187_s24_q;
  logic [31:0] select_4204_s24_q;
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
      equal_575_s24_q <= equal_575_s23_q;
      so_s24_q <= so_s23_q;
      and_2062_s24_q <= and_2062_s23_q;
      less_2063_s24_q <= less_2063_s23_q;
      equal_2401_s24_q <= equal_2401_s23_q;
      or_2447_s24_q <= equal_2445_s23_q | xor_2446;
      and_2448_s24_q <= five_times[0] & xor_2446;
      or_2453_s24_q <= equal_2445_s23_q | xor_2452;
      and_2454_s24_q <= five_times_2[0] & xor_2452;
      select_2469_s24_q <= select_2469_s23_q;
      or_3928_s24_q <= or_3928_s23_q;
      select_3936_s24_q <= select_3936_s23_q;
      equal_3947_s24_q <= equal_3947_s23_q;
      select_3962_s24_q <= select_3962;
      and_3994_s24_q <= over[14] & equal_3706_s23_q;
      not_3996_s24_q <= not_3996_s23_q;
      or_4000_s24_q <= or_4000_s23_q;
      and_4005_s24_q <= and_4005_s23_q;
      and_4007_s24_q <= over[14] & less_4006_s23_q;
      and_4109_s24_q <= and_4109_s23_q;
      and_4127_s24_q <= select_4125[0] & and_4126;
      and_4130_s24_q <= select_4125[1] & and_4126;
      and_4142_s24_q <= equal_575_s23_q & (equal_3947_s23_q & (cfg_prove_i & or_4139));
      and_4155_s24_q <= equal_575_s23_q & and_4154;
      or_4157_s24_q <= or_4157;
      and_4181_s24_q <= and_4181;
      and_4185_s24_q <= and_4185_s23_q;
      select_4187_s24_q <= select_4187_s23_q;
      select_4204_s24_q <= equal_575_s23_q ? (x_s23_q ? select_4202 : 32'h0) : 32'h0;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic sharpness_comparing_less_detail_0_q;
  logic sharpness_comparing_less_detail_1_q;
  logic [7:0] hidden_for_q;
  logic too_much_q;
  logic overlooks_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:400
  logic select_2449;
  assign select_2449 = or_2447_s24_q ? and_2448_s24_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2450;
  assign select_2450 = equal_2401_s24_q ? select_2449 : sharpness_comparing_less_detail_0_q;
  logic select_2451;
  assign select_2451 = so_s24_q ? select_2450 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:400
  logic select_2455;
  assign select_2455 = or_2453_s24_q ? and_2454_s24_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2456;
  assign select_2456 = equal_2401_s24_q ? select_2455 : sharpness_comparing_less_detail_1_q;
  logic select_2457;
  assign select_2457 = so_s24_q ? select_2456 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:654
  logic [12:0] product_3843;
  assign product_3843 = {8'h0, cfg_on_skin_limit_i} * {5'h0, patches_places_q};
  // hls/stages/agreement.hpp:1148
  logic not_3963;
  assign not_3963 = ~hidden_for_q[7];
  logic [7:0] select_3965;
  assign select_3965 = select_3962_s24_q ? (hidden_for_q + {7'h0, not_3963}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3967;
  assign select_3967 = equal_575_s24_q ? (equal_3947_s24_q ? select_3965 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1228
  logic and_3997;
  assign and_3997 = too_much_q & not_3996_s24_q;
  // hls/stages/agreement.hpp:1229
  logic select_4002;
  assign select_4002 = and_3994_s24_q ? (and_3997 | or_4000_s24_q) : and_3997;
  // hls/stages/agreement.hpp:1231
  logic select_4008;
  assign select_4008 = and_4005_s24_q ? and_4007_s24_q : overlooks_q;
  // hls/stages/agreement.hpp:438
  logic select_4129;
  assign select_4129 = and_2062_s24_q ? (less_2063_s24_q ? and_4127_s24_q : seen_q) : seen_q;
  logic select_4132;
  assign select_4132 = and_2062_s24_q ? (less_2063_s24_q ? and_4130_s24_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:788
  logic and_4145;
  assign and_4145 = equal_575_s24_q & (equal_3947_s24_q & (cfg_prove_i & or_3928_s24_q));
  // hls/stages/agreement.hpp:1241
  logic not_4147;
  assign not_4147 = ~(or_3928_s24_q | not_2353);
  // hls/stages/agreement.hpp:788
  logic and_4150;
  assign and_4150 = equal_3947_s24_q & (not_4147 & (select_3936_s24_q | select_4002));
  logic and_4164;
  assign and_4164 = equal_3947_s24_q & (not_4147 & (select_2457 | select_2469_s24_q));

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
      hidden_for_q <= 8'h0;
      too_much_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s24_en) begin
      sharpness_comparing_less_detail_0_q <= select_2451;
      sharpness_comparing_less_detail_1_q <= select_2457;
      hidden_for_q <= select_3967;
      too_much_q <= equal_575_s24_q ? select_4002 : too_much_q;
      overlooks_q <= equal_575_s24_q ? select_4008 : overlooks_q;
      seen_q <= select_4129;
      nearer_q <= select_4132;
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
  logic equal_575_s25_q;
  logic [7:0] product_3843_s25_q;
  logic equal_3947_s25_q;
  logic and_4109_s25_q;
  logic and_4142_s25_q;
  logic and_4145_s25_q;
  logic and_4151_s25_q;
  logic and_4155_s25_q;
  logic and_4160_s25_q;
  logic and_4164_s25_q;
  logic not_4169_s25_q;
  logic or_4175_s25_q;
  logic and_4181_s25_q;
  logic and_4185_s25_q;
  logic [5:0] select_4187_s25_q;
  logic [31:0] select_4204_s25_q;
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
      equal_575_s25_q <= equal_575_s24_q;
      product_3843_s25_q <= product_3843[12:5];
      equal_3947_s25_q <= equal_3947_s24_q;
      and_4109_s25_q <= and_4109_s24_q;
      and_4142_s25_q <= and_4142_s24_q;
      and_4145_s25_q <= and_4145;
      and_4151_s25_q <= equal_575_s24_q & and_4150;
      and_4155_s25_q <= and_4155_s24_q;
      and_4160_s25_q <= equal_3947_s24_q & (not_4147 & (select_2451 | or_4157_s24_q));
      and_4164_s25_q <= and_4164;
      not_4169_s25_q <= ~(select_3965 < cfg_hidden_frames_i);
      or_4175_s25_q <= not_2353 | (select_4008 & not_3840);
      and_4181_s25_q <= and_4181_s24_q;
      and_4185_s25_q <= and_4185_s24_q;
      select_4187_s25_q <= select_4187_s24_q;
      select_4204_s25_q <= select_4204_s24_q;
    end
  end

  // Stage 25 ----------------------------------------------------------------------------------------------------------
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:189
  logic and_3845;
  assign and_3845 = (~(patches_on_skin_s25_q[7:2] == 6'h0)) & (product_3843_s25_q < patches_on_skin_s25_q);
  logic select_3850;
  assign select_3850 = patches_round_ends_s25_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:635
  logic or_3854;
  assign or_3854 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s25_q));
  // hls/stages/agreement.hpp:1150
  logic and_4171;
  assign and_4171 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4169_s25_q);
  // hls/stages/agreement.hpp:788
  logic and_4177;
  assign and_4177 = equal_3947_s25_q & (or_4175_s25_q ? cfg_prove_i : patches_overlooked_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s25_en) begin
      patches_large_q <= not_3840 & and_3845;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3850;
      patches_spoiled_q <= or_3854;
    end
  end

  logic [7:0] pixel_0_s26_q;
  logic [7:0] pixel_1_s26_q;
  logic saturated_s26_q;
  logic mask_s26_q;
  logic marks_first_s26_q;
  logic marks_last_s26_q;
  logic and_4109_s26_q;
  logic or_4133_s26_q;
  logic and_4134_s26_q;
  logic and_4142_s26_q;
  logic and_4145_s26_q;
  logic and_4151_s26_q;
  logic and_4155_s26_q;
  logic and_4161_s26_q;
  logic and_4165_s26_q;
  logic and_4173_s26_q;
  logic and_4178_s26_q;
  logic and_4181_s26_q;
  logic and_4185_s26_q;
  logic [5:0] select_4187_s26_q;
  logic [31:0] select_4204_s26_q;
  always_ff @(posedge clk_i) begin
    if (s25_en) begin
      pixel_0_s26_q <= pixel_0_s25_q;
      pixel_1_s26_q <= pixel_1_s25_q;
      saturated_s26_q <= saturated_s25_q;
      mask_s26_q <= mask_s25_q;
      marks_first_s26_q <= marks_first_s25_q;
      marks_last_s26_q <= marks_last_s25_q;
      and_4109_s26_q <= and_4109_s25_q;
      or_4133_s26_q <= not_2353 | seen_q;
      and_4134_s26_q <= cfg_prove_i & nearer_q;
      and_4142_s26_q <= and_4142_s25_q;
      and_4145_s26_q <= and_4145_s25_q;
      and_4151_s26_q <= and_4151_s25_q;
      and_4155_s26_q <= and_4155_s25_q;
      and_4161_s26_q <= equal_575_s25_q & and_4160_s25_q;
      and_4165_s26_q <= equal_575_s25_q & and_4164_s25_q;
      and_4173_s26_q <= equal_575_s25_q & (equal_3947_s25_q & and_4171);
      and_4178_s26_q <= equal_575_s25_q & and_4177;
      and_4181_s26_q <= and_4181_s25_q;
      and_4185_s26_q <= and_4185_s25_q;
      select_4187_s26_q <= select_4187_s25_q;
      select_4204_s26_q <= select_4204_s25_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s26_q;
  assign pixel_1_o = pixel_1_s26_q;
  assign saturated_o = saturated_s26_q;
  assign mask_o = mask_s26_q;
  assign marks_first_o = marks_first_s26_q;
  assign marks_last_o = marks_last_s26_q;
  assign marks_seen_o = or_4133_s26_q;
  assign marks_nearer_o = and_4134_s26_q;
  assign verdict_valid_o = and_4109_s26_q;
  assign verdict_unproven_yet_o = and_4142_s26_q;
  assign verdict_untextured_o = and_4145_s26_q;
  assign verdict_disagree_o = and_4151_s26_q;
  assign verdict_moved_o = and_4155_s26_q;
  assign verdict_unsharp_left_o = and_4161_s26_q;
  assign verdict_unsharp_right_o = and_4165_s26_q;
  assign verdict_hidden_o = and_4173_s26_q;
  assign verdict_overlooked_o = and_4178_s26_q;
  assign verdict_out_of_step_o = and_4181_s26_q;
  assign frame_valid_o = and_4185_s26_q;
  assign frame_index_o = select_4187_s26_q;
  assign frame_word_o = select_4204_s26_q;
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
  assign unused_bits = ^{over[13:0], product_3843[4:0], sum_3809[1:0], sum_3764[1:0], product_3655[4:0], sum_2747[0], difference_2688[1:0], detail_4[1:0], detail_3[1:0], sum_2286[4:0], sum_1769[1:0], sum_1768[1:0], sum_1764[0], sum_1713[0], sum_1709[0], sum_732[4:0], cfg_width_i[3:0]};

endmodule
