// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::hd>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 25 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3123 bits, pipeline 8744 bits, memories 157167 bits.
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
  logic not_2332;
  assign not_2332 = ~cfg_prove_i;
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[10:4]} + 8'hff;
  logic [6:0] sum_2545;
  assign sum_2545 = {1'b0, cfg_height_i[10:5]} + 7'h5;
  logic [6:0] difference_3606;
  assign difference_3606 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3820;
  assign not_3820 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [7:0] difference_3877;
  assign difference_3877 = 8'h0 - {1'b0, cfg_height_i[10:4]};
  logic less_4093;
  assign less_4093 = 7'h8 < cfg_height_i[10:4];
  logic [4:0] sum_4094;
  assign sum_4094 = {1'b0, cfg_height_i[10:7]} + 5'h1f;

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
  logic equal_543;
  assign equal_543 = select_508_s1_q == 4'hf;
  // hls/stages/agreement.hpp:276
  logic [6:0] select_2129;
  assign select_2129 = sample_pair_whole_s1_q ? (select_511 + {6'h0, equal_543}) : raster_at_column_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_column_q <= 7'h0;
    end else if (s1_en) begin
      raster_at_column_q <= select_2129;
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
  logic equal_543_s2_q;
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
      equal_543_s2_q <= equal_543;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [3:0] raster_at_y_q;
  logic [8:0] averager_place_q;
  // hls/stages/census.hpp:110
  logic equal_509;
  assign equal_509 = select_508_s2_q[1:0] == 2'h0;
  // hls/stages/census.hpp:116
  logic [8:0] select_514;
  assign select_514 = ({select_511_s2_q, select_508_s2_q} == 11'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:117
  logic [8:0] select_515;
  assign select_515 = equal_509 ? select_514 : averager_place_q;
  // hls/stages/census.hpp:42
  logic [3:0] select_526;
  assign select_526 = sample_pair_first_s2_q ? 4'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2127;
  assign select_2127 = sample_pair_whole_s2_q ? (sample_last_s2_q ? (select_526 + 4'h1) : select_526) : raster_at_y_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_y_q <= 4'h0;
      averager_place_q <= 9'h0;
    end else if (s2_en) begin
      raster_at_y_q <= select_2127;
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
  logic [8:0] select_515_s3_q;
  logic equal_517_s3_q;
  logic [3:0] select_526_s3_q;
  logic equal_543_s3_q;
  logic equal_544_s3_q;
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
      select_515_s3_q <= select_515;
      equal_517_s3_q <= select_508_s2_q[1:0] == 2'h3;
      select_526_s3_q <= select_526;
      equal_543_s3_q <= equal_543_s2_q;
      equal_544_s3_q <= select_526 == 4'hf;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [6:0] raster_at_row_q;
  logic raster_at_live_q;
  logic [10:0] raster_rows_left_q;
  logic raster_final_row_q;
  // hls/stages/census.hpp:42
  logic or_516;
  assign or_516 = sample_pair_first_s3_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_521;
  assign and_521 = (or_516 & equal_517_s3_q) & (~(select_515_s3_q[8:5] == 4'hf));
  // hls/stages/agreement.hpp:276
  logic [6:0] column;
  assign column = sample_pair_whole_s3_q ? select_511_s3_q : 7'h0;
  // hls/stages/census.hpp:127
  logic and_545;
  assign and_545 = equal_544_s3_q & and_521;
  // hls/stages/agreement.hpp:276
  logic and_547;
  assign and_547 = sample_pair_whole_s3_q & (equal_543_s3_q & and_545);
  // hls/stages/census.hpp:42
  logic [6:0] select_675;
  assign select_675 = sample_pair_first_s3_q ? 7'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] row;
  assign row = sample_pair_whole_s3_q ? select_675 : 7'h0;
  // hls/stages/census.hpp:58
  logic [6:0] select_2131;
  assign select_2131 = sample_last_s3_q ? (select_675 + {6'h0, equal_544_s3_q}) : select_675;
  // hls/stages/agreement.hpp:276
  logic select_2136;
  assign select_2136 = sample_pair_whole_s3_q ? (sample_last_s3_q ? (or_516 & (~raster_final_row_q)) : or_516) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [10:0] select_2138;
  assign select_2138 = sample_pair_first_s3_q ? cfg_height_i : (raster_rows_left_q - {10'h0, sample_last_s3_q});
  // hls/stages/agreement.hpp:276
  logic select_2142;
  assign select_2142 = sample_pair_whole_s3_q ? (raster_rows_left_q == 11'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:460
  logic equal_2451;
  assign equal_2451 = {last[7], column} == {1'b0, last[6:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      raster_at_row_q <= 7'h0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 11'h0;
      raster_final_row_q <= 1'b0;
    end else if (s3_en) begin
      raster_at_row_q <= sample_pair_whole_s3_q ? select_2131 : raster_at_row_q;
      raster_at_live_q <= select_2136;
      raster_rows_left_q <= sample_pair_whole_s3_q ? select_2138 : raster_rows_left_q;
      raster_final_row_q <= select_2142;
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
  logic [3:0] select_508_s4_q;
  logic equal_509_s4_q;
  logic [6:0] select_511_s4_q;
  logic [8:0] select_515_s4_q;
  logic and_521_s4_q;
  logic [3:0] select_526_s4_q;
  logic [6:0] column_s4_q;
  logic and_545_s4_q;
  logic and_547_s4_q;
  logic [3:0] select_675_s4_q;
  logic [6:0] row_s4_q;
  logic equal_1679_s4_q;
  logic equal_2451_s4_q;
  logic and_2452_s4_q;
  logic [7:0] sum_2541_s4_q;
  logic [2:0] or_2982_s4_q;
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
      select_508_s4_q <= select_508_s3_q;
      equal_509_s4_q <= equal_509_s3_q;
      select_511_s4_q <= select_511_s3_q;
      select_515_s4_q <= select_515_s3_q;
      and_521_s4_q <= and_521;
      select_526_s4_q <= select_526_s3_q;
      column_s4_q <= column;
      and_545_s4_q <= and_545;
      and_547_s4_q <= and_547;
      select_675_s4_q <= select_675[3:0];
      row_s4_q <= row;
      equal_1679_s4_q <= {or_516, select_526_s3_q} == 5'h18;
      equal_2451_s4_q <= equal_2451;
      and_2452_s4_q <= and_547 & equal_2451;
      sum_2541_s4_q <= {1'b0, row} + 8'h1;
      or_2982_s4_q <= select_511_s3_q[2:0] | select_675[6:4];
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
  // hls/stages/agreement.hpp:624
  logic equal_576;
  assign equal_576 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:615
  logic equal_591;
  assign equal_591 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:616
  logic equal_592;
  assign equal_592 = run_phase_q == 3'h2;
  // hls/stages/patches.hpp:122
  logic and_1673;
  assign and_1673 = (select_508_s4_q == 4'h0) & (select_511_s4_q == 7'h0);
  // hls/stages/agreement.hpp:524
  logic select_2455;
  assign select_2455 = (and_2452_s4_q | (~ends_cell_q)) ? and_2452_s4_q : ends_q;
  // hls/stages/agreement.hpp:530
  logic [2:0] now;
  assign now = select_2455 ? (and_2452_s4_q ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:535
  logic [5:0] select_2459;
  assign select_2459 = select_2455 ? (and_2452_s4_q ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2462;
  assign select_2462 = select_2455 ? (following_last_shift_q & (~and_2452_s4_q)) : run_last_shift_q;
  // hls/stages/agreement.hpp:536
  logic [7:0] select_2464;
  assign select_2464 = select_2455 ? (and_2452_s4_q ? 8'h0 : following_span_q) : run_span_q;
  // hls/stages/agreement.hpp:608
  logic and_2465;
  assign and_2465 = run_last_shift_q & equal_591;
  // hls/stages/agreement.hpp:617
  logic select_2467;
  assign select_2467 = equal_591 ? (~run_last_shift_q) : equal_592;
  // hls/stages/agreement.hpp:621
  logic equal_2468;
  assign equal_2468 = run_phase_q == 3'h1;
  logic not_2471;
  assign not_2471 = ~select_2467;
  // hls/stages/agreement.hpp:624
  logic equal_2473;
  assign equal_2473 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:608
  logic and_2474;
  assign and_2474 = final_row_q & so;
  // hls/stages/agreement.hpp:621
  logic [1:0] select_2475;
  assign select_2475 = equal_2473 ? 2'h1 : {2{and_2474}};
  logic [2:0] select_2477;
  assign select_2477 = (and_2465 | (select_2467 | equal_2468)) ? (equal_2468 ? 3'h2 : {not_2471, {2{select_2467}}}) : (equal_576 ? 3'h6 : {select_2475[0], select_2475});
  // hls/stages/agreement.hpp:608
  logic and_2480;
  assign and_2480 = select_2467 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:631
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2483;
  assign select_2483 = (plan_shift_q[5] & select_2467) ? value : 7'h0;
  logic [1:0] or_2484;
  assign or_2484 = {2{so}} | select_2483[5:4];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2488;
  assign or_2488 = (select_2467 ? plan_columns_q : 8'h0) | ((equal_2468 | equal_2473) ? whole_q : 8'h0);
  logic [1:0] or_2489;
  assign or_2489 = {2{and_2465}} | or_2488[4:3];
  // hls/stages/agreement.hpp:635
  logic [7:0] or_2491;
  assign or_2491 = {or_2488[7:5], or_2489, or_2488[2:0]} | (equal_576 ? drawn_q : 8'h0);
  logic [4:0] or_2492;
  assign or_2492 = {5{so}} | {or_2491[6], or_2491[3:0]};
  // hls/stages/agreement.hpp:641
  logic not_2496;
  assign not_2496 = ~run_shift_q[5];
  logic [7:0] select_2499;
  assign select_2499 = equal_591 ? ({{7{not_2496}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:524
  logic [6:0] select_2503;
  assign select_2503 = and_2452_s4_q ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:527
  logic [7:0] select_2505;
  assign select_2505 = select_2455 ? {select_2503[6], select_2503} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2508;
  assign select_2508 = select_2455 ? (and_2452_s4_q ? 8'h18 : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:461
  logic [6:0] select_2515;
  assign select_2515 = equal_2451_s4_q ? ((6'he < column_s4_q[6:1]) ? 7'h1d : column_s4_q) : least_q;
  // hls/stages/agreement.hpp:521
  logic [7:0] select_2519;
  assign select_2519 = and_547_s4_q ? (equal_2451_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h17) : whole_q) : whole_q;
  logic [7:0] select_2522;
  assign select_2522 = and_547_s4_q ? (equal_2451_s4_q ? ({1'b0, cfg_width_i[10:4]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:532
  logic select_2536;
  assign select_2536 = (ends_cell_q | select_2455) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_591 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:527
  logic and_2540;
  assign and_2540 = (~select_2455) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:477
  logic equal_2542;
  assign equal_2542 = {sum_2541_s4_q[7], cfg_height_i[10:4]} == {1'b0, sum_2541_s4_q[6:0]};
  // hls/stages/agreement.hpp:521
  logic select_2544;
  assign select_2544 = and_547_s4_q ? (equal_2451_s4_q ? equal_2542 : final_row_q) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2919;
  assign select_2919 = and_1673 ? (sample_pair_first_s4_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/patches.hpp:371
  logic [8:0] sum_2983;
  assign sum_2983 = {1'b0, select_511_s4_q[3], or_2982_s4_q, select_675_s4_q} + 9'h1;

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
      run_shift_q <= select_2459;
      run_last_shift_q <= select_2462;
      run_span_q <= select_2464;
      following_phase_q <= select_2477;
      following_shift_q <= select_2467 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2480;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2483[6], or_2484, select_2483[3:0]};
      following_columns_q <= {or_2491[7], or_2492[4], or_2491[5:4], or_2492[3:0]};
      plan_shift_q <= equal_591 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2499;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2505;
      columns_left_q <= select_2508;
      last_q <= and_547_s4_q ? (equal_2451_s4_q ? column_s4_q : last_q) : last_q;
      least_q <= and_547_s4_q ? select_2515 : least_q;
      whole_q <= select_2519;
      drawn_q <= select_2522;
      slot_q <= select_2455 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2536;
      ends_q <= and_2540;
      final_row_q <= select_2544;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= sample_pair_whole_s4_q ? select_2919 : patches_phase_q;
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
  logic [3:0] select_508_s5_q;
  logic equal_509_s5_q;
  logic [6:0] select_511_s5_q;
  logic [8:0] select_515_s5_q;
  logic and_521_s5_q;
  logic equal_527_s5_q;
  logic [6:0] column_s5_q;
  logic and_545_s5_q;
  logic and_547_s5_q;
  logic equal_572_s5_q;
  logic so_s5_q;
  logic equal_576_s5_q;
  logic [7:0] sum_578_s5_q;
  logic equal_591_s5_q;
  logic equal_592_s5_q;
  logic [7:0] sum_609_s5_q;
  logic [6:0] row_s5_q;
  logic and_1673_s5_q;
  logic equal_1679_s5_q;
  logic equal_2451_s5_q;
  logic and_2452_s5_q;
  logic select_2455_s5_q;
  logic [3:0] phase_s5_q;
  logic not_2985_s5_q;
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
      select_508_s5_q <= select_508_s4_q;
      equal_509_s5_q <= equal_509_s4_q;
      select_511_s5_q <= select_511_s4_q;
      select_515_s5_q <= select_515_s4_q;
      and_521_s5_q <= and_521_s4_q;
      equal_527_s5_q <= select_526_s4_q == 4'h0;
      column_s5_q <= column_s4_q;
      and_545_s5_q <= and_545_s4_q;
      and_547_s5_q <= and_547_s4_q;
      equal_572_s5_q <= run_phase_q == 3'h7;
      so_s5_q <= so;
      equal_576_s5_q <= equal_576;
      sum_578_s5_q <= {{2{run_shift_q[5]}}, run_shift_q} + x_q;
      equal_591_s5_q <= equal_591;
      equal_592_s5_q <= equal_592;
      sum_609_s5_q <= {1'b0, last_q} + 8'h3;
      row_s5_q <= row_s4_q;
      and_1673_s5_q <= and_1673;
      equal_1679_s5_q <= equal_1679_s4_q;
      equal_2451_s5_q <= equal_2451_s4_q;
      and_2452_s5_q <= and_2452_s4_q;
      select_2455_s5_q <= select_2455;
      phase_s5_q <= phase;
      not_2985_s5_q <= ~({sum_2983, select_526_s4_q, 1'b0} < {3'h0, cfg_height_i});
    end
  end

  // Stage 5 -----------------------------------------------------------------------------------------------------------
  logic [6:0] age_q;
  // hls/stages/agreement.hpp:595
  logic [7:0] select_579;
  assign select_579 = run_shift_s5_q[5] ? x_s5_q : sum_578_s5_q;
  logic less_580;
  assign less_580 = {1'b0, last_s5_q} < select_579;
  // hls/stages/agreement.hpp:226
  logic not_581;
  assign not_581 = ~less_580;
  // hls/stages/agreement.hpp:799
  logic [7:0] x;
  assign x = x_s5_q + 8'hfd;
  // hls/stages/agreement.hpp:529
  logic [6:0] select_2524;
  assign select_2524 = select_2455_s5_q ? 7'h0 : (ends_cell_s5_q ? {age_q[5:0], 1'b1} : age_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      age_q <= 7'h0;
    end else if (s5_en) begin
      age_q <= select_2524;
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
  logic [3:0] select_508_s6_q;
  logic equal_509_s6_q;
  logic [6:0] select_511_s6_q;
  logic [8:0] select_515_s6_q;
  logic and_521_s6_q;
  logic equal_527_s6_q;
  logic [6:0] column_s6_q;
  logic and_545_s6_q;
  logic and_547_s6_q;
  logic equal_572_s6_q;
  logic so_s6_q;
  logic equal_576_s6_q;
  logic [6:0] sum_578_s6_q;
  logic less_580_s6_q;
  logic not_581_s6_q;
  logic equal_591_s6_q;
  logic and_593_s6_q;
  logic [6:0] x_s6_2_q;
  logic and_613_s6_q;
  logic [6:0] row_s6_q;
  logic equal_1560_s6_q;
  logic and_1673_s6_q;
  logic equal_1679_s6_q;
  logic equal_2451_s6_q;
  logic and_2452_s6_q;
  logic [3:0] phase_s6_q;
  logic equal_2939_s6_q;
  logic [3:0] select_2942_s6_q;
  logic not_2985_s6_q;
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
      select_508_s6_q <= select_508_s5_q;
      equal_509_s6_q <= equal_509_s5_q;
      select_511_s6_q <= select_511_s5_q;
      select_515_s6_q <= select_515_s5_q;
      and_521_s6_q <= and_521_s5_q;
      equal_527_s6_q <= equal_527_s5_q;
      column_s6_q <= column_s5_q;
      and_545_s6_q <= and_545_s5_q;
      and_547_s6_q <= and_547_s5_q;
      equal_572_s6_q <= equal_572_s5_q;
      so_s6_q <= so_s5_q;
      equal_576_s6_q <= equal_576_s5_q;
      sum_578_s6_q <= sum_578_s5_q[6:0];
      less_580_s6_q <= less_580;
      not_581_s6_q <= not_581;
      equal_591_s6_q <= equal_591_s5_q;
      and_593_s6_q <= equal_592_s5_q & not_581;
      x_s6_2_q <= x[6:0];
      and_613_s6_q <= age_q[2] & (ends_cell_s5_q & (~(sum_609_s5_q < select_579)));
      row_s6_q <= row_s5_q;
      equal_1560_s6_q <= {x[7], last_s5_q} == {1'b0, x[6:0]};
      and_1673_s6_q <= and_1673_s5_q;
      equal_1679_s6_q <= equal_1679_s5_q;
      equal_2451_s6_q <= equal_2451_s5_q;
      and_2452_s6_q <= and_2452_s5_q;
      phase_s6_q <= phase_s5_q;
      equal_2939_s6_q <= row_s5_q == 7'h3;
      select_2942_s6_q <= (patches_phase_q == 4'h2) ? 4'h0 : (patches_phase_q + 4'h1);
      not_2985_s6_q <= not_2985_s5_q;
    end
  end

  // Stage 6 -----------------------------------------------------------------------------------------------------------
  logic [3:0] patches_choosing_rows_to_next_q;
  // hls/stages/agreement.hpp:595
  logic or_577;
  assign or_577 = so_s6_q | equal_576_s6_q;
  // hls/stages/agreement.hpp:149
  logic select_595;
  assign select_595 = or_577 ? not_581_s6_q : (equal_591_s6_q ? not_581_s6_q : and_593_s6_q);
  logic and_614;
  assign and_614 = equal_591_s6_q & and_613_s6_q;
  logic select_615;
  assign select_615 = or_577 ? not_581_s6_q : and_614;
  // hls/stages/agreement.hpp:822
  logic [6:0] right;
  assign right = sum_578_s6_q + 7'h7d;
  // hls/stages/agreement.hpp:149
  logic [6:0] select_639;
  assign select_639 = or_577 ? x_s6_q[6:0] : (equal_591_s6_q ? sum_578_s6_q : x_s6_q[6:0]);
  // hls/stages/agreement.hpp:721
  logic not_645;
  assign not_645 = ~or_577;
  // hls/stages/agreement.hpp:521
  logic and_2809;
  assign and_2809 = and_547_s6_q & (equal_2451_s6_q & (row_s6_q[6:2] == 5'h0));
  // hls/stages/patches.hpp:87
  logic [3:0] select_2943;
  assign select_2943 = equal_2939_s6_q ? select_2942_s6_q : patches_choosing_rows_to_next_q;
  logic equal_2944;
  assign equal_2944 = select_2943 == 4'h0;
  // hls/stages/agreement.hpp:461
  logic [3:0] select_2947;
  assign select_2947 = equal_2451_s6_q ? (equal_2944 ? 4'h2 : (select_2943 + 4'hf)) : patches_choosing_rows_to_next_q;

  // Memory left, 120 x 85, DISTANCE 24, hls/stages/agreement.hpp:1374; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [84:0] left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_mem[i] = 85'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_s6_q[6:0];
  logic left_re;
  assign left_re = s6_en & select_595;
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 120 x 99, DISTANCE 24, hls/stages/agreement.hpp:1375; read in stage 6, written in stage 9: 6 < 9 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [98:0] right_codes_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = select_639;
  logic right_codes_re;
  assign right_codes_re = s6_en & select_595;
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 120 x 62, DISTANCE 24, hls/stages/agreement.hpp:1376; read in stage 6, written in stage 17: 6 < 17 < 6 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [61:0] best_left_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_left_mem[i] = 62'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_577 ? x_s6_q[6:0] : x_s6_2_q;
  logic best_left_re;
  assign best_left_re = s6_en & select_615;
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_choosing_rows_to_next_q <= 4'h0;
    end else if (s6_en) begin
      patches_choosing_rows_to_next_q <= and_547_s6_q ? select_2947 : patches_choosing_rows_to_next_q;
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
  logic and_521_s7_q;
  logic equal_527_s7_q;
  logic [6:0] column_s7_q;
  logic and_545_s7_q;
  logic and_547_s7_q;
  logic equal_572_s7_q;
  logic so_s7_q;
  logic equal_576_s7_q;
  logic or_577_s7_q;
  logic less_580_s7_q;
  logic not_581_s7_q;
  logic equal_591_s7_q;
  logic [6:0] x_s7_2_q;
  logic select_615_s7_q;
  logic [6:0] right_s7_q;
  logic and_648_s7_q;
  logic [6:0] row_s7_q;
  logic and_1559_s7_q;
  logic equal_1560_s7_q;
  logic and_1673_s7_q;
  logic equal_1679_s7_q;
  logic equal_2451_s7_q;
  logic and_2810_s7_q;
  logic and_2812_s7_q;
  logic and_2819_s7_q;
  logic [3:0] phase_s7_q;
  logic equal_2939_s7_q;
  logic equal_2944_s7_q;
  logic not_2985_s7_q;
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
      select_508_s7_q <= select_508_s6_q;
      equal_509_s7_q <= equal_509_s6_q;
      select_511_s7_q <= select_511_s6_q;
      select_515_s7_q <= select_515_s6_q;
      and_521_s7_q <= and_521_s6_q;
      equal_527_s7_q <= equal_527_s6_q;
      column_s7_q <= column_s6_q;
      and_545_s7_q <= and_545_s6_q;
      and_547_s7_q <= and_547_s6_q;
      equal_572_s7_q <= equal_572_s6_q;
      so_s7_q <= so_s6_q;
      equal_576_s7_q <= equal_576_s6_q;
      or_577_s7_q <= or_577;
      less_580_s7_q <= less_580_s6_q;
      not_581_s7_q <= not_581_s6_q;
      equal_591_s7_q <= equal_591_s6_q;
      x_s7_2_q <= x_s6_2_q;
      select_615_s7_q <= select_615;
      right_s7_q <= right;
      and_648_s7_q <= not_645 & ((~equal_591_s6_q) & and_593_s6_q);
      row_s7_q <= row_s6_q;
      and_1559_s7_q <= not_645 & and_614;
      equal_1560_s7_q <= equal_1560_s6_q;
      and_1673_s7_q <= and_1673_s6_q;
      equal_1679_s7_q <= equal_1679_s6_q;
      equal_2451_s7_q <= equal_2451_s6_q;
      and_2810_s7_q <= and_2452_s6_q & and_2809;
      and_2812_s7_q <= and_2452_s6_q & (~and_2809);
      and_2819_s7_q <= ends_cell_s6_q & so_s6_q;
      phase_s7_q <= phase_s6_q;
      equal_2939_s7_q <= equal_2939_s6_q;
      equal_2944_s7_q <= equal_2944;
      not_2985_s7_q <= not_2985_s6_q;
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
  logic not_1677;
  assign not_1677 = ~sample_pair_first_s7_q;
  // hls/stages/patches.hpp:311
  logic equal_1681;
  assign equal_1681 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/registration.hpp:218
  logic [16:0] select_1753;
  assign select_1753 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1978;
  assign sum_1978 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2813;
  assign select_2813 = and_2812_s7_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2815;
  assign select_2815 = and_2810_s7_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2813[15]}}, select_2813});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2816;
  assign select_2816 = and_2812_s7_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2816[15]}}, select_2816};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2818;
  assign select_2818 = and_2810_s7_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2819_s7_q ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:373
  logic and_2921;
  assign and_2921 = not_1677 & equal_1679_s7_q;
  logic [8:0] select_2922;
  assign select_2922 = and_2921 ? {patches_choosing_number_q, patches_choosing_rows_to_next_s7_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2923;
  assign select_2923 = and_2921 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2924;
  assign select_2924 = sample_pair_first_s7_q ? select_2922 : select_2923;
  // hls/stages/patches.hpp:126
  logic [3:0] select_2925;
  assign select_2925 = and_1673_s7_q ? select_2924[3:0] : patches_band_rows_rows_to_next_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2926;
  assign select_2926 = sample_pair_whole_s7_q ? select_2925 : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2928;
  assign select_2928 = sample_pair_whole_s7_q ? (and_1673_s7_q ? select_2924[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2931;
  assign select_2931 = sample_pair_whole_s7_q ? (equal_1681 ? 4'h2 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2933;
  assign select_2933 = sample_pair_whole_s7_q ? (patches_band_rows_number_q + {4'h0, equal_1681}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2934;
  assign equal_2934 = phase_s7_q == 4'h0;
  // hls/stages/patches.hpp:331
  logic not_2935;
  assign not_2935 = ~equal_2934;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2937;
  assign select_2937 = sample_pair_whole_s7_q ? (phase_s7_q + {{2{not_2935}}, 1'b1, not_2935}) : patches_first_band_rows_to_next_q;
  logic select_2938;
  assign select_2938 = sample_pair_whole_s7_q ? equal_2934 : patches_first_band_number_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2949;
  assign select_2949 = equal_2939_s7_q ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:461
  logic [4:0] select_2951;
  assign select_2951 = equal_2451_s7_q ? (select_2949 + {4'h0, equal_2944_s7_q}) : patches_choosing_number_q;
  logic select_2955;
  assign select_2955 = equal_2451_s7_q ? ((7'h2 < row_s7_q) & equal_2944_s7_q) : patches_chooses_q;
  // hls/stages/agreement.hpp:521
  logic [4:0] select_2958;
  assign select_2958 = and_547_s7_q ? (equal_2451_s7_q ? select_2949 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3867;
  assign select_3867 = so_s7_q ? (and_2819_s7_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3869;
  assign sum_3869 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3870;
  assign select_3870 = sum_1978[5] ? {1'b1, sum_1978[4:0], region_across_rest_q[2:0]} : sum_3869;
  // hls/stages/agreement.hpp:461
  logic [8:0] select_3872;
  assign select_3872 = equal_2451_s7_q ? (9'h1f0 - {2'h0, cfg_width_i[10:4]}) : columns_begin_rest_q;
  logic [7:0] select_3875;
  assign select_3875 = equal_2451_s7_q ? (8'h8 - {1'b0, cfg_width_i[10:4]}) : columns_begin_back_q;

  // Memory fresh, 120 x 33, DISTANCE 24, hls/stages/agreement.hpp:1373; read in stage 7, written in stage 22: 7 < 22 < 7 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] fresh_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) fresh_mem[i] = 33'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_s7_q[6:0];
  logic fresh_re;
  assign fresh_re = s7_en & and_648_s7_q;
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
      registration_slope_row_q <= select_2815;
      registration_slope_change_q <= select_2818;
      registration_slope_q <= so_s7_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_band_rows_rows_to_next_q <= select_2926;
      patches_band_rows_number_q <= select_2928;
      patches_next_band_rows_to_next_q <= select_2931;
      patches_next_band_number_q <= select_2933;
      patches_first_band_rows_to_next_q <= select_2937;
      patches_first_band_number_q <= select_2938;
      patches_choosing_number_q <= and_547_s7_q ? select_2951 : patches_choosing_number_q;
      patches_chooses_q <= and_547_s7_q ? select_2955 : patches_chooses_q;
      patches_choosing_band_q <= select_2958;
      region_across_rest_q <= select_3867;
      region_across_back_q <= so_s7_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3870;
      columns_begin_rest_q <= and_547_s7_q ? select_3872 : columns_begin_rest_q;
      columns_begin_back_q <= and_547_s7_q ? select_3875 : columns_begin_back_q;
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
  logic [3:0] select_508_s8_q;
  logic equal_509_s8_q;
  logic [6:0] select_511_s8_q;
  logic [8:0] select_515_s8_q;
  logic and_521_s8_q;
  logic equal_527_s8_q;
  logic [6:0] column_s8_q;
  logic and_545_s8_q;
  logic and_547_s8_q;
  logic equal_572_s8_q;
  logic so_s8_q;
  logic equal_576_s8_q;
  logic or_577_s8_q;
  logic less_580_s8_q;
  logic not_581_s8_q;
  logic equal_591_s8_q;
  logic [84:0] left_rdata_s8_q;
  logic [6:0] x_s8_2_q;
  logic select_615_s8_q;
  logic [61:0] best_left_rdata_s8_q;
  logic [6:0] right_s8_q;
  logic [98:0] right_codes_rdata_s8_q;
  logic and_648_s8_q;
  logic [6:0] row_s8_q;
  logic and_1559_s8_q;
  logic equal_1560_s8_q;
  logic and_1673_s8_q;
  logic not_1677_s8_q;
  logic or_1683_s8_q;
  logic [16:0] select_1753_s8_q;
  logic sum_1978_s8_q;
  logic equal_2451_s8_q;
  logic not_2985_s8_q;
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
      select_508_s8_q <= select_508_s7_q;
      equal_509_s8_q <= equal_509_s7_q;
      select_511_s8_q <= select_511_s7_q;
      select_515_s8_q <= select_515_s7_q;
      and_521_s8_q <= and_521_s7_q;
      equal_527_s8_q <= equal_527_s7_q;
      column_s8_q <= column_s7_q;
      and_545_s8_q <= and_545_s7_q;
      and_547_s8_q <= and_547_s7_q;
      equal_572_s8_q <= equal_572_s7_q;
      so_s8_q <= so_s7_q;
      equal_576_s8_q <= equal_576_s7_q;
      or_577_s8_q <= or_577_s7_q;
      less_580_s8_q <= less_580_s7_q;
      not_581_s8_q <= not_581_s7_q;
      equal_591_s8_q <= equal_591_s7_q;
      left_rdata_s8_q <= left_rdata_q;
      x_s8_2_q <= x_s7_2_q;
      select_615_s8_q <= select_615_s7_q;
      best_left_rdata_s8_q <= best_left_rdata_q;
      right_s8_q <= right_s7_q;
      right_codes_rdata_s8_q <= right_codes_rdata_q;
      and_648_s8_q <= and_648_s7_q;
      row_s8_q <= row_s7_q;
      and_1559_s8_q <= and_1559_s7_q;
      equal_1560_s8_q <= equal_1560_s7_q;
      and_1673_s8_q <= and_1673_s7_q;
      not_1677_s8_q <= not_1677;
      or_1683_s8_q <= (~equal_1679_s7_q) | (~equal_1681);
      select_1753_s8_q <= select_1753;
      sum_1978_s8_q <= sum_1978[5];
      equal_2451_s8_q <= equal_2451_s7_q;
      not_2985_s8_q <= not_2985_s7_q;
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
  // hls/stages/agreement.hpp:669
  logic equal_566;
  assign equal_566 = row_q == 7'h0;
  // hls/stages/agreement.hpp:976
  logic and_605;
  assign and_605 = (or_577_s8_q & (left_rdata_s8_q[67] & not_581_s8_q)) & (~(row_q[6:3] == 4'h0));
  // hls/stages/agreement.hpp:967
  logic [5:0] shift;
  assign shift = slot_s8_q[2] ? best_left_rdata_s8_q[5:0] : best_left_rdata_s8_q[45:40];
  // hls/stages/agreement.hpp:669
  logic not_745;
  assign not_745 = ~equal_566;
  // hls/stages/agreement.hpp:221
  logic and_760;
  assign and_760 = left_rdata_s8_q[48] & not_581_s8_q;
  logic and_761;
  assign and_761 = right_codes_rdata_s8_q[42] & not_581_s8_q;
  logic [11:0] select_762;
  assign select_762 = less_580_s8_q ? 12'h0 : left_rdata_s8_q[47:36];
  logic [11:0] select_763;
  assign select_763 = less_580_s8_q ? 12'h0 : right_codes_rdata_s8_q[41:30];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_767;
  assign select_767 = and_760 ? (and_761 ? (~(select_762 ^ select_763)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_783;
  assign and_783 = left_rdata_s8_q[66] & not_581_s8_q;
  logic and_784;
  assign and_784 = right_codes_rdata_s8_q[57] & not_581_s8_q;
  logic [11:0] select_785;
  assign select_785 = less_580_s8_q ? 12'h0 : left_rdata_s8_q[65:54];
  logic [11:0] select_786;
  assign select_786 = less_580_s8_q ? 12'h0 : right_codes_rdata_s8_q[56:45];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_790;
  assign select_790 = and_783 ? (and_784 ? (~(select_785 ^ select_786)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_800;
  assign and_800 = left_rdata_s8_q[84] & not_581_s8_q;
  logic and_801;
  assign and_801 = right_codes_rdata_s8_q[72] & not_581_s8_q;
  logic [11:0] select_802;
  assign select_802 = less_580_s8_q ? 12'h0 : left_rdata_s8_q[83:72];
  logic [11:0] select_803;
  assign select_803 = less_580_s8_q ? 12'h0 : right_codes_rdata_s8_q[71:60];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_807;
  assign select_807 = and_800 ? (and_801 ? (~(select_802 ^ select_803)) : 12'h0) : 12'h0;
  logic [11:0] select_1015;
  assign select_1015 = (slot_s8_q[0] ? and_801 : and_784) ? (~(select_762 ^ (slot_s8_q[0] ? select_803 : select_786))) : 12'h0;
  // hls/stages/agreement.hpp:221
  logic and_1032;
  assign and_1032 = right_codes_rdata_s8_q[85] & not_581_s8_q;
  logic [11:0] select_1034;
  assign select_1034 = less_580_s8_q ? 12'h0 : right_codes_rdata_s8_q[84:73];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1038;
  assign select_1038 = (slot_s8_q[0] ? and_1032 : and_801) ? (~(select_785 ^ (slot_s8_q[0] ? select_1034 : select_803))) : 12'h0;
  // hls/stages/agreement.hpp:735
  logic select_1050;
  assign select_1050 = slot_s8_q[0] ? (right_codes_rdata_s8_q[98] & not_581_s8_q) : and_1032;
  logic [11:0] select_1052;
  assign select_1052 = slot_s8_q[0] ? (less_580_s8_q ? 12'h0 : right_codes_rdata_s8_q[97:86]) : select_1034;
  // hls/stages/agreement.hpp:221
  logic and_1261;
  assign and_1261 = right_codes_rdata_s8_q[27] & not_581_s8_q;
  // hls/stages/agreement.hpp:735
  logic select_1262;
  assign select_1262 = slot_s8_q[0] ? (right_codes_rdata_s8_q[12] & not_581_s8_q) : and_1261;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1264;
  assign select_1264 = less_580_s8_q ? 12'h0 : right_codes_rdata_s8_q[26:15];
  // hls/stages/agreement.hpp:735
  logic [11:0] select_1265;
  assign select_1265 = slot_s8_q[0] ? (less_580_s8_q ? 12'h0 : right_codes_rdata_s8_q[11:0]) : select_1264;
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1289;
  assign select_1289 = (slot_s8_q[0] ? and_1261 : and_761) ? (~(select_785 ^ (slot_s8_q[0] ? select_1264 : select_763))) : 12'h0;
  logic [11:0] select_1304;
  assign select_1304 = (slot_s8_q[0] ? and_761 : and_784) ? (~(select_802 ^ (slot_s8_q[0] ? select_763 : select_786))) : 12'h0;
  // hls/stages/patches.hpp:392
  logic not_1674;
  assign not_1674 = ~patches_begins_q;
  // hls/stages/patches.hpp:362
  logic and_1678;
  assign and_1678 = patches_capturing_q & not_1677_s8_q;
  // hls/stages/patches.hpp:125
  logic and_1686;
  assign and_1686 = (not_1674 & (patches_work_q == 3'h0)) & (~(and_1678 | or_1683_s8_q));
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s8_q[6:1]} < x_s8_q;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_577_s8_q ? (less_580_s8_q ? 6'h0 : best_left_rdata_s8_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [13:0] select_1755;
  assign select_1755 = ($signed(10'h0) < $signed(select_1753_s8_q[16:7])) ? 14'h7f : select_1753_s8_q[13:0];
  // hls/stages/patches.hpp:530
  logic equal_1785;
  assign equal_1785 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:501
  logic equal_1787;
  assign equal_1787 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:495
  logic equal_1789;
  assign equal_1789 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1790;
  assign equal_1790 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:530
  logic or_1791;
  assign or_1791 = equal_1789 | equal_1790;
  // hls/stages/patches.hpp:456
  logic not_1792;
  assign not_1792 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_1814;
  assign select_1814 = and_1686 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1815;
  assign select_1815 = and_1673_s8_q ? select_1814 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1817;
  assign and_1817 = and_1678 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1821;
  assign select_1821 = and_1673_s8_q ? (and_1686 | (and_1678 & (~and_1817))) : patches_capturing_q;
  // hls/stages/patches.hpp:167
  logic not_1846;
  assign not_1846 = ~equal_1790;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1860;
  assign select_1860 = and_1673_s8_q ? {select_1814[4], select_1814[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:542
  logic less_1946;
  assign less_1946 = patches_step_q[4:0] < 5'h11;
  logic equal_1947;
  assign equal_1947 = patches_step_q[6:5] == 2'h0;
  logic not_1948;
  assign not_1948 = ~equal_1947;
  logic equal_1949;
  assign equal_1949 = patches_step_q[6:5] == 2'h3;
  logic not_1950;
  assign not_1950 = ~equal_1949;
  // hls/stages/patches.hpp:556
  logic select_1953;
  assign select_1953 = equal_1949 ? (less_1946 & (less_1946 & not_1950)) : less_1946;
  // hls/stages/agreement.hpp:461
  logic select_2548;
  assign select_2548 = equal_2451_s8_q ? (~({row_s8_q, 1'b0} < {sum_2545, cfg_height_i[4]})) : lower_half_q;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2709;
  assign select_2709 = or_577_s8_q ? (less_580_s8_q ? 8'h0 : best_left_rdata_s8_q[32:25]) : 8'h0;
  logic [7:0] select_2711;
  assign select_2711 = or_577_s8_q ? (less_580_s8_q ? 8'h0 : best_left_rdata_s8_q[24:17]) : 8'h0;
  // hls/stages/patches.hpp:91
  logic parity_2962;
  assign parity_2962 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:461
  logic [15:0] select_2963;
  assign select_2963 = equal_2451_s8_q ? {patches_chance_q[14:0], parity_2962} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s8_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:393
  logic or_3026;
  assign or_3026 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3032;
  assign and_3032 = equal_1785 & not_1792;
  // hls/stages/patches.hpp:399
  logic and_3033;
  assign and_3033 = not_1846 & and_3032;
  logic [1:0] select_3035;
  assign select_3035 = equal_1787 ? 2'h0 : (equal_1789 ? 2'h3 : {equal_1790, and_3033});
  // hls/stages/patches.hpp:279
  logic equal_3037;
  assign equal_3037 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3038;
  assign not_3038 = ~equal_3037;
  // hls/stages/patches.hpp:279
  logic equal_3039;
  assign equal_3039 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3040;
  assign not_3040 = ~equal_3039;
  // hls/stages/patches.hpp:283
  logic not_3042;
  assign not_3042 = ~(patches_following_q == 3'h2);
  logic and_3045;
  assign and_3045 = (~(patches_following_q == 3'h1)) & not_3042;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3046;
  assign select_3046 = equal_3039 ? 2'h2 : {and_3045, not_3042};
  logic [3:0] select_3047;
  assign select_3047 = equal_3037 ? 4'h2 : {select_3046, {2{not_3040}}};
  // hls/stages/patches.hpp:405
  logic not_3050;
  assign not_3050 = ~or_3026;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3055;
  assign select_3055 = or_3026 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);

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
      row_q <= and_547_s8_q ? (equal_2451_s8_q ? row_s8_q : row_q) : row_q;
      lower_half_q <= and_547_s8_q ? select_2548 : lower_half_q;
      patches_chance_q <= and_547_s8_q ? select_2963 : patches_chance_q;
      patches_capturing_q <= sample_pair_whole_s8_q ? select_1821 : patches_capturing_q;
      patches_row_q <= sample_pair_whole_s8_q ? select_1815 : patches_row_q;
      patches_work_q <= or_3026 ? following : patches_work_q;
      patches_second_q <= not_1674 & (patches_second_q | (patches_ends_q & equal_1785));
      patches_following_q <= equal_1785 ? {2'h0, and_3032} : {equal_1787, select_3035};
      patches_following_beats_q <= {select_3047, not_3038};
      patches_begins_q <= sample_pair_whole_s8_q & (and_1673_s8_q & and_1817);
      patches_ends_q <= not_3050 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3055;
      patches_step_q <= or_3026 ? 7'h0 : (patches_step_q + 7'h1);
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
  logic [3:0] select_508_s9_q;
  logic equal_509_s9_q;
  logic [6:0] select_511_s9_q;
  logic [8:0] select_515_s9_q;
  logic and_521_s9_q;
  logic equal_527_s9_q;
  logic [6:0] column_s9_q;
  logic and_545_s9_q;
  logic and_547_s9_q;
  logic equal_566_s9_q;
  logic equal_572_s9_q;
  logic so_s9_q;
  logic equal_576_s9_q;
  logic or_577_s9_q;
  logic less_580_s9_q;
  logic not_581_s9_q;
  logic equal_591_s9_q;
  logic [62:0] left_rdata_s9_q;
  logic and_598_s9_q;
  logic and_606_s9_q;
  logic [6:0] x_s9_2_q;
  logic select_615_s9_q;
  logic [61:0] best_left_rdata_s9_q;
  logic [5:0] shift_s9_q;
  logic [6:0] right_s9_q;
  logic and_637_s9_q;
  logic [77:0] right_codes_rdata_s9_q;
  logic and_642_s9_q;
  logic and_644_s9_q;
  logic and_648_s9_q;
  logic [32:0] fresh_rdata_s9_q;
  logic equal_677_s9_q;
  logic and_746_s9_q;
  logic and_747_s9_q;
  logic and_748_s9_q;
  logic and_749_s9_q;
  logic and_750_s9_q;
  logic and_751_s9_q;
  logic and_752_s9_q;
  logic and_753_s9_q;
  logic and_754_s9_q;
  logic and_755_s9_q;
  logic and_760_s9_q;
  logic [11:0] select_767_s9_q;
  logic and_783_s9_q;
  logic [11:0] select_790_s9_q;
  logic and_800_s9_q;
  logic [11:0] select_807_s9_q;
  logic [11:0] select_1015_s9_q;
  logic [11:0] select_1038_s9_q;
  logic [11:0] select_1055_s9_q;
  logic [11:0] select_1268_s9_q;
  logic [11:0] select_1289_s9_q;
  logic [11:0] select_1304_s9_q;
  logic and_1559_s9_q;
  logic equal_1560_s9_q;
  logic and_1673_s9_q;
  logic and_1686_s9_q;
  logic right_3_s9_q;
  logic less_1700_s9_q;
  logic [5:0] b_s9_q;
  logic [13:0] select_1755_s9_q;
  logic equal_1785_s9_q;
  logic equal_1787_s9_q;
  logic equal_1789_s9_q;
  logic equal_1790_s9_q;
  logic or_1791_s9_q;
  logic and_1794_s9_q;
  logic [4:0] select_1815_s9_q;
  logic select_1821_s9_q;
  logic and_1827_s9_q;
  logic and_1847_s9_q;
  logic [3:0] select_1860_s9_q;
  logic less_1946_s9_q;
  logic equal_1947_s9_q;
  logic not_1948_s9_q;
  logic equal_1949_s9_q;
  logic not_1950_s9_q;
  logic select_1953_s9_q;
  logic and_1954_s9_q;
  logic sum_1978_s9_q;
  logic and_1999_s9_q;
  logic and_2116_s9_q;
  logic equal_2262_s9_q;
  logic equal_2451_s9_q;
  logic and_2577_s9_q;
  logic [7:0] select_2709_s9_q;
  logic [7:0] select_2711_s9_q;
  logic [5:0] further_s9_q;
  logic not_2985_s9_q;
  logic or_3026_s9_q;
  logic not_3050_s9_q;
  logic and_3522_s9_q;
  logic equal_3529_s9_q;
  logic less_3855_s9_q;
  logic equal_4074_s9_q;
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
      select_508_s9_q <= select_508_s8_q;
      equal_509_s9_q <= equal_509_s8_q;
      select_511_s9_q <= select_511_s8_q;
      select_515_s9_q <= select_515_s8_q;
      and_521_s9_q <= and_521_s8_q;
      equal_527_s9_q <= equal_527_s8_q;
      column_s9_q <= column_s8_q;
      and_545_s9_q <= and_545_s8_q;
      and_547_s9_q <= and_547_s8_q;
      equal_566_s9_q <= equal_566;
      equal_572_s9_q <= equal_572_s8_q;
      so_s9_q <= so_s8_q;
      equal_576_s9_q <= equal_576_s8_q;
      or_577_s9_q <= or_577_s8_q;
      less_580_s9_q <= less_580_s8_q;
      not_581_s9_q <= not_581_s8_q;
      equal_591_s9_q <= equal_591_s8_q;
      left_rdata_s9_q <= {left_rdata_s8_q[65:49], left_rdata_s8_q[47:31], left_rdata_s8_q[29:13], left_rdata_s8_q[11:0]};
      and_598_s9_q <= or_577_s8_q & (left_rdata_s8_q[70] & not_581_s8_q);
      and_606_s9_q <= (or_577_s8_q & (left_rdata_s8_q[68] & not_581_s8_q)) & and_605;
      x_s9_2_q <= x_s8_2_q;
      select_615_s9_q <= select_615_s8_q;
      best_left_rdata_s9_q <= best_left_rdata_s8_q;
      shift_s9_q <= shift;
      right_s9_q <= right_s8_q;
      and_637_s9_q <= or_577_s8_q & (left_rdata_s8_q[71] & not_581_s8_q);
      right_codes_rdata_s9_q <= {right_codes_rdata_s8_q[84:73], right_codes_rdata_s8_q[71:60], right_codes_rdata_s8_q[56:43], right_codes_rdata_s8_q[41:28], right_codes_rdata_s8_q[26:13], right_codes_rdata_s8_q[11:0]};
      and_642_s9_q <= or_577_s8_q & (right_codes_rdata_s8_q[58] & not_581_s8_q);
      and_644_s9_q <= or_577_s8_q & (right_codes_rdata_s8_q[59] & not_581_s8_q);
      and_648_s9_q <= and_648_s8_q;
      fresh_rdata_s9_q <= fresh_rdata_q;
      equal_677_s9_q <= row_s8_q == 7'h0;
      and_746_s9_q <= left_rdata_s8_q[12] & not_745;
      and_747_s9_q <= left_rdata_s8_q[30] & not_745;
      and_748_s9_q <= left_rdata_s8_q[48] & not_745;
      and_749_s9_q <= left_rdata_s8_q[66] & not_745;
      and_750_s9_q <= right_codes_rdata_s8_q[12] & not_745;
      and_751_s9_q <= right_codes_rdata_s8_q[27] & not_745;
      and_752_s9_q <= right_codes_rdata_s8_q[42] & not_745;
      and_753_s9_q <= right_codes_rdata_s8_q[57] & not_745;
      and_754_s9_q <= right_codes_rdata_s8_q[72] & not_745;
      and_755_s9_q <= right_codes_rdata_s8_q[85] & not_745;
      and_760_s9_q <= and_760;
      select_767_s9_q <= select_767;
      and_783_s9_q <= and_783;
      select_790_s9_q <= select_790;
      and_800_s9_q <= and_800;
      select_807_s9_q <= select_807;
      select_1015_s9_q <= select_1015;
      select_1038_s9_q <= select_1038;
      select_1055_s9_q <= select_1050 ? (~(select_802 ^ select_1052)) : 12'h0;
      select_1268_s9_q <= select_1262 ? (~(select_762 ^ select_1265)) : 12'h0;
      select_1289_s9_q <= select_1289;
      select_1304_s9_q <= select_1304;
      and_1559_s9_q <= and_1559_s8_q;
      equal_1560_s9_q <= equal_1560_s8_q;
      and_1673_s9_q <= and_1673_s8_q;
      and_1686_s9_q <= and_1686;
      right_3_s9_q <= right_3;
      less_1700_s9_q <= 6'h4 < row_q[6:1];
      b_s9_q <= b;
      select_1755_s9_q <= select_1755;
      equal_1785_s9_q <= equal_1785;
      equal_1787_s9_q <= equal_1787;
      equal_1789_s9_q <= equal_1789;
      equal_1790_s9_q <= equal_1790;
      or_1791_s9_q <= or_1791;
      and_1794_s9_q <= or_1791 & (equal_1790 & not_1792);
      select_1815_s9_q <= select_1815;
      select_1821_s9_q <= select_1821;
      and_1827_s9_q <= or_1791 & (patches_second_q & equal_1790);
      and_1847_s9_q <= not_1846 & or_1791;
      select_1860_s9_q <= select_1860;
      less_1946_s9_q <= less_1946;
      equal_1947_s9_q <= equal_1947;
      not_1948_s9_q <= not_1948;
      equal_1949_s9_q <= equal_1949;
      not_1950_s9_q <= not_1950;
      select_1953_s9_q <= select_1953;
      and_1954_s9_q <= not_1948 & select_1953;
      sum_1978_s9_q <= sum_1978_s8_q;
      and_1999_s9_q <= or_577_s8_q & (left_rdata_s8_q[69] & not_581_s8_q);
      and_2116_s9_q <= (7'h6 < row_q) & (~(x_s8_q[7:2] == 6'h0));
      equal_2262_s9_q <= (column_s8_q | row_s8_q) == 7'h0;
      equal_2451_s9_q <= equal_2451_s8_q;
      and_2577_s9_q <= not_581_s8_q & and_605;
      select_2709_s9_q <= select_2709;
      select_2711_s9_q <= select_2711;
      further_s9_q <= further;
      not_2985_s9_q <= not_2985_s8_q;
      or_3026_s9_q <= or_3026;
      not_3050_s9_q <= not_3050;
      and_3522_s9_q <= less_1946 & (patches_step_q[6:5] == 2'h1);
      equal_3529_s9_q <= patches_step_q[6:5] == 2'h2;
      less_3855_s9_q <= 6'h2 < row_s8_q[6:1];
      equal_4074_s9_q <= row_s8_q[6:3] == 4'h0;
    end
  end

  // Stage 9 -----------------------------------------------------------------------------------------------------------
  logic patches_lower_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:968
  logic [7:0] found;
  assign found = x_s9_q + {{2{shift_s9_q[5]}}, shift_s9_q};
  // hls/stages/count_bits.hpp:24
  logic parity_773;
  assign parity_773 = ^select_767_s9_q[5:3];
  logic parity_776;
  assign parity_776 = ^select_767_s9_q[8:6];
  logic parity_779;
  assign parity_779 = ^select_767_s9_q[11:3];
  logic parity_793;
  assign parity_793 = ^select_790_s9_q[8:6];
  logic parity_796;
  assign parity_796 = ^select_790_s9_q[11:9];
  logic parity_813;
  assign parity_813 = ^select_807_s9_q[2:0];
  logic parity_816;
  assign parity_816 = ^select_807_s9_q[5:3];
  logic parity_819;
  assign parity_819 = ^select_807_s9_q[8:0];
  logic parity_825;
  assign parity_825 = ^select_807_s9_q[11:9];
  logic parity_828;
  assign parity_828 = ^select_790_s9_q[2:0];
  logic parity_831;
  assign parity_831 = ^{select_807_s9_q[11:9], select_790_s9_q[5:0]};
  logic parity_834;
  assign parity_834 = ^{select_807_s9_q, select_790_s9_q, select_767_s9_q[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_839;
  assign or_839 = (select_767_s9_q[1:0] == 2'h3) | (select_767_s9_q[2] & (select_767_s9_q[0] | select_767_s9_q[1]));
  // hls/stages/count_bits.hpp:25
  logic or_843;
  assign or_843 = (select_790_s9_q[7:6] == 2'h3) | (select_790_s9_q[8] & (select_790_s9_q[6] | select_790_s9_q[7]));
  logic or_847;
  assign or_847 = (select_790_s9_q[10:9] == 2'h3) | (select_790_s9_q[11] & (select_790_s9_q[9] | select_790_s9_q[10]));
  // hls/stages/count_bits.hpp:23
  logic or_855;
  assign or_855 = (select_807_s9_q[7:6] == 2'h3) | (select_807_s9_q[8] & (~(select_807_s9_q[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_859;
  assign or_859 = (select_807_s9_q[1:0] == 2'h3) | (select_807_s9_q[2] & (select_807_s9_q[0] | select_807_s9_q[1]));
  logic or_863;
  assign or_863 = (select_807_s9_q[4:3] == 2'h3) | (select_807_s9_q[5] & (select_807_s9_q[3] | select_807_s9_q[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_866;
  assign parity_866 = ^{or_863, or_859, or_855};
  // hls/stages/count_bits.hpp:23
  logic or_870;
  assign or_870 = (select_790_s9_q[4:3] == 2'h3) | (select_790_s9_q[5] & (select_790_s9_q[3] | select_790_s9_q[4]));
  // hls/stages/count_bits.hpp:25
  logic or_874;
  assign or_874 = (select_807_s9_q[10:9] == 2'h3) | (select_807_s9_q[11] & (select_807_s9_q[9] | select_807_s9_q[10]));
  logic or_878;
  assign or_878 = (select_790_s9_q[1:0] == 2'h3) | (select_790_s9_q[2] & (select_790_s9_q[0] | select_790_s9_q[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_881;
  assign parity_881 = ^{or_878, or_874, or_870};
  logic parity_884;
  assign parity_884 = ^{or_878, or_874, or_870, or_863, or_859, or_855, or_847, or_843, or_839};
  // hls/stages/count_bits.hpp:25
  logic or_889;
  assign or_889 = (parity_773 & parity_776) | ((^select_767_s9_q[11:9]) & (parity_773 | parity_776));
  logic and_892;
  assign and_892 = (^{select_790_s9_q[11:6], select_767_s9_q[2:0]}) & (parity_819 | parity_831);
  // hls/stages/count_bits.hpp:23
  logic or_900;
  assign or_900 = (select_767_s9_q[10:9] == 2'h3) | (select_767_s9_q[11] & (select_767_s9_q[9] | select_767_s9_q[10]));
  // hls/stages/count_bits.hpp:25
  logic or_904;
  assign or_904 = (select_767_s9_q[4:3] == 2'h3) | (select_767_s9_q[5] & (select_767_s9_q[3] | select_767_s9_q[4]));
  logic or_908;
  assign or_908 = (select_767_s9_q[7:6] == 2'h3) | (select_767_s9_q[8] & (select_767_s9_q[6] | select_767_s9_q[7]));
  logic or_915;
  assign or_915 = (parity_793 & parity_796) | ((^select_767_s9_q[2:0]) & (parity_793 | parity_796));
  logic or_919;
  assign or_919 = (parity_813 & parity_816) | ((^select_807_s9_q[8:6]) & (parity_813 | parity_816));
  logic or_923;
  assign or_923 = (parity_825 & parity_828) | ((^select_790_s9_q[5:3]) & (parity_825 | parity_828));
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1016;
  assign select_1016 = and_760_s9_q ? select_1015_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1022;
  assign parity_1022 = ^select_1016[5:3];
  logic parity_1025;
  assign parity_1025 = ^select_1016[8:6];
  logic parity_1028;
  assign parity_1028 = ^select_1016[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1039;
  assign select_1039 = and_783_s9_q ? select_1038_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1042;
  assign parity_1042 = ^select_1039[8:6];
  logic parity_1045;
  assign parity_1045 = ^select_1039[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1056;
  assign select_1056 = and_800_s9_q ? select_1055_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1062;
  assign parity_1062 = ^select_1056[2:0];
  logic parity_1065;
  assign parity_1065 = ^select_1056[5:3];
  logic parity_1068;
  assign parity_1068 = ^select_1056[8:0];
  logic parity_1074;
  assign parity_1074 = ^select_1056[11:9];
  logic parity_1077;
  assign parity_1077 = ^select_1039[2:0];
  logic parity_1080;
  assign parity_1080 = ^{select_1056[11:9], select_1039[5:0]};
  logic parity_1083;
  assign parity_1083 = ^{select_1056, select_1039, select_1016[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1088;
  assign or_1088 = (select_1016[1:0] == 2'h3) | (select_1016[2] & (select_1016[0] | select_1016[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1092;
  assign or_1092 = (select_1039[7:6] == 2'h3) | (select_1039[8] & (select_1039[6] | select_1039[7]));
  logic or_1096;
  assign or_1096 = (select_1039[10:9] == 2'h3) | (select_1039[11] & (select_1039[9] | select_1039[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1104;
  assign or_1104 = (select_1056[7:6] == 2'h3) | (select_1056[8] & (~(select_1056[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1108;
  assign or_1108 = (select_1056[1:0] == 2'h3) | (select_1056[2] & (select_1056[0] | select_1056[1]));
  logic or_1112;
  assign or_1112 = (select_1056[4:3] == 2'h3) | (select_1056[5] & (select_1056[3] | select_1056[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1115;
  assign parity_1115 = ^{or_1112, or_1108, or_1104};
  // hls/stages/count_bits.hpp:23
  logic or_1119;
  assign or_1119 = (select_1039[4:3] == 2'h3) | (select_1039[5] & (select_1039[3] | select_1039[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1123;
  assign or_1123 = (select_1056[10:9] == 2'h3) | (select_1056[11] & (select_1056[9] | select_1056[10]));
  logic or_1127;
  assign or_1127 = (select_1039[1:0] == 2'h3) | (select_1039[2] & (select_1039[0] | select_1039[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1130;
  assign parity_1130 = ^{or_1127, or_1123, or_1119};
  logic parity_1133;
  assign parity_1133 = ^{or_1127, or_1123, or_1119, or_1112, or_1108, or_1104, or_1096, or_1092, or_1088};
  // hls/stages/count_bits.hpp:25
  logic or_1138;
  assign or_1138 = (parity_1022 & parity_1025) | ((^select_1016[11:9]) & (parity_1022 | parity_1025));
  logic and_1141;
  assign and_1141 = (^{select_1039[11:6], select_1016[2:0]}) & (parity_1068 | parity_1080);
  // hls/stages/count_bits.hpp:23
  logic or_1149;
  assign or_1149 = (select_1016[10:9] == 2'h3) | (select_1016[11] & (select_1016[9] | select_1016[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1153;
  assign or_1153 = (select_1016[4:3] == 2'h3) | (select_1016[5] & (select_1016[3] | select_1016[4]));
  logic or_1157;
  assign or_1157 = (select_1016[7:6] == 2'h3) | (select_1016[8] & (select_1016[6] | select_1016[7]));
  logic or_1164;
  assign or_1164 = (parity_1042 & parity_1045) | ((^select_1016[2:0]) & (parity_1042 | parity_1045));
  logic or_1168;
  assign or_1168 = (parity_1062 & parity_1065) | ((^select_1056[8:6]) & (parity_1062 | parity_1065));
  logic or_1172;
  assign or_1172 = (parity_1074 & parity_1077) | ((^select_1039[5:3]) & (parity_1074 | parity_1077));
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1269;
  assign select_1269 = and_760_s9_q ? select_1268_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1275;
  assign parity_1275 = ^select_1269[5:3];
  logic parity_1278;
  assign parity_1278 = ^select_1269[8:6];
  logic parity_1281;
  assign parity_1281 = ^select_1269[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1290;
  assign select_1290 = and_783_s9_q ? select_1289_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1293;
  assign parity_1293 = ^select_1290[8:6];
  logic parity_1296;
  assign parity_1296 = ^select_1290[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1305;
  assign select_1305 = and_800_s9_q ? select_1304_s9_q : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1311;
  assign parity_1311 = ^select_1305[2:0];
  logic parity_1314;
  assign parity_1314 = ^select_1305[5:3];
  logic parity_1317;
  assign parity_1317 = ^select_1305[8:0];
  logic parity_1323;
  assign parity_1323 = ^select_1305[11:9];
  logic parity_1326;
  assign parity_1326 = ^select_1290[2:0];
  logic parity_1329;
  assign parity_1329 = ^{select_1305[11:9], select_1290[5:0]};
  logic parity_1332;
  assign parity_1332 = ^{select_1305, select_1290, select_1269[2:0]};
  // hls/stages/count_bits.hpp:23
  logic or_1337;
  assign or_1337 = (select_1269[1:0] == 2'h3) | (select_1269[2] & (select_1269[0] | select_1269[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1341;
  assign or_1341 = (select_1290[7:6] == 2'h3) | (select_1290[8] & (select_1290[6] | select_1290[7]));
  logic or_1345;
  assign or_1345 = (select_1290[10:9] == 2'h3) | (select_1290[11] & (select_1290[9] | select_1290[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1353;
  assign or_1353 = (select_1305[7:6] == 2'h3) | (select_1305[8] & (~(select_1305[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1357;
  assign or_1357 = (select_1305[1:0] == 2'h3) | (select_1305[2] & (select_1305[0] | select_1305[1]));
  logic or_1361;
  assign or_1361 = (select_1305[4:3] == 2'h3) | (select_1305[5] & (select_1305[3] | select_1305[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1364;
  assign parity_1364 = ^{or_1361, or_1357, or_1353};
  // hls/stages/count_bits.hpp:23
  logic or_1368;
  assign or_1368 = (select_1290[4:3] == 2'h3) | (select_1290[5] & (select_1290[3] | select_1290[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1372;
  assign or_1372 = (select_1305[10:9] == 2'h3) | (select_1305[11] & (select_1305[9] | select_1305[10]));
  logic or_1376;
  assign or_1376 = (select_1290[1:0] == 2'h3) | (select_1290[2] & (select_1290[0] | select_1290[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1379;
  assign parity_1379 = ^{or_1376, or_1372, or_1368};
  logic parity_1382;
  assign parity_1382 = ^{or_1376, or_1372, or_1368, or_1361, or_1357, or_1353, or_1345, or_1341, or_1337};
  // hls/stages/count_bits.hpp:25
  logic or_1387;
  assign or_1387 = (parity_1275 & parity_1278) | ((^select_1269[11:9]) & (parity_1275 | parity_1278));
  logic and_1390;
  assign and_1390 = (^{select_1290[11:6], select_1269[2:0]}) & (parity_1317 | parity_1329);
  // hls/stages/count_bits.hpp:23
  logic or_1398;
  assign or_1398 = (select_1269[10:9] == 2'h3) | (select_1269[11] & (select_1269[9] | select_1269[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1402;
  assign or_1402 = (select_1269[4:3] == 2'h3) | (select_1269[5] & (select_1269[3] | select_1269[4]));
  logic or_1406;
  assign or_1406 = (select_1269[7:6] == 2'h3) | (select_1269[8] & (select_1269[6] | select_1269[7]));
  logic or_1413;
  assign or_1413 = (parity_1293 & parity_1296) | ((^select_1269[2:0]) & (parity_1293 | parity_1296));
  logic or_1417;
  assign or_1417 = (parity_1311 & parity_1314) | ((^select_1305[8:6]) & (parity_1311 | parity_1314));
  logic or_1421;
  assign or_1421 = (parity_1323 & parity_1326) | ((^select_1290[5:3]) & (parity_1323 | parity_1326));
  // hls/stages/agreement.hpp:247
  logic or_1580;
  assign or_1580 = (cfg_nearer_below_i & shift_s9_q[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift_s9_q)));
  // hls/stages/agreement.hpp:1010
  logic [5:0] sum_1645;
  assign sum_1645 = {1'b0, last_s9_q[6:2]} + 6'h1;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1729;
  assign sum_1729 = {2'h0, x_s9_q} + {{4{b_s9_q[5]}}, b_s9_q};
  // hls/stages/registration.hpp:213
  logic [9:0] select_1756;
  assign select_1756 = b_s9_q[4] ? select_1755_s9_q[9:0] : 10'h0;
  // hls/stages/registration.hpp:211
  logic [12:0] sum_1761;
  assign sum_1761 = (b_s9_q[0] ? select_1755_s9_q[13:1] : 13'h0) + (b_s9_q[1] ? select_1755_s9_q[12:0] : 13'h0);
  // hls/stages/registration.hpp:212
  logic [11:0] select_1762;
  assign select_1762 = b_s9_q[2] ? select_1755_s9_q[11:0] : 12'h0;
  // hls/stages/patches.hpp:508
  logic not_1786;
  assign not_1786 = ~equal_1785_s9_q;
  // hls/stages/patches.hpp:454
  logic not_1788;
  assign not_1788 = ~equal_1787_s9_q;
  logic and_1870;
  assign and_1870 = not_1786 & (or_1791_s9_q & not_1788);
  // hls/stages/patches.hpp:184
  logic and_1956;
  assign and_1956 = equal_1785_s9_q & (less_1946_s9_q ? and_1954_s9_q : select_1953_s9_q);
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2707;
  assign select_2707 = or_577_s9_q ? (less_580_s9_q ? 8'h0 : best_left_rdata_s9_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2709_s9_q} - {1'b0, select_2711_s9_q};
  // hls/stages/patches.hpp:110
  logic [5:0] select_2968;
  assign select_2968 = right_3_s9_q ? last_s9_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further_s9_q} + {1'b0, select_2968};
  // hls/stages/patches.hpp:126
  logic select_2987;
  assign select_2987 = and_1673_s9_q ? (and_1686_s9_q ? not_2985_s9_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:187
  logic [4:0] select_3057;
  assign select_3057 = or_3026_s9_q ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});
  // hls/stages/patches.hpp:556
  logic select_3525;
  assign select_3525 = equal_1949_s9_q ? (less_1946_s9_q ? (not_1950_s9_q & and_3522_s9_q) : and_3522_s9_q) : and_3522_s9_q;

  // Memory patches_right_0, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:775; read in stage 9, written in stage 22: 9 < 22 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s9_en & (not_1786 & (not_1788 & and_1794_s9_q));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 24, hls/stages/patches.hpp:775; read in stage 9, written in stage 22: 9 < 22 < 9 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s9_en & (not_1786 & (not_1788 & and_1827_s9_q));
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 24, hls/stages/patches.hpp:787; read in stage 9, written in stage 13: 9 < 13 < 9 + DISTANCE.
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
  assign patches_columns_above_re = s9_en & and_1870;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 24, hls/stages/patches.hpp:807; read in stage 9, written in stage 24: 9 < 24 < 9 + DISTANCE.
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
  assign patches_rows_re = s9_en & and_1956;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s9_q[6:0];
  logic left_we;
  assign left_we = s9_en & and_648_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_749_s9_q, left_rdata_s9_q[62:46], and_748_s9_q, left_rdata_s9_q[45:29], and_747_s9_q, left_rdata_s9_q[28:12], and_746_s9_q, left_rdata_s9_q[11:0], fresh_rdata_s9_q[30:26], fresh_rdata_s9_q[24], fresh_rdata_s9_q[11:0]};
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
  assign right_codes_we = s9_en & and_648_s9_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_755_s9_q, right_codes_rdata_s9_q[77:66], and_754_s9_q, right_codes_rdata_s9_q[65:54], and_753_s9_q, right_codes_rdata_s9_q[53:40], and_752_s9_q, right_codes_rdata_s9_q[39:26], and_751_s9_q, right_codes_rdata_s9_q[25:12], and_750_s9_q, right_codes_rdata_s9_q[11:0], fresh_rdata_s9_q[32:31], fresh_rdata_s9_q[25], fresh_rdata_s9_q[23:12]};
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
      patches_lower_q <= sample_pair_whole_s9_q ? select_2987 : patches_lower_q;
      patches_code_row_q <= select_3057;
      patches_column_q <= or_3026_s9_q ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3050_s9_q & (patches_column_q == 5'h1e);
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
  logic [3:0] select_508_s10_q;
  logic equal_509_s10_q;
  logic [6:0] select_511_s10_q;
  logic [8:0] select_515_s10_q;
  logic and_521_s10_q;
  logic equal_527_s10_q;
  logic [6:0] column_s10_q;
  logic and_545_s10_q;
  logic and_547_s10_q;
  logic equal_566_s10_q;
  logic equal_572_s10_q;
  logic so_s10_q;
  logic equal_576_s10_q;
  logic or_577_s10_q;
  logic less_580_s10_q;
  logic not_581_s10_q;
  logic equal_591_s10_q;
  logic and_598_s10_q;
  logic and_606_s10_q;
  logic [6:0] x_s10_2_q;
  logic select_615_s10_q;
  logic [61:0] best_left_rdata_s10_q;
  logic [6:0] select_624_s10_q;
  logic [6:0] right_s10_q;
  logic and_637_s10_q;
  logic and_642_s10_q;
  logic and_644_s10_q;
  logic equal_677_s10_q;
  logic xor_835_s10_q;
  logic parity_884_s10_q;
  logic and_885_s10_q;
  logic or_889_s10_q;
  logic or_893_s10_q;
  logic or_900_s10_q;
  logic or_904_s10_q;
  logic or_908_s10_q;
  logic or_915_s10_q;
  logic or_919_s10_q;
  logic or_923_s10_q;
  logic and_932_s10_q;
  logic and_934_s10_q;
  logic or_946_s10_q;
  logic or_950_s10_q;
  logic or_954_s10_q;
  logic xor_1084_s10_q;
  logic parity_1099_s10_q;
  logic parity_1133_s10_q;
  logic and_1134_s10_q;
  logic or_1138_s10_q;
  logic or_1142_s10_q;
  logic or_1149_s10_q;
  logic or_1153_s10_q;
  logic or_1157_s10_q;
  logic or_1164_s10_q;
  logic or_1168_s10_q;
  logic or_1172_s10_q;
  logic and_1181_s10_q;
  logic or_1182_s10_q;
  logic or_1195_s10_q;
  logic or_1199_s10_q;
  logic or_1203_s10_q;
  logic xor_1333_s10_q;
  logic parity_1348_s10_q;
  logic parity_1382_s10_q;
  logic and_1383_s10_q;
  logic or_1387_s10_q;
  logic or_1391_s10_q;
  logic or_1398_s10_q;
  logic or_1402_s10_q;
  logic or_1406_s10_q;
  logic or_1413_s10_q;
  logic or_1417_s10_q;
  logic or_1421_s10_q;
  logic and_1430_s10_q;
  logic or_1431_s10_q;
  logic or_1444_s10_q;
  logic or_1448_s10_q;
  logic or_1452_s10_q;
  logic and_1559_s10_q;
  logic equal_1560_s10_q;
  logic or_1580_s10_q;
  logic less_1646_s10_q;
  logic and_1673_s10_q;
  logic and_1686_s10_q;
  logic right_3_s10_q;
  logic less_1700_s10_q;
  logic [5:0] b_s10_q;
  logic less_1721_s10_q;
  logic not_1725_s10_q;
  logic less_1730_s10_q;
  logic less_1731_s10_q;
  logic select_1756_s10_q;
  logic [8:0] difference_1758_s10_q;
  logic [11:0] sum_1761_s10_q;
  logic select_1762_s10_q;
  logic [10:0] sum_1764_s10_q;
  logic equal_1778_s10_q;
  logic equal_1785_s10_q;
  logic not_1786_s10_q;
  logic equal_1787_s10_q;
  logic not_1788_s10_q;
  logic equal_1789_s10_q;
  logic equal_1790_s10_q;
  logic or_1791_s10_q;
  logic [4:0] select_1815_s10_q;
  logic select_1821_s10_q;
  logic and_1849_s10_q;
  logic [3:0] select_1860_s10_q;
  logic and_1870_s10_q;
  logic less_1946_s10_q;
  logic equal_1947_s10_q;
  logic not_1948_s10_q;
  logic equal_1949_s10_q;
  logic not_1950_s10_q;
  logic sum_1978_s10_q;
  logic and_1999_s10_q;
  logic and_2119_s10_q;
  logic equal_2262_s10_q;
  logic equal_2451_s10_q;
  logic and_2578_s10_q;
  logic equal_2663_s10_q;
  logic [7:0] select_2707_s10_q;
  logic rise_2_s10_q;
  logic [7:0] select_2713_s10_q;
  logic [7:0] xor_2718_s10_q;
  logic less_2744_s10_q;
  logic not_2971_s10_q;
  logic or_3026_s10_q;
  logic not_3050_s10_q;
  logic select_3527_s10_q;
  logic equal_3529_s10_q;
  logic less_3855_s10_q;
  logic equal_4074_s10_q;
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
      select_508_s10_q <= select_508_s9_q;
      equal_509_s10_q <= equal_509_s9_q;
      select_511_s10_q <= select_511_s9_q;
      select_515_s10_q <= select_515_s9_q;
      and_521_s10_q <= and_521_s9_q;
      equal_527_s10_q <= equal_527_s9_q;
      column_s10_q <= column_s9_q;
      and_545_s10_q <= and_545_s9_q;
      and_547_s10_q <= and_547_s9_q;
      equal_566_s10_q <= equal_566_s9_q;
      equal_572_s10_q <= equal_572_s9_q;
      so_s10_q <= so_s9_q;
      equal_576_s10_q <= equal_576_s9_q;
      or_577_s10_q <= or_577_s9_q;
      less_580_s10_q <= less_580_s9_q;
      not_581_s10_q <= not_581_s9_q;
      equal_591_s10_q <= equal_591_s9_q;
      and_598_s10_q <= and_598_s9_q;
      and_606_s10_q <= and_606_s9_q;
      x_s10_2_q <= x_s9_2_q;
      select_615_s10_q <= select_615_s9_q;
      best_left_rdata_s10_q <= best_left_rdata_s9_q;
      select_624_s10_q <= ({1'b0, last_s9_q} < found) ? 7'h0 : found[6:0];
      right_s10_q <= right_s9_q;
      and_637_s10_q <= and_637_s9_q;
      and_642_s10_q <= and_642_s9_q;
      and_644_s10_q <= and_644_s9_q;
      equal_677_s10_q <= equal_677_s9_q;
      xor_835_s10_q <= parity_779 ^ parity_834;
      parity_884_s10_q <= parity_884;
      and_885_s10_q <= parity_779 & parity_834;
      or_889_s10_q <= or_889;
      or_893_s10_q <= (parity_819 & parity_831) | and_892;
      or_900_s10_q <= or_900;
      or_904_s10_q <= or_904;
      or_908_s10_q <= or_908;
      or_915_s10_q <= or_915;
      or_919_s10_q <= or_919;
      or_923_s10_q <= or_923;
      and_932_s10_q <= parity_866 & parity_881;
      and_934_s10_q <= (^{or_847, or_843, or_839}) & (parity_866 | parity_881);
      or_946_s10_q <= (or_843 & or_847) | (or_839 & (or_843 | or_847));
      or_950_s10_q <= (or_859 & or_863) | (or_855 & (or_859 | or_863));
      or_954_s10_q <= (or_874 & or_878) | (or_870 & (or_874 | or_878));
      xor_1084_s10_q <= parity_1028 ^ parity_1083;
      parity_1099_s10_q <= ^{or_1096, or_1092, or_1088};
      parity_1133_s10_q <= parity_1133;
      and_1134_s10_q <= parity_1028 & parity_1083;
      or_1138_s10_q <= or_1138;
      or_1142_s10_q <= (parity_1068 & parity_1080) | and_1141;
      or_1149_s10_q <= or_1149;
      or_1153_s10_q <= or_1153;
      or_1157_s10_q <= or_1157;
      or_1164_s10_q <= or_1164;
      or_1168_s10_q <= or_1168;
      or_1172_s10_q <= or_1172;
      and_1181_s10_q <= parity_1115 & parity_1130;
      or_1182_s10_q <= parity_1115 | parity_1130;
      or_1195_s10_q <= (or_1092 & or_1096) | (or_1088 & (or_1092 | or_1096));
      or_1199_s10_q <= (or_1108 & or_1112) | (or_1104 & (or_1108 | or_1112));
      or_1203_s10_q <= (or_1123 & or_1127) | (or_1119 & (or_1123 | or_1127));
      xor_1333_s10_q <= parity_1281 ^ parity_1332;
      parity_1348_s10_q <= ^{or_1345, or_1341, or_1337};
      parity_1382_s10_q <= parity_1382;
      and_1383_s10_q <= parity_1281 & parity_1332;
      or_1387_s10_q <= or_1387;
      or_1391_s10_q <= (parity_1317 & parity_1329) | and_1390;
      or_1398_s10_q <= or_1398;
      or_1402_s10_q <= or_1402;
      or_1406_s10_q <= or_1406;
      or_1413_s10_q <= or_1413;
      or_1417_s10_q <= or_1417;
      or_1421_s10_q <= or_1421;
      and_1430_s10_q <= parity_1364 & parity_1379;
      or_1431_s10_q <= parity_1364 | parity_1379;
      or_1444_s10_q <= (or_1341 & or_1345) | (or_1337 & (or_1341 | or_1345));
      or_1448_s10_q <= (or_1357 & or_1361) | (or_1353 & (or_1357 | or_1361));
      or_1452_s10_q <= (or_1372 & or_1376) | (or_1368 & (or_1372 | or_1376));
      and_1559_s10_q <= and_1559_s9_q;
      equal_1560_s10_q <= equal_1560_s9_q;
      or_1580_s10_q <= or_1580;
      less_1646_s10_q <= {1'b0, sum_1645, last_s9_q[1]} < x_s9_q;
      and_1673_s10_q <= and_1673_s9_q;
      and_1686_s10_q <= and_1686_s9_q;
      right_3_s10_q <= right_3_s9_q;
      less_1700_s10_q <= less_1700_s9_q;
      b_s10_q <= b_s9_q;
      less_1721_s10_q <= {3'h0, last_s9_q[6:1]} < ({1'b0, x_s9_q} + 9'h1);
      not_1725_s10_q <= ~(x_s9_q < {1'b0, last_s9_q});
      less_1730_s10_q <= $signed(10'h0) < $signed(sum_1729);
      less_1731_s10_q <= $signed(sum_1729) < $signed({3'h0, last_s9_q});
      select_1756_s10_q <= select_1756[0];
      difference_1758_s10_q <= select_1756[9:1] - (b_s9_q[5] ? select_1755_s9_q[8:0] : 9'h0);
      sum_1761_s10_q <= sum_1761[12:1];
      select_1762_s10_q <= select_1762[0];
      sum_1764_s10_q <= select_1762[11:1] + (b_s9_q[3] ? select_1755_s9_q[10:0] : 11'h0);
      equal_1778_s10_q <= x_s9_q == {1'b0, last_s9_q};
      equal_1785_s10_q <= equal_1785_s9_q;
      not_1786_s10_q <= not_1786;
      equal_1787_s10_q <= equal_1787_s9_q;
      not_1788_s10_q <= not_1788;
      equal_1789_s10_q <= equal_1789_s9_q;
      equal_1790_s10_q <= equal_1790_s9_q;
      or_1791_s10_q <= or_1791_s9_q;
      select_1815_s10_q <= select_1815_s9_q;
      select_1821_s10_q <= select_1821_s9_q;
      and_1849_s10_q <= not_1786 & (not_1788 & and_1847_s9_q);
      select_1860_s10_q <= select_1860_s9_q;
      and_1870_s10_q <= and_1870;
      less_1946_s10_q <= less_1946_s9_q;
      equal_1947_s10_q <= equal_1947_s9_q;
      not_1948_s10_q <= not_1948_s9_q;
      equal_1949_s10_q <= equal_1949_s9_q;
      not_1950_s10_q <= not_1950_s9_q;
      sum_1978_s10_q <= sum_1978_s9_q;
      and_1999_s10_q <= and_1999_s9_q;
      and_2119_s10_q <= and_2116_s9_q & (~({sum_1645, last_s9_q[1:0]} < x_s9_q));
      equal_2262_s10_q <= equal_2262_s9_q;
      equal_2451_s10_q <= equal_2451_s9_q;
      and_2578_s10_q <= or_577_s9_q & and_2577_s9_q;
      equal_2663_s10_q <= shift_s9_q == 6'h0;
      select_2707_s10_q <= select_2707;
      rise_2_s10_q <= rise_2[8];
      select_2713_s10_q <= rise_2[8] ? select_2709_s9_q : select_2711_s9_q;
      xor_2718_s10_q <= rise_2[7:0] ^ {8{rise_2[8]}};
      less_2744_s10_q <= select_2709_s9_q < select_2711_s9_q;
      not_2971_s10_q <= ~(x_s9_q < {1'b0, from});
      or_3026_s10_q <= or_3026_s9_q;
      not_3050_s10_q <= not_3050_s9_q;
      select_3527_s10_q <= less_1946_s9_q ? (not_1948_s9_q & select_3525) : select_3525;
      equal_3529_s10_q <= equal_3529_s9_q;
      less_3855_s10_q <= less_3855_s9_q;
      equal_4074_s10_q <= equal_4074_s9_q;
    end
  end

  // Stage 10 ----------------------------------------------------------------------------------------------------------
  logic patches_read_searches_q;
  // hls/stages/patches.hpp:106
  logic equal_567;
  assign equal_567 = x_s10_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_566_s10_q & equal_567;
  // hls/stages/count_bits.hpp:24
  logic parity_911;
  assign parity_911 = ^{or_908_s10_q, or_904_s10_q, or_900_s10_q};
  logic parity_926;
  assign parity_926 = ^{or_923_s10_q, or_919_s10_q, or_915_s10_q};
  logic parity_929;
  assign parity_929 = ^{or_923_s10_q, or_919_s10_q, or_915_s10_q, or_908_s10_q, or_904_s10_q, or_900_s10_q, or_893_s10_q, or_889_s10_q, and_885_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_931;
  assign and_931 = parity_884_s10_q & parity_929;
  logic or_935;
  assign or_935 = and_932_s10_q | and_934_s10_q;
  logic and_938;
  assign and_938 = (^{or_893_s10_q, or_889_s10_q, and_885_s10_q}) & (parity_911 | parity_926);
  logic or_939;
  assign or_939 = (parity_911 & parity_926) | and_938;
  // hls/stages/count_bits.hpp:24
  logic parity_957;
  assign parity_957 = ^{or_954_s10_q, or_950_s10_q, or_946_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_961;
  assign or_961 = (or_889_s10_q & or_893_s10_q) | (and_885_s10_q & (or_889_s10_q | or_893_s10_q));
  logic or_965;
  assign or_965 = (or_904_s10_q & or_908_s10_q) | (or_900_s10_q & (or_904_s10_q | or_908_s10_q));
  logic or_969;
  assign or_969 = (or_919_s10_q & or_923_s10_q) | (or_915_s10_q & (or_919_s10_q | or_923_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_972;
  assign parity_972 = ^{or_969, or_965, or_961};
  logic parity_975;
  assign parity_975 = ^{or_969, or_965, or_961, or_954_s10_q, or_950_s10_q, or_946_s10_q, or_939, or_935, and_931};
  // hls/stages/count_bits.hpp:25
  logic or_987;
  assign or_987 = (or_950_s10_q & or_954_s10_q) | (or_946_s10_q & (or_950_s10_q | or_954_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1160;
  assign parity_1160 = ^{or_1157_s10_q, or_1153_s10_q, or_1149_s10_q};
  logic parity_1175;
  assign parity_1175 = ^{or_1172_s10_q, or_1168_s10_q, or_1164_s10_q};
  logic parity_1178;
  assign parity_1178 = ^{or_1172_s10_q, or_1168_s10_q, or_1164_s10_q, or_1157_s10_q, or_1153_s10_q, or_1149_s10_q, or_1142_s10_q, or_1138_s10_q, and_1134_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1180;
  assign and_1180 = parity_1133_s10_q & parity_1178;
  logic or_1184;
  assign or_1184 = and_1181_s10_q | (parity_1099_s10_q & or_1182_s10_q);
  logic and_1187;
  assign and_1187 = (^{or_1142_s10_q, or_1138_s10_q, and_1134_s10_q}) & (parity_1160 | parity_1175);
  logic or_1188;
  assign or_1188 = (parity_1160 & parity_1175) | and_1187;
  // hls/stages/count_bits.hpp:24
  logic parity_1206;
  assign parity_1206 = ^{or_1203_s10_q, or_1199_s10_q, or_1195_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1210;
  assign or_1210 = (or_1138_s10_q & or_1142_s10_q) | (and_1134_s10_q & (or_1138_s10_q | or_1142_s10_q));
  logic or_1214;
  assign or_1214 = (or_1153_s10_q & or_1157_s10_q) | (or_1149_s10_q & (or_1153_s10_q | or_1157_s10_q));
  logic or_1218;
  assign or_1218 = (or_1168_s10_q & or_1172_s10_q) | (or_1164_s10_q & (or_1168_s10_q | or_1172_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1221;
  assign parity_1221 = ^{or_1218, or_1214, or_1210};
  logic parity_1224;
  assign parity_1224 = ^{or_1218, or_1214, or_1210, or_1203_s10_q, or_1199_s10_q, or_1195_s10_q, or_1188, or_1184, and_1180};
  // hls/stages/count_bits.hpp:25
  logic or_1236;
  assign or_1236 = (or_1199_s10_q & or_1203_s10_q) | (or_1195_s10_q & (or_1199_s10_q | or_1203_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1409;
  assign parity_1409 = ^{or_1406_s10_q, or_1402_s10_q, or_1398_s10_q};
  logic parity_1424;
  assign parity_1424 = ^{or_1421_s10_q, or_1417_s10_q, or_1413_s10_q};
  logic parity_1427;
  assign parity_1427 = ^{or_1421_s10_q, or_1417_s10_q, or_1413_s10_q, or_1406_s10_q, or_1402_s10_q, or_1398_s10_q, or_1391_s10_q, or_1387_s10_q, and_1383_s10_q};
  // hls/stages/count_bits.hpp:25
  logic and_1429;
  assign and_1429 = parity_1382_s10_q & parity_1427;
  logic or_1433;
  assign or_1433 = and_1430_s10_q | (parity_1348_s10_q & or_1431_s10_q);
  logic and_1436;
  assign and_1436 = (^{or_1391_s10_q, or_1387_s10_q, and_1383_s10_q}) & (parity_1409 | parity_1424);
  logic or_1437;
  assign or_1437 = (parity_1409 & parity_1424) | and_1436;
  // hls/stages/count_bits.hpp:24
  logic parity_1455;
  assign parity_1455 = ^{or_1452_s10_q, or_1448_s10_q, or_1444_s10_q};
  // hls/stages/count_bits.hpp:25
  logic or_1459;
  assign or_1459 = (or_1387_s10_q & or_1391_s10_q) | (and_1383_s10_q & (or_1387_s10_q | or_1391_s10_q));
  logic or_1463;
  assign or_1463 = (or_1402_s10_q & or_1406_s10_q) | (or_1398_s10_q & (or_1402_s10_q | or_1406_s10_q));
  logic or_1467;
  assign or_1467 = (or_1417_s10_q & or_1421_s10_q) | (or_1413_s10_q & (or_1417_s10_q | or_1421_s10_q));
  // hls/stages/count_bits.hpp:24
  logic parity_1470;
  assign parity_1470 = ^{or_1467, or_1463, or_1459};
  logic parity_1473;
  assign parity_1473 = ^{or_1467, or_1463, or_1459, or_1452_s10_q, or_1448_s10_q, or_1444_s10_q, or_1437, or_1433, and_1429};
  // hls/stages/count_bits.hpp:25
  logic or_1485;
  assign or_1485 = (or_1448_s10_q & or_1452_s10_q) | (or_1444_s10_q & (or_1448_s10_q | or_1452_s10_q));
  // hls/stages/patches.hpp:104
  logic and_1723;
  assign and_1723 = less_1721_s10_q & (~right_3_s10_q);
  // hls/stages/agreement.hpp:1019
  logic and_1733;
  assign and_1733 = (~(and_1723 | (equal_567 | not_1725_s10_q))) & (less_1730_s10_q & less_1731_s10_q);
  // hls/stages/registration.hpp:214
  logic [11:0] sum_1765;
  assign sum_1765 = sum_1761_s10_q + {sum_1764_s10_q, select_1762_s10_q};
  logic [9:0] sum_1766;
  assign sum_1766 = {difference_1758_s10_q, select_1756_s10_q} + sum_1765[11:2];
  // hls/stages/registration.hpp:35
  logic [8:0] fall;
  assign fall = {1'b0, select_2707_s10_q} - {1'b0, select_2713_s10_q};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:34
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2_s10_q} + {1'b0, xor_2718_s10_q};

  // Memory best_right, 120 x 29, DISTANCE 24, hls/stages/agreement.hpp:1377; read in stage 10, written in stage 17: 10 < 17 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) best_right_mem[i] = 29'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_577_s10_q ? select_624_s10_q : right_s10_q;
  logic best_right_re;
  assign best_right_re = s10_en & select_615_s10_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 24, hls/stages/patches.hpp:776; read in stage 10, written in stage 21: 10 < 21 < 10 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_s10_q, patches_code_row_s10_q[3:0], patches_column_s10_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s10_en & and_1849_s10_q;
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_read_searches_q <= 1'b0;
    end else if (s10_en) begin
      patches_read_searches_q <= equal_1785_s10_q ? select_3527_s10_q : patches_read_searches_q;
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
  logic and_521_s11_q;
  logic equal_527_s11_q;
  logic [6:0] column_s11_q;
  logic and_545_s11_q;
  logic and_547_s11_q;
  logic equal_567_s11_q;
  logic first_s11_q;
  logic equal_572_s11_q;
  logic so_s11_q;
  logic equal_576_s11_q;
  logic or_577_s11_q;
  logic less_580_s11_q;
  logic not_581_s11_q;
  logic equal_591_s11_q;
  logic and_598_s11_q;
  logic and_606_s11_q;
  logic [6:0] x_s11_2_q;
  logic [61:0] best_left_rdata_s11_q;
  logic [6:0] select_624_s11_q;
  logic [6:0] right_s11_q;
  logic and_637_s11_q;
  logic and_642_s11_q;
  logic and_644_s11_q;
  logic equal_677_s11_q;
  logic xor_835_s11_q;
  logic xor_930_s11_q;
  logic parity_975_s11_q;
  logic and_976_s11_q;
  logic and_978_s11_q;
  logic and_980_s11_q;
  logic and_982_s11_q;
  logic or_987_s11_q;
  logic or_991_s11_q;
  logic xor_1084_s11_q;
  logic xor_1179_s11_q;
  logic parity_1224_s11_q;
  logic and_1225_s11_q;
  logic and_1227_s11_q;
  logic and_1229_s11_q;
  logic and_1231_s11_q;
  logic or_1236_s11_q;
  logic or_1240_s11_q;
  logic xor_1333_s11_q;
  logic xor_1428_s11_q;
  logic parity_1473_s11_q;
  logic and_1474_s11_q;
  logic and_1476_s11_q;
  logic and_1478_s11_q;
  logic and_1480_s11_q;
  logic or_1485_s11_q;
  logic or_1489_s11_q;
  logic and_1559_s11_q;
  logic equal_1560_s11_q;
  logic or_1580_s11_q;
  logic less_1646_s11_q;
  logic and_1673_s11_q;
  logic and_1686_s11_q;
  logic right_3_s11_q;
  logic less_1700_s11_q;
  logic [5:0] b_s11_q;
  logic and_1733_s11_q;
  logic [7:0] sum_1766_s11_q;
  logic equal_1778_s11_q;
  logic or_1779_s11_q;
  logic equal_1785_s11_q;
  logic not_1786_s11_q;
  logic equal_1787_s11_q;
  logic not_1788_s11_q;
  logic equal_1789_s11_q;
  logic equal_1790_s11_q;
  logic or_1791_s11_q;
  logic [7:0] patches_right_0_rdata_s11_q;
  logic [4:0] select_1815_s11_q;
  logic select_1821_s11_q;
  logic [7:0] patches_right_1_rdata_s11_q;
  logic [3:0] select_1860_s11_q;
  logic and_1870_s11_q;
  logic [31:0] patches_columns_above_rdata_s11_q;
  logic less_1946_s11_q;
  logic equal_1947_s11_q;
  logic not_1948_s11_q;
  logic equal_1949_s11_q;
  logic not_1950_s11_q;
  logic [14:0] patches_rows_rdata_s11_q;
  logic sum_1978_s11_q;
  logic and_1999_s11_q;
  logic and_2121_s11_q;
  logic equal_2262_s11_q;
  logic equal_2451_s11_q;
  logic and_2578_s11_q;
  logic equal_2663_s11_q;
  logic [7:0] wide_s11_q;
  logic [8:0] size_3_s11_q;
  logic less_2744_s11_q;
  logic not_2971_s11_q;
  logic or_3026_s11_q;
  logic not_3050_s11_q;
  logic equal_3529_s11_q;
  logic less_3855_s11_q;
  logic equal_4074_s11_q;
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
      and_521_s11_q <= and_521_s10_q;
      equal_527_s11_q <= equal_527_s10_q;
      column_s11_q <= column_s10_q;
      and_545_s11_q <= and_545_s10_q;
      and_547_s11_q <= and_547_s10_q;
      equal_567_s11_q <= equal_567;
      first_s11_q <= first;
      equal_572_s11_q <= equal_572_s10_q;
      so_s11_q <= so_s10_q;
      equal_576_s11_q <= equal_576_s10_q;
      or_577_s11_q <= or_577_s10_q;
      less_580_s11_q <= less_580_s10_q;
      not_581_s11_q <= not_581_s10_q;
      equal_591_s11_q <= equal_591_s10_q;
      and_598_s11_q <= and_598_s10_q;
      and_606_s11_q <= and_606_s10_q;
      x_s11_2_q <= x_s10_2_q;
      best_left_rdata_s11_q <= best_left_rdata_s10_q;
      select_624_s11_q <= select_624_s10_q;
      right_s11_q <= right_s10_q;
      and_637_s11_q <= and_637_s10_q;
      and_642_s11_q <= and_642_s10_q;
      and_644_s11_q <= and_644_s10_q;
      equal_677_s11_q <= equal_677_s10_q;
      xor_835_s11_q <= xor_835_s10_q;
      xor_930_s11_q <= parity_884_s10_q ^ parity_929;
      parity_975_s11_q <= parity_975;
      and_976_s11_q <= parity_957 & parity_972;
      and_978_s11_q <= (^{or_939, or_935, and_931}) & (parity_957 | parity_972);
      and_980_s11_q <= or_935 & or_939;
      and_982_s11_q <= and_931 & (or_935 | or_939);
      or_987_s11_q <= or_987;
      or_991_s11_q <= (or_965 & or_969) | (or_961 & (or_965 | or_969));
      xor_1084_s11_q <= xor_1084_s10_q;
      xor_1179_s11_q <= parity_1133_s10_q ^ parity_1178;
      parity_1224_s11_q <= parity_1224;
      and_1225_s11_q <= parity_1206 & parity_1221;
      and_1227_s11_q <= (^{or_1188, or_1184, and_1180}) & (parity_1206 | parity_1221);
      and_1229_s11_q <= or_1184 & or_1188;
      and_1231_s11_q <= and_1180 & (or_1184 | or_1188);
      or_1236_s11_q <= or_1236;
      or_1240_s11_q <= (or_1214 & or_1218) | (or_1210 & (or_1214 | or_1218));
      xor_1333_s11_q <= xor_1333_s10_q;
      xor_1428_s11_q <= parity_1382_s10_q ^ parity_1427;
      parity_1473_s11_q <= parity_1473;
      and_1474_s11_q <= parity_1455 & parity_1470;
      and_1476_s11_q <= (^{or_1437, or_1433, and_1429}) & (parity_1455 | parity_1470);
      and_1478_s11_q <= or_1433 & or_1437;
      and_1480_s11_q <= and_1429 & (or_1433 | or_1437);
      or_1485_s11_q <= or_1485;
      or_1489_s11_q <= (or_1463 & or_1467) | (or_1459 & (or_1463 | or_1467));
      and_1559_s11_q <= and_1559_s10_q;
      equal_1560_s11_q <= equal_1560_s10_q;
      or_1580_s11_q <= or_1580_s10_q;
      less_1646_s11_q <= less_1646_s10_q;
      and_1673_s11_q <= and_1673_s10_q;
      and_1686_s11_q <= and_1686_s10_q;
      right_3_s11_q <= right_3_s10_q;
      less_1700_s11_q <= less_1700_s10_q;
      b_s11_q <= b_s10_q;
      and_1733_s11_q <= and_1733;
      sum_1766_s11_q <= sum_1766[9:2];
      equal_1778_s11_q <= equal_1778_s10_q;
      or_1779_s11_q <= and_1723 | equal_1778_s10_q;
      equal_1785_s11_q <= equal_1785_s10_q;
      not_1786_s11_q <= not_1786_s10_q;
      equal_1787_s11_q <= equal_1787_s10_q;
      not_1788_s11_q <= not_1788_s10_q;
      equal_1789_s11_q <= equal_1789_s10_q;
      equal_1790_s11_q <= equal_1790_s10_q;
      or_1791_s11_q <= or_1791_s10_q;
      patches_right_0_rdata_s11_q <= patches_right_0_rdata_q;
      select_1815_s11_q <= select_1815_s10_q;
      select_1821_s11_q <= select_1821_s10_q;
      patches_right_1_rdata_s11_q <= patches_right_1_rdata_q;
      select_1860_s11_q <= select_1860_s10_q;
      and_1870_s11_q <= and_1870_s10_q;
      patches_columns_above_rdata_s11_q <= patches_columns_above_rdata_q;
      less_1946_s11_q <= less_1946_s10_q;
      equal_1947_s11_q <= equal_1947_s10_q;
      not_1948_s11_q <= not_1948_s10_q;
      equal_1949_s11_q <= equal_1949_s10_q;
      not_1950_s11_q <= not_1950_s10_q;
      patches_rows_rdata_s11_q <= patches_rows_rdata_q;
      sum_1978_s11_q <= sum_1978_s10_q;
      and_1999_s11_q <= and_1999_s10_q;
      and_2121_s11_q <= so_s10_q & (ends_cell_s10_q & and_2119_s10_q);
      equal_2262_s11_q <= equal_2262_s10_q;
      equal_2451_s11_q <= equal_2451_s10_q;
      and_2578_s11_q <= and_2578_s10_q;
      equal_2663_s11_q <= equal_2663_s10_q;
      wide_s11_q <= wide;
      size_3_s11_q <= size_3;
      less_2744_s11_q <= less_2744_s10_q;
      not_2971_s11_q <= not_2971_s10_q;
      or_3026_s11_q <= or_3026_s10_q;
      not_3050_s11_q <= not_3050_s10_q;
      equal_3529_s11_q <= equal_3529_s10_q;
      less_3855_s11_q <= less_3855_s10_q;
      equal_4074_s11_q <= equal_4074_s10_q;
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
  assign inside_v = or_577_s11_q & not_581_s11_q;
  // hls/stages/count_bits.hpp:25
  logic or_979;
  assign or_979 = and_976_s11_q | and_978_s11_q;
  logic or_983;
  assign or_983 = and_980_s11_q | and_982_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_996;
  assign parity_996 = ^{or_991_s11_q, or_987_s11_q, or_983, or_979};
  // hls/stages/count_bits.hpp:25
  logic or_1000;
  assign or_1000 = (or_987_s11_q & or_991_s11_q) | (or_983 & (or_987_s11_q | or_991_s11_q));
  logic and_1001;
  assign and_1001 = or_979 & (^{or_991_s11_q, or_987_s11_q, or_983});
  // hls/stages/count_bits.hpp:24
  logic xor_1002;
  assign xor_1002 = or_1000 ^ and_1001;
  // hls/stages/count_bits.hpp:27
  logic and_1003;
  assign and_1003 = or_1000 & and_1001;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1004;
  assign select_1004 = equal_591_s11_q ? {and_1003, xor_1002, parity_996, parity_975_s11_q, xor_930_s11_q, xor_835_s11_q} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_577_s11_q ? 6'h0 : select_1004;
  // hls/stages/count_bits.hpp:25
  logic or_1228;
  assign or_1228 = and_1225_s11_q | and_1227_s11_q;
  logic or_1232;
  assign or_1232 = and_1229_s11_q | and_1231_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1245;
  assign parity_1245 = ^{or_1240_s11_q, or_1236_s11_q, or_1232, or_1228};
  // hls/stages/count_bits.hpp:25
  logic or_1249;
  assign or_1249 = (or_1236_s11_q & or_1240_s11_q) | (or_1232 & (or_1236_s11_q | or_1240_s11_q));
  logic and_1250;
  assign and_1250 = or_1228 & (^{or_1240_s11_q, or_1236_s11_q, or_1232});
  // hls/stages/count_bits.hpp:24
  logic xor_1251;
  assign xor_1251 = or_1249 ^ and_1250;
  // hls/stages/count_bits.hpp:27
  logic and_1252;
  assign and_1252 = or_1249 & and_1250;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1253;
  assign select_1253 = equal_591_s11_q ? {and_1252, xor_1251, parity_1245, parity_1224_s11_q, xor_1179_s11_q, xor_1084_s11_q} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_577_s11_q ? 6'h0 : select_1253;
  // hls/stages/count_bits.hpp:25
  logic or_1477;
  assign or_1477 = and_1474_s11_q | and_1476_s11_q;
  logic or_1481;
  assign or_1481 = and_1478_s11_q | and_1480_s11_q;
  // hls/stages/count_bits.hpp:24
  logic parity_1494;
  assign parity_1494 = ^{or_1489_s11_q, or_1485_s11_q, or_1481, or_1477};
  // hls/stages/count_bits.hpp:25
  logic or_1498;
  assign or_1498 = (or_1485_s11_q & or_1489_s11_q) | (or_1481 & (or_1485_s11_q | or_1489_s11_q));
  logic and_1499;
  assign and_1499 = or_1477 & (^{or_1489_s11_q, or_1485_s11_q, or_1481});
  // hls/stages/count_bits.hpp:24
  logic xor_1500;
  assign xor_1500 = or_1498 ^ and_1499;
  // hls/stages/count_bits.hpp:27
  logic and_1501;
  assign and_1501 = or_1498 & and_1499;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1502;
  assign select_1502 = equal_591_s11_q ? {and_1501, xor_1500, parity_1494, parity_1473_s11_q, xor_1428_s11_q, xor_1333_s11_q} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_577_s11_q ? 6'h0 : select_1502;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_2;
  assign before_v_2 = age_s11_q[1] ? sums_0_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1538;
  assign sum_1538 = {1'b0, sums_0_columns_values_3_q} + {1'b0, sums_0_columns_values_5_q};
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_3;
  assign before_v_3 = age_s11_q[1] ? sums_1_columns_values_7_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1541;
  assign sum_1541 = {1'b0, sums_1_columns_values_3_q} + {1'b0, sums_1_columns_values_5_q};
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v & less_1646_s11_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1767;
  assign sum_1767 = {registration_slope_s11_q[11], registration_slope_s11_q} + {{5{sum_1766_s11_q[7]}}, sum_1766_s11_q};
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1790_s11_q ? (patches_second_s11_q ? 8'h0 : patches_right_0_rdata_s11_q) : 8'h0;
  // hls/stages/patches.hpp:463
  logic [8:0] sum_1908;
  assign sum_1908 = {1'b0, patches_columns_above_rdata_s11_q[23:16]} + {3'h0, patches_columns_above_rdata_s11_q[31:26]};
  // hls/stages/registration.hpp:40
  logic [8:0] select_2721;
  assign select_2721 = ({wide_s11_q, 1'b0} < size_3_s11_q) ? {wide_s11_q, 1'b0} : size_3_s11_q;
  logic [8:0] taken;
  assign taken = ~select_2721;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3492;
  assign select_3492 = less_1946_s11_q ? patches_rows_rdata_s11_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:553
  logic [9:0] select_3494;
  assign select_3494 = less_1946_s11_q ? (equal_1949_s11_q ? 10'h0 : select_3492) : 10'h0;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3499;
  assign select_3499 = less_1946_s11_q ? patches_rows_rdata_s11_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3502;
  assign select_3502 = equal_1949_s11_q ? (less_1946_s11_q ? (equal_1949_s11_q ? 5'h0 : select_3499) : 5'h0) : select_3499;

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
  logic [3:0] select_508_s12_q;
  logic equal_509_s12_q;
  logic [6:0] select_511_s12_q;
  logic [8:0] select_515_s12_q;
  logic and_521_s12_q;
  logic equal_527_s12_q;
  logic [6:0] column_s12_q;
  logic and_545_s12_q;
  logic and_547_s12_q;
  logic equal_567_s12_q;
  logic first_s12_q;
  logic equal_572_s12_q;
  logic so_s12_q;
  logic equal_576_s12_q;
  logic or_577_s12_q;
  logic less_580_s12_q;
  logic not_581_s12_q;
  logic inside_v_s12_q;
  logic and_598_s12_q;
  logic and_606_s12_q;
  logic [6:0] x_s12_2_q;
  logic [61:0] best_left_rdata_s12_q;
  logic [6:0] select_624_s12_q;
  logic [6:0] right_s12_q;
  logic [28:0] best_right_rdata_s12_q;
  logic and_637_s12_q;
  logic and_642_s12_q;
  logic and_644_s12_q;
  logic equal_677_s12_q;
  logic [5:0] column_2_s12_q;
  logic [5:0] select_1255_s12_q;
  logic [5:0] select_1504_s12_q;
  logic [6:0] sum_1539_s12_q;
  logic [6:0] sum_1542_s12_q;
  logic and_1559_s12_q;
  logic equal_1560_s12_q;
  logic or_1580_s12_q;
  logic right_2_s12_q;
  logic and_1673_s12_q;
  logic and_1686_s12_q;
  logic and_1698_s12_q;
  logic less_1700_s12_q;
  logic [5:0] b_s12_q;
  logic and_1733_s12_q;
  logic [7:0] sum_1767_s12_q;
  logic less_1768_s12_q;
  logic less_1769_s12_q;
  logic equal_1778_s12_q;
  logic and_1782_s12_q;
  logic equal_1785_s12_q;
  logic not_1786_s12_q;
  logic equal_1787_s12_q;
  logic not_1788_s12_q;
  logic equal_1789_s12_q;
  logic equal_1790_s12_q;
  logic or_1791_s12_q;
  logic [4:0] select_1815_s12_q;
  logic select_1821_s12_q;
  logic [7:0] patches_left_rdata_s12_q;
  logic [3:0] select_1860_s12_q;
  logic and_1870_s12_q;
  logic [31:0] patches_columns_above_rdata_s12_q;
  logic [7:0] select_1874_s12_q;
  logic [8:0] sum_1908_s12_q;
  logic less_1946_s12_q;
  logic equal_1947_s12_q;
  logic not_1948_s12_q;
  logic equal_1949_s12_q;
  logic not_1950_s12_q;
  logic [9:0] patches_rows_rdata_s12_q;
  logic sum_1978_s12_q;
  logic and_1999_s12_q;
  logic and_2121_s12_q;
  logic equal_2262_s12_q;
  logic equal_2451_s12_q;
  logic and_2578_s12_q;
  logic equal_2663_s12_q;
  logic less_2705_s12_q;
  logic [7:0] wide_s12_q;
  logic [8:0] taken_s12_q;
  logic [7:0] not_2723_s12_q;
  logic less_2744_s12_q;
  logic and_2974_s12_q;
  logic or_3026_s12_q;
  logic not_3050_s12_q;
  logic [9:0] select_3495_s12_q;
  logic [4:0] select_3502_s12_q;
  logic equal_3529_s12_q;
  logic less_3855_s12_q;
  logic equal_4074_s12_q;
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
      select_508_s12_q <= select_508_s11_q;
      equal_509_s12_q <= equal_509_s11_q;
      select_511_s12_q <= select_511_s11_q;
      select_515_s12_q <= select_515_s11_q;
      and_521_s12_q <= and_521_s11_q;
      equal_527_s12_q <= equal_527_s11_q;
      column_s12_q <= column_s11_q;
      and_545_s12_q <= and_545_s11_q;
      and_547_s12_q <= and_547_s11_q;
      equal_567_s12_q <= equal_567_s11_q;
      first_s12_q <= first_s11_q;
      equal_572_s12_q <= equal_572_s11_q;
      so_s12_q <= so_s11_q;
      equal_576_s12_q <= equal_576_s11_q;
      or_577_s12_q <= or_577_s11_q;
      less_580_s12_q <= less_580_s11_q;
      not_581_s12_q <= not_581_s11_q;
      inside_v_s12_q <= inside_v;
      and_598_s12_q <= and_598_s11_q;
      and_606_s12_q <= and_606_s11_q;
      x_s12_2_q <= x_s11_2_q;
      best_left_rdata_s12_q <= best_left_rdata_s11_q;
      select_624_s12_q <= select_624_s11_q;
      right_s12_q <= right_s11_q;
      best_right_rdata_s12_q <= best_right_rdata_q;
      and_637_s12_q <= and_637_s11_q;
      and_642_s12_q <= and_642_s11_q;
      and_644_s12_q <= and_644_s11_q;
      equal_677_s12_q <= equal_677_s11_q;
      column_2_s12_q <= column_2;
      select_1255_s12_q <= age_s11_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1504_s12_q <= age_s11_q[3] ? sums_1_columns_values_13_q : 6'h0;
      sum_1539_s12_q <= {1'b0, before_v_2} + sum_1538;
      sum_1542_s12_q <= {1'b0, before_v_3} + sum_1541;
      and_1559_s12_q <= and_1559_s11_q;
      equal_1560_s12_q <= equal_1560_s11_q;
      or_1580_s12_q <= or_1580_s11_q;
      right_2_s12_q <= right_2;
      and_1673_s12_q <= and_1673_s11_q;
      and_1686_s12_q <= and_1686_s11_q;
      and_1698_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & right_3_s11_q));
      less_1700_s12_q <= less_1700_s11_q;
      b_s12_q <= b_s11_q;
      and_1733_s12_q <= and_1733_s11_q;
      sum_1767_s12_q <= sum_1767[7:0];
      less_1768_s12_q <= $signed(6'h0) < $signed(sum_1767[12:7]);
      less_1769_s12_q <= $signed(sum_1767[12:7]) < $signed(6'h3f);
      equal_1778_s12_q <= equal_1778_s11_q;
      and_1782_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & or_1779_s11_q));
      equal_1785_s12_q <= equal_1785_s11_q;
      not_1786_s12_q <= not_1786_s11_q;
      equal_1787_s12_q <= equal_1787_s11_q;
      not_1788_s12_q <= not_1788_s11_q;
      equal_1789_s12_q <= equal_1789_s11_q;
      equal_1790_s12_q <= equal_1790_s11_q;
      or_1791_s12_q <= or_1791_s11_q;
      select_1815_s12_q <= select_1815_s11_q;
      select_1821_s12_q <= select_1821_s11_q;
      patches_left_rdata_s12_q <= patches_left_rdata_q;
      select_1860_s12_q <= select_1860_s11_q;
      and_1870_s12_q <= and_1870_s11_q;
      patches_columns_above_rdata_s12_q <= patches_columns_above_rdata_s11_q;
      select_1874_s12_q <= patches_second_s11_q ? patches_right_1_rdata_s11_q : pixel;
      sum_1908_s12_q <= sum_1908;
      less_1946_s12_q <= less_1946_s11_q;
      equal_1947_s12_q <= equal_1947_s11_q;
      not_1948_s12_q <= not_1948_s11_q;
      equal_1949_s12_q <= equal_1949_s11_q;
      not_1950_s12_q <= not_1950_s11_q;
      patches_rows_rdata_s12_q <= patches_rows_rdata_s11_q[9:0];
      sum_1978_s12_q <= sum_1978_s11_q;
      and_1999_s12_q <= and_1999_s11_q;
      and_2121_s12_q <= and_2121_s11_q;
      equal_2262_s12_q <= equal_2262_s11_q;
      equal_2451_s12_q <= equal_2451_s11_q;
      and_2578_s12_q <= and_2578_s11_q;
      equal_2663_s12_q <= equal_2663_s11_q;
      less_2705_s12_q <= slot_s11_q < 3'h3;
      wide_s12_q <= wide_s11_q;
      taken_s12_q <= taken;
      not_2723_s12_q <= ~wide_s11_q;
      less_2744_s12_q <= less_2744_s11_q;
      and_2974_s12_q <= so_s11_q & (ends_cell_s11_q & (inside_v & not_2971_s11_q));
      or_3026_s12_q <= or_3026_s11_q;
      not_3050_s12_q <= not_3050_s11_q;
      select_3495_s12_q <= equal_1949_s11_q ? select_3494 : select_3492;
      select_3502_s12_q <= select_3502;
      equal_3529_s12_q <= equal_3529_s11_q;
      less_3855_s12_q <= less_3855_s11_q;
      equal_4074_s12_q <= equal_4074_s11_q;
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
  // hls/stages/census.hpp:120
  logic and_522;
  assign and_522 = sample_pair_whole_s12_q & and_521_s12_q;
  // hls/stages/moments.hpp:57
  logic [13:0] select_570;
  assign select_570 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:1010
  logic not_573;
  assign not_573 = ~equal_572_s12_q;
  // hls/stages/agreement.hpp:201
  logic not_575;
  assign not_575 = ~so_s12_q;
  // hls/stages/agreement.hpp:980
  logic [6:0] chosen;
  assign chosen = slot_s12_q[2] ? best_right_rdata_s12_q[14:8] : best_right_rdata_s12_q[28:22];
  // hls/stages/agreement.hpp:808
  logic or_757;
  assign or_757 = shift_first_s12_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1006;
  assign select_1006 = age_s12_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v;
  assign before_v = age_s12_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1534;
  assign sum_1534 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  // hls/stages/agreement.hpp:752
  logic [6:0] select_1544;
  assign select_1544 = (sum_1539_s12_q < sum_1542_s12_q) ? sum_1542_s12_q : sum_1539_s12_q;
  // hls/stages/agreement.hpp:789
  logic and_1570;
  assign and_1570 = ends_cell_s12_q & inside_v_s12_q;
  logic and_1572;
  assign and_1572 = not_573 & (so_s12_q & and_1570);
  // hls/stages/registration.hpp:83
  logic equal_1701;
  assign equal_1701 = slot_s12_q == 3'h7;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1704;
  assign select_1704 = b_s12_q[0] ? registration_slope_here_q[7:1] : 7'h0;
  logic [7:0] select_1705;
  assign select_1705 = b_s12_q[1] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1706;
  assign sum_1706 = {{2{select_1704[6]}}, select_1704} + {select_1705[7], select_1705};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1707;
  assign select_1707 = b_s12_q[2] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1708;
  assign select_1708 = b_s12_q[3] ? registration_slope_here_q : 8'h0;
  logic [8:0] sum_1709;
  assign sum_1709 = {{2{select_1707[7]}}, select_1707[7:1]} + {select_1708[7], select_1708};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1711;
  assign select_1711 = b_s12_q[4] ? registration_slope_here_q : 8'h0;
  logic [7:0] select_1712;
  assign select_1712 = b_s12_q[5] ? registration_slope_here_q : 8'h0;
  logic [8:0] difference_1713;
  assign difference_1713 = {{2{select_1711[7]}}, select_1711[7:1]} - {select_1712[7], select_1712};
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1749;
  assign select_1749 = so_s12_q ? (ends_cell_s12_q ? (inside_v_s12_q ? b_s12_q : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/registration.hpp:218
  logic [7:0] select_1771;
  assign select_1771 = less_1768_s12_q ? 8'h7f : (less_1769_s12_q ? 8'h80 : sum_1767_s12_q);
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1701 ? registration_slope_here_q : select_1771;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_1775;
  assign select_1775 = so_s12_q ? (ends_cell_s12_q ? (inside_v_s12_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic and_1783;
  assign and_1783 = not_573 & and_1782_s12_q;
  // hls/stages/patches.hpp:172
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1790_s12_q ? select_1874_s12_q : patches_left_rdata_s12_q;
  // hls/stages/patches.hpp:463
  logic [9:0] sum_1909;
  assign sum_1909 = {2'h0, patches_columns_above_rdata_s12_q[15:8]} + {1'b0, sum_1908_s12_q};
  // hls/stages/agreement.hpp:789
  logic and_2314;
  assign and_2314 = not_573 & (not_575 & (equal_576_s12_q & (inside_v_s12_q & first_s12_q)));
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2551;
  assign select_2551 = slot_s12_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2552;
  assign select_2552 = slot_s12_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2553;
  assign select_2553 = slot_s12_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2554;
  assign select_2554 = slot_s12_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2555;
  assign select_2555 = slot_s12_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2556;
  assign select_2556 = slot_s12_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:987
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s12_q[61:54]} - {1'b0, best_left_rdata_s12_q[53:46]};
  // hls/stages/registration.hpp:37
  logic not_2716;
  assign not_2716 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2705_s12_q ? {1'b0, wide_s12_q, 1'b0} : {registration_displacement_over_q[8:0], not_2716};
  // hls/stages/registration.hpp:40
  logic [7:0] select_2724;
  assign select_2724 = registration_displacement_over_q[9] ? wide_s12_q : not_2723_s12_q;
  logic [9:0] taken_2;
  assign taken_2 = less_2705_s12_q ? {taken_s12_q, 1'b1} : {not_2716, select_2724, not_2716};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2726;
  assign sum_2726 = {left, 1'b1} + {taken_2, less_2705_s12_q};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2728;
  assign select_2728 = so_s12_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2730;
  assign select_2730 = equal_572_s12_q ? registration_slope_here_q : (so_s12_q ? slope : registration_slope_here_q);
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2739;
  assign select_2739 = or_577_s12_q ? (less_580_s12_q ? 3'h0 : best_left_rdata_s12_q[8:6]) : 3'h0;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3497;
  assign select_3497 = less_1946_s12_q ? (equal_1947_s12_q ? 10'h0 : select_3495_s12_q) : select_3495_s12_q;
  logic [4:0] select_3504;
  assign select_3504 = less_1946_s12_q ? (equal_1947_s12_q ? 5'h0 : select_3502_s12_q) : select_3502_s12_q;
  // hls/stages/patches.hpp:552
  logic and_3514;
  assign and_3514 = less_1946_s12_q & (patches_step_s12_q == 5'h0);
  // hls/stages/patches.hpp:556
  logic select_3517;
  assign select_3517 = equal_1949_s12_q ? (less_1946_s12_q ? (not_1950_s12_q & and_3514) : and_3514) : and_3514;

  // Memory averager_memory, 480 x 30, DISTANCE 16, hls/stages/census.hpp:227; read in stage 12, written in stage 15: 12 < 15 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] averager_memory_mem [0:479];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 480; i++) averager_memory_mem[i] = 30'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_515_s12_q;
  logic averager_memory_re;
  assign averager_memory_re = s12_en & and_522;
  logic [29:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory seen_columns, 120 x 18, DISTANCE 24, hls/stages/agreement.hpp:1406; read in stage 12, written in stage 16: 12 < 16 < 12 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s12_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s12_en & and_1572;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
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
      moments_place_q <= select_570;
      moments_taken_q <= not_573 & (not_575 & (equal_576_s12_q & inside_v_s12_q));
      moments_starts_q <= and_2314;
      shift_not_right_q <= $signed(run_shift_s12_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s12_q ? sum_2726[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2728;
      registration_slope_here_q <= select_2730;
      patches_read_row_differing_q <= equal_1785_s12_q ? select_3497 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1785_s12_q ? select_3504 : patches_read_row_column_q;
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
      middle_sum_columns_values_1_q <= select_2551;
      middle_sum_columns_values_2_q <= select_2552;
      middle_sum_columns_values_3_q <= select_2553;
      middle_sum_columns_values_4_q <= select_2554;
      middle_sum_columns_values_5_q <= select_2555;
      middle_sum_columns_values_6_q <= select_2556;
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
  logic [3:0] select_508_s13_q;
  logic equal_509_s13_q;
  logic [6:0] select_511_s13_q;
  logic [8:0] select_515_s13_q;
  logic and_521_s13_q;
  logic and_522_s13_q;
  logic equal_527_s13_q;
  logic [6:0] column_s13_q;
  logic and_545_s13_q;
  logic and_547_s13_q;
  logic equal_567_s13_q;
  logic first_s13_q;
  logic equal_572_s13_q;
  logic not_573_s13_q;
  logic so_s13_q;
  logic not_575_s13_q;
  logic equal_576_s13_q;
  logic or_577_s13_q;
  logic less_580_s13_q;
  logic not_581_s13_q;
  logic inside_v_s13_q;
  logic and_598_s13_q;
  logic and_606_s13_q;
  logic [6:0] x_s13_2_q;
  logic [61:0] best_left_rdata_s13_q;
  logic less_617_s13_q;
  logic [6:0] select_624_s13_q;
  logic [6:0] right_s13_q;
  logic [28:0] best_right_rdata_s13_q;
  logic [6:0] chosen_s13_q;
  logic and_637_s13_q;
  logic and_642_s13_q;
  logic and_644_s13_q;
  logic equal_677_s13_q;
  logic select_759_s13_q;
  logic [6:0] difference_1007_s13_q;
  logic [6:0] difference_1256_s13_q;
  logic equal_1257_s13_q;
  logic [6:0] difference_1505_s13_q;
  logic [6:0] sum_1535_s13_q;
  logic [6:0] select_1544_s13_q;
  logic and_1559_s13_q;
  logic select_1561_s13_q;
  logic and_1570_s13_q;
  logic and_1572_s13_q;
  logic or_1580_s13_q;
  logic right_2_s13_q;
  logic and_1673_s13_q;
  logic and_1686_s13_q;
  logic and_1699_s13_q;
  logic less_1700_s13_q;
  logic equal_1701_s13_q;
  logic [7:0] sum_1706_s13_q;
  logic select_1707_s13_q;
  logic [8:0] sum_1709_s13_q;
  logic select_1711_s13_q;
  logic [8:0] difference_1713_s13_q;
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
  logic [4:0] select_1815_s13_q;
  logic select_1821_s13_q;
  logic [3:0] select_1860_s13_q;
  logic and_1870_s13_q;
  logic [31:0] patches_columns_above_rdata_s13_q;
  logic [7:0] pixel_2_s13_q;
  logic [9:0] sum_1909_s13_q;
  logic less_1946_s13_q;
  logic equal_1947_s13_q;
  logic not_1948_s13_q;
  logic equal_1949_s13_q;
  logic not_1950_s13_q;
  logic [9:0] patches_rows_rdata_s13_q;
  logic sum_1978_s13_q;
  logic and_1999_s13_q;
  logic and_2122_s13_q;
  logic equal_2262_s13_q;
  logic equal_2451_s13_q;
  logic and_2578_s13_q;
  logic equal_2663_s13_q;
  logic rise_s13_q;
  logic [7:0] xor_2668_s13_q;
  logic select_2739_s13_q;
  logic or_2742_s13_q;
  logic [1:0] sum_2743_s13_q;
  logic less_2744_s13_q;
  logic and_2975_s13_q;
  logic or_3026_s13_q;
  logic not_3050_s13_q;
  logic select_3517_s13_q;
  logic equal_3529_s13_q;
  logic less_3855_s13_q;
  logic equal_4074_s13_q;
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
      select_508_s13_q <= select_508_s12_q;
      equal_509_s13_q <= equal_509_s12_q;
      select_511_s13_q <= select_511_s12_q;
      select_515_s13_q <= select_515_s12_q;
      and_521_s13_q <= and_521_s12_q;
      and_522_s13_q <= and_522;
      equal_527_s13_q <= equal_527_s12_q;
      column_s13_q <= column_s12_q;
      and_545_s13_q <= and_545_s12_q;
      and_547_s13_q <= and_547_s12_q;
      equal_567_s13_q <= equal_567_s12_q;
      first_s13_q <= first_s12_q;
      equal_572_s13_q <= equal_572_s12_q;
      not_573_s13_q <= not_573;
      so_s13_q <= so_s12_q;
      not_575_s13_q <= not_575;
      equal_576_s13_q <= equal_576_s12_q;
      or_577_s13_q <= or_577_s12_q;
      less_580_s13_q <= less_580_s12_q;
      not_581_s13_q <= not_581_s12_q;
      inside_v_s13_q <= inside_v_s12_q;
      and_598_s13_q <= and_598_s12_q;
      and_606_s13_q <= and_606_s12_q;
      x_s13_2_q <= x_s12_2_q;
      best_left_rdata_s13_q <= best_left_rdata_s12_q;
      less_617_s13_q <= 8'hb6 < best_left_rdata_s12_q[16:9];
      select_624_s13_q <= select_624_s12_q;
      right_s13_q <= right_s12_q;
      best_right_rdata_s13_q <= best_right_rdata_s12_q;
      chosen_s13_q <= chosen;
      and_637_s13_q <= and_637_s12_q;
      and_642_s13_q <= and_642_s12_q;
      and_644_s13_q <= and_644_s12_q;
      equal_677_s13_q <= equal_677_s12_q;
      select_759_s13_q <= or_757 ? shift_first_s12_q : (~age_s12_q[1]);
      difference_1007_s13_q <= {1'b0, column_2_s12_q} - {1'b0, select_1006};
      difference_1256_s13_q <= {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1255_s12_q};
      equal_1257_s13_q <= {age_s12_q[0], slot_s12_q[0]} == 2'h0;
      difference_1505_s13_q <= {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1504_s12_q};
      sum_1535_s13_q <= {1'b0, before_v} + sum_1534;
      select_1544_s13_q <= select_1544;
      and_1559_s13_q <= and_1559_s12_q;
      select_1561_s13_q <= or_757 ? shift_first_s12_q : equal_1560_s12_q;
      and_1570_s13_q <= and_1570;
      and_1572_s13_q <= and_1572;
      or_1580_s13_q <= or_1580_s12_q;
      right_2_s13_q <= right_2_s12_q;
      and_1673_s13_q <= and_1673_s12_q;
      and_1686_s13_q <= and_1686_s12_q;
      and_1699_s13_q <= not_573 & and_1698_s12_q;
      less_1700_s13_q <= less_1700_s12_q;
      equal_1701_s13_q <= equal_1701;
      sum_1706_s13_q <= sum_1706[8:1];
      select_1707_s13_q <= select_1707[0];
      sum_1709_s13_q <= sum_1709;
      select_1711_s13_q <= select_1711[0];
      difference_1713_s13_q <= difference_1713;
      and_1733_s13_q <= and_1733_s12_q;
      select_1750_s13_q <= equal_572_s12_q ? 6'h0 : select_1749;
      select_1776_s13_q <= equal_572_s12_q ? 8'h0 : select_1775;
      equal_1778_s13_q <= equal_1778_s12_q;
      and_1783_s13_q <= and_1783;
      and_1784_s13_q <= patches_chooses_s12_q & and_1783;
      equal_1785_s13_q <= equal_1785_s12_q;
      not_1786_s13_q <= not_1786_s12_q;
      equal_1787_s13_q <= equal_1787_s12_q;
      not_1788_s13_q <= not_1788_s12_q;
      equal_1789_s13_q <= equal_1789_s12_q;
      equal_1790_s13_q <= equal_1790_s12_q;
      or_1791_s13_q <= or_1791_s12_q;
      select_1815_s13_q <= select_1815_s12_q;
      select_1821_s13_q <= select_1821_s12_q;
      select_1860_s13_q <= select_1860_s12_q;
      and_1870_s13_q <= and_1870_s12_q;
      patches_columns_above_rdata_s13_q <= patches_columns_above_rdata_s12_q;
      pixel_2_s13_q <= pixel_2;
      sum_1909_s13_q <= sum_1909;
      less_1946_s13_q <= less_1946_s12_q;
      equal_1947_s13_q <= equal_1947_s12_q;
      not_1948_s13_q <= not_1948_s12_q;
      equal_1949_s13_q <= equal_1949_s12_q;
      not_1950_s13_q <= not_1950_s12_q;
      patches_rows_rdata_s13_q <= patches_rows_rdata_s12_q;
      sum_1978_s13_q <= sum_1978_s12_q;
      and_1999_s13_q <= and_1999_s12_q;
      and_2122_s13_q <= not_573 & and_2121_s12_q;
      equal_2262_s13_q <= equal_2262_s12_q;
      equal_2451_s13_q <= equal_2451_s12_q;
      and_2578_s13_q <= and_2578_s12_q;
      equal_2663_s13_q <= equal_2663_s12_q;
      rise_s13_q <= rise[8];
      xor_2668_s13_q <= rise[7:0] ^ {8{rise[8]}};
      select_2739_s13_q <= select_2739[0];
      or_2742_s13_q <= (select_2739 == 3'h0) | (select_2739 == 3'h4);
      sum_2743_s13_q <= select_2739[2:1] + 2'h3;
      less_2744_s13_q <= less_2744_s12_q;
      and_2975_s13_q <= not_573 & and_2974_s12_q;
      or_3026_s13_q <= or_3026_s12_q;
      not_3050_s13_q <= not_3050_s12_q;
      select_3517_s13_q <= select_3517;
      equal_3529_s13_q <= equal_3529_s12_q;
      less_3855_s13_q <= less_3855_s12_q;
      equal_4074_s13_q <= equal_4074_s12_q;
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
  logic [13:0] select_525;
  assign select_525 = equal_509_s13_q ? {6'h0, sample_pair_pixel_0_q} : ({6'h0, sample_pair_pixel_0_q} + averager_running_0_q);
  logic [13:0] sum_531;
  assign sum_531 = {6'h0, sample_pair_pixel_1_q} + (equal_509_s13_q ? 14'h0 : averager_running_1_q);
  // hls/stages/moments.hpp:63
  logic [10:0] place;
  assign place = first_s13_q ? 11'h0 : moments_place_q[13:3];
  // hls/stages/moments.hpp:104
  logic not_585;
  assign not_585 = ~(11'h3ec < place);
  // hls/stages/agreement.hpp:979
  logic select_619;
  assign select_619 = slot_s13_q[2] ? less_617_s13_q : (6'h2a < best_left_rdata_s13_q[39:34]);
  // hls/stages/agreement.hpp:993
  logic [8:0] difference_629;
  assign difference_629 = {2'h0, chosen_s13_q} - {1'b0, x_s13_q};
  // hls/stages/agreement.hpp:779
  logic [7:0] sum_1009;
  assign sum_1009 = {difference_1007_s13_q[6], difference_1007_s13_q} + (age_s13_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  logic [7:0] sum_1259;
  assign sum_1259 = {difference_1256_s13_q[6], difference_1256_s13_q} + (equal_1257_s13_q ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [7:0] sum_1507;
  assign sum_1507 = {difference_1505_s13_q[6], difference_1505_s13_q} + (equal_1257_s13_q ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:756
  logic [6:0] select_1536;
  assign select_1536 = slot_s13_q[0] ? chosen_near_q : sum_1535_s13_q;
  // hls/stages/agreement.hpp:752
  logic [6:0] select_1546;
  assign select_1546 = (select_1536 < select_1544_s13_q) ? select_1544_s13_q : select_1536;
  // hls/stages/agreement.hpp:789
  logic [6:0] select_1576;
  assign select_1576 = so_s13_q ? x_s13_q[6:0] : (or_577_s13_q ? (less_580_s13_q ? 7'h0 : select_624_s13_q) : 7'h0);
  // hls/stages/agreement.hpp:149
  logic and_1589;
  assign and_1589 = or_577_s13_q & (slot_s13_q[2] & not_581_s13_q);
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1710;
  assign sum_1710 = {{3{sum_1706_s13_q[7]}}, sum_1706_s13_q} + {sum_1709_s13_q[8], sum_1709_s13_q, select_1707_s13_q};
  logic [9:0] sum_1714;
  assign sum_1714 = {difference_1713_s13_q, select_1711_s13_q} + {sum_1710[10], sum_1710[10:2]};
  // hls/stages/patches.hpp:465
  logic [8:0] sum_1898;
  assign sum_1898 = {1'b0, patches_columns_above_rdata_s13_q[7:0]} + {2'h0, pixel_2_s13_q[7:1]};
  logic [8:0] sum_1899;
  assign sum_1899 = {1'b0, patches_columns_above_rdata_s13_q[23:16]} + {2'h0, patches_columns_above_rdata_s13_q[31:25]};
  // hls/stages/patches.hpp:463
  logic [10:0] sum_1910;
  assign sum_1910 = {3'h0, patches_columns_above_rdata_s13_q[15:8]} + {sum_1909_s13_q, patches_columns_above_rdata_s13_q[25]};
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2563;
  assign select_2563 = slot_s13_q[0] ? 7'h0 : sum_1535_s13_q;
  // hls/stages/agreement.hpp:752
  logic [6:0] select_2565;
  assign select_2565 = (select_2563 < select_1544_s13_q) ? select_1544_s13_q : select_2563;
  // hls/stages/agreement.hpp:988
  logic [7:0] lower;
  assign lower = rise_s13_q ? best_left_rdata_s13_q[61:54] : best_left_rdata_s13_q[53:46];
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2745;
  assign difference_2745 = {sum_2743_s13_q, select_2739_s13_q, 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2746;
  assign select_2746 = less_2744_s13_q ? difference_2745 : {sum_2743_s13_q, select_2739_s13_q, registration_displacement_fraction_q};
  logic [7:0] select_2747;
  assign select_2747 = or_2742_s13_q ? {sum_2743_s13_q, select_2739_s13_q, 5'h0} : select_2746;
  // hls/stages/patches.hpp:187
  logic select_3065;
  assign select_3065 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:175
  logic and_3126;
  assign and_3126 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3131;
  assign select_3131 = or_3026_s13_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3133;
  assign select_3133 = and_3126 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:552
  logic [4:0] select_3506;
  assign select_3506 = less_1946_s13_q ? patches_step_s13_q : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3509;
  assign select_3509 = equal_1949_s13_q ? (less_1946_s13_q ? (equal_1949_s13_q ? 5'h0 : select_3506) : 5'h0) : select_3506;
  logic [4:0] select_3511;
  assign select_3511 = less_1946_s13_q ? (equal_1947_s13_q ? 5'h0 : select_3509) : select_3509;
  logic select_3519;
  assign select_3519 = less_1946_s13_q ? (not_1948_s13_q & select_3517_s13_q) : select_3517_s13_q;
  // hls/stages/patches.hpp:178
  logic or_3531;
  assign or_3531 = patches_read_first_q | (patches_read_row_differing_s13_q < patches_peak_best_differing_q);
  logic and_3532;
  assign and_3532 = patches_read_searches_s13_q & or_3531;
  // hls/stages/patches.hpp:535
  logic [14:0] select_3564;
  assign select_3564 = and_3532 ? {patches_read_row_column_s13_q, patches_read_row_differing_s13_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3565;
  assign select_3565 = equal_1785_s13_q ? select_3564[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3566;
  assign select_3566 = equal_1785_s13_q ? select_3564[14:10] : patches_peak_best_column_q;

  // Memory shown_right, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1378; read in stage 13, written in stage 16: 13 < 16 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s13_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s13_en & and_1572_s13_q;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1379; read in stage 13, written in stage 17: 13 < 17 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] left_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) left_turns_mem[i] = 2'h0;
`endif
  logic [6:0] left_turns_raddr;
  assign left_turns_raddr = x_s13_q[6:0];
  logic left_turns_re;
  assign left_turns_re = s13_en & and_1589;
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_turns_re) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 120 x 2, DISTANCE 24, hls/stages/agreement.hpp:1379; read in stage 13, written in stage 17: 13 < 17 < 13 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] right_turns_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_624_s13_q;
  logic right_turns_re;
  assign right_turns_re = s13_en & and_1589;
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_turns_re) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s13_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s13_en & and_1870_s13_q;
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
      chosen_near_q <= select_2565;
      patches_along_ends_q <= not_3050_s13_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3050_s13_q & select_3065;
      patches_down_by_q <= or_3026_s13_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3126});
      patches_along_q <= select_3131;
      patches_match_row_q <= or_3026_s13_q ? 4'h0 : select_3133;
      patches_summed_last_q <= not_1786_s13_q & (equal_1787_s13_q & and_3126);
      patches_read_first_q <= equal_1785_s13_q ? select_3519 : patches_read_first_q;
      patches_peak_best_differing_q <= select_3565;
      patches_peak_best_column_q <= select_3566;
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
      averager_running_0_q <= sample_pair_whole_s13_q ? select_525 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s13_q ? sum_531 : averager_running_1_q;
      middle_sum_sum_sums_values_0_q <= slot_s13_q[0] ? middle_sum_sum_sums_values_0_q : sum_1009;
      sums_0_sum_sums_values_0_q <= sum_1259;
      sums_0_sum_sums_values_1_q <= equal_1257_s13_q ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1507;
      sums_1_sum_sums_values_1_q <= equal_1257_s13_q ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [3:0] select_508_s14_q;
  logic equal_509_s14_q;
  logic [6:0] select_511_s14_q;
  logic [8:0] select_515_s14_q;
  logic and_521_s14_q;
  logic and_522_s14_q;
  logic [29:0] averager_memory_rdata_s14_q;
  logic [13:0] select_525_s14_q;
  logic equal_527_s14_q;
  logic [13:0] sum_531_s14_q;
  logic [6:0] column_s14_q;
  logic and_545_s14_q;
  logic and_547_s14_q;
  logic equal_567_s14_q;
  logic [12:0] select_571_s14_q;
  logic equal_572_s14_q;
  logic not_573_s14_q;
  logic so_s14_q;
  logic not_575_s14_q;
  logic equal_576_s14_q;
  logic or_577_s14_q;
  logic less_580_s14_q;
  logic not_581_s14_q;
  logic inside_v_s14_q;
  logic not_585_s14_q;
  logic and_588_s14_q;
  logic and_598_s14_q;
  logic and_606_s14_q;
  logic [6:0] x_s14_2_q;
  logic [45:0] best_left_rdata_s14_q;
  logic select_619_s14_q;
  logic [6:0] right_s14_q;
  logic [28:0] best_right_rdata_s14_q;
  logic [9:0] sum_630_s14_q;
  logic and_637_s14_q;
  logic and_642_s14_q;
  logic and_644_s14_q;
  logic equal_677_s14_q;
  logic select_759_s14_q;
  logic [7:0] sum_1009_s14_q;
  logic less_1508_s14_q;
  logic [6:0] select_1546_s14_q;
  logic [7:0] select_1554_s14_q;
  logic [7:0] select_1557_s14_q;
  logic and_1559_s14_q;
  logic select_1561_s14_q;
  logic and_1570_s14_q;
  logic and_1572_s14_q;
  logic [6:0] select_1576_s14_q;
  logic or_1580_s14_q;
  logic and_1598_s14_q;
  logic right_2_s14_q;
  logic and_1673_s14_q;
  logic and_1686_s14_q;
  logic and_1699_s14_q;
  logic less_1700_s14_q;
  logic equal_1701_s14_q;
  logic sum_1710_s14_q;
  logic [9:0] sum_1714_s14_q;
  logic and_1733_s14_q;
  logic [5:0] select_1750_s14_q;
  logic [7:0] select_1776_s14_q;
  logic equal_1778_s14_q;
  logic and_1783_s14_q;
  logic and_1784_s14_q;
  logic equal_1785_s14_q;
  logic not_1786_s14_q;
  logic equal_1787_s14_q;
  logic not_1788_s14_q;
  logic equal_1789_s14_q;
  logic equal_1790_s14_q;
  logic or_1791_s14_q;
  logic [4:0] select_1815_s14_q;
  logic select_1821_s14_q;
  logic [3:0] select_1860_s14_q;
  logic [8:0] patches_columns_above_rdata_s14_q;
  logic [7:0] pixel_2_s14_q;
  logic [4:0] sum_1884_s14_q;
  logic [8:0] sum_1898_s14_q;
  logic [8:0] sum_1899_s14_q;
  logic [10:0] sum_1910_s14_q;
  logic less_1946_s14_q;
  logic equal_1947_s14_q;
  logic not_1948_s14_q;
  logic equal_1949_s14_q;
  logic not_1950_s14_q;
  logic [9:0] patches_rows_rdata_s14_q;
  logic sum_1978_s14_q;
  logic and_1999_s14_q;
  logic [17:0] seen_columns_rdata_s14_q;
  logic and_2122_s14_q;
  logic equal_2262_s14_q;
  logic equal_2451_s14_q;
  logic and_2578_s14_q;
  logic equal_2663_s14_q;
  logic [7:0] lower_s14_q;
  logic [7:0] sum_2669_s14_q;
  logic [7:0] select_2747_s14_q;
  logic and_2975_s14_q;
  logic [4:0] select_3511_s14_q;
  logic equal_3529_s14_q;
  logic and_3532_s14_q;
  logic [14:0] select_3564_s14_q;
  logic less_3855_s14_q;
  logic equal_4074_s14_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s14_q <= saturated_s13_q;
      mask_s14_q <= mask_s13_q;
      marks_first_s14_q <= marks_first_s13_q;
      marks_last_s14_q <= marks_last_s13_q;
      sample_pair_pixel_0_s14_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s14_q <= sample_pair_pixel_1_q;
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
      select_508_s14_q <= select_508_s13_q;
      equal_509_s14_q <= equal_509_s13_q;
      select_511_s14_q <= select_511_s13_q;
      select_515_s14_q <= select_515_s13_q;
      and_521_s14_q <= and_521_s13_q;
      and_522_s14_q <= and_522_s13_q;
      averager_memory_rdata_s14_q <= averager_memory_rdata_q;
      select_525_s14_q <= select_525;
      equal_527_s14_q <= equal_527_s13_q;
      sum_531_s14_q <= sum_531;
      column_s14_q <= column_s13_q;
      and_545_s14_q <= and_545_s13_q;
      and_547_s14_q <= and_547_s13_q;
      equal_567_s14_q <= equal_567_s13_q;
      select_571_s14_q <= first_s13_q ? 13'h0 : moments_place_q[12:0];
      equal_572_s14_q <= equal_572_s13_q;
      not_573_s14_q <= not_573_s13_q;
      so_s14_q <= so_s13_q;
      not_575_s14_q <= not_575_s13_q;
      equal_576_s14_q <= equal_576_s13_q;
      or_577_s14_q <= or_577_s13_q;
      less_580_s14_q <= less_580_s13_q;
      not_581_s14_q <= not_581_s13_q;
      inside_v_s14_q <= inside_v_s13_q;
      not_585_s14_q <= not_585;
      and_588_s14_q <= not_575_s13_q & (equal_576_s13_q & (inside_v_s13_q & not_585));
      and_598_s14_q <= and_598_s13_q;
      and_606_s14_q <= and_606_s13_q;
      x_s14_2_q <= x_s13_2_q;
      best_left_rdata_s14_q <= best_left_rdata_s13_q[45:0];
      select_619_s14_q <= select_619;
      right_s14_q <= right_s13_q;
      best_right_rdata_s14_q <= best_right_rdata_s13_q;
      sum_630_s14_q <= {difference_629[8], difference_629} + 10'h1;
      and_637_s14_q <= and_637_s13_q;
      and_642_s14_q <= and_642_s13_q;
      and_644_s14_q <= and_644_s13_q;
      equal_677_s14_q <= equal_677_s13_q;
      select_759_s14_q <= select_759_s13_q;
      sum_1009_s14_q <= sum_1009;
      less_1508_s14_q <= sum_1259 < sum_1507;
      select_1546_s14_q <= select_1546;
      select_1554_s14_q <= select_759_s13_q ? 8'h0 : best_left_rdata_s13_q[53:46];
      select_1557_s14_q <= select_759_s13_q ? 8'h0 : best_left_rdata_s13_q[61:54];
      and_1559_s14_q <= and_1559_s13_q;
      select_1561_s14_q <= select_1561_s13_q;
      and_1570_s14_q <= and_1570_s13_q;
      and_1572_s14_q <= and_1572_s13_q;
      select_1576_s14_q <= select_1576;
      or_1580_s14_q <= or_1580_s13_q;
      and_1598_s14_q <= moments_taken_q;
      right_2_s14_q <= right_2_s13_q;
      and_1673_s14_q <= and_1673_s13_q;
      and_1686_s14_q <= and_1686_s13_q;
      and_1699_s14_q <= and_1699_s13_q;
      less_1700_s14_q <= less_1700_s13_q;
      equal_1701_s14_q <= equal_1701_s13_q;
      sum_1710_s14_q <= sum_1710[1];
      sum_1714_s14_q <= sum_1714;
      and_1733_s14_q <= and_1733_s13_q;
      select_1750_s14_q <= select_1750_s13_q;
      select_1776_s14_q <= select_1776_s13_q;
      equal_1778_s14_q <= equal_1778_s13_q;
      and_1783_s14_q <= and_1783_s13_q;
      and_1784_s14_q <= and_1784_s13_q;
      equal_1785_s14_q <= equal_1785_s13_q;
      not_1786_s14_q <= not_1786_s13_q;
      equal_1787_s14_q <= equal_1787_s13_q;
      not_1788_s14_q <= not_1788_s13_q;
      equal_1789_s14_q <= equal_1789_s13_q;
      equal_1790_s14_q <= equal_1790_s13_q;
      or_1791_s14_q <= or_1791_s13_q;
      select_1815_s14_q <= select_1815_s13_q;
      select_1821_s14_q <= select_1821_s13_q;
      select_1860_s14_q <= select_1860_s13_q;
      patches_columns_above_rdata_s14_q <= {patches_columns_above_rdata_s13_q[24], patches_columns_above_rdata_s13_q[7:0]};
      pixel_2_s14_q <= pixel_2_s13_q;
      sum_1884_s14_q <= patches_down_by_q + {1'b0, patches_match_row_q};
      sum_1898_s14_q <= sum_1898;
      sum_1899_s14_q <= sum_1899;
      sum_1910_s14_q <= sum_1910;
      less_1946_s14_q <= less_1946_s13_q;
      equal_1947_s14_q <= equal_1947_s13_q;
      not_1948_s14_q <= not_1948_s13_q;
      equal_1949_s14_q <= equal_1949_s13_q;
      not_1950_s14_q <= not_1950_s13_q;
      patches_rows_rdata_s14_q <= patches_rows_rdata_s13_q;
      sum_1978_s14_q <= sum_1978_s13_q;
      and_1999_s14_q <= and_1999_s13_q;
      seen_columns_rdata_s14_q <= seen_columns_rdata_q;
      and_2122_s14_q <= and_2122_s13_q;
      equal_2262_s14_q <= equal_2262_s13_q;
      equal_2451_s14_q <= equal_2451_s13_q;
      and_2578_s14_q <= and_2578_s13_q;
      equal_2663_s14_q <= equal_2663_s13_q;
      lower_s14_q <= lower;
      sum_2669_s14_q <= {7'h0, rise_s13_q} + xor_2668_s13_q;
      select_2747_s14_q <= select_2747;
      and_2975_s14_q <= and_2975_s13_q;
      select_3511_s14_q <= select_3511;
      equal_3529_s14_q <= equal_3529_s13_q;
      and_3532_s14_q <= and_3532;
      select_3564_s14_q <= select_3564;
      less_3855_s14_q <= less_3855_s13_q;
      equal_4074_s14_q <= equal_4074_s13_q;
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
  logic [13:0] sum_529;
  assign sum_529 = select_525_s14_q + (equal_527_s14_q ? 14'h0 : averager_memory_rdata_s14_q[13:0]);
  logic [13:0] sum_533;
  assign sum_533 = sum_531_s14_q + (equal_527_s14_q ? 14'h0 : averager_memory_rdata_s14_q[27:14]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = equal_509_s14_q ? sample_present_s14_q : (sample_present_s14_q & averager_running_mask_q);
  logic all_of_skin;
  assign all_of_skin = equal_509_s14_q ? sample_of_skin_q : (sample_of_skin_q & averager_running_of_skin_q);
  // hls/stages/census.hpp:124
  logic and_541;
  assign and_541 = all_of_skin & (averager_memory_rdata_s14_q[29] | equal_527_s14_q);
  // hls/stages/agreement.hpp:789
  logic and_589;
  assign and_589 = not_573_s14_q & and_588_s14_q;
  // hls/stages/agreement.hpp:247
  logic and_632;
  assign and_632 = (and_606_s14_q & select_619_s14_q) & ({{22{sum_630_s14_q[9]}}, sum_630_s14_q} < 32'h3);
  // hls/stages/agreement.hpp:756
  logic [7:0] select_1010;
  assign select_1010 = slot_s14_q[0] ? chosen_score_q : sum_1009_s14_q;
  // hls/stages/agreement.hpp:752
  logic [7:0] select_1509;
  assign select_1509 = less_1508_s14_q ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1510;
  assign less_1510 = select_1010 < select_1509;
  // hls/stages/agreement.hpp:802
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1510 ? select_1509 : select_1010) : 8'h0;
  // hls/stages/agreement.hpp:721
  logic not_1516;
  assign not_1516 = ~slot_s14_q[0];
  // hls/stages/agreement.hpp:753
  logic [1:0] select_1517;
  assign select_1517 = less_1508_s14_q ? {slot_s14_q[0], not_1516} : 2'h0;
  logic [2:0] select_1519;
  assign select_1519 = less_1510 ? {select_1517, not_1516} : (slot_s14_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:803
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? select_1546_s14_q : 7'h0;
  // hls/stages/agreement.hpp:814
  logic less_1548;
  assign less_1548 = best_left_rdata_s14_q[39:33] < of_near;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s14_q[5:3] == 3'h4;
  // hls/stages/patches.hpp:210
  logic equal_1619;
  assign equal_1619 = x_s14_q[5:0] == 6'h3c;
  logic equal_1621;
  assign equal_1621 = x_s14_q[5:0] == 6'h3b;
  logic equal_1623;
  assign equal_1623 = x_s14_q[5:0] == 6'h36;
  logic equal_1625;
  assign equal_1625 = x_s14_q[5:0] == 6'h35;
  logic equal_1627;
  assign equal_1627 = x_s14_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1179
  logic and_1631;
  assign and_1631 = (~equal_1621) & ((~equal_1623) & ((~equal_1625) & (~equal_1627)));
  // hls/stages/patches.hpp:373
  logic [1:0] select_1687;
  assign select_1687 = and_1686_s14_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1688;
  assign select_1688 = and_1686_s14_q ? patches_band_rows_number_s14_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1689;
  assign select_1689 = and_1673_s14_q ? {select_1688, select_1687[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1690;
  assign select_1690 = and_1673_s14_q ? select_1687 : patches_fetch_q;
  logic equal_1691;
  assign equal_1691 = select_1690 == 2'h0;
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1701_s14_q ? {sum_1714_s14_q, sum_1710_s14_q} : registration_expected_q;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1798;
  assign select_1798 = and_1673_s14_q ? select_1688 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_1799;
  assign equal_1799 = {patches_choosing_band_s14_q, and_1699_s14_q} == {select_1798, select_1690[1]};
  // hls/stages/patches.hpp:496
  logic less_1876;
  assign less_1876 = 5'he < patches_along_s14_q;
  // hls/stages/patches.hpp:497
  logic or_1877;
  assign or_1877 = equal_1789_s14_q | less_1876;
  // hls/stages/patches.hpp:500
  logic new_row;
  assign new_row = patches_along_s14_q == 5'h0;
  logic select_1882;
  assign select_1882 = equal_1789_s14_q ? patches_column_s14_q[0] : (or_1877 ? (patches_along_s14_q == 5'h10) : (~new_row));
  // hls/stages/patches.hpp:498
  logic [4:0] select_1885;
  assign select_1885 = patches_match_row_ends_s14_q ? patches_down_by_s14_q : sum_1884_s14_q;
  // hls/stages/patches.hpp:501
  logic [4:0] select_1888;
  assign select_1888 = equal_1789_s14_q ? 5'h0 : (or_1877 ? (select_1885 + 5'h1) : sum_1884_s14_q);
  // hls/stages/patches.hpp:477
  logic equal_1891;
  assign equal_1891 = patches_column_s14_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s14_q == 5'h11;
  logic equal_1893;
  assign equal_1893 = patches_column_s14_q == 5'h18;
  // hls/stages/patches.hpp:479
  logic and_1895;
  assign and_1895 = of_row & (~equal_1893);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1891 ? 2'h3 : {equal_1893, and_1895};
  // hls/stages/patches.hpp:465
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1898_s14_q, pixel_2_s14_q[0]} - {1'b0, sum_1899_s14_q, patches_columns_above_rdata_s14_q[8]};
  // hls/stages/patches.hpp:463
  logic [9:0] sum_1911;
  assign sum_1911 = {2'h0, patches_columns_above_rdata_s14_q[7:0]} + sum_1910_s14_q[10:1];
  // hls/stages/patches.hpp:478
  logic or_1921;
  assign or_1921 = (((patches_column_s14_q == 5'ha) | of_row) | equal_1893) | equal_1891;
  // hls/stages/patches.hpp:473
  logic and_1926;
  assign and_1926 = (~(patches_code_row_s14_q[4:2] == 3'h0)) & (~(patches_column_s14_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:172
  logic and_1940;
  assign and_1940 = (~(equal_1790_s14_q | (~and_1926))) & (~patches_column_s14_q[4]);
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1965;
  assign select_1965 = so_s14_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1051
  logic or_1968;
  assign or_1968 = select_1965[7] | (~({select_1965[5], select_1965[3], select_1965[1]} == 3'h0));
  // hls/stages/agreement.hpp:1059
  logic or_1980;
  assign or_1980 = (~sum_1978_s14_q) | equal_1778_s14_q;
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s14_q & (or_577_s14_q & (not_581_s14_q & and_606_s14_q));
  // hls/stages/agreement.hpp:1031
  logic [7:0] select_2063;
  assign select_2063 = inside_v_s14_q ? (sum_1978_s14_q ? select_1965 : {select_1965[6:0], 1'b0}) : select_1965;
  // hls/stages/agreement.hpp:1051
  logic or_2066;
  assign or_2066 = select_2063[7] | (~({select_2063[5], select_2063[3], select_2063[1]} == 3'h0));
  // hls/stages/agreement.hpp:276
  logic select_2175;
  assign select_2175 = sample_pair_whole_s14_q ? all_of_skin : averager_running_of_skin_q;
  // hls/stages/agreement.hpp:239
  logic [7:0] select_2560;
  assign select_2560 = slot_s14_q[0] ? 8'h0 : sum_1009_s14_q;
  // hls/stages/agreement.hpp:752
  logic less_2561;
  assign less_2561 = select_2560 < select_1509;
  // hls/stages/agreement.hpp:789
  logic less_2567;
  assign less_2567 = $signed(run_shift_s14_q) < $signed($unsigned(cfg_shift_lowest_i));
  logic less_2569;
  assign less_2569 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s14_q);
  // hls/stages/agreement.hpp:989
  logic [7:0] difference_2667;
  assign difference_2667 = best_left_rdata_s14_q[16:9] - lower_s14_q;
  // hls/stages/agreement.hpp:789
  logic [10:0] select_2732;
  assign select_2732 = equal_572_s14_q ? registration_expected_q : (so_s14_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:102
  logic [11:0] value_2;
  assign value_2 = {{4{select_2747_s14_q[7]}}, select_2747_s14_q} - {sum_1714_s14_q[9], sum_1714_s14_q, sum_1710_s14_q};
  // hls/stages/patches.hpp:354
  logic not_2991;
  assign not_2991 = ~select_1690[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_2993;
  assign select_2993 = sample_pair_whole_s14_q ? (equal_1691 ? select_1690 : {not_2991, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:184
  logic [4:0] select_3488;
  assign select_3488 = equal_1787_s14_q ? patches_down_by_s14_q : patches_summed_down_by_q;
  // hls/stages/patches.hpp:536
  logic [4:0] select_3533;
  assign select_3533 = and_3532_s14_q ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:543
  logic [5:0] away;
  assign away = {1'b0, patches_step_s14_q} - {1'b0, select_3533};
  // hls/stages/division.hpp:34
  logic [7:0] sum_3856;
  assign sum_3856 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3865;
  assign select_3865 = equal_572_s14_q ? select_1965 : (so_s14_q ? (ends_cell_s14_q ? select_2063 : select_1965) : 8'h1);
  // hls/stages/agreement.hpp:461
  logic [8:0] select_3879;
  assign select_3879 = equal_677_s14_q ? {difference_3877[7], difference_3877} : (less_3855_s14_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:521
  logic [8:0] select_3881;
  assign select_3881 = and_547_s14_q ? (equal_2451_s14_q ? select_3879 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:461
  logic [7:0] select_3883;
  assign select_3883 = equal_677_s14_q ? (8'h6 - {1'b0, cfg_height_i[10:4]}) : region_down_back_q;
  // hls/stages/agreement.hpp:521
  logic [7:0] select_3885;
  assign select_3885 = and_547_s14_q ? (equal_2451_s14_q ? select_3883 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:36
  logic [8:0] select_3887;
  assign select_3887 = sum_3856[7] ? {1'b1, sum_3856[6:0], region_down_rest_q[0]} : (region_down_rest_q + {region_down_back_q[7], region_down_back_q});

  // Memory census_memory, 120 x 78, DISTANCE 16, hls/stages/census.hpp:340; read in stage 14, written in stage 16: 14 < 16 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:119];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 120; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s14_q;
  logic census_memory_re;
  assign census_memory_re = s14_en & and_547_s14_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 8040 x 4, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 14, written in stage 15: 14 < 15 < 14 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:8039];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 8040; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_571_s14_q;
  logic moments_memory_re;
  assign moments_memory_re = s14_en & and_589;
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (moments_memory_re) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
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
      averager_running_of_skin_q <= select_2175;
      chosen_score_q <= less_2561 ? select_1509 : select_2560;
      chosen_place_q <= less_2561 ? {select_1517, not_1516} : 3'h2;
      before_0_q <= select_2560;
      before_1_q <= sums_0_sum_sums_values_0_q;
      before_2_q <= sums_1_sum_sums_values_0_q;
      shift_allowed_q <= (~less_2567) & (~less_2569);
      registration_expected_q <= select_2732;
      patches_band_q <= sample_pair_whole_s14_q ? select_1798 : patches_band_q;
      patches_fetch_q <= select_2993;
      patches_summed_down_by_q <= equal_1785_s14_q ? patches_summed_down_by_q : select_3488;
      patches_read_at_q <= equal_1785_s14_q ? select_3511_s14_q : patches_read_at_q;
      patches_peak_row_q <= equal_1785_s14_q ? select_3533 : patches_peak_row_q;
      region_columns_q <= select_3865;
      region_down_rest_q <= select_3881;
      region_down_back_q <= select_3885;
      region_down_next_q <= select_3887;
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
  logic [3:0] select_508_s15_q;
  logic [6:0] select_511_s15_q;
  logic [8:0] select_515_s15_q;
  logic and_521_s15_q;
  logic and_522_s15_q;
  logic [13:0] sum_529_s15_q;
  logic [13:0] sum_533_s15_q;
  logic and_537_s15_q;
  logic and_541_s15_q;
  logic [6:0] column_s15_q;
  logic and_545_s15_q;
  logic and_547_s15_q;
  logic equal_550_s15_q;
  logic equal_567_s15_q;
  logic [12:0] select_571_s15_q;
  logic equal_572_s15_q;
  logic not_573_s15_q;
  logic so_s15_q;
  logic not_575_s15_q;
  logic equal_576_s15_q;
  logic or_577_s15_q;
  logic less_580_s15_q;
  logic not_581_s15_q;
  logic inside_v_s15_q;
  logic not_585_s15_q;
  logic and_589_s15_q;
  logic and_598_s15_q;
  logic [6:0] x_s15_2_q;
  logic [32:0] best_left_rdata_s15_q;
  logic [6:0] right_s15_q;
  logic [28:0] best_right_rdata_s15_q;
  logic and_632_s15_q;
  logic and_637_s15_q;
  logic and_642_s15_q;
  logic and_644_s15_q;
  logic equal_677_s15_q;
  logic select_759_s15_q;
  logic [7:0] of_best_s15_q;
  logic [2:0] select_1519_s15_q;
  logic [6:0] of_near_s15_q;
  logic [6:0] select_1549_s15_q;
  logic [5:0] select_1551_s15_q;
  logic [7:0] select_1554_s15_q;
  logic [7:0] select_1557_s15_q;
  logic and_1559_s15_q;
  logic select_1561_s15_q;
  logic or_1567_s15_q;
  logic and_1570_s15_q;
  logic and_1572_s15_q;
  logic [1:0] shown_right_rdata_s15_q;
  logic [6:0] select_1576_s15_q;
  logic and_1581_s15_q;
  logic [1:0] left_turns_rdata_s15_q;
  logic and_1598_s15_q;
  logic [1:0] right_turns_rdata_s15_q;
  logic equal_1605_s15_q;
  logic all_s15_q;
  logic equal_1619_s15_q;
  logic equal_1621_s15_q;
  logic equal_1623_s15_q;
  logic equal_1625_s15_q;
  logic equal_1627_s15_q;
  logic and_1632_s15_q;
  logic right_2_s15_q;
  logic and_1673_s15_q;
  logic [5:0] select_1689_s15_q;
  logic select_1690_s15_q;
  logic equal_1691_s15_q;
  logic and_1699_s15_q;
  logic less_1700_s15_q;
  logic equal_1701_s15_q;
  logic expected_s15_q;
  logic [10:0] sum_1716_s15_q;
  logic and_1733_s15_q;
  logic [5:0] select_1750_s15_q;
  logic [7:0] select_1776_s15_q;
  logic and_1783_s15_q;
  logic and_1784_s15_q;
  logic equal_1785_s15_q;
  logic not_1786_s15_q;
  logic equal_1787_s15_q;
  logic not_1788_s15_q;
  logic equal_1790_s15_q;
  logic or_1791_s15_q;
  logic and_1800_s15_q;
  logic [4:0] select_1815_s15_q;
  logic select_1821_s15_q;
  logic [3:0] select_1860_s15_q;
  logic patches_columns_above_rdata_s15_q;
  logic [7:0] pixel_2_s15_q;
  logic less_1876_s15_q;
  logic new_row_s15_q;
  logic select_1882_s15_q;
  logic not_1883_s15_q;
  logic [4:0] select_1888_s15_q;
  logic or_1889_s15_q;
  logic [1:0] of_row_2_s15_q;
  logic [10:0] down_2_s15_q;
  logic sum_1910_s15_q;
  logic [9:0] sum_1911_s15_q;
  logic and_1929_s15_q;
  logic and_1940_s15_q;
  logic and_1943_s15_q;
  logic less_1946_s15_q;
  logic equal_1947_s15_q;
  logic not_1948_s15_q;
  logic equal_1949_s15_q;
  logic not_1950_s15_q;
  logic [9:0] patches_rows_rdata_s15_q;
  logic or_1968_s15_q;
  logic or_1971_s15_q;
  logic or_1974_s15_q;
  logic and_1983_s15_q;
  logic textured_s15_q;
  logic and_1999_s15_q;
  logic [12:0] seen_columns_rdata_s15_q;
  logic and_2049_s15_q;
  logic and_2051_s15_q;
  logic or_2066_s15_q;
  logic or_2069_s15_q;
  logic or_2072_s15_q;
  logic and_2083_s15_q;
  logic and_2099_s15_q;
  logic and_2122_s15_q;
  logic equal_2262_s15_q;
  logic equal_2451_s15_q;
  logic and_2578_s15_q;
  logic and_2602_s15_q;
  logic equal_2663_s15_q;
  logic [5:0] difference_2667_s15_q;
  logic [7:0] sum_2669_s15_q;
  logic [11:0] select_2750_s15_q;
  logic and_2975_s15_q;
  logic less_3102_s15_q;
  logic equal_3529_s15_q;
  logic [4:0] select_3533_s15_q;
  logic [5:0] away_s15_q;
  logic equal_3535_s15_q;
  logic equal_3544_s15_q;
  logic [14:0] select_3564_s15_q;
  logic less_3855_s15_q;
  logic sum_3856_s15_q;
  logic select_3898_s15_q;
  logic equal_3909_s15_q;
  logic equal_3948_s15_q;
  logic and_4064_s15_q;
  logic equal_4074_s15_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s15_q <= sample_pair_pixel_0_q;
      pixel_1_s15_q <= sample_pair_pixel_1_q;
      saturated_s15_q <= saturated_s14_q;
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
      select_508_s15_q <= select_508_s14_q;
      select_511_s15_q <= select_511_s14_q;
      select_515_s15_q <= select_515_s14_q;
      and_521_s15_q <= and_521_s14_q;
      and_522_s15_q <= and_522_s14_q;
      sum_529_s15_q <= sum_529;
      sum_533_s15_q <= sum_533;
      and_537_s15_q <= whole & (averager_memory_rdata_s14_q[28] | equal_527_s14_q);
      and_541_s15_q <= and_541;
      column_s15_q <= column_s14_q;
      and_545_s15_q <= and_545_s14_q;
      and_547_s15_q <= and_547_s14_q;
      equal_550_s15_q <= select_508_s14_q == 4'h3;
      equal_567_s15_q <= equal_567_s14_q;
      select_571_s15_q <= select_571_s14_q;
      equal_572_s15_q <= equal_572_s14_q;
      not_573_s15_q <= not_573_s14_q;
      so_s15_q <= so_s14_q;
      not_575_s15_q <= not_575_s14_q;
      equal_576_s15_q <= equal_576_s14_q;
      or_577_s15_q <= or_577_s14_q;
      less_580_s15_q <= less_580_s14_q;
      not_581_s15_q <= not_581_s14_q;
      inside_v_s15_q <= inside_v_s14_q;
      not_585_s15_q <= not_585_s14_q;
      and_589_s15_q <= and_589;
      and_598_s15_q <= and_598_s14_q;
      x_s15_2_q <= x_s14_2_q;
      best_left_rdata_s15_q <= best_left_rdata_s14_q[32:0];
      right_s15_q <= right_s14_q;
      best_right_rdata_s15_q <= best_right_rdata_s14_q;
      and_632_s15_q <= and_632;
      and_637_s15_q <= and_637_s14_q;
      and_642_s15_q <= and_642_s14_q;
      and_644_s15_q <= and_644_s14_q;
      equal_677_s15_q <= equal_677_s14_q;
      select_759_s15_q <= select_759_s14_q;
      of_best_s15_q <= of_best;
      select_1519_s15_q <= select_1519;
      of_near_s15_q <= of_near;
      select_1549_s15_q <= less_1548 ? of_near : best_left_rdata_s14_q[39:33];
      select_1551_s15_q <= less_1548 ? run_shift_s14_q : best_left_rdata_s14_q[45:40];
      select_1554_s15_q <= select_1554_s14_q;
      select_1557_s15_q <= select_1557_s14_q;
      and_1559_s15_q <= and_1559_s14_q;
      select_1561_s15_q <= select_1561_s14_q;
      or_1567_s15_q <= select_1561_s14_q | (best_right_rdata_s14_q[21:15] < of_near);
      and_1570_s15_q <= and_1570_s14_q;
      and_1572_s15_q <= and_1572_s14_q;
      shown_right_rdata_s15_q <= shown_right_rdata_q;
      select_1576_s15_q <= select_1576_s14_q;
      and_1581_s15_q <= and_632 & or_1580_s14_q;
      left_turns_rdata_s15_q <= left_turns_rdata_q;
      and_1598_s15_q <= and_1598_s14_q;
      right_turns_rdata_s15_q <= right_turns_rdata_q;
      equal_1605_s15_q <= x_s14_q[6:4] == 3'h7;
      all_s15_q <= all;
      equal_1619_s15_q <= equal_1619;
      equal_1621_s15_q <= equal_1621;
      equal_1623_s15_q <= equal_1623;
      equal_1625_s15_q <= equal_1625;
      equal_1627_s15_q <= equal_1627;
      and_1632_s15_q <= (~equal_1619) & and_1631;
      right_2_s15_q <= right_2_s14_q;
      and_1673_s15_q <= and_1673_s14_q;
      select_1689_s15_q <= select_1689;
      select_1690_s15_q <= select_1690[1];
      equal_1691_s15_q <= equal_1691;
      and_1699_s15_q <= and_1699_s14_q;
      less_1700_s15_q <= less_1700_s14_q;
      equal_1701_s15_q <= equal_1701_s14_q;
      expected_s15_q <= expected[0];
      sum_1716_s15_q <= {expected[10], expected[10:1]} + 11'h5;
      and_1733_s15_q <= and_1733_s14_q;
      select_1750_s15_q <= select_1750_s14_q;
      select_1776_s15_q <= select_1776_s14_q;
      and_1783_s15_q <= and_1783_s14_q;
      and_1784_s15_q <= and_1784_s14_q;
      equal_1785_s15_q <= equal_1785_s14_q;
      not_1786_s15_q <= not_1786_s14_q;
      equal_1787_s15_q <= equal_1787_s14_q;
      not_1788_s15_q <= not_1788_s14_q;
      equal_1790_s15_q <= equal_1790_s14_q;
      or_1791_s15_q <= or_1791_s14_q;
      and_1800_s15_q <= and_1784_s14_q & equal_1799;
      select_1815_s15_q <= select_1815_s14_q;
      select_1821_s15_q <= select_1821_s14_q;
      select_1860_s15_q <= select_1860_s14_q;
      patches_columns_above_rdata_s15_q <= patches_columns_above_rdata_s14_q[8];
      pixel_2_s15_q <= pixel_2_s14_q;
      less_1876_s15_q <= less_1876;
      new_row_s15_q <= new_row;
      select_1882_s15_q <= select_1882;
      not_1883_s15_q <= ~or_1877;
      select_1888_s15_q <= select_1888;
      or_1889_s15_q <= equal_1789_s14_q | equal_1787_s14_q;
      of_row_2_s15_q <= of_row_2;
      down_2_s15_q <= down_2;
      sum_1910_s15_q <= sum_1910_s14_q[0];
      sum_1911_s15_q <= sum_1911;
      and_1929_s15_q <= or_1791_s14_q & (or_1921 & (equal_1790_s14_q & and_1926));
      and_1940_s15_q <= and_1940;
      and_1943_s15_q <= or_1791_s14_q & (and_1940 & (patches_column_s14_q == 5'hf));
      less_1946_s15_q <= less_1946_s14_q;
      equal_1947_s15_q <= equal_1947_s14_q;
      not_1948_s15_q <= not_1948_s14_q;
      equal_1949_s15_q <= equal_1949_s14_q;
      not_1950_s15_q <= not_1950_s14_q;
      patches_rows_rdata_s15_q <= patches_rows_rdata_s14_q;
      or_1968_s15_q <= or_1968;
      or_1971_s15_q <= select_1965[7] | (~({select_1965[6], select_1965[3:2]} == 3'h0));
      or_1974_s15_q <= select_1965[7] | (~(select_1965[6:4] == 3'h0));
      and_1983_s15_q <= so_s14_q & (ends_cell_s14_q & (inside_v_s14_q & or_1980));
      textured_s15_q <= textured;
      and_1999_s15_q <= and_1999_s14_q;
      seen_columns_rdata_s15_q <= {seen_columns_rdata_s14_q[13:7], seen_columns_rdata_s14_q[5:0]};
      and_2049_s15_q <= seen_columns_rdata_s14_q[14] & inside_v_s14_q;
      and_2051_s15_q <= seen_columns_rdata_s14_q[5] & inside_v_s14_q;
      or_2066_s15_q <= or_2066;
      or_2069_s15_q <= select_2063[7] | (~({select_2063[6], select_2063[3:2]} == 3'h0));
      or_2072_s15_q <= select_2063[7] | (~(select_2063[6:4] == 3'h0));
      and_2083_s15_q <= seen_columns_rdata_s14_q[16] & inside_v_s14_q;
      and_2099_s15_q <= seen_columns_rdata_s14_q[17] & inside_v_s14_q;
      and_2122_s15_q <= and_2122_s14_q;
      equal_2262_s15_q <= equal_2262_s14_q;
      equal_2451_s15_q <= equal_2451_s14_q;
      and_2578_s15_q <= and_2578_s14_q;
      and_2602_s15_q <= seen_columns_rdata_s14_q[15] & inside_v_s14_q;
      equal_2663_s15_q <= equal_2663_s14_q;
      difference_2667_s15_q <= difference_2667[7:2];
      sum_2669_s15_q <= sum_2669_s14_q;
      select_2750_s15_q <= ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
      and_2975_s15_q <= and_2975_s14_q;
      less_3102_s15_q <= 4'he < patches_column_s14_q[4:1];
      equal_3529_s15_q <= equal_3529_s14_q;
      select_3533_s15_q <= select_3533;
      away_s15_q <= away;
      equal_3535_s15_q <= away == 6'h3f;
      equal_3544_s15_q <= away == 6'h1;
      select_3564_s15_q <= select_3564_s14_q;
      less_3855_s15_q <= less_3855_s14_q;
      sum_3856_s15_q <= sum_3856[7];
      select_3898_s15_q <= sum_1978_s14_q ? (equal_1778_s14_q & or_1980) : or_1980;
      equal_3909_s15_q <= x_s14_q[6:3] == 4'h7;
      equal_3948_s15_q <= x_s14_q[6:3] == 4'h6;
      and_4064_s15_q <= seen_columns_rdata_s14_q[6] & inside_v_s14_q;
      equal_4074_s15_q <= equal_4074_s14_q;
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
  logic segment_starts_q;
  logic centres_values_0_textured_q;
  logic centres_values_0_of_skin_q;
  logic centres_values_1_textured_q;
  logic centres_values_1_of_skin_q;
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_521_s15_q ? sum_529_s15_q[13:5] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_550_s15_q ? 11'h0 : averager_total_0_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_521_s15_q ? sum_533_s15_q[13:5] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_550_s15_q ? 11'h0 : averager_total_1_q);
  // hls/stages/census.hpp:207
  logic and_558;
  assign and_558 = and_521_s15_q & and_537_s15_q;
  // hls/stages/census.hpp:127
  logic select_560;
  assign select_560 = equal_550_s15_q ? and_558 : (averager_mask_q & and_558);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s15_q & select_560;
  // hls/stages/census.hpp:207
  logic and_562;
  assign and_562 = and_521_s15_q & and_541_s15_q;
  // hls/stages/census.hpp:127
  logic select_564;
  assign select_564 = equal_550_s15_q ? and_562 : (averager_of_skin_q & and_562);
  // hls/stages/agreement.hpp:149
  logic and_634;
  assign and_634 = or_577_s15_q & (not_581_s15_q & and_632_s15_q);
  // hls/stages/moments.hpp:77
  logic and_635;
  assign and_635 = and_598_s15_q & and_634;
  // hls/stages/agreement.hpp:811
  logic equal_1522;
  assign equal_1522 = select_1519_s15_q == 3'h1;
  logic or_1525;
  assign or_1525 = equal_1522 | (~(select_1519_s15_q == 3'h2));
  logic [7:0] select_1527;
  assign select_1527 = or_1525 ? before_0_s15_q : before_1_s15_q;
  logic [7:0] select_1528;
  assign select_1528 = equal_1522 ? (or_1525 ? before_1_q : {7'h0, shift_not_right_s15_q}) : select_1527;
  // hls/stages/agreement.hpp:812
  logic [7:0] select_1531;
  assign select_1531 = equal_1522 ? select_1527 : (or_1525 ? before_2_q : before_2_s15_q);
  // hls/stages/agreement.hpp:825
  logic or_1563;
  assign or_1563 = select_1561_s15_q | (best_right_rdata_s15_q[7:0] < of_best_s15_q);
  // hls/stages/agreement.hpp:149
  logic and_1583;
  assign and_1583 = or_577_s15_q & (not_581_s15_q & and_1581_s15_q);
  // hls/stages/agreement.hpp:789
  logic and_1587;
  assign and_1587 = not_573_s15_q & (so_s15_q ? and_1570_s15_q : (equal_576_s15_q & and_634));
  // hls/stages/agreement.hpp:1179
  logic [1:0] quarter;
  assign quarter = x_s15_q[1:0] + 2'h1;
  // hls/stages/agreement.hpp:1130
  logic [1:0] select_1608;
  assign select_1608 = x_s15_q[4] ? {x_s15_q[3], x_s15_q[0]} : {x_s15_q[0], x_s15_q[3]};
  // hls/stages/agreement.hpp:1143
  logic [3:0] select_1610;
  assign select_1610 = equal_1605_s15_q ? {2'h0, quarter} : (all_s15_q ? {1'b0, x_s15_q[2:0]} : {x_s15_q[2:1], select_1608});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1611;
  assign sum_1611 = slot_s15_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_1612;
  assign select_1612 = equal_572_s15_q ? select_1610 : {sum_1611, lower_half_s15_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1613;
  assign equal_1613 = x_s15_q[5:0] == 6'h3f;
  logic equal_1615;
  assign equal_1615 = x_s15_q[5:0] == 6'h3e;
  logic equal_1617;
  assign equal_1617 = x_s15_q[5:0] == 6'h3d;
  // hls/stages/agreement.hpp:1179
  logic and_1635;
  assign and_1635 = (~equal_1613) & ((~equal_1615) & ((~equal_1617) & and_1632_s15_q));
  // hls/stages/agreement.hpp:1130
  logic less_1636;
  assign less_1636 = x_s15_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all_s15_q ? {1'b0, x_s15_q[2]} : x_s15_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1640;
  assign or_1640 = (kind == 2'h3) | (x_s15_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s15_q ? (right_2_s15_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1651;
  assign sum_1651 = {2'h0, slot_s15_q} + 5'h1f;
  // hls/stages/registration.hpp:258
  logic not_1657;
  assign not_1657 = ~lower_half_s15_q;
  logic [3:0] select_1658;
  assign select_1658 = registration_of_right_q ? {lower_half_s15_q, 1'b0, not_1657, 1'b0} : {1'b0, lower_half_s15_q, 1'b0, not_1657};
  // hls/stages/patches.hpp:98
  logic less_1717;
  assign less_1717 = {{4{sum_1716_s15_q[10]}}, sum_1716_s15_q, expected_s15_q} < 16'h15;
  // hls/stages/patches.hpp:467
  logic [11:0] sum_1901;
  assign sum_1901 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1902;
  assign sum_1902 = {{4{down_2_s15_q[10]}}, down_2_s15_q[10:2]} + {sum_1901[11], sum_1901};
  // hls/stages/patches.hpp:464
  logic [11:0] smooth;
  assign smooth = {sum_1911_s15_q, sum_1910_s15_q, patches_columns_above_rdata_s15_q} + {4'h0, pixel_2_s15_q};
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1975;
  assign select_1975 = equal_572_s15_q ? x_s15_q[5:0] : {region_row_q, or_1974_s15_q, or_1971_s15_q, or_1968_s15_q};
  // hls/stages/agreement.hpp:1129
  logic not_1976;
  assign not_1976 = ~equal_1605_s15_q;
  // hls/stages/agreement.hpp:149
  logic and_2001;
  assign and_2001 = or_577_s15_q & (not_581_s15_q & and_1999_s15_q);
  // hls/stages/agreement.hpp:1015
  logic select_2011;
  assign select_2011 = slot_s15_q[2] ? shown_shown_q : and_634;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s15_q & (shown_right_rdata_s15_q[0] | select_2011);
  // hls/stages/agreement.hpp:1015
  logic select_2014;
  assign select_2014 = slot_s15_q[2] ? shown_nearer_q : and_1583;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s15_q & (select_2011 ? select_2014 : shown_right_rdata_s15_q[1]);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2154;
  assign select_2154 = sample_pair_whole_s15_q ? (and_545_s15_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2156;
  assign select_2156 = sample_pair_whole_s15_q ? (and_545_s15_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2177;
  assign select_2177 = sample_pair_whole_s15_q ? (and_545_s15_q ? select_560 : averager_mask_q) : averager_mask_q;
  logic select_2179;
  assign select_2179 = sample_pair_whole_s15_q ? (and_545_s15_q ? select_564 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:789
  logic and_2582;
  assign and_2582 = not_573_s15_q & (so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & and_2578_s15_q)));
  // hls/stages/agreement.hpp:1106
  logic not_2601;
  assign not_2601 = ~(x_s15_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:789
  logic and_2643;
  assign and_2643 = so_s15_q & (ends_cell_s15_q & (inside_v_s15_q & (and_2578_s15_q & and_2001)));
  // hls/stages/agreement.hpp:1111
  logic and_2648;
  assign and_2648 = not_2601 & (centres_values_1_textured_q & centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:247
  logic and_2672;
  assign and_2672 = ((and_1999_s15_q & and_632_s15_q) & equal_2663_s15_q) & (~({2'h0, difference_2667_s15_q} < sum_2669_s15_q));
  // hls/stages/agreement.hpp:149
  logic and_2682;
  assign and_2682 = not_581_s15_q & (slot_s15_q[2] & left_turns_rdata_s15_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2684;
  assign and_2684 = not_581_s15_q & (slot_s15_q[2] & left_turns_rdata_s15_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2685;
  assign select_2685 = or_577_s15_q ? {and_2684, and_2682} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2687;
  assign select_2687 = less_580_s15_q ? 2'h0 : (slot_s15_q[2] ? right_turns_rdata_s15_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2688;
  assign select_2688 = or_577_s15_q ? select_2687 : 2'h0;
  // hls/stages/registration.hpp:108
  logic equal_2733;
  assign equal_2733 = slot_s15_q == 3'h4;
  // hls/stages/registration.hpp:218
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2750_s15_q[11:7])) ? 12'h7f : select_2750_s15_q;
  // hls/stages/agreement.hpp:789
  logic select_2794;
  assign select_2794 = so_s15_q ? (equal_2733 ? right_2_s15_q : registration_of_right_q) : registration_of_right_q;
  logic select_2797;
  assign select_2797 = so_s15_q ? (equal_1701_s15_q ? inside_v_s15_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/agreement.hpp:1130
  logic [1:0] quarter_2;
  assign quarter_2 = all_s15_q ? x_s15_q[1:0] : select_1608;
  // hls/stages/patches.hpp:184
  logic [10:0] select_3080;
  assign select_3080 = equal_1787_s15_q ? patches_down_values_0_q : (or_1791_s15_q ? down_2_s15_q : patches_down_values_0_q);
  logic [10:0] select_3082;
  assign select_3082 = or_1791_s15_q ? patches_down_values_0_q : patches_down_values_1_q;
  logic [10:0] select_3084;
  assign select_3084 = equal_1785_s15_q ? patches_down_values_1_q : (equal_1787_s15_q ? patches_down_values_1_q : select_3082);
  // hls/stages/patches.hpp:552
  logic and_3537;
  assign and_3537 = less_1946_s15_q & (equal_3529_s15_q & equal_3535_s15_q);
  // hls/stages/patches.hpp:556
  logic select_3540;
  assign select_3540 = equal_1949_s15_q ? (less_1946_s15_q ? (not_1950_s15_q & and_3537) : and_3537) : and_3537;
  // hls/stages/patches.hpp:552
  logic and_3546;
  assign and_3546 = less_1946_s15_q & (equal_3529_s15_q & equal_3544_s15_q);
  // hls/stages/patches.hpp:556
  logic select_3549;
  assign select_3549 = equal_1949_s15_q ? (less_1946_s15_q ? (not_1950_s15_q & and_3546) : and_3546) : and_3546;
  // hls/stages/patches.hpp:549
  logic [6:0] sum_3553;
  assign sum_3553 = {away_s15_q[5], away_s15_q} + 7'h7d;
  // hls/stages/agreement.hpp:789
  logic select_3852;
  assign select_3852 = equal_572_s15_q ? shown_shown_q : (so_s15_q ? select_2011 : shown_shown_q);
  logic select_3854;
  assign select_3854 = equal_572_s15_q ? shown_nearer_q : (so_s15_q ? select_2014 : shown_nearer_q);
  // hls/stages/agreement.hpp:461
  logic [2:0] select_3858;
  assign select_3858 = less_3855_s15_q ? (sum_3856_s15_q ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3860;
  assign select_3860 = equal_2451_s15_q ? (equal_677_s15_q ? 3'h0 : select_3858) : region_row_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3856_s15_q;
  // hls/stages/agreement.hpp:461
  logic select_3891;
  assign select_3891 = equal_2451_s15_q ? (equal_677_s15_q | (less_3855_s15_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3896;
  assign or_3896 = segment_starts_q | not_575_s15_q;
  // hls/stages/agreement.hpp:789
  logic select_3900;
  assign select_3900 = ends_cell_s15_q ? (inside_v_s15_q ? select_3898_s15_q : or_3896) : or_3896;
  // hls/stages/agreement.hpp:1218
  logic equal_3929;
  assign equal_3929 = x_s15_q[6:3] == 4'ha;
  logic equal_3933;
  assign equal_3933 = x_s15_q[6:3] == 4'h9;
  logic equal_3934;
  assign equal_3934 = x_s15_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1126
  logic [7:0] select_3950;
  assign select_3950 = equal_3909_s15_q ? cfg_unproven_limit_i : (equal_3948_s15_q ? cfg_explained_limit_i : cfg_regions_limit_i);
  logic [7:0] select_3952;
  assign select_3952 = equal_3933 ? cfg_hidden_limit_i : (equal_3934 ? cfg_unproven_skin_limit_i : select_3950);
  // hls/stages/agreement.hpp:789
  logic select_4062;
  assign select_4062 = so_s15_q ? (ends_cell_s15_q ? and_2051_s15_q : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4066;
  assign select_4066 = so_s15_q ? (ends_cell_s15_q ? and_4064_s15_q : centres_values_0_of_skin_q) : centres_values_0_of_skin_q;
  logic select_4068;
  assign select_4068 = ends_cell_s15_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4070;
  assign select_4070 = equal_572_s15_q ? centres_values_1_textured_q : (so_s15_q ? select_4068 : centres_values_1_textured_q);
  logic select_4071;
  assign select_4071 = ends_cell_s15_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4073;
  assign select_4073 = equal_572_s15_q ? centres_values_1_of_skin_q : (so_s15_q ? select_4071 : centres_values_1_of_skin_q);

  // Memory patches_choices, 64 x 23, DISTANCE 24, hls/stages/patches.hpp:763; read in stage 15, written in stage 17: 15 < 17 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1689_s15_q;
  logic patches_choices_re;
  assign patches_choices_re = s15_en & (sample_pair_whole_s15_q & (~equal_1691_s15_q));
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 24, hls/stages/patches.hpp:792; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1888_s15_q, not_1883_s15_q, select_1882_s15_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s15_en & or_1889_s15_q;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 24, hls/stages/patches.hpp:793; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
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
  assign patches_left_codes_re = s15_en & (not_1786_s15_q & (new_row_s15_q & equal_1787_s15_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 24, hls/stages/agreement.hpp:1399; read in stage 15, written in stage 18: 15 < 18 < 15 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1975;
  logic regions_re;
  assign regions_re = s15_en & (equal_572_s15_q ? (x_s15_q[6] & not_1976) : and_1983_s15_q);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_515_s15_q;
  logic averager_memory_we;
  assign averager_memory_we = s15_en & and_522_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_541_s15_q, and_537_s15_q, sum_533_s15_q, sum_529_s15_q};
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

  // Memory moments_memory, write
  logic [12:0] moments_memory_waddr;
  assign moments_memory_waddr = select_571_s15_q;
  logic moments_memory_we;
  assign moments_memory_we = s15_en & and_589_s15_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_644_s15_q, and_642_s15_q, and_637_s15_q, and_635};
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
      averager_mask_q <= select_2177;
      averager_of_skin_q <= select_2179;
      registration_of_right_q <= equal_572_s15_q ? registration_of_right_q : select_2794;
      registration_was_inside_q <= equal_572_s15_q ? registration_was_inside_q : select_2797;
      patches_down_values_0_q <= equal_1785_s15_q ? patches_down_values_0_q : select_3080;
      patches_down_values_1_q <= select_3084;
      shown_shown_q <= select_3852;
      shown_nearer_q <= select_3854;
      region_row_q <= and_547_s15_q ? select_3860 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_fresh_q <= and_547_s15_q ? select_3891 : region_fresh_q;
      segment_starts_q <= equal_572_s15_q ? or_3896 : (so_s15_q ? select_3900 : or_3896);
      centres_values_0_textured_q <= equal_572_s15_q ? centres_values_0_textured_q : select_4062;
      centres_values_0_of_skin_q <= equal_572_s15_q ? centres_values_0_of_skin_q : select_4066;
      centres_values_1_textured_q <= select_4070;
      centres_values_1_of_skin_q <= select_4073;
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
      averager_total_0_q <= select_2154;
      averager_total_1_q <= select_2156;
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
  logic [3:0] select_508_s16_q;
  logic [6:0] select_511_s16_q;
  logic [6:0] column_s16_q;
  logic and_545_s16_q;
  logic and_547_s16_q;
  logic [77:0] census_memory_rdata_s16_q;
  logic [8:0] grey_s16_q;
  logic equal_550_s16_q;
  logic [8:0] select_553_s16_q;
  logic [8:0] grey_2_s16_q;
  logic [8:0] select_557_s16_q;
  logic whole_2_s16_q;
  logic and_565_s16_q;
  logic equal_567_s16_q;
  logic equal_572_s16_q;
  logic not_573_s16_q;
  logic so_s16_q;
  logic not_575_s16_q;
  logic equal_576_s16_q;
  logic inside_v_s16_q;
  logic not_585_s16_q;
  logic [3:0] moments_memory_rdata_s16_q;
  logic [6:0] x_s16_2_q;
  logic [32:0] best_left_rdata_s16_q;
  logic [6:0] right_s16_q;
  logic [14:0] best_right_rdata_s16_q;
  logic and_634_s16_q;
  logic and_637_s16_q;
  logic and_644_s16_q;
  logic equal_677_s16_q;
  logic [7:0] of_best_s16_q;
  logic or_1514_s16_q;
  logic [2:0] select_1519_s16_q;
  logic [7:0] select_1528_s16_q;
  logic [7:0] select_1531_s16_q;
  logic [6:0] select_1550_s16_q;
  logic [5:0] select_1552_s16_q;
  logic [7:0] select_1555_s16_q;
  logic [7:0] select_1558_s16_q;
  logic and_1559_s16_q;
  logic or_1563_s16_q;
  logic [6:0] select_1568_s16_q;
  logic [6:0] select_1569_s16_q;
  logic and_1572_s16_q;
  logic [6:0] select_1576_s16_q;
  logic and_1583_s16_q;
  logic and_1587_s16_q;
  logic and_1598_s16_q;
  logic equal_1605_s16_q;
  logic [1:0] quarter_s16_q;
  logic all_s16_q;
  logic [1:0] sum_1611_s16_q;
  logic [3:0] select_1612_s16_q;
  logic equal_1613_s16_q;
  logic equal_1615_s16_q;
  logic equal_1617_s16_q;
  logic equal_1619_s16_q;
  logic equal_1621_s16_q;
  logic equal_1623_s16_q;
  logic equal_1625_s16_q;
  logic equal_1627_s16_q;
  logic less_1636_s16_q;
  logic or_1640_s16_q;
  logic select_1643_s16_q;
  logic and_1653_s16_q;
  logic [3:0] select_1658_s16_q;
  logic and_1673_s16_q;
  logic select_1690_s16_q;
  logic equal_1691_s16_q;
  logic and_1699_s16_q;
  logic equal_1701_s16_q;
  logic and_1734_s16_q;
  logic [5:0] select_1750_s16_q;
  logic [7:0] select_1776_s16_q;
  logic and_1783_s16_q;
  logic and_1784_s16_q;
  logic equal_1785_s16_q;
  logic equal_1787_s16_q;
  logic equal_1790_s16_q;
  logic or_1791_s16_q;
  logic and_1800_s16_q;
  logic [4:0] select_1815_s16_q;
  logic select_1821_s16_q;
  logic [3:0] select_1860_s16_q;
  logic less_1876_s16_q;
  logic new_row_s16_q;
  logic or_1889_s16_q;
  logic [1:0] of_row_2_s16_q;
  logic [1:0] down_2_s16_q;
  logic [12:0] sum_1902_s16_q;
  logic [11:0] smooth_s16_q;
  logic and_1931_s16_q;
  logic and_1940_s16_q;
  logic and_1945_s16_q;
  logic less_1946_s16_q;
  logic equal_1947_s16_q;
  logic not_1948_s16_q;
  logic equal_1949_s16_q;
  logic [9:0] patches_rows_rdata_s16_q;
  logic or_1968_s16_q;
  logic or_1971_s16_q;
  logic or_1974_s16_q;
  logic not_1976_s16_q;
  logic textured_s16_q;
  logic and_2001_s16_q;
  logic and_2008_s16_q;
  logic [12:0] seen_columns_rdata_s16_q;
  logic shown_s16_q;
  logic near_s16_q;
  logic and_2049_s16_q;
  logic and_2051_s16_q;
  logic or_2066_s16_q;
  logic or_2069_s16_q;
  logic or_2072_s16_q;
  logic and_2083_s16_q;
  logic and_2085_s16_q;
  logic and_2086_s16_q;
  logic and_2099_s16_q;
  logic and_2101_s16_q;
  logic and_2102_s16_q;
  logic and_2122_s16_q;
  logic equal_2262_s16_q;
  logic equal_2451_s16_q;
  logic and_2582_s16_q;
  logic not_2601_s16_q;
  logic and_2602_s16_q;
  logic and_2604_s16_q;
  logic and_2605_s16_q;
  logic and_2644_s16_q;
  logic and_2651_s16_q;
  logic and_2675_s16_q;
  logic select_2685_s16_q;
  logic select_2688_s16_q;
  logic and_2689_s16_q;
  logic and_2736_s16_q;
  logic and_2737_s16_q;
  logic [11:0] residual_s16_q;
  logic equal_2799_s16_q;
  logic [3:0] not_2800_s16_q;
  logic [1:0] quarter_2_s16_q;
  logic and_2975_s16_q;
  logic less_3102_s16_q;
  logic equal_3445_s16_q;
  logic [4:0] select_3533_s16_q;
  logic select_3540_s16_q;
  logic select_3549_s16_q;
  logic and_3555_s16_q;
  logic [14:0] select_3564_s16_q;
  logic equal_3909_s16_q;
  logic equal_3929_s16_q;
  logic equal_3932_s16_q;
  logic equal_3933_s16_q;
  logic equal_3934_s16_q;
  logic [7:0] select_3953_s16_q;
  logic equal_4074_s16_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      select_508_s16_q <= select_508_s15_q;
      select_511_s16_q <= select_511_s15_q;
      column_s16_q <= column_s15_q;
      and_545_s16_q <= and_545_s15_q;
      and_547_s16_q <= and_547_s15_q;
      census_memory_rdata_s16_q <= census_memory_rdata_q;
      grey_s16_q <= grey;
      equal_550_s16_q <= equal_550_s15_q;
      select_553_s16_q <= sample_pair_whole_s15_q ? total[10:2] : 9'h0;
      grey_2_s16_q <= grey_2;
      select_557_s16_q <= sample_pair_whole_s15_q ? total_2[10:2] : 9'h0;
      whole_2_s16_q <= whole_2;
      and_565_s16_q <= sample_pair_whole_s15_q & select_564;
      equal_567_s16_q <= equal_567_s15_q;
      equal_572_s16_q <= equal_572_s15_q;
      not_573_s16_q <= not_573_s15_q;
      so_s16_q <= so_s15_q;
      not_575_s16_q <= not_575_s15_q;
      equal_576_s16_q <= equal_576_s15_q;
      inside_v_s16_q <= inside_v_s15_q;
      not_585_s16_q <= not_585_s15_q;
      moments_memory_rdata_s16_q <= moments_memory_rdata_q;
      x_s16_2_q <= x_s15_2_q;
      best_left_rdata_s16_q <= best_left_rdata_s15_q;
      right_s16_q <= right_s15_q;
      best_right_rdata_s16_q <= best_right_rdata_s15_q[14:0];
      and_634_s16_q <= and_634;
      and_637_s16_q <= and_637_s15_q;
      and_644_s16_q <= and_644_s15_q;
      equal_677_s16_q <= equal_677_s15_q;
      of_best_s16_q <= of_best_s15_q;
      or_1514_s16_q <= select_759_s15_q | (best_left_rdata_s15_q[16:9] < of_best_s15_q);
      select_1519_s16_q <= select_1519_s15_q;
      select_1528_s16_q <= select_1528;
      select_1531_s16_q <= select_1531;
      select_1550_s16_q <= select_759_s15_q ? of_near_s15_q : select_1549_s15_q;
      select_1552_s16_q <= select_759_s15_q ? run_shift_s15_q : select_1551_s15_q;
      select_1555_s16_q <= (run_shift_s15_q == 6'h3f) ? of_best_s15_q : select_1554_s15_q;
      select_1558_s16_q <= (run_shift_s15_q == 6'h1) ? of_best_s15_q : select_1557_s15_q;
      and_1559_s16_q <= and_1559_s15_q;
      or_1563_s16_q <= or_1563;
      select_1568_s16_q <= or_1567_s15_q ? of_near_s15_q : best_right_rdata_s15_q[21:15];
      select_1569_s16_q <= or_1567_s15_q ? x_s15_2_q : best_right_rdata_s15_q[28:22];
      and_1572_s16_q <= and_1572_s15_q;
      select_1576_s16_q <= select_1576_s15_q;
      and_1583_s16_q <= and_1583;
      and_1587_s16_q <= and_1587;
      and_1598_s16_q <= and_1598_s15_q;
      equal_1605_s16_q <= equal_1605_s15_q;
      quarter_s16_q <= quarter;
      all_s16_q <= all_s15_q;
      sum_1611_s16_q <= sum_1611;
      select_1612_s16_q <= select_1612;
      equal_1613_s16_q <= equal_1613;
      equal_1615_s16_q <= equal_1615;
      equal_1617_s16_q <= equal_1617;
      equal_1619_s16_q <= equal_1619_s15_q;
      equal_1621_s16_q <= equal_1621_s15_q;
      equal_1623_s16_q <= equal_1623_s15_q;
      equal_1625_s16_q <= equal_1625_s15_q;
      equal_1627_s16_q <= equal_1627_s15_q;
      less_1636_s16_q <= less_1636;
      or_1640_s16_q <= or_1640;
      select_1643_s16_q <= equal_1605_s15_q ? and_1635 : (less_1636 & (~or_1640));
      and_1653_s16_q <= half_ends & ({{3{sum_1651[4]}}, sum_1651} < 8'h3);
      select_1658_s16_q <= select_1658;
      and_1673_s16_q <= and_1673_s15_q;
      select_1690_s16_q <= select_1690_s15_q;
      equal_1691_s16_q <= equal_1691_s15_q;
      and_1699_s16_q <= and_1699_s15_q;
      equal_1701_s16_q <= equal_1701_s15_q;
      and_1734_s16_q <= (less_1700_s15_q & (and_634 & less_1717)) & and_1733_s15_q;
      select_1750_s16_q <= select_1750_s15_q;
      select_1776_s16_q <= select_1776_s15_q;
      and_1783_s16_q <= and_1783_s15_q;
      and_1784_s16_q <= and_1784_s15_q;
      equal_1785_s16_q <= equal_1785_s15_q;
      equal_1787_s16_q <= equal_1787_s15_q;
      equal_1790_s16_q <= equal_1790_s15_q;
      or_1791_s16_q <= or_1791_s15_q;
      and_1800_s16_q <= and_1800_s15_q;
      select_1815_s16_q <= select_1815_s15_q;
      select_1821_s16_q <= select_1821_s15_q;
      select_1860_s16_q <= select_1860_s15_q;
      less_1876_s16_q <= less_1876_s15_q;
      new_row_s16_q <= new_row_s15_q;
      or_1889_s16_q <= or_1889_s15_q;
      of_row_2_s16_q <= of_row_2_s15_q;
      down_2_s16_q <= down_2_s15_q[1:0];
      sum_1902_s16_q <= sum_1902;
      smooth_s16_q <= smooth;
      and_1931_s16_q <= not_1786_s15_q & (not_1788_s15_q & and_1929_s15_q);
      and_1940_s16_q <= and_1940_s15_q;
      and_1945_s16_q <= not_1786_s15_q & (not_1788_s15_q & and_1943_s15_q);
      less_1946_s16_q <= less_1946_s15_q;
      equal_1947_s16_q <= equal_1947_s15_q;
      not_1948_s16_q <= not_1948_s15_q;
      equal_1949_s16_q <= equal_1949_s15_q;
      patches_rows_rdata_s16_q <= patches_rows_rdata_s15_q;
      or_1968_s16_q <= or_1968_s15_q;
      or_1971_s16_q <= or_1971_s15_q;
      or_1974_s16_q <= or_1974_s15_q;
      not_1976_s16_q <= not_1976;
      textured_s16_q <= textured_s15_q;
      and_2001_s16_q <= and_2001;
      and_2008_s16_q <= not_573_s15_q & and_1983_s15_q;
      seen_columns_rdata_s16_q <= seen_columns_rdata_s15_q;
      shown_s16_q <= shown;
      near_s16_q <= near;
      and_2049_s16_q <= and_2049_s15_q;
      and_2051_s16_q <= and_2051_s15_q;
      or_2066_s16_q <= or_2066_s15_q;
      or_2069_s16_q <= or_2069_s15_q;
      or_2072_s16_q <= or_2072_s15_q;
      and_2083_s16_q <= and_2083_s15_q;
      and_2085_s16_q <= seen_columns_rdata_s15_q[7] & inside_v_s15_q;
      and_2086_s16_q <= seen_columns_rdata_s15_q[3] & inside_v_s15_q;
      and_2099_s16_q <= and_2099_s15_q;
      and_2101_s16_q <= seen_columns_rdata_s15_q[8] & inside_v_s15_q;
      and_2102_s16_q <= seen_columns_rdata_s15_q[4] & inside_v_s15_q;
      and_2122_s16_q <= and_2122_s15_q;
      equal_2262_s16_q <= equal_2262_s15_q;
      equal_2451_s16_q <= equal_2451_s15_q;
      and_2582_s16_q <= and_2582;
      not_2601_s16_q <= not_2601;
      and_2602_s16_q <= and_2602_s15_q;
      and_2604_s16_q <= seen_columns_rdata_s15_q[6] & inside_v_s15_q;
      and_2605_s16_q <= seen_columns_rdata_s15_q[2] & inside_v_s15_q;
      and_2644_s16_q <= not_573_s15_q & and_2643;
      and_2651_s16_q <= not_573_s15_q & (so_s15_q & (ends_cell_s15_q & and_2648));
      and_2675_s16_q <= inside_v_s15_q & (or_577_s15_q & (not_581_s15_q & and_2672));
      select_2685_s16_q <= select_2685[1];
      select_2688_s16_q <= select_2688[1];
      and_2689_s16_q <= select_2685[0] & select_2688[0];
      and_2736_s16_q <= not_573_s15_q & (so_s15_q & (half_ends & equal_2733));
      and_2737_s16_q <= and_634 & less_1700_s15_q;
      residual_s16_q <= residual;
      equal_2799_s16_q <= sum_1611 == 2'h2;
      not_2800_s16_q <= ~select_1658;
      quarter_2_s16_q <= quarter_2;
      and_2975_s16_q <= and_2975_s15_q;
      less_3102_s16_q <= less_3102_s15_q;
      equal_3445_s16_q <= patches_match_row_s15_q == 4'h0;
      select_3533_s16_q <= select_3533_s15_q;
      select_3540_s16_q <= select_3540;
      select_3549_s16_q <= select_3549;
      and_3555_s16_q <= equal_3529_s15_q & ({sum_3553[6], sum_3553} < 8'hfb);
      select_3564_s16_q <= select_3564_s15_q;
      equal_3909_s16_q <= equal_3909_s15_q;
      equal_3929_s16_q <= equal_3929;
      equal_3932_s16_q <= x_s15_q[6:3] == 4'hb;
      equal_3933_s16_q <= equal_3933;
      equal_3934_s16_q <= equal_3934;
      select_3953_s16_q <= equal_3929 ? cfg_regions_limit_i : select_3952;
      equal_4074_s16_q <= equal_4074_s15_q;
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
  logic patches_read_above_q;
  logic patches_read_below_q;
  logic [9:0] patches_peak_above_q;
  logic [9:0] patches_peak_below_q;
  logic segment_started_q;
  // hls/stages/census.hpp:296
  logic less_650;
  assign less_650 = census_memory_rdata_s16_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_memory_rdata_s16_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_662;
  assign less_662 = census_memory_rdata_s16_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_memory_rdata_s16_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:456
  logic equal_674;
  assign equal_674 = column_s16_q == 7'h0;
  logic [3:0] select_678;
  assign select_678 = equal_677_s16_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:457
  logic [4:0] select_679;
  assign select_679 = equal_674 ? {select_678, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_680;
  assign select_680 = equal_674 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:288
  logic and_683;
  assign and_683 = census_memory_rdata_s16_q[38] & (census_memory_rdata_s16_q[18] & whole_2_s16_q);
  logic and_685;
  assign and_685 = census_memory_rdata_s16_q[77] & (census_memory_rdata_s16_q[58] & and_683);
  // hls/stages/census.hpp:272
  logic [9:0] difference_708;
  assign difference_708 = {1'b0, select_553_s16_q} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [9:0] difference_711;
  assign difference_711 = {1'b0, census_memory_rdata_s16_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [9:0] difference_715;
  assign difference_715 = {1'b0, census_memory_rdata_s16_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [9:0] difference_719;
  assign difference_719 = {1'b0, census_memory_rdata_s16_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [9:0] difference_723;
  assign difference_723 = {1'b0, census_memory_rdata_s16_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/agreement.hpp:789
  logic and_1584;
  assign and_1584 = not_575_s16_q & and_1583_s16_q;
  // hls/stages/moments.hpp:73
  logic and_1591;
  assign and_1591 = moments_has_before_q & moments_memory_rdata_s16_q[0];
  // hls/stages/agreement.hpp:1004
  logic and_1595;
  assign and_1595 = not_585_s16_q & (and_1591 & (moments_memory_rdata_s16_q[1] ^ and_637_s16_q));
  // hls/stages/moments.hpp:73
  logic and_1600;
  assign and_1600 = moments_has_before_q & moments_memory_rdata_s16_q[2];
  // hls/stages/agreement.hpp:1004
  logic and_1604;
  assign and_1604 = not_585_s16_q & (and_1600 & (moments_memory_rdata_s16_q[3] ^ and_644_s16_q));
  // hls/stages/agreement.hpp:789
  logic and_1654;
  assign and_1654 = so_s16_q & and_1653_s16_q;
  logic and_1738;
  assign and_1738 = not_573_s16_q & (so_s16_q & (ends_cell_s16_q & (inside_v_s16_q & and_1734_s16_q)));
  logic [7:0] select_1744;
  assign select_1744 = so_s16_q ? (ends_cell_s16_q ? (inside_v_s16_q ? x_s16_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:467
  logic [13:0] sum_1903;
  assign sum_1903 = {{3{patches_down_values_1_s16_q[10]}}, patches_down_values_1_s16_q} + {sum_1902_s16_q, down_2_s16_q[1]};
  logic [12:0] sum_1904;
  assign sum_1904 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1903[13:1];
  // hls/stages/patches.hpp:466
  logic [12:0] sum_1913;
  assign sum_1913 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth_s16_q[11:1]};
  logic [12:0] sum_1914;
  assign sum_1914 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1915;
  assign difference_1915 = {1'b0, sum_1913, smooth_s16_q[0]} - {1'b0, sum_1914, patches_smooth_values_3_q[0]};
  // hls/stages/agreement.hpp:262
  logic explained;
  assign explained = inside_v_s16_q & and_634_s16_q;
  logic and_2010;
  assign and_2010 = inside_v_s16_q & and_2001_s16_q;
  // hls/stages/agreement.hpp:1031
  logic and_2052;
  assign and_2052 = seen_columns_rdata_s16_q[0] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2054;
  assign sum_2054 = {1'b0, and_2051_s16_q} + ({1'b0, textured_s16_q} + {1'b0, and_2052});
  // hls/stages/agreement.hpp:1031
  logic and_2084;
  assign and_2084 = seen_columns_rdata_s16_q[11] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2088;
  assign sum_2088 = {1'b0, and_2085_s16_q} + ({1'b0, shown_s16_q} + {1'b0, and_2086_s16_q});
  // hls/stages/agreement.hpp:1031
  logic and_2100;
  assign and_2100 = seen_columns_rdata_s16_q[12] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1091
  logic [1:0] sum_2104;
  assign sum_2104 = {1'b0, and_2101_s16_q} + ({1'b0, near_s16_q} + {1'b0, and_2102_s16_q});
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2146;
  assign select_2146 = sample_pair_whole_s16_q ? (and_545_s16_q ? grey_s16_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2148;
  assign select_2148 = sample_pair_whole_s16_q ? (and_545_s16_q ? grey_2_s16_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2150;
  assign select_2150 = sample_pair_whole_s16_q ? (and_545_s16_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2152;
  assign select_2152 = sample_pair_whole_s16_q ? (and_545_s16_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2157;
  assign sum_2157 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s16_q};
  logic [9:0] sum_2165;
  assign sum_2165 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s16_q};
  // hls/stages/agreement.hpp:521
  logic [8:0] select_2180;
  assign select_2180 = and_547_s16_q ? select_553_s16_q : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2181;
  assign select_2181 = and_547_s16_q ? select_557_s16_q : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2183;
  assign select_2183 = and_547_s16_q ? census_memory_rdata_s16_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2184;
  assign select_2184 = and_547_s16_q ? census_memory_rdata_s16_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2185;
  assign select_2185 = and_547_s16_q ? census_memory_rdata_s16_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2186;
  assign select_2186 = and_547_s16_q ? census_memory_rdata_s16_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2187;
  assign select_2187 = and_547_s16_q ? census_memory_rdata_s16_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2188;
  assign select_2188 = and_547_s16_q ? census_memory_rdata_s16_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2189;
  assign select_2189 = and_547_s16_q ? census_memory_rdata_s16_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2190;
  assign select_2190 = and_547_s16_q ? census_memory_rdata_s16_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2191;
  assign select_2191 = and_547_s16_q ? census_memory_rdata_s16_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2192;
  assign select_2192 = and_547_s16_q ? census_memory_rdata_s16_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2193;
  assign select_2193 = and_547_s16_q ? census_memory_rdata_s16_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2194;
  assign select_2194 = and_547_s16_q ? census_memory_rdata_s16_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2195;
  assign select_2195 = and_547_s16_q ? census_memory_rdata_s16_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2196;
  assign select_2196 = and_547_s16_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2197;
  assign select_2197 = and_547_s16_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic [8:0] select_2199;
  assign select_2199 = and_547_s16_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2200;
  assign select_2200 = and_547_s16_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic [8:0] select_2202;
  assign select_2202 = and_547_s16_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2203;
  assign select_2203 = and_547_s16_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2205;
  assign select_2205 = and_547_s16_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2206;
  assign select_2206 = and_547_s16_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2207;
  assign select_2207 = and_547_s16_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic [8:0] select_2209;
  assign select_2209 = and_547_s16_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2210;
  assign select_2210 = and_547_s16_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic [8:0] select_2212;
  assign select_2212 = and_547_s16_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2213;
  assign select_2213 = and_547_s16_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic [8:0] select_2215;
  assign select_2215 = and_547_s16_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2216;
  assign select_2216 = and_547_s16_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic [8:0] select_2218;
  assign select_2218 = and_547_s16_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2219;
  assign select_2219 = and_547_s16_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic [8:0] select_2221;
  assign select_2221 = and_547_s16_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2222;
  assign select_2222 = and_547_s16_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic [8:0] select_2224;
  assign select_2224 = and_547_s16_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_547_s16_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic [8:0] select_2228;
  assign select_2228 = and_547_s16_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2229;
  assign select_2229 = and_547_s16_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic [8:0] select_2232;
  assign select_2232 = and_547_s16_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2233;
  assign select_2233 = and_547_s16_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2237;
  assign difference_2237 = {1'b0, select_557_s16_q} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [9:0] difference_2240;
  assign difference_2240 = {1'b0, census_memory_rdata_s16_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [9:0] difference_2244;
  assign difference_2244 = {1'b0, census_memory_rdata_s16_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [9:0] difference_2248;
  assign difference_2248 = {1'b0, census_memory_rdata_s16_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [9:0] difference_2252;
  assign difference_2252 = {1'b0, census_memory_rdata_s16_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  // hls/stages/agreement.hpp:1143
  logic equal_2277;
  assign equal_2277 = x_s16_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:789
  logic select_2283;
  assign select_2283 = equal_572_s16_q ? (moments_has_before_q | equal_2277) : moments_has_before_q;
  // hls/stages/census.hpp:359
  logic [9:0] difference_2348;
  assign difference_2348 = {1'b0, select_553_s16_q} - {1'b0, sharpness_last_mean_0_q};
  logic [9:0] difference_2360;
  assign difference_2360 = {1'b0, select_557_s16_q} - {1'b0, sharpness_last_mean_1_q};
  // hls/stages/agreement.hpp:521
  logic and_2576;
  assign and_2576 = and_547_s16_q & (equal_677_s16_q & equal_2451_s16_q);
  // hls/stages/agreement.hpp:789
  logic and_2587;
  assign and_2587 = not_573_s16_q & (so_s16_q & (ends_cell_s16_q & textured_s16_q));
  // hls/stages/agreement.hpp:1031
  logic and_2603;
  assign and_2603 = seen_columns_rdata_s16_q[10] & inside_v_s16_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2607;
  assign sum_2607 = {1'b0, and_2604_s16_q} + ({1'b0, explained} + {1'b0, and_2605_s16_q});
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2646;
  assign select_2646 = and_2576 ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2644_s16_q});
  logic [13:0] select_2653;
  assign select_2653 = and_2576 ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2651_s16_q});
  // hls/stages/agreement.hpp:1028
  logic and_2690;
  assign and_2690 = and_634_s16_q & and_2689_s16_q;
  // hls/stages/agreement.hpp:789
  logic and_2693;
  assign and_2693 = ends_cell_s16_q & (inside_v_s16_q & (select_2685_s16_q & and_2690));
  logic and_2700;
  assign and_2700 = ends_cell_s16_q & (inside_v_s16_q & (select_2688_s16_q & and_2690));
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2771;
  assign difference_2771 = 13'h0 - {residual_s16_q[11], residual_s16_q};
  logic less_2786;
  assign less_2786 = $signed(difference_2771) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:269
  logic [3:0] select_2802;
  assign select_2802 = equal_2799_s16_q ? (registration_fresh_q & not_2800_s16_q) : registration_fresh_q;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_2804;
  assign select_2804 = so_s16_q ? (and_1653_s16_q ? select_2802 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2806;
  assign select_2806 = and_2576 ? 4'hf : (equal_572_s16_q ? registration_fresh_q : select_2804);
  // hls/stages/registration.hpp:258
  logic not_2827;
  assign not_2827 = ~quarter_2_s16_q[1];
  logic [3:0] select_2828;
  assign select_2828 = quarter_2_s16_q[0] ? {quarter_2_s16_q[1], 1'b0, not_2827, 1'b0} : {1'b0, quarter_2_s16_q[1], 1'b0, not_2827};
  // hls/stages/patches.hpp:184
  logic [11:0] select_3068;
  assign select_3068 = equal_1787_s16_q ? patches_smooth_values_0_q : (or_1791_s16_q ? smooth_s16_q : patches_smooth_values_0_q);
  logic [11:0] select_3070;
  assign select_3070 = or_1791_s16_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3072;
  assign select_3072 = equal_1785_s16_q ? patches_smooth_values_1_q : (equal_1787_s16_q ? patches_smooth_values_1_q : select_3070);
  logic [11:0] select_3073;
  assign select_3073 = or_1791_s16_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3075;
  assign select_3075 = equal_1785_s16_q ? patches_smooth_values_2_q : (equal_1787_s16_q ? patches_smooth_values_2_q : select_3073);
  logic [11:0] select_3076;
  assign select_3076 = or_1791_s16_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3078;
  assign select_3078 = equal_1785_s16_q ? patches_smooth_values_3_q : (equal_1787_s16_q ? patches_smooth_values_3_q : select_3076);
  logic [10:0] select_3085;
  assign select_3085 = or_1791_s16_q ? patches_down_values_1_s16_q : patches_down_values_2_q;
  logic [10:0] select_3087;
  assign select_3087 = equal_1785_s16_q ? patches_down_values_2_q : (equal_1787_s16_q ? patches_down_values_2_q : select_3085);
  logic [10:0] select_3088;
  assign select_3088 = or_1791_s16_q ? patches_down_values_2_q : patches_down_values_3_q;
  logic [10:0] select_3090;
  assign select_3090 = equal_1785_s16_q ? patches_down_values_3_q : (equal_1787_s16_q ? patches_down_values_3_q : select_3088);
  // hls/stages/patches.hpp:556
  logic select_3542;
  assign select_3542 = less_1946_s16_q ? (not_1948_s16_q & select_3540_s16_q) : select_3540_s16_q;
  logic select_3551;
  assign select_3551 = less_1946_s16_q ? (not_1948_s16_q & select_3549_s16_q) : select_3549_s16_q;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3557;
  assign select_3557 = less_1946_s16_q ? (and_3555_s16_q ? patches_rows_rdata_s16_q : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3568;
  assign select_3568 = patches_read_above_q ? patches_read_row_differing_s16_q : patches_peak_above_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3570;
  assign select_3570 = patches_read_below_q ? patches_read_row_differing_s16_q : patches_peak_below_q;
  // hls/stages/patches.hpp:575
  logic less_3607;
  assign less_3607 = select_3568 < select_3570;
  // hls/stages/patches.hpp:576
  logic [9:0] high;
  assign high = less_3607 ? select_3570 : select_3568;
  logic [9:0] low;
  assign low = (select_3570 < select_3568) ? select_3570 : select_3568;
  // hls/stages/agreement.hpp:1224
  logic equal_3685;
  assign equal_3685 = x_s16_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1218
  logic equal_3931;
  assign equal_3931 = x_s16_q[6:3] == 4'hc;
  // hls/stages/agreement.hpp:1126
  logic [7:0] select_3954;
  assign select_3954 = equal_3932_s16_q ? {cfg_on_skin_limit_i, 3'h0} : select_3953_s16_q;
  logic [7:0] limit;
  assign limit = equal_3931 ? cfg_regions_limit_i : select_3954;
  // hls/stages/agreement.hpp:1232
  logic not_3956;
  assign not_3956 = ~x_s16_q[2];
  logic [3:0] select_3957;
  assign select_3957 = x_s16_q[1] ? {x_s16_q[2], 1'b0, not_3956, 1'b0} : {1'b0, x_s16_q[2], 1'b0, not_3956};
  logic [7:0] select_3958;
  assign select_3958 = x_s16_q[0] ? {select_3957[3], 1'b0, select_3957[2], 1'b0, select_3957[1], 1'b0, select_3957[0], 1'b0} : {1'b0, select_3957[3], 1'b0, select_3957[2], 1'b0, select_3957[1], 1'b0, select_3957[0]};
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_3962;
  assign select_3962 = equal_3933_s16_q ? counts_skin_supervised_q : (equal_3934_s16_q ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3964;
  assign select_3964 = equal_3932_s16_q ? counts_skin_textured_q : (equal_3929_s16_q ? counts_textured_q : select_3962);
  logic [13:0] of;
  assign of = equal_3931 ? counts_textured_q : select_3964;
  // hls/stages/registration.hpp:258
  logic not_4167;
  assign not_4167 = ~quarter_s16_q[1];
  logic [3:0] select_4168;
  assign select_4168 = quarter_s16_q[0] ? {quarter_s16_q[1], 1'b0, not_4167, 1'b0} : {1'b0, quarter_s16_q[1], 1'b0, not_4167};

  // Memory registration_sums, 12 x 32, DISTANCE 24, hls/stages/registration.hpp:277; read in stage 16, written in stage 20: 16 < 20 < 16 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1612_s16_q;
  logic registration_sums_re;
  assign registration_sums_re = s16_en & (equal_572_s16_q ? (x_s16_q[6] & select_1643_s16_q) : and_1654);
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s16_q;
  logic census_memory_we;
  assign census_memory_we = s16_en & and_547_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_s16_q[58:40], census_memory_rdata_s16_q[38:0], and_565_s16_q, whole_2_s16_q, select_557_s16_q, select_553_s16_q};
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
  assign shown_right_waddr = select_1576_s16_q;
  logic shown_right_we;
  assign shown_right_we = s16_en & and_1587_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1584, not_575_s16_q};
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
  assign seen_columns_we = s16_en & and_1572_s16_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_s16_q, near_s16_q, shown_s16_q, explained, and_2010, textured_s16_q};
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
      census_filled_q <= and_547_s16_q ? {select_680[2:0], 1'b1} : census_filled_q;
      moments_has_before_q <= select_2283;
      rows_passed_above_q <= and_547_s16_q ? select_679 : rows_passed_above_q;
      counts_textured_q <= and_2576 ? 14'h0 : (counts_textured_q + {13'h0, and_2587});
      counts_skin_supervised_q <= select_2646;
      counts_skin_textured_q <= select_2653;
      registration_fresh_q <= select_2806;
      patches_smooth_values_0_q <= equal_1785_s16_q ? patches_smooth_values_0_q : select_3068;
      patches_smooth_values_1_q <= select_3072;
      patches_smooth_values_2_q <= select_3075;
      patches_smooth_values_3_q <= select_3078;
      patches_down_values_2_q <= select_3087;
      patches_down_values_3_q <= select_3090;
      patches_read_above_q <= equal_1785_s16_q ? select_3542 : patches_read_above_q;
      patches_read_below_q <= equal_1785_s16_q ? select_3551 : patches_read_below_q;
      patches_peak_above_q <= equal_1785_s16_q ? select_3568 : patches_peak_above_q;
      patches_peak_below_q <= equal_1785_s16_q ? select_3570 : patches_peak_below_q;
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
    if (s16_en) begin
      averager_quarter_1_0_q <= select_2146;
      averager_quarter_1_1_q <= select_2148;
      averager_quarter_2_0_q <= select_2150;
      averager_quarter_2_1_q <= select_2152;
      census_columns_values_0_cell_0_left_q <= select_2180;
      census_columns_values_0_cell_0_right_q <= select_2181;
      census_columns_values_0_cell_1_left_q <= select_2183;
      census_columns_values_0_cell_1_right_q <= select_2184;
      census_columns_values_0_cell_1_mask_q <= select_2185;
      census_columns_values_0_cell_2_left_q <= select_2186;
      census_columns_values_0_cell_2_right_q <= select_2187;
      census_columns_values_0_cell_2_mask_q <= select_2188;
      census_columns_values_0_cell_2_of_skin_q <= select_2189;
      census_columns_values_0_cell_3_left_q <= select_2190;
      census_columns_values_0_cell_3_right_q <= select_2191;
      census_columns_values_0_cell_3_mask_q <= select_2192;
      census_columns_values_0_cell_4_left_q <= select_2193;
      census_columns_values_0_cell_4_right_q <= select_2194;
      census_columns_values_0_cell_4_mask_q <= select_2195;
      census_columns_values_1_cell_0_left_q <= select_2196;
      census_columns_values_1_cell_0_right_q <= select_2197;
      census_columns_values_1_cell_1_left_q <= select_2199;
      census_columns_values_1_cell_1_right_q <= select_2200;
      census_columns_values_1_cell_2_left_q <= select_2202;
      census_columns_values_1_cell_2_right_q <= select_2203;
      census_columns_values_1_cell_2_of_skin_q <= select_2205;
      census_columns_values_1_cell_3_left_q <= select_2206;
      census_columns_values_1_cell_3_right_q <= select_2207;
      census_columns_values_1_cell_4_left_q <= select_2209;
      census_columns_values_1_cell_4_right_q <= select_2210;
      census_columns_values_2_cell_0_left_q <= select_2212;
      census_columns_values_2_cell_0_right_q <= select_2213;
      census_columns_values_2_cell_1_left_q <= select_2215;
      census_columns_values_2_cell_1_right_q <= select_2216;
      census_columns_values_2_cell_2_left_q <= select_2218;
      census_columns_values_2_cell_2_right_q <= select_2219;
      census_columns_values_2_cell_3_left_q <= select_2221;
      census_columns_values_2_cell_3_right_q <= select_2222;
      census_columns_values_2_cell_4_left_q <= select_2224;
      census_columns_values_2_cell_4_right_q <= select_2225;
      census_columns_values_3_cell_1_left_q <= select_2228;
      census_columns_values_3_cell_1_right_q <= select_2229;
      census_columns_values_3_cell_3_left_q <= select_2232;
      census_columns_values_3_cell_3_right_q <= select_2233;
      sharpness_last_mean_0_q <= and_547_s16_q ? select_553_s16_q : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_547_s16_q ? select_557_s16_q : sharpness_last_mean_1_q;
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
  logic census_columns_values_0_cell_2_mask_s17_q;
  logic census_columns_values_0_cell_3_mask_s17_q;
  logic census_columns_values_0_cell_4_mask_s17_q;
  logic census_columns_values_1_cell_2_of_skin_s17_q;
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
  logic [3:0] select_508_s17_q;
  logic [6:0] select_511_s17_q;
  logic [6:0] column_s17_q;
  logic and_545_s17_q;
  logic and_547_s17_q;
  logic equal_550_s17_q;
  logic whole_2_s17_q;
  logic equal_567_s17_q;
  logic equal_572_s17_q;
  logic not_573_s17_q;
  logic so_s17_q;
  logic not_575_s17_q;
  logic equal_576_s17_q;
  logic inside_v_s17_q;
  logic [6:0] x_s17_2_q;
  logic [6:0] right_s17_q;
  logic less_650_s17_q;
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
  logic and_681_s17_q;
  logic and_685_s17_q;
  logic difference_708_s17_q;
  logic [8:0] xor_709_s17_q;
  logic difference_711_s17_q;
  logic [8:0] xor_712_s17_q;
  logic difference_715_s17_q;
  logic [8:0] xor_716_s17_q;
  logic difference_719_s17_q;
  logic [8:0] xor_720_s17_q;
  logic difference_723_s17_q;
  logic [8:0] xor_724_s17_q;
  logic [9:0] half_grey_levels_s17_q;
  logic [9:0] half_grey_levels_2_s17_q;
  logic [5:0] select_1515_s17_q;
  logic [2:0] select_1520_s17_q;
  logic [7:0] select_1521_s17_q;
  logic [7:0] select_1529_s17_q;
  logic [7:0] select_1532_s17_q;
  logic [6:0] select_1550_s17_q;
  logic [5:0] select_1552_s17_q;
  logic [7:0] select_1555_s17_q;
  logic [7:0] select_1558_s17_q;
  logic and_1559_s17_q;
  logic [7:0] select_1564_s17_q;
  logic [6:0] select_1565_s17_q;
  logic [6:0] select_1568_s17_q;
  logic [6:0] select_1569_s17_q;
  logic and_1592_s17_q;
  logic and_1595_s17_q;
  logic and_1598_s17_q;
  logic and_1601_s17_q;
  logic and_1604_s17_q;
  logic equal_1605_s17_q;
  logic all_s17_q;
  logic [1:0] sum_1611_s17_q;
  logic equal_1613_s17_q;
  logic equal_1615_s17_q;
  logic equal_1617_s17_q;
  logic equal_1619_s17_q;
  logic equal_1621_s17_q;
  logic equal_1623_s17_q;
  logic equal_1625_s17_q;
  logic equal_1627_s17_q;
  logic less_1636_s17_q;
  logic or_1640_s17_q;
  logic equal_1660_s17_q;
  logic and_1670_s17_q;
  logic and_1673_s17_q;
  logic select_1690_s17_q;
  logic equal_1691_s17_q;
  logic [22:0] patches_choices_rdata_s17_q;
  logic and_1699_s17_q;
  logic equal_1701_s17_q;
  logic and_1738_s17_q;
  logic [7:0] select_1745_s17_q;
  logic [5:0] select_1750_s17_q;
  logic [7:0] select_1776_s17_q;
  logic and_1783_s17_q;
  logic and_1784_s17_q;
  logic equal_1785_s17_q;
  logic equal_1787_s17_q;
  logic equal_1790_s17_q;
  logic or_1791_s17_q;
  logic and_1800_s17_q;
  logic [4:0] select_1815_s17_q;
  logic select_1821_s17_q;
  logic [3:0] select_1860_s17_q;
  logic less_1876_s17_q;
  logic new_row_s17_q;
  logic or_1889_s17_q;
  logic [27:0] patches_right_codes_rdata_s17_q;
  logic [1:0] of_row_2_s17_q;
  logic down_2_s17_q;
  logic sum_1903_s17_q;
  logic [12:0] sum_1904_s17_q;
  logic [14:0] difference_1915_s17_q;
  logic and_1931_s17_q;
  logic [47:0] patches_left_codes_rdata_s17_q;
  logic and_1940_s17_q;
  logic and_1945_s17_q;
  logic less_1946_s17_q;
  logic equal_1947_s17_q;
  logic not_1948_s17_q;
  logic equal_1949_s17_q;
  logic or_1968_s17_q;
  logic or_1971_s17_q;
  logic or_1974_s17_q;
  logic not_1976_s17_q;
  logic [29:0] regions_rdata_s17_q;
  logic textured_s17_q;
  logic explained_s17_q;
  logic and_2003_s17_q;
  logic and_2008_s17_q;
  logic and_2049_s17_q;
  logic and_2050_s17_q;
  logic [1:0] sum_2054_s17_q;
  logic or_2066_s17_q;
  logic or_2069_s17_q;
  logic or_2072_s17_q;
  logic and_2083_s17_q;
  logic [2:0] sum_2089_s17_q;
  logic and_2099_s17_q;
  logic [2:0] sum_2105_s17_q;
  logic and_2122_s17_q;
  logic sum_2157_s17_q;
  logic [9:0] difference_2158_s17_q;
  logic sum_2165_s17_q;
  logic [9:0] difference_2166_s17_q;
  logic difference_2237_s17_q;
  logic [8:0] xor_2238_s17_q;
  logic difference_2240_s17_q;
  logic [8:0] xor_2241_s17_q;
  logic difference_2244_s17_q;
  logic [8:0] xor_2245_s17_q;
  logic difference_2248_s17_q;
  logic [8:0] xor_2249_s17_q;
  logic difference_2252_s17_q;
  logic [8:0] xor_2253_s17_q;
  logic equal_2262_s17_q;
  logic equal_2277_s17_q;
  logic difference_2348_s17_q;
  logic [8:0] xor_2349_s17_q;
  logic difference_2360_s17_q;
  logic [8:0] xor_2361_s17_q;
  logic equal_2451_s17_q;
  logic and_2576_s17_q;
  logic and_2582_s17_q;
  logic and_2587_s17_q;
  logic not_2601_s17_q;
  logic and_2602_s17_q;
  logic [2:0] sum_2608_s17_q;
  logic and_2678_s17_q;
  logic and_2695_s17_q;
  logic and_2702_s17_q;
  logic and_2736_s17_q;
  logic and_2737_s17_q;
  logic [7:0] residual_s17_q;
  logic less_2772_s17_q;
  logic less_2786_s17_q;
  logic equal_2830_s17_q;
  logic and_2975_s17_q;
  logic less_3102_s17_q;
  logic equal_3445_s17_q;
  logic [4:0] select_3533_s17_q;
  logic [9:0] select_3557_s17_q;
  logic [14:0] select_3564_s17_q;
  logic less_3607_s17_q;
  logic [9:0] high_s17_q;
  logic [9:0] low_s17_q;
  logic equal_3685_s17_q;
  logic and_3910_s17_q;
  logic equal_3929_s17_q;
  logic equal_3931_s17_q;
  logic equal_3932_s17_q;
  logic equal_3933_s17_q;
  logic equal_3934_s17_q;
  logic equal_3960_s17_q;
  logic [13:0] of_s17_q;
  logic equal_4074_s17_q;
  logic equal_4170_s17_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      census_columns_values_0_cell_2_mask_s17_q <= census_columns_values_0_cell_2_mask_q;
      census_columns_values_0_cell_3_mask_s17_q <= census_columns_values_0_cell_3_mask_q;
      census_columns_values_0_cell_4_mask_s17_q <= census_columns_values_0_cell_4_mask_q;
      census_columns_values_1_cell_2_of_skin_s17_q <= census_columns_values_1_cell_2_of_skin_q;
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
      select_508_s17_q <= select_508_s16_q;
      select_511_s17_q <= select_511_s16_q;
      column_s17_q <= column_s16_q;
      and_545_s17_q <= and_545_s16_q;
      and_547_s17_q <= and_547_s16_q;
      equal_550_s17_q <= equal_550_s16_q;
      whole_2_s17_q <= whole_2_s16_q;
      equal_567_s17_q <= equal_567_s16_q;
      equal_572_s17_q <= equal_572_s16_q;
      not_573_s17_q <= not_573_s16_q;
      so_s17_q <= so_s16_q;
      not_575_s17_q <= not_575_s16_q;
      equal_576_s17_q <= equal_576_s16_q;
      inside_v_s17_q <= inside_v_s16_q;
      x_s17_2_q <= x_s16_2_q;
      right_s17_q <= right_s16_q;
      less_650_s17_q <= less_650;
      less_651_s17_q <= less_651;
      less_652_s17_q <= less_652;
      less_653_s17_q <= less_653;
      less_654_s17_q <= less_654;
      less_655_s17_q <= less_655;
      less_656_s17_q <= less_656;
      less_657_s17_q <= less_657;
      less_658_s17_q <= less_658;
      less_659_s17_q <= less_659;
      less_660_s17_q <= less_660;
      less_661_s17_q <= less_661;
      less_662_s17_q <= less_662;
      less_663_s17_q <= less_663;
      less_664_s17_q <= less_664;
      less_665_s17_q <= less_665;
      less_666_s17_q <= less_666;
      less_667_s17_q <= less_667;
      less_668_s17_q <= less_668;
      less_669_s17_q <= less_669;
      less_670_s17_q <= less_670;
      less_671_s17_q <= less_671;
      less_672_s17_q <= less_672;
      less_673_s17_q <= less_673;
      and_681_s17_q <= select_679[4] & select_680[3];
      and_685_s17_q <= and_685;
      difference_708_s17_q <= difference_708[9];
      xor_709_s17_q <= difference_708[8:0] ^ {9{difference_708[9]}};
      difference_711_s17_q <= difference_711[9];
      xor_712_s17_q <= difference_711[8:0] ^ {9{difference_711[9]}};
      difference_715_s17_q <= difference_715[9];
      xor_716_s17_q <= difference_715[8:0] ^ {9{difference_715[9]}};
      difference_719_s17_q <= difference_719[9];
      xor_720_s17_q <= difference_719[8:0] ^ {9{difference_719[9]}};
      difference_723_s17_q <= difference_723[9];
      xor_724_s17_q <= difference_723[8:0] ^ {9{difference_723[9]}};
      half_grey_levels_s17_q <= half_grey_levels;
      half_grey_levels_2_s17_q <= half_grey_levels_2;
      select_1515_s17_q <= or_1514_s16_q ? run_shift_s16_q : best_left_rdata_s16_q[5:0];
      select_1520_s17_q <= or_1514_s16_q ? select_1519_s16_q : best_left_rdata_s16_q[8:6];
      select_1521_s17_q <= or_1514_s16_q ? of_best_s16_q : best_left_rdata_s16_q[16:9];
      select_1529_s17_q <= or_1514_s16_q ? select_1528_s16_q : best_left_rdata_s16_q[24:17];
      select_1532_s17_q <= or_1514_s16_q ? select_1531_s16_q : best_left_rdata_s16_q[32:25];
      select_1550_s17_q <= select_1550_s16_q;
      select_1552_s17_q <= select_1552_s16_q;
      select_1555_s17_q <= select_1555_s16_q;
      select_1558_s17_q <= select_1558_s16_q;
      and_1559_s17_q <= and_1559_s16_q;
      select_1564_s17_q <= or_1563_s16_q ? of_best_s16_q : best_right_rdata_s16_q[7:0];
      select_1565_s17_q <= or_1563_s16_q ? x_s16_2_q : best_right_rdata_s16_q[14:8];
      select_1568_s17_q <= select_1568_s16_q;
      select_1569_s17_q <= select_1569_s16_q;
      and_1592_s17_q <= not_585_s16_q & and_1591;
      and_1595_s17_q <= and_1595;
      and_1598_s17_q <= and_1598_s16_q;
      and_1601_s17_q <= not_585_s16_q & and_1600;
      and_1604_s17_q <= and_1604;
      equal_1605_s17_q <= equal_1605_s16_q;
      all_s17_q <= all_s16_q;
      sum_1611_s17_q <= sum_1611_s16_q;
      equal_1613_s17_q <= equal_1613_s16_q;
      equal_1615_s17_q <= equal_1615_s16_q;
      equal_1617_s17_q <= equal_1617_s16_q;
      equal_1619_s17_q <= equal_1619_s16_q;
      equal_1621_s17_q <= equal_1621_s16_q;
      equal_1623_s17_q <= equal_1623_s16_q;
      equal_1625_s17_q <= equal_1625_s16_q;
      equal_1627_s17_q <= equal_1627_s16_q;
      less_1636_s17_q <= less_1636_s16_q;
      or_1640_s17_q <= or_1640_s16_q;
      equal_1660_s17_q <= (registration_fresh_q & select_1658_s16_q) == 4'h0;
      and_1670_s17_q <= not_573_s16_q & and_1654;
      and_1673_s17_q <= and_1673_s16_q;
      select_1690_s17_q <= select_1690_s16_q;
      equal_1691_s17_q <= equal_1691_s16_q;
      patches_choices_rdata_s17_q <= patches_choices_rdata_q;
      and_1699_s17_q <= and_1699_s16_q;
      equal_1701_s17_q <= equal_1701_s16_q;
      and_1738_s17_q <= and_1738;
      select_1745_s17_q <= equal_572_s16_q ? 8'h0 : select_1744;
      select_1750_s17_q <= select_1750_s16_q;
      select_1776_s17_q <= select_1776_s16_q;
      and_1783_s17_q <= and_1783_s16_q;
      and_1784_s17_q <= and_1784_s16_q;
      equal_1785_s17_q <= equal_1785_s16_q;
      equal_1787_s17_q <= equal_1787_s16_q;
      equal_1790_s17_q <= equal_1790_s16_q;
      or_1791_s17_q <= or_1791_s16_q;
      and_1800_s17_q <= and_1800_s16_q;
      select_1815_s17_q <= select_1815_s16_q;
      select_1821_s17_q <= select_1821_s16_q;
      select_1860_s17_q <= select_1860_s16_q;
      less_1876_s17_q <= less_1876_s16_q;
      new_row_s17_q <= new_row_s16_q;
      or_1889_s17_q <= or_1889_s16_q;
      patches_right_codes_rdata_s17_q <= patches_right_codes_rdata_q;
      of_row_2_s17_q <= of_row_2_s16_q;
      down_2_s17_q <= down_2_s16_q[0];
      sum_1903_s17_q <= sum_1903[0];
      sum_1904_s17_q <= sum_1904;
      difference_1915_s17_q <= difference_1915;
      and_1931_s17_q <= and_1931_s16_q;
      patches_left_codes_rdata_s17_q <= patches_left_codes_rdata_q;
      and_1940_s17_q <= and_1940_s16_q;
      and_1945_s17_q <= and_1945_s16_q;
      less_1946_s17_q <= less_1946_s16_q;
      equal_1947_s17_q <= equal_1947_s16_q;
      not_1948_s17_q <= not_1948_s16_q;
      equal_1949_s17_q <= equal_1949_s16_q;
      or_1968_s17_q <= or_1968_s16_q;
      or_1971_s17_q <= or_1971_s16_q;
      or_1974_s17_q <= or_1974_s16_q;
      not_1976_s17_q <= not_1976_s16_q;
      regions_rdata_s17_q <= regions_rdata_q;
      textured_s17_q <= textured_s16_q;
      explained_s17_q <= explained;
      and_2003_s17_q <= inside_v_s16_q & (and_2001_s16_q & and_1583_s16_q);
      and_2008_s17_q <= and_2008_s16_q;
      and_2049_s17_q <= and_2049_s16_q;
      and_2050_s17_q <= seen_columns_rdata_s16_q[9] & inside_v_s16_q;
      sum_2054_s17_q <= sum_2054;
      or_2066_s17_q <= or_2066_s16_q;
      or_2069_s17_q <= or_2069_s16_q;
      or_2072_s17_q <= or_2072_s16_q;
      and_2083_s17_q <= and_2083_s16_q;
      sum_2089_s17_q <= {2'h0, and_2084} + {1'b0, sum_2088};
      and_2099_s17_q <= and_2099_s16_q;
      sum_2105_s17_q <= {2'h0, and_2100} + {1'b0, sum_2104};
      and_2122_s17_q <= and_2122_s16_q;
      sum_2157_s17_q <= sum_2157[0];
      difference_2158_s17_q <= {1'b0, sum_2157[9:1]} - {1'b0, averager_quarter_1_0_q};
      sum_2165_s17_q <= sum_2165[0];
      difference_2166_s17_q <= {1'b0, sum_2165[9:1]} - {1'b0, averager_quarter_1_1_q};
      difference_2237_s17_q <= difference_2237[9];
      xor_2238_s17_q <= difference_2237[8:0] ^ {9{difference_2237[9]}};
      difference_2240_s17_q <= difference_2240[9];
      xor_2241_s17_q <= difference_2240[8:0] ^ {9{difference_2240[9]}};
      difference_2244_s17_q <= difference_2244[9];
      xor_2245_s17_q <= difference_2244[8:0] ^ {9{difference_2244[9]}};
      difference_2248_s17_q <= difference_2248[9];
      xor_2249_s17_q <= difference_2248[8:0] ^ {9{difference_2248[9]}};
      difference_2252_s17_q <= difference_2252[9];
      xor_2253_s17_q <= difference_2252[8:0] ^ {9{difference_2252[9]}};
      equal_2262_s17_q <= equal_2262_s16_q;
      equal_2277_s17_q <= equal_2277;
      difference_2348_s17_q <= difference_2348[9];
      xor_2349_s17_q <= difference_2348[8:0] ^ {9{difference_2348[9]}};
      difference_2360_s17_q <= difference_2360[9];
      xor_2361_s17_q <= difference_2360[8:0] ^ {9{difference_2360[9]}};
      equal_2451_s17_q <= equal_2451_s16_q;
      and_2576_s17_q <= and_2576;
      and_2582_s17_q <= and_2582_s16_q;
      and_2587_s17_q <= and_2587;
      not_2601_s17_q <= not_2601_s16_q;
      and_2602_s17_q <= and_2602_s16_q;
      sum_2608_s17_q <= {2'h0, and_2603} + {1'b0, sum_2607};
      and_2678_s17_q <= not_573_s16_q & (so_s16_q & (ends_cell_s16_q & and_2675_s16_q));
      and_2695_s17_q <= not_573_s16_q & (so_s16_q & and_2693);
      and_2702_s17_q <= not_573_s16_q & (so_s16_q & and_2700);
      and_2736_s17_q <= and_2736_s16_q;
      and_2737_s17_q <= and_2737_s16_q;
      residual_s17_q <= residual_s16_q[7:0];
      less_2772_s17_q <= $signed(difference_2771) < $signed({7'h0, cfg_moved_limit_i});
      less_2786_s17_q <= less_2786;
      equal_2830_s17_q <= (registration_fresh_q & select_2828) == 4'h0;
      and_2975_s17_q <= and_2975_s16_q;
      less_3102_s17_q <= less_3102_s16_q;
      equal_3445_s17_q <= equal_3445_s16_q;
      select_3533_s17_q <= select_3533_s16_q;
      select_3557_s17_q <= select_3557;
      select_3564_s17_q <= select_3564_s16_q;
      less_3607_s17_q <= less_3607;
      high_s17_q <= high;
      low_s17_q <= low;
      equal_3685_s17_q <= equal_3685;
      and_3910_s17_q <= equal_3909_s16_q & equal_3685;
      equal_3929_s17_q <= equal_3929_s16_q;
      equal_3931_s17_q <= equal_3931;
      equal_3932_s17_q <= equal_3932_s16_q;
      equal_3933_s17_q <= equal_3933_s16_q;
      equal_3934_s17_q <= equal_3934_s16_q;
      equal_3960_s17_q <= (limit & select_3958) == 8'h0;
      of_s17_q <= of;
      equal_4074_s17_q <= equal_4074_s16_q;
      equal_4170_s17_q <= (registration_fresh_q & select_4168) == 4'h0;
    end
  end

  // Stage 17 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:457
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_685_s17_q;
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
  // hls/stages/census.hpp:272
  logic [9:0] sum_710;
  assign sum_710 = {9'h0, difference_708_s17_q} + {1'b0, xor_709_s17_q};
  logic [9:0] sum_713;
  assign sum_713 = {9'h0, difference_711_s17_q} + {1'b0, xor_712_s17_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_735;
  assign sum_735 = {half_grey_levels_s17_q[9], half_grey_levels_s17_q[9:4]} + 7'h7f;
  logic less_736;
  assign less_736 = {{5{sum_735[6]}}, sum_735, half_grey_levels_s17_q[3:0]} < 16'hffe1;
  logic [6:0] sum_741;
  assign sum_741 = {half_grey_levels_2_s17_q[9], half_grey_levels_2_s17_q[9:4]} + 7'h7f;
  logic less_742;
  assign less_742 = {{5{sum_741[6]}}, sum_741, half_grey_levels_2_s17_q[3:0]} < 16'hffe1;
  // hls/stages/patches.hpp:156
  logic and_1740;
  assign and_1740 = and_1738_s17_q & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_1741;
  assign select_1741 = and_1740 ? and_1738_s17_q : patches_choice_valid_q;
  logic [7:0] select_1746;
  assign select_1746 = and_1740 ? select_1745_s17_q : patches_choice_column_q;
  logic [5:0] select_1751;
  assign select_1751 = and_1740 ? select_1750_s17_q : patches_choice_shift_q;
  logic [7:0] select_1777;
  assign select_1777 = and_1740 ? select_1776_s17_q : patches_choice_slope_q;
  // hls/stages/patches.hpp:353
  logic [22:0] select_1801;
  assign select_1801 = and_1800_s17_q ? {select_1777, select_1751, select_1746, select_1741} : patches_choices_rdata_s17_q;
  // hls/stages/patches.hpp:467
  logic [14:0] sum_1905;
  assign sum_1905 = {{4{patches_down_values_3_s17_q[10]}}, patches_down_values_3_s17_q} + {sum_1904_s17_q, sum_1903_s17_q, down_2_s17_q};
  // hls/stages/agreement.hpp:901
  logic [6:0] select_1989;
  assign select_1989 = segment_started_s17_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_1990;
  assign sum_1990 = {6'h0, textured_s17_q} + select_1989;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_1992;
  assign sum_1992 = {3'h0, sum_1990} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[9:0]);
  // hls/stages/agreement.hpp:901
  logic [6:0] select_1994;
  assign select_1994 = segment_started_s17_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_1995;
  assign sum_1995 = {6'h0, explained_s17_q} + select_1994;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_1997;
  assign sum_1997 = {3'h0, sum_1995} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[19:10]);
  // hls/stages/agreement.hpp:901
  logic [6:0] select_2004;
  assign select_2004 = segment_started_s17_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:903
  logic [6:0] sum_2005;
  assign sum_2005 = {6'h0, and_2003_s17_q} + select_2004;
  // hls/stages/agreement.hpp:1064
  logic [9:0] sum_2007;
  assign sum_2007 = {3'h0, sum_2005} + (region_fresh_s17_q ? 10'h0 : regions_rdata_s17_q[29:20]);
  // hls/stages/agreement.hpp:1276
  logic or_2017;
  assign or_2017 = marks_first_s17_q | line_ended_q;
  // hls/stages/agreement.hpp:1278
  logic [12:0] select_2019;
  assign select_2019 = marks_first_s17_q ? 13'h1 : (or_2017 ? {rows_passed_q[11:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1277
  logic [8:0] select_2021;
  assign select_2021 = or_2017 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1285
  logic select_2023;
  assign select_2023 = cfg_compete_i ? (or_2017 & select_2019[12]) : (select_2021[8] & select_2019[9]);
  // hls/stages/agreement.hpp:1088
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2049_s17_q} + ({2'h0, and_2050_s17_q} + {1'b0, sum_2054_s17_q});
  // hls/stages/agreement.hpp:1090
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2083_s17_q} + sum_2089_s17_q;
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2091;
  assign select_2091 = age_s17_q ? box_shown_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1091
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2099_s17_q} + sum_2105_s17_q;
  // hls/stages/agreement.hpp:1098
  logic [2:0] select_2107;
  assign select_2107 = age_s17_q ? box_nearer_columns_values_4_q : 3'h0;
  // hls/stages/census.hpp:210
  logic [9:0] xor_2159;
  assign xor_2159 = {difference_2158_s17_q[8:0], sum_2157_s17_q} ^ {10{difference_2158_s17_q[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2158_s17_q[9]} + {1'b0, xor_2159};
  logic [9:0] xor_2167;
  assign xor_2167 = {difference_2166_s17_q[8:0], sum_2165_s17_q} ^ {10{difference_2166_s17_q[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2166_s17_q[9]} + {1'b0, xor_2167};
  // hls/stages/agreement.hpp:521
  logic select_2182;
  assign select_2182 = and_547_s17_q ? whole_2_s17_q : census_columns_values_0_cell_0_mask_q;
  logic select_2198;
  assign select_2198 = and_547_s17_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2201;
  assign select_2201 = and_547_s17_q ? census_columns_values_0_cell_1_mask_s17_q : census_columns_values_1_cell_1_mask_q;
  logic select_2208;
  assign select_2208 = and_547_s17_q ? census_columns_values_0_cell_3_mask_s17_q : census_columns_values_1_cell_3_mask_q;
  logic select_2211;
  assign select_2211 = and_547_s17_q ? census_columns_values_0_cell_4_mask_s17_q : census_columns_values_1_cell_4_mask_q;
  logic select_2214;
  assign select_2214 = and_547_s17_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2217;
  assign select_2217 = and_547_s17_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] sum_2239;
  assign sum_2239 = {9'h0, difference_2237_s17_q} + {1'b0, xor_2238_s17_q};
  logic [9:0] sum_2242;
  assign sum_2242 = {9'h0, difference_2240_s17_q} + {1'b0, xor_2241_s17_q};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2274;
  assign sum_2274 = {13'h0, moments_turns_0_q} + (moments_starts_s17_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2276;
  assign sum_2276 = {13'h0, moments_turns_1_q} + (moments_starts_s17_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:789
  logic and_2317;
  assign and_2317 = not_575_s17_q & (equal_576_s17_q & (inside_v_s17_q & and_1595_s17_q));
  logic and_2321;
  assign and_2321 = not_575_s17_q & (equal_576_s17_q & (inside_v_s17_q & and_1604_s17_q));
  // hls/stages/census.hpp:359
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2348_s17_q} + xor_2349_s17_q;
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2360_s17_q} + xor_2361_s17_q;
  // hls/stages/agreement.hpp:789
  logic and_2592;
  assign and_2592 = not_573_s17_q & (so_s17_q & (ends_cell_s17_q & explained_s17_q));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2594;
  assign select_2594 = and_2576_s17_q ? 14'h0 : (counts_explained_q + {13'h0, and_2592});
  // hls/stages/agreement.hpp:789
  logic and_2597;
  assign and_2597 = not_573_s17_q & (so_s17_q & (ends_cell_s17_q & and_2003_s17_q));
  // hls/stages/agreement.hpp:1089
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2602_s17_q} + sum_2608_s17_q;
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2610;
  assign select_2610 = age_s17_q ? box_explained_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1133
  logic less_2626;
  assign less_2626 = region_row_s17_q < x_s17_q[5:3];
  // hls/stages/patches.hpp:345
  logic not_2965;
  assign not_2965 = ~and_1783_s17_q;
  // hls/stages/patches.hpp:501
  logic [27:0] word;
  assign word = or_1889_s17_q ? patches_right_codes_rdata_s17_q : 28'h0;
  // hls/stages/patches.hpp:518
  logic [47:0] select_3135;
  assign select_3135 = new_row_s17_q ? patches_left_codes_rdata_s17_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3137;
  assign select_3137 = equal_1785_s17_q ? patches_left_row_q : (equal_1787_s17_q ? select_3135 : patches_left_row_q);
  logic [4:0] select_3482;
  assign select_3482 = equal_1787_s17_q ? patches_along_s17_q : patches_summed_row_column_q;
  // hls/stages/patches.hpp:553
  logic [9:0] select_3559;
  assign select_3559 = less_1946_s17_q ? (equal_1949_s17_q ? 10'h3ff : select_3557_s17_q) : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3560;
  assign select_3560 = equal_1949_s17_q ? select_3559 : select_3557_s17_q;
  logic [9:0] select_3562;
  assign select_3562 = less_1946_s17_q ? (equal_1947_s17_q ? 10'h3ff : select_3560) : select_3560;
  // hls/stages/patches.hpp:577
  logic [9:0] eight;
  assign eight = high_s17_q - low_s17_q;
  logic [9:0] fall_2;
  assign fall_2 = high_s17_q - select_3564_s17_q[9:0];
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_3947;
  assign select_3947 = equal_3685_s17_q ? 14'h0 : product_q;
  logic [13:0] select_3966;
  assign select_3966 = equal_3960_s17_q ? 14'h0 : of_s17_q;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3947} + {1'b0, select_3966};
  // hls/stages/agreement.hpp:789
  logic [2:0] select_4008;
  assign select_4008 = so_s17_q ? (ends_cell_s17_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4010;
  assign select_4010 = ends_cell_s17_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4012;
  assign select_4012 = equal_572_s17_q ? box_explained_columns_values_1_q : (so_s17_q ? select_4010 : box_explained_columns_values_1_q);
  logic [2:0] select_4013;
  assign select_4013 = ends_cell_s17_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4015;
  assign select_4015 = equal_572_s17_q ? box_explained_columns_values_2_q : (so_s17_q ? select_4013 : box_explained_columns_values_2_q);
  logic [2:0] select_4016;
  assign select_4016 = ends_cell_s17_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4018;
  assign select_4018 = equal_572_s17_q ? box_explained_columns_values_3_q : (so_s17_q ? select_4016 : box_explained_columns_values_3_q);
  logic [2:0] select_4019;
  assign select_4019 = ends_cell_s17_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4021;
  assign select_4021 = equal_572_s17_q ? box_explained_columns_values_4_q : (so_s17_q ? select_4019 : box_explained_columns_values_4_q);
  logic [2:0] select_4026;
  assign select_4026 = so_s17_q ? (ends_cell_s17_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4028;
  assign select_4028 = ends_cell_s17_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4030;
  assign select_4030 = equal_572_s17_q ? box_shown_columns_values_1_q : (so_s17_q ? select_4028 : box_shown_columns_values_1_q);
  logic [2:0] select_4031;
  assign select_4031 = ends_cell_s17_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4033;
  assign select_4033 = equal_572_s17_q ? box_shown_columns_values_2_q : (so_s17_q ? select_4031 : box_shown_columns_values_2_q);
  logic [2:0] select_4034;
  assign select_4034 = ends_cell_s17_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4036;
  assign select_4036 = equal_572_s17_q ? box_shown_columns_values_3_q : (so_s17_q ? select_4034 : box_shown_columns_values_3_q);
  logic [2:0] select_4037;
  assign select_4037 = ends_cell_s17_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4039;
  assign select_4039 = equal_572_s17_q ? box_shown_columns_values_4_q : (so_s17_q ? select_4037 : box_shown_columns_values_4_q);
  logic [2:0] select_4044;
  assign select_4044 = so_s17_q ? (ends_cell_s17_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4046;
  assign select_4046 = ends_cell_s17_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4048;
  assign select_4048 = equal_572_s17_q ? box_nearer_columns_values_1_q : (so_s17_q ? select_4046 : box_nearer_columns_values_1_q);
  logic [2:0] select_4049;
  assign select_4049 = ends_cell_s17_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4051;
  assign select_4051 = equal_572_s17_q ? box_nearer_columns_values_2_q : (so_s17_q ? select_4049 : box_nearer_columns_values_2_q);
  logic [2:0] select_4052;
  assign select_4052 = ends_cell_s17_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4054;
  assign select_4054 = equal_572_s17_q ? box_nearer_columns_values_3_q : (so_s17_q ? select_4052 : box_nearer_columns_values_3_q);
  logic [2:0] select_4055;
  assign select_4055 = ends_cell_s17_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4057;
  assign select_4057 = equal_572_s17_q ? box_nearer_columns_values_4_q : (so_s17_q ? select_4055 : box_nearer_columns_values_4_q);

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s17_2_q;
  logic best_left_we;
  assign best_left_we = s17_en & and_1559_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1558_s17_q, select_1555_s17_q, select_1552_s17_q, select_1550_s17_q, select_1532_s17_q, select_1529_s17_q, select_1521_s17_q, select_1520_s17_q, select_1515_s17_q};
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
  assign best_right_we = s17_en & and_1559_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1569_s17_q, select_1568_s17_q, select_1565_s17_q, select_1564_s17_q};
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
  assign left_turns_we = s17_en & and_1598_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1595_s17_q, and_1592_s17_q};
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
  assign right_turns_we = s17_en & and_1598_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1604_s17_q, and_1601_s17_q};
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
  assign patches_choices_waddr = {patches_choosing_band_s17_q, and_1699_s17_q};
  logic patches_choices_we;
  assign patches_choices_we = s17_en & and_1784_s17_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {select_1777, select_1751, select_1746, select_1741};
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
      moments_turned_0_q <= sum_2274;
      moments_turned_1_q <= sum_2276;
      moments_turns_0_q <= not_573_s17_q & and_2317;
      moments_turns_1_q <= not_573_s17_q & and_2321;
      counts_explained_q <= select_2594;
      patches_fixed_q <= not_2965 & (patches_fixed_q | (and_2975_s17_q & and_1740));
      patches_choice_valid_q <= and_1783_s17_q ? (select_1741 & not_2965) : select_1741;
      patches_choice_column_q <= select_1746;
      patches_choice_shift_q <= select_1751;
      patches_choice_slope_q <= select_1777;
      patches_left_row_q <= select_3137;
      patches_summed_row_column_q <= equal_1785_s17_q ? patches_summed_row_column_q : select_3482;
      patches_read_far_q <= equal_1785_s17_q ? select_3562 : patches_read_far_q;
      segment_textured_q <= select_1989 + {6'h0, and_2587_s17_q};
      segment_explained_q <= select_1994 + {6'h0, and_2592};
      segment_nearer_q <= select_2004 + {6'h0, and_2597};
      product_q <= equal_572_s17_q ? sum_4[14:1] : product_q;
      rows_passed_q <= select_2019;
      columns_passed_q <= {select_2021[7:0], or_2017};
      line_ended_q <= marks_last_s17_q;
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
    if (s17_en) begin
      census_columns_values_0_cell_0_mask_q <= select_2182;
      census_columns_values_1_cell_0_mask_q <= select_2198;
      census_columns_values_1_cell_1_mask_q <= select_2201;
      census_columns_values_1_cell_3_mask_q <= select_2208;
      census_columns_values_1_cell_4_mask_q <= select_2211;
      census_columns_values_2_cell_0_mask_q <= select_2214;
      census_columns_values_2_cell_1_mask_q <= select_2217;
      box_explained_columns_values_0_q <= equal_572_s17_q ? box_explained_columns_values_0_q : select_4008;
      box_explained_columns_values_1_q <= select_4012;
      box_explained_columns_values_2_q <= select_4015;
      box_explained_columns_values_3_q <= select_4018;
      box_explained_columns_values_4_q <= select_4021;
      box_shown_columns_values_0_q <= equal_572_s17_q ? box_shown_columns_values_0_q : select_4026;
      box_shown_columns_values_1_q <= select_4030;
      box_shown_columns_values_2_q <= select_4033;
      box_shown_columns_values_3_q <= select_4036;
      box_shown_columns_values_4_q <= select_4039;
      box_nearer_columns_values_0_q <= equal_572_s17_q ? box_nearer_columns_values_0_q : select_4044;
      box_nearer_columns_values_1_q <= select_4048;
      box_nearer_columns_values_2_q <= select_4051;
      box_nearer_columns_values_3_q <= select_4054;
      box_nearer_columns_values_4_q <= select_4057;
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
  logic census_columns_values_0_cell_2_mask_s18_q;
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
  logic [3:0] select_508_s18_q;
  logic [6:0] select_511_s18_q;
  logic [6:0] column_s18_q;
  logic and_545_s18_q;
  logic and_547_s18_q;
  logic equal_550_s18_q;
  logic whole_2_s18_q;
  logic equal_567_s18_q;
  logic equal_572_s18_q;
  logic not_573_s18_q;
  logic so_s18_q;
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
  logic less_673_s18_q;
  logic and_681_s18_q;
  logic whole_9_s18_q;
  logic [10:0] sum_714_s18_q;
  logic [9:0] sum_717_s18_q;
  logic [9:0] sum_721_s18_q;
  logic [9:0] sum_725_s18_q;
  logic less_736_s18_q;
  logic less_738_s18_q;
  logic less_742_s18_q;
  logic less_744_s18_q;
  logic equal_1605_s18_q;
  logic all_s18_q;
  logic [1:0] sum_1611_s18_q;
  logic equal_1613_s18_q;
  logic equal_1615_s18_q;
  logic equal_1617_s18_q;
  logic equal_1619_s18_q;
  logic equal_1621_s18_q;
  logic equal_1623_s18_q;
  logic equal_1625_s18_q;
  logic equal_1627_s18_q;
  logic less_1636_s18_q;
  logic or_1640_s18_q;
  logic [31:0] registration_sums_rdata_s18_q;
  logic equal_1660_s18_q;
  logic and_1670_s18_q;
  logic and_1673_s18_q;
  logic select_1690_s18_q;
  logic equal_1691_s18_q;
  logic equal_1701_s18_q;
  logic equal_1785_s18_q;
  logic equal_1787_s18_q;
  logic equal_1790_s18_q;
  logic or_1791_s18_q;
  logic [22:0] select_1801_s18_q;
  logic [4:0] select_1815_s18_q;
  logic select_1821_s18_q;
  logic [3:0] select_1860_s18_q;
  logic less_1876_s18_q;
  logic new_row_s18_q;
  logic [1:0] of_row_2_s18_q;
  logic less_1906_s18_q;
  logic less_1907_s18_q;
  logic less_1916_s18_q;
  logic less_1917_s18_q;
  logic and_1931_s18_q;
  logic and_1940_s18_q;
  logic and_1945_s18_q;
  logic less_1946_s18_q;
  logic equal_1947_s18_q;
  logic not_1948_s18_q;
  logic equal_1949_s18_q;
  logic or_1968_s18_q;
  logic or_1971_s18_q;
  logic or_1974_s18_q;
  logic not_1976_s18_q;
  logic [9:0] sum_1992_s18_q;
  logic [9:0] sum_1997_s18_q;
  logic [9:0] sum_2007_s18_q;
  logic and_2008_s18_q;
  logic select_2023_s18_q;
  logic [2:0] textured_2_s18_q;
  logic or_2066_s18_q;
  logic or_2069_s18_q;
  logic or_2072_s18_q;
  logic [3:0] difference_2092_s18_q;
  logic [3:0] difference_2108_s18_q;
  logic and_2122_s18_q;
  logic [10:0] size_s18_q;
  logic [10:0] size_2_s18_q;
  logic [10:0] sum_2243_s18_q;
  logic [9:0] sum_2246_s18_q;
  logic [9:0] sum_2250_s18_q;
  logic [9:0] sum_2254_s18_q;
  logic equal_2262_s18_q;
  logic equal_2277_s18_q;
  logic [8:0] contrast_s18_q;
  logic [8:0] contrast_2_s18_q;
  logic equal_2451_s18_q;
  logic and_2576_s18_q;
  logic and_2582_s18_q;
  logic and_2597_s18_q;
  logic not_2601_s18_q;
  logic [3:0] difference_2611_s18_q;
  logic [9:0] select_2627_s18_q;
  logic [9:0] select_2630_s18_q;
  logic and_2678_s18_q;
  logic and_2695_s18_q;
  logic and_2702_s18_q;
  logic and_2736_s18_q;
  logic and_2737_s18_q;
  logic [7:0] residual_s18_q;
  logic and_2773_s18_q;
  logic and_2787_s18_q;
  logic equal_2830_s18_q;
  logic [27:0] word_s18_q;
  logic equal_3096_s18_q;
  logic less_3102_s18_q;
  logic [47:0] select_3135_s18_q;
  logic equal_3445_s18_q;
  logic [4:0] select_3533_s18_q;
  logic [14:0] select_3564_s18_q;
  logic less_3607_s18_q;
  logic [9:0] eight_s18_q;
  logic [9:0] fall_2_s18_q;
  logic equal_3685_s18_q;
  logic and_3910_s18_q;
  logic less_3911_s18_q;
  logic equal_3912_s18_q;
  logic equal_3929_s18_q;
  logic equal_3931_s18_q;
  logic equal_3932_s18_q;
  logic equal_3933_s18_q;
  logic equal_3934_s18_q;
  logic sum_4_s18_q;
  logic equal_4074_s18_q;
  logic equal_4170_s18_q;
  logic [9:0] select_4180_s18_q;
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
      census_columns_values_0_cell_2_mask_s18_q <= census_columns_values_0_cell_2_mask_s17_q;
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
      select_508_s18_q <= select_508_s17_q;
      select_511_s18_q <= select_511_s17_q;
      column_s18_q <= column_s17_q;
      and_545_s18_q <= and_545_s17_q;
      and_547_s18_q <= and_547_s17_q;
      equal_550_s18_q <= equal_550_s17_q;
      whole_2_s18_q <= whole_2_s17_q;
      equal_567_s18_q <= equal_567_s17_q;
      equal_572_s18_q <= equal_572_s17_q;
      not_573_s18_q <= not_573_s17_q;
      so_s18_q <= so_s17_q;
      less_650_s18_q <= less_650_s17_q;
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
      and_681_s18_q <= and_681_s17_q;
      whole_9_s18_q <= whole_9;
      sum_714_s18_q <= {1'b0, sum_710} + {1'b0, sum_713};
      sum_717_s18_q <= {9'h0, difference_715_s17_q} + {1'b0, xor_716_s17_q};
      sum_721_s18_q <= {9'h0, difference_719_s17_q} + {1'b0, xor_720_s17_q};
      sum_725_s18_q <= {9'h0, difference_723_s17_q} + {1'b0, xor_724_s17_q};
      less_736_s18_q <= less_736;
      less_738_s18_q <= $signed(10'h0) < $signed(half_grey_levels_s17_q);
      less_742_s18_q <= less_742;
      less_744_s18_q <= $signed(10'h0) < $signed(half_grey_levels_2_s17_q);
      equal_1605_s18_q <= equal_1605_s17_q;
      all_s18_q <= all_s17_q;
      sum_1611_s18_q <= sum_1611_s17_q;
      equal_1613_s18_q <= equal_1613_s17_q;
      equal_1615_s18_q <= equal_1615_s17_q;
      equal_1617_s18_q <= equal_1617_s17_q;
      equal_1619_s18_q <= equal_1619_s17_q;
      equal_1621_s18_q <= equal_1621_s17_q;
      equal_1623_s18_q <= equal_1623_s17_q;
      equal_1625_s18_q <= equal_1625_s17_q;
      equal_1627_s18_q <= equal_1627_s17_q;
      less_1636_s18_q <= less_1636_s17_q;
      or_1640_s18_q <= or_1640_s17_q;
      registration_sums_rdata_s18_q <= registration_sums_rdata_q;
      equal_1660_s18_q <= equal_1660_s17_q;
      and_1670_s18_q <= and_1670_s17_q;
      and_1673_s18_q <= and_1673_s17_q;
      select_1690_s18_q <= select_1690_s17_q;
      equal_1691_s18_q <= equal_1691_s17_q;
      equal_1701_s18_q <= equal_1701_s17_q;
      equal_1785_s18_q <= equal_1785_s17_q;
      equal_1787_s18_q <= equal_1787_s17_q;
      equal_1790_s18_q <= equal_1790_s17_q;
      or_1791_s18_q <= or_1791_s17_q;
      select_1801_s18_q <= select_1801;
      select_1815_s18_q <= select_1815_s17_q;
      select_1821_s18_q <= select_1821_s17_q;
      select_1860_s18_q <= select_1860_s17_q;
      less_1876_s18_q <= less_1876_s17_q;
      new_row_s18_q <= new_row_s17_q;
      of_row_2_s18_q <= of_row_2_s17_q;
      less_1906_s18_q <= $signed(15'h100) < $signed(sum_1905);
      less_1907_s18_q <= $signed(sum_1905[14:8]) < $signed(7'h7f);
      less_1916_s18_q <= $signed(15'h100) < $signed(difference_1915_s17_q);
      less_1917_s18_q <= $signed(difference_1915_s17_q[14:8]) < $signed(7'h7f);
      and_1931_s18_q <= and_1931_s17_q;
      and_1940_s18_q <= and_1940_s17_q;
      and_1945_s18_q <= and_1945_s17_q;
      less_1946_s18_q <= less_1946_s17_q;
      equal_1947_s18_q <= equal_1947_s17_q;
      not_1948_s18_q <= not_1948_s17_q;
      equal_1949_s18_q <= equal_1949_s17_q;
      or_1968_s18_q <= or_1968_s17_q;
      or_1971_s18_q <= or_1971_s17_q;
      or_1974_s18_q <= or_1974_s17_q;
      not_1976_s18_q <= not_1976_s17_q;
      sum_1992_s18_q <= sum_1992;
      sum_1997_s18_q <= sum_1997;
      sum_2007_s18_q <= sum_2007;
      and_2008_s18_q <= and_2008_s17_q;
      select_2023_s18_q <= select_2023;
      textured_2_s18_q <= textured_2;
      or_2066_s18_q <= or_2066_s17_q;
      or_2069_s18_q <= or_2069_s17_q;
      or_2072_s18_q <= or_2072_s17_q;
      difference_2092_s18_q <= {1'b0, shown_2} - {1'b0, select_2091};
      difference_2108_s18_q <= {1'b0, near_2} - {1'b0, select_2107};
      and_2122_s18_q <= and_2122_s17_q;
      size_s18_q <= size;
      size_2_s18_q <= size_2;
      sum_2243_s18_q <= {1'b0, sum_2239} + {1'b0, sum_2242};
      sum_2246_s18_q <= {9'h0, difference_2244_s17_q} + {1'b0, xor_2245_s17_q};
      sum_2250_s18_q <= {9'h0, difference_2248_s17_q} + {1'b0, xor_2249_s17_q};
      sum_2254_s18_q <= {9'h0, difference_2252_s17_q} + {1'b0, xor_2253_s17_q};
      equal_2262_s18_q <= equal_2262_s17_q;
      equal_2277_s18_q <= equal_2277_s17_q;
      contrast_s18_q <= contrast;
      contrast_2_s18_q <= contrast_2;
      equal_2451_s18_q <= equal_2451_s17_q;
      and_2576_s18_q <= and_2576_s17_q;
      and_2582_s18_q <= and_2582_s17_q;
      and_2597_s18_q <= and_2597;
      not_2601_s18_q <= not_2601_s17_q;
      difference_2611_s18_q <= {1'b0, explained_2} - {1'b0, select_2610};
      select_2627_s18_q <= less_2626 ? 10'h0 : regions_rdata_s17_q[9:0];
      select_2630_s18_q <= less_2626 ? 10'h0 : regions_rdata_s17_q[19:10];
      and_2678_s18_q <= and_2678_s17_q;
      and_2695_s18_q <= and_2695_s17_q;
      and_2702_s18_q <= and_2702_s17_q;
      and_2736_s18_q <= and_2736_s17_q;
      and_2737_s18_q <= and_2737_s17_q;
      residual_s18_q <= residual_s17_q;
      and_2773_s18_q <= and_2737_s17_q & less_2772_s17_q;
      and_2787_s18_q <= and_2737_s17_q & less_2786_s17_q;
      equal_2830_s18_q <= equal_2830_s17_q;
      word_s18_q <= word;
      equal_3096_s18_q <= patches_along_s17_q == 5'h7;
      less_3102_s18_q <= less_3102_s17_q;
      select_3135_s18_q <= select_3135;
      equal_3445_s18_q <= equal_3445_s17_q;
      select_3533_s18_q <= select_3533_s17_q;
      select_3564_s18_q <= select_3564_s17_q;
      less_3607_s18_q <= less_3607_s17_q;
      eight_s18_q <= eight;
      fall_2_s18_q <= fall_2;
      equal_3685_s18_q <= equal_3685_s17_q;
      and_3910_s18_q <= and_3910_s17_q;
      less_3911_s18_q <= counts_explained_q < product_q;
      equal_3912_s18_q <= counts_explained_q == product_q;
      equal_3929_s18_q <= equal_3929_s17_q;
      equal_3931_s18_q <= equal_3931_s17_q;
      equal_3932_s18_q <= equal_3932_s17_q;
      equal_3933_s18_q <= equal_3933_s17_q;
      equal_3934_s18_q <= equal_3934_s17_q;
      sum_4_s18_q <= sum_4[0];
      equal_4074_s18_q <= equal_4074_s17_q;
      equal_4170_s18_q <= equal_4170_s17_q;
      select_4180_s18_q <= less_2626 ? 10'h0 : regions_rdata_s17_q[29:20];
    end
  end

  // Stage 18 ----------------------------------------------------------------------------------------------------------
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
  // hls/stages/agreement.hpp:457
  logic whole_10;
  assign whole_10 = census_columns_values_1_cell_2_mask_q & whole_9_s18_q;
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
  // hls/stages/census.hpp:272
  logic [10:0] sum_718;
  assign sum_718 = sum_714_s18_q + {1'b0, sum_717_s18_q};
  // hls/stages/agreement.hpp:457
  logic and_732;
  assign and_732 = census_columns_values_0_cell_2_mask_s18_q & census_columns_values_1_cell_2_mask_q;
  logic and_733;
  assign and_733 = and_681_s18_q & and_732;
  // hls/stages/registration.hpp:265
  logic equal_1662;
  assign equal_1662 = sum_1611_s18_q == 2'h0;
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1611_s18_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1668;
  assign select_1668 = equal_1662 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1669;
  assign sum_1669 = (equal_1660_s18_q ? registration_sums_rdata_s18_q[31:20] : 12'h0) + {{5{select_1668[6]}}, select_1668};
  // hls/stages/patches.hpp:354
  logic [21:0] select_1804;
  assign select_1804 = select_1690_s18_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1801_s18_q[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1805;
  assign select_1805 = equal_1691_s18_q ? patches_place_0_column_q : select_1804[7:0];
  logic [5:0] select_1806;
  assign select_1806 = equal_1691_s18_q ? patches_place_0_shift_q : select_1804[13:8];
  // hls/stages/patches.hpp:354
  logic [21:0] select_1833;
  assign select_1833 = select_1690_s18_q ? select_1801_s18_q[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1834;
  assign select_1834 = equal_1691_s18_q ? patches_place_1_column_q : select_1833[7:0];
  logic [5:0] select_1835;
  assign select_1835 = equal_1691_s18_q ? patches_place_1_shift_q : select_1833[13:8];
  // hls/stages/patches.hpp:132
  logic equal_1851;
  assign equal_1851 = {select_1805[7], select_511_s18_q, select_508_s18_q} == {1'b0, select_1805[6:0], 4'h0};
  logic equal_1855;
  assign equal_1855 = {select_1834[7], select_511_s18_q, select_508_s18_q} == {1'b0, select_1834[6:0], 4'h0};
  // hls/stages/patches.hpp:482
  logic [2:0] sum_1897;
  assign sum_1897 = patches_code_row_s18_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:486
  logic [1:0] sum_1935;
  assign sum_1935 = patches_code_row_s18_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2023_s18_q & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1292
  logic [6:0] select_2026;
  assign select_2026 = next_row ? cfg_width_i[10:4] : 7'h0;
  // hls/stages/agreement.hpp:1302
  logic equal_2029;
  assign equal_2029 = seen_x_q == 4'hf;
  // hls/stages/agreement.hpp:1275
  logic not_2036;
  assign not_2036 = ~marks_first_s18_q;
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2057;
  assign select_2057 = age_s18_q ? box_textured_columns_values_4_q : 3'h0;
  // hls/stages/agreement.hpp:1102
  logic not_2073;
  assign not_2073 = ~region_row_s18_q[2];
  logic [2:0] select_2074;
  assign select_2074 = region_row_s18_q[1] ? {1'b0, not_2073, 1'b0} : {region_row_s18_q[2], 1'b0, not_2073};
  logic [5:0] select_2075;
  assign select_2075 = region_row_s18_q[0] ? {select_2074[2], 1'b0, select_2074[1], 1'b0, select_2074[0], 1'b0} : {1'b0, select_2074[2], 1'b0, select_2074[1], 1'b0, select_2074[0]};
  logic [11:0] select_2076;
  assign select_2076 = or_2072_s18_q ? {select_2075[5], 1'b0, select_2075[4], 1'b0, select_2075[3], 1'b0, select_2075[2], 1'b0, select_2075[1], 1'b0, select_2075[0], 1'b0} : {1'b0, select_2075[5], 1'b0, select_2075[4], 1'b0, select_2075[3], 1'b0, select_2075[2], 1'b0, select_2075[1], 1'b0, select_2075[0]};
  logic [23:0] select_2077;
  assign select_2077 = or_2069_s18_q ? {select_2076[11], 1'b0, select_2076[10], 1'b0, select_2076[9], 1'b0, select_2076[8], 1'b0, select_2076[7], 1'b0, select_2076[6], 1'b0, select_2076[5], 1'b0, select_2076[4], 1'b0, select_2076[3], 1'b0, select_2076[2], 1'b0, select_2076[1], 1'b0, select_2076[0], 1'b0} : {1'b0, select_2076[11], 1'b0, select_2076[10], 1'b0, select_2076[9], 1'b0, select_2076[8], 1'b0, select_2076[7], 1'b0, select_2076[6], 1'b0, select_2076[5], 1'b0, select_2076[4], 1'b0, select_2076[3], 1'b0, select_2076[2], 1'b0, select_2076[1], 1'b0, select_2076[0]};
  // hls/stages/agreement.hpp:1097
  logic [4:0] around;
  assign around = {difference_2092_s18_q[3], difference_2092_s18_q} + (equal_567_s18_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1098
  logic [4:0] n;
  assign n = {difference_2108_s18_q[3], difference_2108_s18_q} + (equal_567_s18_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size_s18_q} + (equal_550_s18_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2164;
  assign select_2164 = sample_pair_whole_s18_q ? (and_545_s18_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2_s18_q} + (equal_550_s18_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2172;
  assign select_2172 = sample_pair_whole_s18_q ? (and_545_s18_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:521
  logic select_2204;
  assign select_2204 = and_547_s18_q ? census_columns_values_0_cell_2_mask_s18_q : census_columns_values_1_cell_2_mask_q;
  logic select_2220;
  assign select_2220 = and_547_s18_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2223;
  assign select_2223 = and_547_s18_q ? census_columns_values_1_cell_3_mask_s18_q : census_columns_values_2_cell_3_mask_q;
  logic select_2226;
  assign select_2226 = and_547_s18_q ? census_columns_values_1_cell_4_mask_s18_q : census_columns_values_2_cell_4_mask_q;
  logic select_2227;
  assign select_2227 = and_547_s18_q ? census_columns_values_2_cell_0_mask_s18_q : census_columns_values_3_cell_0_mask_q;
  logic select_2230;
  assign select_2230 = and_547_s18_q ? census_columns_values_2_cell_1_mask_s18_q : census_columns_values_3_cell_1_mask_q;
  logic select_2231;
  assign select_2231 = and_547_s18_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2234;
  assign select_2234 = and_547_s18_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  // hls/stages/census.hpp:274
  logic [10:0] sum_2247;
  assign sum_2247 = sum_2243_s18_q + {1'b0, sum_2246_s18_q};
  // hls/stages/moments.hpp:117
  logic [13:0] select_2278;
  assign select_2278 = equal_2277_s18_q ? moments_turned_0_q : moments_before_0_q;
  logic [13:0] select_2280;
  assign select_2280 = equal_2277_s18_q ? moments_turned_1_q : moments_before_1_q;
  logic [14:0] sum_2291;
  assign sum_2291 = {1'b0, moments_turned_1_q} + 15'h3;
  logic [14:0] sum_2301;
  assign sum_2301 = {1'b0, moments_turned_0_q} + 15'h3;
  // hls/stages/agreement.hpp:521
  logic select_2344;
  assign select_2344 = and_547_s18_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2347;
  assign and_2347 = whole_2_s18_q & (~(column_s18_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:458
  logic and_2353;
  assign and_2353 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s18_q[8:2]));
  logic and_2354;
  assign and_2354 = and_2347 & and_2353;
  logic and_2365;
  assign and_2365 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s18_q[8:2]));
  logic and_2366;
  assign and_2366 = and_2347 & and_2365;
  // hls/stages/census.hpp:415
  logic not_2383;
  assign not_2383 = ~x_s18_q[1];
  logic [2:0] select_2384;
  assign select_2384 = x_s18_q[0] ? {1'b0, not_2383, 1'b0} : {x_s18_q[1], 1'b0, not_2383};
  logic [5:0] select_2385;
  assign select_2385 = slot_s18_q[2] ? {select_2384[2], 1'b0, select_2384[1], 1'b0, select_2384[0], 1'b0} : {1'b0, select_2384[2], 1'b0, select_2384[1], 1'b0, select_2384[0]};
  logic [11:0] select_2386;
  assign select_2386 = slot_s18_q[1] ? {select_2385[5], 1'b0, select_2385[4], 1'b0, select_2385[3], 1'b0, select_2385[2], 1'b0, select_2385[1], 1'b0, select_2385[0], 1'b0} : {1'b0, select_2385[5], 1'b0, select_2385[4], 1'b0, select_2385[3], 1'b0, select_2385[2], 1'b0, select_2385[1], 1'b0, select_2385[0]};
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2584;
  assign select_2584 = and_2576_s18_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2582_s18_q});
  logic [13:0] select_2599;
  assign select_2599 = and_2576_s18_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2597_s18_q});
  // hls/stages/agreement.hpp:1096
  logic [4:0] e;
  assign e = {difference_2611_s18_q[3], difference_2611_s18_q} + (equal_567_s18_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2697;
  assign select_2697 = and_2576_s18_q ? 14'h0 : (counts_turned_left_q + {13'h0, and_2695_s18_q});
  logic [13:0] select_2704;
  assign select_2704 = and_2576_s18_q ? 14'h0 : (counts_turned_right_q + {13'h0, and_2702_s18_q});
  // hls/stages/registration.hpp:107
  logic [7:0] select_2754;
  assign select_2754 = equal_1701_s18_q ? (and_2737_s18_q ? residual_s18_q : 8'h0) : 8'h0;
  // hls/stages/agreement.hpp:789
  logic and_2761;
  assign and_2761 = not_573_s18_q & (so_s18_q & (and_2737_s18_q & equal_1701_s18_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2763;
  assign select_2763 = and_2736_s18_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2761});
  // hls/stages/registration.hpp:107
  logic and_2765;
  assign and_2765 = and_2737_s18_q & ($signed(residual_s18_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2767;
  assign select_2767 = so_s18_q ? (equal_1701_s18_q ? {and_2765, and_2737_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2775;
  assign select_2775 = so_s18_q ? (equal_1701_s18_q ? {and_2773_s18_q, and_2737_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2776;
  assign select_2776 = equal_572_s18_q ? 2'h0 : select_2775;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2777;
  assign sum_2777 = registration_half_votes_up_q + {{5{select_2776[1]}}, select_2776};
  // hls/stages/registration.hpp:205
  logic less_2779;
  assign less_2779 = $signed(residual_s18_q) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:107
  logic and_2780;
  assign and_2780 = and_2737_s18_q & less_2779;
  // hls/stages/agreement.hpp:789
  logic [1:0] select_2782;
  assign select_2782 = so_s18_q ? (equal_1701_s18_q ? {and_2780, and_2737_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2789;
  assign select_2789 = so_s18_q ? (equal_1701_s18_q ? {and_2787_s18_q, and_2737_s18_q} : 2'h0) : 2'h0;
  logic [1:0] select_2790;
  assign select_2790 = equal_572_s18_q ? 2'h0 : select_2789;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2791;
  assign sum_2791 = registration_half_half_votes_up_q + {{5{select_2790[1]}}, select_2790};
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_2832;
  assign select_2832 = or_1640_s18_q ? 12'h0 : (equal_2830_s18_q ? registration_sums_rdata_s18_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_2834;
  assign select_2834 = equal_1605_s18_q ? 12'h0 : (less_1636_s18_q ? select_2832 : 12'h0);
  // hls/stages/registration.hpp:153
  logic and_2837;
  assign and_2837 = x_s18_q[1] & all_s18_q;
  // hls/stages/agreement.hpp:1143
  logic and_2840;
  assign and_2840 = not_1976_s18_q & (less_1636_s18_q & ({and_2837, x_s18_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_2847;
  assign select_2847 = or_1640_s18_q ? 12'h0 : (equal_2830_s18_q ? registration_sums_rdata_s18_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_2849;
  assign select_2849 = equal_1605_s18_q ? 12'h0 : (less_1636_s18_q ? select_2847 : 12'h0);
  // hls/stages/registration.hpp:150
  logic not_2855;
  assign not_2855 = ~all_s18_q;
  // hls/stages/agreement.hpp:1143
  logic and_2858;
  assign and_2858 = not_1976_s18_q & (less_1636_s18_q & (x_s18_q[2:0] == {all_s18_q, not_2855, 1'b0}));
  // hls/stages/agreement.hpp:789
  logic and_2864;
  assign and_2864 = equal_572_s18_q & (x_s18_q[6] & (not_1976_s18_q & (less_1636_s18_q & all_s18_q)));
  // hls/stages/registration.hpp:157
  logic equal_2891;
  assign equal_2891 = x_s18_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1143
  logic and_2894;
  assign and_2894 = not_1976_s18_q & (less_1636_s18_q & (x_s18_q[5] ? x_s18_q[3] : equal_2891));
  logic and_2903;
  assign and_2903 = not_1976_s18_q & (less_1636_s18_q & ((~x_s18_q[5]) & (x_s18_q[3] & equal_2891)));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_2998;
  assign select_2998 = sample_pair_whole_s18_q ? (equal_1691_s18_q ? patches_place_0_slope_q : select_1804[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3003;
  assign select_3003 = sample_pair_whole_s18_q ? (equal_1691_s18_q ? patches_place_1_slope_q : select_1833[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:518
  logic [55:0] other;
  assign other = new_row_s18_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3092;
  assign select_3092 = or_1791_s18_q ? {less_1917_s18_q, less_1916_s18_q, less_1907_s18_q, less_1906_s18_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3094;
  assign select_3094 = equal_1785_s18_q ? patches_codes_at_q : (equal_1787_s18_q ? other[55:4] : select_3092);
  // hls/stages/patches.hpp:517
  logic [27:0] select_3097;
  assign select_3097 = equal_3096_s18_q ? word_s18_q : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3099;
  assign select_3099 = equal_1787_s18_q ? (new_row_s18_q ? word_s18_q : select_3097) : patches_codes_further_q;
  // hls/stages/patches.hpp:519
  logic [55:0] select_3101;
  assign select_3101 = less_1876_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:489
  logic [55:0] select_3103;
  assign select_3103 = less_3102_s18_q ? {word_s18_q, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3105;
  assign select_3105 = or_1791_s18_q ? (equal_1790_s18_q ? patches_next_codes_q : select_3103) : patches_next_codes_q;
  logic [55:0] select_3107;
  assign select_3107 = equal_1785_s18_q ? patches_next_codes_q : (equal_1787_s18_q ? select_3101 : select_3105);
  // hls/stages/count_bits.hpp:24
  logic parity_3112;
  assign parity_3112 = ^{less_1917_s18_q, less_1916_s18_q, less_1907_s18_q, less_1906_s18_q};
  // hls/stages/count_bits.hpp:25
  logic or_3116;
  assign or_3116 = ({less_1907_s18_q, less_1906_s18_q} == 2'h3) | (less_1916_s18_q & (less_1907_s18_q | less_1906_s18_q));
  logic and_3117;
  assign and_3117 = less_1917_s18_q & (^{less_1916_s18_q, less_1907_s18_q, less_1906_s18_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3118;
  assign xor_3118 = or_3116 ^ and_3117;
  // hls/stages/count_bits.hpp:27
  logic and_3119;
  assign and_3119 = or_3116 & and_3117;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3121;
  assign select_3121 = or_1791_s18_q ? (and_1940_s18_q ? {and_3119, xor_3118, parity_3112} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:520
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3135_s18_q;
  // hls/stages/count_bits.hpp:24
  logic xor_3141;
  assign xor_3141 = bits[17] ^ (^{select_3135_s18_q[16:15], other[16:15]});
  logic xor_3144;
  assign xor_3144 = bits[11] ^ (^{select_3135_s18_q[10:9], other[10:9]});
  logic xor_3147;
  assign xor_3147 = bits[14] ^ (^{select_3135_s18_q[13:12], other[13:12]});
  logic xor_3150;
  assign xor_3150 = xor_3141 ^ (^{select_3135_s18_q[14:9], other[14:9]});
  logic xor_3153;
  assign xor_3153 = bits[47] ^ (^{select_3135_s18_q[46:45], other[46:45]});
  logic xor_3156;
  assign xor_3156 = bits[8] ^ (^{select_3135_s18_q[7:6], other[7:6]});
  logic xor_3159;
  assign xor_3159 = bits[2] ^ (^{select_3135_s18_q[1:0], other[1:0]});
  logic xor_3162;
  assign xor_3162 = bits[5] ^ (^{select_3135_s18_q[4:3], other[4:3]});
  logic xor_3165;
  assign xor_3165 = xor_3156 ^ (^{select_3135_s18_q[5:0], other[5:0]});
  logic parity_3167;
  assign parity_3167 = ^{select_3135_s18_q[47:45], select_3135_s18_q[8:0], other[47:45], other[8:0]};
  logic xor_3171;
  assign xor_3171 = bits[44] ^ (^{select_3135_s18_q[43:42], other[43:42]});
  logic xor_3174;
  assign xor_3174 = bits[38] ^ (^{select_3135_s18_q[37:36], other[37:36]});
  logic xor_3177;
  assign xor_3177 = bits[41] ^ (^{select_3135_s18_q[40:39], other[40:39]});
  logic xor_3183;
  assign xor_3183 = bits[26] ^ (^{select_3135_s18_q[25:24], other[25:24]});
  logic xor_3186;
  assign xor_3186 = bits[20] ^ (^{select_3135_s18_q[19:18], other[19:18]});
  logic xor_3189;
  assign xor_3189 = bits[23] ^ (^{select_3135_s18_q[22:21], other[22:21]});
  logic xor_3195;
  assign xor_3195 = bits[35] ^ (^{select_3135_s18_q[34:33], other[34:33]});
  logic xor_3198;
  assign xor_3198 = bits[29] ^ (^{select_3135_s18_q[28:27], other[28:27]});
  logic xor_3201;
  assign xor_3201 = bits[32] ^ (^{select_3135_s18_q[31:30], other[31:30]});
  // hls/stages/patches.hpp:184
  logic select_3485;
  assign select_3485 = equal_1785_s18_q ? patches_summed_first_q : (equal_1787_s18_q ? new_row_s18_q : patches_summed_first_q);
  // hls/stages/patches.hpp:539
  logic [9:0] select_3573;
  assign select_3573 = (patches_read_far_s18_q < patches_peak_far_q) ? patches_read_far_s18_q : patches_peak_far_q;
  logic [9:0] select_3574;
  assign select_3574 = patches_read_first_s18_q ? patches_read_far_s18_q : select_3573;
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3616;
  assign sum_3616 = {1'b0, fall_2_s18_q} + {2'h0, fall_2_s18_q[9:1]};
  // hls/stages/patches.hpp:580
  logic [10:0] sum_3620;
  assign sum_3620 = {1'b0, fall_2_s18_q} + {3'h0, fall_2_s18_q[9:2]};
  logic less_3624;
  assign less_3624 = {eight_s18_q, 3'h0} < ({fall_2_s18_q, 3'h0} - {3'h0, fall_2_s18_q});
  // hls/stages/patches.hpp:593
  logic [7:0] select_3630;
  assign select_3630 = patches_second_s18_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:592
  logic [3:0] sum_3631;
  assign sum_3631 = {2'h0, select_3564_s18_q[14:13]} + 4'hf;
  logic [5:0] select_3632;
  assign select_3632 = patches_second_s18_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [6:0] sum_3633;
  assign sum_3633 = {select_3632[5], select_3632} + {{4{sum_3631[3]}}, sum_3631[3:1]};
  // hls/stages/agreement.hpp:1189
  logic or_3907;
  assign or_3907 = ({counts_textured_s18_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_s18_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1227
  logic too_little;
  assign too_little = less_3911_s18_q | (product_rest_q & equal_3912_s18_q);
  // hls/stages/agreement.hpp:1228
  logic select_3915;
  assign select_3915 = and_3910_s18_q ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1136
  logic [10:0] sum_3918;
  assign sum_3918 = {1'b0, select_2630_s18_q} + {2'h0, select_2630_s18_q[9:1]};
  // hls/stages/agreement.hpp:789
  logic select_3971;
  assign select_3971 = equal_572_s18_q ? (equal_3685_s18_q ? sum_4_s18_q : (product_rest_q | sum_4_s18_q)) : product_rest_q;
  logic [2:0] select_3989;
  assign select_3989 = ends_cell_s18_q ? textured_2_s18_q : box_textured_columns_values_0_q;
  logic [2:0] select_3991;
  assign select_3991 = equal_572_s18_q ? box_textured_columns_values_0_q : (so_s18_q ? select_3989 : box_textured_columns_values_0_q);
  logic [2:0] select_3992;
  assign select_3992 = ends_cell_s18_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3994;
  assign select_3994 = equal_572_s18_q ? box_textured_columns_values_1_q : (so_s18_q ? select_3992 : box_textured_columns_values_1_q);
  logic [2:0] select_3995;
  assign select_3995 = ends_cell_s18_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3997;
  assign select_3997 = equal_572_s18_q ? box_textured_columns_values_2_q : (so_s18_q ? select_3995 : box_textured_columns_values_2_q);
  logic [2:0] select_3998;
  assign select_3998 = ends_cell_s18_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4000;
  assign select_4000 = equal_572_s18_q ? box_textured_columns_values_3_q : (so_s18_q ? select_3998 : box_textured_columns_values_3_q);
  logic [2:0] select_4001;
  assign select_4001 = ends_cell_s18_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4003;
  assign select_4003 = equal_572_s18_q ? box_textured_columns_values_4_q : (so_s18_q ? select_4001 : box_textured_columns_values_4_q);
  logic [4:0] select_4023;
  assign select_4023 = so_s18_q ? (ends_cell_s18_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4024;
  assign select_4024 = equal_572_s18_q ? box_explained_sum_sums_values_0_q : select_4023;
  logic [4:0] select_4041;
  assign select_4041 = so_s18_q ? (ends_cell_s18_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [4:0] select_4059;
  assign select_4059 = so_s18_q ? (ends_cell_s18_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1301
  logic [3:0] select_4091;
  assign select_4091 = select_2023_s18_q ? (began_q ? (seen_y_q + 4'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4097;
  assign select_4097 = marks_first_s18_q ? (less_4093 ? {sum_4094, cfg_height_i[6:4]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1141
  logic [31:0] select_4172;
  assign select_4172 = equal_1627_s18_q ? {2'h0, counts_explained_s18_q, 2'h0, counts_textured_s18_q} : (equal_4170_s18_q ? registration_sums_rdata_s18_q : 32'h0);
  logic [31:0] select_4173;
  assign select_4173 = equal_1625_s18_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4172;

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1897, patches_code_row_s18_q[1:0], of_row_2_s18_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s18_en & and_1931_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1917_s18_q, less_1916_s18_q, less_1907_s18_q, less_1906_s18_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1935, patches_code_row_s18_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s18_en & and_1945_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1917_s18_q, less_1916_s18_q, less_1907_s18_q, less_1906_s18_q, patches_codes_at_q[51:8]};
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
  assign regions_waddr = {region_row_s18_q, or_1974_s18_q, or_1971_s18_q, or_1968_s18_q};
  logic regions_we;
  assign regions_we = s18_en & and_2008_s18_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2007_s18_q, sum_1997_s18_q, sum_1992_s18_q};
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
      moments_before_0_q <= equal_572_s18_q ? select_2278 : moments_before_0_q;
      moments_before_1_q <= equal_572_s18_q ? select_2280 : moments_before_1_q;
      sharpness_before_last_mask_q <= select_2344;
      counts_supervised_q <= select_2584;
      counts_nearer_q <= select_2599;
      counts_turned_left_q <= select_2697;
      counts_turned_right_q <= select_2704;
      registration_half_measured_q <= select_2763;
      registration_half_votes_up_q <= and_2736_s18_q ? 7'h0 : sum_2777;
      registration_half_half_votes_up_q <= and_2736_s18_q ? 7'h0 : sum_2791;
      patches_place_0_column_q <= sample_pair_whole_s18_q ? select_1805 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s18_q ? select_1806 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2998;
      patches_place_1_column_q <= sample_pair_whole_s18_q ? select_1834 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s18_q ? select_1835 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3003;
      patches_codes_at_q <= select_3094;
      patches_codes_further_q <= equal_1785_s18_q ? patches_codes_further_q : select_3099;
      patches_next_codes_q <= select_3107;
      patches_summed_first_q <= select_3485;
      patches_peak_far_q <= equal_1785_s18_q ? select_3574 : patches_peak_far_q;
      product_rest_q <= select_3971;
      disagree_q <= equal_572_s18_q ? select_3915 : disagree_q;
      began_q <= not_2036 & (began_q | select_2023_s18_q);
      seen_x_q <= select_2023_s18_q ? 4'h0 : (seen_x_q + 4'h1);
      seen_y_q <= marks_first_s18_q ? 4'h0 : select_4091;
      seen_column_q <= select_2023_s18_q ? 8'h0 : (seen_column_q + {7'h0, equal_2029});
      seen_rows_left_q <= select_4097;
      at_cell_end_q <= (seen_y_q == 4'hf) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= marks_first_s18_q ? 13'h0 : (seen_base_q + {6'h0, select_2026});
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
    if (s18_en) begin
      averager_detail_0_q <= select_2164;
      averager_detail_1_q <= select_2172;
      census_columns_values_1_cell_2_mask_q <= select_2204;
      census_columns_values_2_cell_2_mask_q <= select_2220;
      census_columns_values_2_cell_3_mask_q <= select_2223;
      census_columns_values_2_cell_4_mask_q <= select_2226;
      census_columns_values_3_cell_0_mask_q <= select_2227;
      census_columns_values_3_cell_1_mask_q <= select_2230;
      census_columns_values_3_cell_2_mask_q <= select_2231;
      census_columns_values_3_cell_3_mask_q <= select_2234;
      sharpness_last_mask_q <= and_547_s18_q ? whole_2_s18_q : sharpness_last_mask_q;
      box_textured_columns_values_0_q <= select_3991;
      box_textured_columns_values_1_q <= select_3994;
      box_textured_columns_values_2_q <= select_3997;
      box_textured_columns_values_3_q <= select_4000;
      box_textured_columns_values_4_q <= select_4003;
      box_explained_sum_sums_values_0_q <= select_4024;
      box_shown_sum_sums_values_0_q <= equal_572_s18_q ? box_shown_sum_sums_values_0_q : select_4041;
      box_nearer_sum_sums_values_0_q <= equal_572_s18_q ? box_nearer_sum_sums_values_0_q : select_4059;
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
  logic [3:0] select_508_s19_q;
  logic [6:0] select_511_s19_q;
  logic [6:0] column_s19_q;
  logic and_547_s19_q;
  logic equal_567_s19_q;
  logic equal_572_s19_q;
  logic not_573_s19_q;
  logic so_s19_q;
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
  logic less_673_s19_q;
  logic and_681_s19_q;
  logic whole_16_s19_q;
  logic and_707_s19_q;
  logic [11:0] sum_722_s19_q;
  logic [9:0] sum_725_s19_q;
  logic and_733_s19_q;
  logic and_737_s19_q;
  logic less_738_s19_q;
  logic less_742_s19_q;
  logic less_744_s19_q;
  logic equal_1605_s19_q;
  logic [1:0] sum_1611_s19_q;
  logic equal_1613_s19_q;
  logic equal_1615_s19_q;
  logic equal_1617_s19_q;
  logic equal_1619_s19_q;
  logic equal_1621_s19_q;
  logic equal_1623_s19_q;
  logic less_1636_s19_q;
  logic [19:0] select_1661_s19_q;
  logic equal_1662_s19_q;
  logic [11:0] sum_1669_s19_q;
  logic and_1670_s19_q;
  logic and_1673_s19_q;
  logic select_1690_s19_q;
  logic equal_1691_s19_q;
  logic equal_1785_s19_q;
  logic equal_1787_s19_q;
  logic equal_1790_s19_q;
  logic select_1801_s19_q;
  logic [7:0] sum_1807_s19_q;
  logic [4:0] select_1815_s19_q;
  logic select_1821_s19_q;
  logic [7:0] sum_1836_s19_q;
  logic equal_1851_s19_q;
  logic equal_1855_s19_q;
  logic [3:0] select_1860_s19_q;
  logic less_1946_s19_q;
  logic equal_1947_s19_q;
  logic not_1948_s19_q;
  logic equal_1949_s19_q;
  logic not_1976_s19_q;
  logic not_2036_s19_q;
  logic [7:0] sum_2046_s19_q;
  logic [3:0] difference_2058_s19_q;
  logic or_2066_s19_q;
  logic [23:0] select_2077_s19_q;
  logic [4:0] around_s19_q;
  logic less_2111_s19_q;
  logic and_2122_s19_q;
  logic [11:0] sum_2251_s19_q;
  logic [9:0] sum_2254_s19_q;
  logic equal_2262_s19_q;
  logic equal_2277_s19_q;
  logic [13:0] select_2285_s19_q;
  logic not_2293_s19_q;
  logic not_2296_s19_q;
  logic not_2303_s19_q;
  logic not_2306_s19_q;
  logic [27:0] select_2341_s19_q;
  logic and_2354_s19_q;
  logic and_2366_s19_q;
  logic [8:0] select_2373_s19_q;
  logic [8:0] select_2377_s19_q;
  logic equal_2380_s19_q;
  logic less_2381_s19_q;
  logic [11:0] select_2386_s19_q;
  logic equal_2424_s19_q;
  logic equal_2451_s19_q;
  logic and_2576_s19_q;
  logic not_2601_s19_q;
  logic [4:0] e_s19_q;
  logic [9:0] select_2627_s19_q;
  logic [9:0] select_2630_s19_q;
  logic and_2678_s19_q;
  logic and_2736_s19_q;
  logic [7:0] select_2756_s19_q;
  logic [1:0] select_2768_s19_q;
  logic [1:0] select_2783_s19_q;
  logic [11:0] select_2834_s19_q;
  logic and_2842_s19_q;
  logic [11:0] select_2849_s19_q;
  logic and_2860_s19_q;
  logic and_2864_s19_q;
  logic and_2896_s19_q;
  logic and_2904_s19_q;
  logic [8:0] other_s19_q;
  logic [2:0] select_3122_s19_q;
  logic [8:0] select_3135_s19_q;
  logic xor_3150_s19_q;
  logic xor_3168_s19_q;
  logic xor_3180_s19_q;
  logic xor_3192_s19_q;
  logic xor_3204_s19_q;
  logic or_3213_s19_q;
  logic or_3217_s19_q;
  logic or_3221_s19_q;
  logic or_3228_s19_q;
  logic or_3232_s19_q;
  logic or_3236_s19_q;
  logic or_3243_s19_q;
  logic or_3247_s19_q;
  logic or_3251_s19_q;
  logic or_3261_s19_q;
  logic or_3265_s19_q;
  logic or_3269_s19_q;
  logic or_3277_s19_q;
  logic or_3281_s19_q;
  logic or_3285_s19_q;
  logic or_3292_s19_q;
  logic or_3296_s19_q;
  logic or_3300_s19_q;
  logic or_3310_s19_q;
  logic or_3314_s19_q;
  logic or_3318_s19_q;
  logic and_3323_s19_q;
  logic or_3324_s19_q;
  logic equal_3445_s19_q;
  logic [4:0] select_3533_s19_q;
  logic [12:0] select_3564_s19_q;
  logic [9:0] select_3574_s19_q;
  logic less_3607_s19_q;
  logic not_3615_s19_q;
  logic not_3618_s19_q;
  logic not_3622_s19_q;
  logic not_3625_s19_q;
  logic [7:0] select_3630_s19_q;
  logic sum_3631_s19_q;
  logic [6:0] sum_3633_s19_q;
  logic equal_3685_s19_q;
  logic equal_3904_s19_q;
  logic or_3907_s19_q;
  logic select_3915_s19_q;
  logic not_3920_s19_q;
  logic equal_3929_s19_q;
  logic equal_3931_s19_q;
  logic equal_3932_s19_q;
  logic equal_3933_s19_q;
  logic equal_3934_s19_q;
  logic equal_4074_s19_q;
  logic [31:0] select_4173_s19_q;
  logic [9:0] select_4180_s19_q;
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
      select_508_s19_q <= select_508_s18_q;
      select_511_s19_q <= select_511_s18_q;
      column_s19_q <= column_s18_q;
      and_547_s19_q <= and_547_s18_q;
      equal_567_s19_q <= equal_567_s18_q;
      equal_572_s19_q <= equal_572_s18_q;
      not_573_s19_q <= not_573_s18_q;
      so_s19_q <= so_s18_q;
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
      less_673_s19_q <= less_673_s18_q;
      and_681_s19_q <= and_681_s18_q;
      whole_16_s19_q <= whole_16;
      and_707_s19_q <= census_columns_values_1_cell_2_mask_q & and_681_s18_q;
      sum_722_s19_q <= {1'b0, sum_718} + {2'h0, sum_721_s18_q};
      sum_725_s19_q <= sum_725_s18_q;
      and_733_s19_q <= and_733;
      and_737_s19_q <= and_733 & less_736_s18_q;
      less_738_s19_q <= less_738_s18_q;
      less_742_s19_q <= less_742_s18_q;
      less_744_s19_q <= less_744_s18_q;
      equal_1605_s19_q <= equal_1605_s18_q;
      sum_1611_s19_q <= sum_1611_s18_q;
      equal_1613_s19_q <= equal_1613_s18_q;
      equal_1615_s19_q <= equal_1615_s18_q;
      equal_1617_s19_q <= equal_1617_s18_q;
      equal_1619_s19_q <= equal_1619_s18_q;
      equal_1621_s19_q <= equal_1621_s18_q;
      equal_1623_s19_q <= equal_1623_s18_q;
      less_1636_s19_q <= less_1636_s18_q;
      select_1661_s19_q <= equal_1660_s18_q ? registration_sums_rdata_s18_q[19:0] : 20'h0;
      equal_1662_s19_q <= equal_1662;
      sum_1669_s19_q <= sum_1669;
      and_1670_s19_q <= and_1670_s18_q;
      and_1673_s19_q <= and_1673_s18_q;
      select_1690_s19_q <= select_1690_s18_q;
      equal_1691_s19_q <= equal_1691_s18_q;
      equal_1785_s19_q <= equal_1785_s18_q;
      equal_1787_s19_q <= equal_1787_s18_q;
      equal_1790_s19_q <= equal_1790_s18_q;
      select_1801_s19_q <= select_1801_s18_q[0];
      sum_1807_s19_q <= select_1805 + {{2{select_1806[5]}}, select_1806};
      select_1815_s19_q <= select_1815_s18_q;
      select_1821_s19_q <= select_1821_s18_q;
      sum_1836_s19_q <= select_1834 + {{2{select_1835[5]}}, select_1835};
      equal_1851_s19_q <= equal_1851;
      equal_1855_s19_q <= equal_1855;
      select_1860_s19_q <= select_1860_s18_q;
      less_1946_s19_q <= less_1946_s18_q;
      equal_1947_s19_q <= equal_1947_s18_q;
      not_1948_s19_q <= not_1948_s18_q;
      equal_1949_s19_q <= equal_1949_s18_q;
      not_1976_s19_q <= not_1976_s18_q;
      not_2036_s19_q <= not_2036;
      sum_2046_s19_q <= {2'h0, x_s18_q[7:2]} + 8'hff;
      difference_2058_s19_q <= {1'b0, textured_2_s18_q} - {1'b0, select_2057};
      or_2066_s19_q <= or_2066_s18_q;
      select_2077_s19_q <= select_2077;
      around_s19_q <= around;
      less_2111_s19_q <= {1'b0, around[4:1]} < n;
      and_2122_s19_q <= and_2122_s18_q;
      sum_2251_s19_q <= {1'b0, sum_2247} + {2'h0, sum_2250_s18_q};
      sum_2254_s19_q <= sum_2254_s18_q;
      equal_2262_s19_q <= equal_2262_s18_q;
      equal_2277_s19_q <= equal_2277_s18_q;
      select_2285_s19_q <= (select_2280 < select_2278) ? select_2278 : select_2280;
      not_2293_s19_q <= ~({3'h0, counts_turned_left_q[13:2]} < sum_2291);
      not_2296_s19_q <= ~({3'h0, select_2280[13:2]} < sum_2291);
      not_2303_s19_q <= ~({3'h0, counts_turned_right_q[13:2]} < sum_2301);
      not_2306_s19_q <= ~({3'h0, select_2278[13:2]} < sum_2301);
      select_2341_s19_q <= sample_pair_whole_s18_q ? {detail_2, detail} : 28'h0;
      and_2354_s19_q <= and_2354;
      and_2366_s19_q <= and_2366;
      select_2373_s19_q <= and_2354 ? contrast_s18_q : 9'h0;
      select_2377_s19_q <= and_2366 ? contrast_2_s18_q : 9'h0;
      equal_2380_s19_q <= x_s18_q[7:3] == 5'h0;
      less_2381_s19_q <= 7'h2 < {x_s18_q[4:0], slot_s18_q[2:1]};
      select_2386_s19_q <= select_2386;
      equal_2424_s19_q <= {x_s18_q[4:0], slot_s18_q} == 8'h0;
      equal_2451_s19_q <= equal_2451_s18_q;
      and_2576_s19_q <= and_2576_s18_q;
      not_2601_s19_q <= not_2601_s18_q;
      e_s19_q <= e;
      select_2627_s19_q <= select_2627_s18_q;
      select_2630_s19_q <= select_2630_s18_q;
      and_2678_s19_q <= and_2678_s18_q;
      and_2736_s19_q <= and_2736_s18_q;
      select_2756_s19_q <= equal_572_s18_q ? 8'h0 : (so_s18_q ? select_2754 : 8'h0);
      select_2768_s19_q <= equal_572_s18_q ? 2'h0 : select_2767;
      select_2783_s19_q <= equal_572_s18_q ? 2'h0 : select_2782;
      select_2834_s19_q <= select_2834;
      and_2842_s19_q <= equal_572_s18_q & (x_s18_q[6] & and_2840);
      select_2849_s19_q <= select_2849;
      and_2860_s19_q <= equal_572_s18_q & (x_s18_q[6] & and_2858);
      and_2864_s19_q <= and_2864;
      and_2896_s19_q <= equal_572_s18_q & (x_s18_q[6] & and_2894);
      and_2904_s19_q <= x_s18_q[6] & and_2903;
      other_s19_q <= other[44:36];
      select_3122_s19_q <= equal_1787_s18_q ? 3'h0 : select_3121;
      select_3135_s19_q <= select_3135_s18_q[44:36];
      xor_3150_s19_q <= xor_3150;
      xor_3168_s19_q <= xor_3150 ^ parity_3167;
      xor_3180_s19_q <= xor_3171 ^ (^{select_3135_s18_q[41:36], other[41:36]});
      xor_3192_s19_q <= xor_3183 ^ (^{select_3135_s18_q[23:18], other[23:18]});
      xor_3204_s19_q <= xor_3195 ^ (^{select_3135_s18_q[32:27], other[32:27]});
      or_3213_s19_q <= (xor_3144 & xor_3147) | (xor_3141 & (xor_3144 | xor_3147));
      or_3217_s19_q <= (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
      or_3221_s19_q <= (xor_3159 & xor_3162) | (xor_3156 & (xor_3159 | xor_3162));
      or_3228_s19_q <= (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
      or_3232_s19_q <= (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
      or_3236_s19_q <= (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
      or_3243_s19_q <= (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
      or_3247_s19_q <= (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
      or_3251_s19_q <= (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
      or_3261_s19_q <= (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
      or_3265_s19_q <= (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
      or_3269_s19_q <= (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
      or_3277_s19_q <= (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
      or_3281_s19_q <= (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
      or_3285_s19_q <= (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
      or_3292_s19_q <= (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
      or_3296_s19_q <= (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
      or_3300_s19_q <= (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
      or_3310_s19_q <= (xor_3174 & xor_3177) | (xor_3171 & (xor_3174 | xor_3177));
      or_3314_s19_q <= (xor_3186 & xor_3189) | (xor_3183 & (xor_3186 | xor_3189));
      or_3318_s19_q <= (xor_3198 & xor_3201) | (xor_3195 & (xor_3198 | xor_3201));
      and_3323_s19_q <= xor_3153 & xor_3165;
      or_3324_s19_q <= xor_3153 | xor_3165;
      equal_3445_s19_q <= equal_3445_s18_q;
      select_3533_s19_q <= select_3533_s18_q;
      select_3564_s19_q <= select_3564_s18_q[12:0];
      select_3574_s19_q <= select_3574;
      less_3607_s19_q <= less_3607_s18_q;
      not_3615_s19_q <= ~({eight_s18_q, 3'h0} < {3'h0, fall_2_s18_q});
      not_3618_s19_q <= ~({eight_s18_q, 3'h0} < {1'b0, sum_3616, fall_2_s18_q[0]});
      not_3622_s19_q <= ~({eight_s18_q, 3'h0} < {sum_3620, fall_2_s18_q[1:0]});
      not_3625_s19_q <= ~less_3624;
      select_3630_s19_q <= select_3630;
      sum_3631_s19_q <= sum_3631[0];
      sum_3633_s19_q <= sum_3633;
      equal_3685_s19_q <= equal_3685_s18_q;
      equal_3904_s19_q <= select_2627_s18_q[9:3] == 7'h0;
      or_3907_s19_q <= or_3907;
      select_3915_s19_q <= select_3915;
      not_3920_s19_q <= ~({sum_3918, select_2630_s18_q[0]} < {2'h0, select_2627_s18_q});
      equal_3929_s19_q <= equal_3929_s18_q;
      equal_3931_s19_q <= equal_3931_s18_q;
      equal_3932_s19_q <= equal_3932_s18_q;
      equal_3933_s19_q <= equal_3933_s18_q;
      equal_3934_s19_q <= equal_3934_s18_q;
      equal_4074_s19_q <= equal_4074_s18_q;
      select_4173_s19_q <= select_4173;
      select_4180_s19_q <= select_4180_s18_q;
    end
  end

  // Stage 19 ----------------------------------------------------------------------------------------------------------
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
  logic [47:0] good_q;
  logic [4:0] box_textured_sum_sums_values_0_q;
  logic [12:0] map_row_q;
  logic [6:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
  logic said_q;
  // hls/stages/agreement.hpp:457
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
  // hls/stages/census.hpp:272
  logic [11:0] texture;
  assign texture = sum_722_s19_q + {2'h0, sum_725_s19_q};
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1611_s19_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1664;
  assign select_1664 = equal_1662_s19_q ? registration_half_across_q : {{7{down[6]}}, down};
  // hls/stages/patches.hpp:127
  logic select_1803;
  assign select_1803 = equal_1691_s19_q ? patches_place_0_valid_q : (select_1690_s19_q ? patches_place_0_valid_q : select_1801_s19_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1808;
  assign sum_1808 = sum_1807_s19_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1809;
  assign equal_1809 = {sum_1808[7], select_511_s19_q, select_508_s19_q} == {1'b0, sum_1808[6:0], 4'h8};
  // hls/stages/patches.hpp:127
  logic select_1832;
  assign select_1832 = equal_1691_s19_q ? patches_place_1_valid_q : (select_1690_s19_q ? select_1801_s19_q : patches_place_1_valid_q);
  // hls/stages/patches.hpp:324
  logic [7:0] sum_1837;
  assign sum_1837 = sum_1836_s19_q + 8'hff;
  // hls/stages/patches.hpp:131
  logic equal_1838;
  assign equal_1838 = {sum_1837[7], select_511_s19_q, select_508_s19_q} == {1'b0, sum_1837[6:0], 4'h8};
  // hls/stages/agreement.hpp:1309
  logic [12:0] index;
  assign index = seen_base_q + {5'h0, seen_column_q};
  // hls/stages/agreement.hpp:1276
  logic select_2034;
  assign select_2034 = marks_first_s19_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1262
  logic [10:0] sum_2035;
  assign sum_2035 = {1'b0, {5{select_2034}}, 1'b0, {2{select_2034}}, 1'b0, select_2034} + {1'b0, index[12:3]};
  // hls/stages/agreement.hpp:1112
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2046_s19_q[7]}}, sum_2046_s19_q, x_s19_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1262
  logic [10:0] sum_2048;
  assign sum_2048 = {1'b0, {5{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2[12:3]};
  // hls/stages/agreement.hpp:1095
  logic [4:0] t;
  assign t = {difference_2058_s19_q[3], difference_2058_s19_q} + (equal_567_s19_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [47:0] select_2078;
  assign select_2078 = or_2066_s19_q ? {select_2077_s19_q[23], 1'b0, select_2077_s19_q[22], 1'b0, select_2077_s19_q[21], 1'b0, select_2077_s19_q[20], 1'b0, select_2077_s19_q[19], 1'b0, select_2077_s19_q[18], 1'b0, select_2077_s19_q[17], 1'b0, select_2077_s19_q[16], 1'b0, select_2077_s19_q[15], 1'b0, select_2077_s19_q[14], 1'b0, select_2077_s19_q[13], 1'b0, select_2077_s19_q[12], 1'b0, select_2077_s19_q[11], 1'b0, select_2077_s19_q[10], 1'b0, select_2077_s19_q[9], 1'b0, select_2077_s19_q[8], 1'b0, select_2077_s19_q[7], 1'b0, select_2077_s19_q[6], 1'b0, select_2077_s19_q[5], 1'b0, select_2077_s19_q[4], 1'b0, select_2077_s19_q[3], 1'b0, select_2077_s19_q[2], 1'b0, select_2077_s19_q[1], 1'b0, select_2077_s19_q[0], 1'b0} : {1'b0, select_2077_s19_q[23], 1'b0, select_2077_s19_q[22], 1'b0, select_2077_s19_q[21], 1'b0, select_2077_s19_q[20], 1'b0, select_2077_s19_q[19], 1'b0, select_2077_s19_q[18], 1'b0, select_2077_s19_q[17], 1'b0, select_2077_s19_q[16], 1'b0, select_2077_s19_q[15], 1'b0, select_2077_s19_q[14], 1'b0, select_2077_s19_q[13], 1'b0, select_2077_s19_q[12], 1'b0, select_2077_s19_q[11], 1'b0, select_2077_s19_q[10], 1'b0, select_2077_s19_q[9], 1'b0, select_2077_s19_q[8], 1'b0, select_2077_s19_q[7], 1'b0, select_2077_s19_q[6], 1'b0, select_2077_s19_q[5], 1'b0, select_2077_s19_q[4], 1'b0, select_2077_s19_q[3], 1'b0, select_2077_s19_q[2], 1'b0, select_2077_s19_q[1], 1'b0, select_2077_s19_q[0]};
  // hls/stages/agreement.hpp:1104
  logic [5:0] sum_2095;
  assign sum_2095 = {1'b0, around_s19_q} + {2'h0, around_s19_q[4:1]};
  // hls/stages/agreement.hpp:521
  logic select_2235;
  assign select_2235 = and_547_s19_q ? census_columns_values_2_cell_4_mask_s19_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2255;
  assign sum_2255 = sum_2251_s19_q + {2'h0, sum_2254_s19_q};
  // hls/stages/agreement.hpp:521
  logic [11:0] select_2257;
  assign select_2257 = and_547_s19_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2258;
  assign select_2258 = and_547_s19_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2287;
  assign sum_2287 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:521
  logic [13:0] select_2342;
  assign select_2342 = and_547_s19_q ? select_2341_s19_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2343;
  assign select_2343 = and_547_s19_q ? select_2341_s19_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2341_s19_q[13:0]};
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2341_s19_q[27:14]};
  // hls/stages/census.hpp:363
  logic [23:0] sum_2374;
  assign sum_2374 = (equal_2262_s19_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2373_s19_q};
  logic [23:0] sum_2378;
  assign sum_2378 = (equal_2262_s19_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2377_s19_q};
  // hls/stages/census.hpp:415
  logic less_2382;
  assign less_2382 = x_s19_q[4:0] < 5'h3;
  logic [23:0] select_2387;
  assign select_2387 = slot_s19_q ? {select_2386_s19_q[11], 1'b0, select_2386_s19_q[10], 1'b0, select_2386_s19_q[9], 1'b0, select_2386_s19_q[8], 1'b0, select_2386_s19_q[7], 1'b0, select_2386_s19_q[6], 1'b0, select_2386_s19_q[5], 1'b0, select_2386_s19_q[4], 1'b0, select_2386_s19_q[3], 1'b0, select_2386_s19_q[2], 1'b0, select_2386_s19_q[1], 1'b0, select_2386_s19_q[0], 1'b0} : {1'b0, select_2386_s19_q[11], 1'b0, select_2386_s19_q[10], 1'b0, select_2386_s19_q[9], 1'b0, select_2386_s19_q[8], 1'b0, select_2386_s19_q[7], 1'b0, select_2386_s19_q[6], 1'b0, select_2386_s19_q[5], 1'b0, select_2386_s19_q[4], 1'b0, select_2386_s19_q[3], 1'b0, select_2386_s19_q[2], 1'b0, select_2386_s19_q[1], 1'b0, select_2386_s19_q[0]};
  // hls/stages/census.hpp:378
  logic and_2391;
  assign and_2391 = less_2382 & (~((sharpness_sums_contrast_1_q & select_2387) == 24'h0));
  logic and_2401;
  assign and_2401 = less_2382 & (~((sharpness_sums_contrast_0_q & select_2387) == 24'h0));
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2614;
  assign sum_2614 = {1'b0, e_s19_q} + {2'h0, e_s19_q[4:1]};
  // hls/stages/agreement.hpp:1134
  logic [10:0] sum_2631;
  assign sum_2631 = {1'b0, select_2630_s19_q} + {3'h0, select_2630_s19_q[9:2]};
  // hls/stages/registration.hpp:133
  logic [13:0] sum_2757;
  assign sum_2757 = registration_half_across_q + {{6{select_2756_s19_q[7]}}, select_2756_s19_q};
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2769;
  assign sum_2769 = registration_half_votes_down_q + {{5{select_2768_s19_q[1]}}, select_2768_s19_q};
  logic [6:0] sum_2784;
  assign sum_2784 = registration_half_half_votes_down_q + {{5{select_2783_s19_q[1]}}, select_2783_s19_q};
  // hls/stages/agreement.hpp:789
  logic and_2825;
  assign and_2825 = equal_572_s19_q & (x_s19_q[6] & (not_1976_s19_q & less_1636_s19_q));
  logic [11:0] select_2836;
  assign select_2836 = equal_572_s19_q ? (x_s19_q[6] ? select_2834_s19_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2844;
  assign sum_2844 = {{2{select_2836[11]}}, select_2836} + (and_2842_s19_q ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:789
  logic [11:0] select_2851;
  assign select_2851 = equal_572_s19_q ? (x_s19_q[6] ? select_2849_s19_q : 12'h0) : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2853;
  assign sum_2853 = {{2{select_2851[11]}}, select_2851} + (and_2842_s19_q ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:246
  logic not_2865;
  assign not_2865 = ~and_2864_s19_q;
  logic less_2866;
  assign less_2866 = $signed({9'h1, {2{not_2865}}, and_2864_s19_q}) < $signed(registration_up_q[13:2]);
  logic select_2867;
  assign select_2867 = and_2860_s19_q ? less_2866 : registration_enough_q;
  // hls/stages/agreement.hpp:1143
  logic and_2871;
  assign and_2871 = x_s19_q[6] & (not_1976_s19_q & (less_1636_s19_q & (x_s19_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:789
  logic and_2872;
  assign and_2872 = equal_572_s19_q & and_2871;
  // hls/stages/registration.hpp:242
  logic less_2873;
  assign less_2873 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2875;
  assign less_2875 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2877;
  assign equal_2877 = x_s19_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:789
  logic and_2881;
  assign and_2881 = equal_572_s19_q & (x_s19_q[6] & (not_1976_s19_q & (less_1636_s19_q & equal_2877)));
  // hls/stages/agreement.hpp:1143
  logic and_2888;
  assign and_2888 = x_s19_q[6] & (not_1976_s19_q & (less_1636_s19_q & (x_s19_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:244
  logic and_2906;
  assign and_2906 = registration_votes_up_q & registration_other_down_q;
  logic select_2908;
  assign select_2908 = registration_votes_down_q ? (registration_other_up_q | and_2906) : and_2906;
  // hls/stages/registration.hpp:138
  logic and_2910;
  assign and_2910 = (equal_572_s19_q & and_2904_s19_q) & (registration_other_enough_q & select_2908);
  logic and_2912;
  assign and_2912 = registration_enough_q & ((and_2896_s19_q & (less_2875 | less_2873)) | and_2910);
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3125;
  assign sum_3125 = {7'h0, patches_set_q} + (equal_1790_s19_q ? 10'h0 : patches_size_q);
  // hls/stages/count_bits.hpp:24
  logic xor_3205;
  assign xor_3205 = xor_3192_s19_q ^ xor_3204_s19_q;
  // hls/stages/count_bits.hpp:25
  logic or_3330;
  assign or_3330 = (xor_3192_s19_q & xor_3204_s19_q) | (xor_3180_s19_q & (xor_3192_s19_q | xor_3204_s19_q));
  // hls/stages/patches.hpp:579
  logic [1:0] sum_3619;
  assign sum_3619 = {1'b0, not_3615_s19_q} + {1'b0, not_3618_s19_q};
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3626;
  assign sum_3626 = {1'b0, not_3622_s19_q} + {1'b0, not_3625_s19_q};
  // hls/stages/patches.hpp:579
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3619} + {1'b0, sum_3626};
  // hls/stages/patches.hpp:593
  logic [18:0] product_3634;
  assign product_3634 = $signed({{11{select_3630_s19_q[7]}}, select_3630_s19_q}) * $signed({{8{sum_3633_s19_q[6]}}, sum_3633_s19_q, sum_3631_s19_q, select_3564_s19_q[12:10]});
  // hls/stages/patches.hpp:601
  logic [11:0] sum_3809;
  assign sum_3809 = {sum_3633_s19_q[6], sum_3633_s19_q, sum_3631_s19_q, select_3564_s19_q[12:10]} + 12'h1;
  // hls/stages/agreement.hpp:1136
  logic select_3921;
  assign select_3921 = equal_3904_s19_q ? ((~or_3907_s19_q) & (~select_3915_s19_q)) : not_3920_s19_q;
  // hls/stages/agreement.hpp:1143
  logic [47:0] select_3923;
  assign select_3923 = x_s19_q[6] ? (equal_1605_s19_q ? good_q : {select_3921, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:1148
  logic equal_3926;
  assign equal_3926 = x_s19_q == 7'h7f;
  // hls/stages/agreement.hpp:789
  logic [4:0] select_4005;
  assign select_4005 = so_s19_q ? (ends_cell_s19_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:461
  logic [12:0] select_4077;
  assign select_4077 = equal_2451_s19_q ? (equal_4074_s19_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:521
  logic [6:0] select_4080;
  assign select_4080 = and_547_s19_q ? (equal_2451_s19_q ? cfg_width_i[10:4] : map_width_q) : map_width_q;

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
      good_q <= 48'h0;
      map_row_q <= 13'h0;
      map_width_q <= 7'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s19_en) begin
      moments_most_before_q <= equal_572_s19_q ? select_2285_s19_q : moments_most_before_q;
      moments_left_alone_q <= equal_572_s19_q ? not_2293_s19_q : moments_left_alone_q;
      moments_left_other_stops_q <= equal_572_s19_q ? not_2296_s19_q : moments_left_other_stops_q;
      moments_right_alone_q <= equal_572_s19_q ? not_2303_s19_q : moments_right_alone_q;
      moments_right_other_stops_q <= equal_572_s19_q ? not_2306_s19_q : moments_right_other_stops_q;
      sharpness_sums_contrast_0_q <= and_547_s19_q ? sum_2374 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_547_s19_q ? sum_2378 : sharpness_sums_contrast_1_q;
      registration_half_across_q <= and_2736_s19_q ? 14'h0 : sum_2757;
      registration_half_votes_down_q <= and_2736_s19_q ? 7'h0 : sum_2769;
      registration_half_half_votes_down_q <= and_2736_s19_q ? 7'h0 : sum_2784;
      registration_down_q <= and_2825 ? sum_2844 : registration_down_q;
      registration_up_q <= and_2825 ? sum_2853 : registration_up_q;
      registration_enough_q <= select_2867;
      registration_votes_down_q <= and_2872 ? less_2873 : registration_votes_down_q;
      registration_votes_up_q <= and_2872 ? less_2875 : registration_votes_up_q;
      registration_other_enough_q <= and_2881 ? select_2867 : registration_other_enough_q;
      registration_other_down_q <= and_2881 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2881 ? registration_votes_up_q : registration_other_up_q;
      patches_place_0_valid_q <= sample_pair_whole_s19_q ? select_1803 : patches_place_0_valid_q;
      patches_place_1_valid_q <= sample_pair_whole_s19_q ? select_1832 : patches_place_1_valid_q;
      patches_set_q <= equal_1785_s19_q ? 3'h0 : select_3122_s19_q;
      patches_size_q <= sum_3125;
      good_q <= equal_572_s19_q ? select_3923 : good_q;
      map_row_q <= and_547_s19_q ? select_4077 : map_row_q;
      map_width_q <= select_4080;
      write_half_q <= marks_first_s19_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2034;
      done_q <= not_2036_s19_q & ((~drew_q) & (done_q | said_q));
      drew_q <= so_s19_q;
      said_q <= equal_572_s19_q & equal_3926;
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
      census_columns_values_3_cell_4_mask_q <= select_2235;
      census_changes_values_0_left_q <= and_547_s19_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_547_s19_q ? sum_2255 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2257;
      census_changes_values_1_right_q <= select_2258;
      sharpness_last_detail_0_q <= select_2342;
      sharpness_last_detail_1_q <= select_2343;
      box_textured_sum_sums_values_0_q <= equal_572_s19_q ? box_textured_sum_sums_values_0_q : select_4005;
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
  logic moments_left_alone_s20_q;
  logic moments_left_other_stops_s20_q;
  logic moments_right_alone_s20_q;
  logic moments_right_other_stops_s20_q;
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
  logic and_547_s20_q;
  logic equal_572_s20_q;
  logic not_573_s20_q;
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
  logic less_673_s20_q;
  logic and_681_s20_q;
  logic and_706_s20_q;
  logic and_707_s20_q;
  logic [12:0] sum_727_s20_q;
  logic and_733_s20_q;
  logic and_737_s20_q;
  logic less_738_s20_q;
  logic less_742_s20_q;
  logic less_744_s20_q;
  logic equal_1605_s20_q;
  logic [1:0] sum_1611_s20_q;
  logic equal_1613_s20_q;
  logic equal_1615_s20_q;
  logic equal_1617_s20_q;
  logic equal_1619_s20_q;
  logic equal_1621_s20_q;
  logic equal_1623_s20_q;
  logic [19:0] sum_1665_s20_q;
  logic [11:0] sum_1669_s20_q;
  logic and_1670_s20_q;
  logic and_1673_s20_q;
  logic select_1690_s20_q;
  logic equal_1691_s20_q;
  logic equal_1785_s20_q;
  logic equal_1787_s20_q;
  logic select_1801_s20_q;
  logic select_1803_s20_q;
  logic equal_1809_s20_q;
  logic [4:0] select_1815_s20_q;
  logic select_1821_s20_q;
  logic select_1832_s20_q;
  logic equal_1838_s20_q;
  logic or_1853_s20_q;
  logic or_1857_s20_q;
  logic [3:0] select_1860_s20_q;
  logic less_1946_s20_q;
  logic equal_1947_s20_q;
  logic not_1948_s20_q;
  logic equal_1949_s20_q;
  logic not_1976_s20_q;
  logic [2:0] index_s20_q;
  logic [10:0] sum_2035_s20_q;
  logic and_2042_s20_q;
  logic less_2043_s20_q;
  logic [2:0] index_2_s20_q;
  logic [10:0] sum_2048_s20_q;
  logic equal_2061_s20_q;
  logic not_2081_s20_q;
  logic not_2097_s20_q;
  logic less_2111_s20_q;
  logic and_2122_s20_q;
  logic equal_2262_s20_q;
  logic [12:0] sum_2263_s20_q;
  logic equal_2277_s20_q;
  logic not_2289_s20_q;
  logic not_2299_s20_q;
  logic [12:0] select_2356_s20_q;
  logic [12:0] select_2368_s20_q;
  logic equal_2380_s20_q;
  logic less_2381_s20_q;
  logic and_2391_s20_q;
  logic and_2401_s20_q;
  logic equal_2424_s20_q;
  logic and_2576_s20_q;
  logic not_2601_s20_q;
  logic not_2616_s20_q;
  logic [9:0] select_2627_s20_q;
  logic [9:0] select_2630_s20_q;
  logic less_2632_s20_q;
  logic and_2678_s20_q;
  logic equal_2877_s20_q;
  logic not_2890_s20_q;
  logic and_2912_s20_q;
  logic parity_3209_s20_q;
  logic or_3213_s20_q;
  logic or_3217_s20_q;
  logic or_3221_s20_q;
  logic or_3228_s20_q;
  logic or_3232_s20_q;
  logic or_3236_s20_q;
  logic or_3243_s20_q;
  logic or_3247_s20_q;
  logic or_3251_s20_q;
  logic or_3261_s20_q;
  logic or_3265_s20_q;
  logic or_3269_s20_q;
  logic or_3277_s20_q;
  logic or_3281_s20_q;
  logic or_3285_s20_q;
  logic or_3292_s20_q;
  logic or_3296_s20_q;
  logic or_3300_s20_q;
  logic or_3310_s20_q;
  logic or_3314_s20_q;
  logic or_3318_s20_q;
  logic and_3322_s20_q;
  logic or_3326_s20_q;
  logic or_3330_s20_q;
  logic equal_3445_s20_q;
  logic [4:0] select_3533_s20_q;
  logic [9:0] select_3564_s20_q;
  logic [9:0] select_3574_s20_q;
  logic less_3607_s20_q;
  logic [2:0] fraction_s20_q;
  logic [13:0] product_3634_s20_q;
  logic equal_3685_s20_q;
  logic less_3810_s20_q;
  logic or_3907_s20_q;
  logic select_3915_s20_q;
  logic equal_3926_s20_q;
  logic equal_3929_s20_q;
  logic equal_3931_s20_q;
  logic equal_3932_s20_q;
  logic equal_3933_s20_q;
  logic equal_3934_s20_q;
  logic [31:0] select_4173_s20_q;
  logic [9:0] select_4180_s20_q;
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
      census_changes_values_1_left_s20_q <= census_changes_values_1_left_q;
      census_changes_values_1_right_s20_q <= census_changes_values_1_right_q;
      moments_left_alone_s20_q <= moments_left_alone_q;
      moments_left_other_stops_s20_q <= moments_left_other_stops_q;
      moments_right_alone_s20_q <= moments_right_alone_q;
      moments_right_other_stops_s20_q <= moments_right_other_stops_q;
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
      and_547_s20_q <= and_547_s19_q;
      equal_572_s20_q <= equal_572_s19_q;
      not_573_s20_q <= not_573_s19_q;
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
      less_673_s20_q <= less_673_s19_q;
      and_681_s20_q <= and_681_s19_q;
      and_706_s20_q <= whole_22 & and_681_s19_q;
      and_707_s20_q <= and_707_s19_q;
      sum_727_s20_q <= {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
      and_733_s20_q <= and_733_s19_q;
      and_737_s20_q <= and_737_s19_q;
      less_738_s20_q <= less_738_s19_q;
      less_742_s20_q <= less_742_s19_q;
      less_744_s20_q <= less_744_s19_q;
      equal_1605_s20_q <= equal_1605_s19_q;
      sum_1611_s20_q <= sum_1611_s19_q;
      equal_1613_s20_q <= equal_1613_s19_q;
      equal_1615_s20_q <= equal_1615_s19_q;
      equal_1617_s20_q <= equal_1617_s19_q;
      equal_1619_s20_q <= equal_1619_s19_q;
      equal_1621_s20_q <= equal_1621_s19_q;
      equal_1623_s20_q <= equal_1623_s19_q;
      sum_1665_s20_q <= select_1661_s19_q + {{6{select_1664[13]}}, select_1664};
      sum_1669_s20_q <= sum_1669_s19_q;
      and_1670_s20_q <= and_1670_s19_q;
      and_1673_s20_q <= and_1673_s19_q;
      select_1690_s20_q <= select_1690_s19_q;
      equal_1691_s20_q <= equal_1691_s19_q;
      equal_1785_s20_q <= equal_1785_s19_q;
      equal_1787_s20_q <= equal_1787_s19_q;
      select_1801_s20_q <= select_1801_s19_q;
      select_1803_s20_q <= select_1803;
      equal_1809_s20_q <= equal_1809;
      select_1815_s20_q <= select_1815_s19_q;
      select_1821_s20_q <= select_1821_s19_q;
      select_1832_s20_q <= select_1832;
      equal_1838_s20_q <= equal_1838;
      or_1853_s20_q <= and_1673_s19_q | (select_1803 & equal_1851_s19_q);
      or_1857_s20_q <= and_1673_s19_q | (select_1832 & equal_1855_s19_q);
      select_1860_s20_q <= select_1860_s19_q;
      less_1946_s20_q <= less_1946_s19_q;
      equal_1947_s20_q <= equal_1947_s19_q;
      not_1948_s20_q <= not_1948_s19_q;
      equal_1949_s20_q <= equal_1949_s19_q;
      not_1976_s20_q <= not_1976_s19_q;
      index_s20_q <= index[2:0];
      sum_2035_s20_q <= sum_2035;
      and_2042_s20_q <= began_q & (seen_x_q == 4'h0);
      less_2043_s20_q <= seen_column_q < {1'b0, cfg_width_i[10:4]};
      index_2_s20_q <= index_2[2:0];
      sum_2048_s20_q <= sum_2048;
      equal_2061_s20_q <= t[4:1] == 4'h0;
      not_2081_s20_q <= ~((good_q & select_2078) == 48'h0);
      not_2097_s20_q <= ~({sum_2095, around_s19_q[0]} < {2'h0, t});
      less_2111_s20_q <= less_2111_s19_q;
      and_2122_s20_q <= and_2122_s19_q;
      equal_2262_s20_q <= equal_2262_s19_q;
      sum_2263_s20_q <= {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2255};
      equal_2277_s20_q <= equal_2277_s19_q;
      not_2289_s20_q <= ~({3'h0, counts_turned_left_s19_q} < sum_2287);
      not_2299_s20_q <= ~({3'h0, counts_turned_right_s19_q} < sum_2287);
      select_2356_s20_q <= and_2354_s19_q ? detail_3[14:2] : 13'h0;
      select_2368_s20_q <= and_2366_s19_q ? detail_4[14:2] : 13'h0;
      equal_2380_s20_q <= equal_2380_s19_q;
      less_2381_s20_q <= less_2381_s19_q;
      and_2391_s20_q <= and_2391;
      and_2401_s20_q <= and_2401;
      equal_2424_s20_q <= equal_2424_s19_q;
      and_2576_s20_q <= and_2576_s19_q;
      not_2601_s20_q <= not_2601_s19_q;
      not_2616_s20_q <= ~({sum_2614, e_s19_q[0]} < {2'h0, t});
      select_2627_s20_q <= select_2627_s19_q;
      select_2630_s20_q <= select_2630_s19_q;
      less_2632_s20_q <= {sum_2631, select_2630_s19_q[1:0]} < {3'h0, select_2627_s19_q};
      and_2678_s20_q <= and_2678_s19_q;
      equal_2877_s20_q <= equal_2877;
      not_2890_s20_q <= ~(equal_572_s19_q & and_2888);
      and_2912_s20_q <= and_2912;
      parity_3209_s20_q <= ^{xor_3205, xor_3168_s19_q, select_3135_s19_q, other_s19_q};
      or_3213_s20_q <= or_3213_s19_q;
      or_3217_s20_q <= or_3217_s19_q;
      or_3221_s20_q <= or_3221_s19_q;
      or_3228_s20_q <= or_3228_s19_q;
      or_3232_s20_q <= or_3232_s19_q;
      or_3236_s20_q <= or_3236_s19_q;
      or_3243_s20_q <= or_3243_s19_q;
      or_3247_s20_q <= or_3247_s19_q;
      or_3251_s20_q <= or_3251_s19_q;
      or_3261_s20_q <= or_3261_s19_q;
      or_3265_s20_q <= or_3265_s19_q;
      or_3269_s20_q <= or_3269_s19_q;
      or_3277_s20_q <= or_3277_s19_q;
      or_3281_s20_q <= or_3281_s19_q;
      or_3285_s20_q <= or_3285_s19_q;
      or_3292_s20_q <= or_3292_s19_q;
      or_3296_s20_q <= or_3296_s19_q;
      or_3300_s20_q <= or_3300_s19_q;
      or_3310_s20_q <= or_3310_s19_q;
      or_3314_s20_q <= or_3314_s19_q;
      or_3318_s20_q <= or_3318_s19_q;
      and_3322_s20_q <= xor_3168_s19_q & (^{xor_3205, select_3135_s19_q, other_s19_q});
      or_3326_s20_q <= and_3323_s19_q | (xor_3150_s19_q & or_3324_s19_q);
      or_3330_s20_q <= or_3330;
      equal_3445_s20_q <= equal_3445_s19_q;
      select_3533_s20_q <= select_3533_s19_q;
      select_3564_s20_q <= select_3564_s19_q[9:0];
      select_3574_s20_q <= select_3574_s19_q;
      less_3607_s20_q <= less_3607_s19_q;
      fraction_s20_q <= fraction;
      product_3634_s20_q <= product_3634[18:5];
      equal_3685_s20_q <= equal_3685_s19_q;
      less_3810_s20_q <= {{4{sum_3809[11]}}, sum_3809} < 16'h3;
      or_3907_s20_q <= or_3907_s19_q;
      select_3915_s20_q <= select_3915_s19_q;
      equal_3926_s20_q <= equal_3926;
      equal_3929_s20_q <= equal_3929_s19_q;
      equal_3931_s20_q <= equal_3931_s19_q;
      equal_3932_s20_q <= equal_3932_s19_q;
      equal_3933_s20_q <= equal_3933_s19_q;
      equal_3934_s20_q <= equal_3934_s19_q;
      select_4173_s20_q <= select_4173_s19_q;
      select_4180_s20_q <= select_4180_s19_q;
    end
  end

  // Stage 20 ----------------------------------------------------------------------------------------------------------
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
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic good_known_q;
  // hls/stages/census.hpp:283
  logic [13:0] sum_728;
  assign sum_728 = {2'h0, census_changes_values_1_left_s20_q} + {1'b0, sum_727_s20_q};
  logic [13:0] sum_729;
  assign sum_729 = {2'h0, census_changes_values_2_left_q} + sum_728;
  // hls/stages/patches.hpp:134
  logic [4:0] select_1854;
  assign select_1854 = or_1853_s20_q ? {and_1673_s20_q, 4'h0} : patches_left_next_0_q;
  logic [4:0] select_1858;
  assign select_1858 = or_1857_s20_q ? {and_1673_s20_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1854[4] ? select_1858[3:0] : select_1854[3:0];
  logic and_1863;
  assign and_1863 = select_1821_s20_q & (select_1815_s20_q[3] ^ select_1815_s20_q[4]);
  logic and_1868;
  assign and_1868 = sample_pair_whole_s20_q & (and_1863 & ((~select_1854[4]) | (~select_1858[4])));
  // hls/stages/agreement.hpp:1031
  logic and_2082;
  assign and_2082 = good_known_q & not_2081_s20_q;
  // hls/stages/agreement.hpp:1104
  logic is_seen;
  assign is_seen = equal_2061_s20_q ? and_2082 : not_2097_s20_q;
  // hls/stages/agreement.hpp:521
  logic [11:0] select_2259;
  assign select_2259 = and_547_s20_q ? census_changes_values_1_left_s20_q : census_changes_values_2_left_q;
  logic [11:0] select_2260;
  assign select_2260 = and_547_s20_q ? census_changes_values_1_right_s20_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [13:0] sum_2264;
  assign sum_2264 = {2'h0, census_changes_values_1_right_s20_q} + {1'b0, sum_2263_s20_q};
  logic [13:0] sum_2265;
  assign sum_2265 = {2'h0, census_changes_values_2_right_q} + sum_2264;
  // hls/stages/moments.hpp:94
  logic and_2324;
  assign and_2324 = moments_right_alone_s20_q & (moments_right_begins_q | moments_right_other_stops_s20_q);
  logic or_2326;
  assign or_2326 = moments_left_begins_q | (moments_left_other_stops_s20_q | and_2324);
  logic and_2328;
  assign and_2328 = cfg_same_table_i & (moments_left_alone_s20_q ? or_2326 : and_2324);
  // hls/stages/moments.hpp:95
  logic and_2334;
  assign and_2334 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:363
  logic [23:0] select_2358;
  assign select_2358 = equal_2262_s20_q ? {11'h0, select_2356_s20_q} : (sharpness_sums_detail_0_q + {11'h0, select_2356_s20_q});
  logic [23:0] select_2370;
  assign select_2370 = equal_2262_s20_q ? {11'h0, select_2368_s20_q} : (sharpness_sums_detail_1_q + {11'h0, select_2368_s20_q});
  // hls/stages/census.hpp:383
  logic [17:0] select_2393;
  assign select_2393 = (less_2381_s20_q & and_2391_s20_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [17:0] select_2403;
  assign select_2403 = (less_2381_s20_q & and_2401_s20_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  // hls/stages/agreement.hpp:216
  logic [1:0] select_2412;
  assign select_2412 = equal_2380_s20_q ? {sharpness_comparing_contrast_0_q[0], and_2401_s20_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2414;
  assign select_2414 = equal_2380_s20_q ? {sharpness_comparing_contrast_1_q[0], and_2391_s20_q} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:392
  logic xor_2437;
  assign xor_2437 = sharpness_comparing_contrast_0_q[1] ^ and_2391_s20_q;
  logic select_2440;
  assign select_2440 = (equal_2424_s20_q | xor_2437) ? (and_2391_s20_q & xor_2437) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2441;
  assign select_2441 = equal_2380_s20_q ? select_2440 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2443;
  assign xor_2443 = sharpness_comparing_contrast_1_q[1] ^ and_2401_s20_q;
  logic select_2446;
  assign select_2446 = (equal_2424_s20_q | xor_2443) ? (and_2401_s20_q & xor_2443) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2447;
  assign select_2447 = equal_2380_s20_q ? select_2446 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:1107
  logic not_2618;
  assign not_2618 = ~(equal_2061_s20_q ? and_2082 : not_2616_s20_q);
  // hls/stages/agreement.hpp:789
  logic and_2621;
  assign and_2621 = ends_cell_s20_q & (not_2601_s20_q & (centres_values_1_textured_s20_q & not_2618));
  // hls/stages/agreement.hpp:1139
  logic [9:0] select_2634;
  assign select_2634 = ((~(select_2627_s20_q[9:4] == 6'h0)) & less_2632_s20_q) ? select_2627_s20_q : 10'h0;
  // hls/stages/agreement.hpp:789
  logic [9:0] select_2637;
  assign select_2637 = equal_572_s20_q ? (x_s20_q[6] ? (equal_1605_s20_q ? 10'h0 : select_2634) : 10'h0) : 10'h0;
  // hls/stages/agreement.hpp:1111
  logic and_2655;
  assign and_2655 = centres_values_1_textured_s20_q & (centres_values_1_of_skin_s20_q & not_2618);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3022;
  assign select_3022 = sample_pair_whole_s20_q ? (select_1854[4] ? {1'b1, select_1854[3:0]} : (select_1854 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3025;
  assign select_3025 = sample_pair_whole_s20_q ? (select_1858[4] ? {1'b1, select_1858[3:0]} : (select_1858 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3239;
  assign parity_3239 = ^{or_3236_s20_q, or_3232_s20_q, or_3228_s20_q};
  logic parity_3254;
  assign parity_3254 = ^{or_3251_s20_q, or_3247_s20_q, or_3243_s20_q};
  logic parity_3257;
  assign parity_3257 = ^{or_3251_s20_q, or_3247_s20_q, or_3243_s20_q, or_3236_s20_q, or_3232_s20_q, or_3228_s20_q, or_3221_s20_q, or_3217_s20_q, or_3213_s20_q};
  logic parity_3288;
  assign parity_3288 = ^{or_3285_s20_q, or_3281_s20_q, or_3277_s20_q};
  logic parity_3303;
  assign parity_3303 = ^{or_3300_s20_q, or_3296_s20_q, or_3292_s20_q};
  logic parity_3306;
  assign parity_3306 = ^{or_3300_s20_q, or_3296_s20_q, or_3292_s20_q, or_3285_s20_q, or_3281_s20_q, or_3277_s20_q, or_3269_s20_q, or_3265_s20_q, or_3261_s20_q};
  logic parity_3321;
  assign parity_3321 = ^{or_3318_s20_q, or_3314_s20_q, or_3310_s20_q};
  logic parity_3333;
  assign parity_3333 = ^{or_3330_s20_q, or_3326_s20_q, and_3322_s20_q};
  logic parity_3336;
  assign parity_3336 = ^{or_3330_s20_q, or_3326_s20_q, and_3322_s20_q, or_3318_s20_q, or_3314_s20_q, or_3310_s20_q, or_3300_s20_q, or_3296_s20_q, or_3292_s20_q, or_3285_s20_q, or_3281_s20_q, or_3277_s20_q, or_3269_s20_q, or_3265_s20_q, or_3261_s20_q};
  logic parity_3338;
  assign parity_3338 = ^{or_3330_s20_q, or_3326_s20_q, and_3322_s20_q, or_3318_s20_q, or_3314_s20_q, or_3310_s20_q, or_3300_s20_q, or_3296_s20_q, or_3292_s20_q, or_3285_s20_q, or_3281_s20_q, or_3277_s20_q, or_3269_s20_q, or_3265_s20_q, or_3261_s20_q, or_3251_s20_q, or_3247_s20_q, or_3243_s20_q, or_3236_s20_q, or_3232_s20_q, or_3228_s20_q, or_3221_s20_q, or_3217_s20_q, or_3213_s20_q};
  // hls/stages/count_bits.hpp:25
  logic and_3339;
  assign and_3339 = parity_3257 & parity_3336;
  logic and_3342;
  assign and_3342 = (^{or_3221_s20_q, or_3217_s20_q, or_3213_s20_q}) & (parity_3239 | parity_3254);
  logic or_3343;
  assign or_3343 = (parity_3239 & parity_3254) | and_3342;
  logic or_3347;
  assign or_3347 = (parity_3321 & parity_3333) | (parity_3306 & (parity_3321 | parity_3333));
  logic and_3353;
  assign and_3353 = (^{or_3269_s20_q, or_3265_s20_q, or_3261_s20_q}) & (parity_3288 | parity_3303);
  logic or_3354;
  assign or_3354 = (parity_3288 & parity_3303) | and_3353;
  logic or_3358;
  assign or_3358 = (or_3314_s20_q & or_3318_s20_q) | (or_3310_s20_q & (or_3314_s20_q | or_3318_s20_q));
  logic or_3362;
  assign or_3362 = (or_3326_s20_q & or_3330_s20_q) | (and_3322_s20_q & (or_3326_s20_q | or_3330_s20_q));
  // hls/stages/count_bits.hpp:23
  logic or_3369;
  assign or_3369 = (or_3265_s20_q & or_3269_s20_q) | (or_3261_s20_q & (or_3265_s20_q | or_3269_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3373;
  assign or_3373 = (or_3281_s20_q & or_3285_s20_q) | (or_3277_s20_q & (or_3281_s20_q | or_3285_s20_q));
  logic or_3377;
  assign or_3377 = (or_3296_s20_q & or_3300_s20_q) | (or_3292_s20_q & (or_3296_s20_q | or_3300_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3380;
  assign parity_3380 = ^{or_3377, or_3373, or_3369};
  // hls/stages/count_bits.hpp:23
  logic or_3384;
  assign or_3384 = (or_3217_s20_q & or_3221_s20_q) | (or_3213_s20_q & (or_3217_s20_q | or_3221_s20_q));
  // hls/stages/count_bits.hpp:25
  logic or_3388;
  assign or_3388 = (or_3232_s20_q & or_3236_s20_q) | (or_3228_s20_q & (or_3232_s20_q | or_3236_s20_q));
  logic or_3392;
  assign or_3392 = (or_3247_s20_q & or_3251_s20_q) | (or_3243_s20_q & (or_3247_s20_q | or_3251_s20_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3395;
  assign parity_3395 = ^{or_3392, or_3388, or_3384};
  logic parity_3398;
  assign parity_3398 = ^{or_3392, or_3388, or_3384, or_3377, or_3373, or_3369, or_3362, or_3358, or_3354};
  // hls/stages/patches.hpp:590
  logic [9:0] difference_3577;
  assign difference_3577 = select_3574_s20_q - select_3564_s20_q;
  // hls/stages/patches.hpp:595
  logic or_3584;
  assign or_3584 = (patches_size_q < 10'h39) | ({1'b0, patches_size_q[9:1]} < select_3564_s20_q);
  // hls/stages/patches.hpp:581
  logic [1:0] sum_3608;
  assign sum_3608 = select_3533_s20_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:582
  logic [7:0] difference_3628;
  assign difference_3628 = {sum_3608, select_3533_s20_q[2:0], 3'h0} - {5'h0, fraction_s20_q};
  logic [7:0] select_3629;
  assign select_3629 = less_3607_s20_q ? difference_3628 : {sum_3608, select_3533_s20_q[2:0], fraction_s20_q};
  // hls/stages/agreement.hpp:789
  logic select_3928;
  assign select_3928 = equal_572_s20_q ? ((x_s20_q[6] & good_known_q) | equal_3926_s20_q) : good_known_q;
  // hls/stages/agreement.hpp:1309
  logic and_4103;
  assign and_4103 = and_2122_s20_q & ({sum_2048_s20_q, index_2_s20_q} == {sum_2035_s20_q, index_s20_q});

  // Memory map, 16080 x 2, DISTANCE 16, hls/stages/agreement.hpp:1410; read in stage 20, written in stage 21: 20 < 21 < 20 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:16079];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 16080; i++) map_mem[i] = 2'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2035_s20_q, index_s20_q};
  logic map_re;
  assign map_re = s20_en & (and_2042_s20_q & less_2043_s20_q);
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1611_s20_q, lower_half_s20_q, registration_of_right_s20_q};
  logic registration_sums_we;
  assign registration_sums_we = s20_en & and_1670_s20_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1669_s20_q, sum_1665_s20_q};
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
      moments_left_begins_q <= equal_572_s20_q ? not_2289_s20_q : moments_left_begins_q;
      moments_right_begins_q <= equal_572_s20_q ? not_2299_s20_q : moments_right_begins_q;
      moments_ends_q <= equal_572_s20_q & (equal_2277_s20_q & (not_2332 | and_2334));
      sharpness_sums_detail_0_q <= and_547_s20_q ? select_2358 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_547_s20_q ? select_2370 : sharpness_sums_detail_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2412 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2414 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_less_contrast_0_q <= drew_q ? select_2441 : sharpness_comparing_less_contrast_0_q;
      sharpness_comparing_less_contrast_1_q <= drew_q ? select_2447 : sharpness_comparing_less_contrast_1_q;
      registration_moved_q <= not_2890_s20_q & (registration_moved_q | and_2912_s20_q);
      patches_left_next_0_q <= select_3022;
      patches_left_next_1_q <= select_3025;
      good_known_q <= select_3928;
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
      census_changes_values_2_left_q <= select_2259;
      census_changes_values_2_right_q <= select_2260;
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
  logic and_547_s21_q;
  logic equal_572_s21_q;
  logic not_573_s21_q;
  logic so_s21_q;
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
  logic less_673_s21_q;
  logic and_681_s21_q;
  logic and_706_s21_q;
  logic and_707_s21_q;
  logic [8:0] sum_729_s21_q;
  logic and_737_s21_q;
  logic less_738_s21_q;
  logic and_743_s21_q;
  logic less_744_s21_q;
  logic equal_1605_s21_q;
  logic equal_1613_s21_q;
  logic equal_1615_s21_q;
  logic equal_1617_s21_q;
  logic equal_1619_s21_q;
  logic equal_1621_s21_q;
  logic equal_1623_s21_q;
  logic and_1673_s21_q;
  logic select_1690_s21_q;
  logic equal_1691_s21_q;
  logic equal_1785_s21_q;
  logic equal_1787_s21_q;
  logic select_1801_s21_q;
  logic or_1811_s21_q;
  logic [4:0] select_1815_s21_q;
  logic select_1821_s21_q;
  logic or_1840_s21_q;
  logic [3:0] column_5_s21_q;
  logic [3:0] select_1860_s21_q;
  logic select_1861_s21_q;
  logic and_1868_s21_q;
  logic less_1946_s21_q;
  logic equal_1947_s21_q;
  logic not_1948_s21_q;
  logic equal_1949_s21_q;
  logic not_1976_s21_q;
  logic and_2042_s21_q;
  logic less_2043_s21_q;
  logic [2:0] index_2_s21_q;
  logic [10:0] sum_2048_s21_q;
  logic is_seen_s21_q;
  logic and_2112_s21_q;
  logic and_2122_s21_q;
  logic equal_2262_s21_q;
  logic [8:0] sum_2265_s21_q;
  logic equal_2277_s21_q;
  logic not_2308_s21_q;
  logic and_2329_s21_q;
  logic equal_2380_s21_q;
  logic less_2381_s21_q;
  logic [17:0] select_2393_s21_q;
  logic [17:0] select_2403_s21_q;
  logic equal_2424_s21_q;
  logic and_2576_s21_q;
  logic and_2623_s21_q;
  logic [9:0] select_2627_s21_q;
  logic [9:0] select_2630_s21_q;
  logic [9:0] select_2637_s21_q;
  logic and_2658_s21_q;
  logic and_2678_s21_q;
  logic equal_2877_s21_q;
  logic parity_3209_s21_q;
  logic parity_3338_s21_q;
  logic and_3339_s21_q;
  logic or_3343_s21_q;
  logic or_3347_s21_q;
  logic or_3354_s21_q;
  logic or_3358_s21_q;
  logic or_3362_s21_q;
  logic or_3369_s21_q;
  logic or_3373_s21_q;
  logic or_3377_s21_q;
  logic or_3384_s21_q;
  logic or_3388_s21_q;
  logic or_3392_s21_q;
  logic parity_3398_s21_q;
  logic or_3408_s21_q;
  logic or_3412_s21_q;
  logic and_3419_s21_q;
  logic and_3421_s21_q;
  logic and_3423_s21_q;
  logic equal_3445_s21_q;
  logic equal_3576_s21_q;
  logic less_3578_s21_q;
  logic less_3579_s21_q;
  logic or_3584_s21_q;
  logic [7:0] select_3629_s21_q;
  logic [13:0] product_3634_s21_q;
  logic equal_3685_s21_q;
  logic less_3810_s21_q;
  logic or_3907_s21_q;
  logic select_3915_s21_q;
  logic equal_3926_s21_q;
  logic equal_3929_s21_q;
  logic equal_3931_s21_q;
  logic equal_3932_s21_q;
  logic equal_3933_s21_q;
  logic equal_3934_s21_q;
  logic and_4088_s21_q;
  logic and_4103_s21_q;
  logic [31:0] select_4173_s21_q;
  logic [9:0] select_4180_s21_q;
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
      and_547_s21_q <= and_547_s20_q;
      equal_572_s21_q <= equal_572_s20_q;
      not_573_s21_q <= not_573_s20_q;
      so_s21_q <= drew_q;
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
      less_673_s21_q <= less_673_s20_q;
      and_681_s21_q <= and_681_s20_q;
      and_706_s21_q <= and_706_s20_q;
      and_707_s21_q <= and_707_s20_q;
      sum_729_s21_q <= sum_729[13:5];
      and_737_s21_q <= and_737_s20_q;
      less_738_s21_q <= less_738_s20_q;
      and_743_s21_q <= (and_706_s20_q & and_733_s20_q) & less_742_s20_q;
      less_744_s21_q <= less_744_s20_q;
      equal_1605_s21_q <= equal_1605_s20_q;
      equal_1613_s21_q <= equal_1613_s20_q;
      equal_1615_s21_q <= equal_1615_s20_q;
      equal_1617_s21_q <= equal_1617_s20_q;
      equal_1619_s21_q <= equal_1619_s20_q;
      equal_1621_s21_q <= equal_1621_s20_q;
      equal_1623_s21_q <= equal_1623_s20_q;
      and_1673_s21_q <= and_1673_s20_q;
      select_1690_s21_q <= select_1690_s20_q;
      equal_1691_s21_q <= equal_1691_s20_q;
      equal_1785_s21_q <= equal_1785_s20_q;
      equal_1787_s21_q <= equal_1787_s20_q;
      select_1801_s21_q <= select_1801_s20_q;
      or_1811_s21_q <= and_1673_s20_q | (select_1803_s20_q & equal_1809_s20_q);
      select_1815_s21_q <= select_1815_s20_q;
      select_1821_s21_q <= select_1821_s20_q;
      or_1840_s21_q <= and_1673_s20_q | (select_1832_s20_q & equal_1838_s20_q);
      column_5_s21_q <= column_5;
      select_1860_s21_q <= select_1860_s20_q;
      select_1861_s21_q <= or_1853_s20_q ? and_1673_s20_q : patches_left_next_0_q[4];
      and_1868_s21_q <= and_1868;
      less_1946_s21_q <= less_1946_s20_q;
      equal_1947_s21_q <= equal_1947_s20_q;
      not_1948_s21_q <= not_1948_s20_q;
      equal_1949_s21_q <= equal_1949_s20_q;
      not_1976_s21_q <= not_1976_s20_q;
      and_2042_s21_q <= and_2042_s20_q;
      less_2043_s21_q <= less_2043_s20_q;
      index_2_s21_q <= index_2_s20_q;
      sum_2048_s21_q <= sum_2048_s20_q;
      is_seen_s21_q <= is_seen;
      and_2112_s21_q <= is_seen & less_2111_s20_q;
      and_2122_s21_q <= and_2122_s20_q;
      equal_2262_s21_q <= equal_2262_s20_q;
      sum_2265_s21_q <= sum_2265[13:5];
      equal_2277_s21_q <= equal_2277_s20_q;
      not_2308_s21_q <= ~moments_ends_q;
      and_2329_s21_q <= cfg_prove_i & and_2328;
      equal_2380_s21_q <= equal_2380_s20_q;
      less_2381_s21_q <= less_2381_s20_q;
      select_2393_s21_q <= select_2393;
      select_2403_s21_q <= select_2403;
      equal_2424_s21_q <= equal_2424_s20_q;
      and_2576_s21_q <= and_2576_s20_q;
      and_2623_s21_q <= not_573_s20_q & (drew_q & and_2621);
      select_2627_s21_q <= select_2627_s20_q;
      select_2630_s21_q <= select_2630_s20_q;
      select_2637_s21_q <= select_2637;
      and_2658_s21_q <= drew_q & (ends_cell_s20_q & (not_2601_s20_q & and_2655));
      and_2678_s21_q <= and_2678_s20_q;
      equal_2877_s21_q <= equal_2877_s20_q;
      parity_3209_s21_q <= parity_3209_s20_q;
      parity_3338_s21_q <= parity_3338;
      and_3339_s21_q <= and_3339;
      or_3343_s21_q <= or_3343;
      or_3347_s21_q <= or_3347;
      or_3354_s21_q <= or_3354;
      or_3358_s21_q <= or_3358;
      or_3362_s21_q <= or_3362;
      or_3369_s21_q <= or_3369;
      or_3373_s21_q <= or_3373;
      or_3377_s21_q <= or_3377;
      or_3384_s21_q <= or_3384;
      or_3388_s21_q <= or_3388;
      or_3392_s21_q <= or_3392;
      parity_3398_s21_q <= parity_3398;
      or_3408_s21_q <= (or_3373 & or_3377) | (or_3369 & (or_3373 | or_3377));
      or_3412_s21_q <= (or_3388 & or_3392) | (or_3384 & (or_3388 | or_3392));
      and_3419_s21_q <= and_3339 & (or_3343 | or_3347);
      and_3421_s21_q <= parity_3380 & parity_3395;
      and_3423_s21_q <= (^{or_3362, or_3358, or_3354}) & (parity_3380 | parity_3395);
      equal_3445_s21_q <= equal_3445_s20_q;
      equal_3576_s21_q <= select_3533_s20_q[3:0] == 4'h0;
      less_3578_s21_q <= {difference_3577, 3'h0} < {3'h0, patches_size_q};
      less_3579_s21_q <= select_3574_s20_q < select_3564_s20_q;
      or_3584_s21_q <= or_3584;
      select_3629_s21_q <= select_3629;
      product_3634_s21_q <= product_3634_s20_q;
      equal_3685_s21_q <= equal_3685_s20_q;
      less_3810_s21_q <= less_3810_s20_q;
      or_3907_s21_q <= or_3907_s20_q;
      select_3915_s21_q <= select_3915_s20_q;
      equal_3926_s21_q <= equal_3926_s20_q;
      equal_3929_s21_q <= equal_3929_s20_q;
      equal_3931_s21_q <= equal_3931_s20_q;
      equal_3932_s21_q <= equal_3932_s20_q;
      equal_3933_s21_q <= equal_3933_s20_q;
      equal_3934_s21_q <= equal_3934_s20_q;
      and_4088_s21_q <= said_q;
      and_4103_s21_q <= and_4103;
      select_4173_s21_q <= select_4173_s20_q;
      select_4180_s21_q <= select_4180_s20_q;
    end
  end

  // Stage 21 ----------------------------------------------------------------------------------------------------------
  logic moments_out_of_step_q;
  logic moments_begins_alone_q;
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
  logic [5:0] select_1822;
  assign select_1822 = or_1811_s21_q ? {and_1673_s21_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1824;
  assign and_1824 = select_1821_s21_q & (~select_1822[5]);
  // hls/stages/patches.hpp:133
  logic [5:0] select_1842;
  assign select_1842 = or_1840_s21_q ? {and_1673_s21_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1844;
  assign and_1844 = select_1821_s21_q & (~select_1842[5]);
  // hls/stages/moments.hpp:51
  logic or_2310;
  assign or_2310 = moments_begins_alone_q | (moments_out_of_step_q & not_2308_s21_q);
  // hls/stages/census.hpp:383
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2393_s21_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2396;
  assign select_2396 = equal_2380_s21_q ? (less_2381_s21_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:383
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2403_s21_q};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2406;
  assign select_2406 = equal_2380_s21_q ? (less_2381_s21_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2625;
  assign select_2625 = and_2576_s21_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2623_s21_q});
  logic [13:0] select_2639;
  assign select_2639 = and_2576_s21_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2637_s21_q});
  // hls/stages/agreement.hpp:789
  logic and_2659;
  assign and_2659 = not_573_s21_q & and_2658_s21_q;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_2661;
  assign select_2661 = and_2576_s21_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2659});
  logic [13:0] select_2680;
  assign select_2680 = and_2576_s21_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2678_s21_q});
  // hls/stages/patches.hpp:127
  logic select_3005;
  assign select_3005 = equal_1691_s21_q ? patches_valid_0_q : (select_1690_s21_q ? patches_valid_0_q : select_1801_s21_q);
  // hls/stages/agreement.hpp:276
  logic select_3008;
  assign select_3008 = sample_pair_whole_s21_q ? (and_1824 ? (sample_present_s21_q & select_3005) : select_3005) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3010;
  assign select_3010 = equal_1691_s21_q ? patches_valid_1_q : (select_1690_s21_q ? select_1801_s21_q : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3013;
  assign select_3013 = sample_pair_whole_s21_q ? (and_1844 ? (sample_present_s21_q & select_3010) : select_3010) : patches_valid_1_q;
  logic [5:0] select_3016;
  assign select_3016 = sample_pair_whole_s21_q ? (select_1822[5] ? {1'b1, select_1822[4:0]} : (select_1822 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3019;
  assign select_3019 = sample_pair_whole_s21_q ? (select_1842[5] ? {1'b1, select_1842[4:0]} : (select_1842 + 6'h1)) : patches_right_next_1_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3400;
  assign parity_3400 = ^{or_3392_s21_q, or_3388_s21_q, or_3384_s21_q, or_3377_s21_q, or_3373_s21_q, or_3369_s21_q, or_3362_s21_q, or_3358_s21_q, or_3354_s21_q, or_3347_s21_q, or_3343_s21_q, and_3339_s21_q};
  // hls/stages/count_bits.hpp:25
  logic or_3404;
  assign or_3404 = (or_3358_s21_q & or_3362_s21_q) | (or_3354_s21_q & (or_3358_s21_q | or_3362_s21_q));
  // hls/stages/count_bits.hpp:24
  logic parity_3415;
  assign parity_3415 = ^{or_3412_s21_q, or_3408_s21_q, or_3404};
  // hls/stages/count_bits.hpp:25
  logic and_3416;
  assign and_3416 = (^{or_3347_s21_q, or_3343_s21_q, and_3339_s21_q}) & parity_3398_s21_q;
  logic or_3420;
  assign or_3420 = (or_3343_s21_q & or_3347_s21_q) | and_3419_s21_q;
  logic or_3424;
  assign or_3424 = and_3421_s21_q | and_3423_s21_q;
  // hls/stages/count_bits.hpp:24
  logic parity_3427;
  assign parity_3427 = ^{or_3424, or_3420, and_3416};
  // hls/stages/count_bits.hpp:25
  logic and_3429;
  assign and_3429 = parity_3415 & parity_3427;
  logic or_3433;
  assign or_3433 = (or_3408_s21_q & or_3412_s21_q) | (or_3404 & (or_3408_s21_q | or_3412_s21_q));
  logic or_3437;
  assign or_3437 = (or_3420 & or_3424) | (and_3416 & (or_3420 | or_3424));
  // hls/stages/patches.hpp:595
  logic or_3585;
  assign or_3585 = (~(patches_second_s21_q ? patches_valid_1_q : patches_valid_0_q)) | or_3584_s21_q;
  logic or_3588;
  assign or_3588 = equal_3576_s21_q | (less_3578_s21_q | (less_3579_s21_q | or_3585));
  // hls/stages/patches.hpp:594
  logic [14:0] difference_3635;
  assign difference_3635 = {{7{select_3629_s21_q[7]}}, select_3629_s21_q} - {product_3634_s21_q[13], product_3634_s21_q};
  // hls/stages/patches.hpp:600
  logic less_3636;
  assign less_3636 = $signed({{8{difference_3606[6]}}, difference_3606}) < $signed(difference_3635);
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_3936;
  assign select_3936 = equal_3933_s21_q ? counts_skin_unproven_q : (equal_3934_s21_q ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3938;
  assign select_3938 = equal_3932_s21_q ? counts_regions_bad_q : (equal_3929_s21_q ? counts_nearer_s21_q : select_3936);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3931_s21_q ? counts_on_skin_q : select_3938;
  // hls/stages/agreement.hpp:1141
  logic [31:0] select_4174;
  assign select_4174 = equal_1623_s21_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4173_s21_q;
  logic [31:0] select_4175;
  assign select_4175 = equal_1621_s21_q ? {8'h0, sharpness_sums_detail_0_s21_q} : select_4174;
  logic [31:0] select_4176;
  assign select_4176 = equal_1619_s21_q ? {8'h0, sharpness_sums_detail_1_s21_q} : select_4175;
  logic [31:0] select_4177;
  assign select_4177 = equal_1617_s21_q ? {8'h0, sharpness_sums_contrast_0_s21_q} : select_4176;
  logic [31:0] select_4178;
  assign select_4178 = equal_1615_s21_q ? {8'h0, sharpness_sums_contrast_1_s21_q} : select_4177;

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1861_s21_q, select_1860_s21_q, column_5_s21_q};
  logic patches_left_we;
  assign patches_left_we = s21_en & and_1868_s21_q;
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
  assign map_waddr = {sum_2048_s21_q, index_2_s21_q};
  logic map_we;
  assign map_we = s21_en & and_2122_s21_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2112_s21_q, is_seen_s21_q};
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
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      proven_q <= 1'b0;
    end else if (s21_en) begin
      moments_out_of_step_q <= or_2310;
      moments_begins_alone_q <= equal_572_s21_q & (equal_2277_s21_q & and_2329_s21_q);
      sharpness_comparing_rest_0_q <= so_s21_q ? select_2396 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s21_q ? select_2406 : sharpness_comparing_rest_1_q;
      counts_unproven_q <= select_2625;
      counts_regions_bad_q <= select_2639;
      counts_skin_unproven_q <= select_2661;
      counts_on_skin_q <= select_2680;
      patches_valid_0_q <= select_3008;
      patches_valid_1_q <= select_3013;
      patches_right_next_0_q <= select_3016;
      patches_right_next_1_q <= select_3019;
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
  logic and_547_s22_q;
  logic equal_572_s22_q;
  logic so_s22_q;
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
  logic less_673_s22_q;
  logic and_681_s22_q;
  logic and_706_s22_q;
  logic and_707_s22_q;
  logic less_730_s22_q;
  logic and_737_s22_q;
  logic less_738_s22_q;
  logic and_743_s22_q;
  logic less_744_s22_q;
  logic equal_1605_s22_q;
  logic equal_1613_s22_q;
  logic equal_1785_s22_q;
  logic equal_1787_s22_q;
  logic [4:0] select_1812_s22_q;
  logic [4:0] select_1815_s22_q;
  logic and_1825_s22_q;
  logic [4:0] select_1841_s22_q;
  logic and_1845_s22_q;
  logic less_1946_s22_q;
  logic equal_1947_s22_q;
  logic not_1948_s22_q;
  logic equal_1949_s22_q;
  logic not_1976_s22_q;
  logic and_2042_s22_q;
  logic less_2043_s22_q;
  logic [1:0] map_rdata_s22_q;
  logic is_seen_s22_q;
  logic and_2112_s22_q;
  logic equal_2262_s22_q;
  logic and_2267_s22_q;
  logic equal_2380_s22_q;
  logic sum_s22_q;
  logic sum_2_s22_q;
  logic equal_2424_s22_q;
  logic select_2442_s22_q;
  logic select_2448_s22_q;
  logic [9:0] select_2627_s22_q;
  logic [9:0] select_2630_s22_q;
  logic equal_2877_s22_q;
  logic parity_3209_s22_q;
  logic parity_3338_s22_q;
  logic parity_3400_s22_q;
  logic xor_3428_s22_q;
  logic parity_3440_s22_q;
  logic and_3441_s22_q;
  logic and_3443_s22_q;
  logic equal_3445_s22_q;
  logic or_3588_s22_q;
  logic [5:0] difference_3635_s22_q;
  logic not_3637_s22_q;
  logic not_3647_s22_q;
  logic equal_3685_s22_q;
  logic less_3759_s22_q;
  logic less_3760_s22_q;
  logic and_3791_s22_q;
  logic less_3810_s22_q;
  logic or_3907_s22_q;
  logic select_3915_s22_q;
  logic equal_3926_s22_q;
  logic and_3930_s22_q;
  logic [13:0] before_v_4_s22_q;
  logic not_3975_s22_q;
  logic or_3979_s22_q;
  logic and_3984_s22_q;
  logic less_3985_s22_q;
  logic and_4088_s22_q;
  logic and_4103_s22_q;
  logic not_4117_s22_q;
  logic [31:0] select_4178_s22_q;
  logic [9:0] select_4180_s22_q;
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
      column_s22_q <= column_s21_q;
      and_547_s22_q <= and_547_s21_q;
      equal_572_s22_q <= equal_572_s21_q;
      so_s22_q <= so_s21_q;
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
      less_673_s22_q <= less_673_s21_q;
      and_681_s22_q <= and_681_s21_q;
      and_706_s22_q <= and_706_s21_q;
      and_707_s22_q <= and_707_s21_q;
      less_730_s22_q <= 9'h4 < sum_729_s21_q;
      and_737_s22_q <= and_737_s21_q;
      less_738_s22_q <= less_738_s21_q;
      and_743_s22_q <= and_743_s21_q;
      less_744_s22_q <= less_744_s21_q;
      equal_1605_s22_q <= equal_1605_s21_q;
      equal_1613_s22_q <= equal_1613_s21_q;
      equal_1785_s22_q <= equal_1785_s21_q;
      equal_1787_s22_q <= equal_1787_s21_q;
      select_1812_s22_q <= or_1811_s21_q ? 5'h0 : patches_right_next_0_q[4:0];
      select_1815_s22_q <= select_1815_s21_q;
      and_1825_s22_q <= sample_pair_whole_s21_q & and_1824;
      select_1841_s22_q <= or_1840_s21_q ? 5'h0 : patches_right_next_1_q[4:0];
      and_1845_s22_q <= sample_pair_whole_s21_q & and_1844;
      less_1946_s22_q <= less_1946_s21_q;
      equal_1947_s22_q <= equal_1947_s21_q;
      not_1948_s22_q <= not_1948_s21_q;
      equal_1949_s22_q <= equal_1949_s21_q;
      not_1976_s22_q <= not_1976_s21_q;
      and_2042_s22_q <= and_2042_s21_q;
      less_2043_s22_q <= less_2043_s21_q;
      map_rdata_s22_q <= map_rdata_q;
      is_seen_s22_q <= is_seen_s21_q;
      and_2112_s22_q <= and_2112_s21_q;
      equal_2262_s22_q <= equal_2262_s21_q;
      and_2267_s22_q <= and_706_s21_q & (9'h4 < sum_2265_s21_q);
      equal_2380_s22_q <= equal_2380_s21_q;
      sum_s22_q <= sum[0];
      sum_2_s22_q <= sum_2[0];
      equal_2424_s22_q <= equal_2424_s21_q;
      select_2442_s22_q <= sharpness_comparing_less_contrast_0_q;
      select_2448_s22_q <= sharpness_comparing_less_contrast_1_q;
      select_2627_s22_q <= select_2627_s21_q;
      select_2630_s22_q <= select_2630_s21_q;
      equal_2877_s22_q <= equal_2877_s21_q;
      parity_3209_s22_q <= parity_3209_s21_q;
      parity_3338_s22_q <= parity_3338_s21_q;
      parity_3400_s22_q <= parity_3400;
      xor_3428_s22_q <= parity_3415 ^ parity_3427;
      parity_3440_s22_q <= ^{or_3437, or_3433, and_3429};
      and_3441_s22_q <= or_3433 & or_3437;
      and_3443_s22_q <= and_3429 & (or_3433 | or_3437);
      equal_3445_s22_q <= equal_3445_s21_q;
      or_3588_s22_q <= or_3588;
      difference_3635_s22_q <= difference_3635[5:0];
      not_3637_s22_q <= ~less_3636;
      not_3647_s22_q <= ~($signed(difference_3635) < $signed({9'h0, cfg_patch_limit_i}));
      equal_3685_s22_q <= equal_3685_s21_q;
      less_3759_s22_q <= $signed(15'h10) < $signed(difference_3635);
      less_3760_s22_q <= $signed(difference_3635[14:4]) < $signed(11'h7ff);
      and_3791_s22_q <= equal_572_s21_q & equal_2277_s21_q;
      less_3810_s22_q <= less_3810_s21_q;
      or_3907_s22_q <= or_3907_s21_q;
      select_3915_s22_q <= select_3915_s21_q;
      equal_3926_s22_q <= equal_3926_s21_q;
      and_3930_s22_q <= equal_3929_s21_q & equal_3685_s21_q;
      before_v_4_s22_q <= before_v_4;
      not_3975_s22_q <= ~(equal_3934_s21_q & equal_3685_s21_q);
      or_3979_s22_q <= (equal_3934_s21_q | equal_3933_s21_q) | (x_s21_q[6:3] == 4'hf);
      and_3984_s22_q <= equal_3931_s21_q & equal_3685_s21_q;
      less_3985_s22_q <= {4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q;
      and_4088_s22_q <= and_4088_s21_q;
      and_4103_s22_q <= and_4103_s21_q;
      not_4117_s22_q <= ~proven_q;
      select_4178_s22_q <= select_4178;
      select_4180_s22_q <= select_4180_s21_q;
    end
  end

  // Stage 22 ----------------------------------------------------------------------------------------------------------
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
  logic patches_frame_ended_q;
  logic hides_q;
  // hls/stages/census.hpp:305
  logic and_731;
  assign and_731 = and_681_s22_q & less_730_s22_q;
  // hls/stages/census.hpp:312
  logic and_2268;
  assign and_2268 = and_706_s22_q & less_730_s22_q;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2269;
  assign sum_2269 = census_left_misses_q + {{17{and_2268}}, and_2267_s22_q, 1'b0, and_2267_s22_q};
  // hls/stages/agreement.hpp:521
  logic [19:0] select_2271;
  assign select_2271 = and_547_s22_q ? (equal_2262_s22_q ? 20'h0 : sum_2269) : census_left_misses_q;
  // hls/stages/agreement.hpp:216
  logic [2:0] select_2408;
  assign select_2408 = equal_2380_s22_q ? {sharpness_comparing_product_0_q[1:0], sum_s22_q} : sharpness_comparing_product_0_q;
  logic [2:0] select_2410;
  assign select_2410 = equal_2380_s22_q ? {sharpness_comparing_product_1_q[1:0], sum_2_s22_q} : sharpness_comparing_product_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2_s22_q});
  // hls/stages/agreement.hpp:216
  logic select_2419;
  assign select_2419 = so_s22_q ? (equal_2380_s22_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum_s22_q});
  // hls/stages/agreement.hpp:216
  logic select_2422;
  assign select_2422 = equal_2380_s22_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:391
  logic xor_2425;
  assign xor_2425 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic xor_2431;
  assign xor_2431 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  // hls/stages/count_bits.hpp:27
  logic or_3444;
  assign or_3444 = and_3441_s22_q | and_3443_s22_q;
  // hls/stages/patches.hpp:521
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3444, parity_3440_s22_q, xor_3428_s22_q, parity_3400_s22_q, parity_3338_s22_q, parity_3209_s22_q} + (equal_3445_s22_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3449;
  assign select_3449 = equal_1785_s22_q ? patches_sums_values_0_q : (equal_1787_s22_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3450;
  assign select_3450 = equal_1787_s22_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3452;
  assign select_3452 = equal_1787_s22_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3454;
  assign select_3454 = equal_1787_s22_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3456;
  assign select_3456 = equal_1787_s22_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3458;
  assign select_3458 = equal_1787_s22_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3460;
  assign select_3460 = equal_1787_s22_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3462;
  assign select_3462 = equal_1787_s22_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3464;
  assign select_3464 = equal_1787_s22_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3466;
  assign select_3466 = equal_1787_s22_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3468;
  assign select_3468 = equal_1787_s22_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3470;
  assign select_3470 = equal_1787_s22_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3472;
  assign select_3472 = equal_1787_s22_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3474;
  assign select_3474 = equal_1787_s22_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3476;
  assign select_3476 = equal_1787_s22_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3478;
  assign select_3478 = equal_1787_s22_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3480;
  assign select_3480 = equal_1787_s22_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:575
  logic not_3589;
  assign not_3589 = ~or_3588_s22_q;
  // hls/stages/patches.hpp:556
  logic and_3590;
  assign and_3590 = equal_1949_s22_q & not_3589;
  // hls/stages/patches.hpp:184
  logic and_3593;
  assign and_3593 = equal_1785_s22_q & (less_1946_s22_q ? (not_1948_s22_q & and_3590) : and_3590);
  // hls/stages/patches.hpp:556
  logic and_3596;
  assign and_3596 = equal_1949_s22_q & (patches_second_s22_q & not_3589);
  // hls/stages/patches.hpp:184
  logic and_3599;
  assign and_3599 = equal_1785_s22_q & (less_1946_s22_q ? (not_1948_s22_q & and_3596) : and_3596);
  // hls/stages/patches.hpp:556
  logic and_3639;
  assign and_3639 = equal_1949_s22_q & (not_3589 & not_3637_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3642;
  assign and_3642 = equal_1785_s22_q & (less_1946_s22_q ? (not_1948_s22_q & and_3639) : and_3639);
  // hls/stages/patches.hpp:556
  logic and_3649;
  assign and_3649 = equal_1949_s22_q & (not_3589 & not_3647_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3652;
  assign and_3652 = equal_1785_s22_q & (less_1946_s22_q ? (not_1948_s22_q & and_3649) : and_3649);
  // hls/stages/agreement.hpp:1131
  logic less_3686;
  assign less_3686 = x_s22_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:789
  logic and_3690;
  assign and_3690 = equal_572_s22_q & (x_s22_q[6] & (not_1976_s22_q & (equal_3685_s22_q & less_3686)));
  // hls/stages/agreement.hpp:1143
  logic and_3695;
  assign and_3695 = x_s22_q[6] & (not_1976_s22_q & (less_3686 & (x_s22_q[2:0] == 3'h1)));
  logic and_3702;
  assign and_3702 = x_s22_q[6] & (not_1976_s22_q & (less_3686 & (x_s22_q[2:0] == 3'h2)));
  logic and_3709;
  assign and_3709 = x_s22_q[6] & (not_1976_s22_q & (less_3686 & (x_s22_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:199
  logic select_3716;
  assign select_3716 = (x_s22_q[5:3] == 3'h2) ? x_s22_q[1] : (x_s22_q[0] & (x_s22_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3743;
  assign sum_3743 = {2'h0, x_s22_q[2:0]} + 5'h1f;
  // hls/stages/patches.hpp:602
  logic [5:0] select_3762;
  assign select_3762 = less_3759_s22_q ? 6'h10 : (less_3760_s22_q ? 6'h30 : difference_3635_s22_q);
  // hls/stages/patches.hpp:556
  logic [5:0] select_3764;
  assign select_3764 = equal_1949_s22_q ? (or_3588_s22_q ? 6'h0 : select_3762) : 6'h0;
  logic [5:0] select_3766;
  assign select_3766 = less_1946_s22_q ? (equal_1947_s22_q ? 6'h0 : select_3764) : select_3764;
  // hls/stages/agreement.hpp:789
  logic and_3773;
  assign and_3773 = equal_572_s22_q & (x_s22_q[6] & (not_1976_s22_q & (equal_2877_s22_q & less_3686)));
  // hls/stages/agreement.hpp:1143
  logic and_3777;
  assign and_3777 = x_s22_q[6] & (not_1976_s22_q & (less_3686 & (x_s22_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:556
  logic and_3812;
  assign and_3812 = equal_1949_s22_q & (not_3589 & less_3810_s22_q);
  // hls/stages/patches.hpp:184
  logic and_3815;
  assign and_3815 = equal_1785_s22_q & (less_1946_s22_q ? (not_1948_s22_q & and_3812) : and_3812);
  // hls/stages/agreement.hpp:1223
  logic [14:0] over;
  assign over = {1'b0, product_s22_q} - {1'b0, before_v_4_s22_q};
  // hls/stages/agreement.hpp:1231
  logic select_3941;
  assign select_3941 = and_3930_s22_q ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1309
  logic [1:0] select_4104;
  assign select_4104 = and_4103_s22_q ? {and_2112_s22_q, is_seen_s22_q} : map_rdata_s22_q;
  // hls/stages/agreement.hpp:1310
  logic and_4105;
  assign and_4105 = proven_q & less_4093;
  // hls/stages/agreement.hpp:1151
  logic or_4136;
  assign or_4136 = select_2442_s22_q | ($signed(20'h0) < $signed(census_left_misses_q));
  // hls/stages/agreement.hpp:789
  logic and_4160;
  assign and_4160 = equal_572_s22_q & (equal_3926_s22_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4164;
  assign and_4164 = equal_572_s22_q & (x_s22_q[6] & (not_1976_s22_q | (4'hc < x_s22_q[5:2])));

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s22_q;
  logic fresh_we;
  assign fresh_we = s22_en & and_547_s22_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_744_s22_q, and_743_s22_q, less_738_s22_q, and_737_s22_q, census_columns_values_1_cell_2_of_skin_s22_q, and_731, and_707_s22_q, and_706_s22_q, and_681_s22_q, less_673_s22_q, less_672_s22_q, less_671_s22_q, less_670_s22_q, less_669_s22_q, less_668_s22_q, less_667_s22_q, less_666_s22_q, less_665_s22_q, less_664_s22_q, less_663_s22_q, less_662_s22_q, less_661_s22_q, less_660_s22_q, less_659_s22_q, less_658_s22_q, less_657_s22_q, less_656_s22_q, less_655_s22_q, less_654_s22_q, less_653_s22_q, less_652_s22_q, less_651_s22_q, less_650_s22_q};
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
  assign patches_right_0_waddr = {select_1815_s22_q, select_1812_s22_q};
  logic patches_right_0_we;
  assign patches_right_0_we = s22_en & and_1825_s22_q;
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
  assign patches_right_1_waddr = {select_1815_s22_q, select_1841_s22_q};
  logic patches_right_1_we;
  assign patches_right_1_we = s22_en & and_1845_s22_q;
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
      patches_frame_ended_q <= 1'b0;
      hides_q <= 1'b0;
    end else if (s22_en) begin
      census_left_misses_q <= select_2271;
      sharpness_comparing_product_0_q <= so_s22_q ? select_2408 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s22_q ? select_2410 : sharpness_comparing_product_1_q;
      sharpness_comparing_carry_0_q <= select_2419;
      sharpness_comparing_carry_1_q <= so_s22_q ? select_2422 : sharpness_comparing_carry_1_q;
      patches_sums_values_0_q <= select_3449;
      patches_sums_values_1_q <= equal_1785_s22_q ? patches_sums_values_1_q : select_3450;
      patches_sums_values_2_q <= equal_1785_s22_q ? patches_sums_values_2_q : select_3452;
      patches_sums_values_3_q <= equal_1785_s22_q ? patches_sums_values_3_q : select_3454;
      patches_sums_values_4_q <= equal_1785_s22_q ? patches_sums_values_4_q : select_3456;
      patches_sums_values_5_q <= equal_1785_s22_q ? patches_sums_values_5_q : select_3458;
      patches_sums_values_6_q <= equal_1785_s22_q ? patches_sums_values_6_q : select_3460;
      patches_sums_values_7_q <= equal_1785_s22_q ? patches_sums_values_7_q : select_3462;
      patches_sums_values_8_q <= equal_1785_s22_q ? patches_sums_values_8_q : select_3464;
      patches_sums_values_9_q <= equal_1785_s22_q ? patches_sums_values_9_q : select_3466;
      patches_sums_values_10_q <= equal_1785_s22_q ? patches_sums_values_10_q : select_3468;
      patches_sums_values_11_q <= equal_1785_s22_q ? patches_sums_values_11_q : select_3470;
      patches_sums_values_12_q <= equal_1785_s22_q ? patches_sums_values_12_q : select_3472;
      patches_sums_values_13_q <= equal_1785_s22_q ? patches_sums_values_13_q : select_3474;
      patches_sums_values_14_q <= equal_1785_s22_q ? patches_sums_values_14_q : select_3476;
      patches_sums_values_15_q <= equal_1785_s22_q ? patches_sums_values_15_q : select_3478;
      patches_sums_values_16_q <= equal_1785_s22_q ? patches_sums_values_16_q : select_3480;
      patches_frame_ended_q <= and_3791_s22_q;
      hides_q <= equal_572_s22_q ? select_3941 : hides_q;
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
  logic equal_572_s23_q;
  logic so_s23_q;
  logic equal_1605_s23_q;
  logic equal_1613_s23_q;
  logic and_2042_s23_q;
  logic less_2043_s23_q;
  logic equal_2380_s23_q;
  logic or_2426_s23_q;
  logic and_2427_s23_q;
  logic or_2432_s23_q;
  logic and_2433_s23_q;
  logic select_2448_s23_q;
  logic [9:0] select_2627_s23_q;
  logic [9:0] select_2630_s23_q;
  logic and_3593_s23_q;
  logic and_3599_s23_q;
  logic and_3642_s23_q;
  logic and_3652_s23_q;
  logic and_3690_s23_q;
  logic and_3696_s23_q;
  logic and_3703_s23_q;
  logic and_3710_s23_q;
  logic and_3719_s23_q;
  logic and_3746_s23_q;
  logic [5:0] select_3767_s23_q;
  logic and_3773_s23_q;
  logic and_3778_s23_q;
  logic and_3816_s23_q;
  logic or_3907_s23_q;
  logic select_3915_s23_q;
  logic equal_3926_s23_q;
  logic select_3941_s23_q;
  logic and_3973_s23_q;
  logic not_3975_s23_q;
  logic or_3979_s23_q;
  logic and_3984_s23_q;
  logic and_3986_s23_q;
  logic and_4088_s23_q;
  logic and_4106_s23_q;
  logic and_4109_s23_q;
  logic not_4117_s23_q;
  logic or_4136_s23_q;
  logic and_4160_s23_q;
  logic and_4164_s23_q;
  logic [5:0] select_4166_s23_q;
  logic [31:0] select_4178_s23_q;
  logic [9:0] select_4180_s23_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
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
      equal_572_s23_q <= equal_572_s22_q;
      so_s23_q <= so_s22_q;
      equal_1605_s23_q <= equal_1605_s22_q;
      equal_1613_s23_q <= equal_1613_s22_q;
      and_2042_s23_q <= and_2042_s22_q;
      less_2043_s23_q <= less_2043_s22_q;
      equal_2380_s23_q <= equal_2380_s22_q;
      or_2426_s23_q <= equal_2424_s22_q | xor_2425;
      and_2427_s23_q <= five_times[0] & xor_2425;
      or_2432_s23_q <= equal_2424_s22_q | xor_2431;
      and_2433_s23_q <= five_times_2[0] & xor_2431;
      select_2448_s23_q <= select_2448_s22_q;
      select_2627_s23_q <= select_2627_s22_q;
      select_2630_s23_q <= select_2630_s22_q;
      and_3593_s23_q <= and_3593;
      and_3599_s23_q <= and_3599;
      and_3642_s23_q <= and_3642;
      and_3652_s23_q <= and_3652;
      and_3690_s23_q <= and_3690;
      and_3696_s23_q <= equal_572_s22_q & and_3695;
      and_3703_s23_q <= equal_572_s22_q & and_3702;
      and_3710_s23_q <= equal_572_s22_q & and_3709;
      and_3719_s23_q <= x_s22_q[6] & (not_1976_s22_q & (less_3686 & select_3716));
      and_3746_s23_q <= not_1976_s22_q & (less_3686 & (sum_3743[4:2] == 3'h0));
      select_3767_s23_q <= equal_1785_s22_q ? select_3766 : 6'h0;
      and_3773_s23_q <= and_3773;
      and_3778_s23_q <= equal_572_s22_q & and_3777;
      and_3816_s23_q <= and_3593 & and_3815;
      or_3907_s23_q <= or_3907_s22_q;
      select_3915_s23_q <= select_3915_s22_q;
      equal_3926_s23_q <= equal_3926_s22_q;
      select_3941_s23_q <= select_3941;
      and_3973_s23_q <= over[14] & equal_3685_s22_q;
      not_3975_s23_q <= not_3975_s22_q;
      or_3979_s23_q <= or_3979_s22_q;
      and_3984_s23_q <= and_3984_s22_q;
      and_3986_s23_q <= over[14] & less_3985_s22_q;
      and_4088_s23_q <= and_4088_s22_q;
      and_4106_s23_q <= select_4104[0] & and_4105;
      and_4109_s23_q <= select_4104[1] & and_4105;
      not_4117_s23_q <= not_4117_s22_q;
      or_4136_s23_q <= or_4136;
      and_4160_s23_q <= and_4160;
      and_4164_s23_q <= and_4164;
      select_4166_s23_q <= equal_572_s22_q ? (x_s22_q[6] ? x_s22_q[5:0] : 6'h0) : 6'h0;
      select_4178_s23_q <= select_4178_s22_q;
      select_4180_s23_q <= select_4180_s22_q;
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
  logic less_1958;
  assign less_1958 = patches_sums_values_0_s23_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1959;
  assign not_1959 = ~less_1958;
  logic [1:0] select_1960;
  assign select_1960 = patches_summed_first_s23_q ? 2'h2 : {less_1958, not_1959};
  logic [12:0] select_1962;
  assign select_1962 = select_1960[0] ? {4'h0, patches_summed_first_s23_q, 3'h0, patches_summed_row_column_s23_q} : {patches_summed_row_column_s23_q, patches_sums_values_0_s23_q[7:0]};
  logic [14:0] select_1963;
  assign select_1963 = select_1960[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_1964;
  assign select_1964 = (select_1960 == 2'h2) ? {select_1962[12:8], patches_sums_values_0_s23_q[9:8], select_1962[7:0]} : select_1963;
  // hls/stages/census.hpp:391
  logic select_2428;
  assign select_2428 = or_2426_s23_q ? and_2427_s23_q : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2429;
  assign select_2429 = equal_2380_s23_q ? select_2428 : sharpness_comparing_less_detail_0_q;
  logic select_2430;
  assign select_2430 = so_s23_q ? select_2429 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic select_2434;
  assign select_2434 = or_2432_s23_q ? and_2433_s23_q : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2435;
  assign select_2435 = equal_2380_s23_q ? select_2434 : sharpness_comparing_less_detail_1_q;
  logic select_2436;
  assign select_2436 = so_s23_q ? select_2435 : sharpness_comparing_less_detail_1_q;
  // hls/stages/patches.hpp:653
  logic not_3594;
  assign not_3594 = ~patches_lower_s23_q;
  logic not_3600;
  assign not_3600 = ~and_3599_s23_q;
  // hls/stages/patches.hpp:188
  logic and_3602;
  assign and_3602 = and_3593_s23_q & (not_3594 & not_3600);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3604;
  assign sum_3604 = {7'h0, and_3602} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:656
  logic and_3643;
  assign and_3643 = and_3642_s23_q & and_3602;
  logic [7:0] sum_3644;
  assign sum_3644 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3643};
  // hls/stages/patches.hpp:657
  logic and_3653;
  assign and_3653 = and_3652_s23_q & and_3602;
  logic [7:0] sum_3654;
  assign sum_3654 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3653};
  // hls/stages/patches.hpp:188
  logic and_3656;
  assign and_3656 = and_3593_s23_q & (and_3599_s23_q & not_3594);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3658;
  assign sum_3658 = {7'h0, and_3656} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:656
  logic and_3660;
  assign and_3660 = and_3642_s23_q & and_3656;
  logic [7:0] sum_3661;
  assign sum_3661 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3660};
  // hls/stages/patches.hpp:657
  logic and_3663;
  assign and_3663 = and_3652_s23_q & and_3656;
  logic [7:0] sum_3664;
  assign sum_3664 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3663};
  // hls/stages/patches.hpp:188
  logic and_3666;
  assign and_3666 = and_3593_s23_q & (patches_lower_s23_q & not_3600);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3668;
  assign sum_3668 = {7'h0, and_3666} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:656
  logic and_3670;
  assign and_3670 = and_3642_s23_q & and_3666;
  logic [7:0] sum_3671;
  assign sum_3671 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3670};
  // hls/stages/patches.hpp:657
  logic and_3673;
  assign and_3673 = and_3652_s23_q & and_3666;
  logic [7:0] sum_3674;
  assign sum_3674 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3673};
  // hls/stages/patches.hpp:188
  logic and_3676;
  assign and_3676 = and_3593_s23_q & (patches_lower_s23_q & and_3599_s23_q);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_3678;
  assign sum_3678 = {7'h0, and_3676} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:656
  logic and_3680;
  assign and_3680 = and_3642_s23_q & and_3676;
  logic [7:0] sum_3681;
  assign sum_3681 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3680};
  // hls/stages/patches.hpp:657
  logic and_3683;
  assign and_3683 = and_3652_s23_q & and_3676;
  logic [7:0] sum_3684;
  assign sum_3684 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3683};
  // hls/stages/patches.hpp:619
  logic [7:0] or_3698;
  assign or_3698 = (and_3690_s23_q ? patches_quarters_0_places_q : 8'h0) | (and_3696_s23_q ? patches_quarters_1_places_q : 8'h0);
  logic [7:0] or_3712;
  assign or_3712 = (or_3698 | (and_3703_s23_q ? patches_quarters_2_places_q : 8'h0)) | (and_3710_s23_q ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/agreement.hpp:789
  logic and_3720;
  assign and_3720 = equal_572_s23_q & and_3719_s23_q;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3722;
  assign select_3722 = and_3690_s23_q ? (and_3720 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3724;
  assign select_3724 = and_3696_s23_q ? (and_3720 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3727;
  assign select_3727 = and_3703_s23_q ? (and_3720 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3730;
  assign select_3730 = and_3710_s23_q ? (and_3720 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:621
  logic [7:0] select_3733;
  assign select_3733 = and_3690_s23_q ? (and_3720 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3735;
  assign select_3735 = and_3696_s23_q ? (and_3720 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3738;
  assign select_3738 = and_3703_s23_q ? (and_3720 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3741;
  assign select_3741 = and_3710_s23_q ? (and_3720 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/agreement.hpp:789
  logic and_3748;
  assign and_3748 = equal_572_s23_q & (x_s23_q & and_3746_s23_q);
  // hls/stages/patches.hpp:614
  logic [7:0] sum_3750;
  assign sum_3750 = patches_word_places_q + (and_3696_s23_q ? 8'h0 : patches_sum_places_q);
  // hls/stages/patches.hpp:616
  logic [7:0] select_3754;
  assign select_3754 = and_3748 ? (patches_word_up_q + (and_3696_s23_q ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] sum_3756;
  assign sum_3756 = patches_word_down_q + (and_3696_s23_q ? 8'h0 : patches_sum_down_q);
  // hls/stages/patches.hpp:659
  logic [5:0] select_3768;
  assign select_3768 = and_3593_s23_q ? select_3767_s23_q : 6'h0;
  logic [11:0] sum_3769;
  assign sum_3769 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3768[5]}}, select_3768};
  // hls/stages/patches.hpp:643
  logic [7:0] select_3780;
  assign select_3780 = and_3773_s23_q ? (and_3778_s23_q ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:645
  logic or_3784;
  assign or_3784 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic or_3787;
  assign or_3787 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:647
  logic [8:0] sum_3788;
  assign sum_3788 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:642
  logic select_3790;
  assign select_3790 = and_3773_s23_q ? (and_3778_s23_q ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3793;
  assign and_3793 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:642
  logic [2:0] select_3794;
  assign select_3794 = and_3773_s23_q ? {and_3793, patches_found_q[2:1]} : patches_found_q;
  logic [2:0] select_3796;
  assign select_3796 = and_3773_s23_q ? (and_3778_s23_q ? {and_3793, patches_found_q[2:1]} : select_3794) : patches_found_q;
  // hls/stages/patches.hpp:641
  logic or_3799;
  assign or_3799 = patches_partly_q | (patches_doubted_q & (~and_3778_s23_q));
  // hls/stages/patches.hpp:642
  logic select_3801;
  assign select_3801 = and_3778_s23_q ? or_3799 : (and_3773_s23_q ? or_3799 : patches_doubted_q);
  // hls/stages/patches.hpp:640
  logic select_3803;
  assign select_3803 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:629
  logic [7:0] select_3807;
  assign select_3807 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3817;
  assign sum_3817 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3816_s23_q};
  // hls/stages/patches.hpp:631
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:632
  logic select_3840;
  assign select_3840 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:633
  logic and_3846;
  assign and_3846 = patches_frame_ended_s23_q & (~patches_age_q[9]);
  logic [9:0] sum_3847;
  assign sum_3847 = patches_age_q + {9'h0, and_3846};
  logic [9:0] select_3850;
  assign select_3850 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3847)) : sum_3847;
  // hls/stages/agreement.hpp:1149
  logic not_3942;
  assign not_3942 = ~hidden_for_q[7];
  logic [7:0] select_3944;
  assign select_3944 = select_3941_s23_q ? (hidden_for_q + {7'h0, not_3942}) : 8'h0;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3946;
  assign select_3946 = equal_572_s23_q ? (equal_3926_s23_q ? select_3944 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1229
  logic and_3976;
  assign and_3976 = too_much_q & not_3975_s23_q;
  // hls/stages/agreement.hpp:1230
  logic select_3981;
  assign select_3981 = and_3973_s23_q ? (and_3976 | or_3979_s23_q) : and_3976;
  // hls/stages/agreement.hpp:1232
  logic select_3987;
  assign select_3987 = and_3984_s23_q ? and_3986_s23_q : overlooks_q;
  // hls/stages/agreement.hpp:438
  logic select_4108;
  assign select_4108 = and_2042_s23_q ? (less_2043_s23_q ? and_4106_s23_q : seen_q) : seen_q;
  logic select_4111;
  assign select_4111 = and_2042_s23_q ? (less_2043_s23_q ? and_4109_s23_q : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1240
  logic or_4118;
  assign or_4118 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4117_s23_q;
  // hls/stages/agreement.hpp:789
  logic and_4124;
  assign and_4124 = equal_572_s23_q & (equal_3926_s23_q & (cfg_prove_i & or_3907_s23_q));
  // hls/stages/agreement.hpp:1242
  logic not_4126;
  assign not_4126 = ~(or_3907_s23_q | not_2332);
  // hls/stages/agreement.hpp:789
  logic and_4129;
  assign and_4129 = equal_3926_s23_q & (not_4126 & (select_3915_s23_q | select_3981));
  logic and_4133;
  assign and_4133 = equal_3926_s23_q & (cfg_prove_i & (registration_moved_s23_q | patches_moved_q));
  logic and_4143;
  assign and_4143 = equal_3926_s23_q & (not_4126 & (select_2436 | select_2448_s23_q));
  // hls/stages/agreement.hpp:1141
  logic [31:0] select_4179;
  assign select_4179 = equal_1613_s23_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4178_s23_q;
  // hls/stages/agreement.hpp:1143
  logic [31:0] select_4181;
  assign select_4181 = equal_1605_s23_q ? select_4179 : {2'h0, select_4180_s23_q, select_2630_s23_q, select_2627_s23_q};

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
      sharpness_comparing_less_detail_0_q <= select_2430;
      sharpness_comparing_less_detail_1_q <= select_2436;
      patches_best_differing_q <= select_1964[9:0];
      patches_best_column_q <= select_1964[14:10];
      patches_quarters_0_places_q <= sum_3604;
      patches_quarters_0_up_q <= sum_3644;
      patches_quarters_0_down_q <= sum_3654;
      patches_quarters_1_places_q <= sum_3658;
      patches_quarters_1_up_q <= sum_3661;
      patches_quarters_1_down_q <= sum_3664;
      patches_quarters_2_places_q <= sum_3668;
      patches_quarters_2_up_q <= sum_3671;
      patches_quarters_2_down_q <= sum_3674;
      patches_quarters_3_places_q <= sum_3678;
      patches_quarters_3_up_q <= sum_3681;
      patches_quarters_3_down_q <= sum_3684;
      patches_word_places_q <= or_3712;
      patches_word_up_q <= ((select_3722 | select_3724) | select_3727) | select_3730;
      patches_word_down_q <= ((select_3733 | select_3735) | select_3738) | select_3741;
      patches_sum_places_q <= and_3748 ? sum_3750 : patches_sum_places_q;
      patches_sum_up_q <= select_3754;
      patches_sum_down_q <= and_3748 ? sum_3756 : patches_sum_down_q;
      patches_across_q <= sum_3769;
      patches_places_q <= select_3780;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3784;
      patches_partly_q <= or_3787;
      patches_clear_limit_q <= sum_3788[8:2];
      patches_complete_q <= select_3790;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= select_3796;
      patches_doubted_q <= and_3773_s23_q ? select_3801 : patches_doubted_q;
      patches_doubted_before_q <= select_3803;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3807;
      patches_on_skin_q <= sum_3817;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3840;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3850;
      hidden_for_q <= select_3946;
      too_much_q <= equal_572_s23_q ? select_3981 : too_much_q;
      overlooks_q <= equal_572_s23_q ? select_3987 : overlooks_q;
      seen_q <= select_4108;
      nearer_q <= select_4111;
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
  logic equal_572_s24_q;
  logic equal_3926_s24_q;
  logic and_4088_s24_q;
  logic and_4121_s24_q;
  logic and_4124_s24_q;
  logic and_4130_s24_q;
  logic and_4134_s24_q;
  logic and_4139_s24_q;
  logic and_4143_s24_q;
  logic not_4148_s24_q;
  logic or_4154_s24_q;
  logic and_4160_s24_q;
  logic and_4164_s24_q;
  logic [5:0] select_4166_s24_q;
  logic [31:0] select_4183_s24_q;
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
      equal_572_s24_q <= equal_572_s23_q;
      equal_3926_s24_q <= equal_3926_s23_q;
      and_4088_s24_q <= and_4088_s23_q;
      and_4121_s24_q <= equal_572_s23_q & (equal_3926_s23_q & (cfg_prove_i & or_4118));
      and_4124_s24_q <= and_4124;
      and_4130_s24_q <= equal_572_s23_q & and_4129;
      and_4134_s24_q <= equal_572_s23_q & and_4133;
      and_4139_s24_q <= equal_3926_s23_q & (not_4126 & (select_2430 | or_4136_s23_q));
      and_4143_s24_q <= and_4143;
      not_4148_s24_q <= ~(select_3944 < cfg_hidden_frames_i);
      or_4154_s24_q <= not_2332 | (select_3987 & not_3820);
      and_4160_s24_q <= and_4160_s23_q;
      and_4164_s24_q <= and_4164_s23_q;
      select_4166_s24_q <= select_4166_s23_q;
      select_4183_s24_q <= equal_572_s23_q ? (x_s23_q ? select_4181 : 32'h0) : 32'h0;
    end
  end

  // Stage 24 ----------------------------------------------------------------------------------------------------------
  logic [7:0] patches_on_skin_most_q;
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  // hls/stages/patches.hpp:650
  logic [12:0] product_3818;
  assign product_3818 = {8'h0, cfg_on_skin_limit_i} * {5'h0, patches_places_q};
  // hls/stages/patches.hpp:188
  logic and_3824;
  assign and_3824 = (~(patches_on_skin_s24_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_s24_q);
  logic select_3829;
  assign select_3829 = patches_round_ends_s24_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:630
  logic or_3833;
  assign or_3833 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_s24_q));
  // hls/stages/agreement.hpp:1151
  logic and_4150;
  assign and_4150 = cfg_prove_i & ((~(cfg_hidden_frames_i == 8'h0)) & not_4148_s24_q);
  // hls/stages/agreement.hpp:789
  logic and_4156;
  assign and_4156 = equal_3926_s24_q & (or_4154_s24_q ? cfg_prove_i : patches_overlooked_q);

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
      patches_on_skin_most_q <= 8'h0;
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
    end else if (s24_en) begin
      patches_on_skin_most_q <= product_3818[12:5];
      patches_large_q <= not_3820 & and_3824;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3829;
      patches_spoiled_q <= or_3833;
    end
  end

  logic [7:0] pixel_0_s25_q;
  logic [7:0] pixel_1_s25_q;
  logic saturated_s25_q;
  logic mask_s25_q;
  logic marks_first_s25_q;
  logic marks_last_s25_q;
  logic and_4088_s25_q;
  logic or_4112_s25_q;
  logic and_4113_s25_q;
  logic and_4121_s25_q;
  logic and_4124_s25_q;
  logic and_4130_s25_q;
  logic and_4134_s25_q;
  logic and_4140_s25_q;
  logic and_4144_s25_q;
  logic and_4152_s25_q;
  logic and_4157_s25_q;
  logic and_4160_s25_q;
  logic and_4164_s25_q;
  logic [5:0] select_4166_s25_q;
  logic [31:0] select_4183_s25_q;
  always_ff @(posedge clk_i) begin
    if (s24_en) begin
      pixel_0_s25_q <= pixel_0_s24_q;
      pixel_1_s25_q <= pixel_1_s24_q;
      saturated_s25_q <= saturated_s24_q;
      mask_s25_q <= mask_s24_q;
      marks_first_s25_q <= marks_first_s24_q;
      marks_last_s25_q <= marks_last_s24_q;
      and_4088_s25_q <= and_4088_s24_q;
      or_4112_s25_q <= not_2332 | seen_q;
      and_4113_s25_q <= cfg_prove_i & nearer_q;
      and_4121_s25_q <= and_4121_s24_q;
      and_4124_s25_q <= and_4124_s24_q;
      and_4130_s25_q <= and_4130_s24_q;
      and_4134_s25_q <= and_4134_s24_q;
      and_4140_s25_q <= equal_572_s24_q & and_4139_s24_q;
      and_4144_s25_q <= equal_572_s24_q & and_4143_s24_q;
      and_4152_s25_q <= equal_572_s24_q & (equal_3926_s24_q & and_4150);
      and_4157_s25_q <= equal_572_s24_q & and_4156;
      and_4160_s25_q <= and_4160_s24_q;
      and_4164_s25_q <= and_4164_s24_q;
      select_4166_s25_q <= select_4166_s24_q;
      select_4183_s25_q <= select_4183_s24_q;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s25_q;
  assign pixel_1_o = pixel_1_s25_q;
  assign saturated_o = saturated_s25_q;
  assign mask_o = mask_s25_q;
  assign marks_first_o = marks_first_s25_q;
  assign marks_last_o = marks_last_s25_q;
  assign marks_seen_o = or_4112_s25_q;
  assign marks_nearer_o = and_4113_s25_q;
  assign verdict_valid_o = and_4088_s25_q;
  assign verdict_unproven_yet_o = and_4121_s25_q;
  assign verdict_untextured_o = and_4124_s25_q;
  assign verdict_disagree_o = and_4130_s25_q;
  assign verdict_moved_o = and_4134_s25_q;
  assign verdict_unsharp_left_o = and_4140_s25_q;
  assign verdict_unsharp_right_o = and_4144_s25_q;
  assign verdict_hidden_o = and_4152_s25_q;
  assign verdict_overlooked_o = and_4157_s25_q;
  assign verdict_out_of_step_o = and_4160_s25_q;
  assign frame_valid_o = and_4164_s25_q;
  assign frame_index_o = select_4166_s25_q;
  assign frame_word_o = select_4183_s25_q;
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
  assign unused_bits = ^{over[13:0], product_3818[4:0], sum_3788[1:0], sum_3743[1:0], product_3634[4:0], sum_2726[0], difference_2667[1:0], detail_4[1:0], detail_3[1:0], sum_2265[4:0], sum_1766[1:0], sum_1765[1:0], sum_1761[0], sum_1710[0], sum_1706[0], sum_729[4:0], cfg_width_i[3:0]};

endmodule
